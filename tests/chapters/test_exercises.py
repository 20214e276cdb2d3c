"""Exercises of the chapters: their numbers, confirmed for other settings too, and marked."""

import math
from dataclasses import replace
from functools import cache

import pytest

from rigidtop.cli import main
from rigidtop.collection import load
from rigidtop.collection.chapters import CHAPTERS, chapters
from rigidtop.mark.exercise import answered
from rigidtop.proof.exercise import Answer
from rigidtop.proof.page import Measure

EXERCISES = {
    (name, each.name): each for name in chapters() for each in load(CHAPTERS / name).exercises
}
every_exercise = pytest.mark.parametrize(("chapter", "name"), EXERCISES)

NUMBERS = {
    # A square of edge a has λ₂ = Ma²/3 and λ₃ = 5Ma²/12 about the middle of an edge, and R = a/2.
    ("asymmetric", "hanging"): {
        "within": 2 * math.pi * math.sqrt(5 * 0.3 / 6 / 9.81),
        "across": 2 * math.pi * math.sqrt(2 * 0.3 / 3 / 9.81),
        "fastest": 2 * math.sqrt(6 * 9.81 / 5 / 0.3),
    },
    ("asymmetric", "lost"): {
        "kept": abs((5 + 2j) ** 2 - 40 * (-math.cos(1) + 1j * math.sin(1))) ** 2,
        "rate": -4 * 0.2 / 1.8**2 * 320 * (21 * math.sin(1) + 20 * math.cos(1)),
    },
    ("kepler", "comet"): {"period": 75.3 * 365.25 * 86400, "nearest": 0.5885 * 1.495979e11},
    ("kepler", "seasons"): {"longer": 7.77 * 86400},
    ("coupled", "exchange"): {"time": 8.674, "swings": 4.574},
    ("coupled", "three"): {"slowest": math.sqrt(9.81), "fastest": math.sqrt(9.81 + 3 * 1.2)},
    ("foucault", "tower"): {"time": 5.676, "east": 0.0259},
    ("foucault", "pantheon"): {"round": 31.8 * 3600, "period": 16.42},
    # K(0.2) = 1.65962 in tables.
    ("freebody", "whole-turn"): {"period": 5.4203, "clock": 11 / math.sqrt(26) * 5.4203},
    ("freebody", "turnover"): {"longer": 2 * math.log(10) * math.sqrt(5) / (2 * math.pi)},
    # A pendulum from 179° takes 3.90107 times as long for a swing as for a small one.
    ("gyrocompass", "swing"): {"period": 14.180, "time": 3.90107 * 14.180 / 4},
    ("gyrocompass", "course"): {"error": 10.3 / 298.62, "farthest": 2 * 10.3 / 298.62},
    ("rolling", "race"): {"hoop": 1.544, "ball": 1.292, "rough": math.tan(math.radians(20)) / 2},
    ("rolling", "turntable"): {"time": 7.0, "radius": 0.35 / math.pi},
    # The last by Rauch-Wojciechowski and Rutstam, SIGMA 10 (2014) 017: their threshold of J.
    ("tippe", "spin"): {
        "least": 27.65,
        "whole": 1.3**2 / 0.7 * math.sqrt(147.15 / (1.3 - 131 / 140) / 0.4),
    },
    ("tippe", "over"): {"rise": 0.01197, "rate": 160 * (math.cos(0.1) - 0.3) / 1.3},
}
"""From tables, or by hand."""

