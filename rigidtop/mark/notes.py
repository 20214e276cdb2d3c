"""Anyone's notes held against themselves: what each line says, and what the lines above say of it.

The file's own definitions are put in, and Lagrange's equations are taken from its own ℒ: a line
holds because of them, or contradicts them, with numbers.  What nothing above speaks of is taken as
it stands, and not called right.  So notes on a system of which nobody has heard are checked.

>>> from rigidtop.notation import OWN
>>> from rigidtop.read.formula import read
>>> text = (r"L = \\frac12 m\\dot x^2 - \\frac12 kx^2,\\quad m\\ddot x = -kx,\\quad m\\ddot x = kx")
>>> for each in held(read(text, OWN)):
...     print(each.verdict, each.note.partition(";")[0], sep=": ")
premise: the Lagrangian of the equations that follow
proved: by Lagrange's equations
false: at k = 1, m = 1, x = 2: ẍ is −2 by Lagrange's equations
"""

from __future__ import annotations

import math
import re
import time
from bisect import bisect_right
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise, product
from typing import Any

import sympy
from sympy import Add, Expr, Function, Integer, Mul, Pow, Rational, Symbol
from sympy.core.function import AppliedUndef

from rigidtop.notation import OWN
from rigidtop.notation.convention import own
from rigidtop.proof import decide
from rigidtop.proof import equation as eq
from rigidtop.proof.equation import Equation, NoMeaningError
from rigidtop.proof.verdict import Verdict
from rigidtop.read.document import Formula, each, numbered, places, states
from rigidtop.read.formula import Line, kind
from rigidtop.read.habits import Habits
from rigidtop.theory import lagrangian
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.symbols import Glyph, const
from rigidtop.theory.trig import reduce_ratio, reduce_trig
from rigidtop.typeset.text import text

PREMISE = "premise"
"""Said of what is taken as it stands: a law, a quantity of the file's own, a special motion."""

UNREAD = "unread"

MOST_OPERATIONS = 400
"""An expression has no more operations, or it is not judged."""

MOST_MISSING = 2
"""A line with accelerations that lacks more numbers of the law is of a special case."""

MOST_SOLVED = 3
"""Of more equations of motion at once it is not asked by what they are divided."""

MOST_SIGNS = 3
"""So many letters of a line may be known by their squares alone."""

TIME = own(Glyph("t"))
_LAGRANGIANS = frozenset({"L", "ℒ"})
_ENERGIES = frozenset({"H", "ℋ"})
_ANGLES = frozenset("θφψϕϑαβγχ")


@dataclass(frozen=True)
class Held:
    """What became of a line; `rests` are the numbers of the lines that it follows from."""

    line: Line
    verdict: str
    note: str = ""
    rests: tuple[int, ...] = ()

    @property
    def passed(self) -> bool | None:
        """None: it was not judged."""
        if self.verdict == PREMISE:
            return None
        return self.verdict in _HOLDS


_HOLDS = frozenset(v.value for v in (Verdict.PROVED, Verdict.SAMPLED, Verdict.ASSUMING))
_ORDER: tuple[str, ...] = (
    *(Verdict.PROVED, Verdict.SAMPLED, Verdict.ASSUMING, PREMISE),
    *(Verdict.UNDECIDED, Verdict.FALSE),
)


def held(
    lines: Iterable[Line],
    functions: Iterable[tuple[Glyph, str]] = (),
    timed: Iterable[Glyph] = (),
    sections: Sequence[int] = (),
    until: float = float("inf"),
    kinds: Callable[[Glyph], str] = lambda _: "",
) -> tuple[Held, ...]:
    """Each line that was read, judged by the lines above it.

    `functions`, `timed` and `kinds` are what `Habits` has of a file; `sections` says for each line
    under which heading it stands.  After a time of `time.monotonic` no more are judged.
    """
    found = list(lines)
    places = list(sections) or [0] * len(found)
    under: dict[int, list[Line]] = {}
    for line, place in zip(found, places, strict=True):
        under.setdefault(place, []).append(line)
    always = frozenset(own(glyph) for glyph in timed)
    dotted = {place: _moving(some) | always for place, some in under.items()}
    # Equations of motion often stand under a heading of their own.
    moving = {place: some | dotted.get(place + 1, frozenset()) for place, some in dotted.items()}
    known = frozenset().union(*moving.values())
    of = {x: args for x, args in _arguments(functions).items() if x not in known}
    ledger = _Ledger(moving, of, _twins(found), kinds)
    made = []
    for i, line in enumerate(found):
        if line.equation is None:
            made.append(Held(line, UNREAD, line.problem))
            continue
        if time.monotonic() > until:
            made.append(Held(line, Verdict.UNDECIDED.value, "the time for the file was over"))
            continue
        ledger.section = places[i]
        made.append(ledger.take(i, line))
    return tuple(made)


def _twins(lines: Sequence[Line]) -> dict[int, Equation]:
    """The lines that ± makes: two at one place, with the same left side."""
    made: dict[int, Equation] = {}
    for (i, one), (k, two) in pairwise(enumerate(lines)):
        a, b = one.equation, two.equation
        if a is None or b is None or one.position != two.position:
            continue
        if a.sides[0] == b.sides[0] and len(a.sides) == len(b.sides) == 2:
            made |= {i: b, k: a}
    return made


def _moving(lines: Iterable[Line]) -> frozenset[Symbol]:
    """The letters that have a dot somewhere."""
    found: set[Symbol] = set()
    for line in lines:
        for side in line.equation.sides if line.equation is not None else ():
            for node in sympy.preorder_traversal(side):
                if isinstance(node, Lettered) and node.quantity.glyph.accent in ("dot", "ddot"):
                    found.add(own(replace(node.quantity.glyph, accent="")))
                elif isinstance(node, eq.Rate) and isinstance(node.args[0], Lettered):
                    found.add(node.args[0])
    return frozenset(found)


def _arguments(functions: Iterable[tuple[Glyph, str]]) -> dict[Symbol, tuple[Symbol, ...]]:
    made: dict[Symbol, set[Symbol]] = {}
    for glyph, base in functions:
        if base:
            made.setdefault(own(glyph), set()).add(own(Glyph(base)))
    return {x: tuple(sorted(of, key=str)) for x, of in made.items()}


def _dotted(letter: Lettered, times: int = 1) -> Lettered:
    """ẋ of x, ẍ of ẋ; what comes then has no letter that is written."""
    glyph = letter.quantity.glyph
    for _ in range(times):
        glyph = replace(glyph, accent={"": "dot", "dot": "ddot", "ddot": "dddot"}[glyph.accent])
    return own(glyph)


