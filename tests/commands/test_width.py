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
