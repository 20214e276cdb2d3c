"""What a formula means in a context: an expression of SymPy in the numbers of a world.

Letters that stand for something are put in, rates are taken by the chain rule, vectors are columns
of three components, and sums run over three particles.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import pairwise
from typing import Any

import numpy as np
import sympy
from sympy import Expr, ImmutableMatrix, MatrixBase, Rational, Symbol

from rigidtop.judge.brackets import bracket, conjugates, is_bracket
from rigidtop.judge.context import Context, Definition
from rigidtop.judge.jets import TIME, Jet, at_instant, jet_of, jets, rate, symbol
from rigidtop.judge.names import basis_of, component_of, function_name, is_vector
from rigidtop.judge.units import UNITS
from rigidtop.judge.values import (
    LARGEST,
    UnclearError,
    Value,
    added,
    length,
    matrix_product,
    multiplied,
    size,
    unit_times,
)
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node

PARTICLES = 3
"""Of a sum over particles so many are taken."""

REGION = "∫"
"""The index of the particles of a body over which an integral is taken, and its letter's mark."""

NODES = 32
"""Places at which the integrand of an integral is taken."""


def _nodes() -> list[tuple[float, float]]:
    """Places x = −cos s between −1 and 1 with their weights, Gauss and Legendre's in s.

    So a root that vanishes at an end is as smooth as anything else.
    """
    places, weights = np.polynomial.legendre.leggauss(NODES)
    s = (places + 1) * np.pi / 2
    return [*zip((-np.cos(s)).tolist(), (weights * np.sin(s) * np.pi / 2).tolist(), strict=True)]


_NODES = _nodes()

_MOST_RATES = 3
"""The rates of a letter that is held are put in again up to this order, less one."""

DEEPEST = 40
"""Definitions are not put into definitions deeper."""


@dataclass(frozen=True, slots=True)
class Meant(Node):
    """An expression in place of a formula: what was solved for a letter."""

    value: Value


@dataclass
class Memory:
    """What letters stood for when they were last asked, with what that rested on."""

    values: dict[object, tuple[Value, frozenset[int], dict[Letter, Definition | None]]] = field(
        default_factory=dict
    )
    conserved: dict[object, bool] = field(default_factory=dict)


