"""Small widgets that zones, panels and dialogs share."""
