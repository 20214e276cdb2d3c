"""What vanishes, what differs from zero, what is positive: and what is only not known."""

import math

import pytest
import sympy
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from sympy import Abs, Gt, Lt, Ne, Rational, Symbol, cos, pi, sin, sqrt, symbols, tan

from rigidtop.proof import bounds, decide, floats

x, y = symbols("x y", real=True)
a, b = symbols("a b", positive=True)
c = Symbol("c", real=True)

quick = settings(max_examples=40)

coefficients = st.integers(-3, 3).filter(bool)
terms = st.tuples(coefficients, *(st.integers(0, 2) for _ in range(4)))
polynomials = st.lists(terms, min_size=1, max_size=4)


def trigonometric(rows):
    """Σ k aⁱ sinʲx cosᵏx sinˡy."""
    return sum(k * a**i * sin(x) ** j * cos(x) ** n * sin(y) ** m for k, i, j, n, m in rows)


# --- vanishes ----------------------------------------------------------------------------------


@quick
@given(polynomials, polynomials)
def test_a_product_minus_its_expansion_vanishes(first, second):
    left, right = trigonometric(first), trigonometric(second)
    assert decide.vanishes(left * right - sympy.expand(left * right))


@quick
@given(polynomials, st.tuples(coefficients, st.integers(0, 2), st.integers(0, 2)))
def test_with_one_term_more_it_does_not(rows, extra):
    number, power, of_sine = extra
    left = trigonometric(rows)
    residual = left**2 - sympy.expand(left**2) + number * a**power * sin(y) ** of_sine
    assert not decide.vanishes(residual)
    assert not decide.digits_vanish([residual])


@quick
@given(polynomials)
def test_sines_and_cosines_of_sums(rows):
    left = trigonometric(rows)
    turned = left.subs(x, x + y)
    assert decide.vanishes(turned - sympy.expand_trig(turned))


@pytest.mark.parametrize(
    "zero",
    [
        sin(x) ** 2 + cos(x) ** 2 - 1,
        tan(x) * cos(x) - sin(x),
        sin(2 * x) - 2 * sin(x) * cos(x),
        cos(x + y) - cos(x) * cos(y) + sin(x) * sin(y),
        sin(x) ** 2 / (1 + cos(x)) - 1 + cos(x),
        (a**2 - b**2) / (a - b) - a - b,
        sqrt(a) ** 2 - a,
        Rational(1, 3) + Rational(1, 6) - Rational(1, 2),
    ],
)
def test_zero_in_other_clothes(zero):
    assert decide.vanishes(zero)


@pytest.mark.parametrize(
    "other",
    [sin(x), sin(x) ** 2 + cos(x) ** 2, x - y, sin(x) - cos(x), a - b, Rational(1, 10**30) + 0 * x],
)
def test_what_is_not_zero(other):
    assert not decide.vanishes(other)


def test_zero_over_zero_does_not_vanish():
    with sympy.evaluate(False):
        quotient = x / (sin(x) ** 2 + cos(x) ** 2 - 1)
    assert not decide.vanishes(0 * quotient.args[0] + quotient)


# --- nonzero and positive ----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("expression", "conditions", "known"),
    [
        (a * b, (), True),
        (a * c, (), False),
        (a * c, (Ne(c, 0),), True),
        (a * c**3, (Gt(c, 0),), True),
        (c * sin(x), (Ne(c, 0),), False),
        (c * sin(x), (Ne(c, 0), Ne(sin(x), 0)), True),
        (1 - cos(x) ** 2, (Ne(sin(x), 0),), True),
        (x - y, (Ne(y, x),), True),
        (x - y, (Ne(x, 0), Ne(y, 0)), False),
        (x**2 - y**2, (Ne(x, y),), False),
        (a + b, (), True),
    ],
)
def test_nonzero(expression, conditions, known):
    assert bounds.nonzero(expression, conditions) is known


@pytest.mark.parametrize(
    ("expression", "conditions", "known"),
    [
        (a * b / (a + b), (), True),
        (-a, (), False),
        (c, (), False),
        (c, (Gt(c, 0),), True),
        (-c, (Lt(c, 0),), True),
        (c**2, (), False),
        (c**2, (Ne(c, 0),), True),
        (a * (x - y) ** 2, (Ne(x, y),), True),
        (x - y, (Gt(x, y),), True),
        (y - x, (Gt(x, y),), False),
        (a * x**2 + b * y**2, (Ne(x, 0),), True),
        (a * x**2 + b * y**2, (), False),
        (a * x**2 - b * y**2, (Ne(x, 0),), False),
        ((a - b) * x**2, (Gt(a, b), Ne(x, 0)), True),
        ((a - b) * (c - b) * x**2, (Gt(a, b), Lt(c, b), Ne(x, 0)), False),
        (-(a - b) * (c - b) * x**2, (Gt(a, b), Lt(c, b), Ne(x, 0)), True),
        (1 - cos(x) ** 2, (Ne(sin(x), 0),), True),
        (-cos(x), (Lt(cos(x), 0),), True),
        (c + a, (sympy.Ge(c, 0),), True),
        (2 * c + a, (sympy.Le(0, c),), True),
        (c, (sympy.Ge(c, 0),), False),
        (a - c, (sympy.Ge(c, 0),), False),
        (c * x + a, (sympy.Ge(c, 0),), False),
    ],
)
def test_positive(expression, conditions, known):
    assert bounds.positive(expression, conditions) is known


@quick
@given(polynomials, st.floats(-3, 3), st.floats(-3, 3), st.floats(0.1, 3))
def test_what_is_called_positive_is(rows, at_x, at_y, at_a):
    expression = trigonometric(rows)
    values = {x: at_x, y: at_y, a: at_a}
    if bounds.positive(expression):
        assert expression.subs(values) > 0
    if bounds.nonzero(expression):
        assert expression.subs(values) != 0


