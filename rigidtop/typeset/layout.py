"""From a SymPy tree to a tree of layout: every decision about order, signs, fractions, brackets.

The renderers (`latex`, `mathml`, `text`) only spell out what stands here, so that the same
equation reads the same in all of them.  A tree that was *typed* (inside
`rigidtop.proof.equation.as_printed`) keeps the order of typing.  An *evaluated* tree, whose order
SymPy chose, is put into the order of mechanics: in a product numbers, parameters, momenta, rates,
functions of angles; in a sum what has more rates first, so that kinetic stands before potential.

>>> from rigidtop.theory.symbols import lambda1, phidot, theta
>>> layout(lambda1 * phidot / 2)
Factors(factors=(Fraction(over=Digits(text='1'), under=Digits(text='2'), small=True), \
Atom(glyph=Glyph(base='λ', sub='1', accent='', bold=False, prime=False)), \
Atom(glyph=Glyph(base='φ', sub='', accent='dot', bold=False, prime=False))), joints=('', ''))
"""

from __future__ import annotations

import re
from dataclasses import replace
from functools import cmp_to_key, singledispatch
from typing import Literal

import sympy
from sympy import Add, Basic, Expr, Mul, Pow, Symbol
from sympy.core.relational import Relational

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
    Slope,
    SumOver,
    Transposed,
    Underbrace,
    VolumeIntegral,
)
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.symbols import Glyph
from rigidtop.typeset import nodes as lay
from rigidtop.typeset.order import factor_key, ordered_terms, with_one_root

Order = Literal["typed", "printed", "mechanics", "auto"]
"""``typed``: as typed.  ``printed``: as typed, but for a side that is certainly SymPy's own, as in
an equation of the notes that takes one side from the engine.  ``mechanics``: the order of
mechanics.  ``auto``: that too, but for a side that is certainly typed."""


# --- The nodes -----------------------------------------------------------------------------------


_RELATIONS = {
    sympy.Eq: "=",
    sympy.Ne: "≠",
    sympy.Gt: ">",
    sympy.Lt: "<",
    sympy.Ge: "≥",
    sympy.Le: "≤",
}


def is_typed(tree: Basic) -> bool:
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


def is_evaluated(tree: Expr) -> bool:
    """Whether SymPy put a tree together: what is typed has two operands at each node."""
    return not is_typed(tree) and _has_wide_node(tree)


def _has_wide_node(tree: Expr) -> bool:
    if isinstance(tree, sympy.MatrixBase):
        return any(map(_has_wide_node, tree))
    if isinstance(tree, (Add, Mul)) and len(tree.args) - (tree.args[0] == -1) > 2:
        return True
    return isinstance(tree, Basic) and any(map(_has_wide_node, tree.args))


def layout(tree: Basic, order: Order = "auto") -> lay.Node:
    """The layout of an expression, a matrix, a condition or an `Equation`, each side by itself."""
    if isinstance(tree, Equation):
        sides = tuple(layout(side, order) for side in tree.sides)
        signs = tuple(tree.relation.split())
        return lay.Chain(sides, signs if signs[1:] else signs * (len(sides) - 1))
    tree = sympy.sympify(tree)
    if order == "auto":
        order = "typed" if is_typed(tree) else "mechanics"
    elif order == "printed":
        order = "mechanics" if is_evaluated(tree) else "typed"
    return _node(tree, order)


@singledispatch
def _node(tree: Basic, order: Order) -> lay.Node:
    if isinstance(tree, sympy.MatrixBase):
        return _matrix(tree, order)
    if isinstance(tree, Relational):
        return lay.Chain((_node(tree.lhs, order), _node(tree.rhs, order)), (_RELATIONS[tree.func],))
    if isinstance(tree, sympy.Function):
        return _function(tree, order)
    raise TypeError(f"no layout for {type(tree).__name__}: {tree}")


@_node.register(Symbol)
@_node.register(sympy.MatrixSymbol)
def _(tree: Expr, order: Order) -> lay.Node:
    return lay.lettered(tree.quantity.glyph if isinstance(tree, Lettered) else lay.glyph(tree.name))


