"""Section 3.5.4."""

from itertools import pairwise
from math import acos, cos, degrees, pi, sin, sqrt

import numpy as np
import pytest

from rigidtop.errors import NoSteadyPrecession, RigidtopError
from rigidtop.motion.top import HeavyTop

# MgR = 4; with λ₁ = 2 and θ = 60° the steady rates are those of Ω² − λ₃ω₃ Ω + 4.
WHOLE = {"lambda1": 2, "lambda3": 0.5, "M": 1, "R": 0.5, "g": 8}
LIGHT = {**WHOLE, "lambda1": 1}


# --- small nutation ------------------------------------------------------------------------------


def test_frequency_in_whole_numbers(solve):
    """Ω = 1: λ₁² times the square is (λ₃ω₃ − 2λ₁Ω cos θ)² + (λ₁Ω sin θ)² = 9 + 3.

    The sum of squares is Routh's condition for a steady precession to be stable.
    """
    found = solve("small-nutation", **WHOLE, theta=pi / 3, omega3=10)
    assert found["slow"] == pytest.approx(1, rel=1e-14)
    assert found["frequency"] == pytest.approx(sqrt(3), rel=1e-14)
    assert found["fast_frequency"] == 2.5


def test_release_at_60_degrees_that_turns_at_the_horizontal(solve):
    """16 (½ − u) = 2·4 (1 − u²) at u = 0: the energy in whole numbers."""
    found = solve("small-nutation", **LIGHT, theta=pi / 3, omega3=8)
    assert found["turn"] == pytest.approx(pi / 2, rel=1e-14)
    assert found["amplitude"] == pytest.approx(pi / 12, rel=1e-14)
    assert found["centre"] == pytest.approx(5 * pi / 12, rel=1e-14)


def test_fast_top_nutates_as_goldstein_says(solve):
    """Section 5.7: cos θ₀ − cos θ₁ = (I₁/I₃)(2Mgl/I₃ω₃²) sin²θ₀, and the frequency I₃ω₃/I₁."""
    found = solve("small-nutation", **LIGHT, theta=0.8, omega3=4000)
    small = 2 * (1 / 0.5) * 4 / (0.5 * 4000**2)
    assert cos(0.8) - cos(found["turn"]) == pytest.approx(small * sin(0.8) ** 2, rel=1e-5)
    assert found["released_frequency"] == pytest.approx(2000, rel=1e-5)


def test_formulas_for_fast_tops_err_by_the_weight_over_the_square_of_the_spin(solve):
    """Errors of the amplitude fall as 1/ω₃², those of √(U″/λ₁) as 1/ω₃⁴."""
    rows = solve("small-nutation")["spins"].rows[-3:]
    for slower, faster in pairwise(rows):
        amplitude = [row[5] / row[4] - 1 for row in (slower, faster)]
        assert amplitude[0] / amplitude[1] == pytest.approx(4, rel=0.03)
        harmonic = [row[2] / row[1] - 1 for row in (slower, faster)]
        assert harmonic[0] / harmonic[1] == pytest.approx(16, rel=0.1)


def test_axis_swings_about_the_angle_where_it_could_be_steady(solve):
    """To first order of the amplitude; the mean lies off it by its square."""
    found = solve("small-nutation", omega3=200)
    assert found["centre"] - found["steady_angle"] == pytest.approx(0, abs=found["amplitude"] ** 2)
    assert found["amplitude"] > 1e-4


def test_nutation_needs_a_steady_precession(solve):
    with pytest.raises(NoSteadyPrecession, match="at least"):
        solve("small-nutation", omega3=3)
    with pytest.raises(RigidtopError, match="omega3 = 0"):
        solve("small-nutation", theta=2, omega3=0)


# --- waves, cusps, loops -------------------------------------------------------------------------


def test_boundaries_in_whole_numbers(solve):
    """λ₃ω₃ = 5, u = ½: −5/(2·½), 0, the roots 1 and 4, 2·4/5, 5/(2·3/2)."""
    rows = solve("waves-cusps-loops", **WHOLE, theta=pi / 3, omega3=10)["boundaries"].rows
    expected = [-5, 0, 1, 1.6, 5 / 3, 4]
    assert [row[1] for row in rows[:-1]] == pytest.approx(expected, rel=1e-14, abs=0)
    assert [row[2] for row in rows] == ["waves", "loops", *2 * ["waves"], "loops", *2 * ["waves"]]
    assert [row[3] for row in rows] == [*3 * ["sinks"], *3 * ["rises"], "sinks"]


