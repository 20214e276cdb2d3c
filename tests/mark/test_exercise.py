"""Answers to exercises: a derivation, or the numbers that they ask for."""

import json
import math
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rigidtop.cli import main
from rigidtop.derivations.exercises import EXERCISES
from rigidtop.errors import RigidtopError
from rigidtop.mark.cell import answer
from rigidtop.mark.exercise import _marked, answered, ends, numbers
from rigidtop.proof.exercise import Answer

TOPPLING = {exercise.name: exercise for exercise in EXERCISES}["toppling-top"]
ASKED = numbers(TOPPLING)


def test_every_exercise_has_something_that_is_marked():
    """A line of the lecture, or else numbers; that of a body falling is its own goal."""
    marked, refusals = set(), []
    for exercise in EXERCISES:
        try:
            marked.add(exercise.name * bool(ends(exercise.name)))
        except RigidtopError as error:
            refusals.append(str(error))
    assert all(" = …" in each for each in refusals)  # their numbers
    assert {"gyroscope", "space-rate", "bicycle-wheel"} <= marked
    assert ends("azimuthal-rate")[1] == "3.45"


def test_all_numbers_of_an_exercise_pass_and_some_do_not_suffice():
    lines = [f"{x.name} = {x.value:.4g} {x.unit}" for x in ASKED.values()]
    whole = answer("toppling-top", "Some words.\n" + "\n".join(lines)).marking
    assert (whole.passed, whole.summary) == (True, "all 5 numbers are right")
    part = answer("toppling-top", lines[0]).marking
    assert not part.passed
    assert "asked are also time_to_fall = … s" in part.summary
    assert not answer("toppling-top theta=30deg", lines[1]).marking.passed


@pytest.mark.parametrize(
    ("written", "mark", "note"),
    [
        ("time_to_fall = 1.547 s", "follows", "time until θ"),  # cut, not rounded
        ("time_to_fall = 15.48·10⁻¹ s", "follows", "time until θ"),
        ("theta_dot = 153.04 deg/s", "follows", "θ̇ then"),
        ("angular_momentum = 3.472 kg m²/s", "follows", "L then"),
        ("theta_dot = 25.5 rpm", "follows", "θ̇ then"),
        ("time_to_fall = 1.6 s", "wrong", "this is not the time"),
        ("time_to_fall = -1.548 s", "wrong", "its sign"),
        ("theta_dot = 5.342 rad/s", "wrong", "a factor 2"),
        ("theta_dot = 153.04 rad/s", "wrong", "degrees for radians"),
        ("theta_dot = 2.671 Hz", "wrong", "Hz is no unit of it"),
        ("angular_momentum = 3.47 J", "wrong", "J is no unit of it: J s"),
        ("time_to_fall = 2 s", "inconclusive", "two digits"),
        ("time_to_fall = 1.548", "inconclusive", "its unit is not said"),
        ("time_to_fall = 1,548 s", "unread", "such as 1.25e-3 s"),
        ("time_to_fall = 1.5e999 s", "unread", "such as 1.25e-3 s"),
        ("time = 1.548 s", "unread", "asks for no time, but for growth_rate"),
        ("$t = 1.548$", "unread", "an answer of their own"),
    ],
)
def test_a_number_is_marked_by_its_digits_and_its_unit(written, mark, note):
    first, found = answered("toppling-top", f"growth_rate = 1.903 1/s\n{written}")[2].lines
    assert first.mark == "follows"
    assert found.mark == mark
    assert note in found.note
    assert bool(found.slip) == (mark == "wrong" and "not the" not in note)


@given(
    st.floats(1e-9, 1e9) | st.floats(-1e9, -1e-9),
    st.integers(2, 12),
    st.sampled_from(["m", "rad", "1"]),
    st.floats(0.12, 0.88),
)
def test_what_is_rounded_passes_and_what_is_one_tenth_off_does_not(value, digits, unit, off):
    asked = Answer("x", "length", value, unit)
    shown = "" if unit == "1" else unit
    said = f"{value:.{digits - 1}e} {shown}"
    assert _marked(1, said, said, asked).mark == "follows"
    wrong = f"{value * (1 + math.copysign(off, digits - 6.5)):.{digits - 1}e} {shown}"
    assert _marked(1, wrong, wrong, asked).mark == "wrong"


def test_zero_and_words():
    nothing = Answer("drift", "drift", 0.0, "m/s")
    assert _marked(1, "", "0 m/s", nothing).mark == "follows"
    assert _marked(1, "", "0 m/s", replace(nothing, value=0.01)).mark == "inconclusive"
    word = Answer("nearest", "which is nearer", "ω")
    assert _marked(1, "", "ω", word).mark == "follows"
    assert _marked(1, "", "L", word).mark == "inconclusive"


def test_the_command_marks_an_exercise(tmp_path, capsys):
    file = tmp_path / "a.md"
    file.write_text("".join(f"{x.name} = {x.value:.3g} {x.unit}\n" for x in ASKED.values()))
    assert main(["mark", str(file), "--exercise", "toppling-top", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["passed"] is True
    options = ["--exercise", "toppling-top", "--set", "theta=30deg"]
    assert main(["mark", str(file), *options]) == 1
    assert main(["mark", str(tmp_path), *options]) == 0  # a table of marks
    assert "a.md,1,5,False" in capsys.readouterr().out
    for bad in ([], ["--from", "3.54"], ["--to", "3.57", "--from", "3.54", "--set", "theta=1"]):
        assert main(["mark", str(file), *bad]) == 2
