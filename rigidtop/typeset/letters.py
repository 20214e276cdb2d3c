r"""What a letter that no table has is, as far as the formulas tell: never guessed in silence.

>>> from rigidtop.notation import OWN
>>> from rigidtop.read.formula import read
>>> lines = read(r"\frac{\partial L}{\partial\dot q} = p, \vec F = m\vec g", OWN)
>>> for shown, role in roles([line.equation for line in lines if line.equation]).items():
...     print(shown, role, sep=": ")
F: a vector
L: differentiated by q̇, the Lagrangian
g: a vector
m: a number
p: a number
q: a number that changes in time
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import replace
from itertools import chain
from typing import TypeGuard

import sympy

from rigidtop.proof.equation import At, Equation, Partial
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.symbols import Glyph
from rigidtop.typeset.text import letter

OPEN = "a number here: the Lagrangian, or the size of an angular momentum? no formula tells"


def roles(equations: Iterable[Equation], said: Mapping[Glyph, str] | None = None) -> dict[str, str]:
    """Each letter of its own, as it is written, with what it is; `said` is what words say of it."""
    letters: set[Glyph] = set()
    arguments: defaultdict[Glyph, set[str]] = defaultdict(set)
    by_rates: defaultdict[Glyph, set[str]] = defaultdict(set)
    dotted: set[Glyph] = set()
    for equation in equations:
        for node in chain.from_iterable(map(sympy.preorder_traversal, equation.sides)):
            if is_letter(node):
                glyph = node.quantity.glyph
                plain = replace(glyph, accent="" if "dot" in glyph.accent else glyph.accent)
                letters.add(plain)
                if plain != glyph:
                    dotted.add(plain)
            elif isinstance(node, At) and is_letter(node.args[0]):
                found = arguments[node.args[0].quantity.glyph]
                found |= {letter(x.quantity.glyph) for x in node.args[1:] if is_letter(x)}
            elif isinstance(node, Partial) and is_letter(node.args[0]) and is_letter(node.args[1]):
                by = node.args[1].quantity.glyph
                if by.accent == "dot":
                    by_rates[node.args[0].quantity.glyph].add(letter(by))

    def role(glyph: Glyph) -> str:
        if by_rates[glyph]:
            return f"differentiated by {', '.join(sorted(by_rates[glyph]))}, the Lagrangian"
        if glyph.bold:
            return "a vector"
        if arguments[glyph]:
            return f"a function of {', '.join(sorted(arguments[glyph]))}"
        if said and said.get(glyph):
            return said[glyph]
        if glyph == Glyph("L"):
            return OPEN
        return "a number that changes in time" if glyph in dotted else "a number"

    made: dict[str, str] = {}
    for glyph in sorted(letters, key=lambda glyph: glyph.bold):
        shown = letter(glyph)
        if glyph.base != "…":
            made[shown] = f"{made[shown]}, and {role(glyph)}" if shown in made else role(glyph)
    return dict(sorted(made.items()))


def is_letter(node: object) -> TypeGuard[Lettered]:
    """Whether a part of a formula is a letter of its own."""
    return isinstance(node, Lettered)
