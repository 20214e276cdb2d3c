"""What README and documentation show is what one gets."""

from __future__ import annotations

import ast
import doctest
import importlib
import io
import re
import shlex
from contextlib import redirect_stdout
from functools import cache
from pathlib import Path

import pytest

import rigidtop
from rigidtop.cli import main
from rigidtop.commands.parser import parsed

ROOT = Path(__file__).parents[1]
README = ROOT / "README.md"
SITE = ROOT / "notebooks" / "site"
CONFIGURATION = (SITE / "conf.py").read_text("utf-8")
MADE = {"figures", "lecture", "notebooks"}
"""Folders of the site that its configuration writes."""
PAGES = [
    README,
    *(page for page in sorted(SITE.rglob("*.md")) if page.relative_to(SITE).parts[0] not in MADE),
]


def name(page: Path) -> str:
    return page.relative_to(ROOT).as_posix()


def commands(page: Path) -> list[tuple[list[str], str]]:
    """Each command line of a page as words, and what the page shows of its output."""
    found = []
    for block in re.findall(r"^```console\n(.*?)^```", page.read_text("utf-8"), re.M | re.S):
        for command in re.split(r"^\$ ", block, flags=re.M)[1:]:
            line, _, shown = command.partition("\n")
            found.append((shlex.split(line, comments=True), shown))
    return found


def files(page: Path) -> list[tuple[str, str]]:
    """What a page tells its reader to save, with its name."""
    return re.findall(
        r"as\s`(\S+)`:\n\n```(?:markdown|latex)\n(.*?)^```", page.read_text("utf-8"), re.M | re.S
    )


def is_whole_lecture(words: list[str]) -> bool:
    """What takes too long for every page: the README's first command and tests/commands make it."""
    return words[1] == "lecture" and not any(word.endswith("/") for word in words)


def agree(shown: str, out: str) -> bool:
    """Whether the output is what is shown, in which … stands for any lines, or the rest of one."""
    rows = [
        r"(?:.*\n)*?" if row == "…" else re.escape(row).replace("…", ".*") + r"\n"
        for row in shown.rstrip().splitlines()
    ]
    return re.fullmatch("".join(rows), out.rstrip() + "\n") is not None


@cache
def ran(words: tuple[str, ...]) -> tuple[int, str]:
    """The exit code of a command and what it prints; several pages have the same one."""
    patient = ["--seconds", "3600"] if words[0] == "mark" else []
    with redirect_stdout(io.StringIO()) as out:
        code = main([*words, *patient])
    return code, out.getvalue()


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_examples_run(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    result = doctest.testfile(str(page), module_relative=False, encoding="utf-8")
    assert result.failed == 0


@pytest.mark.parametrize("page", PAGES, ids=name)
def test_every_command_is_one(page):
    for words, _ in commands(page):
        assert words[0] == "rigidtop"
        assert parsed(words[1:]).command == words[1]


@pytest.mark.parametrize("page", [page for page in PAGES if commands(page)], ids=name)
def test_commands_run_and_print_what_is_shown(page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")
    for file, text in [*(each for other in PAGES for each in files(other)), *files(page)]:
        (tmp_path / file).parent.mkdir(exist_ok=True)
        (tmp_path / file).write_text(text, "utf-8")
    for data in (ROOT / "notebooks" / "data").iterdir():
        (tmp_path / data.name).write_bytes(data.read_bytes())
    for words, shown in commands(page):
        if is_whole_lecture(words):
            assert not shown
            continue
        code, out = ran(tuple(words[1:]))
        assert code in (0, 1), words
        if shown:
            assert agree(shown, out), words


def test_there_are_such_pages():
    assert sum(page.read_text("utf-8").count(">>>") for page in PAGES) > 30
    asked = [(words, shown) for page in PAGES for words, shown in commands(page)]
    assert len(asked) > 30
    assert sum(bool(shown) for _, shown in asked) >= 6
    assert sum(is_whole_lecture(words) for words, _ in asked) <= 5


def test_the_verdicts_are_counted_as_they_are(judgements):
    verdicts = [judgement.verdict.value for judgement in judgements.values()]
    [sentence] = re.findall(r"^Of the (\d+ claims .*?)\.", README.read_text("utf-8"), re.M | re.S)
    assert sentence.startswith(f"{len(verdicts)} claims ")
    counted = re.findall(r"(\d+)(?: are)? `(\w+)`", sentence)
    counts = {verdict: int(count) for count, verdict in counted}
    assert counts == {verdict: verdicts.count(verdict) for verdict in set(verdicts)}


def test_first_two_blocks_are_one_command_each():
    blocks = re.findall(r"^```sh\n(.*?)^```", README.read_text("utf-8"), re.M | re.S)
    assert len(blocks) == 2
    assert all(block.count("\n") == 1 for block in blocks)
    assert "rigidtop lecture --pdf" in blocks[0]
    assert "pytest" in blocks[1]


def test_every_public_name_is_in_the_reference():
    there = "\n".join(page.read_text("utf-8") for page in (SITE / "reference").glob("*.md"))
    named = set(re.findall(r"^\.\. auto\w+:: rigidtop\.(\w+)$", there, re.M))
    assert set(rigidtop.__all__) - {"__version__"} <= named


@pytest.mark.parametrize("room", ["theory", "proof", "typeset", "codegen"])
def test_every_public_module_is_in_the_reference_and_says_what_its_names_are(room):
    public = importlib.import_module(f"rigidtop.{room}").__all__
    page = (SITE / "reference" / f"{room}.md").read_text("utf-8")
    assert sorted(re.findall(rf"^\.\. automodule:: rigidtop\.{room}\.(\w+)$", page, re.M)) == public
    for name in public:
        module = importlib.import_module(f"rigidtop.{room}.{name}")
        there = [
            x for x in vars(module).values() if getattr(x, "__module__", "") == module.__name__
        ]
        made = [x for x in there if callable(x) and not x.__name__.startswith("_")]
        assert [x.__name__ for x in made if not x.__doc__] == []
        assert module.__doc__


def test_every_link_to_a_file_leads_there():
    for page in PAGES:
        for target in re.findall(r"\]\(([^)#:]+?)(?:#[\w-]+)?\)", page.read_text("utf-8")):
            made = target.partition("/")[0] in MADE
            assert made or (page.parent / target).exists(), f"{page.name}: {target}"


def test_the_gallery_shows_what_its_examples_print_and_nothing_else():
    """Not <matplotlib.legend.Legend object at 0x…>, which the last line of one may give."""
    settings = re.search(r"^sphinx_gallery_conf = (\{.*?^\})", CONFIGURATION, re.M | re.S)
    assert ast.literal_eval(settings[1])["capture_repr"] == ()
