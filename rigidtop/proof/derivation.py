"""Derivations: lines that follow from lines.

A line says what it comes from and by which move.  The engine makes that move with the cited
equations alone and has to arrive at the line: two sides that differ by a number's factor, or not at
all.  Whether a line is true in some model is another question, which is asked elsewhere; a true
line that is not arrived at is a gap.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any

import sympy
from sympy import Add, Expr, Integer, MatrixBase, Rational, Symbol

from rigidtop.proof import decide, units
from rigidtop.proof.algebra import (
    TIME,
    Algebra,
    Letters,
    Value,
    Vector,
    agree,
    atoms_of,
    components,
    flattened,
    is_smooth,
    vanishes,
)
from rigidtop.proof.changed import perturbations
from rigidtop.proof.equation import Equation, NoMeaningError, Rate, symbols_of
from rigidtop.proof.moves import (
    NEGLECTED,
    Known,
    Move,
    Order,
    Pair,
    Performed,
    RefusedError,
    Scope,
    braces_of,
    flat_with,
    give,
    named_components,
    nonzero,
    pairs_of,
    perform,
    put_in,
    where_set,
)
from rigidtop.theory.symbols import const


@dataclass(frozen=True)
class Line:
    """A line of a derivation: what it says and what is done to get there.

    `words` are the sentence in pieces: text, and trees where mathematics stands.  Without a move a
    line stands by itself: a law (`source` says whose, `origin` in pieces) or a definition, which
    gives a name to what is on its other side.  `at` is the number of the line in its `file`.
    """

    id: str
    equations: tuple[Equation, ...]
    sentence: str
    words: tuple[Any, ...] = ()
    move: Move | None = None
    scope: Scope = Scope.IDENTITY
    called: str = ""
    source: str = ""
    origin: tuple[Any, ...] = ()
    file: str = ""
    at: int = 0


@dataclass(frozen=True)
class Judged:
    """What became of a line: `problem` is empty where it follows; `known` is what may be cited."""

    line: Line
    known: Known
    problem: RefusedError | None = None
    unneeded: tuple[Known, ...] = ()

    @property
    def follows(self) -> bool:
        return self.problem is None


def judge_line(line: Line, letters: Letters, above: Iterable[Known] = ()) -> Judged:
    """Make a line's move and see whether it arrives at the line; its units come first.

    What it rests on, all that is `above` it, has to hold together with its conditions.
    """
    bare = Known(line.id, line.equations, line.scope, called=line.called)
    set_to = () if line.move is None else line.move.by
    try:
        for equation in (*line.equations, *(x for x in set_to if isinstance(x, Equation))):
            units.check(equation, letters)
    except units.UnitsError as problem:
        return Judged(line, bare, problem)
    if line.move is None:
        nearly = any(equation.relation == "≈" for equation in line.equations)
        scope = _holds(line, line.scope, letters)
        order = Order(NEGLECTED, 1) if nearly else None
        return Judged(line, replace(bare, scope=scope, order=order))
    if line.move.verb == "call":
        try:
            letter = define(line, letters)
            # What keeps a number holds where that does which is cited for it.
            scope = max((line.scope, *(known.scope for known in line.move.using)))
            conditions = tuple(c for known in line.move.using for c in known.conditions)
            return Judged(line, replace(bare, scope=scope, conditions=conditions, defines=letter))
        except RefusedError as problem:
            return Judged(line, bare, problem)
    try:
        performed = arrive(line.equations, line.move, letters)
        _each_needed(line.equations, line.move, performed, letters)
    except RefusedError as problem:
        return Judged(line, bare, problem)
    if against := _contradiction(line, performed, above, letters):
        return Judged(line, bare, RefusedError(against))
    scope = _holds(line, performed.scope, letters)
    known = replace(bare, scope=scope, conditions=performed.conditions, order=performed.order)
    return Judged(line, known)


def _each_needed(
    equations: Sequence[Equation], move: Move, performed: Performed, letters: Letters
) -> None:
    """Raises RefusedError where a line is arrived at without one of its conditions as well."""
    for k, condition in enumerate(move.where):
        try:
            less = replace(move, where=(*move.where[:k], *move.where[k + 1 :]))
            made = arrive(equations, less, letters)
        except RefusedError:
            continue
        if set(made.conditions) <= set(performed.conditions):
            raise RefusedError("{} is a condition without need", condition.expression)


def define(line: Line, letters: Letters) -> Symbol:
    """The letter that a definition introduces.  Raises RefusedError where it is none.

    The letter is new: `move.by` are the letters that stand above.  One that is said to be a number
    is defined by what does not change, as far as what is cited says.
    """
    assert line.move is not None
    [equation, *more] = line.equations
    letter = equation.sides[0]
    if (
        more
        or len(equation.sides) != 2
        or not isinstance(letter, Symbol)
        or equation.relation not in ("=", "≡")
    ):
        raise RefusedError(
            "a definition has a letter on its left side, and what it means on its right"
        )
    if letter in line.move.by:
        raise RefusedError("{} stands for something already: call it by another letter", letter)
    if letter in {*letters.coordinates, *letters.rates.values()}:
        raise RefusedError("{} is a coordinate or a rate: it can't be defined", letter)
    if letter in letters.unit_vectors | letters.arbitrary | {TIME}:
        raise RefusedError("{} has a meaning of its own: it can't be defined", letter)
    right = equation.sides[1]
    try:
        _as_it_is_used(letter, right, letters)
        nothing = Performed((), Scope.IDENTITY)
        _braces(equation, nothing, line.move, Algebra(letters, put_in(line.move.using, letters)))
    except NoMeaningError as error:
        raise RefusedError(str(error)) from None
    if letter in getattr(right, "free_symbols", set()):
        raise RefusedError("{} is defined by itself", letter)
    if letter.is_commutative and letter not in letters.vectors:
        value = Algebra(letters).value(right)
        if not isinstance(value, MatrixBase) and (vanishes(value) or nonzero(letter - value, ())):
            raise RefusedError("{} can't be that: it is 0, or of another sign", letter)
    if letter in letters.numbers:
        for known in line.move.using:
            if known.scope is Scope.SET or known.order is not None:
                raise RefusedError(
                    "{} is a number: what holds at a moment, or approximately, does not keep it",
                    letter,
                )
        algebra = Algebra(letters, put_in(line.move.using, letters))
        try:
            rate = algebra.value(Algebra(letters).rate(Algebra(letters).value(right)))
        except NoMeaningError as error:
            raise RefusedError(str(error)) from None
        if not all(vanishes(part) for part in components(rate, Integer(0))):
            raise RefusedError(
                "{} is a number, and this changes in time: cite what keeps it", letter
            )
    return letter


def _holds(line: Line, scope: Scope, letters: Letters) -> Scope:
    """Where a line holds: along the motion at most if it ties coordinates and velocities."""
    free = {*letters.coordinates}
    for _ in range(2):  # q̇ and q̈
        free |= {letters.rates[x] for x in free if x in letters.rates}
    for equation in line.equations if scope is Scope.IDENTITY else ():
        here = symbols_of(equation)
        ties = here & free and here <= free | letters.numbers | {TIME}
        if equation.relation in ("=", "≡") and (ties or const in here):
            pairs = pairs_of(equation, Algebra(letters))
            if not all(agree(pair.left, pair.right) for pair in pairs):
                return Scope.MOTION
    return scope


def _contradiction(
    line: Line, performed: Performed, above: Iterable[Known], letters: Letters
) -> str:
    """Why a line, its conditions and what it rests on can't all hold, or nothing."""
    conditions = performed.conditions
    bounded = {x for c in conditions for x in atoms_of(c.expression)}
    cited = line.move.cited if line.move is not None else ()
    values: dict[Expr, Value] = {}
    if len(cited) != 1 or {*conditions} != {*cited[0].conditions}:  # else asked for above
        values = where_set(conditions, performed.scope, letters)
        for each in above if bounded else ():
            for equation in each.equations if each.order is None else ():
                if equation.relation in ("=", "≡") and bounded & {*equation.sides}:
                    with suppress(RefusedError, NoMeaningError):
                        give(equation, each, values, letters)
    there = Algebra(letters, values)
    for condition in conditions:
        if condition.relation in ("≠", ">") and {*values} & {*atoms_of(condition.expression)}:
            value = there.value(condition.expression)
            if vanishes(value):
                return "a division by 0" if condition.lost else _AGAINST
            flat, strict = flat_with(-value, [c for c in conditions if c is not condition])
            bounds = [each.lhs for each in strict if each.rel_op == ">"]
            asked = condition.relation == ">" and not decide.branches(flat)
            negative = asked and decide.in_digits([(">", flat)], bounds=bounds)
            if negative and decide.positive(flat, strict):
                return _AGAINST
    pairs = [p for e in line.equations for p in pairs_of(e, Algebra(letters)) if _is_scalar(p)]
    if any(p.relation in ("<", ">", "≠") and vanishes(p.left - p.right) for p in pairs):
        return _AGAINST
    apart = [p.left - p.right for p in pairs if p.relation in ("=", "≈")]
    # A limit, such as g = 0, is set for a letter of which g > 0 is known.
    apart += [c.expression for c in conditions if c.relation == "=" and len(c.expression.args) > 0]
    # Where a letter of either sign stands that no condition speaks of, nothing is known.
    known = [x for x in apart if all(y.is_nonzero or y in bounded for y in _open(x))]
    return _AGAINST if any(nonzero(difference, conditions) for difference in known) else ""


