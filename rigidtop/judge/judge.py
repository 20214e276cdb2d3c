"""A statement judged in a context, and the context behind it."""

from __future__ import annotations

import time
from collections.abc import Callable, Collection, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from math import inf

import numpy as np
from numpy.typing import NDArray
from sympy import (
    Add,
    Basic,
    Expr,
    MatrixBase,
    Symbol,
    cancel,
    factor_terms,
    fraction,
    linsolve,
    together,
)
from sympy.core.function import AppliedUndef
from sympy.solvers.solveset import NonlinearError

from rigidtop.judge import worlds as w
from rigidtop.judge.context import (
    FORCED,
    LAW,
    LINEAR,
    PREMISE,
    SETTING,
    Constraint,
    Context,
    Definition,
)
from rigidtop.judge.jets import TIME, Jet, jet_of, jets, rate, symbol
from rigidtop.judge.laws import (
    ENERGIES,
    LAGRANGIANS,
    Residual,
    coordinates,
    highest,
    lagrange,
    moved,
    residuals,
    surrounding,
)
from rigidtop.judge.meaning import (
    LARGEST,
    Meaning,
    Meant,
    Memory,
    UnclearError,
    Value,
    function_name,
    is_component,
    is_vector,
    pairs,
    particles,
    plain,
)
from rigidtop.judge.numbers import agree, are_numbers, rounded, share
from rigidtop.judge.orders import Scaling, differ, nearly, scalings, small_together
from rigidtop.judge.outcome import (
    ASSUMING,
    DEFINITION,
    FALSE,
    SAMPLED,
    UNDECIDED,
    Outcome,
    joint,
)
from rigidtop.judge.program import UnknownFunctionError
from rigidtop.judge.slips import Change, changes
from rigidtop.judge.written import written
from rigidtop.tree import nodes as n
from rigidtop.tree.latex import latex
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.plain import plain as in_words
from rigidtop.tree.statement import Statement

EQUALS = ("=", "≡")
NEARLY = ("≈", "∼")
CONDITIONS = ("≠", "<", ">", "≤", "≥", "≪", "≫")

BOTH_ROOTS = ("1,2", "1/2", "12")
"""Indices under which both roots stand in one formula."""

MOST_NUMBERS = 8
"""Of a counterexample no more numbers are told."""

MOST_LETTERS = 16
"""So many letters are tried in place of others."""

NUMBERS = 1.5
"""Up to this rank a slip is one of a sign or a number."""

SLIP_SECONDS, ALL_SLIPS_SECONDS = 1.5, 12.0
"""How long the change that makes a statement right is looked for: in one, and in a whole text (s,
of the processor's time)."""


@dataclass(frozen=True)
class Situation:
    """Where a statement stands and what the words beside it say.

    `supposed`: it is set for what follows; `case`: it is one of several; `derived`: it is said to
    follow; `instant`: it is said of one moment; `small` and `large`: for what it is nearly true;
    `declared` are letters that words introduce, and `asked` says that it is not asserted.
    `inline`: it stands in a line of words, and `opens`: nothing stands above it in its scope.
    `closed`: all that is needed has been said, so that what does not hold is false.
    """

    number: int
    scope: tuple[int, ...] = ()
    instant: str = ""
    sentence: int = -1
    supposed: bool = False
    case: bool = False
    derived: bool = False
    defined: bool = False
    small: bool = False
    large: bool = False
    asked: bool = False
    inline: bool = False
    closed: bool = False
    opens: bool = False
    declared: frozenset[Letter] = frozenset()


@dataclass
class Judge:
    """What judges the statements of one text.

    It remembers what letters stand for, and how many seconds are left to look for slips: once these
    are over, what would be false for a slip is undecided.
    """

    memory: Memory = field(default_factory=Memory)
    left_for_slips: float = ALL_SLIPS_SECONDS

    def judged(
        self, statement: Statement, situation: Situation, context: Context
    ) -> tuple[Outcome, Context]:
        """What becomes of a statement, and what is known after it."""
        outcome, after = self._in_context(statement, situation, context)
        if situation.asked and not outcome.passed:
            return Outcome(UNDECIDED, "it is asked, or denied"), context.doubting(
                statement.sides[0]
            )
        if outcome.verdict == FALSE and outcome.rests_on & context.doubted:
            why = "it rests on what has been said in two ways"
            return Outcome(UNDECIDED, why, outcome.rests_on), context
        if outcome.verdict == UNDECIDED:
            after = after.doubting(statement.sides[0])
        supposed = situation.supposed and outcome.verdict == FALSE
        if situation.closed or outcome.passed or not (situation.case or supposed):
            return outcome, after
        # What is said of a case says nothing of the others.
        context = context.doubting(statement.sides[0])
        return Outcome("premise", "a special case"), context.knowing(_letters(statement))

    def _in_context(
        self, statement: Statement, situation: Situation, context: Context
    ) -> tuple[Outcome, Context]:
        if context.bases and context.basis is None and has_components(statement):
            return self._in_some_axes(statement, situation, context)
        head, _ = _named(statement.sides[0])
        named = self._with_momentum(head, context, situation)
        if named is not context:
            found = self._judged(statement, situation, named)
            if found[0].verdict != UNDECIDED:
                return found
        return self._with_components(statement, situation, context)

    def _with_components(
        self, statement: Statement, situation: Situation, context: Context
    ) -> tuple[Outcome, Context]:
        """The outcome where ω₁ is a component of the vector, if it follows so; else as it is.

        Once something has followed so, what does not is judged so too.
        """
        names, vectors = _letters(statement), context.habits.vectors
        usual = self._judged(statement, situation, context)
        settled = usual[0].passed or usual[0].verdict == DEFINITION
        if settled or not any(is_component(x, v) for x in names for v in vectors):
            return usual
        other = replace(context, componentwise=not context.componentwise)
        found = self._judged(statement, situation, other)
        return found if found[0].passed else usual

    def _in_some_axes(
        self, statement: Statement, situation: Situation, context: Context
    ) -> tuple[Outcome, Context]:
        """The outcome in the axes in which components are right; in the first ones if in none."""
        outcomes = []
        for basis in context.bases:
            outcome, after = self._in_context(statement, situation, replace(context, basis=basis))
            outcomes.append((outcome, replace(after, basis=None)))
            if outcome.passed:
                return outcomes[-1]
        order = (FALSE, DEFINITION)
        return min(
            outcomes, key=lambda x: order.index(x[0].verdict) if x[0].verdict in order else 2
        )

    def _judged(
        self, statement: Statement, situation: Situation, context: Context
    ) -> tuple[Outcome, Context]:
        statement = _with_constant_last(statement)
        outcomes = []
        before = context
        head, _ = _named(statement.sides[0])
        if not statement.continues:
            context = replace(context, head=head)
        try:
            for k, relation in enumerate(statement.relations):
                left, right = statement.sides[k : k + 2]
                inner = k > 0 or statement.continues
                if _gives_all_a_value(statement):
                    right, inner = statement.sides[-1], statement.continues
                link = Link(self, left, right, situation, context, inner)
                outcome, context = self._link(link, relation)
                if outcome.verdict == FALSE and len(statement.relations) > 1:
                    where = f"{in_words(left)} {relation} {in_words(right)}"
                    outcome = replace(outcome, why=f"{where}: {outcome.why}")
                outcomes.append(outcome)
        except (UnclearError, UnknownFunctionError) as why:
            return Outcome(UNDECIDED, str(why)), before.knowing(_letters(statement))
        return joint(outcomes), context.knowing(_letters(statement))

    def _with_momentum(self, letter: Letter | None, context: Context, at: Situation) -> Context:
        """What p_θ stands for where there is a Lagrangian with θ: its derivative by θ̇."""
        if letter is None or letter in context.definitions or letter.bold:
            return context
        place = next((q for q in context.habits.moving if q == Letter(letter.sub)), None)
        function = next((x for x in LAGRANGIANS if x in context.definitions), None)
        if function is None:
            return context
        if letter.base == "p" and place is not None:
            slope: Node = n.Derivative(function, (n.Rate(place, 1, True),))
        elif letter in (Letter("E"), Letter("H")):
            slope = self._energy(function, context)
        else:
            return context
        try:
            value = Meaning(context, self.memory).scalar(slope)
        except UnclearError:
            return context
        if value == 0:
            return context
        return context.defining(letter, Definition(slope, at.number, at.scope))

    def _energy(self, function: Letter, context: Context) -> Node:
        """Σ q̇ ∂L/∂q̇ − L."""
        value = Meaning(context, self.memory).scalar(function)
        rates = [n.Rate(jet.letter, 1, True) for jet in coordinates(value)]
        terms = [n.Product((v, n.Derivative(function, (v,)))) for v in rates]
        return n.Sum((*terms, n.Negative(function)))

    def _link(self, link: Link, relation: str) -> tuple[Outcome, Context]:
        if relation in CONDITIONS and link.at.inline:
            link = replace(link, context=link.context.freeing(link.left, link.right))
        if isinstance(link.right, n.Constant):
            link = replace(link, left=n.Rate(link.left), right=n.Number("0"))
        if relation in EQUALS:
            if not (_has_sign(link.left) or _has_sign(link.right)):
                return link.judged()
            return link.judged_with_signs()
        if relation in NEARLY:
            if not (_has_sign(link.left) or _has_sign(link.right)):
                return link.judged_nearly()
            return link.each_sign(Link.judged_nearly)
        if relation in ("≥", ">", "≤", "<") and not link.inner:
            turned = relation in ("≤", "<")
            sides = (link.right, link.left) if turned else (link.left, link.right)
            if link.at.inline:
                bounds = (*link.context.bounds, sides)
                return Outcome("premise", "a condition"), replace(link.context, bounds=bounds)
            return replace(link, left=sides[0], right=sides[1]).judged_bound()
        if relation in CONDITIONS:
            context = link.context
            equal = link.at.closed and relation == "≠"
            if equal and (link.left == link.right or link.judged()[0].passed):
                return Outcome(FALSE, "the two are equal"), context
            if relation == "≠":
                gap = n.Sum((link.left, n.Negative(link.right)))
                context = replace(context, not_zero=(*context.not_zero, gap))
            elif relation in ("≪", "≫"):
                context = replace(context, little=_with_little(context.little, link, relation))
            return Outcome("premise", "a condition"), context
        raise UnclearError(f"{relation} is not judged")