@pytest.mark.parametrize("spin", [4, -4])
def test_weak_spin_leaves_no_steady_rate_no_cusps_above_and_no_way_to_the_upright(solve, spin):
    """(λ₃ω₃)² = 4 is less than 2λ₁MgR(1 + cos θ) = 24: p_φ = p_ψ parts nothing."""
    rows = solve("waves-cusps-loops", **WHOLE, theta=pi / 3, omega3=spin)["boundaries"].rows
    forward = rows if spin > 0 else rows[::-1]
    assert [row[2] for row in forward] == ["waves", "loops", "waves"]
    assert {row[4] for row in rows[:-1]} == {"through the hanging position", "cusps"}
    assert {row[3] for row in rows} == {"sinks"}


def test_momenta_of_an_upright_top_without_the_energy_to_get_there(solve):
    """The exercise's top with ω₃ = 4: from 30° down to 108.28°, and φ̇ keeps its sign.

    (1 + cos θ)(1 + cos θ′) = (λ₃ω₃)²/(λ₁MgR); φ̇ = λ₃ω₃/(λ₁(1 + cos θ)) all the way.
    """
    theta, spin, weight = pi / 6, 0.7 * 4, 0.8 * 9.81 * 0.6
    rate = spin / (1.3 * (1 + cos(theta)))
    found = solve("waves-cusps-loops", omega3=4, phi_dot=rate)
    assert found["path"] == "waves"
    assert found["turn"] == pytest.approx(
        acos(spin**2 / (1.3 * weight) / (1 + cos(theta)) - 1), rel=1e-12
    )
    assert degrees(found["turn"]) == pytest.approx(108.28, abs=0.005)
    assert found["turn_rate"] == pytest.approx(spin / (1.3 * (1 + cos(found["turn"]))), rel=1e-10)


@pytest.mark.parametrize("share", [0.999, 1.001])
def test_the_upright_is_passed_from_the_energy_on_that_reaches_it(solve, share):
    """(λ₃ω₃)² = 2λ₁MgR(1 + cos θ), by integration: on one side the axis comes to the upright."""
    theta, weight = pi / 6, 0.8 * 9.81 * 0.6
    spin = share * sqrt(2 * 1.3 * weight * (1 + cos(theta))) / 0.7
    rate = 0.7 * spin / (1.3 * (1 + cos(theta)))
    top = HeavyTop(lambda1=1.3, lambda3=0.7, M=0.8, R=0.6, g=9.81)
    motion = top.motion(theta=theta, phi_dot=rate, omega3=spin)
    smallest = float(motion.integrate(np.linspace(0, 20, 4001), rtol=1e-12, atol=1e-14).theta.min())
    if share > 1:
        assert smallest < 1e-3
        with pytest.raises(RigidtopError, match="through the vertical"):
            solve("waves-cusps-loops", omega3=spin, phi_dot=rate)
    else:
        assert solve("waves-cusps-loops", omega3=spin, phi_dot=rate)["turn"] == pytest.approx(
            smallest, abs=1e-4
        )
        assert smallest > 0.05


def test_second_cusps_are_the_first_seen_from_above(solve):
    """From φ̇ = 2MgR/(λ₃ω₃) the axis rises to where it rests, cos θ = ½ + 2·8·¾/25."""
    below = solve("waves-cusps-loops", **WHOLE, theta=pi / 3, omega3=10, phi_dot=1.6)
    assert below["path"] == "cusps"
    assert below["turn"] == pytest.approx(acos(0.98), rel=1e-13)
    assert below["turn_rate"] == pytest.approx(0, abs=1e-12)
    above = solve("waves-cusps-loops", **WHOLE, theta=acos(0.98), omega3=10, phi_dot=0)
    assert above["path"] == "cusps"
    assert above["turn"] == pytest.approx(pi / 3, rel=1e-13)
    assert above["turn_rate"] == pytest.approx(1.6, rel=1e-12)


