"""The exercises of the lecture, solved once for all tests of a worker."""

import pytest

from rigidtop.derivations import lecture_with
from rigidtop.derivations.exercises import EXERCISES
from rigidtop.report.solutions import solved

from ..typeset.conftest import printed

__all__ = ["printed"]


@pytest.fixture(scope="session")
def lines():
    return lecture_with([exercise.text for exercise in EXERCISES if exercise.text])


@pytest.fixture(scope="session")
def solutions(judgements, lines):
    return [solved(exercise, judged=judgements, lines=lines) for exercise in EXERCISES]
