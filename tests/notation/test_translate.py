"""Into another notation and back, in symbols and on the page."""

import pickle
import re

import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Matrix, Ne, Rational, cos, diff, pi, sin, tan

from rigidtop.notation import BUILT_IN, GOLDSTEIN, NOTES, named
from rigidtop.notation.translate import is_typed
from rigidtop.proof.equation import Cross, Equation, Group, Partial, Underbrace, as_printed, value
from rigidtop.report.wording import Wording
from rigidtop.theory import symbols as s
from rigidtop.theory import top
from rigidtop.theory.rotation import euler_matrix, euler_omega, rotation_x, rotation_z
from rigidtop.theory.trig import reduce_trig
from rigidtop.typeset.layout import layout
from rigidtop.typeset.text import text

ALL = [named(name) for name in BUILT_IN]
TURNED = [notation for notation in ALL if notation.sequence == "zxz"]
by_name = pytest.mark.parametrize("notation", ALL, ids=BUILT_IN)


def plain(tree):
    """Without what is only for the page, expanded."""
    if isinstance(tree, Equation):
        return [plain(side) for side in tree.sides]
    if isinstance(tree, sympy.MatrixBase):
        return [plain(entry) for entry in tree]
    return sympy.expand(value(tree, {}))


ATOMS = st.sampled_from(
    [
        s.lambda1,
        s.lambda3,
        s.M,
        s.g,
        s.R,
        s.omega1,
        s.omega3,
        s.phi,
        s.theta,
        s.psi,
        s.phidot,
        s.e1p,
        s.e2p,
        s.omega1p,
        s.omega2p,
        s.c_phi,
        s.s_psi,
        s.L_z,
        s.N1,
        s.U,
        s.V,
        s.tau,
    ]
)
NUMBERS = st.integers(-3, 3).map(sympy.Integer) | st.sampled_from([Rational(1, 2), Rational(-2, 3)])
ANGLES = st.builds(
    lambda a, b, c: a * s.phi + b * s.psi + c * s.theta,
    *[st.sampled_from([0, 1, -1, 2, Rational(1, 2), 3])] * 3,
)
LEAVES = ATOMS | NUMBERS | ANGLES.map(sin) | ANGLES.map(cos) | ANGLES.map(tan)
EXPRESSIONS = st.recursive(
    LEAVES,
    lambda inner: st.one_of(
        st.builds(lambda a, b: a + b, inner, inner),
        st.builds(lambda a, b: a * b, inner, inner),
        st.builds(lambda a: a**2, inner),
        st.builds(sin, inner),
        st.builds(cos, inner),
    ),
    max_leaves=8,
)


@given(EXPRESSIONS, st.sampled_from(ALL))
@settings(max_examples=100)
def test_there_and_back_is_the_same_expression(expression, notation):
    there = notation.written(expression)
    assert not there.free_symbols & set(notation.images)
    assert sympy.expand(notation.in_notes(there)) == sympy.expand(expression)


@given(EXPRESSIONS, st.sampled_from(TURNED))
@settings(max_examples=60)
def test_the_value_is_the_same_at_the_same_attitude(expression, notation):
    symbols = sorted(expression.free_symbols, key=str)
    point = {x: Rational(7 * k + 3, 5) for k, x in enumerate(symbols)}
    images = {x: notation.images[x] for x in symbols if x in notation.images}
    there = {image.symbol: point[x] - image.quarters * pi / 2 for x, image in images.items()}
    there = {
        y: -v if any(i.symbol == y and i.negative for i in images.values()) else v
        for y, v in there.items()
    }
    rest = {x: v for x, v in point.items() if x not in images}
    written = notation.written(expression).subs({**there, **rest}, simultaneous=True)
    left, right = written.evalf(30), expression.subs(point, simultaneous=True).evalf(30)
    assert left == right or abs(left - right) < 1e-18 * (1 + abs(right))


@pytest.mark.parametrize("notation", TURNED, ids=lambda notation: notation.name)
def test_the_matrix_is_that_of_the_other_sequence(notation):
    phi, psi = (notation.letters[x] for x in (s.phi, s.psi))
    turns = rotation_z(phi) * rotation_x(s.theta) * rotation_z(psi)
    assert notation.written(euler_matrix()) - turns == sympy.zeros(3)


@pytest.mark.parametrize("notation", TURNED, ids=lambda notation: notation.name)
def test_omega_of_the_text_books(notation):
    # Goldstein (4.87), Landau and Lifshitz (35.1)
    psi = notation.letters[s.psi]
    printed = Matrix(
        [
            s.phidot * sin(s.theta) * sin(psi) + s.thetadot * cos(psi),
            s.phidot * sin(s.theta) * cos(psi) - s.thetadot * sin(psi),
            s.phidot * cos(s.theta) + s.psidot,
        ]
    )
    assert reduce_trig(notation.written(euler_omega("body")) - printed) == sympy.zeros(3, 1)


def test_what_the_symmetric_top_is_made_of_keeps_its_form():
    assert text(GOLDSTEIN.written(top.symmetric_lagrangian())) == (
        "½I₁(φ̇² sin² θ + θ̇²) + ½I₃(ψ̇ + φ̇ cos θ)² − Mgl cos θ"
    )
    assert text(named("landau").written(top.symmetric_lagrangian())) == (
        "½I₁(φ̇² sin² θ + θ̇²) + ½I₃(ψ̇ + φ̇ cos θ)² − μgl cos θ"
    )


