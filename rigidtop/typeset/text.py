"""Unicode on one line, for the terminal and for what screen readers say of an equation.

>>> from sympy import cos, sin
>>> from rigidtop.theory.symbols import lambda1, phidot, theta, thetadot
>>> text(lambda1 * (phidot**2 * sin(theta) ** 2 + thetadot**2) / 2)
'½λ₁(φ̇² sin² θ + θ̇²)'
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from typing import Any

from sympy import Basic

from rigidtop.proof.equation import Equation
from rigidtop.theory.symbols import Glyph
from rigidtop.typeset import nodes as lay
from rigidtop.typeset.layout import Order, layout

_ACCENTS = {"": "", "dot": "\u0307", "ddot": "\u0308", "hat": "\u0302"}
_SUBSCRIPTS = str.maketrans("0123456789−+i", "₀₁₂₃₄₅₆₇₈₉₋₊ᵢ")
_SUPERSCRIPTS = str.maketrans("0123456789−", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")
_VULGAR = {"1/2": "½", "1/3": "⅓", "2/3": "⅔", "1/4": "¼", "3/4": "¾", "1/8": "⅛"}
_JOINTS = {"": "", "function": " ", "thin": " ", "dot": "·"}


def text(tree: Basic, order: Order = "auto", *, tag: bool = False) -> str:
    """An expression, a matrix, a condition or an `Equation`, with its tag behind it if wanted."""
    node = tree if type(tree).__module__ == lay.__name__ else layout(tree, order)
    sentence = unicodedata.normalize("NFC", _text(node))
    # On one line a name of a part would read as a side of the equation.
    named = [f"{_text(_bare(b.body))} ≡ {_text(b.label)}" for b in _braced(node)]
    if named:
        sentence += unicodedata.normalize("NFC", ", with " + " and ".join(dict.fromkeys(named)))
    if tag and isinstance(tree, Equation) and tree.tag:
        sentence += f"  ({tree.tag})"
    return sentence


def letter(glyph: Glyph) -> str:
    """A symbol as plain text: ω̇₁, e₁′, L_z."""
    before, glyph = lay.differential(glyph)
    spelling = before + glyph.base[0] + _ACCENTS[glyph.accent] + glyph.base[1:]
    plain = glyph.sub.rstrip("′")
    if plain and all(c in "0123456789−+i" for c in plain):
        spelling += glyph.sub.translate(_SUBSCRIPTS)
    elif re.search(r"\w ?[-+−/]|\w \w", glyph.sub):
        spelling += f"_{{{glyph.sub}}}"
    elif glyph.sub:
        spelling += "_" + glyph.sub
    return spelling + ("′" if glyph.prime else "")


def _text(node: lay.Node) -> str:
    match node:
        case lay.Digits():
            return node.text
        case lay.Atom():
            return letter(node.glyph)
        case lay.Terms():
            return "".join(sign + _text(body) for sign, body in node.signed()).lstrip()
        case lay.Factors():
            spelling = _factor(node.factors[0])
            for joint, factor in zip(node.joints, node.factors[1:], strict=True):
                right = _factor(factor)
                between = _JOINTS[joint]
                if not between and re.search(r"_\w+$", spelling) and right[0] not in "([|":
                    between = " "  # Ω_b ω₂, lest the index runs on
                if not between and (
                    "/" in right or (spelling[-1].isalpha() and re.match(r"\w+_", right))
                ):
                    between = " "
                spelling += between + right
            return spelling
        case lay.Fraction():
            over, under = _text(node.over), _text(node.under)
            if node.small and f"{over}/{under}" in _VULGAR:
                return _VULGAR[f"{over}/{under}"]
            if isinstance(node.over, (lay.Terms, lay.Infix, lay.Big, lay.Fraction)):
                over = f"({over})"
            if not _is_simple(node.under):
                under = f"({under})"
            return f"{over}/{under}"
        case lay.Superscript():
            return _text(node.base) + _superscript(node.exponent)
        case lay.Radical():
            body = _text(node.body)
            sign = {"": "√", "3": "∛", "4": "∜"}.get(node.index, f"({node.index})√")
            return sign + (body if isinstance(node.body, (lay.Digits, lay.Atom)) else f"({body})")
        case lay.FunctionOf():
            name = node.name if isinstance(node.name, str) else _text(node.name)
            if node.power is not None:
                name += _superscript(node.power)
            inside = ", ".join(map(_text, node.arguments))
            return f"{name}({inside})" if node.brackets else f"{name} {inside}"
        case lay.Brackets():
            return f"{node.shape[0]}{_text(node.body)}{node.shape[1]}"
        case lay.BraceBelow():
            body = _text(node.body)
            alone = isinstance(node.body, (lay.Atom, lay.Digits, lay.Brackets))
            return body if alone else f"({body})"
        case lay.Infix():
            sign = node.sign if node.sign == "/" else f" {node.sign} "
            return f"{_text(node.left) if node.left else ''}{sign}{_text(node.right)}"
        case lay.TransposeOf():
            return _text(node.body) + "ᵀ"
        case lay.DifferentialQuotient():
            d = "∂" if node.partial else "d"
            order = str(node.order).translate(_SUPERSCRIPTS) if node.order > 1 else ""
            body, by = _text(node.body), _text(node.by)
            spelling = (
                f"{d}{order}{body}/{d}{by}{order}"
                if node.inside
                else f"{d}{order}/{d}{by}{order} {body}"
            )
            return f"({spelling})_{node.frame}" if node.frame else spelling
        case lay.Big():
            sign = {"∑": "Σ"}.get(node.sign, node.sign)
            index = "" if node.index is None else _text(node.index)
            if node.limits is not None:
                ends = ", ".join(map(_text, node.limits))
                return f"{sign}[{index + ' = ' if index else ''}{ends}] {_text(node.body)}"
            if node.sign == "∫":
                bounds = node.index.bounds if isinstance(node.index, lay.IntegralMeasure) else ()
                between = f" from {' to '.join(map(_text, bounds))}" if bounds else ""
                return " ".join(filter(None, (sign + between, index, _text(node.body))))
            return f"{sign}_{index} {_text(node.body)}" if index else f"{sign} {_text(node.body)}"
        case lay.IntegralMeasure():
            return "d" + node.dimension.translate(_SUPERSCRIPTS) + _text(node.variable)
        case lay.Grid():
            return "[" + "; ".join(", ".join(map(_text, row)) for row in node.rows) + "]"
        case lay.Enumeration():
            between = ", " if node.between == "," else f" {node.between} "
            return between.join(map(_text, node.items))
        case lay.Chain():
            rest = zip(node.signs, node.sides[1:], strict=True)
            return _text(node.sides[0]) + "".join(f" {sign} {_text(side)}" for sign, side in rest)


def _factor(node: Basic) -> str:
    """A quotient among other factors stands in brackets, ½ does not."""
    if isinstance(node, lay.Fraction):
        spelling = _text(node)
        return f"({spelling})" if "/" in spelling else spelling
    return _text(node)


def _is_simple(node: Basic) -> bool:
    alone = (lay.Digits, lay.Atom, lay.Superscript, lay.Brackets, lay.Radical, lay.FunctionOf)
    return isinstance(node, alone)


def _superscript(node: Basic) -> str:
    spelling = _text(node)
    if all(c in "0123456789−" for c in spelling):
        return spelling.translate(_SUPERSCRIPTS)
    return "^" + (spelling if _is_simple(node) and len(spelling) == 1 else f"({spelling})")


def _bare(node: Basic) -> Any:
    return node.body if isinstance(node, lay.Brackets) else node


def _braced(node: Basic) -> Iterator[lay.BraceBelow]:
    """The parts of a tree that have a brace beneath them."""
    if isinstance(node, lay.BraceBelow):
        yield node
    for part in lay.parts(node):
        yield from _braced(part)