@dataclass
class Link:
    """Two sides that are said to be equal; `inner` is a link of a chain behind the first one."""

    judge: Judge
    left: Node
    right: Node
    at: Situation
    context: Context
    inner: bool = False
    sign: int = 1

    def judged(self) -> tuple[Outcome, Context]:
        """The outcome and the context behind; raises UnclearError."""
        defined = self._definition(self.left, self.right) or self._definition(self.right, self.left)
        if defined is not None:
            return defined
        meaning = self._meaning()
        both = self._sides(meaning, self.left, self.right)
        self.used = frozenset(meaning.used)
        self.both = both
        if all(are_numbers(*pair) for pair in both):
            if self._says_that_nothing_moves():
                return Outcome(UNDECIDED, "nothing in it moves"), self.context
            return self._value_anew() or (self._numbers(), self.context)
        self.pool = self._pool(self.context)
        self._surround()
        holds = self.worlds.holds(self.both)
        if holds is None:
            holds = self._without_what_contradicts()
        if holds:
            if self.left == self.right:
                return Outcome(UNDECIDED, "it says nothing"), self.context
            return self._always() or self._follows()
        if self._is_kept(self.both):
            return self._follows()
        return self._fails(holds)

    def _always(self) -> tuple[Outcome, Context] | None:
        """What becomes of it for all times, where it says no more than 0 = 0 of one instant."""
        said = not (self.at.instant and n.Number("0") not in (self.left, self.right))
        if said or not self.worlds.vanish([x for pair in self.both for x in pair]):
            return None
        always = replace(self, at=replace(self.at, instant=""))
        outcome, context = always.judged()
        return (outcome, context) if outcome.passed is not None or not self.at.inline else None

    def _is_kept(self, both: Sequence[tuple[Expr, Expr]]) -> bool:
        """Whether the difference of both sides does not change, and vanishes at an instant."""
        instants = {c.instant for c in self.context.constraints if c.instant}
        if self.at.instant or self.tried is not None or not self.worlds.count or not instants:
            return False
        moving = self.context.habits.moving
        rates = [(rate(a, moving), rate(b, moving)) for a, b in both]
        if all(a == b == 0 for a, b in rates):
            return False
        if self.times is None:
            then = [(self._at(a, x), self._at(b, x)) for a, b in both for x in instants]
            self.times = self._asked(self.context, [*both, *rates, *then]).worlds
        return bool(self.times.holds(rates)) and any(
            self.times.holds([(self._at(a, x), self._at(b, x)) for a, b in both]) for x in instants
        )

    times: w.Worlds | None = None
    """Worlds of now and of the instants of which something is known."""

    def _at(self, expression: Expr, instant: str) -> Expr:
        return moved(expression, instant, self.context, self.judge.memory)

    def _says_that_nothing_moves(self) -> bool:
        """Whether both sides are rates, which vanish only as no letter of theirs moves."""
        sides = (self.left, self.right)
        return all(x == 0 for pair in self.both for x in pair) and all(
            any(isinstance(node, n.Rate) for node in n.walked(side)) for side in sides
        )

    def judged_with_signs(self) -> tuple[Outcome, Context]:
        """Both signs of ±: each is a statement, or both are the roots of what holds."""
        letter, _ = _named(self.left)
        if letter is None and not any("±" in x.sub for x in _own_letters(self.left)):
            roots = replace(self)._roots()
            if roots is not None:
                return roots, self.context
        both = {self._meaning(sign=x).named(letter) for x in (1, -1) if letter is not None}
        settled = len(both) > 1 and both <= self.context.definitions.keys()
        if letter is not None and not self.inner and not settled:
            sub = letter.sub.replace(" ", "").strip("±∓")
            root = replace(letter, sub="" if sub in BOTH_ROOTS else sub)
            link = replace(self, left=root)
            roots = link._roots()
            if roots is not None:
                context = self.context
                right = link.change.right if link.change is not None else self.right
                known = roots.passed is not None and root != letter
                for sign in (1, -1) if known else ():
                    named = replace(self, right=right, context=context, sign=sign)
                    _, context = named.judged()
                return roots, context
            if sub in BOTH_ROOTS:
                return self.each_sign(Link.judged, [replace(letter, sub=x) for x in "12"])
        return self.each_sign(Link.judged)

    def each_sign(
        self, judged: Callable[[Link], tuple[Outcome, Context]], names: Sequence[Node] = ()
    ) -> tuple[Outcome, Context]:
        """The outcome of the upper signs and of the lower ones, each with its name if given."""
        outcomes, context = [], self.context
        for sign, name in zip((1, -1), names or (self.left, self.left), strict=True):
            outcome, context = judged(replace(self, left=name, context=context, sign=sign))
            outcomes.append(outcome)
        return joint(outcomes), context

    def _roots(self) -> Outcome | None:
        """Whether a letter that an equation speaks of is one of both values; None: none does."""
        if self.at.instant:
            always = replace(self, at=replace(self.at, instant=""))._roots()
            if always is not None and always.passed:
                return always
        letter = self.left
        self.pool = self._pool(self.context)
        if (
            isinstance(letter, Letter)
            and letter not in self.context.definitions
            and not any(_speaks_of(each.expression, letter) for each in self.pool)
        ):
            return None
        both, used = [], set()
        for sign in (1, -1):
            meaning = replace(self, sign=sign)._meaning()
            both += self._sides(meaning, self.left, self.right)
            used |= meaning.used
        self.both, self.used = both, frozenset(used)
        self._surround()
        self.roots = True
        if self.worlds.holds_one(self.both) or self._are_roots():
            return self._follows()[0]
        slip = self._slip() or (self._refuted() if self.at.closed else None)
        return slip or Outcome(UNDECIDED, "it does not follow from what stands above")

    def _are_roots(self) -> bool:
        """Whether all that speaks of a letter holds with each of both values in its place."""
        x = symbol(Jet(self.left)) if isinstance(self.left, Letter) else None
        laws = [each for each in self.pool if x is not None and each.expression.has(x)]
        if not laws or any(x is None or right.has(x) for _, right in self.both):
            return False
        spoken = {each.constraint for each in laws}
        others = tuple(c for c in self.context.constraints if c not in spoken)
        gaps = [
            (each.expression.subs(x, right), 0 * TIME) for each in laws for _, right in self.both
        ]
        return self._asked(replace(self.context, constraints=others), gaps).holds()

    def judged_bound(self) -> tuple[Outcome, Context]:
        """The same where the left side is said to be no smaller than the right one.

        It follows if it is the same bound as one that is known: both are reached together.
        """
        meaning = self._meaning()
        self.both = self._sides(meaning, self.left, self.right)
        self.used = frozenset(meaning.used)
        context = replace(self.context, bounds=(*self.context.bounds, (self.left, self.right)))
        if len(self.both) != 1 or all(are_numbers(*pair) for pair in self.both):
            return Outcome("premise", "a condition"), self.context
        if self.at.supposed:
            return Outcome("premise", "a condition"), context
        self.pool = self._pool(self.context)
        self._surround()
        for left, right in reversed(self.context.bounds):
            try:
                [known] = self._sides(self._meaning(), left, right)
            except (UnclearError, ValueError):
                continue
            reached = Constraint(left, right, self.at.number, SETTING, self.at.scope)
            self.bound = self._asked(self.context.holding(reached), self.both), known
            if self._is_bound(self.both):
                rests_on = (self.used | self.rests_on) - {self.at.number}
                return Outcome(SAMPLED, "", rests_on), context
            slip = self._slip() if self.bound[0].worlds.count else None
            if slip is not None:
                return slip, self.context
        self.bound = None
        return Outcome("premise", "a condition"), context

    bound: tuple[Link, tuple[Expr, Expr]] | None = None

    def _is_bound(self, both: Sequence[tuple[Expr, Expr]]) -> bool:
        """Whether it is reached where the known bound is, and left on the same side."""
        assert self.bound is not None
        at, known = self.bound
        if not at.worlds.holds(both):
            return False
        free = self._asked(self.context, [*both, known])
        signs = free.worlds.signs([a - b for a, b in (*both, known)])
        return signs is not None and bool((signs[0] == signs[1]).all())

    def judged_nearly(self) -> tuple[Outcome, Context]:
        """The same where the sides are said to be nearly equal."""
        defined = self._definition(self.left, self.right)
        if defined is not None:
            return defined
        meaning = self._meaning()
        self.both = self._sides(meaning, self.left, self.right)
        self.used = frozenset(meaning.used)
        if all(are_numbers(*pair) for pair in self.both):
            return self._numbers(nearly=True), self.context
        self.pool = self._pool(self.context)
        self._surround()
        if self.worlds.holds(self.both):
            return self._follows()
        nearly = self._nearly(self.both)
        if nearly is not None:
            return nearly
        slip = self._slip(nearly=True) or self._differ_nearly()
        if slip is not None:
            return slip, self.context
        return Outcome(UNDECIDED, "it is not seen for what it is nearly true"), self.context

    def _nearly(self, both: Sequence[tuple[Expr, Expr]]) -> tuple[Outcome, Context] | None:
        """Whether the sides become alike as something is small or large."""
        words = self._alike(both)
        if not words:
            return None
        context = self.context
        fixed = {f"small {in_words(x)}" for x in self.context.letters - self.context.habits.moving}
        if words not in fixed and any(
            jet.order > 1 for pair in both for side in pair for jet in jets(side).values()
        ):
            context = context.holding(self._constraint(LINEAR))
        rests_on = (self.used | self.rests_on) - {self.at.number}
        return Outcome(ASSUMING, f"for {words}", rests_on, conditions=(words,)), context

    def _alike(self, both: Sequence[tuple[Expr, Expr]]) -> str:
        if not self.worlds.count:
            return ""
        words = {
            nearly(left, right, self.equations, self.worlds, self._scalings())
            for left, right in both
            if left != right
        }
        return words.pop() if len(words) == 1 else ""

    def _scalings(self) -> list[Scaling]:
        """What may be small or large here: what is said to be, before what is only possible."""
        which = "small" if self.at.small else "large" if self.at.large else ""
        said = [small_together(x, self.worlds) for x in self.context.little]
        usual = scalings(self.worlds, self.equations, self.context.habits.moving, which)
        return [*filter(None, said), *usual]

    def _differ_nearly(self) -> Outcome | None:
        """That both sides do not become alike, where it is said for what they should."""
        said = [*filter(None, (small_together(x, self.worlds) for x in self.context.little))]
        if self.at.large and not said:
            said = scalings(self.worlds, self.equations, self.context.habits.moving, "large")
        if not self.at.closed or not self.worlds.count:
            return None
        rests_on = (self.used | self.rests_on) - {self.at.number}
        for left, right in self.both:
            found = [differ(left, right, self.equations, self.worlds, each) for each in said]
            if found and all(found):
                words = said[0].words if len(said) == 1 else "what is said to be large"
                return Outcome(FALSE, f"the sides do not become alike for {words}", rests_on)
        return None

    def _numbers(self, nearly: bool = False) -> Outcome:
        """Whether numbers agree to the digits that are written."""
        off = max(share(self.left, nearly), share(self.right, nearly), 1e-12)
        found = [agree(left, right, off) for left, right in self.both]
        if all(found):
            return Outcome(SAMPLED, "", self.used)
        if None in found:
            return Outcome(UNDECIDED, "the units of both sides do not fit", self.used)
        value = rounded(self.both[0][0], self.right)
        why = f"the left side is {value}"
        return Outcome(FALSE, why, self.used, "another number", f"{latex(self.left)} ≈ {value}")

    # --- what it means ---------------------------------------------------------------------------

    def _meaning(self, **changes: object) -> Meaning:
        changes = {"sign": self.sign, **changes}
        return Meaning(self.context, self.judge.memory, **changes)  # type: ignore[arg-type]

    def _sides(self, meaning: Meaning, left: Node, right: Node) -> list[tuple[Expr, Expr]]:
        """Both sides as expressions, for each particle if they speak of any one; now or then."""
        bound = particles(self.context.habits.indices, left, right, most=2)
        made = []
        for each in bound:
            inner = meaning.with_(bound=each)
            made += pairs(inner.value(left), inner.value(right))
        if self.at.instant:
            made = [(self._then(a), self._then(b)) for a, b in made]
        if sum(x.count_ops() for pair in made for x in pair) > 2 * LARGEST:
            raise UnclearError("it becomes too long")
        return made

    def _then(self, expression: Expr) -> Expr:
        return moved(expression, self.at.instant, self.context, self.judge.memory)

    def _pool(self, context: Context) -> list[Residual]:
        return residuals(context, self.judge.memory, self.at.instant)

    def _surround(self) -> None:
        sides = [x for pair in self.both for x in pair]
        self.both = list(zip(*[iter(plain(sides))] * 2, strict=True))
        equations, self.rests_on, self.near = surrounding(sides, self.context, self.pool)
        together = plain([*equations, *sides])
        self.equations = together[: len(equations)]
        letters = w.symbols_of([*together, *(x for pair in self.both for x in pair)])
        self.worlds = w.found(self.equations, letters, self.context.results, self._not_zero())

    def _not_zero(self) -> list[Expr]:
        """What the text says does not vanish."""
        made = []
        for node in self.context.not_zero:
            try:
                made.append(self._meaning().scalar(node))
            except UnclearError:
                continue
        return made

    def _asked(self, context: Context, both: Sequence[tuple[Expr, Expr]]) -> Link:
        """The same statement with other sides, or in another context, and worlds for that."""
        link = replace(self, context=context)
        link.both, link.used = list(both), self.used
        same = context is self.context
        link.pool = self.pool if same else self._pool(context)
        link._surround()
        return link

    def _without_what_contradicts(self) -> bool | None:
        """What does not hold together with the rest is another problem's: the oldest goes first."""
        constraints = {r.constraint for r in self.near if r.constraint is not None}
        scope = self.at.scope
        order = sorted(
            constraints,
            key=lambda c: (scope[: len(c.scope)] == c.scope, c.kind != SETTING, c.number),
        )
        kept = self.context
        for constraint in order[:4]:
            left = tuple(c for c in kept.constraints if c is not constraint)
            kept = replace(kept, constraints=left)
            trial = self._asked(kept, self.both)
            if trial.worlds.count:
                self.context, self.pool, self.worlds = kept, trial.pool, trial.worlds
                self.equations, self.rests_on, self.near = (
                    trial.equations, trial.rests_on, trial.near,
                )  # fmt: skip
                return self.worlds.holds(self.both)
        return None

    # --- what it brings --------------------------------------------------------------------------

    def _definition(self, name: Node, other: Node) -> tuple[Outcome, Context] | None:
        """What a letter stands for that nothing has fixed yet."""
        letter, places = _named(name)
        if letter is None or self.at.instant or isinstance(other, n.Constant):
            return None
        if letter == Letter("π") and letter not in self.context.habits.own:
            return None
        letter = self._meaning().named(letter)
        index = next((x for x in self.context.habits.indices if letter.sub == x), "")
        if letter in self.context.definitions and not self._only_names(letter):
            return None
        if letter in self.context.given or letter in _own_letters(other):
            return None
        bound = {index: 0} if index else {}
        meaning = self._meaning(bound=bound)
        value = meaning.value(other)
        if _speaks_of(value, letter) or self._is_fixed(letter, value):
            return None
        if meaning._component(letter) is not None:
            return None
        if letter in self.context.habits.moving and are_numbers(value, value) and self.at.inline:
            return None  # a place where it may be
        if name is self.right and self._moves(value):
            return None  # x + y = s ties x to y, and s is what it is
        if is_vector(letter) and not isinstance(value, MatrixBase) and value != 0:
            raise UnclearError("one side is a vector, the other is a number")
        node = _signed(other, self.sign)
        made = Definition(node, self.at.number, self.at.scope, places, index)
        context = self.context.defining(letter, made)
        why = f"what {in_words(name)} stands for"
        used, brings = frozenset(meaning.used), frozenset({in_words(letter)})
        return Outcome(DEFINITION, why, used, brings=brings), context

    def _only_names(self, letter: Letter) -> bool:
        """Whether a letter stands for others of which nothing is said, as L does in L = T − V."""
        node = self.context.definitions[letter].node
        names = n.letters(node)
        known = {*self.context.definitions, *self.context.habits.moving}
        return (
            bool(names)
            and not names & known
            and all(x in ENERGIES for x in names)
            and not any(
                names & n.letters(c.left) | n.letters(c.right) for c in self.context.constraints
            )
        )

    def _moves(self, value: Value) -> bool:
        entries = list(value) if isinstance(value, MatrixBase) else [value]
        moving = self.context.habits.moving
        return any(j.order or j.letter in moving for x in entries for j in jets(x).values())

    def _is_fixed(self, letter: Letter, value: Value) -> bool:
        """Whether something that holds speaks of the letter, so that it is no name to give.

        A law moves a coordinate and does not say where it is; but a motion that is given in time
        has to obey it.
        """
        motion = letter in self.context.habits.moving and not value.has(TIME)
        return any(
            _speaks_of(each.expression, letter, functions=True)
            and (each.constraint is not None or not motion)
            for each in residuals(self.context, self.judge.memory)
        )

    def _follows(self) -> tuple[Outcome, Context]:
        rests_on = (self.used | self.rests_on) - {self.at.number}
        context = self.context
        letter = context.head
        if letter is not None and letter in context.definitions and self.sign == 1:
            definition = context.definitions[letter]
            also = (*definition.also, self.right)
            context = context.defining(letter, replace(definition, also=also))
        context = replace(context, supported=context.supported | rests_on)
        return Outcome(SAMPLED, "", rests_on), context

    def _fails(self, holds: bool | None) -> tuple[Outcome, Context]:
        """What becomes of two sides that are not equal in the worlds so far."""
        for attempt in (
            self._as_said_nearly,
            self._force,
            self._other_expression,
            self._path,
            self._root,
            self._anew,
            self._of_new_letters,
            self._setting,
            self._chosen,
            self._fixing,
        ):
            outcome = attempt()
            if outcome is not None:
                return outcome
            if self.tried is not None and not self.at.closed:
                break  # a motion that does not obey what holds brings nothing new
        if holds is None:
            return Outcome(UNDECIDED, "no world was found in which all above holds"), self.context
        if self.at.closed:
            nearly = self._slip(nearly=True) if self.at.small or self.at.large else None
            return nearly or self._slip() or self._refuted(), self.context
        slip = self._slip()
        if slip is not None:
            return slip, self._righted()
        fixed = self._fixing_what_is_free()
        if fixed is not None:
            return fixed
        wrong = self._missing_term() or self._contradiction()
        if wrong is not None:
            return wrong, self.context
        return Outcome(UNDECIDED, "it does not follow from what stands above"), self.context

    def _refuted(self) -> Outcome:
        """That it fails in a world, with the numbers of its letters and of both sides there."""
        rests_on = (self.used | self.rests_on) - {self.at.number}
        named = self._numbered()
        for left, right in self.both:
            try:
                at = self.worlds.program.values([*named.values(), left, right]).values.real
            except UnknownFunctionError:
                break
            fails = [k for k in range(self.worlds.count) if not agree_in(at[-2:, k])]
            if fails:
                *numbers, here, there = at[:, fails[0]]
                told = [f"{x} = {v:.3g}" for x, v in zip(named, numbers, strict=True)]
                where = f"at {', '.join(told[:MOST_NUMBERS])}: " if told else ""
                both = f"the left side is {here:.4g}, the right side {there:.4g}"
                return Outcome(FALSE, (where + both).replace("-", "−"), rests_on)
        return Outcome(FALSE, "it does not hold", rests_on)

    def _numbered(self) -> dict[str, Expr]:
        """The letters and rates that stand in it and have a number in its worlds."""
        meaning, found = self._meaning(), dict[str, Expr]()
        for node in (x for side in (self.left, self.right) for x in n.walked(side)):
            if isinstance(node, Letter) or (isinstance(node, n.Rate) and node.dotted):
                with suppress(UnclearError):
                    value = meaning.scalar(node)
                    if value.free_symbols <= {*self.worlds.letters}:
                        found[in_words(node)] = value
        return found

    def _as_said_nearly(self) -> tuple[Outcome, Context] | None:
        """What words say is true for what is small or large, though "=" is written."""
        if not (self.at.small or self.at.large):
            return None
        nearly = self._nearly(self.both)
        if nearly is None:
            return None
        # Another sign, or twice as much, is no approximation.
        slip = self._slip(most=NUMBERS)
        return nearly if slip is None else (slip, self._righted())

    def _force(self) -> tuple[Outcome, Context] | None:
        """Lagrange's equation with a force on its right side, which holds from here on."""
        names = {
            x
            for node in n.walked(self.left)
            if isinstance(node, n.Derivative)
            for x in n.letters(node.of)
        }
        if self.inner or self.at.instant or self.at.closed or not names & {*LAGRANGIANS}:
            return None
        laws = lagrange(self.context, self.judge.memory, [])
        [(left, right), *more] = self.both
        if more or right == 0 or not any((left - law.expression).expand() == 0 for law in laws):
            return None
        new = self._new_letters()
        outcome = self._brings(new) if new else Outcome("premise", "it brings a force", self.used)
        return outcome, self.context.holding(self._constraint(FORCED))

    def _other_expression(self) -> tuple[Outcome, Context] | None:
        """Whether it holds with another expression of a function that is differentiated."""
        functions = {
            of
            for side in (self.left, self.right)
            for node in n.walked(side)
            if isinstance(node, (n.Derivative, n.Primed))
            for of in [n.ungrouped(node.of)]
            if isinstance(of, Letter) and of in self.context.definitions
        }
        for function in functions:
            for other in self.context.definitions[function].also:
                chosen = {function: other}
                try:
                    both = self._sides(self._meaning(chosen=chosen), self.left, self.right)
                except UnclearError:
                    continue
                if self._holds(both) and (function not in LAGRANGIANS or self._moves_alike(other)):
                    return self._follows()
        return None

    def _root(self) -> tuple[Outcome, Context] | None:
        """One of the two roots of what stands above, with a sign that nothing else says."""
        letter, _ = _named(self.left)
        if letter is None or letter in self.context.definitions or self.at.closed or self.inner:
            return None
        other = n.mapped(self.right, _other_root)
        if other == self.right or len(self.both) != 1:
            return None
        try:
            both = [*self.both, *self._sides(self._meaning(), self.left, other)]
        except UnclearError:
            return None
        if not self.worlds.holds_one(both):
            return None
        rests_on = (self.used | self.rests_on) - {self.at.number}
        context = self.context.holding(self._constraint(PREMISE))
        words = f"{latex(self.left)} = {latex(self.right)}"
        return Outcome(ASSUMING, "it is one of two roots", rests_on, conditions=(words,)), context

    def _moves_alike(self, other: Node) -> bool:
        """Whether an expression of a Lagrangian moves alike: a momentum may not be put in."""
        meaning = self._meaning()
        try:
            value = meaning.scalar(other)
        except UnclearError:
            return False
        held = {
            x
            for x in _own_letters(other)
            if x in self.context.definitions and meaning._is_momentum(x)
        }
        if held:
            value = self._meaning(held=frozenset(held)).scalar(other)
        laws = lagrange(self.context, self.judge.memory, [], value)
        return all(self._holds([(law.expression, 0 * law.expression)]) for law in laws)

    def _holds(self, both: Sequence[tuple[Expr, Expr]]) -> bool:
        """Whether other sides are equal in worlds of their own."""
        return self._asked(self.context, both).holds()

    def holds(self) -> bool:
        """Whether the sides are equal in every world."""
        return bool(self.worlds.holds(self.both))

    def _path(self) -> tuple[Outcome, Context] | None:
        """A motion given as a function of the time: it solves what holds, or is tried."""
        letter, _ = _named(self.left)
        if letter is None or self.at.instant or letter not in self.context.habits.moving:
            return None
        value = self._meaning().value(self.right)
        known = self.context.definitions.get(letter)
        if known is not None and not self._meaning().value(letter).has(TIME):
            return None
        if isinstance(value, MatrixBase) or not value.has(TIME) or _speaks_of(value, letter):
            return None
        before = self.context.forgetting(letter)
        definition = Definition(self.right, self.at.number, self.at.scope)
        context = before.defining(letter, definition)
        self.tried = Path(letter, replace(self, context=before), context)
        laws = self.tried.laws()
        if not laws:
            return Outcome(DEFINITION, f"what {in_words(self.left)} stands for"), context
        tried = context
        context = replace(context, results=context.results | {*self._new_letters()})
        if self._solves(value):
            rests_on = frozenset().union(*(each.rests_on for each in laws)) | self.used
            return Outcome(SAMPLED, "it solves what stands above", rests_on), context
        letters = [symbol(Jet(x)) for x in sorted(_letters_of(value), key=str)]
        if (
            known is None
            and letters
            and not self.at.closed
            and self._asked(tried, [(x, x) for x in letters]).worlds.count
        ):
            # One of known letters alone that solves what holds with another number is wrong.
            slip = None if self._new_letters() else self._slip(most=NUMBERS)
            if slip is not None:
                return slip, self._righted()
            return Outcome(DEFINITION, f"a motion of {in_words(self.left)} that is tried"), context
        return None

    tried: Path | None = None

    def _solves(self, value: Expr) -> bool:
        """Whether a motion that is tried obeys what holds of its letter."""
        assert self.tried is not None
        path = self.tried
        put = _put_in(path.letter, value, self.context)
        gaps = [(each.expression.subs(put, simultaneous=True), 0 * TIME) for each in path.laws()]
        solved = {each.constraint for each in path.laws()}
        left = tuple(c for c in path.context.constraints if c not in solved)
        if not self._new_letters():  # else they say what the new letters are
            starts = tuple(c for c in left if c.instant and path.letter in c.letters)
            tried = Definition(Meant(value), self.at.number, self.at.scope)
            begun = residuals(
                replace(path.context.defining(path.letter, tried), constraints=starts),
                self.judge.memory,
            )
            gaps += [(each.expression, 0 * TIME) for each in begun if each.constraint in starts]
            left = tuple(c for c in left if c not in starts)
        return self._asked(replace(path.context, constraints=left), gaps).holds()

    def _of_new_letters(self) -> tuple[Outcome, Context] | None:
        """What fixes a letter, or a function, that occurs for the first time."""
        if self.inner and self._free_on_the_left():
            return None
        new = self._new_letters()
        if not new and self._is_of_new_functions():
            constraint = self._constraint(SETTING if self.at.supposed else PREMISE)
            return Outcome("premise", "it brings a function", self.used), self.context.holding(
                constraint
            )
        if not new:
            return None
        if len(new) == 1 and self._rate_follows(new[0]):
            rests_on = (self.used | self.rests_on) - {self.at.number}
            words = f"{in_words(new[0])} is a constant of integration"
            return Outcome(SAMPLED, words, rests_on), self.context.holding(
                self._constraint(PREMISE)
            )
        wrong = [x for x in new if x not in self.at.declared]
        names_it = isinstance(self.left, Letter) or _own_letters(self.left) <= {*new}
        if len(wrong) == 1 and not names_it and len(new) == 1:
            slip = self._slip(letter=wrong[0])
            if slip is not None:
                return slip, self.context
        if len(new) == 1:
            solved = self._solved(new[0])
            if solved is not None:
                definition = Definition(solved, self.at.number, self.at.scope)
                return self._brings(new), self.context.defining(new[0], definition)
        constraint = self._constraint(SETTING if self.at.supposed else PREMISE)
        context = replace(self.context, results=self.context.results | self._results(new))
        return self._brings(new), context.holding(constraint)

    def _results(self, new: Sequence[Letter]) -> frozenset[Letter]:
        """New letters that stand alone as a term, as the force in m z̈ = N − m g."""
        if self.at.instant:
            return frozenset()
        gaps = [a - b for a, b in self.both]
        alone = {x for x in new for gap in gaps if gap.diff(symbol(Jet(x))) in (1, -1)}
        return frozenset(alone)

    def _is_of_new_functions(self) -> bool:
        known = {x for e in self.equations for x in e.free_symbols}
        return any(
            x.name.startswith("f(") and x not in known
            for left, right in self.both
            for x in left.free_symbols ^ right.free_symbols
        )

    def _rate_follows(self, letter: Letter) -> bool:
        """Whether the rates of both sides agree, so that the new letter is their difference."""
        x, moving = symbol(Jet(letter)), self.context.habits.moving
        if letter in moving or is_vector(letter) or self.at.instant or self.tried is not None:
            return False
        gaps = [a - b for a, b in self.both]
        rates = [rate(gap, moving) for gap in gaps]
        speaks = any(gap.has(x) for gap in gaps) and not any(r.has(x) for r in rates)
        if not speaks or not any(rates):
            return False
        return self._holds([(r, 0 * r) for r in rates])

    def _brings(self, new: Sequence[Letter]) -> Outcome:
        letters = ", ".join(map(in_words, new))
        names = frozenset(map(in_words, new))
        return Outcome("premise", f"it brings {letters}", self.used, brings=names)

    def _new_letters(self) -> list[Letter]:
        """Letters of which nothing that stands above speaks."""
        spoken = {x for each in self.pool for x in _letters_of(each.expression)}
        for definition in self.context.definitions.values():
            spoken |= n.letters(definition.node)
        meant = {x for pair in self.both for side in pair for x in _letters_of(side)}
        spoken |= self.context.definitions.keys() | self.context.given | self.context.declared
        return sorted(meant - spoken, key=str)

    def _solved(self, letter: Letter) -> Node | None:
        """What a new letter is by a linear equation; None where it is not linear, or moves."""
        x = symbol(Jet(letter))
        if is_vector(letter) or letter in self.context.habits.moving or len(self.both) > 1:
            return None
        gap = self.both[0][0] - self.both[0][1]
        slope = gap.diff(x)
        if self.at.instant or slope.has(x) or slope == 0:
            return None
        if isinstance(self.left, Letter) and self.left == letter:
            return self.right
        return Meant(-gap.subs(x, 0) / slope)

    def _constraint(self, kind: str) -> Constraint:
        at = self.at
        names = _own_letters(self.left) | _own_letters(self.right)
        moves = bool(names & self.context.habits.moving) or any(
            self._moves(x) for pair in self.both for x in pair
        )
        # Said of one place, r = R ŷ ends with its sentence, unless the motion passes there.
        placed = at.instant and not moves and isinstance(self.left, Letter)
        until = at.sentence if placed else None
        instant = at.instant if moves else ""
        return Constraint(self.left, self.right, at.number, kind, at.scope, instant, until)

    def _setting(self) -> tuple[Outcome, Context] | None:
        """A special motion, or what holds at one instant."""
        at = self.at
        known = () if at.instant else self.context.definitions
        given = _is_setting(self.left, self.right, known) or self._is_value()
        given = given or bool(at.instant and at.inline)
        if (
            (self.inner and not _is_start(self.left))
            or (at.closed and not (at.supposed or at.instant or _is_start(self.left)))
            or not (at.supposed or given)
            or (at.derived and not (at.supposed or at.opens or (at.instant and at.inline)))
        ):
            return None
        what = "at one instant" if self.at.instant else "a special case"
        older = [c for c in self.context.constraints if c.kind == SETTING and not c.instant]
        for count in range(-1, len(older) + 1):
            # What goes together with no earlier case is a case of its own.
            kept = tuple(c for c in self.context.constraints if c not in older[: max(count, 0)])
            before = self.context if count < 0 else replace(self.context, not_zero=())
            context = replace(before, constraints=kept).holding(self._constraint(SETTING))
            if self._asked(context, self.both).worlds.count:
                return Outcome("premise", what, self.used), context
        return None

    def _chosen(self) -> tuple[Outcome, Context] | None:
        """A value for a letter that a text has brought itself and has left free so far."""
        if not self.at.closed or self.at.instant:
            return None
        asked = {x for pair in self.both for side in pair for x in side.free_symbols}
        own = {x for x in asked if (jet := jet_of(x)) is not None and self._is_own(jet)}
        if not own or not _is_setting(self.left, self.right, self.context.definitions):
            return None
        gaps = [a - b for a, b in self.both]
        if any(self._moves(gap) for gap in gaps):
            return None
        # What moves follows such a value, as ω₁ = A cos Ωt does.
        free = [x for x in self.worlds.letters if x in own or self._moves(x)]
        context = self.context.holding(self._constraint(SETTING))
        before = w.rank(self.equations, self.worlds, free)
        chosen = w.rank([*self.equations, *gaps], self.worlds, free) == before + len(gaps)
        timed = any(each.has(TIME) for each in self.equations)
        if not chosen and not (timed and self._asked(context, self.both).worlds.count):
            return None
        return Outcome(PREMISE, "it is chosen", self.used), context

    def _is_own(self, jet: Jet) -> bool:
        """Whether it is a constant that no facts know and nothing else is called."""
        known = (
            self.context.given
            | self.context.declared
            | self.context.habits.moving
            | self.context.definitions.keys()
        )
        return not jet.order and not jet.place and jet.letter not in known

    def _anew(self) -> tuple[Outcome, Context] | None:
        """A letter that is used again in another part of the text."""
        letter, places = _named(self.left)
        definition = self.context.definitions.get(letter) if letter is not None else None
        if letter is None or definition is None or self.at.instant:
            return None
        if not self._may_be_anew(definition):
            return None
        value = self._meaning().value(self.right)
        if _speaks_of(value, letter) or isinstance(value, MatrixBase) != is_vector(letter):
            return None
        made = Definition(self.right, self.at.number, self.at.scope, places)
        kept = tuple(
            c
            for c in self.context.constraints
            if letter not in n.letters(c.left) | n.letters(c.right)
        )
        context = replace(self.context, constraints=kept).defining(letter, made)
        return Outcome(DEFINITION, f"{in_words(letter)} is used again"), context

    def _is_value(self) -> bool:
        """Whether a letter that stands for nothing is given a number, perhaps with a unit."""
        new = isinstance(self.left, Letter) and self.left not in self.context.definitions
        return new and self.at.inline and all(are_numbers(right, right) for _, right in self.both)

    def _may_be_anew(self, definition: Definition) -> bool:
        """Whether what a letter stands for may be another problem's: outside, or by the words."""
        at = self.at
        within = at.scope[: len(definition.scope)] == definition.scope
        said = at.scope != definition.scope and (at.defined or at.supposed) and not at.derived
        # A property, as a moment of inertia, is another body's; what moves is a special motion.
        moves = any(self._moves(x) for pair in self.both for x in pair)
        other = at.supposed and at.inline and not (moves or at.small or at.large)
        return not within or (not self.inner and (said or other))

    def _value_anew(self) -> tuple[Outcome, Context] | None:
        """A number that is given to a letter in place of the one that it had in another problem."""
        letter, _ = _named(self.left)
        definition = self.context.definitions.get(letter) if letter is not None else None
        if letter is None or definition is None or self.at.instant:
            return None
        given = not _own_letters(definition.node) and not _own_letters(self.right)
        other = self.at.inline and not (self.at.derived or self.inner)
        if not given or not (other or self._may_be_anew(definition)) or self._numbers().passed:
            return None
        made = Definition(self.right, self.at.number, self.at.scope)
        context = self.context.defining(letter, made)
        return Outcome(DEFINITION, f"{in_words(letter)} is used again"), context

    def _fixing(self) -> tuple[Outcome, Context] | None:
        """An equation of motion of what no law moves: it fixes a highest rate that was free."""
        if not self.worlds.count or self.inner or self.at.instant or self.at.closed:
            return None
        head = self.left.of if isinstance(self.left, n.Rate) else self.left
        if isinstance(head, Letter) and head in self.context.definitions:
            # What stands for something moves as that does, if it is not a law.
            slip = self._slip()
            if slip is not None:
                return slip, self._righted()
        gaps = [a - b for a, b in self.both]
        free = highest([*gaps, *self.equations])
        before = w.rank(self.equations, self.worlds, free)
        behind = w.rank([*self.equations, *gaps], self.worlds, free)
        if not free or behind != before + len(gaps):
            return None
        context = self.context.holding(self._constraint(LAW))
        return Outcome("premise", "it is taken as it stands", self.used), context

    def _fixing_what_is_free(self) -> tuple[Outcome, Context] | None:
        """What fixes letters that have occurred, and of which nothing has been said."""
        said = self.at.defined or self.at.supposed or self.at.inline
        if not self.worlds.count or (self.at.derived and not self.inner):
            return None
        gaps = [a - b for a, b in self.both]
        free = self._free_on_the_left() if said or self.inner else []
        if not free and not self.inner:
            free = self._free_in_premises()
        before = w.rank(self.equations, self.worlds, free)
        if not free or w.rank([*self.equations, *gaps], self.worlds, free) != before + len(gaps):
            return None
        letters = {jet.letter for x in free if (jet := jet_of(x)) is not None}
        above = (d for d in self.context.definitions.values() if d.number != self.at.number)
        spoken = frozenset().union(*(n.letters(d.node) for d in above))
        outcome = self._brings(sorted(letters, key=str))
        outcome = replace(outcome, restricts=bool(letters & spoken))
        if len(letters) == 1:
            [letter] = letters
            solved = self._solved(letter)
            if solved is not None:
                definition = Definition(solved, self.at.number, self.at.scope)
                return outcome, self.context.defining(letter, definition)
        return outcome, self.context.holding(self._constraint(PREMISE))

    def _free_in_premises(self) -> list[Symbol]:
        """Letters of which only premises speak, and neither laws nor what letters stand for."""
        spoken: set[Basic] = set()
        other: set[Basic] = set()
        for each in self.pool:
            (spoken if each.kind == PREMISE else other).update(each.expression.free_symbols)
        named = frozenset().union(*(n.letters(d.node) for d in self.context.definitions.values()))
        sides = w.symbols_of([x for pair in self.both for x in pair])
        return [
            x
            for x in sides
            if x in spoken - other and (jet := jet_of(x)) is not None and jet.letter not in named
        ]

    def _free_on_the_left(self) -> list[Symbol]:
        """Letters of the left side alone of which nothing has been said."""
        bound = {x for each in self.pool for x in each.expression.free_symbols}
        bound |= {x for _, right in self.both for x in right.free_symbols}
        left = w.symbols_of([left for left, _ in self.both])
        return [x for x in left if x not in bound and jet_of(x) is not None]

    # --- what is wrong with it -------------------------------------------------------------------

    def _slip(
        self, letter: Letter | None = None, nearly: bool = False, most: float = inf
    ) -> Outcome | None:
        """The one change with which it holds in every world; of one `letter` alone, if given.

        Of the changes none is less likely than `most`.
        """
        if not self.worlds.count or self.judge.left_for_slips <= 0:
            return None
        begun = time.process_time()
        until = begun + min(SLIP_SECONDS, self.judge.left_for_slips)
        near = {jet.letter for x in self.worlds.letters if (jet := jet_of(x)) is not None}
        known = frozenset(self.context.letters & (near | {*self.context.definitions}))
        moving = self.context.habits.moving
        indices = self.context.habits.indices
        self.worlds = self._widened(known)
        self.shared = None
        if not indices:
            self.shared = self._meaning().remembering(self.left, self.right)
        right_one = None
        for change in changes(self.left, self.right, known, moving, letter, indices):
            if time.process_time() > until or change.rank > most:
                break
            if self._is_right(change, nearly):
                right_one = change
                break
        self.judge.left_for_slips -= time.process_time() - begun
        if right_one is None:
            return None
        self.change = right_one
        relation = "\\approx" if nearly else "\\geq" if self.bound else "="
        right = f"{latex(right_one.left)} {relation} {latex(right_one.right)}"
        rests_on = (self.used | self.rests_on) - {self.at.number}
        why = f"it holds with {right_one.words}"
        return Outcome(FALSE, why, rests_on, right_one.words, right)

    def _missing_term(self) -> Outcome | None:
        """One term that is missing, of letters that the statement has."""
        if len(self.both) != 1 or not self.worlds.count or self.tried is not None:
            return None
        left, right = self.both[0]
        count = sum(len(Add.make_args(x.expand())) for x in (left, right) if x != 0)
        gap = _solved_for(highest(self.equations), self.equations, left - right)
        tops = highest(self.equations)
        moves = any(left.has(x) or right.has(x) for x in tops) or self._differentiates()
        if (
            not moves
            or count < 3
            or gap is None
            or not _is_monomial(gap)
            or not self.used | self.rests_on
        ):
            return None
        if not _letters_of(gap) <= _own_letters(self.left) | _own_letters(self.right):
            return None
        term = written(-gap)
        changed = n.Sum((self.left, term)) if self.right == n.Number("0") else None
        side = f"{latex(changed)} = 0" if changed is not None else ""
        side = side or f"{latex(self.left)} = {latex(n.Sum((self.right, written(gap))))}"
        rests_on = (self.used | self.rests_on) - {self.at.number}
        words = f"the term {in_words(term)}"
        return Outcome(FALSE, f"{words} is missing", rests_on, words, side)

    def _differentiates(self) -> bool:
        sides = (self.left, self.right)
        return any(isinstance(x, n.Derivative) for side in sides for x in n.walked(side))

    def _contradiction(self) -> Outcome | None:
        """A statement above that, with one change, lets this one hold; nothing follows from it."""
        until = time.process_time() + SLIP_SECONDS / 2
        names = [
            (letter, definition)
            for letter, definition in self.context.definitions.items()
            if definition.number in self.used and definition.number not in self.context.supported
            if not isinstance(definition.node, Meant)
        ]
        for letter, definition in sorted(names, key=lambda x: -x[1].number)[:3]:
            known = n.letters(definition.node)
            for change in changes(letter, definition.node, known, self.context.habits.moving):
                if time.process_time() > until or change.rank > 1.2:
                    break
                if change.left == letter and self._holds_with(letter, definition, change.right):
                    why = f"it contradicts what {in_words(letter)} stands for: {change.words} there"
                    right = f"{latex(letter)} = {latex(change.right)}"
                    rests_on = frozenset({definition.number})
                    return Outcome(FALSE, why, rests_on, change.words, right)
        return None

    def _holds_with(self, letter: Letter, definition: Definition, node: Node) -> bool:
        other = self.context.defining(letter, replace(definition, node=node))
        link = replace(self, context=other)
        try:
            if self.tried is not None:
                before = self.tried.before.context.defining(letter, replace(definition, node=node))
                link.tried = replace(self.tried, before=replace(link, context=before))
                value = link._meaning().scalar(self.right)
                link.both, link.used, link.pool = self.both, self.used, link._pool(other)
                return link._solves(value)
            both = link._sides(link._meaning(), self.left, self.right)
        except UnclearError:
            return False
        return self._asked(other, both).holds()

    def _widened(self, known: frozenset[Letter]) -> w.Worlds:
        """Worlds in which the letters that a change may put in have numbers too."""
        more: list[Expr] = []
        for letter in sorted(known, key=str)[:MOST_LETTERS]:
            moves = letter in self.context.habits.moving and not self.context.timeless
            try:
                value = self._meaning().value(letter)
            except UnclearError:
                continue
            more += list(value) if isinstance(value, MatrixBase) else [value]
            for _ in range(2 * moves):
                value = self._meaning().rate(value)
                more += list(value) if isinstance(value, MatrixBase) else [value]
        if self.at.instant:
            more = [self._then(x) for x in more]
        wide = self._asked(self.context, [*self.both, *((x, x) for x in more)])
        return wide.worlds if wide.worlds.count else self.worlds

    def _righted(self) -> Context:
        """What a text goes on with behind a slip: what it should have said."""
        if self.tried is not None and self.change is not None:
            definition = Definition(self.change.right, self.at.number, self.at.scope)
            return self.tried.before.context.defining(self.tried.letter, definition)
        return self.context

    change: Change | None = None
    shared: Meaning | None = None
    roots: bool = False

    def _is_right(self, change: Change, nearly: bool = False) -> bool:
        name, _ = _named(change.left)
        if name is not None and name in n.letters(change.right) - n.letters(self.right):
            return False  # x = x says nothing
        if (
            isinstance(self.left, Letter)
            and change.left != self.left
            and self.right == n.Number("0")
        ):
            return False  # any letter may be zero
        if isinstance(self.right, Letter) and change.right == self.context.head:
            return False  # a chain may not end with what it begins with
        meaning = self.shared or self._meaning()
        if self.tried is not None and not nearly:
            if change.left != self.left:
                return False
            try:
                value = meaning.scalar(change.right)
            except UnclearError:
                return False
            return value.has(TIME) and self._solves(value)
        try:
            both = self._sides(meaning, change.left, change.right)
            if self.roots:
                other = replace(self, sign=-1)._meaning()
                both += self._sides(other, change.left, change.right)
        except UnclearError:
            return False
        flat = plain([x for pair in both for x in pair])
        both = list(zip(*[iter(flat)] * 2, strict=True))
        if all(a == 0 and b == 0 for a, b in both):
            return False
        if not {x for side in flat for x in side.free_symbols} <= {*self.worlds.letters}:
            return False
        if self.roots:
            return self.worlds.holds_one(both) and not self.worlds.vanish(flat)
        if self.bound is not None:
            return self._is_bound(both)
        if nearly:
            return change.rank < 3 and bool(self._alike(both))
        if change.left == change.right:
            return False
        return bool(self.worlds.holds(both, trivially=False)) or self._is_kept(both)


