"""A meaning that is the statement itself proves nothing, however it is put together."""

import json

import pytest

from rigidtop.cli import main

LETTERS = """\
from rigidtop.theory.lettered import in_order, positive, real
from rigidtop.theory.symbols import Glyph

m, g, length, E, theta, thetaddot, thetadot, x, y, r = in_order(
    positive("m", Glyph("m"), "mass", "kg"),
    positive("g", Glyph("g"), "gravity", "m/s²"),
    positive("length", Glyph("l"), "length", "m"),
    real("E", Glyph("E"), "energy", "J"),
    real("theta", Glyph("θ"), "angle", "rad"),
    real("thetaddot", Glyph("θ", accent="ddot"), "acceleration", "rad/s²"),
    real("thetadot", Glyph("θ", accent="dot"), "rate", "rad/s"),
    real("x", Glyph("x"), "place", "m"),
    real("y", Glyph("y"), "place", "m"),
    real("r", Glyph("r"), "distance", "m"),
)
"""
NEIGHBOUR = """\
from sympy import Rational, cos, sin

from rigidtop.notation import Notation
from rigidtop.read.page import Displays
from rigidtop.theory.lagrangian import accelerations

from .letters import g, length, m, theta, thetaddot, thetadot

GLYPHS = {x: x.quantity.glyph for x in (g, length, theta, thetaddot)}
shown = Displays(__package__, Notation("course", GLYPHS, {}))
LAW = -(g / length) * sin(theta)
LAGRANGIAN = Rational(1, 2) * m * length**2 * thetadot**2 + m * g * length * cos(theta)
DERIVED = accelerations(LAGRANGIAN, [theta], [thetadot])[0]

def law():
    found = g * sin(theta)
    return -found / length

def derived():
    return accelerations(LAGRANGIAN, [theta], [thetadot])[0]
"""
TEXT = r"$$\ddot\theta = -\frac gl\sin\theta \tag{1.1}$$"
PAGE = """\
import sympy
from sympy import Matrix, Ne, cos, sin

from rigidtop.proof.equation import Cross, Equation, Group, as_printed
from rigidtop.proof.page import Assumption, Check, Page, claim
from rigidtop.theory.lagrangian import accelerations, energy
from rigidtop.theory.rotation import total_derivative

from . import neighbour
from .letters import E, g, length, m, r, theta, thetaddot, thetadot, x, y
from .neighbour import DERIVED, LAGRANGIAN, LAW, derived, law, shown

@claim("1.1", "x")
def one():
    with as_printed():
        printed = Equation(thetaddot, -(g / length) * sin(theta))
        multiple = Equation(length * thetaddot, -g * sin(theta))
        vector = Equation(Matrix([thetaddot, theta]), Matrix([-(g / length) * sin(theta), theta]))
    {body}

PAGES = (Page("1", "x", "y", (one,)),)
"""


def judged(tmp_path, capsys, body):
    folder = tmp_path / "course"
    folder.mkdir()
    files = {"letters": LETTERS, "neighbour": NEIGHBOUR, "__init__": PAGE.replace("{body}", body)}
    for name, text in files.items():
        (folder / f"{name}.py").write_text(text, encoding="utf-8")
    (folder / "text.md").write_text(TEXT, encoding="utf-8")
    failed = main(["check", f"{folder}/", "--json"])
    [record] = json.loads(capsys.readouterr().out)
    assert failed == (record["verdict"] != "proved")
    return record, f"{folder / '__init__.py'}, line "


def held(theta_ddot, before="", line="printed"):
    """A check of a line with θ̈ from an expression that is typed in the page."""
    return f"{before}\n    yield Check({line}, {{thetaddot: {theta_ddot}}})".lstrip()


