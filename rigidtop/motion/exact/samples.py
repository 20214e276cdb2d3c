"""Many evenly spaced samples of one motion, from few.

Between its samples a motion is smooth.  In pieces of many samples each quantity is interpolated
from its values at Chebyshev's points, which is one small matrix product; where its last
coefficients are not negligible the pieces are halved, and where samples are few the closed form
itself is evaluated.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rigidtop.motion.attitude import Floats

NODES = 16
"""Values of a piece from which it is interpolated."""

FEWEST, MOST = 64, 1024
"""Samples of a piece, a power of 2: what is worth it, and what fits the processor's cache."""

HALF_PIECE = 0.5
"""In radians of z: 16 values give exp(2iz) to rounding there."""

OF_STRIP = 0.2
"""And a function that is analytic so far from the real axis, in these, most of the time."""

LEVELS = 4
"""So many sizes of pieces are tried, where there are many samples."""

MANY = 1 << 15
"""Fewer samples are worth one size only, of half as many."""

BLOCK = 1 << 13
"""Samples at a time; larger matrix products would be shared among threads."""

UNITS = 8 * float(np.finfo(float).eps)
"""Of last coefficients, and of times that are evenly spaced but for rounding."""


@lru_cache(maxsize=8)
def _weights(size: int) -> tuple[Floats, Floats]:
    """(NODES, size): from values at the nodes to samples; (NODES, 2): to the last coefficients."""
    orders = np.arange(NODES)
    analysis = np.cos(np.multiply.outer(_angles(), orders)) * (2 / NODES)
    analysis[:, 0] /= 2
    polynomials = np.empty((NODES, size))
    x = np.linspace(-1.0, 1.0, size)
    polynomials[0], polynomials[1] = 1.0, x
    for k in range(2, NODES):
        polynomials[k] = 2 * x * polynomials[k - 1] - polynomials[k - 2]
    return analysis @ polynomials, np.ascontiguousarray(analysis[:, -2:])


def _angles() -> Floats:
    return np.pi * (np.arange(NODES) + 0.5) / NODES


@dataclass(frozen=True, eq=False)
class Level:
    """The pieces of `size` samples that begin at `firsts`, and the states at their nodes."""

    size: int
    firsts: NDArray[np.intp]
    rows: NDArray[np.intp]
    """Which of all pieces whose states these are."""
    states: Any
    nodes: int
    """How many of the states those are."""


@dataclass(frozen=True, eq=False)
class Samples:
    """Evenly spaced samples of a motion, made by `samples`."""

    count: int
    levels: tuple[Level, ...]
    others: NDArray[np.intp]
    """Which samples are not interpolated."""
    states: Any
    """The states there, behind `skipped` others."""
    skipped: int

    def of(self, name: str) -> Floats:
        """All samples of a quantity of the states."""
        result = np.empty(self.count)
        for level in self.levels:
            weights, _ = _weights(level.size)
            every = getattr(level.states, name)[: level.nodes]
            values = every.reshape(-1, NODES)[level.rows]
            centres = values[:, NODES // 2 : NODES // 2 + 1]
            changes = values - centres
            table = result[: self.count // level.size * level.size].reshape(-1, level.size)
            pieces = level.firsts // level.size
            per_block = BLOCK // level.size
            for begin in range(0, len(pieces), per_block):
                block = slice(begin, begin + per_block)
                one, last = pieces[begin], pieces[block][-1]
                found = changes[block] @ weights
                found += centres[block]
                if last - one == len(found) - 1:
                    table[one : last + 1] = found
                else:
                    table[pieces[block]] = found
        if len(self.others):
            result[self.others] = getattr(self.states, name)[self.skipped :]
        return result


Sizes = Callable[[Any], Sequence[tuple[Floats, Floats]]]
"""From states, what is interpolated, and the sizes to which it is needed at each time."""


def samples(
    times: Floats, half: float, states: Callable[[Floats], Any], sizes: Sizes
) -> Samples | None:
    """The states at `times`, if these are many, evenly spaced, and many in `half` a second."""
    count = len(times)
    step = _step(times)
    if not 0 < abs(step) * FEWEST <= 2 * half:
        return None
    size = FEWEST
    most = min(2 * half / abs(step), MOST, count) / (1 if count > MANY else 2)
    while 2 * size <= most:
        size *= 2
    units = np.zeros(count // FEWEST, dtype=bool)  # what is done
    cosines = np.cos(_angles())
    levels: list[Level] = []
    for _ in range(LEVELS if count > MANY else 1):
        group = size // FEWEST
        whole = units[: len(units) // group * group].reshape(-1, group)
        firsts = np.flatnonzero(~whole.any(axis=1)) * size
        if not len(firsts):
            break
        begin, end = times[firsts], times[firsts + size - 1]
        nodes = ((begin + end)[:, None] / 2 + (end - begin)[:, None] / 2 * cosines).ravel()
        rest = times[len(whole) * size :] if not levels else times[:0]  # in the same call
        at_nodes = states(np.concatenate([nodes, rest]))
        _, last = _weights(size)
        pairs = sizes(at_nodes)
        values, needed = (
            np.stack([pair[k][: len(nodes)] for pair in pairs]).reshape(len(pairs), -1, NODES)
            for k in (0, 1)
        )
        smooth = np.all(np.abs(values @ last).max(axis=2) <= UNITS * needed.min(axis=2), axis=0)
        rows = np.flatnonzero(smooth)
        levels.append(Level(size, firsts[rows], rows, at_nodes, len(nodes)))
        whole[firsts[rows] // size] = True
        size //= 2
        if size < FEWEST or units.all():
            break
    left = np.append(np.repeat(~units, FEWEST), np.ones(count % FEWEST, dtype=bool))
    others = np.flatnonzero(left)
    if 2 * len(others) > count:
        return None
    first = levels[0]
    if len(others) == count - len(first.rows) * first.size == count % first.size:
        return Samples(count, tuple(levels), others, first.states, first.nodes)
    return Samples(count, tuple(levels), others, states(times[others]), 0)


def _step(times: Floats) -> float:
    """Between evenly spaced times; 0 of others, and of few."""
    count = len(times)
    if count < 4 * FEWEST:
        return 0.0
    step = (times[-1] - times[0]) / (count - 1)
    slack = UNITS / 2 * max(abs(times[0]), abs(times[-1]))
    index = np.arange(min(BLOCK, count)) * step
    for first in range(0, count, BLOCK):
        apart = times[first : first + BLOCK] - index[: count - first]
        apart -= times[0] + first * step
        if not max(apart.max(), -apart.min()) <= slack:
            return 0.0
    return float(step)


def half_piece(strip: float, rate: float) -> float:
    """Half the length of a piece (s), of functions of z that are analytic in a strip; dz/dt."""
    return min(HALF_PIECE, OF_STRIP * strip) / rate if rate else np.inf


def in_blocks(compute: Callable[[Floats], Sequence[Floats]], times: Floats) -> list[Floats]:
    """What `compute` gives, of times in blocks that fit the processor's cache."""
    size = BLOCK // 4
    if len(times) <= 2 * size:
        return list(compute(times))
    parts = [compute(times[first : first + size]) for first in range(0, len(times), size)]
    return [np.concatenate(column) for column in zip(*parts, strict=True)]
