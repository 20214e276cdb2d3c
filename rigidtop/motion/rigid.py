"""What motions, their closed forms and trajectories need to know of a body."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass, field
from decimal import ROUND_CEILING, Context

from rigidtop.errors import NoSteadyPrecession, RigidtopError
from rigidtop.motion import checks

Pair = tuple[float, float]
Triple = tuple[float, float, float]

ROUNDING = 4e-16
"""|cos θ| and relative gaps to the threshold that floats cannot tell from zero."""


class RigidBody(ABC):
    """What a motion needs to know of a body."""

    @property
    @abstractmethod
    def moments(self) -> Triple:
        """λ₁, λ₂, λ₃ about the point that stays at rest (kg m²)."""

    @property
    @abstractmethod
    def weight(self) -> Triple:
        """Mg (R₁, R₂, R₃) in body components (N m): the potential energy is this · ẑ."""

    @property
    def symmetric(self) -> bool:
        """Whether e₃ is an axis of symmetry, also for the weight; then ω₃ is constant."""
        return self.moments[0] == self.moments[1] and self.weight[:2] == (0.0, 0.0)


@dataclass(frozen=True, kw_only=True)
class SymmetricTop(RigidBody):
    """A heavy body about whose e₃, through its centre of mass, it is symmetric: see `HeavyTop`."""

    lambda1: float
    lambda3: float
    M: float
    R: float
    g: float = 9.81
    # A float too, so that numbers by name, as figures have them, may be all arguments.
    physical: bool | float = field(default=True, repr=False, compare=False)

    def __post_init__(self) -> None:
        checks.settle(self, checks.positive, "lambda1", "lambda3", "M")
        checks.settle(self, checks.not_negative, "R", "g")
        shift = self.M * self.R**2
        central = self.lambda1 - shift
        if checks.truth("physical", self.physical) and not checks.triangle(
            (central, central, self.lambda3), max(self.moments)
        ):
            raise RigidtopError(
                f"lambda1 = {self.lambda1:g} is too small: about the centre of mass it leaves "
                f"{central:g}, less than lambda3/2; it must be at least MR² + lambda3/2 = "
                f"{shift + self.lambda3 / 2:g}{checks.UNPHYSICAL}"
            )

    @property
    def moments(self) -> Triple:
        return self.lambda1, self.lambda1, self.lambda3

    @property
    def weight(self) -> Triple:
        return 0.0, 0.0, self.M * self.g * self.R

    def smallest_spin(self, theta: float) -> float:
        """The smallest |ω₃| with a steady precession at θ: 2√(λ₁MgR cos θ)/λ₃ (rad/s).

        0 where cos θ ≤ 0; at cos θ = 0 that value itself is excluded (unless gR = 0).
        """
        cosine = _cosine(checks.polar_angle(theta))
        return self._threshold(cosine) / self.lambda3

    def sleeping_spin(self) -> float:
        """The smallest |ω₃| at which the upright top is stable: 2√(λ₁MgR)/λ₃ (rad/s).

        >>> from rigidtop import HeavyTop
        >>> HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5, g=8.0).sleeping_spin()
        8.0
        """
        return self.smallest_spin(0.0)

    def steady_precession(self, theta: float, omega3: float) -> tuple[float, float]:
        """Both rates Ω = φ̇ at which θ stays constant, the slow one first: (3.57), in rad/s.

        The roots of (λ₁ cos θ)Ω² − (λ₃ω₃)Ω + MgR = 0, of which the slow one has the smaller
        magnitude; neither loses digits for large ω₃.  Both change sign with ω₃.  For cos θ < 0 they
        have opposite signs, and for ω₃ = 0 equal magnitudes (a conical pendulum): then the positive
        one is first.  At cos θ = 0 (to rounding) there is one rate, MgR/(λ₃ω₃); the fast one, which
        grows without limit towards it, is ±inf with the sign of ω₃.  At θ = 0 and π, where every
        rate is steady, these are the limits of the rates at neighbouring θ.

        Raises NoSteadyPrecession, which names the smallest |ω₃|, where there is no real root.

        >>> from rigidtop import HeavyTop
        >>> top = HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5, g=8.0)
        >>> top.steady_precession(theta=0.0, omega3=10.0)
        (1.0, 4.0)
        >>> top.steady_precession(theta=0.0, omega3=1.0)
        Traceback (most recent call last):
        ...
        rigidtop.errors.NoSteadyPrecession: no steady precession at theta = 0 with omega3 = 1: \
|omega3| must be at least 8 rad/s
        """
        theta = checks.polar_angle(theta)
        cosine = _cosine(theta)
        spin = checks.number("omega3", omega3)
        a, b, c = self.lambda1 * cosine, self.lambda3 * spin, self.weight[2]
        threshold = self._threshold(cosine)
        if abs(b) < threshold * (1 - ROUNDING) or (a == b == 0 < c):
            least = Context(prec=9, rounding=ROUND_CEILING)  # what is shown is enough
            least_spin = least.create_decimal_from_float(threshold / self.lambda3)
            needed = f"at least {least_spin:g} rad/s" if a else "more than 0"
            raise NoSteadyPrecession(
                f"no steady precession at theta = {theta:g} with omega3 = {spin:g}: "
                f"|omega3| must be {needed}"
            )
        if a > 0:
            # As a product the difference of squares neither overflows nor loses digits.
            root = math.sqrt(max(abs(b) - threshold, 0.0)) * math.sqrt(abs(b) + threshold)
        else:
            root = math.hypot(b, 2 * math.sqrt(-a) * math.sqrt(c))
        if b == 0:  # Ω² = −c/a: a conical pendulum, or at rest without weight
            rate = math.sqrt(c / -a) if c else 0.0
            return rate, -rate
        larger = math.copysign(abs(b) + root, b) / 2
        return c / larger, larger / a if a else math.copysign(math.inf, b)

    def _threshold(self, cosine: float) -> float:
        """The smallest |p_ψ| with a steady precession (J s)."""
        return 2 * math.sqrt(self.lambda1 * max(cosine, 0.0)) * math.sqrt(self.weight[2])


def _cosine(theta: float) -> float:
    """cos θ, and exactly 0 where θ is the float nearest to π/2."""
    cosine = math.cos(theta)
    return 0.0 if abs(cosine) < ROUNDING else cosine
