"""What became of a numbered equation of a file: its lines, its verdict, one line of words."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from rigidtop.judge.outcome import UNREAD as UNREAD
from rigidtop.mark.ruling import Ruling, refutation
from rigidtop.proof.equation import Equation
from rigidtop.proof.page import Claim, Page
from rigidtop.proof.verdict import Judgement, Verdict
from rigidtop.read.document import Numbered
from rigidtop.report.records import note as said_of
from rigidtop.typeset.text import text

UNKNOWN, ABSENT = "unknown", "absent"
"""What is said in place of a verdict: a number of no claim, no equation."""

LATE = "not judged: the time for the file was over"


@dataclass(frozen=True)
class Placed:
    """An equation of the file with its place: line and column count from 1."""

    line: int
    column: int
    equation: Equation | None
    ruling: Ruling

    @property
    def verdict(self) -> str:
        """A verdict, or `UNREAD`."""
        return UNREAD if self.equation is None else self.ruling.verdict.value


@dataclass(frozen=True)
class Audited:
    """A numbered equation of the file and its verdict.

    `judgement` is the claim with what the file says in it; None where there is no such claim.
    `absent` are equations of the claim to which nothing in the file corresponds.
    """

    group: Numbered
    placed: tuple[Placed, ...]
    judgement: Judgement | None
    absent: tuple[Equation, ...] = ()

    @property
    def number(self) -> str:
        return self.group.number

    @property
    def line(self) -> int:
        """The line of the file where the equation begins."""
        return self.placed[0].line

    @property
    def verdict(self) -> str:
        """A verdict, or `UNREAD` or `UNKNOWN`; what is refuted comes before what is unread."""
        if any(each.ruling.verdict is Verdict.FALSE for each in self.placed):
            return Verdict.FALSE.value
        if any(each.equation is None for each in self.placed):
            return UNREAD
        return UNKNOWN if self.judgement is None else self.judgement.verdict.value

    @property
    def passed(self) -> bool:
        """Whether every line was read and is as right as the collection knows it."""
        return self.judgement is not None and not any(each.ruling.wrong for each in self.placed)

    @property
    def note(self) -> str:
        """One line: what is wrong and where, or what is assumed; what is not there."""
        parts = [self._of_line(each) for each in self.placed if not self._is_fine(each)]
        if self.judgement is None:
            parts += [] if LATE in parts else ["the collection has no claim of this number"]
        elif not parts:
            parts = list(filter(None, [said_of(self.judgement)]))
        if self.absent:
            told = ", ".join(text(equation, "printed") for equation in self.absent)
            parts.append(f"not among the file's lines: {told}")
        return "; ".join(parts)

    def _is_fine(self, each: Placed) -> bool:
        return each.equation is not None and (self.judgement is None or not each.ruling.wrong)

    def _of_line(self, each: Placed) -> str:
        """Why a line does not pass."""
        ruling, found = each.ruling, each.ruling.finding
        parts = [ruling.problem] if ruling.problem else []
        if found is not None and found.counterexample is not None and not ruling.problem:
            parts.append(refutation(found, found.counterexample))
        if found is not None and not parts:
            parts.append("neither shown nor refuted")
        if ruling.instead is not None:
            parts.append(f"the claim has {text(ruling.instead, 'printed')}")
        where = [f"line {each.line}"] if each.line != self.line else []
        where += [f"column {each.column}"] if each.equation is None and parts != [LATE] else []
        return (f"{', '.join(where)}: " if where else "") + "; ".join(parts)


def missing(audited: Sequence[Audited], pages: Iterable[Page]) -> tuple[Claim, ...]:
    """The collection's claims between the first and the last that the file has, not in it."""
    claims = [c for page in pages for c in page.claims if re.fullmatch(r"\d+\.\d+[a-z]?", c.name)]
    there = {each.number for each in audited}
    places = [i for i, claim in enumerate(claims) if claim.name in there]
    if not places:
        return ()
    return tuple(c for c in claims[places[0] : places[-1]] if c.name not in there)
