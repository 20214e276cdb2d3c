"""Sentences, equations and units as LaTeX, for the blocks of a document."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rigidtop.notation.characters import MATHS, SIGNS, SUPERSCRIPTS, escape
from rigidtop.proof.equation import Equation
from rigidtop.report import blocks as b
from rigidtop.terminal.visible import visible
from rigidtop.typeset import nodes as lay
from rigidtop.typeset import sizes, words
from rigidtop.typeset.latex import AlignRow, align, latex, row_lines, seen
from rigidtop.typeset.layout import layout


def prose(text: str) -> str:
    """A sentence as LaTeX; what nobody sees in it is shown by its number."""
    return words.prose(visible(text))


def in_words(node: lay.Node) -> str:
    """Mathematics in a sentence: fractions with a slash; what is long may be broken."""
    match node:
        case lay.Chain():
            signs = ["", *(f" {SIGNS[sign]} " for sign in node.signs)]
            sides = zip(signs, node.sides, strict=True)
            return "".join(sign + in_words(side) for sign, side in sides)
        case lay.Terms(terms=(lay.Signed(negative=True, body=body),)):
            return "-" + in_words(body)
        case lay.DifferentialQuotient(body=lay.Atom(), inside=True, order=1):
            d = r"\partial " if node.partial else "d"
            flat = f"{d}{latex(node.body)}/{d}{latex(node.by)}"
            return rf"({flat})_{{\text{{{escape(node.frame)}}}}}" if node.frame else flat
        case lay.Fraction(small=False):
            ends = [node.over.factors[-1] if isinstance(node.over, lay.Factors) else node.over]
            bare = any(isinstance(end, lay.FunctionOf) and not end.brackets for end in ends)
            over = lay.Brackets(node.over) if bare else lay.as_factor(node.over, False)
            single = isinstance(
                node.under, lay.Atom | lay.Digits | lay.Superscript | lay.Radical | lay.FunctionOf
            )
            under = node.under if single else lay.bracketed(node.under)
            return rf"{in_words(over)}/{latex(under)}"
    return latex(node).replace(")(", r")\allowbreak (")


def upright(unit: str) -> str:
    """The LaTeX of a unit, in upright letters."""
    return "".join(map(_unit_character, unit))


def _unit_character(c: str) -> str:
    if c in SUPERSCRIPTS:
        return f"$^{{{SUPERSCRIPTS[c]}}}$"
    return f"${MATHS[c]}$" if c in "−×″" else r"\," if c == " " else escape(c)


rich = b.Script(
    words=prose,
    formula=lambda node: f"${in_words(node)}$",
    unit=upright,
    cited=lambda place: rf"\rtcited{{{place.anchor}}}{{{prose(place.words)}}}",
    verdict=lambda verdict: rf"\verdict{{{verdict}}}",
)


def goes_on(block: b.Block, after: b.Block | None) -> bool:
    """Whether a paragraph goes on with the sentence of the step, or the equation, behind it."""
    if not (isinstance(block, b.Paragraph) and isinstance(after, b.Display)):
        return False
    reason = after.rows[0].reason
    if block.held:  # an equation in its midst
        return not reason
    return after.step and bool(reason) and not stands_alone(after)


def stands_alone(block: b.Display) -> bool:
    """Whether a step is a line of its own."""
    return fits_in_line(beside(block.rows, block.room), block.room)


def beside(rows: Sequence[b.DisplayRow], room: float) -> Sequence[b.DisplayRow]:
    """Short equations of one step side by side, in lines of as many as have room in each."""
    if any(row.tag or row.beside or row.reason for row in rows[1:]) or rows[0].tag:
        return rows
    widths = [sizes.width(layout(row.equation, row.order)) + 5 for row in rows]
    for k in range(len(rows), 1, -1):
        starts = range(0, len(rows), k)
        if len(rows) % k == 0 and all(sum(widths[i : i + k]) <= room + 5 for i in starts):
            return [_together(rows[i : i + k]) for i in starts]
    return rows


def _together(rows: Sequence[b.DisplayRow]) -> b.DisplayRow:
    mark = next((row.mark for row in reversed(rows) if row.mark is not None), None)
    anchor = next((row.anchor for row in reversed(rows) if row.anchor), "")
    return replace(rows[0], beside=tuple(r.equation for r in rows[1:]), mark=mark, anchor=anchor)


WORD = 0.9
"""The width of a letter of a sentence in letters of an equation."""


def fits_in_line(rows: Sequence[b.DisplayRow], room: float) -> bool:
    """Whether a step has one line with its sentence: it is short, and has no number."""
    row, *more = rows
    if more or row.tag or row.mark is not None or not row.reason:
        return False
    width = sum(sizes.width(layout(each, row.order)) + 3 for each in abreast(row))
    # Neither its indent nor the place of a number is needed.
    return WORD * len(seen(rich(row.spoken))) + width <= 1.1 * room


def shown(block: b.Display) -> str:
    """A display; a short step in one line with its sentence."""
    label = rf"\lab{{{prose(block.label)}}}" if block.label else ""
    rows = beside(block.rows, block.room) if block.step else block.rows
    if not (block.step and fits_in_line(rows, block.room)):
        return label + "\n" * bool(label) + display(rows, block.room)
    equations = r" \qquad ".join(latex(each, rows[0].order) for each in abreast(rows[0]))
    return rf"\rtstep{{{label}{rich(rows[0].spoken)}}}{{{equations}}}"


def abreast(row: b.DisplayRow) -> Sequence[Equation]:
    """All equations that stand side by side in one line."""
    return row.equation, *row.beside


def display(rows: Sequence[b.DisplayRow], room: float = sizes.LINE) -> str:
    """The rows in ``align``, smaller where a line is too wide for the page."""
    together = sharing(rows, room)
    # Side notes go out from the sentence: inside the display there is no place for them.
    notes = "".join(_note(row.mark) for row in rows)
    together[0][0] = replace(together[0][0], reason=together[0][0].reason + notes)
    body = "\n".join(_sized(rows, room) for rows in together)
    # Behind a side note LaTeX would allow the page to end.
    return rf"{{\interlinepenalty10000 {body}\par}}" if notes else body


def sharing(rows: Sequence[b.DisplayRow], room: float) -> list[list[AlignRow]]:
    """Rows share their = sign as long as that does not make them too wide together."""
    together: list[list[AlignRow]] = []
    for row in rows:
        lines = aligned(row, room)
        if together and not is_wide([*together[-1], lines], room):
            together[-1].append(lines)
        else:
            together.append([lines])
    return together


def is_wide(rows: Sequence[AlignRow], room: float) -> bool:
    """Whether rows that share their = sign do not fit in their usual size."""
    lines = [line for row in rows for line in row.lines]
    left = max(sizes.width(line.left) if line.left else 0 for line in lines)
    return left + 3 + max(sizes.width(line.right) for line in lines) > WIDE * room


WIDE = 1.04
"""A line that is wider than this, in its room, does not fit in its usual size."""


def _sized(rows: Sequence[AlignRow], room: float) -> str:
    if not is_wide(rows, room):
        return align(rows, room)
    (row,) = rows
    inside = r" \\ ".join(row_lines(hung(row)))
    place = rf"\phantomsection\label{{{row.label}}}" if row.label else ""
    behind = (f"({row.tag})" if row.tag else "") + row.behind
    return (
        rf"{row.reason}\rtfit{{{place}}}{{$\begin{{aligned}}{inside}\end{{aligned}}$}}{{{behind}}}"
    )


def hung(row: AlignRow) -> AlignRow:
    """A row with its left side in a line of its own, where that makes it less wide."""
    first, *rest = row.lines
    if first.left is None or sizes.width(first.left) < HUNG:
        return row
    left = sizes.DisplayLine(None, "", first.left)
    return replace(row, lines=(left, replace(first, left=None), *rest), hung=True)


HUNG = 6.0
"""A left side that is shorter than this gives no room where it stands alone."""


def aligned(row: b.DisplayRow, room: float) -> AlignRow:
    mark = f"({row.verdict})" if row.verdict is not None else ""
    lines = tuple(sizes.lines(row.equation, row.order, room))
    if row.beside:
        every = [layout(each, row.order) for each in abreast(row)]
        first, *more = every
        assert isinstance(first, lay.Chain)
        (line,) = sizes.lines(first, row.order, 10 * room)
        lines = (replace(line, right=lay.Enumeration((line.right, *more), "")),)
    seal = rf"\rtseal{{{row.mark.verdict}}}" if row.mark is not None else ""
    label = row.anchor if seal or row.tag else ""
    return AlignRow(lines, row.tag, rich(row.spoken), mark, seal, label)


def _note(mark: b.MarginMark | None) -> str:
    return rf"\rtnote{{{rich(mark.note)}}}" if mark is not None and mark.note else ""
