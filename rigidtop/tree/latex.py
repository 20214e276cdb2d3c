r"""Formulas as LaTeX that reads back as the same nodes, with brackets where they are needed.

>>> from rigidtop.tree.nodes import Letter, Number, Power, Product, Sum, TimeDerivative
>>> x = Letter("x", "1")
>>> latex(Product((Number("2"), Sum((Power(TimeDerivative(x, dotted=True), Number("2")), x)))))
'2 \\left(\\dot{x}_{1}^{2} + x_{1}\\right)'
"""

from __future__ import annotations

import unicodedata
from collections.abc import Callable, Sequence
from typing import Final

from rigidtop.notation.characters import FUNCTIONS, MATHS, SIGNS
from rigidtop.tree import nodes as n
from rigidtop.tree.binding import ATOM, CROSS, DOT, FACTOR, PRODUCT, TERM, binding, is_dotted
from rigidtop.tree.nodes import Node, ungrouped
from rigidtop.tree.statement import Statement

_MARKS: Final = {
    "hat": r"\hat",
    "bar": r"\bar",
    "tilde": r"\tilde",
    "check": r"\check",
    "breve": r"\breve",
    "ring": r"\mathring",
    "acute": r"\acute",
}
_RAISED: Final = {"star": "^{*}", "dagger": r"^{\dagger}"}
_DOTS: Final = ("", r"\dot", r"\ddot", r"\dddot", r"\ddddot")
_PAIRS: Final = {"(": ("(", ")"), "[": ("[", "]"), "{": (r"\{", r"\}")}
_MATRICES: Final = {"(": "pmatrix", "[": "bmatrix", "{": "Bmatrix", "|": "vmatrix", "": "matrix"}
_COMMANDS: Final = frozenset(FUNCTIONS) - {"sn", "tr"}
_CLOSING: Final = frozenset("θφψϕϑt")
"""Letters behind which the argument of a function ends without brackets."""
_SIGNS: Final = {**MATHS, **SIGNS, "∈": r"\in", "−": "-"}


def latex(part: Node | Statement) -> str:
    """A node, or a statement with its conditions and its number, as LaTeX."""
    return _statement(part) if isinstance(part, Statement) else _WRITERS[type(part)](part)


def _statement(part: Statement) -> str:
    first, *others = map(latex, part.sides)
    pairs = zip(part.relations, others, strict=True)
    text = first + "".join(f" {_SIGNS[relation]} {side}" for relation, side in pairs)
    conditions = [f"({latex(each)})" for each in part.conditions]
    words = [rf"\text{{{part.condition}}}"] if part.condition else []
    tag = [rf"\tag{{{part.tag}}}"] if part.tag else []
    return r" \qquad ".join([text, *words, *conditions]) + " ".join(["", *tag])


def _within(part: Node, closeness: int) -> str:
    """A part, in brackets where it holds together less than what stands around it."""
    text = latex(part)
    return text if binding(part) >= closeness else _bracketed(text)


def _bracketed(text: str, bracket: str = "(") -> str:
    opens, closes = _PAIRS[bracket]
    return rf"\left{opens}{text}\right{closes}"


def _letter(part: n.Letter) -> str:
    text = _character(part.base)
    if part.bold:
        greek = text.startswith("\\") and len(part.base) == 1
        text = rf"\boldsymbol{{{text}}}" if greek else rf"\mathbf{{{part.base}}}"
    mark = part.mark.rstrip("′")
    if mark in _MARKS:
        text = f"{_MARKS[mark]}{{{text}}}"
    return text + _lowered(part.sub) + _RAISED.get(mark, "") + "'" * (len(part.mark) - len(mark))


def _character(base: str) -> str:
    if base == "d":
        return "{d}"  # not that of a derivative
    if base.startswith("Δ") and len(base) == 2:
        return rf"\Delta {_character(base[1])}"
    if len(base) > 1:
        return rf"\mathrm{{{base}}}"
    if base in MATHS or base.isascii():
        return MATHS.get(base, base)
    plain = unicodedata.normalize("NFKC", base)
    name = unicodedata.name(base, "")
    if plain == base:
        return base
    style = "mathfrak" if "FRAKTUR" in name or "BLACK-LETTER" in name else "mathcal"
    return rf"\{'mathbb' if 'DOUBLE-STRUCK' in name else style}{{{plain}}}"


