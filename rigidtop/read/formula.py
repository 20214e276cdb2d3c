"""Formulas in LaTeX become equations.

>>> from rigidtop.present.text import text
>>> [line] = read(r"\\lambda_1\\cos\\theta\\,\\Omega^2 - \\lambda_3\\omega_3\\Omega = -MgR \\tag{3.57}")
>>> text(line.equation), line.tag
('λ₁ cos θ Ω² − λ₃ω₃Ω = −MgR', '3.57')
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache
from importlib.resources import files
from typing import Any

import sympy
from lark import Lark, Transformer, UnexpectedInput
from lark import Token as Lexeme
from lark.exceptions import VisitError
from lark.lexer import Lexer
from sympy import Add, Integer, Mul, Pow, Rational, Symbol

from rigidtop.notation import MATRICES, NOTES, Notation
from rigidtop.proof import equation as eq
from rigidtop.proof.equation import Equation
from rigidtop.read.scan import Token, UnreadError, tokens
from rigidtop.theory import symbols as s


@dataclass(frozen=True)
class Line:
    """An equation that was read, or why it was not.

    `position` is where it begins in the text; `follows` says that ⇒ stands before it.
    """

    position: int
    equation: Equation | None
    problem: str = ""
    follows: bool = False

    @property
    def tag(self) -> str:
        """The equation's number."""
        return self.equation.tag if self.equation is not None else ""


def read(text: str, notation: Notation = NOTES) -> tuple[Line, ...]:
    """The equations of a formula, in order, each read or with the reason why not.

    Text from strangers is welcome: nothing of it is evaluated, and its size and depth are limited.
    """
    try:
        found = tokens(text, notation)
    except UnreadError as error:
        return (Line(error.position, None, error.reason),)
    return tuple(line for part in _parts(found) for line in _read(part, notation))


# --- Lines ---------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Part:
    """The tokens of one equation."""

    tokens: tuple[Token, ...]
    tag: str = ""
    follows: bool = False


_GOES_ON = frozenset({"RELATION", "SIGN", "CROSS", "DOT", "SLASH"})
"""A line that begins with one of these, or whose last line ended with one, goes on."""


def _parts(found: Sequence[Token]) -> list[_Part]:
    """Tokens cut at separators and at ends of lines, tags taken out."""
    parts: list[_Part] = []
    current: list[Token] = []
    nested = follows = 0

    def close() -> None:
        nonlocal current, follows
        kept = [t for t in current if t.kind not in ("TAG", "ARROW")]
        tags = [t.value for t in current if t.kind == "TAG"] + _bracketed(kept)
        arrow = any(t.kind == "ARROW" for t in current)
        if tags and parts and _bracketed(kept):  # its number stands behind a comma
            parts[-1] = replace(parts[-1], tag=tags[-1])
        elif kept:
            begins = bool(current) and current[0].kind == "ARROW"
            parts.append(_Part(tuple(kept), tags[-1] if tags else "", bool(follows) or begins))
            follows = int(arrow and not begins)
        elif arrow:
            follows = 1
        current = []

    for i, token in enumerate(found):
        nested += {"MATRIX": 1, "XIRTAM": -1}.get(token.kind, 0)
        if token.kind == "LINE" and not nested:
            ahead = found[i + 1].kind if i + 1 < len(found) else ""
            behind = current[-1].kind if current else ""
            if ahead not in _GOES_ON and behind not in _GOES_ON:
                close()
        elif token.kind == "SEPARATOR":
            close()
        else:
            current.append(token)
    close()
    return parts


def _bracketed(part: Sequence[Token]) -> list[str]:
    """The number of an equation in brackets, if that is all there is."""
    if [t.kind for t in part] == ["OPEN", "NUMBER", "CLOSE"]:
        return [part[1].value]
    return []


def _read(part: _Part, notation: Notation) -> list[Line]:
    """One line, or two where the relation changes in a chain."""
    position = part.tokens[0].position
    try:
        sides, relations = _parsed(part.tokens, notation)
    except UnreadError as error:
        return [Line(error.position, None, error.reason, part.follows)]
    if not relations:
        return [Line(position, None, "no relation: an equation has two sides", part.follows)]
    if set(relations) == {"=", "≡"}:  # p_φ ≡ … = const is one statement
        relations = ["="] * len(relations)
    lines = []
    start = 0
    for i in range(1, len(relations) + 1):
        if i == len(relations) or relations[i] != relations[start]:
            tag = part.tag if i == len(relations) else ""
            equation = Equation(*sides[start : i + 1], relation=relations[start], tag=tag)
            lines.append(Line(position, equation, follows=part.follows))
            start = i
    return lines


