"""The lecture and sheets of exercises as files, and one claim as a fragment to paste."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from rigidtop.errors import RigidtopError
from rigidtop.notation import NOTES as NOTES_NOTATION
from rigidtop.notation import Notation
from rigidtop.present import html, notations, plain, tex, typst
from rigidtop.present.figures.catalog import FIGURES, named
from rigidtop.present.figures.drawing import Drawing, rendered
from rigidtop.present.files import write_all
from rigidtop.present.pdf import make_pdf
from rigidtop.present.report import (
    NOTES,
    Block,
    Document,
    Figure,
    Front,
    Judged,
    claim_blocks,
    document,
    symbol_list,
    symbols_used,
)
from rigidtop.present.solutions import Solution, blocks, question
from rigidtop.present.ways import led_blocks, text_blocks
from rigidtop.present.wording import Wording
from rigidtop.proof.lecture import Lecture
from rigidtop.proof.verdict import Judgement

FORMATS = ("text", "latex", "html", "typst")


def fragment(
    judgement: Judgement, format: str, notation: Notation = NOTES_NOTATION, deep: bool = False
) -> str:
    """A claim as "text", "latex", "html" or "typst", with its derivation and its verdict.

    A `deep` derivation starts from laws and definitions.
    """
    made = claim_blocks(Wording(notation).judgement(judgement), marks=format == "text")
    made[1:1] = led_blocks(judgement, notation, deep)
    made[1:1] = notations.remark(notation, symbols_used(made))
    if format == "text":
        return plain.fragment(made)
    if format == "latex":
        return tex.fragment(made)
    if format == "html":
        return html.fragment(made)
    if format == "typst":
        return typst.fragment(made)
    raise RigidtopError(f"unknown format {format!r}: choose from {', '.join(FORMATS)}")


@dataclass(frozen=True)
class Picture:
    """A figure of the catalogue in a document: under a name of its own, with these parameters."""

    name: str
    drawing: Drawing
    given: Mapping[str, float]

    def shows_what(self, other: Picture) -> bool:
        """Whether the other picture is this one under another name."""
        same = self.drawing.name == other.drawing.name
        return same and self.drawing.values(self.given) == other.drawing.values(other.given)

    def described(self) -> Figure:
        """As the blocks of a document know it."""
        values = self.drawing.values(self.given)
        return Figure(self.name, self.drawing.caption(**values), self.drawing.alternative(**values))


def picture(solution: Solution, notation: Notation | None = None) -> Picture | None:
    """The figure of an exercise, with those of its settings that the figure has too."""
    if not solution.exercise.figure:
        return None
    drawing = named(solution.exercise.figure)
    known = {parameter.name for parameter in drawing.parameters}
    given = {name: value for name, value in solution.settings.items() if name in known}
    shown = Wording(notation or NOTES_NOTATION).drawing(drawing)
    return Picture(f"exercise-{solution.exercise.name}", shown, given)


def exercise_fragment(solution: Solution, notation: Notation = NOTES_NOTATION) -> str:
    """An exercise with its solution as text."""
    made = blocks(solution_in(notation, solution), notation=notation)
    made[1:1] = notations.remark(notation, symbols_used(made))
    return plain.fragment(made)


def solution_in(notation: Notation, solution: Solution) -> Solution:
    """A solution with its words and the equations of its claims in a notation."""
    exercise, outcomes = Wording(notation).of((solution.exercise, solution.outcomes))
    judgements = _in(notation, solution.judgements)
    return replace(solution, exercise=exercise, outcomes=outcomes, judgements=judgements)


def write_lecture(
    judged: Judged,
    solutions: Sequence[Solution],
    out: Path | str,
    *,
    pdf: bool = False,
    student: bool = False,
    front: Front = NOTES,
    figures: Sequence[Drawing] = FIGURES,
    notation: Notation | None = None,
    lines: Lecture | None = None,
) -> list[Path]:
    """Write lecture.tex, lecture.html and figures/ into `out`, with `pdf` also lecture.pdf.

    Each of the `figures` closes its section.  Equations are in the `notation`, of which the first
    page tells where one is given.  The exercises are without solutions for a `student`.
    Everything is made before anything is written, and each file is replaced only by a whole one.
    Raises RigidtopError, with one line, where the PDF cannot be made or the folder not written.
    """
    made = lecture(
        judged,
        solutions,
        student=student,
        front=front,
        figures=figures,
        notation=notation,
        lines=lines,
    )
    return _write("lecture", *made, out, pdf)


Illustrated = tuple[Document, Sequence[Picture]]
"""A document and its figures."""


def lecture(
    judged: Judged,
    solutions: Sequence[Solution] = (),
    *,
    student: bool = False,
    front: Front = NOTES,
    figures: Sequence[Drawing] = FIGURES,
    notation: Notation | None = None,
    lines: Lecture | None = None,
) -> Illustrated:
    """The lecture: its text with its `lines`, then the verdicts.

    Figures and exercises close the sections that they belong to.
    """
    if notation is not None:
        wording = Wording(notation)
        judged = [(wording.of(page), _in(notation, judgements)) for page, judgements in judged]
        figures = [wording.drawing(each) for each in figures]
        solutions = [solution_in(notation, each) for each in solutions]
    sections = {page.section for page, _ in judged}
    pictures = [Picture(each.name, each, {}) for each in figures if each.section in sections]
    closing: list[tuple[str, Block]] = [
        (picture.drawing.section, picture.described()) for picture in pictures
    ]
    told = {judgement.claim.name for _, judgements in judged for judgement in judgements}
    for solution in solutions:
        own = None if student else picture(solution, notation)
        if own and any(own.shows_what(other) for other in pictures):
            own = None  # the section has it
        made = _exercise(solution, own, student, told, notation or NOTES_NOTATION)
        closing += [(solution.exercise.section, block) for block in made]
        pictures += [own] if own else []
        told |= {judgement.claim.name for judgement in solution.judgements}
    texts = {} if lines is None else _texts(lines, judged, notation or NOTES_NOTATION)
    return _introduced(document(judged, closing, front, texts), notation), pictures


def _texts(lines: Lecture, judged: Judged, notation: Notation) -> dict[str, list[Block]]:
    """The text of each section that has one."""
    named = {text.name: text for text in lines.texts}
    return {
        page.section: text_blocks(lines, named[page.text], notation)
        for page, _ in judged
        if page.text in named
    }


def _introduced(whole: Document, notation: Notation | None) -> Document:
    """A document that begins with its notation, where one is given."""
    if notation is None:
        return whole
    first = notations.front(notation, symbols_used(whole.blocks))
    said = f"{whole.colophon} {notations.origin(notation)}"
    blocks = (*first, *map(Wording(notation).symbols, whole.blocks))
    return replace(whole, blocks=blocks, colophon=said)


def _in(notation: Notation, judgements: Sequence[Judgement]) -> tuple[Judgement, ...]:
    return tuple(map(Wording(notation).judgement, judgements))


def write_sheet(
    solutions: Sequence[Solution],
    out: Path | str,
    *,
    pdf: bool = False,
    student: bool = False,
    front: Front = NOTES,
    notation: Notation | None = None,
) -> list[Path]:
    """Write exercises.tex, exercises.html and figures/ into `out`: see `write_lecture`."""
    made = sheet(solutions, student=student, front=front, notation=notation)
    return _write("exercises", *made, out, pdf)


def sheet(
    solutions: Sequence[Solution],
    *,
    student: bool = False,
    front: Front = NOTES,
    notation: Notation | None = None,
) -> Illustrated:
    """Exercises one after the other, for a `student` without solutions."""
    if notation is not None:
        solutions = [solution_in(notation, each) for each in solutions]
    pictures: list[Picture] = []
    made: list[Block] = []
    told: set[str] = set()
    for solution in solutions:
        own = None if student else picture(solution, notation)
        made += _exercise(solution, own, student, told, notation or NOTES_NOTATION)
        pictures += [own] if own else []
        told |= {judgement.claim.name for judgement in solution.judgements}
    subtitle = "Questions" if student else "Questions and solutions"
    every = (*made, *symbol_list(made))
    whole = Document(front.exercises, subtitle, every, front.source, front.author)
    return _introduced(whole, notation), pictures


def _exercise(
    solution: Solution,
    own: Picture | None,
    student: bool,
    told: Collection[str],
    notation: Notation,
) -> list[Block]:
    """The exercise; claims that were told before are named only."""
    if student:
        return question(solution.exercise, solution.settings, named=not notation.images)
    return blocks(solution, own.described() if own else None, told=told, notation=notation)


def _write(
    stem: str, whole: Document, pictures: Sequence[Picture], out: Path | str, pdf: bool
) -> list[Path]:
    svg = {each.name: rendered(each.drawing, "svg", each.given) for each in pictures}
    drawn = {
        f"figures/{each.name}.pdf": rendered(each.drawing, "pdf", each.given) for each in pictures
    }
    vectors = {f"figures/{name}.svg": content for name, content in svg.items()}
    source = tex.write(whole, {name: f"figures/{name}.pdf" for name in svg})
    page = html.write(whole, {name: content.decode() for name, content in svg.items()})
    contents = {**drawn, **vectors, f"{stem}.tex": source.encode(), f"{stem}.html": page.encode()}
    if pdf:
        paths = {name: f"figures/{name}.svg" for name in svg}
        contents[f"{stem}.pdf"] = make_pdf(
            lambda: source, lambda: typst.write(whole, paths), {**drawn, **vectors}
        )
    return write_all(Path(out), contents)
