"""What an audit finds, told to code hosts, editors and test runners, and told again on saving."""

import asyncio
import csv
import json
import re
import sys
import threading
import time
from pathlib import Path
from xml.etree import ElementTree

import mcp
import pytest

import rigidtop
from rigidtop.cli import main
from rigidtop.collection import built_in
from rigidtop.commands.browser import Desk
from rigidtop.commands.cell import RECORD, answer, audit
from rigidtop.commands.draft import Draft
from rigidtop.commands.watch import saved

BOB = r"""A bob has the Lagrangian

$$L = \tfrac12 m l^2\dot\theta^2 + m g l\cos\theta$$

and so $p = 100\,\%$ and

$$l\ddot\theta = g\sin\theta.$$
"""


@pytest.fixture
def bob(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "my bob, new.md").write_text(BOB, "utf-8")
    return "my bob, new.md"


def told(capsys, file, format):
    assert main(["audit", file, "--format", format]) == 1
    return capsys.readouterr().out


def test_a_workflow_command_for_what_is_wrong(bob, capsys):
    [line] = told(capsys, bob, "github").splitlines()
    assert line == (
        "::error file=my bob%2C new.md,line=7,title=line 7 is wrong::it holds with another sign"
        "%0Awritten: l θ̈ = g sin θ%0Aright: l θ̈ = −g sin θ"
        "%0Aagainst line 3: L = ½ m l² θ̇² + m g l cos θ"
    )


def test_sarif_has_the_place_and_what_it_contradicts(bob, capsys):
    found = json.loads(told(capsys, bob, "sarif"))
    [result] = found["runs"][0]["results"]
    place = result["locations"][0]["physicalLocation"]
    assert found["version"] == "2.1.0"
    assert place == {
        "artifactLocation": {"uri": "my%20bob%2C%20new.md"},
        "region": {"startLine": 7},
    }
    [against] = result["relatedLocations"]
    assert against["physicalLocation"]["region"] == {"startLine": 3}


def test_a_test_case_for_each_formula(bob, capsys):
    [suite] = ElementTree.fromstring(told(capsys, bob, "junit"))
    assert (suite.get("tests"), suite.get("failures"), suite.get("skipped")) == ("3", "1", "2")
    [failed] = [case.get("name") for case in suite if case.find("failure") is not None]
    assert failed == "line 7"


def test_a_cell_says_what_the_command_says(bob, capsys):
    """The same record through ``%%audit``, and the wrong line with its right one in place."""
    assert main(["audit", bob, "--json"]) == 1
    records = json.loads(capsys.readouterr().out)
    magics = {}

    class Shell:
        def register_magic_function(self, function, kind, name):
            magics[kind, name] = function

    rigidtop.load_ipython_extension(Shell())
    assert set(magics) == {("cell", "audit"), ("cell", "answer")}
    shown = magics["cell", "audit"]("", BOB)._repr_mimebundle_()
    assert shown[RECORD] == records
    assert (
        "| 7 | l θ̈ = g sin θ | **false** | it holds with another sign | l θ̈ = −g sin θ |"
        in shown["text/markdown"]
    )
    assert shown["text/plain"].startswith("line 7 is wrong: it holds with another sign\nwritten: ")
    for line, cell, said in (
        ("", "No formulas.", "the cell: no formulas between dollars"),
        ("nothing", BOB, "%%audit, or %%audit FOLDER/"),
        ('"', BOB, "%%audit, or %%audit FOLDER/"),
        ("nowhere/", BOB, "no folder 'nowhere'"),
    ):
        assert magics["cell", "audit"](line, cell) is None
        assert said in capsys.readouterr().out


ANSWER = r"""$$\dot\theta = 0$$

$$\lambda_1\cos\theta\,\Omega^2 + \lambda_3\omega_3\Omega + MgR = 0$$"""


def test_an_answer_is_marked_alike_through_every_door(tmp_path, capsys):
    """By the command, for a class, on a page and in a cell."""
    asked = ["--from", "3.54", "--to", "3.57"]
    (tmp_path / "ann.md").write_text(ANSWER, "utf-8")
    assert main(["mark", str(tmp_path / "ann.md"), *asked, "--json"]) == 1
    record = json.loads(capsys.readouterr().out)
    assert main(["mark", str(tmp_path), *asked, "-o", str(tmp_path / "out")]) == 0
    [row] = csv.DictReader(capsys.readouterr().out.splitlines())
    assert (row["points"], row["of"]) == (str(record["points"]), str(record["of"])) == ("1", "2")
    assert row["summary"] == record["summary"]
    [slip] = record["lines"][1]["slips"]
    assert row["slips"] == slip["words"]
    cell = answer("3.54 3.57", ANSWER).record
    assert {key: cell[key] for key in record} == record
    page = (tmp_path / "out" / "ann.html").read_text("utf-8")
    badges = re.findall(r'<span class="side">.*?</span>([a-z]+)</span>', page)
    assert badges == [line["verdict"] for line in record["lines"]]
    assert record["summary"] in page


