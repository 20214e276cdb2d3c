"""The lecture as a MyST project: pages that a course site or a Jupyter Book takes as they are.

Equations keep the numbers of the notes, and are cited by name: `[](#claim-3-54)`.
"""

from __future__ import annotations

import json
from collections.abc import Sequence

from rigidtop.report import blocks as b
from rigidtop.report import markdown
from rigidtop.typeset import layout as lay
from rigidtop.typeset.latex import align_row, latex


def write(document: b.Document) -> dict[str, str]:
    """The files of the project by their paths, in the folder ``myst``; figures are in figures/."""
    parts: list[tuple[str, list[b.Block]]] = [("index", [])]
    for block in document.blocks:
        if isinstance(block, b.Heading) and block.anchor != parts[-1][0]:
            parts.append((block.anchor, []))
        parts[-1][1].append(block)
    made = {f"myst/{name}.md": _page(blocks) for name, blocks in parts if name != "index"}
    front = [f"# {markdown.words(document.title)}", markdown.words(document.subtitle)]
    front += [document.byline] if document.byline else []
    front += [_page(parts[0][1]), markdown.words(document.colophon)]
    made["myst/index.md"] = "\n\n".join(front) + "\n"
    made["myst/myst.yml"] = _project(document, [name for name, _ in parts])
    return made


def _project(document: b.Document, names: Sequence[str]) -> str:
    """myst.yml; what stands in quotes for JSON does so for YAML."""
    pages = "\n".join(f"    - file: {name}.md" for name in names)
    return (
        f"version: 1\nproject:\n  title: {json.dumps(document.title, ensure_ascii=False)}\n"
        f"  authors:\n    - name: {json.dumps(document.author, ensure_ascii=False)}\n"
        f"  toc:\n{pages}\nsite:\n  template: book-theme\n"
    )


def _page(blocks: Sequence[b.Block]) -> str:
    return "\n\n".join(filter(None, map(_block, blocks))) + "\n"


def _block(block: b.Block) -> str:
    match block:
        case b.Heading():
            title = f"{block.number} {block.title}".strip()
            return f"({block.anchor})=\n# {markdown.words(title)}"
        case b.Subhead():
            return f"## {markdown.words(block.words)}"
        case b.ExerciseHead():
            head = f"{block.label}. {block.title}"
            return f"({block.anchor})=\n### {markdown.words(head)}"
        case b.Display():
            return "\n\n".join(_display(block))
        case b.Figure():
            return (
                f":::{{figure}} ../figures/{block.name}.svg\n:name: {block.anchor}\n"
                f":alt: {block.alternative}\n\n{markdown.words(block.caption)}\n:::"
            )
        case b.Paragraph(mark=b.Mark()) if block.mark is not None:
            return f"{markdown.markdown([block])}\n\n{_margin(block.mark)}"
        case b.Legend():
            return "\n".join(f"- {b.MARKS[v]} {markdown.words(words)}" for v, words in block.rows)
        case b.Results():
            return "\n".join(
                ["| | |", "|---|---|"]
                + [
                    f"| {f'[({n})](#{b.anchor(n)})' if n else ''} | ${latex(e, 'printed')}$ |"
                    for n, e, _, _ in block.rows
                ]
            )
        case b.Symbols():
            return "\n".join(
                ["| | | |", "|---|---|---|"]
                + [
                    f"| ${latex(x)}$ | {markdown.words(words)} | {u} |"
                    for x, words, u in block.rows
                ]
            )
    return markdown.markdown([block])


def _display(block: b.Display) -> list[str]:
    """The sentences and the equations, each with its name; behind it its verdict."""
    made: list[str] = []
    group: list[b.Row] = []
    for k, row in enumerate(block.rows):
        group.append(row)
        after = block.rows[k + 1 : k + 2]
        if not after or after[0].reason or row.tag:
            if group[0].reason:
                made.append(markdown.running(group[0].spoken))
            lines = [
                align_row(line)
                for each in group
                for line in lay.lines(each.equation, each.order, markdown.LINE)
            ]
            options = [f":label: {row.anchor}"] if row.anchor else []
            options.append(f":enumerator: {row.tag}" if row.tag else ":enumerated: false")
            made.append("\n".join(["```{math}", *options, markdown.aligned(lines), "```"]))
            mark = next((each.mark for each in group if each.mark is not None), None)
            if mark is not None:
                made.append(_margin(mark))
            group = []
    return made


def _margin(mark: b.Mark) -> str:
    note = f" {markdown.running(mark.note)}" if mark.note else ""
    return f"```{{margin}}\n{b.MARKS[mark.verdict]} {mark.verdict}{note}\n```"
