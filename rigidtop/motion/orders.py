"""The observed order of each integrator, from runs with steps of one size.

Steps are halved and the states compared with the closed form.  `solve_ivp` takes steps of one size
if `first_step` and `max_step` are that size and its tolerance lets every step pass, which is seen
from their number.  Steps are powers of two, so that sums of them are exact.

It is quaternions that are compared, not attitudes: in a fast spin the leading error of an odd order
changes the norm of the quaternion alone, and the attitude would show the order above.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal

import numpy as np
from scipy.integrate import solve_ivp

from rigidtop.errors import RigidtopError
from rigidtop.motion import attitude as attitudes
from rigidtop.motion import equations
from rigidtop.motion.attitude import Floats
from rigidtop.motion.motion import Motion

Fixed = Literal["RK23", "RK45", "DOP853", "Radau"]

CLASSICAL: Mapping[Fixed, int] = MappingProxyType({"RK23": 3, "RK45": 5, "DOP853": 8, "Radau": 5})
"""The order that the theory of each gives."""

IMPLICIT = ("Radau",)

LEFT_OUT: Mapping[str, str] = MappingProxyType(
    {
        "BDF": "its order changes as it goes, from 1 to 5",
        "LSODA": "its order changes as it goes, from 1 to 12",
        "taylor": "its order follows from the tolerance",
    }
)
"""Why the others have no order to observe."""

LENGTH = 32
"""Of a run, in units of the power of two below the time in which the motion turns by a radian."""

MOST_STEPS = 1024
"""Steps of a run, after which no more halving is tried."""

LARGEST_ERROR = 0.01
"""Above, the error is not yet its leading term (rad)."""

SMALLEST_ERROR, SMALLEST_IMPLICIT = 5e-13, 1e-8
"""Below, it is rounding, or how far an implicit method solves its equations (rad)."""

LOOSE = 1e9
"""An absolute tolerance that lets every step pass."""

FACTOR = 4.0
"""Tolerances of an implicit method are tried from 1 down by this: it solves its equations to a
fraction of them."""


@dataclass(frozen=True)
class Order:
    """How the error of an integrator falls with its step."""

    method: str

    classical: int
    """What theory says."""

    observed: float
    """The slope of log error against log step between the two smallest steps that errors allow."""

    steps: tuple[int, ...]
    """Numbers of steps in the two runs that were compared, the second twice the first."""

    errors: tuple[float, ...]
    """The largest error of each (rad)."""


def orders(motion: Motion) -> tuple[tuple[Order, ...], dict[str, str]]:
    """The order of every integrator that has one, and for those without a measurement the reason.

    >>> from rigidtop import FreeBody
    >>> measured, _ = orders(FreeBody(1.0, 2.0, 2.5).motion(omega=(1.0, 0.5, 0.2)))
    >>> [(order.method, round(order.observed)) for order in measured]
    [('RK23', 3), ('RK45', 5), ('DOP853', 8), ('Radau', 5)]
    """
    measured, reasons = [], {}
    for method in CLASSICAL:
        try:
            measured.append(order(motion, method))
        except RigidtopError as reason:
            reasons[f"order of {method}"] = str(reason)
    return tuple(measured), reasons


def order(motion: Motion, method: Fixed) -> Order:
    """The observed order of one integrator on the quaternion and ω of a motion.

    RigidtopError where there is no closed form, or nothing to see.
    """
    if motion.rate == 0:
        raise RigidtopError("nothing moves")
    unit = 2.0 ** math.floor(-math.log2(motion.rate))
    smallest = SMALLEST_IMPLICIT if method in IMPLICIT else SMALLEST_ERROR
    counts: list[int] = []
    errors: list[float] = []
    steps = LENGTH // 2
    while steps <= MOST_STEPS:
        error = _error(motion, method, unit * LENGTH, steps)
        if error < smallest:
            break
        if error < LARGEST_ERROR:
            counts, errors = [*counts[-1:], steps], [*errors[-1:], error]
        steps *= 2
    if len(counts) < 2:
        raise RigidtopError("too few of its errors lie between the coarsest step and rounding")
    observed = math.log2(errors[0] / errors[1])
    return Order(method, CLASSICAL[method], observed, tuple(counts), tuple(errors))


def _error(motion: Motion, method: Fixed, end: float, steps: int) -> float:
    """Twice the largest distance between quaternions: where norms agree, an angle (rad)."""
    times, states = _run(motion, method, end, steps)
    every = slice(None, None, max(steps // LENGTH, 1))
    exact = attitudes.quaternions(motion.exact(times[every]).rotation)
    found = states[:4, every].T
    exact = exact * np.sign(np.sum(exact * found, axis=1))[:, None]  # q and −q are one attitude
    error = float(2 * np.max(np.linalg.norm(found - exact, axis=1)))
    return error if math.isfinite(error) else math.inf


def _run(motion: Motion, method: Fixed, end: float, steps: int) -> tuple[Floats, Floats]:
    """Times (N + 1,) and states (7, N + 1) of N steps of one size."""
    if method not in IMPLICIT:
        found = _attempt(motion, method, end, steps, LOOSE)
    else:
        tolerance, found = 1.0, None
        while (tighter := _attempt(motion, method, end, steps, tolerance)) is not None:
            found, tolerance = tighter, tolerance / FACTOR
    if found is None:
        raise RigidtopError("the solver takes steps of its own")
    return found


def _attempt(
    motion: Motion, method: Fixed, end: float, steps: int, tolerance: float
) -> tuple[Floats, Floats] | None:
    """None where not every step passes."""
    rates = equations.heavy_body(*motion.body.moments, 1.0, 1.0, *motion.body.weight)
    start = np.concatenate([attitudes.quaternions(motion.attitude), motion.omega])
    step = end / steps
    solution = solve_ivp(
        lambda _, state: rates(state.tolist()),
        (0.0, end),
        start,
        method=method,
        first_step=step,
        max_step=step,
        rtol=1e-10,
        # An error of ω counts by what it turns in a step.
        atol=tolerance * np.repeat([1.0, 1.0 / step], [4, 3]),
    )
    passed = solution.success and len(solution.t) == steps + 1
    return (solution.t, solution.y) if passed else None
