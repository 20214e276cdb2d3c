"""Expressions as text: how SymPy's printers write them here, and functions of Python.

What several values share is computed once, each on a line of its own.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Sequence

import sympy
from sympy import Expr, Pow, Symbol
from sympy.printing.codeprinter import CodePrinter
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.pycode import PythonCodePrinter

from rigidtop.codegen.lines import StraightLine

WIDTH = 100
INDENT = "    "


class Printer(CodePrinter):
    """A quotient with one stroke, numbers in front: a*b/2 for (1.0/2.0)*a*b.

    So no fraction of two integers stands alone, which Python would round before a symbol meets it.
    """

    times, over = "*", "/"
    powers_as_products = False

    def text(self, expression: Expr) -> str:
        """An expression as source text, on one line."""
        self._not_supported: set[Expr] = set()
        self._number_symbols: set[Expr] = set()
        text = str(self._print(expression))
        unknown = self._not_supported | self._number_symbols
        if unknown:
            raise ValueError(f"{type(self).__name__} has no words for {expression}")
        return text

    def _print_Mul(self, expr: Expr) -> str:
        number, rest = expr.as_coeff_Mul()
        if not number.is_Rational:
            number, rest = sympy.S.One, expr
        above, below = [], []
        for factor in (
            sympy.Mul.make_args(rest) if self.order == "none" else rest.as_ordered_factors()
        ):
            if factor.is_Pow and factor.exp.is_Rational and factor.exp < 0:
                below += self._factors(Pow(factor.base, -factor.exp))
            elif factor != 1:
                above += self._factors(factor)
        if abs(number.p) != 1 or not above:
            above = [str(abs(number.p)), *above]
        if number.q != 1:
            below = [str(number.q), *below]
        sign = "-" if number < 0 else ""
        if not below:
            return sign + self._product(above)
        under = below[0] if len(below) == 1 else f"({self._product(below)})"
        stroke = "/" if under.isdigit() else self.over
        return f"{sign}{self._product(above)}{stroke}{under}"

    def _factors(self, factor: Expr) -> list[str]:
        if self._is_small_power(factor):
            return [self.parenthesize(factor.base, PRECEDENCE["Mul"])] * int(factor.exp)
        return [self.parenthesize(factor, PRECEDENCE["Mul"])]

    def _is_small_power(self, factor: Expr) -> bool:
        whole = self.powers_as_products and factor.is_Pow and factor.exp.is_Integer
        return bool(whole and 2 <= factor.exp <= 4)

    def _product(self, factors: Sequence[str]) -> str:
        first, *others = factors
        times = "*" if first.isdigit() else self.times
        return times.join([first, self.times.join(others)]) if others else first

    def _print_Pow(self, expr: Expr) -> str:
        if expr.exp.is_Rational and expr.exp < 0:
            return self._print_Mul(expr)
        if self._is_small_power(expr):
            return self._product(self._factors(expr))
        return str(super()._print_Pow(expr))


class Python(Printer, PythonCodePrinter):
    """Functions as `math` names them; one that nobody knows keeps its name."""

    def __init__(self, sorts: bool = True) -> None:
        defaults = {"fully_qualified_modules": False, "allow_unknown_functions": True}
        super().__init__(defaults | {"order": None if sorts else "none"})


_BREAKS = re.compile(r"(?<= [-+] )|(?<=, )|(?<=[\w)][*/])(?=[\w(])|(?<=\.[*/])")


def broken(line: str, more: str = "", width: int = WIDTH) -> list[str]:
    """A long line, broken behind operators and commas; `more` says that it goes on."""
    indent = " " * (len(line) - len(line.lstrip()) + 4)
    lines = [""]
    for piece in _BREAKS.split(line):
        if lines[-1].strip() and len(lines[-1]) + len(piece.rstrip()) + len(more) > width:
            lines[-1] = lines[-1].rstrip() + more
            lines.append(indent)
        lines[-1] += piece
    return [part.rstrip() for part in lines]


def signature(name: str, parameters: Sequence[str], returns: str = "") -> list[str]:
    """The line ``def name(parameters):``, broken where it is too long."""
    line = f"def {name}({', '.join(parameters)}){f' -> {returns}' * bool(returns)}:"
    first, *others = broken(line, width=WIDTH - len(INDENT))
    return [first, *(INDENT + other for other in others)]


def assignments(
    pairs: Sequence[tuple[Symbol, Expr]], depth: int = 1, sorts: bool = True
) -> list[str]:
    """``x0 = sin(theta)`` and so on, indented `depth` times."""
    lines: list[str] = []
    printer = Python(sorts)
    for name, value in pairs:
        line = f"{INDENT * depth}{name} = {printer.text(value)}"
        lines += [line] if len(line) <= WIDTH else broken(line.replace(" = ", " = (", 1) + ")")
    return lines


def body(program: StraightLine, depth: int = 1, sorts: bool = True) -> list[str]:
    """The statements of a function that returns the results as a tuple, indented `depth` times.

    Sums and products are sorted, to be read, or stand as they are, which is quicker.
    """
    lines = [*assignments(program.shared, depth, sorts), INDENT * depth + "return ("]
    printer = Python(sorts)
    for value in program.results:
        lines += broken(f"{INDENT * (depth + 1)}{printer.text(value)},")
    return [*lines, INDENT * depth + ")"]


def operations(tree: ast.AST) -> int:
    """How many sums, products, powers, signs and function calls one evaluation takes."""
    counted = (ast.BinOp, ast.UnaryOp, ast.Call)
    return sum(isinstance(node, counted) for node in ast.walk(tree))


def names_called(definition: ast.FunctionDef) -> set[str]:
    """The functions, such as sin, that a definition calls."""
    calls = (node.func for node in ast.walk(definition) if isinstance(node, ast.Call))
    return {called.id for called in calls if isinstance(called, ast.Name)}
