"""The gyroscope and the bicycle wheel."""

from math import acos, pi, sqrt

import pytest


def test_gyroscope_of_young_and_freedman(solve):
    """University Physics, 11th edition, problem 10.48: 0.165 kg at 4.00 cm, I = 1.20·10⁻⁴ kg m².

    One turn in 2.20 s takes 188.7 rad/s, or 1.80·10³ rev/min.
    """
    radius = sqrt(2 * 1.20e-4 / 0.165)
    found = solve("gyroscope", M=0.165, radius=radius, R=0.04, g=9.80, omega3=188.7, theta=pi / 2)
    assert found["lambda3"] == pytest.approx(1.20e-4)
    assert found["period"] == pytest.approx(2.20, abs=0.005)
    assert found["exact"] == pytest.approx(found["simple"], rel=1e-14)


def test_a_horizontal_gyroscope_has_no_least_spin(solve):
    """Any goes round, at MgR/(λ₃ω₃), and 0 falls: no number is the smallest."""
    found = solve("gyroscope", theta=pi / 2, omega3=1e-6)
    assert found["smallest_spin"] == found["spin_needed"] == "more than 0"
    assert found["off"] == pytest.approx(0, abs=1e-15)
    assert solve("gyroscope", theta=1.5)["smallest_spin"] > 0
    assert solve("gyroscope", theta=1.6)["smallest_spin"] == 0


def test_wheel_on_a_long_cord_is_a_conical_pendulum(solve):
    """Huygens, Horologium Oscillatorium V: cos β = g/(Ω²ℓ). Here Ω²ℓ = 2g."""
    rate, length, radius, R = sqrt(9.81), 2.0, 0.31, 1e-9
    spin = 9.81 * R / (radius**2 * rate)
    found = solve("bicycle-wheel", cord=length, R=R, omega3=spin, M=1.0)
    assert found["lean"] == pytest.approx(acos(0.5), rel=1e-8)
    assert found["tension"] == pytest.approx(2 * 9.81, rel=1e-8)


def test_fast_wheel_nods_at_the_frequency_of_its_spin(solve):
    """Goldstein, Classical Mechanics, § 5.7: at I₃ω₃/I₁, and by 2I₁Mgl sin θ/(I₃ω₃)² in all."""
    found = solve("bicycle-wheel", omega3=400)
    # A hoop about a diameter has half of what it has about its axis; and Steiner.
    lambda1, momentum = 1.5 * (0.31**2 / 2 + 0.15**2), 1.5 * 0.31**2 * 400
    assert found["dip_period"] == pytest.approx(2 * pi * lambda1 / momentum, rel=1e-6)
    assert found["dip"] == pytest.approx(2 * lambda1 * 1.5 * 9.81 * 0.15 / momentum**2, rel=1e-6)
