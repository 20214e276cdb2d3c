"""The lecture, a page a section of the notes, in reading order."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from importlib.resources import files

from rigidtop.derivations import (
    euler_angles,
    eulers_equations,
    free_precession,
    lagrange_formalism,
    net_torque,
    nutation,
    opening,
    precession_of_rotation_axis,
    rotation_matrices,
    simplified_picture,
    space_and_body_frames,
)
from rigidtop.derivations.letters import LETTERS
from rigidtop.judge.page import refuted
from rigidtop.notation import NOTES
from rigidtop.proof.lecture import Lecture, Text
from rigidtop.read.page import read_exercises, read_lecture

PAGES = (
    opening.page,
    free_precession.page,
    space_and_body_frames.page,
    eulers_equations.page,
    precession_of_rotation_axis.page,
    euler_angles.page,
    rotation_matrices.page,
    net_torque.page,
    simplified_picture.page,
    lagrange_formalism.page,
    nutation.page,
)
"""Every page of the lecture."""

TEXTS = (
    "laws",
    "opening",
    "free_precession",
    "space_and_body_frames",
    "eulers_equations",
    "precession_of_rotation_axis",
    "euler_angles",
    "rotation_matrices",
    "net_torque",
    "simplified_picture",
    "lagrange_formalism",
    "nutation",
)
"""The pages as they are read aloud, Markdown files beside this one, in reading order."""

FORMERLY = (
    ("the component off the diagonal", "the product of inertia"),
    ("the frequency in the body", "the precession frequency in the body frame"),
    ("the frequency in space", "the precession frequency in the space frame"),
    ("the inner torque", "the internal torque"),
    ("the momentum of $\\phi$", "the momentum conjugate to $\\phi$"),
    ("the momentum of $\\psi$", "the momentum conjugate to $\\psi$"),
    ("the weight against the spin", "the small parameter $\\varepsilon$"),
    ("the square of the frequency of nutation", "the square of the nutation frequency"),
)
"""What lines were called once, with what they are called now: pages of others cite them so."""


@cache
def lecture() -> Lecture:
    """The text of the lecture, read: every line with the move that leads to it."""
    text = read_lecture(_sources(TEXTS), LETTERS, NOTES)
    return replace(text, refuted=refuted, formerly=FORMERLY)


@cache
def laws() -> Text:
    """The page of laws that the lecture starts from."""
    return read_lecture(_sources(TEXTS[:1]), LETTERS, NOTES).texts[0]


def lecture_with(exercises: Sequence[str]) -> Lecture:
    """The lecture with the solutions of exercises, named as in `Exercise.text`, behind it."""
    return _lecture_with(tuple(exercises))


@cache
def _lecture_with(exercises: tuple[str, ...]) -> Lecture:
    return read_exercises(_sources(exercises), lecture(), NOTES)


def _sources(names: Sequence[str]) -> list[tuple[str, str]]:
    folder = files(__package__)
    return [(name, folder.joinpath(f"{name}.md").read_text("utf-8")) for name in names]
