"""The lecture as a LaTeX document that needs no more than a basic TeX Live."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import singledispatch
from typing import Any

from rigidtop.notation.characters import MATHS, SUPERSCRIPTS, escape
from rigidtop.present import layout as lay
from rigidtop.present import plain
from rigidtop.present.latex import AlignRow, align, latex
from rigidtop.present.prose import prose
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
)

_PREAMBLE = r"""\documentclass[10pt,a4paper,fleqn]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{lmodern}
\usepackage{microtype}
\usepackage[margin=27mm,bottom=30mm]{geometry}
\usepackage{amsmath,amssymb}
\usepackage{graphicx,booktabs,longtable,array}
\usepackage{xcolor}
\usepackage[unicode,hidelinks]{hyperref}
\definecolor{proved}{HTML}{1E5B3A}
\definecolor{sampled}{HTML}{3E5F2B}
\definecolor{assuming}{HTML}{7A4B00}
\definecolor{convention}{HTML}{5B2D83}
\definecolor{false}{HTML}{8E1B1B}
\definecolor{definition}{HTML}{2B4C7E}
\definecolor{undecided}{HTML}{444444}
\definecolor{muted}{HTML}{555555}
\hypersetup{pdftitle={@TITLE@},pdfauthor={@AUTHOR@},pdfsubject={@SUBJECT@},%
  pdfkeywords={@KEYWORDS@}}
\setlength{\parindent}{0pt}
\setlength{\parskip}{0.45\baselineskip plus 1pt}
\setlength{\mathindent}{2em}
\allowdisplaybreaks[2]
\AtBeginDocument{\setlength{\abovedisplayskip}{3pt plus 2pt}%
  \setlength{\belowdisplayskip}{3pt plus 2pt}}
