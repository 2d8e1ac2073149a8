"""The four control zones of the window: they show documents and report what the user wants."""
