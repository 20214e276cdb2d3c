"""Many evenly spaced samples of one motion, from few.

Samples are cut into pieces of one size, and all pieces of a quantity are one small matrix product:
what is known of each piece, times functions that are the same for every piece.

- `Harmonics`: but for what grows evenly with time a motion is periodic, and a few dozen values of
  one period give its Fourier series.  Each piece turns the coefficients by its phase.
- `Nodes`: next to a separatrix the period is long, next to a pole the series is.  There every
  piece is interpolated from its values at Chebyshev's points.

Either is taken only where the last coefficients are rounding; else the closed form itself is
evaluated.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from rigidtop.motion.attitude import Complexes, Floats

NODES = 16
"""Values of a piece from which it is interpolated."""

FEWEST, MOST = 64, 1024
"""Samples of a piece: what is worth it, and what fits the processor's cache."""

SIZES = 32
"""Pieces of few samples have a multiple of so many; those of many a power of 2, to be halved."""

HALF_PIECE = 0.5
"""In radians of z: 16 values give exp(2iz) to rounding there."""

OF_STRIP = 0.2
"""And a function that is analytic so far from the real axis, in these, most of the time."""

BESIDE = 2.5
"""So many pieces are too near to a pole, each time that a motion comes to one."""

LEVELS = 4
"""So many sizes of pieces are tried, where there are many samples."""

MANY = 1 << 15
"""Fewer samples are worth one size only, of half as many."""

BLOCK = 2560
"""States at a time: some dozens of arrays stay in the processor's cache."""

PRODUCT = 1 << 18
"""Multiplications of a matrix product: larger ones would be shared among threads."""

UNITS = 8 * float(np.finfo(float).eps)
"""Of last coefficients, and of times that are evenly spaced but for rounding."""

MOST_HARMONICS = 120
"""Longer series cost more than pieces."""

LONG_SERIES = 40
"""Harmonics from which any pieces are better, of few samples too."""

LAST = 4
"""Coefficients that must be rounding."""

NEGLIGIBLE = float(np.finfo(float).eps) / 4
"""Of coefficients: their sum is far below rounding."""

States = Callable[[Floats], Any]
"""At times (N,), an object with arrays of that shape."""

Sizes = Callable[[Floats], Callable[[Any], Sequence[tuple[str, Floats | float]]]]
"""From times, and states: which quantities must be right, and to what size, everywhere or at each.

A late time is not known as well as an early one, and so is what depends on it."""


@dataclass(frozen=True)
class Course:
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
    """Half a period of z, of all but what is linear in time."""
    slopes: Mapping[str, float] = field(default_factory=dict)
    """What grows with time, and how fast (1/s)."""

    @property
    def harmonics(self) -> float:
        """How many there are in a period, to rounding."""
        if not self.rate * self.nearest > 0:
            return math.inf
        return -math.log(NEGLIGIBLE) * self.half / (math.pi * self.nearest)

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
        """And next to poles too (s)."""
        return 2 * OF_STRIP * self.nearest / self.rate if self.rate else math.inf


class Part(Protocol):
    """Some of the pieces."""

    @property
    def size(self) -> int:
        """Samples of a piece."""

    @property
    def rows(self) -> NDArray[np.intp]:
        """Which pieces, in order."""

    @property
    def basis(self) -> Floats:
        """(W, size)."""

    def coefficients(self, name: str) -> tuple[Floats, Floats, float]:
        """(P, W), times `basis`; and what is added: (P,), and so much more at each sample."""


