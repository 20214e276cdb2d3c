"""Files as authors have them: several of LaTeX, notebooks, Markdown; nothing outside is read."""

import json
import time

import pytest

from rigidtop.cli import main
from rigidtop.errors import RigidtopError
from rigidtop.read.project import macros_of, numbers, sources, whole


@pytest.fixture
def project(tmp_path):
    folder = tmp_path / "notes"
    (folder / "parts").mkdir(parents=True)
    (tmp_path / "outside.tex").write_text(r"\newcommand{\x}{outside}", "utf-8")
    (folder / "main.tex").write_text(
        "\\documentclass{article}\n\\usepackage{amsmath, own}\n\\begin{document}\n"
        "\\input{parts/one}\n% \\input{parts/never}\n\\include{../outside}\\input{main}\n"
        "\\[ \\vc F = \\half\\vc p \\tag{1} \\]\n\\end{document}\n",
        "utf-8",
    )
    (folder / "own.sty").write_text(r"\newcommand{\vc}[1]{\mathbf{#1}}", "utf-8")
    (folder / "parts" / "one.tex").write_text(
        "\\def\\half{\\tfrac12}\n\\input{two}\n\\[ V(x) = \\half kx^2 \\]\n", "utf-8"
    )
    (folder / "parts" / "two.tex").write_text(r"\[ \x = V(x + a) \]", "utf-8")
    (folder / "parts" / "never.tex").write_text(r"\[ never = 1 \]", "utf-8")
    return folder / "main.tex"


def test_a_project_is_read_with_what_it_takes_in(project, capsys):
    names = [source.path.name for source in sources(project)]
    assert names == ["main.tex", "own.sty", "one.tex", "two.tex"]
    assert main(["read", str(project), "--json"]) == 0
    records = json.loads(capsys.readouterr().out)
    shown = [(r["file"], r["number"], r["equation"] or r["problem"]) for r in records]
    assert shown == [
        ("main.tex", "", r"\include{../outside} is not read: there is no such file in the folder"),
        ("main.tex", "1", "F = ½ p"),
        ("one.tex", "", "V(x) = ½ k x²"),
        ("two.tex", "", r"the command \x is not known"),
    ]


def test_letters_are_said(tmp_path, capsys):
    path = tmp_path / "notes.md"
    path.write_text(
        "$$L = T - V(x)$$\n\n$$\\vec F = m\\ddot{\\vec r} \\quad\\text{for all } t$$\n", "utf-8"
    )
    assert main(["read", str(path)]) == 0
    said = " ".join(capsys.readouterr().out.split())
    assert "L a number here: the Lagrangian, or the size of an angular momentum?" in said
    assert "V a function of x" in said
    assert "F a vector" in said
    assert "F = m r̈ [for all t]" in said
    path.write_text("$$\\frac{\\partial L}{\\partial\\dot q} = p$$ with $L$ any.\n", "utf-8")
    assert main(["read", str(path)]) == 0
    assert "L differentiated by q̇, the Lagrangian" in " ".join(capsys.readouterr().out.split())


def test_a_notebook_says_in_which_cell(tmp_path, capsys):
    path = tmp_path / "notes.ipynb"
    cells = [
        {"cell_type": "markdown", "source": ["# One\n", "\n", "$$a = b$$\n"]},
        {"cell_type": "code", "source": ["c = d"]},
        {"cell_type": "markdown", "source": "Two\n$$\\oint a = 0$$"},
    ]
    path.write_text(json.dumps({"cells": cells}), "utf-8")
    assert main(["read", str(path), "--json"]) == 0
    records = json.loads(capsys.readouterr().out)
    assert [(r["cell"], r["line"], bool(r["equation"])) for r in records] == [
        *((1, 3, True), (2, 2, False))
    ]
    for broken in ("{}", "[" * 100_000, '{"cells": [1]}', "no"):
        path.write_text(broken, "utf-8")
        with pytest.raises(RigidtopError, match="no Jupyter notebook"):
            sources(path)


