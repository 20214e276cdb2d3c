"""θ = 0 and π are no special places, and φ and ψ count turns."""

import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import rigidtop as rt
from rigidtop.motion.attitude import azimuth_and_spin, from_euler_angles, quaternions, spinors

TOP = rt.HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5)
tilt = st.one_of(
    st.floats(0, math.pi, allow_subnormal=False),
    st.floats(1e-300, 1e-3),
    st.floats(1e-12, 1e-3).map(lambda x: math.pi - x),
)
azimuth = st.floats(-math.pi, math.pi)


@given(tilt, azimuth, azimuth)
def test_angles_are_the_product_of_three_rotations(theta, phi, psi):
    product = (
        Rotation.from_rotvec([0, 0, phi])
        * Rotation.from_rotvec([0, theta, 0])
        * Rotation.from_rotvec([0, 0, psi])
    )
    made = from_euler_angles(theta, phi, psi)
    assert abs(made.as_matrix() - product.as_matrix()).max() < 1e-15 * 4


@given(tilt, azimuth, azimuth, st.tuples(azimuth, azimuth, azimuth))
@example(0.0, 0.0, 0.0, (0.0, -1.0, 0.0))  # φ = ψ = π up to whole turns, not −π
@example(0.0, 0.0, 0.0, (-0.0, -1.0, 0.0))
def test_attitude_to_angles_and_back(theta, phi, psi, omega):
    attitude = from_euler_angles(theta, phi, psi)
    motion = TOP.motion(attitude=attitude, omega=omega)
    start = motion.start()
    assert start.theta[0] == pytest.approx(theta, rel=1e-14, abs=1e-15 if theta > 1 else 0)
    again = from_euler_angles(start.theta[0], motion.phi, motion.psi)
    assert (again.inv() * attitude).magnitude() < 1e-14
    assert -math.pi < motion.phi <= math.pi
    assert -math.pi < motion.psi <= math.pi


@pytest.mark.parametrize("theta", [0.0, 1e-12, 1e-6, 0.3, 3.0, math.pi - 1e-6, math.pi])
def test_rates_come_back_from_the_body(theta):
    given = {"theta_dot": 0.2, "phi_dot": -1.5, "psi_dot": 4.0}
    start = TOP.motion(theta=theta, phi=1.0, psi=2.5, **given).start()
    assert start.theta_dot[0] == pytest.approx(0.2, abs=1e-14)
    assert start.theta[0] == pytest.approx(theta, abs=1e-15)
    if 0 < theta < math.pi:
        allowed = 1e-15 / math.sin(theta)  # rounding of ω, divided by sin θ
        assert start.phi_dot[0] == pytest.approx(-1.5, abs=max(allowed, 1e-13))
        assert start.psi_dot[0] == pytest.approx(4.0, abs=max(allowed, 1e-13))


@pytest.mark.parametrize(("theta", "sign"), [(0.0, 1), (math.pi, -1)])
def test_at_a_pole_the_azimuth_turns_as_on_a_passage(theta, sign):
    """φ̇ → ±λ₃ω₃/(2λ₁): just after the pole it is that, from the attitude alone."""
    motion = TOP.motion(theta=theta, theta_dot=sign * 0.5, omega3=6.0)
    run = motion.integrate([0.0, 1e-3], rtol=1e-13)
    assert run.phi_dot[0] == sign * 0.5 * 6.0 / 2
    assert run.phi_dot[1] == pytest.approx(sign * 1.5, abs=1e-5)
    assert run.phi[1] - run.phi[0] == pytest.approx(sign * 1.5e-3, abs=1e-7)


@pytest.mark.parametrize("pole", [0.0, math.pi])
def test_a_passage_exactly_through_a_pole_keeps_its_accuracy(pole):
    """Started at the pole and looked at before and after: θ is even in t, ω agrees reversed."""
    speed = 2.0 if pole == 0 else -5.0
    motion = TOP.motion(theta=pole, theta_dot=speed, omega3=5.0)
    t = np.linspace(0, 20, 201)
    after, before = motion.integrate(t, rtol=1e-12), motion.integrate(-t, rtol=1e-12)
    assert max(max(run.drift().values()) for run in (after, before)) < 1e-11
    assert after.theta == pytest.approx(before.theta, abs=1e-9)
    # p_φ = ±p_ψ holds on the whole motion, so (3.45) is regular at both its returns to the pole.
    turn = after.p_phi - after.p_psi * np.cos(after.theta)
    away = np.sin(after.theta) > 0.05
    assert after.phi_dot[away] == pytest.approx(
        turn[away] / np.sin(after.theta[away]) ** 2, abs=1e-6
    )


def test_through_the_pole_only_the_sum_of_the_angles_is_continuous():
    t = np.linspace(-0.1, 0.1, 2001)
    run = TOP.motion(theta=0.0, theta_dot=2.0, phi=0.3, psi=0.1, omega3=5.0).integrate(t)
    assert run.theta[1000] == 0
    assert (run.phi[1000], run.psi[1000]) == (pytest.approx(0.3), pytest.approx(0.1))
    assert np.diff(run.phi + run.psi) == pytest.approx(np.full(2000, 5e-4), abs=1e-5)
    assert abs(run.phi[999] - run.phi[1001]) == pytest.approx(math.pi, abs=1e-3)


