"""Equations of motion that a file has: what follows by them, and numbers against what does not."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, product
from math import inf, isfinite
from typing import Any

import sympy
from sympy import Add, Expr, Pow, Symbol
from sympy.core.function import AppliedUndef

from rigidtop.notation.convention import own
from rigidtop.proof import bounds, decide, floats
from rigidtop.proof.equation import NoMeaningError
from rigidtop.proof.verdict import Verdict
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.symbols import Glyph
from rigidtop.theory.trig import reduce_trig
from rigidtop.typeset.text import text

MOST_MISSING = 2
"""A line with accelerations that lacks more numbers of the law is of a special case."""

MOST_ROOTS = 4
"""Of more roots not every sign is tried."""

MOST_WITH_ROOTS = 150
"""What has roots and more operations is not expanded: there would be no end to it."""

TIME = own(Glyph("t"))

ANGLES = frozenset("θφψϕϑαβγχ")


_DOTS = ("", "dot", "ddot", "dddot")


def dots(letter: Symbol) -> int:
    """0 for x, 1 for ẋ, 2 for ẍ."""
    return _DOTS.index(accent(letter)) if accent(letter) in _DOTS else 0


def dotted(letter: Lettered, times: int = 1) -> Lettered:
    """ẋ of x, ẍ of ẋ; what comes then has no letter that is written.  Raises NoMeaningError."""
    glyph, count = letter.quantity.glyph, dots(letter) + times
    if glyph.accent not in _DOTS or count >= len(_DOTS):
        raise NoMeaningError("a fourth rate, or of a letter with a hat, is not judged")
    return own(replace(glyph, accent=_DOTS[count]))


def bare(letter: Symbol) -> Symbol:
    """The letter without dots."""
    glyph = letter.quantity.glyph if isinstance(letter, Lettered) else Glyph(letter.name)
    return own(replace(glyph, accent="")) if "dot" in glyph.accent else letter


def base(letter: Expr) -> str:
    """Its letter without index and dots; none of what is no letter."""
    return (
        letter.quantity.glyph.base if isinstance(letter, Lettered) else getattr(letter, "name", "")
    )


def accent(letter: Symbol) -> str:
    return letter.quantity.glyph.accent if isinstance(letter, Lettered) else ""


def moves(x: Symbol) -> bool:
    return "dot" in accent(x) or base(x)[:1] in ANGLES


def functions_of(*expressions: Expr) -> set[Expr]:
    return {f.func for x in expressions for f in x.atoms(AppliedUndef)}


def words_of(meant: Mapping[Symbol, Expr]) -> str:
    """What is set, in words."""
    return ", ".join(f"{text(x)} = {text(v)}" for x, v in meant.items() if accent(x) != "ddot")


@dataclass(frozen=True)
class Law:
    """Equations that hold along the motion: coordinates, what vanishes, and whose lines they are.

    `words` say what they are; `letters` are all that stand in them, `besides` those of forces that
    the Lagrangian has not.  They hold where the `condition` does.
    """

    q: tuple[Lettered, ...]
    vanishing: tuple[Expr, ...]
    rests: frozenset[int]
    words: str
    section: int
    lagrangian: Expr | None = None
    broken: bool = False
    besides: frozenset[Symbol] = frozenset()
    condition: str = ""

    @property
    def functions(self) -> set[Expr]:
        """Functions of which nothing is known."""
        return functions_of(*self.vanishing)

    @property
    def highest(self) -> list[Lettered]:
        """The rates for which the law is solved: ẍ, or ω̇ of an equation of first order."""
        stands = set().union(*(x.free_symbols for x in self.vanishing))
        return [dotted(x, 2 if dotted(x, 2) in stands else 1) for x in self.q]

    def where(self, put: Mapping[Symbol, Expr]) -> Law:
        """The law for a special motion; what says nothing of it falls out."""
        given = (put_in(x, put) for x in self.vanishing)
        return replace(self, vanishing=tuple(x for x in given if vanishes(x) is None))

    def left_of(self, values: Mapping[Symbol, Expr]) -> list[Expr]:
        """What its equations say of coordinates that are functions of the time, of such alone."""
        paths = {
            y: values[y]
            for x in self.q
            if x in values and not {bare(z) for z in values[x].free_symbols} & {*self.q}
            for y in (x, dotted(x), dotted(x, 2))
            if y in values
        }
        left = (put_in(x, paths) for x in self.vanishing if x.has(*paths))
        return [x for x in left if not {bare(z) for z in x.free_symbols} & {*self.q}]

    def misses(self, symbols: set[Symbol]) -> int:
        """How many numbers the equations of the accelerations among symbols have besides these; too
        many where they have coordinates besides."""
        a = [x for x in symbols if accent(x) == "ddot"]
        lost = [x.free_symbols - symbols - {*a, TIME} for x in self.vanishing if x.has(*a)]
        return min(
            (
                MOST_MISSING + 1 if any(bare(x) in self.q for x in each) else len(each)
                for each in lost
            ),
            default=0,
        )

    @property
    def letters(self) -> frozenset[Symbol]:
        return frozenset(bare(x) for each in self.vanishing for x in each.free_symbols) | frozenset(
            self.q
        )


def put_in(side: Expr, put: Mapping[Symbol, Expr]) -> Expr:
    """A side with what is set put in, twice: one may bring in another's letter."""
    made = side.subs(put).subs(put) if put else side
    rooted = any(not p.exp.is_Integer for p in made.atoms(Pow))
    large = rooted and sympy.count_ops(made) > MOST_WITH_ROOTS
    return made if large or not put else sympy.expand(made)


