"""What is done with equations: moves, performed.

A move takes cited equations and makes new ones of them.  It knows no model: what it does not find
in the equations that are cited, it does not use.  What can't be done raises `RefusedError`, with
the reason in words.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from enum import IntEnum
from functools import partial
from typing import Any

import sympy
from sympy import Add, Dummy, Expr, Integer, MatrixBase, Mul, Symbol

from rigidtop.proof import decide
from rigidtop.proof.algebra import (
    TIME,
    Algebra,
    Applied,
    Letters,
    Value,
    Vector,
    agree,
    atoms_of,
    components,
    flattened,
    vanishes,
)
from rigidtop.proof.equation import (
    Dot,
    Equation,
    NoMeaningError,
    Partial,
    Printed,
    Rate,
    SumOver,
    Underbrace,
    VolumeIntegral,
    as_printed,
)
from rigidtop.theory.symbols import const
from rigidtop.theory.trig import reduce_ratio, reduce_trig


class RefusedError(Exception):
    """A move that can't be made, and why: `nodes` stand where the message has braces."""

    def __init__(self, message: str, *nodes: Any) -> None:
        super().__init__(message, *nodes)
        self.message, self.nodes = message, nodes

    def __str__(self) -> str:
        return self.words()

    def words(self, said: Callable[[Any], str] = str) -> str:
        """The message, what stands in it printed by `said`."""
        return self.message.format(*(x if isinstance(x, str) else said(x) for x in self.nodes))


class Scope(IntEnum):
    """Where an equation holds; what rests on several holds where all of them do."""

    IDENTITY = 0
    """For all coordinates and velocities: it may be differentiated by either."""
    MOTION = 1
    """Along the motion: it may be differentiated in time."""
    SET = 2
    """Where something is set, at a moment: it may not be differentiated."""


@dataclass(frozen=True)
class Order:
    """What is neglected is of this order in a small letter: ``Order(epsilon, 2)`` is O(ε²).

    Letters that are small together are counted together: each is as small as `small`.
    """

    small: Symbol
    power: int
    together: tuple[Symbol, ...] = ()

    def counted(self, expression: Expr) -> Expr:
        """An expression with `small` before each of the letters that are small together."""
        return expression.xreplace({x: self.small * x for x in self.together})

    def lowest(self, expression: Expr) -> int:
        """The power of what is small with which an expression begins."""
        counted = self.counted(expression)
        if not counted.has(self.small):
            return 0
        _, power = counted.as_leading_term(self.small).as_coeff_exponent(self.small)
        return int(sympy.floor(power))


@dataclass(frozen=True)
class Condition:
    """What has to hold besides: `expression` ≠, >, ≥ or = 0, or 0 at the "start".

    `lost`: a branch ends there.
    """

    expression: Expr
    relation: str = "≠"
    lost: bool = False


@dataclass(frozen=True)
class Pair:
    """Two values with a relation between them."""

    left: Value
    right: Value
    relation: str = "="


@dataclass(frozen=True)
class Known:
    """Equations that may be cited: a law, a definition, a line that stands.

    `called` is what sentences call it; `defines` is the letter that it introduces.
    """

    id: str
    equations: tuple[Equation, ...]
    scope: Scope = Scope.IDENTITY
    conditions: tuple[Condition, ...] = ()
    order: Order | None = None
    called: str = ""
    defines: Symbol | None = None

    @property
    def tag(self) -> str:
        return next((e.tag for e in self.equations if e.tag), "")


@dataclass(frozen=True)
class Move:
    """What a sentence says is done.

    `verb` names the move, `of` what it is done with, `using` what is put in besides.  `by` are
    expressions: a factor, a variable, axes, values.
    """

    verb: str
    of: tuple[Known, ...] = ()
    using: tuple[Known, ...] = ()
    by: tuple[Any, ...] = ()
    power: int = 0
    where: tuple[Condition, ...] = ()
    words: str = ""

    @property
    def cited(self) -> tuple[Known, ...]:
        return (*self.of, *(k for k in self.using if k not in self.of))


@dataclass(frozen=True)
class Performed:
    """What a move arrives at.  `given` is put into the line as well, before they are compared."""

    pairs: tuple[Pair, ...]
    scope: Scope
    conditions: tuple[Condition, ...] = ()
    order: Order | None = None
    given: Mapping[Any, Value] = field(default_factory=dict)
    every: bool = False
    """Whether the line has to show all pairs (both roots)."""


# --- equations as values --------------------------------------------------------------------------


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
        vector = _single(pair.left) if isinstance(pair.left, Vector) else None
        for (axis, of), letter in algebra.letters.components.items():
            if vector is not None and of == vector[0] and isinstance(pair.right, Vector):
                along = Vector({axis: Integer(1)})
                made.append(Pair(algebra.atom(letter), algebra.dot(along, pair.right)))
    return made


def put_in(known: Sequence[Known], letters: Letters) -> dict[Any, Value]:
    """What to put in for atoms, so that the equations hold: each equation gives one atom."""
    given: dict[Any, Value] = {}
    for each in known:
        for equation in each.equations:
            _give(equation, each, given, letters)
    return given


