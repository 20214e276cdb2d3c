"""Notebooks with points, and questions for Moodle: what they hold, and the real tools on them."""

import ast
import json
import os
import shutil
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import pytest

from rigidtop.cli import main
from rigidtop.commands.cell import points
from rigidtop.derivations.exercises import EXERCISES
from rigidtop.mark.cell import answer
from rigidtop.mark.exercise import numbers

NUMBERS = "growth_rate = 1.903 1/s\ntime_to_fall = 1.548 s\n"
"""Two of the five numbers of the toppling top."""


def written(kind, folder, *more):
    assert main(["exercise", "toppling-top", "--format", kind, "--sheet", str(folder), *more]) == 0
    return folder


def filled(notebook, text):
    """A notebook with an answer in its cell."""
    for cell in notebook["cells"]:
        if "".join(cell["source"]).startswith("%%answer"):
            cell["source"] = [cell["source"][0], text]
    return notebook


def sources(notebook):
    return ["".join(cell["source"]) for cell in notebook["cells"]]


def test_an_assignment_for_nbgrader(tmp_path):
    written("nbgrader", tmp_path, "--points", "5", "--set", "theta=30deg")
    notebook = json.loads((tmp_path / "exercises.ipynb").read_text("utf-8"))
    told = [cell["metadata"].get("nbgrader", {}) for cell in notebook["cells"]]
    assert [x.get("locked", False) for x in told] == [True, True, False, True]
    assert [x.get("points") for x in told] == [None, None, None, 5]
    assert all(x["schema_version"] == 3 for x in told if x)
    load, question, cell, test = sources(notebook)
    assert load == "%load_ext rigidtop"
    assert "time_to_fall = … s" in question
    assert "(5 points)" in question
    assert cell.startswith("%%answer toppling-top theta=30deg --as answer_1 --hint tries\n")
    assert test.endswith("points(globals().get('answer_1'), 'toppling-top', 5, 'theta=30deg')")
    for each in (load, cell):  # no solution
        assert "1.9" not in each


def test_a_test_for_otter_gives_a_case_a_point(tmp_path):
    written("otter", tmp_path, "--points", "5")
    tree = ast.parse((tmp_path / "tests" / "q1.py").read_text("utf-8"))
    test = ast.literal_eval(tree.body[1].value)
    [suite] = test["suites"]
    assert [case["points"] for case in suite["cases"]] == [1] * 5
    given = answer("toppling-top --as answer_1", NUMBERS)
    names = {"answer_1": given}
    passed = []
    for case in suite["cases"]:
        lines = [line.removeprefix(">>> ") for line in case["code"].splitlines()]
        exec(lines[0], names)
        passed.append(str(eval(lines[1], names)) == lines[2])
    assert passed == [True, True, False, False, False]


def test_points_are_of_the_text_and_its_own_exercise():
    given = answer("toppling-top", NUMBERS)
    assert points(given, "toppling-top", 5) == 2
    assert points(given, "toppling-top", 10) == 4
    assert points(given, "toppling-top", 5, "theta=30deg") == 1  # another time, the same rate
    assert points(given, "fast-spin-roots", 5) == 0
    assert points(None, "toppling-top", 5) == 0


def test_moodle_compares_the_numbers(tmp_path):
    written("moodle", tmp_path)
    [question] = ElementTree.parse(tmp_path / "exercises.xml").getroot()
    assert question.get("type") == "cloze"
    text = question.findtext("questiontext/text")
    [exercise] = [x for x in EXERCISES if x.name == "toppling-top"]
    for asked in numbers(exercise).values():
        assert f"{{1:NUMERICAL:={asked.value:.8g}:" in text
    assert r"\(\theta\) at the start: 0.174533 rad" in text
    assert "$" not in text


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        (
            ["toppling-top", "--format", "otter"],
            "--format otter goes with --sheet DIR, and without",
        ),
        (["--format", "moodle", "--sheet", "{out}", "--json"], "--format moodle goes with --sheet"),
        (
            ["toppling-top", "--format", "otter", "--sheet", "{out}", "--points", "0"],
            "--points wants a number above 0",
        ),
        (["topling", "--format", "otter", "--sheet", "{out}"], "no exercise 'topling'"),
    ],
)
def test_bad_input_is_one_line_and_nothing_is_written(arguments, complaint, tmp_path, capsys):
    out = tmp_path / "out"
    assert main(["exercise", *(x.format(out=out) for x in arguments)]) == 2
    assert capsys.readouterr().err.startswith(f"rigidtop exercise: {complaint}")
    assert not out.exists()


# --- The real tools ------------------------------------------------------------------------------


def tool(name, package):
    """A program of a grader, if it is installed."""
    path = shutil.which(name)
    if path is None:
        pytest.skip(f"{name} is not installed, which is no dependency: pip install {package}")
    return path


def test_nbgrader_collects_the_points(tmp_path):
    nbgrader = tool("nbgrader", "nbgrader")
    source = written("nbgrader", tmp_path / "source" / "sheet", "--points", "5")
    notebook = json.loads((source / "exercises.ipynb").read_text("utf-8"))

    def run(*words):
        environment = {**os.environ, "HOME": str(tmp_path)}
        subprocess.run([nbgrader, *words], cwd=tmp_path, check=True, env=environment)

    run("generate_assignment", "sheet")
    for name, text in {"ann": NUMBERS, "bob": "I could not do it."}.items():
        submitted = tmp_path / "submitted" / name / "sheet"
        submitted.mkdir(parents=True)
        released = tmp_path / "release" / "sheet" / "exercises.ipynb"
        notebook = filled(json.loads(released.read_text("utf-8")), text)
        (submitted / "exercises.ipynb").write_text(json.dumps(notebook), "utf-8")
    run("autograde", "sheet")
    run("export", "--to=grades.csv")
    rows = Path(tmp_path / "grades.csv").read_text("utf-8").splitlines()[1:]
    assert [(row.split(",")[3], float(row.split(",")[7])) for row in rows] == [
        ("ann", 2.0),
        ("bob", 0.0),
    ]


def test_otter_collects_the_points(tmp_path):
    otter = tool("otter", "otter-grader")
    written("otter", tmp_path, "--points", "5")
    notebook = tmp_path / "exercises.ipynb"
    notebook.write_text(json.dumps(filled(json.loads(notebook.read_text("utf-8")), NUMBERS)))
    subprocess.run([otter, "generate", "-t", "tests"], cwd=tmp_path, check=True)
    (tmp_path / "results").mkdir()
    run = [otter, "run", "-a", "autograder.zip", "-o", "results", "exercises.ipynb"]
    subprocess.run(run, cwd=tmp_path, check=True)
    results = json.loads((tmp_path / "results" / "results.json").read_text("utf-8"))
    scores = {test["name"]: (test.get("score"), test.get("max_score")) for test in results["tests"]}
    assert scores["q1"] == (2.0, 5.0)
