"""Tops that fall: without spin, or with too little of it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from scipy.optimize import brentq

from rigidtop.figures import style as look
from rigidtop.figures.bodies import TOP, of_top, top_in_words
from rigidtop.figures.drawing import Drawing, one
from rigidtop.figures.style import alone, degrees, name_at, said, spoken
from rigidtop.motion.many import top_motions
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter

ALL_TILTS: Mapping[str, Any] = {
    "ylim": (0, 190),
    "yticks": [0, 45, 90, 135, 180],
    "ylabel": r"$\theta$  (degrees)",
}

# --- The toppling top ----------------------------------------------------------------------------


def time_to_fall(motion: TopMotion) -> float:
    """When θ of a top that is let go at rest comes to π/2 (s)."""

    def above(t: float) -> float:
        return float(motion.exact(t).theta[0]) - math.pi / 2

    return float(brentq(above, 0.0, motion.nutation_period / 2, xtol=1e-12, rtol=1e-14))


def draw_toppling(axes: Axes, motion: TopMotion) -> None:
    """θ(t) of a top that is let go at rest, until it lies, and on as if there were no table."""
    fall, period = time_to_fall(motion), motion.nutation_period
    until, after = np.linspace(0.0, fall, 400), np.linspace(fall, period, 600)
    for times, style in ((after, look.DASHED), (until, "-")):
        theta = np.degrees(motion.exact(times).theta)
        width = 1.0 if style == look.DASHED else 1.6
        axes.plot(
            times,
            theta,
            color=look.GREY if style == look.DASHED else look.FIRST,
            ls=style,
            lw=width,
        )
    axes.plot([0, fall, fall], [90, 90, 0], color=look.INK, lw=0.8, ls=look.DOTTED)
    axes.plot(fall, 90, "o", color=look.SECOND, ms=4.5)
    left = fall > 0.3 * period
    name_at(
        axes,
        fall,
        90,
        f"{fall:.3g} s",
        (-6, 5) if left else (7, -10),
        ha="right" if left else "left",
        color=look.INK,
    )
    axes.set(xlim=(0, period), xlabel="$t$  (s)", **ALL_TILTS)


def _toppling(theta: float, lambda1: float, M: float, R: float, g: float) -> TopMotion:
    """As thin as can be: λ₃ plays no part without spin."""
    top = HeavyTop(lambda1=lambda1, lambda3=1e-9 * lambda1, M=M, R=R, g=g)
    return top.motion(theta=theta, omega3=0.0)


def _toppling_caption(**values: float) -> str:
    motion = _toppling(**values)
    top = motion.body
    return (
        f"$θ$ of a top with $λ₁ = {said(top.lambda1)}$ kg m² and $MgR = "
        f"{said(top.M * top.g * top.R)}$ J that is let go without rotation at $θ = "
        f"{degrees(values['theta'])}$: it lies after {said(time_to_fall(motion))} s. Dashed: what "
        "it would do without the table, a pendulum that rests as high on the other side after "
        f"{said(motion.nutation_period)} s."
    )


def _toppling_in_words(**values: float) -> str:
    motion = _toppling(**values)
    return (
        f"Theta against time rises from {spoken(math.degrees(values['theta']))} degrees, slowly at "
        f"first, to 90 degrees at {spoken(time_to_fall(motion))} seconds, where a dot is. A dashed "
        "curve goes on to 180 degrees and back, as that of a pendulum."
    )


TOPPLING = Drawing(
    "toppling",
    "The toppling top: $θ(t)$ without rotation",
    "",
    (
        TOP[0],
        *TOP[2:],
        Parameter("theta", 0.1, "$θ$ where it is let go", "rad", least=1e-6, most=1.57),
    ),
    alone(2.3, lambda axes, **values: draw_toppling(axes, _toppling(**values))),
    _toppling_caption,
    _toppling_in_words,
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
    axes.fill_between(spins, first, second, color=look.FIRST, alpha=0.12, lw=0)
    axes.plot(spins, second, color=look.FIRST, label="_largest")
    axes.plot(spins, first, color=look.SECOND, ls=look.DASHED, label="_smallest")
    axes.axvline(wakes, color=look.GREY, lw=0.9, ls=look.DOTTED)
    marked = np.degrees(top.motion(theta=theta, omega3=omega3).turning_points)
    axes.plot([omega3, omega3], marked, "-o", color=look.INK, ms=3.5, lw=0.8)
    name_at(axes, wakes, 190, r"$\frac{2}{\lambda_3}\sqrt{\lambda_1 MgR}$", (5, -2), va="top")
    name_at(axes, 0.62 * wakes, 40, "wakes", ha="center", color=look.INK)
    name_at(axes, 0.5 * (wakes + last), 40, "sleeps", ha="center", color=look.INK)
    for curve, words in ((second, r"$\theta_2$"), (first, r"$\theta_i$")):
        at = float(np.interp(0.3 * wakes, spins, curve))
        name_at(axes, 0.3 * wakes, at, words, (0, 5), ha="center", color=look.INK)
    axes.set(xlim=(0, last), xlabel=r"$\omega_3$  (rad/s)", **ALL_TILTS)


def _sleeping_caption(body: HeavyTop, theta: float, omega3: float) -> str:
    first, last = body.motion(theta=theta, omega3=omega3).turning_points
    return (
        f"How far a top with {top_in_words(body)} falls that is let go at $θ = {degrees(theta)}$ "
        "with $φ̇ = θ̇ = 0$, so $p_φ ≠ p_ψ$: its turning points, the start $θᵢ$ and $θ₂$, against "
        f"$ω₃$. Left of the dotted line, $ω₃ = {said(body.sleeping_spin())}$ rad/s, the upright "
        f"top is not stable. Dots: at $ω₃ = {said(omega3)}$ rad/s $θ$ runs between "
        f"{degrees(first)} and {degrees(last)}."
    )


def _sleeping_in_words(body: HeavyTop, theta: float, omega3: float) -> str:
    return (
        "The largest theta against the spin falls from 180 degrees without spin, ever more "
        f"steeply, to nearly its start, {spoken(math.degrees(theta))} degrees, at the spin "
        f"{spoken(body.sleeping_spin())} radians per second, and stays there; the smallest theta "
        "stays at the start."
    )


SLEEPING = Drawing(
    "sleeping",
    "The sleeping top wakes: turning points of $θ$ against $ω₃$",
    "",
    (
        *TOP,
        Parameter("theta", math.radians(2), "$θ$ where it is let go", "rad", least=1e-6, most=0.5),
        Parameter("omega3", 22.0, "$ω₃$ that is marked", "rad/s", least=0),
    ),
    alone(2.3, of_top(draw_sleeping)),
    of_top(_sleeping_caption),
    of_top(_sleeping_in_words),
)
