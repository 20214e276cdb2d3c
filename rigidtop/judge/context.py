"""What is known at a line of a text."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from sympy import MatrixBase

from rigidtop.judge.letters import CLOCK
from rigidtop.tree.nodes import Letter, Node, Number, TimeDerivative, Unit, letters, walked

START = "start"
"""The instant at which a motion begins; the time is zero then, if nothing else is said."""


@dataclass(frozen=True, eq=False)
class LetterDefinition:
    """What a letter stands for since a statement; `also` are expressions shown to be equal to it.

    `places` are the letters of which it is a function where the text says so, `index` is the letter
    that counts particles in its name.
    """

    node: Node
    number: int
    scope: tuple[int, ...] = ()
    places: tuple[Node, ...] = ()
    index: str = ""
    also: tuple[Node, ...] = ()
    supposed: bool = False
    """Whether it is said of a case, and ends where another scope begins."""
    motion: bool = False
    """Whether it is a motion in time, which ends with the part of the text around its scope."""
    deviation: bool = False
    """Whether it is a place with what moves away from there, which ends with its scope."""

    def lasts(self, scope: tuple[int, ...]) -> bool:
        """Whether the letter stands for it in another scope, too."""
        if self.supposed:
            return self.scope == scope
        if self.deviation:
            return is_open(self.scope, scope)
        return not self.motion or is_open(self.scope[:-1], scope)


LAW, PREMISE, SETTING, LINEAR = "law", "premise", "setting", "linear"
"""Why something holds: a stated law, what fixes a letter, a special motion, an approximation."""
PLACE = "place"
"""Or a value that is said in passing: it ends with its sentence."""
FORCED = "forced"
"""Or Lagrange's equation with a force that the Lagrangian does not have."""


FIELD = "field"
"""Or how a function of places changes, which holds at each of them."""
RULE = "rule"
"""Or what holds of each coordinate, written for any one."""


@dataclass(frozen=True, eq=False)
class Constraint:
    """Two sides that are equal, for all times or at one `instant`."""

    left: Node
    right: Node
    number: int
    kind: str
    scope: tuple[int, ...] = ()
    instant: str = ""
    until: int | None = None
    """The sentence with which it ends, where it is said of one place."""

    @property
    def letters(self) -> frozenset[Letter]:
        return letters(self.left) | letters(self.right)

    def stays(self, moving: frozenset[Letter]) -> bool:
        """Whether it gives something that moves, or the rate of it, a value that does not."""
        left = self.left.of if isinstance(self.left, TimeDerivative) else self.left
        return self.kind != LAW and left in moving and not letters(self.right) & moving


@dataclass(frozen=True, eq=False)
class Bound:
    """What a statement says to be no smaller than something else."""

    greater: Node
    less: Node
    number: int


@dataclass(frozen=True)
class LimitingCase:
    """A letter that becomes large, or small, in one sentence."""

    letter: Letter
    large: bool
    sentence: int


@dataclass(frozen=True)
class Habits:
    """How a whole text uses its letters.

    `moving` are those that have a rate somewhere, `functions` those that are written with a place
    behind them, `indices` count particles; `own` are i and e where the text makes them letters, and
    `lengths` are letters that stand for the length of the vector of that name, and `vectors` are
    those without an index. Everything moves with `running`, the time where nothing else is said.
    `fields` are functions of which only slopes are known at first.
    """

    moving: frozenset[Letter] = frozenset()
    functions: Mapping[Letter, tuple[Node, ...]] = field(default_factory=dict)
    indices: frozenset[str] = frozenset()
    own: frozenset[Letter] = frozenset()
    primes_are_rates: bool = False
    lengths: frozenset[Letter] = frozenset()
    vectors: frozenset[Letter] = frozenset()
    running: Letter = CLOCK
    fields: frozenset[Letter] = frozenset()
    units: frozenset[Letter] = frozenset()
    """Vectors that words say to be unit vectors."""
    driven: frozenset[Letter] = frozenset()
    """Letters whose motion the words say to be given, so that no law moves them."""
    extended: bool = False
    """Whether words speak of bodies that turn, whose energy is not that of their centre alone."""
    massless: bool = False
    """Whether by its words nothing in the text has a mass, so that it is 1."""
    weightless: bool = False
    """Whether by its words nothing in the text has a weight, or hangs on a spring."""


