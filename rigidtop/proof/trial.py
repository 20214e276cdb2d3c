"""Lines on trial: what they cite for nothing, what else would follow, what refutes them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import islice

import sympy
from sympy import Expr, Integer, Symbol

from rigidtop.proof import floats
from rigidtop.proof.algebra import Algebra
from rigidtop.proof.arrive import arrive
from rigidtop.proof.changed import perturbations
from rigidtop.proof.derivation import Line
from rigidtop.proof.equation import Equation, NoMeaningError, symbols_of
from rigidtop.proof.factor import factor_of
from rigidtop.proof.letters import Letters
from rigidtop.proof.moves import Known, Move, Pair, RefusedError, pairs_of, perform, put_in
from rigidtop.proof.values import Vector, components, flattened, vanishes


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
        for part in components(pair.left, pair.right):
            if not vanishes(part):
                return _numbers(pair, letters)
    return Diagnosis(True)


def _numbers(pair: Pair, letters: Letters) -> Diagnosis | None:
    """Short numbers at which the two sides differ."""
    if isinstance(pair.left, Vector) or isinstance(pair.right, Vector):
        return Diagnosis(False)
    flat, nodes = flattened(sympy.Tuple(pair.left, pair.right))
    sides = list(flat)
    for point, number in floats.places(sides, exists=letters.exists):
        if floats.apart(*map(number, sides)):
            at = {nodes.get(x, x): value for x, value in point.items()}
            return Diagnosis(False, at, *(side.xreplace(point) for side in sides))
    return None


@dataclass(frozen=True)
class ChangedLine:
    """A line with one thing changed, and what it was."""

    line: Line
    what: str


def changes(line: Line, letters: Letters, others: Sequence[Known] = ()) -> Iterator[ChangedLine]:
    """A line with a sign, factor or function changed; another equation cited, another move."""
    for k, equation in enumerate(line.equations):
        for changed in perturbations(equation, letters.families):
            yield ChangedLine(_with_equation(line, k, changed.equation), changed.change)
        for i, side in enumerate(equation.sides):
            for letter in _letters(equation) if side == 0 else ():
                sides = (*equation.sides[:i], letter, *equation.sides[i + 1 :])
                new = Equation(*sides, relation=equation.relation, tag=equation.tag)
                yield ChangedLine(_with_equation(line, k, new), f"{letter} for 0")
    move = line.move
    if move is None or move.verb == "call":
        return
    for other in others:
        if other.id == line.id or any(other.equations == k.equations for k in move.cited):
            continue
        for k in range(len(move.of)):
            of = (*move.of[:k], other, *move.of[k + 1 :])
            yield ChangedLine(replace(line, move=replace(move, of=of)), f"{other.id} cited instead")
    for verb in ("rate", "square"):
        if verb != move.verb:
            made = replace(move, verb=verb, by=())
            yield ChangedLine(replace(line, move=made), f"{verb} instead of {move.verb}")


def survivors(
    line: Line, letters: Letters, others: Sequence[Known] = (), every: int = 1
) -> tuple[int, tuple[str, ...]]:
    """How many changes of a line that follows say something else, and which of them follow too.

    Every so many are tried.  What says the same as the line, such as cos(−θ) for cos θ, or as
    another of its equations, is no change.
    """
    assert line.move is not None
    performed = perform(line.move, letters)
    tried, survived = 0, []
    for change in islice(changes(line, letters, others), 0, None, every):
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
            factor_of(a, b, nothing) is not None for a, b in zip(*pairs, strict=True)
        )
    except (NoMeaningError, RefusedError, TypeError, AttributeError):
        return False
