"""A class: a folder of answers as a table, as a page for each student, and what goes wrong most."""

from __future__ import annotations

import csv
import os
import re
import sys
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path

from rigidtop.commands.annotation import marked_page
from rigidtop.errors import RigidtopError
from rigidtop.mark.marking import Marked, Marking, kind
from rigidtop.terminal.files import check_folder, text_of, write_all

COLUMNS = ("file", "points", "of", "passed", "wrong line", "slips", "summary")
SUFFIXES = (".tex", ".md")


@dataclass(frozen=True)
class Sheet:
    """A student's file, with its marks, or why it has none."""

    name: str
    source: str = ""
    marking: Marking | None = None
    problem: str = ""

    @property
    def slips(self) -> tuple[Marked, ...]:
        """The lines with a slip that is named."""
        lines = self.marking.lines if self.marking else ()
        return tuple(line for line in lines if line.slip)

    @property
    def cells(self) -> tuple[object, ...]:
        """The cells of its row of the table, under `COLUMNS`."""
        if self.marking is None:
            return self.name, 0, 0, False, "", "", self.problem
        wrong = self.marking.first_wrong
        words = "; ".join(dict.fromkeys(line.slip for line in self.slips))
        line = wrong.line if wrong is not None else ""
        return (
            *(self.name, *self.marking.points, self.marking.passed),
            *(line, words, self.marking.summary),
        )


def write_class(folder: Path, judge: Callable[[str, str], Marking], output: Path | None) -> bool:
    """A row of CSV for each answer of a folder; below it, on stderr, the commonest slips.

    With an `output` that folder has a page for each, and one for the class, all written at the
    end.  `judge` has the marks of a text, whose name it is told.  True if each could be marked.
    """
    paths = sorted(folder.iterdir())
    files = [path for path in paths if path.suffix in SUFFIXES]
    if not files:
        raise RigidtopError(f"{folder}: no answers in it, .tex or .md")
    if output is not None:
        if output.resolve() == folder.resolve():
            raise RigidtopError(f"{output} has the answers: write the pages elsewhere")
        check_folder(output)
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(COLUMNS)
    sheets = []
    for path in files:
        sheets.append(_sheet(path, judge))
        writer.writerow([_cell(x) if isinstance(x, str) else x for x in sheets[-1].cells])
    unmarked = sum(sheet.marking is None for sheet in sheets)
    kinds = Counter(slip for sheet in sheets for slip in {line.slip for line in sheet.slips})
    listed = ", ".join(f"{words} ({count})" for words, count in kinds.most_common())
    count = f"{_answers(len(files))}{f', {unmarked} of them not marked' * bool(unmarked)}"
    print(f"{count}; slips: {listed or 'none that is named'}", file=sys.stderr)
    if output is not None:
        others = [Sheet(path.name, problem="neither .tex nor .md") for path in _left(paths, files)]
        pages = _pages(folder.resolve().name, sheets, others)
        write_all(output, {name: page.encode() for name, page in pages.items()})
        print(output / "index.html", file=sys.stderr)
    return not unmarked


def _sheet(path: Path, judge: Callable[[str, str], Marking]) -> Sheet:
    name = os.fsencode(path.name).decode("utf-8", "replace")
    try:
        if path.is_symlink() and path.resolve().parent != path.parent.resolve():
            raise RigidtopError(f"{name} is a link that leads out of the folder")
        source = text_of(path)
        return Sheet(name, source, judge(name, source))
    except RigidtopError as error:
        return Sheet(name, problem=str(error))


def _answers(count: int) -> str:
    return f"{count} answer{'s' * (count != 1)}"


def _cell(value: str) -> str:
    """Text that a spreadsheet does not take for a formula."""
    return f"'{value}" if value[:1] in ("=", "+", "-", "@", "\t", "\r") else value


def _left(paths: Sequence[Path], files: Sequence[Path]) -> list[Path]:
    """What lies in the folder besides answers, apart from hidden files."""
    return [path for path in paths if path not in files and not path.name.startswith(".")]


# --- Pages ---------------------------------------------------------------------------------------


