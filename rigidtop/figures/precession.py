"""Steady precession: its two rates, and what holds for large ω₃."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from numpy.typing import ArrayLike
from scipy.optimize import brentq

from rigidtop.derivations.exercises import parallel
from rigidtop.figures import style as look
from rigidtop.figures.bodies import SPIN, THETA, TOP, of_top, top_in_words
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.style import Floats, alone, degrees, name_at, said, spoken
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter

# --- Ω₋ and Ω₊ against ω₃ ------------------------------------------------------------------------


def draw_precession_rates(axes: Axes, top: HeavyTop, theta: float, omega3: float) -> None:
    """Ω₋ and Ω₊ of (3.57) against ω₃, at the tilt `theta` (rad); dots at the spin `omega3` (rad/s).

    Dashed are the values that the notes give for large ω₃; the dotted line is the least spin at
    which a steady precession exists.  Raises NoSteadyPrecession if `omega3` is less.
    """
    marked = top.steady_precession(theta, omega3)
    least = top.smallest_spin(theta)
    last = max(3.5 * least, 1.25 * omega3)
    spins = least + (last - least) * np.linspace(0.0, 1.0, 400)[1:] ** 2
    spins[0] = least * (1 + 1e-12) if least else spins[0]
    rates = np.array([top.steady_precession(theta, spin) for spin in spins])
    weight, cosine = top.M * top.g * top.R, math.cos(theta)
    leaning = math.isfinite(marked[1])  # horizontal, there is no fast precession
    slow = weight / (top.lambda3 * spins)
    axes.plot(spins, slow, color=look.GREY, lw=1.0, ls=look.DASHED)
    if least:
        axes.axvline(least, color=look.GREY, lw=0.9, ls=look.DOTTED)
    if leaning:
        fast = top.lambda3 * spins / (top.lambda1 * cosine)
        axes.plot(spins, fast, color=look.GREY, lw=1.0, ls=look.DASHED)
        axes.plot(spins, rates[:, 1], color=look.SECOND, label="_fast")
        axes.plot(omega3, marked[1], "o", color=look.SECOND, ms=4)
        name_at(axes, last, rates[-1, 1], r"$\Omega_+$", (3, 0), va="center", color=look.SECOND)
    axes.plot(spins, rates[:, 0], color=look.FIRST, label="_slow")
    axes.plot(omega3, marked[0], "o", color=look.FIRST, ms=4)
    name_at(axes, last, rates[-1, 0], r"$\Omega_-$", (3, 0), va="center", color=look.FIRST)
    top_edge = max(rates[-1, 1] if leaning else 0.0, 0.0) or 4 * float(marked[0])
    bottom = min(rates[-1, 1], 0.0) if leaning else 0.0
    axes.set(xlim=(0.5 * least, last), ylim=(1.02 * bottom, 1.08 * top_edge))
    where = least + 0.55 * (last - least)
    if leaning:
        name_at(
            axes,
            where,
            float(np.interp(where, spins, fast)),
            r"$\lambda_3\omega_3/(\lambda_1\cos\theta)$",
            (-5, 5) if cosine > 0 else (5, 3),
            ha="right" if cosine > 0 else "left",
            va="bottom",
        )
    name_at(
        axes,
        where,
        float(np.interp(where, spins, slow)),
        r"$MgR/(\lambda_3\omega_3)$",
        (0, 6),
        ha="center",
    )
    if least:
        name_at(
            axes,
            least,
            1.08 * top_edge,
            r"$\frac{2}{\lambda_3}\sqrt{\lambda_1 MgR\,\cos\theta}$",
            (4, -1),
            va="top",
            color=look.INK,
        )
    axes.set(xlabel=r"$\omega_3$  (rad/s)", ylabel=r"$\Omega$  (rad/s)")


def _precession_rates_caption(body: HeavyTop, theta: float, omega3: float) -> str:
    slow, fast = body.steady_precession(theta, omega3)
    least = body.smallest_spin(theta)
    roots = f"$Ω₋ = {said(slow)}$ rad/s"
    if math.isfinite(fast):
        roots += f" and $Ω₊ = {said(fast)}$ rad/s"
    left = (
        f" Left of the dotted line, $ω₃ = {said(least)}$ rad/s, no steady precession exists."
        if least
        else ""
    )
    return (
        f"The roots of (3.57) against $ω₃$ at $θ = {degrees(theta)}$, for {top_in_words(body)}; at "
        f"$ω₃ = {said(omega3)}$ rad/s they are {roots}. Dashed: what the notes give for large $ω₃$."
        f"{left}"
    )


def _precession_rates_in_words(body: HeavyTop, theta: float, omega3: float) -> str:
    slow, fast = body.steady_precession(theta, omega3)
    least = body.smallest_spin(theta)
    if not least:
        return (
            "Rates of steady precession against the spin of a top that does not stand above the "
            f"horizontal: at {spoken(omega3)} radians per second the slow one is {spoken(slow)} "
            f"and the fast one {spoken(fast)}."
        )
    return (
        f"Two curves that begin at a common point at the least spin, {spoken(least)} radians per "
        "second. The fast rate rises to the straight line lambda3 omega3 over lambda1 cos theta, "
        f"the slow rate falls to the hyperbola M g R over lambda3 omega3; at {spoken(omega3)} they "
        f"are {spoken(fast)} and {spoken(slow)}."
    )


PRECESSION_RATES = Drawing(
    "precession-rates",
    "$Ω₋$ and $Ω₊$ against $ω₃$, with the threshold",
    "3.5.3",
    (*TOP, THETA, SPIN),
    alone(2.5, of_top(draw_precession_rates)),
    of_top(_precession_rates_caption),
    of_top(_precession_rates_in_words),
)

# --- How good the formulas for large ω₃ are ------------------------------------------------------

WEAKEST, STRONGEST = 1e-5, 0.25
"""ε from a fast spin to the threshold."""


@cache
def _large_spin_formula(order: int) -> Callable[..., Floats]:
    """Ω₋ and Ω₊ as `order` terms of their derived expansions."""
    from rigidtop.codegen.numpy import function
    from rigidtop.theory import symbols as s
    from rigidtop.theory.top import steady_expansions

    arguments = (s.lambda1, s.lambda3, s.M, s.R, s.g, s.theta, s.omega3)
    return function(steady_expansions(order), arguments, "large_spin").array


def large_spin_formulas(top: HeavyTop, theta: float, spins: Floats) -> Floats:
    """Ω₋ and Ω₊ (rad/s) to leading order in ε and to the next, shape (2 orders, 2 roots, N)."""
    body = top.lambda1, top.lambda3, top.M, top.R, top.g
    return np.array([_large_spin_formula(order)(*body, theta, spins) for order in (1, 2)])


def weakness(top: HeavyTop, theta: float, omega3: float) -> float:
    """ε = λ₁MgR cos θ/(λ₃ω₃)²: a quarter at the least spin with a steady precession."""
    return (top.smallest_spin(theta) / omega3) ** 2 / 4


def draw_asymptotics(axes: Axes, top: HeavyTop, theta: float, omega3: float) -> None:
    """The relative error of the formulas for large ω₃ against ε, to two orders.

    The dots are those at the spin `omega3` (rad/s).
    """
    top.steady_precession(theta, omega3)  # says so where there is none
    marked = top.smallest_spin(theta) / (2 * np.sqrt([weakness(top, theta, omega3)]))
    epsilon = np.geomspace(min(WEAKEST, weakness(top, theta, omega3) / 2), STRONGEST, 240)
    epsilon[-1] *= 1 - 1e-12
    spins = top.smallest_spin(theta) / (2 * np.sqrt(epsilon))

    def errors(at: Floats) -> Floats:
        """Shape (order, root, N)."""
        exact = np.array([top.steady_precession(theta, spin) for spin in at]).T
        made: Floats = np.abs(large_spin_formulas(top, theta, at) / exact - 1)
        return made

    lines, dots = errors(spins), errors(marked)
    for order, width in ((0, 1.5), (1, 1.0)):
        for root, (color, style) in enumerate(((look.FIRST, "-"), (look.SECOND, look.DASHED))):
            axes.plot(epsilon, lines[order, root], color=color, ls=style, lw=width)
            axes.plot(weakness(top, theta, omega3), dots[order, root], "o", color=color, ms=3.5)
    axes.axhline(0.01, color=look.GREY, lw=0.8, ls=look.DOTTED)
    axes.set(
        xscale="log", yscale="log", xlim=(epsilon[0], 0.4), ylim=(float(lines[1].min()) / 3, 2.0)
    )
    name_at(axes, epsilon[0], 0.01, "1 %", (4, 3))
    for order, words in ((0, "leading order"), (1, "next order")):
        at = 90 + 40 * order
        name_at(
            axes,
            float(epsilon[at]),
            float(lines[order].max(axis=0)[at]),
            words,
            (-4, 4),
            ha="right",
            color=look.INK,
        )
    axes.set(
        xlabel=r"$\epsilon = \lambda_1 MgR\,\cos\theta/(\lambda_3\omega_3)^2$",
        ylabel="relative error",
    )
    handles = [
        Line2D([], [], color=look.FIRST, label=r"$\Omega_-$"),
        Line2D([], [], color=look.SECOND, ls=look.DASHED, label=r"$\Omega_+$"),
    ]
    axes.legend(handles=handles, loc="lower right", handlelength=2.2)


def _large_spin_errors(body: HeavyTop, theta: float, omega3: float) -> tuple[float, float, float]:
    exact = body.steady_precession(theta, omega3)
    lead, _ = large_spin_formulas(body, theta, np.array([omega3]))
    slow, fast = (abs(float(a[0]) / b - 1) for a, b in zip(lead, exact, strict=True))
    return weakness(body, theta, omega3), slow, fast


def _asymptotics_caption(body: HeavyTop, theta: float, omega3: float) -> str:
    epsilon, slow, fast = _large_spin_errors(body, theta, omega3)
    return (
        "The relative error of $Ω₋ ≈ MgR/(λ₃ω₃)$ and $Ω₊ ≈ λ₃ω₃/(λ₁ cos θ)$, and of the same with "
        "the next term in $ε$, against $ε$; at $ε = 1/4$ the two roots of (3.57) meet. Dots: a "
        f"top with {top_in_words(body)} at $θ = {degrees(theta)}$ and $ω₃ = "
        f"{said(omega3)}$ rad/s, $ε = {said(epsilon)}$, where the first are off by "
        f"{said(100 * slow)} and {said(100 * fast)} %."
    )


def _asymptotics_in_words(body: HeavyTop, theta: float, omega3: float) -> str:
    epsilon, slow, fast = _large_spin_errors(body, theta, omega3)
    return (
        "Relative errors against epsilon on logarithmic scales. To leading order the errors of "
        "both rates are about epsilon itself; with the next term they are of the order of its "
        f"square. At epsilon {spoken(epsilon)} they are {spoken(slow)} and {spoken(fast)}. A "
        "dotted line marks one per cent."
    )


UPWARD = Parameter("theta", math.pi / 3, "$θ$", "rad", least=0, most=1.57)

ASYMPTOTICS = Drawing(
    "asymptotics",
    "How good the formulas for large $ω₃$ are",
    "",
    (*TOP, UPWARD, SPIN),
    alone(2.6, of_top(draw_asymptotics)),
    of_top(_asymptotics_caption),
    of_top(_asymptotics_in_words),
)

# --- L and ω of a fast top are nearly parallel ---------------------------------------------------

NUTATIONS = 5


def angle_to_momentum(motion: TopMotion, t: ArrayLike) -> Floats:
    """The angle between L and ω (N,), rad."""
    top, omega = motion.body, motion.exact(t).omega
    along, across = omega[:, 2], np.hypot(omega[:, 0], omega[:, 1])
    # |L × ω| and L·ω in the body; in space the cross product of long vectors loses a small angle.
    crossed = abs(top.lambda1 - top.lambda3) * np.abs(along) * across
    return np.arctan2(crossed, top.lambda1 * across**2 + top.lambda3 * along**2)


def bound_of_angle(motion: TopMotion) -> float:
    """No angle between L and ω exceeds this (rad), for a top that is let go with ω along e₃.

    Its tangent is 2ε₀|1 − λ₃/λ₁| sin θ, with ε₀ = λ₁MgR/(λ₃ω₃)² and sin θ at its largest.
    """
    top = motion.body
    across = 2 * top.M * top.g * top.R * largest_sine(motion) / (top.lambda3 * motion.omega[2])
    return math.atan(abs(top.lambda1 - top.lambda3) * across / (top.lambda3 * motion.omega[2]))


def largest_sine(motion: TopMotion) -> float:
    """The largest sin θ between the turning points."""
    first, last = motion.turning_points
    return 1.0 if first <= math.pi / 2 <= last else max(math.sin(first), math.sin(last))


def _at_lowest(motion: TopMotion) -> float:
    """ω across e₃ (rad/s) at the lowest point of a top that is let go with ω along e₃."""
    return float(parallel.fastest_across(motion.body, motion.turning_points[0], motion.omega[2]))


def _widest_across(motion: TopMotion) -> float:
    """ω across e₃ (rad/s) for which the angle between L and ω is largest: √(λ₃/λ₁)|ω₃|."""
    return math.sqrt(motion.body.lambda3 / motion.body.lambda1) * abs(motion.omega[2])


def largest_angle(motion: TopMotion) -> float:
    """The largest angle between L and ω (rad) of a top that is let go with ω along e₃."""
    return float(parallel.largest_angle(motion.body, motion.turning_points[0], motion.omega[2]))


def widest_between(motion: TopMotion) -> bool:
    """Whether the angle is largest on the way down, not at the lowest point."""
    return _at_lowest(motion) > _widest_across(motion)


def _over_nutations(motion: TopMotion) -> Floats:
    """Times (s), of which one is half way through each of the nutations, dense about the cusps."""
    period = motion.nutation_period
    if not math.isfinite(period):  # upright or hanging, it stays
        return np.linspace(0.0, NUTATIONS * 2 * math.pi / motion.omega[2], 201)
    if not widest_between(motion):
        return np.linspace(0.0, NUTATIONS * period, 120 * 2 * NUTATIONS + 1)

    def wanting(t: float) -> float:
        return math.hypot(*motion.exact(t).omega[0, :2]) - _widest_across(motion)

    # A slow top falls to its largest angle in a small part of the period.
    first = float(brentq(wanting, 0.0, period / 2, xtol=1e-300, rtol=1e-12))
    dense = np.append(np.geomspace(first / 50, period / 2, 160), first)
    even = np.linspace(0.0, period / 2, 121)
    half = np.unique(np.concatenate([even, np.minimum(dense, period / 2)]))
    once = np.concatenate([half[:-1], period - half[:0:-1]])
    starts = period * np.arange(NUTATIONS)
    return np.append((starts[:, None] + once).ravel(), NUTATIONS * period)


def draw_parallel(axes: Axes, top: HeavyTop, theta: float, omega3: float) -> None:
    """The angle between L and ω of a top that is let go with ω along e₃, and its bound."""
    motion = top.motion(theta=theta, omega3=omega3)
    times = _over_nutations(motion)
    angle = np.degrees(angle_to_momentum(motion, times))
    bound = math.degrees(bound_of_angle(motion))
    axes.plot(times, angle, color=look.FIRST, label="_angle")
    axes.axhline(bound, color=look.SECOND, lw=1.1, ls=look.DASHED, label="_bound")
    axes.set(xlim=(0, times[-1]), ylim=(0, 1.3 * bound or 1.0))
    name_at(
        axes,
        0.0,
        bound,
        r"$\arctan(2\epsilon_0\,|1-\lambda_3/\lambda_1|\,\sin\theta_\mathrm{max})$",
        (4, 5),
        va="bottom",
        color=look.SECOND,
    )
    axes.set(
        xlabel="$t$  (s)", ylabel=r"angle of $\mathbf{L}$ and $\boldsymbol{\omega}$  (degrees)"
    )


def _parallel_caption(body: HeavyTop, theta: float, omega3: float) -> str:
    motion = body.motion(theta=theta, omega3=omega3)
    weak = body.lambda1 * body.M * body.g * body.R / (body.lambda3 * omega3) ** 2
    largest = largest_angle(motion)
    if not largest:
        course = "It is zero all the time."
    elif widest_between(motion):
        course = (
            f"It is zero at every cusp and {degrees(largest)} at most, "
            "$arcsin(|λ₁ − λ₃|/(λ₁ + λ₃))$, on the way down and again on the way up."
        )
    else:
        course = f"It is zero at every cusp and {degrees(largest)} at most."
    return (
        f"The angle between $𝐋$ and $𝛚$ of a top with {top_in_words(body)} that is let go at $θ = "
        f"{degrees(theta)}$ with $ω₃ = {said(omega3)}$ rad/s and $𝛚$ along $e₃$. {course} Dashed: "
        "the bound that holds at any spin, its tangent $2ε₀|1 − λ₃/λ₁| sin θ$ with the largest "
        f"$sin θ$ that occurs, here {degrees(bound_of_angle(motion))} with $ε₀ = λ₁MgR/(λ₃ω₃)² = "
        f"{said(weak)}$."
    )


def _parallel_in_words(body: HeavyTop, theta: float, omega3: float) -> str:
    motion = body.motion(theta=theta, omega3=omega3)
    largest = largest_angle(motion)
    if not largest:
        course = "is zero all the time"
    else:
        often = "twice" if widest_between(motion) else "once"
        course = (
            f"goes from zero up and comes down again, {often} in every nutation; it is "
            f"{spoken(math.degrees(largest))} degrees at most"
        )
    return (
        f"The angle between L and omega against time {course}. A dashed line that it never crosses "
        f"is at the bound, {spoken(math.degrees(bound_of_angle(motion)))} degrees."
    )


PARALLEL = Drawing(
    "parallel",
    "$𝐋$ and $𝛚$ of a fast top are nearly parallel",
    "",
    (*TOP, THETA, Parameter("omega3", 150.0, "$ω₃$", "rad/s", above=0)),
    alone(2.3, of_top(draw_parallel)),
    of_top(_parallel_caption),
    of_top(_parallel_in_words),
)
