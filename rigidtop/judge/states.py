"""Two states of what is conserved between them: l₁ and l₂ of a pendulum that is shortened."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

from rigidtop.judge.context import SETTING, Constraint, Context, LetterDefinition
from rigidtop.judge.laws import LAGRANGIANS
from rigidtop.judge.letters import SPEEDS, TURNING
from rigidtop.judge.sides import letters_in
from rigidtop.judge.situation import Situation
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Number, TimeDerivative
from rigidtop.tree.statement import Statement

_PAIRS = ({"1", "2"}, {"0", "1"}, {"i", "f"}, {"A", "B"}, {"a", "b"}, {"a", "e"}, {"0", "f"})
"""Indices that tell a state from another, by their names."""
_MOMENTA = frozenset("LℓlJMDKpPNh")
"""Letters of a momentum that words say to be conserved."""


def kept(context: Context, number: int, scope: tuple[int, ...], named: bool) -> Context:
    """What is known where the letter of the line above, or the momentum that is `named`, stays."""
    letter = _quantity(context, named)
    if letter is None:
        return context
    return context.holding(Constraint(TimeDerivative(letter), Number("0"), number, SETTING, scope))


def _quantity(context: Context, named: bool) -> Letter | None:
    """The letter that words say to be conserved: of a momentum, or the one of the line above."""
    known = context.definitions
    letters = [x for x in known if not (x in LAGRANGIANS and _has_a_square(known[x].node))]
    said = next((x for x in context.said[:1] if isinstance(x, Letter)), None)
    if not named:
        return said if said in letters else None
    momenta = [x for x in letters if x.base in _MOMENTA and _has_speed(known[x].node, known)]
    return max(momenta, key=lambda x: known[x].number, default=None)


def _has_speed(node: n.Node, known: Mapping[Letter, LetterDefinition]) -> bool:
    """Whether something in it moves by what it is, or by its name."""
    nodes = [*n.walked(node)]
    if any(isinstance(x, (TimeDerivative, n.Derivative)) for x in nodes):
        return True
    names = [x for x in nodes if isinstance(x, Letter)]
    inner = (known[x].node for x in names if x in known and known[x].node is not node)
    return any(x.base in SPEEDS | TURNING | {"u"} for x in names) or any(
        _has_speed(x, {y: d for y, d in known.items() if d.node is not x}) for x in inner
    )


def _has_a_square(node: n.Node) -> bool:
    """Whether a rate has a square in it, as in a Lagrangian."""
    return any(
        isinstance(x, n.Power) and isinstance(x.base, TimeDerivative) for x in n.walked(node)
    )


def stated(statement: Statement, at: Situation, context: Context) -> Context | None:
    """What is known where letters with an index are those of two states; None if nothing stays."""
    states = two_states(letters_in(statement) - context.definitions.keys(), context.letters)
    if not states or at.instant or not any(_is_kept(each) for each in context.constraints):
        return None
    habits = context.habits
    varying = frozenset(states.values()) | _varying(context)
    context = replace(context, habits=replace(habits, moving=habits.moving | varying))
    for name, letter in states.items():
        instant = f"state {name.sub}"
        value = Constraint(name, letter, at.number, SETTING, at.scope, instant, at.sentence)
        context = replace(context, instants={**context.instants, instant: None}).holding(value)
    return context


_FIXED = frozenset("mMgGcqeħπ")
"""Letters of masses and constants, which are the same in both states."""


def _varying(context: Context) -> frozenset[Letter]:
    """What a quantity that stays is made of, but for masses and constants."""
    kept = [each.left.of for each in context.constraints if _is_kept(each)]  # type: ignore[attr-defined]
    made: set[Letter] = set()
    while kept:
        letter = kept.pop()
        definition = context.definitions.get(letter)
        if letter not in made and definition is not None:
            kept += n.letters(definition.node)
        made.add(letter)
    return frozenset(x for x in made if x.base not in _FIXED and not x.bold)


def _is_kept(constraint: Constraint) -> bool:
    """Whether it says that a letter does not change."""
    left = constraint.left
    return (
        isinstance(left, TimeDerivative)
        and isinstance(left.of, Letter)
        and constraint.right == Number("0")
    )


def two_states(names: Iterable[Letter], known: Iterable[Letter]) -> Mapping[Letter, Letter]:
    """Letters with the indices of two states, each with the letter that it is a value of.

    >>> r, ω = Letter("r"), Letter("ω")
    >>> found = two_states({Letter("ω", "1"), Letter("ω", "2"), Letter("r", "1")}, {r, ω})
    >>> sorted(str(x.base) + x.sub for x in found)
    ['r1', 'ω1', 'ω2']
    """
    values = {x: replace(x, sub="") for x in names if x.sub and not x.bold}
    values = {x: letter for x, letter in values.items() if letter in {*known}}
    subs = {x.sub for x in values}
    return values if any(subs == pair for pair in _PAIRS) else {}