def _give(equation: Equation, source: Known, given: dict[Any, Value], letters: Letters) -> None:
    if equation.relation not in ("=", "≡", "≈"):
        raise RefusedError(
            "{} says {}: only an equation can be put in", _name(source), equation.relation
        )
    algebra = Algebra(letters, given)
    sides = [side for side in equation.sides if side != const]
    if const in equation.sides:
        atoms = [a for side in sides if (a := _single(algebra.rate(Algebra(letters).value(side))))]
        if not atoms:
            raise RefusedError("{} says that a sum is constant: take the rate of it", _name(source))
        given.update((atom, Integer(0)) for atom, _ in atoms)
    # Each side as what it is; the first that is an atom gives way to the others: a letter before
    # a letter with a positive factor, such as m r̈.
    bare = Algebra(letters)
    raw = [bare.value(side) for side in sides]
    for i in range(len(sides) - 1):
        left, right = raw[i], raw[i + 1]
        both = ((left, right), (right, left))
        for atom, other in (
            *((_single(side), other) for side, other in both),
            *((_scaled_atom(side), other) for side, other in both),
        ):
            if atom is None or atom[0] in given or atom[0] in set(atoms_of(other)):
                continue
            value = algebra.value(other)
            if atom[0] in set(atoms_of(value)):
                continue
            solved = algebra.times(1 / atom[1], value) if atom[1] != 1 else value
            _settle(given, atom[0], solved, letters)
            break
        else:
            left_now, right_now = algebra.value(sides[i]), algebra.value(sides[i + 1])
            if agree(left_now, right_now):
                continue
            if _differ_by_number(left_now, right_now):
                raise RefusedError("what is cited contradicts itself: see {}", _name(source))
            raise RefusedError(
                "{} gives no letter to put in: solve it for one first", _name(source)
            )


def _differ_by_number(left: Value, right: Value) -> bool:
    return any(part.is_number and part != 0 for part in components(left, right))


def _settle(given: dict[Any, Value], atom: Any, value: Value, letters: Letters) -> None:
    """Put a value in for an atom, also in what is given already."""
    one = Algebra(letters, {atom: value})
    for old in list(given):
        given[old] = one.value(given[old])
    given[atom] = value


def _single(value: Value) -> tuple[Any, Expr] | None:
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


def _scaled_atom(value: Value) -> tuple[Any, Expr] | None:
    """The atom of a value that is one vector, or one product or rate, times what can't vanish."""
    if isinstance(value, Vector) and len(value.terms) == 1:
        [(atom, factor)] = value.terms.items()
    elif isinstance(value, Mul) and len(made := [f for f in value.args if f.func in _MADE]) == 1:
        [atom], factor = made, value / made[0]
    else:
        return None
    return (atom, factor) if nonzero(factor, ()) else None


_MADE = (Dot, Rate)


def _name(known: Known) -> str:
    return known.called or (f"({known.tag})" if known.tag else known.id)


# --- performing -----------------------------------------------------------------------------------


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
    conditions = list(made.conditions)
    for each in (*move.of, *move.using):
        conditions += [c for c in each.conditions if c not in conditions]
    conditions += [c for c in move.where if c not in conditions]
    _one_start([c.expression for c in conditions if c.relation == "start"], letters)
    scope = max((made.scope, *(k.scope for k in move.cited)), default=made.scope)
    return replace(made, scope=scope, conditions=tuple(conditions))


def _one_start(starts: Sequence[Expr], letters: Letters) -> None:
    """Refuse what is cited of two motions, which start with different values of a letter."""
    for k, start in enumerate(starts):
        for other in starts[:k]:
            difference = sympy.expand(start - other)
            if difference.free_symbols <= letters.numbers and not vanishes(difference):
                raise RefusedError("what is cited starts in two ways: {} and {}", other, start)


def _with(made: Performed, move: Move, letters: Letters) -> Performed:
    """What was made, with more put into it."""
    for each in move.using:
        if each.scope is Scope.SET:
            _reaches_into(each, made.pairs, letters)
    given = put_in(move.using, letters)
    if made.scope is not Scope.SET:  # what is set at all times is set in what is put in as well
        always = Algebra(letters, made.given)
        given = {old: always.value(new) for old, new in given.items()}
    for old, new in made.given.items():
        given.setdefault(old, new)
    algebra = Algebra(letters, given)
    pairs = tuple(
        replace(pair, left=algebra.value(pair.left), right=algebra.value(pair.right))
        for pair in made.pairs
    )
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
    """The order of the error that an approximate value brings into what it is put in for."""
    mark = Dummy("error")
    given = put_in([known], letters)
    error = mark * order.small**order.power
    wrong = {
        atom: value + (Vector({atom: error}) if isinstance(value, Vector) else error)
        for atom, value in given.items()
        if not isinstance(value, MatrixBase)
    }
    lowest = order.power
    right, off = Algebra(letters, given), Algebra(letters, {**given, **wrong})
    for side in (side for pair in pairs for side in (pair.left, pair.right)):
        for change in components(off.value(side), right.value(side)):
            slope = flattened(change)[0].diff(mark).subs(mark, 0)
            if slope != 0:
                lowest = min(lowest, order.lowest(slope))
    return replace(order, power=lowest)


def _reaches_into(known: Known, pairs: Sequence[Pair], letters: Letters) -> None:
    """Refuse to put what is set at a moment under a rate or a slope."""
    atoms = set(put_in([known], letters))
    for pair in pairs:
        for side in (pair.left, pair.right):
            for node in atoms_of(side):
                inner = {x for part in getattr(node, "args", ()) for x in (part, *_nodes(part))}
                if isinstance(node, Rate) and inner & atoms:
                    raise RefusedError(
                        "{} is set at a moment: it can't be put in before the derivative is taken",
                        _name(known),
                    )


def _nodes(tree: Any) -> set[Any]:
    return set(sympy.preorder_traversal(tree))


def _one(move: Move) -> Known:
    if len(move.of) != 1:
        raise RefusedError("{} acts on one equation, not on {}", move.verb, len(move.of))
    return move.of[0]


def _all_pairs(known: Known, algebra: Algebra) -> list[Pair]:
    return [p for e in known.equations for p in pairs_of(e, algebra, chain=True)]