@_node.register
def _(tree: sympy.Number, order: Order) -> lay.Node:
    if tree.is_extended_negative:
        return lay.negated(_node(-tree, order))
    if tree.is_Rational and tree.q != 1:
        return lay.Fraction(lay.Digits(str(tree.p)), lay.Digits(str(tree.q)), small=True)
    if tree.is_infinite:
        return lay.Digits("∞")
    if tree.is_Float:
        return lay.decimal(float(tree))
    return lay.Digits(str(tree))


@_node.register
def _(tree: sympy.core.numbers.ImaginaryUnit, order: Order) -> lay.Node:
    return lay.lettered(lay.glyph("i"))


@_node.register
def _(tree: sympy.NumberSymbol, order: Order) -> lay.Node:
    return lay.Atom(Glyph({"Pi": "π", "Exp1": "e"}[type(tree).__name__]))


@_node.register(Add)
@_node.register(sympy.MatAdd)
def _(tree: Expr, order: Order) -> lay.Node:
    terms = tree.args if order == "typed" else ordered_terms(tree.args)
    nodes = [_node(term, order) for term in terms]
    if order == "mechanics" and isinstance(nodes[0], lay.Terms) and nodes[0].terms[0].negative:
        positive = [node for node in nodes if not isinstance(node, lay.Terms)]
        if positive:  # a sum does not begin with a minus when it need not
            nodes.remove(positive[0])
            nodes.insert(0, positive[0])
    return lay.total(nodes)


@_node.register(Mul)
@_node.register(sympy.MatMul)
def _(tree: Expr, order: Order) -> lay.Node:
    return _typed_product(tree) if order == "typed" else _ordered_product(tree)


@_node.register(Pow)
@_node.register(sympy.MatPow)
def _(tree: Expr, order: Order) -> lay.Node:
    base, exponent = tree.args
    if not isinstance(tree, sympy.MatPow) and _divides(tree):
        return lay.ratio(lay.Digits("1"), _denominator(tree, order))
    if exponent == 1:
        return _node(base, order)
    if base == sympy.E:
        return lay.Superscript(lay.Atom(Glyph("e")), lay.flat(_node(exponent, order)))
    if exponent == sympy.Rational(1, 2) and isinstance(base, Dot) and base.args[0] == base.args[1]:
        return lay.Brackets(_node(base.args[0], order), "||")
    if exponent.is_Rational and exponent.p == 1:
        index = "" if exponent.q == 2 else str(exponent.q)
        return lay.Radical(_node(base, order), index)
    return lay.raised(_node(base, order), _node(exponent, order))


@_node.register
def _(tree: sympy.Inverse, order: Order) -> lay.Node:
    return lay.raised(_node(tree.args[0], order), lay.negated(lay.Digits("1")))


@_node.register
def _(tree: Matrices, order: Order) -> lay.Node:
    return lay.product([_node(matrix, order) for matrix in tree.args])


@_node.register(sympy.Transpose)
@_node.register(Transposed)
def _(tree: Expr, order: Order) -> lay.Node:
    body = _node(tree.args[0], order)
    if isinstance(body, lay.TransposeOf):  # a column, which is printed as a row already
        return body
    if isinstance(body, (lay.Atom, lay.Grid, lay.Brackets)):
        return lay.TransposeOf(body)
    return lay.TransposeOf(lay.Brackets(body))


@_node.register
def _(tree: sympy.exp, order: Order) -> lay.Node:
    return lay.Superscript(lay.Atom(Glyph("e")), lay.flat(_node(tree.args[0], order)))


@_node.register
def _(tree: sympy.Abs, order: Order) -> lay.Node:
    return lay.Brackets(_node(tree.args[0], order), "||")


@_node.register
def _(tree: sympy.Derivative, order: Order) -> lay.Node:
    body = _node(tree.expr, order)
    ((variable, count), *others) = tree.variable_count
    if others:
        raise TypeError(f"no layout for a mixed derivative: {tree}")
    inside = isinstance(body, lay.Atom)
    body = body if inside else lay.bracketed(body)
    return lay.DifferentialQuotient(body, _node(variable, order), True, inside, order=int(count))


