"""Two rotations of a book, in one order and in the other (section 3.4)."""

from __future__ import annotations

import math
from typing import TypeAlias

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas
from scipy.spatial.transform import Rotation

from rigidtop.derivations.exercises.rotation_matrices import about, rotations_form_a_group
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.solved import answers
from rigidtop.figures.space import Scene, View, paper, unit
from rigidtop.figures.style import Floats, canvas, degrees, said, spoken

VIEW = View(azimuth=0.5, elevation=0.42)
HALF = np.array([0.15, 0.5, 0.66])
"""Half the thickness, the width and the height of the book, along x̂, ŷ and ẑ before the turns."""

COVER, BACK, SPINE, PAPER, EDGE = "#dbe7cf", "#9cc07f", "#55703f", "#ffffff", "#3d5230"
FACES = ((0, 1, COVER), (0, -1, BACK), (1, 1, PAPER), (1, -1, SPINE), (2, 1, PAPER), (2, -1, PAPER))
"""Axis, side and colour: the cover looks along x̂, the spine against ŷ."""

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


def corners(axis: int, side: int) -> Floats:
    """Those of one face of the book (4, 3), one after the other."""
    first, second = (k for k in range(3) if k != axis)
    found = np.zeros((4, 3))
    found[:, axis] = side * HALF[axis]
    found[:, first] = HALF[first] * np.array([-1, 1, 1, -1])
    found[:, second] = HALF[second] * np.array([-1, -1, 1, 1])
    return found


def letter() -> Floats:
    """The strokes of the F (6, 3), before the turns."""
    return np.column_stack([np.full(len(LETTER), HALF[0]), LETTER * HALF[1:]])


def strokes(axis: int, side: int) -> list[Floats]:
    """What is drawn on a face: F, bar, or the sheets of the paper, parallel to the covers."""
    if axis == 0:
        return [letter() if side > 0 else np.column_stack([[-HALF[0]] * 2, BAR * HALF[1:]])]
    ends = corners(axis, side)[[0, 3]]
    return [np.column_stack([[share * HALF[0]] * 2, ends[:, 1:]]) for share in (-0.4, 0.0, 0.4)]


def draw_book(scene: Scene, turn: Floats) -> None:
    """The book, turned by a matrix (3, 3)."""
    for axis, side, color in FACES:
        if float(scene.view(side * turn[:, axis])[2]) <= 1e-9:
            continue
        corner = corners(axis, side) @ turn.T
        scene.face(corner, fc=color, ec=EDGE, lw=0.8, zorder=3, joinstyle="round")
        for stroke in strokes(axis, side) if color != SPINE else ():
            ink, width = (look.GREY, 0.4) if color == PAPER else (EDGE, 2.2)
            name = "_letter" if color == COVER else None
            scene.line(stroke @ turn.T, color=ink, lw=width, zorder=4, label=name)


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
    scene, ends = Scene(axes, VIEW), 1.15 * axes_of_rotation(gamma)
    names = [r"$\mathbf{n}_1$", r"$\mathbf{n}_2$"]
    if gamma < CLOSE:
        names = ["", r"$\mathbf{n}_1, \mathbf{n}_2$"]
    if last is not None:
        k, angle = last
        stripe = [np.zeros(3), 0.95 * ends[k]]
        scene.line(stripe, color=TURNED_ABOUT, lw=4.5, solid_capstyle="round", zorder=1)
        # Around the end of the axis, from above it.
        start = 0.82 * ends[k] + np.array([0.0, 0.0, 0.34])
        turns = np.outer(np.linspace(0, angle, 61), unit(ends[k]))
        way = Rotation.from_rotvec(turns).apply(start)
        _draw_way(scene, way, angle, 5.5 if leaves(turn, ends[k])[1] else 2.5)
    draw_book(scene, turn)
    below = (-3.0, -10.0) if gamma < CLOSE else None
    for end, name in zip(ends, names, strict=True):
        out, seen = leaves(turn, unit(end))
        above = 5 if seen else 2
        scene.arrow(end, name, start=out, shift=below, color=look.FIRST, lw=1.0, zorder=above)


