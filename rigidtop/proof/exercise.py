"""What an exercise is made of: a question, its solution in symbols, its solution in numbers.

An exercise is a function of its parameters that yields what they lead to: an `Answer`, a `Table`,
or a `Measure` where two independent ways to a number are compared.  Its docstring says how the
numbers are found.  The solution in symbols are claims, judged like those of the lecture.

    @exercise(
        "toppling-top",
        "The toppling top",
        section="3.5.2",
        asks="example 34",
        statement="A top leans at θ and is let go without rotation. …",
        claims=(example_34, time_to_fall),
        parameters=(Parameter("theta", 0.5, "θ at the start", "rad", above=0, most=pi / 2), …),
        figure="toppling",
    )
    def toppling_top(theta, …):
        '''The time is an elliptic integral; the fall is integrated besides.'''
        yield Answer("time_to_fall", "time until e₃ is horizontal", seconds, "s")
        yield Measure("time to fall, closed form against integration (s)", error, 1e-9)
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any

from rigidtop.parameters import Parameter
from rigidtop.proof.page import Claim, Measure, by_lines, paragraph


@dataclass(frozen=True)
class Answer:
    """A number of the solution, in SI units and radians unless `unit` says otherwise.

    `name` is a Python name, by which programs and tests find it; `what` says it in words.
    """

    name: str
    what: str
    value: float | str
    unit: str = "1"


@dataclass(frozen=True)
class Table:
    """Many numbers; every row has as many cells as there are `columns`."""

    name: str
    title: str
    columns: tuple[str, ...]
    rows: tuple[tuple[float | str, ...], ...]

    def __post_init__(self) -> None:
        if any(len(row) != len(self.columns) for row in self.rows):
            raise ValueError(f"table {self.name}: not every row has {len(self.columns)} cells")


@dataclass(frozen=True)
class Rubric:
    """Points for an answer.

    A derivation has `line` points for each of `lines` right lines, and those of the `goal` where it
    arrives.  Of a longer one each line counts for less, so that nobody gains by padding; a wrong
    line costs once, and not again in those that follow from it.  Of an answer in numbers each has
    as many points as a `number`.
    """

    line: float = 1.0
    lines: int = 3
    goal: float = 3.0
    number: float = 1.0

    def __post_init__(self) -> None:
        points = self.line, self.goal, self.number
        if self.lines < 1 or not all(0 <= x < math.inf for x in points) or not self.total:
            raise ValueError("a rubric has points of 0 or more, not all 0, for one line or more")

    @property
    def total(self) -> float:
        return _short(self.line * self.lines + self.goal)

    def points(self, right: int, of: int, arrives: bool) -> float:
        """Those of an answer with so many right lines of all that it has."""
        return _short(
            self.line * self.lines * right / max(of, self.lines) + self.goal * bool(arrives)
        )

    def of_numbers(self, count: int) -> Rubric:
        """The rubric of an answer in as many numbers as are asked."""
        return Rubric(self.number, count, 0.0, self.number)


def _short(points: float) -> float:
    """Points to two decimals, whole ones as an integer."""
    return int(points) if points == int(points) else round(points, 2)


Outcome = Answer | Table | Measure
Solve = Callable[..., Iterable[Outcome]]


@dataclass(frozen=True)
class Exercise:
    """A question that the notes leave to their reader, and its solution.

    `asks` is where they do ("example 34"), `statement` the question in our own words, paragraphs
    separated by blank lines.  `figure` is the name of a figure; it is drawn with those parameters
    of the exercise that it has too.  `text` is the name of its solution in words and lines, a file
    in Markdown behind those of the pages; `method` says how the numbers are found.  Without a
    `rubric` each line of an answer is a point.
    """

    name: str
    title: str
    section: str
    asks: str
    statement: str
    claims: tuple[Claim, ...]
    parameters: tuple[Parameter, ...]
    solve: Solve
    figure: str = ""
    text: str = ""
    method: str = ""
    rubric: Rubric | None = None


def exercise(name: str, title: str, **given: Any) -> Callable[[Solve], Exercise]:
    """Make the decorated generator function an `Exercise`; its docstring is the method."""
    return lambda solve: Exercise(name, title, solve=solve, method=paragraph(solve), **given)


def texts(exercises: Sequence[Exercise], every: Sequence[Exercise]) -> list[str]:
    """The names of their texts, and of those of others that show a claim of theirs by its lines."""
    own = {each.name for each in exercises}
    shown = {c.name for each in exercises for c in each.claims if c.evidence is by_lines}
    return [
        each.text
        for each in every
        if each.text and (each.name in own or shown & {claim.name for claim in each.claims})
    ]
