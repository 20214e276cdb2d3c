"""Derivations as they are shown: each line after the sentence that says its move."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType
from typing import Any

import sympy

from rigidtop.notation import NOTES, Notation
from rigidtop.proof.derivation import Judged, Line
from rigidtop.proof.equation import Equation
from rigidtop.proof.lecture import (
    Box,
    BoxEnd,
    Heading,
    Illustration,
    Lecture,
    Prose,
    Shown,
    Text,
)
from rigidtop.proof.letters import Letters
from rigidtop.proof.moves import Condition
from rigidtop.proof.trial import diagnose
from rigidtop.proof.units import UnitsError
from rigidtop.proof.values import tree
from rigidtop.proof.verdict import Judgement, Led
from rigidtop.report import blocks as b
from rigidtop.report import plain
from rigidtop.report.claims import claim_blocks
from rigidtop.report.wording import Wording
from rigidtop.typeset.latex import latex
from rigidtop.typeset.layout import layout
from rigidtop.typeset.nodes import Node
from rigidtop.typeset.text import text


def way_blocks(
    lecture: Lecture, name: str, notation: Notation = NOTES, deep: bool = False
) -> list[b.Block]:
    """The lines that lead to what a name names, and what they start from.

    What does not follow is said.  A `deep` way starts from laws and definitions alone.
    """
    ids, starts = lecture.way(name, deep)
    rows = [row for id in ids for row in line_rows(lecture, id, notation, starts)]
    blocks: list[b.Block] = [b.Display(tuple(rows), "Derivation")]
    if starts:
        names = [called(lecture.lines[id], notation) for id in starts]
        blocks.append(b.Paragraph((*b.listed(names, last=" and "), "."), "From"))
    return [*blocks, *gaps(lecture, lecture.leading([name]))]


def claim_told(
    judgement: Judgement,
    notation: Notation = NOTES,
    deep: bool = False,
    *,
    led: bool = True,
    marks: bool = True,
) -> list[b.Block]:
    """A claim, its head first, with the lines that `led` to it and all that was found."""
    head, *content = claim_blocks(judgement, marks=marks)
    way = [
        block
        for item in judgement.items
        if led and isinstance(item, Led)
        for block in way_blocks(item.lecture, item.name, notation, deep)
    ]
    return [head, *way, *content]


def text_blocks(
    lecture: Lecture,
    text: Text,
    notation: Notation = NOTES,
    marks: Mapping[str, Sequence[b.Block | b.MarginMark]] = MappingProxyType({}),
    figures: Mapping[str, b.Figure] = MappingProxyType({}),
) -> list[b.Block]:
    """A page as it is read: its paragraphs, its headings, and every line after its sentence.

    `marks` stand beside the last line of what they name, and blocks among them behind it.  Each of
    the `figures` stands at its picture, or behind the paragraph that speaks of it first, and is
    cited by its number.
    """
    blocks: list[b.Block] = []
    rows: list[b.DisplayRow] = []
    placed = {block.name for block in text.blocks if isinstance(block, Illustration)}
    own = [line.id for line in text.lines]
    at: dict[str, Sequence[b.Block | b.MarginMark]] = {}
    for name, beside in marks.items():
        ids = [id for id in own if id in lecture.names.get(name, ())]
        if ids:
            at[ids[-1]] = (*at.get(ids[-1], ()), *beside)

    def close() -> None:
        if rows:
            blocks.append(b.Display(tuple(rows)))
            rows.clear()

    def place(words: Sequence[b.Piece]) -> None:
        """Put here the figures of which these words speak."""
        for name in cited_figures(words):
            if name in figures and name not in placed:
                placed.add(name)
                blocks.append(figures[name])

    for block in text.blocks[1:] if _is_title(text) else text.blocks:
        if isinstance(block, Shown):
            if block.line is not None:
                beside = at.get(block.line.id, ())
                lines = told_rows(lecture, block.line, notation, figures)
                marked = [each for each in beside if isinstance(each, b.MarginMark)]
                rows += [*lines[:-1], replace(lines[-1], mark=marked[0] if marked else None)]
                behind = [each for each in beside if not isinstance(each, b.MarginMark)]
                if behind or cited_figures(block.line.words):
                    close()
                    place(block.line.words)
                    blocks += behind
            continue
        close()
        if isinstance(block, BoxEnd):
            blocks.append(b.AsideEnd())
            continue
        content = running(block.pieces, notation, figures)
        if isinstance(block, Illustration):
            blocks += [captioned(figures[block.name], content)] * (block.name in figures)
        elif isinstance(block, Heading):
            blocks.append(b.Subhead(_titled(content)))
        elif isinstance(block, Box):
            blocks.append(b.Aside(_titled(content), block.for_lecturers))
        else:
            blocks.append(b.Paragraph(content))
            place(block.pieces)
    close()
    return [*blocks, *gaps(lecture, [line.id for line in text.lines])]


def captioned(figure: b.Figure, words: b.Rich) -> b.Figure:
    """A figure with the words of its page in front of those that it has itself."""
    return replace(figure, caption=f"{_titled(words)} {figure.caption}".strip())


def told_rows(
    lecture: Lecture,
    line: Line,
    notation: Notation = NOTES,
    figures: Mapping[str, b.Figure] = MappingProxyType({}),
) -> list[b.DisplayRow]:
    """The rows of a line; a law has the words in front that say what its letters are."""
    rows = line_rows(lecture, line.id, notation, figures=figures)
    origin = running(line.origin, notation)
    if origin:
        rows[0] = replace(rows[0], reason=(*origin, " ", *rows[0].spoken))
    return rows


def law_blocks(
    lecture: Lecture, pages: Collection[str], notation: Notation = NOTES
) -> list[b.Block]:
    """The laws and definitions that these pages cite, as they stand on other pages."""
    cited = {
        id
        for page in lecture.texts
        if page.name in pages
        for line in page.lines
        for id in lecture.cites(line.id)
    } & lecture.laws
    blocks: list[b.Block] = []
    for page in lecture.texts:
        if page.name in pages or not cited & {line.id for line in page.lines}:
            continue
        head: list[b.Block] = []
        for block in page.blocks[1:] if _is_title(page) else page.blocks:
            if isinstance(block, Heading):
                name = _titled(running(block.pieces, notation)).removeprefix("Laws: ")
                head = [b.Subhead(name[:1].upper() + name[1:])]
            elif isinstance(block, Prose):
                (head or blocks).append(b.Paragraph(running(block.pieces, notation)))
            elif isinstance(block, Shown) and block.line and block.line.id in cited:
                blocks += [*head, b.Display(tuple(told_rows(lecture, block.line, notation)))]
                head = []
    return blocks


def _titled(content: b.Rich) -> str:
    """Running text as the words of a title, its letters marked as in sentences."""
    title = []
    for piece in content:
        title.append(f"${latex(piece)}$" if isinstance(piece, Node) else plain.rich((piece,)))
    return "".join(title)


_FIGURE = re.compile(r"\[([^\]]+)\]\(#figure-([\w-]+)\)")


def cited_figures(words: Sequence[b.Piece]) -> list[str]:
    """The names of the figures that running text speaks of: [the figure](#figure-cones)."""
    return [m[2] for piece in words if isinstance(piece, str) for m in _FIGURE.finditer(piece)]


def _with_figures(words: str, figures: Mapping[str, b.Figure]) -> b.Rich:
    """Text that cites figures by their numbers; in its own words where they have none."""
    pieces: list[Any] = []
    end = 0
    for match in _FIGURE.finditer(words):
        pieces.append(words[end : match.start()])
        figure = figures.get(match[2])
        if figure is None:
            pieces.append(match[1])
        else:
            noun = "Figure" if match[1][:1].isupper() else "figure"
            pieces.append(b.Cited(f"{noun} {figure.number}", figure.anchor))
        end = match.end()
    return tuple(piece for piece in (*pieces, words[end:]) if piece)


def _is_title(text: Text) -> bool:
    return bool(text.blocks) and isinstance(text.blocks[0], Heading)


def line_rows(
    lecture: Lecture,
    id: str,
    notation: Notation = NOTES,
    above: Collection[str] = (),
    figures: Mapping[str, b.Figure] = MappingProxyType({}),
) -> list[b.DisplayRow]:
    """A line with its sentence.  What stands `above`, and is not shown, is called by its name."""
    judged = lecture.judged(id)
    words = _without_it(lecture, judged.line, above, notation, figures)
    words = _spoken(words, judged, notation)
    place = "line-" + re.sub(r"[^A-Za-z0-9]+", "-", id)
    equations = chained(judged.line.equations)
    last = len(equations) - 1
    return [
        b.DisplayRow(
            notation.written(equation),
            "printed",
            equation.tag,
            words if k == 0 else "",
            anchor=place if k == last else "",
            line=id,
            cites=lecture.cites(id) if k == 0 else (),
        )
        for k, equation in enumerate(equations)
    ]


def chained(equations: Sequence[Equation]) -> list[Equation]:
    """Equations as they are printed: a ≈ b, b = c as a ≈ b = c."""
    chains: list[Equation] = []
    for each in equations:
        if chains and not chains[-1].tag and chains[-1].sides[-1] == each.sides[0]:
            signs = [sign for e in (chains[-1], each) for sign in _signs(e)]
            sides = (*chains.pop().sides, *each.sides[1:])
            each = Equation(*sides, relation=" ".join(signs), tag=each.tag)
        chains.append(each)
    return chains


def _signs(equation: Equation) -> list[str]:
    signs = equation.relation.split()
    return signs if signs[1:] else signs * (len(equation.sides) - 1)


def gaps(lecture: Lecture, ids: Iterable[str]) -> list[b.Block]:
    """What does not follow, with its place."""
    return [b.Paragraph((f"{gap(each, lecture.letters)}.",), "Gap") for each in lecture.gaps(ids)]


_IT = re.compile(r"\bit\b(?! is)|(?<=\bwith )this\b")


def _without_it(
    lecture: Lecture,
    line: Line,
    above: Collection[str],
    notation: Notation,
    figures: Mapping[str, b.Figure],
) -> b.Rich:
    """A sentence that names the line just above where that is meant, and not shown."""
    along = line.move.by if line.move is not None and line.move.verb == "component" else ()
    words = running(line.words, notation, figures, along)
    if line.move is None:
        return words
    before = lecture.before(line.id)
    if before not in above or before not in {each.id for each in line.move.cited}:
        return words
    name = called(lecture.lines[before], notation)
    if line.move.unnamed and isinstance(words[0], str):
        words = ("Take ", *name, " and ", words[0][:1].lower() + words[0][1:], *words[1:])
    pieces: list[Any] = []
    for piece in words:
        parts = _IT.split(piece) if isinstance(piece, str) else [piece]
        for k, part in enumerate(parts):
            pieces += [*name, part] if k else [part]
    return tuple(pieces)


def _spoken(words: b.Rich, judged: Judged, notation: Notation) -> b.Rich:
    """A sentence, with the condition that its move brings: "where sin θ ≠ 0"."""
    move = judged.line.move
    cited = () if move is None else move.cited
    old = [c for line_cited in cited for c in line_cited.conditions]
    old += () if move is None else move.where
    kinds = ("=", "start", "large", "small")
    new = [c for c in judged.known.conditions if c not in old and c.relation not in kinds]
    new = [c for c in new if not (c.relation == "≥" and c.expression.is_nonnegative)]
    formulas = {text(piece) for piece in words if isinstance(piece, Node)}
    new = [c for c in new if text(relation(c, notation)) not in formulas]
    if not (new and words and isinstance(words[-1], str)):
        return words
    conditions = b.listed(((relation(c, notation),) for c in new), " and ")
    return (*words[:-1], words[-1].rstrip().rstrip(":"), ", where ", *conditions, ":")


def relation(condition: Condition, notation: Notation = NOTES) -> Node:
    """A condition as it is printed: sin θ ≠ 0."""
    sign = "=" if condition.relation == "start" else condition.relation
    beside = sympy.Integer(1 if sign == "≪" else 0)
    expression = notation.written(condition.expression)
    if sign in ("=", "≠") and text(expression).startswith("−"):
        expression = sympy.expand(-expression)
    return layout(Equation(expression, beside, relation=sign), "auto")


def running(
    words: Sequence[b.Piece],
    notation: Notation = NOTES,
    figures: Mapping[str, b.Figure] = MappingProxyType({}),
    axes: Collection[Any] = (),
) -> b.Rich:
    """Running text with its mathematics laid out; along `axes` something has its components."""
    pieces: list[Any] = []
    for piece in words:
        if isinstance(piece, str):
            pieces += _with_figures(piece, figures)
        else:
            unread = getattr(piece, "latex", None)
            pieces.append(
                Wording(notation)(f"${unread}$")
                if unread
                else layout((notation.axis if piece in axes else notation.named)(piece), "printed")
            )
    return tuple(pieces)


_NAMING = re.compile(r"^(?:Along the motion|At the moment),? |^(?:Call|Define) |, define ")


def called(line: Line, notation: Notation = NOTES) -> b.Rich:
    """What an equation is called: by its number, else by its name, else by its place."""
    tag = next((e.tag for e in line.equations if e.tag), "")
    if tag:
        return (f"({tag})",)
    if not line.called:
        return (f"line {line.at}",)
    name, *rest = running(line.words, notation)
    for k, piece in enumerate((name, *rest)):
        naming = _NAMING.search(piece) if isinstance(piece, str) else None
        if naming is not None:
            name, *rest = (naming.string[naming.end() :], *rest[k:])
            break
    if isinstance(name, str):
        name = name[:1].lower() + name[1:] if name.startswith(("The ", "A ")) else name
    words = (name, *rest)
    last = words[-1]
    return (*words[:-1], last.rstrip(": \n")) if isinstance(last, str) else words


def gap(judged: Judged, letters: Letters, notation: Notation = NOTES) -> str:
    """Why a line does not follow, with its place, and numbers against it where there are."""
    line, problem = judged.line, judged.problem
    by_itself = line.move is None or isinstance(problem, UnitsError)
    verdict = "" if by_itself else ", does not follow"
    return f"{line.file}, line {line.at}{verdict}: {reason(judged, letters, notation)}"


def reason(judged: Judged, letters: Letters, notation: Notation = NOTES) -> str:
    """Why a line does not follow, and numbers against it where there are."""
    line, problem = judged.line, judged.problem
    assert problem is not None

    def said(node: Any) -> str:
        formula = node if isinstance(node, Equation) else tree(node)
        try:
            return text(notation.written(formula))
        except TypeError:  # what has no layout is told all the same: a page has more lines
            return str(formula)

    why = problem.words(said)
    if line.move is None or line.move.verb == "call" or isinstance(problem, UnitsError):
        return why
    diagnosis = diagnose(line.equations, line.move.cited, letters)
    if diagnosis is None:
        return why
    if diagnosis.entailed:
        return f"{why}; it follows from what is cited, but not by this move"
    if not diagnosis.at:
        return why
    values = ", ".join(f"{said(x)} = {said(value)}" for x, value in diagnosis.at.items())
    sides = f"the left side is {said(diagnosis.left)}, the right side {said(diagnosis.right)}"
    return f"{why}; with what is cited, at {values}, {sides}"
