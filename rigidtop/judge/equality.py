"""Two sides that are said to be equal: what becomes of that, and what is known behind it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from math import inf

from sympy import Add, Expr

from rigidtop.judge import (
    approximations,
    definitions,
    faults,
    fields,
    missing,
    novelties,
    oscillations,
    paths,
    quantities,
    settings,
    signs,
    spectrum,
    worth,
)
from rigidtop.judge.brackets import convention
from rigidtop.judge.context import LAW, PLACE, SETTING, Constraint, LetterDefinition
from rigidtop.judge.context import PREMISE as SUPPOSED
from rigidtop.judge.counterexample import acceleration, refuted
from rigidtop.judge.faults import NUMBERS
from rigidtop.judge.jets import jet_of, rate
from rigidtop.judge.laws import HAMILTONIANS, LAGRANGIANS, hamilton, lagrange
from rigidtop.judge.numbers import A_MINUTE, are_numbers, compared
from rigidtop.judge.outcome import DEFINITION, PREMISE, SAMPLED, UNDECIDED, Outcome
from rigidtop.judge.question import Judgement, Pair, Question, TrialMotion
from rigidtop.judge.rest import staying
from rigidtop.judge.sides import ZERO, letters_of, own_letters
from rigidtop.judge.values import UnclearError
from rigidtop.judge.worlds import Worlds
from rigidtop.read.phrases import Cue
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.plain import plain as in_words

DOES_NOT_FOLLOW = "it does not follow from what stands above"


def judged(question: Question) -> Judgement:
    """The outcome of an equation and the context behind it; raises UnclearError."""
    judgement = oscillations.with_meaning(question, _judged(question))
    judgement = spectrum.with_meaning(question, judgement)
    return quantities.with_meaning(question, judgement)


def _judged(question: Question) -> Judgement:
    left, right = question.left, question.right
    origin = settings.origin(question)
    if origin is not None:
        return origin
    sign = convention(left, right)
    if sign is not None:
        context = replace(question.context, brackets=sign)
        return Outcome(DEFINITION, "what its brackets mean"), context
    rule = novelties.rule(question)
    if rule is not None:
        return rule
    field = fields.equation(question) or fields.value(question)
    if field is not None:
        return field
    form = definitions.form(question)
    if form is not None:
        return form
    defined = definitions.definition(question, left, right)
    defined = defined or definitions.definition(question, right, left)
    if defined is not None:
        return defined
    if all(are_numbers(*pair) for pair in question.meant):
        return _nothing(question) or _numbers(question)
    holds = question.worlds.holds(question.both)
    if holds is None and not question.worlds.count:
        consistent = question.consistent()
        if consistent is not None:
            question = consistent
            holds = question.worlds.holds(question.both)
    if holds:
        if left == right:
            return Outcome(UNDECIDED, "it says nothing"), question.context
        if _is_turned_round(left, right) and not question.at.closed:
            return Outcome(UNDECIDED, "it says that its factors commute"), question.context
        return _always(question) or _vacuous(question) or question.follows()
    if question.is_kept(question.both):
        path = paths.path_of(question)
        outcome, context = question.follows()
        if path is None:  # no world knows the way from the start
            kind = SETTING if _is_special(question) else SUPPOSED
            return outcome, context.holding(question.constraint(kind))
        return outcome, context.defining(path.letter, path.definition)
    deep = replace(question, deep=True)
    further = len(deep.equations) > len(question.equations)
    if further and deep.worlds.count and deep.worlds.holds(deep.both):
        return deep.follows()
    still = staying(question)
    if still is not None:
        other = question.within(still)
        if other.worlds.count and other.worlds.holds(other.both):
            outcome, _ = other.follows()
            return outcome, question.follows()[1]
    return _failed(question, holds)


def _is_turned_round(left: Node, right: Node) -> bool:
    """Whether one product is the other one in another order: nobody says so of numbers."""
    products = isinstance(left, n.Product) and isinstance(right, n.Product)
    return products and Counter(n.parts(left)) == Counter(n.parts(right))


def _is_special(question: Question) -> bool:
    """Whether a special case is among what it follows from: it ends with that."""
    near = {each.constraint for each in question.grounds.near}
    cases = (c for c in question.context.constraints if c.kind in (SETTING, PLACE))
    supposed = (d for d in question.context.definitions.values() if d.supposed)
    return any(c in near and not c.instant for c in cases) or any(
        d.number in question.rests_on for d in supposed
    )


def _nothing(question: Question) -> Judgement | None:
    """What becomes of it without the letters that are zero, where they make both sides vanish."""
    context = question.context
    named = {x: d for x, d in context.definitions.items() if d.node != ZERO}
    if ZERO in (question.left, question.right) or len(named) == len(context.definitions):
        return None
    if any(x != 0 for pair in question.meant for x in pair):
        return None
    general = replace(question.within(replace(context, definitions=named)), asked=None)
    if judged(general)[0].passed:
        return None
    return Outcome(UNDECIDED, ALL_VANISH, question.rests_on_meaning), context


def _forced(question: Question, terms: Sequence[Expr]) -> Judgement | None:
    """What becomes of it where each of its terms has to vanish by what is supposed.

    A constant of an answer's own that nothing sets is zero only as all has to be, and what the
    answer supposes of what moves may go together with the facts only where that rests.
    """
    context = question.context
    numbers = filter(None, map(jet_of, question.worlds.zeros))
    stuck = any(settings.is_own(question, x) for x in numbers)
    facts = tuple(c for c in context.constraints if c.number < 0 or c.instant)
    if not question.at.closed:
        nothing = Outcome(UNDECIDED, ALL_VANISH, question.rests_on), context
        return None if question.at.instant else nothing
    if not (stuck or len(facts) < len(context.constraints)):
        return None
    general = replace(question.within(replace(context, constraints=facts)), asked=None)
    if not stuck and general.worlds.count and general.worlds.vanish(terms):
        return None
    return Outcome(UNDECIDED, ALL_VANISH, question.rests_on), context


ALL_VANISH = "each of its terms vanishes in the case that is supposed"


def _numbers(question: Question) -> Judgement:
    """The outcome where both sides are numbers."""
    sides, meant = (question.left, question.right), question.meant
    others = [side for side in sides if side != ZERO]
    rates = [any(isinstance(x, n.TimeDerivative) for x in n.walked(side)) for side in others]
    if others and all(rates) and all(x == 0 for pair in meant for x in pair):
        # Rates vanish only as no letter of theirs moves.
        if len(others) == len(sides):
            return Outcome(UNDECIDED, "nothing in it moves"), question.context
        given = question.context.given
        if not any(own_letters(side) & given for side in others):
            return Outcome(PREMISE, "a constant"), question.context
    slopes = {
        x.of
        for side in sides
        for x in n.walked(side)
        if isinstance(x, (n.TimeDerivative, n.Derivative)) and isinstance(x.of, Letter)
    }
    unsaid = slopes - question.context.definitions.keys() - question.context.given
    if unsaid and all(x == 0 for pair in meant for x in pair):
        names = ", ".join(sorted(map(in_words, unsaid)))
        return Outcome(UNDECIDED, f"nothing says how {names} changes"), question.context
    outcome = compared(*sides, meant, question.rests_on_meaning)
    if outcome.why == A_MINUTE and isinstance(question.context.head, Letter):
        head, at = question.context.head, question.at  # what it says of it is the number
        number = LetterDefinition(question.right, at.number, at.scope)
        return outcome, question.context.defining(head, number)
    return definitions.number_again(question) or (outcome, question.context)


def _always(question: Question) -> Judgement | None:
    """What becomes of it for all times, where it says no more than 0 = 0 of one instant."""
    at = question.at
    said = not (at.instant and ZERO not in (question.left, question.right))
    if said or not question.worlds.vanish([x for pair in question.both for x in pair]):
        return None
    outcome, context = judged(replace(question.always(), asked=None))
    return (outcome, context) if outcome.passed is not None or not at.inline else None


def _vacuous(question: Question) -> Judgement | None:
    """What becomes of it without the special cases in which each of its terms vanishes."""
    context = question.context
    kept = tuple(c for c in context.constraints if c.instant or not _is_case(c, question.moving))
    named = {x: d for x, d in context.definitions.items() if d.node != ZERO}
    sides = (side for pair in question.both for side in pair)
    terms = [x for side in sides for x in Add.make_args(side) if x != 0]
    general = replace(context, constraints=kept, definitions=named)
    is_case = len(kept) + len(named) < len(context.constraints) + len(context.definitions)
    if (terms and len(terms) < 2) or not question.worlds.vanish(terms):
        return None
    if not is_case:
        return _forced(question, terms)
    other = replace(question.within(general), asked=None)
    if other.worlds.holds(other.both):
        return None
    return Outcome(UNDECIDED, ALL_VANISH, question.rests_on), context


def _is_case(constraint: Constraint, moving: frozenset[Letter]) -> bool:
    """Whether a constraint gives what moves a value, at which it stays, or says what vanishes."""
    if constraint.kind == SETTING and constraint.number >= 0:
        return True  # as a vector that is set along another one, and has to vanish for that
    return constraint.right == ZERO or (constraint.left in moving and constraint.stays(moving))


def _failed(question: Question, holds: bool | None) -> Judgement:
    """What becomes of two sides that are not equal in the worlds so far."""
    return (
        _excused(question)
        or _canonical(question)
        or _speed(question)
        or _path(question, holds)
        or _judged_new(question, holds)
    )


def _excused(question: Question) -> Judgement | None:
    """What it says in other words than an equation of what is known now."""
    return (
        approximations.said(question)
        or novelties.dot(question)
        or novelties.force(question)
        or _other_form(question)
        or signs.but_for_a_sign(question)
    )


def _canonical(question: Question) -> Judgement | None:
    """What follows from Hamilton's equations, or would with another sign or number.

    They are not held against what is said otherwise, as there may be forces besides.
    """
    if question.at.closed or question.at.instant or not question.moves(*question.gaps):
        return None
    canonical = question.context
    for each in hamilton(question.context):
        canonical = canonical.holding(each)
    if canonical is question.context:
        return None
    question = replace(question.within(canonical), asked=None)
    forms = (replace(question, chosen={name: node}) for name, node in _forms(question))
    if any(map(_holds_in_motion, (question, *forms))):
        return _worked_out_so(question)
    wrong = faults.slip(question, most=NUMBERS)
    return (wrong.outcome, canonical) if wrong is not None else None


def _holds_in_motion(question: Question) -> bool:
    """Whether the sides are equal, and not only as everything has to stand still."""
    return question.holds() and not question.worlds.vanish([x for y in question.both for x in y])


def _path(question: Question, holds: bool | None) -> Judgement | None:
    """A motion given as a function of the time: it solves what holds, or is tried."""
    path = paths.path_of(question)
    if path is None:
        return None
    question = replace(question, path=path)
    laws, tried = paths.laws(question), paths.tried(question)
    if not laws:
        return Outcome(DEFINITION, f"what {in_words(question.left)} stands for"), tried
    new = question.new_letters
    if not new and not question.inner and _is_another(question, path):
        return Outcome(UNDECIDED, "it is another motion than the one above"), question.context
    if paths.solves(question, path.value) or paths.goes_with_others(question, path.value):
        rests_on = frozenset().union(*(each.rests_on for each in laws))
        rests_on |= question.rests_on_meaning
        solved = replace(tried, results=tried.results | {*new})
        return Outcome(SAMPLED, "it solves what stands above", rests_on), solved
    if Cue.PARTICULAR in question.at.cues and paths.solves(question, path.value, begins=False):
        rests_on = frozenset().union(*(each.rests_on for each in laws)) | question.rests_on_meaning
        return Outcome(SAMPLED, "it solves what stands above", rests_on), question.context
    if paths.is_free(question):
        # One of known letters alone that solves what holds with a small change is wrong.
        wrong = None if new else faults.slip(question, most=faults.FUNCTIONS)
        if wrong is not None:
            return wrong.outcome, wrong.context
        words = f"a motion of {in_words(question.left)} that is tried"
        known = replace(tried, results=tried.results | {*new})
        return Outcome(DEFINITION, words), known
    if question.at.closed:
        return _judged_new(question, holds)
    # A motion that does not obey what holds brings nothing new.
    return _wrong(question, holds)


def _is_another(question: Question, path: TrialMotion) -> bool:
    """Whether the text has said another motion with the same letters, and no condition since."""
    above = question.context.definitions.get(path.letter)
    if above is None or not above.motion or above.scope != question.at.scope:
        return False
    if any(bound.number > above.number for bound in question.context.bounds):
        return False
    both = question.of([(question.meaning().scalar(path.letter), path.value)])
    return bool(both.worlds.count) and not both.holds()


def _speed(question: Question) -> Judgement | None:
    """A velocity given as a function of the time, which solves what holds."""
    path = paths.speed_of(question)
    if path is None:
        return None
    tried = replace(question, path=path)
    if not paths.laws(tried):
        return None
    if not paths.solves(tried, path.value):
        return _wrong_speed(question)
    rests_on = frozenset().union(*(each.rests_on for each in paths.laws(tried)))
    outcome = Outcome(SAMPLED, "it solves what stands above", rests_on | question.rests_on_meaning)
    return outcome, question.context.holding(question.constraint(LAW))


def _wrong_speed(question: Question) -> Judgement | None:
    """The slip with which a velocity has the rate that is known."""
    moving = question.moving
    rates = [(rate(x, moving), rate(y, moving)) for x, y in question.both]

    def agree(both: Sequence[Pair], worlds: Worlds) -> bool:
        return bool(worlds.holds([(rate(x, moving), rate(y, moving)) for x, y in both]))

    wrong = faults.slip(question.of([*question.both, *rates]), agree)
    return (wrong.outcome, wrong.context) if wrong is not None else None


def _judged_new(question: Question, holds: bool | None) -> Judgement:
    """What it brings that is new; else what is wrong with it."""
    return (
        signs.one_root(question)
        or settings.one_value(question)
        or definitions.again(question)
        or settings.place(question)
        or settings.number(question)
        or settings.elsewhere(question)
        or novelties.letters(question)
        or settings.setting(question)
        or settings.chosen(question)
        or settings.part(question)
        or settings.coordinates(question)
        or worth.number(question)
        or novelties.law(question)
        or _wrong(question, holds)
    )


def _wrong(question: Question, holds: bool | None) -> Judgement:
    """What is wrong with what brings nothing new; it is open where that is not seen."""
    context, at = question.context, question.at
    if holds is None:
        return Outcome(UNDECIDED, question.worlds.why_unknown(question.both)), context
    if at.closed:
        near = approximations.near_slip(question) if at.small or at.large else None
        wrong = near or faults.slip(question)
        return wrong.outcome if wrong is not None else refuted(question), context
    if at.anew:
        return Outcome(UNDECIDED, "it is something else than above"), context
    if question.patience.is_over:
        return Outcome(UNDECIDED, DOES_NOT_FOLLOW), context
    # In a line of words it may be said of another case, if it is not a sign or a number.
    wrong = approximations.near_slip(question) if at.small else None
    if wrong is not None:
        return wrong.outcome, context
    wrong = faults.slip(question, most=NUMBERS if at.inline and not at.derived else inf)
    if wrong is not None:
        return wrong.outcome, wrong.context
    fixed = novelties.value(question)
    if fixed is not None:
        return fixed
    outcome = (
        missing.term(question)
        or missing.factor(question)
        or faults.contradiction(question)
        or _worked_out(question)
    )
    outcome = outcome or _wrong_form(question) or acceleration(question)
    return outcome or Outcome(UNDECIDED, DOES_NOT_FOLLOW), context


def _wrong_form(question: Question) -> Outcome | None:
    """The slip with another expression of what is differentiated, by letters that it has alone."""
    for function, other in _forms(question):
        own = question.meaning().scalar(question.context.definitions[function].node)
        by = {x for side in (question.left, question.right) for x in _places(side, function)}
        written_so = function in HAMILTONIANS  # by a place, its momenta stay what they are
        if not by or (not written_so and any(x in letters_of(own) for x in by)):
            continue
        wrong = faults.slip(replace(question, chosen={function: other}, asked=None))
        if wrong is not None:
            return wrong.outcome
    return None


def _places(side: Node, function: Letter) -> Iterator[Node]:
    """The letters by which a function is differentiated."""
    for node in n.walked(side):
        if isinstance(node, n.Derivative) and n.ungrouped(node.of) == function:
            yield from node.by


def _worked_out(question: Question) -> Outcome | None:
    """A counterexample where something known is worked out; None if it may be a condition.

    What is nearly true is left open.
    """
    if not faults.is_settled(question) or approximations.nearly_equal(question) is not None:
        return None
    return faults.multiple(question) or refuted(question)


# --- Another expression of what is differentiated ------------------------------------------------


def _other_form(question: Question) -> Judgement | None:
    """Whether it holds with another expression of a function that is differentiated."""
    for function, other in _forms(question):
        form = replace(question, chosen={function: other}, asked=None)
        try:
            alike = function not in LAGRANGIANS or _moves_alike(question, other)
            if form.holds() and alike:
                return _worked_out_so(question)
        except UnclearError:
            continue
    return None


def _forms(question: Question) -> Iterator[tuple[Letter, Node]]:
    """The other expressions of the functions that are differentiated."""
    for function in _differentiated(question):
        for other in question.context.definitions[function].also:
            yield function, other


def _worked_out_so(question: Question) -> Judgement:
    """That it follows; the letter of the chain is what was found, not what its slope says first."""
    outcome, context = question.follows()
    letter = context.head
    if isinstance(letter, Letter) and letter in context.definitions and question.inner:
        definition = replace(context.definitions[letter], node=question.right, also=())
        context = context.defining(letter, definition)
    return outcome, context


def _differentiated(question: Question) -> set[Letter]:
    """The letters with a meaning of which a derivative stands in it."""
    return {
        of
        for side in (question.left, question.right)
        for node in n.walked(side)
        if isinstance(node, (n.Derivative, n.Primed))
        for of in [n.ungrouped(node.of)]
        if isinstance(of, Letter) and of in question.context.definitions
    }


def _moves_alike(question: Question, other: Node) -> bool:
    """Whether an expression of a Lagrangian moves alike: a momentum may not be put in."""
    meaning = question.meaning()
    try:
        value = meaning.scalar(other)
    except UnclearError:
        return False
    context = question.context
    held = {x for x in own_letters(other) if x in context.definitions and meaning.is_momentum(x)}
    if held:
        value = question.meaning(held=frozenset(held)).scalar(other)
    laws = lagrange(context, question.memory, [], value)
    return all(question.of([(x.expression, 0 * x.expression)]).holds() for x in laws)
