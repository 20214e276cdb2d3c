"""The lecture as a Typst document; formulas come through `tylax` from our LaTeX (extra ``pdf``)."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import singledispatch
from typing import Any

from rigidtop.present import layout as lay
from rigidtop.present.formula import tex
from rigidtop.present.latex import align_row, latex
from rigidtop.present.prose import written
from rigidtop.present.report import (
    ClaimHead,
    Condition,
    Conditions,
    DataTable,
    Display,
    Document,
    ExerciseHead,
    Figure,
    FoundList,
    Heading,
    Measures,
    Numbers,
    Paragraph,
    Quantities,
    Rich,
    Row,
    Subhead,
    Summary,
    Symbols,
    groups,
)

_PREAMBLE = """#set document(
  title: @TITLE@, author: @AUTHOR@, description: @SUBJECT@, keywords: (@KEYWORDS@), date: none,
)
#set page(paper: "a4", margin: (x: 28mm, top: 26mm, bottom: 28mm), numbering: "1")
#set text(font: "Libertinus Serif", size: 10.5pt, lang: "en")
#set par(justify: true, leading: 0.62em, spacing: 0.8em)
#set math.equation(number-align: end + bottom)
#show math.equation.where(block: true): set align(left)
#show math.equation.where(block: true): set block(inset: (left: 2em), above: 0.7em, below: 0.7em)
#show math.equation.where(block: true): set block(breakable: false)
#show heading.where(level: 1): it => block(above: 2em, below: 0.9em, text(size: 15pt, it.body))
#show heading.where(level: 2): it => block(above: 1.7em, below: 0.8em, text(size: 12.5pt, it.body))
#show heading.where(level: 3): it => strong(text(size: 10.5pt, it.body))
#show outline.entry.where(level: 1): it => block(above: 0.9em, strong(it))
#show outline.entry: set block(above: 0.5em)
#let muted = rgb("#555555")
#let colors = (
  proved: rgb("#1e5b3a"), sampled: rgb("#3e5f2b"), assuming: rgb("#7a4b00"),
  convention: rgb("#5b2d83"), "false": rgb("#8e1b1b"), definition: rgb("#2b4c7e"),
  undecided: rgb("#444444"),
)
#let verdict(name) = box(
  stroke: 0.6pt + colors.at(name), inset: (x: 3pt, y: 0pt), outset: (y: 2.5pt), radius: 1.5pt,
  text(font: "Libertinus Serif", fill: colors.at(name), size: 8.5pt, smallcaps(name)),
)
#let lab(words) = text(fill: muted, size: 9pt, smallcaps(words)) + h(0.5em)
#let claim(name, anchor, says, state) = {
  block(above: 1.6em, below: 0.6em, sticky: true, {
    line(length: 100%, stroke: 0.4pt + muted)
    v(-0.35em)
    [#grid(columns: (1fr, auto), strong(name), verdict(state)) #label(anchor)]
  })
  block(sticky: true, above: 0.6em, emph(says))
}
#let exercise(title, anchor, asks) = {
  block(above: 1.9em, below: 0.7em, sticky: true, {
    line(length: 100%, stroke: 1.2pt + muted)
    v(-0.35em)
    let head = [#heading(level: 3)[Exercise: #title] #label(anchor)]
    let remark = text(fill: muted, size: 9.5pt, asks)
    layout(room => {  // beneath the heading where it has no room beside it
      let needed = measure(strong[Exercise: #title]).width + measure(remark).width + 20pt
      if needed > room.width { stack(spacing: 0.6em, head, remark) }
      else { grid(columns: (1fr, auto), head, remark) }
    })
  })
}
#let subhead(words) = block(above: 1.2em, below: 0.7em, sticky: true, strong(text(9.5pt, words)))
#let side(tag, state) = {
  if state != "" { verdict(state) }
  if tag != "" { h(0.6em) + "(" + tag + ")" }
}
#let eq(tag, state, body) = math.equation(
  block: true, numbering: if tag + state == "" { none } else { _ => side(tag, state) }, body,
)
#let why(body) = block(sticky: true, text(size: 9.5pt, fill: muted, body))
#let title(body) = block(sticky: true, below: 0.4em, text(size: 9.5pt, fill: muted, body))
#let head(words) = block(sticky: true, above: 0.9em, below: 0.5em, lab(words))
"""


def write(document: Document, figures: Mapping[str, str]) -> str:
    """The document.  `figures` says where the file of each figure lies, as seen from it."""
    body = "\n\n".join(
        _figure(block, figures[block.name]) if isinstance(block, Figure) else typst_block(block)
        for block in document.blocks
    )
    return "\n".join(
        [
            _preamble(document),
            f'#text(size: 17pt, weight: "bold")[{prose(document.title)}]',
            f"#v(-0.4em)\n#text(size: 12pt, fill: muted)[{prose(document.subtitle)}]\n",
            f"#text(size: 9pt, fill: muted)[{prose(document.colophon)}]",
            "#text(size: 9.5pt)[#outline(title: [Contents], depth: 3)]",
            body,
            "",
        ]
    )


def _preamble(document: Document) -> str:
    about = {
        "@TITLE@": _quoted(document.title),
        "@AUTHOR@": _quoted(document.author),
        "@SUBJECT@": _quoted(document.subtitle),
        "@KEYWORDS@": "".join(f"{_quoted(words)}, " for words in document.keywords),
    }
    made = _PREAMBLE
    for place, words in about.items():
        made = made.replace(place, words)
    return made


def fragment(blocks: Sequence[Any]) -> str:
    """The blocks of one claim, with the functions that they use."""
    functions = _PREAMBLE[_PREAMBLE.index("#let muted") :]
    return functions + "\n" + "\n\n".join(map(typst_block, blocks)) + "\n"


def _figure(block: Figure, path: str) -> str:
    alternative = block.alternative.replace('"', "'")
    return (
        f'#figure(image("{path}", alt: "{alternative}"), placement: top, numbering: none, '
        f"caption: [{prose(block.caption)}])"
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
    """English with Unicode mathematics in it."""
    return written(text, lambda part, vectors: f"${maths(tex(part, vectors))}$", plain)


def maths(tex: str) -> str:
    """A LaTeX formula as Typst mathematics, without the dollars."""
    from tylax import latex_to_typst

    made = latex_to_typst(f"${tex}$").strip().strip("$").strip()
    made = re.sub(r"#text\[([^\]]*)\]", lambda m: f'"{_words(m[1])}"', made)
    made = re.sub(r"_\(([^()]*)\)('+)", r"\2_(\1)", made)  # else the prime goes to the index
    return re.sub(r"(\d+)/(\d+)", r"inline(\1/\2)", made)  # only a \tfrac becomes a plain a/b


def _words(text: str) -> str:
    """Words of a formula, in which Typst makes no dashes."""
    return text.replace("\\", "").replace("---", "—").replace("--", "–")


def rich(content: Rich) -> str:
    """Running text with formulas."""
    return "".join(
        prose(piece) if isinstance(piece, str) else f"${maths(latex(piece))}$" for piece in content
    )


# --- Blocks --------------------------------------------------------------------------------------


@singledispatch
def typst_block(block: Any) -> str:
    """A block as Typst."""
    raise TypeError(f"no Typst for {type(block).__name__}")


@typst_block.register
def _(block: Heading) -> str:
    number = plain(block.number) + "#h(0.7em)" if block.number else ""
    return f"{'=' * block.level} {number}{prose(block.title)} <{block.anchor}>"


@typst_block.register
def _(block: Paragraph) -> str:
    words = rich(block.content)
    # A labelled paragraph, the reason, is not parted from what it is the reason for.
    held = block.label or block.held
    return f"#block(sticky: true)[{_label(block.label)}{words}]" if held else words


def _head(words: str) -> str:
    return f"#head[{prose(words)}]"


def _label(words: str) -> str:
    return f"#lab[{prose(words)}]" if words else ""


@typst_block.register
def _(block: ClaimHead) -> str:
    shown, says = prose(block.shown), prose(block.says)
    return f'#claim([{shown}], "{block.anchor}", [{says}], "{block.verdict}")'


@typst_block.register
def _(block: Display) -> str:
    label = _head(block.label) + "\n\n" if block.label else ""
    return label + "\n\n".join(_rows(group) for group in groups(block))


def _rows(group: Sequence[Row]) -> str:
    last = group[-1]
    reason = rich(group[0].spoken)
    rows = [align_row(line) for row in group for line in lay.lines(row.equation, row.order)]
    body = maths(r" \\ ".join(rows))
    shown = f'#eq("{last.tag}", "{last.verdict or ""}", $ {body} $)'
    return f"#why[{reason}]\n{shown}" if reason else shown


@typst_block.register
def _(block: Conditions) -> str:
    items = "\n".join(f"- {_condition(item)}" for item in block.items)
    return f"{_head('Assumptions')}\n{items}"


def _condition(item: Condition) -> str:
    words = f", {prose(item.words)}" if item.words else ""
    stated = "stated" if item.stated else "*not stated*"
    return f"${maths(latex(item.relation))}${words} ({stated}). {typst_block(item.without)}"


@typst_block.register
def _(block: Numbers) -> str:
    values = ", ".join(f"${maths(f'{latex(n)} = {latex(v)}')}$" for n, v in block.values)
    sides = block.said(lambda node: f"${maths(latex(node))}$")
    return f"{_label(block.label)}{sides}" + (f" at {values}." if values else ".")


WHOLE = 14
"""A table of no more rows stays on one page."""


def _table(columns: str, head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    cells = "\n".join("  " + ", ".join(f"[{cell}]" for cell in row) + "," for row in rows)
    heads = ", ".join(f"text(fill: muted)[{words}]" for words in head)
    header = f"table.header({heads}), table.hline(stroke: 0.4pt)," if head else ""
    breakable = "true" if len(rows) > WHOLE else "false"
    return (
        f"#block(breakable: {breakable}, text(size: 9.5pt)[#set par(justify: false)\n"
        f"#table(columns: {columns}, stroke: none, inset: (x: 5pt, y: 3.5pt),\n"
        f"  table.hline(stroke: 0.8pt), {header}\n"
        f"{cells}\n  table.hline(stroke: 0.8pt))])"
    )


@typst_block.register
def _(block: Measures) -> str:
    rows = [(prose(r.what), _power(r.error), _power(r.tolerance)) for r in block.rows]
    head = (prose(block.compared), "error", "tolerance")
    return _head(block.label) + "\n" + _table("(1fr, auto, auto)", head, rows)


def _power(number: float) -> str:
    return f"${maths(latex(lay.decimal(number, 2)))}$"


@typst_block.register
def _(block: Summary) -> str:
    rows = [(f'#verdict("{v}")', str(count), prose(meaning)) for v, count, meaning in block.rows]
    rows.append(("all", str(sum(count for _, count, _ in block.rows)), ""))
    return _table("(auto, auto, 1fr)", ("verdict", "claims", "what it says"), rows)


@typst_block.register
def _(block: FoundList) -> str:
    rows = [
        (
            prose(row.section),
            f'#link(label("{row.anchor}"))[{plain(row.name)}]',
            f'#verdict("{row.verdict}")',
            rich(row.content),
        )
        for row in block.rows
    ]
    head = ("section", "claim", "verdict", "what is amiss")
    return _table("(auto, 7.5em, auto, 1fr)", head, rows)


@typst_block.register
def _(block: Symbols) -> str:
    rows = [
        (f"${maths(latex(node))}$", prose(meaning), plain(unit))
        for node, meaning, unit in block.rows
    ]
    return _table("(auto, 1fr, auto)", ("symbol", "meaning", "unit"), rows)


@typst_block.register
def _(block: ExerciseHead) -> str:
    return f'#exercise([{prose(block.title)}], "{block.anchor}", [{prose(block.asks)}])'


@typst_block.register
def _(block: Subhead) -> str:
    return f"#subhead[{prose(block.words)}]"


@typst_block.register
def _(block: Quantities) -> str:
    rows = [
        (prose(what), f"#align(right)[{_cell(value)}]", plain("" if unit == "1" else unit))
        for what, value, unit in block.rows
    ]
    return _head(block.label) + "\n" + _table("(1fr, auto, auto)", (), rows)


@typst_block.register
def _(block: DataTable) -> str:
    rows = [(_cell(row[0]), *(f"#align(right)[{_cell(x)}]" for x in row[1:])) for row in block.rows]
    columns = ", ".join(["auto"] * len(block.columns))
    head = [prose(words) for words in block.columns]
    title = f"#title[{prose(block.title)}]"
    return title + "\n" + _table(f"({columns},)", head, rows)


def _cell(value: str | lay.Node) -> str:
    return prose(value) if isinstance(value, str) else f"${maths(latex(value))}$"