SPRING = r"""A mass on a spring has $L = \frac12 m \dot x^2 - \frac12 k x^2$ and $p = = 3$.
% $m \ddot x = 3 k x$
\newcommand{\acc}{\ddot x} It is called
\begin{equation} \omega_0^2 = k / m \end{equation}
and moves by
\[ m \acc = k x . \]
"""
AUTHORS = Path(__file__).parents[1] / "judge" / "authors"


def test_a_file_is_judged_alike_through_every_door(tmp_path, monkeypatch, capsys):
    """The command, its reports, an editor, a cell, the browser's page, an assistant."""
    monkeypatch.chdir(tmp_path)
    texts = {"bob.md": BOB, "spring.tex": SPRING}
    texts["right.tex"] = SPRING.replace("= k x .", "= -k x .")
    texts["goldstein.tex"] = (AUTHORS / "goldstein.tex").read_text("utf-8")

    async def assistant():
        start = mcp.StdioServerParameters(command=sys.executable, args=["-m", "rigidtop", "mcp"])
        async with mcp.Client(start) as client:
            told = [await client.call_tool("audit", {"text": text}) for text in texts.values()]
        return [each.structured_content["findings"] for each in told]

    by_assistant = asyncio.run(assistant())
    for (name, text), assisted in zip(texts.items(), by_assistant, strict=True):
        Path(name).write_text(text, "utf-8")
        code = main(["audit", name, "--json"])
        rows = json.loads(capsys.readouterr().out)
        wrong = [row["line"] for row in rows if row["passed"] is False]
        assert code == bool(wrong) == (name in ("bob.md", "spring.tex"))
        assert assisted == rows
        assert json.loads(Desk().answer(text, [], lambda *_: None))["outcomes"] == rows
        notes = Draft(Path(name)).audit(text, built_in()).notes
        assert [each.record for each in notes.findings] == rows
        assert audit("", text)._repr_mimebundle_()[RECORD] == rows
        shown = {}
        for format in ("github", "sarif", "junit"):
            assert main(["audit", name, "--format", format]) == code
            shown[format] = capsys.readouterr().out
        assert [int(x) for x in re.findall(r",line=(\d+),", shown["github"])] == wrong
        places = [each["locations"] for each in json.loads(shown["sarif"])["runs"][0]["results"]]
        assert [x["physicalLocation"]["region"]["startLine"] for [x] in places] == wrong
        cases = ElementTree.fromstring(shown["junit"]).iter("testcase")
        passed = {(): True, ("failure",): False, ("skipped",): None}
        assert [passed[tuple(x.tag for x in case)] for case in cases] == [
            row["passed"] for row in rows
        ]


def test_several_files_are_told_one_by_one(bob, tmp_path, capsys):
    (tmp_path / "README.md").write_text("No formulas.", "utf-8")
    (tmp_path / "right.md").write_text(BOB.replace("g\\sin\\theta.", "-g\\sin\\theta."), "utf-8")
    names = [bob, "README.md", "right.md"]
    assert main(["audit", *names]) == 1
    shown = capsys.readouterr().out
    assert shown.startswith(f"{bob}\n\nline 7 is wrong")
    assert "\n\nright.md\n\nline " in shown
    assert main(["audit", *names, "--format", "sarif"]) == 1
    assert len(json.loads(capsys.readouterr().out)["runs"][0]["results"]) == 1
    assert main(["audit", *names, "--json"]) == 2
    assert "one file at a time with --json: 3 names are too many" in capsys.readouterr().err
    assert main(["audit", "README.md"]) == 2


def test_a_commit_without_formulas_passes(bob, tmp_path, capsys):
    """The hook and the reports are there for whatever files a commit happens to have."""
    (tmp_path / "README.md").write_text("No formulas.", "utf-8")
    [hook] = (Path(__file__).parents[2] / ".pre-commit-hooks.yaml").read_text().split("entry: ")[1:]
    command, *words = hook.splitlines()[0].split()
    assert command == "rigidtop"
    assert main([*words, "README.md"]) == 0
    assert main([*words, "README.md", bob]) == 1
    assert main([*words, "nowhere.md"]) == 2
    capsys.readouterr()
    for format, said in (("github", ""), ("sarif", '"results": []'), ("junit", "<testsuites />")):
        assert main(["audit", "README.md", "--format", format]) == 0
        assert said in capsys.readouterr().out


def test_each_change_is_seen_once(bob, tmp_path):
    path, seen = tmp_path / bob, []

    def watch():
        for _ in zip(range(2), saved(path, pause=0.01), strict=False):
            seen.append(path.read_text("utf-8"))

    watching = threading.Thread(target=watch)
    watching.start()
    while not seen:
        time.sleep(0.01)
    path.with_suffix(".new").write_text("$a = b$", "utf-8")
    path.with_suffix(".new").replace(path)
    watching.join(10)
    assert seen == [BOB, "$a = b$"]


def test_what_is_not_there_is_not_watched(capsys):
    assert main(["watch", "nothing.md"]) == 2
    assert "rigidtop watch: " in capsys.readouterr().err
