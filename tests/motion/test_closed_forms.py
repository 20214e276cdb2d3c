"""Closed forms: periods, turning points, regimes, late times, many samples and many motions.

`test_exact.py` judges the states themselves by 40-digit references.
"""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation
from scipy.special import ellipk

import rigidtop as rt
from rigidtop.motion import many
from rigidtop.motion.exact import samples

TOP = rt.HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5)
STEADY = TOP.steady_precession(theta=0.5, omega3=40.0)[0]

angles = st.floats(0.05, 3.09)
rates = st.floats(-5.0, 5.0, allow_subnormal=False)
spins = st.floats(-40.0, 40.0)


def differences(run, other):
    """Angles between attitudes, and distances of ω, at each time."""
    turned = (run.rotation.inv() * other.rotation).magnitude()
    return turned, np.linalg.norm(run.omega - other.omega, axis=1)


# --- Periods and turning points ---


@given(theta=angles, theta_dot=rates, phi_dot=rates, omega3=spins)
def test_after_a_nutation_everything_repeats_but_phi_and_psi(theta, theta_dot, phi_dot, omega3):
    motion = TOP.motion(theta=theta, theta_dot=theta_dot, phi_dot=phi_dot, omega3=omega3)
    assume(motion.nutation_period < 20 and motion.turning_points[0] > 1e-3)
    assume(motion.turning_points[1] < math.pi - 1e-3)
    times = np.array([0.0, 0.4, 1.3])
    now, later = motion.exact(times), motion.exact(times + motion.nutation_period)
    assert_allclose(later.theta, now.theta, atol=1e-10)
    assert_allclose(later.theta_dot, now.theta_dot, atol=1e-9)
    assert_allclose(later.phi - now.phi, motion.precession_per_period, atol=1e-9)
    assert motion.mean_precession * motion.nutation_period == pytest.approx(
        motion.precession_per_period
    )


@given(theta=angles, theta_dot=rates, phi_dot=rates, omega3=spins)
@settings(max_examples=40)
def test_theta_goes_from_one_turning_point_to_the_other(theta, theta_dot, phi_dot, omega3):
    motion = TOP.motion(theta=theta, theta_dot=theta_dot, phi_dot=phi_dot, omega3=omega3)
    assume(motion.nutation_period < 50)
    smallest, largest = motion.turning_points
    path = motion.exact(np.linspace(0, motion.nutation_period, 20_001)).theta
    assert path.min() >= smallest - 1e-12
    assert path.max() <= largest + 1e-12
    # The extremes are seen to second order in the spacing.
    near_pole = 1e-2 * (smallest < 0.1), 1e-2 * (largest > math.pi - 0.1)
    reach = 1e-6 * max(1.0, largest - smallest)
    assert path.min() <= smallest + max(reach, near_pole[0])
    assert path.max() >= largest - max(reach, near_pole[1])


def test_plane_pendulum_has_the_period_of_the_textbook():
    motion = TOP.motion(theta=1.0, omega3=0.0)  # released at rest, 1 rad from the upright
    omega0 = math.sqrt(9.81 * 0.5)
    amplitude = math.pi - 1.0
    # T = 4K(sin²(amplitude/2))/ω₀, and θ takes each value twice in it.
    assert motion.nutation_period == pytest.approx(
        2 * ellipk(math.sin(amplitude / 2) ** 2) / omega0, rel=1e-14
    )
    assert motion.regime == "plane"


def test_small_nutation_about_steady_precession():
    motion = TOP.motion(theta=0.5, phi_dot=STEADY, omega3=40.0)
    assert motion.regime == "steady"
    # Ω² of small nutations, from the effective potential: b² − 4μ cos θ + …, all from (3.54).
    b, mu, c, s2 = 20.0, 9.81 * 0.5, math.cos(0.5), math.sin(0.5) ** 2
    frequency = math.sqrt((b - 2 * STEADY * c) ** 2 + STEADY**2 * s2)
    assert motion.nutation_period == pytest.approx(2 * math.pi / frequency, rel=1e-12)
    assert motion.mean_precession == pytest.approx(STEADY, rel=1e-12)
    assert mu == pytest.approx(STEADY * (b - STEADY * c))


