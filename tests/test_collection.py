"""Collections: a second system judged and typeset like the first, errors in one line, a start."""

from __future__ import annotations

import json
import pickle
import re
import shutil
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest
from sympy import Symbol

import rigidtop.errors
from rigidtop.cli import main
from rigidtop.collection import built_in, load
from rigidtop.commands import new
from rigidtop.commands.mark import subject_of
from rigidtop.derivations.letters import LETTERS
from rigidtop.errors import RigidtopError
from rigidtop.judge.text import judged
from rigidtop.mark.numbered import Numbers, copies
from rigidtop.proof.verdict import judge
from rigidtop.theory import symbols
from rigidtop.theory.lettered import Lettered, in_order, real
from rigidtop.theory.symbols import Glyph
from rigidtop.typeset.text import text

PENDULUM = Path(__file__).parent / "collections" / "spherical_pendulum"
STARTER = new.STARTER

VERDICTS = {
    "1.1": "proved",
    "1.2": "proved",
    "1.3": "assuming",
    "1.4": "proved",
    "p-phi-is-Lz": "proved",
    "1.5": "proved",
    "2.1": "proved",
    "2.2": "assuming",
    "least-rate": "proved",
    "2.3": "proved",
    "nods-twice": "false",
    "3.1": "proved",
    "3.2": "proved",
    "taut": "assuming",
    "speed": "proved",
}
"""What physics expects."""


def every_claim(collection):
    """Claims of pages and of exercises, each once."""
    both = (*collection.pages, *collection.exercises)
    return {claim.name: claim for each in both for claim in each.claims}


@pytest.fixture(scope="module")
def judgements():
    claims = {f"pendulum {n}": c for n, c in every_claim(load(PENDULUM)).items()}
    claims |= {f"starter {n}": c for n, c in every_claim(load(STARTER)).items()}
    return {name: judge(claim, letters=LETTERS) for name, claim in claims.items()}


# --- What the second collection says --------------------------------------------------------------


def test_verdicts(judgements):
    found = {
        name.partition(" ")[2]: judged.verdict.value
        for name, judged in judgements.items()
        if name.startswith("pendulum")
    }
    assert found == VERDICTS
    assert [name for name, judged in judgements.items() if not judged.passed] == []


def test_numbers_refute_what_textbooks_say(judgements):
    [finding] = judgements["pendulum nods-twice"].findings()
    theta, omega = (
        next(v for x, v in finding.counterexample.values.items() if x.name == name)
        for name in ("theta", "omega")
    )
    from sympy import cos

    assert finding.counterexample.left == omega**2 * (1 + 3 * cos(theta) ** 2)
    assert finding.counterexample.right == 4 * omega**2
    assert finding.counterexample.left != finding.counterexample.right


NAMES = [*(f"pendulum {name}" for name in VERDICTS), "starter 1.1", "starter from-energy"]


def test_changes_make_claims_fall(judgements, fallen):
    found = {name: fallen(judgements[name]) for name in NAMES}
    assert [name for name, (fell, stood) in found.items() if fell < len(stood)] == []
    assert sum(fell for fell, _ in found.values()) > 130


@pytest.mark.parametrize(
    ("file", "old", "new", "broken"),
    [
        ("equations.py", "- g * sin(theta)", "+ g * sin(theta)", {"1.2"}),
        ("engine.py", "WEIGHT = Matrix([0, 0, -m * g])", "WEIGHT = Matrix([0, 0, m * g])", None),
        ("conical.py", "yield Correction(right, meaning)", "", {"nods-twice"}),
        ("evidence.py", "(1 + 3 * cos(TILT) ** 2)", "4", {"2.3"}),
        ("evidence.py", "v @ v - gravity", "v @ v - 0.9 * gravity", {"1.5", "2.2", "2.3"}),
    ],
)
def test_a_slip_in_a_page_is_found(tmp_path, capsys, file, old, new, broken):
    folder = shutil.copytree(PENDULUM, tmp_path / "course", ignore=lambda *_: ["__pycache__"])
    words = (folder / file).read_text("utf-8")
    assert old in words
    (folder / file).write_text(words.replace(old, new), encoding="utf-8")
    assert main(["check", f"{folder}/", "--json"]) == 1
    failed = {r["name"] for r in json.loads(capsys.readouterr().out) if not r["passed"]}
    assert failed == broken if broken else len(failed) > 3