OTHERS = {
    ("asymmetric", "hanging"): {"R": 0.3, "lambda2": 0.06, "lambda3": 0.05},
    ("asymmetric", "lost"): {"kappa": 2.2, "chi": -2.5, "omega3": -5.0},
    ("kepler", "comet"): {"epsilon": 0.2, "a": 1.5e11},
    ("kepler", "seasons"): {"epsilon": 0.6},
    ("coupled", "exchange"): {"D": 3.0, "length": 0.4},
    ("coupled", "three"): {"D": 5.0, "m": 2.0},
    ("foucault", "tower"): {"height": 20.0, "latitude": -0.6},
    ("foucault", "pantheon"): {"length": 5.0, "A": 0.2, "latitude": 1.2},
    ("freebody", "whole-turn"): {"lambda2": 1.6, "lambda3": 2.0, "a3": 2.7},
    ("freebody", "turnover"): {"lambda3": 2.6, "push": 0.3},
    ("gyrocompass", "swing"): {"alpha": 1.0, "latitude": -1.2, "ratio": 1.4},
    ("gyrocompass", "course"): {"speed": 250.0, "latitude": 1.3},
    ("rolling", "race"): {"slope": 1.0, "R": 0.5},
    ("rolling", "turntable"): {"turn": 0.7, "d": 0.0},
    ("tippe", "spin"): {"h": 0.005, "omega3": 50.0},
    ("tippe", "over"): {"h": 0.005, "tilt": 0.2},
}


@cache
def answers(chapter, name, **given):
    exercise = EXERCISES[chapter, name]
    values = {p.name: p.default for p in exercise.parameters} | given
    outcomes = [*exercise.solve(**values)]
    assert all(o.passed for o in outcomes if isinstance(o, Measure)), outcomes
    assert any(isinstance(o, Measure) for o in outcomes)
    return {o.name: o for o in outcomes if isinstance(o, Answer)}


def test_each_chapter_has_two():
    assert all(sum(where == name for where, _ in EXERCISES) >= 2 for name in chapters())
    assert EXERCISES.keys() == NUMBERS.keys() == OTHERS.keys()


@every_exercise
def test_numbers_are_right_and_confirmed(chapter, name):
    found = answers(chapter, name)
    for which, value in NUMBERS[chapter, name].items():
        assert found[which].value == pytest.approx(value, rel=1e-3), which


@every_exercise
def test_numbers_are_confirmed_for_other_settings(chapter, name):
    assert answers(chapter, name, **OTHERS[chapter, name])


def written(answer, times=1):
    return f"{answer.name} = {times * answer.value:.4e} {answer.unit if answer.unit != '1' else ''}"


@every_exercise
def test_answers_are_marked(chapter, name):
    found = answers(chapter, name)
    solved = replace(EXERCISES[chapter, name], solve=lambda **_: found.values())
    lines = [written(each, times) for times in (1, 2) for each in found.values()]
    marking = answered(name, "\n".join(lines), exercises=[solved])[2]
    assert marking.summary.startswith("line ")
    assert [x.mark for x in marking.lines] == ["follows"] * len(found) + ["wrong"] * len(found)
    assert [x.slip for x in marking.lines[len(found) :]] == ["off by a factor 2"] * len(found)


def test_the_command_marks_an_exercise_of_a_chapter(tmp_path, capsys):
    file = tmp_path / "answer.md"
    for times, code, told in ((1, 0, "all 5 numbers are right"), (2, 1, "off by a factor 2")):
        found = answers("rolling", "race").values()
        file.write_text("\n".join(written(each, times) for each in found), "utf-8")
        marked = ["mark", f"{CHAPTERS / 'rolling'}/", str(file), "--exercise", "race"]
        assert main(marked) == code
        assert told in " ".join(capsys.readouterr().out.split())


def test_the_symbols_stand_with_the_numbers(capsys):
    assert main(["exercise", f"{CHAPTERS / 'kepler'}/", "seasons"]) == 0
    shown = capsys.readouterr().out
    assert "η − ε sin η = nt  (2.3)" in shown
    assert "0.489369" in shown


def test_a_derivation_of_a_chapter_is_marked(tmp_path, capsys):
    file = tmp_path / "answer.md"
    marked = ["mark", f"{CHAPTERS / 'coupled'}/", str(file), "--from", "2.2", "--to", "2.4"]
    for right, code in ((r"\frac{2D}m", 0), (r"\frac{D}m", 1)):
        file.write_text(rf"$$\kappa = \frac gl + {right}$$", "utf-8")
        assert main(marked) == code, capsys.readouterr().out
