"""Mouse, trackpad and keys of a viewport, and what lies under a pixel."""