# --- The commands ---------------------------------------------------------------------------------


MODEL = """
from rigidtop.proof.model import Model
from rigidtop.theory.lagrangian import accelerations

from . import letters as x
from .pendulum import lagrangian

T = x.m * x.length**2 * x.thetadot**2 / 2
[acceleration] = accelerations(lagrangian(), [x.theta], [x.thetadot])
MEANING = {x.Lagrangian: lagrangian(), x.T: T, x.V: T - lagrangian(), x.E: 2 * T - lagrangian()}
RATES = {x.theta: x.thetadot, x.thetadot: acceleration}
MODELS = (
    Model("", {**MEANING, x.thetaddot: x.thetaddot}, {**RATES, x.thetadot: x.thetaddot}),
    Model("", {**MEANING, x.thetaddot: acceleration}, RATES, along=True),
)
"""


def test_lines_are_held_against_the_models_of_a_collection(tmp_path, capsys):
    folder = shutil.copytree(STARTER, tmp_path / "course", ignore=lambda *_: ["__pycache__"])
    start = (folder / "__init__.py").read_text("utf-8")
    (folder / "__init__.py").write_text(start + MODEL, "utf-8")
    assert main(["check", f"{folder}/"]) == 0
    said = capsys.readouterr().out
    assert "5 laws, of which the models bear out 5" in said
    assert "false in the models" not in said
    # Of another length: Python takes a file of the same length and second for the one it compiled.
    wrong = MODEL.replace("x.V: T - lagrangian()", "x.V: -T + lagrangian()")
    (folder / "__init__.py").write_text(start + wrong, "utf-8")
    assert main(["check", f"{folder}/"]) == 1
    assert "this law is false in the models" in capsys.readouterr().out
    (folder / "__init__.py").write_text(start + "MODELS = ('theta',)\n", "utf-8")
    assert main(["check", f"{folder}/"]) == 2
    assert "MODELS[0] is" in capsys.readouterr().err


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    out = tmp_path_factory.mktemp("lecture")
    assert main(["lecture", f"{PENDULUM}/", "-o", str(out)]) == 0
    assert main(["exercise", f"{PENDULUM}/", "--sheet", str(out)]) == 0
    return out


@pytest.mark.parametrize("file", ["lecture.html", "lecture.tex", "exercises.html", "exercises.tex"])
def test_nothing_of_the_top_is_in_it(written, file):
    source = (written / file).read_text("utf-8")
    if file.endswith("html"):
        root = ElementTree.fromstring(source.removeprefix("<!DOCTYPE html>\n"))
        style = "".join("".join(e.itertext()) for e in root.iter("style"))
        source = "".join(root.itertext()).replace(style, "")
    for foreign in (r"\bspinning", r"(?<!\\)\btops?\b", "λ|lambda", "Euler angle", "Wüster", "PHY"):
        assert not re.search(foreign, source), foreign
    assert "spherical pendulum" in source


def test_the_lecture_on_the_top_is_as_it_was(tmp_path, capsys):
    whole = built_in()
    assert len(every_claim(whole)) > 57
    assert whole.folder is None
    assert whole.command("list") == "rigidtop list"
    assert load(PENDULUM).command("list") == f"rigidtop list {PENDULUM}/"


NOTES = r"""
$$\mathcal{L} = \frac12 m l^2(\dot\theta^2 + \dot\phi^2\sin^2\theta) + m g l\cos\theta \tag{1.1}$$
$$l\ddot\theta = l\dot\phi^2\sin\theta\cos\theta + g\sin\theta \tag{1.2}$$
$$l\omega^2\cos\theta = g \tag{2.2}$$
$$\Omega^2 = \omega^2(1 + 3\cos^2\theta) \tag{2.3}$$
$$S = m g\cos\theta + \frac{m v^2}{l} \tag{3.1}$$
"""


