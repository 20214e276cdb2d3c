"""Native presentation MathML, within what browsers share (MathML Core).

Bold upright vectors carry their style with them, so that a fragment needs no style sheet and no
font with a bold alphabet.  ``alttext`` is the equation as `rigidtop.typeset.text` writes it.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from html import escape
from typing import Any

from sympy import Basic

from rigidtop.notation.characters import GREEK
from rigidtop.proof.equation import Equation
from rigidtop.theory.symbols import Glyph
from rigidtop.typeset import nodes as lay
from rigidtop.typeset import sizes
from rigidtop.typeset.layout import Order, layout
from rigidtop.typeset.sizes import DisplayLine
from rigidtop.typeset.text import text

# Not accent="true": browsers then lay a dot into the letter beneath it.
_ACCENTS = {
    "dot": '<mo scriptlevel="0">˙</mo>',
    "ddot": '<mo scriptlevel="0">¨</mo>',
    "hat": '<mo stretchy="false">^</mo>',
}
_SHAPES = {"φ": "ϕ"}  # as LaTeX draws them
_VECTOR = ' mathvariant="normal" style="font-weight:bold"'
_BOLD_GREEK = ' style="font-weight:bold"'
THIN = '<mspace width="0.1667em"/>'
STRUT = '<mspace height="0.75em" depth="0.4em"/>'
APPLY = "<mo>&#x2061;</mo>"


def mathml(tree: Basic, order: Order = "auto", *, display: bool = False) -> str:
    """A ``<math>`` element for an expression, a condition, or an `Equation` without its tag."""
    node = tree if type(tree).__module__ == lay.__name__ else layout(tree, order)
    return element(_ml(node), text(node), display)


def display(equations: Sequence[Equation], order: Order = "auto", limit: float = sizes.LINE) -> str:
    """A block ``<math>``: the lines of the equations, aligned at their relation signs.

    Where the left sides leave no room for that, what follows them is hung beneath them, unless
    that gains nothing, beneath a letter.
    """
    broken = [line for equation in equations for line in sizes.lines(equation, order, limit)]
    alt = "; ".join(text(equation, order) for equation in equations)
    left = max(sizes.width(line.left) for line in broken if line.left)
    aligned = left + 3 + max(sizes.width(line.right) for line in broken) <= SPARE * limit
    if aligned and len(broken) == 1:
        return element(_ml(layout(equations[0], order)), alt, True)
    rows = "".join(_row(line) if aligned else _hung(line, limit) for line in broken)
    return element(f'<mtable displaystyle="true">{rows}</mtable>', alt, True)


SPARE = 1.15
"""A screen's line has room for a little more letters than its limit says."""
INSET = 2
"""By how many em a line stands in that is hung beneath another."""


def _row(line: DisplayLine) -> str:
    left = _ml(line.left) if line.left is not None else ""
    sign = _sign(line) or '<mspace width="2em"/>'
    return f"<mtr>{_cell(left, 'right')}{_cell(_group(f'<mi></mi>{sign}{_ml(line.right)}'))}</mtr>"


def _hung(line: DisplayLine, limit: float) -> str:
    right = _group(_sign(line) + _ml(line.right))
    if line.left is None:
        return f"<mtr>{_cell(right, inset=INSET)}</mtr>"
    left = _ml(line.left)
    left_side = sizes.width(line.left)
    if left_side > INSET and left_side + 3 + sizes.width(line.right) > SPARE * limit:
        return f"<mtr>{_cell(left)}</mtr><mtr>{_cell(right, inset=INSET)}</mtr>"
    return f"<mtr>{_cell(_group(left + right))}</mtr>"


def _sign(line: DisplayLine) -> str:
    return f'<mo form="infix">{escape(line.sign)}</mo>' if line.sign else ""


def _cell(inside: str, side: str = "left", inset: int = 0) -> str:
    return f'<mtd style="text-align:{side};padding:0.25em 0 0.25em {inset}em">{inside}</mtd>'


def element(inside: str, alt: str, block: bool) -> str:
    """The ``<math>`` round its inside; `alt` says it in words."""
    attribute = ' display="block"' if block else ""
    return (
        f'<math xmlns="http://www.w3.org/1998/Math/MathML"{attribute} alttext="{escape(alt)}">'
        f"{inside}</math>"
    )


# No place is looked at twice: a page has five million.
_BESIDE = re.compile(
    r"((?<![^ \n<>])[^ \n<>]++|)"
    r"(<math(?![^>]*display=)(?:[^<]++|<(?!/math>))*+</math>)"
    r"([^ \n<]*)"
)


def held(html: str) -> str:
    """HTML in which no line ends between a formula and the comma, bracket or unit beside it.

    Browsers break a line there, as they do beside a picture.
    """
    return _BESIDE.sub(lambda m: f'<span class="m">{m[0]}</span>' if m[1] or m[3] else m[0], html)


