r"""Anyone's notes held against themselves: what each line says, and what the lines above say of it.

The file's own definitions are put in, and Lagrange's equations are taken from its own ℒ: a line
holds because of them, or contradicts them, with numbers.  What nothing above speaks of is taken as
it stands, and not called right.  So notes on a system of which nobody has heard are checked.

>>> from rigidtop.notation import OWN
>>> from rigidtop.read.formula import read
>>> text = (r"L = \frac12 m\dot x^2 - \frac12 kx^2,\quad m\ddot x = -kx,\quad m\ddot x = kx")
>>> for each in held(read(text, OWN)):
...     print(each.verdict, each.note.partition(";")[0], sep=": ")
premise: the Lagrangian of the equations that follow
proved: by Lagrange's equations
false: at k = 1, m = 1, x = 2: ẍ is −2 by Lagrange's equations
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import compress, pairwise, product
from typing import Any

import sympy
from sympy import Expr, Integer, Pow, Rational, Symbol

from rigidtop.mark.law import (
    MOST_MISSING,
    TIME,
    Law,
    accent,
    at_rest,
    bare,
    base,
    degree,
    differ_at,
    divided,
    dotted,
    functions_of,
    is_linear,
    is_polynomial,
    lost,
    moves,
    nearly,
    reduced,
    to_first_order,
    vanishes,
    words_of,
)
from rigidtop.mark.ledger import LAGRANGIANS, Given, Ledger
from rigidtop.notation.convention import own
from rigidtop.proof import equation as eq
from rigidtop.proof.equation import Equation, NoMeaningError
from rigidtop.proof.verdict import Verdict
from rigidtop.read.formula import Line
from rigidtop.read.values import kind
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.symbols import Glyph, const
from rigidtop.typeset.text import text

MOST_OPERATIONS = 400
"""An expression has no more operations, or it is not judged."""

MOST_SIGNS = 3
"""So many letters of a line may be known by their squares alone."""

PREMISE = "premise"
"""Said of what is taken as it stands: a law, a quantity of the file's own, a special motion."""

UNREAD = "unread"

IMAGINARY = own(Glyph("i"))


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
    under which heading it stands.  After a time of `time.process_time` no more are judged.
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
    ledger = _Judge(moving, of, kinds, _twins(found))
    made = []
    for i, line in enumerate(found):
        if line.equation is None:
            made.append(Held(line, UNREAD, line.problem))
            continue
        if time.process_time() > until:
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
    for glyph, of in functions:
        if of:
            made.setdefault(own(glyph), set()).add(own(Glyph(of)))
    return {x: tuple(sorted(args, key=str)) for x, args in made.items()}


