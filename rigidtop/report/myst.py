"""The lecture as a MyST project: pages that a course site or a Jupyter Book takes as they are.

Equations keep the numbers of the notes, and are cited by name: `[(3.54)](#claim-3-54)`.  Only what
mystmd and Sphinx have alike is used; each claim has a page, to which its mark in the margin leads.
"""

from __future__ import annotations

import json
from collections.abc import Sequence

from rigidtop.report import blocks as b
from rigidtop.report import markdown
from rigidtop.terminal.visible import visible
from rigidtop.typeset.latex import aligned, aligned_lines
from rigidtop.typeset.words import unmarked

CELL = 56.0
"""How many letters wide the equations of a table are."""

Claims = Sequence[tuple[b.ClaimHead, Sequence[b.Block]]]
"""Claims, and what their pages tell: the derivation, what it rests on, what rests on it."""


def write(document: b.Document, claims: Claims = ()) -> dict[str, str]:
    """The files of the project by their paths, in the folder ``myst``; figures are in figures/."""
    parts: list[tuple[str, list[b.Block]]] = [("index", [])]
    for block in document.blocks:
        if isinstance(block, b.SectionHead) and block.anchor != parts[-1][0]:
            parts.append((block.anchor, []))
        parts[-1][1].append(block)
    files = {f"myst/{name}.md": _page(blocks) for name, blocks in parts if name != "index"}
    front = [f"# {markdown.words(document.title)}", markdown.words(document.subtitle)]
    front += [markdown.words(document.byline)] if document.byline else []
    front += [_page(parts[0][1]), markdown.words(document.colophon)]
    files["myst/index.md"] = "\n\n".join(front) + "\n"
    names = [name for name, _ in parts]
    if claims:
        names += ["claims", *(_path(head.anchor) for head, _ in claims)]
        files["myst/claims.md"] = _list_of(claims)
        for head, blocks in claims:
            stands = any(f"({head.anchor})=" in page for page in files.values())
            files[f"myst/{_path(head.anchor)}.md"] = _claim(head, blocks, stands)
    files["myst/myst.yml"] = _project(document, names)
    # The contents for a Jupyter Book before its version 2, and for Sphinx.
    pages = "".join(f"  - file: {name}\n" for name in names[1:])
    files["myst/_toc.yml"] = f"format: jb-book\nroot: index\nchapters:\n{pages}"
    return {path: visible(text) for path, text in files.items()}


def _project(document: b.Document, names: Sequence[str]) -> str:
    """myst.yml; what stands in quotes for JSON does so for YAML."""
    pages = "\n".join(f"    - file: {name}.md" for name in names)
    about = (document.title, document.author)
    title, author = (json.dumps(unmarked(x), ensure_ascii=False) for x in about)
    by = f"  authors:\n    - name:\n        literal: {author}\n"
    return (
        f"version: 1\nproject:\n  title: {title}\n"
        f"{by if document.author in document.byline else ''}"
        # Equations and figures bring their own numbers.
        f"  numbering:\n    equation: false\n    figure: false\n"
        f"  toc:\n{pages}\nsite:\n  template: book-theme\n"
    )


def _path(anchor: str) -> str:
    """The path of the page on which a claim stands."""
    return anchor.replace("claim-", "claims/", 1)


def page_of(anchor: str) -> str:
    """The anchor of the page of a claim, of which `anchor` is its place in the text."""
    return f"page-of-{anchor}"


def _list_of(claims: Claims) -> str:
    items = "\n".join(
        f"- {b.MARKS[head.verdict]} [{_title(head)}](#{page_of(head.anchor)}): {head.verdict}"
        for head, _ in claims
    )
    return f"# Every claim\n\n{items}\n"


def _title(head: b.ClaimHead) -> str:
    says = markdown.words(head.says.rstrip("."))
    return f"{head.shown} {says}" if b.is_number(head.name) else says


