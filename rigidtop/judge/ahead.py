"""Definitions that stand behind what they explain: "F = μ g, where μ = …"."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from itertools import groupby
from typing import Protocol, TypeVar

from rigidtop.judge.letters import CLOCK
from rigidtop.read.passages import Passage
from rigidtop.read.phrases import Cue
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter
from rigidtop.tree.statement import Statement, Unread


class Placed(Protocol):
    """A statement with what stands around it."""

    @property
    def statement(self) -> Statement | Unread: ...
    @property
    def passage(self) -> Passage: ...


S = TypeVar("S", bound=Placed)


def explained_first(text: Iterable[S]) -> Iterator[S]:
    """Statements in the order in which they can be understood.

    What only says what a new letter of its sentence stands for goes before the statement that has
    the letter.
    """
    known: set[Letter] = set()
    for _, sentence in groupby(text, key=lambda each: each.passage.sentence):
        ordered: list[S] = []
        behind = 0
        for each in sentence:
            if not _continues(each):
                behind = _place(each, ordered, known)
            ordered.insert(behind, each)  # a chain stays together
            behind += 1
        for each in ordered:
            known |= _letters(each)
        yield from ordered


def _continues(each: Placed) -> bool:
    """Whether it is the next link of the chain above."""
    return isinstance(each.statement, Statement) and each.statement.continues


def _place(each: Placed, sentence: Sequence[Placed], known: Collection[Letter]) -> int:
    """Before which statement of its sentence one has to stand: the last place if none needs it."""
    name = _explained(each, sentence)
    places = [
        k
        for k, other in enumerate(sentence)
        if name in _letters(other)
        and _says(other)
        and not _is_motion(other)
        # Solved for the letter, it says the same again.
        and _letters(each) != _letters(other)
    ]
    # What several statements speak of may come out of them.
    if name is None or name in known or len(places) != 1 or _named(sentence[places[0]]) == name:
        return len(sentence)
    return places[0]


def _explained(each: Placed, sentence: Sequence[Placed]) -> Letter | None:
    """The letter of which it says what it is, behind "where" or in the same display."""
    together = any(other.passage.start == each.passage.start for other in sentence)
    return _named(each) if together or Cue.DEFINED in each.passage.cues else None


def _named(each: Placed) -> Letter | None:
    """The letter, or the one of which the square, a statement gives a value."""
    if not isinstance(each.statement, Statement) or each.statement.relations[:1] != ("=",):
        return None
    match each.statement.sides[0]:
        case Letter() as letter:
            return letter
        case n.Power(Letter() as letter, n.Number()):
            return letter
    return None


def _is_motion(each: Placed) -> bool:
    """Whether it gives a letter in time: its amplitude comes out of what holds."""
    if _named(each) is None or not isinstance(each.statement, Statement):
        return False
    return isinstance(each.statement.sides[0], Letter) and CLOCK in n.letters(
        each.statement.sides[-1]
    )


def _says(each: Placed) -> bool:
    """Whether it is more than a letter that is named."""
    return isinstance(each.statement, Statement) and bool(each.statement.relations)


def _letters(each: Placed) -> frozenset[Letter]:
    if not isinstance(each.statement, Statement):
        return frozenset()
    return frozenset().union(*map(n.letters, each.statement.sides))