def _said(known: Known, algebra: Algebra) -> list[Pair]:
    """The pairs of equal sides; of a chain that ends in a constant, without its rate."""
    pairs = []
    for equation in known.equations:
        sides = [side for side in equation.sides if side != const]
        if len(sides) > 1:
            equation = Equation(*sides, relation=equation.relation)
        pairs += [p for p in pairs_of(equation, algebra, chain=True) if _equal(p)]
    return pairs


def _put(move: Move, algebra: Algebra) -> Performed:
    """Put … into …: the equation as it is; what is put in follows."""
    known = _one(move)
    return Performed(tuple(_all_pairs(known, algebra)), known.scope, order=known.order)


def _differentiate(move: Move, algebra: Algebra) -> Performed:
    known = _one(move)
    [by] = move.by
    if not isinstance(by, Symbol):
        raise RefusedError("{} is no letter to differentiate by", by)
    if known.scope is not Scope.IDENTITY:
        holds = "where something is set" if known.scope is Scope.SET else "along the motion only"
        raise RefusedError(
            "{} holds {}: it can't be differentiated by {}, of which it says nothing elsewhere",
            _name(known),
            holds,
            by,
        )
    if known.order is not None:
        raise RefusedError(
            "{} is approximate: the slope of what is neglected is not known", _name(known)
        )
    made: list[Pair] = []
    for pair in _all_pairs(known, algebra):
        if not isinstance(pair.left, Symbol):
            continue
        held = algebra.letters.arguments(pair.left)
        if by not in held:
            raise RefusedError("{} is no function of {}", pair.left, by)
        slope = _slope(pair.right, by, held, known, algebra)
        made.append(Pair(Partial(pair.left, by), slope))
    if not made:
        raise RefusedError(
            "{} does not give a letter as a function: solve it for one", _name(known)
        )
    return Performed(tuple(made), known.scope)


def _slope(
    value: Value, by: Symbol, held: frozenset[Symbol], known: Known, algebra: Algebra
) -> Expr:
    """The derivative of a function of what is `held`, but for `by`."""
    if isinstance(value, (Vector, MatrixBase)):
        raise RefusedError("partial derivatives are taken of scalars")
    letters = algebra.letters
    flat, atoms = flattened(value)
    slope = flat.diff(by)
    for x in flat.free_symbols - held - {by}:
        node = atoms.get(x, x)
        if node in letters.functions and letters.arguments(node) <= held:
            if by in letters.functions[node]:
                slope += flat.diff(x) * Partial(node, by)  # the chain rule
        elif not (by in letters.velocities and letters.is_placed(node)):
            raise RefusedError(
                "{} in {} depends on the coordinates and velocities: write it out before you "
                "differentiate by {}",
                node,
                _name(known),
                by,
            )
    return slope.xreplace(atoms)


def _rate(move: Move, algebra: Algebra) -> Performed:
    known = _one(move)
    frame = move.by[0] if move.by else None
    if known.scope is Scope.SET:
        raise RefusedError(
            "{} holds where something is set, at a moment: its rate does not follow", _name(known)
        )
    if known.order is not None:
        raise RefusedError(
            "{} is approximate: the rate of what is neglected is not known", _name(known)
        )
    pairs = [
        Pair(algebra.rate(pair.left, frame), algebra.rate(pair.right, frame))
        for pair in _all_pairs(known, algebra)
        if _equal(pair)
    ]
    return Performed(tuple(pairs), known.scope)


def _integrate(move: Move, algebra: Algebra) -> Performed:
    """Over time: what has no rate is constant.  A line that says more is tried by its rate."""
    known = _one(move)
    if known.scope is Scope.SET:
        raise RefusedError("{} holds at a moment: it can't be integrated", _name(known))
    starts = tuple(
        Condition(algebra.value(e.sides[0]) - algebra.value(e.sides[1]), "start")
        for e in move.by
        if not isinstance(algebra.value(e.sides[0]), Vector)
    )
    return Performed(tuple(_all_pairs(known, algebra)), Scope.MOTION, starts, known.order)


def _equal(pair: Pair) -> bool:
    if pair.relation not in ("=", "≡"):
        raise RefusedError("a relation {} can't be treated so", pair.relation)
    return True


def _map(move: Move, algebra: Algebra, change: Callable[[Value], Value]) -> Performed:
    known = _one(move)
    pairs = [
        replace(pair, left=change(pair.left), right=change(pair.right))
        for pair in _all_pairs(known, algebra)
        if pair.relation in ("=", "≈") or _equal(pair)
    ]
    return Performed(tuple(pairs), known.scope, order=known.order)


def _component(move: Move, algebra: Algebra) -> Performed:
    """Along one axis, or along several: the scalar product with each."""
    pairs: list[Pair] = []
    known = _one(move)
    for axis in move.by:
        pairs += _map(move, algebra, partial(algebra.dot, algebra.value(axis))).pairs
    return Performed(tuple(pairs), known.scope, order=known.order)


def _dot(move: Move, algebra: Algebra) -> Performed:
    return _product(move, algebra, algebra.dot)


def _cross(move: Move, algebra: Algebra) -> Performed:
    return _product(move, algebra, algebra.cross)


def _product(move: Move, algebra: Algebra, times: Callable[[Value, Value], Value]) -> Performed:
    if len(move.of) == 2:
        first, second = (_all_pairs(k, algebra) for k in move.of)
        pairs = [
            Pair(times(p.left, q.left), times(p.right, q.right))
            for p in first
            for q in second
            if _equal(p) and _equal(q)
        ]
        return Performed(tuple(pairs), max(k.scope for k in move.of))
    [by] = move.by
    vector = algebra.value(by)
    return _map(move, algebra, lambda v: times(vector, v) if move.power == 0 else times(v, vector))


