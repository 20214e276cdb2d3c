"""What is known not to vanish, and what a division asks for."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import lru_cache

import sympy
from sympy import Dummy, Expr, MatrixBase, Mul, Pow, Rational, Symbol
from sympy.core.relational import Relational

from rigidtop.proof import bounds, floats
from rigidtop.proof.algebra import Algebra
from rigidtop.proof.equation import Equation, IntegralOver, Slope, SumOver, VolumeIntegral
from rigidtop.proof.moves.move import Condition
from rigidtop.proof.values import Value, flattened, vanishes
from rigidtop.theory.trig import reduce_ratio


def divided_by(factor: Expr, conditions: Sequence[Condition]) -> tuple[Condition, ...]:
    """The conditions that a division brings: each factor that may vanish does not."""
    if nonzero(factor, conditions):
        return ()
    flat, nodes = flattened(factor)
    bases = [f.as_base_exp()[0] for f in Mul.make_args(reduce_ratio(flat))]
    bases = [b.args[0] if isinstance(b, sympy.Abs) else b for b in bases]
    made = [b.xreplace(nodes) for b in bases if not b.is_number]
    return tuple(Condition(b, "≠", lost=True) for b in made if not nonzero(b, conditions))


def domain(
    equation: Equation, algebra: Algebra, conditions: Sequence[Condition]
) -> tuple[Condition, ...]:
    """What has to hold for an equation to say something: that its sides are real numbers.

    What stands under a sum or an integral has another value at each place, and is not asked.
    """
    found: list[Condition] = []
    for node in (node for side in equation.sides for node in _outside_sums(side)):
        for value, relation in _bounds_of(node, algebra):
            if isinstance(value, Expr) and value.is_commutative and not value.is_number:
                found += _unless_known(value, relation, (*conditions, *found))
    return tuple(dict.fromkeys(each for each in found if each not in conditions))


def _bounds_of(node: Expr, algebra: Algebra) -> Iterator[tuple[Value, str]]:
    """What of a function's argument has to be ≠, >, or ≥ 0, so that it has a real value."""
    if isinstance(node, Pow):
        power = algebra.value(node.exp)
        if power.is_integer:
            if power.is_negative:
                yield algebra.value(node.base), "≠"
        else:
            yield algebra.value(node.base), "≥" if power.is_positive else ">"
    elif isinstance(node, Slope):
        yield algebra.rate(algebra.value(node.args[1])), "≠"
    elif isinstance(node, sympy.log):
        yield algebra.value(node.args[0]), ">"
    elif isinstance(node, sympy.tan):
        yield sympy.cos(algebra.value(node.args[0])), "≠"
    elif isinstance(node, (sympy.asin, sympy.acos)):
        yield 1 - algebra.value(node.args[0]) ** 2, "≥"


def _unless_known(
    value: Expr, relation: str, conditions: Sequence[Condition]
) -> tuple[Condition, ...]:
    """The condition that a value is ≠, >, or ≥ 0, where this is not known."""
    if relation == "≠":
        return divided_by(value, conditions)
    bound = bounds.positive if relation == ">" else bounds.nonnegative
    is_known = bound(*flat_with(value, conditions, weak=relation == "≥"))
    return () if is_known else (Condition(value, relation),)


def joined(conditions: Sequence[Condition]) -> tuple[Condition, ...]:
    """Conditions with x > 0 in place of x ≥ 0 and x ≠ 0, or −x ≠ 0."""
    apart = {c.expression: c for c in conditions if c.relation == "≠"}
    bounds = {c.expression for c in conditions if c.relation == "≥"}
    made = []
    for each in conditions:
        zero = apart.get(each.expression) or apart.get(-each.expression)
        if each.relation == "≥" and zero is not None:
            made.append(Condition(each.expression, ">", zero.lost))
        elif each.relation != "≠" or not bounds & {each.expression, -each.expression}:
            made.append(each)
    return tuple(dict.fromkeys(made))


def _outside_sums(node: Expr) -> Iterator[Expr]:
    """The parts of a printed tree but for those under a sum or an integral."""
    if not isinstance(node, (SumOver, VolumeIntegral, IntegralOver)):
        yield node
        for part in [*node] if isinstance(node, MatrixBase) else node.args:
            yield from _outside_sums(part)


def nonzero(factor: Expr, conditions: Sequence[Condition]) -> bool:
    """Whether an expression is known not to vanish; what is set to 0 does, whatever its sign."""
    if _is_set_to_zero(factor, conditions):
        return False
    flat, relations = flat_with(factor, conditions)
    return _is_apart(flat, tuple(relations))


@lru_cache(maxsize=20_000)
def _is_apart(flat: Expr, relations: tuple[Relational, ...]) -> bool:
    """Whether an expression in letters alone is known not to vanish where all relations hold."""
    if _vanishes_somewhere(flat, relations):
        return False
    return bounds.nonzero(flat, relations) or any(
        bounds.positive(sign * flat, relations) for sign in (1, -1)
    )


def never_vanishes(expression: Expr, conditions: Sequence[Condition]) -> bool:
    """As `nonzero`, and sooner: not asked where numbers of both signs are drawn.

    Where a condition says ≠, only points count together that are on the same side of it.
    """
    flat, relations = flat_with(expression, conditions)
    seen: dict[tuple[bool, ...], bool] = {}
    for attempt in range(2 * DRAWS):
        point = _drawn(flat, relations, attempt)
        number = floats.at(point)
        height, sides = number(flat), [number(each.lhs) for each in relations]
        if any(x.func is sympy.Gt and not y > 0 for x, y in zip(relations, sides, strict=True)):
            continue
        if math.isfinite(height) and seen.setdefault(tuple(y > 0 for y in sides), height > 0) != (
            height > 0
        ):
            return False
    roots = {r: Dummy(nonnegative=True) for r in expression.atoms(Pow) if r.exp == Rational(1, 2)}
    return nonzero(expression.xreplace(roots), conditions) or _has_no_root(flat, relations)


