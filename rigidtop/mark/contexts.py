"""Contexts of an answer: with its own names and habits, without facts, behind a wrong line."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from itertools import pairwise

from rigidtop.judge.context import LAW, SETTING, Constraint, Context, Habits, LetterDefinition
from rigidtop.judge.habits import habits_of
from rigidtop.judge.laws import LAGRANGIANS
from rigidtop.judge.letters import CLOCK
from rigidtop.judge.names import vector_of
from rigidtop.judge.reading import Read
from rigidtop.judge.vocabulary import Meant
from rigidtop.mark.arrival import head
from rigidtop.mark.facts import GIVEN, is_turned, with_angles
from rigidtop.mark.task import ALWAYS, Task, letters
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.plain import plain
from rigidtop.tree.statement import Statement

_ANGLES = frozenset({Letter("θ"), Letter("φ")})
"""Letters by which an answer shows that it uses Euler's angles."""


def free_letters(each: Statement, context: Context) -> list[Letter]:
    """The letters that no facts know, not even as a part of a vector, and nothing says they are."""
    known = ALWAYS | context.given | context.declared | context.definitions.keys()

    def is_known(x: Letter) -> bool:
        return {x, vector_of(x), replace(x, sub=x.sub.strip("±∓"))} & known != set()

    # What stands alone with what is known in a line above is fixed by that, in a line of vectors
    # three numbers are.
    own = [c.letters for c in context.constraints if c.number >= 0]
    fixed: set[Letter] = set()
    while new := {
        x
        for spoken in own
        for unknown in [{y for y in spoken - fixed if not is_known(y)}]
        if len(unknown) <= (3 if any(y.bold for y in spoken - unknown) else 1)
        for x in unknown
    }:
        fixed |= new
    return sorted((x for x in letters(each) - fixed if not is_known(x)), key=plain)


def without_facts(context: Context) -> Context:
    """A context with what the answer itself has set, and with no law."""
    own = tuple(c for c in context.constraints if c.number >= 0)
    return replace(context, constraints=own, lawless=True)


def without_trials(context: Context) -> Context:
    """A context without the motions that the answer has tried, x = A exp(κ t), nor what A and κ
    are.
    """
    own = [c for c in context.constraints if c.number >= 0]
    tried = [c for c in own if c.left in context.habits.moving and _is_exponential(c.right)]
    if not tried:
        return context
    known = context.given | {CLOCK}
    free = frozenset().union(*(c.letters for c in tried)) - known - ALWAYS
    kept = tuple(c for c in context.constraints if c not in own or not c.letters & free)
    definitions = {x: d for x, d in context.definitions.items() if x not in free}
    results = context.results & context.given - {c.left for c in tried}  # these may be zero
    return replace(context, constraints=kept, definitions=definitions, results=results)


def _is_exponential(motion: Node) -> bool:
    powers = (x for x in n.walked(motion) if isinstance(x, n.Power))
    return any(CLOCK in n.letters(x.exponent) for x in powers)


def believing(context: Context, each: Statement) -> Context:
    """A context in which a wrong line is right, and the laws that it offends are not known."""
    left, right = each.sides[0], each.sides[-1]
    kept = tuple(c for c in context.constraints if c.kind == SETTING or c.number >= 0)
    if isinstance(left, Letter) and left in context.definitions:
        number = context.definitions[left].number
        lawless = context.lawless and left not in LAGRANGIANS
        changed = replace(context, constraints=kept, lawless=lawless)
        return changed.defining(left, LetterDefinition(right, number))
    laws = tuple(Constraint(a, b, -1, LAW) for a, b in pairwise(each.sides))
    return replace(context, constraints=(*kept, *laws), lawless=True)


def in_names_of(read: Read, task: Task) -> Task:
    """A task in which functions that an answer gives itself, as U(θ), are not those of the pages.

    What each goal speaks of keeps its name.
    """
    heads = (each.sides[0] for _, each in read if isinstance(each, Statement) and each.relations)
    named = {head(side) for side in heads if isinstance(side, n.Call)}
    spoken = [frozenset().union(*map(letters, goal)) for goal in task.goals]
    named -= frozenset.intersection(*spoken)
    contexts = tuple(without_names(context, named) for context in task.contexts)
    return replace(task, contexts=contexts, names=without_names(task.names, named))


def in_angles(read: Read, task: Task) -> Task:
    """A task about a body whose attitude has Euler's angles, if the answer writes them."""
    stated = (each for _, each in read if isinstance(each, Statement))
    spoken = frozenset().union(*map(letters, stated))
    if not _ANGLES & spoken or not all(map(is_turned, task.contexts)):
        return task
    return replace(task, contexts=tuple(map(with_angles, task.contexts)))


def without_names(context: Context, named: Collection[Node]) -> Context:
    """A context in which these letters are not what the pages call so."""
    dropped = {
        letter
        for letter, each in context.definitions.items()
        if letter in named and each.number == GIVEN and not isinstance(each.node, Meant)
    }
    kept = {x: each for x, each in context.definitions.items() if x not in dropped}
    known = replace(context, definitions=kept, letters=context.letters - dropped)
    return replace(known, given=context.given - dropped)


def habits_in(read: Read, task: Task) -> Habits:
    """How an answer uses its letters; without dots a prime on what moves in the facts is a rate."""
    stated = [each for _, each in read if isinstance(each, Statement)]
    own = habits_of(stated)
    nodes = [node for each in stated for side in each.sides for node in n.walked(side)]
    primed = {x.of for x in nodes if isinstance(x, n.Primed)}
    dotted = any(isinstance(x, n.TimeDerivative) and x.dotted for x in nodes)
    known = frozenset().union(*(context.letters for context in task.contexts))
    moving = frozenset().union(*(context.habits.moving for context in task.contexts))
    axes = any(isinstance(x, Letter) and replace(x, mark="′") in known for x in primed)
    if dotted or axes or not primed or not primed <= moving:
        return own
    return replace(own, primes_are_rates=True)


def with_habits(context: Context, own: Habits) -> Context:
    """A context in which the answer's own letters have rates and places too."""
    habits = context.habits
    return replace(
        context,
        habits=replace(
            own,
            moving=habits.moving | own.moving | own.vectors - context.given,
            lengths=habits.lengths | own.lengths - {*context.definitions} - context.given,
        ),
    )