def _sum(sign: int) -> Callable[[Move, Algebra], Performed]:
    def combine(move: Move, algebra: Algebra) -> Performed:
        """Add … to …, subtract … from …; `by` are the factors that each is taken with."""
        factors = [algebra.value(f) for f in move.by] or [Integer(1)] * len(move.of)
        if len(move.of) != 2:
            raise RefusedError("{} takes two equations", move.verb)
        first, second = (
            [(algebra.times(f, p.left), algebra.times(f, p.right)) for p in _said(k, algebra)]
            for k, f in zip(move.of, factors, strict=True)
        )
        minus = Integer(sign)
        pairs = [
            Pair(
                algebra.total([c, algebra.times(minus, a)]),
                algebra.total([d, algebra.times(minus, b)]),
            )
            for a, b in first
            for c, d in second
        ]
        return Performed(tuple(pairs), max(k.scope for k in move.of))

    return combine


def _sum_over(move: Move, algebra: Algebra) -> Performed:
    """Over all parts of a body, for each of which the equation holds."""
    [index] = move.by
    return _map(
        move, algebra, lambda v: v if v == 0 else algebra.summed(SumOver(index, Integer(1)), v)
    )


def _multiply(move: Move, algebra: Algebra) -> Performed:
    [by] = move.by
    factor = algebra.value(by)
    known = _one(move)
    if any(p.relation in ("<", ">", "≤", "≥") for p in _all_pairs(known, algebra)):
        return _scaled(known, factor, algebra, move)
    right = move.power == 1
    made = _map(
        move, algebra, lambda v: algebra.times(v, factor) if right else algebra.times(factor, v)
    )
    return replace(made, order=_shifted(known.order, factor))


def _scaled(known: Known, factor: Expr, algebra: Algebra, move: Move) -> Performed:
    if not decide.positive(*_flat_with(factor, move.where)):
        raise RefusedError("{} has no known sign: an inequality may turn round", factor)
    pairs = [
        replace(p, left=algebra.times(factor, p.left), right=algebra.times(factor, p.right))
        for p in _all_pairs(known, algebra)
    ]
    return Performed(tuple(pairs), known.scope)


def _divide(move: Move, algebra: Algebra) -> Performed:
    [by] = move.by
    factor = algebra.value(by)
    if isinstance(factor, (Vector, MatrixBase)) or not factor.is_commutative:
        raise RefusedError("a division by what is no scalar")
    known = _one(move)
    if vanishes(factor) or vanishes(_where_set(known, algebra.letters).value(factor)):
        raise RefusedError("a division by 0")
    made = _multiply(replace(move, by=(1 / factor,)), algebra)
    return replace(made, conditions=divided_by(factor, ()))


def _where_set(known: Known, letters: Letters) -> Algebra:
    """What has been set for an equation to hold, put in: at all times with its rate."""
    given: dict[Any, Value] = {}
    for condition in known.conditions:
        if condition.relation != "=":
            continue
        difference = Algebra(letters, given).value(condition.expression)
        for x in sorted(difference.free_symbols, key=str):
            slope = difference.diff(x)
            if slope.is_number and slope != 0:
                value = x - difference / slope
                _settle(given, x, value, letters)
                if known.scope is not Scope.SET and value.free_symbols <= letters.numbers:
                    while x in letters.rates:
                        x = letters.rates[x]
                        given[x] = Integer(0)
                break
    return Algebra(letters, given)


def divided_by(factor: Expr, conditions: Sequence[Condition]) -> tuple[Condition, ...]:
    """The conditions that a division brings: each factor that may vanish does not."""
    if nonzero(factor, conditions):
        return ()
    flat, nodes = flattened(factor)
    bases = [f.as_base_exp()[0] for f in Mul.make_args(reduce_ratio(flat))]
    made = [b.xreplace(nodes) for b in bases if not b.is_number]
    return tuple(Condition(b, "≠", lost=True) for b in made if not nonzero(b, conditions))


def nonzero(factor: Expr, conditions: Sequence[Condition]) -> bool:
    """Whether an expression is known not to vanish."""
    flat, relations = _flat_with(factor, conditions)
    return decide.nonzero(flat, relations) or any(
        decide.positive(sign * flat, relations) for sign in (1, -1)
    )


_STRICT = {"≠": sympy.Ne, ">": sympy.Gt}


def _flat_with(value: Expr, conditions: Sequence[Condition]) -> tuple[Expr, list[Any]]:
    """A value and strict relations, what is no letter being the same in all of them."""
    strict = [c for c in conditions if c.relation in _STRICT]
    [flat, *known] = flattened(sympy.Tuple(value, *(c.expression for c in strict)))[0]
    return flat, [_STRICT[c.relation](x, 0) for c, x in zip(strict, known, strict=True)]


def _shifted(order: Order | None, factor: Expr) -> Order | None:
    """The order of an error that is multiplied by a factor."""
    if order is None:
        return None
    lowest = min((order.lowest(x) for x in scalars(factor)), default=0)
    return replace(order, power=order.power + lowest)


def _rewrite(move: Move, algebra: Algebra) -> Performed:
    """As it is, or several together."""
    if len(move.of) > 1 and any(known.order is not None for known in move.of):
        raise RefusedError("what is approximate is rewritten by itself")
    pairs = tuple(pair for known in move.of for pair in _all_pairs(known, algebra))
    scope = max((known.scope for known in move.of), default=Scope.IDENTITY)
    return Performed(pairs, scope, order=_one(move).order if len(move.of) == 1 else None)


# --- operators ------------------------------------------------------------------------------------


def _is_operator(value: Value) -> bool:
    return isinstance(value, MatrixBase) or (
        not isinstance(value, Vector) and not value.is_commutative
    )


