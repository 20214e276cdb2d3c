"""What numbers or Taylor decide before symbols are asked is what symbols say."""

import pytest
import sympy
from sympy import Rational, cos, exp, sin, sqrt, symbols

from rigidtop.proof.moves.conditions import nonzero
from rigidtop.proof.moves.move import Order, RefusedError
from rigidtop.proof.moves.orders import _series

x, y = symbols("x y", real=True)
p, q = symbols("p q", positive=True)
e = symbols("e", real=True)


@pytest.mark.parametrize(
    ("expression", "never"),
    [(p + q, True), (p - q, False), (x, False), (x**2 + p, True), (x**2 - p, False),
     (p**2 + q * y**2, True), (cos(x), False), (2 + cos(x), True)],
)  # fmt: skip
def test_what_has_a_zero_is_not_called_nonzero(expression, never):
    found = nonzero(expression, ())
    assert found <= never, "a zero was overlooked"
    assert found or not never or expression.has(cos)


@pytest.mark.parametrize(
    "expression",
    [sin(e) * exp(e), 1 / (1 - p * e), sqrt(p + e), cos(e) / (1 + e**2), (1 + e) ** Rational(5, 2)],
)
@pytest.mark.parametrize("power", [1, 2, 3, 4])
def test_taylor_has_the_terms_of_the_series(expression, power):
    made = _series(expression, Order(e, power))
    assert sympy.simplify(made - sympy.series(expression, e, 0, power).removeO()) == 0


def test_terms_that_differ_below_zero_are_refused():
    with pytest.raises(RefusedError, match="the terms are others"):
        _series(sqrt(p * e**2), Order(e, 3))
    assert _series(sqrt(p * q**2), Order(q, 3)) == sqrt(p) * q
