"""Which motions are computed: families on and near every special case, drawn from a seed.

"Near" is a signed relative distance, its magnitude log-uniform between 1e-16 and 1e-2; the motions
exactly on a special case (as exactly as floats can say it) are mixed in or have their own family.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

Floats = NDArray[np.float64]

SEED = 1751
TOP_INPUTS = [
    "lambda1", "lambda3", "M", "R", "g",
    "theta", "theta_dot", "phi", "phi_dot", "psi", "omega3",
]  # fmt: skip
BODY_INPUTS = [
    "lambda1", "lambda2", "lambda3", "omega1", "omega2", "omega3", "q0", "q1", "q2", "q3",
]  # fmt: skip
PER_TOP_FAMILY = 30
PER_BODY_FAMILY = 36


@dataclass
class TopCase:
    """The inputs of a heavy top, by name (kg, m, s, rad)."""

    lambda1: float
    lambda3: float
    M: float
    R: float
    g: float
    theta: float = 1.0
    theta_dot: float = 0.0
    phi: float = 0.0
    phi_dot: float = 0.0
    psi: float = 0.0
    omega3: float = 0.0

    @property
    def weight(self) -> float:
        return self.M * self.g * self.R

    @property
    def swing(self) -> float:
        """√(MgR/λ₁), the rate of small swings about the hanging top (rad/s)."""
        return math.sqrt(self.weight / self.lambda1)

    @property
    def spin(self) -> float:
        """λ₃ω₃/λ₁, the rate of nutation of a fast top (rad/s)."""
        return self.lambda3 * self.omega3 / self.lambda1

    @property
    def rate(self) -> float:
        """A bound for the rates of the axis (rad/s); 1 for a body at rest without weight."""
        across = math.hypot(self.theta_dot, self.phi_dot * math.sin(self.theta))
        return abs(self.spin) + self.swing + across or 1.0

    def inputs(self) -> list[float]:
        return [float(getattr(self, name)) for name in TOP_INPUTS]


def distance(rng: Generator, low: float = -16.0, high: float = -2.0) -> float:
    return float(rng.choice([-1, 1]) * 10 ** rng.uniform(low, high))


def log_uniform(rng: Generator, low: float, high: float) -> float:
    return float(math.exp(rng.uniform(math.log(low), math.log(high))))


def some_top(rng: Generator) -> TopCase:
    """A body with sizes near 1, φ and ψ anywhere or 0, and a spin of a few λ₁/λ₃ swings."""
    lambda1 = log_uniform(rng, 0.3, 3.0)
    lambda3 = lambda1 * rng.uniform(0.1, 1.9)
    mass = log_uniform(rng, 0.3, 3.0)
    arm = math.sqrt(rng.uniform(0.01, 0.98) * (lambda1 - lambda3 / 2) / mass)
    case = TopCase(lambda1, lambda3, mass, arm, rng.choice([9.81, 1.0, 10 * rng.random()]))
    case.theta = math.acos(rng.uniform(-0.95, 0.95))
    if rng.random() < 0.7:
        case.phi, case.psi = rng.uniform(-4, 4, 2)
    case.omega3 = _spin(case, rng.uniform(0.3, 5.0) * rng.choice([-1, 1]))
    return case


def _spin(case: TopCase, ratio: float) -> float:
    """ω₃ of `ratio` swings per nutation: the upright top sleeps from a ratio of 2 on."""
    return ratio * (case.swing or 1.0) * case.lambda1 / case.lambda3


def generic(case: TopCase, rng: Generator) -> None:
    case.theta_dot, case.phi_dot = rng.normal(0, case.rate, 2)


def waves(case: TopCase, rng: Generator) -> None:
    case.phi_dot = _drift(case) * rng.uniform(0.2, 3.0)


def loops(case: TopCase, rng: Generator) -> None:
    case.phi_dot = -_drift(case) * rng.uniform(0.2, 5.0)


def _drift(case: TopCase) -> float:
    """MgR/(λ₃ω₃), the slow precession of a fast top (rad/s)."""
    return case.swing**2 / case.spin


def cusps(case: TopCase, rng: Generator) -> None:
    case.omega3 = _spin(case, rng.uniform(0.5, 8.0))


def near_cusps(case: TopCase, rng: Generator) -> None:
    case.theta_dot, case.phi_dot = distance(rng) * case.rate, distance(rng) * case.rate


def _steady(case: TopCase, rng: Generator, fast: bool) -> None:
    """The roots of (λ₁ cos θ)Ω² − (λ₃ω₃)Ω + MgR = 0."""
    cosine = math.cos(case.theta)
    least = 2 * math.sqrt(max(cosine, 0.0))
    case.omega3 = _spin(case, (least + log_uniform(rng, 1e-3, 5.0)) * rng.choice([-1, 1]))
    spin = case.spin
    root = math.sqrt(max(spin**2 - 4 * cosine * case.swing**2, 0.0))
    larger = (spin + math.copysign(root, spin)) / 2
    case.phi_dot = larger / cosine if fast else case.swing**2 / larger


def steady_slow(case: TopCase, rng: Generator) -> None:
    _steady(case, rng, fast=False)


def steady_fast(case: TopCase, rng: Generator) -> None:
    _steady(case, rng, fast=True)


def near_steady_slow(case: TopCase, rng: Generator) -> None:
    _steady(case, rng, fast=False)
    _disturb(case, rng)


def near_steady_fast(case: TopCase, rng: Generator) -> None:
    _steady(case, rng, fast=True)
    _disturb(case, rng)


def _disturb(case: TopCase, rng: Generator) -> None:
    """Change θ̇, φ̇ or both by a small amount."""
    which = rng.integers(3)
    if which != 0:
        case.phi_dot += distance(rng) * (case.phi_dot or case.rate)
    if which != 1:
        case.theta_dot += distance(rng) * (case.theta_dot or case.rate)


def merging_steady(case: TopCase, rng: Generator) -> None:
    """Slow and fast precession nearly one: ω₃ at its smallest."""
    case.theta = rng.uniform(0.1, 1.4)
    near = distance(rng) if rng.random() < 0.7 else 0.0
    case.omega3 = _spin(case, 2 * math.sqrt(math.cos(case.theta)) * (1 + near))
    case.phi_dot = case.spin / (2 * math.cos(case.theta))
    if rng.random() < 0.5:
        _disturb(case, rng)


def _to_upright(case: TopCase, rng: Generator, excess: float) -> None:
    """p_φ = p_ψ, and at θ = 0 the energy is MgR + ½λ₃ω₃² + MgR `excess`."""
    ratio = rng.uniform(0.0, 1.9) * rng.choice([-1, 1])
    case.omega3 = _spin(case, ratio)
    # θ̇² of the asymptotic motion is positive where 1 + cos θ > ½ (ratio)².
    least = ratio**2 / 2 - 1
    cosine = rng.uniform(least + 0.05 * (1 - least), 0.98)
    case.theta = math.acos(cosine)
    case.phi_dot = case.spin / (1 + cosine)
    gain = 2 * case.swing**2 * (1 - cosine + excess)
    case.theta_dot = -math.sqrt(max(gain - (case.phi_dot * math.sin(case.theta)) ** 2, 0.0))
    case.theta_dot *= rng.choice([1, -1])


def asymptotic(case: TopCase, rng: Generator) -> None:
    _to_upright(case, rng, 0.0)


def near_asymptotic(case: TopCase, rng: Generator) -> None:
    _to_upright(case, rng, 0.0)
    _disturb(case, rng)


def through_upright(case: TopCase, rng: Generator) -> None:
    _to_upright(case, rng, log_uniform(rng, 0.01, 3.0))


def past_upright(case: TopCase, rng: Generator) -> None:
    _to_upright(case, rng, log_uniform(rng, 0.01, 3.0))
    case.phi_dot += distance(rng, -12.0, -3.0) * case.rate


def through_hanging(case: TopCase, rng: Generator) -> None:
    """p_φ = −p_ψ."""
    case.phi_dot = -case.spin / (1 - math.cos(case.theta))
    case.theta_dot = rng.normal(0, 0.5) * case.rate * rng.choice([0, 1])


def past_hanging(case: TopCase, rng: Generator) -> None:
    through_hanging(case, rng)
    case.phi_dot += distance(rng, -12.0, -3.0) * case.rate


def from_upright(case: TopCase, rng: Generator) -> None:
    case.theta = 0.0
    case.theta_dot = rng.normal(0, 1) * case.rate if rng.random() < 0.5 else distance(rng)
    case.phi_dot = rng.choice([0.0, rng.normal()])


def from_hanging(case: TopCase, rng: Generator) -> None:
    from_upright(case, rng)
    case.theta = math.pi


def upright(case: TopCase, rng: Generator) -> None:
    """No motion but the spin, below, at and above the threshold."""
    case.theta = 0.0
    case.omega3 = _spin(case, rng.choice([0.0, 0.5, 1.9, 2.0, 2 + distance(rng), 3.0, -4.0]))


def hanging(case: TopCase, rng: Generator) -> None:
    case.theta = math.pi
    case.omega3 = rng.choice([0.0, case.omega3])


def _tilted(case: TopCase, rng: Generator) -> None:
    case.theta = 10 ** rng.uniform(-12, -3)
    if rng.random() < 0.6:
        case.theta_dot = rng.normal() * case.theta * case.rate
        case.phi_dot = rng.normal() * case.rate


def sleeping(case: TopCase, rng: Generator) -> None:
    case.omega3 = _spin(case, rng.uniform(2.05, 5.0) * rng.choice([-1, 1]))
    _tilted(case, rng)


def waking(case: TopCase, rng: Generator) -> None:
    case.omega3 = _spin(case, rng.uniform(0.0, 1.95) * rng.choice([-1, 1]))
    _tilted(case, rng)


def threshold(case: TopCase, rng: Generator) -> None:
    near = distance(rng) if rng.random() < 0.7 else 0.0
    case.omega3 = _spin(case, 2 * (1 + near))
    _tilted(case, rng)


def near_hanging(case: TopCase, rng: Generator) -> None:
    tilt = 10 ** rng.uniform(-15, -3)
    case.theta = math.pi - tilt
    if rng.random() < 0.6:
        case.theta_dot = rng.normal() * tilt * case.rate
        case.phi_dot = rng.normal() * case.rate
    if rng.random() < 0.2:
        case.omega3 = 0.0


def near_upright(case: TopCase, rng: Generator) -> None:
    """Down to tilts that no cosine resolves, moving as fast as the top is tilted, or faster."""
    case.theta = 10 ** rng.uniform(-16, -2)
    case.theta_dot = distance(rng) * case.rate
    case.phi_dot = rng.normal() * case.rate


def spherical_pendulum(case: TopCase, rng: Generator) -> None:
    case.omega3 = 0.0
    case.theta_dot, case.phi_dot = rng.normal(0, 1, 2) * case.swing


def nearly_plane(case: TopCase, rng: Generator) -> None:
    """A pendulum that passes the vertical at tiny distances."""
    case.omega3 = distance(rng) * case.swing if rng.random() < 0.5 else 0.0
    case.theta_dot = rng.normal(0, 1.5) * case.swing
    case.phi_dot = distance(rng) * case.swing


def conical_pendulum(case: TopCase, rng: Generator) -> None:
    case.omega3 = 0.0
    case.theta = rng.uniform(1.6, 3.1)
    case.phi_dot = case.swing / math.sqrt(-math.cos(case.theta)) * rng.choice([-1, 1])
    if rng.random() < 0.6:
        _disturb(case, rng)


def swinging(case: TopCase, rng: Generator) -> None:
    case.omega3 = 0.0
    _swing(case, rng, rng.uniform(-0.9, 0.99))


def rotating(case: TopCase, rng: Generator) -> None:
    case.omega3 = 0.0
    _swing(case, rng, log_uniform(rng, 1.05, 20.0))


def pendulum_separatrix(case: TopCase, rng: Generator) -> None:
    case.omega3 = 0.0
    _swing(case, rng, 1.0 + (distance(rng) if rng.random() < 0.8 else 0.0))


def _swing(case: TopCase, rng: Generator, energy: float) -> None:
    """A plane pendulum of energy `energy` MgR: it swings below 1 and rotates above."""
    case.theta = math.acos(rng.uniform(-0.95, min(0.95 * energy, 0.95)))
    case.theta_dot = math.sqrt(max(2 * (energy - math.cos(case.theta)), 0.0)) * case.swing
    case.theta_dot *= rng.choice([-1, 1])


def from_rest(case: TopCase, rng: Generator) -> None:
    case.omega3 = 0.0


def at_rest_upright(case: TopCase, rng: Generator) -> None:
    """No spin, let go at or next to the upright or hanging position."""
    case.omega3 = 0.0
    tilt = 10 ** rng.uniform(-16, -1) if rng.random() < 0.8 else 0.0
    case.theta = tilt if rng.random() < 0.7 else math.pi - tilt


def no_gravity(case: TopCase, rng: Generator) -> None:
    case.g = 0.0
    _free(case, rng)


def no_arm(case: TopCase, rng: Generator) -> None:
    case.R = 0.0
    _free(case, rng)


def _free(case: TopCase, rng: Generator) -> None:
    generic(case, rng)
    which = rng.integers(6)
    if which == 0:
        case.omega3 = 0.0
    elif which == 1:
        case.theta_dot = case.phi_dot = 0.0
    elif which == 2:
        case.omega3 = case.theta_dot = case.phi_dot = 0.0
    elif which == 3:
        case.theta = rng.choice([0.0, math.pi, 1e-9])
    elif which == 4:  # e₃ passes through the vertical
        case.phi_dot = case.spin / (1 + math.cos(case.theta))


def little_gravity(case: TopCase, rng: Generator) -> None:
    spin = case.spin or 1.0
    case.g *= 10 ** rng.uniform(-16, -2)
    case.omega3 = spin * case.lambda1 / case.lambda3
    case.theta_dot, case.phi_dot = rng.normal(0, abs(spin), 2)
    if rng.random() < 0.3:
        case.theta_dot = case.phi_dot = 0.0


def slow_spin(case: TopCase, rng: Generator) -> None:
    case.omega3 = 10 ** rng.uniform(-12, -1) * rng.choice([-1, 1])
    case.theta_dot, case.phi_dot = rng.normal(0, 1, 2) * case.swing * rng.choice([0, 1])


def fast_spin(case: TopCase, rng: Generator) -> None:
    case.omega3 = 10 ** rng.uniform(1.5, 6) * rng.choice([-1, 1])
    which = rng.integers(4)
    if which == 1:
        case.phi_dot = _drift(case) * rng.normal(0, 3)
    elif which == 2:
        case.theta_dot, case.phi_dot = rng.normal(0, 1, 2)
    elif which == 3:
        case.theta_dot, case.phi_dot = rng.normal(0, 0.3, 2) * case.rate


def horizontal(case: TopCase, rng: Generator) -> None:
    case.theta = math.pi / 2
    if rng.random() < 0.6:
        generic(case, rng)
    elif rng.random() < 0.5:
        case.phi_dot = _drift(case)


def si_sizes(case: TopCase, rng: Generator) -> None:
    case.lambda1 = 10 ** rng.uniform(-5, 3)
    case.lambda3 = case.lambda1 * 10 ** rng.uniform(-3, 0.27)
    case.R = 10 ** rng.uniform(-2, 0.5)
    case.M = rng.uniform(0.01, 0.98) * (case.lambda1 - case.lambda3 / 2) / case.R**2
    case.g = rng.choice([9.81, 1.62])
    case.omega3 = _spin(case, 10 ** rng.uniform(-1, 1.5) * rng.choice([-1, 1]))
    case.theta_dot, case.phi_dot = rng.normal(0, 0.7, 2) * case.rate * rng.choice([0, 1])


def discs_and_rods(case: TopCase, rng: Generator) -> None:
    if rng.random() < 0.5:  # a disc: λ₃ = 2 (λ₁ − MR²)
        case.lambda3 = 2 * (case.lambda1 - case.M * case.R**2)
    else:
        case.lambda3 = case.lambda1 * 10 ** rng.uniform(-8, -1)
    case.omega3 = _spin(case, rng.uniform(0.0, 5.0) * rng.choice([-1, 1]))
    generic(case, rng)


def spheres(case: TopCase, rng: Generator) -> None:
    case.lambda3 = case.lambda1 * (1 + (distance(rng) if rng.random() < 0.5 else 0.0))
    case.R = math.sqrt(rng.uniform(0, 0.45) * case.lambda1 / case.M)
    case.omega3 = _spin(case, rng.uniform(0.3, 5.0) * rng.choice([-1, 1]))
    generic(case, rng)


def tiny_cones(case: TopCase, rng: Generator) -> None:
    """Steady precession, or nearly, about the vertical."""
    tilt = 10 ** rng.uniform(-10, -1)
    case.theta = tilt if rng.random() < 0.7 else math.pi - tilt
    _steady(case, rng, fast=bool(rng.random() < 0.5))
    if rng.random() < 0.5:
        _disturb(case, rng)


def tiniest_tilts(case: TopCase, rng: Generator) -> None:
    """Tilts and rates so small that their squares underflow."""
    case.theta = 10 ** rng.uniform(-200, -20)
    case.theta_dot = rng.normal() * case.theta * case.rate
    case.phi_dot = rng.normal() * case.rate
    case.omega3 = _spin(case, rng.choice([0.0, 1.0, 2.0, 3.0]))


def fast_past_upright(case: TopCase, rng: Generator) -> None:
    """A fast top whose axis passes through the vertical, or close by, above or below."""
    case.omega3 = 10 ** rng.uniform(1.5, 6) * rng.choice([-1, 1])
    below = rng.random() < 0.3
    case.theta = 10 ** rng.uniform(-6, 0.3)
    case.phi_dot = case.spin / (1 + math.cos(case.theta))
    if below:  # the same about the downward vertical
        case.theta, case.phi_dot = math.pi - case.theta, -case.phi_dot
    if rng.random() < 0.7:
        case.phi_dot *= 1 + distance(rng)
    if rng.random() < 0.3:
        case.theta_dot = rng.normal() * case.swing


def near_upright_separatrix(case: TopCase, rng: Generator) -> None:
    """Nearly asymptotic, and p_φ and p_ψ nearly equal too, in all proportions."""
    _to_upright(case, rng, distance(rng))
    case.phi_dot += distance(rng) * case.rate


def late(case: TopCase, rng: Generator) -> None:
    """Anything generic, at later times."""
    rng.choice(np.array([generic, waves, loops, cusps, spherical_pendulum, fast_spin]))(case, rng)


def mixture(case: TopCase, rng: Generator) -> None:
    """Every input special by itself."""
    near = float(rng.choice([0.0, distance(rng), 10 ** rng.uniform(-3, 0)]))
    case.theta = abs(float(rng.choice([0.0, math.pi / 2, math.pi, 1.0])) - abs(near))
    case.omega3 = float(rng.choice([0.0, distance(rng), 1.0, -2.0, 2 + distance(rng), 30.0, 1e4]))
    case.omega3 = _spin(case, case.omega3)
    case.theta_dot = float(rng.choice([0.0, distance(rng), 1.0, -2.0])) * case.swing
    rates = [
        0.0,
        distance(rng),
        1.0,
        0.5 * case.spin,
        case.spin / max(1 + math.cos(case.theta), 1e-2),
    ]
    case.phi_dot = float(rng.choice(rates)) * (1 + float(rng.choice([0.0, distance(rng)])))


def triple_root(case: TopCase, rng: Generator) -> None:
    """At the threshold of the sleeping top, as its neighbours precess: the three roots meet."""
    near = distance(rng, -16.0, -1.0) if rng.random() < 0.8 else 0.0
    case.omega3 = _spin(case, 2 * (1 + near) * rng.choice([-1, 1]))
    case.theta = log_uniform(rng, 0.03, 0.15)
    if rng.random() < 0.3:
        case.theta = 10 ** rng.uniform(-13, -1)
    case.phi_dot = case.spin / 2
    if rng.random() < 0.9:
        case.phi_dot *= 1 + distance(rng, -9.0, -1.0)
    if rng.random() < 0.8:
        case.theta_dot = distance(rng, -6.0, 0.0) * case.theta * case.rate


TOP_FAMILIES: dict[str, Callable[[TopCase, Generator], None]] = {
    family.__name__: family
    for family in (
        generic, waves, loops, cusps, near_cusps, steady_slow, steady_fast, near_steady_slow,
        near_steady_fast, merging_steady, asymptotic, near_asymptotic, through_upright,
        past_upright, through_hanging, past_hanging, from_upright, from_hanging, upright, hanging,
        sleeping, waking, threshold, near_hanging, near_upright, spherical_pendulum, nearly_plane,
        conical_pendulum, swinging, rotating, pendulum_separatrix, from_rest, at_rest_upright,
        no_gravity, no_arm, little_gravity, slow_spin, fast_spin, horizontal, si_sizes,
        discs_and_rods, spheres, tiny_cones, tiniest_tilts, fast_past_upright,
        near_upright_separatrix, late, mixture, triple_root,
    )
}  # fmt: skip


@dataclass
class BodyCase:
    """Moments in ascending order and ω in that order, before the axes are permuted."""

    moments: list[float]
    omega: list[float]


def some_body(rng: Generator) -> BodyCase:
    """Sizes near 1, no two moments closer than a few per cent, any direction of ω."""
    while True:
        # Moments are sums of two of these three positive numbers.
        spread = rng.uniform(0.05, 1.0, 3)
        moments = sorted(float(spread.sum() - x) for x in spread)
        if min(moments[1] / moments[0], moments[2] / moments[1]) > 1.03:
            break
    omega = rng.normal(0, 1, 3) * log_uniform(rng, 0.3, 10.0)
    return BodyCase(moments, [float(x) for x in omega])


def _excess(case: BodyCase) -> float:
    """λ₃(λ₃−λ₂)ω₃² − λ₁(λ₂−λ₁)ω₁² = L² − 2Eλ₂, scaled: positive around the largest moment."""
    (a, b, c), (x, _, z) = case.moments, case.omega
    return (c * (c - b) * z**2 - a * (b - a) * x**2) / (c * (c - b) * z**2 + a * (b - a) * x**2)


def short_axis(case: BodyCase, rng: Generator) -> None:
    while _excess(case) < 0.05:
        case.omega = [float(x) for x in rng.normal(0, 2, 3)]


def long_axis(case: BodyCase, rng: Generator) -> None:
    while _excess(case) > -0.05:
        case.omega = [float(x) for x in rng.normal(0, 2, 3)]


def separatrix(case: BodyCase, rng: Generator) -> None:
    (a, b, c), omega = case.moments, case.omega
    omega[2] = omega[0] * math.sqrt(a * (b - a) / (c * (c - b)))


def near_separatrix(case: BodyCase, rng: Generator) -> None:
    separatrix(case, rng)
    case.omega[2] *= 1 + distance(rng)


def _along(case: BodyCase, axis: int, tilts: tuple[float, float]) -> None:
    case.omega = [float(x) for x in np.insert(tilts, axis, case.omega[axis])]


def _near_axis(case: BodyCase, rng: Generator, axis: int) -> None:
    tilt = 10 ** rng.uniform(-12, -3) * case.omega[axis]
    along = rng.uniform(0, 2 * math.pi)
    directions = rng.choice(4)
    first = (tilt * math.cos(along), tilt, 0.0, tilt * math.cos(along))[directions]
    second = (tilt * math.sin(along), 0.0, tilt, tilt * math.sin(along))[directions]
    _along(case, axis, (first, second))


def near_smallest(case: BodyCase, rng: Generator) -> None:
    _near_axis(case, rng, 0)


def near_middle(case: BodyCase, rng: Generator) -> None:
    _near_axis(case, rng, 1)


def near_largest(case: BodyCase, rng: Generator) -> None:
    _near_axis(case, rng, 2)


def principal_axis(case: BodyCase, rng: Generator) -> None:
    _along(case, int(rng.integers(3)), (0.0, 0.0))


def principal_plane(case: BodyCase, rng: Generator) -> None:
    """One component of ω is zero, or as good as zero."""
    tiny = rng.choice([0.0, -0.0, distance(rng), 1e-200])
    case.omega[int(rng.integers(3))] = float(tiny)


def _equal(case: BodyCase, rng: Generator, near: float) -> None:
    smallest, _, largest = case.moments
    if rng.random() < 0.5 and smallest * (2 + near) > largest:
        case.moments[1] = smallest * (1 + near)
    else:
        case.moments[1] = largest * (1 - near)


def two_equal(case: BodyCase, rng: Generator) -> None:
    _equal(case, rng, 0.0)
    which = rng.integers(6)
    if which == 0:
        case.omega[0] = case.omega[1] = 0.0
    elif which == 1:
        case.omega[2] = 0.0
    elif which == 2:
        case.omega[1] = case.omega[0] = distance(rng)


def nearly_two_equal(case: BodyCase, rng: Generator) -> None:
    _equal(case, rng, 10 ** rng.uniform(-15, -3))


def nearly_two_equal_separatrix(case: BodyCase, rng: Generator) -> None:
    """Nearly equal moments, ω nearly in their plane: as near a separatrix as not."""
    _equal(case, rng, 10 ** rng.uniform(-15, -3))
    separatrix(case, rng)
    case.omega[2] *= 1 + rng.choice([0.0, distance(rng), distance(rng, -3, 0)])


def three_equal(case: BodyCase, rng: Generator) -> None:
    case.moments = [case.moments[0]] * 3


def nearly_three_equal(case: BodyCase, rng: Generator) -> None:
    size = case.moments[0]
    case.moments = sorted(size * (1 + distance(rng, -15, -3)) for _ in range(3))


def flat(case: BodyCase, rng: Generator) -> None:
    case.moments[2] = case.moments[0] + case.moments[1]


def flat_near_separatrix(case: BodyCase, rng: Generator) -> None:
    flat(case, rng)
    separatrix(case, rng)
    case.omega[2] *= 1 + rng.choice([0.0, distance(rng)])


def rods(case: BodyCase, rng: Generator) -> None:
    """One moment small; the other two then differ by at most as much."""
    small = 10 ** rng.uniform(-8, -1) * case.moments[2]
    case.moments[0] = small
    case.moments[1] = case.moments[2] - small * rng.choice([0.0, 1.0, rng.random()])
    if case.moments[1] < case.moments[2] and rng.random() < 0.5:
        separatrix(case, rng)
        case.omega[2] *= 1 + distance(rng, -16, 0)


def spinning_rods(case: BodyCase, rng: Generator) -> None:
    rods(case, rng)
    case.omega[1] *= 10 ** rng.uniform(-9, -3)
    case.omega[2] *= 10 ** rng.uniform(-9, -3)


def at_rest(case: BodyCase, rng: Generator) -> None:
    case.omega = [0.0, 0.0, 0.0]


def tiny_and_huge(case: BodyCase, rng: Generator) -> None:
    rate, size = 10 ** rng.uniform(-9, 6), 10 ** rng.uniform(-9, 6)
    case.omega = [rate * x for x in case.omega]
    case.moments = [size * x for x in case.moments]


def uneven_omega(case: BodyCase, rng: Generator) -> None:
    """Components of ω of very different sizes."""
    case.omega = [x * 10 ** rng.uniform(-15, 0) for x in case.omega]


def any_body(case: BodyCase, rng: Generator) -> None:
    spread = 10 ** rng.uniform(-3, 0, 3)
    case.moments = sorted(float(spread.sum() - x) for x in spread)


def leaving_middle(case: BodyCase, rng: Generator) -> None:
    """On the separatrix, next to the axis that it leaves or approaches."""
    case.omega[0] = case.omega[1] * distance(rng, -12, -1)
    separatrix(case, rng)
    case.omega[2] *= rng.choice([-1, 1]) * (1 + rng.choice([0.0, distance(rng, -9, -2)]))


def late_body(case: BodyCase, rng: Generator) -> None:
    """Anything generic, at later times."""


def mixed_body(case: BodyCase, rng: Generator) -> None:
    """Every moment and every component of ω special by itself."""
    size = case.moments[2]
    middle = size * float(rng.choice([1.0, 1 - abs(distance(rng)), rng.uniform(0.5, 1)]))
    smallest = float(
        rng.choice(
            [size - middle, middle, middle * (1 - abs(distance(rng))), rng.uniform(0.5, 1) * middle]
        )
    )
    case.moments = [max(smallest, size - middle) or size, middle, size]
    case.omega = [
        x * float(rng.choice([0.0, 1.0, distance(rng), 10 ** rng.uniform(-3, 0)]))
        for x in case.omega
    ]


BODY_FAMILIES: dict[str, Callable[[BodyCase, Generator], None]] = {
    family.__name__: family
    for family in (
        short_axis, long_axis, separatrix, near_separatrix, leaving_middle, near_smallest,
        near_middle, near_largest, principal_axis, principal_plane, uneven_omega, two_equal,
        nearly_two_equal, nearly_two_equal_separatrix, three_equal, nearly_three_equal, flat,
        flat_near_separatrix, rods, spinning_rods, any_body, at_rest, tiny_and_huge,
        late_body, mixed_body,
    )
}  # fmt: skip

# More of those that matter most.
BODY_COUNTS = {"at_rest": 8, "three_equal": 20, "late_body": 20} | dict.fromkeys(
    ["short_axis", "long_axis", "separatrix", "near_separatrix", "leaving_middle", "near_middle",
     "nearly_two_equal", "nearly_two_equal_separatrix", "rods", "mixed_body"], 60
)  # fmt: skip
TOP_COUNTS = {"upright": 15, "hanging": 8, "late": 20} | dict.fromkeys(
    ["near_asymptotic", "past_upright", "near_steady_slow", "near_steady_fast", "near_upright",
     "near_upright_separatrix", "fast_past_upright", "mixture", "triple_root"], 40
)  # fmt: skip


@dataclass(frozen=True)
class Drawn:
    """One motion: its family, its inputs in the order of `…_INPUTS`, and its times (s)."""

    family: str
    inputs: list[float]
    times: list[float]


def _times(rng: Generator, rate: float, latest: float = 30.0) -> list[float]:
    """A short one, one of a few periods, and a later one on either side (s)."""
    last = log_uniform(rng, 4.0 if latest == 30 else 60.0, latest) * rng.choice([-1, 1])
    turns = (log_uniform(rng, 1e-2, 1.0), rng.uniform(1.0, 10.0), last)
    return [float(x / rate) for x in turns]


def top(name: str, count: int, seed: int = SEED) -> Drawn:
    """The `count`th of a family."""
    rng = np.random.default_rng([seed, 1, list(TOP_FAMILIES).index(name), count])
    case = some_top(rng)
    TOP_FAMILIES[name](case, rng)
    return Drawn(name, case.inputs(), _times(rng, case.rate, 200.0 if name == "late" else 30.0))


def body(name: str, count: int, seed: int = SEED) -> Drawn:
    """The `count`th of a family."""
    rng = np.random.default_rng([seed, 2, list(BODY_FAMILIES).index(name), count])
    case = some_body(rng)
    case.omega = [x + math.copysign(1e-3, x) for x in case.omega]
    BODY_FAMILIES[name](case, rng)
    order = rng.permutation(3)
    moments = [case.moments[k] for k in order]
    omega = [case.omega[k] * float(rng.choice([-1, 1])) for k in order]
    q = rng.normal(0, 1, 4) if rng.random() < 0.8 else np.array([1.0, 0.0, 0.0, 0.0])
    q = (q / np.linalg.norm(q)).tolist()
    rate = math.hypot(*omega) or 1.0
    times = _times(rng, rate, 120.0 if name == "late_body" else 30.0)
    return Drawn(name, [*moments, *omega, *q], times)


def tops() -> list[Drawn]:
    counts = {name: TOP_COUNTS.get(name, PER_TOP_FAMILY) for name in TOP_FAMILIES}
    return [top(name, count) for name in counts for count in range(counts[name])]


def bodies() -> list[Drawn]:
    counts = {name: BODY_COUNTS.get(name, PER_BODY_FAMILY) for name in BODY_FAMILIES}
    return [body(name, count) for name in counts for count in range(counts[name])]
