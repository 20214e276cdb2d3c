"""Derivations as they are shown: all of them, in every form."""

from __future__ import annotations

import pytest

from rigidtop.derivations import lecture
from rigidtop.notation import NOTES, named
from rigidtop.report import html, plain, tex, typst
from rigidtop.report.lines import steps
from rigidtop.report.ways import line_rows, text_blocks, way_blocks

LECTURE = lecture()


@pytest.mark.parametrize("text", LECTURE.texts, ids=[text.name for text in LECTURE.texts])
def test_a_page_is_written_in_every_form(text) -> None:
    """In another notation; in that of the notes test_lecture writes all of them but as text."""
    for notation in (NOTES, named("landau")):
        blocks = text_blocks(LECTURE, text, notation)
        shown = plain.fragment(blocks)
        assert "\\" not in shown
        assert "$" not in shown
    for block in blocks:
        assert tex.tex_block(block)
        assert html.html_block(block)
        assert typst.typst_block(block)


@pytest.mark.parametrize("name", LECTURE.names)
def test_a_way_is_shown_from_the_laws(name: str) -> None:
    shown = plain.fragment(way_blocks(LECTURE, name, deep=True))
    assert "Gap" not in shown
    for step in steps(LECTURE, name):
        assert step["verdict"] in ("follows", "definition")
        assert step["equation"]
        assert step["latex"]


@pytest.mark.parametrize(
    ("notation", "along"),
    [
        ("notes", "Project on e₁′, e₂′ and e₃:"),
        ("goldstein", "Project on e₂′, e₁′ and e₃:"),
    ],
)
def test_axes_along_which_something_is_resolved_have_no_sign(notation: str, along: str) -> None:
    """Of the direction −e₂′ what comes out would have the other sign."""
    (id,) = [
        k for k, x in LECTURE.lines.items() if x.sentence.startswith("Project on $\\mathbf e_1'")
    ]
    letters = NOTES if notation == "notes" else named(notation)
    first = line_rows(LECTURE, id, letters)[0]
    assert plain.rich(first.spoken) == along