def test_free_body_with_two_equal_moments_precesses_as_in_the_notes():
    body = rt.FreeBody(2.0, 2.0, 1.0)
    motion = body.motion(omega=(0.3, 0.4, 2.0))
    length = math.hypot(2 * 0.5, 2.0)
    assert motion.regime == "regular precession"
    assert motion.mean_precession == pytest.approx(length / 2.0, rel=1e-14)  # Ω_s = L/λ₁
    assert motion.turning_points == pytest.approx((math.atan2(1.0, 2.0),) * 2, rel=1e-14)
    body_cone = abs((2.0 - 1.0) / 2.0 * 2.0)  # Ω_b, once round in two of them
    assert motion.nutation_period == pytest.approx(math.pi / body_cone, rel=1e-14)


@given(
    moments=st.tuples(*[st.floats(1.0, 1.9)] * 3),
    omega=st.tuples(*[st.floats(-3.0, 3.0)] * 3),
)
def test_omega_of_a_free_body_returns_after_two_nutations(moments, omega):
    motion = rt.FreeBody(*moments).motion(omega=omega)
    assume(0 < motion.nutation_period < 200)
    times = np.array([0.0, 0.7])
    now, later = (motion.exact(times + shift) for shift in (0.0, 2 * motion.nutation_period))
    assert_allclose(later.omega, now.omega, atol=1e-8)
    # The attitude has turned about L by the mean precession.
    momentum = now.angular_momentum[0]
    turned = later.rotation * now.rotation.inv()
    axis = momentum / np.linalg.norm(momentum)
    angle = 2 * motion.precession_per_period
    assert_allclose(
        turned.as_matrix()[0], Rotation.from_rotvec(angle * axis).as_matrix(), atol=1e-7
    )


# --- Regimes ---


@pytest.mark.parametrize(
    ("start", "regime"),
    [
        ({"theta": 0.5, "phi_dot": 1.0, "omega3": 40.0}, "loops"),
        ({"theta": 0.5, "omega3": 40.0}, "cusps"),
        ({"theta": 0.5, "phi_dot": 0.1, "omega3": 40.0}, "waves"),
        ({"theta": 0.5, "phi_dot": STEADY, "omega3": 40.0}, "steady"),
        ({"theta": 0.5, "phi_dot": STEADY, "psi": 0.3, "omega3": 40.0}, "steady"),
        ({"theta": 0.0, "omega3": 40.0}, "sleeping"),
        ({"theta": 0.0, "omega3": 1.0}, "sleeping"),
        ({"theta": math.pi, "omega3": 1.0}, "hanging"),
        ({"theta": 0.5, "omega3": 0.0}, "plane"),
        ({"theta": 0.5, "theta_dot": 9.0, "omega3": 0.0}, "plane"),
        ({"theta": 0.5, "phi_dot": 9.0, "omega3": 0.0}, "waves"),
        ({"theta": 0.0, "theta_dot": 1.0, "omega3": 10.0}, "through the vertical"),
        ({"theta": math.pi, "theta_dot": 1.0, "omega3": 10.0}, "through the vertical"),
        ({"theta": 1e-7, "omega3": 1.0}, "cusps"),  # falls from rest, and comes back
        ({"theta": 1e-7, "omega3": 0.0}, "plane"),
        ({"theta": 1e-15, "omega3": 40.0}, "cusps"),
        ({"theta": 1e-30, "phi_dot": 1.0, "omega3": 40.0}, "loops"),
    ],
)
def test_regimes(start, regime):
    assert TOP.motion(**start).regime == regime


