"""The lecture as a Typst document; formulas come through `tylax` from our LaTeX (extra ``pdf``)."""

from __future__ import annotations

import re
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import singledispatch
from importlib.resources import files

from rigidtop.proof.equation import Equation
from rigidtop.report import blocks as b
from rigidtop.report.pdf import written_at
from rigidtop.report.tex_lines import (
    abreast,
    beside,
    fits_in_line,
    goes_on,
    hung,
    in_words,
    is_wide,
    sharing,
)
from rigidtop.terminal.visible import visible
from rigidtop.typeset import nodes as lay
from rigidtop.typeset.latex import AlignRow, aligned_lines, latex, row_lines, seen
from rigidtop.typeset.words import tex, tied, unmarked, written


def write(document: b.Document, figures: Mapping[str, str]) -> str:
    """The document.  `figures` says where the file of each figure lies, as seen from it."""
    body = "\n\n".join(_joined(document.blocks, figures))
    depth = 2 if document.lecture else 3
    contents = f"#text(size: 9.5pt)[#outline(title: [Contents], depth: {depth})]"
    source = f"#text(size: 9pt, fill: muted)[{prose(document.colophon)}]"
    document_text = "\n".join(
        [
            _preamble(document),
            f'#text(size: 17pt, weight: "bold")[{prose(document.title)}]',
            f"#v(-0.4em)\n#text(size: 12pt, fill: muted)[{prose(document.subtitle)}]\n",
            *([prose(document.byline) + "\n"] if document.byline else []),
            *([source, contents, body] if document.contents else [body, source]),
            "",
        ]
    )
    return visible(document_text)


def _joined(blocks: Sequence[b.Block], figures: Mapping[str, str]) -> Iterator[str]:
    """The blocks; a sentence in front of an equation goes on the paragraph above it."""
    words = ends = ""
    above: b.Block | None = None
    for block, after in zip(blocks, [*blocks[1:], None], strict=True):
        if not ends and isinstance(block, b.SectionHead) and block.anchor in b.IN_COLUMNS:
            yield "#solutions["
            ends = "]"
        if isinstance(block, b.Paragraph) and goes_on(block, after):
            words = _said(block)
            continue
        if isinstance(block, b.Figure):
            part = _figure(block, figures[block.name], floats=not isinstance(above, b.SectionHead))
        else:
            part = _display(block, words) if isinstance(block, b.Display) else typst_block(block)
        # The place where a figure is told, at the end of the words above it.
        yield part + (f'#told("{after.anchor}")' if isinstance(after, b.Figure) else "")
        words, above = "", block
    yield ends


def _preamble(document: b.Document) -> str:
    about = {
        "@TITLE@": _quoted(unmarked(document.title)),
        "@AUTHOR@": _quoted(unmarked(document.author)),
        "@SUBJECT@": _quoted(unmarked(document.subtitle)),
        "@KEYWORDS@": "".join(f"{_quoted(unmarked(words))}, " for words in document.keywords),
    }
    about["@DATE@"] = time.strftime("year: %Y, month: %m, day: %d", time.gmtime(written_at()))
    about["@PAPER@"] = {"a4": "a4", "letter": "us-letter"}[document.look.paper]
    about["@RIGHT@"] = "51mm" if document.lecture else "28mm"
    preamble = _style()
    for place, words in about.items():
        preamble = preamble.replace(place, words)
    return preamble


def _style() -> str:
    """The Typst with which every document begins."""
    style = files("rigidtop.report").joinpath("styles", "document.typ").read_text("utf-8")
    colors = (f'"{verdict}": rgb("#{light}")' for verdict, (light, _) in b.COLORS.items())
    return style.replace("@COLORS@", ", ".join(colors))


def fragment(blocks: Sequence[b.Block]) -> str:
    """The blocks of one claim, with the functions that they use."""
    style = _style()
    functions = style[style.index("#let muted") :]
    return visible(functions + "\n" + "\n\n".join(map(typst_block, blocks)) + "\n")


def _figure(block: b.Figure, path: str, *, floats: bool) -> str:
    """A figure; what does not float stays beneath its heading."""
    alternative = block.alternative.replace('"', "'")
    return (
        f'#shown("{block.anchor}", image("{path}", alt: "{alternative}"), '
        f"[*{block.label}.* {prose(block.caption)}], {'true' if floats else 'false'})"
    )


# --- Text and formulas ---------------------------------------------------------------------------


def plain(text: str) -> str:
    """Text as a Typst string, in which nothing has to be escaped but quotes and backslashes.

    >>> print(plain('a #b "c"'))
    #"a #b \\"c\\"";
    """
    return f"#{_quoted(text)};"


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("'", "’") + '"'


