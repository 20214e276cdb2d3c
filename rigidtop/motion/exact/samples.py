"""Many evenly spaced samples of one motion, from few.

Samples are cut into pieces, each of which is interpolated from its values at Chebyshev's points:
all pieces of a quantity are one small matrix product.  That is taken only where the last
coefficients are rounding; else, as next to a pole, the closed form itself is evaluated.
"""

from __future__ import annotations

import math
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
"""Samples of a piece: what is worth it, and what fits the processor's cache."""

SIZES = 32
"""Pieces have a multiple of so many."""

HALF_PIECE = 0.5
"""In radians of z: 16 values give exp(2iz) to rounding there."""

OF_STRIP = 0.2
"""And a function that is analytic so far from the real axis, in these, most of the time."""

THROUGH, BESIDE = 1.0, 3.0
"""So many pieces are too near to a pole, each time that a motion goes through one, or beside it."""

MANY = 1 << 15
"""Fewer samples cost less where a compiled formula computes each."""

BLOCK = 2560
"""States at a time: some dozens of arrays stay in the processor's cache."""

PRODUCT = 1 << 18
"""Multiplications of a matrix product: larger ones would be shared among threads."""

UNITS = 8 * float(np.finfo(float).eps)
"""Of last coefficients, and of times that are evenly spaced but for rounding."""

States = Callable[[Floats], Any]
"""At times (N,), an object with arrays of that shape."""

Sizes = Callable[[Floats], Callable[[Any], Sequence[tuple[str, Floats | float]]]]
"""From times, and states: which quantities must be right, and to what size, everywhere or at each.

A late time is not known as well as an early one, and so is what depends on it."""


@dataclass(frozen=True)
class Smoothness:
    """How smooth a motion is, as a function of z, which grows with time: see `theta`."""

    rate: float
    """|dz/dt| (1/s)."""
    strip: float
    """How far from the real axis the functions are analytic, but next to poles."""
    turning: float
    """Nothing turns faster (rad/s)."""
    nearest: float = 0.0
    """How far they are analytic next to poles."""
    half: float = math.inf
    """Half of how far z goes from a pole to the next."""

    @property
    def period(self) -> float:
        return 2 * self.half / self.rate if self.rate else math.inf

    @property
    def piece(self) -> float:
        """What `Nodes` may interpolate, in most places (s)."""
        turning = 2 * HALF_PIECE / self.turning if self.turning else math.inf
        return min(turning, 2 * OF_STRIP * self.strip / self.rate) if self.rate else turning

    @property
    def piece_anywhere(self) -> float:
        """The longest piece that may be interpolated next to poles too (s)."""
        return 2 * OF_STRIP * self.nearest / self.rate if self.rate else math.inf


