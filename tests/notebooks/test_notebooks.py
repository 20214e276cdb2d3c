"""The notebooks run, are what their sources make, and keep solutions from students."""

from __future__ import annotations

import copy
import importlib.util
import re
import shutil
import subprocess
import sys
from pathlib import Path

import jupytext
import nbformat
import pytest

NOTEBOOKS = Path(__file__).parents[2] / "notebooks"
SOURCES = sorted(NOTEBOOKS.glob("[0-9]-*.py"))
BUILD = NOTEBOOKS / "build.py"
LARGEST = 3_000_000
"""Bytes, of all copies together."""

each = pytest.mark.parametrize("source", SOURCES, ids=lambda source: source.stem)


@pytest.fixture(scope="module")
def build():
    spec = importlib.util.spec_from_file_location("build_notebooks", BUILD)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def shipped(kind: str, source: Path):
    return nbformat.read(NOTEBOOKS / kind / f"{source.stem}.ipynb", as_version=4)


def test_there_are_five_or_six():
    assert 5 <= len(SOURCES) <= 6
    assert [source.name[0] for source in SOURCES] == [str(n + 1) for n in range(len(SOURCES))]


EXECUTED = """
import sys
sys.path.insert(0, sys.argv[1])
import build, nbformat
whole = nbformat.read(sys.argv[2], as_version=4)
build.execute("a notebook", whole)
nbformat.write(whole, sys.argv[2])
"""


def python(*words):
    """In a process of its own, which may leave sockets open."""
    words = [sys.executable, *map(str, words)]
    return subprocess.run(words, capture_output=True, text=True, timeout=600)


@pytest.fixture(scope="module")
def executed(build, tmp_path_factory):
    """The teacher's copies as their sources make them, by a single kernel: imports are half of it.

    It fails where a cell fails, warns or shows an address.
    """
    made = {source: build.read(source) for source in SOURCES}
    parts = [[*made[source].cells, nbformat.v4.new_code_cell("%reset -f")] for source in SOURCES]
    cells = [copy.deepcopy(cell) for part in parts for cell in part]
    for number, cell in enumerate(cells):
        cell.id = f"cell-{number}"
    path = tmp_path_factory.mktemp("notebooks") / "whole.ipynb"
    nbformat.write(nbformat.v4.new_notebook(cells=cells), path)
    done = python("-c", EXECUTED, NOTEBOOKS, path)
    assert done.returncode == 0, done.stderr
    ran = iter(nbformat.read(path, as_version=4).cells)
    for source, part in zip(SOURCES, parts, strict=True):
        code = [(cell, new) for cell, new in zip(part, ran, strict=False) if "outputs" in cell]
        for count, (cell, new) in enumerate(code[:-1], 1):
            cell.outputs, cell.execution_count = new.outputs, count
            for output in cell.outputs:
                if "execution_count" in output:
                    output.execution_count = count
        made[source].metadata = nbformat.from_dict(build.METADATA)
        nbformat.validate(made[source])
    return made


@each
def test_the_copies_are_what_their_source_makes(build, executed, source):
    """Where this fails, mend the source, or run `python notebooks/build.py`."""
    teacher = executed[source]
    assert build.differences(teacher, shipped("teacher", source)) == []
    assert build.differences(build.student(teacher), shipped("student", source)) == []


@each
def test_only_the_teacher_has_solutions(source):
    cells = jupytext.read(source).cells
    tags = [cell.metadata.get("tags", [""])[0] for cell in cells]
    solutions = [c for c, tag in zip(cells, tags, strict=True) if tag in ("solution", "lecturer")]
    of_teacher, of_student = ((NOTEBOOKS / kind / f"{source.stem}.ipynb") for kind in COPIES)
    teacher = {cell.source for cell in nbformat.read(of_teacher, as_version=4).cells}
    student = of_student.read_text("utf-8")
    everything = "\n".join(cell.source for cell in nbformat.reads(student, as_version=4).cells)
    lecture = "\n".join(cell.source for cell in cells if cell not in solutions)
    assert tags.count("solution") >= 3
    assert tags.count("lecturer") >= 1
    assert '"solution"' not in student
    assert "verdict" not in everything
    for solution in solutions:
        assert solution.source in teacher
        for line in solution.source.splitlines():
            # A line that the lecture has too ("axes.set_xlabel…") gives nothing away.
            if len(line.strip()) > 12 and line not in lecture:
                assert line not in everything


COPIES = ("teacher", "student")


