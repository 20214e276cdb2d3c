"""What a system is made of: masses and bodies, with their places as functions of coordinates.

From them come T and V, and besides, without any Lagrangian, the equations: see `balance`.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass

import sympy
from sympy import Expr, Integer, Matrix, MatrixBase, Rational

from rigidtop.codegen.graph import Graph, somewhere
from rigidtop.errors import RigidtopError
from rigidtop.system.names import Given, PlainSymbols, expression, several
from rigidtop.theory.rotation import vee
from rigidtop.theory.trig import reduce_trig

ROUNDING = 1e-30
"""How well RᵀR has to be 1."""


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
        object.__setattr__(self, "place", checked_place(place))

    @property
    def expressions(self) -> tuple[Expr, ...]:
        """All expressions that it is given."""
        return (self.mass, *self.place)


@dataclass(frozen=True)
class Body:
    """A rigid body: mass, inertia about its centre of mass, where that is, attitude.

    `inertia` are the three principal moments, or a symmetric tensor (3×3) in the body's axes.  The
    columns of `attitude` (3×3, such as `rigidtop.theory.rotation.euler_matrix`) are e₁, e₂, e₃
    in space.  With the inertia about a point at rest, and `mass` 0, the body turns about it.

    >>> from sympy import eye
    >>> Body(1, [[2, 0, 1], [0, 3, 0], [1, 0, 4]], [0, 0, 0], eye(3)).inertia[0, 2]
    1
    """

    mass: Expr
    inertia: MatrixBase
    place: MatrixBase
    attitude: MatrixBase

    def __init__(self, mass: Expr, inertia: Given, place: Given, attitude: Given) -> None:
        object.__setattr__(self, "mass", expression("a mass", mass))
        object.__setattr__(self, "inertia", checked_inertia(inertia))
        object.__setattr__(self, "place", checked_place(place))
        object.__setattr__(self, "attitude", checked_attitude(attitude))

    @property
    def expressions(self) -> tuple[Expr, ...]:
        """All expressions that it is given."""
        return (self.mass, *self.inertia, *self.place, *self.attitude)


class Assembly(ABC):
    """Bodies that hang together, with the gravity that acts on them: see `linkage`."""

    @property
    @abstractmethod
    def expressions(self) -> tuple[Expr, ...]:
        """All expressions that its parts are given."""

    @property
    @abstractmethod
    def bodies(self) -> tuple[Body, ...]:
        """The parts that have mass or inertia."""

    @property
    @abstractmethod
    def potential(self) -> Expr:
        """The potential energy of its parts."""


Part = Mass | Body | Assembly


def single(parts: Sequence[Part]) -> tuple[Mass | Body, ...]:
    """The masses and bodies of which parts are made."""
    bodies: list[Mass | Body] = []
    for part in parts:
        bodies += part.bodies if isinstance(part, Assembly) else [part]
    return tuple(bodies)


def checked_attitude(attitude: Given) -> MatrixBase:
    """A rotation (3×3).  Raises RigidtopError for what is none."""
    if not isinstance(attitude, MatrixBase) or attitude.shape != (3, 3):
        raise RigidtopError("an attitude is a 3×3 matrix with e₁, e₂, e₃ as its columns")
    if not _is_orthogonal(attitude):
        raise RigidtopError("the attitude is no rotation: RᵀR is not 1")
    return attitude.as_immutable()


def checked_inertia(inertia: Given) -> MatrixBase:
    """A tensor of inertia (3×3) from principal moments or from rows."""
    rows = inertia.tolist() if isinstance(inertia, MatrixBase) else several(inertia)
    if len(rows) != 3:
        raise RigidtopError(f"a body has three principal moments, not {len(rows)}")
    if not any(hasattr(row, "__len__") for row in rows):
        return sympy.ImmutableMatrix.diag(*(expression("a moment", x) for x in rows))
    if any(not hasattr(row, "__len__") or len(row) != 3 for row in rows):
        raise RigidtopError("an inertia is three principal moments, or a tensor with 3×3 entries")
    tensor = sympy.ImmutableMatrix([[expression("a moment", x) for x in row] for row in rows])
    if tensor != tensor.T:
        raise RigidtopError("a tensor of inertia is symmetric: this one is not")
    return tensor


def checked_place(place: Given) -> MatrixBase:
    """The three components of a place; the third is 0 if two are given."""
    row = several(place)
    if len(row) not in (2, 3):
        raise RigidtopError(f"a place has two or three components, not {len(row)}")
    row = tuple(expression("a component", x) for x in row)
    return sympy.ImmutableMatrix([*row, Integer(0)][:3])


def _is_orthogonal(matrix: MatrixBase) -> bool:
    """Whether RᵀR is 1, at a point."""

    def holds(graph: Graph) -> bool:
        columns = [[graph.expression(x) for x in matrix.col(k)] for k in range(3)]
        return all(
            abs(graph.number(graph.total(map(graph.product, zip(a, b, strict=True)))) - (a is b))
            < ROUNDING
            for a in columns
            for b in columns
        )

    return somewhere(matrix, holds)


def velocity(place: MatrixBase, names: PlainSymbols) -> Matrix:
    """ṙ of a place in plain symbols (3×1)."""
    return names.rate(place, dict(zip(names.q, names.v, strict=True)))


def spin(attitude: MatrixBase, names: PlainSymbols) -> Matrix:
    """ω in body components, from RᵀṘ = hat(ω) (3×1)."""
    return vee(reduce_trig(attitude.T * velocity(attitude, names)))


def kinetic_energy(parts: Sequence[Part], names: PlainSymbols) -> Expr:
    """½ Σ m ṙ² + ½ Σ ω·Iω, in plain symbols."""
    total = Integer(0)
    for part in single(parts):
        v = velocity(names.plain(part.place), names)
        total += Rational(1, 2) * names.plain(part.mass) * reduce_trig(v.dot(v))
        if isinstance(part, Body):
            omega = spin(names.plain(part.attitude), names)
            total += omega.dot(names.plain(part.inertia) * omega) / 2
    return total


def potential_energy(parts: Sequence[Mass | Body], gravity: MatrixBase) -> Expr:
    """−Σ m g·r for the `gravity` g (3×1)."""
    along = [k for k in range(3) if gravity[k] != 0]
    return -sympy.Add(*(part.mass * gravity[k] * part.place[k] for part in parts for k in along))