def plain(expression: Expr) -> tuple[Expr, dict[Expr, Symbol]]:
    """Functions of which nothing is known, and their slopes, as numbers at will."""
    nodes = sorted(
        expression.atoms(AppliedUndef, sympy.Derivative, sympy.Subs), key=sympy.default_sort_key
    )
    nodes.sort(key=sympy.count_ops, reverse=True)
    names = {node: sympy.Dummy(f"f{i}", real=True) for i, node in enumerate(nodes)}
    return expression.xreplace(names), names


def written(node: Expr) -> str:
    """A number, a function, or a slope: that of several letters by the places of these.

    >>> U, (x, y) = sympy.Function("U"), sympy.symbols("x y")
    >>> written(U(x)), written(U(x).diff(x, 2)), written(U(x - y).diff(x))
    ('U(x)', 'U″(x)', 'U′(x − y)')
    >>> written(U(x, y).diff(x, y))
    '∂₁₂U(x, y)'
    """
    at = dict(zip(node.variables, node.point, strict=True)) if isinstance(node, sympy.Subs) else {}
    slope = node.expr if at else node
    if not isinstance(slope, sympy.Derivative):
        return text(node) if not at else str(node)
    name, args = text(slope.expr).partition("(")[0], slope.expr.args
    said = ", ".join(text(x.xreplace(at)) for x in args)
    if len(args) == 1:
        return f"{name}{'′″‴⁗'[slope.derivative_count - 1]}({said})"
    by = "".join("₁₂₃₄₅₆₇₈₉"[args.index(x)] for x in slope.variables)
    return f"∂{by}{name}({said})"


def vanishes(
    residual: Expr, given: Sequence[Expr] = (), unknowns: Sequence[Symbol] = ()
) -> Verdict | None:
    """PROVED or SAMPLED where an expression vanishes, perhaps because others do; else None."""
    wanted, *known = plain(sympy.Tuple(residual, *given))[0]
    if not known:
        return decide.evidence(wanted)
    rest = decide.eliminated(wanted, known, unknowns)
    return None if rest is None else decide.evidence(rest[0])


