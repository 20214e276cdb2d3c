"""The grammar of formulas, as a physicist reads them: sums, products, and the factors in them.

Where a text can mean two things, `ReadingRules` says which is taken.  How each factor is read is
told by `FactorRules`, which `rigidtop.read.factors` has.
"""

from __future__ import annotations

from collections.abc import Callable, Container, Sequence
from dataclasses import dataclass, replace
from typing import Final

from rigidtop.read.dress import DOTS, DRESS
from rigidtop.read.shapes import FRACTIONS, brackets, is_operator, product_of, unbraced
from rigidtop.read.tex import DEEPEST, UnreadError, listed
from rigidtop.read.tokens import Token, written
from rigidtop.read.units import units
from rigidtop.read.vocabulary import CONSTANT, FUNCTIONS, MATRICES
from rigidtop.tree.nodes import (
    CrossProduct,
    DotProduct,
    Letter,
    Negative,
    Node,
    Number,
    PlusMinus,
    Quotient,
    Sum,
    Tuple,
    ungrouped,
)


@dataclass(frozen=True)
class ReadingRules:
    """How is read what can be read in two ways.

    `calls`: M(x) is a function at a place, not a product; `gathered`: a/bc is a/(bc);
    `differentials`: dx is a differential, not d times x.  `functions` are functions for certain,
    and where it is `lettered`, so is d a letter in front of a rate, and d².
    """

    calls: bool = True
    gathered: bool = True
    differentials: bool = True
    functions: frozenset[Letter] = frozenset()
    lettered: bool = False


@dataclass(frozen=True)
class FactorRules:
    """How factors are read.

    `commands` are those with which one begins; `primary` reads one without its scripts, behind
    those that stand in front of it in the product; `scripted` reads what belongs to it: its index,
    its power, its primes, its place.
    """

    commands: Container[str]
    primary: Callable[[Grammar, Sequence[Node]], Node]
    scripted: Callable[[Grammar, Node], Node]


_END: Final = Token("end", "", 0)
_SPELLED: Final = sorted(
    listed("sin cos tan cot arcsin arccos arctan sinh cosh tanh exp ln log sqrt const"),
    key=len,
    reverse=True,
)
"""Names that plain text spells with letters."""


