"""The text of the lecture: every line follows, every change of one falls, no other line comes."""

from __future__ import annotations

from dataclasses import replace

import pytest

from rigidtop.derivations import PAGES, lecture_with
from rigidtop.derivations.exercises import EXERCISES
from rigidtop.derivations.letters import LETTERS
from rigidtop.proof.derivation import judge_line
from rigidtop.read.page import Raw

LECTURE = lecture_with([each.text for each in EXERCISES if each.text])
MOVED = [id for id, line in LECTURE.lines.items() if line.move is not None]
MADE = [id for id in MOVED if LECTURE.lines[id].move.verb != "call"]
CHANGES = 10
"""A line is changed at least so often."""


def test_everything_is_read() -> None:
    assert not list(LECTURE.problems())
    sentences = [piece for line in LECTURE.lines.values() for piece in line.words]
    assert not [piece for piece in sentences if isinstance(piece, Raw)]


@pytest.mark.parametrize("id", LECTURE.lines)
def test_a_line_follows_from_what_it_cites(id: str) -> None:
    judged = LECTURE.judged(id)
    assert judged.follows, f"{judged.line.file}, line {judged.line.at}: {judged.problem}"


@pytest.mark.parametrize("id", MADE)
def test_a_changed_line_falls(id: str) -> None:
    """Without what it cites, with something changed, from other lines, by other moves."""
    trial = LECTURE.trial(id)
    assert trial.unneeded == ()
    assert trial.changes >= CHANGES
    assert trial.survived == ()


def test_only_what_rests_on_a_line_falls_with_it() -> None:
    line = LECTURE.lines["3.54"]
    below = set(LECTURE.below("3.54"))
    assert {"3.57"} <= below
    assert not below & {"3.53", "3.55", "3.56"}
    assert line.id not in below


def test_a_later_equation_does_not_take_the_place_of_a_line() -> None:
    """True all the same in the model: what decides is the move."""
    refused = 0
    for place, id in enumerate(MADE):
        line = LECTURE.judged(id).line
        for other in MADE[place + 1 : place + 6]:
            equations = LECTURE.lines[other].equations
            move = LECTURE.lines[other].move
            if equations == line.equations or move == LECTURE.lines[id].move:
                continue  # one move may make several equations
            if move.verb == "rewrite" or (move.verb == "integrate" and not move.by):
                continue  # it says what a line above says: a constant is a rate that vanishes
            found = judge_line(replace(line, equations=equations), LETTERS)
            assert not found.follows, (id, other)
            refused += 1
    assert refused >= 60


def test_every_numbered_equation_has_its_lines() -> None:
    numbered = {
        claim.name for page in PAGES if page.text for claim in page.claims if claim.name[0] == "3"
    }
    assert numbered <= set(LECTURE.names)
    assert len(LECTURE.way("3.54")[0]) >= 4


def test_every_claim_of_an_exercise_with_a_page_has_its_lines() -> None:
    told = {claim.name for page in PAGES for claim in page.claims}
    missing = {c.name for e in EXERCISES if e.text for c in e.claims} - told - set(LECTURE.names)
    assert missing == set()


def test_an_exercise_cites_the_lecture_and_no_other_exercise() -> None:
    for id, line in LECTURE.lines.items():
        for cited in LECTURE.cites(id):
            there = LECTURE.lines[cited].file
            assert there in (line.file, there.removeprefix("exercises/")), (id, cited)


def test_every_law_says_where_it_is_from() -> None:
    sources = {id: LECTURE.lines[id].source for id in LECTURE.laws}
    assert [id for id, source in sources.items() if not source] == []


def test_no_two_laws_give_one_scalar_a_value() -> None:
    """Cited together they would contradict each other; a vector's laws are of different frames.

    An exercise may have a body of its own.
    """
    laws = [LECTURE.lines[id] for id in LECTURE.laws if not id.startswith("exercises/")]
    sides = [e.sides[0] for line in laws for e in line.equations]
    scalars = [x for x in sides if x.is_Symbol and x not in LETTERS.vectors]
    assert len(scalars) > 10
    assert [x for x in scalars if scalars.count(x) > 1] == []
