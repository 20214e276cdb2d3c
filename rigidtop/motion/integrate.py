"""Motions by `scipy.integrate.solve_ivp`, in quaternions: no attitude is a special place.

`rigidtop.motion.taylor` does the same by Taylor series.

A body that is symmetric about e₃, with its centre of mass on e₃, is integrated in the frame that
follows e₃ without turning about it (`rigidtop.motion.equations.heavy_top`); the turn about e₃,
which is ω₃t exactly, is put back afterwards.  A fast spin then costs no steps and no accuracy, and
a steady precession, although 10⁴ turns of the body, is nothing but a slowly turning vector.

The norm of the quaternion is conserved by the equations and not enforced while integrating; the
attitudes that come out are normalised.

The absolute tolerance is a fraction of what moves: a top that starts 10⁻¹² from the vertical is
followed as accurately, relative to that, as one that starts at 1.  Should the motion then grow, the
solver starts afresh with a tolerance to match, before what has been negligible rounding drives its
steps to nothing.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, cast, get_args

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from rigidtop.errors import RigidtopError
from rigidtop.motion import checks
from rigidtop.motion.attitude import Complexes, Floats, spinors
from rigidtop.motion.equations import Rates
from rigidtop.motion.systems import Sizes
from rigidtop.parameters import in_one_line

Method = Literal["DOP853", "RK45", "RK23", "Radau", "BDF", "LSODA"]
TAYLOR = "taylor"
METHODS = (*get_args(Method), TAYLOR)

SMALLEST_RTOL = 2.3e-14
"""`solve_ivp` warns below this, a hundred times the rounding of floats, and does not go lower."""

ROUNDING = 2.3e-16
"""No series is better than the rounding of floats, 2⁻⁵²."""

LARGEST_TOLERANCE = 0.1
"""A step that is wrong by more than this, in a unit quaternion, is no approximation."""

GROWTH = 100.0
"""Absolute tolerances are set anew when what they are measured against has grown so much."""

SUBSTEPS = 8
"""A step of the solver is looked at this many times when turns are counted."""

STRAYS = 10.0
"""A motion is brought back to its constraints when it is off by so many tolerances."""

MOST_RETURNS = 1000
"""Of so many steps in a row that all lead away from the constraints none leads on."""

BISECTIONS = 40
"""Near a pole the steps are halved up to so many times: 2⁻⁴⁰ is below the error of a motion."""


@dataclass(frozen=True)
class Accuracy:
    """How a solver is to work; what `atol` is to `solve_ivp`, Taylor series do not need."""

    method: str = "DOP853"
    rtol: float = 1e-10
    atol: float = 1e-12

    def __post_init__(self) -> None:
        if str(self.method) not in METHODS:
            raise RigidtopError(f"unknown method {in_one_line(self.method)}: {', '.join(METHODS)}")
        smallest = ROUNDING if self.method == TAYLOR else SMALLEST_RTOL
        object.__setattr__(self, "rtol", checks.number("rtol", self.rtol))
        object.__setattr__(self, "atol", checks.positive("atol", self.atol))
        if self.rtol < smallest:
            raise RigidtopError(f"rtol must be at least {smallest:g}, not {self.rtol:g}")
        for name, value in (("rtol", self.rtol), ("atol", self.atol)):
            if value > LARGEST_TOLERANCE:
                raise RigidtopError(f"{name} must be at most {LARGEST_TOLERANCE:g}, not {value:g}")


STUCK, CALLS = 1e-7, 20_000
"""Where so many calls move the time by less than this part of it, the steps have shrunk."""

Path = Callable[[Floats], Floats]
"""Times (N,) in, states (n, N) out."""


@dataclass(frozen=True)
class Flow:
    """The motion on one side of t = 0: its `path`, and the times at which the solver stopped."""

    path: Path
    steps: Floats


Flows = Callable[[float], Flow]
"""The last time in, the flow up to there out."""

Progress = Callable[[int, int], None]
"""Is told how many motions of how many are done."""


Held = Callable[[float, Floats], Floats]
"""A time and a state in, the state that keeps the constraints out."""


@dataclass(frozen=True)
class InitialValueProblem:
    """ẋ = rates(x), from a state at t = 0 on: what a solver has to know of a motion."""

    rates: Rates
    start: Floats
    sizes: Sizes
    series: Callable[[float, float], Flow] | None = None
    """The same by Taylor series, from the last time and `rtol`."""
    held: Held | None = None
    """Brings the motion back where the solver's errors have led it away from constraints."""
    hint: str = ""
    """What would be right, where the solver gets stuck."""


