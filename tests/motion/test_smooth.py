"""The top on a smooth plane in closed form, against its equations of motion and limits."""

import math
from dataclasses import replace

import numpy as np
import pytest

import rigidtop as rt
from rigidtop.motion.table import smooth

BODY = {"lambda1": 1.0, "lambda3": 0.5, "M": 1.0, "R": 0.5}
STARTS = {
    "loops": {"theta": 0.5, "theta_dot": 0.1, "phi_dot": 1.0, "omega3": 40.0},
    "cusps": {"theta": 0.5, "omega3": 40.0},
    "waves": {"theta": 0.8, "theta_dot": -0.6, "phi_dot": 0.3, "omega3": 12.0},
    "backwards": {"theta": 1.0, "theta_dot": 0.2, "phi_dot": -0.5, "omega3": -15.0},
    "near the vertical": {"theta": 0.02, "theta_dot": 0.01, "omega3": 30.0},
}
SEEN = ("theta", "phi", "psi", "theta_dot", "phi_dot", "psi_dot")
KEPT = ("energy", "angular_momentum", "jellett", "velocity")
WHERE = ("position", "contact", "slip", "normal_force")


def motion(start, tip=0.0, **changes):
    body = rt.SlidingTop(**(BODY | {"fall": 3.0} | changes), tip=tip)
    return body.motion(**start, phi=0.3, psi=-0.2, velocity=(0.1, -0.3))


@pytest.mark.parametrize(
    ("start", "tip"),
    [
        ("loops", 0.0),
        ("cusps", 0.1),
        ("waves", 0.9),
        ("backwards", 0.1),
        ("near the vertical", 0.5),
    ],
)
def test_closed_form_is_the_integrated_motion(start, tip):
    """Sharp, round, a ball with its mass in the middle (h = 0), its mass below the middle."""
    times = np.array([7.0, 0.0, 0.3, 1.9, 10.0])
    run = motion(STARTS[start], tip)
    exact, solved = run.exact(times), run.integrate(times, rtol=1e-12, atol=1e-14)
    fast = 1 / math.sin(run.start().theta[0])
    for name in (*SEEN, *KEPT, *WHERE):
        found, wanted = getattr(exact, name), getattr(solved, name)
        assert found == pytest.approx(wanted, rel=1e-11, abs=2e-10 * fast), name
    assert (exact.rotation.inv() * solved.rotation).magnitude().max() < 1e-10


@pytest.mark.parametrize(
    ("start", "tip"),
    [
        ({"theta": 0.0, "theta_dot": 1.0, "omega3": 20.0}, 0.1),
        ({"theta": 0.0, "theta_dot": -0.7, "omega3": -30.0}, 0.9),
        (
            {"theta": 0.4, "theta_dot": 1.5, "omega3": 24.0, "phi_dot": 12.0 / (1 + math.cos(0.4))},
            0.0,
        ),
    ],
)
def test_through_the_vertical(start, tip):
    """φ and ψ jump there by a half turn, so attitudes are compared."""
    times = np.array([7.0, 0.0, 0.3, 1.9, 2.7, 10.0])
    run = motion(start, tip)
    exact, solved = run.exact(times), run.integrate(times, rtol=1e-12, atol=1e-14)
    assert run.exact(np.linspace(0, 10, 4001)).theta.min() < 0.02
    assert (exact.rotation.inv() * solved.rotation).magnitude().max() < 1e-9
    assert exact.omega == pytest.approx(solved.omega, abs=1e-8)
    assert exact.contact == pytest.approx(solved.contact, abs=1e-9)
    energy = exact.energy
    assert energy == pytest.approx(energy[1], rel=1e-13)


def test_a_wrong_plane_is_seen():
    """The held top's inertia, or N forgotten about the axis, are far off."""
    times = np.linspace(0, 5, 11)
    run = motion(STARTS["waves"], 0.1)
    solved = run.integrate(times, rtol=1e-12, atol=1e-14)
    for changes in ({"lambda1": 1 + 1e-6}, {"R": 0.5 + 1e-6}, {"M": 1 + 1e-6}):
        other = replace(run, body=replace(run.body, **changes)).exact(times)
        assert np.abs(other.theta - solved.theta).max() > 1e-8


