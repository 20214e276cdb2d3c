"""Feynman's plate, thrown up spinning and wobbling."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from scipy.spatial.transform import Rotation

from rigidtop.derivations.exercises.precession_of_rotation_axis import (
    plate,
    plate_rates,
    wobbling_plate,
)
from rigidtop.figures import picture as pen
from rigidtop.figures import solids
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing, one
from rigidtop.figures.solved import answers
from rigidtop.figures.space import UPRIGHT, View
from rigidtop.figures.style import Canvas, Floats
from rigidtop.motion.attitude import from_euler_angles
from rigidtop.motion.motion import Motion
from rigidtop.motion.trajectory import Trajectory

VIEW = View(azimuth=0.0, elevation=0.26)

WOBBLES = 2
PICTURES = 2 * WOBBLES + 1
"""One for every half of a wobble, when the plate leans to the right or to the left."""

REACH = 2.1
"""How far L and e₃ are drawn, where the rim is at the distance 1; e₃ not beyond its picture."""


def thrown(theta: float, radius: float, thickness: float, omega3: float) -> Motion:
    """A plate with L upright; at first it leans to the right, and the mark, on e₁, is in front."""
    body = plate(radius, thickness)
    wobble, _ = plate_rates(body, theta, omega3)
    attitude = from_euler_angles(theta, math.pi / 2, -math.pi / 2)
    # ω is the wobble about L, which is upright, and ψ̇ about e₃.
    across = attitude.inv().apply(wobble * UPRIGHT)
    made: Motion = body.motion(
        omega=(float(across[0]), float(across[1]), omega3), attitude=attitude
    )
    return made


def turned(path: Trajectory) -> tuple[Floats, Floats]:
    """How many times e₃, and the mark on e₁, have gone round L, which is upright, since row 0."""
    attitudes = path.rotation.as_matrix()
    found = []
    for k in (2, 0):
        angle = np.unwrap(np.arctan2(attitudes[:, 1, k], attitudes[:, 0, k]))
        found.append((angle - angle[0]) / (2 * math.pi))
    return found[0], found[1]


def draw_turns(axes: Axes, path: Trajectory) -> None:
    """Turns of e₃ and of the mark against time (s); dots where `draw_plate` shows the plate."""
    pictures = slice(None, None, (len(path.t) - 1) // (PICTURES - 1))
    k = int(0.64 * len(path.t))
    wobble, mark = turned(path)
    wobbles = f"{look.E3} about {look.L_VEC}"
    parts = [
        pen.Curve((path.t, wobble), look.SECOND, 1.3, label="_wobble"),
        pen.Curve((path.t, mark), look.FIRST, 1.3, look.DASHED, label="_mark"),
        pen.Mark((path.t[pictures], wobble[pictures]), look.SECOND, 4, label="_wobble_dots"),
        pen.Mark((path.t[pictures], mark[pictures]), look.FIRST, 4, label="_mark_dots"),
        pen.Words((path.t[k], wobble[k]), wobbles, (-7, 5), look.SECOND, "right"),
        pen.Words((path.t[k], mark[k]), "mark", (3, -11), look.FIRST),
    ]
    pen.chart(axes, parts, "$t$  (s)", "turns")
    axes.locator_params(axis="x", nbins=6)


def draw_plate(
    axes: Axes, attitude: Rotation, radius: float, thickness: float, *, named: bool = False
) -> None:
    """The plate at one moment, to scale, with the mark, e₃, and the direction of L, upright."""
    e1, _, e3 = attitude.as_matrix().T
    size = math.hypot(radius, thickness / 2)
    half, height = radius / size, thickness / size
    above = 3.0 if float(e3 @ VIEW.axes[2]) > 0 else 1.0
    # Both lines begin where they leave the upper face.
    face, vertical = 0.5 * height * e3, 0.5 * height / float(e3[2]) * UPRIGHT
    mark, top = face + half * e1, REACH * UPRIGHT
    tip = min(REACH, 0.98 / max(math.hypot(e3[0], e3[1]), 1e-9)) * e3
    parts: list[pen.Part] = [
        *solids.disc(0.0 * e3, e3, half, height),
        pen.Curve([face, mark], look.FIRST, 1.1, z=above),
        pen.Mark(mark, look.FIRST, 4.2, z=above + 0.1, label="_mark"),
        pen.Curve([vertical, top], look.MOMENTUM, 0.9, look.DASHED, above),
        pen.Arrow(tip, "", look.AXIS, 1.3, start=face, z=above + 0.2),
    ]
    if named:
        parts.append(pen.Words(tip, look.E3, (1, 3), look.AXIS))
        parts.append(pen.Words(top, look.L_VEC, (-2, 3), look.MOMENTUM, "right"))
    pen.picture(axes, parts, (-1.1, 1.1), (-1.1, 2.6), VIEW)


# --- Together ------------------------------------------------------------------------------------


def _path(motion: Motion) -> Trajectory:
    """Two wobbles, with the moments of the pictures among its rows."""
    last = WOBBLES * 2 * math.pi / motion.mean_precession
    return motion.exact(np.linspace(0.0, last, 200 * (PICTURES - 1) + 1))


def _draw(theta: float, radius: float, thickness: float, omega3: float) -> Canvas:
    drawn = Canvas(figsize=(look.COLUMN, 3.0))
    path = _path(thrown(theta, radius, thickness, omega3))
    left, width = 0.13, 0.84
    chart = drawn.add_axes((left, 0.15, width, 0.43))
    draw_turns(chart, path)
    # Room for half a picture on either side, so that each is above its dots.
    margin = 0.5 * path.t[-1] / (PICTURES - 1)
    chart.set_xlim(-margin, path.t[-1] + margin)
    for k, attitude in enumerate(path.rotation[:: (len(path.t) - 1) // (PICTURES - 1)]):
        place = drawn.add_axes((left + k * width / PICTURES, 0.61, width / PICTURES, 0.39))
        draw_plate(place, attitude, radius, thickness, named=k == 0)
    return drawn


def _facts(**values: float) -> dict[str, Any]:
    marks = float(turned(_path(thrown(**values)))[1][-1])
    facts = {"pictures": PICTURES, "wobbles": WOBBLES, "marks": marks}
    return facts | answers(wobbling_plate, **values)


WOBBLING_PLATE = Drawing(
    "wobbling-plate",
    "Feynman's plate: how often it wobbles while a mark goes round",
    "",
    wobbling_plate.parameters,
    _draw,
    "A plate of radius {radius} m and thickness {thickness} m that is thrown up with "
    r"$\omega_3 = {omega3}$ rad/s and its axis $\mathbf e_3$ tilted by $\theta = {theta:°}$ from "
    r"$\mathbf L$, at {pictures} moments, every half of a wobble, and the turns of $\mathbf e_3$ "
    r"and of a mark on its rim about $\mathbf L$. The wobble, at {wobble} rad/s, is "
    "{wobble_to_mark} times as fast as the mark, at {mark} rad/s on the mean; of a flat plate, "
    "tilted little, it is twice as fast. Feynman remembered the two exchanged.",
    "A plate seen from the side, {pictures} times: its axis leans to the right and to the left in "
    "turn, {theta:°} degrees from the upright L, while a mark on its rim begins in front and goes "
    "round anticlockwise as seen from above. Below, turns against time: while e3 goes round L "
    "{wobbles} times, in a straight line, those of the mark come to {marks}.",
    _facts,
    motions=one(thrown),
)
