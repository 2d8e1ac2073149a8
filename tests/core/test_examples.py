"""Every example in the library's docstrings and in the README runs and prints what it says."""

import doctest
from importlib import import_module

import pytest

from support.structure import PATHS, ROOT

WITH_EXAMPLES = [
    module
    for module, path in PATHS.items()
    if module.split(".")[0] == "qovr_core" and ">>> " in path.read_text(encoding="utf-8")
]


@pytest.mark.parametrize("module", WITH_EXAMPLES)
def test_the_examples_of_a_module_run(module):
    result = doctest.testmod(import_module(module))
    assert result.attempted > 0
    assert result.failed == 0


def test_the_examples_of_the_readme_run():
    result = doctest.testfile(str(ROOT / "README.md"), module_relative=False, encoding="utf-8")
    assert result.attempted > 0
    assert result.failed == 0
