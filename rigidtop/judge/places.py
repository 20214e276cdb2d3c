"""Letters with an index that name a value at a special place: θ₀ at the start, v_q at r = q."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

from rigidtop.judge.context import SETTING, START, TIME, Constraint, Context
from rigidtop.judge.sides import is_setting, letters_in, moving_in, named
from rigidtop.judge.situation import Situation
from rigidtop.judge.starts import COORDINATES
from rigidtop.tree.nodes import Letter, Node, Number, Rate, letters, mapped
from rigidtop.tree.statement import Statement

_RADII = frozenset("rρ")
"""What stays the same on a circle."""


def placed(statement: Statement, at: Situation, context: Context) -> Context | None:
    """What is known where new letters are values at the place of which the words speak.

    None if they speak of none.
    """
    instant = at.instant or (START if at.begins else "")
    names_it = is_setting(statement.sides[0], statement.sides[-1], ())
    zero = context.said if at.vanishes else None
    still = _still(at, context)
    somewhere = instant or at.balanced or at.circular or zero is not None
    # Where each of its terms vanishes a line would say nothing.
    rates = moving_in(statement) & {*still}
    if names_it or rates or not somewhere or _speaks_of(statement, zero):
        return None
    fixed = frozenset().union(*(each.letters for each in context.constraints))
    spoken = frozenset().union(*(letters(x.node) for x in context.definitions.values()))
    known = fixed | spoken | context.definitions.keys() | context.given | context.declared
    new = {x: replace(x, sub="") for x in letters_in(statement) if x.sub and x not in known}
    counts = Counter(new.values())
    for name, letter in sorted(new.items(), key=str):
        if counts[letter] > 1 or letter not in context.letters | {TIME}:
            continue
        if at.begins and name.sub != "0":
            continue
        value = Constraint(name, letter, at.number, SETTING, at.scope, instant, at.sentence)
        context = context.holding(value)
    zeros: list[Node] = [] if zero is None else [zero]
    zeros += [Rate(letter, order, True) for letter in still for order in (1, 2)]
    for side in zeros:
        none = Constraint(side, Number("0"), at.number, SETTING, at.scope, "", at.sentence)
        context = context.holding(none)
    return context


def _speaks_of(statement: Statement, side: Node | None) -> bool:
    """Whether the letter that a side is stands in a statement."""
    return side is not None and named(side)[0] in letters_in(statement)


def _still(at: Situation, context: Context) -> list[Letter]:
    """The coordinates that do not change where the words say that a motion is."""
    bases = COORDINATES if at.balanced else _RADII if at.circular else frozenset()
    moving = context.habits.moving - context.definitions.keys()
    return sorted((x for x in moving if x.base in bases), key=str)


def with_rates(statement: Statement, context: Context) -> Statement:
    """A statement with the rate of φ where the one of a new letter φ₁ is written."""

    def change(node: Node) -> Node:
        if isinstance(node, Rate) and isinstance(node.of, Letter) and node.of.sub:
            bare = replace(node.of, sub="")
            if bare in context.habits.moving and node.of not in context.letters:
                return replace(node, of=bare)
        return node

    return replace(statement, sides=tuple(mapped(side, change) for side in statement.sides))
