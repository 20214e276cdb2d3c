"""Answers as students write them: half are wrong, and the line that is wrong is named."""

from pathlib import Path

import pytest

from rigidtop.mark.answer import mark
from rigidtop.mark.task import task

TEXT = (Path(__file__).parent / "answers" / "students.md").read_text("utf-8")
ANSWERS = [part.split("\n", 1) for part in TEXT.split("## ")[1:]]
"""Of each the two equations, and what is written; ✗ stands before the line that is wrong."""


@pytest.mark.parametrize(("ends", "body"), ANSWERS, ids=range(len(ANSWERS)))
def test_the_wrong_line_is_named_and_what_is_right_passes(ends, body):
    wrong = [i + 1 for i, line in enumerate(body.split("\n")) if line.startswith("✗")]
    found = mark(body.replace("✗ ", ""), task(*ends.split()))
    named = [found.first_wrong.line] if found.first_wrong else []
    assert named == wrong, found.summary
    assert found.passed == (not wrong), found.summary