def _of_operators(
    change: Callable[[Algebra], Callable[[Value], Value]],
) -> Callable[[Move, Algebra], Performed]:
    """The same done with both sides, of which one at least is a matrix."""

    def changed(move: Move, algebra: Algebra) -> Performed:
        pairs = _all_pairs(_one(move), algebra)
        if not all(_is_operator(p.left) or _is_operator(p.right) for p in pairs):
            raise RefusedError("{} says nothing of matrices", _name(_one(move)))
        return _map(move, algebra, change(algebra))

    return changed


def _exchange_factors(move: Move, algebra: Algebra) -> Performed:
    """Where a product of square matrices is 1, it is with its factors in turn: XY = 1, YX = 1."""
    known = _one(move)
    pairs: list[Pair] = []
    for pair in _all_pairs(known, algebra):
        if not _equal(pair) or pair.right != 1 or not _is_operator(pair.left):
            raise RefusedError("only where a product is 1 can its factors be exchanged")
        scalars, factors = pair.left.args_cnc()
        for k in range(1, len(factors)):
            turned = Mul(*scalars, *factors[k:], *factors[:k])
            pairs.append(Pair(turned, Integer(1)))
    return Performed(tuple(pairs), known.scope)


def _strip(move: Move, algebra: Algebra) -> Performed:
    """What does the same to all vectors is the same: of Au = Bu for every axis u, A = B.

    u·Av = … for all pairs of axes gives the entries of A; `by` may also be letters for any vector.
    """
    axes = [_atom(algebra.value(x), x) for x in move.by]
    if any(known.order is not None for known in move.of):
        raise RefusedError("{} is approximate", _name(move.of[0]))
    pairs = [p for known in move.of for p in _all_pairs(known, algebra) if _equal(p)]
    scope = max(known.scope for known in move.of)
    letters = algebra.letters
    if any(set(axes) == set(frame) for frame in letters.frames) and len(axes) == 3:
        made = _on_axes(pairs, axes, algebra)
    elif set(axes) <= letters.arbitrary and len(set(axes)) == len(axes) <= 2:
        limits = {
            x for known in move.of for c in known.conditions for x in c.expression.free_symbols
        }
        if scope is Scope.SET or limits & {*axes}:
            raise RefusedError("{} does not hold for any vector", _name(move.of[0]))
        made = _on_any(pairs, axes, algebra)
    else:
        raise RefusedError("three axes of a frame, or letters for any vector, can be stripped")
    if not made:
        raise RefusedError("the two sides are not known for all of them")
    return Performed(tuple(made), scope)


def _on_axes(pairs: Sequence[Pair], axes: Sequence[Any], algebra: Algebra) -> list[Pair]:
    images: dict[Any, list[tuple[Expr, Vector]]] = {u: [] for u in axes}
    entries: dict[Any, dict[tuple[int, int], Expr]] = {}
    for pair in pairs:
        for left, right in ((pair.left, pair.right), (pair.right, pair.left)):
            for u in axes:
                operator = _acting(left, u)
                if operator is not None:
                    images[u].append((operator, right if isinstance(right, Vector) else Vector({})))
            _enter(left, right, axes, entries, algebra)
    made = []
    first, *others = axes
    for operator, image in images[first]:
        row = [image]
        for u in others:
            row += [image for same, image in images[u] if same == operator][:1]
        if len(row) < 3:
            continue
        acting = [_acting(image, u) for image, u in zip(row, axes, strict=True)]
        if acting[0] is not None and acting[0] == acting[1] == acting[2]:
            made.append(Pair(operator, acting[0]))
        columns = [[image.terms.get(u, Integer(0)) for u in axes] for image in row]
        if all(set(image.terms) <= set(axes) for image in row):
            made.append(Pair(operator, _plain(sympy.Matrix(columns).T)))
    for operator, found in entries.items():
        if len(found) == 9:
            entries_of = [found[divmod(k, 3)] for k in range(9)]
            made.append(Pair(operator, _plain(sympy.Matrix(3, 3, entries_of))))
    return [pair for pair in made if _is_operator(pair.left)]


def _acting(value: Value, u: Any) -> Expr | None:
    """The operator A of a vector Au; None if it is no such vector."""
    if not isinstance(value, Vector):
        return None
    made: Expr = Integer(0)
    for atom, factor in value.terms.items():
        if factor == 0:
            continue
        if atom != u and not (isinstance(atom, Applied) and atom.args[1] == u):
            return None
        made += factor * (atom.args[0] if atom != u else 1)
    return sympy.expand(made)


def _enter(
    left: Value,
    right: Value,
    axes: Sequence[Any],
    entries: dict[Any, dict[tuple[int, int], Expr]],
    algebra: Algebra,
) -> None:
    """Of u·Av = c the entry of A, and that of its transpose."""
    found = _single(left)
    if found is None or isinstance(right, (Vector, MatrixBase)) or not isinstance(found[0], Dot):
        return
    u, image = found[0].args
    if isinstance(image, Applied) and u in axes and image.args[1] in axes:
        i, j = axes.index(u), axes.index(image.args[1])
        operator = image.args[0]
        entries.setdefault(operator, {})[i, j] = right / found[1]
        entries.setdefault(algebra.transposed(operator), {})[j, i] = right / found[1]


def _plain(matrix: MatrixBase) -> Value:
    """A number in place of its multiple of the unit matrix."""
    return matrix[0, 0] if matrix == matrix[0, 0] * sympy.eye(3) else matrix


def _on_any(pairs: Sequence[Pair], axes: Sequence[Any], algebra: Algebra) -> list[Pair]:
    made = []
    for pair in pairs:
        left, right = (
            _acting(side, axes[0]) if len(axes) == 1 else _between(side, axes[0], axes[1], algebra)
            for side in (pair.left, pair.right)
        )
        if left is None or right is None or (left.free_symbols | right.free_symbols) & {*axes}:
            continue
        made.append(Pair(left, right))
    return made


