"""Formulas in LaTeX become equations.

>>> from rigidtop.typeset.text import text
>>> [line] = read(r"\\lambda_1\\cos\\theta\\,\\Omega^2 = L_3\\Omega - MgR \\tag{3.57}")
>>> text(line.equation), line.tag
('λ₁ cos θ Ω² = L₃Ω − MgR', '3.57')
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise, takewhile
from typing import Any

from sympy import Add, MatrixBase, Mul, Pow

from rigidtop.notation import MATRICES, NOTES, Notation
from rigidtop.proof.equation import At, Equation, Group
from rigidtop.read.build import parsed
from rigidtop.read.called import NAMED
from rigidtop.read.cursor import Token
from rigidtop.read.cut import Part, parts
from rigidtop.read.habits import NO_HABITS, Habits
from rigidtop.read.macros import expanded
from rigidtop.read.scan import Scan, limited
from rigidtop.read.signs import ACTED_ON
from rigidtop.read.tex import UnreadError, pieces
from rigidtop.read.values import kind as kind
from rigidtop.theory import symbols as s
from rigidtop.theory.lettered import Lettered


@dataclass(frozen=True)
class Line:
    """An equation that was read, or why it was not.

    `position` is where it begins in the text, or where what can't be read stands; `tag`
    is the equation's number.
    """

    position: int
    equation: Equation | None
    problem: str = ""
    tag: str = ""
    condition: str = ""
    """Words behind it, such as "for small angles", as they are written."""


def read(
    text: str,
    notation: Notation = NOTES,
    habits: Habits = NO_HABITS,
) -> tuple[Line, ...]:
    """The equations of a formula, in order, each read or with the reason why not.

    A notation that is `open` takes letters that it does not know, and any author's ways of writing.
    Text from strangers is welcome: nothing of it is evaluated, and its size and depth are limited.
    """
    try:
        found = scanned(text, notation, habits)
    except UnreadError as error:
        return (Line(error.position, None, error.reason),)
    lines = tuple(line for part in parts(found, text) for line in _read(part, notation))
    if notation.open or habits.conditions:
        return lines
    return tuple(_unconditioned(line) for line in lines)


def _unconditioned(line: Line) -> Line:
    """A line without words behind it; one that has some is unread."""
    if not line.condition:
        return line
    reason = f"words inside a formula: {line.condition[:40]!r}"
    return Line(line.position, None, reason, line.tag)


def scanned(text: str, notation: Notation, habits: Habits) -> list[Token]:
    """The tokens of a formula, its macros put in."""
    items = expanded(pieces(text), habits.macros)
    found = limited(Scan(items, notation, habits))
    here = _with(habits, found, text) if notation.open else habits
    return found if here == habits else limited(Scan(items, notation, here))


def with_habits(habits: Habits, text: str, notation: Notation) -> Habits:
    """What is known of an author's letters, with what one more formula says of them."""
    items = expanded(pieces(text), habits.macros)
    return _with(habits, limited(Scan(items, notation)), text)


def _with(habits: Habits, found: Sequence[Token], text: str) -> Habits:
    functions, timed = set(habits.functions), set(habits.timed)
    for i, token in enumerate(found):
        if not isinstance(token.value, Lettered):
            continue
        glyph = token.value.quantity.glyph
        behind = found[i + 1] if i + 1 < len(found) else Token("", "", len(text))
        if behind.kind == "OF":
            inside = takewhile(lambda token: token.kind != "FO", found[i + 2 :])
            among = [x.value for x in inside if isinstance(x.value, Lettered)]
            functions |= {(glyph, x.quantity.glyph.base) for x in among} or {(glyph, "")}
        if _OF_TIME.search(text, token.position, behind.position):
            timed.add(glyph)
    return replace(habits, functions=frozenset(functions), timed=frozenset(timed))


_OF_TIME = re.compile(r"\(\s*t\s*(?:\\right)?\)")


def _read(part: Part, notation: Notation) -> list[Line]:
    """One line, more where a symbol has two indices, or where the relation changes in a chain."""
    try:
        if part.problem is not None:
            raise part.problem
        lines = [
            replace(line, condition=", ".join(filter(None, (condition, part.condition))))
            for chosen, condition in _choices(part.tokens)
            for line in _lines(chosen, notation)
        ]
    except UnreadError as error:
        return [Line(error.position, None, error.reason, part.tag)]
    if part.tag:
        last = lines[-1]
        assert last.equation is not None
        numbered = Equation(*last.equation.sides, relation=last.equation.relation, tag=part.tag)
        lines[-1] = replace(last, equation=numbered, tag=part.tag)
    return lines


