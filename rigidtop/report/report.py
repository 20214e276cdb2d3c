"""The lecture as one structure, which `tex`, `html` and `typst` write down.

`document` turns judged pages into blocks; it decides what is said and in which order, the writers
how it looks.  `write_lecture` leaves the finished files in a folder.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any

import sympy
from sympy import Expr, MatrixBase, Symbol

from rigidtop.proof.equation import Equation, Printed
from rigidtop.proof.page import Assumption, Correction, Definition, Measure, Page, Step
from rigidtop.proof.verdict import (
    Counterexample,
    Finding,
    Judgement,
    Led,
    TestedAssumption,
    Verdict,
)
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.symbols import VOCABULARY
from rigidtop.typeset import layout as lay
from rigidtop.typeset.layout import Node, Order, layout, width
from rigidtop.typeset.text import text

Judged = Sequence[tuple[Page, Sequence[Judgement]]]


@dataclass(frozen=True)
class Front:
    """What stands on the first page of a lecture and of its exercises, and whose claims it has."""

    title: str
    subtitle: str
    source: str
    exercises: str
    author: str = "rigidtop"
    byline: str = ""


NOTES = Front(
    "Rigid rotation and the spinning top: derived and judged",
    "Free precession, Euler angles and the heavy symmetric top, equations (3.33) to (3.57)",
    "The numbered equations and the claims are those of the lecture notes of Sebastian Wüster, "
    "PHY 305 Classical Mechanics, IISER Bhopal, 2020, week 8. The wording, the derivations and "
    "the verdicts are ours. Every verdict on these pages was computed when they were written.",
    "Rigid rotation and the spinning top: exercises",
)
"""The lecture notes on the top."""

READING = (
    "Each claim of the notes is typed as it is printed there and held against what a computer "
    "algebra system derives by itself from the definitions. The residual between the two "
    "decides. Nothing is judged by its looks, and no verdict is written by hand."
)
MEANINGS: Mapping[Verdict, str] = {
    Verdict.PROVED: "the residual vanishes identically",
    Verdict.SAMPLED: "the residual vanishes to 40 digits at random points; not shown in symbols",
    Verdict.ASSUMING: "true only under conditions that the notes do not state beside the claim",
    Verdict.CONVENTION: "right in content, at odds with the notes' own definitions",
    Verdict.FALSE: "refuted by numbers",
    Verdict.DEFINITION: "introduces a name; there is nothing to prove",
    Verdict.UNDECIDED: "neither shown nor refuted",
}
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
class Unit:
    """A unit behind a number, in upright letters: kg m², °."""

    letters: str

    @property
    def spaced(self) -> str:
        """With the thin space that stands before it."""
        return self.letters if self.letters[:1] in "°″%" else "\u2009" + self.letters


Piece = str | Node | Cited | Unit
Rich = tuple[Piece, ...]
"""Running text: prose, with formulas as layout nodes, units and citations between."""


# --- Blocks --------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Heading:
    """A section, level 1 for 3.2, level 2 for 3.2.1."""

    level: int
    number: str
    title: str
    anchor: str


@dataclass(frozen=True)
class Mark:
    """The verdict on a claim in the margin beside it; the `note` tells its conditions."""

    name: str
    verdict: Verdict
    note: Rich = ()


@dataclass(frozen=True)
class Paragraph:
    """Running text, with a short label before it ("Reason"); `held` to what follows.

    A `mark` stands in the margin; `anchor` is its place for what cites it.
    """

    content: Rich
    label: str = ""
    held: bool = False
    mark: Mark | None = None
    anchor: str = ""


@dataclass(frozen=True)
class Row:
    """An equation of a display.

    `reason` is the sentence that belongs to it; `follows` says that it follows from the line
    above, which `spoken` says too; `verdict` is shown where the verdicts of one claim differ, a
    `mark` stands in the margin; `anchor` is its place for what cites it.
    Equations `beside` it stand in the same line.
    """

    equation: Equation
    order: Order
    tag: str = ""
    reason: str | Rich = ""
    follows: bool = False
    verdict: Verdict | None = None
    mark: Mark | None = None
    anchor: str = ""
    beside: tuple[Equation, ...] = ()

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

    rows: tuple[Row, ...]
    label: str = ""
    room: float = lay.LINE
    step: bool = False


@dataclass(frozen=True)
class ClaimHead:
    """The name of a claim, what it asserts, and its verdict."""

    name: str
    anchor: str
    says: str
    verdict: Verdict

    @property
    def shown(self) -> str:
        """(3.57) for an equation, the name itself for a slug."""
        return f"({self.name})" if is_number(self.name) else self.name


@dataclass(frozen=True)
class Numbers:
    """Values of symbols at which two sides differ."""

    label: str
    values: tuple[tuple[Node, Node], ...]
    left: Node | None
    right: Node | None

    def said(self, written: Callable[[Node], str]) -> str:
        """The two sides in words, each number `written` by the target."""
        left, right = (
            "undefined" if side is None else written(side) for side in (self.left, self.right)
        )
        if left == right:
            return f"both sides are {left}"
        return f"the left side is {left}, the right side {right}"


@dataclass(frozen=True)
class Condition:
    """An assumption: the relation, words for it, and what happens without it."""

    relation: Node
    words: str
    stated: bool
    without: Numbers


@dataclass(frozen=True)
class Conditions:
    """The assumptions of a claim."""

    items: tuple[Condition, ...]


@dataclass(frozen=True)
class Measures:
    """What was compared: on computed motions, or by a second way to the same number."""

    rows: tuple[Measure, ...]
    label: str = "Measured"
    compared: str = "on a computed motion"


@dataclass(frozen=True)
class Summary:
    """How many claims got which verdict."""

    rows: tuple[tuple[Verdict, int, str], ...]


@dataclass(frozen=True)
class Found:
    """A line of the list of what was found in the notes."""

    section: str
    name: str
    anchor: str
    verdict: Verdict
    content: Rich


@dataclass(frozen=True)
class FoundList:
    """What was found in the notes."""

    rows: tuple[Found, ...]


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
        """What stands before the title."""
        return f"{self.kind} {self.number}" if self.number else self.kind


@dataclass(frozen=True)
class Subhead:
    """The name of a part of an exercise, or of a section, there with the `level` of a heading."""

    words: str
    level: int = 0


@dataclass(frozen=True)
class Quantities:
    """What was given or found: words, value, unit."""

    label: str
    rows: tuple[tuple[str, str | Node, str], ...]


@dataclass(frozen=True)
class DataTable:
    """Many numbers, under their columns; on one page where it is kept `whole`."""

    title: str
    columns: tuple[str, ...]
    rows: tuple[tuple[str | Node, ...], ...]
    whole: bool = False


@dataclass(frozen=True)
class Symbols:
    """The list of symbols: glyph, meaning, unit."""

    rows: tuple[tuple[Node, str, str], ...]


@dataclass(frozen=True)
class Results:
    """The numbered equations on one page: each with its number, its words and its mark."""

    rows: tuple[tuple[str, Equation, str, Mark | None], ...]


@dataclass(frozen=True)
class Legend:
    """What the marks in the margin mean."""

    rows: tuple[tuple[Verdict, str], ...]
    head: str = "In the margin"


@dataclass(frozen=True)
class NameLine:
    """Where a student writes a name, and a date."""

    words: tuple[str, ...] = ("Name", "Date")


Block = (
    Heading
    | Paragraph
    | Display
    | ClaimHead
    | Numbers
    | Conditions
    | Measures
    | Summary
    | FoundList
    | Figure
    | ExerciseHead
    | Subhead
    | Quantities
    | DataTable
    | Symbols
    | Results
    | Legend
    | NameLine
)


PAPERS = ("a4", "letter")


@dataclass(frozen=True)
class Look:
    """How a document is set: its paper, its language, a preamble and a class of one's own."""

    paper: str = "a4"
    language: str = "en"
    preamble: str = ""
    documentclass: str = ""


