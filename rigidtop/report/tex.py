"""The lecture as a LaTeX document that needs no more than a basic TeX Live."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import singledispatch
from importlib.resources import files
from typing import Any

from rigidtop.notation.characters import ESCAPES
from rigidtop.report import blocks as b
from rigidtop.report import plain
from rigidtop.report.tex_lines import (
    aligned,
    goes_on,
    prose,
    rich,
    shown,
)
from rigidtop.terminal.visible import visible
from rigidtop.typeset import sizes
from rigidtop.typeset.latex import align, aligned_lines
from rigidtop.typeset.words import unmarked


def write(document: b.Document, figures: Mapping[str, str]) -> str:
    """The document.  `figures` says where the file of each figure lies, as seen from it."""
    parts = list(_joined(document.blocks, figures))
    headings = sum(isinstance(block, b.SectionHead) for block in document.blocks)
    if isinstance(document.blocks[0], b.SectionHead) and headings > FEW:
        parts.insert(0, r"\clearpage")
    if isinstance(document.blocks[0], b.Legend) and headings > FEW:
        # Then the pages of all that follows do not depend on how long the contents are.
        parts.insert(1 + isinstance(document.blocks[1], b.Paragraph), r"\clearpage")
        parts.insert(0, r"\vskip 0pt plus 4fil")
    body = "\n\n".join(parts)
    title = prose(document.title)
    # \tableofcontents begins a page in classes that have chapters.
    contents = r"{\setlength{\parskip}{0pt plus 1fil}\section*{\contentsname}\rttoc}"
    contents *= bool(document.contents)
    if document.lecture:
        words = "Contents" if contents else title
        # Without sections the title stands above all pages.
        kept = "" if contents else r"\def\markboth#1#2{}"
        contents += rf"\markboth{{}}{{{words}}}{kept}\thispagestyle{{plain}}"
    # On a sheet of paper it stands at the end.
    source = rf"{{\footnotesize\color{{muted}} {prose(document.colophon)}\par}}"
    byline = [rf"{{\normalsize {prose(document.byline)}\par}}"] if document.byline else []
    return visible(
        "\n".join(
            [
                _preamble(document, bool(NOTED.search(body))),
                r"\begin{document}",
                rf"{{\LARGE\bfseries\raggedright {title.replace(': ', TURN)}\par}}",
                rf"{{\large\raggedright {prose(document.subtitle)}\par}}",
                *byline,
                r"\vspace{0.5\baselineskip}",
                *([source, r"\vspace{0.5\baselineskip}"] if document.contents else []),
                contents,
                body,
                *([] if document.contents else [source]),
                r"\end{document}",
                "",
            ]
        )
    )


NOTED = re.compile(r"\\rtnote|\\rtmarked\{\w+\}\{[^}]")
"""What stands in the margin."""

FEW = 8
"""With more headings the contents have a page of their own."""

TURN = r":\hfil\penalty-100\hfilneg\ "
"""A title of two lines is broken here, if it can."""

USE = r"""% A chapter for a document of one's own.  In its preamble:
%   \usepackage{rigidtop}        (rigidtop.sty lies beside the folder of the chapters)
%   \graphicspath{{@OUT@}}       where the folder figures/ is
% and where the chapter is to stand: \input{chapters/@NAME@}
"""


def chapters(document: b.Document, figures: Mapping[str, str]) -> dict[str, str]:
    """Each numbered section as a file to be read into another document, and rigidtop.sty."""
    files = {"rigidtop.sty": style_file()}
    parts: dict[str, list[Any]] = {}
    name = "marks"  # what they mean comes first
    for block in document.blocks:
        if isinstance(block, b.SectionHead):
            name = block.number or block.anchor
            name = name if name not in parts else f"{name}-{block.anchor}"
        parts.setdefault(name.replace(".", "-"), []).append(block)
    for name, blocks in parts.items():
        head = USE.replace("@NAME@", name).replace("@OUT@", "./")
        text = "\n\n".join(_joined(blocks, figures, measured=True))
        files[f"chapters/{name}.tex"] = visible(
            f"{head}\\begingroup\\rttext\n{text}\n\\par\\endgroup\n"
        )
    return files


def _joined(
    blocks: Sequence[b.Block], figures: Mapping[str, str], *, measured: bool = False
) -> Iterator[str]:
    """The blocks; a sentence in front of an equation goes on the paragraph above it.

    Where the line is to be `measured` equations are there for a column too.
    """
    at = (
        k for k, e in enumerate(blocks) if isinstance(e, b.SectionHead) and e.anchor in b.IN_COLUMNS
    )
    solved = next(at, len(blocks))
    blocks = [*blocks[:solved], *_floating(blocks[solved:])]
    pending = ""
    for k, (block, after) in enumerate(zip(blocks, [*blocks[1:], None], strict=True)):
        pending += "\\rtsolutions\n" * (k == solved)
        whole = _shown(block, figures)
        if measured and isinstance(block, b.Display):
            narrow = tex_block(replace(block, room=min(block.room, COLUMN)))
            whole = whole if narrow == whole else rf"\rtbroken{{{whole}}}{{{narrow}}}"
        words = pending + whole
        pending = ""
        if goes_on(block, after):
            pending = words.removesuffix(r"\held") + "\n"
        else:
            yield words
    if solved < len(blocks):
        yield r"\rtrest"


def _floating(blocks: Sequence[b.Block]) -> Iterator[b.Block]:
    """What floats told behind the head of its solution and the first paragraph.

    So it has room there, and never takes that of the head.  Narrow tables come before what goes
    over both columns, which would hold them up.
    """
    turns: list[tuple[int, int]] = []
    place, begins = 0, False
    for each in blocks:
        headed = isinstance(each, b.SectionHead | b.ExerciseHead)
        place += headed
        turn = 0 if headed else _turn(each)
        if begins and turn == TEXT:
            turn, begins = 0, isinstance(each, b.Paragraph) and each.held
        begins = headed or begins
        turns.append((place, turn))
    return (blocks[k] for k in sorted(range(len(blocks)), key=turns.__getitem__))


def _turn(block: b.Block) -> int:
    if isinstance(block, b.TableBlock) and block.kind == "numbers":
        return 1 + (len(block.head) > 6)
    return 2 if isinstance(block, b.Figure) else TEXT


TEXT = 3
"""The turn of what does not float."""


COLUMN = 36.0
"""Letters of a line in a column of a page of one's own."""