def _bare(letter: Symbol) -> Symbol:
    """The letter without dots."""
    glyph = letter.quantity.glyph if isinstance(letter, Lettered) else Glyph(letter.name)
    return own(replace(glyph, accent="")) if "dot" in glyph.accent else letter


@dataclass(frozen=True)
class _Given:
    """What a letter stands for, and the lines that say so."""

    value: Expr
    rests: frozenset[int]
    section: int
    stated: bool = True
    """Whether it is said, rather than the rate of what is said."""
    side: Any = None
    """As it was written, where the letter itself is said."""


@dataclass(frozen=True)
class _Law:
    """Equations that hold along the motion: coordinates, what vanishes, and whose lines they are.

    `words` say what they are; `letters` are all that stand in them.
    """

    q: tuple[Lettered, ...]
    vanishing: tuple[Expr, ...]
    rests: frozenset[int]
    words: str
    section: int
    lagrangian: Expr | None = None
    broken: bool = False

    @property
    def functions(self) -> set[Any]:
        """Functions of which nothing is known."""
        return _functions(*self.vanishing)

    @property
    def highest(self) -> list[Lettered]:
        """The rates for which the law is solved: ẍ, or ω̇ of an equation of first order."""
        stands = set().union(*(x.free_symbols for x in self.vanishing))
        return [_dotted(x, 2 if _dotted(x, 2) in stands else 1) for x in self.q]

    def misses(self, symbols: set[Symbol]) -> int:
        """How many numbers the equations of the accelerations among symbols have besides these; too
        many where they have coordinates besides."""
        a = [x for x in symbols if _accent(x) == "ddot"]
        lost = [x.free_symbols - symbols - {*a, TIME} for x in self.vanishing if x.has(*a)]
        return min(
            (
                MOST_MISSING + 1 if any(_bare(x) in self.q for x in each) else len(each)
                for each in lost
            ),
            default=0,
        )

    @property
    def letters(self) -> frozenset[Symbol]:
        return frozenset(
            _bare(x) for each in self.vanishing for x in each.free_symbols
        ) | frozenset(self.q)


