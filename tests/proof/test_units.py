"""Units of lines, from the symbols' units: what is in what, and what is said where it disagrees."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st
from sympy import ImmutableMatrix, Integer, MatrixBase, Rational, Symbol, atan2, cos, sin, sqrt

from rigidtop.collection import load
from rigidtop.derivations import lecture
from rigidtop.derivations.letters import LETTERS
from rigidtop.notation import NOTES
from rigidtop.proof.equation import (
    Cross,
    Dot,
    Equation,
    Group,
    Partial,
    Rate,
    SumOver,
    Transposed,
    Underbrace,
    VolumeIntegral,
    as_printed,
)
from rigidtop.proof.lecture import Lecture
from rigidtop.proof.letters import Letters
from rigidtop.proof.units import UnitsError, check, defining, dimension, named, parsed
from rigidtop.proof.values import Applied
from rigidtop.proof.verdict import led
from rigidtop.report.ways import gap
from rigidtop.starter import letters as starter
from rigidtop.theory import symbols as s
from rigidtop.typeset.text import text

from .pages import lecture as lecture_of

LECTURE = lecture()
THING = Symbol("thing")
"""A letter of which nothing is known."""


def said(tree) -> str:
    return text(NOTES.written(tree))


def problem(equation: Equation, letters: Letters = LETTERS) -> str:
    with pytest.raises(UnitsError) as caught:
        check(equation, letters)
    return caught.value.words(said)


# --- units as they are written --------------------------------------------------------------------


@pytest.mark.parametrize(
    ("unit", "exponents"),
    {
        "kg m²": (1, 2, 0),
        "J s": (1, 2, -1),
        "N m": (1, 2, -2),
        "J": (1, 2, -2),
        "rad": (0, 0, 0),
        "1": (0, 0, 0),
        "rad/s²": (0, 0, -2),
        "1/s²": (0, 0, -2),
        "J² s²": (2, 4, -2),
        "1/(J s)": (-1, -2, 1),
        "N/m³": (1, -2, -2),
        "W": (1, 2, -3),
        "kg·m^2·s⁻¹": (1, 2, -1),
        "J/(kg K)": (0, 2, -2, 0, -1),
        "Ω": (1, 2, -3, -2),
    }.items(),
)
def test_a_unit_becomes_exponents(unit: str, exponents: tuple[int, ...]) -> None:
    assert parsed(unit) == (*exponents, 0, 0)[:5]


@pytest.mark.parametrize(
    "unit", ["", "ell", "m²⁻", "J/", "/s", "m/s/s", "J/(kg ell)", "N/m s", "m2"]
)
def test_what_is_no_unit_is_unknown(unit: str) -> None:
    """A product behind a solidus has two readings: it has neither here."""
    assert parsed(unit) is None


def test_every_unit_of_the_vocabulary_is_known() -> None:
    assert [x for x, row in s.VOCABULARY.items() if parsed(row.unit) is None and row.unit] == []


def test_a_unit_is_named_as_the_letters_have_it() -> None:
    energy = parsed("kg m²/s²")
    assert energy is not None
    assert named(energy, LETTERS) == "J"
    assert named(energy, Letters()) == "kg m²/s²"
    assert named(parsed("1/(J s)"), Letters()) == "s/(kg m²)"


# --- trees ----------------------------------------------------------------------------------------

with as_printed():
    TREES = {
        s.lambda1 * s.thetaddot: "J",
        -s.M * s.g * s.R * sin(s.theta): "J",
        Group(s.psidot + s.phidot * cos(s.theta)) ** 2: "1/s²",
        sqrt(s.D): "J s",
        s.D ** (-Rational(1, 2)): "1/(J s)",
        Cross(s.omega_vec, s.L_vec): "N m",
        Dot(s.omega_vec, s.L_vec): "J",
        Dot(s.e3, s.L_vec): "J s",
        s.omega1 * s.e1 + s.omega2 * s.e2: "rad/s",
        Applied(s.inertia, s.omega_vec): "J s",
        Rate(s.inertia * s.omega_vec): "N m",
        Rate(Rate(s.theta)): "1/s²",
        Partial(s.Lagrangian, s.thetadot): "J s",
        Rate(Partial(s.Lagrangian, s.thetadot)): "J",
        Partial(s.Lagrangian, s.theta): "J",
        SumOver(Symbol("k"), s.m_k * Cross(s.r_k, s.g_vec)): "N m",
        VolumeIntegral(Symbol("d3r"), Cross(s.r_vec, s.f_r)): "N m",
        VolumeIntegral(Symbol("d3r"), s.rho): "kg",
        Underbrace(s.M * s.g, s.n): "N",
        Transposed(s.O_matrix) * s.r_vec: "m",
        sympy.Abs(s.omega3): "rad/s",
        sin(s.Omega * s.t): "1",
        atan2(s.omega1, s.omega2): "1",
        Rational(1, 2): "1",
        ImmutableMatrix([s.omega1, Integer(0), s.omega3]): "rad/s",
    }


@pytest.mark.parametrize(("tree", "unit"), TREES.items(), ids=str)
def test_what_a_tree_is_in(tree, unit: str) -> None:
    assert dimension(tree, LETTERS) == parsed(unit)


@pytest.mark.parametrize(
    "tree",
    [Integer(0), s.const, THING, THING * s.M, Rate(THING), s.M**THING, Partial(s.E, THING)],
    ids=str,
)
def test_what_fits_all(tree) -> None:
    assert dimension(tree, LETTERS) is None


with as_printed():
    DISAGREE = {
        Equation(
            s.lambda1 * s.phidot, s.lambda1 * s.phidot**2 * sin(s.theta) + s.M * s.g * s.R
        ): "the units disagree: λ₁φ̇ is in J s, λ₁φ̇² sin θ is in J",
        Equation(
            s.lambda1 * s.thetaddot, s.lambda3 * (s.omega3 * s.phidot - s.omega3)
        ): "the units disagree: ω₃φ̇ is in 1/s², ω₃ is in 1/s",
        Equation(s.V, -Group(s.M * s.g)): "the units disagree: V is in J, Mg is in N",
        Equation(s.epsilon, s.M * s.g * s.R): (
            "the units disagree: ε is a pure number, MgR is in J"
        ),
        Equation(s.thetadot, sin(s.omega3)): (
            "the units disagree: sin takes a pure number, ω₃ is in 1/s"
        ),
        Equation(s.T, 2**s.t): "the units disagree: an exponent is a pure number, t is in s",
        Equation(s.L_vec, s.omega_vec): "the units disagree: L is in J s, ω is in 1/s",
        Equation(s.N_vec, Underbrace(Rate(s.L_vec), s.omega_vec)): (
            "the units disagree: L̇ is in J, ω is in 1/s"
        ),
        Equation(s.T, s.L, relation="≈"): "the units disagree: T is in J, L is in J s",
        Equation(s.T, Integer(2)): "the units disagree: T is in J, 2 is a pure number",
        Equation(
            ImmutableMatrix([s.L1, s.L2]), ImmutableMatrix([s.lambda1 * s.omega1, s.lambda2 * s.N2])
        ): "the units disagree: L₂ is in J s, λ₂N₂ is in J² s²",
        Equation(s.omega_vec, ImmutableMatrix([s.omega1, s.L2, s.omega3])): (
            "the units disagree: ω is in 1/s, L₂ is in J s"
        ),
    }


@pytest.mark.parametrize(("equation", "message"), DISAGREE.items(), ids=str)
def test_units_that_disagree_are_named(equation: Equation, message: str) -> None:
    assert problem(equation) == message


@pytest.mark.parametrize(
    "equation",
    [
        Equation(s.M, THING),
        Equation(THING * s.M, s.L3, s.const),
        Equation(s.thetadot, Integer(0)),
        Equation(s.p_phi, s.const),
        Equation(ImmutableMatrix([s.theta, s.thetadot]), ImmutableMatrix([s.beta, s.Omega])),
    ],
    ids=str,
)
def test_what_is_not_known_makes_no_complaint(equation: Equation) -> None:
    check(equation, LETTERS)


def test_a_definition_gives_a_unit() -> None:
    letters = defining(LETTERS, Equation(THING, s.lambda1 * s.omega1))
    assert letters.units[THING] == "kg m²/s"
    assert problem(Equation(THING, s.M), letters) == (
        "the units disagree: thing is in J s, M is in kg"
    )
    assert defining(LETTERS, Equation(s.M, s.R)) is LETTERS
    assert defining(LETTERS, Equation(s.e1, s.L_vec)) is LETTERS
    assert defining(LETTERS, Equation(THING, s.M + s.R)) is LETTERS


# --- properties -----------------------------------------------------------------------------------

LETTER = st.sampled_from([s.lambda1, s.M, s.g, s.omega3, s.L3, s.t, s.damping, s.D, s.theta])
POWER = st.builds(Rational, st.integers(-4, 4), st.integers(1, 3)).filter(bool)


@given(st.lists(st.tuples(LETTER, POWER), min_size=1, max_size=6))
def test_exponents_of_a_product_add(factors) -> None:
    with as_printed():
        product = sympy.Mul(*(letter**power for letter, power in factors))
    total = [
        sum(power * exponent for letter, power in factors for exponent in [parsed(unit(letter))[k]])
        for k in range(5)
    ]
    assert list(dimension(product, LETTERS)) == total


def unit(letter: Symbol) -> str:
    return LETTERS.units[letter]


@given(st.sampled_from([x for x in TREES if not isinstance(x, MatrixBase)]), POWER)
def test_a_number_changes_no_unit(tree, number) -> None:
    with as_printed():
        scaled = number * Group(tree)
    assert dimension(scaled, LETTERS) == dimension(tree, LETTERS)
    check(Equation(scaled, tree), LETTERS)


EQUATIONS = [e for line in LECTURE.lines.values() for e in line.equations]


@given(st.sampled_from(EQUATIONS), POWER)
def test_a_line_times_a_number_keeps_its_units(equation: Equation, number) -> None:
    with as_printed():
        sides = [number * Group(side) for side in equation.sides]
    check(Equation(*sides, relation=equation.relation), LETTERS)


@given(st.sampled_from(EQUATIONS))
def test_a_side_times_a_length_has_other_units(equation: Equation) -> None:
    left, *others = equation.sides
    if left != 0 and any(dimension(side, LETTERS) is not None for side in others):
        with as_printed():
            longer = Equation(s.R * Group(left), *others)
        assert problem(longer).startswith("the units disagree: ")


# --- lines ----------------------------------------------------------------------------------------

LAWS = r"""
# Laws
The potential => V = MgR\cos\theta
The balance => \lambda_1\ddot\theta = MgR\sin\theta
"""


def judged(page: str, laws: str = LAWS, letters: Letters = LETTERS):
    """The lines of a page below the laws, each with what became of it."""
    read = lecture_of(laws, page, letters)
    assert not list(read.unread())
    return [read.judged(line.id) for line in read.texts[1].lines]


def test_units_come_before_anything_else() -> None:
    """The line follows from nothing that it cites either; it is not even tried."""
    [line] = judged(r"Put the potential into the balance => \lambda_1\dot\theta = V")
    assert not line.follows
    message = "page.md, line 1: the units disagree: λ₁θ̇ is in J s, V is in J"
    assert gap(line, LETTERS) == message


def test_a_line_that_follows_keeps_its_units() -> None:
    [line] = judged(r"Multiply the balance by $R$ => \lambda_1\ddot\theta R = MgR^2\sin\theta")
    assert line.follows


def test_what_is_set_has_units_too() -> None:
    page = r"Set $\theta = M$ in the balance => \lambda_1\ddot\theta = MgR\sin\theta"
    [line] = judged(page)
    assert gap(line, LETTERS).endswith("the units disagree: θ is a pure number, M is in kg")


def test_a_definition_has_the_unit_of_its_letter() -> None:
    [line] = judged(r"Call the discriminant => D = \lambda_3\omega_3")
    assert gap(line, LETTERS).endswith("the units disagree: D is in J² s², λ₃ω₃ is in J s")


def test_a_definition_gives_later_lines_a_unit() -> None:
    unknown = replace(LETTERS, units={x: u for x, u in LETTERS.units.items() if x != s.A})
    page = r"""
