"""Expressions become functions, and their text is what runs."""

import math

import numpy as np
import pytest
from sympy import Add, Integer, Matrix, Rational, Symbol, cos, sin, sqrt, symbols

from rigidtop.codegen.numpy import function

x, y, lambda1 = symbols("x y lambda1")
EXPRESSIONS = [
    sin(x) ** 2 / 2 / lambda1 + sqrt(lambda1) * Rational(3, 7) * y,
    -Rational(1, 2) * (x * y + cos(x)),
    Rational(3, 2) * x * sin(x) * lambda1,
    Integer(4),
]
POINT = (0.7, -1.3, 2.5)
VALUES = [
    math.sin(0.7) ** 2 / 5 - math.sqrt(2.5) * 3 / 7 * 1.3,
    -(0.7 * -1.3 + math.cos(0.7)) / 2,
    1.5 * 0.7 * math.sin(0.7) * 2.5,
    4,
]


@pytest.fixture(scope="module")
def made():
    return function(EXPRESSIONS, (x, y, lambda1), "example")


def test_scalar_and_array_give_the_values(made):
    assert made.scalar(*POINT) == pytest.approx(VALUES, rel=1e-15)
    assert made.array(*POINT) == pytest.approx(VALUES, rel=1e-15)


def test_scalar_returns_floats_of_python(made):
    assert {type(value) for value in made.scalar(*POINT)} <= {float, int}


def test_arrays_broadcast_and_constants_with_them(made):
    result = made.array(np.full((5, 1), 0.7), np.full(3, -1.3), 2.5)
    assert result.shape == (4, 5, 3)
    assert result == pytest.approx(np.broadcast_to(np.array(VALUES)[:, None, None], (4, 5, 3)))


def test_source_runs_and_gives_the_same(made):
    names = {"sin": math.sin, "cos": math.cos, "sqrt": math.sqrt}
    exec(made.source, names)
    assert names["example"](*POINT) == pytest.approx(made.scalar(*POINT), rel=1e-15)


def test_source_on_symbols_is_exact(made):
    names = {"sin": sin, "cos": cos, "sqrt": sqrt}
    exec(made.source, names)
    assert names["example"](x, y, lambda1)[1:] == tuple(EXPRESSIONS[1:])


def test_names_of_parameters_are_those_of_the_symbols(made):
    assert made.source.splitlines()[0] == "def example(x, y, lambda1):"


def test_operations_count_shared_parts_once():
    # x0 = sin(x): a call; x0 + 1, x0 - 1, and y * x0 ** 2
    assert function([sin(x) + 1, sin(x) - 1, y * sin(x) ** 2], (x, y), "f").operations == 5


def test_a_matrix_is_taken_entry_by_entry():
    assert function(Matrix([x, y]), (x, y), "f").scalar(1.0, 2.0) == (1.0, 2.0)


def test_a_symbol_that_is_no_argument_is_named():
    with pytest.raises(ValueError, match=r"^f: y missing in the arguments$"):
        function([x + y], (x,), "f")


@pytest.mark.parametrize("name", ["lambda", "1st", "two words"])
def test_names_must_be_identifiers(name):
    with pytest.raises(ValueError, match="cannot be a name in Python"):
        function([Symbol("z")], (Symbol("z"),), name)


def test_long_sums_are_broken_at_their_signs():
    terms = symbols(" ".join(f"quantity{k}" for k in range(14)))
    weighed = sum(k * term for k, term in enumerate(terms))
    source = function([weighed, terms[0]], terms, "f").source
    assert max(map(len, source.splitlines())) <= 100
    names = {}
    exec(source, names)
    assert names["f"](*range(14)) == (sum(k * k for k in range(14)), 0)


def test_a_sum_of_thousands_of_terms_is_one_too():
    """Python's own compiler fails at about 3,000."""
    letters = symbols("a:3000")
    made = function([y * Add(*letters)], (y, *letters), "long")
    assert made(0.5, *range(3000)) == pytest.approx([0.25 * 2999 * 3000], rel=1e-12)
    assert made.source.count(" +") > 2900
