"""What is behind a verdict, as rich text."""

from __future__ import annotations

import html
import re

from qovr_app.laboratory.claims_table import marked_verdict, statement
from qovr_app.style.spacing import SPACE
from qovr_app.style.symbols import symbol_html
from qovr_core.laboratory.claims_report import standing
from qovr_core.laboratory.verify import Finding, Ground
from qovr_core.number_texts import short_text

_SYMBOL = re.compile(r"\b([A-Za-z])_(ip|\d(?:,\d)?)\b")


def details_html(finding: Finding) -> str:
    """Return everything known of a verdict as rich text."""
    claim, here = finding.claim, finding.here
    condition = f" {_rich(finding.condition)}" if finding.condition else ""
    measured, value = here.what[0].upper() + here.what[1:], short_text(here.value)
    paragraphs = [
        f"{_rich(statement(claim))} <b>{_rich(claim.name)}</b>, {_rich(claim.where)}.",
        f"For {_rich(str(finding.formulation))}: <b>{marked_verdict(finding)}</b>{condition}.",
        _ground_html(finding),
        standing(finding.verdict, here).sentence,
        f"{_rich(measured)}: <b>{value}</b> here, {short_text(finding.largest)} at most in all trials.",
        f"Found: {_rich(here.note)}." if here.note else "",
    ]
    return "".join(f'<p style="margin: 0 0 {SPACE}px 0">{text}</p>' for text in paragraphs if text)


def _ground_html(finding: Finding) -> str:
    """Return how a verdict is known, where it is not by trials alone."""
    if finding.proof:
        return f"Proved in exact arithmetic: {_rich(finding.proof)}."
    return "" if finding.ground is Ground.TRIALS else f"{str(finding.ground).capitalize()}."


def _rich(text: str) -> str:
    symbols = _SYMBOL.sub(lambda found: symbol_html(found[1], found[2]), html.escape(text))
    return symbols.replace("^-1", "<sup>−1</sup>")
