"""The formulas of a file, each judged by those above it."""

from __future__ import annotations

import re
import time
from dataclasses import dataclass

from rigidtop.mark.notes import Held, held
from rigidtop.notation import OWN
from rigidtop.read.cases import cases
from rigidtop.read.document import Formula, alone, each, numbered, places, states
from rigidtop.read.formula import Line
from rigidtop.read.habits import Habits

_CONSTANT = re.compile(
    r"\b(?:is|are|stays?|remains?)\s+(?:\w+ly\s+|also\s+|again\s+|a\s+)?"
    r"(?:conserved|constant|integral of (?:the )?motion)\b"
    r"|\bist\s+(?:\w+\s+)?(?:erhalten|konstant|Erhaltungsgröße)"
)
"""Words behind a formula which say that what it gives is conserved."""

_DOUBT = re.compile(
    r"\b(?:not?|neither|nor|only|if|when|where|unless|for|while|until|since|because|provided"
    r"|absence|without|neglect\w*|limit|approximately|nearly|about|once|in case|case of|ohne"
    r"|nicht|kein\w*|nur|wenn|falls|wo|für|solange)\b",
    re.I,
)
"""With these words it may be said of a special case, or denied, or of something else."""

_LABEL = re.compile(r"\\label\s*\{([^{}\n]{1,100})\}")


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
    judged = held(lines, habits.functions, habits.timed, paths, end, habits.kind, constant)
    place = places(source)
    at = [place(min(line.position, len(source))) for line in lines]
    made = []
    for i, (formula, line) in enumerate(found):
        last = i + 1 == len(found) or found[i + 1][0] is not formula
        stop = formula.end if last else lines[i + 1].position
        label = _LABEL.search(source, line.position, stop)
        number = line.tag or (tags.get(formula.start, "") if last else "")
        number = number or (label[1] if label else "")
        rests = tuple(sorted({at[k][0] for k in judged[i].rests}))
        made.append(Row(*at[i], formula.opens, number, formula.display, judged[i], rests))
    return tuple(made)


def _is_called_constant(source: str, formula: Formula) -> bool:
    """Whether the sentence goes on behind a formula by saying that it is conserved."""
    if formula.text.rstrip().endswith((".", ";")):
        return False
    rest = re.split(r"[.;:$]|\n\s*\n|\\[\[(]|\\begin", source[formula.end : formula.end + 200])[0]
    sentence = re.split(r"[.;:]\s|\n\s*\n", source[max(0, formula.opens - 200) : formula.opens])[-1]
    said = _CONSTANT.match(rest.strip(" ,\n").removeprefix("which ").removeprefix("that "))
    return said is not None and not _DOUBT.search(f"{sentence} {rest}")