CIRCULAR = {
    "typed": held("-(g / length) * sin(theta)"),
    "in another order": held("-sin(theta) * g / length"),
    "the side itself": held("printed.sides[1]"),
    "solved for": held("-(g / length) * sin(theta)", line="multiple"),
    "rearranged": held("(g * sin(theta)).subs(g, -g).expand() / length"),
    "a factor": held("-(2 * g / length - g / length) * sin(theta)"),
    "by SymPy's name": held("-sympy.simplify(g * sin(theta)) / length"),
    "a name": held("it / length", "angle = sin(theta)\n    it = -g * angle"),
    "a mapping": "shape = {E: m, thetaddot: LAW}\n    yield Check(printed, shape)",
    "beside what is derived": held("LAW, E: energy(LAGRANGIAN, [thetadot])"),
    "zipped": "yield Check(printed, dict(zip([thetaddot], [-(g / length) * sin(theta)])))",
    "a neighbour's": held("LAW"),
    "a neighbour's by its module": held("neighbour.LAW"),
    "a neighbour's function": "yield Check(printed, meaning={thetaddot: law()})",
    "a neighbour's function by its module": held("neighbour.law()"),
    "what the page prints": "yield Check(shown('1.1'), {thetaddot: LAW})",
    "both from the page": held("shown('1.1').sides[1]"),
    "a line of the page": held("shown.lines('1.1')[0].sides[1]"),
    "a function within": held("again()", "def again():\n        return LAW"),
    "a lambda": held("again()", "again = lambda: LAW"),
    "no generator": "return [Check(printed, {thetaddot: LAW})]",
    "a loop": "for line in (printed, multiple):\n        yield Check(line, {thetaddot: LAW})",
    "a vector": held("LAW", line="vector"),
    "given": "yield Check(printed, given=(thetaddot + (g / length) * sin(theta),))",
    "given with the other sign": "yield Check(printed, given=(-thetaddot + LAW,))",
}


@pytest.mark.parametrize("how", CIRCULAR)
def test_a_meaning_that_is_the_statement_proves_nothing(tmp_path, capsys, how):
    body = CIRCULAR[how]
    record, place = judged(tmp_path, capsys, body)
    lines = PAGE.replace("{body}", body).splitlines()
    made = 1 + next(n for n, line in enumerate(lines) if "Check(" in line)
    if "return [" in body:
        made = lines.index("def one():")
    what = "what is given" if "given" in how else "the meaning of thetaddot"
    assert record["verdict"] == "undecided"
    assert record["note"] == (
        f"PageError: {place}{made}: CircularMeaningError: {what} is typed, and is what the "
        "statement says: derive it"
    )


DERIVED = {
    "derived": held("accelerations(LAGRANGIAN, [theta], [thetadot])[0]"),
    "by a name": held("it[0]", "it = accelerations(LAGRANGIAN, [theta], [thetadot])"),
    "a neighbour's": held("DERIVED"),
    "a neighbour's function": held("derived()"),
    "a neighbour's function by its module": held("neighbour.derived()"),
    "a derivative": held("(g * cos(theta) / length).diff(theta)"),
    "an identity": "at = {x: r * cos(theta), y: r * sin(theta)}\n"
    "    yield Check(Equation(x**2 + y**2, r**2), at)",
    "a product": "of = {x: Matrix([1, 0, 0]), y: Matrix([0, g, 0])}\n"
    "    yield Check(Equation(Cross(x, y), Matrix([0, 0, g])), of)",
    "no meaning": "yield Check(Equation(sin(theta) ** 2 + cos(theta) ** 2, 1))",
    "what follows": "moving = (Assumption(Ne(thetadot, 0), stated=True),)\n"
    "    rate = (length * thetaddot + g * sin(theta)) * thetadot\n"
    "    yield Check(printed, given=(rate,), assuming=moving)",
}


@pytest.mark.parametrize("how", DERIVED)
def test_what_is_derived_is_proved_though_it_is_the_same_tree(tmp_path, capsys, how):
    record, _ = judged(tmp_path, capsys, DERIVED[how])
    assert record["verdict"] == "proved", record["note"]


def test_a_typed_meaning_that_is_wrong_is_refuted(tmp_path, capsys):
    record, _ = judged(tmp_path, capsys, "yield Check(printed, {thetaddot: g * sin(theta)})")
    assert record["verdict"] == "false"