def divided(residual: Expr, given: Sequence[Expr], unknowns: Sequence[Symbol]) -> str:
    """What must not vanish for a line to follow, in words: beside what it divides by itself."""
    flat, names = plain(sympy.Tuple(residual, *given))
    open_to_vanish = {bare(x) for x in unknowns}
    flat = flat.xreplace(
        {
            x: sympy.Dummy(x.name, positive=True)
            for x in flat.free_symbols
            if isinstance(x, Lettered) and not moves(x) and x not in open_to_vanish
        }
    )
    wanted, *known = flat
    found = decide.eliminated(sympy.fraction(sympy.together(wanted))[0], known, unknowns)
    lost = [] if found is None else bounds.divided_by(found[1])
    typed = sympy.fraction(sympy.together(wanted))[1]
    kept = {new: old for old, new in names.items()}
    lost = [x for x in lost if not has_sign(x) and typed.subs(x, 0) != 0]
    # A multiple of one of them is divided by nothing else, which takes long to be seen.
    if not lost or any(
        bounds.follows(sympy.expand_trig(wanted), sympy.expand_trig(one)) for one in known
    ):
        return ""
    return "where " + ", ".join(f"{text(x.xreplace(kept))} ≠ 0" for x in lost)


def has_sign(x: Expr) -> bool:
    """Whether something is never 0, its letters being positive: m₁ + m₂ − m₂ cos² θ is not."""
    for form in (reduce_trig(sign * x, keep) for sign in (1, -1) for keep in ("cos", "sin")):
        squares = [p for p in form.atoms(Pow) if p.exp.is_even]
        if form.xreplace({p: sympy.Dummy(nonnegative=True) for p in squares}).is_positive:
            return True
    return bounds.nonzero(x)


def reduced(side: Expr) -> Expr:
    """A side without what falls out of it: R²sin²φ + R²cos²φ as R², √x(x/√x + y/√x) as x + y."""
    if any(not p.exp.is_Integer for p in side.atoms(Pow)):
        side = sympy.expand(side)
    if not side.has(sympy.sin, sympy.cos) or any(not p.exp.is_nonnegative for p in side.atoms(Pow)):
        return side
    return reduce_trig(side)


def is_polynomial(side: Expr, moving: Iterable[Symbol]) -> bool:
    """Whether a side with more than numbers is a polynomial in what moves."""
    moves = {x for x in side.free_symbols if bare(x) in moving}
    return bool(moves) and side.is_polynomial(*moves)


def degree(residual: Expr, letters: Sequence[Symbol]) -> int:
    over = sympy.fraction(sympy.together(residual))[0]
    if not letters or not over.is_polynomial(*letters):
        return 0
    return int(sympy.Poly(over, *letters).total_degree())


_SMALL = sympy.Dummy("small", positive=True)


def _shrunk(x: Expr, letters: Iterable[Symbol]) -> Expr:
    """An expression where letters and their rates are small: times one small number."""
    found = [y for y in letters if isinstance(y, Lettered)]
    return x.subs({z: _SMALL * z for y in found for z in (y, dotted(y), dotted(y, 2))})


def _of_order(x: Expr, order: int) -> Expr:
    return x.diff(_SMALL, order).subs(_SMALL, 0)


def is_linear(residual: Expr, law: Law) -> bool:
    """Whether a line is linear in what moves and the law is not: it may be of small deviations."""
    put = (sympy.expand(_shrunk(x, law.q)) for x in (residual, *law.vanishing))
    twice = [x.diff(_SMALL, 2) for x in put]
    return twice[0] == 0 and any(x != 0 for x in twice[1:])


def nearly(sides: tuple[Expr, Expr], q: Iterable[Symbol]) -> bool:
    """Whether sides that are polynomials in coordinates and rates agree to their own order."""
    put = [_shrunk(side, q) for side in sides]
    degrees = [sympy.degree(x, _SMALL) for x in put if x != 0 and x.is_polynomial(_SMALL)]
    residual = put[0] - put[1]
    if not degrees or not residual.has(_SMALL):
        return False
    return all(vanishes(_of_order(residual, k)) is not None for k in range(max(1, *degrees) + 1))


