"""What letters mean in a context: what they stand for, or numbers of their own."""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Self

import sympy
from sympy import Expr, ImmutableMatrix, MatrixBase

from rigidtop.judge.context import Context, LetterDefinition
from rigidtop.judge.jets import TIME, Jet, rate, symbol
from rigidtop.judge.letters import INFINITY
from rigidtop.judge.names import basis_of, component_of, function_name, is_vector
from rigidtop.judge.particles import DENSITY, MASS, REGION, SPREAD, VOLUME, part
from rigidtop.judge.values import LARGEST, UnclearError, Value, length, size
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node

DEEPEST = 40
"""Definitions are not put into definitions deeper."""


@dataclass(frozen=True, slots=True)
class Meant(Node):
    """An expression in place of a formula: what was solved for a letter."""

    value: Value


@dataclass(frozen=True, slots=True)
class Curvature(Node):
    """The matrix of the second derivatives of a function by the entries of a column."""

    of: Node
    by: Node


@dataclass
class Memory:
    """What letters stood for when they were last asked, with what that rested on."""

    values: dict[object, tuple[Value, frozenset[int], dict[Letter, LetterDefinition | None]]] = (
        field(default_factory=dict)
    )
    conserved: dict[object, bool] = field(default_factory=dict)


@dataclass
class Vocabulary(ABC):
    """What finds the values of letters in a context, and notes what they rest on in `used`.

    With `known` it keeps the value of each node by its identity, for trees that share their parts.
    `held` letters are taken as numbers of their own whatever they stand for; `sign` is that of ±;
    `bound` says which particle an index is; `chosen` puts another expression of a letter in place
    of its definition.
    """

    context: Context
    memory: Memory = field(default_factory=Memory)
    held: frozenset[Letter] = frozenset()
    sign: int = 1
    bound: Mapping[str, int] = field(default_factory=dict)
    chosen: Mapping[Letter, Node] = field(default_factory=dict)
    used: set[int] = field(default_factory=set)
    known: dict[int, Value] | None = None
    consulted: dict[Letter, LetterDefinition | None] = field(default_factory=dict)
    depth: int = 0

    @property
    def moving(self) -> frozenset[Letter]:
        return self.context.habits.moving

    @abstractmethod
    def value(self, node: Node) -> Value:
        """What a formula means; raises UnclearError."""

    def scalar(self, node: Node) -> Expr:
        value = self.value(node)
        if isinstance(value, MatrixBase):
            if value.shape == (1, 1):
                return value[0, 0]
            raise UnclearError("a vector where a number has to be")
        return value

    def rate(self, value: Value) -> Value:
        if self.context.timeless:
            raise UnclearError("a rate where nothing is said of time")
        if isinstance(value, MatrixBase):
            return value.applyfunc(lambda x: rate(x, self.moving))
        return rate(value, self.moving)

    def with_(self, **changes: object) -> Self:
        """The same with something changed; what it uses is noted here too.

        What it has at hand is left behind where a formula means something else.
        """
        other = replace(self, **changes)  # type: ignore[arg-type]
        if "known" not in changes and other.reading != self.reading:
            other.known = None
        return other

    @property
    def reading(self) -> tuple[object, ...]:
        """What a formula means depends on, besides the context."""
        return self.held, self.sign, self.bound, self.chosen

    def letter(self, letter: Letter) -> Value:
        letter = self.named(letter)
        if letter in self.held:
            return self.free(letter)
        if letter in self.chosen:
            return self.with_(chosen={}).value(self.chosen[letter])
        definition = self.definition(letter)
        if definition is not None:
            return self._defined(letter, definition)
        if letter == INFINITY:
            raise UnclearError("∞ is no number")
        if letter.base == "π" and not letter.sub and letter not in self.context.habits.own:
            return sympy.pi
        if letter == Letter("i") and letter not in self.context.habits.own:
            return sympy.I
        if letter == self.context.habits.running:
            return TIME
        places = self.context.habits.functions.get(letter)
        if places is not None and not self.is_time(places):
            return self.unknown(letter, places)
        component = self.component(letter)
        if component is not None:
            return component
        vector = replace(letter, bold=True)
        if letter in self.context.habits.lengths:
            return length(self.letter(vector))
        return self.free(letter)

    def named(self, letter: Letter) -> Letter:
        """The letter, with the sign that ± has now."""
        if "±" in letter.sub or "∓" in letter.sub:
            signs = "+-" if self.sign > 0 else "-+"
            letter = replace(letter, sub=letter.sub.replace("±", signs[0]).replace("∓", signs[1]))
        return letter

    def definition(self, letter: Letter) -> LetterDefinition | None:
        found = self.context.definitions.get(letter)
        self.consulted[letter] = found
        return found if found is not None else self._neighbour(letter)

    def _neighbour(self, letter: Letter) -> LetterDefinition | None:
        """What x_{n+1} stands for where x_n is given by n."""
        shift = re.fullmatch(r"([a-z])([+-])([0-9])", letter.sub)
        if shift is None:
            return None
        index, step = Letter(shift[1]), n.Number(shift[3])
        own = replace(letter, sub=shift[1])
        known = self.context.definitions.get(own)
        self.consulted[own] = known
        if known is None or index not in n.letters(known.node):
            return None
        place = n.Sum((index, step if shift[2] == "+" else n.Negative(step)))
        return replace(known, node=n.replaced(known.node, index, n.Bracketed(place)))

    def index_of(self, letter: Letter) -> str:
        """The index of particles in its name, or that of a body in which it differs."""
        regions = sorted((x for x in self.bound if x.startswith(REGION)), reverse=True)
        if regions and letter.base in SPREAD and letter.sub in {"", *"xyz123"}:
            marks = (x for x in regions if x == REGION or letter.mark.endswith(x[len(REGION) :]))
            return next(marks, "")
        return next((x for x in self.bound if letter.sub == x or letter.sub.endswith("," + x)), "")

    def free(self, letter: Letter, index: str = "") -> Value:
        """Numbers of its own for a letter, of one particle if it has an index."""
        index = index or self.index_of(letter)
        place = (self.bound[index],) if index else ()
        if index.startswith(REGION) and letter == DENSITY:
            return part(MASS, *place) / part(VOLUME, *place)
        if is_vector(letter):
            fixed = None if letter in self.moving else basis_of(letter)
            if fixed is not None:
                return fixed
            return ImmutableMatrix([symbol(Jet(letter, 0, (*place, k))) for k in range(3)])
        return symbol(Jet(letter, 0, place))

    def _defined(self, letter: Letter, definition: LetterDefinition) -> Value:
        componentwise = self.context.componentwise
        key = letter, self.sign, self.held, tuple(self.bound.items()), componentwise
        known = self.memory.values.get(key)
        definitions = self.context.definitions
        if known is None or any(definitions.get(x) is not d for x, d in known[2].items()):
            if self.depth > DEEPEST:
                raise UnclearError(f"{letter.base} is defined by itself")
            bound = self.bound
            inner = self.with_(
                used=set(), consulted={letter: definition}, depth=self.depth + 1, bound=bound
            )
            value = inner.value(definition.node)
            if size(value) > LARGEST:
                raise UnclearError("it becomes too long")
            known = value, frozenset(inner.used | {definition.number}), inner.consulted
            self.memory.values[key] = known
        self.used |= known[1]
        self.consulted |= known[2]
        return known[0]

    def unknown(self, letter: Letter, places: Sequence[Node]) -> Value:
        """A function at its places of which nothing is known; over a body, a number a particle."""
        region = next((self.index_of(x) for place in places for x in n.letters(place)), "")
        if region.startswith(REGION):
            return self.free(letter, region)
        function = sympy.Function(function_name(letter), real=True)
        return function(*(self.scalar(x) for x in places))

    def component(self, letter: Letter) -> Expr | None:
        """v_x or ω_1 where the vector of that letter has a value in other letters.

        Along an axis that is given, it is so for ω_1′ whatever the vector stands for.
        """
        along = component_of(letter)
        if "′" in letter.sub and {along.left, along.right} <= self.context.definitions.keys():
            return self.scalar(along)
        for names in ("xyz", "123"):
            if len(letter.sub) == 1 and letter.sub in names and not letter.bold:
                vector = Letter(letter.base, "", letter.mark, True)
                definition = self.definition(vector)
                named = self.context.componentwise and vector in self.context.habits.vectors
                if definition is None and named:
                    return self.letter(vector)[names.index(letter.sub)]
                if definition is None or isinstance(definition.node, Meant):
                    continue
                if letter not in n.letters(definition.node):
                    if along.right in self.context.definitions:
                        return self.scalar(along)
                    value = self.letter(vector)
                    if isinstance(value, MatrixBase) and value.shape == (3, 1):
                        return value[names.index(letter.sub)]
        return None

    def is_time(self, places: Sequence[Node]) -> bool:
        """Whether the only place is the time, with which everything moves."""
        return list(places) == [self.context.habits.running]