@dataclass
class _Judge(Ledger):
    """Takes one line after the other, and says what the lines above say of it."""

    def take(self, number: int, line: Line) -> Held:
        equation = line.equation
        assert equation is not None
        self.places[number] = self.section
        self.sets = {x: g for x, g in self.sets.items() if g.section == self.section}
        try:
            if equation.relation not in ("=", "≡", "≈"):
                raise NoMeaningError(f"{equation.relation} is not judged")
            if any(sympy.count_ops(side, visual=False) > MOST_OPERATIONS for side in equation.sides
                   if not isinstance(side, sympy.MatrixBase)):  # fmt: skip
                raise NoMeaningError(f"more than {MOST_OPERATIONS} operations")
            if equation.relation == "≈":
                found = self.approximate(line, *map(self.named, equation.sides))
            else:
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

    def approximate(self, line: Line, *sides: Expr) -> Held:
        """A line of motions that are small: it holds to first order, or is open."""
        rests, found = set[int](), ""
        for left, right in pairwise(sides):
            if left == sides[0] and self.defines(left, [right]):
                continue
            self.used = set()
            if self.law is not None and self.law.broken:
                raise NoMeaningError("forces besides the Lagrangian act: it is not judged")
            found = to_first_order((self.value(left), self.value(right)), self.law, self.moving)
            if not found:
                raise NoMeaningError("≈ is shown to first order in what moves, and no further")
            rests |= self.used | (self.law.rests if self.law is not None else frozenset())
        if not found:
            return Held(line, PREMISE, f"about what {text(sides[0])} stands for")
        note = f"where the motion is small: to first order in {found}"
        return Held(line, Verdict.ASSUMING.value, note, tuple(sorted(rests)))

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
        if defines and wrong and law is not None and base(first) in LAGRANGIANS:
            self.defined(number, line, first, others[-1:])
            self.law, self.other, self.given[first] = law, self.law, known or self.given[first]
        said = made[1:] if defines and len(made) > 1 and made[0].verdict == PREMISE else made
        worst = max(said, key=lambda each: _ORDER.index(each.verdict))
        rests = sorted({x for each in made for x in each.rests} - {number})
        return replace(worst, rests=tuple(rests))

    def named(self, side: Expr) -> Expr:
        """V for V(x, θ), of which nothing was said above."""
        if not isinstance(side, eq.At) or side.args[0] in self.given:
            return side
        letter, *of = side.args
        known = self.moving | {TIME}
        return letter if len(of) > 1 and all(bare(x) in known for x in of) else side

    def defines(self, first: Expr, others: Sequence[Expr]) -> bool:
        """Whether a line says what a letter stands for, of which nothing was said above."""
        if not isinstance(first, Lettered) or kind(first) != "scalar" or others[0] == const:
            return False
        if first.quantity.glyph.accent in ("dot", "ddot") or self.by_law(first) is not None:
            return False
        if first in self.set_to:
            return False
        known = self.given.get(first)
        if known is not None:
            return known.section != self.section and first not in _letters(others[0])
        if first in self.primitive() and self.is_set(first, others[-1]):
            return False
        side = others[-1] if others[-1] != const else others[0]
        made = {y for x in _letters(side) if x in self.given
                for y in self.given[x].value.free_symbols}  # fmt: skip
        return first not in _letters(side) | made

    def defined(self, number: int, line: Line, first: Lettered, others: Sequence[Expr]) -> Held:
        if first in self.given and self.given[first].section != self.section:
            old = self.section
            self.given = {x: g for x, g in self.given.items() if g.section == old}
            if self.law is not None and self.law.section != old:
                self.law, self.sets = None, {}
        values: list[tuple[Expr, Expr, set[int]]] = []
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
        if base(first) in LAGRANGIANS:
            return self.lagrangian(number, line, first, side)
        return Held(line, PREMISE, f"what {text(first)} stands for", tuple(sorted(used)))

    def lagrangian(self, number: int, line: Line, letter: Lettered, side: Expr) -> Held:
        """Lagrange's equations of an ℒ that is written in coordinates and rates."""
        law = self.of_lagrangian(letter)
        if law is None:
            named = self.kinds(letter.quantity.glyph)
            rates = any(accent(x) == "dot" for x in self.given[letter].value.free_symbols)
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

    def energies(self, side: Expr) -> tuple[tuple[Symbol, Symbol], int] | None:
        """The letters T and V of a side T ± V, and the sign."""
        letters = {base(x): x for x in _letters(side)}
        potential = next((letters[b] for b in ("V", "U") if b in letters), None)
        if len(letters) != 2 or "T" not in letters or potential is None:
            return None
        kinetic = letters["T"]
        plain = sympy.expand(self.bare(side))
        for sign in (1, -1):
            if plain == kinetic + sign * potential:
                return (kinetic, potential), sign
        return None

    def linked(self, number: int, line: Line, left: Expr, right: Expr, inner: bool = False) -> Held:
        self.used = set()
        if right is None:
            sides = (self.total(self.value(left)), sympy.sympify(0))
        else:
            sides = (self.value(left), self.value(right))
        rests = set(self.used)
        residual = sides[0] - sides[1]

        def made(verdict: Verdict, note: str, *more: int) -> Held:
            return Held(line, verdict.value, note, tuple(sorted({*rests, *more} - {number})))

        sound = [law for law in (self.law, self.other) if law is not None and not law.broken]
        for law in (None, *sound):
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
        if self.is_open(IMAGINARY) and IMAGINARY in residual.free_symbols:
            unit = residual.xreplace({IMAGINARY: sympy.I})
            for law in (None, *sound):
                found = self.shown(unit, law)
                if found is not None and found[0] is not Verdict.UNDECIDED:
                    more = found[1].removeprefix("where ")
                    where = ", ".join(filter(None, ("i² = −1", more)))
                    rested = law.rests if law is not None else ()
                    return made(Verdict.ASSUMING, f"where {where}", *rested)
            return made(Verdict.UNDECIDED, "i: a number, or the imaginary unit? nothing says")
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

    def either(self, line: Line, left: Expr, right: Expr, other: Expr) -> Held:
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
            if not given.has(*(dotted(x, 2) for x in self.moving)):
                linear = [x for x in given.free_symbols if given.diff(x) != 0 == given.diff(x, 2)]
                solved += [{x: -given.subs(x, 0) / given.diff(x)} for x in sorted(linear, key=str)]
        for put in solved:
            if self.shown(sympy.expand(both.subs(put)), None) is not None:
                said = ", ".join(filter(None, (words_of(meant), "with one of the two signs")))
                law = self.law.rests if put and self.law is not None else frozenset()
                return Held(line, Verdict.ASSUMING.value, f"where {said}", tuple({*rests, *law}))
        refuted = self.neither(left, right, both, two)
        if refuted is not None:
            law = self.law.rests if self.sets and self.law is not None else frozenset()
            return Held(line, Verdict.FALSE.value, refuted, tuple(sorted({*rests, *law})))
        known = self.primitive().union(self.set_to, self.given)
        if isinstance(left, Symbol) and bare(left) not in known:
            return Held(line, PREMISE, f"one of two values of {text(left)}: which is not said")
        return Held(line, Verdict.UNDECIDED.value, "neither of the two signs was shown")

    def neither(self, left: Expr, right: Expr, both: Expr, other: Expr) -> str | None:
        """Numbers at which neither sign of ± is right, where the file says what both have to be."""
        sure = self.law is not None and self.law.lagrangian is not None and not self.law.broken
        found = self.against((both, Integer(0))) if sure else None
        stands = {x for x in both.free_symbols - {left} if bare(x) in self.moving}
        solved = accent(left) and left in (other - left).expand().free_symbols
        if found is None and solved and stands <= right.free_symbols and not functions_of(both):
            found = differ_at((both, Integer(0)), None)
        return found and f"with neither sign: {found.partition('; the')[0].partition(': the')[0]}"

    def refuted(
        self,
        left: Expr,
        right: Expr,
        sides: tuple[Expr, Expr],
        inner: bool,
        made: Callable[..., Held],
    ) -> Held:
        """Numbers for which two sides differ, where nothing in them is open.

        A line is refuted along the motion if it has accelerations, and of what is defined above if
        it speaks of rates; other equations between the same letters may be of a special case.
        """
        typed, sides = sides, (reduced(sides[0]), reduced(sides[1]))
        law, residual, rests = self.law, sides[0] - sides[1], set(self.used)
        symbols = set().union(*(side.free_symbols for side in sides))
        letters = {bare(x) for x in residual.free_symbols}
        closed = self.letters_of(rests) | {TIME}
        by_file = bool(rests) and any(
            self.is_closed(left, right, form, inner) for form in (typed, sides)
        )
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
        if nearly(residual, sides, law.q if law else tuple(self.moving)):
            words = "it holds to the lowest order in the coordinates only: write ≈"
            return made(Verdict.UNDECIDED, words)
        if is_polynomial(sides[1], self.moving) and not is_polynomial(sides[0], self.moving):
            words = "it may be an expansion about another place: write ≈"
            return made(Verdict.UNDECIDED, words)
        if law is not None and along and residual.free_symbols & {*law.highest}:
            at_set = self.where_set(sides) if sure else None
            if at_set is not None:
                return made(Verdict.FALSE, at_set, *law.rests)
            if law.broken:
                words = "forces besides the Lagrangian act: it is not judged"
                return made(Verdict.UNDECIDED, words)
            special = law.misses(symbols) > MOST_MISSING or law.functions - functions_of(*sides)
            # Of what is defined there is no other case that is the same in all its letters.
            other = law.lagrangian is None and (not rests or law.misses(symbols) > 0)
            if special or other or is_linear(residual, law):
                return made(Verdict.UNDECIDED, "a special case of what is above, or a slip?")
            found = differ_at(sides, law)
            if found is not None:
                return made(Verdict.FALSE, found, *law.rests)
        elif by_file and (_differentiates(left) or any(map(accent, symbols | _letters(left)))):
            found = None if functions_of(*sides) else differ_at(sides, None)
            if found is not None:
                return made(Verdict.FALSE, found)
        elif law is not None and along and not by_file:
            where = at_rest(residual, law)
            if where:
                return made(Verdict.ASSUMING, f"where {where}", *law.rests)
            return made(Verdict.UNDECIDED, "it holds for special motions at most: which?")
        elif isinstance(left, Symbol) and left in self.given:
            return made(Verdict.UNDECIDED, "another value than above: of another case, or a slip?")
        return made(Verdict.UNDECIDED, "neither shown nor refuted")

    def is_closed(self, left: Expr, right: Expr, sides: tuple[Expr, Expr], inner: bool) -> bool:
        """Whether the left side says by itself what the right one must be, all under one heading: a
        derivative, or a quantity made of others and written in the same letters."""
        if any(self.places.get(x) != self.section for x in self.used):
            return False
        made = _letters(left) <= {*self.given}
        moving = self.moving | ({TIME} if made and any(map(accent, _letters(left))) else set())
        if not all({bare(x) for x in side.free_symbols} & moving for side in sides):
            return False
        mine, theirs = (side.free_symbols - {TIME} for side in sides)
        here = max(self.places)  # of a chain that gives ℒ the first form is the law
        law = self.law if self.law is not None and self.law.rests <= self.used | {here} else None
        within = {bare(x) for x in theirs} <= {bare(x) for x in mine}.union(
            law.letters if law is not None else ()
        )
        if _differentiates(left):
            return within
        if not isinstance(left, Lettered):
            gives = law is not None and here in law.rests
            return (made or inner) and (mine == theirs or (inner and gives and within))
        known = self.given.get(left)
        if accent(left):  # a derivative, or a rate that stands in the momenta: solved for it
            return (known is not None and theirs <= mine) or (law is not None and left in theirs)
        if law is not None and (known is None or law.rests <= known.rests):
            return within
        told = known is not None and (len(known.rests) > 1 or right.has(*self.given))
        return told and mine == theirs

    def is_other(self, left: Expr, right: Expr, residual: Expr) -> bool:
        """Whether a letter of which something was said stands for something else from here on."""
        if right is None or left not in self.given or accent(left):
            return False
        letters = {bare(x) for x in residual.free_symbols}
        return not letters <= self.letters_of(set(self.given[left].rests)) | {TIME}

    def specially(self, sides: tuple[Expr, Expr]) -> tuple[str, set[int]] | None:
        """Where a line holds for the special motion that was set, the words for that."""
        residual = sides[0] - sides[1]
        if not self.sets:
            return None
        meant = {x: g.value for x, g in self.sets.items()}
        lines = set().union(*(g.rests for g in self.sets.values()))
        words = words_of(meant)
        law, stated = self.law, {x: meant[x] for x, g in self.sets.items() if g.stated}
        tried = [] if law is None or law.broken else [(stated, law), (meant, law)]
        if law is not None and tried and law.lagrangian is not None:
            # What holds a coordinate takes its equation, and leaves the others.
            free = [x not in {bare(y) for y in meant} for x in law.q]
            if any(free) and vanishes(residual.subs(meant)) is None:
                tried.append((meant, replace(law, vanishing=tuple(compress(law.vanishing, free)))))
        for put, law in tried:
            given = tuple(x.subs(put) for x in law.vanishing)
            found = self.shown(residual.subs(put), replace(law, vanishing=given))
            if found is not None and found[0] is not Verdict.UNDECIDED:
                more = found[1].removeprefix("where ") if found[0] is Verdict.ASSUMING else ""
                return ", ".join(filter(None, (words_of(put), more))), lines | law.rests
        if not {*meant}.union(*(x.free_symbols for x in meant.values())) & residual.free_symbols:
            return None
        under = sympy.expand(residual.subs(meant).subs(meant))
        if vanishes(under) is not None:
            left = sympy.expand(sides[0].subs(meant).subs(meant))
            return (words, lines) if vanishes(left) is None else None
        for vanishing in self.law.vanishing if self.law is not None else ():
            given = vanishing.subs(meant).subs(meant)
            if vanishes(given) is not None:
                continue
            divided = lost(under, sympy.expand(given))
            if divided is not None:
                more = "".join(f", {text(x)} ≠ 0" for x in divided)
                return words + more, lines | set(self.law.rests if self.law else ())
        return None

    def where_set(self, sides: tuple[Expr, Expr]) -> str | None:
        """Numbers for what the line just above has set, at which a line does not hold."""
        here, law = max(self.places), self.law
        put = {x: g.value for x, g in self.sets.items() if g.stated}
        if law is None or not any(here - 1 in g.rests for g in self.sets.values()):
            return None
        vanishing = [sympy.expand(x.subs(put)) for x in law.vanishing]
        where = replace(law, vanishing=tuple(x for x in vanishing if vanishes(x) is None))
        left, right = (sympy.expand(side.subs(put)) for side in sides)
        strange = {bare(x) for x in (left - right).free_symbols} - where.letters - {TIME}
        if strange - self.set_to or law.functions or is_linear(left - right, where):
            return None
        found = differ_at((left, right), where)
        return found and f"where {words_of(put)}, {found}"

    @property
    def set_to(self) -> set[Symbol]:
        """The letters that are values of what is set: Ω of φ̇ = Ω."""
        return set().union(*(g.value.free_symbols for g in self.sets.values()))

    def against(self, sides: tuple[Expr, Expr]) -> str | None:
        """Numbers for the special motion that was set, at which a line does not hold."""
        law = self.law
        meant = {x: g.value for x, g in self.sets.items()}
        new = self.set_to
        if law is None or not ({*meant} | new) & (sides[0] - sides[1]).free_symbols:
            return None
        given = [sympy.expand(x.subs(meant).subs(meant)) for x in law.vanishing]
        moved = {dotted(x, 2) for x in law.q}
        given = [x for x in given if not x.has(*moved) and vanishes(x) is None]
        known = {bare(x) for x in (sides[0] - sides[1]).free_symbols} - law.letters
        if len(given) != 1 or not known <= new | {TIME} or functions_of(*sides, *given):
            return None
        linear = [x for x in given[0].free_symbols if not moves(x) and given[0].diff(x, 2) == 0]
        for x in sorted(linear, key=str):
            solved = {x: -given[0].subs(x, 0) / given[0].diff(x)}
            put = [sympy.expand(side.subs(meant).subs(meant)).subs(solved) for side in sides]
            found = (
                None if vanishes(put[0] - put[1]) is not None else differ_at((put[0], put[1]), None)
            )
            if found is not None:
                told = ", ".join(f"{text(y)} = {text(v)}" for y, v in meant.items() if v != 0)
                return f"where {told}, {text(x)} balances: {found}"
        return None

    def shown(self, residual: Expr, law: Law | None) -> tuple[Verdict, str] | None:
        """Whether an expression vanishes, along the motion of a law if there is one, and where:
        for which signs of what is known by its square, and of what stands under a root."""
        vanishing = law.vanishing if law is not None else ()
        a = law.highest if law is not None else []
        if any(accent(x) == "dot" and dotted(x) in residual.free_symbols for x in a):
            vanishing = (*vanishing, *map(self.total, vanishing))
            a = [*a, *map(dotted, a)]
        letters = set().union(*(x.free_symbols for x in (residual, *vanishing)))
        signs = [x for x in self.signs if x in letters]
        if len(signs) > MOST_SIGNS:
            raise NoMeaningError(f"more than {MOST_SIGNS} letters are known by their squares")

        def holds(put: Mapping[Symbol, Expr]) -> Verdict | None:
            return vanishes(residual.xreplace(put), [x.xreplace(put) for x in vanishing], a)

        def turned(k: int) -> tuple[int, ...]:
            return tuple(1 - 2 * (i == k) for i in range(len(signs)))

        found = {
            turns: holds(dict(zip(signs, map(Integer, turns), strict=True)))
            for turns in product((1, -1), repeat=len(signs))
        }
        verdicts = [verdict for verdict in found.values() if verdict is not None]
        if len(verdicts) == len(found):
            where = divided(residual, vanishing, a) if law is not None else ""
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
        for negative in ({}, *({x: -positive[x]} for x in roots if bare(x) in self.moving)):
            put = {**plus, **positive, **negative}
            if roots and holds(put) is not None:
                needed = [
                    y for y in roots if holds({z: v for z, v in put.items() if z != y}) is None
                ]
                said = [f"{text(y)} {'<' if y in negative else '>'} 0" for y in needed]
                said += [f"{text(self.signs[y])} > 0" for y in signs]
                return Verdict.ASSUMING, "where " + ", ".join(sorted(said))
        return None

    def is_open(self, letter: Lettered) -> bool:
        """Whether nothing says what a letter is."""
        said = self.kinds(letter.quantity.glyph)
        return not said and letter not in self.given and letter not in self.moving

    def forced(self, law: Law, residual: Expr, number: int) -> Law:
        """The law with a force besides the Lagrangian, in the equation that names it."""
        for k, vanishing in enumerate(law.vanishing):
            for sign in (1, -1):
                force = sympy.expand(residual - sign * vanishing)
                if not force.free_symbols & {*law.highest}:
                    given = (*law.vanishing[:k], residual, *law.vanishing[k + 1 :])
                    words = "by the equations of motion above"
                    return Law(law.q, given, law.rests | {number}, words, law.section)
        return replace(law, broken=True)

    def is_integral(self, residual: Expr, law: Law) -> bool:
        """Whether an equation between coordinates and rates stays true along the motion."""
        found = residual.free_symbols
        if found & {*law.highest} or not any(dotted(x) in found for x in law.q):
            return False
        shown = self.shown(self.total(residual), law)
        return shown is not None and shown[0] is not Verdict.UNDECIDED

    def premise(
        self, number: int, line: Line, left: Expr, right: Expr, residual: Expr
    ) -> Held | None:
        """What a line brings that is new: a quantity by its square, an equation of motion, what is
        set for a special motion."""
        if right is None:
            return None
        known = self.law.letters if self.law is not None else set()
        here = {number, *self.used}
        law = self.law
        kept = law is not None and law.lagrangian is not None and self.is_integral(residual, law)
        if isinstance(left, Pow) and isinstance(left.base, Lettered) and left.exp.is_Integer:
            letter, value = left.base, self.value(right)
            said = {*self.given, *self.set_to, *known, *value.free_symbols}
            if letter not in said and (kept or bare(letter) not in known):
                root = value ** Rational(1, int(left.exp))
                if left.exp % 2 == 0:
                    sign = sympy.Dummy(f"sign of {letter}", real=True)
                    self.signs[sign] = letter
                    root *= sign
                self.give(letter, root, frozenset(here))
                words = f"what {text(letter)} stands for"
                if kept:
                    words = "an integral of the motion, its constant taken as it stands"
                    assert law is not None
                    self.used |= law.rests
                return Held(line, PREMISE, words, tuple(self.used))
        if isinstance(left, Lettered) and self.is_set(left, right):
            value = self.value(right)
            for k in range(3 - ["", "dot", "ddot"].index(left.quantity.glyph.accent)):
                self.sets[dotted(left, k) if k else left] = Given(
                    value, frozenset(here), self.section, k == 0
                )
                value = Integer(0)
            return Held(line, PREMISE, "a special motion, or value", ())
        if self.defines(right, [left]) and right not in self.primitive():
            self.give(right, self.value(left), frozenset(here), left)
            return Held(line, PREMISE, f"what {text(right)} stands for", tuple(self.used))
        generic = {x for side in (left, right) for x in side.atoms(eq.Rate, eq.Partial)}
        if self.law is not None and any(isinstance(x, eq.Partial) for x in generic):
            if {bare(x) for x in residual.free_symbols} - known:
                self.law = self.forced(self.law, residual, number)
                return Held(line, PREMISE, "Lagrange's equation with a force besides", ())
            return None
        newest = sorted({bare(x) for x in residual.free_symbols if accent(x) == "ddot"}, key=str)
        told = not isinstance(left, Symbol) and left.free_symbols <= {*self.given}
        rates = [x for x in residual.free_symbols if accent(x) == "dot" and not told]
        if not newest and degree(residual, rates) == 1:
            newest = sorted(map(bare, rates), key=str)
        if newest and (self.law is None or not set(newest) <= set(self.law.q)):
            return self.newton(number, line, residual, newest)
        return None

    def newton(
        self, number: int, line: Line, residual: Expr, newest: Sequence[Expr]
    ) -> Held | None:
        """An equation of motion that is taken as it stands."""
        law = self.law
        if law is not None and law.section != self.section:
            law = None
        if law is not None and law.lagrangian is not None:
            return None
        before = law if law is not None else Law((), (), frozenset(), "", self.section)
        q = tuple(dict.fromkeys([*before.q, *newest]))
        vanishing = (*before.vanishing, residual)
        if len(vanishing) > len(q):
            return None
        self.law = Law(
            q, vanishing, before.rests | {number}, "by the equations of motion above", self.section
        )
        return Held(line, PREMISE, "an equation of motion, taken as it stands", ())


def _letters(side: Expr) -> set[Symbol]:
    return set(getattr(side, "free_symbols", ()))


def _differentiates(side: Expr) -> bool:
    return bool(side.atoms(eq.Rate, eq.Partial, eq.Slope)) if isinstance(side, Expr) else False
