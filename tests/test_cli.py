"""The command line as a user meets it: output, exit codes, and one line for bad input."""

from __future__ import annotations

import csv
import json
import math
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from rigidtop.cli import main
from rigidtop.derivations import PAGES


def test_list_names_every_claim_once(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["list", "--json"]) == 0
    records = json.loads(capsys.readouterr().out)
    names = [record["name"] for record in records]
    assert names == [claim.name for page in PAGES for claim in page.claims]
    assert {record["reference"] for record in records} >= {"3.2", "3.3", "3.4", "3.5.4"}


def test_check_json_is_the_contract(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", "3.45", "--json"]) == 0
    [record] = json.loads(capsys.readouterr().out)
    assert record["name"] == "3.45"
    assert record["reference"] == "3.3"
    assert record["verdict"] == "assuming"
    assert record["assumptions"] == [
        "λ₂ = λ₁ (a symmetric top) [stated]",
        "sin θ ≠ 0 (the top is not upright and does not hang)",
    ]
    assert record["note"].startswith("holds if sin θ ≠ 0")
    assert 0 < record["seconds"] < 60


def test_conditions_of_lines_stay_beside_evidence_in_python(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["check", "two-roots", "--json"]) == 0
    [record] = json.loads(capsys.readouterr().out)
    assert record["assumptions"]
    assert record["lines_hold_if"] == ["sin θ ≠ 0", "D ≥ 0", "1 − 4ε ≥ 0"]


def test_a_failed_check_exits_with_1(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    from sympy import cos, sin

    from rigidtop import derivations
    from rigidtop.proof.equation import Equation
    from rigidtop.proof.page import Check, Page, claim
    from rigidtop.theory.symbols import theta

    @claim("broken", "sin θ = cos θ")
    def broken():  # type: ignore[no-untyped-def]
        yield Check(Equation(sin(theta), cos(theta)))

    monkeypatch.setattr(derivations, "PAGES", (Page("9", "Broken", "A false claim.", (broken,)),))
    assert main(["check", "broken"]) == 1
    out = capsys.readouterr().out
    note = (
        "it fails, and no corrected form stands beside it; "
        "at θ = ⅓π: the left side is ½√3, the right side ½"
    )
    assert note in " ".join(out.split())
    assert main(["check", "broken", "--json"]) == 1
    [record] = json.loads(capsys.readouterr().out)
    assert record["note"] == note
    assert out.endswith("1 claim: 1 false; NOT PASSED: broken\n")


def test_derive_as_source_in_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["derive", "(3.45)", "--format", "python", "--json"]) == 0
    record = json.loads(capsys.readouterr().out)
    source = record.pop("source")
    assert record == {
        "name": "3.45",
        "language": "python",
        "arguments": ["theta", "L_z", "L3", "lambda1"],
        "returns": ["phidot"],
    }
    names: dict[str, Any] = {}
    exec(source, names)
    assert names["equation_3_45"](math.pi / 2, 3.0, 7.0, 2.0)[0] == pytest.approx(1.5, rel=1e-15)


def test_simulate_prints_the_drift(capsys: pytest.CaptureFixture[str]) -> None:
    arguments = "simulate top --theta 30deg --omega3 40 --time 1 --samples 3 --json"
    assert main(arguments.split()) == 0
    out = json.loads(capsys.readouterr().out)
    assert out["columns"]["theta/rad"][0] == pytest.approx(0.5235987755982988, abs=1e-15)
    assert set(out["drift"]) == {"energy", "p_phi", "p_psi"}
    assert max(out["drift"].values()) < 1e-10


def test_simulate_steady_keeps_theta(capsys: pytest.CaptureFixture[str]) -> None:
    for root in ("slow", "fast"):
        arguments = f"simulate top --theta 0.5 --omega3 12 --steady {root} --time 5 --json"
        assert main(arguments.split()) == 0
        theta = json.loads(capsys.readouterr().out)["columns"]["theta/rad"]
        assert max(abs(value - 0.5) for value in theta) < 1e-9


def test_simulate_by_integration_agrees_with_the_closed_form(
    capsys: pytest.CaptureFixture[str],
) -> None:
    columns = []
    for method in ("exact", "DOP853"):
        assert main(f"simulate top --time 3 --method {method} --json".split()) == 0
        columns.append(json.loads(capsys.readouterr().out)["columns"])
    for name, values in columns[0].items():
        assert columns[1][name] == pytest.approx(values, rel=1e-7, abs=1e-7), name


def test_simulate_writes_csv(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "flip.csv"
    arguments = f"simulate free --moments 1 2 3 --omega 0.01 2 0.01 --samples 4 -o {file}"
    assert main(arguments.split()) == 0
    assert str(file) in capsys.readouterr().out
    rows = list(csv.DictReader(file.read_text(encoding="utf-8").splitlines()))
    assert [float(row["t/s"]) for row in rows] == pytest.approx([0, 10 / 3, 20 / 3, 10])
    assert float(rows[0]["omega2/(rad/s)"]) == pytest.approx(2.0, rel=1e-15)
    assert [path.name for path in tmp_path.iterdir()] == ["flip.csv"]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("derive 3.58", "rigidtop derive: no equation or claim '3.58'; did you mean 3.5"),
        (
            "check zzz",
            "no equation or claim 'zzz'; `rigidtop list` names those of the lecture, "
            "`rigidtop exercise NAME` an exercise's",
        ),
        ("derive polhodes", "'polhodes'; did you mean `rigidtop figure polhodes`?"),
        ("check toppling-top", "'toppling-top'; did you mean `rigidtop exercise toppling-top`?"),
        ("check time-to-fal", "no equation or claim 'time-to-fal'; did you mean time-to-fall"),
        ("check 3.5.9", "no section '3.5.9'; there are 3.2 (opening), 3.2, 3.2.1, 3.2.2,"),
        ("list 9", "no section '9'; there are 3.2 (opening), 3.2, 3.2.1, 3.2.2, 3.2.3, 3.3,"),
        ("derive 3.5", "3.5 is a section; derive one of its claims: 3.48 3.49 potential 3.50"),
        ("simulate top --lambda1 0.1", "lambda1 = 0.1 is too small"),
        ("simulate top --lambda3 -1", "lambda3"),
        ("simulate top --mass 0", "M"),
        ("simulate top --gravity nan", "must be a number, such as 0.5, not 'nan'"),
        ("simulate top --theta inf", "must be a number in rad, such as 0.5 or 30deg, not 'inf'"),
        ("simulate top --theta 30degrees", "argument --theta: must be a number in rad, such as "),
        ("simulate top --theta 30rpm", "such as 0.5 or 30deg, not '30rpm'"),
        ("simulate top --omega3 40deg/s", "must be a number in rad/s, such as 0.5, 30deg or 600"),
        ("simulate top --M 30deg", "argument --mass/--M: must be a number, such as 0.5, not"),
        ("mark x --from 3.53 --to 3.57 --seconds nan", "--seconds: must be a number, such as 0.5"),
        (
            "simulate top --theta 200deg",
            "theta must be at most 3.14159 rad (180°), not 3.49066 rad (200°)",
        ),
        ("simulate sliding --theta 200deg", "not 3.49066 rad (200°)"),
        ("simulate top --mass 1 extra", "rigidtop simulate: unrecognized arguments: extra (see"),
        ("simulate top --omega3 1 --steady slow", "|omega3| must be at least 8.29"),
        ("simulate top --steady slow --phi-dot 1", "--steady sets the rates"),
        ("simulate top --omega3 1 --psi-dot 2", "--psi-dot: not allowed with argument --omega3"),
        ("simulate top --moments 1 2 3", "--moments does not go with `simulate top`"),
        ("simulate free --theta 1", "--theta does not go with `simulate free`"),
        ("simulate free --moments 1 2 3", "a free body needs --moments λ₁ λ₂ λ₃ and --omega"),
        ("simulate free --moments 1 1 3 --omega 1 0 0", "3"),
        ("simulate top --samples 1", "'1' is not a whole number from 2"),
        ("simulate top --method Euler", "DOP853"),
        ("simulate top -o /dev/null/x.csv", "cannot write /dev/null/x.csv"),
        ("simulate top -o /dev/null", "is not an ordinary file"),
        ("simulate top --rtol 1e-9", "--rtol is for integration: give a --method too"),
        ("simulate top --time 0", "--time 0 leaves nothing to compute"),
        ("simulate top --theta 0 --steady slow", "--steady wants a tilt"),
        ("derive 3.35 --format c", "derive: 3.35 has no expression to evaluate; it holds between"),
        ("derive 3.54 --format cobol", "invalid choice: 'cobol'"),
        ("derive 3.5.4", "is a section; derive one of its claims: nutation azimuth friction"),
        ("lecture -o /dev/null/x", "cannot write into /dev/null/x: /dev/null is not a folder"),
    ],
)
def test_bad_input_is_one_line(
    arguments: str, message: str, capsys: pytest.CaptureFixture[str]
) -> None:
    try:
        code = main(arguments.split())
    except SystemExit as stop:
        code = stop.code
    captured = capsys.readouterr()
    assert code == 2
    assert captured.out == ""
    assert captured.err.count("\n") == 1
    assert message in captured.err


