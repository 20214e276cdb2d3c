"""A body with a ball inside: friction that exerts no torque on the whole.

The ball turns in a cavity that it fills but for a film of oil.  Its moment λ₀ is the same about
every axis, so that only its rotation relative to the body counts, at ζ; the oil brakes that by the
torque −cζ.  λ₁, λ₂, λ₃ are the moments of the whole with the ball at rest in it: those of the body
around the ball are λₖ − λ₀.  Vectors have body components.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache, lru_cache
from types import MappingProxyType

from sympy import Expr, Matrix

from rigidtop.theory import euler
from rigidtop.theory import symbols as s
from rigidtop.theory.polynomial import CACHED
from rigidtop.theory.rotation import total_derivative
from rigidtop.theory.trig import reduce_ratio

RELATIVE = (s.zeta1, s.zeta2, s.zeta3)


def angular_momentum() -> Matrix:
    """Lₖ = λₖωₖ + λ₀ζₖ, of the whole (3×1, J s)."""
    return euler.angular_momentum() + s.ball * Matrix(RELATIVE)


def kinetic_energy() -> Expr:
    """½ω·L of the body around the ball and ½λ₀(ω + ζ)² of the ball (J)."""
    relative = Matrix(RELATIVE)
    with_ball = s.ball * relative.dot(2 * Matrix(euler.OMEGA) + relative) / 2
    return euler.kinetic_energy() + with_ball


@cache
def rates() -> Mapping[Expr, Expr]:
    """ω̇ by Euler's equations of the body around the ball, ζ̇ by those of the ball (rad/s²).

    Each gets the torque of the oil from the other.
    """
    oil, omega = s.damping * Matrix(RELATIVE), Matrix(euler.OMEGA)
    around = {moment: moment - s.ball for moment in euler.MOMENTS}
    turning = euler.body_accelerations(oil).subs(around, simultaneous=True)
    relative = -oil / s.ball - omega.cross(Matrix(RELATIVE)) - turning
    rate_by_letter = dict(zip([*euler.OMEGA, *RELATIVE], [*turning, *relative], strict=True))
    return MappingProxyType(rate_by_letter)


@lru_cache(maxsize=CACHED)
def along_flow(expression: Expr) -> Expr:
    """d/dt of a function of ω and ζ.

    >>> along_flow(kinetic_energy())
    -damping*(zeta1**2 + zeta2**2 + zeta3**2)
    """
    return reduce_ratio(total_derivative(expression, rates()))