@dataclass(frozen=True, eq=False)
class Samples:
    """Evenly spaced samples of a motion, made by `samples`."""

    count: int
    size: int
    """Samples of a piece."""
    nodes: Any
    """The states of all pieces at Chebyshev's points."""
    others: NDArray[np.intp]
    """Which samples are evaluated, for their pieces are no polynomials, and the states there."""
    states: Any

    def of(self, *names: str) -> Floats:
        """All samples of some quantities of the states, (len(names), count)."""
        result = np.empty((len(names), -(-self.count // self.size) * self.size))
        for row, name in zip(result, names, strict=True):
            self._interpolate(row.reshape(-1, self.size), name)
            if len(self.others):
                row[self.others] = getattr(self.states, name)
        return result[:, : self.count]

    def _interpolate(self, table: Floats, name: str) -> None:
        """Fill a table of all pieces (P, size)."""
        values = getattr(self.nodes, name).reshape(NODES, -1)
        added, basis = values[NODES // 2], _weights(self.size)[0]
        coefficients = (values - added).T
        per_block = max(PRODUCT // (NODES * self.size), 1)
        for begin in range(0, len(table), per_block):
            block = slice(begin, begin + per_block)
            np.matmul(coefficients[block], basis, out=table[block])
            table[block] += added[block, None]


def samples(times: Floats, smoothness: Smoothness, states: States, sizes: Sizes) -> Samples | None:
    """The states at `times`, if these are many and evenly spaced, and the motion smooth there."""
    step = _step(times)
    size = _size(len(times), step, smoothness) if step else 0
    if not size:
        return None
    half = step * ((size - 1) / 2)
    at_nodes = states(np.add.outer(half * np.cos(_angles()), times[::size] + half).ravel())
    values, units = _needed(at_nodes, sizes(times)(at_nodes), NODES)
    changes = values - values[:, NODES // 2, None]
    last: Floats = np.abs(np.matmul(_weights(size)[1], changes)).max(axis=1)
    wrong = np.flatnonzero(~(last <= UNITS * units).all(axis=0))
    others = np.add.outer(wrong * size, np.arange(size)).ravel()
    others = others[others < len(times)]
    if 2 * len(others) > len(times):
        return None
    return Samples(
        len(times), size, at_nodes, others, states(times[others]) if len(others) else at_nodes
    )


def _size(count: int, step: float, smoothness: Smoothness) -> int:
    """How many samples of a piece; 0 if pieces are too short."""
    if not abs(step) * FEWEST <= smoothness.piece:
        return 0
    # Beside each pole a piece or two are evaluated, sample by sample.
    poles = count * abs(step) / smoothness.period
    lost = (BESIDE if smoothness.nearest else THROUGH) * poles
    balanced = math.sqrt(NODES * count / lost) if lost else math.inf
    most = min(smoothness.piece / abs(step), MOST, count)
    most = min(most, max(smoothness.piece_anywhere / abs(step), balanced))
    return max(int(most) // SIZES * SIZES, FEWEST)


def _needed(
    states: Any, needs: Sequence[tuple[str, Floats | float]], nodes: int
) -> tuple[Floats, Floats]:
    """Quantities (Q, nodes, P) of pieces, and to what size each is needed there (Q, P)."""
    values = np.stack([getattr(states, name).reshape(nodes, -1) for name, _ in needs])
    units = np.empty((len(needs), values.shape[2]))
    for unit, (_, needed) in zip(units, needs, strict=True):
        unit[:] = needed if isinstance(needed, float) else needed.reshape(nodes, -1).min(axis=0)
    return values, units


@lru_cache(maxsize=MOST // SIZES)
def _weights(size: int) -> tuple[Floats, Floats]:
    """(NODES, size): from values at the nodes to samples; (2, NODES): to the last coefficients."""
    orders = np.arange(NODES)
    analysis = np.cos(np.multiply.outer(_angles(), orders)) * (2 / NODES)
    analysis[:, 0] /= 2
    polynomials = np.cos(np.multiply.outer(orders, np.arccos(np.linspace(-1.0, 1.0, size))))
    return analysis @ polynomials, np.ascontiguousarray(analysis[:, -2:].T)


def _angles() -> Floats:
    return np.pi * (np.arange(NODES) + 0.5) / NODES


def _step(times: Floats) -> float:
    """Between evenly spaced times; 0 of others, and of few."""
    count = len(times)
    if count < 4 * FEWEST:
        return 0.0
    step = (times[-1] - times[0]) / (count - 1)
    slack = UNITS / 2 * max(abs(times[0]), abs(times[-1]))
    block = 4 * BLOCK
    index = np.arange(min(block, count)) * step
    for first in range(0, count, block):
        apart = times[first : first + block] - index[: count - first]
        apart -= times[0] + first * step
        if not max(apart.max(), -apart.min()) <= slack:
            return 0.0
    return float(step)


def in_blocks(compute: Callable[[Floats], Sequence[Floats]], times: Floats) -> Floats:
    """The rows that `compute` gives, of times in blocks that fit the processor's cache."""
    blocks = np.array_split(times, -(-len(times) // BLOCK) or 1)
    if len(blocks) == 1:
        return np.stack(np.broadcast_arrays(*compute(times)))
    first = compute(blocks[0])
    rows = np.empty((len(first), len(times)))
    begin = 0
    for block in blocks:
        end = begin + len(block)
        for row, values in zip(rows, compute(block) if begin else first, strict=True):
            row[begin:end] = values
        begin = end
    return rows