def _pages(title: str, sheets: Sequence[Sheet], others: Sequence[Sheet]) -> dict[str, str]:
    """The page of the class, and one for each answer that was marked, by the names of the files."""
    names: dict[str, Sheet] = {}
    for sheet in sheets:
        if sheet.marking is not None:
            names[_page_name(sheet.name, names)] = sheet
    pages = {
        name: marked_page(sheet.name, sheet.source, sheet.marking)
        for name, sheet in names.items()
        if sheet.marking is not None
    }
    left = [*(sheet for sheet in sheets if sheet.marking is None), *others]
    return {"index.html": _index(title, names, left), **pages}


def _page_name(name: str, taken: dict[str, Sheet]) -> str:
    """The name of a page: that of the file, as far as it is no more than letters and the like."""
    stem = re.sub(r"[^\w-]+", "_", name.rpartition(".")[0])[:50] or "_"
    alike = {"index.html", *map(str.casefold, taken)}
    tried = (f"{stem}{f'-{k}' * (k > 1)}.html" for k in range(1, len(taken) + 3))
    return next(page for page in tried if page.casefold() not in alike)


def _index(title: str, names: dict[str, Sheet], left: Sequence[Sheet]) -> str:
    """The class: the commonest slips, the marks, and what was not marked."""
    from rigidtop.report.html import page

    passed = sum(sheet.marking is not None and sheet.marking.passed for sheet in names.values())
    summary = f"{_answers(len(names))} marked, {passed} passed"
    heads = ("answer", "points", "passed", "wrong line", "what is said")
    whole = f"""<main class="page" id="content">
<header class="summary"><h1>{_text(title)}, marked</h1>
<p>{summary}{f"; not marked: {len(left)}" * bool(left)}.</p></header>
<h2>The commonest slips</h2>
{_table(("slip", "answers", "an example"), _slips(names)) or "<p>None that is named.</p>"}
<h2>The marks</h2>
{_table(heads, map(_row, names, names.values()))}
{"<h2>Not marked</h2>" * bool(left)}
{_table(("file", "why"), ([_text(each.name), _text(each.problem)] for each in left))}
</main>
"""
    styles = ("page.css", "print.css", "annotated.css")
    return page(f"{title}, marked", styles, whole, what="marks")


def _row(name: str, sheet: Sheet) -> list[str]:
    _, points, of, passed, wrong, slips, summary = map(str, sheet.cells)
    words = f"{summary}: {slips}" if slips else summary
    mark = "✓" if passed == "True" else "✗"
    return [_link(name, sheet), f"{points} of {of}", mark, _text(wrong), _text(words)]


def _slips(names: dict[str, Sheet]) -> Iterator[list[str]]:
    """The kinds of slips, the commonest first, each with the first line in which it stands."""
    firsts: dict[str, tuple[str, Sheet, Marked]] = {}
    counts: Counter[str] = Counter()
    for name, sheet in names.items():
        counts.update({kind(line.slip) for line in sheet.slips})
        for line in sheet.slips:
            firsts.setdefault(kind(line.slip), (name, sheet, line))
    for words, count in counts.most_common():
        name, sheet, line = firsts[words]
        where = f"{_link(name, sheet)}, line {line.line}: {_text(line.slip)}"
        right = f"<br/>right: {_formula(line.right)}" if line.right else ""
        yield [words, str(count), f"{where}<br/>written: {_text(line.said)}{right}"]


def _formula(tex: str) -> str:
    from rigidtop.report.transcript import transcript

    return transcript(tex, {}) or f"<code>{_text(tex)}</code>"


def _link(name: str, sheet: Sheet) -> str:
    return f'<a href="{escape(name)}">{_text(sheet.name)}</a>'


def _text(words: str) -> str:
    from rigidtop.terminal.visible import visible

    return escape(visible(" ".join(words.split())))


def _table(head: Sequence[str], rows: Iterator[list[str]]) -> str:
    """Cells in HTML as a table; nothing where there is no row."""
    body = "\n".join(f"<tr>{''.join(f'<td>{x}</td>' for x in row)}</tr>" for row in rows)
    heads = "".join(f'<th scope="col">{name}</th>' for name in head)
    table = f"<table><thead><tr>{heads}</tr></thead>\n<tbody>\n{body}\n</tbody></table>"
    return table if body else ""
