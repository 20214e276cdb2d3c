"""Height and width of a layout, and how an equation is broken into lines."""

from __future__ import annotations

from dataclasses import dataclass

from rigidtop.proof.equation import (
    Equation,
)
from rigidtop.typeset import nodes as lay
from rigidtop.typeset.layout import Order, layout


def is_tall(node: lay.Node) -> bool:
    """Whether brackets round a node must grow."""
    match node:
        case lay.Fraction():
            return not node.small
        case lay.BraceBelow() | lay.Big() | lay.DifferentialQuotient() | lay.Grid():
            return True
        case lay.Superscript():
            return is_tall(node.base)
        case lay.FunctionOf() | lay.IntegralMeasure():
            return False
    return any(map(is_tall, lay.parts(node)))


def width(node: lay.Node) -> float:
    """About how wide a node is printed, in digits: 5 pt in letters of 10 pt."""
    match node:
        case lay.Digits():
            return sum(map(_letter, node.text))
        case lay.Atom():
            return sum(map(_letter, node.glyph.base)) + _script(node.glyph.sub)
        case lay.Terms():
            first = 1.6 * (node.terms[0].negative or isinstance(node, lay.Continued))
            return (
                first + sum(width(term.body) for term in node.terms) + 2.45 * (len(node.terms) - 1)
            )
        case lay.Factors():
            return sum(map(width, node.factors)) + sum(map(_SIGNS.__getitem__, node.joints))
        case lay.Fraction():
            return max(width(node.over), width(node.under)) * (0.75 if node.small else 1) + 0.5
        case lay.Superscript(base=lay.Atom(glyph=glyph)):  # the exponent stands above the index
            above = SCRIPT * width(node.exponent)
            return sum(map(_letter, glyph.base)) + max(above, _script(glyph.sub))
        case lay.Superscript():
            return width(node.base) + SCRIPT * width(node.exponent)
        case lay.Radical():
            return width(node.body) + 1.8
        case lay.FunctionOf():
            name = 0.9 * len(node.name) if isinstance(node.name, str) else width(node.name)
            power = SCRIPT * width(node.power) if node.power else 0
            inside = sum(map(width, node.arguments))
            return name + power + inside + (_BRACKETS if node.brackets else 0.33)
        case lay.Brackets():
            return width(node.body) + _BRACKETS * (1.5 if is_tall(node.body) else 1)
        case lay.BraceBelow():
            return max(width(node.body), 1 + SCRIPT * width(node.label))
        case lay.Infix():
            left = width(node.left) if node.left else 0
            return left + width(node.right) + _SIGNS.get(node.sign, 2.45)
        case lay.TransposeOf():
            return width(node.body) + 1
        case lay.DifferentialQuotient():
            over = 1.2 + width(node.body) * node.inside
            apart = width(node.body) * (not node.inside)
            frame = 3 + SCRIPT * len(node.frame) if node.frame else 0
            return max(over, 1.2 + width(node.by)) + 0.5 + apart + frame
        case lay.Big():
            measure = width(node.index) if node.sign == "∫" and node.index is not None else 0
            return 3.2 + measure + width(node.body)
        case lay.IntegralMeasure():
            return 1.6 + width(node.variable) + SCRIPT * max(map(width, node.bounds), default=0.0)
        case lay.Grid():
            columns = zip(*node.rows, strict=True)
            return sum(max(map(width, column)) + 2 for column in columns)
        case lay.Enumeration():
            between = 0.9 if node.between == "," else 4 + len(node.between)
            return sum(map(width, node.items)) + between * (len(node.items) - 1)
        case lay.Chain():
            return sum(map(width, node.sides)) + 2.7 * len(node.signs)


SCRIPT = 0.8
"""The size of indices and exponents."""

_BRACKETS = 1.56
_SIGNS = {"": 0.0, "function": 0.33, "thin": 0.33, "dot": 1.45, "·": 1.45, "/": 1.0}
_WIDTHS = {"M": 2.15, "m": 1.75, "I": 1.0, ".": 0.55, "i": 0.7, "l": 0.65, "t": 0.75, "Ω": 1.45}


def _letter(c: str) -> float:
    return _WIDTHS.get(c) or (1.0 if c.isdigit() else 1.5 if c.isascii() and c.isupper() else 1.15)


