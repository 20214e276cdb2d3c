"""``rigidtop web``."""

import json
import math

import pytest

from rigidtop.cli import main


def first(path):
    text = path.read_text("utf-8")
    data = text.split('<script type="application/json" id="data">')[1].split("</script>")[0]
    return json.loads(data)["first"]


@pytest.mark.parametrize("kind", ["heavy-top", "free"])
def test_a_page_is_one_file(kind, tmp_path, capsys):
    path = tmp_path / "page.html"
    assert main(["web", kind, "-o", str(path)]) == 0
    assert capsys.readouterr().out.startswith(f"{path}\nThe ")
    assert [p.name for p in tmp_path.iterdir()] == ["page.html"]
    assert path.stat().st_size < 1_500_000


def test_a_preset_with_other_numbers_comes_first(tmp_path, capsys):
    path = tmp_path / "loops.html"
    asked = ("--preset", "loops", "--set", "theta=45deg", "omega3=60rpm")
    assert main(["web", "--json", "-o", str(path), *asked, "heavy-top"]) == 0
    record = json.loads(capsys.readouterr().out)
    assert record["values"]["theta"] == pytest.approx(math.pi / 4)
    assert record["values"]["omega3"] == pytest.approx(2 * math.pi)
    assert record["bytes"] == path.stat().st_size
    assert [p["name"] for p in record["presets"]][:3] == ["loops", "slow", "fast"]
    shown = first(path)
    assert shown["name"] == record["preset"] == "own"
    assert shown["title"] == "An example, changed"
    assert shown["setup"]["values"]["theta"] == pytest.approx(math.pi / 4)
    assert shown["about"] == (
        "As “Loops”, but with theta = 0.7854, omega3 = 6.283 (SI units and radians)."
    )


def test_a_preset_with_its_own_numbers_is_the_preset(tmp_path, capsys):
    path = tmp_path / "same.html"
    assert main(["web", "heavy-top", "--set", "theta=30deg", "-o", str(path), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["preset"] == first(path)["name"] == "loops"


def test_the_second_moment_follows_the_first(tmp_path, capsys):
    path = tmp_path / "page.html"
    assert main(["web", "heavy-top", "--set", "lambda1=2", "-o", str(path)]) == 0
    values = first(path)["setup"]["values"]
    assert (values["lambda1"], values["lambda2"]) == (2, 2)
    assert main(["web", "heavy-top", "--set", "lambda2=1.2", "-o", str(path)]) == 0
    values = first(path)["setup"]["values"]
    assert (values["lambda1"], values["lambda2"]) == (1.3, 1.2)


@pytest.mark.parametrize(
    ("asked", "says"),
    [
        (("free", "--preset", "loops"), "no preset 'loops': there are free-precession, plate,"),
        (("free", "--set", "theta=1"), "no parameter 'theta'; there are lambda1, lambda2,"),
        (("free", "--set", "lambda3=9"), "lambda3 = 9 exceeds the sum of the other two moments"),
        (("heavy-top", "--set", "M=3"), "lambda1 = 1.3 is too small"),
        (("heavy-top", "--set", "theta=200deg"), "theta must be at most 3.14159 rad (180°)"),
        (("bicycle",), "which page?  heavy-top, free or check, not 'bicycle'"),
        ((), "which page?  heavy-top, free or check\n"),
        (("heavy-top", "-o", ""), "--output wants the name of a file"),
        (("heavy-top", "-o", "."), "is no"),
    ],
)
def test_bad_input_is_one_line_and_nothing_is_written(asked, says, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["web", *asked]) == 2
    errors = capsys.readouterr().err
    assert errors.startswith("rigidtop web: ")
    assert says in errors
    assert errors.count("\n") == 1
    assert not list(tmp_path.iterdir())


def test_the_page_that_checks_a_derivation(tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["web", "check"]) == 0
    out = capsys.readouterr().out
    assert out.startswith("check.html\nCheck my derivation (1.")
    assert "curl -L https://github.com/pyodide/pyodide/releases/download/" in out
    assert [p.name for p in tmp_path.iterdir()] == ["check.html"]
    assert main(["web", "check", "--pyodide", "https://example.org/py", "--json"]) == 0
    record = json.loads(capsys.readouterr().out)
    assert record["pyodide"] == "https://example.org/py"
    assert record["bytes"] == (tmp_path / "check.html").stat().st_size


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["check", "--preset", "flip"], "shows no motion"),
        (["check", "--set", "M=2"], "shows no motion"),
        (["check", "--pyodide", "ftp://x/"], "is no address on the web"),
        (["free", "--pyodide", "pyodide/"], "--pyodide is for the page check, not for free"),
        (["chec"], "heavy-top, free or check, not 'chec'"),
    ],
)
def test_what_the_page_that_checks_has_not(words, message, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["web", *words]) == 2
    assert message in capsys.readouterr().err
    assert not [*tmp_path.iterdir()]
