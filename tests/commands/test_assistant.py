"""The tools of an assistant, asked by a client of the protocol."""

import asyncio
import json
import sys

import mcp
import pytest

from rigidtop.cli import main

LAW = r"$$L = \tfrac12 m l^2\dot\theta^2 + m g l\cos\theta$$"
BOB = rf"{LAW} and so $$l\ddot\theta = g\sin\theta$$"
TOP = {"theta": 0.5, "omega3": 40}


async def asked(*calls):
    """What comes of each call: its record, or the error's words."""
    start = mcp.StdioServerParameters(command=sys.executable, args=["-m", "rigidtop", "mcp"])
    said = []
    async with mcp.Client(start) as client:
        for name, arguments in calls:
            result = await client.call_tool(name, arguments)
            if result.is_error:
                said.append(result.content[0].text)
            else:
                said.append(result.structured_content)
        said.append({each.name: each.input_schema for each in (await client.list_tools()).tools})
    return said


GOAL = r"l\ddot\theta = -g\sin\theta"


@pytest.fixture(scope="module")
def said(tmp_path_factory):
    """What comes of calls to one server, and the schemas of its tools."""
    secret = tmp_path_factory.mktemp("files") / "secret.tex"
    secret.write_text("$$E = 7$$", "utf-8")
    text = rf"\documentclass{{article}} \input{{{secret.with_suffix('')}}} $E = 8$"
    calls = (
        ("audit", {"text": BOB}),
        ("derive", {"name": "3.53"}),
        ("mark", {"text": f"$${GOAL}$$", "given": LAW, "goal": GOAL}),
        ("simulate", {"top": TOP, "samples": 3}),
        ("certify", {"top": TOP, "samples": 5}),
        ("audit", {"text": text}),
        ("audit", {"text": "none"}),
        ("derive", {"name": "/etc"}),
        ("mark", {"text": "$x = 1$"}),
        ("mark", {"text": "$x = 1$", "start": "3.53", "goal": "9.99"}),
        ("simulate", {"top": {**TOP, "theta": 9}}),
        ("audit", {}),
        ("simulate", {"top": {"mass": "heavy"}, "samples": 1}),
    )
    return asyncio.run(asked(*calls))


def test_an_assistant_is_told_what_the_commands_tell(said, tmp_path, capsys):
    (tmp_path / "bob.md").write_text(BOB, "utf-8")
    main(["audit", str(tmp_path / "bob.md"), "--json"])
    findings = json.loads(capsys.readouterr().out)
    main(["derive", "3.53", "--json"])
    derivation = json.loads(capsys.readouterr().out)
    main(["certify", "top", "--theta", "0.5", "--omega3", "40", "--samples", "5", "--json"])
    certificate = json.loads(capsys.readouterr().out)
    audit, derive, mark, simulate, certify, *_, tools = said
    assert audit["findings"] == findings
    assert audit["summary"].endswith("1 wrong; 1 says something new")
    assert derive["steps"] == derivation["steps"]
    assert mark["passed"]
    assert simulate["columns"]["t/s"] == [0, 5, 10]
    assert certify["passed"] is certificate["passed"] is True
    assert certify["differences"].keys() == certificate["differences"].keys()
    assert [*tools] == ["audit", "derive", "mark", "simulate", "certify"]
    assert tools["simulate"]["properties"]["samples"]["maximum"] == 10_000


def test_what_makes_no_sense_is_told_in_one_line(said):
    for words, expected in zip(
        said[6:-1],
        (
            *("no formulas", "no equation or claim '/etc'", "say `goal`", "'9.99'"),
            *("theta must lie", "audit: `text` is missing"),
            "simulate: `top.theta` and `top.omega3` are missing; `top.mass` should be a valid",
        ),
        strict=True,
    ):
        assert expected in words
        assert "\n" not in words
    assert said[-2].endswith("; `samples` should be greater than or equal to 2")


def test_no_file_is_read(said):
    shown = json.dumps(said[5]["findings"])
    assert "8" in shown
    assert "E = 7" not in shown
