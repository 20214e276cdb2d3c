"""Motions keep what they must keep, wherever they go, and agree with closed forms."""

import math
import pickle
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import rigidtop as rt

TOP = rt.HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5)
START = {"theta_dot": 0.1, "phi_dot": 1.0, "psi_dot": 40.0}
BRICK = rt.HeavyBody(3.0, 2.0, 1.5, M=1.0, centre_of_mass=(0.2, 0.3, 0.4))


def start_of(theta):
    return TOP.motion(theta=theta, **START)


@pytest.mark.parametrize("theta", [0.5, 1e-6, math.pi - 1e-6, 0.0, math.pi])
def test_fast_top_keeps_energy_and_momenta(theta):
    run = start_of(theta).integrate(np.linspace(0, 20, 401), rtol=1e-12)
    assert set(run.drift()) == {"energy", "p_phi", "p_psi"}
    assert max(run.drift().values()) < 1e-12
    assert np.all(np.isfinite([run.phi, run.psi, run.theta_dot, run.phi_dot, run.psi_dot]))


def test_drift_sees_a_wrong_energy():
    run = start_of(0.5).integrate([0.0, 1.0])
    wrong = replace(run, v_phi=run.v_phi * 1.001)
    assert wrong.drift()["energy"] > 1e-7
    assert wrong.drift()["p_phi"] > 1e-7


def test_drift_of_a_body_at_rest_without_weight_is_zero():
    run = rt.FreeBody(1.0, 2.0, 2.5).motion(omega=(0, 0, 0)).integrate([0.0, 5.0])
    assert run.drift() == {"energy": 0.0, "angular_momentum": 0.0}


@pytest.mark.parametrize("moments", [(2.0, 2.0, 1.0), (1.0, 1.0, 1.9)])
def test_body_cone(moments):
    """(3.38) with (3.40)."""
    omega0, omega3 = 0.7, 5.0
    rate = (moments[0] - moments[2]) * omega3 / moments[0]
    t = np.linspace(-20, 20, 101)
    cone = np.stack(
        [omega0 * np.cos(rate * t), -omega0 * np.sin(rate * t), np.full(101, omega3)], axis=1
    )
    run = rt.FreeBody(*moments).motion(omega=(omega0, 0, omega3)).integrate(t, rtol=1e-12)
    assert abs(run.omega - cone).max() < 1e-10


def test_heavy_body_with_any_centre_of_mass():
    run = BRICK.motion(omega=(1.0, 2.0, 3.0)).integrate(np.linspace(0, 50, 201), rtol=1e-12)
    assert set(run.drift()) == {"energy", "p_phi"}
    assert max(run.drift().values()) < 1e-9
    # The centre of mass falls as the energy says: against T + Mgh by hand.
    height = run.rotation.apply([0.2, 0.3, 0.4])[:, 2]
    kinetic = (run.omega**2 * [3.0, 2.0, 1.5]).sum(axis=1) / 2
    assert kinetic + 9.81 * height == pytest.approx(np.full(201, run.energy[0]), abs=1e-7)


angle = st.floats(-3.0, 3.0)


@given(st.floats(0.0, math.pi), angle, angle, angle, angle, angle)
def test_energy_and_momenta_of_both_forms_agree(theta, phi, psi, theta_dot, phi_dot, psi_dot):
    """(3.44), (3.53), (3.55), (3.56) in angles against L and E of the body."""
    run = TOP.motion(
        theta=theta, phi=phi, psi=psi, theta_dot=theta_dot, phi_dot=phi_dot, psi_dot=psi_dot
    ).start()
    spin = psi_dot + phi_dot * math.cos(theta)
    kinetic = (phi_dot**2 * math.sin(theta) ** 2 + theta_dot**2 + 0.5 * spin**2) / 2
    assert run.energy[0] == pytest.approx(kinetic + 4.905 * math.cos(theta), abs=1e-13)
    p_phi = phi_dot * math.sin(theta) ** 2 + 0.5 * spin * math.cos(theta)
    assert run.p_phi[0] == pytest.approx(p_phi, abs=1e-13)
    assert run.p_psi[0] == pytest.approx(0.5 * spin, abs=1e-14)


def test_rows_are_in_the_order_of_the_times():
    motion = start_of(0.5)
    t = [3.0, -1.0, 0.0, 3.0, 1.5, -2.0]
    run = motion.integrate(t)
    assert run.t.tolist() == t
    assert run.omega.shape == run.e3.shape == run.omega_space.shape == (6, 3)
    for row, time in enumerate(t):
        alone = motion.integrate(time)
        assert alone.theta.shape == (1,)
        assert run.theta[row] == pytest.approx(alone.theta[0], abs=1e-9)
        assert run.phi[row] == pytest.approx(alone.phi[0], abs=1e-8)
    assert run.theta[2] == 0.5
    assert run.omega[2].tolist() == list(motion.omega)


