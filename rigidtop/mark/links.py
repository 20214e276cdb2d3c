"""Two sides of a line, and whether they are equal for every motion of a model."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sympy
from sympy import Expr, MatrixBase, Symbol, cos, sin

from rigidtop.proof import decide, floats
from rigidtop.proof.counterexample import entries
from rigidtop.proof.equation import NoMeaningError, Partial
from rigidtop.proof.model import Model, Sample, samples
from rigidtop.typeset.text import text


@dataclass(frozen=True)
class Link:
    """Two neighbouring sides.  `right` None: the left one is constant."""

    left: Expr
    right: Expr


@dataclass(frozen=True)
class Verdict:
    """True, false with a motion at which it fails, or (None) neither shown nor refuted."""

    holds: bool | None
    at: Sample | None = None
    left: Expr | None = None
    right: Expr | None = None
    why: str = ""


ERRORS = (ArithmeticError, TypeError, ValueError, AttributeError, NoMeaningError)
FEWEST = 6
"""A line that has values at fewer motions than this is not judged."""


def judge(link: Link, model: Model) -> Verdict:
    """Whether a link holds for every motion of a model."""
    try:
        tried = samples(model)
        found = [
            (sample, sides)
            for sample, sides in zip(tried, in_numbers(link, model, tried), strict=True)
            if sides is not None
        ]
        refuted = [Verdict(False, sample, *sides) for sample, sides in found if apart(*sides)]
        for verdict in refuted:
            sides = verdict.left, verdict.right
            if pair_text(*sides) != pair_text(*reversed(sides)):
                return verdict
        if refuted:
            return refuted[0]
        if len(found) < FEWEST:
            return Verdict(None, why="it has a value for hardly any motion")
        return Verdict(True if is_shown(link, model) else None, why="neither shown nor refuted")
    except ERRORS as error:
        return Verdict(None, why=f"it says nothing that can be compared: {error}")
    except RecursionError:
        return Verdict(None, why="nested too deeply")


def sides_of(link: Link, model: Model) -> tuple[Expr, Expr]:
    """The values of the two sides in the free symbols; a rate and 0 of what is constant."""
    if link.right is None:
        left = model.rate(link.left)
        return left, sympy.zeros(*left.shape) if is_matrix(left) else sympy.Integer(0)
    return model.value(link.left), model.value(link.right)


def in_numbers(link: Link, model: Model, samples: Sequence[Sample]) -> list[tuple[Any, Any] | None]:
    """The two sides for each of some motions; None where a side has no finite real value."""
    sides = sides_of(link, model)
    flat = [e for side in sides for e in (side if is_matrix(side) else [sympy.sympify(side)])]
    count = len(sides[0]) if is_matrix(sides[0]) else 1
    free = set().union(*(e.free_symbols for e in flat))
    made: list[tuple[Any, Any] | None] = []
    for sample in samples:
        row = [*map(floats.at(sample.point), flat)] if free <= {*sample.point} else [math.nan]
        numbers = [*map(sympy.Float, row)] if all(map(math.isfinite, row)) else []
        pair = [
            sympy.Matrix(*side.shape, part) if is_matrix(side) else part[0]
            for side, part in zip(sides, (numbers[:count], numbers[count:]), strict=True)
            if numbers
        ]
        made.append((pair[0], pair[1]) if pair else None)
    return made


def apart(left: Expr, right: Expr) -> bool:
    """Whether two values differ by more than rounding."""
    size = 1 + max(abs(e) for side in (left, right) for e in (side if is_matrix(side) else [side]))
    return any(floats.holds("≠", difference, size) for difference in entries(left, right))


def is_shown(link: Link, model: Model) -> bool:
    """Whether the difference of the sides has the normal form 0."""
    return all(decide.vanishes(one_angle(gap)) for gap in entries(*sides_of(link, model)))


def one_angle(expression: Expr) -> Expr:
    """Angles such as Ω_b t, however they are typed, in lowest terms."""
    angles = {f.args[0] for f in expression.atoms(sin, cos) if not f.args[0].is_Symbol}
    return expression.xreplace({angle: sympy.cancel(angle) for angle in angles})


def is_matrix(side: Expr) -> bool:
    return isinstance(side, MatrixBase)


def pair_text(found: Any, other: Expr, digits: int = 6) -> str:
    """One side of two; what is nothing beside the largest number in them is 0."""
    largest = max(abs(e) for side in (found, other) for e in (side if is_matrix(side) else [side]))

    def shown(number: Any) -> str:
        return "0" if abs(number) <= _NOISE * largest else number_text(number, digits)

    return "[" + ", ".join(map(shown, found)) + "]" if is_matrix(found) else shown(found)


_NOISE = 1e-13


def number_text(found: Any, digits: int = 6) -> str:
    """A number as it is read aloud."""
    if not found.is_Float:
        return text(found)
    return f"{float(found):.{digits}g}".replace("-", "−")


def counterexample(link: Link, verdict: Verdict) -> str:
    """The motion at which a link fails, in the symbols that stand in it, and its two sides."""
    assert verdict.at is not None
    point, meaning = verdict.at.point, verdict.at.meaning
    typed = sorted(_letters(link), key=str)
    values = {x: point.get(x, meaning.get(x)) for x in typed}
    if any(is_matrix(value) for value in values.values()) or link.right is None:
        values |= point
    numbers = {x: v for x, v in values.items() if v is not None and not is_matrix(v)}
    where = ", ".join(f"{text(x)} = {number_text(v)}" for x, v in numbers.items())
    at, one, other = f"at {where}: " * bool(where), verdict.left, verdict.right
    left, right = pair_text(one, other), pair_text(other, one)
    if left == right:
        left, right = pair_text(one, other, digits=15), pair_text(other, one, digits=15)
    if link.right is None:
        return f"{at}the rate is {left}, not 0"
    return f"{at}the left side is {left}, the right side {right}"


def _letters(link: Link) -> set[Expr]:
    """The letters of a link; a slope is one thing."""
    todo, found = [link.left, *([] if link.right is None else [link.right])], set[Expr]()
    while todo:
        node = todo.pop()
        if isinstance(node, (Symbol, Partial)):
            found.add(node)
        else:
            todo += [*node] if is_matrix(node) else [*node.args]
    return found
