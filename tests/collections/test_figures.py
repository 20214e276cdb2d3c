"""Figures beside a page: drawn where it shows them, told where something is wrong with them."""

import json

import pytest

from rigidtop.cli import main

PAGE = r"""# 1 A fall

| letter | meaning | unit | kind |
| --- | --- | --- | --- |
| $z$ | height | m | coordinate |
| $g$ | acceleration of gravity | m/s² | positive |

## Laws

Galilei 1638. Along the motion, the law of falling:

$$\ddot z = -g$$

## What follows

[The figure](#figure-fall) has the height.

![How (1.1) falls, at $g = 2$.](#fall)

Differentiate the law of falling in time:

$$\dddot z = 0 \tag{1.1}$$
"""
PAGE = PAGE.replace(r"\dddot z = 0", r"\ddot z = -g").replace(
    "Differentiate the law of falling in time", "Rewrite the law of falling"
)
FIGURES = """
from rigidtop.figures import picture as pen
from rigidtop.figures.drawing import Drawing
from rigidtop.parameters import Parameter


def fill(axes, g):
    pen.draw(axes, [pen.Curve(([0, 1], [1, 1 - g / 2]))])


FIGURES = (
    Drawing("fall", "A fall", "1", (Parameter("g", 2.0, "gravity", "m/s²", above=0),),
            pen.alone(2, fill), "It is {g} m/s².", "A line down."),
)
"""
EXERCISE = '''
from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, exercise
from rigidtop.proof.page import Claim

FIGURES = ("fall",)


@exercise("depth", "How deep", section="1", asks="the fall", statement="How deep after $t$?",
          claims=(Claim("1.1", "The fall."),), parameters=(Parameter("t", 2.0, "time", "s"),))
def depth(t):
    """By hand."""
    yield Answer("depth", "depth", 4.905 * t**2, "m")


EXERCISES = (depth,)
'''


@pytest.fixture
def course(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / "course"
    folder.mkdir()
    for name, text in {"fall.md": PAGE, "__init__.py": EXERCISE, "figures.py": FIGURES}.items():
        (folder / name).write_text(text, "utf-8")
    return folder


def lines(folder, capsys):
    capsys.readouterr()
    code = main(["check", f"{folder}/"])
    return code, capsys.readouterr().out


def test_a_figure_stands_where_the_page_shows_it(course, tmp_path, capsys):
    assert main(["check", "course/"]) == 0
    assert main(["lecture", "course", "--slides", "-o", "out"]) == 0
    for name in ("lecture.html", "slides.html"):
        html = (tmp_path / "out" / name).read_text("utf-8")
        shown, caption = html.index('<figure id="figure-fall"'), html.index("How (1.1) falls, at")
        assert html.index('href="#figure-fall">Figure 1') < shown < caption < html.index("Rewrite")
        assert html.count("<figcaption>") - html.count('data-figure="map"') == 1
        assert "It is 2\u202fm/s" in html or "It is 2 m/s" in html
    tex = (tmp_path / "out" / "lecture.tex").read_text("utf-8")
    assert r"\rtfigure{figures/fall.pdf}{figure-fall}{Figure 1}{How (1.1) falls, at $g = 2$" in tex


def test_figure_takes_a_collection(course, capsys):
    assert main(["figure", "course/", "--json"]) == 0
    listed = json.loads(capsys.readouterr().out)
    assert [each["name"] for each in listed] == ["fall"]
    assert main(["figure", "course/", "fall", "--set", "g=3", "-o", "a.svg"]) == 0
    assert "It is 3 m/s²." in capsys.readouterr().out
    assert main(["figure", "course/", "--set", "g=3", "fall", "-o", "b.svg"]) == 0
    assert main(["figure", "course/", "fal"]) == 2
    assert "no figure 'fal'; did you mean fall?" in capsys.readouterr().err
    assert main(["figure", "course/", "fall", "-o", "a.gif"]) == 2
    assert "fall does not move" in capsys.readouterr().err
    assert main(["figure", "fall"]) == 2  # the lecture on the top has none of this name


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("(#fall)", "(#fell)", "line 18: no figure is called 'fell'; there are fall"),
        ("(#fall)", "(fall.svg)", "line 18: a picture is a paragraph of its own"),
        (
            "Rewrite the",
            "![Again.](#fall)\n\nRewrite the",
            "line 20: the figure 'fall' stands above already",
        ),
        ("How (1.1)", "How (1.7)", "line 18: no line has the number (1.7)"),
    ],
)
def test_what_is_wrong_with_a_picture_is_told(course, capsys, old, new, told):
    page = course / "fall.md"
    page.write_text(page.read_text("utf-8").replace(old, new, 1), "utf-8")
    code, out = lines(course, capsys)
    assert code == 1
    assert told in " ".join(out.split())


@pytest.mark.parametrize(
    ("file", "old", "new", "told"),
    [
        ("figures.py", 'Drawing("fall"', 'Drawing("fell"', "FIGURES has fell, and that of"),
        ("figures.py", "pen.alone(2, fill)", "pen.alon(2, fill)", "figures.py, line"),
        ("__init__.py", '("fall",)', '("fall", "fall")', "FIGURES names one twice"),
        ("__init__.py", '("fall",)', '"fall"', "FIGURES is a str, not a tuple"),
    ],
)
def test_what_is_wrong_with_the_drawings_is_one_line(course, capsys, file, old, new, told):
    source = course / file
    source.write_text(source.read_text("utf-8").replace(old, new, 1), "utf-8")
    assert main(["figure", "course/", "fall"]) == 2
    error = capsys.readouterr().err
    assert told in error
    assert len(error.strip().split("\n")) == 1


def test_an_exercise_of_a_collection_is_shown_and_marked(course, tmp_path, capsys):
    assert main(["exercise", "course/", "depth"]) == 0
    shown = capsys.readouterr().out
    assert "z̈ = −g  (1.1)" in shown
    assert "19.62" in shown
    for answer, code in (("depth = 19.6 m", 0), ("depth = 39.2 m", 1), ("depth = 19.6 s", 1)):
        (tmp_path / "answer.md").write_text(answer, "utf-8")
        assert main(["mark", "course", "answer.md", "--exercise", "depth"]) == code
    told = " ".join(capsys.readouterr().out.split())
    assert "it is off by a factor 2" in told
    (tmp_path / "answer.md").write_text("depth = 4.905 m", "utf-8")
    marked = ["mark", "course", "answer.md", "--exercise", "depth", "--set", "t=1"]
    assert main(marked) == 0
    assert main([*marked[:-4], "--exercise", "width"]) == 2
    assert "no exercise is called 'width': depth" in capsys.readouterr().err
