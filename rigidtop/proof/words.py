"""Sentences with mathematics in them, which stands between dollars.

What stands there is written as it is read: $λ₁ sin² θ$.  A letter that is a vector is bold, 𝐋 or 𝛚.
A dollar that opens has its formula close behind it, one that closes has it close in front and no
digit behind: all others are money.

>>> [*parts("the angle between $𝛚$ and $𝐋$")]
[(False, 'the angle between '), (True, '𝛚'), (False, ' and '), (True, '𝐋')]
>>> unmarked("the angle between $𝛚$ and $𝐋$, for $5 or $6")
'the angle between ω and L, for $5 or $6'
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator

_FORMULA = re.compile(r"\$(?!\s)([^$]+)(?<!\s)\$(?!\d)")
_BOLD = re.compile("[\U0001d400-\U0001d433\U0001d6a8-\U0001d6e1]")


def parts(words: str) -> Iterator[tuple[bool, str]]:
    """The parts of a sentence, each with whether it is mathematics."""
    for k, part in enumerate(_FORMULA.split(words)):
        if part:
            yield k % 2 == 1, part


def unmarked(words: str) -> str:
    """A sentence for the terminal and for programs: without dollars, its vectors as letters."""
    return unbold("".join(part for _, part in parts(words)))


def unbold(words: str) -> str:
    """Bold letters as letters.

    >>> unbold("𝐋̇ = 𝛚 × 𝐋")
    'L̇ = ω × L'
    """
    return unicodedata.normalize("NFC", light(words))


def light(words: str) -> str:
    """The same, letter by letter: accents stay apart where they are."""
    return _BOLD.sub(lambda found: unicodedata.normalize("NFKC", found[0]), words)


def bold(letter: str) -> str:
    """A letter as that of a vector.

    >>> bold("L"), bold("ω")
    ('𝐋', '𝛚')
    """
    for first, last, start in (("A", "Z", 0x1D400), ("a", "z", 0x1D41A), ("α", "ω", 0x1D6C2)):
        if first <= letter <= last:
            return chr(start + ord(letter) - ord(first))
    return chr(0x1D6A8 + ord(letter) - ord("Α"))
