"""What a statement brings that is new: letters, functions, forces, a law of what was free."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from sympy import Basic, Expr, Symbol

from rigidtop.judge import worlds as w
from rigidtop.judge.context import FORCED, LAW, RULE, SETTING, Constraint, LetterDefinition
from rigidtop.judge.context import PREMISE as SUPPOSED
from rigidtop.judge.faults import FUNCTIONS, LIKELY, contradiction, is_worked_out, slip
from rigidtop.judge.jets import TIME, jet_of, jets, rate, symbol
from rigidtop.judge.laws import LAGRANGIANS, coordinates, is_any, lagrange
from rigidtop.judge.letters import CLOCK, FORCES, FREQUENCIES, SPEEDS
from rigidtop.judge.names import is_component, is_vector
from rigidtop.judge.outcome import DEFINITION, PREMISE, SAMPLED, Outcome
from rigidtop.judge.question import Judgement, Question, alone
from rigidtop.judge.settings import fixes
from rigidtop.judge.sides import ZERO, is_acceleration, letters_of, own_letters
from rigidtop.judge.surroundings import highest
from rigidtop.judge.vocabulary import Meant
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.plain import plain as in_words

# --- Letters and functions -----------------------------------------------------------------------


def letters(question: Question) -> Judgement | None:
    """What fixes a letter, or a function, that occurs for the first time."""
    if question.inner and _free_on_the_left(question):
        return None
    new, context = question.new_letters, question.context
    if new and is_worked_out(question) and not question.moves(*question.gaps):
        return None  # it holds whatever they are
    kind = SETTING if question.at.supposed or question.at.balanced else SUPPOSED
    if new and _are_zero(question, new, kind):
        return None
    if not new:
        if not _brings_a_function(question):
            return None
        outcome = Outcome(PREMISE, "it brings a function", question.rests_on_meaning)
        return outcome, context.holding(question.constraint(kind))
    mistaken = new[0] not in question.at.declared and not question.at.anew
    mistaken = mistaken and not _is_start_value(question, new[0])
    if len(new) == 1 and mistaken and not _names(question, new):
        wrong = slip(question, letter=new[0])
        if wrong is not None:
            return wrong.outcome, wrong.context
    if len(new) == 1 and _rate_follows(question, new[0]) and _begins_so(question, new[0]):
        words = f"{in_words(new[0])} is a constant of integration"
        outcome = Outcome(SAMPLED, words, question.rests_on)
        return outcome, context.holding(question.constraint(SUPPOSED))
    if len(new) == 1:
        solved = _solved(question, new[0])
        if solved is not None:
            definition = LetterDefinition(solved, question.at.number, question.at.scope)
            return brings(question, new), context.defining(new[0], definition)
    square = _square(question)
    if square is not None:
        root = LetterDefinition(n.Root(question.right), question.at.number, question.at.scope)
        return brings(question, new), context.defining(square, root)
    known = replace(context, results=context.results | _results(question, new))
    return brings(question, new), known.holding(question.constraint(kind))


def _are_zero(question: Question, new: Sequence[Letter], kind: str) -> bool:
    """Whether it can only hold if the new letters are zero, as the rest of it vanishes."""
    nothing = {alone(x): 0 for x in new if not is_vector(x)}
    said = question.right == ZERO or len(nothing) < len(new)  # x = 0 says just that
    rest = [gap.subs(nothing) for gap in question.gaps]
    # A law may have a force besides, but not what is worked out from it.
    vanishes = question.inner and question.worlds.holds([(gap, 0 * gap) for gap in rest])
    if said or (any(rest) and not vanishes):
        return False
    known = question.context.holding(question.constraint(kind))
    there = question.of(question.both, known).worlds
    return not there.count or bool(there.zeros - question.worlds.zeros)


def _square(question: Question) -> Letter | None:
    """A new letter of which the square is said to be something that moves.

    It moves with that: were it a constant, all would stand still.
    """
    match question.left:
        case n.Power(Letter() as letter, n.Number("2")) if letter in question.new_letters:
            moving = {x for x in letters_of(question.gaps[0]) if x in question.moving}
            free = not is_vector(letter) and not question.at.instant
            positive = letter.base in FREQUENCIES and not moving and question.at.derived
            return letter if free and (positive or len(moving - {letter}) == 1) else None
    return None


def _is_start_value(question: Question, letter: Letter) -> bool:
    """Whether a chain that begins with x(0) calls that x₀."""
    head = question.context.head
    named = isinstance(head, Letter) and letter == replace(head, sub="0")
    return bool(question.at.instant) and named


def _names(question: Question, new: Sequence[Letter]) -> bool:
    """Whether the left side is a letter that nothing gives, or has none but new ones."""
    if isinstance(question.left, Letter):
        return not (question.at.derived and _comes_out(question))
    return own_letters(question.left) <= {*new}


def brings(question: Question, new: Sequence[Letter]) -> Outcome:
    """The outcome of a statement that is a premise since it brings letters."""
    words = ", ".join(map(in_words, new))
    names = frozenset(map(in_words, new))
    # What has been said names nothing, nor does a ratio: what follows in the chain rests on it.
    told = bool(own_letters(question.left) - {*new})
    ties = told or (len(new) > 1 and isinstance(question.left, n.Quotient))
    outcome = Outcome(PREMISE, f"it brings {words}", question.rests_on_meaning, brings=names)
    return replace(outcome, restricts=ties)


def _results(question: Question, new: Sequence[Letter]) -> frozenset[Letter]:
    """New letters that stand alone as a term, as the force in m z̈ = N − m g, or in a motion."""
    if question.at.instant:
        return frozenset()
    if question.left in question.moving and any(right.has(TIME) for _, right in question.both):
        return frozenset(new)
    return frozenset(x for x in new for gap in question.gaps if gap.diff(alone(x)) in (1, -1))


def _brings_a_function(question: Question) -> bool:
    known = {x for e in question.equations for x in e.free_symbols}
    return any(
        x.name.startswith("f(") and x not in known
        for left, right in question.both
        for x in left.free_symbols ^ right.free_symbols
    )


def _rate_follows(question: Question, letter: Letter) -> bool:
    """Whether the rates of both sides agree, so that the new letter is their difference."""
    x = alone(letter)
    vectors = question.context.habits.vectors
    still = letter not in question.moving and not is_vector(letter)
    if (
        any(is_component(letter, x) for x in vectors)
        or not still
        or question.at.instant
        or question.path is not None
    ):
        return False
    if any(jet.order > 1 for gap in question.gaps for jet in jets(gap).values()):
        return False  # nothing is integrated in an acceleration
    rates = [rate(gap, question.moving) for gap in question.gaps]
    speaks = any(gap.has(x) for gap in question.gaps) and not any(r.has(x) for r in rates)
    if not speaks or not any(rates):
        return False
    return question.of([(r, 0 * r) for r in rates]).holds()


def _begins_so(question: Question, letter: Letter) -> bool:
    """Whether v₀ is what v is at t = 0, where the line has both and the time."""
    value = replace(letter, sub="")
    if letter.sub != "0" or value not in question.moving:
        return True
    start = {alone(value): alone(letter), TIME: 0}
    timed = [gap for gap in question.gaps if gap.has(TIME) and gap.has(alone(value))]
    begun = [gap.subs(start, simultaneous=True) for gap in timed]
    return all(question.moves(x) or x.equals(0) for x in begun)


def _solved(question: Question, letter: Letter) -> Node | None:
    """What a new letter is by a linear equation; None where it is not linear, or moves."""
    x = alone(letter)
    if is_vector(letter) or letter in question.moving or len(question.both) > 1:
        return None
    [gap] = question.gaps
    slope = gap.diff(x)
    if question.at.instant or slope.has(x) or slope == 0 or question.moves(slope):
        return None  # in J θ̈ = … what is new is a constant
    if question.left == letter and slope == 1:
        return question.right
    if question.right == letter and (question.left in question.moving or _is_kept(letter, gap)):
        return None  # what moves stays at it
    if isinstance(question.left, n.TimeDerivative) or (gap.has(TIME) and question.moves(gap)):
        return None  # it makes something move, and stays what it is
    return Meant(-gap.subs(x, 0) / slope)


_INTEGRALS = frozenset("hLlℓEcCJDK")
"""Letters of constants of the motion."""


def _is_kept(letter: Letter, gap: Expr) -> bool:
    """Whether a letter on the right is a constant of the motion by its name: r² φ̇ = h."""
    orders = [jet.order for jet in jets(gap).values()]
    return letter.base in _INTEGRALS and max(orders, default=0) == 1


def rule(question: Question) -> Judgement | None:
    """A rule for any coordinate that has more than the Lagrangian in it, as friction."""
    nodes = [x for side in (question.left, question.right) for x in n.walked(side)]
    slopes = [x for x in nodes if isinstance(x, n.Derivative)]
    bare = {x.of if isinstance(x, n.TimeDerivative) else x for slope in slopes for x in slope.by}
    places = {x for x in bare if isinstance(x, Letter) and is_any(x)}
    functions = {slope.of for slope in slopes if isinstance(slope.of, Letter)}
    known = question.context.definitions
    if not places or any(x in known and not isinstance(known[x].node, Letter) for x in places):
        return None
    if not functions & {*LAGRANGIANS} or functions <= {*LAGRANGIANS}:
        return None
    context = question.context.holding(question.constraint(RULE))
    return Outcome(PREMISE, "it holds of each coordinate"), context


# --- What was free -------------------------------------------------------------------------------


def law(question: Question) -> Judgement | None:
    """An equation of motion of what no law moves: it fixes a highest rate that was free."""
    within = question.inner and not _is_force(question.context.head)
    if not question.worlds.count or within or question.at.instant or question.at.closed:
        return None
    sides = (question.left, question.right)
    heads = {side.of if isinstance(side, n.TimeDerivative) else side for side in sides}
    heads |= {x.of for side in sides for x in n.walked(side) if isinstance(x, n.TimeDerivative)}
    known = _with_meaning(question)
    said = question.context.definitions
    named = any(
        x in said or any(is_component(x, v) for v in said) for x in own_letters(question.left)
    )
    if named or any(isinstance(x, Letter) and x in known for x in heads):
        # What stands for something moves as that does, if it is not a law.
        wrong = slip(question)
        if wrong is not None:
            return wrong.outcome, wrong.context
    free = highest([*question.gaps, *question.equations])
    head = question.context.head
    if question.inner and head is not None and _ACCELERATION in n.letters(head):
        free.append(alone(_ACCELERATION))  # m a = m ẍ = … says what both are
    if not free or _holds_still(question, free):
        return None
    if not fixes(question, free):
        if not _ties_velocities(question, free):
            return None
        wrong = slip(question)
        if wrong is not None:
            return wrong.outcome, wrong.context
    if own_letters(question.left) & known and not question.at.supposed:
        orders = [jet.order for gap in question.gaps for jet in jets(gap).values()]
        most = FUNCTIONS if max(orders, default=0) == 1 else LIKELY
        against = contradiction(question, most)
        if against is not None:
            return against, question.context
    outcome = Outcome(PREMISE, "it is taken as it stands", question.rests_on_meaning)
    return outcome, question.context.holding(question.constraint(LAW))


def _holds_still(question: Question, free: Sequence[Symbol]) -> bool:
    """Whether with it nothing of what it speaks of moves any more."""
    own = [x for x in free if any(gap.has(x) for gap in question.gaps)]
    if question.right == ZERO or len(own) < 2 or question.worlds.vanish(own):
        return False
    known = question.context.holding(question.constraint(LAW))
    with_it = question.of([*question.both, *((x, x) for x in own)], known).worlds
    return with_it.vanish(own)


def _ties_velocities(question: Question, free: Sequence[Symbol]) -> bool:
    """Whether it ties velocities, as rolling does, and what is not known yet are the forces.

    Were they, only special motions would obey it.
    """
    moving = [x for gap in question.gaps for x in jets(gap).values() if question.moves(symbol(x))]
    speeds = all(x.order == (0 if x.letter.base in SPEEDS else 1) for x in moving)
    if not speeds or len(moving) < 2 or question.at.derived or question.right == ZERO:
        return False
    results = question.context.results
    forces = [
        x
        for x, jet in ((x, jet_of(x)) for x in question.worlds.letters)
        if jet is not None and (jet.letter in results or jet.letter.base in FORCES)
    ]
    rates = [rate(gap, question.moving) for gap in question.gaps]
    equations, unknown = question.equations, [*free, *(x for x in forces if x not in free)]
    worlds = question.of([*question.both, *((x, 0 * x) for x in rates)]).worlds
    before = w.rank(equations, worlds, unknown)
    return w.rank([*equations, *rates], worlds, unknown) == before + len(rates)


def _with_meaning(question: Question) -> frozenset[Letter]:
    """Letters of which it is said what they are, or that stand alone on a side of what holds."""
    context = question.context
    alone = {c.left for c in context.constraints if c.kind == SUPPOSED and not c.instant}
    return frozenset({*context.definitions, *(x for x in alone if isinstance(x, Letter))})


def _is_force(head: Node | None) -> bool:
    """Whether a chain begins with a force, or the sum of all, or with a mass and how it speeds up.

    F = m a = … is Newton's law, and so is m a = m ẍ = ….
    """
    side = head.of if isinstance(head, n.Total) and not head.index else head
    if isinstance(side, n.Product):
        return any(x == _ACCELERATION or is_acceleration(x) for x in side.factors)
    return isinstance(side, Letter) and side.base == "F"


_ACCELERATION = Letter("a")


def force(question: Question) -> Judgement | None:
    """Lagrange's equation with a force on its right side, which holds from here on."""
    names = {
        x
        for node in n.walked(question.left)
        if isinstance(node, n.Derivative)
        for x in n.letters(node.of)
    }
    at = question.at
    if question.inner or at.instant or at.closed or not names & {*LAGRANGIANS}:
        return None
    laws = lagrange(question.context, question.memory, [])
    [(left, right), *more] = question.both
    if more or right == 0 or not any((left - x.expression).expand() == 0 for x in laws):
        return None
    new = question.new_letters
    outcome = Outcome(PREMISE, "it brings a force", question.rests_on_meaning)
    outcome = brings(question, new) if new else outcome
    context = question.context.holding(question.constraint(FORCED))
    for each in _for_the_others(question):
        context = context.holding(each)
    return outcome, context


