"""The main window: what assembles it, its commands, and what outlives it."""