# --- Expressions ---------------------------------------------------------------------------------


class _Tokens(Lexer):
    """Lark takes our tokens as they are."""

    def __init__(self, _: Any) -> None:
        pass

    def lex(self, data: Any) -> Iterator[Lexeme]:  # type: ignore[override]
        for token in data:
            yield Lexeme(token.kind, token, start_pos=token.position)


@cache
def _grammar() -> Lark:
    text = files(__package__).joinpath("formula.lark").read_text("utf-8")
    return Lark(text, parser="lalr", lexer=_Tokens)


_SAID = {
    "POWER": "a power here could belong to the function or to its argument: put brackets",
    "$END": "the formula ends too early",
}


def _parsed(found: Sequence[Token], notation: Notation) -> tuple[list[Any], list[str]]:
    """Sides and the relations between them."""
    try:
        tree = _grammar().parse(found)
    except UnexpectedInput as error:
        lexeme = getattr(error, "token", None)
        kind = lexeme.type if lexeme is not None else "$END"
        if lexeme is None or not isinstance(lexeme.value, Token):
            raise UnreadError(_SAID["$END"], found[-1].position) from None
        token = lexeme.value
        raise UnreadError(
            _SAID.get(kind, f"{token.value} is out of place"), token.position
        ) from None
    with eq.as_printed():
        try:
            return _Builder(notation).transform(tree)
        except VisitError as error:
            if isinstance(error.orig_exc, UnreadError):
                raise UnreadError(error.orig_exc.reason, found[0].position) from None
            raise


def kind(node: Any) -> str:
    """ "scalar", "vector" or "matrix"."""
    if isinstance(node, sympy.MatrixBase):
        return "vector" if 1 in node.shape else "matrix"
    if isinstance(node, Symbol):
        if node in MATRICES:
            return "matrix"
        quantity = s.VOCABULARY.get(node)
        return "vector" if quantity is not None and quantity.glyph.bold else "scalar"
    if isinstance(node, eq.Cross):
        return "vector"
    if isinstance(node, (eq.Group, eq.Underbrace, eq.Rate, eq.Transposed)):
        return kind(node.args[0])
    if isinstance(node, (eq.SumOver, eq.VolumeIntegral)):
        return kind(node.args[1])
    if isinstance(node, (Add, Mul)):
        kinds = [kind(argument) for argument in node.args]
        return next((k for k in ("vector", "matrix") if k in kinds), "scalar")
    if isinstance(node, Pow):
        return kind(node.base)
    return "scalar"


_INDEPENDENT = {"sin": sympy.sin, "cos": sympy.cos, "tan": sympy.tan, "exp": sympy.exp}
_FUNCTIONS: dict[str, Any] = {
    **_INDEPENDENT,
    "log": sympy.log,
    "arcsin": sympy.asin,
    "arccos": sympy.acos,
    "arctan": sympy.atan,
    "sinh": sympy.sinh,
    "cosh": sympy.cosh,
    "tanh": sympy.tanh,
    "K": sympy.elliptic_k,
    "F": sympy.elliptic_f,
}
_FRAMES = {"space": eq.SPACE, "body": eq.BODY}
_ANGLES = frozenset({"rad", "1", ""})
_RATES = frozenset({"rad/s", "1/s"})