def test_a_near_passage_turns_the_azimuth_by_half_a_turn_to_the_right_side():
    """The sum of many small differences, sampled as finely as needed, is what few samples show."""
    for miss in (1e-3, -1e-3, 1e-8, -1e-8):
        motion = TOP.motion(theta=abs(miss), phi_dot=2.0 / miss, omega3=5.0)  # closest at t = 0
        few = motion.integrate([-0.1, 0.1])
        fine = motion.integrate(np.concatenate([-np.geomspace(0.1, 1e-12, 4000), [0.0]]))
        steps = np.diff(np.angle(np.exp(1j * fine.phi)))
        summed = np.sum((steps + np.pi) % (2 * np.pi) - np.pi)
        assert few.phi[0] == pytest.approx(-summed, abs=1e-6)
        half_turn = math.copysign(math.pi, miss)
        assert few.phi[1] - few.phi[0] == pytest.approx(half_turn + 0.2 * 1.25, abs=0.02)


@pytest.mark.parametrize("miss", [1e-3, -1e-5, 1e-7])
@pytest.mark.parametrize("lead", [0.05, 0.1337])
def test_a_near_passage_in_the_middle_of_a_step(miss, lead):
    """Started some time before, so that no step ends where the axis is closest to the pole."""
    motion = TOP.motion(theta=abs(miss), phi_dot=2.0 / miss, omega3=5.0)  # closest at t = 0
    through = motion.integrate([-lead, lead], rtol=1e-13, atol=1e-15)
    early = TOP.motion(attitude=through.rotation[0], omega=through.omega[0])
    run = early.integrate([0.0, 2 * lead], rtol=1e-13, atol=1e-15)
    assert np.diff(run.phi) == pytest.approx(np.diff(through.phi), abs=1e-4)
    assert np.diff(run.psi) == pytest.approx(np.diff(through.psi), abs=1e-4)


def test_coarse_samples_lose_no_turns():
    motion = TOP.motion(theta=0.5, theta_dot=0.1, phi=9.0, psi=-7.0, phi_dot=1.0, psi_dot=40.0)
    fine = motion.integrate(np.linspace(0, 20, 4001))
    few = motion.integrate([20.0, 10.0])
    assert few.phi == pytest.approx(fine.phi[[-1, 2000]], abs=1e-12)
    assert few.psi == pytest.approx(fine.psi[[-1, 2000]], abs=1e-12)
    assert (fine.phi[0], fine.psi[0]) == (pytest.approx(9.0), pytest.approx(-7.0))
    # ψ by quadrature of its rate
    rate = fine.psi_dot
    quadrature = (rate[:-1:2] + 4 * rate[1::2] + rate[2::2]).sum() * 0.005 / 3
    assert fine.psi[-1] - fine.psi[0] == pytest.approx(quadrature, abs=1e-5)


@given(st.floats(0.2, 2.9), azimuth, azimuth, azimuth, azimuth, st.floats(-9, 9), st.floats(-3, 3))
def test_continuous_angles_are_the_attitude(theta, phi, psi, theta_dot, phi_dot, spin, t):
    run = TOP.motion(
        theta=theta, phi=phi, psi=psi, theta_dot=theta_dot, phi_dot=phi_dot, omega3=spin
    ).integrate(t, rtol=1e-6)
    again = from_euler_angles(float(run.theta[0]), float(run.phi[0]), float(run.psi[0]))
    assert (again.inv() * run.rotation[0]).magnitude() < 1e-13


@pytest.mark.parametrize(("theta", "sign"), [(0.0, 1), (math.pi, -1)])
def test_sleeping_top(theta, sign):
    run = TOP.motion(theta=theta, phi=0.2, omega3=40.0).integrate([0.0, -1.0, 100.0])
    assert run.theta.tolist() == [theta] * 3
    assert run.phi_dot.tolist() == [sign * 10.0] * 3
    assert run.phi == pytest.approx(0.2 + sign * 10.0 * run.t, abs=1e-11)
    assert run.psi == pytest.approx(30.0 * run.t, abs=1e-11)


def test_upright_attitude_gets_the_azimuth_in_which_it_leaves():
    turned = Rotation.from_rotvec([0, 0, 0.7])
    motion = TOP.motion(attitude=turned, omega=(0.3, -0.4, 5.0))
    soon = motion.integrate(1e-6)
    e3_velocity = turned.apply(np.cross([0.3, -0.4, 5.0], [0, 0, 1]))
    assert motion.phi == pytest.approx(math.atan2(e3_velocity[1], e3_velocity[0]))
    assert soon.phi[0] == pytest.approx(motion.phi, abs=1e-4)
    assert motion.start().theta_dot[0] == pytest.approx(0.5)


def test_hanging_attitude_too():
    attitude = Rotation.from_rotvec([0, math.pi, 0]) * Rotation.from_rotvec([0, 0, 0.7])
    upside_down = Rotation.from_quat(
        np.where(abs(attitude.as_quat()) < 1e-15, 0, attitude.as_quat())
    )
    phi, psi = azimuth_and_spin(upside_down, (0.3, -0.4, 5.0))
    motion = TOP.motion(attitude=upside_down, omega=(0.3, -0.4, 5.0))
    assert (motion.phi, motion.psi) == (phi, psi)
    assert motion.integrate(1e-6).phi[0] == pytest.approx(phi, abs=1e-4)
    assert motion.start().theta_dot[0] == pytest.approx(-0.5)


def test_spinors_of_an_attitude():
    alpha, beta = spinors(quaternions(from_euler_angles(1.0, 0.6, 0.2)))
    assert complex(alpha) == pytest.approx(math.cos(0.5) * np.exp(0.4j))
    assert complex(beta) == pytest.approx(math.sin(0.5) * np.exp(0.2j))


@pytest.mark.parametrize("theta", [0.3, 0.9, 1.5, 2.0, 2.6])
def test_what_rounding_keeps_from_the_lower_pole_passes_through_it(theta):
    """p_φ = −p_ψ but for the last digit."""
    phi_dot = -0.5 * 3 * (1 + math.cos(theta)) / math.sin(theta) ** 2
    assert TOP.motion(theta=theta, phi_dot=phi_dot, omega3=3.0).regime == "through the vertical"
