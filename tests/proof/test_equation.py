"""What a printed tree says, and that it stays as it is typed."""

import pytest
import sympy
from sympy import Integer, Matrix, cos, eye, sin, symbols

from rigidtop.proof.equation import (
    Cross,
    Dot,
    Equation,
    Group,
    NoMeaningError,
    Rate,
    SumOver,
    Transposed,
    Underbrace,
    VolumeIntegral,
    as_printed,
    symbols_of,
    value,
)

a, b, c, k, d3r = symbols("a b c k d3r")
v, w, turn = symbols("v w O")
VECTORS = {v: Matrix([1, 2, 3]), w: Matrix([-1, 0, 4])}


def test_typed_order_stays():
    with as_printed():
        side = Equation(c, b * a + a - b).sides[1]
    first, last = side.args
    assert (first.args[0].args, first.args[1], last) == ((b, a), a, -b)


def test_nothing_is_evaluated_until_it_has_a_meaning():
    with as_printed():
        zero = Equation(0, a - a).sides[1]
    assert zero != 0
    assert value(zero, {}) == 0


def test_values_of_numbers():
    with as_printed():
        tree = Group(a + b) * a**2 - Underbrace(sin(c), b) / 2
    assert value(tree, {a: 3, b: 4, c: sympy.pi / 2}) == Integer(63) - sympy.Rational(1, 2)


def test_values_of_vectors():
    assert value(Cross(v, w), VECTORS) == Matrix([8, -7, 2])
    assert value(Cross(w, v), VECTORS) == -Matrix([8, -7, 2])
    assert value(Dot(v, w), VECTORS) == 11
    assert value(Dot(v, Cross(v, w)), VECTORS) == 0


def test_scalars_multiply_vectors_in_any_order():
    with as_printed():
        tree = a * v - w * b / 2
    assert value(tree, {**VECTORS, a: 2, b: 6}) == Matrix([5, 4, -6])


def test_products_of_matrices_keep_their_order():
    first, second = Matrix([[0, 1], [0, 0]]), Matrix([[0, 0], [1, 0]])
    with as_printed():
        tree = v * w
    found = value(tree, {v: first, w: second})
    assert found == (first * second if tree.args == (v, w) else second * first)
    assert value(Transposed(turn), {turn: first}) == second


def test_matrices_entry_by_entry():
    with as_printed():
        tree = Matrix([[a, b], [0, a * b]])
    assert value(tree, {a: 2, b: 3}) == Matrix([[2, 3], [0, 6]])


def test_sum_over_particles():
    terms = [{a: 1, b: 10}, {a: 2, b: 100}, {a: -3, b: 1000}]
    assert value(SumOver(k, a * b + c), {k: terms, c: 7}) == 10 + 200 - 3000 + 21


def test_integral_is_done_by_its_measure():
    x = symbols("x")

    def measure(body):
        return sympy.integrate(body, (x, 0, 2))

    assert value(VolumeIntegral(d3r, a * v), {d3r: measure, v: x**2, a: 3}) == 8


def test_rate_needs_a_meaning_of_its_own():
    rate = Rate(v, symbols("space"))
    assert value(2 * rate, {**VECTORS, rate: Matrix([1, 0, 0])}) == Matrix([2, 0, 0])
    with pytest.raises(NoMeaningError, match="has no meaning here: give it one"):
        value(rate, VECTORS)


def test_a_symbol_without_meaning_stands_for_itself():
    assert value(a + cos(b), {a: c}) == c + cos(b)


def test_the_innermost_meaning_wins_in_a_sum():
    assert value(SumOver(k, a), {a: 5, k: [{a: 1}, {a: 2}]}) == 3


def test_equation_needs_two_sides():
    with pytest.raises(ValueError, match="an equation has at least two sides"):
        Equation(a)


def test_equation_holds_sympy_and_its_symbols():
    chain = Equation(0, a, Matrix([b, 1]), relation="≈", tag="9.9")
    assert chain.sides[0] == Integer(0)
    assert (chain.relation, chain.tag) == ("≈", "9.9")
    assert symbols_of(chain) == {a, b}


def test_unit_matrix_is_the_unit_of_the_product():
    one = symbols("unit")
    assert value(one * turn, {one: eye(3), turn: 2 * eye(3)}) == 2 * eye(3)
