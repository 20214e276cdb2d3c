"""Formulas in LaTeX become equations.

>>> from rigidtop.typeset.text import text
>>> [line] = read(r"\\lambda_1\\cos\\theta\\,\\Omega^2 = L_3\\Omega - MgR \\tag{3.57}")
>>> text(line.equation), line.tag
('λ₁ cos θ Ω² = L₃Ω − MgR', '3.57')
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache
from importlib.resources import files
from itertools import pairwise, takewhile
from typing import Any

import sympy
from lark import Lark, UnexpectedInput
from lark import Token as Lexeme
from lark.exceptions import VisitError
from lark.lexer import Lexer
from lark.visitors import Transformer_NonRecursive
from sympy import Add, Expr, Integer, MatrixBase, Mul, Pow, Rational, Symbol

from rigidtop.notation import MATRICES, NOTES, Notation
from rigidtop.notation.convention import own
from rigidtop.proof import equation as eq
from rigidtop.proof.equation import Equation
from rigidtop.read.habits import NO_HABITS, Habits
from rigidtop.read.macros import expanded
from rigidtop.read.scan import ANGLES, CONDITIONS, Scan, Token, limited, shown
from rigidtop.read.tex import UnreadError, pieces, words
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


@dataclass(frozen=True)
class Line:
    """An equation that was read, or why it was not.

    `position` is where it begins in the text, or where what can't be read stands; `follows` says
    that ⇒ stands before it; `tag` is the equation's number.
    """

    position: int
    equation: Equation | None
    problem: str = ""
    follows: bool = False
    tag: str = ""
    condition: str = ""
    """Words behind it, such as "for small angles", as they are written."""


def read(
    text: str,
    notation: Notation = NOTES,
    habits: Habits = NO_HABITS,
) -> tuple[Line, ...]:
    """The equations of a formula, in order, each read or with the reason why not.

    A notation that is `open` takes letters that it does not know, and any author's ways of writing.
    Text from strangers is welcome: nothing of it is evaluated, and its size and depth are limited.
    """
    try:
        found = scanned(text, notation, habits)
    except UnreadError as error:
        return (Line(error.position, None, error.reason),)
    lines = tuple(line for part in _parts(found, text) for line in _read(part, notation))
    if notation.open or habits.conditions:
        return lines
    return tuple(_unconditioned(line) for line in lines)


def _unconditioned(line: Line) -> Line:
    """A line without words behind it; one that has some is unread."""
    if not line.condition:
        return line
    reason = f"words inside a formula: {line.condition[:40]!r}"
    return Line(line.position, None, reason, line.follows, line.tag)


def scanned(text: str, notation: Notation, habits: Habits) -> list[Token]:
    """The tokens of a formula, its macros put in."""
    items = expanded(pieces(text), habits.macros)
    found = limited(Scan(items, notation, habits))
    here = _with(habits, found, text) if notation.open else habits
    return found if here == habits else limited(Scan(items, notation, here))


def with_habits(habits: Habits, text: str, notation: Notation) -> Habits:
    """What is known of an author's letters, with what one more formula says of them."""
    items = expanded(pieces(text), habits.macros)
    return _with(habits, limited(Scan(items, notation)), text)


def _with(habits: Habits, found: Sequence[Token], text: str) -> Habits:
    functions, timed = set(habits.functions), set(habits.timed)
    for i, token in enumerate(found):
        if not isinstance(token.value, Lettered):
            continue
        glyph = token.value.quantity.glyph
        behind = found[i + 1] if i + 1 < len(found) else Token("", "", len(text))
        if behind.kind == "OF":
            inside = takewhile(lambda token: token.kind != "FO", found[i + 2 :])
            among = [x.value for x in inside if isinstance(x.value, Lettered)]
            functions |= {(glyph, x.quantity.glyph.base) for x in among} or {(glyph, "")}
        if _OF_TIME.search(text, token.position, behind.position):
            timed.add(glyph)
    return replace(habits, functions=frozenset(functions), timed=frozenset(timed))


_OF_TIME = re.compile(r"\(\s*t\s*(?:\\right)?\)")


# --- Lines ---------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Part:
    """The tokens of one equation."""

    tokens: tuple[Token, ...]
    tag: str = ""
    follows: bool = False
    problem: UnreadError | None = None
    condition: str = ""

    @property
    def kinds(self) -> list[str]:
        return [token.kind for token in self.tokens]


_GOES_ON = frozenset({"RELATION", "SIGN", "SIGNS", "CROSS", "DOT", "SLASH"})
"""A line that begins with one of these, or whose last line ended with one, goes on."""

_BREAKS = frozenset({"LINE", "SEPARATOR", "ARROW"})
_BLANK = frozenset({"SPACE", "ALIGN"})
_OPENS = {"MATRIX": 1, "XIRTAM": -1, "OPEN": 1, "CLOSE": -1, "LIST": 1, "TSIL": -1}
_OPENS |= {"_BEGIN": 1, "_END": -1, "OF": 1, "FO": -1, "BAR": 1, "RAB": -1}


def _parts(found: Sequence[Token], text: str) -> list[_Part]:
    """Tokens cut at separators, at arrows and at ends of lines, tags taken out."""
    cutter = _Cutter(found, text)
    for i in range(len(found)):
        cutter.take(i)
    cutter.close()
    return cutter.parts