@dataclass
class _Ledger:
    """Takes one line after the other, and keeps what they say."""

    moves: Mapping[int, frozenset[Symbol]]
    """The letters that change in time, under each heading."""
    functions: Mapping[Symbol, tuple[Symbol, ...]]
    twins: Mapping[int, Equation] = field(default_factory=dict)
    """Of a line that ± makes, by its number, the other one."""
    kinds: Callable[[Glyph], str] = lambda _: ""
    """The quantity that the file's words say a letter is."""
    given: dict[Symbol, _Given] = field(default_factory=dict)
    law: _Law | None = None
    other: _Law | None = None
    """That of another form of ℒ which contradicts it: which of them is meant is open."""
    sets: dict[Symbol, _Given] = field(default_factory=dict)
    """What is set for a special motion: θ̇ by 0, φ̇ by Ω."""
    signs: dict[Symbol, Lettered] = field(default_factory=dict)
    """What stands in values for the sign, 1 or −1, of a letter that is known by its square."""
    at_places: set[Symbol] = field(default_factory=set)
    """Letters of functions, as V in V(x): V′(x) is then its slope."""
    section: int = 0
    used: set[int] = field(default_factory=set)
    places: dict[int, int] = field(default_factory=dict)
    """The section of each line."""

    @property
    def moving(self) -> frozenset[Symbol]:
        along = self.law.q if self.law is not None else ()
        return self.moves.get(self.section, frozenset()) | {*along}

    def take(self, number: int, line: Line) -> Held:
        equation = line.equation
        assert equation is not None
        self.places[number] = self.section
        self.sets = {x: g for x, g in self.sets.items() if g.section == self.section}
        try:
            if equation.relation not in ("=", "≡"):
                raise NoMeaningError(f"{equation.relation} is not judged")
            if any(sympy.count_ops(side, visual=False) > MOST_OPERATIONS for side in equation.sides
                   if not isinstance(side, sympy.MatrixBase)):  # fmt: skip
                raise NoMeaningError(f"more than {MOST_OPERATIONS} operations")
            found = self.judged(number, line, equation)
        except NoMeaningError as error:
            found = Held(line, Verdict.UNDECIDED.value, str(error))
        except (ArithmeticError, TypeError, ValueError, AttributeError, KeyError) as error:
            said = " ".join(str(error).split())[:80]
            found = Held(line, Verdict.UNDECIDED.value, f"it says nothing to compare ({said})")
        except RecursionError:
            found = Held(line, Verdict.UNDECIDED.value, "nested too deeply")
        if found.verdict == Verdict.FALSE.value and line.condition:
            note = f"holds at most “{line.condition}”, which is not judged"
            return replace(found, verdict=Verdict.UNDECIDED.value, note=note)
        return found

    def judged(self, number: int, line: Line, equation: Equation) -> Held:
        """All links of a chain; the first one may say what a letter stands for."""
        first, *others = map(self.named, equation.sides)
        if const in others:
            links = [(a, None if b == const else b) for a, b in pairwise([first, *others])]
        else:
            links = list(pairwise([first, *others]))
        made: list[Held] = []
        inner = 0
        defines = self.defines(first, others)
        twin = self.twins.get(number)
        if twin is not None and len(others) == 1:
            return self.either(line, first, others[0], self.named(twin.sides[-1]))
        if defines:
            made.append(self.defined(number, line, first, others))
            links, inner = links[1:], 1
        made += [
            self.linked(number, line, left, right, bool(k))
            for k, (left, right) in enumerate(links, inner)
        ]
        law, known = self.law, self.given.get(first)
        wrong = any(each.verdict == Verdict.FALSE for each in made)
        if defines and wrong and law is not None and _base(first) in _LAGRANGIANS:
            self.defined(number, line, first, others[-1:])
            self.law, self.other, self.given[first] = law, self.law, known or self.given[first]
        said = made[1:] if defines and len(made) > 1 and made[0].verdict == PREMISE else made
        worst = max(said, key=lambda each: _ORDER.index(each.verdict))
        rests = sorted({x for each in made for x in each.rests} - {number})
        return replace(worst, rests=tuple(rests))

    def named(self, side: Any) -> Any:
        """V for V(x, θ), of which nothing was said above."""
        if not isinstance(side, eq.At) or side.args[0] in self.given:
            return side
        letter, *of = side.args
        known = self.moving | {TIME}
        return letter if len(of) > 1 and all(_bare(x) in known for x in of) else side

    # What letters stand for

    def defines(self, first: Any, others: Sequence[Any]) -> bool:
        """Whether a line says what a letter stands for, of which nothing was said above."""
        if not isinstance(first, Lettered) or kind(first) != "scalar" or others[0] == const:
            return False
        if first.quantity.glyph.accent in ("dot", "ddot") or self.by_law(first) is not None:
            return False
        known = self.given.get(first)
        if known is not None:
            return known.section != self.section and not _closed_over(others[0], first)
        if first in self.primitive() and self.is_set(first, others[-1]):
            return False
        side = others[-1] if others[-1] != const else others[0]
        made = {y for x in getattr(side, "free_symbols", ()) if x in self.given
                for y in self.given[x].value.free_symbols}  # fmt: skip
        return first not in getattr(side, "free_symbols", set()) | made

    def defined(self, number: int, line: Line, first: Lettered, others: Sequence[Any]) -> Held:
        if first in self.given and self.given[first].section != self.section:
            old = self.section
            self.given = {x: g for x, g in self.given.items() if g.section == old}
            if self.law is not None and self.law.section != old:
                self.law, self.sets = None, {}
        values: list[tuple[Any, Expr, set[int]]] = []
        last: NoMeaningError | None = None
        for side in (side for side in others if side != const):
            try:
                self.used = set()
                values.append((side, self.value(side), self.used))
            except NoMeaningError as error:
                last = error
        if not values:
            raise last or NoMeaningError("nothing is said of it")
        side, value, used = next((found for found in values if found[2]), values[-1])
        self.give(first, value, frozenset({number, *used}), side)
        if _base(first) in _LAGRANGIANS:
            return self.lagrangian(number, line, first, side)
        return Held(line, PREMISE, f"what {text(first)} stands for", tuple(sorted(used)))

    def give(self, letter: Lettered, value: Expr, rests: frozenset[int], side: Any = None) -> None:
        """A letter that changes in time gives its rates too."""
        times = 3 if letter in self.moving else 1
        meant = {letter: value}
        for k in range(1, times):
            meant[_dotted(letter, k)] = self.total(
                meant[_dotted(letter, k - 1) if k > 1 else letter]
            )
        coordinates = {*self.law.q} if self.law is not None else set()
        turned = {_bare(x) for x in value.free_symbols} & self.moving - coordinates
        for other, known in self.given.items():
            if known.section == self.section and known.value.free_symbols & {*meant}:
                new = known.value.subs(meant, simultaneous=True)
                self.given[other] = replace(known, value=new, rests=known.rests | rests)
                # ω = ẋ/r behind ℒ says what ℒ is, and r = r₀ + ρ; r = r(φ) of an orbit is no
                # constraint.
                if _base(other) in _LAGRANGIANS and (letter not in coordinates or turned):
                    self.law = self.of_lagrangian(other) or self.law
        for k in range(times):
            known = _Given(value, rests, self.section, side=None if k else side)
            self.given[_dotted(letter, k) if k else letter] = known
            value = self.total(value) if k + 1 < times else value

    def lagrangian(self, number: int, line: Line, letter: Lettered, side: Any) -> Held:
        """Lagrange's equations of an ℒ that is written in coordinates and rates."""
        law = self.of_lagrangian(letter)
        if law is None:
            named = self.kinds(letter.quantity.glyph)
            rates = any(_accent(x) == "dot" for x in self.given[letter].value.free_symbols)
            said = f"what {text(letter)} stands for" + (f": {named}" if named else "")
            if rates and not named:
                said = f"{text(letter)}: ℒ, or an angular momentum? nothing says"
            return Held(line, PREMISE, said)
        self.law, self.sets, self.other = law, {}, None
        energies = self.energies(side)
        if energies is not None and energies[1] != -1:
            at = " − ".join(text(x) for x in energies[0])
            return Held(
                line, Verdict.FALSE.value, f"a Lagrangian is {at}: the sign of the potential"
            )
        rests = tuple(sorted(law.rests - {number}))
        return Held(line, PREMISE, "the Lagrangian of the equations that follow", rests)

    def of_lagrangian(self, letter: Lettered) -> _Law | None:
        known = self.given[letter]
        value = known.value
        rates = [x for x in value.free_symbols if _accent(x) == "dot"]
        q = tuple(sorted((_bare(x) for x in rates), key=str))
        if not q or any(_accent(x) == "ddot" for x in value.free_symbols):
            return None
        v = [_dotted(x) for x in q]
        named = self.kinds(letter.quantity.glyph)
        linear = all(value.diff(x, y) == 0 for x in v for y in v)
        if named not in ("", "the Lagrangian") or (linear and not named):
            return None
        vanishing = [self.total(value.diff(y)) - value.diff(x) for x, y in zip(q, v, strict=True)]
        expanded = tuple(sympy.expand(x) for x in vanishing)
        return _Law(q, expanded, known.rests, "by Lagrange's equations", known.section, value)

    def energies(self, side: Any) -> tuple[tuple[Symbol, Symbol], int] | None:
        """The letters T and V of a side T ± V, and the sign."""
        letters = {_base(x): x for x in getattr(side, "free_symbols", set())}
        potential = next((letters[b] for b in ("V", "U") if b in letters), None)
        if len(letters) != 2 or "T" not in letters or potential is None:
            return None
        kinetic = letters["T"]
        plain = sympy.expand(self.bare(side))
        for sign in (1, -1):
            if plain == kinetic + sign * potential:
                return (kinetic, potential), sign
        return None

    def bare(self, side: Any) -> Expr:
        """A side in its own letters, nothing put in."""
        return _Ledger({0: self.moving}, {}).value(side)

    def by_law(self, letter: Any) -> Expr | None:
        """A momentum p_θ, or H, where ℒ says what it is."""
        if self.law is None or self.law.lagrangian is None or not isinstance(letter, Lettered):
            return None
        glyph, L = letter.quantity.glyph, self.law.lagrangian
        v = [_dotted(x) for x in self.law.q]
        if glyph.accent or letter in self.given:
            return None
        if glyph.base == "p" and glyph.sub:
            for q, rate in zip(self.law.q, v, strict=True):
                named = q.quantity.glyph
                if glyph.sub in (named.base + named.sub, f"{named.base}_{named.sub}"):
                    return sympy.sympify(L.diff(rate))
        if glyph.base in _ENERGIES and not glyph.sub:
            return lagrangian.energy(L, v)
        return None

    # What trees say

    def value(self, node: Any) -> Expr:
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
            return self.value(Mul(*node.args, evaluate=False))
        if isinstance(node, eq.Printed):
            raise NoMeaningError(f"{_NAMES.get(type(node), 'what stands here')} is not judged")
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
        rate = self.by_law(_bare(node)) if _accent(node) == "dot" else None
        if self.law is not None and (law is not None or rate is not None):
            self.used |= self.law.rests
            return law if law is not None else self.total(rate)
        if node in self.functions:
            return Function(node.name, real=True)(*self.functions[node])
        return node

    def slope(self, node: Expr) -> Expr:
        of, *by = node.args
        value = self.value(of)
        if isinstance(of, Symbol) and value == of:
            raise NoMeaningError(f"nothing above says what {text(of)} is")
        momenta = self.momenta()
        if len(by) == 1 and self.by_law(of) is not None and _base(of) in _ENERGIES:
            return self.of_hamiltonian(by[0], momenta)
        if _base(of) not in _LAGRANGIANS and all(_accent(x) != "dot" for x in by):
            held = self.without(momenta)
            if any(x in momenta or self.by_law(x) for x in held.value(of).free_symbols):
                return self.value(held.slope(node))
        for x in by:
            if not isinstance(x, Lettered) or x in self.given:
                raise NoMeaningError("a derivative by what is no free letter")
            others = {_bare(y) for y in value.free_symbols} & self.moving - {_bare(x)}
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
        rates = {self.law.lagrangian.diff(_dotted(q)).expand(): _dotted(q) for q in self.law.q}
        values = {x: g.value.expand() for x, g in self.given.items() if not _accent(x)}
        return {x: rates[value] for x, value in values.items() if value in rates}

    def without(self, letters: Iterable[Symbol]) -> _Ledger:
        """What is said, where letters are left as they are written: held as others change."""
        made = _Ledger(self.moves, self.functions, section=self.section)
        for x, known in self.given.items():
            if known.side is not None and x not in letters and isinstance(x, Lettered):
                made.give(x, made.value(known.side), known.rests, known.side)
        return made

    def of_hamiltonian(self, by: Symbol, momenta: Mapping[Symbol, Expr]) -> Expr:
        """∂ℋ/∂p = q̇, and ∂ℋ/∂q = −∂ℒ/∂q: the momenta are held in one, the rates in the other."""
        law = self.law
        assert law is not None
        assert law.lagrangian is not None
        found, slopes = self.by_law(by), {law.lagrangian.diff(_dotted(q)): q for q in law.q}
        if by in momenta:
            return momenta[by]
        if found in slopes:
            return _dotted(slopes[found])
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
            if x in self.moving or (isinstance(x, Lettered) and _accent(x) in ("dot", "ddot")):
                made += value.diff(x) * _dotted(x)
        return made

    # Whether two sides are equal

    def linked(self, number: int, line: Line, left: Any, right: Any, inner: bool = False) -> Held:
        self.used = set()
        if right is None:
            sides = (self.total(self.value(left)), sympy.sympify(0))
        else:
            sides = (self.value(left), self.value(right))
        rests = set(self.used)
        residual = sides[0] - sides[1]

        def made(verdict: Verdict, note: str, *more: int) -> Held:
            return Held(line, verdict.value, note, tuple(sorted({*rests, *more} - {number})))

        for law in (None, *filter(None, (self.law, self.other))):
            found = self.shown(residual, law)
            if found is None:
                continue
            if law is None and not rests and left == right:
                return made(Verdict.UNDECIDED, "it says nothing: both sides are the same")
            said = "by what is said above" if rests else "whatever its letters are"
            verdict, where = found
            if law is not None:
                return made(verdict, where or law.words, *law.rests)
            return made(verdict, where or said)
        plus = dict.fromkeys(self.signs, Integer(1))
        sides = (sides[0].xreplace(plus), sides[1].xreplace(plus))
        residual = sides[0] - sides[1]
        special = self.specially(sides)
        if special is not None:
            where, lines = special
            return made(Verdict.ASSUMING, f"where {where}", *lines)
        premise = self.premise(number, line, left, right, residual)
        if premise is not None:
            return premise
        if self.is_other(left, right, residual):
            self.give(left, self.value(right), frozenset({number, *self.used}))
            if self.law is not None and self.law.rests & rests:
                self.law, self.sets = None, {}
            return Held(line, PREMISE, f"what {text(left)} stands for, another than above")
        self.used = rests
        return self.refuted(left, right, sides, inner, made)

    def either(self, line: Line, left: Any, right: Any, other: Any) -> Held:
        """One of two lines that ± makes: where it does not hold the other one has to."""
        self.used = set()
        one, two = (self.value(left) - self.value(side) for side in (right, other))
        rests = tuple(sorted(self.used))
        found = self.shown(one, None)
        if found is not None and found[0] is not Verdict.UNDECIDED:
            return Held(line, found[0].value, found[1] or "by what is said above", rests)
        meant = {x: g.value for x, g in self.sets.items()}
        both, solved = (one * two).subs(meant).subs(meant), [dict[Symbol, Expr]()]
        for v in self.law.vanishing if self.law is not None else ():
            given = sympy.expand(v.subs(meant).subs(meant))
            if not given.has(*(_dotted(x, 2) for x in self.moving)):
                linear = [x for x in given.free_symbols if given.diff(x) != 0 == given.diff(x, 2)]
                solved += [{x: -given.subs(x, 0) / given.diff(x)} for x in sorted(linear, key=str)]
        for put in solved:
            if self.shown(sympy.expand(both.subs(put)), None) is not None:
                said = ", ".join(filter(None, (_said(meant), "with one of the two signs")))
                law = self.law.rests if put and self.law is not None else frozenset()
                return Held(line, Verdict.ASSUMING.value, f"where {said}", tuple({*rests, *law}))
        known = self.primitive().union(*(x.free_symbols for x in meant.values()), self.given)
        if isinstance(left, Symbol) and _bare(left) not in known:
            return Held(line, PREMISE, f"one of two values of {text(left)}: which is not said")
        return Held(line, Verdict.UNDECIDED.value, "neither of the two signs was shown")

    def refuted(
        self,
        left: Any,
        right: Any,
        sides: tuple[Expr, Expr],
        inner: bool,
        made: Callable[..., Held],
    ) -> Held:
        """Numbers for which two sides differ, where nothing in them is open.

        A line is refuted along the motion if it has accelerations, and of what is defined above if
        it speaks of rates; other equations between the same letters may be of a special case.
        """
        law, residual, rests = self.law, sides[0] - sides[1], set(self.used)
        symbols = set().union(*(side.free_symbols for side in sides))
        letters = {_bare(x) for x in residual.free_symbols}
        closed = self.letters_of(rests) | {TIME}
        by_file = bool(rests) and self.is_closed(left, sides, inner)
        along = law is not None and letters <= law.letters | closed
        sure = law is not None and law.lagrangian is not None and not law.broken
        against = self.against(sides) if sure else None
        if against is not None and law is not None:
            return made(Verdict.FALSE, against, *law.rests)
        if not along and not by_file:
            strange = sorted(letters - closed - (law.letters if law else set()), key=str)
            named = ", ".join(map(text, strange))
            said = f"says what {named} is" if named else "leads here"
            return made(Verdict.UNDECIDED, f"nothing above {said}")
        if _nearly(residual, sides, law.q if law else tuple(self.moving)):
            words = "it holds to the lowest order in the coordinates only: write ≈"
            return made(Verdict.UNDECIDED, words)
        if _is_polynomial(sides[1], self.moving) and not _is_polynomial(sides[0], self.moving):
            words = "it may be an expansion about another place: write ≈"
            return made(Verdict.UNDECIDED, words)
        if law is not None and along and residual.free_symbols & {*law.highest}:
            if law.broken:
                words = "forces besides the Lagrangian act: it is not judged"
                return made(Verdict.UNDECIDED, words)
            special = law.misses(symbols) > MOST_MISSING or law.functions - _functions(*sides)
            if special or law.lagrangian is None or _is_linear(residual, law):
                return made(Verdict.UNDECIDED, "a special case of what is above, or a slip?")
            found = _numbers(sides, law)
            if found is not None:
                return made(Verdict.FALSE, found, *law.rests)
        elif by_file and (_differentiates(left) or any(map(_accent, symbols))):
            found = None if _functions(*sides) else _numbers(sides, None)
            if found is not None:
                return made(Verdict.FALSE, found)
        elif law is not None and along and not by_file:
            where = _at_rest(residual, law)
            if where:
                return made(Verdict.ASSUMING, f"where {where}", *law.rests)
            return made(Verdict.UNDECIDED, "it holds for special motions at most: which?")
        elif isinstance(left, Symbol) and left in self.given:
            return made(Verdict.UNDECIDED, "another value than above: of another case, or a slip?")
        return made(Verdict.UNDECIDED, "neither shown nor refuted")

    def is_closed(self, left: Any, sides: tuple[Expr, Expr], inner: bool) -> bool:
        """Whether the left side says by itself what the right one must be, all under one heading: a
        derivative, or a quantity made of others and written in the same letters."""
        if any(self.places.get(x) != self.section for x in self.used):
            return False
        if not all({_bare(x) for x in side.free_symbols} & self.moving for side in sides):
            return False
        mine, theirs = (side.free_symbols - {TIME} for side in sides)
        here = max(self.places)  # of a chain that gives ℒ the first form is the law
        law = self.law if self.law is not None and self.law.rests <= self.used | {here} else None
        within = {_bare(x) for x in theirs} <= {_bare(x) for x in mine}.union(
            law.letters if law is not None else ()
        )
        if _differentiates(left):
            return within
        if not isinstance(left, Lettered):
            gives = law is not None and here in law.rests
            return inner and (mine == theirs or (gives and within))
        known = self.given.get(left)
        if _accent(left):  # a derivative, or a rate that stands in the momenta: solved for it
            return (known is not None and theirs <= mine) or (law is not None and left in theirs)
        if law is not None and (known is None or law.rests <= known.rests):
            return within
        return known is not None and len(known.rests) > 1 and mine == theirs

    def is_other(self, left: Any, right: Any, residual: Expr) -> bool:
        """Whether a letter of which something was said stands for something else from here on."""
        if right is None or left not in self.given or _accent(left):
            return False
        letters = {_bare(x) for x in residual.free_symbols}
        return not letters <= self.letters_of(set(self.given[left].rests)) | {TIME}

    def letters_of(self, rests: set[int]) -> set[Symbol]:
        """What stands in the values that were put in."""
        values = [g.value for g in self.given.values() if g.rests & rests and g.rests <= rests]
        return {_bare(x) for value in values for x in value.free_symbols}

    def specially(self, sides: tuple[Expr, Expr]) -> tuple[str, set[int]] | None:
        """Where a line holds for the special motion that was set, the words for that."""
        residual = sides[0] - sides[1]
        if not self.sets:
            return None
        meant = {x: g.value for x, g in self.sets.items()}
        lines = set().union(*(g.rests for g in self.sets.values()))
        words = _said(meant)
        law, stated = self.law, {x: meant[x] for x, g in self.sets.items() if g.stated}
        for put in (stated, meant) if law is not None and not law.broken else ():
            assert law is not None
            given = tuple(x.subs(put) for x in law.vanishing)
            found = self.shown(residual.subs(put), replace(law, vanishing=given))
            if found is not None and found[0] is not Verdict.UNDECIDED:
                more = found[1].removeprefix("where ") if found[0] is Verdict.ASSUMING else ""
                return ", ".join(filter(None, (_said(put), more))), lines | law.rests
        if not {*meant}.union(*(x.free_symbols for x in meant.values())) & residual.free_symbols:
            return None
        bare = sympy.expand(residual.subs(meant).subs(meant))
        if _vanishes(bare) is not None:
            left = sympy.expand(sides[0].subs(meant).subs(meant))
            return (words, lines) if _vanishes(left) is None else None
        for vanishing in self.law.vanishing if self.law is not None else ():
            given = vanishing.subs(meant).subs(meant)
            if _vanishes(given) is not None:
                continue
            lost = _follows(bare, sympy.expand(given))
            if lost is not None:
                more = "".join(f", {text(x)} ≠ 0" for x in lost)
                return words + more, lines | set(self.law.rests if self.law else ())
        return None

    def against(self, sides: tuple[Expr, Expr]) -> str | None:
        """Numbers for the special motion that was set, at which a line does not hold."""
        law = self.law
        meant = {x: g.value for x, g in self.sets.items()}
        new = {y for x in meant.values() for y in x.free_symbols}
        if law is None or not ({*meant} | new) & (sides[0] - sides[1]).free_symbols:
            return None
        given = [sympy.expand(x.subs(meant).subs(meant)) for x in law.vanishing]
        moved = {_dotted(x, 2) for x in law.q}
        given = [x for x in given if not x.has(*moved) and _vanishes(x) is None]
        known = {_bare(x) for x in (sides[0] - sides[1]).free_symbols} - law.letters
        if len(given) != 1 or not known <= new | {TIME} or _functions(*sides, *given):
            return None
        linear = [x for x in given[0].free_symbols if not _moves(x) and given[0].diff(x, 2) == 0]
        for x in sorted(linear, key=str):
            solved = {x: -given[0].subs(x, 0) / given[0].diff(x)}
            put = [sympy.expand(side.subs(meant).subs(meant)).subs(solved) for side in sides]
            found = (
                None if _vanishes(put[0] - put[1]) is not None else _numbers((put[0], put[1]), None)
            )
            if found is not None:
                told = ", ".join(f"{text(y)} = {text(v)}" for y, v in meant.items() if v != 0)
                return f"where {told}, {text(x)} balances: {found}"
        return None

    def shown(self, residual: Expr, law: _Law | None) -> tuple[Verdict, str] | None:
        """Whether an expression vanishes, along the motion of a law if there is one, and where:
        for which signs of what is known by its square, and of what stands under a root."""
        vanishing = law.vanishing if law is not None else ()
        a = law.highest if law is not None else []
        if any(_accent(x) == "dot" and _dotted(x) in residual.free_symbols for x in a):
            vanishing = (*vanishing, *map(self.total, vanishing))
            a = [*a, *map(_dotted, a)]
        letters = set().union(*(x.free_symbols for x in (residual, *vanishing)))
        signs = [x for x in self.signs if x in letters]
        if len(signs) > MOST_SIGNS:
            raise NoMeaningError(f"more than {MOST_SIGNS} letters are known by their squares")

        def holds(put: Mapping[Symbol, Any]) -> Verdict | None:
            return _vanishes(residual.xreplace(put), [x.xreplace(put) for x in vanishing], a)

        def turned(k: int) -> tuple[int, ...]:
            return tuple(1 - 2 * (i == k) for i in range(len(signs)))

        found = {
            turns: holds(dict(zip(signs, map(Integer, turns), strict=True)))
            for turns in product((1, -1), repeat=len(signs))
        }
        verdicts = [verdict for verdict in found.values() if verdict is not None]
        if len(verdicts) == len(found):
            where = _divided(residual, vanishing, a) if law is not None else ""
            return (Verdict.ASSUMING, where) if where else (max(verdicts, key=[*Verdict].index), "")
        if found[turned(-1)] is not None:
            needed = [self.signs[x] for k, x in enumerate(signs) if found[turned(k)] is None]
            needed = needed or [self.signs[x] for x in signs]
            return Verdict.ASSUMING, "where " + ", ".join(f"{text(x)} > 0" for x in needed)
        if verdicts:
            return Verdict.UNDECIDED, "it holds with the other sign of a root"
        roots = {x for p in residual.atoms(Pow, sympy.Abs, sympy.log) for x in p.free_symbols
                 if not (p.is_Pow and p.exp.is_Integer)} - {*signs}  # fmt: skip
        positive: dict[Symbol, Any] = {x: sympy.Dummy(positive=True) for x in roots}
        plus = dict.fromkeys(signs, Integer(1))
        for negative in ({}, *({x: -positive[x]} for x in roots if _bare(x) in self.moving)):
            put = {**plus, **positive, **negative}
            if roots and holds(put) is not None:
                needed = [
                    y for y in roots if holds({z: v for z, v in put.items() if z != y}) is None
                ]
                said = [f"{text(y)} {'<' if y in negative else '>'} 0" for y in needed]
                said += [f"{text(self.signs[y])} > 0" for y in signs]
                return Verdict.ASSUMING, "where " + ", ".join(sorted(said))
        return None

    def premise(
        self, number: int, line: Line, left: Any, right: Any, residual: Expr
    ) -> Held | None:
        """What a line brings that is new: a quantity by its square, an equation of motion, what is
        set for a special motion."""
        if right is None:
            return None
        known = self.law.letters if self.law is not None else set()
        here = {number, *self.used}
        if isinstance(left, Pow) and isinstance(left.base, Lettered) and left.exp.is_Integer:
            letter, value = left.base, self.value(right)
            if letter not in self.given and letter not in known | value.free_symbols:
                root = value ** Rational(1, int(left.exp))
                if left.exp % 2 == 0:
                    sign = sympy.Dummy(f"sign of {letter}", real=True)
                    self.signs[sign] = letter
                    root *= sign
                self.give(letter, root, frozenset(here))
                return Held(line, PREMISE, f"what {text(letter)} stands for", tuple(self.used))
        if isinstance(left, Lettered) and self.is_set(left, right):
            value = self.value(right)
            for k in range(3 - ["", "dot", "ddot"].index(left.quantity.glyph.accent)):
                self.sets[_dotted(left, k) if k else left] = _Given(
                    value, frozenset(here), self.section, k == 0
                )
                value = Integer(0)
            return Held(line, PREMISE, "a special motion, or value", ())
        if self.defines(right, [left]) and right not in self.primitive():
            self.give(right, self.value(left), frozenset(here), left)
            return Held(line, PREMISE, f"what {text(right)} stands for", tuple(self.used))
        generic = {x for side in (left, right) for x in side.atoms(eq.Rate, eq.Partial)}
        if self.law is not None and any(isinstance(x, eq.Partial) for x in generic):
            if {_bare(x) for x in residual.free_symbols} - known:
                self.law = replace(self.law, broken=True)
                return Held(line, PREMISE, "Lagrange's equation with a force besides", ())
            return None
        newest = sorted({_bare(x) for x in residual.free_symbols if _accent(x) == "ddot"}, key=str)
        rates = [x for x in residual.free_symbols if _accent(x) == "dot"]
        if not newest and _degree(residual, rates) == 1:
            newest = sorted(map(_bare, rates), key=str)
        if newest and (self.law is None or not set(newest) <= set(self.law.q)):
            return self.newton(number, line, residual, newest)
        return None

    def primitive(self) -> set[Symbol]:
        """The letters that stand in what is defined, and in the law."""
        values = [g.value for g in self.given.values() if g.section == self.section]
        made = {_bare(x) for value in values for x in value.free_symbols}
        return made | (set(self.law.letters) if self.law is not None else set())

    def is_set(self, left: Lettered, right: Any) -> bool:
        """θ̇ = 0, φ̇ = Ω, l₁ = l: a letter of the motion, or a number, and what does not change."""
        accent = left.quantity.glyph.accent
        if left in self.given or accent not in ("", "dot", "ddot"):
            return False
        if _bare(left) not in self.primitive():
            return False
        value = self.value(right)
        law = self.law
        if accent == "ddot" and law is not None and value and value.free_symbols <= law.letters:
            return False  # it is what the law says, or wrong
        moves = {_bare(x) for x in value.free_symbols} & self.moving
        return (value.is_Symbol or value.is_number) and not moves

    def newton(self, number: int, line: Line, residual: Expr, newest: Sequence[Any]) -> Held | None:
        """An equation of motion that is taken as it stands."""
        law = self.law
        if law is not None and law.section != self.section:
            law = None
        if law is not None and law.lagrangian is not None:
            return None
        before = law if law is not None else _Law((), (), frozenset(), "", self.section)
        q = tuple(dict.fromkeys([*before.q, *newest]))
        vanishing = (*before.vanishing, residual)
        if len(vanishing) > len(q):
            return None
        self.law = _Law(
            q, vanishing, before.rests | {number}, "by the equations of motion above", self.section
        )
        return Held(line, PREMISE, "an equation of motion, taken as it stands", ())


