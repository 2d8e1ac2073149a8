"""What computation says of the paper's claims: verdicts from trials and exact proofs, never written down."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import cache, lru_cache

import numpy as np

from qovr_core.construction import build_patch, overflow_error
from qovr_core.document import Document, Window
from qovr_core.edits import extract_window
from qovr_core.formulations import FORMULATIONS, Formulation
from qovr_core.geometry.rounding import largest
from qovr_core.laboratory.claims import CLAIMS, Claim
from qovr_core.laboratory.measurement import Measurement
from qovr_core.laboratory.own_unit import document_in_own_unit, in_unit
from qovr_core.laboratory.trials import random_documents

_LARGEST = 1e90
"""Coordinates beyond this, of a net of size 1, come of knots that no longer shape a curve. What claims measure is made
of up to three of them, and no verdict is to hang on what has overflown."""


_REMEMBERED = 8
"""Every claim asks how far the same surfaces reach: a net and one of its windows, under three formulations."""


class Verdict(StrEnum):
    """What computation says of a claim, for one formulation."""

    TRUE = "true"
    TRUE_IF = "true if"
    FALSE = "false"


class Ground(StrEnum):
    """How a verdict is known."""

    PROVED = "proved"
    COUNTEREXAMPLE = "by counterexample"
    DOCUMENT = "decided for this document"
    TRIALS = "not refuted"


@dataclass(frozen=True, eq=False)
class Finding:
    """The verdict on one claim for one formulation, how it is known, and how one document stands.

    Parameters
    ----------
    claim, formulation : what was decided
    verdict : on the claim in general, from all trials
    ground : how it is known
    condition : where the verdict is ``true if``, under what
    proof : where it is proved, what was
    trials : how many documents were tried, of those that meet the condition
    here : what the claim comes to on the document
    largest : the largest value of all trials
    counterexample : where the verdict is ``false``, a document on which the claim fails
    """

    claim: Claim
    formulation: Formulation
    verdict: Verdict
    ground: Ground
    condition: str
    proof: str
    trials: int
    here: Measurement
    largest: float
    counterexample: Document | None

    @property
    def words(self) -> str:
        """The verdict in words: of what only trials support no one can say that it is true."""
        if self.ground is not Ground.TRIALS:
            return str(self.verdict)
        documents = "1 trial" if self.trials == 1 else f"{self.trials} trials"
        return f"{self.ground} by {documents}{' if' * (self.verdict is Verdict.TRUE_IF)}"

    @property
    def example(self) -> Document | None:
        """A document that shows what the note of this document's measurement says."""
        return self.here.example


@dataclass(frozen=True)
class _Trial:
    """A document, what a claim comes to on it, and the document as it is shown, in the unit that was asked about."""

    document: Document
    measured: Measurement
    shown: Document


def verify(
    document: Document, window: Window = (0, 0), report: Callable[[Finding], object] = lambda _finding: None
) -> tuple[Finding, ...]:
    """Decide every claim for every formulation, and measure it on a document.

    The document's own formulation does not matter: it is looked at under each.

    Parameters
    ----------
    window : (a, b), the window of a net on which claims are measured that do not speak of joints
    report : called with each finding as soon as it is known; what it raises ends the work

    Returns
    -------
    one finding for each claim and formulation, claim by claim

    Raises
    ------
    DocumentError : the net has no such window
    EvaluationError : the document has no finite surface under some formulation
    """
    findings = []
    for claim in CLAIMS.values():
        for formulation in FORMULATIONS.values():
            findings.append(decide(claim, document, formulation, window))
            report(findings[-1])
    return tuple(findings)