_AGAINST = "this can't hold: what is cited contradicts what is set or divided by"


def _open(expression: Expr) -> set[Expr]:
    """The letters of an expression, and its atoms that are none."""
    flat, nodes = flattened(expression)
    return {nodes.get(x, x) for x in flat.free_symbols}


def _is_scalar(pair: Pair) -> bool:
    return not any(
        isinstance(side, (Vector, MatrixBase)) or not side.is_commutative
        for side in (pair.left, pair.right)
    )


def _as_it_is_used(letter: Symbol, right: Expr, letters: Letters) -> None:
    """Raises RefusedError where a definition contradicts what is known of its letter."""
    value = Algebra(letters).value(right)
    for (axis, vector), component in letters.components.items():
        along = Algebra(letters).dot(Vector({axis: Integer(1)}), Vector({vector: Integer(1)}))
        if letter == component and value != along:
            raise RefusedError("{} is the component of {} along {}", letter, vector, axis)
    if letter in letters.determinants.values():
        raise RefusedError("{} has a meaning of its own: it can't be defined", letter)
    if letter in letters.placed and not isinstance(value, (Vector, MatrixBase)):
        flat, nodes = flattened(value)
        if any(
            x in letters.velocities or not letters.is_placed(nodes.get(x, x))
            for x in flat.free_symbols
        ):
            raise RefusedError("{} is a function of the coordinates alone", letter)


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
    algebra = Algebra(letters, performed.given)
    gone = [e.sides[0] for e in move.by] if move.verb == "set" and move.power < 2 else []
    if performed.scope is Scope.SET:  # what was set to a number, here or above
        fixed, numbers = where_set(performed.conditions, Scope.SET, letters), letters.numbers
        gone += [x for x, v in fixed.items() if x not in numbers and {*atoms_of(v)} <= numbers]
    shown: set[int] = set()
    says_something = False
    try:
        if move.verb == "integrate" and move.by and not move.power:
            if any(equation.sides[0] in letters.rates for equation in equations):
                solves(equations, move, letters)
            else:
                _first_integral(equations, performed, move, letters)
            for equation in equations:
                _braces(equation, performed, move, algebra)
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
            _braces(equation, performed, move, algebra)
    except NoMeaningError as error:
        raise RefusedError(str(error)) from None
    if not says_something:
        raise RefusedError("this holds whatever the letters are: it says nothing")
    if performed.every:
        _both_roots(equations, performed, shown)
    return performed