def style_file() -> str:
    """rigidtop.sty, which a lecture and fragments of it are written with."""
    colors = "\n".join(
        rf"\definecolor{{{verdict}}}{{HTML}}{{{color.upper()}}}"
        for verdict, (color, _) in b.COLORS.items()
    )
    return _style("rigidtop.sty").replace("@COLORS@", colors)


def _inside(style: str) -> str:
    """A style file as a part of a preamble."""
    body = re.sub(r"(?m)^\\(Needs|Provides|endinput).*\n", "", style)
    body = body.replace(r"\RequirePackage", r"\usepackage")
    return "\\makeatletter\n" + body + "\n\\makeatother"


def _style(name: str) -> str:
    return files("rigidtop.report").joinpath("styles", name).read_text("utf-8")


def _preamble(document: b.Document, noted: bool) -> str:
    about = {
        "@TITLE@": document.title,
        "@AUTHOR@": document.author,
        "@SUBJECT@": document.subtitle,
        "@KEYWORDS@": "; ".join(document.keywords),
    }
    look = document.look
    head = _style("lecture.tex" if document.lecture else "record.tex")
    if not document.contents:  # a sheet: what belongs to an exercise stays there
        head += "\\rtinline\n"
    if document.lecture and not noted:  # nothing stands beside it
        head = head.replace("textwidth=134mm", "textwidth=146mm").replace("left=25mm", "hcentering")
    head = head.replace("@PAPER@", f"{look.paper}paper")
    head = head.replace("@STYLE@", _inside(style_file()))
    if look.documentclass:
        head = head.replace("{article}", f"{{{look.documentclass}}}", 1)
    head += look.preamble
    for place, words in about.items():
        head = head.replace(place, as_string(words))
    return head


def _shown(block: b.Block, figures: Mapping[str, str]) -> str:
    if not isinstance(block, b.Figure):
        return tex_block(block)
    about = (figures[block.name], block.anchor, block.label, prose(block.caption))
    return r"\rtfigure" + "".join(f"{{{part}}}" for part in about)


def fragment(blocks: Sequence[b.Block]) -> str:
    """The equations of one claim, to be pasted; what else there is to say stands in comments."""
    lines: list[str] = []
    for block in blocks:
        if isinstance(block, b.Display):
            first, *rest = block.rows
            lines.append(f"% {block.label}")
            if first.follows and first.reason:  # no sentence: it would stand alone
                lines += [f"% {line}" for line in textwrap.wrap(plain.rich(first.spoken), 88)]
                first = replace(first, reason="")
            lines.append(align([aligned(row, sizes.LINE) for row in (first, *rest)]))
        else:
            lines += [f"% {line}" for line in plain.fragment([block]).splitlines() if line]
    return visible("\n".join(lines) + "\n")