def test_notes_are_audited_in_the_letters_of_the_collection():
    collection = load(PENDULUM)
    numbers = Numbers(collection.pages, subject_of(collection), collection.letters)
    found = copies(judged(NOTES), NOTES, numbers)
    assert {each.number: each.verdict for each in found} == {
        "1.1": "proved",
        "1.2": "false",  # the sign of the weight
        "2.2": "assuming",
        "2.3": "proved",
        "3.1": "proved",
    }


@pytest.fixture
def own(tmp_path):
    """A collection whose eight claims are shown by the lines of its page, with models."""
    folder = shutil.copytree(STARTER, tmp_path / "own", ignore=lambda *_: ["__pycache__"])
    page = folder / "pendulum.md"
    pieces = page.read_text("utf-8").replace(r" \tag{1.1}", "").split("$$")
    for n in range(1, 9):  # five laws come first
        pieces[2 * n + 9] += rf" \tag{{1.{n}}}"
    page.write_text("$$".join(pieces), "utf-8")
    claims = """
from rigidtop.proof.page import Claim, Page
PAGES = (
    Page("1", "x", "y", tuple(Claim(f"1.{n}", "so") for n in range(1, 9)), text="pendulum"),
)
EXERCISES = ()
"""
    init = folder / "__init__.py"
    init.write_text(init.read_text("utf-8") + MODEL + claims, "utf-8")
    return folder


def verdicts(capsys, *command):
    assert main(["audit", *map(str, command), "--json"]) < 2
    return {x["name"]: x["verdict"] for x in json.loads(capsys.readouterr().out) if x["name"]}


def test_a_page_is_audited_by_the_lines_of_its_own_collection(own, capsys):
    page = own / "pendulum.md"
    assert verdicts(capsys, f"{own}/", page) == {f"1.{n}": "proved" for n in range(1, 9)}
    notes = own.parent / "notes.md"
    other = r"l\ddot\theta + g\sin\theta = 0"
    forms = {
        r"ml^2\ddot\theta = -mgl\sin\theta": r"ml^2\ddot\theta = -mgl\cos\theta",  # (1.5)
        r"\ddot\theta = -\frac gl\sin\theta \tag": other + r" \tag",  # (1.6), in another form
        r"\dot E = ml^2": r"2\dot E = ml^2",  # (1.8)
    }
    changed = page.read_text("utf-8")
    for right, written in forms.items():
        assert right in changed
        changed = changed.replace(right, written)
    notes.write_text(changed, "utf-8")
    assert main(["audit", f"{own}/", str(notes)]) == 1
    assert "right m l² θ̈ = −m g l sin θ" in " ".join(capsys.readouterr().out.split())
    found = verdicts(capsys, own, notes)
    assert {x for x, verdict in found.items() if verdict == "false"} == {"1.5", "1.8"}
    assert found["1.6"] == "sampled"


def test_an_answer_is_marked_by_a_collection_of_ones_own(own, capsys):
    ends = ["--from", "1.1", "--to", "1.5"]
    answer = own.parent / "answer.md"
    answer.write_text("$$m l^2\\ddot\\theta + mgl\\sin\\theta = 0$$\n", "utf-8")
    assert main(["mark", f"{own}/", str(answer), *ends]) == 0
    assert "and the derivation arrives at (1.5)" in capsys.readouterr().out
    answer.write_text("$$m l^2\\ddot\\theta - mgl\\sin\\theta = 0$$\n", "utf-8")
    assert main(["mark", f"{own}/", str(answer), *ends]) == 1
    assert "line 1 does not follow: 0 of 1 lines" in capsys.readouterr().out
    assert main(["new", "--page", str(own.parent / "markdown")]) == 0
    for words, said in (
        ([own], "is a collection, no answer: the answer stands behind it"),
        ([own.parent / "markdown"], "is a collection, no answer: the answer stands behind it"),
        ([STARTER, answer], "no line of the lecture is called '1.5'"),
        ([answer, answer, answer], "one answer at a time: 3 names are too many"),
    ):
        assert main(["mark", *map(str, words), *ends]) == 2
        assert said in capsys.readouterr().err
    assert main(["mark", str(own), str(answer), "--exercise", "period"]) == 2
    assert "no exercise is called 'period'" in capsys.readouterr().err
    assert main(["mark", str(STARTER), str(answer), "--exercise", "period"]) == 2
    assert "but its numbers are, a line each: period = … s" in capsys.readouterr().err
    answer.write_text("period = 2.153 s\nlonger = 0.0732\n", "utf-8")
    assert main(["mark", str(STARTER), str(answer), "--exercise", "period"]) == 0


