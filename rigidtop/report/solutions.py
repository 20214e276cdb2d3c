"""Exercises solved: as blocks of a page, as records for programs."""

from __future__ import annotations

import math
import time
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

from rigidtop.derivations.letters import LETTERS
from rigidtop.errors import RigidtopError
from rigidtop.notation import NOTES, Notation
from rigidtop.parameters import settings
from rigidtop.proof.exercise import Answer, Exercise, Outcome, Table
from rigidtop.proof.lecture import Lecture, Text
from rigidtop.proof.page import Measure
from rigidtop.proof.verdict import Judgement, judge
from rigidtop.report import blocks as b
from rigidtop.report.claims import measured
from rigidtop.report.numbers import SMALLEST_ANGLE, cells, cleaned, shown
from rigidtop.report.plain import rich
from rigidtop.report.records import measure_record
from rigidtop.report.records import record as judgement_record
from rigidtop.report.ways import claim_told, text_blocks
from rigidtop.typeset.words import unmarked


@dataclass(frozen=True)
class Solution:
    """An exercise, solved for its settings; its `text`, if it has one, is among the `lines`."""

    exercise: Exercise
    settings: Mapping[str, float]
    judgements: tuple[Judgement, ...]
    outcomes: tuple[Outcome, ...]
    seconds: float
    text: Text | None = None
    lines: Lecture = field(default_factory=Lecture)

    @property
    def measures(self) -> tuple[Measure, ...]:
        return tuple(outcome for outcome in self.outcomes if isinstance(outcome, Measure))

    @property
    def passed(self) -> bool:
        """Whether every claim holds, every number is confirmed by a second way, no line a gap."""
        lines = self.text.lines if self.text else ()
        return (
            all(j.passed for j in self.judgements)
            and all(m.passed for m in self.measures)
            and all(self.lines.judged(line.id).follows for line in lines)
        )


def solved(
    exercise: Exercise,
    given: Mapping[str, float] | Sequence[str] = (),
    judged: Mapping[str, Judgement] | None = None,
    lines: Lecture | None = None,
) -> Solution:
    """Solve an exercise; `judged` are judgements of claims, by name, that need not be made again.

    `lines` is the lecture with the exercise's own text, whose moves are made.  Raises RigidtopError
    for settings that make no sense, and for a number that is not finite.
    """
    start = time.perf_counter()
    values = settings(exercise.parameters, given)
    outcomes = tuple(exercise.solve(**values))
    for outcome in outcomes:
        if any(isinstance(x, float) and not math.isfinite(x) for x in _numbers(outcome)):
            raise RigidtopError(f"{exercise.name} has no finite answer for these settings")
    done = judged or {}
    lines = lines or Lecture()
    judgements = tuple(
        done.get(claim.name) or judge(claim, letters=LETTERS, lecture=lines)
        for claim in exercise.claims
    )
    text = next((each for each in lines.texts if each.name == exercise.text), None)
    seconds = time.perf_counter() - start
    return Solution(exercise, values, judgements, outcomes, seconds, text, lines)


def _numbers(outcome: Outcome) -> list[float | str]:
    if isinstance(outcome, Answer):
        return [outcome.value]
    if isinstance(outcome, Table):
        return [cell for row in outcome.rows for cell in row]
    return []


def blocks(solution: Solution, *, notation: Notation = NOTES) -> list[b.Block]:
    """The blocks of an exercise with its solution."""
    content = question(solution.exercise, solution.settings, named=not notation.images)
    content.append(b.Subhead("Solution in symbols"))
    own = {display.name for display in solution.text.shown} if solution.text else set()
    if solution.text is not None:
        content.extend(text_blocks(solution.lines, solution.text, notation))
    for judgement in solution.judgements:
        content += claim_told(judgement, notation, led=judgement.claim.name not in own)
    return [*content, *numbers(solution)]


