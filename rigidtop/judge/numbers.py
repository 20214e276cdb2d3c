"""Sides that are numbers, perhaps with units: do they agree to the digits that are written?"""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal
from itertools import pairwise
from math import inf

import sympy
from sympy import Expr, Symbol

from rigidtop.judge.jets import TIME, jets
from rigidtop.judge.outcome import FALSE, SAMPLED, UNDECIDED, Outcome
from rigidtop.tree import nodes as n
from rigidtop.tree.latex import latex
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.plain import plain as in_words


def are_numbers(left: Expr, right: Expr) -> bool:
    """Whether neither side has a letter, and one of them more than an exact number."""
    sides = (sympy.sympify(left), sympy.sympify(right))
    return not any(jets(x) or x.has(TIME) for x in sides) and not any(
        x.atoms(sympy.core.function.AppliedUndef) for x in sides
    )


A_MINUTE = "with the number of turns a minute"
"""Why sides agree of which one is 60 times the other one by what is written."""


def _ratio(left: Expr, right: Expr) -> complex | None:
    """How many times as large the left number is; None where the units of both do not fit."""
    if right == 0 or left == 0:
        return 1 if sympy.N(left - right) == 0 else inf
    ratio = sympy.simplify(left / right)
    return None if ratio.free_symbols else complex(sympy.N(ratio))


def compared(
    left: Node,
    right: Node,
    meant: Sequence[tuple[Expr, Expr]],
    rests_on: frozenset[int] = frozenset(),
    nearly: bool = False,
) -> Outcome:
    """Whether both sides, which mean numbers, agree to the digits with which they are written."""
    digits = max(share(left, nearly), share(right, nearly), 1e-12)
    ratios = [_ratio(*pair) for pair in meant]
    known = [x for x in ratios if x is not None]
    if len(known) < len(ratios):
        return Outcome(UNDECIDED, "the units of both sides do not fit", rests_on)

    def are(factor: float) -> bool:
        return all(abs(x / factor - 1) <= digits for x in known)

    if are(1):
        return Outcome(SAMPLED, "", rests_on)
    if _counts_minutes(left, right, meant) and (are(60) or are(1 / 60)):
        return Outcome(SAMPLED, A_MINUTE, rests_on)
    value = _like(*meant[0], right)
    why = f"the left side is {in_words(value)}"
    return Outcome(FALSE, why, rests_on, "another number", f"{latex(left)} ≈ {latex(value)}")


def _counts_minutes(left: Node, right: Node, meant: Sequence[tuple[Expr, Expr]]) -> bool:
    """Whether turns a minute may be put in as they stand: n in 2π n/60 or in π n/30."""
    formulas = [x for x in (left, right) if n.letters(x) - {Letter("π")}]
    numbers = (x for side in formulas for x in n.walked(side) if isinstance(x, n.Number))
    in_seconds = all(x.free_symbols == {_SECOND} for pair in meant for x in pair)
    return in_seconds and any(x.value in (30, 60) for x in numbers)


_SECOND = Symbol("unit s", positive=True)


def _like(value: Expr, other: Expr, like: Node) -> Node:
    """A number as another one is written, in its unit and with as many digits."""
    match like:
        case n.Product((n.Number() as number, *units)) if other and not n.letters(like):
            share_of_it = sympy.simplify(value / other) * sympy.sympify(number.text)
            return n.Product((_signed(rounded(share_of_it, like)), *units))
    return _signed(rounded(value, like))


def _signed(text: str) -> Node:
    number = n.Number(text.lstrip("-"))
    return n.Negative(number) if text.startswith("-") else number


def share(node: Node, nearly: bool = False) -> float:
    """By which share a number may be off that is written with so many digits; 0 if it is exact.

    Where it is said to be `nearly` so, whole numbers are rounded too, unless letters stand by them.
    """
    nearly = nearly and not n.letters(node)
    powers = {
        part for x in n.walked(node) if isinstance(x, n.Power) for part in n.walked(x.exponent)
    }
    # 5 · 10⁹ is rounded, as 5 is not.
    mantissas = {
        first
        for x in n.walked(node)
        if isinstance(x, (n.Product, n.CrossProduct, n.DotProduct))
        for first, second in pairwise(n.parts(x))
        if isinstance(second, n.Power) and second.base == n.Number("10")
    }
    shares = [
        float(Decimal(1).scaleb(_exponent(x.text, nearly)) / abs(Decimal(x.text)))
        for x in n.walked(node)
        if isinstance(x, n.Number) and x.value
        if "." in x.text or x in mantissas or (x not in powers and (nearly or len(x.text) > 2))
    ]
    return max(shares, default=0.0)


def rounded(value: Expr, like: Node) -> str:
    """A number with as many digits as another one is written with, its units aside."""
    off = share(like)
    figures = max(2, len(f"{1 / off:.0f}")) if off else 3
    number, _ = sympy.N(value).as_coeff_Mul()
    return f"{float(number):.{figures}g}"


def _exponent(text: str, nearly: bool = False) -> int:
    """The place of the last digit that counts; of 2470, which is `nearly` so, that of the 7."""
    exponent = Decimal(text).as_tuple().exponent
    zeros = len(text) - len(text.rstrip("0"))
    if nearly and text.isdigit() and zeros:
        return min(zeros, max(len(text) - _FIGURES, 0))
    return exponent if isinstance(exponent, int) else 0


_FIGURES = 2
"""Zeros at the end of a rounded number count up to so many figures."""
