"""A text that somebody is writing, audited again after each change."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import zip_longest
from pathlib import Path
from typing import TYPE_CHECKING

from rigidtop.commands.notes import NoFormulasError, Notes, audited
from rigidtop.judge.carried import Older
from rigidtop.judge.judge import Judge
from rigidtop.judge.outcome import UNDECIDED, Outcome
from rigidtop.judge.text import (
    Asked,
    Knowledge,
    Reading,
    Row,
    TextStep,
    reading,
    rows_of,
    start,
    step,
)
from rigidtop.read.project import sources, whole

if TYPE_CHECKING:
    from rigidtop.collection import Collection
    from rigidtop.commands.findings import AuditFinding
    from rigidtop.read.macros import Macros


Refusal = Callable[[Asked, Reading], str]
"""Why something that a text asks is not to be judged, "" if it is."""


FEW = 8
"""So many statements are judged in about the time in which a text is read again."""


class OldTextError(Exception):
    """What is being judged has been changed in the meantime."""


class EnoughError(Exception):
    """What has not been judged is to be told as it was."""


@dataclass
class History:
    """How far a text has been judged, so that what is as before is not judged again.

    What a text says of all its letters has to be as it was. `whole` is the last text that has been
    judged to its end, if this one has not.
    """

    source: tuple[str, Macros] | None = None
    read: Reading | None = None
    steps: list[TextStep] = field(default_factory=list)
    whole: tuple[Reading, list[TextStep]] | None = None

    def rows(self, text: str, macros: Macros, until: float, refusal: Refusal) -> tuple[Row, ...]:
        """Each statement as it is judged, in order.

        `refusal` is asked before each one, and may raise an error that ends it all.
        """
        read = self._reading(text, macros, until)
        older = [*self._begin(read)]
        judge = Judge()

        def made(asked: Asked) -> TextStep:
            behind = self.steps[-1].behind if self.steps else start(read)
            as_before = next((x for each in older if (x := each.carried(self.steps))), None)
            if as_before is not None:
                return as_before
            why = refusal(asked, read)
            return _refused(asked, why, behind) if why else step(asked, read, judge, behind, until)

        try:
            for asked in read.asked:
                self.steps.append(made(asked))
        except EnoughError:
            return rows_of([*self.steps, *self._as_they_were(older)])
        self.whole = None
        return rows_of(self.steps)

    def _reading(self, text: str, macros: Macros, until: float) -> Reading:
        """What a text asks: that of the last one, if it has only not been judged to its end."""
        if self.read is not None and self.source == (text, macros) and not self.is_whole:
            return self.read
        read = reading(text, macros, until)
        self.source = text, macros
        return read

    def _as_they_were(self, older: Sequence[Older]) -> Iterator[TextStep]:
        """The steps that are still to be made, where there were some."""
        for place in range(len(self.steps), len(self.read.asked) if self.read else 0):
            yield from (x for each in older[-1:] if (x := each.as_it_was(place)) is not None)

    @property
    def is_whole(self) -> bool:
        """Whether the text has been judged to its end."""
        return self.read is not None and len(self.steps) == len(self.read.asked)

    def _begin(self, read: Reading) -> Iterator[Older]:
        """Nothing of a text is judged yet; what was judged before of others."""
        if self.read is not None:
            yield Older(self.read, self.steps, read)
            if self.is_whole:
                self.whole = self.read, self.steps
        if self.whole is not None and self.whole[1] is not self.steps:
            yield Older(*self.whole, read)
        self.read, self.steps = read, []


def _refused(asked: Asked, why: str, behind: Knowledge) -> TextStep:
    """What is left open; behind it the same is known as before."""
    outcome = Outcome(UNDECIDED, why)
    return TextStep(
        asked, Row(asked.line, asked.statement, outcome, asked.passage, asked.number), behind
    )


@dataclass(frozen=True)
class Lines:
    """The lines of a text as a protocol counts them: from 0, and columns in units of UTF-16.

    >>> lines = Lines("a\\n𝜔 = 1")
    >>> lines.place(4), lines.position(1, 3), lines.place(99)
    ((1, 3), 4, (1, 6))
    """

    text: str

    @cached_property
    def starts(self) -> tuple[int, ...]:
        return (0, *(match.end() for match in re.finditer(r"\n", self.text)))

    def place(self, position: int) -> tuple[int, int]:
        """The line of a position, and its column."""
        line = bisect_right(self.starts, position) - 1
        return line, _units(self.text[self.starts[line] : position])

    def span(self, line: int) -> tuple[int, int]:
        """Where a line begins and ends; the end of the text where it has no such line."""
        if not 0 <= line < len(self.starts):
            return len(self.text), len(self.text)
        end = self.text.find("\n", self.starts[line])
        return self.starts[line], end if end >= 0 else len(self.text)

    def position(self, line: int, column: int) -> int:
        """Where a line and a column are; a line ends where it has fewer columns."""
        start, end = self.span(line)
        units = self.text[start:end].encode("utf-16-le")[: 2 * column]
        return start + len(units.decode("utf-16-le", "ignore"))


def well_formed(text: str) -> str:
    """A text from elsewhere with the ends of lines as the judge has them, and Unicode alone."""
    text = text.replace("\r\n", "\n").replace("\r", "\n").replace("\0", "\ufffd")
    return text.encode("utf-16-le", "surrogatepass").decode("utf-16-le", "replace")


def _units(text: str) -> int:
    return len(text.encode("utf-16-le")) // 2


@dataclass(frozen=True)
class TextRemark:
    """What is said of some characters of a text; `repair` is what they have to be, in LaTeX."""

    start: int
    end: int
    finding: AuditFinding
    repair: str = ""


@dataclass(frozen=True)
class Audit:
    """A text with what is remarked on it, and with its notes where it has formulas.

    Where it `is_whole` all of it has been judged, and nothing is told as it was.
    """

    text: str
    remarks: tuple[TextRemark, ...] = ()
    notes: Notes | None = None
    is_whole: bool = True

    @cached_property
    def lines(self) -> Lines:
        return Lines(self.text)

    def at(self, position: int) -> tuple[TextRemark, ...]:
        """What is remarked on a place, the wrong ones first."""
        there = [each for each in self.remarks if each.start <= position <= each.end]
        return tuple(sorted(there, key=lambda each: not each.finding.is_wrong))


@dataclass
class Draft:
    """A text that changes, where it is saved, and how far it has been judged."""

    path: Path
    history: History = field(default_factory=History)

    def audit(
        self,
        text: str,
        collection: Collection,
        is_old: Callable[[], bool] = lambda: False,
        is_enough: Callable[[], bool] = lambda: False,
    ) -> Audit:
        """The newest text audited; raises OldTextError once it is not the newest any more.

        Once it `is_enough` the rest is told as it was, unless it is little.
        """

        def refusal(asked: Asked, read: Reading) -> str:
            if is_old():
                raise OldTextError
            left = len(read.asked) - len(self.history.steps)
            if left > FEW and is_enough():
                raise EnoughError
            return ""

        return self.audit_but(text, collection, refusal)

    def audit_but(self, text: str, collection: Collection, refusal: Refusal) -> Audit:
        """A text audited but for what is refused."""

        def judge(text: str, macros: Macros, until: float) -> tuple[Row, ...]:
            return self.history.rows(text, macros, until, refusal)

        files = sources(self.path, text)
        try:
            notes = audited(files, collection, judge)
        except NoFormulasError:
            return Audit(text, is_whole=self.history.is_whole)
        return Audit(text, tuple(_remarks(notes)), notes, self.history.is_whole)


def _remarks(notes: Notes) -> Iterator[TextRemark]:
    """What is found in the file that was named, where it stands there."""
    whole_text = whole(notes.files)
    ends = {}
    rows = sorted((x for each in notes.findings for x in each.rows), key=lambda row: row.position)
    for row, after in zip_longest(rows, rows[1:]):
        end = row.passage.start + len(row.passage.text)
        ends[row.number] = min(end, after.position) if after is not None else end
    for finding in notes.findings:
        for row in finding.rows:
            source, start = whole_text.origin(row.position)
            if source is notes.source:
                text = source.text[start : start + ends[row.number] - row.position]
                text = text[: _written(text)]
                yield TextRemark(start, start + len(text), finding, _repair(row, text))
        if not finding.rows and finding.place is not None and not finding.place.file:
            yield TextRemark(*Lines(notes.source.text).span(finding.place.line - 1), finding)


_SIGN = re.compile(
    r"\s|[.,;&]|\\[,;!:]|\\q?quad\b|\\\\(?:\[[^\]\n]{0,20}\])?|\\no(?:number|tag)\b"
    r"|\\(?:label|tag\*?)\s{0,9}\{[^{}\n]{0,200}\}|(?P<sign>\\?.)",
    re.DOTALL,
)
"""Layout, the end of a sentence and numbers, or a sign of a formula."""


def _written(text: str) -> int:
    """Where the last sign of a statement ends, without what stands behind it.

    >>> _written(r"a = b. \\label{eq}")
    5
    """
    return max((match.end() for match in _SIGN.finditer(text) if match["sign"]), default=0)


def _repair(row: Row, text: str) -> str:
    """What has to stand in place of a statement's text, where it is known and reads as one."""
    from rigidtop.read.statements import statements
    from rigidtop.tree.statement import Statement

    right, each = row.outcome.right, row.statement
    if not right or not isinstance(each, Statement) or len(each.sides) != 2 or each.continues:
        return ""
    if not len(statements(text)) == 1 == len(statements(right)):
        return ""
    [sign] = each.relations  # it stays below those of the other lines
    return right.replace(f" {sign} ", f" &{sign} ", 1) if "&" in text else right