@dataclass(frozen=True)
class Document:
    """Title, subtitle, blocks, colophon.

    `byline` stands beneath the title: author, course, date.  A `lecture` has its verdicts in the
    margin, a record among its lines.
    """

    title: str
    subtitle: str
    blocks: tuple[Block, ...]
    colophon: str
    author: str = "rigidtop"
    byline: str = ""
    lecture: bool = False
    look: Look = Look()

    @property
    def keywords(self) -> tuple[str, ...]:
        """The titles of its numbered sections, or else of its exercises."""
        sections = [b.title for b in self.blocks if isinstance(b, Heading) and b.number]
        exercises = [b.title for b in self.blocks if isinstance(b, ExerciseHead)]
        return tuple(dict.fromkeys(sections or exercises))


# --- Building ------------------------------------------------------------------------------------


def document(
    judged: Judged,
    closing: Iterable[tuple[str, Block]] = (),
    front: Front = NOTES,
    texts: Mapping[str, Sequence[Block]] = MappingProxyType({}),
) -> Document:
    """The lecture.  The blocks `closing` a section come with its number: figures, exercises.

    `texts` are the sections' texts by their numbers; behind them stand the verdicts.
    """
    after: dict[str, list[Block]] = {}
    for section, block in closing:
        after.setdefault(section, []).append(block)
    blocks: list[Block] = [*_front(judged)]
    for page, judgements in judged:
        blocks.extend(headings(page))
        blocks.extend(texts.get(page.section, [Paragraph((page.about,), held=True)]))
        for judgement in judgements:
            blocks.extend(claim_blocks(judgement))
        blocks.extend(after.get(page.section, ()))
    whole = (*blocks, *symbol_list(blocks))
    return Document(front.title, front.subtitle, whole, front.source, front.author)


