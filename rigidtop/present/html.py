"""The lecture as one HTML file that needs no network: MathML, inline figures, inline style."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import singledispatch
from html import escape
from typing import Any

from rigidtop.present import layout as lay
from rigidtop.present import mathml
from rigidtop.present.prose import prose_html
from rigidtop.present.report import (
    MARKS,
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
from rigidtop.proof.verdict import Verdict

NARROW = 36.0
"""How many letters wide a line is on a small screen."""

STYLE = """
:root {
  --ink: #1b1b1b; --paper: #fdfdfb; --muted: #595959; --rule: #cfcbc2; --link: #1f4f8a;
  --proved: #1e5b3a; --sampled: #3e5f2b; --assuming: #7a4b00; --convention: #5b2d83;
  --false: #8e1b1b; --definition: #2b4c7e; --undecided: #444;
  --serif: "STIX Two Text", "Libertinus Serif", "Latin Modern Roman", "Palatino Linotype",
    Palatino, "Book Antiqua", Cambria, Georgia, serif;
  --maths: "STIX Two Math", "Libertinus Math", "Latin Modern Math", "Cambria Math", math;
}
@media (prefers-color-scheme: dark) {
  :root {
    --ink: #e4e1da; --paper: #17181a; --muted: #a5a29a; --rule: #45464a; --link: #9dc1ef;
    --proved: #86cfa5; --sampled: #b0cf8f; --assuming: #e6b865; --convention: #cba6ee;
    --false: #f29b9b; --definition: #9cbcf0; --undecided: #bbb;
  }
}
* { box-sizing: border-box; }
html { scroll-padding-top: 1rem; }
body {
  margin: 0; background: var(--paper); color: var(--ink);
  font: 1.0625rem/1.55 var(--serif); text-rendering: optimizeLegibility;
}
math { font-family: var(--maths); font-size: 1.06em; }
a { color: var(--link); text-underline-offset: 0.15em; }
:focus-visible { outline: 2px solid var(--link); outline-offset: 2px; }
.skip { position: absolute; left: -99rem; }
.skip:focus { left: 1rem; top: 1rem; background: var(--paper); padding: 0.5rem 1rem; z-index: 2; }
.page { max-width: 46rem; margin: 0 auto; padding: 2.5rem 1.25rem 4rem; }
.toc { font-size: 0.93rem; line-height: 1.4; }
.toc summary { cursor: pointer; font-weight: bold; }
.toc ul { list-style: none; margin: 0.4rem 0 0; padding: 0; }
.toc li { margin: 0.25rem 0; padding-left: 2.9rem; text-indent: -2.9rem; }
.toc .deep { margin-left: 0.9rem; }
.toc .ask { font-size: 0.93em; }
.toc .n { display: inline-block; width: 2.9rem; text-indent: 0; color: var(--muted); }
.toc a { color: inherit; text-decoration: none; }
.toc a:hover { text-decoration: underline; }
@media (min-width: 78rem) {
  body { display: grid; grid-template-columns: 17rem minmax(0, 46rem) 1fr; column-gap: 3.5rem; }
  .page { margin: 0; }
  .toc { position: sticky; top: 0; max-height: 100vh; overflow-y: auto;
  padding: 3rem 0 2rem 2rem; }
}
@media (max-width: 77.99rem) { .toc { max-width: 46rem; margin: 0 auto;
  padding: 1.5rem 1.25rem 0; } }
h1 { font-size: 1.95rem; line-height: 1.2; font-weight: 600; margin: 0 0 0.4rem;
  text-wrap: balance; }
h2 { font-size: 1.42rem; line-height: 1.25; font-weight: 600; margin: 3.2rem 0 0.6rem; }
h3 { font-size: 1.2rem; line-height: 1.3; font-weight: 600; margin: 2.6rem 0 0.5rem; }
h2 .n, h3 .n { color: var(--muted); font-weight: 400; margin-right: 0.6em; }
p { margin: 0.55rem 0; }
.subtitle { font-size: 1.12rem; color: var(--muted); margin-top: 0; }
.colophon { font-size: 0.9rem; color: var(--muted); border-top: 1px solid var(--rule);
  margin-top: 3rem; padding-top: 1rem; }
