"""What computation says of the paper's claims: verdicts from trials, never written down."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import cache

import numpy as np

from qovr_core.construction import build_patch, overflow_error
from qovr_core.document import Document
from qovr_core.formulations import FORMULATIONS, Formulation
from qovr_core.geometry.rounding import largest
from qovr_core.laboratory.claims import CLAIMS, Claim
from qovr_core.laboratory.measurement import Measurement
from qovr_core.laboratory.own_unit import document_in_own_unit, in_unit
from qovr_core.laboratory.trials import random_documents

_LARGEST = 1e90
"""Coordinates beyond this, of a net of size 1, come of knots that no longer shape a curve. What claims measure is made
of up to three of them, and no verdict is to hang on what has overflown."""


class Verdict(StrEnum):
    """What computation says of a claim, for one formulation."""

    TRUE = "true"
    TRUE_IF = "true if"
    FALSE = "false"


@dataclass(frozen=True, eq=False)
class Finding:
    """The verdict on one claim for one formulation, and how one document stands.

    Parameters
    ----------
    claim, formulation : what was decided
    verdict : on the claim in general, from all trials
    condition : where the verdict is ``true if``, under what
    here : what the claim comes to on the document
    largest : the largest value of all trials
    counterexample : where the verdict is ``false``, a document on which the claim fails
    """

    claim: Claim
    formulation: Formulation
    verdict: Verdict
    condition: str
    here: Measurement
    largest: float
    counterexample: Document | None

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


def verify(document: Document, report: Callable[[Finding], object] = lambda _finding: None) -> tuple[Finding, ...]:
    """Decide every claim for every formulation, and measure it on a document.

    The document's own formulation does not matter: it is looked at under each.

    Parameters
    ----------
    report : called with each finding as soon as it is known; what it raises ends the work

    Returns
    -------
    one finding for each claim and formulation, claim by claim

    Raises
    ------
    EvaluationError : the document has no finite surface under some formulation
    """
    findings = []
    for claim in CLAIMS.values():
        for formulation in FORMULATIONS.values():
            findings.append(decide(claim, document, formulation))
            report(findings[-1])
    return tuple(findings)


@np.errstate(all="ignore")  # what overflows is not finite, and no claim holds there; what underflows is nothing
def decide(claim: Claim, document: Document, formulation: Formulation) -> Finding:
    """Decide a claim for a formulation, and measure it on a document.

    The trials are the document under that formulation, the claim's examples made from it, random documents from a
    stated seed, and the examples made from the first of these. A claim that holds on all of them is true. If it
    holds on all that meet its condition, some do, and one that does not meet it fails, it is true under that
    condition. Else it is false, and the first trial on which it fails is the counterexample.

    Raises
    ------
    EvaluationError : the document has no finite surface, or none that can be measured
    """
    shown = replace(document, formulation=formulation)
    here, unit = document_in_own_unit(shown)
    if largest(build_patch(here).coefficients) > _LARGEST:
        raise overflow_error(shown)
    measured = claim.measure(here)
    if measured.example is not None:
        measured = replace(measured, example=shown if measured.example is here else in_unit(measured.example, unit))
    trials = [_Trial(here, measured, shown)]
    if claim.is_general:
        trials += [_Trial(made, claim.measure(made), in_unit(made, unit)) for made in claim.examples(here)]
        trials += _fixed_trials(claim, formulation)
    return _finding(claim, formulation, trials)


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
    condition = _condition_met(claim, trials) if failing else ""
    verdict = Verdict.TRUE if not failing else Verdict.TRUE_IF if condition else Verdict.FALSE
    return Finding(
        claim=claim,
        formulation=formulation,
        verdict=verdict,
        condition=condition,
        here=trials[0].measured,
        largest=max(trial.measured.value for trial in trials),
        counterexample=failing[0].shown if verdict is Verdict.FALSE else None,
    )


def _condition_met(claim: Claim, trials: list[_Trial]) -> str:
    """Return the condition under which a claim that fails somewhere is true; empty where there is none."""
    if claim.parts_condition:
        kept = _parts_kept(trials)
        return claim.parts_condition.format(parts=", ".join(kept)) if kept else ""
    if claim.condition is None:
        return ""
    meets = [claim.condition.is_met(trial.document) for trial in trials]
    holds = [trial.measured.holds for trial in trials]
    sufficient = any(meets) and all(held for held, met in zip(holds, meets, strict=True) if met)
    return claim.condition.text if sufficient else ""


def _parts_kept(trials: list[_Trial]) -> list[str]:
    """Return the curves whose knots have an effect in some trial and keep the claim in every one."""
    answers: dict[str, bool] = {}
    for trial in trials:
        for part, keeps in trial.measured.parts.items():
            answers[part] = answers.get(part, True) and keeps
    return sorted(part for part, keeps in answers.items() if keeps)
