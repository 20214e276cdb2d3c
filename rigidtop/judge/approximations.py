"""Sides that are said to be nearly equal: for what small or large thing do they become alike?"""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from itertools import combinations

from sympy import Rational

from rigidtop.judge import definitions, oscillations, worth
from rigidtop.judge.context import (
    LINEAR,
    SETTING,
    Constraint,
    Context,
    LetterDefinition,
    LimitingCase,
)
from rigidtop.judge.faults import NEARLY_ALIKE, NUMBERS, SLIP_SECONDS, Slip, slip
from rigidtop.judge.implicit import implicit, solves_nearly
from rigidtop.judge.jets import jet_of, jets
from rigidtop.judge.letters import INFINITY
from rigidtop.judge.numbers import are_numbers, compared
from rigidtop.judge.orders import (
    Scaling,
    differ,
    is_too_long,
    nearly,
    ratio,
    scalings,
    small_together,
    tending_to,
)
from rigidtop.judge.outcome import ASSUMING, FALSE, PREMISE, UNDECIDED, Outcome
from rigidtop.judge.question import Judgement, Pair, Question
from rigidtop.judge.settings import is_own
from rigidtop.judge.sides import ZERO, own_letters
from rigidtop.judge.situation import Situation
from rigidtop.judge.slips import times
from rigidtop.judge.surroundings import highest
from rigidtop.judge.values import UnclearError
from rigidtop.judge.worlds import Worlds
from rigidtop.read.phrases import Cue
from rigidtop.tree import nodes as n
from rigidtop.tree.latex import latex
from rigidtop.tree.nodes import Letter
from rigidtop.tree.plain import plain as in_words
from rigidtop.tree.statement import Statement


def judged(question: Question) -> Judgement:
    """The outcome of ≈; raises UnclearError."""
    named = question.context
    names = frozenset[Letter]().union(*named.little) & named.definitions.keys()
    outcome, context = _judged(_with_free(names, question))
    # What is behind it has the letters' meaning as it was.
    kept = tuple(c for c in context.constraints if c.left not in names or c in named.constraints)
    definitions = {x: named.definitions[x] for x in names} | {**context.definitions}
    return outcome, replace(context, constraints=kept, definitions=definitions)


def _judged(question: Question) -> Judgement:
    if question.inner and question.worlds.vanish([left for left, _ in question.both]):
        # Of 0 = a ≈ b it is asked how a becomes b, whatever it is that vanishes.
        said = question.left
        own = tuple(c for c in question.context.constraints if said not in (c.left, c.right))
        if len(own) < len(question.context.constraints):
            question = question.within(replace(question.context, constraints=own))
    defined = definitions.definition(question, question.left, question.right)
    if defined is None and question.at.closed:  # ω₁ ≈ w names w
        defined = definitions.definition(question, question.right, question.left)
        defined = defined or definitions.nearly(question)
    if defined is not None:
        root = _nearly_root(question)
        if root is None:
            return oscillations.with_meaning(question, defined)
        return root, defined[1]
    context = question.context
    if all(are_numbers(*pair) for pair in question.meant):
        sides = question.left, question.right
        numbers = compared(*sides, question.meant, question.rests_on_meaning, nearly=True)
        again = None if numbers.passed else definitions.number_again(question)
        return again or (numbers, context)
    if question.holds():
        return question.follows()
    if Cue.NEARLY_EQUAL in question.at.cues and Cue.SMALL not in question.at.cues:
        return _of_two_alike(question), context
    outcome = nearly_equal(question) or worth.number(question, nearly=True)
    if outcome is not None:
        return outcome
    wrong = near_slip(question)
    if wrong is not None:
        return wrong.outcome, context
    root = _nearly_root(question)
    if root is not None:
        return root, context
    apart = _near_multiple(question) or _differ(question)
    if apart is not None:
        return apart, context
    return Outcome(UNDECIDED, "it is not seen for what it is nearly true"), context


