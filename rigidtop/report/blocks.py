"""The blocks of a document, which `tex`, `html`, `typst` and the others write down."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass, replace
from typing import Any, TypeVar

from rigidtop.proof.equation import Equation
from rigidtop.proof.lecture import Lecture
from rigidtop.proof.page import Page
from rigidtop.proof.verdict import (
    Judgement,
    Verdict,
)
from rigidtop.typeset import sizes
from rigidtop.typeset.layout import Order
from rigidtop.typeset.nodes import Node
from rigidtop.typeset.words import printed_unit

T = TypeVar("T")
Judged = Sequence[tuple[Page, Sequence[Judgement]]]


MARKS: Mapping[Verdict, str] = {
    Verdict.PROVED: "✓",
    Verdict.SAMPLED: "≈",
    Verdict.ASSUMING: "◐",
    Verdict.CONVENTION: "⇄",
    Verdict.FALSE: "✗",
    Verdict.DEFINITION: "≔",
    Verdict.UNDECIDED: "?",
}


@dataclass(frozen=True)
class Cited:
    """Words that lead to another place of the document, such as (3.54)."""

    words: str
    anchor: str


COLORS: Mapping[Verdict, tuple[str, str]] = {
    Verdict.PROVED: ("1e5b3a", "86cfa5"),
    Verdict.SAMPLED: ("3e5f2b", "b0cf8f"),
    Verdict.ASSUMING: ("7a4b00", "e6b865"),
    Verdict.CONVENTION: ("5b2d83", "cba6ee"),
    Verdict.FALSE: ("8e1b1b", "f29b9b"),
    Verdict.DEFINITION: ("2b4c7e", "9cbcf0"),
    Verdict.UNDECIDED: ("444444", "bbbbbb"),
}
"""Of the verdicts, on white and on black."""


@dataclass(frozen=True)
class UprightUnit:
    """A unit behind a number, in upright letters: kg m², °."""

    letters: str

    @property
    def spaced(self) -> str:
        """The unit with the thin space that stands before it."""
        return self.letters if self.letters[:1] in "°″%" else "\u2009" + printed_unit(self.letters)


Piece = str | Node | Cited | UprightUnit | Verdict
Rich = tuple[Piece, ...]
"""Running text: prose, with formulas as layout nodes, units, citations, verdicts between."""


@dataclass(frozen=True)
class Script:
    """How the pieces of running text are written in a language; called, it writes them."""

    words: Callable[[str], str]
    formula: Callable[[Node], str]
    unit: Callable[[str], str]
    cited: Callable[[Cited], str]
    verdict: Callable[[Verdict], str] = str

    def __call__(self, content: Rich) -> str:
        """Running text with its formulas, as one string of the format."""
        return "".join(map(self._piece, content))

    def _piece(self, piece: Piece) -> str:
        match piece:
            case UprightUnit():
                return self.unit(piece.spaced)
            case Verdict():
                return self.verdict(piece)
            case Cited():
                return self.cited(piece)
            case str():
                return self.words(piece)
        return self.formula(piece)


def listed(items: Iterable[Rich], between: str = ", ", last: str = "") -> Rich:
    """Running text of several items, `between` two of them; the `last` has a word of its own.

    >>> listed((("a",), ("b", "c"), ("d",)), last=" and ")
    ('a', ', ', 'b', 'c', ' and ', 'd')
    """
    first, *others = (*items, ())
    joints = [between] * (len(others) - 2) + [last or between]
    joined = ((joint, *item) for joint, item in zip(joints, others[:-1], strict=False))
    return tuple(piece for part in (first, *joined) for piece in part)


# --- Blocks --------------------------------------------------------------------------------------


@dataclass(frozen=True)
class SectionHead:
    """A section, level 1 for 3.2, level 2 for 3.2.1."""

    level: int
    number: str
    title: str
    anchor: str


@dataclass(frozen=True)
class MarginMark:
    """The verdict on a claim in the margin beside it; the `note` tells its conditions.

    Where it only says "as above", `above` has what is said there.
    """

    name: str
    verdict: Verdict
    note: Rich = ()
    above: Rich = ()

    @property
    def in_full(self) -> MarginMark:
        """The mark with its whole note, for where what is above is not in sight."""
        return replace(self, note=self.above or self.note)


@dataclass(frozen=True)
class Paragraph:
    """Running text, with a short label before it ("Reason"); `held` to what follows.

    A `mark` stands in the margin; `anchor` is its place for what cites it.
    """

    content: Rich
    label: str = ""
    held: bool = False
    mark: MarginMark | None = None
    anchor: str = ""


@dataclass(frozen=True)
class DisplayRow:
    """An equation of a display.

    `reason` is the sentence that belongs to it; `follows` says that it follows from the line
    above, which `spoken` says too; `verdict` is shown where the verdicts of one claim differ, a
    `mark` stands in the margin; `anchor` is its place for what cites it.
    Equations `beside` it stand in the same line.  `line` is the line of the lecture that it is of,
    `cites` are those that its move rests on.
    """

    equation: Equation
    order: Order
    tag: str = ""
    reason: str | Rich = ""
    follows: bool = False
    verdict: Verdict | None = None
    mark: MarginMark | None = None
    anchor: str = ""
    beside: tuple[Equation, ...] = ()
    line: str = ""
    cites: tuple[str, ...] = ()

    @property
    def spoken(self) -> Rich:
        if not self.reason:
            return ()
        words = (self.reason,) if isinstance(self.reason, str) else self.reason
        return ("⇒ ", *words) if self.follows else words


@dataclass(frozen=True)
class Display:
    """Equations below each other, each after its reason, under a short label.

    Lines are broken that have no `room`, in letters.  A `step` of a derivation goes on with the
    paragraph above it, or stands in one line with its sentence where it is short.
    """

    rows: tuple[DisplayRow, ...]
    label: str = ""
    room: float = sizes.LINE
    step: bool = False


@dataclass(frozen=True)
class ClaimHead:
    """The name of a claim, what it asserts, and its verdict."""

    name: str
    anchor: str
    says: str
    verdict: Verdict
    level: int = 3

    @property
    def shown(self) -> str:
        """(3.57) for an equation, the name itself for a slug."""
        return f"({self.name})" if is_number(self.name) else self.name


@dataclass(frozen=True)
class Items:
    """Sentences below each other, each an item of a list, under a short label."""

    items: tuple[Rich, ...]
    label: str


@dataclass(frozen=True)
class TableBlock:
    """Rows of cells under the heads of their columns.

    Its `kind` is one of "values" (words, number, unit), "numbers", "symbols" and "text";  `widths`
    are the shares of the line that its columns take, 0 for one that is as wide as its words.
    """

    head: tuple[str, ...]
    rows: tuple[tuple[Piece | Rich, ...], ...]
    title: str = ""
    kind: str = "numbers"
    widths: tuple[float, ...] = ()

    @property
    def cells(self) -> list[list[Rich]]:
        """The cells of every row as running text."""
        return [[x if isinstance(x, tuple) else (x,) for x in row] for row in self.rows]

    @property
    def right(self) -> Sequence[int]:
        """The columns of numbers, which end beneath each other; words begin there."""
        if self.kind != "numbers":
            return (1,) if self.kind == "values" else ()
        columns = enumerate(zip(*self.rows, strict=True))
        return [k for k, cells in columns if any(isinstance(x, Node) for x in cells)]


@dataclass(frozen=True)
class Figure:
    """A figure by its name, with its caption, and its content in words."""

    name: str
    caption: str
    alternative: str
    number: int = 0
    kind: str = "Figure"

    @property
    def anchor(self) -> str:
        return f"figure-{self.name}"

    @property
    def label(self) -> str:
        """What stands before the caption, where figures are numbered."""
        return f"{self.kind} {self.number}" if self.number else ""


@dataclass(frozen=True)
class ExerciseHead:
    """The title of an exercise, and where the notes ask for it; `points` that it can bring."""

    title: str
    anchor: str
    asks: str
    number: int = 0
    points: str = ""
    level: int = 3
    kind: str = "Exercise"

    @property
    def label(self) -> str:
        """What stands before the title: the kind, and the number if there is one."""
        return f"{self.kind} {self.number}" if self.number else self.kind


@dataclass(frozen=True)
class Subhead:
    """The name of a part of an exercise, or of a section, there with the `level` of a heading."""

    words: str
    level: int = 0


@dataclass(frozen=True)
class Aside:
    """Where a box begins, which holds what goes beyond the main thread.

    One `for_lecturers` is about the notes, not about the subject.
    """

    title: str
    for_lecturers: bool = False


@dataclass(frozen=True)
class AsideEnd:
    """The end of the innermost box that is open."""


@dataclass(frozen=True)
class Results:
    """The numbered equations on one page: each number with its lines, its words, its verdict."""

    rows: tuple[tuple[str, tuple[Equation, ...], Rich, Verdict], ...]
    head: tuple[str, ...] = ("number", "equation", "what it says")


@dataclass(frozen=True)
class Legend:
    """What the marks in the margin mean, verdict by verdict."""

    rows: tuple[tuple[Verdict, str], ...]
    head: str = "In the margin, at each claim"


@dataclass(frozen=True)
class NameLine:
    """Where a student writes a name, and a date."""

    words: tuple[str, ...] = ("Name", "Date")


@dataclass(frozen=True)
class Room:
    """Blank paper for an answer, some hands high."""


Block = (
    SectionHead
    | Paragraph
    | Display
    | ClaimHead
    | Items
    | TableBlock
    | Figure
    | ExerciseHead
    | Subhead
    | Aside
    | AsideEnd
    | Results
    | Legend
    | NameLine
    | Room
)


@dataclass(frozen=True)
class Look:
    """How a document is set: its paper, a preamble and a class of one's own."""

    paper: str = "a4"
    preamble: str = ""
    documentclass: str = ""


