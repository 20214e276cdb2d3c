"""The lecture, a page a section of the notes, in reading order."""

from __future__ import annotations

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
from rigidtop.notation import NOTES
from rigidtop.proof.lecture import Lecture
from rigidtop.read.page import read_lecture

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


@cache
def lecture() -> Lecture:
    """The text of the lecture, read: every line with the move that leads to it."""
    folder = files(__package__)
    sources = [(name, folder.joinpath(f"{name}.md").read_text("utf-8")) for name in TEXTS]
    return read_lecture(sources, LETTERS, NOTES)
