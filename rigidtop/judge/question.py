"""Two sides that are said to be equal: what they mean, what they rest on, worlds for that."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import cached_property

from sympy import Expr

from rigidtop.judge import worlds as w
from rigidtop.judge.context import PREMISE, SETTING, Constraint, Context, LetterDefinition
from rigidtop.judge.jets import TIME, Jet, jets, operations, rate, symbol, time_at
from rigidtop.judge.laws import moved, residuals
from rigidtop.judge.meaning import Meaning
from rigidtop.judge.outcome import SAMPLED, Outcome
from rigidtop.judge.particles import particles
from rigidtop.judge.residual import Residual
from rigidtop.judge.sides import entries, letters_of, own_letters
from rigidtop.judge.situation import Situation
from rigidtop.judge.surroundings import surrounding
from rigidtop.judge.values import LARGEST, UnclearError, Value, pairs, plain
from rigidtop.judge.vocabulary import Memory
from rigidtop.judge.worlds import Worlds
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node

Pair = tuple[Expr, Expr]
Judgement = tuple[Outcome, Context]
"""What became of a statement, and what is known behind it."""

MOST_GIVEN_UP = 4
"""So many premises are given up, the oldest first, where they do not hold together."""


MOST_FOLLOWED = 8
"""So many equations that followed are remembered."""

ALL_SLIPS_SECONDS = 30.0
"""How long slips are looked for in a whole text (s, of the processor's time)."""


@dataclass
class Patience:
    """How many seconds of the processor are left to look for slips in a text."""

    seconds: float = ALL_SLIPS_SECONDS

    @property
    def is_over(self) -> bool:
        return self.seconds <= 0

    @contextmanager
    def search(self, longest: float) -> Iterator[float]:
        """When a search has to end, which takes of these seconds what it needs."""
        begun = time.process_time()
        yield begun + min(longest, self.seconds)
        self.seconds -= time.process_time() - begun


@dataclass(frozen=True, eq=False)
class Premises:
    """What holds in a context: at an instant, if one is named."""

    context: Context
    memory: Memory
    instant: str = ""

    @cached_property
    def residuals(self) -> list[Residual]:
        """Laws and constraints as expressions that vanish."""
        return residuals(self.context, self.memory, self.instant)

    @cached_property
    def not_zero(self) -> list[Expr]:
        """What the text says does not vanish."""
        return [*self._not_zero()]

    def _not_zero(self) -> Iterator[Expr]:
        for node in self.context.not_zero:
            try:
                yield Meaning(self.context, self.memory).scalar(node)
            except UnclearError:
                continue


@dataclass(frozen=True, eq=False)
class Grounds:
    """The premises that have to do with a question, as equations, with both sides beside them."""

    both: list[Pair]
    equations: list[Expr]
    rests_on: frozenset[int]
    near: list[Residual]


@dataclass(frozen=True, eq=False)
class TrialMotion:
    """A motion that is tried for a letter: what is known without it, and with it put in."""

    letter: Letter
    value: Expr
    before: Context
    definition: LetterDefinition

    @property
    def context(self) -> Context:
        """What is known with it."""
        return self.before.defining(self.letter, self.definition)


@dataclass(frozen=True, eq=False)
class Question:
    """Whether two sides are equal where they stand; `inner` is a link behind a chain's first one.

    `signs` are those of ±: with two the sides are the two roots of something. With `asked` other
    sides are compared, in place of what is written; `path` is the motion that they try. Of a letter
    that is `chosen` another expression is taken.  Where it is `deep`, rates are taken of all.
    """

    left: Node
    right: Node
    at: Situation
    premises: Premises
    patience: Patience
    inner: bool = False
    signs: tuple[int, ...] = (1,)
    asked: tuple[Pair, ...] | None = None
    used: frozenset[int] = field(default_factory=frozenset)
    path: TrialMotion | None = None
    chosen: Mapping[Letter, Node] = field(default_factory=dict)
    deep: bool = False

    @property
    def context(self) -> Context:
        return self.premises.context

    @property
    def memory(self) -> Memory:
        return self.premises.memory

    @property
    def moving(self) -> frozenset[Letter]:
        """The letters that have a rate somewhere in the text."""
        return self.context.habits.moving

    # --- the same otherwise ----------------------------------------------------------------------

    def within(self, context: Context) -> Question:
        """The same question where something else holds."""
        return replace(self, premises=replace(self.premises, context=context))

    def always(self) -> Question:
        """The same question of all times, in place of one instant."""
        premises = replace(self.premises, instant="")
        return replace(self, at=replace(self.at, instant=""), premises=premises)

    def of(self, both: Sequence[Pair], context: Context | None = None) -> Question:
        """The same with other sides, perhaps where something else holds."""
        other = replace(self, asked=tuple(both), used=self.rests_on_meaning)
        return other if context is None else other.within(context)

    def consistent(self) -> Question | None:
        """The same without the oldest premises that do not hold together with the rest.

        They are another problem's. None where no world is found so either.
        """
        near = {r.constraint for r in self.grounds.near}
        scope = self.at.scope
        order = sorted(
            (each for each in self.context.constraints if each in near),
            key=lambda c: (scope[: len(c.scope)] == c.scope, c.kind != SETTING, c.number),
        )
        kept = self.context
        for constraint in order[:MOST_GIVEN_UP]:
            left = tuple(c for c in kept.constraints if c is not constraint)
            kept = replace(kept, constraints=left)
            other = self.of(self.both, kept)
            if other.worlds.count:
                return other
        return None

    # --- what it means ---------------------------------------------------------------------------

    def meaning(self, **changes: object) -> Meaning:
        """What finds values here, with the first sign."""
        changes = {"sign": self.signs[0], "chosen": self.chosen, **changes}
        return Meaning(self.context, self.memory, **changes)  # type: ignore[arg-type]

    def meanings(self, **changes: object) -> list[Meaning]:
        """What finds values here, one for each sign."""
        return [self.meaning(sign=sign, **changes) for sign in self.signs]

    def sides(self, meanings: Sequence[Meaning], left: Node, right: Node) -> list[Pair]:
        """Both sides as expressions, for each particle if they speak of any one; now or then.

        Raises UnclearError.
        """
        bound = particles(self.context.habits.indices, left, right, most=2)
        values = [meaning.with_(bound=each) for meaning in meanings for each in bound]
        both = [pair for x in values for pair in pairs(x.value(left), x.value(right))]
        if self.at.instant:
            both = [(self.then(a), self.then(b)) for a, b in both]
        if sum(operations(x) for pair in both for x in pair) > 2 * LARGEST:
            raise UnclearError("it becomes too long")
        return both

    def then(self, expression: Expr, instant: str = "") -> Expr:
        """What an expression is at an instant, else at the one of which the statement speaks."""
        return moved(expression, instant or self.at.instant, self.context, self.memory)

    @cached_property
    def _meant(self) -> tuple[list[Pair], frozenset[int]]:
        if self.asked is not None:
            return [*self.asked], self.used
        meanings = self.meanings()
        both = self.sides(meanings, self.left, self.right)
        return both, frozenset().union(*(meaning.used for meaning in meanings))

    @property
    def meant(self) -> list[Pair]:
        """Both sides as expressions, a pair a component; raises UnclearError."""
        return self._meant[0]

    @property
    def rests_on_meaning(self) -> frozenset[int]:
        """The statements that say what the letters of both sides stand for."""
        return self._meant[1]

    # --- what holds beside it --------------------------------------------------------------------

    @property
    def pool(self) -> list[Residual]:
        """All laws and constraints that hold here, as expressions that vanish."""
        return self.premises.residuals

    @cached_property
    def grounds(self) -> Grounds:
        """What has to do with it."""
        flat = [x for pair in self.meant for x in pair]
        equations, rests_on, near = surrounding(flat, self.context, self.pool, self.deep)
        together = plain([*equations, *flat])
        count = len(equations)
        return Grounds(paired(together[count:]), together[:count], rests_on, near)

    @property
    def both(self) -> list[Pair]:
        """Both sides, with a symbol for the value of each unknown function."""
        return self.grounds.both

    @property
    def equations(self) -> list[Expr]:
        """What vanishes where all holds that has to do with it."""
        return self.grounds.equations

    @cached_property
    def worlds(self) -> Worlds:
        """Numbers at which all holds that has to do with it."""
        letters = w.symbols_of([*self.equations, *(x for pair in self.both for x in pair)])
        may_vanish = self.context.results
        if isinstance(self.left, Letter) and self.right == n.Number("0"):
            may_vanish |= {self.left}  # it may have to
        return w.found(self.equations, letters, may_vanish, self.premises.not_zero)

    @property
    def rests_on(self) -> frozenset[int]:
        """The statements that it would follow from."""
        return (self.rests_on_meaning | self.grounds.rests_on) - {self.at.number}

    def holds(self) -> bool:
        """Whether the sides are equal in every world."""
        return bool(self.worlds.holds(self.both))

    # --- what is in it ---------------------------------------------------------------------------

    @cached_property
    def new_letters(self) -> list[Letter]:
        """Letters of which nothing that stands above speaks."""
        spoken = {x for each in self.pool for x in letters_of(each.expression)}
        for definition in self.context.definitions.values():
            spoken |= n.letters(definition.node)
        meant = {x for pair in self.both for side in pair for x in letters_of(side)}
        spoken |= self.context.definitions.keys() | self.context.given | self.context.declared
        return sorted(meant - spoken, key=str)

    @property
    def gaps(self) -> list[Expr]:
        """The difference of both sides, one a component."""
        return [a - b for a, b in self.both]

    def moves(self, *values: Value) -> bool:
        """Whether a letter that moves, or a rate, stands in what is meant."""
        return any(
            not j.instant and (j.order or j.letter in self.moving)
            for value in values
            for x in entries(value)
            for j in jets(x).values()
        )

    def constraint(self, kind: str) -> Constraint:
        """That both sides are equal, as something that holds from here on."""
        at = self.at
        names = own_letters(self.left) | own_letters(self.right)
        sides = [x for pair in self.both for x in pair]
        times = {TIME, time_at(at.instant)}
        moves = bool(names & self.moving) or self.moves(*sides) or any(x.has(*times) for x in sides)
        # Said of one place, r = R ŷ ends with its sentence, unless the motion passes there.
        bare = isinstance(self.left, Letter) and not self.left.sub
        placed = at.instant and not moves and bare
        until = at.sentence if placed else None
        instant = at.instant if moves else ""
        return Constraint(self.left, self.right, at.number, kind, at.scope, instant, until)

    def follows(self) -> Judgement:
        """That it follows; its right side is another expression of what the chain begins with."""
        context = self.context
        letter = context.head
        if isinstance(letter, Letter) and letter in context.definitions and self.signs[0] == 1:
            definition = context.definitions[letter]
            also = (*definition.also, self.right)
            context = context.defining(letter, replace(definition, also=also))
        followed = (*context.followed, self.constraint(PREMISE))[-MOST_FOLLOWED:]
        supported = context.supported | self.rests_on
        context = replace(context, supported=supported, followed=followed)
        if isinstance(self.left, Letter) and not self.at.instant:
            # What comes out of what holds may be zero in a special case, or negative.
            context = replace(context, results=context.results | {self.left})
        return Outcome(SAMPLED, "", self.rests_on), context

    def is_kept(self, both: Sequence[Pair]) -> bool:
        """Whether sides are equal at an instant, and so, by how they change, all the time."""
        instants = self._instants
        if self.at.instant or self.path is not None or not self.worlds.count or not instants:
            return False
        rates = self._rates(both)
        if all(a == b == 0 for a, b in rates):
            return False
        if not self._times.holds(rates):
            return self._stays_equal(both) or self._stays_equal([*both, *rates])
        still = self._stand_still(rates)
        then = [self._then(both, x) for x in instants]
        return any(
            self._times.holds(pairs) and not (still and self._stand_still(pairs)) for pairs in then
        )

    def _stays_equal(self, both: Sequence[Pair]) -> bool:
        """Whether sides are equal at an instant of which they speak, and stay so if they are.

        So it is with x = x(0) cos wt + y(0) sin wt: what holds has one solution for a start.
        """
        spoken = {jet.instant for pair in both for x in pair for jet in jets(x).values()} - {""}
        rates = self._rates(both)
        for instant in spoken:
            then = self._then(both, instant)
            there = replace(self, premises=replace(self.premises, instant=instant))
            known = there.of([*both, *rates, *then]).worlds
            equal = [*known.equations, *(a - b for a, b in both)]
            alike = w.found(equal, known.letters, self.context.results, self.premises.not_zero)
            if alike.count and alike.holds(rates) and known.holds(then):
                return True
        return False

    def _then(self, both: Sequence[Pair], instant: str) -> list[Pair]:
        return [(self.then(a, instant), self.then(b, instant)) for a, b in both]

    def _stand_still(self, both: Sequence[Pair]) -> bool:
        """Whether sides vanish, each by itself."""
        written = [x for pair in both for x in pair if 0 not in pair]
        return bool(written) and self._times.vanish(written)

    @property
    def _instants(self) -> set[str]:
        """The instants of which something is known, or of which the sides speak: x = x(0)."""
        spoken = {jet.instant for pair in self.both for x in pair for jet in jets(x).values()}
        return {c.instant for c in self.context.constraints if c.instant} | spoken - {""}

    def _rates(self, both: Sequence[Pair]) -> list[Pair]:
        return [(rate(a, self.moving), rate(b, self.moving)) for a, b in both]

    @cached_property
    def _times(self) -> Worlds:
        """Worlds of now and of the instants of which something is known."""
        instants = self._instants
        then = [(self.then(a, x), self.then(b, x)) for a, b in self.both for x in instants]
        return self.of([*self.both, *self._rates(self.both), *then]).worlds


def paired(expressions: Sequence[Expr]) -> list[Pair]:
    """Each two expressions that follow each other as a pair."""
    return list(zip(*[iter(expressions)] * 2, strict=True))


def alone(letter: Letter) -> Expr:
    """The number of a letter itself."""
    return symbol(Jet(letter))
