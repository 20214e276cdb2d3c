"""The lecture as one HTML file that needs no network: MathML, inline figures, inline style."""

from __future__ import annotations

import math
import re
from base64 import b64encode
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cache, singledispatch
from html import escape
from importlib.resources import files

from rigidtop.proof.verdict import Verdict
from rigidtop.report import blocks as b
from rigidtop.report.transcript import transcript
from rigidtop.terminal.visible import visible
from rigidtop.typeset import mathml, sizes
from rigidtop.typeset import nodes as lay
from rigidtop.typeset.latex import aligned, aligned_lines, latex
from rigidtop.typeset.words import characters, tex, tied, unmarked, written

NARROW = 36.0
"""How many letters wide a line is on a small screen."""


def prose_html(text: str) -> str:
    """A sentence as HTML, its formulas as MathML.

    >>> prose_html("a & b's")
    'a &amp; b’s'
    """
    return written(tied(text), _formula, lambda part: escape(part.replace("'", "’"), quote=False))


@cache
def _formula(part: str) -> str:
    """A formula of a sentence, which says itself in Unicode."""
    words = characters(part)
    plain = f"<mtext>{escape(words)}</mtext>"
    return transcript(tex(part), {}, alt=words) or mathml.element(plain, words, False)


def style(*names: str) -> str:
    """Style sheets and scripts of this package, one behind the other, with their fonts in them."""
    folder = files("rigidtop.report").joinpath("styles")
    colors = " ".join(
        f"--{verdict}: light-dark(#{light}, #{dark});"
        for verdict, (light, dark) in b.COLORS.items()
    )
    text = "".join(folder.joinpath(name).read_text("utf-8") for name in names)

    def font(place: re.Match[str]) -> str:
        letters = b64encode(folder.joinpath(place[1]).read_bytes()).decode()
        return f"url(data:font/woff2;base64,{letters})"

    return re.sub(r"url\((\w+\.woff2)\)", font, text).replace("@COLORS@", colors)


def page(
    title: str, styles: Sequence[str], body: str, kind: str = "", what: str = "lecture"
) -> str:
    """A whole page that brings its styles along; a reader of `what` it has may skip its head."""
    return f"""<!DOCTYPE html>
<html lang="en"{f' class="{kind}"' if kind else ""}>
<head>
<meta charset="utf-8"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<meta name="color-scheme" content="light dark"/>
<title>{escape(title)}</title>
<style>{style(*styles)}</style>
</head>
<body>
<a class="skip" href="#content">Skip to the {what}</a>
{body}</body>
</html>
"""


def write(
    document: b.Document, figures: Mapping[str, str], *, slides: bool = False, player: str = ""
) -> str:
    """The document.  `figures` has the SVG of each figure by its name; a `player` ends the body.

    As `slides` it is for the projector: a derivation is uncovered line by line with the keys.
    """
    if slides:
        document = replace(document, blocks=tuple(map(_in_full, document.blocks)))
    body = mathml.held("\n".join(_sections(document, figures)))
    byline = f'\n<p class="byline">{prose_html(document.byline)}</p>' if document.byline else ""
    source = f'<p class="colophon">{prose_html(document.colophon)}</p>'
    begin, end = (f"\n{source}", "") if slides else ("", f"\n<footer>{source}</footer>")
    opening = "" if slides or document.opening is None else _figure(document.opening, figures)
    kinds = [
        "fonts.css",
        "page.css",
        *["lecture.css"] * document.lecture,
        f"{'slides' if slides else 'print'}.css",
    ]
    extra = ("slides.js", "projector.js") if slides else ("refit.js",)
    scripts = ("fit.js", *["lecture.js"] * (document.lecture and not slides), *extra)
    # The marks of CDATA are comments to a browser, and keep the page well-formed XML.
    script = f"<script>/*<![CDATA[*/{style(*scripts)}/*]]>*/</script>\n"
    body = f"""{_contents(document)}
<main class="page" id="content">
<header>
<h1>{prose_html(document.title)}</h1>
<p class="subtitle">{prose_html(document.subtitle)}</p>{byline}{begin}
</header>
{opening}{_TOOLS * (document.lecture and not slides)}
{body}{end}{_CARD * (document.lecture and not slides)}
</main>
{player}{script}"""
    return visible(page(unmarked(document.title), kinds, body, "lecture" * document.lecture))


