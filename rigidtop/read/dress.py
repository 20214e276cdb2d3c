"""The commands that dress a letter: bold, with dots or marks above it, in another script."""

from __future__ import annotations

import unicodedata
from typing import Final

from rigidtop.read.tex import commands

BOLD: Final = commands(
    "mathbf boldsymbol bm vec pmb bold overrightarrow underline overrightharpoon mathbfit vb va "
    "mathbold bf overleftrightarrow"
)
DOTS: Final = {r"\dot": 1, r"\ddot": 2, r"\dddot": 3, r"\ddddot": 4}
MARKS: Final = {
    **dict.fromkeys(commands("hat widehat vu"), "hat"),
    **dict.fromkeys(commands("bar overline"), "bar"),
    **dict.fromkeys(commands("tilde widetilde"), "tilde"),
    r"\check": "check",
    r"\breve": "breve",
    r"\mathring": "ring",
    r"\acute": "acute",
}
STYLES: Final = {
    **dict.fromkeys(commands("mathcal mathscr"), "SCRIPT"),
    r"\mathfrak": "FRAKTUR",
    **dict.fromkeys(commands("mathbb mathbbm mathds"), "DOUBLE-STRUCK"),
}
SLANTED: Final = commands("mathit mathnormal")
DRESS: Final = BOLD.union(DOTS, MARKS, STYLES)
"""What may stand in front of a letter and leaves it one."""


def styled(character: str, style: str) -> str:
    """A letter in another script.  Raises KeyError where Unicode has none.

    >>> styled("H", "SCRIPT"), styled("g", "FRAKTUR")
    ('ℋ', '𝔤')
    """
    size = "CAPITAL" if character.isupper() else "SMALL"
    name = f"{style} {size} {character.upper()}"
    try:
        return unicodedata.lookup(name)
    except KeyError:
        return unicodedata.lookup(f"MATHEMATICAL {name}")