@pytest.mark.parametrize(
    ("expression", "written"),
    [
        (cos(s.phi), "sin φ"),
        (sin(s.phi), "−cos φ"),
        (cos(s.psi), "−sin ψ"),
        (sin(s.psi), "cos ψ"),
        (tan(s.phi), "−1/tan φ"),
        (sin(2 * s.phi), "−sin(2φ)"),
        (cos(s.phi + s.psi), "cos(φ + ψ)"),
        (cos((s.phi - s.psi) / 2), "sin(½φ − ½ψ)"),
        (sin(s.phi / 2), "−cos(¼π + ½φ)"),
        (s.phi, "φ − ½π"),
        (-s.e1p * s.phidot * sin(s.theta), "φ̇ sin θ e₂′"),
        (s.e2p * s.thetadot, "θ̇e₁′"),
        (s.omega1p**2 + s.omega2p**2, "ω₁′² + ω₂′²"),
        (s.omega1p**3, "−ω₂′³"),
        (Ne(sin(s.phi), 0), "cos φ ≠ 0"),
    ],
)
def test_quarter_turns_are_taken_in(expression, written):
    assert text(GOLDSTEIN.written(expression)) == written


def test_a_typed_equation_stays_typed():
    with as_printed():
        typed = Equation(
            s.omega_vec,
            Underbrace(Group(-s.phidot * sin(s.theta)), s.omega1p) * s.e1p
            + s.thetadot * s.e2p
            + Group(s.psidot + s.phidot * cos(s.theta)) * s.e3,
            tag="3.42",
        )
        crossed = Equation(s.L_vecdot, s.M * Cross(s.R * s.e1p, s.g_vec))
    made = GOLDSTEIN.written(typed)
    assert text(made, "printed", tag=True) == (
        "ω = (φ̇ sin θ)e₂′ + θ̇e₁′ + (ψ̇ + φ̇ cos θ)e₃, with φ̇ sin θ ≡ ω₂′  (3.42)"
    )
    assert is_typed(made.sides[1])
    assert text(GOLDSTEIN.written(crossed), "printed") == "L̇ = −Mle₂′ × g"


def test_a_minus_before_both_sides_is_left_out_where_it_says_nothing():
    equal = Equation(s.omega1p, -s.phidot * sin(s.theta))
    assert text(GOLDSTEIN.written(equal)) == "ω₂′ = φ̇ sin θ"
    less = Equation(s.omega1p, -s.phidot * sin(s.theta), relation="<")
    assert text(GOLDSTEIN.written(less)) == "−ω₂′ < −φ̇ sin θ"


def test_a_derivative_is_by_the_angle_itself():
    potential = sympy.Derivative(s.V, s.phi)
    assert GOLDSTEIN.written(potential) == sympy.Derivative(s.V, GOLDSTEIN.letters[s.phi])
    phi, omega = GOLDSTEIN.letters[s.phi], GOLDSTEIN.letters[s.omega2p]
    assert GOLDSTEIN.written(Partial(s.Lagrangian, s.phi)).args[1] == phi
    assert text(GOLDSTEIN.written(Partial(s.T, s.omega1p))) == f"−∂T/∂{text(omega)}"


def test_the_name_of_an_angle_does_not_know_where_it_is_counted_from():
    assert text(GOLDSTEIN.named(s.phi)) == "φ"
    assert text(GOLDSTEIN.named(sympy.Eq(s.phi, 0))) == text(GOLDSTEIN.written(sympy.Eq(s.phi, 0)))
    assert Wording(GOLDSTEIN)(r"Neither $\phi$ nor $\psi$, but $\phi = 0$") == (
        r"Neither $\phi$ nor $\psi$, but $\phi - \tfrac{1}{2}\pi = 0$"
    )


def test_the_same_letter_for_another_angle_is_another_symbol():
    phi = GOLDSTEIN.letters[s.phi]
    assert (phi.name, text(phi)) == ("phi", "φ")
    assert phi != s.phi
    assert phi == named("goldstein").letters[s.phi]
    assert pickle.loads(pickle.dumps(phi)) == phi
    assert pickle.loads(pickle.dumps(phi)).stands == s.phi
    assert diff(sin(phi), s.phi) == 0


@by_name
def test_factors_and_terms_stand_in_the_order_of_the_notes(notation):
    def letters(tree):
        return re.findall(r"Glyph\([^)]*\)", repr(layout(tree)))

    other = {repr(row.glyph): repr(notation.glyphs[x]) for x, row in s.VOCABULARY.items()}
    for expression in (top.symmetric_lagrangian(), *top.symmetric_equations()):
        made = notation.written(expression)
        assert not is_typed(made)
        assert letters(made) == [other[letter] for letter in letters(expression)]


def test_the_notes_themselves_change_nothing():
    equation = Equation(s.L3, s.lambda3 * s.omega3)
    assert NOTES.images == {}
    assert NOTES.written(equation) == equation
    assert NOTES.read(equation) == equation
