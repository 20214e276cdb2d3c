"""Letters with an index that name a value at a special place: θ₀ at the start, v_q at r = q."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

from rigidtop.judge.context import SETTING, START, Constraint, Context
from rigidtop.judge.sides import is_setting, letters_in
from rigidtop.judge.situation import Situation
from rigidtop.judge.starts import COORDINATES
from rigidtop.tree.nodes import Letter, Node, Number, Rate, mapped
from rigidtop.tree.statement import Statement


def placed(statement: Statement, at: Situation, context: Context) -> Context | None:
    """What is known where new letters are values at the place of which the words speak.

    None if they speak of none.
    """
    instant = at.instant or (START if at.begins else "")
    names_it = is_setting(statement.sides[0], statement.sides[-1], ())
    somewhere = instant or at.balanced or at.circular or (at.vanishes and context.said is not None)
    if names_it or not somewhere:
        return None
    fixed = frozenset().union(*(each.letters for each in context.constraints))
    known = fixed | context.definitions.keys() | context.given | context.declared
    new = {x: replace(x, sub="") for x in letters_in(statement) if x.sub and x not in known}
    counts = Counter(new.values())
    for name, letter in sorted(new.items(), key=str):
        if counts[letter] > 1 or letter not in context.letters or (at.begins and name.sub != "0"):
            continue
        value = Constraint(name, letter, at.number, SETTING, at.scope, instant, at.sentence)
        context = context.holding(value)
    if at.vanishes and context.said is not None:
        zero = Constraint(context.said, Number("0"), at.number, SETTING, at.scope, "", at.sentence)
        context = context.holding(zero)
    still = COORDINATES if at.balanced else _RADII if at.circular else frozenset()
    for letter in sorted(context.habits.moving - context.definitions.keys(), key=str):
        context = _still(letter, at, context) if letter.base in still else context
    return context


def with_rates(statement: Statement, context: Context) -> Statement:
    """A statement with the rate of φ where the one of a new letter φ₁ is written."""

    def change(node: Node) -> Node:
        if isinstance(node, Rate) and isinstance(node.of, Letter) and node.of.sub:
            bare = replace(node.of, sub="")
            if bare in context.habits.moving and node.of not in context.letters:
                return replace(node, of=bare)
        return node

    return replace(statement, sides=tuple(mapped(side, change) for side in statement.sides))


_RADII = frozenset("rρ")


def _still(letter: Letter, at: Situation, context: Context) -> Context:
    """What is known where a coordinate does not change."""
    for order in (1, 2):
        rate = Rate(letter, order, True)
        still = Constraint(rate, Number("0"), at.number, SETTING, at.scope, "", at.sentence)
        context = context.holding(still)
    return context