.claim { border-top: 1px solid var(--rule); margin-top: 2.2rem; padding-top: 0.8rem; }
.head { display: flex; flex-wrap: wrap; justify-content: space-between; align-items: baseline;
  gap: 0.1rem 1rem; }
.head h4 { font-size: 1.04rem; font-weight: 600; margin: 0; }
.exercise { border-top: 3px solid var(--rule); margin-top: 2.6rem; padding-top: 0.8rem; }
.asks { color: var(--muted); font-size: 0.93rem; }
h5 { font-size: 1rem; font-weight: 600; margin: 1.6rem 0 0.3rem; }
.unseen { position: absolute; left: -99rem; }
.says { font-style: italic; margin: 0.25rem 0 0.7rem; }
.m { white-space: nowrap; }
sub, sup { font-size: 0.72em; line-height: 0; }
.badge {
  display: inline-block; white-space: nowrap; font-size: 0.78rem; line-height: 1.3;
  letter-spacing: 0.04em; border: 1px solid currentColor; border-radius: 0.2rem;
  padding: 0.05rem 0.45rem;
}
.badge.false, .badge.convention { border-width: 2px; font-weight: 600; }
.badge.assuming { border-style: dashed; }
.badge.undecided { border-style: dotted; }
.proved { color: var(--proved); } .sampled { color: var(--sampled); }
.assuming { color: var(--assuming); } .convention { color: var(--convention); }
.false { color: var(--false); } .definition { color: var(--definition); }
.undecided { color: var(--undecided); }
.label { font-variant-caps: all-small-caps; letter-spacing: 0.04em; color: var(--muted);
  margin: 0.9rem 0 0.15rem; }
p .label { margin-right: 0.5em; }
.row { display: grid; grid-template-columns: minmax(0, 1fr) auto; column-gap: 1rem;
  align-items: center; margin: 0.3rem 0; }
.eq { overflow-x: auto; overflow-y: hidden; padding: 0.15rem 0 0.3rem 1.6rem; }
.eq math { display: inline math; math-style: normal; }
.tag { font-variant-numeric: tabular-nums; }
.why { grid-column: 1 / -1; margin: 0.5rem 0 0; font-size: 0.95rem;
  color: var(--muted); }
.eq .narrow { display: none; }
@media (max-width: 40rem) {
  .eq .wide { display: none; } .eq .narrow { display: inline math; }
  .page { padding: 1.5rem 0.9rem 3rem; } .eq { padding-left: 0.4rem; } .why {
  margin-left: 0.4rem; }
  h1 { font-size: 1.6rem; }
  .found thead { position: absolute; left: -99rem; }
  .found tr { display: block; border-bottom: 1px solid var(--rule); padding: 0.5rem 0; }
  .found td, .found th { display: inline; border: 0 !important; padding: 0 0.6rem 0 0; }
  .found td:last-child { display: block; padding-top: 0.25rem; }
}
ul.conditions { margin: 0.2rem 0 0.6rem; padding-left: 1.3rem; }
ul.conditions li { margin: 0.3rem 0; }
.stated { color: var(--muted); } .unstated { font-weight: 600; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; margin: 0.8rem 0; font-size: 0.95rem;
  line-height: 1.4; }
th, td { text-align: left; vertical-align: top; padding: 0.35rem 0.9rem 0.35rem 0; }
thead th { font-weight: 400; color: var(--muted); border-top: 1.5px solid var(--ink);
  border-bottom: 1px solid var(--rule); }
