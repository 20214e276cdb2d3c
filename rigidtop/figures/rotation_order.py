"""Two rotations of a book, in one order and in the other (section 3.4)."""

from __future__ import annotations

import math
from typing import Any, TypeAlias

import numpy as np
from matplotlib.axes import Axes
from scipy.spatial.transform import Rotation

from rigidtop.derivations.exercises.rotation_matrices import about, rotations_form_a_group
from rigidtop.figures import picture as pen
from rigidtop.figures import solids
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.solved import answers
from rigidtop.figures.space import View, unit
from rigidtop.figures.style import Canvas, Floats, canvas, degrees, said

VIEW = View(azimuth=0.5, elevation=0.42)
HALF = np.array([0.15, 0.5, 0.66])
"""Half the thickness, the width and the height of the book, along x̂, ŷ and ẑ before the turns."""

COVER, BACK, SPINE, PAPER, EDGE = "#dbe7cf", "#9cc07f", "#55703f", "#ffffff", "#3d5230"
COLOURS = COVER, BACK, PAPER, SPINE, PAPER, PAPER
"""Of the faces: the cover looks along x̂, the spine against ŷ."""

LETTER = np.array([[-0.5, -0.6], [-0.5, 0.6], [0.5, 0.6], [-0.5, 0.6], [-0.5, 0.05], [0.3, 0.05]])
"""An F on the cover, along ŷ and ẑ in half widths and heights: it shows which way is up, and it is
no other letter in a mirror."""

BAR = np.array([[-0.5, 0.6], [0.5, 0.6]])
"""A bar on the back, along its upper edge."""

TURNED_ABOUT = "#8fd3e3"
TURN = "#3f7d2a"

Turn: TypeAlias = tuple[int, float]
"""About n₁ (0) or n₂ (1), and by how much (rad)."""

CLOSE = 0.15
"""Axes at a smaller angle (rad) get one name for both."""

SAME = 1e-9
"""Ends that differ by a smaller angle (rad) are one, to rounding."""


def axes_of_rotation(gamma: float) -> Floats:
    """n₁ and n₂ (2, 3), as in the exercise: n₁ along x̂, and n₂ at `gamma` (rad) towards ŷ."""
    return np.array([[1.0, 0.0, 0.0], [math.cos(gamma), math.sin(gamma), 0.0]])


def matrices(alpha: float, beta: float, gamma: float) -> Floats:
    """A and B (2, 3, 3)."""
    first, second = axes_of_rotation(gamma)
    return np.array([about(first, alpha), about(second, beta)])


def book(turn: Floats) -> list[pen.Part]:
    """The book, turned by a matrix (3, 3), with its F, its bar and the sheets of its paper."""
    parts: list[pen.Part] = []
    for color, (corners, normal) in zip(COLOURS, solids.faces(turn, HALF), strict=True):
        parts.append(pen.Face(corners, color, EDGE, 0.8, z=3, normal=normal))
        if color in (COVER, BACK):
            flat, label = (LETTER, "_letter") if color == COVER else (BAR, "_")
            stroke = HALF[0] * normal + flat * HALF[1:] @ turn[:, 1:].T
            parts.append(pen.Curve(stroke, EDGE, 2.2, z=4, label=label, normal=normal))
        for share in (-0.4, 0.0, 0.4) if color == PAPER else ():  # parallel to the covers
            sheet = corners[[0, 3]] + (1 + share) * HALF[0] * turn[:, 0]
            parts.append(pen.Curve(sheet, look.GREY, 0.4, z=4, normal=normal))
    return parts


def leaves(turn: Floats, direction: Floats) -> tuple[Floats, bool]:
    """Where a ray from the centre leaves the book turned by a matrix (3, 3), and whether that face
    is seen."""
    inside = direction @ turn
    distances = HALF / np.maximum(np.abs(inside), 1e-12)
    axis = int(np.argmin(distances))
    normal = math.copysign(1.0, inside[axis]) * turn[:, axis]
    return distances[axis] * direction, float(VIEW(normal)[2]) > 0