def flow(problem: InitialValueProblem, end: float, accuracy: Accuracy) -> Flow:
    """Integrate from t = 0 to `end`, which may be negative.

    Raises RigidtopError with the solver's message when it does not arrive.
    """
    if accuracy.method == TAYLOR and problem.series is not None:
        return problem.series(end, accuracy.rtol)
    return joined(list(_stages(problem, end, accuracy)))


def joined(pieces: Sequence[Flow]) -> Flow:
    """Flows that follow one another, the first from t = 0, as one."""
    # Where each piece but the last hands over to the next.
    breaks = np.abs([piece.steps[-1] for piece in pieces[:-1]])

    def path(times: Floats) -> Floats:
        at = np.searchsorted(breaks, np.abs(times))
        # In no piece without a time: none is evaluated for nothing.
        parts = {k: pieces[k].path(times[at == k]) for k in np.unique(at)}
        states = np.empty((len(next(iter(parts.values()))), len(times)))
        for k, part in parts.items():
            states[:, at == k] = part
        return states

    return Flow(path, np.concatenate([np.zeros(1), *(piece.steps[1:] for piece in pieces)]))


def _stages(problem: InitialValueProblem, end: float, accuracy: Accuracy) -> Iterator[Flow]:
    """The motion from 0 to `end` in pieces; usually one."""
    rates, sizes, held, hint = problem.rates, problem.sizes, problem.held, problem.hint

    calls, before = 0, 0.0

    def right_hand_side(time: float, state: Floats) -> tuple[float, ...]:
        nonlocal calls, before
        calls += 1
        if calls % CALLS == 0:
            if abs(time - before) < STUCK * abs(end if hint else time):
                raise RigidtopError(
                    f"the integration stopped at t = {time:g} on the way to {end:g}: stuck{hint}"
                )
            before = time
        return rates(state.tolist())  # plain floats: several times faster than NumPy's

    if not np.all(np.isfinite(right_hand_side(0.0, problem.start))):
        raise RigidtopError("the rates overflow at the start: the velocities are too large")
    time, state, step, returns = 0.0, problem.start, None, 0
    while time != end:
        if held is not None:
            state = held(time, state)
        unit = sizes(state)

        def growth(_: float, state: Floats, unit: Floats = unit) -> float:
            return float(np.max(sizes(state) / unit)) - GROWTH

        def strays(time: float, state: Floats, unit: Floats = unit) -> float:
            assert held is not None
            tolerance = accuracy.atol * unit + accuracy.rtol * np.abs(state)
            return float(np.max(np.abs(held(time, state) - state) / tolerance)) - STRAYS

        events = [growth] if held is None else [growth, strays]
        for event in events:
            event.terminal = True  # type: ignore[attr-defined]
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", category=UserWarning, message="lsoda")
            solution = solve_ivp(
                right_hand_side,
                (time, end),
                state,
                method=cast(Method, accuracy.method),
                rtol=accuracy.rtol,
                atol=accuracy.atol * unit,
                dense_output=True,
                first_step=(step and min(step, abs(end - time))) or None,
                events=events,
            )
        time, state = float(solution.t[-1]), solution.y[:, -1]
        path = solution.sol
        if path is None or solution.status < 0 or not np.all(np.isfinite(state)):
            reached = f"t = {time:g} on the way to {end:g}"
            raise RigidtopError(f"the integration stopped at {reached}: {solution.message}{hint}")
        if held is not None:  # brought back, it goes on as it went
            step = float(np.max(np.abs(np.diff(solution.t))))
            returns = returns + 1 if len(solution.t) == 2 else 0
            if returns > MOST_RETURNS:
                raise RigidtopError(
                    f"the integration stopped at t = {time:g} on the way to {end:g}: the "
                    "constraints can't be kept"
                )
        yield Flow(path, solution.t)


