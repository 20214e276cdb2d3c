"""Friction on the table and in the air."""

from math import atanh, cos, exp, log, pi, sin, sqrt

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from rigidtop.errors import RigidtopError
from rigidtop.motion.table.motion import SlidingTop

TOP = {"lambda1": 4e-5, "lambda3": 2.5e-5, "M": 0.1, "R": 0.03, "g": 9.81}
UP = np.array([0.0, 0.0, 1.0])


def rates_on_the_table(y, lambda1, lambda3, M, R, g, tip, mu):
    """d/dt of e₃, L about the centre of mass and its velocity along x̂ and ŷ: L̇ = ρ × C.

    Neither quaternions nor Euler's equations; N from the height, which e₃ alone decides.
    """
    e3, momentum, velocity = y[:3], y[3:6], y[6:]
    turning = np.cross(momentum, e3) / lambda1
    omega = momentum / lambda1 + (1 / lambda3 - 1 / lambda1) * (momentum @ e3) * e3
    rho = -(R - tip) * e3 - tip * UP
    slip = (np.append(velocity, 0) + np.cross(omega, rho))[:2]
    per_newton = np.append(-mu * slip / np.hypot(*slip), 1.0)
    # M(R − r) ë₃z = N − Mg, with λ₁ ë₃ = N (ρ × c) × e₃ + L × ė₃.
    bend = np.cross(np.cross(rho, per_newton), e3)[2] / lambda1
    free = np.cross(momentum, turning)[2] / lambda1
    normal = M * (g + (R - tip) * free) / (1 - M * (R - tip) * bend)
    force = normal * per_newton
    return np.concatenate([turning, np.cross(rho, force), force[:2] / M])


def test_rise_by_another_way_to_the_equations(solve):
    """The whole rise integrated as vectors in space: θ and ω₃ are where they should be."""
    theta, omega3, tip, mu = 0.5, 200.0, 0.01, 0.1
    found = solve("rising-top")
    b, c = TOP["lambda3"] * omega3, TOP["M"] * TOP["g"] * (TOP["R"] - tip)
    a = TOP["lambda1"] * cos(theta)
    precession = (b - sqrt(b**2 - 4 * a * c)) / (2 * a)
    axis, across = np.array([sin(theta), 0, cos(theta)]), np.array([cos(theta), 0, -sin(theta)])
    momentum = b * axis - TOP["lambda1"] * precession * sin(theta) * across
    run = solve_ivp(
        lambda t, y: rates_on_the_table(y, **TOP, tip=tip, mu=mu),
        (0, found["time_to_rise"]),
        [*axis, *momentum, 0, 0],
        method="DOP853",
        rtol=1e-9,
        atol=1e-12,
    )
    e3, end = run.y[:3, -1], run.y[3:6, -1]
    assert np.arctan2(np.hypot(*e3[:2]), e3[2]) == pytest.approx(0.25, abs=1e-6)
    assert end @ e3 / TOP["lambda3"] == pytest.approx(found["omega3_then"], rel=1e-8)


def test_where_the_energy_of_the_spin_goes(solve):
    found = solve("rising-top")
    assert found["to_weight"] + found["to_motion"] + found["to_heat"] == pytest.approx(1, rel=1e-9)
    assert found["rise"] == pytest.approx(0.02 * (cos(0.25) - cos(0.5)), rel=1e-6)
    assert found["spin_lost"] == pytest.approx(
        2.5e-5 / 2 * (200**2 - found["omega3_then"] ** 2), rel=1e-9
    )
    for row in found["budget"].rows:
        assert sum(row[2:-1]) == pytest.approx(row[-1], rel=1e-15)
        assert row[-1] == pytest.approx(found["budget"].rows[0][-1], rel=1e-9)


def test_jellett_leaves_the_upright_top_its_spin(solve):
    """r/R = 1/3 and cos θ = 1/2: a sixth goes, but for what the precession has of L_z."""
    found = solve("rising-top", theta=pi / 3, until=pi / 3 - 0.05)
    assert found["omega3_upright"] == pytest.approx(
        200 * 5 / 6 + 4e-5 / 2.5e-5 * found["phi_dot"] * sin(pi / 3) ** 2 / 3, rel=1e-12
    )


def test_little_friction_raises_slowly(solve):
    """The time of the gyroscopic formula goes as 1/μ, and the rise nearly obeys it."""
    found = solve("rising-top", mu=0.02, until=0.46)
    expected = solve("rising-top", mu=0.04, until=0.46)["time_gyroscope"]
    assert found["time_gyroscope"] == pytest.approx(2 * expected, rel=1e-12)
    assert found["time_to_rise"] == pytest.approx(found["time_gyroscope"], rel=0.2)


