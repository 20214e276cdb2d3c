"""Lines of pages in the worlds of what they rest on."""

import numpy as np
import pytest
from sympy import Integer

from rigidtop.collection import load
from rigidtop.derivations import lecture
from rigidtop.judge.jets import Jet, symbol
from rigidtop.judge.outcome import FALSE, SAMPLED
from rigidtop.judge.page import outcome, witness
from rigidtop.judge.worlds import Worlds
from rigidtop.tree.nodes import Letter

LETTERS = """
from rigidtop.theory.lettered import in_order, positive, real
from rigidtop.theory.symbols import Glyph, t as t

a, c, d, h, v, x, ydot, y, sdot, s, W, theta, m, g, E0, Edot, E, qddot, qdot, q = in_order(
    positive("a", Glyph("a"), "a positive number", "1"),
    positive("c", Glyph("c"), "a rate", "1/s"),
    positive("d", Glyph("d"), "a positive number", "1"),
    positive("h", Glyph("h"), "a positive number", "1"),
    real("v", Glyph("v"), "any number", "1"),
    real("x", Glyph("x"), "any number", "1"),
    real("ydot", Glyph("y", accent="dot"), "its rate", "1/s"),
    real("y", Glyph("y"), "any number", "1"),
    real("sdot", Glyph("s", accent="dot"), "its rate", "1/s"),
    real("s", Glyph("s"), "any number", "1"),
    real("W", Glyph("W"), "any number", "1"),
    real("theta", Glyph("θ"), "any number", "1"),
    positive("m", Glyph("m"), "a mass", "kg"),
    positive("g", Glyph("g"), "an acceleration", "m/s²"),
    positive("E0", Glyph("E", "0"), "a constant energy", "J"),
    real("Edot", Glyph("E", accent="dot"), "its rate", "W"),
    real("E", Glyph("E"), "an energy", "J"),
    real("qddot", Glyph("q", accent="ddot"), "its second rate", "m/s²"),
    real("qdot", Glyph("q", accent="dot"), "its rate", "m/s"),
    real("q", Glyph("q"), "a place", "m"),
)
"""
PAGES = """
from rigidtop.proof.page import Page

from . import letters as letters

PAGES = (Page("1", "A page", "A page.", (), text="page"),)
"""


@pytest.fixture
def judged(tmp_path):
    """What becomes of the last line of a page."""

    def last(page):
        folder = tmp_path / "own"
        folder.mkdir()
        (folder / "__init__.py").write_text(PAGES, "utf-8")
        (folder / "letters.py").write_text(LETTERS, "utf-8")
        (folder / "page.md").write_text(page, "utf-8")
        lecture = load(folder).lecture
        return lecture.judged([*lecture.lines][-1])

    return last


LAWS = r"""# 1 A page

## Laws

Chosen. The size:

$$W = {size}$$

Chosen. The sine:

$$W = \sin\theta$$

## Lines

Put the sine into the size:

$$\sin\theta = {size}$$
"""


def test_a_line_that_no_number_obeys_is_a_gap(judged):
    line = judged(LAWS.replace("{size}", "2"))
    assert not line.follows
    assert "holds for no numbers" in str(line.problem)


def test_the_same_line_with_numbers_follows(judged):
    assert judged(LAWS.replace("{size}", r"\frac12")).follows


POWER = r"""# 1 A page

## Laws

Chosen. The power:

$$y = x^v$$

## Lines

Set $x = {place}$ in the power:

$$y = {base}^v$$
"""


@pytest.mark.parametrize(("place", "base", "follows"), [("-1", "(-1)", False), ("2", "2", True)])
def test_only_whole_powers_of_what_is_negative(judged, place, base, follows):
    assert judged(POWER.replace("{place}", place).replace("{base}", base)).follows is follows


def test_what_is_added_to_what_cannot_be_is_a_gap(judged):
    sum_ = (
        LAWS[: LAWS.index("## Lines")].replace("{size}", "2")
        + r"""## Lines

Add the size to the sine:

$$2W = 2 + \sin\theta$$
"""
    )
    assert not judged(sum_).follows


