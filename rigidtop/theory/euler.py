"""Euler's equations for any three moments: rates, first integrals, stability of the axes."""

from __future__ import annotations

from functools import cache

import sympy
from sympy import Expr, ImmutableMatrix, Matrix, MatrixBase, Symbol, diag

from rigidtop.theory import symbols as s
from rigidtop.theory.rotation import total_derivative

MOMENTS = (s.lambda1, s.lambda2, s.lambda3)
OMEGA = (s.omega1, s.omega2, s.omega3)
OMEGA_DOT = (s.omega1dot, s.omega2dot, s.omega3dot)


def angular_momentum() -> Matrix:
    """L = (λ₁ω₁, λ₂ω₂, λ₃ω₃) in the body frame (3×1, J s): (3.26) with (3.29)."""
    return diag(*MOMENTS) * Matrix(OMEGA)


def body_accelerations(torque: MatrixBase | None = None) -> Matrix:
    """ω̇ in the body frame (3×1, rad/s²): L̇ + ω × L = N, solved; (3.36) without torque.

    `torque` is 3×1 in body components (N m).

    >>> body_accelerations()[0]
    omega2*omega3*(lambda2 - lambda3)/lambda1
    """
    if torque is None:
        return Matrix(_free_accelerations())
    balance = torque - Matrix(OMEGA).cross(angular_momentum())
    return _over_moments(balance)


@cache
def _free_accelerations() -> ImmutableMatrix:
    return ImmutableMatrix(_over_moments(-Matrix(OMEGA).cross(angular_momentum())))


def _over_moments(balance: MatrixBase) -> Matrix:
    return Matrix([sympy.factor(n) / moment for n, moment in zip(balance, MOMENTS, strict=True)])


def kinetic_energy() -> Expr:
    """½ ω·L in the body frame (J): (3.32)."""
    return Matrix(OMEGA).dot(angular_momentum()) / 2


def first_integrals() -> tuple[Expr, Expr]:
    """2T and L², both constant along free motion; they fix the polhode."""
    momentum = angular_momentum()
    return 2 * kinetic_energy(), momentum.dot(momentum)


def along_flow(expression: Expr, torque: MatrixBase | None = None) -> Expr:
    """d/dt of a function of ω₁, ω₂, ω₃ along Euler's equations."""
    return total_derivative(expression, dict(zip(OMEGA, body_accelerations(torque), strict=True)))


def axis_jacobian(axis: int) -> Matrix:
    """Euler's equations linearised about ω = ω e_k (k = 1, 2, 3), 3×3, in 1/s."""
    spin = _spin(axis)
    jacobian = body_accelerations().jacobian(OMEGA)
    return jacobian.subs({w: 0 for w in OMEGA if w is not spin})


def axis_growth(axis: int) -> Expr:
    """The square of the growth rate of a small deviation from rotation about e_k (1/s²).

    Negative: the axis oscillates with the root of minus this.  Positive: it runs away.

    >>> axis_growth(3)
    -omega3**2*(lambda1 - lambda3)*(lambda2 - lambda3)/(lambda1*lambda2)
    """
    # The characteristic polynomial is σ (σ² − growth): one zero belongs to a change of spin.
    return sympy.factor(-axis_jacobian(axis).charpoly().all_coeffs()[-2])


def _spin(axis: int) -> Symbol:
    if axis not in (1, 2, 3):
        raise ValueError(f"no axis {axis}: a body has axes 1, 2 and 3")
    return OMEGA[axis - 1]
