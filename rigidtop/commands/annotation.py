"""Formulas of a text as a page of notes shows them, and answers with their marks beside them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from rigidtop.mark.marking import SOUND, Marked, Marking
from rigidtop.mark.marking import Mark as Verdict
from rigidtop.read.document import formulas
from rigidtop.read.left import TAG
from rigidtop.read.macros import Macros, customary, defined
from rigidtop.read.walk import Formula
from rigidtop.report.annotated import FormulaSpan, VerdictSpan, write
from rigidtop.report.transcript import transcript


def others(source: str, marks: Sequence[VerdictSpan], macros: Macros) -> list[FormulaSpan]:
    """The formulas of the text without a mark."""
    spans = [(mark.start, mark.end) for mark in marks]
    return [
        _shown(each, macros, each.text, each.display)
        for each in formulas(source)
        if not any(start <= each.start < end for start, end in spans)
    ]


def framed(formula: Formula, macros: Macros) -> FormulaSpan:
    """A formula with a verdict, in a frame of its own; its number stands beside it there."""
    return _shown(formula, macros, re.sub(TAG, "", formula.text), display=True)


def _shown(formula: Formula, macros: Macros, text: str, display: bool) -> FormulaSpan:
    """A formula of the text, sign by sign as it is written."""
    signs = transcript(text.strip(), macros, display)
    return FormulaSpan(formula.opens, formula.end, text.strip(), display, signs)


# --- Answers -------------------------------------------------------------------------------------

COLOPHON = """Each display with its mark; within a sentence what is not right is marked. All
formulas are set sign by sign, as they are written."""


def marked_page(name: str, source: str, marking: Marking) -> str:
    """An answer with the marks beside its lines, as HTML; `name` is that of its file."""
    macros = defined(source, customary(source))
    at = {f.start: f for f in formulas(source)}
    lines: dict[tuple[int, int], list[Marked]] = {}
    for line in marking.lines:
        lines.setdefault(_span(source, line.position, at), []).append(line)
    spans = [each for each in lines if _is_shown(each, lines[each], at)]
    marks = [_mark(source, each, lines[each], at, macros) for each in spans]
    beside = [
        f"line {line.line}: {line.mark}: {line.note}"
        for each in lines
        if each not in spans
        for line in lines[each]
        if line.mark not in SOUND
    ]
    points = "{:g} of {:g} points".format(*marking.points)
    summary = "; ".join([points, marking.summary, *marking.lost])
    rest = others(source, marks, macros)
    return write(name, source, rest, marks, summary, beside, "marked", COLOPHON)


def _span(source: str, position: int, at: Mapping[int, Formula]) -> tuple[int, int]:
    """Where the formula stands that has a position, or else its line of text."""
    for start, formula in at.items():
        if start <= position < formula.end:
            return start, formula.end
    end = source.find("\n", position)
    return source.rfind("\n", 0, position) + 1, len(source) if end < 0 else end


def _is_shown(span: tuple[int, int], lines: Sequence[Marked], at: Mapping[int, Formula]) -> bool:
    """Whether it stands in a frame: not what is right within a sentence, nor text with formulas."""
    if span[0] in at:
        return at[span[0]].display or any(line.mark not in SOUND for line in lines)
    return not any(start < span[1] and span[0] < formula.end for start, formula in at.items())


_WORST = (Verdict.WRONG, Verdict.CARRIED, Verdict.UNREAD, Verdict.INCONCLUSIVE, *SOUND)


def _mark(
    source: str,
    span: tuple[int, int],
    lines: Sequence[Marked],
    at: Mapping[int, Formula],
    macros: Macros,
) -> VerdictSpan:
    """The mark of a formula in which some lines stand."""
    start, end = span
    formula = FormulaSpan(start, end, source[start:end])
    if start in at:
        formula = framed(at[start], macros)
    verdict = min((line.mark for line in lines), key=_WORST.index)
    return VerdictSpan(
        start=formula.start,
        end=end,
        number="",
        line=lines[0].line,
        verdict=verdict.value,
        passed=verdict in SOUND,
        note="; ".join(_notes(lines)),
        formulas=(formula,),
    )


def _notes(lines: Sequence[Marked]) -> Iterator[str]:
    """What is said of each line, with the line as it has to be."""
    several = len({line.line for line in lines}) > 1
    for line in lines:
        parts = [line.note, f"right: ${line.right}$" if line.right else ""]
        note = "; ".join(filter(None, parts))
        if note:
            yield f"line {line.line}: {note}" if several else note
