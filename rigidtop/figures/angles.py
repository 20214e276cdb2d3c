"""Euler's angles: three rotations from x̂ŷẑ to e₁e₂e₃ (section 3.3)."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas
from scipy.spatial.transform import Rotation

from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.space import Scene, View, paper
from rigidtop.figures.style import Floats, canvas, degrees, spoken
from rigidtop.motion.attitude import from_euler_angles
from rigidtop.parameters import Parameter

VIEW = View(azimuth=0.36, elevation=0.4)
TURNED_ABOUT = "#8fd3e3"
ANGLE = "#3f7d2a"
NAMES = (
    ("", r"$\mathbf{e}_2'$", ""),
    (r"$\mathbf{e}_1'$", r"$\mathbf{e}_2'$", r"$\mathbf{e}_3$"),
    (r"$\mathbf{e}_1$", r"$\mathbf{e}_2$", r"$\mathbf{e}_3$"),
)
"""Of the axes after each step."""


def steps(phi: float, theta: float, psi: float) -> list[Rotation]:
    """The attitude before the first rotation and after each of the three."""
    return [
        Rotation.identity(),
        from_euler_angles(0.0, phi, 0.0),
        from_euler_angles(theta, phi, 0.0),
        from_euler_angles(theta, phi, psi),
    ]


def draw_rotation(
    axes: Axes,
    before: Rotation,
    after: Rotation,
    turned: tuple[Floats, float, int, str],
    names: tuple[str, str, str],
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
    scene.words(1.24 * way[30], symbol, color=ANGLE, ha="center", va="center", fontsize=11)


def turns(phi: float, theta: float, psi: float) -> list[tuple[Floats, float, int, str]]:
    """About which axis each step turns, by how much, and which axis shows it: ẑ, e₂′, e₃."""
    after = steps(phi, theta, psi)
    return [
        (np.array([0.0, 0.0, 1.0]), phi, 0, r"$\phi$"),
        (after[1].as_matrix()[:, 1], theta, 2, r"$\theta$"),
        (after[2].as_matrix()[:, 2], psi, 0, r"$\psi$"),
    ]


def _draw(phi: float, theta: float, psi: float) -> Canvas:
    drawn = canvas(look.WIDE, 2.65)
    attitudes = steps(phi, theta, psi)
    words = (
        r"$\phi$ about $\hat{\mathbf{z}}$",
        r"$\theta$ about $\mathbf{e}_2'$",
        r"$\psi$ about $\mathbf{e}_3$",
    )
    for i, (axes, turned) in enumerate(
        zip(drawn.subplots(1, 3), turns(phi, theta, psi), strict=True)
    ):
        draw_rotation(axes, attitudes[i], attitudes[i + 1], turned, NAMES[i])
        axes.set_title(f"({'i' * (i + 1)})  {words[i]}", color=look.INK)
        paper(axes, (-1.42, 1.42), (-1.05, 1.5))
    return drawn


def _caption(phi: float, theta: float, psi: float) -> str:
    return (
        f"Euler's angles, here $φ = {degrees(phi)}$, $θ = {degrees(theta)}$ and $ψ = "
        f"{degrees(psi)}$: three rotations, each about the axis on the broad stripe, from $x̂ŷẑ$ "
        "(thin) to $e₁e₂e₃$. The axes that move are dashed before and solid after the step."
    )


def _in_words(phi: float, theta: float, psi: float) -> str:
    by = [spoken(math.degrees(angle)) for angle in (phi, theta, psi)]
    return (
        "Three drawings of a space-fixed frame x, y, z and of a body frame that is turned, first "
        f"by phi, {by[0]} degrees, about z, which gives e2 prime; then by theta, {by[1]} degrees, "
        f"about e2 prime, which brings e3 where it stays; last by psi, {by[2]} degrees, about e3, "
        "which brings e1 and e2 to their final places."
    )


FULL = 2 * math.pi

EULER_ANGLES = Drawing(
    "euler-angles",
    "Euler's angles: $φ$ about $ẑ$, $θ$ about $e₂′$, $ψ$ about $e₃$",
    "3.3",
    (
        Parameter("phi", math.radians(60), "first, about $ẑ$", "rad", least=-FULL, most=FULL),
        Parameter("theta", math.radians(45), "second, about $e₂′$", "rad", least=0, most=math.pi),
        Parameter("psi", math.radians(45), "third, about $e₃$", "rad", least=-FULL, most=FULL),
    ),
    _draw,
    _caption,
    _in_words,
)
