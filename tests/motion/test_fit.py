"""Measurements that were made tell the body that made them, with errors that cover."""

import re

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import rigidtop as rt

MOMENTS = np.array([1.0, 4.2, 5.0])
OMEGA = (2.0, 9.0, 3.0)
T = np.linspace(0.0, 2.0, 121)
FEW = T[::3]
TOP = rt.HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5)


def flight(t=T, moments=MOMENTS, omega=OMEGA):
    return rt.FreeBody(*moments).motion(omega).exact(t)


def noisy(values, size=0.05, seed=0):
    return values + size * np.random.default_rng(seed).normal(size=values.shape)


def nearby(fit, true):
    """Whether every value lies within four errors."""
    errors = fit.errors
    return all(abs(fit.values[name] - x) <= 4 * errors[name] + 1e-12 for name, x in true.items())


def named(moments):
    return dict(zip(("lambda1", "lambda2", "lambda3"), moments, strict=True))


def test_without_noise_it_is_the_body():
    run = flight()
    fit = rt.fit(T, omega=run.omega)
    assert np.allclose([fit.lambda1, fit.lambda2, fit.lambda3], MOMENTS, rtol=1e-9)
    assert np.allclose(fit.motion.exact(T).omega, run.omega, atol=1e-9)
    assert fit.values["E"] == pytest.approx(run.energy[0])
    assert fit.values["L"] == pytest.approx(np.linalg.norm(run.angular_momentum[0]))


@pytest.mark.parametrize("order", [(1, 2, 0), (2, 1, 0)])
def test_moments_belong_to_the_axes_as_measured(order):
    order = list(order)
    fit = rt.fit(T, omega=noisy(flight(T, MOMENTS[order], np.array(OMEGA)[order]).omega))
    assert nearby(fit, named(MOMENTS[order]))
    assert min(fit.lambda1, fit.lambda2, fit.lambda3) == 1.0


def test_covariance():
    fit = rt.fit(T, omega=noisy(flight().omega))
    assert list(fit.values) == [*named(MOMENTS), "omega1", "omega2", "omega3", "L", "E"]
    assert fit.covariance.shape == (8, 8)
    assert np.array_equal(np.diag(fit.covariance) == 0, np.arange(8) == 0)
    assert 0.001 < fit.errors["lambda2"] < 0.05
    assert np.abs(np.std(np.stack([*fit.residuals.values()])) - 0.05) < 0.005


def test_a_given_moment_is_the_scale():
    fit = rt.fit(T, omega=noisy(flight().omega), lambda2=4.2e-4)
    assert nearby(fit, named(MOMENTS * 1e-4))
    assert fit.errors["lambda2"] == 0
    two = rt.fit(T, omega=noisy(flight().omega), lambda2=4.2e-4, lambda3=5e-4)
    assert nearby(two, named(MOMENTS * 1e-4))
    assert two.errors["lambda1"] < fit.errors["lambda1"]


def test_the_clock_is_that_of_the_data():
    t = T + 7.0
    run = flight(t)
    fit = rt.fit(t, omega=noisy(run.omega))
    assert np.abs(fit.motion.exact(t).omega - run.omega).max() < 0.1


def test_a_sensor_that_is_turned():
    turn = Rotation.from_rotvec([0.3, -0.2, 0.5])
    fit = rt.fit(T, omega=noisy(turn.apply(flight().omega)), misalignment=True)
    assert nearby(fit, named(MOMENTS))
    assert nearby(fit, dict(zip(("turn1", "turn2", "turn3"), turn.as_rotvec(), strict=True)))


def test_attitudes_alone_and_with_rates():
    run = flight()
    shaken = run.rotation * Rotation.from_rotvec(noisy(np.zeros((len(T), 3)), 0.01))
    alone = rt.fit(T, attitude=shaken)
    both = rt.fit(T, omega=noisy(run.omega), attitude=shaken)
    for fit in (alone, both):
        assert nearby(fit, named(MOMENTS))
        off = fit.motion.exact(T).rotation.inv() * run.rotation
        assert off.magnitude().max() < 0.02
    assert both.errors["lambda3"] < alone.errors["lambda3"]


def test_a_symmetric_body():
    t = np.linspace(0, 4, 200)
    fit = rt.fit(t, omega=noisy(flight(t, (1.0, 1.0, 1.5), (2.0, 0.0, 9.0)).omega))
    assert nearby(fit, {"lambda3": 1.5})


