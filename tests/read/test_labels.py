"""Numbers as a class counts them, and the labels that stand for them."""

import pytest

from rigidtop.read.labels import counted
from rigidtop.read.statements import statements
from rigidtop.tree.plain import plain

EQ = "\\begin{equation}\\label{%s} a = b \\end{equation}\n"


def numbers(source):
    return [(row.number, row.label) for row in counted(source)]


def test_an_article_counts_through():
    source = "\\documentclass{article}\\section{A}" + EQ % "x" + "\\section{B}" + EQ % "y"
    assert numbers(source) == [("1", "x"), ("2", "y")]


def test_a_label_with_its_kind_is_no_formula():
    source = EQ.replace("label", "label[equation]") % "x"
    assert numbers(source) == [("1", "x")]
    [line] = statements(r"\label[equation]{x} a = b")
    assert plain(line) == "a = b"


@pytest.mark.parametrize(
    "head",
    [
        "\\documentclass{article}\\numberwithin{equation}{section}",
        "\\documentclass{article}\\counterwithin{equation}{section}",
    ],
)
def test_counted_anew_in_each_section(head):
    body = "\\section{A}" + EQ % "x" + EQ % "y" + "\\subsection{S}" + EQ % "z"
    assert numbers(head + body + "\\section*{no}\\section{B}" + EQ % "w") == [
        ("1.1", "x"), ("1.2", "y"), ("1.3", "z"), ("2.1", "w"),
    ]  # fmt: skip


def test_a_book_counts_in_chapters_and_its_appendix_has_letters():
    source = "\\documentclass[a4paper]{book}\\chapter{A}" + EQ % "x" + "\\section{s}" + EQ % "y"
    source += "\\chapter[Short]{B}" + EQ % "z" + "\\appendix\\chapter{C}" + EQ % "w"
    assert numbers(source) == [("1.1", "x"), ("1.2", "y"), ("2.1", "z"), ("A.1", "w")]


def test_rows_stars_tags_and_comments():
    source = (
        "\\begin{align} a &= b \\\\ c &= d \\nonumber\\\\ e &= f \\label{e}\\end{align}"
        "\\begin{align*} a &= b \\end{align*} $$a = b$$ \\[ c = d \\tag{A} \\label{t} \\]"
        "%\\begin{equation} no = no \\end{equation}\n"
        "\\begin{equation} a = \\begin{aligned} b \\\\ c \\end{aligned} \\end{equation}"
        "\\begin{align} a &= \\begin{cases} 1 \\\\ 2 \\end{cases} \\tag{*} \\\\ b &= c\\end{align}"
        "\\begin{equation} a = b \\notag\\end{equation}"
    )
    source = "\\begin{document}" + source
    assert numbers(source) == [
        ("1", ""), ("2", "e"), ("A", "t"), ("3", ""), ("*", ""), ("4", ""),
    ]  # fmt: skip


def test_subequations_have_letters():
    source = "\\begin{document}" + EQ % "a" + "\\begin{subequations}" + EQ % "b" + EQ % "c"
    source += "\\end{subequations}" + EQ % "d"
    assert numbers(source) == [("1", "a"), ("2a", "b"), ("2b", "c"), ("3", "d")]


def test_a_row_stands_where_it_stands():
    source = "\\begin{align} a &= b \\\\ c &= d \\label{here}\\end{align}"
    [_, row] = counted(source)
    assert source[row.start : row.end].strip() == "c &= d \\label{here}"


def test_an_appendix_behind_subsections():
    source = "\\documentclass{article}\\numberwithin{equation}{section}\\section{A}\\subsection{s}"
    source += (
        EQ % "x" + "\\appendix\\section{B}\\subsection{t}" + EQ % "y" + "\\section{C}" + EQ % "z"
    )
    assert numbers(source) == [("1.1", "x"), ("A.1", "y"), ("B.1", "z")]