@dataclass(frozen=True, eq=False)
class Nodes:
    """Pieces that are interpolated from their values at Chebyshev's points."""

    size: int
    rows: NDArray[np.intp]
    columns: NDArray[np.intp]
    """Which of all pieces whose states these are."""
    states: Any

    @property
    def basis(self) -> Floats:
        return _weights(self.size)[0]

    def coefficients(self, name: str) -> tuple[Floats, Floats, float]:
        values = getattr(self.states, name).reshape(NODES, -1)[:, self.columns]
        centre = values[NODES // 2]
        return (values - centre).T, centre, 0.0


@dataclass(frozen=True, eq=False)
class Harmonics:
    """A periodic motion."""

    size: int
    rows: NDArray[np.intp]
    begins: Floats
    """The times at which pieces begin (s)."""
    step: float
    basis: Floats
    phases: Complexes
    """Powers of exp(2πit/T) where pieces begin, (P, W/2)."""
    nodes: Floats
    states: Any
    course: Course

    def coefficients(self, name: str) -> tuple[Floats, Floats, float]:
        slope = self.course.slopes.get(name, 0.0)
        c = _series(getattr(self.states, name) - slope * self.nodes)
        turned = self.phases * c[1 : 1 + self.phases.shape[1]]
        return turned.view(np.float64), c[0].real + slope * self.begins, slope * self.step


@dataclass(frozen=True, eq=False)
class Samples:
    """Evenly spaced samples of a motion, made by `samples`."""

    count: int
    padded: int
    """With those behind the last that fill its piece."""
    parts: tuple[Part, ...]
    others: NDArray[np.intp]
    """Which samples are evaluated, and the states there."""
    states: Any

    def of(self, *names: str) -> Floats:
        """All samples of some quantities of the states, (len(names), count)."""
        result = np.empty((len(names), self.padded))
        for row, name in zip(result, names, strict=True):
            for part in self.parts:
                _fill(row.reshape(-1, part.size), part, name)
            if len(self.others):
                row[self.others] = getattr(self.states, name)
        return result[:, : self.count]


def _fill(table: Floats, part: Part, name: str) -> None:
    """The pieces of a part, of all pieces (P, size)."""
    coefficients, added, slope = part.coefficients(name)
    basis, rows = part.basis, part.rows
    line = slope * np.arange(part.size) if slope else 0.0
    per_block = max(PRODUCT // (len(basis) * part.size), 1)
    for begin in range(0, len(rows), per_block):
        block = rows[begin : begin + per_block]
        whole = block[-1] - block[0] == len(block) - 1
        found = table[block[0] : block[-1] + 1] if whole else np.empty((len(block), part.size))
        np.matmul(coefficients[begin : begin + per_block], basis, out=found)
        if slope:
            found += line
        found += added[begin : begin + per_block, None]
        if not whole:
            table[block] = found


def samples(times: Floats, course: Course, states: States, sizes: Sizes) -> Samples | None:
    """The states at `times`, if these are many and evenly spaced, and the motion smooth there."""
    step = _step(times)
    if not step:
        return None
    size = _size(len(times), step, course)
    # Products cost what they have terms: of pieces always few, and long pieces have few nodes.
    cheap = 2 * FEWEST if len(times) <= MANY and course.harmonics <= LONG_SERIES else FEWEST
    if course.harmonics > MOST_HARMONICS:
        ways = [_in_pieces]
    elif course.harmonics > NODES / 2 and size >= cheap:
        ways = [_in_pieces, _in_harmonics]
    else:
        ways = [_in_harmonics, _in_pieces]
    for way in ways:
        found = way(times, step, course, size, states, sizes)
        if found is not None:
            return found
    return None


def _size(count: int, step: float, course: Course) -> int:
    """How many samples of the first pieces; 0 if pieces are too short."""
    if not abs(step) * FEWEST <= course.piece:
        return 0
    most = min(course.piece / abs(step), MOST, count)
    if count > MANY:
        return FEWEST << int(math.log2(most / FEWEST))
    # One size only is worth it.  Beside each pole a piece or two are evaluated, sample by sample.
    poles = count * abs(step) / course.period
    balanced = math.sqrt(NODES * count / (BESIDE * poles)) if poles else math.inf
    most = min(most, max(course.piece_anywhere / abs(step), balanced))
    return max(int(most) // SIZES * SIZES, FEWEST)


def _in_harmonics(
    times: Floats, step: float, course: Course, size: int, states: States, sizes: Sizes
) -> Samples | None:
    number = FEWEST
    while number < 2 * (course.harmonics + LAST):
        number *= 2
    nodes = np.linspace(0.0, course.period, number, endpoint=False)
    at_nodes = states(nodes)
    needs = sizes(nodes)(at_nodes)
    values, units = _needed(at_nodes, needs, number)
    for row, (name, _) in zip(values[..., 0], needs, strict=True):
        if name in course.slopes:
            row -= course.slopes[name] * nodes
    series = np.abs(_series(values[..., 0]))
    if not np.all(series[:, -LAST:] <= UNITS * units):
        return None
    wanted = (series[:, 1:] > NEGLIGIBLE * units).any(axis=0)
    width = 1 + int(np.flatnonzero(wanted).max(initial=0))
    count = len(times)
    size = 2 * FEWEST if count < MANY else MOST
    begins = times[::size]
    turns = begins / course.period
    ahead: Floats = np.arange(float(size)) * (2 * math.pi * step / course.period)
    powers = _powers(ahead, width)
    basis = np.empty((2 * width, size))
    basis[0::2], basis[1::2] = powers.real, -powers.imag
    part = Harmonics(
        size=size,
        rows=np.arange(len(begins)),
        begins=begins,
        step=step,
        basis=basis,
        phases=np.ascontiguousarray(_powers(2 * math.pi * (turns - np.rint(turns)), width).T),
        nodes=nodes,
        states=at_nodes,
        course=course,
    )
    return Samples(count, len(begins) * size, (part,), np.arange(0), at_nodes)


def _needed(
    states: Any, needs: Sequence[tuple[str, Floats | float]], nodes: int
) -> tuple[Floats, Floats]:
    """Quantities (Q, nodes, P) of pieces, and to what size each is needed there (Q, P)."""
    values = np.stack([getattr(states, name).reshape(nodes, -1) for name, _ in needs])
    units = np.empty((len(needs), values.shape[2]))
    for unit, (_, needed) in zip(units, needs, strict=True):
        unit[:] = needed if isinstance(needed, float) else needed.reshape(nodes, -1).min(axis=0)
    return values, units


def _series(values: Floats) -> Complexes:
    """Fourier coefficients (…, n), of which the real parts of the products are to be added."""
    number = values.shape[-1]
    found = np.fft.rfft(values)[..., : number // 2] * (2 / number)
    found[..., 0] /= 2
    return found


def _powers(angles: Floats, most: int) -> Complexes:
    """(most, …): exp(iα), its square and so on."""
    found = np.empty((most, len(angles)), dtype=complex)
    found[0] = np.exp(1j * angles)
    done = 1
    while done < most:
        more = min(done, most - done)
        np.multiply(found[:more], found[done - 1], out=found[done : done + more])
        done += more
    return found


def _in_pieces(
    times: Floats, step: float, course: Course, size: int, states: States, sizes: Sizes
) -> Samples | None:
    if not size:
        return None
    count, needed = len(times), sizes(times)
    padded = -(-count // size) * size
    unit = FEWEST if count > MANY else size
    left = np.ones(padded // unit, dtype=bool)
    parts: list[Nodes] = []
    for _ in range(LEVELS if count > MANY else 1):
        whole = left.reshape(-1, size // unit)
        pieces = np.flatnonzero(np.all(whole[: -(-count // size)], axis=1))
        if not len(pieces):
            break
        middle = times[pieces * size] + step * ((size - 1) / 2)
        nodes = np.add.outer(step * ((size - 1) / 2) * np.cos(_angles()), middle)
        at_nodes = states(nodes.ravel())
        values, units = _needed(at_nodes, needed(at_nodes), NODES)
        changes = values - values[:, NODES // 2, None]
        last: Floats = np.abs(np.matmul(_weights(size)[1], changes)).max(axis=1)
        columns = np.flatnonzero((last <= UNITS * units).all(axis=0))
        parts.append(Nodes(size, pieces[columns], columns, at_nodes))
        whole[pieces[columns]] = False
        size //= 2
        if size < FEWEST or not left.any():
            break
    others = np.flatnonzero(np.repeat(left, unit)[:count])
    if 2 * len(others) > count:
        return None
    at_others = states(times[others]) if len(others) else parts[0].states
    return Samples(count, padded, tuple(parts), others, at_others)


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
    found = np.empty((len(first), len(times)))
    begin = 0
    for block in blocks:
        end = begin + len(block)
        for row, values in zip(found, compute(block) if begin else first, strict=True):
            row[begin:end] = values
        begin = end
    return found
