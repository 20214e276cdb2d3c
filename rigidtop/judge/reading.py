"""The statements of a text, read with the functions and the letters of the whole."""

from __future__ import annotations

import re
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import zip_longest
from math import inf
from typing import Final

from rigidtop.judge.differentials import in_rates, in_variations
from rigidtop.judge.habits import functions_of, has_length
from rigidtop.read.macros import Macro, Macros, customary, defined
from rigidtop.read.passages import CONSTANT, Passage, passages
from rigidtop.read.phrases import Cue
from rigidtop.read.statements import statements
from rigidtop.read.unmarked import as_tex, is_spelled
from rigidtop.read.walk import places
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.statement import Statement, Unread

LATE = "the time for the file was over"

Read = list[tuple[Passage, Statement | Unread]]
_Macros = frozenset[tuple[str, Macro]]

_SHAPES: Final = {"ϕ": "φ", "ϑ": "θ", "ϵ": "ε"}
"""Letters that are written in two ways."""


def read_text(
    source: str, macros: Macros | None = None, until: float = inf, plain: bool = False
) -> tuple[Read, Callable[[int], tuple[int, int]]]:
    """The statements of a text with their passages, and what tells the line of a position.

    With `plain` mathematics outside of dollars is read too.
    """
    around = passages(source, plain)
    known = defined(source, {**customary(source), **(macros or {})})
    return statements_of(around, known, until), places(source)


def statements_of(text: Sequence[Passage], macros: Macros, until: float = inf) -> Read:
    """What each formula states, read with the functions of the whole text."""
    for nothing in (_MARGIN, _TICKS):
        text = [replace(x, text=nothing.sub(lambda m: " " * len(m[0]), x.text)) for x in text]
    text = _with_units(text)
    text = [replace(x, text=_THIN.sub(_closed_up, x.text)) for x in text]
    if any(_POINT.search(passage.text) for passage in text):
        text = [replace(x, text=_THOUSANDS.sub(_closed_up, x.text)) for x in text]
    own = frozenset(macros.items())
    once = [each for passage in text for each in _read(passage, own, until)]
    known, lettered = functions_of(once), has_length(once)
    read = [
        (passage, _excepted(each) if Cue.EXCEPTED in passage.cues else each)
        for passage in text
        for each in _read(passage, own, until, known, lettered)
    ]
    read = _continued(_written_for(read))
    stated = in_rates(in_variations(x for _, x in read))
    read = [*zip((x for x, _ in read), stated, strict=True)]
    shapes = frozenset(_shapes(each for _, each in read).items())
    return [(passage, _folded(each, shapes)) for passage, each in read] if shapes else read


_WRITES = re.compile(r"\b(?:write|writing|put|use|abbreviate|schreiben?|écri\w+|note)\b", re.I)
_FOR = re.compile(r"\s*(?:for|für|pour|instead of|statt)\s*(?:§|\Z)")


def _written_for(read: Read) -> Read:
    """A text in which "I write $A$ for $B$, $C$ for $D$" says that A = B and C = D."""
    made: list[tuple[Passage, Statement | Unread]] = []
    writing = -1  # the sentence that says so
    for passage, each in read:
        if made and isinstance(each, Statement) and {*each.relations} <= {"="}:
            before, last = made[-1]
            says = _WRITES.search(before.before) or writing == before.sentence
            named = says and _FOR.match(before.behind) and before.sentence == passage.sentence
            if named and isinstance(last, Statement) and len(last.sides) == 1:
                writing = before.sentence
                relations = ("=", *each.relations)
                said = Statement((*last.sides, *each.sides), relations, last.position)
                made[-1] = replace(before, cues=before.cues | {Cue.DEFINED}), said
                continue
        made.append((passage, each))
    return made


_LONGEST_LINK = 40
"""So many characters of words stand at most between a formula and the display that goes on."""


