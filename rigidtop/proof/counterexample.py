"""Points with numbers at which a claimed relation fails."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import sympy
from sympy import Eq, Expr, Integer, MatrixBase, Symbol
from sympy.core.relational import Relational
from sympy.logic.boolalg import Boolean

from rigidtop.proof import floats
from rigidtop.proof.equation import Equation, Meaning, Underbrace, value
from rigidtop.proof.letters import Letters
from rigidtop.proof.page import Assumption, Check
from rigidtop.theory.symbols import const


@dataclass(frozen=True)
class Counterexample:
    """Values at which a claimed relation fails, and its two sides there (None: undefined).

    Of vectors and matrices these are an `entry` of the sides, from 1: of a matrix row and column.
    """

    values: Mapping[Symbol, Expr]
    left: Expr
    right: Expr
    entry: tuple[int, ...] = ()


ANY = Letters()
"""Letters of which nothing is known."""


def typed_divisors(claimed: Equation, meaning: Meaning) -> list[Expr]:
    """What the equation divides by as it is typed: a division has a condition, loses a branch."""
    sides = [e for side in claimed.sides for e in (side if _is_matrix(side) else [side])]
    powers = set().union(*(side.atoms(sympy.Pow) for side in sides))
    typed = {p.base for p in powers if p.exp.is_number and p.exp < 0 and not p.base.is_number}
    return [value(base, meaning) for base in sorted(typed, key=str)]


def _is_matrix(side: Expr) -> bool:
    return isinstance(side, sympy.MatrixBase)


def assertions(claimed: Equation, meaning: Meaning) -> list[tuple[str, Expr, Expr]]:
    """Neighbouring sides of the chain with their meanings; "= const" as a rate that vanishes."""
    values: list[Any] = []
    for side in claimed.sides:
        values.append(values[-1] if side == const else value(side, meaning))
    pairs = []
    for side, left, right in zip(claimed.sides[1:], values, values[1:], strict=False):
        if side == const:
            pairs.append(("=", meaning[const](left), sympy.Integer(0)))
        else:
            pairs.append((claimed.relation, left, right))
    # What stands under a brace is a claim too, unless it only gives the body a name.
    for brace in set().union(*(side.atoms(Underbrace) for side in claimed.sides)):
        body, label = brace.args
        if label in meaning or not label.is_Symbol:
            pairs.append(("=", value(body, meaning), value(label, meaning)))
    return pairs


def entries(left: Expr | MatrixBase, right: Expr | MatrixBase) -> list[Expr]:
    """The differences that decide: entry by entry for matrices; 0 fits every shape."""
    return [a - b for a, b in _pairs(left, right)]


def _pairs(left: Expr | MatrixBase, right: Expr | MatrixBase) -> list[tuple[Expr, Expr]]:
    shapes = {side.shape for side in (left, right) if _is_matrix(side)}
    if not shapes:
        return [(sympy.sympify(left), sympy.sympify(right))]
    if len(shapes) > 1:
        raise sympy.matrices.exceptions.ShapeError("matrices of different shapes can't be equal")
    if any(not _is_matrix(side) and side != 0 for side in (left, right)):
        raise TypeError("a vector can't equal a number other than 0")
    zeros = [Integer(0)] * math.prod(*shapes)
    rows = [list(side) if _is_matrix(side) else zeros for side in (left, right)]
    return list(zip(*rows, strict=True))


def parted(assuming: Sequence[Assumption]) -> tuple[dict[Expr, Expr], list[Relational]]:
    """Assumptions that are put in (equalities) and those that decide signs."""
    equal: dict[Expr, Expr] = {}
    conditions: list[Relational] = []
    for assumption in assuming:
        condition = assumption.condition
        if isinstance(condition, Eq):
            equal[condition.lhs] = condition.rhs
        else:
            conditions.append(condition)
    return equal, conditions


def imposed_on(expression: Expr, equal: Mapping[Expr, Expr]) -> Any:
    """Put the equalities in, twice, since one may bring in the symbol of another."""
    replaced = set().union(*(old.free_symbols for old in equal))
    for _ in range(2 if equal else 0):
        if expression.free_symbols & replaced:
            expression = expression.subs(equal)
    return expression


def refute(
    check: Check, dropped: Assumption | None = None, tries: int = 600, letters: Letters = ANY
) -> Counterexample | None:
    """A point where the assumptions hold, `dropped` does not, and the claimed relation fails."""
    failure = _failure(check, dropped, tries, letters)
    if failure is None and dropped is None:  # what is tiny may differ as well
        failure = _failure(check, None, FEW, letters, exact=True)
    if failure is None:
        return None
    shapes = [
        next((side.shape for side in (left, right) if _is_matrix(side)), ())
        for _, left, right in assertions(check.claimed, check.meaning)
    ]
    return _counterexample(*failure, shapes)


def is_refuted(check: Check, tries: int, letters: Letters = ANY) -> bool:
    """Whether `refute` finds a point; cheaper, since no exact numbers are made of it."""
    return _failure(check, None, tries, letters) is not None


Failure = tuple[Any, Mapping[Symbol, Expr], Mapping[Symbol, Expr]]
"""The sides of all relations, a point at which one fails, and what the sides' dummies stand for."""