def _has_no_root(flat: Expr, relations: Sequence[Relational]) -> bool:
    """Whether the discriminant of an expression that is quadratic in a letter is negative."""
    for x in sorted(flat.free_symbols, key=str):
        if flat.is_polynomial(x) and (quadratic := sympy.Poly(flat, x)).degree() == 2:
            a, b, c = quadratic.all_coeffs()
            if bounds.positive(sympy.expand(4 * a * c - b**2), relations):
                return True
    return False


def never_positive(expression: Expr, conditions: Sequence[Condition]) -> bool:
    """Whether an expression is not positive at any point drawn at which conditions hold."""
    flat, relations = flat_with(expression, conditions)
    told = 0
    for attempt in range(4 * DRAWS):
        number = floats.at(_drawn(flat, relations, attempt))
        height = number(flat)
        bound = [number(x.lhs) for x in relations if x.func is sympy.Gt]
        if math.isfinite(height) and all(at > 0 for at in bound):
            told += 1
            if height > 0:
                return False
    return told >= DRAWS // 2


def _drawn(flat: Expr, relations: Sequence[Relational], attempt: int) -> dict[Symbol, float]:
    """A number for each symbol, of either sign unless it has one: then small, or large."""
    symbols = flat.free_symbols.union(*(each.free_symbols for each in relations))
    power = 3 + 6 * (attempt % 2)
    near = {x: floats.somewhere(x, attempt) for x in symbols}
    return {x: at**power if x.is_nonnegative else 3 * at - 3 for x, at in near.items()}


def _is_set_to_zero(factor: Expr, conditions: Sequence[Condition]) -> bool:
    for gap in (c.expression for c in conditions if c.relation == "="):
        for x in gap.free_symbols & factor.free_symbols:
            slope = gap.diff(x)
            if slope.is_number and slope != 0 and vanishes(factor.subs(x, x - gap / slope)):
                return True
    return False


DRAWS, STEPS = 8, 24
"""Points drawn for two of opposite sign, and steps made from one to the other."""


def _vanishes_somewhere(flat: Expr, relations: Sequence[Relational]) -> bool:
    """Whether a zero where all relations hold is found by numbers, sooner than by symbols.

    It lies between two points at which the expression has opposite signs.
    """
    known = [relation.lhs for relation in relations]
    symbols = [*flat.free_symbols.union(*(each.free_symbols for each in known))]
    if not all(map(_is_drawn, symbols)):
        return False

    def value(expression: Expr, x: Sequence[float]) -> float:
        return floats.at(dict(zip(symbols, x, strict=True)))(expression)

    ends: dict[bool, tuple[list[float], float]] = {}
    for attempt in range(DRAWS):
        drawn = [(x.is_positive, floats.somewhere(x, attempt)) for x in symbols]
        point = [at**3 if positive else 3 * at - 3 for positive, at in drawn]
        height = value(flat, point)
        if math.isfinite(height):
            ends[height > 0] = point, height
        if len(ends) == 2:
            break
    else:
        return False
    (low, below), (high, above) = ends[False], ends[True]
    least, stays = floats.TOLERANCE * (above - below), 0
    for _ in range(STEPS):
        share = below / (below - above)
        middle = [a + share * (b - a) for a, b in zip(low, high, strict=True)]
        height = value(flat, middle)
        if abs(height) < least:
            gaps = [value(each, middle) for each in known]
            far = [
                gap if x.func is sympy.Gt else abs(gap)
                for gap, x in zip(gaps, relations, strict=True)
            ]
            far += [abs(at) for at, x in zip(middle, symbols, strict=True) if x.is_nonzero]
            return all(each > LEAST for each in far)
        # An end that stays twice counts half (Illinois), or it would stay for ever.
        if height > 0:
            high, above, below = middle, height, below / 2 if stays < 0 else below
            stays = -1
        else:
            low, below, above = middle, height, above / 2 if stays > 0 else above
            stays = 1
    return False


def _is_drawn(x: Expr) -> bool:
    """Whether a number of any size, or any positive one, is one that a letter can have."""
    either = x.is_nonnegative is None and x.is_nonpositive is None
    return bool(x.is_real and not x.is_integer and (x.is_positive or either))


LEAST = 1e-3
"""What is to differ from zero is this far from it."""


_STRICT = {"≠": sympy.Ne, ">": sympy.Gt}
_WEAK = {**_STRICT, "≥": sympy.Ge}


def flat_with(
    value: Expr, conditions: Sequence[Condition], weak: bool = False
) -> tuple[Expr, list[Relational]]:
    """A value and strict relations, or `weak` ones too; what is no letter is the same in all."""
    asked = _WEAK if weak else _STRICT
    told = [c for c in conditions if c.relation in asked]
    [flat, *known] = flattened(sympy.Tuple(value, *(c.expression for c in told)))[0]
    relations = (asked[c.relation](x, 0) for c, x in zip(told, known, strict=True))
    # What is plainly so, or not so, is no relation: SymPy makes it true or false.
    return flat, [each for each in relations if isinstance(each, Relational)]
