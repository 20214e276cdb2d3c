"""Lines as records for programs: what each says, by which move, under what, with which verdict."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from rigidtop.judge.page import outcome
from rigidtop.notation import NOTES, Notation
from rigidtop.proof.derivation import Judged
from rigidtop.proof.lecture import Lecture, Text
from rigidtop.proof.moves import NEGLECTED, Known
from rigidtop.report import plain
from rigidtop.report.ways import called, reason, relation
from rigidtop.typeset.latex import latex
from rigidtop.typeset.text import text

Record = dict[str, object]
"""A line for programs."""


def steps(
    lecture: Lecture, name: str, notation: Notation = NOTES, deep: bool = False
) -> list[dict[str, object]]:
    """The lines as records of plain values, for JSON."""
    return [step(lecture, id, notation) for id in lecture.way(name, deep)[0]]


def step(lecture: Lecture, id: str, notation: Notation = NOTES) -> dict[str, object]:
    """A line as a record of plain values, for JSON."""
    each = lecture.judged(id)
    equations = [notation.written(equation) for equation in each.line.equations]
    return {
        "id": id,
        "equation": "; ".join(text(equation) for equation in equations),
        "latex": r",\quad ".join(latex(equation) for equation in equations),
        "move": " ".join(each.line.sentence.split()).rstrip(":"),
        "from": list(lecture.cites(id)),
        "conditions": conditions(each.known, notation),
        "verdict": _verdict(each),
    }


def conditions(line: Known, notation: Notation = NOTES) -> list[str]:
    """What an equation holds under, and the order of what is left out of it, as text."""
    words = []
    for condition in line.conditions:
        if condition.relation in ("large", "small"):
            words.append(f"{text(notation.written(condition.expression))} {condition.relation}")
            continue
        when = " at the start" if condition.relation == "start" else ""
        words.append(text(relation(condition, notation)) + when)
    order = line.order
    if order is not None and order.small != NEGLECTED:
        for x in order.together or (order.small,):
            letter, error = (text(notation.written(each)) for each in (x, x**order.power))
            words.append(f"{letter} small, with an error of order O({error})")
    return words


def way_record(
    lecture: Lecture, name: str, notation: Notation = NOTES, deep: bool = False
) -> tuple[list[dict[str, Any]], list[str]]:
    """The lines to what a name names, and what they rest on; nothing where there are no lines."""
    if name not in lecture.names:
        return [], []
    starts = lecture.way(name, deep)[1]
    names = [plain.rich(called(lecture.lines[id], notation)) for id in starts]
    return steps(lecture, name, notation, deep), names


def _verdict(judged: Judged) -> str:
    if not judged.follows:
        return "gap"
    move = judged.line.move
    return "definition" if move is None or move.verb == "call" else "follows"


def _nothing(verdict: str, note: str) -> Record:
    """What is said where there is no line."""
    return {"id": "", "verdict": verdict, "conditions": [], "note": note, "worlds": "unread"}


def line_records(lecture: Lecture, texts: Iterable[Text], notation: Notation) -> list[Record]:
    """What `rigidtop check --lines --json` says: an object for every display of some pages.

    `line` is where the display begins in its `file`; `worlds` is what becomes of it wherever all
    holds that it rests on: "sampled" if it is true there, "false" if it never is, "premise" or
    "definition" if it rests on nothing, else "undecided" or "unread".  A fault of a page is an
    object too, without an `id`.
    """
    faults = [*lecture.faults()]
    records: list[Record] = []
    for page in texts:
        for display in page.shown:
            row: Record = {"file": page.file, "line": display.at}
            if display.line is None:
                more = _nothing("unread", display.problem)
            else:
                judged = lecture.judged(display.line.id)
                more = {
                    "id": display.line.id,
                    "verdict": "premise"
                    if display.line.move is None and judged.follows
                    else _verdict(judged),
                    "conditions": conditions(judged.known, notation),
                    "note": "" if judged.follows else reason(judged, lecture.letters, notation),
                    "worlds": outcome(lecture, judged).verdict,
                }
            records.append(row | more)
        records += [
            {"file": file, "line": at} | _nothing("fault", why)
            for file, at, why in faults
            if file == page.file
        ]
    return records