def groups(block: Display) -> list[list[Row]]:
    """Rows between which no reason and no tag stands: they are aligned with each other."""
    made: list[list[Row]] = []
    for row in block.rows:
        last = made[-1][-1] if made else None
        if last is None or last.tag or last.verdict or last.order != row.order or row.reason:
            made.append([row])
        else:
            made[-1].append(row)
    return made


def is_number(name: str) -> bool:
    """Whether a claim is named by its equation's number."""
    return bool(re.fullmatch(r"\d+\.\d+[a-z]?", name))


def anchor(name: str) -> str:
    """A name for links: letters, digits and hyphens."""
    return "claim-" + re.sub(r"[^A-Za-z0-9]+", "-", name).strip("-")


def headings(page: Page) -> Iterable[Heading]:
    """The heading of a page, after that of the section above where the page opens it."""
    number = page.section if re.fullmatch(r"[\d.]+", page.section) else ""
    if page.opens:
        above = number.rpartition(".")[0]
        yield Heading(1, above, page.opens, _section_anchor(above))
    level = 2 if page.section.count(".") >= 2 else 1
    yield Heading(level, number, page.title, _section_anchor(page.section))


def _section_anchor(section: str) -> str:
    return "section-" + re.sub(r"\W+", "-", section).strip("-")


def _front(judged: Judged) -> Iterable[Block]:
    everything = [judgement for _, judgements in judged for judgement in judgements]
    yield Heading(1, "", "How to read the verdicts", "verdicts")
    yield Paragraph((READING,))
    counts = [(v, sum(j.verdict is v for j in everything)) for v in Verdict]
    yield Summary(tuple((v, count, MEANINGS[v]) for v, count in counts if count))
    found = tuple(_found(judgement) for judgement in everything if judgement.verdict in _NOTED)
    if found:
        yield Heading(1, "", "What was found in the notes", "found")
        yield FoundList(found)


_NOTED = (Verdict.ASSUMING, Verdict.CONVENTION, Verdict.FALSE, Verdict.UNDECIDED)


