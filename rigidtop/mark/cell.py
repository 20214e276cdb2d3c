"""An answer in a cell of a notebook, marked where it stands.

    %load_ext rigidtop

    %%answer fast-spin-roots --record marks.jsonl
    $$\\Omega_\\pm = …$$

The first line names an exercise, perhaps with settings of its own (``%%answer toppling-top
theta=30deg``), one of the notebooks, ``%%answer exercise-1.2``, or two equations: ``%%answer 3.54
3.57``.  The student sees what became of each
line; the teacher has the record, in the output of the cell (and so in the notebook) and, with
``--record``, as a line of JSON in a file.  With ``--hint 1`` only the first wrong line is told,
with 2 also what kind of slip it is, with 3 the line as it has to be; ``--hint tries`` goes from one
to the next with each try.  ``--as NAME`` gives the answer that name, for a test to count points.
"""

from __future__ import annotations

import json
import shlex
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rigidtop.derivations.exercises import EXERCISES
from rigidtop.errors import RigidtopError
from rigidtop.mark.answer import mark
from rigidtop.mark.exercise import answered
from rigidtop.mark.marking import Marked, Marking, kind
from rigidtop.mark.questions import QUESTIONS
from rigidtop.mark.task import Subject, task
from rigidtop.proof.exercise import Exercise

RECORD = "application/vnd.rigidtop.marking+json"
"""The kind of output in which a notebook keeps the record."""

USAGE = (
    "%%answer EXERCISE [NAME=VALUE …], or %%answer FROM TO; --record FILE if a file is to have it "
    "too, --hint 1, 2, 3 or tries, --as NAME"
)
MOST = 3
"""The hint that says all."""


@dataclass(frozen=True)
class Answered:
    """An answer with its marks, as the cell shows it; with a `hint` of 1 to 3 only that much."""

    asked: str
    start: str
    goal: str
    marking: Marking
    source: str = ""
    hint: int = 0
    name: str = ""

    @property
    def record(self) -> dict[str, object]:
        """What the teacher keeps."""
        named = {"exercise": self.asked, "from": self.start, "to": self.goal}
        return {**named, **self.marking.record}

    def __repr__(self) -> str:
        said = [f"line {x.line}: {x.mark.value}{': ' * bool(x.note)}{x.note}" for x in self.lines]
        return "\n".join([*said, self.marking.summary, *self.marking.lost])

    @property
    def lines(self) -> tuple[Marked, ...]:
        """The lines that are shown, with what is said of them."""
        lines, wrong = self.marking.lines, self.marking.first_wrong
        if not self.hint or wrong is None:
            return lines
        return (*lines[: lines.index(wrong)], _hinted(wrong, self.hint))

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, object]:
        """What a front end shows: a table, and the words; the record goes with it, unseen.

        Where hints are given it has no notes, since whoever looks for them would find them.
        """
        rows = [(str(x.line), x.said, x.mark.value, x.note) for x in self.lines]
        heads = ("line", "read", "verdict", "")
        shown = "\n".join(
            [*table(heads, rows), "", f"**{self.marking.summary}**", *self.marking.lost]
        )
        record = self.record
        if self.hint in range(1, MOST):
            kept = [{"line": x.line, "verdict": x.mark.value} for x in self.marking.lines]
            record = {**record, "lines": kept}
        return {"text/plain": repr(self), "text/markdown": shown, RECORD: record}


def _hinted(wrong: Marked, hint: int) -> Marked:
    """The first wrong line with as much as a hint says."""
    words = "look at this line again"
    if hint >= MOST:
        words = f"{wrong.note}; right: ${wrong.right}$" if wrong.right else wrong.note
    elif hint == 2:
        words = f"look for {kind(wrong.slip)}" if wrong.slip else "no single slip explains it"
    return Marked(wrong.line, wrong.said, wrong.mark, words)


def table(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """The lines of a table in Markdown."""
    lines = [f"| {' | '.join(heads)} |", "|" + "---|" * len(heads)]
    for row in rows:
        cells = (" ".join(cell.split()).replace("|", "\\|") for cell in row)
        lines.append("| " + " | ".join(cells) + " |")
    return lines


def answer(
    line: str,
    cell: str,
    tries: Counter[str] | None = None,
    exercises: Sequence[Exercise] = (*EXERCISES, *QUESTIONS),
    subject: Subject | None = None,
) -> Answered:
    """Mark what a cell says, in formulas between dollars.  Raises RigidtopError for a bad line.

    In `tries` is counted how often each exercise has been tried without success.
    """
    words, options = _words(line)
    given = [word for word in words if "=" in word]
    names = [word for word in words if word not in given]
    if len(names) not in (1, 2) or any(word.startswith("-") for word in words):
        raise RigidtopError(USAGE)
    hint, name = options.get("--hint", "0"), options.get("--as", "")
    if hint not in ("0", "1", "2", "3", "tries"):
        raise RigidtopError(f"--hint wants 1, 2, 3 or tries, not {hint}")
    if name and not name.isidentifier():
        raise RigidtopError(f"--as wants a name such as answer, not {name!r}")
    ends: tuple[str, str, Marking]
    if len(names) == 1:
        asked, ends = (
            names[0],
            answered(names[0], cell, given, exercises=exercises, subject=subject),
        )
    elif given:
        raise RigidtopError(f"{given[0]}: only an exercise has settings")
    else:
        start, goal = names
        asked, ends = "", (start, goal, mark(cell, task(start, goal, subject)))
    if not ends[-1].lines:
        raise RigidtopError("no formula in the cell: put each between $$ and $$")
    level = 0 if hint == "tries" else int(hint)
    if hint == "tries":
        counted = Counter[str]() if tries is None else tries
        counted[" ".join(names)] += not ends[-1].passed
        level = min(max(counted[" ".join(names)], 1), MOST)
    found = Answered(asked, *ends, cell, level, name)
    if "--record" in options:
        _keep(found, Path(options["--record"]))
    return found


def _words(line: str) -> tuple[list[str], dict[str, str]]:
    """The words of a line, and its options with what stands behind each."""
    try:
        words = shlex.split(line)
    except ValueError:
        raise RigidtopError(USAGE) from None
    options: dict[str, str] = {}
    for option in ("--record", "--hint", "--as"):
        if option in words[:-1]:
            at = words.index(option)
            options[option] = words[at + 1]
            words = words[:at] + words[at + 2 :]
    return words, options


def _keep(found: Answered, path: Path) -> None:
    try:
        with path.open("a", encoding="utf-8") as file:
            file.write(json.dumps(found.record, ensure_ascii=False) + "\n")
    except OSError as error:
        raise RigidtopError(f"cannot write {path}: {error.strerror}") from None


def load_ipython_extension(shell: Any) -> None:
    """Give a notebook ``%%answer``; a bad line is told in words."""
    register(shell, answer)


def register(shell: Any, judge: Callable[[str, str, Counter[str]], Answered]) -> None:
    """Make a function of a line, a cell and the tries so far the magic ``%%answer`` of a shell."""
    tries: Counter[str] = Counter()

    def magic(line: str, cell: str) -> Answered | None:
        try:
            found = judge(line, cell, tries)
        except RigidtopError as error:
            print(error)
            return None
        if found.name:
            shell.push({found.name: found})
        return found

    shell.register_magic_function(magic, "cell", "answer")