@each
def test_exercises_are_numbered_and_have_room_for_an_answer(source):
    cells = shipped("student", source).cells
    chapter = source.name[0]
    found = [i for i, c in enumerate(cells) if c.source.find("### Exercise") >= 0]
    assert 3 <= len(found) <= 5
    for number, i in enumerate(found, 1):
        assert f"### Exercise {chapter}.{number}\n" in cells[i].source
        assert cells[i + 1].cell_type == "code"
        assert cells[i + 1].source == ""
        assert cells[i + 1].outputs == []
        assert cells[i].source.count("<details>") == cells[i].source.count("</details>") == 2
        check = cells[i + 2]
        assert check.source.startswith(f"%%answer exercise-{chapter}.{number} --hint tries\n")
        assert all(re.fullmatch(r"\w+ = ….*", line) for line in check.source.splitlines()[1:])
        assert check.outputs == []


@each
def test_the_answers_of_the_teachers_copy_are_right(source):
    """As many numbers as are asked, and each follows."""
    checks = [c for c in shipped("teacher", source).cells if c.source.startswith("%%answer")]
    assert len(checks) == 4
    for check in checks:
        [output] = check.outputs
        count = len(check.source.splitlines()) - 1
        assert output.data["text/plain"].endswith(f"\nall {count} numbers are right")
        assert {*output.data} == {"text/plain", "text/markdown"}  # no record of a student


@each
def test_one_line_imports_all_and_nothing_is_asserted(source):
    text = source.read_text("utf-8")
    imports = re.findall("^(?:from|import) .*", text, re.M)
    assert imports == ["from rigidtop.notebook import *"]
    assert "\nassert " not in text


def test_the_live_top_plays_in_the_fifth():
    [cell] = [c for c in shipped("student", SOURCES[4]).cells if "rt.show(" in c.source]
    assert "the page plays here" in cell.outputs[0].data["text/html"]


@each
def test_the_students_copy_is_executed(source):
    cells = [c for c in shipped("student", source).cells if c.cell_type == "code" and c.source]
    cells = [c for c in cells if not c.source.startswith("%%answer")]
    assert [c.execution_count for c in cells] == list(range(1, len(cells) + 1))
    assert 12 <= len(shipped("student", source).cells) <= 60
    assert any("image/png" in o.get("data", {}) for c in cells for o in c.outputs)
    assert any("$" in o.get("data", {}).get("text/latex", "") for c in cells for o in c.outputs)


@pytest.mark.parametrize("kind", COPIES)
@each
def test_nothing_in_a_copy_changes_by_itself(source, kind):
    text = (NOTEBOOKS / kind / f"{source.stem}.ipynb").read_text("utf-8")
    for word in ("iopub", "model_id", "widget-state", "stderr", "Traceback", "/tmp/", "/home/"):
        assert word not in text
    ids = [cell.id for cell in nbformat.reads(text, as_version=4).cells]
    assert all(re.fullmatch(r"(cell|answer)-\d+", name) for name in ids)
    assert len(set(ids)) == len(ids)


def test_they_are_small():
    assert sum(path.stat().st_size for path in NOTEBOOKS.glob("*/*.ipynb")) < LARGEST


def test_every_copy_has_a_source():
    stems = {source.stem for source in SOURCES}
    for kind in COPIES:
        assert {path.stem for path in (NOTEBOOKS / kind).glob("*.ipynb")} == stems


def test_symbols_print_as_in_the_notes():
    """λ₁, ω̇₂ and φ̇ of three notebooks, in what their cells show."""
    shown = {
        source.name[0]: "\n".join(
            output.data.get("text/latex", "")
            for cell in shipped("teacher", source).cells
            for output in cell.get("outputs", [])
            if "data" in output
        )
        for source in SOURCES
    }
    assert r"\lambda_{1}\dot{\omega}_{1} &= (\lambda_{2} - \lambda_{3})" in shown["1"]
    assert r"\dot{\psi} + \dot{\phi}\cos\theta" in shown["3"]
    assert r"\ddot{\theta} &= \frac{(\lambda_{1}\dot{\phi}^{2}\cos\theta" in shown["4"]
    assert "lambda1" not in "".join(shown.values())
    assert "varphi" not in "".join(shown.values())


# --- What the builder refuses --------------------------------------------------------------------


def tiny(tmp_path, build, text):
    source = tmp_path / "1-tiny.py"
    source.write_text(text, "utf-8")
    return build.read(source)


