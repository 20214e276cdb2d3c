"""Rotations: Euler's angles (section 3.3), and a book that is turned twice (section 3.4)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
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
from rigidtop.figures.style import Floats, degrees, said
from rigidtop.parameters import Parameter

# --- Euler's angles ------------------------------------------------------------------------------

VIEW_ANGLES = View(azimuth=0.36, elevation=0.4)
TURNED_ABOUT = "#8fd3e3"
ANGLE = "#3f7d2a"
NODES = {"zyz": 1, "zxz": 0}
"""Which axis of the first turn is the line of nodes, about which the second goes."""

NODE = r"$\mathbf{e}_2'$"
NAMES = {
    "zyz": ((r"$\mathbf{h}$", NODE, ""), (r"$\mathbf{e}_1'$", NODE, look.E3), look.BODY),
    "zxz": ((NODE, r"$-\mathbf{h}$", ""), (NODE, r"$-\mathbf{e}_1'$", look.E3), look.BODY),
}
"""Of the axes after each step, in the letters of the notes."""

NARROW = 0.3
"""An arc that goes less far has no room for a name: it stands where the arc begins."""


def steps(sequence: str, *angles: float) -> list[Rotation]:
    """The attitude before the first rotation and after each of the three."""
    axes = sequence.upper()  # capitals: about the axes as they are turned
    return [
        Rotation.identity(),
        *(Rotation.from_euler(axes, (*angles[:k], *[0.0] * (3 - k))) for k in (1, 2, 3)),
    ]


def draw_rotation(
    axes: Axes,
    before: Rotation,
    after: Rotation,
    turned: tuple[Floats, float, int, str],
    names: Sequence[str],
) -> None:
    """One step: the axes before (dashed) and after (solid) it, among x̂ŷẑ.

    `turned` says about which unit vector of space, by how much (rad), which of the three axes
    shows the angle, and the angle's name.
    """
    axis, angle, shown, symbol = turned
    old, new = before.as_matrix().T, after.as_matrix().T
    # The way of one axis, at a part of its length, with a head where it ends.
    way = Rotation.from_rotvec(np.linspace(0, angle, 61)[:, None] * axis).apply(0.62 * old[shown])
    x, y, _ = VIEW_ANGLES(way[[0, 30, 60]])
    narrow = math.hypot(x[2] - x[0], y[2] - y[0]) < NARROW
    at, away = (0, (x[0] - x[2], y[0] - y[2])) if narrow else (30, (x[1], y[1]))
    right, up = 9 / (math.hypot(*away) or 1.0) * np.array(away)
    moved = [each for each, there in zip(old, new, strict=True) if not np.allclose(each, there)]
    parts = [
        pen.Curve([-0.18 * axis, 0.98 * axis], TURNED_ABOUT, 5, z=1, cap="round"),
        *pen.frame(np.eye(3), 1.34, look.SPACE, color=look.FIRST, lw=0.8, z=2),
        *(pen.Curve([pen.ORIGIN, each], look.AXIS, ls=look.HIDDEN, z=3) for each in moved),
        *pen.frame(new, 1.0, names, lw=1.6, z=4),
        pen.Curve(way, ANGLE, 1.4, z=4, head=abs(angle) > 0.1),
        pen.Words(way[at], symbol, (right, up), ANGLE, "center", "center", 11),
    ]
    pen.picture(axes, parts, (-1.1, 1.42), (-1.05, 1.5), VIEW_ANGLES)


def turns(sequence: str, *angles: float) -> list[tuple[Floats, float, int, str]]:
    """About which axis each step turns, by how much, and which axis shows it: ẑ, the nodes, e₃."""
    after = steps(sequence, *angles)
    about = (2, NODES[sequence], 2)
    names = (r"$\phi$", r"$\theta$", r"$\psi$")
    return [
        (after[k].as_matrix()[:, axis], angle, 2 if k == 1 else 0, name)
        for k, (axis, angle, name) in enumerate(zip(about, angles, names, strict=True))
    ]


def euler_angles(sequence: str) -> Drawing:
    """The three turns of a sequence, "zyz" as in the notes or "zxz", in the notes' letters.

    Its parameters are the angles of that sequence.
    """

    def fill(*panels: Axes, phi: float, theta: float, psi: float) -> None:
        attitudes, about = steps(sequence, phi, theta, psi), (look.Z, NODE, look.E3)
        for i, turned in enumerate(turns(sequence, phi, theta, psi)):
            names = NAMES[sequence][i]
            draw_rotation(panels[i], attitudes[i], attitudes[i + 1], turned, names)
            panels[i].set_title(f"({'i' * (i + 1)})  {turned[3]} about {about[i]}", color=look.INK)

    def angle(name: str, degrees: float, about: str) -> Parameter:
        least, most = -2 * math.pi, 2 * math.pi
        return Parameter(name, math.radians(degrees), about, "rad", least=least, most=most)

    return Drawing(
        "euler-angles",
        r"Euler's angles: $\phi$ about $\hat{\mathbf z}$, $\theta$ about $\mathbf e_2'$, $\psi$ "
        r"about $\mathbf e_3$",
        "3.3",
        (
            angle("phi", 60, r"first, about $\hat{\mathbf z}$"),
            replace(angle("theta", 45, r"second, about $\mathbf e_2'$"), least=0, most=math.pi),
            angle("psi", 45, r"third, about $\mathbf e_3$"),
        ),
        pen.panels(look.TEXT, 2.5, fill, 1, 3),
        r"Euler's angles $\phi$, $\theta$ and $\psi$, here {phi:°}, {theta:°} and {psi:°}: three "
        "rotations, each about the axis on the broad stripe, from "
        r"$\hat{\mathbf x}\hat{\mathbf y}\hat{\mathbf z}$ (thin) to "
        r"$\mathbf e_1\mathbf e_2\mathbf e_3$. The axes that move are dashed before and solid "
        "after the step.",
        "Three drawings of a space-fixed frame x, y, z and of a body frame that is turned, first "
        "by phi, {phi:°} degrees, about z, which gives {nodes}; then by theta, {theta:°} "
        "degrees, about {nodes}, which brings e3 where it stays; last by psi, {psi:°} degrees, "
        "about e3, which brings e1 and e2 to their final places.",
        lambda **_: {"nodes": f"e{NODES[sequence] + 1} prime"},
        turned=euler_angles,
    )


EULER_ANGLES = euler_angles("zyz")

# --- Two rotations of a book, in one order and in the other --------------------------------------

VIEW_ROTATION_ORDER = View(azimuth=0.5, elevation=0.42)
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
    return distances[axis] * direction, float(VIEW_ROTATION_ORDER(normal)[2]) > 0


def draw_turned(axes: Axes, turn: Floats, gamma: float, last: Turn | None = None) -> None:
    """The book, turned by a matrix, with n₁ and n₂, which stay where they are.

    `last` says about which of the two it has just been turned, 0 or 1, and by how much (rad).
    """
    ends = 1.15 * axes_of_rotation(gamma)
    names, below = (r"$\mathbf{n}_1$", r"$\mathbf{n}_2$"), None
    if gamma < CLOSE:
        names, below = ("", r"$\mathbf{n}_1, \mathbf{n}_2$"), (-3.0, -10.0)
    parts = book(turn)
    for end, name in zip(ends, names, strict=True):
        out, seen = leaves(turn, unit(end))
        parts.append(pen.Arrow(end, name, look.FIRST, 1.0, out, below, 5 if seen else 2))
    if last is not None:
        k, angle = last
        # Around the end of the axis, from above it.
        start = 0.82 * ends[k] + np.array([0.0, 0.0, 0.34])
        turns = np.outer(np.linspace(0, angle, 61), unit(ends[k]))
        way, z = Rotation.from_rotvec(turns).apply(start), 5.5 if leaves(turn, ends[k])[1] else 2.5
        parts.append(pen.Curve([pen.ORIGIN, 0.95 * ends[k]], TURNED_ABOUT, 4.5, z=1, cap="round"))
        parts.append(pen.Curve(way, ANGLE, z=z, head=abs(angle) > 0.2, label="_turn"))
    pen.draw(axes, parts, VIEW_ROTATION_ORDER)


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


def _draw_orders(*panels: Axes, **values: float) -> None:
    first, second = orders(**values)
    for axes, (words, turn, last) in zip(panels, first + second, strict=True):
        draw_turned(axes, turn, values["gamma"], last)
        axes.set_title(words)
        pen.paper(axes, (-0.98, 1.2), (-0.92, 0.92))


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
    pen.panels(look.COLUMN, 2.55, _draw_orders, 2, 3),
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
