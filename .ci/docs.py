"""Make the reference of the library from its docstrings, and the help as a page, in ``build/docs``."""

from pathlib import Path
from pkgutil import iter_modules

import pdoc

import qovr_core
from qovr_core.resources import resource
from qovr_core.version import VERSION

FOLDER = Path("build/docs")
HELP = '<!DOCTYPE html>\n<html lang="en">\n<meta charset="utf-8">\n<title>QOVR Studio</title>\n{}\n</html>\n'
COMMANDS = {"qovr_core.cli", "qovr_core.commands"}

modules = {found.name for found in iter_modules(qovr_core.__path__, "qovr_core.")} - COMMANDS
pdoc.render.configure(docformat="numpy", math=True, footer_text=f"QOVR Studio {VERSION}")
pdoc.pdoc("qovr_core", *sorted(modules), output_directory=FOLDER)
text = resource("help", "help.html").read_text(encoding="utf-8")
(FOLDER / "help.html").write_text(HELP.format(text), encoding="utf-8")