def _braces(equation: Equation, performed: Performed, move: Move, algebra: Algebra) -> None:
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


def solves(equations: Sequence[Equation], move: Move, letters: Letters) -> None:
    """Raises RefusedError unless letters as functions of time solve what is cited.

    They have to satisfy every equation and the values at t = 0.  A solution that does is the only
    one: the equations give the rate of each letter, as a smooth function of the letters.
    """
    if any(known.scope is Scope.SET or known.order is not None for known in move.cited):
        raise RefusedError("what holds at a moment, or approximately, can't be integrated")
    bare = Algebra(letters)
    given = put_in(move.using, letters)
    found: dict[Expr, Value] = {}
    for equation in equations:
        for pair in pairs_of(equation, bare):
            if pair.left in letters.numbers or pair.left not in letters.rates:
                raise RefusedError("a solution gives a letter as a function of the time")
            found[pair.left] = pair.right
    motion = dict(found)
    for letter, value in found.items():
        motion[letters.rates[letter]] = bare.rate(value)
    known = Algebra(letters, given)
    motion = {x: known.value(value) for x, value in motion.items()}
    algebra = Algebra(letters, motion)
    algebra = Algebra(letters, {**{x: algebra.value(v) for x, v in given.items()}, **motion})
    cited = [p for k in move.of for e in k.equations for p in pairs_of(e, bare)]
    if not all(_is_identity(_valued(p, algebra), move) for p in cited):
        raise RefusedError("this does not satisfy the equations that are integrated")
    _gives_rates([_valued(p, known) for p in cited], list(found), letters)
    start = {e.sides[0]: bare.value(e.sides[1]) for e in move.by}
    for letter, value in found.items():
        if letter not in start:
            raise RefusedError("where {} starts is not said", letter)
        if not {*atoms_of(start[letter])} <= letters.numbers:
            raise RefusedError("{} starts at what is no number", letter)
        if not _zero(value.subs(TIME, 0) - start[letter], move):
            raise RefusedError("{} does not start there", letter)