def labelled(sides: Sequence[tuple[Sequence[Any], int | None]], alt: str) -> str:
    """A block ``<math>`` of an equation, each term in an ``<mrow>`` that says which it is.

    A side is its terms as layout nodes and the number of the first, ``data-term``; terms without a
    number are plain.
    """
    row = ""
    for place, (nodes, number) in enumerate(sides):
        row += "<mo>=</mo>" if place else ""
        for k, node in enumerate(nodes):
            negative = isinstance(node, lay.Terms) and len(node.terms) == 1
            inside = _ml(node.terms[0].body) if negative else _ml(node)
            form = "infix" if k else "prefix"
            if k or negative:
                inside = f'<mo form="{form}">{"−" if negative else "+"}</mo>{inside}'
            mark = "" if number is None else f' data-term="{number + k}"'
            row += f"<mrow{mark}>{inside}</mrow>"
    return element(row, alt, True)


def letter(glyph: Glyph) -> str:
    """A symbol as MathML, with its accent, index and prime."""
    if len(glyph.base) > 1:
        base = f"<mtext>{escape(glyph.base)}</mtext>"
    else:
        greek = glyph.base in GREEK.values()
        style = (_BOLD_GREEK if greek and glyph.base.islower() else _VECTOR) if glyph.bold else ""
        if not style and greek and glyph.base.isupper():
            style = ' mathvariant="normal"'
        base = f"<mi{style}>{_SHAPES.get(glyph.base, escape(glyph.base))}</mi>"
    if glyph.accent:
        base = f"<mover>{base}{_ACCENTS[glyph.accent]}</mover>"
    if glyph.sub:
        base = f"<msub>{base}{subscript(glyph.sub)}</msub>"
    return primed(base) if glyph.prime else base


def primed(base: str, prime: str = "′") -> str:
    """A prime above the index of a letter; fonts raise it by themselves."""
    indexed = re.fullmatch(r"<msub>(<(\w+).*?</\2>)(.*)</msub>", base)
    if indexed:
        above = f'<mpadded width="0"><mo>{prime}</mo></mpadded>'
        return f"<msub>{_group(indexed[1] + above)}{indexed[3]}</msub>"
    return _group(f"{base}<mo>{prime}</mo>")


def subscript(sub: str) -> str:
    """An index: 1, ⊥, φ, CM, 1′."""
    plain = sub.rstrip("′")
    if plain.isdigit():
        index = f"<mn>{plain}</mn>"
    elif plain in ("+", "−", "⊥"):
        index = f"<mo>{plain}</mo>"
    elif not plain.isalpha():
        index = f"<mn>{escape(plain)}</mn>"
    elif len(plain) > 1 and set(plain) <= set("xyzijkl"):
        index = _group("".join(f"<mi>{c}</mi>" for c in plain))
    elif len(plain) > 1:
        index = f"<mtext>{escape(plain)}</mtext>"
    else:
        index = f"<mi>{_SHAPES.get(plain, escape(plain))}</mi>"
    return _group(f"{index}<mo>′</mo>") if plain != sub else index


def _group(inside: str) -> str:
    return f"<mrow>{inside}</mrow>"


