"""Python text of a lambdified function, laid out for a reader.

`sympy.lambdify` writes correct Python on lines of any length.  The functions here take its text
apart and lay it out as `ruff format` would, so that what is printed is what runs.
"""

from __future__ import annotations

import ast
import inspect
import re
from collections.abc import Callable
from typing import Any

import sympy

WIDTH = 100
INDENT = "    "


def syntax_tree(function: Callable[..., Any]) -> ast.FunctionDef:
    """The definition that `lambdify` wrote for a function, with 1/2·x rewritten as x/2."""
    (definition,) = ast.parse(inspect.getsource(function)).body
    assert isinstance(definition, ast.FunctionDef)
    made: ast.FunctionDef = ast.fix_missing_locations(_FractionsLast().visit(definition))
    return made


def operations(tree: ast.AST) -> int:
    """How many sums, products, powers, signs and function calls one evaluation takes."""
    counted = (ast.BinOp, ast.UnaryOp, ast.Call)
    return sum(isinstance(node, counted) for node in ast.walk(tree))


def names_called(definition: ast.FunctionDef) -> set[str]:
    """The functions, such as sin, that a definition calls."""
    calls = (node.func for node in ast.walk(definition) if isinstance(node, ast.Call))
    return {called.id for called in calls if isinstance(called, ast.Name)}


def signature(name: str, parameters: list[str], returns: str = "") -> list[str]:
    """``def name(parameters):``, broken over lines where it is too long for one."""
    end = f") -> {returns}:" if returns else "):"
    for inside in (f"{', '.join(parameters)}", f"\n{INDENT}{', '.join(parameters)}\n"):
        text = f"def {name}({inside}{end}"
        if all(len(line) <= WIDTH for line in text.splitlines()):
            return text.splitlines()
    return [f"def {name}(", *(f"{INDENT}{p}," for p in parameters), end]


def body(definition: ast.FunctionDef, depth: int = 1) -> list[str]:
    """The statements of a definition, indented `depth` times; a list is returned as a tuple."""
    lines: list[str] = []
    for statement in definition.body:
        if isinstance(statement, ast.Assign):
            (target,) = statement.targets
            lines += assignment(_text(target), statement.value, depth)
        elif isinstance(statement, ast.Return) and isinstance(statement.value, ast.List):
            lines += [INDENT * depth + "return ("]
            for entry in statement.value.elts:
                lines += _entry(entry, depth + 1)
            lines += [INDENT * depth + ")"]
        else:
            raise TypeError(f"lambdify wrote a {type(statement).__name__}: not laid out here")
    return lines


def expression(value: sympy.Expr) -> ast.expr:
    """The syntax tree of one expression."""
    tree = ast.parse(sympy.pycode(value, fully_qualified_modules=False), mode="eval").body
    made: ast.expr = ast.fix_missing_locations(_FractionsLast().visit(tree))
    return made


def assignment(target: str, value: ast.expr, depth: int = 1) -> list[str]:
    """``target = value``, indented `depth` times."""
    line = f"{INDENT * depth}{target} = {_text(value)}"
    if len(line) <= WIDTH:
        return [line]
    terms = [INDENT * (depth + 1) + term for term in _terms(value)]
    return [f"{INDENT * depth}{target} = (", *terms, INDENT * depth + ")"]


def _entry(value: ast.expr, depth: int) -> list[str]:
    line = f"{INDENT * depth}{_text(value)},"
    if len(line) <= WIDTH:
        return [line]
    terms = [INDENT * depth + term for term in _terms(value)]
    return [*terms[:-1], terms[-1] + ","]


def _terms(value: ast.expr) -> list[str]:
    """A sum as lines that begin with their sign, a product likewise; anything else as one line."""
    for kind in ((ast.Add, ast.Sub), (ast.Mult, ast.Div)):
        if isinstance(value, ast.BinOp) and isinstance(value.op, kind):
            return _operands(value, kind)
    return [_text(value)]


def _operands(value: ast.expr, kind: tuple[type[ast.operator], ...]) -> list[str]:
    if isinstance(value, ast.BinOp) and isinstance(value.op, kind):
        sign = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/"}[type(value.op)]
        return [*_operands(value.left, kind), f"{sign} {_operand(value.right, value.op)}"]
    return [_operand(value, kind[0]())]


def _operand(value: ast.expr, beside: ast.operator) -> str:
    """The text of an operand, in the parentheses that it has as the right one of `beside`."""
    whole = _text(ast.BinOp(ast.Name("_"), beside, value))
    return whole.split(" ", 2)[2]


def _text(node: ast.expr) -> str:
    # ruff writes a power of two plain names without blanks
    return re.sub(r"\b(\w+) \*\* (\w+)\b", r"\1**\2", ast.unparse(node))


class _FractionsLast(ast.NodeTransformer):
    """(1/2)·a·b → a·b/2.

    The value is the same, but no fraction of two integers remains, which Python would round before
    a symbol can meet it.
    """

    def visit_BinOp(self, node: ast.BinOp) -> ast.expr:
        self.generic_visit(node)
        match _chain(node):
            case [(_, p), (ast.Div(), ast.Constant() as q), (ast.Mult(), first), *rest]:
                match p:
                    case ast.Constant(value=1):
                        leading = [first]
                    case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=1)):
                        leading = [ast.UnaryOp(ast.USub(), first)]
                    case _:
                        leading = [p, first]
                numerator = [(ast.Mult(), factor) for factor in leading]
                return _product([*numerator, *rest, (ast.Div(), q)])
            case [one, (ast.Div(), ast.Constant()) as divisor, *rest] if rest:
                return _product([one, *rest, divisor])
        return node


_Factor = tuple[ast.operator, ast.expr]


def _chain(node: ast.expr) -> list[_Factor]:
    """a·b/c as [(·, a), (·, b), (/, c)]."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Mult, ast.Div)):
        return [*_chain(node.left), (node.op, node.right)]
    return [(ast.Mult(), node)]


def _product(factors: list[_Factor]) -> ast.expr:
    (_, product), *rest = factors
    for operator, factor in rest:
        product = ast.BinOp(product, operator, factor)
    return product
