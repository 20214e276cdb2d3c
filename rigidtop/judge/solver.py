"""Where equations hold: weighted least squares from random starts, each step the smallest one.

The highest rates move first and parameters last.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from sympy import Expr, Symbol

from rigidtop.judge.jets import jet_of
from rigidtop.judge.program import Array, Steps

_STARTS, _STEPS, _PATIENCE, _MORE = 12, 60, 32, 8
"""So many places are tried, with so many steps: fewer where none is exact by then, and few more
behind the first exact one if there are enough."""
_EXACT = 1e-12
"""An equation holds where its sides differ by no more than this share of its terms."""


def solved(
    equations: Sequence[Expr],
    letters: Sequence[Symbol],
    points: Array,
    weights: NDArray[np.float64],
    enough: int,
) -> tuple[Array, NDArray[np.bool_]]:
    """Where some starts, a column each, have come to, and in which of them all equations vanish.

    `weights` say how far each letter may go; no more are looked for once there are `enough`.
    """
    points = points.copy()
    exact = np.zeros(points.shape[1], bool)
    lost = np.zeros(points.shape[1], bool)
    largest = np.maximum(1, weights)[:, None]
    steps = Steps(equations, letters)
    first = _STEPS  # the step at which one was found
    for step in range(_STEPS):
        left = np.flatnonzero(~exact & ~lost)
        first = min(first, step) if exact.any() else first
        late = step > first + _MORE
        if not len(left) or exact.sum() >= (enough if late else 2 * enough):
            break
        if step > (_PATIENCE if first == _STEPS else first + 3 * _MORE):
            break
        at = steps.at(points[:, left])
        finite = np.isfinite(at.values).all(axis=0) & np.isfinite(at.slopes).all(axis=(0, 1))
        arrived = finite & (np.abs(at.values) <= _EXACT * (at.sizes + 1e-3)).all(axis=0)
        lost[left[~finite]] = True
        exact[left[arrived]] = True
        on = finite & ~arrived
        if not on.any():
            continue
        gap, size, slope = at.values[:, on], at.sizes[:, on], at.slopes[:, :, on]
        scale = np.abs(slope).max(axis=1) + 1e-300
        gap = np.where(np.abs(gap) <= _EXACT * size, 0, gap)
        scale = np.where((gap == 0) & (scale <= 1e-9 * (size + 1e-3)), np.inf, scale)
        matrix = np.moveaxis(slope / scale[:, None] * weights[:, None], -1, 0)
        move = weights[:, None] * least(matrix, (-gap / scale).T, 1e-9).T
        farthest = np.abs(move / largest).max(axis=0)
        points[:, left[on]] += move * (0.7 / np.maximum(farthest, 0.7))
        lost[left[on]] = (np.abs(points[:, left[on]]) > 1e5).any(axis=0)
    return points, exact


def least(matrices: Array, right: Array, rounding: float) -> Array:
    """The smallest solutions of systems of linear equations, each as nearly as it has one.

    A singular value that is no larger than this share of the largest one is taken for zero.
    """
    if not matrices.imag.any() and not right.imag.any():
        matrices, right = matrices.real, right.real
    made: Array = (np.linalg.pinv(matrices, rcond=rounding) @ right[..., None])[..., 0]
    return made


def starts(
    letters: Sequence[Symbol], seed: int, backwards: frozenset[Symbol] = frozenset()
) -> Array:
    """Random places for some letters, a column each; `backwards` may be negative too."""
    rates = tuple(order(x) > 0 for x in letters)
    return _places(seed, rates, tuple(bool(seed) and x in backwards for x in letters))


@lru_cache(maxsize=1_000)
def _places(seed: int, rates: tuple[bool, ...], backwards: tuple[bool, ...]) -> Array:
    """Random numbers for letters that are rates, or not; a speed may be one backwards.

    Of two places that stand side by side the rates have opposite signs, so that √ẋ² is not ẋ.
    """
    rng = np.random.default_rng(seed)
    rows = [
        rng.uniform(-1.5, 1.5, _STARTS) if is_rate else rng.uniform(0.5, 1.9, _STARTS)
        for is_rate in rates
    ]
    for row in (row for row, is_rate in zip(rows, rates, strict=True) if is_rate):
        row[1::2] = np.copysign(row[1::2], -row[::2])
    rows = [
        row * rng.choice([-1, 1], _STARTS) if either else row
        for row, either in zip(rows, backwards, strict=True)
    ]
    places: Array = np.array(rows, complex).reshape(len(rates), _STARTS)
    places.setflags(write=False)
    return places


def order(x: Symbol) -> int:
    """Which rate of its letter a number is; 0 if it is the letter itself."""
    jet = jet_of(x)
    return jet.order if jet is not None else 0


@lru_cache(maxsize=20_000)
def weight(x: Symbol) -> float:
    """How far a letter may go: rates farther, the parameters of which nothing moves least."""
    jet = jet_of(x)
    if jet is None:
        return 0.3 if x.name.startswith(("t\x1f", "unit ", "part ")) else 10.0
    return (1.0, 3.0, 10.0, 30.0)[min(jet.order, 3)]