def test_letters_of_the_notes_are_options_too(capsys: pytest.CaptureFixture[str]) -> None:
    tables = []
    for flags in ("--mass 2 --arm 0.4 --gravity 1.6", "--M 2 --R 0.4 --g 1.6"):
        assert main(f"simulate top --time 1 --samples 3 {flags}".split()) == 0
        tables.append(capsys.readouterr().out)
    assert tables[0] == tables[1]
    assert main(["simulate", "top", "--time", "1", "--samples", "3"]) == 0
    assert capsys.readouterr().out != tables[0]


def test_help_loads_nothing_heavy() -> None:
    code = (
        "import sys, rigidtop.cli\n"
        "try: rigidtop.cli.main(['--help'])\n"
        "except SystemExit: pass\n"
        "heavy = {'numpy', 'scipy', 'sympy', 'matplotlib'} & set(sys.modules)\n"
        "assert not heavy, heavy"
    )
    result = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False, timeout=120
    )
    assert result.returncode == 0, result.stderr
    for command in ("list", "check", "derive", "lecture", "simulate", "certify", "sweep"):
        assert f"\n    {command} " in result.stdout


def test_a_reader_that_leaves_is_no_error() -> None:
    shell = f"{sys.executable} -m rigidtop simulate top --time 1 --samples 9999 | head -n 1"
    result = subprocess.run(
        shell, shell=True, capture_output=True, text=True, check=False, timeout=120
    )
    assert result.stdout.split()[:2] == ["t/s", "theta/rad"]
    assert result.stderr == ""


