"""A top on a table from moment to moment: it slides, stands still, rolls, slips, falls, lifts off.

The state is (q₀ … q₃, ω₁, ω₂, ω₃, v_x, v_y, χ, X, Y, W_f, W_a): the attitude of the frame that
follows e₃ without turning about it and ω there, the slip v of the contact, the turn χ of the body
about e₃ in that frame, the centre of mass over the table, and what friction and air have
dissipated.  The equations are those of `theory.sliding`.  Since v itself is integrated, rolling is
v = 0 exactly, and a slip that dies out is known relative to itself.

The contact slides or rolls until an event; then the other law takes over, or the motion ends.
Coulomb friction has no direction where nothing slips, so a slip below `STANDSTILL` counts as none,
and one that begins starts with twice that.  Either is done by the impulse that does just this, and
what it does to the energy is booked under friction: what is neglected is of second order.

Between that and `SLOW` the direction turns the faster the less slips.  There the slip is integrated
implicitly, and to a fraction of `STANDSTILL` whatever the tolerance: a step that could miss the end
of the slip by more than that goes through rest to the other side, and back, without end.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from rigidtop.errors import RigidtopError
from rigidtop.motion import equations
from rigidtop.motion.attitude import Floats
from rigidtop.motion.equations import Number, Rates
from rigidtop.motion.integrate import SUBSTEPS, Accuracy, Flow, Method, Path

if TYPE_CHECKING:
    from rigidtop.motion.sliding import SlidingTop

VARIABLES = 14

STANDSTILL = 1e-10
"""A slip below this, in units of √(gR), is none."""

SLOW = 1e-3
"""Up to this slip, in units of √(gR), friction turns quickly and is integrated implicitly; a slip
that dies out is so from half of that."""

SLIP_TOLERANCE = 1e-2
"""The absolute tolerance of a slip is at most this times the least one of its regime."""

JAMMED = 1e-6
"""What the normal force is divided by is 1 for an upright top; below this it is as good as 0."""

MOST_EVENTS = 500
"""More changes between sliding and rolling than these are refused: a top whose tip sticks and slips
with every nutation, a hundred times a second, takes as long to integrate as to play with."""

MOST_RATES = 10_000
"""LSODA asks for some hundreds of them for a slow slip, or fails to see that it is stiff and goes
on for ever: then Radau, slower but always implicit, takes over."""

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

Direction = tuple[float, float]
NOWHERE: Direction = 0.0, 0.0


@dataclass(frozen=True)
class Moment:
    """What a state leads to: its rate, the contact force, the slip's rate, N's divisor."""

    rate: tuple[Number, ...]
    force: tuple[Number, Number, Number]
    slipping: tuple[Number, Number] = (0.0, 0.0)
    divisor: Number = 1.0


class _TooManyError(Exception):
    """Rates that a solver asks for."""


class Contact:
    """The equations of one top, of states as floats or as arrays."""

    def __init__(self, body: SlidingTop) -> None:
        b = body
        drags = b.drag, b.drag1, b.drag3
        shape = b.lambda1, b.lambda3, b.M, b.R, b.tip
        self.body = body
        self.kinematics: Rates = equations.contact_kinematics(
            b.lambda1, b.lambda3, b.M, b.g, b.R, b.tip, *drags
        )
        self._slide: Rates = equations.sliding_force(*shape, b.mu, b.viscosity)
        self._roll: Rates = equations.rolling_force(*shape)
        self._top: Rates = equations.sliding_top(b.lambda1, b.lambda3, b.R, b.tip, *drags)
        self.speed_unit = math.sqrt(b.g * b.R)

    def sliding(self, state: Sequence[Number], direction: tuple[Number, Number]) -> Moment:
        """In that direction of the slip, a unit vector."""
        known = self.kinematics(state[:9])
        axis, velocity, free = known[:3], known[3:6], known[6:]
        found = self._slide((*axis, *state[7:9], *direction, *free))
        force, slipping = (found[0], found[1], found[2]), (found[3], found[4])
        return Moment(self._rate(state, velocity, force, slipping), force, slipping, found[5])

    def slipping(self, state: Sequence[Number], otherwise: Direction) -> Moment:
        """In the direction of the slip, or `otherwise` where there is none."""
        direction: tuple[Number, Number]
        if isinstance(state[7], float):
            speed = math.hypot(state[7], state[8])
            direction = (state[7] / speed, state[8] / speed) if speed else otherwise
        else:
            speed = np.hypot(state[7], state[8])
            known = np.where(speed > 0, speed, 1.0)
            direction = (
                np.where(speed > 0, state[7] / known, otherwise[0]),
                np.where(speed > 0, state[8] / known, otherwise[1]),
            )
        return self.sliding(state, direction)

    def rolling(self, state: Sequence[Number]) -> Moment:
        """The contact held."""
        known = self.kinematics(state[:9])
        axis, velocity, free = known[:3], known[3:6], known[6:]
        found = self._roll((*axis, *free))
        force = found[0], found[1], found[2]
        return Moment(self._rate(state, velocity, force, (0.0, 0.0)), force)

    def _rate(
        self,
        state: Sequence[Number],
        velocity: Sequence[Number],
        force: Sequence[Number],
        slipping: tuple[Number, Number],
    ) -> tuple[Number, ...]:
        turning = self._top((*state[:9], *velocity, *force))
        return *turning[:7], *slipping, state[6], velocity[0], velocity[1], *turning[7:]

    def holds(self, state: Sequence[float]) -> bool:
        """Whether static friction can hold the contact, which does not slip now."""
        return bool(self.body.mu > 0 and self.reserve(self.rolling(state)) >= 0)

    def reserve(self, rolling: Moment) -> Number:
        """μN − |F| of a contact that rolls."""
        friction_x, friction_y, normal = rolling.force
        return self.body.mu * normal - np.hypot(friction_x, friction_y)

    def struck(self, state: Sequence[float], slip: Direction) -> list[float]:
        """The state after the impulse at the contact that makes the slip what it is to be."""
        known = self.kinematics(state[:9])
        change = slip[0] - state[7], slip[1] - state[8]
        impulse = self._roll((*known[:3], -change[0], -change[1], 0.0))
        still = (0.0,) * 5
        pushed, left = (
            self._top((*state[:7], *still, *force)) for force in (impulse, (0.0, 0.0, 0.0))
        )
        after = list(state)
        for k in (4, 5, 6):
            after[k] += pushed[k] - left[k]
        after[7:9] = slip
        gained = sum(
            (before + now) / 2 * push
            for before, now, push in zip(state[7:9], slip, impulse, strict=False)
        )
        after[12] -= gained
        return after

    def onset(self, state: Sequence[float]) -> Direction:
        """Where a contact that rests but cannot be held starts to slip: v̇ along v.

        Raises RigidtopError where no direction does that.
        """

        def across(angle: float) -> float:
            d = math.cos(angle), math.sin(angle)
            v = self.sliding(state, d).slipping
            return float(d[0] * v[1] - d[1] * v[0])

        # None of these is an axis, along which a top falls that does not spin.
        angles = np.linspace(-math.pi, math.pi, 361) + 0.01
        turning = [across(angle) for angle in angles]
        # Stable where a slip that points a little aside turns back.
        found = [
            brentq(across, angles[k], angles[k + 1])
            for k in range(len(angles) - 1)
            if turning[k] > 0 >= turning[k + 1]
        ]
        rates = []
        for angle in found:
            d = math.cos(angle), math.sin(angle)
            v = self.sliding(state, d).slipping
            rates.append((d[0] * v[0] + d[1] * v[1], d))
        fastest, direction = max(rates, default=(0.0, NOWHERE))
        if fastest <= 0:
            raise RigidtopError(
                "friction can neither hold the contact nor let it slip from rest (Painlevé): "
                "the rigid body has no motion there; a smaller mu has"
            )
        return direction


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
    def ended(self) -> Event | None:
        """The fall or the lift-off with which it ended."""
        return self.events[-1] if self.events and self.events[-1].kind in ENDINGS else None


def course(contact: Contact, start: Sequence[float], end: float, accuracy: Accuracy) -> Course:
    """Integrate from t = 0 to `end` > 0.

    Raises RigidtopError where the solver gives up, where the top does not stand on the table at the
    start, and where friction jams it (Painlevé).
    """
    state, time, events = list(start), 0.0, list[Event]()
    small = STANDSTILL * contact.speed_unit
    coulomb = contact.body.mu > 0
    if coulomb and 0 < math.hypot(*state[7:9]) <= small:
        state = contact.struck(state, NOWHERE)
    phases: list[Phase] = []
    at_rest = coulomb and not any(state[7:9])
    rolling, direction = _law(contact, state) if at_rest else (False, NOWHERE)
    onset = at_rest and not rolling
    least = SLOW * contact.speed_unit
    slow = coulomb and not rolling and math.hypot(*state[7:9]) < least
    while time < end:
        if len(events) > MOST_EVENTS:
            raise RigidtopError(
                f"more than {MOST_EVENTS} changes between sliding and rolling until t = {time:g}: "
                "the tip sticks and slips all the time; ask for earlier times"
            )
        if onset:
            state = contact.struck(state, (2 * small * direction[0], 2 * small * direction[1]))
            slow = True
        flow, state, kind = _phase(contact, state, (time, end), accuracy, rolling, direction, slow)
        time = float(flow.steps[-1])
        phases.append(Phase(flow, rolling))
        onset, slow = False, kind == SLOWS
        if kind in (STANDS, SLIPS, *ENDINGS):
            events.append(Event(time, kind))
        if kind in ENDINGS:
            break
        if kind == STANDS:
            state = contact.struck(state, NOWHERE)
            rolling, direction = _law(contact, state)
            onset = not rolling
            if onset:
                events.append(Event(time, SLIPS))
        elif kind == SLIPS:
            friction = contact.rolling(state).force[:2]
            size = math.hypot(*friction)
            direction = -friction[0] / size, -friction[1] / size
            rolling, onset = False, True
    return Course(tuple(phases), tuple(events))


def _law(contact: Contact, state: Sequence[float]) -> tuple[bool, Direction]:
    """Whether a contact at rest rolls, and if not, where it starts to slip."""
    # Where rolling would pull, it lifts off whatever friction does.
    if contact.holds(state) or contact.rolling(state).force[2] <= 0:
        return True, NOWHERE
    return False, contact.onset(state)


def _phase(
    contact: Contact,
    start: Sequence[float],
    span: tuple[float, float],
    accuracy: Accuracy,
    rolling: bool,
    direction: Direction,
    slow: bool,
) -> tuple[Flow, list[float], str]:
    """One law of contact until an event, or until the slip is no longer slow, or no longer fast."""
    body = contact.body
    floor = math.cos(body.fall)

    # What is watched looks at the same state, often the one of the solver's last stage.
    seen: tuple[Sequence[Number], Moment] | None = None
    count, most = 0, math.inf

    # Of a state as floats, or of many as rows.
    def moment(state: Sequence[Number]) -> Moment:
        nonlocal seen
        if seen is None or not (state is seen[0] or _same(state, seen[0])):
            seen = (
                state,
                contact.rolling(state) if rolling else contact.slipping(state, direction),
            )
        return seen[1]

    def rates(_: float, state: Floats) -> tuple[float, ...]:
        nonlocal count
        count += 1
        if count > most:
            raise _TooManyError
        return moment(state.tolist()).rate

    def faster_than(slip: float) -> Watch:
        return lambda state: np.hypot(state[7], state[8]) - slip * contact.speed_unit

    watched: dict[str, Watch] = {LIFTS: lambda state: moment(state).force[2]}
    if body.fall < math.pi:
        watched[FALLS] = lambda state: 1 - 2 * (state[1] ** 2 + state[2] ** 2) - floor
    if rolling:
        watched[SLIPS] = lambda state: contact.reserve(moment(state))
    else:
        watched[JAM] = lambda state: moment(state).divisor - JAMMED
        if slow:
            watched[STANDS] = faster_than(STANDSTILL)
            watched[QUICKENS] = lambda state: -faster_than(SLOW)(state)
        elif body.mu > 0:
            watched[SLOWS] = faster_than(SLOW / 2)
    first = np.array(start)
    now = moment(start)
    _check_jam(float(now.divisor), span[0])
    if not np.all(np.isfinite(now.rate)):
        raise RigidtopError("the rates overflow: the velocities are too large")
    if now.force[2] <= 0:
        if span[0] == 0:
            raise RigidtopError(
                f"the top does not stay on the table: it would have to pull with "
                f"{-now.force[2]:.3g} N at the start; start more slowly"
            )
        return (
            Flow(lambda t: np.repeat(first[:, None], len(t), axis=1), np.array([span[0]])),
            (list(start)),
            LIFTS,
        )
    # Its direction settles while the slip is still of the size with which it starts.
    settling = math.hypot(*start[7:9]) / (body.mu * body.g) if slow else 0.0
    tolerances = accuracy.atol * units(body)
    if body.mu > 0 and not rolling:
        least = STANDSTILL if slow else SLOW
        tolerances[7:9] = contact.speed_unit * min(accuracy.atol, SLIP_TOLERANCE * least)

    def solved(method: str) -> Any:
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", category=UserWarning, message="lsoda")
            return solve_ivp(
                rates,
                span,
                first,
                method=cast(Method, method),
                rtol=accuracy.rtol,
                atol=tolerances,
                dense_output=True,
                events=[_event(watch) for watch in watched.values()],
                first_step=min(0.1 * settling, span[1] - span[0]) if slow else None,
            )

    if slow:
        most = MOST_RATES
        try:
            solution = solved("LSODA")
        except _TooManyError:
            solution = None
        if solution is None or solution.status < 0:
            most = math.inf
            solution = solved("Radau")
    else:
        solution = solved(accuracy.method)
    last = solution.y[:, -1]
    path = solution.sol
    if path is None or solution.status < 0 or not np.all(np.isfinite(last)):
        _check_jam(float(moment(last).divisor), float(solution.t[-1]), 1e-2)
        reached = f"t = {solution.t[-1]:g} on the way to {span[1]:g}"
        raise RigidtopError(f"the integration stopped at {reached}: {solution.message}")
    kind = ""
    if solution.status == 1 and solution.t_events is not None:
        at = [k for k, times in enumerate(solution.t_events) if len(times)]
        kind = list(watched)[at[0]]
    steps = solution.t
    unseen = None if slow else _unseen(path, steps, watched)
    if unseen is not None:
        time, kind = unseen
        steps = np.append(steps[steps < time], time)
        last = path(time)
    if kind == JAM:
        _check_jam(0.0, float(steps[-1]))
    return Flow(path, steps), last.tolist(), kind


def _same(one: Sequence[Number], other: Sequence[Number]) -> bool:
    return isinstance(one[0], float) and isinstance(other[0], float) and one == other


def _event(watch: Watch) -> Callable[[float, Floats], float]:
    """For `solve_ivp`: to stop where it falls to zero."""

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


def units(body: SlidingTop) -> Floats:
    """What the absolute tolerance multiplies, for each variable: 1, √(g/R), R and so on."""
    rate, length = math.sqrt(body.g / body.R), body.R
    speed, energy = rate * length, body.M * body.g * body.R
    return np.array([1.0] * 4 + [rate] * 3 + [speed] * 2 + [1.0] + [length] * 2 + [energy] * 2)
