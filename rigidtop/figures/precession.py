"""Steady precession: its two rates, and what holds for large ω₃."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from rigidtop.derivations.exercises import parallel
from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.bodies import SPIN, THETA, TOP, facts_of, of_top
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.style import Floats
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter

# --- Ω₋ and Ω₊ against ω₃ ------------------------------------------------------------------------


ABOVE: Any = {"ha": "center", "shift": (0, 6)}


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
    fast = top.lambda3 * spins / (top.lambda1 * cosine) if leaning else slow
    height = max(rates[-1, 1] if leaning else 0.0, 0.0) or 4 * float(marked[0])
    low, high = 1.02 * min(rates[-1, 1] if leaning else 0.0, 0.0), 1.08 * height
    where = least + 0.55 * (last - least)
    beside = {"ha": "right", "shift": (-5, 5)} if cosine > 0 else {"ha": "left", "shift": (5, 3)}
    parts: list[pen.Part] = []
    for k, name, color, law, formula, place in (
        (1, "fast", look.SECOND, fast, r"$\lambda_3\omega_3/(\lambda_1\cos\theta)$", beside),
        (0, "slow", look.FIRST, slow, r"$MgR/(\lambda_3\omega_3)$", ABOVE),
    )[not leaning :]:
        letter, at = rf"$\Omega_{'-+'[k]}$", (where, float(np.interp(where, spins, law)))
        parts += [
            pen.Curve((spins, law), look.GREY, 1.0, look.DASHED),
            pen.Curve((spins, rates[:, k]), color, 1.3, label=f"_{name}"),
            pen.Markers((omega3, marked[k]), color, 4),
            pen.Words((last, rates[-1, k]), letter, (3, 0), color, va="center"),
            pen.Words(at, formula, color=look.NOTE, **place),
        ]
    if least:
        formula = r"$\frac{2}{\lambda_3}\sqrt{\lambda_1 MgR\,\cos\theta}$"
        parts += [pen.Rule(x=least), pen.Words((least, high), formula, (4, -1), va="top")]
    limits = {"xlim": (0.5 * least, last), "ylim": (low, high)}
    pen.chart(axes, parts, r"$\omega_3$  (rad/s)", r"$\Omega$  (rad/s)", **limits)


def _rates_facts(body: HeavyTop, theta: float, omega3: float) -> dict[str, Any]:
    slow, fast = body.steady_precession(theta, omega3)
    least = body.smallest_spin(theta)
    left = r" Left of the dotted line, $\omega_3 = {least}$ rad/s, no steady precession exists."
    standing = (
        "Two curves that begin at a common point at the least spin, {least} radians per second. "
        "The fast rate rises to the straight line lambda3 omega3 over lambda1 cos theta, the slow "
        "rate falls to the hyperbola M g R over lambda3 omega3; at {omega3} they are {fast} and "
        "{slow}."
    )
    hanging = (
        "Rates of steady precession against the spin of a top that does not stand above the "
        "horizontal: at {omega3} radians per second the slow one is {slow} and the fast one {fast}."
    )
    return facts_of(
        body,
        slow=slow,
        fast=fast,
        least=least,
        other=r" and $\Omega_+ = {fast}$ rad/s" if math.isfinite(fast) else "",
        left=left if least else "",
        course=standing if least else hanging,
    )


PRECESSION_RATES = Drawing(
    "precession-rates",
    r"$\Omega_-$ and $\Omega_+$ against $\omega_3$, with the threshold",
    "3.5.3",
    (*TOP, THETA, SPIN),
    pen.alone(2.5, of_top(draw_precession_rates)),
    r"The roots of (3.57) against $\omega_3$ at $\theta = {theta:°}$, for {top}; at "
    r"$\omega_3 = {omega3}$ rad/s they are $\Omega_- = {slow}$ rad/s{other}. Dashed: what the "
    r"notes give for large $\omega_3$.{left}",
    "{course}",
    of_top(_rates_facts),
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
        return np.asarray(np.abs(large_spin_formulas(top, theta, at) / exact - 1))

    (lines, dots), here = (errors(spins), errors(marked)), weakness(top, theta, omega3)
    parts: list[pen.Part] = [
        pen.Rule(y=0.01, lw=0.8),
        pen.Words((epsilon[0], 0.01), "1 %", (4, 3), look.NOTE),
    ]
    roots = (look.FIRST, "-", r"$\Omega_-$"), (look.SECOND, look.DASHED, r"$\Omega_+$")
    for order, width, words in ((0, 1.5, "leading order"), (1, 1.0, "next order")):
        for root, (color, style, name) in enumerate(roots):
            errors_of = epsilon, lines[order, root]
            label = "_" if order else name
            parts.append(pen.Curve(errors_of, color, width, style, label=label))
            parts.append(pen.Markers((here, float(dots[order, root, 0])), color))
        k = 90 + 40 * order
        place = float(epsilon[k]), float(lines[order].max(axis=0)[k])
        parts.append(pen.Words(place, words, (-4, 4), ha="right"))
    limits = {"xlim": (epsilon[0], 0.4), "ylim": (float(lines[1].min()) / 3, 2.0)}
    across = r"$\epsilon = \lambda_1 MgR\,\cos\theta/(\lambda_3\omega_3)^2$"
    pen.chart(axes, parts, across, "relative error", xscale="log", yscale="log", **limits)
    axes.legend(loc="lower right", handlelength=2.2)


def _asymptotics_facts(body: HeavyTop, theta: float, omega3: float) -> dict[str, Any]:
    exact = body.steady_precession(theta, omega3)
    lead, _ = large_spin_formulas(body, theta, np.array([omega3]))
    slow, fast = (abs(float(a[0]) / b - 1) for a, b in zip(lead, exact, strict=True))
    return facts_of(body, epsilon=weakness(body, theta, omega3), slow=slow, fast=fast)


UPWARD = Parameter("theta", math.pi / 3, r"$\theta$", "rad", least=0, most=1.57)

ASYMPTOTICS = Drawing(
    "asymptotics",
    r"How good the formulas for large $\omega_3$ are",
    "",
    (*TOP, UPWARD, SPIN),
    pen.alone(2.6, of_top(draw_asymptotics)),
    r"The relative error of $\Omega_- \approx MgR/(\lambda_3\omega_3)$ and $\Omega_+ "
    r"\approx \lambda_3\omega_3/(\lambda_1 \cos\theta)$, and of the same with the next term in "
    r"$\varepsilon$, against $\varepsilon$; at $\varepsilon = 1/4$ the two roots of (3.57) meet. "
    r"Dots: a top with {top} at $\theta = {theta:°}$ and $\omega_3 = {omega3}$ rad/s, "
    r"$\varepsilon = {epsilon}$, where the first are off by {slow:%} and {fast:%} %.",
    "Relative errors against epsilon on logarithmic scales. To leading order the errors of both "
    "rates are about epsilon itself; with the next term they are of the order of its square. At "
    "epsilon {epsilon} they are {slow} and {fast}. A dotted line marks one per cent.",
    of_top(_asymptotics_facts),
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
    sine = math.sin(float(np.clip(math.pi / 2, *motion.turning_points)))
    across = 2 * top.M * top.g * top.R * sine / (top.lambda3 * motion.omega[2])
    return math.atan(abs(top.lambda1 - top.lambda3) * across / (top.lambda3 * motion.omega[2]))


def widest_between(motion: TopMotion) -> bool:
    """Whether the angle is largest on the way down, where ω across e₃ is √(λ₃/λ₁)|ω₃|."""
    top, omega3 = motion.body, motion.omega[2]
    lowest = parallel.fastest_across(top, motion.turning_points[0], omega3)
    return float(lowest) > math.sqrt(top.lambda3 / top.lambda1) * abs(omega3)


def _over_nutations(motion: TopMotion) -> Floats:
    """Times (s), of which one is half way through each of the nutations, dense about the cusps."""
    period = motion.nutation_period
    if not math.isfinite(period):  # upright or hanging, it stays
        return np.linspace(0.0, NUTATIONS * 2 * math.pi / motion.omega[2], 201)
    half = np.linspace(0.0, 0.5, 121)
    if widest_between(motion):  # a slow top falls to its largest angle in a small part of it
        half = np.union1d(half, np.geomspace(1e-12, 0.5, 900))
    once = np.append(half[:-1], 1 - half[:0:-1])
    return period * np.append(np.add.outer(np.arange(NUTATIONS), once), NUTATIONS)


def draw_parallel(axes: Axes, top: HeavyTop, theta: float, omega3: float) -> None:
    """The angle between L and ω of a top that is let go with ω along e₃, and its bound."""
    motion = top.motion(theta=theta, omega3=omega3)
    times = _over_nutations(motion)
    angle = np.degrees(angle_to_momentum(motion, times))
    bound = math.degrees(bound_of_angle(motion))
    formula = r"$\arctan(2\epsilon_0\,|1-\lambda_3/\lambda_1|\,\sin\theta_\mathrm{max})$"
    parts = [
        pen.Curve((times, angle), look.FIRST, 1.3, label="_angle"),
        pen.Rule(y=bound, color=look.SECOND, lw=1.1, ls=look.DASHED, label="_bound"),
        pen.Words((0.0, bound), formula, (4, 5), look.SECOND, va="bottom"),
    ]
    up = r"angle of $\mathbf{L}$ and $\boldsymbol{\omega}$  (degrees)"
    limits = {"xlim": (0, times[-1]), "ylim": (0, 1.3 * bound or 1.0)}
    pen.chart(axes, parts, "$t$  (s)", up, **limits)


def _parallel_facts(body: HeavyTop, theta: float, omega3: float) -> dict[str, Any]:
    motion = body.motion(theta=theta, omega3=omega3)
    largest = float(parallel.largest_angle(body, motion.turning_points[0], omega3))
    between = widest_between(motion)
    rises = (
        f"goes from zero up and comes down again, {'twice' if between else 'once'} in every "
        "nutation; it is {largest:°} degrees at most"
    )
    course, most = "It is zero at every cusp and {largest:°} at most", "."
    if between:
        most = (
            r", $\arcsin(|\lambda_1 - \lambda_3|/(\lambda_1 + \lambda_3))$, on the way down and "
            "again on the way up."
        )
    return facts_of(
        body,
        largest=largest,
        course=course + most if largest else "It is zero all the time.",
        goes=rises if largest else "is zero all the time",
        bound=bound_of_angle(motion),
        weak=body.lambda1 * body.M * body.g * body.R / (body.lambda3 * omega3) ** 2,
    )


PARALLEL = Drawing(
    "parallel",
    r"$\mathbf L$ and $\boldsymbol\omega$ of a fast top are nearly parallel",
    "",
    (*TOP, THETA, Parameter("omega3", 150.0, r"$\omega_3$", "rad/s", above=0)),
    pen.alone(2.3, of_top(draw_parallel)),
    r"The angle between $\mathbf L$ and $\boldsymbol\omega$ of a top with {top} that is let go at "
    r"$\theta = {theta:°}$ with $\omega_3 = {omega3}$ rad/s and $\boldsymbol\omega$ along "
    r"$\mathbf e_3$. {course} Dashed: the bound that holds at any spin, its tangent "
    r"$2\varepsilon_0|1 - \lambda_3/\lambda_1|\sin\theta$ with the largest $\sin\theta$ that "
    r"occurs, here {bound:°} with $\varepsilon_0 = \lambda_1MgR/(\lambda_3\omega_3)^2 = {weak}$.",
    "The angle between L and omega against time {goes}. A dashed line that it never crosses is at "
    "the bound, {bound:°} degrees.",
    of_top(_parallel_facts),
)
