"""Differentiate by a letter, take the rate along the motion, integrate."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from sympy import Expr, MatrixBase, Symbol

from rigidtop.proof import quadrature
from rigidtop.proof.algebra import Algebra
from rigidtop.proof.equation import IntegralOver, Partial, Printed, symbols_of
from rigidtop.proof.moves.conditions import divided_by
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
    the_factor,
    the_one,
)
from rigidtop.proof.moves.orders import NEGLECTED
from rigidtop.proof.moves.pairs import all_pairs, equal_pairs, said_pairs
from rigidtop.proof.values import TIME, Value, Vector, atoms_of, flattened
from rigidtop.theory.rates import slope


def differentiate(move: Move, algebra: Algebra) -> Performed:
    """By a letter, or by each of several."""
    known = the_one(move)
    made: list[Pair] = []
    for by in move.by:
        _may_differentiate(known, by, algebra)
        for pair in _smooth_pairs(known, algebra):
            if not isinstance(pair.left, Symbol):
                continue
            held = algebra.letters.arguments(pair.left)
            if by not in held:
                raise RefusedError("{} is no function of {}", pair.left, by)
            slope = _slope(pair.right, by, held, move, algebra)
            made.append(Pair(Partial(pair.left, by), slope))
    if not made:
        raise RefusedError(
            "{} does not give a letter as a function: solve it for one", name_of(known)
        )
    return Performed(tuple(made), known.scope, order=_lowered(known, move.by))


def _smooth_pairs(known: Known, algebra: Algebra) -> list[Pair]:
    """The pairs that may be differentiated: also what was expanded, as its remainder is smooth."""
    if known.order is None or known.order.small == NEGLECTED:
        return equal_pairs(known, algebra)
    return said_pairs(known, algebra)


def _lowered(known: Known, by: Collection[Expr]) -> Order | None:
    """The order of the derivative of what is left out, one less where a small letter changes."""
    order = known.order
    if order is None or not {*by} & {*order.letters}:
        return order
    return replace(order, power=order.power - 1)


def _may_differentiate(known: Known, by: Expr, algebra: Algebra) -> None:
    """Raises RefusedError where an equation does not say what happens as a letter changes alone."""
    if not isinstance(by, Symbol):
        raise RefusedError("{} is no letter to differentiate by", by)
    if known.scope is not Scope.IDENTITY:
        holds = "where something is set" if known.scope is Scope.SET else "along the motion only"
        raise RefusedError(
            "{} holds {}: it can't be differentiated by {}, of which it says nothing elsewhere",
            name_of(known),
            holds,
            by,
        )
    if by in known.tied:
        raise RefusedError(
            "{} holds where {} is set, or tied to other letters: it can't be differentiated by it",
            name_of(known),
            by,
        )
    small = () if known.order is None else known.order.letters
    given = {e.sides[0] for e in known.equations}  # what a line gives, it says what it is made of
    for x in {*small, *(x for e in known.equations for x in symbols_of(e))} - given:
        if by in algebra.letters.numbers & algebra.letters.made_of(x):
            raise RefusedError("{} is defined by {}: put its definition in first", x, by)


def _slope(value: Value, by: Symbol, held: frozenset[Symbol], move: Move, algebra: Algebra) -> Expr:
    """The derivative of a function of what is `held`, but for `by`."""
    if isinstance(value, (Vector, MatrixBase)):
        raise RefusedError("partial derivatives are taken of scalars")
    letters = algebra.letters
    flat, atoms = flattened(value)
    made = slope(flat, by)
    for x in flat.free_symbols - held - {by, TIME}:  # the time is held fixed too
        node = atoms.get(x, x)
        if node in letters.functions and letters.arguments(node) <= held:
            if by in letters.functions[node]:
                _is_function(node, move, algebra)
                made += slope(flat, x) * Partial(node, by)  # the chain rule
        elif not (by in letters.velocities and letters.is_placed(node)):
            raise RefusedError(
                "{} in {} depends on the coordinates and velocities: write it out before you "
                "differentiate by {}",
                node,
                name_of(the_one(move)),
                by,
            )
    return made.xreplace(atoms)


def _is_function(letter: Symbol, move: Move, algebra: Algebra) -> None:
    """Raises RefusedError unless a letter is defined, or cited, as a function of its arguments.

    Its slope may be cited instead.
    """
    letters = algebra.letters
    of = letters.arguments(letter)
    others = {x for x in letters.functions if x in letters.defined and letters.arguments(x) <= of}
    if letters.defined.get(letter, {letter}) <= of | (others - {letter}):
        return
    for pair in (p for known in move.cited for p in all_pairs(known, algebra)):
        for one, other in ((pair.left, pair.right), (pair.right, pair.left)):
            named = one == letter or (isinstance(one, Partial) and one.args[0] == letter)
            if named and {*atoms_of(other)} <= of | {letter}:
                return
    raise RefusedError("{} is a function of others only if that is cited", letter)


def rate(move: Move, algebra: Algebra) -> Performed:
    """Along the motion; of vectors as seen from space, or from the body."""
    known = the_one(move)
    frame = move.by[0] if move.by else None
    if known.scope is Scope.SET:
        raise RefusedError(
            "{} holds where something is set, at a moment: its rate does not follow", name_of(known)
        )
    pairs = []
    for pair in _smooth_pairs(known, algebra):
        for side in pair.sides:
            for letter in algebra.letters.functions.keys() & {*atoms_of(side)}:
                _is_function(letter, move, algebra)
        pairs.append(Pair(algebra.rate(pair.left, frame), algebra.rate(pair.right, frame)))
    order = known.order
    changing = {*(() if order is None else order.letters)} - algebra.letters.numbers
    return Performed(tuple(pairs), known.scope, order=_lowered(known, changing))


def along(move: Move, algebra: Algebra) -> Performed:
    """By a letter that changes along the motion: du/dφ = u̇/φ̇."""
    known, by = the_one(move), algebra.value(the_factor(move))
    if known.scope is Scope.SET:
        raise RefusedError("{} holds at a moment: its derivative does not follow", name_of(known))
    pairs = [
        Pair(algebra.slope(pair.left, by), algebra.slope(pair.right, by))
        for pair in equal_pairs(known, algebra)
    ]
    return Performed(tuple(pairs), known.scope, divided_by(algebra.rate(by), move.where))


def integrate(move: Move, algebra: Algebra) -> Performed:
    """Over time: what has no rate is constant.  A line that says more is tried by its rate."""
    for known in move.of:
        if known.scope is Scope.SET:
            raise RefusedError("{} holds at a moment: it can't be integrated", name_of(known))
    if move.power:
        return _time(the_one(move), move, algebra)
    starts = tuple(Condition(e.sides[0] - e.sides[1], "start") for e in move.by)
    pairs = tuple(pair for known in move.of for pair in equal_pairs(known, algebra))
    return Performed(pairs, Scope.MOTION, starts)


def integrate_over(move: Move, algebra: Algebra) -> Performed:
    """Over a letter, from where it is 0."""
    by, *starts = move.by
    over_time = integrate(replace(move, by=tuple(starts)), algebra)
    return replace(over_time, conditions=(Condition(by, "start"), *over_time.conditions))


def _time(known: Known, move: Move, algebra: Algebra) -> Performed:
    """The time from one value of a letter to another: of ẋ = f(x) the integral of dx/f(x).

    On the way f must not vanish: there the letter would rest, or turn back.
    """
    begin, end = move.by
    letter = begin.sides[0]
    if end.sides[0] != letter:
        raise RefusedError("from one value of {} to another, not of {}", letter, end.sides[0])
    low, high = algebra.value(begin.sides[1]), algebra.value(end.sides[1])
    rate = algebra.rate(algebra.value(letter))
    pairs: list[Pair] = []
    conditions: list[Condition] = [Condition(letter - low, "start")]
    for pair in equal_pairs(known, algebra):
        if pair.left != rate:
            continue
        allowed = algebra.letters.numbers | {letter}
        if pair.right.atoms(Printed) or not pair.right.free_symbols <= allowed:
            raise RefusedError("{} is no function of {} alone", rate, letter)
        if not quadrature.is_passed(IntegralOver(letter, low, high, 1 / pair.right)):
            raise RefusedError("on the way {} rests, turns back or goes the other way", letter)
        time = algebra.integrated(letter, low, high, 1 / pair.right)
        pairs.append(Pair(TIME, time))
        conditions += divided_by(pair.right, move.where)
    if not pairs:
        raise RefusedError("{} does not say what {} is", name_of(known), rate)
    return Performed(tuple(pairs), Scope.SET, tuple(conditions))
