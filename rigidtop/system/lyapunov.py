"""The largest Lyapunov exponent of a motion, by its variational equations."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from rigidtop.errors import RigidtopError
from rigidtop.motion import checks, taylor
from rigidtop.motion.attitude import Floats
from rigidtop.motion.integrate import Accuracy, Flow, InitialValueProblem, flow
from rigidtop.motion.rows import Rows
from rigidtop.system.numeric import Computed, computed
from rigidtop.system.start import sizes

ROWS = 500
"""So many times show how an exponent converges."""

BLOCKS = 10
"""The mean error of an exponent is that of its values in so many parts of the time."""


@dataclass(frozen=True, eq=False, repr=False)
class LyapunovExponent(Rows):
    """How fast neighbours of a motion go apart, and how that converges: a row for each time."""

    t: Floats
    """Times, shape (N,), in s."""

    growth: Floats
    """The logarithm of the distance of a near neighbour over that at t = 0, shape (N,)."""

    def __repr__(self) -> str:
        return f"<LyapunovExponent: {self.value:.4g} ± {self.error:.2g}>"

    @property
    def converging(self) -> Floats:
        """The exponent up to each time, shape (N,), in 1/s."""
        return self.growth / self.t

    @property
    def value(self) -> float:
        """The exponent over the whole time, in 1/s."""
        return float(self.converging[-1])

    @property
    def error(self) -> float:
        """An estimate of its error, in 1/s.

        The larger of the mean error, from the scatter between ten parts of the time, and of the
        range in which the exponent is during the second half.  Of a regular motion the exponent
        goes to zero as ln t / t: one within three errors of zero does not show chaos.
        """
        length = len(self.t) // BLOCKS
        ends = self.growth[length - 1 :: length]
        parts = np.diff(ends, prepend=0.0) / self.t[length - 1]
        change = np.ptp(self.converging[len(self.t) // 2 - 1 :])
        return float(max(parts.std(ddof=1) / np.sqrt(BLOCKS), change))

    def columns(self) -> dict[str, Floats]:
        """t, and the exponent up to there."""
        return {"t/s": self.t, "exponent/(1/s)": self.converging}


def lyapunov(
    system: Computed,
    parameters: Sequence[float],
    start: Sequence[float],
    t: float,
    how: Accuracy,
    check: Callable[[Floats], None],
) -> LyapunovExponent:
    """See `SystemMotion.lyapunov`; `start` is (q, q̇), and `check` raises for states it refuses."""
    end, n = checks.number("t", t), len(system.q)
    if end <= 0:
        raise RigidtopError(f"an exponent is that of a time t > 0, not {end:g}")
    if system.constraints:
        raise RigidtopError("an exponent wants independent coordinates: put the constraints into L")
    numeric = system.numeric
    first, rate = beginning(system, parameters, start)
    values = [*parameters, rate]
    own = sizes(system, first[: 2 * n])

    def rates(state: Sequence[float]) -> tuple[float, ...]:
        row = (state[-1] if numeric.timed else 0.0, *state[: 4 * n], *values)
        slopes, why = computed(lambda row: numeric.variation.scalar(*row), row)
        if why:
            raise RigidtopError(f"the variational equations can't be computed: {why}")
        return (*slopes, 1.0) if numeric.timed else tuple(slopes)

    def units(state: Floats) -> Floats:
        return np.concatenate([sizes(system, state[: 2 * n]), np.ones(len(state) - 2 * n)])

    def series(end: float, rtol: float) -> Flow:
        unit = own[[0, n]]
        with numeric.varied(rtol) as integrator:
            integrator.pars[:] = [*unit, *(1 / unit), *values][: len(integrator.pars)]
            integrator.state[:] = first / units(first)
            return taylor.propagated(integrator, end, units(first))

    rates(first.tolist())
    with np.errstate(all="ignore"):
        motion = flow(InitialValueProblem(rates, first, units, series), end, how)
    check(motion.path(motion.steps))
    times = np.linspace(0.0, end, ROWS + 1)[1:]
    return LyapunovExponent(times, motion.path(times)[4 * n])


def beginning(
    system: Computed, parameters: Sequence[float], start: Sequence[float]
) -> tuple[Floats, float]:
    """The state with a direction that no symmetry has, and a rate of the motion, in 1/s."""
    n = len(system.q)
    away = np.random.default_rng(0).normal(size=2 * n)
    moved = system.numeric.solved.scalar(0.0, *start, *parameters)[:n]
    q, v, a = (float(np.max(np.abs(x))) for x in (start[:n], start[n:], moved))
    rates = [upper / lower for upper, lower in ((v, q), (a, v)) if upper > 0 and lower > 0]
    more = [0.0] * (1 + int(system.numeric.timed))
    return np.array([*start, *(away / np.linalg.norm(away)), *more]), max(rates, default=1.0)
