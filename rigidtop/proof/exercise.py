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


Outcome = Answer | Table | Measure
Solve = Callable[..., Iterable[Outcome]]


@dataclass(frozen=True)
class Exercise:
    """A question that the notes leave to their reader, and its solution.

    `asks` is where they do ("example 34"), `statement` the question in our own words, paragraphs
    separated by blank lines.  `figure` is the name of a figure; it is drawn with those parameters
    of the exercise that it has too.  `text` is the name of its solution in words and lines, a file
    in Markdown behind those of the pages; `method` says how the numbers are found.
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