class _Cutter:
    """Goes through the tokens of some lines and cuts them into equations."""

    def __init__(self, found: Sequence[Token], text: str) -> None:
        self.found, self.text = found, text
        self.parts: list[_Part] = []
        self.current: list[Token] = []
        self.tag, self.follows, self.nested = "", False, 0
        self.problem: UnreadError | None = None
        self.ahead = _ahead(found)
        """For each token the kind of the next one that is not blank, and whether a relation
        stands between it and the next break."""

    def take(self, i: int) -> None:
        token = self.found[i]
        kind = token.kind
        self.nested += _OPENS.get(kind, 0)
        inside = self.nested > 0
        if self.condition is not None:
            if (inside or kind not in ("LINE", "ARROW", "TAG")) and token is not self.found[-1]:
                return
            whole = token is self.found[-1] and kind not in ("LINE", "ARROW", "TAG")
            self._conditioned(len(self.text) if whole else token.position)
            if whole:
                return
        if kind == "TAG":
            self.tag = token.value
        elif kind == "WORDS":
            if self.current and self.ahead[i][0] in _GOES_ON:
                reason = "words in the middle of a formula"
                self.current.append(Token("UNREAD", UnreadError(reason, token.position), 0))
                return
            self.close()
            if token.value.split()[0].lower() in CONDITIONS:
                self.condition = token.position
                if token is self.found[-1]:
                    self._conditioned(len(self.text))
        elif kind == "ARROW":
            self.close()
            self.follows = True
        elif kind == "SEPARATOR":
            if self._is_list(i):
                self.condition = self.current[0].position
                self.current = []
                if not self.parts:
                    reason = "a list of values: for which values something holds is no equation"
                    self.parts.append(_Part((token,), problem=UnreadError(reason, self.condition)))
                return
            self.close(stop=token.value)
        elif kind == "LINE" and not inside:
            self._line(i)
        elif kind in _BLANK:
            if not inside and not self._goes_on(i):
                self.close()
        else:
            self.current.append(token)

    def _goes_on(self, i: int) -> bool:
        behind = self.current[-1].kind if self.current else ""
        return behind in _GOES_ON or self.ahead[i][0] in _GOES_ON | {"TAG", ""}

    def _line(self, i: int) -> None:
        kind, related = self.ahead[i]
        if not self._goes_on(i) or kind == "TAG":
            self.close()
        elif kind == "SIGN" and related and self.current:
            # "a = b \\\\ -c &= d" begins anew, "a &= b \\\\ & - c = d" goes on.
            alignments = [
                token.kind
                for token in self.found[i + 1 : self._end(i + 1)]
                if token.kind != "SPACE"
            ]
            if alignments[0] == "ALIGN":
                return
            if "ALIGN" not in alignments:
                sign = next(t for t in self.found[i:] if t.kind == "SIGN")
                self.problem = UnreadError(
                    "a line that begins with a sign and has a relation of its own: put & before "
                    "the sign if it goes on, & before the relation if it begins anew",
                    sign.position,
                )
                return
            self.close()

    def _end(self, start: int) -> int:
        for i in range(start, len(self.found)):
            if self.found[i].kind in _BREAKS:
                return i
        return len(self.found)

    def close(self, stop: str = "") -> None:
        """What was taken so far is an equation."""
        kept, self.current = self.current, []
        unread = next((token.value for token in kept if token.kind == "UNREAD"), self.problem)
        part = _Part(tuple(kept), self.tag, self.follows, unread)
        number = _bracketed(kept)
        if self.parts and _is_range(kept):  # "(i = 1, 2)": for which i
            said = words(self.text[kept[0].position : kept[-1].position + 1])
            joint = ", ".join(filter(None, (self.parts[-1].condition, said)))
            self.parts[-1] = replace(self.parts[-1], condition=joint)
            kept = []
        if number and self.parts and not self.parts[-1].tag:  # it stands behind a comma or a space
            self.parts[-1] = replace(self.parts[-1], tag=number)
        elif kept and part.kinds == ["NUMBER"] and self.parts and self._listed:
            last = self.parts[-1]
            problem = UnreadError(
                "a list of values, or a decimal comma: write each equation out, with a full stop "
                "in numbers",
                last.tokens[0].position,
            )
            self.parts[-1] = replace(last, tag=self.tag or last.tag, problem=problem)
        elif kept:
            self.parts.append(part)
        elif self.tag and self.parts and not self.parts[-1].tag:
            self.parts[-1] = replace(self.parts[-1], tag=self.tag)
        if kept:
            self.tag, self.follows, self.problem = "", False, None
            self._listed = stop == "," and kept[-1].kind == "NUMBER"
        elif self.tag:
            self.tag = ""

    def _is_list(self, i: int) -> bool:
        """Whether values are listed: i = 1, 2, …, n behind the comma of which no relation comes."""
        kinds = [token.kind for token in self.current]
        if kinds not in (["SYMBOL", "RELATION", "NUMBER"], ["SYMBOL", "RELATION", "SYMBOL"]):
            return False
        commas = 0
        for token in self.found[i + 1 :]:
            if token.kind in ("LINE", "ARROW", "TAG", "WORDS"):
                break
            if token.kind in ("RELATION", "OPEN"):
                return False
            if token.value == _OMITTED:
                return True
            commas += token.kind == "SEPARATOR"
        return commas > 1

    condition: int | None = None
    """Where words stand, such as "if", that all up to the end of the line belong to."""

    def _conditioned(self, end: int) -> None:
        """What stands behind such words belongs to the equation in front, unread."""
        start, self.condition = self.condition, None
        if self.parts and not self.parts[-1].condition:
            said = words(self.text[start:end])
            self.parts[-1] = replace(self.parts[-1], condition=said)

    _listed = False
    """Whether the last part ended with a number and a comma."""


def _ahead(found: Sequence[Token]) -> list[tuple[str, bool]]:
    made: list[tuple[str, bool]] = []
    kind, related = "", False
    for token in reversed(found):
        made.append((kind, related))
        if token.kind not in _BLANK:
            kind = token.kind
        related = token.kind not in _BREAKS and (related or token.kind == "RELATION")
    return made[::-1]


def _is_range(part: Sequence[Token]) -> bool:
    """Whether a part stands in brackets with a relation of its own: it says where another holds."""
    kinds = [token.kind for token in part]
    return (
        len(kinds) > 4
        and kinds[0] in ("OPEN", "LIST")
        and kinds[-1] in ("CLOSE", "TSIL")
        and kinds[2] == "RELATION"
    )


def _bracketed(part: Sequence[Token]) -> str:
    """The number of an equation in brackets, if that is all there is."""
    plain = [t.kind for t in part] == ["OPEN", "NUMBER", "CLOSE"]
    return part[1].value if plain else ""