tbody tr:last-child > * { border-bottom: 1.5px solid var(--ink); }
tbody th { font-weight: 400; }
caption { text-align: left; color: var(--muted); padding-bottom: 0.35rem; }
.unseen + tbody tr:first-child > * { border-top: 1.5px solid var(--ink); }
.num { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
thead .num { white-space: normal; vertical-align: bottom; }
figure { margin: 1.8rem 0; }
figure svg { display: block; width: 100%; height: auto; margin: 0 auto;
  background: #fff; }
figcaption { font-size: 0.93rem; color: var(--muted); margin-top: 0.5rem; }
@media print {
  :root { --ink: #000; --paper: #fff; --muted: #444; --rule: #999; --link: #000; }
  body { display: block; font-size: 10.5pt; } .toc, .skip { display: none; }
  .page { max-width: none; padding: 0; } a { text-decoration: none; }
  .head, .says, .label, h2, h3, h4 { break-after: avoid; } .row, figure, li { break-inside: avoid; }
}
@page { margin: 20mm; }
"""


def write(document: Document, figures: Mapping[str, str]) -> str:
    """The document.  `figures` has the SVG of each figure by its name."""
    body = mathml.held("\n".join(_sections(document, figures)))
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<meta name="color-scheme" content="light dark"/>
<title>{escape(document.title)}</title>
<style>{STYLE}</style>
</head>
<body>
<a class="skip" href="#content">Skip to the lecture</a>
{_contents(document)}
<main class="page" id="content">
<header>
<h1>{prose_html(document.title)}</h1>
<p class="subtitle">{prose_html(document.subtitle)}</p>
</header>
{body}
<footer class="colophon"><p>{prose_html(document.colophon)}</p></footer>
</main>
</body>
</html>
"""


def _contents(document: Document) -> str:
    items = "\n".join(
        _entry(block) for block in document.blocks if isinstance(block, (Heading, ExerciseHead))
    )
    return (
        '<nav class="toc" aria-label="Contents"><details open="open"><summary>Contents</summary>'
        f"<ul>\n{items}\n</ul></details></nav>"
    )


def _entry(block: Heading | ExerciseHead) -> str:
    """A line of the contents."""
    if isinstance(block, ExerciseHead):
        kind, number = "deep ask", "Ex."
    else:
        kind, number = "deep" if block.level > 1 else "", block.number
    name = f' class="{kind}"' if kind else ""
    title = f'<span class="n">{number}</span>{prose_html(block.title)}'
    return f'<li{name}><a href="#{block.anchor}">{title}</a></li>'


def _sections(document: Document, figures: Mapping[str, str]) -> list[str]:
    """The blocks, those of each claim in an element of its own."""
    made: list[str] = []
    inside = False
    for block in document.blocks:
        if inside and isinstance(block, (ClaimHead, ExerciseHead, Heading, Figure, Subhead)):
            made.append("</section>")
            inside = False
        if isinstance(block, (ClaimHead, ExerciseHead)):
            kind = "claim" if isinstance(block, ClaimHead) else "exercise"
            made.append(f'<section class="{kind}" id="{block.anchor}">')
            inside = True
        made.append(_figure(block, figures) if isinstance(block, Figure) else html_block(block))
    return [*made, "</section>"] if inside else made


def fragment(blocks: Sequence[Any]) -> str:
    """The blocks of one claim, to be pasted into a page."""
    (head,) = [block for block in blocks if isinstance(block, ClaimHead)]
    inner = mathml.held("\n".join(html_block(block) for block in blocks))
    return f'<section class="claim" id="{head.anchor}">\n{inner}\n</section>\n'


def _figure(block: Figure, figures: Mapping[str, str]) -> str:
    """The SVG inline, its identifiers made unique, and its content in words."""
    svg = figures[block.name]
    svg = svg[svg.index("<svg") :].strip()
    svg = re.sub(r'\bid="', f'id="{block.name}-', svg)
    svg = re.sub(r'(href="#|url\(#)', rf"\g<1>{block.name}-", svg)
    label = escape(block.alternative)
    # Larger than in print, where figures have their own size.
    size = re.search(r'width="([\d.]+)pt"', svg)
    room = f' style="max-width: {float(size[1]) / 8:.1f}rem"' if size else ""
    svg = svg.replace("<svg", f'<svg role="img" aria-label="{label}"{room}', 1)
    return f"<figure>\n{svg}\n<figcaption>{prose_html(block.caption)}</figcaption>\n</figure>"


def rich(content: Rich) -> str:
    """Running text with formulas."""
    return "".join(
        prose_html(piece) if isinstance(piece, str) else mathml.mathml(piece) for piece in content
    )


def badge(verdict: Verdict) -> str:
    """A verdict as a mark and a word, so that colour is not needed."""
    mark = f'<span aria-hidden="true">{MARKS[verdict]} </span>'
    return f'<span class="badge {verdict}">{mark}{verdict}</span>'


@singledispatch
def html_block(block: Any) -> str:
    """A block as HTML."""
    raise TypeError(f"no HTML for {type(block).__name__}")


@html_block.register
def _(block: Heading) -> str:
    level = block.level + 1
    number = f'<span class="n">{block.number}</span>' if block.number else ""
    return f'<h{level} id="{block.anchor}">{number}{prose_html(block.title)}</h{level}>'


@html_block.register
def _(block: Paragraph) -> str:
    return f"<p>{_label(block.label)}{rich(block.content)}</p>"


def _label(words: str) -> str:
    return f'<span class="label">{prose_html(words)}</span> ' if words else ""


@html_block.register
def _(block: ClaimHead) -> str:
    return (
        f'<div class="head"><h4>{escape(block.shown)}</h4>{badge(block.verdict)}</div>\n'
        f'<p class="says">{prose_html(block.says)}</p>'
    )


@html_block.register
def _(block: Display) -> str:
    label = f'<p class="label">{prose_html(block.label)}</p>\n' if block.label else ""
    rows = "\n".join(_row(group) for group in groups(block))
    return f'{label}<div class="display">\n{rows}\n</div>'


def _row(group: Sequence[Row]) -> str:
    last = group[-1]
    speaker = group[0]
    why = f'<p class="why">{rich(speaker.spoken)}</p>' if speaker.reason else ""
    equations = [row.equation for row in group]
    wide, narrow = (mathml.display(equations, last.order, n) for n in (lay.LINE, NARROW))
    shown = wide if wide == narrow else _classed(wide, "wide") + _classed(narrow, "narrow")
    side = badge(last.verdict) if last.verdict is not None else ""
    side += f' <span class="tag">({last.tag})</span>' if last.tag else ""
    line = f'<div class="eq">{shown}</div>' + (f"<div>{side.strip()}</div>" if side else "")
    return f'<div class="row">{why}{line}</div>'


def _classed(math: str, name: str) -> str:
    return math.replace("<math", f'<math class="{name}"', 1)


@html_block.register
def _(block: Conditions) -> str:
    items = "\n".join(f"<li>{_condition(item)}</li>" for item in block.items)
    return f'<p class="label">Assumptions</p>\n<ul class="conditions">\n{items}\n</ul>'


def _condition(item: Condition) -> str:
    words = f", {prose_html(item.words)}" if item.words else ""
    kind, said = ("stated", "stated") if item.stated else ("unstated", "not stated")
    return (
        f'{mathml.mathml(item.relation)}{words} <span class="{kind}">({said})</span>. '
        f"{_numbers(item.without)}"
    )


@html_block.register
def _(block: Numbers) -> str:
    return f"<p>{_numbers(block)}</p>"


def _numbers(block: Numbers) -> str:
    values = ", ".join(
        mathml.mathml(lay.Chain((name, value), ("=",))) for name, value in block.values
    )
    sides = block.said(mathml.mathml)
    return f"{_label(block.label)}{sides}" + (f" at {values}." if values else ".")


@html_block.register
def _(block: Measures) -> str:
    rows = "\n".join(
        f'<tr><th scope="row">{prose_html(row.what)}</th><td class="num">{_power(row.error)}</td>'
        f'<td class="num">{_power(row.tolerance)}</td></tr>'
        for row in block.rows
    )
    return (
        f'<p class="label">{prose_html(block.label)}</p>\n<div class="scroll"><table>\n<thead><tr>'
        f'<th scope="col">{prose_html(block.compared)}</th><th scope="col" class="num">error</th>'
        f'<th scope="col" class="num">tolerance</th></tr></thead>\n<tbody>\n{rows}\n</tbody>\n'
        "</table></div>"
    )


def _power(number: float) -> str:
    return mathml.mathml(lay.decimal(number, 2))


@html_block.register
def _(block: Summary) -> str:
    rows = "\n".join(
        f'<tr><th scope="row">{badge(verdict)}</th><td class="num">{count}</td>'
        f"<td>{prose_html(meaning)}</td></tr>"
        for verdict, count, meaning in block.rows
    )
    total = sum(count for _, count, _ in block.rows)
    return (
        '<table>\n<thead><tr><th scope="col">verdict</th><th scope="col" class="num">claims</th>'
        f'<th scope="col">what it says</th></tr></thead>\n<tbody>\n{rows}\n'
        f'<tr><th scope="row">all</th><td class="num">{total}</td><td></td></tr>\n'
        "</tbody>\n</table>"
    )


@html_block.register
def _(block: FoundList) -> str:
    rows = "\n".join(
        f'<tr><td>{prose_html(row.section)}</td><th scope="row"><a href="#{row.anchor}">'
        f"{escape(row.name)}</a></th><td>{badge(row.verdict)}</td><td>{rich(row.content)}</td></tr>"
        for row in block.rows
    )
    return (
        '<div class="scroll"><table class="found">\n<thead><tr><th scope="col">section</th>'
        '<th scope="col">claim</th><th scope="col">verdict</th>'
        f'<th scope="col">what is amiss</th></tr></thead>\n<tbody>\n{rows}\n</tbody>\n'
        "</table></div>"
    )


@html_block.register
def _(block: Symbols) -> str:
    rows = "\n".join(
        f'<tr><th scope="row">{mathml.mathml(node)}</th><td>{prose_html(meaning)}</td>'
        f"<td>{escape(unit)}</td></tr>"
        for node, meaning, unit in block.rows
    )
    return (
        '<div class="scroll"><table>\n<thead><tr><th scope="col">symbol</th>'
        '<th scope="col">meaning</th><th scope="col">unit</th></tr></thead>\n'
        f"<tbody>\n{rows}\n</tbody>\n</table></div>"
    )


@html_block.register
def _(block: ExerciseHead) -> str:
    return (
        f'<div class="head"><h4>Exercise: {prose_html(block.title)}</h4>'
        f'<span class="asks">{prose_html(block.asks)}</span></div>'
    )


@html_block.register
def _(block: Subhead) -> str:
    return f"<h5>{prose_html(block.words)}</h5>"


@html_block.register
def _(block: Quantities) -> str:
    rows = "\n".join(
        f'<tr><th scope="row">{prose_html(what)}</th><td class="num">{_cell(value)}</td>'
        f"<td>{'' if unit == '1' else escape(unit)}</td></tr>"
        for what, value, unit in block.rows
    )
    return (
        f'<p class="label">{prose_html(block.label)}</p>\n<div class="scroll"><table>\n'
        '<thead class="unseen"><tr><th scope="col">what</th><th scope="col">value</th>'
        f'<th scope="col">unit</th></tr></thead>\n<tbody>\n{rows}\n</tbody>\n</table></div>'
    )


@html_block.register
def _(block: DataTable) -> str:
    first, *others = map(prose_html, block.columns)
    head = f'<th scope="col">{first}</th>' + "".join(
        f'<th scope="col" class="num">{words}</th>' for words in others
    )
    rows = "\n".join(
        f'<tr><th scope="row">{_cell(row[0])}</th>'
        + "".join(f'<td class="num">{_cell(value)}</td>' for value in row[1:])
        + "</tr>"
        for row in block.rows
    )
    return (
        f'<div class="scroll"><table>\n<caption>{prose_html(block.title)}</caption>\n'
        f"<thead><tr>{head}</tr></thead>\n<tbody>\n{rows}\n</tbody>\n</table></div>"
    )


def _cell(value: str | lay.Node) -> str:
    return prose_html(value) if isinstance(value, str) else mathml.mathml(value)