@dataclass(frozen=True, eq=False)
class Path:
    """A motion that is tried for a letter: what holds of it, and the context with it put in."""

    letter: Letter
    before: Link
    context: Context

    def laws(self) -> list[Residual]:
        """What holds of the letter where nothing says how it moves."""
        pool = residuals(self.before.context, self.before.judge.memory)
        return [
            each for each in pool if _speaks_of(each.expression, self.letter) and not each.instant
        ]


def _with_constant_last(statement: Statement) -> Statement:
    """A chain in which a constant stands at the end: a = const = b is a = b = const."""
    sides = [side for side in statement.sides if not isinstance(side, n.Constant)]
    if len(sides) in (len(statement.sides), 0) or not {*statement.relations} <= {*EQUALS}:
        return statement
    constant = n.Constant()
    return replace(statement, sides=(*sides, constant), relations=("=",) * len(sides))


def _gives_all_a_value(statement: Statement) -> bool:
    """Whether it gives one number to several letters or rates: ω₁ = ω₂ = 0."""
    *sides, value = statement.sides
    bare = (x.of if isinstance(x, n.Rate) and x.dotted else x for x in sides)
    named = all(isinstance(x, Letter) or _is_start(x) for x in bare)
    return named and isinstance(value, n.Number) and {*statement.relations} == {"="}