def draw_turned(axes: Axes, turn: Floats, gamma: float, last: Turn | None = None) -> None:
    """The book, turned by a matrix, with n₁ and n₂, which stay where they are.

    `last` says about which of the two it has just been turned, 0 or 1, and by how much (rad).
    """
    ends = 1.15 * axes_of_rotation(gamma)
    close = gamma < CLOSE
    names = (
        ("", r"$\mathbf{n}_1, \mathbf{n}_2$") if close else (r"$\mathbf{n}_1$", r"$\mathbf{n}_2$")
    )
    parts = book(turn)
    for end, name in zip(ends, names, strict=True):
        out, seen = leaves(turn, unit(end))
        below = (-3.0, -10.0) if close else None
        parts.append(pen.Arrow(end, name, look.FIRST, 1.0, out, below, 5 if seen else 2))
    if last is not None:
        k, angle = last
        # Around the end of the axis, from above it.
        start = 0.82 * ends[k] + np.array([0.0, 0.0, 0.34])
        turns = np.outer(np.linspace(0, angle, 61), unit(ends[k]))
        way, z = Rotation.from_rotvec(turns).apply(start), 5.5 if leaves(turn, ends[k])[1] else 2.5
        parts.append(pen.Curve([pen.ORIGIN, 0.95 * ends[k]], TURNED_ABOUT, 4.5, z=1, cap="round"))
        parts.append(pen.Curve(way, TURN, z=z, head=abs(angle) > 0.2, label="_turn"))
    pen.draw(axes, parts, VIEW)


def orders(alpha: float, beta: float, gamma: float) -> list[list[tuple[str, Floats, Turn | None]]]:
    """Both rows of the picture: the title of each step, the matrix so far, and the last turn.

    The matrix of what comes later stands to the left.
    """
    a, b = matrices(alpha, beta, gamma)
    start, of_a, of_b = ("at first", np.eye(3), None), (0, alpha), (1, beta)
    first_a, first_b = (f"first ${n}$: {degrees(by)}" for n, by in (("A", alpha), ("B", beta)))
    return [
        [start, (first_b, b, of_b), ("then $A$: $AB$", a @ b, of_a)],
        [start, (first_a, a, of_a), ("then $B$: $BA$", b @ a, of_b)],
    ]


def _draw(**values: float) -> Canvas:
    drawn = canvas(look.COLUMN, 2.55)
    steps = [step for row in orders(**values) for step in row]
    for (words, turn, last), axes in zip(steps, drawn.subplots(2, 3).flat, strict=True):
        draw_turned(axes, turn, values["gamma"], last)
        axes.set_title(words)
        pen.paper(axes, (-0.98, 1.2), (-0.92, 0.92))
    return drawn


def _facts(**angles: float) -> dict[str, Any]:
    facts = answers(rotations_form_a_group, **angles)
    axis = ", ".join(said(round(facts[f"axis_{letter}"], 3) + 0.0) for letter in "xyz")
    apart = "From where one ends to where the other ends it is a turn by {commutator:°}."
    ends = "The two ends differ by a turn of {commutator:°} degrees."
    if facts["commutator"] < SAME:
        apart, ends = "Both end alike.", "Both rows end alike."
    return {**facts, "axis": axis, "apart": apart, "ends": ends}


ORDER_OF_ROTATIONS = Drawing(
    "order-of-rotations",
    "Two turns of a book: $AB$ is not $BA$",
    "",
    rotations_form_a_group.parameters,
    _draw,
    r"A book turned by $A$, $2\alpha_1 = {alpha:°}$ about $\mathbf n_1$, and by $B$, "
    r"$2\alpha_2 = {beta:°}$ about $\mathbf n_2$, axes at $\gamma = {gamma:°}$ that stay where "
    "they are. The cover bears an F, the darker back a bar. Above $B$ comes first, below $A$; the "
    "matrix of what comes later stands to the left. $AB$ is one turn, by {angle:°} about the axis "
    r"({axis}), $\mathbf n_1$ being along $\hat{\mathbf x}$ and $\mathbf n_2$ in the plane of "
    r"$\hat{\mathbf x}$ and $\hat{\mathbf y}$. {apart}",
    "Two rows of three drawings of a book with an F on its cover. In the upper row it is turned "
    "first by B, {beta:°} degrees about n2, then by A, {alpha:°} degrees about n1, and ends at A "
    "B; in the lower row first by A, then by B, and ends at B A. Between the axes are {gamma:°} "
    "degrees. {ends}",
    _facts,
)