FEW = 20
"""So many points are tried with exact numbers, where floats tell no difference."""


def _failure(
    check: Check, dropped: Assumption | None, tries: int, letters: Letters, exact: bool = False
) -> Failure | None:
    equal, _ = parted(check.assuming)
    if dropped is not None and dropped.otherwise is not None:
        equal = {**equal, dropped.condition.lhs: dropped.otherwise}
    given = [imposed_on(h, equal) for h in check.given]
    solved, left_over, divisor = _solve_given(given)
    found = None
    if dropped is None or not _needed(dropped.condition, divisor):
        found = _search(check, dropped, tries, letters, equal, (solved, left_over, divisor), exact)
    if found is None and solved:
        # Solving divided by something; where that vanishes the equation may hold all the same.
        found = _search(check, dropped, tries, letters, equal, ({}, given, Integer(1)), exact)
    return found


def _search(
    check: Check,
    dropped: Assumption | None,
    tries: int,
    letters: Letters,
    equal: Mapping[Expr, Expr],
    known: tuple[Mapping[Symbol, Expr], Sequence[Expr], Expr],
    exact: bool,
) -> Failure | None:
    """Among points where what is given vanishes, and that by which `solved` divide does not."""
    solved, given, divisor = known
    meaning, hidden = _opaque(check.meaning)
    _, conditions = parted(check.assuming)

    def both(expression: Expr) -> Any:
        return imposed_on(imposed_on(expression, equal), solved)

    hidden = {dummy: both(expression) for dummy, expression in hidden.items()}
    sides = [
        (relation, [(both(a), both(b)) for a, b in _pairs(left, right)])
        for relation, left, right in assertions(check.claimed, meaning)
    ]
    conditions = [c for c in map(both, conditions) if c != sympy.true]
    violated = None if dropped is None else both(dropped.condition)
    if violated == sympy.true or sympy.false in conditions:
        return None
    flat = [e for _, pairs in sides for pair in pairs for e in pair]
    # Where an assumption is dropped, what is then divided by may vanish: the claim says nothing.
    divisors = [] if dropped is None else [both(d) for d in typed_divisors(check.claimed, meaning)]
    extra = [*conditions, *([] if violated in (None, sympy.false) else [violated])]
    gaps = [c.lhs - c.rhs for c in extra]
    everything = [*flat, *gaps, divisor, *given, *divisors]
    # What the relation does not contain is no part of a counterexample to it.
    contained = set().union(*(e.free_symbols for e in everything))
    hidden = {dummy: expression for dummy, expression in hidden.items() if dummy in contained}
    undefined: Failure | None = None
    patience = 20
    for point, number in floats.places(
        everything, hidden=hidden, tries=tries, exists=letters.exists
    ):
        # What is asked of a point first: most are not at places where the rest would count.
        if abs(number(divisor)) < floats.TOLERANCE:
            continue
        if not all(abs(number(h)) < floats.TOLERANCE for h in given):
            continue
        holds = [_holds(c, number(gap)) for c, gap in zip(extra, gaps, strict=True)]
        if holds != [True] * len(conditions) + [False] * (len(extra) - len(conditions)):
            continue
        if any(abs(number(d)) < floats.TOLERANCE for d in divisors):
            # Numbers that differ say more than a division by zero: look on for a while.
            undefined = undefined or (sides, point, hidden)
        elif (exact and _apart(sides, point, hidden)) or (
            not exact
            and (
                _fails(sides, number, undefined_counts=dropped is not None)
                and _apart(sides, point, hidden) is not False
            )
        ):
            return sides, point, hidden
        patience -= undefined is not None
        if patience == 0:
            break
    return undefined


def _opaque(meaning: Meaning) -> tuple[Meaning, dict[Symbol, Expr]]:
    """The meaning with a dummy for every expression, so that typed divisions do not cancel.

    A claim divides where it is typed to divide, also by what its symbols' meanings make zero.
    Sums, integrals and rates need the expressions themselves; with those nothing is hidden.
    """
    if any(callable(m) or isinstance(m, (list, tuple)) for m in meaning.values()):
        return meaning, {}
    hidden: dict[Symbol, Expr] = {}

    def dummy(expression: Expr) -> Expr:
        expression = sympy.sympify(expression)
        if expression.is_Atom:
            return expression
        stand_in = _stand_in(len(hidden))
        hidden[stand_in] = expression
        return stand_in

    used = {
        key: m.applyfunc(dummy) if isinstance(m, sympy.MatrixBase) else dummy(m)
        for key, m in meaning.items()
    }
    return used, hidden


