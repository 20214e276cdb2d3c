"""Integrals between bounds: read, carried out, printed, refused; the time that a motion takes."""

from __future__ import annotations

import pytest
import sympy

from rigidtop.derivations.letters import LETTERS
from rigidtop.notation import NOTES
from rigidtop.proof.algebra import Algebra
from rigidtop.proof.equation import IntegralOver, NoMeaningError
from rigidtop.proof.values import antiderivative
from rigidtop.read.equations import equations as read
from rigidtop.read.page import read_lecture
from rigidtop.theory import symbols as s
from rigidtop.typeset.latex import latex
from rigidtop.typeset.layout import layout
from rigidtop.typeset.mathml import mathml
from rigidtop.typeset.text import text

from .pages import markdown

LAWS = r"""
# Laws
Along the motion, the swing => \dot\chi = \omega_0\sqrt{1 - m\sin^2\chi}
Along the motion, the fall => \dot\chi = -\omega_0(1 + \chi^2)
Along the motion, the drift => \dot\chi = \omega_1\sin\chi
Definition. The height => h = 3r
The volume over π => r^3 = \int_0^h dr_3\,\frac{r_3^2}9
# The page
"""


def last(page: str) -> str:
    """What is wrong with the last line of a page; nothing where it follows."""
    lecture = read_lecture([("page", markdown(LAWS + page))], LETTERS, NOTES)
    assert not list(lecture.unread())
    *_, id = lecture.lines
    return str(lecture.judged(id).problem or "")


@pytest.mark.parametrize(
    ("move", "display", "problem"),
    [
        ("Integrate the swing from $\\chi = 0$ to $\\chi = \\tfrac\\pi2$", "K(m)/\\omega_0", ""),
        (
            "Integrate the swing from $\\chi = 0$ to $\\chi = \\tfrac\\pi2$",
            "\\int_0^{\\frac\\pi2}d\\chi\\,\\frac1{\\omega_0\\sqrt{1 - m\\sin^2\\chi}}",
            "",
        ),
        ("Integrate the swing from $\\chi = 0$ to $\\chi = \\theta_0$", "F/\\omega_0", ""),
        (
            "Integrate the swing from $\\chi = 0$ to $\\chi = \\tfrac\\pi2$",
            "2K(m)/\\omega_0",
            "does not arrive",
        ),
        (
            "Integrate the swing from $\\chi = 0$ to $\\theta = \\tfrac\\pi2$",
            "K(m)/\\omega_0",
            "from one value of chi to another, not of theta",
        ),
        ("Integrate the fall from $\\chi = 1$ to $\\chi = 0$", "1/\\omega_0", "does not arrive"),
        (
            "Integrate the drift from $\\chi = 1$ to $\\chi = 2$",
            "1/\\omega_0",
            "no function of chi",
        ),
        (
            "Integrate the height from $\\chi = 1$ to $\\chi = 2$",
            "1/\\omega_0",
            "does not say what",
        ),
    ],
)
def test_the_time_from_one_value_to_another(move: str, display: str, problem: str) -> None:
    right = display.replace("K(m)", r"\operatorname{K}(m)")
    right = right.replace("F/", r"\operatorname{F}(\theta_0, m)/")
    found = last(f"{move} => t = {right}")
    assert problem in found if problem else found == ""


def test_what_is_reached_at_a_moment_has_no_rate() -> None:
    page = r"""
Integrate the swing from $\chi = 0$ to $\chi = \tfrac\pi2$ =>
  t = \frac{\operatorname{K}(m)}{\omega_0}
Take the rate of it => 1 = 0
"""
    assert "at a moment: its rate does not follow" in last(page)


def test_an_integral_is_carried_out_where_a_line_is_rewritten() -> None:
    page = r"Rewrite the volume over π => r^3 = \frac{h^3}{%s}"
    assert last(page % "27") == ""
    assert "does not arrive" in last(page % "9")


@pytest.mark.parametrize(
    "integrand",
    [
        "x**3 - 2*x + 1",
        "sin(x)**2*cos(x)",
        "x*cos(x)",
        "3/sqrt(1 - sin(x)**2/4)",
        "-2/sqrt(4 + sin(x)**2)",
    ],
)
def test_a_primitive_gives_the_integral_that_numbers_give(integrand: str) -> None:
    x = sympy.Symbol("x", real=True)
    f = sympy.sympify(integrand, locals={"x": x})
    found = antiderivative(f, x)
    assert found is not None
    exact = float((found.subs(x, 1) - found.subs(x, sympy.Rational(-1, 2))).evalf())
    import mpmath

    assert exact == pytest.approx(float(mpmath.quad(sympy.lambdify(x, f, "mpmath"), [-0.5, 1])))


@pytest.mark.parametrize("integrand", ["1/x**2", "1/cos(x)**2", "sqrt(1 - x**2)", "1/sqrt(x)"])
def test_what_may_have_a_pole_between_has_no_primitive(integrand: str) -> None:
    """From −1 to 1 the primitive −1/x of 1/x² would give −2."""
    x = sympy.Symbol("x", real=True)
    assert antiderivative(sympy.sympify(integrand, locals={"x": x}), x) is None


def test_what_stands_outside_is_not_bound() -> None:
    """The variable of an integral is no letter of its bounds, nor of what is put in."""
    node = IntegralOver(s.r3, sympy.Integer(0), s.r3, s.r3 * s.height)
    assert Algebra(LETTERS).value(node) == s.r3**2 * s.height / 2
    put = Algebra(LETTERS, {s.height: s.r3}).value(node)
    assert put == s.r3**3 / 2


def test_an_integral_over_what_a_product_hides_is_none() -> None:
    from rigidtop.proof.equation import Rate

    with pytest.raises(NoMeaningError, match="in a product or a rate"):
        Algebra(LETTERS).value(IntegralOver(s.chi, 0, 1, Rate(s.chi)))


def test_it_is_read_and_printed() -> None:
    [line] = read(r"r_1 = \int_0^{2h}dr_3\,\frac{r_3}h", NOTES)
    assert line.equation is not None
    node = line.equation.sides[1]
    assert node == IntegralOver(s.r3, sympy.Integer(0), 2 * s.height, s.r3 / s.height)
    assert text(line.equation) == "r₁ = ∫ from 0 to 2h dr₃ r₃/h"
    assert r"\int_{0}^{2h} dr_{3}\,\frac{r_{3}}{h}" in latex(line.equation)
    assert "<msubsup><mo>∫</mo><mn>0</mn>" in mathml(layout(line.equation))
    again = read(latex(line.equation), NOTES)[0].equation
    assert again == line.equation


@pytest.mark.parametrize(
    ("tex", "problem"),
    [
        (r"M = \int_0^h r_3", "does not say over what"),
        (r"M = \int_0 dr_3\,r_3", "an integral is"),
        (r"M = \int_0^h d2\,r_3", "does not say over what"),
        (r"M = \int r_3", "does not say over what"),
    ],
)
def test_what_is_no_integral_is_not_read(tex: str, problem: str) -> None:
    [line] = read(tex, NOTES)
    assert problem in str(line.problem)


def test_units_are_those_of_variable_and_body() -> None:
    assert last("Rewrite the height => h = 3r") == ""
    page = r"Rewrite the volume over π => \int_0^h dr_3\,r_3 = r^3"
    assert "the units disagree" in last(page)


def test_equations_are_multiplied_side_by_side() -> None:
    page = "Multiply the height by the height => h^2 = %s r^2"
    assert last(page % "9") == ""
    assert last(page % "3") != ""
