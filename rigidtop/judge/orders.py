"""What is nearly equal: as something is made smaller, or larger, the sides become more alike.

Where x̂ is scaled down step by step, the share of the sides by which they differ has to go to zero.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray
from sympy import Add, Expr, Symbol

from rigidtop.judge.jets import TIME, jet_of, operations
from rigidtop.judge.letters import CLOCK
from rigidtop.judge.program import Array, Program, Steps, UnknownFunctionError
from rigidtop.judge.solver import least
from rigidtop.judge.surroundings import highest
from rigidtop.judge.worlds import Worlds
from rigidtop.tree.nodes import Letter
from rigidtop.tree.plain import plain

STEPS = 5
SMALL, LARGE = 0.1, 10.0
"""By these factors a letter is scaled at every step."""

LITTLE = 4e-3
"""At the last step the sides differ by no more than this share."""


LONGEST = 200
"""A side with more operations is not taken apart into its terms."""

_TYPICAL = 0.5
"""Sides are not taken for smaller than this share of what they are elsewhere."""

MORE = 2.0
"""What is of an order becomes no more than so many times as large a share of it at a step."""

STAYS = 0.7
"""A share that is no less than this much of the one a step before does not go to zero."""


@dataclass(frozen=True)
class Scaling:
    """Letters that are scaled together, with what they are then, in words."""

    words: str
    letters: tuple[Symbol, ...]
    factor: float


def nearly(
    left: Expr,
    right: Expr,
    equations: Sequence[Expr],
    worlds: Worlds,
    tried: Iterable[Scaling],
) -> Scaling | None:
    """For what both sides become alike; None where for none that is tried."""
    for scaling in tried:
        if _tends(left, right, equations, worlds, scaling):
            return scaling
    return None


_ROUNDING, _SETTLED = 1e-15, 1e-13
"""What is left out may be no more than these shares of the largest term: the second one where
equations had to be solved for the numbers."""


def is_too_long(
    left: Expr, right: Expr, equations: Sequence[Expr], worlds: Worlds, scaling: Scaling
) -> bool:
    """Whether a term of the right side becomes no larger than what is left out."""
    terms = Add.make_args(right.expand()) if operations(right) < LONGEST else (right,)
    if len(terms) < 2:
        return False

    def beside_smallest(step: int) -> Gap | None:
        settled, _ = _settled(tuple(equations), worlds, scaling, step)
        if settled is None:
            return None
        at = Program(worlds.letters, settled).values([left - right, *terms])
        return _gap_of(at.values[0], at.sizes[0], np.abs(at.values[1:]).min(axis=0), equations)

    return _stays(beside_smallest)


def differ(
    left: Expr, right: Expr, equations: Sequence[Expr], worlds: Worlds, scaling: Scaling
) -> bool:
    """Whether both sides have values at the last steps and in no world become alike."""
    sides = left, right, equations, worlds, scaling
    return _stays(lambda step: _gap(*sides, step, strictly=True))


def grows(
    both: tuple[Expr, Expr],
    size: Expr,
    equations: Sequence[Expr],
    worlds: Worlds,
    scaling: Scaling,
) -> bool | None:
    """Whether the gap between two sides becomes ever larger beside a size; None if it isn't seen.

    It does not if in no world it is a larger share of that at the last step than a step before.
    """

    def share(step: int) -> Gap | None:
        settled, holds = _settled(tuple(equations), worlds, scaling, step)
        if settled is None or not holds:
            return None
        at = Program(worlds.letters, settled).values([both[0] - both[1], size])
        return _gap_of(at.values[0], at.sizes[0], np.abs(at.values[1]), equations)

    step, last = _last(share)
    before = share(step - 1)
    if last is None or before is None or not np.isfinite([before.share, last.share]).all():
        return None
    if (last.share <= MORE * before.share).all():
        return False
    return True if (last.share > before.share / scaling.factor / MORE).all() else None


def ratio(
    left: Expr, right: Expr, equations: Sequence[Expr], worlds: Worlds, scaling: Scaling
) -> float:
    """How many times as large as the right side the left one becomes; NaN where it is not seen."""
    step, gap = _last(lambda step: _gap(left, right, equations, worlds, scaling, step))
    settled, _ = _settled(tuple(equations), worlds, scaling, step)
    if gap is None or settled is None:
        return np.nan
    at = Program(worlds.letters, settled).values([left, right])
    with np.errstate(all="ignore"):
        return float(np.median((at.values[0] / at.values[1]).real))


def share(left: Expr, right: Expr, worlds: Worlds, scaling: Scaling) -> NDArray[np.float64]:
    """By which share of the larger one both sides differ at the last step."""
    _, gap = _last(lambda step: _gap(left, right, (), worlds, scaling, step))
    return np.full(worlds.count, np.inf) if gap is None else gap.share


def small_together(letters: frozenset[Letter], worlds: Worlds) -> Scaling | None:
    """What is said to be small together, with its rates."""
    small = [x for x in worlds.letters if (jet := jet_of(x)) is not None and jet.letter in letters]
    words = "small " + " and ".join(sorted(map(plain, letters)))
    return Scaling(words, tuple(small), SMALL) if small else None


def tending_to(letter: Letter, large: bool, worlds: Worlds) -> Scaling | None:
    """That a letter, or the time, becomes large or small."""
    time = letter == CLOCK
    names = [
        x
        for x in worlds.letters
        if (x == TIME if time else (jet := jet_of(x)) is not None and jet.letter == letter)
    ]
    words = f"{'large' if large else 'small'} {plain(letter)}"
    return Scaling(words, tuple(names), LARGE if large else SMALL) if names else None


def scalings(
    worlds: Worlds, equations: Sequence[Expr], moving: frozenset[Letter], which: str = ""
) -> list[Scaling]:
    """What is looked at: a small motion, and each letter alone.

    `which` is "small" or "large" where the text says which of the two it is.
    """
    made: list[Scaling] = []
    numbers = [(x, jet) for x in worlds.letters if (jet := jet_of(x)) is not None]
    motion = [x for x, jet in numbers if jet.order or jet.letter in moving]
    bound = set().union(*(e.free_symbols for e in equations)) if equations else set()
    if motion and which != "large":
        made.append(Scaling("a small motion", tuple(motion), SMALL))
    for x, jet in numbers:
        if x in motion or (x in bound and len(equations) > 3):
            continue
        name = plain(jet.letter)
        made += [] if which == "large" else [Scaling(f"small {name}", (x,), SMALL)]
        made += [] if which == "small" else [Scaling(f"large {name}", (x,), LARGE)]
    for x, jet in numbers:
        if x in motion and which != "large":
            made.append(Scaling(f"small {plain(jet.letter)}", (x,), SMALL))
    return made


def _tends(
    left: Expr, right: Expr, equations: Sequence[Expr], worlds: Worlds, scaling: Scaling
) -> bool:
    sides = left, right, equations, worlds, scaling
    step, last = _last(lambda step: _gap(*sides, step))  # it decides most often
    if last is None or not (last.share < LITTLE).all():
        return False
    if not all(_settled(tuple(equations), worlds, scaling, k)[1] for k in range(step + 1)):
        return False  # the numbers have jumped to where something else is small
    first = _gap(*sides, 0)
    if first is None or not np.isfinite(first.share).all():
        return False
    return bool((last.share <= 0.3 * np.maximum(first.share, 1e-9)).all())


@dataclass(frozen=True, eq=False)
class Gap:
    """By which share two sides differ in each world, and how much of that may be rounding."""

    share: NDArray[np.float64]
    rounding: NDArray[np.float64]

    @property
    def resolved(self) -> NDArray[np.bool_]:
        """In which worlds rounding would change nothing that is seen."""
        return np.asarray(self.rounding < LITTLE / 4 * np.maximum(self.share, 1))


def _gap_of(
    values: Array, terms: NDArray[np.float64], size: NDArray[np.float64], equations: Sequence[Expr]
) -> Gap:
    """Values as shares of a size; those that rounding of their terms may have left are zero."""
    rounding = (_SETTLED if equations else _ROUNDING) * terms
    gaps = np.where(np.abs(values) <= rounding, 0, np.abs(values))
    with np.errstate(all="ignore"):
        return Gap(gaps / size, rounding / size)


Gaps = Callable[[int], Gap | None]
"""The gap after so many steps; None where it has no value."""


def _last(gap_at: Gaps, enough: float = 1.0) -> tuple[int, Gap | None]:
    """The last step at which rounding does not hide a gap, and the gap there.

    1 − cos x is lost in the rounding of 1 where x is small enough.  A share of the worlds in which
    it is not hidden may be `enough`.
    """
    for step in reversed(range(1, STEPS)):
        gap = gap_at(step)
        if gap is None or gap.resolved.mean() >= enough or not np.isfinite(gap.share).all():
            break
    return step, gap


def _stays(gap_at: Gaps) -> bool:
    """Whether in every world a gap is not seen to go to zero at the last two steps."""
    step, last = _last(gap_at, enough=0.5)
    before = gap_at(step - 1)
    if last is None or before is None:
        return False
    if not np.isfinite([before.share, last.share]).all() or not last.resolved.any():
        return False
    stays = (last.share > LITTLE) & (last.share >= STAYS * before.share)
    return bool(stays[last.resolved].all())


def _gap(
    left: Expr,
    right: Expr,
    equations: Sequence[Expr],
    worlds: Worlds,
    scaling: Scaling,
    step: int,
    strictly: bool = False,
) -> Gap | None:
    """By how much both sides differ after some steps; None where it has no value.

    What is said to vanish has to be small beside what is scaled.
    """
    points, scaled = _scaled(worlds, scaling, step)
    settled, holds = _settled(tuple(equations), worlds, scaling, step)
    if settled is None or (strictly and not holds):
        return None
    try:
        at = Program(worlds.letters, settled).values([left, right, left - right])
    except UnknownFunctionError:
        return None
    size = np.maximum(np.abs(at.values[0]), np.abs(at.values[1]))
    size = np.maximum(size, _TYPICAL * np.median(size))  # both may be small by chance
    if left == 0 or right == 0:
        size = at.sizes[2]
        if len(scaling.letters) > 1 and scaling.factor < 1:
            size = np.abs(points[scaled]).max(axis=0)
    return _gap_of(at.values[2], at.sizes[2], size, equations)


def _scaled(worlds: Worlds, scaling: Scaling, step: int) -> tuple[Array, list[int]]:
    """Numbers that are scaled after some steps, and in which rows they stand."""
    scaled = [worlds.letters.index(x) for x in scaling.letters]
    points = worlds.points.copy()
    points[scaled] *= scaling.factor**step
    return points, scaled


@lru_cache(maxsize=512)
def _settled(
    equations: tuple[Expr, ...], worlds: Worlds, scaling: Scaling, step: int
) -> tuple[Array | None, bool]:
    """With the highest rates that the equations give at other numbers, and whether these hold.

    Where they do not, other rates move too, and then all letters, but for those that are scaled.
    """
    points, scaled = _scaled(worlds, scaling, step)
    if not equations:
        return points, True
    numbers = range(len(worlds.letters))
    top = {worlds.letters.index(x) for x in highest(equations)}
    rates = {
        k for k, x in enumerate(worlds.letters) if (jet := jet_of(x)) is not None and jet.order
    }
    held = {*scaled} - rates or {*scaled}  # of a small motion the rates are what they have to be
    wider = [top, top | rates - held, {*numbers} - {*scaled}]
    first = None
    for places in (x for x in wider if x):
        moved, holds = _moved(equations, worlds, points, sorted(places))
        if holds:
            return moved, holds
        if first is None:
            first = moved
    return first, False


_NOTHING = 1e-12
"""What is no larger is left by rounding, beside numbers of which most are about one."""

_STEPS, _PATIENCE = 30, 12
"""So many steps towards numbers at which equations hold, and so few where it only jumps about."""


def _moved(
    equations: Sequence[Expr], worlds: Worlds, points: Array, places: Sequence[int]
) -> tuple[Array | None, bool]:
    steps = Steps(equations, worlds.letters)
    for step in range(_STEPS):
        at = steps.at(points)
        if not np.isfinite(at.slopes).all():
            return None, False
        slope = at.slopes[:, places]
        scale = np.abs(slope).max(axis=1)
        scale = np.where(scale > 0, scale, np.inf)  # what no such rate can change stays
        matrix = np.moveaxis(slope / scale[:, None], -1, 0)
        move = least(matrix, (-at.values / scale).T, 1e-12).T
        points = points.copy()
        points[places] += move
        reached = np.abs(points[places]).max(axis=0) + 1e-300
        largest = float((np.abs(move).max(axis=0) / reached).max())
        if largest < 1e-13 or (step > _PATIENCE and largest > 0.3):
            break
    here = Program(worlds.letters, points).values(equations)
    return points, bool((np.abs(here.values) <= 1e-8 * here.sizes + _NOTHING).all())