RIGHT = r"""# 1 A page

## Laws

Chosen. The potential:

$$W = -a\cos\theta$$

Chosen. Along the motion, the even pace:

$$\dot s = c$$

Chosen. Along the motion, the quarter:

$$\dot y = c\sqrt{a^2 - y^2}$$

Chosen. The circle:

$$x^2 + y^2 = a^2$$

Chosen. The exponent:

$$v = \ln\frac ah$$

## Lines

"""


@pytest.mark.parametrize(
    "lines",
    [
        "Set $\\theta = \\frac\\pi2$ in the potential:\n\n$$W = 0$$",
        "Set $\\theta = 0$ in the potential:\n\n$$W = -a$$",
        "Set $x = 0$ in the circle:\n\n$$y^2 = a^2$$"
        "\n\nSolve it for $y$, for $y < 0$:\n\n$$y = -a$$",
        "Set $x = -a$ in the circle:\n\n$$y^2 = 0$$",
        "Rewrite the exponent:\n\n$$v = \\ln a - \\ln h$$",
        "Integrate the even pace from $s = h$:\n\n$$s = h + ct$$",
        "Integrate the even pace from $s = 0$ to $s = h$:\n\n$$t = \\frac hc$$"
        "\n\nMultiply it by $c$:\n\n$$ct = h$$"
        "\n\nMultiply it by $2$:\n\n$$2ct = 2h$$",
        "Integrate the quarter from $y = 0$ to $y = a$:\n\n$$t = \\frac\\pi{2c}$$"
        "\n\nMultiply it by $2c$:\n\n$$2ct = \\pi$$"
        "\n\nMultiply it by $2$:\n\n$$4ct = 2\\pi$$",
    ],
)
def test_a_right_line_is_never_refuted(judged, lines):
    line = judged(RIGHT + lines + "\n")
    assert line.follows, line.problem


def test_a_witness_has_few_numbers_of_letters_that_the_page_writes():
    letters = tuple(symbol(Jet(Letter("r", bold=True), 0, (k,))) for k in range(3))
    hidden = symbol(Jet(Letter("I", mark="entry"), 0, (0, 0)))
    others = tuple(symbol(Jet(Letter(name))) for name in "abcdefgh")
    points = np.arange(1.0, 13.0).reshape(12, 1) + 0j
    worlds = Worlds((*letters, hidden, *others), points)
    why = witness(worlds, [(sum((*letters, *others), hidden), Integer(0))])
    assert why == (
        "it does not hold: its sides are 78 and 0, for instance where "
        "r = (1, 2, 3), a = 5, b = 6, c = 7, d = 8, e = 9"
    )


def test_lines_of_the_lecture_hold_in_their_worlds():
    pages = lecture()
    ids = ["3.33", "3.37", "3.54", "3.55", "3.57"]
    verdicts = {id: outcome(pages, pages.judged(id)).verdict for id in ids}
    assert verdicts == dict.fromkeys(ids, SAMPLED)


def test_no_line_of_the_lecture_is_false():
    pages = lecture()
    verdicts = {id: outcome(pages, pages.judged(id)).verdict for id in [*pages.lines][::7]}
    assert FALSE not in verdicts.values()


DOMAIN = r"""# 1 A page

## Laws

Chosen. The law:

$$y = {right}$$

## Lines

{sentence}:

$${line}$$

Set {place} in it:

$${there}$$
"""


@pytest.mark.parametrize(
    ("right", "sentence", "line", "place", "there"),
    [
        (r"\sqrt x", "Square the law", "y^2 + v = x + v", "$x = -1$", "y^2 + v = v - 1"),
        (r"\arcsin x", "Take the sine of the law", r"\sin y = x", "$x = 2$", r"\sin y = 2"),
        (r"(-a)^x", "Multiply the law by $2$", "2y = 2(-a)^x", "$x = v$", "2y = 2(-a)^v"),
        (
            r"v + \tan\theta",
            r"Multiply the law by $\cos\theta$",
            r"y\cos\theta = v\cos\theta + \sin\theta",
            r"$\theta = \tfrac\pi2$",
            "0 = 1",
        ),
    ],
)
def test_what_has_no_real_value_is_not_set(judged, right, sentence, line, place, there):
    page = DOMAIN.replace("{right}", right).replace("{sentence}", sentence)
    page = page.replace("{line}", line).replace("{place}", place).replace("{there}", there)
    assert not judged(page).follows


