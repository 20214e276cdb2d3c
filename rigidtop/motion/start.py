"""The state of a body at t = 0, as somebody gives it: by an attitude and ω, or by Euler angles."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from scipy.spatial.transform import Rotation

from rigidtop.errors import RigidtopError
from rigidtop.motion import attitude, checks
from rigidtop.motion.rigid import Pair, Triple


@dataclass(frozen=True, eq=False)
class Start:
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
        """cos(θ/2) and sin(θ/2)."""
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
        """Body components to space components."""
        return attitude.from_euler_angles(self.theta, self.phi, self.psi)

    @property
    def angles(self) -> Pair:
        """φ and ψ, as they were given (rad)."""
        return self.phi, self.psi

    @property
    def halves(self) -> Pair:
        """cos(θ/2) and sin(θ/2)."""
        cos_half, sin_half, _ = attitude.of_polar_angle(self.theta)
        return cos_half, sin_half

    @property
    def rates(self) -> Pair:
        """θ̇ and φ̇ sin θ (rad/s)."""
        return self.theta_dot, self.phi_dot * attitude.of_polar_angle(self.theta)[2]


AnyStart = Start | EulerStart


@dataclass(frozen=True, eq=False)
class Moving(ABC):
    """A body that moves from a state at t = 0, and has trajectories."""

    body: Any

    initial: AnyStart
    """The state at t = 0."""

    @property
    def attitude(self) -> Rotation:
        """At t = 0, body components to space components."""
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


def from_angles(missing: str, *given: object) -> EulerStart:
    """From what is `GIVEN`: θ, the spin as ψ̇ or ω₃, and the others, which are 0 if None.

    Raises RigidtopError for anything else: with `missing` where θ or the spin is.
    """
    named = zip(GIVEN, given, strict=True)
    known = {name: checks.number(name, x) for name, x in named if x is not None}
    if "psi_dot" in known and "omega3" in known:
        raise RigidtopError("give psi_dot or omega3, not both")
    if "theta" not in known or not ("psi_dot" in known or "omega3" in known):
        raise RigidtopError(missing)
    theta = checks.polar_angle(known["theta"])
    theta_dot, phi, phi_dot, psi = (
        known.get(name, 0.0) for name in ("theta_dot", "phi", "phi_dot", "psi")
    )
    first, second, third = attitude.body_rates(
        theta, psi, theta_dot, phi_dot, known.get("psi_dot", 0.0)
    )
    omega = first, second, known.get("omega3", third)
    return EulerStart(theta, theta_dot, phi, phi_dot, psi, omega)