HOSTILE = {
    "openings": "$$" + r"\left(a" * 2_500 + "$$",
    "calls": "$$" + "f(" * 8_000 + "$$",
    "definitions": r"\newcommand{\a}{" * 30_000,
    "macros": r"\def\a{bbbbbbbb}\def\b{\c\c\c\c\c\c\c\c}\def\c{\d\d\d\d\d\d\d\d}" * 2
    + "$$x = \\a\\a\\a\\a$$\n" * 200,
    "displays": "$$a=b$$\n\n" * 4_000,
}


@pytest.mark.parametrize("name", HOSTILE)
def test_what_is_hostile_is_read_in_time(name, tmp_path, capsys):
    path = tmp_path / "notes.md"
    path.write_text(HOSTILE[name], "utf-8")
    begun = time.process_time()
    assert main(["read", str(path), "--json"]) == 0
    json.loads(capsys.readouterr().out)
    assert time.process_time() - begun < 10


def test_equations_are_counted_through_the_files_that_are_taken_in(tmp_path):
    text = "\\begin{equation} a = b \\end{equation}\n"
    (tmp_path / "b.tex").write_text("\\section{B}" + text * 2, "utf-8")
    (tmp_path / "c.tex").write_text(text, "utf-8")
    top = tmp_path / "a.tex"
    top.write_text(
        "\\documentclass{article}\\numberwithin{equation}{section}\n\\section{A}\n" + text
        + "% \\input{c}\n\\input{b}\n" + text + "\\input{c}\n",
        "utf-8",
    )  # fmt: skip
    found = sources(top)
    counts = numbers(found)
    assert [[row.number for row in counts[x.path]] for x in found] == [
        ["1.1", "2.3"],
        ["2.1", "2.2"],
        ["2.4"],
    ]
    for source in found:
        for row in counts[source.path]:
            assert source.text[row.start : row.end].strip().startswith("a = b")


def test_a_row_of_letters_is_their_product(tmp_path, capsys):
    file = tmp_path / "a.md"
    file.write_text("Mass $m$:\n$$E = mghu,\\quad b = a\\sqrt{1 - e^2},\\quad x = e^{2t}$$\n")
    assert main(["read", str(file), "--json"]) == 0
    energy, axis, growth = json.loads(capsys.readouterr().out)
    assert (energy["equation"], energy["letters"]["m"]) == ("E = m g h u", "mass")
    assert (axis["equation"], growth["equation"]) == ("b = a √(1 − e²)", "x = e^(2 t)")


def test_both_signs_are_read_in_the_letters_of_a_table_too(tmp_path, capsys):
    file = tmp_path / "a.md"
    file.write_text("$$\\theta = \\pm\\sqrt{2 - \\phi},\\quad\\phi \\leq 2$$\n")
    assert main(["read", str(file), "--notation", "goldstein", "--json"]) == 0
    read = [row["equation"] for row in json.loads(capsys.readouterr().out)]
    assert read == ["θ = √(2 − φ)", "θ = −√(2 − φ)", "φ ≤ 2"]


def test_files_are_one_text_in_the_order_in_which_they_are_taken_in(tmp_path):
    (tmp_path / "main.tex").write_text("a\\usepackage{own}\\input{one}b", "utf-8")
    (tmp_path / "one.tex").write_text("c\\input{main}d", "utf-8")
    (tmp_path / "own.sty").write_text("\\newcommand{\\q}{r}", "utf-8")
    found = sources(tmp_path / "main.tex")
    text = whole(found)
    assert text.text == "a\\usepackage{own}c\\input{main}db"
    for letter, name, start in (("d", "one.tex", 13), ("b", "main.tex", 28)):
        source, place = text.origin(text.text.rindex(letter))
        assert (source.path.name, place, source.text[place]) == (name, start, letter)
    assert "\\q" in macros_of(found)
