"""Sentences with formulas in Unicode between dollars, as LaTeX and as HTML.

`pieces` reads a formula, from left to right; both writers spell out the same pieces.  A character
that LaTeX would not know raises a `ValueError` that names it.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from html import escape as escape_html

from rigidtop.notation.characters import (
    FUNCTIONS,
    GREEK,
    HALVES,
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
from rigidtop.proof.words import light, parts, unbold
from rigidtop.theory.symbols import Glyph
from rigidtop.typeset import mathml as ml


def prose(text: str) -> str:
    r"""A sentence as LaTeX.

    >>> print(prose("$θ̈$ vanishes & $sin θ ≠ 0$ (3.54): 100 %"))
    $\ddot{\theta}$ vanishes \& $\sin \theta \neq 0$ (3.54): 100\,\%
    """
    return written(tied(text), lambda part: f"${tex(part)}$", escape)


def prose_html(text: str) -> str:
    """The same as HTML, its formulas as MathML.

    >>> prose_html("a & b's")
    'a &amp; b’s'
    """
    return written(
        tied(text), mathml, lambda part: escape_html(part.replace("'", "’"), quote=False)
    )


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


@dataclass(frozen=True)
class Piece:
    """What stands in a formula.

    `kind` is "letter" (with its `marks`, `bold` for a vector), "number", "sign", "space",
    "function" (sin), "word", "turn" (the x of Rx), "root" and "power" (with what is `inside`),
    "sub" and "sup" (digits and signs in ASCII), "index" (the name behind a _) or "unit".
    """

    kind: str
    text: str
    marks: str = ""
    bold: bool = False
    inside: tuple[Piece, ...] = ()


# --- Reading -------------------------------------------------------------------------------------

_WORD = re.compile(rf"(?:{'|'.join(FUNCTIONS)})(?![a-z])|const|R[xyz](?=\()|['’]s\b|-?[a-z]{{3,}}")
_NUMBER = re.compile(r"\d+(?:\.\d+)?")
_NAMED_INDEX = re.compile(r"\d,\d|[A-Za-z0-9]+|[^\W\d_]")
_UNIT = re.compile(r"((?:kg|rad|[msNJW])(?:[·/](?:kg|rad|[msNJW]))*)([²³])")
_BRACES = {"{": "}", "(": ")"}


def pieces(text: str) -> tuple[Piece, ...]:
    """The pieces of a formula; bold letters are vectors.

    >>> [piece.kind for piece in pieces("e^{σt} ≤ √(λ₁ sin θ)")]
    ['letter', 'power', 'space', 'sign', 'space', 'root']
    >>> [piece.text for piece in pieces("m_k𝐠")]
    ['m', 'k', 'g']
    """
    opened_text = opened(text)
    text = light(opened_text)
    unit = _UNIT.fullmatch(text)
    if unit:
        return Piece("unit", unit[1]), Piece("sup", SUPERSCRIPTS[unit[2]])
    bold = frozenset(i for i, c in enumerate(text) if c != opened_text[i])
    bold |= {axis.start() for axis in _AXIS.finditer(text)}
    made: list[Piece] = []
    i = 0
    while i < len(text):
        piece, i = _read(text, i, bold)
        made.append(piece)
    return tuple(made)


def _read(text: str, i: int, bold: frozenset[int]) -> tuple[Piece, int]:
    """The piece that begins at i, and where the next one begins."""
    c = text[i]
    word = _WORD.match(text, i)
    if word:
        return _word(word[0]), word.end()
    if c == "√":
        inside, end = _under_root(text, i + 1)
        return Piece("root", "", inside=pieces(inside)), end
    if c == "^" and i and i + 1 < len(text):
        inside, end = _raised(text, i + 1)
        return Piece("power", "", inside=pieces(inside)), end
    if c in SUBSCRIPTS or c in SUPERSCRIPTS:
        return _script(text, i)
    if c == "_":
        vector = min((k for k in bold if k > i), default=len(text))  # m_k𝐠: no unit
        named = _NAMED_INDEX.match(text, i + 1, vector)
        return (Piece("index", named[0]), named.end()) if named else (Piece("sign", c), i + 1)
    if c == "⊥" and i and text[i - 1].isalpha():
        return Piece("sub", c), i + 1
    if c in " \u00a0\u202f\u2009":
        return Piece("space", c), i + 1
    number = _NUMBER.match(text, i)
    if number:
        return Piece("number", number[0]), number.end()
    end = i + 1
    while end < len(text) and text[end] in MARKS:
        end += 1
    if not c.isalpha():
        return Piece("sign", c, text[i + 1 : end]), end
    return Piece("letter", c, text[i + 1 : end], i in bold), end


def _word(word: str) -> Piece:
    if word[0] == "R":
        return Piece("turn", word[1])
    return Piece("function" if word in FUNCTIONS else "word", word)


def _script(text: str, i: int) -> tuple[Piece, int]:
    table, kind = (SUBSCRIPTS, "sub") if text[i] in SUBSCRIPTS else (SUPERSCRIPTS, "sup")
    end = i
    while end < len(text) and text[end] in table:
        end += 1
    inner = "".join(table[c] for c in text[i:end])
    of_the_index = i > 0 and text[i - 1] == "ω"  # ω₁′ is a component along e₁′
    if kind == "sub" and text[end : end + 1] == "′" and of_the_index:
        return Piece(kind, inner + "'"), end + 1
    return Piece(kind, inner), end


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


# --- As LaTeX ------------------------------------------------------------------------------------

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


def tex(text: str) -> str:
    r"""A formula in Unicode, as LaTeX.

    >>> print(tex("ω̇₁ = (λ₂ − λ₃)ω₂ω₃/λ₁"))
    \dot{\omega}_{1} = (\lambda_{2} - \lambda_{3})\omega_{2}\omega_{3}/\lambda_{1}
    """
    return _tex_row(pieces(text))


def _tex_row(row: Sequence[Piece]) -> str:
    made = ""
    for piece in row:
        part = _tex(piece, made)
        if part.startswith("^") and made.endswith("'"):
            made = made[:-1] + r"^{\prime " + part[2:]
        elif part == " ":
            made += " "
        else:
            made = joined(made, part)
    return made.strip()


def _tex(piece: Piece, before: str) -> str:
    match piece.kind:
        case "sub":
            return r"_{\perp}" if piece.text == "⊥" else f"_{{{piece.text}}}"
        case "sup":
            return f"^{{{piece.text}}}"
        case "power":
            return f"^{{{_tex_row(piece.inside)}}}"
        case "root":
            return rf"\sqrt{{{_tex_row(piece.inside)}}}"
        case "index":
            return _tex_index(piece.text)
        case "turn":
            return f"R_{{{piece.text}}}"
        case "function":
            known = piece.text not in ("sn", "tr")
            return "\\" + piece.text if known else rf"\operatorname{{{piece.text}}}"
        case "word":
            return rf"\text{{{escape(piece.text)}}}"
        case "unit":
            return rf"\mathrm{{{piece.text.replace('·', chr(92) + ',')}}}"
    if piece.text in _PLAIN_MATHS:
        return _PLAIN_MATHS[piece.text]
    if piece.text == "°" and before.endswith("}"):  # 10⁻⁵°
        return "{}" + MATHS["°"]
    c = piece.text
    base = MATHS.get(c) or (c if c.isascii() else plain(c))
    if piece.bold:
        base = rf"\boldsymbol{{{base}}}" if c in TEX_GREEK else rf"\mathbf{{{base}}}"
    for mark in piece.marks:
        base = MARKS[mark] % base
    return base


def _tex_index(name: str) -> str:
    shown = TEX_GREEK[GREEK[name]] if name in GREEK else LETTERS.get(name, name)
    if len(name) > 1 and name not in GREEK and not name[0].isdigit():
        shown = rf"\text{{{name}}}"
    return f"_{{{shown}}}"


# --- As MathML -----------------------------------------------------------------------------------

_ACCENTS = {"\u0307": "dot", "\u0308": "ddot", "\u0302": "hat"}
_PRIMES = frozenset("′″‴")
_NO_OPERATORS = frozenset("°∞%…")


def mathml(text: str) -> str:
    """A formula in Unicode, as an inline ``<math>`` that says it in words.

    >>> mathml("√3")[-32:]
    '<msqrt><mn>3</mn></msqrt></math>'
    """
    inside = _ml_row(pieces(text))
    return ml.element(inside, unbold(text), False)


def _ml_row(row: Sequence[Piece]) -> str:
    """The pieces with their indices and exponents, in one element."""
    made: list[str] = []
    opened: list[tuple[str, int]] = []  # brackets and bars, and where they stand
    for i, piece in enumerate(row):
        before, after = row[:i], row[i + 1 :]
        closes = bool(opened) and opened[-1][0] + piece.text in ("()", "[]", "||")
        if _is_raised(piece):
            base = made.pop() if before and before[-1].kind != "space" else "<mrow></mrow>"
            made.append(_attached(base, piece) + _applied(before, after))
        elif piece.kind == "space":
            made.append(ml.THIN if _is_seen(before, after) else "")
        elif piece.text in "()[]|" and piece.kind == "sign":
            form = "postfix" if closes or piece.text in ")]" else "prefix"
            made.append(_fence(piece.text, form))
        else:
            made.append(_ml(piece, before, after))
        if closes:  # an exponent raises it as a whole
            start = opened.pop()[1]
            made[start:] = ["<mrow>" + "".join(made[start:]) + "</mrow>"]
        elif piece.kind == "sign" and piece.text in "([|":
            opened.append((piece.text, len(made) - 1))
    made = [part for part in made if part]
    return made[0] if len(made) == 1 else "<mrow>" + "".join(made) + "</mrow>"


def _is_raised(piece: Piece) -> bool:
    return piece.kind in ("sub", "index", "sup", "power") or piece.text in _PRIMES


def _attached(base: str, piece: Piece) -> str:
    """A base with a prime, an index or an exponent; an index and an exponent above each other."""
    if piece.kind == "sign":
        return ml.primed(base, piece.text)
    if piece.kind == "index":
        return f"<msub>{base}{ml.subscript(GREEK.get(piece.text, piece.text))}</msub>"
    if piece.kind == "sub":
        sub = piece.text.replace("'", "′").replace("-", "−")
        return f"<msub>{base}{ml.subscript(sub)}</msub>"
    if piece.kind == "power":
        return ml.with_superscript(base, _ml_row(piece.inside))
    shown = piece.text.replace("-", "−")
    tag = "mn" if shown[-1].isdigit() else "mi"
    return ml.with_superscript(base, f"<{tag}>{shown}</{tag}>")


def _applied(before: Sequence[Piece], after: Sequence[Piece]) -> str:
    """What stands between the exponent of a function and its argument."""
    behind = bool(before) and before[-1].kind == "function"
    return ml.APPLY + ml.THIN if behind and after and after[0].text != "(" else ""


def _is_seen(before: Sequence[Piece], after: Sequence[Piece]) -> bool:
    """Whether a space is seen: not beside signs, which have their own, nor behind a function."""
    if not before or not after:
        return False
    if before[-1].kind == "function" or _applied(before[:-1], after):
        return False
    left = before[-1].kind != "sign" or before[-1].text in ")]|°"
    return left and (after[0].kind != "sign" or after[0].text in "([|")


def _ml(piece: Piece, before: Sequence[Piece], after: Sequence[Piece]) -> str:
    match piece.kind:
        case "root":
            return f"<msqrt>{_ml_row(piece.inside)}</msqrt>"
        case "number":
            return f"<mn>{piece.text}</mn>"
        case "function":
            raised = bool(after) and _is_raised(after[0])
            return f"<mi>{piece.text}</mi>" + ("" if raised else _applied([piece], after))
        case "turn":
            return f"<msub><mi>R</mi><mi>{piece.text}</mi></msub>"
        case "word" | "unit":
            return f"<mtext>{escape_html(piece.text.replace(chr(39), '’'))}</mtext>"
        case "letter":
            accent = _ACCENTS.get(piece.marks, "")
            return ml.letter(Glyph(piece.text, accent=accent, bold=piece.bold))
    return _ml_sign(piece, before)


def _ml_sign(piece: Piece, before: Sequence[Piece]) -> str:
    shown = escape_html({"-": "−", "*": "·"}.get(piece.text, piece.text) + piece.marks)
    if piece.text in HALVES:
        over, under = unicodedata.normalize("NFKC", piece.text).split("⁄")
        return f"<mfrac><mn>{over}</mn><mn>{under}</mn></mfrac>"
    if piece.text in _NO_OPERATORS:
        return f"<mtext>{shown}</mtext>"
    if piece.text == "/":
        return f'<mo lspace="0" rspace="0">{shown}</mo>'
    seen = [part for part in before if part.kind != "space"]
    leads = not seen or (seen[-1].kind == "sign" and seen[-1].text not in ")]|°′″‴")
    return f'<mo form="prefix">{shown}</mo>' if leads else f"<mo>{shown}</mo>"


def _fence(mark: str, form: str) -> str:
    return f'<mo form="{form}" fence="true" stretchy="false">{mark}</mo>'
