"""Set letters to values: at a moment, at all times, at the start."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from sympy import Expr, Integer, MatrixBase, Symbol

from rigidtop.proof.algebra import Algebra
from rigidtop.proof.equation import Equation, Rate
from rigidtop.proof.letters import Letters
from rigidtop.proof.moves import orders
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
from rigidtop.proof.moves.pairs import (
    all_pairs,
    at_right_angles,
    atom_of,
    is_operator,
    nodes_of,
    put_in,
)
from rigidtop.proof.values import TIME, Value, Vector, agree, atoms_of, tree, vanishes


def set_to(move: Move, algebra: Algebra) -> Performed:
    """Values for letters, at a moment; `power` 1: at all times, so that their rates vanish too.

    `power` 2: at the start, in what is constant and keeps what it was.  That 𝐞 is 𝐧 says of an
    equation with 𝐧 alone what it is with 𝐞.
    """
    try:
        return _set_to(move, algebra)
    except _AbsentError:
        if len(move.by) != 1 or not isinstance(move.by[0].sides[-1], Symbol) or move.power:
            raise
        [equation] = move.by
        turned = Equation(*reversed(equation.sides), relation=equation.relation)
        return _set_to(replace(move, by=(turned,)), algebra)


class _AbsentError(RefusedError):
    """What is set does not stand there."""


def _set_to(move: Move, algebra: Algebra) -> Performed:
    known = the_one(move)
    given = _values(move, algebra)
    letters = algebra.letters
    if TIME in given and move.power:
        raise RefusedError("t is set at a moment only")
    for atom in letters.unit_vectors & {*given}:
        if not vanishes(algebra.dot(given[atom], given[atom]) - 1):
            raise RefusedError("{} is a unit vector", atom)
    orders.stays_small(known, given, letters)
    for atom, value in given.items():
        if isinstance(value, Vector) and at_right_angles(tree(value) - atom, letters):
            raise RefusedError("{} and {} are axes of one frame, at right angles", atom, value)
    at_start = move.power == 2
    always = move.power == 1 or all(
        x in letters.numbers and {*atoms_of(value)} <= letters.numbers for x, value in given.items()
    )
    if always:
        for atom in list(given):
            if (
                isinstance(given[atom], (Vector, MatrixBase))
                or {*atoms_of(given[atom])} - letters.numbers
            ):
                raise RefusedError("only to a number can a letter be set at all times")
            given |= dict.fromkeys(_with_rates(atom, letters) - {atom}, Integer(0))
    else:
        _not_under_a_rate(given, known, algebra)
    put = Algebra(algebra.letters, given)
    pairs = [pair.valued(put) for pair in all_pairs(known, algebra)]
    _stand_there(move, known, given, algebra)
    if at_start:
        _constant(pairs, known, move, letters)
        premises = [Condition(p.left - p.right, "=") for p in pairs]
        premises += [Condition(x - tree(value), "start") for x, value in given.items()]
        return Performed(tuple(pairs), Scope.MOTION, tuple(premises))
    scope = known.scope if always and not move.power else Scope.MOTION if always else Scope.SET
    conditions = tuple(
        Condition(tree(left) - tree(right), "=")
        for left, right in (map(algebra.value, e.sides) for e in move.by)
        if not (is_operator(left) or is_operator(right))
    )
    conditions += _small_too(known, given)
    tied = frozenset(x for x in _letters_of(given) if x in letters.numbers)
    return Performed(tuple(pairs), scope, conditions, known.order, given, tied=tied)


def _small_too(known: Known, given: Mapping[Expr, Value]) -> tuple[Condition, ...]:
    """That a letter is small, or large, as what is small or large in an equation is set to it."""
    values = ((given[x], size) for x, size in known.sizes.items() if x in given)
    letters = ((value.as_coeff_Mul()[1], size) for value, size in values if isinstance(value, Expr))
    return tuple(Condition(x, size) for x, size in letters if isinstance(x, Symbol))


def _letters_of(given: Mapping[Expr, Value]) -> Iterator[Expr]:
    """What is set, and what it is set to, as far as these are scalars."""
    for atom, value in given.items():
        if isinstance(atom, Symbol) and not isinstance(value, (Vector, MatrixBase)):
            yield from (atom, *value.free_symbols)


def _stand_there(move: Move, known: Known, given: Mapping[Expr, Value], algebra: Algebra) -> None:
    """Refuse to set what does not stand in what is cited: nothing is done there."""
    sides = [
        side
        for cited in (known, *move.using)
        for pair in all_pairs(cited, algebra)
        for side in pair.sides
    ]
    made = [Algebra(algebra.letters, given).value(side) for side in sides]
    for equation in move.by:
        atom = atom_of(algebra.value(equation.sides[0]), equation.sides[0])
        own = _with_rates(atom, algebra.letters)
        rest = {x: value for x, value in given.items() if x not in own}
        put = Algebra(algebra.letters, rest)
        if all(agree(put.value(side), now) for side, now in zip(sides, made, strict=True)):
            raise _AbsentError("{} does not stand in {}", atom, name_of(known))


def _with_rates(atom: Expr, letters: Letters) -> set[Expr]:
    found = {atom}
    while atom in letters.rates:
        atom = letters.rates[atom]
        found.add(atom)
    return found


def _constant(pairs: Sequence[Pair], known: Known, move: Move, letters: Letters) -> None:
    """Refuse what changes after the start, as far as what is cited besides says."""
    if known.scope is Scope.SET or known.order is not None:
        raise RefusedError("{} does not hold at all times", name_of(known))
    bare, later = Algebra(letters), Algebra(letters, put_in(move.using, letters))
    for pair in pairs:
        rates = (later.value(bare.rate(side)) for side in pair.sides)
        if not is_equation(pair) or not agree(*rates):
            raise RefusedError("this changes after the start: cite what keeps it")
        if isinstance(pair.left, (Vector, MatrixBase)) or isinstance(pair.right, Vector):
            raise RefusedError("at the start scalars are set")


def _values(move: Move, algebra: Algebra) -> dict[Expr, Value]:
    given: dict[Expr, Value] = {}
    for equation in move.by:
        atom = atom_of(algebra.value(equation.sides[0]), equation.sides[0])
        given[atom] = algebra.value(equation.sides[1])
    return given


def _not_under_a_rate(given: Mapping[Expr, Value], known: Known, algebra: Algebra) -> None:
    for pair in all_pairs(known, algebra):
        for side in pair.sides:
            for node in atoms_of(side):
                if isinstance(node, Rate) and node not in given:
                    inner = {x for part in node.args for x in nodes_of(part)}
                    if inner & set(given):
                        raise RefusedError(
                            "{} stands there: what is set at a moment says nothing of a derivative",
                            node,
                        )
