"""Formulas in a file: Markdown with dollars, or LaTeX, and the numbers that stand beside them."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

from rigidtop.errors import RigidtopError
from rigidtop.notation import NOTES, Notation
from rigidtop.read import left
from rigidtop.read.equations import ReadEquation, equations
from rigidtop.read.left import NUMBER, RELATED, TAG, N, bared
from rigidtop.read.macros import PACKAGES, Macros
from rigidtop.read.walk import Formula, Problem, Walk

MOST_NUMBERS = 5_000
"""A file has no more numbered equations."""


@dataclass(frozen=True)
class Numbered:
    """The formulas that bear one number together."""

    number: str
    formulas: tuple[Formula, ...]


_INSIDE = re.compile(
    rf"{TAG}|\\l?eqno\s*\(?\s*({N})|\\q?quad\s*\(({N})\)(?=[\s.,]*$)"
    r"|\((\d+\.\d+[a-z]?)\)(?=[\s.,]*(?:\\end\s*\{\s*[A-Za-z*]+\s*\}\s*)*$)"
)


def formulas(source: str) -> tuple[Formula, ...]:
    """Every formula, in order, those in code and comments left out.

    Raises RigidtopError for a file that is too long.
    """
    return _read(source).formulas


def problems(source: str) -> tuple[Problem, ...]:
    """Where mathematics stands in a file that `formulas` does not have, in order.

    A stray dollar, an opening without its closing, an unknown environment, a comment.
    """
    return _read(source).problems


def bare(source: str) -> tuple[Problem, ...]:
    """The lines with mathematics outside of all dollars and the like, in order."""
    return _read(source).bare


@dataclass(frozen=True)
class _Read:
    formulas: tuple[Formula, ...]
    problems: tuple[Problem, ...]
    bare: tuple[Problem, ...]
    lost: tuple[tuple[str, Formula], ...]


@lru_cache(maxsize=2)
def _read(source: str) -> _Read:
    walk = Walk(source)
    bare, lost = tuple(left.bare(walk)), tuple(left.lost(walk))
    problems = sorted(set(walk.problems), key=lambda problem: problem.position)
    return _Read(tuple(walk.found), tuple(problems), bare, lost)


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
        for number in inside:
            made.append(Numbered(number, found[first : i + 1]))
            first = i  # what stands above belongs to the first of several numbers
    made += [Numbered(number, (formula,)) for number, formula in _read(source).lost]
    if len(made) > MOST_NUMBERS:
        raise RigidtopError(f"a file of more than {MOST_NUMBERS} numbered equations: split it")
    return tuple(sorted(made, key=lambda group: group.formulas[-1].opens))


def _numbers_of(source: str, formula: Formula) -> tuple[str, ...]:
    """The numbers of a display, one or more; that of a formula in a line, if it is an equation."""
    tagged = (bared("".join(groups)) for groups in _INSIDE.findall(formula.text))
    inside = tuple(dict.fromkeys(filter(None, tagged)))
    if inside:
        return inside
    beside = NUMBER.match(source, formula.end)
    if beside and (formula.display or RELATED.search(formula.text)):
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


def lines(
    group: Numbered, notation: Notation = NOTES, macros: Macros = PACKAGES
) -> tuple[ReadEquation, ...]:
    """The equations of a number, with their places in the file."""
    for formula in group.formulas:
        if formula.problem:
            return (ReadEquation(formula.start, None, formula.problem, tag=group.number),)
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
        replace(line, position=place(line.position)) for line in equations(text, notation, macros)
    ]
    return tuple(_of_number(made, group.number))


def _of_number(made: Sequence[ReadEquation], number: str) -> Sequence[ReadEquation]:
    """Those up to the tag of that number, from the tag before it on; to the last all behind it."""
    tagged = [i for i, line in enumerate(made) if line.tag]
    if len({made[i].tag for i in tagged}) < 2:
        return made
    here = [i for i in tagged if made[i].tag == number]
    if not here:
        return made
    before = [i + 1 for i in tagged if i < here[0]]
    behind = here[-1] + 1 if here[-1] < tagged[-1] else len(made)
    return made[max(before, default=0) : behind]
