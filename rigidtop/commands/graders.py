"""Exercises for what collects points: notebooks for nbgrader and Otter, questions for Moodle.

A notebook asks, marks the answer in its cell, and has a test that turns the marks into points.
Moodle compares numbers; a derivation can only be marked where rigidtop runs.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

from rigidtop.collection import Collection
from rigidtop.commands.mark import subject_of
from rigidtop.errors import RigidtopError
from rigidtop.mark.exercise import ends, ends_of, listed, numbers
from rigidtop.mark.task import top
from rigidtop.parameters import settings
from rigidtop.proof.exercise import Answer, Exercise, Rubric
from rigidtop.report.markdown import markdown
from rigidtop.report.solutions import question
from rigidtop.typeset.words import tex, unmarked, written

TOLERANCE = 5e-3
"""By how much a number may be off in Moodle, relative."""


@dataclass(frozen=True)
class GradedExercise:
    """An exercise with its settings, and what is asked in it: a derivation, numbers, or both."""

    exercise: Exercise
    given: tuple[str, ...]
    goal: tuple[str, str] | None
    numbers: tuple[Answer, ...]
    points: float
    folder: str = ""

    @property
    def line(self) -> str:
        """What names it in the first line of a cell."""
        return " ".join(filter(None, [self.folder, self.exercise.name, *self.given]))

    @property
    def how(self) -> str:
        """The sentence that tells students how to answer, in Markdown."""
        ways = []
        if self.goal is not None:
            start, goal = self.goal
            ways.append(f"a derivation from ({start}) to ({goal}), each formula between `$$`")
        if self.numbers:
            ways.append(f"its numbers, a line each: `{listed(self.numbers)}`")
        return f"Answer below with {', or with '.join(ways)} ({self.points:g} points)."


def asked(
    collection: Collection,
    exercises: Sequence[Exercise],
    settings: Sequence[str],
    points: float | None,
) -> list[GradedExercise]:
    """What the exercises ask.  Raises RigidtopError for one of which nothing can be marked."""
    folder = "" if collection.folder is None else f"{collection.folder}/"
    graded = []
    for exercise in exercises:
        try:
            subject = subject_of(collection) if folder else top()
            goal = ends_of(exercise, subject) if folder else ends(exercise.name)
        except RigidtopError:
            goal = None
        values = tuple(numbers(exercise, settings).values())
        if goal is None and not values:
            raise RigidtopError(f"of {exercise.name} nothing can be marked")
        most = points or (exercise.rubric or Rubric()).total
        graded.append(GradedExercise(exercise, tuple(settings), goal, values, most, folder))
    return graded


# --- Notebooks -----------------------------------------------------------------------------------


def nbgrader(exercises: Sequence[GradedExercise]) -> dict[str, str]:
    """An assignment: the last expression of its tests are the points, parts of them too."""
    cells = [_code("%load_ext rigidtop", "setup", locked=True)]
    for k, each in enumerate(exercises, 1):
        test = f"from rigidtop.commands.cell import points\n{_call(each, k)}"
        cells += [
            _cell("markdown", _question(each), f"question-{k}", locked=True),
            _cell("code", _answer(each, k)),
            _code(test, f"points-{k}", locked=True, grade=True, points=each.points),
        ]
    return {"exercises.ipynb": _notebook(cells)}


def otter(exercises: Sequence[GradedExercise]) -> dict[str, str]:
    """A notebook, and beside it a test for each exercise, a case of it for each point."""
    head = 'import otter\n\ngrader = otter.Notebook("exercises.ipynb")'
    cells = [_cell("code", "%load_ext rigidtop"), _cell("code", head)]
    tests = {}
    for k, each in enumerate(exercises, 1):
        cells += [
            _cell("markdown", _question(each)),
            _cell("code", _answer(each, k)),
            _cell("code", f'grader.check("q{k}")'),
        ]
        tests[f"tests/q{k}.py"] = _test(each, k)
    return {"exercises.ipynb": _notebook(cells), **tests}


def _test(each: GradedExercise, k: int) -> str:
    """A test in the format of OK: it is passed case by case."""
    count = max(1, round(each.points))
    case = "\n".join(
        [
            ">>> from rigidtop.commands.cell import points",
            f">>> {_call(each, k)} >= {{:g}}",
            "True",
        ]
    )
    cases = [
        {
            "code": case.format(each.points * n / count - 1e-3),
            "hidden": False,
            "locked": False,
            "points": each.points / count,
        }
        for n in range(1, count + 1)
    ]
    suite = {"cases": cases, "scored": True, "setup": "", "teardown": "", "type": "doctest"}
    return f"OK_FORMAT = True\n\ntest = {{'name': 'q{k}', 'points': None, 'suites': [{suite!r}]}}\n"


def _question(each: GradedExercise) -> str:
    values = settings(each.exercise.parameters, each.given)
    return f"{markdown(question(each.exercise, values))}\n\n{each.how}"


def _answer(each: GradedExercise, k: int) -> str:
    return f"%%answer {each.line} --as answer_{k} --hint tries\n(your answer)"


def _call(each: GradedExercise, k: int) -> str:
    words = "".join(f", {word!r}" for word in each.given)
    folder = f", folder={each.folder!r}" if each.folder else ""
    name = f"{each.exercise.name!r}"
    return f"points(globals().get('answer_{k}'), {name}, {each.points:g}{words}{folder})"


def _code(source: str, name: str, **options: Any) -> dict[str, Any]:
    return _cell("code", source, name, **options)


def _cell(kind: str, source: str, name: str = "", **options: Any) -> dict[str, Any]:
    """A cell of a notebook; with a name it is one that nbgrader knows."""
    flags = {"grade": False, "solution": False, "locked": False, "task": False, "schema_version": 3}
    metadata = {"nbgrader": {**flags, "grade_id": name, **options}} if name else {}
    cell = {"cell_type": kind, "metadata": metadata, "source": source.splitlines(keepends=True)}
    return {**cell, "execution_count": None, "outputs": []} if kind == "code" else cell


def _notebook(cells: Sequence[dict[str, Any]]) -> str:
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    numbered = [{"id": f"cell-{k}", **cell} for k, cell in enumerate(cells, 1)]
    whole = {
        "cells": numbered,
        "metadata": {"kernelspec": kernel, "language_info": {"name": "python"}},
        "nbformat": 4,
        "nbformat_minor": 5,
    }
    return json.dumps(whole, ensure_ascii=False, indent=1) + "\n"


# --- Moodle --------------------------------------------------------------------------------------


def moodle(exercises: Sequence[GradedExercise]) -> dict[str, str]:
    """Questions in Moodle's XML, each with a field for every number; it is right to half a percent.

    Raises RigidtopError for an exercise without numbers.
    """
    quiz = ElementTree.Element("quiz")
    for each in exercises:
        fields = [x for x in each.numbers if not isinstance(x.value, str)]
        if not fields:
            raise RigidtopError(f"{each.exercise.name} asks for no numbers, which Moodle compares")
        question = ElementTree.SubElement(quiz, "question", {"type": "cloze"})
        name = ElementTree.SubElement(ElementTree.SubElement(question, "name"), "text")
        name.text = unmarked(each.exercise.title)
        text = ElementTree.SubElement(question, "questiontext", {"format": "html"})
        ElementTree.SubElement(text, "text").text = _html(each, fields)
    ElementTree.indent(quiz)
    return {"exercises.xml": ElementTree.tostring(quiz, "unicode", xml_declaration=True) + "\n"}


def _html(each: GradedExercise, fields: Sequence[Answer]) -> str:
    values = settings(each.exercise.parameters, each.given)
    paragraphs = [" ".join(part.split()) for part in each.exercise.statement.split("\n\n")]
    listed = [f"{p.about}: {values[p.name]:.6g}{_unit(p.unit)}" for p in each.exercise.parameters]
    parts = [f"<p>{_words(part)}</p>" for part in paragraphs]
    parts += ["<ul>", *(f"<li>{_words(part)}</li>" for part in listed), "</ul>"] if listed else []
    for x in fields:
        allowed = abs(float(x.value)) * TOLERANCE or 1e-9
        field = f"{{1:NUMERICAL:={float(x.value):.8g}:{allowed:.2g}}}"
        parts.append(f"<p>{_words(x.what)}: {field}{escape(_unit(x.unit))}</p>")
    return "\n".join(parts)


def _words(text: str) -> str:
    """A sentence in HTML with LaTeX, which Moodle sets."""
    return written(text, lambda part: rf"\({escape(tex(part))}\)", escape)


def _unit(unit: str) -> str:
    return "" if unit == "1" else f" {unit}"


FORMATS: Mapping[str, Callable[[Sequence[GradedExercise]], dict[str, str]]] = {
    "nbgrader": nbgrader,
    "otter": otter,
    "moodle": moodle,
}


def write(exercises: Sequence[GradedExercise], kind: str, folder: str) -> list[Path]:
    """The files of a format, each written as a whole into a folder."""
    from rigidtop.terminal.files import check_folder, write_all

    check_folder(folder)
    contents = {name: text.encode() for name, text in FORMATS[kind](exercises).items()}
    return write_all(Path(folder), contents)
