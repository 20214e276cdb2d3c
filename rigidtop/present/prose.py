"""English with Unicode mathematics in it: reasons, notes, what a claim says.

`segments` finds the mathematics, `prose` writes the whole as LaTeX, `prose_html` as HTML.  A
character that LaTeX would not know raises a `ValueError` that names it.
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable
from html import escape as escape_html

from rigidtop.notation.characters import FUNCTIONS, MATHS, SUBSCRIPTS, SUPERSCRIPTS, escape
from rigidtop.present import formula


def prose(text: str) -> str:
    r"""English with Unicode mathematics in it, as LaTeX.

    >>> print(prose("θ̈ vanishes & sin θ ≠ 0 (3.54): 100 %"))
    $\ddot{\theta}$ vanishes \& $\sin \theta \neq 0$ (3.54): 100 \%
    """
    return written(text, tex, escape)


def prose_html(text: str) -> str:
    """The same as HTML, its formulas as MathML.

    >>> prose_html("a & b's")
    'a &amp; b’s'
    """
    return written(text, formula.mathml, _plain_html)


def _plain_html(text: str) -> str:
    return escape_html(text.replace("'", "’"), quote=False)


def tex(part: str, vectors: str) -> str:
    """A formula of a text between dollars."""
    return f"${formula.tex(part, vectors)}$"


def written(text: str, maths: Callable[[str, str], str], plain: Callable[[str], str]) -> str:
    """A text; `maths` writes its formulas, told the `vectors` of the text, `plain` the rest."""
    letters = vectors(text)
    return "".join(
        maths(part, letters) if is_maths else plain(part) for is_maths, part in segments(text)
    )


_DIRECTED = re.compile(
    r"(?<!\w)[LNω]\u0307?\s?[×∥⟂⊥·]\s?\w|(?<!\w)L\u0307|\bvectors? [LNω](?!\w)|[×∥⟂]\s?[LNω](?!\w)"
    r"|\b(?:along|across|about|against|parallel to|tilted to|right angles to|parts? of|tip of"
    r"|ways? of|direction of|angles? of|angles? between|plane of|from)(?: the)? [Lω]"
    r"(?![\w/])(?! =| to)"
    r"|(?:(?<!\w)[LNω]|\be[₁₂₃])(?:,| and|, and) [LNω](?!\w)(?! =)"
    r"|(?<!\w)[Lω] (?:along|across|lies|points|precesses"
    r"|is (?:not )?(?:along|across|parallel|at right angles))"
)


# Letters of other vectors stand beside a × or a · somewhere in the text.
_CROSSED = re.compile(
    r"(?<![A-Za-z\d])([uvw])\s?[×·]|[×·]\s?I?([uvw])(?!\w)|\bvectors? ([uvw])\b(?: and ([uvw])\b)?"
)


def vectors(text: str) -> str:
    """The letters that are vectors in a text: L, N and ω where it speaks of their directions.

    >>> vectors("the angle between ω and L"), vectors("it turns with the speed ω")
    ('LNω', '')
    """
    apart = formula.opened(text)
    crossed = {letter for found in _CROSSED.findall(apart) for letter in found}
    return ("LNω" if _DIRECTED.search(apart) else "") + "".join(sorted(crossed))


# --- Finding the mathematics ---------------------------------------------------------------------

_FORMAL = ("maths", "letter", "operator", "inner")
_OPERATORS = frozenset("=+−×·≠≤≥<>→∥≡≈±/∝≪≫⇒⟂⊥∈⇔↦≃∼*")
_LONE = frozenset("BCDEFHIKLMNOPRTUVbcfghkmnpqrstuvwxyz")
_UNITS = frozenset("CFKNTVghms")  # behind a number or another unit
_IDENTIFIER = re.compile(r"\b[A-Za-z]_[A-Za-z0-9]{1,4}\b|\b[A-Za-z0-9]\^[\w{(−-]")
# No English word has a dot above a letter; xẏ is a product.
_MARKED = re.compile(r"(?<![A-Za-z])[A-Za-z][\u0302\u0307\u0308](?![A-Za-z])|\u0307")
_NEIGHBOUR = re.compile(
    r"[-−]?[\d./]+(e[-+]?\d+)?|\(?\|?[-−]?\d*[A-Za-z]\|?|const|[A-Z][A-Za-z]{1,2}|mg"
)
_NAME = "|".join(("MgR", "Mg", *FUNCTIONS))
# MgR, 2cos, |L|, and with a bracket that is closed later: m(r, MgR(cos, ln(8.
_WHOLE = re.compile(
    rf"\d*MgR|Mg|\d+(?:{_NAME})|\|[A-Za-z]\||\d*(?:{_NAME}|[A-Za-z])\((?:{_NAME}|\d+|[A-Za-z])?"
    r"|[B-Zb-z]\([A-Za-z]\)|d/d[a-z]|[A-Z]\)/[A-Z]|\([A-Z]{2}\)[A-Z]|[A-Z]\([A-Z]{2}\)"
)


def segments(text: str) -> list[tuple[bool, str]]:
    """Prose cut into pieces, each with whether it is mathematics.

    >>> segments("for θ = 0 only")
    [(False, 'for '), (True, 'θ = 0'), (False, ' only')]
    """
    tokens = re.findall(r"\s+|\S+", formula.opened(text))
    kinds = [_kind(token) for token in tokens]
    for i, kind in enumerate(kinds):
        after = kinds[i + 2] if i + 2 < len(kinds) else ""
        if kind == "function" and after in ("maths", "letter"):
            kinds[i] = "maths"
        if kind == "operator" and (i or tokens[i] != "⇒"):  # it takes its neighbours along
            for j in (i - 2, i + 2):
                if 0 <= j < len(kinds) and _NEIGHBOUR.fullmatch(_stripped(tokens[j])[1]):
                    kinds[j] = "maths"
    for i in range(len(kinds)):
        kinds[i] = _among(tokens, kinds, i)
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
    if core.lstrip("|") in FUNCTIONS:
        return "function"
    if any(c in MATHS or c in SUBSCRIPTS or c in SUPERSCRIPTS for c in core):
        return "maths"
    if _WHOLE.fullmatch(core) or _IDENTIFIER.search(core) or _MARKED.search(core):
        return "maths"
    return "letter" if core in _LONE else "word"


_QUANTITY = re.compile(r"\(?[-−\d.e·⁻⁰¹²³⁴-⁹]+\)?|kg|[JNWms]|rad")


def _among(tokens: list[str], kinds: list[str], i: int) -> str:
    """The kind of a token for what stands round it, where it is one letter."""
    letter = _stripped(tokens[i])[1]
    if kinds[i] not in ("letter", "word") or len(letter) != 1 or not letter.isalpha():
        return kinds[i]
    before, after = (tokens[j] if 0 <= j < len(tokens) else "" for j in (i - 2, i + 2))
    kind_after = kinds[i + 2] if after else ""
    if kinds[i] == "letter":  # 14.7 N m, (0, 3.9, 0) N, (N)
        unit = bool(_QUANTITY.fullmatch(before))
        unit |= letter != "g" and tokens[i].startswith(f"({letter})")
        unit |= letter in "ms" and before in ("in", "per")
        return "word" if letter in _UNITS and unit else "letter"
    if letter == "A":  # no article
        inside = bool(before) and before[-1] not in ".:;!?⇒" and tokens[i][0] not in "“‘"
        return "letter" if inside or kind_after == "letter" else "word"
    if letter == "d" and kind_after == "maths" and after.startswith(FUNCTIONS):
        return "maths"
    paired = after == "and" and i + 4 < len(kinds) and kinds[i + 4] == "letter"
    behind = before == "and" and i >= 4 and kinds[i - 4] == "letter" and letter != "a"
    return "letter" if (paired or behind) and tokens[i] == letter else "word"


def _one_formula(tokens: list[str], kinds: list[str], i: int) -> bool:
    """Whether the space at i is inside one formula."""
    left, right = kinds[i - 1], kinds[i + 1]
    if left not in _FORMAL or right not in _FORMAL:
        return False
    if tokens[i - 1][-1] in '.,;:!?”’"' or tokens[i + 1][0] in '“‘"':
        return False
    # Two formulas side by side stay two: "for ω₃ > 0 Ω is positive".
    if _stripped(tokens[i - 1])[1].endswith("MgR") or _is_summed(tokens, kinds, i):
        return True
    return "operator" in (left, right) or tokens[i - 1].endswith(FUNCTIONS)


def _is_summed(tokens: list[str], kinds: list[str], i: int) -> bool:
    """Whether the space at i stands between the factors behind a Σ or an ∫."""
    for j in range(i - 1, -1, -2):
        if kinds[j] not in _FORMAL or tokens[j][-1] in ".,;:":
            return False
        if tokens[j].lstrip("(")[:1] in ("Σ", "∑", "∫"):
            return True
    return False