_WAYS = {"results": "Results only", "steps": "Steps", "all": "Steps and reasons"}
_SET = ' checked="checked"'
_TOOLS = (
    '\n<div class="tools" role="group" aria-label="How the lecture is shown">'
    + "".join(
        f'<label><input type="radio" name="show" value="{way}"{_SET * (way == "all")}/>'
        f"{words}</label>"
        for way, words in _WAYS.items()
    )
    + '<label><input type="checkbox" id="turned"/>Light or dark</label></div>'
)
"""What a reader may choose, which the style sheet heeds."""
_CARD = """
<div class="card" id="card" hidden=""></div>
<button type="button" class="back" hidden="">↩ Back to where I was</button>"""
"""Where a script shows what a citation leads to, and the way back from there."""


def _in_full(block: b.Block) -> b.Block:
    """A block whose notes say in full what is "as above" on a page: that is another slide."""
    return b.walked(block, lambda part, _: part.in_full if isinstance(part, b.MarginMark) else part)


def _contents(document: b.Document) -> str:
    parts: list[list[str]] = []
    for block in document.contents:
        if parts and (isinstance(block, b.ExerciseHead) or block.level > 1):
            parts[-1].append(_entry(block))
        else:
            parts.append([_entry(block)])
    if not parts:
        return ""
    items = "\n".join(_part(*each) for each in parts)
    # On a narrow page the contents of a lecture are closed, or its title would stand below them.
    state = "" if document.lecture else ' open="open"'
    return (
        f'<nav class="toc" aria-label="Contents"><details{state}><summary>Contents</summary>'
        f"<ul>\n{items}\n</ul></details></nav>"
    )


def _part(head: str, *deep: str) -> str:
    """A section in the contents, with what stands in it."""
    inside = "\n".join(f"<li>{each}</li>" for each in deep)
    return f"<li>{head}\n<ul>\n{inside}\n</ul></li>" if deep else f"<li>{head}</li>"


def _entry(block: b.SectionHead | b.ExerciseHead) -> str:
    """The link to a section or an exercise in the table of contents."""
    kind, number = (
        ("", block.number) if isinstance(block, b.SectionHead) else (' class="ask"', "Ex.")
    )
    title = f'<span class="n">{number}</span>{prose_html(block.title)}'
    return f'<a{kind} href="#{block.anchor}">{title}</a>'


def _sections(document: b.Document, figures: Mapping[str, str]) -> list[str]:
    """The blocks, those together that have columns on paper."""
    pieces: list[str] = []
    end = ""
    for block in document.blocks:
        if isinstance(block, b.SectionHead) and block.level == 1:
            wide = block.anchor not in b.IN_COLUMNS
            pieces += [end, "" if wide else '<div class="columns">']
            end = "" if wide else "</div>"
        pieces.append(_figure(block, figures) if isinstance(block, b.Figure) else html_block(block))
    return [each for each in (*pieces, end) if each]


def fragment(blocks: Sequence[b.Block]) -> str:
    """The blocks of one claim, to be pasted into a page."""
    inner = mathml.held("\n".join(map(html_block, blocks)))
    return visible(f"<section>\n{inner}\n</section>\n")


def _figure(block: b.Figure, figures: Mapping[str, str]) -> str:
    """The SVG inline, its identifiers made unique, and its content in words."""
    svg = figures[block.name]
    svg = svg[svg.index("<svg") :].strip()
    svg = re.sub(r'\bid="', f'id="{block.name}-', svg)
    svg = re.sub(r'(href="#|url\(#)', rf"\g<1>{block.name}-", svg)
    svg = re.sub(r"<path (?![^>]*\bd=)", '<path d="" ', svg)  # of a space
    alternative = escape(block.alternative)
    # Larger than in print, where figures have their own size.
    size = re.search(r'width="([\d.]+)pt"', svg)
    room = f' style="max-width: {float(size[1]) / 8:.1f}rem"' if size else ""
    svg = svg.replace("<svg", f'<svg role="img" aria-label="{alternative}"{room}', 1)
    label = f"<strong>{block.label}.</strong> " if block.label else ""
    caption = f"{label}{prose_html(block.caption)}"
    place = f'id="{block.anchor}" data-figure="{block.name}"'
    place += ' class="broad"' * (size is not None and float(size[1]) > 350)  # two columns on paper
    return f"<figure {place}>\n{svg}\n<figcaption>{caption}</figcaption>\n</figure>"