def numbers(solution: Solution) -> Iterable[b.Block]:
    """The numbers of a solution, and what confirms them."""
    yield b.Subhead("Solution in numbers")
    yield b.Paragraph((solution.exercise.method,))
    answers = [outcome for outcome in solution.outcomes if isinstance(outcome, Answer)]
    if answers:
        rows = tuple((a.what, shown(a.value), _unit(a.unit, a.value)) for a in answers)
        yield b.quantities("Found", rows)
    for outcome in solution.outcomes:
        if isinstance(outcome, Table):
            columns = map(cleaned, zip(*outcome.rows, strict=True))
            yield b.TableBlock(outcome.columns, cells([*zip(*columns, strict=True)]), outcome.title)
    if solution.measures:
        yield confirmed(solution.measures)


def confirmed(measures: Sequence[Measure]) -> b.TableBlock:
    """The table that says by how much a second way to the same numbers differs."""
    return measured(measures, "Confirmed", "by a second way")


def question(
    exercise: Exercise, values: Mapping[str, float], *, number: int = 0, named: bool = True
) -> list[b.Block]:
    """The exercise as a student gets it, with nothing of its solution.

    The settings are `named` as in the shell, where that is no other letter than in the formulas.
    """
    rows = tuple(
        (p.about + f" ({p.name})" * named, shown(values[p.name]), _unit(p.unit, values[p.name]))
        for p in exercise.parameters
    )
    content = posed(exercise, number)
    return [*content, b.quantities("Given", rows)] if rows else content


def posed(exercise: Exercise, number: int = 0, points: str = "") -> list[b.Block]:
    """The blocks of an exercise without its solution: its title and its statement."""
    head = b.ExerciseHead(exercise.title, b.anchor(exercise.name), exercise.asks, number, points)
    paragraphs = (" ".join(part.split()) for part in exercise.statement.split("\n\n"))
    return [head, *(b.Paragraph((part,)) for part in paragraphs)]


def _unit(unit: str, value: float | str) -> str:
    """The unit, and degrees beside radians.

    >>> _unit("m", 2.0), _unit("rad", -0.25)
    ('m', 'rad = −14.32°')
    """
    if unit != "rad" or isinstance(value, str) or abs(value) < SMALLEST_ANGLE:
        return unit
    degrees = shown(math.degrees(value), 4)
    return f"rad = {rich((degrees,))}°"


def record(solution: Solution) -> dict[str, object]:
    """A solution as plain values, for `rigidtop exercise --json`."""
    exercise = solution.exercise
    return {
        **listed(exercise),
        "statement": unmarked(exercise.statement),
        "settings": dict(solution.settings),
        "answers": [
            {"name": o.name, "what": unmarked(o.what), "value": _unmarked(o.value), "unit": o.unit}
            for o in solution.outcomes
            if isinstance(o, Answer)
        ],
        "tables": [
            {
                "name": o.name,
                "title": unmarked(o.title),
                "columns": [*map(unmarked, o.columns)],
                "rows": [[*map(_unmarked, row)] for row in o.rows],
            }
            for o in solution.outcomes
            if isinstance(o, Table)
        ],
        "measures": [measure_record(measure) for measure in solution.measures],
        "claims": [judgement_record(judgement) for judgement in solution.judgements],
        "passed": solution.passed,
        "seconds": round(solution.seconds, 4),
    }


def _unmarked(value: float | str) -> float | str:
    return unmarked(value) if isinstance(value, str) else value


def listed(exercise: Exercise) -> dict[str, object]:
    """What `rigidtop exercise --json` says where none is named."""
    return {
        "name": exercise.name,
        "title": unmarked(exercise.title),
        "reference": exercise.section,
        "asks": unmarked(exercise.asks),
        "figure": exercise.figure,
        "parameters": [
            {"name": p.name, "default": p.default, "unit": p.unit, "about": unmarked(p.about)}
            for p in exercise.parameters
        ],
    }
