"""What a motion of a system starts with: its coordinates and velocities, and their sizes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from typing import Any

import numpy as np
from sympy import Expr, Symbol

from rigidtop.codegen.numpy import Function
from rigidtop.errors import RigidtopError
from rigidtop.motion.attitude import Floats
from rigidtop.motion.integrate import Accuracy, Flow
from rigidtop.motion.systems import Sizes
from rigidtop.parameters import in_one_line
from rigidtop.system.names import Given, several
from rigidtop.system.numeric import Computed, computed

HOLDS = 1e-9
"""How well a constraint has to hold at the start, relative to its terms."""

TOO_SMALL = 1e-3
"""A motion that stays below this part of what its tolerances are fractions of is done again."""

ROUNDING = 1e-15
"""Of a sum whose terms come to 1, such as an acceleration in which a weight and a force cancel."""


@dataclass(frozen=True, repr=False)
class SystemStart:
    """A system with its parameters and its state at t = 0."""

    system: Computed
    parameters: tuple[float, ...]
    """In the order of `System.parameters`."""

    q: tuple[float, ...]
    qdot: tuple[float, ...]

    def __repr__(self) -> str:
        names = self.system.names
        start = [f"{x.name}={a:g}" for x, a in zip(names.q, self.q, strict=True)]
        start += [f"{names.spelled(v)}={a:g}" for v, a in zip(names.v, self.qdot, strict=True)]
        return f"{type(self).__name__}({', '.join(start)})"

    def _repr_html_(self) -> str:
        """Where it starts, and its parameters, for notebooks."""
        names = self.system.names
        values = {names.spelled(x): a for x, a in zip(names.q, self.q, strict=True)}
        values |= {names.spelled(x): a for x, a in zip(names.v, self.qdot, strict=True)}
        pairs = zip(self.system.parameters, self.parameters, strict=True)
        values |= {x.name: a for x, a in pairs}
        head = "".join(f"<th>{escape(name)}</th>" for name in values)
        row = "".join(f"<td>{a:.6g}</td>" for a in values.values())
        return f"<table><thead><tr>{head}</tr></thead><tbody><tr>{row}</tr></tbody></table>"

    def check(self) -> None:
        """Raises RigidtopError where the motion can't start so."""
        if self.system.constraints:
            self._check_rules()
        self.keeps_signs(np.array(self.q)[:, None])
        self.rates_at([*self.q, *self.qdot, *([0.0] * self.more)])

    def _check_rules(self) -> None:
        """Raises RigidtopError where a constraint, or its rate, does not hold at the start."""
        residuals = self.at_start(self.system.numeric.holding, "a constraint")
        names = [f"constraint {rule} = 0" for rule in self.system.constraints]
        names += [f"rate of the {name}" for name in names]
        for name, value, size in zip(names, residuals[::2], residuals[1::2], strict=True):
            if abs(value) > HOLDS * max(size, 1e-300):
                raise RigidtopError(f"the {name} does not hold at the start: it is {value:.6g}")

    def at_start(self, function: Function, what: str) -> tuple[float, ...]:
        """The values of a function at the start; one that has none is told in one line."""
        row = (0.0, *self.q, *self.qdot, *self.parameters)
        values, why = computed(lambda row: function.scalar(*row), row)
        if why:
            raise RigidtopError(f"{what} can't be computed at the start: {why}")
        return values

    @property
    def more(self) -> int:
        """Components of the state besides q and q̇: the work, the time, how dry friction slips."""
        numeric = self.system.numeric
        return int(numeric.works) + int(numeric.timed) + bool(self.system.friction)

    def _rates(self, state: Sequence[float]) -> tuple[float, ...]:
        """ẋ of the state x = (q, q̇, work, t)."""
        numeric = self.system.numeric
        n = len(self.q)
        time = state[-1] if numeric.timed else 0.0
        rates = numeric.rates.scalar(time, *state[: 2 * n], *self.parameters)
        return (*rates, 1.0) if numeric.timed else tuple(rates)

    def rates_at(self, state: Sequence[float]) -> tuple[float, ...]:
        """The same, what can't be computed in one line."""
        rates, why = computed(self._rates, state)
        if why:
            n = len(self.q)
            place = ", ".join(
                f"{x.name} = {value:g}"
                for x, value in zip(self.system.names.q, state[:n], strict=True)
            )
            raise RigidtopError(
                f"the accelerations can't be computed at {place}: {why}; the mass matrix or a "
                "force is singular there"
            )
        return tuple(rates)

    def keeps_signs(self, states: Floats) -> None:
        """Raises RigidtopError where a coordinate has left the side on which it was declared."""
        for k, sign in self.system.one_sided:
            if not np.all(sign * states[k] > 0):
                words = "positive" if sign > 0 else "negative"
                raise RigidtopError(
                    f"{self.system.names.q[k].name} is declared {words}, and does not stay so: "
                    "declare it real"
                )


