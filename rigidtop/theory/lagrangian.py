"""Mechanics for any L(q, q̇), and by its Legendre transform for any H(q, p): pure functions.

The top is one argument of many.

Coordinates and velocities are sequences in the same order: plain symbols, or functions of time and
their derivatives, such as SymPy's `dynamicsymbols`.  Whatever else L has of the time counts: other
functions of it (a given motion of the pivot), and the symbol named t itself.

>>> from sympy import symbols
>>> m, k, x, v, a = symbols("m k x v a", positive=True)
>>> oscillator = m*v**2/2 - k*x**2/2
>>> euler_lagrange(oscillator, [x], [v], [a])
Matrix([[a*m + k*x]])
>>> energy(oscillator, [v])
k*x**2/2 + m*v**2/2
>>> from sympy.physics.mechanics import dynamicsymbols
>>> r, phi = dynamicsymbols("r phi")
>>> orbit = m*(r.diff()**2 + r**2*phi.diff()**2)/2 - k*r**2/2
>>> accelerations(orbit, [r, phi], [r.diff(), phi.diff()])[1]
-2*Derivative(phi(t), t)*Derivative(r(t), t)/r(t)

Raises ValueError for names that are no symbols and no functions of time, that stand twice or do
not pair, and for derivatives in L that are no velocities.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy
from sympy import Derivative, Expr, Matrix, MatrixBase
from sympy.solvers.solveset import NonlinearError

from rigidtop.theory.rates import slope, total_derivative
from rigidtop.theory.trig import reduce_ratio, reduce_trig

Names = Sequence[Expr]
"""Symbols, or functions of time and their derivatives."""


def _check(function: Expr, **names: Names) -> None:
    """Raises ValueError unless L or H is an expression and the names are names, all different,
    that go with each other."""
    if not isinstance(function, Expr):
        raise ValueError(f"{function!r} is no expression of SymPy: L or H has to be one")
    for what, group in names.items():
        if not isinstance(group, (Sequence, MatrixBase)):
            raise ValueError(f"the {what} are {group!r}: a sequence was expected, such as [x]")
        for x in group:
            if not getattr(x, "_diff_wrt", False):
                raise ValueError(f"{x!r} is among the {what}: no symbol and no function of time")
        if len({*group}) < len(group):
            raise ValueError(f"among the {what}, {', '.join(map(str, group))}, one stands twice")
    if len({len(group) for group in names.values()}) > 1:
        counts = ", ".join(f"{len(group)} {what}" for what, group in names.items())
        raise ValueError(f"{counts}: there have to be as many of each")


def _check_motion(L: Expr, q: Names, qdot: Names, qddot: Names = ()) -> None:
    """Besides: raises ValueError where a rate is another's, or L has one that is no velocity."""
    _check(L, coordinates=q, velocities=qdot)
    for x, v in (*zip(q, qdot, strict=True), *zip(qdot, qddot, strict=False)):
        if isinstance(v, Derivative) and v != x.diff(*v.variables[:1]):
            raise ValueError(f"{v} is given as the rate of {x}")
    functions = [x for x in q if not x.is_Symbol]
    for x in L.atoms(Derivative) - {*qdot}:
        if x.has(*functions) and not {*x.variables} <= {*q}:
            raise ValueError(f"L has {x}, which is none of the velocities")


def momenta(L: Expr, qdot: Names) -> Matrix:
    """The momenta p = ∂L/∂q̇ (n×1)."""
    _check(L, velocities=qdot)
    return Matrix([sympy.factor_terms(slope(L, v)) for v in qdot])


def mass_matrix(L: Expr, qdot: Names) -> Matrix:
    """∂²L/∂q̇∂q̇ (n×n), with products of sines and cosines in normal form."""
    _check(L, velocities=qdot)
    return reduce_trig(_second(L, qdot), keep="sin")


def _second(L: Expr, names: Names) -> Matrix:
    """The matrix (n×n) of the second derivatives of L by the names."""
    return Matrix([[slope(slope(L, x), y) for y in names] for x in names])


def euler_lagrange(L: Expr, q: Names, qdot: Names, qddot: Names) -> Matrix:
    """d/dt ∂L/∂q̇ − ∂L/∂q (n×1), which vanishes along the motion: Lagrange's equations (2.29)."""
    _check(L, velocities=qdot, accelerations=qddot)
    _check_motion(L, q, qdot, qddot)
    rates = {**dict(zip(q, qdot, strict=True)), **dict(zip(qdot, qddot, strict=True))}
    force = Matrix([slope(L, x) for x in q])
    return total_derivative(momenta(L, qdot), rates) - force


