"""Exercises, solved for the settings of a test."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from rigidtop.derivations.exercises import EXERCISES
from rigidtop.parameters import settings
from rigidtop.proof.exercise import Answer, Outcome, Table
from rigidtop.proof.page import Measure


class Solved(list[Outcome]):
    """What an exercise yields, by name."""

    def __getitem__(self, name):
        [found] = [o for o in self if isinstance(o, (Answer, Table)) and o.name == name]
        return found.value if isinstance(found, Answer) else found

    @property
    def measures(self) -> list[Measure]:
        return [o for o in self if isinstance(o, Measure)]


@pytest.fixture(scope="session")
def solve() -> Callable[..., Solved]:
    """``solve("toppling-top", theta=0.1)["time_to_fall"]``."""
    by_name = {exercise.name: exercise for exercise in EXERCISES}

    def solved(name: str, **given: float) -> Solved:
        exercise = by_name[name]
        return Solved(exercise.solve(**settings(exercise.parameters, given)))

    return solved