def test_without_models_an_answer_is_marked_by_what_the_pages_start_from(tmp_path, capsys):
    answer, ends = tmp_path / "answer.md", ["--from", "1.1", "--to", "from-energy"]
    answer.write_text("$$\\ddot\\theta + \\frac gl\\sin\\theta = 0$$\n", "utf-8")
    assert main(["mark", str(STARTER), str(answer), *ends]) == 0
    answer.write_text("$$\\ddot\\theta - \\frac gl\\sin\\theta = 0$$\n", "utf-8")
    assert main(["mark", str(STARTER), str(answer), *ends]) == 1
    assert "another sign before" in capsys.readouterr().out


def test_a_letter_of_the_lecture_is_known_where_it_is_used(tmp_path):
    init = PAGE + "from rigidtop.theory.symbols import lambda1\nPAGES = (page,)"
    glyphs = load(course(tmp_path, init)).notation.glyphs
    assert symbols.lambda1 in glyphs
    assert symbols.lambda2 not in glyphs
    assert symbols.lambda2 in built_in().notation.glyphs


# --- What is wrong is one line --------------------------------------------------------------------

PAGE = """\
from rigidtop.proof.equation import Equation
from rigidtop.proof.page import Assumption, Check, Measure, Page, claim
from sympy import Integer, Ne

@claim("1.1", "one is one")
def one():
    yield Check(Equation(Integer(1), Integer(1)))

page = Page("1", "Numbers", "About numbers.", (one,))
"""


def course(tmp_path, init, **files):
    folder = tmp_path / "course"
    folder.mkdir()
    for name, content in {"__init__": init, **files}.items():
        (folder / f"{name}.py").write_text(content, encoding="utf-8")
    return folder


WRONG = {
    "syntax": ("PAGES = (", r"__init__\.py, line 1: SyntaxError: '\(' was never closed"),
    "no pages": ("x = 1", r"__init__\.py: has no PAGES, the tuple of its pages, and no page"),
    "none": ("PAGES = ()", "has no PAGES"),
    "name": (PAGE + "PAGES = (pgae,)", r"__init__\.py, line 10: NameError: name 'pgae'"),
    "no comma": (PAGE + "PAGES = (page)", r"PAGES is a Page, not a tuple: \(x,\) has a comma"),
    "a claim": (PAGE + "PAGES = (one,)", r"PAGES\[0\] is a Claim, not a Page"),
    "text": ("PAGES = 'page'", "PAGES is a str, not a tuple"),
    "exercises": (
        PAGE + "PAGES = (page,)\nEXERCISES = (one,)",
        r"EXERCISES\[0\] is a Claim, not an Exercise",
    ),
    "title": (PAGE + "PAGES = (page,)\nTITLE = 3", "TITLE is an int, not text"),
    "about": (
        PAGE + "PAGES = (Page('2', 'x', None, ()),)",
        r"the about of PAGES\[0\] is None, not text",
    ),
    "claims": (
        PAGE + "PAGES = (Page('2', 'x', 'y', one),)",
        r"PAGES\[0\].claims is a Claim, not a tuple",
    ),
    "no decorator": (
        PAGE + "PAGES = (Page('2', 'x', 'y', (one.evidence,)),)",
        r"PAGES\[0\].claims\[0\] is a function, not a Claim; is @claim\(name, says\) missing\?",
    ),
    "two claims": (
        PAGE + "other = claim('1.1', 'z')(one.evidence)\n"
        "PAGES = (page, Page('2', 'x', 'y', (other,)))",
        "two claims have the name '1.1'",
    ),
    "two sections": (PAGE + "PAGES = (page, page)", "two sections have the name '1'"),
    "a section": (
        PAGE + "PAGES = (Page('1.1', 'x', 'y', (one,)),)",
        "a section and a claim have the name '1.1'",
    ),
    "bad name": (
        PAGE + "PAGES = (Page('1', 'x', 'y', (claim('../a', 'z')(one.evidence),)),)",
        r"the claim '\.\./a' needs a name of letters, digits, \. and -",
    ),
    "exit": ("import sys\nsys.exit(0)", r"__init__\.py, line 2: SystemExit: 0"),
    "lines": ("raise ValueError('a\\nb')", r"__init__\.py, line 1: ValueError: a b"),
    "no such": (
        "from .pages import page",
        r"__init__\.py, line 1: ModuleNotFoundError: No module named 'course\.pages'",
    ),
    "no dot": (
        "from other import page",
        r"No module named 'other'; a file of the folder is imported with a dot: from \.other",
    ),
}


