"""What the export dialog offers of a net."""

import pytest
from PySide6.QtWidgets import QCheckBox

from qovr_app.dialogs.export_choices import ExportChoices
from qovr_core.files import FORMATS, ExportOptions
from qovr_core.presets import preset
from support.net_documents import net_of


@pytest.mark.parametrize("suffix", FORMATS)
def test_one_face_is_offered_of_exact_surfaces_with_sharp_joints(suffix, app):
    entry = FORMATS[suffix]
    for document, has_parts in (
        (net_of("one sharp joint"), True),
        (net_of("smooth"), False),
        (net_of("one sharp joint", formulation="published"), False),
        (preset("fig5").document, False),
    ):
        choices = ExportChoices(document, ExportOptions())
        box = choices.findChild(QCheckBox, "export.single_face")
        choices.show()
        choices.describe(entry)
        is_exact = suffix in (".step", ".iges", ".3dm")
        assert box.isVisible() == (has_parts and is_exact)
        assert not choices.options(entry).single_face
        box.click()
        assert choices.options(entry).single_face == is_exact
        choices.close()
