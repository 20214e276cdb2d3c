"""Aligned tables, and paragraphs, as wide as the terminal."""

from __future__ import annotations

import os
import shutil
import sys
import unicodedata
from collections.abc import Mapping, Sequence
from functools import cache
from typing import TextIO

from rigidtop.terminal.visible import visible

LEAST = 12
"""A column of text is no narrower."""

_COLORS = {"green": "32", "yellow": "33", "red": "31", "blue": "34", "magenta": "35", "dim": "2"}


def terminal_width() -> int:
    """How many columns the terminal has; 80 where there is none, and COLUMNS says it otherwise."""
    return shutil.get_terminal_size((80, 24)).columns


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


def broken(formula: str, room: int, indent: str = "") -> list[str]:
    """A formula in lines of at most `room` columns, begun with `indent`, the later ones deeper.

    A line ends where few brackets are open: best behind a row, then behind a comma, in front of a
    relation, of a plus or minus.  What has no space stays wider.

    >>> broken("L = a(b + c + d) + e", 17)
    ['L = a(b + c + d)', '  + e']
    """
    lines, first = [], indent
    while columns(first + formula) > room and (end := _end(formula, room - columns(first))):
        lines.append(first + formula[:end].rstrip())
        formula, first = formula[end:].lstrip(), indent + "  "
    return [*lines, first + formula]


def _end(formula: str, room: int) -> int:
    """Where the first line of a formula is to end; 0 where nothing ends in its `room`."""
    depth, used, best, end = 0, 0, (0, 0), 0
    for place, character in enumerate(formula):
        depth += (character in "([{") - (character in ")]}")
        if character == " " and used:
            cost = depth, _cost(formula[place - 1], formula[place + 1 : place + 2])
            # A line that is hardly begun ends only where there is no other place.
            if not end or cost <= best or 3 * columns(formula[:end]) < room:
                best, end = cost, place
        used += _columns(character)
        if used > room:
            break
    return end


def _cost(before: str, behind: str) -> int:
    """How little a line of a formula likes to end between two characters."""
    good = (before == ";", before == ",", behind in "=≈≡≠<>≤≥", behind in "+−±∓")
    return good.index(True) if True in good else len(good)


def paragraph(text: str, first: str = "", rest: str = "") -> str:
    """A text in lines as wide as the terminal, the `first` and the `rest` begun so.

    >>> print(paragraph("one two " * 12, "- ", "  "))
    - one two one two one two one two one two one two one two one two one two one
      two one two one two
    """
    room = max(terminal_width() - max(columns(first), columns(rest)), LEAST)
    lines = wrapped(text, room)
    return "\n".join((rest if k else first) + line for k, line in enumerate(lines))


def message(text: str, stream: TextIO) -> str:
    """What a terminal shows in its width, line by line; elsewhere the text, for programs."""
    if not stream.isatty():
        return text
    return "\n".join(paragraph(line, rest="  ") for line in text.split("\n"))


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

    So is the first where it leaves no room for another.  Columns that find no room stand in a table
    below, beside the first, which says what a row is.  `right` are the columns that are aligned to
    the right.  `colors` gives a colour name to the cells that consist of a word; pass it only when
    `wants_color` says so.  `width` is that of the terminal if it is not given.
    """
    if not rows:
        return ""
    room = terminal_width() if width is None else width
    whole = [[*map(visible, row)] for row in ([head, *rows] if head else rows)]
    every = _narrowed(whole, room)
    return "\n\n".join(
        _table(
            [[row[i] for i in beside] for row in every],
            bool(head),
            room,
            [k for k, i in enumerate(beside) if i in right],
            colors,
        )
        for beside in _abreast(every, room)
    )


def _narrowed(every: Sequence[list[str]], width: int) -> Sequence[list[str]]:
    """The rows, the first column wrapped where the widest of the others finds no room beside it.

    It leaves room for all others if a third of the width is left for itself.
    """
    first, *others = (max(map(columns, cells)) for cells in zip(*every, strict=True))
    others[-1:] = [min(each, LEAST) for each in others[-1:]]  # the last one is wrapped
    if not others or first + 2 + max(others) <= width:
        return every
    beside = sum(each + 2 for each in others)
    room = width - (beside if 3 * (width - beside) >= width else 2 + max(others))
    return [
        [piece, *(row[1:] if k == 0 else [""] * len(others))]
        for row in every
        for k, piece in enumerate(wrapped(row[0], max(room, LEAST)))
    ]


def _abreast(every: Sequence[Sequence[str]], width: int) -> list[list[int]]:
    """Which columns find room beside one another, each time with the first."""
    longest = [max(map(columns, cells)) for cells in zip(*every, strict=True)]
    longest[-1] = min(longest[-1], LEAST)  # the last one is wrapped
    groups, used = [[0]], longest[0]
    for column, length in enumerate(longest[1:], 1):
        if length and used + 2 + length > width and groups[-1][1:]:
            groups.append([0])
            used = longest[0]
        groups[-1].append(column)
        used += 2 + length
    return groups


def _table(
    every: Sequence[Sequence[str]],
    head: bool,
    width: int,
    right: Sequence[int],
    colors: Mapping[str, str] | None,
) -> str:
    """Rows, the first of them perhaps a `head`, in columns that find room beside one another."""
    rooms = [max(columns(row[i]) for row in every) for i in range(len(every[0]) - 1)]
    indent = sum(rooms) + 2 * len(rooms)
    rest = max(width - indent, LEAST)
    last = len(rooms)
    number = min(max(columns(row[-1]) for row in every), rest) if rooms and last in right else 0
    lines: list[str] = []
    for place, row in enumerate(every):
        first = [
            _colored(padded(cell, room, i in right), cell, colors)
            for i, (cell, room) in enumerate(zip(row, rooms, strict=False))
        ]
        for j, piece in enumerate(wrapped(row[-1], rest)):
            start = "  ".join(first) if j == 0 else " " * (indent - 2)
            text = padded(piece, number, right=True)
            text = _colored(text, row[-1], colors) if j == 0 else text
            lines.append(f"{start}  {text}".rstrip() if rooms else text)
        if head and place == 0:
            longest = max(columns(line) for row in every[1:] for line in wrapped(row[-1], rest))
            ends = indent + longest if longest else max(indent - 2, 0)
            lines.append("─" * min(max(ends, columns(lines[0])), max(width, ends)))
    return "\n".join(lines)


def _colored(text: str, cell: str, colors: Mapping[str, str] | None) -> str:
    if not colors or cell not in colors:
        return text
    return text.replace(cell, f"\033[{_COLORS[colors[cell]]}m{cell}\033[0m", 1)


def wants_color(stream: TextIO | None = None) -> bool:
    """Whether colour is welcome: on a terminal, unless NO_COLOR is set or TERM is dumb."""
    stream = stream if stream is not None else sys.stdout
    if os.environ.get("NO_COLOR") or os.environ.get("TERM") == "dumb":
        return False
    return stream.isatty()
