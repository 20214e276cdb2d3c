"""Expressions of SymPy in the numbers of a world, written as formulas."""

from __future__ import annotations

import sympy
from sympy import Expr

from rigidtop.judge.jets import TIME, jet_of
from rigidtop.judge.letters import CLOCK
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node


def written(expression: Expr) -> Node:
    """A formula for an expression: sums, products, powers and functions of letters and rates."""
    if expression.is_Symbol:
        return _letter(expression)
    if expression.is_Rational:
        return _number(expression)
    if expression.is_Add:
        terms = sorted(expression.args, key=lambda x: x.could_extract_minus_sign())
        return n.Sum(tuple(_term(x) for x in terms))
    if expression.is_Mul:
        return _product(expression)
    if expression.is_Pow:
        base, exponent = expression.as_base_exp()
        if exponent == sympy.Rational(1, 2):
            return n.Root(written(base))
        return n.Power(_grouped(base), written(exponent))
    if expression == sympy.pi:
        return Letter("π")
    if expression.is_Function and len(expression.args) == 1:
        return n.Apply(expression.func.__name__, written(expression.args[0]))
    return Letter("…")


def _letter(x: sympy.Symbol) -> Node:
    if x == TIME:
        return CLOCK
    jet = jet_of(x)
    if jet is None:
        return Letter("…")
    return n.TimeDerivative(jet.letter, jet.order, True) if jet.order else jet.letter


def _number(value: Expr) -> Node:
    if value < 0:
        return n.Negative(_number(-value))
    over = n.Number(str(value.p))
    return over if value.q == 1 else n.Quotient(over, n.Number(str(value.q)))


def _term(expression: Expr) -> Node:
    if expression.could_extract_minus_sign():
        return n.Negative(_grouped(-expression))
    return written(expression)


def _product(expression: Expr) -> Node:
    if expression.could_extract_minus_sign():
        return n.Negative(_product(-expression) if (-expression).is_Mul else written(-expression))
    over, under = sympy.fraction(expression)
    if under != 1:
        return n.Quotient(written(over), written(under))
    return n.Product(tuple(_grouped(x) for x in expression.as_ordered_factors()))


def _grouped(expression: Expr) -> Node:
    node = written(expression)
    return n.Bracketed(node) if isinstance(node, n.Sum) else node
