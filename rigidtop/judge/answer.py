"""An answer judged: its lines by facts that are given, and whether it arrives.

The facts are a chain of contexts, from the general motion to the special one; a line follows if it
holds in one of them, with what the answer itself has set and named.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import combinations, pairwise

from sympy import Expr, Integer, MatrixBase

from rigidtop.judge import worlds as w
from rigidtop.judge.context import Context, Habits
from rigidtop.judge.jets import jets
from rigidtop.judge.judge import EQUALS, NEARLY, Judge, Situation
from rigidtop.judge.meaning import Meaning, Memory, UnclearError, pairs, plain
from rigidtop.judge.outcome import DEFINITION, FALSE, PREMISE, UNDECIDED, UNREAD, Outcome
from rigidtop.judge.text import (
    Read,
    Row,
    declared_letters,
    habits_of,
    in_time,
    instants,
    is_time,
    read_text,
    situation,
)
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.plain import plain as in_words
from rigidtop.tree.statement import Statement, Unread

MOST_SIDES = 5
"""Of a longer chain the last sides are compared with what is to be reached."""


@dataclass(frozen=True)
class Goal:
    """What an answer has to reach: any of some statements, all those of each together.

    `names` are definitions that stand with it, for letters that an answer does not know.
    """

    name: str
    statements: tuple[tuple[Statement, ...], ...]
    names: tuple[Statement, ...] = ()


@dataclass(frozen=True)
class Marked:
    """The rows of an answer, and whether it arrives."""

    rows: tuple[Row, ...]
    arrives: bool


def marked(source: str, facts: Sequence[Context], goal: Goal) -> Marked:
    """Every statement of an answer with what became of it."""
    read, place = read_text(source, plain=True)
    read = [(passage, _in_letters_of(each, read, facts)) for passage, each in read]
    own = habits_of([each for _, each in read if isinstance(each, Statement)])
    contexts = [_with_habits(context, own) for context in facts]
    judge, names = Judge(), declared_letters(source)
    rows: list[Row] = []
    sound: list[Statement] = []
    chain: list[Node] = []
    known = frozenset(in_words(x) for context in facts for x in context.letters)
    moments = instants(read)
    for number, (passage, each) in enumerate(read):
        line = place(passage.start + each.position)[0]
        if isinstance(each, Unread):
            rows.append(Row(line, each, Outcome(UNREAD, each.reason), passage, number))
            continue
        if not each.relations or any(isinstance(x, n.Omitted) for x in each.sides):
            continue
        if is_time(each):
            continue  # a moment: what is said of it has its own place there
        at = replace(situation(passage, number, moments[number], False, names), closed=True)
        judged = [in_time(judge, each, at, context) for context in contexts]
        vector = _with_vector(each, known)
        if vector is not None and all(o.verdict == UNDECIDED for o, _ in judged):
            judged = [in_time(judge, vector, at, context) for context in contexts]
        outcome = _best([outcome for outcome, _ in judged], known)
        contexts = [after for _, after in judged]
        chain = [*chain, *each.sides[1:]] if each.continues and chain else [*each.sides]
        if outcome.passed is not False and outcome.verdict != UNDECIDED:
            relations = each.relations[-1:]
            both = list(combinations(chain[-MOST_SIDES:], 2))
            sound += [replace(each, sides=pair, relations=relations) for pair in both]
            sound += [with_root for x in sound[-len(both) :] for with_root in _roots(x)]
        rows.append(Row(line, each, outcome, passage, number))
    contexts = [_knowing(context, goal.names, judge) for context in contexts]
    arrives = any(
        all(_is_reached(each, sound, contexts) for each in together) for together in goal.statements
    )
    return Marked(tuple(rows), arrives)


def _knowing(context: Context, names: Sequence[Statement], judge: Judge) -> Context:
    """A context with definitions of letters that it does not have."""
    for each in names:
        letter = _head(each.sides[0])
        if isinstance(letter, Letter) and letter not in context.definitions:
            _, context = judge.judged(each, Situation(GIVEN, closed=True), context)
    return context


GIVEN = -1
"""The number of a statement that is given, and not the answer's."""


def _best(outcomes: Sequence[Outcome], known: frozenset[str]) -> Outcome:
    """What becomes of a line in several contexts: it follows, else is set or named, else is wrong.

    What brings a letter that another context knows says nothing.
    """
    for outcome in outcomes:
        if outcome.passed:
            return outcome
    outcomes = [x for x in outcomes if not x.brings & known] or outcomes
    kinds = (DEFINITION, PREMISE, FALSE, UNDECIDED)

    def place(outcome: Outcome) -> tuple[int, bool]:
        order = kinds.index(outcome.verdict) if outcome.verdict in kinds else len(kinds)
        return order, not outcome.slip

    return min(outcomes, key=place)


def _with_habits(context: Context, own: Habits) -> Context:
    """A context in which the answer's own letters have rates and places too."""
    habits = context.habits
    return replace(
        context,
        habits=replace(
            own,
            moving=habits.moving | own.moving,
            lengths=habits.lengths | own.lengths - {*context.definitions},
        ),
    )


def _roots(each: Statement) -> list[Statement]:
    """What a letter with two values says of letters for each: Ω = … ± … of Ω_±."""
    letter, signs = each.sides[0], any(isinstance(x, n.PlusMinus) for x in n.walked(each.sides[1]))
    if not signs or not isinstance(letter, Letter) or "±" in letter.sub:
        return []
    return [replace(each, sides=(replace(letter, sub=letter.sub + "±"), *each.sides[1:]))]


