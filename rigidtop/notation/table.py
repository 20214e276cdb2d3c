"""Tables of notations: files in TOML, checked when they are read.

    title = "My lecture"
    source = "PHY 305, 2026, week 8"        # book, edition, section
    note = "…"                              # what a reader has to know besides; may be left out

    [euler]
    sequence = "zxz"                        # or "zyz", as in the notes
    angles = ["φ", "θ", "ψ"]                # the letters of the three turns, in this order

    [letters]                               # a letter for another, in every symbol that has it
    "λ" = "I"

    [symbols]                               # one symbol of the notes, by its Python name
    R = { base = "l", meaning = "distance from the pivot to the centre of mass" }
    L_later = { base = "M", sub = "later", bold = true, name = "M_later" }

    [spellings]                             # what is understood too, when a formula is read
    R = [{ base = "ℓ" }]

A symbol has a `base`, and may have a `sub`, an `accent` ("dot", "ddot" or "hat"), `bold` and
`prime`.  Its `name` in code is made from these, unless it is given.  All parts are optional.
"""

from __future__ import annotations

import keyword
import re
import tomllib
import unicodedata
from collections.abc import Mapping
from dataclasses import replace
from difflib import get_close_matches
from importlib.resources import files
from pathlib import Path
from typing import Any

from sympy import Symbol

from rigidtop.errors import RigidtopError
from rigidtop.notation.convention import MEANINGS, SEQUENCES, Notation
from rigidtop.terminal.files import text_of
from rigidtop.theory.lettered import instead
from rigidtop.theory.symbols import VOCABULARY, Glyph

BUILT_IN = ("notes", "goldstein", "landau", "taylor", "morin")

_BY_NAME = {symbol.name: symbol for symbol in VOCABULARY}
_PRINTED = {symbol: quantity.glyph for symbol, quantity in VOCABULARY.items()}
_ANGLES = ("φ", "θ", "ψ")
_ACCENTS = ("", "dot", "ddot", "hat")
_MORE = "ℓℒ′+−⊥,() ⁰¹²³⁴⁵⁶⁷⁸⁹"
_PARTS: Mapping[str, type] = {"base": str, "sub": str, "accent": str, "bold": bool, "prime": bool}
_KNOWN: Mapping[str, type] = {
    "title": str,
    "source": str,
    "note": str,
    "euler": dict,
    "letters": dict,
    "symbols": dict,
    "spellings": dict,
}

Toml = Mapping[str, Any]
"""A table as the file has it: text, flags, lists and tables."""


def named(name: str) -> Notation:
    """One of `BUILT_IN`, or the table in a file.  Raises RigidtopError, in one line, for another.

    >>> named("landau").title
    'Landau and Lifshitz'
    """
    if name in BUILT_IN:
        return parsed(files(__package__).joinpath(f"{name}.toml").read_text("utf-8"), name)
    path = Path(name)
    if path.suffix != ".toml" and not path.is_file():
        near = get_close_matches(name, BUILT_IN, n=1, cutoff=0.5)
        hint = f"did you mean {near[0]}?" if near else f"{', '.join(BUILT_IN)}, or a file"
        raise RigidtopError(f"no notation {name!r}; {hint}")
    return parsed(text_of(path), path.stem, name)


def parsed(text: str, name: str, where: str = "") -> Notation:
    """The notation of a table.  Raises RigidtopError, with the line and `where` it stands."""
    try:
        return _notation(_toml(text), name)
    except _TableError as error:
        raise RigidtopError(f"{where or name}: {error}") from None


class _TableError(ValueError):
    """What is wrong with a table, and with which entry."""


def _toml(text: str) -> Toml:
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise _TableError(f"not TOML: {error}") from None