@pytest.mark.parametrize("rate", [-1.0, 0.2, 0.5, 3.0, 8.0, 20.0])
def test_the_other_turning_point_leads_back(solve, rate):
    there = solve("waves-cusps-loops", phi_dot=rate)
    back = solve("waves-cusps-loops", theta=there["turn"], phi_dot=there["turn_rate"])
    assert back["turn"] == pytest.approx(pi / 6, rel=1e-11)
    assert back["turn_rate"] == pytest.approx(rate, rel=1e-10)
    assert back["path"] == there["path"]
    assert {back["at_first"], there["at_first"]} == {"sinks", "rises"}
    for name in ("period", "precession"):
        assert back[name] == pytest.approx(there[name], rel=1e-10)


def test_mean_rate_of_a_fast_top_is_that_of_the_simple_picture(solve):
    """(3.52): MgR/(λ₃ω₃) = 4/1000, for a release at rest."""
    found = solve("waves-cusps-loops", **WHOLE, theta=1, omega3=2000, phi_dot=0)
    assert found["mean_rate"] == pytest.approx(0.004, rel=1e-4)
    assert found["path"] == "cusps"


def test_backward_spin_is_the_mirror_image(solve):
    forward = solve("waves-cusps-loops", phi_dot=2)
    backward = solve("waves-cusps-loops", phi_dot=-2, omega3=-20)
    assert forward["path"] == backward["path"] == "loops"
    assert backward["turn"] == forward["turn"]
    assert backward["precession"] == -forward["precession"]


@pytest.mark.parametrize("rate", [5.76960, 5.7695, -80.2, -80.0])
def test_paths_that_almost_pass_the_vertical(solve, rate):
    found = solve("waves-cusps-loops", phi_dot=rate)
    assert min(found["turn"], pi - found["turn"]) < 0.003
    assert all(measure.passed for measure in found.measures)


def test_slow_top_with_almost_the_momenta_of_an_upright_one(solve):
    """Too little spin to rise that far: (1 + cos θ)(1 + cos θ′) = (λ₃ω₃)²/(λ₁MgR), here 12/4.

    By L₃²(1 − cos θ)/(2λ₁(1 + cos θ)) + MgR cos θ, the potential with L_z = L₃.
    """
    theta, spin = 0.8, sqrt(12) / 0.5
    rate = 0.5 * spin / (1 + cos(theta)) * (1 + 1e-9)
    found = solve("waves-cusps-loops", **LIGHT, theta=theta, omega3=spin, phi_dot=rate)
    assert (1 + cos(theta)) * (1 + cos(found["turn"])) == pytest.approx(3, rel=1e-8)
    assert all(measure.passed for measure in found.measures)


def test_starts_without_a_path_are_refused(solve):
    with pytest.raises(RigidtopError, match="phi_dot = -5 takes the axis through the vertical"):
        solve("waves-cusps-loops", **WHOLE, theta=pi / 3, omega3=10, phi_dot=-5.000000000000001)
    with pytest.raises(RigidtopError, match="omega3 = 0"):
        solve("waves-cusps-loops", omega3=0)


def test_a_start_that_tends_to_the_upright_is_refused(solve):
    spin = sqrt(2 * 2 * 4 * 1.5) / 0.5
    with pytest.raises(RigidtopError, match="lost in rounding"):
        solve("waves-cusps-loops", **WHOLE, theta=pi / 3, omega3=spin, phi_dot=spin / 6)


def test_a_start_that_almost_tends_to_the_upright_comes_close_to_it(solve):
    """(1 + cos θ)(1 + cos θ′) = (λ₃ω₃)²/(λ₁MgR), 3 but for twice 10⁻⁶ of it: θ′ = √(8·10⁻⁶)."""
    spin = (1 - 1e-6) * sqrt(2 * 2 * 4 * 1.5) / 0.5
    found = solve("waves-cusps-loops", **WHOLE, theta=pi / 3, omega3=spin, phi_dot=spin / 6)
    assert found["turn"] == pytest.approx(sqrt(8e-6), rel=1e-6)
    assert all(measure.passed for measure in found.measures)
