"""Tokens become the sides of an equation: the grammar, and what each of its rules makes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cache
from importlib.resources import files
from itertools import pairwise
from typing import Any

import sympy
from lark import Lark, UnexpectedInput
from lark import Token as Lexeme
from lark.exceptions import VisitError
from lark.lexer import Lexer
from sympy import Add, Integer, Mul, Pow, Rational, Symbol

from rigidtop.notation import Notation
from rigidtop.notation.convention import own
from rigidtop.proof import equation as eq
from rigidtop.read import values as v
from rigidtop.read.called import Functions, Items
from rigidtop.read.cursor import Token
from rigidtop.read.scan import shown
from rigidtop.read.tex import UnreadError
from rigidtop.read.values import LARGEST, OMITTED, Value, acting, built, kind
from rigidtop.theory import symbols as s
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.symbols import Glyph


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


def parsed(found: Sequence[Token], notation: Notation) -> tuple[list[Any], list[str]]:
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


_FRAMES = {"space": eq.SPACE, "body": eq.BODY}


class _Builder(Functions):
    """The tree of the grammar as the tree of an equation; one method a rule."""

    def __init__(self, notation: Notation) -> None:
        super().__init__(notation)
        self.differentials: dict[Any, tuple[int, Any]] = {}
        """Of dx, d³r: the order, and the letter."""

    def start(self, items: Items) -> tuple[list[Any], list[str]]:
        sides = [item.closed for item in items if isinstance(item, Value)]
        relations = [item.value for item in items if isinstance(item, Token)]
        kinds = {side.kind for side in sides}
        if "matrix" in kinds:
            sides = [v.as_matrix(side) for side in sides]
        for before, side in pairwise(sides):
            free = (0, s.const, OMITTED)
            if self.notation.open and before.explicit != side.explicit:
                lone = side if before.explicit else before
                if lone.tree.is_number and lone.tree != 0:
                    raise UnreadError("a row and a number are compared", side.position)
                continue  # a letter that is equal to a matrix is one
            if before.kind != side.kind and before.tree not in free and side.tree not in free:
                raise UnreadError(
                    f"a {before.kind} and a {side.kind} are compared: is a symbol meant in bold?",
                    side.position,
                )
        return [side.tree for side in sides], relations

    # Sums and products

    def signed(self, items: Items) -> Value:
        sign, term = items
        made = v.negative(term.closed) if sign.value == "-" else term.closed
        return replace(made, position=sign.position)

    def added(self, items: Items) -> Value:
        total, sign, term = items[0].closed, items[1], items[2].closed
        if "matrix" in (total.kind, term.kind):
            total, term = v.as_matrix(total), v.as_matrix(term)
        wild = (0, OMITTED)
        if self.notation.open and (total.explicit or term.explicit):
            return self._added_typed(total, sign, term)
        if total.kind != term.kind and total.tree not in wild and term.tree not in wild:
            raise UnreadError(f"a {total.kind} and a {term.kind} are added", term.position)
        if sign.value == "-":
            term = v.negative(term)
        if self.notation.open and v.goes_on(total.tree, term.tree):
            raise UnreadError("the sum over an index could go on here: put brackets", term.position)
        digits = max(total.digits, term.digits) + 1
        if total.explicit or term.explicit:
            return built(self._sum(total, term), total.kind, total, term, digits=digits)
        return built(
            Add(total.tree, term.tree, evaluate=False), total.kind, total, term, digits=digits
        )

    def _added_typed(self, total: Value, sign: Token, term: Value) -> Value:
        """A sum with matrices that are written out, as it is typed."""
        trees = [
            eq.Matrices(part.tree.as_immutable()) if part.explicit else part.tree
            for part in (total, term)
        ]
        if sign.value == "-":
            trees[1] = Mul(Integer(-1), trees[1], evaluate=False)
        shape = total if total.explicit else term
        return built(Add(*trees, evaluate=False), shape.kind, total, term)

    def _sum(self, total: Value, term: Value) -> Any:
        if not (total.explicit and term.explicit and total.tree.shape == term.tree.shape):
            raise UnreadError("what is added is not of the same shape", term.position)
        return total.tree + term.tree

    def product(self, items: Items) -> Value:
        if self.notation.open:
            v.definite(items)
        factors = self._of_time(items)
        vectors = [factor for factor in factors if factor.kind == "vector"]
        form = False
        if self.notation.open:
            vectors = [x for x in vectors if not v.may_be_tensor(x.tree)] or vectors[:1]
            form = len(vectors) == 2 and isinstance(vectors[0].tree, eq.Transposed)
            vectors = vectors[:1] if form else vectors
        if len(vectors) > 1:
            raise UnreadError("two vectors side by side: · or × between them?", vectors[1].position)
        for factor, after in pairwise(factors):
            if (factor.alone and factor.ends) or (after.alone and after.ends):
                raise UnreadError(factor.ends or after.ends, after.position)
            if after.literal and not v.is_differential(factor.tree):
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

    def _times(self, left: Value, right: Value) -> Value:
        """A product; of a matrix that is written out and of letters, as it is typed."""
        if not self.notation.open or left.explicit == right.explicit:
            return v.times(left, right)
        parts = [*v.written_out(left), *v.written_out(right)]
        trees = [x.as_immutable() if isinstance(x, sympy.MatrixBase) else x for x in parts]
        shape = left if left.explicit else right
        return built(eq.Matrices(*trees), shape.kind, left, right)

    def _of_time(self, factors: list[Value]) -> list[Value]:
        """sin Ωt is the sine of an angle: a rate in a function takes the time behind it along."""
        made: list[Value] = []
        for factor in factors:
            last = made[-1] if made else None
            time = factor.tree == s.t or factor.tree == own(Glyph("t"))
            if time and last is not None and last.pending is not None:
                angle = Mul(last.tree, factor.tree, evaluate=False)
                made[-1] = replace(last, tree=angle, depth=last.depth + 1).closed
            else:
                made.append(factor)
        return [factor.closed for factor in made]

    def cross(self, items: Items) -> Value:
        left, _, right = items[0].closed, items[1], items[2].closed
        if left.kind == right.kind == "vector":
            return built(eq.Cross(left.tree, right.tree), "vector", left, right)
        if self.notation.open and left.kind == right.kind == "scalar" and v.is_numeric(right.tree):
            return v.times(left, right)
        if left.digits and left.literal and right.kind == "scalar" and not right.tree.free_symbols:
            return v.times(left, right)
        raise UnreadError(f"× between a {left.kind} and a {right.kind}", right.position)

    def dot(self, items: Items) -> Value:
        left, _, right = items[0].closed, items[1], items[2].closed
        if left.kind == right.kind == "vector":
            return built(eq.Dot(left.tree, right.tree), "scalar", left, right)
        if left.kind == right.kind == "scalar":
            letters = [part for part in (left, right) if not part.tree.is_number]
            if self.notation.open and len(letters) == 2:  # of numbers, or of vectors
                return built(eq.Dot(left.tree, right.tree), "scalar", left, right)
            return v.times(left, right)
        if left.kind == "scalar" and isinstance(right.tree, eq.Group) and not self.notation.open:
            return v.times(left, right)  # as a product is broken before a bracket
        raise UnreadError(f"· between a {left.kind} and a {right.kind}", right.position)

    def over(self, items: Items) -> Value:
        left, _, right = items
        if isinstance(right.tree, Mul):
            raise UnreadError(
                "what follows the / could stand above or below it: put brackets", right.position
            )
        if left.bare and right.literal:
            raise UnreadError(
                "the / could belong to the function's argument: put brackets", right.position
            )
        return v.ratio(left.closed, right.closed)

    def summed(self, items: Items) -> Value:
        index, *limits, body = items[1], *(item.closed for item in items[2:])
        label = Symbol(index.value)
        if limits and not index.value:
            raise UnreadError("a sum with an end and no index", items[0].position)
        if len(limits) == 2:
            made = eq.SumFrom(label, *(limit.tree for limit in limits), body.tree)
        else:
            made = eq.SumOver(label, body.tree)
        return built(made, body.kind, body, *limits, position=items[0].position)

    def integral(self, items: Items) -> Value:
        """∫ of a term, which must hold as many differentials as integrals.

        In the letters of a table it is over d³r, or over a letter between two ends.
        """
        *limits, body = (item.closed for item in items[1:])
        place = items[0].position
        found = [node for node in v.nodes(body.tree) if v.is_differential(node)]
        nested = sum(isinstance(node, eq.Integrated) for node in v.nodes(body.tree))
        if len(found) != nested + 1:
            reason = "an integral without its dx: put brackets round all that it is of"
            raise UnreadError(reason, place)
        ends = [limit.tree for limit in limits]
        tree: Any = eq.Integrated(body.tree, *ends)
        if not self.notation.open:
            order, of = self.differentials[found[0]]
            rest = v.without(body.tree, found[0])
            if rest is not None and (order, of, ends) == (3, s.r_vec, []):
                tree = eq.VolumeIntegral(Symbol("d3r"), rest)
            elif rest is not None and order == 1 and kind(of) == "scalar" and len(ends) == 2:
                tree = eq.IntegralOver(of, *ends, rest)
            else:
                reason = r"an integral is \int d^3\mathbf r, or \int_a^b dx with its dx as a factor"
                raise UnreadError(reason, place)
        return built(tree, body.kind, body, *limits, position=place)

    def differential(self, items: Items) -> Value:
        tree, order, of = items[0].value
        self.differentials[tree] = order, of
        return Value(tree, kind(tree), items[0].position)

    # Factors

    def power(self, items: Items) -> Value:
        return v.power(items[0].closed, items[2].closed)

    def transposed(self, items: Items) -> Value:
        base: Value
        base, raised = items
        if base.kind == "scalar" and not self.notation.open:
            raise UnreadError("a scalar is transposed", raised.position)
        if base.explicit:
            return replace(base, tree=base.tree.T)
        return built(eq.Transposed(base.tree), base.kind, base)

    def symbol(self, items: Items) -> Value:
        tree = items[0].value
        return Value(tree, kind(tree), items[0].position)

    def number(self, items: Items) -> Value:
        return v.number(items[0])

    def constant(self, items: Items) -> Value:
        return Value(s.const, "scalar", items[0].position)

    def brackets(self, items: Items) -> Value:
        inside: Value = items[1].closed
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
        return built(eq.Group(inside.tree), inside.kind, inside, position=items[0].position)

    def listed(self, items: Items) -> Value:
        entries = [item.closed for item in items if isinstance(item, Value)]
        if len(entries) == 1:
            return self.brackets(items)
        if self.notation.open and [entry.kind for entry in entries] == ["vector", "vector"]:
            reason = "two vectors in brackets: a row, or their product?"
            raise UnreadError(reason, items[0].position)
        return self._matrix([entries], items[0].position)

    def matrix(self, items: Items) -> Value:
        rows = [item for item in items if isinstance(item, list)]
        if len({len(row) for row in rows}) > 1:
            raise UnreadError("a matrix with rows of different lengths", items[0].position)
        return self._matrix(rows, items[0].position)

    def _matrix(self, rows: list[list[Value]], position: int) -> Value:
        entries = [entry for row in rows for entry in row]
        if len(rows) > LARGEST or len(rows[0]) > LARGEST:
            raise UnreadError(f"a matrix of more than {LARGEST} rows or columns", position)
        for entry in entries:
            if entry.kind != "scalar" and (entry.explicit or not self.notation.open):
                raise UnreadError(f"a {entry.kind} as an entry", entry.position)
        tree = sympy.ImmutableMatrix([[entry.tree for entry in row] for row in rows])
        digits = max(entry.digits for entry in entries)
        return built(tree, kind(tree), *entries, digits=digits, position=position)

    def row(self, items: Items) -> list[Value]:
        return [item.closed for item in items if isinstance(item, Value)]

    def fraction(self, items: Items) -> Value:
        over, below = items[1].closed, items[2].closed
        made = v.ratio(over, below)
        literal = over.literal and below.literal and not self.notation.open
        return replace(made, literal=literal, position=items[0].position)

    def root(self, items: Items) -> Value:
        body = items[1].closed
        if body.kind != "scalar":
            raise UnreadError(f"the root of a {body.kind}", body.position)
        tree = Pow(body.tree, Rational(1, items[0].value), evaluate=False)
        return built(tree, "scalar", body, position=items[0].position)

    def size(self, items: Items) -> Value:
        inside = items[1].closed
        if inside.kind == "matrix":
            raise UnreadError("bars round a matrix: write det", inside.position)
        if inside.kind == "vector":
            tree = Pow(eq.Dot(inside.tree, inside.tree), Rational(1, 2), evaluate=False)
        else:
            tree = sympy.Abs(inside.tree, evaluate=False)
        return built(tree, "scalar", inside, position=items[0].position)

    def brace(self, items: Items) -> Value:
        body, label = items[1].closed, items[2].closed
        if body.kind != label.kind:
            raise UnreadError(
                f"a {label.kind} beneath a {body.kind}: is a symbol meant in bold?", label.position
            )
        tree = eq.Underbrace(body.tree, label.tree)
        return built(tree, body.kind, body, label, position=items[0].position)

    # Functions of letters, and what is taken at a place

    def at(self, items: Items) -> Value:
        arguments = [item.closed for item in items[1:] if isinstance(item, Value)]
        letter = items[0].value
        if not isinstance(letter, Symbol):
            raise UnreadError("a number with arguments", items[0].position)
        tree = eq.At(letter, *(argument.tree for argument in arguments))
        at = Value(letter, kind(letter), items[0].position)
        return built(tree, at.kind, at, *arguments, position=items[0].position)

    def evaluated(self, items: Items) -> Value:
        body, place = items[0].closed, items[1]
        if not self.notation.open:
            raise UnreadError("a value at one place", place.position)
        tree = eq.Evaluated(body.tree, Symbol(place.value))
        ends = "" if isinstance(body.tree, (eq.Group, Symbol)) else "taken at a place: put brackets"
        return built(tree, body.kind, body, position=body.position, alone=True, ends=ends)

    # Slopes and rates

    def slope(self, items: Items) -> Value:
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
        return built(tree, shown, of, *by, position=items[0].position)

    def slope_of(self, items: Items) -> Value:
        operator, *by, of = items
        return acting(of, lambda inside: self.slope([operator, inside, *by]))

    def rate_of(self, items: Items) -> Value:
        return acting(items[1], lambda inside: self.rate([items[0], inside]))

    def rate(self, items: Items) -> Value:
        operator, what = items[0], items[1].closed
        tree = what.tree
        for _ in range(operator.value):
            dotted = self._dotted(tree) if isinstance(tree, Symbol) else None
            tree = dotted if dotted is not None else eq.Rate(tree)
        return built(tree, what.kind, what, position=operator.position)

    def _dotted(self, symbol: Symbol) -> Symbol | None:
        glyph = self.notation.glyphs.get(symbol)
        accents = {"": "dot", "dot": "ddot"}
        if glyph is None or glyph.accent not in accents:
            return None
        return self.notation.names.get(replace(glyph, accent=accents[glyph.accent]))

    def rate_in(self, items: Items) -> Value:
        _, operator, what, _, frame = items
        if self.notation.open:
            return self.framed([items[0], what, None, frame])
        if frame.value not in _FRAMES:
            raise UnreadError(f"a rate as seen from {frame.value!r}: space or body", frame.position)
        if operator.value != 1:
            raise UnreadError("a second derivative as seen from a frame", operator.position)
        tree = eq.Rate(what.tree, _FRAMES[frame.value])
        return built(tree, what.kind, what, position=items[0].position)

    def framed(self, items: Items) -> Value:
        """A rate in brackets with the frame that it is seen from."""
        body, frame = items[1].closed, items[-1]
        tree = body.tree
        if isinstance(tree, eq.Partial) and tree.args[1:] == (own(Glyph("t")),):
            tree = eq.Rate(tree.args[0])
        if not self.notation.open or not isinstance(tree, (eq.Rate, Lettered)):
            raise UnreadError("an index behind brackets", frame.position)
        what = tree.args[0] if isinstance(tree, eq.Rate) else tree
        seen = eq.Rate(what, _FRAMES.get(frame.value, Symbol(frame.value)))
        return built(seen, body.kind, body, position=items[0].position)

    def rate_in_brackets(self, items: Items) -> Value:
        operator, what = items[-3], items[-2]
        made = self.rate([operator, what])
        sign = items[1] if len(items) == 5 else None
        if sign is not None and sign.value == "-":
            made = v.negative(made)
        return built(eq.Group(made.tree), made.kind, made, position=items[0].position)

    def multiple(self, items: Items) -> Value:
        return v.times(v.number(items[0]), self.symbol(items[1:]))

    def part(self, items: Items) -> Value:
        share = self.fraction(items[:3])
        if not (items[1].literal and items[2].literal):
            raise UnreadError("the function could end here: put brackets", items[3].position)
        return v.times(share, self.symbol(items[3:]))