def sides(times: Floats) -> Iterator[tuple[NDArray[np.intp], Floats]]:
    """`times` ≥ 0 and then those < 0, each with where they stood, increasing in magnitude."""
    for side in (times >= 0, times < 0):
        rows = np.flatnonzero(side)
        if len(rows):
            rows = rows[np.argsort(np.abs(times[rows]), kind="stable")]
            yield rows, times[rows]


def on_both_sides(
    flows: Flows, start: Floats, times: Floats, sample: Callable[[Flow, Floats], Floats]
) -> Floats:
    """`sample`, of the flows to the latest and to the earliest time, in the order of `times`.

    `sample` gives (n, N) for N times, which increase in magnitude from 0.
    """
    parts = []
    for rows, ordered in sides(times):
        end = float(ordered[-1])
        if end == 0:
            motion = Flow(lambda t: np.repeat(start[:, None], len(t), axis=1), np.zeros(1))
        else:
            motion = flows(end)
        parts.append((rows, sample(motion, ordered)))
    states = np.empty((len(parts[0][1]), len(times)))
    for rows, part in parts:
        states[:, rows] = part
    return states


def with_angles(
    motion: Flow, times: Floats, start: tuple[float, float], spin: Mapping[str, Floats]
) -> Floats:
    """The states (n, N) at `times`, and behind them φ and ψ, continuous along it from `start`.

    ψ is that in the frame of the state.  α and β, whose phases are half their sum and difference,
    are followed along the dense output with steps so short that neither can go round zero unseen,
    however far apart `times` are.  As long as one of them is exactly zero (a sleeping top) its
    phase advances at the rate that `state.spinning` calls upright, or backwards.
    """
    (phi, psi), upright = start, float(spin["upright_phi_dot"])
    starts = (phi + psi) / 2, (phi - psi) / 2
    fractions = np.arange(SUBSTEPS) / SUBSTEPS
    steps = motion.steps
    between = (steps[:-1, None] + np.diff(steps)[:, None] * fractions).ravel()
    nodes = np.unique(np.abs(np.concatenate([between, steps[-1:], times])))
    direction = -1.0 if times[-1] < 0 else 1.0
    nodes, z = _refined(lambda t: np.stack(spinors(motion.path(direction * t))), nodes)
    phases = [
        _unwrapped(*row, direction * nodes)
        for row in zip(z, starts, (-upright, upright), strict=True)
    ]
    half_sum, half_difference = np.stack(phases)[:, np.searchsorted(nodes, np.abs(times))]
    angles = [half_sum + half_difference, half_sum - half_difference]
    return np.concatenate([motion.path(times), angles])


def _refined(path: Callable[[Floats], Complexes], nodes: Floats) -> tuple[Floats, Complexes]:
    """More nodes, so that between neighbours α and β change by less than half of themselves."""
    z = path(nodes)
    for _ in range(BISECTIONS):
        size = np.abs(z)
        jumps = np.abs(np.diff(z)) > 0.5 * np.minimum(size[:, :-1], size[:, 1:])
        at = np.flatnonzero(jumps.any(axis=0))
        middle = (nodes[at] + nodes[at + 1]) / 2
        new = (middle > nodes[at]) & (middle < nodes[at + 1])
        if not new.any():
            break
        at, middle = at[new], middle[new]
        nodes = np.insert(nodes, at + 1, middle)
        z = np.insert(z, at + 1, path(middle), axis=1)
    return nodes, z


def _unwrapped(z: Complexes, start: float, idle: float, times: Floats) -> Floats:
    """The phase of z without jumps, from `start` at the first node, which is t = 0."""
    moving = np.flatnonzero(z)
    first = moving[0] if len(moving) else len(z)
    phase = start + idle * times
    if first == len(z):
        return phase
    # Later zeros are isolated: the phase stands still there.
    last_seen = np.maximum.accumulate(np.where(z != 0, np.arange(len(z)), first))[first:]
    angles = np.concatenate([[phase[max(first - 1, 0)]], np.angle(z[last_seen])])
    phase[first:] = np.unwrap(angles)[1:]
    return phase