Call the weight => A = Mg
Multiply it by $R$ => AR = MgR
Rearrange it => A = MgR
"""
    *before, last = judged(page, letters=unknown)
    assert all(line.follows for line in before)
    assert str(last.problem) == "the units disagree: A is in N, R*(M*g) is in J"


def test_a_law_has_units_and_what_rests_on_it_does_not_pass() -> None:
    laws = LAWS.replace("MgR\\sin", "Mg\\sin")
    page = r"Divide the balance by $\lambda_1$ => \ddot\theta = Mg\sin\theta/\lambda_1 \tag{1}"
    read = lecture_of(laws, page)
    law, line = led(read, "1").gaps
    assert law.line.file == "laws.md"
    assert gap(law, LETTERS) == (
        "laws.md, line 7: the units disagree: λ₁θ̈ is in J, Mg sin θ is in N"
    )
    assert "Mg sin θ/λ₁ is in" in gap(line, LETTERS)


def test_letters_without_units_take_numbers() -> None:
    """A page that sets masses and lengths to 1 for short."""
    page = r"Set $M = 1$ and $R = 1$ in the potential => V = g\cos\theta"
    assert all(line.follows for line in judged(page, letters=replace(LETTERS, units={})))
    assert not any(line.follows for line in judged(page))


def test_units_of_a_collection_are_its_letters(tmp_path: Path) -> None:
    """A course of one's own, as `rigidtop new` makes it."""
    folder = tmp_path / "course"
    folder.mkdir()
    for path in Path(starter.__file__).parent.glob("*"):
        if path.is_file():
            words = path.read_text("utf-8").replace("-mgl\\cos\\theta", "-mg\\cos\\theta", 1)
            (folder / path.name).write_text(words, "utf-8")
    read: Lecture = load(folder).lecture
    law = next(line for line in read.lines.values() if line.called == "The potential energy")
    found = read.judged(law.id).problem
    assert found is not None
    assert str(found).startswith("the units disagree: V is in J")