def _draw_way(scene: Scene, way: Floats, angle: float, zorder: float) -> None:
    """An arc, with a head where it ends."""
    scene.line(way, color=TURN, lw=1.2, zorder=zorder, label="_turn")
    if abs(angle) > 0.2:
        scene.head(way[[-9, -1]], width=0.14, length=0.26, color=TURN, lw=0.8, zorder=zorder)


def orders(alpha: float, beta: float, gamma: float) -> list[list[tuple[str, Floats, Turn | None]]]:
    """Both rows of the picture: the title of each step, the matrix so far, and the last turn.

    The matrix of what comes later stands to the left.
    """
    a, b = matrices(alpha, beta, gamma)
    one, of_a, of_b = np.eye(3), (0, alpha), (1, beta)
    return [
        [
            ("at first", one, None),
            (f"first $B$: {degrees(beta)}", b, of_b),
            ("then $A$: $AB$", a @ b, of_a),
        ],
        [
            ("at first", one, None),
            (f"first $A$: {degrees(alpha)}", a, of_a),
            ("then $B$: $BA$", b @ a, of_b),
        ],
    ]


def _draw(**values: float) -> Canvas:
    drawn = canvas(look.COLUMN, 2.55)
    for row, panels in zip(orders(**values), drawn.subplots(2, 3), strict=True):
        for (words, turn, last), axes in zip(row, panels, strict=True):
            draw_turned(axes, turn, values["gamma"], last)
            axes.set_title(words)
            paper(axes, (-0.98, 1.2), (-0.92, 0.92))
    return drawn


def _caption(alpha: float, beta: float, gamma: float) -> str:
    found = answers(rotations_form_a_group, alpha=alpha, beta=beta, gamma=gamma)
    axis = ", ".join(said(round(found[f"axis_{letter}"], 3) + 0.0) for letter in "xyz")
    apart = found["commutator"]
    differ = f"From where one ends to where the other ends it is a turn by {degrees(apart)}."
    if apart < SAME:
        differ = "Both end alike."
    return (
        f"A book turned by $A$, $2α₁ = {degrees(alpha)}$ about $𝐧₁$, and by $B$, $2α₂ = "
        f"{degrees(beta)}$ about $𝐧₂$, axes at $γ = {degrees(gamma)}$ that stay where they are. "
        "The cover bears an F, the darker back a bar. Above $B$ comes first, below $A$; the matrix "
        "of what comes later stands to the left. $AB$ is one turn, by "
        f"{degrees(found['angle'])} about the axis ({axis}), $𝐧₁$ being along $x̂$ and $𝐧₂$ in the "
        f"plane of $x̂$ and $ŷ$. {differ}"
    )


def _in_words(alpha: float, beta: float, gamma: float) -> str:
    found = answers(rotations_form_a_group, alpha=alpha, beta=beta, gamma=gamma)
    by = [spoken(math.degrees(angle)) for angle in (alpha, beta, gamma)]
    apart = found["commutator"]
    ends = f"The two ends differ by a turn of {spoken(math.degrees(apart))} degrees."
    if apart < SAME:
        ends = "Both rows end alike."
    return (
        "Two rows of three drawings of a book with an F on its cover. In the upper row it is "
        f"turned first by B, {by[1]} degrees about n2, then by A, {by[0]} degrees about n1, and "
        f"ends at A B; in the lower row first by A, then by B, and ends at B A. Between the axes "
        f"are {by[2]} degrees. {ends}"
    )


ORDER_OF_ROTATIONS = Drawing(
    "order-of-rotations",
    "Two turns of a book: $AB$ is not $BA$",
    "",
    rotations_form_a_group.parameters,
    _draw,
    _caption,
    _in_words,
)