def test_a_link_keeps_its_place(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target, link = tmp_path / "target.csv", tmp_path / "link.csv"
    target.write_text("old")
    link.symlink_to(target)
    assert main(f"simulate top --time 0.1 --samples 3 -o {link}".split()) == 0
    assert link.is_symlink()
    assert target.read_text().startswith("t/s,theta/rad,")


@pytest.mark.parametrize(
    ("section", "pages"),
    [
        ("3.5", ["3.5.1", "3.5.2", "3.5.3", "3.5.4"]),
        ("3.2", ["3.2 (opening)", "3.2", "3.2.1", "3.2.2", "3.2.3"]),
        ("3.3", ["3.3"]),
        ("3.53", ["3.5.3"]),  # an equation
    ],
)
def test_a_section_has_its_subsections(
    section: str, pages: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["list", "--json"]) == 0
    every = json.loads(capsys.readouterr().out)
    assert main(["list", section, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert list(dict.fromkeys(record["reference"] for record in found)) == pages
    if section == "3.53":
        assert [record["name"] for record in found] == ["3.53"]
    else:
        assert found == [record for record in every if record["reference"] in pages]


def test_rows_too_far_apart_are_said_to_be(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["simulate", "top", "--omega3", "40", "--time", "20"]) == 0
    assert capsys.readouterr().err == (
        "a row every 1 s, but the nutation takes 0.32 s: for a plot use --samples 1247\n"
    )
    assert main(["simulate", "top", "--omega3", "40", "--time", "1", "--samples", "81"]) == 0
    assert capsys.readouterr().err == ""


def test_interrupt_is_one_line() -> None:
    code = (
        "from rigidtop.cli import main\n"
        "from rigidtop.commands import listing\n"
        "def stop(options): raise KeyboardInterrupt\n"
        "listing.run = stop\n"
        "raise SystemExit(main(['list']))"
    )
    result = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False, timeout=120
    )
    assert result.returncode == 130
    assert result.stderr == "rigidtop list: interrupted\n"


def test_interrupt_while_modules_load_is_one_line() -> None:
    code = (
        "import sys\n"
        "known = {*sys.modules}\n"
        "from rigidtop.cli import main\n"
        "loaded = {m.partition('.')[0] for m in {*sys.modules} - known} - {'__future__'}\n"
        "assert loaded == {'rigidtop'}, loaded\n"
        "assert 'rigidtop.commands' not in sys.modules\n"
        "class Stop:\n"
        "    def find_spec(self, name, *_): raise KeyboardInterrupt\n"
        "sys.meta_path.insert(0, Stop())\n"
        "raise SystemExit(main(['list']))"
    )
    result = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=False, timeout=120
    )
    assert (result.returncode, result.stderr) == (130, "rigidtop: interrupted\n")


def test_a_full_disk_is_one_line() -> None:
    if not Path("/dev/full").is_char_device():
        pytest.skip("there is no /dev/full")
    result = subprocess.run(
        f"{sys.executable} -m rigidtop simulate top > /dev/full",
        shell=True,
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    assert result.returncode == 2
    assert result.stderr == "rigidtop simulate: No space left on device\n"
