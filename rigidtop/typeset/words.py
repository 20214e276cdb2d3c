r"""Sentences with formulas in LaTeX between dollars: as LaTeX, or on one line of Unicode.

A dollar that opens has its formula close behind it, one that closes has it close in front and no
digit behind: all others are money.

>>> [*parts("the angle between $L$ and $M$")]
[(False, 'the angle between '), (True, 'L'), (False, ' and '), (True, 'M')]
>>> unmarked(r"the angle between $\boldsymbol\omega$ and $\mathbf L$, for $5 or $6")
'the angle between ω and L, for $5 or $6'
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterator
from functools import cache, reduce

from rigidtop.notation.characters import (
    FUNCTIONS,
    GREEK,
    HALVES,
    MARKS,
    MATHS,
    SUBSCRIPTS,
    SUPERSCRIPTS,
    escape,
    joined,
    opened,
    plain,
)

_FORMULA = re.compile(r"\$(?!\s)([^$]+)(?<!\s)\$(?!\d)")


def parts(words: str) -> Iterator[tuple[bool, str]]:
    """The parts of a sentence, each with whether it is mathematics."""
    for k, part in enumerate(_FORMULA.split(words)):
        if part:
            yield k % 2 == 1, part


def written(text: str, maths: Callable[[str], str], plain: Callable[[str], str]) -> str:
    """A sentence; `maths` writes its formulas, `plain` the rest."""
    return "".join(maths(part) if is_maths else plain(part) for is_maths, part in parts(text))


def unmarked(words: str) -> str:
    """A sentence for the terminal and for programs, its formulas as they are read."""
    return written(words, characters, str)


def prose(text: str) -> str:
    r"""A sentence as LaTeX.

    >>> print(prose(r"$\ddot\theta$ vanishes & $\sin\theta \neq 0$ (3.54): 100 %"))
    $\ddot\theta$ vanishes \& $\sin\theta \neq 0$ (3.54): 100\,\%
    """
    return written(tied(text), lambda part: f"${tex(part)}$", escape)


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
    return _PER_UNIT.sub(lambda match: f"{match[1]}⁻{match[2] or '¹'}", text)


_PER_UNIT = re.compile(r"(?<![\w$/.)])1/([ms])([²³]?)(?![\w²³])")
_NAMES = r"(?:kg|rad|[cmk]?m|[mkμ]?J|[NWs%])(?![A-Za-z])"
_COUNTED = re.compile(
    r"(?<=\d) (?=(?:days|turns)\b)|(?<=\d\$) (?=(?:days|turns)\b)"
    r"|(?:(?<=\b[Ss]ection)|(?<=\b[Ff]igure)|(?<=\bassignment)) (?=\d)"
)
_APART = re.compile(
    rf"(?<=[\d∞⁰¹²³⁴-⁹]) (?={_NAMES})|(?<=[\d∞⁰¹²³⁴-⁹}}]\$) (?={_NAMES})"
    r"|(?:(?<=\b[NJ])|(?<=\bkg)) (?=[ms](?![A-Za-z]))"
)

# --- Characters as commands ----------------------------------------------------------------------

_RAISED, _LOWERED = "".join(SUPERSCRIPTS), "".join(SUBSCRIPTS)
_PART = re.compile(
    rf"\\[A-Za-z]+|\u202f([A-Za-z]+)|(.)([{''.join(MARKS)}]+)|[{_RAISED}]+|[{_LOWERED}]+|.",
    re.S,
)
_SPACES = {"\u00a0": "\\ ", "\u202f": r"\,", "\u2009": r"\,", "–": "--"}


def tex(formula: str) -> str:
    r"""A formula whose characters are commands, such as those of a number that is put into it.

    A character that no command is known for raises a `ValueError` that names it.

    >>> print(tex(r"\Omega_s = 1.2 × 10⁻⁷"), tex("45°"), tex("10^{-5}°"), tex("10⁻⁶\u202frad"))
    \Omega_s = 1.2 \times 10^{-7} 45^{\circ} 10^{-5}{}^{\circ} 10^{-6}\,\text{rad}
    """
    if formula.isascii():
        return formula
    text = reduce(joined, map(_command, _PART.finditer(opened(formula))), "")
    return text.replace(r"}^{\circ}", r"}{}^{\circ}")


def _command(part: re.Match[str]) -> str:
    character = part[0]
    if part[1]:
        return rf"\,\text{{{part[1]}}}"  # a unit
    if part[3]:
        base = MATHS.get(part[2]) or plain(part[2])
        return reduce(lambda inside, mark: MARKS[mark] % inside, part[3], base)
    if character[0] in SUPERSCRIPTS:
        return f"^{{{''.join(SUPERSCRIPTS[c] for c in character)}}}"
    if character[0] in SUBSCRIPTS:
        return f"_{{{''.join(SUBSCRIPTS[c] for c in character)}}}"
    if character.isascii():
        return character
    return MATHS.get(character) or _SPACES.get(character) or plain(character)


# --- Commands as characters ----------------------------------------------------------------------

_TOKEN = re.compile(r"\\[A-Za-z]+(?: +(?=\w))?|\\.|\s+|.", re.S)
_SIGNS = {tex: sign for sign, tex in MATHS.items() if tex[0] == "\\"}
_SIGNS |= {f"\\{name}": letter for name, letter in GREEK.items()}
_SIGNS |= {
    "-": "−",
    "'": "′",
    r"\sum": "Σ",
    r"\perp": "⊥",
    r"\cdot": "·",
    r"\dots": "…",
    r"\vert": "|",
    r"\sim": "∼",
}
_SIGNS |= {r"\ne": "≠", r"\le": "≤", r"\ge": "≥", r"\prime": "′", r"\rightarrow": "→"}
_SIGNS |= {r"\varphi": "φ", r"\vartheta": "θ", r"\epsilon": "ε", r"\varepsilon": "ε"}
_SIGNS |= {r"\left": "", r"\right": "", r"\displaystyle": "", r"\,": " ", r"\;": " ", r"\quad": " "}
_FONTS = {rf"\{name}" for name in ("mathbf", "boldsymbol", "mathrm", "operatorname")}
_ABOVE = {form.partition("{")[0]: mark for mark, form in MARKS.items()}
_VULGAR = {tuple(re.findall(r"\d", form)): sign for sign, form in HALVES.items()}
_SMALL = {"^": {sign: c for c, sign in SUPERSCRIPTS.items()} | {"−": "⁻", "′": "′", "∘": "°"}}
_SMALL["_"] = {sign: c for c, sign in SUBSCRIPTS.items() if sign not in "nx"}
_SMALL["_"] |= {"−": "₋", "′": "′", "⊥": "⊥"}

_Items = list["str | _Items"]


@cache
def characters(formula: str) -> str:
    r"""A formula on one line of Unicode, as the terminal and a screen reader have it.

    >>> characters(r"\dot\omega_1 = (\lambda_2 - \lambda_3)\omega_2\omega_3/\lambda_1")
    'ω̇₁ = (λ₂ − λ₃)ω₂ω₃/λ₁'
    >>> characters(r"e^{\sigma t} \leq \sqrt{\lambda_1\sin\theta}"), characters(r"m_k\mathbf g")
    ('e^(σt) ≤ √(λ₁ sin θ)', 'mₖg')
    """
    tokens = iter(_TOKEN.findall(formula))
    line = unicodedata.normalize("NFC", _line(_grouped(tokens)))
    return " ".join(line.replace("′′", "″").split())


def _grouped(tokens: Iterator[str]) -> _Items:
    """The tokens up to the next brace that closes; what stands in braces is a list."""
    items: _Items = []
    for token in tokens:
        if token == "}":
            break
        items.append(_grouped(tokens) if token == "{" else token)
    return items


def _line(items: _Items) -> str:
    """Items beside each other: functions apart from their arguments, signs as their left side."""
    text, called = "", False
    rest = iter(items)
    for item in rest:
        atom = _atom(item, rest)
        name = isinstance(item, str) and item[0] == "\\" and item.strip()[1:] in FUNCTIONS
        script = item in ("^", "_")
        if (called and not script and atom[:1] not in ("(", " ")) or (
            name and (text[-1:].isalnum() or text[-1:] in (*")|′", *_SMALL["_"].values()))
        ):
            text += " "
        operator = isinstance(item, str) and item[0] == "\\" and not atom[-1:].isalnum()
        text += atom + " " * (operator and text.endswith(" ") and atom in _OPERATORS)
        called = name or (called and script)
    return text


_OPERATORS = {*"=≠<>≤≥≈≪≫×·∥→∝⇒±∓∈∼≡≅↦↔⊥…"}


def _atom(item: str | _Items, rest: Iterator[str | _Items]) -> str:
    """An item, with what it takes of the rest."""
    if isinstance(item, list):
        return _line(item)
    name = item.strip() or " "
    if name in _SMALL:
        return _script(name, _atom(next(rest), rest))
    if name == r"\text":
        return _plain(next(rest))
    if name == r"\mathcal":
        return {"L": "ℒ"}.get(script := _atom(next(rest), rest), script)
    if name in _FONTS:
        return _atom(next(rest), rest)
    if name in _ABOVE:
        below = _atom(next(rest), rest)
        return below[:1] + _ABOVE[name] + below[1:]
    if name in (r"\frac", r"\tfrac"):
        over, under = (_atom(next(rest), rest) for _ in range(2))
        return _VULGAR.get((over, under)) or f"{_held(over)}/{_held(under)}"
    if name == r"\sqrt":
        return f"√{_held(_atom(next(rest), rest))}"
    return _SIGNS.get(name, name.removeprefix("\\"))


def _plain(item: str | _Items) -> str:
    return item if isinstance(item, str) else "".join(map(_plain, item))


def _held(text: str) -> str:
    """What is more than a letter or a number, in brackets."""
    return text if re.fullmatch(r"\w[\u0307\u0308]?[₀-₉]*|[\d.]+", text) else f"({text})"


def _script(mark: str, text: str) -> str:
    """An exponent or an index in small characters, where there are such."""
    if all(c in _SMALL[mark] for c in text):
        return "".join(_SMALL[mark][c] for c in text)
    return mark + (f"({text})" if mark == "^" and len(text) > 1 else text)
