"""Section 3.5.4: small nutation; waves, cusps and loops."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from math import cos, inf, pi, sin, sqrt
from typing import Any

import numpy as np
from scipy.optimize import brentq

from rigidtop.derivations.nutation import azimuth, nutation
from rigidtop.errors import RigidtopError
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Exercise, Outcome, Table, exercise
from rigidtop.proof.page import Claim, Measure

from .bodies import HEAVY_TOP, SPIN, TILT, heavy_top, smallness

INCLINED = replace(TILT, least=0.01, most=3.1)
"""Well away from both verticals, where a small swing is one in θ."""

TIGHT: Any = {"rtol": 1e-12, "atol": 1e-14}


released_at_rest = Claim(
    "released-at-rest",
    r"Where a top let go at $\theta_i$ with $\boldsymbol\omega$ along $\mathbf e_3$ turns back, "
    "and how far it swings.",
)


turning_points = Claim(
    "turning-points", r"The turning points of $\theta$ are two roots of a cubic in $\cos\theta$."
)


waves_or_loops = Claim(
    "waves-or-loops",
    r"At which $\dot\phi$ the path changes from waves to loops, for a start with $\dot\theta = 0$.",
)


@dataclass(frozen=True)
class Start:
    """θ, φ̇ and ω₃ (rad, rad/s) of a top at a moment at which θ̇ = 0."""

    top: HeavyTop
    tilt: float
    phi_dot: float
    spin: float

    @property
    def steepness(self) -> float:
        """(3.57) with φ̇ for Ω: λ₁θ̈/sin θ (N m); positive where the axis sinks."""
        top, rate = self.top, self.phi_dot
        return (top.lambda1 * cos(self.tilt) * rate - top.lambda3 * self.spin) * rate + top.weight[
            2
        ]

    @property
    def first(self) -> str:
        """What the axis does then."""
        return "stays" if kind(self) == "steady" else "sinks" if self.steepness > 0 else "rises"

    @cached_property
    def motion(self) -> TopMotion:
        return self.top.motion(theta=self.tilt, phi_dot=self.phi_dot, omega3=self.spin)

    @cached_property
    def other(self) -> Start:
        """The other turning point, half a period later."""
        half = self.motion.nutation_period / 2
        if half == inf:
            raise RigidtopError(
                f"phi_dot = {self.phi_dot:g} takes the axis so slowly so close to the upright that "
                "its other turning point is lost in rounding: change it or omega3 a little"
            )
        there = self.motion.turning_points[self.steepness > 0]
        return replace(self, tilt=there, phi_dot=float(self.motion.exact([half]).phi_dot[0]))


def small_frequency(top: HeavyTop, tilt: float, phi_dot: float, spin: float) -> float:
    """√(U″/λ₁) at a steady precession (rad/s)."""
    square = (
        (top.lambda3 * spin) ** 2
        - 4 * top.lambda1 * top.weight[2] * cos(tilt)
        + (top.lambda1 * phi_dot * sin(tilt)) ** 2
    )
    return sqrt(square) / top.lambda1


def lowest_potential(start: Start) -> Start:
    """Where a motion with the momenta of one that starts at rest could be steady, and Ω there."""

    def at(tilt: float) -> Start:
        fallen = 2 * sin((tilt + start.tilt) / 2) * sin((tilt - start.tilt) / 2)
        turning = start.top.lambda3 * start.spin * fallen
        return replace(start, tilt=tilt, phi_dot=turning / (start.top.lambda1 * sin(tilt) ** 2))

    ends = start.tilt, start.other.tilt
    return at(float(brentq(lambda tilt: at(tilt).steepness, *ends, xtol=1e-14)))


@exercise(
    "small-nutation",
    "Frequency and amplitude of the nutation",
    section="3.5.4",
    asks="“small oscillations around the value where it could be constant”",
    statement=r"A top precesses almost steadily. With which frequency does $\theta$ oscillate "
    "about the angle at which it could be constant, and what does that become for large "
    "$\\omega_3$?\n\nThe same top is let go at $\\theta$ with its axis at rest. How far "
    "does the axis swing, and about which angle? How good are the formulas for fast tops "
    "when the top is not that fast?",
    claims=(nutation, released_at_rest),
    parameters=(*HEAVY_TOP, INCLINED, SPIN),
    figure="effective-potential",
    text="exercises/small_nutation",
)
def small_nutation(theta: float, omega3: float, **shape: float) -> Iterator[Outcome]:
    """The formulas for a small nutation and for a fast top stand beside the period and the turning
    points of the exact motion."""
    top = heavy_top(**shape)
    slow, _ = top.steady_precession(theta, omega3)
    if omega3 == 0:
        raise RigidtopError("omega3 = 0: a top that is let go at rest without spin falls over")
    frequency = small_frequency(top, theta, slow, omega3)
    yield Answer("slow", r"rate $\Omega_-$ of steady precession at $\theta$", slow, "rad/s")
    yield Answer("frequency", r"small nutation about it, $\omega_n$", frequency, "rad/s")
    yield Answer(
        "fast_frequency",
        r"the same for a fast top, $|\lambda_3\omega_3|/\lambda_1$",
        top.lambda3 * abs(omega3) / top.lambda1,
        "rad/s",
    )
    kicked = top.motion(theta=theta, theta_dot=1e-6 * frequency, phi_dot=slow, omega3=omega3)
    error = abs(2 * pi / kicked.nutation_period / frequency - 1)
    yield Measure("frequency of a nutation of $10^{-6}$ rad in closed form, relative", error, 1e-8)

    released, predicted = Start(top, theta, 0.0, omega3), smallness(top, omega3)
    period, turn = released.motion.nutation_period, released.other.tilt
    yield Answer("turn", r"let go at rest: $\theta$ of the other turning point", turn, "rad")
    yield Answer("amplitude", "half the way to it", (turn - theta) / 2, "rad")
    yield Answer(
        "fast_amplitude",
        r"for a fast top, $\lambda_1MgR \sin\theta/(\lambda_3\omega_3)^2$",
        predicted * sin(theta),
        "rad",
    )
    yield Answer("centre", "middle between the turning points", (turn + theta) / 2, "rad")
    yield Answer("fast_centre", "that middle for a fast top", theta + predicted * sin(theta), "rad")
    steady = lowest_potential(released)
    yield Answer("steady_angle", "angle at which its potential is lowest", steady.tilt, "rad")
    yield Answer("released_frequency", "frequency of this nutation", 2 * pi / period, "rad/s")
    yield Answer(
        "harmonic_frequency",
        r"$\omega_n$ at that angle",
        small_frequency(top, steady.tilt, steady.phi_dot, omega3),
        "rad/s",
    )
    yield Table(
        "spins",
        r"Let go at rest with other spins; $\omega_n$ at the lowest potential",
        (
            r"$\omega_3$ (rad/s)",
            "frequency (rad/s)",
            r"$\omega_n$ (rad/s)",
            r"$|\lambda_3\omega_3|/\lambda_1$ (rad/s)",
            "amplitude (rad)",
            r"$\lambda_1MgR \sin\theta/(\lambda_3\omega_3)^2$ (rad)",
        ),
        tuple(_released(top, theta, factor * omega3) for factor in (1, 2, 4, 8)),
    )
    turned = released.motion.integrate(period / 2, **TIGHT)
    there = abs(float(turned.theta[0]) - turn)
    yield Measure("its turning point half a period later, integrated (rad)", there, 1e-9)
    slowed = abs(float(turned.theta_dot[0])) / (2 * pi / period * (turn - theta))
    yield Measure(r"$\dot\theta$ there over that of a small nutation, integrated", slowed, 1e-9)


def _released(top: HeavyTop, tilt: float, spin: float) -> tuple[float, ...]:
    """A row of the table: spin, frequencies and amplitudes of a top that is let go at rest."""
    released = Start(top, tilt, 0.0, spin)
    steady = lowest_potential(released)
    return (
        spin,
        2 * pi / released.motion.nutation_period,
        small_frequency(top, steady.tilt, steady.phi_dot, spin),
        top.lambda3 * abs(spin) / top.lambda1,
        (released.other.tilt - tilt) / 2,
        smallness(top, spin) * sin(tilt),
    )


def changes(top: HeavyTop, tilt: float, spin: float) -> list[tuple[float, str]]:
    """The φ̇ at which the path changes, ascending, and what it is there, for a start with θ̇ = 0."""
    momentum = top.lambda3 * spin
    found = [
        (-momentum / (top.lambda1 * 2 * sin(tilt / 2) ** 2), "through the hanging position"),
        (0.0, "cusps"),
    ]
    upright = momentum / (top.lambda1 * 2 * cos(tilt / 2) ** 2)
    second = 2 * top.weight[2] / momentum
    if abs(second) < abs(upright):  # else it has not the energy to get there
        found += [(upright, "through the upright position"), (second, "cusps")]
    if abs(spin) > top.smallest_spin(tilt):
        rates = top.steady_precession(tilt, spin)
        found += [(rate, "steady") for rate in rates if rate not in (inf, -inf)]
    return sorted(found)


def kind(start: Start) -> str:
    """Waves or loops, by the φ̇ at the start; on a boundary what is there."""
    top, rate = start.top, start.phi_dot
    momentum = top.lambda3 * start.spin
    for boundary, name in changes(top, start.tilt, start.spin):
        if abs(rate - boundary) <= 1e-14 * abs(boundary):
            return "through the vertical" if name.startswith("through") else name
    towards = start.tilt if rate * momentum < 0 else pi - start.tilt
    within = abs(top.lambda1 * rate) * 2 * sin(towards / 2) ** 2 < abs(momentum)
    turns_back = rate * (momentum * rate - 2 * top.weight[2]) * momentum > 0
    return "loops" if within and turns_back else "waves"


def seen(motion: TopMotion, period: float) -> str:
    """Waves or loops, by the signs of φ̇ along the integrated path of one nutation."""
    rates = motion.integrate(np.linspace(0, period, 401), **TIGHT).phi_dot
    largest = float(np.max(np.abs(rates)))
    if np.min(np.abs(rates)) < 1e-9 * largest:
        return "cusps"
    return "loops" if rates.min() < 0 < rates.max() else "waves"


@exercise(
    "waves-cusps-loops",
    "Waves, cusps, loops",
    section="3.5.4",
    asks="“the azimuthal progress of the top … becomes more complicated”",
    statement=r"A top starts at $\theta$ with the spin $\omega_3$ and with $\dot\theta = 0$. For "
    r"which $\dot\phi$ does its axis draw waves, for which loops, and what is drawn at "
    r"the boundaries between them? For which $\dot\phi$ does the axis sink at first, for "
    "which does it rise?\n\nFind the turning points of $\\theta$ and $\\dot\\phi$ there "
    r"for the given $\dot\phi$, and how far the axis turns about the vertical from one "
    "nutation to the next.",
    claims=(azimuth, turning_points, waves_or_loops),
    parameters=(
        *HEAVY_TOP,
        INCLINED,
        Parameter("phi_dot", 0.2, r"$\dot\phi$ at the start", "rad/s"),
        SPIN,
    ),
    figure="paths",
    text="exercises/waves_cusps_loops",
)
def waves_cusps_loops(
    theta: float, phi_dot: float, omega3: float, **shape: float
) -> Iterator[Outcome]:
    """Which path it is follows from the boundaries just derived; the other turning point, the
    period and the precession are those of the exact motion, in elliptic functions. An integrated
    path agrees."""
    top = heavy_top(**shape)
    if omega3 == 0:
        raise RigidtopError("omega3 = 0: without spin φ̇ never changes its sign")
    start = Start(top, theta, phi_dot, omega3)
    drawn = kind(start)
    if drawn == "through the vertical":
        raise RigidtopError(
            f"phi_dot = {phi_dot:g} takes the axis through the vertical, where φ has no value"
        )
    motion, other = start.motion, start.other
    period, precession = motion.nutation_period, motion.precession_per_period
    rows, wrong = _between(top, theta, omega3)
    yield Table(
        "boundaries",
        r"The path for each $\dot\phi$ at the start",
        (
            r"from $\dot\phi$ (rad/s)",
            r"to $\dot\phi$ (rad/s)",
            "path",
            "at first the axis",
            "at the end of the range",
        ),
        tuple(rows),
    )
    yield Answer("path", r"path for the given $\dot\phi$", drawn)
    yield Answer("at_first", "at first the axis", start.first)
    yield Answer("turn", r"$\theta$ at the other turning point", other.tilt, "rad")
    yield Answer("turn_rate", r"$\dot\phi$ at the other turning point", other.phi_dot, "rad/s")
    yield Answer("period", "time from one nutation to the next", period, "s")
    yield Answer("precession", r"by how much $\phi$ grows in that time", precession, "rad")
    yield Answer("mean_rate", r"mean $\dot\phi$", precession / period, "rad/s")
    yield Measure(
        r"$\dot\phi$ chosen between the boundaries with another path in closed form", wrong, 0.5
    )
    yield Measure("path as in closed form", float(motion.regime != drawn), 0.5)
    if drawn != "steady":
        by_signs = float(seen(motion, period) != drawn)
        yield Measure(r"path by the signs of $\dot\phi$, integrated", by_signs, 0.5)
    path = motion.integrate([period / 2, period], **TIGHT)
    errors = np.abs(path.theta - [other.tilt, theta])
    yield Measure(
        r"$\theta$ half a period later, and a whole one, integrated "
        "(rad)",
        float(errors.max()),
        1e-9,
    )
    scale = max(abs(phi_dot), abs(other.phi_dot), 1.0)
    error = abs(float(path.phi_dot[0]) - other.phi_dot)
    yield Measure(r"$\dot\phi$ half a period later, integrated (rad/s)", error, 1e-7 * scale)
    error = abs(float(path.phi[1]) - precession)
    yield Measure(
        r"$\phi$ a period later, integrated (rad)", error, 1e-9 * max(1.0, abs(precession))
    )


def _between(
    top: HeavyTop, tilt: float, spin: float
) -> tuple[list[tuple[float | str, ...]], float]:
    """Every interval of φ̇ with its path, and how many closed forms have another one."""
    found = changes(top, tilt, spin)
    rates = [rate for rate, _ in found]
    beyond = (rates[-1] - rates[0]) / 2
    samples = [
        rates[0] - beyond,
        *((a + b) / 2 for a, b in pairwise(rates)),
        rates[-1] + beyond,
    ]
    rows: list[tuple[float | str, ...]] = []
    wrong = 0
    lower: list[float | str] = [r"$-\infty$", *rates]
    upper: list[float | str] = [*rates, r"$\infty$"]
    there = [*(name for _, name in found), "–"]
    for sample, low, high, what in zip(samples, lower, upper, there, strict=True):
        start = Start(top, tilt, sample, spin)
        rows.append((low, high, kind(start), start.first, what))
        wrong += start.motion.regime != kind(start)
    return rows, float(wrong)


EXERCISES: tuple[Exercise, ...] = (
    small_nutation,
    waves_cusps_loops,
)
"""In the order of the notes."""
