"""A worker that leaves nothing, and a way to run one job on it."""

import pytest

from qovr_app.work.worker import Worker
from support.working import Heard, children


@pytest.fixture
def worker(app):
    made = Worker()
    yield made
    made.close()
    assert children() == []


@pytest.fixture
def answer(worker, spin):
    """A function that runs a job to its end and returns what was told of it."""

    def run(function, *values, **options):
        heard = Heard()
        worker.run(function, *values, **heard.callbacks(), **options)
        spin(lambda: heard.is_over, seconds=60)
        return heard

    return run