def _continued(read: Read) -> Read:
    """A text in which "$a = b$ (as $c = d$) $= e$" says that b = e: it goes on with a chain.

    What stands in brackets between comes before both; ω ≈ const = w says that ω ≈ w.
    """
    text: Read = []
    for passage, each in read:
        chain = next((k for k in range(len(text))[::-1] if not _is_aside(text[k][0])), None)
        if chain is not None and _goes_on(passage, each, *text[chain]):
            asides, last = text[chain + 1 :], text[chain]
            text[chain:] = [*asides, last]
            match each, last[1]:
                case Statement(sides, (_, *links)), Statement((*_, link, n.Constant()), (*_, said)):
                    each = replace(each, sides=(link, *sides[1:]), relations=(said, *links))
                case Statement(sides), Statement((*_, link)):
                    each = replace(each, sides=(link, *sides[1:]), continues=True)
        text.append((passage, each))
    return text


def _goes_on(
    passage: Passage, each: Statement | Unread, before: Passage, last: Statement | Unread
) -> bool:
    """Whether a formula without a left side goes on with one before it."""
    if not (isinstance(each, Statement) and isinstance(last, Statement) and last.relations):
        return False
    if not isinstance(each.sides[0], n.Omitted) or each.relations[:1] not in (("=",), ("≈",)):
        return False
    words = passage.before.rpartition("§")[2].strip()
    close = passage.display and len(words) <= _LONGEST_LINK and not _ENDS.search(words)
    alone = words == "" or words[-1] == ")" or CONSTANT.fullmatch(words) is not None
    return passage.scope == before.scope and (close or alone)


_ENDS = re.compile(r"[.!?](?:\s|\Z)")
_CLOSED = re.compile(r"[^()§]{0,40}\)")


def _is_aside(passage: Passage) -> bool:
    """Whether a formula stands in brackets, among the words of a sentence."""
    opened = passage.before.rfind("(") > passage.before.rfind(")")
    return opened and bool(_CLOSED.match(passage.behind))


def _excepted(each: Statement | Unread) -> Statement | Unread:
    """An equation that words exclude as what it says then: that both sides differ."""
    if isinstance(each, Statement) and each.relations == ("=",):
        return replace(each, relations=("≠",))
    return each


_MARGIN = re.compile(
    r"\\q?quad\s*(?:\\[bB]ig[glr]?\s*)?(?:\||\\mid|\\vert)\s*(?:[:+/-]|\\cdot|\\times|\\div)"
    r"[^\\&\n]*(?:\\(?!\\)[^\\&\n]*)*"
)
"""What is done with a row, behind a bar in its margin: | : sin θ."""
_TICKS = re.compile(r"[✓✔☑✅∎□■]|\\(?:checkmark|square|blacksquare|qed)(?![a-zA-Z])")
"""Signs that something is so, or shown."""
_POINT = re.compile(r"\d\.\d")
_THOUSANDS = re.compile(r"(?<![\d.])\d{1,3}(?:\{,\}\d{3})+(?!\d)")
"""A comma between thousands, where a point stands before decimals."""
_THIN = re.compile(r"(?<![\d.,}])\d{1,3}(?:\\,\d{3})+(?!\d)")
"""A thin space between thousands."""


_NAME = (
    r"(?:mm|cm|km|m|kg|ms|min|s|h|k?N|[kM]?J|k?W|[kMG]?Pa|k?Hz|rad)"
    r"(?:\^?-?\d|[²³]|⁻[¹²³])?"
)
_UNIT_BEHIND = re.compile(rf"\s*(?P<unit>{_NAME}(?:[ /·]{_NAME})*)(?=[\s,.;:)§]|\Z)")
_MEASURED = re.compile(
    r"[=≈x]\s*-?[\d.,{}]+(?:\s*\\(?:cdot|times)\s*10\s*\^\s*(?:\d|\{-?\d+\}))?\s*\Z"
)
"""A number at the end of a formula."""
_RAISED = str.maketrans({"²": "^2", "³": "^3", "·": " ", "⁻": "^-", "¹": "1"})


def _with_units(text: Sequence[Passage]) -> list[Passage]:
    """Formulas with the units that stand as words behind them: "$k = 120$ N/m", "9.81$ m/s$^2$"."""
    made: list[Passage] = []
    raised = False
    for passage, following in zip_longest(text, text[1:]):
        if raised:  # what raises the unit before
            raised = False
            continue
        unit = _UNIT_BEHIND.match(passage.behind)
        if passage.display or unit is None or not _MEASURED.search(passage.text):
            made.append(passage)
            continue
        name = unit["unit"].translate(_RAISED)
        last = passage.behind.startswith("§", unit.end())
        power = following.text if following is not None and last else ""
        raised = bool(re.fullmatch(r"\^\s*(?:\d|\{-?\d+\})", power))
        written = f"{passage.text}\\,\\mathrm{{{name}{power if raised else ''}}}"
        made.append(replace(passage, text=written))
    return made


