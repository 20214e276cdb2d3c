"""What kind of thing a letter is by its name: a vector, a component of one, a unit vector."""

from __future__ import annotations

from dataclasses import replace

from sympy import ImmutableMatrix, MatrixBase

from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter


def is_vector(letter: Letter) -> bool:
    """Whether it is written as a vector."""
    return letter.bold or letter.mark == "hat"


def component_of(letter: Letter) -> n.DotProduct:
    """What a letter is by its name, if it is a component: the vector times a unit vector."""
    axis = Letter("e", letter.sub.rstrip("′"), "′" * letter.sub.count("′"), True)
    return n.DotProduct(vector_of(letter), axis)


def vector_of(letter: Letter) -> Letter:
    """The vector of which a letter is a component by its name."""
    return replace(letter, sub="", bold=True)


def is_component(letter: Letter, vector: Letter) -> bool:
    """Whether it is the name of one number of a vector: ω₁, v_x."""
    named = len(letter.sub) == 1 and letter.sub in "xyz123" and not letter.bold
    return named and vector == Letter(letter.base, "", letter.mark, True)


def function_name(letter: Letter) -> str:
    """The name of the function of SymPy that an unknown function is."""
    return "\x1f".join((letter.base, letter.sub, letter.mark))


def basis_of(letter: Letter) -> MatrixBase | None:
    """The fixed unit vector that a letter is by its name."""
    for names in ("xyz", "ijk"):
        if letter.base in names and not letter.sub and (letter.mark == "hat" or names == "ijk"):
            return ImmutableMatrix([int(letter.base == x) for x in names])
    if letter.base in "eu" and len(letter.sub) == 1:
        for names in ("xyz", "123"):
            if letter.sub in names and letter.mark in ("", "hat"):
                return ImmutableMatrix([int(letter.sub == x) for x in names])
    return None
