"""The chapters that come with rigidtop, each a collection that can be copied as a start."""

from __future__ import annotations

from pathlib import Path

from rigidtop.collection.pages import pages_of
from rigidtop.errors import RigidtopError

CHAPTERS = Path(__file__).parents[1] / "chapters"
"""The folder in which they stand, each in its own."""


def chapters() -> dict[str, tuple[str, ...]]:
    """The titles of the pages of each chapter, by its name."""
    folders = sorted(each for each in CHAPTERS.iterdir() if each.is_dir())
    return {each.name: tuple(title for _, title, _ in pages_of(each)) for each in folders}


def chapter(name: str) -> Path:
    """The folder of a chapter.  Raises RigidtopError where there is none of this name."""
    if name not in chapters():
        raise RigidtopError(f"no chapter {name!r}; there are {', '.join(chapters())}")
    return CHAPTERS / name
