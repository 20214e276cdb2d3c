"""The front of a lecture: its title, its source, and the figure that its page opens with."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Opening:
    """What the page of a lecture opens with: a figure of the catalogue, at these parameters.

    The `invitation` is the sentence beneath it, in place of a caption.
    """

    figure: str
    invitation: str
    settings: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class Front:
    """What stands on the first page of a lecture and of its exercises, and whose claims it has."""

    title: str
    subtitle: str
    source: str
    exercises: str
    author: str = "rigidtop"
    byline: str = ""
    questions: str = ""
    """What a sheet of questions says in place of the `source`, if it does."""
    opening: Opening | None = None


_OF_THE_NOTES = (
    "The numbered equations and the claims, but for what is called ours, are those of the lecture "
    "notes of Sebastian Wüster, PHY 305 Classical Mechanics, IISER Bhopal, 2020, week 8."
)
NOTES = Front(
    "Rigid rotation and the spinning top: derived and judged",
    "Free precession, Euler angles and the heavy symmetric top, equations (3.33) to (3.57)",
    f"{_OF_THE_NOTES} The wording, the derivations and the verdicts are ours. Every verdict on "
    "these pages was computed when they were written.",
    "Rigid rotation and the spinning top: exercises",
    questions=_OF_THE_NOTES,
    opening=Opening(
        "top",
        "Why does a spinning top go round instead of falling, and why does its axis draw loops on "
        "the way?",
        {"phi_dot": -1.5},
    ),
)
"""The lecture notes on the top."""
