"""Laws that pages share: one that is known by its name and its form needs no source again.

>>> law = Law("Hooke's law for $x$", r"F = -kx", Scope.MOTION, "Hooke 1678.")
>>> found("Hooke's law for $y$", r"F = -Dy", [law]) == law
True
>>> found("Hooke's law for $y$", r"F = Dy", [law]) is None
True
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from rigidtop.proof.lecture import Text
from rigidtop.proof.moves import Scope
from rigidtop.read.statements import statements
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.statement import Statement


@dataclass(frozen=True)
class Law:
    """A law by its name, as it is written, with where it holds and whose it is."""

    called: str
    latex: str
    scope: Scope
    source: str


def laws_of(text: Text) -> Iterator[Law]:
    """The laws and definitions that a page states."""
    for shown in text.shown:
        if shown.line is not None and shown.line.move is None:
            yield Law(shown.line.called, shown.latex, shown.line.scope, shown.line.source)


def found(called: str, latex: str, library: Iterable[Law]) -> Law | None:
    """The law of this name and form, whichever letters either has."""
    named = (law for law in library if _words(law.called) == _words(called))
    return next((law for law in named if _is_same(law.latex, latex)), None)


def _words(called: str) -> str:
    """What something is called, in lower case with a $ for each formula."""
    return " ".join(re.sub(r"\$[^$]+\$", "$", called).lower().removeprefix("the ").split())


def _is_same(one: str, other: str) -> bool:
    """Whether two formulas differ in what their letters are called, and in nothing else."""
    first, second = (_form(each) for each in (one, other))
    if first is None or second is None or first[0] != second[0]:
        return False
    pairs = {*zip(first[1], second[1], strict=True)}
    return all(len(pairs) == len({pair[k] for pair in pairs}) for k in (0, 1))


def _form(latex: str) -> tuple[tuple[Statement, ...], tuple[Letter, ...]] | None:
    """Statements with the same letter everywhere, and the letters that stood there; None: unread.

    A bold letter stays bold, and so does one with a hat.
    """
    letters: list[Letter] = []

    def bare(node: Node) -> Node:
        if isinstance(node, Letter):
            letters.append(node)
            return Letter("x", mark=node.mark, bold=node.bold)
        return node

    made = []
    for each in statements(latex):
        if not isinstance(each, Statement):
            return None
        sides = tuple(n.mapped(side, bare) for side in each.sides)
        made.append(replace(each, sides=sides, position=0, tag=""))
    return tuple(made), tuple(letters)
