"""Numbers for letters: expressions have SymPy's values there, and equations hold."""

import numpy as np
import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st
from sympy import Symbol, cos, exp, log, sin, sqrt

from rigidtop.judge import program as home
from rigidtop.judge.jets import TIME, Jet, at_instant, jet_of, jets, rate, symbol
from rigidtop.judge.program import Program, Steps, UnknownFunctionError
from rigidtop.judge.worlds import WORLDS, Worlds, found, rank, symbols_of
from rigidtop.tree.nodes import Letter

X, Y, Z = LETTERS = sympy.symbols("x y z", real=True)
COMPLEX = {sympy.Abs, sympy.sign, sympy.re, sympy.im, sympy.conjugate}
"""What has no slope in the complex plane."""

SMOOTH = [function for function in home._FUNCTIONS if function not in COMPLEX]
EXPRESSIONS = {
    "sum": X - 2 * Y + sympy.pi,
    "product": X * Y * Z / 3,
    "power": X**3 * Y**-2,
    "root": sqrt(X**2 + Y**2),
    "moving exponent": (2 + X) ** Y,
    "nested": sin(X * exp(-Y)) / (1 + log(2 + Z) ** 2),
    "imaginary": exp(sympy.I * X) * (Y - sympy.I * Z),
    "number": sympy.Rational(2, 7) + sympy.E,
} | {function.__name__: function((X * Y + Z) / 7) for function in SMOOTH}


def points(seed, count=5):
    return np.random.default_rng(seed).uniform(0.4, 1.4, (len(LETTERS), count)) + 0j


def numbers(expression, at):
    """The values of SymPy."""
    return [
        complex(sympy.N(expression.subs(dict(zip(LETTERS, map(float, column.real), strict=True)))))
        for column in at.T
    ]


@pytest.mark.parametrize("expression", EXPRESSIONS.values(), ids=EXPRESSIONS)
def test_values_and_slopes_are_those_of_sympy(expression):
    # arcosh has a value from 1 on
    at = points(1) + 2 if expression.has(sympy.acosh) else points(1)
    made = Steps([expression], LETTERS).at(at)
    assert made.values[0] == pytest.approx(numbers(expression, at), rel=1e-11)
    for k, letter in enumerate(LETTERS):
        slope = numbers(expression.diff(letter), at)
        assert made.slopes[0, k] == pytest.approx(slope, rel=1e-10, abs=1e-13), letter


@pytest.mark.parametrize(
    "function", sorted(COMPLEX, key=str), ids=lambda function: function.__name__
)
def test_values_of_what_has_no_slope_are_those_of_sympy(function):
    expression = function(X - sympy.I * Y + 1)
    if function is sympy.sign:
        expression = function(X - Y)
    at = points(2)
    [made] = Program(LETTERS, at).values([expression]).values
    assert made == pytest.approx(numbers(expression, at), rel=1e-12)


SUMS = st.recursive(
    st.sampled_from(LETTERS) | st.integers(-3, 3).map(sympy.Integer),
    lambda below: st.one_of(
        st.tuples(below, below).map(lambda pair: pair[0] + pair[1]),
        st.tuples(below, below).map(lambda pair: pair[0] * pair[1]),
        below.map(sin),
        below.map(lambda x: x**2),
    ),
    max_leaves=5,
)


@given(expression=SUMS, seed=st.integers(0, 99))
def test_random_expressions_have_the_values_of_sympy(expression, seed):
    at = points(seed, count=1)
    made = Steps([expression], LETTERS).at(at)
    assert made.values[0] == pytest.approx(numbers(expression, at), rel=1e-9, abs=1e-9)
    slopes = [numbers(expression.diff(x), at)[0] for x in LETTERS]
    assert made.slopes[0, :, 0] == pytest.approx(slopes, rel=1e-9, abs=1e-9)
    assert abs(made.values[0, 0]) <= made.sizes[0, 0] * (1 + 1e-12)


def test_a_difference_has_the_size_of_its_terms():
    made = Program(LETTERS, points(3)).values([1000 * X - 1000 * X * Y / Z])
    assert (made.sizes > 100).all()