def _read(part: _Part, notation: Notation) -> list[Line]:
    """One line, more where a symbol has two indices, or where the relation changes in a chain."""
    try:
        if part.problem is not None:
            raise part.problem
        lines = [
            replace(line, condition=", ".join(filter(None, (condition, part.condition))))
            for chosen, condition in _choices(part.tokens)
            for line in _lines(chosen, notation)
        ]
    except UnreadError as error:
        return [Line(error.position, None, error.reason, part.follows, part.tag)]
    lines = [replace(line, follows=part.follows) for line in lines]
    if part.tag:
        last = lines[-1]
        assert last.equation is not None
        numbered = Equation(*last.equation.sides, relation=last.equation.relation, tag=part.tag)
        lines[-1] = replace(last, equation=numbered, tag=part.tag)
    return lines


def _choices(found: Sequence[Token]) -> list[tuple[list[Token], str]]:
    """ω_{1,2} = … are two equations, a = ±b too, and each of several cases with its condition."""
    several = [t for t in found if t.kind in _SEVERAL]
    if not several:
        return [(list(found), "")]
    counts = {len(t.value): t.position for t in several}
    if len(counts) > 1:
        raise UnreadError("lists of indices of different lengths", max(counts.values()))
    branches = sum(t.kind == "BRANCHES" for t in several)
    if branches and len(several) > 1:
        raise UnreadError("cases beside other choices", several[0].position)
    [count] = counts
    made = []
    for i in range(count):
        chosen: list[Token] = []
        for token in found:
            if token.kind == "BRANCHES":
                chosen += token.value[i][0]
            elif token.kind in _SEVERAL:
                chosen.append(Token(_SEVERAL[token.kind], token.value[i], token.position))
            else:
                chosen.append(token)
        made.append((chosen, several[0].value[i][1] if branches else ""))
    return made


_SEVERAL = {"CHOICE": "SYMBOL", "SIGNS": "SIGN", "BRANCHES": ""}


_OMITTED = own(Glyph("…"))
"""Dots for what is left out: a number or a vector, as need be."""

_WRITTEN_OUT = frozenset({"TRANSPOSED", "MATRIX"})


def _is_vector(token: Token) -> bool:
    return token.kind == "SYMBOL" and kind(token.value) == "vector"


def _of_its_kind(found: Sequence[Token]) -> list[Token]:
    """A is an amplitude, beside matrices and in front of a vector a matrix."""
    among = {t.value for t in found if t.kind == "SYMBOL"}
    named = any(t.kind == "FUNCTION" and t.value in _NAMED for t in found)
    acts = any(t.value == s.A and _is_vector(behind) for t, behind in pairwise(found))
    if not (acts or named or among & MATRICES or any(t.kind in _WRITTEN_OUT for t in found)):
        return list(found)
    return [replace(t, value=s.A_matrix) if t.value == s.A else t for t in found]


def _lines(found: Sequence[Token], notation: Notation) -> list[Line]:
    position = found[0].position
    sides, relations = _parsed(_of_its_kind(found), notation)
    if not relations:
        raise UnreadError("no relation: an equation has two sides", position)
    if set(relations) == {"=", "≡"}:  # p_φ ≡ … = const is one statement
        relations = ["="] * len(relations)
    lines = []
    start = 0
    for i in range(1, len(relations) + 1):
        if i == len(relations) or relations[i] != relations[start]:
            equation = Equation(*sides[start : i + 1], relation=relations[start])
            lines.append(Line(position, equation))
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
    "RELATION": "a relation where an expression goes on: close the brackets before it",
    "FRAME": "an index behind brackets",
    "LINE": "an end of the line where an expression goes on",
    "_END": "something is missing here",
}


def _parsed(found: Sequence[Token], notation: Notation) -> tuple[list[Any], list[str]]:
    """Sides and the relations between them."""
    try:
        tree = _grammar().parse(found)
    except UnexpectedInput as error:
        lexeme = getattr(error, "token", None)
        if lexeme is None or not isinstance(lexeme.value, Token):
            raise UnreadError("the formula ends too early", found[-1].position) from None
        token = lexeme.value
        if token is found[0] and token.kind == "RELATION":
            raise UnreadError("a relation without its left side", token.position) from None
        reason = _SAID.get(token.kind, f"{shown(token, notation)} is out of place")
        raise UnreadError(reason, token.position) from None
    try:
        made: tuple[list[Any], list[str]] = _Builder(notation).transform(tree)
        return made
    except VisitError as error:
        if isinstance(error.orig_exc, UnreadError):
            raise error.orig_exc from None
        raise UnreadError("this has no meaning", found[0].position) from None


def kind(node: Expr) -> str:
    """ "scalar", "vector" or "matrix"."""
    if isinstance(node, sympy.MatrixBase):
        return "vector" if 1 in node.shape else "matrix"
    if isinstance(node, Symbol):
        if node in MATRICES:
            return "matrix"
        _, quantity = known(node)
        return "vector" if quantity is not None and quantity.glyph.bold else "scalar"
    if isinstance(node, eq.Cross):
        return "vector"
    if isinstance(node, eq.Matrices):
        return kind(node.args[-1])
    if isinstance(node, (eq.Group, eq.Underbrace, eq.Rate, eq.Transposed)):
        return kind(node.args[0])
    if isinstance(node, (eq.SumOver, eq.VolumeIntegral)):
        return kind(node.args[1])
    if isinstance(node, eq.IntegralOver):
        return kind(node.args[3])
    if isinstance(node, eq.SumFrom):
        return kind(node.args[3])
    if isinstance(node, (eq.At, eq.Slope, eq.Partial, eq.Evaluated, eq.Integrated)):
        return kind(node.args[0])
    if isinstance(node, (Add, Mul)):
        kinds = [kind(argument) for argument in node.args]
        return next((k for k in ("vector", "matrix") if k in kinds), "scalar")
    if isinstance(node, Pow):
        return kind(node.base)
    return "scalar"


