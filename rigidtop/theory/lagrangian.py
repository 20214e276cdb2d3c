"""Mechanics for any L(q, q̇), and by its Legendre transform for any H(q, p): pure functions.

The top is one argument of many.

Coordinates and velocities are sequences of plain symbols in the same order.

>>> from sympy import symbols
>>> m, k, x, v, a = symbols("m k x v a", positive=True)
>>> oscillator = m*v**2/2 - k*x**2/2
>>> euler_lagrange(oscillator, [x], [v], [a])
Matrix([[a*m + k*x]])
>>> energy(oscillator, [v])
k*x**2/2 + m*v**2/2
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy
from sympy import Expr, Matrix, Symbol, hessian
from sympy.solvers.solveset import NonlinearError

from rigidtop.theory.rotation import total_derivative
from rigidtop.theory.trig import reduce_ratio, reduce_trig

Symbols = Sequence[Symbol]


def momenta(L: Expr, qdot: Symbols) -> Matrix:
    """p = ∂L/∂q̇ (n×1)."""
    return Matrix([sympy.factor_terms(L.diff(v)) for v in qdot])


def mass_matrix(L: Expr, qdot: Symbols) -> Matrix:
    """∂²L/∂q̇∂q̇ (n×n), with products of sines and cosines in normal form."""
    return reduce_trig(hessian(L, list(qdot)), keep="sin")


def euler_lagrange(L: Expr, q: Symbols, qdot: Symbols, qddot: Symbols) -> Matrix:
    """d/dt ∂L/∂q̇ − ∂L/∂q (n×1), which vanishes along the motion: Lagrange's equations (2.29)."""
    rates = {**dict(zip(q, qdot, strict=True)), **dict(zip(qdot, qddot, strict=True))}
    force = Matrix([L.diff(x) for x in q])
    return total_derivative(momenta(L, qdot), rates) - force


def accelerations(L: Expr, q: Symbols, qdot: Symbols) -> Matrix:
    """q̈ from Lagrange's equations (n×1).

    Raises ValueError where the mass matrix is singular for every q.
    """
    mass = mass_matrix(L, qdot)
    adjugate, determinant = mass.adjugate(), reduce_trig(mass.det())
    if determinant == 0:
        raise ValueError("the mass matrix is singular: some velocity does not enter L")
    rates = dict(zip(q, qdot, strict=True))
    force = Matrix([L.diff(x) for x in q]) - total_derivative(momenta(L, qdot), rates)
    return (adjugate * force / determinant).applyfunc(reduce_ratio)


def energy(L: Expr, qdot: Symbols) -> Expr:
    """Jacobi's integral Σ p q̇ − L, which is T + V for a natural system; constant if ∂L/∂t = 0."""
    return sympy.expand(momenta(L, qdot).dot(Matrix(qdot)) - L)


def cyclic(L: Expr, q: Symbols) -> tuple[Symbol, ...]:
    """The coordinates that L does not contain; the momentum of each is conserved."""
    return tuple(x for x in q if sympy.expand(L.diff(x)) == 0)


def inverse_momenta(L: Expr, qdot: Symbols, p: Symbols) -> dict[Symbol, Expr]:
    """q̇(q, p), which p = ∂L/∂q̇ defines.

    Raises ValueError where it does not: some velocity does not enter L, or several velocities have
    the same momentum.

    >>> from sympy import sqrt, symbols
    >>> m, v, P = symbols("m v P", positive=True)
    >>> inverse_momenta(-m*sqrt(1 - v**2), [v], [P])     # a relativistic particle, c = 1
    {v: P/sqrt(P**2 + m**2)}
    """
    equations = list(momenta(L, qdot) - Matrix(p))
    try:
        found = [dict(zip(qdot, x, strict=True)) for x in sympy.linsolve(equations, *qdot)]
    except NonlinearError:
        found = sympy.solve(equations, list(qdot), dict=True)
    if len(found) != 1 or any(x.free_symbols & set(qdot) for x in found[0].values()):
        raise ValueError("the momenta do not determine the velocities")
    return {v: reduce_ratio(x) for v, x in found[0].items()}


def cyclic_velocities(L: Expr, velocities: Symbols, p: Symbols) -> dict[Symbol, Expr]:
    """The velocities of cyclic coordinates in terms of their constant momenta `p`."""
    return inverse_momenta(L, velocities, p)


def routhian(L: Expr, velocities: Symbols, p: Symbols) -> Expr:
    """L − Σ p q̇ over the cyclic coordinates, their velocities eliminated.

    Its Euler–Lagrange equations are those of the coordinates that are left (Goldstein 8.3 has the
    opposite sign).
    """
    solution = cyclic_velocities(L, velocities, p)
    reduced = L - sum(pk * v for v, pk in zip(velocities, p, strict=True))
    return reduced.subs(solution, simultaneous=True)


def effective_potential(L: Expr, velocities: Symbols, p: Symbols, rest: Symbols) -> Expr:
    """Minus the Routhian where the velocities `rest` that are left vanish."""
    return -routhian(L, velocities, p).subs(dict.fromkeys(rest, 0))


def hamiltonian(L: Expr, qdot: Symbols, p: Symbols) -> Expr:
    """H(q, p) = Σ p q̇ − L, the Legendre transform of L; it undoes itself.

    >>> from sympy import symbols
    >>> m, k, x, v, P = symbols("m k x v P", positive=True)
    >>> H = hamiltonian(m*v**2/2 - k*x**2/2, [v], [P])
    >>> H
    P**2/(2*m) + k*x**2/2
    >>> hamiltonian(H, [P], [v])
    -k*x**2/2 + m*v**2/2
    """
    transform = sum(pk * v for v, pk in zip(qdot, p, strict=True)) - L
    return sympy.expand(transform.subs(inverse_momenta(L, qdot, p), simultaneous=True))


def hamilton_equations(H: Expr, q: Symbols, p: Symbols) -> Matrix:
    """q̇ = ∂H/∂p and ṗ = −∂H/∂q (2n×1), the coordinates first.

    >>> from sympy import symbols
    >>> m, k, x, P = symbols("m k x P", positive=True)
    >>> hamilton_equations(P**2/(2*m) + k*x**2/2, [x], [P])
    Matrix([
    [ P/m],
    [-k*x]])
    """
    return Matrix([*(H.diff(pk) for pk in p), *(-H.diff(x) for x in q)])


@dataclass(frozen=True)
class Linearisation:
    """M δq̈ + G δq̇ + K δq = 0 about a steady motion; M and K symmetric, G antisymmetric (n×n)."""

    mass: Matrix
    gyroscopic: Matrix
    stiffness: Matrix

    def characteristic(self, frequency: Expr) -> Expr:
        """The determinant whose zeros are the squares of the angular frequencies."""
        pencil = -(frequency**2) * self.mass + self.stiffness
        return (pencil + sympy.I * frequency * self.gyroscopic).det()


def linearise(L: Expr, q: Symbols, qdot: Symbols, about: Mapping[Symbol, Expr]) -> Linearisation:
    """Small deviations from a steady motion, in which no second derivative of L changes in time.

    `about` gives the steady values of coordinates and velocities.
    """
    mixed = Matrix([[L.diff(v, x) for x in q] for v in qdot])
    return Linearisation(
        hessian(L, list(qdot)).subs(about),
        (mixed - mixed.T).subs(about),
        -hessian(L, list(q)).subs(about),
    )