class _Builder(Transformer):
    """The tree of the grammar as the tree of an equation; one method a rule."""

    def __init__(self, notation: Notation) -> None:
        super().__init__()
        self.notation = notation

    def __default_token__(self, token: Lexeme) -> Any:
        return token

    def start(self, items: list[Any]) -> tuple[list[Any], list[str]]:
        sides = [item for item in items if not isinstance(item, Lexeme)]
        relations = [item.value.value for item in items if isinstance(item, Lexeme)]
        kinds = {kind(side) for side in sides}
        if "matrix" in kinds:
            sides = [s.unit if side == 1 else side for side in sides]
        return sides, relations

    # Sums and products

    def signed(self, items: list[Any]) -> Any:
        sign, term = items
        return _times(Integer(-1), term) if sign.value.value == "-" else term

    def added(self, items: list[Any]) -> Any:
        total, sign, term = items
        if "matrix" in (kind(total), kind(term)):
            total, term = (s.unit if side == 1 else side for side in (total, term))
        if kind(total) != kind(term) and 0 not in (total, term):
            raise UnreadError(f"a {kind(total)} and a {kind(term)} are added", 0)
        if sign.value.value == "-":
            term = _times(Integer(-1), term)
        if isinstance(total, sympy.MatrixBase) and isinstance(term, sympy.MatrixBase):
            return total + term
        return Add(total, term, evaluate=False)

    def product(self, items: list[Any]) -> Any:
        factors = self._of_time(items)
        if sum(kind(factor) == "vector" for factor in factors) > 1:
            raise UnreadError("two vectors side by side: · or × between them?", 0)
        if any(isinstance(factor, sympy.MatrixBase) for factor in factors):
            made = factors[0]
            for factor in factors[1:]:
                made = made * factor
            return made
        return Mul(*factors, evaluate=False)

    def _of_time(self, factors: list[Any]) -> list[Any]:
        """sin Ωt is the sine of an angle: a rate in a function takes the time behind it along."""
        made: list[Any] = []
        for factor in factors:
            last = made[-1] if made else None
            if factor == s.t and isinstance(last, _Pending):
                made[-1] = last.function(_times(last.rate, s.t))
                continue
            made.append(factor)
        return [_closed(factor) for factor in made]

    def cross(self, items: list[Any]) -> Any:
        left, _, right = items
        if kind(left) == kind(right) == "vector":
            return eq.Cross(left, right)
        if left.is_Number and right.is_Number:
            return Mul(left, right, evaluate=False)
        raise UnreadError(f"× between a {kind(left)} and a {kind(right)}", 0)

    def dot(self, items: list[Any]) -> Any:
        left, _, right = items
        if kind(left) == kind(right) == "vector":
            return eq.Dot(left, right)
        if "vector" in (kind(left), kind(right)):
            raise UnreadError(f"· between a {kind(left)} and a {kind(right)}", 0)
        return Mul(left, right, evaluate=False)

    def over(self, items: list[Any]) -> Any:
        left, _, right = items
        if isinstance(right, Mul):
            raise UnreadError("what follows the / could stand above or below it: put brackets", 0)
        return _ratio(left, right)

    def summed(self, items: list[Any]) -> Any:
        return eq.SumOver(Symbol(items[1].value.value), items[2])

    def integrated(self, items: list[Any]) -> Any:
        return eq.VolumeIntegral(Symbol("d3r"), items[1])

    # Factors

    def power(self, items: list[Any]) -> Any:
        base, _, exponent = items
        if kind(base) == "vector":
            return Pow(eq.Dot(base, base), Rational(1, 2) * exponent)
        return Pow(base, exponent, evaluate=False)

    def transposed(self, items: list[Any]) -> Any:
        base = items[0]
        if isinstance(base, sympy.MatrixBase):
            return base.T
        return eq.Transposed(base)

    def symbol(self, items: list[Any]) -> Any:
        return items[0].value.value

    def number(self, items: list[Any]) -> Any:
        return Rational(items[0].value.value)

    def constant(self, items: list[Any]) -> Any:
        return s.const

    def brackets(self, items: list[Any]) -> Any:
        return eq.Group(items[1]) if not isinstance(items[1], sympy.MatrixBase) else items[1]

    def listed(self, items: list[Any]) -> Any:
        entries = [item for item in items if not isinstance(item, Lexeme)]
        return sympy.Matrix([entries]) if len(entries) > 1 else eq.Group(entries[0])

    def matrix(self, items: list[Any]) -> Any:
        rows = [item for item in items if not isinstance(item, Lexeme)]
        if len({len(row) for row in rows}) > 1:
            raise UnreadError("a matrix with rows of different lengths", 0)
        return sympy.Matrix(rows)

    def row(self, items: list[Any]) -> list[Any]:
        return [item for item in items if not isinstance(item, Lexeme)]

    def fraction(self, items: list[Any]) -> Any:
        return _ratio(items[1], items[2])

    def root(self, items: list[Any]) -> Any:
        return Pow(items[1], Rational(1, 2), evaluate=False)

    def size(self, items: list[Any]) -> Any:
        inside = items[1]
        if kind(inside) == "vector":
            return Pow(eq.Dot(inside, inside), Rational(1, 2), evaluate=False)
        return sympy.Abs(inside, evaluate=False)

    def brace(self, items: list[Any]) -> Any:
        return eq.Underbrace(items[1], items[2])

    def rate(self, items: list[Any]) -> Any:
        what = items[1]
        if isinstance(what, Symbol):
            dotted = self._dotted(what)
            return dotted if dotted is not None else eq.Rate(what)
        return eq.Rate(what)

    def _dotted(self, symbol: Symbol) -> Symbol | None:
        glyph = self.notation.glyphs[symbol]
        if glyph.accent == "":
            return self.notation.names.get(replace(glyph, accent="dot"))
        if glyph.accent == "dot":
            return self.notation.names.get(replace(glyph, accent="ddot"))
        return None

    def rate_of(self, items: list[Any]) -> Any:
        return eq.Rate(items[2])

    def rate_in(self, items: list[Any]) -> Any:
        frame = items[4].value.value
        if frame not in _FRAMES:
            raise UnreadError(
                f"a rate as seen from {frame!r}: space or body", items[4].value.position
            )
        return eq.Rate(items[2], _FRAMES[frame])

    def rate_in_brackets(self, items: list[Any]) -> Any:
        nodes = [item for item in items if not isinstance(item, Lexeme)]
        signs = [i for i in items if isinstance(i, Lexeme) and i.type == "SIGN"]
        made = self.rate([None, nodes[0]])
        return eq.Group(
            _times(Integer(-1), made) if signs and signs[0].value.value == "-" else made
        )

    # Functions

    def function(self, items: list[Any]) -> Any:
        return items[0]

    def multiple(self, items: list[Any]) -> Any:
        return _times(Rational(items[0].value.value), items[1].value.value)

    def applied(self, items: list[Any]) -> Any:
        return self._applied(items[0], items[1], None)

    def applied_power(self, items: list[Any]) -> Any:
        return self._applied(items[0], items[3], items[2])

    def applied_to_many(self, items: list[Any]) -> Any:
        arguments = [item for item in items if not isinstance(item, Lexeme)]
        return self._named(items[0])(*arguments, evaluate=False)

    def _applied(self, lexeme: Lexeme, argument: Any, exponent: Any) -> Any:
        name = lexeme.value.value
        if name == "det":
            return self._determinant(argument)
        function = self._named(lexeme)

        def call(inside: Any) -> Any:
            made = function(inside, evaluate=False)
            return made if exponent is None else Pow(made, exponent, evaluate=False)

        if isinstance(argument, eq.Group):
            argument = argument.args[0]
        if isinstance(argument, Symbol) and _unit(argument) in _RATES:
            return _Pending(call, argument)
        return call(argument)

    def _named(self, lexeme: Lexeme) -> Any:
        name = lexeme.value.value
        if name not in _FUNCTIONS:
            raise UnreadError(f"the function {name} is not known", lexeme.value.position)
        return _FUNCTIONS[name]

    def _determinant(self, argument: Any) -> Any:
        inside = argument.args[0] if isinstance(argument, eq.Group) else argument
        if isinstance(inside, Symbol):
            letter = self.notation.glyphs[inside].base
            for symbol, glyph in self.notation.glyphs.items():
                if glyph.base == f"det {letter}":
                    return symbol
        raise UnreadError("the determinant of what has no name for it", 0)


@dataclass(frozen=True)
class _Pending:
    """A function of a rate, which makes sense only if the time follows."""

    function: Any
    rate: Any


def _closed(factor: Any) -> Any:
    return factor.function(factor.rate) if isinstance(factor, _Pending) else factor


def _unit(symbol: Symbol) -> str:
    quantity = s.VOCABULARY.get(symbol)
    return quantity.unit if quantity is not None else ""


def _times(left: Any, right: Any) -> Any:
    if isinstance(right, sympy.MatrixBase):
        return left * right
    return Mul(left, right, evaluate=False)


def _ratio(over: Any, below: Any) -> Any:
    if isinstance(over, Rational) and isinstance(below, Rational) and below != 0:
        return Rational(over, below)
    if kind(below) != "scalar":
        raise UnreadError(f"a division by a {kind(below)}", 0)
    return Mul(over, Pow(below, Integer(-1), evaluate=False), evaluate=False)
