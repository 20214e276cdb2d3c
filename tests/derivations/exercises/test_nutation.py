"""Section 3.5.4."""

from itertools import pairwise
from math import cos, pi, sin, sqrt

import pytest

from rigidtop.errors import NoSteadyPrecession, RigidtopError

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


def test_mean_rate_of_a_fast_top_is_that_of_the_simple_picture(solve):
    """(3.52): MgR/(λ₃ω₃) = 4/1000, for a release at rest."""
    found = solve("waves-cusps-loops", **WHOLE, theta=1, omega3=2000, phi_dot=0)
    assert found["mean_rate"] == pytest.approx(0.004, rel=1e-4)
    assert found["path"] == "cusps"


@pytest.mark.parametrize("rate", [5.76960, 5.7695, -80.2, -80.0])
def test_paths_that_almost_pass_the_vertical(solve, rate):
    found = solve("waves-cusps-loops", phi_dot=rate)
    assert min(found["turn"], pi - found["turn"]) < 0.003
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