def _notation(table: Toml, name: str) -> Notation:
    _require(any(table.values()), "it is no table of a notation: no title, no entry")
    for key, value in table.items():
        _require(key in _KNOWN, f"no entry {key!r} in a notation", key, _KNOWN)
        _typed(value, _KNOWN[key], key)
    sequence, angles = _euler(table.get("euler", {}))
    glyphs, names = dict(_PRINTED), {symbol: symbol.name for symbol in VOCABULARY}
    changes = {**_renamed_angles(angles), **_lettered(table.get("letters", {}))}
    meanings = dict(MEANINGS[sequence])
    for symbol, glyph in changes.items():
        glyphs[symbol], names[symbol] = glyph, identifier(glyph)
    for key, entry in table.get("symbols", {}).items():
        symbol, entry = _symbol(key, "symbols"), _typed(entry, dict, f"symbols.{key}")
        glyphs[symbol] = _glyph(entry, f"symbols.{key}", glyphs[symbol], ("name", "meaning"))
        names[symbol] = _typed(
            entry.get("name", identifier(glyphs[symbol])), str, f"symbols.{key}.name"
        )
        meaning = _typed(entry.get("meaning", ""), str, f"symbols.{key}.meaning")
        meanings[symbol] = meaning or meanings.get(symbol, "")
    changed = {x for x in VOCABULARY if glyphs[x] != _PRINTED[x] or names[x] != x.name}
    changed |= set(meanings) | {image.symbol for image in SEQUENCES[sequence].values()}
    _unambiguous(glyphs, names, changed)
    letters = {
        x: instead(x, names[x], glyphs[x], meanings.get(x, "")) for x in VOCABULARY if x in changed
    }
    spellings = _inherited(glyphs) | _spellings(table.get("spellings", {}), glyphs)
    words = {key: " ".join(str(table.get(key, "")).split()) for key in ("title", "source", "note")}
    title, source, note = words["title"] or name, words["source"], words["note"]
    return Notation(name, glyphs, spellings, title, source, note, sequence, letters)


# --- Entries -------------------------------------------------------------------------------------


def _require(condition: bool, complaint: str, name: str = "", names: Any = ()) -> None:
    """Raise unless the condition holds, with what may have been meant."""
    if not condition:
        near = get_close_matches(name, names, n=1, cutoff=0.5)
        raise _TableError(f"{complaint}; did you mean {near[0]}?" if near else complaint)


def _typed(value: Any, kind: type, where: str) -> Any:
    words = {str: "text", bool: "true or false", dict: "a table", list: "a list"}
    _require(isinstance(value, kind), f"{where} wants {words[kind]}, not {value!r}")
    return value


def _known(letters: str, where: str) -> None:
    """Refuse what not every way of print has, or what would be more than a letter there."""
    _require(letters.strip() != "", f"{where} is empty")
    for c in letters:
        is_writable = (c.isascii() and c.isalnum()) or c in _MORE or _is_greek(c)
        _require(is_writable, f"{where}: {c!r} is no letter that is known here")


def _is_greek(c: str) -> bool:
    return bool(re.fullmatch("[α-ωΑ-Ω]", c)) and c != "ς"


def _symbol(key: str, where: str) -> Symbol:
    _require(key in _BY_NAME, f"{where}: no symbol {key!r}", key, _BY_NAME)
    return _BY_NAME[key]


def _glyph(entry: Toml, where: str, start: Glyph, others: tuple[str, ...] = ()) -> Glyph:
    """A glyph from its parts.  With a base of its own it has nothing of what it was before."""
    for key in entry:
        _require(key in (*_PARTS, *others), f"{where}: no part {key!r}", key, (*_PARTS, *others))
    parts = {
        key: _typed(entry[key], kind, f"{where}.{key}")
        for key, kind in _PARTS.items()
        if key in entry
    }
    if parts.get("sub"):
        _known(parts["sub"], f"{where}.sub")
    accent = parts.get("accent", "")
    _require(accent in _ACCENTS, f"{where}.accent is dot, ddot or hat, not {accent!r}")
    if "base" not in parts:
        return replace(start, **parts)
    _known(parts["base"], f"{where}.base")
    return Glyph(**parts)


def _euler(entry: Toml) -> tuple[str, tuple[str, ...]]:
    for key in entry:
        _require(
            key in ("sequence", "angles"), f"euler: no entry {key!r}", key, ("sequence", "angles")
        )
    sequence = _typed(entry.get("sequence", "zyz"), str, "euler.sequence")
    sequences = " or ".join(SEQUENCES)
    _require(
        sequence in SEQUENCES,
        f"euler.sequence is {sequences}, whose θ is the polar angle of e₃, not {sequence!r}",
    )
    angles = _typed(entry.get("angles", list(_ANGLES)), list, "euler.angles")
    right = len(angles) == 3 and all(isinstance(x, str) and len(x) == 1 for x in angles)
    _require(right and len(set(angles)) == 3, "euler.angles wants three different letters")
    for letter in angles:
        _known(letter, "euler.angles")
    return sequence, tuple(angles)


def _renamed_angles(angles: tuple[str, ...]) -> dict[Symbol, Glyph]:
    """φ, θ and ψ by other letters, also in rates, momenta and indices."""
    new = dict(zip(_ANGLES, angles, strict=True))
    return {
        symbol: renamed
        for symbol, glyph in _PRINTED.items()
        if (renamed := _with(glyph, new)) != glyph
    }


