"""The nodes of a layout, and how they are put together: brackets, signs, joints."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import get_args

from rigidtop.notation.characters import GREEK
from rigidtop.theory.lettered import BY_NAME
from rigidtop.theory.symbols import Glyph


@dataclass(frozen=True)
class Digits:
    """A number without a sign, as its digits."""

    text: str


@dataclass(frozen=True)
class Atom:
    """A single symbol, by its glyph."""

    glyph: Glyph


@dataclass(frozen=True)
class Signed:
    """A term of a sum, and whether a minus stands before it."""

    negative: bool
    body: Node


@dataclass(frozen=True)
class Terms:
    """Signed terms; a single negative term is a negation."""

    terms: tuple[Signed, ...]

    def signed(self) -> Iterator[tuple[str, Node]]:
        """Each term with its sign: "−" or "" before the first, " + " or " − " between two."""
        for k, term in enumerate(self.terms):
            between = f" {'−' if term.negative else '+'} "
            first = "−" if term.negative else ""
            yield between if k or isinstance(self, Continued) else first, term.body


@dataclass(frozen=True)
class Continued(Terms):
    """The rest of a sum on a new line: its first sign is always shown."""


@dataclass(frozen=True)
class Factors:
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
class Superscript:
    """``base`` raised to ``exponent``; brackets round the base are already there."""

    base: Node
    exponent: Node


@dataclass(frozen=True)
class Radical:
    """A square root, or with an `index` another root."""

    body: Node
    index: str = ""


@dataclass(frozen=True)
class FunctionOf:
    """A function with its arguments.  Without `brackets` the single argument stands bare.

    `name` is a word that is set upright ("sin"), or a `Atom` ("ρ(r)").
    """

    name: str | Atom
    arguments: tuple[Node, ...]
    brackets: bool
    power: Node | None = None


@dataclass(frozen=True)
class Brackets:
    """Brackets of one shape: "()", "[]" or "||"; "(." and ".)" where a line ends between them."""

    body: Node
    shape: str = "()"


@dataclass(frozen=True)
class BraceBelow:
    """A body with a brace beneath it and ≡ label beneath that."""

    body: Node
    label: Node


@dataclass(frozen=True)
class Infix:
    """``left × right`` or ``left · right``; nothing to the left where a line goes on."""

    sign: str
    left: Node | None
    right: Node


@dataclass(frozen=True)
class TransposeOf:
    """The transpose of a matrix: the body with ᵀ behind it."""

    body: Node


@dataclass(frozen=True)
class DifferentialQuotient:
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
class IntegralMeasure:
    """The measure d³r of an integral, or dx with bounds."""

    dimension: str
    variable: Node
    bounds: tuple[Node, ...] = ()


@dataclass(frozen=True)
class Grid:
    """A matrix as rows of nodes."""

    rows: tuple[tuple[Node, ...], ...]


@dataclass(frozen=True)
class Enumeration:
    """Nodes with a comma, "and" or "or" between them."""

    items: tuple[Node, ...]
    between: str = ","


@dataclass(frozen=True)
class Chain:
    """Sides with a relation sign between each pair of neighbours."""

    sides: tuple[Node, ...]
    signs: tuple[str, ...]


Node = (
    Digits
    | Atom
    | Terms
    | Factors
    | Fraction
    | Superscript
    | Radical
    | FunctionOf
    | Brackets
    | BraceBelow
    | Infix
    | TransposeOf
    | DifferentialQuotient
    | Big
    | IntegralMeasure
    | Grid
    | Enumeration
    | Chain
)


def parts(node: object) -> Iterator[Node]:
    """The nodes of which a node is put together."""
    for value in vars(node).values():
        for part in value if isinstance(value, tuple) else (value,):
            if isinstance(part, Signed):
                yield part.body
            elif isinstance(part, tuple):  # a row of a grid
                yield from part
            elif isinstance(part, _NODES):
                yield part


_NODES = get_args(Node)


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
    match = re.fullmatch("([dΔδ][²³]?)(\\w[\u0300-\u036f′]*)", glyph.base)
    return (match[1], replace(glyph, base=match[2])) if match else ("", glyph)


# --- Building blocks: brackets and joints -------------------------------------------------------


def negated(node: Node) -> Node:
    """−node, with the sign drawn out of a negation."""
    if isinstance(node, Terms) and len(node.terms) == 1:
        (term,) = node.terms
        return term.body if term.negative else Terms((Signed(True, term.body),))
    return Terms((Signed(True, bracketed(node) if isinstance(node, Terms) else node),))


def bracketed(node: Node) -> Node:
    """The node in round brackets, unless it has brackets of its own."""
    return node if isinstance(node, (Brackets, Grid)) else Brackets(node)


def as_factor(node: Node, last: bool) -> Node:
    if isinstance(node, Terms):
        return Brackets(node)
    if isinstance(node, (Infix, Big, Chain, Enumeration)) and not last:
        return Brackets(node)
    if isinstance(node, DifferentialQuotient) and not node.inside and not last:
        return Brackets(node)
    if isinstance(node, BraceBelow):
        return replace(node, body=as_factor(node.body, last))
    return node


def _starts_with_digit(node: Node) -> bool:
    if isinstance(node, Digits):
        return True
    if isinstance(node, Fraction):
        return node.small
    if isinstance(node, Superscript):
        return _starts_with_digit(node.base)
    return isinstance(node, Factors) and _starts_with_digit(node.factors[0])


def _is_word(node: Node) -> bool:
    return isinstance(node, Atom) and len(node.glyph.base) > 1


def _joint(left: Node, right: Node) -> str:
    if _starts_with_digit(right):
        return "dot"
    if isinstance(right, FunctionOf) and isinstance(right.name, str):
        return "function"
    if isinstance(left, FunctionOf) and not left.brackets:
        return "thin"
    if isinstance(right, Big):
        return "function"
    if isinstance(right, DifferentialQuotient) or isinstance(left, DifferentialQuotient):
        return "thin"
    if isinstance(right, Fraction) and isinstance(left, Fraction):
        return "thin"
    return "thin" if _is_word(left) or _is_word(right) else ""


def product(factors: Iterable[Node]) -> Node:
    """Factors side by side, each in brackets where it needs them."""
    flat: list[Node] = []
    for factor in factors:
        flat.extend(factor.factors if isinstance(factor, Factors) else (factor,))
    if not flat:
        return Digits("1")
    if len(flat) == 1:
        return flat[0]
    alone = not any(isinstance(factor, Infix) for factor in flat[:-1])
    parts = [as_factor(x, last=alone and i == len(flat) - 1) for i, x in enumerate(flat)]
    return Factors(tuple(parts), tuple(_joint(a, b) for a, b in pairwise(parts)))


def total(terms: Iterable[Node]) -> Node:
    """A sum; negations become its minus signs."""
    flat: list[Signed] = []
    for term in terms:
        flat.extend(term.terms if isinstance(term, Terms) else (Signed(False, term),))
    if len(flat) == 1 and not flat[0].negative:
        return flat[0].body
    return Terms(tuple(flat))


def as_operand(node: Node) -> Node:
    """The node as an operand of × or ·, in brackets where it needs them."""
    return Brackets(node) if isinstance(node, (Terms, Infix, Big)) else node


def raised(base: Node, exponent: Node) -> Node:
    if isinstance(base, FunctionOf) and base.power is None and isinstance(base.name, str):
        return replace(base, power=exponent)
    simple = (Atom, Digits, Brackets, Grid)
    return Superscript(base if isinstance(base, simple) else Brackets(base), flat(exponent))


def flat(node: Node) -> Node:
    """Fractions with a slash, as they stand in an exponent or a sentence."""
    match node:
        case Terms():
            return replace(node, terms=tuple(replace(x, body=flat(x.body)) for x in node.terms))
        case Chain():
            return replace(node, sides=tuple(map(flat, node.sides)))
        case Brackets():
            return replace(node, body=flat(node.body))
        case Factors():
            inner = (flat(x) if isinstance(x, Brackets) else x for x in node.factors)
            return replace(node, factors=tuple(inner))
        case FunctionOf():
            return replace(node, arguments=tuple(map(flat, node.arguments)))
        case Fraction(small=False):
            single = isinstance(node.under, Atom | Digits | Superscript | Radical | FunctionOf)
            under = node.under if single else bracketed(node.under)
            return Infix("/", as_factor(node.over, False), under)
    return node


def ratio(over: Node, under: Node) -> Node:
    small = isinstance(over, Digits) and isinstance(under, Digits)
    if isinstance(over, Terms) and len(over.terms) == 1:  # the minus stands before the fraction
        return negated(ratio(over.terms[0].body, under))
    if isinstance(under, Brackets) and under.shape == "()":  # the bar holds it together
        under = under.body
    return Fraction(over, under, small)


# --- From SymPy ----------------------------------------------------------------------------------


def lettered(glyph: Glyph) -> Node:
    """A glyph as a node: ω²ₙ has its exponent above its index, det O is a function of O.

    >>> lettered(Glyph("ω²", "n")) == Superscript(Atom(Glyph("ω", "n")), Digits("2"))
    True
    """
    if glyph.base.isdigit() and glyph.base.isascii():
        return Digits(glyph.base)
    name, _, argument = glyph.base.partition(" ")
    if argument:
        return FunctionOf(name, (Atom(replace(glyph, base=argument)),), brackets=False)
    stem = glyph.base.rstrip("⁰¹²³⁴⁵⁶⁷⁸⁹")
    if stem == glyph.base:
        return Atom(glyph)
    exponent = unicodedata.normalize("NFKC", glyph.base.removeprefix(stem))
    return Superscript(Atom(replace(glyph, base=stem)), Digits(exponent))


def decimal(number: float, digits_shown: int = 6, *, kept: bool = False) -> Node:
    """A decimal number that is not negative, with a power of ten where it needs one.

    Zeros at its end are left out, if they are not to be `kept`.

    >>> decimal(0.25), decimal(0.25, 3, kept=True)
    (Digits(text='0.25'), Digits(text='0.250'))
    """
    digits, _, exponent = f"{number:{'#' * kept}.{digits_shown}g}".partition("e")
    digits = digits.rstrip(".")
    if not exponent:
        return Digits(digits)
    size = abs(int(exponent))
    power = Digits(str(size))
    ten = Superscript(Digits("10"), power if int(exponent) > 0 else negated(power))
    return ten if digits == "1" else Infix("×", Digits(digits), ten)
