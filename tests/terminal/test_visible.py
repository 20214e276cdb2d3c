"""What nobody sees, and what tells a terminal or TeX what to do, is shown by its number."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from rigidtop.cli import main
from rigidtop.report import blocks as b
from rigidtop.report import html, markdown, myst, plain, tex, typst
from rigidtop.terminal.table import table

HOSTILE = "\x1b[2J\u202e\x9b\x07\u2066\x7f"
UNSEEN = re.compile("[\0-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")
NOTES = (
    f"\\documentclass{{article}}\n\\section{{{HOSTILE}}}\n\\input{{{HOSTILE}}}\n"
    f"\\begin{{equation}}\\label{{e{HOSTILE}}} E = m \\end{{equation}}\n$$E = {HOSTILE} m$$\n"
)


@pytest.mark.parametrize("more", [[], ["--json"]])
@pytest.mark.parametrize(
    "command", [["audit"], ["read"], ["mark", "--from", "3.53", "--to", "3.54"]]
)
def test_no_command_prints_what_nobody_sees(
    command: list[str], more: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / f"notes{HOSTILE}.tex"
    file.write_text(NOTES, "utf-8")
    main([command[0], str(file), *command[1:], *more])
    main([command[0], str(file) + ".none", *command[1:], *more])
    shown = capsys.readouterr()
    assert shown.out
    assert ".none" in shown.err
    assert not UNSEEN.search(shown.out + shown.err)
    if more:
        json.loads(shown.out)


def test_nor_does_a_page_have_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file, page = tmp_path / f"notes{HOSTILE}.md", tmp_path / "page.html"
    file.write_text(f"# {HOSTILE}\n\n{HOSTILE} $${HOSTILE} = 1$$\n\n$$E = m$$ (3.57)\n", "utf-8")
    main(["audit", str(file), "-o", str(page)])
    assert not UNSEEN.search(page.read_text("utf-8") + capsys.readouterr().out)


def test_nor_has_a_document() -> None:
    blocks = (b.SectionHead(1, "1", HOSTILE, "one"), b.Paragraph((HOSTILE,)))
    document = b.Document(HOSTILE, HOSTILE, blocks, HOSTILE, byline=HOSTILE)
    made = [tex.write(document, {}), tex.fragment(blocks[1:]), plain.fragment(blocks[1:])]
    made += tex.chapters(document, {}).values()
    made += [html.write(document, {}), html.fragment(blocks[1:]), markdown.markdown(blocks[1:])]
    made += [typst.write(document, {}), typst.fragment(blocks[1:])]
    made += myst.write(document).values()
    assert not any(map(UNSEEN.search, made))
    assert "U+202E" in made[0]
    assert "U+202E" in html.write(document, {})


def test_colours_are_ours_alone() -> None:
    shown = table([["red", HOSTILE]], colors={"red": "red"})
    assert re.sub("\x1b\\[(31|0)m", "", shown) == (
        "red  (U+001B)[2J(U+202E)(U+009B)(U+0007)(U+2066)(U+007F)"
    )


@pytest.mark.skipif(os.name != "posix", reason="no shell that closes streams")
def test_where_the_output_is_closed_it_goes_nowhere() -> None:
    command = f"{sys.executable} -m rigidtop.cli list >&-"
    ended = subprocess.run(command, shell=True, capture_output=True, text=True, check=False)
    assert (ended.returncode, ended.stderr) == (0, "")


def test_without_docstrings_commands_work() -> None:
    """In one process: Python compiles all that it imports anew for -OO."""
    code = (
        "from rigidtop.cli import main\n"
        "for words in ('check --quick 3.57', 'derive 3.57', 'list 3.57'):\n"
        "    print(main(words.split()))"
    )
    command = [sys.executable, "-OO", "-c", code]
    ended = subprocess.run(command, capture_output=True, text=True, check=False, timeout=120)
    assert (ended.returncode, ended.stderr) == (0, "")
    *shown, rest = ended.stdout.split("\n0\n")
    assert ["3.57" in each for each in shown] == [True] * 3
    assert rest == ""