def prose(text: str) -> str:
    """A sentence with mathematics between dollars."""
    return written(tied(text), lambda part: _inline(tex(part)), plain)


def _inline(tex: str) -> str:
    """A formula of a sentence; where it is short no line ends in it."""
    formula = f"${maths(tex)}$"
    return f"#box({formula})" if len(seen(tex)) <= WHOLE_IN_TEXT else formula


WHOLE_IN_TEXT = 16
"""Letters of a formula that is not broken in a sentence."""


def maths(tex: str) -> str:
    """A LaTeX formula as Typst mathematics, without the dollars."""
    from tylax import latex_to_typst

    # What follows a fraction of single letters would be set close to it: 1/nux.
    apart = re.sub(r"(\{(?:\\[A-Za-z]+|\w+)\})(?=[\w\\])", r"\1 ", tex)
    typst = latex_to_typst(f"${apart}$").strip().strip("$").strip()
    typst = re.sub(r"#text\[([^\]]*)\]", lambda m: f'"{_words(m[1])}"', typst)
    typst = re.sub(r"_\(([^()]*)\)('+)", r"\2_(\1)", typst)  # else the prime goes to the index
    return re.sub(r'"[^"]*"|(\w+)/ ?(\w+)', _fraction, typst)


def _fraction(match: re.Match[str]) -> str:
    r"""A plain a/b, which a fraction becomes that has one letter or number above and one below.

    >>> maths(r"\tfrac{1}{12}M + \frac{1}{\nu}\,x + \text{rad/s}")
    'inline(1/12) M + frac(1, nu) thin x + "rad/s"'
    """
    over, under = match.groups()
    if over is None:  # in words
        return match[0]
    whole = over.isdigit() and under.isdigit()
    return f"inline({over}/{under})" if whole else f"frac({over}, {under})"


def _words(text: str) -> str:
    """Words of a formula, in which Typst makes no dashes."""
    return text.replace("\\", "").replace("---", "—").replace("--", "–")


rich = b.Script(
    words=prose,
    formula=lambda node: _inline(in_words(lay.flat(node))),
    unit=plain,
    cited=lambda place: f'#link(label("{place.anchor}"))[{plain(place.words)}]',
    verdict=lambda verdict: f'#verdict("{verdict}")',
)


def _note(mark: b.MarginMark | None) -> str:
    return f"#note[{rich(mark.note)}]" if mark is not None and mark.note else ""


# --- Blocks --------------------------------------------------------------------------------------


@singledispatch
def typst_block(block: b.Block) -> str:
    """A block of a document, as Typst."""
    raise TypeError(f"no Typst for {type(block).__name__}")


@typst_block.register
def _(block: b.SectionHead) -> str:
    number = plain(block.number) + "#h(0.7em)" if block.number else ""
    return f"{'=' * block.level} {number}{prose(block.title)} <{block.anchor}>"


@typst_block.register
def _(block: b.Paragraph) -> str:
    words = _said(block)
    # A labelled paragraph, the reason, is not parted from what it is the reason for.
    return f"#held[{words}]" if block.label or block.held else words


def _said(block: b.Paragraph) -> str:
    words = rich(block.content)
    if block.mark is not None:
        seal = f'#seal("{block.mark.verdict}"){_note(block.mark)}'
        place = f' #label("{block.anchor}")' if block.anchor else ""
        words = f"{seal}{words}{place}"
    return _label(block.label) + words


def _head(words: str) -> str:
    return f"#head[{prose(words)}]"


def _label(words: str) -> str:
    return f"#lab[{prose(words)}]" if words else ""


@typst_block.register
def _(block: b.ClaimHead) -> str:
    name, says = prose(block.shown), prose(block.says)
    return f'#claim([{name}], "{block.anchor}", [{says}], "{block.verdict}")'


@typst_block.register
def _(block: b.Display) -> str:
    return _display(block)


def _display(block: b.Display, before: str = "") -> str:
    """The equations behind their sentences, the first of which goes on what is said `before`."""
    rows = beside(block.rows, block.room) if block.step else block.rows
    label = _label(block.label)
    if block.step and fits_in_line(rows, block.room):
        (row,) = rows
        body = "#h(2em)".join(
            f"#box($display({maths(latex(each, row.order))})$)" for each in abreast(row)
        )
        return f"#step[{label}{rich(row.spoken)}][{body}]{_place(row)}"
    pieces: list[str] = []
    for group in b.groups(replace(block, rows=tuple(rows))):
        notes = "".join(_note(row.mark) for row in group)
        words = " ".join(filter(None, [before, label + notes + rich(group[0].spoken)]))
        pieces += [f"#held[{words}]"] if words else []
        left = iter(group)
        for lines in sharing(group, block.room):
            pieces.append(_rows([next(left) for _ in lines], lines, block.room))
        before = label = ""
    return "\n".join(pieces)


