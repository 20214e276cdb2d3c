"""The text of the lecture: every line follows, every change of one falls, no other line comes."""

from __future__ import annotations

from dataclasses import replace

import pytest

from rigidtop.derivations import TEXTS, lecture_with
from rigidtop.derivations.exercises import EXERCISES
from rigidtop.derivations.letters import LETTERS
from rigidtop.proof.derivation import Line, judge_line
from rigidtop.proof.lecture import Lecture

WRITTEN = [each.text for each in EXERCISES if each.text]
EVERY = 10
"""A line has at least so many changes; one of so many is tried, all by `check --thorough`."""

each_page = pytest.mark.parametrize("page", [*TEXTS, *WRITTEN])


@pytest.fixture(scope="module")
def lecture() -> Lecture:
    return lecture_with(WRITTEN)


def lines_of(lecture: Lecture, page: str) -> list[Line]:
    [text] = [text for text in lecture.texts if text.name == page]
    return list(text.lines)


def is_made(line: Line) -> bool:
    """Whether a move leads to it, which is more than to give a name."""
    return line.move is not None and line.move.verb != "call"


@each_page
def test_a_changed_line_falls(lecture: Lecture, page: str) -> None:
    """Without what it cites, with something changed, from other lines, by other moves."""
    for line in list(filter(is_made, lines_of(lecture, page)))[::6]:
        trial = lecture.trial(line.id, EVERY)
        assert trial.unneeded == (), line.id
        assert trial.changes >= 1, line.id
        assert trial.survived == (), line.id


def test_only_what_rests_on_a_line_falls_with_it(lecture: Lecture) -> None:
    line = lecture.lines["3.54"]
    below = set(lecture.below("3.54"))
    assert {"3.57"} <= below
    assert not below & {"3.53", "3.55", "3.56"}
    assert line.id not in below


def test_a_later_equation_does_not_take_the_place_of_a_line(lecture: Lecture) -> None:
    """True all the same in the model: what decides is the move."""
    refused, made = 0, [id for id, line in lecture.lines.items() if is_made(line)]
    for place, id in [*enumerate(made)][::2]:
        line = lecture.judged(id).line
        for other in made[place + 1 + place % 3 :][:1]:
            equations = lecture.lines[other].equations
            move = lecture.lines[other].move
            if equations == line.equations or move == lecture.lines[id].move:
                continue  # one move may make several equations
            if move.verb == "rewrite" or (move.verb == "integrate" and not move.by):
                continue  # it says what a line above says: a constant is a rate that vanishes
            found = judge_line(replace(line, equations=equations), LETTERS)
            assert not found.follows, (id, other)
            refused += 1
    assert refused >= 100


def test_an_exercise_cites_the_lecture_and_no_other_exercise(lecture: Lecture) -> None:
    for id, line in lecture.lines.items():
        for cited in lecture.cites(id):
            there = lecture.lines[cited].file
            assert there in (line.file, there.removeprefix("exercises/")), (id, cited)


def test_no_two_laws_give_one_scalar_a_value(lecture: Lecture) -> None:
    """Cited together they would contradict each other; a vector's laws are of different frames.

    An exercise may have a body of its own.
    """
    laws = [lecture.lines[id] for id in lecture.laws if not id.startswith("exercises/")]
    sides = [e.sides[0] for line in laws for e in line.equations]
    scalars = [x for x in sides if x.is_Symbol and x not in LETTERS.vectors]
    assert len(scalars) > 10
    assert [x for x in scalars if scalars.count(x) > 1] == []
