"""English with Unicode mathematics in it: reasons, notes, what a claim says.

`segments` finds the mathematics, `prose` writes the whole as LaTeX, `prose_html` as HTML.  A
character that LaTeX would not know raises a `ValueError` that names it.
"""

from __future__ import annotations

import re
import unicodedata
from html import escape as escape_html

from rigidtop.present.characters import (
    ESCAPES,
    LETTERS,
    MARKS,
    MATHS,
    PUNCTUATION,
    SUBSCRIPTS,
    SUPERSCRIPTS,
    TEX_GREEK,
    joined,
)
from rigidtop.present.layout import GREEK


def prose(text: str) -> str:
    r"""English with Unicode mathematics in it, as LaTeX.

    >>> print(prose("θ̈ vanishes & sin θ ≠ 0 (3.54): 100 %"))
    $\ddot{\theta}$ vanishes \& $\sin \theta \neq 0$ (3.54): 100 \%
    """
    return "".join(
        f"${formula(part)}$" if is_maths else escape(part) for is_maths, part in segments(text)
    )


def prose_html(text: str) -> str:
    """The same as HTML: Unicode as it stands, the letters of formulas in italics.

    >>> prose_html("for θ = 0 & sin θ")
    'for <span class="m"><i>θ</i> = 0</span> &amp; <span class="m">sin <i>θ</i></span>'
    """
    return "".join(
        f'<span class="m">{_html_formula(part)}</span>'
        if is_maths
        else escape_html(part.replace("'", "’"), quote=False)
        for is_maths, part in segments(text)
    )


def escape(text: str) -> str:
    """Text without mathematics, escaped for LaTeX."""
    return "".join(_plain(c) for c in unicodedata.normalize("NFC", text))


def _plain(character: str) -> str:
    if character in ESCAPES:
        return ESCAPES[character]
    if character in PUNCTUATION:
        return PUNCTUATION[character]
    if character.isascii() or (character.isalpha() and ord(character) < 0x180):
        return character  # Latin letters with accents: inputenc knows them
    name = unicodedata.name(character, "without a name")
    raise ValueError(f"no LaTeX for the character {character!r} (U+{ord(character):04X}, {name})")


# --- Finding the mathematics ---------------------------------------------------------------------

_FORMAL = ("maths", "letter", "operator", "inner")
_OPERATORS = frozenset("=+−×·≠≤≥<>→∥≡≈±/∝≪≫⇒⟂⊥∈⇔↦≃∼*")
_FUNCTIONS = ("arcsin", "arccos", "arctan", "sin", "cos", "tan", "exp", "log", "det", "tr")
_LONE = frozenset("BCDEFILMNOPRTVbgknpqrtuvwxyz")  # no a, A, and no m, the metre
_IDENTIFIER = re.compile(r"\b[A-Za-z]_[A-Za-z0-9]{1,4}\b")
# No English word has a dot above a letter; xẏ is a product.
_MARKED = re.compile(r"(?<![A-Za-z])[A-Za-z][\u0302\u0307\u0308](?![A-Za-z])|\u0307")
_NEIGHBOUR = re.compile(r"[-−]?[\d./]+(e[-+]?\d+)?|[-−]?\d*[A-Za-z]|const|[A-Z][A-Za-z]{1,2}")
_UNIT = re.compile(r"((?:kg|rad|[msNJW])(?:[·/](?:kg|rad|[msNJW]))*)([²³])")