_FUNCTIONS: dict[str, Any] = {
    "sin": sympy.sin,
    "cos": sympy.cos,
    "tan": sympy.tan,
    "exp": sympy.exp,
    "log": sympy.log,
    "arcsin": sympy.asin,
    "arccos": sympy.acos,
    "arctan": sympy.atan,
    "sinh": sympy.sinh,
    "cosh": sympy.cosh,
    "tanh": sympy.tanh,
    "cot": sympy.cot,
    "sec": sympy.sec,
    "csc": sympy.csc,
    "coth": sympy.coth,
    "K": sympy.elliptic_k,
    "F": sympy.elliptic_f,
}
_OF_ANGLES = frozenset({"sin", "cos", "tan"})
_NAMED = frozenset({"det", "tr"})
"""Functions of a matrix that are symbols: det O."""
_FRAMES = {"space": eq.SPACE, "body": eq.BODY}
_ANGLES = frozenset({"rad", "1", ""})
_RATES = frozenset({"rad/s", "1/s"})


@dataclass(frozen=True)
class _Value:
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
    def closed(self) -> _Value:
        if self.pending is None:
            return self
        return replace(self, tree=self.pending(self.tree), pending=None, depth=self.depth + 1)

    @property
    def explicit(self) -> bool:
        """Whether it is a matrix or column with its entries."""
        return isinstance(self.tree, sympy.MatrixBase)


def _made(tree: Expr, kind: str, *parts: _Value, **known: Any) -> _Value:
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
    return _Value(tree, kind, position, depth, **known)


