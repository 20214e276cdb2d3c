"""Many motions at once by DOP853, on arrays of NumPy; each has steps of its own.

The coefficients are those of `scipy.integrate.DOP853`, and steps are chosen as it chooses them: a
motion is as accurate as it is alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import count

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import DOP853

from rigidtop.motion.attitude import Floats
from rigidtop.motion.integrate import GROWTH, Accuracy

Which = NDArray[np.intp]

SAFETY, LEAST, MOST = 0.9, 0.2, 10.0
"""A step is so much of the best one, and at least and at most so many times the last."""

POWER = -1 / (DOP853.error_estimator_order + 1)


@dataclass(frozen=True)
class InitialValueProblems:
    """What the solver has to know of L motions with n components."""

    rates: Callable[[Floats, Which], Floats]
    """States (n, L), and which motions they are of (L,), in; their rates (n, L) out."""

    sizes: Callable[[Floats], Floats]
    """States (n, L) in; what absolute tolerances are fractions of (n, L) out."""

    allowed: Callable[[Floats], NDArray[np.bool_]]
    """Of states (n, L), to which of them a motion may come (L,)."""


def states(
    problems: InitialValueProblems, start: Floats, times: Floats, accuracy: Accuracy
) -> Floats:
    """The motions from states (n, L) at t = 0, at N `times` that increase in magnitude: (N, n, L).

    NaN for motions that do not arrive.
    """
    samples = np.full((len(times), *start.shape), np.nan)
    backwards, ends = times[-1] < 0, np.abs(times)
    samples[ends == 0] = start
    if ends[-1] > 0:
        with np.errstate(all="ignore"):
            for step in _steps(problems, start, -1.0 if backwards else 1.0, ends[-1], accuracy):
                _sample(step, ends, samples)
    return samples


@dataclass(frozen=True)
class _Step:
    """One step of the motions `which`, from `before` to `after` (K,) with `stages` (16, n, K)."""

    rates: Callable[[Floats, Which], Floats]
    which: Which
    before: Floats
    after: Floats
    states: tuple[Floats, Floats]
    stages: Floats

    def taken(self, rows: Which | NDArray[np.bool_]) -> _Step:
        """The step for some of its motions."""
        old, new = self.states
        at = self.which[rows], self.before[rows], self.after[rows]
        return _Step(self.rates, *at, (old[:, rows], new[:, rows]), self.stages[..., rows])

    def polynomial(self) -> Floats:
        """Coefficients (7, n, K) of what lies between, as SciPy has them."""
        h, (old, new), first = self.after - self.before, self.states, DOP853.n_stages + 1
        stages = np.concatenate([self.stages, np.empty((3, *old.shape))])
        for k, row in enumerate(DOP853.A_EXTRA, first):
            stages[k] = self.rates(old + h * _sum(row[:k], stages[:k]), self.which)
        change, slope = new - old, h * stages[0]
        last = h * stages[DOP853.n_stages]
        ends = np.stack([change, slope - change, 2 * change - slope - last])
        return np.concatenate([ends, h * np.tensordot(DOP853.D, stages, 1)])


def _sample(step: _Step, ends: Floats, samples: Floats) -> None:
    """Fill in what was asked for within a step."""
    first, last = (np.searchsorted(ends, at, "right") for at in (step.before, step.after))
    step = step.taken(last > first)
    first, last = first[last > first], last[last > first]
    if not len(first):
        return
    coefficients, (old, _) = step.polynomial(), step.states
    for k in count():
        rows = np.flatnonzero(first + k < last)
        if not len(rows):
            return
        place = first[rows] + k
        x = (ends[place] - step.before[rows]) / (step.after - step.before)[rows]
        value = np.zeros((len(old), len(rows)))
        for power, each in enumerate(coefficients[::-1]):
            value = (value + each[:, rows]) * (1 - x if power % 2 else x)
        samples[place, :, step.which[rows]] = (old[:, rows] + value).T


def _steps(
    problems: InitialValueProblems, start: Floats, sign: float, end: float, accuracy: Accuracy
) -> Iterator[_Step]:
    """The steps of all from 0 to `end`, time running as `sign` says; of who is lost no more."""

    def rates(states: Floats, which: Which) -> Floats:
        return sign * problems.rates(states, which)

    y, which, t = start, np.arange(start.shape[1]), np.zeros(start.shape[1])
    unit, rate = problems.sizes(y), rates(y, which)
    h = _first(rates, y, rate, end, accuracy.rtol, accuracy.atol * unit)
    most = np.full(len(t), MOST)  # right after a step that was too long none is longer
    while len(which):
        h = np.minimum(h, end - t)
        new, stages = _stages(rates, y, rate, h, which)
        scale = accuracy.atol * unit + accuracy.rtol * np.maximum(np.abs(y), np.abs(new))
        error = np.where(problems.allowed(new), _error(stages, h, scale), np.nan)
        good = error < 1
        if good.any():
            after = np.where(h == end - t, end, t + h)
            whole = _Step(rates, which, t, after, (y, new), stages)
            yield whole if good.all() else whole.taken(good)
            t, y = np.where(good, after, t), np.where(good, new, y)
            rate = np.where(good, stages[-1], rate)
        # What has grown has a larger tolerance from now on.
        sizes = problems.sizes(y)
        unit = np.where((sizes / unit).max(axis=0) > GROWTH, sizes, unit)
        h = h * np.clip(SAFETY * np.maximum(error, 1e-300) ** POWER, LEAST, most)
        most = np.where(good, MOST, 1.0)
        going = np.isfinite(error) & (t < end) & (h > 10 * np.spacing(t))
        if not going.all():
            which, t, h, most = which[going], t[going], h[going], most[going]
            y, rate, unit = y[:, going], rate[:, going], unit[:, going]


def _stages(
    rates: Callable[[Floats, Which], Floats], y: Floats, rate: Floats, h: Floats, which: Which
) -> tuple[Floats, Floats]:
    """Where a step leads to, and the rates on the way, there last."""
    stages = np.empty((DOP853.n_stages + 1, *y.shape))
    stages[0] = rate
    for k in range(1, DOP853.n_stages):
        stages[k] = rates(y + h * _sum(DOP853.A[k, :k], stages[:k]), which)
    new = y + h * _sum(DOP853.B, stages[:-1])
    stages[-1] = rates(new, which)
    return new, stages


def _sum(weights: Floats, stages: Floats) -> Floats:
    total: Floats = np.tensordot(weights, stages, 1)
    return total


def _error(stages: Floats, h: Floats, scale: Floats) -> Floats:
    """The error of a step over what is allowed."""
    fifth, third = (
        np.square(_sum(weights, stages) / scale).sum(axis=0) for weights in (DOP853.E5, DOP853.E3)
    )
    error: Floats = h * fifth / np.sqrt(np.maximum(fifth + 0.01 * third, 1e-300) * len(scale))
    return error


def _first(
    rates: Callable[[Floats, Which], Floats],
    y: Floats,
    rate: Floats,
    end: float,
    rtol: float,
    atol: Floats,
) -> Floats:
    """First steps (Hairer, Nørsett and Wanner, II.4)."""
    scale = atol + np.abs(y) * rtol

    def size(x: Floats) -> Floats:
        norm: Floats = np.sqrt(np.square(x / scale).mean(axis=0))
        return norm

    of_state, of_rate = size(y), size(rate)
    small = (of_state < 1e-5) | (of_rate < 1e-5)
    h = np.minimum(np.where(small, 1e-6, 0.01 * of_state / of_rate), end)
    bend = size(rates(y + h * rate, np.arange(len(h))) - rate) / h
    largest = np.maximum(of_rate, bend)
    better = np.where(largest <= 1e-15, np.maximum(1e-6, h * 1e-3), (0.01 / largest) ** -POWER)
    first: Floats = np.minimum(np.minimum(100 * h, better), end)
    return first
