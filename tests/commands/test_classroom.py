"""A class: a page for each answer, and one with the marks and the commonest slips."""

import csv
import os
import re
from html import unescape
from pathlib import Path
from xml.etree import ElementTree

import pytest

from rigidtop.cli import main
from rigidtop.commands import classroom
from rigidtop.mark.marking import Mark, Marked, Marking, kind
from rigidtop.proof.exercise import Rubric

RIGHT = Path(__file__).parents[1].joinpath("mark/answers/from-3.54-to-3.57.tex").read_text("utf-8")
SIGN = RIGHT.replace(r"- (\lambda_3\omega_3)", r"+ (\lambda_3\omega_3)")
ASKED = ["--from", "3.54", "--to", "3.57"]


def words(page):
    """What a reader sees of a page, its formulas left out."""
    body = re.sub(r"<style>.*?</style>|<math.*?</math>", "", page, flags=re.S)
    return " ".join(unescape(re.sub(r"<[^>]+>", " ", body)).split())


@pytest.fixture
def answers(tmp_path):
    folder = tmp_path / "answers"
    folder.mkdir()
    (folder / "ann.tex").write_text(RIGHT, "utf-8")
    (folder / "bob.md").write_text(SIGN, "utf-8")
    (folder / "<i>carl.tex").write_text("On $x$ and <script>alert(1)</script>\n" + SIGN, "utf-8")
    (folder / "index.tex").write_text("I could not do it.", "utf-8")
    (folder / "dora.pdf").write_bytes(b"%PDF")
    return folder


def test_a_page_a_student_and_one_for_the_class(answers, tmp_path, capsys):
    out = tmp_path / "out"
    assert main(["mark", str(answers), *ASKED]) == 1
    plain = capsys.readouterr()
    assert main(["mark", str(answers), *ASKED, "-o", str(out)]) == 1
    shown = capsys.readouterr()
    assert shown.out == plain.out
    assert shown.err == f"{plain.err}{out / 'index.html'}\n"
    assert sorted(os.listdir(out)) == ["_i_carl.html", "ann.html", "bob.html", "index.html"]
    pages = {path.name: path.read_text("utf-8") for path in out.iterdir()}
    for page in pages.values():
        ElementTree.fromstring(page.removeprefix("<!DOCTYPE html>\n"))  # well-formed
        assert "<script" not in page
        assert "http" not in re.sub(r'xmlns="[^"]*"', "", page)  # it needs no network
    for row in list(csv.DictReader(shown.out.splitlines()))[1:3]:
        page = words(pages[f"{row['file'].split('.')[0]}.html"])
        assert f"{row['points']} of {row['of']} points; {row['summary']}" in page
    index = words(pages["index.html"])
    assert "3 answers marked, 1 passed; not marked: 2." in index
    assert "a sign 2 <i>carl.tex , line 7: another sign before (λ₃ ω₃) Ω" in index
    assert "dora.pdf neither .tex nor .md" in index
    assert "index.tex no formula in index.tex: put each between $$ and $$" in index
    assert pages["index.html"].count("<a href=") == 1 + 3  # an example, three answers
    bob = pages["bob.html"]
    assert bob.count("audited") - bob.split("</style>")[0].count("audited") == 4
    assert bob.count('class="audited amiss"') == 1
    assert "3 of 4 points; line 6 does not follow: 3 of 4 lines" in words(bob)
    assert r"right: <math" in bob
    assert bob.count("✓ </span>follows") == 3
    assert "✗ </span>wrong" in bob


@pytest.mark.parametrize(
    ("asked", "complaint"),
    [
        (["--exercise", "fast-spin-root"], "no exercise is called 'fast-spin-root'"),
        (["--exercise", "fast-spin-roots", "--set", "thet=1"], "thet"),
        (["--from", "9.9", "--to", "3.57"], "no line of the lecture is called '9.9'"),
        (["--given", "nowhere.tex", "--to", "x = 1"], "cannot read nowhere.tex"),
    ],
)
def test_what_is_asked_for_in_vain_is_told_once_and_is_no_mark(asked, complaint, answers, capsys):
    assert main(["mark", str(answers), *asked]) == 2
    shown = capsys.readouterr()
    assert shown.out == ""
    assert complaint in shown.err
    assert shown.err.count("\n") == 1


def test_names_of_strangers_lead_nowhere(answers, tmp_path, capsys):
    for name in ("INDEX.md", "a b.md", "a_b.md", "..x.md", "é" * 120 + ".md"):
        (answers / name).write_text(RIGHT, "utf-8")
    (answers / os.fsdecode(b"\xff.tex")).write_text(RIGHT, "utf-8")
    (tmp_path / "secret.md").write_text("The secret is $x = 1$.", "utf-8")
    (answers / "link.md").symlink_to(tmp_path / "secret.md")
    out = tmp_path / "out"
    assert main(["mark", str(answers), *ASKED, "-o", str(out)]) == 1
    assert "link.md is a link that leads out of the folder" in capsys.readouterr().out
    names = set(os.listdir(out))
    assert {
        "INDEX-2.html",
        "a_b.html",
        "a_b-2.html",
        "_x.html",
        "_.html",
        "é" * 50 + ".html",
    } < names
    assert not any("secret" in path.read_text("utf-8") for path in out.iterdir())
    hrefs = re.findall(r'<a href="([^"#]+)"', (out / "index.html").read_text("utf-8"))
    assert {*map(unescape, hrefs)} == names - {"index.html"}