@given(
    theta=st.floats(1e-13, 1e-3),
    apart=st.floats(-1e-3, 1e-3),
    near=st.sampled_from([1.0, 1e-6, 1e-9, 1e-12, 0.0]),
    theta_dot=st.sampled_from([0.0, 1e-10, 1e-3, 1.0, -1.0]),
    phi_dot=st.sampled_from([1.0, 1 + 1e-9, 1.1, 0.5, 0.0]),
)
@settings(max_examples=100)
def test_at_the_critical_spin_a_motion_starts_where_it_does(theta, apart, near, theta_dot, phi_dot):
    """There steady precession, sleeping top and separatrix meet, and three roots of the cubic."""
    spin = TOP.sleeping_spin() * (1 + apart * near)
    motion = TOP.motion(
        theta=theta, theta_dot=theta_dot * theta, phi_dot=phi_dot * spin / 4, omega3=spin
    )
    run, start = motion.exact(0.0), motion.start()
    assert run.theta[0] == pytest.approx(theta, rel=1e-9)
    speed = abs(start.theta_dot[0]) + abs(start.v_phi[0]) + theta
    assert abs(run.theta_dot[0] - start.theta_dot[0]) < 1e-3 * speed
    assert abs(run.v_phi[0] - start.v_phi[0]) < 1e-9 * speed
    assert motion.turning_points[0] <= theta * (1 + 1e-9)


@pytest.mark.parametrize("theta", [0.0, math.pi])
@pytest.mark.parametrize("spin", [0.0, 1e-6, 3.0, 10.0])
def test_a_mirror_turns_the_precession_round(theta, spin):
    means = [
        TOP.motion(theta=theta, theta_dot=1.0, omega3=sign * spin).mean_precession
        for sign in (1, -1)
    ]
    assert means[0] == pytest.approx(-means[1], rel=1e-13, abs=1e-13)


def test_phi_of_a_plane_pendulum_goes_to_and_fro():
    run = TOP.motion(theta=1.0, omega3=0.0).exact(np.linspace(-20, 20, 301))
    assert set(np.round(run.phi, 12)) == {0.0, round(math.pi, 12)}


def test_equal_momenta_without_the_energy_to_reach_the_upright():
    top = rt.HeavyTop(lambda1=1.3, lambda3=0.7, M=0.8, R=0.6)
    theta, omega3 = math.radians(10), 3.0
    phi_dot = top.lambda3 * omega3 * (1 - math.cos(theta)) / (top.lambda1 * math.sin(theta) ** 2)
    motion = top.motion(theta=theta, phi_dot=phi_dot, omega3=omega3)
    assert motion.start().p_phi[0] == pytest.approx(motion.start().p_psi[0], rel=5e-16)
    assert motion.turning_points[0] == pytest.approx(theta)
    assert motion.regime == "waves"
    pushed = top.motion(theta=theta, theta_dot=1.0, phi_dot=phi_dot, omega3=omega3)
    assert pushed.turning_points[0] < 1e-15
    assert pushed.regime == "through the vertical"


@pytest.mark.parametrize(
    ("off", "regime"), [(0.0, "through the vertical"), (1e-13, "waves"), (-1e-13, "loops")]
)
def test_opposite_momenta_lead_through_the_hanging_position_to_rounding(off, regime):
    top = rt.HeavyTop(lambda1=1.3, lambda3=0.7, M=0.8, R=0.6)
    theta, omega3 = (
        x.ravel() for x in np.meshgrid(np.radians(range(91, 172, 4)), (3.0, -7.1, 0.3))
    )
    spin = top.lambda3 * omega3 / top.lambda1
    phi_dot = -spin * (1 + np.cos(theta)) / np.sin(theta) ** 2 * (1 + off)
    starts = zip(theta, phi_dot, omega3, strict=True)
    motions = [top.motion(theta=x, theta_dot=0.4, phi_dot=y, omega3=z) for x, y, z in starts]
    assert {motion.regime for motion in motions} == {regime}


def test_regime_of_a_top_without_weight():
    top = rt.HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5, g=0.0)
    assert top.motion(theta=0.5, phi_dot=1.0, omega3=3.0).regime == "free precession"


def test_asymptotic_to_the_upright():
    """p_φ = p_ψ and the energy of the upright: a slow top that climbs for ever."""
    theta, omega3 = 1.0, 2.0
    b, mu, u = 0.5 * omega3, 9.81 * 0.5, math.cos(1.0)
    phi_dot = b / (1 + u)  # p_φ = p_ψ
    theta_dot = -math.sqrt(2 * mu * (1 - u) - (phi_dot * math.sin(theta)) ** 2)
    motion = TOP.motion(theta=theta, theta_dot=theta_dot, phi_dot=phi_dot, omega3=omega3)
    assert motion.regime == "asymptotic"
    path = motion.exact([0.0, 2.0, 4.0, 6.0]).theta
    assert np.all(np.diff(path) < 0)
    assert path[-1] < 1e-4
    assert motion.nutation_period == math.inf
    # All the time but a little it is next to upright, where φ̇ = p_ψ/(2λ₁).
    assert motion.mean_precession == pytest.approx(b / 2, rel=1e-14)
    assert motion.exact([40.0]).phi[0] / 40.0 == pytest.approx(b / 2, rel=0.05)