def _lowered(sub: str) -> str:
    if not sub:
        return ""
    if sub.isascii() and sub.isalpha() and len(sub) > 2:
        return rf"_{{\text{{{sub}}}}}"
    return "_{" + " ".join(MATHS.get(each, each) for each in sub).replace(" '", "'") + "}"


def _sum(part: n.Sum) -> str:
    first, *others = part.terms
    text = _bracketed(latex(first)) if isinstance(first, n.Sum) else latex(first)
    for term in others:
        signed = isinstance(term, (n.Negative, n.PlusMinus))
        text += f" {latex(term)}" if signed else f" + {_within(term, TERM)}"
    return text.replace(" -", " - ")


def _product(part: n.Product) -> str:
    """Factors with spaces; a bracket is set off, lest it hold the place of a function."""
    text = ""
    for i, factor in enumerate(part.factors):
        written = _factor(factor)
        apart = written.startswith(r"\left") and not isinstance(part.factors[i - 1], n.Number)
        text += (r"\," if apart or isinstance(factor, n.Unit) else " ") * bool(i) + written
    return text


def _factor(part: Node) -> str:
    """A factor, of which a fraction with a bar needs no brackets."""
    if isinstance(part, n.Quotient) and not part.slash:
        return latex(part)
    return _within(part, FACTOR)


def _quotient(part: n.Quotient) -> str:
    if not part.slash:
        return rf"\frac{{{latex(ungrouped(part.over))}}}{{{latex(ungrouped(part.under))}}}"
    return f"{_within(part.over, PRODUCT)}/{_factor(part.under)}"


def _base(part: Node) -> str:
    """What stands below a power or in front of an index."""
    text = _within(part, ATOM)
    return f"{{{text}}}" if "^" in text and not text.startswith(r"\left") else text


def _power(part: n.Power) -> str:
    exponent = latex(ungrouped(part.exponent))
    if isinstance(part.base, n.Apply) and isinstance(part.exponent, n.Number):
        return f"{_function(part.base)}^{{{exponent}}} {_argument(part.base)}"
    if exponent in ("T", "*"):
        exponent = _bracketed(exponent, "[")
    return f"{_base(part.base)}^{{{exponent}}}"


def _function(part: n.Apply) -> str:
    name, _, base = part.name.partition("_")
    command = f"\\{name}" if name in _COMMANDS else rf"\operatorname{{{name}}}"
    return command + (f"_{{{base}}}" if base else "")


def _argument(part: n.Apply) -> str:
    of = ungrouped(part.of)
    close = isinstance(of, n.Letter) and of.base in _CLOSING
    return latex(of) if close else _bracketed(latex(of))


def _rate(part: n.TimeDerivative) -> str:
    if part.frame:
        whole = latex(n.TimeDerivative(part.of, part.order, part.dotted))
        return _bracketed(whole) + rf"_{{\text{{{part.frame}}}}}"
    if is_dotted(part):
        dots = _DOTS[part.order]
        if isinstance(part.of, n.Letter) and not part.of.mark.endswith(("′", "star", "dagger")):
            of = part.of
            return f"{dots}{{{latex(n.Letter(of.base, '', of.mark, of.bold))}}}{_lowered(of.sub)}"
        return f"{dots}{{{_within(part.of, ATOM + is_dotted(part.of))}}}"
    return _fraction("d", part.of, [n.Letter("t")] * part.order)


def _fraction(sign: str, of: Node, by: Sequence[Node]) -> str:
    order = f"^{{{len(by)}}}" if len(by) > 1 else ""
    under = " ".join(f"{sign} {_within(each, ATOM)}" for each in by)
    return rf"\frac{{{sign}{order} {_within(of, ATOM)}}}{{{under}}}"


def _differential(part: n.Differential) -> str:
    sign = r"\partial" if part.partial else r"\mathrm{d}"
    return sign + (f"^{{{part.order}}}" if part.order > 1 else "") + " " + _within(part.of, ATOM)


def _limits(lower: Node | None, upper: Node | None, index: str = "") -> str:
    start = "" if lower is None else latex(lower)
    below = f"_{{{index}{' = ' if index and start else ''}{start}}}" if index or start else ""
    return below + ("" if upper is None else f"^{{{latex(upper)}}}")