\raggedbottom
\clubpenalty=10000 \widowpenalty=10000
\emergencystretch=2em
\newcommand{\verdict}[1]{\begingroup\setlength{\fboxsep}{2.5pt}%
  \fcolorbox{#1}{white}{\textcolor{#1}{\footnotesize\textsc{#1}}}\endgroup}
\newcommand{\lab}[1]{\textcolor{muted}{\footnotesize\textsc{#1}}\enspace}
% No whatsit between the rule and the line beneath it, or a page could end there.
\makeatletter
\newcommand{\claim}[4]{\par\if@nobreak\else\pagebreak[2]\fi\vspace{1.1\baselineskip}%
  {\color{muted}\hrule height 0.4pt}\nobreak\vskip 0.35\baselineskip\nobreak
  \noindent\phantomsection\label{#2}\textbf{#1}\hfill\verdict{#4}\nopagebreak\par\nobreak
  \textit{#3}\nopagebreak\par\nobreak}
\newcommand{\held}{\par\nobreak\@afterheading}
\makeatother
% A figure in its own size, or as wide as the page.
\newcommand{\drawn}[1]{\sbox0{\includegraphics{#1}}%
  \ifdim\wd0>\linewidth\resizebox{\linewidth}{!}{\usebox0}\else\usebox0\fi}
% A heading does not end a page: it begins the next one where six lines have no room.  (Glue that
% stretches would make breaks far above the end of a page look better than those at its end.)
\makeatletter
\newcommand{\room}{\par\if@nobreak\else\penalty-100
  \ifdim\dimexpr\pagegoal-\pagetotal<6\baselineskip\break\fi\fi}
\makeatother
% A remark stands at the right of its heading, or beneath it where there is no room.
\newcommand{\heading}[2]{\sbox0{#1}\sbox2{#2}%
  \ifdim\dimexpr\wd0+\wd2+2em>\linewidth #1\\*#2\else #1\hfill#2\fi}
\newcommand{\exercise}[3]{\room\pagebreak[2]\vspace{1.3\baselineskip}%
  {\color{muted}\hrule height 1.2pt}\nobreak\vskip 0.35\baselineskip\nobreak
  \noindent\phantomsection\label{#2}\addcontentsline{toc}{subsubsection}{Exercise: #1}%
  \heading{\textbf{Exercise: #1}}{\textcolor{muted}{\small #3}}\nopagebreak\par\nobreak}
% Above a table, as wide as the page whatever the columns.
\newcommand{\tabletitle}[1]{\makebox[0pt][l]{\parbox[b]{\linewidth}{\raggedright\footnotesize
  \textcolor{muted}{#1}\vspace{3pt}}}}
\newcommand{\subhead}[1]{\room\pagebreak[1]\vspace{0.6\baselineskip}%
  \noindent\textbf{\small #1}\nopagebreak\par\nobreak}
\makeatletter\@beginparpenalty=10000 \makeatother
"""


def write(document: Document, figures: Mapping[str, str]) -> str:
    """The document.  `figures` says where the file of each figure lies, as seen from it."""
    body = "\n\n".join(_shown(block, figures) for block in document.blocks)
    title = prose(document.title)
    return "\n".join(
        [
            _preamble(document),
            r"\begin{document}",
            rf"{{\Large\bfseries\raggedright {title}\par}}",
            rf"{{\large {prose(document.subtitle)}\par}}",
            r"\vspace{0.5\baselineskip}",
            rf"{{\footnotesize\color{{muted}} {prose(document.colophon)}\par}}",
            r"\vspace{0.5\baselineskip}",
            r"{\small\setlength{\parskip}{0pt}\tableofcontents}",
            body,
            r"\end{document}",
            "",
        ]
    )


def _preamble(document: Document) -> str:
    about = {
        "@TITLE@": document.title,
        "@AUTHOR@": document.author,
        "@SUBJECT@": document.subtitle,
        "@KEYWORDS@": "; ".join(document.keywords),
    }
    made = _PREAMBLE
    for place, words in about.items():
        made = made.replace(place, escape_for_bookmark(words))
    return made


def _shown(block: Any, figures: Mapping[str, str]) -> str:
    if isinstance(block, Figure):
        return _figure(block, figures[block.name])
    return tex_block(block)


def _figure(block: Figure, path: str) -> str:
    return "\n".join(
        [
            r"\begin{figure}[!ht]\centering",
            rf"\drawn{{{path}}}",
            r"\par\vspace{2pt}",
            r"\begin{minipage}{0.86\linewidth}\footnotesize",
            prose(block.caption),
            r"\end{minipage}",
            r"\end{figure}",
        ]
    )


def fragment(blocks: Sequence[Any]) -> str:
    """The equations of one claim, to be pasted; what else there is to say stands in comments."""
    made: list[str] = []
    for block in blocks:
        if isinstance(block, Display):
            first, *rest = block.rows
            made.append(f"% {block.label}")
            if first.follows and first.reason:  # no sentence: it would stand alone
                made += [f"% {line}" for line in textwrap.wrap(plain.rich(first.spoken), 88)]
                first = replace(first, reason="")
            made.append(display((first, *rest)))
        else:
            made += [f"% {line}" for line in plain.fragment([block]).splitlines() if line]
    return "\n".join(made) + "\n"


def rich(content: Rich) -> str:
    """Running text with formulas."""
    return "".join(
        prose(piece) if isinstance(piece, str) else f"${latex(piece)}$" for piece in content
    )


@singledispatch
def tex_block(block: Any) -> str:
    """A block as LaTeX."""
    raise TypeError(f"no LaTeX for {type(block).__name__}")


@tex_block.register
def _(block: Heading) -> str:
    command, level = ("section", 1) if block.level == 1 else ("subsection", 2)
    title = prose(f"{block.number}\u2002{block.title}" if block.number else block.title)
    plain = escape_for_bookmark(f"{block.number} {block.title}".strip())
    # Figures that wait for room come before the list of symbols, not behind it.
    begins = "\\clearpage\n" if block.anchor == "symbols" else ""
    return begins + (
        rf"\room\{command}*{{{title}}}\phantomsection\label{{{block.anchor}}}"
        rf"\addcontentsline{{toc}}{{{'sub' * (level - 1)}section}}"
        rf"{{\texorpdfstring{{{title}}}{{{plain}}}}}"
    )


def escape_for_bookmark(text: str) -> str:
    """Bookmarks are Unicode, without mathematics."""
    return "".join(c if c.isalnum() or c in " .,:;()'-" else " " for c in text)


@tex_block.register
def _(block: Paragraph) -> str:
    words = rich(block.content)
    # A labelled paragraph, the reason, is not parted from what it is the reason for.
    return (
        rf"\lab{{{prose(block.label)}}}{words}\nopagebreak"
        if block.label
        else words + r"\held" * block.held
    )


@tex_block.register
def _(block: ClaimHead) -> str:
    parts = (prose(block.shown), block.anchor, prose(block.says), block.verdict)
    return r"\claim" + "".join(f"{{{part}}}" for part in parts)


@tex_block.register
def _(block: Display) -> str:
    label = rf"\lab{{{prose(block.label)}}}" + "\n" if block.label else ""
    return label + display(block.rows)


def display(rows: Sequence[Row]) -> str:
    """The rows in ``align``, smaller where a line is too wide for the page.

    Rows share their = sign as long as that does not make them too wide together.
    """
    together: list[list[AlignRow]] = []
    for row in map(_align_row, rows):
        if together and _width([*together[-1], row]) <= max(WIDE, _width(together[-1])):
            together[-1].append(row)
        else:
            together.append([row])
    return "\n".join(map(_sized, together))


WIDE = 1.12 * lay.LINE
"""A line that is wider than this does not fit in its usual size."""

SIZES = ((1.55 * lay.LINE, "scriptsize"), (1.3 * lay.LINE, "footnotesize"), (WIDE, "small"))
"""From which width on a display is set in which size."""


def _sized(rows: Sequence[AlignRow]) -> str:
    tex = align(rows)
    for width, size in SIZES:
        if _width(rows) > width:
            return rf"{{\{size}" + f"\n{tex}\n}}"
    return tex


def _width(rows: Sequence[AlignRow]) -> float:
    """What rows need that share their = sign, in letters."""
    lines = [line for row in rows for line in row.lines]
    left = max(lay.width(line.left) if line.left else 0 for line in lines)
    return left + 3 + max(lay.width(line.right) for line in lines)


def _align_row(row: Row) -> AlignRow:
    mark = f"({row.verdict})" if row.verdict is not None else ""
    lines = tuple(lay.lines(row.equation, row.order))
    return AlignRow(lines, row.tag, rich(row.spoken), mark)


@tex_block.register
def _(block: Conditions) -> str:
    items = "\n".join(r"\item " + _condition(item) for item in block.items)
    return (
        r"\lab{Assumptions}\par\nobreak\vspace{-0.6\baselineskip}"
        + "\n"
        + r"\begin{itemize}\setlength{\itemsep}{1pt}\setlength{\parskip}{0pt}"
        + f"\n{items}\n"
        + r"\end{itemize}"
    )


def _condition(item: Condition) -> str:
    words = f", {prose(item.words)}" if item.words else ""
    stated = "stated" if item.stated else r"\textbf{not stated}"
    return rf"${latex(item.relation)}${words} ({stated}). " + tex_block(item.without)


@tex_block.register
def _(block: Numbers) -> str:
    values = ", ".join(rf"${latex(name)} = {latex(value)}$" for name, value in block.values)
    sides = block.said(lambda node: f"${latex(node)}$")
    return rf"\lab{{{prose(block.label)}}}{sides}" + (f" at {values}." if values else ".")


@tex_block.register
def _(block: Measures) -> str:
    rows = "\n".join(
        rf"{prose(row.what)} & {_power_of_ten(row.error)} & {_power_of_ten(row.tolerance)} \\"
        for row in block.rows
    )
    return "\n".join(
        [
            rf"\lab{{{prose(block.label)}}}\par\nopagebreak{{\small\hspace*{{2em}}%",
            r"\begin{tabular}{@{}p{0.62\linewidth}rr@{}}",
            rf"\toprule {prose(block.compared)} & error & tolerance \\ \midrule",
            rows,
            r"\bottomrule\end{tabular}\par}",
        ]
    )


def _power_of_ten(number: float) -> str:
    return f"${latex(lay.decimal(number, 2))}$"


@tex_block.register
def _(block: Summary) -> str:
    rows = "\n".join(
        rf"\verdict{{{verdict}}} & {count} & {prose(meaning)} \\[3pt]"
        for verdict, count, meaning in block.rows
    )
    total = sum(count for _, count, _ in block.rows)
    return "\n".join(
        [
            r"\begin{center}\begin{tabular}{@{}lr@{\quad}p{0.68\linewidth}@{}}",
            r"\toprule verdict & claims & what it says \\ \midrule",
            rows,
            rf"\midrule & {total} & \\ \bottomrule",
            r"\end{tabular}\end{center}",
        ]
    )


@tex_block.register
def _(block: FoundList) -> str:
    rows = "\n".join(
        rf"{prose(row.section)} & \hyperref[{row.anchor}]{{{escape(row.name)}}} & "
        rf"\verdict{{{row.verdict}}} & {rich(row.content)} \\[3pt]"
        for row in block.rows
    )
    return "\n".join(
        [
            r"{\small",
            r"\begin{longtable}{@{}l>{\raggedright}p{0.17\linewidth}l"
            r">{\raggedright\arraybackslash}p{0.50\linewidth}@{}}",
            r"\toprule section & claim & verdict & what is amiss \\ \midrule \endhead",
            rows,
            r"\bottomrule\end{longtable}}",
        ]
    )


def _unit(unit: str) -> str:
    """A unit in upright letters."""
    return "".join(map(_unit_character, unit))


def _unit_character(c: str) -> str:
    if c in SUPERSCRIPTS:
        return f"$^{{{SUPERSCRIPTS[c]}}}$"
    return f"${MATHS[c]}$" if c in "−×" else escape(c)


@tex_block.register
def _(block: Symbols) -> str:
    rows = "\n".join(
        rf"${latex(node)}$ & {prose(meaning)} & {_unit(unit)} \\"
        for node, meaning, unit in block.rows
    )
    return "\n".join(
        [
            r"{\small\begin{longtable}{@{}lp{0.68\linewidth}l@{}}",
            r"\toprule symbol & meaning & unit \\ \midrule \endhead",
            rows,
            r"\bottomrule\end{longtable}}",
        ]
    )


@tex_block.register
def _(block: ExerciseHead) -> str:
    return rf"\exercise{{{prose(block.title)}}}{{{block.anchor}}}{{{prose(block.asks)}}}"


@tex_block.register
def _(block: Subhead) -> str:
    return rf"\subhead{{{prose(block.words)}}}"


@tex_block.register
def _(block: Quantities) -> str:
    rows = "\n".join(
        rf"{prose(what)} & {_value(value, '' if unit == '1' else unit)} \\"
        for what, value, unit in block.rows
    )
    return "\n".join(
        [
            rf"\lab{{{prose(block.label)}}}\par\nopagebreak{{\small\hspace*{{2em}}%",
            r"\begin{tabular}{@{}p{0.6\linewidth}r@{\ }l@{}}",
            r"\toprule",
            rows,
            r"\bottomrule\end{tabular}\par}",
        ]
    )


def _value(value: str | lay.Node, unit: str) -> str:
    """A number before its unit, or words."""
    if isinstance(value, str):
        return rf"\multicolumn{{2}}{{l@{{}}}}{{{prose(value)}}}"
    return f"${latex(value)}$ & {_unit(unit)}"


@tex_block.register
def _(block: DataTable) -> str:
    first, *others = (_stacked(words) for words in block.columns)
    head = " & ".join([_head(first, "l"), *(_head(lines, "r") for lines in others)])
    count = len(block.columns)
    together = WHOLE if len(block.rows) <= WHOLE else 3
    rows = "\n".join(
        " & ".join(map(_cell, row)) + (r" \\*" if i < together else r" \\")
        for i, row in enumerate(block.rows)
    )
    # The title is part of the head, or a page could end beneath it.
    title = rf"\multicolumn{{{count}}}{{@{{}}l@{{}}}}{{\tabletitle{{{prose(block.title)}}}}} \\*"
    return "\n".join(
        [
            r"{\scriptsize\setlength{\tabcolsep}{3pt}" if _is_wide(block) else r"{\footnotesize",
            rf"\begin{{longtable}}[l]{{@{{\hspace*{{2em}}}}l*{{{count - 1}}}{{r}}@{{}}}}",
            rf"{title} \toprule {head} \\ \midrule \endfirsthead",
            rf"\toprule {head} \\ \midrule \endhead",
            rows,
            r"\bottomrule\end{longtable}}",
        ]
    )


WHOLE = 14
"""A table of no more rows stays on one page."""

WIDEST = 84
"""Letters of a table in its usual size; a wider one is set smaller."""


def _is_wide(block: DataTable) -> bool:
    heads = (max(_stacked(words), key=len) for words in block.columns)
    columns = zip(heads, *block.rows, strict=True)
    return sum(2 + max(_letters(value) for value in column) for column in columns) > WIDEST


NARROW = 13
"""Letters of a line in the head of a table, where its words allow it."""


def _stacked(words: str) -> list[str]:
    """The head of a column in lines."""
    return textwrap.wrap(words, NARROW, break_long_words=False, break_on_hyphens=False) or [""]


def _head(lines: Sequence[str], side: str) -> str:
    shown = [prose(line) for line in lines]
    if len(shown) == 1:
        return shown[0]
    inner = r" \\ ".join(shown)
    return rf"\begin{{tabular}}[b]{{@{{}}{side}@{{}}}}{inner}\end{{tabular}}"


def _letters(value: str | lay.Node) -> float:
    return len(value) if isinstance(value, str) else lay.width(value)


def _cell(value: str | lay.Node) -> str:
    return prose(value) if isinstance(value, str) else f"${latex(value)}$"
