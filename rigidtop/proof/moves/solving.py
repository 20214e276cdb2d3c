"""Solve for a letter or a vector, or for several: linear, or the roots of a quadratic."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import sympy
from sympy import Add, Dummy, Expr, Integer, Mul, Pow, Symbol

from rigidtop.proof.algebra import Algebra
from rigidtop.proof.equation import Equation
from rigidtop.proof.moves.conditions import divided_by, never_positive
from rigidtop.proof.moves.move import (
    Condition,
    Known,
    Move,
    Pair,
    Performed,
    RefusedError,
    Scope,
)
from rigidtop.proof.moves.pairs import atom_of, entries, equal_pairs, is_operator, single_atom
from rigidtop.proof.values import Vector, difference, flattened
from rigidtop.theory.symbols import const
from rigidtop.theory.trig import reduce_trig


def solve(move: Move, algebra: Algebra) -> Performed:
    """For one letter or vector, or more: linear, or the roots of a quadratic.

    What is asked for may be a power or a product, which is one thing then.
    """
    whole = {x: Dummy() for x in map(algebra.value, move.by) if isinstance(x, (Pow, Mul))}
    whole = {x: name for x, name in whole.items() if single_atom(x) is None}
    if whole:
        return _solved_whole(move, algebra, whole)
    unknowns = [atom_of(algebra.value(x), x) for x in move.by]
    if len(move.of) > len(unknowns):
        raise RefusedError("more equations than unknowns")
    pairs = [
        Pair(*sides)
        for known in move.of
        for pair in equal_pairs(_without_const(known), algebra)
        for sides in entries(*pair.sides)
    ]
    if any(is_operator(side) for p in pairs for side in p.sides):
        raise RefusedError("a matrix equation is not solved so: multiply by what takes it away")
    scope = max(k.scope for k in move.of)
    atoms = {x: Dummy() for x in unknowns}
    rows = [_linear(pair, atoms) for pair in pairs]
    if all(row is not None for row in rows):
        return _solved_linear(move, [r for row in rows if row for r in row], atoms, scope)
    if len(unknowns) == 1 and len(pairs) == 1:
        return _roots(pairs[0], unknowns[0], move, scope)
    raise RefusedError("this is not linear in {}", *move.by)


def eliminate(move: Move, algebra: Algebra) -> Performed:
    """Of as many linear equations as letters, with no rest: their determinant vanishes.

    Only where not all of the letters are 0.
    """
    unknowns = [atom_of(algebra.value(x), x) for x in move.by]
    atoms = {x: Dummy() for x in unknowns}
    parts = [
        Pair(*sides)
        for known in move.of
        for pair in equal_pairs(known, algebra)
        for sides in entries(*pair.sides)
    ]
    if any(is_operator(side) for pair in parts for side in pair.sides):
        raise RefusedError("letters are eliminated from equations of numbers, or of columns")
    rows = [row for pair in parts for row in _linear(pair, atoms) or ()]
    if len(rows) != len(unknowns) or any(rest != 0 for _, rest in rows):
        raise RefusedError("as many equations as letters are needed, linear and with no rest")
    determinant = _reduced(sympy.Matrix([[row[x] for x in unknowns] for row, _ in rows]).det())
    size = Add(*(x**2 for x in unknowns))
    scope = max(known.scope for known in move.of)
    return Performed((Pair(determinant, Integer(0)),), scope, divided_by(size, move.where))


def _solved_whole(move: Move, algebra: Algebra, whole: Mapping[Expr, Symbol]) -> Performed:
    """The same with a letter for each power or product that is asked for."""
    back = {name: x for x, name in whole.items()}

    def named(side: Expr) -> Expr:
        flat, nodes = flattened(algebra.value(side))
        inner = {node: x for x, node in nodes.items()}
        return (
            sympy.expand(flat)
            .subs({x.xreplace(inner): y for x, y in whole.items()})
            .xreplace(nodes)
        )

    def lettered(known: Known) -> Known:
        made = (Equation(*map(named, e.sides), relation=e.relation) for e in known.equations)
        return replace(known, equations=tuple(made))

    by = tuple(whole.get(algebra.value(x), x) for x in move.by)
    made = solve(replace(move, of=tuple(map(lettered, move.of)), by=by), algebra)
    pairs = (Pair(*(x.xreplace(back) for x in pair.sides)) for pair in made.pairs)
    conditions = (replace(c, expression=c.expression.xreplace(back)) for c in made.conditions)
    return replace(made, pairs=tuple(pairs), conditions=tuple(conditions))


def _without_const(known: Known) -> Known:
    """Of a chain that ends in a constant, such as ℓ = mr²θ̇ = const, what it says besides."""
    equations = []
    for equation in known.equations:
        sides = [side for side in equation.sides if side != const]
        if 1 < len(sides) < len(equation.sides):
            equation = Equation(*sides, relation=equation.relation, tag=equation.tag)
        equations.append(equation)
    return replace(known, equations=tuple(equations))


def _linear(pair: Pair, atoms: Mapping[Expr, Symbol]) -> list[tuple[dict[Expr, Expr], Any]] | None:
    """(coefficients of the unknowns, the rest), where they enter linearly; vectors are one row."""
    if isinstance(pair.left, Vector) or isinstance(pair.right, Vector):
        gap = difference(pair.left, pair.right)
        coefficients = {x: gap.get(x, Integer(0)) for x in atoms}
        return [(coefficients, Vector({a: f for a, f in gap.items() if a not in atoms}))]
    flat, nodes = flattened(pair.left - pair.right)
    back = {node: dummy for dummy, node in nodes.items()}
    unknowns = [back.get(x, x) for x in atoms]
    expanded = sympy.expand(_cleared(flat, unknowns))
    coefficients = {}
    rest = expanded
    for x, unknown in zip(atoms, unknowns, strict=True):
        coefficient = expanded.diff(unknown) if isinstance(unknown, Symbol) else Integer(0)
        if coefficient.free_symbols & {u for u in unknowns if isinstance(u, Symbol)}:
            return None
        coefficients[x] = coefficient.xreplace(nodes)
        rest = rest.subs(unknown, 0) if isinstance(unknown, Symbol) else rest
    return [(coefficients, rest.xreplace(nodes))]


def _cleared(expression: Expr, unknowns: Sequence[Expr]) -> Expr:
    """Without divisors that have an unknown in them: the equation says that they do not vanish."""
    if expression.is_rational_function(*unknowns) and not expression.is_polynomial(*unknowns):
        return sympy.fraction(sympy.cancel(sympy.together(expression)))[0]
    return expression


def _solved_linear(
    move: Move, rows: list[tuple[dict[Expr, Expr], Any]], atoms: Mapping[Expr, Symbol], scope: Scope
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
        total: Expr | None = None
        for j, row in enumerate(rows):
            share = -inverse[i, j] / determinant
            part = row[1].times(share) if isinstance(row[1], Vector) else share * row[1]
            total = part if total is None else total + part
        is_vector = isinstance(rows[0][1], Vector)
        pairs.append(Pair(Vector({x: Integer(1)}) if is_vector else x, total))
    kept = pairs[: len(pairs) - move.power]  # `power` unknowns are only eliminated
    conditions = divided_by(determinant, (*move.where, *move.settings))
    return Performed(tuple(kept), scope, conditions)


def _reduced(expression: Expr) -> Expr:
    flat, nodes = flattened(expression)
    return reduce_trig(flat).xreplace(nodes)


def _roots(pair: Pair, unknown: Expr, move: Move, scope: Scope) -> Performed:
    """Both roots of a quadratic: that with − before the square root, then that with +.

    No condition makes them change places: Ω₋ is the slow one below the horizontal too.
    """
    if isinstance(pair.left, Vector) or isinstance(pair.right, Vector):
        raise RefusedError("a vector equation that is not linear")
    signs = {
        c.expression: Dummy(positive=True)
        for c in move.where
        if c.relation == ">" and isinstance(c.expression, Symbol) and c.expression != unknown
    }
    flat, nodes = flattened(pair.left - pair.right)
    back = {node: dummy for dummy, node in nodes.items()}
    x = back.get(unknown, unknown)
    flat = _cleared(flat, [x])
    polynomial = sympy.Poly(sympy.expand(flat), x) if flat.is_polynomial(x) else None
    if polynomial is None or polynomial.degree() != 2:
        raise RefusedError("this is neither linear nor quadratic in {}", unknown)
    a, b, c = (coefficient.xreplace(nodes) for coefficient in polynomial.all_coeffs())
    if a.could_extract_minus_sign():  # the first of the roots is the same whatever is divided by
        a, b, c = -a, -b, -c
    discriminant = sympy.expand(b**2 - 4 * a * c)
    named = {sign: letter for letter, sign in signs.items()}
    root = sympy.sqrt(discriminant.xreplace(signs)).xreplace(named)
    roots = [(-b + sign * root) / (2 * a) for sign in (-1, 1)]
    conditions = [Condition(discriminant, "≥")]
    conditions += divided_by(a, (*move.where, *move.settings))
    allowed = [each for each in roots if not _against(each, unknown, move.where)]
    allowed = allowed[:1] if discriminant == 0 else allowed
    pairs = tuple(Pair(unknown, each) for each in allowed)
    return Performed(pairs, scope, tuple(conditions), every=len(pairs) == 2)


def _against(root: Expr, unknown: Expr, conditions: Sequence[Condition]) -> bool:
    """Whether a root is known not to fulfil one of the conditions on what is asked for."""
    for condition in conditions:
        if condition.relation == ">" and condition.expression.has(unknown):
            others = [c for c in conditions if c is not condition]
            if never_positive(condition.expression.xreplace({unknown: root}), others):
                return True
    return False
