"""The one table of the window's commands, from which menus, bars, context menus and the keyboard are drawn."""

from qovr_app.window.commands.command import Command
from qovr_app.window.commands.document import edit_commands, file_commands, preference_commands, surface_commands
from qovr_app.window.commands.fields import field_commands
from qovr_app.window.commands.hiding import hiding_commands
from qovr_app.window.commands.net import net_commands
from qovr_app.window.commands.net_windows import net_window_commands
from qovr_app.window.commands.points import point_commands, selection_commands
from qovr_app.window.commands.tools import go_commands, help_commands, laboratory_commands, probe_commands
from qovr_app.window.commands.tools_of_points import tool_commands
from qovr_app.window.commands.view import view_commands
from qovr_app.window.commands.windows import window_commands

__all__ = ["Command", "command_table"]


def command_table() -> tuple[Command, ...]:
    """Return every command, in the order in which menus list them."""
    return (
        *file_commands(),
        *edit_commands(),
        *field_commands(),
        *selection_commands(),
        *point_commands(),
        *hiding_commands(),
        *tool_commands(),
        *net_commands(),
        *surface_commands(),
        *view_commands(),
        *go_commands(),
        *net_window_commands(),
        *laboratory_commands(),
        *probe_commands(),
        *preference_commands(),
        *window_commands(),
        *help_commands(),
    )
