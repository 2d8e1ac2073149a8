"""What a claim of the paper is, and how a verdict on it is computed from trials; never written down."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from enum import StrEnum
from functools import cache

import numpy as np

from qovr_core.document import Document
from qovr_core.formulations import Formulation
from qovr_core.laboratory.trials import random_documents


class Verdict(StrEnum):
    """What computation says of a claim, for one formulation."""

    TRUE = "true"
    TRUE_IF = "true if"
    FALSE = "false"


@dataclass(frozen=True, eq=False)
class Measurement:
    """What one claim comes to on one document.

    Parameters
    ----------
    value : the measured number
    what : what that number is
    holds : whether the claim holds on this document
    note : what else was found, as the weight rows that take the place of the paper's
    parts : for a claim about the knots of single curves, each curve with an effect and whether it keeps the claim
    example : a document that shows what the note says
    """

    value: float
    what: str
    holds: bool
    note: str = ""
    parts: Mapping[str, bool] = field(default_factory=dict)
    example: Document | None = None


@dataclass(frozen=True)
class Condition:
    """A condition under which a claim is true.

    Parameters
    ----------
    text : the condition, to be read after "true if"
    is_met : whether a document meets it
    """

    text: str
    is_met: Callable[[Document], bool]


def _no_examples(_document: Document) -> tuple[Document, ...]:
    """Try no documents but the usual ones; has a name, so that a claim can go to another process."""
    return ()


@dataclass(frozen=True)
class Claim:
    """One claim of the paper and the function that decides it.

    Parameters
    ----------
    id : its short name
    text : what the paper says
    where : the equation, lemma or section
    measure : what it comes to on a document, under that document's formulation
    condition : under what it may be true
    parts_condition : for a claim about the knots of single curves, the condition with ``{parts}`` for the curves
    examples : documents made from one that are tried too, such as meet the condition and such as do not
    is_general : whether it speaks of all surfaces; if not, it is decided by the document alone
    """

    id: str
    text: str
    where: str
    measure: Callable[[Document], Measurement]
    condition: Condition | None = None
    parts_condition: str = ""
    examples: Callable[[Document], Sequence[Document]] = _no_examples
    is_general: bool = True

    @property
    def file_name(self) -> str:
        """Its name where no apostrophe may stand."""
        return self.id.replace("'", "-transformed")


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
    document: Document
    measured: Measurement


def decide(claim: Claim, document: Document, formulation: Formulation) -> Finding:
    """Decide a claim for a formulation, and measure it on a document.

    The trials are the document under that formulation, the claim's examples made from it, random documents from a
    stated seed, and the examples made from the first of these. A claim that holds on all of them is true. If it
    holds on all that meet its condition, some do, and one that does not meet it fails, it is true under that
    condition. Else it is false, and the first trial on which it fails is the counterexample.

    Raises
    ------
    EvaluationError : the document has no finite surface
    """
    here = replace(document, formulation=formulation)
    trials = [_Trial(here, _measured(claim, here))]
    if claim.is_general:
        trials += [_Trial(example, _measured(claim, example)) for example in claim.examples(here)]
        trials += [_Trial(fixed, _measured_once(claim, fixed)) for fixed in _fixed_trials(claim, formulation)]
    return _finding(claim, formulation, trials)


def _measured(claim: Claim, document: Document) -> Measurement:
    with np.errstate(all="ignore"):  # what overflows is not finite, and no claim holds there
        return claim.measure(document)


@cache
def _fixed_trials(claim: Claim, formulation: Formulation) -> tuple[Document, ...]:
    """Return the trials that do not depend on the document: what is special about it may fool all made from it."""
    random = random_documents(formulation)
    return (*random, *claim.examples(random[0]))


@cache
def _measured_once(claim: Claim, document: Document) -> Measurement:
    """Measure a document that is the same for everybody."""
    return _measured(claim, document)


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
        counterexample=failing[0].document if verdict is Verdict.FALSE else None,
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
