"""Moves, performed: the verb that a move names, and what is put in besides."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import sympy
from sympy import Dummy, Expr, Integer, MatrixBase, Mul, Tuple

from rigidtop.proof.algebra import Algebra
from rigidtop.proof.equation import Dot, NoMeaningError, Rate
from rigidtop.proof.letters import Letters
from rigidtop.proof.moves import (
    arithmetic,
    calculus,
    functions,
    operators,
    orders,
    setting,
    signs,
    solving,
)
from rigidtop.proof.moves.conditions import nonzero
from rigidtop.proof.moves.move import (
    Known,
    Move,
    Order,
    Pair,
    Performed,
    RefusedError,
    Scope,
    name_of,
)
from rigidtop.proof.moves.orders import NEGLECTED, OF_NO_ORDER
from rigidtop.proof.moves.pairs import (
    at_right_angles,
    is_operator,
    nodes_of,
    put_in,
    scalars,
    single_atom,
    where_set,
)
from rigidtop.proof.values import Value, Vector, atoms_of, components, flattened, tree, vanishes
from rigidtop.theory.trig import reduce_ratio


def perform(move: Move, letters: Letters) -> Performed:
    """Make a move with the equations that it cites, and nothing else.  Raises RefusedError."""
    verb = _VERBS.get(move.verb)
    if verb is None:
        raise RefusedError("there is no move {}", move.verb)
    try:
        made = verb(move, Algebra(letters))
        if move.using:
            made = _with(made, move, letters)
    except NoMeaningError as error:
        raise RefusedError(str(error)) from None
    sides = [side for pair in made.pairs for side in pair.sides]
    parts = [part for side in sides for part in scalars(side)]
    if any(part.has(*_NO_NUMBERS) for part in parts):
        raise RefusedError("a division by 0")
    if any(part.has(sympy.I) for part in parts):
        raise RefusedError("a root, or a logarithm, of what is negative")
    conditions = list(made.conditions)
    for each in (*move.of, *move.using):
        conditions += [c for c in each.conditions if c not in conditions]
    recorded = {(c.expression, c.relation) for c in conditions}
    conditions += [c for c in move.where if (c.expression, c.relation) not in recorded]
    settings = [c for c in conditions if c.relation == "="]
    _one_way([c.expression for c in settings], "is set", letters)
    always = [c for c in settings if c.expression.free_symbols <= letters.numbers]
    there = Algebra(letters, where_set(always, Scope.SET, letters))
    starts = [tree(there.value(c.expression)) for c in conditions if c.relation == "start"]
    _one_way(starts, "starts", letters)
    large, small = (
        {c.expression for c in conditions if c.relation == size} for size in ("large", "small")
    )
    for letter in large & small:
        raise RefusedError("{} is large in one of these and small in another", letter)
    scope = max((made.scope, *(k.scope for k in move.cited)), default=made.scope)
    tied = made.tied.union(*(known.tied for known in move.cited))
    return replace(made, scope=scope, conditions=tuple(conditions), tied=tied)


def with_rates(made: Performed, move: Move, letters: Letters) -> Performed | None:
    """What was made with values put in also for rates that have letters of their own.

    For p = m v that is ṗ = m v̇.  None where nothing is put in for one: a line may leave it as it
    stands, and at a moment, or of what is approximate, nothing is known of it.
    """
    if move.verb != "put" or any(k.scope is Scope.SET or k.order is not None for k in move.using):
        return None
    there = {atom for pair in made.pairs for side in pair.sides for atom in atoms_of(side)}
    kept = {atom for value in made.given.values() for atom in atoms_of(value)}
    wanted = there & {*letters.rates.values()} - kept - {*made.given}
    algebra, rates = Algebra(letters, made.given), dict[Expr, Value]()
    for letter, value in made.given.items():
        while wanted and letter in letters.rates and not is_operator(value):
            letter, value = letters.rates[letter], algebra.rate(value)
            if letter in wanted:
                rates[letter] = value
    if not rates:
        return None
    algebra = Algebra(letters, {**made.given, **rates})
    pairs = tuple(pair.valued(algebra) for pair in made.pairs)
    return replace(made, pairs=pairs, given=algebra.known)


def _one_way(starts: Sequence[Expr], word: str, letters: Letters) -> None:
    """Refuse what is cited of two motions or moments, with different values of a letter."""
    for k, start in enumerate(starts):
        if not start.free_symbols - letters.numbers or start.free_symbols & letters.arbitrary:
            continue
        for other in starts[:k]:
            difference = sympy.expand(start - other)
            by_number = difference.free_symbols <= letters.numbers and not vanishes(difference)
            # x = y and x = −y hold together at 0 only, which is neither of the two cases.
            product = Mul.make_args(difference.as_coeff_Mul()[1])
            by_product = difference != 0 and all(x.is_Symbol for x in product)
            if by_number or by_product or at_right_angles(difference, letters):
                raise RefusedError("what is cited {} in two ways: {} and {}", word, other, start)


def _with(made: Performed, move: Move, letters: Letters) -> Performed:
    """What was made, with more put into it."""
    for each in move.using:
        if each.scope is Scope.SET:
            _reaches_into(each, made.pairs, letters)
    given = put_in(move.using, letters)
    for known in move.of:
        orders.stays_small(known, given, letters)
    for atom in {*given} & {*made.given}:
        values = made.given[atom], given[atom]
        scalar = not any(is_operator(x) or isinstance(x, Vector) for x in values)
        if scalar and nonzero(values[0] - values[1], ()):
            raise RefusedError("{} is set to {}, and what is cited says {}", atom, *values)
    # What is set is set in what is put in as well; at a moment it says nothing of a rate.
    there = Algebra(letters, made.given)
    for old, new in given.items():
        if made.scope is not Scope.SET or not any(isinstance(x, Rate) for x in atoms_of(new)):
            given[old] = there.value(new)
    for product in [atom for atom in given if isinstance(atom, Dot)]:
        # e·e = 1 says n·n = 1 where e is n.
        alone = single_atom(there.value(product))
        if alone is not None and alone[1] == 1:
            given.setdefault(alone[0], given[product])
    for old, new in made.given.items():
        given.setdefault(old, new)
    algebra = Algebra(letters, given)
    pairs = tuple(pair.valued(algebra) for pair in made.pairs)
    return replace(made, pairs=pairs, given=given, order=_error(made, move.using, letters))


def _error(made: Performed, using: Sequence[Known], letters: Letters) -> Order | None:
    """The order to which the result holds, if something in it or put into it is approximate."""
    orders = [made.order] if made.order is not None else []
    for known in using:
        if known.order is not None:
            orders.append(_carried(made.pairs, known, known.order, letters))
    if len({(order.small, order.together) for order in orders}) > 1:
        raise RefusedError("two small quantities at once: expand in one after the other")
    return min(orders, key=lambda order: order.power, default=None)


def _carried(pairs: Sequence[Pair], known: Known, order: Order, letters: Letters) -> Order:
    """The order of the error that an approximate value brings into what it is put in for.

    Beside terms that are neglected this is a share of the value: it stays one in a product.
    """
    mark = Dummy("error")
    given = put_in([known], letters)
    share = order.small == NEGLECTED
    error = mark * order.small**order.power
    right = Algebra(letters, given)

    def wrong(atom: Expr, value: Value) -> Value:
        if share:
            return right.times(1 + mark, value)
        return value + (Vector({atom: error}) if isinstance(value, Vector) else error)

    off = {x: wrong(x, v) for x, v in given.items() if share or not isinstance(v, MatrixBase)}
    lowest = order.power
    for side in (side for pair in pairs for side in pair.sides):
        value, changed = (Algebra(letters, {**given, **x}).value(side) for x in ({}, off))
        rows = components(changed, value), components(changed, Integer(0))
        for change, whole in (flattened(Tuple(*row))[0] for row in zip(*rows, strict=True)):
            slope = change.diff(mark).subs(mark, 0)
            if slope != 0 and not share:
                lowest = min(lowest, order.lowest(slope))
            elif slope != 0 and not reduce_ratio(slope / whole.subs(mark, 0)).is_number:
                raise RefusedError(OF_NO_ORDER)
    return replace(order, power=lowest)


def _reaches_into(known: Known, pairs: Sequence[Pair], letters: Letters) -> None:
    """Refuse to put what is set at a moment under a rate or a slope."""
    atoms = set(put_in([known], letters))
    for pair in pairs:
        for side in pair.sides:
            for node in atoms_of(side):
                inner = {x for part in getattr(node, "args", ()) for x in (part, *nodes_of(part))}
                if isinstance(node, Rate) and inner & atoms:
                    raise RefusedError(
                        "{} is set at a moment: it can't be put in before the derivative is taken",
                        name_of(known),
                    )


_NO_NUMBERS = (sympy.nan, sympy.zoo, sympy.oo, -sympy.oo)

_VERBS: Mapping[str, Callable[[Move, Algebra], Performed]] = {
    "put": arithmetic.put,
    "differentiate": calculus.differentiate,
    "rate": calculus.rate,
    "along": calculus.along,
    "integrate": calculus.integrate,
    "integrate over": calculus.integrate_over,
    "component": arithmetic.component,
    "dot": arithmetic.dot,
    "cross": arithmetic.cross,
    "add": arithmetic.adding(1),
    "subtract": arithmetic.adding(-1),
    "multiply": arithmetic.multiply,
    "divide": arithmetic.divide,
    "rewrite": arithmetic.rewrite,
    "transpose": operators.of_operators(lambda algebra: algebra.transposed),
    "determinant": operators.of_operators(lambda algebra: algebra.determinant),
    "exchange": arithmetic.exchange,
    "turn factors": operators.exchange_factors,
    "strip": operators.strip,
    "solve": solving.solve,
    "eliminate": solving.eliminate,
    "root": signs.root,
    "sine": functions.function(sympy.sin),
    "cosine": functions.function(sympy.cos),
    "logarithm": functions.function(sympy.log),
    "sign": signs.sign,
    "sum": arithmetic.sum_over,
    "square": arithmetic.square,
    "expand": orders.expand,
    "neglect": orders.neglect,
    "set": setting.set_to,
}