class Grammar:
    """Reads nodes from tokens, from the left to the right."""

    def __init__(
        self,
        items: Sequence[Token],
        rules: FactorRules,
        reading: ReadingRules | None = None,
        depth: int = 0,
    ) -> None:
        self.items, self.rules, self.reading, self.depth = (
            items,
            rules,
            reading or ReadingRules(),
            depth,
        )
        self.at = 0
        self.bars = 0
        self.integrals = 0
        self.partners, self.related = brackets(items)

    # The tokens

    def peek(self, ahead: int = 0) -> Token:
        at = self.at + ahead
        return self.items[at] if 0 <= at < len(self.items) else _END

    def take(self) -> Token:
        self.at += 1
        return self.items[self.at - 1]

    def is_sign(self, signs: str, ahead: int = 0) -> bool:
        token = self.peek(ahead)
        return token.kind == "sign" and token.text in signs

    def place(self) -> int:
        if self.at < len(self.items):
            return self.items[self.at].position
        return self.items[-1].position + 1 if self.items else 0

    def missing(self, what: str) -> UnreadError:
        here = self.peek().text
        return UnreadError(f"{what} is missing" + (f" before {here}" if here else ""), self.place())

    def inner(self, items: Sequence[Token]) -> Grammar:
        return Grammar(items, self.rules, self.reading, self.counted(self.depth))

    def node_of(self, items: Sequence[Token]) -> Node:
        """What stands within, as one expression or a list."""
        return self.inner(items).whole()

    def argument(self, depth: int = 0) -> tuple[Token, ...]:
        """What a command or an index takes: a group, or one token with what that takes itself."""
        token = self.peek()
        if depth > DEEPEST:
            raise UnreadError(f"nested deeper than {DEEPEST}", self.place())
        if token.kind == "group":
            return self.take().group
        if token.kind == "number" and len(token.text) > 1 and token.text[1] != ".":
            rest = replace(token, text=token.text[1:], position=token.position + 1)
            self.items = [*self.items[: self.at], rest, *self.items[self.at + 1 :]]
            return (replace(token, text=token.text[0]),)
        if token.kind == "end":
            raise self.missing("what a command acts on")
        start = self.at
        self.take()
        if token.kind == "command":
            for _ in range(2 if token.text in FRACTIONS else 1):
                self.argument(depth + 1)
        elif token.kind == "open":
            self.at = self.partners.get(start, start) + 1
        return tuple(self.items[start : self.at])

    # Sums and products

    def whole(self) -> Node:
        """All tokens as one expression, or as a list with commas."""
        entries = self.entries()
        return entries[0] if len(entries) == 1 else Tuple(entries)

    def entries(self) -> tuple[Node, ...]:
        entries = [self.expression()]
        while self.peek().kind == "comma":
            self.take()
            entries.append(self.expression())
        if self.at < len(self.items):
            raise UnreadError(f"{self.peek().text or 'something'} cannot stand here", self.place())
        return tuple(entries)

    def expression(self) -> Node:
        terms = [self.signed()]
        while self.is_sign("+-±∓"):
            terms.append(self.signed())
        return terms[0] if len(terms) == 1 else Sum(tuple(terms))

    def signed(self) -> Node:
        signs = []
        while self.is_sign("+-±∓"):
            signs.append(self.take().text)
        if len(signs) > 3:
            raise UnreadError("several signs in a row", self.place())
        node = self.term()
        for sign in reversed(signs):
            if sign == "-":
                node = Negative(node)
            elif sign in "±∓":
                node = PlusMinus(node, sign == "∓")
        return node

    def term(self) -> Node:
        node, count = self.crossed(), 0
        while self.is_sign("·") and not (self.integrals and self.is_differential(1)):
            self.take()
            count = self.counted(count)
            node = DotProduct(node, self.crossed())
        return node

    def crossed(self) -> Node:
        node, count = self.product(), 0
        while self.is_sign("×"):
            self.take()
            count = self.counted(count)
            node = CrossProduct(node, self.product())
        return node

    def counted(self, count: int) -> int:
        """One level more; too many of them are no formula."""
        if count >= DEEPEST:
            raise UnreadError(f"nested deeper than {DEEPEST}", self.place())
        return count + 1

    def product(self) -> Node:
        sign = self.take().text if self.is_sign("+-") else ""  # r × -v
        factors, slashes = [self.factor([])], 0
        while True:
            if self.is_sign("*"):
                self.take()
                factors.append(self.factor(factors))
            elif self.is_sign("/"):
                self.take()
                slashes = self.counted(slashes)
                over = product_of(factors)
                factors = [Quotient(ungrouped(over), self.under(factors), slash=True)]
            elif self.starts():
                factors.append(self.factor(factors))
            else:
                node = product_of(factors)
                return Negative(node) if sign == "-" else node

    def under(self, over: Sequence[Node]) -> Node:
        """What stands below a slash: one factor, or all letters that stand close to it."""
        bracket = self.peek().kind == "open"
        factors = [self.factor(over)]
        numbers = all(isinstance(each, Number) for each in (over[-1], factors[0]))
        while (
            self.reading.gathered
            and not (bracket or numbers or self.peek().spaced)
            and (self.peek().kind in ("letter", "number") or self.peek().text in DOTS)
            and self.starts()
            and not self.spelled()
        ):
            factors.append(self.factor(factors))
        return ungrouped(product_of(factors))

    def starts(self) -> bool:
        """Whether the next token begins a factor."""
        token = self.peek()
        if self.integrals and self.is_differential():
            return False
        if token.kind == "open":
            return not self.related.get(self.at, False)
        if token.kind == "bar":
            return not self.bars and not self.is_sign("_", 1)
        if token.kind == "sign":
            return token.text in "∂∇∫∮ΣΠ"
        if token.kind == "words":
            return bool(units(token.text)) or token.text.strip(". ").lower() in CONSTANT
        if token.kind == "environment":
            return token.text in MATRICES
        if token.kind == "command":
            return token.text in self.rules.commands
        return token.kind in ("letter", "number", "upright", "group", "dots")

    def factor(self, before: Sequence[Node]) -> Node:
        self.depth = self.counted(self.depth)
        try:
            return self.rules.scripted(self, self.primary(before))
        finally:
            self.depth -= 1

    def primary(self, before: Sequence[Node]) -> Node:
        """The factor that begins here, without its scripts and primes."""
        return self.rules.primary(self, before)

    # What stands ahead

    def spelled(self) -> str:
        """The name of a function that is spelled with letters that stand close."""
        first = self.peek()
        if first.kind != "letter" or not first.text.isascii():
            return ""
        close = ""
        while len(close) < 6 and self.peek(len(close)).kind == "letter":
            token = self.peek(len(close))
            if token.position != first.position + len(close) or len(token.text) > 1:
                break
            close += token.text
        return next((name for name in _SPELLED if close.startswith(name)), "")

    def is_named(self) -> bool:
        """Whether a letter begins here, with its accents."""
        token = self.peek()
        named = token.kind == "upright" and token.text not in FUNCTIONS
        return (token.kind == "letter" and not self.spelled()) or token.text in DRESS or named

    def exponent(self) -> int:
        """How often what stands in front counts: 2 for dx², 1 for dx."""
        if self.is_sign("^") and written((self.peek(1),)).isdecimal():
            self.at += 2
            return min(int(written((self.items[self.at - 1],))), 9)
        return 1

    def limits(self) -> dict[str, tuple[Token, ...]]:
        """What stands below and above, by its sign."""
        limits: dict[str, tuple[Token, ...]] = {}
        while self.is_sign("_^"):
            sign = self.take().text
            limits[sign] = self.argument()
        return limits

    def is_differential(self, ahead: int = 0) -> bool:
        """Whether a d with its letter stands here, within an integral."""
        start = self.at
        self.at += ahead
        operator = is_operator(unbraced(self.peek()), "d")
        self.at += 1
        if operator and self.is_sign("^"):
            self.at += 2
        named = self.is_named() or self.peek().kind == "group"
        self.at = start
        return operator and named
