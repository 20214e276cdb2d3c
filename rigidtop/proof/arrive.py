"""Whether a move arrives at a line: it may differ by a number's factor from what is made."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from operator import itemgetter
from typing import Any

import sympy
from sympy import Add, Expr, Integer, MatrixBase, Symbol

from rigidtop.proof.algebra import Algebra
from rigidtop.proof.clock import Clock
from rigidtop.proof.equation import Equation, NoMeaningError, Rate, symbols_of
from rigidtop.proof.factor import factor_of, is_zero
from rigidtop.proof.letters import Letters
from rigidtop.proof.moves import (
    NEGLECTED,
    Condition,
    Move,
    Order,
    Pair,
    Performed,
    RefusedError,
    Scope,
    braces_of,
    named_components,
    nonzero,
    pairs_of,
    perform,
    put_in,
    where_set,
    with_rates,
)
from rigidtop.proof.values import (
    TIME,
    Value,
    Vector,
    atoms_of,
    components,
    flattened,
    is_smooth,
    tree,
    vanishes,
)
from rigidtop.theory.symbols import const


def arrive(
    equations: Sequence[Equation],
    move: Move,
    letters: Letters,
    performed: Performed | None = None,
) -> Performed:
    """What a move makes, if the equations are that.  Raises RefusedError.

    What was `performed` already need not be again.
    """
    performed = perform(move, letters) if performed is None else performed
    if move.verb == "integrate over":
        return _over(equations, move, letters, performed)
    try:
        return _arrived(equations, move, letters, performed)
    except RefusedError:
        further = with_rates(performed, move, letters)
        if further is None:
            raise
        return _arrived(equations, move, letters, further)


def _arrived(
    equations: Sequence[Equation], move: Move, letters: Letters, performed: Performed
) -> Performed:
    """What was performed, if the equations are that.  Raises RefusedError."""
    algebra = Algebra(letters, performed.given)
    given = performed.given
    # What alone stands there may be the right side of what is set.
    gone: list[Expr] = []
    if move.verb == "set" and move.power < 2:
        pairs = ((e.sides[0], e.sides[-1]) for e in move.by)
        gone = [y if x not in given and y in given else x for x, y in pairs]
    if move.verb == "set" and move.power == 1:  # at all times: so are its rates
        gone += [rate for e in move.by for rate in _with_rates(e.sides[0], letters)[1:]]
    if performed.scope is Scope.SET:  # what was set to a number, here or above
        fixed, numbers = where_set(performed.conditions, Scope.SET, letters), letters.numbers
        gone += [
            x
            for x, v in fixed.items()
            if not ({x} & numbers or isinstance(v, Vector)) and {*atoms_of(v)} <= numbers
        ]
    shown: set[int] = set()
    says_something = False
    try:
        if move.verb == "integrate" and move.by and not move.power:
            if all(_is_solution(equation, letters) for equation in equations):
                performed = replace(
                    performed, conditions=(*performed.conditions, *solves(equations, move, letters))
                )
            else:
                _first_integral(equations, performed, move, letters)
            for equation in equations:
                check_braces(equation, performed, move, algebra)
            return performed
        for equation in equations:
            if performed.scope is Scope.SET:
                _at_a_moment(equation, performed)
            _is_gone(gone, equation)
            for pair in pairs_of(equation, algebra):
                if move.verb == "integrate" and not move.power and const not in equation.sides:
                    raise RefusedError("say from where: “from $x = x_0$”, or that it is constant")
                found = _matching(pair, _named(performed, pair, letters), move)
                says_something |= found is not None
                if found is not None:
                    shown.add(found)
            check_braces(equation, performed, move, algebra)
    except NoMeaningError as error:
        raise RefusedError(str(error)) from None
    if not says_something:
        raise RefusedError("this holds whatever the letters are: it says nothing")
    if performed.every:
        _both_roots(equations, performed, shown)
    return performed


def _over(
    equations: Sequence[Equation], move: Move, letters: Letters, performed: Performed
) -> Performed:
    """The same as over time, with another letter in the place of t, from where that is 0."""
    by, *starts = move.by
    known = (e for each in move.cited for e in each.equations)
    clock = Clock.of(by, (*known, *starts, *equations))
    timed = [clock.equation(each, letters) for each in equations]
    try:
        made = arrive(timed, clock.move(move, letters), replace(letters, rates=clock.rates))
    except RefusedError as error:
        raise clock.problem(error) from None
    conditions = (*performed.conditions, *map(clock.condition, made.conditions))
    return replace(performed, conditions=tuple(dict.fromkeys(conditions)))


def check_braces(equation: Equation, performed: Performed, move: Move, algebra: Algebra) -> None:
    """Raises RefusedError unless what stands beneath a brace is what is in it, or a component."""
    if braces := braces_of(equation, algebra):
        named = named_components(performed.pairs, algebra)
        widened = replace(performed, pairs=(*performed.pairs, *named))
        for pair in braces:
            _matching(pair, widened, move)


def _at_a_moment(equation: Equation, performed: Performed) -> None:
    """Raises RefusedError where a line speaks of rates of what is set at a moment."""
    if const in equation.sides:
        raise RefusedError("what is set at a moment does not say that something is constant")
    for side in equation.sides:
        for rate in side.atoms(Rate):
            if any(part in performed.given for part in sympy.preorder_traversal(rate.args[0])):
                raise RefusedError(
                    "{} stands there: what is set at a moment says nothing of a derivative", rate
                )


def _is_gone(letters: Sequence[Expr], equation: Equation) -> None:
    for letter in letters:
        if letter in symbols_of(equation):
            raise RefusedError("{} is set and stands there still", letter)


def _both_roots(equations: Sequence[Equation], performed: Performed, shown: set[int]) -> None:
    if len(shown) < len(performed.pairs):
        raise RefusedError("there is another root: show both, or say which by a condition")
    names = [e.sides[0] for e in equations]
    if len(set(names)) < len(names):
        raise RefusedError("two roots need two letters")


def _named(performed: Performed, pair: Pair, letters: Letters) -> Performed:
    """Roots by the letters that the line gives them: Ω₋ and Ω₊, each its own root for Ω."""
    unknown, place = letters.branches.get(pair.left, (None, 0))
    if not performed.every or unknown is None or unknown != performed.pairs[0].left:
        return performed
    roots = list(performed.pairs)
    roots[place] = replace(roots[place], left=pair.left)
    if vanishes(pair.right - roots[1 - place].right):
        raise RefusedError("{} is the other root", pair.left)
    return replace(performed, pairs=tuple(roots))


def _is_solution(equation: Equation, letters: Letters) -> bool:
    """Whether an equation gives a letter as a function of the time."""
    letter, *rest = equation.sides
    given = {x for side in rest for x in side.free_symbols}
    return (
        letter in letters.rates
        and letter not in letters.numbers
        and given <= (letters.numbers | {TIME, const})
    )


def solves(equations: Sequence[Equation], move: Move, letters: Letters) -> list[Condition]:
    """Where a solution ends, if equations are one of those that are cited.  Raises RefusedError.

    Letters as functions of time have to satisfy every equation and the values at t = 0.  A solution
    that does is the only one: the equations give the highest rate of each letter, as a smooth
    function of the letters and their lower rates.  What it divides by keeps its sign.
    """
    if any(known.scope is Scope.SET or known.order is not None for known in move.cited):
        raise RefusedError("what holds at a moment, or approximately, can't be integrated")
    bare = Algebra(letters)
    given = put_in(move.using, letters)
    cited = [p for k in move.of for e in k.equations for p in pairs_of(e, bare)]
    known = Algebra(letters, given)
    asked = {x for p in cited for side in p.valued(known).sides for x in atoms_of(side)}
    states: list[list[Expr]] = []
    motion: dict[Expr, Value] = {}
    for pair in (pair for equation in equations for pair in pairs_of(equation, bare)):
        chain = _with_rates(pair.left, letters)
        order = max((k for k, rate in enumerate(chain) if k and rate in asked), default=0)
        states.append(chain[:order])
        value = pair.right
        for letter in chain[: order + 1]:
            motion[letter], value = known.value(value), bare.rate(value)
    algebra = Algebra(letters, motion)
    algebra = Algebra(letters, {**{x: algebra.value(v) for x, v in given.items()}, **motion})
    for pair in (each.valued(algebra) for each in cited):
        if not _is_identity(pair, move):
            became = Equation(*map(tree, pair.sides))
            raise RefusedError(
                "this does not satisfy the equations that are integrated: they become {}", became
            )
    _gives_rates([p.valued(known) for p in cited], states, letters)
    start = {e.sides[0]: bare.value(e.sides[1]) for e in move.by}
    for letter in (x for lower in states for x in lower):
        if letter not in start:
            raise RefusedError("where {} starts is not said", letter)
        if not {*atoms_of(start[letter])} <= letters.numbers:
            raise RefusedError("{} starts at what is no number", letter)
        if not is_zero(motion[letter].subs(TIME, 0) - start[letter], move):
            raise RefusedError("{} does not start there", letter)
    return [c for lower in states for c in _until(motion[lower[0]])]


def _with_rates(letter: Expr, letters: Letters) -> list[Expr]:
    """A letter, its rate, the rate of that, as far as they have letters."""
    chain = [letter]
    while chain[-1] in letters.rates:
        chain.append(letters.rates[chain[-1]])
    return chain


def _until(solution: Expr) -> list[Condition]:
    """That what a solution divides by has the sign that it has at t = 0.

    A tangent, and one over a cosine, end a quarter turn from there.
    """
    made = []
    turning = [f.args[0] for f in solution.atoms(sympy.tan)]
    turning += [p.base.args[0] for p in solution.atoms(sympy.Pow) if _is_inverse_cosine(p)]
    for angle in dict.fromkeys(turning):
        slope = angle.diff(TIME)
        if slope.is_positive or slope.is_negative:
            quarter = sympy.pi / 2
            made.append(Condition(quarter - (angle if slope.is_positive else -angle), ">"))
    for power in solution.atoms(sympy.Pow):
        if power.exp.is_negative and power.base.has(TIME):
            begins = power.base.subs(TIME, 0)
            sign = 1 if begins.is_positive else -1 if begins.is_negative else 1 / begins
            made.append(Condition(sympy.expand(sign * power.base), ">"))
    return made


def _is_inverse_cosine(power: Expr) -> bool:
    return isinstance(power.base, sympy.cos) and power.exp.is_negative and power.base.has(TIME)


def _gives_rates(pairs: Sequence[Pair], states: Sequence[Sequence[Expr]], letters: Letters) -> None:
    """Raises RefusedError unless equations give the highest rates as smooth functions of states."""
    rates = [letters.rates[lower[-1]] for lower in states if lower]
    of = [x for lower in states for x in lower]
    rows = []
    for pair in pairs:
        if pair.relation != "=" or isinstance(pair.left, (Vector, MatrixBase)):
            raise RefusedError("scalar equations are integrated")
        flat, _ = flattened(sympy.expand(pair.left - pair.right))
        row = [flat.diff(rate) for rate in rates]
        if any(slope != 0 for slope in row):
            rest = flat.subs(dict.fromkeys(rates, 0))
            if any(slope.has(*rates, *of) for slope in row) or not is_smooth(rest, of):
                raise RefusedError("the rates are not smooth functions of the letters")
            rows.append(row)
    if len(rows) < len(states) or len(rates) < len(states):
        raise RefusedError("as many equations as letters have to be integrated")
    matrix = sympy.Matrix(rows[: len(rates)])
    if not nonzero(sympy.factor(matrix.det()), ()):
        raise RefusedError("the equations do not give the highest rate of each letter")


def _first_integral(
    equations: Sequence[Equation], performed: Performed, move: Move, letters: Letters
) -> None:
    """Raises RefusedError unless equations have the rates that are cited, and hold at the start."""
    if performed.order is not None:
        raise RefusedError("what holds approximately can't be integrated")
    bare, given = Algebra(letters), Algebra(letters, performed.given)
    at_start = {e.sides[0]: bare.value(e.sides[1]) for e in move.by}
    start = Algebra(letters, {TIME: Integer(0), **at_start})
    for equation in equations:
        for letter, value in at_start.items():
            if letter not in symbols_of(equation):
                raise RefusedError("{} does not stand there", letter)
            if not {*atoms_of(value)} <= letters.numbers:
                raise RefusedError("{} starts at what is no number", letter)
        for pair in pairs_of(equation, bare):
            rates = [given.value(bare.rate(side)) for side in pair.sides]
            if _matching(replace(pair, left=rates[0], right=rates[1]), performed, move) is None:
                raise RefusedError("this is constant whatever is cited: it is no integral")
            if not _is_identity(pair.valued(start), move):
                raise RefusedError("this does not hold at the start")


def _matching(pair: Pair, performed: Performed, move: Move) -> int | None:
    """The number of the performed pair that a pair of the line is; None for an identity."""
    if pair.relation == "=" and _is_identity(pair, move):
        return None
    wrong: list[tuple[bool, RefusedError]] = []
    for number, made in enumerate(performed.pairs):
        problem = _problem(pair, made, performed, move)
        if problem is None:
            return number
        wrong.append((not _same_side(pair, made), problem))
    if not wrong:
        raise RefusedError("nothing comes of this move")
    raise min(wrong, key=itemgetter(0))[1]  # of that which the line is nearest to


def _same_side(pair: Pair, made: Pair) -> bool:
    """Whether two pairs have a side in common that is not 0."""
    return any(_is_alike(one, other) for one in pair.sides for other in made.sides)


def _is_alike(one: Value, other: Value) -> bool:
    """Whether two values are the same as they are written, and not 0."""
    if isinstance(one, Vector) and isinstance(other, Vector):
        return bool(one.terms) and dict(one.terms) == dict(other.terms)
    if isinstance(one, Vector) or isinstance(other, Vector):
        return False
    return bool(one == other and one != 0)


def _is_identity(pair: Pair, move: Move) -> bool:
    return all(is_zero(part, move) for part in components(pair.left, pair.right))


def _problem(pair: Pair, made: Pair, performed: Performed, move: Move) -> RefusedError | None:
    """Why a pair of the line is not the one that was made; None if it is."""
    order = performed.order
    if order is not None:
        return _approximate(pair, made, order, move)
    if pair.relation == "≈":
        return RefusedError("nothing was neglected: write =")
    factor = factor_of(pair, made, move)
    if factor is None:
        return _disagreement(pair, made, move)
    turned = {"<": ">", ">": "<", "≤": "≥", "≥": "≤"}
    expected = made.relation
    if expected in turned and factor < 0:
        expected = turned[expected]
    if pair.relation != expected:
        return RefusedError("the move gives {}, the line says {}", expected, pair.relation)
    return None


LONGEST = 150
"""What has more operations is not shown beside what a line says."""


MOST = 6
"""Of more components that differ, or entries, the first ones are shown."""


def _disagreement(pair: Pair, made: Pair, move: Move) -> RefusedError:
    """What a move gives instead of what a line says, and in which of their parts they differ.

    Where matrices with zeros differ these parts are all that is shown.
    """
    given = Equation(*map(tree, made.sides), relation=made.relation)
    parts = [
        (f"{where} it gives {{}}, the line has {{}}", (*of, one, other))
        for (where, *of), one, other in _differing(pair, made, move)
    ]
    matrices = [side for side in given.sides if isinstance(side, MatrixBase)]
    if any(0 in [*matrix] for matrix in matrices) and parts:
        shown = []
    elif len(matrices) == 1 and 2 * [*matrices[0]].count(0) > len(matrices[0]) > 9:
        [other] = (side for side in given.sides if side is not matrices[0])
        shown = [("it gives {} with these entries and else zeros", (other,))]
        parts = [(f"{{}} {where}", (entry,)) for where, entry in _entries(matrices[0]) if entry]
    elif sum(sympy.count_ops(side) for side in given.sides) <= LONGEST:
        shown = [("it gives {}", (given,))]
    else:
        shown = []
    told = [*shown, *parts[:MOST]]
    words = "; ".join([words for words, _ in told] + ["…"] * (len(parts) > MOST))
    nodes = [node for _, nodes in told for node in nodes]
    return RefusedError("the move does not arrive here" + f": {words}" * bool(words), *nodes)


def _differing(
    pair: Pair, made: Pair, move: Move
) -> Iterator[tuple[tuple[Any, ...], Expr | Equation, Expr | Equation]]:
    """The components in which a line differs from what is made: the place, this and the line's."""
    rights = _parts(made.right, pair.right)
    if sympy.sympify(tree(pair.left)) == sympy.sympify(tree(made.left)):
        for where, one, other in rights:
            if not is_zero(one - other, move):
                yield where, tree(one), tree(other)
    elif isinstance(made.left, MatrixBase):
        for (where, *left), (_, *right) in zip(_parts(made.left, pair.left), rights, strict=False):
            if not all(is_zero(one - other, move) for one, other in (left, right)):
                yield where, Equation(left[0], right[0]), Equation(left[1], right[1])


