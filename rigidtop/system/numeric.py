"""A system's expressions as functions of numbers."""

from __future__ import annotations

import builtins
import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass
from functools import cached_property
from itertools import chain
from keyword import kwlist
from typing import Any

import numpy as np
import sympy
from sympy import Expr, Symbol
from sympy.core.function import AppliedUndef

from rigidtop.codegen import numpy as plain
from rigidtop.codegen.heyoka import on_symbols
from rigidtop.codegen.lines import StraightLine, straight_line
from rigidtop.codegen.nodes import ZERO, Value
from rigidtop.codegen.numpy import Function
from rigidtop.codegen.sizes import with_sizes
from rigidtop.errors import RigidtopError
from rigidtop.motion import taylor
from rigidtop.motion.integrate import TAYLOR, Accuracy
from rigidtop.system.balance import Balance
from rigidtop.system.canonical import Canonical
from rigidtop.system.names import own_functions

BALANCE = "energy balance"
"""What energy and work fail to add up to."""

MEANT = {*kwlist, *dir(builtins), *dir(math), *dir(np)}
"""Names that mean something else in the functions that are made."""


@dataclass(frozen=True, eq=False)
class Numeric:
    """A system's functions of numbers: time, q, q̇ and parameters in, in this order."""

    system: Canonical

    @cached_property
    def arguments(self) -> tuple[Symbol, ...]:
        """The symbols for which numbers go in, in their order."""
        names = self.system.names
        return (names.t, *names.q, *names.v, *self.system.parameters)

    @cached_property
    def _python(self) -> dict[Symbol, Symbol]:
        """Names for those whose own are none in Python, such as lambda, m_{1} or pi."""
        letters = (*self.arguments, *self.system.names.p)
        taken = {x.name for x in letters} | {x.name for x, _ in self.system.program.shared}
        free = (x for x in sympy.numbered_symbols("a") if x.name not in taken)
        wrong = (x for x in letters if not x.name.isidentifier() or x.name in MEANT)
        return {x: Symbol(next(free).name, **x.assumptions0) for x in wrong}

    def made(
        self,
        expressions: Sequence[Expr],
        name: str,
        shared: Sequence[tuple[Symbol, Expr]] = (),
        arguments: Sequence[Symbol] | None = None,
    ) -> Function:
        """Expressions as a function of numbers.  Raises RigidtopError where they have none."""
        own = self._python
        for x in own_functions([*expressions, *(value for _, value in shared)]):
            raise RigidtopError(f"{self.system.names.back(x)} has no numbers: put in what it is")
        try:
            return plain.function(
                [x.xreplace(own) for x in expressions],
                [own.get(x, x) for x in arguments or self.arguments],
                name,
                [(x, value.xreplace(own)) for x, value in shared],
            )
        except ValueError as error:
            raise RigidtopError(str(error).removeprefix(f"{name}: ")) from None

    @cached_property
    def works(self) -> bool:
        """Whether the work of the forces is followed: the energy is not conserved."""
        return not self.system.is_conservative

    @cached_property
    def timed(self) -> bool:
        """Whether the equations contain the time."""
        system = self.system
        programs = [system.program, *([self._power] if self.works else [])]
        values = (x for each in programs for x in (*(y for _, y in each.shared), *each.results))
        return any(x.has(system.names.t) for x in values)

    @cached_property
    def solved(self) -> Function:
        """The function that gives q̈ and −λ at a state."""
        return self._function(self.system.program.results, "solved")

    @cached_property
    def rates(self) -> Function:
        """q̇, q̈, and the power where it is followed."""
        n, program = len(self.system.names.q), self.system.program
        results = (*self.system.names.v, *program.results[:n])
        if not self.works:
            return self._function(results, "rates")
        forces = {x: -y for x, y in zip(self.system.multipliers, program.results[n:], strict=True)}
        shared = [(name, value.xreplace(forces)) for name, value in self._power.shared]
        power = [value.xreplace(forces) for value in self._power.results]
        return self.made((*results, *power), "rates", [*program.shared, *shared])

    @cached_property
    def _power(self) -> StraightLine:
        """The power, with the multipliers as letters; its lines are none of `Derived.program`."""
        system = self.system
        taken = {x for x, _ in system.program.shared}
        free = (x for x in system.free() if x not in taken)
        return straight_line(system.balanced.graph, [system.balanced.power], free)

    def slopes(self, letters: tuple[Symbol, ...]) -> Function:
        """q̈, its derivatives by (q, q̇) row by row (n×2n), then those by some letters (n×k).

        Of those letters the coordinates and velocities count as starts, which q̈ does not have.
        """
        if letters not in self._slopes:
            names, sides = self.system.names, self.system.balanced
            moved = sides.solution[: len(names.q)]
            by_state = sides.gradients(moved, (*names.q, *names.v))
            own = [[ZERO] * len(letters) for _ in moved]
            for k, x in enumerate(letters):
                if x in self.system.parameters:
                    for line, [slope] in zip(own, sides.gradients(moved, [x]), strict=True):
                        line[k] = slope
            values = [*moved, *chain(*by_state), *chain(*own)]
            self._slopes[letters] = self.on_graph(values, "slopes")
        return self._slopes[letters]

    @cached_property
    def _slopes(self) -> dict[tuple[Symbol, ...], Function]:
        """The `slopes` that were asked for."""
        return {}

    @cached_property
    def energy(self) -> Function:
        """The function that gives Jacobi's integral at a state."""
        return self.on_graph([self.system.balanced.energy], "energy")

    @cached_property
    def momenta(self) -> Function:
        """The function that gives the n momenta p at a state."""
        return self.on_graph(self.system.balanced.momenta, "momenta")

    @cached_property
    def watched(self) -> dict[str, Value]:
        """What tells how well a motion is computed, by name, on the graph.

        It is what is conserved, else the energy, which the work balances; and the constraints.
        """
        sides = self.system.balanced
        constant = self.system.of_constants(lambda: sides.energy, lambda: sides.momenta)
        balance = {} if "energy" in constant else {BALANCE: sides.energy}
        return constant | balance | {f"constraint {k}": x for k, x in enumerate(sides.rules, 1)}

    @cached_property
    def watch(self) -> Function:
        """The function that gives each of the `watched`, and behind it the size of its terms."""
        return self.on_graph(self.with_sizes(self.watched.values()), "watch")

    @cached_property
    def holding(self) -> Function:
        """The function that gives the constraints, then their rates, each with its terms' size."""
        sides = self.system.balanced
        return self.on_graph(self.with_sizes([*sides.rules, *sides.speeds]), "holding")

    @cached_property
    def surface(self) -> Function:
        """M, A, A q̇ + b, and the constraints of coordinates alone."""
        sides = self.system.balanced
        places = [x for x, of in zip(sides.rules, self.system.holonomic, strict=True) if of]
        rows = [x for row in (*sides.mass, *sides.constraints) for x in row]
        return self.on_graph([*rows, *sides.speeds, *places], "surface")

    @cached_property
    def friction(self) -> Function:
        """The function that gives w, the sum of the magnitudes of its terms, N, μN and μₛN."""
        names, friction = self.system.names, self.system.friction
        assert friction is not None
        w = friction.velocity(names)
        terms = [*(w.diff(v) * v for v in names.v), w.subs(dict.fromkeys(names.v, 0))]
        forces = (names.plain(x * friction.normal) for x in (1, friction.mu, friction.mu_static))
        return self.of((w, sympy.Add(*map(sympy.Abs, terms)), *forces))

    @cached_property
    def frames(self) -> Function:
        """The function of the place (3) and attitude (9, by rows) of each mass and body."""
        balance = Balance(self.system, self.system.balanced.graph)
        return self.on_graph(list(balance.frames()), "frames")

    def with_sizes(self, values: Iterable[Value]) -> list[Value]:
        """Values on the system's graph, each with the sum of the magnitudes of its terms."""
        return with_sizes(self.system.balanced.graph, values)

    def on_graph(self, values: Sequence[Value], name: str) -> Function:
        """Values on the system's graph as a function of numbers."""
        program = self.system.lines(values)
        return self.made(program.results, name, program.shared)

    @cached_property
    def _free(self) -> dict[tuple[str, float, int], list[Any]]:
        """Integrators that nobody uses now, by what they integrate, tolerance and batch."""
        return {}

    @contextmanager
    def _kept(self, of: str, rtol: float, batch: int, make: Callable[[], Any]) -> Iterator[Any]:
        """An integrator at t = 0, compiled once and used by one thread at a time."""
        free = self._free.setdefault((of, rtol, batch), [])
        integrator = free.pop() if free else make()
        try:
            if not batch:
                integrator.time = 0.0
            yield integrator
        finally:
            free.append(integrator)

    def series(self, rtol: float, batch: int = 0) -> AbstractContextManager[Any]:
        """heyoka's integrator to a tolerance, for q, q̇, work and the time in units, at t = 0.

        Its parameters are the units of q, of q̇ and of the work, if it is followed, one over each,
        and the system's own, without those behind the last that occurs.  It is compiled once, and
        used again for another start; by one thread at a time.  One for a `batch` has so many
        columns, and its time is set by `taylor.sampled`.
        """
        return self._kept("motion", rtol, batch, lambda: self._compiled(rtol, batch))

    def varied(self, rtol: float) -> AbstractContextManager[Any]:
        """The same of `variation`, and of the time where it occurs.

        Its parameters are the units of q and of q̇, one over each, and what `variation` has behind
        the states, without those behind the last that occurs.
        """
        return self._kept("variation", rtol, 0, lambda: self._compiled_variation(rtol))

    def _compiled_variation(self, rtol: float) -> Any:
        heyoka, right, n = taylor.loaded(), self.variation, len(self.system.q)
        parameters = [heyoka.par[k] for k in range(5 + len(self.system.parameters))]
        state = heyoka.make_vars(*(f"x{k}" for k in range(4 * n + 1 + self.timed)))
        time = state[-1] if self.timed else heyoka.expression(0.0)
        kinds = [0] * n + [1] * n
        places = [x * parameters[k] for x, k in zip(state, kinds, strict=False)]
        inside = [time, *places, *state[2 * n : 4 * n], *parameters[4:]]
        rows = on_symbols(heyoka, right, "variation", inside)
        rows[: 2 * n] = [x * parameters[2 + k] for x, k in zip(rows, kinds, strict=False)]
        rows += [heyoka.expression(1.0)] * self.timed
        occurring = {str(x) for row in rows for x in heyoka.get_params(row)}
        last = max(k for k, x in enumerate(parameters) if str(x) in occurring)
        system = list(zip(state, rows, strict=True))
        return heyoka.taylor_adaptive(system, [0.0] * len(state), pars=[1.0] * (last + 1), tol=rtol)

    def varied_by(self, letters: tuple[Symbol, ...], rtol: float) -> AbstractContextManager[Any]:
        """The same of q, q̇ and S = ∂(q, q̇)/∂(k letters), and of the time where it occurs.

        Its parameters are the units of q and of q̇, one over each, those of the letters, and the
        system's own, without those behind the last that occurs.
        """
        name = "by " + ", ".join(x.name for x in letters)
        return self._kept(name, rtol, 0, lambda: self._compiled_slopes(letters, rtol))

    def _compiled_slopes(self, letters: tuple[Symbol, ...], rtol: float) -> Any:
        heyoka, n, k = taylor.loaded(), len(self.system.q), len(letters)
        parameters = [heyoka.par[i] for i in range(4 + k + len(self.system.parameters))]
        state = heyoka.make_vars(*(f"x{i}" for i in range(2 * n * (1 + k) + self.timed)))
        time = state[-1] if self.timed else heyoka.expression(0.0)
        of_q, of_v, per_q, per_v = parameters[:4]
        q, v = ([x * of_q for x in state[:n]], [x * of_v for x in state[n : 2 * n]])
        inside = [time, *q, *v, *parameters[4 + k :]]
        slopes = np.array(on_symbols(heyoka, self.slopes(letters), "slopes", inside))
        S = np.array(state[2 * n : 2 * n * (1 + k)]).reshape(2 * n, k)
        A, B = np.split(slopes[n:], [2 * n * n])
        A, B = A.reshape(n, 2 * n), B.reshape(n, k)
        A[:, :n] = A[:, :n] * of_q * per_v
        moved = A @ S + B * parameters[4 : 4 + k] * per_v
        rows = [x * per_q for x in v] + [x * per_v for x in slopes[:n]]
        rows += [*(S[n:] * of_v * per_q).flat, *moved.flat]
        rows += [heyoka.expression(1.0)] * self.timed
        occurring = {str(x) for row in rows for x in heyoka.get_params(row)}
        last = max(i for i, x in enumerate(parameters) if str(x) in occurring)
        system = list(zip(state, rows, strict=True))
        start, pars = [0.0] * len(state), [1.0] * (last + 1)
        # Unrolled, as a motion alone is, so many equations would be compiled for half a minute.
        return heyoka.taylor_adaptive(system, start, pars=pars, tol=rtol, compact_mode=True)

    @cached_property
    def variation(self) -> Function:
        """Rates of q, q̇, of the direction of a neighbour (2n) and of the logarithm of its distance.

        Of the time, q, q̇, that direction, the parameters and a rate, by which the neighbour's
        velocities are divided.
        """
        system = self.system
        names, n = system.names, len(system.q)
        own = [Symbol(f"away_{k}", real=True) for k in range(2 * n)]
        rate = Symbol("away_rate", positive=True)
        away: dict[Expr, Expr] = dict(zip(names.q, own, strict=False))
        away |= {v: rate * x for v, x in zip(names.v, own[n:], strict=True)}

        def slope(value: Expr) -> Expr:
            return sympy.Add(*(value.diff(x) * away[x] for x in value.free_symbols if x in away))

        lines: list[tuple[Symbol, Expr]] = []
        for name, value in system.program.shared:
            lines.append((name, value))
            change = slope(value)
            if change != 0:
                away[name] = Symbol(f"away_{name.name}", real=True)
                lines.append((away[name], change))
        results = system.program.results[:n]
        moved = [rate * x for x in own[n:]] + [slope(value) / rate for value in results]
        parts = sympy.symbols(f"away_by_:{2 * n}", real=True)
        lines += zip(parts, moved, strict=True)
        size = sympy.Add(*(x**2 for x in own))
        growth = Symbol("away_growth", real=True)
        along = sympy.Add(*(x * y for x, y in zip(own, parts, strict=True)))
        lines.append((growth, along / size))
        turned = [y - growth * x for x, y in zip(own, parts, strict=True)]
        arguments = (names.t, *names.q, *names.v, *own, *system.parameters, rate)
        return self.made((*names.v, *results, *turned, growth), "variation", lines, arguments)

    def _compiled(self, rtol: float, batch: int) -> Any:
        heyoka = taylor.loaded()
        system, pars = self._in_series
        start = np.zeros((len(system), batch)) if batch else [0.0] * len(system)
        make = heyoka.taylor_adaptive_batch if batch else heyoka.taylor_adaptive
        return make(system, start, pars=np.ones((pars, batch) if batch else pars), tol=rtol)

    @cached_property
    def method(self) -> str:
        """Where none is named: "taylor" where heyoka has all that occurs, else "DOP853"."""
        try:
            rows, _ = self._in_series
        except RigidtopError:
            rows = []
        return TAYLOR if rows else "DOP853"

    def accuracy(
        self, method: str | None = None, rtol: float = 1e-10, atol: float = 1e-12
    ) -> Accuracy:
        """How a solver is to work, by `method` where none is named."""
        return Accuracy(self.method if method is None else method, rtol, atol)

    @cached_property
    def _in_series(self) -> tuple[list[Any], int]:
        """The equations in heyoka's symbols, and how many parameters they have."""
        heyoka, n = taylor.loaded(), len(self.system.q)
        kinds = [0] * n + [1] * n + [2] * self.works
        count = max(kinds) + 1
        own = len(self.system.parameters)
        parameters = [heyoka.par[k] for k in range(2 * count + own)]
        state = heyoka.make_vars(*(f"x{k}" for k in range(len(kinds) + self.timed)))
        time = state[-1] if self.timed else heyoka.expression(0.0)
        places = [x * parameters[k] for x, k in zip(state, kinds[: 2 * n], strict=False)]
        right = on_symbols(heyoka, self.rates, "rates", [time, *places, *parameters[2 * count :]])
        rows = [rate * parameters[count + k] for rate, k in zip(right, kinds, strict=True)]
        if self.timed:
            rows.append(heyoka.expression(1.0))
        # Those behind the last that occurs are not counted.
        occurring = {str(x) for row in rows for x in heyoka.get_params(row)}
        last = max(k for k, x in enumerate(parameters) if str(x) in occurring)
        return list(zip(state, rows, strict=True)), last + 1

    def _function(self, results: Sequence[Expr], name: str) -> Function:
        return self.made(results, name, self.system.program.shared)

    def of(self, expressions: tuple[Expr, ...]) -> Function:
        """Other quantities.  Raises RigidtopError for letters that the system does not have."""
        unknown = set().union(*(x.free_symbols for x in expressions)) - {*self.arguments}
        if unknown:
            names = ", ".join(sorted(map(str, unknown)))
            there = ", ".join(map(self.system.names.spelled, self.arguments))
            raise RigidtopError(f"no number for {names}: the system has {there}")
        return self.made(expressions, "quantity")