def _between(value: Value, u: Any, v: Any, algebra: Algebra) -> Expr | None:
    """The operator A of a scalar u·Av; None if it is no such scalar."""
    if isinstance(value, (Vector, MatrixBase)):
        return None
    made: Expr = Integer(0)
    for term in Add.make_args(sympy.expand(value)):
        [*dots] = term.atoms(Dot)
        if term == 0:
            continue
        if len(dots) != 1:
            return None
        [product] = dots
        factor = term / product
        left, image = product.args
        operator, right = image.args if isinstance(image, Applied) else (Integer(1), image)
        if factor.has(Dot) or {left, right} != {u, v}:
            return None
        made += factor * (operator if left == u else algebra.transposed(operator))
    return sympy.expand(made)


def _exchange(move: Move, algebra: Algebra) -> Performed:
    """Two indices change places: what holds for any two parts, holds for them the other way."""
    known = _one(move)
    one, two = move.by
    letters = algebra.letters
    there = {**letters.exchanged, **{new: old for old, new in letters.exchanged.items()}}

    def turned(tree: Any) -> Any:
        if isinstance(tree, (SumOver, VolumeIntegral)):
            index, body = tree.args
            return tree.func({one: two, two: one}.get(index, index), turned(body))
        if isinstance(tree, Symbol):
            if letters.indexed.get(tree, frozenset()) & {one, two}:
                if tree not in there:
                    raise RefusedError("{} with the other index has no letter", tree)
                return there[tree]
            return tree
        if not tree.args:
            return tree
        with as_printed():
            return tree.func(*map(turned, tree.args))

    pairs = [
        pair
        for e in known.equations
        for pair in pairs_of(
            Equation(*map(turned, e.sides), relation=e.relation), algebra, chain=True
        )
    ]
    return Performed(tuple(pairs), known.scope, order=known.order)


def _solve(move: Move, algebra: Algebra) -> Performed:
    """For one letter or vector, or more: linear, or the roots of a quadratic."""
    unknowns = [_atom(algebra.value(x), x) for x in move.by]
    if len(move.of) > len(unknowns):
        raise RefusedError("more equations than unknowns")
    pairs = [p for k in move.of for p in _all_pairs(k, algebra) if _equal(p)]
    if any(_is_operator(side) for p in pairs for side in (p.left, p.right)):
        raise RefusedError("a matrix equation is not solved so: multiply by what takes it away")
    scope = max(k.scope for k in move.of)
    atoms = {x: Dummy() for x in unknowns}
    rows = [_linear(components_of(pair), atoms) for pair in pairs]
    if all(row is not None for row in rows):
        return _solved_linear(move, [r for row in rows if row for r in row], atoms, scope)
    if len(unknowns) == 1 and len(pairs) == 1:
        return _roots(pairs[0], unknowns[0], scope)
    raise RefusedError("this is not linear in {}", *move.by)


def _atom(value: Value, typed: Any) -> Any:
    single = _single(value)
    if single is None:
        raise RefusedError("{} is nothing to solve for", typed)
    return single[0]


def components_of(pair: Pair) -> Any:
    """left − right: a scalar, or a vector as a mapping."""
    if isinstance(pair.left, Vector) or isinstance(pair.right, Vector):
        left = pair.left if isinstance(pair.left, Vector) else Vector({})
        right = pair.right if isinstance(pair.right, Vector) else Vector({})
        return dict((left + right.times(Integer(-1))).terms)
    return pair.left - pair.right


def _linear(
    difference: Any, atoms: Mapping[Any, Symbol]
) -> list[tuple[dict[Any, Any], Any]] | None:
    """(coefficients of the unknowns, the rest), where they enter linearly; vectors are one row."""
    if isinstance(difference, dict):
        coefficients = {x: difference.get(x, Integer(0)) for x in atoms}
        rest = {a: f for a, f in difference.items() if a not in atoms}
        return [(coefficients, Vector(rest))]
    flat, nodes = flattened(difference)
    back = {node: dummy for dummy, node in nodes.items()}
    unknowns = [back.get(x, x) for x in atoms]
    expanded = sympy.expand(flat)
    coefficients = {}
    rest = expanded
    for x, unknown in zip(atoms, unknowns, strict=True):
        coefficient = expanded.diff(unknown) if isinstance(unknown, Symbol) else Integer(0)
        if coefficient.free_symbols & {u for u in unknowns if isinstance(u, Symbol)}:
            return None
        coefficients[x] = coefficient.xreplace(nodes)
        rest = rest.subs(unknown, 0) if isinstance(unknown, Symbol) else rest
    return [(coefficients, rest.xreplace(nodes))]


def _solved_linear(
    move: Move, rows: list[tuple[dict[Any, Any], Any]], atoms: Mapping[Any, Symbol], scope: Scope
) -> Performed:
    """Gauss: as many rows as unknowns; what is not asked for is eliminated besides."""
    wanted = list(atoms)
    rows = [row for row in rows if any(c != 0 for c in row[0].values())]
    if len(rows) < len(wanted):
        raise RefusedError("fewer equations than unknowns")
    rows = rows[: len(wanted)]
    matrix = sympy.Matrix([[row[0][x] for x in wanted] for row in rows])
    determinant = _reduced(matrix.det())
    if determinant == 0:
        raise RefusedError("these equations do not determine what is asked for")
    inverse = matrix.adjugate().applyfunc(_reduced)
    pairs = []
    for i, x in enumerate(wanted):
        total: Any = None
        for j, row in enumerate(rows):
            share = -inverse[i, j] / determinant
            part = row[1].times(share) if isinstance(row[1], Vector) else share * row[1]
            total = part if total is None else total + part
        is_vector = isinstance(rows[0][1], Vector)
        pairs.append(Pair(Vector({x: Integer(1)}) if is_vector else x, total))
    kept = pairs[: len(pairs) - move.power]  # `power` unknowns are only eliminated
    conditions = divided_by(determinant, move.where)
    return Performed(tuple(kept), scope, conditions)