def _found(judgement: Judgement) -> Found:
    claim = judgement.claim
    content: Rich
    if judgement.verdict is Verdict.ASSUMING:
        silent = [t for t in tested(judgement) if not t.assumption.stated]
        content = ("Not stated: ", *_joined(silent), ".")
    else:
        content = (claim.says,)
        corrected = [c.check.claimed for c in judgement.corrections()]
        shown = [layout(equation, "printed") for equation in corrected if not _has_matrix(equation)]
        short = [node for node in shown if width(node) < 45]
        for i, node in enumerate(short):
            content = (*content, "; " if i else " Corrected: ", node)
        if len(short) < len(corrected):
            content = (*content, "; more at the claim" if short else " Corrected at the claim")
        if corrected:
            content = (*content, ".")
    return Found(judgement.section, claim.name, anchor(claim.name), judgement.verdict, content)


def _has_matrix(equation: Equation) -> bool:
    nodes = (node for side in equation.sides for node in sympy.preorder_traversal(side))
    return any(isinstance(node, MatrixBase) for node in nodes)


def _joined(tested: Sequence[TestedAssumption]) -> Rich:
    pieces: list[str | Node] = []
    for i, item in enumerate(tested):
        pieces.append("; " if i else "")
        pieces.append(condition(item.assumption))
        if item.assumption.words:
            pieces.append(f" ({item.assumption.words.rstrip('.')})")
    return tuple(piece for piece in pieces if piece != "")


def claim_blocks(judgement: Judgement, *, marks: bool = True) -> list[Block]:
    """A claim with all that its evidence showed; `marks` puts verdicts that differ beside lines."""
    claim = judgement.claim
    findings = judgement.findings()
    blocks: list[Block] = [ClaimHead(claim.name, anchor(claim.name), claim.says, judgement.verdict)]
    mixed = marks and len({finding.verdict for finding in findings}) > 1
    led = any(isinstance(item, Led) for item in judgement.items)
    rows = tagged_rows(judgement, mixed)
    amiss = judgement.verdict in (Verdict.FALSE, Verdict.CONVENTION)
    if rows and (amiss or not led):
        blocks.append(Display(rows, "The notes print"))
    if not led:  # else its lines say the rest
        if claim.reason:
            blocks.append(Paragraph((claim.reason,), "Reason"))
        blocks.extend(derivation(judgement, mixed))
        meanings = _meanings(judgement)
        if meanings:
            blocks.append(Display(meanings, "The engine's own expressions"))
    assumed = tested(judgement)
    if assumed:
        blocks.append(Conditions(conditions(assumed)))
    blocks.extend(
        numbers(finding.counterexample)
        for finding in findings
        if finding.counterexample is not None
    )
    corrected = judgement.corrections()
    if corrected:
        made = tuple(replace(_notes_row(item, False), tag="") for item in corrected)
        blocks.append(Display(made, "Corrected form"))
        under = conditions([t for c in corrected for t in c.assumptions])
        if under:
            blocks.append(Conditions(under))
    remarks = judgement.remarks()
    if remarks:
        made = tuple(replace(_notes_row(item, False), tag="") for item in remarks)
        blocks.append(Display(made, "Besides"))
        under = conditions([t for r in remarks for t in r.assumptions])
        if under:
            blocks.append(Conditions(under))
    measures = tuple(item for item in judgement.items if isinstance(item, Measure))
    if measures:
        blocks.append(Measures(measures))
    if judgement.problem and not any(isinstance(i, Led) and i.gaps for i in judgement.items):
        blocks.append(Paragraph((f"This claim does not pass. {_sentence(judgement.problem)}",), ""))
    return blocks


def tagged_rows(judgement: Judgement, mixed: bool = False) -> tuple[Row, ...]:
    """What the notes print of a claim, with its number."""
    items: list[Definition | Finding] = [
        *(item for item in judgement.items if isinstance(item, Definition)),
        *(finding for finding in judgement.findings() if finding.check.printed),
    ]
    rows = [_notes_row(item, mixed) for item in items]
    return _tagged(rows, judgement.claim.name) if rows else ()