def test_steps_have_the_values_of_what_is_looked_up():
    expressions = [*EXPRESSIONS.values(), X, sympy.Integer(2), Y**sympy.pi, 2**X, X**X]
    one = Program(LETTERS, points(1) + 2).values(expressions)
    other = Steps(expressions, LETTERS).at(points(1) + 2)
    assert other.values == pytest.approx(one.values, rel=1e-12)
    assert other.sizes == pytest.approx(one.sizes, rel=1e-12)


def test_a_power_of_zero_has_a_slope():
    at = Steps([X**3 * Y, X * Y], (X, Y)).at(np.array([[0.0], [2.0]], complex))
    assert at.slopes[:, :, 0].tolist() == [[0, 0], [2, 0]]


def test_a_function_of_no_known_name_has_no_numbers():
    with pytest.raises(UnknownFunctionError):
        Program(LETTERS, points(4)).values([sympy.Function("f")(X)])


# --- Worlds --------------------------------------------------------------------------------------


def jet(base, order=0, **more):
    return symbol(Jet(Letter(base), order, **more))


M, G, L, K = map(jet, "mglk")
Q = [jet("θ", order) for order in range(3)]
P = [jet("x", order) for order in range(3)]
EQUATIONS = {
    "a pendulum": [L * Q[2] + G * sin(Q[0])],
    "two coordinates": [
        M * P[2] + M * L * (cos(Q[0]) * Q[2] - sin(Q[0]) * Q[1] ** 2) + K * P[0],
        L * Q[2] + cos(Q[0]) * P[2] + G * sin(Q[0]),
    ],
    "a tie with its rates": [
        P[0] - L * sin(Q[0]),
        P[1] - L * cos(Q[0]) * Q[1],
        P[2] - L * cos(Q[0]) * Q[2] + L * sin(Q[0]) * Q[1] ** 2,
    ],
    "an equation twice": [M * P[2] + K * P[0], 2 * M * P[2] + 2 * K * P[0]],
    "roots": [M * X**2 - 2 * K * X + G],
    "none that is real": [Q[0] - sqrt(-1 - M**2)],
}


@pytest.mark.parametrize("equations", EQUATIONS.values(), ids=EQUATIONS)
def test_equations_hold_in_the_worlds_that_are_found(equations):
    letters = symbols_of(equations)
    worlds = found(equations, letters)
    assert 2 <= worlds.count <= WORLDS
    made = Program(letters, worlds.points).values(equations)
    assert (np.abs(made.values) <= 1e-10 * (1 + made.sizes)).all()
    assert worlds.holds([(each, 0 * each) for each in equations]) is True
    assert worlds.holds([(equations[0] + letters[0], sympy.Integer(0))]) is False


def test_worlds_are_always_the_same():
    equations = EQUATIONS["two coordinates"]
    one, other = (found(equations, symbols_of(equations)).points for _ in range(2))
    assert (one == other).all()


def test_worlds_are_real_where_they_can_be():
    equations = EQUATIONS["a pendulum"]
    assert not found(equations, symbols_of(equations)).points.imag.any()


def test_no_world_is_where_equations_contradict_each_other():
    worlds = found([P[0] - 1, P[0] - 2], [P[0]])
    assert worlds.count == 0
    assert worlds.holds([(P[0], P[0])]) is None


def test_a_parameter_vanishes_only_where_it_may():
    assert found([K * M], [K, M]).count == 0
    assert found([K * M], [K, M], may_vanish=[Letter("k")]).count


def test_what_is_not_zero_is_not_zero():
    worlds = found([P[0] * (P[0] - 3)], [P[0]], not_zero=[P[0]])
    assert worlds.points == pytest.approx(3)


def test_what_is_asked_of_other_letters_has_no_answer():
    worlds = found([P[0] - 1], [P[0]])
    assert worlds.holds([(P[0], Q[0])]) is None
    assert worlds.signs([Q[0]]) is None


def test_one_of_several_pairs_holds_in_every_world():
    worlds = found([P[0] ** 2 - M**2], [P[0], M])
    assert worlds.holds_one([(P[0], M), (P[0], -M)])
    assert not worlds.holds_one([(P[0], 2 * M), (P[0], -2 * M)])


def test_signs():
    worlds = found([P[0] - 3], [P[0]])
    assert worlds.signs([P[0] - 2, P[0] - 4]).T.tolist() == [[1, -1]] * worlds.count