def _integral(part: n.Integral) -> str:
    of = _within(part.of, TERM)
    power = f"^{{{part.dimension}}}" if part.dimension > 1 else ""
    by = rf"\mathrm{{d}}{power} {_within(part.by, ATOM)}"
    return rf"\int{_limits(part.lower, part.upper)} {of}\,{by}"


def _total(part: n.Total) -> str:
    index = ",".join(map(latex, part.index))
    sign = r"\sum" if part.sign == "Σ" else r"\prod"
    return f"{sign}{_limits(part.lower, part.upper, index)} {_within(part.of, DOT)}"


def _matrix(part: n.Matrix) -> str:
    rows = r" \\ ".join(" & ".join(map(latex, row)) for row in part.rows)
    name = _MATRICES.get(part.bracket, "pmatrix")
    return rf"\begin{{{name}}} {rows} \end{{{name}}}"


def _at(part: n.At) -> str:
    where = rf"\text{{{part.sub}}}"
    if part.letter is not None and part.value is not None:
        where = f"{latex(part.letter)} = {latex(part.value)}"
    return rf"\left.{latex(part.of)}\right|_{{{where}}}"


def _braced(part: n.Braced) -> str:
    label = rf"\text{{{part.words}}}" if part.label is None else latex(part.label)
    return rf"\underbrace{{{latex(part.of)}}}_{{{label}}}"


def _primed(part: n.Primed) -> str:
    named = isinstance(part.of, n.Letter) and (part.of.mark or (part.of.bold and part.of.sub))
    text = _bracketed(latex(part.of)) if named else _base(part.of)
    return text + "'" * part.order


def _places(part: n.Call) -> str:
    return f"{_within(part.function, ATOM)}({', '.join(map(latex, part.places))})"


_PRODUCTS: Final = {"": "", "·": r"\cdot", "×": r"\times", "²": "^{2}"}
_WRITERS: Final[dict[type[Node], Callable[..., str]]] = {
    n.Letter: _letter,
    n.Number: lambda x: x.text,
    n.Unit: lambda x: r"^{\circ}" if x.name == "°" else rf"\mathrm{{{x.name}}}",
    n.Constant: lambda x: r"\text{const}",
    n.Omitted: lambda x: r"\dots",
    n.Sum: _sum,
    n.Negative: lambda x: f"-{_within(x.of, TERM)}",
    n.PlusMinus: lambda x: (r"\mp " if x.inverted else r"\pm ") + _within(x.of, TERM),
    n.Product: _product,
    n.Quotient: _quotient,
    n.Power: _power,
    n.Root: lambda x: (
        rf"\sqrt{'' if x.degree == 2 else f'[{x.degree}]'}{{{latex(ungrouped(x.of))}}}"
    ),
    n.Apply: lambda x: f"{_function(x)} {_argument(x)}",
    n.Call: _places,
    n.Bracketed: lambda x: _bracketed(latex(x.of), x.bracket),
    n.Absolute: lambda x: rf"\left|{latex(x.of)}\right|",
    n.Average: lambda x: rf"\left\langle {latex(x.of)}\right\rangle",
    n.TimeDerivative: _rate,
    n.Primed: _primed,
    n.Derivative: lambda x: _fraction(r"\partial" if x.partial else "d", x.of, x.by),
    n.Differential: _differential,
    n.Nabla: lambda x: rf"\nabla{_PRODUCTS[x.product]} {_within(x.of, ATOM)}",
    n.DotProduct: lambda x: rf"{_within(x.left, DOT)} \cdot {_within(x.right, CROSS)}",
    n.CrossProduct: lambda x: rf"{_within(x.left, CROSS)} \times {_within(x.right, PRODUCT)}",
    n.Tuple: lambda x: _bracketed(", ".join(map(latex, x.entries)), x.bracket),
    n.Matrix: _matrix,
    n.TransposedMatrix: lambda x: f"{_base(x.of)}^{{T}}",
    n.Component: lambda x: f"{_within(x.of, ATOM)}{_lowered(x.index)}",
    n.Integral: _integral,
    n.Total: _total,
    n.At: _at,
    n.Braced: _braced,
    n.Limit: lambda x: rf"\lim_{{{latex(x.letter)} \to {latex(x.place)}}} {_within(x.of, DOT)}",
    n.Remainder: lambda x: "O" + _bracketed(latex(ungrouped(x.of))),
}