def derivation(judgement: Judgement, mixed: bool) -> Iterable[Block]:
    """Steps and formal checks in their order; an equation that stands already is not repeated."""
    rows: list[Row] = []
    again: list[str] = []
    seen = {_said(f) for f in judgement.findings() if f.check.printed}
    for item in judgement.items:
        if isinstance(item, Step):
            rows.append(Row(item.equation, "auto", reason=item.reason))
        elif isinstance(item, Finding) and item in judgement.findings():
            if item.check.printed:
                continue
            if _said(item) in seen:
                again.append(item.check.reason)
                continue
            seen.add(_said(item))
            rows.append(replace(_notes_row(item, mixed), tag=""))
    if rows:
        yield Display(tuple(rows), "Derivation")
    sentences = list(dict.fromkeys(filter(None, again)))
    if sentences:
        yield Paragraph((" ".join(map(_sentence, sentences)),), "Checked again")


def _said(finding: Finding) -> tuple[Any, ...]:
    """What a line says: the equation, its verdict, and, where a reason tells, under what."""
    check = finding.check
    conditions = {str(a.condition) for a in check.assuming} if check.reason else ()
    return (*check.claimed.sides, check.claimed.relation, finding.verdict, frozenset(conditions))


def _sentence(words: str) -> str:
    return words[:1].upper() + words[1:].rstrip(".") + "."


def _notes_row(item: Definition | Finding, mixed: bool) -> Row:
    if isinstance(item, Definition):
        return Row(item.equation, "printed", item.equation.tag, item.reason)
    check = item.check
    return Row(
        check.claimed,
        "printed",
        check.claimed.tag,
        check.reason,
        bool(check.given) and not isinstance(check, Correction),
        item.verdict if mixed else None,
    )


def _tagged(rows: Sequence[Row], name: str) -> tuple[Row, ...]:
    """Each number once, behind the last of its lines; the claim's own if no line has one."""
    tags = [row.tag for row in rows]
    if not any(tags) and is_number(name):
        tags[-1] = name
    once = [tag if tag not in tags[i + 1 :] else "" for i, tag in enumerate(tags)]
    return tuple(replace(row, tag=tag) for row, tag in zip(rows, once, strict=True))


LONGEST = 110.0
"""A meaning that is wider than this is not printed, nor one that does not go into two lines."""


def _meanings(judgement: Judgement) -> tuple[Row, ...]:
    """What the symbols of the claim stand for in the engine, where that is short and the same
    in all checks of what the notes print, and not shown as a step."""
    checks = [finding.check for finding in judgement.findings()]
    shown = {item.equation.sides for item in judgement.items if isinstance(item, Step)}
    found: dict[str, set[Row]] = {}
    for check in [c for c in checks if c.printed] or checks:
        for symbol, meaning in check.meaning.items():
            used = any(side.has(symbol) for side in check.claimed.sides)
            if used and _is_shown(symbol, meaning):
                row = Row(Equation(symbol, meaning), "auto")
                found.setdefault(text(symbol), set()).add(row)
    rows = [
        row for alternatives in found.values() if len(alternatives) == 1 for row in alternatives
    ]
    return tuple(row for row in rows if row.equation.sides not in shown and _is_short(row.equation))


def _is_short(equation: Equation) -> bool:
    if width(layout(equation)) > LONGEST:
        return False
    return all(width(line.right) <= lay.LINE for line in lay.lines(equation))


def _is_shown(symbol: Any, meaning: Any) -> bool:
    if not isinstance(symbol, (Symbol, Printed)):
        return False
    if isinstance(meaning, sympy.MatrixBase):  # an axis along itself says nothing
        return bool(meaning.free_symbols)
    return isinstance(meaning, Expr) and not meaning.is_Atom


def tested(judgement: Judgement) -> list[TestedAssumption]:
    """The assumptions of all findings, each once."""
    once: dict[tuple[str, str], TestedAssumption] = {}
    for finding in judgement.findings():
        for tested in finding.assumptions:
            key = (str(tested.assumption.condition), tested.assumption.words)
            once.setdefault(key, tested)
    return list(once.values())


