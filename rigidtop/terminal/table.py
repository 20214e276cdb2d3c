"""Aligned tables for the terminal."""

from __future__ import annotations

import os
import shutil
import sys
import unicodedata
from collections.abc import Mapping, Sequence
from functools import cache
from typing import TextIO

from rigidtop.terminal.visible import visible

_COLORS = {"green": "32", "yellow": "33", "red": "31", "blue": "34", "magenta": "35", "dim": "2"}


def columns(text: str) -> int:
    """How many columns a terminal needs for a text: θ̈ takes one, 日 two.

    >>> columns("λ₁θ̈"), columns("日本")
    (3, 4)
    """
    return sum(_columns(c) for c in text)


@cache
def _columns(character: str) -> int:
    if unicodedata.category(character) in ("Mn", "Me", "Cf"):
        return 0
    return 2 if unicodedata.east_asian_width(character) in ("W", "F") else 1


def cut(text: str, room: int) -> str:
    """The text in at most `room` columns, with … where something was left out.

    >>> cut("λ₁θ̈ = const", 5)
    'λ₁θ̈ …'
    """
    if columns(text) <= room:
        return text
    kept, used = "", 0
    for character in text:
        if used + _columns(character) > room - 1:
            break
        kept, used = kept + character, used + _columns(character)
    return kept + "…" if room > 0 else ""


def wrapped(text: str, room: int) -> list[str]:
    """The text in lines of at most `room` columns, broken at spaces; a longer word is cut."""
    lines = [""]
    for word in text.split():
        longer = f"{lines[-1]} {word}".strip()
        if columns(longer) <= room or not lines[-1]:
            lines[-1] = longer
        else:
            lines.append(word)
    return [cut(line, room) for line in lines]


def padded(text: str, room: int, right: bool = False) -> str:
    """The text with spaces, as wide as `room` columns."""
    space = " " * max(0, room - columns(text))
    return space + text if right else text + space


def table(
    rows: Sequence[Sequence[str]],
    head: Sequence[str] = (),
    *,
    width: int | None = None,
    right: Sequence[int] = (),
    colors: Mapping[str, str] | None = None,
) -> str:
    """Rows in aligned columns; the last column is wrapped to what is left of `width`.

    `right` are the columns that are aligned to the right.  `colors` gives a colour name to the
    cells that consist of a word; pass it only when `wants_color` says so.  `width` is that of the
    terminal if it is not given, and 80 where there is none.
    """
    if not rows:
        return ""
    width = width if width is not None else shutil.get_terminal_size((80, 24)).columns
    every = [[*map(visible, row)] for row in ([head, *rows] if head else rows)]
    rooms = [max(columns(row[i]) for row in every) for i in range(len(every[0]) - 1)]
    indent = sum(rooms) + 2 * len(rooms)
    rest = max(width - indent, 12)
    lines: list[str] = []
    for number, row in enumerate(every):
        first = [
            _colored(padded(cell, room, i in right), cell, colors)
            for i, (cell, room) in enumerate(zip(row, rooms, strict=False))
        ]
        for j, piece in enumerate(wrapped(row[-1], rest)):
            start = "  ".join(first) if j == 0 else " " * (indent - 2)
            last = _colored(piece, row[-1], colors) if j == 0 else piece
            lines.append(f"{start}  {last}".rstrip() if rooms else last)
        if head and number == 0:
            longest = max(columns(line) for row in every[1:] for line in wrapped(row[-1], rest))
            lines.append("─" * min(max(indent + longest, columns(lines[0])), max(width, indent)))
    return "\n".join(lines)


def _colored(shown: str, cell: str, colors: Mapping[str, str] | None) -> str:
    if not colors or cell not in colors:
        return shown
    return shown.replace(cell, f"\033[{_COLORS[colors[cell]]}m{cell}\033[0m", 1)


def wants_color(stream: TextIO | None = None) -> bool:
    """Whether colour is welcome: on a terminal, unless NO_COLOR is set or TERM is dumb."""
    stream = stream if stream is not None else sys.stdout
    if os.environ.get("NO_COLOR") or os.environ.get("TERM") == "dumb":
        return False
    return stream.isatty()