_NAMES: Mapping[Any, str] = {
    eq.SumOver: "a sum",
    eq.SumFrom: "a sum",
    eq.Integrated: "an integral",
    eq.IntegralOver: "an integral",
    eq.VolumeIntegral: "an integral",
    eq.Cross: "a vector product",
    eq.Evaluated: "a value at a place",
    eq.Matrices: "a product of matrices",
}


def _functions(*expressions: Expr) -> set[Any]:
    return {f.func for x in expressions for f in x.atoms(AppliedUndef)}


def _base(letter: Symbol) -> str:
    return letter.quantity.glyph.base if isinstance(letter, Lettered) else letter.name


def _accent(letter: Symbol) -> str:
    return letter.quantity.glyph.accent if isinstance(letter, Lettered) else ""


def _said(meant: Mapping[Symbol, Expr]) -> str:
    """What is set, in words."""
    return ", ".join(f"{text(x)} = {text(v)}" for x, v in meant.items() if _accent(x) != "ddot")


def _differentiates(side: Any) -> bool:
    return bool(side.atoms(eq.Rate, eq.Partial, eq.Slope)) if isinstance(side, Expr) else False


def _closed_over(side: Any, letter: Symbol) -> bool:
    return letter in getattr(side, "free_symbols", set())


# --- Numbers and normal forms --------------------------------------------------------------------


