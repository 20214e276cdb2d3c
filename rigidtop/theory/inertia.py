"""Inertia tensors of point masses and of solids, parallel axes, principal axes."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache

import sympy
from sympy import Add, Expr, ImmutableMatrix, Matrix, MatrixBase, Symbol, cos, eye, pi, sin

from rigidtop.theory.trig import reduce_trig


def point_masses(masses: Iterable[tuple[Expr, MatrixBase]]) -> Matrix:
    """Σ m (r² 1 − r rᵀ) about the origin (3×3, kg m²) of pairs (m, r) with r 3×1."""
    total = sympy.zeros(3)
    for mass, r in masses:
        total += mass * (r.dot(r) * eye(3) - r * r.T)
    return total


def parallel_axis(about_centre: MatrixBase, mass: Expr, shift: MatrixBase) -> Matrix:
    """Steiner: the tensor about a point at −`shift` from the centre of mass (3×3, kg m²)."""
    return about_centre + point_masses([(mass, Matrix(shift))])


Limits = tuple[tuple[Symbol, Expr, Expr], ...]


@cache
def _integral(position: ImmutableMatrix, limits: Limits, density: Expr) -> Expr:
    """∫ d³r of the density, once for each: claims, exercises and figures ask for the same."""
    jacobian = reduce_trig(position.jacobian([limit[0] for limit in limits]).det())
    integrand = density * jacobian
    for limit in limits:
        terms = Add.make_args(sympy.expand(integrand))
        parts = [term.as_independent(limit[0], as_Add=False) for term in terms]
        integrand = Add(*(outside * _single(inside, limit) for outside, inside in parts))
    return sympy.factor(integrand)


@cache
def _single(part: Expr, limit: tuple[Symbol, Expr, Expr]) -> Expr:
    """∫ of a product of powers and of sines and cosines of one parameter: they are few."""
    return sympy.integrate(part, limit)


@dataclass(frozen=True)
class Solid:
    """A uniform solid, swept by three parameters.

    `position` is 3×1 in the parameters, each with its limits; an inner limit may depend on outer
    parameters, which stand behind it.  Mass, centre and inertia are integrals over the solid.
    """

    position: Matrix
    limits: Limits

    def integral(self, density: Expr) -> Expr:
        """∫ d³r of `density`, given in the parameters."""
        return _integral(self.position.as_immutable(), self.limits, sympy.sympify(density))

    def named(self, *parameters: Symbol) -> Solid:
        """The same solid with other names for its parameters, for print."""
        names = dict(zip((limit[0] for limit in self.limits), parameters, strict=True))
        limits = tuple(sympy.Tuple(*limit).xreplace(names).args for limit in self.limits)
        return Solid(self.position.xreplace(names), limits)

    def volume(self) -> Expr:
        """The volume ∫ d³r of the solid (m³)."""
        return self.integral(sympy.Integer(1))

    def centre(self) -> Matrix:
        """The centre of mass (3×1, m)."""
        return self.position.applyfunc(lambda x: sympy.cancel(self.integral(x) / self.volume()))

    def inertia(self, mass: Expr) -> Matrix:
        """About the origin of `position`, for the whole mass (3×3, kg m²)."""
        density = mass / self.volume()
        integrand = point_masses([(density, self.position)])
        return integrand.applyfunc(lambda entry: sympy.cancel(self.integral(entry)))


_u, _v, _w = sympy.symbols("u v w", real=True)


def cuboid(a: Expr, b: Expr, c: Expr) -> Solid:
    """A brick with edges a, b, c along the axes, about its centre.

    >>> a, b, c, M = sympy.symbols("a b c M", positive=True)
    >>> cuboid(a, b, c).inertia(M)[2, 2]
    M*a**2/12 + M*b**2/12
    """
    limits = ((_u, -a / 2, a / 2), (_v, -b / 2, b / 2), (_w, -c / 2, c / 2))
    return Solid(Matrix([_u, _v, _w]), limits)


def ellipsoid(a: Expr, b: Expr, c: Expr) -> Solid:
    """An ellipsoid with semi-axes a, b, c, about its centre."""
    position = Matrix([a * _u * sin(_v) * cos(_w), b * _u * sin(_v) * sin(_w), c * _u * cos(_v)])
    return Solid(position, ((_u, 0, 1), (_v, 0, pi), (_w, 0, 2 * pi)))


def sphere(radius: Expr) -> Solid:
    """A ball with its centre at the origin."""
    return ellipsoid(radius, radius, radius)


def cylinder(radius: Expr, height: Expr) -> Solid:
    """A cylinder along e₃, about its centre."""
    position = Matrix([_u * cos(_v), _u * sin(_v), _w])
    return Solid(position, ((_u, 0, radius), (_v, 0, 2 * pi), (_w, -height / 2, height / 2)))


def cone(radius: Expr, height: Expr) -> Solid:
    """A cone along e₃ that stands on its apex, the origin: the top of the lecture.

    >>> r, h, M = sympy.symbols("r h M", positive=True)
    >>> cone(r, h).centre()[2], cone(r, h).inertia(M)[2, 2]
    (3*h/4, 3*M*r**2/10)
    """
    position = Matrix([_u * _w * cos(_v), _u * _w * sin(_v), _w])
    return Solid(position, ((_u, 0, radius / height), (_v, 0, 2 * pi), (_w, 0, height)))


def hemisphere(radius: Expr) -> Solid:
    """The half of a ball with z > 0, about the centre of the ball."""
    position = _u * Matrix([sin(_v) * cos(_w), sin(_v) * sin(_w), cos(_v)])
    return Solid(position, ((_u, 0, radius), (_v, 0, pi / 2), (_w, 0, 2 * pi)))


def torus(ring: Expr, tube: Expr) -> Solid:
    """A torus about e₃ with mean radius `ring` and tube radius `tube` ≤ `ring`."""
    across = ring + _u * cos(_v)
    position = Matrix([across * cos(_w), across * sin(_w), -_u * sin(_v)])
    return Solid(position, ((_u, 0, tube), (_v, 0, 2 * pi), (_w, 0, 2 * pi)))


def principal_axes(inertia: MatrixBase) -> tuple[tuple[Expr, ...], Matrix]:
    """Principal moments, ascending where they can be compared, and O with the axes as columns.

    O is orthogonal and right-handed (det O = 1), so it is a rotation.  Equal moments leave the
    choice of axes open; an orthogonal one is made.  Raises ValueError for a tensor that is not
    symmetric 3×3.

    >>> moments, O = principal_axes(Matrix([[3, 1, 0], [1, 3, 0], [0, 0, 5]]))
    >>> moments, (O.T * Matrix([[3, 1, 0], [1, 3, 0], [0, 0, 5]]) * O).is_diagonal(), O.det()
    ((2, 4, 5), True, 1)
    """
    if inertia.shape != (3, 3) or not inertia.is_symmetric():
        raise ValueError("an inertia tensor is a symmetric 3×3 matrix")
    pairs: list[tuple[Expr, Matrix]] = []
    for moment, _, vectors in inertia.eigenvects():
        for vector in sympy.GramSchmidt(list(vectors), orthonormal=True):
            pairs.append((sympy.simplify(moment), vector.applyfunc(sympy.radsimp)))
    if all(moment.is_number for moment, _ in pairs):
        pairs.sort(key=lambda pair: sympy.re(pair[0]).evalf(30))
    moments: Sequence[Expr] = [moment for moment, _ in pairs]
    axes = Matrix.hstack(*(vector for _, vector in pairs))
    if sympy.simplify(axes.det()) == -1:
        axes[:, 2] = -axes[:, 2]
    return tuple(moments), axes
