"""Formulas in a file: Markdown with dollars, or LaTeX, and the numbers that stand beside them."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from rigidtop.notation import NOTES, Notation
from rigidtop.read.formula import Line, read


@dataclass(frozen=True)
class Formula:
    """The text between two dollars, say: where it stands in the file, whether on its own."""

    text: str
    start: int
    end: int
    display: bool


@dataclass(frozen=True)
class Numbered:
    """The formulas that bear one number together."""

    number: str
    formulas: tuple[Formula, ...]


_ENVIRONMENTS = "equation|align|gather|multline|eqnarray|displaymath"
_FORMULA = re.compile(
    r"\$\$(?P<dollars>.+?)\$\$"
    r"|\\\[(?P<square>.+?)\\\]"
    rf"|\\begin\{{(?P<name>(?:{_ENVIRONMENTS})\*?)\}}(?P<environment>.+?)\\end\{{(?P=name)\}}"
    r"|(?<![\\$])\$(?P<inline>[^$\n]+)\$"
    r"|\\\((?P<round>.+?)\\\)",
    re.S,
)
_NUMBER = re.compile(r"\(\s*(\d+\.\d+[a-z]?)\s*\)[ \t]*(?:\n|$)")
_INSIDE = re.compile(r"\\tag\{\s*(\d+\.\d+[a-z]?)\s*\}|\((\d+\.\d+[a-z]?)\)(?=[\s.,]*$)")


def formulas(source: str) -> tuple[Formula, ...]:
    """Every formula, in order."""
    found = []
    for match in _FORMULA.finditer(source):
        kind = match.lastgroup or ""
        display = kind not in ("inline", "round")
        found.append(Formula(match[kind], match.start(kind), match.end(), display))
    return tuple(found)


def numbered(source: str) -> tuple[Numbered, ...]:
    """The formulas that bear a number, as `\\tag{3.57}` or in brackets at the end of the line.

    A number belongs to all displays above it between which nothing is said.
    """
    found = formulas(source)
    numbers = [_number_of(source, formula) for formula in found]
    made = []
    for i, number in enumerate(numbers):
        if not number:
            continue
        first = i
        while first and found[i].display and _goes_on(source, found, numbers, first):
            first -= 1
        made.append(Numbered(number, found[first : i + 1]))
    return tuple(made)


def _number_of(source: str, formula: Formula) -> str:
    inside = _INSIDE.search(formula.text)
    if inside:
        return inside[1] or inside[2]
    behind = re.compile(r"\s*").match(source, formula.end)
    beside = _NUMBER.match(source, behind.end() if behind else formula.end)
    return beside[1] if beside else ""


def _goes_on(source: str, found: Sequence[Formula], numbers: Sequence[str], first: int) -> bool:
    """Whether the formula before belongs to the same number."""
    before, this = found[first - 1], found[first]
    between = source[before.end : source.rfind("$$", 0, this.start)]
    return before.display and not numbers[first - 1] and not between.strip()


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

    return tuple(
        Line(place(line.position), line.equation, line.problem, line.follows)
        for line in read(text, notation)
    )