class _Builder(Transformer_NonRecursive[Lexeme, Any]):
    """The tree of the grammar as the tree of an equation; one method a rule."""

    def __init__(self, notation: Notation) -> None:
        super().__init__()
        self.notation = notation
        self.differentials: dict[Any, tuple[int, Any]] = {}
        """Of dx, d³r: the order, and the letter."""

    def __default_token__(self, token: Lexeme) -> Token:
        value: Token = token.value
        return value

    def start(self, items: list[Any]) -> tuple[list[Any], list[str]]:
        sides = [item.closed for item in items if isinstance(item, _Value)]
        relations = [item.value for item in items if isinstance(item, Token)]
        kinds = {side.kind for side in sides}
        if "matrix" in kinds:
            sides = [_as_matrix(side) for side in sides]
        for before, side in pairwise(sides):
            free = (0, s.const, _OMITTED)
            if self.notation.open and before.explicit != side.explicit:
                continue  # a letter that is equal to a matrix is one
            if before.kind != side.kind and before.tree not in free and side.tree not in free:
                raise UnreadError(
                    f"a {before.kind} and a {side.kind} are compared: is a symbol meant in bold?",
                    side.position,
                )
        return [side.tree for side in sides], relations

    # Sums and products

    def signed(self, items: list[Any]) -> _Value:
        sign, term = items
        made = _negative(term.closed) if sign.value == "-" else term.closed
        return replace(made, position=sign.position)

    def added(self, items: list[Any]) -> _Value:
        total, sign, term = items[0].closed, items[1], items[2].closed
        if "matrix" in (total.kind, term.kind):
            total, term = _as_matrix(total), _as_matrix(term)
        wild = (0, _OMITTED)
        if self.notation.open and (total.explicit or term.explicit):
            return self._added_typed(total, sign, term)
        if total.kind != term.kind and total.tree not in wild and term.tree not in wild:
            raise UnreadError(f"a {total.kind} and a {term.kind} are added", term.position)
        if sign.value == "-":
            term = _negative(term)
        digits = max(total.digits, term.digits) + 1
        if total.explicit or term.explicit:
            return _made(self._sum(total, term), total.kind, total, term, digits=digits)
        return _made(
            Add(total.tree, term.tree, evaluate=False), total.kind, total, term, digits=digits
        )

    def _added_typed(self, total: _Value, sign: Token, term: _Value) -> _Value:
        """A sum with matrices that are written out, as it is typed."""
        trees = [
            eq.Matrices(part.tree.as_immutable()) if part.explicit else part.tree
            for part in (total, term)
        ]
        if sign.value == "-":
            trees[1] = Mul(Integer(-1), trees[1], evaluate=False)
        shape = total if total.explicit else term
        return _made(Add(*trees, evaluate=False), shape.kind, total, term)

    def _sum(self, total: _Value, term: _Value) -> Any:
        if not (total.explicit and term.explicit and total.tree.shape == term.tree.shape):
            raise UnreadError("what is added is not of the same shape", term.position)
        return total.tree + term.tree

    def product(self, items: list[Any]) -> _Value:
        if self.notation.open:
            _definite(items)
        factors = self._of_time(items)
        vectors = [factor for factor in factors if factor.kind == "vector"]
        form = False
        if self.notation.open:
            vectors = [x for x in vectors if not _may_be_tensor(x.tree)] or vectors[:1]
            form = len(vectors) == 2 and isinstance(vectors[0].tree, eq.Transposed)
            vectors = vectors[:1] if form else vectors
        if len(vectors) > 1:
            raise UnreadError("two vectors side by side: · or × between them?", vectors[1].position)
        for factor, after in pairwise(factors):
            if (factor.alone and factor.ends) or (after.alone and after.ends):
                raise UnreadError(factor.ends or after.ends, after.position)
            if after.literal and not _is_differential(factor.tree):
                raise UnreadError(
                    "a number behind a factor: a power x^2, an index x_2, or a factor 2x?",
                    after.position,
                )
            if factor.ends:
                raise UnreadError(factor.ends, after.position)
            if factor.kind == "vector" and after.kind == "matrix":
                raise UnreadError("a vector before a matrix", after.position)
        made = factors[0]
        for factor in factors[1:]:
            made = self._times(made, factor)
        return replace(made, kind="scalar") if form else made

    def _times(self, left: _Value, right: _Value) -> _Value:
        """A product; of a matrix that is written out and of letters, as it is typed."""
        if not self.notation.open or left.explicit == right.explicit:
            return _times(left, right)
        parts = [*_written_out(left), *_written_out(right)]
        trees = [x.as_immutable() if isinstance(x, sympy.MatrixBase) else x for x in parts]
        shape = left if left.explicit else right
        return _made(eq.Matrices(*trees), shape.kind, left, right)

    def _of_time(self, factors: list[_Value]) -> list[_Value]:
        """sin Ωt is the sine of an angle: a rate in a function takes the time behind it along."""
        made: list[_Value] = []
        for factor in factors:
            last = made[-1] if made else None
            time = factor.tree == s.t or factor.tree == own(Glyph("t"))
            if time and last is not None and last.pending is not None:
                angle = Mul(last.tree, factor.tree, evaluate=False)
                made[-1] = replace(last, tree=angle, depth=last.depth + 1).closed
            else:
                made.append(factor)
        return [factor.closed for factor in made]

    def cross(self, items: list[Any]) -> _Value:
        left, _, right = items[0].closed, items[1], items[2].closed
        if left.kind == right.kind == "vector":
            return _made(eq.Cross(left.tree, right.tree), "vector", left, right)
        if self.notation.open and left.kind == right.kind == "scalar" and _is_numeric(right.tree):
            return _times(left, right)
        if left.digits and left.literal and right.kind == "scalar" and not right.tree.free_symbols:
            return _times(left, right)
        raise UnreadError(f"× between a {left.kind} and a {right.kind}", right.position)

    def dot(self, items: list[Any]) -> _Value:
        left, _, right = items[0].closed, items[1], items[2].closed
        if left.kind == right.kind == "vector":
            return _made(eq.Dot(left.tree, right.tree), "scalar", left, right)
        if left.kind == right.kind == "scalar":
            letters = [part for part in (left, right) if not part.tree.is_number]
            if self.notation.open and len(letters) == 2:  # of numbers, or of vectors
                return _made(eq.Dot(left.tree, right.tree), "scalar", left, right)
            return _times(left, right)
        raise UnreadError(f"· between a {left.kind} and a {right.kind}", right.position)

    def over(self, items: list[Any]) -> _Value:
        left, _, right = items
        if isinstance(right.tree, Mul):
            raise UnreadError(
                "what follows the / could stand above or below it: put brackets", right.position
            )
        if left.bare and right.literal:
            raise UnreadError(
                "the / could belong to the function's argument: put brackets", right.position
            )
        return _ratio(left.closed, right.closed)

    def summed(self, items: list[Any]) -> _Value:
        index, *limits, body = items[1], *(item.closed for item in items[2:])
        label = Symbol(index.value)
        if limits and not index.value:
            raise UnreadError("a sum with an end and no index", items[0].position)
        if len(limits) == 2:
            made = eq.SumFrom(label, *(limit.tree for limit in limits), body.tree)
        else:
            made = eq.SumOver(label, body.tree)
        return _made(made, body.kind, body, *limits, position=items[0].position)

    def integral(self, items: list[Any]) -> _Value:
        """∫ of a term, which must hold as many differentials as integrals.

        In the letters of a table it is over d³r, or over a letter between two ends.
        """
        *limits, body = (item.closed for item in items[1:])
        place = items[0].position
        found = [node for node in _nodes(body.tree) if _is_differential(node)]
        nested = sum(isinstance(node, eq.Integrated) for node in _nodes(body.tree))
        if len(found) != nested + 1:
            reason = "an integral without its dx: put brackets round all that it is of"
            raise UnreadError(reason, place)
        ends = [limit.tree for limit in limits]
        tree: Any = eq.Integrated(body.tree, *ends)
        if not self.notation.open:
            order, of = self.differentials[found[0]]
            rest = _without(body.tree, found[0])
            if rest is not None and (order, of, ends) == (3, s.r_vec, []):
                tree = eq.VolumeIntegral(Symbol("d3r"), rest)
            elif rest is not None and order == 1 and kind(of) == "scalar" and len(ends) == 2:
                tree = eq.IntegralOver(of, *ends, rest)
            else:
                reason = r"an integral is \int d^3\mathbf r, or \int_a^b dx with its dx as a factor"
                raise UnreadError(reason, place)
        return _made(tree, body.kind, body, *limits, position=place)

    def differential(self, items: list[Any]) -> _Value:
        tree, order, of = items[0].value
        self.differentials[tree] = order, of
        return _Value(tree, kind(tree), items[0].position)

    # Factors

    def power(self, items: list[Any]) -> _Value:
        return _power(items[0].closed, items[2].closed)

    def transposed(self, items: list[Any]) -> _Value:
        base: _Value
        base, raised = items
        if base.kind == "scalar" and not self.notation.open:
            raise UnreadError("a scalar is transposed", raised.position)
        if base.explicit:
            return replace(base, tree=base.tree.T)
        return _made(eq.Transposed(base.tree), base.kind, base)

    def symbol(self, items: list[Any]) -> _Value:
        tree = items[0].value
        return _Value(tree, kind(tree), items[0].position)

    def number(self, items: list[Any]) -> _Value:
        return _number(items[0])

    def constant(self, items: list[Any]) -> _Value:
        return _Value(s.const, "scalar", items[0].position)

    def brackets(self, items: list[Any]) -> _Value:
        inside: _Value = items[1].closed
        if inside.explicit:
            return inside
        if self.notation.open and inside.literal and inside.tree.is_Integer:
            raise UnreadError(
                "a number in brackets: of the equation, or a factor?", inside.position
            )
        if inside.tree.is_Rational and not inside.tree.is_Integer and inside.tree > 1:
            raise UnreadError(
                "a number in brackets: as the equation's own, put it behind a comma or in \\tag{}; "
                "as a factor, without brackets",
                items[0].position,
            )
        return _made(eq.Group(inside.tree), inside.kind, inside, position=items[0].position)

    def listed(self, items: list[Any]) -> _Value:
        entries = [item.closed for item in items if isinstance(item, _Value)]
        if len(entries) == 1:
            return self.brackets(items)
        return self._matrix([entries], items[0].position)

    def matrix(self, items: list[Any]) -> _Value:
        rows = [item for item in items if isinstance(item, list)]
        if len({len(row) for row in rows}) > 1:
            raise UnreadError("a matrix with rows of different lengths", items[0].position)
        return self._matrix(rows, items[0].position)

    def _matrix(self, rows: list[list[_Value]], position: int) -> _Value:
        entries = [entry for row in rows for entry in row]
        if len(rows) > LARGEST or len(rows[0]) > LARGEST:
            raise UnreadError(f"a matrix of more than {LARGEST} rows or columns", position)
        for entry in entries:
            if entry.kind != "scalar" and (entry.explicit or not self.notation.open):
                raise UnreadError(f"a {entry.kind} as an entry", entry.position)
        tree = sympy.Matrix([[entry.tree for entry in row] for row in rows])
        digits = max(entry.digits for entry in entries)
        return _made(tree, kind(tree), *entries, digits=digits, position=position)

    def row(self, items: list[Any]) -> list[_Value]:
        return [item.closed for item in items if isinstance(item, _Value)]

    def fraction(self, items: list[Any]) -> _Value:
        over, below = items[1].closed, items[2].closed
        made = _ratio(over, below)
        literal = over.literal and below.literal and not self.notation.open
        return replace(made, literal=literal, position=items[0].position)

    def root(self, items: list[Any]) -> _Value:
        body = items[1].closed
        if body.kind != "scalar":
            raise UnreadError(f"the root of a {body.kind}", body.position)
        tree = Pow(body.tree, Rational(1, items[0].value), evaluate=False)
        return _made(tree, "scalar", body, position=items[0].position)

    def size(self, items: list[Any]) -> _Value:
        inside = items[1].closed
        if inside.kind == "matrix":
            raise UnreadError("bars round a matrix: write det", inside.position)
        if inside.kind == "vector":
            tree = Pow(eq.Dot(inside.tree, inside.tree), Rational(1, 2), evaluate=False)
        else:
            tree = sympy.Abs(inside.tree, evaluate=False)
        return _made(tree, "scalar", inside, position=items[0].position)

    def brace(self, items: list[Any]) -> _Value:
        body, label = items[1].closed, items[2].closed
        if body.kind != label.kind:
            raise UnreadError(
                f"a {label.kind} beneath a {body.kind}: is a symbol meant in bold?", label.position
            )
        tree = eq.Underbrace(body.tree, label.tree)
        return _made(tree, body.kind, body, label, position=items[0].position)

    def exponential(self, items: list[Any]) -> _Value:
        return self._call("exp", items[0], [items[1].closed])

    # Functions of letters, and what is taken at a place

    def at(self, items: list[Any]) -> _Value:
        arguments = [item.closed for item in items[1:] if isinstance(item, _Value)]
        letter = items[0].value
        if not isinstance(letter, Symbol):
            raise UnreadError("a number with arguments", items[0].position)
        tree = eq.At(letter, *(argument.tree for argument in arguments))
        at = _Value(letter, kind(letter), items[0].position)
        return _made(tree, at.kind, at, *arguments, position=items[0].position)

    def evaluated(self, items: list[Any]) -> _Value:
        body, place = items[0].closed, items[1]
        if not self.notation.open:
            raise UnreadError("a value at one place", place.position)
        tree = eq.Evaluated(body.tree, Symbol(place.value))
        ends = "" if isinstance(body.tree, (eq.Group, Symbol)) else "taken at a place: put brackets"
        return _made(tree, body.kind, body, position=body.position, alone=True, ends=ends)

    # Slopes and rates

    def slope(self, items: list[Any]) -> _Value:
        of, *by = (item.closed for item in items[1:])
        for variable in by:
            if not isinstance(variable.tree, (Symbol, eq.At)):
                raise UnreadError("a derivative is by a letter", variable.position)
        node = eq.Partial if items[0].value == "∂" else eq.Slope
        simple = len(by) == 1 and of.kind == by[0].kind == "scalar"
        if not (self.notation.open or (simple and node is eq.Partial)):
            reason = "a derivative is by the time, or a partial one of a scalar by a letter"
            raise UnreadError(reason, items[0].position)
        tree = node(of.tree, *(variable.tree for variable in by))
        gradient = any(variable.kind == "vector" for variable in by)
        shown = "vector" if gradient else of.kind
        return _made(tree, shown, of, *by, position=items[0].position)

    def slope_of(self, items: list[Any]) -> _Value:
        operator, *by, of = items
        return _acting(of, lambda inside: self.slope([operator, inside, *by]))

    def rate_of(self, items: list[Any]) -> _Value:
        return _acting(items[1], lambda inside: self.rate([items[0], inside]))

    def rate(self, items: list[Any]) -> _Value:
        operator, what = items[0], items[1].closed
        tree = what.tree
        for _ in range(operator.value):
            dotted = self._dotted(tree) if isinstance(tree, Symbol) else None
            tree = dotted if dotted is not None else eq.Rate(tree)
        return _made(tree, what.kind, what, position=operator.position)

    def _dotted(self, symbol: Symbol) -> Symbol | None:
        glyph = self.notation.glyphs.get(symbol)
        accents = {"": "dot", "dot": "ddot"}
        if glyph is None or glyph.accent not in accents:
            return None
        return self.notation.names.get(replace(glyph, accent=accents[glyph.accent]))

    def rate_in(self, items: list[Any]) -> _Value:
        _, operator, what, _, frame = items
        if self.notation.open:
            return self.framed([items[0], what, None, frame])
        if frame.value not in _FRAMES:
            raise UnreadError(f"a rate as seen from {frame.value!r}: space or body", frame.position)
        if operator.value != 1:
            raise UnreadError("a second derivative as seen from a frame", operator.position)
        tree = eq.Rate(what.tree, _FRAMES[frame.value])
        return _made(tree, what.kind, what, position=items[0].position)

    def framed(self, items: list[Any]) -> _Value:
        """A rate in brackets with the frame that it is seen from."""
        body, frame = items[1].closed, items[-1]
        tree = body.tree
        if isinstance(tree, eq.Partial) and tree.args[1:] == (own(Glyph("t")),):
            tree = eq.Rate(tree.args[0])
        if not self.notation.open or not isinstance(tree, (eq.Rate, Lettered)):
            raise UnreadError("an index behind brackets", frame.position)
        what = tree.args[0] if isinstance(tree, eq.Rate) else tree
        seen = eq.Rate(what, _FRAMES.get(frame.value, Symbol(frame.value)))
        return _made(seen, body.kind, body, position=items[0].position)

    def rate_in_brackets(self, items: list[Any]) -> _Value:
        operator, what = items[-3], items[-2]
        made = self.rate([operator, what])
        sign = items[1] if len(items) == 5 else None
        if sign is not None and sign.value == "-":
            made = _negative(made)
        return _made(eq.Group(made.tree), made.kind, made, position=items[0].position)

    # Functions

    def multiple(self, items: list[Any]) -> _Value:
        return _times(_number(items[0]), self.symbol(items[1:]))

    def part(self, items: list[Any]) -> _Value:
        share = self.fraction(items[:3])
        if not (items[1].literal and items[2].literal):
            raise UnreadError("the function could end here: put brackets", items[3].position)
        return _times(share, self.symbol(items[3:]))

    def applied(self, items: list[Any]) -> _Value:
        arguments = [item.closed for item in items if isinstance(item, _Value)]
        return self._call(items[0].value, items[0], arguments)

    def applied_power(self, items: list[Any]) -> _Value:
        made = self._call(items[0].value, items[0], [items[4].closed])
        return self._raised(made, items[2].closed)

    def bare(self, items: list[Any]) -> _Value:
        return self._bare(items[0], items[1], lambda made: made)

    def bare_power(self, items: list[Any]) -> _Value:
        exponent = items[2].closed
        return self._bare(items[0], items[3], lambda made: self._raised(made, exponent))

    def _raised(self, made: _Value, exponent: _Value) -> _Value:
        if exponent.tree == -1 or isinstance(exponent.tree, Mul):
            raise UnreadError(
                "a negative power of a function: the inverse function, or one over it?",
                exponent.position,
            )
        return _power(made, exponent)

    def _bare(self, name: Token, argument: _Value, raised: Callable[[_Value], _Value]) -> _Value:
        """A function without brackets: of an angle, or of a rate that the time may follow."""
        symbol = _last(argument.tree)
        unit = _unit(symbol) if isinstance(symbol, Symbol) else "1"
        if self.notation.open and _is_open(symbol) and not _is_angle(symbol):
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

    def _call(self, name: str, at: Token, arguments: list[_Value]) -> _Value:
        if name in _NAMED and len(arguments) == 1:
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
        return _made(tree, "scalar", *arguments, digits=digits, position=at.position)

    def _of_matrix(self, name: str, at: Token, argument: _Value) -> _Value:
        tree = argument.tree
        inside = tree.args[0] if isinstance(tree, eq.Group) else tree
        if isinstance(inside, Symbol) and inside in self.notation.glyphs:
            letter = self.notation.glyphs[inside].base
            for symbol, glyph in self.notation.glyphs.items():
                if glyph.base == f"{name} {letter}":
                    return _Value(symbol, "scalar", at.position)
        raise UnreadError(f"{name} of what has no name for it", at.position)