def condition(assumption: Assumption) -> Node:
    """The relation as it is written; a limit, ε = 0 for the engine, as ε → 0."""
    relation = layout(assumption.condition)
    if assumption.otherwise is not None and isinstance(relation, lay.Chain):
        return replace(relation, signs=("→",))
    return relation


def conditions(assumed: Sequence[TestedAssumption]) -> tuple[Condition, ...]:
    """Assumptions as they are listed: those with the same words together, one counterexample."""
    together: dict[tuple[str, bool], list[TestedAssumption]] = {}
    for item in assumed:
        words = item.assumption.words.rstrip(".")
        key = (words or str(item.assumption.condition), item.assumption.stated)
        together.setdefault(key, []).append(item)
    return tuple(map(_condition, together.values()))


def _condition(items: Sequence[TestedAssumption]) -> Condition:
    relations = tuple(dict.fromkeys(condition(item.assumption) for item in items))
    first = items[0].assumption
    return Condition(
        relations[0] if len(relations) == 1 else lay.Listed(relations),
        first.words.rstrip("."),
        first.stated,
        numbers(items[0].without, "Without it" if len(relations) == 1 else "Without the first"),
    )


def numbers(found: Counterexample, label: str = "Counterexample") -> Numbers:
    """A counterexample in the order of the vocabulary, its numbers shortened."""
    ordered = sorted(found.values.items(), key=lambda kv: (lay.known(kv[0])[0], str(kv[0])))
    values = tuple((layout(symbol), short_number(value)) for symbol, value in ordered)
    return Numbers(label, values, _real_number(found.left), _real_number(found.right))


def _real_number(side: Any) -> Node | None:
    """A side of a counterexample; None where it has no real value there."""
    if side is None or not sympy.sympify(side).evalf(12).is_real:
        return None
    return short_number(side)


def short_number(number: Any) -> Node:
    """An exact number where it is short, else six digits of it.

    >>> third = sympy.Rational(3, 7)
    >>> text(short_number(third)), text(short_number(sympy.sin(third / 3 * 2)))
    ('3/7', '0.281843')
    """
    number = sympy.sympify(number)
    exact = layout(number)
    if width(exact) <= 6 and not number.has(sympy.Function):
        return exact
    return layout(sympy.Float(number.evalf(12)))


def symbol_list(
    blocks: Sequence[Block], order: Mapping[str, int] | None = None
) -> tuple[Block, ...]:
    """The symbols of all displays under a heading; nothing where there are none.

    They stand in an `order` of their names, or in that of the vocabulary.
    """
    used = symbols_used(blocks)
    names = {symbol.name for symbol in used if not isinstance(symbol, Lettered)}
    # A symbol of another notation stands where that of the notes does, others before.
    own = {x for x in used if isinstance(x, Lettered)}
    alone = sorted((x for x in own if x.stands is None), key=lambda x: (x.place, x.name))
    placed = {x.place: x for x in own if x.stands is not None}
    quantities = [(symbol, symbol.quantity) for symbol in alone]
    for place, (symbol, quantity) in enumerate(VOCABULARY.items()):
        if symbol.name in names:
            quantities.append((symbol, quantity))
        if place in placed:
            quantities.append((placed[place], placed[place].quantity))
    if order is not None:
        quantities.sort(key=lambda pair: order.get(pair[0].name, len(order)))
    rows = tuple(
        (layout(symbol), quantity.meaning, quantity.unit)
        for symbol, quantity in quantities
        if quantity.glyph.base != "const"
    )
    return (Heading(1, "", "Symbols", "symbols"), Symbols(rows)) if rows else ()


def symbols_used(blocks: Iterable[Block]) -> set[Symbol]:
    """The symbols of all displays."""
    return {
        symbol
        for block in blocks
        if isinstance(block, Display)
        for row in block.rows
        for side in row.equation.sides
        for symbol in side.free_symbols
    }
