"""When a quantity of a motion is zero."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import pairwise

import numpy as np
from scipy.optimize import brentq, minimize_scalar

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


def zeros(motion: Flow, value: Callable[[float, Floats], float], end: float) -> list[float]:
    """The times at which a quantity goes through zero, t = 0 left out."""

    def of(times: Floats) -> Floats:
        states = motion.path(times).T
        return np.array([value(float(t), state) for t, state in zip(times, states, strict=True)])

    def at(time: float) -> float:
        return float(of(np.array([time]))[0])

    looks = [look for span in pairwise(motion.steps) for look in _looks(of, *span, DEEPEST)]
    times, values = np.array([(0.0, at(0.0)), *looks]).T
    # Between two zeros near each other, of three values with one sign the middle one is the least.
    size = np.abs(values)
    for k in np.flatnonzero((size[1:-1] < size[:-2]) & (size[1:-1] < size[2:])) + 1:
        sign = np.sign(values[k])
        if sign == np.sign(values[k - 1]) == np.sign(values[k + 1]):
            around = sorted((float(times[k - 1]), float(times[k + 1])))
            least, depth = _least(at, sign, *around)
            if depth < -NOISE * size.max():
                times, values = np.append(times, least), np.append(values, sign * depth)
    order = np.argsort(np.abs(times))
    found = []
    for (left, before), (right, after) in pairwise(zip(times[order], values[order], strict=True)):
        if after == 0 != before:
            found.append(float(right))
        elif before * after < 0:
            zero = float(brentq(at, left, right, xtol=1e-14, rtol=4 * np.finfo(float).eps))
            if abs(at(zero)) <= max(abs(before), abs(after)):  # at a pole the sign changes too
                found.append(zero)
    return [x for x in found if abs(x) <= abs(end)]


def _least(
    value: Callable[[float], float], sign: float, left: float, right: float
) -> tuple[float, float]:
    """Where between two times ±value is least, and what it is there."""
    found = minimize_scalar(lambda t: sign * value(t), bounds=(left, right), method="bounded")
    return float(found.x), float(found.fun)


def _looks(
    of: Callable[[Floats], Floats], start: float, end: float, depth: int
) -> Iterator[tuple[float, float]]:
    """Times and values behind `start`, so dense that every other value follows from the rest."""
    times = start + (end - start) * PLACES
    times[-1] = end
    values = of(times)
    missed = np.abs(BETWEEN @ values[::2] - values[1::2]).max()
    if depth == 0 or missed <= max(0.05 * np.ptp(values), 1e-12 * np.abs(values).max()):
        yield from zip(times[1:], values[1:], strict=True)
    else:
        middle = (start + end) / 2
        yield from _looks(of, start, middle, depth - 1)
        yield from _looks(of, middle, end, depth - 1)