def _reduced(expression: Expr) -> Expr:
    flat, nodes = flattened(expression)
    return reduce_trig(flat).xreplace(nodes)


def _roots(pair: Pair, unknown: Any, scope: Scope) -> Performed:
    """Both roots of a quadratic, told apart by a sign."""
    difference = components_of(pair)
    if isinstance(difference, dict):
        raise RefusedError("a vector equation that is not linear")
    flat, nodes = flattened(difference)
    back = {node: dummy for dummy, node in nodes.items()}
    x = back.get(unknown, unknown)
    polynomial = sympy.Poly(sympy.expand(flat), x) if flat.is_polynomial(x) else None
    if polynomial is None or polynomial.degree() != 2:
        raise RefusedError("this is neither linear nor quadratic in {}", unknown)
    a, b, c = (coefficient.xreplace(nodes) for coefficient in polynomial.all_coeffs())
    discriminant = b**2 - 4 * a * c
    roots = [(-b + sign * sympy.sqrt(discriminant)) / (2 * a) for sign in (-1, 1)]
    conditions = [Condition(discriminant, "≥")]
    conditions += divided_by(a, ())
    pairs = tuple(Pair(unknown, root) for root in roots)
    return Performed(pairs, scope, tuple(conditions), every=True)


def _root(move: Move, algebra: Algebra) -> Performed:
    """The square root of both sides; the sign has to be given."""
    known = _one(move)
    pairs = []
    conditions: list[Condition] = []
    for pair in _all_pairs(known, algebra):
        if isinstance(pair.left, Vector) or _is_operator(pair.left) or not _equal(pair):
            raise RefusedError("the root of what is no scalar")
        left = sympy.sqrt(sympy.factor(pair.left))
        bases = [abs_.args[0] for abs_ in left.atoms(sympy.Abs)]
        for base in bases:
            if not _sign_known(base, move.where):
                raise RefusedError(
                    "the root is ±: say for which sign of {}, such as “for … > 0”", base
                )
        left = left.replace(sympy.Abs, lambda x: x)
        pairs.append(Pair(left, sympy.sqrt(pair.right)))
        conditions.append(Condition(pair.right, "≥"))
    return Performed(tuple(pairs), known.scope, tuple(conditions))


def _sign_known(base: Expr, conditions: Sequence[Condition]) -> bool:
    return decide.positive(*_flat_with(base, [c for c in conditions if c.relation == ">"]))


def _sign(move: Move, algebra: Algebra) -> Performed:
    """The sign of a right side, under the conditions that are given, each of which is needed."""
    known = _one(move)
    if known.order is not None:
        raise RefusedError("{} is approximate: its sign is not known", _name(known))
    pairs = []
    for pair in _all_pairs(known, algebra):
        if isinstance(pair.right, (Vector, MatrixBase)) or not _equal(pair):
            continue
        relation = _sign_of(pair.right, move.where)
        if relation is None:
            continue
        for k, condition in enumerate(move.where):
            if _sign_of(pair.right, (*move.where[:k], *move.where[k + 1 :])) == relation:
                raise RefusedError("{} is a condition without need", condition.expression)
        pairs.append(Pair(pair.left, Integer(0), relation))
    if not pairs:
        raise RefusedError("the sign is not known: say under which conditions")
    return Performed(tuple(pairs), known.scope)


def _sign_of(value: Expr, conditions: Sequence[Condition]) -> str | None:
    flat, relations = _flat_with(value, conditions)
    for sign, relation in ((1, ">"), (-1, "<")):
        if decide.positive(sign * flat, relations):
            return relation
    return "≠" if decide.nonzero(flat, relations) else None


def _square(move: Move, algebra: Algebra) -> Performed:
    def squared(value: Value) -> Value:
        return algebra.dot(value, value) if isinstance(value, Vector) else value**2

    known = _one(move)
    order = known.order
    if order is not None:  # (a + O)² has the error a O
        sides = [v for p in _all_pairs(known, algebra) for v in (p.left, p.right)]
        lowest = min((order.lowest(x) for side in sides for x in scalars(side)), default=0)
        order = replace(order, power=order.power + min(0, lowest))
    return replace(_map(move, algebra, squared), order=order)


def scalars(value: Value) -> Sequence[Expr]:
    """The factors of a vector, the entries of a matrix, or a scalar itself."""
    if isinstance(value, Vector):
        return tuple(value.terms.values())
    return tuple(value) if isinstance(value, MatrixBase) else (value,)


NEGLECTED = Symbol("neglected")
"""What stands for all that an approximate equation leaves out, if no letter is small in it."""

SMALL = Symbol("small")
"""What letters that are small together are counted by."""


