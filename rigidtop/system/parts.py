"""What a system is made of: masses and bodies, with their places as functions of coordinates.

From them come T and V, and besides, without any Lagrangian, the equations by Newton and Euler.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy
from sympy import Expr, Integer, Matrix, MatrixBase, Rational

from rigidtop.errors import RigidtopError
from rigidtop.parameters import in_one_line
from rigidtop.system.names import Given, Names, expression
from rigidtop.theory.rotation import vee
from rigidtop.theory.trig import reduce_trig


@dataclass(frozen=True)
class Mass:
    """A mass point: its mass, and where it is (2 or 3 components in space).

    >>> from sympy import cos, sin, symbols
    >>> m, l, theta = symbols("m l theta")
    >>> Mass(m, [l*sin(theta), -l*cos(theta)]).place.T
    Matrix([[l*sin(theta), -l*cos(theta), 0]])
    """

    mass: Expr
    place: MatrixBase

    def __init__(self, mass: Expr, place: Given) -> None:
        object.__setattr__(self, "mass", expression("a mass", mass))
        object.__setattr__(self, "place", _place(place))


@dataclass(frozen=True)
class Body:
    """A rigid body: mass, principal moments about its centre of mass, where that is, attitude.

    The columns of `attitude` (3×3, such as `rigidtop.theory.rotation.euler_matrix`) are e₁, e₂, e₃
    in space.  With the moments about a point at rest, and `mass` 0, the body turns about it.
    """

    mass: Expr
    moments: tuple[Expr, Expr, Expr]
    place: MatrixBase
    attitude: MatrixBase

    def __init__(self, mass: Expr, moments: Sequence[Expr], place: Given, attitude: Given) -> None:
        object.__setattr__(self, "mass", expression("a mass", mass))
        made = tuple(expression("a moment", x) for x in moments)
        if len(made) != 3:
            raise RigidtopError(f"a body has three principal moments, not {len(made)}")
        object.__setattr__(self, "moments", made)
        object.__setattr__(self, "place", _place(place))
        if not isinstance(attitude, MatrixBase) or attitude.shape != (3, 3):
            raise RigidtopError("an attitude is a 3×3 matrix with e₁, e₂, e₃ as its columns")
        object.__setattr__(self, "attitude", attitude.as_immutable())


Part = Mass | Body


def _place(given: Given) -> MatrixBase:
    """Three components."""
    if isinstance(given, (str, bytes)) or not hasattr(given, "__len__"):
        raise RigidtopError(f"a place has two or three components, not {in_one_line(given)}")
    row = [expression("a component", x) for x in given]
    if len(row) not in (2, 3):
        raise RigidtopError(f"a place has two or three components, not {len(row)}")
    return sympy.ImmutableMatrix([*row, Integer(0)][:3])


def velocity(place: MatrixBase, names: Names) -> Matrix:
    """ṙ of a place in plain symbols (3×1)."""
    return names.rate(place, dict(zip(names.q, names.v, strict=True)))


def spin(attitude: MatrixBase, names: Names) -> Matrix:
    """ω in body components, from RᵀṘ = hat(ω) (3×1)."""
    turning = reduce_trig(attitude.T * velocity(attitude, names))
    try:
        return vee(turning)
    except ValueError:
        raise RigidtopError("the attitude is no rotation: RᵀR is not 1") from None


def kinetic_energy(parts: Sequence[Part], names: Names) -> Expr:
    """½ Σ m ṙ² + ½ Σ λω², in plain symbols."""
    total = Integer(0)
    for part in parts:
        v = velocity(names.plain(part.place), names)
        total += Rational(1, 2) * names.plain(part.mass) * reduce_trig(v.dot(v))
        if isinstance(part, Body):
            omega = spin(names.plain(part.attitude), names)
            moments = map(names.plain, part.moments)
            total += sum(x * w**2 for x, w in zip(moments, omega, strict=True)) / 2
    return total


def potential_energy(parts: Sequence[Part], gravity: MatrixBase) -> Expr:
    """−Σ m g·r for the `gravity` g (3×1)."""
    return -sympy.Add(*(part.mass * gravity.dot(part.place) for part in parts))


def newton_euler(
    parts: Sequence[Part], names: Names, forces: Sequence[Expr]
) -> tuple[Matrix, list[Expr]]:
    """M and f of M q̈ = f by d'Alembert: Σ (m r̈·∂v/∂q̇ + (λω̇ + ω × λω)·∂ω/∂q̇) = Q.

    In plain symbols; `forces` are all generalised forces, those of the potential too.  Nothing is
    differentiated by a coordinate that is an energy.
    """
    n = len(names.q)
    mass = sympy.zeros(n, n)
    force = [*forces]
    freely = {**names.rates, **dict.fromkeys(names.v, Integer(0))}
    for part in parts:
        v = velocity(names.plain(part.place), names)
        rows = [(v, names.plain(part.mass), Matrix([0, 0, 0]))]
        if isinstance(part, Body):
            omega = spin(names.plain(part.attitude), names)
            moments = sympy.diag(*map(names.plain, part.moments))
            rows.append((omega, moments, omega.cross(moments * omega)))
        for moved, inertia, turning in rows:
            jacobian = moved.jacobian(list(names.v))
            bias = names.rate(moved, freely)
            mass += jacobian.T * (inertia * jacobian)
            pushed = jacobian.T * (inertia * bias + turning)
            force = [f - x for f, x in zip(force, pushed, strict=True)]
    return mass, force