def _with_little(
    known: tuple[frozenset[Letter], ...], link: Link, relation: str
) -> tuple[frozenset[Letter], ...]:
    """What is little, with one side more; what is smaller than the same is so together."""
    small = _own_letters(link.left if relation == "≪" else link.right)
    alone = tuple(x for x in known if not x <= small)
    return (*alone, small)


def agree_in(pair: NDArray[np.float64]) -> bool:
    """Whether two numbers differ by no more than rounding."""
    return bool(abs(pair[0] - pair[1]) <= w.CLOSE * (abs(pair[0]) + abs(pair[1]) + w.CLOSE))


def _is_monomial(expression: Expr) -> bool:
    """Whether it is one term, with a small number in front."""
    over, under = fraction(expression)
    number, _ = over.expand().as_coeff_Mul()
    return (
        expression != 0
        and not over.expand().is_Add
        and not under.expand().is_Add
        and number.is_Rational
        and max(abs(number.p), number.q) <= 8
    )


def _solved_for(tops: Sequence[Symbol], equations: Sequence[Expr], gap: Expr) -> Expr | None:
    """What is left of a difference where the highest rates are put in; None if it is not short."""
    used = [x for x in tops if gap.has(x)]
    if len(tops) > 4 or len(equations) > 6 or gap.count_ops() > 200:
        return None
    try:
        solutions = list(linsolve(list(equations), list(tops))) if used else [()]
    except NonlinearError:
        return None
    if len(solutions) != 1 or (used and any(x.has(*tops) for x in solutions[0])):
        return None
    rest = gap.xreplace(dict(zip(tops, solutions[0], strict=False))) if used else gap
    made: Expr = factor_terms(cancel(together(rest)))
    return made


