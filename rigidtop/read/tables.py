"""Tables of letters in Markdown: those whose first column is headed "letter"."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass

_TABLE = re.compile(r"^[ \t]*\|[ \t]*letter[ \t]*\|[^\n]*(?:\n[ \t]*\|[^\n]*)*", re.M | re.I)
_RULE = re.compile(r"[-: ]+")


@dataclass(frozen=True)
class TableRow:
    """A row of a table with its cells, and the line of the file in which it stands."""

    line: int
    cells: tuple[str, ...]


def is_of_letters(paragraph: str) -> bool:
    """Whether a paragraph is a table of letters."""
    return _TABLE.fullmatch(paragraph.rstrip()) is not None


def rows(source: str) -> Iterator[TableRow]:
    """The rows of all tables of letters, without their heads.

    >>> [row.cells for row in rows("| letter | unit |\\n| --- | --- |\\n| $m$ | kg |")]
    [('$m$', 'kg')]
    """
    for table in _TABLE.finditer(source):
        first = source.count("\n", 0, table.start()) + 1
        for k, line in enumerate(table[0].splitlines()):
            cells = tuple(cell.strip() for cell in line.strip().strip("|").split("|"))
            if k and not all(_RULE.fullmatch(cell) for cell in cells):
                yield TableRow(first + k, cells)
