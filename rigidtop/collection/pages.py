r"""What pages of Markdown say by themselves: their sections, their claims and their letters.

A page begins with its section, ``# 2 The Kepler problem``.  What has a number or an anchor is a
claim, and says what stands in front of it.  The letters stand in tables whose first column is
headed "letter"::

    | letter       | meaning             | unit | kind       |
    | ------------ | ------------------- | ---- | ---------- |
    | $m$          | mass of the planet  | kg   | positive   |
    | $r$          | distance to the sun | m    | coordinate |
    | $\mathbf r$  | position            | m    | vector     |

"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from sympy import Symbol

from rigidtop.collection.faults import strange
from rigidtop.collection.kinds import problems
from rigidtop.errors import RigidtopError
from rigidtop.notation.characters import unwritable
from rigidtop.proof import units
from rigidtop.proof.lecture import Fault, Heading, Illustration, Prose, Shown, Text
from rigidtop.proof.page import Claim, Page
from rigidtop.read.statements import statements
from rigidtop.read.tables import TableRow, rows
from rigidtop.terminal.files import text_of
from rigidtop.theory.lettered import Lettered, in_order, matrix, positive, real
from rigidtop.theory.symbols import Glyph
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter
from rigidtop.tree.statement import Statement
from rigidtop.typeset.latex import letter

KINDS = {
    "positive": "a number that is positive",
    "number": "a number of any sign, or a vector that does not change",
    "coordinate": "a coordinate, whose rates have letters too",
    "positive coordinate": "a coordinate that is positive, such as a distance",
    "positive variable": "what depends on the motion and is positive",
    "matrix": "a square matrix",
    "vector": "a vector that moves",
    "frame": "three axes in one row, right-handed and at right angles, which may turn",
    "fixed frame": "three axes that do not turn",
    "variable": "anything else that depends on the motion",
}
"""What a letter can be, as the last column of the table says."""

_SECTION = re.compile(r"^#{1,2}[ \t]+(\d+(?:\.\d+)*)[ \t]+(\S[^\n]*)$", re.M)
_SENTENCE = re.compile(r"(?<=[.!?])\s+(?=[A-Z$])")
_FORMULA = re.compile(r"\$([^$]+)\$")
_LINK = re.compile(r"\[([^\]]+)\]\(#[\w-]+\)")


def pages_of(folder: Path) -> tuple[tuple[str, str, str], ...]:
    """The section, the title and the name of each page of a folder, in the order of sections."""
    pages = []
    for path in sorted(folder.glob("*.md")):
        heading = _SECTION.search(text_of(path))
        if heading is not None:
            pages.append((heading[1], heading[2].strip(), path.stem))
    return tuple(sorted(pages, key=lambda page: [int(part) for part in page[0].split(".")]))


# --- Claims --------------------------------------------------------------------------------------


def page_of(section: str, title: str, text: Text) -> Page:
    """A page with the claims that its text makes."""
    about = next((block.words for block in text.blocks if isinstance(block, Prose)), title)
    return Page(section, title, " ".join(about.split()), tuple(_claims(text)), text=text.name)


def _claims(text: Text) -> Iterator[Claim]:
    """What has a number or an anchor, with the words in front of it, but for those of a picture."""
    words, heading, named = "", "", set[str]()
    for block in text.blocks:
        if isinstance(block, Heading):
            words = heading = block.words
        elif isinstance(block, Illustration):
            words = heading
        elif isinstance(block, Prose):
            words = _SENTENCE.split(block.words)[-1]
        elif isinstance(block, Shown) and block.line is not None:
            for name in dict.fromkeys((block.name, *(e.tag for e in block.line.equations))):
                if name and name not in named:
                    named.add(name)
                    yield Claim(name, " ".join(words.split()).rstrip(".") + ".")


# --- Letters -------------------------------------------------------------------------------------


def table_of(symbols: Sequence[Lettered]) -> str:
    """The table that declares some letters; those of rates are declared with their coordinates."""
    glyphs = {x.quantity.glyph for x in symbols}
    lines = []
    for symbol in symbols:
        quantity, glyph = symbol.quantity, symbol.quantity.glyph
        if glyph.accent in ("dot", "ddot"):
            continue
        kind = "positive" if symbol.is_positive else "vector" if glyph.bold else ""
        if not glyph.bold and replace(glyph, accent="dot") in glyphs:
            kind = f"{kind} coordinate".strip()
        lines.append(f"| ${letter(glyph)}$ | {quantity.meaning} | {quantity.unit} | {kind} |")
    head = ("| letter | meaning | unit | kind |", "| --- | --- | --- | --- |")
    return "\n".join((*head, *lines))


@dataclass(frozen=True)
class Declarations:
    """The letters that pages declare; `numbers` are those that do not change in time.

    The `faults` of their tables have the names of the pages.
    """

    symbols: tuple[Lettered, ...] = ()
    numbers: frozenset[Symbol] = frozenset()
    frames: tuple[tuple[Symbol, Symbol, Symbol], ...] = ()
    faults: tuple[tuple[str, Fault], ...] = ()


def declared(sources: Iterable[tuple[str, str]]) -> Declarations:
    """The letters of some pages, (name, text), in the order in which they are declared.

    Faults are a row that declares none, a letter that is declared twice and not alike, a unit that
    is not known, and what no document can set.
    """
    by_glyph: dict[Glyph, tuple[Lettered, str]] = {}
    faults: list[tuple[str, Fault]] = []
    for name, text in sources:
        for row in rows(text):
            try:
                letters = [*_row(row)]
            except RigidtopError as error:
                faults.append((name, Fault(row.line, str(error), True)))
                continue
            own = [x for x, _ in letters if x.quantity.glyph.accent not in ("dot", "ddot")]
            wrong = [problem for symbol in own for problem in problems(symbol)]
            wrong += map(strange, unwritable(" ".join(row.cells[1:])))
            faults += [(name, Fault(row.line, problem, True)) for problem in wrong]
            for symbol, kind in letters:
                quantity = symbol.quantity
                if units.parsed(quantity.unit or "1") is None:  # so that its lines are read
                    quantity = replace(quantity, unit="")
                    symbol = Lettered(symbol.name, quantity, **symbol.assumptions0)
                other, _ = by_glyph.setdefault(quantity.glyph, (symbol, kind))
                if other.quantity != quantity:
                    problem = (
                        f"{row.cells[0]} is {other.quantity.meaning!r} already: a letter means one "
                        "thing in all pages"
                    )
                    faults.append((name, Fault(row.line, problem, True)))
                    break
    symbols = in_order(*(symbol for symbol, _ in by_glyph.values()))
    kinds = [kind for _, kind in by_glyph.values()]
    fixed = (x for x, kind in zip(symbols, kinds, strict=True) if kind in _FIXED)
    axes = [x for x, kind in zip(symbols, kinds, strict=True) if kind.endswith("frame")]
    frames = zip(axes[::3], axes[1::3], axes[2::3], strict=True)
    return Declarations(symbols, frozenset(fixed), tuple(frames), tuple(faults))


_FIXED = ("positive", "number", "fixed frame")
"""The kinds that do not change in time."""


def _row(row: TableRow) -> Iterator[tuple[Lettered, str]]:
    """The symbols that a row declares, those for rates too, each with its kind."""
    if len(row.cells) != 4:
        raise RigidtopError("a letter has four columns: letter, meaning, unit, kind")
    letters, meaning, unit, kind = row.cells
    kind = kind or "variable"
    if kind not in KINDS:
        raise RigidtopError(f"{kind!r} is no kind of letter: {', '.join(KINDS)}")
    if kind.endswith("frame") and letters.count(",") != 2:
        raise RigidtopError("a frame is three letters in one row, with commas between them")
    for latex in letters.split(","):
        glyph = _glyph(latex.strip())
        bold = kind == "vector" or kind.endswith("frame")
        if glyph.bold != bold and not (glyph.bold and kind == "number"):
            raise RigidtopError(f"{latex.strip()}: a vector is bold, and what is bold is a vector")
        if kind == "matrix":
            yield matrix(_name(glyph), glyph, meaning, unit), kind
            continue
        make = positive if kind.startswith("positive") else real
        unit = "" if unit == "–" else unit
        yield make(_name(glyph), glyph, meaning, unit), kind
        if kind.endswith(("coordinate", "vector")) and unit:
            ending = meaning
            for accent, words in (("dot", "rate of"), ("ddot", "second rate of")):
                unit = _per_second(unit)
                fast = replace(glyph, accent=accent)
                yield real(_name(fast), fast, f"{words} {ending}", unit), "variable"


def _per_second(unit: str) -> str:
    """The unit of the rate of a quantity with this unit."""
    if unit == "1":
        return "1/s"
    for end, longer in (("/s", "/s²"), ("/s²", "/s³")):
        if unit.endswith(end):
            return unit.removesuffix(end) + longer
    over, slash, under = unit.partition("/")
    return f"{over}/({under.strip('()')} s)" if slash else f"{unit}/s"


def _glyph(latex: str) -> Glyph:
    """The glyph of a letter between dollars.  Raises RigidtopError where there is none."""
    formula = _FORMULA.fullmatch(latex)
    read = statements(formula[1]) if formula else ()
    side = read[0].sides[0] if len(read) == 1 and isinstance(read[0], Statement) else None
    prime = isinstance(side, n.Primed) and side.order == 1
    side = side.of if isinstance(side, n.Primed) and prime else side
    if not isinstance(side, Letter) or side.mark not in ("", "hat", "′"):
        raise RigidtopError(f"{latex or 'nothing'} is no letter between dollars, such as $m$")
    accent = "hat" if side.mark == "hat" else ""
    return Glyph(side.base, side.sub, accent, side.bold, prime or side.mark == "′")


def _name(glyph: Glyph) -> str:
    """A name for programs that no other glyph has."""
    parts = (glyph.base, glyph.sub, glyph.accent, "vec" * glyph.bold, "prime" * glyph.prime)
    return "_".join(filter(None, parts))