def test_a_pendulum_that_never_arrives_does_not_precess():
    motion = TOP.motion(theta=math.pi, theta_dot=2 * math.sqrt(9.81 * 0.5), omega3=0.0)
    assert motion.nutation_period > 10 * math.pi / math.sqrt(9.81 * 0.5)
    assert TOP.motion(theta=0.0, omega3=0.0).precession_per_period == 0.0
    assert rt.FreeBody(1.0, 2.0, 2.5).motion(omega=(0, 0, 0)).precession_per_period == 0.0


@pytest.mark.parametrize(
    ("omega", "regime"),
    [
        ((1.0, 0.1, 0.0), "long axis"),
        ((0.0, 0.1, 1.0), "short axis"),
        ((0.0, 1.0, 0.0), "steady"),
        ((0.0, 0.0, 0.0), "steady"),
        ((0.0, 0.0, -2.0), "steady"),
        ((1.0, 0.3, math.sqrt(0.8)), "separatrix"),
    ],
)
def test_regimes_of_a_free_body(omega, regime):
    # λ₁(λ₂ − λ₁)ω₁² = λ₃(λ₃ − λ₂)ω₃² on the separatrix: 1 = 1.25 ω₃².
    assert rt.FreeBody(1.0, 2.0, 2.5).motion(omega=omega).regime == regime


@pytest.mark.parametrize("tilt", [0.3, 0.5, 0.7, 1.0, 2.5])
def test_what_is_asymptotic_has_no_period(tilt):
    """Also where rounding leaves a little of the distance from the separatrix."""
    speed = math.sqrt(2 * 9.81 * 0.5 * (1 - math.cos(tilt)))
    motion = TOP.motion(theta=tilt, theta_dot=speed, omega3=0.0)
    assert (motion.regime, motion.nutation_period) == ("asymptotic", math.inf)
    assert motion.mean_precession == motion.precession_per_period == 0.0
    omega = tilt, 1.0, math.sqrt(0.8) * tilt
    free = rt.FreeBody(1.0, 2.0, 2.5).motion(omega=omega)
    assert (free.regime, free.nutation_period) == ("separatrix", math.inf)
    momentum = np.linalg.norm(np.array([1.0, 2.0, 2.5]) * omega)
    assert free.mean_precession == pytest.approx(momentum / 2, rel=1e-14)


@pytest.mark.parametrize("phi_dot", [0.0, 1e-18, 1e-17, -1e-16, 1e-15])
def test_a_plane_pendulum_does_not_precess(phi_dot):
    """Also where rounding is all that takes it past the vertical, as it does for ψ ≠ 0."""
    for theta_dot, psi in ((0.0, 0.0), (1.0, 3.0), (9.0, 0.0)):
        motion = TOP.motion(theta=0.5, theta_dot=theta_dot, phi_dot=phi_dot, psi=psi, omega3=0.0)
        assert motion.regime == "plane"
        assert motion.precession_per_period == motion.mean_precession == 0.0


@pytest.mark.parametrize("apart", [1e-3, 1e-6, 1e-9, 1e-12])
def test_a_small_ellipse_is_not_plane(apart):
    """A pendulum next to the hanging one, whose p_φ is tiny, and so are all that it could have."""
    rate = math.sqrt(9.81 * 0.5)
    around = TOP.motion(theta=math.pi - apart, phi_dot=rate / 2, omega3=0.0)
    assert around.regime == "waves"
    assert around.mean_precession == pytest.approx(rate, rel=1e-5)


