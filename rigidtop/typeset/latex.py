r"""LaTeX, for amsmath and amssymb.

>>> from sympy import cos, sin
>>> from rigidtop.theory.symbols import lambda1, phidot, theta, thetadot
>>> latex(lambda1 * (phidot**2 * sin(theta) ** 2 + thetadot**2) / 2)
'\\tfrac{1}{2}\\lambda_{1}(\\dot{\\phi}^{2}\\sin^{2}\\theta + \\dot{\\theta}^{2})'
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from sympy import Basic

from rigidtop.notation.characters import LETTERS, MARKS, MATHS, SIGNS, TEX_GREEK, escape, joined
from rigidtop.proof.equation import Equation
from rigidtop.theory.symbols import Glyph
from rigidtop.typeset import nodes as lay
from rigidtop.typeset import sizes
from rigidtop.typeset.layout import Order, layout
from rigidtop.typeset.nodes import Node
from rigidtop.typeset.sizes import DisplayLine

_ACCENTS = {"dot": r"\dot{%s}", "ddot": r"\ddot{%s}", "hat": r"\hat{%s}"}
_KNOWN = frozenset(
    ("sin", "cos", "tan", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "exp", "ln", "det")
)


def latex(tree: Basic, order: Order = "auto") -> str:
    r"""An expression, a matrix, a condition, or an `Equation` on one line, without its tag."""
    return _tex(tree if _is_node(tree) else layout(tree, order))


@dataclass(frozen=True)
class AlignRow:
    """An equation of an ``align``: its lines, its tag, the reason for it, in LaTeX.

    `mark` is a word that stands beside it in any case; `behind` follows the tag, `label` is the
    name by which it is cited.  Where it is `hung` its first line is its left side alone.
    """

    lines: tuple[DisplayLine, ...]
    tag: str = ""
    reason: str = ""
    mark: str = ""
    behind: str = ""
    label: str = ""
    hung: bool = False


def align(rows: Sequence[AlignRow], limit: float = sizes.LINE) -> str:
    r"""The ``align`` environment of some rows; ``align*`` if none has a tag."""
    star = "" if any(row.tag or row.behind for row in rows) else "*"
    beside = _all_fit_beside(rows, limit)
    lines: list[str] = []
    for i, row in enumerate(rows):
        if row.reason and not beside and lines:
            lines[-1] += _intertext(row.reason)
        for j, tex in enumerate(row_lines(row)):
            last = j == len(row.lines) - 1
            words = " ".join(filter(None, [row.reason if beside else "", row.mark]))
            if last and words:
                tex += rf" && \text{{{words}}}"
            if last and row.behind:
                number = f"({row.tag})" if row.tag else ""
                tex += rf" \tag*{{{number}{row.behind}}}"
            elif last and row.tag:
                tex += rf" \tag{{{row.tag}}}"
            elif not star:
                tex += r" \notag"
            if last and row.label:
                tex += rf"\label{{{row.label}}}"
            # A page may end between equations, not within one.
            lines.append(tex + (r" \\*" if not last else r" \\" * (i < len(rows) - 1)))
    # What stands above the first line is a paragraph of its own.
    before = rows[0].reason + "\n" if rows[0].reason and not beside else ""
    body = "\n".join(lines)
    return f"{before}\\begin{{align{star}}}\n{body}\n\\end{{align{star}}}"


def _intertext(words: str) -> str:
    return "\n" + rf"\intertext{{{words}}}"


def _all_fit_beside(rows: Sequence[AlignRow], limit: float) -> bool:
    """Whether all reasons fit into a column right of the widest line.

    A sentence that ends in a colon, or with a note, stands in front of its equation.
    """
    if any(row.reason.endswith((":", "}")) for row in rows):
        return False
    widest = max(_line_width(line) for row in rows for line in row.lines)
    longest = max(0.8 * len(seen(row.reason) + row.mark) + (8 if row.tag else 0) for row in rows)
    return widest + longest + 4 < limit


def seen(tex: str) -> str:
    """About as many characters as are seen of words in LaTeX."""
    return re.sub(r"\\[A-Za-z]+|[{}$^_]", "", tex)


def row_lines(row: AlignRow) -> list[str]:
    """Each line of a row with its alignment mark."""
    first, *rest = map(align_row, row.lines)
    if row.hung:
        return [f"& {_tex(row.lines[0].right)}", *(rf"&\quad {line[1:]}" for line in rest)]
    return [first, *rest]


def align_row(line: DisplayLine) -> str:
    """One line with its alignment mark."""
    left = _tex(line.left) + " " if line.left is not None else ""
    sign = SIGNS[line.sign] + " " if line.sign else r"\quad {}"
    return f"{left}&{sign}{_tex(line.right)}"


def aligned_lines(
    equations: Iterable[Equation], order: Order = "auto", limit: float = sizes.LINE
) -> list[str]:
    """The lines of equations, broken to so many letters, each with its alignment mark."""
    return [align_row(line) for each in equations for line in sizes.lines(each, order, limit)]


def aligned(lines: Sequence[str]) -> str:
    """Lines below each other; unlike an ``align`` this may stand between dollars."""
    # A bracket at the start of a line would be read as an option.
    safe = ["{}" + line if line.startswith("[") else line for line in lines]
    return "\\begin{aligned}\n" + " \\\\\n".join(safe) + "\n\\end{aligned}"


def _line_width(line: DisplayLine) -> float:
    left = sizes.width(line.left) if line.left is not None else 0
    return left + 3 + sizes.width(line.right)


def _is_node(tree: Basic) -> bool:
    return type(tree).__module__ == lay.__name__


# --- Letters -------------------------------------------------------------------------------------


def letter(glyph: Glyph) -> str:
    r"""A symbol: ``\dot{\omega}_{1}``, ``\mathbf{e}_{1}'``.

    >>> print(letter(Glyph("ω", "1", "dot")), letter(Glyph("e", "2", bold=True, prime=True)))
    \dot{\omega}_{1} \mathbf{e}_{2}'
    """
    before, glyph = lay.differential(glyph)
    if before:
        head = {"d": r"\mathrm{d}"}.get(before[0], TEX_GREEK.get(before[0], before[0]))
        raised = f"^{{{unicodedata.normalize('NFKC', before[1:])}}}" if before[1:] else ""
        return joined(head + raised, letter(glyph))
    base = _base(glyph.base)
    if len(glyph.base) > 1 and glyph.base.isascii():
        base = rf"\text{{{escape(glyph.base)}}}"
    elif glyph.bold:
        base = rf"\boldsymbol{{{base}}}" if glyph.base in TEX_GREEK else rf"\mathbf{{{base}}}"
    if glyph.accent:
        base = _ACCENTS[glyph.accent] % base
    if glyph.sub:
        base += f"_{{{_subscript(glyph.sub)}}}"
    return base + ("'" if glyph.prime else "")


_STYLES = {"SCRIPT": "mathcal", "DOUBLE-STRUCK": "mathbb", "FRAKTUR": "mathfrak"}
_MARKS = MARKS | {
    "\u0304": r"\bar{%s}",
    "\u0303": r"\tilde{%s}",
    "\u030c": r"\check{%s}",
    "\u0306": r"\breve{%s}",
    "\u030a": r"\mathring{%s}",
}


def can_be_set(glyph: Glyph) -> bool:
    """Whether every document has a way to write a letter: Latin, Greek, one of the tables.

    >>> can_be_set(Glyph("ω", "1", "dot")), can_be_set(Glyph("ж")), can_be_set(Glyph("x", "🙂"))
    (True, False, False)
    """
    base = unicodedata.normalize("NFD", lay.differential(glyph)[1].base)
    return all(
        c in LETTERS or c in MATHS or c in _MARKS or (c.isascii() and c.isprintable()) or _styled(c)
        for c in base + unicodedata.normalize("NFD", glyph.sub)
    )


def _styled(c: str) -> str:
    """The command for a letter of another style, such as ℒ."""
    name = unicodedata.name(c, "")
    return next((tex for word, tex in _STYLES.items() if word in name), "")


def _base(base: str) -> str:
    """A letter with what is one with it: bars, primes, stars, another style."""
    tex = ""
    for c in unicodedata.normalize("NFD", base):
        if c in _MARKS:
            tex = _MARKS[c] % tex
            continue
        plain, style = unicodedata.normalize("NFKC", c), _styled(c)
        if c not in LETTERS and style and plain != c:
            tex += rf"\{style}{{{plain}}}"
        else:
            tex = joined(tex, LETTERS.get(c, MATHS.get(c, c)))
    return tex


def _subscript(sub: str) -> str:
    plain = sub.rstrip("′")
    primes = "'" * (len(sub) - len(plain))
    if len(plain) > 1 and plain.isalpha() and not set(plain) <= set("xyzijkl"):
        return rf"\text{{{plain}}}" + primes
    return "".join(MATHS.get(c, c) for c in plain) + primes


# --- Nodes ---------------------------------------------------------------------------------------


def _tex(node: lay.Node) -> str:
    match node:
        case lay.Digits():
            return LETTERS.get(node.text, node.text)
        case lay.Atom():
            return letter(node.glyph)
        case lay.Terms():
            terms = (sign.replace("−", "-") + _tex(body) for sign, body in node.signed())
            return "".join(terms).lstrip()
        case lay.Factors():
            text = _tex(node.factors[0])
            for joint, factor in zip(node.joints, node.factors[1:], strict=True):
                text = joined(text + _JOINTS[joint], _tex(factor))
            return text
        case lay.Fraction():
            command = r"\tfrac" if node.small else r"\frac"
            return rf"{command}{{{_tex(node.over)}}}{{{_tex(node.under)}}}"
        case lay.Superscript():
            return f"{_tex(node.base)}^{{{_tex(node.exponent)}}}"
        case lay.Radical():
            index = f"[{node.index}]" if node.index else ""
            return rf"\sqrt{index}{{{_tex(node.body)}}}"
        case lay.FunctionOf():
            if isinstance(node.name, lay.Atom):
                name = _tex(node.name)
            else:
                name = "\\" + node.name if node.name in _KNOWN else rf"\operatorname{{{node.name}}}"
            if node.power is not None:
                name += f"^{{{_tex(node.power)}}}"
            inside = ", ".join(map(_tex, node.arguments))
            return (
                name + _enclosed(inside, "()", node.arguments)
                if node.brackets
                else joined(name, inside)
            )
        case lay.Brackets():
            return _enclosed(_tex(node.body), node.shape, [node.body])
        case lay.BraceBelow():
            return rf"\underbrace{{{_tex(node.body)}}}_{{\equiv {_tex(node.label)}}}"
        case lay.Infix():
            left = _tex(node.left) if node.left else ""
            return f"{left} {SIGNS[node.sign]} {_tex(node.right)}"
        case lay.TransposeOf():
            return f"{_tex(node.body)}^{{T}}"
        case lay.DifferentialQuotient():
            d = r"\partial" if node.partial else "d"
            order = f"^{{{node.order}}}" if node.order > 1 else ""
            over, under = d + order, joined(d, _tex(node.by)) + order
            if node.inside:
                text = rf"\frac{{{joined(over, _tex(node.body))}}}{{{under}}}"
            else:
                text = rf"\frac{{{over}}}{{{under}}}{_tex(node.body)}"
            if node.frame:
                return rf"\left({text}\right)_{{\text{{{escape(node.frame)}}}}}"
            return text
        case lay.Big():
            index = "" if node.index is None else _tex(node.index)
            if node.limits is not None:
                start, *end = map(_tex, node.limits)
                below = f"{index}={start}" if index else start
                above = f"^{{{end[0]}}}" if end else ""
                return rf"{SIGNS[node.sign]}_{{{below}}}{above} {_tex(node.body)}"
            if node.sign == "∫":
                return rf"\int{index}\,{_tex(node.body)}" if index else rf"\int {_tex(node.body)}"
            return rf"\sum_{{{index}}} {_tex(node.body)}" if index else rf"\sum {_tex(node.body)}"
        case lay.IntegralMeasure():
            if node.bounds:
                low, high = map(_tex, node.bounds)
                return f"_{{{low}}}^{{{high}}} d{_tex(node.variable)}"
            return f" d^{{{node.dimension}}}{_tex(node.variable)}"
        case lay.Grid():
            rows = r" \\ ".join(" & ".join(map(_tex, row)) for row in node.rows)
            return rf"\begin{{bmatrix}} {rows} \end{{bmatrix}}"
        case lay.Enumeration():
            between = ", " if node.between == "," else rf" \quad\text{{{node.between}}}\quad "
            return between.join(map(_tex, node.items))
        case lay.Chain():
            rest = zip(node.signs, node.sides[1:], strict=True)
            return _tex(node.sides[0]) + "".join(
                f" {SIGNS[sign]} {_tex(side)}" for sign, side in rest
            )


_JOINTS = {"": "", "function": "", "thin": r"\,", "dot": r" \cdot "}


def _enclosed(inside: str, shape: str, nodes: Sequence[Node]) -> str:
    if "." in shape:  # no \left and \right on two lines
        size = r"\Big" if any(map(sizes.is_tall, nodes)) else ""
        left, right = ("" if mark == "." else size + side * bool(size) + mark
                       for side, mark in zip("lr", shape, strict=True))  # fmt: skip
        return left + inside + right
    if any(map(sizes.is_tall, nodes)):
        return rf"\left{shape[0]}{inside}\right{shape[1]}"
    left, right = (r"\lvert ", r"\rvert") if shape == "||" else (shape[0], shape[1])
    return left + inside + right
