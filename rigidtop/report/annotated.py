"""Somebody's notes with verdicts beside their equations, as one HTML file that needs no network.

The text is shown simply, and comes from strangers: every character of it is escaped, links and
pictures are left out.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

from rigidtop.judge.outcome import PREMISE
from rigidtop.proof.verdict import Verdict
from rigidtop.report.blocks import MARKS
from rigidtop.report.html import badge, page, prose_html
from rigidtop.terminal.visible import visible
from rigidtop.typeset import mathml


@dataclass(frozen=True)
class FormulaSpan:
    """A formula and its place in the text, dollars included.

    Its `signs` are shown, a ``<math>`` element, and where it has none the TeX `source`.
    """

    start: int
    end: int
    source: str
    display: bool = False
    signs: str = ""


@dataclass(frozen=True)
class VerdictSpan:
    """An equation with its verdict; it stands in the text from `start` to `end`.

    Its `number` is "" where it has none.
    """

    start: int
    end: int
    number: str
    line: int
    verdict: str
    passed: bool
    note: str
    formulas: tuple[FormulaSpan, ...]


_COLOPHON = """Each numbered equation with the verdict of the collection of
derivations; of other formulas what is wrong is marked, and the rest is
counted. All are set sign by sign, as they are written."""


def write(
    title: str,
    source: str,
    formulas: Sequence[FormulaSpan],
    marks: Sequence[VerdictSpan],
    summary: str,
    others: Sequence[str] = (),
    done: str = "audited",
    colophon: str = _COLOPHON,
) -> str:
    """The page.

    `formulas` are those without a mark; `summary` is one sentence about all; `others` are findings
    without a number.  `done` says what has been done to the text, and `colophon` what is marked.
    """
    inside = {**{f.start: (f.end, _inline(f)) for f in formulas}}
    framed = {mark.start: (mark.end, _framed(mark, n)) for n, mark in enumerate(marks)}
    text = _text(source, inside, framed)
    items = [
        f'<li><a href="#{_anchor(mark, n)}">{_name(mark)}</a>'
        f"{verdict_badge(mark.verdict)} {f'line {mark.line}: ' * bool(mark.number)}"
        f"{note_html(mark.note)}</li>"
        for n, mark in enumerate(marks)
        if not mark.passed or mark.verdict in (Verdict.CONVENTION, Verdict.FALSE)
    ]
    items += [f"<li>{escape(_clean(other))}</li>" for other in others]
    findings = "\n".join(items)
    listed = f'\n<ul class="findings">\n{findings}\n</ul>' if items else ""
    whole = f"""<main class="page">