def _with_free(names: frozenset[Letter], question: Question) -> Question:
    """The question where some letters are equal to what they stand for, and not written out.

    Then they can be made smaller: ε of ε = a/b² ≪ 1.
    """
    context = question.context
    for letter in names:
        meant = context.definitions[letter]
        others = {x: each for x, each in context.definitions.items() if x != letter}
        equal = Constraint(letter, meant.node, meant.number, SETTING, meant.scope)
        context = replace(context, definitions=others).holding(equal)
    return question.within(context) if names else question


def tending(question: Question) -> Judgement:
    """The outcome of →: a letter that becomes large or small, or what both sides become then."""
    left, right, context = question.left, question.right, question.context
    limits = [x for x in context.limits if x.sentence == question.at.sentence]
    same = any(x.letter == left for x in limits)
    if isinstance(left, Letter) and right in (INFINITY, ZERO) and (same or not limits):
        limit = LimitingCase(left, right == INFINITY, question.at.sentence)
        return Outcome(PREMISE, "a limit"), replace(context, limits=(*context.limits, limit))
    match left, right:
        case Letter(), Letter() if (
            question.at.inline and not limits and left not in context.definitions
        ):
            return Outcome(PREMISE, "a limit"), _approaching(question, left, right)
    if not limits and isinstance(left, n.Number) and isinstance(right, n.Number):
        return Outcome(PREMISE, "indices that are exchanged"), context
    judgement = judged(question)
    if judgement[0].passed:
        return judgement
    if not limits:
        raise UnclearError("it is not said for what it tends there")
    tries = map(nearly_equal, map(_beside_one, _written_out(question)))
    return next(filter(None, tries), judgement)


def _written_out(question: Question) -> Iterator[Question]:
    """The question of a letter, and that of what has been found above for it."""
    yield question
    for each in question.context.followed:
        if each.left == question.left and not each.instant:
            yield replace(question.within(question.context.without_equations()), left=each.right)


def _beside_one(question: Question) -> Question:
    """The question whether a number stays as it is where what tends to zero is added to it."""
    if question.right != ZERO:
        return question
    return question.of([(left + 1, right + 1) for left, right in question.both])


def limited(statement: Statement, at: Situation, context: Context) -> tuple[Statement, Context]:
    """lim v = c as v → c, where a letter tends to zero or to infinity; all else as it is.

    To what the letter tends is known in the sentence then.
    """
    match statement:
        case Statement((n.Limit(of, Letter() as letter, place), *others), ("=", *links)) if (
            place in (INFINITY, ZERO)
        ):
            limit = LimitingCase(letter, place == INFINITY, at.sentence)
            context = replace(context, limits=(*context.limits, limit))
            statement = replace(statement, sides=(of, *others), relations=("→", *links))
    return statement, context


_DISTANCE = Letter("ε", "→")
"""How far a letter is from the one to which it tends."""


def _approaching(question: Question, letter: Letter, other: Letter) -> Context:
    """What is known where a letter tends to another one."""
    at, sum_of_both = question.at, n.Sum((other, _DISTANCE))
    near = LetterDefinition(sum_of_both, at.number, at.scope, supposed=True)
    context = question.context.defining(letter, near)
    return replace(context, limits=(*context.limits, LimitingCase(_DISTANCE, False, at.sentence)))


