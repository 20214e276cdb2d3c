"""What a motion is at given times."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.spatial.transform import Rotation

from rigidtop.motion import attitude
from rigidtop.motion.attitude import Floats

if TYPE_CHECKING:
    from rigidtop.motion.motion import Motion, TopMotion


@dataclass(frozen=True, eq=False)
class Trajectory:
    """A motion at N times, one row each, in the order in which the times were asked for."""

    motion: Motion
    """The motion that it belongs to, with its body and its initial state."""

    t: Floats
    """Times, shape (N,), in s."""

    rotation: Rotation
    """Attitudes, N of them: body components to space components."""

    omega: Floats
    """Rotational velocity in body components, shape (N, 3), in rad/s."""

    @property
    def omega_space(self) -> Floats:
        """Rotational velocity in space components, shape (N, 3), in rad/s."""
        return self.rotation.apply(self.omega)

    @property
    def angular_momentum(self) -> Floats:
        """L = Iω in space components, shape (N, 3), in J s."""
        return self.rotation.apply(self.omega * np.array(self.motion.body.moments))

    @property
    def e3(self) -> Floats:
        """The figure axis in space components, shape (N, 3)."""
        return self.rotation.as_matrix()[:, :, 2]

    @property
    def vertical(self) -> Floats:
        """ẑ in body components, shape (N, 3)."""
        return self.rotation.as_matrix()[:, 2, :]

    @property
    def energy(self) -> Floats:
        """½ Σ λₖωₖ² + Mg × (height of the centre of mass above the pivot), shape (N,), in J."""
        body = self.motion.body
        kinetic = self.omega**2 @ np.array(body.moments) / 2
        return kinetic + self.vertical @ np.array(body.weight)

    def conserved(self) -> Mapping[str, Floats]:
        """What the exact motion keeps: the energy, and L (free) or L_z, called p_φ (heavy)."""
        if any(self.motion.body.weight):
            return {"energy": self.energy, "p_phi": self.angular_momentum[:, 2]}
        return {"energy": self.energy, "angular_momentum": self.angular_momentum}

    def drift(self) -> dict[str, float]:
        """By how much the conserved quantities stray from their values at t = 0, at most.

        Each is relative: the energy to T₀ + MgR, a momentum to √(2λ(T₀ + MgR)) with the largest
        moment λ, which no |L| of a body with that kinetic energy exceeds.  T₀ is the kinetic energy
        at t = 0.  For a body at rest without weight, where both would be zero, they are 1 J and
        1 J s.  For L the change of the vector counts, not that of its length.
        """
        body, start = self.motion.body, self.motion.start()
        kinetic = float(np.dot(body.moments, np.square(self.motion.omega))) / 2
        energy = kinetic + float(np.linalg.norm(body.weight))
        scales = {"energy": energy or 1.0}
        # As a product of roots it does not overflow.
        momentum = float(np.sqrt(2 * max(body.moments)) * np.sqrt(energy)) or 1.0
        initial = start.conserved()
        drifts = {}
        for name, values in self.conserved().items():
            change = (values - initial[name]).reshape(len(self.t), -1)
            relative = change / scales.get(name, momentum)  # before it is squared: no overflow
            drifts[name] = float(np.linalg.norm(relative, axis=1).max())
        return drifts


@dataclass(frozen=True, eq=False)
class TopTrajectory(Trajectory):
    """The motion of a symmetric top, with its Euler angles R = Rz(φ) Ry(θ) Rz(ψ).

    φ and ψ are continuous in t, from the values at t = 0 that the motion was given: they count
    turns.  Only a top whose axis goes exactly through the vertical makes φ jump by ±π and ψ by ∓π
    there (φ ± ψ does not); rounding then decides the sign.
    """

    motion: TopMotion

    phi: Floats
    """Azimuth of e₃, shape (N,), in rad; continuous."""

    psi: Floats
    """Turn about e₃, shape (N,), in rad; continuous."""

    @property
    def theta(self) -> Floats:
        """Polar angle of e₃ in [0, π], shape (N,), in rad."""
        return attitude.polar_angle(*self._spinors)

    @property
    def theta_dot(self) -> Floats:
        """θ̇, the component of ω along e₂′, shape (N,), in rad/s."""
        sin_psi, cos_psi = self._along_nodes.imag, self._along_nodes.real
        return self.omega[:, 0] * sin_psi + self.omega[:, 1] * cos_psi

    @property
    def phi_dot(self) -> Floats:
        """φ̇, shape (N,), in rad/s.

        Exactly at θ = 0 or π it is the limit along a motion through it, ±λ₃ω₃/(2λ₁).
        """
        # ẑ = −sin θ e₁′ + cos θ e₃, so ω·e₁′ = −φ̇ sin θ (3.42); products of the spinors keep
        # their digits where the entries of a rotation matrix would lose them.
        alpha, beta = self._spinors
        sine = 2 * np.abs(alpha) * np.abs(beta)
        across = (
            self.omega[:, 0] * self._along_nodes.real - self.omega[:, 1] * self._along_nodes.imag
        )
        body = self.motion.body
        limit = np.copysign(1.0, np.abs(alpha) - np.abs(beta)) * self.p_psi / (2 * body.lambda1)
        return np.divide(-across, sine, out=limit, where=sine > 0)

    @property
    def psi_dot(self) -> Floats:
        """ψ̇ = ω₃ − φ̇ cos θ, shape (N,), in rad/s."""
        return self.omega[:, 2] - self.phi_dot * np.cos(self.theta)

    @property
    def p_phi(self) -> Floats:
        """Momentum conjugate to φ (3.55), which is L_z, shape (N,), in J s."""
        return self.angular_momentum[:, 2]

    @property
    def p_psi(self) -> Floats:
        """Momentum conjugate to ψ (3.56), which is L₃, shape (N,), in J s."""
        return self.motion.body.lambda3 * self.omega[:, 2]

    def conserved(self) -> Mapping[str, Floats]:
        """The energy, p_φ and p_ψ."""
        return {"energy": self.energy, "p_phi": self.p_phi, "p_psi": self.p_psi}

    @property
    def _spinors(self) -> tuple[attitude.Complexes, attitude.Complexes]:
        return attitude.spinors(attitude.quaternions(self.rotation).T)

    @property
    def _along_nodes(self) -> attitude.Complexes:
        """cos ψ + i sin ψ: from the attitude, and where that has no ψ, from `psi`."""
        alpha, beta = self._spinors
        product = alpha * beta.conj()
        size = np.abs(product)
        return np.divide(product, size, out=np.exp(1j * self.psi), where=size > 0)
