"""What becomes of an answer: each line with its mark, and the whole."""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import StrEnum

from rigidtop.proof.exercise import Rubric


class Mark(StrEnum):
    """What becomes of a line."""

    FOLLOWS = "follows"
    DEFINITION = "definition"
    ASSUMPTION = "assumption"
    WRONG = "wrong"
    CARRIED = "carried"
    INCONCLUSIVE = "inconclusive"
    UNREAD = "unread"


SOUND = (Mark.FOLLOWS, Mark.DEFINITION, Mark.ASSUMPTION)
_UNSURE = {Mark.INCONCLUSIVE: "neither shown nor refuted", Mark.UNREAD: "not read"}


@dataclass(frozen=True)
class Marked:
    """A line of the answer: where it stands in the file, what was read, what became of it.

    `slip` is what is wrong with it where one change makes it right, and `right` that line in TeX.
    """

    line: int
    said: str
    mark: Mark
    note: str = ""
    slip: str = ""
    right: str = ""
    behind: int = 0
    """The wrong line that it follows from, if it does."""
    position: int = -1
    """Where in the text it begins."""


@dataclass(frozen=True)
class Marking:
    """A derivation, marked.

    `lost` are branches that a right line leaves out; `way` says what the pages have and it has not.
    Without a `rubric` each line is a point.
    """

    lines: tuple[Marked, ...]
    arrives: bool
    goal: str
    lost: tuple[str, ...] = ()
    problem: str = ""
    way: str = ""
    rubric: Rubric | None = None

    @property
    def first_wrong(self) -> Marked | None:
        return next((line for line in self.lines if line.mark is Mark.WRONG), None)

    @property
    def points(self) -> tuple[float, float]:
        """The points, and how many there are."""
        if self.rubric is None:
            return self.right
        return self.rubric.points(*self.right, self.arrives), self.rubric.total

    @property
    def right(self) -> tuple[int, int]:
        """How many lines are right, those right behind a wrong one among them, of how many."""
        right = [line.mark in SOUND or bool(line.behind) for line in self.lines]
        return sum(right), len(right)

    @property
    def passed(self) -> bool:
        """Every line was read and follows, and the goal is reached."""
        return self.arrives and all(line.mark in SOUND for line in self.lines)

    @property
    def summary(self) -> str:
        """One line for the whole."""
        wrong = self.first_wrong
        if wrong is not None:
            points = "{} of {}".format(*self.right)
            behind = [str(line.line) for line in self.lines if line.behind]
            lines = f"line{'s' * (len(behind) > 1)} {', '.join(behind)}"
            right = f"; {lines} right from there" if behind else ""
            return f"line {wrong.line} does not follow{right}: {points} lines"
        unsure = [line for line in self.lines if line.mark in (Mark.INCONCLUSIVE, Mark.UNREAD)]
        if unsure:
            return f"inconclusive: line {unsure[0].line} was {_UNSURE[unsure[0].mark]}"
        if not self.lines:
            return "there is no line to mark"
        if self.problem:
            return self.problem
        arrives = "and the derivation arrives"
        if not self.arrives:
            arrives = "but the derivation does not arrive"
        said = f"every line follows, {arrives} at ({self.goal})"
        return f"{said}; {self.way}" if self.way else said

    @property
    def record(self) -> dict[str, object]:
        """As plain values, for JSON.

        >>> Marking((), True, "3.57").record["summary"]
        'there is no line to mark'
        """
        lines = [
            {
                "line": line.line,
                "read": line.said,
                "verdict": line.mark.value,
                "note": line.note,
                "slips": [{"words": line.slip, "right": line.right}] if line.slip else [],
            }
            for line in self.lines
        ]
        points = dict(zip(("points", "of"), self.points, strict=True))
        found = {"arrives": self.arrives, "lost": [*self.lost], "passed": self.passed}
        return {"lines": lines, **points, **found, "summary": self.summary}


# --- Kinds of slips ------------------------------------------------------------------------------

_KINDS = (
    (r"\bsign\b", "a sign"),
    (r"\bunit$|degrees for radians", "a unit"),
    (r"exchanged|turned over", "two things exchanged"),
    (r"\bdots? on|rate of", "a dot"),
    (r"squared$|\broot\b|power of|[²³⁴].* in place of|in place of .*[²³⁴]", "a power or a root"),
    (r"\b(?:sin|cos|tan|cot|sinh|cosh)\b.* in place of", "a function or its argument"),
    (r"factor|times|^\S*\d\S* in place of|^[½⅓⅔¼]", "a number or a factor"),
    (r"^no |, too$", "a term too many or too few"),
    (r"in place of", "a letter"),
)


def kind(slip: str) -> str:
    """What kind of slip it is, in words that do not say where.

    >>> kind("another sign before λ₃ ω₃ Ω"), kind("2 times M g R"), kind("ψ in place of φ")
    ('a sign', 'a number or a factor', 'a letter')
    """
    return next((name for pattern, name in _KINDS if re.search(pattern, slip)), "another slip")
