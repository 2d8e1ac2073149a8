"""The 3D view: it shows a configured surface and reports picks and drags; it changes no document.

``View3D`` in ``qovr_app.view3d.view`` is the widget. ``settings`` and ``probe`` are light: importing them
loads no OpenGL, so that a window can be shown before the drawing libraries are.
"""
