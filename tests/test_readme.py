"""The README's Python examples run as they stand."""

from __future__ import annotations

import doctest
import re
from pathlib import Path

README = Path(__file__).parents[1] / "README.md"


def test_examples_run() -> None:
    result = doctest.testfile(str(README), module_relative=False, encoding="utf-8")
    assert result.attempted >= 12
    assert result.failed == 0


def test_verdict_table_is_current() -> None:
    from rigidtop.derivations import PAGES
    from rigidtop.proof.verdict import judge_page

    verdicts = [judgement.verdict.value for page in PAGES for judgement in judge_page(page)]
    counts = dict(re.findall(r"^\| `(\w+)` \|.*\| (\d+) \|$", README.read_text("utf-8"), re.M))
    assert {name: int(count) for name, count in counts.items()} == {
        name: verdicts.count(name) for name in set(verdicts)
    }


def test_first_two_blocks_are_one_command_each() -> None:
    blocks = re.findall(r"^```sh\n(.*?)^```", README.read_text("utf-8"), re.M | re.S)
    assert len(blocks) == 2
    assert all(block.count("\n") == 1 for block in blocks)
    assert "rigidtop lecture --pdf" in blocks[0]
    assert "pytest" in blocks[1]


def test_the_derivation_is_printed_as_it_stands(capsys) -> None:
    from rigidtop.cli import main

    shown = re.search(
        r"^\$ rigidtop derive 3\.54\n(.*?)^```", README.read_text("utf-8"), re.M | re.S
    )
    assert shown is not None
    assert main(["derive", "3.54"]) == 0
    assert capsys.readouterr().out.strip() == shown[1].strip()
