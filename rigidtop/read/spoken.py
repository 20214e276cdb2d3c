r"""What a file says of its letters: "where $I_1$ is the moment of inertia about $e_1$".

The words are taken as they stand, and the kind of quantity that they name with them; nothing is
concluded from a letter alone.

>>> from rigidtop.notation import OWN
>>> text = r"A bead of mass $m$. Let $x(t)$ be the displacement, where $I_1$ is the moment."
>>> for letter, said in spoken(text, OWN).items():
...     print(letter.base + letter.sub, (said.words, said.kind))
m ('mass', 'mass')
x ('the displacement', 'length')
I1 ('the moment', '')
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from rigidtop.notation import Notation
from rigidtop.read.document import Formula, formulas, places
from rigidtop.read.scan import Scan, limited
from rigidtop.read.tex import UnreadError, pieces, words
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.symbols import Glyph

LONGEST = 60
"""Longer words say more than what a letter is (characters)."""

KINDS = {
    "moment of inertia": r"(?:principal )?moments? of inertia|principal moments?|inertia",
    "the Lagrangian": "lagrangian",
    "the Hamiltonian": "hamiltonian",
    "angular momentum": "angular momentum",
    "momentum": "moment(?:um|a)",
    "energy": "energy|potential",
    "torque": "torques?|force moments?",
    "force": "forces?|weight",
    "angular velocity": "angular (?:velocity|speed|rate)|angular frequency|frequency|spin",
    "velocity": "velocity|speed",
    "acceleration": "acceleration",
    "mass": "mass(?:es)?",
    "time": "time|period",
    "angle": "angles?|latitude|longitude|phase",
    "length": "lengths?|radius|distance|displacement|height|position|coordinate|amplitude",
    "stiffness": "spring constant|stiffness|force constant",
}
"""Kinds of quantities, and the words that name them: of two the one that stands first."""
_KIND = re.compile("|".join(rf"(?P<k{i}>\b(?:{w})\b)" for i, w in enumerate(KINDS.values())), re.I)
_IS = re.compile(
    r"[\s~]*(?:,\s*)?(?:is|are|be|denotes?|represents?|stands?\s+for|means|=)\s+"
    r"((?:the|an?|its|our)\s+[^.,;:()$\\\n]{2,80}?)"
    r"(?=\s*[.,;:()\\\n$]|\s+(?:and|so|which|that|then|with|if|when|where|we|for|in|at|to)\b|$)"
)
_NAMED = re.compile(
    r"(?:\b(?:the|an?|of|with|has|have|and|by|total|their|its)\s+)((?:[A-Za-z-]+\s+){0,2}[A-Za-z]+)"
    r"[\s~]*$",
    re.I,
)
_CUT = re.compile(r"^an? (?:bit|lot|little)\b.*|(?: (?:of|by|due|on|from|to|as|used))+$")
_TYPED = re.compile(r"\(\s*[a-z]\s*\)$")


@dataclass(frozen=True)
class Spoken:
    """The words that say what a letter is, in which line; the kind of quantity, if they name it."""

    words: str
    line: int
    kind: str = ""


def spoken(source: str, notation: Notation) -> dict[Glyph, Spoken]:
    """Of each letter what the text says of it first."""
    found: dict[Glyph, Spoken] = {}
    place = places(source)
    for formula in formulas(source):
        if formula.display or len(formula.text) > LONGEST:
            continue
        said = _said_of(source, formula)
        glyph = _letter(formula.text, notation) if said else None
        if glyph is not None and glyph not in found:
            found[glyph] = Spoken(said, place(formula.opens)[0], kind_of(said))
    return found


def kind_of(said: str) -> str:
    """The kind of quantity that words name, if they do; what stands behind "of" is of another.

    >>> kind_of("the moment of inertia of the disc"), kind_of("the position of the centre of mass")
    ('moment of inertia', 'length')
    """
    head = re.split(r"(?<!moment)(?<!moments) of ", said, maxsplit=1)[0]
    found = [each.lastgroup for each in _KIND.finditer(head)]
    return list(KINDS)[int((found[-1] or "k0")[1:])] if found else ""


def _said_of(source: str, formula: Formula) -> str:
    """What stands behind a letter, as "is the mass", or before it, as "of mass"."""
    behind = _IS.match(source, formula.end, formula.end + 120)
    if behind is not None:
        return _CUT.sub("", words(behind[1]))
    before = _NAMED.search(" ".join(source[max(0, formula.opens - 60) : formula.opens].split(" ")))
    if before is None:
        return ""
    kind = _KIND.search(before[1])
    return words(before[1][kind.start() :]) if kind and kind.end() == len(before[1]) else ""


def _letter(text: str, notation: Notation) -> Glyph | None:
    """The letter that a formula is, perhaps with (t) behind it; None for more than that."""
    try:
        tokens = limited(Scan(pieces(_TYPED.sub("", text.strip())), notation))
    except UnreadError:
        return None
    if [token.kind for token in tokens] != ["SYMBOL"] or not isinstance(tokens[0].value, Lettered):
        return None
    return tokens[0].value.quantity.glyph