def test_a_long_flight_is_no_false_minimum():
    t = np.linspace(0, 60, 600)
    fit = rt.fit(t, omega=noisy(flight(t, (1.0, 1.3, 1.9), (1.0, 9.0, 3.0)).omega, 0.3))
    assert nearby(fit, named((1.0, 1.3, 1.9)))


def test_a_top_by_its_angles():
    t = np.linspace(0, 3, 200)
    run = TOP.motion(theta=0.5, theta_dot=0.2, phi_dot=0.5, psi=0.3, omega3=20.0).exact(t)
    angles = {
        name: noisy(getattr(run, name), 0.005, k) for k, name in enumerate(("theta", "phi", "psi"))
    }
    told = {"spin": 10.0, "weight": TOP.weight[2]}
    two = rt.fit(t, theta=angles["theta"], phi=angles["phi"])
    wrapped = np.angle(np.exp(1j * angles["psi"]))
    three = rt.fit(t, **{**angles, "psi": wrapped})
    assert nearby(two, told)
    assert (two.spin, two.weight) == (two.values["spin"], two.values["weight"])
    assert nearby(three, {**told, "omega3": 20.0, "lambda3/lambda1": 0.5})
    assert np.abs(two.motion.exact(t).theta - run.theta).max() < 0.01
    assert np.abs(three.motion.exact(t).psi - run.psi).max() < 0.01


def test_errors_cover():
    """Of 8 throws with fixed seeds: about 68 % within one error, 95 % within two."""
    away, t = [], T[::4]
    for seed in range(8):
        shape = np.random.default_rng(seed)
        moments = np.array([1.0, shape.uniform(1.2, 1.8), shape.uniform(1.9, 2.2)])
        omega = shape.normal(size=3) * 8 + np.array([3.0, 3.0, 3.0])
        fit = rt.fit(t, omega=noisy(flight(t, moments, omega).omega, 0.1, seed))
        away += [(fit.values[n] - x) / fit.errors[n] for n, x in list(named(moments).items())[1:]]
    within = np.abs(away)
    assert 0.5 < (within < 1).mean() < 0.85
    assert (within < 2).mean() > 0.85


SPIN = "moments cannot be known from this: a body that tumbles explains"


@pytest.mark.parametrize(("axis", "size"), [(0, 0.05), (1, 0.0), (2, 1e-9)])
def test_a_spin_along_a_principal_axis_tells_nothing(axis, size):
    omega = np.tile(9.0 * np.eye(3)[axis], (len(FEW), 1))
    with pytest.raises(rt.RigidtopError, match=SPIN):
        rt.fit(FEW, omega=noisy(omega, size))


def test_a_ball_tells_nothing():
    for omega in (noisy(np.tile((1.0, 2.0, 3.0), (len(FEW), 1))), np.zeros((len(FEW), 3))):
        with pytest.raises(rt.RigidtopError, match=SPIN):
            rt.fit(FEW, omega=omega)


def test_a_steady_precession_tells_nothing():
    slow, _ = TOP.steady_precession(0.5, 20.0)
    run = TOP.motion(theta=0.5, phi_dot=slow, omega3=20.0).exact(T)
    with pytest.raises(rt.RigidtopError, match="a steady precession, which tells one relation"):
        rt.fit(T, theta=noisy(run.theta, 0.005), phi=noisy(run.phi, 0.005, 1))


ROWS = {"t": T, "omega": np.ones((len(T), 3))}


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"omega": np.ones((5, 3))}, "omega must be of shape (121, 3), as t has it, not (5, 3)"),
        ({"omega": np.full((len(T), 3), np.nan)}, "omega must be finite"),
        ({"t": T[::-1]}, "t must increase"),
        ({"t": [0, 1, 2], "omega": np.ones((3, 3))}, "3 rows are too few"),
        ({"t": "never"}, "t must be a number"),
        ({"lambda1": -1.0}, "lambda1 must be positive"),
        ({"theta": T}, "give omega or attitude of a free body, or theta and phi of a top"),
        ({"omega": None}, "give omega or attitude of a free body, or theta and phi of a top"),
        ({"omega": None, "lambda1": 1.0}, "moments and misalignment go with omega"),
        ({"attitude": Rotation.identity()}, "attitude must be a scipy Rotation of 121"),
        ({"attitude": "up"}, "attitude must be a scipy Rotation of 121"),
        ({"omega": None, "theta": T, "phi": T}, "theta must be more than 0"),
    ],
)
def test_what_does_not_fit_together(change, says):
    with pytest.raises(rt.RigidtopError, match=re.escape(says)):
        rt.fit(**{**ROWS, **change})
