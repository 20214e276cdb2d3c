"""Which LaTeX command writes which character.

The tables are closed: a character that none of them knows is an error that names it.
"""

from __future__ import annotations

import re
import unicodedata

_SMALL = (
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau "
    "upsilon phi chi psi omega"
)
_CAPITAL = "Gamma Delta Theta Lambda Xi Pi Sigma Phi Psi Omega"
GREEK = dict(zip(f"{_SMALL} {_CAPITAL}".split(), "αβγδεζηθικλμνξπρστυφχψωΓΔΘΛΞΠΣΦΨΩ", strict=True))
"""Greek letters by the names of TeX."""

FUNCTIONS = (
    *("arcsin", "arccos", "arctan", "sinh", "cosh", "tanh", "sin", "cos", "tan"),
    *("exp", "log", "ln", "det", "sn", "tr"),
)
"""Whose names stand upright."""

TEX_GREEK = {letter: "\\" + name for name, letter in GREEK.items()} | {
    "ε": r"\varepsilon",
    "ο": "o",
    "ϕ": r"\varphi",
    "ϑ": r"\vartheta",
}
LETTERS = TEX_GREEK | {
    "ℒ": r"\mathcal{L}",
    "ℓ": r"\ell",
    "∞": r"\infty",
    "∇": r"\nabla",
    "…": r"\ldots",
    "ħ": r"\hbar",
}
SIGNS = {
    "=": "=",
    "≡": r"\equiv",
    "≠": r"\neq",
    ">": ">",
    "<": "<",
    "≥": r"\geq",
    "≤": r"\leq",
    "≈": r"\approx",
    "×": r"\times",
    "/": "/",
    "·": r"\cdot",
    "∥": r"\parallel",
    "⇒": r"\Rightarrow",
    "≪": r"\ll",
    "≫": r"\gg",
    "≲": r"\lesssim",
    "≳": r"\gtrsim",
    "≃": r"\simeq",
    "∼": r"\sim",
    "∝": r"\propto",
    "⊥": r"\perp",
    "→": r"\to",
    "∑": r"\sum",
    "∫": r"\int",
}

ESCAPES = {
    "%": r"\%",
    "&": r"\&",
    "_": r"\_",
    "#": r"\#",
    "{": r"\{",
    "}": r"\}",
    "$": r"\$",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "\\": r"\textbackslash{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "|": r"\textbar{}",
}
PUNCTUATION = {
    "–": "--",
    "—": "---",
    "‘": "`",
    "’": "'",
    "“": "``",
    "”": "''",
    "„": ",,",
    "«": r"\guillemotleft{}",
    "»": r"\guillemotright{}",
    "…": r"\ldots{}",
    "§": r"\S{}",
    "°": r"\ensuremath{^{\circ}}",
    "\u00a0": "~",
    "\u202f": r"\,",
    "\u2009": r"\,",
    "\u2002": r"\enspace{}",
    "\u2011": "-",
}
SUBSCRIPTS = dict(zip("₀₁₂₃₄₅₆₇₈₉₊₋ₖᵢⱼₙₓ", "0123456789+-kijnx", strict=True))
SUPERSCRIPTS = dict(zip("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻ᵀⁿᵏ", "0123456789+-Tnk", strict=True))
HALVES = {
    "½": r"\tfrac{1}{2}",
    "⅓": r"\tfrac{1}{3}",
    "⅔": r"\tfrac{2}{3}",
    "¼": r"\tfrac{1}{4}",
    "¾": r"\tfrac{3}{4}",
    "⅛": r"\tfrac{1}{8}",
}
MARKS = {"\u0307": r"\dot{%s}", "\u0308": r"\ddot{%s}", "\u0302": r"\hat{%s}"}
MATHS = {
    **LETTERS,
    **HALVES,
    **{sign: tex for sign, tex in SIGNS.items() if not sign.isascii()},
    "±": r"\pm",
    "∓": r"\mp",
    "⟂": r"\perp",
    "≅": r"\cong",
    "∂": r"\partial",
    "∈": r"\in",
    "∧": r"\wedge",
    "√": r"\sqrt",
    "Σ": r"\sum",
    "∘": r"\circ",
    "°": r"^{\circ}",
    "′": "'",
    "″": "''",
    "‴": "'''",
    "↦": r"\mapsto",
    "↔": r"\leftrightarrow",
    "⇔": r"\Leftrightarrow",
    "←": r"\leftarrow",
    "⁄": "/",
    "∣": r"\mid",
    "⟨": r"\langle",
    "⟩": r"\rangle",
    "⋅": r"\cdot",
    "−": "-",
    "ℝ": r"\mathbb{R}",
    "†": r"\dagger",
    "∀": r"\forall",
    "∃": r"\exists",
}


