"""The 3D view: it shows what it is given and reports picks and drags; it changes no document.

``View3D`` in ``qovr_app.view3d.view`` is the widget. ``scene`` holds values: what is drawn, from NumPy alone. Above it,
and apart from one another, ``interaction`` turns events into intents, ``gl`` and ``painter`` draw, ``figure`` lays out
pages; the modules of this folder put them together. ``scene`` and ``gl.support`` are light: importing them loads no
OpenGL, so that a window can be shown before the drawing libraries are.
"""