def test_omega_and_momentum_in_space():
    run = BRICK.motion(omega=(1.0, 2.0, 3.0)).integrate([0.3])
    matrix = run.rotation.as_matrix()[0]
    assert run.omega_space[0] == pytest.approx(matrix @ run.omega[0])
    assert run.angular_momentum[0] == pytest.approx(matrix @ (run.omega[0] * [3.0, 2.0, 1.5]))
    assert run.e3[0] == pytest.approx(matrix @ [0, 0, 1])


@pytest.mark.parametrize("method", ["RK45", "RK23", "Radau", "BDF", "LSODA"])
def test_every_method_arrives(method):
    t = [-0.2, 0.5]
    exact = start_of(0.5).integrate(t, rtol=1e-12)
    run = start_of(0.5).integrate(t, method=method, rtol=1e-6, atol=1e-8)
    assert run.theta == pytest.approx(exact.theta, abs=1e-3)
    assert run.phi == pytest.approx(exact.phi, abs=1e-2)


def test_numbers_load_no_sympy_and_no_heyoka():
    code = (
        "import sys, rigidtop as rt; top = rt.HeavyTop(lambda1=1, lambda3=0.5, M=1, R=0.5);"
        "run = top.motion(theta=0.5, omega3=40.0).integrate([0.0, 0.1]); run.drift();"
        "rt.FreeBody(1, 2, 2.5).motion((1, 2, 3)).integrate(1.0);"
        "sys.exit(any(name.split('.')[0] in ('sympy', 'heyoka') for name in sys.modules))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False, timeout=120).returncode == 0


# --- In other processes --------------------------------------------------------------------------

COPIED = {
    "angles": start_of(0.5),
    "attitude": TOP.motion(attitude=Rotation.from_euler("y", 0.4), omega=(1, 2, 30)),
    "free": rt.FreeBody(3.0, 2.0, 1.5).motion(omega=(1, 2, 3)),
    "free symmetric": rt.FreeBody(2.0, 2.0, 1.5).motion(omega=(1, 2, 3)),
    "heavy": BRICK.motion(omega=(1, 2, 3)),
}


@pytest.mark.parametrize("name", COPIED)
@pytest.mark.parametrize("count", [1, 5, 5000])
def test_a_copy_by_pickle_is_the_same(name, count):
    """Before and after a motion is used, and what it gave; 5000 times are sampled."""
    motion, t = COPIED[name], np.linspace(0.1, 2.0, count)
    ways = ["integrate"] if name == "heavy" else ["integrate", "exact"]
    fresh = pickle.loads(pickle.dumps(motion))
    assert fresh.body == motion.body
    for way in ways:
        path = getattr(motion, way)(t)
        used = pickle.loads(pickle.dumps(motion))
        copy = pickle.loads(pickle.dumps(path))
        assert path == getattr(fresh, way)(t) == getattr(used, way)(t) == copy
        assert copy.drift() == path.drift()
        assert np.array_equal(copy.rotation.as_quat(), path.rotation.as_quat())
        assert np.array_equal(copy.motion.start().omega, motion.start().omega)


# --- Zero of either sign -------------------------------------------------------------------------

NOUGHT = {"lambda1": 1.0, "lambda3": 0.5, "M": 1.0, "R": 0.5, "g": 9.81, "theta": 0.5} | {
    "theta_dot": 0.3, "phi": 0.1, "phi_dot": 1.0, "psi": 0.2, "omega3": 20.0,
}  # fmt: skip


@pytest.mark.parametrize(
    "name", [name for name in NOUGHT if name not in ("lambda1", "lambda3", "M")]
)
def test_zero_has_no_sign(name):
    def values(zero):
        given = NOUGHT | {name: zero}
        body = {key: given.pop(key) for key in ("lambda1", "lambda3", "M", "R", "g")}
        one, many = rt.HeavyTop(**body).motion(**given), rt.top_motions(**body, **given)
        path = one.exact([zero, 1.7])
        of_all = ("nutation_period", "mean_precession", "precession_per_period", "turning_points")
        return [
            *path.columns().values(),
            *(getattr(many.exact(1.7), angle) for angle in ("theta", "phi", "psi")),
            *(getattr(each, key) for each in (one, many) for key in of_all),
        ]

    for mine, theirs in zip(values(-0.0), values(0.0), strict=True):
        assert np.array_equal(mine, theirs)
        assert not np.any(np.isnan(mine))
