"""A claim as plain text for the terminal."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from functools import singledispatch

from rigidtop.proof.words import unmarked
from rigidtop.report import blocks as b
from rigidtop.terminal.table import table
from rigidtop.terminal.visible import visible
from rigidtop.typeset.text import text


def fragment(blocks: Sequence[b.Block], width: int = 88) -> str:
    """The blocks of a claim or an exercise in `width` columns; equations are never wrapped."""
    made = "\n".join(line for block in blocks for line in _lines(block, width))
    return visible(made.lstrip("\n") + "\n")


def rich(content: b.Rich) -> str:
    """Running text with formulas."""
    return "".join(map(_piece, content))


def _piece(piece: b.Piece) -> str:
    if isinstance(piece, b.Unit):
        return piece.spaced
    if isinstance(piece, b.Cited):
        return piece.words
    return unmarked(piece) if isinstance(piece, str) else text(piece)


def _wrapped(words: str, width: int, first: str = "", rest: str = "") -> list[str]:
    return textwrap.wrap(
        unmarked(words), width, initial_indent=first, subsequent_indent=rest, break_on_hyphens=False
    )


@singledispatch
def _lines(block: b.Block, width: int) -> list[str]:
    raise TypeError(f"no text for {type(block).__name__}")


@_lines.register
def _(block: b.ClaimHead, width: int) -> list[str]:
    return ["", f"{block.shown}  [{block.verdict}]", *_wrapped(block.says, width)]


@_lines.register
def _(block: b.Paragraph, width: int) -> list[str]:
    label = f"{block.label}: " if block.label else ""
    return ["", *_wrapped(label + rich(block.content), width)]


@_lines.register
def _(block: b.Display, width: int) -> list[str]:
    made = ["", f"{block.label}:"] if block.label else [""]
    for row in block.rows:
        reason = _wrapped(rich(row.spoken), width, "  ", "  ") if row.reason else []
        marks = (f"({row.tag})" if row.tag else "", f"[{row.verdict}]" if row.verdict else "")
        equation = "  ".join(filter(None, (f"    {text(row.equation, row.order)}", *marks)))
        made += [*reason, equation]
    return made


@_lines.register
def _(block: b.Items, width: int) -> list[str]:
    made = ["", f"{block.label}:"]
    for item in block.items:
        made += _wrapped(rich(item), width, "  • ", "    ")
    return made


@_lines.register
def _(block: b.ExerciseHead, width: int) -> list[str]:
    return _wrapped(f"{block.title}  ({block.asks})", width)


@_lines.register
def _(block: b.Subhead, width: int) -> list[str]:
    return ["", f"── {unmarked(block.words)} ".ljust(width, "─")]


@_lines.register
def _(block: b.Table, width: int) -> list[str]:
    rows = [[*map(rich, row)] for row in block.cells]
    if block.kind == "values":
        values = [(value, unit.strip(), what) for what, value, unit in rows]
        return ["", f"{block.title}:", *_indented(table(values, right=(0,), width=width - 2))]
    # The last column of a table is text: here one without any.
    head = (*map(unmarked, block.head), "")
    made = table([(*row, "") for row in rows], head, right=block.right, width=width - 2)
    return ["", *_wrapped(f"{block.title}:", width), *_indented(made)]


def _indented(lines: str) -> list[str]:
    return [f"  {line}" for line in lines.splitlines()]