@singledispatch
def tex_block(block: b.Block) -> str:
    """A block of a document, as LaTeX."""
    raise TypeError(f"no LaTeX for {type(block).__name__}")


@tex_block.register
def _(block: b.SectionHead) -> str:
    command, level = ("section", 1) if block.level == 1 else ("subsection", 2)
    title = prose(f"{block.number}\u2002{block.title}" if block.number else block.title)
    plain = as_string(f"{block.number} {block.title}".strip())
    begins = APART.get(block.anchor, "")
    return begins + (
        rf"\rtheading\{command}*{{\raggedright {title}}}\phantomsection\label{{{block.anchor}}}"
        rf"\addcontentsline{{toc}}{{{'sub' * (level - 1)}section}}"
        rf"{{\texorpdfstring{{{title}}}{{{plain}}}}}\rthead{{{title}}}"
    )


APART = {"results": "\\rtalone\n", "map": "\\rtwith{25}\n"}
"""How what begins a page begins it."""


def as_string(text: str) -> str:
    r"""What a PDF says in Unicode, without mathematics: of itself and in its bookmarks.

    >>> print(as_string("R&D 100 %: costs $5, $θ$"))
    R\&D 100 \%: costs \$5, θ
    """
    return "".join(ESCAPES.get(c, c) if c.isascii() else c for c in unmarked(visible(text)))


@tex_block.register
def _(block: b.Paragraph) -> str:
    words = rich(block.content)
    if block.mark is not None:
        anchored = rf"\phantomsection\label{{{block.anchor}}}" if block.anchor else ""
        words = (
            rf"{anchored}\rtmarked{{{block.mark.verdict}}}{{{rich(block.mark.note)}}}{{{words}}}"
        )
    # A labelled paragraph, the reason, is not parted from what it is the reason for.
    return (
        rf"\lab{{{prose(block.label)}}}{words}\nopagebreak"
        if block.label
        else words + r"\held" * block.held
    )


@tex_block.register
def _(block: b.ClaimHead) -> str:
    parts = (prose(block.shown), block.anchor, prose(block.says), block.verdict)
    return r"\claim" + "".join(f"{{{part}}}" for part in parts)


@tex_block.register
def _(block: b.Display) -> str:
    return shown(block)


@tex_block.register
def _(block: b.Items) -> str:
    items = "\n".join(rf"\item {rich(item)}" for item in block.items)
    return (
        rf"\lab{{{prose(block.label)}}}\par\nobreak\vspace{{-0.6\baselineskip}}"
        "\n\\begin{itemize}\\setlength{\\itemsep}{1pt}\\setlength{\\parskip}{0pt}"
        f"\n{items}\n\\end{{itemize}}"
    )


@tex_block.register
def _(block: b.TableBlock) -> str:
    rows = [[*map(rich, row)] for row in block.cells]
    kinds = {"text": _text, "symbols": _symbols, "values": _values, "numbers": _numbers}
    return kinds[block.kind](block, rows)


Cells = Sequence[Sequence[str]]


def _text(block: b.TableBlock, rows: Cells) -> str:
    columns = "".join(
        rf">{{\raggedright\arraybackslash}}p{{{width}\linewidth}}" if width else "l"
        for width in block.widths
    )
    # A short one has no head to be said again: where a page ends before it, none is left behind.
    parted = len(rows) > MOST_KEPT
    kind, place, head = ("longtable", "[l]", r"\endhead") if parted else ("tabular", "", "")
    return "\n".join(
        [
            rf"{{\small\noindent\begin{{{kind}}}{place}{{@{{}}{columns}@{{}}}}",
            rf"\toprule {' & '.join(map(prose, block.head))} \\ \midrule {head}",
            *(" & ".join(row) + r" \\[2pt]" for row in rows),
            rf"\bottomrule\end{{{kind}}}\par}}",
        ]
    )


MOST_KEPT = 10
"""Rows of a table of words that is not parted."""


def _symbols(_: b.TableBlock, rows: Cells) -> str:
    body = "\n".join(
        rf"\rtsymbol{{{symbol}}}{{{meaning}}}{{{unit.removeprefix(THIN)}}}"
        for symbol, meaning, unit in rows
    )
    return f"\\begin{{rtsymbols}}{body}\\end{{rtsymbols}}"


THIN = r"\,"


