"""Tops that fall: without spin, or with too little of it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.bodies import TOP, facts_of, of_top, time_to
from rigidtop.figures.drawing import Drawing, one
from rigidtop.motion.many import top_motions
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter

TILT = r"$\theta$  (degrees)"
LET_GO = Parameter("theta", 0.1, r"$\theta$ where it is let go", "rad", least=1e-6, most=1.57)
ALL_TILTS: Mapping[str, Any] = {"ylim": (0, 190), "yticks": [0, 45, 90, 135, 180]}

# --- The toppling top ----------------------------------------------------------------------------


def time_to_fall(motion: TopMotion) -> float:
    """When θ of a top that is let go at rest comes to π/2 (s)."""
    return time_to(motion, math.pi / 2)


def draw_toppling(axes: Axes, motion: TopMotion) -> None:
    """θ(t) of a top that is let go at rest, until it lies, and on as if there were no table."""
    fall, period = time_to_fall(motion), motion.nutation_period
    until, after = np.linspace(0.0, fall, 400), np.linspace(fall, period, 600)
    left = fall > 0.3 * period
    beside, side = ((-6, 5), "right") if left else ((7, -10), "left")
    parts = [
        pen.Curve((after, np.degrees(motion.exact(after).theta)), look.GREY, 1.0, look.DASHED),
        pen.Curve((until, np.degrees(motion.exact(until).theta)), look.FIRST, 1.6),
        pen.Curve(([0, fall, fall], [90, 90, 0]), look.INK, 0.8, look.DOTTED),
        pen.Markers((fall, 90), look.SECOND, 4.5),
        pen.Words((fall, 90), f"{fall:.3g} s", beside, ha=side),
    ]
    pen.chart(axes, parts, "$t$  (s)", TILT, xlim=(0, period), **ALL_TILTS)


def _toppling(theta: float, lambda1: float, M: float, R: float, g: float) -> TopMotion:
    """As thin as can be: λ₃ plays no part without spin."""
    top = HeavyTop(lambda1=lambda1, lambda3=1e-9 * lambda1, M=M, R=R, g=g)
    return top.motion(theta=theta, omega3=0.0)


def _toppling_facts(**values: float) -> dict[str, Any]:
    motion = _toppling(**values)
    return facts_of(motion.body, fall=time_to_fall(motion), period=motion.nutation_period)


TOPPLING = Drawing(
    "toppling",
    r"The toppling top: $\theta(t)$ without rotation",
    "",
    (TOP[0], *TOP[2:], LET_GO),
    pen.alone(2.3, lambda axes, **values: draw_toppling(axes, _toppling(**values))),
    r"$\theta$ of a top with $\lambda_1 = {lambda1}$ kg m² and $MgR = {MgR}$ J that is let go "
    r"without rotation at $\theta = {theta:°}$: it lies after {fall} s. Dashed: what it would do "
    "without the table, a pendulum that rests as high on the other side after {period} s.",
    "Theta against time rises from {theta:°} degrees, slowly at first, to 90 degrees at {fall} "
    "seconds, where a dot is. A dashed curve goes on to 180 degrees and back, as that of a "
    "pendulum.",
    _toppling_facts,
    motions=one(_toppling),
)

# --- The sleeping top ----------------------------------------------------------------------------


def draw_sleeping(axes: Axes, top: HeavyTop, theta: float, omega3: float) -> None:
    """The turning points of θ against ω₃, of a top let go at a small θ with φ̇ = θ̇ = 0.

    The dotted line is the least spin at which the upright top is stable; the dots are those of
    `omega3` (rad/s).
    """
    wakes = top.sleeping_spin()
    last = max(1.7 * wakes, 1.15 * omega3)
    spins = np.unique(np.append(np.linspace(0.0, last, 801), np.linspace(0.9, 1.1, 201) * wakes))
    tops = top_motions(**vars(top), theta=theta, omega3=spins)
    first, second = np.degrees(tops.turning_points)
    marked = np.degrees(top.motion(theta=theta, omega3=omega3).turning_points)
    at = 0.3 * wakes
    formula = r"$\frac{2}{\lambda_3}\sqrt{\lambda_1 MgR}$"
    parts = [
        pen.Band(spins, first, second),
        pen.Curve((spins, second), look.FIRST, 1.3, label="_largest"),
        pen.Curve((spins, first), look.SECOND, 1.3, look.DASHED, label="_smallest"),
        pen.Rule(x=wakes),
        pen.Curve(([omega3, omega3], marked), look.INK, 0.8),
        pen.Markers(([omega3, omega3], marked)),
        pen.Words((wakes, 190), formula, (5, -2), look.NOTE, va="top"),
        pen.Words((0.62 * wakes, 40), "wakes", ha="center"),
        pen.Words((0.5 * (wakes + last), 40), "sleeps", ha="center"),
        pen.Words((at, np.interp(at, spins, second)), r"$\theta_2$", (0, 5), ha="center"),
        pen.Words((at, np.interp(at, spins, first)), r"$\theta_i$", (0, 5), ha="center"),
    ]
    pen.chart(axes, parts, r"$\omega_3$  (rad/s)", TILT, xlim=(0, last), **ALL_TILTS)


def _sleeping_facts(body: HeavyTop, theta: float, omega3: float) -> dict[str, Any]:
    first, last = body.motion(theta=theta, omega3=omega3).turning_points
    return facts_of(body, first=first, last=last, sleeping=body.sleeping_spin())


SLEEPING = Drawing(
    "sleeping",
    r"The sleeping top wakes: turning points of $\theta$ against $\omega_3$",
    "",
    (
        *TOP,
        replace(LET_GO, default=math.radians(2), most=0.5),
        Parameter("omega3", 22.0, r"$\omega_3$ that is marked", "rad/s", least=0),
    ),
    pen.alone(2.3, of_top(draw_sleeping)),
    r"How far a top with {top} falls that is let go at $\theta = {theta:°}$ with "
    r"$\dot\phi = \dot\theta = 0$, so $p_\phi \neq p_\psi$: its turning points, the start "
    r"$\theta_i$ and $\theta_2$, against $\omega_3$. Left of the dotted line, "
    r"$\omega_3 = {sleeping}$ rad/s, the upright top is not stable. Dots: at $\omega_3 = {omega3}$ "
    r"rad/s $\theta$ runs between {first:°} and {last:°}.",
    "The largest theta against the spin falls from 180 degrees without spin, ever more steeply, to "
    "nearly its start, {theta:°} degrees, at the spin {sleeping} radians per second, and stays "
    "there; the smallest theta stays at the start.",
    of_top(_sleeping_facts),
)
