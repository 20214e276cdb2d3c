"""Two sides of a line, and whether they are equal for every motion of a model."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import sympy
from sympy import Expr, MatrixBase, cos, sin

from rigidtop.mark import facts
from rigidtop.mark.facts import Model, Sample
from rigidtop.proof import decide
from rigidtop.proof.equation import NoMeaningError, Rate, value
from rigidtop.proof.verdict import entries
from rigidtop.theory import symbols as s
from rigidtop.typeset.text import text


@dataclass(frozen=True)
class Link:
    """Two neighbouring sides.  `right` None: the left one is constant."""

    left: Any
    right: Any


@dataclass(frozen=True)
class Verdict:
    """True, false with a motion at which it fails, or (None) neither shown nor refuted."""

    holds: bool | None
    at: Sample | None = None
    left: Any = None
    right: Any = None
    why: str = ""


_TOLERANCE = sympy.Float("1e-15")
ERRORS = (ArithmeticError, TypeError, ValueError, AttributeError, NoMeaningError)
FEWEST = 6
"""A line that has values at fewer motions than this is not judged."""


def judge(link: Link, model: Model) -> Verdict:
    """Whether a link holds for every motion of a model."""
    try:
        symbolic = rates_of(link, model)
        defined = 0
        refuted: Verdict | None = None
        for sample in facts.samples(model):
            sides = in_numbers(link, model, sample, symbolic)
            if sides is None:
                continue
            defined += 1
            if apart(*sides):
                refuted = refuted or Verdict(False, sample, *sides)
                if pair_text(*sides) != pair_text(*reversed(sides)):
                    return Verdict(False, sample, *sides)
        if refuted is not None:
            return refuted
        if defined < FEWEST:
            return Verdict(None, why="it has a value for hardly any motion")
        return Verdict(True if is_shown(link, model) else None, why="neither shown nor refuted")
    except ERRORS as error:
        return Verdict(None, why=f"it says nothing that can be compared: {error}")
    except RecursionError:
        return Verdict(None, why="nested too deeply")


def rates_of(link: Link, model: Model) -> dict[Any, Any]:
    """The values of the derivatives in a link, once for all motions."""
    found: dict[Any, Any] = {}
    for side in (link.left, link.right):
        if side is None:
            continue
        for tree in side if _is_matrix(side) else [side]:
            for rate in tree.atoms(Rate):
                found[rate] = model.value(rate)
    if link.right is None:
        found[s.const] = model.rate(link.left)
    return found


def in_numbers(
    link: Link, model: Model, sample: Sample, symbolic: Mapping[Any, Any]
) -> tuple[Any, Any] | None:
    """The two sides for one motion; None where a side has no finite real value."""
    point = {x: facts.number(v) for x, v in sample.point.items()}

    def number(found: Any) -> Any:
        if _is_matrix(found):
            return found.applyfunc(number)
        return sympy.N(sympy.sympify(found).xreplace(point), facts.DIGITS)

    rates = {node: number(found) for node, found in symbolic.items()}
    if link.right is None:
        left: Any = rates[s.const]
        right: Any = sympy.zeros(*left.shape) if _is_matrix(left) else sympy.Integer(0)
    else:
        meaning = {**sample.meaning, **rates}
        left, right = (number(value(side, meaning)) for side in (link.left, link.right))
    flat = [e for side in (left, right) for e in (side if _is_matrix(side) else [side])]
    return (left, right) if all(e.is_number and e.is_finite and e.is_real for e in flat) else None


def apart(left: Any, right: Any) -> bool:
    """Whether two values in digits differ by more than rounding."""
    size = 1 + max(abs(e) for side in (left, right) for e in (side if _is_matrix(side) else [side]))
    return any(abs(difference) > _TOLERANCE * size for difference in entries(left, right))


def is_shown(link: Link, model: Model) -> bool:
    """Whether the difference of the sides has the normal form 0."""
    if link.right is None:
        left, right = model.rate(link.left), sympy.Integer(0)
    else:
        left, right = model.value(link.left), model.value(link.right)
    return all(decide.vanishes(one_angle(difference)) for difference in entries(left, right))


def one_angle(expression: Expr) -> Expr:
    """Angles such as Ω_b t, however they are typed, in lowest terms."""
    angles = {f.args[0] for f in expression.atoms(sin, cos) if not f.args[0].is_Symbol}
    return expression.xreplace({angle: sympy.cancel(angle) for angle in angles})


def _is_matrix(side: Any) -> bool:
    return isinstance(side, MatrixBase)


def pair_text(found: Any, other: Any, digits: int = 6) -> str:
    """One side of two; what is nothing beside the largest number in them is 0."""
    largest = max(abs(e) for side in (found, other) for e in (side if _is_matrix(side) else [side]))

    def shown(number: Any) -> str:
        return "0" if abs(number) <= _NOISE * largest else number_text(number, digits)

    return "[" + ", ".join(map(shown, found)) + "]" if _is_matrix(found) else shown(found)


_NOISE = sympy.Float("1e-25")


def number_text(found: Any, digits: int = 6) -> str:
    """A number as it is read aloud."""
    if not found.is_Float:
        return text(found)
    return f"{float(found):.{digits}g}".replace("-", "−")
