"""Fractions and derivatives, powers, roots and functions, sums and integrals."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from rigidtop.notation.convention import own
from rigidtop.read import signs
from rigidtop.read.cursor import Token
from rigidtop.read.letters import Letters
from rigidtop.read.look import operator, operator_at, spelling, terms
from rigidtop.read.tex import Piece, UnreadError, flat, plain, said
from rigidtop.theory import symbols as s
from rigidtop.theory.symbols import Glyph


class Calculus(Letters):
    """Takes what acts on something."""

    def fraction(self) -> Iterator[Token]:
        piece = self.take()
        over, below = self.argument(piece), self.argument(piece)
        found = operator(over, below, piece.position)
        if found is None:
            yield Token("FRACTION", piece.text, piece.position)
            yield from self.braced(over, piece.position)
            yield from self.braced(below, piece.position)
            return
        sign, rest, by = found
        self.taken_of(piece.position)
        body = [list(self.inside(rest))] if rest else []
        variables = [self.variable(part, piece.position) for part in by]
        if sign == "∂" and s.Lagrangian in self.notation.glyphs:
            body, variables = self.of_lagrangian(rest, body, variables)
        yield from self.derivative(sign, body, variables, piece.position)

    def variable(self, part: Sequence[Piece], position: int) -> list[Token]:
        """What is differentiated by; the time is, whether a table has it or not."""
        if [piece.text for piece in flat(part)] == ["t"]:
            return [Token("SYMBOL", signs.TIME, position)]
        return list(self.inside(part))

    def of_lagrangian(
        self, rest: Sequence[Piece], body: list[list[Token]], by: list[list[Token]]
    ) -> tuple[list[list[Token]], list[list[Token]]]:
        """∂L/∂θ is of ℒ where L is no number itself; ∂ℒ/∂t is what ℒ has of the time by itself."""
        if self.is_time(by):
            if [[x.value for x in part] for part in body] == [[s.Lagrangian]]:
                by = [[replace(x, value=s.t) for x in part] for part in by]
        elif [piece.text for piece in rest] == ["L"] and Glyph("L") not in self.notation.names:
            body = [[Token("SYMBOL", s.Lagrangian, rest[0].position)]]
        return body, by

    def is_time(self, by: Sequence[Sequence[Token]]) -> bool:
        return all(len(part) == 1 and part[0].value == signs.TIME for part in by)

    def taken_of(self, position: int) -> None:
        """Refuse brackets behind a derivative that may say where it is taken."""
        at = self.behind(self.at)
        if not self.open or at >= len(self.items) or self.items[at].text != "(":
            return
        inner, end = self.bracketed(at)
        if [piece.text for piece in inner] == ["t"]:
            self.at = end + 1
        elif plain(*inner) == "0" or self.one_letter(inner) or "t" in terms(inner):
            reason = "a derivative at a place, or times what stands in brackets?"
            raise UnreadError(reason, position)

    def derivative(
        self, sign: str, body: list[list[Token]], by: list[list[Token]], position: int
    ) -> Iterator[Token]:
        """The tokens of d^n…/dx^n, of a body that stands above the bar, or of none."""
        if self.is_time(by) and len(by) <= 2 and (sign == "d" or not self.open):
            yield Token("RATE", len(by), position)
            by = []
        else:
            yield Token("SLOPE" if body else "OPERATOR", sign, position)
        for part in (*body, *by):
            yield Token("_BEGIN", "{", position)
            yield from part
            yield Token("_END", "}", position)

    def operator(self, sign: str, count: int) -> Iterator[Token]:
        r"""A d or ∂ outside of a fraction: dx/dt, ``\partial_x``, or a differential."""
        start, position = self.at, self.peek().position
        self.at += count
        if sign == "∂" and not self.open:
            raise UnreadError(
                r"∂ outside of a fraction: write \frac{\partial…}{\partial…}", position
            )
        if sign == "∂" and self.peek().text == "_":
            piece = self.take()
            index = self.argument(piece)
            if plain(index[0] if len(index) == 1 else piece) in signs.RUNNING | {"_"}:
                raise UnreadError("∂ with an index: by what is it differentiated?", position)
            yield from self.derivative("∂", [], [self.variable(index, position)], position)
            return
        order = 1
        if self.peek().text == "^" and plain(self.peek(1)).isdigit():
            order = int(plain(self.peek(1))[:2])
            self.at += 2
        self.skip()
        apart = self.peek().position - self.items[start + count - 1].position
        if not self.starts_letter(self.at):
            upright = count > 1 or self.items[start].text == "{}"
            if sign == "d" and (upright or self.peek().text in ("(", "[")):
                reason = "d before more than a letter: a differential, or a factor?"
                raise UnreadError(reason, position)
            self.at = start
            if sign == "∂":
                raise UnreadError("∂ without what it is to act on", position)
            yield from self.lettered()
            return
        glyph, ahead = self.letter(), self.peek()
        if glyph.base == "E" and not glyph.sub and ahead.text in ("c", "k", "m", "p"):
            reason = f"E{ahead.text}: an energy, or a product? put an index, E_{ahead.text}"
            raise UnreadError(reason, position)
        behind = self.at
        self.skip()
        if self.peek().text == "/":
            below, n = operator_at(self.items, self.at + 1)
            if below == sign:
                self.at += 1 + n
                by = self.at
                if not self.starts_letter(self.at):
                    raise UnreadError("a derivative by what is no letter", position)
                self.letter()
                if order > 1:
                    raise UnreadError("a derivative of higher order on one line", position)
                body = list(self.resolved(glyph, position))
                variable = self.variable(self.items[by : self.at], position)
                yield from self.derivative(sign, [body], [variable], position)
                return
        self.at = behind
        if sign == "∂":
            raise UnreadError("∂ without what it is differentiated by", position)
        single = count == 1 and self.items[start].text == "d" and order == 1
        if not self.open and not self.integrals:
            raise UnreadError(r"a differential: a derivative is a dot or \frac{d…}{dt}", position)
        if single and (self.lonely_d or (apart > 1 and not self.integrals)):
            raise UnreadError(r"d: a differential or a letter? write \mathrm{d}", position)
        if order > 3:
            raise UnreadError("a differential of higher order", position)
        raised = ("", "²", "³")[order - 1]
        of, *more = self.resolved(glyph, position)
        if more or of.kind != "SYMBOL":
            reason = f"a differential of {spelling(glyph)}, which is no letter of this notation"
            raise UnreadError(reason, position)
        dressed = replace(glyph, base=f"d{raised}{glyph.base}", bold=glyph.bold and order == 1)
        yield Token("DIFFERENTIAL", (own(dressed), order, of.value), position)

    def power(self) -> Iterator[Token]:
        piece = self.take()
        letter, function = self.last == "SYMBOL", self.last == "FUNCTION"
        raised = self.argument(piece)
        if plain(*raised) in ("∘", "°"):
            raise UnreadError(signs.DEGREES, piece.position)
        if letter and plain(*raised) in ("0", "1"):
            raise UnreadError("0 or 1 above a letter: an index, or a power?", piece.position)
        if plain(*raised) in signs.TRANSPOSED:
            yield Token("TRANSPOSED", "T", piece.position)
        else:
            yield Token("POWER", "^", piece.position)
            yield from self.braced(raised, piece.position)
        at = self.behind(self.at)
        if function or at >= len(self.items) or self.items[at].text != "(":
            return
        inner, end = self.bracketed(at)
        if [piece.text for piece in inner] == ["t"]:
            self.at = end + 1  # ω²(t): that it depends on the time is left out
        elif self.open and letter and (self.commas(at) or self.one_letter(inner)):
            raise UnreadError("a power, and then what it is a function of?", piece.position)

    def root(self) -> Iterator[Token]:
        piece = self.take()
        index = "2"
        if self.peek().text == "[":
            inner, end = self.bracketed(self.at, ("[", "]"))
            index = plain(*inner)
            if end < 0 or not re.fullmatch("[2-9]", index):
                raise UnreadError("a root whose index is no small number", piece.position)
            if not self.open and index != "2":
                raise UnreadError("roots other than the square root are not read", piece.position)
            self.at = end + 1
        yield Token("ROOT", int(index), piece.position)
        yield from self.braced(self.argument(piece), piece.position)

    def function(self, name: str, position: int) -> Iterator[Token]:
        """A function; what stands in braces behind it must not be a sum."""
        at = self.behind(self.at + 2 * (self.peek().text == "^"))
        inner, end = self.bracketed(at, ("[", "]"))
        followed = self.items[end + 1].text if 0 <= end < len(self.items) - 1 else ""
        if followed == "(" or (followed and plain(*inner).isdigit()):
            power = Piece("^", self.items[at].position)  # \cos[2](x) of the package physics
            self.items[at : end + 1] = [power, Piece("{}", power.position, tuple(inner))]
        elif end >= 0:
            for i, text in ((at, "("), (end, ")")):
                self.items[i] = replace(self.items[i], text=text)
        yield Token("FUNCTION", name, position)
        self.skip()
        if self.peek().text == "^":
            self.last = "FUNCTION"
            yield from self.power()
            self.skip()
        if self.peek().text == "(" and self.called is None:
            self.called = self.depth
        group = self.peek().group
        if self.peek().text != "{}" or (group and group[0].text in ("(", r"\left")):
            return
        if {piece.text for piece in group} & {"+", "-", "/"} or self.several(group):
            reason = "what the function acts on: put it in brackets"
            raise UnreadError(reason, self.peek().position)

    def several(self, group: Sequence[Piece]) -> bool:
        """Whether what stands in braces is more than an angle with a number, or a rate times t."""
        found = list(self.inside(group))
        if len(found) > 1 and found[-1].value == self.notation.symbol(Glyph("t")):
            found.pop()
        kinds = [token.kind for token in found]
        if kinds[:1] in (["NUMBER"], ["FRACTION"], ["FUNCTION"]):
            symbols = kinds.count("SYMBOL") if kinds[0] == "NUMBER" else 0
            return symbols > 1
        return kinds.count("SYMBOL") > 1

    # Sums and integrals

    def limits(self) -> list[tuple[Piece, ...] | None]:
        """What stands below and above, in any order."""
        found: dict[str, tuple[Piece, ...]] = {}
        self.skip()
        while self.peek().text in ("_", "^"):
            piece = self.take()
            found[piece.text] = self.argument(piece)
            self.skip()
        return [found.get("_"), found.get("^")]

    def under(self) -> Iterator[Token]:
        """The index of a sum, and its limits."""
        position = self.peek().position
        below, above = self.limits()
        index, lower = below or (), None
        for i, piece in enumerate(index):
            if piece.text == "=" and above is not None:
                index, lower = index[:i], index[i + 1 :]
                break
        if above is not None and lower is None:
            raise UnreadError("a sum with an end and no start", position)
        over = said(index)
        if below is not None and not over.strip("_ "):
            raise UnreadError("a sum whose index is no letter", position)
        if not self.open and (above is not None or not re.fullmatch(r"[a-z]", over)):
            reason = f"a sum over {over!r}: only over an index, such as k"
            raise UnreadError(reason if below else "a sum without its index", position)
        yield Token("INDEX", over, position)
        for part in (lower, above):
            if part is not None:
                yield from self.braced(part, position)

    def integral(self) -> Iterator[Token]:
        piece = self.take()
        below, above = self.limits()
        if below is None and above is not None:
            raise UnreadError("an integral with an end and no start", piece.position)
        yield Token("INTEGRAL", "", piece.position)
        for part in (below, above):
            if part is not None:
                yield from self.braced(part, piece.position)