def _script(sub: str) -> float:
    return SCRIPT * sum(map(_letter, sub)) + 0.1 if sub else 0.0


@dataclass(frozen=True)
class DisplayLine:
    """One line of a display: what stands left of the alignment, the sign, what stands right.

    The first line of an equation has a `left` side; a line that continues a sum has no `sign`.
    """

    left: lay.Node | None
    sign: str
    right: lay.Node


LINE = 62.0
"""How many letters wide a line of the page is."""

HUNG = 4.0
"""Letters by which a right side begins to the right that has a line of its own."""


def lines(
    equation: Equation | lay.Chain, order: Order = "auto", limit: float = LINE
) -> list[DisplayLine]:
    """An equation broken before its relation signs, and long sums before a + or −."""
    chain = layout(equation, order) if isinstance(equation, Equation) else equation
    assert isinstance(chain, lay.Chain)
    first = chain.sides[0]
    margin = min(width(first) + 3, limit / 2)
    packed: list[tuple[list[lay.Node], list[str]]] = [([chain.sides[1]], [chain.signs[0]])]
    for sign, side in zip(chain.signs[1:], chain.sides[2:], strict=True):
        sides, signs = packed[-1]
        if margin + sum(map(width, sides)) + 3 * len(signs) + width(side) <= limit:
            sides.append(side)
            signs.append(sign)
        else:
            packed.append(([side], [sign]))
    broken: list[DisplayLine] = []
    for sides, signs in packed:
        pieces = [sides[0]]
        if len(sides) == 1:
            terms = [t.body for t in sides[0].terms] if isinstance(sides[0], lay.Terms) else pieces
            fit = all(width(term) <= limit - HUNG for term in terms)
            pieces = _broken(sides[0], limit - (margin if fit else HUNG), limit - HUNG)
        joined = pieces if len(sides) == 1 else [lay.Chain(tuple(sides), tuple(signs[1:]))]
        for i, piece in enumerate(joined):
            left = first if not broken else None
            broken.append(DisplayLine(left, signs[0] if i == 0 else "", piece))
    return broken


def _broken(node: lay.Node, limit: float, whole: float) -> list[lay.Node]:
    """A node in lines: sums before a + or −, before a bracket, with a ·, what no `whole` line has
    room for."""
    match node:
        case _ if width(node) <= limit:
            return [node]
        case lay.Terms():
            rows: list[list[lay.Signed]] = [[]]
            for term in node.terms:
                if rows[-1] and width(lay.Terms((*rows[-1], term))) > limit:
                    rows.append([])
                rows[-1].append(term)
            pieces: list[lay.Node] = []
            for row in rows:
                first, *rest = (
                    _broken(row[0].body, limit, whole) if len(row) == 1 else [row[0].body]
                )
                terms = (lay.Signed(row[0].negative, first), *row[1:])
                pieces += [lay.Continued(terms) if pieces else lay.Terms(terms), *rest]
            return pieces
        case lay.Factors(factors=(*before, lay.Brackets() as last)) if width(node) > whole:
            head = lay.Factors(tuple(before), node.joints[:-1]) if before[1:] else before[0]
            if _is_vector(last):  # a · before it would be the product of two
                first, *rest = _opened(last, limit - width(head), whole)
                return [lay.Factors((*before, first), node.joints), *rest]
            first, *rest = _broken(last, limit, whole)
            return [*_broken(head, limit, whole), lay.Infix("·", None, first), *rest]
        case lay.Brackets(shape="()") if width(node) > whole:
            return _opened(node, limit, whole)
    return [node]


def _opened(node: lay.Brackets, limit: float, whole: float) -> list[lay.Node]:
    """A sum in round brackets, in lines."""
    if node.shape != "()" or not isinstance(node.body, lay.Terms):
        return [node]
    first, *rest = _broken(node.body, limit - 1.5, whole)
    if not rest:
        return [node]
    return [lay.Brackets(first, "(."), *rest[:-1], lay.Brackets(rest[-1], ".)")]


def _is_vector(node: lay.Node) -> bool:
    match node:
        case lay.Atom():
            return node.glyph.bold
        case lay.Infix():
            return node.sign == "×"
        case lay.Brackets() | lay.Terms() | lay.Factors():
            return any(map(_is_vector, lay.parts(node)))
    return False
