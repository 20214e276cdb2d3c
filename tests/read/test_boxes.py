"""Boxes of a page: what goes beyond the main thread, between <details> and </details>."""

import pytest

from rigidtop.derivations.letters import LETTERS
from rigidtop.notation import NOTES
from rigidtop.proof.lecture import Box, BoxEnd
from rigidtop.read.page import read_lecture

LAWS = r"""# Laws

Definition. The spin:

$$L_3 = \lambda_3\omega_3$$
"""
BEGIN = r"<details><summary>What $\omega_3$ is</summary>"
PAGE = rf"""# 1 A page

Multiply the spin by $2$:

$$2L_3 = 2\lambda_3\omega_3$$

{BEGIN}

Multiply the spin by $3$:

$$3L_3 = 3\lambda_3\omega_3$$

Divide it by $3\lambda_3$:

$$\frac{{L_3}}{{\lambda_3}} = \omega_3$$

</details>

Multiply it by $2$:

$$4L_3 = 4\lambda_3\omega_3$$
"""


def _page(source):
    return read_lecture([("laws", LAWS), ("page", source)], LETTERS, NOTES)


def test_a_box_has_lines_that_are_judged_like_all_others():
    lecture = _page(PAGE)
    assert not [*lecture.faults(), *lecture.unread(), *lecture.gaps()]
    kinds = [type(block).__name__ for block in lecture.texts[1].blocks]
    assert kinds == ["Heading", "Shown", "Box", "Shown", "Shown", "BoxEnd", "Shown"]
    box = lecture.texts[1].blocks[2]
    assert isinstance(box, Box)
    assert (box.words, box.at, box.for_lecturers) == (r"What $\omega_3$ is", 7, False)


def test_behind_a_box_it_is_the_last_line_of_the_main_thread():
    lecture = _page(PAGE)
    first, _, _, last = (line.id for line in lecture.texts[1].lines)
    assert lecture.cites(last) == (first,)


def test_in_a_box_it_is_never_a_line_outside():
    begins = PAGE.index(BEGIN) + len(BEGIN)
    moved = PAGE[:begins] + PAGE[begins:].replace("Divide it by", "Divide both by")
    (problem,) = [why for _, _, why in _page(moved).unread()]
    assert "not so many lines above" in problem


def test_a_box_can_be_for_lecturers():
    source = PAGE.replace("<details>", '<details class="lecturer">')
    (box,) = [block for block in _page(source).texts[1].blocks if isinstance(block, Box)]
    assert box.for_lecturers


@pytest.mark.parametrize(
    ("old", "new", "at", "problem"),
    [
        ("</details>", "", 22, "the last box has no end"),
        (BEGIN, "", 17, "a box begins with"),
        (BEGIN, f"{BEGIN}\n\n{BEGIN}", 9, "has no box in it"),
        (BEGIN, "<details>", 7, "a box begins with"),
        (BEGIN, f"{BEGIN}\n\n## Here", 9, "a box has no heading in it: end it above 'Here'"),
    ],
)
def test_what_is_wrong_with_a_box_is_said_at_its_line(old, new, at, problem):
    lecture = _page(PAGE.replace(old, new))
    _, where, why = next(lecture.faults())
    assert (where, problem in why) == (at, True), why
    begun = [isinstance(block, Box) for block in lecture.texts[1].blocks]
    ended = [isinstance(block, BoxEnd) for block in lecture.texts[1].blocks]
    assert sum(begun) == sum(ended)