def _values(block: b.TableBlock, rows: Cells) -> str:
    lines = [rf"\rtquantity{{{what}}}{{{value}{unit}}}" for what, value, unit in rows]
    # A list is parted, if at all, between at least so many rows, and only where nothing else is.
    parts = (min(k, len(lines) - k) for k in range(len(lines)))
    lines = [
        (r"\nobreak" if least < TOGETHER else r"\penalty500 ") + row
        for least, row in zip(parts, lines, strict=True)
    ]
    label = rf"\lab{{{prose(block.title)}}}\par\nopagebreak" if block.title else ""
    return f"{label}\\rtquantities{{{''.join(lines)}}}"


TOGETHER = 4
"""Quantities of a list that stay together."""


def _numbers(block: b.TableBlock, rows: Cells) -> str:
    first, *others = block.head
    side, *sides = ["r" if k in block.right else "l" for k in range(len(block.head))]
    head = " & ".join([prose(first), *map(_head, map(_stacked, others), sides)])
    # Long words at the left have room for two lines.
    long = any(isinstance(row[0], str) and len(row[0]) > LONG for row in block.rows)
    left = r">{\raggedright\arraybackslash}p{0.62\linewidth}" if long else side
    lines = [" & ".join(row) + r" \\" for row in rows]
    return "\n\n".join(
        rf"\rttable{{{prose(block.title)}}}{{\begin{{tabular}}{{@{{}}{left}{''.join(sides)}@{{}}}}"
        rf"\toprule {head} \\ \midrule {' '.join(lines[k : k + MOST])} \bottomrule\end{{tabular}}}}"
        for k in range(0, len(lines), MOST)
    )


LONG = 45
"""Letters of a cell that has no room in one line beside others."""

MOST = 30
"""Rows of a table that stand on one page."""

NARROW = 13
"""Letters of a line in the head of a table, where its words allow it."""


TIE = "\ue000"
"""In place of a space at which no line ends."""


def _stacked(words: str) -> list[str]:
    """The head of a column in lines; formulas and units are not broken."""
    whole = re.sub(r"\$[^$]*\$|\([^()]*\)", lambda m: m[0].replace(" ", TIE), words)
    lines = textwrap.wrap(whole, NARROW, break_long_words=False, break_on_hyphens=False)
    return [line.replace(TIE, " ") for line in lines] or [""]


def _head(lines: Sequence[str], side: str) -> str:
    cell = r" \\ ".join(map(prose, lines))
    return rf"\begin{{tabular}}[b]{{@{{}}{side}@{{}}}}{cell}\end{{tabular}}" if lines[1:] else cell


@tex_block.register
def _(block: b.ExerciseHead) -> str:
    parts = (prose(f"{block.label}. {block.title}"), block.anchor, prose(block.asks))
    return r"\rtexercise" + "".join(f"{{{part}}}" for part in (*parts, prose(block.points)))


@tex_block.register
def _(block: b.Legend) -> str:
    items = r"\quad ".join(
        rf"\mbox{{\rtmark{{{verdict}}}}}~{prose(words)}." for verdict, words in block.rows
    )
    return rf"{{\medskip\footnotesize\color{{muted}} {prose(block.head)}: {items}\par}}"


@tex_block.register
def _(block: b.NameLine) -> str:
    return r"\noindent " + r"\quad ".join(rf"{prose(word)}: \hrulefill" for word in block.words)


@tex_block.register
def _(_: b.Room) -> str:
    return r"\par\vskip 45mm plus 1fil"


@tex_block.register
def _(block: b.Results) -> str:
    rows: list[str] = []
    for number, equations, words, verdict in block.rows:
        lines = r" \\ ".join(aligned_lines(equations, "printed", ROOM))
        rows.append(
            rf"\rtmark{{{verdict}}} & \rtcited{{{b.anchor(number)}}}{{({number})}} & "
            rf"\rtrows{{{lines}}} & {rich(words)} \\"
        )
    columns = r"@{}r@{\ }l@{\ \ }l@{\quad}>{\raggedright\arraybackslash}p{43mm}@{}"
    begin = rf"\rtonepage{{\begin{{tabular}}{{{columns}}}"
    return "\n".join([begin, *rows, r"\end{tabular}}"])


ROOM = 62.0
"""Letters of a line in the summary of results."""


@tex_block.register
def _(block: b.Aside) -> str:
    return rf"\rtbox{{{prose(block.title)}}}"


@tex_block.register
def _(_: b.AsideEnd) -> str:
    return r"\rtboxend"


@tex_block.register
def _(block: b.Subhead) -> str:
    return rf"\{'rtsub' if block.level else 'subhead'}{{{prose(block.words)}}}"
