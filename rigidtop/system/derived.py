"""What follows from a Lagrangian, its forces and its constraints: expressions of SymPy."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, fields
from functools import cached_property
from typing import Any, TypeVar

import sympy
from sympy import Expr, Integer, Matrix, Symbol

from rigidtop.codegen.graph import somewhere
from rigidtop.codegen.lines import StraightLine, straight_line
from rigidtop.codegen.nodes import ZERO, Value
from rigidtop.codegen.solve import SingularError, solved
from rigidtop.errors import RigidtopError
from rigidtop.parameters import in_one_line
from rigidtop.proof import decide
from rigidtop.system.balance import Balance, Balanced
from rigidtop.system.declaration import (
    acting,
    check_letters,
    check_rules,
    check_signs,
    check_sliding,
    check_terms,
    is_even,
    with_time,
)
from rigidtop.system.forms import LARGEST, expanded, grouped, over, readable, short
from rigidtop.system.friction import DryFriction, apart
from rigidtop.system.names import Given, PlainSymbols, expression, multipliers, named, several
from rigidtop.system.parts import Assembly, Part, kinetic_energy

SMALL = 750
"""Nodes of a graph up to which normal forms are tried, to see whether they are shorter."""

NEGLIGIBLE = 1e-40
"""What a value that might vanish is at most, at a point where letters have no relation."""

Quantity = TypeVar("Quantity")

NORMAL = (grouped, lambda value, _: short(value))
"""Forms of the entries of M and f."""


@dataclass(frozen=True, repr=False)
class Derived:
    """What a system is given, and all that is derived from it when it is asked for.

    Results are in the names that were given.  Raises RigidtopError, in one line, for what is no
    system.
    """

    rest: Expr
    """L, or what of it the kinetic energy of the parts is not."""

    q: tuple[Expr, ...]
    qdot: tuple[Expr, ...]
    forces: tuple[Expr, ...]
    constraints: tuple[Expr, ...]
    rayleigh: Expr
    parts: tuple[Part, ...]
    """The masses and bodies that it was made of, if it was."""

    def __init__(
        self,
        L: Expr,
        q: Given,
        qdot: Given = None,
        forces: Given = None,
        constraints: Given = (),
        *,
        rayleigh: Given = 0,
        parts: Sequence[Part] = (),
    ) -> None:
        L, rayleigh = expression("L", L), expression("rayleigh", rayleigh)
        rules = tuple(expression("a constraint", each) for each in several(constraints))
        coordinates = (q,) if isinstance(q, Expr) else q
        forces, friction = apart(forces)
        pushing = acting(forces, coordinates)
        inside = [x for part in parts for x in part.expressions]
        rubbing = tuple(friction.expressions.values()) if friction else ()
        whole = (L, rayleigh, *rules, *pushing, *rubbing, *inside)
        letters = set().union(*(x.free_symbols for x in whole))
        names = named(coordinates, (qdot,) if isinstance(qdot, Expr) else qdot, letters)
        pushed = friction or rayleigh != 0 or any(Q != 0 for Q in pushing)
        check_signs(names.v, None if pushed else (L, *rules))
        names = with_time(names, letters, coordinates)
        pushing = pushing or (Integer(0),) * len(names.q)
        acting_forces = pushing
        if friction and len(pushing) == len(names.q):
            rubbing = friction.on_coordinates(names)
            acting_forces = tuple(Q + names.back(F) for Q, F in zip(pushing, rubbing, strict=True))
        for name, value in (
            ("rest", L),
            ("q", tuple(names.back(x) for x in names.q)),
            ("qdot", tuple(names.back(x) for x in names.v)),
            ("forces", acting_forces),
            ("constraints", rules),
            ("rayleigh", rayleigh),
            ("names", names),
            ("parts", tuple(parts)),
            ("potential", None),
            ("friction", friction),
            ("pushing", pushing),
        ):
            object.__setattr__(self, name, value)
        self._check()

    names: PlainSymbols = field(init=False, repr=False, compare=False)
    """The plain symbols inside: see `rigidtop.system.names`."""

    potential: Expr | None = field(init=False, repr=False, compare=False)
    """V, where it is known apart."""

    friction: DryFriction | None = field(init=False, repr=False)
    """The dry friction among the forces."""

    pushing: tuple[Expr, ...] = field(init=False, repr=False, compare=False)
    """The forces without it."""

    def _check(self) -> None:
        n = len(self.q)
        if len(self.forces) != n:
            raise RigidtopError(f"{len(self.forces)} forces for {n} coordinates: give one for each")
        inside = tuple(x for part in self.parts for x in part.expressions)
        terms = {"L": (self.rest, *inside), "rayleigh": (self.rayleigh,), "a force": self.forces}
        rubbing = {what: (x,) for what, x in self._rubbing.items()}
        check_terms({**terms, **rubbing, "a constraint": self.constraints}, self.q, self.names)
        check_letters(self._letters)
        check_rules(dict(zip(self.constraints, self.rules, strict=True)), self.names)
        if self.friction:
            check_sliding(self.friction.of, self.friction.velocity(self.names), self.names)

    @property
    def _rubbing(self) -> dict[str, Expr]:
        """What the dry friction is given."""
        return self.friction.expressions if self.friction else {}

    def __getstate__(self) -> dict[str, Any]:
        """The state without what was computed: functions that are made cannot be pickled."""
        return {each.name: getattr(self, each.name) for each in fields(self)}

    @cached_property
    def L(self) -> Expr:
        """The Lagrangian in the names that were given, with that of its parts."""
        if not self.parts:
            return self.rest
        hanging = (part.potential for part in self.parts if isinstance(part, Assembly))
        moving = self.names.back(kinetic_energy(self.parts, self.names))
        return moving + self.rest - sympy.Add(*hanging)

    # --- in plain symbols, for what computes ------------------------------------------------------

    @cached_property
    def plain(self) -> Expr:
        """The Lagrangian in plain symbols, not functions."""
        return self.names.plain(self.L)

    @cached_property
    def rules(self) -> tuple[Expr, ...]:
        """The left sides of the constraints, which vanish, in plain symbols."""
        return tuple(map(self.names.plain, self.constraints))

    @cached_property
    def holonomic(self) -> tuple[bool, ...]:
        """For each constraint whether it is one of coordinates and time alone."""
        return tuple(not rule.has(*self.names.v) for rule in self.rules)

    @cached_property
    def rolling(self) -> Matrix:
        """The constraints as A q̇ + b = 0: A with b behind it (k×(n+1)), plain."""
        names = self.names
        rows = []
        for rule, of_places in zip(self.rules, self.holonomic, strict=True):
            if of_places:
                rows.append([*(rule.diff(x) for x in names.q), rule.diff(names.t)])
            else:
                rows.append(
                    [*(rule.diff(v) for v in names.v), rule.subs(dict.fromkeys(names.v, 0))]
                )
        return Matrix(len(rows), len(names.q) + 1, [x for row in rows for x in row])

    @cached_property
    def generalised_forces(self) -> tuple[Expr, ...]:
        """The forces Q − ∂ℱ/∂q̇ (n), in plain symbols."""
        forces = map(self.names.plain, self.forces)
        dissipation = self.names.plain(self.rayleigh)
        return tuple(Q - dissipation.diff(v) for Q, v in zip(forces, self.names.v, strict=True))

    @cached_property
    def conjugate(self) -> tuple[Expr, ...]:
        """The momenta ∂L/∂q̇ (n), in plain symbols."""
        return tuple(self.plain.diff(v) for v in self.names.v)

    @cached_property
    def _balance(self) -> tuple[Matrix, list[Expr]]:
        """M and f of M q̈ = f, as they come; multipliers apart."""
        names, momenta = self.names, self.conjugate
        n = len(momenta)
        lower = {(i, j): momenta[i].diff(names.v[j]) for i in range(n) for j in range(i + 1)}
        mass = Matrix(n, n, lambda i, j: lower[max(i, j), min(i, j)])
        rates = dict(zip(names.q, names.v, strict=True))
        force = [
            self.plain.diff(x) - names.rate(p, rates) + Q
            for x, p, Q in zip(names.q, momenta, self.generalised_forces, strict=True)
        ]
        return mass, force

    @cached_property
    def multipliers(self) -> tuple[Symbol, ...]:
        """λ of each constraint; its force on the coordinate qᵢ is λ ∂(constraint rate)/∂q̇ᵢ."""
        taken = {*self._letters, *self.names.q, *self.names.v}
        return multipliers(len(self.constraints), taken)

    @cached_property
    def reactions(self) -> Matrix:
        """Aᵀλ, the forces of the constraints on the coordinates (n×1), plain."""
        A = self.rolling
        rows = [
            sympy.Add(*(x * A[i, k] for i, x in enumerate(self.multipliers)))
            for k in range(len(self.q))
        ]
        return Matrix(rows)

    @cached_property
    def program(self) -> StraightLine:
        """q̈, then −λ, as the shortest straight-line program that was found.

        Raises RigidtopError where the mass matrix is singular for every motion.
        """
        try:
            programs = [self.lines(self.balanced.solution)]
            # Of a mechanism's L, all in space, SymPy's normal forms take long.
            in_space = any(isinstance(part, Assembly) for part in self.parts)
            if len(self.balanced.graph.nodes) < SMALL and not in_space:
                programs += map(self._by_normal_form, NORMAL)
        except SingularError:
            raise RigidtopError(self.balanced.why_singular(self.qdot)) from None
        return min(programs, key=lambda each: each.operations) if programs[1:] else programs[0]

    @cached_property
    def balanced(self) -> Balanced:
        """M, f and what is conserved on a graph, of which no expression is ever written down."""
        names = self.names
        balanced = somewhere(
            (names.t, *names.q, *names.v, *self.multipliers, *self.given),
            lambda graph: Balance(self, graph).of_parts(),
        )
        with suppress(SingularError):
            balanced.solution  # noqa: B018 - first of all, so that it depends on nothing that is asked
        return balanced

    def _by_normal_form(self, form: Callable[[Expr, Sequence[Symbol]], Expr]) -> StraightLine:
        """The program that M and f have in a normal form."""
        mass, force = self._balance
        n = len(force)
        entries = [form(x, self.names.v) for x in (*mass, *force)]
        matrix, right = self.with_constraints(Matrix(n, n, entries[: n * n]), entries[n * n :])
        return solved(matrix, right, self.free())

    def free(self) -> Iterator[Symbol]:
        """Names for the lines of a program."""
        taken = {x.name for x in self._letters} | {x.name for x in self.multipliers}
        return (x for x in sympy.numbered_symbols("x") if x.name not in taken)

    def lines(self, values: Sequence[Value]) -> StraightLine:
        """Values of `balanced` as a program."""
        return straight_line(self.balanced.graph, values, self.free())

    def with_constraints(self, mass: Matrix, force: list[Expr]) -> tuple[Matrix, list[Expr]]:
        """Mass and force with a row for each constraint, derived until it has accelerations."""
        if not self.constraints:
            return mass, force
        names, n = self.names, len(force)
        A = self.rolling[:, :n]
        k = A.rows
        rates = dict(zip(names.q, names.v, strict=True))
        held = [
            short(
                -sympy.Add(
                    *(names.rate(A[i, j], rates) * names.v[j] for j in range(n)),
                    names.rate(self.rolling[i, n], rates),
                )
            )
            for i in range(k)
        ]
        # With −λ as unknowns the matrix is symmetric.
        return Matrix([[mass, A.T], [A, sympy.zeros(k, k)]]), [*force, *held]

    @cached_property
    def one_sided(self) -> tuple[tuple[int, int], ...]:
        """Which coordinates have to stay on the side on which they were declared, and that sign.

        SymPy has taken |x| for x where x is positive.  What is the same for x and −x has no such
        place; nor is one looked for within a function, where nobody would write it.
        """
        names = self.names
        declared = [names.given.get(x, x) for x in names.q]
        signs = [bool(x.is_positive) - bool(x.is_negative) for x in declared]
        if not any(signs):
            return ()
        whole = (self.plain, *self.generalised_forces, *self.rules)
        return tuple(
            (k, sign)
            for k, (x, sign) in enumerate(zip(names.q, signs, strict=True))
            if sign and not all(is_even(each, x) for each in whole)
        )

    @cached_property
    def given(self) -> tuple[Expr, ...]:
        """What L is made of, the forces and the constraints, plain."""
        inside = (x for part in self.parts for x in part.expressions)
        made_of = map(self.names.plain, (self.rest, *inside))
        rubbing = map(self.names.plain, self._rubbing.values())
        return (*made_of, *self.generalised_forces, *self.rules, *rubbing)

    @cached_property
    def _letters(self) -> tuple[Symbol, ...]:
        """All that L, the forces and the constraints may have."""
        return tuple(sorted(set().union(*(x.free_symbols for x in self.given)), key=str))

    @cached_property
    def parameters(self) -> tuple[Symbol, ...]:
        """The symbols that are constant, in the order of their names."""
        moving = {*self.names.q, *self.names.v, self.names.t}
        if self.parts:  # of which not all enters L
            rubbing = map(self.names.plain, self._rubbing.values())
            acting = (self.names.plain(self.rest), *self.generalised_forces, *self.rules, *rubbing)
            moving |= {*self._letters}.difference(
                *(x.free_symbols for x in (*self.balanced.leaves, *acting))
            )
        return tuple(x for x in self._letters if x not in moving)

    # --- what is derived, in the names that were given --------------------------------------------

    @cached_property
    def equations(self) -> Matrix:
        """d/dt ∂L/∂q̇ − ∂L/∂q − Q − Σ λA (n×1), which vanishes along the motion: Lagrange (2.29)."""
        names = self.names
        rows = [
            names.rate(p, names.rates) - self.plain.diff(x) - Q - force
            for p, x, Q, force in zip(
                self.conjugate, names.q, self.generalised_forces, self.reactions, strict=True
            )
        ]
        return names.back(
            Matrix([short(row) if row.count_ops() < LARGEST else row for row in rows])
        )

    @cached_property
    def accelerations(self) -> Matrix:
        """q̈(q, q̇, t) (n×1), multipliers eliminated.

        Raises RigidtopError where the mass matrix is singular for every motion.
        """
        rates = self.program.written_out()[: len(self.q)]
        if not self.constraints:
            rates = over(*self._balance) or rates
        return self.names.back(Matrix([readable(x) for x in rates]))

    @cached_property
    def constraint_forces(self) -> Matrix:
        """The multipliers along the motion (k×1)."""
        unknowns = self.program.written_out()[len(self.q) :]
        return self.names.back(Matrix([readable(-x) for x in unknowns]))

    @cached_property
    def mass_matrix(self) -> Matrix:
        """The symmetric mass matrix ∂²L/∂q̇∂q̇ (n×n)."""
        return self.names.back(self._balance[0].applyfunc(short))

    @cached_property
    def momenta(self) -> Matrix:
        """The momenta p = ∂L/∂q̇ (n×1)."""
        return self.names.back(Matrix([sympy.factor_terms(p) for p in self.conjugate]))

    @property
    def p(self) -> tuple[Symbol, ...]:
        """The letters of the momenta in the Hamiltonian and the Routhian, in the order of `q`."""
        return self.names.p

    @cached_property
    def energy(self) -> Expr:
        """Jacobi's integral Σ p q̇ − L, which is T + V for a natural system."""
        return self.names.back(self.jacobi)

    @cached_property
    def jacobi(self) -> Expr:
        """Jacobi's integral q̇·∂L/∂q̇ − L, in plain symbols."""
        turned = sympy.Add(*(p * v for p, v in zip(self.conjugate, self.names.v, strict=True)))
        return expanded(turned - self.plain)

    @cached_property
    def cyclic(self) -> tuple[Expr, ...]:
        """The coordinates on which L does not depend, and no force and no constraint acts.

        The momentum of each is conserved.
        """
        return tuple(x for k, x in enumerate(self.q) if self._is_cyclic(k))

    def _is_cyclic(self, k: int) -> bool:
        sides, x = self.balanced, self.names.q[k]
        return (
            all(A[k] == ZERO for A in sides.constraints)
            and self._vanishes(sides.acting[k], lambda: self.generalised_forces[k])
            and self._vanishes(sides.by_place(x), lambda: self.plain.diff(x))
        )

    def _vanishes(self, value: Value, written: Callable[[], Expr]) -> bool:
        """Whether a value of `balanced` is zero whatever its letters are.

        The graph sees it of what is analytic; of what else is zero at its point SymPy has to show
        it, `written` as an expression.
        """
        if value == ZERO:
            return True
        near = abs(self.balanced.graph.number(value)) < NEGLIGIBLE
        return near and decide.vanishes(written())

    @cached_property
    def power(self) -> Expr:
        """The rate of the energy, ∂L/∂t left out of it as the negative: Q·q̇ − ∂L/∂t − λ·b."""
        return self.names.back(self.work_rate)

    @cached_property
    def work_rate(self) -> Expr:
        """The rate of change of Jacobi's integral, in plain symbols."""
        work = [Q * v for Q, v in zip(self.generalised_forces, self.names.v, strict=True)]
        b = [self.rolling[i, len(self.q)] for i in range(self.rolling.rows)]
        work += [-x * y for x, y in zip(self.multipliers, b, strict=True)]
        if any(x.has(self.names.t) for x in self.given):
            work.append(-self.plain.diff(self.names.t))
        return sympy.expand(sympy.Add(*work))

    @cached_property
    def is_conservative(self) -> bool:
        """Whether the energy is conserved: L does not contain the time, and forces do no work."""
        return self._vanishes(self.balanced.power, lambda: self.work_rate)

    @cached_property
    def conserved(self) -> dict[str, Expr]:
        """What is constant along every motion, as far as L shows it: the energy, momenta.

        The energy is, where L does not contain the time and forces do no work.
        """
        return {name: self.names.back(x) for name, x in self.constant.items()}

    @cached_property
    def constant(self) -> dict[str, Expr]:
        """The conserved quantities by name, in plain symbols."""
        return self.of_constants(lambda: self.jacobi, lambda: self.conjugate)

    def of_constants(
        self, energy: Callable[[], Quantity], momenta: Callable[[], Sequence[Quantity]]
    ) -> dict[str, Quantity]:
        """Those of the energy and the momenta that are conserved, by their names."""
        constant = {"energy": energy()} if self.is_conservative else {}
        if self.cyclic:
            named = zip(self.q, momenta(), self.names.p, strict=True)
            constant |= {name.name: p for x, p, name in named if x in self.cyclic}
        return constant

    def quantity(self, quantity: Expr) -> Expr:
        """The quantity with the momenta's letters, if there are any, written out."""
        values = dict(zip(self.names.p, self.conjugate, strict=True))
        return self._own(quantity).xreplace(values)

    def varying(self, what: str, value: Given) -> Expr:
        """A quantity that changes, as `quantity`.  Raises RigidtopError for one that can't."""
        plain, names = self.quantity(expression(what, value)), self.names
        if plain.free_symbols <= {*self.parameters}:
            there = ", ".join(map(names.spelled, (*names.q, *names.v)))
            raise RigidtopError(
                f"{what} is {in_one_line(value)}, which no motion changes: "
                f"give an expression of {there} or the time"
            )
        return plain

    def _own(self, quantity: Expr) -> Expr:
        """A quantity, plain.  Raises RigidtopError where a letter only looks like the system's."""
        plain = self.names.plain(quantity)
        own = {x.name: x for x in (self.names.t, *self.names.p, *self._letters)}
        for x in plain.free_symbols:
            if own.get(x.name, x) != x:
                raise RigidtopError(f"two different symbols are called {x.name}")
        return plain