def _rows(rows: Sequence[b.DisplayRow], lines: Sequence[AlignRow], room: float) -> str:
    """Rows that share their = sign."""
    if is_wide(lines, room):
        lines = [*map(hung, lines)]
    body = maths(r" \\ ".join(line for each in lines for line in row_lines(each)))
    mark = next((f', mark: "{row.mark.verdict}"' for row in rows if row.mark is not None), "")
    row = next((row for row in rows if row.anchor), rows[-1])
    tag, verdict = rows[-1].tag, rows[-1].verdict or ""
    return f'#eq("{tag}", "{verdict}", $ {body} ${mark}){_place(row)}'


def _place(row: b.DisplayRow) -> str:
    return f' #label("{row.anchor}")' if row.anchor else ""


@typst_block.register
def _(block: b.Items) -> str:
    items = "\n".join(f"- {rich(item)}" for item in block.items)
    return f"{_head(block.label)}\n{items}"


WHOLE = 14
"""A table of no more rows stays on one page."""


def _table(columns: str, head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    cells = "\n".join("  " + ", ".join(f"[{cell}]" for cell in row) + "," for row in rows)
    heads = ", ".join(f"text(fill: muted)[{words}]" for words in head)
    header = f"table.header({heads}), table.hline(stroke: 0.4pt)," if head else ""
    breakable = "true" if len(rows) > WHOLE else "false"
    return (
        f"#block(breakable: {breakable}, text(size: 0.9em)[#set par(justify: false)\n"
        f"#table(columns: {columns}, stroke: none, inset: (x: 5pt, y: 3.5pt),\n"
        f"  table.hline(stroke: 0.8pt), {header}\n"
        f"{cells}\n  table.hline(stroke: 0.8pt))])"
    )


@typst_block.register
def _(block: b.TableBlock) -> str:
    rows = [
        [f"#align(right)[{rich(x)}]" if k in block.right else rich(x) for k, x in enumerate(row)]
        for row in block.cells
    ]
    widths = block.widths or (0,) * len(block.head)
    columns = ", ".join(f"{width:g}fr" if width else "auto" for width in widths)
    listed = block.kind == "values"
    body = _table(f"({columns},)", () if listed else [*map(prose, block.head)], rows)
    if block.title:
        body = f"{_head(block.title) if listed else f'#title[{prose(block.title)}]'}\n{body}"
    return f"#over[{body}]" if len(block.head) > NARROW else body


NARROW = 5
"""Columns of a table that has room in one of two columns of a page."""


@typst_block.register
def _(block: b.ExerciseHead) -> str:
    title, asks, points = map(prose, (block.title, block.asks, block.points))
    return f'#asked([{block.label}. {title}], "{block.anchor}", [{asks}], [{points}])'


@typst_block.register
def _(block: b.Subhead) -> str:
    return f"#subhead[{prose(block.words)}]"


@typst_block.register
def _(block: b.Aside) -> str:
    return f"#boxed[{prose(block.title)}]["


@typst_block.register
def _(_: b.AsideEnd) -> str:
    return "]"


@typst_block.register
def _(block: b.Legend) -> str:
    items = " ".join(f'#sign("{verdict}") {prose(words)}.' for verdict, words in block.rows)
    return f"#text(size: 9pt, fill: muted)[{plain(block.head)}: {items}]"


@typst_block.register
def _(block: b.NameLine) -> str:
    columns = ", ".join(
        f"[{prose(word)}: #box(width: 1fr, line(length: 100%))]" for word in block.words
    )
    return f"#grid(columns: {len(block.words)}, column-gutter: 2em, {columns})"


@typst_block.register
def _(_: b.Room) -> str:
    return "#v(45mm)"


@typst_block.register
def _(block: b.Results) -> str:
    rows = [
        (
            f'#link(label("{b.anchor(number)}"))[{plain(f"({number})")}]',
            "".join(f'#eq("", "", $ {_in_lines(each)} $)' for each in equations),
            rich(words),
        )
        for number, equations, words, _ in block.rows
    ]
    return f"#results[{_table('(auto, 1fr, 43mm)', block.head, rows)}]"


ROOM = 48.0
"""Letters of a line in the summary of results."""


def _in_lines(equation: Equation) -> str:
    return maths(r" \\ ".join(aligned_lines([equation], "printed", ROOM)))
