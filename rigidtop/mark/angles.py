"""Angles that an answer names in words: "let $α$ be the angle between $L$ and $ω$"."""

from __future__ import annotations

import re
from collections.abc import Collection
from dataclasses import replace

from rigidtop.judge.reading import Read
from rigidtop.read.phrases import Cue
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.statement import Statement, Unread

_ANGLE, _BETWEEN, _AND = r"(?:angle|Winkel)", r"(?:between|zwischen)", r"(?:and|und)"
_BEFORE = re.compile(
    rf"§ (?:be|is|for|denote|sei|ist|für) (?:the|der|den) {_ANGLE} {_BETWEEN}\Z"
    rf"|{_ANGLE} § {_BETWEEN}\Z",
    re.I,
)
"""Words between the name of an angle and the first of two directions."""
_OPENS = re.compile(rf"{_ANGLE} {_BETWEEN}\Z", re.I)
_SECOND = re.compile(rf"§ {_AND}\Z", re.I)
_BEHIND = re.compile(
    rf"§ {_AND} § (?:is|be|ist|sei|heißt)(?: (?:then|now|called|nun|dann))?\Z", re.I
)
"""Words between the second direction and the name."""


def with_angles(read: Read, facts: Collection[Letter]) -> Read:
    """A text in which words that name an angle say what its letter stands for.

    Letters of the facts have a meaning already.
    """
    alone = [_letter(each) for _, each in read]
    made: Read = []
    for k, (passage, each) in enumerate(read):
        made.append((passage, each))
        for first, words in ((k + 1, _BEFORE), (k - 2, _OPENS)):
            if not 0 <= first < len(read) - 1:
                continue
            around = [read[j][0] for j in (first, first + 1)]
            if any(x.sentence != passage.sentence for x in around):
                continue
            said = words.search(around[0].before) and _SECOND.search(around[1].before)
            named = first > k or _BEHIND.search(passage.before)
            name, one, other = alone[k], alone[first], alone[first + 1]
            if said and named and name is not None and name not in facts and one and other:
                defined = Statement((name, _between(one, other)), ("=",), each.position)
                made.append((replace(passage, cues=frozenset({Cue.DEFINED})), defined))
    return made


def _letter(each: Statement | Unread) -> Letter | None:
    """The letter that stands alone, if one does."""
    side = each.sides[0] if isinstance(each, Statement) and len(each.sides) == 1 else None
    return side if isinstance(side, Letter) else None


def _between(one: Node, other: Node) -> Node:
    """The angle between two vectors."""
    lengths = n.Product((n.Absolute(one), n.Absolute(other)))
    return n.Apply("arccos", n.Quotient(n.DotProduct(one, other), lengths))
