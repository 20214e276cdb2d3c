"""Motions of a system: integrated, with what is conserved as a measure of the errors."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial
from html import escape
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sympy import Expr, Symbol

from rigidtop.codegen.numpy import Function
from rigidtop.errors import RigidtopError
from rigidtop.motion import checks, taylor
from rigidtop.motion.attitude import Floats
from rigidtop.motion.integrate import Accuracy, Flow, Problem, flow, on_both_sides
from rigidtop.motion.rows import Rows
from rigidtop.parameters import in_one_line
from rigidtop.system.events import Watched, Zeros, joined_zeros, zeros
from rigidtop.system.held import Surface
from rigidtop.system.names import Given, expression, numbers
from rigidtop.system.numeric import BALANCE, Computed, computed
from rigidtop.system.start import row, sizes, with_units

if TYPE_CHECKING:
    from rigidtop.system.lyapunov import LyapunovExponent

HOLDS = 1e-9
"""How well a constraint has to hold at the start, relative to its terms."""

TOO_SMALL = 1e-3
"""A motion that stays below this part of what its tolerances are fractions of is done again."""

UNTIL = ""
"""The name of what ends a motion, among events."""


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
        if self.system.constraints:
            self._check_rules()
        self._keeps_signs(np.array(self.q)[:, None])
        self._rates_at([*self.q, *self.qdot, *([0.0] * self._more)])

    def _check_rules(self) -> None:
        """Raises RigidtopError where a constraint, or its rate, does not hold at the start."""
        found = self._at_start(self.system.numeric.holding, "a constraint")
        names = [f"constraint {rule} = 0" for rule in self.system.constraints]
        names += [f"rate of the {name}" for name in names]
        for name, value, size in zip(names, found[::2], found[1::2], strict=True):
            if abs(value) > HOLDS * max(size, 1e-300):
                raise RigidtopError(f"the {name} does not hold at the start: it is {value:.6g}")

    def _at_start(self, function: Function, what: str) -> tuple[float, ...]:
        """The values of a function at the start; one that has none is told in one line."""
        row = (0.0, *self.q, *self.qdot, *self.parameters)
        found, why = computed(lambda row: function.scalar(*row), row)
        if why:
            raise RigidtopError(f"{what} can't be computed at the start: {why}")
        return found

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

        `events` are quantities by name, of q, q̇ and t, or pairs of one and a direction, +1 or −1:
        see `SystemTrajectory.crossings`.  Rows after the first zero of `until` (before it, for
        t < 0), which may be such a pair, are left out.  Constraints hold to rounding: when the
        solver's errors lead away from them, the state is brought back, by as little as the masses
        allow.

        Raises RigidtopError where the solver does not arrive.
        """
        times = checks.times(t)
        accuracy = Accuracy(method, rtol, atol)
        start = np.array([*self.q, *self.qdot, *([0.0] * self._more)])
        if not isinstance(events or {}, Mapping):
            raise RigidtopError(
                f"events are given as {{name: quantity}}, not {in_one_line(events)}"
            )
        wanted = {name: self._watched(f"the event {name}", x) for name, x in (events or {}).items()}
        if until is not None:
            wanted[UNTIL] = self._watched("until", until)
        seen: dict[str, list[Zeros]] = {name: [] for name in wanted}

        def sample(motion: Flow, ordered: Floats) -> Floats:
            for name, watched in wanted.items():
                seen[name].append(zeros(motion, watched.value, float(ordered[-1])))
                seen[name][-1] = seen[name][-1].towards(watched.direction)
            return self._kept(ordered, motion.path(ordered))

        def flows(end: float) -> Flow:
            made = self._flow(start, end, accuracy, self._sizes)
            self._keeps_signs(made.path(made.steps))
            largest = self._sizes(np.abs(made.path(made.steps)).max(axis=1))
            if np.all(largest > TOO_SMALL * self._sizes(start)):
                return made
            return self._flow(start, end, accuracy, lambda _: largest)

        with np.errstate(all="ignore"):
            states = on_both_sides(flows, start, times, sample)
        stops = [float(x) for found in seen.pop(UNTIL, []) for x in found.times]
        last = min((x for x in stops if x > 0), default=math.inf)
        first = max((x for x in stops if x < 0), default=-math.inf)
        kept = (times <= last) & (times >= first)
        return SystemTrajectory(
            self,
            times[kept],
            *self._columns(states[:, kept]),
            crossings={
                name: self._section(joined_zeros(found).within(first, last))
                for name, found in seen.items()
            },
            ended=next((x for x in (last, first) if math.isfinite(x)), None),
        )

    def section(
        self,
        quantity: Given,
        t: ArrayLike,
        direction: int = 0,
        method: str | None = None,
        rtol: float = 1e-12,
        atol: float = 1e-14,
    ) -> SystemSection:
        """Poincaré's section: the states at which a quantity goes through zero, until the time `t`.

        `quantity` is an expression of q, q̇ and t, or an equation; of an angle that turns round
        sin((φ − c)/2) has the zeros.  `direction` is +1 where it shall increase with the time, −1
        where it shall decrease, and 0 for both.  `t` (s) may be negative, or a pair of times.
        Without a `method` it is "taylor" where heyoka is there and has all functions that occur,
        else "DOP853".

        Raises RigidtopError where the solver does not arrive.

        >>> from sympy import symbols
        >>> from rigidtop.system.system import System
        >>> x, v = symbols("x v", real=True)
        >>> spring = System(v**2/2 - x**2/2, [x], [v]).motion(q=1.0)
        >>> spring.section(x, 10.0, direction=1).t.round(4)
        array([4.7124])
        """
        method, watched = method or self.system.numeric.method, {"section": (quantity, direction)}
        run = self.integrate(np.append(0.0, checks.times(t)), method, rtol, atol, watched)
        return run.crossings["section"]

    def lyapunov(
        self, t: float, method: str | None = None, rtol: float = 1e-12, atol: float = 1e-14
    ) -> LyapunovExponent:
        """The largest Lyapunov exponent over a time `t` > 0 (s), with an estimate of its error.

        A near neighbour is followed by the variational equations, derived from the program of q̈.
        Raises RigidtopError for systems with constraints, and where the solver does not arrive.

        >>> from sympy import symbols
        >>> from rigidtop.system.system import System
        >>> x, v = symbols("x v", real=True)
        >>> System(v**2/2 + x**2, [x], [v]).motion(q=0.0).lyapunov(1000.0)
        <LyapunovExponent: 1.412 ± 0.0019>
        """
        from rigidtop.system.lyapunov import lyapunov

        accuracy = Accuracy(method or self.system.numeric.method, rtol, atol)
        start = *self.q, *self.qdot
        return lyapunov(self.system, self.parameters, start, t, accuracy, self._keeps_signs)

    def _section(self, found: Zeros) -> SystemSection:
        states = self._kept(found.times, found.states)
        return SystemSection(self, found.times, *self._columns(states), rising=found.rising)

    def _columns(self, states: Floats) -> tuple[Floats, Floats, Floats]:
        """q, q̇ and the work of states (…, N), a row each."""
        n = len(self.q)
        work = states[2 * n] if self.system.numeric.works else np.zeros(states.shape[1])
        return states[:n].T.copy(), states[n : 2 * n].T.copy(), work

    def _kept(self, times: Floats, states: Floats) -> Floats:
        """States (…, N) as the constraints have them."""
        return self._surface.onto(times, states) if self.system.constraints else states

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

    def _watched(self, name: str, given: Given) -> Watched:
        """A quantity as a function of times (N,) and states (…, N), and the direction."""
        system, n = self.system, len(self.q)
        given, direction = given if isinstance(given, tuple) and len(given) == 2 else (given, 0)
        if direction not in (-1, 0, 1):
            raise RigidtopError(f"the direction of {name} is +1, −1 or 0, not {direction}")
        made = system.numeric.of((system.quantity(expression(name, given)),))

        def value(times: Floats, states: Floats) -> Floats:
            found: Floats = made.array(times, *states[: 2 * n], *self.parameters)[0].copy()
            for k in np.flatnonzero(~np.isfinite(found)):  # the reason is told for one number
                row = (float(times[k]), *states[: 2 * n, k].tolist(), *self.parameters)
                [found[k], *_], why = computed(lambda row: made.scalar(*row), row)
                if why:
                    raise RigidtopError(f"{name} can't be computed at t = {times[k]:g}: {why}")
            return found

        return Watched(value, direction)

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

    crossings: Mapping[str, SystemSection] = field(default_factory=dict)
    """Where each of the events that were asked for changes its sign, with times that increase.

    A zero at t = 0 is left out, and one at which a quantity only touches zero may be.
    """

    ended: float | None = None
    """When `until` was zero, after which there are no rows; None if it was not."""

    @property
    def events(self) -> dict[str, Floats]:
        """The times of the `crossings`."""
        return {name: section.t for name, section in self.crossings.items()}

    def columns(self) -> dict[str, Floats]:
        """t, the coordinates, their velocities and the energy."""
        names = self._system.names
        made = {"t/s": self.t}
        made |= {_header(x): self.q[:, k] for k, x in enumerate(names.q)}
        made |= {_header(v, names.spelled(v)): self.qdot[:, k] for k, v in enumerate(names.v)}
        return made | {"energy/J" if _in_si(self._system) else "energy": self.energy}

    @property
    def plotted(self) -> tuple[str | tuple[str, str], ...]:
        """The coordinates."""
        return tuple(x.name for x in self._system.names.q)

    def places(self) -> Floats:
        """Where the parts of the system are in space, shape (parts, N, 3), in m.

        Those of a mechanism are its links with mass or inertia, by their centres of mass.
        Raises RigidtopError for a system that was not made of parts.
        """
        return self._frames[:, :3].swapaxes(1, 2)

    def attitudes(self) -> Floats:
        """R of the parts, of mass points 1, shape (parts, N, 3, 3): body to space."""
        rows = self._frames[:, 3:].reshape(-1, 3, 3, len(self))
        return np.moveaxis(rows, -1, 1)

    @cached_property
    def _frames(self) -> Floats:
        if not self._system.parts:
            raise RigidtopError(
                "the system is not made of masses and bodies: System.of_parts makes one that is"
            )
        return self._along(self._system.numeric.frames).reshape(-1, 12, len(self))

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
        return self._along(self._system.numeric.of(tuple(expressions)))

    def _along(self, function: Function) -> Floats:
        """A function of numbers along the motion, shape (results, N)."""
        with np.errstate(all="ignore"):
            return function.array(self.t, *self.q.T, *self.qdot.T, *self.motion.parameters)

    @cached_property
    def energy(self) -> Floats:
        """Jacobi's integral, shape (N,), in J."""
        made: Floats = self._along(self._system.numeric.energy)[0]
        return made

    @cached_property
    def momenta(self) -> Floats:
        """p = ∂L/∂q̇, shape (N, n)."""
        return self._along(self._system.numeric.momenta).T

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
        return self._along(self._system.numeric.solved).T

    def drift(self) -> dict[str, float]:
        """By how much what is conserved strays from its value at t = 0, at most; constraints too.

        Each is relative to the largest sum of the magnitudes of its terms along the motion.  Where
        the energy is not conserved, "energy balance" is what energy and work fail to add up to.
        """
        numeric = self._system.numeric
        along = self._along(numeric.watch)
        first = self.motion._at_start(numeric.watch, "what is conserved")
        drifts = {}
        for k, name in enumerate(numeric.watched):
            change, size = along[2 * k] - first[2 * k], first[2 * k + 1]
            if name == BALANCE:
                change = change - self.work
            if name.startswith("constraint"):
                change, size = along[2 * k], 0.0
            drifts[name] = _relative(change, along[2 * k + 1], size)
        return drifts


@dataclass(frozen=True, eq=False, repr=False)
class SystemSection(SystemTrajectory):
    """The states of a motion at which a quantity changes its sign, a row each."""

    rising: NDArray[np.bool_] = field(default_factory=lambda: np.empty(0, dtype=bool))
    """Whether it increases with the time there, shape (N,)."""

    dots = True

    @property
    def plotted(self) -> tuple[tuple[str, str], ...]:
        """The velocity of the last coordinate over that coordinate."""
        names = self._system.names
        return ((names.q[-1].name, names.spelled(names.v[-1])),)


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
