"""The lecture as it is handed out: its text, its figures, its exercises, and their solutions.

A verdict is a mark in the margin; in the record, `rigidtop.report.record`, all that was found
stands in its place.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from rigidtop.notation import Notation
from rigidtop.proof.equation import Equation
from rigidtop.proof.exercise import Answer, Exercise, Table
from rigidtop.proof.lecture import Illustration, Lecture, Prose, Text
from rigidtop.proof.page import Claim, Page
from rigidtop.proof.verdict import Judgement, Verdict
from rigidtop.report import blocks as b
from rigidtop.report import plain
from rigidtop.report.claims import claim_blocks, derivation, tagged_rows
from rigidtop.report.marks import SAID, marked
from rigidtop.report.numbers import apart, cells, cleaned, given, in_degrees
from rigidtop.report.solutions import Solution, posed
from rigidtop.report.ways import chained, cited_figures, law_blocks, text_blocks

# --- Sections ------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Parts:
    """What a handout is made of, besides its judged pages, all in the notation of the handout."""

    lines: Lecture
    notation: Notation
    figures: Mapping[str, b.Figure]
    closing: Mapping[str, str]
    """To which section a figure belongs, by its name."""
    points: str = ""
    recorded: bool = False
    """Whether all that was found stands with a claim, and not its mark alone."""

    def beside(
        self, judgement: Judgement, lines: Sequence[Equation]
    ) -> Sequence[b.MarginMark | b.Block]:
        """What stands beside and behind the `lines` of a claim."""
        if self.recorded:
            return claim_blocks(judgement)
        marks = marked(judgement, lines)
        quarrel = [each for each in marks if not isinstance(each, b.MarginMark)]
        if not quarrel:
            return marks
        # A student has no quarrel with the notes.
        box = b.Aside("The notes", for_lecturers=True), *quarrel, b.AsideEnd()
        return (*(each for each in marks if isinstance(each, b.MarginMark)), *box)

    def alone(self, judgement: Judgement) -> list[b.Block]:
        """The blocks of a claim that has no lines."""
        return claim_blocks(judgement) if self.recorded else stated(judgement)

    def equations(self, text: Text) -> list[Equation]:
        """The equations of all lines of a text, in the notation."""
        return [self.notation.written(each) for line in text.lines for each in line.equations]


def sections(judged: b.Judged, exercises: Sequence[Solution], parts: Parts) -> list[b.Block]:
    """The lecture section by section: text with figures, then exercises."""
    blocks: list[b.Block] = []
    numbered = {id(each): k for k, each in enumerate(exercises, 1)}
    for page, judgements in judged:
        blocks += section(page, judgements, parts)
        placed = {block.name for block in blocks if isinstance(block, b.Figure)}
        blocks += [
            each
            for name, each in parts.figures.items()
            if parts.closing.get(name) == page.section and name not in placed
        ]
        asked = [each for each in exercises if each.exercise.section == page.section]
        if len(asked) > 1:  # one says by itself what it is
            blocks.append(b.Subhead("Exercises"))
        for each in asked:
            blocks += question(each.exercise, each.settings, numbered[id(each)], parts.points)
    return blocks


def section(page: Page, judgements: Sequence[Judgement], parts: Parts) -> list[b.Block]:
    """The text of a page under its headings, each of its claims at its lines."""
    blocks: list[b.Block] = [*b.headings(page)]
    text = next((each for each in parts.lines.texts if each.name == page.text), None)
    if text is None:
        blocks.append(b.Paragraph((page.about,), held=True))
        return [*blocks, *(block for each in judgements for block in parts.alone(each))]
    return [*blocks, *_read(parts.lines, text, judgements, parts, parts.lines.names)]


def _read(
    lines: Lecture,
    text: Text,
    judgements: Sequence[Judgement],
    parts: Parts,
    placed: Collection[str],
) -> list[b.Block]:
    """A text with each claim at its lines, behind it those that are not `placed` there."""
    equations = parts.equations(text)
    beside = {each.claim.name: parts.beside(each, equations) for each in judgements}
    blocks = text_blocks(lines, text, parts.notation, beside, parts.figures)
    others = (each for each in judgements if each.claim.name not in placed)
    return [*blocks, *(block for each in others for block in parts.alone(each))]


def order_of_figures(
    lines: Lecture, pages: Iterable[Page], closing: Mapping[str, str]
) -> list[str]:
    """Names of figures as they come: those that a text speaks of, then those of its section.

    `closing` says to which section a figure belongs.
    """
    named = {text.name: text for text in lines.texts}
    names: list[str] = []
    for page in pages:
        text = named.get(page.text)
        names += [] if text is None else [n for n in spoken_of(text) if n in closing]
        names += [name for name, section in closing.items() if section == page.section]
    return list(dict.fromkeys(names))


def spoken_of(text: Text) -> list[str]:
    """The names of the figures that a text shows or speaks of."""
    names: list[str] = []
    for block in text.blocks:
        if isinstance(block, Illustration):
            names.append(block.name)
        elif isinstance(block, Prose):
            names += cited_figures(block.pieces)
        elif getattr(block, "line", None) is not None:
            names += cited_figures(block.line.words)  # type: ignore[union-attr]
    return names


def stated(judgement: Judgement) -> list[b.Block]:
    """A claim without lines of its own: its words, its reason, its equation as it is printed."""
    mark, *behind = marked(judgement)
    assert isinstance(mark, b.MarginMark)
    claim = judgement.claim
    words = " ".join(filter(None, [claim.says.rstrip(".") + ".", claim.reason]))
    rows = tagged_rows(judgement)
    blocks: list[b.Block] = [b.Paragraph((words,), held=bool(rows), mark=mark)]
    if rows:
        blocks.append(b.Display(rows))
    for block in derivation(judgement, False):
        blocks.append(replace(block, label="") if isinstance(block, b.Display) else block)
    return [*blocks, *(block for block in behind if not isinstance(block, b.MarginMark))]


# --- Exercises -----------------------------------------------------------------------------------


def question(
    exercise: Exercise, values: Mapping[str, float], number: int, points: str = ""
) -> list[b.Block]:
    """An exercise as it is asked, its numbers as people write them."""
    settings: list[b.Rich] = []
    for parameter in exercise.parameters:
        value = given(values[parameter.name], parameter.unit)
        # A line does not begin with a few digits.
        space = "\u00a0" if len(plain.rich(value)) < SHORT else " "
        settings.append((parameter.about, f":{space}", *value))
    data = [b.Paragraph((*b.listed(settings, "; "), "."), "Given")] if settings else []
    return [*posed(exercise, number, points), *data]


SHORT = 12
"""Letters of a value that stays with its name."""


def counted(points: float) -> str:
    """
    >>> counted(1), counted(2.5)
    ('1 point', '2.5 points')
    """
    return f"{points:g} point{'s' * (points != 1)}"


def total(points: str, exercises: int) -> str:
    """What a sheet can bring whose exercises can bring so much each.

    >>> total("2.5 points", 4)
    '10 points'
    """
    return counted(float(points.partition(" ")[0]) * exercises)


def solutions(
    exercises: Sequence[Solution],
    parts: Parts,
    places: Mapping[str, b.Rich],
) -> list[b.Block]:
    """The appendix.  `places` says where a claim of the lecture was derived."""
    blocks: list[b.Block] = [b.SectionHead(1, "", "Solutions of the exercises", "solutions")]
    whole = dict(places)
    for number, each in enumerate(exercises, 1):
        place = f"{b.anchor(each.exercise.name)}-solution"
        blocks.append(b.ExerciseHead(each.exercise.title, place, "", number, kind="Solution"))
        blocks += answer(each, parts, whole)
        there = "Solution", "\u00a0", b.Cited(f"{number}", place)
        whole = {j.claim.name: there for j in each.judgements} | whole
    return blocks


def answer(solution: Solution, parts: Parts, places: Mapping[str, b.Rich]) -> list[b.Block]:
    """What an exercise comes to, in symbols and in numbers."""
    exercise = solution.exercise
    blocks: list[b.Block] = []
    had = [j for j in solution.judgements if j.claim.name in places]
    there = [j.claim for j in had if j.verdict is not Verdict.FALSE]
    if there:
        names = (_called(claim, places[claim.name]) for claim in there)
        blocks.append(b.Paragraph(("We have shown: ", *b.listed(names, last=" and "), ".")))
    text, lines = solution.text, solution.lines
    new = [j for j in solution.judgements if j.claim.name not in places]
    if text is None:
        blocks += [block for each in new for block in parts.alone(each)]
    else:
        here = {line.id for line in text.lines}
        placed = {name for name, ids in lines.names.items() if here & set(ids)}
        blocks += _read(lines, text, new, parts, placed)
    blocks += results(solution)
    own = f"exercise-{exercise.name}"
    if own in parts.figures:
        blocks.append(parts.figures[own])
    return blocks


def laws(lines: Lecture, pages: Collection[str], notation: Notation) -> list[b.Block]:
    """What the derivations of these pages start from."""
    cited = law_blocks(lines, pages, notation)
    return [b.SectionHead(1, "", "Laws and definitions", "laws"), *cited] if cited else []


def _called(claim: Claim, place: b.Rich) -> b.Rich:
    """A claim that stands in another place, to be looked up."""
    name = b.Cited(f"({claim.name})", b.anchor(claim.name)) if b.is_number(claim.name) else None
    if name is not None:
        return (name,)
    return (f"“{claim.says.rstrip('.')}”", *((" (", *place, ")") if place else ()))


def results(solution: Solution) -> list[b.Block]:
    """The answers and tables of a solution, as blocks."""
    blocks: list[b.Block] = [b.Paragraph((solution.exercise.method,))]
    answers = [outcome for outcome in solution.outcomes if isinstance(outcome, Answer)]
    if answers:
        rows = tuple((a.what, *apart(a.value, a.unit)) for a in answers)
        blocks.append(b.quantities("", rows))
    for outcome in solution.outcomes:
        if isinstance(outcome, Table):
            columns = tuple(map(in_degrees, outcome.columns, zip(*outcome.rows, strict=True)))
            numbers = cells(list(zip(*(cleaned(column) for _, column in columns), strict=True)))
            blocks.append(b.TableBlock(tuple(head for head, _ in columns), numbers, outcome.title))
    return blocks


# --- Front and back ------------------------------------------------------------------------------


STARTS = (
    "What a sentence cites by its name, or by the number of an equation that is not derived here, "
    "stands under “Laws and definitions” at the end."
)


def summary(judged: b.Judged, parts: Parts, student: bool = False) -> list[b.Block]:
    """Every numbered equation once, on one page: as the text has it, if it does.

    For a `student` without what the notes say amiss.
    """
    rows = []
    for _, judgements in judged:
        for judgement in judgements:
            name = judgement.claim.name
            if b.is_number(name):
                printed = tagged_rows(judgement)
                corrected = [f.check.claimed for f in judgement.corrections()]
                equations = (
                    numbered(parts, name) or corrected[:1] or [row.equation for row in printed]
                )
                words: b.Rich = (judgement.claim.says,)
                if corrected:
                    right = [*filter(None, (f.check.reason for f in judgement.corrections()))]
                    sentence = judgement.claim.says.rstrip(".")
                    words = (SAID, " ".join((f"{sentence}.", *right)))
                    words = (" ".join(right),) if student and right else words
                rows.append((name, tuple(equations), words, judgement.verdict))
    if not rows:
        return []
    head = b.SectionHead(1, "", "Summary of results", "results")
    marked = any(verdict is Verdict.ASSUMING for *_, verdict in rows)
    return [head, *[b.Paragraph((CONDITIONS,))] * marked, b.Results(tuple(rows))]


CONDITIONS = "The conditions of the marks stand in the text, with these statements."


def numbered(parts: Parts, number: str) -> list[Any]:
    """The equations of the line that has a number."""
    lines = (parts.lines.lines[id] for id in parts.lines.names.get(number, ()))
    equations = (x.equations for x in lines if any(each.tag == number for each in x.equations))
    return [parts.notation.written(each) for each in chained(next(equations, ()))]


def looked_up(blocks: Sequence[b.Block], parts: Parts) -> list[b.Block]:
    """The numbered equations that blocks cite and do not have, as the lecture has them."""
    pieces: list[b.Piece] = []
    for block in blocks:
        pieces += block.content if isinstance(block, b.Paragraph) else ()
        for row in block.rows if isinstance(block, b.Display) else ():
            pieces += row.spoken
    words = (x.words if isinstance(x, b.Cited) else x for x in pieces)
    numbers = {n[1:-1] for x in words if isinstance(x, str) for n in NUMBER.findall(x)}
    rows = tuple(
        b.DisplayRow(equation, "printed", equation.tag)
        for number in sorted(numbers - tags(blocks))
        for equation in numbered(parts, number)
    )
    return [b.SectionHead(1, "", "Equations cited", "cited"), b.Display(rows)] if rows else []


NUMBER = re.compile(r"(\(\d+\.\d+[a-z]?\))")


def tags(blocks: Iterable[b.Block]) -> set[str]:
    """The numbers of the equations that stand there."""
    rows = (row for block in blocks if isinstance(block, b.Display) for row in block.rows)
    return {row.tag for row in rows} - {""}


def linked(blocks: Sequence[b.Block]) -> list[b.Block]:
    """The same, every (3.54) in a sentence leading to its equation."""
    there = {f"({tag})" for tag in tags(blocks)}

    def cited(content: b.Rich) -> b.Rich:
        pieces: list[Any] = []
        for piece in content:
            parts = NUMBER.split(piece) if type(piece) is str else [piece]
            pieces += [b.Cited(x, b.anchor(x)) if x in there else x for x in parts if x != ""]
        return tuple(pieces)

    def leading(part: Any, _: str) -> Any:
        match part:
            case b.Paragraph():
                return replace(part, content=cited(part.content))
            case b.DisplayRow(reason=str(words)):
                return replace(part, reason=cited((words,))) if words else part
            case b.DisplayRow(reason=tuple(words)):
                return replace(part, reason=cited(words))
        return part

    return [b.walked(block, leading) for block in blocks]


def _once(mark: b.MarginMark | None, noted: dict[b.Rich, b.MarginMark]) -> b.MarginMark | None:
    """A mark whose note refers to that of a numbered equation above if it says the same."""
    if mark is None or not mark.note:
        return mark
    first = noted.setdefault(mark.note, mark)
    if first is mark or not b.is_number(first.name):
        return mark
    there = b.Cited(f"({first.name})", b.anchor(first.name))
    return replace(mark, note=("as ", there), above=mark.note)


ROOM = 65.0
"""Letters of a line beside a margin for notes."""

COLUMN = 51.0
"""Letters of a line in one of two columns."""


def parted(blocks: Sequence[b.Block]) -> list[b.Block]:
    """Displays apart that have a sentence each, the lines of each with their anchors."""
    parts: list[b.Block] = []
    seen = {block.name for block in blocks if isinstance(block, b.ClaimHead)}
    noted: dict[b.Rich, b.MarginMark] = {}
    level, asked, nameless, room = 0, 0, 0, ROOM
    for block in blocks:
        if isinstance(block, b.SectionHead):
            level, asked = block.level, 0
            noted.clear()
            room = COLUMN if block.anchor in b.IN_COLUMNS else ROOM
            parts.append(block)
        elif isinstance(block, b.Subhead):
            parts.append(replace(block, level=(asked or level) + 1))
        elif isinstance(block, b.ExerciseHead | b.ClaimHead):
            # Beneath “Exercises”, where there are several.
            asked = asked or level + 1 + bool(parts and isinstance(parts[-1], b.Subhead))
            parts.append(replace(block, level=asked))
        elif isinstance(block, b.Paragraph) and block.mark is not None:
            name = block.mark.name
            place = b.anchor(name) if name not in seen and not b.is_number(name) else ""
            seen.add(name if place else "")
            parts.append(replace(block, anchor=place))
        elif isinstance(block, b.Display) and block.label in ("", "Derivation"):
            groups: list[list[b.DisplayRow]] = []
            for row in block.rows:
                if row.reason or not groups:
                    groups.append([])
                name = row.tag or (row.mark.name if row.mark is not None else "")
                place = b.anchor(name) if name and name not in seen else row.anchor
                seen.add(name)
                groups[-1].append(replace(row, anchor=place, mark=_once(row.mark, noted)))
            for rows in groups:
                if not any(row.anchor for row in rows):
                    nameless += 1
                    rows[-1] = replace(rows[-1], anchor=f"equation-{nameless}")
            label = (block.label, *[""] * len(groups))
            parts += [
                replace(block, rows=tuple(rows), label=words, room=room, step=True)
                for rows, words in zip(groups, label, strict=False)
            ]
        else:
            parts.append(block)
    return parts
