"""Boxes in every form of the lecture: folded, smaller, as they are, left out."""

import pytest

from rigidtop.report import html, markdown, myst, plain, tex, typst
from rigidtop.report.blocks import (
    Aside,
    AsideEnd,
    Document,
    Paragraph,
    SectionHead,
)
from rigidtop.report.selection import for_students, main_thread, projected

INNER = (Aside("A quarrel", for_lecturers=True), Paragraph(("Inside.",)), AsideEnd())
BOX = (Aside("How $θ$ goes on"), Paragraph(("More.",)), *INNER, Paragraph(("Still.",)), AsideEnd())
BLOCKS = (SectionHead(1, "1", "One", "section-1"), Paragraph(("Before.",)), *BOX)
WHOLE = Document("T", "S", (*BLOCKS, Paragraph(("After.",))), "C", lecture=True)


def _words(blocks):
    return [block.content[0] for block in blocks if isinstance(block, Paragraph)]


def test_the_main_thread_has_no_boxes():
    assert _words(main_thread(WHOLE.blocks)) == ["Before.", "After."]


def test_a_student_has_no_box_that_is_for_lecturers():
    assert _words(for_students(WHOLE.blocks)) == ["Before.", "More.", "Still.", "After."]
    assert Aside("How $θ$ goes on") in for_students(WHOLE.blocks)


def test_slides_have_the_main_thread_and_no_solutions_unless_asked():
    solved = SectionHead(1, "", "Solutions", "solutions"), Paragraph(("Solved.",))
    laws = SectionHead(1, "", "Laws", "laws"), Paragraph(("A law.",))
    blocks = (*WHOLE.blocks, *solved, *laws)
    assert _words(projected(blocks)) == ["Before.", "After."]
    assert _words(projected(blocks, solutions=True)) == ["Before.", "After.", "Solved."]


@pytest.mark.parametrize(
    ("made", "begin", "end", "count"),
    [
        (html.write(WHOLE, {}), '<details class="box"><summary>', "</details>", 2),
        (tex.write(WHOLE, {}), r"\rtbox{", r"\rtboxend" + "\n", 2),
        (typst.write(WHOLE, {}), "#boxed[", "\n]\n", 2),
        (markdown.markdown(BOX), "<details><summary>", "</details>", 2),
        (myst.write(WHOLE)["myst/section-1.md"], "{admonition} ", "````\n", 2),
        (plain.fragment(BOX), "── ", "─" * 88 + "\n", 2),
    ],
)
def test_every_form_has_the_box_in_its_place(made, begin, end, count):
    body = made[made.index("Before.") if "Before." in made else 0 :]
    assert (body.count(begin), body.count(end)) == (count, count)
    places = [body.index(x) for x in (begin, "More.", "Inside.", end, "Still.")]
    assert places == sorted(places)
    assert body.rindex(end) > body.index("Still.")


def test_a_box_within_a_box_has_a_shorter_fence():
    body = myst.write(WHOLE)["myst/section-1.md"]
    fences = [line for line in body.splitlines() if line.startswith("````")]
    assert [len(x) - len(x.lstrip("`")) for x in fences] == [5, 4, 4, 5]
