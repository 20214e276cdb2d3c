"""Words, tables and captions in the letters of a notation, translated as formulas are.

What is written in sentences names the same quantities as the equations beside it, so each letter
of the notes in them becomes what the notation has for it: where angles are counted from another
axis, φ becomes φ − ½π.  Letters that are no symbols of the notes stay as they are.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, TypeVar

from rigidtop.notation import Notation
from rigidtop.notation.characters import FUNCTIONS, TEX_GREEK, opened
from rigidtop.notation.convention import MEANINGS
from rigidtop.notation.judged import judgement_in
from rigidtop.notation.translate import Image
from rigidtop.proof.verdict import Judgement
from rigidtop.proof.words import bold, light, parts
from rigidtop.report.blocks import Block, Table, walked
from rigidtop.theory.symbols import VOCABULARY, phi, psi
from rigidtop.typeset.latex import latex
from rigidtop.typeset.text import letter, text

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Canvas

    from rigidtop.figures.drawing import Drawing

T = TypeVar("T")

WORDS = frozenset(
    {"about", "asks", "columns", "content", "method", "opens", "problem", "reason", "rows", "says"}
    | {"statement", "title", "value", "what", "words"}
)
"""The fields that are read as sentences."""

LETTER = re.compile(
    rf"(?:{'|'.join(FUNCTIONS)}|const)(?![a-z])|R[xyz](?=\()|[a-z]{{3,}}"
    r"|(?P<letter>[^\W\d_][\u0302\u0307\u0308]?"
    r"(?:[₀-₉₊₋ᵢⱼₖₙₓ]+|_(?:\d,\d|[A-Za-z0-9]+|[^\W\d_])|⊥)?)(?P<primes>′*)"
)
_A_UNIT = re.compile(r"(?:kg|rad|[msNJW])(?:[·/](?:kg|rad|[msNJW]))*[²³]")
_SAID = {quantity.meaning for quantity in VOCABULARY.values()} | {
    meaning for turned in MEANINGS.values() for meaning in turned.values()
}
_ANGLES = {latex(angle): angle for angle in (phi, psi)}
_TURNED = re.compile(r"\bR[xyz]\(|R\u0307|Rᵀ")
"""Beside these R is the matrix of a rotation, and no distance."""


@dataclass(frozen=True)
class Wording:
    """What is said beside the formulas, with the letters of a notation in place of the notes'."""

    notation: Notation

    @cached_property
    def _images(self) -> Mapping[str, Image]:
        """What becomes of a letter of the notes as it stands in words."""
        images = self.notation.images.items()
        # Magnitude and vector share a letter in words, in every table.
        return {letter(VOCABULARY[x].glyph): image for x, image in images if x in VOCABULARY}

    @cached_property
    def _bases(self) -> Mapping[str, str]:
        """Letters that are others in every symbol: those of ωᵢ and L′ too."""
        new: dict[str, set[str]] = {}
        for symbol, glyph in self.notation.glyphs.items():
            if symbol in VOCABULARY:
                new.setdefault(VOCABULARY[symbol].glyph.base, set()).add(glyph.base)
        return {old: min(bases) for old, bases in new.items() if len(bases) == 1}

    def __call__(self, words: str) -> str:
        """A sentence in the notation.

        >>> from rigidtop.notation import named
        >>> Wording(named("landau"))("$N = MgR sin θ$ is along $𝐋$, and 3 N at $φ = 0$")
        '$K = μgl sin θ$ is along $𝐌$, and 3 N at $φ − ½π = 0$'
        """
        if not self.notation.images:
            return words
        turned = bool(_TURNED.search(opened(words)))
        return "".join(
            f"${self._formula(part, turned)}$" if formal else part for formal, part in parts(words)
        )

    def _formula(self, piece: str, turned: bool) -> str:
        if _A_UNIT.fullmatch(piece):
            return piece
        whole = opened(piece)
        named = self._images.get(unicodedata.normalize("NFC", whole.strip()))
        if (
            named is not None and named.quarters
        ):  # the name of an angle, wherever it is counted from
            return text(named.symbol)

        def other(found: re.Match[str]) -> str:
            if not found["letter"] or (turned and found["letter"][0] == "R"):
                return found[0]
            before, behind = whole[: found.start()].rstrip(), whole[found.end() :].lstrip()
            alone = before[-1:] in ("", *"(=,[") and behind[:1] in ("", *")=,]")
            old = light(found["letter"])
            made = opened(self._other(old, found["primes"], alone))
            return made if old == found["letter"] else bold(made[0]) + made[1:]

        return unicodedata.normalize("NFC", LETTER.sub(other, whole))

    def _other(self, old: str, primes: str, alone: bool) -> str:
        old = unicodedata.normalize("NFC", old)
        for known, rest in ((old + primes, ""), (old, primes)):
            image = self._images.get(known)
            if image is not None:
                shown = text(image.expression)
                simple = alone or not (image.negative or image.quarters)
                return (shown if simple else f"({shown})") + rest
        apart = unicodedata.normalize("NFD", old)
        new = unicodedata.normalize("NFC", self._bases.get(apart[0], apart[0]) + apart[1:])
        taken = {old, old + primes} & self._notes or {new, new + primes} & self._printed
        return (old if taken else new) + primes

    @cached_property
    def _printed(self) -> frozenset[str]:
        return frozenset(map(letter, self.notation.glyphs.values()))

    @cached_property
    def _notes(self) -> frozenset[str]:
        glyphs = (quantity.glyph for quantity in VOCABULARY.values())
        # Beside a square its root has the same letter.
        return frozenset(letter(replace(x, base=x.base.removesuffix("²"))) for x in glyphs)

    def of(self, tree: T) -> T:
        """A claim, a page, a solution, a block …, with all its sentences in the notation."""
        if not self.notation.images:
            return tree
        return walked(tree, lambda x, name: self(x) if name in WORDS and isinstance(x, str) else x)

    def symbols(self, block: Block) -> Block:
        """A list of symbols with their meanings in the notation; any other block as it is."""
        if not (isinstance(block, Table) and block.kind == "symbols" and self.notation.images):
            return block
        rows = ((x, self.meaning(str(said)), unit) for x, said, unit in block.rows)
        return replace(block, rows=tuple(rows))

    def meaning(self, said: str) -> str:
        """What a symbol of the notation stands for, in its letters.

        It is of these that it speaks: of the notation's own angles and axes.  What a table says
        itself stays.

        >>> from rigidtop.notation import named
        >>> Wording(named("goldstein")).meaning("rotational velocity along $e₁′$")
        'rotational velocity along $e₁′$'
        """
        return self._roles(said) if said in _SAID else said

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
                name.set_text(self.label(name.get_text()))
            return canvas

        title = self(drawing.title)
        return replace(drawing, title=title, draw=draw, wording=self, animate=None)

    def judgement(self, judgement: Judgement) -> Judgement:
        """A judgement with equations and words in the notation."""
        return self.of(judgement_in(self.notation, judgement))

    # --- Names in figures ------------------------------------------------------------------------

    @cached_property
    def _tex(self) -> Mapping[str, str]:
        """What becomes of a letter in the LaTeX of a figure."""
        # A rate is a letter of its own: that of an angle does not know where it is counted from.
        dotted = [x for x, quantity in VOCABULARY.items() if quantity.glyph.accent]
        made = {latex(x): latex(self.notation.written(x)) for x in dotted}
        for symbol, image in self.notation.images.items():
            shown = ("-" if image.negative else "") + latex(image.symbol)
            turn = {0: "", 1: r"+\pi/2", -1: r"-\pi/2"}[image.quarters]
            made[latex(symbol)] = f"({shown}{turn})" if turn else shown
        return made

    def label(self, words: str) -> str:
        r"""A name in a figure: words, with LaTeX between dollars.

        >>> from rigidtop.notation import named
        >>> print(Wording(named("landau")).label(r"$\mathbf{L}$ of $MgR\lambda_3$ in N"))
        $\mathbf{M}$ of $\mu gl I_{3}$ in N
        """
        parts = words.split("$")
        parts[1::2] = map(self._label, parts[1::2])
        return "$".join(parts)

    def _label(self, tex: str) -> str:
        if tex in _ANGLES:  # a name, wherever the angle is counted from
            return latex(self.notation.named(_ANGLES[tex]))
        tex = re.sub(r"_(\\[a-z]+(?!\{)|[^{\\])(?![a-z]*\{)", r"_{\1}", tex)
        tex = re.sub(r"\\(dot|hat)\s*(\\[a-z]+)", r"\\\1{\2}", tex)
        known, bases = (
            "|".join(re.escape(each) + r"(?![A-Za-z])" * (each[0] == "\\") for each in found)
            for found in (sorted(self._tex, key=len, reverse=True), self._tex_bases)
        )
        other = r"\\(?:mathrm|mathbf|boldsymbol)\{[^}]*\}|\\[A-Za-z]+|."
        parts = re.finditer(rf"({known})(?!_)|({bases or '(?!)'})|_\{{(\\[a-z]+)\}}|{other}", tex)
        made = (
            (m[1] and f"{self._tex[m[1]]} ")
            or (m[2] and self._tex_bases[m[2]])
            or (m[3] and f"_{{{self._label(m[3])}}}")  # what names a letter, such as p_ψ
            or m[0]
            for m in parts
        )
        return "".join(made).strip().replace("--", "")

    @cached_property
    def _tex_bases(self) -> Mapping[str, str]:
        return {
            TEX_GREEK.get(old, old): TEX_GREEK.get(new, new)
            for old, new in self._bases.items()
            if old != new
        }
