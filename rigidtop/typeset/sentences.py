"""Sentences with formulas in Unicode between dollars, as LaTeX.

A character that LaTeX would not know raises a `ValueError` that names it.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from rigidtop.notation.characters import (
    FUNCTIONS,
    GREEK,
    LETTERS,
    MARKS,
    MATHS,
    SUBSCRIPTS,
    SUPERSCRIPTS,
    TEX_GREEK,
    escape,
    joined,
    opened,
    plain,
)
from rigidtop.proof.words import light, parts


def prose(text: str) -> str:
    r"""A sentence as LaTeX.

    >>> print(prose("$θ̈$ vanishes & $sin θ ≠ 0$ (3.54): 100 %"))
    $\ddot{\theta}$ vanishes \& $\sin \theta \neq 0$ (3.54): 100\,\%
    """
    return written(tied(text), lambda part: f"${tex(part)}$", escape)


def written(text: str, maths: Callable[[str], str], plain: Callable[[str], str]) -> str:
    """A sentence; `maths` writes its formulas, `plain` the rest."""
    return "".join(maths(part) if is_maths else plain(part) for is_maths, part in parts(text))


def tied(text: str) -> str:
    """A sentence in which no line ends between a number and its unit, nor inside a unit.

    A thin space stands there, as in the tables; before a word, such as days, a whole one.
    """
    return _APART.sub("\u202f", _COUNTED.sub("\u00a0", printed_unit(text)))


def printed_unit(text: str) -> str:
    """A unit, or a sentence with units, as it is printed.

    >>> printed_unit("1/s²"), printed_unit("rate (1/s)"), printed_unit("rad/s")
    ('s⁻²', 'rate (s⁻¹)', 'rad/s')
    """
    return _PER_UNIT.sub(lambda found: f"{found[1]}⁻{found[2] or '¹'}", text)


_PER_UNIT = re.compile(r"(?<![\w$/.)])1/([ms])([²³]?)(?![\w²³])")
_NAMES = r"(?:kg|rad|[cmk]?m|[mkμ]?J|[NWs%])(?![A-Za-z])"
_COUNTED = re.compile(
    r"(?<=\d) (?=(?:days|turns)\b)|(?<=\d\$) (?=(?:days|turns)\b)"
    r"|(?:(?<=\b[Ss]ection)|(?<=\b[Ff]igure)|(?<=\bassignment)) (?=\d)"
)
_APART = re.compile(
    rf"(?<=[\d∞⁰¹²³⁴-⁹]) (?={_NAMES})|(?<=[\d∞⁰¹²³⁴-⁹]\$) (?={_NAMES})"
    r"|(?:(?<=\b[NJ])|(?<=\bkg)) (?=[ms](?![A-Za-z]))"
)


# --- Reading -------------------------------------------------------------------------------------

_WORD = re.compile(rf"(?:{'|'.join(FUNCTIONS)})(?![a-z])|const|R[xyz](?=\()|['’]s\b|-?[a-z]{{3,}}")
_NUMBER = re.compile(r"\d+(?:\.\d+)?")
_NAMED_INDEX = re.compile(r"\d,\d|[A-Za-z0-9]+|[^\W\d_]")
_UNIT = re.compile(r"((?:kg|rad|[msNJW])(?:[·/](?:kg|rad|[msNJW]))*)([²³])")
_BRACES = {"{": "}", "(": ")"}


def tex(text: str) -> str:
    r"""A formula in Unicode, as LaTeX; bold letters are vectors.

    >>> print(tex("ω̇₁ = (λ₂ − λ₃)ω₂ω₃/λ₁"))
    \dot{\omega}_{1} = (\lambda_{2} - \lambda_{3})\omega_{2}\omega_{3}/\lambda_{1}
    >>> print(tex("e^{σt} ≤ √(λ₁ sin θ)"), tex("m_k𝐠"))
    e^{\sigma t} \leq \sqrt{\lambda_{1} \sin \theta} m_{k}\mathbf{g}
    """
    opened_text = opened(text)
    text = light(opened_text)
    unit = _UNIT.fullmatch(text)
    if unit:
        return rf"\mathrm{{{unit[1].replace('·', chr(92) + ',')}}}^{{{SUPERSCRIPTS[unit[2]]}}}"
    bold = frozenset(i for i, c in enumerate(text) if c != opened_text[i])
    bold |= {axis.start() for axis in _AXIS.finditer(text)}
    made = ""
    i = 0
    while i < len(text):
        part, i = _read(text, i, bold, made)
        if part.startswith("^") and made.endswith("'"):
            made = made[:-1] + r"^{\prime " + part[2:]
        elif part == " ":
            made += " "
        else:
            made = joined(made, part)
    return made.strip()


def _read(text: str, i: int, bold: frozenset[int], before: str) -> tuple[str, int]:
    """What begins at i, behind the LaTeX `before`, and where the next begins."""
    c = text[i]
    word = _WORD.match(text, i)
    if word:
        return _word(word[0]), word.end()
    if c == "√":
        inside, end = _under_root(text, i + 1)
        return rf"\sqrt{{{tex(inside)}}}", end
    if c == "^" and i and i + 1 < len(text):
        inside, end = _raised(text, i + 1)
        return f"^{{{tex(inside)}}}", end
    if c in SUBSCRIPTS or c in SUPERSCRIPTS:
        return _script(text, i)
    if c == "_":
        vector = min((k for k in bold if k > i), default=len(text))  # m_k𝐠: no unit
        named = _NAMED_INDEX.match(text, i + 1, vector)
        return (_index(named[0]), named.end()) if named else (r"\_", i + 1)
    if c == "⊥" and i and text[i - 1].isalpha():
        return r"_{\perp}", i + 1
    if c in " \u00a0\u202f\u2009":
        return _PLAIN_MATHS.get(c, c), i + 1
    number = _NUMBER.match(text, i)
    if number:
        return number[0], number.end()
    end = i + 1
    while end < len(text) and text[end] in MARKS:
        end += 1
    return _marked(c, text[i + 1 : end], i in bold, before), end


def _word(word: str) -> str:
    """A function's name, the x of Rx, or another word."""
    if word[0] == "R":
        return f"R_{{{word[1]}}}"
    if word not in FUNCTIONS:
        return rf"\text{{{escape(word)}}}"
    return rf"\operatorname{{{word}}}" if word in ("sn", "tr") else "\\" + word


