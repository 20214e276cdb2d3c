"""A top on a table from moment to moment: it slides, stands still, rolls, slips, falls, lifts off.

The contact slides or rolls until an event; then the other law takes over, or the motion ends.
Coulomb friction has no direction where nothing slips, so a slip below `STANDSTILL` counts as none,
and one that begins starts with twice that.  Either is done by the impulse that does just this, and
what it does to the energy is booked under friction: what is neglected is of second order.  Since
the slip itself is integrated, rolling is v = 0 exactly, and a slip that dies out is known relative
to itself.

Between that and `SLOW` the direction turns the faster the less slips.  There the slip is integrated
implicitly, and to a fraction of `STANDSTILL` whatever the tolerance: a step that could miss the end
of the slip by more than that goes through rest to the other side, and back, without end.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from rigidtop.errors import RigidtopError
from rigidtop.motion.attitude import Floats
from rigidtop.motion.equations import Number
from rigidtop.motion.integrate import SUBSTEPS, Accuracy, Flow, Method, Path, joined
from rigidtop.motion.table.contact import NOWHERE, Contact, Direction, Moment, units

STANDSTILL = 1e-10
"""A slip below this, in units of √(gR), is none."""

SLOW = 1e-3
"""Up to this slip, in units of √(gR), friction turns quickly and is integrated implicitly; a slip
that dies out is so from half of that."""

IMPLICIT = "Radau"
"""The method for it.  LSODA is faster where it works; at times it does not see that the slip is
stiff, and goes on for ever."""

SLIP_TOLERANCE = 1e-2
"""The absolute tolerance of a slip is at most this times the least one of its regime."""

JAMMED = 1e-6
"""What the normal force is divided by is 1 for an upright top; below this it is as good as 0."""

MOST_EVENTS = 500
"""More changes between sliding and rolling than these are refused: a top whose tip sticks and slips
with every nutation, a hundred times a second, takes as long to integrate as to play with."""

STANDS, SLIPS, LIFTS, FALLS = "standstill", "slip", "lift-off", "fall"
ENDINGS = (LIFTS, FALLS)
SLOWS, QUICKENS, JAM = "slows", "quickens", "jam"


@dataclass(frozen=True)
class Event:
    """A moment at which the contact changes."""

    time: float
    """s."""

    kind: str
    """"standstill" (the slip ends), "slip" (it begins), "lift-off" or "fall" (the motion ends)."""


Watch = Callable[[Sequence[Number]], Number]
"""A state, as floats or as rows of many, to what ends a phase where it falls to zero."""


@dataclass(frozen=True)
class ContactLaw:
    """How the contact goes on, until an event."""

    contact: Contact
    rolling: bool

    direction: Direction = NOWHERE
    """Of a slip that is none yet."""

    slow: bool = False
    """Whether it slips slowly."""

    def moment(self, state: Sequence[Number]) -> Moment:
        """The rates and the force at a state of floats, or at many as rows."""
        if self.rolling:
            return self.contact.rolling(state)
        return self.contact.slipping(state, self.direction)

    def rates(self, _: float, state: Floats) -> tuple[Number, ...]:
        return self.moment(state.tolist()).rate

    def watched(self) -> dict[str, Watch]:
        """The events that end it, by their names."""
        body, contact = self.contact.body, self.contact

        def speed(state: Sequence[Number]) -> Number:
            return np.hypot(state[7], state[8]) / contact.speed_unit

        watches: dict[str, Watch] = {LIFTS: lambda state: self.moment(state).force[2]}
        if body.fall < math.pi:
            floor = math.cos(body.fall)
            watches[FALLS] = lambda state: 1 - 2 * (state[1] ** 2 + state[2] ** 2) - floor
        if self.rolling:
            watches[SLIPS] = lambda state: contact.reserve(self.moment(state))
            return watches
        watches[JAM] = lambda state: self.moment(state).divisor - JAMMED
        if self.slow:
            watches[STANDS] = lambda state: speed(state) - STANDSTILL
            watches[QUICKENS] = lambda state: SLOW - speed(state)
        elif body.mu > 0:
            watches[SLOWS] = lambda state: speed(state) - SLOW / 2
        return watches

    def tolerances(self, atol: float) -> Floats:
        """The absolute tolerance of each variable of the state."""
        body, tolerances = self.contact.body, atol * units(self.contact.body)
        if body.mu > 0 and not self.rolling:
            least = STANDSTILL if self.slow else SLOW
            tolerances[7:9] = self.contact.speed_unit * min(atol, SLIP_TOLERANCE * least)
        return tolerances

    def solved(self, state: Floats, span: tuple[float, float], accuracy: Accuracy) -> Any:
        """What `solve_ivp` finds until the first event that it sees."""
        first_step = None
        if self.slow:
            # The direction settles while the slip is still of the size with which it starts.
            settling = math.hypot(*state[7:9]) / (self.contact.body.mu * self.contact.body.g)
            first_step = min(0.1 * settling, span[1] - span[0])
        return solve_ivp(
            self.rates,
            span,
            state,
            method=cast(Method, IMPLICIT if self.slow else accuracy.method),
            rtol=accuracy.rtol,
            atol=self.tolerances(accuracy.atol),
            dense_output=True,
            events=[_event(watch) for watch in self.watched().values()],
            first_step=first_step,
        )


@dataclass(frozen=True)
class Phase:
    """A part of the motion with one law of contact."""

    flow: Flow
    rolling: bool


@dataclass(frozen=True)
class Course:
    """The motion from t = 0 until the last time, or until it ended."""

    phases: tuple[Phase, ...]
    events: tuple[Event, ...]

    @property
    def flow(self) -> Flow:
        """The flow of all phases, one after the other."""
        return joined([phase.flow for phase in self.phases])

    def rolling(self, times: Floats) -> NDArray[np.bool_]:
        """Whether the contact rolls, at times (N,)."""
        ends = np.array([phase.flow.steps[-1] for phase in self.phases[:-1]])
        return np.array([phase.rolling for phase in self.phases])[np.searchsorted(ends, times)]


def ending(events: Sequence[Event]) -> Event | None:
    """The fall or the lift-off with which a motion ended, if it did."""
    return events[-1] if events and events[-1].kind in ENDINGS else None


def course(contact: Contact, start: Sequence[float], end: float, accuracy: Accuracy) -> Course:
    """Integrate from t = 0 to `end` > 0.

    Raises RigidtopError where the solver gives up, where the top does not stand on the table at the
    start, and where friction jams it (Painlevé).
    """
    phases, events, time = list[Phase](), list[Event](), 0.0
    state, law = _begun(contact, list(start))
    while time < end:
        if len(events) > MOST_EVENTS:
            raise RigidtopError(
                f"more than {MOST_EVENTS} changes between sliding and rolling until t = {time:g}: "
                "the tip sticks and slips all the time; ask for earlier times"
            )
        flow, state, kind = _phase(law, state, (time, end), accuracy)
        time = float(flow.steps[-1])
        phases.append(Phase(flow, law.rolling))
        if kind in (STANDS, SLIPS, *ENDINGS):
            events.append(Event(time, kind))
        if kind in ENDINGS:
            break
        if kind == STANDS:
            state, law = _from_rest(contact, contact.struck(state, NOWHERE))
            if not law.rolling:
                events.append(Event(time, SLIPS))
        elif kind == SLIPS:
            friction = contact.rolling(state).force[:2]
            size = math.hypot(*friction)
            state, law = _slipping(contact, state, (-friction[0] / size, -friction[1] / size))
        else:
            law = replace(law, slow=kind == SLOWS)
    return Course(tuple(phases), tuple(events))


def _begun(contact: Contact, state: list[float]) -> tuple[list[float], ContactLaw]:
    """The state at t = 0, without a slip too small to count, and its law."""
    speed = math.hypot(*state[7:9]) / contact.speed_unit
    if contact.body.mu == 0 or speed >= SLOW:
        return state, ContactLaw(contact, rolling=False)
    if speed > STANDSTILL:
        return state, ContactLaw(contact, rolling=False, slow=True)
    return _from_rest(contact, contact.struck(state, NOWHERE) if speed else state)


def _from_rest(contact: Contact, state: list[float]) -> tuple[list[float], ContactLaw]:
    """How a contact at rest goes on: it rolls, or starts to slip."""
    # Where rolling would pull, it lifts off whatever friction does.
    if contact.holds(state) or contact.rolling(state).force[2] <= 0:
        return state, ContactLaw(contact, rolling=True)
    return _slipping(contact, state, contact.onset(state))


def _slipping(
    contact: Contact, state: list[float], direction: Direction
) -> tuple[list[float], ContactLaw]:
    """A contact at rest, struck so that it slips as little as counts."""
    speed = 2 * STANDSTILL * contact.speed_unit
    struck = contact.struck(state, (speed * direction[0], speed * direction[1]))
    return struck, ContactLaw(contact, rolling=False, direction=direction, slow=True)


def _phase(
    law: ContactLaw, start: list[float], span: tuple[float, float], accuracy: Accuracy
) -> tuple[Flow, list[float], str]:
    """One law until an event, or the end of the span: the state there, and the event's name."""
    first = np.array(start)
    if _lifts_at_once(law, start, span[0]):
        still = Flow(lambda t: np.repeat(first[:, None], len(t), axis=1), np.array([span[0]]))
        return still, start, LIFTS
    solution = law.solved(first, span, accuracy)
    path, steps, last = solution.sol, solution.t, solution.y[:, -1]
    if path is None or solution.status < 0 or not np.all(np.isfinite(last)):
        _check_jam(float(law.moment(last.tolist()).divisor), float(steps[-1]), 1e-2)
        reached = f"t = {steps[-1]:g} on the way to {span[1]:g}"
        raise RigidtopError(f"the integration stopped at {reached}: {solution.message}")
    watched = law.watched()
    seen = zip(watched, solution.t_events, strict=True)
    kind = next((name for name, times in seen if len(times)), "")
    unseen = None if law.slow else _unseen(path, steps, watched)
    if unseen is not None:
        time, kind = unseen
        steps, last = np.append(steps[steps < time], time), path(time)
    if kind == JAM:
        _check_jam(0.0, float(steps[-1]))
    return Flow(path, steps), last.tolist(), kind


