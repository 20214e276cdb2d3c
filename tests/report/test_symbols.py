"""The list of symbols: letters of displays, and on a sheet of exercises of a question's words."""

from __future__ import annotations

import pytest

from rigidtop.derivations import lecture_with
from rigidtop.derivations.exercises import EXERCISES
from rigidtop.notation import GOLDSTEIN, NOTES
from rigidtop.parameters import settings
from rigidtop.proof.exercise import texts
from rigidtop.report import blocks as b
from rigidtop.report import plain
from rigidtop.report.lecture import Edition, sheet
from rigidtop.report.solutions import Solution
from rigidtop.report.symbols import symbol_list
from rigidtop.theory import symbols as s

HEADING = b.SectionHead(1, "", "Symbols", "letters")
WAKING = next(each for each in EXERCISES if each.name == "waking-top")


@pytest.mark.parametrize(("notation", "moment"), [(NOTES, "λ₁"), (GOLDSTEIN, "I₁")])
def test_a_students_sheet_says_what_the_letters_of_its_questions_are(notation, moment):
    """It has no display."""
    asked = Solution(WAKING, settings(WAKING.parameters), (), (), 0.0)
    lines = lecture_with(texts([WAKING], EXERCISES))
    edition = Edition(student=True, lines=lines, notation=notation)
    document, _ = sheet([asked], edition)
    [table] = [x for x in document.blocks if isinstance(x, b.TableBlock) and x.kind == "symbols"]
    told = plain.fragment([table])
    assert f"{moment} " in told
    for meaning in ("drag torque of the air", "mass of the body", "distance from the pivot"):
        assert meaning in told
    assert len(table.rows) == 9


def test_a_letter_of_a_question_is_the_one_that_is_spelled_longest():
    words = b.Paragraph((r"$\dot\theta = 1\ \text{M}$ and $\phi_0 + m\boldsymbol\omega$, not R.",))
    letters = (s.theta, s.thetadot, s.phi, s.omega, s.omega_vec, s.m, s.M, s.R, s.unit)
    _, table = symbol_list([b.ExerciseHead("T", "a", "", 1, ""), words], HEADING, letters)
    meanings = {s.VOCABULARY[x].meaning for x in (s.thetadot, s.omega_vec, s.m)}
    assert {row[1] for row in table.rows} == meanings
    assert symbol_list([words], HEADING, letters) == ()  # no question
    behind = [b.ExerciseHead("T", "a", "", 1, ""), b.Room(), words]
    assert symbol_list(behind, HEADING, letters) == ()