def _acting(of: _Value, derivative: Callable[[_Value], _Value]) -> _Value:
    """A derivative of what stands behind it, which ends with it unless it stands in brackets."""
    group = isinstance(of.tree, eq.Group)
    made = derivative(replace(of.closed, tree=of.tree.args[0]) if group else of.closed)
    ends = "" if group else "the derivative could go on here: put brackets"
    if of.pending is None:
        return replace(made, ends=ends)

    def pending(inside: Any) -> Any:
        return derivative(replace(of, tree=inside).closed).tree

    return replace(made, tree=of.tree, pending=pending, ends=ends, bare=True)


def _is_open(node: Expr) -> bool:
    """Whether nothing is known of a letter but how it is written."""
    return isinstance(node, Lettered) and not node.quantity.unit


def _is_angle(node: Lettered) -> bool:
    """Whether mechanics writes angles with that letter."""
    glyph = node.quantity.glyph
    return glyph.base[0] in ANGLES and not glyph.accent


def _definite(factors: Sequence[_Value]) -> None:
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
        if _is_differential(last) or (factor.pending is None) != time:
            continue
        raise UnreadError(
            "of how much the function is: put brackets round all that it is of", after.position
        )


def _may_be_tensor(node: Expr) -> bool:
    """Whether a bold letter may be a matrix: a capital, or what is made of one."""
    if isinstance(node, Pow):
        return _may_be_tensor(node.base)
    if isinstance(node, (eq.Transposed, eq.Group)):
        return _may_be_tensor(node.args[0])
    if not isinstance(node, Lettered):
        return isinstance(node, (Add, Mul))
    base = node.quantity.glyph.base
    return base[0].isupper() or base[0] in "∇01" or len(base) > 1