@cache
def _stand_in(count: int) -> Symbol:
    """The same at every search: SymPy remembers what it found out about it."""
    return sympy.Dummy(f"stand_in_{count}", real=True)


def _solve_given(given: list[Expr]) -> tuple[dict[Symbol, Expr], list[Expr], Expr]:
    """Solve the first equation for a symbol that enters linearly, so that points satisfy it.

    Also what is left over, and what was divided by.
    """
    for equation in given:
        for symbol in sorted(equation.free_symbols, key=str):
            if symbol.is_positive:
                continue
            coefficient = equation.diff(symbol)
            if coefficient != 0 and not coefficient.has(symbol):
                rest = equation.subs(symbol, 0)
                left_over = [h for h in given if h is not equation]
                return {symbol: -rest / coefficient}, left_over, coefficient
    return {}, given, sympy.S.One


def _needed(condition: Boolean, divisor: Expr) -> bool:
    """Whether the divisor vanishes where the condition, f ≠ 0, is violated."""
    return isinstance(condition, sympy.Ne) and divisor.subs(condition.lhs, condition.rhs) == 0


_WRITTEN = {"==": "=", "!=": "≠", ">=": "≥", "<=": "≤"}


def _holds(condition: Relational, gap: float) -> bool:
    return floats.holds(_WRITTEN.get(condition.rel_op, condition.rel_op), gap)


def _fails(sides: Any, number: floats.Number, undefined_counts: bool) -> bool:
    for relation, pairs in sides:
        told = []
        for pair in pairs:
            left, right = map(number, pair)
            if math.isnan(left) or math.isnan(right):
                return False
            if math.isinf(left) or math.isinf(right):
                # Where an assumption is dropped, a side that stops being a number is the failure.
                return undefined_counts and math.isinf(left) != math.isinf(right)
            told.append(floats.holds(relation, left - right, 1 + abs(left) + abs(right)))
        if not (any(told) if relation == "≠" else all(told)):
            return True
    return False


DIGITS = 40
"""Where floats say that an equation fails, so many digits are asked before it is refuted."""


def _apart(sides: Any, point: Mapping[Symbol, Expr], hidden: Mapping[Symbol, Expr]) -> bool | None:
    """Whether equal sides differ in many digits: floats tell apart what cancels, and nothing tiny.

    None where they can't be asked: of another relation, or where a side is no number.
    """
    at = {**point, **{dummy: x.xreplace(dict(point)) for dummy, x in hidden.items()}}
    for relation, pairs in sides:
        for left, right in ((_at(a, at), _at(b, at)) for a, b in pairs):
            if relation not in ("=", "≡") or left is None or right is None:
                return None
            gap, size = (sympy.N(x, DIGITS) for x in (left - right, abs(left) + abs(right)))
            if not gap.is_number:
                return None
            if abs(gap) > size * sympy.Float(10) ** (-DIGITS // 2):
                return True
    return False


def _counterexample(
    sides: Any,
    point: Mapping[Symbol, Expr],
    hidden: Mapping[Symbol, Expr],
    shapes: Sequence[tuple[int, ...]],
) -> Counterexample:
    """The first pair of sides that differ visibly, else exactly or are undefined; else any."""
    at = {
        **point,
        **{dummy: expression.xreplace(dict(point)) for dummy, expression in hidden.items()},
    }
    exact = [
        (_at(left, at), _at(right, at), _entry(k, shape))
        for (_, pairs), shape in zip(sides, shapes, strict=True)
        for k, (left, right) in enumerate(pairs)
    ]
    number = floats.at({})
    differ = [each for each in exact if each[0] != each[1] or each[0] is None]
    # A zero that is not seen to be one has digits far behind the point.
    visible = (x for x in differ if None in x or floats.apart(number(x[0]), number(x[1])))
    return Counterexample(dict(point), *next(visible, [*differ, *exact][0]))


def _entry(k: int, shape: tuple[int, ...]) -> tuple[int, ...]:
    """The place of the k-th number of a side, from 1: nothing, a component, row and column."""
    if not shape:
        return ()
    row, column = divmod(k, shape[1])
    return (k + 1,) if 1 in shape else (row + 1, column + 1)


def _at(expression: Expr, point: Mapping[Symbol, Expr]) -> Expr | None:
    number = expression.xreplace(dict(point))
    return None if number.has(sympy.nan, sympy.zoo, sympy.oo) else number
