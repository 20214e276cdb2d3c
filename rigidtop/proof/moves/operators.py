"""What is done with matrices: transposed, their factors in turn, told by what they do."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import sympy
from sympy import Add, Expr, Integer, MatrixBase, Mul

from rigidtop.proof.algebra import Algebra
from rigidtop.proof.equation import Dot
from rigidtop.proof.moves.move import (
    Move,
    Pair,
    Performed,
    RefusedError,
    Scope,
    name_of,
    the_one,
)
from rigidtop.proof.moves.pairs import (
    all_pairs,
    atom_of,
    equal_pairs,
    is_operator,
    mapped,
    single_atom,
)
from rigidtop.proof.values import Applied, Value, Vector


def of_operators(
    change: Callable[[Algebra], Callable[[Value], Value]],
) -> Callable[[Move, Algebra], Performed]:
    """The same done with both sides, of which one at least is a matrix."""

    def changed(move: Move, algebra: Algebra) -> Performed:
        pairs = all_pairs(the_one(move), algebra)
        if not all(is_operator(p.left) or is_operator(p.right) for p in pairs):
            raise RefusedError("{} says nothing of matrices", name_of(the_one(move)))
        return mapped(move, algebra, change(algebra))

    return changed


def exchange_factors(move: Move, algebra: Algebra) -> Performed:
    """Where a product of square matrices is 1, it is with its factors in turn: XY = 1, YX = 1."""
    known = the_one(move)
    pairs: list[Pair] = []
    for pair in equal_pairs(known, algebra):
        if pair.right != 1 or not is_operator(pair.left):
            raise RefusedError("only where a product is 1 can its factors be exchanged")
        scalars, factors = pair.left.args_cnc()
        for k in range(1, len(factors)):
            turned = Mul(*scalars, *factors[k:], *factors[:k])
            pairs.append(Pair(turned, Integer(1)))
    return Performed(tuple(pairs), known.scope)


def strip(move: Move, algebra: Algebra) -> Performed:
    """What does the same to all vectors is the same: of Au = Bu for every axis u, A = B.

    u·Av = … for all pairs of axes gives the entries of A; `by` may also be letters for any vector.
    """
    axes = [atom_of(algebra.value(x), x) for x in move.by]
    pairs = [p for known in move.of for p in equal_pairs(known, algebra)]
    scope = max(known.scope for known in move.of)
    letters = algebra.letters
    if any(set(axes) == set(frame) for frame in letters.frames) and len(axes) == 3:
        made = _on_axes(pairs, axes, algebra)
    elif set(axes) <= letters.arbitrary and len(set(axes)) == len(axes) <= 2:
        limits = {
            x for known in move.of for c in known.conditions for x in c.expression.free_symbols
        }
        if scope is Scope.SET or limits & {*axes}:
            raise RefusedError("{} does not hold for any vector", name_of(move.of[0]))
        made = _on_any(pairs, axes, algebra)
    else:
        raise RefusedError("three axes of a frame, or letters for any vector, can be stripped")
    if not made:
        raise RefusedError("the two sides are not known for all of them")
    return Performed(tuple(made), scope)


def _on_axes(pairs: Sequence[Pair], axes: Sequence[Expr], algebra: Algebra) -> list[Pair]:
    images: dict[Expr, list[tuple[Expr, Vector]]] = {u: [] for u in axes}
    entries: dict[Expr, dict[tuple[int, int], Expr]] = {}
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
    return [pair for pair in made if is_operator(pair.left)]


def _acting(value: Value, u: Expr) -> Expr | None:
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
    axes: Sequence[Expr],
    entries: dict[Expr, dict[tuple[int, int], Expr]],
    algebra: Algebra,
) -> None:
    """Of u·Av = c the entry of A, and that of its transpose."""
    found = single_atom(left)
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


def _on_any(pairs: Sequence[Pair], axes: Sequence[Expr], algebra: Algebra) -> list[Pair]:
    made = []
    for pair in pairs:
        left, right = (
            _acting(side, axes[0]) if len(axes) == 1 else _between(side, axes[0], axes[1], algebra)
            for side in pair.sides
        )
        if left is None or right is None or (left.free_symbols | right.free_symbols) & {*axes}:
            continue
        made.append(Pair(left, right))
    return made


def _between(value: Value, u: Expr, v: Expr, algebra: Algebra) -> Expr | None:
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
