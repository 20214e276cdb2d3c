"""The state of a body at t = 0, as somebody gives it: by an attitude and ω, or by Euler angles."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from scipy.optimize import brentq
from scipy.spatial.transform import Rotation

from rigidtop.errors import RigidtopError
from rigidtop.motion import attitude, checks
from rigidtop.motion.rigid import Pair, SymmetricTop, Triple


@dataclass(frozen=True, eq=False)
class InitialState:
    """An attitude and a rotational velocity."""

    attitude: Rotation
    """Body components to space components."""

    omega: Triple
    """In body components, rad/s: `checks.vector` gives it."""

    def __post_init__(self) -> None:
        checks.single_rotation(self.attitude)

    @cached_property
    def angles(self) -> Pair:
        """φ and ψ in (−π, π]; of a vertical body those that it has as soon as it moves (rad)."""
        return attitude.azimuth_and_spin(self.attitude, self.omega)

    @property
    def halves(self) -> Pair:
        """The two numbers cos(θ/2) and sin(θ/2)."""
        alpha, beta = attitude.spinors(attitude.quaternions(self.attitude))
        return float(abs(alpha)), float(abs(beta))

    @property
    def rates(self) -> Pair:
        """θ̇ and φ̇ sin θ (rad/s)."""
        theta_dot, v_phi = attitude.to_nodes(*self.omega[:2], self.angles[1])
        return theta_dot, v_phi


@dataclass(frozen=True, eq=False)
class EulerStart:
    """R = Rz(φ) Ry(θ) Rz(ψ) and rates (rad, rad/s); large φ and ψ keep their digits."""

    theta: float
    theta_dot: float
    phi: float
    phi_dot: float
    psi: float
    omega: Triple
    """In body components, rad/s."""

    def __post_init__(self) -> None:
        checks.settle(self, checks.vector, "omega")

    @cached_property
    def attitude(self) -> Rotation:
        """The rotation that takes body components to space components."""
        return attitude.from_euler_angles(self.theta, self.phi, self.psi)

    @property
    def angles(self) -> Pair:
        """φ and ψ, as they were given (rad)."""
        return self.phi, self.psi

    @property
    def halves(self) -> Pair:
        """The two numbers cos(θ/2) and sin(θ/2)."""
        cos_half, sin_half, _ = attitude.of_polar_angle(self.theta)
        return cos_half, sin_half

    @property
    def rates(self) -> Pair:
        """θ̇ and φ̇ sin θ (rad/s)."""
        return self.theta_dot, self.phi_dot * attitude.of_polar_angle(self.theta)[2]


AnyStart = InitialState | EulerStart


@dataclass(frozen=True, eq=False)
class Moving(ABC):
    """A body that moves from a state at t = 0, and has trajectories."""

    body: Any

    initial: AnyStart
    """The state at t = 0."""

    @property
    def attitude(self) -> Rotation:
        """The attitude at t = 0: body components to space components."""
        return self.initial.attitude

    @property
    def omega(self) -> Triple:
        """Rotational velocity at t = 0, body components, rad/s."""
        return self.initial.omega

    @property
    def phi(self) -> float:
        """φ at t = 0, from which φ(t) continues (rad)."""
        return self.initial.angles[0]

    @property
    def psi(self) -> float:
        """ψ at t = 0, from which ψ(t) continues (rad)."""
        return self.initial.angles[1]

    @abstractmethod
    def start(self) -> Any:
        """The initial state, as a trajectory of one row."""


GIVEN = ("theta", "theta_dot", "phi", "phi_dot", "psi", "psi_dot", "omega3")


def from_angles(missing: str, *values: object) -> EulerStart:
    """The start from what is `GIVEN`: θ, the spin as ψ̇ or ω₃, and others, 0 if None.

    Raises RigidtopError for anything else: with `missing` where θ or the spin is.
    """
    named = zip(GIVEN, values, strict=True)
    numbers = {name: checks.number(name, x) for name, x in named if x is not None}
    if "psi_dot" in numbers and "omega3" in numbers:
        raise RigidtopError("give psi_dot or omega3, not both")
    if "theta" not in numbers or not ("psi_dot" in numbers or "omega3" in numbers):
        raise RigidtopError(missing)
    theta = checks.polar_angle(numbers["theta"])
    theta_dot, phi, phi_dot, psi = (
        numbers.get(name, 0.0) for name in ("theta_dot", "phi", "phi_dot", "psi")
    )
    first, second, third = attitude.body_rates(
        theta, psi, theta_dot, phi_dot, numbers.get("psi_dot", 0.0)
    )
    omega = first, second, numbers.get("omega3", third)
    return EulerStart(theta, theta_dot, phi, phi_dot, psi, omega)


CONSTANTS = ("E", "p_phi", "p_psi")

NEAREST = 1e-12
"""Angles to the vertical below this are not told from it where constants of the motion decide."""

LEVEL = 1e-14
"""What rounding leaves of an energy, relative to its parts."""


@dataclass(frozen=True)
class Reach:
    """Where a symmetric top is while E (J), p_φ (3.55) and p_ψ (3.56) (J s) stay what they are."""

    top: SymmetricTop
    E: float
    p_phi: float
    p_psi: float

    @cached_property
    def scale(self) -> float:
        """The size of what E consists of (J)."""
        momenta = self.p_phi**2 / self.top.lambda1 + self.p_psi**2 / self.top.lambda3
        return abs(self.E) + momenta + self.top.weight[2]

    def across(self, theta: float) -> float:
        """φ̇ sin θ (rad/s) at θ: infinite where a vertical top cannot have both momenta."""
        cosine, sine, _ = attitude.of_polar_angle(theta)
        part = (self.p_phi - self.p_psi) * cosine**2 + (self.p_phi + self.p_psi) * sine**2
        below = 2 * self.top.lambda1 * sine * cosine
        if not below:
            small = 2 * NEAREST * math.sqrt(2 * self.top.lambda1 * self.scale)
            return math.inf if abs(part) > small else 0.0
        rate: float = part / below
        return rate

    def left(self, theta: float) -> float:
        """What E leaves for ½λ₁θ̇² at θ (J)."""
        kinetic = self.top.lambda1 * self.across(theta) ** 2 + self.p_psi**2 / self.top.lambda3
        left: float = self.E - kinetic / 2 - self.top.weight[2] * math.cos(theta)
        return left

    @cached_property
    def lowest(self) -> float:
        """θ where the effective potential, which is convex in cos θ, is least."""
        above, below = (self.p_phi - self.p_psi) ** 2, (self.p_phi + self.p_psi) ** 2
        weight = 16 * self.top.lambda1 * self.top.weight[2]

        def fall(theta: float) -> float:
            cosine, sine, _ = attitude.of_polar_angle(theta)
            slope: float = above * cosine**4 - below * sine**4 + weight * (sine * cosine) ** 4
            return slope

        if fall(NEAREST) <= 0:
            return 0.0
        return math.pi if fall(math.pi - NEAREST) >= 0 else _root(fall, NEAREST, math.pi - NEAREST)

    @cached_property
    def turning_points(self) -> Pair:
        """The smallest and the largest θ; RigidtopError where E is too small for any."""
        most = self.left(self.lowest)
        if most < -LEVEL * self.scale:
            raise RigidtopError(
                f"E = {self.E:g} is too small: with p_phi = {self.p_phi:g} and p_psi = "
                f"{self.p_psi:g} it is at least {self.E - most:.9g} J"
            )
        if most <= LEVEL * self.scale:
            return self.lowest, self.lowest
        return self._end(0.0), self._end(math.pi)

    def _end(self, pole: float) -> float:
        """Where θ̇ vanishes between the lowest place and a pole; the pole if it gets there."""
        near = abs(pole - NEAREST)
        return pole if self.left(near) >= 0 else _root(self.left, near, self.lowest)


def _root(function: Any, low: float, high: float) -> float:
    return float(brentq(function, low, high, xtol=1e-300, rtol=1e-15, maxiter=500))


def from_constants(
    top: SymmetricTop, E: object, p_phi: object, p_psi: object, theta: object, *angles: object
) -> EulerStart:
    """The start from E, p_φ and p_ψ, with θ̇ ≥ 0: at the smallest θ unless given; φ, ψ 0 if None.

    Raises RigidtopError for constants that the top cannot have, there or anywhere.
    """
    constants = zip(CONSTANTS, (E, p_phi, p_psi), strict=True)
    reach = Reach(top, *(checks.number(name, value) for name, value in constants))
    phi, psi = (checks.number(n, x or 0.0) for n, x in zip(("phi", "psi"), angles, strict=True))
    least, most = reach.turning_points
    at = least if theta is None else checks.polar_angle(theta)
    energy = reach.left(at)
    if energy < -LEVEL * reach.scale:
        raise RigidtopError(
            f"theta = {at:g} is out of reach: with this E, p_phi and p_psi it goes from "
            f"{least:.9g} to {most:.9g}"
        )
    turning = theta is None and (0 < at < math.pi or least == most)
    theta_dot = 0.0 if turning else math.sqrt(max(2 * energy / top.lambda1, 0.0))
    across, sine = reach.across(at), attitude.of_polar_angle(at)[2]
    omega = *attitude.from_nodes(theta_dot, across, psi), reach.p_psi / top.lambda3
    return EulerStart(at, theta_dot, phi, across / sine if sine else 0.0, psi, omega)
