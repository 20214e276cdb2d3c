"""Figures of a collection: their names are known at once, they are loaded when one is drawn.

A page shows one as a paragraph of its own, ``![The orbit of (1.5).](#orbit)``.  The folder's
``__init__.py`` has the names, ``FIGURES = ("orbit",)``, and its ``figures.py`` the drawings
themselves, ``FIGURES = (Drawing("orbit", …),)``.
"""

from __future__ import annotations

import importlib
from collections.abc import Collection, Iterable, Iterator
from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING

from rigidtop.collection.folder import in_one_line
from rigidtop.collection.kinds import many
from rigidtop.errors import RigidtopError
from rigidtop.proof.lecture import Fault, Illustration, Lecture

if TYPE_CHECKING:
    from rigidtop.figures.drawing import Drawing


def names_of(module: ModuleType) -> tuple[str, ...]:
    """The names that a collection's module gives; RigidtopError for what is no tuple of names."""
    names: tuple[str, ...] = many(getattr(module, "FIGURES", ()), str, "FIGURES")
    if len({*names}) < len(names):
        raise RigidtopError(f"FIGURES names one twice: {', '.join(names)}")
    return names


def drawings(module: ModuleType, folder: Path) -> tuple[Drawing, ...]:
    """The drawings of these names, which are imported; RigidtopError where they are others."""
    from rigidtop.figures.drawing import Drawing

    names = names_of(module)
    if not names:
        return ()
    with in_one_line(folder):
        source = importlib.import_module(f"{module.__name__}.figures")
    figures: tuple[Drawing, ...] = many(getattr(source, "FIGURES", ()), Drawing, "FIGURES")
    if tuple(each.name for each in figures) != names:
        has = ", ".join(each.name for each in figures) or "none"
        raise RigidtopError(
            f"{folder / 'figures.py'}: FIGURES has {has}, and that of __init__.py "
            f"{', '.join(names)}"
        )
    return figures


def checked(lecture: Lecture, names: Collection[str]) -> Lecture:
    """The lecture; a picture that is none of these names, or stands twice, is a fault of its page.

    >>> checked(Lecture(), ()).texts
    ()
    """
    seen: set[str] = set()
    texts = []
    for text in lecture.texts:
        pictures = (each for each in text.blocks if isinstance(each, Illustration))
        faults = (*text.faults, *_amiss(pictures, names, seen))
        texts.append(replace(text, faults=faults))
    return replace(lecture, texts=tuple(texts))


def _amiss(
    pictures: Iterable[Illustration], names: Collection[str], seen: set[str]
) -> Iterator[Fault]:
    there = f"there are {', '.join(names)}" if names else "FIGURES in __init__.py names them"
    for each in pictures:
        if each.name not in names:
            yield Fault(each.at, f"no figure is called {each.name!r}; {there}")
        elif each.name in seen:
            yield Fault(each.at, f"the figure {each.name!r} stands above already")
        seen.add(each.name)
