"""An answer to an exercise: a derivation between two equations, or the numbers that it asks for.

Numbers stand by their names, a line each, in SI units or, where they are angles, in degrees:

    time_to_fall = 1.548 s
    theta_dot = 153 deg

The solution's value decides, rounded or cut to as many digits as are given, two or more.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cache

from rigidtop.derivations.exercises import EXERCISES
from rigidtop.errors import RigidtopError
from rigidtop.mark.answer import LONGEST, SECONDS, SECONDS_A_LINE, mark
from rigidtop.mark.marking import Mark, Marked, Marking
from rigidtop.mark.task import Subject, task, top
from rigidtop.parameters import settings
from rigidtop.proof.exercise import Answer, Exercise
from rigidtop.proof.units import NUMBER, parsed
from rigidtop.typeset.words import unmarked

_NAMED = re.compile(r"^[ \t]*(?:[-*][ \t]+)?`?([A-Za-z]\w*)`?[ \t]*=([^=\n]*)$", re.M)
_NUMBER = re.compile(
    r"(?P<digits>[+−-]?(?:\d{1,20}(?:\.\d{0,20})?|\.\d{1,20}))"
    r"(?:e(?P<e>[+-]?\d{1,2})| ?[·×*] ?10\^?\{?(?P<ten>[-−⁻]?[\d⁰¹²³⁴-⁹]{1,2})\}?)?"
    r"\s*(?P<unit>(?!e[+-]?\d)[^\d\s.,].*|1/.*)?"
)
_PLAIN = str.maketrans("−⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "--0123456789")
_TURNS = {
    ("°", "rad"): math.pi / 180,
    ("°/s", "rad/s"): math.pi / 180,
    ("rpm", "rad/s"): math.pi / 30,
}
"""Units of angles and of their rates, besides those in which they are asked."""
_FACTORS = {
    -1.0: "its sign",
    2.0: "a factor 2",
    0.5: "a factor ½",
    2 * math.pi: "a factor 2π",
    1 / (2 * math.pi): "a factor 1/(2π)",
    180 / math.pi: "degrees for radians",
}
"""What a wrong number is to the right one, and what slip that is."""

HALF = 1e-6
"""By how much of the last digit a value may be off half of it."""
ZERO = 1e-12
"""A solution's value below this is zero, which has no digits."""


def answered(
    name: str,
    source: str,
    given: Sequence[str] = (),
    a_line: float = SECONDS_A_LINE,
    altogether: float = SECONDS,
    exercises: Sequence[Exercise] = EXERCISES,
    subject: Subject | None = None,
) -> tuple[str, str, Marking]:
    """The marks of an answer to an exercise, with the ends of the derivation, if it is one.

    The `exercises` are those of the `subject`, which is the lecture on the top if it is None.

    `given` are settings of the exercise other than its own, such as "theta=30deg".  Raises
    RigidtopError for an exercise or a setting that is not there, and for an answer of which no
    line can be marked, with what can be.

    >>> _, _, found = answered("toppling-top", "growth_rate = 1.903 1/s")
    >>> [line.mark.value for line in found.lines], found.passed
    (['follows'], False)
    """
    exercise = named(name, exercises)
    if len(source) > LONGEST:
        raise RigidtopError(f"an answer has no more than {LONGEST} characters, not {len(source)}")
    asked = numbers(exercise, given)
    if any(match[1] in asked for match in _NAMED.finditer(source)):
        found = _numeric(source, exercise.name, asked)
        rubric = exercise.rubric and exercise.rubric.of_numbers(len(asked))
        return "", "", replace(found, rubric=rubric)
    known = subject is None and exercise in EXERCISES
    ends_here = ends(name) if known else ends_of(exercise, subject or top())
    found = mark(source, task(*ends_here, subject), a_line, altogether)
    return (*ends_here, replace(found, rubric=exercise.rubric))


def numbers(exercise: Exercise, given: Sequence[str] = ()) -> Mapping[str, Answer]:
    """The numbers of an exercise's solution, by their names."""
    values = settings(exercise.parameters, given)
    return {x.name: x for x in exercise.solve(**values) if isinstance(x, Answer)}


def named(name: str, exercises: Sequence[Exercise] = EXERCISES) -> Exercise:
    """The exercise of that name; RigidtopError with the names that there are for another."""
    found: dict[str, Exercise] = {exercise.name: exercise for exercise in exercises}
    if name not in found:
        raise RigidtopError(
            f"no exercise is called {name!r}: {', '.join(found) or 'there is none'}"
        )
    return found[name]


@cache
def ends(name: str) -> tuple[str, str]:
    """The equations between which an answer to an exercise is marked.

    The goal is the first of its claims that can be marked, the start the last equation with a
    number that leads there.  Raises RigidtopError for an exercise that has none, with the numbers
    that can be marked instead.

    >>> ends("fast-spin-roots")
    ('3.57', 'two-roots')
    """
    return ends_of(named(name), top())


