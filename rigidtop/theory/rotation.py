"""Rotations: Rodrigues, Euler angles z–y′–z″, unit quaternions, and ω from Ṙ.

Throughout, R takes body components to space components: its columns are e₁, e₂, e₃ in the space
frame, and R = Rz(φ) Ry(θ) Rz(ψ) (section 3.3).
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import sympy
from sympy import (
    Derivative,
    Dummy,
    Expr,
    ImmutableMatrix,
    Integer,
    Matrix,
    MatrixBase,
    cos,
    eye,
    sin,
)
from sympy.core.function import AppliedUndef

from rigidtop.theory import symbols as s
from rigidtop.theory.lettered import Lettered
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


def total_derivative(expression: Expr | MatrixBase, rates: Mapping[Expr, Expr]) -> Expr | Matrix:
    """d/dt by the chain rule: Σ ∂/∂q · q̇ over the q in `rates`, and ∂/∂t.

    The q are symbols, or functions of time and their derivatives.  A function of time that has no
    rate there is differentiated; the symbol named t is the time; other symbols are constant.

    >>> total_derivative(sin(s.theta), {s.theta: s.thetadot})
    thetadot*cos(theta)
    >>> x = sympy.Function("x")(s.t)
    >>> total_derivative(s.t*x**2, {x: s.omega})
    2*omega*t*x(t) + x(t)**2

    Raises ValueError where it cannot be known what a rate belongs to, or which symbol is the time.
    """
    if isinstance(expression, MatrixBase):
        return expression.applyfunc(lambda entry: total_derivative(entry, rates))
    moving = _moving(expression, rates)
    # A letter for each: SymPy would find a function within its own derivatives.
    letters = {x: x if x.is_Symbol else Dummy() for x in moving}
    lettered = expression.xreplace(letters)
    words = {letter: x for x, letter in letters.items()}
    present = lettered.free_symbols
    changing = (x for x in words if x in present and moving[words[x]] != 0)
    terms = (lettered.diff(x) * moving[words[x]] for x in changing)
    return sum((term.xreplace(words) for term in terms), Integer(0))


def _moving(expression: Expr, rates: Mapping[Expr, Expr]) -> dict[Expr, Expr]:
    """What changes in time, each with its rate: `rates`, the time, derivatives of the functions."""
    functions = {x.expr if isinstance(x, Derivative) else x for x in rates if not x.is_Symbol}
    unknown = [x for x in functions if not (isinstance(x, AppliedUndef) and len(x.args) == 1)]
    if unknown:
        raise ValueError(f"{unknown[0]} has a rate, but is no symbol and no function of time")
    times = {x.args[0] for x in functions}
    times |= {x for x in expression.free_symbols if _is_time(x)}
    if len(times) > 1:
        both = " and ".join(sorted(map(sympy.srepr, times)))
        raise ValueError(f"two times, {both}: there is only one")
    moving = {**dict.fromkeys(times, Integer(1)), **rates}
    for x in expression.atoms(AppliedUndef):
        if len(x.args) == 1 and x.args[0].is_Symbol and x.args[0] not in moving:
            raise ValueError(f"is {x.args[0]} in {x} the time? Then give it the rate 1, else 0")
    for x in expression.atoms(Derivative):
        own = functions & x.atoms(AppliedUndef)
        if x in rates or not own or not times & {*x.variables}:
            continue
        lower = [f for f in rates if f.has(*own) and rates[f] != f.diff(*times)]
        if lower or x.expr not in own:
            raise ValueError(f"{x} does not go with the rate given for {', '.join(map(str, own))}")
        moving[x] = x.diff(*times)
    return moving


def _is_time(symbol: Expr) -> bool:
    """By its name; but a t of one's own may be a thickness."""
    return str(symbol) == "t" and (not isinstance(symbol, Lettered) or symbol.quantity.unit == "s")


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
