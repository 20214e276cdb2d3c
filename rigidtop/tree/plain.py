"""Formulas as plain text: ½ m ẋ² − m g y, ∂L/∂θ̇, √(a + b).

>>> from rigidtop.tree.nodes import Letter, Number, Power, Quotient, Sum, TimeDerivative
>>> x = Letter("x")
>>> plain(Sum((Power(TimeDerivative(x, dotted=True), Number("2")), Quotient(Number("1"), x))))
'ẋ² + 1/x'
"""

from __future__ import annotations

import unicodedata
from collections.abc import Callable
from typing import Final

from rigidtop.notation.characters import HALVES, SUBSCRIPTS, SUPERSCRIPTS
from rigidtop.tree import nodes as n
from rigidtop.tree.binding import ATOM, CROSS, DOT, FACTOR, PRODUCT, TERM, binding, is_dotted
from rigidtop.tree.nodes import Node
from rigidtop.tree.statement import Statement

_RAISED: Final = {sign: raised for raised, sign in SUPERSCRIPTS.items()} | {"−": "⁻"}
_LOWERED: Final = {sign: lowered for lowered, sign in SUBSCRIPTS.items()}
_FRACTIONS: Final = {
    tuple(tex.removeprefix(r"\tfrac{").rstrip("}").split("}{")): sign
    for sign, tex in HALVES.items()
}
_ABOVE: Final = {
    "hat": "\u0302",
    "bar": "\u0304",
    "tilde": "\u0303",
    "check": "\u030c",
    "breve": "\u0306",
    "ring": "\u030a",
    "acute": "\u0301",
    "star": "*",
    "dagger": "†",
}
_DOTS: Final = ("", "\u0307", "\u0308", "\u20db", "\u20dc")
_CLOSES: Final = {"(": ")", "[": "]", "{": "}", "⟨": "⟩", "|": "|", "": ""}


def plain(part: Node | Statement) -> str:
    """A node, or a statement with its conditions, as a line of text."""
    return _statement(part) if isinstance(part, Statement) else _WRITERS[type(part)](part)


def _statement(part: Statement) -> str:
    first, *others = map(plain, part.sides)
    text = first + "".join(f" {r} {s}" for r, s in zip(part.relations, others, strict=True))
    conditions = [f"({plain(each)})" for each in part.conditions]
    return "  ".join([text, *conditions])


def within(part: Node, closeness: int) -> str:
    """A part, in brackets where it holds together less than what stands around it."""
    text = plain(part)
    return text if binding(part) >= closeness else f"({text})"


def _letter(part: n.Letter) -> str:
    mark = part.mark.rstrip("′")
    text = part.base + _ABOVE.get(mark, mark)
    return unicodedata.normalize("NFC", text) + _lowered(part.sub) + part.mark[len(mark) :]


def _lowered(sub: str) -> str:
    if not sub:
        return ""
    if all(each in _LOWERED for each in sub):
        return "".join(_LOWERED[each] for each in sub)
    return f"_{sub}" if len(sub) == 1 or sub.isalnum() else f"_{{{sub}}}"


def _sum(part: n.Sum) -> str:
    first, *others = part.terms
    text = f"({plain(first)})" if isinstance(first, n.Sum) else plain(first)
    for term in others:
        if isinstance(term, n.Negative):
            text += f" − {within(term.of, TERM)}"
        elif isinstance(term, n.PlusMinus):
            text += f" {'∓' if term.inverted else '±'} {within(term.of, TERM)}"
        else:
            text += f" + {within(term, TERM)}"
    return text


def _product(part: n.Product) -> str:
    """Factors with spaces; the last may be a sum over an index, which goes on to the end."""
    *first, last = part.factors
    return " ".join([*(within(each, PRODUCT) for each in first), _last(last)])


def _last(part: Node) -> str:
    return plain(part) if isinstance(part, n.Total) else within(part, PRODUCT)


def _quotient(part: n.Quotient) -> str:
    numbers = (plain(part.over), plain(part.under))
    if numbers in _FRACTIONS:
        return _FRACTIONS[numbers]
    return f"{within(part.over, PRODUCT)}/{within(part.under, FACTOR)}"


def _power(part: n.Power) -> str:
    exponent = plain(part.exponent)
    raised = all(each in _RAISED for each in exponent)
    if isinstance(part.base, n.Apply) and raised:
        text = _apply(part.base)
        return text[: len(part.base.name)] + _raised(exponent) + text[len(part.base.name) :]
    base = within(part.base, ATOM)
    if raised:
        return base + _raised(exponent)
    return f"{base}^{exponent}" if len(exponent) == 1 else f"{base}^({exponent})"


def _apply(part: n.Apply) -> str:
    close = isinstance(part.of, (n.Letter, n.Number)) or is_dotted(part.of)
    return f"{part.name} {plain(part.of)}" if close else f"{part.name}({plain(part.of)})"


