"""The lecture, judged, and its exercises, solved once for all tests of a worker."""

import pytest

from rigidtop.derivations import PAGES, lecture_with
from rigidtop.derivations.exercises import EXERCISES
from rigidtop.proof.verdict import judge_page
from rigidtop.report.solutions import solved

from ..typeset.conftest import printed

__all__ = ["printed"]


@pytest.fixture(scope="session")
def judged():
    return [(page, judge_page(page)) for page in PAGES]


@pytest.fixture(scope="session")
def known(judged):
    """Judgements by the names of their claims."""
    return {j.claim.name: j for _, judgements in judged for j in judgements}


@pytest.fixture(scope="session")
def lines():
    return lecture_with([exercise.text for exercise in EXERCISES if exercise.text])


@pytest.fixture(scope="session")
def solutions(known, lines):
    return [solved(exercise, judged=known, lines=lines) for exercise in EXERCISES]
