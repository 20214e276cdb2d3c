"""What is nearly equal: as something is made smaller, or larger, the sides become more alike.

Where x̂ is scaled down step by step, the share of the sides by which they differ has to go to zero.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from sympy import Expr, Symbol

from rigidtop.judge.jets import jet_of
from rigidtop.judge.laws import highest
from rigidtop.judge.program import Array, Program, UnknownFunctionError
from rigidtop.judge.worlds import Worlds
from rigidtop.tree.nodes import Letter
from rigidtop.tree.plain import plain

STEPS = 5
SMALL, LARGE = 0.1, 10.0
"""By these factors a letter is scaled at every step."""

LITTLE = 2e-3
"""At the last step the sides differ by no more than this share."""


def nearly(
    left: Expr,
    right: Expr,
    equations: Sequence[Expr],
    worlds: Worlds,
    moving: frozenset[Letter],
    which: str = "",
) -> str:
    """For what both sides become alike, in words; nothing where for none that is looked at.

    `which` is "small" or "large" where the text says which of the two it is.
    """
    for words, letters, factor in _scalings(worlds, equations, moving, which):
        if _tends(left, right, equations, worlds, letters, factor):
            return words
    return ""


def _scalings(
    worlds: Worlds, equations: Sequence[Expr], moving: frozenset[Letter], which: str
) -> list[tuple[str, list[Symbol], float]]:
    made: list[tuple[str, list[Symbol], float]] = []
    numbers = [(x, jet) for x in worlds.letters if (jet := jet_of(x)) is not None]
    motion = [x for x, jet in numbers if jet.order or jet.letter in moving]
    bound = set().union(*(e.free_symbols for e in equations)) if equations else set()
    if motion and which != "large":
        made.append(("a small motion", motion, SMALL))
    for x, jet in numbers:
        if x in motion or (x in bound and len(equations) > 3):
            continue
        name = plain(jet.letter)
        made += [] if which == "large" else [(f"small {name}", [x], SMALL)]
        made += [] if which == "small" else [(f"large {name}", [x], LARGE)]
    for x, jet in numbers:
        if x in motion and which != "large":
            made.append((f"small {plain(jet.letter)}", [x], SMALL))
    return made


def _tends(
    left: Expr,
    right: Expr,
    equations: Sequence[Expr],
    worlds: Worlds,
    letters: Sequence[Symbol],
    factor: float,
) -> bool:
    scaled = [worlds.letters.index(x) for x in letters]
    gaps = []
    for k in (STEPS - 1, 0):  # the last step decides most often
        points = worlds.points.copy()
        points[scaled] *= factor**k
        settled = _settled(equations, worlds, points)
        if settled is None:
            return False
        try:
            at = Program(worlds.letters, settled).values([left, right, left - right])
        except UnknownFunctionError:
            return False
        with np.errstate(all="ignore"):
            size = np.maximum(np.abs(at.values[0]), np.abs(at.values[1]))
            size = at.sizes[2] if left == 0 or right == 0 else size
            gaps.append(np.abs(at.values[2]) / size)
        if not (np.isfinite(gaps[0]).all() and (gaps[0] < LITTLE).all()):
            return False
    last, first = gaps
    return bool(np.isfinite(first).all() and (last <= 0.3 * np.maximum(first, 1e-9)).all())


def _settled(equations: Sequence[Expr], worlds: Worlds, points: Array) -> Array | None:
    """With the highest rates that the equations give at other numbers."""
    free = list(highest(equations))
    if not equations or not free:
        return points
    places = [worlds.letters.index(x) for x in free]
    for _ in range(30):
        at = Program(worlds.letters, points, with_slopes=True).values(equations)
        if not np.isfinite(at.slopes).all():
            return None
        points = points.copy()
        largest = 0.0
        for k in range(points.shape[1]):
            slope = at.slopes[:, places, k]
            scale = np.abs(slope).max(axis=1) + 1e-300
            move = np.linalg.lstsq(slope / scale[:, None], -at.values[:, k] / scale, rcond=1e-12)[0]
            points[places, k] += move
            largest = max(
                largest, float(np.abs(move).max() / (np.abs(points[places, k]).max() + 1e-300))
            )
        if largest < 1e-13:
            break
    return points
