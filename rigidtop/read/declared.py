r"""What the words of a text say that its letters are, in English, German and French.

>>> text = "A bead of mass $m$. The unit vectors $\\hat x$, $\\hat y$ are fixed, with a rate $n$."
>>> for letter in declared(text):
...     print(letter.text, *sorted(word.name for word in letter.words))
m MASS
\hat x FIXED UNIT_VECTOR
\hat y FIXED UNIT_VECTOR
n RATE
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum, auto

from rigidtop.read.prose import TextStructure, prose_of


class Word(Enum):
    """One thing that words say of a letter."""

    CONSTANT = auto()
    FIXED = auto()
    POSITIVE = auto()
    COMPLEX = auto()
    CYCLIC = auto()
    UNIT_VECTOR = auto()
    VECTOR = auto()
    MATRIX = auto()
    FRAME = auto()
    FUNCTION = auto()
    INDEX = auto()
    DERIVATIVE = auto()
    INERTIA = auto()
    ANGULAR_MOMENTUM = auto()
    MOMENTUM = auto()
    LAGRANGIAN = auto()
    HAMILTONIAN = auto()
    POTENTIAL = auto()
    ENERGY = auto()
    TORQUE = auto()
    STIFFNESS = auto()
    FORCE = auto()
    RATE = auto()
    VELOCITY = auto()
    ACCELERATION = auto()
    MASS = auto()
    TIME = auto()
    ANGLE = auto()
    POSITION = auto()
    LENGTH = auto()


WORDS = {
    Word.CONSTANT: r"constante?s?|conserved|konstante?[nrs]?|erhalten|conservée?s?",
    Word.FIXED: r"fixed|at rest|feste?[nrs]?|ortsfest|raumfest|fixes?",
    Word.POSITIVE: r"positi(?:ve|v|ver|ven|f|fs)",
    Word.COMPLEX: r"complexe?|komplexe?[nrs]?",
    Word.CYCLIC: r"cyclic|zyklisch|cyclique",
    Word.UNIT_VECTOR: r"unit vectors?|basis vectors?|einheitsvektor\w*|vecteurs? unitaires?",
    Word.VECTOR: r"vectors?|\w*vektor(?:en)?|vecteurs?",
    Word.MATRIX: r"matrix|matrices|tensors?|\w*matrizen|\w*tensor|matrice",
    Word.FUNCTION: r"functions?|funktion(?:en)?|fonctions?",
    Word.FRAME: r"frames?|coordinate system|bezugssystem|koordinatensystem|repère|référentiel",
    Word.INERTIA: r"moments? of inertia|principal moments?|moments?|inertia|\w*trägheitsmomente?"
    r"|moments? d'inertie",
    Word.ANGULAR_MOMENTUM: r"angular moment(?:um|a)|\w*drehimpulse?|moment cinétique",
    Word.DERIVATIVE: r"derivatives?|ableitung(?:en)?|dérivées?",
    Word.LAGRANGIAN: r"lagrangian|lagrange-?funktion|lagrangien",
    Word.HAMILTONIAN: r"hamiltonian|hamilton-?funktion|hamiltonien",
    Word.POTENTIAL: r"potential(?: energy)?|potentielle energie|énergie potentielle|potentiel",
    Word.ENERGY: r"energy|energies|\w*energie|énergie",
    Word.TORQUE: r"torques?|\w*drehmomente?|couple",
    Word.STIFFNESS: r"(?:spring|force) constant|stiffness|federkonstante|raideur",
    Word.FORCE: r"forces?|weight|tension|\w*kraft|\w*kräfte|poids",
    Word.RATE: r"rates?|angular (?:velocity|velocities|speed|frequency)|spin|frequency|frequencies"
    r"|winkelgeschwindigkeit|\w*frequenz|vitesse angulaire|pulsation|fréquence",
    Word.VELOCITY: r"velocity|velocities|speeds?|\w*geschwindigkeit|vitesses?",
    Word.MOMENTUM: r"moment(?:um|a)|impulse?|quantité de mouvement",
    Word.ACCELERATION: r"accelerations?|beschleunigung|accélération",
    Word.POSITION: r"positions?|cent(?:er|re)s? of (?:mass|gravity)|ortsvektor|schwerpunkt"
    r"|centre de masse",
    Word.MASS: r"mass(?:es)?|\w*massen?",
    Word.TIME: r"times?|period|zeit|periode|temps|période",
    Word.ANGLE: r"angles?|\w*winkel|latitude|longitude|phase",
    Word.LENGTH: r"lengths?|radius|radii|distances?|displacements?|heights?|amplitudes?"
    r"|coordinates?|\w*länge|\w*radius|abstand|auslenkung|höhe|koordinaten?|longueur|rayon"
    r"|hauteur|distance",
    Word.INDEX: r"index|indices",
}
"""The words for each; of what is taken for one nothing is left for those behind it."""

_ADJECTIVES = frozenset({Word.CONSTANT, Word.FIXED, Word.POSITIVE, Word.COMPLEX, Word.CYCLIC})
_SORTS = frozenset({Word.UNIT_VECTOR, Word.VECTOR, Word.MATRIX, Word.FUNCTION})
"""What stands behind a quantity: "position vector"."""

_WORDS = {
    word: re.compile(rf"\b(?:{words})\b" + r"\s*\Z" * (word not in _ADJECTIVES), re.I)
    for word, words in WORDS.items()
}
_OF = re.compile(
    r"\b(?:of|from|in|at|by|with|has|have|to|on|about|that|which|where|let|there|and|for|as"
    r"|between|across|along|above|below|without|sans|à|für|pour"
    r"|von|vom|der|des|im|mit|um|zur|zum|de|du|des|avec|par)\b|[^\w\s'-]",
    re.I,
)
"""What a noun begins behind, and ends before."""
_WHOLE = re.compile(
    r"\b(moments?|cent(?:er|re)s?) (of|d'|de) ?(inertia|mass|gravity|inertie|masse)\b", re.I
)
_DENIED = re.compile(r"\b(?:not|no|nicht|kein\w*|pas)\b", re.I)
_SUBJECT = re.compile(r"([\w\s'-]{1,80})\s(?:is|are|be|ist|sind|sei|est|sont)\s*\Z", re.I)
"""What is said to be a letter: "the moment about its axis is §"."""
_IN = re.compile(r"\b(?:in|im|dans) [^§.,;:]*\Z", re.I)
"""Words that say where an equation holds."""
_NEXT = r"(?:\s*\([^()§]{0,60}\))?\s*(?:,|,?\s*(?:and|or|und|oder|et|ou)\b)?\s*"
_LIST_BEFORE = re.compile(rf"(?:§{_NEXT})*\Z")
_LIST_BEHIND = re.compile(rf"(?:{_NEXT}[§=])*(?:\s*\([^()§]{{0,60}}\))?\s*,?\s*")
_VERB = re.compile(
    r"(?:which |that |both |all )?(?:is|are|be|being|denotes?|means?|stands? for|remains?|for the"
    r"|called|ist|sind|sei(?:en)?|bezeichne[nt]?|für die|est|sont|étant|désigne(?:nt)?)\s+"
    r"(?=([^§.;:,()]{1,60}))",
    re.I,
)
_NOUN = re.compile(
    r"(?=((?:the|an?|its|his|der|die|das|eine?|l[ae]|les|une?|constant|fixed|positive|konstant|fest|constante?s?)\b[^§.;:,()]{0,40}?)"
    r"\s*(?:[.;:,()]|\Z|\s(?:and|und|et)\s))",
    re.I,
)
"""A noun or an adjective directly behind a letter, without a verb."""

_FONTS = (
    "mathbf|boldsymbol|bm|vec|bf|mathrm|mathcal|mathbb|mathsf|rm|cal|hat|bar|tilde|dot|ddot"
    "|overline|widehat|underline|pmb"
)
_BRACES = r"\{[^{}]*(?:\{[^{}]*\}[^{}]*)*\}"
_LETTER = re.compile(
    rf"\s*(?P<letter>(?:\\(?:{_FONTS})\s*(?={_BRACES}|\\|[^\W\d_]|\s))*"
    rf"(?:{_BRACES}|\\[A-Za-z]+|[^\W\d_])(?:\s*_\s*(?:{_BRACES}|\\[A-Za-z]+|\w)|'|[₀-₉\u0300-\u036f])*)"
    r"(?P<argument>\s*\(\s*(?:[A-Za-z]|\\[a-z]+)(?:\s*,\s*(?:[A-Za-z]|\\[a-z]+))*\s*\))?"
    r"(?P<positive>(?:\s|\\[ ,;])*\(?(?:\s|\\[ ,;])*(?:(?P=letter)\s*)?>\s*0\s*\)?)?"
    r"\s*(?P<next>,|=|\\equiv|:=|\Z)"
)


@dataclass(frozen=True)
class Declared:
    """A letter and what a sentence says of it."""

    text: str
    """The letter as it is written, without what it depends on."""
    start: int
    words: frozenset[Word]


def declared(source: str) -> tuple[Declared, ...]:
    """What a text says of its letters, in order; one of which much is said comes several times.

    Raises RigidtopError for a text that is too long.
    """
    return tuple(_declared(prose_of(source, False)))


def _declared(prose: TextStructure) -> Iterator[Declared]:
    for number, formula in enumerate(prose.formulas):
        if formula.display:
            continue
        letters = [*_letters(formula.text)]
        before, behind = prose.near(number) if letters else ("", "")
        for letter in letters:
            words = _said(before, behind, letter["next"] in ("", ","))
            if letter["argument"]:
                words |= {Word.FUNCTION}
            if letter["positive"] and (before.endswith("(") or "(" in letter["positive"]):
                words |= {Word.POSITIVE}
            if words:
                start = formula.start + letter.start("letter")
                yield Declared(letter["letter"].strip(), start, words)


def _letters(text: str) -> Iterator[re.Match[str]]:
    """The letters of a list of them, or the one that an equation is for."""
    at, letters = 0, []
    while match := _LETTER.match(text, at):
        letters.append(match)
        at = match.end()
        if match["next"] != ",":
            yield from letters if not match["next"] else letters[:1] if len(letters) == 1 else ()
            return


def _said(before: str, behind: str, bare: bool) -> frozenset[Word]:
    """What the words in front of a list with a letter and those behind it say.

    A letter that is not `bare` is one that an equation is for.
    """
    front = _LIST_BEFORE.sub("", before)
    subject = _SUBJECT.search(front)
    words: frozenset[Word] = frozenset()
    if subject:
        words = _noun(subject[1], last=False)
    elif bare or not _IN.search(front):
        words = _noun(front, last=True)
    rest = _LIST_BEHIND.sub("", behind, count=1)
    verb = _VERB.match(rest) or (_NOUN.match(rest) if bare else None)
    return words | (_noun(verb[1], last=False) if verb else frozenset())


def _noun(phrase: str, last: bool) -> frozenset[Word]:
    """What the noun at the end of a phrase says, or that at its beginning, with its adjectives."""
    if _DENIED.search(phrase):
        return frozenset()
    parts = _OF.split(_WHOLE.sub(lambda match: match[0].replace(" ", "_"), phrase))
    part = parts[-1] if last else next(filter(str.strip, parts), "")
    noun = " ".join(part.replace("_", " ").split()[-5:])
    words = set()
    for word, pattern in _WORDS.items():
        rest = pattern.sub(" ", noun)
        if rest != noun:
            words.add(word)
            noun = rest
            if word not in _ADJECTIVES | _SORTS:
                break
    return frozenset(words)
