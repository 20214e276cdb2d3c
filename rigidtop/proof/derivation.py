"""Derivations: lines that follow from lines.

A line says what it comes from and by which move.  The engine makes that move with the cited
equations alone and has to arrive at the line: two sides that differ by a number's factor, or not at
all.  Whether a line is true in some model is another question, which is asked elsewhere; a true
line that is not arrived at is a gap.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

import sympy
from sympy import Expr, Integer, MatrixBase, Symbol

from rigidtop.proof import bounds, decide, units
from rigidtop.proof.algebra import Algebra
from rigidtop.proof.arrive import arrive, check_braces
from rigidtop.proof.equation import Equation, NoMeaningError, symbols_of
from rigidtop.proof.letters import Letters
from rigidtop.proof.moves import (
    NEGLECTED,
    Condition,
    Known,
    Move,
    Order,
    Pair,
    Performed,
    RefusedError,
    Scope,
    domain,
    flat_with,
    give,
    joined,
    never_vanishes,
    nonzero,
    pairs_of,
    put_in,
    where_set,
)
from rigidtop.proof.values import (
    TIME,
    Value,
    Vector,
    agree,
    atoms_of,
    components,
    difference,
    flattened,
    vanishes,
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
    bare = unproved(line)
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
        known = replace(bare, scope=scope, order=order, tied=_ties(line, letters))
        return Judged(line, replace(known, conditions=joined(_domain(line, (), letters))))
    if line.move.verb == "call":
        try:
            letter = define(line, letters)
            # What keeps a number holds where that does which is cited for it.
            scope = max((line.scope, *(known.scope for known in line.move.using)))
            conditions = tuple(c for known in line.move.using for c in known.conditions)
            conditions += _domain(line, conditions, letters)
            tied = _ties(line, letters).union(*(known.tied for known in line.move.using))
            known = replace(
                bare, scope=scope, conditions=joined(conditions), defines=letter, tied=tied
            )
            return Judged(line, known)
        except RefusedError as problem:
            return Judged(line, bare, problem)
    try:
        performed = arrive(line.equations, line.move, letters)
        _each_needed(line.equations, line.move, performed, letters)
        conditions = (*performed.conditions, *line.move.where)
        defined = _domain(line, conditions, letters)
        if line.move.verb in _ROOTS:
            defined = tuple(c for c in defined if c.relation != "≥")
        performed = replace(performed, conditions=(*performed.conditions, *defined))
    except RefusedError as problem:
        return Judged(line, bare, problem)
    if against := _contradiction(line, performed, above, letters):
        return Judged(line, bare, RefusedError(against))
    scope = _holds(line, performed.scope, letters)
    known = replace(
        bare,
        scope=scope,
        conditions=joined(performed.conditions),
        order=performed.order,
        tied=performed.tied | _ties(line, letters),
    )
    return Judged(line, known)


def unproved(line: Line) -> Known:
    """A line that does not follow, to be cited: it holds at most where all does that it cites."""
    cited = () if line.move is None else line.move.cited
    return Known(
        line.id,
        line.equations,
        max((line.scope, *(known.scope for known in cited))),
        joined([c for known in cited for c in known.conditions]),
        called=line.called,
        tied=frozenset[Symbol]().union(*(known.tied for known in cited)),
    )


_ROOTS = ("root", "solve")
"""Moves that make square roots, and say themselves of what this asks that it is not negative."""


def _domain(line: Line, conditions: Sequence[Condition], letters: Letters) -> tuple[Condition, ...]:
    """What must not vanish, or is positive, for a line to say something, if it is not known."""
    found: tuple[Condition, ...] = ()
    for equation in line.equations:
        with suppress(NoMeaningError):
            found += domain(equation, Algebra(letters), (*conditions, *found))
    return found


def _each_needed(
    equations: Sequence[Equation], move: Move, performed: Performed, letters: Letters
) -> None:
    """Raises RefusedError where a line is arrived at without one of its conditions as well.

    Of u > 0 and v > 0 for the logarithm of uv either may be said alone: then both may.
    """

    def is_needed(*conditions: Condition) -> bool:
        try:
            less = replace(move, where=tuple(x for x in move.where if x not in conditions))
            made = arrive(equations, less, letters)
        except RefusedError:
            return True
        # What the move asks for all the same, as a division does, may be said.
        is_asked = {x.expression for x in conditions} <= {c.expression for c in made.conditions}
        return is_asked or not set(made.conditions) <= set(performed.conditions)

    idle = [x for x in move.where if not is_needed(x)]
    if idle and not (len(idle) > 1 and is_needed(*idle)):
        raise RefusedError("{} is a condition without need", idle[0].expression)


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
    if right == const:
        raise RefusedError("{} is not known to be constant: show it by its rate", letter)
    try:
        _as_it_is_used(letter, right, letters)
        nothing = Performed((), Scope.IDENTITY)
        check_braces(
            equation, nothing, line.move, Algebra(letters, put_in(line.move.using, letters))
        )
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
    energies = {x for x in letters.rates if units.is_energy(letters.units.get(x, ""))}
    free = {*letters.coordinates} | energies
    for _ in range(2):  # q̇ and q̈
        free |= {letters.rates[x] for x in free if x in letters.rates}
    for equation in line.equations if scope is Scope.IDENTITY else ():
        here = symbols_of(equation)
        ties = here & free and here <= free | letters.numbers | {TIME}
        # What gives an energy by coordinates and velocities says it for all of them.
        within = {x for side in equation.sides if side.args for x in side.free_symbols}
        states = within - energies - letters.numbers
        gives = bool(states and energies & {*equation.sides} - within)
        gives = gives and states <= {*letters.coordinates} | letters.velocities
        if equation.relation in ("=", "≡") and ((ties and not gives) or const in here):
            pairs = pairs_of(equation, Algebra(letters))
            if not all(agree(pair.left, pair.right) for pair in pairs):
                return Scope.MOTION
    return scope


def _ties(line: Line, letters: Letters) -> frozenset[Symbol]:
    """The numbers that a line ties to one another: it holds for some of them only."""
    tied: set[Symbol] = set()
    for equation in line.equations:
        here = symbols_of(equation)
        if equation.relation in ("=", "≡") and here <= letters.numbers - {*letters.indexed}:
            pairs = pairs_of(equation, Algebra(letters))
            if any(_is_scalar(p) and not agree(p.left, p.right) for p in pairs):
                tied |= here
    return frozenset(tied - letters.vectors)


def _contradiction(
    line: Line, performed: Performed, above: Iterable[Known], letters: Letters
) -> str:
    """Why a line, its conditions and what it rests on can't all hold, or nothing."""
    conditions = performed.conditions
    cited = line.move.cited if line.move is not None else ()
    if len(cited) > 1 and _at_odds(cited, letters):
        return _AGAINST
    if len(cited) != 1 or {*conditions} != {*cited[0].conditions}:  # else asked for above
        resting = [
            (known, equation)
            for known in above
            if known.order is None
            for equation in known.equations
            if equation.relation in ("=", "≡")
        ]
        for backwards in (False, True) if any(c.relation == "=" for c in conditions) else (False,):
            values = _settled(performed, resting, letters, backwards)
            given = {*values} | letters.unit_vectors
            for _, equation in resting:
                # Where a letter is left that nothing gives, no number comes of it.
                if symbols_of(equation) <= given and _is_false(equation, values, letters):
                    return _AGAINST
            if against := _against_conditions(conditions, values, letters):
                return against
    pairs = [p for e in line.equations for p in pairs_of(e, Algebra(letters)) if _is_scalar(p)]
    if any(p.relation in ("<", ">", "≠") and vanishes(p.left - p.right) for p in pairs):
        return _AGAINST
    for relation, sign in ((">", -1), ("<", 1)):
        wrong = [sign * (p.left - p.right) for p in pairs if p.relation == relation]
        if any(bounds.positive(*flat_with(x, conditions)) for x in wrong):
            return _AGAINST
    apart = [p.left - p.right for p in pairs if p.relation in ("=", "≈")]
    if performed.order is not None:  # 0 ≈ 1 − ε says that ε is not small
        nothing = dict.fromkeys(performed.order.letters, 0)
        first = (x.subs(nothing) for x in apart)
        apart += [x for x in first if not x.has(sympy.nan, sympy.zoo, sympy.oo)]
    apart += [x for known in cited for x in _gaps(known, letters)]
    if any(never_vanishes(x, conditions) for x in apart):
        return _AGAINST
    # A limit, such as g = 0, is set for a letter of which g > 0 is known.
    settings = [c.expression for c in conditions if c.relation == "=" and c.expression.args]
    unset = [c for c in conditions if c.relation != "="]
    scalar = [x for x in settings if not {*letters.vectors} & x.free_symbols]
    return _AGAINST if any(never_vanishes(x, unset) for x in scalar) else ""


