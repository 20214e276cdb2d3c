"""(3.57): both roots, to rounding, everywhere; the threshold below which there is none."""

import math
from fractions import Fraction

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import rigidtop as rt

EXAMPLE = rt.HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5)


ZERO = st.just(0.0)


def numbers(low, high):
    return st.floats(low, high)


@st.composite
def tops(draw, weightless=ZERO):
    lambda3, mass = draw(numbers(0.01, 100)), draw(numbers(0.01, 100))
    arm = draw(weightless | numbers(0.001, 10))
    across = lambda3 / 2 + draw(numbers(0, 100))
    return rt.HeavyTop(
        lambda1=across + mass * arm**2 + 1e-6,
        lambda3=lambda3,
        M=mass,
        R=arm,
        g=draw(weightless | numbers(0.001, 100)),
    )


def imbalance(top, theta, omega3, rate):
    """The quadratic over the sum of its magnitudes, in exact arithmetic on the given floats."""
    a = Fraction(top.lambda1) * Fraction(math.cos(theta))
    b = Fraction(top.lambda3) * Fraction(omega3)
    c = Fraction(top.M) * Fraction(top.g) * Fraction(top.R)
    terms = a * Fraction(rate) ** 2, -b * Fraction(rate), c
    size = sum(map(abs, terms))
    return float(abs(sum(terms)) / size) if size else 0.0


@given(tops(), numbers(0, math.pi), st.floats(-1e9, 1e9))
def test_both_rates_balance_to_rounding(top, theta, omega3):
    assume(abs(math.cos(theta)) > 1e-15)
    assume(abs(omega3) > 1e-9)
    try:
        slow, fast = top.steady_precession(theta, omega3)
    except rt.NoSteadyPrecession:
        assert abs(omega3) <= top.smallest_spin(theta)
        return
    assert abs(omega3) >= top.smallest_spin(theta) * (1 - 1e-15)
    assert abs(slow) <= abs(fast) * (1 + 1e-15)
    assert imbalance(top, theta, omega3, slow) < 4e-15
    assert imbalance(top, theta, omega3, fast) < 4e-15


@given(tops(), numbers(0, math.pi), st.floats(0.01, 1e6))
def test_rates_change_sign_with_the_spin(top, theta, above):
    omega3 = top.smallest_spin(theta) + above
    slow, fast = top.steady_precession(theta, omega3)
    assert top.steady_precession(theta, -omega3) == (-slow, -fast)


@given(tops(weightless=st.nothing()), numbers(0, 1.57))
def test_at_the_threshold_both_rates_are_one(top, theta):
    smallest = top.smallest_spin(theta)
    slow, fast = top.steady_precession(theta, smallest)
    assert slow == pytest.approx(fast, rel=1e-6)
    with pytest.raises(rt.NoSteadyPrecession):
        top.steady_precession(theta, smallest * (1 - 1e-12))


def test_below_the_threshold_the_message_names_the_smallest_spin():
    smallest = 2 * math.sqrt(1.0 * 9.81 * 0.5 * math.cos(1.0)) / 0.5
    with pytest.raises(rt.NoSteadyPrecession) as caught:
        EXAMPLE.steady_precession(theta=1.0, omega3=0.3)
    message = str(caught.value)
    assert "\n" not in message
    named = float(message.split("at least ")[1].split()[0])
    assert smallest <= named <= smallest * (1 + 1e-8)
    assert len(EXAMPLE.steady_precession(1.0, named)) == 2
    assert isinstance(caught.value, ValueError)


def test_large_spin_loses_no_digits():
    """For ω₃ → ∞ the slow rate is MgR/(λ₃ω₃)(1 + ε + …), the fast one λ₃ω₃/(λ₁cos θ)(1 − ε − …)."""
    omega3, theta = 1e7, 0.7
    slow, fast = EXAMPLE.steady_precession(theta, omega3)
    epsilon = 4.905 * math.cos(theta) / (0.5 * omega3) ** 2
    assert slow == pytest.approx(4.905 / (0.5 * omega3) * (1 + epsilon), rel=1e-15)
    assert fast == pytest.approx(0.5 * omega3 / math.cos(theta) * (1 - epsilon), rel=1e-15)


@pytest.mark.parametrize("spin", [1e8, 1e50, 1e100])
def test_spins_as_large_as_can_be(spin):
    slow, fast = EXAMPLE.steady_precession(1.0, spin)
    assert slow == pytest.approx(9.81 / spin, rel=1e-14)
    assert fast == pytest.approx(0.5 * spin / math.cos(1.0), rel=1e-14)


def test_momenta_beyond_the_square_root_of_the_largest_float():
    top = rt.HeavyTop(lambda1=1e100, lambda3=1e100, M=1.0, R=0.5)
    slow, fast = top.steady_precession(1.0, 1e100)
    assert slow == pytest.approx(4.905e-200, rel=1e-14)
    assert fast == pytest.approx(1e100 / math.cos(1.0), rel=1e-14)


def test_level_axis_has_one_rate():
    assert EXAMPLE.steady_precession(math.pi / 2, 3.0) == (pytest.approx(4.905 / 1.5), math.inf)
    assert EXAMPLE.steady_precession(math.pi / 2, -3.0) == (pytest.approx(-4.905 / 1.5), -math.inf)
    with pytest.raises(rt.NoSteadyPrecession, match=r"omega3\| must be more than 0$"):
        EXAMPLE.steady_precession(math.pi / 2, 0.0)


def test_hanging_top_has_rates_of_both_signs_for_any_spin():
    slow, fast = EXAMPLE.steady_precession(2.0, 1.0)
    assert slow > 0 > fast
    assert EXAMPLE.smallest_spin(2.0) == 0


def test_without_spin_it_is_a_conical_pendulum():
    rate = math.sqrt(4.905 / -math.cos(2.0))
    assert EXAMPLE.steady_precession(2.0, 0.0) == (pytest.approx(rate), pytest.approx(-rate))


@pytest.mark.parametrize("change", [{"g": 0.0}, {"R": 0.0}])
def test_without_torque_it_stands_or_precesses_freely(change):
    top = rt.HeavyTop(**{"lambda1": 1.0, "lambda3": 0.5, "M": 1.0, "R": 0.5, **change})
    assert top.steady_precession(1.0, 4.0) == (0.0, pytest.approx(2 / math.cos(1.0)))
    assert top.steady_precession(1.0, 0.0) == (0.0, 0.0)
    assert top.smallest_spin(1.0) == top.sleeping_spin() == 0


def test_sleeping_spin():
    assert EXAMPLE.sleeping_spin() == pytest.approx(2 * math.sqrt(4.905) / 0.5, rel=1e-15)
    assert EXAMPLE.sleeping_spin() == EXAMPLE.smallest_spin(0.0)


@pytest.mark.parametrize("theta", [0.6, 2.0])
@pytest.mark.parametrize("root", [0, 1])
def test_started_on_a_root_it_holds_the_tilt_for_20_turns(theta, root):
    rate = EXAMPLE.steady_precession(theta, 12.0)[root]
    turns = [k * 2 * math.pi / abs(rate) for k in (0.1, 1.3, 10, 19.7, 20)]
    run = EXAMPLE.motion(theta=theta, phi_dot=rate, omega3=12.0).integrate(turns)
    assert abs(run.theta - theta).max() < 1e-9
    assert abs(run.phi - rate * run.t).max() < 1e-7
    assert abs(run.phi_dot - rate).max() < 1e-8 * abs(rate)
    assert abs(run.psi - (12.0 - rate * math.cos(theta)) * run.t).max() < 1e-7
