"""The text of the lecture: every line follows, every change of one falls, no other line comes."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy
from sympy import Eq, Ge, Gt, Le, Lt, Ne

from rigidtop.derivations import PAGES, TEXTS, lecture_with
from rigidtop.derivations.exercises import EXERCISES
from rigidtop.derivations.letters import LETTERS
from rigidtop.mark.laws import laws_in, of_the_top
from rigidtop.proof import bounds
from rigidtop.proof.derivation import Line, judge_line
from rigidtop.proof.equation import Printed
from rigidtop.proof.lecture import Lecture
from rigidtop.proof.page import Check, Correction, Remark
from rigidtop.read.page import Raw

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


def test_everything_is_read(lecture: Lecture) -> None:
    assert not list(lecture.unread())
    sentences = [piece for line in lecture.lines.values() for piece in line.words]
    assert not [piece for piece in sentences if isinstance(piece, Raw)]


@each_page
def test_a_line_follows_from_what_it_cites(lecture: Lecture, page: str) -> None:
    assert lines_of(lecture, page)
    for judged in (lecture.judged(line.id) for line in lines_of(lecture, page)):
        assert judged.follows, f"{judged.line.file}, line {judged.line.at}: {judged.problem}"


@each_page
def test_a_changed_line_falls(lecture: Lecture, page: str) -> None:
    """Without what it cites, with something changed, from other lines, by other moves."""
    for line in list(filter(is_made, lines_of(lecture, page)))[::2]:
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
    for place, id in enumerate(made):
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
    assert refused >= 200


def test_every_numbered_equation_has_its_lines(lecture: Lecture) -> None:
    numbered = {
        claim.name for page in PAGES if page.text for claim in page.claims if claim.name[0] == "3"
    }
    assert numbered <= set(lecture.names)
    assert len(lecture.way("3.54")[0]) >= 4


def test_an_exercise_cites_the_lecture_and_no_other_exercise(lecture: Lecture) -> None:
    for id, line in lecture.lines.items():
        for cited in lecture.cites(id):
            there = lecture.lines[cited].file
            assert there in (line.file, there.removeprefix("exercises/")), (id, cited)


def test_every_law_says_where_it_is_from(lecture: Lecture) -> None:
    sources = {id: lecture.lines[id].source for id in lecture.laws}
    assert [id for id, source in sources.items() if not source] == []


def test_no_two_laws_give_one_scalar_a_value(lecture: Lecture) -> None:
    """Cited together they would contradict each other; a vector's laws are of different frames.

    An exercise may have a body of its own.
    """
    laws = [lecture.lines[id] for id in lecture.laws if not id.startswith("exercises/")]
    sides = [e.sides[0] for line in laws for e in line.equations]
    scalars = [x for x in sides if x.is_Symbol and x not in LETTERS.vectors]
    assert len(scalars) > 10
    assert [x for x in scalars if scalars.count(x) > 1] == []


# --- Are they true? -----------------------------------------------------------------------------


def test_no_law_is_false_and_many_are_true_of_a_top_or_a_body(lecture: Lecture) -> None:
    found = laws_in(lecture, of_the_top())
    assert [id for id, holds in found.items() if holds is False] == []
    assert sum(holds is True for holds in found.values()) >= 16


# --- Conditions of the pages, assumptions of the claims ------------------------------------------

_RELATIONS = {"≠": Ne, ">": Gt, "≥": Ge}

DIFFER = {
    "two-mass-points": "the page speaks of the general tilt, the claim of its exceptions",
    "principal-axes": "the page: for two moments that differ, orthogonality is to be shown",
    "space-cone": "the page takes positive roots; the claim says that ω is off the axis",
    "3.51": "the page has it from (3.52), which divides by it",
    "parallel-approximation": "the page compares terms, the claim divides by them",
    "example-34": "the page inherits from (3.45) that the axis is tilted",
    "slow-agrees": "the claim multiplies the spin by δ, the page does so in words",
    "fast-is-free": "the page divides by Ω, the claim by cos θ and for ω₃ > 0",
    "nutation": "the page shows the frequency, the claim the sleeping top too",
    "azimuth": "the page inherits that the axis is tilted; the slope is the claim's alone",
    "friction": "the page speaks of the slip as it is, the claim of its size",
}
"""Where a page divides by something else than its claim, and why both are right."""


def known_nonzero(expression: sympy.Expr, conditions: list[sympy.Rel]) -> bool:
    return bounds.nonzero(expression, conditions) or any(
        bounds.positive(sign * expression, conditions) for sign in (1, -1)
    )


def test_conditions_of_the_pages_are_the_assumptions_of_the_claims(lecture: Lecture) -> None:
    pages, differ = lecture, set()
    for claim in (x for page in PAGES for x in page.claims if x.name in pages.names):
        checks = [x for x in claim.evidence() if isinstance(x, Check)]
        said = [x for x in checks if not isinstance(x, (Correction, Remark))]
        assumed = [a.condition for x in said for a in x.assuming if not isinstance(a.condition, Eq)]
        _, starts = pages.way(claim.name)
        inherited = [c for id in starts for c in pages.judged(id).known.conditions]
        own = [
            c
            for id in pages.names[claim.name]
            for c in pages.judged(id).known.conditions
            if c not in inherited and c.relation in _RELATIONS and not c.expression.has(Printed)
        ]
        recorded = [_RELATIONS[c.relation](c.expression, 0) for c in own]
        unequal = [c for c in assumed if isinstance(c, Ne)]
        agree = (
            all(known_nonzero(c.expression, assumed) for c in own if c.relation == "≠")
            and all(bounds.positive(c.expression, assumed) for c in own if c.relation == ">")
            and all(known_nonzero(c.lhs - c.rhs, recorded) for c in unequal)
        )
        assert all(isinstance(c, (Ne, Gt, Lt, Ge, Le)) for c in assumed)
        if not agree:
            differ.add(claim.name)
    assert differ == {*DIFFER}