def _rate(part: n.TimeDerivative) -> str:
    if is_dotted(part):
        if isinstance(part.of, n.Letter):
            base = part.of.base + _ABOVE.get(part.of.mark, "") + _DOTS[part.order]
            return unicodedata.normalize("NFC", base) + _lowered(part.of.sub)
        if isinstance(part.of, n.Primed):
            return _rate(n.TimeDerivative(part.of.of, part.order, True)) + "′" * part.of.order
        return f"({plain(part.of)}){_DOTS[part.order]}"
    order = "" if part.order == 1 else _raised(part.order)
    text = f"d{order}{within(part.of, ATOM)}/dt{order}"
    return f"({text})_{part.frame}" if part.frame else text


def _raised(written: object) -> str:
    return "".join(_RAISED[each] for each in str(written))


def _derivative(part: n.Derivative) -> str:
    sign = "∂" if part.partial else "d"
    order = _raised(len(part.by)) if len(part.by) > 1 else ""
    by = "".join(sign + within(each, ATOM) for each in part.by)
    if len(part.by) > 1 and len(set(part.by)) == 1:
        by = f"{sign}{within(part.by[0], ATOM)}{order}"
    return f"{sign}{order}{within(part.of, ATOM)}/{by}"


def _limits(lower: Node | None, upper: Node | None, index: str = "") -> str:
    start = "" if lower is None else plain(lower)
    below = f"_{{{index}{'=' if index and start else ''}{start}}}" if index or start else ""
    return below + ("" if upper is None else f"^{{{plain(upper)}}}")


def _integral(part: n.Integral) -> str:
    limits = _limits(part.lower, part.upper)
    power = _raised(part.dimension) if part.dimension > 1 else ""
    return f"∫{limits} {within(part.of, DOT)} d{power}{within(part.by, ATOM)}"


def _total(part: n.Total) -> str:
    index = ",".join(map(plain, part.index))
    return f"{part.sign}{_limits(part.lower, part.upper, index)} {within(part.of, DOT)}"


def _matrix(part: n.Matrix) -> str:
    rows = "; ".join(", ".join(map(plain, row)) for row in part.rows)
    return f"{part.bracket or '('}{rows}{_CLOSES[part.bracket or '(']}"


def _at(part: n.At) -> str:
    where = part.sub
    if part.letter is not None and part.value is not None:
        where = f"{plain(part.letter)} = {plain(part.value)}"
    return f"{within(part.of, FACTOR)}|_{{{where}}}"


def _braced(part: n.Braced) -> str:
    label = part.words if part.label is None else plain(part.label)
    return f"{within(part.of, ATOM)}⟦{label}⟧"


_WRITERS: Final[dict[type[Node], Callable[..., str]]] = {
    n.Letter: _letter,
    n.Number: lambda x: x.text,
    n.Unit: lambda x: x.name,
    n.Constant: lambda x: "const",
    n.Omitted: lambda x: "…",
    n.Sum: _sum,
    n.Negative: lambda x: f"−{within(x.of, TERM)}",
    n.PlusMinus: lambda x: ("∓" if x.inverted else "±") + within(x.of, TERM),
    n.Product: _product,
    n.Quotient: _quotient,
    n.Power: _power,
    n.Root: lambda x: ("" if x.degree == 2 else _raised(x.degree)) + f"√({plain(x.of)})",
    n.Apply: _apply,
    n.Call: lambda x: f"{within(x.function, FACTOR)}({', '.join(map(plain, x.places))})",
    n.Bracketed: lambda x: x.bracket + plain(x.of) + _CLOSES[x.bracket],
    n.Absolute: lambda x: f"|{plain(x.of)}|",
    n.Average: lambda x: f"⟨{plain(x.of)}⟩",
    n.TimeDerivative: _rate,
    n.Primed: lambda x: within(x.of, ATOM) + "′" * x.order,
    n.Derivative: _derivative,
    n.Differential: lambda x: (
        ("∂" if x.partial else "d") + (_raised(x.order) if x.order > 1 else "") + within(x.of, ATOM)
    ),
    n.Nabla: lambda x: "∇" + x.product + (" " if x.product else "") + within(x.of, FACTOR),
    n.DotProduct: lambda x: f"{within(x.left, DOT)} · {within(x.right, CROSS)}",
    n.CrossProduct: lambda x: f"{within(x.left, CROSS)} × {within(x.right, PRODUCT)}",
    n.Tuple: lambda x: f"{x.bracket}{', '.join(map(plain, x.entries))}{_CLOSES[x.bracket]}",
    n.Matrix: _matrix,
    n.TransposedMatrix: lambda x: within(x.of, ATOM) + "ᵀ",
    n.Component: lambda x: within(x.of, ATOM) + _lowered(x.index),
    n.Integral: _integral,
    n.Total: _total,
    n.At: _at,
    n.Braced: _braced,
    n.Limit: lambda x: f"lim_{{{plain(x.letter)}→{plain(x.place)}}} {within(x.of, TERM)}",
    n.Remainder: lambda x: f"O({plain(x.of)})",
}