def nearly_equal(question: Question) -> Judgement | None:
    """That the sides become alike as something is small or large; None if they do not."""
    words = _alike(question, question.both, question.worlds)
    if not words and not question.moves(*question.gaps):
        question = question.within(_still(question.context))
        words = _alike(question, question.both, question.worlds)
    if not words:
        return None
    limits = any(x.sentence == question.at.sentence for x in question.context.limits)
    written = not limits or any(isinstance(x, n.Sum) for x in n.walked(question.right))
    if written and not _alike(question, question.both, question.worlds, strictly=True):
        strictly = partial(_is_alike, question, strictly=True)
        wrong = slip(question, strictly, "\\approx", most=NEARLY_ALIKE)
        why = f"a term of it is no larger than what is left out for {words}"
        outcome = Outcome(UNDECIDED, why) if wrong is None else wrong.outcome
        return outcome, question.context
    context = question.context
    fixed = {f"small {in_words(x)}" for x in context.letters - question.moving}
    accelerates = any(
        jet.order > 1 for pair in question.both for side in pair for jet in jets(side).values()
    )
    if words not in fixed and accelerates and not question.at.closed:  # there laws are known
        context = context.holding(question.constraint(LINEAR))
    outcome = Outcome(ASSUMING, f"for {words}", question.rests_on, conditions=(words,))
    return outcome, context


def _still(context: Context) -> Context:
    """What is known without what moves."""
    moving = context.habits.moving
    kept = tuple(c for c in context.constraints if not c.letters & moving)
    return replace(context, constraints=kept, lawless=True)


def said(question: Question) -> Judgement | None:
    """What words say is true for what is small or large, though "=" is written."""
    context, at = question.context, question.at
    limits = any(x.sentence == at.sentence for x in context.limits)
    little = frozenset[Letter]().union(*context.little)
    written = own_letters(question.left) | own_letters(question.right)
    if not (at.small or at.large or limits or written & little):
        return None
    given = {*highest(question.equations)}  # B η̇ = 0, where it is a product of two small things
    bare = [a + b for a, b in question.both if 0 in (a, b) and not (a + b).expand().is_Add]
    if any(given.isdisjoint(x.free_symbols) for x in bare):
        return None  # that it is small itself does not make it vanish
    outcome = nearly_equal(question)
    if outcome is None:
        return None
    # Another sign, or twice as much, is no approximation.
    wrong = slip(question, most=NUMBERS)
    return outcome if wrong is None else (wrong.outcome, wrong.context)


def _of_two_alike(question: Question) -> Outcome:
    """What holds where two parameters are equal holds nearly where they are nearly so."""
    parameters = {
        x: jet.letter
        for pair in question.both
        for side in pair
        for x, jet in jets(side).items()
        if not jet.order and jet.letter not in question.moving
    }
    for x, y in combinations(sorted(parameters, key=str), 2):
        both = [(left.subs(y, x), right.subs(y, x)) for left, right in question.both]
        if question.of(both).holds():
            words = f"nearly equal {in_words(parameters[x])} and {in_words(parameters[y])}"
            return Outcome(ASSUMING, f"for {words}", question.rests_on, conditions=(words,))
    return Outcome(UNDECIDED, "it is not seen which two are nearly equal")


def _nearly_root(question: Question) -> Outcome | None:
    """What becomes of a value that a letter nearly has, where an equation above fixes it."""
    equations = [*implicit(question)]
    for each in equations:
        found = [each.nearly_solved(right, _scalings) for _, right in each.question.both]
        if found and all(found):
            words = found[0].words  # type: ignore[union-attr]
            rests_on = frozenset({each.rests_on})
            return Outcome(ASSUMING, f"for {words}", rests_on, conditions=(words,))
    for each in equations:
        alike = partial(solves_nearly, each, _scalings)
        wrong = slip(each.question, alike, "\\approx", most=NEARLY_ALIKE)
        if wrong is not None:
            return replace(wrong.outcome, rests_on=frozenset({each.rests_on}))
    return None


def near_slip(question: Question) -> Slip | None:
    """The one change with which the sides become alike where something is small, or large.

    If words of its own say that something is large, that alone is tried, and not what was said
    before to be small.
    """
    at = question.at
    if at.large and Cue.SMALL not in at.cues:
        question = replace(question, at=replace(at, cues=at.cues - {Cue.APPROXIMATED}))
    alike = partial(_is_alike, question, strictly=True)
    return slip(question, alike, "\\approx", most=NEARLY_ALIKE)