def to_first_order(sides: tuple[Expr, Expr], law: Law | None, moving: Iterable[Symbol]) -> str:
    """The letters in which two sides agree to first order, along a law that is at rest where they
    are 0; none where they do not, or where one has more than that order."""
    letters = sorted(law.q if law is not None else moving, key=str)
    given = law.vanishing if law is not None else ()
    put = [_shrunk(x, letters) for x in (*sides, *given)]
    degrees = [sympy.degree(x, _SMALL) for x in put[:2] if x != 0 and x.is_polynomial(_SMALL)]
    if max(degrees, default=0) != 1:
        return ""
    still, first = ([_of_order(x, k) for x in put] for k in (0, 1))
    if any(x.has(sympy.nan, sympy.zoo, sympy.oo, -sympy.oo) for x in (*still, *first)):
        return ""
    if any(vanishes(x) is None for x in (still[0] - still[1], *still[2:])):
        return ""
    residual, a = first[0] - first[1], law.highest if law is not None else []
    if vanishes(residual) is None and vanishes(residual, first[2:], a) is None:
        return ""
    stands = set().union(*(x.free_symbols for x in (*sides, *given)))
    return ", ".join(text(x) for x in letters if stands & {x, *(dotted(x, k) for k in (1, 2))})


def lost(wanted: Expr, given: Expr) -> tuple[Expr, ...] | None:
    """What must not vanish so that wanted = 0 says what given = 0 does; None where it does not.

    The two are multiples of one sum; what they have besides are letters, sines and cosines.
    """
    if not may_be_multiples(wanted, given):
        return None
    found = bounds.lost(wanted, given)
    if any(x.has(Add) for x in found) or not sympy.factor(given).has(Add):
        return None
    return tuple(x for x in found if x.has(sympy.Function))


def are_proportional(one: Expr, other: Expr) -> bool:
    """Whether, as far as numbers tell, one side is the other one times a number that is not 0."""
    pair = plain(sympy.Tuple(one, other))[0]
    ratios = [_over(*floats.values([*pair], k)) for k in range(3)]
    return all(isfinite(x) and x and not floats.apart(x, ratios[0]) for x in ratios)


def _over(one: float, other: float) -> float:
    return one / other if other else inf


