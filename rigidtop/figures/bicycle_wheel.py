"""A bicycle wheel whose horizontal axle hangs on a cord at one end."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.derivations.exercises.gyroscope import (
    bicycle_wheel,
    hoop_on_axle,
    slope_of_cord,
    spinning,
)
from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.axle import arrows, axle, facts_of_axle, steady, to_scale
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.solved import answers
from rigidtop.figures.space import UPRIGHT, View, ring
from rigidtop.figures.style import Floats, in_math
from rigidtop.motion.motion import TopMotion

VIEW = View(azimuth=-0.36, elevation=0.3)
"""Nearly along the wheel, which would else hide its cord."""

SPOKES = 18

LONGEST = 1.3
"""Of the cord as it is drawn, where the rim is at the distance 1 from its lower end."""


def draw_wheel(axes: Axes, motion: TopMotion, radius: float, cord: float) -> None:
    """A wheel of this radius (m) on its axle and on a cord of this length (m), with the arrows.

    Wheel, axle and the lean of the cord are to scale, arrows are not; a long cord is cut off.
    """
    arm, half = to_scale(motion, radius)
    start, top = motion.start(), motion.body
    e3, rate = start.e3[0], float(start.phi_dot[0])
    slope = slope_of_cord(rate, top.R, cord, top.g)
    # From the end of the axle up, and in towards the vertical about which all goes round.
    along = np.array([0.0, -slope, 1.0]) / math.hypot(1.0, slope)
    whole = cord / math.hypot(top.R, radius)
    upper, centre = min(whole, LONGEST) * along, arm * e3
    rim = ring(centre, e3, half, VIEW.axes[2] + 0.1 * VIEW.axes[0])
    spokes = ring(centre, e3, half, UPRIGHT, count=SPOKES + 1)[:-1]
    # Where the cord is fixed, or a stroke through it where it goes on.
    cut = pen.Mark(upper, look.NOTE, 9, (2, 0, 60), z=5)
    end = cut if whole > LONGEST else pen.Mark(upper, look.GREY, 5, "s", z=5)
    turning, beside = _sense(upper, rate)
    pull, edge = arrows(VIEW, motion, radius)
    parts: list[pen.Part] = [
        pen.Curve([pen.ORIGIN, upper], look.NOTE, 1.1, z=5, label="_cord"),
        end,
        pen.Words(pen.ORIGIN, "$O$", (-4, -10), ha="right"),
        *axle(VIEW, motion, radius),
        *(pen.Curve([centre, point], look.GREY, 0.6, z=2.2) for point in spokes),
        pen.Curve(rim, look.INK, 3.4, z=2.4, label="_rim"),
        pen.Curve(rim, look.MANTLE, 1.6, z=2.5),
        *pull,
        turning,
        *beside,
    ]
    pen.draw(axes, parts, VIEW)
    edge += [*rim, *turning.points(VIEW), 1.05 * upper]
    pen.fit(axes, VIEW, edge, (0.2, 0.06, 0.05, 0.02))


def _sense(upper: Floats, rate: float) -> tuple[pen.Turning, list[pen.Part]]:
    """Ω about the vertical, beside a cord that ends at `upper`, or above a short one."""
    words = rf"$\Omega = {in_math(rate)}$ rad/s"
    middle, beside = 0.8 * upper, list[pen.Part]()
    if np.linalg.norm(upper) < 0.6:
        middle = 0.7 * UPRIGHT
        beside = [pen.guide(np.outer([0.0, 0.9], UPRIGHT), ls=look.DOTTED)]
    elif abs(upper[1]) > 0.5 * upper[2]:  # the cord is where the words would be
        beside, words = [pen.Words(middle, words, (0, 9), look.OMEGA, "center")], ""
    return pen.Turning(middle, UPRIGHT, 0.17, rate, words, left=True, z=3.5), beside


def _motion(M: float, radius: float, R: float, g: float, omega3: float) -> TopMotion:
    spinning(omega3)
    return steady(hoop_on_axle(M, radius, R, g), math.pi / 2, omega3)


def _draw(axes: Axes, cord: float, **values: float) -> None:
    draw_wheel(axes, _motion(**values), values["radius"], cord)


def _facts(cord: float, **values: float) -> dict[str, Any]:
    return answers(bicycle_wheel, cord=cord, **values) | facts_of_axle(_motion(**values))


BICYCLE_WHEEL = Drawing(
    "bicycle-wheel",
    "The bicycle wheel on a cord: weight, torque and the change of $L$",
    "",
    bicycle_wheel.parameters,
    pen.alone(2.9, _draw),
    "A bicycle wheel of {M} kg and radius {radius} m at $R = {R}$ m from the end $O$ of its "
    r"horizontal axle, with $\omega_3 = {omega3}$ rad/s and $g = {g}$ m/s²: $L = {L}$ J s, and the "
    "torque about $O$, $N = {N}$ N m, turns it {direction}, as seen from above, at "
    r"$\Omega = {precession}$ rad/s, a turn in {period} s. The cord of {cord} m, drawn shorter, "
    r"pulls with {tension} N and leans by {lean:°}. Dashed: the circle of the tip of $\mathbf L$. "
    "Directions are computed, lengths of arrows are not to scale.",
    "A wheel with spokes, seen aslant, on a horizontal axle; a cord that leans by {lean:°} degrees "
    "holds it at one end, O. The weight points down from the hub, L points {side} O, {aslant:°} "
    "degrees from the axle. The torque N at O is horizontal and points into the paper, and so does "
    "the change of L at its tip. Seen from above the wheel goes {direction}: the tip of L into the "
    "paper.",
    _facts,
    motions=lambda cord, **values: (_motion(**values),),
)
