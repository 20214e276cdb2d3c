"""A claim as plain text for the terminal."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence

from rigidtop.report import blocks as b
from rigidtop.terminal.table import broken, table
from rigidtop.terminal.visible import visible
from rigidtop.typeset.text import text
from rigidtop.typeset.words import unmarked


def fragment(blocks: Sequence[b.Block], width: int = 88) -> str:
    """The blocks of a claim or an exercise in `width` columns."""
    joined = "\n".join(line for block in blocks for line in _lines(block, width))
    return visible(joined.lstrip("\n") + "\n")


rich = b.Script(words=unmarked, formula=text, unit=str, cited=lambda place: place.words)


def _wrapped(words: str, width: int, first: str = "", rest: str = "") -> list[str]:
    return textwrap.wrap(
        unmarked(words), width, initial_indent=first, subsequent_indent=rest, break_on_hyphens=False
    )


def _lines(block: b.Block, width: int) -> list[str]:
    match block:
        case b.ClaimHead():
            return ["", f"{block.shown}  [{block.verdict}]", *_wrapped(block.says, width)]
        case b.Paragraph():
            label = f"{block.label}: " if block.label else ""
            return ["", *_wrapped(label + rich(block.content), width)]
        case b.Display():
            rows = [line for row in block.rows for line in _row(row, width)]
            return ["", *[f"{block.label}:"] * bool(block.label), *rows]
        case b.Items():
            items = [_wrapped(rich(item), width, "  • ", "    ") for item in block.items]
            return ["", f"{block.label}:", *(line for item in items for line in item)]
        case b.ExerciseHead():
            return _wrapped(f"{block.title}  ({block.asks})", width)
        case b.Subhead(words=words) | b.Aside(title=words):
            return ["", f"── {unmarked(words)} ".ljust(width, "─")]
        case b.AsideEnd():
            return ["", "─" * width]
        case b.TableBlock():
            return _table(block, width)
    raise TypeError(f"no text for {type(block).__name__}")


def _row(row: b.DisplayRow, width: int) -> list[str]:
    """The lines of an equation, below the sentence that belongs to it."""
    reason = _wrapped(rich(row.spoken), width, "  ", "  ") if row.reason else []
    marks = (f"({row.tag})" if row.tag else "", f"[{row.verdict}]" if row.verdict else "")
    line = "  ".join(filter(None, (text(row.equation, row.order), *marks)))
    return [*reason, *broken(line, width, "    ")]


def _table(block: b.TableBlock, width: int) -> list[str]:
    rows = [[*map(rich, row)] for row in block.cells]
    if block.kind == "values":
        values = [(value, unit.strip(), what) for what, value, unit in rows]
        return ["", f"{block.title}:", *_indented(table(values, right=(0,), width=width - 2))]
    # The last column of a table is text: here one without any.
    head = (*map(unmarked, block.head), "")
    lines = table([(*row, "") for row in rows], head, right=block.right, width=width - 2)
    return ["", *_wrapped(f"{block.title}:", width), *_indented(lines)]


def _indented(lines: str) -> list[str]:
    return [f"  {line}" for line in lines.splitlines()]
