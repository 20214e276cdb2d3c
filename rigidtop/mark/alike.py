r"""Which equation of a collection a line is, whatever its letters and however it is solved.

Two lines are alike if one becomes the other, up to a factor, when letters are exchanged one for
one: dots with dots, vectors with vectors, angles with angles.  Its number decides nothing.  That a
line has the form of an equation says what it may be, never that it is right; of letters that
stand alike, as λ₃ and ω₃ in λ₃ω₃, nothing is said.

>>> from rigidtop.notation import OWN
>>> from rigidtop.read.formula import read
>>> [notes] = read(r"\lambda_1\cos\theta\,\Omega^2 - \lambda_3\omega_3\Omega + MgR = 0 \tag{3.57}")
>>> [line] = read(r"Mgl = n(C s - A n\cos\alpha)", OWN)
>>> found = alike(line.equation, [("3.57", notes.equation)])
>>> found.name, found.words
('3.57', 'A for λ₁, M for M, g for g, l for R, n for Ω, α for θ')
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import combinations, islice
from typing import Any

import sympy
from sympy import Add, Expr, Symbol

from rigidtop.proof.equation import At, Equation, Group, Partial, Printed, Rate, Slope, Underbrace
from rigidtop.theory.lettered import known
from rigidtop.theory.symbols import Glyph, const
from rigidtop.typeset.text import text

MOST = 40
"""A line with more terms is compared with none."""

TRIES = 4_000
"""No more letters are tried for one another."""


@dataclass(frozen=True)
class Alike:
    """The equation whose form a line has, and which letter stands for which there."""

    name: str
    letters: tuple[tuple[Symbol, Symbol], ...]

    @property
    def words(self) -> str:
        """The letters in words, those without a dot."""
        return ", ".join(f"{text(mine)} for {text(theirs)}" for mine, theirs in self.letters)


def alike(equation: Equation, others: Iterable[tuple[str, Equation]]) -> Alike | None:
    """The first of the named equations that a line is alike; None where too little is said.

    Fewer than four letters, or neither a function nor a rate, are alike too much.
    """
    for mine in _residuals(equation):
        if not _says_enough(mine):
            continue
        for name, other in others:
            for theirs in _residuals(other):
                found = _renamed(mine, theirs)
                if found is not None:
                    loose = [x for x in found if _base(x) != _base(found[x])]
                    plain = [
                        (a, b)
                        for a, b in found.items()
                        if "dot" not in _glyph(a).accent
                        and not any(
                            a in loose and x != a and _stand_alike(mine, a, x) for x in loose
                        )
                    ]
                    return Alike(name, tuple(sorted(plain, key=lambda pair: text(pair[0]))))
    return None


def _stand_alike(residual: Expr, one: Symbol, other: Symbol) -> bool:
    """Whether two letters may be exchanged, as λ₃ and ω₃ in λ₃ω₃."""
    return bool(residual.xreplace({one: other, other: one}) == residual)


def _base(letter: Symbol) -> tuple[str, str]:
    glyph = _glyph(letter)
    return glyph.base, glyph.sub


def _says_enough(residual: Expr) -> bool:
    letters = residual.free_symbols
    rates = any("dot" in _glyph(x).accent for x in letters)
    return len(letters) >= 4 and (rates or residual.has(sympy.Function, Rate, Partial))


def _residuals(equation: Equation) -> tuple[Expr, ...]:
    """What vanishes by each two sides: a sum of terms without quotients; of matrices nothing."""
    sides = equation.sides
    if equation.relation not in ("=", "≡") or any(isinstance(x, sympy.MatrixBase) for x in sides):
        return ()
    return _differences(tuple(side for side in sides if side != const))


@lru_cache(maxsize=512)
def _differences(sides: tuple[Expr, ...]) -> tuple[Expr, ...]:
    made = []
    for left, right in combinations(sides[:4], 2):
        try:
            over, _ = sympy.fraction(sympy.together(_bare(left) - _bare(right)))
            residual = sympy.expand(over)
        except (TypeError, ValueError, AttributeError):
            continue
        if residual != 0 and len(Add.make_args(residual)) <= MOST:
            made.append(residual)
    return tuple(made)


def _bare(tree: Expr) -> Expr:
    """A tree without what is there for the page only; what is printed otherwise stays one node."""
    if isinstance(tree, (Group, Underbrace)):
        return _bare(tree.args[0])
    if isinstance(tree, At) and all(isinstance(x, Symbol) for x in tree.args):
        return tree.args[0]
    if not tree.args or isinstance(tree, (Partial, Slope, Rate)):
        return tree
    if isinstance(tree, Printed):
        raise TypeError("no scalar of letters")
    return tree.func(*map(_bare, tree.args))


def _glyph(symbol: Symbol) -> Glyph:
    _, quantity = known(symbol)
    return quantity.glyph if quantity is not None else Glyph(symbol.name)


# --- Letters for letters -------------------------------------------------------------------------


def _renamed(mine: Expr, theirs: Expr) -> dict[Symbol, Symbol] | None:
    """Letters for letters that make one the other, up to a number as factor."""
    if len(Add.make_args(mine)) != len(Add.make_args(theirs)):
        return None
    here, there = _signs(mine), _signs(theirs)
    if Counter(here.values()) != Counter(there.values()):
        return None
    letters = sorted(here, key=lambda x: (sum(v == here[x] for v in here.values()), text(x)))
    for found in islice(_maps(letters, here, there, {}), TRIES):
        renamed = mine.xreplace(found)
        factor = sympy.cancel(Add.make_args(renamed)[0] / _partner(renamed, theirs))
        if factor.is_number and factor != 0 and sympy.expand(renamed - factor * theirs) == 0:
            return found
    return None


def _partner(renamed: Expr, theirs: Expr) -> Expr:
    """The term that is the first one of the other but for a number, or 1."""
    first, *_ = Add.make_args(renamed)
    bare = first.as_coeff_Mul()[1]
    return next((x for x in Add.make_args(theirs) if x.as_coeff_Mul()[1] == bare), sympy.Integer(1))


@lru_cache(maxsize=512)
def _signs(residual: Expr) -> Mapping[Symbol, tuple[Any, ...]]:
    """Of each letter how it stands in the terms: what another must have in common with it."""
    made: dict[Symbol, tuple[Any, ...]] = {}
    terms = [term.as_coeff_Mul() for term in Add.make_args(residual)]
    least = min(abs(number) for number, _ in terms)
    for letter in residual.free_symbols:
        stands = sorted(
            (str(abs(number) / least), str(_power(term, letter)), len(term.free_symbols))
            for number, term in terms
            if term.has(letter)
        )
        glyph = _glyph(letter)
        inside = sorted(type(f).__name__ for f in residual.atoms(sympy.Function) if f.has(letter))
        made[letter] = (glyph.accent, glyph.bold, tuple(inside), tuple(stands))
    return made


def _power(term: Expr, letter: Symbol) -> Any:
    """To which powers a letter stands as a factor, and in functions."""
    return sorted(
        (type(base).__name__ if base != letter else "", str(exponent))
        for base, exponent in (f.as_base_exp() for f in sympy.Mul.make_args(term))
        if base.has(letter)
    )


def _maps(
    letters: list[Symbol],
    here: Mapping[Expr, Any],
    there: Mapping[Expr, Any],
    made: dict[Expr, Expr],
) -> Iterator[dict[Symbol, Symbol]]:
    if not letters:
        yield dict(made)
        return
    letter, *rest = letters
    for other, sign in sorted(there.items(), key=lambda pair: _base(pair[0]) != _base(letter)):
        if sign == here[letter] and other not in made.values() and _fits(letter, other, made):
            yield from _maps(rest, here, there, {**made, letter: other})


def _fits(letter: Symbol, other: Symbol, made: Mapping[Expr, Expr]) -> bool:
    """Whether dots agree: θ̇ for α̇ wants θ for α."""
    mine, theirs = (replace(_glyph(x), accent="") for x in (letter, other))
    for one, image in made.items():
        same = replace(_glyph(one), accent="") == mine
        if same != (replace(_glyph(image), accent="") == theirs):
            return False
    return True