def _with(glyph: Glyph, new: Mapping[str, str]) -> Glyph:
    return replace(glyph, base=new.get(glyph.base, glyph.base), sub=new.get(glyph.sub, glyph.sub))


def _lettered(letters: Toml) -> dict[Symbol, Glyph]:
    """A letter for another in every symbol that has it as its base."""
    for old, new in letters.items():
        originals = {glyph.base for glyph in _PRINTED.values()}
        _require(old in originals, f"letters: no symbol is written with {old!r}")
        _known(_typed(new, str, f"letters.{old}"), f"letters.{old}")
    return {
        symbol: replace(glyph, base=letters[glyph.base])
        for symbol, glyph in _PRINTED.items()
        if glyph.base in letters
    }


def _spellings(entries: Toml, glyphs: Mapping[Symbol, Glyph]) -> dict[Glyph, Symbol]:
    """The glyphs that are read as a symbol although they are not its own."""
    symbols: dict[Glyph, Symbol] = {}
    for key, listed in entries.items():
        symbol, where = _symbol(key, "spellings"), f"spellings.{key}"
        for entry in _typed(listed, list, where):
            glyph = _glyph(_typed(entry, dict, where), where, glyphs[symbol])
            other = symbols.get(glyph, symbol)
            _require(other == symbol, f"{where}: {_shown(glyph)} is {other.name} already")
            symbols[glyph] = symbol
    return symbols


def _inherited(glyphs: Mapping[Symbol, Glyph]) -> dict[Glyph, Symbol]:
    """What is understood besides in the notes, of symbols that are written as there."""
    entries = _toml(files(__package__).joinpath("notes.toml").read_text("utf-8"))["spellings"]
    spellings = _spellings(entries, _PRINTED)
    return {glyph: x for glyph, x in spellings.items() if glyphs[x] == _PRINTED[x]}


def _unambiguous(
    glyphs: Mapping[Symbol, Glyph], names: Mapping[Symbol, str], changed: set[Symbol]
) -> None:
    """Refuse two symbols that look the same, or are named the same in code."""
    by_glyph: dict[Glyph, Symbol] = {}
    by_name: dict[str, Symbol] = {}
    for symbol in sorted(VOCABULARY, key=lambda x: x in changed):
        glyph, name = glyphs[symbol], names[symbol]
        legal = name.isidentifier() and name.isascii() and not keyword.iskeyword(name)
        _require(
            symbol not in changed or legal,
            f"symbols.{symbol.name}: {name!r} is no name for code, give it another by name = …",
        )
        twin, namesake = by_glyph.get(glyph), by_name.get(name)
        if symbol in changed and twin is not None:
            raise _TableError(f"{twin.name} and {symbol.name} are both written {_shown(glyph)}")
        if namesake is not None:
            raise _TableError(f"{namesake.name} and {symbol.name} are both named {name} in code")
        by_glyph[glyph], by_name[name] = symbol, symbol


def _shown(glyph: Glyph) -> str:
    """A glyph as a message names it, with its accents in words."""
    index = f"_{glyph.sub}" if glyph.sub else ""
    words = [word for word, there in (("bold", glyph.bold), (glyph.accent, glyph.accent)) if there]
    addition = f" ({', '.join(words)})" if words else ""
    return f"{glyph.base}{index}{'′' * glyph.prime}{addition}"


# --- Names in code -------------------------------------------------------------------------------

_WORDS = {"+": "plus", "−": "minus", "⊥": "perp", "′": "p"}


def identifier(glyph: Glyph) -> str:
    """The name in code that a glyph gets of itself, as the notes' symbols have theirs.

    >>> identifier(Glyph("I", "1")), identifier(Glyph("Ω", "3", "dot"))
    ('I1', 'Omega3dot')
    """
    base, sub = (re.sub(r"\W", "", "".join(map(_word, part))) for part in (glyph.base, glyph.sub))
    joint = "_" if sub and not sub[0].isdigit() else ""
    vector = "_vec" if glyph.bold and not sub and glyph.accent != "hat" else ""
    return f"{base}{joint}{sub}{vector}{glyph.accent}{'p' if glyph.prime else ''}"


def _word(character: str) -> str:
    """λ as lambda, Ω as Omega, ℓ as l, ² as 2."""
    script, _, rest = unicodedata.name(character, "").partition(" ")
    if script in ("GREEK", "SCRIPT"):
        word = rest.rpartition(" ")[2].replace("LAMDA", "LAMBDA")
        return word.capitalize() if "CAPITAL" in rest else word.lower()
    plain = unicodedata.normalize("NFKC", character)
    return _WORDS.get(character, plain)
