"""The viewport that OpenGL draws, and everything that touches OpenGL."""
