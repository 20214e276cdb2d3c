"""What nodes of a formula are as expressions of SymPy, in the letters of a notation."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import reduce
from itertools import pairwise
from typing import Any

import sympy
from sympy import Add, Integer, MatrixBase, Mul, Pow, Rational, Symbol

from rigidtop.notation import Notation, is_matrix
from rigidtop.proof import equation as eq
from rigidtop.read.kinds import UnknownError, kind
from rigidtop.theory import symbols as s
from rigidtop.theory.symbols import VOCABULARY, Glyph
from rigidtop.tree import nodes as n
from rigidtop.tree.plain import plain

LARGEST = 6
"""A matrix that is written out has no more rows or columns."""


@dataclass(frozen=True)
class Expressions:
    """What nodes are as expressions, in the letters of one notation."""

    notation: Notation
    matrices: bool = False
    """Whether A is a matrix, as it is beside others, and no amplitude."""

    def of(self, node: n.Node) -> Any:
        """The expression of a node.  Raises UnknownError for one that has no place there."""
        handler = _HANDLERS.get(type(node))
        if handler is None:
            raise UnknownError(f"{plain(node)}: that is not read here")
        return handler(self, node)

    def symbol(self, node: n.Letter, accent: str = "", primes: int = 0) -> Symbol | None:
        """The symbol of a letter, perhaps with a dot or a prime above it; None if there is none."""
        mark = node.mark.rstrip("′")
        primes += len(node.mark) - len(mark)
        if primes > 1 or (mark and accent):
            return None
        sub = node.sub.replace("-", "−").replace(" ", "")
        glyph = Glyph(node.base, sub, accent or mark, node.bold, bool(primes))
        symbol = self.notation.symbol(glyph)
        if symbol is None and node.base in _VARIANTS:
            return self.symbol(replace(node, base=_VARIANTS[node.base]), accent, primes)
        if symbol is None and mark == "hat":  # a unit vector with a hat that it does not need
            bare = self.notation.symbol(replace(glyph, accent="", bold=True))
            symbol = bare if bare in VOCABULARY and VOCABULARY[bare].unit == "" else None
        return symbol

    def known(self, node: n.Letter, primes: int = 0) -> Symbol:
        """The same, but raises UnknownError where there is none."""
        symbol = self.symbol(node, primes=primes)
        if symbol is None:
            raise UnknownError(f"no symbol {plain(node)}{'′' * primes} in this notation")
        return symbol


_VARIANTS = {"ϑ": "θ", "ϕ": "φ", "ϵ": "ε", "ϱ": "ρ", "ϖ": "π", "ς": "σ"}
"""Other shapes of Greek letters: in a table each letter has one."""


def _letter(meaning: Expressions, node: n.Letter) -> Any:
    if node == n.Letter("π"):
        return sympy.pi
    symbol = meaning.known(node)
    return s.A_matrix if symbol == s.A and meaning.matrices else symbol


def _primed(meaning: Expressions, node: n.Primed) -> Any:
    if not isinstance(node.of, n.Letter):
        raise UnknownError(f"{plain(node)}: a prime belongs to a letter")
    return meaning.known(node.of, node.order)


_DOTS = {1: "dot", 2: "ddot"}


def _rate(meaning: Expressions, node: n.TimeDerivative) -> Any:
    of = node.of
    if node.frame:
        if node.frame not in _FRAMES:
            raise UnknownError(f"a rate as seen from {node.frame!r}: space or body")
        return eq.Rate(meaning.of(of), _FRAMES[node.frame])
    letter, primes = (of.of, of.order) if isinstance(of, n.Primed) else (of, 0)
    for order in range(node.order, 0, -1):
        dotted = isinstance(letter, n.Letter) and order in _DOTS
        symbol = meaning.symbol(letter, _DOTS[order], primes) if dotted else None  # type: ignore[arg-type]
        if symbol is not None:
            return _rates(symbol, node.order - order)
    return _rates(meaning.of(of), node.order)


def _rates(of: Any, count: int) -> Any:
    for _ in range(count):
        of = eq.Rate(of)
    return of


_FRAMES = {"space": eq.SPACE, "body": eq.BODY}


def _group(meaning: Expressions, node: n.Bracketed) -> Any:
    if isinstance(node.of, n.Number) and "." in node.of.text and node.of.value > 1:
        raise UnknownError(
            "a number in brackets: as the equation's own, put it behind a comma or in \\tag{}; "
            "as a factor, without brackets"
        )
    inside = meaning.of(node.of)
    return inside if isinstance(inside, MatrixBase) else eq.Group(inside)


def _sum(meaning: Expressions, node: n.Sum) -> Any:
    terms = [(x.of, -1) if isinstance(x, n.Negative) else (x, 1) for x in node.terms]
    values = [(meaning.of(x), sign) for x, sign in terms]
    if any(kind(x) == "matrix" for x, _ in values):
        values = [(s.unit if x == 1 else x, sign) for x, sign in values]
    kinds = dict.fromkeys(kind(x) for x, _ in values if x != 0)
    if len(kinds) > 1:
        raise UnknownError(f"a {' and a '.join(kinds)} are added: is a symbol meant in bold?")
    signed = (x if sign > 0 else _times(Integer(-1), x) for x, sign in values)
    return reduce(lambda total, term: Add(total, term, evaluate=False), signed)


def _product(meaning: Expressions, node: n.Product) -> Any:
    for factor in node.factors[1:]:
        if isinstance(factor, n.Number):
            raise UnknownError(f"the number {factor.text} behind a factor")
    return reduce(_times, map(meaning.of, node.factors))


def _times(left: Any, right: Any) -> Any:
    written_out = (MatrixBase, eq.Matrices)
    if isinstance(left, written_out) and isinstance(right, written_out):
        factors = (x.args if isinstance(x, eq.Matrices) else (x,) for x in (left, right))
        return eq.Matrices(*(factor for each in factors for factor in each))
    if kind(left) == kind(right) == "vector":
        raise UnknownError("two vectors beside each other: · or × between them?")
    if isinstance(left, MatrixBase):
        return left.applyfunc(lambda entry: entry and _times(entry, right))
    if isinstance(right, MatrixBase):
        return right.applyfunc(lambda entry: entry and _times(left, entry))
    return Mul(left, right, evaluate=False)


def _quotient(meaning: Expressions, node: n.Quotient) -> Any:
    over, under = meaning.of(node.over), meaning.of(node.under)
    if kind(under) != "scalar":
        raise UnknownError(f"a division by a {kind(under)}")
    if n.ungrouped(node.under) == n.Number("0"):
        raise UnknownError("a division by 0")
    if isinstance(over, Rational) and isinstance(under, Rational):
        return Rational(over, under)
    return _times(over, Pow(under, Integer(-1), evaluate=False))


def _power(meaning: Expressions, node: n.Power) -> Any:
    if isinstance(node.base, n.Letter) and node.exponent == n.Number("2"):
        square = meaning.symbol(replace(node.base, base=f"{node.base.base}²"))
        if square is not None and meaning.symbol(node.base) is None:
            return square  # σ² alone has a name, and may be negative
    if node.base == n.Letter("e") and meaning.symbol(node.base) is None:
        return _apply(meaning, n.Apply("exp", node.exponent))
    base, exponent = meaning.of(node.base), meaning.of(node.exponent)
    if kind(base) == "vector" and exponent == 2:
        return eq.Dot(base, base)
    if kind(base) != "scalar":
        raise UnknownError(f"a power of a {kind(base)}: write the product, or ᵀ")
    if kind(exponent) != "scalar":
        raise UnknownError(f"a {kind(exponent)} as an exponent")
    if base == 0 and (exponent == 0 or isinstance(exponent, Mul)):
        raise UnknownError("a power of 0 that has no value")
    return Pow(base, exponent, evaluate=False)


def _root(meaning: Expressions, node: n.Root) -> Any:
    of = meaning.of(node.of)
    if kind(of) != "scalar":
        raise UnknownError(f"the root of a {kind(of)}")
    return Pow(of, Rational(1, node.degree), evaluate=False)


def _apply(meaning: Expressions, node: n.Apply) -> Any:
    inside = meaning.of(n.ungrouped(node.of))
    if node.name in _OF_MATRICES:
        letter = meaning.notation.glyphs.get(inside)
        name = Glyph(f"{node.name} {letter.base}") if letter is not None else Glyph("")
        if name not in meaning.notation.names:
            raise UnknownError(f"{plain(node)} has no name in this notation")
        return meaning.notation.names[name]
    if node.name not in _FUNCTIONS:
        raise UnknownError(f"the function {node.name} is not known")
    if kind(inside) != "scalar":
        raise UnknownError(f"{node.name} of a {kind(inside)}")
    if inside == 0 and node.name in ("ln", "log"):
        raise UnknownError("the logarithm of 0")
    return _FUNCTIONS[node.name](inside, evaluate=False)


_OF_MATRICES = ("det", "tr")


def is_of_matrices(node: n.Node, meaning: Expressions) -> bool:
    """Whether something stands in it that only matrices have, or a letter that is always one."""
    for x in n.walked(node):
        if isinstance(x, (n.Matrix, n.TransposedMatrix)):
            return True
        if isinstance(x, n.Apply) and x.name in _OF_MATRICES:
            return True
        symbol = meaning.symbol(x) if isinstance(x, n.Letter) else None
        if symbol is not None and is_matrix(symbol):
            return True
        if isinstance(x, n.Product) and any(_acts(meaning, *two) for two in pairwise(x.factors)):
            return True
    return False


def _acts(meaning: Expressions, left: n.Node, right: n.Node) -> bool:
    """Whether A stands before a vector."""
    named = isinstance(left, n.Letter) and meaning.symbol(left) == s.A
    bare = right.of if isinstance(right, n.TimeDerivative) else right
    return named and isinstance(bare, n.Letter) and bare.bold


def _call(meaning: Expressions, node: n.Call) -> Any:
    """A letter of a table is itself at its time or place; K and F are elliptic integrals."""
    function = node.function
    places = tuple(meaning.of(n.ungrouped(x)) for x in node.places)
    if isinstance(function, n.Letter) and function.base in _ELLIPTIC and not function.sub:
        elliptic = _ELLIPTIC[function.base]
        if len(places) not in elliptic.nargs or any(kind(x) != "scalar" for x in places):
            raise UnknownError(f"{plain(node)}: K is of a parameter, F of an angle and a parameter")
        return elliptic(*places, evaluate=False)
    if places not in ((s.t,), (s.r_vec,)):
        raise UnknownError(f"{plain(node)}: the value at one place")
    return meaning.of(function)


_ELLIPTIC = {"K": sympy.elliptic_k, "F": sympy.elliptic_f}


def _derivative(meaning: Expressions, node: n.Derivative) -> Any:
    by, *more = (meaning.of(x) for x in node.by)
    of = _differentiated(meaning, node.of)
    if not node.partial and kind(by) == "scalar" and {*more} <= {by}:
        return reduce(eq.Slope, (by, *more), of)
    if more or not node.partial:
        raise UnknownError("a derivative is by one letter, a partial one once and of a scalar")
    if not isinstance(by, Symbol) or kind(of) != "scalar" or kind(by) != "scalar":
        raise UnknownError("a derivative is by the time, or a partial one of a scalar by a letter")
    return eq.Partial(of, by)


def _differentiated(meaning: Expressions, of: n.Node) -> Any:
    """What is differentiated: ∂L is of the Lagrangian where L is nothing else."""
    if of == n.Letter("L") and meaning.symbol(of) is None:
        return s.Lagrangian
    return meaning.of(of)


def _total(meaning: Expressions, node: n.Total) -> Any:
    if node.sign != "Σ" or node.lower is not None or len(node.index) > 1:
        raise UnknownError("a sum is over an index, as in \\sum_k")
    return eq.SumOver(Symbol("".join(x.base for x in node.index)), meaning.of(node.of))


def _integral(meaning: Expressions, node: n.Integral) -> Any:
    body, by = meaning.of(node.of), node.by
    if node.lower is None and node.upper is None and meaning.of(by) == s.r_vec:
        return eq.VolumeIntegral(Symbol("d3r"), body)
    if node.lower is None or node.upper is None or kind(meaning.of(by)) != "scalar":
        raise UnknownError("an integral is \\int d^3\\mathbf r, or \\int_a^b dx")
    return eq.IntegralOver(meaning.of(by), meaning.of(node.lower), meaning.of(node.upper), body)


def _braced(meaning: Expressions, node: n.Braced) -> Any:
    if node.label is None:
        raise UnknownError(f"words beneath a brace: {node.words!r}")
    body, label = meaning.of(node.of), meaning.of(node.label)
    if kind(body) != kind(label):
        raise UnknownError(f"a {kind(label)} beneath a {kind(body)}: is a symbol meant in bold?")
    return eq.Underbrace(body, label)


def _matrix(meaning: Expressions, rows: Sequence[Sequence[n.Node]]) -> Any:
    if len({len(row) for row in rows}) > 1:
        raise UnknownError("a matrix with rows of different lengths")
    if len(rows) > LARGEST or len(rows[0]) > LARGEST:
        raise UnknownError(f"a matrix of more than {LARGEST} rows or columns")
    entries = [[meaning.of(x) for x in row] for row in rows]
    other = next((kind(x) for row in entries for x in row if kind(x) != "scalar"), "")
    if other:
        raise UnknownError(f"a {other} as an entry")
    return sympy.ImmutableMatrix(entries)


def _transposed(meaning: Expressions, node: n.TransposedMatrix) -> Any:
    of = meaning.of(node.of)
    if isinstance(of, MatrixBase):
        return of.T
    if kind(of) == "scalar":
        raise UnknownError("a scalar is transposed")
    return eq.Transposed(of)


def _absolute(meaning: Expressions, node: n.Absolute) -> Any:
    of = meaning.of(node.of)
    if kind(of) == "matrix":
        raise UnknownError("bars round a matrix: write det")
    if kind(of) == "vector":
        return Pow(eq.Dot(of, of), Rational(1, 2), evaluate=False)
    return sympy.Abs(of, evaluate=False)


def _dot(meaning: Expressions, node: n.DotProduct) -> Any:
    left, right = meaning.of(node.left), meaning.of(node.right)
    if kind(left) == kind(right) == "vector":
        return eq.Dot(left, right)
    if kind(left) == "scalar" and (kind(right) == "scalar" or isinstance(right, eq.Group)):
        return _times(left, right)
    raise UnknownError(f"· between a {kind(left)} and a {kind(right)}")


def _cross(meaning: Expressions, node: n.CrossProduct) -> Any:
    left, right = meaning.of(node.left), meaning.of(node.right)
    if kind(left) == kind(right) == "vector":
        return eq.Cross(left, right)
    if left.is_number and kind(right) == "scalar":
        return _times(left, right)
    raise UnknownError(f"× between a {kind(left)} and a {kind(right)}")


_FUNCTIONS: dict[str, Any] = {
    **{x: getattr(sympy, x) for x in ("sin", "cos", "tan", "exp", "sinh", "cosh", "tanh")},
    **{x: getattr(sympy, x) for x in ("cot", "sec", "csc", "coth")},
    **{f"arc{x}": getattr(sympy, f"a{x}") for x in ("sin", "cos", "tan")},
    "ln": sympy.log,
    "log": sympy.log,
}


_HANDLERS: dict[type, Callable[[Expressions, Any], Any]] = {
    n.Letter: _letter,
    n.Primed: _primed,
    n.TimeDerivative: _rate,
    n.Number: lambda m, x: Rational(x.value.numerator, x.value.denominator),
    n.Sum: _sum,
    n.Product: _product,
    n.Quotient: _quotient,
    n.Negative: lambda m, x: _times(Integer(-1), m.of(x.of)),
    n.Bracketed: _group,
    n.Power: _power,
    n.Root: _root,
    n.Apply: _apply,
    n.Call: _call,
    n.Derivative: _derivative,
    n.Total: _total,
    n.Integral: _integral,
    n.Braced: _braced,
    n.Matrix: lambda m, x: _matrix(m, x.rows),
    n.Tuple: lambda m, x: _matrix(m, [x.entries]),
    n.Absolute: _absolute,
    n.CrossProduct: _cross,
    n.DotProduct: _dot,
    n.TransposedMatrix: _transposed,
    n.Constant: lambda m, x: s.const,
}
