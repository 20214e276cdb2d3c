"""Scalars, vectors and matrices: which of them an expression of a page is.

>>> from rigidtop.theory import symbols as s
>>> kind(s.omega_vec), kind(s.theta)
('vector', 'scalar')
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any

from sympy import Add, MatrixBase, Mul, Pow, Symbol

from rigidtop.notation import is_matrix
from rigidtop.proof import equation as eq
from rigidtop.theory import symbols as s
from rigidtop.theory.lettered import known


class UnknownError(Exception):
    """A node that has no place in an equation of a page, and why."""


_CARRIES: Mapping[Any, int] = {
    **dict.fromkeys(
        (eq.Group, eq.Underbrace, eq.Rate, eq.Slope, eq.Transposed, eq.Partial, Pow), 0
    ),
    **dict.fromkeys((eq.SumOver, eq.VolumeIntegral), 1),
    eq.IntegralOver: 3,
    eq.Matrices: -1,
}
"""Which of its parts a node has its kind from."""


def kind(node: Any) -> str:
    """Whether an expression is a "scalar", a "vector" or a "matrix"."""
    if isinstance(node, MatrixBase):
        return "vector" if 1 in node.shape else "matrix"
    if isinstance(node, Symbol):
        _, quantity = known(node)
        bold = quantity is not None and quantity.glyph.bold
        return "matrix" if is_matrix(node) else "vector" if bold else "scalar"
    if type(node) in _CARRIES:
        return kind(node.args[_CARRIES[type(node)]])
    if isinstance(node, (Add, Mul)):
        kinds = [kind(argument) for argument in node.args]
        return next((k for k in ("vector", "matrix") if k in kinds), "scalar")
    return "vector" if isinstance(node, eq.Cross) else "scalar"


def of_one_kind(sides: Sequence[Any]) -> list[Any]:
    """Sides of one kind; 1 beside matrices is the unit matrix."""
    if any(kind(side) == "matrix" for side in sides):
        sides = [s.unit if side == 1 else side for side in sides]
    for before, side in pairwise(sides):
        free = (0, s.const)
        if kind(before) != kind(side) and before not in free and side not in free:
            raise UnknownError(
                f"a {kind(before)} and a {kind(side)} are compared: is a symbol meant in bold?"
            )
    return list(sides)