def _choices(found: Sequence[Token]) -> list[tuple[list[Token], str]]:
    """ω_{1,2} = … are two equations, a = ±b too, and each of several cases with its condition."""
    several = [t for t in found if t.kind in _SEVERAL]
    if not several:
        return [(list(found), "")]
    counts = {len(t.value): t.position for t in several}
    if len(counts) > 1:
        raise UnreadError("lists of indices of different lengths", max(counts.values()))
    branches = sum(t.kind == "BRANCHES" for t in several)
    if branches and len(several) > 1:
        raise UnreadError("cases beside other choices", several[0].position)
    [count] = counts
    made = []
    for i in range(count):
        chosen: list[Token] = []
        for token in found:
            if token.kind == "BRANCHES":
                chosen += token.value[i][0]
            elif token.kind in _SEVERAL:
                chosen.append(Token(_SEVERAL[token.kind], token.value[i], token.position))
            else:
                chosen.append(token)
        made.append((chosen, several[0].value[i][1] if branches else ""))
    return made


_SEVERAL = {"CHOICE": "SYMBOL", "SIGNS": "SIGN", "BRANCHES": ""}


_WRITTEN_OUT = frozenset({"TRANSPOSED", "MATRIX"})


def _is_vector(token: Token) -> bool:
    return token.kind == "SYMBOL" and kind(token.value) == "vector"


def _of_its_kind(found: Sequence[Token]) -> list[Token]:
    """A is an amplitude, beside matrices and in front of a vector a matrix."""
    among = {t.value for t in found if t.kind == "SYMBOL"}
    named = any(t.kind == "FUNCTION" and t.value in NAMED for t in found)
    acts = any(t.value == s.A and _is_vector(behind) for t, behind in pairwise(found))
    if not (acts or named or among & MATRICES or any(t.kind in _WRITTEN_OUT for t in found)):
        return list(found)
    return [replace(t, value=s.A_matrix) if t.value == s.A else t for t in found]


def _is_eigen(sides: Sequence[Any]) -> bool:
    """Whether it is an equation such as Lu = μu: nobody writes a factor that cancels."""
    factors = list(_factors(sides[0]))
    if len(factors) != 2:
        return False
    acts, on = factors
    if not (isinstance(acts, Lettered) and isinstance(on, (Lettered, At))):
        return False
    above = acts.quantity.glyph.base[0].isupper() and not acts.quantity.glyph.bold
    named = isinstance(on, At) or on.quantity.glyph.base in ACTED_ON
    return above and named and any(on in list(_factors(side))[1:] for side in sides[1:])


def _is_small_power(side: Any) -> bool:
    """Whether it is λ⁴: a power of a small letter, which is no matrix."""
    powers = [x for x in _factors(side) if isinstance(x, Pow) and isinstance(x.base, Lettered)]
    alone = isinstance(side, Pow)
    return any(
        x.base.quantity.glyph.base.islower() and (alone or (x.exp.is_Integer and x.exp > 3))
        for x in powers
    )


def _is_conjugate(side: Any) -> bool:
    """Whether a letter and its inverse stand in a product, such as RAR⁻¹: a number would cancel."""
    for term in side.args if isinstance(side, Add) else (side,):
        factors = list(_factors(term))
        inverse = {x.base for x in factors if isinstance(x, Pow) and x.exp.args == (-1, 1)}
        if any(isinstance(x, Lettered) and x in inverse for x in factors):
            return True
        maps = any(x.quantity.glyph.base in "fghφψ" for x in inverse if isinstance(x, Lettered))
        if maps and any(isinstance(x, At) for x in factors):
            return True
    return False


def _factors(side: Any) -> Iterator[Any]:
    """What a product is made of, without its sign."""
    if isinstance(side, Group):
        side = side.args[0]
    if not isinstance(side, Mul):
        yield from () if side == -1 else (side,)
        return
    for factor in side.args:
        yield from _factors(factor)


def _lines(found: Sequence[Token], notation: Notation) -> list[Line]:
    position = found[0].position
    sides, relations = parsed(_of_its_kind(found), notation)
    if not relations:
        raise UnreadError("no relation: an equation has two sides", position)
    if notation.open and _is_eigen(sides):
        raise UnreadError("an operator before what it acts on, or a factor?", position)
    if notation.open and any(map(_is_conjugate, sides)):
        raise UnreadError("a letter and what undoes it: numbers, or operators?", position)
    matrix = any(isinstance(side, MatrixBase) for side in sides)
    if notation.open and matrix and any(map(_is_small_power, sides)):
        raise UnreadError("a power of a letter is a matrix: an index, or a power?", position)
    if set(relations) == {"=", "≡"}:  # p_φ ≡ … = const is one statement
        relations = ["="] * len(relations)
    lines = []
    start = 0
    for i in range(1, len(relations) + 1):
        if i == len(relations) or relations[i] != relations[start]:
            equation = Equation(*sides[start : i + 1], relation=relations[start])
            lines.append(Line(position, equation))
            start = i
    return lines
