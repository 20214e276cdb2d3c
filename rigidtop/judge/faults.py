"""What is wrong with a statement: a slip, a missing term, or a contradiction."""

from __future__ import annotations

import time
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from math import inf

import numpy as np
from sympy import (
    Expr,
)

from rigidtop.judge import paths
from rigidtop.judge import worlds as w
from rigidtop.judge.context import PREMISE as SUPPOSED
from rigidtop.judge.context import Constraint, Context, LetterDefinition, is_open
from rigidtop.judge.jets import TIME, jet_of, symbols
from rigidtop.judge.meaning import Meaning
from rigidtop.judge.outcome import FALSE, Outcome
from rigidtop.judge.program import UnknownFunctionError
from rigidtop.judge.question import Pair, Question, paired
from rigidtop.judge.series import is_of_numbers
from rigidtop.judge.sides import ZERO, entries, letters_of, named, own_letters
from rigidtop.judge.slips import Change, changes, times
from rigidtop.judge.values import UnclearError, plain
from rigidtop.judge.vocabulary import Curvature, Meant
from rigidtop.judge.worlds import Worlds
from rigidtop.read.phrases import Cue
from rigidtop.tree import nodes as n
from rigidtop.tree.latex import latex
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.plain import plain as in_words

MOST_LETTERS = 16
"""So many letters are tried in place of others."""

NUMBERS = 1.5
"""Up to this rank a slip is one of a sign or a number."""

NEARLY_ALIKE = 2.9
"""Up to this rank a slip is looked for where sides are only said to be nearly equal."""

LIKELY = 1.2
"""Up to this rank a slip is looked for in what a statement contradicts."""

FUNCTIONS = 2.0
"""Up to this rank a slip is one of a function, too, as sin in place of cos."""

FEWEST = 2
"""In fewer worlds a change may make a statement right by chance."""

SLIP_SECONDS = 5.0
"""How long the change that makes a statement right is looked for (s, of the processor's time)."""

Comparison = Callable[[Sequence[Pair], Worlds], bool]
"""Whether sides are to each other as the relation of a statement says."""

# --- Slips ---------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Slip:
    """The change with which a statement holds; `context` is known behind the statement so changed.

    `outcome` shows the right line.
    """

    change: Change
    outcome: Outcome
    context: Context


def slip(
    question: Question,
    compared: Comparison | None = None,
    relation: str = "=",
    letter: Letter | None = None,
    most: float = inf,
) -> Slip | None:
    """The one change with which it holds in every world; of one `letter` alone, if given.

    Of the changes none is less likely than `most`. Sides are `compared` for equality unless
    something else is said; `relation` is how that is written in LaTeX.
    """
    patience = question.patience
    if patience.is_over or question.worlds.count < FEWEST or question.worlds.tied:
        return None
    if question.worlds.points.imag.any() and _has_size(question):
        return None  # how large a complex number is is not seen
    if counts(question) or (Cue.ELSEWHERE in question.at.cues and not question.at.closed):
        return None
    with patience.search(SLIP_SECONDS) as until:
        change = next(_right_changes(question, compared, letter, most, until), None)
    if change is None:
        return None
    right = f"{latex(change.left)} {relation} {latex(change.right)}"
    why = f"it holds with {change.words}"
    outcome = Outcome(FALSE, why, question.rests_on, change.words, right)
    return Slip(change, outcome, _righted(question, change))


def counts(question: Question) -> bool:
    """Whether a multiple of π stands in it that is counted: the n of n π has no other value."""
    nodes = (x for side in (question.left, question.right) for x in n.walked(side))
    products = (x.factors for x in nodes if isinstance(x, n.Product))
    return any(
        Letter("π") in factors and any(isinstance(x, Letter) and x.base in "nkjNℓ" for x in factors)
        for factors in products
    )


def _has_size(question: Question) -> bool:
    nodes = (x for side in (question.left, question.right) for x in n.walked(side))
    return any(isinstance(x, n.Absolute) for x in nodes)