@pytest.mark.parametrize(
    ("equations", "by", "expected"),
    [
        ([P[2] + K * P[0], Q[2] - P[2]], [P[2], Q[2]], 2),
        ([P[2] + K * P[0], 2 * P[2] + 2 * K * P[0]], [P[2]], 1),
        ([P[2] + K * P[0], Q[2] - P[2]], [Q[2]], 1),
        ([P[2] + K * P[0]], [Q[0]], 0),
        ([], [P[2]], 0),
        ([P[2]], [], 0),
    ],
    ids=["independent", "the same twice", "of one letter", "of another", "none", "no letters"],
)
def test_rank(equations, by, expected):
    letters = symbols_of([*equations, *by])
    at = np.random.default_rng(0).uniform(0.5, 1.5, (len(letters), 1)) + 0j
    assert rank(equations, Worlds(letters, at), by) == expected


# --- Jets ----------------------------------------------------------------------------------------

JETS = st.builds(
    Jet,
    st.builds(
        Letter,
        st.sampled_from(["x", "θ", "Ek"]),
        st.sampled_from(["", "1", "max,2"]),
        st.sampled_from(["", "hat", "′"]),
        st.booleans(),
    ),
    st.integers(0, 4),
    st.lists(st.integers(0, 12), max_size=2).map(tuple),
    st.sampled_from(["", "start", "s3"]),
)


@given(one=JETS, other=JETS)
def test_a_symbol_tells_what_number_it_is(one, other):
    assert jet_of(symbol(one)) == one
    assert (symbol(one) == symbol(other)) == (one == other)


def test_the_time_and_other_symbols_are_no_jets():
    assert jet_of(TIME) is None
    assert jet_of(Symbol("x")) is None
    assert jets(TIME + X + Q[1]) == {Q[1]: Jet(Letter("θ"), 1)}


def test_the_rate_of_what_moves():
    moving = frozenset({Letter("θ")})
    assert rate(L * sin(Q[0]) * TIME, moving) == L * sin(Q[0]) + L * TIME * cos(Q[0]) * Q[1]
    assert rate(Q[1] ** 2 / 2 + K, moving) == Q[1] * Q[2]


def test_another_moment_has_other_values_of_what_moves():
    then = at_instant(L * Q[0] + TIME * Q[1], "start", frozenset({Letter("θ")}), sympy.Integer(0))
    assert then == L * jet("θ", instant="start")


def test_of_sides_that_would_round_everything_away_nothing_is_seen():
    worlds = Worlds(LETTERS, np.full((len(LETTERS), 4), 0.7 + 0j))
    huge = 2 * sympy.Integer(10) ** 30 * (X - Y)
    assert worlds.holds([(huge, Z)]) is None
    assert worlds.holds([(huge, Z)], trivially=False) is False
    assert worlds.holds([(X, Y)], trivially=False)


TINY = sympy.Rational(1, 10**45)


@pytest.mark.parametrize("equations", EQUATIONS.values(), ids=EQUATIONS)
def test_equations_hold_with_many_digits_where_that_is_asked(equations):
    worlds = found(equations, symbols_of(equations))
    assert worlds.holds([(each + TINY, TINY) for each in equations]) is True
    assert worlds.holds([(each + TINY, 0 * each) for each in equations]) is False


def test_where_equations_are_not_known_nothing_is_seen_of_small_numbers():
    worlds = found(EQUATIONS["a pendulum"], symbols_of(EQUATIONS["a pendulum"]))
    bare = Worlds(worlds.letters, worlds.points)
    assert bare.holds([(G + TINY, G + TINY)]) is None
    assert bare.holds([(G + TINY, 2 * G)]) is False


def test_a_place_that_does_not_come_nearer_is_not_known():
    equations = [(P[0] - M) ** 2, M**2 - G - TINY * K]
    worlds = found(equations, symbols_of(equations))
    assert worlds.count
    assert worlds.holds([(M**2, G + TINY * K)]) is None


@pytest.mark.parametrize("factor", [1, 10**9, TINY])
def test_where_something_divides_that_vanishes_nothing_is_seen(factor):
    worlds = found([Q[0] - sympy.pi / 2], [Q[0], M])
    half = (1 - sqrt(1 - cos(Q[0]))) / cos(Q[0])
    assert not worlds.holds([(factor * half, factor * M)])
    assert not worlds.holds([(factor * half / cos(Q[0]), factor * M / cos(Q[0]))])
