"""Motions with dry friction: smooth ones by turns, that slide and that stick."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from rigidtop.errors import RigidtopError
from rigidtop.motion.attitude import Floats
from rigidtop.motion.integrate import Accuracy, Flow, joined
from rigidtop.motion.systems import Sizes
from rigidtop.system.events import zeros
from rigidtop.system.held import Surface
from rigidtop.system.numeric import Computed

Run = Callable[[Computed, tuple[float, ...], Floats, float, Accuracy, Sizes, float], Flow]
"""A smooth system, its parameters, where it starts, for how long, how accurately, since when."""

RESTS = 1e-13
"""A velocity that is less, relative to its terms, is zero: rounding of ẋ − u is not sliding."""

EDGE = 1e-12
"""A force that is so little more than friction can be, relative to that, is not more yet."""

FIRST, MOST, LEAST = 1e-3, 1 / 20, 1e-7
"""Of the whole time, how long the first piece may be, any piece, and each one at least."""

IDLE = 100
"""So many turns in a row between which no time goes by are no motion."""


@dataclass(frozen=True)
class Slipping:
    """A system with dry friction, in numbers, and when it slides and when it sticks.

    A state is (q, q̇, work, …, slip): slip is the sign of the sliding velocity, 0 while it sticks.
    """

    system: Computed

    parameters: tuple[float, ...]
    """In the order of `System.parameters`."""

    def measured(self, times: Floats, states: Floats) -> Floats:
        """The rows of `Numeric.friction` along states (…, N) at times (N,)."""
        n = len(self.system.q)
        rows: Floats = self.system.numeric.friction.array(times, *states[: 2 * n], *self.parameters)
        return rows

    def solved(self, slip: float, times: Floats, states: Floats) -> Floats:
        """q̈ and −λ while it slides, with a sign, or sticks: with −λ of the friction behind them."""
        n, (system, parameters) = len(self.system.q), self.chosen(slip)
        rows: Floats = system.numeric.solved.array(times, *states[: 2 * n], *parameters)
        return rows

    def friction(self, times: Floats, states: Floats, slip: Floats) -> Floats:
        """The force of friction along the sliding velocity (N,)."""
        force: Floats = -slip * self.measured(times, states)[3]
        rest = slip == 0
        if rest.any():
            force[rest] = -self.solved(0, times[rest], states[:, rest])[-1]
        return force

    def chosen(self, slip: float) -> tuple[Computed, tuple[float, ...]]:
        """What slides or sticks, and its parameters."""
        system = self.system.sliding if slip else self.system.sticking
        values = dict(zip(self.system.parameters, self.parameters, strict=True))
        values[self.system.slip] = float(slip)
        return system, tuple(values[x] for x in system.parameters)

    def begun(self, time: float, state: Floats, at_rest: bool) -> Floats:
        """The state with what it does from now on: with w = 0, if `at_rest`, or looked at."""
        at, moved = np.array([time]), state.copy()
        w, size, normal, kinetic, static = self.measured(at, moved[:, None])[:, 0]
        check_normal(at, np.array([normal]))
        if static < kinetic:
            raise RigidtopError(f"mu_static is less than mu: μₛN = {static:g}, μN = {kinetic:g}")
        if not at_rest and abs(w) > RESTS * size:
            moved[-1] = np.sign(w)
            return moved
        moved = Surface(*self.chosen(0)).onto(at, moved[:, None])[:, 0]
        needed = -float(self.solved(0, at, moved[:, None])[-1, 0])
        moved[-1] = 0 if abs(needed) <= static * (1 + EDGE) else -np.sign(needed)
        return moved

    def flow(self, run: Run, start: Floats, end: float, accuracy: Accuracy, unit: Floats) -> Flow:
        """The flow from t = 0 to `end`, with tolerances that are fractions of `unit`."""
        if end < 0:
            raise RigidtopError(
                "dry friction does not tell where a motion came from: give times t ≥ 0"
            )
        return joined(list(self._pieces(run, start, end, accuracy, unit)))

    def _pieces(
        self, run: Run, state: Floats, end: float, accuracy: Accuracy, unit: Floats
    ) -> Iterator[Flow]:
        time, span, idle = 0.0, FIRST * end, 0
        while time < end:
            last = end if time + span >= end * (1 - LEAST) else time + span
            piece = self._smooth(run, time, state, last, accuracy, unit)
            at, slip = self._turn(piece, state[-1])
            steps = np.append(piece.steps[piece.steps < at], at)
            check_normal(steps, self.measured(steps, piece.path(steps))[2])
            state = piece.path(np.array([at]))[:, 0]
            if slip is not None:
                state = self.begun(at, state, True) if state[-1] else _with(state, slip)
            if at > time:
                yield _ending(piece, steps, state)
            idle = idle + 1 if at - time <= LEAST**2 * end else 0
            if idle > IDLE:
                raise RigidtopError(f"the friction at t = {at:g} neither slides nor sticks")
            span = 2 * span if slip is None else max(2 * (at - time), LEAST * end)
            time, span = at, min(span, MOST * end)

    def _turn(self, run: Flow, slip: float) -> tuple[float, float | None]:
        """When what slides stops or what sticks lets go, and how it slides then; or the end."""
        turns: list[tuple[float, float | None]] = [(float(run.steps[-1]), None)]
        for direction in (slip,) if slip else (-1.0, 1.0):

            def left(times: Floats, states: Floats, direction: float = direction) -> Floats:
                measured = self.measured(times, states)
                if slip:
                    return np.asarray(direction * measured[0])
                needed = -self.solved(0, times, states)[-1]
                return np.asarray(measured[4] + direction * needed)

            falls = zeros(run, left, float(run.steps[-1])).towards(-1).times
            first = run.steps[:2]
            at_once = left(first, run.path(first))[1] < 0 and not (falls <= first[1]).any()
            times = [float(first[0])] if at_once else falls[:1].tolist()
            turns += [(at, direction) for at in times]
        return min(turns, key=lambda turn: turn[0])

    def _smooth(
        self,
        run: Run,
        time: float,
        state: Floats,
        end: float,
        accuracy: Accuracy,
        unit: Floats,
    ) -> Flow:
        """What the state does until `end` if it slides, or sticks, all the time."""
        system, parameters = self.chosen(state[-1])
        n = 2 * len(self.system.q)
        works, timed = system.numeric.works, system.numeric.timed

        def own(whole: Floats, clock: float) -> Floats:
            return np.array([*whole[: n + works], *([clock] * timed)])

        sizes = own(unit, 1.0)
        inner = run(
            system, parameters, own(state, time), end - time, accuracy, lambda _: sizes, time
        )

        def path(times: Floats) -> Floats:
            states = np.repeat(state[:, None], len(times), axis=1)
            states[: n + works] = inner.path(times - time)[: n + works]
            return states

        steps = inner.steps + time
        steps[-1] = end
        return Flow(path, steps)


def _ending(run: Flow, steps: Floats, state: Floats) -> Flow:
    """A part of a flow, to the last of the steps, with the state there that is gone on from."""

    def path(times: Floats) -> Floats:
        return np.where(times == steps[-1], state[:, None], run.path(times))

    return Flow(path, steps)


def _with(state: Floats, slip: float) -> Floats:
    return np.array([*state[:-1], slip])


def check_normal(times: Floats, normal: Floats) -> None:
    """Raises RigidtopError where surfaces would be pulled together."""
    for k in np.flatnonzero(normal < 0)[:1]:
        raise RigidtopError(
            f"the normal force of the friction is {normal[k]:g} at t = {times[k]:g}: it can't be "
            "negative, the contact is lost there; end the motion before, with until="
        )