def _flat(formula: lay.Node) -> str:
    """A formula in a sentence; its brackets do not grow where it is no higher than its line."""
    markup = mathml.mathml(lay.flat(formula))
    return markup if "<mfrac" in markup else markup.replace('stretchy="true"', 'stretchy="false"')


def badge(verdict: Verdict) -> str:
    """A verdict as a mark and a word, so that colour is not needed."""
    mark = f'<span aria-hidden="true">{b.MARKS[verdict]} </span>'
    return f'<span class="badge {verdict}">{mark}{verdict}</span>'


rich = b.Script(
    words=prose_html,
    formula=_flat,
    unit=escape,
    cited=lambda place: f'<a href="#{place.anchor}">{escape(place.words)}</a>',
    verdict=badge,
)


@singledispatch
def html_block(block: b.Block) -> str:
    """A block of a document, as HTML."""
    raise TypeError(f"no HTML for {type(block).__name__}")


@html_block.register
def _(block: b.SectionHead) -> str:
    level = block.level + 1
    number = f'<span class="n">{block.number}</span>' if block.number else ""
    return f'<h{level} id="{block.anchor}">{number}{prose_html(block.title)}</h{level}>'


@html_block.register
def _(block: b.Paragraph) -> str:
    if block.mark is None:
        return f"<p>{_label(block.label)}{rich(block.content)}</p>"
    words = f"{seal(block.mark)}{rich(block.content)}"
    place = f' id="{block.anchor}"' if block.anchor else ""
    return f'<p class="marked"{place}>{words}</p>{_aside(block.mark)}'


def seal(mark: b.MarginMark) -> str:
    """A verdict in the margin: a mark, its word for those who do not see it."""
    sign = f'<span aria-hidden="true">{b.MARKS[mark.verdict]}</span>'
    word = f'<span class="unseen">{mark.verdict}: </span>'
    return f'<span class="seal {mark.verdict}" title="{mark.verdict}">{sign}{word}</span>'


def _aside(mark: b.MarginMark | None) -> str:
    """The condition of a verdict as a side note."""
    return f'<p class="side">{rich(mark.note)}</p>' if mark is not None and mark.note else ""


def _label(words: str) -> str:
    return f'<span class="label">{prose_html(words)}</span> ' if words else ""


@html_block.register
def _(block: b.ClaimHead) -> str:
    level = f"h{block.level + 1}"
    return (
        f'<div class="head claim" id="{block.anchor}"><{level}>{escape(block.shown)}</{level}>'
        f"{badge(block.verdict)}</div>\n"
        f'<p class="says">{prose_html(block.says)}</p>'
    )


@html_block.register
def _(block: b.Display) -> str:
    label = f'<p class="label">{prose_html(block.label)}</p>\n' if block.label else ""
    rows = "\n".join(_row(group, block.step) for group in b.groups(block))
    return f"{label}{rows}"


def _row(group: Sequence[b.DisplayRow], step: bool = False) -> str:
    last = group[-1]
    speaker = group[0]
    why = f'<p class="why">{rich(speaker.spoken)}</p>' if speaker.reason else ""
    equations = [row.equation for row in group]
    wide, narrow = (mathml.display(equations, last.order, n) for n in (sizes.LINE, NARROW))
    body = wide if wide == narrow else _classed(wide, "wide") + _classed(narrow, "narrow")
    side = badge(last.verdict) if last.verdict is not None else ""
    number = f'<span class="tag">({last.tag})</span>' if last.tag else ""
    mark = next((row.mark for row in reversed(group) if row.mark is not None), None)
    place = next((row.anchor for row in reversed(group) if row.anchor), "")
    if place and number:
        number = f'<a class="place" href="#{place}">{number}</a>'
    side += f" {number}" if number else ""
    side += seal(mark) if mark is not None else ""
    line = f'<div class="eq">{body}</div>' + (f"<div>{side.strip()}</div>" if side else "")
    if not step:
        return f'<div class="row">{why}{line}</div>'
    kind = "row result" if last.tag or mark is not None else "row step"
    source = latex(equations[0], last.order)
    if equations[1:]:
        source = aligned(aligned_lines(equations, last.order, math.inf))
    name = f' id="{place}"' if place else ""
    attributes = f' data-line="{speaker.line}" data-cites="{" ".join(speaker.cites)}"'
    return (
        f'<div class="{kind}"{name}{attributes * bool(speaker.line)} data-tex="{escape(source)}">'
        f"{why}{line}</div>{_aside(mark)}"
    )


def _classed(math: str, name: str) -> str:
    return math.replace("<math", f'<math class="{name}"', 1)