def row(system: Computed, what: str, numbers: Given) -> dict[Symbol, Any]:
    """What is given for each coordinate ("q") or velocity ("qdot"), in their order."""
    letters = system.names.q if what == "q" else system.names.v
    names = ", ".join(map(system.names.spelled, letters))
    if numbers is None and what == "q":
        raise RigidtopError(f"where does it start? q = a number for each of {names}")
    numbers = {} if numbers is None else numbers
    if isinstance(numbers, Mapping):
        places = {}
        for key, value in numbers.items():
            place = _place(key, letters, system)
            if place is None:
                raise RigidtopError(f"{what} has {in_one_line(key)}, which is none of {names}")
            places[place] = value
        missing = [x.name for k, x in enumerate(letters) if k not in places]
        if missing and what == "q":
            raise RigidtopError(f"q has no number for {', '.join(missing)}")
        values = [places.get(k, 0.0) for k in range(len(letters))]
    else:
        values = [*several(numbers)]
    if len(values) != len(letters):
        raise RigidtopError(f"{what} has {len(values)} numbers, for {names}")
    return dict(zip(letters, values, strict=True))


def _place(key: Expr, letters: Sequence[Symbol], system: Computed) -> int | None:
    """Which coordinate is meant, also where its velocity is: by symbol, function or name."""
    names = system.names
    for k, x in enumerate(letters):
        own = (names.q[k], names.v[k], names.given.get(names.q[k]), names.given.get(names.v[k]))
        if key in own or key in (x.name, names.q[k].name, names.spelled(names.v[k])):
            return k
    return None


def sizes(system: Computed, states: Floats) -> Floats:
    """What absolute tolerances are fractions of: at most 1, or of q, of q̇, of work.

    Of one state (n,) or of many (n, L).
    """
    n, units = len(system.q), np.ones(states.shape)
    for part in (slice(n), slice(n, 2 * n), slice(2 * n, 2 * n + system.numeric.works)):
        largest = np.max(np.abs(states[part]), axis=0, initial=0.0)
        units[part] = np.where((largest > 0) & (largest < 1), largest, 1.0)
    return units


def at_its_size(
    run: Callable[[Sizes], Flow], sizes: Sizes, start: Floats, least: float = 0.0
) -> Flow:
    """A flow with tolerances that are fractions of `sizes`; again, where all stays far below.

    The second time they are fractions of what it comes to, and not below `least` of what they were.
    """
    flow = run(sizes)
    before = sizes(start)
    largest = np.maximum(sizes(np.abs(flow.path(flow.steps)).max(axis=1)), least * before)
    if np.all(largest >= TOO_SMALL * before):
        return flow
    return run(lambda _: largest)


def least_size(system: Computed, accuracy: Accuracy) -> float:
    """Below this part of their first size tolerances would be less than rounding.

    Forces of constraints cancel large ones, such as a weight, so that a system at rest moves by
    their rounding, however small its motion is; so does what friction holds.  Without both nothing
    is left at rest.
    """
    return ROUNDING / accuracy.atol if system.constraints or system.friction else 0.0


def with_units(system: Computed, units: Floats, parameters: Floats) -> Floats:
    """The numbers that an integrator of `Numeric.series` wants, for one motion or for many."""
    n = len(system.q)
    own = np.concatenate([units[[0, n]], units[2 * n : 2 * n + system.numeric.works]])
    return np.concatenate([own, 1 / own, parameters])
