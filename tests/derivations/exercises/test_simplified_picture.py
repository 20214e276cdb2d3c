"""Section 3.5.2."""

from math import acos, asin, atan2, cos, gamma, pi, radians, sqrt

import numpy as np
import pytest

from rigidtop.derivations.exercises.simplified_picture import bound_of_angle, largest_angle
from rigidtop.errors import NoSteadyPrecession, RigidtopError
from rigidtop.motion.top import HeavyTop


def test_toppling_from_the_horizontal_is_a_lemniscate(solve):
    """From π/2 to π it is a quarter of a pendulum with amplitude 90°: K(½) = Γ(¼)²/(4√π).

    DLMF 23.5.8; with √(λ₁/MgR) = 1.
    """
    found = solve("toppling-top", theta=pi / 2, until=pi, lambda1=1, M=1, R=0.5, g=2)
    assert found["time_to_fall"] == pytest.approx(gamma(0.25) ** 2 / (4 * sqrt(pi)), rel=1e-14)
    assert found["theta_dot"] == pytest.approx(sqrt(2), rel=1e-14)  # ½λ₁θ̇² = MgR


def test_toppling_of_a_hanging_top_is_harmonic(solve):
    """Small swings about the hanging top: a quarter of a period from rest to the lowest point."""
    found = solve("toppling-top", theta=pi - 1e-6, until=pi)
    assert found["time_to_fall"] == pytest.approx(pi / 2 / found["growth_rate"], rel=1e-9)


def test_toppling_from_almost_upright_takes_the_logarithm(solve):
    """Each tenth of the tilt costs ln 10/κ more."""
    times = [solve("toppling-top", theta=tilt)["time_to_fall"] for tilt in (1e-20, 1e-21)]
    growth = solve("toppling-top")["growth_rate"]
    assert times[1] - times[0] == pytest.approx(2.302585092994046 / growth, rel=1e-12)


def test_toppling_upwards_is_refused(solve):
    with pytest.raises(RigidtopError, match=r"until = 0\.3 must be more than theta = 0\.5"):
        solve("toppling-top", theta=0.5, until=0.3)


def lowest_by_the_cubic(top, theta, spin):
    """cos θ where a released top turns: Goldstein, Classical Mechanics, § 5.7, (1 − u²)(α − βu) −
    (b − au)² = 0, of which u = cos θ at the start is a root."""
    momentum = top.lambda3 * spin / top.lambda1
    strength = 2 * top.M * top.g * top.R / top.lambda1
    start = cos(theta)
    # (α − βu) = β(u₀ − u) and b − au = a(u₀ − u): divided by u₀ − u.
    quadratic = [-strength, momentum**2, strength - momentum**2 * start]
    return min(root.real for root in np.roots(quadratic) if -1 <= root.real <= start)


@pytest.mark.parametrize(
    ("theta", "spin"), [(0.5, 20.0), (pi / 2, 12.0), (2.2, -30.0), (1.0, 90.0)]
)
def test_largest_angle_is_that_at_the_lowest_point(solve, theta, spin):
    """ω⊥ there by energy, and the angles of L and ω with e₃: tan = λ₁ω⊥/λ₃ω₃ and ω⊥/ω₃."""
    top = HeavyTop(lambda1=1.3, lambda3=0.7, M=0.8, R=0.6)
    sunk = cos(theta) - lowest_by_the_cubic(top, theta, spin)
    across = sqrt(2 * top.M * top.g * top.R * sunk / top.lambda1)
    expected = atan2(1.3 * across, 0.7 * abs(spin)) - atan2(across, abs(spin))
    found = solve("parallel-bound", theta=theta, omega3=spin)
    assert found["largest"] == pytest.approx(expected, rel=1e-11)


@pytest.mark.parametrize(("theta", "spin"), [(pi / 6, 0.01), (1e-3, 0.3), (3.0, -0.01)])
def test_slow_top_reaches_the_widest_angle_of_its_body(solve, theta, spin):
    """Any angle between ω and L is at most arcsin |λ₁ − λ₃|/(λ₁ + λ₃); 17.46° for 1.3 and 0.7."""
    found = solve("parallel-bound", theta=theta, omega3=spin)
    assert found["largest"] == pytest.approx(asin(0.6 / 2.0), rel=1e-14)
    assert all(measure.passed for measure in found.measures)


@pytest.mark.parametrize("spin", [0.7, 2.0, 4.0, 6.0])
def test_largest_angle_over_many_states(spin):
    """As for fast tops, of all that a fine sample of ω⊥ up to the lowest point gives."""
    top, theta = HeavyTop(lambda1=1.3, lambda3=0.2, M=0.8, R=0.6), 1.2
    sunk = cos(theta) - lowest_by_the_cubic(top, theta, spin)
    across = np.linspace(0, sqrt(2 * top.M * top.g * top.R * sunk / top.lambda1), 100001)
    angles = np.arctan2(1.3 * across, 0.2 * spin) - np.arctan2(across, spin)
    assert largest_angle(top, theta, spin) == pytest.approx(angles.max(), rel=1e-8)


def test_nothing_disturbs_an_upright_top():
    top = HeavyTop(lambda1=1.3, lambda3=0.7, M=0.8, R=0.6)
    assert largest_angle(top, 0.0, 1.0) == 0


def test_no_angle_exceeds_the_bound():
    """Over tops, tilts and spins of every kind, slow ones too."""
    rng = np.random.default_rng(11)
    for _ in range(200):
        lambda3, thickness, M, R = 10 ** rng.uniform(-2, 1, 4)
        top = HeavyTop(lambda1=M * R**2 + lambda3 / 2 + thickness, lambda3=lambda3, M=M, R=R)
        theta = rng.uniform(0.01, 3.1)
        spin = rng.choice([-1, 1]) * sqrt(top.lambda1 * M * 9.81 * R) / lambda3
        spin *= 10 ** rng.uniform(-1, 2)
        assert largest_angle(top, theta, spin) <= bound_of_angle(top, theta, spin) * (1 + 1e-9)


def test_bound_is_reached_by_a_fast_top(solve):
    shares = [row[4] for row in solve("parallel-bound")["spins"].rows]
    assert shares[-1] == pytest.approx(1, abs=1e-9)
    # What is missing is of second order: a sixteenth for twice the spin.
    assert (1 - shares[2]) / (1 - shares[1]) == pytest.approx(1 / 16, rel=0.05)


@pytest.mark.parametrize("theta", [0.3, 1.2, pi / 2, 2.5])
def test_mean_precession_exceeds_the_simple_one_by_epsilon_cos_theta(solve, theta):
    """To zeroth order it is Mgl/(I₃ω₃): Goldstein, Classical Mechanics, § 5.7. To first, cos θ.

    Extrapolated from two rows, of which the second has a quarter of the first's ε₀.
    """
    rows = solve("parallel-bound", theta=theta)["spins"].rows
    fine, coarse = rows[4][7], rows[3][7]
    assert fine + (fine - coarse) / 3 == pytest.approx(cos(theta), abs=1e-6)
    assert rows[-1][6] == pytest.approx(0, abs=1e-5)


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


def test_gyroscopes_that_fall(solve):
    with pytest.raises(NoSteadyPrecession, match=r"\|omega3\| must be at least 103"):
        solve("gyroscope", omega3=100)
    for name in ("gyroscope", "bicycle-wheel", "parallel-bound"):
        with pytest.raises(RigidtopError, match="omega3 must not be 0"):
            solve(name, omega3=0)
    with pytest.raises(RigidtopError, match="lambda1 and lambda3 must differ"):
        solve("parallel-bound", lambda1=1.3, lambda3=1.3)


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