def ends_of(exercise: Exercise, subject: Subject) -> tuple[str, str]:
    """The same of an exercise of a collection of one's own."""
    found = _ends([claim.name for claim in exercise.claims], subject)
    if found is None:
        raise RigidtopError(
            f"of {exercise.name} no derivation is marked, but its numbers are, a line each: "
            f"{listed(numbers(exercise).values())}"
        )
    return found


def _ends(goals: Iterable[str], subject: Subject) -> tuple[str, str] | None:
    """The first of some claims that can be marked, behind the last number that leads there."""
    names = subject.lecture.names
    starts = [name for name in reversed(names) if name[:1].isdigit()]
    for goal in goals:
        for start in starts if goal in names else ():
            try:
                task(start, goal, subject)
            except RigidtopError:
                continue
            return start, goal
    return None


def listed(asked: Iterable[Answer]) -> str:
    """What numbers are asked for, as an answer has them."""
    shown = (f"{x.name} = …{f' {x.unit}' * (x.unit != '1')}" for x in asked)
    return ", ".join(shown)


# --- Numbers -------------------------------------------------------------------------------------


def _numeric(source: str, name: str, asked: Mapping[str, Answer]) -> Marking:
    made: list[Marked] = []
    right = set()
    position = 0
    for at, written in enumerate(source.split("\n"), start=1):
        begin, position = position, position + len(written) + 1
        match = _NAMED.fullmatch(written)
        if match is None:
            if re.search(r"[=$\\]", written):
                reason = (
                    "beside numbers no formulas are marked: give them in an answer of their own"
                )
                made.append(Marked(at, written.strip(), Mark.UNREAD, reason, position=begin))
            continue
        value = match[2].strip(" \t.,;")
        said = f"{match[1]} = {value}"
        if match[1] not in asked:
            reason = f"{name} asks for no {match[1]}, but for {listed(asked.values())}"
            made.append(Marked(at, said, Mark.UNREAD, reason, position=begin))
            continue
        made.append(replace(_marked(at, said, value, asked[match[1]]), position=begin))
        if made[-1].mark is Mark.FOLLOWS:
            right.add(match[1])
    left = [x for x in asked.values() if x.name not in right]
    if left:
        told = f"{len(right)} of {len(asked)} numbers are right; asked are also {listed(left)}"
    else:
        told = f"all {len(asked)} numbers are right"
    return Marking(tuple(made), not left, name, problem=told)


def _marked(at: int, said: str, written: str, asked: Answer) -> Marked:
    """One number with its unit."""
    what = unmarked(asked.what)
    if isinstance(asked.value, str):
        same = written.strip("“”\"'").casefold() == asked.value.casefold()
        note = what if same else f"{what}: words are compared letter by letter"
        return Marked(at, said, Mark.FOLLOWS if same else Mark.INCONCLUSIVE, note)
    found = _NUMBER.fullmatch(written)
    if found is None:
        reason = f"a number with its unit, such as 1.25e-3 {asked.unit}, is read"
        return Marked(at, said, Mark.UNREAD, reason)
    unit = re.sub("^deg(?=$|/)", "°", found["unit"] or "")
    problem = _other_unit(unit, asked.unit)
    if problem and not unit:
        return Marked(at, said, Mark.INCONCLUSIVE, problem)
    if problem:
        return Marked(at, said, Mark.WRONG, problem, "another unit")
    digits = found["digits"].translate(_PLAIN)
    power = int((found["e"] or found["ten"] or "0").translate(_PLAIN))
    given = float(f"{digits}e{power}")
    if len(digits.lstrip("+-0.").replace(".", "")) < 2 and (given or abs(asked.value) > ZERO):
        return Marked(at, said, Mark.INCONCLUSIVE, "give two digits or more")
    last = 10.0 ** (power - len(digits.partition(".")[2]))
    true, count = asked.value / _TURNS.get((unit, asked.unit), 1.0) / last, round(given / last)
    for factor, words in {1.0: "", **_FACTORS}.items():
        value = factor * true
        # Half a digit goes either way, and what is computed is half a digit but for rounding.
        if count not in {math.trunc(value), round(value - HALF), round(value + HALF)}:
            continue
        if not words:
            return Marked(at, said, Mark.FOLLOWS, what)
        return Marked(at, said, Mark.WRONG, f"it is off by {words}", f"off by {words}")
    return Marked(at, said, Mark.WRONG, f"this is not the {what}")


def _other_unit(unit: str, asked: str) -> str:
    """Why a unit is not that of what is asked, or nothing."""
    if unit == asked or (not unit and asked in ("1", "rad")):
        return ""
    if not unit:
        return f"its unit is not said: {asked}"
    known = parsed(unit)
    # A number has no unit, and a turn a second is no radian a second.
    alike = known is not None and known == parsed(asked) != NUMBER and "Hz" not in unit + asked
    return "" if alike or (unit, asked) in _TURNS else f"{unit} is no unit of it: {asked}"