def may_be_multiples(one: Expr, other: Expr) -> bool:
    """Whether, as far as numbers tell, the ratio of two is one of factors of a letter each.

    >>> x, y, m = sympy.symbols("x y m")
    >>> may_be_multiples(m * (x + y), (x + y) / sympy.sin(x)), may_be_multiples(x + y, x - y)
    (True, False)
    """
    one, other = plain(sympy.Tuple(one, other))[0]
    letters = sorted(one.free_symbols | other.free_symbols, key=str)
    for half in ({*letters[::2]}, {*letters[: len(letters) // 2]}):
        ratios = []
        for inside, outside in product((0, 1), repeat=2):
            number = floats.at(
                {x: floats.somewhere(x, inside if x in half else outside) for x in letters}
            )
            ratios.append(_over(number(one), number(other)))
        across = ratios[0] * ratios[3], ratios[1] * ratios[2]
        if floats.apart(*across) or not all(map(isfinite, across)):
            return False
    return True


def force_in(residual: Expr, law: Law) -> tuple[int, Expr] | None:
    """Which of the law's equations a line is but for a force, and this on the side of ẍ.

    None where that has terms of the equation itself: these may be a slip of the pen.
    """
    a = law.highest
    for k, vanishing in enumerate(law.vanishing):
        slopes = [(residual.diff(x), vanishing.diff(x)) for x in a if vanishing.has(x)]
        if not slopes or not residual.has(*a):
            continue
        factor = sympy.cancel(slopes[0][0] / slopes[0][1])
        own = sympy.cancel(factor * vanishing)
        force = sympy.expand(sympy.cancel(residual - own))
        terms = [
            {term.as_coeff_Mul()[1] for term in Add.make_args(sympy.expand(each))}
            for each in (force, own)
        ]
        if force != 0 and not force.has(*a) and not terms[0] & terms[1]:
            return k, force
    return None


def at_rest(residual: Expr, law: Law) -> str:
    """The accelerations without which a line is one of the law's equations, in words."""
    for vanishing in law.vanishing:
        a = [dotted(x, 2) for x in law.q if vanishing.has(dotted(x, 2))]
        given = sympy.expand(vanishing.subs(dict.fromkeys(a, 0)))
        divided = lost(residual, given) if given != 0 else None
        if divided is not None:
            words = [f"{text(x)} = 0" for x in a] + [f"{text(x)} ≠ 0" for x in divided]
            return ", ".join(words)
    return ""


def may_vanish(residual: Expr, always: Iterable[Symbol]) -> bool:
    """Whether numbers for its letters may make an expression vanish whatever those are that are
    `always` free, and what stands in a sine or cosine: an equation for these numbers."""
    flat, _ = plain(residual)
    over = sympy.expand(sympy.fraction(sympy.together(flat))[0])
    free = {*always}.union(*(f.free_symbols for f in over.atoms(sympy.sin, sympy.cos)))
    parts: dict[Expr, Expr] = {}
    for term in Add.make_args(over):
        number, rest = term.as_independent(*free, as_Add=False)
        parts[rest] = parts.get(rest, sympy.S.Zero) + number
    bases = (
        {x.as_base_exp()[0] for x in sympy.Mul.make_args(sympy.factor(part))}
        for part in parts.values()
    )
    return all(any(x.is_Add and _has_both_signs(x) for x in each) for each in bases)


def _has_both_signs(part: Expr) -> bool:
    """Whether it does, where some of its letters are negative too."""
    found = set()
    for attempt in range(32):
        letters = sorted(part.free_symbols, key=str)
        negative = {x: -x for k, x in enumerate(letters) if attempt >> k % 5 & 1}
        [number] = floats.values([part.xreplace(negative)], attempt)
        found |= {number > 0} if floats.apart(number, 0) else set()
    return len(found) > 1


def differ_at(sides: tuple[Expr, Expr], law: Law | None) -> str | None:
    """Short numbers at which two sides differ, in words; accelerations are those of the law.

    Functions of which nothing is known, and their slopes, have any numbers there; roots differ with
    either sign.
    """
    vanishing = law.vanishing if law is not None else ()
    if functions_of(sides[0] - sides[1]) - functions_of(*vanishing):
        return None  # nothing binds them
    flat, names = plain(sympy.Tuple(*sides, *vanishing))
    left, right, *given = flat
    a = law.highest if law is not None else []
    free = left.free_symbols | right.free_symbols
    if any(dots(x) > 2 for x in free):
        return None  # a rate of an acceleration is of no file's own
    if not free & {*a}:
        given, a = [], []
    if any(x.diff(y).has(*a) for x in given for y in a):
        return None  # it gives no rates: it is not linear in them
    free = free.union(*(x.free_symbols for x in given))

    signed = [(left.xreplace(put), right.xreplace(put)) for put in of_roots(left - right)]
    angles = {x for x in free if base(x)[:1] in ANGLES and not accent(x)}
    # A length or a mass, whatever its letter, has no short number that is not positive.
    drawn = {x: sympy.Dummy(x.name, positive=True) for x in free if not moves(x)}
    kept = {new: old for old, new in names.items()}
    for point, number in floats.places(
        [left, right], given=given, unknowns=a, angles=angles, drawn=drawn, tries=120
    ):
        if not all(floats.apart(number(one), number(other)) for one, other in signed):
            continue
        solved = {x: v for x, v in point.items() if x in a}
        values = ", ".join(
            f"{written(kept.get(x, x))} = {text(v)}" for x, v in point.items() if x not in solved
        )
        rates = ", ".join(
            f"{text(x)} is {short(v)}" for x, v in solved.items() if (left - right).has(x)
        )
        said = f"{rates} {law.words}; " if law is not None and rates else ""
        sizes = f"the left side is {short(number(left))}, the right side {short(number(right))}"
        return f"at {values}: {said}{sizes}"
    return None


def of_roots(residual: Expr) -> list[dict[Expr, Expr]]:
    """What roots in an expression may be meant to be: each with either sign, |a| and arccos too."""
    found = (x for x in residual.atoms(Pow, sympy.Abs, sympy.acos) if x.free_symbols)
    roots = sorted((x for x in found if x.is_Function or getattr(x.exp, "q", 1) == 2), key=str)
    under = [*dict.fromkeys(x.args[0] for x in roots)][:MOST_ROOTS]
    return [
        {x: -x for x in roots if x.args[0] in negative}
        for k in range(len(under) + 1)
        for negative in combinations(under, k)
    ]


def short(number: Any) -> str:
    return re.sub(r"\.?0+$", "", f"{round(float(number), 6) + 0.0:.6f}").replace("-", "−") or "0"
