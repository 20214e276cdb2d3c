"""Motions of a system: integrated, with what is conserved as a measure of the errors."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike
from sympy import Expr

from rigidtop.errors import RigidtopError
from rigidtop.motion import checks, taylor
from rigidtop.motion.attitude import Floats
from rigidtop.motion.integrate import Accuracy, Flow, Held, InitialValueProblem, flow, on_both_sides
from rigidtop.motion.systems import Sizes
from rigidtop.system.events import Watched, Zeros, joined_zeros, zeros
from rigidtop.system.friction import refuse
from rigidtop.system.held import Surface
from rigidtop.system.names import Given, expression, mapping, numbers
from rigidtop.system.numeric import Computed, computed
from rigidtop.system.slipping import Slipping
from rigidtop.system.start import SystemStart, at_its_size, least_size, row, sizes, with_units
from rigidtop.system.trajectory import Signs, SystemSection, SystemTrajectory

if TYPE_CHECKING:
    from rigidtop.system.lyapunov import LyapunovExponent
    from rigidtop.system.sensitivities import Sensitivities

STICKS = "; a force jumps with a sign: friction that sticks is rt.DryFriction among the forces"
"""What is right instead of −μN sign(v), where a solver gets stuck."""

UNTIL = ""
"""The name of what ends a motion, among events."""


def started(
    system: Computed, parameters: Mapping[Expr, object] | None, q: Given, qdot: Given
) -> SystemMotion:
    """The motion from a start: see `System.motion`."""
    values = numbers(system.parameters, parameters).values()
    places, rates = (
        tuple(checks.number(x.name, value) for x, value in row(system, what, entries).items())
        for what, entries in (("q", q), ("qdot", qdot))
    )
    motion = SystemMotion(system, tuple(map(float, values)), places, rates)
    motion.check()
    return motion


@dataclass(frozen=True, repr=False)
class SystemMotion(SystemStart):
    """The motion of a system from its state at t = 0; made by `System.motion`."""

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
        start = np.array([*self.q, *self.qdot, *([0.0] * self.more)])
        if self.system.friction:
            start = self._slipping.begun(0.0, start, False)
        events = mapping("events are given as {name: quantity}", events)
        wanted = {name: self._watched(f"the event {name}", x) for name, x in events.items()}
        if until is not None:
            wanted[UNTIL] = self._watched("until", until)
        seen: dict[str, list[Zeros]] = {name: [] for name in wanted}

        def sample(motion: Flow, ordered: Floats) -> Floats:
            for name, watched in wanted.items():
                seen[name].append(zeros(motion, watched.value, float(ordered[-1])))
                seen[name][-1] = seen[name][-1].towards(watched.direction)
            return self._kept(ordered, motion.path(ordered))

        def flows(end: float) -> Flow:
            def run(sizes: Sizes) -> Flow:
                flow = self._flow(start, end, accuracy, sizes)
                if self.system.one_sided:
                    self.keeps_signs(flow.path(flow.steps))
                return flow

            return at_its_size(run, self._sizes, start, least_size(self.system, accuracy))

        with np.errstate(all="ignore"):
            states = on_both_sides(flows, start, times, sample)
        stops = [float(x) for crossings in seen.pop(UNTIL, []) for x in crossings.times]
        last = min((x for x in stops if x > 0), default=math.inf)
        first = max((x for x in stops if x < 0), default=-math.inf)
        kept = (times <= last) & (times >= first)
        return SystemTrajectory(
            self,
            times[kept],
            *self._columns(states[:, kept]),
            crossings={
                name: self._section(joined_zeros(crossings).within(first, last))
                for name, crossings in seen.items()
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
        method = self.system.numeric.accuracy(method, rtol, atol).method
        watched = {"section": (quantity, direction)}
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

        refuse(self.system.friction, "a Lyapunov exponent")
        accuracy = self.system.numeric.accuracy(method, rtol, atol)
        start = *self.q, *self.qdot
        return lyapunov(self.system, self.parameters, start, t, accuracy, self.keeps_signs)

    def sensitivities(
        self,
        t: ArrayLike,
        by: Given,
        method: str = "DOP853",
        rtol: float = 1e-10,
        atol: float = 1e-12,
    ) -> Sensitivities:
        """The motion at N times, and its derivatives by parameters and by where it starts.

        `t` (s) is as for `integrate`; `by` is one quantity or a row of k of them, by symbol or by
        name: parameters, and coordinates and velocities, which stand for their values at t = 0.
        The derivatives of the n coordinates are `q_by`, (N, n, k): see `Sensitivities`.

        The variational equations come from the same program as the accelerations and are
        integrated with the motion, by the same `method` and to the same tolerances as `integrate`
        has them: the step follows both.  `atol` of a derivative is that of what it is of, over the
        size of what it is by.

        Raises RigidtopError for what is no letter of the system, where a force jumps on the way,
        where a constraint ties a start or a parameter to the rest, so that it can't change alone,
        and where the solver does not arrive.

        >>> from sympy import symbols
        >>> from rigidtop.system.system import System
        >>> k = symbols("k", positive=True)
        >>> x, v = symbols("x v", real=True)
        >>> spring = System(v**2/2 - k*x**2/2, [x], [v]).motion({k: 4}, q=1.0)    # x = cos √k t
        >>> run = spring.sensitivities([0, 1], by=[k, x, v])
        >>> run.q_by.shape, run.of(k)[0][-1].round(6)    # ∂x/∂k = −t sin(√k t)/2√k
        ((2, 1, 3), array([-0.227324]))
        """
        from rigidtop.system.sensitivities import sensitivities

        refuse(self.system.friction, "derivatives of a motion")
        return sensitivities(self, t, by, Accuracy(method, rtol, atol))

    def _section(self, zeros: Zeros) -> SystemSection:
        states = self._kept(zeros.times, zeros.states)
        return SystemSection(self, zeros.times, *self._columns(states), rising=zeros.rising)

    def _columns(self, states: Floats) -> tuple[Floats, Floats, Floats, Signs]:
        """q, q̇, the work and the slip of states (…, N), a row each."""
        n = len(self.q)
        work = states[2 * n] if self.system.numeric.works else np.zeros(states.shape[1])
        slip = states[-1].astype(int) if self.system.friction else None
        return states[:n].T.copy(), states[n : 2 * n].T.copy(), work, slip

    def _kept(self, times: Floats, states: Floats) -> Floats:
        """States (…, N) as the constraints have them."""
        return self._surface.onto(times, states) if self.system.constraints else states

    @cached_property
    def _surface(self) -> Surface:
        return Surface(self.system, self.parameters)

    def _held(self, begin: float, time: float, state: Floats) -> Floats:
        """The state that keeps the constraints, at a time after the begin."""
        return self._surface.onto(np.array([begin + time]), state[:, None])[:, 0]

    def _watched(self, name: str, what: Given) -> Watched:
        """A quantity as a function of times (N,) and states (…, N), and the direction."""
        system, n = self.system, len(self.q)
        what, direction = what if isinstance(what, tuple) and len(what) == 2 else (what, 0)
        if checks.number(f"the direction of {name}", direction) not in (-1, 0, 1):
            raise RigidtopError(f"the direction of {name} is +1, −1 or 0, not {direction}")
        if name == "until":
            system.varying(name, what)  # a number there is meant as a time
        function = system.numeric.of((system.quantity(expression(name, what)),))

        def value(times: Floats, states: Floats) -> Floats:
            values: Floats = function.array(times, *states[: 2 * n], *self.parameters)[0].copy()
            for k in np.flatnonzero(~np.isfinite(values)):  # the reason is told for one number
                row = (float(times[k]), *states[: 2 * n, k].tolist(), *self.parameters)
                [values[k], *_], why = computed(lambda row: function.scalar(*row), row)
                if why:
                    raise RigidtopError(f"{name} can't be computed at t = {times[k]:g}: {why}")
            return values

        return Watched(value, direction)

    def _sizes(self, state: Floats) -> Floats:
        return sizes(self.system, state)

    def _flow(
        self, start: Floats, end: float, accuracy: Accuracy, sizes: Sizes, begin: float = 0.0
    ) -> Flow:
        if self.system.friction:
            # How fast a block starts says nothing of how fast it is when it has turned.
            unit = sizes(np.zeros_like(start))
            return self._slipping.flow(self._smooth, start, end, accuracy, unit)
        unit = sizes(start)
        held = partial(self._held, begin) if self.system.constraints else None
        series = partial(self._taylor, start, unit, held)
        own = sizes if held is None else lambda _: unit
        hint = STICKS if self.system.switches else ""
        return flow(
            InitialValueProblem(self.rates_at, start, own, series, held, hint), end, accuracy
        )

    @cached_property
    def _slipping(self) -> Slipping:
        return Slipping(self.system, self.parameters)

    def _smooth(self, system: Computed, parameters: tuple[float, ...], *flow_options: Any) -> Flow:
        """The flow of what slides, or sticks."""
        return replace(self, system=system, parameters=parameters)._flow(*flow_options)

    def _taylor(
        self, start: Floats, unit: Floats, held: Held | None, end: float, rtol: float
    ) -> Flow:
        """The flow by heyoka's Taylor series, in `unit`s: below 1 its tolerance is absolute."""
        values = with_units(self.system, unit, np.array(self.parameters))
        with self.system.numeric.series(rtol) as integrator:
            integrator.pars[:] = values[: len(integrator.pars)]
            integrator.state[:] = start / unit
            return taylor.propagated(integrator, end, unit, held=held)
