"""Wobbles of flat bodies: a plate that is thrown up, and the Earth."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from scipy.spatial.transform import Rotation

from rigidtop.derivations.exercises import precession_of_rotation_axis as exercise
from rigidtop.figures import picture as pen
from rigidtop.figures import solids
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing, one
from rigidtop.figures.solved import answers
from rigidtop.figures.space import UPRIGHT, View
from rigidtop.figures.style import Canvas, Floats, in_math
from rigidtop.motion.attitude import from_euler_angles
from rigidtop.motion.body import FreeBody
from rigidtop.motion.motion import Motion
from rigidtop.motion.trajectory import Trajectory

# --- Feynman's plate, thrown up spinning and wobbling --------------------------------------------

VIEW = View(azimuth=0.0, elevation=0.26)

WOBBLES = 2
PICTURES = 2 * WOBBLES + 1
"""One for every half of a wobble, when the plate leans to the right or to the left."""

REACH = 2.1
"""How far L and e₃ are drawn, where the rim is at the distance 1; e₃ not beyond its picture."""


def thrown(theta: float, radius: float, thickness: float, omega3: float) -> Motion:
    """A plate with L upright; at first it leans to the right, and the mark, on e₁, is in front."""
    body = exercise.plate(radius, thickness)
    wobble, _ = exercise.plate_rates(body, theta, omega3)
    attitude = from_euler_angles(theta, math.pi / 2, -math.pi / 2)
    # ω is the wobble about L, which is upright, and ψ̇ about e₃.
    across = attitude.inv().apply(wobble * UPRIGHT)
    omega = float(across[0]), float(across[1]), omega3
    motion: Motion = body.motion(omega=omega, attitude=attitude)
    return motion


def turned(path: Trajectory) -> tuple[Floats, Floats]:
    """How many times e₃, and the mark on e₁, have gone round L, which is upright, since row 0."""
    x, y, _ = np.moveaxis(path.rotation.as_matrix(), 0, -1)
    angles = np.unwrap(np.arctan2(y, x))
    mark, _, wobble = (angles - angles[:, :1]) / (2 * math.pi)
    return wobble, mark


def draw_turns(axes: Axes, path: Trajectory) -> None:
    """Turns of e₃ and of the mark against time (s); dots where `draw_plate` shows the plate."""
    pictures = slice(None, None, (len(path.t) - 1) // (PICTURES - 1))
    k = int(0.64 * len(path.t))
    wobble, mark = turned(path)
    wobbles = f"{look.E3} about {look.L_VEC}"
    parts = [
        pen.Curve((path.t, wobble), look.SECOND, 1.3, label="_wobble"),
        pen.Curve((path.t, mark), look.FIRST, 1.3, look.DASHED, label="_mark"),
        pen.Markers((path.t[pictures], wobble[pictures]), look.SECOND, 4, label="_wobble_dots"),
        pen.Markers((path.t[pictures], mark[pictures]), look.FIRST, 4, label="_mark_dots"),
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
        pen.Markers(mark, look.FIRST, 4.2, z=above + 0.1, label="_mark"),
        pen.Curve([vertical, top], look.MOMENTUM, 0.9, look.DASHED, above),
        pen.Arrow(tip, "", look.AXIS, 1.3, start=face, z=above + 0.2),
    ]
    if named:
        parts.append(pen.Words(tip, look.E3, (1, 3), look.AXIS))
        parts.append(pen.Words(top, look.L_VEC, (-2, 3), look.MOMENTUM, "right"))
    pen.picture(axes, parts, (-1.1, 1.1), (-1.1, 2.6), VIEW)


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


def _facts_plate(**values: float) -> dict[str, Any]:
    marks = float(turned(_path(thrown(**values)))[1][-1])
    facts = {"pictures": PICTURES, "wobbles": WOBBLES, "marks": marks}
    return facts | answers(exercise.wobbling_plate, **values)


WOBBLING_PLATE = Drawing(
    "wobbling-plate",
    "Feynman's plate: how often it wobbles while a mark goes round",
    "",
    exercise.wobbling_plate.parameters,
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
    _facts_plate,
    motions=one(thrown),
)

# --- The way of the Earth's pole of rotation around the pole of its figure -----------------------

MARKS = 9
"""At most, on the way once around."""


def wobble(H: float, angle: float, share: float = 0.0) -> Motion:
    """The free motion of the Earth, with C = 1 and ω₃ = 1, from ω at `angle` (rad) to e₃.

    Where the `share` k of the bulge follows ω, L is that of a rigid body with the moments
    λ₁ + k(λ₃ − λ₁) and λ₃, and so ω in the body is that of one too.
    """
    across = 1 - (1 - share) * H
    return FreeBody(across, across, 1.0).motion(omega=(math.tan(angle), 0.0, 1.0))


def way_of_the_pole(motion: Motion, radius: float, turned: Floats) -> Floats:
    """Where ω meets the ground (N, 2), in metres from e₃ along e₁ and e₂, after angles (rad) by
    which the Earth has `turned`."""
    omega = motion.exact(turned).omega
    return radius * omega[:, :2] / omega[:, 2:]


def marked_days(period: float) -> Floats:
    """Round numbers of days on the way once around, from 0 on; none too near to its end."""
    size = 10.0 ** math.floor(math.log10(period))
    steps = [share * size for share in (0.2, 0.5, 1.0, 2.0) if period / (share * size) <= MARKS]
    return np.arange(0.0, period - 0.45 * steps[0], steps[0])


def draw_polar_motion(axes: Axes, **values: float) -> None:
    """The circle of the pole of rotation seen from above the pole, in metres.

    Outside are the days of a rigid Earth, inside those of one whose bulge follows so far that the
    period is the `observed` one.
    """
    found = answers(exercise.earth_euler_period, **values)
    names = (p.name for p in exercise.earth_euler_period.parameters)
    H, omega3, observed, angle, radius = (values[name] for name in names)
    rigid, yielding = wobble(H, angle), wobble(H, angle, max(found["share"], 0.0))
    once = np.linspace(0.0, found["period"], 361)
    way = way_of_the_pole(rigid, radius, once * exercise.DAY * omega3)
    size, small = found["ground"], look.SMALL
    metres = f"${in_math(size)}$ m"
    parts: list[pen.Part] = [
        pen.Curve(way, look.OMEGA, 1.3, label="_way"),
        # Heads where there are no days of either.
        *(pen.Curve(way[k : k + 9], look.OMEGA, head=True) for k in (12, 192)),
        pen.Curve(([0.0, size], 0.0), look.GREY, 0.9, look.DASHED),
        pen.Markers((0.0, 0.0), look.AXIS, 4, z=5),
        pen.Markers(way[0], look.OMEGA, 6.5, z=6),
        pen.Words((0.0, 0.0), look.E3, (-6, 0), look.AXIS, "right", "center", 10),
        pen.Words((size, 0.0), look.OMEGA_VEC, (7, -3), look.OMEGA, size=10),
        pen.Words((0.5 * size, 0.0), metres, (0, 3), look.NOTE, "center", size=small),
    ]
    dot: dict[str, Any] = {"z": 5.0}
    ring: dict[str, Any] = {"size": 5.5, "fill": "white", "z": 4.5}
    for motion, period, outwards, words, color, height, mark in (
        (rigid, found["period"], 12, "outside: rigid", look.INK, 0.32, dot),
        (yielding, observed, -12, "inside: observed", look.SECOND, -0.38, ring),
    ):
        days = marked_days(period)
        poles = way_of_the_pole(motion, radius, days * exercise.DAY * omega3)
        label = "_rigid" if outwards > 0 else "_yielding"
        parts.append(pen.Markers(poles, color, label=label, **mark))
        for pole, day in zip(poles[1:], days[1:], strict=True):
            right, up = outwards * pole / size
            number = f"${in_math(float(day), 4)}$"
            parts.append(pen.Words(pole, number, (right, up), color, "center", "center", small))
        text = f"{words},\n${in_math(period)}$ days"
        parts.append(pen.Words((0.0, height * size), text, (0, 0), color, "center", "center"))
    pen.picture(axes, parts, (-1.3 * size, 1.3 * size), (-1.2 * size, 1.2 * size))


def _facts_polar_motion(angle: float, radius: float, **others: float) -> dict[str, Any]:
    facts = answers(exercise.earth_euler_period, angle=angle, radius=radius, **others)
    nearer = radius * (math.tan(angle) - math.tan(angle - facts["space_cone"]))
    return facts | {"seconds": math.degrees(angle) * 3600, "nearer": nearer}


POLAR_MOTION = Drawing(
    "polar-motion",
    "The wobble of the Earth: rigid, and as it is observed",
    "",
    exercise.earth_euler_period.parameters,
    pen.alone(3.05, draw_polar_motion),
    r"The pole of rotation, where $\boldsymbol\omega$ meets the ground, goes round the pole of the "
    r"figure, $\mathbf e_3$: {direction}; seen from above. With $H = {H}$ and "
    r"$\omega_3 = {omega3}$ rad/s a rigid Earth needs {period} days (dots, days outside). Observed "
    "are {observed:4} (circles, days inside), as if {share:%} % of the bulge followed "
    r"$\boldsymbol\omega$. At ${seconds}''$ from $\mathbf e_3$ and {radius} m from the centre the "
    r"circle has a radius of {ground} m; for a rigid Earth $\mathbf L$ is {nearer} m nearer to "
    r"$\mathbf e_3$ than $\boldsymbol\omega$.",
    "A circle of radius {ground} metres around the point e3, which the tip of omega goes round "
    "counterclockwise, seen from above. Dots with the days of a rigid Earth, which is back after "
    "{period}, and open circles with those of the observed wobble, which is back after {observed}.",
    _facts_polar_motion,
)