@pytest.mark.parametrize("theta", [0.01, 0.5, 2.0, 3.0])
def test_half_turns_at_the_vertical_are_no_precession(theta):
    """To rounding, which says on which side the axis passes: the sides differ by 2π."""
    spins = np.linspace(10.0, 60.0, 101)
    tops = rt.top_motions(
        lambda1=1.0, lambda3=0.5, M=1.0, R=0.5, theta=theta, theta_dot=0.3, omega3=spins,
        phi_dot=0.5 * spins / (1 + math.cos(theta)),
    )  # fmt: skip
    through = tops.regime == "through the vertical"
    assert through.sum() > 90
    turned = tops.precession_per_period[through]
    assert np.abs(np.diff(turned)).max() < 2
    for motion in (
        TOP.motion(theta=theta, theta_dot=0.3, omega3=w, phi_dot=0.5 * w / (1 + math.cos(theta)))
        for w in spins[through][::10]
    ):
        if motion.regime == "through the vertical":
            alike = turned[spins[through] == motion.omega[2]]
            assert motion.precession_per_period == pytest.approx(alike[0], rel=1e-9)


@pytest.mark.parametrize("phi", [0.0, 100 * math.pi, -1e4, 1e6 * math.pi])
@pytest.mark.parametrize("psi", [0.0, 0.7, 100 * math.pi, -1e6])
def test_turns_at_the_start_cost_no_digits(phi, psi):
    """One motion at a time as well as an array of them: θ and the rates do not depend on φ."""
    start = {"theta": 0.5, "theta_dot": 0.1, "phi_dot": 1.0, "omega3": 40.0, "phi": phi, "psi": psi}
    times = np.array([0.0, 1.3])
    alone = TOP.motion(**start)
    of_many = rt.top_motions(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5, **start).exact(times)
    runs = (of_many, alone.exact(times), alone.integrate(times, rtol=1e-13, atol=1e-14))
    for run in runs:
        assert abs(run.theta_dot[0] - 0.1) < 1e-15
        assert abs(run.phi_dot[0] - 1.0) < 1e-15
    for run, bound in zip(runs[1:], (2e-14, 1e-10), strict=True):
        for name in ("theta", "theta_dot", "phi_dot"):
            assert abs(getattr(run, name)[1] - getattr(of_many, name)[1]) < bound
    for rate in TOP.steady_precession(0.5, 40.0):
        steady = TOP.motion(theta=0.5, phi_dot=rate, omega3=40.0, phi=phi, psi=psi)
        assert steady.regime == "steady"


# --- Late times, many samples, other bodies ---


def test_phi_and_psi_are_continuous():
    motion = TOP.motion(theta=0.2, theta_dot=1.0, phi_dot=9.0, psi_dot=10.0)
    run = motion.exact(np.linspace(-10, 10, 200_001))
    assert np.abs(np.diff(run.phi)).max() < 0.1
    assert np.abs(np.diff(run.psi)).max() < 0.1
    assert abs(run.phi[100_000]) < 1e-14


ARM = (0.15, -0.2, 0.1)


@pytest.mark.parametrize(
    ("moments", "centre"),
    [
        ((0.5, 1.0, 1.0), (0.4, 0.0, 0.0)),
        ((0.5, 1.0, 1.0), (-0.4, 0.0, 0.0)),
        ((1.0, 0.5, 1.0), (0.0, 0.4, 0.0)),
        ((1.0, 0.5, 1.0), (0.0, -0.4, 0.0)),
        ((1.0, 1.0, 0.5), (0.0, 0.0, -0.4)),
        ((1.0, 1.0, 1.0), ARM),
        ((1.0, 1.0, 1.0), tuple(-x for x in ARM)),
        ((1.0, 1.0, 1.0), (0.0, 0.0, -0.3)),
        ((1.0, 1.0, 1.0), (0.0, 0.0, 0.3)),
    ],
)
def test_a_symmetric_body_whatever_its_axes_are_called(moments, centre):
    body = rt.HeavyBody(*moments, M=1.0, centre_of_mass=centre)
    motion = body.motion(omega=(1.0, -2.0, 5.0), attitude=Rotation.from_rotvec([0.4, 0.5, -0.3]))
    times = [0.0, 1.0, -2.0, 5.0]
    exact, solved = motion.exact(times), motion.integrate(times, rtol=1e-12, atol=1e-13)
    turned, apart = differences(exact, solved)
    assert turned.max() < 1e-10
    assert apart.max() < 1e-9
    assert max(exact.drift().values()) < 1e-14
    run = motion.exact(np.linspace(0, 30, 6001))
    direction = np.array(centre) / np.linalg.norm(centre)
    if moments[0] == moments[1] and centre[:2] == (0, 0):
        direction = np.array([0.0, 0.0, 1.0])
    axis = run.rotation.apply(direction)
    tilts = np.arctan2(np.hypot(axis[:, 0], axis[:, 1]), axis[:, 2])
    assert_allclose(motion.turning_points, (tilts.min(), tilts.max()), atol=1e-4)
    azimuth = np.unwrap(np.arctan2(axis[:, 1], axis[:, 0]))
    turned = azimuth[-1] - azimuth[0]
    assert abs(turned - 30 * motion.mean_precession) < abs(motion.precession_per_period) + 1