def _with_vector(each: Statement, known: frozenset[str]) -> Statement | None:
    """The statement with a vector on its left side, where the facts know one of that name."""
    left = each.sides[0]
    if not isinstance(left, Letter) or left.bold:
        return None
    bold = replace(left, bold=True)
    return replace(each, sides=(bold, *each.sides[1:])) if in_words(bold) in known else None


def _in_letters_of(
    each: Statement | Unread, read: Read, facts: Sequence[Context]
) -> Statement | Unread:
    """The statement in the letters of the facts: φ for ϕ, ℒ for L where it is differentiated."""
    if isinstance(each, Unread):
        return each
    known = frozenset().union(*(context.letters for context in facts))
    written = {_head(x.sides[0]) for _, x in read if isinstance(x, Statement)}
    differentiated = {
        n.ungrouped(x.of)
        for _, other in read
        if isinstance(other, Statement)
        for side in other.sides
        for x in n.walked(side)
        if isinstance(x, n.Derivative)
    }

    def change(node: Node) -> Node:
        if not isinstance(node, Letter):
            return node
        if node == Letter("L") and node in differentiated:
            return Letter("ℒ")
        bold = replace(node, bold=True)
        if node not in known and bold in known and node not in written:
            return bold  # e₃ for the vector
        if node.sub == "t" and node not in known and replace(node, sub="") in known:
            return n.Rate(replace(node, sub=""), 1, True)  # θ_t for θ̇
        return node

    sides = tuple(n.mapped(side, change) for side in each.sides)
    return replace(each, sides=sides)


def _is_reached(
    goal: Statement,
    sound: Sequence[Statement],
    contexts: Sequence[Context],
) -> bool:
    """Whether what was said in the right letters comes to the same as a statement."""
    return any(_comes_to(goal, sound, context) for context in contexts)


def _comes_to(goal: Statement, sound: Sequence[Statement], context: Context) -> bool:
    """The same in one context, of which only what letters stand for is known."""
    own = {x: d for x, d in context.definitions.items() if d.number >= 0}
    allowed = _letters(goal) | {*own} | _names_in(goal, context)
    vectors = {x.base for x in allowed if x.bold and not x.sub}
    allowed |= {x for each in sound for x in _letters(each) if x.base in vectors and x.sub}
    said = [each for each in sound if _is_said_in(each, allowed, goal)]
    if not said:
        return False
    named = [x for x in _letters(goal) if x in context.definitions and x not in own]
    heads = {_head(goal.sides[0])} & {*named}
    scalars = {x for x in named if not x.bold}
    for free in (set(), heads, heads | scalars, {*named}):
        kept = {x: d for x, d in context.definitions.items() if x not in free}
        bare = replace(context, definitions=kept, constraints=(), lawless=True)
        for basis in context.bases or (None,):
            if _same(goal, said, replace(bare, basis=basis)):
                return True
    return False


def _names_in(goal: Statement, context: Context) -> frozenset[Letter]:
    """Names of numbers that are made of nothing but what a statement speaks of."""
    meaning = Meaning(context, Memory())
    try:
        spoken = {x for gap in _gaps(goal, replace(context, definitions={})) for x in _jets(gap)}
    except UnclearError:
        return frozenset()
    names = set()
    for letter in context.definitions:
        try:
            value = meaning.value(letter)
        except UnclearError:
            continue
        if not letter.bold and not isinstance(value, MatrixBase) and _jets(value) <= spoken:
            names.add(letter)
    return frozenset(names)


def _jets(expression: Expr) -> set[Letter]:
    return {jet.letter for jet in jets(expression).values()}


def _same(goal: Statement, said: Sequence[Statement], context: Context) -> bool | None:
    """Whether the goal holds where the others do; None where it holds in any case."""
    try:
        asked = _gaps(goal, context)
    except UnclearError:
        return False
    given = []
    for each in said:
        try:
            given += _gaps(each, context)
        except UnclearError:
            continue
    flat = plain([*asked, *given])
    asked, given = flat[: len(asked)], flat[len(asked) :]
    letters = w.symbols_of(flat)
    sides = [(gap, 0 * gap) for gap in asked]
    if w.found([], letters).holds(sides):
        return None
    return bool(w.found(given, letters).holds(sides))


def _gaps(statement: Statement, context: Context) -> list[Expr]:
    """What vanishes where a statement holds, for the upper sign and the lower one."""
    made: list[Expr] = []
    for sign in (1, -1):
        meaning = Meaning(context, Memory(), sign=sign)
        for left, right in pairwise(statement.sides):
            if isinstance(right, n.Constant):
                both = pairs(meaning.rate(meaning.value(left)), Integer(0))
            else:
                both = pairs(meaning.value(left), meaning.value(right))
            made += [a - b for a, b in both]
    return [gap for gap in dict.fromkeys(made) if gap != 0]


def _letters(statement: Statement) -> frozenset[Letter]:
    return frozenset().union(*map(n.letters, statement.sides))


def _head(node: Node) -> Node:
    while isinstance(node, (n.Rate, n.Group, n.Call)):
        node = node.function if isinstance(node, n.Call) else node.of
    return node


def _is_said_in(each: Statement, allowed: frozenset[Letter], goal: Statement) -> bool:
    """Whether a statement has letters that may stand in the goal, and no derivative but there."""
    if not {*each.relations} <= {*EQUALS, *NEARLY}:
        return False
    derived = (n.Derivative, n.Integral, n.Total)
    of_goal = any(isinstance(x, derived) for side in goal.sides for x in n.walked(side))
    if not of_goal and any(isinstance(x, derived) for s in each.sides for x in n.walked(s)):
        return False
    return _letters(each) - {Letter("π"), Letter("t"), Letter("i"), Letter("e")} <= allowed