def _right_changes(
    question: Question,
    compared: Comparison | None,
    letter: Letter | None,
    most: float,
    until: float,
) -> Iterator[Change]:
    context = question.context
    known = frozenset(context.letters & near(question))
    indices = context.habits.indices
    worlds = _widened(question, known)
    meanings = question.meanings()
    if not indices:
        meanings = [x.remembering(question.left, question.right) for x in meanings]
    sums = _sums(question) if letter is None else frozenset()
    both = question.left, question.right
    for change in changes(*both, known, question.moving, letter, indices, sums):
        if time.process_time() > until or change.rank > most:
            return
        if _says_something(question, change) and _is_right(
            question, change, compared, meanings, worlds
        ):
            yield change


def _sums(question: Question) -> frozenset[n.Sum]:
    """The sums of two letters in what it rests on, as R − a, unless the statement has them too."""
    context = question.context
    used = [d.node for d in context.definitions.values() if d.number in question.rests_on]
    held = (c for c in context.constraints if c.number in question.rests_on)
    used += [side for each in held for side in (each.left, each.right)]
    own = {x for side in (question.left, question.right) for x in n.walked(side)}
    return frozenset(
        x
        for node in used
        for x in n.walked(node)
        if isinstance(x, n.Sum) and len(x.terms) == 2 and x not in own and _is_of_letters(x)
    )


def _is_of_letters(node: n.Sum) -> bool:
    bare = (x.of if isinstance(x, n.Negative) else x for x in node.terms)
    return all(isinstance(x, Letter) and not x.bold for x in bare)


def near(question: Question) -> set[Letter]:
    """The letters that have to do with a statement: they, and no others, may be missing in it.

    A quantity that is given as a number with a unit belongs to an example.
    """
    near = {jet.letter for x in question.worlds.letters if (jet := jet_of(x)) is not None}
    for letter, definition in question.context.definitions.items():
        if definition.number in question.rests_on:
            near |= {letter, *n.letters(definition.node)}
    return {x for x in near if not _has_unit(question.context.definitions.get(x))}


def _has_unit(definition: LetterDefinition | None) -> bool:
    return definition is not None and any(isinstance(x, n.Unit) for x in n.walked(definition.node))


def _says_something(question: Question, change: Change) -> bool:
    name, _ = named(change.left)
    if name is not None and name in n.letters(change.right) - n.letters(question.right):
        return False  # x = x says nothing
    if _is_exchanged(question, change) or _is_renamed(question, change):
        return False
    if any(
        _is_idle(x, question.moving) for side in (change.left, change.right) for x in n.walked(side)
    ):
        return False
    letter, _ = named(question.left)
    if question.at.inline and letter is not None and change.left != question.left:
        return False  # words that name a letter do not mistake it
    may_vanish = isinstance(question.left, Letter) and question.right == ZERO
    if may_vanish and change.left != question.left:
        return False  # any letter may be zero
    # A chain may not end with what it begins with.
    ends = isinstance(question.right, Letter) and change.right == question.context.head
    return not ends


def _is_idle(node: Node, moving: Collection[Letter]) -> bool:
    """Whether it is zero as it is written: r − r, or the rate of what does not move."""
    if isinstance(node, n.Sum):
        return any(n.Negative(term) in node.terms for term in node.terms)
    return (
        isinstance(node, n.TimeDerivative) and isinstance(node.of, Letter) and node.of not in moving
    )


def _is_renamed(question: Question, change: Change) -> bool:
    """Whether sides that speak of different letters are made to speak of the same: |U|² = U²."""
    before = n.letters(question.left), n.letters(question.right)
    behind = n.letters(change.left), n.letters(change.right)
    return not before[0] & before[1] and behind[0] == behind[1] != frozenset()


def _is_exchanged(question: Question, change: Change) -> bool:
    """Whether it puts a letter for one that an open line says to be equal to it."""
    for each in question.context.open:
        one, other = each.left, each.right
        before = [n.replaced(side, one, other) for side in (question.left, question.right)]
        behind = [n.replaced(side, one, other) for side in (change.left, change.right)]
        if before == behind:
            return True
    return False


def _is_right(
    question: Question,
    change: Change,
    compared: Comparison | None,
    meanings: Sequence[Meaning],
    worlds: Worlds,
) -> bool:
    if question.path is not None and compared is None:
        return _is_right_path(question, change, meanings[0])
    try:
        both = question.sides(meanings, change.left, change.right)
    except UnclearError:
        return False
    flat = plain([x for pair in both for x in pair])
    if all(x == 0 for x in flat):
        return False
    if not {x for side in flat for x in side.free_symbols} <= {*worlds.letters}:
        return False
    if compared is not None:
        return compared(paired(flat), worlds)
    if change.left == change.right:
        return False
    if ZERO not in (question.left, question.right) and worlds.vanish(flat):
        return False  # sides that are zero since their terms cancel say nothing of each other
    return bool(worlds.holds(paired(flat), trivially=False)) or question.is_kept(paired(flat))


