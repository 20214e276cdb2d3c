"""Expressions and printed equations from the symbols of one notation into those of another.

A symbol may become another with a minus sign, as e₁′ does where the line of nodes is e₁′, or
another with an offset of quarter turns, as φ does.  Sines and cosines take offsets in, cos(φ − π/2)
is sin φ, and a minus sign that comes up is drawn out of its product and its brackets, so that the
result reads as a book would print it.  What was typed stays in the order of typing.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from itertools import repeat
from typing import Any

import sympy
from sympy import Add, Basic, Derivative, Eq, Expr, Mul, Ne, Pow, Symbol, cos, pi, sin, tan

from rigidtop.proof.equation import (
    Cross,
    Dot,
    Equation,
    Group,
    IntegralOver,
    Matrices,
    Partial,
    Printed,
    Rate,
    SumOver,
    Transposed,
    Underbrace,
    VolumeIntegral,
    as_printed,
)


@dataclass(frozen=True)
class Image:
    """What becomes of a symbol: ± another one, plus quarter turns."""

    symbol: Symbol
    negative: bool = False
    quarters: int = 0

    @property
    def expression(self) -> Expr:
        signed = -self.symbol if self.negative else self.symbol
        return signed + self.quarters * pi / 2


Images = Mapping[Symbol, Image]


def inverse(images: Images) -> dict[Symbol, Image]:
    """The images that lead back.  An offset has no minus sign."""
    return {
        image.symbol: Image(symbol, image.negative, -image.quarters)
        for symbol, image in images.items()
    }


def translated(tree: Expr, images: Images) -> Any:
    """An expression, a matrix, a condition or an `Equation` with every symbol replaced.

    >>> from rigidtop.theory.symbols import phi, psi, theta
    >>> x = Symbol("x", real=True)
    >>> translated(sin(theta) * cos(phi), {phi: Image(x, quarters=-1)})
    sin(theta)*sin(x)
    """
    if isinstance(tree, Equation):
        sides = [translated(side, images) for side in tree.sides]
        positive = [_without_minuses(side) for side in sides]
        moved = tree.relation not in "<>" and any(map(_concerns, tree.sides, repeat(images)))
        if moved and all(x is not None for x in positive):
            sides = positive
        return Equation(*sides, relation=tree.relation, tag=tree.tag)
    if not isinstance(tree, (Basic, sympy.MatrixBase)) or not _concerns(tree, images):
        return tree
    if isinstance(tree, sympy.MatrixBase):
        return type(tree)(*tree.shape, [translated(entry, images) for entry in tree])
    typed = is_typed(tree)
    context: AbstractContextManager[None] = as_printed() if typed else nullcontext()
    with context:
        return _made(*_signed(tree, images))


def _concerns(tree: Expr, images: Images) -> bool:
    return any(symbol in images for symbol in tree.atoms(Symbol))


def is_typed(tree: Expr) -> bool:
    """Whether SymPy would put a tree together otherwise."""
    if isinstance(tree, sympy.MatrixBase):
        return any(map(is_typed, tree))
    if not isinstance(tree, Basic) or not tree.args:
        return False
    if isinstance(tree, Printed) or any(map(is_typed, tree.args)):
        return True
    if not isinstance(tree, (Add, Mul, Pow)):
        return False
    rebuilt = tree.func(*tree.args)
    return rebuilt.func is not tree.func or rebuilt.args != tree.args


# --- Trees with a sign before them ---------------------------------------------------------------

LINEAR = {Group: 0, Transposed: 0, Rate: 0, SumOver: 1, VolumeIntegral: 1, IntegralOver: 3}
"""The argument of which a minus sign is drawn out."""

Signed = tuple[bool, Any]
"""Whether a minus sign that came up stands before a tree, and the tree."""


def _signed(tree: Expr, images: Images) -> Signed:
    if isinstance(tree, Symbol):
        image = images.get(tree)
        if image is None:
            return False, tree
        if image.quarters:
            return False, image.expression
        return image.negative, image.symbol
    if not isinstance(tree, Basic) or not tree.args or not _concerns(tree, images):
        return False, tree
    if isinstance(tree, (sin, cos, tan)):
        return _trigonometric(tree, images)
    if isinstance(tree, Pow):
        return _power(tree, images)
    if isinstance(tree, Derivative):
        return _derivative(tree, images)
    if isinstance(tree, Partial) and all(x.is_Symbol for x in tree.args[1:]):
        negative, by = _variables([(x, 1) for x in tree.args[1:]], images)
        minus, body = _signed(tree.args[0], images)
        return negative ^ minus, tree.func(body, *(x for x, _ in by))
    if isinstance(tree, Underbrace):
        return _brace(tree, images)
    if isinstance(tree, (Mul, Cross, Dot)):
        return _product(tree, [_signed(argument, images) for argument in tree.args])
    if isinstance(tree, Add):
        return False, _sum([_signed(argument, images) for argument in tree.args])
    if isinstance(tree, Matrices):
        return False, Matrices(*(translated(matrix, images) for matrix in tree.args))
    if isinstance(tree, (Eq, Ne)) and tree.rhs == 0:  # what vanishes does so with either sign
        return False, tree.func(_signed(tree.lhs, images)[1], tree.rhs)
    parts = [_signed(argument, images) for argument in tree.args]
    negative = False
    for kind, k in LINEAR.items():
        if isinstance(tree, kind):
            negative, parts[k] = parts[k][0], (False, parts[k][1])
    return negative, tree.func(*(_made(*part) for part in parts))


def _made(negative: bool, tree: Expr) -> Expr:
    """The tree, or −tree where a minus sign came up."""
    return _negated(tree) if negative else tree


def _negated(tree: Expr) -> Expr:
    """−tree with two minus signs made none, also where one stands in brackets."""
    positive = _without_minus(tree)
    return positive if positive is not None else Mul(-1, tree)


def _without_minus(tree: Expr) -> Expr | None:
    """What a minus sign stands before, if one does."""
    if tree.is_Number:
        return -tree if tree < 0 else None
    if isinstance(tree, Group):
        body = _without_minus(tree.args[0])
        return None if body is None else Group(body)
    if not isinstance(tree, Mul):
        return None
    if tree.args[0] == -1:
        return Mul(*tree.args[1:]) if len(tree.args) > 2 else tree.args[1]
    for i, factor in enumerate(tree.args):
        body = _without_minus(factor)
        if body is not None:
            return Mul(*tree.args[:i], body, *tree.args[i + 1 :])
    return None


def _without_minuses(side: Expr) -> Expr | None:
    """A side of an equation without the minus sign before each of its terms."""
    terms = side.args if isinstance(side, Add) else (side,)
    positive = [_without_minus(term) if isinstance(term, Expr) else None for term in terms]
    if None in positive:
        return None
    with as_printed() if is_typed(side) else nullcontext():
        return Add(*positive) if len(positive) > 1 else positive[0]


def _product(tree: Expr, parts: list[Signed]) -> Signed:
    negative = sum(minus for minus, _ in parts) % 2 == 1
    product = tree.func(*(part for _, part in parts))
    if negative:
        positive = _without_minus(product)
        if positive is not None:
            return False, positive
    return negative, product


def _sum(parts: list[Signed]) -> Expr:
    """Terms in their order, but none to which a minus sign came first, where it need not be."""
    if parts[0][0]:
        parts.sort(key=lambda part: part[0])
    return Add(*(_made(*part) for part in parts))


def _brace(tree: Underbrace, images: Images) -> Signed:
    """What a brace names, with the minus sign of the name before both."""
    body, label = (_signed(part, images) for part in tree.args)
    if label[0]:
        return True, Underbrace(_made(not body[0], body[1]), label[1])
    return False, Underbrace(_made(*body), label[1])


def _power(tree: Pow, images: Images) -> Signed:
    base, exponent = tree.args
    negative, image = _signed(base, images)
    exponent = _made(*_signed(exponent, images))
    if negative and exponent.is_Integer:
        return exponent.is_odd, Pow(image, exponent)
    return False, Pow(_made(negative, image), exponent)


def _derivative(tree: Derivative, images: Images) -> Signed:
    negative, body = _signed(tree.expr, images)
    minus, variables = _variables(tree.variable_count, images)
    return negative ^ minus, Derivative(body, *variables)


def _variables(
    variables: Iterable[tuple[Symbol, int]], images: Images
) -> tuple[bool, list[tuple[Symbol, int]]]:
    """What is differentiated by, and the sign that comes up: an offset changes no derivative."""
    negative, pairs = False, []
    for variable, count in variables:
        image = images.get(variable, Image(variable))
        negative ^= image.negative and bool(count % 2)
        pairs.append((image.symbol, count))
    return negative, pairs


def _trigonometric(tree: Expr, images: Images) -> Signed:
    """sin, cos or tan with whole quarter turns taken out of the argument."""
    argument = tree.args[0]
    offset = _offset(argument, images)
    if offset is None or not offset.is_Integer:
        return False, tree.func(_made(*_signed(argument, images)))
    bare = {x: Image(i.symbol, i.negative) for x, i in images.items()}
    negative, inside = _signed(argument, bare)
    minus, function = _turned(tree.func, int(offset))
    if negative and function is not cos:
        minus = not minus
    image = function(inside)
    if function is tan and offset.is_odd:
        image = Pow(image, -1)
    return minus, image


def _offset(argument: Expr, images: Images) -> Expr | None:
    """How many quarter turns the offsets add to an argument; None where it is not linear."""
    with sympy.evaluate(True):
        total = sympy.Integer(0)
        for symbol in _shifted(argument, images):
            rate = argument.doit().diff(symbol)
            if rate.free_symbols:
                return None
            total += rate * images[symbol].quarters
        return total


def _shifted(argument: Expr, images: Images) -> Iterator[Symbol]:
    return (x for x in argument.free_symbols if x in images and images[x].quarters)


def _turned(function: Any, quarters: int) -> tuple[bool, Expr]:
    """f(x + quarters · π/2) as ± g(x); of the tangent after an odd number, as −1/tan x."""
    if function is tan:
        return bool(quarters % 2), tan
    order = (sin, cos)
    place = order.index(function) + quarters
    # sin, cos, −sin, −cos
    return place % 4 >= 2, order[place % 2]
