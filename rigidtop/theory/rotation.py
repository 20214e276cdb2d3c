"""Rotations: Rodrigues, Euler angles z–y′–z″, unit quaternions, and ω from Ṙ.

Throughout, R takes body components to space components: its columns are e₁, e₂, e₃ in the space
frame, and R = Rz(φ) Ry(θ) Rz(ψ) (section 3.3).
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from sympy import (
    Expr,
    ImmutableMatrix,
    Matrix,
    MatrixBase,
    cos,
    eye,
    sin,
)

from rigidtop.theory import symbols as s
from rigidtop.theory.rates import total_derivative as total_derivative
from rigidtop.theory.trig import reduce_trig

X_AXIS, Y_AXIS, Z_AXIS = (ImmutableMatrix(eye(3)[:, k]) for k in range(3))


def hat(v: MatrixBase) -> Matrix:
    """The antisymmetric 3×3 matrix with hat(v) w = v × w.

    >>> from sympy.abc import a, b, c
    >>> hat(Matrix([a, b, c])) * Matrix([1, 0, 0])
    Matrix([
    [ 0],
    [ c],
    [-b]])
    """
    return Matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def vee(m: MatrixBase) -> Matrix:
    """The vector v with hat(v) = m, for an antisymmetric m.  Raises ValueError for another."""
    # In normal form already, as a rule: then no second reduction is needed.
    symmetric = (m + m.T).expand()
    if not (symmetric.is_zero_matrix or reduce_trig(symmetric).is_zero_matrix):
        raise ValueError("vee needs an antisymmetric matrix")
    return Matrix([m[2, 1], m[0, 2], m[1, 0]])


def rotation(axis: MatrixBase, angle: Expr) -> Matrix:
    """Rodrigues: the active rotation about the unit vector `axis` (3×1) by `angle` (radians)."""
    along = axis * axis.T
    return along + cos(angle) * (eye(3) - along) + sin(angle) * hat(axis)


def rotation_x(angle: Expr) -> Matrix:
    """The turn by an angle (rad) about x̂."""
    return rotation(X_AXIS, angle)


def rotation_y(angle: Expr) -> Matrix:
    """The turn by an angle (rad) about ŷ."""
    return rotation(Y_AXIS, angle)


def rotation_z(angle: Expr) -> Matrix:
    """The turn by an angle (rad) about ẑ."""
    return rotation(Z_AXIS, angle)


def euler_matrix(phi: Expr = s.phi, theta: Expr = s.theta, psi: Expr = s.psi) -> Matrix:
    """R = Rz(φ) Ry(θ) Rz(ψ), body to space; the matrix printed as (3.47).

    >>> from sympy import pi
    >>> euler_matrix(0, pi/2, 0) * Matrix([0, 0, 1])    # e₃ lies along x̂
    Matrix([
    [1],
    [0],
    [0]])
    """
    return rotation_z(phi) * rotation_y(theta) * rotation_z(psi)


def primed_matrix(phi: Expr = s.phi, theta: Expr = s.theta) -> Matrix:
    """Rz(φ) Ry(θ): its columns are e₁′, e₂′, e₃ in the space frame."""
    return rotation_z(phi) * rotation_y(theta)


def quaternion_matrix(q: MatrixBase) -> Matrix:
    """R of the unit quaternion (q₀, q₁, q₂, q₃), scalar first, body to space.

    It is 1 + 2 q₀ hat(v) + 2 hat(v)² with v = (q₁, q₂, q₃), orthogonal only where |q| = 1.
    """
    v = hat(Matrix(q[1:4]))
    return eye(3) + 2 * q[0] * v + 2 * v * v


EULER_RATES: Mapping[Expr, Expr] = {
    s.theta: s.thetadot,
    s.phi: s.phidot,
    s.psi: s.psidot,
    s.thetadot: s.thetaddot,
    s.phidot: s.phiddot,
    s.psidot: s.psiddot,
}
"""Which symbol is whose rate, for the Euler angles."""


def omega_space(attitude: MatrixBase, rates: Mapping[Expr, Expr]) -> Matrix:
    """ω in the space frame, from ṘRᵀ = hat(ω) (3×1, rad/s)."""
    return vee(reduce_trig(total_derivative(attitude, rates) * attitude.T))


def omega_body(attitude: MatrixBase, rates: Mapping[Expr, Expr]) -> Matrix:
    """ω in the body frame, from RᵀṘ = hat(ω) (3×1, rad/s)."""
    return vee(reduce_trig(attitude.T * total_derivative(attitude, rates)))


@cache
def euler_omega(frame: str) -> ImmutableMatrix:
    """ω from Euler angles and rates, as components in a frame (3×1, rad/s).

    `frame` is "space", "body", or "primed" for e₁′, e₂′, e₃; in the last it is (3.42).

    >>> euler_omega("primed").T
    Matrix([[-phidot*sin(theta), thetadot, phidot*cos(theta) + psidot]])
    """
    if frame == "space":
        return ImmutableMatrix(omega_space(euler_matrix(), EULER_RATES))
    if frame == "primed":
        return ImmutableMatrix(reduce_trig(primed_matrix().T * euler_omega("space")))
    if frame == "body":
        return ImmutableMatrix(reduce_trig(rotation_z(s.psi).T * euler_omega("primed")))
    raise ValueError(f"unknown frame {frame!r}: it is 'space', 'body' or 'primed'")


def quaternion_rates(q: MatrixBase, omega: MatrixBase) -> Matrix:
    """q̇ = ½ q ∘ (0, ω) for ω in body components (4×1, 1/s).

    `rigidtop.derivations` shows that RᵀṘ = hat(ω) follows from it.
    """
    v, w = Matrix(q[1:4]), Matrix(omega)
    return Matrix([-v.dot(w), *(q[0] * w + v.cross(w))]) / 2