@pytest.mark.parametrize("what", WRONG)
def test_errors_are_one_line(tmp_path, capsys, what):
    init, message = WRONG[what]
    folder = course(tmp_path, init, other=PAGE)
    for command in ("check", "list", "lecture", "exercise"):
        assert main([command, f"{folder}/"]) == 2
        out, err = capsys.readouterr()
        assert out == ""
        assert err.count("\n") == 1
        assert err.startswith(f"rigidtop {command}: {folder}")
        assert re.search(message, err)
        assert "_rigidtop_collection" not in err


BREAKS = {
    "raises": ("1 / 0\n    yield", "line 12: ZeroDivisionError: division by zero"),
    "nothing": ("return None", "line 10: TypeError: broken yields nothing"),
    "text": (
        "yield 'proved'",
        "line 12: TypeError: a str is no Step, Check, Definition or Measure",
    ),
    "number": (
        "yield Measure('x', 'small', 1)",
        "line 12: ValueError: could not convert string to float",
    ),
    "comma": (
        "yield Check(Equation(Integer(1), 1), assuming=(Assumption(None)))",
        "line 12: TypeError: assuming is an Assumption, not a tuple",
    ),
    "always": (
        "yield Check(Equation(Integer(1), 1), assuming=(Assumption(Ne(Integer(1), 0)),))",
        "line 12: TypeError: the assumption is True: it says nothing",
    ),
}


@pytest.mark.parametrize("what", BREAKS)
def test_a_claim_that_breaks_is_undecided(tmp_path, capsys, what):
    body, message = BREAKS[what]
    broken = f"@claim('broken', 'x')\ndef broken():\n    {body}\n"
    init = PAGE + broken + "PAGES = (Page('1', 'x', 'y', (one, broken)),)\n"
    folder = course(tmp_path, init)
    assert main(["check", f"{folder}/", "--json"]) == 1
    first, record = json.loads(capsys.readouterr().out)
    assert first["verdict"] == "proved"
    assert record["verdict"] == "undecided"
    assert record["note"].startswith(f"PageError: {folder}")
    assert message in record["note"]
    assert main(["lecture", f"{folder}/", "-o", str(tmp_path / "out")]) == 1
    assert main(["derive", f"{folder}/", "broken"]) == 1
    assert "Traceback" not in capsys.readouterr().err


def test_what_cannot_be_typeset_is_one_line(tmp_path, capsys):
    odd = "def odd():\n    area = Integral(Symbol('x'), Symbol('x'))\n"
    odd = f"@claim('odd', 'x')\n{odd}    yield Check(Equation(area, area))\n"
    init = "from sympy import Integral, Symbol\n" + PAGE + odd
    folder = course(tmp_path, init + "PAGES = (Page('1', 'x', 'y', (odd,)),)\n")
    assert main(["derive", f"{folder}/", "odd"]) == 2
    err = capsys.readouterr().err
    assert err.count("\n") == 1
    assert "TypeError: no layout for Integral" in err