@pytest.mark.parametrize(
    ("right", "conditions"),
    [
        (r"\sqrt x", {(">=", "x")}),
        (r"\frac1{\sqrt x}", {(">", "x")}),
        (r"\sqrt{x^2 + a}", set()),
        (r"x^v", {(">", "x")}),
        (r"x^a", {(">=", "x")}),
        (r"x^2", set()),
        (r"a^v", set()),
        (r"\arccos x", {(">=", "1 - x**2")}),
        (r"\tan\theta", {("!=", "cos(theta)")}),
        (r"\ln x", {(">", "x")}),
    ],
)
def test_what_a_line_needs_for_real_sides_is_recorded(judged, right, conditions):
    line = judged(DOMAIN[: DOMAIN.index("## Lines")].replace("{right}", right))
    names = {"≥": ">=", ">": ">", "≠": "!="}
    assert {(names[c.relation], str(c.expression)) for c in line.known.conditions} == conditions


def test_a_condition_that_a_division_asks_for_may_be_said(judged):
    law = "# 1 A page\n\n## Laws\n\nChosen. The law:\n\n$$vx = vy$$\n\n## Lines\n\n"
    line = judged(law + r"Divide the law by $v$, for $v \ne 0$:" + "\n\n$$x = y$$\n")
    assert line.follows, line.problem
    [condition] = line.known.conditions
    assert condition.relation == "≠"


def test_what_stands_below_a_line_is_solved_for(judged):
    law = "# 1 A page\n\n## Laws\n\nChosen. The law:\n\n$$y = \\frac a{x - v}$$\n\n## Lines\n\n"
    line = judged(law + "Solve the law for $x$:\n\n$$x = v + \\frac ay$$\n")
    assert line.follows, line.problem
    assert {str(c.expression) for c in line.known.conditions} == {"y", "-v + x"}


SQUARES = r"""# 1 A page

## Laws

Chosen. The squares:

$$x^2 = y^2$$

## Lines

Subtract $y^2$ from the squares:

$$x^2 - y^2 = 0$$

Divide it by $x - y$:

$$x + y = 0$$
"""


def test_no_world_has_a_zero_of_what_was_divided_by(judged):
    line = judged(SQUARES)
    assert line.follows, line.problem
    assert [each.relation for each in line.known.conditions] == ["≠"]


ENERGY = r"""# 1 A page

## Laws

{whose} energy:

$$E = {energy}$$

## Lines

Differentiate the energy by ${by}$:

$$\frac{{\partial E}}{{\partial {by}}} = {slope}$$
"""


@pytest.mark.parametrize(
    ("whose", "energy", "by", "slope", "follows"),
    [
        ("Chosen. The", r"\tfrac12m\dot q^2 + mgq", "q", "mg", True),
        ("Chosen. The", r"\tfrac12m\dot q^2 + mgq", r"\dot q", r"m\dot q", True),
        ("Chosen. The", r"\tfrac12m\dot q^2 + mgq", "m", r"\tfrac12\dot q^2 + gq", True),
        ("Chosen. The", r"\tfrac12m\dot q^2 + mgq", "q", "2mg", False),
        ("Along the motion, the", r"\tfrac12m\dot q^2 + mgq", "q", "mg", False),
        ("Chosen. The", "E_0", "q", "0", False),
        ("Chosen. The", r"E_0 + E\dot q^2/(gq)", "q", r"-E\dot q^2/(gq^2)", False),
        ("Chosen. The", r"-\tfrac12mq\ddot q", "q", r"-\tfrac12m\ddot q", False),
    ],
)
def test_an_energy_is_no_coordinate(judged, whose, energy, by, slope, follows):
    page = ENERGY.format(whose=whose, energy=energy, by=by, slope=slope)
    assert judged(page).follows is follows


PRODUCT = r"""# 1 A page

## Laws

Chosen. The product:

$$W = dx$$

## Lines

Set $x = 2d$ in the product:

$$W = {value}$$
"""


@pytest.mark.parametrize(("value", "follows"), [("2d^2", True), ("2d", False)])
def test_d_before_a_letter_is_a_factor_where_d_is_a_letter(judged, value, follows):
    assert judged(PRODUCT.replace("{value}", value)).follows is follows