def accelerations(L: Expr, q: Names, qdot: Names) -> Matrix:
    """q̈ from Lagrange's equations (n×1).

    Raises ValueError where the mass matrix is singular for every q.
    """
    _check_motion(L, q, qdot)
    mass = mass_matrix(L, qdot)
    adjugate, determinant = mass.adjugate(), reduce_trig(mass.det())
    if determinant == 0:
        raise ValueError("the mass matrix is singular: some velocity does not enter L")
    # What the accelerations add stands on the other side.
    rates = {**dict(zip(q, qdot, strict=True)), **dict.fromkeys(qdot, sympy.S.Zero)}
    force = Matrix([slope(L, x) for x in q]) - total_derivative(momenta(L, qdot), rates)
    return (adjugate * force / determinant).applyfunc(reduce_ratio)


def energy(L: Expr, qdot: Names) -> Expr:
    """Jacobi's integral Σ p q̇ − L, which is T + V for a natural system; constant if ∂L/∂t = 0."""
    return sympy.expand(momenta(L, qdot).dot(Matrix(qdot)) - L)


def cyclic(L: Expr, q: Names) -> tuple[Expr, ...]:
    """The coordinates that L does not contain; the momentum of each is conserved."""
    _check(L, coordinates=q)
    return tuple(x for x in q if sympy.expand(L.diff(x)) == 0)


def inverse_momenta(L: Expr, qdot: Names, p: Names) -> dict[Expr, Expr]:
    """q̇(q, p), which p = ∂L/∂q̇ defines.

    Raises ValueError where it does not: some velocity does not enter L, or several velocities have
    the same momentum.

    >>> from sympy import sqrt, symbols
    >>> m, v, P = symbols("m v P", positive=True)
    >>> inverse_momenta(-m*sqrt(1 - v**2), [v], [P])     # a relativistic particle, c = 1
    {v: P/sqrt(P**2 + m**2)}
    """
    _check(L, velocities=qdot, momenta=p)
    equations = list(momenta(L, qdot) - Matrix(p))
    try:
        solutions = [dict(zip(qdot, x, strict=True)) for x in sympy.linsolve(equations, *qdot)]
    except NonlinearError:
        solutions = sympy.solve(equations, list(qdot), dict=True)
    if len(solutions) != 1 or any(x.has(*qdot) for x in solutions[0].values()):
        raise ValueError("the momenta do not determine the velocities")
    return {v: reduce_ratio(x) for v, x in solutions[0].items()}


def cyclic_velocities(L: Expr, velocities: Names, p: Names) -> dict[Expr, Expr]:
    """The velocities of cyclic coordinates in terms of their constant momenta `p`."""
    return inverse_momenta(L, velocities, p)


def routhian(L: Expr, velocities: Names, p: Names) -> Expr:
    """L − Σ p q̇ over the cyclic coordinates, their velocities eliminated.

    Its Euler–Lagrange equations are those of the coordinates that are left (Goldstein 8.3 has the
    opposite sign).
    """
    solution = cyclic_velocities(L, velocities, p)
    reduced = L - sum(pk * v for v, pk in zip(velocities, p, strict=True))
    return reduced.subs(solution, simultaneous=True)


def effective_potential(L: Expr, velocities: Names, p: Names, rest: Names) -> Expr:
    """Minus the Routhian where the velocities `rest` that are left vanish."""
    return -routhian(L, velocities, p).subs(dict.fromkeys(rest, 0))


def hamiltonian(L: Expr, qdot: Names, p: Names) -> Expr:
    """H(q, p) = Σ p q̇ − L, the Legendre transform of L; it undoes itself.

    >>> from sympy import symbols
    >>> m, k, x, v, P = symbols("m k x v P", positive=True)
    >>> H = hamiltonian(m*v**2/2 - k*x**2/2, [v], [P])
    >>> H
    P**2/(2*m) + k*x**2/2
    >>> hamiltonian(H, [P], [v])
    -k*x**2/2 + m*v**2/2
    """
    _check(L, velocities=qdot, momenta=p)
    transform = sum(pk * v for v, pk in zip(qdot, p, strict=True)) - L
    return sympy.expand(transform.subs(inverse_momenta(L, qdot, p), simultaneous=True))


def hamilton_equations(H: Expr, q: Names, p: Names) -> Matrix:
    """q̇ = ∂H/∂p and ṗ = −∂H/∂q (2n×1), the coordinates first.

    >>> from sympy import symbols
    >>> m, k, x, P = symbols("m k x P", positive=True)
    >>> hamilton_equations(P**2/(2*m) + k*x**2/2, [x], [P])
    Matrix([
    [ P/m],
    [-k*x]])
    """
    _check(H, coordinates=q, momenta=p)
    return Matrix([*(H.diff(pk) for pk in p), *(-H.diff(x) for x in q)])
