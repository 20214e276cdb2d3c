"""Values of printed trees: scalars, vectors, operators; whether two are the same."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import sympy
from sympy import Add, Basic, Dummy, Expr, Integer, MatrixBase, Mul, Pow, Symbol
from sympy.integrals.manualintegrate import manualintegrate

from rigidtop.proof import decide
from rigidtop.proof.confirmation import heard
from rigidtop.proof.equation import Dot, NoMeaningError, Printed, Transposed

Value = Any
"""A scalar, a `Vector`, an operator (an expression of letters that do not commute) or a matrix."""


@dataclass(frozen=True, eq=False)
class Vector:
    """A sum of atoms, each with its scalar: ``Vector({e1: omega1, e2: omega2})``."""

    terms: Mapping[Expr, Expr]

    def __add__(self, other: Vector) -> Vector:
        total = dict(self.terms)
        for atom, factor in other.terms.items():
            total[atom] = total.get(atom, Integer(0)) + factor
        return Vector(total)

    def times(self, factor: Expr) -> Vector:
        return Vector({atom: factor * old for atom, old in self.terms.items()})


ZERO = Vector({})


class Applied(Printed):
    """``Applied(I, ω)``: what an operator makes of an atom."""


class Entry(Printed):
    """``Entry(O, i, j)``: the entry of an operator that is compared with a matrix written out."""


TIME = Symbol("t", real=True)


def antiderivative(integrand: Expr, x: Symbol) -> Expr | None:
    """A function whose derivative is a smooth integrand; None where none is known.

    Polynomials in x, sin x and cos x, and Legendre's integral F(x, m) of the first kind (DLMF
    19.2.4), whose derivative is 1/√(1 − m sin²x): others may have poles between two ends.
    """
    if is_smooth(integrand, (x,)):
        made = manualintegrate(sympy.expand(integrand), x)
        sound = is_smooth(made, (x,)) and vanishes(made.diff(x) - integrand)
        return made if sound else None
    first = integrand.subs(x, 0)
    if first.is_zero or (not first.is_finite and first.is_number):
        return None
    square = (first / integrand) ** 2
    m = sympy.factor(1 - square.subs(x, sympy.pi / 2))
    if not vanishes(square - (1 - m * sympy.sin(x) ** 2)):
        return None
    return first * sympy.elliptic_f(x, m)


def is_smooth(node: Expr, of: Sequence[Symbol]) -> bool:
    """Whether an expression is a polynomial in letters, their sines and cosines."""
    if not node.has(*of) or isinstance(node, Symbol):
        return True
    if isinstance(node, Pow) and not (node.exp.is_Integer and node.exp > 0):
        return False
    if not isinstance(node, (Add, Mul, Pow, sympy.sin, sympy.cos)):
        return False
    return all(is_smooth(part, of) for part in node.args)


ELLIPTIC = (sympy.elliptic_k, sympy.elliptic_f)
"""Functions that stand for themselves: of the same numbers they are the same."""


def flattened(expression: Expr) -> tuple[Expr, dict[Symbol, Expr]]:
    """An expression with a dummy for every atom that is no letter, and what each stands for."""
    atoms: dict[Symbol, Expr] = {}

    def go(node: Expr) -> Expr:
        if isinstance(node, Printed):
            found = _stand_in(node)
            atoms[found] = node
            return found
        if not node.args or not node.has(Printed):
            return node
        return node.func(*(go(part) for part in node.args))

    return go(expression), atoms


@lru_cache(maxsize=20_000)
def _stand_in(node: Printed) -> Dummy:
    """The letter for an atom, the same each time: what is found out of it need not be again."""
    squared = isinstance(node, Dot) and node.args[0] == node.args[1]
    return Dummy(nonnegative=True) if squared else Dummy(real=True)


def difference(left: Value, right: Value) -> dict[Expr | int, Expr]:
    """What vanishes where two values agree: by the atoms of vectors, the places of matrices."""
    if isinstance(left, Vector) or isinstance(right, Vector):
        for side in (left, right):
            if not isinstance(side, Vector) and not is_zero(side):
                raise NoMeaningError("a vector is compared with a scalar")
        first, second = (side if isinstance(side, Vector) else ZERO for side in (left, right))
        return dict((first + second.times(Integer(-1))).terms)
    if isinstance(left, MatrixBase) or isinstance(right, MatrixBase):
        shape = (left if isinstance(left, MatrixBase) else right).shape
        sides = [x if isinstance(x, MatrixBase) else _entries(x, *shape) for x in (left, right)]
        if sides[0].shape != sides[1].shape:
            raise NoMeaningError("matrices of different sizes are compared")
        return dict(enumerate(sides[0] - sides[1]))
    return {0: sympy.expand(left - right) if has_operators(left, right) else left - right}


def components(left: Value, right: Value) -> list[Expr]:
    """The scalars that vanish where two values agree."""
    return list(difference(left, right).values())


def _entries(operator: Expr, rows: int, columns: int) -> MatrixBase:
    """A number times the unit matrix, or an operator, entry by entry; 0 is of every size."""
    if is_zero(operator):
        return sympy.zeros(rows, columns)
    if rows != columns:
        raise NoMeaningError("matrices of different sizes are compared")
    if has_operators(operator):
        made = sympy.expand(operator)
        return sympy.Matrix(rows, columns, lambda i, j: Entry(made, Integer(i), Integer(j)))
    return operator * sympy.eye(rows)


def has_operators(*sides: Expr) -> bool:
    return any(not sympy.sympify(side).is_commutative for side in sides)


def agree(left: Value, right: Value) -> bool:
    """Whether two values are the same, by normal form."""
    return all(vanishes(part) for part in components(left, right))


@heard
def vanishes(expression: Expr) -> bool:
    """Whether a scalar with atoms in it, or an operator, is zero."""
    if expression == 0:
        return True
    if not expression.is_commutative:
        return bool(sympy.expand(expression) == 0)
    return _is_null(flattened(expression)[0])


@lru_cache(maxsize=20_000)
def _is_null(flat: Expr) -> bool:
    """Whether a scalar without atoms in it is zero."""
    flat = flat.xreplace({node: Dummy(real=True) for node in flat.atoms(*ELLIPTIC)})
    found = decide.in_digits([("=", flat)])
    if found is False:
        return False
    # What is real at no point is not worth a long search.
    again = (change(flat) for change in (_rooted, _in_whole_angles) if found is True)
    return decide.vanishes(flat) or any(map(decide.vanishes, again))


def _in_whole_angles(expression: Expr) -> Expr:
    """With a letter for the smallest part of each angle, so that all angles are multiples of it."""
    turning = expression.atoms(sympy.sin, sympy.cos)
    angles = {f: sympy.expand(f.args[0]).as_coefficients_dict() for f in turning}
    parts: dict[Expr, int] = {}
    for angle in angles.values():
        for part, count in angle.items():
            parts[part] = sympy.ilcm(parts.get(part, 1), sympy.Rational(count).q)
    if set(parts.values()) <= {1}:
        return expression
    least = {part: Dummy(real=True) * number for part, number in parts.items() if part != 1}
    whole = {
        f: f.func(Add(*(count * least.get(part, part) for part, count in angle.items())))
        for f, angle in angles.items()
    }
    return expression.xreplace(whole)


def _rooted(expression: Expr) -> Expr:
    """√(x²y) as |x|√y where signs are known: a last attempt, on what is zero in digits."""
    return sympy.radsimp(sympy.powdenest(sympy.together(sympy.expand(expression)), force=False))


def tree(value: Value) -> Expr | MatrixBase:
    """A value as an expression that can be printed: a vector as a sum, what acts as a factor."""
    if isinstance(value, Vector):
        return Add(*(Mul(factor, tree(atom)) for atom, factor in value.terms.items()))
    if isinstance(value, MatrixBase):
        return value.applyfunc(tree)
    return sympy.sympify(value).replace(_is_applied_or_turned, _as_written)


def _is_applied_or_turned(node: Basic) -> bool:
    return isinstance(node, Applied) or (isinstance(node, Symbol) and node.name.endswith("ᵀ"))


def _as_written(node: Basic) -> Basic:
    if isinstance(node, Symbol):
        return Transposed(Symbol(node.name.removesuffix("ᵀ")))
    return Mul(*node.args, evaluate=False)


def is_zero(value: Value) -> bool:
    return (isinstance(value, Vector) and not value.terms) or (
        not isinstance(value, (Vector, MatrixBase)) and value == 0
    )


def without_zeros(value: Value) -> Value:
    if not isinstance(value, Vector):
        return value
    return Vector({atom: factor for atom, factor in value.terms.items() if factor != 0})


def atoms_of(value: Value) -> Iterator[Expr]:
    """The atoms of a value: letters, products of vectors, rates, slopes."""
    if isinstance(value, Vector):
        for atom, factor in value.terms.items():
            yield atom
            yield from atoms_of(factor)
    elif isinstance(value, MatrixBase):
        for entry in value:
            yield from atoms_of(entry)
    else:
        yield from value.free_symbols
        yield from value.atoms(Printed)
