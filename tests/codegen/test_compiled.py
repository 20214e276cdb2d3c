"""Compiled functions give the numbers of those that are not."""

import importlib
import importlib.util
import math
import sys

import numpy as np
import pytest
from sympy import Abs, Add, Integer, Matrix, Piecewise, Rational, cos, gamma, pi, sin, sqrt, symbols

from rigidtop.codegen import numpy as plain
from rigidtop.codegen import shipped
from rigidtop.errors import RigidtopError

BACKENDS = [
    pytest.param(
        name,
        marks=pytest.mark.skipif(
            importlib.util.find_spec(name) is None, reason=f"{name} is not installed"
        ),
    )
    for name in ("numba", "heyoka")
]
ROUNDING = 1e-14
"""Of sums, relative to the sum of the magnitudes of their terms."""

x, y, lambda1 = symbols("x y lambda1")
EXPRESSIONS = [
    sin(x) ** 2 / 2 / lambda1 + sqrt(lambda1) * Rational(3, 7) * y,
    -Rational(1, 2) * (x * y + cos(x)) + pi,
    Integer(4),
    x**-3,
]


def function(backend, *arguments):
    return importlib.import_module(f"rigidtop.codegen.{backend}").function(*arguments)


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("side", shipped.SHIPPED, ids=lambda side: side.name)
def test_shipped_right_hand_sides(backend, side):
    rates, arguments = tuple(side.derive()), (*side.state, *side.parameters)
    inputs = np.random.default_rng(5).uniform(0.3, 1.5, (len(arguments), 40))
    made, reference = (function(b, rates, arguments, side.name) for b in (backend, "numpy"))
    terms = plain.function(
        [sum(map(Abs, Add.make_args(rate.expand()))) for rate in rates], arguments, "terms"
    ).array(*inputs)
    through_math = np.array([reference.scalar(*column) for column in inputs.T.tolist()]).T
    for found in (
        made.array(*inputs),
        np.array([made.scalar(*column) for column in inputs.T.tolist()]).T,
        reference.array(*inputs),
    ):
        assert found.shape == through_math.shape
        assert np.all(abs(found - through_math) <= ROUNDING * terms)
    assert made.source == reference.source
    assert made.operations == reference.operations


@pytest.mark.parametrize("backend", BACKENDS)
def test_arrays_broadcast_and_constants_with_them(backend):
    made = function(backend, EXPRESSIONS, (x, y, lambda1), "example")
    reference = plain.function(EXPRESSIONS, (x, y, lambda1), "example")
    column, row = np.linspace(0.1, 2, 5)[:, None], np.linspace(-1, 1, 7)
    transposed, few = np.ones((7, 5)).T * column, np.arange(14.0)[::2]
    for given in [(column, row, 2.5), (transposed, few, column), (0.7, -1.3, 2.5), ([0.7], 1, 2)]:
        expected, found = reference.array(*given), made.array(*given)
        assert found.shape == expected.shape
        assert found == pytest.approx(expected, rel=ROUNDING)
        assert found.flags.c_contiguous
    assert list(made.scalar(0.7, -1.3, 2.5)) == pytest.approx(
        reference.scalar(0.7, -1.3, 2.5), rel=ROUNDING
    )
    assert {type(value) for value in made.scalar(0.7, -1.3, 2.5)} <= {float, int}


@pytest.mark.parametrize("backend", BACKENDS)
def test_arrays_without_elements_and_one_expression(backend):
    made = function(backend, Matrix([x * y]), (x, y), "product")
    assert made.array([], 2.0).shape == (1, 0)
    assert made.array([3.0, 4.0], 2.0).tolist() == [[6.0, 8.0]]


@pytest.mark.parametrize("backend", BACKENDS)
def test_division_by_zero_in_arrays_is_infinite(backend):
    made = function(backend, [1 / x, y / x], (x, y), "quotients")
    found = made.array([0.0, 2.0], 0.0)
    assert found[0].tolist() == [math.inf, 0.5]
    assert math.isnan(found[1, 0])


@pytest.mark.skipif(importlib.util.find_spec("heyoka") is None, reason="heyoka is not installed")
def test_a_batch_is_one_array_in_and_one_out():
    made = function("heyoka", EXPRESSIONS, (x, y, lambda1), "example")
    rows = np.random.default_rng(6).uniform(0.5, 1.5, (3, 1001))
    into = np.empty((4, 1001))
    assert made.batch(rows, outputs=into) is not None
    assert into.tolist() == made.batch(rows).tolist()
    assert into == pytest.approx(made.array(*rows), rel=ROUNDING)


@pytest.mark.skipif(importlib.util.find_spec("heyoka") is None, reason="heyoka is not installed")
@pytest.mark.parametrize(
    ("expression", "says"),
    [
        (Piecewise((x, x > 0), (y, True)), "f: heyoka's functions have no cases"),
        (gamma(x), "f: heyoka has no gamma"),
        (Abs(x), "f: heyoka has no abs"),
    ],
)
def test_what_heyoka_cannot_do(expression, says):
    with pytest.raises(RigidtopError) as caught:
        function("heyoka", [expression], (x, y), "f")
    assert str(caught.value) == says


@pytest.mark.skipif(importlib.util.find_spec("numba") is None, reason="numba is not installed")
def test_floats_raise_where_python_does():
    made = function("numba", [1 / x, Piecewise((x, x > 0), (-x, True))], (x,), "quotient")
    with pytest.raises(ZeroDivisionError):
        made.scalar(0.0)
    assert made.scalar(-2.0) == (-0.5, 2.0)


@pytest.mark.parametrize("backend", BACKENDS)
def test_a_symbol_that_is_no_argument_is_named(backend):
    with pytest.raises(ValueError, match=r"^f: y missing in the arguments$"):
        function(backend, [x + y], (x,), "f")


@pytest.mark.parametrize(
    ("backend", "says"),
    [
        ("numba", "numba is not installed: pip install 'rigidtop[numba]'"),
        (
            "heyoka",
            "heyoka is not installed: pip install 'rigidtop[taylor]' (wheels for Linux only)",
        ),
    ],
)
def test_a_missing_package_has_one_line(monkeypatch, backend, says):
    monkeypatch.setitem(sys.modules, backend, None)
    with pytest.raises(RigidtopError) as caught:
        function(backend, [x], (x,), "f")
    assert str(caught.value) == says
