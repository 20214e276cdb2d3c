"""``rigidtop notation`` and the option ``--notation``, as a user meets them."""

import inspect
import json

import pytest

from rigidtop.cli import main
from rigidtop.codegen.languages import source
from rigidtop.codegen.values import NothingToEvaluateError, rewritten, values
from rigidtop.derivations.euler_angles import page
from rigidtop.notation import GOLDSTEIN, named
from rigidtop.proof.verdict import judge
from rigidtop.proof.words import unmarked
from rigidtop.report.blocks import Table
from rigidtop.report.html import write as html
from rigidtop.report.lecture import Edition, lecture
from rigidtop.report.notations import different
from rigidtop.report.tex import write as tex
from rigidtop.report.typst import write as typst
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


def test_the_conventions_are_listed(capsys):
    said = out(capsys, "notation")
    for words in ("Goldstein, Poole and Safko", "Landau and Lifshitz", "Taylor", "Morin"):
        assert words in said
    assert said.count("R = Rz(φ) Rx(θ) Rz(ψ)") == 3
    rows = [line.split()[:3] for line in said.splitlines()]
    assert ["I₃", "λ₃", "I3"] in rows
    assert ["μ", "M", "mu"] in rows
    assert ["Γ₁", "N₁", "Gamma1"] in rows
    assert ["φ", "½π", "+"] in rows


def test_the_conventions_as_json(capsys):
    [record] = json.loads(out(capsys, "notation", "goldstein", "--json"))
    assert (record["name"], record["euler"]) == ("goldstein", "zxz")
    assert "3rd edition" in record["source"]
    by_symbol = {row["symbol"]: row for row in record["symbols"]}
    assert by_symbol["phi"]["notes"] == "½π + φ"
    assert by_symbol["e2p"]["notes"] == "−e₁′"
    assert by_symbol["R"]["glyph"]["base"] == "l"


@pytest.mark.parametrize(
    ("format", "line"),
    [
        ("text", "I₁θ̈ = I₁φ̇² sin θ cos θ − I₃(ψ̇ + φ̇ cos θ)φ̇ sin θ + Mgl sin θ  (3.54)"),
        ("latex", r"I_{1}\ddot{\theta} &= I_{1}\dot{\phi}^{2}\sin\theta\cos\theta - I_{3}"),
        ("html", "<msub><mi>I</mi><mn>1</mn></msub>"),
        ("typst", "I_(1) dot.double(theta)"),
        ("python", "def equation_3_54(theta, thetadot, phidot, psidot, I1, I3, M, g, l):"),
        ("c", "double psidot, double I1"),
        ("fortran", "I1, I3, M, g, l, out)"),
        ("julia", "function equation_3_54(theta, thetadot, phidot, psidot, I1, I3, M, g, l)"),
    ],
)
def test_an_equation_of_goldstein(capsys, format, line):
    said = out(capsys, "derive", "3.54", "--notation", "goldstein", "--format", format)
    assert line in said
    _, _, equations = said.partition("whose words stand beside the equations")
    assert "lambda" not in equations
    assert "λ" not in equations


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


def test_the_change_of_angles_is_a_claim(capsys):
    said = out(capsys, "derive", "euler-zxz")
    assert "[proved]" in said
    assert "φ_x = ½π + φ\n" in said
    # In that notation the angle itself, of which there is nothing to say.
    assert "φ_x = " not in out(capsys, "derive", "euler-zxz", "--notation", "goldstein")


def test_a_document_says_its_notation_first():
    judged = [(page, tuple(judge(claim, page.section) for claim in page.claims))]
    whole, _ = lecture(judged, (), Edition(figures=(), notation=GOLDSTEIN))
    for made in (tex(whole, {}), html(whole, {}), typst(whole, {})):
        assert "Goldstein, Poole and Safko" in made
    for words in ("Goldstein, Poole and Safko", "3rd edition (2002)", "z–x′–z″: R = Rz(φ) Rx(θ)"):
        assert words in unmarked(whole.colophon)
    assert whole.blocks[0].title == "Notation"
    [symbols] = [
        block for block in whole.blocks if isinstance(block, Table) and block.kind == "symbols"
    ]
    listed = [text(node) for node, _, _ in symbols.rows]
    assert {"I₁", "I₂", "I₃"} <= set(listed)
    assert not {"λ₁", "λ₃"} & set(listed)
    meanings = {text(node): meaning for node, meaning, _ in symbols.rows}
    assert meanings["φ"] == "first Euler angle: azimuth of the line of nodes"


def test_only_what_a_document_uses_is_listed_as_different():
    landau = named("landau")
    used = {landau.letters[x] for x in list(landau.letters)[:3]}
    assert [x.name for x in different(landau, used)] == ["I1", "I2", "I3"]


def test_components_are_along_the_axes_of_the_notation(capsys):
    made = out(capsys, "derive", "3.42", "--notation", "goldstein", "--format", "javascript")
    assert "Components with e₂′ = (0, 1, 0), e₁′ = (1, 0, 0), e₃ = (0, 0, 1)." in made
    body = made[made.index("return [") :].splitlines()
    assert body[1:4] == [
        "    thetadot,",
        "    phidot*Math.sin(theta),",
        "    phidot*Math.cos(theta) + psidot,",
    ]


@pytest.mark.parametrize("name", ["goldstein", "landau", "morin"])
def test_values_of_every_claim_can_be_written(name, judgements):
    notation = named(name)
    written = 0
    for judged in judgements.values():
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
