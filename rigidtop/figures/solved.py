"""The numbers of an exercise, for the figure that shows it."""

from __future__ import annotations

from itertools import takewhile
from typing import Any

from rigidtop.proof.exercise import Answer, Exercise


def answers(exercise: Exercise, **settings: float) -> dict[str, Any]:
    """What an exercise finds for its settings, by the names of its answers.

    The answers stand first; what comes after, and confirms them, takes longer and is not asked for.
    Raises RigidtopError where the exercise does.
    """
    found = takewhile(lambda each: isinstance(each, Answer), exercise.solve(**settings))
    return {each.name: each.value for each in found if isinstance(each, Answer)}