@np.errstate(all="ignore")  # what overflows is not finite, and no claim holds there; what underflows is nothing
def decide(claim: Claim, document: Document, formulation: Formulation, window: Window = (0, 0)) -> Finding:
    """Decide a claim for a formulation, and measure it on a document.

    A claim about joints is measured on the whole net, any other on its window (a, b). The trials are that under the
    formulation, the claim's examples made from the window, random documents from a stated seed, and the examples made
    from the first of these. A claim that holds on all of them is true. If it holds on all that meet its condition, some
    do, and one that does not meet it fails, it is true under that condition. Else it is false, and the first trial on
    which it fails is the counterexample. What is true and has a proof that holds is proved.

    Raises
    ------
    DocumentError : the net has no such window
    EvaluationError : the document has no finite surface, or none that can be measured
    """
    whole = replace(document, formulation=formulation)
    focus = extract_window(whole, window)
    shown = whole if claim.is_of_joints else focus
    here, unit = document_in_own_unit(shown)
    if _reach(here) > _LARGEST:
        raise overflow_error(shown)
    measured = claim.measure(here)
    if measured.example is not None:
        measured = replace(measured, example=shown if measured.example is here else in_unit(measured.example, unit))
    trials = [_Trial(here, measured, shown)]
    if claim.is_general:
        made_from = here if shown is focus else replace(focus, control_points=focus.control_points / unit)
        trials += [_Trial(made, claim.measure(made), in_unit(made, unit)) for made in claim.examples(made_from)]
        trials += _fixed_trials(claim, formulation)
    return _finding(claim, formulation, trials)


@lru_cache(maxsize=_REMEMBERED)
def _reach(document: Document) -> float:
    return largest(build_patch(document).coefficients)


def _fixed_trials(claim: Claim, formulation: Formulation) -> tuple[_Trial, ...]:
    """Return the trials that do not depend on the document: what is special about it may fool all made from it.

    Those of the program's own records are made once; others may come under one name one after the other.
    """
    is_own = CLAIMS.is_own(claim) and FORMULATIONS.is_own(formulation)
    return (_remembered_trials if is_own else _made_trials)(claim, formulation)


def _made_trials(claim: Claim, formulation: Formulation) -> tuple[_Trial, ...]:
    random = random_documents(formulation)
    return tuple(_Trial(made, claim.measure(made), made) for made in (*random, *claim.examples(random[0])))


_remembered_trials = cache(_made_trials)


def _finding(claim: Claim, formulation: Formulation, trials: list[_Trial]) -> Finding:
    failing = [trial for trial in trials if not trial.measured.holds]
    support = _support(claim, trials) if failing else _Support("", len(trials))
    verdict = Verdict.TRUE if not failing else Verdict.TRUE_IF if support.condition else Verdict.FALSE
    proof = _proof(claim, formulation, support) if verdict is not Verdict.FALSE else ""
    return Finding(
        claim=claim,
        formulation=formulation,
        verdict=verdict,
        ground=_ground(claim, verdict, proof),
        condition=support.condition,
        proof=proof,
        trials=support.trials,
        here=trials[0].measured,
        largest=max(trial.measured.value for trial in trials),
        counterexample=failing[0].shown if verdict is Verdict.FALSE else None,
    )


def _ground(claim: Claim, verdict: Verdict, proof: str) -> Ground:
    if not claim.is_general:
        return Ground.DOCUMENT
    if verdict is Verdict.FALSE:
        return Ground.COUNTEREXAMPLE
    return Ground.PROVED if proof else Ground.TRIALS


def _proof(claim: Claim, formulation: Formulation, support: _Support) -> str:
    """Return what is proved of a claim, for all its parts; empty where nothing is."""
    proof = claim.proofs.get(formulation)
    return proof.statement if proof is not None and proof.parts >= support.parts and proof.holds() else ""


@dataclass(frozen=True)
class _Support:
    """Under what condition trials support a claim, empty for none, how many do, and of which parts it speaks."""

    condition: str
    trials: int
    parts: frozenset[str] = frozenset()


def _support(claim: Claim, trials: list[_Trial]) -> _Support:
    """Return how trials support a claim that fails on some: where there is no condition, it is false."""
    if claim.parts_condition:
        kept = _parts_kept(trials)
        condition = claim.parts_condition.format(parts=", ".join(kept)) if kept else ""
        return _Support(condition, len(trials), frozenset(kept))
    if claim.condition is None:
        return _Support("", len(trials))
    held = [trial.measured.holds for trial in trials if claim.condition.is_met(trial.document)]
    return _Support(claim.condition.text if held and all(held) else "", len(held))


def _parts_kept(trials: list[_Trial]) -> list[str]:
    """Return the curves whose knots have an effect in some trial and keep the claim in every one."""
    answers: dict[str, bool] = {}
    for trial in trials:
        for part, keeps in trial.measured.parts.items():
            answers[part] = answers.get(part, True) and keeps
    return sorted(part for part, keeps in answers.items() if keeps)