@dataclass(frozen=True, eq=False)
class Context:
    """Definitions, constraints, instants (with their time, where it is said) and letters so far."""

    habits: Habits
    definitions: Mapping[Letter, LetterDefinition] = field(default_factory=dict)
    constraints: tuple[Constraint, ...] = ()
    instants: Mapping[str, Node | None] = field(default_factory=dict)
    letters: frozenset[Letter] = frozenset()
    not_zero: tuple[Node, ...] = ()
    results: frozenset[Letter] = frozenset()
    """Letters that come out of what holds, as forces and amplitudes do: they may be zero."""
    supported: frozenset[int] = frozenset()
    """The numbers of the statements from which something has been found to follow."""
    doubted: frozenset[int] = frozenset()
    """The numbers of definitions of letters of which the text has said something else since."""
    given: frozenset[Letter] = frozenset()
    """Letters of what is given with a task: what they stand for is settled, or they are free."""
    declared: frozenset[Letter] = frozenset()
    """Letters that have a meaning where the task comes from: an answer does not bring them."""
    lawless: bool = False
    """Whether nothing is known of how things move: a Lagrangian is one function more."""
    timeless: bool = False
    """Whether nothing is said of time: no rate has a meaning."""
    bases: tuple[MatrixBase, ...] = ()
    """The axes in which components may be meant, each as a matrix of its unit vectors in space."""
    basis: MatrixBase | None = None
    componentwise: bool = False
    """Whether ω₁ is a component of a vector **ω** of which nothing says what it is."""
    bounds: tuple[Bound, ...] = ()
    """What is said to be no smaller than something else."""
    open: tuple[Constraint, ...] = ()
    """What letters are said to be in lines that are left open."""
    accelerations: tuple[Constraint, ...] = ()
    """Equations of motion that have been said."""
    followed: tuple[Constraint, ...] = ()
    """The latest equations that have been found to follow."""
    little: tuple[frozenset[Letter], ...] = ()
    """Letters that are said to be much smaller than others, together at a time."""
    compared: int = -1
    """The sentence that said so last."""
    brackets: int = 1
    """The sign of ∂f/∂q ∂g/∂p in the text's Poisson brackets."""
    limits: tuple[LimitingCase, ...] = ()
    """What letters tend to: zero or infinity."""
    said: tuple[Node, ...] = ()
    """The sides of the statement before."""
    head: Node | None = None
    """The letter, or else the side, with which the chain begins that is being read."""

    def forgetting(self, letter: Letter) -> Context:
        """Without what a letter stands for."""
        kept = {x: definition for x, definition in self.definitions.items() if x != letter}
        return replace(self, definitions=kept)

    def freeing(self, *nodes: Node) -> Context:
        """Without what was supposed of letters of which something else is supposed now.

        That is a number, or that both are equal.
        """
        kept = tuple(
            c
            for c in self.constraints
            if c.kind != SETTING or c.instant or {c.left, c.right} != {*nodes}
        )
        context = replace(self, constraints=kept)
        for letter in nodes:
            definition = self.definitions.get(letter) if isinstance(letter, Letter) else None
            if definition is not None and isinstance(definition.node, Number):
                context = context.forgetting(letter)  # type: ignore[arg-type]
        return context

    def defining(self, letter: Letter, definition: LetterDefinition) -> Context:
        """With a letter that stands for something from here on.

        What others stand for that would make it stand for itself is another problem's, and over.
        """
        kept = {x: other for x, other in self.definitions.items() if x != letter}
        for name in _reached(definition.node, kept):
            if letter in letters(kept[name].node):
                del kept[name]
        return replace(self, definitions={**kept, letter: definition})

    def comparing(self, little: frozenset[Letter], sentence: int) -> Context:
        """The same, where letters are small beside others: they are so together."""
        others = tuple(x for x in self.little if not x <= little)
        return replace(self, little=(*others, little), compared=sentence)

    def speaks_of(self, node: Node) -> bool:
        """Whether something that has been said, or follows, says what this is."""
        stated = (*self.constraints, *self.followed)
        return node in self.definitions or any(each.left == node for each in stated)

    def holding(self, constraint: Constraint) -> Context:
        """This context with one more constraint."""
        return replace(self, constraints=(*self.constraints, constraint))

    def staying(self, instant: str, sentence: int) -> Context:
        """With what is so at an instant for all times, as long as one sentence speaks."""
        there = (c for c in self.constraints if c.instant and c.instant == instant)
        kept = tuple(replace(c, instant="", until=sentence) for c in there)
        return replace(self, constraints=(*self.constraints, *kept))

    def deviating(self, letter: Letter) -> Context:
        """With no special motion of a letter that moves, but with what it has said of constants."""
        moving = self.habits.moving
        special = [
            c
            for c in self.constraints
            if not c.instant and (c.kind in (SETTING, PLACE) or c.stays(moving))
        ]
        since = min((c.number for c in special if letter in c.letters), default=None)
        if since is None:
            return self
        over = [c for c in special if c.number >= since]
        kept = [c for c in self.constraints if c not in over]
        said = [
            c for c in self.followed if c.number > since and not (c.instant or c.letters & moving)
        ]
        return replace(self, constraints=(*kept, *said))

    def without_equations(self) -> Context:
        """With no more than what letters stand for."""
        return replace(self, constraints=(), lawless=True)

    def generally(self) -> Context:
        """Without the special cases, and without the places that are passed."""
        ended = (SETTING, PLACE)
        kept = tuple(c for c in self.constraints if c.instant or c.kind not in ended)
        definitions = {x: each for x, each in self.definitions.items() if not each.supposed}
        return replace(self, constraints=kept, definitions=definitions)

    def without_cases(self, written: frozenset[Letter]) -> Context:
        """Without the cases in which letters have numbers, where they are written as letters."""

        def is_over(letter: Node, value: Node) -> bool:
            return letter in written and (isinstance(value, Number) or has_unit(value))

        settings = [c for c in self.constraints if c.kind == SETTING and not c.instant]
        over = [c.number for c in settings if is_over(c.left, c.right)]
        given = {x: d for x, d in self.definitions.items() if is_over(x, d.node)}
        if not over and not given:
            return self
        over += [d.number for d in given.values() if not has_unit(d.node)]
        definitions = {x: d for x, d in self.definitions.items() if x not in given}
        # What has been found in a case is over with it.
        ended = {id(c) for c in settings if over and c.number >= min(over)}
        kept = tuple(c for c in self.constraints if id(c) not in ended)
        return replace(self, definitions=definitions, constraints=kept)

    def opposing(self, bound: Bound) -> Context:
        """With a condition, and without what was said under the opposite one: of another case."""
        opposite = (bound.less, bound.greater)
        since = [b.number for b in self.bounds if (b.greater, b.less) == opposite]
        if not since:
            return replace(self, bounds=(*self.bounds, bound))
        kept = {x: d for x, d in self.definitions.items() if not d.motion or d.number < since[0]}

        def before(equations: tuple[Constraint, ...]) -> tuple[Constraint, ...]:
            return tuple(c for c in equations if c.number < since[0])

        return replace(
            self,
            definitions=kept,
            constraints=before(self.constraints),
            accelerations=before(self.accelerations),
            followed=before(self.followed),
            bounds=(*(b for b in self.bounds if b.number < since[0]), bound),
        )

    def doubting(self, node: Node) -> Context:
        """With a doubt of what a letter stands for."""
        definition = self.definitions.get(node) if isinstance(node, Letter) else None
        if definition is None:
            return self
        return replace(self, doubted=self.doubted | {definition.number})

    def knowing(self, letters: frozenset[Letter]) -> Context:
        return replace(self, letters=self.letters | letters)

    def within(self, scope: tuple[int, ...], sentence: int | None = None) -> Context:
        """What is left of it in another scope: what was set in one that has ended is over."""
        kept = tuple(
            c
            for c in self.constraints
            if (is_open(c.scope, scope) or c.kind == LAW or _is_listed(c, scope))
            and c.until in (None, sentence)
        )
        definitions = {
            letter: definition
            for letter, definition in self.definitions.items()
            if definition.lasts(scope) and (letter != CLOCK or is_open(definition.scope, scope))
        }
        open_here = tuple(each for each in self.open if is_open(each.scope, scope))
        moved = tuple(each for each in self.accelerations if is_open(each.scope, scope))
        followed = tuple(each for each in self.followed if is_open(each.scope, scope))
        return replace(
            self,
            constraints=kept,
            definitions=definitions,
            open=open_here,
            accelerations=moved,
            followed=followed,
            limits=tuple(each for each in self.limits if each.sentence == sentence),
        )


def has_unit(node: Node) -> bool:
    """Whether it is a measured number."""
    return not letters(node) and any(isinstance(x, Unit) for x in walked(node))


def _reached(node: Node, definitions: Mapping[Letter, LetterDefinition]) -> list[Letter]:
    """The letters with a meaning in a node, and in what these stand for."""
    reached: list[Letter] = []
    left = [node]
    while left:
        new = [x for x in letters(left.pop()) if x in definitions and x not in reached]
        reached += new
        left += [definitions[x].node for x in new]
    return reached


def _is_listed(constraint: Constraint, now: tuple[int, ...]) -> bool:
    """Whether it is said in an item of a list, and of the list as a whole."""
    scope = constraint.scope
    outer = next((scope[:k] for k, number in enumerate(scope) if number < 0), scope)
    return constraint.kind == PREMISE and is_open(outer, now)


def is_open(scope: tuple[int, ...], now: tuple[int, ...]) -> bool:
    """Whether a place lies in a scope."""
    return now[: len(scope)] == scope
