"""Polynomials in rings against what SymPy makes of the same expressions."""

import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import cos, sin, sqrt, symbols

from rigidtop.theory.polynomial import Polynomial
from rigidtop.theory.rates import slope

x, y, a, b = symbols("x y a b")
p, q = symbols("p q", positive=True)

LEAVES = st.sampled_from([x, y, sin(a), cos(a), sqrt(p + q), p, sympy.Rational(2, 3), sympy.S(-1)])
EXPRESSIONS = st.recursive(
    LEAVES,
    lambda parts: st.one_of(
        st.tuples(parts, parts).map(lambda pair: pair[0] + pair[1]),
        st.tuples(parts, parts).map(lambda pair: pair[0] * pair[1]),
        st.tuples(parts, st.sampled_from([2, 3])).map(lambda pair: pair[0] ** pair[1]),
    ),
    max_leaves=8,
)
AT = {x: 3, y: -2, a: sympy.Rational(7, 5), p: 5, q: sympy.Rational(2, 7)}


@settings(max_examples=40, deadline=None)
@given(EXPRESSIONS, EXPRESSIONS)
def test_a_ratio_keeps_its_value_in_every_form(above, below):
    normal = Polynomial(above).expression()
    assert sympy.expand(normal) == normal
    assert not any(power.base == sin(a) and power.exp > 1 for power in normal.atoms(sympy.Pow))
    assert abs(float((above - normal).subs(AT))) < 1e-9 * (1 + abs(float(above.subs(AT))))
    if Polynomial(below).expression() != 0:
        made = sympy.Mul(*(base**power for base, power in Polynomial(above / below).factors()))
        value = float((above / below).subs(AT))
        assert float(made.subs(AT)) == pytest.approx(value, rel=1e-9, abs=1e-12)
        assert Polynomial(above / below - made).is_zero()
        assert not Polynomial(above / below - made + 1).is_zero()


@settings(max_examples=40, deadline=None)
@given(EXPRESSIONS, st.sampled_from([x, a, p]))
def test_a_slope_is_the_derivative(expression, by):
    assert Polynomial(slope(expression, by) - expression.diff(by)).is_zero()


@pytest.mark.parametrize(
    "expression",
    [
        1 / sin(x) - sin(x) - cos(x) ** 2 / sin(x),
        1 / (1 + 1 / (1 + 1 / x)) - (x + 1) / (2 * x + 1),
        1 / (sqrt(a) + sqrt(b)) - (sqrt(a) - sqrt(b)) / (a - b),
        sqrt(x) - x / sqrt(x),
        sqrt(1 - x / p**2) - sqrt(p**2 - x) / p,
        (x + sympy.I) * (x - sympy.I) - x**2 - 1,
    ],
)
def test_what_vanishes_is_seen_to(expression):
    assert Polynomial(expression).is_zero()
    assert not Polynomial(expression + y).is_zero()


@pytest.mark.parametrize(
    "nothing",
    [
        sin(x) ** 2 + cos(x) ** 2 - 1,
        (x + y) ** 2 - x**2 - 2 * x * y - y**2,
        1 / sin(x) - sin(x) - cos(x) ** 2 / sin(x),
    ],
)
def test_what_is_divided_by_nothing_does_not_vanish(nothing):
    assert not Polynomial((x - x * y) / nothing).is_zero()
    assert not Polynomial((sin(y) ** 2 + cos(y) ** 2 - 1) / nothing).is_zero()
    assert not Polynomial(1 / (x + 1 / nothing)).is_zero()


def test_what_does_not_commute_keeps_its_order():
    A, B = symbols("A B", commutative=False)
    assert Polynomial((A + x * B) * (A - B)).expression() == sympy.expand((A + x * B) * (A - B))
    assert Polynomial((A + B) ** 2 - A**2 - A * B - B * A - B**2).is_zero()
    assert not Polynomial(A * B - B * A).is_zero()


def test_factors_are_those_of_sympy_and_nothing_has_none():
    x, y, z = sympy.symbols("x y z", real=True)
    for made in (x * y + y * z, (x + y) ** 2 * z, 6 * x**2 - 6 * y**2, x**2 + y**2, -x * y):
        factors = Polynomial(made).factors()
        product = sympy.Mul(*(base**power for base, power in factors))
        assert sympy.expand(product - made) == 0
        number, known = sympy.factor_list(made)
        assert sorted(n for b, n in factors if not b.is_number) == sorted(n for _, n in known), (
            number
        )
    assert sympy.Mul(*(b**n for b, n in Polynomial(sympy.Integer(0)).factors())) == 0
