"""The judge of somebody's notes: takes one line after the other, and what they say of the next."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import sympy
from sympy import Expr, Integer, Pow, Rational, Symbol

from rigidtop.mark.case import PREMISE, Case, Held, letters
from rigidtop.mark.doubts import doubt
from rigidtop.mark.law import (
    TIME,
    Law,
    accent,
    bare,
    base,
    degree,
    differ_at,
    dots,
    dotted,
    force_in,
    to_first_order,
)
from rigidtop.mark.ledger import LAGRANGIANS, Given
from rigidtop.mark.reasons import MOST_SIGNS, Reasons, turned
from rigidtop.proof import equation as eq
from rigidtop.proof.equation import Equation, NoMeaningError
from rigidtop.proof.verdict import Verdict
from rigidtop.read.formula import Line
from rigidtop.read.values import kind
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.symbols import const
from rigidtop.typeset.text import text

MOST_OPERATIONS, MOST_PUT_IN = 400, 1000
"""An expression as it is written, and with all that is said put in, has no more operations."""

_ORDER: tuple[str, ...] = (
    *(Verdict.PROVED, Verdict.SAMPLED, Verdict.ASSUMING, PREMISE),
    *(Verdict.UNDECIDED, Verdict.FALSE),
)


@dataclass
class Judge(Reasons):
    """Takes one line after the other, and says what the lines above say of it."""

    def take(self, number: int, line: Line) -> Held:
        equation = line.equation
        assert equation is not None
        self.places[number] = self.section
        self.sets = {x: g for x, g in self.sets.items() if self.holds(g.section, g.rests)}
        try:
            if equation.relation not in ("=", "≡", "≈"):
                raise NoMeaningError(f"{equation.relation} is not judged")
            few(equation.sides, MOST_OPERATIONS)
            if equation.relation == "≈":
                found = self.approximate(line, *map(self.named, equation.sides))
            else:
                found = self.judged(number, line, equation)
        except NoMeaningError as error:
            found = Held(line, Verdict.UNDECIDED.value, str(error))
        except (ArithmeticError, TypeError, ValueError) as error:
            said = " ".join(str(error).split())[:80]
            found = Held(line, Verdict.UNDECIDED.value, f"it says nothing to compare ({said})")
        except (AttributeError, LookupError) as error:  # ours; the other lines are judged
            said = f"{type(error).__name__}: {error}".replace("\n", " ")[:80]
            note = f"rigidtop itself fails here, please report it ({said})"
            found = Held(line, Verdict.UNDECIDED.value, note)
        except RecursionError:
            found = Held(line, Verdict.UNDECIDED.value, "nested too deeply")
        said = doubt(self, found) if found.verdict == Verdict.FALSE.value else ""
        if said:
            note = f"{said}: {found.note}"
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
            a, b = self.value(left), self.value(right)
            signs = [x for x in self.signs if x in letters(a) | letters(b)][:MOST_SIGNS]
            shown = [
                to_first_order((a.xreplace(put), b.xreplace(put)), self.law, self.moving)
                for put in turned(signs)
            ]
            found = shown[0] if all(shown) else ""
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
            other = self.case(number, line, first, self.named(twin.sides[-1]))
            return self.either(self.case(number, line, first, others[0]), other)
        if defines:
            made.append(self.defined(number, line, first, others))
            links, inner = links[1:], 1
        made += [
            self.linked(self.case(number, line, left, right, bool(k)))
            for k, (left, right) in enumerate(links, inner)
        ]
        law, known = self.law, self.given.get(first)
        wrong = any(each.verdict == Verdict.FALSE for each in made)
        if defines and wrong and law is not None and base(first) in LAGRANGIANS:
            self.defined(number, line, first, others[-1:])
            self.law, self.other, self.given[first] = law, self.law, known or self.given[first]
        again = isinstance(first, Symbol) and base(first) in LAGRANGIANS and not wrong
        if again and self.other is not None and self.other.condition:  # it is written so now
            self.law, self.other = replace(self.other, condition=""), None
        said = made[1:] if defines and len(made) > 1 and made[0].verdict == PREMISE else made
        worst = max(said, key=lambda each: _ORDER.index(each.verdict))
        if first in self.given and worst.verdict == Verdict.UNDECIDED:
            self.doubted |= self.given[first].rests
        rests = sorted({x for each in made for x in each.rests} - {number})
        return replace(worst, rests=tuple(rests))

    def conserved(self, number: int, found: Held, letter: Symbol, said: bool) -> Held:
        """What a letter stands for, and by Lagrange's equations whether that is conserved.

        `said`: the words say so, and numbers may say otherwise.
        """
        law, known = self.law, self.given[letter]
        moves = any(accent(x) == "dot" for x in letters(known.side))
        if found.verdict != PREMISE or not self.sure or not moves or base(letter) in LAGRANGIANS:
            return found
        assert law is not None
        try:
            rate = self.total(known.value)
            shown = self.shown(rate, law)
        except NoMeaningError:
            return found
        sides = (rate, Integer(0))
        case = Case(number, found.line, letter, Integer(0), sides, frozenset(known.rests))
        if shown is not None and shown[0] in (Verdict.PROVED, Verdict.SAMPLED):
            words = f"{law.words}, {text(letter)} is conserved"
            return case.said(
                shown[0] if said else PREMISE, words if said else f"{found.note}; {words}", law
            )
        if (
            not said
            or self.sets
            or law.functions
            or not {bare(x) for x in rate.free_symbols} <= law.letters
        ):
            return found
        differs = differ_at(sides, law)
        if differs is None:
            return found
        words = f"d{text(letter)}/dt is not 0: {differs}"
        return case.said(Verdict.FALSE, words, law)

    def named(self, side: Expr) -> Expr:
        """V for V(x, θ), of which nothing was said above, and θ̇ for θ̇(t)."""
        if not isinstance(side, eq.At) or side.args[0] in self.given:
            return side
        letter, *of = side.args
        known = self.moving | {TIME}
        many = len(of) > 1 or accent(letter)
        times = all(isinstance(x, Symbol) and bare(x) in known for x in of)
        return letter if many and times else side

    def defines(self, first: Expr, others: Sequence[Expr]) -> bool:
        """Whether a line says what a letter stands for, of which nothing was said above."""
        if not isinstance(first, Lettered) or kind(first) != "scalar" or others[0] == const:
            return False
        if dots(first) or self.by_law(first) is not None:
            return False
        if first in self.set_to:
            return False
        known = self.given.get(first)
        if known is not None:
            free = not self.holds(known.section, known.rests)
            return free and first not in letters(others[0])
        if first in self.primitive() and self.is_set(first, others[-1]):
            return False
        found = set[Symbol]().union(*map(letters, others))
        made = (self.given[x].value.free_symbols for x in found if x in self.given)
        return first not in found.union(*made)

    def defined(self, number: int, line: Line, first: Lettered, others: Sequence[Expr]) -> Held:
        known = self.given.get(first)
        if known is not None and not self.holds(known.section, known.rests):
            given = self.given.items()
            self.given = {x: g for x, g in given if self.holds(g.section, g.rests)}
            if self.law is not None and not self.holds(self.law.section, self.law.rests):
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
        said = Held(line, PREMISE, f"what {text(first)} stands for", tuple(sorted(used)))
        return self.solution(number, said, first, value)

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
        energies = {base(x): x for x in letters(side)}
        kinetic, potential = energies.get("T"), energies.get("V", energies.get("U"))
        two = {*energies.values()} == {kinetic, potential}
        if two and sympy.expand(self.bare(side)) == sympy.Add(kinetic, potential):
            said = f"a Lagrangian is {text(kinetic)} − {text(potential)}"
            return Held(line, Verdict.FALSE.value, f"{said}: the sign of the potential")
        rests = tuple(sorted(law.rests - {number}))
        return Held(line, PREMISE, "the Lagrangian of the equations that follow", rests)

    def case(self, number: int, line: Line, left: Expr, right: Expr, inner: bool = False) -> Case:
        """Two sides with all that is said put in; of what is constant the rate, and 0."""
        self.used = set()
        if right is None:
            sides = (self.total(self.value(left)), Integer(0))
        else:
            sides = (self.value(left), self.value(right))
        few(sides, MOST_PUT_IN)
        return Case(number, line, left, right, sides, frozenset(self.used), inner)

    def positive(self, case: Case) -> Case:
        """With letters that are known by their squares as roots."""
        plus = dict.fromkeys(self.signs, Integer(1))
        return replace(case, sides=tuple(side.xreplace(plus) for side in case.sides))

    def linked(self, case: Case) -> Held:
        """The first reason that has something to say; letters known by squares are positive."""
        put = self.positive(case)
        reasons = (self.imaginary, self.specially, self.premise, self.another, self.refuted)
        found = (reason(put) for reason in reasons)
        return self.follows(case) or next(each for each in found if each is not None)

    def another(self, case: Case) -> Held | None:
        """A letter of which something was said stands for something else from here on."""
        left, right = case.left, case.right
        if right is None or left not in self.given or accent(left):
            return None
        known = self.letters_of({*self.given[left].rests}) | {TIME}
        if {bare(x) for x in case.residual.free_symbols} <= known:
            return None
        self.give(left, self.value(right), case.rests | {case.number})
        if self.law is not None and self.law.rests & case.rests:
            self.law, self.sets = None, {}
        return Held(case.line, PREMISE, f"what {text(left)} stands for, another than above")

    def either(self, one: Case, two: Case) -> Held:
        """One of two lines that ± makes: where it does not hold the other one has to."""
        shown = self.shown(one.residual, None)
        if shown is not None and shown[0] is not Verdict.UNDECIDED:
            return one.said(shown[0], shown[1] or "by what is said above")
        both = replace(one, sides=(one.residual * two.residual, Integer(0)))
        sign = "one of the two signs is meant"
        if self.shown(both.residual, None) is not None:
            return both.assuming(sign)
        found = self.specially(both)
        if found is not None:
            return replace(found, note=f"{found.note}, {sign}")
        put = replace(self.positive(both), closed=self.is_general(one))
        refuted = self.unbalanced(both) or self.made_otherwise(put)
        if refuted is not None:
            said = refuted.note.partition("; the")[0].partition(": the")[0]
            return replace(refuted, note=f"with neither sign: {said}")
        left = one.left
        known = self.primitive().union(self.set_to, self.given)
        if isinstance(left, Symbol) and bare(left) not in known:
            return Held(one.line, PREMISE, f"one of two values of {text(left)}: which is not said")
        return one.undecided("neither of the two signs was shown")

    def forced(self, law: Law, residual: Expr, number: int) -> Law | None:
        """The law with a force besides the Lagrangian, in the equation that names it."""
        found = force_in(residual, law)
        if found is None:
            strange = {bare(x) for x in residual.free_symbols} - law.letters
            return replace(law, broken=True) if strange else None
        k, force = found
        given = (*law.vanishing[:k], residual, *law.vanishing[k + 1 :])
        return replace(
            law,
            vanishing=given,
            rests=law.rests | {number},
            words="by the equations of motion above",
            besides=law.besides | force.free_symbols,
        )

    def is_integral(self, residual: Expr, law: Law) -> bool:
        """Whether an equation between coordinates and rates stays true along the motion."""
        found = residual.free_symbols
        if found & {*law.highest} or not any(dotted(x) in found for x in law.q):
            return False
        shown = self.shown(self.total(residual), law)
        return shown is not None and shown[0] is not Verdict.UNDECIDED

    def premise(self, case: Case) -> Held | None:
        """What a line brings that is new: a quantity by its square, an equation of motion, what is
        set for a special motion."""
        line, left, right, residual = case.line, case.left, case.right, case.residual
        if right is None:
            return None
        known = self.law.letters if self.law is not None else set()
        here = {case.number, *self.used}
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
            for k in range(3 - dots(left)):
                self.sets[dotted(left, k) if k else left] = Given(
                    value, frozenset(here), self.section, k == 0
                )
                value = Integer(0)
            return Held(line, PREMISE, "a special motion, or value", ())
        if self.defines(right, [left]) and right not in self.primitive():
            self.give(right, self.value(left), frozenset(here), left)
            return Held(line, PREMISE, f"what {text(right)} stands for", tuple(self.used))
        if law is not None and law.lagrangian is not None and has_slopes(left, right):
            forced = self.forced(law, residual, case.number)
            self.law = forced or law
            words = "Lagrange's equation with a force besides"
            return Held(line, PREMISE, words, ()) if forced is not None else None
        if isinstance(left, Symbol) and self.is_initial(left, case.sides[1]):
            return Held(line, PREMISE, "a velocity, always or at the start: which is not said")
        newest = sorted({bare(x) for x in residual.free_symbols if accent(x) == "ddot"}, key=str)
        told = not isinstance(left, Symbol) and left.free_symbols <= {*self.given}
        rates = [x for x in residual.free_symbols if accent(x) == "dot" and not told]
        if not newest and degree(residual, rates) == 1:
            newest = sorted(map(bare, rates), key=str)
        if self.is_carried_out(case):
            return None
        if newest and (self.law is None or not set(newest) <= set(self.law.q)):
            return self.newton(case, newest)
        return None

    def newton(self, case: Case, newest: Sequence[Expr]) -> Held | None:
        """An equation of motion that is taken as it stands."""
        law = self.law
        if law is None or not self.holds(law.section, law.rests):
            law = Law((), (), frozenset(), "by the equations of motion above", self.section)
        q = tuple(dict.fromkeys([*law.q, *newest]))
        if law.lagrangian is not None or len(law.vanishing) == len(q):
            return None
        vanishing = (*law.vanishing, case.residual)
        self.law = replace(law, q=q, vanishing=vanishing, rests=law.rests | {case.number})
        return Held(case.line, PREMISE, "an equation of motion, taken as it stands", ())


def few(sides: Iterable[Expr], most: int) -> None:
    """Raises NoMeaningError for what SymPy would work at for minutes."""
    if any(sympy.count_ops(x) > most for x in sides if not isinstance(x, sympy.MatrixBase)):
        raise NoMeaningError(f"more than {most} operations")


def has_slopes(*sides: Expr) -> bool:
    return any(side.has(eq.Partial) for side in sides)