def test_nothing_is_written_by_halves(answers, tmp_path, monkeypatch, capsys):
    assert main(["mark", str(answers), *ASKED, "-o", str(answers)]) == 2
    assert "has the answers: write the pages elsewhere" in capsys.readouterr().err
    (tmp_path / "file").write_text("")
    assert main(["mark", str(answers), *ASKED, "-o", str(tmp_path / "file")]) == 2
    assert capsys.readouterr().out == ""  # before anything was marked

    def interrupted(name, source, marking):
        if name == "bob.md":
            raise KeyboardInterrupt
        return ""

    monkeypatch.setattr(classroom, "marked_page", interrupted)
    with pytest.raises(KeyboardInterrupt):
        classroom.write_class(answers, lambda name, source: Marking((), True, ""), tmp_path / "out")
    assert os.listdir(tmp_path / "out") == []


def test_one_answer_becomes_a_page(answers, tmp_path, capsys):
    file, page = answers / "bob.md", tmp_path / "bob.html"
    assert main(["mark", str(file), *ASKED, "-o", str(page)]) == 1
    assert "line 6 does not follow" in words(page.read_text("utf-8"))
    assert main(["mark", str(file), *ASKED, "-o", str(file)]) == 2
    assert "is the answer that is marked: write the page elsewhere" in capsys.readouterr().err
    assert file.read_text("utf-8") == SIGN


def test_numbers_are_framed_where_they_stand(tmp_path, capsys):
    answer = tmp_path / "answer.md"
    answer.write_text("By integration\n\ntime_to_fall = 5 s\ngrowth_rate = 1.903 1/s\n", "utf-8")
    page = tmp_path / "page.html"
    assert main(["mark", str(answer), "--exercise", "toppling-top", "-o", str(page)]) == 1
    text = page.read_text("utf-8")
    assert "<code>growth_rate = 1.903 1/s</code>" in text
    assert text.count("✓ </span>follows") == 1


def test_a_rubric_counts_an_error_once():
    rubric = Rubric(line=2, lines=3, goal=4)
    marks = [Mark.FOLLOWS, Mark.WRONG, Mark.CARRIED, Mark.CARRIED]
    behind = [0, 0, 2, 2]
    lines = [Marked(k, "", m, behind=b) for k, (m, b) in enumerate(zip(marks, behind, strict=True))]
    carried = Marking(tuple(lines), False, "", rubric=rubric)
    assert carried.points == (4.5, 10)  # three of four lines, of six points
    right = Marking((lines[0],), True, "", rubric=rubric)
    assert right.points == (6, 10)  # the goal and one of three lines
    padded = Marking((lines[0],) * 20, True, "", rubric=rubric)
    assert padded.points == (10, 10)
    assert Marking(tuple(lines), False, "").points == (3, 4)
    with pytest.raises(ValueError, match="a rubric has points of 0 or more"):
        Rubric(line=0, goal=0)


@pytest.mark.parametrize(
    ("slip", "said"),
    [
        ("another sign before λ₃ ω₃ Ω", "a sign"),
        ("off by its sign", "a sign"),
        ("off by a factor 2π", "a number or a factor"),
        ("½ times M g R", "a number or a factor"),
        ("3 in place of 2", "a number or a factor"),
        ("cos in place of sin", "a function or its argument"),
        ("ψ̇ in place of φ̇", "a letter"),
        ("one more dot on θ", "a dot"),
        ("x² in place of x", "a power or a root"),
        ("x squared", "a power or a root"),
        ("no M g R", "a term too many or too few"),
        ("no root", "a power or a root"),
        ("sine and cosine of θ exchanged", "two things exchanged"),
        ("another unit", "a unit"),
        ("something", "another slip"),
    ],
)
def test_the_kind_of_a_slip(slip, said):
    assert kind(slip) == said


def test_a_display_has_the_worst_mark_of_its_lines(tmp_path, capsys):
    text = r"\begin{align}\ddot\theta &= \dot\theta = 0\\ " + "\n"
    text += r"\lambda_1\Omega^2\cos\theta + \lambda_3\omega_3\Omega + MgR &= 0\end{align}"
    (tmp_path / "answer.tex").write_text(text, "utf-8")
    page = tmp_path / "page.html"
    assert main(["mark", str(tmp_path / "answer.tex"), *ASKED, "-o", str(page)]) == 1
    assert page.read_text("utf-8").count('class="audited amiss"') == 1
    assert "line 2: it holds with another sign before λ₃ ω₃ Ω" in words(page.read_text("utf-8"))
    assert "✗ </span>wrong" in page.read_text("utf-8")