def _gaps(known: Known, letters: Letters) -> Iterator[Expr]:
    """What vanishes where an equation between scalars holds that is cited as it stands."""
    for equation in known.equations if known.order is None else ():
        for pair in pairs_of(equation, Algebra(letters)):
            if pair.relation == "=" and _is_scalar(pair):
                yield pair.left - pair.right


def _at_odds(cited: Sequence[Known], letters: Letters) -> bool:
    """Whether two of the equations that are cited give a letter values that differ by a number."""
    given: dict[Expr, Value] = {}
    for known in cited:
        for equation in known.equations if known.order is None else ():
            if equation.relation in ("=", "≡") and const not in equation.sides:
                with suppress(RefusedError, NoMeaningError):
                    if given and _is_false(equation, given, letters):
                        return True
                    give(equation, known, given, letters)
    return False


def _settled(
    performed: Performed,
    resting: Sequence[tuple[Known, Equation]],
    letters: Letters,
    backwards: bool,
) -> dict[Expr, Value]:
    """The values that letters have by what is set, and by what gives a letter of a condition."""
    values = where_set(performed.conditions, performed.scope, letters, backwards)
    bounded = {x for c in performed.conditions for x in atoms_of(c.expression)}
    waiting = [*resting] if bounded else []
    while used := [each for each in waiting if bounded & {*each[1].sides}]:
        waiting = [each for each in waiting if each not in used]
        for known, equation in used:
            with suppress(RefusedError, NoMeaningError):
                give(equation, known, values, letters)
            if not any(side.args for side in equation.sides):  # another name for a letter
                bounded |= symbols_of(equation)
    return values


