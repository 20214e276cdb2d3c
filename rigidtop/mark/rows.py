"""The formulas of a file, each judged by those above it."""

from __future__ import annotations

import re
import time
from dataclasses import dataclass, replace

from rigidtop.mark.case import Held
from rigidtop.mark.notes import held
from rigidtop.notation import OWN
from rigidtop.proof.verdict import Verdict
from rigidtop.read.cases import cases
from rigidtop.read.document import alone, each, numbered, states
from rigidtop.read.formula import Line
from rigidtop.read.habits import Habits
from rigidtop.read.labels import LABEL
from rigidtop.read.walk import Formula, places

_CONSTANT = re.compile(
    r"\b(?:is|are|stays?|remains?)\s+(?:\w+ly\s+|also\s+|again\s+|a\s+)?"
    r"(?:conserved|constant|integral of (?:the )?motion)\b"
    r"|\bist\s+(?:\w+\s+)?(?:erhalten|konstant|Erhaltungsgröße)"
)
"""Words behind a formula which say that what it gives is conserved."""

_IFS = "if|iff|unless|wenn|falls|cuando|quando|quand|lorsque|если"
_CASES = (
    rf"{_IFS}|suppos\w*|assum\w*|instead|otherwise|alternatively|whereas|similarly|likewise"
    r"|provided|cases?|sonst"
)
_IF = re.compile(rf"(?<![\\{{])(\b(?:{_IFS})\b|如果|若|当)", re.I)
"""What is said with these words holds there and no further."""

_CASE = re.compile(rf"(?<![\\{{])(\b(?:{_CASES})\b|如果|若|当)", re.I)
"""With these words something is said of another case, however it is printed."""

_DOUBT = re.compile(
    rf"(?<![\\{{])\b({_CASES}|not?|neither|nor|only|when|where|for|while|until|since|because|absence|then|or"
    r"|without|neglect\w*|limit|approximately|nearly|about|at|once|ohne|nicht|kein\w*|nur|wo|für"
    r"|solange)\b",
    re.I,
)
"""With these words it may be said of a special case, or denied, or of something else."""

_ASIDE = re.compile(r"\\(?:text|mbox)\s*\{\s*\(([^(){}]{1,80})\)")
"""Words in brackets beside an equation."""


@dataclass(frozen=True)
class Row:
    """A line of a file, counted from 1, with what became of it; `lines` are those that it rests on.

    `number` is its number, or the name of its label; a symbol in a sentence is no row.
    """

    line: int
    column: int
    opens: int
    number: str
    display: bool
    held: Held
    lines: tuple[int, ...]


def rows(source: str, habits: Habits, seconds: float) -> tuple[Row, ...]:
    """Every formula of a file that says something, each judged by those above it.

    Once the time is up the rest is unread, and says so.
    """
    end = time.process_time() + seconds
    tags = {
        formula.start: group.number for group in numbered(source) for formula in group.formulas[-1:]
    }
    found: list[tuple[Formula, Line]] = [
        (formula, line)
        for group, lines in each(alone(source), OWN, seconds, habits)
        for formula in group.formulas
        if states(formula)
        for line in lines
        if line.equation is not None or formula.display
    ]
    lines = [line for _, line in found]
    paths = [*map(cases(source), (line.position for line in lines))]
    constant = [i for i, (formula, _) in enumerate(found) if _is_called_constant(source, formula)]
    before = (_sentence(source, formula)[0] for formula, _ in found)
    special = [i for i, words in enumerate(before) if _IF.search(words)]
    judged = held(lines, habits, paths, end, constant, special)
    place = places(source)
    at = [place(min(line.position, len(source))) for line in lines]
    made = []
    for i, (formula, line) in enumerate(found):
        last = i + 1 == len(found) or found[i + 1][0] is not formula
        stop = formula.end if last else lines[i + 1].position
        label = LABEL.search(source, line.position, stop)
        number = line.tag or (tags.get(formula.start, "") if last else "")
        number = number or (label[1] if label else "")
        rests = tuple(sorted({at[k][0] for k in judged[i].rests}))
        said = _of_a_case(source, formula, judged[i])
        made.append(Row(*at[i], formula.opens, number, formula.display, said, rests))
    return tuple(made)


def _sentence(source: str, formula: Formula) -> tuple[str, str]:
    """What stands before and behind a formula in its sentence."""
    before = re.split(r"[.;:]\s|\n\s*\n", source[max(0, formula.opens - 200) : formula.opens])[-1]
    behind = re.split(r"[.;:$]|\n\s*\n|\\[\[(]|\\begin", source[formula.end : formula.end + 200])
    ended = formula.text.rstrip().endswith((".", ";"))
    return before, "" if ended else behind[0]


def _is_called_constant(source: str, formula: Formula) -> bool:
    """Whether the sentence goes on behind a formula by saying that it is conserved."""
    before, behind = _sentence(source, formula)
    said = _CONSTANT.match(behind.strip(" ,\n").removeprefix("which ").removeprefix("that "))
    return said is not None and not _DOUBT.search(f"{before} {behind}")


def _of_a_case(source: str, formula: Formula, found: Held) -> Held:
    """What numbers refute is open where its sentence may speak of a case."""
    words = _CASE if formula.display else _DOUBT
    said = words.search(" ".join(_sentence(source, formula))) or _ASIDE.search(formula.text)
    if found.verdict != Verdict.FALSE.value or said is None:
        return found
    note = f"another case, or a slip? “{said[1]}” stands beside it: {found.note}"
    return replace(found, verdict=Verdict.UNDECIDED.value, note=note)
