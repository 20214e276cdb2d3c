"""The lecture and sheets of exercises as files, and one claim as a fragment to paste."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from rigidtop.errors import RigidtopError
from rigidtop.figures.catalog import FIGURES, named
from rigidtop.figures.drawing import Drawing, both
from rigidtop.motion.motion import Motion
from rigidtop.notation import NOTES as NOTES_NOTATION
from rigidtop.notation import Notation
from rigidtop.proof.lecture import Lecture
from rigidtop.proof.verdict import Judgement
from rigidtop.report import blocks as b
from rigidtop.report import handout, html, marks, myst, notations, plain, tex, typst
from rigidtop.report.front import NOTES, Front
from rigidtop.report.handout import Parts, order_of_figures, spoken_of
from rigidtop.report.map import contracted
from rigidtop.report.map import label as map_label
from rigidtop.report.map import picture as map_picture
from rigidtop.report.pdf import LatexError, make_pdf
from rigidtop.report.record import NO_LINES, document
from rigidtop.report.selection import for_students, projected
from rigidtop.report.solutions import Solution, blocks
from rigidtop.report.symbols import symbol_list, symbols_used
from rigidtop.report.ways import claim_told
from rigidtop.report.wording import Wording
from rigidtop.terminal.files import write_all
from rigidtop.terminal.progress import over
from rigidtop.terminal.table import terminal_width

PLAIN = b.Look()

FORMATS: Mapping[str, Callable[[Sequence[b.Block]], str]] = {
    "text": lambda blocks: plain.fragment(blocks, terminal_width()),
    "latex": tex.fragment,
    "html": html.fragment,
    "typst": typst.fragment,
}
"""How a claim is written by itself."""


def fragment(
    judgement: Judgement, format: str, notation: Notation = NOTES_NOTATION, deep: bool = False
) -> str:
    """A claim as "text", "latex", "html" or "typst", with its derivation and its verdict.

    A `deep` derivation starts from laws and definitions.
    """
    if format not in FORMATS:
        raise RigidtopError(f"unknown format {format!r}: choose from {', '.join(FORMATS)}")
    return FORMATS[format](_told(judgement, notation, deep, marks=format == "text"))


def _told(
    judgement: Judgement, notation: Notation, deep: bool = False, *, marks: bool = False
) -> list[b.Block]:
    """A claim with its derivation and all that was found, its head first."""
    content = claim_told(Wording(notation).judgement(judgement), notation, deep, marks=marks)
    content[1:1] = notations.remark(notation, symbols_used(content))
    return content


@dataclass(frozen=True)
class PlacedFigure:
    """A figure of the catalogue in a document: under a name of its own, with these parameters."""

    name: str
    drawing: Drawing
    given: Mapping[str, float]

    def shows_what(self, other: PlacedFigure) -> bool:
        """Whether the other picture is this one under another name."""
        same = self.drawing.name == other.drawing.name
        return same and self.drawing.values(self.given) == other.drawing.values(other.given)

    def motions(self) -> Sequence[Motion]:
        """The motions that the picture shows; none where it shows another thing."""
        of = self.drawing.motions
        return of(**self.drawing.values(self.given)) if of else ()

    def described(self, number: int) -> b.Figure:
        """The figure as the blocks of a document know it."""
        values = self.drawing.values(self.given)
        caption, alternative = self.drawing.caption(**values), self.drawing.alternative(**values)
        return b.Figure(self.name, caption, alternative, number)


def picture(solution: Solution, notation: Notation | None = None) -> PlacedFigure | None:
    """The figure of an exercise, with those of its settings that the figure has too."""
    if not solution.exercise.figure:
        return None
    drawing = named(solution.exercise.figure)
    names = {parameter.name for parameter in drawing.parameters}
    values = {name: value for name, value in solution.settings.items() if name in names}
    translated = Wording(notation or NOTES_NOTATION).drawing(drawing)
    return PlacedFigure(f"exercise-{solution.exercise.name}", translated, values)


def exercise_fragment(solution: Solution, notation: Notation = NOTES_NOTATION) -> str:
    """An exercise with its solution, as text of one format."""
    content = blocks(solution_in(notation, solution), notation=notation)
    content[1:1] = notations.remark(notation, symbols_used(content))
    return plain.fragment(content, terminal_width())


def claims_told(
    judged: b.Judged, solutions: Sequence[Solution], lines: Lecture, notation: Notation
) -> list[tuple[b.ClaimHead, list[b.Block]]]:
    """Each claim, of the lecture and of the solutions, with what its page tells.

    That is its derivation, what was found, what it rests on, and what rests on it.
    """
    judgements_by_name = {j.claim.name: j for _, judgements in judged for j in judgements}
    judgements_by_name |= {j.claim.name: j for each in solutions for j in each.judgements}

    def named(label: str, names: Sequence[str]) -> b.Paragraph:
        return b.Paragraph((*b.listed((cited(name),) for name in names), "."), label)

    def cited(name: str) -> b.Piece:
        words = map_label(lines, name, notation)
        return b.Cited(words, myst.page_of(b.anchor(name))) if name in judgements_by_name else words

    entries: list[tuple[b.ClaimHead, list[b.Block]]] = []
    for name, judgement in judgements_by_name.items():
        head, *content = _told(judgement, notation)
        assert isinstance(head, b.ClaimHead)
        if name in lines.names:
            resting = {"Rests on": lines.map[name], "On it rest": lines.resting(name)}
            content += [named(label, names) for label, names in resting.items() if names]
        entries.append((head, content))
    return entries


def solution_in(notation: Notation, solution: Solution) -> Solution:
    """A solution with its words and the equations of its claims in a notation."""
    exercise, outcomes = Wording(notation).of((solution.exercise, solution.outcomes))
    judgements = _in(notation, solution.judgements)
    return replace(solution, exercise=exercise, outcomes=outcomes, judgements=judgements)


@dataclass(frozen=True)
class Edition:
    """The reader for whom a document is written, and its form.

    A `student` gets no solutions.  Equations are in the `notation`, of which the first page tells
    where one is given; the text is that of `lines`.  An exercise can bring so many `points`.
    """

    student: bool = False
    front: Front = NOTES
    figures: Sequence[Drawing] = FIGURES
    notation: Notation | None = None
    lines: Lecture = NO_LINES
    points: str = ""
    look: b.Look = PLAIN

    @property
    def letters(self) -> Notation:
        """The notation that its equations have."""
        return self.notation or NOTES_NOTATION

    def handed_out(self, title: str, subtitle: str, blocks: Sequence[b.Block]) -> b.Document:
        """What is handed out, with verdicts in the margin."""
        front = self.front
        about = front.source, front.author, front.byline
        whole = b.Document(title, subtitle, tuple(blocks), *about, True, self.look)
        return _introduced(whole, self.notation)


@dataclass(frozen=True)
class Wanted:
    """Which files: with a PDF, with slides, as chapters for another document, as MyST.

    `player` makes of the motions of each figure what plays them in the HTML.
    """

    pdf: bool = False
    slides: bool = False
    solutions: bool = False
    """Exercises and their solutions on the slides too."""
    fragment: bool = False
    myst: bool = False
    player: Callable[[Mapping[str, Sequence[Motion]]], str] | None = None


def write_lecture(
    judged: b.Judged,
    solutions: Sequence[Solution],
    out: Path | str,
    edition: Edition = Edition(),
    wanted: Wanted = Wanted(),
    recorded: bool = False,
) -> list[Path]:
    """Write lecture.tex, lecture.html and figures/ into `out`, and what else is `wanted`.

    With `recorded` it is the record of every verdict, record.tex and record.html.  Everything is
    made before anything is written, and each file is replaced only by a whole one.  Raises
    RigidtopError, with one line, where the PDF cannot be made or the folder not written; where
    LaTeX found an error, its log is there beside all other files.
    """
    if recorded:
        return _write("record", *record(judged, solutions, edition), out, wanted)
    claims: myst.Claims = ()
    if wanted.myst:
        solved = () if edition.student else solutions
        claims = claims_told(judged, solved, edition.lines, edition.letters)
    return _write("lecture", *lecture(judged, solutions, edition), out, wanted, claims)


Illustrated = tuple[b.Document, Sequence[PlacedFigure]]
"""A document and its figures."""


def lecture(
    judged: b.Judged, solutions: Sequence[Solution] = (), edition: Edition = Edition()
) -> Illustrated:
    """The lecture as it is handed out: its text, figures, exercises, and their solutions.

    Figures stand where the text speaks of them.
    """
    lines, notation, student = edition.lines, edition.letters, edition.student
    judged, figures, solutions = _written(edition, judged, solutions)
    if student:
        told_right = lines.names.keys()  # a claim without lines is told as the notes have it
        judged = [
            (page, [marks.set_right(j) if j.claim.name in told_right else j for j in judgements])
            for page, judgements in judged
        ]
    every = map(Wording(notation).drawing, FIGURES if figures else ())
    drawings = {each.name: each for each in (*every, *figures)}
    sections = {page.section for page, _ in judged}
    closing = {each.name: each.section for each in figures if each.section in sections}
    texts = {page.text for page, _ in judged}
    spoken = [name for text in lines.texts if text.name in texts for name in spoken_of(text)]
    closing |= {name: "" for name in spoken if name in drawings and name not in closing}
    order = order_of_figures(lines, [page for page, _ in judged], closing)
    pictures = [
        PlacedFigure(name, drawings[name], drawings[name].asked if student else {})
        for name in order
    ]
    chart = _map(lines, notation)
    pictures += [chart] if chart is not None else []
    for each in () if student else solutions:
        own = picture(each, edition.notation)
        if own is not None and not any(own.shows_what(other) for other in pictures):
            pictures.append(own)
    numbered = {p.name: p.described(k) for k, p in enumerate(pictures, 1)}
    parts = Parts(lines, notation, numbered, closing, edition.points)
    everything = [judgement for _, judgements in judged for judgement in judgements]
    places: dict[str, b.Rich] = {}
    for page, judgements in judged:
        *_, head = b.headings(page)
        place = (f"section\u00a0{head.number}",) if head.number else (f"“{head.title}”",)
        places |= {j.claim.name: place for j in judgements}
    blocks: list[b.Block] = [marks.legend(everything)]
    if not student:
        texts |= {each.text.name for each in solutions if each.text is not None}
    laws = handout.laws(lines, texts, notation)
    blocks += [b.Paragraph((handout.STARTS,))] if laws else []
    blocks += handout.sections(judged, solutions, parts)
    if chart is not None:
        blocks += [b.SectionHead(1, "", "What rests on what", "map"), numbered[chart.name]]
    blocks += handout.summary(judged, parts, student)
    if not student and solutions:
        blocks += handout.solutions(solutions, parts, places)
    blocks += laws
    blocks = for_students(blocks) if student else blocks
    blocks = handout.linked(handout.parted([*blocks, *symbol_list(blocks, LETTERS)]))
    front = edition.front
    whole = edition.handed_out(front.title, front.subtitle, blocks)
    if front.opening is None:
        return whole, pictures
    drawing = Wording(notation).drawing(named(front.opening.figure))
    first = PlacedFigure("opening", drawing, front.opening.settings)
    opening = replace(first.described(0), caption=front.opening.invitation)
    return replace(whole, opening=opening), [*pictures, first]


LETTERS = b.SectionHead(1, "", "Symbols, letter by letter in the order of first use", "letters")

LEAST = 4
"""So many numbered equations make a map."""


def _map(lines: Lecture, notation: Notation) -> PlacedFigure | None:
    """Which numbered equation rests on which, where there are several."""
    numbered = contracted(lines.map, {name for name in lines.names if b.is_number(name)})
    if len(numbered) < LEAST:
        return None
    used = {name for on in numbered.values() for name in on}
    kept = {name for name in numbered if name not in lines.laws or name in used}
    nodes = {name: on for name, on in numbered.items() if name in kept}
    caption = (
        "Which numbered statement rests on which, by the lines of the text. A number stands for "
        "all lines of its statement, and has its place at the last of them. Arrows that a chain of "
        "others says too are left out. Light: what the lecture starts from and cites by number."
    )
    alternative = "A chart from left to right: " + "; ".join(
        f"{name} rests on {', '.join(on)}" for name, on in nodes.items() if on
    )
    drawing = Drawing(
        "map",
        "What rests on what",
        "",
        (),
        draw=lambda: map_picture(lines, nodes, notation, COLUMN),
        printed=caption,
        spoken=alternative,
    )
    return PlacedFigure("map", drawing, {})


COLUMN = 0.68
"""The width of a column of the map on a page (inches)."""


def _written(
    edition: Edition, judged: b.Judged, solutions: Sequence[Solution]
) -> tuple[b.Judged, Sequence[Drawing], Sequence[Solution]]:
    """Everything in a notation, where one is given."""
    notation, figures = edition.notation, edition.figures
    if notation is None:
        return judged, figures, solutions
    wording = Wording(notation)
    return (
        [(wording.of(page), _in(notation, judgements)) for page, judgements in judged],
        [wording.drawing(each) for each in figures],
        [solution_in(notation, each) for each in solutions],
    )


def record(
    judged: b.Judged, solutions: Sequence[Solution] = (), edition: Edition = Edition()
) -> Illustrated:
    """The record of every verdict: each claim with its lines, then what was found."""
    judged, _, solutions = _written(edition, judged, solutions)
    solved = () if edition.student else solutions
    whole = document(judged, solved, edition.lines, edition.front, edition.letters)
    return _introduced(whole, edition.notation), ()


def _introduced(whole: b.Document, notation: Notation | None) -> b.Document:
    """A document that begins with its notation, where one is given.

    The notation of the notes needs no words about it.
    """
    if notation is None or not notation.images:
        return whole
    first = notations.front(notation, symbols_used(whole.blocks))
    colophon = f"{whole.colophon} {notations.origin(notation)}"
    blocks = (*first, *map(Wording(notation).symbols, whole.blocks))
    return replace(whole, blocks=blocks, colophon=colophon)


def _in(notation: Notation, judgements: Sequence[Judgement]) -> tuple[Judgement, ...]:
    return tuple(map(Wording(notation).judgement, judgements))


def write_sheet(
    solutions: Sequence[Solution],
    out: Path | str,
    edition: Edition = Edition(),
    wanted: Wanted = Wanted(),
) -> list[Path]:
    """Write exercises.tex, exercises.html and figures/ into `out`: see `write_lecture`."""
    return _write("exercises", *sheet(solutions, edition), out, wanted)


def sheet(solutions: Sequence[Solution], edition: Edition = Edition()) -> Illustrated:
    """Exercises one after the other, for a student without solutions, to sign and to fill in."""
    notation, student, points = edition.notation, edition.student, edition.points
    if notation is not None:
        solutions = [solution_in(notation, each) for each in solutions]
    drawn = [] if student else [picture(each, notation) for each in solutions]
    pictures = [each for each in drawn if each is not None]
    numbered = {p.name: p.described(k) for k, p in enumerate(pictures, 1)}
    parts = Parts(edition.lines, edition.letters, numbered, {}, points)
    blocks: list[b.Block] = [b.NameLine()] if student else []
    own = {each.text.name for each in solutions if each.text is not None}
    lines = edition.lines
    printed = {line.id for text in lines.texts if text.name not in own for line in text.lines}
    places: dict[str, b.Rich] = {name: () for name, ids in lines.names.items() if printed & {*ids}}
    new = [j for each in solutions for j in each.judgements if j.claim.name not in places]
    blocks += [marks.legend(new)] if new else []
    for number, each in enumerate(solutions, 1):
        blocks += handout.question(each.exercise, each.settings, number, points)
        if student:
            blocks.append(b.Room())
        else:
            blocks.append(b.Subhead("Solution"))
            blocks += handout.answer(each, parts, places)
            places = {j.claim.name: () for j in each.judgements} | places
    blocks += handout.looked_up(blocks, parts)
    sides = [x for line in lines.lines.values() for e in line.equations for x in e.sides]
    read = frozenset().union(*(side.free_symbols for side in sides))
    letters = {edition.letters.letters.get(x, x) for x in read}
    blocks = handout.linked(handout.parted([*blocks, *symbol_list(blocks, LETTERS, letters)]))
    about = ["Questions" if student else "Questions and solutions"]
    about += [handout.total(points, len(solutions))] if points else []
    subtitle = ", ".join(about)
    front = edition.front
    if student and front.questions:
        edition = replace(edition, front=replace(front, source=front.questions))
    return edition.handed_out(front.exercises, subtitle, blocks), pictures


def _write(
    stem: str,
    whole: b.Document,
    pictures: Sequence[PlacedFigure],
    out: Path | str,
    wanted: Wanted,
    claims: myst.Claims = (),
) -> list[Path]:
    drawn = {each.name: both(each.drawing, each.given) for each in over("drawing", pictures)}
    files = {f"figures/{name}.pdf": paper for name, (paper, _) in drawn.items()}
    files |= {f"figures/{name}.svg": page for name, (_, page) in drawn.items()}
    pages = {name: page.decode() for name, (_, page) in drawn.items()}
    paths = {name: f"figures/{name}.pdf" for name in drawn}
    source = tex.write(whole, paths)
    motions = {each.name: each.motions() for each in pictures}
    player = wanted.player(motions) if wanted.player else ""
    contents = {
        **files,
        f"{stem}.tex": source.encode(),
        f"{stem}.html": html.write(whole, pages, player=player).encode(),
    }
    if wanted.slides:
        document = replace(whole, blocks=tuple(projected(whole.blocks, wanted.solutions)))
        slides = html.write(document, pages, slides=True, player=player)
        contents["slides.html"] = slides.encode()
    if wanted.fragment:
        contents |= {name: text.encode() for name, text in tex.chapters(whole, paths).items()}
    if wanted.myst:
        contents |= {name: text.encode() for name, text in myst.write(whole, claims).items()}
    if wanted.pdf:
        vectors = {name: f"figures/{name}.svg" for name in drawn}
        try:
            contents[f"{stem}.pdf"] = make_pdf(
                lambda: source, lambda: typst.write(whole, vectors), files, whole.look
            )
        except LatexError as error:
            write_all(Path(out), contents | {f"{stem}.log": error.log.encode()})
            raise RigidtopError(f"{error}; see {Path(out, stem)}.tex and .log") from None
    return write_all(Path(out), contents)
