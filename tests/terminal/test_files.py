"""Files that users name: every command reads and refuses them alike."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from rigidtop.cli import main
from rigidtop.terminal.files import text_of

COMMANDS = {
    "audit": ["audit", "{}"],
    "read": ["read", "{}"],
    "mark": ["mark", "{}", "--from", "3.53", "--to", "3.57"],
    "notation": ["notation", "{}"],
    "derive": ["derive", "3.57", "--notation", "{}"],
}
BAD = {
    "none.toml": "No such file or directory",
    "folder.toml": "Is a directory",
    "bytes.toml": "it is not text in UTF-8",
    "long.toml": "it has more than 4000000 bytes",
    "pipe.toml": "it is not an ordinary file",
}


@pytest.mark.parametrize("name", BAD)
@pytest.mark.parametrize("command", COMMANDS)
def test_one_wording(
    command: str, name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "folder.toml").mkdir()
    (tmp_path / "bytes.toml").write_bytes(b"\xff\xfe\x00")
    (tmp_path / "long.toml").write_bytes(b" " * 4_000_001)
    os.mkfifo(tmp_path / "pipe.toml")
    file = tmp_path / name
    assert main([word.format(file) for word in COMMANDS[command]]) == 2
    said = capsys.readouterr()
    assert said.out == ""
    why = f"cannot read {file}: {BAD[name]}"
    if (command, name) == ("mark", "folder.toml"):
        why = f"{file}: no answers in it, .tex or .md"
    if (command, name) == ("audit", "folder.toml"):
        why = f"{file} is a collection, no notes: these stand behind it"
    assert said.err == f"rigidtop {command}: {why}\n"


def test_marks_and_line_ends_of_other_systems(tmp_path: Path) -> None:
    file = tmp_path / "a.txt"
    file.write_bytes("\ufeffone\r\ntwo\rλ\n".encode())
    assert text_of(file) == "one\ntwo\nλ\n"
