r"""Mathematics that stands in a text without dollars or the like, as in an answer.

>>> from rigidtop.read.walk import Walk
>>> [formula.text for formula in unmarked(Walk("so L = λ₃ω₃e₃ and R_CM = R e₃, g = −g ẑ: yes"))]
['L = λ₃ω₃e₃', 'R_CM = R e₃', 'g = −g ẑ']
>>> [formula.text for formula in unmarked(Walk("then L_1 = $a b$ holds, as $c = d$."))]
['L_1 =  a b', 'c = d']
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from functools import partial

from rigidtop.read.left import SIGNS
from rigidtop.read.walk import Formula, Walk

_GREEK = frozenset(
    re.findall(
        r"\w+",
        "alpha beta gamma delta epsilon zeta eta theta kappa lambda mu nu xi pi rho sigma tau phi"
        " chi psi omega Omega Theta Phi Psi Lambda Delta",
    )
)
"""Letters that are written as words."""
_NAMES = _GREEK | frozenset(
    re.findall(r"\w+", "sin cos tan cot sec exp log sqrt arcsin arccos arctan const konst dot ddot")
)
"""Words that are mathematics."""
_TOKEN = re.compile(
    r"(?P<none><[A-Za-z/!][^<>\n]{0,200}>|https?://\S+|\]\([^)\n]{0,200}\)|[=-]>|<[=-]|[⇒→⟹←⇔|!?:;\n]"
    r"|\\(?:begin|end|label|tag|eq?ref|cite|item|section|usepackage|document\w+|def|newcommand)\b"
    r"[^\n\\$]{0,200}|\\(?:text\w*|emph|noindent|paragraph)(?![A-Za-z])|[.,](?=\s|\Z)"
    r"|^[ \t>]*(?:[-*+]|\d{1,3}[.)]|\([a-z]{1,3}\)|#{1,6})[ \t])"
    rf"|(?P<relation>[=≈≡≠≤≥∝≃≅]|(?<=\s)[<>](?=\s)|\\(?:{SIGNS})(?![A-Za-z]))"
    r"|(?P<word>(?<![_^{\\])[^\W\d_]{2,}(?:['-][^\W\d_]+)*)|(?P<sign>\\[A-Za-z]+|\S)",
    re.M,
)
_PROSE = re.compile(r"[A-ZÄÖÜ]?[a-zäöüß]+(?:['-][A-Za-zäöüß]+)*")
_RATE = re.compile(rf"(?:{'|'.join(sorted(_GREEK))}|[a-zA-Z])d{{1,2}}ot")
"""A rate that is written as a word: thetadot, xddot."""
_VOWEL = re.compile("[aeiouyäöü]", re.I)
_LETTER = re.compile(r"[^\W_]")
_WORD = re.compile(
    r"\*\*(?P<bold>[^\s*\\]{1,4})\*\*"
    rf"|(?<![\\A-Za-z])(?:(?P<rate>d{{1,2}}ot)\((?P<of>{'|'.join(sorted(_GREEK))}|[A-Za-z])\)"
    rf"|(?P<greek>{'|'.join(sorted(_GREEK, key=len, reverse=True))})|(?P<latin>[A-Za-z]))"
    r"(?:_?(?P<dots>d{1,2})ot)?(?![A-Za-z])"
)
"""A letter that is written as a word, or a rate of one: phi, phidot, dot(phi); or **bold**."""


def as_tex(text: str) -> tuple[str, Callable[[int], int]]:
    r"""Mathematics in plain text as LaTeX, and what tells the position before of one in it.

    >>> tex, before = as_tex("phidot = Omega")
    >>> tex, before(tex.index("="))
    ('\\dot{\\phi} = \\Omega', 7)
    """
    parts, starts, at, length = [], [(0, 0)], 0, 0
    for match in _WORD.finditer(text):
        if not (match["bold"] or match["greek"] or match["dots"] or match["rate"]):
            continue
        name = match["of"] or match["greek"] or match["latin"]
        letter = f"\\{name}" if name in _GREEK else name
        rate = match["rate"] or (f"{match['dots']}ot" if match["dots"] else "")
        behind = " " if text[match.end() :][:1].isalnum() else ""
        new = f"\\{rate}{{{letter}}}" if rate else f"{letter}{behind}"
        if match["bold"]:
            new = f"\\mathbf{{{match['bold']}}}"
        parts += [text[at : match.start()], new]
        length += match.start() - at + len(new)
        at = match.end()
        starts.append((length, at))
    return "".join((*parts, text[at:])), partial(_before, tuple(starts))


def is_spelled(text: str) -> bool:
    """Whether a letter stands in it as a word that is nothing else: phi, but not mu or pi."""
    return any(len(match["greek"] or "") > 2 for match in _WORD.finditer(text))


def _before(starts: tuple[tuple[int, int], ...], position: int) -> int:
    """Where a position in changed text was, each piece having begun at one place and another."""
    new, old = max((x for x in starts if x[0] <= position), default=(0, 0))
    return old + position - new


def unmarked(walk: Walk) -> list[Formula]:
    """The formulas of a walk with those outside of all delimiters, in order.

    What is written in part between dollars is one formula.
    """
    return sorted(_merged(walk), key=lambda formula: formula.opens)


def _merged(walk: Walk) -> Iterator[Formula]:
    inline = {formula.opens: formula for formula in walk.found if not formula.display}
    runs = _Runs(walk.source)
    spans = [(formula.opens, formula.end, formula.display) for formula in walk.found]
    spans += [(start, end, True) for start, end in walk.skipped]
    at = 0
    for start, end, breaks in sorted(spans):
        runs.read(at, start)
        if breaks:
            runs.close()
        else:
            runs.take(start, end)
        at = max(at, end)
    runs.read(at, len(walk.source))
    runs.close()
    swallowed: set[int] = set()
    for start, end, formulas in runs.statements:
        swallowed.update(formulas)
        parts, at = [], start
        for opens in formulas:
            inner = inline[opens]
            blanked = " " * (inner.start - opens) + inner.text
            parts += [walk.source[at:opens], blanked.ljust(inner.end - opens)]
            at = inner.end
        text = "".join((*parts, walk.source[at:end]))
        shift = len(text) - len(text.lstrip())
        yield Formula(text.strip(), start + shift, end, False, start)
    yield from (formula for formula in walk.found if formula.opens not in swallowed)


class _Runs:
    """Rows of mathematical signs; those with a relation outside of dollars are statements."""

    def __init__(self, source: str) -> None:
        self.source = source
        self.statements: list[tuple[int, int, tuple[int, ...]]] = []
        self.spans: list[tuple[int, int]] = []
        self.formulas: list[int] = []
        self.relations: list[int] = []
        self.depth = 0

    def read(self, start: int, end: int) -> None:
        for match in _TOKEN.finditer(self.source, start, end):
            within = self.depth and match[0] in (",", ".")
            if (match["none"] and not within) or (match["word"] and self.is_prose(match)):
                self.close()
                continue
            if match[0] in ")]}" and not self.depth:
                self.close()
                continue
            if match["relation"]:
                self.relations.append(match.start())
                if self.depth == 1 and self.source[self.spans[0][0]] in "([{":
                    del self.spans[0]  # the brackets are those of the sentence
                    self.depth = 0
            self.depth += (match[0] in "([{") - (match[0] in ")]}")
            self.spans.append(match.span())

    def take(self, start: int, end: int) -> None:
        """Notes a formula that stands between dollars."""
        self.formulas.append(start)
        self.spans.append((start, end))

    def opened(self, relation: int) -> int:
        """How many spans stand before the first bracket behind a relation that does not close."""
        open_: list[int] = []
        for k, (start, _) in enumerate(self.spans):
            sign = self.source[start]
            if sign in "([{" and start > relation:
                open_.append(k)
            elif sign in ")]}" and open_:
                open_.pop()
        return open_[0] if open_ else len(self.spans)

    def is_prose(self, match: re.Match[str]) -> bool:
        word = match["word"]
        if (
            word in _NAMES
            or _RATE.fullmatch(word)
            or not _PROSE.fullmatch(word)
            or not _VOWEL.search(word)
        ):
            return False
        last = self.source[self.spans[-1][0]] if self.spans else ""
        return not (len(word) <= 3 and word.islower() and last and last in "=+-−*/·(")

    def close(self) -> None:
        """End a row, and keep it if there is something on both sides of a relation in it.

        A bracket that is still open behind the relation is one of the sentence.
        """
        if self.depth > 0 and self.relations:
            self.spans = self.spans[: self.opened(self.relations[0])]
        if self.relations and self.spans:
            start, end = self.spans[0][0], self.spans[-1][1]
            left = self.source[start : self.relations[0]]
            right = self.source[self.relations[-1] + 1 : end]
            sides = _LETTER.search(left) and _LETTER.search(right)
            if sides and re.search(r"[^\W\d_]", left + right):
                self.statements.append((start, end, tuple(self.formulas)))
        self.spans, self.formulas, self.relations, self.depth = [], [], [], 0