def _is_right_path(question: Question, change: Change, meaning: Meaning) -> bool:
    if change.left != question.left:
        return False
    try:
        value = meaning.scalar(paths.named_path(question, change.right)[1])
    except UnclearError:
        return False
    return value.has(TIME) and paths.solves(question, value)


def _widened(question: Question, known: frozenset[Letter]) -> Worlds:
    """Worlds in which the letters that a change may put in have numbers too."""
    more: list[Expr] = []
    for letter in sorted(known, key=str)[:MOST_LETTERS]:
        moves = letter in question.moving and not question.context.timeless
        try:
            value = question.meaning().value(letter)
        except UnclearError:
            continue
        more += entries(value)
        for _ in range(2 * moves):
            value = question.meaning().rate(value)
            more += entries(value)
    if question.at.instant:
        more = [question.then(x) for x in more]
    wide = question.of([*question.both, *((x, x) for x in more)])
    return wide.worlds if wide.worlds.count else question.worlds


def _righted(question: Question, change: Change) -> Context:
    """What a text goes on with behind a slip: what it should have said."""
    path, context = question.path, question.context
    if path is None:
        definition = context.definitions.get(change.left)  # type: ignore[call-overload]
        if definition is None:
            if not question.new_letters:
                return context
            at = question.at  # it says what the new ones are
            righted = Constraint(change.left, change.right, at.number, SUPPOSED, at.scope)
            return context.holding(righted)
        also = (*definition.also, change.right)
        return context.defining(change.left, replace(definition, also=also))  # type: ignore[arg-type]
    definition = LetterDefinition(change.right, question.at.number, question.at.scope)
    return path.before.defining(path.letter, definition)


# --- Two statements that contradict each other ---------------------------------------------------


def contradiction(question: Question, most: float = LIKELY) -> Outcome | None:
    """A statement above that, with one change, lets this one hold; nothing follows from it.

    Of the changes none is less likely than `most`.
    """
    if all(_changes(question, x) and not _changes(question, y) for x, y in question.both):
        return None  # a value that it has somewhere
    with question.patience.search(SLIP_SECONDS / 2) as until:
        return _contradiction(question, most, until)


def _changes(question: Question, value: Expr) -> bool:
    """Whether a value changes in time."""
    return question.moves(value) or value.has(TIME)


def _contradiction(question: Question, most: float, until: float) -> Outcome | None:
    context = question.context
    names = [
        (letter, definition)
        for letter, definition in context.definitions.items()
        if definition.number in question.rests_on_meaning
        and definition.number not in context.supported
        and is_open(definition.scope, question.at.scope)
        and not any(isinstance(x, (Meant, Curvature)) for x in n.walked(definition.node))
    ]
    told: list[Outcome] = []
    for letter, definition in sorted(names, key=lambda x: -x[1].number)[:3]:
        change = _change_of_meaning(question, letter, definition, most, until)
        if change is not None:
            why = f"it contradicts what {in_words(letter)} stands for: {change.words} there"
            right = f"{latex(letter)} = {latex(change.right)}"
            rests_on = frozenset({definition.number})
            told.append(Outcome(FALSE, why, rests_on, change.words, right))
    if len(told) < 2:
        return told[0] if told else None
    rests_on = frozenset().union(*(each.rests_on for each in told))
    right = ", or ".join(each.right for each in told)
    return Outcome(FALSE, "it contradicts one of the lines that it rests on", rests_on, right=right)


def _change_of_meaning(
    question: Question, letter: Letter, definition: LetterDefinition, most: float, until: float
) -> Change | None:
    """The change of what a letter stands for with which the statement holds."""
    known = n.letters(definition.node)
    for change in changes(letter, definition.node, known, question.moving):
        if time.process_time() > until or change.rank > most:
            return None
        if change.left == letter and _holds_with(question, letter, definition, change.right):
            return change
    return None


