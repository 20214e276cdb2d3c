r"""What the letters of a text are, as far as its formulas and its words tell: never guessed.

>>> from rigidtop.read.statements import statements
>>> read = statements(r"\frac{\partial L}{\partial\dot q} = p, \vec F = m\vec g")
>>> for letter, role in roles(read).items():
...     print(letter, role, sep=": ")
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

from rigidtop.read.declared import Declared, Word
from rigidtop.read.statements import statements
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter
from rigidtop.tree.plain import plain
from rigidtop.tree.statement import Statement, Unread

NUMBERS = frozenset({Letter("π"), Letter("e"), Letter("i")})

LAGRANGIAN = Letter("L")
OPEN = "a number here: the Lagrangian, or the size of an angular momentum? no formula tells"


def roles(
    read: Iterable[Statement | Unread], said: Mapping[Letter, str] | None = None
) -> dict[str, str]:
    """Each letter, as it is written, with what it is; `said` is what words say of it."""
    letters: set[Letter] = set()
    moving: set[Letter] = set()
    places: defaultdict[Letter, set[str]] = defaultdict(set)
    by_rates: defaultdict[Letter, set[str]] = defaultdict(set)
    for node in _nodes(read):
        match node:
            case Letter():
                letters.add(node)
            case n.TimeDerivative(Letter() as of):
                moving.add(of)
            case n.Call(Letter() as function, at):
                places[function] |= {plain(x) for x in at if isinstance(x, Letter)}
            case n.Derivative(Letter() as of, by):
                by_rates[of] |= {plain(x) for x in by if isinstance(x, n.TimeDerivative)}

    def role(letter: Letter) -> str:
        if by_rates[letter]:
            return f"differentiated by {', '.join(sorted(by_rates[letter]))}, the Lagrangian"
        if letter.bold:
            return "a vector"
        if places[letter]:
            return f"a function of {', '.join(sorted(places[letter]))}"
        if said and letter in said:
            return said[letter]
        if letter == LAGRANGIAN:
            return OPEN
        return "a number that changes in time" if letter in moving else "a number"

    told: dict[str, str] = {}
    for letter in sorted(letters - NUMBERS, key=lambda letter: (plain(letter), letter.bold)):
        name = plain(letter)
        told[name] = f"{told[name]}, and {role(letter)}" if name in told else role(letter)
    return told


def words(declared: Iterable[Declared]) -> dict[Letter, str]:
    """What a text says of its letters, of each what it says first."""
    said: dict[Letter, str] = {}
    for each in declared:
        for read in statements(each.text):
            if isinstance(read, Statement) and isinstance(read.sides[0], Letter):
                said.setdefault(read.sides[0], ", ".join(sorted(map(_name, each.words))))
    return said


def _name(word: Word) -> str:
    return word.name.lower().replace("_", " ")


def _nodes(read: Iterable[Statement | Unread]) -> Iterable[n.Node]:
    for each in read:
        if isinstance(each, Statement):
            for side in each.sides:
                yield from n.walked(side)
