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
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, cast

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from rigidtop.errors import RigidtopError
from rigidtop.motion import equations
from rigidtop.motion.attitude import Floats
from rigidtop.motion.equations import Number, Rates
from rigidtop.motion.integrate import Accuracy, Flow, Method

if TYPE_CHECKING:
    from rigidtop.motion.sliding import SlidingTop

VARIABLES = 14

STANDSTILL = 1e-10
"""A slip below this, in units of √(gR), is none."""

ONSET = 1e-4
"""Below this slip, where friction turns quickly, a slip that begins is integrated implicitly."""

JAMMED = 1e-6
"""What the normal force is divided by is 1 for an upright top; below this it is as good as 0."""

MOST_EVENTS = 10_000
"""More changes between sliding and rolling than these are no motion of a top."""

STANDS, SLIPS, LIFTS, FALLS = "standstill", "slip", "lift-off", "fall"
ENDINGS = (LIFTS, FALLS)
BEGUN, JAM = "begun", "jam"


@dataclass(frozen=True)
class Event:
    """A moment at which the contact changes."""

    time: float
    """s."""

    kind: str
    """"standstill" (the slip ends), "slip" (it begins), "lift-off" or "fall" (the motion ends)."""


Direction = tuple[float, float]
NOWHERE: Direction = 0.0, 0.0


@dataclass(frozen=True)
class Moment:
    """What a state leads to: its rate, the contact force, the slip's rate, N's divisor."""

    rate: tuple[Number, ...]
    force: tuple[Number, Number, Number]
    slipping: tuple[Number, Number] = (0.0, 0.0)
    divisor: Number = 1.0


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

    def slipping(self, state: Sequence[float], otherwise: Direction) -> Moment:
        """In the direction of the slip, or `otherwise` where there is none."""
        speed = math.hypot(state[7], state[8])
        direction = (state[7] / speed, state[8] / speed) if speed else otherwise
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
        return bool(self.body.mu > 0 and self.reserve(state) >= 0)

    def reserve(self, state: Sequence[float]) -> float:
        """μN − |F| of a contact that rolls."""
        friction_x, friction_y, normal = self.rolling(state).force
        return float(self.body.mu * normal - math.hypot(friction_x, friction_y))

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
    while time < end:
        if len(events) > MOST_EVENTS:
            raise RigidtopError(f"more than {MOST_EVENTS} changes of sliding and rolling")
        if onset:
            state = contact.struck(state, (2 * small * direction[0], 2 * small * direction[1]))
        flow, state, kind = _phase(contact, state, (time, end), accuracy, rolling, direction, onset)
        time = float(flow.steps[-1])
        phases.append(Phase(flow, rolling))
        if onset and kind == BEGUN and state[7] * direction[0] + state[8] * direction[1] <= 0:
            raise RigidtopError(f"the slip that begins at t = {time:g} could not be followed")
        onset = False
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
    onset: bool,
) -> tuple[Flow, list[float], str]:
    """One law of contact until an event, or a slip that begins until it is no longer small."""
    body = contact.body
    floor = math.cos(body.fall)

    def moment(state: Floats) -> Moment:
        values = state.tolist()
        return contact.rolling(values) if rolling else contact.slipping(values, direction)

    def rates(_: float, state: Floats) -> tuple[float, ...]:
        return moment(state).rate

    def normal(_: float, state: Floats) -> float:
        return float(moment(state).force[2])

    def reserve(_: float, state: Floats) -> float:
        return contact.reserve(state.tolist())

    def speed(_: float, state: Floats) -> float:
        return math.hypot(state[7], state[8]) - STANDSTILL * contact.speed_unit

    def begun(_: float, state: Floats) -> float:
        return ONSET * contact.speed_unit - math.hypot(state[7], state[8])

    def upright(_: float, state: Floats) -> float:
        return 1 - 2 * float(state[1] ** 2 + state[2] ** 2) - floor

    def divisor(_: float, state: Floats) -> float:
        return float(moment(state).divisor) - JAMMED

    watched: list[tuple[str, Callable[[float, Floats], float]]] = [(LIFTS, normal)]
    if body.fall < math.pi:
        watched.append((FALLS, upright))
    if rolling:
        watched.append((SLIPS, reserve))
    else:
        watched.append((JAM, divisor))
        if body.mu > 0:
            watched.append((STANDS, speed))
        if onset:
            watched.append((BEGUN, begun))
    first = np.array(start)
    now = moment(first)
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
    for _, watch in watched:
        watch.terminal, watch.direction = True, -1  # type: ignore[attr-defined]
    # Its direction settles while the slip is still of the size with which it starts.
    settling = math.hypot(*start[7:9]) / (body.mu * body.g) if onset else 0.0
    solution = solve_ivp(
        rates,
        span,
        first,
        method=cast(Method, "Radau" if onset else accuracy.method),
        rtol=accuracy.rtol,
        atol=accuracy.atol * units(body),
        dense_output=True,
        events=[watch for _, watch in watched],
        first_step=min(0.1 * settling, span[1] - span[0]) if onset else None,
    )
    last = solution.y[:, -1]
    path = solution.sol
    if path is None or solution.status < 0 or not np.all(np.isfinite(last)):
        _check_jam(float(moment(last).divisor), float(solution.t[-1]), 1e-2)
        reached = f"t = {solution.t[-1]:g} on the way to {span[1]:g}"
        raise RigidtopError(f"the integration stopped at {reached}: {solution.message}")
    kind = ""
    if solution.status == 1 and solution.t_events is not None:
        at = [k for k, times in enumerate(solution.t_events) if len(times)]
        kind = watched[at[0]][0]
    if kind == JAM:
        _check_jam(0.0, float(solution.t[-1]))
    return Flow(path, solution.t), last.tolist(), kind


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
