"""The upright top of section 3.5.4."""

from math import log, pi, sin, sqrt

import pytest

from rigidtop.errors import RigidtopError

# λ₁ = 1, λ₃ = ½, MgR = 4.
LIGHT = {"lambda1": 1, "lambda3": 0.5, "M": 1, "R": 0.5, "g": 8}


def test_sleeping_spin_in_whole_numbers(solve):
    """ω₃² = 4·1·4/0.25 (Goldstein 5.7, the sleeping top), and turns a minute of 8 rad/s."""
    found = solve("sleeping-top", **LIGHT, omega3=10)
    assert found["sleeping_spin"] == pytest.approx(8, rel=1e-15)
    assert found["sleeping_rpm"] == pytest.approx(480 / (2 * pi), rel=1e-15)
    assert (found["slow_wobble"], found["fast_wobble"]) == pytest.approx((1, 4), rel=1e-14)
    assert found["tilt"] == 1e-8


@pytest.mark.parametrize(("share", "tilt"), [(0.5, 120), (sqrt(0.5), 90), (sqrt(0.75), 60)])
def test_a_slow_top_wakes_to(solve, share, tilt):
    """2·4·(1 + cos θ) = (λ₃ω₃)², in degrees; then σ² = MgR(1 − cos θ)/(2λ₁)."""
    found = solve("sleeping-top", **LIGHT, omega3=8 * share)
    assert found["tilt"] == pytest.approx(tilt * pi / 180, rel=1e-14)
    assert found["growth_rate"] == pytest.approx(2 * sin(tilt * pi / 360), rel=1e-14)


def test_each_tenth_of_the_disturbance_costs_a_logarithm(solve):
    slow, slower = (solve("sleeping-top", disturbance=tilt) for tilt in (1e-10, 1e-11))
    gain = 2 * log(10) / slow["growth_rate"]
    assert slower["period"] - slow["period"] == pytest.approx(gain, rel=1e-12)
    assert slow["period"] == pytest.approx(slow["period_log"], rel=1e-14)


def test_without_spin_it_topples(solve):
    """From the disturbance to the hanging position, as example 34 has it."""
    found = solve("sleeping-top", omega3=0, disturbance=1e-3)
    falls = solve("toppling-top", theta=1e-3, until=pi)
    assert found["tilt"] == pytest.approx(pi, rel=1e-14)
    assert found["period"] / 2 == pytest.approx(falls["time_to_fall"], rel=1e-12)
    assert found["growth_rate"] == falls["growth_rate"]


def test_spin_that_does_not_show_whether_it_sleeps(solve):
    with pytest.raises(RigidtopError, match="so close to the sleeping spin 8"):
        solve("sleeping-top", **LIGHT, omega3=8 * (1 - 1e-9), disturbance=0.01)
