"""An answer in a cell of a notebook, marked where it stands.

    %load_ext rigidtop.mark.cell

    %%answer fast-spin-roots --record marks.jsonl
    $$\\Omega_\\pm = …$$

The first line names an exercise, or two equations: ``%%answer 3.54 3.57``.  The student sees what
became of each line; the teacher has the record, in the output of the cell (and so in the notebook)
and, with ``--record``, as a line of JSON in a file.
"""

from __future__ import annotations

import json
import shlex
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from rigidtop.derivations import lecture
from rigidtop.derivations.exercises import EXERCISES
from rigidtop.errors import RigidtopError
from rigidtop.mark.answer import Marking
from rigidtop.mark.limits import marked
from rigidtop.mark.passages import passage
from rigidtop.mark.record import record

RECORD = "application/vnd.rigidtop.marking+json"
"""The kind of output in which a notebook keeps the record."""

USAGE = "%%answer EXERCISE, or %%answer FROM TO, and --record FILE if a file is to have it too"


@dataclass(frozen=True)
class Answered:
    """An answer with its marks, as the cell shows it."""

    asked: str
    start: str
    goal: str
    marking: Marking

    @property
    def record(self) -> dict[str, object]:
        """What the teacher keeps."""
        named = {"exercise": self.asked, "from": self.start, "to": self.goal}
        return {**named, **record(self.marking)}

    def __repr__(self) -> str:
        said = [f"line {x.line}: {x.mark.value}{': ' * bool(x.note)}{x.note}" for x in self.lines]
        return "\n".join([*said, self.marking.summary, *self.marking.lost])

    @property
    def lines(self) -> Any:
        return self.marking.lines

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, object]:
        """What a front end shows: a table, and the words; the record goes with it, unseen."""
        rows = ["| line | read | verdict | |", "|---|---|---|---|"]
        for x in self.lines:
            cells = [str(x.line), x.said, x.mark.value, x.note]
            rows.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
        shown = "\n".join([*rows, "", f"**{self.marking.summary}**", *self.marking.lost])
        return {"text/plain": repr(self), "text/markdown": shown, RECORD: self.record}


@cache
def ends(exercise: str) -> tuple[str, str]:
    """The equations between which an answer to an exercise is marked.

    The goal is the first of its claims that can be marked, the start the last equation with a
    number that leads there.  Raises RigidtopError for an exercise that has none, with what can be
    marked instead.

    >>> ends("fast-spin-roots")
    ('3.57', 'two-roots')
    """
    claims = {each.name: [claim.name for claim in each.claims] for each in EXERCISES}
    if exercise not in claims:
        raise RigidtopError(f"no exercise is called {exercise!r}: {', '.join(claims)}")
    found = _ends(claims[exercise])
    if found is not None:
        return found
    marked = [name for name, goals in claims.items() if _ends(goals) is not None]
    raise RigidtopError(
        f"no line of {exercise} is marked: its answer is no one equation that the models here bear "
        f"out. Exercises with one are {', '.join(marked)}; or name two equations of the lecture, "
        "%%answer 3.54 3.57"
    )


def _ends(goals: Iterable[str]) -> tuple[str, str] | None:
    """The first of some claims that can be marked, behind the last number that leads there."""
    names = lecture().names
    numbers = [name for name in reversed(names) if name[:1].isdigit()]
    for goal in goals:
        for start in numbers if goal in names else ():
            try:
                passage(start, goal)
            except RigidtopError:
                continue
            return start, goal
    return None


def answer(line: str, cell: str) -> Answered:
    """Mark what a cell says, in formulas between dollars.  Raises RigidtopError for a bad line."""
    try:
        words = shlex.split(line)
    except ValueError:
        raise RigidtopError(USAGE) from None
    kept: Path | None = None
    if "--record" in words[:-1]:
        at = words.index("--record")
        kept, words = Path(words[at + 1]), words[:at] + words[at + 2 :]
    if len(words) not in (1, 2) or any(word.startswith("-") for word in words):
        raise RigidtopError(USAGE)
    start, goal = ends(words[0]) if len(words) == 1 else words
    found = Answered(words[0] if len(words) == 1 else "", start, goal, marked(cell, start, goal))
    if not found.lines:
        raise RigidtopError("no formula in the cell: put each between $$ and $$")
    if kept is not None:
        try:
            with kept.open("a", encoding="utf-8") as file:
                file.write(json.dumps(found.record, ensure_ascii=False) + "\n")
        except OSError as error:
            raise RigidtopError(f"cannot write {kept}: {error.strerror}") from None
    return found


def load_ipython_extension(shell: Any) -> None:
    """Give a notebook ``%%answer``; a bad line is told in words."""

    def magic(line: str, cell: str) -> Answered | None:
        try:
            return answer(line, cell)
        except RigidtopError as error:
            print(error)
            return None

    shell.register_magic_function(magic, "cell", "answer")
