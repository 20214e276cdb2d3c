"""Euler's angles: three rotations from x̂ŷẑ to e₁e₂e₃ (section 3.3)."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas
from scipy.spatial.transform import Rotation

from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.space import Scene, View, paper
from rigidtop.figures.style import Floats, canvas, degrees, spoken
from rigidtop.parameters import Parameter

VIEW = View(azimuth=0.36, elevation=0.4)
TURNED_ABOUT = "#8fd3e3"
ANGLE = "#3f7d2a"
NODES = {"zyz": 1, "zxz": 0}
"""Which axis of the first turn is the line of nodes, about which the second goes."""

E1, E2, E3 = (rf"$\mathbf{{e}}_{k}$" for k in (1, 2, 3))
NODE = r"$\mathbf{e}_2'$"
NAMES = {
    "zyz": ((r"$\mathbf{h}$", NODE, ""), (r"$\mathbf{e}_1'$", NODE, E3), (E1, E2, E3)),
    "zxz": ((NODE, r"$-\mathbf{h}$", ""), (NODE, r"$-\mathbf{e}_1'$", E3), (E1, E2, E3)),
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
    scene = Scene(axes, VIEW)
    axis, angle, shown, symbol = turned
    stripe = np.array([-0.18 * axis, 0.98 * axis])
    scene.line(stripe, color=TURNED_ABOUT, lw=5, solid_capstyle="round", zorder=1)
    for k, words in enumerate(look.SPACE):
        scene.arrow(1.34 * np.eye(3)[k], words, color=look.FIRST, lw=0.8, zorder=2)
    old, new = before.as_matrix().T, after.as_matrix().T
    for k in range(3):
        if np.linalg.norm(old[k] - new[k]) > 1e-9:
            ends = np.array([np.zeros(3), old[k]])
            scene.line(ends, color=look.AXIS, lw=1.2, ls=look.HIDDEN, zorder=3)
        scene.arrow(new[k], names[k], color=look.AXIS, lw=1.6, zorder=4)
    # The way of one axis, at a part of its length, with a head where it ends.
    way = Rotation.from_rotvec(np.linspace(0, angle, 61)[:, None] * axis).apply(0.62 * old[shown])
    scene.line(way, color=ANGLE, lw=1.4, zorder=4)
    if abs(angle) > 0.1:
        scene.head(way[[-6, -1]], width=0.16, length=0.3, color=ANGLE, lw=0.8, zorder=4.5)
    x, y, _ = VIEW(way[[0, 30, 60]])
    narrow = math.hypot(x[2] - x[0], y[2] - y[0]) < NARROW
    at, away = (0, (x[0] - x[2], y[0] - y[2])) if narrow else (30, (x[1], y[1]))
    shift = 9 / (math.hypot(*away) or 1.0) * np.array(away)
    style = {"ha": "center", "va": "center", "fontsize": 11}
    scene.words(way[at], symbol, (float(shift[0]), float(shift[1])), color=ANGLE, **style)


def turns(sequence: str, *angles: float) -> list[tuple[Floats, float, int, str]]:
    """About which axis each step turns, by how much, and which axis shows it: ẑ, the nodes, e₃."""
    after = steps(sequence, *angles)
    about = (2, NODES[sequence], 2)
    names = (r"$\phi$", r"$\theta$", r"$\psi$")
    return [
        (after[k].as_matrix()[:, axis], angle, 2 if k == 1 else 0, name)
        for k, (axis, angle, name) in enumerate(zip(about, angles, names, strict=True))
    ]


def _draw(sequence: str, *angles: float) -> Canvas:
    drawn = canvas(look.TEXT, 2.5)
    attitudes, about = steps(sequence, *angles), (look.Z, NODE, E3)
    all_turned = zip(drawn.subplots(1, 3), turns(sequence, *angles), strict=True)
    for i, (axes, turned) in enumerate(all_turned):
        draw_rotation(axes, attitudes[i], attitudes[i + 1], turned, NAMES[sequence][i])
        axes.set_title(f"({'i' * (i + 1)})  {turned[3]} about {about[i]}", color=look.INK)
        paper(axes, (-1.1, 1.42), (-1.05, 1.5))
    return drawn


def _caption(_: str, *angles: float) -> str:
    phi, theta, psi = map(degrees, angles)
    return (
        f"Euler's angles $φ$, $θ$ and $ψ$, here {phi}, {theta} and {psi}: three rotations, "
        "each about the axis on the broad stripe, from $x̂ŷẑ$ (thin) to $e₁e₂e₃$. The "
        "axes that move are dashed before and solid after the step."
    )


def _in_words(sequence: str, *angles: float) -> str:
    by = [spoken(math.degrees(angle)) for angle in angles]
    nodes = f"e{NODES[sequence] + 1} prime"
    return (
        "Three drawings of a space-fixed frame x, y, z and of a body frame that is turned, first "
        f"by phi, {by[0]} degrees, about z, which gives {nodes}; then by theta, {by[1]} degrees, "
        f"about {nodes}, which brings e3 where it stays; last by psi, {by[2]} degrees, about e3, "
        "which brings e1 and e2 to their final places."
    )


def euler_angles(sequence: str) -> Drawing:
    """The three turns of a sequence, "zyz" as in the notes or "zxz", in the notes' letters.

    Its parameters are the angles of the notes: those of z–x′–z″ are φ + π/2, θ and ψ − π/2.
    """
    quarter = math.pi / 2 if sequence == "zxz" else 0.0

    def counted(of: Callable[..., Any]) -> Callable[..., Any]:
        return lambda phi, theta, psi: of(sequence, phi + quarter, theta, psi - quarter)

    def angle(name: str, degrees: float, about: str, shift: float) -> Parameter:
        value = math.radians(degrees) + shift
        return Parameter(name, value, about, "rad", least=-2 * math.pi, most=2 * math.pi)

    return Drawing(
        "euler-angles",
        "Euler's angles: $φ$ about $ẑ$, $θ$ about $e₂′$, $ψ$ about $e₃$",
        "3.3",
        (
            angle("phi", 60, "first, about $ẑ$", -quarter),
            replace(angle("theta", 45, "second, about $e₂′$", 0.0), least=0, most=math.pi),
            angle("psi", 45, "third, about $e₃$", quarter),
        ),
        counted(_draw),
        counted(_caption),
        counted(_in_words),
        turned=euler_angles,
    )


EULER_ANGLES = euler_angles("zyz")
