"""Derivations as they are shown: all of them, in every form."""

from __future__ import annotations

import pytest

from rigidtop.derivations import lecture
from rigidtop.notation import NOTES, named
from rigidtop.report import html, plain, tex, typst
from rigidtop.report.lines import steps
from rigidtop.report.ways import called, line_rows, text_blocks, way_blocks

LECTURE = lecture()


@pytest.mark.parametrize("notation", [NOTES, named("landau")], ids=["notes", "landau"])
@pytest.mark.parametrize("text", LECTURE.texts, ids=[text.name for text in LECTURE.texts])
def test_a_page_is_written_in_every_form(text, notation) -> None:
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


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        ("3.57", "Take (3.42) and project on e₁′, e₂′ and e₃:"),  # which is not shown
        ("3.57", "Using the rate of precession, divide by sin θ ≠ 0:"),  # and is said once
        ("constant-rate", "Divide by λ₁ sin² θ ≠ 0, where sin θ ≠ 0:"),
        ("3.42", "Take (3.41) and substitute ẑ:"),
    ],
)
def test_a_sentence_names_the_line_above_where_it_is_not_shown(name: str, sentence: str) -> None:
    shown = plain.fragment(way_blocks(LECTURE, name))
    assert f"\n  {sentence}\n" in shown


def test_what_is_defined_is_called_by_its_name_alone() -> None:
    [line] = [x for x in LECTURE.lines.values() if x.called == "the amplitude"]
    assert line.sentence.startswith("Using (3.56), define")
    assert plain.rich(called(line)) == "the amplitude"


@pytest.mark.parametrize(
    ("words", "noted"),
    [
        (r"\rtmarked{assuming}{if $x$}{So it is.}", True),
        (r"$x = 0$\rtnote{if $x$}", True),
        (r"\rtmarked{proved}{}{So it is.}", False),
    ],
)
def test_a_document_has_a_margin_where_something_stands_in_it(words: str, noted: bool) -> None:
    assert bool(tex.NOTED.search(words)) is noted
