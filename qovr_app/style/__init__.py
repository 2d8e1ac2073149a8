"""Colours, symbols and colour maps: once, for widgets, plots and the 3D view alike."""
