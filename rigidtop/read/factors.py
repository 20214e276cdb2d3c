r"""The factors of a formula by how they begin: numbers, words, signs and commands.

>>> from rigidtop.read.tex import pieces
>>> from rigidtop.read.tokens import tokens
>>> from rigidtop.tree.nodes import TimeDerivative
>>> Grammar(tokens(pieces(r"\dot x")), FACTORS).whole() == TimeDerivative(Letter("x"), dotted=True)
True
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Final

from rigidtop.read import brackets, derivatives, functions, integrals, letters
from rigidtop.read.dress import BOLD, DOTS, MARKS, SLANTED, STYLES
from rigidtop.read.grammar import FactorRules, Grammar
from rigidtop.read.scripts import scripted
from rigidtop.read.shapes import FRACTIONS, upright
from rigidtop.read.tex import UnreadError, commands
from rigidtop.read.units import units
from rigidtop.read.vocabulary import CONSTANT, FUNCTIONS
from rigidtop.tree.nodes import Constant, Letter, Node, Number, Omitted
from rigidtop.tree.nodes import letters as letters_of


def primary(grammar: Grammar, before: Sequence[Node]) -> Node:
    """A factor without its scripts, which those `before` it may turn to a unit."""
    token = grammar.peek()
    kind = token.text if token.kind == "sign" else token.kind
    if kind == "group" or token.text in FRACTIONS:
        unit = _unit(grammar, before)
        if unit is not None:
            return unit
    if kind == "command":
        if token.text not in _COMMANDS:
            raise UnreadError(f"the command {token.text} is not known", token.position)
        return _COMMANDS[token.text](grammar)
    if kind in ("upright", "words"):
        return word(grammar, before)
    if kind not in _PRIMARIES:
        raise grammar.missing("a term")
    return _PRIMARIES[kind](grammar)


def _unit(grammar: Grammar, before: Sequence[Node]) -> Node | None:
    """A group or a fraction behind a number in which there are only upright letters."""
    if not before or letters_of(before[-1]):
        return None
    start = grammar.at
    grammar.argument()
    unit = units(upright(grammar.items[start : grammar.at]))
    if unit is None:
        grammar.at = start
    return unit


def _number(grammar: Grammar) -> Node:
    return Number(grammar.take().text)


def _omitted(grammar: Grammar) -> Node:
    grammar.take()
    return Omitted()


def word(grammar: Grammar, before: Sequence[Node]) -> Node:
    """What is written upright: a function, a unit, a constant, or the name of something."""
    token = grammar.peek()
    text = token.text.strip()
    if text in ("d", "∂") and (node := derivatives.differentiated(grammar, text)):
        return node
    grammar.take()
    is_unit = grammar.peek().kind != "open"  # K(m) is no kelvin
    is_unit &= text not in FUNCTIONS or not _acts(grammar)
    unit = units(text) if is_unit else None
    if unit and before and (len(text) > 1 or not letters_of(before[-1])):
        return unit
    if text.strip(". ").lower() in CONSTANT:
        return Constant()
    if text in FUNCTIONS or text == "Tr":
        return functions.function(grammar, text)
    if token.kind == "upright" and before and not letters_of(before[-1]):
        fraction = units(upright(token.group, within=True))
        if fraction:
            return fraction
    if token.kind == "upright" and token.group and not text.isalpha():
        return grammar.node_of(token.group)
    return Letter(text)


def _acts(grammar: Grammar) -> bool:
    """Whether something stands behind a name that a function can act on: sec² α, but 5 sec²."""
    at = grammar.at + (2 if grammar.is_sign("^") else 0)
    behind = grammar.items[at] if at < len(grammar.items) else None
    return behind is not None and behind.kind in ("open", "letter", "number", "group", "command")


_PRIMARIES: Final[dict[str, Callable[[Grammar], Node]]] = {
    "number": _number,
    "letter": letters.letter,
    "dots": _omitted,
    "group": brackets.group,
    "open": brackets.bracket,
    "bar": brackets.bar,
    "environment": brackets.matrix,
    "∂": derivatives.partial,
    "∇": derivatives.nabla,
    "∫": integrals.integral,
    "∮": integrals.integral,
    "Σ": integrals.total,
    "Π": integrals.total,
}
_COMMANDS: Final[dict[str, Callable[[Grammar], Node]]] = {
    **dict.fromkeys(DOTS, letters.dotted),
    **dict.fromkeys(BOLD, letters.bold),
    **dict.fromkeys(MARKS, letters.marked),
    **dict.fromkeys(STYLES, letters.lettered),
    **dict.fromkeys(SLANTED, letters.slanted),
    **dict.fromkeys(FRACTIONS, derivatives.fraction),
    **dict.fromkeys(commands("underbrace overbrace"), brackets.braced),
    r"\sqrt": functions.root,
    r"\lim": integrals.limit,
}
FACTORS: Final = FactorRules(_COMMANDS, primary, scripted)
"""The factors that physicists write."""
