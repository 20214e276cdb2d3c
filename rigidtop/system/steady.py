"""Equilibria and steady motions: where they are, how they shake, whether they are stable."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product
from typing import TYPE_CHECKING, Any

import mpmath
import numpy as np
import sympy
from mpmath import matrix, mpc
from numpy.typing import NDArray
from sympy import Expr, Matrix, Rational, Symbol

from rigidtop.errors import RigidtopError
from rigidtop.proof import decide
from rigidtop.system.linear import linear, place_of
from rigidtop.system.names import numbers

if TYPE_CHECKING:
    from rigidtop.system.derived import Derived

MOST_ANGLES = 6
"""Of so many coordinates all angles of 0 and π are tried."""

DIGITS = 60
"""Of the rates of deviations: a double root is found to half of them."""

MANY = mpmath.MPContext()  # not mpmath's own, whose precision others may change meanwhile
MANY.dps = DIGITS

NEUTRAL = 1e-12
"""Relative to the rates: real parts and rates below this count as none."""

LEFT = 1e-50
"""What of `DIGITS` digits is left by rounding, relatively, is below this."""

LAST_DIGIT = 1e-15
"""By so much parameters are changed, relatively, to see whether their rounding decides."""


@dataclass(frozen=True, repr=False)
class Small:
    """Small deviations δ from a steady motion: M δ̈ + C δ̇ + K δ = 0, in the system's own letters.

    `about` are the steady values, of coordinates and velocities.  For forces that have a potential
    M and K are symmetric, and C is antisymmetric: gyroscopic.
    With constraints δ are the deviations of the coordinates that are `free`; the others follow.
    """

    system: Derived
    about: Mapping[Expr, Expr]
    mass: Matrix
    damping: Matrix
    stiffness: Matrix
    free: tuple[Expr, ...]

    def __repr__(self) -> str:
        place = ", ".join(f"{x} = {value}" for x, value in self.about.items() if value != 0)
        return (
            f"<Small deviations of {', '.join(map(str, self.free))}{place and f' about {place}'}>"
        )

    def characteristic(self, frequency: Expr) -> Expr:
        """The determinant whose zeros are the angular frequencies.

        >>> from sympy import symbols
        >>> from rigidtop.system.system import System
        >>> m, k, x, v, omega = symbols("m k x v omega", positive=True)
        >>> System(m*v**2/2 - k*x**2/2, [x], [v]).small({x: 0}).characteristic(omega)
        k - m*omega**2
        """
        matrix = -(frequency**2) * self.mass + sympy.I * frequency * self.damping + self.stiffness
        return sympy.expand(matrix.det(method="berkowitz"))

    def rates(self, parameters: Mapping[Expr, object]) -> NDArray[np.complex128]:
        """The 2n numbers s of the deviations e^{st} (1/s), by magnitude of the frequency.

        `parameters` gives a number for each parameter, and for each other letter of `about`.
        Raises RigidtopError where the steady motion does not exist for these numbers, or where
        the mass matrix is singular.
        """
        rates = np.array([complex(s) for s in _spectrum(*self._sides(self._at(parameters)))])
        return rates[np.lexsort((rates.imag, np.abs(rates.imag)))]

    def frequencies(self, parameters: Mapping[Expr, object]) -> NDArray[np.float64]:
        """Angular frequencies of what oscillates, once each (rad/s), increasing."""
        rates = self.rates(parameters)
        least = NEUTRAL * max(float(np.max(np.abs(rates))), 1e-300)
        return np.sort(rates.imag[rates.imag > least])

    def stability(self, parameters: Mapping[Expr, object]) -> str:
        """What the linear equations tell.

        "unstable" and "asymptotically stable" by the real parts, Lyapunov's theorems; "stable"
        where K is positive definite and all forces have a potential, which is Lagrange's and
        Dirichlet's theorem; "oscillates" where all deviations oscillate and none grows, which does
        not show that the motion itself is stable; "undecided" where some deviation neither decays
        nor turns or grows as a power of t, where the last digit of a parameter decides, and where
        the equations contain the time.
        """
        values = self._at(parameters)
        names = self.system.names
        if names.plain(self.system.equations).has(names.t):
            return "undecided"
        near = (
            {x: value * (1 + sign * k * LAST_DIGIT) for k, (x, value) in _counted(values)}
            for sign in (0, 1, -1)
        )
        verdicts = {self._told(*self._sides(each)) for each in near}
        return verdicts.pop() if len(verdicts) == 1 else "undecided"

    def _told(self, M: matrix, C: matrix, K: matrix) -> str:
        spectrum = _spectrum(M, C, K)
        none = NEUTRAL * max(map(abs, spectrum))
        neutral = [s for s in spectrum if abs(s.real) <= NEUTRAL * abs(s) or abs(s) <= none]
        if any(s.real > 0 and s not in neutral for s in spectrum):
            return "unstable"
        if not neutral:
            return "asymptotically stable"
        if self._has_potential and _positive(M) and _positive(K):
            return "stable"
        if all(abs(s) > none for s in neutral) and not any(
            _grows(s, M, C, K, sum(abs(s - other) <= none for other in neutral)) for s in neutral
        ):
            return "oscillates"
        return "undecided"

    def _at(self, parameters: Mapping[Expr, object]) -> dict[Expr, Expr]:
        """The values of all letters, for these parameters."""
        sides = (self.mass, self.damping, self.stiffness, *self.about.values())
        letters = {*self.system.parameters}.union(*(x.free_symbols for x in sides))
        values = numbers(sorted(letters, key=str), parameters)
        for x, value in self.about.items():
            number = value.xreplace(values).evalf()
            if not number.is_real:
                raise RigidtopError(f"there is no such motion: {x} would be {number.evalf(6)}")
        return values

    def _sides(self, values: Mapping[Expr, Expr]) -> Iterator[matrix]:
        """The matrices M, C and K as numbers."""
        for side in (self.mass, self.damping, self.stiffness):
            number = side.xreplace(values).evalf(DIGITS)
            if not all(x.is_real for x in number):
                raise RigidtopError("the deviations have no real coefficients for these numbers")
            yield MANY.matrix(number.tolist())

    @cached_property
    def _has_potential(self) -> bool:
        return bool(
            not any(self.system.generalised_forces)
            and (self.stiffness - self.stiffness.T).expand().is_zero_matrix
            and (self.damping + self.damping.T).expand().is_zero_matrix
        )


def _counted(values: Mapping[Expr, Expr]) -> Iterator[tuple[int, tuple[Expr, Expr]]]:
    return enumerate(values.items(), start=1)


def _spectrum(M: matrix, C: matrix, K: matrix) -> list[Any]:
    """The s for which M s² + C s + K is singular, to many digits."""
    n = M.rows
    if abs(MANY.det(M)) <= LEFT * MANY.fprod(MANY.norm(M[k, :]) for k in range(n)):
        raise RigidtopError(
            "the mass matrix is singular there: choose other coordinates near this motion"
        )
    first = MANY.zeros(2 * n)
    for k in range(n):
        first[k, n + k] = 1
        first[n:, k] = -MANY.lu_solve(M, K[:, k])
        first[n:, n + k] = -MANY.lu_solve(M, C[:, k])
    eigenvalues: list[Any] = MANY.eig(first, left=False, right=False)
    return [MANY.mpc(s) for s in eigenvalues]


def _positive(side: matrix) -> bool:
    """Whether a symmetric matrix is positive definite."""
    eigenvalues = MANY.eigsy(side, eigvals_only=True)
    return bool(min(eigenvalues) > LEFT * max(map(abs, eigenvalues)))


def _grows(s: mpc, M: matrix, C: matrix, K: matrix, times: int) -> bool:
    """Whether a root that is found several `times` has fewer deviations: some are tⁿe^{st}."""
    sizes = MANY.svd_c(M * s**2 + C * s + K, compute_uv=False)
    return bool(sum(size <= NEUTRAL * max(sizes) for size in sizes) < times)


def balance(system: Derived, rates: Sequence[Symbol] = ()) -> Matrix:
    """∂L/∂q + Q + Aᵀλ with all velocities zero but the `rates`, which are constant (n×1, plain)."""
    names = system.names
    still = {v: sympy.S.Zero for v in names.v if v not in rates}
    forces = [
        (system.plain.diff(x) + Q).subs(still)
        for x, Q in zip(names.q, system.generalised_forces, strict=True)
    ]
    return Matrix(forces) + system.reactions


def equilibria(system: Derived) -> tuple[dict[Expr, Expr], ...]:
    """The places at which the system can rest: see `System.equilibria`."""
    _of_places(system)
    names = system.names
    conditions = [x for x in (*balance(system), *system.rules) if x != 0]
    unknown = [x for x in (*names.q, *system.multipliers) if any(c.has(x) for c in conditions)]
    if not conditions:
        return ({},)
    if any(c.has(names.t) for c in conditions):
        raise RigidtopError("the forces change in time: there is no equilibrium")
    try:
        solutions = sympy.solve(conditions, unknown, dict=True)
    except NotImplementedError:
        raise RigidtopError("SymPy does not solve the conditions: see S.balance") from None
    real = [each for each in solutions if all(v.is_real is not False for v in each.values())]
    # By half angles SymPy loses an angle of π, or half a period.
    if len(unknown) <= MOST_ANGLES and not system.constraints:
        tried = [(sympy.S.Zero, sympy.pi / (_rate(x, conditions) or 1)) for x in unknown]
        for values in product(*tried):
            place = dict(zip(unknown, values, strict=True))
            rests = all(decide.vanishes(c.subs(place)) for c in conditions)
            if rests and not any(_is_among(place, each) for each in real):
                real.append(place)
    turned = _turned(real, conditions)
    places = ({x: v for x, v in each.items() if x in names.q} for each in turned)
    return tuple({names.back(x): names.back(v) for x, v in each.items()} for each in places)


def _turned(
    solutions: Sequence[Mapping[Expr, Expr]], conditions: Sequence[Expr]
) -> list[dict[Expr, Expr]]:
    """The places with those that SymPy loses of sin 3θ = 0, each place once a turn."""
    places: list[dict[Expr, Expr]] = []
    for place in solutions:
        rates = {x: _rate(x, conditions) for x in place}
        for shifts in product(*(range(max(rate.p, 1)) for rate in rates.values())):
            further = {}
            for (x, rate), k in zip(rates.items(), shifts, strict=True):
                value = place[x] + (2 * sympy.pi * k / rate if rate else 0)
                turn = 2 * sympy.pi * rate.q
                further[x] = value % turn if rate and value.is_number else value
            if further not in places:
                places.append(further)
    return places


def _rate(x: Symbol, conditions: Sequence[Expr]) -> Rational:
    """The largest r for which x stands in sines and cosines of multiples of rx alone, or 0."""
    waves = {f for c in conditions for f in c.atoms(sympy.sin, sympy.cos) if f.has(x)}
    rates = [f.args[0].diff(x) for f in waves]
    outside = [c.xreplace(dict.fromkeys(waves, Symbol("wave"))) for c in conditions]
    if any(c.has(x) for c in outside) or not all(rate.is_Rational for rate in rates):
        return sympy.S.Zero
    return sympy.gcd_list(rates)


def _is_among(place: Mapping[Expr, Expr], family: Mapping[Expr, Expr]) -> bool:
    """Whether a solution, in which some coordinates may be free, has that place."""
    return all(sympy.expand(value.subs(place) - place[x]) == 0 for x, value in family.items())


def small(system: Derived, about: Mapping[Expr, object]) -> Small:
    """Small motions about an equilibrium: see `System.small`."""
    _of_places(system)
    near = linear(system, place_of(system, about))
    N, back = near.rates, system.names.back
    mass, damping, stiffness = (
        back((N.T * side * N).applyfunc(sympy.factor_terms))
        for side in (near.mass, near.damping, near.stiffness)
    )
    place = {back(x): back(value) for x, value in near.place.items()}
    return Small(system, place, mass, damping, stiffness, tuple(system.q[k] for k in near.speeds))


def _of_places(system: Derived) -> None:
    for rule, of_places in zip(system.constraints, system.holonomic, strict=True):
        if not of_places:
            raise RigidtopError(
                f"{rule} = 0 is a constraint of velocities: see S.balance and S.linearise"
            )