def _is_false(equation: Equation, values: Mapping[Expr, Value], letters: Letters) -> bool:
    """Whether an equation becomes one between different numbers, or different vectors."""
    with suppress(NoMeaningError):
        for pair in pairs_of(equation, Algebra(letters, values)):
            apart = {x: part for x, part in difference(pair.left, pair.right).items() if part != 0}
            if isinstance(pair.left, Vector) or isinstance(pair.right, Vector):
                if not any({*apart} <= {*frame} for frame in letters.frames):
                    continue
            elif isinstance(pair.left, MatrixBase) or isinstance(pair.right, MatrixBase):
                continue
            if any(part.is_number and not vanishes(part) for part in apart.values()):
                return True
    return False


def _against_conditions(
    conditions: Sequence[Condition], values: Mapping[Expr, Value], letters: Letters
) -> str:
    """Which condition does not hold with these values, or nothing."""
    there = Algebra(letters, values)
    positive = [there.value(c.expression) for c in conditions if c.relation == ">"]
    weak = [there.value(c.expression) for c in conditions if c.relation == "≥"]
    if any(flattened(value)[0].is_nonpositive for value in positive) or any(
        flattened(value)[0].is_negative for value in weak
    ):
        return _AGAINST
    if any(one + other == 0 for one in positive for other in (*positive, *weak)):
        return _AGAINST  # x > a and x < a
    for condition in conditions:
        if condition.relation in ("≠", ">") and {*values} & {*atoms_of(condition.expression)}:
            value = there.value(condition.expression)
            if vanishes(value):
                return "a division by 0" if condition.lost else _AGAINST
            flat, strict = flat_with(-value, [c for c in conditions if c is not condition])
            sizes = [each.lhs for each in strict if each.rel_op == ">"]
            asked = condition.relation == ">" and not decide.branches(flat)
            negative = asked and decide.in_digits([(">", flat)], bounds=sizes)
            if negative and bounds.positive(flat, strict):
                return _AGAINST
    return ""


_AGAINST = "this can't hold: what is cited contradicts what is set or divided by"


def _is_scalar(pair: Pair) -> bool:
    return not any(
        isinstance(side, (Vector, MatrixBase)) or not side.is_commutative for side in pair.sides
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
