"""Letters with an index that name a value at a special place: θ₀ at the start, v_q at r = q."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import replace

from rigidtop.judge.context import PREMISE, SETTING, START, Constraint, Context
from rigidtop.judge.letters import ANGLES, CLOCK, COORDINATES, is_mass
from rigidtop.judge.sides import is_setting, letters_in, moving_in, named
from rigidtop.judge.situation import Situation
from rigidtop.read.phrases import Cue
from rigidtop.tree.nodes import (
    Derivative,
    Letter,
    Node,
    Number,
    Power,
    TimeDerivative,
    letters,
    mapped,
)
from rigidtop.tree.statement import Statement

_RADII = frozenset("rρ")
"""What stays the same on a circle."""


def placed(statement: Statement, at: Situation, context: Context) -> list[Context]:
    """What is known where new letters are values at the place of which the words speak.

    Where they speak of none there is none; what the line above is may vanish in two ways: the
    letter that it is about, or what that is equal to, whatever else it would make vanish.
    """
    instant = at.instant or (START if at.begins else "")
    names_it = is_setting(statement.sides[0], statement.sides[-1], ())
    zeros = _zeros(statement, at, context)
    still = _still(at, context)
    # Where each of its terms vanishes a line would say nothing.
    rates = moving_in(statement) & {*still}
    if names_it or rates or not (instant or at.balanced or at.circular or zeros):
        return []
    fixed = frozenset().union(*(each.letters for each in context.constraints))
    spoken = frozenset().union(*(letters(x.node) for x in context.definitions.values()))
    known = fixed | spoken | context.definitions.keys() | context.given | context.declared
    new = {x: replace(x, sub="") for x in letters_in(statement) if x.sub and x not in known}
    counts = Counter(new.values())
    for name, letter in sorted(new.items(), key=str):
        if counts[letter] > 1 or letter not in context.letters | {CLOCK}:
            continue
        if at.begins and name.sub != "0":
            continue
        value = Constraint(name, letter, at.number, SETTING, at.scope, instant, at.sentence)
        context = context.holding(value)
    rest = [TimeDerivative(letter, order, True) for letter in still for order in (1, 2)]
    context = _vanishing(context, at, rest)
    if not zeros:
        return [context]
    first, *others = zeros
    kept = tuple(c for c in context.constraints if c.kind != PREMISE)
    bare = replace(context, constraints=kept)
    return [_vanishing(context, at, [first]), *(_vanishing(bare, at, [x]) for x in others)]


def alike(at: Situation, context: Context) -> Context | None:
    """What is known where two masses are equal, in one sentence; None if words do not say so."""
    free = context.letters - context.definitions.keys()
    masses = sorted(filter(is_mass, free), key=str)
    if Cue.EQUAL_MASSES not in at.cues or len(masses) != 2:
        return None
    one, other = masses
    equal = Constraint(one, other, at.number, SETTING, at.scope, "", at.sentence)
    return context.holding(equal)


THERE = "there"
"""The instant at which a motion is where it could stay."""


def resting(at: Situation, context: Context) -> Context:
    """What is known where everything rests for an instant."""
    moving = context.habits.moving - context.definitions.keys()
    still = sorted((x for x in moving if x.base in COORDINATES), key=str)
    for rate in (TimeDerivative(x, 1, True) for x in still):
        none = Constraint(rate, Number("0"), at.number, SETTING, at.scope, THERE)
        context = context.holding(none)
    return context


def solution(statement: Statement, at: Situation, context: Context) -> Context:
    """What is known where a statement holds at that instant.

    A new letter with an index is the value of the one without.
    """
    left, right = statement.sides
    for name in sorted(letters_in(statement) - context.letters, key=str):
        letter = replace(name, sub="")
        if name.sub == "0" and letter in context.habits.moving:
            value = Constraint(letter, name, at.number, SETTING, at.scope, THERE)
            context = context.holding(value)
    return context.holding(Constraint(left, right, at.number, SETTING, at.scope, THERE))


def rests(statement: Statement, at: Situation, context: Context) -> Context | None:
    """What is known where a coordinate rests at θ₀, of which the statement says where that is.

    None if it is where a motion begins, or speaks of rates.
    """
    moving = context.habits.moving - context.definitions.keys()
    names = [x for x in letters_in(statement) if x.sub == "0" and x.base in COORDINATES]
    pairs = [(replace(x, sub=""), x) for x in names]
    kept = [c for c in context.constraints if (c.left, c.right) in pairs and c.left in moving]
    begins = any(
        c.instant == START and isinstance(c.left, TimeDerivative) for c in context.constraints
    )
    begins |= START in context.instants or any(CLOCK in letters(x) for x in statement.sides)
    if len(kept) != 1 or begins or moving_in(statement) or at.instant:
        return None
    still = sorted((x for x in moving if x.base in COORDINATES), key=str)
    context = context.holding(replace(kept[0], instant="", until=at.sentence))
    return _vanishing(
        context, at, [TimeDerivative(x, order, True) for x in still for order in (1, 2)]
    )


def begun(statement: Statement, at: Situation, context: Context) -> Context | None:
    """What is known where a new letter is where a motion begins that begins at rest.

    None if there are several, or if it is said where it begins.
    """
    begins = [c for c in context.constraints if c.instant == START]
    still = {
        c.left.of for c in begins if isinstance(c.left, TimeDerivative) and c.right == Number("0")
    }
    placed = {c.left for c in begins}
    free = [x for x in still if isinstance(x, Letter) and x not in placed and x.base in COORDINATES]
    spoken = frozenset().union(*(letters(x.node) for x in context.definitions.values()))
    fixed = frozenset().union(*(each.letters for each in context.constraints))
    known = fixed | spoken | context.definitions.keys() | context.given | context.habits.moving
    new = letters_in(statement) - known
    given = statement.sides[0] in new | context.habits.moving
    if len(new) != 1 or len(free) != 1 or given:
        return None
    [name], [letter] = new, free
    if (name.base in ANGLES) != (letter.base in ANGLES):
        return None
    return context.holding(Constraint(letter, name, at.number, PREMISE, at.scope, START))


def _zeros(statement: Statement, at: Situation, context: Context) -> list[Node]:
    """What is zero there: what the line above is about, what that is equal to, or its slope."""
    if not context.said or _speaks_of(statement, context.said[0]):
        return []
    sides = [context.said[0], context.said[-1]] if at.vanishes else []
    sides += _slopes(statement, context) if at.extreme else []
    return [x for x in dict.fromkeys(sides) if x != Number("0") and not _speaks_of(statement, x)]


def _slopes(statement: Statement, context: Context) -> list[Node]:
    """The slopes of what the line above is about by the letter that is given a value.

    Where none is given one, by any letter of which the statement says something.
    """
    side = statement.sides[0]
    letter = side.base if isinstance(side, Power) else side
    names = {letter} if isinstance(letter, Letter) else letters_in(statement)
    bare = {x if x in context.letters else replace(x, sub="") for x in names}
    said = context.said[-1]
    values = [d.node for d in context.definitions.values()]
    return [
        Derivative(said, (x,))
        for x in sorted(bare & letters(said), key=str)
        if sum(x in letters(node) for node in values) < 2  # else it may be of another one
    ]


def _vanishing(context: Context, at: Situation, sides: Iterable[Node]) -> Context:
    """What is known where some sides are zero, in one sentence."""
    for side in sides:
        none = Constraint(side, Number("0"), at.number, SETTING, at.scope, "", at.sentence)
        context = context.holding(none)
    return context


def _speaks_of(statement: Statement, side: Node) -> bool:
    """Whether the letter that a side is stands in a statement."""
    return named(side)[0] in letters_in(statement)


def _still(at: Situation, context: Context) -> list[Letter]:
    """The coordinates that do not change where the words say that a motion is."""
    bases = COORDINATES if at.balanced else _RADII if at.circular else frozenset()
    moving = context.habits.moving - context.definitions.keys()
    return sorted((x for x in moving if x.base in bases), key=str)


def with_rates(statement: Statement, context: Context) -> Statement:
    """A statement with the rate of φ where the one of a new letter φ₁ is written."""

    def change(node: Node) -> Node:
        if isinstance(node, TimeDerivative) and isinstance(node.of, Letter) and node.of.sub:
            bare = replace(node.of, sub="")
            if bare in context.habits.moving and node.of not in context.letters:
                return replace(node, of=bare)
        return node

    return replace(statement, sides=tuple(mapped(side, change) for side in statement.sides))