def _expand(move: Move, algebra: Algebra) -> Performed:
    """To an order in a small letter, or in several that are small together."""
    known = _one(move)
    together = move.by if len(move.by) > 1 else ()
    order = Order(SMALL if together else move.by[0], move.power + 1, together)
    algebra = Algebra(algebra.letters, put_in(move.using, algebra.letters))
    if known.order is not None and replace(known.order, power=order.power) != order:
        raise RefusedError("two small quantities at once: expand in one after the other")
    if known.order is not None and known.order.power <= move.power:
        raise RefusedError(
            "{} holds to O({}^{}) only: its terms of order {} are not known",
            _name(known),
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
        for x in flat.free_symbols:
            if algebra.letters.defined.get(x, frozenset()) & {*move.by}:
                raise RefusedError(
                    "{} is defined by {}: put its definition in first", x, move.by[0]
                )
        made = sympy.series(counted, order.small, 0, order.power).removeO()
        return (made.subs(SMALL, 1) if together else made).xreplace(nodes)

    pairs = [
        Pair(pair.left, series(pair.right), "≈")
        for pair in _all_pairs(known, algebra)
        if pair.relation in ("=", "≈")
    ]
    return Performed(tuple(pairs), known.scope, order=order)


def _neglect(move: Move, algebra: Algebra) -> Performed:
    """Leave terms out: the line says ≈."""
    known = _one(move)
    left_out = [algebra.value(x) for x in move.by]
    pairs = []
    for pair in _all_pairs(known, algebra):
        for k, side in enumerate((pair.left, pair.right)):
            rest = side
            for term in left_out:
                if not _contains(rest, term):
                    break
                rest = algebra.total([rest, algebra.times(Integer(-1), term)])
            else:
                if all(vanishes(part) for part in components(rest, Integer(0))):
                    raise RefusedError("nothing is left of a side: what is larger has to stay")
                sides = (rest, pair.right) if k == 0 else (pair.left, rest)
                pairs.append(Pair(*sides, "≈"))
    if not pairs:
        raise RefusedError("what is neglected does not stand there")
    return Performed(tuple(pairs), known.scope, order=Order(NEGLECTED, 1))


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


def _set(move: Move, algebra: Algebra) -> Performed:
    """Values for letters, at a moment; `power` 1: at all times, so that their rates vanish too.

    `power` 2: at the start, in what is constant and keeps what it was.
    """
    known = _one(move)
    given = _values(move, algebra)
    letters = algebra.letters
    if TIME in given and move.power:
        raise RefusedError("t is set at a moment only")
    for atom in letters.unit_vectors & {*given}:
        if not vanishes(algebra.dot(given[atom], given[atom]) - 1):
            raise RefusedError("{} is a unit vector", atom)
    at_start = move.power == 2
    always = move.power == 1 or all(
        x in letters.numbers and value.free_symbols <= letters.numbers for x, value in given.items()
    )
    if always:
        for atom in list(given):
            if (
                isinstance(given[atom], (Vector, MatrixBase))
                or given[atom].free_symbols - letters.numbers
            ):
                raise RefusedError("only to a number can a letter be set at all times")
            while atom in letters.rates:
                atom = letters.rates[atom]
                given[atom] = Integer(0)
    else:
        _not_under_a_rate(given, known, algebra)
    put = Algebra(algebra.letters, given)
    pairs = [
        replace(pair, left=put.value(pair.left), right=put.value(pair.right))
        for pair in _all_pairs(known, algebra)
    ]
    if at_start:
        _constant(pairs, known, move, letters)
        premises = tuple(Condition(p.left - p.right, "=") for p in pairs)
        return Performed(tuple(pairs), Scope.MOTION, premises)
    scope = known.scope if always and not move.power else Scope.MOTION if always else Scope.SET
    conditions = tuple(
        Condition(algebra.value(e.sides[0]) - algebra.value(e.sides[1]), "=")
        for e in move.by
        if not isinstance(algebra.value(e.sides[0]), Vector)
    )
    return Performed(tuple(pairs), scope, conditions, known.order, given)


def _constant(pairs: Sequence[Pair], known: Known, move: Move, letters: Letters) -> None:
    """Refuse what changes after the start, as far as what is cited besides says."""
    if known.scope is Scope.SET or known.order is not None:
        raise RefusedError("{} does not hold at all times", _name(known))
    bare, later = Algebra(letters), Algebra(letters, put_in(move.using, letters))
    for pair in pairs:
        rates = (later.value(bare.rate(side)) for side in (pair.left, pair.right))
        if not _equal(pair) or not agree(*rates):
            raise RefusedError("this changes after the start: cite what keeps it")
        if isinstance(pair.left, (Vector, MatrixBase)) or isinstance(pair.right, Vector):
            raise RefusedError("at the start scalars are set")


def _values(move: Move, algebra: Algebra) -> dict[Any, Value]:
    given: dict[Any, Value] = {}
    for equation in move.by:
        atom = _atom(algebra.value(equation.sides[0]), equation.sides[0])
        given[atom] = algebra.value(equation.sides[1])
    return given


def _not_under_a_rate(given: Mapping[Any, Value], known: Known, algebra: Algebra) -> None:
    for pair in _all_pairs(known, algebra):
        for side in (pair.left, pair.right):
            for node in atoms_of(side):
                if isinstance(node, Rate) and node not in given:
                    inner = {x for part in node.args for x in _nodes(part)}
                    if inner & set(given):
                        raise RefusedError(
                            "{} stands there: what is set at a moment says nothing of a derivative",
                            node,
                        )


_VERBS: Mapping[str, Callable[[Move, Algebra], Performed]] = {
    "put": _put,
    "differentiate": _differentiate,
    "rate": _rate,
    "integrate": _integrate,
    "component": _component,
    "dot": _dot,
    "cross": _cross,
    "add": _sum(1),
    "subtract": _sum(-1),
    "multiply": _multiply,
    "divide": _divide,
    "rewrite": _rewrite,
    "transpose": _of_operators(lambda algebra: algebra.transposed),
    "determinant": _of_operators(lambda algebra: algebra.determinant),
    "exchange": _exchange,
    "turn factors": _exchange_factors,
    "strip": _strip,
    "solve": _solve,
    "root": _root,
    "sign": _sign,
    "sum": _sum_over,
    "square": _square,
    "expand": _expand,
    "neglect": _neglect,
    "set": _set,
}


__all__ = [
    "Applied",
    "Condition",
    "Known",
    "Move",
    "Order",
    "Pair",
    "Performed",
    "RefusedError",
    "Scope",
    "components",
    "pairs_of",
    "perform",
]
