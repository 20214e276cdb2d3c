r"""Files as authors have them: LaTeX in several files, notebooks, Markdown.

A LaTeX file brings the files that it takes in with ``\input``, ``\include`` or ``\usepackage``, as
far as they lie within its folder.  Of a notebook the cells of text are taken.
"""

from __future__ import annotations

import json
import re
from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

from rigidtop.errors import RigidtopError
from rigidtop.read.labels import Counted, counted
from rigidtop.read.macros import PACKAGES, Macros, defined
from rigidtop.read.walk import LONGEST
from rigidtop.terminal.files import text_of

DEEPEST = 8
"""Files are not taken into files deeper."""

MOST = 200
"""No more files are taken in."""

LARGEST = 10_000_000
"""All files together have no more characters."""

_TAKES_IN = re.compile(
    r"\\(input|include|subfile|usepackage|RequirePackage)\s*(?:\[[^\]\n]*\]\s*)?"
    r"\{([^{}\n]{1,200})\}"
)
_COMMENT = re.compile(r"(?<!\\)%[^\n]*")


@dataclass(frozen=True)
class TextFile:
    """The text of one file; `cells` are the lines in which a notebook's cells begin."""

    path: Path
    text: str
    cells: tuple[int, ...] = ()

    @property
    def is_text(self) -> bool:
        """Whether it has more than definitions, as a style has."""
        return self.path.suffix not in (".sty", ".cls")

    def place(self, line: int) -> tuple[int, int]:
        """In which cell of text a line stands, counted from 1, and in which line of it.

        >>> TextFile(Path("a.ipynb"), "one\\n\\ntwo", (1, 3)).place(3)
        (2, 1)
        """
        cell = bisect_right(self.cells, line)
        return cell, line - self.cells[cell - 1] + 1


def sources(path: Path | str, text: str | None = None) -> tuple[TextFile, ...]:
    """A file, and those that it takes in, in order.  Raises RigidtopError for what is no text.

    With `text` that is what stands in the file, whatever has been saved.
    """
    top = Path(path)
    if top.suffix == ".ipynb":
        return (_notebook(top),)
    found = [TextFile(top, text_of(top) if text is None else text)]
    if top.suffix in _LATEX:
        folder = top.resolve().parent
        _take_in(found, found[0], folder, {top.resolve()}, 1)
    if sum(len(source.text) for source in found) > LARGEST:
        raise RigidtopError(f"{path}: its files have more than {LARGEST} characters together")
    return tuple(found)


def _take_in(
    found: list[TextFile], source: TextFile, folder: Path, seen: set[Path], depth: int
) -> None:
    if depth > DEEPEST:
        return
    for _, _, inner in _inputs(source, folder):
        if inner is None or inner in seen or len(found) >= MOST:
            continue
        seen.add(inner)
        found.append(TextFile(inner, text_of(inner)))
        _take_in(found, found[-1], folder, seen, depth + 1)


def _inputs(source: TextFile, folder: Path) -> Iterator[tuple[re.Match[str], str, Path | None]]:
    """Where a file takes others in, in order, by which name, and which, if they are there."""
    bare = _COMMENT.sub(lambda found: " " * len(found[0]), source.text)
    for match in _TAKES_IN.finditer(bare):
        for name in match[2].split(","):
            yield match, name, _within(folder, source.path.resolve().parent, name.strip())


def left_out(source: TextFile, found: tuple[TextFile, ...]) -> Iterator[tuple[int, str]]:
    """Where a file takes in what was not read, a package aside, and why it was not."""
    if found[0].path.suffix not in _LATEX:
        return
    taken = {each.path.resolve() for each in found}
    for match, name, inner in _inputs(source, found[0].path.resolve().parent):
        if match[1].endswith("ackage") or inner in taken:
            continue
        why = "there is no such file in the folder"
        if inner is not None:
            why = f"files are taken in no deeper than {DEEPEST}, and no more than {MOST}"
        yield match.start(), f"\\{match[1]}{{{name.strip()}}} is not read: {why}"


@dataclass(frozen=True)
class FilePart:
    """A piece of a file: where it stands in the whole, and where in the file."""

    at: int
    source: TextFile
    start: int
    text: str


@dataclass(frozen=True)
class Whole:
    """The text of files that belong together, each where it is taken in, styles left out."""

    parts: tuple[FilePart, ...]

    @cached_property
    def text(self) -> str:
        return "".join(part.text for part in self.parts)

    def part(self, position: int) -> FilePart:
        """The piece in which a place of the whole lies."""
        return self.parts[bisect_right(self.parts, position, key=lambda part: part.at) - 1]

    def origin(self, position: int) -> tuple[TextFile, int]:
        """The file of a place of the whole, and the place in it."""
        part = self.part(position)
        return part.source, position - part.at + part.start


def whole(found: tuple[TextFile, ...]) -> Whole:
    """The files as one text."""
    left = {source.path.resolve(): source for source in found[1:] if source.is_text}
    parts: list[FilePart] = []

    def lay(source: TextFile, start: int, end: int) -> None:
        at = parts[-1].at + len(parts[-1].text) if parts else 0
        parts.append(FilePart(at, source, start, source.text[start:end]))

    def lay_out(source: TextFile) -> None:
        at = 0
        for match, _, inner in _inputs(source, found[0].path.resolve().parent) if left else ():
            if inner is not None and inner in left:
                lay(source, at, match.start())
                lay_out(left.pop(inner))
                at = match.end()
        lay(source, at, len(source.text))

    lay_out(found[0])
    return Whole(tuple(part for part in parts if part.text) or tuple(parts[:1]))


def macros_of(found: tuple[TextFile, ...]) -> Macros:
    """The macros of files that belong together."""
    macros: Macros = PACKAGES
    for source in found:
        macros = defined(source.text, macros)
    return macros


def numbers(found: tuple[TextFile, ...]) -> dict[Path, list[Counted]]:
    """The rows of each file that bear a number, counted through all where they are taken in."""
    laid = whole(found)
    made: dict[Path, list[Counted]] = {source.path: [] for source in found}
    for row in counted(laid.text) if len(laid.text) <= LONGEST else ():
        part = laid.part(row.start)
        by = part.start - part.at
        if row.end <= part.at + len(part.text):
            made[part.source.path].append(replace(row, start=row.start + by, end=row.end + by))
    return made


def _within(folder: Path, beside: Path, name: str) -> Path | None:
    """The file of that name, if it lies within the folder."""
    for start in (folder, beside):
        for ending in ("", ".tex", ".sty"):
            path = start / (name + ending)
            try:
                path = path.resolve()
                if path.is_relative_to(folder) and path.is_file() and path.suffix in _TAKEN:
                    return path
            except (OSError, ValueError):
                continue
    return None


_TAKEN = frozenset({".tex", ".sty", ".ltx", ".cls"})
_LATEX = frozenset({".tex", ".ltx", ".latex"})


def _notebook(path: Path) -> TextFile:
    try:
        content = json.loads(text_of(path))
        cells = [c["source"] for c in content["cells"] if c["cell_type"] == "markdown"]
        texts = ["".join(cell) for cell in cells]
    except (ValueError, TypeError, KeyError, RecursionError):
        raise RigidtopError(f"cannot read {path}: it is no Jupyter notebook") from None
    lines, line = [], 1
    for text in texts:
        lines.append(line)
        line += text.count("\n") + 2
    return TextFile(path, "\n\n".join(texts), tuple(lines))