def _named(node: Node) -> tuple[Letter | None, tuple[Node, ...]]:
    """The letter that a side is, with the places behind it."""
    if isinstance(node, n.Primed) and isinstance(node.of, Letter):
        return replace(node.of, mark=node.of.mark + "′" * node.order), ()
    if isinstance(node, Letter):
        return node, ()
    if isinstance(node, n.Call) and isinstance(node.function, Letter):
        simple = all(isinstance(n.ungrouped(x), (Letter, n.Rate)) for x in node.places)
        if simple:
            return node.function, () if node.places == (Letter("t"),) else node.places
    return None, ()


def _letters(statement: Statement) -> frozenset[Letter]:
    return frozenset().union(*map(_own_letters, statement.sides))


def _own_letters(node: Node) -> frozenset[Letter]:
    return n.letters(node) - {Letter("π"), Letter("t")}


def _letters_of(expression: Expr) -> set[Letter]:
    return {jet.letter for jet in jets(expression).values()}


def _speaks_of(value: Value, letter: Letter, functions: bool = False) -> bool:
    entries = list(value) if isinstance(value, MatrixBase) else [value]
    if functions and any(
        function_name(letter) == str(f.func) for x in entries for f in x.atoms(AppliedUndef)
    ):
        return True
    return any(letter in _letters_of(x) for x in entries)


