"""What commands print is no wider than the terminal."""

from contextlib import suppress

import pytest

from rigidtop.cli import main
from rigidtop.commands.parser import COMMANDS
from rigidtop.terminal.table import columns

WIDE = 80
NOTES = r"""\documentclass{article}\begin{document}
$L = \frac12 m\dot x^2 - \frac12 kx^2$ gives
\begin{equation} m\ddot x = -kx \label{oscillator-without-friction} \end{equation}
and not $m\ddot x = kx$.
\end{document}
"""


@pytest.fixture
def printed(monkeypatch, capsys, tmp_path):
    """The lines that a command prints on a terminal of 80 columns, files in a folder of its own."""
    monkeypatch.setenv("COLUMNS", str(WIDE))
    monkeypatch.chdir(tmp_path)
    (tmp_path / "notes.tex").write_text(NOTES, "utf-8")

    def run(words):
        with suppress(SystemExit):  # as --help ends
            main(words)
        out, err = capsys.readouterr()
        return [*out.splitlines(), *err.splitlines()]

    return run


@pytest.mark.parametrize("command", COMMANDS)
def test_help(printed, command):
    lines = printed([command, "--help"])
    assert lines
    assert [line for line in lines if columns(line) > WIDE] == []


@pytest.mark.parametrize(
    "asked",
    [
        "list",
        "map 3.57",
        "notation",
        "exercise",
        "exercise toy-box",
        "derive 3.47",
        "derive 3.49",
        "derive 3.57 --deep",
        "derive axis-stability",
        "figure",
        "audit notes.tex",
        "read notes.tex",
        "mark notes.tex --from 3.53 --to 3.54",
        "simulate top --theta 30deg --omega3 40 --time 0.1 --samples 3",
        "simulate free --moments 1 2 3 --omega 0.01 2 0.01 --samples 3",
        "simulate sliding --theta 0.3 --omega3 60 --tip 0.02 --mu 0.3 --time 0.1 --samples 3",
        "certify top --theta 0.5 --omega3 40 --time 0.5 --samples 3",
        "sweep -o map.npy --axis omega3=1:9:3",
        "new course",
        "web heavy-top",
    ],
)
def test_what_is_printed(printed, asked):
    lines = printed(asked.split())
    assert lines
    assert [line for line in lines if columns(line) > WIDE] == []


def test_a_sentence_stands_no_deeper_than_its_equation(printed):
    said, equation = printed(["derive", "3.54"])[4:6]
    assert (said, equation) == ("  Differentiate (3.53) with respect to θ̇:", "    ∂ℒ/∂θ̇ = λ₁θ̇")
