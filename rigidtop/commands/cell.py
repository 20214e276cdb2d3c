"""Cells of a notebook that are judged where they stand, and the points that a test collects.

    %load_ext rigidtop

    %%audit
    $$L = \\tfrac12 m\\dot x^2 - \\tfrac12 kx^2$$ and so $$m\\ddot x = kx.$$

    %%answer fast-spin-roots --hint tries
    $$\\Omega_\\pm = …$$

A folder with a collection of one's own may stand first in the line of either.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Any

from rigidtop.collection import is_folder, opened
from rigidtop.commands.findings import AuditFinding, summary
from rigidtop.commands.formats import message
from rigidtop.commands.mark import subject_of
from rigidtop.commands.notes import Notes, audited
from rigidtop.errors import RigidtopError
from rigidtop.mark.cell import Answered, register, table
from rigidtop.mark.cell import answer as answer_to
from rigidtop.mark.exercise import answered
from rigidtop.proof.exercise import Rubric
from rigidtop.read.project import TextFile

RECORD = "application/vnd.rigidtop.audit+json"
"""The kind of output in which a notebook keeps what `rigidtop audit --json` says."""


@dataclass(frozen=True)
class Audited:
    """A cell with what an audit finds in it, as it is shown below."""

    notes: Notes

    @property
    def shown(self) -> list[AuditFinding]:
        """What is wrong first, then what is said of the other lines."""
        findings = [each for each in self.notes.findings if each.display]
        return sorted(findings, key=lambda each: not each.is_wrong)

    def __repr__(self) -> str:
        lines = [
            f"{each.title} is wrong: {message(each)}"
            if each.is_wrong
            else f"{each.title}: {each.verdict}: {each.words}".removesuffix(": ")
            for each in self.shown
        ]
        return "\n".join([*lines, summary(self.notes.findings)])

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, object]:
        """What a front end shows: a table, and the counts; the record goes with it, unseen."""
        rows = [
            (
                each.title.removeprefix("line "),
                each.written,
                f"**{each.verdict}**" if each.is_wrong else each.verdict,
                "; ".join(message(each).split("\n")[:1]) if each.is_wrong else each.words,
                each.right,
            )
            for each in self.shown
        ]
        heads = ("line", "read", "verdict", "", "right")
        text = "\n".join([*table(heads, rows), "", summary(self.notes.findings)])
        record = [each.record for each in self.notes.findings]
        return {"text/plain": repr(self), "text/markdown": text, RECORD: record}


def audit(line: str, cell: str) -> Audited:
    """What an audit finds in a cell.  Raises RigidtopError where no formula says anything."""
    folders = line.split()
    if len(folders) > 1 or not all(map(is_folder, folders)):
        raise RigidtopError("%%audit, or %%audit FOLDER/ with a collection of one's own")
    with opened(folders) as (collection, _):
        return Audited(audited((TextFile(Path("the cell"), cell),), collection))


def answer(line: str, cell: str, tries: Counter[str] | None = None) -> Answered:
    """The marks of a cell, as of `rigidtop.mark.cell`; a collection may stand first."""
    folder, _, rest = line.strip().partition(" ")
    if not folder or not is_folder(folder):
        return answer_to(line, cell, tries)
    with opened([folder]) as (collection, _):
        return answer_to(rest, cell, tries, collection.exercises, subject_of(collection))


def points(answer: Answered | None, name: str, most: float, *given: str, folder: str = "") -> float:
    """The points of an answer to an exercise, of `most`; 0 where there is none that can be marked.

    It is marked anew, with the `given` settings, so that only its text counts; `folder` is that of
    a collection of one's own.  The rubric is that of the exercise.

    >>> points(None, "toppling-top", 6)
    0.0
    """
    if answer is None:
        return 0.0
    share = _share(str(answer.source), name, given, folder)
    return round(share * most, 2)


@lru_cache(maxsize=64)
def _share(source: str, name: str, settings: tuple[str, ...], folder: str) -> float:
    """The part of all points: tests ask for the same answer again and again."""
    with opened([folder] if folder else []) as (collection, _):
        exercises = [replace(x, rubric=x.rubric or Rubric()) for x in collection.exercises]
        subject = subject_of(collection) if folder else None
        try:
            *_, marking = answered(name, source, settings, exercises=exercises, subject=subject)
        except RigidtopError:
            return 0.0
    reached, total = marking.points
    return reached / total


def load_ipython_extension(shell: Any) -> None:
    """Give a notebook ``%%audit`` and ``%%answer``; a bad line is told in words."""

    def magic(line: str, cell: str) -> Audited | None:
        try:
            return audit(line, cell)
        except RigidtopError as error:
            print(error)
            return None

    shell.register_magic_function(magic, "cell", "audit")
    register(shell, answer)
