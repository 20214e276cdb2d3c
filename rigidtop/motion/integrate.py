"""Motions by `scipy.integrate.solve_ivp`, in quaternions: no attitude is a special place.

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
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Literal, cast, get_args

import numpy as np
from scipy.integrate import solve_ivp

from rigidtop.errors import RigidtopError
from rigidtop.motion import checks
from rigidtop.motion.attitude import Complexes, Floats, spinors
from rigidtop.motion.equations import Rates

Method = Literal["DOP853", "RK45", "RK23", "Radau", "BDF", "LSODA"]
METHODS = get_args(Method)

SMALLEST_RTOL = 2.3e-14
"""`solve_ivp` warns below this, a hundred times the rounding of floats, and does not go lower."""

LARGEST_TOLERANCE = 0.1
"""A step that is wrong by more than this, in a unit quaternion, is no approximation."""

GROWTH = 100.0
"""Absolute tolerances are set anew when what they are measured against has grown so much."""

SUBSTEPS = 8
"""A step of the solver is looked at this many times when turns are counted."""

BISECTIONS = 40
"""Near a pole the steps are halved up to so many times: 2⁻⁴⁰ is below the error of a motion."""


@dataclass(frozen=True)
class Accuracy:
    """How `solve_ivp` is to work."""

    method: str = "DOP853"
    rtol: float = 1e-10
    atol: float = 1e-12

    def __post_init__(self) -> None:
        if self.method not in METHODS:
            raise RigidtopError(f"unknown method {self.method!r}: {', '.join(METHODS)}")
        if checks.number("rtol", self.rtol) < SMALLEST_RTOL:
            raise RigidtopError(f"rtol must be at least {SMALLEST_RTOL:g}, not {self.rtol:g}")
        checks.positive("atol", self.atol)
        for name, value in (("rtol", self.rtol), ("atol", self.atol)):
            if value > LARGEST_TOLERANCE:
                raise RigidtopError(f"{name} must be at most {LARGEST_TOLERANCE:g}, not {value:g}")


Sizes = Callable[[Floats], Floats]
"""A state (n,) in, what multiplies `atol` for each component (n,) out, none of them zero."""

Path = Callable[[Floats], Floats]
"""Times (N,) in, states (n, N) out."""


@dataclass(frozen=True)
class Flow:
    """The motion on one side of t = 0: its `path`, and the times at which the solver stopped."""

    path: Path
    steps: Floats


def flow(rates: Rates, start: Floats, end: float, accuracy: Accuracy, sizes: Sizes) -> Flow:
    """Integrate ẋ = rates(x) from t = 0 to `end`, which may be negative.

    Raises RigidtopError with the solver's message when it does not arrive.
    """
    stages = list(_stages(rates, start, end, accuracy, sizes))
    # Where each stage but the last hands over to the next.
    breaks = np.abs([steps[-1] for _, steps in stages[:-1]])

    def path(times: Floats) -> Floats:
        stage = np.searchsorted(breaks, np.abs(times))
        states = np.empty((len(start), len(times)))
        for k in np.unique(stage):
            states[:, stage == k] = stages[k][0](times[stage == k])
        return states

    return Flow(path, np.concatenate([np.zeros(1), *(steps[1:] for _, steps in stages)]))


def _stages(
    rates: Rates, start: Floats, end: float, accuracy: Accuracy, sizes: Sizes
) -> Iterator[tuple[Path, Floats]]:
    """The motion from 0 to `end` as paths, each with the times of its steps; usually one."""

    def right_hand_side(_: float, state: Floats) -> tuple[float, ...]:
        return rates(state.tolist())  # plain floats: several times faster than NumPy's

    if not np.all(np.isfinite(right_hand_side(0.0, start))):
        raise RigidtopError("the rates overflow at the start: the velocities are too large")
    time, state = 0.0, start
    while time != end:
        unit = sizes(state)

        def growth(_: float, state: Floats, unit: Floats = unit) -> float:
            return float(np.max(sizes(state) / unit)) - GROWTH

        growth.terminal = True  # type: ignore[attr-defined]
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
                events=growth,
            )
        time, state = float(solution.t[-1]), solution.y[:, -1]
        path = solution.sol
        if path is None or solution.status < 0 or not np.all(np.isfinite(state)):
            reached = f"t = {time:g} on the way to {end:g}"
            raise RigidtopError(f"the integration stopped at {reached}: {solution.message}")
        yield path, solution.t


def on_both_sides(
    rates: Rates,
    start: Floats,
    times: Floats,
    accuracy: Accuracy,
    sizes: Sizes,
    sample: Callable[[Flow, Floats], Floats],
) -> Floats:
    """`sample`, of the flows to the latest and to the earliest time, in the order of `times`.

    `sample` gives (n, N) for N times, which increase in magnitude from 0.
    """
    rows: Floats | None = None
    for side in (times >= 0, times < 0):
        if not side.any():
            continue
        order = np.argsort(np.abs(times[side]), kind="stable")
        ordered = times[side][order]
        end = float(ordered[-1])
        if end == 0:
            motion = Flow(lambda t: np.repeat(start[:, None], len(t), axis=1), np.zeros(1))
        else:
            motion = flow(rates, start, end, accuracy, sizes)
        values = sample(motion, ordered)
        if rows is None:
            rows = np.empty((len(values), len(times)))
        rows[:, np.flatnonzero(side)[order]] = values
    assert rows is not None  # times is not empty
    return rows


def counted_phases(
    motion: Flow, times: Floats, start: tuple[float, float], idle: tuple[float, float]
) -> Floats:
    """The phases of α and β at `times`, continuous along the motion from `start` (2, N).

    α and β are followed along the dense output with steps so short that neither can go round zero
    unseen, however far apart `times` are.  As long as one of them is exactly zero (a sleeping top)
    its phase advances at the rate `idle`.
    """
    fractions = np.arange(SUBSTEPS) / SUBSTEPS
    steps = motion.steps
    between = (steps[:-1, None] + np.diff(steps)[:, None] * fractions).ravel()
    nodes = np.unique(np.abs(np.concatenate([between, steps[-1:], times])))
    direction = -1.0 if times[-1] < 0 else 1.0
    nodes, z = _refined(lambda t: np.stack(spinors(motion.path(direction * t))), nodes)
    phases = [_unwrapped(*row, direction * nodes) for row in zip(z, start, idle, strict=True)]
    return np.stack(phases)[:, np.searchsorted(nodes, np.abs(times))]


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