def _is_numeric(tree: Any) -> bool:
    """Whether a product begins with a number, such as 10³ m: × before it is that of numbers."""
    first = tree.args[0] if isinstance(tree, Mul) else tree
    return (isinstance(first, Mul) and _is_numeric(first)) or bool(first.is_number)


def _nodes(tree: Expr) -> Iterator[Expr]:
    """The parts of a tree, those of matrices too."""
    ahead = [tree]
    while ahead:
        node = ahead.pop()
        yield node
        ahead += list(node) if isinstance(node, sympy.MatrixBase) else list(node.args)


def _is_differential(node: Expr) -> bool:
    """Whether it is a letter such as dx, d³r."""
    if not isinstance(node, Lettered):
        return False
    return bool(re.fullmatch("d[²³]?\\w[\u0300-\u036f′]*", node.quantity.glyph.base))


def _without(tree: Expr, factor: Expr) -> Expr | None:
    """A product without one of its factors; None if it is no factor of it."""
    if tree == factor:
        return Integer(1)
    if not isinstance(tree, (Mul, eq.Cross, eq.Dot)):
        return None
    for i, part in enumerate(tree.args):
        rest = _without(part, factor)
        if rest is None or (rest == 1 and not isinstance(tree, Mul)):
            continue
        kept = [*tree.args[:i], *([] if rest == 1 else [rest]), *tree.args[i + 1 :]]
        whole = {"evaluate": False} if isinstance(tree, Mul) else {}
        return tree.func(*kept, **whole) if len(kept) > 1 else kept[0]
    return None