def test_a_body_without_closed_form_says_so():
    body = rt.HeavyBody(3.0, 2.0, 1.5, M=1.0, centre_of_mass=(0.2, 0.3, 0.4))
    with pytest.raises(rt.RigidtopError, match=r"no closed form: .* integrate the motion instead"):
        body.motion(omega=(1.0, 2.0, 3.0)).exact(1.0)


@given(theta=st.floats(0, math.pi), theta_dot=rates, phi_dot=rates, omega3=spins)
@example(theta=3.972981280204418e-161, theta_dot=1.0, phi_dot=0.0, omega3=1.0)
@example(theta=1e-155, theta_dot=-1.0, phi_dot=2.0, omega3=10.0)
def test_the_closed_form_conserves(theta, theta_dot, phi_dot, omega3):
    motion = TOP.motion(theta=theta, theta_dot=theta_dot, phi_dot=phi_dot, omega3=omega3)
    run = motion.exact(np.linspace(-50, 100, 301))
    assert max(run.drift().values()) < 1e-13


@pytest.mark.parametrize("speed", [1e-40, 1e-60, 1e-90, 1e-149, 1e-151, 1e-200, 1e-310])
@pytest.mark.parametrize("theta", [0.0, math.pi])
def test_motions_too_small_for_a_square_are_none_or_right(theta, speed):
    run = TOP.motion(theta=theta, theta_dot=speed, omega3=0.0).exact([0.0, 1.0])
    assert np.all(np.isfinite(run.rotation.as_quat()))
    assert_allclose(run.theta, theta, atol=1e-35)


# --- Many motions ---


def spread(count):
    random = np.random.default_rng(7)
    return {
        "lambda1": random.uniform(0.8, 1.2, count),
        "lambda3": 0.5,
        "M": 1.0,
        "R": random.uniform(0.1, 0.5, count),
        "theta": random.choice([0.0, math.pi, 0.3, 1.0, 3.0], count),
        "theta_dot": random.choice([0.0, 0.1, -1.0], count),
        "phi": random.uniform(-3, 3, count),
        "phi_dot": random.choice([0.0, 1.0], count),
        "psi": 0.1,
        "omega3": random.choice([0.0, 1.0, 30.0], count),
    }


def one_of(values, k):
    chosen = {name: float(np.broadcast_to(value, 40)[k]) for name, value in values.items()}
    body = {name: chosen.pop(name) for name in ("lambda1", "lambda3", "M", "R")}
    return rt.HeavyTop(**body).motion(**chosen)


def test_many_tops_are_each_alone(monkeypatch):
    monkeypatch.setattr(many, "CHUNK", 7)
    values, times = spread(40), np.array([[0.0], [1.5], [-4.0]])
    told = []
    motions = rt.top_motions(**values)
    states = motions.exact(times, progress=lambda done, total: told.append((done, total)))
    assert states.theta.shape == (3, 40)
    assert told[-1] == (120, 120)
    assert len(told) == 18
    for k in range(40):
        alone = one_of(values, k)
        run = alone.exact(times[:, 0])
        assert_allclose(states.theta[:, k], run.theta, atol=1e-13)
        # Where the axis passes through the vertical φ and ψ jump by π, to rounding.
        turned = (Rotation.from_quat(np.roll(states.quaternion[:, k], -1, axis=-1)).inv()) * (
            run.rotation
        )
        assert turned.magnitude().max() < 1e-12
        assert_allclose(states.omega[:, k], run.omega, atol=1e-11)
        assert motions.regime[k] == alone.regime
        assert motions.nutation_period[k] == pytest.approx(alone.nutation_period, rel=1e-12)
        smallest, largest = motions.turning_points
        assert_allclose((smallest[k], largest[k]), alone.turning_points, atol=1e-12)