def segments(text: str) -> list[tuple[bool, str]]:
    """Prose cut into pieces, each with whether it is mathematics.

    >>> segments("for θ = 0 only")
    [(False, 'for '), (True, 'θ = 0'), (False, ' only')]
    """
    tokens = re.findall(r"\s+|\S+", _opened(text))
    kinds = [_kind(token) for token in tokens]
    for i, kind in enumerate(kinds):
        after = kinds[i + 2] if i + 2 < len(kinds) else ""
        if kind == "function" and after in ("maths", "letter"):
            kinds[i] = "maths"
        if kind == "operator":  # it takes its neighbours along
            for j in (i - 2, i + 2):
                if 0 <= j < len(kinds) and _NEIGHBOUR.fullmatch(_stripped(tokens[j])[1]):
                    kinds[j] = "maths"
    _close(tokens, kinds)
    pieces: list[tuple[bool, str]] = []
    for i, token in enumerate(tokens):
        formal = kinds[i] in _FORMAL
        if kinds[i] == "space":
            formal = 0 < i < len(tokens) - 1 and _one_formula(tokens, kinds, i)
        _append(pieces, formal, " " if token.isspace() else token)
    bare: list[tuple[bool, str]] = []
    for formal, piece in pieces:
        before, core, behind = _stripped(piece) if formal else ("", "", piece)
        _append(bare, False, before)
        _append(bare, True, core)
        _append(bare, False, behind)
    return [(kind, unicodedata.normalize("NFC", piece)) for kind, piece in bare]


def _close(tokens: list[str], kinds: list[str]) -> None:
    """What stands in the brackets of a formula belongs to it: the m of √(1 − m sin² χ)."""
    depth = 0
    for i, token in enumerate(tokens):
        if depth:
            kinds[i] = "inner" if kinds[i] == "space" else "maths"
        # A bracket behind a letter or a root; one that a token begins with may be the sentence's.
        inside = token if depth else token.lstrip("([")
        if depth or (kinds[i] == "maths" and inside.count("(") > inside.count(")")):
            depth = max(0, depth + inside.count("(") - inside.count(")"))


def _opened(text: str) -> str:
    """The text with dots and hats apart from their letters; other accents stay as they are."""
    opened = []
    for c in unicodedata.normalize("NFC", text):
        apart = unicodedata.normalize("NFD", c)
        opened.append(apart if all(mark in MARKS for mark in apart[1:]) else c)
    return "".join(opened)


def _append(pieces: list[tuple[bool, str]], kind: bool, text: str) -> None:
    if text and pieces and pieces[-1][0] == kind:
        pieces[-1] = (kind, pieces[-1][1] + text)
    elif text:
        pieces.append((kind, text))


_PARTNER = {"(": ")", "[": "]", ")": "(", "]": "["}


def _stripped(token: str) -> tuple[str, str, str]:
    """A token without the punctuation round it; brackets that belong to it stay.

    >>> _stripped("(λ₁(t),"), _stripped("(λ₁−λ₃)ω₃.")
    (('(', 'λ₁(t)', ','), ('', '(λ₁−λ₃)ω₃', '.'))
    """
    start, end = 0, len(token)
    while start < end:
        core = token[start:end]
        first, last = core[0], core[-1]
        if last in '.,;:!?”’"':
            end -= 1
        elif first in '“‘"' or (
            first in "([" and (_unmatched(core) or _closes_last(core) or len(core) == 1)
        ):
            start += 1
        elif last in ")]" and core.count(last) > core.count(_PARTNER[last]):
            end -= 1
        else:
            break
    return token[:start], token[start:end], token[end:]


def _unmatched(core: str) -> bool:
    return core.count(core[0]) > core.count(_PARTNER[core[0]])


def _closes_last(core: str) -> bool:
    """Whether the first bracket is closed by the last one."""
    depth = 0
    for i, c in enumerate(core):
        depth += (c == core[0]) - (c == _PARTNER[core[0]])
        if depth == 0:
            return i == len(core) - 1
    return False


def _kind(token: str) -> str:
    if token.isspace():
        return "space"
    core = _stripped(token)[1]
    if core in _OPERATORS:
        return "operator"
    if core in _FUNCTIONS:
        return "function"
    if core == "MgR" or any(c in MATHS or c in SUBSCRIPTS or c in SUPERSCRIPTS for c in core):
        return "maths"
    if _IDENTIFIER.search(core) or _MARKED.search(core):
        return "maths"
    return "letter" if core in _LONE else "word"


