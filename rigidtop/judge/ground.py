"""What a line of a page rests on, as a context of the judge and as expressions that vanish."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from itertools import pairwise

from sympy import Expr, ImmutableMatrix, MatrixBase, eye

from rigidtop.judge.alphabet import Alphabet, letters_of
from rigidtop.judge.context import PREMISE, Constraint, Context, Habits, LetterDefinition
from rigidtop.judge.jets import TIME, Jet, jets, symbol
from rigidtop.judge.letters import CLOCK
from rigidtop.judge.meaning import Meaning
from rigidtop.judge.particles import particles
from rigidtop.judge.residual import Residual
from rigidtop.judge.values import UnclearError, Value, pairs
from rigidtop.judge.vocabulary import Meant, Memory
from rigidtop.proof.moves import Condition, Scope
from rigidtop.read.statements import statements
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.statement import Statement
from rigidtop.typeset.latex import latex

EQUALS = ("=", "≡")

HERE = "here"
"""The instant of what is set at a moment: it says nothing of rates."""

SLACK, ENTRY = "slack", "entry"
"""Marks of numbers that no page writes: how far a bound is from being reached, an operator's."""


@dataclass(frozen=True)
class LinePremises:
    """What a line rests on: what is stated, whether some of it is unread, and what is set.

    The first `general` of the statements are laws and definitions, which hold for any vector.
    """

    stated: tuple[Statement, ...]
    general: int
    unread: bool
    conditions: tuple[Condition, ...]
    scope: Scope


@dataclass
class ValueCache:
    """Values of formulas, each worked out once for all the lines of a page.

    A value is taken again as long as all letters stand for what they stood for.
    """

    _definitions: dict[tuple[Letter, Node], LetterDefinition] = field(default_factory=dict)
    _memories: dict[MatrixBase | None, Memory] = field(default_factory=dict)
    _known: dict[object, tuple[Value, Mapping[Letter, LetterDefinition | None]]] = field(
        default_factory=dict
    )

    def definition(self, letter: Letter, node: Node) -> LetterDefinition:
        """What a letter stands for: the same object for the same formula."""
        return self._definitions.setdefault((letter, node), LetterDefinition(node, -1))

    def of(
        self, node: Node, context: Context, sign: int = 1, bound: Mapping[str, int] | None = None
    ) -> Value:
        """The value of a formula; raises UnclearError."""
        key = node, sign, context.basis, tuple((bound or {}).items())
        known = self._known.get(key)
        if known is None or any(context.definitions.get(x) is not d for x, d in known[1].items()):
            memory = self._memories.setdefault(context.basis, Memory())
            meaning = Meaning(context, memory, sign=sign, bound=bound or {})
            known = self._known[key] = meaning.value(node), meaning.consulted
        return known[0]


def names_and_slopes(read: Iterable[Statement]) -> frozenset[Letter]:
    """All letters that pages write, and one for each slope."""
    nodes = [x for each in read for side in each.sides for x in n.walked(side)]
    letters = frozenset(x for x in nodes if isinstance(x, Letter))
    return letters | {slope(x) for x in nodes if isinstance(x, n.Derivative)}


def habits(written: frozenset[Letter], letters: Alphabet) -> Habits:
    """How pages use the letters that are `written`: what is no number moves."""
    moving = (written | letters.unit) - letters.numbers - {CLOCK, Letter("π")}
    entries = {entry_of(x) for x in letters.operators & moving}
    return Habits(moving | entries, letters.functions)


def slope(node: n.Derivative) -> Letter:
    """A letter for the slope of what nothing says."""
    of = n.ungrouped(node.of)
    return Letter("∂", repr(node), bold=isinstance(of, Letter) and of.bold)


def entry_of(operator: Letter) -> Letter:
    """The letter of the entries of an operator."""
    return replace(operator, mark=operator.mark + ENTRY)


def has_sign(*sides: Node) -> bool:
    """Whether ± stands in one of the sides."""
    return any(map(_has_sign, sides))


