"""Special cases that a statement sets: a special motion, a start, a value of what was left open."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from sympy import Symbol

from rigidtop.judge import worlds as w
from rigidtop.judge.context import PLACE, SETTING, Context, LetterDefinition
from rigidtop.judge.context import PREMISE as SUPPOSED
from rigidtop.judge.jets import TIME, Jet, jet_of, jets, symbols
from rigidtop.judge.numbers import are_numbers
from rigidtop.judge.outcome import DEFINITION, PREMISE, Outcome
from rigidtop.judge.question import Judgement, Question, alone
from rigidtop.judge.sides import ZERO, is_setting, is_start, letters_of, own_letters
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter
from rigidtop.tree.plain import plain as in_words


def setting(question: Question) -> Judgement | None:
    """A special motion, or what holds at one instant."""
    if not _may_be_set(question):
        return None
    context = question.context
    what = "at one instant" if question.at.instant else "a special case"
    outcome = Outcome(PREMISE, what, question.rests_on_meaning)
    set_here = question.constraint(SETTING)
    given = not n.letters(question.right) and not question.at.derived
    if given and isinstance(question.left, Letter):  # it may be as small as it is said to be
        context = replace(context, results=context.results | {question.left})
    known = context.holding(set_here)
    for each in (known, _with_results(known)):
        if question.of(question.both, each).worlds.count:
            return outcome, each
    older = [c for c in context.constraints if c.kind == SETTING and not c.instant]
    ended = [[], *([x] for x in reversed(older)), *(older[:k] for k in range(2, len(older) + 1))]
    for over in ended:
        # What goes together with no earlier case is a case of its own.
        kept = tuple(c for c in context.constraints if c not in over)
        known = replace(context, not_zero=(), constraints=kept).holding(set_here)
        if question.of(question.both, known).worlds.count:
            return outcome, known
    if not (question.at.closed and question.at.instant and question.left in question.moving):
        return None
    # Where coordinates have no meaning, as angles at the pole, what holds at other times says
    # nothing: only what is known of the instant itself may contradict it.
    there = tuple(c for c in context.constraints if c.instant == question.at.instant)
    known = replace(context, constraints=there, lawless=True).holding(set_here)
    return (outcome, context) if question.of(question.both, known).worlds.count else None


def _with_results(context: Context) -> Context:
    """With the letters that equations are about as what comes out of them: J ω₀ may be zero."""
    left = (own_letters(c.left) for c in context.constraints if c.kind == SUPPOSED)
    results = frozenset().union(*left) - context.definitions.keys() - context.given
    return replace(context, results=context.results | results)


def origin(question: Question) -> Judgement | None:
    """Where a letter counts from, or what it passes, by the words: it does not hold as it moves."""
    if question.at.origin and _is_place(question):
        return Outcome(PREMISE, "where it counts from"), question.context
    if _is_of_a_field(question) or (
        question.at.ranges and question.at.inline and _is_bare(question)
    ):
        return Outcome(PREMISE, "a place"), question.context
    at = question.at
    named = at.supposed or at.defined or at.derived or at.closed or at.instant
    if question.right == ZERO and at.inline and not named and _is_bare(question):
        return _passing(question)  # that a letter is zero is seldom what it stands for
    return None


def _passing(question: Question) -> Judgement:
    """A place that is spoken of in passing: it holds as long as its sentence."""
    passing = replace(question.constraint(PLACE), until=question.at.sentence)
    return Outcome(PREMISE, "a place"), question.context.holding(passing)


def _is_bare(question: Question) -> bool:
    """Whether a letter is given a value in a line of words."""
    known = question.context.definitions
    return isinstance(question.left, Letter) and question.left not in known and not question.inner


def _is_of_a_field(question: Question) -> bool:
    """Whether it is a place at which a function is taken: the ends of a string, x = 0 and x = l."""
    habits, at = question.context.habits, question.at
    places = {x for each in habits.functions.values() for x in each}
    value = isinstance(question.right, (n.Number, Letter))
    return at.inline and value and question.left in places - {*habits.moving}


def place(question: Question) -> Judgement | None:
    """A value of what moves, said in passing."""
    at = question.at
    if at.supposed or at.derived or at.closed or not _is_place(question):
        return None
    return _passing(question)


def elsewhere(question: Question) -> Judgement | None:
    """Another place of what was given one in passing: r = a(1 − e), and then r = a(1 + e)."""
    context, at, left = question.context, question.at, question.left
    if not at.inline or at.derived or question.inner or not isinstance(left, Letter):
        return None
    older = [
        c
        for c in context.constraints
        if c.left == left and c.scope == at.scope and c.instant in ("", at.instant)
    ]
    if not older or left in context.definitions:
        return None
    kept = tuple(c for c in context.constraints if c is not older[-1])
    known = replace(context, constraints=kept).holding(question.constraint(SETTING))
    if not question.of(question.both, known).worlds.count:
        return None
    return Outcome(PREMISE, "another place", question.rests_on_meaning), known


def _is_place(question: Question) -> bool:
    """Whether a coordinate is given a number in a line of words."""
    at, left = question.at, question.left
    if not at.inline or at.instant or question.inner or left not in question.moving:
        return False
    return all(are_numbers(x, x) for _, x in question.both)


def _may_be_set(question: Question) -> bool:
    """Whether it is written, and said, as what is set is."""
    at, left = question.at, question.left
    known = () if at.instant else question.context.definitions
    given = (
        is_setting(left, question.right, known)
        or _is_value(question)
        or bool(at.instant and at.inline)
        or _is_tuned(question)
    )
    if question.inner and not is_start(left):
        return False
    if at.closed and not (at.supposed or at.instant or is_start(left)):
        return False
    on_circle = at.circular and at.inline and question.right == ZERO
    if at.derived and not (at.supposed or at.opens or (at.instant and at.inline) or on_circle):
        return False
    return at.supposed or given or on_circle


def number(question: Question) -> Judgement | None:
    """A measured value of a letter, of a product of some, or of the cosine of one.

    It is put in: in a world all numbers are of the size of 1.
    """
    left, value = question.left, question.right
    match left:
        case n.Apply(name, of) if name in _INVERSE:
            left, value = n.ungrouped(of), n.Apply(_INVERSE[name], value)
    names = n.parts(left) if isinstance(left, n.Product) else (left,)
    letters = [x for x in names if isinstance(x, Letter)]
    context, at = question.context, question.at
    fixed = {*context.definitions, *question.moving, *context.given}
    is_free = len(letters) == len(names) and not {*letters} & fixed
    if not (is_free and at.inline and _is_measured(question)):
        return None
    for other in letters[:-1]:
        value = n.Quotient(value, other)
    if _is_determined(question, letters[-1]):
        return None
    definition = LetterDefinition(value, at.number, at.scope, supposed=True)
    known = context.defining(letters[-1], definition)
    return Outcome(PREMISE, "a number", question.rests_on_meaning), known


def _is_tuned(question: Question) -> bool:
    """Whether words choose a constant by others: "with δ = J w²"."""
    at, left = question.at, question.left
    chosen = at.inline and not (at.derived or at.asked or question.inner)
    free = isinstance(left, Letter) and left not in question.context.definitions
    return chosen and free and not question.moves(*question.gaps)


_INVERSE = {"sin": "arcsin", "cos": "arccos", "tan": "arctan"}


def _is_measured(question: Question) -> bool:
    """Whether the right side is a number with a unit, or with a decimal point."""
    numbers = all(are_numbers(x, x) for _, x in question.both)
    parts = [*n.walked(question.right)]
    return numbers and any(
        isinstance(x, n.Unit) or (isinstance(x, n.Number) and "." in x.text) for x in parts
    )


def _is_determined(question: Question, letter: Letter) -> bool:
    """Whether what holds gives the letter a number already."""
    return any(
        letters_of(each.expression) == {letter} for each in question.pool if not each.instant
    )


def _is_value(question: Question) -> bool:
    """Whether a letter that may have any value is given a number, perhaps with a unit."""
    left, known = question.left, question.context.definitions
    free = isinstance(left, Letter) and (
        left not in known or bool(own_letters(known[left].node) - known.keys())
    )
    return free and question.at.inline and all(are_numbers(x, x) for _, x in question.both)


def chosen(question: Question) -> Judgement | None:
    """A value for a letter that a text has brought itself and has left free so far."""
    context = question.context
    if not question.at.closed or question.at.instant:
        return None
    asked = {x for pair in question.both for side in pair for x in side.free_symbols}
    own = {x for x in asked if (jet := jet_of(x)) is not None and is_own(question, jet)}
    if not own or not is_setting(question.left, question.right, context.definitions):
        return None
    if question.moves(*question.gaps):
        return None
    # What moves follows such a value, as ω₁ = A cos Ωt does.
    free = [x for x in question.worlds.letters if x in own or question.moves(x)]
    known = context.holding(question.constraint(SETTING))
    if not fixes(question, free):
        timed = any(each.has(TIME) for each in question.equations)
        if not (timed and question.of(question.both, known).worlds.count):
            return None
    return Outcome(PREMISE, "it is chosen", question.rests_on_meaning), known


def one_value(question: Question) -> Judgement | None:
    """One of the two numbers that something has where it stands: cos θ is 1 or −1 if sin θ is 0."""
    if len(question.both) != 1 or question.inner:
        return None
    [(left, right)] = question.both
    worlds = question.worlds
    if not worlds.count or not symbols(left) or symbols(right) or not worlds.knows([left]):
        return None
    gaps = worlds.program.values([left - right]).values[0]
    if not np.isfinite(gaps).all():
        return None
    here = np.abs(gaps) < SAME
    others = gaps[~here]
    if not here.any() or not others.size or (np.abs(others - others[0]) > SAME).any():
        return None
    rests_on = question.rests_on
    known = question.context.holding(question.constraint(SETTING))
    return Outcome(PREMISE, "it is one of two values", rests_on), known


SAME = 1e-9
"""Numbers that differ by less are the same."""


def part(question: Question) -> Judgement | None:
    """What a letter stands for of which a text that answers has said only what it is a part of.

    After T = T₁ + T₂ it is free which part T₁ is.
    """
    if not question.at.closed or question.at.instant or question.inner:
        return None
    left = question.left
    own = [
        x
        for x in question.worlds.letters
        if (jet := jet_of(x)) is not None and is_own(question, jet)
    ]
    named = (
        isinstance(left, Letter) and alone(left) in own and left not in own_letters(question.right)
    )
    if not named or not fixes(question, own):
        return None
    outcome = Outcome(DEFINITION, f"what {in_words(left)} stands for", question.rests_on_meaning)
    return outcome, question.context.holding(question.constraint(SUPPOSED))


def coordinates(question: Question) -> Judgement | None:
    """What fixes letters of an answer's own that move: ω₂ = A sin χ behind ω₁ = A cos χ.

    It says what was left open of them, or, where that was but a sign, which one is meant.  How they
    are accelerated has to follow.
    """
    if not question.at.closed or question.at.instant or question.inner:
        return None
    asked = {x for gap in question.gaps for x in gap.free_symbols}
    if any(jet.order > 1 for gap in question.gaps for jet in jets(gap).values()):
        return None
    free = [x for x in question.worlds.letters if x in asked and _is_named(question, x)]
    if not free:
        return None
    known = question.context.holding(question.constraint(SUPPOSED))
    squares = [(left**2, right**2) for left, right in question.both]
    if not fixes(question, free):
        chooses = question.worlds.holds(squares) and len(squares) == 1
        chosen = question.of(question.both, known).worlds if chooses else None
        # Against a sign that is settled nothing is left but zeros.
        if chosen is None or not chosen.count or chosen.zeros - question.worlds.zeros:
            return None
    return Outcome(PREMISE, "it says what is meant", question.rests_on_meaning), known


def _is_named(question: Question, x: Symbol) -> bool:
    """Whether it is a letter that no facts know and nothing else is called, though it may move."""
    context, jet = question.context, jet_of(x)
    known = context.given | context.declared | context.definitions.keys()
    return (
        jet is not None and not (jet.order or jet.place or jet.instant) and jet.letter not in known
    )


def is_own(question: Question, jet: Jet) -> bool:
    """Whether it is a constant that no facts know and nothing else is called."""
    context = question.context
    known = context.given | context.declared | question.moving | context.definitions.keys()
    return not jet.order and not jet.place and jet.letter not in known


def fixes(question: Question, free: Sequence[Symbol]) -> bool:
    """Whether each of its components fixes one more of some letters: a question of rank."""
    equations, worlds = question.equations, question.worlds
    before = w.rank(equations, worlds, free)
    behind = w.rank([*equations, *question.gaps], worlds, free)
    return bool(behind == before + len(question.gaps))