def _for_the_others(question: Question) -> Iterator[Constraint]:
    """The same rule for the other coordinates, where its force is the slope of a function."""
    slopes = [
        x
        for x in n.walked(question.right)
        if isinstance(x, n.Derivative) and len(x.by) == 1 and isinstance(x.by[0], n.TimeDerivative)
    ]
    if len(slopes) != 1 or not isinstance(slopes[0].of, Letter):
        return
    [own] = slopes[0].by
    value = question.meaning().scalar(slopes[0].of)
    for jet in coordinates(value):
        if isinstance(own, n.TimeDerivative) and jet.letter != own.of:
            left, right = (
                n.replaced(side, own.of, jet.letter) for side in (question.left, question.right)
            )
            yield Constraint(left, right, question.at.number, FORCED, question.at.scope)


def dot(question: Question) -> Judgement | None:
    """What a dot means, where it is said to be the derivative by another letter than the time."""
    left, right = question.left, question.right
    if not (isinstance(left, n.TimeDerivative) and left.dotted and isinstance(right, n.Derivative)):
        return None
    if left.of != right.of or CLOCK in right.by:
        return None
    by = ", ".join(map(in_words, right.by))
    return Outcome(DEFINITION, f"a dot is the derivative by {by}"), question.context


def value(question: Question) -> Judgement | None:
    """What fixes letters that have occurred, and of which nothing has been said."""
    at, context = question.at, question.context
    said = at.defined or at.supposed or at.inline or at.balances
    if not question.worlds.count or (at.derived and not question.inner):
        return None
    if not at.supposed and _comes_out(question):
        return None  # it would tie parameters to each other
    free = _free_on_the_left(question) if said or question.inner else []
    if not free and not question.inner and not _is_result(question):
        free = _free_in_premises(question) or _tied(question)
    if not free or not fixes(question, free):
        return None
    fixed = {jet.letter for x in free if (jet := jet_of(x)) is not None}
    above = (d for d in context.definitions.values() if d.number != at.number)
    spoken = frozenset().union(*(n.letters(d.node) for d in above))
    outcome = brings(question, sorted(fixed, key=str))
    outcome = replace(outcome, restricts=bool(fixed & spoken))
    if len(fixed) == 1:
        [letter] = fixed
        solved = _solved(question, letter)
        if solved is not None:
            definition = LetterDefinition(solved, at.number, at.scope)
            return outcome, context.defining(letter, definition)
    rates = any(jet.order for gap in question.gaps for jet in jets(gap).values())
    # What ties rates, as rolling does, stays, and so do the equations of a list.
    passed = at.inline and not rates and not (at.scope and at.scope[-1] < 0)
    kind = SETTING if passed or at.balanced else SUPPOSED
    if question.right == ZERO:
        context = replace(context, results=context.results | fixed)
    return outcome, context.holding(question.constraint(kind))