def _plain(expression: Expr) -> tuple[Expr, dict[Expr, Symbol]]:
    """Functions of which nothing is known, and their slopes, as numbers at will."""
    nodes = sorted(
        expression.atoms(AppliedUndef, sympy.Derivative, sympy.Subs), key=sympy.default_sort_key
    )
    nodes.sort(key=sympy.count_ops, reverse=True)
    names = {node: sympy.Dummy(f"f{i}", real=True) for i, node in enumerate(nodes)}
    return expression.xreplace(names), names


def _moves(x: Symbol) -> bool:
    return "dot" in _accent(x) or _base(x)[:1] in _ANGLES


def _vanishes(
    residual: Expr, given: Sequence[Expr] = (), unknowns: Sequence[Symbol] = ()
) -> Verdict | None:
    """PROVED or SAMPLED where an expression vanishes, perhaps because others do; else None."""
    wanted, *known = _plain(sympy.Tuple(residual, *given))[0]
    if not known:
        return decide.evidence(wanted)
    rest = decide.eliminated(wanted, known, unknowns)
    return None if rest is None else decide.evidence(rest[0])


def _divided(residual: Expr, given: Sequence[Expr], unknowns: Sequence[Symbol]) -> str:
    """What must not vanish for a line to follow, in words: beside what it divides by itself."""
    if len(given) > MOST_SOLVED:
        return ""
    flat, names = _plain(sympy.Tuple(residual, *given))
    open_to_vanish = {_bare(x) for x in unknowns}
    flat = flat.xreplace(
        {
            x: sympy.Dummy(x.name, positive=True)
            for x in flat.free_symbols
            if isinstance(x, Lettered) and not _moves(x) and x not in open_to_vanish
        }
    )
    wanted, *known = flat
    # A multiple of one of them is divided by nothing else.
    if any(decide.follows(sympy.expand_trig(wanted), sympy.expand_trig(one)) for one in known):
        return ""
    found = decide.eliminated(sympy.fraction(sympy.together(wanted))[0], known, unknowns)
    lost = [] if found is None else decide.divided_by(found[1])
    typed = sympy.fraction(sympy.together(wanted))[1]
    kept = {new: old for old, new in names.items()}
    lost = [x for x in lost if not _has_sign(x) and typed.subs(x, 0) != 0]
    return "where " + ", ".join(f"{text(x.xreplace(kept))} ≠ 0" for x in lost) if lost else ""


