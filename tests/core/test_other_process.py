"""What the laboratory finds goes to another process and back: records by their names, all else by value."""

import math
import multiprocessing
import pickle

import numpy as np
import pytest

from qovr_core import FORMULATIONS
from qovr_core.fields import FIELDS
from qovr_core.laboratory.claims import CLAIMS
from qovr_core.laboratory.comparison import ComparisonInput, compare
from qovr_core.laboratory.comparison_surfaces import COMPARISON_SURFACES
from qovr_core.laboratory.verify import verify
from support.documents import random_document

DOCUMENT = random_document(11, low=0.35, high=0.65)


def echo(connection):
    """Send everything that comes back as it is; runs in a fresh interpreter, which has imported nothing of the core."""
    while (content := connection.recv()) is not None:
        connection.send(content)


@pytest.fixture(scope="module")
def sent():
    """Return a function that sends a value through a spawned process."""
    context = multiprocessing.get_context("spawn")
    here, there = context.Pipe()
    process = context.Process(target=echo, args=(there,))
    process.start()

    def through(value):
        here.send(value)
        return here.recv()

    yield through
    here.send(None)
    process.join()


def same(a, b):
    """Compare two values by everything in them."""
    if isinstance(a, np.ndarray):
        return np.array_equal(a, b, equal_nan=True)
    if isinstance(a, dict):
        return list(a) == list(b) and all(same(a[key], b[key]) for key in a)
    if isinstance(a, (tuple, list)):
        return len(a) == len(b) and all(map(same, a, b))
    if hasattr(a, "__dict__") and type(a).__module__.startswith("qovr_core.laboratory"):
        return type(a) is type(b) and same(vars(a), vars(b))
    return a == b or (isinstance(a, float) and math.isnan(a) and math.isnan(b))


TABLES = {"fields": FIELDS, "formulations": FORMULATIONS, "claims": CLAIMS, "surfaces": COMPARISON_SURFACES}


@pytest.mark.parametrize("table", TABLES.values(), ids=TABLES)
def test_records_come_back_as_themselves(sent, table):
    for record in table.values():
        assert sent(record) is record
        assert len(pickle.dumps(record)) < 200


def test_findings_come_back_whole(sent):
    findings = verify(DOCUMENT)
    returned = sent(findings)
    assert all(finding.claim is CLAIMS[finding.claim.name] for finding in returned)
    assert same(findings, returned)


def test_a_comparison_comes_back_whole(sent):
    comparison = compare(DOCUMENT)
    returned = sent(comparison)
    assert isinstance(returned.of, ComparisonInput)
    assert same(comparison, returned)