def _gives_rates(pairs: Sequence[Pair], of: Sequence[Symbol], letters: Letters) -> None:
    """Raises RefusedError unless equations give rates of letters as smooth functions of them."""
    rates = [letters.rates[x] for x in of]
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
    matrix = sympy.Matrix(rows[: len(rates)])
    if len(rows) < len(rates) or not nonzero(sympy.factor(matrix.det()), ()):
        raise RefusedError("as many equations of the first order as letters have to be integrated")


def _first_integral(
    equations: Sequence[Equation], performed: Performed, move: Move, letters: Letters
) -> None:
    """Raises RefusedError unless equations have the rates that are cited, and hold at the start."""
    if performed.order is not None:
        raise RefusedError("what holds approximately can't be integrated")
    bare, given = Algebra(letters), Algebra(letters, performed.given)
    at_start = {e.sides[0]: bare.value(e.sides[1]) for e in move.by}
    start = Algebra(letters, at_start)
    for equation in equations:
        for letter, value in at_start.items():
            if letter not in symbols_of(equation):
                raise RefusedError("{} does not stand there", letter)
            if not {*atoms_of(value)} <= letters.numbers:
                raise RefusedError("{} starts at what is no number", letter)
        for pair in pairs_of(equation, bare):
            rates = [given.value(bare.rate(side)) for side in (pair.left, pair.right)]
            if _matching(replace(pair, left=rates[0], right=rates[1]), performed, move) is None:
                raise RefusedError("this is constant whatever is cited: it is no integral")
            if not _is_identity(_valued(pair, start), move):
                raise RefusedError("this does not hold at the start")


def _valued(pair: Pair, algebra: Algebra) -> Pair:
    return replace(pair, left=algebra.value(pair.left), right=algebra.value(pair.right))


def _matching(pair: Pair, performed: Performed, move: Move) -> int | None:
    """The number of the performed pair that a pair of the line is; None for an identity."""
    wrong: RefusedError | None = None
    if pair.relation == "=" and _is_identity(pair, move):
        return None
    for number, made in enumerate(performed.pairs):
        problem = _problem(pair, made, performed, move)
        if problem is None:
            return number
        wrong = wrong or problem
    raise wrong or RefusedError("nothing comes of this move")


def _is_identity(pair: Pair, move: Move) -> bool:
    return all(_zero(part, move) for part in components(pair.left, pair.right))


def _problem(pair: Pair, made: Pair, performed: Performed, move: Move) -> RefusedError | None:
    """Why a pair of the line is not the one that was made; None if it is."""
    order = performed.order
    if order is not None:
        return _approximate(pair, made, order, move)
    if pair.relation == "≈":
        return RefusedError("nothing was neglected: write =")
    factor = _factor(pair, made, move)
    if factor is None:
        return RefusedError("the move does not arrive here")
    turned = {"<": ">", ">": "<", "≤": "≥", "≥": "≤"}
    expected = made.relation
    if expected in turned and factor < 0:
        expected = turned[expected]
    if pair.relation != expected:
        return RefusedError("the move gives {}, the line says {}", expected, pair.relation)
    return None


