"""An evaluation computes what it is asked for, once, whoever asks."""

import weakref
from concurrent.futures import ThreadPoolExecutor
from threading import Barrier

import numpy as np
import pytest

from qovr_core import Document, Evaluation, EvaluationError, Knots, Layer, Patch, configure
from support.documents import random_document, random_net

LAZY = ("network", "control_box", "raw_box", "matrix", "flat_axes", "transformed_patch", "u", "v", "raw", "transformed")


@pytest.fixture
def counted(monkeypatch):
    """Count the calls of the patch's methods that take points or boxes."""
    calls = []

    def counting(name):
        method = getattr(Patch, name)

        def counted_method(self, *arguments):
            calls.append(name)
            return method(self, *arguments)

        monkeypatch.setattr(Patch, name, counted_method)

    for name in ("points", "sampled_box", "transformed"):
        counting(name)
    return calls


def test_the_patch_is_there_at_once_and_nothing_else(counted):
    evaluation = Evaluation(random_document(1))
    assert evaluation.degree == evaluation.patch.degree
    assert counted == []
    with pytest.raises(EvaluationError, match=r"row_knots\[0\]\.r"):
        Evaluation(Document(random_net(1), (Knots(r=1e-320),) * 5, formulation="interpolating"))


def test_a_box_takes_no_samples_and_is_the_same_beside_them(counted):
    alone, after = Evaluation(random_document(1)), Evaluation(random_document(1))
    box = alone.raw_box
    assert counted == ["sampled_box"]
    assert after.raw.shape == (7, 5, 3)
    assert np.array_equal(after.raw_box, box)


@pytest.mark.parametrize("name", LAZY)
def test_everything_is_computed_once(name):
    evaluation = Evaluation(random_document(2))
    first = getattr(evaluation, name)
    assert getattr(evaluation, name) is first
    if isinstance(first, np.ndarray):
        assert not first.flags.writeable


@pytest.mark.parametrize("name", LAZY)
def test_two_threads_are_given_the_same(name):
    evaluation, together = Evaluation(random_document(2, samples=(300, 300))), Barrier(2)

    def ask(_thread):
        together.wait()
        return getattr(evaluation, name)

    with ThreadPoolExecutor(2) as threads:
        first, second = threads.map(ask, range(2))
    assert first is second


def test_samples_can_be_dropped_and_come_again():
    evaluation = configure(random_document(3))
    before = [evaluation.samples(layer).copy() for layer in Layer]
    matrix = evaluation.matrix
    evaluation.drop_samples()
    assert evaluation.matrix is matrix
    assert all(np.array_equal(evaluation.samples(layer), old) for layer, old in zip(Layer, before, strict=True))
    assert evaluation.samples(Layer.RAW) is evaluation.raw
    assert evaluation.samples(Layer.TRANSFORMED) is evaluation.transformed


def test_dropped_samples_are_let_go():
    evaluation = configure(random_document(3))
    held = [weakref.ref(evaluation.samples(layer)) for layer in Layer]
    assert all(reference() is not None for reference in held)
    evaluation.drop_samples()
    assert all(reference() is None for reference in held)