def test_one_top_and_none_are_many_too():
    body = {"lambda1": 1.0, "lambda3": 0.5, "M": 1.0, "R": 0.5}
    one = rt.top_motions(**body, theta=0.5, omega3=40.0)
    assert (one.shape, one.regime.shape, str(one.regime)) == ((), (), "cusps")
    alone = rt.HeavyTop(**body).motion(theta=0.5, omega3=40.0)
    assert one.exact(2.0).theta == alone.exact(2.0).theta[0]
    assert one.nutation_period == alone.nutation_period
    spun = {"theta": 0.5, "phi_dot": 1.0, "psi_dot": 40.0}
    found = rt.top_motions(**body, **spun).nutation_period
    assert found == rt.HeavyTop(**body).motion(**spun).nutation_period
    none = rt.top_motions(**body, theta=[], omega3=40.0)
    assert none.exact(2.0).theta.shape == (0,)
    assert none.regime.shape == (0,)


def test_many_free_bodies_are_each_alone():
    moments = np.array([[1.0, 2.0, 2.5], [2.0, 2.0, 1.0], [1.5, 1.5, 1.5], [2.5, 1.0, 2.0]])
    omega = np.array([[1.0, 0.1, 0.3], [0.1, -2.0, 1.0], [1.0, 2.0, 3.0], [0.0, 0.0, 1.0]])
    motions = rt.free_motions(moments=moments, omega=omega)
    quaternion, rates = motions.exact(np.array([[0.3], [5.0]]))
    assert quaternion.shape == (2, 4, 4)
    for k in range(4):
        alone = rt.FreeBody(*moments[k]).motion(omega=omega[k])
        run = alone.exact([0.3, 5.0])
        assert_allclose(rates[:, k], run.omega, atol=1e-14)
        overlap = np.sum(quaternion[:, k] * np.roll(run.rotation.as_quat(), 1, axis=-1), axis=-1)
        assert_allclose(np.abs(overlap), 1.0, atol=1e-14)
        assert motions.regime[k] == alone.regime
        assert motions.mean_precession[k] == pytest.approx(alone.mean_precession)
        assert motions.precession_per_period[k] == pytest.approx(alone.precession_per_period)
        assert [x[k] for x in motions.turning_points] == pytest.approx(alone.turning_points)
        assert motions.nutation_period[k] == pytest.approx(alone.nutation_period)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"lambda1": [1.0, -1.0]}, "lambda1 must be more than 0, not -1"),
        ({"theta": [0.1, 4.0]}, r"theta must be at most 3.14159, not 4"),
        ({"theta": [0.1, math.nan]}, "theta must be finite: it contains NaN or infinity"),
        ({"omega3": "fast"}, "omega3 must be numbers, not 'fast'"),
        ({"omega3": [1.0, 2.0, 3.0]}, r"these shapes do not broadcast: .*omega3 \(3,\)"),
        (
            {"R": [0.5, 2.0]},
            r"lambda1 is too small in 1 of 2: it must be at least MR² \+ lambda3/2",
        ),
        ({"psi_dot": 1.0}, "give omega3 or psi_dot, one of them"),
        ({"g": 1e-200}, "g must be 0 or not so tiny, not 1e-200"),
    ],
)
def test_bad_arrays_say_what_is_wrong(change, message):
    values = {
        "lambda1": [1.0, 1.1],
        "lambda3": 0.5,
        "M": 1.0,
        "R": 0.5,
        "theta": 0.5,
        "omega3": 1.0,
    }
    with pytest.raises(rt.RigidtopError, match=message):
        rt.top_motions(**{**values, **change})


