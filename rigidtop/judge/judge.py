"""A statement judged in a context, and the context behind it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, field, replace
from itertools import chain

from rigidtop.judge import approximations, bounds, cases, equality, places, remainders, roots
from rigidtop.judge.components import along, each_component, each_entry
from rigidtop.judge.context import PREMISE as SUPPOSED
from rigidtop.judge.context import (
    SETTING,
    START,
    Constraint,
    Context,
    LetterDefinition,
    LimitingCase,
)
from rigidtop.judge.jets import jets
from rigidtop.judge.laws import LAGRANGIANS, coordinates
from rigidtop.judge.letters import TURNING
from rigidtop.judge.meaning import Meaning
from rigidtop.judge.names import is_component
from rigidtop.judge.outcome import (
    DEFINITION,
    FALSE,
    PREMISE,
    SAMPLED,
    UNDECIDED,
    Outcome,
    joint,
)
from rigidtop.judge.program import UnknownFunctionError
from rigidtop.judge.question import Judgement, Patience, Premises, Question
from rigidtop.judge.remainders import has_order
from rigidtop.judge.sides import (
    CONDITIONS,
    EQUALS,
    NEARLY,
    ZERO,
    braces,
    gives_all_a_value,
    has_components,
    is_acceleration,
    letters_in,
    letters_of,
    named,
    own_letters,
    says_its_places,
    with_constant_last,
    with_ratio,
    without_places,
)
from rigidtop.judge.situation import Situation
from rigidtop.judge.suppositions import suppositions
from rigidtop.judge.values import UnclearError
from rigidtop.judge.vocabulary import Memory
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.plain import plain as in_words
from rigidtop.tree.several import has_sign
from rigidtop.tree.statement import Statement

MOST_OPEN = 3
"""So many lines that were left open are tried where a line would be wrong without them."""

_KINETIC, _POTENTIAL = Letter("T"), Letter("V")
_TOTALS = (Letter("E"), Letter("H"))
"""Letters of the whole energy."""

_PRODUCTS = {"⊥": n.DotProduct, "∥": n.CrossProduct}
"""The product of two vectors that vanishes where they stand so to each other."""

GREATER, LESS = ("≥", ">"), ("≤", "<")


@dataclass
class Judge:
    """What judges the statements of one text.

    It remembers what letters stand for. Once its patience to look for slips is over, what would be
    false for a slip is undecided.
    """

    memory: Memory = field(default_factory=Memory)
    patience: Patience = field(default_factory=Patience)

    def judged(self, statement: Statement, situation: Situation, context: Context) -> Judgement:
        """What becomes of a statement, and what is known after it."""
        statement = without_places(statement)
        statement, context = approximations.limited(statement, situation, context)
        if says_its_places(statement):
            why = f"what {in_words(statement.sides[0])} depends on"
            return Outcome(PREMISE, why), context.knowing(letters_in(statement))
        if cases.is_one_of_cases(statement, situation, context):
            return Outcome(PREMISE, "a condition"), context.knowing(letters_in(statement))
        outcome, after = self._for_each(statement, situation, context)
        doubting = context.doubting(statement.sides[0])
        names = outcome.verdict == DEFINITION and outcome.brings  # "is Q = … canonical?"
        if situation.asked and not (outcome.passed or names):
            return Outcome(UNDECIDED, "it is asked, or denied"), doubting
        if outcome.verdict == FALSE and cases.may_be_elsewhere(statement, situation, context):
            why = "it is otherwise above; the words may speak of another case"
            return Outcome(UNDECIDED, why, outcome.rests_on), doubting
        if outcome.passed and cases.is_said_again(statement, situation, context):
            why = "it is the same above, and the words speak of another case"
            return Outcome(UNDECIDED, why, outcome.rests_on), doubting
        if outcome.verdict == FALSE and outcome.rests_on & context.doubted:
            why = "it rests on what has been said in two ways"
            return Outcome(UNDECIDED, why, outcome.rests_on), context
        if outcome.verdict == FALSE and self._open(statement, situation, context):
            why = "it follows from what is left open above"
            return Outcome(UNDECIDED, why, outcome.rests_on), doubting
        if outcome.verdict == UNDECIDED and (
            open_line := self._open(statement, situation, context)
        ):
            why = "it follows from a line above that is left open"
            outcome = Outcome(SAMPLED, why, frozenset({open_line.number}))
        if outcome.verdict == UNDECIDED:
            after = _with_open(statement, situation, after.doubting(statement.sides[0]))
        supposed = situation.supposed and outcome.verdict == FALSE
        if situation.closed or outcome.passed or not (situation.case or supposed):
            return outcome, after
        # What is said of a case says nothing of the others.
        return Outcome(PREMISE, "a special case"), doubting.knowing(letters_in(statement))

    def _for_each(self, statement: Statement, situation: Situation, context: Context) -> Judgement:
        """The outcome of all components, where it speaks of any one."""
        known = context.letters | context.given | context.declared | context.definitions.keys()
        outcomes, after = [], context
        entries = (each_entry(x, known) for x in each_component(statement, known))
        for each in chain.from_iterable(entries):
            outcome, after = self._in_place(each, situation, after)
            outcomes.append(outcome)
        return joint(outcomes), after

    def _open(
        self, statement: Statement, situation: Situation, context: Context
    ) -> Constraint | None:
        """What is said above and was left open, where it follows if that holds."""
        judge = replace(self, patience=Patience(0))  # whether there is a slip is not asked
        return next(
            (
                each
                for each in context.open[-MOST_OPEN:]
                if judge._in_context(statement, situation, context.holding(each))[0].passed
            ),
            None,
        )

    # --- the contexts in which it may be meant ---------------------------------------------------

    def _in_place(self, statement: Statement, situation: Situation, context: Context) -> Judgement:
        """The outcome as it stands, or with what may be left unsaid if it follows so."""
        usual = self._in_context(statement, situation, context)
        if situation.balanced:  # what is said of the moment is so all the time
            context = context.staying(situation.instant, situation.sentence)
            situation = replace(situation, instant="")
        if usual[0].passed:
            return usual
        wrong = None
        is_open = usual[0].passed is None
        for each in suppositions(statement, situation, context, self.memory, is_open):
            outcome, after = self._in_context(each.statement, each.situation, each.context)
            behind = replace(usual[1], accelerations=after.accelerations)
            known = after if each.lasts else behind
            if outcome.passed:
                return replace(outcome, why=each.words or outcome.why), known
            if outcome.slip and each.tells and wrong is None:
                # As it stands it brought something, which is not so.
                before = context.knowing(letters_in(statement))
                wrong = outcome, known if each.lasts else before
        if self._solves(statement, situation, context):
            return Outcome(SAMPLED, "it solves what stands above"), usual[1]
        return wrong if wrong is not None and is_open else usual

    def _solves(self, statement: Statement, situation: Situation, context: Context) -> bool:
        """Whether it is one of the solutions of what was said before to vanish."""
        away = situation.inline or situation.closed or situation.instant
        if statement.relations != ("=",) or away:
            return False
        zeros = [c for c in context.constraints if c.kind == SETTING and c.right == ZERO]
        zeros = [c for c in zeros if c.instant != START][-1:]
        pairs: list[tuple[Node, Constraint | None]] = [(c.left, c) for c in zeros]
        if context.said[1:] == (ZERO,) and (
            not isinstance(context.said[0], Letter) or context.said[0] in context.definitions
        ):
            pairs.insert(0, (context.said[0], None))
        for left, constraint in pairs:
            equation = Statement((left, ZERO), ("=",), 0)
            kept = tuple(c for c in context.constraints if c is not constraint)
            free = places.resting(situation, replace(context, constraints=kept))
            there = replace(situation, instant=places.THERE)
            solved = places.solution(statement, situation, free)
            if self._in_context(equation, there, free)[0].passed:
                continue
            if self._in_context(equation, there, solved)[0].passed:
                return True
        return False

    def _in_context(
        self, statement: Statement, situation: Situation, context: Context
    ) -> Judgement:
        if context.bases and context.basis is None and has_components(statement):
            return self._in_some_axes(statement, situation, context)
        head, _ = named(statement.sides[0])
        derived = [*self._with_derived(head, context, situation)]
        for each in derived:
            judgement = self._in_order(statement, situation, each)
            # Whose momentum p is, is not said.
            single = len(derived) == 1 and not self._is_driven(head, context)
            if judgement[0].passed or (single and judgement[0].verdict != UNDECIDED):
                return judgement
        return self._with_components(statement, situation, context)

    def _is_driven(self, letter: Letter | None, context: Context) -> bool:
        """Whether the energy may not be ∑ q̇ ∂L/∂q̇ − L, as something turns at a given rate."""
        function = next((x for x in LAGRANGIANS if x in context.definitions), None)
        if letter not in _TOTALS or function is None:
            return False
        try:
            value = Meaning(context, self.memory).scalar(function)
        except UnclearError:
            return False
        rates = [x for x, jet in jets(value).items() if jet.order]
        rest = value.subs(dict.fromkeys(rates, 0))
        return any(jet.letter.base in TURNING for jet in jets(rest).values())

    def _in_some_axes(
        self, statement: Statement, situation: Situation, context: Context
    ) -> Judgement:
        """The outcome in the axes in which components are right, else in the first ones.

        What new letters stand for is none of the axes along which some of them would vanish.
        """
        judgements = []
        for basis in context.bases:
            outcome, after = self._in_context(statement, situation, replace(context, basis=basis))
            judgements.append((outcome, along(basis, after, context)))
            if outcome.passed:
                return judgements[-1]
        order = (FALSE, DEFINITION)

        def rank(judgement: Judgement) -> tuple[int, int]:
            outcome, after = judgement
            if outcome.verdict != PREMISE:
                return order.index(outcome.verdict) if outcome.verdict in order else 2, 0
            left, right, *_ = statement.sides
            new = letters_in(statement) - context.letters
            with suppress(UnclearError):
                zeros = self._question(left, right, situation, after, False).worlds.zeros
                return 2, sum(bool(letters_of(x) & new) for x in zeros)
            return 2, 0

        return min(judgements, key=rank)

    def _with_derived(
        self, letter: Letter | None, context: Context, at: Situation
    ) -> Iterator[Context]:
        """What p_θ or E stands for where there is a Lagrangian with θ, and nothing else says it."""
        function = next((x for x in LAGRANGIANS if x in context.definitions), None)
        if letter is None or letter in context.definitions or letter.bold:
            return
        if function is None and letter.base == "p" and letter.sub:
            function = _KINETIC if {_KINETIC, _POTENTIAL} <= context.definitions.keys() else None
        if function is None:
            if letter in _TOTALS and {_KINETIC, _POTENTIAL} <= context.definitions.keys():
                total = n.Sum((_KINETIC, _POTENTIAL))
                yield context.defining(letter, LetterDefinition(total, at.number, at.scope))
            return
        with suppress(UnclearError):
            for meant in self._meant_by(letter, function, context):
                if Meaning(context, self.memory).scalar(meant) != 0:
                    yield context.defining(letter, LetterDefinition(meant, at.number, at.scope))

    def _meant_by(self, letter: Letter, function: Letter, context: Context) -> Iterator[Node]:
        """Momenta, or the energy, of a Lagrangian that a letter usually means."""
        value = Meaning(context, self.memory).scalar(function)
        rates = [n.TimeDerivative(jet.letter, 1, True) for jet in coordinates(value)]
        if letter.base == "p":
            own = [v for v in rates if v.of == Letter(letter.sub)] if letter.sub else rates
            yield from (n.Derivative(function, (v,)) for v in own)
        elif letter in _TOTALS:
            terms = [n.Product((v, n.Derivative(function, (v,)))) for v in rates]
            yield n.Sum((*terms, n.Negative(function)))

    def _with_components(
        self, statement: Statement, situation: Situation, context: Context
    ) -> Judgement:
        """The outcome where ω₁ is a component of the vector, if it follows so; else as it is.

        Once something has followed so, what does not is judged so too.
        """
        names, vectors = letters_in(statement), context.habits.vectors
        usual = self._in_order(statement, situation, context)
        settled = usual[0].passed or usual[0].verdict == DEFINITION
        if settled or not any(is_component(x, v) for x in names for v in vectors):
            return usual
        other = replace(context, componentwise=not context.componentwise)
        judgement = self._in_order(statement, situation, other)
        return judgement if judgement[0].passed else usual

    # --- its relations one after the other -------------------------------------------------------

    def _in_order(self, statement: Statement, situation: Situation, context: Context) -> Judgement:
        statement = with_constant_last(with_ratio(statement, context.habits.moving))
        outcomes = []
        before = context
        head, _ = named(statement.sides[0])
        if not statement.continues:
            context = replace(context, head=head or statement.sides[0])
        try:
            for k, relation in enumerate(statement.relations):
                left, right = statement.sides[k : k + 2]
                inner = k > 0 or statement.continues
                if gives_all_a_value(statement):
                    right, inner = statement.sides[-1], statement.continues
                question = self._question(left, right, situation, context, inner)
                outcome, context = _related(question, relation)
                context = _accelerated(question, outcome, context)
                if inner and outcome.verdict == PREMISE:
                    context = _explicit(question, context)
                if inner and outcome.verdict == FALSE:
                    outcome = self._by_head(question, context) or outcome
                if outcome.verdict == FALSE and len(statement.relations) > 1:
                    where = f"{in_words(left)} {relation} {in_words(right)}"
                    outcome = replace(outcome, why=f"{where}: {outcome.why}")
                outcomes.append(outcome)
        except (UnclearError, UnknownFunctionError) as why:
            undecided = Outcome(UNDECIDED, str(why))
            clear = self._without_unclear(statement, before)
            if clear is None:
                return undecided, before.knowing(letters_in(statement))
            outcome, context = self._in_order(clear, situation, before)
            return (undecided if outcome.passed else outcome), context
        wrong, context = self._braced(statement, situation, context)
        outcome = joint([*outcomes, *wrong])
        said = () if outcome.verdict == FALSE else statement.sides
        return outcome, replace(context.knowing(letters_in(statement)), said=said)

    def _by_head(self, question: Question, context: Context) -> Outcome | None:
        """That a link follows from the head of its chain, where the one before it is wrong.

        None if it does not.
        """
        head, at = context.head, question.at
        if not isinstance(head, Letter) or head not in context.definitions:
            return None
        told = self._question(head, question.left, at, context, True)
        if _related(told, "=")[0].verdict != FALSE:
            return None
        outcome, _ = _related(self._question(head, question.right, at, context, True), "=")
        return outcome if outcome.passed else None

    def _without_unclear(self, statement: Statement, context: Context) -> Statement | None:
        """A chain without the sides that have no meaning; None if too little is left of it."""

        def is_clear(side: Node) -> bool:
            try:
                Meaning(context, self.memory).value(side)
            except (UnclearError, UnknownFunctionError):
                return isinstance(side, n.Constant)
            return True

        sides = tuple(side for side in statement.sides if is_clear(side))
        whole = len(sides) == len(statement.sides) or {*statement.relations} != {"="}
        head = statement.sides[0]
        if whole or len(sides) < 2 or not (sides[0] == head or isinstance(head, n.Integral)):
            return None
        return replace(statement, sides=sides, relations=("=",) * (len(sides) - 1))

    def _braced(
        self, statement: Statement, situation: Situation, context: Context
    ) -> tuple[list[Outcome], Context]:
        """What is false of what stands below braces, and the context in which the rest holds."""
        wrong = []
        for brace in braces(statement):
            name = brace.label
            assert name is not None
            with suppress(UnclearError, UnknownFunctionError):
                question = self._question(name, brace.of, situation, context, True)
                outcome, context = _related(question, "=")
                if outcome.verdict == FALSE:
                    where = f"{in_words(name)} below a brace: {outcome.why}"
                    wrong.append(replace(outcome, why=where))
        return wrong, context

    def _question(
        self, left: Node, right: Node, at: Situation, context: Context, inner: bool
    ) -> Question:
        if isinstance(right, n.Constant):
            left, right = n.TimeDerivative(left), ZERO
        premises = Premises(context, self.memory, at.instant)
        return Question(left, right, at, premises, self.patience, inner)


def _explicit(question: Question, context: Context) -> Context:
    """What is known where the next link of a chain says in other letters what its head is.

    T = ½ m Ṙ² = ½ m (ẋ² + ẏ²) is differentiated by ẋ, which R hides.
    """
    head, definitions = context.head, context.definitions
    if not isinstance(head, Letter) or head not in definitions:
        return context
    known, right = definitions[head], question.right
    hidden = own_letters(question.left) & question.moving - definitions.keys() - own_letters(right)
    told = own_letters(right) & question.moving
    if known.node != question.left or not hidden or not told or head in own_letters(right):
        return context
    return context.defining(head, replace(known, node=right, also=(*known.also, known.node)))


def _with_open(statement: Statement, at: Situation, context: Context) -> Context:
    """What is known behind a line that is left open: what it says may be."""
    left, *_, right = statement.sides
    equal = {*statement.relations} <= {*EQUALS, *NEARLY}
    if not equal or right == ZERO or (at.inline and not isinstance(left, Letter)):
        return context
    supposed = Constraint(left, right, at.number, SUPPOSED, at.scope)
    return replace(context, open=(*context.open, supposed))


def _accelerated(question: Question, outcome: Outcome, context: Context) -> Context:
    """What is known with an equation of motion; if one is wrong or open, none is."""
    sides = question.left, question.right
    if not any(is_acceleration(x) for side in sides for x in n.walked(side)):
        return context
    if outcome.verdict in (FALSE, UNDECIDED):
        return replace(context, accelerations=())
    equation = Constraint(*sides, question.at.number, SUPPOSED, question.at.scope)
    return replace(context, accelerations=(*context.accelerations, equation))


def _related(question: Question, relation: str) -> Judgement:
    """The outcome of two sides with a relation between them; raises UnclearError."""
    signs = has_sign(question.left) or has_sign(question.right)
    if has_order(question.left) or has_order(question.right):
        if relation not in (*EQUALS, *NEARLY):
            raise UnclearError(f"{relation} is not judged beside O(…)")
        return remainders.judged(question)
    if relation in EQUALS:
        return roots.judged(question) if signs else equality.judged(question)
    if relation in NEARLY:
        judge = approximations.judged
        return roots.each_sign(question, judge) if signs else judge(question)
    if relation == "→":
        return approximations.tending(question)
    if relation in _PRODUCTS:
        product = _PRODUCTS[relation](question.left, question.right)
        return equality.judged(replace(question, left=product, right=ZERO))
    if relation not in CONDITIONS:
        raise UnclearError(f"{relation} is not judged")
    if question.at.inline:
        freed = question.context.freeing(question.left, question.right)
        question = question.within(freed)
    if relation in (*GREATER, *LESS) and not question.inner:
        if relation in LESS:
            question = replace(question, left=question.right, right=question.left)
        return bounds.judged(question)
    return _conditioned(question, relation)


def _conditioned(question: Question, relation: str) -> Judgement:
    """The outcome of ≠, ≪ and ≫, and of a bound within a chain: what holds from here on."""
    context = question.context
    if relation == "≠":
        right = question.right
        for other in right.entries if isinstance(right, n.Tuple) else (right,):
            each = replace(question, right=other)
            same = each.left == other
            if each.at.closed and (same or equality.judged(each)[0].passed):
                return Outcome(FALSE, "the two are equal"), question.context
            gap = n.Sum((each.left, n.Negative(other)))
            context = replace(context, not_zero=(*context.not_zero, gap))
    elif relation in ("≪", "≫"):
        less, more = question.left, question.right
        if relation == "≫":
            less, more = more, less
        context = context.comparing(own_letters(less), question.at.sentence)
        if isinstance(less, n.Number) and isinstance(more, Letter):  # x ≫ 1, whatever it was above
            limit = LimitingCase(more, True, question.at.sentence)
            kept = tuple(x for x in context.little if x and more not in x)
            context = replace(context, little=kept, limits=(*context.limits, limit))
    # At the end of a chain it is not shown by the links before it.
    return Outcome(PREMISE, "a condition", restricts=not _is_seen(question, relation)), context


def _is_seen(question: Question, relation: str) -> bool:
    """Whether a bound holds in every world."""
    signs = question.worlds.signs(question.gaps) if relation in (*GREATER, *LESS) else None
    wanted = 1 if relation in GREATER else -1
    return signs is not None and bool((signs == wanted).all())
