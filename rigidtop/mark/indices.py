r"""Indices that run: what Einstein summed is no product of numbers.

>>> from rigidtop.notation import OWN
>>> from rigidtop.read.formula import read
>>> [running(line.equation) for line in read(r"H = p_i\dot q_i - L,\quad p_i = m_iv_i", OWN)]
['i', '']
>>> [running(line.equation) for line in read(r"L_i = \epsilon_{ijk}q_jp_k,\quad T_{kin} = 0", OWN)]
['ijk', '']
>>> [running(line.equation) for line in read(r"e_k e_l = -e_l e_k,\quad E_i = E_f", OWN)]
['k', '']
"""

from __future__ import annotations

import re

import sympy
from sympy import Add, Expr, Mul

from rigidtop.proof.equation import Equation, Group
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.symbols import Glyph

_INDEX = re.compile("[i-n]|[αβγκλμνρσ]")
_INDICES = re.compile("(?!in|kin|min|lin|ini|mn)(?:[i-np-s]{2,5}|[αβγκλμνρσ]{2,5})")
"""Several at one letter; the others are words."""


def running(equation: Equation) -> str:
    """The index, or the indices of a letter, that run in an equation; "" if none does.

    One that stands twice in a product, and in no other term, is summed over; one that stands in
    every term names one of several equations.  Two of them at one letter, σ_i σ_j, run for certain.
    """
    if any(isinstance(side, sympy.MatrixBase) for side in equation.sides):
        return ""
    glyphs = {x.quantity.glyph for x in _letters(*equation.sides)}
    for index in sorted(_indices(*equation.sides), key=lambda x: (-len(x), x)):
        if _INDICES.fullmatch(index):
            return index
        if index in "ijn" and any(x == Glyph(index) for x in glyphs):
            return index  # a number that counts: x_n = 1/n
        terms = [term for side in equation.sides for term in _terms(side) if term != 0]
        products = [node for term in terms for node in term.atoms(Mul)]
        of = {glyph.base for glyph in glyphs if glyph.sub == index}
        if any(x.base in of and x.sub != index and _INDEX.fullmatch(x.sub) for x in glyphs):
            return index
        twice = any(sum(index in _indices(x) for x in node.args) > 1 for node in products)
        if twice and not all(index in _indices(term) for term in terms):
            return index
    return ""


def _terms(side: Expr) -> tuple[Expr, ...]:
    return tuple(Add.make_args(side.args[0] if isinstance(side, Group) else side))


def _indices(*sides: Expr) -> set[str]:
    found = {x.quantity.glyph.sub for x in _letters(*sides)}
    return {x for x in found if _INDEX.fullmatch(x) or _INDICES.fullmatch(x)}


def _letters(*sides: Expr) -> set[Lettered]:
    return {x for side in sides for x in side.free_symbols if isinstance(x, Lettered)}
