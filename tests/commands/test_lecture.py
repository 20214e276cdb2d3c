"""What `rigidtop lecture` is asked for in the shell; the documents are judged in tests/report."""

import re

import pytest

from rigidtop.cli import main
from rigidtop.commands import lecture
from rigidtop.web.page import THREE


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """Every kind of file of a small collection, with what is one's own in it."""
    folder = tmp_path_factory.mktemp("lecture")
    assert main(["new", str(folder / "my_course")]) == 0
    page = folder / "my_course" / "pendulum.py"
    own_words = page.read_text("utf-8").replace("The period of a wide swing", "value")
    page.write_text(own_words.replace("the pendulum moves", "at"), "utf-8")
    preamble = folder / "own.tex"
    preamble.write_text("% my own preamble\n", "utf-8")
    own = [
        "--title",
        r"Pendulums at $5: $\dot\theta$",
        "--author",
        "A. Lecturer",
        "--course",
        "PHY 1",
        "--points",
        "4",
    ]
    look = ["--paper", "letter", "--preamble", str(preamble)]
    kinds = ["--slides", "--fragment", "--format", "myst"]
    out = folder / "out"
    assert main(["lecture", f"{folder / 'my_course'}/", "-o", str(out), *own, *look, *kinds]) == 0
    return out


def test_every_kind_of_file_is_written(written):
    names = {path.relative_to(written).as_posix() for path in written.rglob("*.*")}
    assert {"lecture.tex", "lecture.html", "slides.html", "rigidtop.sty"} <= names
    assert {"chapters/1.tex", "myst/myst.yml", "myst/section-1.md"} <= names


def test_every_link_of_a_course_site_leads_somewhere(written):
    pages = {path.stem: path.read_text("utf-8") for path in (written / "myst").rglob("*.md")}
    whole = "\n".join(pages.values())
    places = set(re.findall(r"^(?:\(|:name: )([\w-]+)(?:\)=)?$", whole, re.M))
    assert set(re.findall(r"\]\(#([\w-]+)\)", whole)) <= places
    listed = re.findall(r"\(#page-of-claim-([\w-]+)\)", pages["claims"])
    assert listed
    for name in listed:
        assert f"[in the text](#claim-{name})" in pages[name]
    assert any("*Rests on.* " in pages[name] for name in listed)


@pytest.mark.parametrize(
    ("asked", "said"),
    [
        (["--record", "--slides"], "--record is the record alone"),
        (["--record", "--live"], "--record is the record alone"),
        (["--preamble", "nowhere.tex"], "cannot read nowhere.tex: No such file"),
        (["--class", "a}b"], "--class wants the name of a LaTeX class"),
        (["--points", "0"], "--points wants a number above 0, up to 1000"),
        (["--points", "nan"], "--points wants a number above 0, up to 1000"),
        (["--title", " "], "--title wants some words"),
        (["--author", "日本"], "--author: no LaTeX for the character '日'"),
        (["--title", r"On $\frac{$"], r"--title: $\frac{$ is not read as a formula"),
    ],
)
def test_what_makes_no_sense_is_one_line(capsys, tmp_path, asked, said):
    assert main(["lecture", "-o", str(tmp_path / "out"), *asked]) == 2
    error = capsys.readouterr().err
    assert said in error
    assert error.count("\n") == 1


@pytest.mark.parametrize(
    ("wished", "installed", "plays"),
    [
        (None, True, True),
        (None, False, False),
        (True, True, True),
        (False, True, False),
        (False, False, False),
    ],
)
def test_figures_play_where_what_plays_them_is_installed(monkeypatch, wished, installed, plays):
    monkeypatch.setattr("rigidtop.web.page.THREE", THREE if installed else "nowhere.js")
    assert lecture.playable(wished) is plays


def test_a_wish_for_play_that_cannot_be_is_one_line(monkeypatch, capsys, tmp_path):
    monkeypatch.setattr("rigidtop.web.page.THREE", "nowhere.js")
    assert main(["lecture", "--live", "-o", str(tmp_path / "out")]) == 2
    assert capsys.readouterr().err == (
        "rigidtop lecture: the live page wants three.js: pip install 'rigidtop[web]'\n"
    )
