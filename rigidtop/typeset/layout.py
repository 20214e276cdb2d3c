"""From a SymPy tree to a tree of layout: every decision about order, signs, fractions, brackets.

The renderers (`latex`, `mathml`, `text`) only spell out what stands here, so that the same
equation reads the same in all of them.  A tree that was *typed* (inside
`rigidtop.proof.equation.as_printed`) keeps the order of typing.  An *evaluated* tree, whose order
SymPy chose, is put into the order of mechanics: in a product numbers, parameters, momenta, rates,
functions of angles; in a sum what has more rates first, so that kinetic stands before potential.

>>> from rigidtop.theory.symbols import lambda1, phidot, theta
>>> layout(lambda1 * phidot / 2)
Product(factors=(Fraction(over=Number(text='1'), under=Number(text='2'), small=True), \
Letter(glyph=Glyph(base='λ', sub='1', accent='', bold=False, prime=False)), \
Letter(glyph=Glyph(base='φ', sub='', accent='dot', bold=False, prime=False))), joints=('', ''))
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cmp_to_key, singledispatch
from itertools import pairwise
from typing import Any, Literal

import sympy
from sympy import Add, Basic, Expr, Mul, Pow, Symbol
from sympy.core.relational import Relational

from rigidtop.notation.characters import GREEK
from rigidtop.proof.equation import (
    At,
    Cross,
    Dot,
    Equation,
    Evaluated,
    Group,
    IntegralOver,
    Integrated,
    Matrices,
    Partial,
    Printed,
    Rate,
    Slope,
    SumFrom,
    SumOver,
    Transposed,
    Underbrace,
    VolumeIntegral,
)
from rigidtop.theory.lettered import BY_NAME, Lettered, known, stands_for
from rigidtop.theory.symbols import Glyph

Order = Literal["typed", "printed", "mechanics", "auto"]
"""``typed``: as typed.  ``printed``: as typed, but for a side that is certainly SymPy's own, as in
an equation of the notes that takes one side from the engine.  ``mechanics``: the order of
mechanics.  ``auto``: that too, but for a side that is certainly typed."""


# --- The nodes -----------------------------------------------------------------------------------


@dataclass(frozen=True)
class Number:
    """Digits without a sign."""

    text: str


@dataclass(frozen=True)
class Letter:
    """A symbol."""

    glyph: Glyph


@dataclass(frozen=True)
class Signed:
    """A term of a sum."""

    negative: bool
    body: Node


@dataclass(frozen=True)
class Sum:
    """Signed terms; a single negative term is a negation."""

    terms: tuple[Signed, ...]


@dataclass(frozen=True)
class Continued(Sum):
    """The rest of a sum on a new line: its first sign is always shown."""


@dataclass(frozen=True)
class Product:
    """Factors side by side.  ``joints[i]`` stands between factor i and i + 1.

    A joint is "" (nothing), "thin" (a thin space), "function" (the space beside the name of a
    function, which TeX puts there by itself) or "dot" (a visible ·, before a number).
    """

    factors: tuple[Node, ...]
    joints: tuple[str, ...]


@dataclass(frozen=True)
class Fraction:
    """A fraction; `small` when both parts are numbers."""

    over: Node
    under: Node
    small: bool = False


@dataclass(frozen=True)
class Power:
    """``base`` raised to ``exponent``; brackets round the base are already there."""

    base: Node
    exponent: Node


@dataclass(frozen=True)
class Root:
    """A square root, or with an `index` another root."""

    body: Node
    index: str = ""


@dataclass(frozen=True)
class Apply:
    """A function with its arguments.  Without `brackets` the single argument stands bare.

    `name` is a word that is set upright ("sin"), or a `Letter` ("ρ(r)").
    """

    name: str | Letter
    arguments: tuple[Node, ...]
    brackets: bool
    power: Node | None = None


@dataclass(frozen=True)
class Brackets:
    """Brackets of one shape: "()", "[]" or "||"."""

    body: Node
    shape: str = "()"


@dataclass(frozen=True)
class Braced:
    """A body with a brace beneath it and ≡ label beneath that."""

    body: Node
    label: Node


@dataclass(frozen=True)
class Infix:
    """``left × right`` or ``left · right``."""

    sign: str
    left: Node
    right: Node


@dataclass(frozen=True)
class TransposeOf:
    """Bodyᵀ."""

    body: Node


@dataclass(frozen=True)
class Derivative:
    """A derivative: ∂ or d, of a body by a variable, as seen from a frame ("" for none).

    `inside` says whether the body stands over the fraction bar, or behind the fraction.
    """

    body: Node
    by: Node
    partial: bool
    inside: bool
    frame: str = ""
    order: int = 1


@dataclass(frozen=True)
class Big:
    """``∑`` over an index, or ``∫`` with a measure, before a body; `limits` from where to where."""

    sign: str
    index: Node | None
    body: Node
    limits: tuple[Node, ...] | None = None


@dataclass(frozen=True)
class Measure:
    """The measure d³r of an integral, or dx with bounds."""

    dimension: str
    variable: Node
    bounds: tuple[Node, ...] = ()


@dataclass(frozen=True)
class Grid:
    """A matrix."""

    rows: tuple[tuple[Node, ...], ...]


@dataclass(frozen=True)
class Listed:
    """Nodes with a comma, "and" or "or" between them."""

    items: tuple[Node, ...]
    between: str = ","


@dataclass(frozen=True)
class Chain:
    """Sides with a relation sign between each pair of neighbours."""

    sides: tuple[Node, ...]
    signs: tuple[str, ...]


Node = (
    Number
    | Letter
    | Sum
    | Product
    | Fraction
    | Power
    | Root
    | Apply
    | Brackets
    | Braced
    | Infix
    | TransposeOf
    | Derivative
    | Big
    | Measure
    | Grid
    | Listed
    | Chain
)


# --- Symbols -------------------------------------------------------------------------------------


def glyph(name: str) -> Glyph:
    """The vocabulary's glyph of a symbol, or one read off its name.

    >>> glyph("lambda1"), glyph("c_phi")
    (Glyph(base='λ', sub='1', accent='', bold=False, prime=False), \
Glyph(base='c', sub='φ', accent='', bold=False, prime=False))
    """
    if name in BY_NAME:
        return BY_NAME[name][1].glyph
    if name.endswith("p") and name[:-1] in BY_NAME:
        return replace(glyph(name[:-1]), prime=True)
    for ending, change in (
        ("_vec", {"bold": True}),
        ("ddot", {"accent": "ddot"}),
        ("dot", {"accent": "dot"}),
        ("hat", {"accent": "hat", "bold": True}),
    ):
        if name.endswith(ending) and len(name) > len(ending):
            return replace(glyph(name.removesuffix(ending)), **change)
    stem, _, sub = name.partition("_")
    if not stem:
        return Glyph(name)
    digits = re.fullmatch(r"(.*?[^\d])(\d+)", stem)
    if digits and not sub:
        stem, sub = digits.groups()
    return Glyph(GREEK.get(stem, stem), GREEK.get(sub, sub))


def differential(glyph: Glyph) -> tuple[str, Glyph]:
    """The d, d³, Δ or δ before a letter that is one with it, and the letter; "" for none.

    >>> differential(Glyph("d³r")), differential(Glyph("drag"))
    (('d³', Glyph(base='r', sub='', accent='', bold=False, prime=False)), \
('', Glyph(base='drag', sub='', accent='', bold=False, prime=False)))
    """
    found = re.fullmatch("([dΔδ][²³]?)(\\w[\u0300-\u036f′]*)", glyph.base)
    return (found[1], replace(glyph, base=found[2])) if found else ("", glyph)


# --- Building blocks: brackets and joints -------------------------------------------------------


def negated(node: Node) -> Node:
    """−node, with the sign drawn out of a negation."""
    if isinstance(node, Sum) and len(node.terms) == 1:
        (term,) = node.terms
        return term.body if term.negative else Sum((Signed(True, term.body),))
    return Sum((Signed(True, bracketed(node) if isinstance(node, Sum) else node),))


def bracketed(node: Node) -> Node:
    """The node in round brackets, unless it has brackets of its own."""
    return node if isinstance(node, (Brackets, Grid)) else Brackets(node)


def _as_factor(node: Node, last: bool) -> Node:
    if isinstance(node, Sum):
        return Brackets(node)
    if isinstance(node, (Infix, Big, Chain, Listed)) and not last:
        return Brackets(node)
    if isinstance(node, Derivative) and not node.inside and not last:
        return Brackets(node)
    if isinstance(node, Braced):
        return replace(node, body=_as_factor(node.body, last))
    return node


def _starts_with_digit(node: Node) -> bool:
    if isinstance(node, Number):
        return True
    if isinstance(node, Fraction):
        return node.small
    if isinstance(node, Power):
        return _starts_with_digit(node.base)
    return isinstance(node, Product) and _starts_with_digit(node.factors[0])


def _is_word(node: Node) -> bool:
    return isinstance(node, Letter) and len(node.glyph.base) > 1


def _joint(left: Node, right: Node) -> str:
    if _starts_with_digit(right):
        return "dot"
    if isinstance(right, Apply) and isinstance(right.name, str):
        return "function"
    if isinstance(left, Apply) and not left.brackets:
        return "thin"
    if isinstance(right, Big):
        return "function"
    if isinstance(right, Derivative) or isinstance(left, Derivative):
        return "thin"
    return "thin" if _is_word(left) or _is_word(right) else ""


def product(factors: Iterable[Node]) -> Node:
    """Factors side by side, each in brackets where it needs them."""
    flat: list[Node] = []
    for factor in factors:
        flat.extend(factor.factors if isinstance(factor, Product) else (factor,))
    if not flat:
        return Number("1")
    if len(flat) == 1:
        return flat[0]
    parts = [_as_factor(factor, last=i == len(flat) - 1) for i, factor in enumerate(flat)]
    return Product(tuple(parts), tuple(_joint(a, b) for a, b in pairwise(parts)))


def total(terms: Iterable[Node]) -> Node:
    """A sum; negations become its minus signs."""
    flat: list[Signed] = []
    for term in terms:
        flat.extend(term.terms if isinstance(term, Sum) else (Signed(False, term),))
    if len(flat) == 1 and not flat[0].negative:
        return flat[0].body
    return Sum(tuple(flat))


def _as_operand(node: Node) -> Node:
    """An operand of × or ·."""
    return Brackets(node) if isinstance(node, (Sum, Infix, Big)) else node


def _raised(base: Node, exponent: Node) -> Node:
    if isinstance(base, Apply) and base.power is None and isinstance(base.name, str):
        return replace(base, power=exponent)
    simple = (Letter, Number, Brackets, Grid)
    return Power(base if isinstance(base, simple) else Brackets(base), exponent)


def _ratio(over: Node, under: Node) -> Node:
    small = isinstance(over, Number) and isinstance(under, Number)
    if isinstance(over, Sum) and len(over.terms) == 1:  # the minus stands before the fraction
        return negated(_ratio(over.terms[0].body, under))
    return Fraction(over, under, small)


# --- From SymPy ----------------------------------------------------------------------------------

_RELATIONS = {
    sympy.Eq: "=",
    sympy.Ne: "≠",
    sympy.Gt: ">",
    sympy.Lt: "<",
    sympy.Ge: "≥",
    sympy.Le: "≤",
}


def is_typed(tree: Any) -> bool:
    """Whether a tree has an order that SymPy would not have given it."""
    if isinstance(tree, sympy.MatrixBase):
        return any(is_typed(entry) for entry in tree)
    if isinstance(tree, (Printed, Equation)):
        return True
    if not isinstance(tree, Basic) or not tree.args:
        return False
    if isinstance(tree, (Add, Mul)):
        rest = list(tree.args[1:] if tree.args[0].is_Number else tree.args)
        if any(part.func is tree.func for part in rest) or any(part.is_Number for part in rest):
            return True
        if rest != sorted(rest, key=cmp_to_key(Basic.compare)):
            return True
    if isinstance(tree, Pow) and isinstance(tree.base, Mul) and tree.exp.is_Integer:
        return True
    return any(is_typed(part) for part in tree.args)


def is_evaluated(tree: Any) -> bool:
    """Whether SymPy put a tree together: what is typed has two operands at each node."""
    return not is_typed(tree) and _has_wide_node(tree)


def _has_wide_node(tree: Any) -> bool:
    if isinstance(tree, sympy.MatrixBase):
        return any(map(_has_wide_node, tree))
    if isinstance(tree, (Add, Mul)) and len(tree.args) - (tree.args[0] == -1) > 2:
        return True
    return isinstance(tree, Basic) and any(map(_has_wide_node, tree.args))


def layout(tree: Any, order: Order = "auto") -> Node:
    """The layout of an expression, a matrix, a condition or an `Equation`, each side by itself."""
    if isinstance(tree, Equation):
        sides = tuple(layout(side, order) for side in tree.sides)
        return Chain(sides, (tree.relation,) * (len(sides) - 1))
    tree = sympy.sympify(tree)
    if order == "auto":
        order = "typed" if is_typed(tree) else "mechanics"
    elif order == "printed":
        order = "mechanics" if is_evaluated(tree) else "typed"
    return _node(tree, order)


@singledispatch
def _node(tree: Any, order: Order) -> Node:
    if isinstance(tree, sympy.MatrixBase):
        return _matrix(tree, order)
    if isinstance(tree, Relational):
        return Chain((_node(tree.lhs, order), _node(tree.rhs, order)), (_RELATIONS[tree.func],))
    if isinstance(tree, sympy.Function):
        return _function(tree, order)
    raise TypeError(f"no layout for {type(tree).__name__}: {tree}")


@_node.register(Symbol)
@_node.register(sympy.MatrixSymbol)
def _(tree: Any, order: Order) -> Node:
    return lettered(tree.quantity.glyph if isinstance(tree, Lettered) else glyph(tree.name))


def lettered(shown: Glyph) -> Node:
    """A glyph as a node: ω²ₙ has its exponent above its index, det O is a function of O.

    >>> lettered(Glyph("ω²", "n")) == Power(Letter(Glyph("ω", "n")), Number("2"))
    True
    """
    if shown.base.isdigit() and shown.base.isascii():
        return Number(shown.base)
    name, _, argument = shown.base.partition(" ")
    if argument:
        return Apply(name, (Letter(replace(shown, base=argument)),), brackets=False)
    stem = shown.base.rstrip("⁰¹²³⁴⁵⁶⁷⁸⁹")
    exponent = unicodedata.normalize("NFKC", shown.base.removeprefix(stem))
    letter = Letter(replace(shown, base=stem))
    return Power(letter, Number(exponent)) if exponent else letter


@_node.register
def _(tree: sympy.Number, order: Order) -> Node:
    if tree.is_negative:
        return negated(_node(-tree, order))
    if tree.is_Rational and tree.q != 1:
        return Fraction(Number(str(tree.p)), Number(str(tree.q)), small=True)
    if tree.is_infinite:
        return Number("∞")
    if tree.is_Float:
        return decimal(float(tree))
    return Number(str(tree))


def decimal(number: float, digits_shown: int = 6) -> Node:
    """A decimal number that is not negative, with a power of ten where it needs one.

    >>> decimal(0.25)
    Number(text='0.25')
    """
    digits, _, exponent = f"{number:.{digits_shown}g}".partition("e")
    if not exponent:
        return Number(digits)
    size = abs(int(exponent))
    power = Number(str(size))
    ten = Power(Number("10"), power if int(exponent) > 0 else negated(power))
    return Infix("×", Number(digits), ten)


@_node.register
def _(tree: sympy.NumberSymbol, order: Order) -> Node:
    return Letter(Glyph({"Pi": "π", "Exp1": "e"}[type(tree).__name__]))


@_node.register
def _(tree: sympy.core.numbers.Infinity, order: Order) -> Node:
    return Number("∞")


@_node.register
def _(tree: sympy.core.numbers.NegativeInfinity, order: Order) -> Node:
    return negated(Number("∞"))


@_node.register(Add)
@_node.register(sympy.MatAdd)
def _(tree: Any, order: Order) -> Node:
    terms = tree.args if order == "typed" else _ordered_terms(tree.args)
    nodes = [_node(term, order) for term in terms]
    if order == "mechanics" and isinstance(nodes[0], Sum) and nodes[0].terms[0].negative:
        positive = [node for node in nodes if not isinstance(node, Sum)]
        if positive:  # a sum does not begin with a minus when it need not
            nodes.remove(positive[0])
            nodes.insert(0, positive[0])
    return total(nodes)


@_node.register(Mul)
@_node.register(sympy.MatMul)
def _(tree: Any, order: Order) -> Node:
    return _typed_product(tree) if order == "typed" else _ordered_product(tree)


@_node.register(Pow)
@_node.register(sympy.MatPow)
def _(tree: Any, order: Order) -> Node:
    base, exponent = tree.args
    if not isinstance(tree, sympy.MatPow) and _divides(tree):
        return _ratio(Number("1"), _denominator(tree, order))
    if exponent == 1:
        return _node(base, order)
    if base == sympy.E:
        return Power(Letter(Glyph("e")), _node(exponent, order))
    if exponent.is_Rational and exponent.p == 1:
        index = "" if exponent.q == 2 else str(exponent.q)
        return Root(_node(base, order), index)
    return _raised(_node(base, order), _node(exponent, order))


@_node.register
def _(tree: sympy.Inverse, order: Order) -> Node:
    return _raised(_node(tree.args[0], order), negated(Number("1")))


@_node.register
def _(tree: Matrices, order: Order) -> Node:
    return product([_node(matrix, order) for matrix in tree.args])


@_node.register(sympy.Transpose)
@_node.register(Transposed)
def _(tree: Any, order: Order) -> Node:
    body = _node(tree.args[0], order)
    if isinstance(body, TransposeOf):  # a column, which is printed as a row already
        return body
    if isinstance(body, (Letter, Grid, Brackets)):
        return TransposeOf(body)
    return TransposeOf(Brackets(body))


@_node.register
def _(tree: sympy.exp, order: Order) -> Node:
    return Power(Letter(Glyph("e")), _node(tree.args[0], order))


@_node.register
def _(tree: sympy.Abs, order: Order) -> Node:
    return Brackets(_node(tree.args[0], order), "||")


@_node.register
def _(tree: sympy.Derivative, order: Order) -> Node:
    body = _node(tree.expr, order)
    ((variable, count), *others) = tree.variable_count
    if others:
        raise TypeError(f"no layout for a mixed derivative: {tree}")
    inside = isinstance(body, Letter)
    body = body if inside else bracketed(body)
    return Derivative(body, _node(variable, order), True, inside, order=int(count))


@_node.register
def _(tree: Group, order: Order) -> Node:
    return Brackets(_node(tree.args[0], order))


@_node.register
def _(tree: Underbrace, order: Order) -> Node:
    body, label = tree.args
    return Braced(_node(body, order), _node(label, order))


@_node.register(Cross)
@_node.register(Dot)
def _(tree: Any, order: Order) -> Node:
    left, right = (_as_operand(_node(part, order)) for part in tree.args)
    return Infix("×" if isinstance(tree, Cross) else "·", left, right)


@_node.register
def _(tree: Partial, order: Order) -> Node:
    body, *by = tree.args
    inside = isinstance(body, Symbol)
    shown = _node(body, order)
    for variable in reversed(by):
        shown = shown if inside else bracketed(shown)
        shown = Derivative(shown, _node(variable, order), True, inside)
        inside = False
    return shown


@_node.register
def _(tree: Rate, order: Order) -> Node:
    body, time = _node(tree.args[0], order), Letter(Glyph("t"))
    if isinstance(body, Derivative) and body.partial and not body.frame:
        return Derivative(body, time, False, False)
    dotted = {"": "dot", "dot": "ddot"}
    if len(tree.args) == 1 and isinstance(body, Letter) and body.glyph.accent in dotted:
        return Letter(replace(body.glyph, accent=dotted[body.glyph.accent]))
    if len(tree.args) > 1:
        frame = str(tree.args[1])
        inside = isinstance(body, Letter)
        return Derivative(body if inside else bracketed(body), time, True, inside, frame)
    inside = isinstance(body, Letter)
    return Derivative(body if inside else bracketed(body), time, False, inside)


@_node.register
def _(tree: Slope, order: Order) -> Node:
    body, *by = tree.args
    inside = isinstance(body, Symbol)
    shown = _node(body, order)
    for variable in reversed(by):
        shown = shown if inside else bracketed(shown)
        shown = Derivative(shown, _node(variable, order), False, inside)
        inside = False
    return shown


@_node.register
def _(tree: At, order: Order) -> Node:
    letter, *arguments = (_node(part, order) for part in tree.args)
    name = letter if isinstance(letter, Letter) else Letter(Glyph("?"))
    return Apply(name, tuple(arguments), brackets=True)


@_node.register
def _(tree: Evaluated, order: Order) -> Node:
    body, place = tree.args
    return product([bracketed(_node(body, order)), Letter(Glyph("|", str(place)))])


@_node.register
def _(tree: Integrated, order: Order) -> Node:
    body, *limits = (_node(part, order) for part in tree.args)
    return Big("∫", None, _under_big(body), tuple(limits) or None)


@_node.register
def _(tree: SumOver, order: Order) -> Node:
    index, body = tree.args
    shown = _node(index, order) if str(index) else None
    return Big("∑", shown, _under_big(_node(body, order)))


@_node.register
def _(tree: SumFrom, order: Order) -> Node:
    index, first, last, body = (_node(part, order) for part in tree.args)
    return Big("∑", index, _under_big(body), (first, last))


@_node.register
def _(tree: VolumeIntegral, order: Order) -> Node:
    measure, body = tree.args
    named = re.fullmatch(r"d(\d)(\w+)", str(measure))
    if not named:
        return Big("∫", _node(measure, order), _under_big(_node(body, order)))
    vector = {"r": "r_vec", "rp": "r_vecp"}.get(named[2], named[2])
    node = Measure(named[1], Letter(glyph(vector)))
    return Big("∫", node, _under_big(_node(body, order)))


@_node.register
def _(tree: IntegralOver, order: Order) -> Node:
    variable, low, high, body = (_node(part, order) for part in tree.args)
    return Big("∫", Measure("", variable, (low, high)), _under_big(body))


def _under_big(body: Node) -> Node:
    return Brackets(body) if isinstance(body, Sum) else body


@_node.register(sympy.And)
@_node.register(sympy.Or)
def _(tree: Any, order: Order) -> Node:
    parts = sorted(tree.args, key=sympy.default_sort_key)
    between = "and" if isinstance(tree, sympy.And) else "or"
    return Listed(tuple(_node(part, order) for part in parts), between)


@_node.register
def _(tree: sympy.Tuple, order: Order) -> Node:
    return Listed(tuple(_node(part, order) for part in tree.args))


@_node.register(sympy.logic.boolalg.BooleanAtom)
def _(tree: Any, order: Order) -> Node:
    return Letter(Glyph("true" if tree else "false"))


def _matrix(tree: Any, order: Order) -> Node:
    rows, columns = tree.shape
    entries = [_node(entry, order) for entry in tree]
    if columns == 1 and rows > 1:  # a column is printed as the notes do, as a transposed row
        return TransposeOf(Brackets(Listed(tuple(entries)), "[]"))
    if rows == 1 and columns > 1:
        return Brackets(Listed(tuple(entries)), "[]")
    return Grid(tuple(tuple(entries[r * columns : (r + 1) * columns]) for r in range(rows)))


_NAMES = {
    "asin": "arcsin",
    "acos": "arccos",
    "atan": "arctan",
    "log": "ln",
    "elliptic_k": "K",
    "elliptic_f": "F",
    "elliptic_pi": "Π",
}
"""Elliptic integrals as in DLMF 19.2, with the parameter m = k², not the modulus."""


def _function(tree: Any, order: Order) -> Node:
    arguments = tuple(_node(argument, order) for argument in tree.args)
    if isinstance(tree, sympy.core.function.AppliedUndef):
        return Apply(Letter(glyph(tree.func.__name__)), arguments, brackets=True)
    name = type(tree).__name__
    bare = len(arguments) == 1 and isinstance(arguments[0], (Letter, Number))
    elliptic = name.startswith("elliptic")  # sin θ, but K(m)
    return Apply(_NAMES.get(name, name), arguments, brackets=elliptic or not bare)


# --- Products as typed ---------------------------------------------------------------------------


def _divides(factor: Any) -> bool:
    """Whether a factor stands below the fraction bar."""
    return isinstance(factor, Pow) and bool(factor.exp.is_number and factor.exp.is_negative)


def _denominator(factor: Pow, order: Order) -> Node:
    exponent = -factor.exp
    if exponent == 1:
        return _node(factor.base, order)
    return _node(Pow(factor.base, exponent, evaluate=False), order)


def _typed_product(tree: Any) -> Node:
    negative, parts = _typed_parts(tree)
    done: list[Node] = []
    start = 0  # where the numerator of the next division begins
    for divides, node in parts:
        if not divides:
            done.append(node)
            if len(done) == 1 and isinstance(node, Fraction) and node.small:
                start = 1  # ½a/b is ½ times a/b
            continue
        over = done[start:]
        del done[start:]
        last = done[-1] if done and not over else None
        if isinstance(last, Fraction) and not last.small:  # a/b/c
            done[-1] = replace(last, under=product([_as_factor(last.under, False), node]))
        else:
            done.append(_ratio(product(over), node))
        start = len(done)
    node = product(done)
    return negated(node) if negative else node


def _typed_parts(tree: Any) -> tuple[bool, list[tuple[bool, Node]]]:
    """The sign, and the factors from left to right, each with whether it is divided by."""
    negative = False
    parts: list[tuple[bool, Node]] = []
    for i, factor in enumerate(tree.args):
        if isinstance(factor, (Mul, sympy.MatMul)):
            if i == 0:
                negative, parts = _typed_parts(factor)
                continue
            minus, inner = _typed_parts(factor)
            if minus or any(divides for divides, _ in inner):
                parts.append((False, _node(factor, "typed")))
            else:
                parts.extend(inner)
        elif _divides(factor):
            parts.append((True, _denominator(factor, "typed")))
        elif i == 0 and factor == -1 and len(tree.args) > 1:
            negative = True
        elif i == 0 and factor.is_number and factor.is_negative:
            negative = True
            parts.append((False, _node(-factor, "typed")))
        else:
            parts.append((False, _node(factor, "typed")))
    return negative, parts


# --- The order of mechanics ----------------------------------------------------------------------

_RATE_WEIGHT = {"rad/s": 1, "1/s": 1, "rad/s²": 2, "rad/s³": 3, "J s": 1}
_ACCENT_WEIGHT = {"dot": 1, "ddot": 2}
_FUNCTIONS = ("sin", "cos", "tan")
_NUMBER, _PARAMETER, _PARAMETER_SUM, _MOMENTUM, _SUM, _RATE, _ANGLE, _FUNCTION, _REST, _VECTOR = (
    range(10)
)

_Key = tuple[Any, ...]


def _weight(symbol: Symbol) -> int:
    """How many inverse seconds a symbol brings to a term."""
    symbol = stands_for(symbol)
    _, quantity = known(symbol)
    if isinstance(symbol, Lettered):  # a velocity may be in m/s as well
        by_accent = _ACCENT_WEIGHT.get(symbol.quantity.glyph.accent, 0)
        return _RATE_WEIGHT.get(symbol.quantity.unit, by_accent)
    if quantity is not None:
        return _RATE_WEIGHT.get(quantity.unit, 0)
    return _ACCENT_WEIGHT.get(glyph(symbol.name).accent, 0)


def _symbol_key(symbol: Symbol) -> _Key:
    symbol = stands_for(symbol)
    position, quantity = known(symbol)
    shown = glyph(symbol.name) if quantity is None else quantity.glyph
    if shown.bold:
        kind = _VECTOR
    elif quantity is not None and quantity.unit in ("J s", "kg m/s"):
        kind = _MOMENTUM
    elif _weight(symbol):
        kind = _RATE
    elif quantity is not None and quantity.unit in ("rad", "s"):
        kind = _ANGLE
    elif isinstance(symbol, Lettered) and not symbol.is_positive:
        kind = _ANGLE  # a coordinate in m
    else:
        kind = _PARAMETER
    return kind, position, symbol.name


def _factor_key(factor: Expr) -> _Key:
    base = factor.base if isinstance(factor, Pow) else factor
    if base.is_number:
        return _NUMBER, 0 if base.is_Rational else 1, str(base)
    if isinstance(base, Symbol):
        return _symbol_key(base)
    symbols = sorted(base.free_symbols, key=_symbol_key)
    if isinstance(base, (Add, Mul)):  # a product only beneath a root
        if all(_symbol_key(symbol)[0] == _PARAMETER for symbol in symbols):
            return _PARAMETER_SUM, _symbol_key(symbols[0])[1], str(base)
        moves = any(_weight(symbol) for symbol in symbols)
        return _SUM if moves else _REST, _symbol_key(symbols[0])[1], str(base)
    name = type(base).__name__
    if name in _FUNCTIONS and len(symbols) >= 1:
        return _FUNCTION, _symbol_key(symbols[0])[1], _FUNCTIONS.index(name), str(base)
    return _REST, 0, str(base)


def _degree(factor: Expr) -> float:
    if isinstance(factor, Symbol):
        return _weight(factor)
    if isinstance(factor, Pow) and factor.exp.is_number:
        return float(factor.exp) * _degree(factor.base)
    if isinstance(factor, Mul):
        return sum(_degree(part) for part in factor.args)
    if isinstance(factor, Add):
        return max(_degree(part) for part in factor.args)
    return 0


def _term_key(term: Expr) -> _Key:
    """Many rates first; then by parameters; then as the glossary has the rates.

    Terms of first degree with a bare rate stand before those with functions: ψ̇ + φ̇ cos θ.
    """
    degree = _degree(term)
    root = any(isinstance(f, Pow) and not f.exp.is_integer and f.base.is_Add for f in term.args)
    keys = sorted(_factor_key(factor) for factor in Mul.make_args(term))
    symbols = sorted(map(_symbol_key, term.free_symbols))
    parameters = tuple(key[1:] for key in symbols if key[0] == _PARAMETER)
    functions = sum(key[0] == _FUNCTION for key in keys)
    return (
        -degree,
        root,
        parameters,
        functions if degree == 1 else 0,
        [(key[0], key[1]) for key in keys if key[0] not in (_NUMBER, _PARAMETER)],
        str(term),
    )


def _ordered_terms(terms: Sequence[Expr]) -> list[Expr]:
    return sorted(terms, key=_term_key)


def _with_one_root(factors: Sequence[Expr]) -> list[Expr]:
    """√a √b as √(ab), above and below the bar."""
    rest = list(factors)
    for power in (sympy.S.Half, -sympy.S.Half):
        roots = [f for f in rest if isinstance(f, Pow) and f.exp == power]
        if len(roots) > 1:
            rest = [f for f in rest if f not in roots]
            rest.append(Pow(Mul(*(root.base for root in roots)), power, evaluate=False))
    return rest


def _ordered_product(tree: Any) -> Node:
    if isinstance(tree, sympy.MatMul):  # matrices do not commute
        return _typed_product(tree)
    factors = sorted(_with_one_root(tree.args), key=_factor_key)
    negative = False
    over: list[Node] = []
    under: list[Node] = []
    number: Any = sympy.S.One
    for factor in factors:
        if factor.is_Rational:
            number = number * factor
        elif _divides(factor):
            under.append(_denominator(factor, "mechanics"))
        else:
            over.append(_node(factor, "mechanics"))
    if number.is_negative:
        negative, number = True, -number
    whole: list[Node] = []
    if under:
        if number.p != 1:
            over.insert(0, Number(str(number.p)))
        if number.q != 1:
            under.insert(0, Number(str(number.q)))
        over = [_ratio(product(over), product(under))]
    elif number != 1:
        whole = [_node(number, "mechanics")]
    node = product([*whole, *over])
    return negated(node) if negative else node


# --- Height, width, and breaking into lines -------------------------------------------------------


_TALL = (Fraction, Braced, Big, Derivative, Grid, Root)


def is_tall(node: Any) -> bool:
    """Whether brackets round a node must grow."""
    if isinstance(node, Fraction):
        return not node.small
    if isinstance(node, _TALL):
        return True
    if isinstance(node, Sum):
        return any(is_tall(term.body) for term in node.terms)
    if isinstance(node, Product):
        return any(map(is_tall, node.factors))
    if isinstance(node, Listed):
        return any(map(is_tall, node.items))
    if isinstance(node, (Power, Brackets, TransposeOf)):
        return is_tall(node.base if isinstance(node, Power) else node.body)
    if isinstance(node, Infix):
        return is_tall(node.left) or is_tall(node.right)
    return isinstance(node, Chain) and any(map(is_tall, node.sides))


def width(node: Node) -> float:
    """About how many letters wide a node is printed."""
    match node:
        case Number():
            return len(node.text)
        case Letter():
            return len(node.glyph.base) + 0.6 * len(node.glyph.sub)
        case Sum():
            return sum(width(term.body) for term in node.terms) + 2.5 * len(node.terms) - 1
        case Product():
            spaces = sum(0.4 for joint in node.joints if joint)
            return sum(map(width, node.factors)) + spaces
        case Fraction():
            return max(width(node.over), width(node.under)) * (0.6 if node.small else 1) + 0.4
        case Power():
            return width(node.base) + 0.6 * width(node.exponent)
        case Root():
            return width(node.body) + 1.5
        case Apply():
            name = len(node.name) if isinstance(node.name, str) else width(node.name)
            power = 0.6 * width(node.power) if node.power else 0
            return name + power + sum(map(width, node.arguments)) + (1.5 if node.brackets else 0.4)
        case Brackets():
            return width(node.body) + 1.5
        case Braced():
            return max(width(node.body), 1 + 0.7 * width(node.label))
        case Infix():
            return width(node.left) + width(node.right) + 2
        case TransposeOf():
            return width(node.body) + 1
        case Derivative():
            inner = width(node.body)
            head = 1.5 + (inner if node.inside else 0)
            return (
                head
                + (0 if node.inside else inner)
                + (2 + 0.6 * len(node.frame) if node.frame else 0)
            )
        case Big():
            measure = width(node.index) if node.sign == "∫" and node.index is not None else 0
            return 2.5 + measure + width(node.body)
        case Measure():
            return 1.6 + width(node.variable) + max(map(width, node.bounds), default=0.0)
        case Grid():
            columns = zip(*node.rows, strict=True)
            return sum(max(map(width, column)) + 2 for column in columns)
        case Listed():
            return sum(map(width, node.items)) + (1.5 if node.between == "," else 5) * len(
                node.items
            )
        case Chain():
            return sum(map(width, node.sides)) + 3 * len(node.signs)


@dataclass(frozen=True)
class Line:
    """One line of a display: what stands left of the alignment, the sign, what stands right.

    The first line of an equation has a `left` side; a line that continues a sum has no `sign`.
    """

    left: Node | None
    sign: str
    right: Node


LINE = 62.0
"""How many letters wide a line of the page is."""


def lines(equation: Equation | Chain, order: Order = "auto", limit: float = LINE) -> list[Line]:
    """An equation broken before its relation signs, and long sums before a + or −."""
    chain = layout(equation, order) if isinstance(equation, Equation) else equation
    assert isinstance(chain, Chain)
    first = chain.sides[0]
    margin = min(width(first) + 3, limit / 2)
    packed: list[tuple[list[Node], list[str]]] = [([chain.sides[1]], [chain.signs[0]])]
    for sign, side in zip(chain.signs[1:], chain.sides[2:], strict=True):
        sides, signs = packed[-1]
        if margin + sum(map(width, sides)) + 3 * len(signs) + width(side) <= limit:
            sides.append(side)
            signs.append(sign)
        else:
            packed.append(([side], [sign]))
    made: list[Line] = []
    for sides, signs in packed:
        pieces = _broken(sides[0], limit - margin) if len(sides) == 1 else [sides[0]]
        joined = pieces if len(sides) == 1 else [Chain(tuple(sides), tuple(signs[1:]))]
        for i, piece in enumerate(joined):
            left = first if not made else None
            made.append(Line(left, signs[0] if i == 0 else "", piece))
    return made


def _broken(node: Node, limit: float) -> list[Node]:
    if not isinstance(node, Sum) or width(node) <= limit:
        return [node]
    rows: list[list[Signed]] = [[]]
    for term in node.terms:
        if rows[-1] and width(Sum((*rows[-1], term))) > limit:
            rows.append([])
        rows[-1].append(term)
    return [Sum(tuple(rows[0])), *(Continued(tuple(row)) for row in rows[1:])]
