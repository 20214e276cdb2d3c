"""Motions of a system: integrated, with what is conserved as a measure of the errors."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial
from html import escape
from typing import Any

import numpy as np
import sympy
from numpy.typing import ArrayLike
from sympy import Expr, Symbol

from rigidtop.errors import RigidtopError
from rigidtop.motion import checks, taylor
from rigidtop.motion.attitude import Floats
from rigidtop.motion.integrate import Accuracy, Flow, Problem, flow, on_both_sides
from rigidtop.motion.rows import Rows
from rigidtop.parameters import in_one_line
from rigidtop.system.events import zeros
from rigidtop.system.held import Surface
from rigidtop.system.names import Given, expression, numbers
from rigidtop.system.numeric import Computed, computed, magnitude

HOLDS = 1e-9
"""How well a constraint has to hold at the start, relative to its terms."""


TOO_SMALL = 1e-3
"""A motion that stays below this part of what its tolerances are fractions of is done again."""


def started(
    system: Computed, parameters: Mapping[Expr, object], q: Given, qdot: Given
) -> SystemMotion:
    """See `System.motion`."""
    values = numbers(system.parameters, parameters).values()
    places, rates = (
        tuple(checks.number(x.name, value) for x, value in row(system, what, given).items())
        for what, given in (("q", q), ("qdot", qdot))
    )
    made = SystemMotion(system, tuple(map(float, values)), places, rates)
    made.check()
    return made


def row(system: Computed, what: str, given: Given) -> dict[Symbol, Any]:
    """What is given for each coordinate ("q") or velocity ("qdot"), in their order."""
    letters = system.names.q if what == "q" else system.names.v
    shown = ", ".join(map(system.names.spelled, letters))
    if given is None and what == "q":
        raise RigidtopError(f"where does it start? q = a number for each of {shown}")
    given = {} if given is None else given
    if isinstance(given, Mapping):
        places = {}
        for key, value in given.items():
            place = _place(key, letters, system)
            if place is None:
                raise RigidtopError(f"{what} has {key!s}, which is none of {shown}")
            places[place] = value
        missing = [x.name for k, x in enumerate(letters) if k not in places]
        if missing and what == "q":
            raise RigidtopError(f"q has no number for {', '.join(missing)}")
        values = [places.get(k, 0.0) for k in range(len(letters))]
    else:
        values = list(given) if np.iterable(given) and not isinstance(given, str) else [given]
    if len(values) != len(letters):
        raise RigidtopError(f"{what} has {len(values)} numbers, for {shown}")
    return dict(zip(letters, values, strict=True))


def _place(key: Expr, letters: Sequence[Symbol], system: Computed) -> int | None:
    """Which coordinate is meant, also where its velocity is: by symbol, function or name."""
    names = system.names
    for k, x in enumerate(letters):
        own = (names.q[k], names.v[k], names.given.get(names.q[k]), names.given.get(names.v[k]))
        if key in own or key in (x.name, names.q[k].name, names.spelled(names.v[k])):
            return k
    return None


@dataclass(frozen=True)
class SystemMotion:
    """The motion of a system from its state at t = 0; made by `System.motion`."""

    system: Computed
    parameters: tuple[float, ...]
    """In the order of `System.parameters`."""

    q: tuple[float, ...]
    qdot: tuple[float, ...]

    def __repr__(self) -> str:
        names = self.system.names
        start = [f"{x.name}={a:g}" for x, a in zip(names.q, self.q, strict=True)]
        start += [f"{names.spelled(v)}={a:g}" for v, a in zip(names.v, self.qdot, strict=True)]
        return f"SystemMotion({', '.join(start)})"

    def _repr_html_(self) -> str:
        """Where it starts, and its parameters, for notebooks."""
        names = self.system.names
        values = {names.spelled(x): a for x, a in zip(names.q, self.q, strict=True)}
        values |= {names.spelled(x): a for x, a in zip(names.v, self.qdot, strict=True)}
        known = zip(self.system.parameters, self.parameters, strict=True)
        values |= {x.name: a for x, a in known}
        head = "".join(f"<th>{escape(name)}</th>" for name in values)
        row = "".join(f"<td>{a:.6g}</td>" for a in values.values())
        return f"<table><thead><tr>{head}</tr></thead><tbody><tr>{row}</tr></tbody></table>"

    def check(self) -> None:
        """Raises RigidtopError where the motion can't start so."""
        system, names = self.system, self.system.names
        row = [0.0, *self.q, *self.qdot, *self.parameters]
        for rule, of_places in zip(system.rules, system.holonomic, strict=True):
            rates = [rule]
            if of_places:
                motion = dict(zip(names.q, names.v, strict=True))
                rates.append(
                    sympy.Add(*(rule.diff(x) * v for x, v in motion.items()), rule.diff(names.t))
                )
            for k, each in enumerate(rates):
                value, size = self.system.numeric.sized(each)(*row)
                if abs(value) > HOLDS * max(size, 1e-300):
                    said = f"the {'rate of the ' if k else ''}constraint {names.back(rule)} = 0"
                    raise RigidtopError(f"{said} does not hold at the start: it is {value:.6g}")
        self._keeps_signs(np.array(self.q)[:, None])
        self._rates_at([*self.q, *self.qdot, *([0.0] * self._more)])

    @property
    def _more(self) -> int:
        """Components of the state besides q and q̇: the work, the time."""
        return int(self.system.numeric.works) + int(self.system.numeric.timed)

    def _rates(self, state: Sequence[float]) -> tuple[float, ...]:
        """ẋ of the state x = (q, q̇, work, t)."""
        numeric = self.system.numeric
        n = len(self.q)
        time = state[-1] if numeric.timed else 0.0
        made = numeric.rates.scalar(time, *state[: 2 * n], *self.parameters)
        return (*made, 1.0) if numeric.timed else tuple(made)

    def _rates_at(self, state: Sequence[float]) -> tuple[float, ...]:
        """The same, what can't be computed in one line."""
        made, why = computed(self._rates, state)
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
        return tuple(made)

    def integrate(
        self,
        t: ArrayLike,
        method: str = "DOP853",
        rtol: float = 1e-10,
        atol: float = 1e-12,
        events: Mapping[str, Given] | None = None,
        until: Given = None,
    ) -> SystemTrajectory:
        """The motion at the times `t`, integrated from the state at t = 0.

        `t` (s) is a float or a row of N floats in any order, also negative; a tuple (start, end)
        is a span, as SciPy has it, of 501 evenly spaced times.  `method` is one of
        `scipy.integrate.solve_ivp`, with `rtol` and `atol` for each step, or "taylor", the Taylor
        series of heyoka (``pip install 'rigidtop[taylor]'``), for which `rtol` bounds what a step
        leaves out.  `atol` is that of a motion whose coordinates, or velocities, come to 1; where
        the largest of them stays smaller, as in atoms, it is a fraction of that.

        `events` are quantities by name, of q, q̇ and t, whose zeros are wanted: see
        `SystemTrajectory.events`.  Rows after the first zero of `until` (before it, for t < 0) are
        left out.  Constraints hold to rounding: when the solver's errors lead away from them, the
        state is brought back, by as little as the masses allow.

        Raises RigidtopError where the solver does not arrive.
        """
        times = checks.times(t)
        accuracy = Accuracy(method, rtol, atol)
        numeric = self.system.numeric
        start = np.array([*self.q, *self.qdot, *([0.0] * self._more)])
        if not isinstance(events or {}, Mapping):
            raise RigidtopError(
                f"events are given as {{name: quantity}}, not {in_one_line(events)}"
            )
        wanted = {name: self._watched(name, x) for name, x in (events or {}).items()}
        if until is not None:
            wanted[UNTIL] = self._watched("until", until)
        seen: dict[str, list[float]] = {name: [] for name in wanted}

        def sample(motion: Flow, ordered: Floats) -> Floats:
            for name, value in wanted.items():
                seen[name] += zeros(motion, value, float(ordered[-1]))
            states = motion.path(ordered)
            return self._surface.onto(ordered, states) if self.system.constraints else states

        def flows(end: float) -> Flow:
            made = self._flow(start, end, accuracy, self._sizes)
            self._keeps_signs(made.path(made.steps))
            largest = self._sizes(np.abs(made.path(made.steps)).max(axis=1))
            if np.all(largest > TOO_SMALL * self._sizes(start)):
                return made
            return self._flow(start, end, accuracy, lambda _: largest)

        with np.errstate(all="ignore"):
            states = on_both_sides(flows, start, times, sample)
        stops = seen.pop(UNTIL, [])
        last = min((x for x in stops if x > 0), default=math.inf)
        first = max((x for x in stops if x < 0), default=-math.inf)
        kept = (times <= last) & (times >= first)
        n = len(self.q)
        return SystemTrajectory(
            motion=self,
            t=times[kept],
            q=states[:n, kept].T.copy(),
            qdot=states[n : 2 * n, kept].T.copy(),
            work=states[2 * n, kept] if numeric.works else np.zeros(int(kept.sum())),
            events={
                name: np.array(sorted(x for x in at if first <= x <= last))
                for name, at in seen.items()
            },
            ended=next((x for x in (last, first) if math.isfinite(x)), None),
        )

    def _keeps_signs(self, states: Floats) -> None:
        """Raises RigidtopError where a coordinate has left the side on which it was declared."""
        for k, sign in self.system.one_sided:
            if not np.all(sign * states[k] > 0):
                words = "positive" if sign > 0 else "negative"
                raise RigidtopError(
                    f"{self.system.names.q[k].name} is declared {words}, and does not stay so: "
                    "declare it real"
                )

    @cached_property
    def _surface(self) -> Surface:
        return Surface(self.system, self.parameters)

    def _held(self, time: float, state: Floats) -> Floats:
        """The state that keeps the constraints."""
        return self._surface.onto(np.array([time]), state[:, None])[:, 0]

    def _watched(self, name: str, given: Expr) -> Callable[[float, Floats], float]:
        """A quantity as a function of a time and a state."""
        system = self.system
        value = system.quantity(expression(f"the event {name}", given))
        made = system.numeric.of((value,))
        n = len(self.q)

        def at(time: float, state: Floats) -> float:
            row = (time, *state[: 2 * n].tolist(), *self.parameters)
            found, why = computed(lambda row: made.scalar(*row), row)
            if why:
                raise RigidtopError(f"the event {name} can't be computed at t = {time:g}: {why}")
            return float(found[0])

        return at

    def _sizes(self, state: Floats) -> Floats:
        return sizes(self.system, state)

    def _flow(
        self, start: Floats, end: float, accuracy: Accuracy, sizes: Callable[[Floats], Floats]
    ) -> Flow:
        held, unit = self._held if self.system.constraints else None, sizes(start)
        series = partial(self._taylor, start, unit)
        own = sizes if held is None else lambda _: unit
        return flow(Problem(self._rates_at, start, own, series, held), end, accuracy)

    def _taylor(self, start: Floats, unit: Floats, end: float, rtol: float) -> Flow:
        """By heyoka's Taylor series, of the state in `unit`s: below 1 its tolerance is absolute."""
        values = with_units(self.system, unit, np.array(self.parameters))
        held = self._held if self.system.constraints else None
        with self.system.numeric.series(rtol) as integrator:
            integrator.pars[:] = values[: len(integrator.pars)]
            integrator.state[:] = start / unit
            return taylor.propagated(integrator, end, unit, held=held)