def _factor(pair: Pair, made: Pair, move: Move) -> Expr | None:
    """The number c for which line = c × performed; None where there is none."""
    mine, theirs = _difference(pair), _difference(made)
    if mine.keys() != theirs.keys():
        mine = {k: v for k, v in mine.items() if not _zero(v, move)}
        theirs = {k: v for k, v in theirs.items() if not _zero(v, move)}
        if mine.keys() != theirs.keys():
            return None
    factor = Integer(1)
    for key in mine:
        guess = _ratio(mine[key], theirs[key])
        if guess is not None:
            factor = guess
            break
    if all(_zero(mine[key] - factor * theirs[key], move) for key in mine):
        return factor
    return None


def _difference(pair: Pair) -> dict[Expr, Expr]:
    if isinstance(pair.left, Vector) or isinstance(pair.right, Vector):
        total = Vector({})
        for side, sign in ((pair.left, 1), (pair.right, -1)):
            if isinstance(side, Vector):
                total = total + side.times(Integer(sign))
            elif side != 0:
                raise NoMeaningError("a vector is compared with a scalar")
        return dict(total.terms)
    return dict(enumerate(components(pair.left, pair.right)))


def _ratio(mine: Expr, theirs: Expr) -> Expr | None:
    """A simple number that two expressions may differ by, guessed at one point."""
    flat, _ = flattened(sympy.Tuple(mine, theirs))
    if not getattr(mine, "is_commutative", True):
        return Integer(1) if sympy.expand(mine - theirs) == 0 else Integer(-1)
    for attempt in range(4):
        a, b = decide.values(list(flat), attempt)
        if not (math.isfinite(a) and math.isfinite(b)) or abs(b) < decide.TOLERANCE:
            continue
        guess = Fraction(a / b).limit_denominator(64)
        return Rational(guess) if guess and math.isclose(guess, a / b, rel_tol=1e-8) else None
    return Integer(1)


def _zero(expression: Expr, move: Move) -> bool:
    """Whether an expression vanishes, letters of known sign being so."""
    positive = {
        c.expression: sympy.Dummy(positive=True)
        for c in move.where
        if c.relation == ">" and isinstance(c.expression, Symbol)
    }
    return vanishes(expression.xreplace(positive) if positive else expression)


def _approximate(pair: Pair, made: Pair, order: Order, move: Move) -> RefusedError | None:
    if pair.relation != "≈":
        return RefusedError("only ≈ follows: something is neglected")
    factor = _factor(pair, made, move)
    if factor is None:
        return RefusedError("the move does not arrive here")
    counted = [flattened(part)[0] for part in _difference(pair).values()]
    if order.small == NEGLECTED:  # it is small against the largest term that stands there
        nothing = sum(len(Add.make_args(x)) for x in map(sympy.expand, counted) if x != 0) < 2
    else:
        nothing = min((order.lowest(x) for x in counted), default=0) >= order.power
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


def unneeded(line: Line, letters: Letters) -> Iterator[Known]:
    """What a line cites without needing it: it is arrived at all the same without."""
    if line.move is None or line.move.verb == "call":
        return
    for known in line.move.using:
        less = replace(line.move, using=tuple(k for k in line.move.using if k is not known))
        try:
            arrive(line.equations, less, letters)
        except RefusedError:
            continue
        yield known


# --- a diagnosis ---------------------------------------------------------------------------------


@dataclass(frozen=True)
class Diagnosis:
    """Of a line that is not arrived at: whether it follows at all, or numbers against it."""

    entailed: bool
    at: dict[Symbol, Expr] = field(default_factory=dict)
    left: Expr | None = None
    right: Expr | None = None


def diagnose(
    equations: Sequence[Equation], cited: Sequence[Known], letters: Letters
) -> Diagnosis | None:
    """Whether equations follow from others by elimination; None where that can't be told."""
    try:
        algebra = Algebra(letters, put_in(cited, letters))
        pairs = [p for e in equations for p in pairs_of(e, algebra)]
    except (RefusedError, NoMeaningError):
        return None
    for pair in pairs:
        for part in _difference(pair).values():
            if not vanishes(part):
                return _numbers(pair, letters)
    return Diagnosis(True)


