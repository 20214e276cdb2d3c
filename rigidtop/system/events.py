"""When quantities of a motion are zero."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from rigidtop.motion.attitude import Floats
from rigidtop.motion.integrate import Flow

LOOKS = 8
"""A step of the solver, or a part of it, is looked at so many times for an event."""


DEEPEST = 8
"""A step is halved so many times, where a quantity changes faster than what moves."""


NOISE = 1e-10
"""A quantity that goes less beyond zero, relative to its largest, is said to touch it only."""


PLACES = (1 - np.cos(np.arange(LOOKS + 1) * np.pi / LOOKS)) / 2
"""Where it is looked at, from 0 to 1: not evenly, which what is periodic could meet."""


BETWEEN = np.vander(PLACES[1::2], LOOKS // 2 + 1) @ np.linalg.inv(
    np.vander(PLACES[::2], LOOKS // 2 + 1)
)
"""Takes the values of a polynomial at every other of these places to those between them."""


FLOAT = float(np.finfo(float).eps)

GOLDEN = (np.sqrt(5) - 1) / 2

NARROWED = 45
"""So many golden sections leave 10⁻⁹ of an interval, below which a minimum is flat."""

MOST = 120
"""A bracket that is halved every third time is narrower than floats are apart after so many."""


@dataclass(frozen=True)
class Watched:
    """A quantity, of times (N,) and states (n, N), and the direction that counts, or 0."""

    value: Callable[[Floats, Floats], Floats]
    direction: int


@dataclass(frozen=True)
class Zeros:
    """Times (N,) at which a quantity is zero, states (n, N), and whether it increases there."""

    times: Floats
    states: Floats
    rising: NDArray[np.bool_]

    def only(self, chosen: NDArray[np.bool_]) -> Zeros:
        """The zeros for which `chosen` (N,) is true."""
        return Zeros(self.times[chosen], self.states[:, chosen], self.rising[chosen])

    def towards(self, direction: int) -> Zeros:
        """The zeros at which the quantity goes in a direction; all for 0."""
        return self.only(self.rising == (direction > 0)) if direction else self

    def within(self, first: float, last: float) -> Zeros:
        """The zeros from the first to the last of two times."""
        return self.only((self.times >= first) & (self.times <= last))


def joined_zeros(parts: Sequence[Zeros]) -> Zeros:
    """All of them, in the order of their times."""
    times = np.concatenate([part.times for part in parts])
    states = np.concatenate([part.states for part in parts], axis=1)
    order = np.argsort(times)
    rising = np.concatenate([part.rising for part in parts])
    return Zeros(times[order], states[:, order], rising[order])


def zeros(motion: Flow, value: Callable[[Floats, Floats], Floats], end: float) -> Zeros:
    """Where a quantity goes through zero until `end`, t = 0 left out."""

    def of(times: Floats) -> Floats:
        return value(times, motion.path(times)) if len(times) else times

    times, values = _dips(of, *_looks(of, motion.steps))
    before, after = values[:-1], values[1:]
    through = before * after < 0
    roots = _between(of, times[:-1][through], times[1:][through], before[through], after[through])
    # At a pole the sign changes too.
    small = np.abs(of(roots)) <= np.maximum(np.abs(before), np.abs(after))[through]
    hit = (after == 0) & (before != 0)
    at = np.concatenate([roots[small], times[1:][hit]])
    earlier = np.concatenate([before[through][small], before[hit]])
    chosen = np.abs(at) <= abs(end)
    at, earlier = at[chosen], earlier[chosen]
    states = motion.path(at) if len(at) else np.empty((len(motion.path(motion.steps[:1])), 0))
    return Zeros(at, states, (earlier < 0) == (end > 0))


def _looks(of: Callable[[Floats], Floats], steps: Floats) -> tuple[Floats, Floats]:
    """Times and values, so dense that every other value follows from the rest."""
    times, values = [steps[:1]], [of(steps[:1])]
    starts, ends = steps[:-1], steps[1:]
    for depth in range(DEEPEST, -1, -1):
        at = starts[:, None] + (ends - starts)[:, None] * PLACES
        at[:, -1] = ends
        samples = of(at.ravel()).reshape(at.shape)
        missed = np.abs(samples[:, ::2] @ BETWEEN.T - samples[:, 1::2]).max(axis=1, initial=0.0)
        enough = 0.05 * np.ptp(samples, axis=1), 1e-12 * np.abs(samples).max(axis=1)
        dense = (missed <= np.maximum(*enough)) | (depth == 0)
        times.append(at[dense, 1:].ravel())
        values.append(samples[dense, 1:].ravel())
        starts, ends = starts[~dense], ends[~dense]
        if not len(starts):
            break
        middle = (starts + ends) / 2
        starts, ends = np.append(starts, middle), np.append(middle, ends)
    t, x = np.concatenate(times), np.concatenate(values)
    order = np.argsort(np.abs(t))
    return t[order], x[order]


def _dips(of: Callable[[Floats], Floats], t: Floats, x: Floats) -> tuple[Floats, Floats]:
    """Times and values, with those between at which it may go through zero and back.

    Between two zeros near each other, of three values with one sign the middle one is the least.
    """
    size, sign = np.abs(x), np.sign(x)
    same = (sign[1:-1] == sign[:-2]) & (sign[1:-1] == sign[2:])
    # What is smooth goes no deeper than it rises on both sides.
    near = size[1:-1] <= np.abs(np.diff(x))[1:] + np.abs(np.diff(x))[:-1]
    k = np.flatnonzero((size[1:-1] < size[:-2]) & (size[1:-1] < size[2:]) & same & near) + 1
    left, right, signs = t[k - 1], t[k + 1], sign[k]
    for _ in range(NARROWED if len(k) else 0):
        inner = right - GOLDEN * (right - left), left + GOLDEN * (right - left)
        first, second = (signs * of(at) for at in inner)
        lower = first < second
        left, right = np.where(lower, left, inner[0]), np.where(lower, inner[1], right)
    least = (left + right) / 2
    depth = of(least)
    deep = signs * depth < -NOISE * size.max()
    t, x = np.append(t, least[deep]), np.append(x, depth[deep])
    order = np.argsort(np.abs(t))
    return t[order], x[order]


def _between(
    of: Callable[[Floats], Floats], a: Floats, b: Floats, before: Floats, after: Floats
) -> Floats:
    """The zeros within brackets, at whose ends the signs differ: false position, and halves."""
    a, b, before, after, best = a.copy(), b.copy(), before.copy(), after.copy(), b.copy()
    left = np.arange(len(a))
    for k in range(MOST):
        if not len(left):
            break
        x, y, lower, upper = a[left], b[left], before[left], after[left]
        new = (x + y) / 2 if k % 3 == 2 else (x * upper - y * lower) / (upper - lower)
        value = of(new)
        moved = np.abs(new - best[left])
        best[left] = new
        crossed = value * upper < 0
        # The end that stays counts half, so that it does not stay for ever (Illinois).
        a[left] = np.where(crossed, y, x)
        before[left] = np.where(crossed, upper, lower / 2)
        b[left], after[left] = new, value
        narrow = 1e-14 + 4 * FLOAT * np.abs(new)
        left = left[(value != 0) & (moved > narrow) & (np.abs(b[left] - a[left]) > narrow)]
    return best