def test_a_tip_that_grips_raises_no_further(solve):
    with pytest.raises(RigidtopError, match=r"until = 0\.02 is not reached.*: standstill at"):
        solve("rising-top", mu=0.3, until=0.02)
    with pytest.raises(RigidtopError, match=r"until = 0\.5 must be less than theta = 0\.5"):
        solve("rising-top", until=0.5)
    with pytest.raises(RigidtopError, match=r"tip = 0\.03 must be less than R = 0\.03"):
        solve("rising-top", tip=0.03)
    with pytest.raises(RigidtopError, match="no steady precession"):
        solve("rising-top", omega3=50)


SLEEPING = 2 * sqrt((4e-5 + 0.1 * 0.03**2) * 0.1 * 9.81 * 0.03) / 2.5e-5
"""2√(λ₁MgR)/λ₃ with λ₁ about the tip (rad/s)."""


def test_air_brings_the_spin_down(solve):
    """ω₃ = e^{0.1} sleeping spins takes 0.1 λ₃/c₃."""
    found = solve("waking-top", omega3=SLEEPING * exp(0.1))
    assert found["sleeping_spin"] == pytest.approx(SLEEPING, rel=1e-14)
    assert found["time_asleep"] == pytest.approx(0.1 * 2.5e-5 / 5e-6, rel=1e-12)
    assert found["half_life"] == pytest.approx(5 * log(2), rel=1e-14)
    assert found["omega3_then"] == pytest.approx(SLEEPING * exp(0.1 - found["seen"] / 5), rel=1e-12)


def test_waking_by_the_integral_in_closed_form(solve):
    """∫ √(1 − e^{−2x}) dx = artanh y − y with y = √(1 − e^{−2x}): the tilt grows by e^11.5."""
    found = solve("waking-top")
    passed = (found["time_awake"] - found["time_asleep"]) / 5
    y = sqrt(-np.expm1(-2 * passed))
    growth = 2.5e-5 * SLEEPING / (2 * (4e-5 + 0.1 * 0.03**2)) * 5
    assert growth * (atanh(y) - y) == pytest.approx(log(0.1 / 1e-6), rel=1e-9)


def test_how_the_disturbance_turns_decides_when_it_is_seen(solve):
    """1.773 s from φ̇ = 0 against 2.015 s from λ₃ω₃/(2λ₁), on the table with all its equations."""
    found = solve("waking-top")
    turning = 2.5e-5 * 165 / (2 * (4e-5 + 0.1 * 0.03**2))
    assert found["phi_dot"] == pytest.approx(turning, rel=1e-12)
    top = SlidingTop(**TOP, mu=1.0, drag3=5e-6)
    for rate, name in ((turning, "seen"), (0.0, "seen_at_rest")):
        motion = top.motion(theta=1e-6, phi_dot=rate, omega3=165.0, slip=(0.0, 0.0))
        path = motion.integrate(np.linspace(1.7, 2.1, 401), rtol=1e-9, atol=1e-12)
        seen = path.t[np.argmax(path.theta > 0.1)]
        assert found[name] == pytest.approx(seen, abs=0.003)
    assert found["seen"] == pytest.approx(2.015, abs=5e-4)
    assert found["seen_at_rest"] == pytest.approx(1.773, abs=5e-4)


@pytest.mark.parametrize("given", [{}, {"drag3": 2e-6}, {"drag3": 1e-4}, {"omega3": 200}])
def test_growth_that_is_soon_visible(solve, given):
    """Only e^2.3 of growth: the growth rate of a moment says little, as the method says."""
    found = solve("waking-top", disturbance=1e-3, visible=0.01, **given)
    assert all(measure.passed for measure in found.measures)


def test_the_air_takes_it_all_while_the_tip_is_held(solve):
    found = solve("waking-top")["budget"]
    rows = found.rows
    assert found.columns[5:] == ("heat by air (J)", "sum (J)")
    spins = [row[2] for row in rows]
    assert rows[-1][5] == pytest.approx(spins[0] - spins[-1], rel=1e-6)


def test_tops_that_never_sleep_or_sleep_too_long_are_refused(solve):
    with pytest.raises(RigidtopError, match=r"more than the sleeping spin, 156\.479 rad/s"):
        solve("waking-top", omega3=150)
    with pytest.raises(RigidtopError, match="turns until the top wakes"):
        solve("waking-top", drag3=1e-8)
