"""Euler's angles: three rotations from x̂ŷẑ to e₁e₂e₃ (section 3.3)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from scipy.spatial.transform import Rotation

from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.space import View
from rigidtop.figures.style import Canvas, Floats, canvas
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
    axis, angle, shown, symbol = turned
    old, new = before.as_matrix().T, after.as_matrix().T
    # The way of one axis, at a part of its length, with a head where it ends.
    way = Rotation.from_rotvec(np.linspace(0, angle, 61)[:, None] * axis).apply(0.62 * old[shown])
    x, y, _ = VIEW(way[[0, 30, 60]])
    narrow = math.hypot(x[2] - x[0], y[2] - y[0]) < NARROW
    at, away = (0, (x[0] - x[2], y[0] - y[2])) if narrow else (30, (x[1], y[1]))
    right, up = 9 / (math.hypot(*away) or 1.0) * np.array(away)
    moved = [each for each, there in zip(old, new, strict=True) if not np.allclose(each, there)]
    parts = [
        pen.Curve([-0.18 * axis, 0.98 * axis], TURNED_ABOUT, 5, z=1, cap="round"),
        *pen.axes_of_space(1.34, color=look.FIRST, lw=0.8, z=2),
        *(pen.Curve([pen.ORIGIN, each], look.AXIS, ls=look.HIDDEN, z=3) for each in moved),
        *(pen.Arrow(tip, name, look.AXIS, 1.6, z=4) for tip, name in zip(new, names, strict=True)),
        pen.Curve(way, ANGLE, 1.4, z=4, head=abs(angle) > 0.1),
        pen.Words(way[at], symbol, (right, up), ANGLE, "center", "center", 11),
    ]
    pen.picture(axes, parts, (-1.1, 1.42), (-1.05, 1.5), VIEW)


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
    return drawn


def euler_angles(sequence: str) -> Drawing:
    """The three turns of a sequence, "zyz" as in the notes or "zxz", in the notes' letters.

    Its parameters are the angles of that sequence.
    """

    def words(**_: float) -> dict[str, Any]:
        return {"nodes": f"e{NODES[sequence] + 1} prime"}

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
        lambda phi, theta, psi: _draw(sequence, phi, theta, psi),
        r"Euler's angles $\phi$, $\theta$ and $\psi$, here {phi:°}, {theta:°} and {psi:°}: three "
        "rotations, each about the axis on the broad stripe, from "
        r"$\hat{\mathbf x}\hat{\mathbf y}\hat{\mathbf z}$ (thin) to "
        r"$\mathbf e_1\mathbf e_2\mathbf e_3$. The axes that move are dashed before and solid "
        "after the step.",
        "Three drawings of a space-fixed frame x, y, z and of a body frame that is turned, first "
        "by phi, {phi:°} degrees, about z, which gives {nodes}; then by theta, {theta:°} "
        "degrees, about {nodes}, which brings e3 where it stays; last by psi, {psi:°} degrees, "
        "about e3, which brings e1 and e2 to their final places.",
        words,
        turned=euler_angles,
    )


EULER_ANGLES = euler_angles("zyz")
