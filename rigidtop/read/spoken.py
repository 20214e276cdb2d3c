r"""What a file says of its letters: "where $I_1$ is the moment of inertia about $e_1$".

The words are taken as they stand, in English or German, and the kind of quantity that they name
with them; nothing is concluded from a letter alone.

>>> from rigidtop.notation import OWN
>>> text = r"A bead of mass $m$. Let $x(t)$ be the displacement, where $I_1$ is the moment."
>>> for letter, said in spoken(text, OWN).items():
...     print(letter.base + letter.sub, (said.words, said.kind, said.timed))
m ('mass', 'mass', False)
x ('the displacement', 'length', True)
I1 ('the moment', '', False)
>>> [said.role for said in spoken("mit der Masse $m$, wobei $r$ der Ortsvektor ist", OWN).values()]
['a number (kg)', 'a number, a vector where × stands (m)']
"""

from __future__ import annotations

import re

from rigidtop.notation import Notation
from rigidtop.read.document import formulas
from rigidtop.read.kinds import Spoken, kind_of, named_last
from rigidtop.read.scan import Scan, limited
from rigidtop.read.tex import UnreadError, pieces, words
from rigidtop.read.walk import Formula, places
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.symbols import Glyph

LONGEST = 60
"""Longer words say more than what a letter is (characters)."""

_ENDS = (
    r"([^.,;:()$\\\n]{2,80}?)"
    r"(?=\s*[.,;:()\\\n$]|\s+(?:and|so|which|that|then|with|if|when|where|we|for|in|at|to)\b"
    r"|\s+(?:und|ist|sind|bezeichnet|bezeichnen|mit|im|am)\b|$)"
)
_IS = re.compile(
    r"[\s~]*(?:,\s*)?(?:is|are|be|denotes?|represents?|stands?\s+for|means|=)\s+"
    rf"((?:the|an?|its|our)\s+{_ENDS})"
)
_IST = re.compile(rf"[\s~]*(?:(?:ist|sei|bezeichnet)\s+)?((?:der|die|das|eine?)\s+{_ENDS})")
_NAMED = re.compile(
    r"(?:\b(?:the|an?|of|with|has|have|and|by|total|their|its|der|die|das|dem|den|mit|von|eine[rs]?)"
    r"\s+)((?:[A-Za-zäöüß-]+\s+){0,2}[A-Za-zäöüß]+)[\s~]*$",
    re.I,
)
_CUT = re.compile(r"^an? (?:bit|lot|little)\b.*|(?: (?:of|by|due|on|from|to|as|used))+$")
_TYPED = re.compile(r"\(\s*t\s*\)$")
_ANY = re.compile(r"\(\s*[a-z]\s*\)$")
_TIMED = re.compile(r"\bfunction of (?:the )?time\b|\btime[- ]dependent\b|\bzeitabhängig", re.I)


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
            timed = bool(_TYPED.search(formula.text.strip()) or _TIMED.search(said))
            found[glyph] = Spoken(said, place(formula.opens)[0], kind_of(said), timed)
    return found


def _said_of(source: str, formula: Formula) -> str:
    """What stands behind a letter, as "is the mass", or before it, as "of mass"."""
    behind = _IS.match(source, formula.end, formula.end + 120)
    if behind is not None:
        return _CUT.sub("", words(behind[1]))
    german = _IST.match(source, formula.end, formula.end + 120)
    if german is not None and kind_of(german[1]):
        return words(german[1])
    before = _NAMED.search(" ".join(source[max(0, formula.opens - 60) : formula.opens].split(" ")))
    return words(named_last(before[1])) if before is not None else ""


def _letter(text: str, notation: Notation) -> Glyph | None:
    """The letter that a formula is, perhaps with (t) behind it; None for more than that."""
    try:
        tokens = limited(Scan(pieces(_ANY.sub("", text.strip())), notation))
    except UnreadError:
        return None
    if [token.kind for token in tokens] != ["SYMBOL"] or not isinstance(tokens[0].value, Lettered):
        return None
    return tokens[0].value.quantity.glyph
