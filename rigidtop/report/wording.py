"""Words, tables and captions in the letters of a notation, translated as formulas are.

What is written in sentences names the same quantities as the equations beside it, so each letter
of the notes in them becomes what the notation has for it: where angles are counted from another
axis, φ becomes φ − ½π.  Letters that are no symbols of the notes stay as they are.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, TypeVar

from rigidtop.notation import Notation
from rigidtop.notation.characters import TEX_GREEK
from rigidtop.notation.convention import MEANINGS
from rigidtop.notation.judged import judgement_in
from rigidtop.notation.translate import Image
from rigidtop.proof.verdict import Judgement
from rigidtop.report.blocks import Block, TableBlock, walked
from rigidtop.theory.symbols import VOCABULARY, phi, psi
from rigidtop.typeset.latex import latex
from rigidtop.typeset.words import parts

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Canvas

    from rigidtop.figures.drawing import Drawing

T = TypeVar("T")

WORDS = frozenset(
    {"about", "asks", "columns", "content", "method", "opens", "problem", "reason", "rows", "says"}
    | {"statement", "title", "value", "what", "words"}
)
"""The fields that are read as sentences."""

_GREEK = "|".join(map(re.escape, TEX_GREEK.values()))
_CORE = rf"(?:\\(?:mathbf|boldsymbol|mathcal)\{{[^{{}}]*\}}|(?:{_GREEK})(?![A-Za-z])|[A-Za-z])"
LETTER = re.compile(
    r"\\(?:mathrm|text|operatorname)\{[^}]*\}"
    rf"|(?P<letter>(?:\\(?:d?dot|hat)\{{{_CORE}\}}|{_CORE})(?:_\{{(?:[^{{}}]|\\text\{{\w*\}})*\}})?)"
    r"(?P<primes>'*)|\\[A-Za-z]+"
)
_BASE = re.compile(r"(?:\\[A-Za-z]+|[A-Za-z])(?=[}_]|$)")
_COMMAND = re.compile(r"\\[A-Za-z]+$")
_SAID = {quantity.meaning for quantity in VOCABULARY.values()} | {
    meaning for turned in MEANINGS.values() for meaning in turned.values()
}
_ANGLES = {latex(angle): angle for angle in (phi, psi)}
_TURNED = re.compile(r"\bR_[xyz]\(|\\dot R|R\^T")
"""Beside these R is the matrix of a rotation, and no distance."""


@dataclass(frozen=True)
class Wording:
    """What is said beside the formulas, with the letters of a notation in place of the notes'."""

    notation: Notation

    @cached_property
    def _images(self) -> Mapping[str, Image]:
        """What becomes of a letter of the notes as it stands in words."""
        images = self.notation.images.items()
        return {latex(x): image for x, image in images if x in VOCABULARY}

    @cached_property
    def _bases(self) -> Mapping[str, str]:
        """Letters that are others in every symbol: those of ωᵢ and L′ too."""
        new: dict[str, set[str]] = {}
        for symbol, glyph in self.notation.glyphs.items():
            if symbol in VOCABULARY:
                new.setdefault(VOCABULARY[symbol].glyph.base, set()).add(glyph.base)
        command = TEX_GREEK.get
        return {command(x, x): command(min(y), min(y)) for x, y in new.items() if len(y) == 1}

    def __call__(self, words: str) -> str:
        r"""A sentence, or a name in a figure, in the notation.

        >>> from rigidtop.notation import named
        >>> print(Wording(named("landau"))(r"$N = MgR \sin\theta$ is along $\mathbf L$, and 3 N"))
        $K = \mu gl \sin\theta$ is along $\mathbf{M}$, and 3 N
        >>> print(Wording(named("landau"))(r"at $\phi = 0$"))
        at $\phi - \tfrac{1}{2}\pi = 0$
        """
        if not self.notation.images:
            return words
        turned = bool(_TURNED.search(words))
        return "".join(
            f"${self._formula(part, turned)}$" if formal else part for formal, part in parts(words)
        )

    def _formula(self, tex: str, turned: bool) -> str:
        if tex in _ANGLES:  # a name, wherever the angle is counted from
            return latex(self.notation.named(_ANGLES[tex]))
        whole = braced(tex)

        def other(match: re.Match[str]) -> str:
            letter = match["letter"]
            if not letter or (turned and letter[0] == "R"):
                return match[0]
            before, behind = whole[: match.start()].rstrip(), whole[match.end() :]
            alone = before[-1:] in ("", *"(=,[") and behind.lstrip()[:1] in ("", *")=,]")
            image = self._other(letter, match["primes"], alone)
            return image + " " * (behind[:1].isalpha() and bool(_COMMAND.search(image)))

        return LETTER.sub(other, whole)

    def _other(self, old: str, primes: str, alone: bool) -> str:
        for name, rest in ((old + primes, ""), (old, primes)):
            image = self._images.get(name)
            if image is not None:
                tex = latex(image.expression)
                simple = alone or not (image.negative or image.quarters)
                return (tex if simple else f"({tex})") + rest
        new = _BASE.sub(lambda base: self._bases.get(base[0], base[0]), old, count=1)
        taken = {old, old + primes} & self._notes or {new, new + primes} & self._printed
        return (old if taken else new) + primes

    @cached_property
    def _printed(self) -> frozenset[str]:
        return frozenset(latex(self.notation.named(x)) for x in self.notation.glyphs)

    @cached_property
    def _notes(self) -> frozenset[str]:
        # Beside a square its root has the same letter.
        return frozenset(latex(x).removesuffix("^{2}") for x in VOCABULARY)

    def of(self, tree: T) -> T:
        """A claim, a page, a solution, a block …, with all its sentences in the notation."""
        if not self.notation.images:
            return tree
        return walked(tree, lambda x, name: self(x) if name in WORDS and isinstance(x, str) else x)

    def symbols(self, block: Block) -> Block:
        """A list of symbols with their meanings in the notation; any other block as it is."""
        if not (isinstance(block, TableBlock) and block.kind == "symbols" and self.notation.images):
            return block
        rows = ((x, self.meaning(str(meaning)), unit) for x, meaning, unit in block.rows)
        return replace(block, rows=tuple(rows))

    def meaning(self, words: str) -> str:
        r"""What a symbol of the notation stands for, in its letters.

        It is of these that it speaks: of the notation's own angles and axes.  What a table says
        itself stays.

        >>> from rigidtop.notation import named
        >>> Wording(named("goldstein")).meaning(r"velocity along $\mathbf e_1'$")
        "velocity along $\\mathbf e_1'$"
        """
        return self._roles(words) if words in _SAID else words

    @cached_property
    def _roles(self) -> Wording:
        return Wording(replace(self.notation, sequence="zyz"))

    def drawing(self, drawing: Drawing) -> Drawing:
        """A figure whose caption and names are in the notation; it does not move."""
        if not self.notation.images:
            return drawing
        from matplotlib.text import Text  # claims are judged without it

        if drawing.turned is not None:
            drawing = drawing.turned(self.notation.sequence)

        def draw(**values: float) -> Canvas:
            canvas = drawing.draw(**values)
            for name in dict.fromkeys(canvas.findobj(Text)):
                name.set_text(self(name.get_text()))
            return canvas

        title = self(drawing.title)
        return replace(drawing, title=title, draw=draw, wording=self, animate=None)

    def judgement(self, judgement: Judgement) -> Judgement:
        """A judgement with equations and words in the notation."""
        return self.of(judgement_in(self.notation, judgement))


def braced(tex: str) -> str:
    """A formula whose indices and letters with accents stand in braces, as in equations."""
    tex = re.sub(r"_(\\[a-z]+(?!\{)|[^{\\])(?![a-z]*\{)", r"_{\1}", tex)
    return re.sub(
        r"\\(d?dot|hat|mathbf|mathrm|boldsymbol) *(\\[A-Za-z]+(?!\{)|[A-Za-z])", r"\\\1{\2}", tex
    )