def computed(
    function: Callable[[Sequence[float]], Sequence[float]], at: Sequence[float]
) -> tuple[tuple[float, ...], str]:
    """The values, and why there are none, if there are none."""
    try:
        values = tuple(function(at))
        return values, "" if all(map(math.isfinite, values)) else "it is not finite"
    except RigidtopError:
        raise  # no numbers at all
    except (ZeroDivisionError, OverflowError, ValueError) as error:
        return (math.nan,), str(error)
    except TypeError:
        return (math.nan,), "a power of a negative number is not real"


@dataclass(frozen=True, repr=False, init=False)
class Computed(Canonical):
    """What is derived, with numbers for its symbols."""

    @cached_property
    def numeric(self) -> Numeric:
        """The functions of numbers that are compiled from the system."""
        return Numeric(self)

    @cached_property
    def switches(self) -> bool:
        """Whether a force jumps with a sign."""
        return any(Q.has(sympy.sign) for Q in self.generalised_forces)

    @cached_property
    def slip(self) -> Symbol:
        """The letter of the direction of dry friction, among the parameters of `sliding`."""
        taken = {x.name for x in (*self.parameters, *self.names.q, *self.names.v)}
        name = next(x for k in range(len(taken) + 1) if (x := "slip" + "_" * k) not in taken)
        return Symbol(name, real=True)

    @cached_property
    def sliding(self) -> Computed:
        """The system with dry friction in one direction, −1 or 1."""
        names, friction = self.names, self.friction
        assert friction is not None
        pairs = zip(self.pushing, friction.on_coordinates(names, self.slip), strict=True)
        return self._without_signs([Q + names.back(F) for Q, F in pairs], ())

    @cached_property
    def sticking(self) -> Computed:
        """The system whose dry friction holds: by a constraint, the last."""
        assert self.friction is not None
        held = self.names.back(self.friction.velocity(self.names))
        return self._without_signs(self.pushing, (held,))

    def _without_signs(self, forces: Sequence[Expr], rules: tuple[Expr, ...]) -> Computed:
        rates = None if isinstance(self.q[0], AppliedUndef) else self.qdot
        more = {"rayleigh": self.rayleigh, "parts": self.parts}
        return Computed(self.rest, self.q, rates, forces, (*self.constraints, *rules), **more)
