"""The menus of the right button over the view: commands of the one table, by what lies under the mouse."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QMenu, QWidget

from qovr_app.state.looking_intents import PointsPutAway, Selected
from qovr_app.store import Store
from qovr_app.view3d.scene.hand import MenuPlace, MenuWish
from qovr_app.window.actions import Actions
from qovr_app.window.knots_in_view import curve_choices, knot_choices

_COMMANDS = {
    MenuPlace.KNOT: ("link_curves", "link_directions", "", "show_knot_handles"),
    MenuPlace.POINT: (
        "select_all", "select_none", "",
        "transform_points", "flatten_height", "flatten_plane", "align_z", "smooth_points", "",
        "symmetry_rows", "symmetry_columns", "soft", "xray", "", "hide_points", "isolate_points",
        "show_points", "", "fit_selection",
    ),
    MenuPlace.NET_LINE: (
        "show_control_net", "show_row_curves", "show_column_curves", "show_joints", "show_knot_handles", "",
        "show_points", "laboratory_curve", "", "fit_selection",
    ),
    MenuPlace.COLOUR_BAR: ("colour_by_", "", "colour_range_", "shares_range", "", "colour_map_", "", "show_colour_bar"),
    MenuPlace.VIEW: (
        "fit", "always_fits", "camera_back", "camera_forward", "", "camera_paper", "camera_top", "camera_isometric", "",
        "layer_", "", "style_", "document_samples", "paper_look", "", "show_control_points", "show_labels", "show_axes",
        "show_legend", "show_triad", "show_points", "", "probe", "tool_measure", "copy_picture", "underlay",
    ),
}  # fmt: skip
"""By what lies under the mouse, the commands; a name that ends with a line stands for all that begin so."""


def context_menu(wish: MenuWish, actions: Actions, store: Store, parent: QWidget) -> QMenu:
    """Return the menu for what lies under the mouse; of several points in one place it lists each."""
    menu = QMenu(parent)
    menu.setObjectName(f"context.{wish.place.replace(' ', '_')}")
    menu.setToolTipsVisible(True)
    if wish.place is MenuPlace.NET_LINE:
        picked = Selected(wish.points[-1], wish.points[:-1])
        menu.addAction("Select this line of the net", partial(store.dispatch, picked))
        put_away = tuple(sorted(store.state.put_away.union(wish.points)))
        menu.addAction("Hide this line of the net", partial(store.dispatch, PointsPutAway(put_away)))
        menu.addSeparator()
    if wish.knot is not None:
        choices = knot_choices if wish.place is MenuPlace.KNOT else curve_choices
        for text, intent in choices(wish.knot, store.state):
            menu.addAction(text, partial(store.dispatch, intent))
        menu.addSeparator()
    elif len(wish.points) > 1:
        for i, j in wish.points:
            menu.addAction(f"P {i},{j}", partial(store.dispatch, Selected((i, j))))
        menu.addSeparator()
    for name in _COMMANDS[wish.place]:
        if not name:
            menu.addSeparator()
        elif name.endswith("_"):
            menu.addActions(actions.begun_with(name))
        else:
            menu.addAction(actions[name])
    return menu


def show_context_menu(wish: MenuWish, at: QPoint, actions: Actions, store: Store, parent: QWidget) -> None:
    """Show the menu for what lies under the mouse at a place of the screen; it is gone when it is left."""
    menu = context_menu(wish, actions, store, parent)
    menu.aboutToHide.connect(menu.deleteLater)
    menu.popup(at)