def _table(
    head: Sequence[str],
    rows: Iterable[Sequence[str]],
    *,
    numbers: Collection[int] = (),
    titles: int = 0,
    kind: str = "",
    caption: str = "",
) -> str:
    """A table of HTML cells under their `head`; the column `titles` says what a row is about.

    The columns `numbers` are aligned as such.
    """

    def cell(words: str, k: int, scope: str = "") -> str:
        style = ' class="num"' if k in numbers else ""
        words = f"<time>{words}</time>" if _DATE.fullmatch(words) else words.strip()
        if not scope or not words:
            return f"<td{style}>{words}</td>"
        return f'<th scope="{scope}"{style}>{_title(words)}</th>'

    body = "\n".join(
        f"<tr>{''.join(cell(x, k, 'row' * (k == titles)) for k, x in enumerate(row))}</tr>"
        for row in rows
    )
    top = "".join(cell(words, k, "col") for k, words in enumerate(head))
    name = f' class="{kind}"' if kind in ("found", "results") else ""
    unseen = ' class="unseen"' if kind == "unseen" else ""
    title = f"<caption>{caption}</caption>\n" if caption else ""
    return (
        f'<div class="scroll"><table{name}>\n{title}<thead{unseen}><tr>{top}</tr></thead>\n'
        f"<tbody>\n{body}\n</tbody>\n</table></div>"
    )


def _title(words: str) -> str:
    """The title of a column or a row; formulas alone are no text that a screen reader looks for."""
    if re.sub(r"<math.*?</math>", "", words).strip():
        return words
    spoken = " ".join(re.findall(r'alttext="([^"]*)"', words))
    return f'<span class="unseen">{spoken}</span><span aria-hidden="true">{words}</span>'


@html_block.register
def _(block: b.Items) -> str:
    items = "\n".join(f"<li>{rich(item)}</li>" for item in block.items)
    return f'<p class="label">{prose_html(block.label)}</p>\n<ul class="items">\n{items}\n</ul>'


@html_block.register
def _(block: b.TableBlock) -> str:
    rows = [[*map(rich, row)] for row in block.cells]
    title = prose_html(block.title)
    listed = block.kind == "values"
    kind = {"values": "unseen", "text": "found"}.get(block.kind, "")
    caption = "" if listed else title
    head = [*map(prose_html, block.head)]
    table = _table(head, rows, numbers=block.right, kind=kind, caption=caption)
    return f'<p class="label">{title}</p>\n{table}' if listed and title else table


@html_block.register
def _(block: b.ExerciseHead) -> str:
    level = f"h{block.level + 1}"
    title = f"<{level}>{block.label}. {prose_html(block.title)}</{level}>"
    points = f' <span class="points">{escape(block.points)}</span>' if block.points else ""
    return (
        f'<div class="head exercise" id="{block.anchor}">{title}'
        f'<span class="asks">{prose_html(block.asks)}</span>{points}</div>'
    )


@html_block.register
def _(block: b.Legend) -> str:
    items = "".join(
        f"<li>{seal(b.MarginMark('', verdict))}{prose_html(words)}</li>"
        for verdict, words in block.rows
    )
    return f'<div class="legend"><p>{escape(block.head)}:</p><ul>{items}</ul></div>'


@html_block.register
def _(block: b.NameLine) -> str:
    words = "".join(f"<span>{escape(word)}:</span>" for word in block.words)
    return f'<p class="names">{words}</p>'


@html_block.register
def _(_: b.Room) -> str:
    return '<div class="room"></div>'


@html_block.register
def _(block: b.Results) -> str:
    rows = (
        (
            f'<a href="#{b.anchor(number)}">({number})</a> {seal(b.MarginMark(number, verdict))}',
            mathml.display(equations, "printed", NARROW),
            rich(words),
        )
        for number, equations, words, verdict in block.rows
    )
    return _table(block.head, rows, kind="results")


@html_block.register
def _(block: b.Subhead) -> str:
    level = block.level + 1 if block.level else 5
    kind = ' class="sub"' if block.level else ""
    return f"<h{level}{kind}>{prose_html(block.words)}</h{level}>"


@html_block.register
def _(block: b.Aside) -> str:
    return f'<details class="box"><summary>{prose_html(block.title)}</summary>'


@html_block.register
def _(_: b.AsideEnd) -> str:
    return "</details>"


_DATE = re.compile(r"\d{4}-\d\d-\d\d")