def joined(left: str, right: str) -> str:
    """Two pieces of LaTeX, with a space where a command would otherwise swallow a letter."""
    command = re.search(r"\\[A-Za-z]+$", left)
    return left + (" " if command and right[:1].isalpha() else "") + right


def opened(text: str) -> str:
    """The text with dots and hats apart from their letters; other accents stay as they are."""
    pieces = []
    for c in unicodedata.normalize("NFC", text):
        apart = unicodedata.normalize("NFD", c)
        pieces.append(apart if all(mark in MARKS for mark in apart[1:]) else c)
    return "".join(pieces)


def escape(text: str) -> str:
    """Text without mathematics, escaped for LaTeX."""
    # Latin letters with accents stay whole: inputenc knows them.
    whole = unicodedata.normalize("NFC", text)
    parts = _ALONE.split("".join(c if ord(c) < 0x180 else opened(c) for c in whole))
    return "".join(
        _alone(part) if k % 2 else "".join(map(plain, part)) for k, part in enumerate(parts)
    )


def unwritable(text: str) -> tuple[str, ...]:
    r"""The characters of a text that no document can write, in their order.

    >>> unwritable("θ̈ = 3·10⁻⁴, naïve"), unwritable("a 🙂, 漢\u202e\x07")
    ((), ('🙂', '漢', '\u202e', '\x07'))
    """
    unknown = []
    for character in text:
        try:
            escape(character)
        except ValueError:
            is_writable = character in LETTERS or character in MARKS
        else:
            is_writable = not character.isascii() or character.isprintable() or character in "\n\t"
        if not is_writable:
            unknown.append(character)
    return tuple(dict.fromkeys(unknown))


_KNOWN = "".join(c for c in MATHS if len(c) == 1 and c not in ESCAPES | PUNCTUATION)
_ALONE = re.compile(
    f"(\\w[{''.join(MARKS)}]|[{''.join(SUBSCRIPTS)}]+|[{''.join(SUPERSCRIPTS)}]+"
    f"|[{re.escape(_KNOWN)}])"
)


def _alone(part: str) -> str:
    """A letter, indices, an exponent or a mark that stands in a text and is not marked there."""
    if part[1:] in MARKS:
        return f"${MARKS[part[1:]] % MATHS.get(part[0], part[0])}$"
    for table, mark in ((SUBSCRIPTS, "_"), (SUPERSCRIPTS, "^")):
        if part[0] in table:
            return f"${mark}{{{''.join(table[c] for c in part)}}}$"
    return f"${MATHS[part]}$"


def plain(character: str) -> str:
    """A character of a text, for LaTeX."""
    if character in ESCAPES:
        return ESCAPES[character]
    if character in PUNCTUATION:
        return PUNCTUATION[character]
    if character.isascii() or (character.isalpha() and ord(character) < 0x180):
        return character  # Latin letters with accents: inputenc knows them
    name = unicodedata.name(character, "without a name")
    raise ValueError(f"no LaTeX for the character {character!r} (U+{ord(character):04X}, {name})")
