r"""An author's macros, and those of common packages, put in before a formula is read.

They are taken from ``\newcommand``, ``\renewcommand``, ``\providecommand``, ``\def``, ``\let`` and
``\DeclareMathOperator``, and put in piece by piece: nothing else of TeX is carried out.  How deep
macros may stand in macros, and how much may come of them, is limited.

>>> from rigidtop.read.tex import pieces
>>> known = defined(r"\newcommand{\dd}[2][t]{\frac{d #2}{d #1}}")
>>> "".join(p.text for p in expanded(pieces(r"\dd{x}+\dd[s]{y}"), known))
'\\frac{}{}+\\frac{}{}'
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import islice

from rigidtop.read.tex import Piece, UnreadError, closing, flat, pieces

DEEPEST = 20
"""Macros are not put into macros deeper."""

LARGEST = 20_000
"""Of one formula no more pieces are made."""

MOST = 2_000
"""Of one file no more macros are taken."""

LONGEST = 2_000
"""A macro is no longer (characters)."""


@dataclass(frozen=True)
class Macro:
    """What stands for a command: `body` with #1 … #`count` in it.

    The first argument may be left out if it has a `default`; `shorter` is for one argument less.
    """

    count: int
    body: tuple[Piece, ...]
    default: tuple[Piece, ...] | None = None
    shorter: Macro | None = None


Macros = Mapping[str, Macro]

_DEFINES = re.compile(
    r"\\(?P<new>(?:re)?newcommand|providecommand|DeclareRobustCommand)\*?\s*"
    r"(?:\{\s*(?P<a>\\(?:[A-Za-z]+|.))\s*\}|(?P<b>\\(?:[A-Za-z]+|.)))"
    r"\s*(?:\[\s*(?P<count>\d)\s*\])?\s*(?:\[(?P<default>[^\[\]\n]{0,100})\])?\s*(?=\{)"
    r"|\\def\s*(?P<c>\\(?:[A-Za-z]+|.))\s*(?P<parts>(?:#\d){0,9})\s*(?=\{)"
    r"|\\let\s*(?P<d>\\[A-Za-z]+)\s*=?\s*(?P<same>\\[A-Za-z]+)"
    r"|\\DeclareMathOperator(?P<star>\*?)\s*\{?\s*(?P<e>\\[A-Za-z]+)\s*\}?\s*(?=\{)"
)
_COMMENT = re.compile(r"(?<!\\)%[^\n]*")


def defined(source: str, known: Macros | None = None) -> dict[str, Macro]:
    """The macros of a text, besides those that are `known`; of two of one name the last."""
    made = dict(known or {})
    text = _COMMENT.sub("", source)
    for match in islice(_DEFINES.finditer(text), MOST):
        name = next(filter(None, (match[group] for group in "abcde")))
        if match["same"]:
            made[name] = made.get(match["same"]) or Macro(0, (Piece(match["same"], 0),))
            continue
        body = _braced(text, match.end())
        if body is None:
            continue
        try:
            found = pieces(body)
            default = None if match["default"] is None else pieces(match["default"])
        except UnreadError:
            continue
        if match["e"]:
            found = (Piece(r"\operatorname", 0), Piece("{}", 0, found))
        count = int(match["count"] or 0) if match["new"] else (match["parts"] or "").count("#")
        if name not in _KEPT:
            made[name] = Macro(count, found, default)
    return made


_KEPT = frozenset(
    "\\" + name
    for name in ["left", "right", "begin", "end", "frac", "sqrt", "text", "mathrm", "tag", "label"]
)
"""Commands that the reader itself rests on, whatever an author makes of them."""


def _braced(text: str, at: int) -> str | None:
    """What stands in the braces that open at a place; None for none, or for too much."""
    end = closing(text, at, at + LONGEST) if text[at : at + 1] == "{" else None
    return None if end is None else text[at + 1 : end]


def expanded(items: Sequence[Piece], macros: Macros) -> tuple[Piece, ...]:
    """The pieces with all macros put in; each has the place of the macro that it comes from."""
    if not macros or not any(piece.text in macros for piece in flat(items)):
        return tuple(items)
    return tuple(_Expansion(macros).of(items, 0))


class _Expansion:
    """Counts what is made, so that it ends."""

    def __init__(self, macros: Macros) -> None:
        self.macros, self.made = macros, 0

    def count(self, piece: Piece) -> Piece:
        self.made += 1
        if self.made > LARGEST:
            raise UnreadError(f"macros that come to more than {LARGEST} pieces", piece.position)
        return piece

    def of(self, items: Sequence[Piece], level: int) -> list[Piece]:
        done: list[Piece] = []
        ahead = [(piece, level) for piece in reversed(items)]
        while ahead:
            piece, deep = ahead.pop()
            self.count(piece)
            macro = self.macros.get(piece.text)
            if macro is None:
                group = tuple(self.of(piece.group, deep)) if piece.group else ()
                done.append(replace(piece, group=group) if group else piece)
                continue
            if deep >= DEEPEST:
                reason = f"the macro {piece.text} stands in itself, or macros deeper than {DEEPEST}"
                raise UnreadError(reason, piece.position)
            body = self.put_in(macro, piece, ahead)
            ahead += [(each, deep + 1) for each in reversed(body)]
        return done

    def put_in(self, macro: Macro, at: Piece, ahead: list[tuple[Piece, int]]) -> list[Piece]:
        while macro.shorter is not None and not _groups_follow(ahead, macro.count):
            macro = macro.shorter
        if macro.count and ahead and ahead[-1][0].text == "*":
            ahead.pop()
        given: list[tuple[Piece, ...]] = []
        if macro.default is not None and macro.count:
            given.append(_optional(ahead) or macro.default)
        while len(given) < macro.count:
            if not ahead:
                raise UnreadError(f"{at.text} without what it is to act on", at.position)
            piece, _ = ahead.pop()
            given.append(piece.group if piece.text == "{}" else (piece,))
        return self.filled(macro.body, given, at.position)

    def filled(
        self, body: Sequence[Piece], given: Sequence[tuple[Piece, ...]], position: int
    ) -> list[Piece]:
        made: list[Piece] = []
        i = 0
        while i < len(body):
            piece = body[i]
            behind = body[i + 1].text if i + 1 < len(body) else ""
            if piece.text == "#" and behind.isdigit() and 0 < int(behind) <= len(given):
                made += [self.count(each) for each in given[int(behind) - 1]]
                i += 2
                continue
            group = tuple(self.filled(piece.group, given, position))
            made.append(self.count(Piece(piece.text, position, group)))
            i += 1
        return made


def _groups_follow(ahead: Sequence[tuple[Piece, int]], count: int) -> bool:
    return len(ahead) >= count and all(piece.text == "{}" for piece, _ in ahead[-count:])


def _optional(ahead: list[tuple[Piece, int]]) -> tuple[Piece, ...] | None:
    """What stands in square brackets next, if anything."""
    if not ahead or ahead[-1][0].text != "[":
        return None
    for i in range(2, min(len(ahead), 60) + 1):
        if ahead[-i][0].text == "]":
            inside = tuple(piece for piece, _ in reversed(ahead[-i + 1 : -1]))
            del ahead[-i:]
            return inside
    return None


def _macro(tex: str, *shorter: str) -> Macro:
    """A macro with the arguments that its text has; `shorter` are those for fewer."""
    count = max(map(int, re.findall(r"#(\d)", tex)), default=0)
    return Macro(count, pieces(tex), None, _macro(*shorter) if shorter else None)


PACKAGES: Macros = {
    "\\" + name: _macro(*bodies)
    for name, *bodies in (
        ("dd", r"\mathrm{d}"),
        ("dv", r"\frac{\mathrm d #1}{\mathrm d #2}", r"\frac{\mathrm d}{\mathrm d #1}"),
        (
            "pdv",
            r"\frac{\partial^2 #1}{\partial #2\partial #3}",
            r"\frac{\partial #1}{\partial #2}",
            r"\frac{\partial}{\partial #1}",
        ),
        *((name, r"\mathbf{#1}") for name in ("vect", "vb")),
        *((name, r"\hat{\mathbf{#1}}") for name in ("uvec", "vu")),
        ("va", r"\vec{#1}"),
        ("abs", r"\lvert #1\rvert"),
        ("norm", r"\lVert #1\rVert"),
        ("qty", ""),
        ("grad", r"\nabla"),
        ("curl", r"\nabla\times"),
        ("cross", r"\times"),
        ("vdot", r"\cdot"),
        ("qq", r"\quad\text{#1}\quad"),
        ("qc", r",\quad"),
    )
}
"""What the packages that physicists load define, such as physics; of each as many as it has
numbers of arguments.  A file's own definitions come before them."""

_CUSTOMARY: Macros = {
    r"\half": _macro(r"\frac{1}{2}"),
    r"\eps": _macro(r"\epsilon"),
}
_SLOPE = re.compile(r"\\d?frac\s*\{\s*\\del(?![A-Za-z])")


def customary(source: str) -> Macros:
    r"""What physicists write without defining it where they write, since all know it.

    A ``\del`` is ∂ in a text that has a fraction of it, and ∇ in others.
    """
    slope = r"\partial" if _SLOPE.search(source) else r"\nabla"
    return {**_CUSTOMARY, r"\del": _macro(slope)}