def _holds_with(
    question: Question, letter: Letter, definition: LetterDefinition, node: Node
) -> bool:
    """Whether the statement holds where a letter stands for something else."""
    known = question.context.defining(letter, replace(definition, node=node))
    other = replace(question.within(known), asked=None)
    path = question.path
    try:
        if path is not None:
            before = path.before.defining(letter, replace(definition, node=node))
            other = replace(other, path=replace(path, before=before), asked=tuple(question.both))
            return paths.solves(other, other.meaning().scalar(question.right))
        return other.holds()
    except UnclearError:
        return False


# --- What is worked out ---------------------------------------------------------------------------


def is_settled(question: Question) -> bool:
    """Whether its sides can only be equal for all letters, or for none.

    Sides of which one is always the same multiple of the other are never equal.
    """
    if question.worlds.count < FEWEST or question.path is not None:
        return False
    if question.right == ZERO or (question.at.instant and not _is_value_then(question)):
        return False
    if isinstance(question.left, Letter) and not question.at.derived:
        return False  # it may be another one
    if _ratio(question) is not None:
        return True
    return _in_the_same_letters(question) if question.inner else is_worked_out(question)


def _in_the_same_letters(question: Question) -> bool:
    """Whether a link of a chain has the same constants on both sides, which nothing else ties."""
    one, other = ({x for pair in question.both for x in symbols(pair[k])} for k in (0, 1))
    ties = (each for each in question.equations if not question.moves(each))
    tied = {x for each in ties for x in symbols(each)}
    return one == other and not question.moves(*one) and not one & tied and not counts(question)


def _is_value_then(question: Question) -> bool:
    """Whether the left side is what is given in time, at a time that is known: v(τ)."""
    left, known = question.left, question.context.definitions
    return isinstance(left, n.Call) and {left.function, *left.places} <= known.keys()


def is_worked_out(question: Question) -> bool:
    """Whether a derivative, a determinant, an integral or a series is worked out in its letters.

    It is no condition for these, as one that is to vanish is.
    """
    left, right = question.left, question.right
    asks = any(_is_operation(x) for x in n.walked(left))
    before = {x for pair in question.both for x in letters_of(pair[0])}
    behind = {x for pair in question.both for x in letters_of(pair[1])}
    return asks and bool(own_letters(right)) and behind <= before


def _is_operation(node: Node) -> bool:
    series = isinstance(node, n.Total) and is_of_numbers(node)
    return series or isinstance(node, (n.Derivative, n.Integral)) or _is_determinant(node)


def _is_determinant(node: Node) -> bool:
    bars = isinstance(node, n.Matrix) and node.bracket == "|" and len(node.rows) > 1
    return bars or (isinstance(node, n.Apply) and node.name == "det")


def multiple(question: Question) -> Outcome | None:
    """By which simple number the right side has to be multiplied, in all worlds alike."""
    ratio = _ratio(question)
    if ratio is None:
        return None
    factor = Fraction(ratio).limit_denominator(LARGEST_OF_A_FRACTION)
    if abs(ratio - factor) > w.CLOSE * abs(ratio):
        return None
    right = times(factor, question.right)
    words = f"{factor} times as much"
    line = f"{latex(question.left)} = {latex(right)}"
    return Outcome(FALSE, f"it holds with {words}", question.rests_on, words, line)


def _ratio(question: Question) -> float | None:
    """The left side over the right one, where that is the same number in all worlds, but not 1."""
    number = ratio(question)
    return number if number is not None and abs(number - 1) > ROUNDED else None


def ratio(question: Question) -> float | None:
    """The left side over the right one, where that is the same number in all worlds."""
    both = [pair for pair in question.both if pair != (0, 0)]
    try:
        values = question.worlds.program.values([x for pair in both for x in pair]).values
    except UnknownFunctionError:
        return None
    with np.errstate(all="ignore"):
        ratios = values[::2] / values[1::2]
    if not ratios.size or not np.isfinite(ratios).all():
        return None
    first = ratios.flat[0]
    alike = (abs(ratios - first) <= w.CLOSE * abs(first)).all() and not abs(first.imag) > w.CLOSE
    return float(first.real) if alike and abs(first) > ROUNDED else None


LARGEST_OF_A_FRACTION = 100
"""A number of a text is a fraction of no larger numbers."""

ROUNDED = 0.05
"""A number that is given with few digits is nearer to what it stands for."""