def _has_sign(x: Expr) -> bool:
    """Whether something is never 0, its letters being positive: m₁ + m₂ − m₂ cos² θ is not."""
    for form in (reduce_trig(sign * x, keep) for sign in (1, -1) for keep in ("cos", "sin")):
        squares = [p for p in form.atoms(Pow) if p.exp.is_even]
        if form.xreplace({p: sympy.Dummy(nonnegative=True) for p in squares}).is_positive:
            return True
    return decide.nonzero(x)


def _is_polynomial(side: Expr, moving: Iterable[Symbol]) -> bool:
    """Whether a side with more than numbers is a polynomial in what moves."""
    moves = {x for x in side.free_symbols if _bare(x) in moving}
    return bool(moves) and side.is_polynomial(*moves)


def _degree(residual: Expr, letters: Sequence[Symbol]) -> int:
    over = sympy.fraction(sympy.together(residual))[0]
    if not letters or not over.is_polynomial(*letters):
        return 0
    return int(sympy.Poly(over, *letters).total_degree())


def _is_linear(residual: Expr, law: _Law) -> bool:
    """Whether a line is linear in what moves and the law is not: it may be of small deviations."""
    scale = sympy.Dummy("scale", positive=True)
    scaled = {y: scale * y for x in law.q for y in (x, _dotted(x), _dotted(x, 2))}
    twice = [sympy.expand(x.subs(scaled)).diff(scale, 2) for x in (residual, *law.vanishing)]
    return twice[0] == 0 and any(x != 0 for x in twice[1:])