def test_an_exercise_that_breaks_is_one_line(tmp_path, capsys):
    init = PAGE + (
        "from rigidtop.proof.exercise import exercise\n"
        "@exercise('bad', 'Bad', section='1', asks='', statement='?', claims=(), parameters=())\n"
        "def bad():\n    yield 1 / 0\n"
        "PAGES, EXERCISES = (page,), (bad,)\n"
    )
    folder = course(tmp_path, init)
    for words in (["exercise", f"{folder}/", "bad"], ["lecture", f"{folder}/"]):
        assert main([*words]) == 2
        err = capsys.readouterr().err
        assert f"{folder}/__init__.py, line 13: ZeroDivisionError" in err
        assert err.count("\n") == 1


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("check nowhere/", "no folder 'nowhere'"),
        ("lecture nowhere", "no folder 'nowhere'"),
        ("check empty/", "empty is no collection: it has no __init__.py"),
        ("check empty", "no equation or claim 'empty'; the folder of this name has no __init__.py"),
        ("check course/ 1.2", "no equation or claim '1.2'; did you mean 1.1?"),
        ("check course/ zzz", "no equation or claim 'zzz'; `rigidtop list course/` names them all"),
        ("derive course/", "one claim at a time; `rigidtop list course/` names them"),
        ("exercise course/ zzz", "no exercise 'zzz'; `rigidtop exercise course/` lists all"),
        ("check 3.57 course/", "no equation or claim 'course/'"),
    ],
)
def test_what_is_not_there(tmp_path, monkeypatch, capsys, words, message):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "empty").mkdir()
    course(tmp_path, PAGE + "PAGES = (page,)")
    assert main(words.split()) == 2
    err = capsys.readouterr().err
    assert err.count("\n") == 1
    assert message in err


# --- A collection is imported if it is named, and takes nobody's place ----------------------------


@pytest.mark.parametrize("name", ["nutation", "3.57", "3.5", "toppling-top", "time-to-fall"])
def test_a_folder_takes_no_name_of_the_lecture(tmp_path, monkeypatch, capsys, name):
    monkeypatch.chdir(tmp_path)
    course(tmp_path, PAGE + "PAGES = (page,)").rename(tmp_path / name)
    if name == "toppling-top":
        assert main(["exercise", name, "--student"]) == 0
        assert capsys.readouterr().out.startswith("The toppling top")
    else:
        assert main(["list", name, "--json"]) == 0
        assert "1.1" not in {r["name"] for r in json.loads(capsys.readouterr().out)}
    for folder in (f"{name}/", str(tmp_path / name)):
        assert main(["list", folder, "--json"]) == 0
        assert [r["name"] for r in json.loads(capsys.readouterr().out)] == ["1.1"]


