"""The tokens of some lines, cut into equations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from rigidtop.read.cursor import Token
from rigidtop.read.signs import CONDITIONS
from rigidtop.read.tex import UnreadError, words
from rigidtop.read.values import OMITTED


@dataclass(frozen=True)
class Part:
    """The tokens of one equation."""

    tokens: tuple[Token, ...]
    tag: str = ""
    problem: UnreadError | None = None
    condition: str = ""

    @property
    def kinds(self) -> list[str]:
        return [token.kind for token in self.tokens]


_GOES_ON = frozenset({"RELATION", "SIGN", "SIGNS", "CROSS", "DOT", "SLASH"})
"""A line that begins with one of these, or whose last line ended with one, goes on."""

_BREAKS = frozenset({"LINE", "SEPARATOR", "ARROW"})
_BLANK = frozenset({"SPACE", "ALIGN"})
_OPENS = {"MATRIX": 1, "XIRTAM": -1, "OPEN": 1, "CLOSE": -1, "LIST": 1, "TSIL": -1}
_OPENS |= {"_BEGIN": 1, "_END": -1, "OF": 1, "FO": -1, "BAR": 1, "RAB": -1}


def parts(found: Sequence[Token], text: str) -> list[Part]:
    """Tokens cut at separators, at arrows and at ends of lines, tags taken out."""
    cutter = _Cutter(found, text)
    for i in range(len(found)):
        cutter.take(i)
    cutter.close()
    return cutter.parts


class _Cutter:
    """Goes through the tokens of some lines and cuts them into equations."""

    def __init__(self, found: Sequence[Token], text: str) -> None:
        self.found, self.text = found, text
        self.parts: list[Part] = []
        self.current: list[Token] = []
        self.tag, self.nested, self.bracketed = "", 0, 0
        self.problem: UnreadError | None = None
        self.ahead = _ahead(found)
        """For each token the kind of the next one that is not blank, and whether a relation
        stands between it and the next break."""

    def take(self, i: int) -> None:
        token = self.found[i]
        kind = token.kind
        self.nested += _OPENS.get(kind, 0)
        self.bracketed += {"OPEN": 1, "CLOSE": -1}.get(kind, 0)
        inside = self.nested > 0
        if self.condition is not None:
            if (inside or kind not in ("LINE", "ARROW", "TAG")) and token is not self.found[-1]:
                return
            whole = token is self.found[-1] and kind not in ("LINE", "ARROW", "TAG")
            self._conditioned(len(self.text) if whole else token.position)
            if whole:
                return
        if kind == "TAG":
            self.tag = token.value
        elif kind == "WORDS":
            if self.current and self.ahead[i][0] in _GOES_ON:
                reason = "words in the middle of a formula"
                self.current.append(Token("UNREAD", UnreadError(reason, token.position), 0))
                return
            self.close()
            self._worded = True
            if token.value.split()[0].lower() in CONDITIONS:
                self.condition = token.position
                if token is self.found[-1]:
                    self._conditioned(len(self.text))
        elif kind == "ARROW":
            self.close()
        elif kind == "SEPARATOR":
            if self._is_list(i):
                self.condition = self.current[0].position
                self.current = []
                if not self.parts:
                    reason = "a list of values: for which values something holds is no equation"
                    self.parts.append(Part((token,), problem=UnreadError(reason, self.condition)))
                return
            self.close(stop=token.value)
        elif kind == "LINE" and not inside:
            self._line(i)
        elif inside and kind in ("LINE", "ALIGN") and self.nested == self.bracketed:
            return  # a bracket may be closed on another line, the entries of a matrix may not
        elif kind in _BLANK:
            if kind == "SPACE" and self._comma != "NUMBER":
                self._comma = ""
            if not inside and not self._goes_on(i):
                self.close()
                self._column = kind == "ALIGN"
        else:
            self.current.append(token)

    def _goes_on(self, i: int) -> bool:
        behind = self.current[-1].kind if self.current else ""
        return behind in _GOES_ON or self.ahead[i][0] in _GOES_ON | {"TAG", ""}

    def _line(self, i: int) -> None:
        kind, related = self.ahead[i]
        if self._worded and kind == "RELATION":
            reason = "a line that goes on behind words: with which equation in front?"
            self.problem = UnreadError(reason, self.found[i].position)
        self._worded = False
        if not self._goes_on(i) or kind == "TAG":
            self.close()
        elif kind == "SIGN" and related and self.current:
            # "a = b \\\\ -c &= d" begins anew, "a &= b \\\\ & - c = d" goes on.
            alignments = [
                token.kind
                for token in self.found[i + 1 : self._end(i + 1)]
                if token.kind != "SPACE"
            ]
            if alignments[0] == "ALIGN":
                return
            if "ALIGN" not in alignments:
                sign = next(t for t in self.found[i:] if t.kind == "SIGN")
                self.problem = UnreadError(
                    "a line that begins with a sign and has a relation of its own: put & before "
                    "the sign if it goes on, & before the relation if it begins anew",
                    sign.position,
                )
                return
            self.close()

    def _end(self, start: int) -> int:
        for i in range(start, len(self.found)):
            if self.found[i].kind in _BREAKS:
                return i
        return len(self.found)

    def close(self, stop: str = "") -> None:
        """What was taken so far is an equation."""
        kept, self.current = self.current, []
        unread = next((token.value for token in kept if token.kind == "UNREAD"), self.problem)
        part = Part(tuple(kept), self.tag, unread)
        number = _bracketed(kept)
        if self.parts and _is_range(kept):  # "(i = 1, 2)": for which i
            said = words(self.text[kept[0].position : kept[-1].position + 1])
            joint = ", ".join(filter(None, (self.parts[-1].condition, said)))
            self.parts[-1] = replace(self.parts[-1], condition=joint)
            kept = []
        if number and self.parts and not self.parts[-1].tag:  # it stands behind a comma or a space
            self.parts[-1] = replace(self.parts[-1], tag=number)
        elif self.parts and self._is_value(part):
            last = self.parts[-1]
            problem = last.problem or UnreadError(
                "a list of values, or a decimal comma: write each equation out, with a full stop "
                "in numbers",
                last.tokens[0].position,
            )
            self.parts[-1] = replace(last, tag=self.tag or last.tag, problem=problem)
        elif kept:
            if self._column and self.parts and "RELATION" not in part.kinds:
                reason = "behind the & a term could go on, or a comment stand"
                problem = UnreadError(reason, kept[0].position)
                self.parts[-1] = replace(self.parts[-1], problem=problem)
            self.parts.append(part)
        elif self.tag and self.parts and not self.parts[-1].tag:
            self.parts[-1] = replace(self.parts[-1], tag=self.tag)
        if kept:
            self.tag, self.problem, self._column = "", None, False
            self._comma = kept[-1].kind if stop == "," else ""
        elif self.tag:
            self.tag = ""

    def _is_list(self, i: int) -> bool:
        """Whether values are listed: i = 1, 2, …, n behind the comma of which no relation comes."""
        kinds = [token.kind for token in self.current]
        if kinds not in (["SYMBOL", "RELATION", "NUMBER"], ["SYMBOL", "RELATION", "SYMBOL"]):
            return False
        commas = 0
        for token in self.found[i + 1 :]:
            if token.kind in ("LINE", "ARROW", "TAG", "WORDS"):
                break
            if token.kind in ("RELATION", "OPEN"):
                return False
            if token.value == OMITTED:
                return True
            commas += token.kind == "SEPARATOR"
        return commas > 1

    condition: int | None = None
    """Where words stand, such as "if", that all up to the end of the line belong to."""

    def _conditioned(self, end: int) -> None:
        """What stands behind such words belongs to the equation in front, unread."""
        start, self.condition = self.condition, None
        if self.parts and not self.parts[-1].condition:
            said = words(self.text[start:end])
            self.parts[-1] = replace(self.parts[-1], condition=said)

    def _is_value(self, part: Part) -> bool:
        """Whether one value more stands behind a comma: 0, π."""
        number = part.kinds == ["NUMBER"] and self._comma == "NUMBER"
        letter = part.kinds in (["SYMBOL"], ["SIGN", "SYMBOL"]) and self._comma != ""
        related = letter and "RELATION" in self.parts[-1].kinds
        return number or (related and part.tokens[-1].value != OMITTED)

    _comma = ""
    """The kind of what stands in front of a comma with which the last part ended."""
    _worded = False
    """Whether words stand in front on the same line."""
    _column = False
    """Whether it ended at an &."""


def _ahead(found: Sequence[Token]) -> list[tuple[str, bool]]:
    made: list[tuple[str, bool]] = []
    kind, related = "", False
    for token in reversed(found):
        made.append((kind, related))
        if token.kind not in _BLANK:
            kind = token.kind
        related = token.kind not in _BREAKS and (related or token.kind == "RELATION")
    return made[::-1]


def _is_range(part: Sequence[Token]) -> bool:
    """Whether a part stands in brackets with a relation of its own: it says where another holds."""
    kinds = [token.kind for token in part]
    return (
        len(kinds) > 4
        and kinds[0] in ("OPEN", "LIST")
        and kinds[-1] in ("CLOSE", "TSIL")
        and kinds[2] == "RELATION"
    )


def _bracketed(part: Sequence[Token]) -> str:
    """The number of an equation in brackets, if that is all there is."""
    plain = [t.kind for t in part] == ["OPEN", "NUMBER", "CLOSE"]
    return part[1].value if plain else ""
