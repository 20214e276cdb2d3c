"""An answer in a cell: the student sees its marks, the teacher has the record."""

import json
from collections import Counter

import pytest

from rigidtop.errors import RigidtopError
from rigidtop.mark.cell import RECORD, answer, load_ipython_extension
from rigidtop.mark.exercise import numbers
from rigidtop.mark.questions import QUESTIONS
from rigidtop.proof.units import parsed

WRONG = r"$$\dot\theta = 0$$ $$\lambda_1\cos\theta\,\Omega^2 + \lambda_3\omega_3\Omega + MgR = 0$$"


def test_a_cell_is_marked_where_it_stands_and_recorded(tmp_path):
    kept = tmp_path / "marks.jsonl"
    found = answer(f"3.54 3.57 --record {kept}", WRONG)
    shown = found._repr_mimebundle_()
    assert "another sign before λ₃ ω₃ Ω" in shown["text/plain"]
    assert "| 1 | θ̇ = 0 | follows |" in shown["text/markdown"]
    assert shown[RECORD] == json.loads(kept.read_text("utf-8"))
    assert (shown[RECORD]["points"], shown[RECORD]["of"], shown[RECORD]["passed"]) == (1, 2, False)
    assert shown[RECORD]["lines"][1]["slips"][0]["words"] == "another sign before λ₃ ω₃ Ω"


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("", "%%answer EXERCISE"),
        ("a b c", "%%answer EXERCISE"),
        ('"', "%%answer EXERCISE"),
        ("--record", "%%answer EXERCISE"),
        ("no-such", "no exercise is called 'no-such'"),
        (
            "vertical-in-primed-frame",
            "of vertical-in-primed-frame no derivation is marked, but its numbers are",
        ),
        ("toppling-top theta=30deg until=10deg", "until = 0.174533 must be more than"),
        ("3.54 3.57 theta=1", "only an exercise has settings"),
        ("3.57 3.26", "no derivation from 3.57 to 3.26"),
        ("3.54 3.57", "no formula in the cell"),
    ],
)
def test_a_bad_line_is_told_in_words(line, said, capsys):
    with pytest.raises(RigidtopError, match=r".*".join(said.split("'"))):
        answer(line, "no formula")
    magics = {}

    class Shell:
        def register_magic_function(self, function, kind, name):
            magics[kind, name] = function

    load_ipython_extension(Shell())
    assert magics["cell", "answer"](line, "no formula") is None
    assert said in capsys.readouterr().out


HINTS = {
    "1": "look at this line again",
    "2": "look for a sign",
    "3": "it holds with another sign before λ₃ ω₃ Ω; right: $",
}


def test_a_hint_says_no_more_than_its_level():
    more = WRONG + r" $$\Omega = 7$$"
    for level, said in HINTS.items():
        found = answer(f"3.54 3.57 --hint {level}", more)
        shown = found._repr_mimebundle_()
        assert [line.mark.value for line in found.lines] == ["follows", "wrong"]  # none behind it
        assert said in shown["text/markdown"]
        for other in {*HINTS.values()} - {said}:
            assert other not in shown["text/plain"]
        hidden = json.dumps(shown, ensure_ascii=False)
        assert ("another sign" in hidden) is (level == "3")  # nor in the record
        assert shown[RECORD]["points"] == found.marking.points[0]
    right = answer("3.54 3.57 --hint 1", r"$$\dot\theta = 0$$")
    assert "for θ constant" in repr(right)


def test_hints_go_on_with_each_try():
    tries = Counter()
    levels = [answer("3.54 3.57 --hint tries", WRONG, tries).hint for _ in range(4)]
    assert levels == [1, 2, 3, 3]
    assert answer("3.53 3.54 --hint tries", WRONG, tries).hint == 1  # another question


def test_an_answer_has_a_name_for_a_test():
    magics, names = {}, {}

    class Shell:
        def register_magic_function(self, function, kind, name):
            magics[kind, name] = function

        def push(self, more):
            names.update(more)

    load_ipython_extension(Shell())
    magics["cell", "answer"]("3.54 3.57 --as mine", WRONG)
    assert names["mine"].source == WRONG
    for line, said in (
        ("3.54 3.57 --as 1x", "--as wants a name"),
        ("3.54 3.57 --hint 4", "--hint"),
    ):
        with pytest.raises(RigidtopError, match=said):
            answer(line, WRONG)


def test_an_exercise_of_the_notebooks_is_marked_by_its_numbers():
    right = answer("exercise-2.3 --hint tries", "Omega_s = 0.711 rad/s\nbeta = 39.3°")
    assert [line.mark.value for line in right.lines] == ["follows", "follows"]
    assert right.marking.summary.startswith("2 of 3 numbers are right; asked are also Omega_b = …")
    wrong = "longer = 1.994 s"
    tries = Counter()
    said = [repr(answer("exercise-1.3 --hint tries", wrong, tries)) for _ in range(3)]
    assert "look at this line again" in said[0]
    assert "it is off by a factor ½" in said[2]
    with pytest.raises(RigidtopError, match=r"of exercise-1\.3 no derivation .* longer = … s"):
        answer("exercise-1.3", r"$$\sigma = 1$$")


def test_every_number_of_the_notebooks_has_a_unit_that_is_read():
    asked = [x for each in QUESTIONS for x in numbers(each).values()]
    assert (len(QUESTIONS), len(asked)) == (24, 40)
    assert {x.unit for x in asked if parsed(x.unit) is None} == {"days"}


@pytest.mark.parametrize("digits", ["2.45", "2.452", "2.453", "2.4525"])
def test_half_a_digit_is_rounded_either_way(digits):
    assert answer("exercise-5.3", f"Omega = {digits} rad/s").marking.passed