def _script(text: str, i: int) -> tuple[str, int]:
    """Digits and signs of an index or of an exponent."""
    table, sign = (SUBSCRIPTS, "_") if text[i] in SUBSCRIPTS else (SUPERSCRIPTS, "^")
    end = i
    while end < len(text) and text[end] in table:
        end += 1
    inner = "".join(table[c] for c in text[i:end])
    of_the_index = i > 0 and text[i - 1] == "ω"  # ω₁′ is a component along e₁′
    if sign == "_" and text[end : end + 1] == "′" and of_the_index:
        return f"_{{{inner}'}}", end + 1
    return f"{sign}{{{inner}}}", end


def _index(name: str) -> str:
    """The name behind a _."""
    shown = TEX_GREEK[GREEK[name]] if name in GREEK else LETTERS.get(name, name)
    if len(name) > 1 and name not in GREEK and not name[0].isdigit():
        shown = rf"\text{{{name}}}"
    return f"_{{{shown}}}"


def _marked(c: str, marks: str, bold: bool, before: str) -> str:
    """A letter, a sign or a space, with the marks above it."""
    if c in _PLAIN_MATHS:
        return _PLAIN_MATHS[c]
    if c == "°" and before.endswith("}"):  # 10⁻⁵°
        return "{}" + MATHS["°"]
    base = MATHS.get(c) or (c if c.isascii() else plain(c))
    if bold and c.isalpha():
        base = rf"\boldsymbol{{{base}}}" if c in TEX_GREEK else rf"\mathbf{{{base}}}"
    for mark in marks:
        base = MARKS[mark] % base
    return base


def _under_root(text: str, i: int) -> tuple[str, int]:
    if text[i : i + 1] == "(":
        end = _closing(text, i)
        if end:
            return text[i + 1 : end], end + 1
    whole = re.compile(r"[^\s()+−=/,]+").match(text, i)
    if not whole:
        raise ValueError(f"a root of nothing in {text!r}")
    return whole[0], whole.end()


def _raised(text: str, i: int) -> tuple[str, int]:
    """What stands behind a ^: in braces or brackets, or one letter or number."""
    if text[i] in _BRACES:
        end = _closing(text, i)
        if end:
            return text[i + 1 : end], end + 1
    whole = re.compile(r"[-−]?(?:\d+|\w)").match(text, i)
    return (whole[0], whole.end()) if whole else (text[i], i + 1)


def _closing(text: str, i: int) -> int:
    """Where the bracket at i is closed; 0 if nowhere."""
    depth = 0
    for end in range(i, len(text)):
        depth += (text[end] == text[i]) - (text[end] == _BRACES[text[i]])
        if depth == 0:
            return end
    return 0


_AXIS = re.compile(r"e(?=[₁₂₃ₖ])|[A-Za-z](?=\u0302)|R(?=_CM)")
"""Vectors for what stands behind their letters; all others are bold in the sentence."""


_PLAIN_MATHS = {
    "%": r"\%",
    "&": r"\&",
    "#": r"\#",
    "{": r"\{",
    "}": r"\}",
    "$": r"\$",
    "~": r"\sim",
    "^": r"\hat{}",
    "_": r"\_",
    "\\": r"\setminus",
    "*": r"\cdot",
    "|": r"\vert",
    "–": r"\text{--}",
    "—": r"\text{---}",
    "…": r"\ldots",
    "\u00a0": r"\ ",
    "\u202f": r"\,",
    "\u2009": r"\,",
}
