"""``rigidtop exercise``: what it prints, what it writes, what it refuses."""

import json
import re

import pytest

from rigidtop.cli import main
from rigidtop.derivations.exercises import EXERCISES
from rigidtop.proof.exercise import Answer, Exercise
from rigidtop.proof.page import Measure

NAMES = [exercise.name for exercise in EXERCISES]


def test_all_are_listed(capsys):
    assert main(["exercise"]) == 0
    shown = capsys.readouterr().out
    assert all(re.search(rf"^\S.* {name} ", shown, re.M) for name in NAMES)
    assert "$" not in shown
    assert main(["exercise", "--json"]) == 0
    assert [row["name"] for row in json.loads(capsys.readouterr().out)] == NAMES


def test_the_way_to_a_claim_of_an_exercise_as_a_record(capsys):
    assert main(["derive", "bearing-torque", "--json", "--deep"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert {step["verdict"] for step in found["steps"]} == {"follows"}
    assert all(step["id"].startswith("exercises/two_masses:") for step in found["steps"])
    assert "the force of the bearing" in found["rests_on"]
    assert main(["map", "bearing-torque", "--json"]) == 0
    [row] = json.loads(capsys.readouterr().out)["results"]
    assert row["name"] == "bearing-torque"


def test_settings_reach_the_numbers(capsys):
    assert main(["exercise", "toppling-top", "--json", "--set", "theta=30deg", "lambda1=2"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["settings"]["theta"] == pytest.approx(0.5235987755982988)
    assert found["passed"] is True
    answers = {answer["name"]: answer["value"] for answer in found["answers"]}
    assert answers["growth_rate"] == pytest.approx((0.8 * 9.81 * 0.6 / 2) ** 0.5)
    assert [claim["verdict"] for claim in found["claims"]] == ["proved", "assuming"]


def test_the_name_may_stand_behind_the_settings(capsys):
    shown = []
    for words in (["toppling-top", "--set", "theta=30deg"], ["--set", "theta=30deg", "M=2"]):
        more = [] if "toppling-top" in words else ["toppling-top"]
        assert main(["exercise", "--student", *words, *more]) == 0
        shown.append(capsys.readouterr().out)
    assert shown[0].splitlines()[0] == shown[1].splitlines()[0]
    assert shown[0].count("= 30°") == shown[1].count("= 30°") == 1


def test_a_student_gets_the_question_alone(capsys):
    assert main(["exercise", "toppling-top", "--student"]) == 0
    shown = capsys.readouterr().out
    assert "Given:" in shown
    assert not re.search(r"Solution|proved|Found|elliptic|Measured", shown)


def test_a_number_that_is_not_confirmed_fails(capsys, monkeypatch):
    import rigidtop.derivations.exercises as home

    def solve():
        """By guessing."""
        yield Answer("x", "a guess", 1.0)
        yield Measure("the guess against the truth", 1.0, 1e-9)

    guess = Exercise("guess", "A guess", "3.2", "nowhere", "Guess.", (), (), solve)
    monkeypatch.setattr(home, "EXERCISES", (guess,))
    assert main(["exercise", "guess"]) == 1
    assert re.search(r"the guess against the truth +1 +10⁻⁹", capsys.readouterr().out)


@pytest.mark.parametrize("student", [True, False])
def test_sheet(capsys, tmp_path, student):
    more = ["--title", "Sheet 3", *(["--student"] if student else [])]
    assert main(["exercise", "toppling-top", "--sheet", str(tmp_path / "out"), *more]) == 0
    listed = capsys.readouterr().out.split()
    assert {f"{tmp_path}/out/exercises.tex", f"{tmp_path}/out/exercises.html"} <= set(listed)
    for kind in ("tex", "html"):
        made = (tmp_path / "out" / f"exercises.{kind}").read_text("utf-8")
        assert "The toppling top" in made
        assert "Sheet 3" in made
        assert "Sheet 3: exercises" not in made
        words = re.sub(r"^%.*", "", made, flags=re.M)  # what TeX leaves out
        assert ("Solution" in words) is not student
        assert ("time-to-fall" in made) is not student
    assert (tmp_path / "out" / "figures").exists() is not student


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        (["topling-top"], "no exercise 'topling-top'; did you mean toppling-top or "),
        (["xyz"], "no exercise 'xyz'; `rigidtop exercise` lists all"),
        (["toppling-top", "--set", "tilt=1"], "no parameter 'tilt'; there are theta, until, "),
        (["toppling-top", "--set", "theta"], "'theta' is not of the form name=value"),
        (["toppling-top", "--set", "theta=x"], "theta must be a number in rad, such as 0.5"),
        (["toppling-top", "--set", "theta=nan"], "theta must be a number in rad, such as 0.5"),
        (["toppling-top", "--set", "theta=1", "theta=2"], "theta is set twice"),
        (["toppling-top", "--set", "theta=-1"], "theta must be more than 0 rad (0°), not -1 rad"),
        (["toppling-top", "--set", "M=3deg"], "M must be a number in kg, such as 0.5, not '3deg'"),
        (["toppling-top", "--set", "theta=30rpm"], "theta must be a number in rad, such as"),
        (["toppling-top", "--set", "until=1deg"], "until = 0.0174533 must be more than theta"),
        (["--set", "theta=1"], "--set wants one exercise"),
        (["toppling-top", "--pdf"], "--pdf goes with --sheet DIR"),
        (["toppling-top", "--json", "--student"], "--json gives the solutions"),
        (["toppling-top", "--notation", "taylr"], "no notation 'taylr'"),
        (["--notation", "taylr"], "no notation 'taylr'"),
        (["toppling-top", "--points", "5"], "--points goes with --sheet DIR"),
    ],
)
def test_bad_input_is_one_line(capsys, arguments, complaint):
    assert main(["exercise", *arguments]) == 2
    shown = capsys.readouterr()
    assert shown.out == ""
    assert shown.err.startswith(f"rigidtop exercise: {complaint}")
    assert shown.err.count("\n") == 1