def _near_multiple(question: Question) -> Outcome | None:
    """By which simple fraction the right side has to be multiplied to become like the left one."""
    if Cue.ELSEWHERE in question.at.cues or not question.worlds.count:
        return None
    left, right = question.both[0]
    with question.patience.search(SLIP_SECONDS) as until:
        for scaling in _scalings(question, question.worlds):
            times_as_much = ratio(left, right, question.equations, question.worlds, scaling)
            if time.process_time() > until or not abs(times_as_much) < LARGEST + 1:
                continue
            factor = Fraction(times_as_much).limit_denominator(LARGEST)
            both = [(a, Rational(factor) * b) for a, b in question.both]
            if 0 < factor <= LARGEST and _is_alike(question, both, question.worlds):
                words = f"{factor} times as much"
                line = f"{latex(question.left)} \\approx {latex(times(factor, question.right))}"
                return Outcome(FALSE, f"it holds with {words}", question.rests_on, words, line)
    return None


LARGEST = 7
"""No larger number stands in a fraction by which a line is said to be off."""


def _is_alike(
    question: Question, both: Sequence[Pair], worlds: Worlds, strictly: bool = False
) -> bool:
    return bool(_alike(question, both, worlds, strictly))


def _alike(question: Question, both: Sequence[Pair], worlds: Worlds, strictly: bool = False) -> str:
    """For what both sides become alike, `strictly` to the last term that is written."""
    if not worlds.count:
        return ""
    words = set()
    for left, right in both:
        if left == right:
            continue
        sides = left, right, question.equations, worlds
        scaling = nearly(*sides, _scalings(question, worlds))
        if scaling is None or (strictly and is_too_long(*sides, scaling)):
            return ""
        words.add(scaling.words)
    return words.pop() if len(words) == 1 else ""


def _scalings(question: Question, worlds: Worlds) -> list[Scaling]:
    """What may be small or large here: what is said to be, before what is only possible."""
    here = question.at.sentence
    limits = [x for x in question.context.limits if x.sentence == here]
    little = _little(question, worlds)
    compared = little[-1:] if question.context.compared == here else []  # in the same sentence
    if limits:
        tending = [tending_to(x.letter, x.large, worlds) for x in limits]
        if any(tending) or not question.at.large:
            return [*compared, *(each for each in tending if each is not None)]
    if compared:
        return compared
    which = "large" if question.at.large else "small" if question.at.small else ""
    usual = _scaled(question, worlds, which)
    if question.at.large and question.at.small:
        usual += _scaled(question, worlds, "small")
    if which == "large" and question.at.closed:
        usual += [x for x in _scaled(question, worlds, "small") if _is_of_own(question, x)]
    return [*little, *usual]


def _scaled(question: Question, worlds: Worlds, which: str) -> list[Scaling]:
    return scalings(worlds, question.equations, question.moving, which)


def _is_of_own(question: Question, scaling: Scaling) -> bool:
    """Whether it scales but letters of the text's own, as x is in √(1 − x)."""
    return all(is_own(question, jet) for jet in filter(None, map(jet_of, scaling.letters)))


def _little(question: Question, worlds: Worlds) -> list[Scaling]:
    little = (small_together(letters, worlds) for letters in question.context.little)
    return [each for each in little if each is not None]


def _differ(question: Question) -> Outcome | None:
    """That both sides do not become alike, where it is said for what they should."""
    if not question.at.closed or not question.worlds.count:
        return None
    stated = _little(question, question.worlds)
    if question.at.large and not stated:
        large = _scaled(question, question.worlds, "large")
        stated = [each for each in large if not _is_of_own(question, each)]
    for left, right in question.both:
        apart = [differ(left, right, question.equations, question.worlds, x) for x in stated]
        if apart and all(apart):
            words = stated[0].words if len(stated) == 1 else "what is said to be large"
            why = f"the sides do not become alike for {words}"
            return Outcome(FALSE, why, question.rests_on)
    return None
