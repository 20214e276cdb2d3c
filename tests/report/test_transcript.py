"""A formula of which nothing is understood is set all the same, or left as it is."""

import re
from pathlib import Path
from xml.etree import ElementTree

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from rigidtop.cli import main
from rigidtop.read.macros import defined
from rigidtop.report.transcript import transcript

DOT = '<mo scriptlevel="0">˙</mo>'
OPENS, CLOSES = (
    f'<mo form="{form}" fence="true" stretchy="false">|</mo>' for form in ("prefix", "postfix")
)
AUTHORS = sorted((Path(__file__).parents[1] / "judge" / "authors").iterdir())


def inside(source, macros=""):
    made = transcript(source, defined(macros))
    return re.sub(r"^<math[^>]*>|</math>$", "", made)


def text(source):
    return "".join(ElementTree.fromstring(transcript(source, {})).itertext())


def test_macros_of_the_author_are_put_in():
    assert inside(r"\dt\ph", r"\def\ph{\varphi}\newcommand{\dt}[1]{\dot{#1}}") == (
        f"<mover><mi>φ</mi>{DOT}</mover>"
    )


def test_lines_and_matrices_are_tables():
    assert transcript(r"a &= b \\ &= c", {}).count("<mtr>") == 2
    matrix = transcript(r"\begin{pmatrix} 1 & 0 \\ 0 & 1 \end{pmatrix}", {})
    assert matrix.count("<mtd") == 4
    assert '<mo stretchy="true">(</mo>' in matrix
    assert text(r"x = \left[\frac12\right. \tag{2}") == "x=[12(2)"


@pytest.mark.parametrize(
    "source",
    [r"\strange", r"\frac{a}", "x^2^3", r"\left(", r"\begin{matrix} a", "a\u202eb", "{", ""],
)
def test_what_is_not_known_is_left_as_it_is(source):
    assert transcript(source, {}) == ""


@pytest.mark.parametrize("source", [r"\dot" * 500 + "x", r"\left(" * 500 + r"\right)" * 500])
def test_what_is_nested_without_end_is_left_as_it_is(source):
    assert transcript(source, {}) == ""


SOME = [r"\frac", r"\sqrt", "^", "_", "{", "}", "&", r"\\", r"\left", r"\right", "(", "]", "|", "'"]
SOME += [r"\begin{cases}", r"\end{cases}", r"\dot", r"\mathbf", r"\text", "x", "<", "7", "-", r"\,"]


@given(st.lists(st.sampled_from(SOME), max_size=12).map(" ".join))
@example(r"\text{<script>} < x")
def test_whatever_is_set_is_well_formed(source):
    made = transcript(source, {})
    if made:
        ElementTree.fromstring(made)


@pytest.mark.parametrize("notes", AUTHORS, ids=lambda path: path.stem)
def test_an_annotated_page_shows_no_formula_as_its_source(notes, tmp_path, capsys):
    main(["audit", str(notes), "-o", str(tmp_path / "page.html")])
    assert "<code>" not in (tmp_path / "page.html").read_text("utf-8")
