"""Findings for people, and as the README's table."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator
from itertools import groupby
from math import isfinite
from typing import NamedTuple

from qovr_core.formulations import FORMULATIONS
from qovr_core.laboratory.claims import Claim
from qovr_core.laboratory.measurement import Measurement
from qovr_core.laboratory.verify import Finding, Ground, Verdict

_WIDTH = 110
_VERDICT = 28

_LONG = 100
"""From here on two digits would need an exponent."""
_INDENT = " " * 17


class Standing(NamedTuple):
    """How one document stands to a verdict: in a word or two, and in a sentence."""

    words: str
    sentence: str


_STANDINGS = {
    (Verdict.TRUE, True): Standing("as claimed", "On this document it is so."),
    (Verdict.TRUE_IF, True): Standing("as claimed", "On this document it is so."),
    (Verdict.TRUE_IF, False): Standing(
        "not as claimed", "On this document it is not so: it does not meet the condition."
    ),
    (Verdict.FALSE, True): Standing("not refuted", "This document does not refute it, but another one does."),
    (Verdict.FALSE, False): Standing("refuted", "This document refutes it."),
}


def standing(verdict: Verdict, here: Measurement) -> Standing:
    """Return how the document that was measured stands to a verdict; nothing else says so anywhere.

    What holds on every trial is true, so that no document is left that refutes what is.
    """
    return _STANDINGS[verdict, here.holds]


def by_claim(findings: Iterable[Finding]) -> Iterator[tuple[Claim, list[Finding]]]:
    """Yield each claim with its findings, one for each formulation."""
    for claim, of_claim in groupby(findings, key=lambda finding: finding.claim):
        yield claim, list(of_claim)


def findings_text(findings: Iterable[Finding]) -> str:
    """Return the findings as one block a claim."""
    lines = [
        f"{'':15}  {'verdict':<{_VERDICT}}{'here':<15}{'measured':>10}{'largest':>10}   (largest: over all trials)"
    ]
    for claim, of_claim in by_claim(findings):
        lines += ["", f"{claim.name}: {claim.text}, {claim.where}", f"  {of_claim[0].here.what}"]
        for finding in of_claim:
            here = standing(finding.verdict, finding.here).words
            numbers = "".join(f"{value:>10.3g}" if isfinite(value) else f"{'-':>10}" for value in _values(finding))
            lines += [f"  {finding.formulation:<15}{finding.words:<{_VERDICT}}{here:<15}{numbers}", *_details(finding)]
    return "\n".join(lines)


def _values(finding: Finding) -> tuple[float, float]:
    return finding.here.value, finding.largest


def _details(finding: Finding) -> Iterator[str]:
    """Yield the lines below a finding: its condition, how it is known, what was found."""
    texts = [f"if {finding.condition}"] if finding.condition else []
    if finding.proof:
        texts.append(f"{finding.ground}: {finding.proof}")
    if finding.ground is Ground.DOCUMENT:
        texts.append(finding.ground)
    texts += [finding.here.note] if finding.here.note else []
    if finding.counterexample is not None and finding.ground is Ground.COUNTEREXAMPLE:
        texts.append(f"counterexample: {'this document' if not finding.here.holds else 'one of the trials'}")
    for text in texts:
        yield from textwrap.wrap(text, _WIDTH, initial_indent=_INDENT, subsequent_indent=_INDENT + "  ")


def findings_markdown(findings: Iterable[Finding]) -> str:
    """Return the table "what the paper says, what is so" for GitHub; a number in brackets is the measured one.

    What is so instead stands beside the verdicts on the surface that the paper's claims describe.
    """
    titles = ["the paper says", "where", *(f"`{name}`" for name in FORMULATIONS)]
    rows = [titles, ["---"] * len(titles)]
    for claim, of_claim in by_claim(findings):
        cells = {finding.formulation: _cell(finding) for finding in of_claim}
        rows.append([claim.text, claim.where, *(cells[formulation] for formulation in FORMULATIONS.values())])
    return "\n".join(f"| {' | '.join(_escaped(cell) for cell in row)} |" for row in rows)


def _cell(finding: Finding) -> str:
    verdict = f"**{finding.words}**"
    if finding.condition:
        verdict += f" {finding.condition}"
    if finding.ground is not Ground.TRIALS:
        verdict += f"{';' if finding.condition else ','} {finding.ground}"
    if finding.verdict is Verdict.FALSE:
        failing = finding.largest if finding.here.holds else finding.here.value
        verdict += f" ({failing:.2g})" if failing < _LONG else f" ({failing:.0f})"
    has_document = finding.example or finding.counterexample
    is_noted = finding.formulation.is_as_claimed and finding.here.note and has_document
    return f"{verdict}; {finding.here.note}" if is_noted else verdict


def _escaped(text: str) -> str:
    for sign in "|_":
        text = text.replace(sign, f"\\{sign}")
    return text