def _claim(head: b.ClaimHead, blocks: Sequence[b.Block], stands: bool) -> str:
    title = f"({page_of(head.anchor)})=\n# {_title(head)}"
    verdict = f"**{b.MARKS[head.verdict]} {head.verdict}**, `{head.name}`"
    verdict += f", [in the text](#{head.anchor})" if stands else ""
    return "\n\n".join([title, verdict, markdown.markdown(blocks)]) + "\n"


def _page(blocks: Sequence[b.Block]) -> str:
    above = next((block.level - 1 for block in blocks if isinstance(block, b.SectionHead)), 0)
    parts, depth = [], 0
    for block in blocks:
        depth += isinstance(block, b.Aside)
        parts.append(_block(block, above, depth))
        depth -= isinstance(block, b.AsideEnd)
    return "\n\n".join(filter(None, parts)) + "\n"


def _block(block: b.Block, above: int, depth: int = 0) -> str:
    """A block of a page as many levels below the title of the whole, in so many boxes."""
    fence = "`" * (6 - depth)  # the outer one is longer
    match block:
        case b.SectionHead():
            title = f"{block.number} {block.title}".strip()
            return f"({block.anchor})=\n# {markdown.words(title)}"
        case b.Subhead():
            return f"{'#' * (block.level - above)} {markdown.words(block.words)}"
        case b.Aside():
            return f"{fence}{{admonition}} {markdown.words(block.title)}\n:class: dropdown\n"
        case b.AsideEnd():
            return fence
        case b.ExerciseHead():
            head = f"{block.label}. {block.title}"
            level = "#" * (block.level - above)
            return f"({block.anchor})=\n{level} {markdown.words(head)}"
        case b.Display():
            return "\n\n".join(_display(block, bool(depth)))
        case b.Figure():
            label = f"**{block.label}.** " if block.label else ""
            return (
                f"```{{figure}} ../figures/{block.name}.svg\n:name: {block.anchor}\n"
                f":alt: {block.alternative}\n\n{label}{markdown.words(block.caption)}\n```"
            )
        case b.Paragraph(mark=b.MarginMark()) if block.mark is not None:
            return f"{_margin(block.mark, bool(depth))}\n\n{markdown.markdown([block])}"
        case b.Legend():
            return "\n".join(f"- {b.MARKS[v]} {markdown.words(words)}" for v, words in block.rows)
        case b.Results():
            cells = (
                (name, aligned(aligned_lines(equations, "printed", CELL)).replace("\n", " "))
                for name, equations, _, _ in block.rows
            )
            rows = (f"| [({name})](#{b.anchor(name)}) | ${cell}$ |" for name, cell in cells)
            return "\n".join(["| | |", "|---|---|", *rows])
    return markdown.markdown([block])


def _display(block: b.Display, boxed: bool) -> list[str]:
    """The sentences and the equations, each with its name; before them its verdict."""
    parts: list[str] = []
    for group in b.groups(block):
        first, last = group[0], group[-1]
        parts += [_margin(row.mark, boxed) for row in group if row.mark is not None][:1]
        parts += [markdown.running(first.spoken)] if first.reason else []
        lines = aligned_lines([row.equation for row in group], last.order, markdown.LINE)
        number = rf" \tag{{{last.tag}}}" if last.tag else ""
        # Sphinx puts what has \\ into a split, in which there is no \tag.
        equation = aligned(lines).replace("\\\\\n", "\\cr\n") + number
        place = [f"({last.anchor})="] if last.anchor else []
        parts.append("\n".join([*place, "```{math}", equation, "```"]))
    return parts


def _margin(mark: b.MarginMark, boxed: bool) -> str:
    """What stands beside a line; a box has no margin, so it stands above the line there."""
    note = f" {markdown.running(mark.note)}" if mark.note else ""
    verdict = f"{b.MARKS[mark.verdict]} [{mark.verdict}](#{page_of(b.anchor(mark.name))})"
    directive = "container" if boxed else "sidebar"
    return f"```{{{directive}}}\n{verdict}{note}\n```"
