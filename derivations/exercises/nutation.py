"""Section 3.5.4: small nutation; waves, cusps and loops."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from math import acos, asin, cos, inf, pi, sin, sqrt
from typing import Any

import numpy as np
import sympy
from scipy.integrate import quad
from scipy.optimize import brentq
from sympy import Expr, Symbol

from rigidtop.derivations.nutation import azimuth, nutation
from rigidtop.derivations.printed import printed, worked
from rigidtop.errors import RigidtopError
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Exercise, Outcome, Table, exercise
from rigidtop.proof.page import Evidence, Formal, Measure, claim
from rigidtop.theory import symbols as s
from rigidtop.theory import top as theory
from rigidtop.theory.trig import reduce_ratio

from .bodies import HEAVY_TOP, SPIN, TILT, heavy_top, smallness

INCLINED = replace(TILT, least=0.01, most=3.1)
"""Well away from both verticals, where a small swing is one in θ."""

TIGHT: Any = {"rtol": 1e-12, "atol": 1e-14}


def from_turning_point(momenta: Mapping[Symbol, Expr]) -> Expr:
    """θ̇² of a top that has θ̇ = 0 at θᵢ, with these p_φ and p_ψ (rad²/s²)."""
    potential = theory.top_effective_potential()
    spent = potential.subs(s.theta, s.theta_i) - potential
    return 2 * spent.subs(momenta, simultaneous=True) / s.lambda1


def momenta_at_start() -> dict[Symbol, Expr]:
    """p_φ and p_ψ of a top that is started at θᵢ with φ̇ᵢ and ω₃."""
    rates = {s.psidot: s.omega3 - s.phidot_i * sympy.cos(s.theta), s.phidot: s.phidot_i}
    _, p_vertical, p_axis = theory.symmetric_momenta().subs(rates)
    return {s.p_phi: p_vertical.expand().subs(s.theta, s.theta_i), s.p_psi: p_axis.expand()}


def first_shift(turning: Expr, start: Expr) -> Expr:
    """How far a root θ of `turning` lies from `start`, its place at g = 0, to first order in g."""
    slope = -turning.diff(s.g) / turning.diff(s.theta)
    return reduce_ratio(s.g * slope.subs(s.g, 0).subs(s.theta, start))


@claim(
    "released-at-rest",
    "A top let go at $θᵢ$ with $𝛚$ along $e₃$ turns back where, and swings how far.",
)
def released_at_rest() -> Iterator[Evidence]:
    """The energy with $p_φ = p_ψ cos θᵢ$; the first factor is the release, the second the turn.

    For small $MgR/(λ₃ω₃)²$ the turn is at $θᵢ + 2A$, so that the axis swings by $A$ about an angle
    that much below the release.
    """
    swing = worked.of("released-at-rest", r"\lambda_1^2(\dot\theta\sin\theta)^2")
    amplitude = printed(r"(\lambda_3\omega_3)^2A = \lambda_1MgR\sin\theta_i")
    rate = from_turning_point({x: p.subs(s.phidot_i, 0) for x, p in momenta_at_start().items()})
    turning = reduce_ratio(rate / (sympy.cos(s.theta_i) - sympy.cos(s.theta)))
    yield Formal(swing, {s.thetadot: sympy.sqrt(rate)}, reason="By energy.")
    yield Formal(
        amplitude,
        {s.A: first_shift(turning, s.theta_i) / 2},
        reason="Half the way to the other turning point, to first order in $g$.",
    )


@claim("turning-points", "The turning points of $θ$ are two roots of a cubic in $cos θ$.")
def turning_points() -> Iterator[Evidence]:
    """The energy with the momenta of (3.55) and (3.56), multiplied by $sin²θ$.

    Of a top started at $θᵢ$ with $θ̇ = 0$ one root is known, and a quadratic is left. The third
    root is no angle: for $cos θ ≥ 1$ the cubic is positive again at last.
    """
    cubic, *_, started = worked.lines("turning-points")
    total = theory.symmetric_hamiltonian().subs(s.p_theta, s.lambda1 * s.thetadot)
    height = s.M * s.g * s.R * sympy.cos(s.theta)
    yield Formal(cubic, {s.T: total - height, s.V: height}, reason="By energy.")
    momenta = momenta_at_start()
    yield Formal(
        started,
        {s.thetadot: sympy.sqrt(from_turning_point(momenta)), **momenta},
        reason="With $θ̇ = 0$, $φ̇ᵢ$ and $ω₃$ at $θᵢ$.",
    )


def rate_on_the_vertical(side: int) -> Expr:
    """θ̇² upright (`side` 1) or hanging (−1) of a top started with p_φ = ±p_ψ (rad²/s²)."""
    momenta, cosine = momenta_at_start(), sympy.cos(s.theta)
    [start] = sympy.solve(momenta[s.p_phi] - side * momenta[s.p_psi], s.phidot_i, simplify=False)
    rate = from_turning_point(momenta).subs(s.phidot_i, start)
    # Regular there once sin² is written as (1 − cos)(1 + cos).
    return sympy.cancel(rate.subs(sympy.sin(s.theta) ** 2, 1 - cosine**2)).subs(cosine, side)


@claim(
    "waves-or-loops", "At which $φ̇$ the path changes from waves to loops, for a start with $θ̇ = 0$."
)
def waves_or_loops() -> Iterator[Evidence]:
    """The axis sinks where (3.57) with $φ̇$ for $Ω$ is positive, and rises where it is negative.

    For $cos θ > 0$ it rises between the two roots, and nowhere below the spin at which there are
    any; for $cos θ < 0$ it rises outside of them. $φ̇$ vanishes on the way, in loops, where $θ̇²$
    comes out positive there; at $φ̇ = 0$ it vanishes at a turning point, in cusps, and if
    $(λ₃ω₃)²$ exceeds $2λ₁MgR(1 + cos θ)$ also at $φ̇ = 2MgR/(λ₃ω₃)$. Where $p_φ = −p_ψ$ the axis
    passes straight down, and where $p_φ = p_ψ$ through the upright if by the same condition it has
    the energy to get there; beyond that $p_φ/p_ψ$ is no cosine and there are waves again.
    """
    sinks, *_, reached, upright, hanging = worked.lines("waves-or-loops")[:8]
    upwards = printed(
        r"\lambda_1^2(1 + \cos\theta_i)\dot\theta^2 = "
        r"(1 - \cos\theta_i)((\lambda_3\omega_3)^2 - 2\lambda_1MgR(1 + \cos\theta_i))"
    )
    downwards = printed(
        r"\lambda_1^2(1 - \cos\theta_i)\dot\theta^2 = "
        r"(1 + \cos\theta_i)((\lambda_3\omega_3)^2 + 2\lambda_1MgR(1 - \cos\theta_i))"
    )
    spinning = {s.psidot: s.omega3 - s.phidot * sympy.cos(s.theta), s.thetadot: 0}
    yield Formal(
        sinks,
        {s.thetaddot: theory.symmetric_top_accelerations()[0].subs(spinning)},
        reason="(3.54) with $ω₃$: down where it is positive.",
    )
    momenta = momenta_at_start()
    # Where φ̇ vanishes, only the height and θ̇ are left of the energy, besides the spin.
    rest = momenta[s.p_phi] / momenta[s.p_psi]
    kinetic = s.lambda1 * s.phidot_i**2 * sympy.sin(s.theta_i) ** 2 / 2
    gained = kinetic + s.M * s.g * s.R * (sympy.cos(s.theta_i) - rest)
    yield Formal(
        reached,
        {s.thetadot: sympy.sqrt(2 * gained / s.lambda1), **momenta},
        reason="$θ̇²$ at $cos θ₀ = p_φ/p_ψ$, where $φ̇$ vanishes.",
    )
    yield Formal(upright, momenta, reason="Upright only with $p_φ = p_ψ$,")
    yield Formal(
        upwards,
        {s.thetadot: sympy.sqrt(rate_on_the_vertical(1))},
        reason="where $θ̇²$ comes out positive there;",
    )
    yield Formal(hanging, momenta, reason="hanging only with $p_φ = −p_ψ$,")
    yield Formal(
        downwards, {s.thetadot: sympy.sqrt(rate_on_the_vertical(-1))}, reason="where it always is."
    )


@dataclass(frozen=True)
class Swing:
    """The motion of θ of a top started with θ̇ = 0, by a way that no elliptic function is used on.

    With u = cos θ it is u̇² = 2(MgR/λ₁)(u₀ − u)(u − u₀ − gap)(u₀ + far − u), u₀ at the start.
    """

    top: HeavyTop
    tilt: float
    phi_dot: float
    spin: float

    @property
    def steepness(self) -> float:
        """(3.57) with φ̇ for Ω: λ₁θ̈/sin θ at the start (N m); positive where the axis sinks."""
        top, rate = self.top, self.phi_dot
        square, linear = top.lambda1 * cos(self.tilt), top.lambda3 * self.spin
        return (square * rate - linear) * rate + top.weight[2]

    @cached_property
    def _roots(self) -> tuple[float, float]:
        """cos θ at the other turning point, and at the root beyond 1, less cos θ at the start."""
        u, sine = cos(self.tilt), sin(self.tilt)
        w = self.top.lambda1 * self.top.weight[2]
        spin, turn = self.top.lambda3 * self.spin, self.top.lambda1 * self.phi_dot * sine
        # 2w x² − linear x − constant = 0 for x = u − u₀, without differences of large numbers.
        linear = spin**2 + turn**2 - 4 * w * u
        constant = 2 * self.top.lambda1 * sine**2 * self.steepness
        square = linear**2 + 8 * w * constant
        if square <= 1e-14 * linear**2:  # these two are one, the upright, to half of all digits
            raise RigidtopError(
                f"phi_dot = {self.phi_dot:g} takes the axis so slowly so close to the upright that "
                "its other turning point is lost in rounding: change it or omega3 a little"
            )
        root = sqrt(square)
        if linear >= 0:
            return -2 * constant / (linear + root), (linear + root) / (4 * w)
        return (linear - root) / (4 * w), 2 * constant / (root - linear)

    @cached_property
    def _nearer(self) -> tuple[int, float, float]:
        """±1, the vertical on the other turning point's side, 1 ∓ cos θ there, and p_φ ∓ p_ψ.

        Without differences of large numbers, also where the axis almost passes through it.
        """
        side = 1 if self.gap > 0 else -1
        away = 2 * (sin(self.tilt / 2) if side == 1 else cos(self.tilt / 2)) ** 2
        top, spin = self.top, self.top.lambda3 * self.spin
        barrier = away * (top.lambda1 * (2 - away) * self.phi_dot - side * spin)
        there = away - abs(self.gap)
        third = abs(side * self._roots[1] - away)  # by how much that root is beyond the vertical
        if there < third:
            # From u̇² = −(p_φ ∓ p_ψ)²/λ₁² at the vertical, the product of all three.
            there = barrier**2 / (2 * top.lambda1 * top.weight[2] * away * third)
        return side, there, barrier

    @property
    def gap(self) -> float:
        """cos θ at the other turning point less cos θ at the start."""
        return self._roots[0]

    @property
    def other(self) -> float:
        """θ at the other turning point (rad)."""
        side, there, _ = self._nearer
        tilt = 2 * asin(min(1.0, sqrt(there / 2)))
        return tilt if side == 1 else pi - tilt

    def _below(self, x: float) -> float:
        """u − u₀ at the phase x, which goes from π at the start to 0 at the other turning point."""
        return self.gap * cos(x / 2) ** 2

    def _slowness(self, x: float) -> float:
        """dt/dx (s)."""
        far = self._roots[1] - self._below(x)
        return 1 / sqrt(2 * self.top.weight[2] / self.top.lambda1 * far)

    def rate(self, x: float) -> float:
        """φ̇ at the phase x (rad/s), from p_φ and p_ψ."""
        side, there, barrier = self._nearer
        away = there + abs(self.gap) * sin(x / 2) ** 2
        turn = barrier + side * self.top.lambda3 * self.spin * away
        return turn / (self.top.lambda1 * away * (2 - away))

    def over_a_period(self, integrand: Callable[[float], float], error: float = 0.0) -> float:
        """2∫ integrand dt from one turning point to the other, to 1e-11 of it or to `error`."""
        found, _ = quad(
            lambda x: integrand(x) * self._slowness(x), 0, pi, epsabs=error, epsrel=1e-11, limit=400
        )
        return 2 * float(found)

    @property
    def period(self) -> float:
        """The time from a turning point to the next of its kind (s)."""
        return self.over_a_period(lambda x: 1.0)

    @property
    def precession(self) -> float:
        """By how much φ grows in that time (rad)."""
        # Two turns almost through a vertical may cancel each other.
        return self.over_a_period(self.rate, error=1e-11)


def small_frequency(top: HeavyTop, tilt: float, phi_dot: float, spin: float) -> float:
    """√(U″/λ₁) at a steady precession (rad/s)."""
    square = (
        (top.lambda3 * spin) ** 2
        - 4 * top.lambda1 * top.weight[2] * cos(tilt)
        + (top.lambda1 * phi_dot * sin(tilt)) ** 2
    )
    return sqrt(square) / top.lambda1


def lowest_potential(swing: Swing) -> tuple[float, float]:
    """θ at which a motion with the momenta of this one could be steady, and Ω there."""

    def state(x: float) -> Swing:
        tilt = acos(cos(swing.tilt) + swing.gap * cos(x / 2) ** 2)
        return replace(swing, tilt=tilt, phi_dot=swing.rate(x))

    phase = float(brentq(lambda x: state(x).steepness, 0, pi, xtol=1e-14))
    return state(phase).tilt, state(phase).phi_dot


@exercise(
    "small-nutation",
    "Frequency and amplitude of the nutation",
    section="3.5.4",
    asks="“small oscillations around the value where it could be constant”",
    statement="A top precesses almost steadily. With which frequency does $θ$ oscillate about the "
    "angle at which it could be constant, and what does that become for large $ω₃$?\n\n"
    "The same top is let go at $θ$ with its axis at rest. How far does the axis swing, and about "
    "which angle? How good are the formulas for fast tops when the top is not that fast?",
    claims=(nutation, released_at_rest),
    parameters=(*HEAVY_TOP, INCLINED, SPIN),
    figure="effective-potential",
    text="exercises/small_nutation",
)
def small_nutation(theta: float, omega3: float, **shape: float) -> Iterator[Outcome]:
    """The formulas for small nutation and for fast tops stand beside the period and the turning
    points in closed form, and beside the same by quadrature and by integration."""
    top = heavy_top(**shape)
    slow, _ = top.steady_precession(theta, omega3)
    if omega3 == 0:
        raise RigidtopError("omega3 = 0: a top that is let go at rest without spin falls over")
    frequency = small_frequency(top, theta, slow, omega3)
    yield Answer("slow", "rate $Ω₋$ of steady precession at $θ$", slow, "rad/s")
    yield Answer("frequency", "small nutation about it, $√(U″/λ₁)$", frequency, "rad/s")
    yield Answer(
        "fast_frequency",
        "the same for a fast top, $|λ₃ω₃|/λ₁$",
        top.lambda3 * abs(omega3) / top.lambda1,
        "rad/s",
    )
    kicked = top.motion(theta=theta, theta_dot=1e-6 * frequency, phi_dot=slow, omega3=omega3)
    error = abs(2 * pi / kicked.nutation_period / frequency - 1)
    yield Measure("frequency of a nutation of $10⁻⁶$ rad in closed form, relative", error, 1e-8)

    swing, motion = Swing(top, theta, 0.0, omega3), top.motion(theta=theta, omega3=omega3)
    period, predicted = motion.nutation_period, smallness(top, omega3)
    yield Answer("turn", "let go at rest: $θ$ of the other turning point", swing.other, "rad")
    yield Answer("amplitude", "half the way to it", (swing.other - theta) / 2, "rad")
    yield Answer(
        "fast_amplitude", "for a fast top, $λ₁MgR sin θ/(λ₃ω₃)²$", predicted * sin(theta), "rad"
    )
    yield Answer("centre", "middle between the turning points", (swing.other + theta) / 2, "rad")
    yield Answer("fast_centre", "for a fast top", theta + predicted * sin(theta), "rad")
    steady, precession = lowest_potential(swing)
    yield Answer("steady_angle", "angle at which its potential is lowest", steady, "rad")
    yield Answer("released_frequency", "frequency of this nutation", 2 * pi / period, "rad/s")
    yield Answer(
        "harmonic_frequency",
        "$√(U″/λ₁)$ at that angle",
        small_frequency(top, steady, precession, omega3),
        "rad/s",
    )
    yield Table(
        "spins",
        "Let go at rest with other spins",
        (
            "$ω₃$ (rad/s)",
            "frequency (rad/s)",
            "$√(U″/λ₁)$ (rad/s)",
            "$|λ₃ω₃|/λ₁$ (rad/s)",
            "amplitude (rad)",
            "$λ₁MgR sin θ/(λ₃ω₃)²$ (rad)",
        ),
        tuple(_released(top, theta, factor * omega3) for factor in (1, 1.5, 2, 4, 8, 16)),
    )
    yield Measure("its period by quadrature, relative", abs(swing.period / period - 1), 1e-10)
    closed = motion.turning_points[1]
    yield Measure("its turning point in closed form (rad)", abs(closed - swing.other), 1e-10)
    turned = motion.integrate(swing.period / 2, **TIGHT)
    there = abs(float(turned.theta[0]) - swing.other)
    yield Measure("its turning point half a period later, integrated (rad)", there, 1e-9)


def _released(top: HeavyTop, tilt: float, spin: float) -> tuple[float, ...]:
    """A row of the table: spin, frequencies and amplitudes of a top that is let go at rest."""
    swing = Swing(top, tilt, 0.0, spin)
    steady, precession = lowest_potential(swing)
    return (
        spin,
        2 * pi / top.motion(theta=tilt, omega3=spin).nutation_period,
        small_frequency(top, steady, precession, spin),
        top.lambda3 * abs(spin) / top.lambda1,
        (swing.other - tilt) / 2,
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


def kind(swing: Swing) -> str:
    """Waves or loops, by the φ̇ at the start; on a boundary what is there."""
    top, rate = swing.top, swing.phi_dot
    momentum = top.lambda3 * swing.spin
    for boundary, name in changes(top, swing.tilt, swing.spin):
        if abs(rate - boundary) <= 1e-14 * abs(boundary):
            return "through the vertical" if name.startswith("through") else name
    towards = swing.tilt if rate * momentum < 0 else pi - swing.tilt
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
    asks="“the azimuthal progress of the top becomes more complicated”",
    statement="A top starts at $θ$ with the spin $ω₃$ and with $θ̇ = 0$. For which $φ̇$ does its "
    "axis draw "
    "waves, for which loops, and what is drawn at the boundaries between them? For which $φ̇$ "
    "does the axis sink at first, for which does it rise?\n\nFind the turning points of $θ$ and "
    "$φ̇$ there for the given $φ̇$, and how far the axis turns about the vertical from one "
    "nutation to the next.",
    claims=(azimuth, turning_points, waves_or_loops),
    parameters=(
        *HEAVY_TOP,
        INCLINED,
        Parameter("phi_dot", 0.2, "$φ̇$ at the start", "rad/s"),
        SPIN,
    ),
    figure="paths",
    text="exercises/waves_cusps_loops",
)
def waves_cusps_loops(
    theta: float, phi_dot: float, omega3: float, **shape: float
) -> Iterator[Outcome]:
    """The turning points are roots of the cubic, one of which is the start; period and precession
    are integrals between them by quadrature. The closed form in elliptic functions and the
    integrated path are compared with all of it."""
    top = heavy_top(**shape)
    if omega3 == 0:
        raise RigidtopError("omega3 = 0: without spin φ̇ never changes its sign")
    swing = Swing(top, theta, phi_dot, omega3)
    drawn = kind(swing)
    if drawn == "through the vertical":
        raise RigidtopError(
            f"phi_dot = {phi_dot:g} takes the axis through the vertical, where φ has no value"
        )
    motion = top.motion(theta=theta, phi_dot=phi_dot, omega3=omega3)
    rows, wrong = _between(top, theta, omega3)
    yield Table(
        "boundaries",
        "For which $φ̇$ the path is what",
        ("from $φ̇$ (rad/s)", "to $φ̇$ (rad/s)", "path", "at first the axis", "at the second $φ̇$"),
        tuple(rows),
    )
    yield Answer("path", "path for the given $φ̇$", drawn)
    yield Answer("at_first", "at first the axis", _first(swing))
    yield Answer("turn", "$θ$ at the other turning point", swing.other, "rad")
    yield Answer("turn_rate", "$φ̇$ at the other turning point", swing.rate(0.0), "rad/s")
    yield Answer("period", "time from one nutation to the next", swing.period, "s")
    yield Answer("precession", "by how much $φ$ grows in that time", swing.precession, "rad")
    yield Answer("mean_rate", "mean $φ̇$", swing.precession / swing.period, "rad/s")
    yield Measure("$φ̇$ chosen between the boundaries with another path in closed form", wrong, 0.5)
    yield Measure("path as in closed form", float(motion.regime != drawn), 0.5)
    ends = sorted((theta, swing.other))
    error = max(abs(a - b) for a, b in zip(motion.turning_points, ends, strict=True))
    yield Measure("turning points in closed form (rad)", error, 1e-9)
    error = abs(motion.nutation_period / swing.period - 1)
    yield Measure("period in closed form, relative", error, 1e-9)
    error = abs(motion.precession_per_period - swing.precession)
    yield Measure("precession in closed form (rad)", error, 1e-9 * max(1.0, abs(swing.precession)))
    if drawn != "steady":
        by_signs = float(seen(motion, swing.period) != drawn)
        yield Measure("path by the signs of $φ̇$, integrated", by_signs, 0.5)
    path = motion.integrate(swing.period / 2, **TIGHT)
    error = abs(float(path.phi_dot[0]) - swing.rate(0.0))
    scale = max(abs(phi_dot), abs(swing.rate(0.0)), 1.0)
    yield Measure("$φ̇$ half a period later, integrated (rad/s)", error, 1e-7 * scale)


def _first(swing: Swing) -> str:
    if abs(swing.gap) < 1e-15:
        return "stays"
    return "sinks" if swing.steepness > 0 else "rises"


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
    lower: list[float | str] = ["$−∞$", *rates]
    upper: list[float | str] = [*rates, "$∞$"]
    there = [*(name for _, name in found), "–"]
    for sample, low, high, what in zip(samples, lower, upper, there, strict=True):
        swing = Swing(top, tilt, sample, spin)
        rows.append((low, high, kind(swing), _first(swing), what))
        wrong += top.motion(theta=tilt, phi_dot=sample, omega3=spin).regime != kind(swing)
    return rows, float(wrong)


EXERCISES: tuple[Exercise, ...] = (
    small_nutation,
    waves_cusps_loops,
)
"""In the order of the notes."""
