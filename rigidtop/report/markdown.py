"""Claims and solutions as Markdown with LaTeX between dollars: what a notebook shows.

Notebooks take MathML and styles away from pages that are not trusted, as those that somebody else
has executed; Markdown they show in any case, in the colours of their theme.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

from rigidtop.report import blocks as b
from rigidtop.terminal.visible import visible
from rigidtop.typeset.latex import aligned, aligned_lines, latex
from rigidtop.typeset.words import tex, written

LINE = 84.0
"""How many letters wide an equation may be before it is broken."""


def markdown(blocks: Sequence[b.Block]) -> str:
    """The blocks of a claim or of an exercise, one below the other."""
    return visible("\n\n".join(map(_block, blocks)))


def words(content: str) -> str:
    r"""Running text with the mathematics in it.

    >>> print(words(r"$\ddot\theta$ vanishes, [as] $\sin\theta \neq 0$"))
    $\ddot\theta$ vanishes, &#91;as&#93; $\sin\theta \neq 0$
    """
    return written(content, lambda part: f"${tex(part)}$", _plain)


def _plain(text: str) -> str:
    """What means something in Markdown, as entities."""
    return "".join(f"&#{ord(c)};" if c in "\\*_`$|<>&[]#" else c for c in text)


running = b.Script(
    words=words,
    formula=lambda node: f"${latex(node)}$",
    unit=_plain,
    cited=lambda place: f"[{_plain(place.words)}](#{place.anchor})",
)


def _label(label: str) -> str:
    return f"*{words(label)}.* " if label else ""


def _block(block: b.Block) -> str:
    match block:
        case b.ClaimHead():
            verdict = f"{b.MARKS[block.verdict]} {block.verdict}"
            return f"**{_plain(block.shown)}** — **{verdict}**\n\n*The claim.* {words(block.says)}"
        case b.Paragraph():
            return _label(block.label) + running(block.content)
        case b.Display():
            return "\n\n".join(filter(None, [_label(block.label).strip(), *map(_row, block.rows)]))
        case b.Items():
            items = "\n".join(f"- {running(item)}" for item in block.items)
            return f"{_label(block.label).strip()}\n\n{items}"
        case b.ExerciseHead():
            return f"**{words(block.title)}** ({words(block.asks)})"
        case b.Subhead():
            return f"**{words(block.words)}**"
        case b.Aside():
            return f"<details><summary>{words(block.title)}</summary>"
        case b.AsideEnd():
            return "</details>"
        case b.TableBlock():
            rows = [[running(cell).strip() for cell in row] for row in block.cells]
            if block.kind == "values":
                return _table((words(block.title), "", ""), rows, block.right)
            title = f"*{words(block.title)}*\n\n" if block.title else ""
            return title + _table([*map(words, block.head)], rows, block.right)
    raise TypeError(f"no Markdown for {type(block).__name__}")


def _row(row: b.DisplayRow) -> str:
    lines = aligned_lines([row.equation], row.order, LINE)
    lines[-1] += rf" && \text{{({row.tag})}}" if row.tag else ""
    lines[-1] += rf" && \text{{{row.verdict}}}" if row.verdict is not None else ""
    return "\n\n".join(filter(None, [running(row.spoken), f"$$\n{aligned(lines)}\n$$"]))


def _table(head: Sequence[str], rows: Sequence[Sequence[str]], right: Collection[int]) -> str:
    rule = "|".join("--:" if k in right else ":--" for k in range(len(head)))
    lines = [f"| {' | '.join(row)} |" for row in (head, *rows)]
    return "\n".join([lines[0], f"|{rule}|", *lines[1:]])