def test_a_bare_word_may_name_a_folder(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    course(tmp_path, PAGE + "PAGES = (page,)")
    assert main(["check", "course", "--json"]) == 0
    assert [r["name"] for r in json.loads(capsys.readouterr().out)] == ["1.1"]


def test_only_what_is_named_is_run(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    folder = course(tmp_path, "raise SystemExit('it ran')")
    folder.rename(tmp_path / "sympy")
    assert main(["list", "--json"]) == 0
    assert len(json.loads(capsys.readouterr().out)) == 57
    assert main(["check", "sympy/"]) == 2
    assert "it ran" in capsys.readouterr().err


def test_nothing_is_shadowed(tmp_path, capsys):
    files = dict.fromkeys(("sympy", "numpy", "rigidtop"), "raise ImportError('shadowed')")
    init = PAGE + "from .errors import HERE\nPAGES = (page,)\nTITLE = HERE"
    folder = course(tmp_path, init, **files, errors="HERE = 'my errors'")
    folder = folder.rename(tmp_path / "rigidtop")
    known, path = dict(sys.modules), list(sys.path)
    collection = load(folder)
    assert collection.front.title == "my errors"
    assert sys.path == path
    assert {name: sys.modules.get(name) for name in known} == known
    assert all(name.startswith("_rigidtop_collection_") for name in set(sys.modules) - set(known))
    assert rigidtop.errors.RigidtopError is RigidtopError


def test_what_a_collection_prints_is_no_result(tmp_path, capsys):
    folder = course(tmp_path, PAGE + "print('hello')\nPAGES = (page,)")
    assert main(["check", f"{folder}/", "--json"]) == 0
    out, err = capsys.readouterr()
    assert json.loads(out)[0]["verdict"] == "proved"
    assert err == "hello\n"


# --- A start --------------------------------------------------------------------------------------


def test_what_is_started_passes(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["new", "my_course"]) == 0
    assert "my_course/pendulum.py" in capsys.readouterr().out
    assert main(["check", "my_course/", "--json"]) == 0
    records = json.loads(capsys.readouterr().out)
    assert [(r["name"], r["verdict"]) for r in records] == [
        ("1.1", "proved"),
        ("from-energy", "assuming"),
    ]
    assert main(["lecture", "my_course/", "-o", "out"]) == 0
    assert capsys.readouterr().out.splitlines()[1] == "1 exercise solved; every number confirmed"
    assert "mass of the bob" in (tmp_path / "out" / "lecture.html").read_text("utf-8")
    for theta in ("1deg", "3"):
        assert main(["exercise", "my_course/", "period", "--set", f"theta={theta}"]) == 0


def test_new_refuses_what_is_there(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "full").mkdir()
    (tmp_path / "full" / "mine.txt").write_text("mine")
    (tmp_path / "file").write_text("mine")
    (tmp_path / "empty").mkdir()
    for words, message in (
        ("full", "full is there already, and is not empty"),
        ("file", "file is there already, and is not a folder"),
        ("file/x", "cannot write file/x: Not a directory"),
        ("bad name!", "'bad name!' is no name for a folder that is a Python module: give it"),
        ("3.57", "'3.57' is no name for a folder that is a Python module"),
        ("class", "'class' is no name for a folder that is a Python module"),
    ):
        assert main(["new", words]) == 2
        assert message in capsys.readouterr().err
    assert (tmp_path / "full" / "mine.txt").read_text() == "mine"
    assert sorted(p.name for p in tmp_path.iterdir()) == ["empty", "file", "full"]
    assert main(["new", "empty", "--json"]) == 0
    files = json.loads(capsys.readouterr().out)["files"]
    names = ("__init__.py", "letters.py", "pendulum.md", "pendulum.py")
    assert files == [str(Path("empty", name)) for name in names]
    assert main(["new", "my notes/course"]) == 0
    assert capsys.readouterr().out.endswith("now: rigidtop check 'my notes/course/'\n")
    monkeypatch.chdir(tmp_path / "empty")
    assert main(["new", "."]) == 2


def test_new_is_whole_or_nothing(tmp_path, monkeypatch):
    def full(path, content):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", full)
    with pytest.raises(RigidtopError, match="No space left on device"):
        new.write(tmp_path / "deep" / "course", {"a.py": b""})
    assert list((tmp_path / "deep").iterdir()) == []


# --- Symbols with a letter of their own -----------------------------------------------------------


def test_a_symbol_is_what_it_says_not_what_it_is_called():
    (mine,) = in_order(real("theta", Glyph("ϑ", sub="0"), "mine", "rad"))
    assert text(mine + symbols.theta) in ("ϑ₀ + θ", "θ + ϑ₀")
    assert mine != symbols.theta
    assert mine != Symbol("theta", real=True)
    assert mine != real("theta", Glyph("η"), "another", "rad")
    assert mine == in_order(real("theta", Glyph("ϑ", sub="0"), "mine", "rad"))[0]
    assert pickle.loads(pickle.dumps(mine * 2)) == mine * 2
    assert isinstance(pickle.loads(pickle.dumps(mine)), Lettered)
    assert pickle.loads(pickle.dumps(mine)).quantity == mine.quantity
