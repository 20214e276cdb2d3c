"""Equations as pairs of values, and what they put in for atoms."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

import sympy
from sympy import Expr, Integer, MatrixBase, Mul, Pow, Symbol

from rigidtop.proof.algebra import Algebra
from rigidtop.proof.equation import Dot, Equation, Printed, Rate, Underbrace
from rigidtop.proof.letters import Letters
from rigidtop.proof.moves.conditions import nonzero
from rigidtop.proof.moves.move import (
    Condition,
    Known,
    Move,
    Pair,
    Performed,
    RefusedError,
    Scope,
    is_equation,
    name_of,
    the_one,
)
from rigidtop.proof.values import Value, Vector, agree, atoms_of, components
from rigidtop.theory.symbols import const


def pairs_of(equation: Equation, algebra: Algebra, chain: bool = False) -> list[Pair]:
    """The neighbouring sides of an equation; of a `chain` any two; "= const" as a rate of 0."""
    values: list[Value] = []
    made: list[Pair] = []
    for side in equation.sides:
        if side == const:
            made.append(Pair(algebra.rate(values[-1]), Integer(0)))
            values.append(values[-1])
            continue
        values.append(algebra.value(side))
    relation = "=" if equation.relation == "≡" else equation.relation
    for j in range(1, len(values)):
        for i in range(j) if chain and relation != "≠" else (j - 1,):
            if equation.sides[j] != const and equation.sides[i] != const:
                made.append(Pair(values[i], values[j], relation))
    return made


def braces_of(equation: Equation, algebra: Algebra) -> list[Pair]:
    """What the braces of an equation say: the body is what stands beneath."""
    braces = {b for side in equation.sides for b in side.atoms(Underbrace)}
    return [Pair(*map(algebra.value, b.args)) for b in sorted(braces, key=str)]


def named_components(pairs: Sequence[Pair], algebra: Algebra) -> list[Pair]:
    """Of vector equations what they say of components that have a letter."""
    made = []
    for pair in pairs:
        vector = single_atom(pair.left) if isinstance(pair.left, Vector) else None
        for (axis, of), letter in algebra.letters.components.items():
            if vector is not None and of == vector[0] and isinstance(pair.right, Vector):
                along = Vector({axis: Integer(1)})
                made.append(Pair(algebra.atom(letter), algebra.dot(along, pair.right)))
    return made


def put_in(known: Sequence[Known], letters: Letters) -> dict[Expr, Value]:
    """What to put in for atoms, so that the equations hold: each equation gives one atom."""
    given: dict[Expr, Value] = {}
    for each in known:
        for equation in each.equations:
            give(equation, each, given, letters)
    return given


def give(equation: Equation, source: Known, given: dict[Expr, Value], letters: Letters) -> None:
    """Put what an equation says of an atom to what is given.  Raises RefusedError."""
    if equation.relation not in ("=", "≡", "≈"):
        raise RefusedError(
            "{} says {}: only an equation can be put in", name_of(source), equation.relation
        )
    algebra = Algebra(letters, given)
    sides = [side for side in equation.sides if side != const]
    if const in equation.sides:
        rates = [algebra.rate(Algebra(letters).value(side)) for side in sides]
        atoms = [atom for rate in rates if (atom := single_atom(rate))]
        if not atoms:
            raise RefusedError(
                "{} says that a sum is constant: differentiate it in time", name_of(source)
            )
        given.update((atom, Integer(0)) for atom, _ in atoms)
    # Each side as what it is; the first that is an atom gives way to the others: a letter before
    # a letter with a positive factor, such as m r̈.
    bare = Algebra(letters)
    raw = [bare.value(side) for side in sides]
    neighbours = [two for sides in pairwise(raw) for two in entries(*sides)]
    for left, right in neighbours:
        both = ((left, right), (right, left))
        for atom, other in (
            *((single_atom(side), other) for side, other in both),
            *((_scaled_atom(side, letters), other) for side, other in both),
            *map(_rooted, both),
            *(map(_factor, both) if source.order is None else ()),
        ):
            if atom is None or atom[0] in given or atom[0] in set(atoms_of(other)):
                continue
            value = algebra.value(other)
            if atom[0] in set(atoms_of(value)):
                continue
            solved = algebra.times(1 / atom[1], value) if atom[1] != 1 else value
            settle(given, atom[0], solved, letters)
            break
        else:
            left_now, right_now = algebra.value(left), algebra.value(right)
            if agree(left_now, right_now):
                continue
            if _differ_by_number(left_now, right_now):
                raise RefusedError("what is cited contradicts itself: see {}", name_of(source))
            raise RefusedError(
                "{} gives no letter to put in: solve it for one first", name_of(source)
            )


def _rooted(sides: tuple[Value, Value]) -> tuple[tuple[Expr, Expr] | None, Value]:
    """What a letter that is positive is, where one side is its power; no atom where it is not."""
    power, other = sides
    is_power = isinstance(power, Pow) and power.base.is_Symbol and power.exp.is_number
    if not (is_power and power.base.is_positive and isinstance(other, Expr)):
        return None, other
    return (power.base, Integer(1)), other ** (1 / power.exp)


def _factor(sides: tuple[Value, Value]) -> tuple[tuple[Expr, Expr] | None, Value]:
    """What a letter of a product is, where the rest of that can't vanish, as in Mb = ma."""
    product, other = sides
    scalar = isinstance(product, Mul) and product.is_commutative and isinstance(other, Expr)
    for x in product.args if scalar and other.is_commutative else ():
        rest = product / x
        if x.is_Symbol and not rest.has(x) and (nonzero(rest, ()) or nonzero(other, ())):
            return (x, rest), other
    return None, other


