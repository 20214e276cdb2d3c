"""Formulas in a file: Markdown with dollars, or LaTeX, and the numbers that stand beside them."""

from __future__ import annotations

import re
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from rigidtop.errors import RigidtopError
from rigidtop.notation import NOTES, Notation
from rigidtop.read.formula import Line, read

LONGEST = 2_000_000
"""A file is no longer than this (characters)."""

SECONDS = 60.0
"""A file is not read for longer than this."""


@dataclass(frozen=True)
class Formula:
    """The text between two dollars, say: where it stands in the file, whether on its own.

    The text goes from `start` on; the formula with its dollars from `opens` to `end`.
    """

    text: str
    start: int
    end: int
    display: bool
    opens: int = 0


@dataclass(frozen=True)
class Numbered:
    """The formulas that bear one number together."""

    number: str
    formulas: tuple[Formula, ...]


_ENVIRONMENTS = "equation|align|gather|multline|eqnarray|displaymath|flalign"
_OPENING = re.compile(
    r"(?P<escaped>\\\\|\\\$)"
    r"|(?P<fence>^[ \t]{0,3}```|<!--)"
    rf"|\\begin\{{(?P<name>(?:{_ENVIRONMENTS})\*?)\}}"
    r"|(?P<sign>\$\$|\\\[|\\\(|\$)",
    re.M,
)
_CLOSING = {"$$": "$$", r"\[": r"\]", r"\(": r"\)", "$": "$"}
_NUMBER = re.compile(r"[ \t\n|]*(?:</?t[dr]>)*\(\s*(\d+\.\d+[a-z]?)\s*\)[.,]?[ \t|]*(?=\n|$)")
_BLANK_LINE = re.compile(r"\n[ \t]*\n")
_INSIDE = re.compile(
    r"\\(?:tag\*?\s*\{\s*\(?|l?eqno\s*\(?)\s*(\d+\.\d+[a-z]?)"
    r"|\((\d+\.\d+[a-z]?)\)(?=[\s.,]*(?:\\end\{[a-z*]+\}\s*)*$)"
)
_RELATED = re.compile(r"[=<>]|\\(?:equiv|approx|neq?|lt|gt)(?![A-Za-z])")


def formulas(source: str) -> tuple[Formula, ...]:
    """Every formula, in order, those in code and comments left out.

    Raises RigidtopError for a file that is too long.
    """
    if len(source) > LONGEST:
        raise RigidtopError(f"a file of more than {LONGEST} characters")
    return tuple(_formulas(source))


def _formulas(source: str) -> Iterator[Formula]:
    at = 0
    missing: set[str] = set()  # closings that do not come any more: looked for only once
    while match := _OPENING.search(source, at):
        at = match.end()
        if match["escaped"]:
            continue
        if match["fence"]:
            closing = "-->" if match[0] == "<!--" else "\n```"
        else:
            closing = rf"\end{{{match['name']}}}" if match["name"] else _CLOSING[match["sign"]]
        end = -1 if closing in missing else source.find(closing, at)
        if end < 0:
            missing.add(closing)
            continue
        if match["fence"]:
            at = end + len(closing)
            continue
        inline = match["sign"] in ("$", r"\(")
        if inline:
            blank = _BLANK_LINE.search(source, at, end)
            if blank or end == at:  # a dollar that is money
                continue
        yield Formula(source[at:end], at, end + len(closing), not inline, match.start())
        at = end + len(closing)


def numbered(source: str) -> tuple[Numbered, ...]:
    """The formulas that bear a number, as `\\tag{3.57}` or in brackets at the end of the line.

    A number belongs to all displays above it between which nothing is said.
    """
    found = formulas(source)
    numbers = [_numbers_of(source, formula) for formula in found]
    made = []
    for i, inside in enumerate(numbers):
        first = i
        while inside and first and _goes_on(source, found, numbers, first):
            first -= 1
        made += [Numbered(number, found[first : i + 1]) for number in inside]
    return tuple(made)


def _numbers_of(source: str, formula: Formula) -> tuple[str, ...]:
    """The numbers of a display, one or more; that of a formula in a line, if it is an equation."""
    inside = tuple(dict.fromkeys(a or b for a, b in _INSIDE.findall(formula.text)))
    if inside:
        return inside
    beside = _NUMBER.match(source, formula.end)
    if beside and (formula.display or _RELATED.search(formula.text)):
        return (beside[1],)
    return ()


def _goes_on(
    source: str, found: Sequence[Formula], numbers: Sequence[tuple[str, ...]], first: int
) -> bool:
    """Whether the formula before belongs to the same number."""
    before, this = found[first - 1], found[first]
    if not (before.display and this.display) or numbers[first - 1]:
        return False
    return not source[before.end : this.opens].strip()


def lines(group: Numbered, notation: Notation = NOTES) -> tuple[Line, ...]:
    """The equations of a number, with their places in the file."""
    joint = "\\\\\n"
    text = joint.join(formula.text for formula in group.formulas)
    starts, at = [], 0
    for formula in group.formulas:
        starts.append((at, formula.start))
        at += len(formula.text) + len(joint)

    def place(position: int) -> int:
        begun, start = max(pair for pair in starts if pair[0] <= position)
        return start + position - begun

    made = [
        Line(place(line.position), line.equation, line.problem, line.follows, line.tag)
        for line in read(text, notation)
    ]
    return tuple(_of_number(made, group.number))


def _of_number(made: Sequence[Line], number: str) -> Sequence[Line]:
    """Those up to the tag of that number, from the tag before it on."""
    tagged = [i for i, line in enumerate(made) if line.tag]
    if len({made[i].tag for i in tagged}) < 2:
        return made
    here = [i for i in tagged if made[i].tag == number]
    if not here:
        return made
    before = [i + 1 for i in tagged if i < here[0]]
    return made[max(before, default=0) : here[-1] + 1]


def each(
    source: str, notation: Notation = NOTES, seconds: float = SECONDS
) -> Iterator[tuple[Formula, tuple[Line, ...]]]:
    """Every formula with its equations; once the time is up the rest is unread, and says so."""
    end = time.monotonic() + seconds
    for formula in formulas(source):
        if time.monotonic() > end:
            late = f"not read: {seconds:g} s for the file were over"
            yield formula, (Line(formula.start, None, late),)
            continue
        found = read(formula.text, notation)
        yield (
            formula,
            tuple(
                Line(
                    formula.start + line.position,
                    line.equation,
                    line.problem,
                    line.follows,
                    line.tag,
                )
                for line in found
            ),
        )
