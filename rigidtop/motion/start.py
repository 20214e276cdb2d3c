"""The state of a symmetric top at t = 0, in Euler angles, as somebody gives it."""

from __future__ import annotations

from dataclasses import dataclass

from scipy.spatial.transform import Rotation

from rigidtop.errors import RigidtopError
from rigidtop.motion import attitude, checks


@dataclass(frozen=True)
class Start:
    """R = Rz(φ) Ry(θ) Rz(ψ) and rates; rad and rad/s."""

    theta: float
    theta_dot: float
    phi: float
    phi_dot: float
    psi: float
    omega: tuple[float, float, float]
    """In body components."""

    @property
    def attitude(self) -> Rotation:
        """Body components to space components."""
        return attitude.from_euler_angles(self.theta, self.phi, self.psi)


GIVEN = ("theta", "theta_dot", "phi", "phi_dot", "psi", "psi_dot", "omega3")


def start(missing: str, *given: object) -> Start:
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
    return Start(theta, theta_dot, phi, phi_dot, psi, (first, second, known.get("omega3", third)))
