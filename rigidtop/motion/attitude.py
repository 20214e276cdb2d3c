"""Attitudes: unit quaternions and Euler angles, at and near the poles too.

R = Rz(φ) Ry(θ) Rz(ψ) takes body components to space components (section 3.3).  Its quaternion,
scalar first, is two complex numbers,

    α = q₀ + i q₃ = cos(θ/2) exp(i(φ + ψ)/2),    β = q₂ − i q₁ = sin(θ/2) exp(i(φ − ψ)/2).

θ from their magnitudes is as accurate near 0 and π as elsewhere.  The phase of α is lost only at
θ = π and that of β only at θ = 0.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from rigidtop.errors import RigidtopError

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]


def from_euler_angles(theta: float, phi: float, psi: float) -> Rotation:
    """R = Rz(φ) Ry(θ) Rz(ψ), body to space; angles in radians.

    >>> from_euler_angles(np.pi / 2, 0.0, 0.0).apply([0, 0, 1]).round(12)    # e₃ lies along x̂
    array([1., 0., 0.])
    """
    cos_half, sin_half, _ = of_polar_angle(theta)
    q0, q1, q2, q3 = components(cos_half, sin_half, phi, psi, math)
    return Rotation.from_quat((q1, q2, q3, q0))


def of_polar_angle(theta: Any, library: Any = math) -> tuple[Any, Any, Any]:
    """cos(θ/2), sin(θ/2) and sin θ of a float, or of an array by NumPy.

    The float nearest to π means π: a top that hangs straight down, exactly.
    """
    tilted = theta != math.pi
    return library.cos(theta / 2) * tilted, library.sin(theta / 2), library.sin(theta) * tilted


def quaternions(rotation: Rotation) -> Floats:
    """The unit quaternions of attitudes, shape (…, 4), scalar first."""
    return np.roll(rotation.as_quat(), 1, axis=-1)


def rotation(q: Floats) -> Rotation:
    """The attitudes of quaternions (…, 4), scalar first; they need not be units."""
    return Rotation.from_quat(np.roll(q, -1, axis=-1))


def from_spinors(
    cos_half: Floats, sin_half: Floats, phi: Floats | float, psi: Floats | float
) -> Floats:
    """Quaternions (…, 4), scalar first, from cos(θ/2), sin(θ/2), φ and ψ."""
    return np.stack(components(cos_half, sin_half, phi, psi, np), axis=-1)


def components(cos_half: Any, sin_half: Any, phi: Any, psi: Any, library: Any) -> tuple[Any, ...]:
    """The same as q₀ … q₃, of floats by `math` or of arrays by NumPy.

    φ and ψ enter by their own sines: after 10⁹ turns of a fast spin ψ is known to 10⁻⁷, and e₃,
    which does not depend on it, must not suffer.
    """
    cos_phi, sin_phi = library.cos(phi / 2), library.sin(phi / 2)
    cos_psi, sin_psi = library.cos(psi / 2), library.sin(psi / 2)
    return (
        cos_half * (cos_phi * cos_psi - sin_phi * sin_psi),
        -sin_half * (sin_phi * cos_psi - cos_phi * sin_psi),
        sin_half * (cos_phi * cos_psi + sin_phi * sin_psi),
        cos_half * (sin_phi * cos_psi + cos_phi * sin_psi),
    )


def product(p: Floats, q: Floats) -> Floats:
    """The quaternion of rotation q followed by p; (…, 4), scalar first."""
    return np.stack(after([*np.moveaxis(p, -1, 0)], [*np.moveaxis(q, -1, 0)]), axis=-1)


def after(p: Sequence[Any], q: Sequence[Any]) -> tuple[Any, ...]:
    """The same of four components each, which may be floats."""
    p0, p1, p2, p3 = p
    q0, q1, q2, q3 = q
    return (
        p0 * q0 - p1 * q1 - p2 * q2 - p3 * q3,
        p0 * q1 + p1 * q0 + p2 * q3 - p3 * q2,
        p0 * q2 - p1 * q3 + p2 * q0 + p3 * q1,
        p0 * q3 + p1 * q2 - p2 * q1 + p3 * q0,
    )


def conjugate(q: Floats) -> Floats:
    """The inverse of unit quaternions (…, 4), scalar first."""
    conjugates: Floats = q * np.array([1.0, -1.0, -1.0, -1.0])
    return conjugates


def units(states: Floats) -> Floats:
    """The quaternions (N, 4) of states (n, N), with norm 1.

    Raises RigidtopError where they are far from it.
    """
    q = states[:4].reshape(4, -1)
    norms = np.linalg.norm(q, axis=0)
    if not np.all((norms > 0.5) & (norms < 2)):  # also NaN
        raise RigidtopError(
            "the integration lost the attitude, its quaternion is far from a unit: "
            "smaller rtol and atol are needed"
        )
    normed: Floats = (q / norms).T
    return normed


def spinors(q: Floats) -> tuple[Complexes, Complexes]:
    """α and β of quaternions (4, …), scalar first."""
    return q[0] + 1j * q[3], q[2] - 1j * q[1]


def polar_angle(alpha: Complexes, beta: Complexes) -> Floats:
    """The angle θ in [0, π] between e₃ and the vertical (rad)."""
    return 2 * np.arctan2(np.abs(beta), np.abs(alpha))


def body_rates(
    theta: float, psi: float, theta_dot: float, phi_dot: float, psi_dot: float
) -> tuple[float, float, float]:
    """ω in body components (rad/s) from Euler angles and their rates: (3.42) turned by ψ."""
    first, second = from_nodes(theta_dot, phi_dot * of_polar_angle(theta)[2], psi)
    return first, second, psi_dot + phi_dot * math.cos(theta)


def from_nodes(theta_dot: Any, v_phi: Any, psi: Any, library: Any = math) -> tuple[Any, Any]:
    """ω₁ and ω₂ from θ̇ and φ̇ sin θ, which are ω along e₂′ and −e₁′ (3.42)."""
    sine, cosine = library.sin(psi), library.cos(psi)
    return theta_dot * sine - v_phi * cosine, theta_dot * cosine + v_phi * sine


def to_nodes(omega1: Any, omega2: Any, psi: Any, library: Any = math) -> tuple[Any, Any]:
    """The way back: θ̇ and φ̇ sin θ."""
    sine, cosine = library.sin(psi), library.cos(psi)
    return omega1 * sine + omega2 * cosine, omega2 * sine - omega1 * cosine


def azimuth_and_spin(rotation: Rotation, omega: tuple[float, float, float]) -> tuple[float, float]:
    """φ and ψ in (−π, π] of an attitude.

    An upright body has no φ and ψ of its own, only their sum (θ = 0) or difference (θ = π).  Then
    they are those that it has as soon as it moves: φ points where e₃ is about to go.  A body that
    stays upright gets ψ = 0.
    """
    alpha, beta = (complex(z) for z in spinors(quaternions(rotation)))
    if alpha != 0 and beta != 0:
        half_sum, half_difference = cmath.phase(alpha), cmath.phase(beta)
        phi, psi = half_sum + half_difference, half_sum - half_difference
    else:
        # θ leaves 0 upwards and π downwards, and θ̇ is the component of ω along e₂′.
        sign = 1.0 if beta == 0 else -1.0
        psi = math.atan2(sign * omega[0], sign * omega[1]) if omega[0] or omega[1] else 0.0
        phi = 2 * cmath.phase(alpha) - psi if beta == 0 else 2 * cmath.phase(beta) + psi
    return _principal(phi), _principal(psi)


def _principal(angle: float) -> float:
    """The same angle in (−π, π]."""
    remainder = math.remainder(angle, 2 * math.pi)
    return math.pi if remainder == -math.pi else remainder
