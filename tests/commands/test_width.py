"""What commands print is no wider than the terminal."""

import sys
from contextlib import suppress

import pytest

from rigidtop.cli import main
from rigidtop.commands.parser import COMMANDS
from rigidtop.terminal.table import columns


@pytest.mark.parametrize("width", [40, 80])
@pytest.mark.parametrize("command", ["", *COMMANDS])
def test_help_is_no_wider_than_the_terminal(monkeypatch, capsys, command, width):
    monkeypatch.setenv("COLUMNS", str(width))
    with suppress(SystemExit):
        main([command, "--help"] if command else ["--help"])
    text = capsys.readouterr().out
    assert text.startswith("usage: rigidtop")
    assert [line for line in text.splitlines() if columns(line) > width] == []


EXAMPLES = ("simulate", "new", "mark", "audit")


@pytest.mark.parametrize("command", EXAMPLES)
def test_examples_keep_to_a_narrow_terminal(monkeypatch, capsys, command):
    monkeypatch.setenv("COLUMNS", "60")
    with suppress(SystemExit):
        main([command, "--help"])
    text = capsys.readouterr().out
    shown = text[text.index("  rigidtop ") :]
    assert [line for line in shown.splitlines() if columns(line) > 60] == []
    joined = " ".join(shown.replace(" \\\n", " ").split())
    assert " ".join(COMMANDS[command].EPILOG.partition("  rigidtop ")[2].split()) in joined


def test_what_is_refused_and_solved(monkeypatch, capsys):
    width = 60
    monkeypatch.setenv("COLUMNS", str(width))
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)  # elsewhere an error is one line
    for words in (
        ["frobnicate"],
        ["simulate", "top", "--omega3", "40", "--psi-dot", "2"],
        ["derive", "3.35", "--format", "c"],
    ):
        with suppress(SystemExit):
            main(words)
        said = capsys.readouterr().err
        said = said.removeprefix("\r\x1b[K")  # the progress that is taken away
        assert said.startswith("rigidtop")
        assert said.count("\n") > 1
        assert [line for line in said.splitlines() if columns(line) > width] == []
    assert main(["exercise", "fast-spin-roots"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert "Confirmed:" in lines
    assert [line for line in lines if columns(line) > width] == []


ANSWERS = (
    "simulate top",
    "simulate free --moments 1 2 3 --omega 1 0.1 2",
    "simulate sliding",
    "notation",
    "notation goldstein",
    "map 3.57",
    "derive 3.57 --deep",
    "list",
    "list --chapters",
    "figure",
    "exercise",
    "certify top",
)


@pytest.mark.parametrize("words", ANSWERS)
def test_what_is_asked_for(monkeypatch, capsys, words):
    width = 60
    monkeypatch.setenv("COLUMNS", str(width))
    assert main(words.split()) == 0
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) > 2
    assert [line for line in lines if columns(line) > width] == []


@pytest.mark.parametrize("width", [60, 80])
def test_what_is_told_of_a_page_with_faults(monkeypatch, capsys, tmp_path, width):
    monkeypatch.setenv("COLUMNS", str(width))
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True)
    zeros = " & 0" * 5
    matrix = r"\begin{pmatrix} %s" + zeros + r" \\ 0" + zeros + r"\end{pmatrix}"
    tie, slip = (rf"{matrix % 'a'} = {matrix % entry}" for entry in ("b", "2b"))
    page = tmp_path / "faults.md"
    page.write_text(
        "# 1 Faults\n\n| letter | meaning | unit | kind |\n| --- | --- | --- | --- |\n"
        "| $a$ | length | m | number |\n| $b$ | width | m | number |\n\n## Laws\n\n"
        f"Definition. The tie:\n\n$${tie}$$\n\n## Slips\n\nRewrite the tie:\n\n"
        f"$${slip} \\tag{{1.1}}$$\n\n"
        f"Put the law of {'x' * width} into it:\n\n$$a = b$$\n",
        "utf-8",
    )
    for words in (
        ["check", f"{tmp_path}/"],
        ["check", f"{tmp_path}/", "--lines"],
        ["derive", f"{tmp_path}/", "1.1"],
        ["map", f"{tmp_path}/"],
        ["audit", str(page)],
        ["notation", str(page)],
    ):
        main(words)
        shown = "".join(capsys.readouterr())
        assert words[0] != "check" or "it gives b" in " ".join(shown.split())
        lines = [part for line in shown.splitlines() for part in line.split("\r")]
        assert [line for line in lines if columns(line) > width] == [], words