def _follows(wanted: Expr, given: Expr) -> tuple[Expr, ...] | None:
    """What must not vanish so that wanted = 0 says what given = 0 does; None where it does not.

    The two are multiples of one sum; what they have besides are letters, sines and cosines.
    """
    ratio = reduce_ratio(wanted / given)
    functions = {f: sympy.Dummy() for f in (ratio + given).atoms(sympy.Function)}
    over, below = (x.xreplace(functions) for x in sympy.fraction(ratio))
    if below.has(Add) or over.has(Add) or not sympy.factor(given.xreplace(functions)).has(Add):
        return None
    kept = {new: old for old, new in functions.items()}
    return tuple(kept[x] for x in sorted(below.free_symbols & {*kept}, key=str))


def _at_rest(residual: Expr, law: _Law) -> str:
    """The accelerations without which a line is one of the law's equations, in words."""
    for vanishing in law.vanishing:
        a = [_dotted(x, 2) for x in law.q if vanishing.has(_dotted(x, 2))]
        given = sympy.expand(vanishing.subs(dict.fromkeys(a, 0)))
        lost = _follows(residual, given) if given != 0 else None
        if lost is not None:
            words = [f"{text(x)} = 0" for x in a] + [f"{text(x)} ≠ 0" for x in lost]
            return ", ".join(words)
    return ""


