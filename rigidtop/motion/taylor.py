"""Motions by Taylor series, compiled: needs heyoka, which is loaded at the first use.

A step expands the motion in powers of time, to an order that the tolerance sets (20 for the
smallest), with coefficients by recurrence from the shipped equations; what comes out is exact to
rounding, and dense.  Parameters of the body are parameters of the compiled code, and heyoka keeps
what it has compiled: one compilation for each tolerance serves all motions of a process.

Time is measured in units near the inverse of `ShippedEquations.rate`, so that a slow motion is
integrated like a fast one: those units are powers of two, and cost no digit.  Solvers of Taylor
series choose their steps by an error relative to the largest component; no step is longer than the
unit, because for such steps the series of what is small, which is linear, converges as fast as the
order allows.  A motion near the vertical is thus as accurate, relative to itself, as a large one.
(heyoka itself loads SymPy where that is installed; nothing here does.)
"""

from __future__ import annotations

import importlib
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np

from rigidtop.errors import RigidtopError
from rigidtop.motion.attitude import Floats
from rigidtop.motion.integrate import Flow, Held, joined
from rigidtop.motion.systems import SMALLEST_SIZE, ShippedEquations

STEPS_AT_ONCE = 20_000
"""Between so many steps, some milliseconds, an interrupt from the keyboard is heard."""

STEPS_HELD = 20
"""After so many steps the constraints are put right, where there are some."""

STEPS_KEPT = 1_000
"""Of so many steps the powers of time are kept here: heyoka compiles each dense output anew."""

MOST_STEPS = 10_000_000
"""No Taylor series takes more steps: it would fill the memory."""


def flow(
    system: ShippedEquations, parameters: Sequence[float], start: Floats, end: float, rtol: float
) -> Flow:
    """Integrate from t = 0 to `end` (s), which may be negative.

    Raises RigidtopError without heyoka, and where the motion overflows.
    """
    heyoka = loaded()
    rate = max(float(system.rate(parameters, start)), SMALLEST_SIZE)
    if not math.isfinite(rate):
        raise RigidtopError("the rates overflow at the start: the velocities are too large")
    unit = 2.0 ** math.floor(math.log2(rate))
    # By what states and parameters are divided when 1/unit is the unit of time.
    of_state = np.array([1.0] * 4 + [unit] * (len(start) - 4))
    of_parameters = np.array([unit**power for power in system.per_time])
    # The shipped equations, run on heyoka's symbols.
    state = heyoka.make_vars(*(f"x{k}" for k in range(len(start))))
    right = system.equations(*(heyoka.par[k] for k in range(len(parameters))))(state)
    integrator = heyoka.taylor_adaptive(
        list(zip(state, right, strict=True)),
        start / of_state,
        pars=parameters / of_parameters,
        tol=rtol,
    )
    return propagated(integrator, end, of_state, unit, unit / rate)


def propagated(
    integrator: Any,
    end: float,
    of_state: Floats,
    unit: float = 1.0,
    max_delta_t: float = math.inf,
    held: Held | None = None,
) -> Flow:
    """The flow of one of heyoka's integrators, from t = 0 to `end` (s).

    Its state is in `of_state`s, its time and `max_delta_t` are in 1/`unit`.  Where it is `held` the
    motion is brought back time and again.
    """
    pieces: list[Flow] = []
    at_once = STEPS_AT_ONCE if held is None else STEPS_HELD
    while not pieces or integrator.time != end * unit:
        if held is not None:
            state = held(integrator.time / unit, integrator.state * of_state)
            integrator.state[:] = state / of_state
        few = held is not None or not pieces
        run, steps = (_kept, min(STEPS_KEPT, at_once)) if few else (_compiled, at_once)
        outcome, series = run(integrator, end * unit, max_delta_t, steps)
        _check(outcome, float(integrator.time / unit), end, integrator.state)
        if len(pieces) * at_once > MOST_STEPS:
            raise RigidtopError(f"more than {MOST_STEPS} steps on the way to {end:g}")
        path = partial(_path, series, unit, of_state)
        pieces.append(Flow(path, np.asarray(series.times) / unit))
    return joined(pieces)