def test_times_that_do_not_fit_the_motions():
    motions = rt.top_motions(lambda1=1, lambda3=0.5, M=1, R=0.5, theta=[0.1, 0.2], omega3=1)
    with pytest.raises(rt.RigidtopError, match=r"t of shape \(3,\) does not broadcast"):
        motions.exact([1.0, 2.0, 3.0])


# --- One time, and many ---


@given(theta=angles, theta_dot=rates, phi_dot=rates, omega3=spins)
@settings(max_examples=30)
def test_one_top_is_as_many_are(theta, theta_dot, phi_dot, omega3):
    start = {"theta": theta, "theta_dot": theta_dot, "phi_dot": phi_dot, "omega3": omega3}
    times = np.array([0.0, 0.3, -4.0])
    one = [TOP.motion(**start).exact(t) for t in times]
    body = {"lambda1": 1.0, "lambda3": 0.5, "M": 1.0, "R": 0.5}
    many_tops = rt.top_motions(**body, **start).exact(times)
    for name in ("theta", "theta_dot", "v_phi", "phi", "psi"):
        found = np.array([getattr(run, name)[0] for run in one])
        size = 1 + np.abs(found).max()
        assert_allclose(getattr(many_tops, name), found, atol=4e-14 * size)


@pytest.mark.parametrize("count", [300, 4_000, 100_000])
@pytest.mark.parametrize(
    "omega", [(1.0, 0.2, 0.3), (0.3, 0.1, 1.0), (0.01, 2.0, 0.01), (0.0, 0.0, 1.0), (0, 0, 0)]
)
def test_many_samples_of_a_free_body_are_those_of_few(omega, count):
    motion = rt.FreeBody(1.0, 2.0, 2.5).motion(omega=omega)
    times = np.linspace(-20.0, 30.0, count)
    run, few = motion.exact(times), motion.exact(times[:: count // 30])
    assert_allclose(run.quaternion[:: count // 30], few.quaternion, atol=1e-13)
    assert_allclose(run.omega[:: count // 30], few.omega, atol=1e-13)


COURSES = {
    "loops": {"theta": 1.0, "phi_dot": -3.0, "omega3": 30.0},
    "close to straight down": {"theta": 2.0, "theta_dot": 3.0, "phi_dot": -4.0, "omega3": 16.7},
    "steady": {"theta": 1.0, "phi_dot": 0.25, "omega3": 39.3},
    "falling": {"theta": 0.1, "omega3": 2.0},
    "pendulum": {"theta": 1.0, "theta_dot": 0.5, "omega3": 0.0},
}


@pytest.mark.parametrize(("count", "end"), [(300, -37.0), (4_000, 10.0), (100_000, -37.0)])
@pytest.mark.parametrize("name", COURSES)
def test_many_samples_of_a_top_are_those_of_few(name, count, end):
    motion = TOP.motion(psi=1.0, **COURSES[name])
    times = np.linspace(0.7, end, count)
    run = motion.exact(times)
    if count == 100_000:
        orbit = motion.orbit
        even = samples.samples(times, orbit.smoothness, orbit.states, orbit.sizes)
        assert len(even.others) < count / 4
    some = np.append(np.arange(0, count, count // 29), count - 1)
    few = motion.exact(times[some])
    for quantity in ("theta", "phi", "psi", "theta_dot", "phi_dot", "psi_dot", "cos_half"):
        found, expected = getattr(run, quantity)[some], getattr(few, quantity)
        size = 1 + np.abs(expected).max() + (quantity.endswith("dot") and np.ptp(few.phi))
        late = 10 + abs(motion.orbit.rate * end)
        assert_allclose(found, expected, rtol=0, atol=2e-15 * late * size, err_msg=quantity)


def test_pieces_that_are_too_long_are_not_taken():
    """A motion that is said to be slower promises longer ones; then none is taken."""
    motion = TOP.motion(theta=1.0, phi_dot=0.25, omega3=39.3)
    times, orbit = np.linspace(0.0, 5.0, 4000), motion.orbit
    for slower, taken in ((1, True), (30, False)):
        rate, turning = orbit.smoothness.rate / slower, orbit.smoothness.turning / slower
        smoothness = replace(orbit.smoothness, rate=rate, turning=turning)
        found = samples.samples(times, smoothness, orbit.states, orbit.sizes)
        assert (found is not None) == taken