def _closed_up(match: re.Match[str]) -> str:
    """A number without commas, and as long as before."""
    return match[0].replace("{,}", "").replace("\\,", "").ljust(len(match[0]))


def _read(
    passage: Passage,
    macros: _Macros,
    until: float,
    functions: frozenset[Letter] = frozenset(),
    lettered: bool = False,
) -> Sequence[Statement | Unread]:
    if time.process_time() > until:
        return (Unread(0, LATE),)
    text = _whole(passage)
    if "\\" in passage.text or (passage.display and not is_spelled(passage.text)):
        return _statements(text, macros, functions, lettered)
    text, before = as_tex(text)
    read = _statements(text, macros, functions, lettered)
    return tuple(replace(each, position=before(each.position)) for each in read)


@lru_cache(maxsize=5_000)
def _statements(
    text: str, macros: _Macros, functions: frozenset[Letter], lettered: bool
) -> Sequence[Statement | Unread]:
    """What a formula states; of a text that is read again, only what is new is gone through."""
    known = dict(macros)
    read = statements(text, known, functions, lettered)
    if lettered and any(_mixes(each) for each in read):
        return statements(text, known, functions, lettered, differentials=False)
    return read


def _mixes(each: Statement | Unread) -> bool:
    """Whether a differential would stand where none can, so that d is a letter.

    It would be a factor in some terms of a sum and not in others, 2Mdx + mx², or in a cosine.
    """
    nodes = [x for side in getattr(each, "sides", ()) for x in n.walked(side)]
    sums = (x.terms for x in nodes if isinstance(x, n.Sum))
    return any(_has_differential(x.of) for x in nodes if isinstance(x, n.Apply)) or any(
        len({_has_differential(term) for term in terms}) > 1 for terms in sums
    )


def _has_differential(node: Node) -> bool:
    """Whether a differential stands in it that belongs to no integral."""
    if isinstance(node, n.Integral):
        return False
    return isinstance(node, n.Differential) or any(map(_has_differential, n.parts(node)))


_INDEX = re.compile(r"(?<![^\W\d_])(?<![_^{])([^\W\d_])(\d)(?![\d.,^])")
"""An index behind a letter in plain text: e1, λ3."""


def _whole(passage: Passage) -> str:
    """The text of a formula; the word "const" behind its last sign is its last side."""
    if not passage.display and "\\" not in passage.text:
        return _INDEX.sub(r"\1_\2", re.sub(r"_([A-Za-z]{2,})", r"_{\1}", passage.text))
    if re.search(r"(=|≡|≈|\\equiv|\\approx)\s*$", passage.text) and re.match(
        r"\W*[ck]onst", passage.behind
    ):
        return passage.text + r"\mathrm{const}"
    return passage.text


def _shapes(read: Iterable[Statement | Unread]) -> dict[str, str]:
    """Which shapes of letters stand for which others: those of which a text has but one."""
    bases = {
        letter.base
        for each in read
        if isinstance(each, Statement)
        for side in each.sides
        for letter in n.letters(side)
    }
    return {one: other for one, other in _SHAPES.items() if not {one, other} <= bases}


@lru_cache(maxsize=5_000)
def _folded(each: Statement | Unread, shapes: frozenset[tuple[str, str]]) -> Statement | Unread:
    """A statement with other shapes of its letters, in its indices too."""
    if isinstance(each, Unread):
        return each
    table = str.maketrans(dict(shapes))

    def change(node: Node) -> Node:
        if not isinstance(node, Letter):
            return node
        return replace(node, base=node.base.translate(table), sub=node.sub.translate(table))

    return replace(
        each,
        sides=tuple(n.mapped(side, change) for side in each.sides),
        conditions=tuple(_folded(x, shapes) for x in each.conditions),  # type: ignore[misc]
    )
