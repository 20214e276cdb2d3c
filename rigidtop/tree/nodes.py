r"""The kinds of nodes: letters and numbers, sums, products, derivatives, vectors, integrals.

>>> x = Letter("x")
>>> line = Sum((Quotient(Number("1"), Number("2")), Negative(Power(x, Number("2")))))
>>> replaced(line, x, Letter("y")).terms[1]
Negative(of=Power(base=Letter(base='y', sub='', mark='', bold=False), exponent=Number(text='2')))
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, fields, replace
from fractions import Fraction
from functools import cache, lru_cache


class Node:
    """A part of a formula; each kind of part is a subclass."""

    __slots__ = ()


@dataclass(frozen=True, slots=True)
class Letter(Node):
    """A letter with what belongs to its name: x, θ, m_1, **e**_3′, λ̄, V_eff.

    `base` is a character or a word, Greek as itself; `sub` what stands below, as text; `mark` is
    "hat", "bar", "tilde", "star" or primes that belong to the name.  A dot is a
    `TimeDerivative`, and an arrow above makes it bold.
    """

    base: str
    sub: str = ""
    mark: str = ""
    bold: bool = False


@dataclass(frozen=True, slots=True)
class Number(Node):
    """A number as it is written: 2, 0.80."""

    text: str

    @property
    def value(self) -> Fraction:
        return Fraction(self.text)


@dataclass(frozen=True, slots=True)
class Unit(Node):
    """A unit, such as kg, written upright behind a number."""

    name: str


@dataclass(frozen=True, slots=True)
class Constant(Node):
    """The word "const" as a side of an equation."""


@dataclass(frozen=True, slots=True)
class Omitted(Node):
    """Three dots for what is left out."""


@dataclass(frozen=True, slots=True)
class Sum(Node):
    """Terms, of which those with a minus are `Negative` and those with ± are `PlusMinus`."""

    terms: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Negative(Node):
    of: Node


@dataclass(frozen=True, slots=True)
class PlusMinus(Node):
    """± or, where it is `inverted`, ∓."""

    of: Node
    inverted: bool = False


@dataclass(frozen=True, slots=True)
class Product(Node):
    """A product of factors that are written side by side."""

    factors: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Quotient(Node):
    """A fraction; `slash` where it is written in a line."""

    over: Node
    under: Node
    slash: bool = False


@dataclass(frozen=True, slots=True)
class Power(Node):
    base: Node
    exponent: Node


@dataclass(frozen=True, slots=True)
class Root(Node):
    of: Node
    degree: int = 2


@dataclass(frozen=True, slots=True)
class Apply(Node):
    """A named function: sin, cos, tan, cot, sec, csc, arcsin, …, exp, ln, sinh, Re, Im, det, tr."""

    name: str
    of: Node


@dataclass(frozen=True, slots=True)
class Call(Node):
    """A letter as a function at a place: V(r), θ(t), x(0), f(x, y)."""

    function: Node
    places: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Bracketed(Node):
    """What stands in brackets: "(", "[" or "{"."""

    of: Node
    bracket: str = "("


@dataclass(frozen=True, slots=True)
class Absolute(Node):
    """|x|, or the length of a vector."""

    of: Node


@dataclass(frozen=True, slots=True)
class Average(Node):
    """An average in angle brackets: ⟨x⟩."""

    of: Node


@dataclass(frozen=True, slots=True)
class TimeDerivative(Node):
    """A derivative in time: a dot, or d/dt; `frame` is the word below a bracket, such as "body"."""

    of: Node
    order: int = 1
    dotted: bool = False
    frame: str = ""


@dataclass(frozen=True, slots=True)
class Primed(Node):
    """A function or a letter with primes: V′(x), θ″; whose derivative that is, is not said."""

    of: Node
    order: int = 1


@dataclass(frozen=True, slots=True)
class Derivative(Node):
    """∂L/∂θ̇, ∂²L/∂x∂y, or d by something else than the time (`partial` is false)."""

    of: Node
    by: tuple[Node, ...]
    partial: bool = True


@dataclass(frozen=True, slots=True)
class Differential(Node):
    """dx, d²r or ∂x that stands alone; in an integral or a derivative it is part of that."""

    of: Node
    order: int = 1
    partial: bool = False


@dataclass(frozen=True, slots=True)
class Nabla(Node):
    """∇V; with `product` "·" or "×" a divergence or a curl, "²" the Laplacian."""

    of: Node
    product: str = ""


@dataclass(frozen=True, slots=True)
class DotProduct(Node):
    """Two factors with a point between them: numbers, or vectors."""

    left: Node
    right: Node


@dataclass(frozen=True, slots=True)
class CrossProduct(Node):
    """Two factors with × between them: numbers, or vectors."""

    left: Node
    right: Node


@dataclass(frozen=True, slots=True)
class Tuple(Node):
    """Entries in one pair of brackets with commas: a vector, or a list of arguments."""

    entries: tuple[Node, ...]
    bracket: str = "("


@dataclass(frozen=True, slots=True)
class Matrix(Node):
    """Rows of entries; one column is a vector."""

    rows: tuple[tuple[Node, ...], ...]
    bracket: str = "("


@dataclass(frozen=True, slots=True)
class TransposedMatrix(Node):
    of: Node


@dataclass(frozen=True, slots=True)
class Component(Node):
    """One component of a vector that is no letter: (ω × L)₁."""

    of: Node
    index: str


@dataclass(frozen=True, slots=True)
class Integral(Node):
    """An integral over a letter; without limits both are None; "loop" where it is closed.

    Over space there are as many differentials as `dimension` says: ∫ d³r.
    """

    of: Node
    by: Node
    lower: Node | None = None
    upper: Node | None = None
    dimension: int = 1


@dataclass(frozen=True, slots=True)
class Total(Node):
    """A sum over an index, Σ_i; `sign` is "Σ" or "Π"."""

    of: Node
    index: tuple[Letter, ...]
    lower: Node | None = None
    upper: Node | None = None
    sign: str = "Σ"


@dataclass(frozen=True, slots=True)
class At(Node):
    """A bar with what is put in below it: ∂V/∂x |_{x = 0}; `sub` is what else stands there."""

    of: Node
    letter: Node | None = None
    value: Node | None = None
    sub: str = ""


@dataclass(frozen=True, slots=True)
class Braced(Node):
    """A part with a brace below or above it, and what is written there."""

    of: Node
    label: Node | None = None
    words: str = ""


@dataclass(frozen=True, slots=True)
class Limit(Node):
    """lim of something as a letter goes to a place."""

    of: Node
    letter: Node
    place: Node


@dataclass(frozen=True, slots=True)
class Remainder(Node):
    """The terms that are left out, such as O(ε²)."""

    of: Node


def parts(node: Node) -> tuple[Node, ...]:
    """The nodes right below a node, in the order in which they are written."""
    below: list[Node] = []
    for name in _branches(node.__class__):  # type: ignore[arg-type]
        value = getattr(node, name)
        if isinstance(value, tuple):
            _collect(value, below)
        elif isinstance(value, Node):
            below.append(value)
    return tuple(below)


def rebuilt(node: Node, others: Sequence[Node]) -> Node:
    """The same kind of node with other parts, as many as `parts` gives."""
    left = iter(others)
    changed = {
        name: _filled(value, left)
        for name, value in zip(_names(node.__class__), _values(node), strict=True)  # type: ignore[arg-type]
        if isinstance(value, (Node, tuple))
    }
    return replace(node, **changed) if changed else node  # type: ignore[type-var]


def walked(node: Node) -> Iterator[Node]:
    """The node and all that are below it, from the outside in."""
    ahead = [node]
    while ahead:
        here = ahead.pop()
        yield here
        ahead += reversed(parts(here))


def mapped(node: Node, change: Callable[[Node], Node]) -> Node:
    """The tree with `change` made of every node, from the inside out."""
    below = parts(node)
    others = [mapped(part, change) for part in below]
    same = all(part is other for part, other in zip(below, others, strict=True))
    return change(node if same else rebuilt(node, others))


def replaced(node: Node, old: Node, new: Node) -> Node:
    """The tree with another node wherever `old` stands."""
    return mapped(node, lambda each: new if each == old else each)


@lru_cache(maxsize=20_000)
def letters(node: Node) -> frozenset[Letter]:
    """The set of all letters that occur in a tree."""
    return frozenset(each for each in walked(node) if isinstance(each, Letter))


def ungrouped(node: Node) -> Node:
    """What stands in brackets, without them."""
    while isinstance(node, Bracketed):
        node = node.of
    return node


def _values(node: Node) -> list[object]:
    return [getattr(node, name) for name in _names(node.__class__)]  # type: ignore[arg-type]


@cache
def _names(kind: type) -> tuple[str, ...]:
    return tuple(field.name for field in fields(kind))


@cache
def _branches(kind: type) -> tuple[str, ...]:
    """The fields of a kind of node in which nodes may stand: a tree is walked very often."""
    return tuple(x.name for x in fields(kind) if x.type not in ("str", "bool", "int"))


def _collect(value: object, below: list[Node]) -> None:
    if isinstance(value, Node):
        below.append(value)
    elif isinstance(value, tuple):
        for each in value:
            _collect(each, below)


def _filled(value: object, left: Iterator[Node]) -> object:
    if isinstance(value, Node):
        return next(left)
    if isinstance(value, tuple):
        return tuple(_filled(each, left) for each in value)
    return value