def has_components(statement: Statement) -> bool:
    """Whether a column of three components, or a square of nine, stands in it."""
    return any(
        isinstance(x, n.Component)
        or (isinstance(x, n.Tuple) and len(x.entries) == 3)
        or (isinstance(x, n.Matrix) and len(x.rows) == 3 and len(x.rows[0]) in (1, 3))
        for side in statement.sides
        for x in n.walked(side)
    )


def _has_sign(node: Node) -> bool:
    return any(
        isinstance(x, n.PlusMinus) or (isinstance(x, Letter) and ("±" in x.sub or "∓" in x.sub))
        for x in n.walked(node)
    )


def _other_root(node: Node) -> Node:
    """A root with the other sign."""
    return n.Negative(node) if isinstance(node, n.Root) else node


def _signed(node: Node, sign: int) -> Node:
    """An expression with the upper or the lower sign."""

    def chosen(each: Node) -> Node:
        if isinstance(each, n.PlusMinus):
            return each.of if (sign > 0) != each.inverted else n.Negative(each.of)
        return each

    return n.mapped(node, chosen) if _has_sign(node) else node


def _is_setting(left: Node, right: Node, definitions: Collection[Letter]) -> bool:
    """Whether a letter or a rate is given a number or another letter."""
    bare = left.of if isinstance(left, n.Rate) and left.dotted else left
    if bare is not left and bare in definitions:
        return False
    value = n.ungrouped(right)
    while isinstance(value, n.Negative):
        value = value.of
    if bare is not left and isinstance(value, n.Rate) and isinstance(value.of, Letter):
        value = value.of if value.of.base == getattr(bare, "base", "") else value
    named = isinstance(bare, Letter) or _is_start(left)
    return named and (isinstance(value, (n.Number, Letter)) or _is_start(value))


def _is_start(node: Node) -> bool:
    """Whether it is what a letter is at one time, as in x(0)."""
    return (
        isinstance(node, n.Call) and len(node.places) == 1 and isinstance(node.places[0], n.Number)
    )


def _put_in(letter: Letter, value: Expr, context: Context) -> dict[Expr, Expr]:
    """The numbers of a letter and its rates where it is a function of the time."""
    put: dict[Expr, Expr] = {}
    for order in range(4):
        put[symbol(Jet(letter, order))] = value
        value = rate(value, context.habits.moving)
    return put