def sizes(system: Computed, states: Floats) -> Floats:
    """What absolute tolerances are fractions of: at most 1, or of q, of q̇, of work.

    Of one state (n,) or of many (n, L).
    """
    n, made = len(system.q), np.ones(states.shape)
    for part in (slice(n), slice(n, 2 * n), slice(2 * n, 2 * n + system.numeric.works)):
        largest = np.max(np.abs(states[part]), axis=0, initial=0.0)
        made[part] = np.where((largest > 0) & (largest < 1), largest, 1.0)
    return made


def with_units(system: Computed, units: Floats, parameters: Floats) -> Floats:
    """The numbers that an integrator of `Numeric.series` wants, for one motion or for many."""
    n = len(system.q)
    own = np.concatenate([units[[0, n]], units[2 * n : 2 * n + system.numeric.works]])
    return np.concatenate([own, 1 / own, parameters])


UNTIL = ""


@dataclass(frozen=True, eq=False, repr=False)
class SystemTrajectory(Rows):
    """What a system does at N times, one row each, in the order in which they were asked for."""

    motion: SystemMotion
    """The motion that it belongs to, with its system and its initial state."""

    t: Floats
    """Times, shape (N,), in s."""

    q: Floats
    """Coordinates, shape (N, n)."""

    qdot: Floats
    """Velocities, shape (N, n)."""

    work: Floats
    """What forces have done since t = 0, where the energy is not conserved, shape (N,)."""

    events: Mapping[str, Floats] = field(default_factory=dict)
    """The times at which each quantity that was asked for changes its sign, increasing.

    A zero at t = 0 is left out, and one at which a quantity only touches zero may be.
    """

    ended: float | None = None
    """When `until` was zero, after which there are no rows; None if it was not."""

    def columns(self) -> dict[str, Floats]:
        """t, the coordinates, their velocities and the energy."""
        names = self._system.names
        made = {"t/s": self.t}
        made |= {_header(x): self.q[:, k] for k, x in enumerate(names.q)}
        made |= {_header(v, names.spelled(v)): self.qdot[:, k] for k, v in enumerate(names.v)}
        return made | {"energy/J" if _in_si(self._system) else "energy": self.energy}

    @property
    def plotted(self) -> tuple[str, ...]:
        """The coordinates."""
        return tuple(x.name for x in self._system.names.q)

    def places(self) -> Floats:
        """Where the parts of the system are in space, shape (parts, N, 3), in m.

        Raises RigidtopError for a system that was not made of parts.
        """
        return self._of_parts(lambda part: part.place).reshape(-1, 3, len(self)).swapaxes(1, 2)

    def attitudes(self) -> Floats:
        """R of the parts, of mass points 1, shape (parts, N, 3, 3): body to space."""
        made = self._of_parts(lambda part: getattr(part, "attitude", sympy.eye(3)))
        return np.moveaxis(made.reshape(-1, 3, 3, len(self)), -1, 1)

    def _of_parts(self, what: Callable[[Any], Any]) -> Floats:
        if not self._system.parts:
            raise RigidtopError(
                "the system is not made of masses and bodies: System.of_parts makes one that is"
            )
        plain = self._system.names.plain
        return self._arrays([plain(x) for part in self._system.parts for x in what(part)])

    def animate(self, path: str, duration: float | None = None) -> None:
        """A film of the parts as a GIF, or an MP4 where ffmpeg is: points, rods, bodies' axes.

        A rod is drawn where two neighbours, or the origin and the first, keep their distance.  The
        rows should be evenly spaced; `duration` is that of the film (s), by default the motion's.

        Raises RigidtopError for a system without parts, and where the file can't be written.
        """
        from rigidtop.figures.trajectories import filmed

        filmed(self, path, duration)

    def value(self, quantity: Expr) -> Floats:
        """A quantity of q, q̇, p, t and the parameters along the motion, shape (N,)."""
        asked = self._system.quantity(expression("the quantity", quantity))
        made: Floats = self._arrays((asked,))[0]
        return made

    @property
    def _system(self) -> Computed:
        return self.motion.system

    def _arrays(self, expressions: Sequence[Expr]) -> Floats:
        function = self._system.numeric.of(tuple(expressions))
        with np.errstate(all="ignore"):
            return function.array(self.t, *self.q.T, *self.qdot.T, *self.motion.parameters)

    @cached_property
    def energy(self) -> Floats:
        """Jacobi's integral, shape (N,), in J."""
        made: Floats = self._arrays((self._system.jacobi,))[0]
        return made

    @cached_property
    def momenta(self) -> Floats:
        """p = ∂L/∂q̇, shape (N, n)."""
        return self._arrays(self._system.conjugate).T

    @cached_property
    def accelerations(self) -> Floats:
        """q̈, shape (N, n)."""
        return self._solved[:, : len(self.motion.q)]

    @cached_property
    def multipliers(self) -> Floats:
        """λ of each of the k constraints, shape (N, k)."""
        return -self._solved[:, len(self.motion.q) :]

    @cached_property
    def _solved(self) -> Floats:
        with np.errstate(all="ignore"):
            return self._system.numeric.solved.array(
                self.t, *self.q.T, *self.qdot.T, *self.motion.parameters
            ).T

    def drift(self) -> dict[str, float]:
        """By how much what is conserved strays from its value at t = 0, at most; constraints too.

        Each is relative to the largest sum of the magnitudes of its terms along the motion.  Where
        the energy is not conserved, "energy balance" is what energy and work fail to add up to.
        """
        numeric, start = self._system.numeric, self.motion
        first = (0.0, *start.q, *start.qdot, *start.parameters)
        drifts = {}
        for name, value in self._system.constant.items():
            made, sizes = self._sized(value)
            initial, size = numeric.sized(value)(*first)
            drifts[name] = _relative(made - initial, sizes, size)
        if "energy" not in drifts:
            made, sizes = self._sized(self._system.jacobi)
            initial, size = numeric.sized(self._system.jacobi)(*first)
            drifts["energy balance"] = _relative(made - initial - self.work, sizes, size)
        for k, rule in enumerate(self._system.rules):
            drifts[f"constraint {k + 1}"] = _relative(*self._sized(rule), 0.0)
        return drifts

    def _sized(self, value: Expr) -> tuple[Floats, Floats]:
        made = self._arrays((value, magnitude(value)))
        return made[0], made[1]


def _header(x: Symbol, name: str = "") -> str:
    unit = getattr(getattr(x, "quantity", None), "unit", "")
    name = name or x.name
    if not unit:
        return name
    return f"{name}/({unit})" if "/" in unit else f"{name}/{unit}"


def _in_si(system: Computed) -> bool:
    """Whether the coordinates say in which units they are."""
    return all("/" in _header(x) for x in system.names.q)


def _relative(change: Floats, sizes: Floats, size: float) -> float:
    largest = max(float(np.max(sizes, initial=0.0)), size)
    return float(np.max(np.abs(change), initial=0.0)) / (largest or 1.0)
