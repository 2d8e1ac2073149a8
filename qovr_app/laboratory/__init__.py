"""The laboratory: panels under the 3D view that lay the paper's method open, each loaded when it is first shown."""
