r"""The grammar of formulas, as a physicist reads them: sums, products, derivatives, functions.

Where a text can mean two things, `Reading` says which is taken.

>>> from rigidtop.read.tex import pieces
>>> from rigidtop.read.tokens import tokens
>>> Grammar(tokens(pieces(r"\dot x"))).whole() == Rate(Letter("x"), dotted=True)
True
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Final

from rigidtop.read.shapes import (
    FRACTIONS,
    Head,
    brackets,
    check_order,
    derivative_of,
    framed,
    head_of,
    integrand_of,
    is_operator,
    is_place,
    parted,
    primed,
    product_of,
    styled,
    unbraced,
    upright,
    with_index,
)
from rigidtop.read.tex import DEEPEST, UnreadError, commands, listed
from rigidtop.read.tokens import CONSTANT, FUNCTIONS, MATRICES, Token, written
from rigidtop.read.units import raised, units
from rigidtop.tree.nodes import (
    Absolute,
    Apply,
    At,
    Average,
    Braced,
    Call,
    Component,
    Constant,
    Cross,
    Derivative,
    Differential,
    Dot,
    Group,
    Integral,
    Letter,
    Limit,
    Matrix,
    Nabla,
    Negative,
    Node,
    Number,
    Omitted,
    Order,
    PlusMinus,
    Power,
    Primed,
    Product,
    Quotient,
    Rate,
    Root,
    Sum,
    Total,
    Transposed,
    Tuple,
    Unit,
    letters,
    mapped,
    ungrouped,
    walked,
)


@dataclass(frozen=True)
class Reading:
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


_END: Final = Token("end", "", 0)
BOLD: Final = commands(
    "mathbf boldsymbol bm vec pmb bold overrightarrow underline overrightharpoon mathbfit vb va "
    "mathbold bf"
)
_DOTS: Final = {r"\dot": 1, r"\ddot": 2, r"\dddot": 3, r"\ddddot": 4}
_MARKS: Final = {
    **dict.fromkeys(commands("hat widehat vu"), "hat"),
    **dict.fromkeys(commands("bar overline"), "bar"),
    **dict.fromkeys(commands("tilde widetilde"), "tilde"),
    r"\check": "check",
    r"\breve": "breve",
    r"\mathring": "ring",
    r"\acute": "acute",
}
_STYLES: Final = {
    **dict.fromkeys(commands("mathcal mathscr"), "SCRIPT"),
    r"\mathfrak": "FRAKTUR",
    r"\mathbb": "DOUBLE-STRUCK",
}
_PLAIN: Final = commands("mathit mathnormal")
_BRACES: Final = commands("underbrace overbrace")
_SPELLED: Final = sorted(
    listed("sin cos tan cot arcsin arccos arctan sinh cosh tanh exp ln log sqrt const"),
    key=len,
    reverse=True,
)
"""Names that plain text spells with letters."""
_INVERSE: Final = {name: f"arc{name}" for name in ("sin", "cos", "tan")}
_WAVES, _PHASES = frozenset("kωΩνκqnm"), frozenset({"t", "x", "φ", "ϕ", "θ"})
"""Letters in front of brackets with one of these places belong to what a function acts on."""
_ANGLES: Final = frozenset("θφψϕϑt")
"""What ends the argument of a function: sin θ, cos ωt."""


class Grammar:
    """Reads nodes from tokens, from the left to the right."""

    def __init__(
        self, items: Sequence[Token], reading: Reading | None = None, depth: int = 0
    ) -> None:
        self.items, self.reading, self.depth = items, reading or Reading(), depth
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
        return Grammar(items, self.reading, self.counted(self.depth))

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
            node = Dot(node, self.crossed())
        return node

    def crossed(self) -> Node:
        node, count = self.product(), 0
        while self.is_sign("×"):
            self.take()
            count = self.counted(count)
            node = Cross(node, self.product())
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
            and (self.peek().kind in ("letter", "number") or self.peek().text in _DOTS)
            and self.starts()
            and not self.spelled()
        ):
            factors.append(self.factor(factors))
        return ungrouped(product_of(factors))

    def starts(self) -> bool:
        """Whether a factor begins here."""
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
            return token.text in _COMMANDS
        return token.kind in ("letter", "number", "upright", "group", "dots")

    def factor(self, before: Sequence[Node]) -> Node:
        self.depth = self.counted(self.depth)
        try:
            return self.scripted(self.primary(before))
        finally:
            self.depth -= 1

    def primary(self, before: Sequence[Node]) -> Node:
        token = self.peek()
        kind = token.text if token.kind == "sign" else token.kind
        if kind == "group" or token.text in FRACTIONS:
            unit = self.unit(before)
            if unit is not None:
                return unit
        if kind == "command":
            if token.text not in _COMMANDS:
                raise UnreadError(f"the command {token.text} is not known", token.position)
            return _COMMANDS[token.text](self)
        if kind in ("upright", "words"):
            return self.word(before)
        if kind not in _PRIMARIES:
            raise self.missing("a term")
        return _PRIMARIES[kind](self)

    def unit(self, before: Sequence[Node]) -> Node | None:
        """A group or a fraction behind a number in which there are only upright letters."""
        if not before or letters(before[-1]):
            return None
        start = self.at
        self.argument()
        unit = units(upright(self.items[start : self.at]))
        if unit is None:
            self.at = start
        return unit

    # Factors

    def number(self) -> Node:
        return Number(self.take().text)

    def omitted(self) -> Node:
        self.take()
        return Omitted()

    def group(self) -> Node:
        token = self.take()
        if not token.group:
            return self.factor([]) if self.starts() else Omitted()
        return self.inner(token.group).whole()

    def bracket(self) -> Node:
        start, token = self.at, self.take()
        end = self.partners.get(start)
        if end is None:
            raise UnreadError(f"a {token.text} without its end", token.position)
        inside = self.items[start + 1 : end]
        self.at = end + 1
        if not inside:
            raise UnreadError("brackets with nothing in them", token.position)
        matrix = inside[0].kind == "environment" and len(inside) == 1
        head = head_of(inside)
        if head and not head.of and self.is_sign("_"):
            self.take()
            return self.operation(head, written(self.argument()))
        node = self.inner(inside).whole()
        if token.text == "|":
            return Absolute(node)
        if token.text == "⟨":
            return Average(node)
        if token.text == ".":
            return self.taken(node)
        if matrix and isinstance(node, Matrix):
            return replace(node, bracket=token.text)
        if isinstance(node, Tuple):
            pair = len(node.entries) == 2 and token.text in "{["  # {q, p}
            return replace(node, bracket=token.text) if pair else node
        return Group(node, token.text)

    def bar(self) -> Node:
        position = self.take().position
        self.bars += 1
        node = self.expression()
        self.bars -= 1
        if self.peek().kind != "bar":
            raise UnreadError("a bar without the one that closes it", position)
        self.take()
        return Absolute(node)

    def letter(self) -> Node:
        token = self.peek()
        name = self.spelled()
        if name:
            self.at += len(name)
            return self.named(name)
        if token.text == "d" and (node := self.differentiated("d")):
            return node
        self.take()
        if token.text == "O" and self.peek().kind == "open":
            return self.order()
        behind = self.peek()
        if token.text == "Δ" and behind.kind == "letter" and not self.spelled():
            return Letter("Δ" + self.take().text)
        return Letter(token.text)

    def order(self) -> Node:
        node = self.bracket()
        return Order(ungrouped(node))

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

    def word(self, before: Sequence[Node]) -> Node:
        """What is written upright: a function, a unit, a constant, or the name of something."""
        token = self.peek()
        text = token.text.strip()
        if text in ("d", "∂") and (node := self.differentiated(text)):
            return node
        self.take()
        unit = units(text) if self.peek().kind != "open" else None  # K(m) is no kelvin
        if unit and before and (len(text) > 1 or not letters(before[-1])):
            return unit
        if text.strip(". ").lower() in CONSTANT:
            return Constant()
        if text in FUNCTIONS or text == "Tr":
            return self.function(text)
        if token.kind == "upright" and before and not letters(before[-1]):
            fraction = units(upright(token.group, within=True))
            if fraction:
                return fraction
        if token.kind == "upright" and token.group and not text.isalpha():
            return self.inner(token.group).whole()
        return Letter(text)

    def named(self, name: str) -> Node:
        if name == "sqrt":
            return Root(self.inner(self.argument()).whole())
        return Constant() if name == "const" else self.function(name)

    def function(self, name: str) -> Node:
        """A function with its power and what it acts on."""
        power: Node | None = None
        while self.is_sign("_^"):
            sign, group = self.take().text, self.argument()
            if sign == "_":
                name += "_" + written(group)
            elif written(group) in ("-1", "−1") and name in _INVERSE:
                name = _INVERSE[name]
            else:
                power = self.inner(group).whole()
        applied = Apply(name, self.acted_on())
        return applied if power is None else Power(applied, power)

    def acted_on(self) -> Node:
        """What a function acts on: brackets, or a product as far as it stands close."""
        token = self.peek()
        if token.kind == "open" and token.text in "([{":
            return ungrouped(self.bracket())
        if token.kind == "group" and len(token.group) > 1:
            return ungrouped(self.group())
        if not self.starts():
            raise self.missing("what a function acts on")
        factors = [self.factor([])]
        while self.goes_on(factors[-1]):
            factors.append(self.factor(factors))
        return product_of(factors)

    def goes_on(self, last: Node) -> bool:
        """Whether the argument of a function takes the next factor too: cos ωt, but sin θ cos θ."""
        token = self.peek()
        if token.text == "(" and not token.spaced and not letters(last):
            return isinstance(last, (Number, Quotient))  # sin 2(α + β)
        if token.text == "(" and not token.spaced and isinstance(last, Letter):
            behind = self.items[self.at : self.partners.get(self.at, self.at)]
            return last.base in _WAVES and any(x.text in _PHASES for x in behind)  # sin ω(t − t₀)
        if token.spaced or token.kind not in ("letter", "number", "group") or not self.starts():
            return False
        if token.text == "d" and self.is_differential():
            return False
        share = isinstance(last, Quotient) and not letters(last)  # cos ½θ
        if not (share or isinstance(last, (Letter, Number, Power))) or self.spelled():
            return False
        return not (letters(last) and {each.base for each in letters(last)} <= _ANGLES)

    def root(self) -> Node:
        self.take()
        degree: Node = Number("2")
        if self.peek().kind == "open" and self.peek().text == "[":
            end = self.partners.get(self.at, self.at)
            degree = self.inner(self.items[self.at + 1 : end]).whole()
            self.at = end + 1
        of = ungrouped(self.inner(self.argument()).whole())
        if isinstance(degree, Number) and degree.text.isdecimal():
            return Root(of, int(degree.text))
        return Power(of, Quotient(Number("1"), degree))

    def braced(self) -> Node:
        self.take()
        of = self.inner(self.argument()).whole()
        if not self.is_sign("_^"):
            return of
        self.take()
        group = self.argument()
        if group and group[0].kind == "relation":
            group = group[1:]
        if any(each.kind == "words" for each in group):
            return Braced(of, words=written(group))
        try:
            return Braced(of, self.inner(group).whole())
        except UnreadError:
            return Braced(of, words=written(group))

    # Letters

    def dotted(self) -> Node:
        order = _DOTS[self.take().text]
        of = self.inner(self.argument()).whole()
        if isinstance(of, Rate) and of.dotted:
            return replace(of, order=of.order + order)
        return Rate(ungrouped(of), order, dotted=True)

    def bold(self) -> Node:
        self.take()
        argument = self.argument()
        if written(argument) == "∇":
            return self.sloped()
        of = self.inner(argument).whole()
        if isinstance(of, Product) and all(isinstance(each, Letter) for each in of.factors):
            of = Letter("".join(each.base for each in of.factors if isinstance(each, Letter)))
        return mapped(of, lambda x: replace(x, bold=True) if isinstance(x, Letter) else x)

    def marked(self) -> Node:
        mark = _MARKS[self.take().text]
        of = self.inner(self.argument()).whole()
        if isinstance(of, Product) and all(isinstance(each, Letter) for each in of.factors):
            of = Letter("".join(each.base for each in of.factors if isinstance(each, Letter)))
        if isinstance(of, Letter):
            return replace(of, mark=mark)
        if isinstance(of, (Rate, Primed)) and isinstance(of.of, Letter):
            return replace(of, of=replace(of.of, mark=mark))
        return Average(of) if mark == "bar" else of

    def styled(self) -> Node:
        style = _STYLES[self.take().text]
        text = written(self.argument())
        try:
            base = "".join(styled(each, style) for each in text)
        except KeyError:
            base = text
        if base == "𝒪" and self.peek().kind == "open":
            return self.order()
        return Letter(base)

    def slanted(self) -> Node:
        self.take()
        return self.inner(self.argument()).whole()

    # Scripts

    def scripted(self, node: Node) -> Node:
        """A factor with its index, power and primes, and with where it is taken."""
        count = 0
        while True:
            count = self.counted(count)
            if self.is_sign("_"):
                self.take()
                node = self.lowered(node, self.argument())
            elif self.is_sign("^"):
                self.take()
                node = self.raised(node, self.argument())
            elif self.peek().kind == "prime":
                self.take()
                node = primed(node)
            elif self.is_sign("!"):
                raise UnreadError("a factorial", self.place())
            elif self.peek().kind == "bar" and self.is_sign("_", 1):
                self.take()
                node = self.taken(node)
            elif self.peek().kind == "open" and self.is_called(node):
                node = self.called(node)
            else:
                return node

    def lowered(self, node: Node, group: Sequence[Token]) -> Node:
        text = written(group)
        indexed = with_index(node, text)
        if indexed is not None:
            return indexed
        if any(each.kind == "relation" for each in group):
            return self.at_place(node, group)
        return framed(ungrouped(node), text) or Component(node, text)

    def raised(self, node: Node, group: Sequence[Token]) -> Node:
        text = written(group)
        if text in ("T", "⊤"):
            return Transposed(node)
        if text in ("∘", "°"):
            return Product((node, Unit("°")))
        if group and group[0].kind == "prime":
            return self.raised(primed(node), group[1:]) if group[1:] else primed(node)
        if text in ("*", "⋆", "†") and isinstance(node, Letter):
            return replace(node, mark="star" if text != "†" else "dagger")
        named = len(group) == 1 and group[0].kind in ("words", "upright") and len(text) > 1
        number = len(group) == 3 and group[0].text == "("
        if named or number or text in ("+", "-", "±", "∓", "⊥", "∥"):
            indexed = with_index(node, text if not number else f"({text.strip('()')})")
            if indexed is not None:
                return indexed
        exponent = self.inner(group).whole()
        return raised(node, exponent) if isinstance(node, Unit) else Power(node, exponent)

    def taken(self, node: Node) -> Node:
        """A bar with what stands below it, or below and above."""
        limits = self.limits()
        below = limits.get("_", ())
        if "^" in limits:
            return At(node, sub=f"{written(below)}^{written(limits['^'])}")
        return framed(ungrouped(node), written(below)) or self.at_place(node, below)

    def at_place(self, node: Node, group: Sequence[Token]) -> Node:
        relations = [i for i, each in enumerate(group) if each.text == "="]
        if len(relations) != 1:
            return At(node, sub=written(group))
        left, right = group[: relations[0]], group[relations[0] + 1 :]
        return At(node, self.inner(left).whole(), self.inner(right).whole())

    def is_called(self, node: Node) -> bool:
        """Whether the bracket that follows holds the places of a function."""
        token = self.peek()
        end = self.partners.get(self.at)
        core = node.of if isinstance(node, (Rate, Primed)) else node
        if token.text != "(" or token.spaced or end is None or not isinstance(core, Letter):
            return False
        inside = self.items[self.at + 1 : end]
        time = len(inside) > 2 and inside[0].text == "t" and inside[1].text == "="
        if time and not any(each.kind == "relation" for each in inside[2:]):
            return True
        if self.related.get(self.at) or (isinstance(node, Rate) and not node.dotted):
            return False
        if core in self.reading.functions:
            return True
        if any(each.kind == "open" for each in inside) or len(inside) > 24:
            return False
        return self.is_place(inside)

    def is_place(self, inside: Sequence[Token]) -> bool:
        try:
            place = self.inner(inside).whole()
        except UnreadError:
            return False
        if isinstance(place, Tuple):
            return all(map(is_place, place.entries)) and bool(letters(place))
        if place == Number("0") or (isinstance(place, Letter) and place.base == "t"):
            return True
        guessed = self.reading.calls and not self.reading.functions
        return guessed and is_place(place) and not isinstance(place, Number)

    def called(self, node: Node) -> Node:
        start, end = self.at, self.partners[self.at]
        inside = self.items[start + 1 : end]
        self.at = end + 1
        if any(each.kind == "relation" for each in inside):
            inside = inside[2:]
        return Call(node, self.inner(inside).entries())

    # Fractions and derivatives

    def fraction(self) -> Node:
        self.take()
        over, under = self.argument(), self.argument()
        head = head_of((*over, Token("sign", "/", 0), *under))
        if head is None:
            return Quotient(self.inner(over).whole(), self.inner(under).whole())
        return self.operation(head)

    def operation(self, head: Head, frame: str = "") -> Node:
        """A derivative; what it acts on stands in it, or behind it."""
        if not head.of and self.peek().kind == "bar" and self.is_sign("_", 1):
            self.at += 2
            frame = written(self.argument())
        of = self.inner(head.of).whole() if head.of else self.operand()
        by = [self.inner(each).whole() for each in head.by]
        node = derivative_of(head.sign, of, by)
        return (frame and framed(node, frame)) or node

    def operand(self) -> Node:
        """What an operator acts on: brackets, a derivative, or the factors that stand there."""
        if not self.starts():
            raise self.missing("what a derivative acts on")
        alone = self.peek().kind == "open" or self.peek().text in FRACTIONS
        factors = [self.factor([])]
        alone = alone and bool(letters(factors[0]))  # nobody differentiates a number
        while not alone and self.starts():
            factors.append(self.factor(factors))
        return ungrouped(product_of(factors))

    def differentiated(self, sign: str) -> Node | None:
        """A derivative on the line, d/dt or dx/dt, or a differential; None if d is a letter."""
        start, first = self.at, self.take()
        order = 1
        if self.is_sign("^") and written((self.peek(1),)).isdecimal():
            order = int(written((self.peek(1),))[:1])
            self.at += 2
        close = self.peek().position <= self.items[self.at - 1].position + 1
        loose = first.kind != "letter" or order > 1 or self.integrals > 0
        of: Node | None = None
        if not self.is_sign("/") and self.is_named() and (close or loose or sign == "∂"):
            of = self.differential_of()
        elif self.peek().kind == "group" and first.kind != "letter":
            inner = self.inner(self.peek().group).whole()
            of = inner if isinstance(inner, (Letter, Rate)) else None
            self.at += of is not None
        elif self.peek().kind == "open" and close:
            of = ungrouped(self.bracket()) if self.at in self.partners else None
        if self.is_sign("/") and is_operator(self.peek(1), sign):
            by: list[Node] = []
            behind = self.at
            self.take()
            while is_operator(self.peek(), sign) and len(by) < 9:
                self.take()
                if not self.is_named():
                    break
                variable = self.differential_of()
                by += [variable] * self.exponent()
            if by:
                check_order(order, by, first.position)
            if by and of is not None:
                return derivative_of(sign, of, by)
            if by:
                return derivative_of(sign, self.operand(), by)
            self.at = behind
        usual = sign == "∂" or self.reading.differentials or loose
        usual = usual and not (self.reading.lettered and (order > 1 or isinstance(of, Rate)))
        if of is not None and usual and self.items[self.at - 1].kind != "close":
            return Differential(of, order, sign == "∂")
        self.at = start
        return None

    def is_named(self) -> bool:
        """Whether a letter begins here, with its accents."""
        token = self.peek()
        dressed = any(token.text in accents for accents in (BOLD, _DOTS, _MARKS, _STYLES))
        named = token.kind == "upright" and token.text not in FUNCTIONS
        return (token.kind == "letter" and not self.spelled()) or dressed or named

    def differential_of(self) -> Node:
        """A letter with its accents and index, without its powers and places."""
        node = self.primary([]) if self.peek().text != "d" else Letter(self.take().text)
        while self.is_sign("_") or self.peek().kind == "prime":
            if self.take().kind == "prime":
                node = primed(node)
            else:
                node = self.lowered(node, self.argument())
        return node

    def exponent(self) -> int:
        if self.is_sign("^") and written((self.peek(1),)).isdecimal():
            self.at += 2
            return min(int(written((self.items[self.at - 1],))), 9)
        return 1

    def partial(self) -> Node:
        if self.is_sign("_", 1):
            self.at += 2
            by = self.inner(self.argument()).whole()
            return Derivative(self.operand(), by.entries if isinstance(by, Tuple) else (by,))
        node = self.differentiated("∂")
        if node is None:
            raise UnreadError("∂ without what it acts on", self.place())
        return node

    def nabla(self) -> Node:
        self.take()
        return self.sloped()

    def sloped(self) -> Node:
        """What ∇ acts on, with the product between them."""
        product = ""
        if self.is_sign("_"):
            self.take()
            self.argument()
        if self.is_sign("·×"):
            product = self.take().text
        elif self.is_sign("^"):
            self.take()
            self.argument()
            product = "²"
        if not self.starts():
            return Letter("∇")
        return Nabla(ungrouped(self.factor([])), product)

    # Integrals, sums and limits

    def limits(self) -> dict[str, tuple[Token, ...]]:
        found: dict[str, tuple[Token, ...]] = {}
        while self.is_sign("_^"):
            sign = self.take().text
            found[sign] = self.argument()
        return found

    def is_differential(self, ahead: int = 0) -> bool:
        """Whether a d with its letter stands here, within an integral."""
        start = self.at
        self.at += ahead
        token = self.peek()
        letter = is_operator(unbraced(token), "d")
        self.at += 1
        if letter and self.is_sign("^"):
            self.at += 2
        found = letter and (self.is_named() or self.peek().kind == "group")
        self.at = start
        return found

    def integral(self) -> Node:
        """An integral, or several in a row; the innermost goes with the first differential."""
        position = self.peek().position
        bounds: list[tuple[Node | None, Node | None]] = []
        while self.peek().text in ("∫", "∮"):
            self.take()
            limits = self.limits()
            lower, upper = (self.inner(limits[x]).whole() if x in limits else None for x in "_^")
            bounds.append((lower, upper))
        self.integrals += 1
        by = self.differentials()
        of = self.integrand(in_front=bool(by))
        by += self.differentials()
        self.integrals -= 1
        for _ in () if by else bounds:
            of, variable = integrand_of(of, position)
            by = [*by, (variable, 1)]
        for variable, dimension in by:
            lower, upper = bounds.pop() if bounds else (None, None)
            of = Integral(ungrouped(of), variable, lower, upper, dimension)
        if bounds:
            raise UnreadError("an integral that does not say over what", position)
        return of

    def integrand(self, *, in_front: bool) -> Node:
        """What stands between ∫ and dx, or behind both."""
        if in_front:
            return self.term() if self.starts() else Number("1")
        if self.is_differential():
            return Number("1")
        terms = [self.signed()]
        while self.is_sign("+-") and not _has_differential(terms[-1]):
            terms.append(self.signed())
        if self.is_sign("·"):
            self.take()
        return terms[0] if len(terms) == 1 else Sum(tuple(terms))

    def differentials(self) -> list[tuple[Node, int]]:
        """The letters behind each d, with how often they count: d³r."""
        found = []
        while self.is_differential():
            self.take()
            dimension = self.exponent()
            found.append((self.differential_of(), dimension))
        return found

    def total(self) -> Node:
        sign = self.take().text
        limits = self.limits()
        below, above = limits.get("_", ()), limits.get("^", ())
        equals = next((i for i, each in enumerate(below) if each.text == "="), None)
        lower = self.inner(below[equals + 1 :]).whole() if equals is not None else None
        upper = self.inner(above).whole() if above else None
        names = tuple(Letter(each.text) for each in below[:equals] if each.kind == "letter")
        return Total(self.term(), names, lower, upper, sign)

    def limit(self) -> Node:
        self.take()
        group = self.limits().get("_", ())
        goes = next((i for i, each in enumerate(group) if each.text == "→"), None)
        if goes is None:
            raise UnreadError("a limit that does not say of what", self.place())
        letter, place = group[:goes], group[goes + 1 :]
        return Limit(self.term(), self.inner(letter).whole(), self.inner(place).whole())

    def matrix(self) -> Node:
        token = self.take()
        if token.text not in MATRICES:
            raise UnreadError("cases within a formula", token.position)
        rows = [
            tuple(self.cell(cell) for cell in parted(row, "align"))
            for row in parted(token.group, "break")
            if row
        ]
        if not rows:
            raise UnreadError("a matrix with nothing in it", token.position)
        return Matrix(tuple(rows), MATRICES[token.text] or "(")

    def cell(self, items: Sequence[Token]) -> Node:
        shown = [each for each in items if each.kind != "quad"]
        while shown and shown[-1].kind in ("comma", "stop"):
            shown.pop()
        return self.inner(shown).whole() if shown else Omitted()


def _has_differential(node: Node) -> bool:
    return any(isinstance(each, Differential) for each in walked(node))


_PRIMARIES: Final[dict[str, Callable[[Grammar], Node]]] = {
    "number": Grammar.number,
    "letter": Grammar.letter,
    "dots": Grammar.omitted,
    "group": Grammar.group,
    "open": Grammar.bracket,
    "bar": Grammar.bar,
    "environment": Grammar.matrix,
    "∂": Grammar.partial,
    "∇": Grammar.nabla,
    "∫": Grammar.integral,
    "∮": Grammar.integral,
    "Σ": Grammar.total,
    "Π": Grammar.total,
}
_COMMANDS: Final[dict[str, Callable[[Grammar], Node]]] = {
    **dict.fromkeys(_DOTS, Grammar.dotted),
    **dict.fromkeys(BOLD, Grammar.bold),
    **dict.fromkeys(_MARKS, Grammar.marked),
    **dict.fromkeys(_STYLES, Grammar.styled),
    **dict.fromkeys(_PLAIN, Grammar.slanted),
    **dict.fromkeys(FRACTIONS, Grammar.fraction),
    **dict.fromkeys(_BRACES, Grammar.braced),
    r"\sqrt": Grammar.root,
    r"\lim": Grammar.limit,
}
