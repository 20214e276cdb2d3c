r"""A text as its formulas in order, each with the scope, the sentence and the words around it.

>>> for passage in passages("Suppose $p = q$. At the start\n\n$$x = 0$$\n"):
...     print(passage.text, passage.sentence, passage.before, *(cue.name for cue in passage.cues))
p = q 0 Suppose CASE
x = 0 1 At the start MOMENT
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

from rigidtop.read.cues import (
    begins_at_rest,
    cues,
    ends_moment,
    enumerates,
    kept,
    passed_on,
    unequal,
)
from rigidtop.read.left import states
from rigidtop.read.phrases import Cue
from rigidtop.read.prose import prose_of
from rigidtop.read.walk import Formula

_OPEN_ENDED = re.compile(r"(?:=|≈|\\(?:equiv|approx|simeq))\s*\Z")
# A limit of which words say the place: b → very large, x → zero.
_TENDING = re.compile(r"(?:→|\\(?:to|rightarrow))\s*\Z")
_FAR = re.compile(
    r"\s*(?:(?:very|sehr|très) )?(?:large|infinity|unendlich|groß|grand|l.infini)\b", re.I
)
_NEAR = re.compile(r"\s*(?:zero|null|zéro|(?:(?:very|sehr|très) )?(?:small|klein|petit))\b", re.I)
CONSTANT = re.compile(r"(?:const|konst|constante?|konstant|costante|cs?te|cst)\b", re.I)
"""A word that stands for something constant."""


@dataclass(frozen=True)
class Passage:
    """A formula and what stands around it."""

    text: str
    start: int
    """Where the text begins in the source."""
    display: bool
    scope: tuple[int, ...]
    """In which heading, exercise, titled paragraph or item it stands, from outside inwards."""
    sentence: int
    before: str
    """The words of the sentence since the formula before; § is a letter, ¶ ends a title."""
    behind: str
    """The words up to the next formula or the end of the sentence."""
    cues: frozenset[Cue] = frozenset()


def passages(source: str, plain: bool = False) -> tuple[Passage, ...]:
    """Every formula of a text, in order; where it is `plain`, those without dollars as well.

    Raises RigidtopError for a text that is too long.
    """
    prose = prose_of(source, plain)
    made = [
        Passage(
            *(formula.text, formula.start, formula.display),
            *(prose.scope(number), prose.sentence(number)),
            *prose.around(number),
        )
        for number, formula in enumerate(prose.formulas)
    ]
    cued = _approximated(_together([*_cued([_completed(passage) for passage in made])]))
    return tuple(
        replace(passage, cues=passage.cues | _said(prose.since(number)))
        for number, passage in enumerate(cued)
    )


@lru_cache(maxsize=5_000)
def _said(words: str) -> frozenset[Cue]:
    """What words say of all that follows."""
    rest = {Cue.REST} if begins_at_rest(words) else set()
    return frozenset(rest | {*kept(words)})


def _completed(passage: Passage) -> Passage:
    """A passage with its last side, where that is the word behind it: $E = $ const."""
    if _OPEN_ENDED.search(passage.text) and CONSTANT.match(passage.behind):
        return replace(passage, text=passage.text + r"\text{const}")
    if _TENDING.search(passage.text):
        if _FAR.match(passage.behind):
            return replace(passage, text=passage.text + r"\infty")
        if _NEAR.match(passage.behind):
            return replace(passage, text=passage.text + "0")
    return passage


def _cued(made: Sequence[Passage]) -> Iterator[Passage]:
    """Passages with what their words say, and what those say that were said of the one before."""
    last: Passage | None = None
    opening = ""
    for passage in made:
        heard = cues(passage.before, passage.behind, passage.text, passage.display)
        if last is not None and last.sentence == passage.sentence:
            between = (passage.before, last.display, passage.display)
            heard |= passed_on(last.cues, opening, *between)
            heard = unequal(heard, passage.text, passage.display)
            if Cue.MOMENT in last.cues and ends_moment(passage.before):
                heard -= {Cue.MOMENT}
        passage = replace(passage, cues=heard)
        yield passage
        if states(Formula(passage.text, 0, 0, passage.display)):
            last = passage
            opening = opening if enumerates(passage.before) else passage.before


_WHEN = frozenset({Cue.MOMENT, Cue.GENERAL})


def _together(made: Sequence[Passage]) -> Iterator[Passage]:
    """Passages; when the last of a list is so ("at the start", "at all times"), all of it is."""
    after: Passage | None = None
    together = []
    for passage in reversed(made):
        if (
            after is not None
            and after.cues & _WHEN
            and not (passage.display or after.display)
            and after.sentence == passage.sentence
            and after.before.strip()
            and enumerates(after.before)
        ):
            behind = passage.behind + after.behind
            passage = replace(passage, cues=passage.cues | after.cues & _WHEN, behind=behind)
        together.append(passage)
        after = passage
    return reversed(together)


_EXPANDED = re.compile(r"\\(?:sin|cos|tan)(?![a-z]).*\\approx|\b(?:sin|cos|tan)\b.*≈")
"""What is said of small angles: sin θ ≈ θ."""


def _approximated(made: Iterable[Passage]) -> Iterator[Passage]:
    """Passages; those behind what is small, up to the end of its scope, are approximated."""
    scope: tuple[int, ...] | None = None
    for passage in made:
        if Cue.GENERAL in passage.cues or (scope and passage.scope[: len(scope)] != scope):
            scope = None
        if passage.cues & {Cue.SMALL, Cue.LARGE} or _EXPANDED.search(passage.text):
            scope = passage.scope if scope is None else scope
        approximated = {Cue.APPROXIMATED} if scope is not None else set()
        yield replace(passage, cues=passage.cues | approximated)
