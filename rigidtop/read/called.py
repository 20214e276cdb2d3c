"""Functions in a formula: what they are of, with brackets or without."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import sympy
from lark import Token as Lexeme
from lark.visitors import Transformer_NonRecursive
from sympy import Expr, Mul, Symbol

from rigidtop.notation import Notation
from rigidtop.proof import equation as eq
from rigidtop.read import values as v
from rigidtop.read.cursor import Token
from rigidtop.read.tex import UnreadError
from rigidtop.read.values import Value, built, is_open

_FUNCTIONS: dict[str, Any] = {
    **{
        name: getattr(sympy, name)
        for name in ["sin", "cos", "tan", "exp", "log", "sinh", "cosh", "tanh"]
    },
    **{name: getattr(sympy, name) for name in ["cot", "sec", "csc", "coth"]},
    **{f"arc{name}": getattr(sympy, f"a{name}") for name in ("sin", "cos", "tan")},
    "K": sympy.elliptic_k,
    "F": sympy.elliptic_f,
}
_OF_ANGLES = frozenset({"sin", "cos", "tan"})
NAMED = frozenset({"det", "tr"})
"""Functions of a matrix that are symbols: det O."""
_ANGLES = frozenset({"rad", "1", ""})
_RATES = frozenset({"rad/s", "1/s"})

Items = list[Any]
"""What Lark hands to a rule: tokens, and what other rules made of theirs."""


class Functions(Transformer_NonRecursive[Lexeme, Any]):
    """The rules of the grammar for functions; one method a rule."""

    def __init__(self, notation: Notation) -> None:
        super().__init__()
        self.notation = notation

    def __default_token__(self, token: Lexeme) -> Token:
        value: Token = token.value
        return value

    def exponential(self, items: Items) -> Value:
        return self._call("exp", items[0], [items[1].closed])

    def applied(self, items: Items) -> Value:
        arguments = [item.closed for item in items if isinstance(item, Value)]
        return self._call(items[0].value, items[0], arguments)

    def applied_power(self, items: Items) -> Value:
        made = self._call(items[0].value, items[0], [items[4].closed])
        return self._raised(made, items[2].closed)

    def bare(self, items: Items) -> Value:
        return self._bare(items[0], items[1], lambda made: made)

    def bare_power(self, items: Items) -> Value:
        exponent = items[2].closed
        return self._bare(items[0], items[3], lambda made: self._raised(made, exponent))

    def _raised(self, made: Value, exponent: Value) -> Value:
        if exponent.tree == -1 or isinstance(exponent.tree, Mul):
            raise UnreadError(
                "a negative power of a function: the inverse function, or one over it?",
                exponent.position,
            )
        return v.power(made, exponent)

    def _bare(self, name: Token, argument: Value, raised: Callable[[Value], Value]) -> Value:
        """A function without brackets: of an angle, or of a rate that the time may follow."""
        symbol = v.last_of(argument.tree)
        unit = v.unit_of(symbol) if isinstance(symbol, Symbol) else "1"
        if self.notation.open and is_open(symbol) and not v.is_angle(symbol):
            unit = "rad/s"  # or of what it may be: the time may follow
        if unit not in _ANGLES | _RATES and name.value in _OF_ANGLES:
            raise UnreadError(
                f"{name.value} of what is no angle ({unit}): put brackets round all that it is of",
                argument.position,
            )
        if unit not in _RATES:
            return replace(raised(self._call(name.value, name, [argument.closed])), bare=True)

        def call(inside: Expr) -> Expr:
            return raised(self._call(name.value, name, [replace(argument, tree=inside)])).tree

        made = raised(self._call(name.value, name, [argument]))
        return replace(made, tree=argument.tree, pending=call, bare=True)

    def _call(self, name: str, at: Token, arguments: list[Value]) -> Value:
        if name in NAMED and len(arguments) == 1:
            return self._of_matrix(name, at, arguments[0])
        if name not in _FUNCTIONS:
            raise UnreadError(f"the function {name} is not known", at.position)
        function = _FUNCTIONS[name]
        if len(arguments) not in function.nargs:
            raise UnreadError(f"{name} of {len(arguments)} arguments", at.position)
        for argument in arguments:
            if argument.kind != "scalar":
                raise UnreadError(f"{name} of a {argument.kind}", argument.position)
        trees = [
            part.tree.args[0] if isinstance(part.tree, eq.Group) else part.tree
            for part in arguments
        ]
        if name == "log" and trees == [0]:
            raise UnreadError("the logarithm of 0", at.position)
        digits = 10 * arguments[0].digits if name == "exp" else 0
        tree = function(*trees, evaluate=False)
        return built(tree, "scalar", *arguments, digits=digits, position=at.position)

    def _of_matrix(self, name: str, at: Token, argument: Value) -> Value:
        tree = argument.tree
        inside = tree.args[0] if isinstance(tree, eq.Group) else tree
        if isinstance(inside, Symbol) and inside in self.notation.glyphs:
            letter = self.notation.glyphs[inside].base
            for symbol, glyph in self.notation.glyphs.items():
                if glyph.base == f"{name} {letter}":
                    return Value(symbol, "scalar", at.position)
        raise UnreadError(f"{name} of what has no name for it", at.position)
