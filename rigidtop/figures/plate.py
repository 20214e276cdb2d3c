"""Feynman's plate, thrown up spinning and wobbling."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas
from scipy.spatial.transform import Rotation

from rigidtop.derivations.exercises.precession_of_rotation_axis import (
    plate,
    plate_rates,
    wobbling_plate,
)
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing, one
from rigidtop.figures.rotors import solid_disc
from rigidtop.figures.solved import answers
from rigidtop.figures.space import UPRIGHT, Scene, View, paper
from rigidtop.figures.style import Floats, degrees, name_at, said, spoken
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
    styles = ((look.SECOND, "-", "_wobble"), (look.FIRST, look.DASHED, "_mark"))
    words = ((f"{look.E3} about {look.L_VEC}", (-7, 5), "right"), ("mark", (3, -11), "left"))
    for turns, (color, style, label), (name, aside, side) in zip(
        turned(path), styles, words, strict=True
    ):
        axes.plot(path.t, turns, color=color, ls=style, label=label)
        axes.plot(path.t[pictures], turns[pictures], "o", color=color, ms=4, label=f"{label}_dots")
        k = int(0.64 * len(turns))
        name_at(axes, float(path.t[k]), float(turns[k]), name, aside, ha=side, color=color)
    axes.locator_params(axis="x", nbins=6)
    axes.set(xlabel="$t$  (s)", ylabel="turns")


def draw_plate(
    axes: Axes, attitude: Rotation, radius: float, thickness: float, *, named: bool = False
) -> None:
    """The plate at one moment, to scale, with the mark, e₃, and the direction of L, upright."""
    scene, (e1, _, e3) = Scene(axes, VIEW), attitude.as_matrix().T
    size = math.hypot(radius, thickness / 2)
    half, height = radius / size, thickness / size
    solid_disc(scene, np.zeros(3), e3, half, height, zorder=2)
    above = 3.0 if float(e3 @ VIEW.axes[2]) > 0 else 1.0
    # Both lines begin where they leave the upper face.
    face, vertical = 0.5 * height * e3, 0.5 * height / float(e3[2]) * UPRIGHT
    mark = face + half * e1
    scene.line([face, mark], color=look.FIRST, lw=1.1, zorder=above)
    style: dict[str, Any] = {"color": look.FIRST, "ms": 4.2, "clip_on": False, "label": "_mark"}
    scene.dot(mark, zorder=above + 0.1, **style)
    scene.line(
        [vertical, REACH * UPRIGHT], color=look.MOMENTUM, lw=0.9, ls=look.DASHED, zorder=above
    )
    tip = min(REACH, 0.98 / max(math.hypot(e3[0], e3[1]), 1e-9)) * e3
    scene.arrow(tip, start=face, color=look.AXIS, lw=1.3, zorder=above + 0.2)
    if named:
        scene.words(tip, look.E3, (1, 3), color=look.AXIS)
        scene.words(REACH * UPRIGHT, look.L_VEC, (-2, 3), color=look.MOMENTUM, ha="right")


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
        paper(place, (-1.1, 1.1), (-1.1, 2.6))
    return drawn


def _caption(theta: float, radius: float, thickness: float, omega3: float) -> str:
    found = answers(wobbling_plate, theta=theta, radius=radius, thickness=thickness, omega3=omega3)
    return (
        f"A plate of radius {said(radius)} m and thickness {said(thickness)} m that is thrown up "
        f"with $ω₃ = {said(omega3)}$ rad/s and its axis $e₃$ tilted by $θ = {degrees(theta)}$ from "
        f"$𝐋$, at {PICTURES} moments, every half of a wobble, and the turns of $e₃$ and of a mark "
        f"on its rim about $𝐋$. The wobble, at {said(found['wobble'])} rad/s, is "
        f"{said(found['wobble_to_mark'])} times as fast as the mark, at {said(found['mark'])} "
        "rad/s on the mean; of a flat plate, tilted little, it is twice as fast. Feynman "
        "remembered the two exchanged."
    )


def _in_words(theta: float, radius: float, thickness: float, omega3: float) -> str:
    marks = float(turned(_path(thrown(theta, radius, thickness, omega3)))[1][-1])
    return (
        f"A plate seen from the side, {PICTURES} times: its axis leans to the right and to the "
        f"left in turn, {spoken(math.degrees(theta))} degrees from the upright L, while a mark on "
        "its rim begins in front and goes round anticlockwise as seen from above. Below, turns "
        f"against time: while e3 goes round L {WOBBLES} times, in a straight line, those of "
        f"the mark come to {spoken(marks)}."
    )


WOBBLING_PLATE = Drawing(
    "wobbling-plate",
    "Feynman's plate: how often it wobbles while a mark goes round",
    "",
    wobbling_plate.parameters,
    _draw,
    _caption,
    _in_words,
    motions=one(thrown),
)