@lru_cache(maxsize=20_000)
def _has_sign(side: Node) -> bool:
    return any(
        isinstance(x, n.PlusMinus) or (isinstance(x, Letter) and ("±" in x.sub or "∓" in x.sub))
        for x in n.walked(side)
    )


@lru_cache(maxsize=20_000)
def _has_column(side: Node) -> bool:
    """Whether three components are written in it."""
    return any(
        (isinstance(x, n.Tuple) and len(x.entries) == 3)
        or (isinstance(x, n.Matrix) and len(x.rows) == 3 and len(x.rows[0]) == 1)
        for x in n.walked(side)
    )


@lru_cache(maxsize=20_000)
def _counted(side: Node) -> frozenset[str]:
    """The indices over which sums in it run."""
    totals = (x for x in n.walked(side) if isinstance(x, n.Total))
    return frozenset(x.base for total in totals for x in total.index)


def equations(each: Statement) -> Iterator[tuple[str, Node, Node]]:
    """The links of a statement: relation, and both sides; what is constant has no rate."""
    for relation, (left, right) in zip(each.relations, pairwise(each.sides), strict=True):
        if isinstance(right, n.Constant):
            yield relation, n.TimeDerivative(left), n.Number("0")
        else:
            yield relation, left, right


@dataclass(frozen=True, eq=False)
class Ground:
    """A line's ground: what it and its premises say, in these letters, with their values.

    With `whole` all that it rests on stands in the premises, and not only what it cites.
    """

    premises: LinePremises
    letters: Alphabet
    habits: Habits
    values: ValueCache
    stated: tuple[Statement, ...]
    whole: bool

    @cached_property
    def sides(self) -> tuple[Node, ...]:
        every = (*self.premises.stated, *self.stated)
        return tuple(side for each in every for side in each.sides)

    @cached_property
    def names(self) -> frozenset[Letter]:
        """All letters of the line and of its premises."""
        return frozenset(x for side in self.sides for x in n.letters(side))

    @cached_property
    def news(self) -> frozenset[Letter]:
        """The letters of the line that nothing it rests on has."""
        known = letters_of(x for c in self.premises.conditions for x in c.expression.free_symbols)
        known |= {x for each in self.premises.stated for y in each.sides for x in n.letters(y)}
        here = {x for each in self.stated for side in each.sides for x in n.letters(side)}
        fixed = self.letters.unit | {CLOCK, Letter("π"), Letter("e"), Letter("i")}
        indices = {x for x in here if x.base in self.context.habits.indices and not x.sub}
        return frozenset(here - known - fixed - indices)

    @cached_property
    def is_partial(self) -> bool:
        """Whether something that it rests on is not known here."""
        return self.premises.unread or any(
            n.letters(side) & self.letters.double
            for each in self.premises.stated
            for side in each.sides
        )

    @cached_property
    def vanishing(self) -> frozenset[Letter]:
        """Letters that are set to something, and so perhaps to nothing."""
        made = {
            x
            for c in self.context.constraints
            if isinstance(c.left, Letter) or isinstance(c.right, Letter)
            for side in (c.left, c.right)
            for x in n.letters(side)
        }
        for condition in self.premises.conditions:
            if condition.relation == "=":
                made |= letters_of(condition.expression.free_symbols)
        return frozenset(made)

    def bases(self) -> list[MatrixBase | None]:
        """The frames in which columns may be meant; none where no columns are written."""
        if not any(map(_has_column, self.sides)):
            return [None]
        made: list[MatrixBase | None] = []
        for frame in sorted(self.letters.frames, key=lambda f: {*f} != {*self.letters.body}):
            try:
                axes = [self.values.of(x, self.context) for x in frame]
                made.append(ImmutableMatrix.hstack(*axes))
            except UnclearError:
                continue
        return made or [ImmutableMatrix(eye(3))]

    def plain(self, node: Node, definitions: Mapping[Letter, LetterDefinition]) -> Node:
        """Without rates seen from the body, and slopes of what nothing says."""

        def change(each: Node) -> Node:
            if (
                isinstance(each, n.TimeDerivative)
                and each.frame.startswith("body")
                and self.letters.body
            ):
                terms = [
                    n.Product((n.TimeDerivative(n.DotProduct(e, each.of), each.order), e))
                    for e in self.letters.body
                ]
                return n.Sum(tuple(terms))
            if isinstance(each, n.Derivative) and not (each.by == (CLOCK,) and not each.partial):
                of = n.ungrouped(each.of)
                along = not each.partial and {of, *each.by} <= self.habits.moving
                known = along or of in definitions or self.whole
                if isinstance(of, Letter) and not known:
                    return slope(each)
            if isinstance(each, n.TransposedMatrix) and isinstance(each.of, n.Tuple):
                return each.of
            return each

        return n.mapped(node, change)

    # --- The context -------------------------------------------------------------------------

    @cached_property
    def context(self) -> Context:
        """What is known of the letters of the line and its premises."""
        letters = self.letters
        counted = frozenset().union(*map(_counted, self.sides))
        indexed = replace(self.habits, indices=frozenset(letters.indices | counted))
        context = Context(indexed, lawless=True)
        for letter in letters.operators & self.names:
            entry = entry_of(letter)
            matrix = [[symbol(Jet(entry, 0, (i, k))) for k in range(3)] for i in range(3)]
            node = Meant(ImmutableMatrix(matrix))
            context = context.defining(letter, self.values.definition(letter, node))
        for number, each in enumerate(self.premises.stated):
            for relation, left, right in equations(each):
                here = n.letters(left) | n.letters(right)
                if relation not in EQUALS or here & letters.double:
                    continue
                free = here & letters.arbitrary if number < self.premises.general else frozenset()
                for one, other in _instances(left, right, free):
                    context = self._with(context, one, other)
        return self._with_components(self._with_frames(context))

    def _with(self, context: Context, left: Node, right: Node) -> Context:
        """With an equation, as a definition of a letter on one of its sides if it can be one."""
        letters = self.letters
        for name, other in ((left, right), (right, left)):
            if isinstance(name, n.Call) and isinstance(name.function, Letter):
                name = name.function
            if (
                isinstance(name, Letter)
                and name not in context.definitions
                and name not in letters.coordinates
                and not (
                    name in letters.unit and (name in letters.numbers or not self._is_turned(other))
                )
                and name not in _made_of(context, other)
            ):
                node = self.plain(other, context.definitions)
                return context.defining(name, self.values.definition(name, node))
        return context.holding(Constraint(left, right, -1, PREMISE))

    def _is_turned(self, node: Node) -> bool:
        """Whether a unit vector is written by other unit vectors alone."""
        vectors = self.letters.vectors | self.letters.operators
        return not any(
            x in vectors or x.bold or x.mark == "hat" for x in n.letters(node) - self.letters.unit
        ) and not any(isinstance(x, (n.TimeDerivative, n.CrossProduct)) for x in n.walked(node))

    def _with_components(self, context: Context) -> Context:
        for letter, node in self.letters.components.items():
            if (
                letter in self.names
                and letter not in context.definitions
                and letter not in _made_of(context, node)
            ):
                context = context.defining(letter, self.values.definition(letter, node))
        return context

    def _with_frames(self, context: Context) -> Context:
        """With right-handed frames of unit vectors, as far as these are spoken of."""
        letters = self.letters
        columns = (x for x in letters.unit & letters.numbers if x.mark == "hat")  # by themselves
        spoken = frozenset(
            x for y in self.names for x in (y, *_made_of(context, y)) if x in letters.unit
        )
        known = [*columns, *(x for x in spoken if x in context.definitions)]
        for frame in sorted(letters.frames, key=lambda f: -len({*f} & {*known})):
            for k, axis in enumerate(frame):
                if axis not in spoken or axis in known:
                    continue
                others = [x for x in (frame[k - 2], frame[k - 1]) if x in known]
                node = n.CrossProduct(frame[k - 2], frame[k - 1])
                if len(others) == 2 and axis not in _made_of(context, node):
                    context = context.defining(axis, self.values.definition(axis, node))
                else:
                    one, none = n.Number("1"), n.Number("0")
                    for other in (axis, *others):
                        dot, value = n.DotProduct(axis, other), one if other is axis else none
                        context = context.holding(Constraint(dot, value, -1, PREMISE))
                known.append(axis)
        return context

    # --- What vanishes -----------------------------------------------------------------------

    def residuals(self, context: Context) -> tuple[list[Residual], bool]:
        """What vanishes where all holds that the line rests on, and whether that is all of it."""
        made: list[Residual] = []
        complete = not self.is_partial
        for each in context.constraints:
            try:
                made += self._of(each, context)
            except UnclearError:
                complete = False
        for k, condition in enumerate(self.premises.conditions):
            if condition.relation == "≠":
                continue
            node = _node_of(condition.expression)
            if condition.relation in ("=", ">", "≥") and node is not None:
                made += self._set(condition, node, k, context)
            else:
                complete = False
        return made, complete

    def apart(self, context: Context) -> Iterator[Expr]:
        """What is divided by on the way to the line: no world has a zero of it."""
        for condition in self.premises.conditions:
            if condition.relation == "≠" and (node := _node_of(condition.expression)) is not None:
                with suppress(UnclearError):
                    value = self.values.of(node, context)
                    yield from () if isinstance(value, MatrixBase) else (value,)

    def _of(self, each: Constraint, context: Context) -> Iterator[Residual]:
        left, right = (self.plain(x, context.definitions) for x in (each.left, each.right))
        for sign in (1, -1) if has_sign(left, right) else (1,):
            for bound in particles(context.habits.indices, left, right):
                sides = [self.values.of(x, context, sign, bound) for x in (left, right)]
                for a, b in pairs(*sides):
                    if a - b != 0:
                        at = HERE if self._says_when(a - b) else ""
                        yield Residual(a - b, frozenset(), PREMISE, each, at)

    def _says_when(self, value: Expr) -> bool:
        """Whether it gives a time, and is no law for all times: nothing in it moves."""
        return value.has(TIME) and not any(
            jet.order or jet.letter in self.habits.moving for jet in jets(value).values()
        )

    def _set(
        self, condition: Condition, node: Node, number: int, context: Context
    ) -> Iterator[Residual]:
        """What is set, at all times or at a moment, and what is positive."""
        value = self.values.of(node, context)
        values = [*value] if isinstance(value, MatrixBase) else [value]
        if condition.relation == "=":
            at = HERE if self.premises.scope is Scope.SET else ""
            yield from (Residual(x, frozenset(), PREMISE, None, at) for x in values)
        else:
            slack = symbol(Jet(Letter("", str(number), SLACK)))
            yield from (Residual(x - slack**2, frozenset(), PREMISE, None, HERE) for x in values)


@lru_cache(maxsize=1_000)
def _node_of(expression: Expr) -> Node | None:
    """An expression of the proof as a formula that can be judged."""
    [read] = statements(latex(expression) + " = 0")
    return read.sides[0] if isinstance(read, Statement) else None


def _made_of(context: Context, node: Node) -> frozenset[Letter]:
    """The letters of a formula, and those of what they stand for."""
    found: set[Letter] = set()
    waiting = [*n.letters(node)]
    while waiting:
        letter = waiting.pop()
        if letter not in found:
            found.add(letter)
            known = context.definitions.get(letter)
            waiting += [*n.letters(known.node)] if known is not None else []
    return frozenset(found)


def _instances(
    left: Node, right: Node, arbitrary: frozenset[Letter]
) -> Iterator[tuple[Node, Node]]:
    """What is said of any vector, said of three."""
    if not arbitrary:
        yield left, right
        return
    letter = min(arbitrary, key=str)
    for k in range(3):
        unit = Meant(ImmutableMatrix([int(k == j) for j in range(3)]))
        yield from _instances(
            n.replaced(left, letter, unit), n.replaced(right, letter, unit), arbitrary - {letter}
        )