<header class="summary">
<h1>{escape(_clean(title))}, {done}</h1>
<p>{escape(_clean(summary))}</p>{listed}
</header>
<div class="notes" id="content">
{text}
</div>
<footer class="colophon"><p>{colophon}</p></footer>
</main>
"""
    styles = ("page.css", "print.css", "annotated.css")
    return page(f"{_clean(title)}, {done}", styles, whole, what="notes")


# --- Equations -----------------------------------------------------------------------------------


def _anchor(mark: VerdictSpan, n: int) -> str:
    return f"eq-{n + 1}"


def _name(mark: VerdictSpan) -> str:
    """The number of an equation, or the line of one without."""
    return f"({escape(_clean(mark.number))})" if mark.number else f"line {mark.line}"


def note_html(note: str) -> str:
    """A note with its mathematics as HTML; what is in it of the file may be of any kind."""
    try:
        return mathml.held(prose_html(_clean(note)))
    except ValueError:
        return escape(_clean(note))


def verdict_badge(verdict: str) -> str:
    """The badge of a verdict, or of what stands in place of one, as HTML."""
    if verdict in list(Verdict):
        return badge(Verdict(verdict))
    alike = _ALIKE.get(verdict, Verdict.UNDECIDED)
    sign = f'<span aria-hidden="true">{MARKS[alike]} </span>'
    return f'<span class="badge {alike}">{sign}{escape(verdict)}</span>'


_ALIKE = {
    PREMISE: Verdict.DEFINITION,
    "follows": Verdict.PROVED,
    "assumption": Verdict.DEFINITION,
    "wrong": Verdict.FALSE,
    "carried": Verdict.ASSUMING,
}
"""What is no verdict of a claim, with the verdict that looks like it."""


def _framed(mark: VerdictSpan, n: int) -> str:
    """A marked equation: what it says, its number and verdict, and why."""
    blocks = "".join(map(_block, mark.formulas))
    amiss = "" if mark.passed else " amiss"
    why = f'<span class="why">{note_html(mark.note)}</span>' if mark.note else ""
    return (
        f'<span class="audited{amiss}" id="{_anchor(mark, n)}"><span class="eq">{blocks}</span>'
        f'<span class="side"><span class="tag">{_name(mark)}</span>'
        f"{verdict_badge(mark.verdict)}</span>{why}</span>"
    )


def _block(formula: FormulaSpan) -> str:
    return formula.signs or f"<code>{escape(_clean(formula.source.strip()))}</code>"


def _inline(formula: FormulaSpan) -> str:
    block = _block(formula)
    return f'<span class="shown eq">{block}</span>' if formula.display else block


# --- Text ----------------------------------------------------------------------------------------

_OPEN, _CLOSE = "\ue000", "\ue001"
_PLACE = re.compile(f"{_OPEN}(\\d+){_CLOSE}")
_PLACES = re.compile("[\ue000\ue001]")
"""Characters that mark places here."""

# The lengths are limited where many may begin and none ends.
_LEFT_OUT = re.compile(r"!\[[^][\n]*\]\([^)\n]{0,1000}\)|<span[^<>\n]*></span>")
_BEGIN = re.compile(r"\\documentclass(?s:.*?)\\begin\{document\}")
_END = re.compile(r"\\end\{document\}")
"""Of a document in TeX what stands around its body is no text."""
_COMMENT = re.compile(r"<!--.*?-->", re.S)
_LINK = re.compile(r"\[([^][\n]*)\]\([^)\n]{0,1000}\)")
_ITEM = re.compile(r"(?:[-*•]|\d+\.|\([ivx]+\)|- \([ivx]+\))\s+")
_HEADING = re.compile(r"(#{1,6})\s+(.*)")


def _text(
    source: str, inside: dict[int, tuple[int, str]], framed: dict[int, tuple[int, str]]
) -> str:
    """The text as blocks, with HTML in the places of formulas; of a whole document its body."""
    pieces: list[str] = []
    frames: set[int] = set()
    begin = _BEGIN.search(source)
    woven, at = "", begin.end() if begin else 0
    finish = _END.search(source, at) if begin else None
    last = finish.start() if finish else len(source)
    for start, (end, html) in sorted({**inside, **framed}.items()):
        if not at <= start < last:
            continue
        if start in framed:
            frames.add(len(pieces))
        woven += _clean(source[at:start]) + f"{_OPEN}{len(pieces)}{_CLOSE}"
        pieces.append(html)
        at = end
    woven += _clean(source[at:last])
    woven = re.sub(f"{_CLOSE}[ \t]+(?=[,.;:)])", _CLOSE, woven)
    commented, mark, behind = woven.rpartition("-->")
    woven = _LEFT_OUT.sub("", _COMMENT.sub("", commented + mark) + behind)
    blocks = [
        html
        for block in re.split(r"\n[ \t]*\n", woven)
        if block.strip()
        for html in _html_blocks(block.strip(), frames)
    ]
    return _PLACE.sub(lambda place: pieces[int(place[1])], "\n".join(blocks))


def _clean(text: str) -> str:
    return visible(_PLACES.sub("\ufffd", text))


def _html_blocks(block: str, frames: set[int]) -> list[str]:
    """Headings, items and paragraphs of a piece of text between blank lines."""
    blocks: list[str] = []
    lines: list[str] = []
    items: list[list[str]] = []

    def close() -> None:
        if lines:
            blocks.append(f"<p>{_inner(' '.join(lines))}</p>")
        if items:
            blocks.append(
                "<ul>" + "".join(f"<li>{_inner(' '.join(item))}</li>" for item in items) + "</ul>"
            )
        lines.clear()
        items.clear()

    for line in block.split("\n"):
        heading = _HEADING.match(line)
        item = _ITEM.match(line)
        if heading:
            close()
            level = min(len(heading[1]) + 1, 4)
            title = heading[2].rstrip().rstrip("#").rstrip()
            words = _PLACE.sub(lambda p: "" if int(p[1]) in frames else p[0], title)
            blocks.append(f"<h{level}>{_inner(words)}</h{level}>")
            lines += [p[0] for p in _PLACE.finditer(title) if int(p[1]) in frames]
        elif item:
            if lines:
                close()
            items.append([line[item.end() :]])
        elif items:
            items[-1].append(line)
        else:
            lines.append(line)
    close()
    return blocks


def _inner(text: str) -> str:
    """A line of text: bold, italics, underlining and raised numbers; all else as it is written."""
    html = escape(_LINK.sub(r"\1", text))
    html = re.sub(r"\*\*(\S(?:[^*]*\S)?)\*\*", r"<b>\1</b>", html)
    html = re.sub(r"(?<![\w*])\*(\S(?:[^*]*\S)?)\*(?![\w*])", r"<i>\1</i>", html)
    return re.sub(r"&lt;(u|sup|sub)&gt;([^&<]*)&lt;/\1&gt;", r"<\1>\2</\1>", html)