@dataclass
class Meaning:
    """What finds values in one context, and notes in `used` which statements they rest on.

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
    consulted: dict[Letter, Definition | None] = field(default_factory=dict)
    depth: int = 0

    @property
    def moving(self) -> frozenset[Letter]:
        return self.context.habits.moving

    def value(self, node: Node) -> Value:
        """Raises UnclearError."""
        if self.known is not None and id(node) in self.known:
            return self.known[id(node)]
        handler = _HANDLERS.get(type(node))
        if handler is None:
            raise UnclearError(f"{type(node).__name__.lower()} is not judged")
        return handler(self, node)

    def remembering(self, *nodes: Node) -> Meaning:
        """What has the values of these trees, and of all parts of them, at hand."""
        known: dict[int, Value] = {}
        for node in nodes:
            for part in reversed([*n.walked(node)]):
                try:
                    known[id(part)] = self.with_(known=known).value(part)
                except UnclearError:
                    continue
        return self.with_(known=known)

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

    def with_(self, **changes: object) -> Meaning:
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

    # --- letters ---------------------------------------------------------------------------------

    def letter(self, letter: Letter) -> Value:
        letter = self.named(letter)
        if letter in self.held:
            return self.free(letter)
        if letter in self.chosen:
            return self.with_(chosen={}).value(self.chosen[letter])
        definition = self.definition(letter)
        if definition is not None:
            return self._defined(letter, definition)
        if letter.base == "π" and not letter.sub and letter not in self.context.habits.own:
            return sympy.pi
        if letter == Letter("i") and letter not in self.context.habits.own:
            return sympy.I
        if letter == self.context.habits.running:
            return TIME
        places = self.context.habits.functions.get(letter)
        if places is not None and not self._is_time(places):
            return self._unknown(letter, places)
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

    def definition(self, letter: Letter) -> Definition | None:
        found = self.context.definitions.get(letter)
        self.consulted[letter] = found
        return found

    def index_of(self, letter: Letter) -> str:
        """The index of particles in its name, or that of a body in which it differs."""
        regions = sorted((x for x in self.bound if x.startswith(REGION)), reverse=True)
        if regions and letter.base in _SPREAD and letter.sub in {"", *"xyz123"}:
            marks = (x for x in regions if x == REGION or letter.mark.endswith(x[len(REGION) :]))
            return next(marks, "")
        return next((x for x in self.bound if letter.sub == x or letter.sub.endswith("," + x)), "")

    def free(self, letter: Letter, index: str = "") -> Value:
        """Numbers of its own for a letter, of one particle if it has an index."""
        index = index or self.index_of(letter)
        place = (self.bound[index],) if index else ()
        if index.startswith(REGION) and letter == DENSITY:
            return _part(MASS, *place) / _part(VOLUME, *place)
        if is_vector(letter):
            fixed = None if letter in self.moving else basis_of(letter)
            if fixed is not None:
                return fixed
            return ImmutableMatrix([symbol(Jet(letter, 0, (*place, k))) for k in range(3)])
        return symbol(Jet(letter, 0, place))

    def _defined(self, letter: Letter, definition: Definition) -> Value:
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

    def _unknown(self, letter: Letter, places: Sequence[Node]) -> Value:
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
                    value = self.letter(vector)
                    if isinstance(value, MatrixBase) and value.shape == (3, 1):
                        return value[names.index(letter.sub)]
        return None

    def _is_time(self, places: Sequence[Node]) -> bool:
        return list(places) == [self.context.habits.running]

    # --- functions and derivatives ---------------------------------------------------------------

    def call(self, node: n.Call) -> Value:
        function, places = node.function, node.places
        order = 0
        while isinstance(function, (n.Primed, n.Rate)):
            order += function.order
            function = function.of
        if not isinstance(function, Letter):
            raise UnclearError("a function that is no letter")
        if self._is_time(places):
            return self._differentiated(self.letter(function), order)
        definition = self.definition(function)
        usual = (definition.places if definition else ()) or self.context.habits.functions.get(
            function, ()
        )
        if len(places) == 1 and function in self.moving and places[0] != function:
            # x(0), where x is a function of the time
            return self._at_time(self._differentiated(self.letter(function), order), places[0])
        if definition is None:
            return self._slope(self._unknown(function, places), places, order)
        meaning = self._held_for(function) if order else self
        value = meaning._slope(meaning._form(function, usual), usual or places, order)
        value = self._released(value, meaning.held - self.held)
        for there, usually in zip(places, usual, strict=False):
            if there != usually:
                value = _put(value, self.scalar(usually), self.scalar(there))
        return value

    def _form(self, function: Letter, places: Sequence[Node]) -> Value:
        """What a function is, written in its places where a text has written it so.

        Of L = p²/2μr², which was found to be ½ p φ̇, that is the form for L(r).
        """
        definition, numbers = self.definition(function), {self.scalar(x) for x in places}
        assert definition is not None
        for node in (definition.node, *definition.also):
            value = self.value(node)
            if not isinstance(value, MatrixBase) and numbers <= value.free_symbols:
                return value
        return self.letter(function)

    def _differentiated(self, value: Value, order: int) -> Value:
        for _ in range(order):
            value = self.rate(value)
        return value

    def _slope(self, value: Value, places: Sequence[Node], order: int) -> Value:
        for _ in range(order):
            if len(places) != 1:
                raise UnclearError("a prime on a function of several letters")
            value = _by(value, self.scalar(places[0]))
        return value

    def _at_time(self, value: Value, place: Node) -> Value:
        time = self.scalar(place)
        instant = f"t={sympy.srepr(time)}"

        def there(x: Expr) -> Expr:
            return at_instant(x, instant, self.moving, time)

        return value.applyfunc(there) if isinstance(value, MatrixBase) else there(value)

    def primed(self, node: n.Primed) -> Value:
        of = n.ungrouped(node.of)
        if isinstance(of, n.Call):
            return self.call(n.Call(n.Primed(of.function, node.order), of.places))
        if isinstance(of, Letter):
            marked = replace(of, mark=of.mark + "′" * node.order)
            places = self.context.habits.functions.get(of, ())
            if places and not self._is_time(places):
                return self._slope(self._held_for(of).letter(of), places, node.order)
            if self.context.habits.primes_are_rates and of in self.moving:
                return self._differentiated(self.letter(of), node.order)
            return self.letter(marked)
        raise UnclearError("a prime on what is neither a letter nor a function")

    def derivative(self, node: n.Derivative) -> Value:
        of = n.ungrouped(node.of)
        value, meaning = self._to_differentiate(of, node.by)
        places = [meaning.scalar(x) for x in node.by]
        moving = not node.partial and all(self._is_motion(of, value, x) for x in places)
        for place in places:
            value = self.rate(value) / self.rate(place) if moving else _by(value, place)
        return self._released(value, meaning.held - self.held)

    def _is_motion(self, of: Node, value: Value, place: Expr) -> bool:
        """Whether a derivative is taken along the motion: d/dt, or dv/dx = v̇/ẋ.

        So is that of u = 1/r by φ, of which it is no function but along an orbit.
        """
        if place == TIME:
            return True
        jet = jet_of(place) if place.is_Symbol else None
        if jet is None or jet.order or jet.letter not in self.moving:
            return False
        if self._is_along(value, place):
            return True
        if isinstance(of, Letter):
            # That of a function, as dV/dx or dL/dθ, is taken with its rates held.
            found = jet_of(value) if getattr(value, "is_Symbol", False) else None
            return found is not None and (found.order > 0 or found.letter in self.moving)
        return any(isinstance(x, n.Rate) for x in n.walked(of))

    def _is_along(self, value: Value, place: Expr) -> bool:
        """Whether what moves is taken along the motion: u = 1/r by φ, which is not written in it.

        It is no function of φ but on an orbit, on which it is u̇/φ̇.
        """
        if isinstance(value, MatrixBase) or value.is_Symbol or value.has(TIME):
            return False
        found = jets(value)
        places = [jet for jet in found.values() if jet.letter in self.moving]
        return bool(places) and place not in found and not any(jet.order for jet in places)

    def _to_differentiate(self, of: Node, by: Sequence[Node]) -> tuple[Value, Meaning]:
        """A value in the letters by which it is differentiated, and with what is held for that."""
        meaning = self
        for x in by:
            bare = x.of if isinstance(x, n.Rate) else x
            if isinstance(bare, Letter):
                letter = self.named(bare)
                if self.definition(letter) is not None:
                    meaning = meaning.with_(held=meaning.held | {letter})
        if isinstance(of, Letter):
            meaning = meaning._held_for(of)
        elif not any(isinstance(x, n.Rate) for x in (*n.walked(of), *by)):
            momenta = {x for x in n.letters(of) if self.is_momentum(x)}
            meaning = meaning.with_(held=meaning.held | momenta)
        value = meaning.value(of)
        if (
            isinstance(of, Letter)
            and value == self.free(of)
            and not {of, *by} <= self.moving | {self.context.habits.running}
        ):
            raise UnclearError(f"nothing says what {of.base} is")
        return value, meaning

    def _held_for(self, function: Letter) -> Meaning:
        """Momenta that a function is written in stay what they are while it is differentiated."""
        definition = self.definition(self.named(function))
        chosen = self.chosen.get(function)
        if chosen is not None:  # it is written in these letters, whatever they stand for
            names = {x for x in n.letters(chosen) if self.definition(x) is not None}
            return self.with_(held=self.held | names)
        node = definition.node if definition else None
        if node is None or self._has_rates(node):
            return self
        places = definition.places if definition else ()
        alone = bool(places) and not self._is_time(places)  # it is a function of these alone
        kept = {x for x in n.letters(node) if self.is_momentum(x) or (alone and self._moves(x))}
        return self.with_(held=self.held | kept) if kept else self

    def _moves(self, letter: Letter) -> bool:
        """Whether it stands for something that has rates."""
        definition = self.definition(letter)
        if definition is None:
            return False
        if isinstance(definition.node, Meant):
            return any(jet.order for jet in jets(sympy.sympify(definition.node.value)).values())
        return any(isinstance(x, (n.Rate, n.Derivative)) for x in n.walked(definition.node))

    def _has_rates(self, node: Node) -> bool:
        if any(isinstance(x, n.Rate) for x in n.walked(node)):
            return True
        definitions = {x: self.definition(x) for x in n.letters(node)}
        return any(
            definition.node is not node and self._has_rates(definition.node)
            for x, definition in definitions.items()
            if definition is not None and not self.is_momentum(x) and self.depth < 8
        )

    def is_momentum(self, letter: Letter) -> bool:
        """Whether it stands for something that has rates, and is one number of the state itself."""
        component = letter.base == "L" and letter.sub != "" and not letter.bold
        return (component or letter.base in _MOMENTA) and self._moves(letter)

    def _released(self, value: Value, held: frozenset[Letter]) -> Value:
        """What was held, put in again, with its rates."""
        for letter in held:
            own, meant = self.free(letter), self.letter(letter)
            if isinstance(own, MatrixBase) or isinstance(meant, MatrixBase):
                continue
            for _ in range(_MOST_RATES if letter in self.moving else 1):
                value = _put(value, own, meant)
                own, meant = self.rate(own), self.rate(meant)
        return value

    # --- sums, integrals -------------------------------------------------------------------------

    def total(self, node: n.Total) -> Value:
        names = [x.base for x in node.index]
        spans = [self._span(node) for _ in names]
        terms = [self.value(node.of)] if not names else []
        if names:
            terms = [
                self.with_(bound={**self.bound, **dict(zip(names, places, strict=True))}).value(
                    node.of
                )
                for places in _places(spans)
            ]
        return added(terms) if node.sign == "Σ" else multiplied(terms)

    def _span(self, node: n.Total) -> range:
        if isinstance(node.upper, n.Number) and isinstance(node.lower, n.Number):
            first, last = int(node.lower.value), int(node.upper.value)
            if 0 <= last - first < 12:
                return range(first, last + 1)
            raise UnclearError("a sum over many terms")
        return range(PARTICLES)

    def integral(self, node: n.Integral) -> Value:
        if node.upper is None and _is_over_body(node):
            return self._over_body(node)
        if node.lower is None or node.upper is None or not isinstance(node.by, Letter):
            raise UnclearError("an integral without limits")
        time = node.by == self.context.habits.running
        kept = frozenset(x for x in n.letters(node.of) if self._is_kept(x)) - self.held
        meaning = self if time else self.with_(held=self.held | {node.by} | kept)
        x = TIME if time else meaning.free(node.by)
        integrand = meaning.scalar(node.of)
        if time and any(jet.letter in self.moving for jet in jets(integrand).values()):
            raise UnclearError("an integral over time of what is not given as a function of it")
        lower, upper = self.scalar(node.lower), self.scalar(node.upper)
        integrand = self._released(integrand, kept) if time else integrand
        if integrand.is_polynomial(x):
            value = sympy.integrate(sympy.expand(integrand), (x, lower, upper))
            return self._released(value, kept)
        middle, half = (lower + upper) / 2, (upper - lower) / 2
        terms = (w * integrand.xreplace({x: middle + half * p}) for p, w in _NODES)
        return self._released(half * sympy.Add(*terms), kept)

    def _is_kept(self, letter: Letter) -> bool:
        """Whether a letter stands for what is said not to change, whatever it is written in."""
        zero = (x.left for x in self.context.constraints if x.right == n.Number("0"))
        said = any(isinstance(x, n.Rate) and x.of == letter for x in zero)
        return said and self.definition(letter) is not None

    def _over_body(self, node: n.Integral) -> Value:
        """The sum over a few particles, each with a mass and a volume of its own."""
        of = n.ungrouped(node.by)
        mark = of.mark if isinstance(of, Letter) else "′" * isinstance(of, n.Primed)
        terms = []
        for k in range(PARTICLES):
            there = self.with_(bound={**self.bound, REGION + mark: k})
            size = _part(MASS if node.by == MASS else VOLUME, k)
            terms.append(multiplied([size, there.value(node.of)]))
        return added(terms)


_MOMENTA = frozenset("pPπJℓlDS")
MASS, VOLUME, DENSITY = Letter("m"), Letter("V"), Letter("ρ")
_SPREAD = frozenset("rxyzvρ")
"""Letters of places, velocities and densities, which differ within a body."""


def _is_over_body(node: n.Integral) -> bool:
    """Whether an integral is over places in space, and not over a pressure as in ∫ p dV."""
    letters = n.letters(node.of)
    local = not letters or any(x.base in _SPREAD for x in letters)
    return node.dimension == 3 or node.by == MASS or (node.by in (VOLUME, Letter("τ")) and local)


def _part(of: Letter, particle: int) -> Symbol:
    """The mass or the volume of one particle of a body."""
    return Symbol(f"part {of.base} {particle}", real=True)


def particles(names: frozenset[str], *sides: Node, most: int = PARTICLES) -> list[dict[str, int]]:
    """Which particle each index is that stands outside of all sums, for all cases."""
    bound: list[dict[str, int]] = [{}]
    if not names:
        return bound
    for index in sorted({x for side in sides for x in _free_indices(side, names)}):
        bound = [{**each, index: k} for each in bound for k in range(most)]
    return bound


def _free_indices(node: Node, names: frozenset[str]) -> set[str]:
    if isinstance(node, n.Total):
        inner = {x for part in n.parts(node) for x in _free_indices(part, names)}
        return inner - {x.base for x in node.index}
    if isinstance(node, Letter):
        return {x for x in names if node.sub == x or node.sub.endswith("," + x)}
    return {x for part in n.parts(node) for x in _free_indices(part, names)}


# --- one handler a kind of node ------------------------------------------------------------------


def _number(_: Meaning, node: n.Number) -> Expr:
    value: Fraction = node.value
    return Rational(value.numerator, value.denominator)


def _power(meaning: Meaning, node: n.Power) -> Value:
    e = Letter("e")
    if node.base == e and e not in meaning.context.habits.own:
        return sympy.exp(meaning.scalar(node.exponent))
    base = meaning.value(node.base)
    exponent = meaning.scalar(node.exponent)
    if isinstance(base, MatrixBase):
        if base.shape[1] == 1:
            if exponent.is_Integer and exponent.is_even and exponent > 0:
                return base.dot(base) ** (exponent / 2)
            raise UnclearError("a power of a vector")
        if not exponent.is_Integer or base.rows != base.cols:
            raise UnclearError("a power of a matrix")
    return base**exponent


def _apply(meaning: Meaning, node: n.Apply) -> Value:
    of = meaning.value(node.of)
    if node.name in ("det", "tr"):
        if not isinstance(of, MatrixBase):
            raise UnclearError(f"{node.name} of what is no matrix")
        return of.det(method="berkowitz") if node.name == "det" else of.trace()
    function = _NAMED.get(node.name)
    if function is None or isinstance(of, MatrixBase):
        raise UnclearError(f"{node.name} is not judged")
    return function(of)


def _dot(meaning: Meaning, node: n.Dot) -> Value:
    left, right = meaning.value(node.left), meaning.value(node.right)
    if isinstance(left, MatrixBase) and isinstance(right, MatrixBase):
        if left.shape == right.shape and left.shape[1] == 1:
            return left.dot(right)
        return matrix_product(left, right)
    return left * right


def _cross(meaning: Meaning, node: n.Cross) -> Value:
    left, right = meaning.value(node.left), meaning.value(node.right)
    vectors = isinstance(left, MatrixBase), isinstance(right, MatrixBase)
    if not any(vectors):
        if n.letters(node.left) & n.letters(node.right):
            # Nobody writes a number times itself with ×: these are vectors that nothing names so.
            raise UnclearError("× between what are no vectors of three components")
        return left * right
    if not all(vectors) or left.shape != (3, 1) or right.shape != (3, 1):
        if left == 0 or right == 0:
            return sympy.zeros(3, 1)
        raise UnclearError("× between what are no vectors of three components")
    return left.cross(right)


def _quotient(meaning: Meaning, node: n.Quotient) -> Value:
    under = meaning.scalar(node.under)
    if under == 0:
        raise UnclearError("a division by zero")
    return meaning.value(node.over) / under


def _matrix(meaning: Meaning, node: n.Matrix) -> Value:
    if node.bracket == "|" and len(node.rows) > 1:
        return _determinant(meaning, node)
    made = ImmutableMatrix([[meaning.scalar(x) for x in row] for row in node.rows])
    return _in_space(meaning, made)


def _determinant(meaning: Meaning, node: n.Matrix) -> Value:
    """Along the first row, in which vectors may stand, as in a cross product."""
    first, *rows = node.rows
    if any(len(row) != len(node.rows) for row in node.rows):
        raise UnclearError("a determinant that is not square")
    below = ImmutableMatrix([[meaning.scalar(x) for x in row] for row in rows])
    terms = []
    for k, each in enumerate(first):
        rest = below.extract([*range(len(rows))], [j for j in range(len(first)) if j != k])
        terms.append((-1) ** k * rest.det() * meaning.value(each))
    return added(terms)


def _column(meaning: Meaning, node: n.Tuple) -> Value:
    if is_bracket(node):
        value = _poisson(meaning, *node.entries)
        if value is not None:
            return value
    return _in_space(meaning, ImmutableMatrix([meaning.scalar(x) for x in node.entries]))


def _poisson(meaning: Meaning, one: Node, other: Node) -> Expr | None:
    """The bracket of two functions, in their letters as they stand or in what these stand for."""
    names = meaning.context.letters
    momenta = frozenset(x for pair in conjugates(names) for x in pair)
    for inner in (meaning.with_(held=meaning.held | momenta), meaning):
        value = bracket(inner.scalar(one), inner.scalar(other), names)
        if value is not None:
            return meaning.context.brackets * value
    return None


def _in_space(meaning: Meaning, made: MatrixBase) -> Value:
    """Components in space of a vector, or a tensor, that is written in the axes that are meant."""
    basis = meaning.context.basis
    if basis is None or made.shape not in ((3, 1), (3, 3)):
        return made
    return ImmutableMatrix(basis * made if made.shape == (3, 1) else basis * made * basis.T)


def _transposed(meaning: Meaning, node: n.Transposed) -> Value:
    value = meaning.value(node.of)
    if isinstance(n.ungrouped(node.of), n.Tuple):
        return value  # a row with commas that is turned is the column that we make of it anyway
    return value.T if isinstance(value, MatrixBase) else value


def _taken(meaning: Meaning, node: n.Component) -> Value:
    value = meaning.value(node.of)
    names = "123" if node.index in "123" else "xyz"
    if not isinstance(value, MatrixBase) or node.index not in names:
        raise UnclearError("a component of what is no vector")
    basis = meaning.context.basis
    value = value if basis is None or value.shape != (3, 1) else basis.T * value
    return value[names.index(node.index)]


def _rate_of(meaning: Meaning, node: n.Rate) -> Value:
    if node.frame and not node.frame.startswith(("space", "inertial", "fixed")):
        if not node.frame.startswith(("body", "rot")):
            raise UnclearError(f"a rate seen from {node.frame}")
        vector = meaning.value(node.of)
        turning = meaning.value(Letter("ω", bold=True))
        if not isinstance(vector, MatrixBase) or vector.shape != (3, 1):
            raise UnclearError(f"a rate seen from {node.frame} of what is no vector")
        for _ in range(node.order):
            vector = meaning.rate(vector) - turning.cross(vector)
        return vector
    return meaning._differentiated(meaning.value(node.of), node.order)


def _at(meaning: Meaning, node: n.At) -> Value:
    value = meaning.value(node.of)
    if node.letter is None or node.value is None:
        raise UnclearError("a value at a place that is no equation")
    if node.letter == meaning.context.habits.running:
        return meaning._at_time(value, node.value)
    if node.letter in meaning.moving and any(jet.order for jet in jets(value).values()):
        raise UnclearError(f"a rate where {node.letter.base} has a value")
    return _put(value, meaning.scalar(node.letter), meaning.scalar(node.value))


def _gradient(meaning: Meaning, node: n.Nabla) -> Value:
    """∇f as a column of slopes, where f is written in x, y and z."""
    places = [Letter(x) for x in "xyz"]
    if node.product or any(meaning.definition(x) is not None for x in places):
        raise UnclearError("this ∇ is not judged")
    value = meaning.scalar(node.of)
    numbers = [meaning.free(x) for x in places]
    if not value.free_symbols & {*numbers}:
        raise UnclearError("∇ of what is not written in x, y and z")
    return ImmutableMatrix([value.diff(x) for x in numbers])


def _unit(_: Meaning, node: n.Unit) -> Expr:
    known = UNITS.get(node.name)
    if known is None:
        raise UnclearError(f"the unit {node.name} is not known")
    factor, powers = known
    return factor * sympy.Mul(*(Symbol(f"unit {x}", positive=True) ** p for x, p in powers.items()))


def _product(meaning: Meaning, node: n.Product) -> Value:
    for first, behind in pairwise(node.factors):
        own = meaning.context.habits.own | meaning.context.definitions.keys()
        varied = first == Letter("δ") and first not in own
        if varied and isinstance(behind, (Letter, n.Rate)):
            raise UnclearError("a variation, δ before a letter, is not judged")
    return multiplied([meaning.value(x) for x in node.factors])


def _grouped(meaning: Meaning, node: n.Group) -> Value:
    if node.bracket == "[" and isinstance(node.of, Letter):
        raise UnclearError("a dimension, a letter in square brackets, is not judged")
    return meaning.value(node.of)


def _sum(meaning: Meaning, node: n.Sum) -> Value:
    values = [meaning.value(x) for x in node.terms]
    square = next((x for x in values if isinstance(x, MatrixBase) and x.rows == x.cols > 1), None)
    if square is not None:
        values = [unit_times(_without_unit(meaning, x), square) for x in values]
    return added(values)


def _without_unit(meaning: Meaning, value: Value) -> Value:
    """A number without the letter of the unit matrix, where nothing else is said of that."""
    if isinstance(value, MatrixBase):
        return value
    free = (x for x in (Letter("E"), Letter("I"), Letter("𝟙")) if meaning.definition(x) is None)
    for x in (symbol(Jet(letter)) for letter in free):
        slope = value.diff(x)
        if slope != 0 and sympy.expand(slope * x - value) == 0:
            return slope
    return value


def _average(meaning: Meaning, node: n.Average) -> Value:
    """The mean of a letter is a number of its own; those of sums and of multiples come from it."""
    match n.ungrouped(node.of):
        case Letter() as letter if not is_vector(letter):
            return symbol(Jet(replace(letter, mark="bar")))
        case n.Sum(terms):
            return added([_average(meaning, n.Average(x)) for x in terms])
        case n.Negative(of):
            return -_average(meaning, n.Average(of))
        case n.Product(factors):
            moving = meaning.context.habits.moving | meaning.context.definitions.keys()
            still = [x for x in factors if not n.letters(x) & moving]
            rest = tuple(x for x in factors if x not in still)
            if still and rest:
                mean = n.Average(rest[0] if len(rest) == 1 else n.Product(rest))
                return multiplied([*map(meaning.value, still), _average(meaning, mean)])
    raise UnclearError("an average of what is no letter is not judged")


def _sign(meaning: Meaning, node: n.PlusMinus) -> Value:
    return (-meaning.sign if node.inverted else meaning.sign) * meaning.value(node.of)


_HANDLERS: dict[type[Node], Callable[[Meaning, Any], Value]] = {
    Letter: Meaning.letter,
    n.Number: _number,
    n.Unit: _unit,
    n.Sum: _sum,
    n.Negative: lambda m, node: -m.value(node.of),
    n.PlusMinus: _sign,
    n.Product: _product,
    n.Quotient: _quotient,
    n.Power: _power,
    n.Root: lambda m, node: m.scalar(node.of) ** Rational(1, node.degree),
    n.Apply: _apply,
    n.Call: Meaning.call,
    n.Group: _grouped,
    n.Braced: lambda m, node: m.value(node.of),
    n.Average: _average,
    n.Absolute: lambda m, node: length(m.value(node.of)),
    n.Rate: _rate_of,
    n.Primed: Meaning.primed,
    n.Derivative: Meaning.derivative,
    n.Dot: _dot,
    n.Cross: _cross,
    n.Tuple: _column,
    n.Matrix: _matrix,
    n.Transposed: _transposed,
    n.Component: _taken,
    n.Integral: Meaning.integral,
    n.Total: Meaning.total,
    n.At: _at,
    n.Nabla: _gradient,
    Meant: lambda _, node: node.value,
}

_NAMED = {
    name: getattr(sympy, name)
    for name in [
        "sin",
        "cos",
        "tan",
        "cot",
        "sec",
        "csc",
        "sinh",
        "cosh",
        "tanh",
        "coth",
        "exp",
        "asin",
        "acos",
        "atan",
        "asinh",
    ]
} | {
    "ln": sympy.log,
    "log": sympy.log,
    "arcsin": sympy.asin,
    "arccos": sympy.acos,
    "arctan": sympy.atan,
    "arccot": sympy.acot,
    "arsinh": sympy.asinh,
    "arcosh": sympy.acosh,
    "artanh": sympy.atanh,
    "Re": sympy.re,
    "Im": sympy.im,
    "sgn": sympy.sign,
}


def _by(value: Value, place: Expr) -> Value:
    if not (place.is_Symbol and (place == TIME or jet_of(place) is not None)):
        raise UnclearError("a derivative by what is no free letter")
    return value.diff(place)


def _put(value: Value, old: Expr, new: Expr) -> Value:
    if not old.is_Symbol:
        raise UnclearError("a function at another place")
    return value.subs(old, new)


def _places(spans: Sequence[range]) -> list[tuple[int, ...]]:
    made: list[tuple[int, ...]] = [()]
    for span in spans:
        made = [(*each, k) for each in made for k in span]
    return made
