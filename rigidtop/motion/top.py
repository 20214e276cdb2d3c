"""The heavy symmetric top of section 3.5."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import overload

from scipy.spatial.transform import Rotation

from rigidtop.errors import RigidtopError
from rigidtop.motion import checks
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.rigid import ROUNDING, SymmetricTop
from rigidtop.motion.start import GIVEN, InitialState, from_angles, from_constants

__all__ = ["ROUNDING", "HeavyTop"]


@dataclass(frozen=True, kw_only=True)
class HeavyTop(SymmetricTop):
    """The heavy symmetric top (3.53), its tip held, in gravity g ≥ 0 along −ẑ (m/s²).

    λ₁ = λ₂ and λ₃ are moments about the pivot (kg m²), M is the mass (kg), R ≥ 0 the distance of
    the centre of mass from the pivot along e₃ (m).  With R = 0 or g = 0 the top is free.

    Raises RigidtopError for moments that no such body can have.  About the centre of mass they are
    λ₁ − MR² (twice) and λ₃, and λ₃ ≤ 2(λ₁ − MR²): the triangle inequality, equal for a disc.
    `physical=False` lets others through, such as those of Simo and Wong's top, a benchmark.

    >>> HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.9)
    Traceback (most recent call last):
    ...
    rigidtop.errors.RigidtopError: lambda1 = 1 is too small: about the centre of mass it leaves \
0.19, less than lambda3/2; it must be at least MR² + lambda3/2 = 1.06 \
(physical=False lets them through)
    """

    @overload
    def motion(
        self,
        *,
        theta: float,
        theta_dot: float = 0.0,
        phi: float = 0.0,
        phi_dot: float = 0.0,
        psi: float = 0.0,
        psi_dot: float | None = None,
        omega3: float | None = None,
    ) -> TopMotion: ...

    @overload
    def motion(
        self,
        *,
        E: float,
        p_phi: float,
        p_psi: float,
        theta: float | None = None,
        phi: float = 0.0,
        psi: float = 0.0,
    ) -> TopMotion: ...

    @overload
    def motion(self, *, attitude: Rotation, omega: Sequence[float]) -> TopMotion: ...

    def motion(
        self,
        *,
        theta: float | None = None,
        theta_dot: float | None = None,
        phi: float | None = None,
        phi_dot: float | None = None,
        psi: float | None = None,
        psi_dot: float | None = None,
        omega3: float | None = None,
        attitude: Rotation | None = None,
        omega: Sequence[float] | None = None,
        E: float | None = None,
        p_phi: float | None = None,
        p_psi: float | None = None,
    ) -> TopMotion:
        """The motion from angles and rates, an attitude and ω, or the constants, at t = 0.

        R = Rz(φ) Ry(θ) Rz(ψ) takes body components to space components; 0 ≤ θ ≤ π.  `theta` is
        needed, and the spin, as `psi_dot` or as `omega3` = ψ̇ + φ̇ cos θ; the others are 0 unless
        given.  Or `attitude`, which is R, and `omega`, the body components of ω; then φ and ψ start
        in (−π, π].  Or the constants of the motion, the energy `E` (J) and the momenta `p_phi`
        (3.55) and `p_psi` (3.56) (J s): it starts at the smallest θ that it reaches, or at `theta`
        with θ̇ ≥ 0.  Radians and rad/s.

        Raises RigidtopError for anything else.

        >>> top = HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5)
        >>> top.motion(theta=0.5, phi_dot=1.0, psi=0.1, omega3=40.0).psi
        0.1
        >>> top.motion(theta=0.5, psi_dot=40.0, omega3=40.0)
        Traceback (most recent call last):
        ...
        rigidtop.errors.RigidtopError: give psi_dot or omega3, not both
        >>> top.motion(E=405.0, p_phi=18.0, p_psi=20.0).turning_points
        (0.4040860915771713, 0.5151895298329429)
        >>> top.motion(E=404.0, p_phi=18.0, p_psi=20.0)
        Traceback (most recent call last):
        ...
        rigidtop.errors.RigidtopError: E = 404 is too small: with p_phi = 18 and p_psi = 20 it is \
at least 404.408656 J
        """
        angles = theta, theta_dot, phi, phi_dot, psi, psi_dot, omega3
        constants = E, p_phi, p_psi
        if any(x is not None for x in constants):
            rates = theta_dot, phi_dot, psi_dot, omega3, attitude, omega
            if None in constants or any(x is not None for x in rates):
                raise RigidtopError(
                    "E, p_phi and p_psi are needed together, with theta, phi and psi alone beside "
                    "them: they tell every rate"
                )
            return TopMotion(self, from_constants(self, *constants, theta, phi, psi))
        if attitude is not None or omega is not None:
            names = [name for name, x in zip(GIVEN, angles, strict=True) if x is not None]
            if names:
                raise RigidtopError(
                    f"give attitude and omega, or Euler angles, not both: {', '.join(names)} too"
                )
            if attitude is None or omega is None:
                raise RigidtopError("attitude and omega are needed together")
            return TopMotion(self, InitialState(attitude, checks.vector("omega", omega)))
        missing = "give theta and the spin (omega3 or psi_dot), or attitude and omega, or constants"
        return TopMotion(self, from_angles(missing, *angles))
