"""Sides that are numbers, perhaps with units: do they agree to the digits that are written?"""

from __future__ import annotations

from collections.abc import Sequence
from decimal import Decimal
from itertools import pairwise

import sympy
from sympy import Expr, Rational

from rigidtop.judge.jets import TIME, jets
from rigidtop.judge.outcome import FALSE, SAMPLED, UNDECIDED, Outcome
from rigidtop.tree import nodes as n
from rigidtop.tree.latex import latex
from rigidtop.tree.nodes import Node
from rigidtop.tree.plain import plain as in_words


def are_numbers(left: Expr, right: Expr) -> bool:
    """Whether neither side has a letter, and one of them more than an exact number."""
    sides = (sympy.sympify(left), sympy.sympify(right))
    return not any(jets(x) or x.has(TIME) for x in sides) and not any(
        x.atoms(sympy.core.function.AppliedUndef) for x in sides
    )


def agree(left: Expr, right: Expr, digits: float) -> bool | None:
    """Whether two numbers agree up to a share of them; None where their units do not fit."""
    if right == 0 or left == 0:
        return bool(sympy.N(left - right) == 0)
    ratio = sympy.simplify(left / right)
    if ratio.free_symbols:
        return None
    return bool(abs(complex(sympy.N(ratio)) - 1) <= digits)


def compared(
    left: Node,
    right: Node,
    meant: Sequence[tuple[Expr, Expr]],
    rests_on: frozenset[int] = frozenset(),
    nearly: bool = False,
) -> Outcome:
    """Whether both sides, which mean numbers, agree to the digits with which they are written."""
    digits = max(share(left, nearly), share(right, nearly), 1e-12)
    answers = [agree(*pair, digits) for pair in meant]
    if all(answers):
        return Outcome(SAMPLED, "", rests_on)
    if in_minutes(left, right, meant, digits):
        return Outcome(SAMPLED, "with the number of turns a minute", rests_on)
    if None in answers:
        return Outcome(UNDECIDED, "the units of both sides do not fit", rests_on)
    value = _like(*meant[0], right)
    why = f"the left side is {in_words(value)}"
    return Outcome(FALSE, why, rests_on, "another number", f"{latex(left)} ≈ {latex(value)}")


def in_minutes(left: Node, right: Node, meant: Sequence[tuple[Expr, Expr]], digits: float) -> bool:
    """Whether a number of turns a minute stands for itself beside a 60: ω = 2π n/60."""
    sixty = any(x == n.Number("60") for side in (left, right) for x in n.walked(side))
    ratios = (sympy.simplify(a / b) for a, b in meant if a != 0 != b)
    turned = [x for x in ratios if not x.free_symbols]
    return (
        sixty
        and bool(turned)
        and all(
            any(abs(complex(sympy.N(x * f)) - 1) <= digits for f in (60, Rational(1, 60)))
            for x in turned
        )
    )


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
        if isinstance(x, (n.Product, n.Cross, n.Dot))
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


_FIGURES = 3
"""Zeros at the end of a rounded number count up to so many figures."""