@_node.register
def _(tree: Group, order: Order) -> lay.Node:
    return lay.Brackets(_node(tree.args[0], order))


@_node.register
def _(tree: Underbrace, order: Order) -> lay.Node:
    body, label = tree.args
    return lay.BraceBelow(_node(body, order), _node(label, order))


@_node.register(Cross)
@_node.register(Dot)
def _(tree: Expr, order: Order) -> lay.Node:
    left, right = (lay.as_operand(_node(part, order)) for part in tree.args)
    return lay.Infix("×" if isinstance(tree, Cross) else "·", left, right)


@_node.register
def _(tree: Partial, order: Order) -> lay.Node:
    body, by = tree.args
    node, inside = _node(body, order), isinstance(body, Symbol)
    node = node if inside else lay.bracketed(node)
    return lay.DifferentialQuotient(node, _node(by, order), True, inside)


@_node.register
def _(tree: Slope, order: Order) -> lay.Node:
    of, by = tree.args
    count = 1
    while isinstance(of, Slope) and of.args[1] == by:
        of, count = of.args[0], count + 1
    node, inside = _node(of, order), isinstance(of, Symbol)
    node = node if inside else lay.bracketed(node)
    return lay.DifferentialQuotient(node, _node(by, order), False, inside, order=count)


@_node.register
def _(tree: Rate, order: Order) -> lay.Node:
    body, time = _node(tree.args[0], order), lay.Atom(Glyph("t"))
    if isinstance(body, lay.DifferentialQuotient) and body.partial and not body.frame:
        return lay.DifferentialQuotient(body, time, False, False)
    dotted = {"": "dot", "dot": "ddot"}
    if len(tree.args) == 1 and isinstance(body, lay.Atom) and body.glyph.accent in dotted:
        return lay.Atom(replace(body.glyph, accent=dotted[body.glyph.accent]))
    inside, frame = isinstance(body, lay.Atom), "".join(map(str, tree.args[1:]))
    body = body if inside else lay.bracketed(body)
    return lay.DifferentialQuotient(body, time, bool(frame), inside, frame)


@_node.register
def _(tree: SumOver, order: Order) -> lay.Node:
    index, body = tree.args
    node = _node(index, order) if str(index) else None
    return lay.Big("∑", node, _under_big(_node(body, order)))


@_node.register
def _(tree: VolumeIntegral, order: Order) -> lay.Node:
    measure, body = tree.args
    named = re.fullmatch(r"d(\d)(\w+)", str(measure))
    if not named:
        return lay.Big("∫", _node(measure, order), _under_big(_node(body, order)))
    vector = {"r": "r_vec", "rp": "r_vecp"}.get(named[2], named[2])
    node = lay.IntegralMeasure(named[1], lay.Atom(lay.glyph(vector)))
    return lay.Big("∫", node, _under_big(_node(body, order)))


@_node.register
def _(tree: IntegralOver, order: Order) -> lay.Node:
    variable, low, high, body = (_node(part, order) for part in tree.args)
    return lay.Big("∫", lay.IntegralMeasure("", variable, (low, high)), _under_big(body))


def _under_big(body: lay.Node) -> lay.Node:
    return lay.Brackets(body) if isinstance(body, lay.Terms) else body


@_node.register(sympy.And)
@_node.register(sympy.Or)
def _(tree: Expr, order: Order) -> lay.Node:
    parts = sorted(tree.args, key=sympy.default_sort_key)
    between = "and" if isinstance(tree, sympy.And) else "or"
    return lay.Enumeration(tuple(_node(part, order) for part in parts), between)


@_node.register
def _(tree: sympy.Tuple, order: Order) -> lay.Node:
    return lay.Enumeration(tuple(_node(part, order) for part in tree.args))


