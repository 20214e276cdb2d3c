"""``rigidtop notation`` and the option ``--notation``, as a user meets them."""

import inspect
import json
from itertools import cycle

import pytest

from rigidtop.cli import main
from rigidtop.codegen.languages import source
from rigidtop.codegen.values import NothingToEvaluateError, rewritten, values
from rigidtop.notation import named
from rigidtop.typeset.text import text

MINE = """
title = "Mine"
source = "my own lecture"
[letters]
"λ" = "J"
[symbols]
R = { base = "d" }
"""


def out(capsys, *arguments):
    assert main(list(arguments)) == 0
    return capsys.readouterr().out


def refused(capsys, *arguments):
    assert main(list(arguments)) == 2
    said = capsys.readouterr()
    assert said.out == ""
    assert said.err.count("\n") == 1
    return said.err


def test_the_conventions_as_json(capsys):
    [record] = json.loads(out(capsys, "notation", "goldstein", "--json"))
    assert (record["name"], record["euler"]) == ("goldstein", "zxz")
    assert "3rd edition" in record["source"]
    by_symbol = {row["symbol"]: row for row in record["symbols"]}
    assert by_symbol["phi"]["notes"] == "½π + φ"
    assert by_symbol["e2p"]["notes"] == "−e₁′"
    assert by_symbol["R"]["glyph"]["base"] == "l"


def test_code_gives_the_same_numbers(capsys):
    functions = []
    for notation in ("notes", "goldstein", "landau"):
        space: dict = {}
        exec(out(capsys, "derive", "3.47", "--notation", notation, "--format", "python"), space)
        functions.append(space["equation_3_47"])
    notes, goldstein, landau = functions
    phi, theta, psi, turn = 0.3, 0.7, -0.4, 1.5707963267948966

    def at(function, first, third):
        given = {"phi": first, "theta": theta, "psi": third}
        return function(**{name: given[name] for name in inspect.signature(function).parameters})

    expected = at(notes, phi, psi)
    assert at(goldstein, phi + turn, psi - turn) == pytest.approx(expected)
    assert at(landau, phi + turn, psi - turn) == pytest.approx(expected)
    assert at(goldstein, phi, psi) != pytest.approx(expected)


def test_a_table_of_ones_own(capsys, tmp_path):
    path = tmp_path / "mine.toml"
    path.write_text(MINE)
    said = out(capsys, "derive", "3.53", "--notation", str(path))
    assert "ℒ = ½J₁(φ̇² sin² θ + θ̇²) + ½J₃(ψ̇ + φ̇ cos θ)² − Mgd cos θ  (3.53)" in said
    assert "As in Mine" in said
    assert "my own lecture" in out(capsys, "notation", str(path))


def test_a_bad_table_is_one_line(capsys, tmp_path):
    path = tmp_path / "bad.toml"
    path.write_text("[symbols]\nlamda1 = { base = 'J' }")
    said = refused(capsys, "derive", "3.53", "--notation", str(path))
    assert said.endswith("symbols: no symbol 'lamda1'; did you mean lambda1?\n")
    assert "bad.toml" in refused(capsys, "notation", str(path))
    assert "did you mean taylor?" in refused(capsys, "check", "3.53", "--notation", "tailor")


def test_a_lecture_is_not_begun_in_a_notation_that_is_none(capsys, tmp_path):
    refused(capsys, "lecture", "-o", str(tmp_path / "out"), "--notation", "none")
    assert not (tmp_path / "out").exists()


def test_notes_of_the_check_are_in_the_notation(capsys):
    said = out(capsys, "check", "3.45", "--notation", "goldstein", "--json")
    [record] = json.loads(said)
    assert record["assumptions"][0] == "I₂ = I₁ (a symmetric top) [stated]"
    assert record["verdict"] == "assuming"


def test_values_of_every_claim_can_be_written(judgements):
    written = 0
    for judged, name in zip(judgements.values(), cycle(["goldstein", "landau", "morin"])):
        notation = named(name)
        try:
            made = values(judged)
        except NothingToEvaluateError:
            continue
        there = rewritten(made, notation.written)
        names = [x.name for x in there.arguments]
        assert len(set(names)) == len(made.arguments)
        assert not set(there.arguments) & set(notation.images)
        space: dict = {}
        exec(source(there, "python", text).text, space)
        written += 1
    assert written > 25
