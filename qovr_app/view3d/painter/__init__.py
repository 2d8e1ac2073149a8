"""What Qt's painter draws: backdrop and overlay of every viewport, and the surface where OpenGL cannot be used."""
