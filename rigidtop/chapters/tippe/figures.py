"""The ball on its point of contact, and how it turns over: its tilt and its energy."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing, Film, film
from rigidtop.figures.space import View, bow, circle
from rigidtop.figures.style import Canvas, Floats
from rigidtop.motion.table.trajectory import SlidingTrajectory
from rigidtop.parameters import Parameter

from .top import USUAL, least_energy, tippe_top

# --- The contact ---------------------------------------------------------------------------------

LID = 0.65
"""Where the ball is cut off, from its axis (rad)."""


def draw_contact(axes: Axes, tilt: float) -> None:
    """The ball in the plane of its axis and the vertical; the radius is 1, the contact at 0."""
    up = math.pi / 2 - tilt
    axis = np.array([math.sin(tilt), math.cos(tilt)])
    middle, touch = np.array([0.0, 1.0]), (0.0, 0.0)
    centre = middle - 0.3 * axis
    lean = bow(1.25, math.pi / 2, up, middle)
    parts: list[pen.Part] = [
        pen.Face(bow(1.0, up + LID, up + 2 * math.pi - LID, middle), look.MANTLE, look.EDGE, 1.2),
        pen.Face(([-1.5, 1.5, 1.5, -1.5], [0, 0, -0.16, -0.16]), look.GROUND),
        pen.Arrow(0.07 * centre, r"$\mathbf{q}$", look.FIRST, 1.5, centre, (-9, 12)),
        pen.Arrow(middle + 1.45 * axis, r"$\mathbf{e}$", look.AXIS, 1.5, centre),
        pen.Arrow((0.0, 2.45), r"$\mathbf{n}$", look.INK, 1.5, middle),
        pen.Arrow((0.0, 0.62), r"$N\mathbf{n}$", look.TORQUE, 1.5, (0.0, 0.07), (12, -4)),
        *pen.angle(lean, r"$\theta$", (0, 3), look.NOTE, lw=0.8),
        pen.Words((centre + middle) / 2, "$h$", (5, -6), look.AXIS),
        pen.Markers(centre, look.INK, 5),
        pen.Markers(middle, look.INK, 4, fill="white"),
        pen.Markers(touch, look.TORQUE, 8, fill="white", z=8),
        pen.Markers(touch, look.TORQUE, 2.5, z=9, words=r"$-f\mathbf{v}$", shift=(8, -10)),
    ]
    pen.picture(axes, parts, (-1.55, 1.55), (-0.3, 2.65))


CONTACT = Drawing(
    "contact",
    "The tippe top and its point of contact",
    "1",
    (Parameter("tilt", math.radians(35), "tilt", "rad", least=0.2, most=1.3),),
    pen.alone(2.9, draw_contact),
    r"The axis leans by $\theta = {tilt:°}$. Black: the centre of mass; white: the middle of the "
    "ball. The contact slides into the paper; friction points out of it.",
    "A ball with its top cut off stands on a table, its axis e at {tilt:°} degrees from the "
    "vertical n. From its centre of mass, on the axis below the middle, the arrow q goes to the "
    "point of contact, where the table pushes up and friction points at us.",
)

# --- The rise ------------------------------------------------------------------------------------

START, SHOWN = 0.1, 2.0
"""The tilt at first (rad), and how long it is shown (s)."""

VIEW = View(azimuth=0.6, elevation=0.25)


@lru_cache(maxsize=8)
def risen(spin: float, f: float) -> SlidingTrajectory:
    """The motion that is shown."""
    motion = tippe_top(**USUAL, f=f).motion(theta=START, omega3=spin)
    return motion.integrate(np.linspace(0.0, SHOWN, 401))


def ball(e: Floats, at: float = 0.0) -> list[pen.Part]:
    """The ball with a lid and a stem along its axis `e`, so many radii to the right."""
    place = at * VIEW.axes[0]
    belt, rim = circle(e, math.pi / 2), circle(e, LID)
    away = np.full(len(rim), bool(e @ VIEW.axes[2] < 0))
    stem = np.outer([math.cos(LID), 1.6], e)
    return [
        pen.Face(circle(VIEW.axes[2], math.pi / 2) + place, look.MANTLE, look.EDGE, z=1.4),
        pen.Curve(belt + place, look.EDGE, 0.8, hidden=VIEW(belt)[2] < 0),
        pen.Face(rim + place, look.FACE, z=1.6, normal=e),
        pen.Curve(rim + place, look.EDGE, 0.7, hidden=away),
        pen.Curve(stem + place, look.AXIS, 2.5, z=1.3 if away[0] else 3),
    ]


def draw_energy(axes: Axes, run: SlidingTrajectory, last: int = -1) -> None:
    """U and, until a row of the run, E over the tilt (mJ, degrees)."""
    tilts = np.linspace(0.0, math.pi, 181)
    least = [1e3 * least_energy(run.motion.body, run.jellett[0], x) for x in tilts]
    path = np.degrees(run.theta[:last]), 1e3 * run.energy[:last]
    parts = [
        pen.Curve((np.degrees(tilts), least), look.FIRST, label="$U$"),
        pen.Curve(path, look.SECOND, label="$E$", z=3),
        pen.Markers((path[0][-1:], path[1][-1:]), look.SECOND, 5),
    ]
    pen.chart(axes, parts, r"$\theta$  (degrees)", "energy  (mJ)", xlim=(0, 180))
    axes.legend(loc="upper right")


def _rise(spin: float, f: float) -> Canvas:
    run = risen(spin, f)
    drawn = look.canvas(look.TEXT, 3.6)
    grid = drawn.add_gridspec(2, 2, height_ratios=(1, 1.6))
    flashes, tilt, energy = (drawn.add_subplot(grid[k]) for k in (slice(0, 2), 2, 3))
    rows = slice(None, None, 100)
    balls: list[pen.Part] = []
    for k, (time, axis) in enumerate(zip(run.t[rows], run.e3[rows], strict=True)):
        word = pen.Words((3.6 * k, -1.6), f"{time:g} s", (0, -8), look.NOTE, "center", size=8)
        balls += [*ball(axis, 3.6 * k), word]
    pen.picture(flashes, balls, (-1.8, 16.2), (-2.2, 1.7), VIEW)
    curve = np.column_stack([run.t, np.degrees(run.theta)])
    parts = [pen.Curve(curve, look.FIRST), pen.Markers(curve[rows], look.AXIS, 4)]
    limits = {"xlim": (0, SHOWN), "ylim": (0, 185)}
    pen.chart(tilt, parts, "$t$  (s)", r"$\theta$  (degrees)", **limits)
    draw_energy(energy, run)
    return drawn


def _film(spin: float, f: float) -> Film:
    """The ball, and its energy until now."""
    run = risen(spin, f)

    def show(share: float, top: Axes, energy: Axes) -> None:
        row = 1 + round(share * (len(run.t) - 2))
        pen.picture(top, ball(run.e3[row]), (-1.9, 1.9), (-1.9, 1.9), VIEW)
        draw_energy(energy, run, row)

    return film(look.TEXT, 2.5, show, (0.0, 0.0, 0.42, 1.0), (0.54, 0.2, 0.43, 0.74))


def _facts(spin: float, f: float) -> dict[str, Any]:
    run = risen(spin, f)
    heat, height = 1e3 * run.dissipated_by_friction, 1e3 * run.position[:, 2]
    facts = {"start": START, "shown": SHOWN, "end": run.theta[-1], "heat": heat[-1]}
    return {**facts, "higher": height[-1] - height[0]}


RISE = Drawing(
    "rise",
    "A tippe top turns over",
    "4",
    (
        Parameter("spin", 155.0, "spin at the start", "rad/s", least=15, most=300),
        Parameter("f", 0.2, "friction by the speed of sliding, $f$", "kg/s", least=0.05, most=1),
    ),
    _rise,
    r"Set down at $\theta = {start:°}$ with $\omega_3 = {spin}$ rad/s, and with the viscous "
    r"friction $f = {f}$ kg/s: after {shown} s it is at $\theta = {end:°}$, its centre of mass is "
    "{higher} mm higher, and friction has taken {heat} mJ. On the right: $E$ is never less "
    "than $U$.",
    "Five balls with a lid and a stem, from the start to {shown} seconds later; theta against time "
    "goes from {start:°} to {end:°} degrees; the energy against theta goes down by {heat} "
    "millijoules and stays above the curve of U.",
    _facts,
    _film,
)

FIGURES = (CONTACT, RISE)
