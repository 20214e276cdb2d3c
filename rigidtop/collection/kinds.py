"""Whether what a collection defines is what it should be: the kinds, the texts, the names."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from types import ModuleType
from typing import Any

from rigidtop.errors import RigidtopError
from rigidtop.parameters import Parameter
from rigidtop.proof import units
from rigidtop.proof.exercise import Exercise
from rigidtop.proof.page import Claim, Page
from rigidtop.theory.lettered import Lettered
from rigidtop.typeset.latex import can_be_set

_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9.-]*")


def claims(pages: Sequence[Page], exercises: Sequence[Exercise]) -> list[Claim]:
    of_pages = [claim for page in pages for claim in page.claims]
    return of_pages + [claim for exercise in exercises for claim in exercise.claims]


def a(value: Any) -> str:
    return "None" if value is None else _kind(type(value))


def _kind(kind: type) -> str:
    return f"{'an' if kind.__name__[0] in 'AEIOaeiou' else 'a'} {kind.__name__}"


def many(values: Any, kind: type, what: str) -> tuple[Any, ...]:
    """A tuple of one kind; RigidtopError says what it is instead."""
    if isinstance(values, kind):
        raise RigidtopError(f"{what} is {a(values)}, not a tuple: (x,) has a comma")
    if not isinstance(values, (tuple, list)):
        raise RigidtopError(f"{what} is {a(values)}, not a tuple")
    for i, value in enumerate(values):
        if not isinstance(value, kind):
            hint = "; is @claim(name, says) missing?" if kind is Claim and callable(value) else ""
            raise RigidtopError(f"{what}[{i}] is {a(value)}, not {_kind(kind)}{hint}")
    return tuple(values)


def text(module: ModuleType, name: str, default: str) -> str:
    value = getattr(module, name, default)
    if not isinstance(value, str):
        raise RigidtopError(f"{name} is {a(value)}, not text")
    return value


def _check_texts(owner: Any, names: Sequence[str], what: str) -> None:
    for name in names:
        if not isinstance(getattr(owner, name), str):
            raise RigidtopError(f"the {name} of {what} is {a(getattr(owner, name))}, not text")


def check_pages(pages: Sequence[Page]) -> None:
    for i, page in enumerate(pages):
        _check_texts(page, ("section", "title", "about", "opens"), f"PAGES[{i}]")
        many(page.claims, Claim, f"PAGES[{i}].claims")


def check_exercises(exercises: Sequence[Exercise], pages: Sequence[Page]) -> None:
    for i, exercise in enumerate(exercises):
        texts = ("name", "title", "section", "asks", "statement", "figure", "text")
        _check_texts(exercise, texts, f"EXERCISES[{i}]")
        many(exercise.claims, Claim, f"EXERCISES[{i}].claims")
        many(exercise.parameters, Parameter, f"EXERCISES[{i}].parameters")
        sections = [page.section for page in pages]
        if exercise.section not in sections:
            there = ", ".join(sections)
            raise RigidtopError(
                f"exercise {exercise.name!r} is in section {exercise.section!r}; there are {there}"
            )


def check_names(pages: Sequence[Page], exercises: Sequence[Exercise]) -> None:
    """Every name finds one thing, in the shell and as a link."""
    once = {id(claim): claim for claim in claims(pages, exercises)}.values()
    for claim in once:
        _check_texts(claim, ("name", "says"), "a claim")
    named = [
        *(("section", page.section) for page in pages),
        *(("claim", claim.name) for claim in once),
        *(("exercise", exercise.name) for exercise in exercises),
    ]
    kinds: dict[str, str] = {}
    for kind, name in named:
        if kind != "section" and not _NAME.fullmatch(name):
            raise RigidtopError(f"the {kind} {name!r} needs a name of letters, digits, . and -")
        link = re.sub(r"\W+", "-", name).strip("-")
        if link in kinds:
            both = f"two {kind}s" if kinds[link] == kind else f"a {kinds[link]} and a {kind}"
            raise RigidtopError(f"{both} have the name {name!r}")
        kinds[link] = kind


def check_letters(letters: Sequence[Lettered]) -> None:
    """RigidtopError for units that are none, which no line could be held to, and strange glyphs."""
    wrong = [problem for letter in letters for problem in problems(letter)]
    if wrong:
        raise RigidtopError("\n".join(wrong))


def problems(letter: Lettered) -> Iterator[str]:
    """What is wrong with a letter: a unit that is none, a glyph that no document can set."""
    unit, glyph = letter.quantity.unit, letter.quantity.glyph
    if unit and units.parsed(unit) is None:
        yield f"the unit {unit!r} of {letter.name} is not known: write it in {units.known()}"
    if not can_be_set(glyph):
        spelling = repr(glyph.base + glyph.sub)
        yield f"no document can set {spelling}, the letter of {letter.name}: take Latin or Greek"
