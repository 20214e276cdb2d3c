"""Expand to an order in what is small, and neglect terms."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import islice
from typing import Any

import sympy
from sympy import Add, Expr, Integer, MatrixBase, Mul, Symbol, factorial

from rigidtop.proof import floats
from rigidtop.proof.algebra import Algebra
from rigidtop.proof.letters import Letters
from rigidtop.proof.moves.conditions import nonzero
from rigidtop.proof.moves.move import (
    Condition,
    Known,
    Move,
    Order,
    Pair,
    Performed,
    RefusedError,
    Scope,
    name_of,
    the_one,
)
from rigidtop.proof.moves.pairs import put_in, said_pairs, scalars
from rigidtop.proof.values import Value, Vector, atoms_of, components, flattened, vanishes
from rigidtop.theory.rates import slopes_at_zero

NEGLECTED = Symbol("neglected")
"""What stands for all that an approximate equation leaves out, if no letter is small in it."""


OF_NO_ORDER = "of what is neglected no order is known: beside what is added it may not be small"

SMALL = Symbol("small", positive=True)
"""What letters that are small together are counted by."""


def expand(move: Move, algebra: Algebra) -> Performed:
    """To an order in a small letter, or in several that are small together."""
    known = the_one(move)
    together = move.by if len(move.by) > 1 else ()
    order = Order(SMALL if together else move.by[0], move.power + 1, together)
    letters = algebra.letters
    algebra = Algebra(letters, put_in(move.using, letters))
    if known.order is not None and replace(known.order, power=order.power) != order:
        raise RefusedError("two small quantities at once: expand in one after the other")
    if known.order is not None and known.order.power <= move.power:
        raise RefusedError(
            "{} holds to O({}^{}) only: its terms of order {} are not known",
            name_of(known),
            known.order.small,
            str(known.order.power),
            str(move.power),
        )

    def series(value: Value) -> Value:
        if isinstance(value, Vector):
            return Vector({atom: series(factor) for atom, factor in value.terms.items()})
        if isinstance(value, MatrixBase):
            return value.applyfunc(series)
        flat, nodes = flattened(value)
        counted = order.counted(flat)
        if not counted.has(order.small):
            return value
        order.lowest(flat)  # where a letter stands in an exponent there is none
        nothing_hidden(flat, known, move.by, algebra.letters)
        made = _series(counted, order)
        for x in move.by:
            _kept_is_larger(flat, made.subs(SMALL, 1), x, move, letters)
        return (made.subs(SMALL, 1) if together else made).xreplace(nodes)

    pairs = [Pair(pair.left, series(pair.right), "≈") for pair in said_pairs(known, algebra)]
    return Performed(tuple(pairs), known.scope, _at_zero(known, move.by), order)


def _at_zero(known: Known, small: Sequence[Expr]) -> tuple[Condition, ...]:
    """What an equation divides by, and takes the logarithm of, where what is small is 0."""
    made = []
    for condition in known.conditions:
        flat, nodes = flattened(condition.expression)
        there = flat.subs(dict.fromkeys(small, 0)).xreplace(nodes)
        if condition.relation in ("≠", ">") and there not in (condition.expression, 0):
            known_so = nonzero(there, ()) if condition.relation == "≠" else there.is_positive
            made += [] if known_so else [replace(condition, expression=there)]
    return tuple(made)


def nothing_hidden(flat: Expr, known: Known, small: Sequence[Expr], letters: Letters) -> None:
    """Raises RefusedError where a letter of an expression changes with what is small.

    Along the motion a law may give a letter that is constant.
    """
    for x in flat.free_symbols:
        laws = letters.means.get(x, Integer(0)).free_symbols
        hidden = letters.made_of(x) | (laws if known.scope is Scope.IDENTITY else set())
        for by in hidden & {*small}:
            raise RefusedError("{} is defined by {}: put its definition in first", x, by)


def stays_small(known: Known, given: Mapping[Expr, Value], letters: Letters) -> None:
    """Raises RefusedError where what is small in an equation need not stay so with values put in.

    The rest that was left out is small for fixed values of all other letters: not where they go to
    zero, or grow, as that becomes small, nor where it is a number, or one of them.
    """
    sizes = {x: size for x, size in known.sizes.items() if x != NEGLECTED}
    if not sizes:
        return
    sides = (side for pair in said_pairs(known, Algebra(letters)) for side in pair.sides)
    standing = {x for side in sides for x in atoms_of(side)}
    for atom, value in given.items():
        if isinstance(value, (Vector, MatrixBase)) or atom not in standing or value == 0:
            continue
        if atom in sizes:
            size = sizes[atom]
            if value.is_number:
                raise RefusedError(f"{{}} is {size} in {{}}: it can't be set", atom, name_of(known))
            others = sorted({*atoms_of(value)} & standing - {atom}, key=str)
            if others and value != letters.means.get(atom):
                raise RefusedError(
                    f"{{}} is {size} in {{}}, whatever {{}} is: it can't be set so",
                    *(atom, name_of(known), others[0]),
                )
        for x, size in sizes.items():
            whole = flattened(_written_out(value, letters, x))[0]
            if atom != x and whole.has(x):
                depths = (depth if size == "small" else -depth for depth in DEPTHS)
                far, near = (_number(whole, (x,), depth) for depth in depths)
                if not abs(near / far - 1) < _SETTLED:
                    raise RefusedError(
                        "with {} = {} it changes with {}: what is left out of {} need not be small",
                        *(atom, value, x, name_of(known)),
                    )


_SETTLED = 1e-3
"""A value no longer changes by more than this share."""

DEPTHS = (10, 12)
"""What is small is 10⁻¹⁰ and 10⁻¹² where its share is looked for."""


def _kept_is_larger(whole: Expr, kept: Expr, small: Symbol, move: Move, letters: Letters) -> None:
    """Raises RefusedError unless what is left out vanishes beside each term that is kept.

    `small` is large instead where what is left out is small for a large one.

    A letter that stands for a ratio, such as ε, becomes small by one of those in it, whichever
    that is: where another term has them too, that becomes small, or large, as well.
    """
    relations = [relation for relation in letters.relations if relation.has(small)]
    relations += [letters.means[small] - small] if small in letters.means else []
    together = (small,) if move.verb == "neglect" else move.by
    sign = -1 if move.verb == "neglect" and move.power > 0 else 1
    depths = [sign * n for n in DEPTHS]
    rest, terms = whole - kept, Add.make_args(sympy.expand(kept))
    for relation in relations:
        for x in sorted(relation.free_symbols & whole.free_symbols - {small}, key=str):
            for solution in _solutions(relation, x):
                left_out = [_number(rest.xreplace({x: solution}), together, n) for n in depths]
                for term in terms:
                    there = term.xreplace({x: solution})
                    sizes = [_number(there, together, n) for n in depths]
                    pairs = zip(left_out, sizes, strict=True)
                    far, near = (abs(a / b) if a != 0 else a for a, b in pairs)
                    if not near < far / 2:
                        raise RefusedError(
                            "with {} = 0 what is left out is not small beside {}", relation, term
                        )


def _solutions(relation: Expr, x: Symbol) -> list[Expr]:
    """A letter by a relation that vanishes, where that is of the first or second degree in it."""
    above = sympy.fraction(sympy.together(relation))[0]
    if not above.is_polynomial(x):
        return []
    degree = sympy.degree(above, x)
    if degree > 2:
        return []
    return [] if degree < 1 else [*sympy.roots(sympy.Poly(above, x))]


def _number(expression: Expr, small: Sequence[Expr], n: int) -> Any:
    """An expression at a point, in many digits, where the letters that are small are 10⁻ⁿ."""
    point = {y: sympy.Rational(floats.somewhere(y, 0)) for y in expression.free_symbols}
    point |= dict.fromkeys(small, sympy.Rational(10) ** -n)
    return sympy.N(expression.xreplace(point), 5 * abs(n), maxn=20 * abs(n))


def _series(counted: Expr, order: Order) -> Expr:
    """The terms below an order, by Taylor, or as far as that has no derivatives by SymPy's series.

    A last derivative that is finite bounds the rest.
    """
    by = order.small
    known = [*islice(slopes_at_zero(counted, by), order.power + 1)]
    if len(known) > order.power:
        terms = (at * by**power / factorial(power) for power, at in enumerate(known[:-1]))
        return sympy.expand(Add(*terms))
    above = sympy.series(counted, by, 0, order.power).removeO()
    if not by.is_nonnegative:
        # SymPy's series holds for a small quantity above zero.
        below = sympy.series(counted, by, 0, order.power, dir="-").removeO()
        if sympy.expand(above - below) != 0:
            raise RefusedError("below {} = 0 the terms are others than above it", by)
    return above


def neglect(move: Move, algebra: Algebra) -> Performed:
    """Leave terms out: the line says ≈.

    The last of `by` is the letter for which they are small: where it is large, `power` being 1, or
    where it is small, `power` being −1.
    """
    known = the_one(move)
    if not move.power:
        raise RefusedError("say where it is small: “…, for large $x$” or “…, for small $x$”")
    left_out = [algebra.value(x) for x in move.by[:-1]]
    for each in (part for value in left_out for part in scalars(value)):
        nothing_hidden(flattened(each)[0], known, move.by[-1:], algebra.letters)
    pairs = []
    conditions: list[Condition] = []
    for pair in said_pairs(known, algebra):
        for k, side in enumerate((pair.left, pair.right)):
            for whole, outside in _sums(side):
                rest = _without(left_out, whole, algebra)
                if rest is None:
                    continue
                if all(vanishes(part) for part in components(rest, Integer(0))):
                    raise RefusedError("nothing is left of a side: what is larger has to stay")
                conditions += _outweighed(left_out, rest, move, algebra.letters)
                for each, kept in zip(scalars(whole), scalars(rest), strict=False):
                    _kept_is_larger(each, kept, move.by[-1], move, algebra.letters)
                rest = outside(rest)
                sides = (rest, pair.right) if k == 0 else (pair.left, rest)
                pairs.append(Pair(*sides, "≈"))
                break
    if not pairs:
        raise RefusedError("what is neglected does not stand there")
    return Performed(tuple(pairs), known.scope, tuple(conditions), Order(NEGLECTED, 1))


def _sums(side: Value) -> Iterator[tuple[Value, Callable[[Value], Value]]]:
    """A side, and sums of which a power is a factor of it, each with what stands around it.

    A small share of a sum is a small share of its powers, and of what they multiply.
    """
    yield side, lambda rest: rest
    for factor in Mul.make_args(side) if isinstance(side, Expr) and side.is_commutative else ():
        base, power = factor.as_base_exp()
        if base.is_Add and power.is_number:
            yield base, partial(_times_power, side / factor, power)


def _times_power(around: Expr, power: Expr, base: Value) -> Value:
    return around * base**power


def _without(terms: Sequence[Value], whole: Value, algebra: Algebra) -> Value | None:
    """A sum without some of its terms, which may be named without their minus."""
    for term in terms:
        signs = [x for x in (1, -1) if _contains(whole, algebra.times(Integer(x), term))]
        if not signs:
            return None
        whole = algebra.total([whole, algebra.times(Integer(-signs[0]), term)])
    return whole


def _outweighed(
    left_out: Sequence[Value], kept: Value, move: Move, letters: Letters
) -> list[Condition]:
    """That terms are small beside the largest of those that are kept, where it is to be said.

    Beside one that is known to be no larger than what is left out, a line claims more than it has:
    of a letter that changes in time the size is not known.  Raises RefusedError.
    """
    letter = move.by[-1]
    if not isinstance(letter, Symbol):
        raise RefusedError("{} is no letter that could be large or small", letter)
    where = "large" if move.power > 0 else "small"

    def terms(value: Value) -> list[tuple[Expr, Expr]]:
        parts = [flattened(part) for part in scalars(value) if part != 0]
        return [
            (t, t.xreplace(nodes))
            for flat, nodes in parts
            for t in Add.make_args(sympy.expand(flat))
        ]

    for term, _ in (t for value in (*left_out, kept) for t in terms(value)):
        # What is large is told by powers: a tangent, a cosine or a growth has no order there.
        large = term.has(letter) and move.power > 0
        if large and not sympy.cancel(letter * term.diff(letter) / term).is_Number:
            raise RefusedError("{} is no power of {}: its size there is not known", term, letter)

    def least(term: Expr) -> int:
        return Order(SMALL, 1).lowest(term.subs(letter, letter * SMALL**-move.power))

    largest = min(least(term) for term, _ in terms(kept))
    conditions = [Condition(letter, where)]
    for term, small in (t for value in left_out for t in terms(value)):
        if least(term) <= largest:
            raise RefusedError("for {} {} it is not small against what is kept", where, letter)
        for other, large in terms(kept):
            known = (term / other).free_symbols <= {letter, *letters.numbers}
            if known and least(term) <= least(other):
                raise RefusedError("for {} {} it is no smaller than {}", where, letter, large)
            if not known and least(other) == largest:
                share = small / large
                if _stays(share, letter, move.power, letters):
                    raise RefusedError(
                        "for {} {} {} is not small beside {}, by what stands on this page",
                        *(where, letter, small, large),
                    )
                conditions.append(Condition(-share if _is_negative(share) else share, "≪"))
    return conditions


def _stays(share: Expr, letter: Symbol, sign: int, letters: Letters) -> bool:
    """Whether a share does not vanish for a large letter, or a small one, by what others are.

    They are what they are defined to be, or what the page solves for.
    """
    whole = _written_out(share, letters, letter)
    if whole == share:
        return False
    far, near = (abs(_number(flattened(whole)[0], (letter,), -sign * n)) for n in DEPTHS)
    return not near < far / 2


def _written_out(value: Expr, letters: Letters, but: Symbol) -> Expr:
    """A value with what letters stand for, by definitions or the page, if that has a letter."""
    values = {x: v for x, v in {**letters.means, **letters.solved}.items() if x != but}

    def expanded(value: Expr) -> Expr:
        for _ in values:  # of letters that are defined by each other there is no end
            value, before = value.xreplace(values), value
            if value == before:
                break
        return value

    known = value.free_symbols & {*values}
    return value.xreplace({x: v for x in known if (v := expanded(values[x])).has(but)})


def _is_negative(term: Expr) -> bool:
    return bool(term.as_coeff_Mul()[0].is_negative)


def _contains(value: Value, term: Value) -> bool:
    """Whether a sum has these terms."""
    if isinstance(value, Vector) != isinstance(term, Vector):
        return False
    if isinstance(value, Vector):
        return all(
            atom in value.terms and _contains(value.terms[atom], factor)
            for atom, factor in term.terms.items()
        )
    here = Add.make_args(sympy.expand(value))
    return all(part in here for part in Add.make_args(sympy.expand(term)))
