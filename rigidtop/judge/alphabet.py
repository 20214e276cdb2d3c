"""What the letters of pages are, as the judge reads them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache

from sympy import Symbol

from rigidtop.proof.letters import Letters
from rigidtop.read.statements import statements
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.statement import Statement
from rigidtop.typeset.latex import latex


@cache
def letter_of(x: Symbol) -> Letter | None:
    """The letter that a symbol of a notation is; None for a rate."""
    found = statements(latex(x) + " = 0")
    side = found[0].sides[0] if len(found) == 1 and isinstance(found[0], Statement) else None
    return side if isinstance(side, Letter) else None


def letters_of(symbols: Iterable[Symbol]) -> frozenset[Letter]:
    """The letters that symbols of a notation are, without their rates."""
    return frozenset(x for each in symbols if (x := letter_of(each)) is not None)


@dataclass(frozen=True, eq=False)
class Alphabet:
    """What the letters of some pages are: the same as `Letters` of the proof, as they are written.

    `double` are letters with several indices, `components` the products that have a letter.
    """

    numbers: frozenset[Letter]
    positive: frozenset[Letter]
    coordinates: frozenset[Letter]
    vectors: frozenset[Letter]
    operators: frozenset[Letter]
    arbitrary: frozenset[Letter]
    unit: frozenset[Letter]
    frames: tuple[tuple[Letter, ...], ...]
    body: tuple[Letter, ...]
    indices: frozenset[str]
    double: frozenset[Letter]
    functions: Mapping[Letter, tuple[Node, ...]]
    components: Mapping[Letter, Node]


def alphabet(letters: Letters) -> Alphabet:
    """What letters of the proof are, as letters of a tree."""
    functions = {
        letter: tuple(y for p in places if (y := letter_of(p)) is not None)
        for x, places in letters.functions.items()
        if (letter := letter_of(x)) is not None
    }
    components = {
        letter: n.DotProduct(one, other)
        for (axis, vector), x in letters.components.items()
        if (one := letter_of(axis)) and (other := letter_of(vector)) and (letter := letter_of(x))
    }
    return Alphabet(
        letters_of(letters.numbers),
        letters_of(x for x in letters.numbers | {*letters.units} if x.is_positive),
        letters_of(letters.coordinates),
        letters_of(letters.vectors),
        letters_of(letters.operators),
        letters_of(letters.arbitrary),
        letters_of(letters.unit_vectors),
        tuple(tuple(filter(None, map(letter_of, frame))) for frame in letters.frames),
        tuple(filter(None, map(letter_of, letters.body))),
        frozenset(x.name for names in letters.indexed.values() for x in names),
        letters_of(x for x, names in letters.indexed.items() if len(names) > 1),
        functions,
        components,
    )