# --- follows -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("residual", "given_", "conditions", "known"),
    [
        (x - 1, 3 * x - 3, (), True),
        (x - 1, a * (x - 1), (), True),
        (x - 1, c * (x - 1), (), False),
        (x - 1, c * (x - 1), (Ne(c, 0),), True),
        (x - 1, sin(y) ** 2 * (x - 1), (Ne(sin(y), 0),), True),
        (x - 1, x**2 - 1, (), False),
        (x**2 - 1, x - 1, (), True),
        (x / y, x, (), False),
        (x - x, y, (), True),
        (x - 1, y - 1, (), False),
    ],
)
def test_follows(residual, given_, conditions, known):
    assert bounds.follows(residual, given_, conditions) is known


# --- digits ------------------------------------------------------------------------------------


def test_digits_of_an_identity_without_a_normal_form():
    p = sympy.Symbol("p", positive=True)
    identity = sympy.atan(p) + sympy.atan(1 / p) - pi / 2  # for p > 0 only
    assert not decide.vanishes(identity)
    assert decide.digits_vanish([identity])
    assert not decide.digits_vanish([identity.subs(p, x)])


@pytest.mark.parametrize(
    "false",
    [
        sympy.sqrt(x**2) - x,
        sympy.Abs(x + 7) - (x + 7),
        sympy.sqrt(sympy.sin(x) ** 2) - sympy.sin(x),
        sympy.asin(sympy.sin(x)) - x,
        sympy.log(x**2) - 2 * sympy.log(sympy.Abs(x)) + sympy.Abs(x) - x,
    ],
)
def test_digits_look_at_both_signs_and_far_away(false):
    assert not decide.digits_vanish([false])


def test_digits_see_the_thirty_fifth():
    assert not decide.digits_vanish([x * 0 + Rational(1, 10**35) * x])
    assert not decide.digits_vanish([x - x, y])


def test_digits_need_points_where_there_is_a_number():
    assert not decide.digits_vanish([sympy.log(-x) - sympy.log(-x).expand() + sqrt(-x)])


# --- numbers -----------------------------------------------------------------------------------


@quick
@given(polynomials, polynomials, st.integers(0, 500))
def test_evaluate_agrees_with_evalf(top, bottom, seed):
    expression = trigonometric(top) / trigonometric(bottom) + sqrt(a) * Abs(sin(x)) - tan(y) / 3
    point = list(floats.points([x, y, a], {x, y}, seed + 1))[-1]
    # One symbol after the other, subs would cancel a zero above with a zero below.
    assume(trigonometric(bottom).subs(point) != 0)
    exact = expression.subs(point)
    number = floats.at(point)(expression)
    assume(exact.is_finite and abs(exact.evalf(30)) < 1e9)
    assert number == pytest.approx(float(exact.evalf(30)), rel=1e-9, abs=1e-9)


def test_evaluate_where_there_is_no_number():
    point = {x: sympy.Integer(0), y: sympy.Integer(-1)}
    division, root, fine = map(floats.at(point), (1 / sin(x), sqrt(y), x - y))
    assert (division, math.isnan(root), fine) == (math.inf, True, 1.0)


def test_sine_of_pi_counts_as_zero_below_a_fraction():
    assert floats.at({x: pi})(1 / sin(x)) == math.inf


def test_evaluate_knows_every_function_of_sympy():
    point = {x: Rational(1, 2), y: sympy.Integer(-2)}
    asked = (sympy.atan(x) + sympy.exp(y), sympy.log(y), sympy.log(x - x))
    found = [*map(floats.at(point), asked)]
    assert found[0] == pytest.approx(math.atan(0.5) + math.exp(-2), rel=1e-14)
    assert all(math.isnan(number) for number in found[1:])


def test_evaluate_puts_in_what_is_hidden():
    dummy = sympy.Dummy(real=True)
    assert floats.at({x: sympy.Integer(3)}, {dummy: 2 * x})(dummy**2 + x) == 39.0
    values = [*map(floats.at({x: sympy.Integer(0)}, {dummy: 1 / x}), (x, dummy, 1 / dummy))]
    assert values[0] == 0.0
    assert math.isnan(values[1])
    assert math.isnan(values[2])


def test_points_can_be_read_aloud():
    found = list(floats.points([a, c, x], {x}, 600))
    assert len(found) == 600
    assert all(p[a] > 0 and p[a].q <= 3 and p[a].p <= 5 for p in found)
    assert all((p[x] / pi).q <= 6 for p in found)
    assert {p[c] for p in found[:60]} <= {0, 1, 2}
    assert any(p[c] < 0 for p in found)
    assert found == list(floats.points([a, c, x], {x}, 600))  # the same in every run


def test_angles_are_what_stands_inside_a_sine():
    assert floats.angle_symbols([sin(x) + y, cos(2 * c), a]) == {x, c}
    assert floats.angle_symbols([a + x]) == set()


@pytest.mark.parametrize("names", [("a", "b"), ("b", "a"), ("x", "y"), ("p", "m")])
def test_a_root_is_tried_on_both_sides_of_where_it_turns(names):
    a, b = sympy.symbols(names, positive=True)
    assert decide.evidence(sqrt(a**2 - 2 * a * b + b**2) - (a - b)) is None
    assert decide.evidence(sqrt(a**2 - 18 * a * b + 81 * b**2) - (9 * b - a)) is None
    assert decide.evidence(sqrt(a**2 - 2 * a * b + b**2) - sympy.Abs(a - b)) is not None