def _ml(node: lay.Node) -> str:
    match node:
        case lay.Digits():
            return "<mi>∞</mi>" if node.text == "∞" else f"<mn>{node.text}</mn>"
        case lay.Atom():
            return letter(node.glyph)
        case lay.Terms():
            math = ""
            for sign, body in node.signed():
                # The first one of a line that goes on has the space of an infix, too.
                form = f' form="{"infix" if " " in sign else "prefix"}"' * (not math)
                math += f"<mo{form}>{sign.strip()}</mo>" * bool(sign) + _ml(body)
            return _group(math)
        case lay.Factors():
            math = _ml(node.factors[0])
            for joint, factor in zip(node.joints, node.factors[1:], strict=True):
                math += _JOINTS[joint] + _ml(factor)
            return _group(math)
        case lay.Fraction():
            math = f"<mfrac>{_ml(node.over)}{_ml(node.under)}</mfrac>"
            return f'<mstyle displaystyle="false">{math}</mstyle>' if node.small else math
        case lay.Superscript():
            return with_superscript(_ml(node.base), _ml(node.exponent))
        case lay.Radical():
            if node.index:
                return f"<mroot>{_ml(node.body)}<mn>{node.index}</mn></mroot>"
            return f"<msqrt>{_ml(node.body)}</msqrt>"
        case lay.FunctionOf():
            name = f"<mi>{escape(node.name)}</mi>" if isinstance(node.name, str) else _ml(node.name)
            if node.power is not None:
                name = f"<msup>{name}{_ml(node.power)}</msup>"
            inside = "<mo>,</mo>".join(map(_ml, node.arguments))
            if node.brackets:
                tall = any(map(sizes.is_tall, node.arguments))
                return _group(name + APPLY + fenced(inside, "()", tall))
            return _group(name + APPLY + THIN + inside)
        case lay.Brackets():
            return fenced(_ml(node.body), node.shape, sizes.is_tall(node.body))
        case lay.BraceBelow():
            # A stretched ⏟ comes out too short in the cells of a table; a border never does, and
            # dots are no fraction bar.
            brace = "border-bottom:2px dotted;padding-bottom:0.15em"
            label = _group(f"<mo>≡</mo>{_ml(node.label)}")
            return f'<munder><mrow style="{brace}">{_ml(node.body)}</mrow>{label}</munder>'
        case lay.Infix():
            left = _ml(node.left) if node.left else ""
            space = ' lspace="0" rspace="0"' * (node.sign == "/")
            return _group(f"{left}<mo{space}>{node.sign}</mo>{_ml(node.right)}")
        case lay.TransposeOf():
            return f"<msup>{_ml(node.body)}<mi>T</mi></msup>"
        case lay.DifferentialQuotient():
            d = "<mo>∂</mo>" if node.partial else "<mi>d</mi>"
            over = under_order = d
            by = _ml(node.by)
            if node.order > 1:
                over = f"<msup>{d}<mn>{node.order}</mn></msup>"
                by = with_superscript(by, f"<mn>{node.order}</mn>")
            under = _group(under_order + by)
            if node.inside:
                math = f"<mfrac>{_group(over + _ml(node.body))}{under}</mfrac>"
            else:
                math = _group(f"<mfrac>{over}{under}</mfrac>{_ml(node.body)}")
            if node.frame:
                return f"<msub>{fenced(math, '()', True)}<mtext>{escape(node.frame)}</mtext></msub>"
            return math
        case lay.Big():
            bounds = node.index.bounds if isinstance(node.index, lay.IntegralMeasure) else ()
            index = "" if node.index is None else _ml(node.index)
            big = '<mo largeop="true" movablelimits="true">∑</mo>'
            sign = "<mo>∫</mo>" if node.sign == "∫" else big
            if node.limits is not None:
                start, *end = map(_ml, node.limits)
                below = _group(f"{index}<mo>=</mo>{start}") if index else start
                both = "munderover" if end else "munder"
                return _group(f"<{both}>{sign}{below}{''.join(end)}</{both}>{_ml(node.body)}")
            if not index:
                return _group(f"{sign}{_ml(node.body)}")
            if node.sign == "∫":
                if bounds:
                    sign = f"<msubsup>{sign}{''.join(map(_ml, bounds))}</msubsup>"
                return _group(f"{sign}{index}{THIN}{_ml(node.body)}")
            return _group(f"<munder>{sign}{index}</munder>{_ml(node.body)}")
        case lay.IntegralMeasure():
            if node.bounds:
                return _group(f"<mi>d</mi>{_ml(node.variable)}")
            return _group(f"<msup><mi>d</mi><mn>{node.dimension}</mn></msup>{_ml(node.variable)}")
        case lay.Grid():
            # Rows of one height, so that those of matrices side by side are in line.
            rows = "".join(
                "<mtr>" + "".join(f"<mtd>{STRUT}{_ml(entry)}</mtd>" for entry in row) + "</mtr>"
                for row in node.rows
            )
            return fenced(f"<mtable>{rows}</mtable>", "[]", True)
        case lay.Enumeration():
            if node.between == ",":
                return _group("<mo>,</mo>".join(map(_ml, node.items)))
            word = f'<mspace width="1em"/><mtext>{node.between}</mtext><mspace width="1em"/>'
            return _group(word.join(map(_ml, node.items)))
        case lay.Chain():
            math = _ml(node.sides[0])
            for sign, side in zip(node.signs, node.sides[1:], strict=True):
                math += f"<mo>{escape(sign)}</mo>{_ml(side)}"
            return _group(math)


_JOINTS = {
    "": "<mo>&#x2062;</mo>",
    "function": f"<mo>&#x2062;</mo>{THIN}",
    "thin": f"<mo>&#x2062;</mo>{THIN}",
    "dot": "<mo>·</mo>",
}


def with_superscript(base: str, exponent: str) -> str:
    """An index and an exponent of one letter stand above each other."""
    if base.startswith("<msub>") and base.endswith("</msub>") and "<mpadded" not in base:
        return f"<msubsup>{beside_accent(base[6:-7])}{exponent}</msubsup>"
    return f"<msup>{beside_accent(base)}{exponent}</msup>"


_ACCENTED = re.compile(r"<mover><mi[^>]*>[^<]*</mi><mo[^>]*>[^<]*</mo></mover>")


def beside_accent(base: str) -> str:
    """What has an exponent, which stands as high at accented letters as at bare ones.

    Browsers raise it above the accents: for them those are part of the height of a letter, and of
    what stands in brackets.
    """
    if "<mover>" in base and base.endswith('stretchy="false">)</mo></mrow>'):
        return f'<mpadded height="0.75em">{base}</mpadded>'
    accented = _ACCENTED.match(base)
    if not accented:
        return base
    return f'<mpadded height="0.6em">{accented[0]}</mpadded>{base[accented.end() :]}'


def fenced(inside: str, shape: str, tall: bool) -> str:
    """What is inside between two brackets, which grow where it is tall; "." for none."""
    stretchy = "true" if tall else "false"
    left, right = (
        f'<mo form="{form}" fence="true" stretchy="{stretchy}">{mark}</mo>' * (mark != ".")
        for form, mark in zip(("prefix", "postfix"), shape, strict=True)
    )
    return _group(left + inside + right)