@dataclass(frozen=True)
class Document:
    """Title, subtitle, blocks, colophon.

    `byline` stands beneath the title: author, course, date.  A `lecture` has its verdicts in the
    margin, a record among its lines.  A page begins with its `opening`, which is not on paper.
    """

    title: str
    subtitle: str
    blocks: tuple[Block, ...]
    colophon: str
    author: str = "rigidtop"
    byline: str = ""
    lecture: bool = False
    look: Look = Look()
    opening: Figure | None = None

    @property
    def contents(self) -> tuple[SectionHead | ExerciseHead, ...]:
        """What its contents list; nothing where a lecture has no sections, as a sheet has none."""
        kinds = SectionHead if self.lecture else SectionHead | ExerciseHead
        listed = tuple(b for b in self.blocks if isinstance(b, kinds))
        return listed if any(b.anchor.startswith("section-") for b in listed) else ()

    @property
    def keywords(self) -> tuple[str, ...]:
        """The titles of its numbered sections, or else of its exercises."""
        sections = [b.title for b in self.blocks if isinstance(b, SectionHead) and b.number]
        exercises = [b.title for b in self.blocks if isinstance(b, ExerciseHead)]
        return tuple(dict.fromkeys(sections or exercises))


# --- Building ------------------------------------------------------------------------------------