@_node.register(sympy.logic.boolalg.BooleanAtom)
def _(tree: Expr, order: Order) -> lay.Node:
    return lay.Atom(Glyph("true" if tree else "false"))


def _matrix(tree: Expr, order: Order) -> lay.Node:
    rows, columns = tree.shape
    entries = [_node(entry, order) for entry in tree]
    if columns == 1 and rows > 1:  # a column is printed as the notes do, as a transposed row
        return lay.TransposeOf(lay.Brackets(lay.Enumeration(tuple(entries)), "[]"))
    if rows == 1 and columns > 1:
        return lay.Brackets(lay.Enumeration(tuple(entries)), "[]")
    return lay.Grid(tuple(tuple(entries[r * columns : (r + 1) * columns]) for r in range(rows)))


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


def _function(tree: Expr, order: Order) -> lay.Node:
    arguments = tuple(_node(argument, order) for argument in tree.args)
    if isinstance(tree, sympy.core.function.AppliedUndef):
        return lay.FunctionOf(lay.Atom(lay.glyph(tree.func.__name__)), arguments, brackets=True)
    name = type(tree).__name__
    bare = len(arguments) == 1 and isinstance(arguments[0], (lay.Atom, lay.Digits))
    elliptic = name.startswith("elliptic")  # sin θ, but K(m)
    return lay.FunctionOf(_NAMES.get(name, name), arguments, brackets=elliptic or not bare)


# --- Products as typed ---------------------------------------------------------------------------


def _divides(factor: Expr) -> bool:
    """Whether a factor stands below the fraction bar."""
    return isinstance(factor, Pow) and bool(factor.exp.is_number and factor.exp.is_negative)


def _denominator(factor: Pow, order: Order) -> lay.Node:
    exponent = -factor.exp
    if exponent == 1:
        return _node(factor.base, order)
    return _node(Pow(factor.base, exponent, evaluate=False), order)


def _typed_product(tree: Expr) -> lay.Node:
    negative, parts = _typed_parts(tree)
    done: list[lay.Node] = []
    start = 0  # where the numerator of the next division begins
    for divides, node in parts:
        if not divides:
            done.append(node)
            if len(done) == 1 and isinstance(node, lay.Fraction) and node.small:
                start = 1  # ½a/b is ½ times a/b
            continue
        over = done[start:]
        del done[start:]
        last = done[-1] if done and not over else None
        if isinstance(last, lay.Fraction) and not last.small:  # a/b/c
            done[-1] = replace(last, under=lay.product([lay.as_factor(last.under, False), node]))
        else:
            done.append(lay.ratio(lay.product(over), node))
        start = len(done)
    node = lay.product(done)
    return lay.negated(node) if negative else node


def _typed_parts(tree: Expr) -> tuple[bool, list[tuple[bool, lay.Node]]]:
    """The sign, and the factors from left to right, each with whether it is divided by."""
    negative = False
    parts: list[tuple[bool, lay.Node]] = []
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


def _ordered_product(tree: Expr) -> lay.Node:
    if isinstance(tree, sympy.MatMul):  # matrices do not commute
        return _typed_product(tree)
    factors = sorted(with_one_root(tree.args), key=factor_key)
    negative = False
    over: list[lay.Node] = []
    under: list[lay.Node] = []
    number: Expr = sympy.S.One
    for factor in factors:
        if factor.is_Rational:
            number = number * factor
        elif _divides(factor):
            under.append(_denominator(factor, "mechanics"))
        else:
            over.append(_node(factor, "mechanics"))
    if number.is_negative:
        negative, number = True, -number
    whole: list[lay.Node] = []
    if under:
        if number.p != 1:
            over.insert(0, lay.Digits(str(number.p)))
        if number.q != 1:
            under.insert(0, lay.Digits(str(number.q)))
        over = [lay.ratio(lay.product(over), lay.product(under))]
    elif number != 1:
        whole = [_node(number, "mechanics")]
    node = lay.product([*whole, *over])
    return lay.negated(node) if negative else node


# --- Height, width, and breaking into lines -------------------------------------------------------