@dataclass(frozen=True)
class Expansions:
    """The state (n,) as powers of time within each step, as heyoka's dense output has it."""

    times: Floats
    """Where the steps begin, and where the last ends, shape (steps + 1,)."""

    powers: Floats
    """Their coefficients, shape (steps, n, order + 1)."""

    def __call__(self, at: Floats) -> Floats:
        """The states (N, n) at times (N,)."""
        step = np.searchsorted(np.abs(self.times[1:-1]), np.abs(at))
        since, states = (at - self.times[step])[:, None], np.zeros(1)
        for power in range(self.powers.shape[-1] - 1, -1, -1):
            states = states * since + self.powers[step, :, power]
        return states


def _kept(integrator: Any, end: float, longest: float, steps: int) -> tuple[object, Expansions]:
    """What came of some steps, and the motion within them."""
    times, rows, powers = [integrator.time], [], integrator.tc  # changes from step to step

    def keep(integrator: Any) -> bool:
        times.append(integrator.time)
        rows.append(powers.tobytes())
        return True

    outcome, *_ = integrator.propagate_until(
        end, max_delta_t=longest, max_steps=steps, write_tc=True, callback=keep
    )
    kept = np.frombuffer(b"".join(rows)).reshape(len(rows), *powers.shape)
    return outcome, Expansions(np.array(times), kept)


def _compiled(integrator: Any, end: float, longest: float, steps: int) -> tuple[object, Any]:
    """The outcome and the compiled series, for evaluation at many times."""
    outcome, *_, series, _ = integrator.propagate_until(
        end, max_delta_t=longest, max_steps=steps, c_output=True
    )
    return outcome, series


def batch() -> int:
    """The number of motions at once that suits the processor."""
    return int(loaded().recommended_simd_size())


def sampled(integrator: Any, start: Floats, parameters: Floats, times: Floats) -> Floats:
    """Motions from states (n, L) at t = 0, at N `times` that increase in magnitude: (N, n, L).

    By an integrator of batches; those behind the last of its `parameters` (p, L) do not matter to
    it.  NaN for motions that do not arrive.
    """
    grid, places = np.unique(np.abs(np.append(0.0, times)), return_inverse=True)
    size, count = integrator.batch_size, start.shape[1]
    at = np.repeat(np.copysign(grid, times[-1])[:, None], size, axis=1)
    samples = np.empty((len(grid), *start.shape))
    for first in range(0, count, size):
        last = min(first + size, count)
        full = np.resize(np.arange(first, last), size)  # the last batch has some motions twice
        integrator.set_time(0.0)
        integrator.state[:] = start[:, full]
        integrator.pars[:] = parameters[: len(integrator.pars), full]
        _, states = integrator.propagate_grid(at, max_steps=MOST_STEPS)
        samples[..., first:last] = states[..., : last - first]
    later: Floats = samples[places[1:]]
    return later


def _path(
    series: Callable[[Floats], Floats], unit: float, of_state: Floats, times: Floats
) -> Floats:
    return np.ascontiguousarray((series(times * unit) * of_state).T)


def loaded() -> Any:
    """heyoka.  Raises RigidtopError where it is not installed."""
    try:
        return importlib.import_module("heyoka")
    except ImportError:
        raise RigidtopError(
            "method 'taylor' needs heyoka: pip install 'rigidtop[taylor]' (wheels for Linux only)"
        ) from None


def _check(outcome: object, reached: float, end: float, states: Floats) -> None:
    outcomes = loaded().taylor_outcome
    arrived = outcomes.time_limit, outcomes.step_limit
    if outcome not in arrived or not np.all(np.isfinite(states)):
        raise RigidtopError(
            f"the integration stopped at t = {reached:g} on the way to {end:g}: "
            "the Taylor series overflows"
        )