def groups(block: Display) -> list[list[DisplayRow]]:
    """Rows between which no reason and no tag stands: they are aligned with each other."""
    aligned: list[list[DisplayRow]] = []
    for row in block.rows:
        last = aligned[-1][-1] if aligned else None
        if last is None or last.tag or last.verdict or last.order != row.order or row.reason:
            aligned.append([row])
        else:
            aligned[-1].append(row)
    return aligned


def quantities(title: str, rows: Iterable[tuple[str, Piece, str]]) -> TableBlock:
    """What was given or found: words, value, unit."""
    head = ("what", "value", "unit")
    cells = tuple((what, value, in_unit(unit)) for what, value, unit in rows)
    return TableBlock(head, cells, title, "values", (1, 0, 0))


def in_unit(letters: str) -> Rich:
    """A cell with a unit, empty for a bare number."""
    return (UprightUnit(letters),) if letters not in ("", "1") else ()


def walked(tree: T, change: Callable[[Any, str], Any], name: str = "") -> T:
    """A block, a claim, a tuple of them …, its parts changed, the smallest first.

    The `change` is told a part and the name of its field; what it leaves is the same object.
    Formulas are one part, and so are the lines of a lecture, which are not of this tree.
    """
    image: Any = tree
    if isinstance(tree, Node | Equation | Lecture):
        return tree
    if isinstance(tree, tuple):
        parts = tuple(walked(each, change, name) for each in tree)
        image = parts if any(a is not b for a, b in zip(parts, tree, strict=True)) else tree
    elif is_dataclass(tree) and not isinstance(tree, type):
        had = {field.name: getattr(tree, field.name) for field in fields(tree) if field.init}
        new = {field: walked(part, change, field) for field, part in had.items()}
        new = {field: part for field, part in new.items() if part is not had[field]}
        image = replace(tree, **new) if new else tree
    changed: T = change(image, name)
    return changed


def is_number(name: str) -> bool:
    """Whether a claim is named by its equation's number."""
    return bool(re.fullmatch(r"\d+\.\d+[a-z]?", name))


IN_COLUMNS = ("solutions", "laws")
"""The anchors of headings from which on pages have two columns."""


def anchor(name: str) -> str:
    """A name for links: letters, digits and hyphens."""
    return "claim-" + re.sub(r"[^A-Za-z0-9]+", "-", name).strip("-")


def headings(page: Page) -> Iterable[SectionHead]:
    """The heading of a page, after that of the section above where the page opens it."""
    number = page.section if re.fullmatch(r"[\d.]+", page.section) else ""
    if page.opens:
        above = number.rpartition(".")[0]
        yield SectionHead(1, above, page.opens, _section_anchor(above))
    level = 2 if page.section.count(".") >= 2 else 1
    yield SectionHead(level, number, page.title, _section_anchor(page.section))


def _section_anchor(section: str) -> str:
    return "section-" + re.sub(r"\W+", "-", section).strip("-")
