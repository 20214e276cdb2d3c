r"""Statements become equations of SymPy, in the letters of a notation.

>>> from rigidtop.notation import NOTES
>>> from rigidtop.typeset.text import text
>>> [line] = equations(r"\lambda_1\cos\theta\,\Omega^2 = L_3\Omega - MgR \tag{3.57}", NOTES)
>>> text(line.equation), line.tag
('λ₁ cos θ Ω² = L₃Ω − MgR', '3.57')
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

from rigidtop.notation import NOTES, Notation
from rigidtop.proof.equation import Equation
from rigidtop.read.expressions import Expressions, is_of_matrices
from rigidtop.read.kinds import UnknownError, of_one_kind
from rigidtop.read.macros import PACKAGES, Macros
from rigidtop.read.sizes import checked_size
from rigidtop.read.statements import Read, is_conditional, statements
from rigidtop.theory.symbols import Glyph
from rigidtop.tree import nodes as n
from rigidtop.tree.plain import plain
from rigidtop.tree.several import each_index, each_sign
from rigidtop.tree.statement import Statement, Unread


@dataclass(frozen=True)
class ReadEquation:
    """An equation that was read, or why it was not.

    `position` is where it begins in the text, or where what can't be read stands; `tag`
    is the equation's number.
    """

    position: int
    equation: Equation | None
    problem: str = ""
    tag: str = ""


def equations(
    text: str, notation: Notation = NOTES, macros: Macros = PACKAGES
) -> tuple[ReadEquation, ...]:
    """The equations of a formula, in order, each read or with the reason why not.

    Nothing of the text is evaluated, and its size and depth are limited, and its powers.
    """
    lines: list[ReadEquation] = []
    differentials = Glyph("d") not in notation.names  # beside a letter d, dx is a product
    for each in _whole(statements(text, macros, differentials=differentials)):
        if isinstance(each, Unread):
            lines.append(ReadEquation(each.position, None, each.reason, each.tag))
        else:
            lines += _of_each(each, notation)
    return tuple(lines)


def _of_each(statement: Statement, notation: Notation) -> list[ReadEquation]:
    """The lines of a statement; of both signs of ±; of ω₁ and ω₂, where ω_{1,2} is no symbol."""
    for several in (each_sign, each_index):
        statements = [*several(statement)]
        lines = [line for each in statements for line in _lines(each, notation)]
        if all(line.equation for line in lines):
            return lines
    return _lines(statement, notation)


def _whole(read: Read) -> list[Statement | Unread]:
    """Statements with the rows that go on with them, as one chain."""
    whole: list[Statement | Unread] = []
    for each in read:
        before = whole[-1] if whole else None
        if isinstance(each, Statement) and isinstance(before, Statement) and each.continues:
            sides = (*before.sides, *each.sides[1:])
            relations = (*before.relations, *each.relations)
            whole[-1] = replace(before, sides=sides, relations=relations, tag=each.tag)
        else:
            whole.append(each)
    return whole


def _lines(statement: Statement, notation: Notation) -> list[ReadEquation]:
    """One line, more where the relation changes in a chain."""
    at, tag = statement.position, statement.tag
    if not statement.relations:
        return [ReadEquation(at, None, "no relation: an equation has two sides", tag)]
    if isinstance(statement.sides[0], n.Omitted):
        return [ReadEquation(at, None, "a relation without its left side", tag)]
    if statement.conditions or is_conditional(statement.condition):
        words = statement.condition or ", ".join(map(plain, statement.conditions))
        return [ReadEquation(at, None, f"words inside a formula: {words[:40]!r}", tag)]
    try:
        for side in statement.sides:
            checked_size(side)
        meaning = Expressions(notation)
        matrices = any(is_of_matrices(side, meaning) for side in statement.sides)
        meaning = replace(meaning, matrices=matrices)
        sides = of_one_kind([meaning.of(side) for side in statement.sides])
    except UnknownError as why:
        return [ReadEquation(at, None, str(why), tag)]
    relations = list(statement.relations)
    if {*relations} == {"=", "≡"}:  # p_φ ≡ … = const is one statement
        relations = ["="] * len(relations)
    runs: list[tuple[str, list[Any]]] = []
    for relation, (left, right) in zip(relations, pairwise(sides), strict=True):
        if runs and runs[-1][0] == relation:
            runs[-1][1].append(right)
        else:
            runs.append((relation, [left, right]))
    lines = [ReadEquation(at, Equation(*run, relation=relation)) for relation, run in runs]
    relation, run = runs[-1]
    lines[-1] = ReadEquation(at, Equation(*run, relation=relation, tag=tag), tag=tag)
    return lines