def _accelerations(
    vanishing: Sequence[Expr], a: Sequence[Symbol], point: Mapping[Symbol, Expr]
) -> dict[Symbol, Expr] | None:
    """The accelerations where numbers are put in for all else."""
    used = [x for x in a if any(each.has(x) for each in vanishing)]
    matrix, right = sympy.linear_eq_to_matrix([x.subs(point) for x in vanishing], used)
    if not matrix.is_square or abs(matrix.det().evalf()) < decide.TOLERANCE:
        return None
    return dict(zip(used, matrix.evalf().LUsolve(right.evalf()), strict=True))


def _nearly(residual: Expr, sides: tuple[Expr, Expr], q: Sequence[Symbol]) -> bool:
    """Whether sides that are polynomials in coordinates and rates agree to their own order."""
    small = sympy.Dummy("small", positive=True)
    scaled = {
        y: small * y
        for x in q
        if isinstance(x, Lettered)
        for y in (x, _dotted(x), _dotted(x, 2))
        if residual.has(y)
    }
    polynomial = [s for s in sides if all(s.is_polynomial(y) for y in scaled) and s != 0]
    if not scaled or not polynomial:
        return False
    powers = [sympy.Poly(s.subs(scaled), small).degree() for s in polynomial]
    highest = max(max(powers), 1)
    series = residual.subs(scaled)
    for order in range(highest + 1):
        if _vanishes(series.diff(small, order).subs(small, 0)) is None:
            return False
    return True


def _numbers(sides: tuple[Expr, Expr], law: _Law | None) -> str | None:
    """Short numbers at which two sides differ, in words; accelerations are those of the law."""
    flat, names = _plain(sympy.Tuple(*sides, *(law.vanishing if law is not None else ())))
    if names and law is not None:
        return "the two sides differ whatever the functions are"
    if names:
        return None
    left, right, *given = flat
    a = law.highest if law is not None else []
    needed = left.free_symbols | right.free_symbols
    if needed & {*a}:
        needed = needed.union(*(x.free_symbols for x in given))
    symbols = sorted(needed - {*a}, key=str)
    angles = {x for x in symbols if _base(x)[:1] in _ANGLES and not _accent(x)}
    # A length or a mass, whatever its letter, has no short number that is not positive.
    drawn = {x: x if _moves(x) else sympy.Dummy(x.name, positive=True) for x in symbols}
    for found in decide.points([*drawn.values()], angles, 120):
        point = {x: found[drawn[x]] for x in symbols}
        solved: dict[Symbol, Expr] = {}
        if (left - right).free_symbols & {*a}:
            solved = _accelerations(given, a, point) or {}
            if not solved:
                continue
        one, other = decide.evaluate([left, right], {**point, **solved}, {})
        gap, size = one - other, 1 + abs(one) + abs(other)
        if not (math.isfinite(size) and decide.holds("≠", gap, size)):
            continue
        values = ", ".join(f"{text(x)} = {text(v)}" for x, v in point.items())
        rates = ", ".join(
            f"{text(x)} is {_short(v)}" for x, v in solved.items() if (left - right).has(x)
        )
        words = f" {law.words}" if law is not None and rates else ""
        said = f"{rates}{words}; " if rates else ""
        return f"at {values}: {said}the left side is {_short(one)}, the right side {_short(other)}"
    return None


def _short(number: Any) -> str:
    return re.sub(r"\.?0+$", "", f"{float(number):.6f}").replace("-", "−") or "0"


# --- Files ---------------------------------------------------------------------------------------

_HEADING = re.compile(
    r"^[ \t]{0,3}#{1,6}[ \t]"
    r"|\\(?:chapter|(?:sub)*section)\*?[ \t]*[\[{]"
    r"|\\begin[ \t]*\{(?:example|problem|exercise|question|solution|theorem|proof)s?\}",
    re.M,
)
"""Behind it another system may begin, and letters stand for other things."""
_LABEL = re.compile(r"\\label\s*\{([^{}\n]{1,100})\}")


@dataclass(frozen=True)
class Row:
    """A line of a file, counted from 1, with what became of it; `lines` are those that it rests on.

    `number` is its number, or the name of its label; a symbol in a sentence is no row.
    """

    line: int
    column: int
    opens: int
    number: str
    display: bool
    held: Held
    lines: tuple[int, ...]


def rows(source: str, habits: Habits, seconds: float) -> tuple[Row, ...]:
    """Every formula of a file that says something, each judged by those above it.

    Once the time is up the rest is unread, and says so.
    """
    end = time.monotonic() + seconds
    tags = {
        formula.start: group.number for group in numbered(source) for formula in group.formulas[-1:]
    }
    found: list[tuple[Formula, Line]] = [
        (formula, line)
        for formula, lines in each(source, OWN, seconds, habits)
        if states(formula)
        for line in lines
        if line.equation is not None or formula.display
    ]
    headings = [match.start() for match in _HEADING.finditer(source)]
    sections = [bisect_right(headings, line.position) for _, line in found]
    lines = [line for _, line in found]
    judged = held(lines, habits.functions, habits.timed, sections, end, habits.kind)
    place = places(source)
    at = [place(min(line.position, len(source))) for line in lines]
    made = []
    for i, (formula, line) in enumerate(found):
        last = i + 1 == len(found) or found[i + 1][0] is not formula
        stop = formula.end if last else lines[i + 1].position
        label = _LABEL.search(source, line.position, stop)
        number = line.tag or (tags.get(formula.start, "") if last else "")
        number = number or (label[1] if label else "")
        rests = tuple(sorted({at[k][0] for k in judged[i].rests}))
        made.append(Row(*at[i], formula.opens, number, formula.display, judged[i], rests))
    return tuple(made)
