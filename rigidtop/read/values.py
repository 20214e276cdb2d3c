"""Parts of expressions, with what is known of them, and how they are put together."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import sympy
from sympy import Add, Expr, Integer, MatrixBase, Mul, Pow, Rational, Symbol

from rigidtop.notation import MATRICES
from rigidtop.notation.convention import own
from rigidtop.proof import equation as eq
from rigidtop.read.cursor import Token
from rigidtop.read.signs import ANGLES
from rigidtop.read.tex import UnreadError
from rigidtop.theory import symbols as s
from rigidtop.theory.lettered import Lettered, known
from rigidtop.theory.symbols import Glyph

DEEPEST = 100
"""No expression is a deeper tree; a sum of n terms is one of n levels."""

DIGITS = 400
"""No number has more, were its powers computed."""

RAISED = 20
"""A power of what is no number is not higher, powers of powers multiplied."""

LARGEST = 6
"""A matrix that is written out has no more rows or columns."""

OMITTED = own(Glyph("…"))
"""Dots for what is left out: a number or a vector, as need be."""


_CARRIES: Mapping[Any, int] = {
    **dict.fromkeys((eq.Group, eq.Underbrace, eq.Rate, eq.Transposed, Pow), 0),
    **dict.fromkeys((eq.At, eq.Slope, eq.Partial, eq.Evaluated, eq.Integrated), 0),
    **dict.fromkeys((eq.SumOver, eq.VolumeIntegral), 1),
    **dict.fromkeys((eq.IntegralOver, eq.SumFrom), 3),
    eq.Matrices: -1,
}
"""Which of its parts a node has its kind from."""


def kind(node: Expr) -> str:
    """ "scalar", "vector" or "matrix"."""
    if isinstance(node, sympy.MatrixBase):
        return "vector" if 1 in node.shape else "matrix"
    if isinstance(node, Symbol):
        _, quantity = known(node)
        bold = quantity is not None and quantity.glyph.bold
        return "matrix" if node in MATRICES else "vector" if bold else "scalar"
    if type(node) in _CARRIES:
        return kind(node.args[_CARRIES[type(node)]])
    if isinstance(node, (Add, Mul)):
        kinds = [kind(argument) for argument in node.args]
        return next((k for k in ("vector", "matrix") if k in kinds), "scalar")
    return "vector" if isinstance(node, eq.Cross) else "scalar"


@dataclass(frozen=True)
class Value:
    """A part of an expression, with what is known of it.

    `depth` is that of its tree, `digits` how many digits its numbers may come to, `raised` the
    product of the powers within.  `pending` is a function of the rate `tree`, which makes sense
    only if the time follows; `ends` is the reason why nothing may follow; `bare` says that a
    function has its argument without brackets.
    """

    tree: Any
    kind: str
    position: int
    depth: int = 1
    digits: float = 0
    raised: float = 1
    pending: Callable[[Any], Any] | None = None
    ends: str = ""
    literal: bool = False
    bare: bool = False
    alone: bool = False
    """That it stands for all of its term, if brackets do not say for how much."""

    @property
    def closed(self) -> Value:
        if self.pending is None:
            return self
        return replace(self, tree=self.pending(self.tree), pending=None, depth=self.depth + 1)

    @property
    def explicit(self) -> bool:
        """Whether it is a matrix or column with its entries."""
        return isinstance(self.tree, sympy.MatrixBase)


def built(tree: Expr, kind: str, *parts: Value, **known: Any) -> Value:
    """A value of parts; a depth beyond the limit is unread at the last part."""
    depth = 1 + max(part.depth for part in parts)
    if depth > DEEPEST:
        raise UnreadError(
            f"an expression of more than {DEEPEST} levels: fewer terms or brackets",
            parts[-1].position,
        )
    known.setdefault("digits", sum(part.digits for part in parts))
    known.setdefault("raised", max(part.raised for part in parts))
    if known["digits"] > DIGITS:
        raise UnreadError("a number too large", parts[-1].position)
    position = known.pop("position", parts[0].position)
    return Value(tree, kind, position, depth, **known)


def acting(of: Value, derivative: Callable[[Value], Value]) -> Value:
    """A derivative of what stands behind it, which ends with it unless it stands in brackets."""
    group = isinstance(of.tree, eq.Group)
    made = derivative(replace(of.closed, tree=of.tree.args[0]) if group else of.closed)
    ends = "" if group else "the derivative could go on here: put brackets"
    if of.pending is None:
        return replace(made, ends=ends)

    def pending(inside: Expr) -> Expr:
        return derivative(replace(of, tree=inside).closed).tree

    return replace(made, tree=of.tree, pending=pending, ends=ends, bare=True)


def goes_on(total: Expr, term: Expr) -> bool:
    """Whether the index of a sum at the end of a total stands in the term behind it too.

    In what a letter is a function of, L(q_k), and beneath a sum it may.
    """
    last = total.args[-1] if isinstance(total, Add) else total
    last = next((x for x in (last, *last.args) if isinstance(x, (eq.SumOver, eq.SumFrom))), None)
    if last is None:
        return False
    index = last.args[0].name.partition("=")[0][:1]
    ahead = [term]
    while index.isalpha() and ahead:
        node = ahead.pop()
        if isinstance(node, Lettered):
            glyph = node.quantity.glyph
            if index in (glyph.base, *glyph.sub.split(",")):
                return True
        if not isinstance(node, (eq.At, eq.SumOver, eq.SumFrom)):
            ahead += list(node.args)
    return False


def is_open(node: Expr) -> bool:
    """Whether nothing is known of a letter but how it is written."""
    return isinstance(node, Lettered) and not node.quantity.unit


def is_angle(node: Lettered) -> bool:
    """Whether mechanics writes angles with that letter."""
    glyph = node.quantity.glyph
    return glyph.base[0] in ANGLES and not glyph.accent


def definite(factors: Sequence[Value]) -> None:
    """Refuse a function without brackets of which nobody can tell where its argument ends.

    sin ωt and sin θ φ̇ are clear, sin kx and cos α t are not.
    """
    for factor, after in pairwise(factors):
        if not factor.bare or after.bare or after.kind == "vector":
            continue
        last = after.tree
        if not (isinstance(last, (Symbol, eq.Group, eq.At)) or last.is_number):
            continue
        time = isinstance(last, Lettered) and last.quantity.glyph == Glyph("t")
        within = [x.quantity.glyph.base for x in factor.tree.free_symbols if is_open(x)]
        place = isinstance(last, Lettered) and last.quantity.glyph.base in ("x", "y", "z")
        wave = place and not last.quantity.glyph.accent and bool(within)
        wave = wave and set(within) <= {"α", "β", "γ", "χ"}  # sin α x is rather sin(αx)
        if is_differential(last) or ((factor.pending is None) != time and not wave):
            continue
        raise UnreadError(
            "of how much the function is: put brackets round all that it is of", after.position
        )


def may_be_tensor(node: Expr) -> bool:
    """Whether a bold letter may be a matrix: a capital, or what is made of one."""
    if isinstance(node, Pow):
        return may_be_tensor(node.base)
    if isinstance(node, (eq.Transposed, eq.Group)):
        return may_be_tensor(node.args[0])
    if not isinstance(node, Lettered):
        return isinstance(node, (Add, Mul))
    base = node.quantity.glyph.base
    return base[0].isupper() or base[0] in "∇01" or len(base) > 1


def is_numeric(tree: Any) -> bool:
    """Whether a product begins with a number, such as 10³ m: × before it is that of numbers."""
    first = tree.args[0] if isinstance(tree, Mul) else tree
    return (isinstance(first, Mul) and is_numeric(first)) or bool(first.is_number)


def nodes(tree: Expr) -> Iterator[Expr]:
    """The parts of a tree, those of matrices too."""
    ahead = [tree]
    while ahead:
        node = ahead.pop()
        yield node
        ahead += list(node) if isinstance(node, sympy.MatrixBase) else list(node.args)


def is_differential(node: Expr) -> bool:
    """Whether it is a letter such as dx, d³r."""
    if not isinstance(node, Lettered):
        return False
    return bool(re.fullmatch("d[²³]?\\w[\u0300-\u036f′]*", node.quantity.glyph.base))


def without(tree: Expr, factor: Expr) -> Expr | None:
    """A product without one of its factors; None if it is no factor of it."""
    if tree == factor:
        return Integer(1)
    if not isinstance(tree, (Mul, eq.Cross, eq.Dot)):
        return None
    for i, part in enumerate(tree.args):
        rest = without(part, factor)
        if rest is None or (rest == 1 and not isinstance(tree, Mul)):
            continue
        kept = [*tree.args[:i], *([] if rest == 1 else [rest]), *tree.args[i + 1 :]]
        whole = {"evaluate": False} if isinstance(tree, Mul) else {}
        return tree.func(*kept, **whole) if len(kept) > 1 else kept[0]
    return None


def number(token: Token) -> Value:
    """Digits, with a decimal point or without, as the fraction that they are."""
    whole, _, decimals = token.value.partition(".")
    tree = Rational(int(whole + decimals or "0"), 10 ** len(decimals))
    return Value(tree, "scalar", token.position, digits=len(whole + decimals), literal=True)


def last_of(tree: Expr) -> Expr:
    """The symbol in Ω or 2Ω."""
    return tree.args[-1] if isinstance(tree, Mul) else tree


def unit_of(symbol: Symbol) -> str:
    _, quantity = known(symbol)
    return quantity.unit if quantity is not None else ""


def as_matrix(value: Value) -> Value:
    """1 beside matrices is the unit matrix."""
    return replace(value, tree=s.unit, kind="matrix") if value.tree == 1 else value


def negative(value: Value) -> Value:
    return replace(times(Value(Integer(-1), "scalar", value.position), value), literal=False)


def times(left: Value, right: Value) -> Value:
    kinds = (left.kind, right.kind)
    both = next((k for k in ("vector", "matrix") if k in kinds), "scalar")
    written_out = left.explicit or right.explicit or isinstance(left.tree, eq.Matrices)
    if written_out and "scalar" not in kinds:
        return matrix_product(left, right)
    return built(product(left.tree, right.tree), both, left, right)


def product(left: Expr, right: Expr) -> Expr:
    """As it is typed, entry by entry where one is a matrix that is written out."""
    if isinstance(left, sympy.MatrixBase):
        return left.applyfunc(lambda entry: entry and product(entry, right))
    if isinstance(right, sympy.MatrixBase):
        return right.applyfunc(lambda entry: entry and product(left, entry))
    return Mul(left, right, evaluate=False)


def matrix_product(left: Value, right: Value) -> Value:
    """The product of matrices that are written out."""
    factors = [*written_out(left), *written_out(right)]
    if len(factors) < 2 or not all(isinstance(factor, sympy.MatrixBase) for factor in factors):
        raise UnreadError("a product with a matrix that is written out", right.position)
    if factors[-2].shape[1] != factors[-1].shape[0]:
        raise UnreadError("matrices of different sizes are multiplied", right.position)
    tree = eq.Matrices(*(factor.as_immutable() for factor in factors))
    depth = left.depth + right.depth
    digits = LARGEST * (left.digits + right.digits + 1)
    return built(tree, kind(factors[-1]), replace(left, depth=depth), right, digits=digits)


def written_out(part: Value) -> tuple[Expr | MatrixBase, ...]:
    return part.tree.args if isinstance(part.tree, eq.Matrices) else (part.tree,)


def power(base: Value, exponent: Value) -> Value:
    if exponent.kind != "scalar":
        raise UnreadError(f"a {exponent.kind} as an exponent", exponent.position)
    if base.kind == "matrix" or base.explicit:
        raise UnreadError("a power of a matrix: write the product, or ᵀ", exponent.position)
    if base.kind == "vector":
        if exponent.tree == -1 and is_open(base.tree) and may_be_tensor(base.tree):
            return built(Pow(base.tree, Integer(-1), evaluate=False), "vector", base)
        if exponent.tree != 2:
            raise UnreadError("a power of a vector other than its square", exponent.position)
        return built(eq.Dot(base.tree, base.tree), "scalar", base)
    if base.tree == 0 and (exponent.tree == 0 or isinstance(exponent.tree, Mul)):
        raise UnreadError("a power of 0 that has no value", exponent.position)
    size = _size(exponent)
    named = bool(base.tree.free_symbols)
    if any(is_open(x) for x in exponent.tree.free_symbols):
        size = min(size, 1)  # nothing is put in for it
    raised = base.raised * max(size, 1) if named else base.raised
    if raised > RAISED or size > 10**4:
        raise UnreadError("a power too high", exponent.position)
    return built(
        Pow(base.tree, exponent.tree, evaluate=False),
        "scalar",
        base,
        exponent,
        digits=base.digits * max(size, 1) + exponent.digits,
        raised=raised,
    )


def _size(exponent: Value) -> float:
    """How large an exponent may be at most, as far as its numbers go."""
    tree = exponent.tree
    if isinstance(tree, Mul) and len(tree.args) == 2 and tree.args[0] == -1:
        tree = tree.args[1]
    if tree.is_Rational:
        return float(abs(tree)) if exponent.digits < 20 else 1e20
    return 10.0 ** min(exponent.digits, 20) if exponent.digits else 1


def ratio(over: Value, below: Value) -> Value:
    if below.kind != "scalar":
        raise UnreadError(f"a division by a {below.kind}", below.position)
    inside = below.tree
    while isinstance(inside, eq.Group):
        inside = inside.args[0]
    if inside == 0:
        raise UnreadError("a division by 0", below.position)
    if isinstance(over.tree, Rational) and isinstance(below.tree, Rational):
        return built(Rational(over.tree, below.tree), "scalar", over, below)
    one_over = built(Pow(below.tree, Integer(-1), evaluate=False), "scalar", below)
    return built(product(over.tree, one_over.tree), over.kind, over, one_over)
