"""The gyroscope and the bicycle wheel."""

from math import acos, pi, radians, sqrt

import numpy as np
import pytest

from rigidtop.errors import NoSteadyPrecession, RigidtopError
from rigidtop.motion.top import HeavyTop


def test_gyroscope_of_young_and_freedman(solve):
    """University Physics, 11th edition, problem 10.48: 0.165 kg at 4.00 cm, I = 1.20·10⁻⁴ kg m².

    One turn in 2.20 s takes 188.7 rad/s, or 1.80·10³ rev/min.
    """
    radius = sqrt(2 * 1.20e-4 / 0.165)
    found = solve("gyroscope", M=0.165, radius=radius, R=0.04, g=9.80, omega3=188.7, theta=pi / 2)
    assert found["lambda3"] == pytest.approx(1.20e-4)
    assert found["period"] == pytest.approx(2.20, abs=0.005)
    assert found["exact"] == pytest.approx(found["simple"], rel=1e-14)


def test_gyroscope_at_an_angle_goes_as_its_motion_does(solve):
    """Set going at the exact rate, θ stays; at that of (3.52) it does not."""
    found = solve("gyroscope")
    top = HeavyTop(lambda1=found["lambda1"], lambda3=found["lambda3"], M=0.17, R=0.105)
    for rate, stays in ((found["exact"], True), (found["simple"], False)):
        motion = top.motion(theta=pi / 3, phi_dot=rate, omega3=90 * pi)
        moved = motion.integrate(np.linspace(0, found["period"], 50), rtol=1e-11, atol=1e-13)
        assert (np.ptp(moved.theta) < 1e-8) == stays
    assert found["good"] == "no"
    assert solve("gyroscope", omega3=1.001 * found["spin_needed"])["good"] == "yes"
    assert solve("gyroscope", omega3=0.999 * found["spin_needed"])["good"] == "no"


def test_gyroscope_below_the_horizontal_is_slower(solve):
    found = solve("gyroscope", theta=radians(120), omega3=-90 * pi)
    assert found["off"] < 0
    assert found["direction"] == "clockwise"
    assert (
        solve("gyroscope", theta=radians(120), omega3=1.001 * found["spin_needed"])["good"] == "yes"
    )


def test_a_horizontal_gyroscope_has_no_least_spin(solve):
    """Any goes round, at MgR/(λ₃ω₃), and 0 falls: no number is the smallest."""
    found = solve("gyroscope", theta=pi / 2, omega3=1e-6)
    assert found["smallest_spin"] == found["spin_needed"] == "more than 0"
    assert found["off"] == pytest.approx(0, abs=1e-15)
    assert solve("gyroscope", theta=1.5)["smallest_spin"] > 0
    assert solve("gyroscope", theta=1.6)["smallest_spin"] == 0


def test_gyroscopes_that_fall(solve):
    with pytest.raises(NoSteadyPrecession, match=r"\|omega3\| must be at least 103"):
        solve("gyroscope", omega3=100)
    for name in ("gyroscope", "bicycle-wheel"):
        with pytest.raises(RigidtopError, match="omega3 must not be 0"):
            solve(name, omega3=0)


def test_wheel_goes_round_as_its_angular_momentum_must(solve):
    """ΔL = N Δt along ŷ for L along x̂: anticlockwise, N/L = MgR/(Mr²ω) = 10·0.2/(0.25·16)."""
    found = solve("bicycle-wheel", radius=0.5, R=0.2, omega3=16, g=10)
    assert found["precession"] == pytest.approx(0.5, rel=1e-14)
    assert found["direction"] == "anticlockwise"


def test_wheel_on_a_long_cord_is_a_conical_pendulum(solve):
    """Huygens, Horologium Oscillatorium V: cos β = g/(Ω²ℓ). Here Ω²ℓ = 2g."""
    rate, length, radius, R = sqrt(9.81), 2.0, 0.31, 1e-9
    spin = 9.81 * R / (radius**2 * rate)
    found = solve("bicycle-wheel", cord=length, R=R, omega3=spin, M=1.0)
    assert found["lean"] == pytest.approx(acos(0.5), rel=1e-8)
    assert found["tension"] == pytest.approx(2 * 9.81, rel=1e-8)


def test_force_on_a_wheel_without_cord_is_that_of_a_circle(solve):
    """Mg and MΩ²R, at right angles."""
    found = solve("bicycle-wheel", cord=0, omega3=2.0)
    across = 1.5 * found["precession"] ** 2 * 0.15
    assert found["tension"] == pytest.approx(np.hypot(1.5 * 9.81, across), rel=1e-14)


def test_fast_wheel_nods_at_the_frequency_of_its_spin(solve):
    """Goldstein, Classical Mechanics, § 5.7: at I₃ω₃/I₁, and by 2I₁Mgl sin θ/(I₃ω₃)² in all."""
    found = solve("bicycle-wheel", omega3=400)
    # A hoop about a diameter has half of what it has about its axis; and Steiner.
    lambda1, momentum = 1.5 * (0.31**2 / 2 + 0.15**2), 1.5 * 0.31**2 * 400
    assert found["dip_period"] == pytest.approx(2 * pi * lambda1 / momentum, rel=1e-6)
    assert found["dip"] == pytest.approx(2 * lambda1 * 1.5 * 9.81 * 0.15 / momentum**2, rel=1e-6)
