"""``rigidtop mark``: what it prints, its exit codes, what it refuses."""

import csv
import json
from pathlib import Path

import pytest

from rigidtop.cli import main

ANSWERS = Path(__file__).parents[1] / "mark" / "answers"
RIGHT = ANSWERS / "from-3.54-to-3.57.tex"


def test_a_right_answer(capsys):
    assert main(["mark", str(RIGHT), "--from", "3.54", "--to", "(3.57)"]) == 0
    shown = capsys.readouterr().out
    assert "2     follows  θ̈ = θ̇ = 0" in shown
    assert "line 4: for θ constant" in shown
    assert "every line follows, and the derivation arrives at (3.57)\n" in shown
    assert "sin θ = 0 is lost: state the condition" in shown


def test_a_wrong_one(capsys, tmp_path):
    source = RIGHT.read_text("utf-8").replace(r"- (\lambda_3\omega_3)", r"+ (\lambda_3\omega_3)")
    file = tmp_path / "answer.tex"
    file.write_text(source, "utf-8")
    assert main(["mark", str(file), "--from", "3.54", "--to", "3.57"]) == 1
    shown = capsys.readouterr().out
    assert "line 6: it holds with another sign before (λ₃ ω₃) Ω" in shown
    assert shown.splitlines()[-1].startswith(("line 6 does not follow", "sin θ = 0 is lost"))
    assert main(["mark", str(file), "--from", "3.54", "--to", "3.57", "--json"]) == 1
    found = json.loads(capsys.readouterr().out)
    assert (found["from"], found["to"], found["passed"]) == ("3.54", "3.57", False)
    assert found["summary"] == "line 6 does not follow: 3 of 4 lines"
    assert (found["points"], found["of"]) == (3, 4)
    [wrong] = [line for line in found["lines"] if line["verdict"] == "wrong"]
    assert wrong["line"] == 6
    [slip] = wrong["slips"]
    assert slip["words"] == "another sign before (λ₃ ω₃) Ω"
    assert slip["right"].endswith(r"- \left(\lambda_{3} \omega_{3}\right) \Omega + M g R = 0")


def test_a_folder_becomes_a_table_of_marks(capsys, tmp_path):
    right = RIGHT.read_text("utf-8")
    headed = f"# 1 Solution\n\n{right}"  # which makes no collection of it
    (tmp_path / "ann.md").write_text(headed, "utf-8")
    wrong = right.replace(r"- (\lambda_3\omega_3)", r"+ (\lambda_3\omega_3)")
    (tmp_path / "=bob.tex").write_text(wrong, "utf-8")
    (tmp_path / "notes.txt").write_text("no answer")
    assert main(["mark", str(tmp_path), "--from", "3.54", "--to", "3.57"]) == 0
    out, err = capsys.readouterr()
    head, bob, ann = csv.reader(out.splitlines())
    assert head == ["file", "points", "of", "passed", "wrong line", "slips", "summary"]
    assert bob[:6] == ["'=bob.tex", "3", "4", "False", "6", "another sign before (λ₃ ω₃) Ω"]
    assert (ann[0], ann[3], ann[4]) == ("ann.md", "True", "")
    assert ann[1] == ann[2]
    assert err == "2 answers; slips: another sign before (λ₃ ω₃) Ω (1)\n"
    (tmp_path / "none").mkdir()
    assert main(["mark", str(tmp_path / "none"), "--from", "3.54", "--to", "3.57"]) == 2
    assert "no answers in it" in capsys.readouterr().err


def test_a_folder_with_what_cannot_be_marked_says_so(capsys, tmp_path):
    (tmp_path / "ann.tex").write_text(RIGHT.read_text("utf-8"), "utf-8")
    (tmp_path / "bob.md").write_text("I could not do it.", "utf-8")
    asked = ["mark", str(tmp_path), "--from", "3.54", "--to", "3.57"]
    assert main(asked) == 1
    out, err = capsys.readouterr()
    _, ann, bob = csv.reader(out.splitlines())
    assert ann[3] == "True"
    assert bob[1:] == [
        "0",
        "0",
        "False",
        "",
        "",
        "no formula in bob.md: put each between $$ and $$",
    ]
    assert err == "2 answers, 1 of them not marked; slips: none that is named\n"


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        (
            ["{right}", "--from", "3.57", "--to", "3.26"],
            "no derivation from 3.57 to 3.26 is marked",
        ),
        (["{right}", "--from", "x", "--to", "3.53"], "no derivation from x to 3.53 is marked"),
        (["{empty}", "--from", "3.53", "--to", "3.54"], "no formula in {empty}: put each"),
        (["{right}", "--from", "3.53", "--to", "3.54", "--seconds", "0"], "--seconds must be"),
    ],
)
def test_bad_input_is_one_line(capsys, tmp_path, arguments, complaint):
    (tmp_path / "empty").write_text("no formula", "utf-8")
    names = {name: str(tmp_path / name) for name in ("empty",)}
    names["right"] = str(RIGHT)
    assert main(["mark", *(argument.format(**names) for argument in arguments)]) == 2
    shown = capsys.readouterr()
    assert shown.out == ""
    assert shown.err.startswith(f"rigidtop mark: {complaint.format(**names)}")
    assert shown.err.count("\n") == 1
