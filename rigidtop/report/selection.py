"""Which blocks of a document are shown: its main thread, to students, on slides."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any

from rigidtop.report.blocks import (
    Aside,
    AsideEnd,
    Block,
    Cited,
    ExerciseHead,
    Legend,
    SectionHead,
    Subhead,
    walked,
)

NOT_PROJECTED = frozenset({"solutions", "laws", "letters", "map", "results"})
"""The anchors of sections that stand on no slide."""


def main_thread(blocks: Iterable[Block]) -> list[Block]:
    """The blocks without the boxes.

    >>> from rigidtop.report.blocks import Paragraph
    >>> aside = Aside("More"), Paragraph(("b",)), AsideEnd()
    >>> blocks = [Paragraph(("a",)), *aside, Paragraph(("c",))]
    >>> [block.content for block in main_thread(blocks)]
    [('a',), ('c',)]
    """
    return list(_outside(blocks, lambda _: True))


def for_students(blocks: Iterable[Block]) -> list[Block]:
    """The blocks without the boxes that are for lecturers."""
    return list(_outside(blocks, lambda box: box.for_lecturers))


def _outside(blocks: Iterable[Block], left_out: Callable[[Aside], bool]) -> Iterator[Block]:
    """The blocks but for the boxes that are left out, with all in them."""
    inside: list[bool] = []  # of each box that is open, whether it is left out
    for block in blocks:
        inside += [left_out(block)] if isinstance(block, Aside) else []
        if not any(inside):
            yield block
        if isinstance(block, AsideEnd):
            inside.pop()


def projected(blocks: Iterable[Block], solutions: bool = False) -> list[Block]:
    """What stands on slides: the main thread, without what nobody projects behind it.

    Exercises are there with their `solutions`, or not at all.  What would lead to what is left out
    has its words alone.
    """
    left_out = NOT_PROJECTED - {"solutions"} if solutions else NOT_PROJECTED
    kept: list[Block] = []
    is_shown = True
    for block in main_thread(block for block in blocks if not isinstance(block, Legend)):
        if isinstance(block, SectionHead) and block.level == 1:
            is_shown = block.anchor not in left_out
        elif isinstance(block, SectionHead):
            is_shown = True
        elif isinstance(block, ExerciseHead) and not solutions:
            if kept and isinstance(kept[-1], Subhead):  # Exercises
                kept.pop()
            is_shown = False
        kept += [block] * is_shown
    anchors: set[str] = set()

    def noted(part: Any, _: str) -> Any:
        anchors.add("" if isinstance(part, Cited) else getattr(part, "anchor", ""))
        return part

    def leading(part: Any, _: str) -> Any:
        return part.words if isinstance(part, Cited) and part.anchor not in anchors else part

    walked(tuple(kept), noted)
    return [walked(block, leading) for block in kept]