def test_momenta_and_energy_are_exchanged_exactly():
    """N acts off the axis of a round tip; L_z and L₃ about the centre of mass stay all the same."""
    run = motion(STARTS["waves"], 0.3).exact(np.linspace(0, 1e4, 1001))
    momentum = run.angular_momentum
    assert momentum[:, 2] == pytest.approx(momentum[0, 2], rel=1e-13)
    assert run.omega3 == pytest.approx(12.0)
    assert np.ptp(np.linalg.norm(momentum[:, :2], axis=1)) > 0.05
    assert run.budget() < 1e-13
    assert run.velocity[:, :2] == pytest.approx(np.tile([0.1, -0.3], (1001, 1)), abs=1e-13)


def smooth_orbit(run):
    start, body = run.start(), run.body
    return smooth.solve(
        lambda1=body.lambda1,
        lambda3=body.lambda3,
        M=body.M,
        g=body.g,
        h=body.R - body.tip,
        theta=float(start.theta[0]),
        theta_dot=float(start.theta_dot[0]),
        v_phi=float(start.v_phi[0]),
        omega3=run.omega[2],
    )


def test_steady_precession():
    """(λ₁ cos θ)Ω² − λ₃ω₃Ω + Mgh = 0: the same as the held top's, with λ₁ about the centre."""
    theta, spin, h = 0.6, 25.0, 0.4
    discriminant = (0.5 * spin) ** 2 - 4 * math.cos(theta) * 9.81 * h
    for sign in (-1, 1):
        rate = (0.5 * spin + sign * math.sqrt(discriminant)) / (2 * math.cos(theta))
        run = motion({"theta": theta, "phi_dot": rate, "omega3": spin}, tip=0.1)
        path = run.exact([0.0, 3.0, 50.0])
        assert path.theta == pytest.approx([theta] * 3, abs=1e-13)
        assert path.phi == pytest.approx(0.3 + rate * path.t, rel=1e-12)
        assert path.normal_force == pytest.approx(9.81)


def test_small_nutation_period():
    orbit = smooth_orbit(motion({"theta": 0.6, "phi_dot": 1.0, "omega3": 300.0}))
    # Fast: e₃ goes round L at λ₃ω₃ over the two moments for θ̇ and φ̇ sin θ, λ₁ + Mh² sin²θ and λ₁.
    moment = math.sqrt(1 + 0.25 * math.sin(0.6) ** 2)
    assert orbit.nutation_period == pytest.approx(2 * math.pi * moment / (0.5 * 300), rel=0.01)


@pytest.mark.parametrize(
    ("start", "changes", "message"),
    [
        (STARTS["loops"], {"mu": 0.1}, "friction or air take energy"),
        (STARTS["loops"], {"drag3": 0.1}, "friction or air take energy"),
        ({"theta": 0.5, "omega3": 1.0}, {"fall": 1.5}, "the top falls"),
        ({"theta": 1e-8, "theta_dot": 1.0, "omega3": 20.0}, {}, "too near to the vertical"),
        ({"theta": 0.0, "omega3": 1.0}, {}, "a top sleeps that would wake"),
        ({"theta": 0.3, "theta_dot": 4.0, "omega3": 30.0}, {}, "leaves the table"),
    ],
)
def test_where_there_is_none(start, changes, message):
    with pytest.raises(rt.RigidtopError, match=message):
        motion(start, **changes).exact(1.0)


@pytest.mark.parametrize("tip", [0.1, 0.5, 0.9])
def test_normal_force_over_a_nutation(tip):
    run = motion({"theta": 0.6, "theta_dot": 1.0, "omega3": 10.0}, tip, lambda1=0.3)
    orbit = smooth_orbit(run)
    chi = np.linspace(0, np.pi, 51)
    times = orbit.time.at(chi) - orbit.time.at(np.array([orbit.chi_0]))
    forces = run.exact(times).normal_force  # from Newton's and Euler's equations
    assert orbit.normal_force(chi) == pytest.approx(forces, rel=1e-10)
    assert np.ptp(forces) > 0.1 or tip == 0.5
    assert orbit.smallest_normal_force == pytest.approx(forces.min())