def entries(left: Value, right: Value) -> Iterator[tuple[Value, Value]]:
    """Two sides, or the entries of two columns, of which one may be 0."""
    columns = [side for side in (left, right) if isinstance(side, MatrixBase) and side.cols == 1]
    one, other = (
        columns[0] * 0 if columns and not isinstance(side, MatrixBase) and side == 0 else side
        for side in (left, right)
    )
    if columns and getattr(one, "shape", None) == getattr(other, "shape", None):
        yield from zip(one, other, strict=True)
    else:
        yield left, right


def where_set(
    conditions: Sequence[Condition], scope: Scope, letters: Letters, backwards: bool = False
) -> dict[Expr, Value]:
    """What has been set, to put in: at all times with its rate.

    Of two letters that are equal the first gives way, or `backwards` the last.
    """
    given: dict[Expr, Value] = {}
    for condition in conditions:
        if condition.relation != "=":
            continue
        found = _solved(Algebra(letters, given).value(condition.expression), backwards)
        if found is None:
            continue
        x, value = found
        settle(given, x, value, letters)
        if scope is not Scope.SET and {*atoms_of(value)} <= letters.numbers:
            while x in letters.rates:
                x = letters.rates[x]
                given[x] = Integer(0)
    return given


def _solved(vanishing: Value, backwards: bool = False) -> tuple[Symbol, Value] | None:
    """A letter of what vanishes, with what it is: one that stands there with a number's factor."""
    if isinstance(vanishing, MatrixBase):
        return None
    if isinstance(vanishing, Vector):
        for x, factor in sorted(
            vanishing.terms.items(), key=lambda term: str(term[0]), reverse=backwards
        ):
            if isinstance(x, Symbol) and factor.is_number and factor != 0:
                rest = {y: other for y, other in vanishing.terms.items() if y != x}
                return x, Vector(rest).times(-1 / factor)
        return None
    for x in sorted(vanishing.free_symbols, key=str, reverse=backwards):
        slope = vanishing.diff(x)
        if slope.is_number and slope != 0:
            return x, x - vanishing / slope
    return None


def at_right_angles(gap: Expr, letters: Letters) -> bool:
    """Whether what is to vanish is a sum of axes of one frame with numbers before them.

    >>> e, f = sympy.symbols("e f")
    >>> at_right_angles(e - f, Letters(frames=((e, f, Symbol("g")),)))
    True
    """
    numbers = sympy.expand(gap).as_coefficients_dict()
    return any({*numbers} <= {*frame} for frame in letters.frames) and any(numbers.values())


