"""What the lines of a file say: what letters stand for, how they move, what is set."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from typing import Any

import sympy
from sympy import Expr, Function, Mul, Symbol

from rigidtop.mark.law import TIME, Law, accent, bare, base, dots, dotted
from rigidtop.notation.convention import own
from rigidtop.proof import equation as eq
from rigidtop.proof.equation import Equation, NoMeaningError
from rigidtop.read.formula import kind
from rigidtop.theory import lagrangian
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.symbols import Glyph, const
from rigidtop.typeset.text import text

LAGRANGIANS = frozenset({"L", "ℒ"})

ENERGIES = frozenset({"H", "ℋ"})

MOST_OF_LAW = 1000
"""Equations of motion with more operations are not judged by: SymPy would work for minutes."""

NAMES: Mapping[Any, str] = {
    eq.SumOver: "a sum",
    eq.SumFrom: "a sum",
    eq.Integrated: "an integral",
    eq.IntegralOver: "an integral",
    eq.VolumeIntegral: "an integral",
    eq.Cross: "a vector product",
    eq.Evaluated: "a value at a place",
    eq.Matrices: "a product of matrices",
}


@dataclass(frozen=True)
class Given:
    """What a letter stands for, and the lines that say so."""

    value: Expr
    rests: frozenset[int]
    section: int
    stated: bool = True
    """Whether it is said, rather than the rate of what is said."""
    side: Expr | None = None
    """As it was written, where the letter itself is said."""


@dataclass
class Ledger:
    """Takes one line after the other, and keeps what they say."""

    moves: Mapping[int, frozenset[Symbol]]
    """The letters that change in time, under each heading."""
    functions: Mapping[Symbol, tuple[Symbol, ...]]
    kinds: Callable[[Glyph], str] = lambda _: ""
    """The quantity that the file's words say a letter is."""
    twins: Mapping[int, Equation] = field(default_factory=dict)
    """Of a line that ± makes, by its number, the other one."""
    given: dict[Symbol, Given] = field(default_factory=dict)
    law: Law | None = None
    other: Law | None = None
    """That of another form of ℒ which contradicts it: which of them is meant is open."""
    sets: dict[Symbol, Given] = field(default_factory=dict)
    """What is set for a special motion: θ̇ by 0, φ̇ by Ω."""
    signs: dict[Symbol, Lettered] = field(default_factory=dict)
    """What stands in values for the sign, 1 or −1, of a letter that is known by its square."""
    at_places: set[Symbol] = field(default_factory=set)
    """Letters of functions, as V in V(x): V′(x) is then its slope."""
    equations: Sequence[Equation | None] = ()
    accelerated: set[Symbol] = field(default_factory=set)
    """The letters with an acceleration somewhere."""
    special: frozenset[int] = frozenset()
    """Lines that stand in a sentence with “if”, by their numbers."""
    section: int = 0
    used: set[int] = field(default_factory=set)
    doubted: set[int] = field(default_factory=set)
    """Lines that say what a letter stands for which is said to be another value below."""
    places: dict[int, int] = field(default_factory=dict)
    """The section of each line."""
    paths: dict[int, tuple[int, ...]] = field(default_factory=dict)
    """Where each line lies among the cases of the file, its heading first."""
    path: tuple[int, ...] = ()
    """Where the line lies which is taken."""

    def holds(self, section: int, rests: Iterable[int]) -> bool:
        """Whether what lines say is of this case: they stand under this heading, and in no item or
        part of an exercise that ends before."""
        of = [self.paths.get(x, ()) for x in rests]
        return section == self.section and all(len(x) < 2 or self.path[: len(x)] == x for x in of)

    @property
    def moving(self) -> frozenset[Symbol]:
        along = self.law.q if self.law is not None else ()
        return self.moves.get(self.section, frozenset()) | {*along}

    def give(
        self, letter: Lettered, value: Expr, rests: frozenset[int], side: Expr | None = None
    ) -> None:
        """A letter that changes in time gives its rates too."""
        times = 3 if letter in self.moving else 1
        meant = {letter: value}
        if times > 1 and value.free_symbols and not value.is_Symbol and self.total(value) == 0:
            # T of ½mv² changes, and nothing says which of the letters there does.
            times = 1
        with suppress(NoMeaningError):  # of F = mẍ two rates are no letters
            for k in range(1, times):
                last = dotted(letter, k - 1) if k > 1 else letter
                meant[dotted(letter, k)] = self.total(meant[last])
        coordinates = {*self.law.q} if self.law is not None else set()
        turned = {bare(x) for x in value.free_symbols} & self.moving - coordinates
        for other, known in self.given.items():
            if known.section == self.section and known.value.free_symbols & {*meant}:
                new = known.value.subs(meant, simultaneous=True)
                self.given[other] = replace(known, value=new, rests=known.rests | rests)
                # ω = ẋ/r behind ℒ says what ℒ is, and r = r₀ + ρ; r = r(φ) of an orbit is no
                # constraint.
                if base(other) in LAGRANGIANS and (letter not in coordinates or turned):
                    self.law = self.of_lagrangian(other) or self.law
                elif base(other) in LAGRANGIANS and self.law is not None:
                    # x = Rθ may be kept by a force.
                    made, kept = self.of_lagrangian(other), f"{text(letter)} = {text(value)}"
                    kept += " is kept by forces that do no work"
                    if made is not None or not value.has(TIME):
                        self.law = replace(self.law, broken=True)
                        self.other = replace(made, condition=kept) if made is not None else None
        for x, known_value in meant.items():
            rate = x != letter
            self.given[x] = Given(known_value, rests, self.section, side=None if rate else side)

    def of_lagrangian(self, letter: Lettered) -> Law | None:
        known = self.given[letter]
        value = known.value
        rates = [x for x in value.free_symbols if accent(x) == "dot"]
        q = tuple(sorted((bare(x) for x in rates), key=str))
        if not q or any(accent(x) == "ddot" for x in value.free_symbols):
            return None
        v = [dotted(x) for x in q]
        named = self.kinds(letter.quantity.glyph)
        linear = all(value.diff(x, y) == 0 for x in v for y in v)
        if named not in ("", "the Lagrangian") or (linear and not named):
            return None
        vanishing = [self.total(value.diff(y)) - value.diff(x) for x, y in zip(q, v, strict=True)]
        expanded = tuple(sympy.expand(x) for x in vanishing)
        if sympy.count_ops(expanded) > MOST_OF_LAW:
            return None
        return Law(q, expanded, known.rests, "by Lagrange's equations", known.section, value)

    def bare(self, side: Expr) -> Expr:
        """A side in its own letters, nothing put in."""
        return Ledger({0: self.moving}, {}).value(side)

    def by_law(self, letter: Expr) -> Expr | None:
        """A momentum p_θ, or H, where ℒ says what it is."""
        if self.law is None or self.law.lagrangian is None or not isinstance(letter, Lettered):
            return None
        glyph, L = letter.quantity.glyph, self.law.lagrangian
        v = [dotted(x) for x in self.law.q]
        if glyph.accent or letter in self.given:
            return None
        if glyph.base == "p" and glyph.sub:
            for q, rate in zip(self.law.q, v, strict=True):
                named = q.quantity.glyph
                if glyph.sub in (named.base + named.sub, f"{named.base}_{named.sub}"):
                    return sympy.sympify(L.diff(rate))
        if glyph.base in ENERGIES and not glyph.sub:
            return lagrangian.energy(L, v)
        return None

    def value(self, node: Expr) -> Expr:
        """A tree with all that is given put in.  Raises NoMeaningError."""
        node = sympy.sympify(node)
        if isinstance(node, sympy.MatrixBase):
            raise NoMeaningError("components of a vector are not judged by the file alone")
        if isinstance(node, Symbol):
            return self.letter(node)
        if not node.args:
            return node
        if isinstance(node, (eq.Group, eq.Underbrace)):
            return self.value(node.args[0])
        if isinstance(node, eq.Rate):
            if len(node.args) > 1:
                raise NoMeaningError("a rate as seen from a frame is not judged by the file alone")
            return self.total(self.value(node.args[0]))
        if isinstance(node, (eq.Partial, eq.Slope)):
            return self.slope(node)
        if isinstance(node, eq.At):
            return self.at(node)
        if isinstance(node, eq.Dot):
            return Mul(*map(self.value, node.args))
        if isinstance(node, eq.Printed):
            raise NoMeaningError(f"{NAMES.get(type(node), 'what stands here')} is not judged")
        return node.func(*map(self.value, node.args))

    def letter(self, node: Symbol) -> Expr:
        if node == const:
            raise NoMeaningError("a constant stands in an expression")
        if kind(node) != "scalar":
            raise NoMeaningError("vectors are not judged by the file alone")
        if isinstance(node, Lettered) and node.quantity.glyph.base == "…":
            raise NoMeaningError("what is left out with dots is not known")
        known = self.given.get(node)
        if known is not None:
            self.used |= known.rests
            return known.value
        law = self.by_law(node)
        rate = self.by_law(bare(node)) if accent(node) == "dot" else None
        if self.law is not None and (law is not None or rate is not None):
            self.used |= self.law.rests
            return law if law is not None else self.total(rate)
        if node in self.functions:
            return Function(node.name, real=True)(*self.functions[node])
        return node

    def slope(self, node: Expr) -> Expr:
        of, *by = node.args
        value = self.value(of)
        of = of.args[0] if isinstance(of, eq.At) else of
        if isinstance(of, Symbol) and value == of:
            raise NoMeaningError(f"nothing above says what {text(of)} is")
        momenta = self.momenta()
        if len(by) == 1 and self.by_law(of) is not None and base(of) in ENERGIES:
            return self.of_hamiltonian(by[0], momenta)
        if base(of) not in LAGRANGIANS and all(accent(x) != "dot" for x in by):
            held = self.without(momenta)
            if any(x in momenta or self.by_law(x) for x in held.value(of).free_symbols):
                return self.value(held.slope(node))
        for x in by:
            if not isinstance(x, Lettered) or x in self.given:
                raise NoMeaningError("a derivative by what is no free letter")
            others = {bare(y) for y in value.free_symbols} & self.moving - {bare(x)}
            if isinstance(node, eq.Slope) and (others or x == TIME):
                value = self.total(value)
                if x != TIME:
                    raise NoMeaningError(f"d/d{text(x)} of what other letters change is not judged")
            else:
                value = value.diff(x)
        return value

    def momenta(self) -> dict[Symbol, Expr]:
        """The letters of which is said that they are momenta ∂ℒ/∂q̇, and the q̇ of each."""
        if self.law is None or self.law.lagrangian is None:
            return {}
        rates = {self.law.lagrangian.diff(dotted(q)).expand(): dotted(q) for q in self.law.q}
        values = {x: g.value.expand() for x, g in self.given.items() if not accent(x)}
        return {x: rates[value] for x, value in values.items() if value in rates}

    def without(self, letters: Iterable[Symbol]) -> Ledger:
        """What is said, where letters are left as they are written: held as others change."""
        made = Ledger(self.moves, self.functions, section=self.section)
        for x, known in self.given.items():
            said = isinstance(x, Lettered) and base(x) not in LAGRANGIANS and x not in letters
            if said and known.side is not None:
                made.give(x, made.value(known.side), known.rests, known.side)
        return made

    def of_hamiltonian(self, by: Symbol, momenta: Mapping[Symbol, Expr]) -> Expr:
        """∂ℋ/∂p = q̇, and ∂ℋ/∂q = −∂ℒ/∂q: the momenta are held in one, the rates in the other."""
        law = self.law
        assert law is not None
        assert law.lagrangian is not None
        found, slopes = self.by_law(by), {law.lagrangian.diff(dotted(q)): q for q in law.q}
        if by in momenta:
            return momenta[by]
        if found in slopes:
            return dotted(slopes[found])
        if by in law.q:
            return -law.lagrangian.diff(by)
        raise NoMeaningError("a derivative of H by what is neither a coordinate nor a momentum")

    def at(self, node: Expr) -> Expr:
        letter, *places = node.args
        if letter in self.given:
            if all(isinstance(x, Lettered) for x in places):
                return self.letter(letter)
            raise NoMeaningError(f"{text(letter)} at another place is not judged")
        at = [*map(self.value, places)]
        glyph = letter.quantity.glyph if isinstance(letter, Lettered) else Glyph("")
        of = own(replace(glyph, prime=False))
        if glyph.prime and len(at) == 1 and isinstance(at[0], Symbol) and of in self.at_places:
            return Function(of.name, real=True)(*at).diff(*at)
        self.at_places.add(letter)
        return Function(letter.name, real=True)(*at)

    def total(self, value: Expr) -> Expr:
        """d/dt."""
        made: Any = value.diff(TIME)
        for x in value.free_symbols:
            if x in self.moving or dots(x):
                made += value.diff(x) * dotted(x)
        return made

    def letters_of(self, rests: set[int]) -> set[Symbol]:
        """What stands in the values that were put in."""
        values = [g.value for g in self.given.values() if g.rests & rests and g.rests <= rests]
        return {bare(x) for value in values for x in value.free_symbols}

    def primitive(self) -> set[Symbol]:
        """The letters that stand in what is defined, and in the law."""
        values = [g.value for g in self.given.values() if g.section == self.section]
        made = {bare(x) for value in values for x in value.free_symbols}
        return made | (set(self.law.letters) if self.law is not None else set())

    def is_initial(self, left: Symbol, value: Expr) -> bool:
        """ẏ = v₀ cos θ, where ÿ stands elsewhere: it need not stay so."""
        changes = {x for x in self.moving if x.quantity.glyph.sub != "0"} | {TIME}
        stays = not {bare(x) for x in value.free_symbols} & changes
        return accent(left) == "dot" and bare(left) in self.accelerated and stays

    def is_set(self, left: Lettered, right: Expr) -> bool:
        """θ̇ = 0, φ̇ = Ω, l₁ = l: a letter of the motion, or a number, and what does not change."""
        accent = left.quantity.glyph.accent
        if left in self.given or accent not in ("", "dot", "ddot"):
            return False
        if bare(left) not in self.primitive():
            return False
        value = self.value(right)
        law = self.law
        if accent == "ddot" and law is not None and value and value.free_symbols <= law.letters:
            return False  # it is what the law says, or wrong
        moves = {bare(x) for x in value.free_symbols} & self.moving
        return (value.is_Symbol or value.is_number) and not moves
