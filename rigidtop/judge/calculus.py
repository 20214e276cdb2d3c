"""What is done with letters: functions at places, derivatives, sums and integrals."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Self

import sympy
from sympy import Expr, MatrixBase

from rigidtop.judge import quadrature, series
from rigidtop.judge.context import START
from rigidtop.judge.jets import TIME, at_instant, jet_of, jets, symbols, time_at
from rigidtop.judge.letters import INFINITY, MOMENTA
from rigidtop.judge.particles import MASS, PARTICLES, REGION, VOLUME, is_over_body, part, tuples
from rigidtop.judge.values import UnclearError, Value, added, multiplied, scaled
from rigidtop.judge.vocabulary import Meant, Vocabulary
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node

GAMMA = Letter("Γ")
"""Of a number it is the gamma function."""

DIGITS = 40
"""So many digits a value of a function has that has no other form."""

_MOST_RATES = 3
"""The rates of a letter that is held are put in again up to this order, less one."""


@dataclass
class Calculus(Vocabulary):
    """What finds the values of functions, derivatives, sums and integrals in one context."""

    # --- functions and derivatives ---------------------------------------------------------------

    def call(self, node: n.Call) -> Value:
        function, places = node.function, node.places
        order, dots = 0, 0
        while isinstance(function, (n.Primed, n.TimeDerivative)):
            order += function.order
            dots += function.order * isinstance(function, n.TimeDerivative)
            function = function.of
        if not isinstance(function, Letter):
            raise UnclearError("a function that is no letter")
        if self.is_time(places):
            return self.differentiated(self.letter(function), order)
        passed = self._passed(function, places)
        if passed is not None:
            value = self.differentiated(self.letter(function), dots)
            place, instant = passed
            value = self._along(value, place, order - dots)
            return self._then(value, instant, time_at(instant))
        definition = self.definition(function)
        usual = (definition.places if definition else ()) or self.context.habits.functions.get(
            function, ()
        )
        timed = function in self.moving or self._is_timed(function, places)
        if timed and len(places) == 1 and places[0] in self.moving and order == dots:
            # y(x), where both move: the path; and ẏ(x), its speed there
            return self.differentiated(self.letter(function), order)
        if len(places) == 1 and timed and places[0] != function:
            # x(0), where x is a function of the time
            return self.at_time(self.differentiated(self.letter(function), order), places[0])
        if function == GAMMA and definition is None and not any(map(n.letters, places)):
            factorial = sympy.gamma(self.scalar(places[0]))
            return factorial.evalf(DIGITS) if factorial.has(sympy.gamma) else factorial
        if definition is None:
            return self._slope(self.unknown(function, places), places, order)
        meaning = self._held_for(function) if order or places != usual else self
        value = meaning._slope(meaning._form(function, usual), usual or places, order)
        for there, usually in zip(places, usual, strict=False):
            if there != usually:
                value = put(value, self.scalar(usually), self.scalar(there))
        return self._released(value, meaning.held - self.held)

    def _passed(self, function: Letter, places: Sequence[Node]) -> tuple[Letter, str] | None:
        """The coordinate that is at the place of X(θ₀) at some instant, and that; None if none."""
        definition = self.definition(function)
        varies = function in self.moving or (definition and self._has_rates(definition.node))
        for each in self.context.constraints:
            left = each.left
            if varies and each.instant and isinstance(left, Letter) and (each.right,) == places:
                return left, each.instant
        return None

    def _along(self, value: Value, place: Letter, order: int) -> Value:
        """The slope of what has rates, along the motion: F′(θ) is Ḟ/θ̇."""
        for _ in range(order):
            value = scaled(self.rate(value), 1 / self.rate(self.scalar(place)))
        return value

    def _is_timed(self, function: Letter, places: Sequence[Node]) -> bool:
        """Whether a function is given in time, and its place is none of its letters: v(τ)."""
        definition = self.definition(function)
        if definition is None or definition.places:
            return False
        value = self.letter(function)
        own = n.letters(definition.node)
        return value.has(TIME) and not any(own & n.letters(place) for place in places)

    def _form(self, function: Letter, places: Sequence[Node]) -> Value:
        """What a function is: of its forms, as V = ½ k x² = ½ k (l − s)², the one in its places."""
        definition, numbers = self.definition(function), {self.scalar(x) for x in places}
        assert definition is not None
        for node in (definition.node, *definition.also):
            value = self.value(node)
            if not isinstance(value, MatrixBase) and numbers <= value.free_symbols:
                return value
        return self.letter(function)

    def differentiated(self, value: Value, order: int) -> Value:
        """The rate of a value, of some order."""
        for _ in range(order):
            value = self.rate(value)
        return value

    def _slope(self, value: Value, places: Sequence[Node], order: int) -> Value:
        for _ in range(order):
            if len(places) != 1:
                raise UnclearError("a prime on a function of several letters")
            value = _by(value, self.scalar(places[0]))
        return value

    def at_time(self, value: Value, place: Node) -> Value:
        """What a value is at a time, as x(0) is."""
        time = self.scalar(place)
        return self._then(value, START if time == 0 else f"t={sympy.srepr(time)}", time)

    def _then(self, value: Value, instant: str, time: Expr) -> Value:
        """What a value is at an instant."""

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
            if places and not self.is_time(places):
                return self._slope(self._held_for(of).letter(of), places, node.order)
            if self.context.habits.primes_are_rates and of in self.moving:
                return self.differentiated(self.letter(of), node.order)
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
        return any(isinstance(x, n.TimeDerivative) for x in n.walked(of))

    def _is_along(self, value: Value, place: Expr) -> bool:
        """Whether a value is written in places that move, and not in the one it is taken by.

        So is u = 1/r by φ: it is a function of φ on an orbit alone, where its slope is u̇/φ̇.
        """
        if isinstance(value, MatrixBase) or value.is_Symbol or value.has(TIME):
            return False
        found = jets(value)
        places = [jet for jet in found.values() if jet.letter in self.moving]
        return bool(places) and place not in found and not any(jet.order for jet in places)

    def _to_differentiate(self, of: Node, by: Sequence[Node]) -> tuple[Value, Self]:
        """A value in the letters by which it is differentiated, and with what is held for that."""
        meaning = self
        for x in by:
            bare = x.of if isinstance(x, n.TimeDerivative) else x
            if isinstance(bare, Letter):
                letter = self.named(bare)
                if self.definition(letter) is not None:
                    meaning = meaning.with_(held=meaning.held | {letter})
        if isinstance(of, Letter):
            meaning = meaning._held_for(of)
        elif not any(isinstance(x, n.TimeDerivative) for x in (*n.walked(of), *by)):
            momenta = {x for x in n.letters(of) if self.is_momentum(x)}
            meaning = meaning.with_(held=meaning.held | momenta)
        value = meaning.value(of)
        value = meaning._written_in(of, by, value)
        if (
            isinstance(of, Letter)
            and value == self.free(of)
            and not {of, *by} <= self.moving | {self.context.habits.running}
        ):
            raise UnclearError(f"nothing says what {of.base} is")
        return value, meaning

    def _written_in(self, of: Node, by: Sequence[Node], value: Value) -> Value:
        """A value, or another form of it, that has the letters by which it is differentiated."""
        definition = self.definition(of) if isinstance(of, Letter) else None
        names = {x for x in by if isinstance(x, Letter) and x in self.held}
        if definition is None or not names or isinstance(value, MatrixBase):
            return value
        missing = {self.free(x) for x in names} - symbols(value)
        forms = (x for x in definition.also if names <= n.letters(x))
        form = next(forms, None) if missing else None
        return value if form is None else self.scalar(form)

    def _held_for(self, function: Letter) -> Self:
        """Momenta that a function is written in stay what they are while it is differentiated."""
        definition = self.definition(self.named(function))
        chosen = self.chosen.get(function)
        if chosen is not None:  # it is written in these momenta, whatever they stand for
            names = {x for x in n.letters(chosen) if self._moves(x)}
            return self.with_(held=self.held | names)
        node = definition.node if definition else None
        places = definition.places if definition else ()
        places = places or self.context.habits.functions.get(function, ())
        alone = bool(places) and not self.is_time(places)  # it is a function of these alone
        if node is None or (self._has_rates(node) and not alone):
            return self
        kept = {x for x in n.letters(node) if self.is_momentum(x) or (alone and self._moves(x))}
        return self.with_(held=self.held | kept) if kept else self

    def _moves(self, letter: Letter) -> bool:
        """Whether it stands for something that has rates."""
        definition = self.definition(letter)
        if definition is None:
            return False
        if isinstance(definition.node, Meant):
            return any(jet.order for jet in jets(sympy.sympify(definition.node.value)).values())
        return any(
            isinstance(x, (n.TimeDerivative, n.Derivative)) for x in n.walked(definition.node)
        )

    def _has_rates(self, node: Node) -> bool:
        if any(isinstance(x, n.TimeDerivative) for x in n.walked(node)):
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
        return (component or letter.base in MOMENTA) and self._moves(letter)

    def _released(self, value: Value, held: frozenset[Letter]) -> Value:
        """What was held, put in again, with its rates."""
        for letter in held:
            own, meant = self.free(letter), self.letter(letter)
            if isinstance(own, MatrixBase) or isinstance(meant, MatrixBase):
                continue
            for _ in range(_MOST_RATES if letter in self.moving else 1):
                value = put(value, own, meant)
                own, meant = self.rate(own), self.rate(meant)
        return value

    # --- sums, integrals -------------------------------------------------------------------------

    def total(self, node: n.Total) -> Value:
        if series.is_of_numbers(node):
            if node.lower is None or node.upper is None:
                raise UnclearError("a sum that does not say from where to where")
            [index] = node.index
            term = self.with_(held=self.held | {index}).scalar(node.of)
            ends = self._end(node.lower), self._end(node.upper)
            return series.series(term, self.free(index), *ends, node.sign)
        names = [x.base for x in node.index]
        spans = [self._span(node) for _ in names]
        terms = [self.value(node.of)] if not names else []
        if names:
            terms = [
                self.with_(bound={**self.bound, **dict(zip(names, places, strict=True))}).value(
                    node.of
                )
                for places in tuples(spans)
            ]
        return added(terms) if node.sign == "Σ" else multiplied(terms)

    def _span(self, node: n.Total) -> range:
        if isinstance(node.upper, n.Number) and isinstance(node.lower, n.Number):
            first, last = int(node.lower.value), int(node.upper.value)
            if 0 <= last - first < 12:
                return range(first, last + 1)
            raise UnclearError("a sum over many terms")
        if node.upper == INFINITY:
            raise UnclearError("a sum without an end")
        return range(PARTICLES)

    def integral(self, node: n.Integral) -> Value:
        if node.upper is None and is_over_body(node):
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
        lower, upper = self._end(node.lower), self._end(node.upper)
        integrand = self._released(integrand, kept) if time else integrand
        if integrand.is_polynomial(x) and not {lower, upper} & {sympy.oo, -sympy.oo}:
            value = sympy.integrate(sympy.expand(integrand), (x, lower, upper))
            return self._released(value, kept)
        return self._released(quadrature.integral(integrand, x, lower, upper), kept)

    def _end(self, node: Node) -> Expr:
        """Where an integral or a sum ends; it may be infinity."""
        if node in (INFINITY, n.Negative(INFINITY)):
            return sympy.oo if node == INFINITY else -sympy.oo
        return self.scalar(node)

    def _is_kept(self, letter: Letter) -> bool:
        """Whether a letter stands for what is said not to change, whatever it is written in."""
        zero = (x.left for x in self.context.constraints if x.right == n.Number("0"))
        said = any(isinstance(x, n.TimeDerivative) and x.of == letter for x in zero)
        return said and self.definition(letter) is not None

    def _over_body(self, node: n.Integral) -> Value:
        """The sum over a few particles, each with a mass and a volume of its own."""
        of = n.ungrouped(node.by)
        mark = of.mark if isinstance(of, Letter) else "′" * isinstance(of, n.Primed)
        terms = []
        for k in range(PARTICLES):
            there = self.with_(bound={**self.bound, REGION + mark: k})
            size = part(MASS if node.by == MASS else VOLUME, k)
            terms.append(multiplied([size, there.value(node.of)]))
        return added(terms)


def _by(value: Value, place: Expr) -> Value:
    if not (place.is_Symbol and (place == TIME or jet_of(place) is not None)):
        raise UnclearError("a derivative by what is no free letter")
    return value.diff(place)


def put(value: Value, old: Expr, new: Expr) -> Value:
    """A value with another expression in place of a letter; raises UnclearError."""
    if not old.is_Symbol:
        raise UnclearError("a function at another place")
    return value.subs(old, new)