def _parts(made: Value, line: Value) -> Iterator[tuple[tuple[Any, ...], Expr, Expr]]:
    """The components of two vectors, or the entries of two matrices, each with its place."""
    if isinstance(made, Vector) and isinstance(line, Vector):
        for atom in {**made.terms, **line.terms}:
            of = (x.terms.get(atom, Integer(0)) for x in (made, line))
            yield ("along {}", tree(atom)), *of
    elif isinstance(made, MatrixBase) and isinstance(line, MatrixBase) and made.shape == line.shape:
        for (where, one), other in zip(_entries(made), line, strict=True):
            yield (where,), one, other


def _entries(matrix: MatrixBase) -> Iterator[tuple[str, Expr]]:
    """The entries of a matrix, each with its place in words."""
    for k, entry in enumerate(matrix):
        row, column = divmod(k, matrix.shape[1])
        yield f"in row {row + 1}, column {column + 1}", entry


def _approximate(pair: Pair, made: Pair, order: Order, move: Move) -> RefusedError | None:
    if pair.relation != "≈":
        return RefusedError("only ≈ follows: something is neglected")
    factor = factor_of(pair, made, move)
    if factor is None:
        return _disagreement(pair, made, move)
    counted = [flattened(part)[0] for part in components(pair.left, pair.right)]
    if order.small == NEGLECTED:  # it is small against the largest term that stands there
        nothing = sum(len(Add.make_args(x)) for x in map(sympy.expand, counted) if x != 0) < 2
    else:
        right = [flattened(x)[0] for x in components(pair.right, Integer(0)) if x != 0]
        nothing = min((order.lowest(x) for x in counted), default=0) >= order.power
        nothing |= not right and order.power <= 0
    if nothing:
        return RefusedError("the error is as large as what stands there: nothing is known")
    for flat in map(order.counted, counted):
        if flat.has(order.small) and _highest(flat, order.small) >= order.power:
            return RefusedError(
                "the line claims more than it has: its error is of order {} in {}",
                str(order.power),
                order.small,
            )
    return None


def _highest(expression: Expr, small: Symbol) -> int:
    expanded = sympy.expand(expression)
    return max((int(t.as_coeff_exponent(small)[1]) for t in Add.make_args(expanded)), default=0)
