r"""The statements of a formula, in order: rows and chains, separators, conditions, numbers.

>>> first, second = statements(r"a &= b + c \tag{1} \\ &\approx c \qquad (b \ll c)")
>>> first.relations, first.tag, second.relations, second.continues, second.conditions[0].relations
(('=',), '1', ('≈',), True, ('≪',))
>>> statements(r"x = , y = 2")[0]
Unread(position=4, reason='a term is missing before ,', tag='')
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Final

from rigidtop.read.dress import BOLD
from rigidtop.read.factors import FACTORS, word
from rigidtop.read.grammar import Grammar, ReadingRules
from rigidtop.read.macros import PACKAGES, Macros, expanded
from rigidtop.read.shapes import parted
from rigidtop.read.tex import UnreadError, listed, pieces
from rigidtop.read.tokens import Token, tokens
from rigidtop.read.vocabulary import CASES, CONSTANT, DERIVATIVES
from rigidtop.tree.nodes import (
    Bracketed,
    Letter,
    Negative,
    Node,
    Number,
    Omitted,
    Product,
    Quotient,
    Tuple,
    walked,
)
from rigidtop.tree.plain import plain
from rigidtop.tree.statement import Statement, Unread

Read = tuple[Statement | Unread, ...]

_NUMBER: Final = re.compile(r"\((\d+(?:\.\d+)*[a-z]?)\)")
"""Words that are the number of an equation."""

_CONDITIONAL: Final = listed(
    "for if when whenever unless provided assuming as at für wenn falls bei pour quand si para "
    "cuando om når hvis since because where otherwise else sonst 当 若 如果 因为"
)
"""Words behind which a condition stands."""
_BOUNDS: Final = frozenset({"comma", "quad", "break", "arrow", "words", "tag", "stop", "align"})
_LAYOUT: Final = frozenset({"break", "align", "quad"})
_EMPTY: Final = frozenset({"open", "close", "relation"})
_INFIX: Final = frozenset("+-±∓·×*/")
_MARKS: Final = _INFIX | {"^", r"\star", "⋆", "†", "‡", r"\dagger", r"\ddagger"}
"""Signs that may stand alone, as those by which the text calls a formula: (*)."""


def statements(
    text: str,
    macros: Macros = PACKAGES,
    functions: frozenset[Letter] = frozenset(),
    lettered: bool = False,
    differentials: bool = True,
) -> Read:
    r"""What a formula states, in order; what can't be read is an `Unread` among the others.

    `functions` are letters whose brackets hold the place at which they are taken; where it is
    `lettered`, d is a letter in front of a rate, and without `differentials` in front of a letter.

    >>> [len(each.sides) for each in statements(r"a = b = c,\quad d > 0 \Rightarrow e = f")]
    [3, 2, 2]
    """
    reading = ReadingRules(functions=functions, lettered=lettered, differentials=differentials)
    return _usual(text, reading) if macros is PACKAGES else _read(text, macros, reading)


@lru_cache(maxsize=5_000)
def _usual(text: str, reading: ReadingRules) -> Read:
    """What a formula in which no macros are defined states; a text is often read twice."""
    return _read(text, PACKAGES, reading)


def readings(
    text: str, macros: Macros = PACKAGES, functions: frozenset[Letter] = frozenset()
) -> tuple[Read, ...]:
    r"""The usual reading, and other ways to read the same text, at most four in all.

    >>> len(readings("a/bc = M(x)"))
    3
    """
    usual = ReadingRules(functions=functions)
    others = [
        replace(usual, calls=False),
        replace(usual, gathered=False),
        replace(usual, differentials=False),
    ]
    found = dict.fromkeys(_read(text, macros, each) for each in (usual, *others))
    first, *more = found
    return (first, *(read for read in more if not any(isinstance(x, Unread) for x in read)))


def _read(text: str, macros: Macros, reading: ReadingRules) -> Read:
    own = {name: each for name, each in macros.items() if each is not PACKAGES.get(name)}
    packed = {
        name: each for name, each in PACKAGES.items() if name not in (*own, *DERIVATIVES, r"\qty")
    }
    try:
        items = tokens(expanded(pieces(text), packed | own))
    except UnreadError as error:
        return (Unread(error.position, error.reason),)
    if len(items) <= 3 and {x.kind for x in items if x.text not in _MARKS} <= _EMPTY:
        return ()
    found = tuple(_StatementReader(joined(items), reading).all())
    match found:
        case (Unread(position),) if position > items[-1].position and not _relates(items):
            return ()  # an operator, d/dt, that is called by its sign
    return found


def joined(items: Sequence[Token]) -> list[Token]:
    """Tokens with only those breaks and columns that part statements."""
    items = _opened(items)
    found: list[Token] = []
    depth = 0
    for i, token in enumerate(items):
        depth = max(0, depth + (token.kind == "open") - (token.kind == "close"))
        if token.kind in _LAYOUT and (depth and _closes(items, i)):
            continue
        last = found[-1] if found else None
        open_ended = last is None or last.kind == "relation" or _is_infix(last)
        if token.kind == "break":
            if not open_ended and not _goes_on(items, i + 1):
                found.append(token)
        elif token.kind == "align":
            ahead = next((x for x in items[i + 1 :] if x.kind not in ("align", "quad")), None)
            starts = ahead is not None and ahead.kind not in ("relation", "break", "close")
            if not (open_ended or _ends(last)) and starts and not _is_infix(ahead):
                found.append(token)
        elif token.kind == "quad" and (open_ended or items[i - 1].kind in _LAYOUT):
            continue
        else:
            found.append(token)
    return found


def _ends(token: Token | None) -> bool:
    """Whether a statement has ended with a token; the word "const" is its last side."""
    constant = token is not None and token.text.strip(". ").lower() in CONSTANT
    return token is not None and token.kind in _BOUNDS and not constant


def _opened(items: Sequence[Token]) -> list[Token]:
    """Tokens without braces around what is a statement by itself, be it bold."""
    found: list[Token] = []
    for token in items:
        states = token.kind == "group" and _relates(token.group)
        last = found[-1] if found else None
        if states and last is not None and last.text in BOLD:
            bold = found.pop()
            for each in _opened(token.group):
                is_bold = each.kind == "letter" and bold.text != r"\underline"
                found += [bold, each] if is_bold else [each]
        elif states and (last is None or not (last.kind == "command" or last.text in ("_", "^"))):
            found += _opened(token.group)
        else:
            found.append(token)
    return found


def _relates(items: Sequence[Token]) -> bool:
    """Whether there is a relation among tokens, and not only the index of I_⊥."""
    signs = [i for i, token in enumerate(items) if token.kind == "relation"]
    lined = [x for i, x in enumerate(items) if i and items[i - 1].text == r"\underline"]
    return any(not i or items[i - 1].text not in ("_", "^") for i in signs) or any(
        _relates(x.group) for x in lined if x.kind == "group"
    )


def _closes(items: Sequence[Token], start: int) -> bool:
    """Whether the bracket in which a token stands is closed later."""
    depth = 1
    for token in items[start:]:
        depth += (token.kind == "open") - (token.kind == "close")
        if not depth:
            return True
    return False


def _is_infix(token: Token | None) -> bool:
    return token is not None and token.kind == "sign" and token.text in _INFIX


def _goes_on(items: Sequence[Token], start: int) -> bool:
    """Whether a row begins with a sign, and goes on with what stands above."""
    row: list[Token] = []
    for token in items[start:]:
        if token.kind == "break" and row:
            break
        row.append(token)
    shown = [token for token in row if token.kind not in ("quad", "break")]
    signs = [i for i, token in enumerate(shown[:2]) if _is_infix(token)]
    if not signs or (signs[0] and shown[0].kind != "align"):
        return False
    begins = shown[signs[0]].text not in "+-±∓" or signs[0] == 1
    return begins or not any(token.kind == "relation" for token in shown)


@dataclass
class _Draft:
    """A statement on its way: what of it has been read."""

    position: int = 0
    sides: list[Node] = field(default_factory=list)
    relations: list[str] = field(default_factory=list)
    continues: bool = False


class _StatementReader(Grammar):
    """Reads statements one after the other."""

    def __init__(self, items: Sequence[Token], reading: ReadingRules, depth: int = 0) -> None:
        super().__init__(items, FACTORS, reading, depth)
        self.found: list[Statement | Unread] = []
        self.tag = ""
        self.condition = False  # what follows is the condition of the statement before
        self.listing = False  # a comma stands right before

    def all(self) -> list[Statement | Unread]:
        while self.at < len(self.items):
            start = self.at
            try:
                self.next()
            except UnreadError as error:
                self.found.append(Unread(error.position, error.reason))
                self.skip()
            self.at += self.at == start
        if self.tag:
            self.numbered()
        return self.found

    def skip(self) -> None:
        """Go to where the next statement may begin."""
        depth = 0
        while self.at < len(self.items):
            token = self.peek()
            depth = max(0, depth + (token.kind == "open") - (token.kind == "close"))
            if token.kind == "break" or (not depth and token.kind in _BOUNDS):
                return
            self.at += 1

    def next(self) -> None:
        token = self.peek()
        if token.kind in _BOUNDS and not self.is_named_side():
            self.bound(self.take())
        elif token.kind == "environment" and token.text in CASES:
            self.take()
            self.branches(None, token)
        elif token.kind == "open" and self.related.get(self.at) and self.at in self.partners:
            self.bracketed()
        elif token.text == "→" and (self.found or _relates(self.items[self.at + 1 :])):
            self.take()  # hence
        else:
            self.statement()

    def bound(self, token: Token) -> None:
        """Takes a token that stands between statements, such as a tag or words."""
        if token.kind == "words":
            self.said(token)
        elif token.kind == "tag":
            self.tag = token.text
            self.numbered()
        if token.kind in ("break", "arrow") or (token.kind == "quad" and self.has_condition()):
            self.condition = False
        self.listing = token.text == "," and self.peek().kind != "quad"

    def numbered(self) -> None:
        if self.found and not self.found[-1].tag:
            self.found[-1] = replace(self.found[-1], tag=self.tag)
        self.tag = ""

    def has_condition(self) -> bool:
        last = self.found[-1] if self.found else None
        return isinstance(last, Statement) and bool(last.conditions)

    def said(self, token: Token) -> None:
        number = _NUMBER.fullmatch(token.text.strip(" ,.;:"))
        if number:
            self.tag = number[1]
            self.numbered()
            return
        words = token.text.strip(" ,.;:()")
        last = self.found[-1] if self.found else None
        self.condition = is_conditional(words) and isinstance(last, Statement)
        if isinstance(last, Statement) and (self.condition or " " in words):
            said = f"{last.condition} {words}".strip()
            self.found[-1] = replace(last, condition=said)

    def is_named_side(self) -> bool:
        """Whether words are a side: "force = mass × acceleration"."""
        if self.peek().kind != "words":
            return False
        return self.peek(1).kind == "relation" or _is_infix(self.peek(1))

    def bracketed(self) -> None:
        """A statement in brackets is the condition of the one before."""
        end = self.partners[self.at]
        inner = _StatementReader(self.items[self.at + 1 : end], self.reading, self.depth + 1)
        self.at = end + 1
        for each in inner.all():
            self.keep(each, condition=True)

    def keep(self, read: Statement | Unread, *, condition: bool) -> None:
        last = self.found[-1] if self.found else None
        if not (condition and isinstance(last, Statement) and isinstance(read, Statement)):
            self.found.append(read)
        elif read.relations:
            self.found[-1] = replace(last, conditions=(*last.conditions, read))
        else:
            self.found[-1] = replace(last, condition=f"{last.condition} {plain(read)}".strip())

    def statement(self) -> None:
        draft = _Draft(self.peek().position)
        if self.peek().kind == "relation":
            last = self.found[-1] if self.found else None
            draft.sides = [last.sides[-1] if isinstance(last, Statement) else Omitted()]
            draft.continues = True
        else:
            draft.sides = [self.side()]
        while self.peek().kind == "relation":
            if self.peek().text == "→" and draft.relations:
                break
            draft.relations.append(self.take().text)
            if self.peek().kind == "environment" and self.peek().text in CASES:
                self.branches(draft, self.take())
                return
            draft.sides.append(self.side())
        self.finish(draft)

    def side(self) -> Node:
        return word(self, []) if self.peek().kind == "words" else self.expression()

    def finish(self, draft: _Draft) -> None:
        ends = ("end", "open", "environment", *_BOUNDS, "relation")
        if self.peek().kind not in ends:
            raise UnreadError(f"{self.peek().text} cannot stand here", self.place())
        made = Statement(
            tuple(draft.sides),
            tuple(draft.relations),
            draft.position,
            continues=draft.continues,
        )
        last = self.found[-1] if self.found else None
        number = _number(draft)
        if number and isinstance(last, Statement) and not last.tag:
            self.found[-1] = replace(last, tag=number)
        elif (
            self.listing
            and not draft.relations
            and isinstance(last, Statement)
            and _is_entry(_entries(last.sides[-1])[-1])
            and _is_entry(draft.sides[0])
        ):
            self.found[-1] = _listed(last, made)
        elif self.listing and isinstance(last, Statement) and not last.relations:
            first = (*_entries(last.sides[0]), made.sides[0])
            self.found[-1] = replace(made, sides=(Tuple(first), *made.sides[1:]))
            self.found[-1] = replace(self.found[-1], position=last.position)
        else:
            self.keep(made, condition=self.condition)
        self.listing = False

    def read(self, tokens: Sequence[Token]) -> list[Statement | Unread]:
        """The statements of some tokens within this one."""
        return _StatementReader([*tokens], self.reading, self.depth + 1).all()

    def conditioned(self, cells: Sequence[Sequence[Token]]) -> list[Statement | Unread]:
        """A row of cases with its condition in the last cell; nothing where that says no more."""
        if len(cells) != 2:
            return []
        first, behind = map(self.read, cells)
        conditions = [x for x in behind if isinstance(x, Statement) and {*x.relations} <= _UNEQUAL]
        if not first or len(conditions) != len(behind) or any(x.continues for x in conditions):
            return []
        *before, last = first
        if not conditions or isinstance(last, Unread):
            return []
        return [*before, replace(last, conditions=(*last.conditions, *conditions))]

    def branches(self, draft: _Draft | None, token: Token) -> None:
        """The rows of cases: statements, or values of the side in front with their conditions."""
        for row in parted(token.group, "break"):
            if not row:
                continue
            cells = parted(row, "align")
            if draft is None:
                self.found += self.conditioned(cells) or self.read(joined(row))
                continue
            value = _StatementReader(cells[0], self.reading, self.depth + 1)
            behind = [each for cell in cells[1:] for each in cell]
            try:
                side = value.side()
                sides = (*draft.sides, side)
                made = Statement(sides, tuple(draft.relations), cells[0][0].position)
            except UnreadError as error:
                self.found.append(Unread(error.position, error.reason))
                continue
            self.found.append(made)
            rest = _StatementReader(
                [*value.items[value.at :], *behind], self.reading, self.depth + 1
            )
            rest.found, rest.condition = [made], True
            self.found[-1:] = rest.all()


_UNEQUAL = frozenset("<>≤≥≠")


def is_conditional(words: str) -> bool:
    """Whether words beside a statement say when it holds, and are no comment."""
    return words.lower().split(" ")[0] in _CONDITIONAL if words else False


def _number(draft: _Draft) -> str:
    """The number of a statement in brackets behind it: "(3.48)"."""
    side = draft.sides[0]
    if draft.relations or not isinstance(side, Bracketed) or not isinstance(side.of, Number):
        return ""
    return side.of.text


def _is_entry(node: Node) -> bool:
    """Whether a node may be one of several values: 0, π, −a."""
    plainly = (Letter, Number, Omitted, Negative, Product, Quotient, Tuple)
    return all(isinstance(each, plainly) for each in walked(node))


def _entries(node: Node) -> tuple[Node, ...]:
    return node.entries if isinstance(node, Tuple) else (node,)


def _listed(last: Statement, made: Statement) -> Statement:
    """A statement to whose last side one entry more belongs: i = 1, 2."""
    return replace(last, sides=(*last.sides[:-1], Tuple((*_entries(last.sides[-1]), *made.sides))))
