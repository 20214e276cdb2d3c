"""Why a line of somebody's notes holds, or does not: one reason after the other.

What it says is compared with all that the lines above say.  The first reason that has something to
say of two sides decides: they are equal; for a special motion that was set; they say something
new; numbers tell them apart.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import compress, product
from typing import Any

import sympy
from sympy import Add, Expr, Integer, Pow, Symbol
from sympy.core.function import AppliedUndef

from rigidtop.mark.case import Case, Held, letters
from rigidtop.mark.law import (
    MOST_MISSING,
    TIME,
    Law,
    accent,
    are_proportional,
    at_rest,
    bare,
    base,
    differ_at,
    divided,
    dots,
    dotted,
    force_in,
    functions_of,
    is_linear,
    is_polynomial,
    lost,
    may_vanish,
    moves,
    nearly,
    reduced,
    vanishes,
    words_of,
)
from rigidtop.mark.ledger import Ledger
from rigidtop.notation.convention import own
from rigidtop.proof import equation as eq
from rigidtop.proof.equation import NoMeaningError
from rigidtop.proof.verdict import Verdict
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.symbols import Glyph
from rigidtop.typeset.text import text

MOST_SIGNS = 3
"""So many letters of a line may be known by their squares alone."""

IMAGINARY = own(Glyph("i"))


@dataclass
class Reasons(Ledger):
    """What the lines above say of two sides."""

    @property
    def sound(self) -> list[Law]:
        return [law for law in (self.law, self.other) if law is not None and not law.broken]

    @property
    def sure(self) -> bool:
        """Whether there is a Lagrangian, and no force besides."""
        return self.law is not None and self.law.lagrangian is not None and not self.law.broken

    @property
    def meant(self) -> dict[Symbol, Expr]:
        """What is set for a special motion."""
        return {x: g.value for x, g in self.sets.items()}

    @property
    def set_to(self) -> set[Symbol]:
        """The letters that are values of what is set: Ω of φ̇ = Ω."""
        return set().union(*(g.value.free_symbols for g in self.sets.values()))

    def is_open(self, letter: Lettered) -> bool:
        """Whether nothing says what a letter is."""
        said = self.kinds(letter.quantity.glyph)
        return not said and letter not in self.given and letter not in self.moving

    # --- why a line holds --------------------------------------------------------------------

    def follows(self, case: Case) -> Held | None:
        for law in (None, *self.sound):
            found = self.shown(case.residual, law)
            if found is None:
                continue
            verdict, where = found
            if law is not None and law.condition and verdict is not Verdict.UNDECIDED:
                return case.assuming(law.condition, where, law=law)
            if law is not None:
                return case.said(verdict, where or law.words, law)
            if not case.rests and case.left == case.right:
                return case.undecided("it says nothing: both sides are the same")
            said = "by what is said above" if case.rests else "whatever its letters are"
            return case.said(verdict, where or said)
        return None

    def imaginary(self, case: Case) -> Held | None:
        if not self.is_open(IMAGINARY) or IMAGINARY not in case.residual.free_symbols:
            return None
        for law in (None, *self.sound):
            found = self.shown(case.residual.xreplace({IMAGINARY: sympy.I}), law)
            if found is not None and found[0] is not Verdict.UNDECIDED:
                return case.assuming("i² = −1", found[1], law=law)
        return case.undecided("i: a number, or the imaginary unit? nothing says")

    def specially(self, case: Case) -> Held | None:
        """It holds for the special motion that was set."""
        if not self.sets:
            return None
        meant, law = self.meant, self.law
        on = replace(case, rests=case.rests.union(*(g.rests for g in self.sets.values())))
        stated = {x: meant[x] for x, g in self.sets.items() if g.stated}
        tried = [] if law is None or law.broken else [(stated, law)]
        if law is not None and tried and law.lagrangian is not None:
            # What holds a coordinate takes its equation, and leaves the others.
            free = [x not in {bare(y) for y in meant} for x in law.q]
            tried.append((meant, replace(law, vanishing=tuple(compress(law.vanishing, free)))))
        for put, held in tried:
            there = held.where(put)
            found = self.shown(case.where(put).residual, there) if there.vanishing else None
            if found is not None and found[0] is not Verdict.UNDECIDED:
                more = found[1] if found[0] is Verdict.ASSUMING else ""
                return on.assuming(words_of(put), more, law=held)
        if not {*meant, *self.set_to} & case.residual.free_symbols:
            return None
        under = case.where(meant)
        if vanishes(under.residual) is not None:
            return on.assuming(words_of(meant)) if vanishes(under.sides[0]) is None else None
        for vanishing in law.where(meant).vanishing if law is not None else ():
            divided = lost(under.residual, vanishing)
            if divided is not None:
                nonzero = [f"{text(x)} ≠ 0" for x in divided]
                return on.assuming(words_of(meant), *nonzero, law=law)
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

        found = [(put, holds(put)) for put in turned(signs)]
        verdicts = [verdict for _, verdict in found if verdict is not None]
        if len(verdicts) == len(found):
            where = divided(residual, vanishing, a) if law is not None else ""
            return (Verdict.ASSUMING, where) if where else (max(verdicts, key=[*Verdict].index), "")
        if found[0][1] is not None:  # of all signs positive
            others = [[x for x in signs if put[x] < 0] for put, verdict in found if verdict is None]
            needed = [self.signs[x] for each in others if len(each) == 1 for x in each]
            needed = needed or [self.signs[x] for x in signs]
            return Verdict.ASSUMING, "where " + ", ".join(f"{text(x)} > 0" for x in needed)
        if verdicts:
            return Verdict.UNDECIDED, "it holds with the other sign of a root"
        roots = {x for p in residual.atoms(Pow, sympy.Abs, sympy.log) for x in p.free_symbols
                 if not (p.is_Pow and p.exp.is_Integer)} - {*signs}  # fmt: skip
        positive: dict[Symbol, Any] = {x: sympy.Dummy(positive=True) for x in roots}
        plus = dict.fromkeys(signs, Integer(1))
        # What a function of x is where x is negative is not known.
        functions = [f for x in (residual, *vanishing) for f in x.atoms(AppliedUndef)]
        within = set().union(*(f.free_symbols for f in functions))
        turning = [x for x in roots - within if bare(x) in self.moving]
        for negative in ({}, *({x: -positive[x]} for x in turning)):
            put = {**plus, **positive, **negative}
            if roots and holds(put) is not None:
                needed = [
                    y for y in roots if holds({z: v for z, v in put.items() if z != y}) is None
                ]
                said = [f"{text(y)} {'<' if y in negative else '>'} 0" for y in needed]
                said += [f"{text(self.signs[y])} > 0" for y in signs]
                return Verdict.ASSUMING, "where " + ", ".join(sorted(said))
        return None

    def solution(self, number: int, said: Held, letter: Lettered, value: Expr) -> Held:
        """A coordinate as a function of the time is put into what holds along the motion."""
        held = self.other is not None  # what was given before may be kept by a force
        laws = [x for x in (self.law, self.other) if x is not None and (held or not x.broken)]
        if not value.has(TIME) or not any(letter in law.q for law in laws):
            return said
        values = {x: g.value for x, g in self.given.items()}
        left = [(law, law.left_of(values)) for law in laws if letter in law.q]
        for law, residuals in left:
            found = [self.shown(x, None) for x in residuals]
            shown = [x for x in found if x is not None and x[0] != Verdict.UNDECIDED]
            if not shown or len(shown) < len(found):
                continue
            if law.broken:  # by nothing: it moves so by itself
                self.law, self.other = replace(law, broken=False), None
            words = f"it solves {law.words.removeprefix('by ')}"
            case = Case(number, said.line, letter, value, (value, value), frozenset(said.rests))
            where = {law.condition: None, **{x[1]: None for x in shown}}
            if any(where):
                return case.assuming(*where, law=law)
            return case.said(max((x[0] for x in shown), key=[*Verdict].index), words, law)
        law, residuals = left[0]
        new = sorted(value.free_symbols - law.letters - {TIME}, key=str)
        if not residuals or law.broken:
            return said
        of = law.words.removeprefix("by ")
        if new:
            special = f"it solves {of} for special {', '.join(map(text, new))} at most"
            return replace(said, note=f"{said.note}; {special}")
        at = (differ_at((x, Integer(0)), None) for x in residuals)
        numbers = next((f"{each.partition(':')[0]} " for each in at if each is not None), "")
        note = f"another motion, or a slip? {numbers}it does not solve {of}"
        return replace(said, verdict=str(Verdict.UNDECIDED), note=note)

    # --- why a line does not hold ------------------------------------------------------------

    def unbalanced(self, case: Case) -> Held | None:
        """Numbers for the special motion that was set, at which its balance does not hold."""
        law, meant, new = self.law, self.meant, self.set_to
        if law is None or not self.sure or not {*meant, *new} & case.residual.free_symbols:
            return None
        moved = {dotted(x, 2) for x in law.q}
        given = [x for x in law.where(meant).vanishing if not x.has(*moved)]
        known = {bare(x) for x in case.residual.free_symbols} - law.letters
        if len(given) != 1 or not known <= new | {TIME} or functions_of(*case.sides, *given):
            return None
        for x in linear_letters(given[0]):
            if moves(x):
                continue
            solved = {x: -given[0].subs(x, 0) / given[0].diff(x)}
            found = differ_at(case.where(meant).where(solved).sides, None)
            if found is not None:
                said = f"where {words_of(meant)}, {text(x)} balances: {found}"
                return case.said(Verdict.FALSE, said, law)
        return None

    def unknown(self, case: Case) -> Held | None:
        """Nothing says what its letters are, or what it is to be."""
        if case.along or case.closed:
            return None
        if self.law is not None and self.law.broken:
            return case.undecided("forces besides the Lagrangian act: it is not judged")
        known = self.letters_of({*case.rests}) | (self.law.letters if self.law else set())
        strange = sorted({bare(x) for x in case.residual.free_symbols} - known - {TIME}, key=str)
        said = f"says what {', '.join(map(text, strange))} is" if strange else "leads here"
        return case.undecided(f"nothing above {said}")

    def lowest_order(self, case: Case) -> Held | None:
        """It may be meant to hold nearly."""
        if nearly(case.sides, self.law.q if self.law else self.moving):
            return case.undecided("it holds to the lowest order in the coordinates only: write ≈")
        small = [x for x in case.symbols if len(base(x)) > 1 and base(x)[0] in "dΔδ"]
        if nearly(case.sides, small):
            return case.undecided("it holds to the lowest order in differentials only: write ≈")
        left, right = case.sides
        if is_polynomial(right, self.moving) and not is_polynomial(left, self.moving):
            return case.undecided("it may be an expansion about another place: write ≈")
        return None

    def moving_otherwise(self, case: Case) -> Held | None:
        """Its accelerations are not those of the law."""
        law = self.law
        if law is None or not case.along or not case.residual.free_symbols & {*law.highest}:
            return None
        at_set = self.at_set(case) if self.sure else None
        if at_set is not None:
            return case.said(Verdict.FALSE, at_set, law)
        if law.broken:
            return case.undecided("forces besides the Lagrangian act: it is not judged")
        force = force_in(case.residual, law) if self.sure else None
        if force is not None and all(map(rates_of, Add.make_args(force[1]))):
            return case.undecided(
                f"a force besides the Lagrangian in the equation for {text(law.q[force[0]])}, or a "
                "slip? say what d/dt ∂L/∂q̇ − ∂L/∂q is"
            )
        misses = law.misses(case.symbols)
        special = misses > MOST_MISSING or law.functions - functions_of(*case.sides)
        # Of what is defined there is no other case that is the same in all its letters; an equation
        # of motion in other letters than that above is of another motion.
        told = case.rests or differentiates(case.left)
        own = (x for x in law.vanishing if x.has(case.sides[0]))
        alike = case.sides[0] not in law.highest or next(own).free_symbols == case.symbols
        other = law.lagrangian is None and (not told or misses > 0 or not alike)
        if special or other or law.besides - case.symbols or is_linear(case.residual, law):
            return case.undecided("a special case of what is above, or a slip?")
        found = differ_at(case.sides, law)
        return case.said(Verdict.FALSE, found, law) if found is not None else self.open(case)

    def at_set(self, case: Case) -> str | None:
        """Numbers for what the line just above has set, at which a line does not hold."""
        law = self.law
        put = {x: g.value for x, g in self.sets.items() if g.stated}
        above = max(self.places) - 1
        if law is None or not any(above in g.rests for g in self.sets.values()):
            return None
        where, under = law.where(put), case.where(put)
        strange = {bare(x) for x in under.residual.free_symbols} - where.letters - {TIME}
        if strange - self.set_to or law.functions or is_linear(under.residual, where):
            return None
        found = differ_at(under.sides, where)
        return found and f"where {words_of(put)}, {found}"

    def made_otherwise(self, case: Case) -> Held | None:
        """What is defined above is not that."""
        if not case.closed:
            return None
        found = differ_at(case.sides, None)
        if found is not None and case.solvable:
            return case.undecided(f"an equation for its letters, or a slip? {found}")
        return case.said(Verdict.FALSE, found) if found is not None else None

    def resting(self, case: Case) -> Held | None:
        """It is a law's equation without its accelerations, or of another special motion."""
        if self.law is None or not case.along or case.closed:
            return None
        where = at_rest(case.residual, self.law)
        if where:
            return case.assuming(where, law=self.law)
        return case.undecided("it holds for special motions at most: which?")

    def open(self, case: Case) -> Held:
        if isinstance(case.left, Symbol) and case.left in self.given:
            return case.undecided("another value than above: of another case, or a slip?")
        return case.undecided("neither shown nor refuted")

    def refuted(self, case: Case) -> Held:
        """What numbers say of two sides that no reason makes equal.

        A line is refuted along the motion if it has accelerations, and of what is defined above if
        it speaks of rates; other equations between the same letters may be of a special case.
        """
        put = replace(case, sides=(reduced(case.sides[0]), reduced(case.sides[1])))
        known = self.letters_of({*case.rests}) | {TIME}
        along = self.law is not None and {bare(x) for x in put.residual.free_symbols} <= (
            self.law.letters | known
        )
        closed = bool(case.rests) and any(map(self.is_closed, (case, put)))
        closed = closed or self.is_carried_out(put)
        solvable = not closed and self.is_solvable(case)
        put = replace(put, along=along, closed=closed or self.is_general(case), solvable=solvable)
        found = (reason(self, put) for reason in REFUTING)
        return next((each for each in found if each is not None), None) or self.open(put)

    def is_general(self, case: Case) -> bool:
        """Whether a line has so many letters of what is said that it is of no special case.

        Each of the definitions that it rests on takes one letter away; a definition said again, in
        other words, may be that of another thing.
        """
        written = letters(case.left) | letters(case.right)
        given = {x: self.given[x] for x in written if x in self.given}
        if not case.symbols:  # a number of one case, and of another
            return False
        if case.rests & self.doubted or any(x.section != self.section for x in given.values()):
            return False
        known = given.get(case.left)
        written_so = {*self.given} & letters(known.side if known is not None else None)
        again = known is not None and known.side is not None
        again = again and written_so == {*given} - {case.left}
        one, other = case.sides
        if given and are_proportional(one, other):
            return not again or len(given) > 1
        if again:
            return False
        values = [reduced(known.value) for known in given.values()]
        said = {*given}.union(*(x.free_symbols for x in values)) - {*self.signs}
        names = {str(f) for f in functions_of(*values)}
        written = {x for x in written if x.name not in names}
        return written <= said and len(said - written) < len(given)

    def is_solvable(self, case: Case) -> bool:
        """Whether a line may be an equation for its letters, or give the value of one in a unit."""
        if any(isinstance(x, Expr) and x.is_number and x != 0 for x in (case.left, case.right)):
            return True
        one, other = case.sides
        # What is worked out, or said again of a letter, is no equation for others.
        again = case.left.as_base_exp()[0] in self.signs.values()
        if case.left in self.given:  # and not by what was made of it
            of = self.given[case.left].rests
            made = [self.given[x].rests for x in letters(case.right) if x in self.given]
            again = not any(of < each for each in made)
        if again or (case.inner and other != 0):
            return False
        if are_proportional(one, other):
            return False
        return may_vanish(case.residual, self.moving | {TIME})

    def is_carried_out(self, case: Case) -> bool:
        """Whether a derivative is worked out on the right: its highest rate stands there too."""
        mine, theirs = (reduced(side).free_symbols for side in case.sides)
        highest = max(map(dots, mine), default=0)
        rates = any(accent(x) and x in self.given for x in letters(case.left))
        if not highest or not (rates or differentiates(case.left)):
            return False
        here, there = ({bare(x) for x in each} for each in (mine, theirs))
        # A letter of the left side alone, of which nothing was said, may be said by this line.
        known = self.letters_of({*case.rests}) | (self.law.letters if self.law else set())
        within = there <= here <= there | known | {TIME}
        return within and {x for x in mine if dots(x) == highest} <= theirs

    def is_closed(self, case: Case) -> bool:
        """Whether ℒ says by itself what a line must be, all under one heading: a derivative, or a
        quantity made of others and written in the same letters."""
        left, here = case.left, max(self.places)
        if any(self.places.get(x) != self.section for x in case.rests):
            return False
        if not all({bare(x) for x in side.free_symbols} & self.moving for side in case.sides):
            return False
        mine, theirs = (side.free_symbols - {TIME} for side in case.sides)
        # Of a chain that gives ℒ the first form is the law.
        law = self.law if self.law is not None and self.law.rests <= case.rests | {here} else None
        of_law = law.letters if law is not None else frozenset()
        within = {bare(x) for x in theirs} <= {bare(x) for x in mine} | of_law
        if differentiates(left) or law is None:
            return within and differentiates(left)
        if not isinstance(left, Lettered):
            return case.inner and here in law.rests and within
        if accent(left):  # a rate that stands in the momenta: solved for it
            return left in theirs
        known = self.given.get(left)
        return (known is None or law.rests <= known.rests) and within


Reason = Callable[[Reasons, Case], Held | None]

REFUTING: Sequence[Reason] = (
    Reasons.unbalanced,
    Reasons.unknown,
    Reasons.lowest_order,
    Reasons.moving_otherwise,
    Reasons.made_otherwise,
    Reasons.resting,
)
"""What may be said of a line that does not follow, in this order."""


def turned(signs: Sequence[Symbol]) -> list[dict[Symbol, Expr]]:
    """All that signs can be, first all positive."""
    every = product((Integer(1), Integer(-1)), repeat=len(signs))
    return [dict(zip(signs, each, strict=True)) for each in every]


def differentiates(side: Expr) -> bool:
    return bool(side.atoms(eq.Rate, eq.Partial, eq.Slope)) if isinstance(side, Expr) else False


def rates_of(term: Expr) -> set[Symbol]:
    """The velocities that are factors of a term."""
    return {x for x in term.free_symbols if accent(x) == "dot"}


def linear_letters(vanishing: Expr) -> list[Symbol]:
    """The letters for which an equation can be solved at once."""
    found = [x for x in vanishing.free_symbols if vanishing.diff(x) != 0 == vanishing.diff(x, 2)]
    return sorted(found, key=str)