def _lifts_at_once(law: ContactLaw, state: list[float], time: float) -> bool:
    """Whether the table would have to pull; RigidtopError at t = 0, or where no motion goes on."""
    now = law.moment(state)
    _check_jam(float(now.divisor), time)
    if not np.all(np.isfinite(now.rate)):
        raise RigidtopError("the rates overflow: the velocities are too large")
    if now.force[2] > 0:
        return False
    if time == 0:
        raise RigidtopError(
            f"the top does not stay on the table: it would have to pull with "
            f"{-now.force[2]:.3g} N at the start; start more slowly"
        )
    return True


def _event(watch: Watch) -> Callable[[float, Floats], float]:
    """The event at which `solve_ivp` stops: where it falls to zero."""

    def event(_: float, state: Floats) -> float:
        return float(watch(state.tolist()))

    event.terminal, event.direction = True, -1  # type: ignore[attr-defined]
    return event


def _unseen(path: Path, steps: Floats, watched: dict[str, Watch]) -> tuple[float, str] | None:
    """When, and which of them, first falls to zero within a step: the solver looks at its ends."""
    fractions = np.arange(SUBSTEPS) / SUBSTEPS
    nodes = np.append((steps[:-1, None] + np.diff(steps)[:, None] * fractions).ravel(), steps[-1])
    rows = list(path(nodes))
    values = np.stack([watch(rows) for watch in watched.values()])
    # The last interval is the solver's own, up to an event that it has found.
    falls = (values[:, :-2] > 0) & (values[:, 1:-1] < 0)
    if not falls.any():
        return None
    k = int(np.flatnonzero(falls.any(axis=0))[0])

    def moment(watch: Watch) -> float:
        return float(brentq(lambda t: watch(path(t).tolist()), nodes[k], nodes[k + 1], xtol=1e-300))

    there = [item for item, falling in zip(watched.items(), falls[:, k], strict=True) if falling]
    return min((moment(watch), kind) for kind, watch in there)


def _check_jam(divisor: float, time: float, least: float = JAMMED) -> None:
    if not divisor > least:
        raise RigidtopError(
            f"the top jams at t = {time:g}: against so much friction (mu) no normal force keeps "
            "its tip on the table (Painlevé); a smaller mu or a smaller tilt does"
        )