LESSON = """# %% [markdown]
# Hello

# %%
x = 1

# %% [markdown]
# ### Exercise 1.1
#
# Why?
"""
SOLVED = (
    LESSON
    + """
# %% tags=["solution"]
x + 1

# %% [markdown] tags=["solution"]
# So.

# %% tags=["check"]
# %%answer stable-axes
# period = 12.75 s
"""
)


def test_solutions_are_cut(tmp_path, build):
    teacher = tiny(tmp_path, build, '# %% tags=["lecturer"]\n7\n\n' + SOLVED)
    asked = "%%answer stable-axes\nperiod = "
    for count, cell in enumerate((c for c in teacher.cells if c.cell_type == "code"), 1):
        cell.execution_count = count
        cell.outputs = [nbformat.v4.new_output("execute_result", execution_count=count)]
    student = build.student(teacher)
    assert [c.source for c in teacher.cells][-3:] == ["x + 1", "So.", asked + "12.75 s"]
    kept = ["Hello", "x = 1", "### Exercise 1.1\n\nWhy?", "", asked + "… s"]
    assert [c.source for c in student.cells] == kept
    counts = [c.execution_count for c in student.cells if c.cell_type == "code"]
    assert counts == [1, None, None]
    assert student.cells[1].outputs[0].execution_count == 1
    assert student.cells[-1].outputs == []


def test_an_exercise_needs_a_solution(tmp_path, build):
    with pytest.raises(build.BuildError, match="an exercise without a solution"):
        tiny(tmp_path, build, LESSON)


def test_an_exercise_needs_a_check(tmp_path, build):
    with pytest.raises(build.BuildError, match="an exercise without a check"):
        tiny(tmp_path, build, SOLVED.partition('\n# %% tags=["check"]')[0])


def test_no_code_behind_a_solution(tmp_path, build):
    with pytest.raises(build.BuildError, match="stands behind one"):
        tiny(tmp_path, build, SOLVED + "\n# %%\ny = x\n")


def test_a_stale_copy_is_seen(build):
    """Another source, another output, another number of cells; but not other pixels."""
    source = SOURCES[0]
    fresh, old = shipped("teacher", source), shipped("teacher", source)
    assert build.differences(fresh, old) == []
    picture = next(
        o for c in old.cells for o in c.get("outputs", []) if "image/png" in o.get("data", {})
    )
    picture.data["image/png"] = "other pixels"
    assert build.differences(fresh, old) == []
    said = next(c for c in old.cells for o in c.get("outputs", []) if o.get("text"))
    said.outputs[0].text += "!"
    assert build.differences(fresh, old) == [said.id]
    old.cells[0].source += " "
    assert build.differences(fresh, old) == [old.cells[0].id, said.id]
    del old.cells[-1]
    assert len(build.differences(fresh, old)) == 1


def test_the_builder_writes_and_checks(tmp_path):
    source = tmp_path / "1-tiny.py"
    source.write_text("# %%\n%load_ext rigidtop\n\n" + SOLVED, "utf-8")
    builder = shutil.copy(BUILD, tmp_path)
    done = python(builder)
    assert done.returncode == 0, done.stderr
    assert nbformat.read(tmp_path / "student" / "1-tiny.ipynb", as_version=4).cells[-2].source == ""
    source.write_text(source.read_text("utf-8").replace("x + 1", "x + 2"), "utf-8")
    done = python(builder, "1", "--check")
    assert done.returncode == 1
    assert done.stderr == "teacher/1-tiny.ipynb: cell-05 is not what its source makes\n"


@pytest.mark.parametrize(
    ("output", "complaint"),
    [
        ({"output_type": "stream", "name": "stderr", "text": "Warning: old"}, "complains"),
        ({"output_type": "stream", "name": "stdout", "text": "<A at 0x7f00>"}, "an address"),
    ],
)
def test_what_an_output_must_not_have(build, output, complaint):
    cell = nbformat.v4.new_code_cell("x", id="cell-01")
    with pytest.raises(build.BuildError, match=complaint):
        build._settled("1-tiny.py", cell, nbformat.from_dict(output))


def test_the_live_page_is_not_kept_in_a_copy(build):
    frame = {"text/html": "<iframe srcdoc=''></iframe>", "text/plain": "Page"}
    shown = nbformat.v4.new_output("display_data", data=frame)
    kept = build._settled("1-tiny.py", nbformat.v4.new_code_cell("x"), shown)
    assert kept.data["text/html"] == "<em>Run this cell, and the page plays here.</em>"