def _differ_by_number(left: Value, right: Value) -> bool:
    return any(part.is_number and part != 0 for part in components(left, right))


def settle(given: dict[Expr, Value], atom: Expr, value: Value, letters: Letters) -> None:
    """Put a value in for an atom, also in what is given already."""
    one = Algebra(letters, {atom: value})
    for old in list(given):
        given[old] = one.value(given[old])
    given[atom] = value


def single_atom(value: Value) -> tuple[Expr, Expr] | None:
    """The atom of a value that is a number times one atom."""
    if isinstance(value, Vector):
        [*terms] = value.terms.items()
        if len(terms) == 1 and terms[0][1].is_number and terms[0][1] != 0:
            return terms[0]
        return None
    if isinstance(value, MatrixBase):
        return None
    if not value.is_commutative:
        scalars, factors = value.args_cnc() if isinstance(value, Mul) else ([], [value])
        number = Mul(*scalars)
        return (Mul(*factors), number) if number.is_number and number != 0 else None
    number, atom = value.as_coeff_Mul()
    is_atom = isinstance(atom, (Symbol, Printed))
    return (atom, number) if is_atom and number != 0 else None


def _scaled_atom(value: Value, letters: Letters) -> tuple[Expr, Expr] | None:
    """The atom of a value that is one vector, or one product or rate, times what can't vanish."""
    rates = {*letters.rates.values()}
    if isinstance(value, Vector) and len(value.terms) == 1:
        [(atom, factor)] = value.terms.items()
    elif isinstance(value, Mul):
        made = [f for f in value.args if f.func in _MADE or f in rates]
        if len(made) != 1:
            return None
        [atom], factor = made, value / made[0]
    else:
        return None
    return (atom, factor) if nonzero(factor, ()) else None


_MADE = (Dot, Rate)


def nodes_of(tree: Expr) -> set[Expr]:
    """A tree and everything in it."""
    return set(sympy.preorder_traversal(tree))


def all_pairs(known: Known, algebra: Algebra) -> list[Pair]:
    """Any two sides of every equation."""
    return [p for e in known.equations for p in pairs_of(e, algebra, chain=True)]


def equal_pairs(known: Known, algebra: Algebra) -> list[Pair]:
    """Any two sides of every equation.  Raises RefusedError for another relation, ≈ too."""
    if known.order is not None:
        raise RefusedError("{} is approximate: what is left out of it is not known", name_of(known))
    return [p for p in all_pairs(known, algebra) if is_equation(p)]


def said_pairs(known: Known, algebra: Algebra) -> list[Pair]:
    """The pairs of equal sides, or nearly so; of a chain to a constant without its rate."""
    pairs = []
    for equation in known.equations:
        sides = [side for side in equation.sides if side != const]
        if len(sides) > 1:
            equation = Equation(*sides, relation=equation.relation)
        made = pairs_of(equation, algebra, chain=True)
        pairs += [p for p in made if p.relation == "≈" or is_equation(p)]
    return pairs


def mapped(move: Move, algebra: Algebra, change: Callable[[Value], Value]) -> Performed:
    """The same done with every side of one equation."""
    known = the_one(move)
    pairs = [
        replace(pair, left=change(pair.left), right=change(pair.right))
        for pair in all_pairs(known, algebra)
        if pair.relation in ("=", "≈") or is_equation(pair)
    ]
    return Performed(tuple(pairs), known.scope, order=known.order)


def is_operator(value: Value) -> bool:
    """Whether it is a matrix, by its letter or written out."""
    return isinstance(value, MatrixBase) or (
        not isinstance(value, Vector) and not value.is_commutative
    )


def atom_of(value: Value, typed: Expr) -> Expr:
    """The atom of a value that is `typed`.  Raises RefusedError where it is more."""
    single = single_atom(value)
    if single is None:
        raise RefusedError("{} is nothing to solve for", typed)
    return single[0]


def scalars(value: Value) -> Sequence[Expr]:
    """The factors of a vector, the entries of a matrix, or a scalar itself."""
    if isinstance(value, Vector):
        return tuple(value.terms.values())
    return tuple(value) if isinstance(value, MatrixBase) else (value,)
