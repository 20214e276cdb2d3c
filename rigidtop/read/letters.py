"""Letters: with fonts, accents, indices and primes, and what the brackets behind them hold."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

import sympy

from rigidtop.read import signs
from rigidtop.read.cursor import Cursor, Token
from rigidtop.read.kinds import Sort
from rigidtop.read.look import (
    dressed,
    is_latin,
    is_list,
    is_product,
    operator_at,
    primed,
    shifted,
    spelling,
    styled,
)
from rigidtop.read.tex import BOLD, NOTHING, TEXTS, UPRIGHT, Piece, UnreadError, plain, said
from rigidtop.theory.symbols import VOCABULARY, Glyph

MOST_INDICES = 6
"""ω_{1,2,…} is a list of no more."""


class Letters(Cursor):
    """Takes letters."""

    def spelled(self) -> str:
        """A function spelled with single letters, or a row of letters that looks like a word."""
        run = ""
        for i in range(40):
            piece = self.peek(i)
            if not (is_latin(piece.text) and piece.text.isascii()):
                break
            if i and piece.position != self.peek(i - 1).position + 1:
                break
            run += piece.text
        for name in signs.SPELLED:
            if run.startswith(name):
                return name
        if not self.open:
            return ""
        bracketed = self.peek(len(run)).text in ("(", "[", r"\left", r"\{")
        if (
            run == "det"
            or (run == "ve" and self.last == "SIGN")
            or (bracketed and run in signs.DOUBTFUL | {"Re", "Im"})
        ):
            return run
        if run.startswith("ln"):
            return "ln"
        before = self.items[self.at - 1] if self.at else Piece("", -9)
        joined = is_latin(before.text) and before.position + 1 == self.peek().position
        cut = min((run.find(name) for name in signs.SPELLED if name in run), default=len(run))
        if not joined and signs.ENERGY.fullmatch(run) and self.peek(len(run)).text in ("=", ""):
            return run
        begins = self.last in signs.BEFORE_SIDE and self.peek(len(run)).text in ("=", "")
        named = len(run) > 2 and run.isupper() and self.peek(len(run)).text == "_"
        if not joined and (
            run in ("and", "for")
            or (begins and signs.SEGMENT.fullmatch(run))
            or (named and self.last in signs.BEFORE_SIDE)
        ):
            return run
        twice = cut == 3 and any(a == b for a, b in pairwise(run[:cut]))
        return (
            run
            if (twice or cut >= 4) and not joined and not is_product(run[:cut], self.habits.letters)
            else ""
        )

    def lettered(self) -> Iterator[Token]:
        """A letter, with the brackets behind it if it is a function of what they hold."""
        position, before, dress = self.peek().position, self.last, self.peek().text
        glyph = self.letter_or_energy()
        if self.open and dress in BOLD:
            arrow = dress in signs.ARROWS_OVER
            if self.worn.setdefault(glyph, arrow) is not arrow:
                reason = f"{glyph.base} in bold type, and with an arrow: one letter, or two?"
                raise UnreadError(reason, position)
        above = plain(self.peek(1)) if self.peek().text == "^" else ""
        named = "e" in self.habits.letters and above.isdigit()  # an eccentricity, a charge
        if glyph == Glyph("e") and above and not named:
            piece = self.take()
            yield Token("EXPONENTIAL", "e", position)
            yield from self.braced(self.argument(piece), piece.position)
            return
        on = self.behind(self.at + 2 * bool(above))
        letter_behind = self.open and self.starts_letter(on)
        bracket_behind = self.open and self.peek(on - self.at).text == "("
        if above and glyph.base in signs.ORDERS and (letter_behind or bracket_behind):
            raise UnreadError(f"{glyph.base} with a power, and then what it is of?", position)
        if glyph == Glyph("Σ") and letter_behind and glyph not in self.habits.said:
            raise UnreadError("Σ before a letter: a factor, or a sum, \\sum?", position)
        change = glyph.base == "Δ" or (glyph == Glyph("δ") and before != "NUMBER")
        followed = self.starts_letter(self.at) and not operator_at(self.items, self.at)[0]
        if self.open and change and followed:
            if glyph.sub:
                raise UnreadError("Δ with an index: the change of a letter, or a factor?", position)
            of = self.letter_or_energy()
            glyph = replace(of, base=glyph.base + of.base)
        if glyph == Glyph("π"):
            if "π" in self.habits.letters and before != "NUMBER":
                raise UnreadError("π: the number, or the letter that the file has?", position)
            if [self.peek(i).text for i in range(3)] == ["(", "t", ")"]:
                raise UnreadError("π of the time: another letter than the number", position)
            yield Token("SYMBOL", sympy.pi, position)
            return
        acts = (
            glyph.base in signs.OPERATORS and not glyph.sub and not operator_at(self.items, on)[0]
        )
        if acts and (letter_behind or (bracket_behind and glyph.base == "𝒟")):
            reason = f"{glyph.base} before a letter: a derivative or an operator, or a factor?"
            raise UnreadError(reason, position)
        found = list(self.resolved(glyph, position))
        if self.open:
            self.arguments(glyph)
            self.functional(glyph)
        else:
            self.of_time()
        yield from found

    def letter_or_energy(self) -> Glyph:
        """A letter, or KE and PE, which are one."""
        self.skip()
        pair, position = self.peek().text + self.peek(1).text, self.peek().position
        if self.open and pair in ("KE", "PE") and self.peek(1).position == position + 1:
            self.at += 2
            return self.scripts(Glyph(pair))
        return self.letter()

    def resolved(self, glyph: Glyph, position: int) -> Iterator[Token]:
        """The symbol of a letter; of one with dots or several indices, what it is made of."""
        several = signs.BOTH.get(glyph.sub, glyph.sub).split(",") if self.two_signs else []
        several = several or glyph.sub.split(",")
        known = self.known(glyph)
        if known is None and self.peek().text == "^" and plain(self.peek(1)) == "2":
            known = self.notation.symbol(replace(glyph, base=glyph.base + "²"))
            self.at += 2 if known is not None else 0
        several_of = known is None or (
            self.two_signs and all(x.isdigit() or x in "+−" for x in several)
        )
        if several_of and 1 < len(several) <= (2 if self.open else MOST_INDICES):
            made = tuple(self.known(replace(glyph, sub=sub)) for sub in several)
            if None not in made:
                yield Token("CHOICE", made, position)
                return
        if known is not None:
            yield Token("SYMBOL", known, position)
            return
        for order, accent in {"dot": ((1, ""),), "ddot": ((1, "dot"), (2, ""))}.get(
            glyph.accent, ()
        ):
            letter = self.known(replace(glyph, accent=accent))
            if letter is not None:
                yield Token("RATE", order, position)
                yield Token("_BEGIN", "{", position)
                yield Token("SYMBOL", letter, position)
                yield Token("_END", "}", position)
                return
        hint = ""
        if glyph.sub in frozenset("ijkl"):
            hint = ": write an equation for each value of the index"
        elif glyph == Glyph("d"):
            hint = r": a derivative is a dot or \frac{d…}{dt}"
        raise UnreadError(f"no symbol {spelling(glyph)} in this notation{hint}", position)

    def known(self, glyph: Glyph) -> sympy.Symbol | None:
        """The symbol of a glyph, also of a unit vector with a hat that it does not need."""
        found = self.notation.symbol(glyph)
        if found is None and "(ext)" in glyph.sub:
            sub = glyph.sub.replace("(ext)", "(e)" if "," in glyph.sub else "ext")
            found = self.notation.symbol(replace(glyph, sub=sub))
        if found is not None or glyph.accent != "hat":
            return found
        bare = self.notation.symbol(replace(glyph, accent="", bold=True))
        return bare if bare in VOCABULARY and VOCABULARY[bare].unit == "" else None

    def of_time(self) -> None:
        """Leave out that a symbol of a table depends on time or place: ω(t), ρ(r)."""
        at = self.behind(self.at)
        if at >= len(self.items) or self.items[at].text != "(":
            return
        inner, end = self.bracketed(at)
        inside, place = plain(*inner), self.items[at].position
        if inside == "t" and self.called is not None:
            reason = "of the time, or times t? leave (t) out, or t without brackets"
            raise UnreadError(reason, place)
        if inside in ("t", "r"):
            self.at = end + 1
        elif inside == "0" or inside.startswith("t="):
            raise UnreadError("a value at one time", place)

    def arguments(self, glyph: Glyph) -> None:
        """Decide whether brackets behind a letter hold what it is a function of.

        That it depends on time, x(t), is left out.
        """
        at = self.behind(self.at, NOTHING - {" ", r"\,"})
        if at < len(self.items) and self.items[at].text == "{}":
            inner = [p for p in self.items[at].group if p.text not in NOTHING]
            if len(inner) > 2 and (inner[0].text, inner[-1].text) == ("(", ")"):
                self.items[at : at + 1] = inner  # R{(θ)}
        if at >= len(self.items) or self.items[at].text != "(":
            return
        inner, end = self.bracketed(at)
        if end < 0:
            return
        inside, place = plain(*inner), self.items[at].position
        texts = {piece.text for piece in inner}
        function = any(known == glyph for known, _ in self.habits.functions)
        raised = end + 1 < len(self.items) and self.items[end + 1].text == "^"
        doubtful = inside == "0" or (self.one_letter(inner) and texts & signs.RATED)
        if raised and doubtful and not function:
            reason = f"{spelling(glyph)} of what stands in brackets, or times its power?"
            raise UnreadError(reason, place)
        worked = texts & signs.FUNCTIONS or not any(p.text.strip("0123456789.,+-") for p in inner)
        if self.commas(at) and worked and not function:
            raise UnreadError(f"{spelling(glyph)} of what stands in brackets, or a row?", place)
        if inside == "t":
            if self.called is not None and glyph.base not in signs.TIMELY:
                reason = "of the time, or times t? leave (t) out, or t without brackets"
                raise UnreadError(reason, place)
            if function:
                self.calls.add(at)
            else:
                self.at = end + 1
        elif inside.startswith("t="):
            del self.items[at + 1 : at + 3]
            self.calls.add(at)
        elif (
            inside == "0"
            or self.one_letter(inner)
            or self.commas(at)
            or is_list(inner)
            or glyph.base in signs.ORDERS
            or self.of_known(glyph, inner)
            or self.habits.is_a(glyph, Sort.FUNCTION)
        ):
            self.calls.add(at)
        elif glyph in self.habits.timed and "t" in texts and not function:
            raise UnreadError(f"{spelling(glyph)} at the time in brackets, or times it?", place)
        elif self.habits.is_a(glyph, Sort.NUMBER) and not function and "t" not in texts:
            return  # a mass, a length: times what stands in brackets
        elif (
            function
            or glyph.base in signs.POTENTIALS
            or inside.replace(".", "").isdigit()
            or (not raised and re.fullmatch(r"\|?\w\|?/\w", inside))
        ):
            raise UnreadError(f"{spelling(glyph)} of what stands in brackets, or times it?", place)

    def functional(self, glyph: Glyph) -> None:
        """Decide whether square brackets behind a letter hold what it is a functional of, S[q]."""
        at = self.behind(self.at, NOTHING - {" ", r"\,"})
        inner, end = self.bracketed(at, ("[", "]"))
        if end < 0:
            return
        texts = [piece.text for piece in inner]
        bracket = texts.index("(") if "(" in texts else len(inner)
        alone = self.one_letter(inner[:bracket]) and texts[-1:] in ([")"], texts[bracket - 1 :])
        several = self.commas(at) and glyph.base[0].isupper()  # no commutator behind an i
        if several or alone or self.of_known(glyph, inner):
            self.calls.add(at)
        elif any(known == glyph for known, _ in self.habits.functions):
            reason = f"{spelling(glyph)} of what stands in brackets, or times it?"
            raise UnreadError(reason, self.items[at].position)

    def of_known(self, glyph: Glyph, inner: Sequence[Piece]) -> bool:
        """Whether a sum has a term that the letter is a function of elsewhere."""
        return any((glyph, term) in self.habits.functions for term in shifted(inner))

    def letter(self) -> Glyph:
        """A letter with its fonts, accents, index and prime, in any order."""
        dresses: list[Piece] = []
        while self.peek().text in signs.DRESSES:
            dresses.append(self.take())
            self.skip()
        piece = self.take()
        text = piece.text
        if text in signs.STYLES:
            glyph = Glyph(styled(plain(*self.argument(piece)), text, piece.position))
        elif text == "{}":
            glyph = self.dressed(piece, {dress.text for dress in dresses})
        elif text == r"\nabla":
            glyph = Glyph("∇", bold=True)
        elif text in signs.LETTERS:
            glyph = Glyph(signs.LETTERS[text])
        elif self.is_alphabetic(text):
            glyph = Glyph(text)
        elif text in ("0", "1") and any(dress.text in BOLD for dress in dresses):
            glyph = Glyph(text, bold=True)
        elif text in TEXTS and self.peek().text == "{}":
            glyph = Glyph(said(self.argument(piece)))
        elif text.startswith("\\") and len(text) > 1:
            known = "of TeX" if text[1:].isalpha() else "here"
            raise UnreadError(f"the command {text} is not known {known}", piece.position)
        elif len(text) == 1 and text.isalpha():
            raise UnreadError(f"words inside a formula: {text!r}", piece.position)
        else:
            reason = f"{text or 'the end'} where a symbol should be"
            raise UnreadError(reason, piece.position)
        for dress in reversed(dresses):
            glyph = dressed(glyph, dress)
        glyph = self.scripts(glyph)
        still = replace(glyph, accent="" if "dot" in glyph.accent else glyph.accent)
        spatial = self.crossed and self.habits.is_a(still, Sort.SPATIAL)
        return replace(glyph, bold=True) if spatial else glyph

    def dressed(self, piece: Piece, worn: set[str]) -> Glyph:
        """The letter in braces; several beneath one arrow, or upright, are one letter."""
        whole = worn & ({r"\vec", r"\overrightarrow", r"\overline"} | UPRIGHT)
        written = plain(piece)
        if self.open and whole and len(written) > 1 and written.isascii() and written.isalnum():
            return Glyph(written)
        if written in ("0", "1") and worn & BOLD:
            return Glyph(written, bold=True)
        if not piece.group:
            raise UnreadError("an empty group", piece.position)
        inner = self.within(piece.group, self.depth)
        glyph = inner.letter()
        inner.skip()
        if inner.at < len(inner.items):
            raise UnreadError("no single symbol in braces", piece.position)
        return glyph

    def scripts(self, glyph: Glyph) -> Glyph:
        while True:
            piece = self.peek()
            if piece.text == "'":
                self.take()
                glyph = primed(glyph)
            elif piece.text == "_":
                self.take()
                sub = said(self.argument(piece)).replace("-", "−")
                sub = sub if self.open else sub.replace(" ", "")
                if not sub:
                    raise UnreadError("an empty index", piece.position)
                if sub.startswith(","):
                    raise UnreadError("a comma before an index: a derivative?", piece.position)
                if glyph.sub and not glyph.sub.startswith("("):
                    raise UnreadError("two indices", piece.position)
                glyph = replace(glyph, sub=",".join(filter(None, (sub, glyph.sub))))
            elif piece.text == "^" and self.peek(2).text == "_":
                at = self.at  # x^2_1 is x_1^2
                self.items[at : at + 4] = [*self.items[at + 2 : at + 4], *self.items[at : at + 2]]
            elif piece.text == "^":
                found = self.raised(glyph, self.peek(1))
                if found is None:
                    return glyph
                self.at += 2
                glyph = found
            else:
                return glyph

    def raised(self, glyph: Glyph, above: Piece) -> Glyph | None:
        """The letter with what stands above it, if that is no power."""
        if glyph.base == "e" and not glyph.bold:
            return None
        written = plain(above)
        if written and set(written) == {"′"}:
            for _ in written:
                glyph = primed(glyph)
            return glyph
        if written in ("*", r"\ast", r"\star", r"\dagger", "+", "-"):
            sign = {"-": "⁻", "+": "⁺", r"\dagger": "†"}.get(written, "*")
            return replace(glyph, base=glyph.base + sign)
        first = above.group[0].text if above.group else above.text
        bracketed = re.fullmatch(r"\(\w{1,4}\)", written)
        worded = first in TEXTS | UPRIGHT and len(written) > 1 and len(above.group) == 2
        if bracketed or worded or (written == "ext" and not self.open):
            sub = f"({written.strip('()')})"
            return replace(glyph, sub=",".join(filter(None, (glyph.sub, sub))))
        if (glyph.base, written) in self.habits.components and not glyph.sub:
            reason = f"{written} above {glyph.base}: a component, or a power?"
            raise UnreadError(reason, above.position)
        written = re.sub(r"\\(?:dot|bar)", "", written)
        indices = len(written) > 1 and (
            written.isalpha() or re.fullmatch(r"\(.*[a-z].*\)", written)
        )
        index = written in signs.INDEXES | self.below
        if self.open and (indices or (index and not glyph.bold)):
            raise UnreadError(f"{written} above a letter: an index, or a power?", above.position)
        return None

    def is_letter(self, at: int) -> bool:
        """Whether what stands there is one letter, whatever it has above or at it."""
        return self.one_letter(self.items[at : at + 2])

    def one_letter(self, inner: Sequence[Piece]) -> bool:
        found = self.within(inner)
        try:
            found.letter()
        except UnreadError:
            return False
        return bool(inner) and found.at >= len(found.items)

    def starts_letter(self, at: int) -> bool:
        """Whether a letter begins there."""
        while at < len(self.items) and self.items[at].text in signs.LEFT_OUT:
            at += 1
        text = self.items[at].text if at < len(self.items) else ""
        if text == "{}":
            group = self.items[at].group
            return bool(group) and self.within(group).starts_letter(0)
        known = text in signs.DRESSES or text in signs.STYLES or text in signs.LETTERS
        return known or self.is_alphabetic(text)

    def is_alphabetic(self, text: str) -> bool:
        """Whether it is a letter that formulas have: in a table any may stand."""
        return len(text) == 1 and text.isalpha() and (not self.open or is_latin(text))
