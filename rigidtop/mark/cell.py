"""An answer in a cell of a notebook, marked where it stands.

    %load_ext rigidtop.mark.cell

    %%answer fast-spin-roots --record marks.jsonl
    $$\\Omega_\\pm = …$$

The first line names an exercise, perhaps with settings of its own (``%%answer toppling-top
theta=30deg``), or two equations: ``%%answer 3.54 3.57``.  The student sees what became of each
line; the teacher has the record, in the output of the cell (and so in the notebook) and, with
``--record``, as a line of JSON in a file.
"""

from __future__ import annotations

import json
import shlex
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rigidtop.errors import RigidtopError
from rigidtop.mark.answer import mark
from rigidtop.mark.exercise import answered
from rigidtop.mark.marking import Marking
from rigidtop.mark.task import task

RECORD = "application/vnd.rigidtop.marking+json"
"""The kind of output in which a notebook keeps the record."""

USAGE = (
    "%%answer EXERCISE [NAME=VALUE …], or %%answer FROM TO, and --record FILE if a file is to have "
    "it too"
)


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
        return {**named, **self.marking.record}

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
    given = [word for word in words if "=" in word]
    names = [word for word in words if word not in given]
    if len(names) not in (1, 2) or any(word.startswith("-") for word in words):
        raise RigidtopError(USAGE)
    if len(names) == 1:
        found = Answered(names[0], *answered(names[0], cell, given))
    elif given:
        raise RigidtopError(f"{given[0]}: only an exercise has settings")
    else:
        found = Answered("", names[0], names[1], mark(cell, task(names[0], names[1])))
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