def _is_result(question: Question) -> bool:
    """Whether the left side is made of letters that come out, as amplitudes do, and not free."""
    names = own_letters(question.left)
    return bool(names) and names <= question.context.results


def _comes_out(question: Question) -> bool:
    """Whether the left side is a letter that what holds gives, as it gives a force."""
    if not isinstance(question.left, Letter):
        return False
    equations, worlds, letter = question.equations, question.worlds, alone(question.left)
    rates = [x for x in worlds.letters if (jet := jet_of(x)) is not None and jet.order]
    if not rates or not any(x.has(letter) for x in equations):
        return False
    others = w.rank(equations, worlds, rates)
    return w.rank(equations, worlds, [letter, *rates]) == others + 1 and others == len(rates)


def _free_in_premises(question: Question) -> list[Symbol]:
    """Letters of which only premises speak, and neither laws nor what letters stand for."""
    spoken: set[Basic] = set()
    other: set[Basic] = set()
    for each in question.pool:
        (spoken if each.kind == SUPPOSED else other).update(each.expression.free_symbols)
    definitions = question.context.definitions.values()
    named = frozenset().union(*(n.letters(d.node) for d in definitions))
    return [
        x
        for x in w.symbols_of([x for pair in question.both for x in pair])
        if x in spoken - other and (jet := jet_of(x)) is not None and jet.letter not in named
    ]


def _tied(question: Question) -> list[Symbol]:
    """A letter on the left that nothing fixes, where what it is said to be comes from it in turn.

    Two such relations are solved together.
    """
    letter, context = question.left, question.context
    known = context.definitions.keys() | context.given | question.moving
    if not isinstance(letter, Letter) or letter in known | own_letters(question.right):
        return []
    bound = {x for each in question.pool for x in each.expression.free_symbols}
    return [x for x in question.worlds.letters if x == alone(letter) and x not in bound]


def _free_on_the_left(question: Question) -> list[Symbol]:
    """Letters of the left side alone of which nothing has been said."""
    bound = {x for each in question.pool for x in each.expression.free_symbols}
    bound |= {x for _, right in question.both for x in right.free_symbols}
    left = w.symbols_of([left for left, _ in question.both])
    return [x for x in left if x not in bound and jet_of(x) is not None]
