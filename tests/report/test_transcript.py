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
    ("source", "shown"),
    [
        (r"\binom{n}{k}", '<mfrac linethickness="0"><mi>n</mi><mi>k</mi></mfrac>'),
        (r"\dbinom nk", '<mfrac linethickness="0"><mi>n</mi><mi>k</mi></mfrac>'),
        (r"\ce{H2O}", "<msub><mtext>H</mtext><mn>2</mn></msub><mtext>O</mtext>"),
        (r"\ce{Ca(OH)2}", "<mtext>H</mtext><msub><mtext>)</mtext><mn>2</mn></msub>"),
        (r"\ce{SO4^{2-}}", "<msubsup><mtext>O</mtext><mn>4</mn><mtext>2−</mtext></msubsup>"),
        (r"\ce{2H2 + O2 -> 2H2O}", "<mo>+</mo><msub><mtext>O</mtext><mn>2</mn></msub><mo>→</mo>"),
    ],
)
def test_binomials_and_chemical_formulas(source, shown):
    made = transcript(source, {})
    assert shown in made
    ElementTree.fromstring(made)


def test_of_a_document_the_body_is_shown(tmp_path, capsys):
    notes = tmp_path / "notes.tex"
    body = r"Words with $\binom{n}{k}$ and $\ce{H2O}$."
    notes.write_text(
        "\\documentclass{article}\n\\usepackage{mhchem}\n\\newcommand{\\own}{$x$}\n"
        f"\\begin{{document}}\n{body}\n\\end{{document}}\nafter\n",
        "utf-8",
    )
    main(["audit", str(notes), "-o", str(tmp_path / "page.html")])
    page = (tmp_path / "page.html").read_text("utf-8")
    assert "Words with <math" in page
    for word in ("documentclass", "usepackage", "newcommand", "{document}", "after</p>", "<code>"):
        assert word not in page


UNKNOWN = (r"\strange", r"\frac{a}", "x^2^3", r"\left(", r"\begin{matrix} a", "a\u202eb", "{", "")


@pytest.mark.parametrize(
    "source",
    [r"\ce{H\x}", r"\ce{?}", r"\binom{a}", *UNKNOWN],
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