def _one_formula(tokens: list[str], kinds: list[str], i: int) -> bool:
    """Whether the space at i is inside one formula."""
    left, right = kinds[i - 1], kinds[i + 1]
    if left not in _FORMAL or right not in _FORMAL:
        return False
    if tokens[i - 1][-1] in '.,;:!?”’"' or tokens[i + 1][0] in '“‘"':
        return False
    # Two formulas side by side stay two: "for ω₃ > 0 Ω is positive".
    return "operator" in (left, right) or tokens[i - 1].endswith(_FUNCTIONS)


# --- A formula in Unicode, as LaTeX --------------------------------------------------------------

_CROSSING = frozenset("×∥⟂⊥·")
_WORD = re.compile("|".join([*_FUNCTIONS, "const", "R[xyz](?=\\()", "['’]s\\b", "-?[a-z]{3,}"]))
_NAMED_INDEX = re.compile(r"[A-Za-z0-9]+|[^\W\d_]")
_PLAIN_MATHS = {
    "%": r"\%",
    "&": r"\&",
    "#": r"\#",
    "{": r"\{",
    "}": r"\}",
    "$": r"\$",
    "~": r"\sim",
    "^": r"\hat{}",
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


def formula(text: str) -> str:
    r"""A formula in Unicode, as LaTeX.

    >>> print(formula("ω̇₁ = (λ₂ − λ₃)ω₂ω₃/λ₁"))
    \dot{\omega}_{1} = (\lambda_{2} - \lambda_{3})\omega_{2}\omega_{3}/\lambda_{1}
    """
    text = _opened(text)
    unit = _UNIT.fullmatch(text)
    if unit:
        return rf"\mathrm{{{formula_units(unit[1])}}}^{{{SUPERSCRIPTS[unit[2]]}}}"
    made = ""
    i = 0
    while i < len(text):
        part, i = _read(text, i)
        if part.startswith("^") and made.endswith("'"):
            made = made[:-1] + r"^{\prime " + part[2:]
        elif part == " ":
            made += " "
        else:
            made = joined(made, part)
    return made.strip()


def formula_units(text: str) -> str:
    """A unit for upright letters."""
    return text.replace("·", r"\,")


def _read(text: str, i: int) -> tuple[str, int]:
    """The LaTeX of the piece of the formula that begins at i, and where the next one begins."""
    c = text[i]
    word = _WORD.match(text, i)
    if word:
        return _word(word[0]), word.end()
    if c == "√":
        return _root(text, i + 1)
    if c in SUBSCRIPTS or c in SUPERSCRIPTS:
        return _script(text, i)
    if c == "_":
        return _index(text, i + 1)
    if c == "⊥" and i and text[i - 1].isalpha():
        return r"_{\perp}", i + 1
    if c in _PLAIN_MATHS:
        return _PLAIN_MATHS[c], i + 1
    if c == "°" and i and text[i - 1] in SUPERSCRIPTS:  # 10⁻⁵°
        return "{}" + MATHS[c], i + 1
    base = MATHS.get(c) or (c if c.isascii() else _plain(c))
    end = i + 1
    while end < len(text) and text[end] in MARKS:
        end += 1
    if _is_vector(text, i, end):
        base = rf"\boldsymbol{{{base}}}" if c in TEX_GREEK else rf"\mathbf{{{base}}}"
    for mark in text[i + 1 : end]:
        base = MARKS[mark] % base
    return base, end


def _word(word: str) -> str:
    if word == "tr":
        return r"\operatorname{tr}"
    if word[0] == "R":
        return f"R_{{{word[1]}}}"
    return "\\" + word if word in _FUNCTIONS else rf"\text{{{escape(word)}}}"


def _script(text: str, i: int) -> tuple[str, int]:
    table, mark = (SUBSCRIPTS, "_") if text[i] in SUBSCRIPTS else (SUPERSCRIPTS, "^")
    end = i
    while end < len(text) and text[end] in table:
        end += 1
    inner = "".join(table[c] for c in text[i:end])
    of_the_index = i > 0 and text[i - 1] == "ω"  # ω₁′ is a component along e₁′
    if mark == "_" and text[end : end + 1] == "′" and of_the_index:
        return f"_{{{inner}'}}", end + 1
    return f"{mark}{{{inner}}}", end


def _index(text: str, i: int) -> tuple[str, int]:
    named = _NAMED_INDEX.match(text, i)
    if not named:
        return r"\_", i
    inner = named[0]
    shown = TEX_GREEK[GREEK[inner]] if inner in GREEK else LETTERS.get(inner, inner)
    if len(inner) > 1 and inner not in GREEK and not inner.isdigit():
        shown = rf"\text{{{inner}}}"
    return f"_{{{shown}}}", named.end()


def _is_vector(text: str, i: int, end: int) -> bool:
    c, behind = text[i], text[end : end + 1]
    if c == "e" and behind and behind in "₁₂₃ₖ":
        return True
    if c in "xyz" and text[i + 1 : i + 2] == "\u0302":
        return True
    if c not in "LNrRgvFfωΩ" or (behind and behind in SUBSCRIPTS) or behind in ("_", "⊥"):
        return False
    before, after = text[:i].rstrip()[-1:], text[end:].lstrip("′").lstrip()[:1]
    return before in _CROSSING or after in _CROSSING


def _root(text: str, i: int) -> tuple[str, int]:
    depth = 0
    for end in range(i, len(text)):
        depth += (text[end] == "(") - (text[end] == ")")
        if depth == 0 and text[i] == "(":
            return rf"\sqrt{{{formula(text[i + 1 : end])}}}", end + 1
    whole = re.compile(r"[^\s()+−=/,]+").match(text, i)
    if not whole:
        raise ValueError(f"a root of nothing in {text!r}")
    return rf"\sqrt{{{formula(whole[0])}}}", whole.end()


# --- A formula in Unicode, as HTML ---------------------------------------------------------------


def _html_formula(text: str) -> str:
    """Letters in italics, vectors bold, indices and exponents as such."""
    text = _opened(text)
    if _UNIT.fullmatch(text):
        return unicodedata.normalize("NFC", text)
    made = ""
    i = 0
    while i < len(text):
        part, i = _read_html(text, i)
        made += part
    return unicodedata.normalize("NFC", made)


def _read_html(text: str, i: int) -> tuple[str, int]:
    c = text[i]
    word = _WORD.match(text, i)
    if word and word[0][0] != "R":
        space = "\u2009" if word[0] in _FUNCTIONS and text[word.end() :][:1].isalpha() else ""
        return escape_html(word[0].replace("'", "’"), quote=False) + space, word.end()
    for table, tag in ((SUBSCRIPTS, "sub"), (SUPERSCRIPTS, "sup")):
        if c in table:
            end = i
            while end < len(text) and text[end] in table:
                end += 1
            inner = "".join(table[d] for d in text[i:end]).replace("-", "−")
            return f"<{tag}>{inner}</{tag}>", end
    named = _NAMED_INDEX.match(text, i + 1) if c == "_" else None
    if named:
        inner = GREEK.get(named[0], named[0])
        return f"<sub>{inner if inner.isdigit() else f'<i>{inner}</i>'}</sub>", named.end()
    if c == "⊥" and i and text[i - 1].isalpha():
        return "<sub>⊥</sub>", i + 1
    if not c.isalpha():
        return escape_html(c, quote=False), i + 1
    end = i + 1
    while end < len(text) and text[end] in MARKS:
        end += 1
    letter = _SHAPES.get(c, c) + text[i + 1 : end]
    if c.isascii() and text[i + 1 : end] in _DOTS:
        # Many fonts have no Ṙ, and show an R.
        dots = _DOTS[text[i + 1 : end]]
        return f"<math><mover><mi>{c}</mi><mo>{dots}</mo></mover></math>", end
    if _is_vector(text, i, end):
        return f"<b>{letter}</b>", end
    return (f"<i>{letter}</i>" if c not in _UPRIGHT else letter), end


_DOTS = {"\u0307": "˙", "\u0308": "¨"}
_SHAPES = {"φ": "ϕ", "ε": "ϵ"}
_UPRIGHT = frozenset("ΓΔΘΛΞΠΣΦΨΩℒℝ")