def _numbers(pair: Pair, letters: Letters) -> Diagnosis | None:
    """Short numbers at which the two sides differ."""
    if isinstance(pair.left, Vector) or isinstance(pair.right, Vector):
        return Diagnosis(False)
    flat, nodes = flattened(sympy.Tuple(pair.left, pair.right))
    sides = list(flat)
    for point, number in decide.places(sides, exists=letters.exists):
        if decide.apart(*map(number, sides)):
            at = {nodes.get(x, x): value for x, value in point.items()}
            return Diagnosis(False, at, *(side.xreplace(point) for side in sides))
    return None


# --- changes: every one has to fall --------------------------------------------------------------


@dataclass(frozen=True)
class Change:
    """A line with one thing changed, and what it was."""

    line: Line
    what: str


def changes(line: Line, letters: Letters, others: Sequence[Known] = ()) -> Iterator[Change]:
    """A line with a sign, factor or function changed; another equation cited, another move."""
    for k, equation in enumerate(line.equations):
        for changed in perturbations(equation, letters.families):
            yield Change(_with_equation(line, k, changed.equation), changed.change)
        for i, side in enumerate(equation.sides):
            for letter in _letters(equation) if side == 0 else ():
                sides = (*equation.sides[:i], letter, *equation.sides[i + 1 :])
                new = Equation(*sides, relation=equation.relation, tag=equation.tag)
                yield Change(_with_equation(line, k, new), f"{letter} for 0")
    move = line.move
    if move is None or move.verb == "call":
        return
    for other in others:
        if other.id == line.id or any(other.equations == k.equations for k in move.cited):
            continue
        for k in range(len(move.of)):
            of = (*move.of[:k], other, *move.of[k + 1 :])
            yield Change(replace(line, move=replace(move, of=of)), f"{other.id} cited instead")
    for verb in ("rate", "square"):
        if verb != move.verb:
            made = replace(move, verb=verb, by=())
            yield Change(replace(line, move=made), f"{verb} instead of {move.verb}")


def survivors(
    line: Line, letters: Letters, others: Sequence[Known] = ()
) -> tuple[int, tuple[str, ...]]:
    """How many changes of a line that follows say something else, and which of them follow too.

    What says the same as the line, such as cos(−θ) for cos θ, or as another of its equations,
    is no change.
    """
    assert line.move is not None
    performed = perform(line.move, letters)
    tried, survived = 0, []
    for change in changes(line, letters, others):
        tried += 1
        new, move = change.line.equations, change.line.move
        assert move is not None
        made = performed if move is line.move else None
        changed = [e for e in new if e not in line.equations]
        try:
            arrive(new, move, letters, made)
        except RefusedError:
            continue
        if changed and all(any(same(e, old, letters) for old in line.equations) for e in changed):
            tried -= 1
        else:
            survived.append(change.what)
    return tried, tuple(survived)


def _with_equation(line: Line, k: int, equation: Equation) -> Line:
    return replace(line, equations=(*line.equations[:k], equation, *line.equations[k + 1 :]))


def _letters(equation: Equation) -> list[Symbol]:
    return sorted(symbols_of(equation), key=str)


def _from_zero(equation: Equation) -> Equation:
    """With a 0 between all sides: 0 = −a = b says of each that it vanishes, as 0 = a = b does."""
    if equation.relation != "=" or 0 not in equation.sides or set(equation.sides) == {0}:
        return equation
    return Equation(*(x for side in equation.sides if side != 0 for x in (Integer(0), side)))


def same(changed: Equation, equation: Equation, letters: Letters) -> bool:
    """Whether two equations say the same whatever their letters are."""
    algebra, nothing = Algebra(letters), Move("rewrite")
    try:
        pairs = [pairs_of(_from_zero(each), algebra) for each in (changed, equation)]
        return len(pairs[0]) == len(pairs[1]) and all(
            _factor(a, b, nothing) is not None for a, b in zip(*pairs, strict=True)
        )
    except (NoMeaningError, RefusedError, TypeError, AttributeError):
        return False