def _number(token: Token) -> _Value:
    """Digits, with a decimal point or without, as the fraction that they are."""
    whole, _, decimals = token.value.partition(".")
    tree = Rational(int(whole + decimals or "0"), 10 ** len(decimals))
    return _Value(tree, "scalar", token.position, digits=len(whole + decimals), literal=True)


def _last(tree: Expr) -> Expr:
    """The symbol in Ω or 2Ω."""
    return tree.args[-1] if isinstance(tree, Mul) else tree


def _unit(symbol: Symbol) -> str:
    _, quantity = known(symbol)
    return quantity.unit if quantity is not None else ""


def _as_matrix(value: _Value) -> _Value:
    """1 beside matrices is the unit matrix."""
    return replace(value, tree=s.unit, kind="matrix") if value.tree == 1 else value


def _negative(value: _Value) -> _Value:
    return replace(_times(_Value(Integer(-1), "scalar", value.position), value), literal=False)


def _times(left: _Value, right: _Value) -> _Value:
    kinds = (left.kind, right.kind)
    both = next((k for k in ("vector", "matrix") if k in kinds), "scalar")
    written_out = left.explicit or right.explicit or isinstance(left.tree, eq.Matrices)
    if written_out and "scalar" not in kinds:
        return _matrices(left, right)
    return _made(_product(left.tree, right.tree), both, left, right)


def _product(left: Expr, right: Expr) -> Expr:
    """As it is typed, entry by entry where one is a matrix that is written out."""
    if isinstance(left, sympy.MatrixBase):
        return left.applyfunc(lambda entry: entry and _product(entry, right))
    if isinstance(right, sympy.MatrixBase):
        return right.applyfunc(lambda entry: entry and _product(left, entry))
    return Mul(left, right, evaluate=False)


def _matrices(left: _Value, right: _Value) -> _Value:
    """The product of matrices that are written out."""
    factors = [*_written_out(left), *_written_out(right)]
    if len(factors) < 2 or not all(isinstance(factor, sympy.MatrixBase) for factor in factors):
        raise UnreadError("a product with a matrix that is written out", right.position)
    if factors[-2].shape[1] != factors[-1].shape[0]:
        raise UnreadError("matrices of different sizes are multiplied", right.position)
    tree = eq.Matrices(*(factor.as_immutable() for factor in factors))
    depth = left.depth + right.depth
    digits = LARGEST * (left.digits + right.digits + 1)
    return _made(tree, kind(factors[-1]), replace(left, depth=depth), right, digits=digits)


def _written_out(part: _Value) -> tuple[Expr | MatrixBase, ...]:
    return part.tree.args if isinstance(part.tree, eq.Matrices) else (part.tree,)


def _power(base: _Value, exponent: _Value) -> _Value:
    if exponent.kind != "scalar":
        raise UnreadError(f"a {exponent.kind} as an exponent", exponent.position)
    if base.kind == "matrix" or base.explicit:
        raise UnreadError("a power of a matrix: write the product, or ᵀ", exponent.position)
    if base.kind == "vector":
        if exponent.tree == -1 and _is_open(base.tree) and _may_be_tensor(base.tree):
            return _made(Pow(base.tree, Integer(-1), evaluate=False), "vector", base)
        if exponent.tree != 2:
            raise UnreadError("a power of a vector other than its square", exponent.position)
        return _made(eq.Dot(base.tree, base.tree), "scalar", base)
    if base.tree == 0 and (exponent.tree == 0 or isinstance(exponent.tree, Mul)):
        raise UnreadError("a power of 0 that has no value", exponent.position)
    size = _size(exponent)
    named = bool(base.tree.free_symbols)
    if any(_is_open(x) for x in exponent.tree.free_symbols):
        size = min(size, 1)  # nothing is put in for it
    raised = base.raised * max(size, 1) if named else base.raised
    if raised > RAISED or size > 10**4:
        raise UnreadError("a power too high", exponent.position)
    return _made(
        Pow(base.tree, exponent.tree, evaluate=False),
        "scalar",
        base,
        exponent,
        digits=base.digits * max(size, 1) + exponent.digits,
        raised=raised,
    )


def _size(exponent: _Value) -> float:
    """How large an exponent may be at most, as far as its numbers go."""
    tree = exponent.tree
    if isinstance(tree, Mul) and len(tree.args) == 2 and tree.args[0] == -1:
        tree = tree.args[1]
    if tree.is_Rational:
        return float(abs(tree)) if exponent.digits < 20 else 1e20
    return 10.0 ** min(exponent.digits, 20) if exponent.digits else 1


def _ratio(over: _Value, below: _Value) -> _Value:
    if below.kind != "scalar":
        raise UnreadError(f"a division by a {below.kind}", below.position)
    inside = below.tree
    while isinstance(inside, eq.Group):
        inside = inside.args[0]
    if inside == 0:
        raise UnreadError("a division by 0", below.position)
    if isinstance(over.tree, Rational) and isinstance(below.tree, Rational):
        return _made(Rational(over.tree, below.tree), "scalar", over, below)
    one_over = _made(Pow(below.tree, Integer(-1), evaluate=False), "scalar", below)
    return _made(_product(over.tree, one_over.tree), over.kind, over, one_over)
