"""Equilibria and steady motions: where they are, how they shake, whether they are stable."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product
from typing import TYPE_CHECKING, Any

import numpy as np
import sympy
from numpy.typing import NDArray
from sympy import Expr, Matrix, Symbol

from rigidtop.errors import RigidtopError
from rigidtop.motion import checks
from rigidtop.proof import decide
from rigidtop.system.names import expression

if TYPE_CHECKING:
    from rigidtop.system.system import System

MOST_ANGLES = 6
"""Of so many coordinates all angles of 0 and π are tried."""

ROUNDING = 1e-9
"""Relative to the largest: real parts, frequencies and forces below this count as none."""


@dataclass(frozen=True)
class Small:
    """Small deviations δ from a steady motion: M δ̈ + C δ̇ + K δ = 0, in the system's own letters.

    `about` are the steady values, of coordinates and velocities.  For forces that have a potential
    M and K are symmetric, and C is antisymmetric: gyroscopic.
    """

    system: System
    about: Mapping[Expr, Expr]
    mass: Matrix
    damping: Matrix
    stiffness: Matrix

    def characteristic(self, frequency: Expr) -> Expr:
        """The determinant whose zeros are the angular frequencies.

        >>> from sympy import symbols
        >>> from rigidtop.system.system import System
        >>> m, k, x, v, omega = symbols("m k x v omega", positive=True)
        >>> System(m*v**2/2 - k*x**2/2, [x], [v]).small({x: 0}).characteristic(omega)
        k - m*omega**2
        """
        made = -(frequency**2) * self.mass + sympy.I * frequency * self.damping + self.stiffness
        return sympy.expand(made.det(method="berkowitz"))

    def rates(self, parameters: Mapping[Any, Any]) -> NDArray[np.complex128]:
        """The 2n numbers s of the deviations e^{st} (1/s), by magnitude of the frequency."""
        values = self.system.numbers_of(parameters)
        M, C, K = (
            np.array(side.xreplace(values).evalf().tolist(), dtype=float)
            for side in (self.mass, self.damping, self.stiffness)
        )
        n = len(M)
        first = np.linalg.solve(M, np.hstack([-K, -C]))
        turned = np.vstack([np.hstack([np.zeros((n, n)), np.eye(n)]), first])
        found = np.linalg.eigvals(turned)
        return found[np.lexsort((found.imag, np.abs(found.imag)))].astype(complex)

    def frequencies(self, parameters: Mapping[Any, Any]) -> NDArray[np.float64]:
        """Angular frequencies of what oscillates, once each (rad/s), increasing."""
        found = self.rates(parameters)
        least = ROUNDING**0.5 * max(float(np.max(np.abs(found))), 1e-300)
        return np.sort(found.imag[found.imag > least])

    def stability(self, parameters: Mapping[Any, Any]) -> str:
        """What the linear equations tell.

        "unstable" and "asymptotically stable" by the real parts; "stable" where K is positive
        definite and all forces have a potential, which is Lagrange's and Dirichlet's theorem;
        "oscillates" where all deviations oscillate, which does not show that the motion itself is
        stable; "undecided" where some deviation neither grows nor turns.
        """
        values = self.system.numbers_of(parameters)
        found = self.rates(parameters)
        scale = max(float(np.max(np.abs(found))), 1e-300)
        if np.any(found.real > ROUNDING**0.5 * scale):
            return "unstable"
        if np.all(found.real < -(ROUNDING**0.5) * scale):
            return "asymptotically stable"
        if self._has_potential and self._mass_is_positive(values):
            K = np.array(self.stiffness.xreplace(values).evalf().tolist(), dtype=float)
            if np.all(np.linalg.eigvalsh(K) > ROUNDING * max(float(np.abs(K).max()), 1e-300)):
                return "stable"
        if np.all(np.abs(found.imag) > ROUNDING**0.5 * scale):
            return "oscillates"
        return "undecided"

    @cached_property
    def _has_potential(self) -> bool:
        return bool(
            not any(self.system.generalised_forces)
            and (self.stiffness - self.stiffness.T).expand().is_zero_matrix
            and (self.damping + self.damping.T).expand().is_zero_matrix
        )

    def _mass_is_positive(self, values: Mapping[Expr, Expr]) -> bool:
        M = np.array(self.mass.xreplace(values).evalf().tolist(), dtype=float)
        return bool(np.all(np.linalg.eigvalsh(M) > 0))


def balance(system: System, rates: Sequence[Symbol] = ()) -> Matrix:
    """∂L/∂q + Q with all velocities zero but the `rates`, which are constant (n×1, plain)."""
    names = system.names
    still = {v: sympy.S.Zero for v in names.v if v not in rates}
    forces = [
        (system.plain.diff(x) + Q).subs(still)
        for x, Q in zip(names.q, system.generalised_forces, strict=True)
    ]
    return Matrix(forces)


def equilibria(system: System) -> tuple[dict[Expr, Expr], ...]:
    """See `System.equilibria`."""
    _no_rules(system)
    names = system.names
    conditions = [x for x in balance(system) if x != 0]
    unknown = [x for x in names.q if any(c.has(x) for c in conditions)]
    if not conditions:
        return ({},)
    if any(c.has(names.t) for c in conditions):
        raise RigidtopError("the forces change in time: there is no equilibrium")
    try:
        found = sympy.solve(conditions, unknown, dict=True)
    except NotImplementedError:
        raise RigidtopError("SymPy does not solve the conditions: see S.balance") from None
    real = [each for each in found if all(v.is_real is not False for v in each.values())]
    # By half angles SymPy loses an angle of π.
    if len(unknown) <= MOST_ANGLES:
        for values in product((sympy.S.Zero, sympy.pi), repeat=len(unknown)):
            place = dict(zip(unknown, values, strict=True))
            rests = all(decide.vanishes(c.subs(place)) for c in conditions)
            if rests and not any(_is_among(place, each) for each in real):
                real.append(place)
    return tuple({names.back(x): names.back(v) for x, v in each.items()} for each in real)


def _is_among(place: Mapping[Expr, Expr], found: Mapping[Expr, Expr]) -> bool:
    """Whether a solution, in which some coordinates may be free, has that place."""
    return all(sympy.expand(value.subs(place) - place[x]) == 0 for x, value in found.items())


def small(system: System, about: Mapping[Any, Any]) -> Small:
    """See `System.small`."""
    _no_rules(system)
    names = system.names
    place = dict.fromkeys(names.v, sympy.S.Zero)
    for key, value in about.items():
        symbol = names.find(key) or names.plain(expression("a coordinate", key))
        if symbol not in (*names.q, *names.v):
            raise RigidtopError(f"{key} is none of the coordinates and velocities")
        place[symbol] = names.plain(expression(f"the value of {key}", value))
    missing = [x for x in names.q if x not in place and (system.plain.has(x) or _acts(system, x))]
    if missing:
        raise RigidtopError(f"the steady motion gives no value for {names.back(missing[0])}")
    residual = names.plain(system.equations).subs(dict.fromkeys(names.a, 0))
    wrong = [x.subs(place) for x in residual]
    if any(x.has(names.t) for x in wrong):
        raise RigidtopError("the equations change in time there: no steady motion")
    for x in wrong:
        if not decide.vanishes(x) and not decide.vanishes(sympy.simplify(x)):
            left = names.back(sympy.factor_terms(x))
            raise RigidtopError(f"this is no steady motion: a force of {left} is left")
    moved = [x for x in names.q if place.get(names.v[names.q.index(x)], 0) != 0]
    for x in moved:
        if residual.has(x):
            raise RigidtopError(f"{names.back(x)} changes, and the equations contain it")
    equations = names.plain(system.equations)
    still = dict.fromkeys(names.a, sympy.S.Zero)
    M, C, K = (
        equations.jacobian(list(group)).subs(still).subs(place)
        for group in (names.a, names.v, names.q)
    )
    if any(side.has(names.t) for side in (M, C, K)):
        raise RigidtopError("the deviations change in time by themselves: no frequencies")
    given = {names.back(x): names.back(value) for x, value in place.items()}
    shown = (names.back(side.applyfunc(sympy.factor_terms)) for side in (M, C, K))
    return Small(system, given, *shown)


def _acts(system: System, x: Symbol) -> bool:
    return any(Q.has(x) for Q in system.generalised_forces)


def _no_rules(system: System) -> None:
    if system.constraints:
        raise RigidtopError("a system with constraints: choose coordinates that need none")


def numbers_of(system: System, given: Mapping[Any, Any]) -> dict[Expr, Expr]:
    """Parameters, by symbol or by name, as numbers for all of them."""
    names = {getattr(key, "name", key): value for key, value in given.items()}
    missing = [x.name for x in system.parameters if x.name not in names]
    if missing:
        raise RigidtopError(f"no number for {', '.join(missing)}: give {{symbol: number}}")
    return {x: sympy.Float(checks.number(x.name, names[x.name])) for x in system.parameters}
