"""The upright top of section 3.5.4."""

from math import log, pi

import pytest

# λ₁ = 1, λ₃ = ½, MgR = 4.
LIGHT = {"lambda1": 1, "lambda3": 0.5, "M": 1, "R": 0.5, "g": 8}


def test_sleeping_spin_in_whole_numbers(solve):
    """ω₃² = 4·1·4/0.25 (Goldstein 5.7, the sleeping top), and turns a minute of 8 rad/s."""
    found = solve("sleeping-top", **LIGHT, omega3=10)
    assert found["sleeping_spin"] == pytest.approx(8, rel=1e-15)
    assert found["sleeping_rpm"] == pytest.approx(480 / (2 * pi), rel=1e-15)
    assert (found["slow_wobble"], found["fast_wobble"]) == pytest.approx((1, 4), rel=1e-14)
    assert found["tilt"] == 1e-8


def test_each_tenth_of_the_disturbance_costs_a_logarithm(solve):
    slow, slower = (solve("sleeping-top", disturbance=tilt) for tilt in (1e-10, 1e-11))
    gain = 2 * log(10) / slow["growth_rate"]
    assert slower["period"] - slow["period"] == pytest.approx(gain, rel=1e-12)
    assert slow["period"] == pytest.approx(slow["period_log"], rel=1e-14)
