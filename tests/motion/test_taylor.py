"""Taylor series arrive where Runge-Kutta does, and to rounding."""

import dataclasses
import importlib.util
import math
import subprocess
import sys

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import rigidtop as rt
from rigidtop.motion import systems, taylor
from rigidtop.motion.integrate import Accuracy

needs_heyoka = pytest.mark.skipif(
    importlib.util.find_spec("heyoka") is None, reason="heyoka is not installed"
)

TOP = rt.HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5)
BRICK = rt.HeavyBody(3.0, 2.0, 1.5, M=1.0, centre_of_mass=(0.2, 0.3, 0.4))
FINEST = Accuracy("taylor", 2.3e-16)
ANGLES = ("theta", "phi", "psi", "theta_dot", "phi_dot", "psi_dot")
T = np.concatenate([np.linspace(-5, 5, 41), [3.0, -1.0, 0.0, 3.0]])


def series(motion, t, rtol=2.3e-16):
    return motion.integrate(t, method="taylor", rtol=rtol)


@needs_heyoka
@pytest.mark.parametrize(
    "start",
    [
        {"theta": 0.5, "theta_dot": 0.1, "phi_dot": 1.0, "phi": 0.3, "psi": -7.0, "psi_dot": 40.0},
        {"theta": 2.5, "theta_dot": -1.0, "phi_dot": 3.0, "omega3": -2.0},
        {"theta": 1.0, "theta_dot": 3.0, "omega3": 0.01},  # past the poles, closely
        {"theta": 1e-6, "theta_dot": 0.1, "omega3": 9.0},
        {"theta": math.pi - 1e-6, "phi_dot": 1.0, "omega3": 9.0},
        {"theta": 0.5, "phi_dot": 2.0, "omega3": 5e1},
    ],
)
def test_tops_agree_with_dop853(start):
    motion = TOP.motion(**start)
    ours, theirs = series(motion, T), motion.integrate(T, rtol=1e-13, atol=1e-15)
    for name in ANGLES:
        allowed = 1e-9 if name in ANGLES[:3] else 1e-7  # φ̇ is large close to a pole
        assert getattr(ours, name) == pytest.approx(getattr(theirs, name), rel=1e-9, abs=allowed)
    assert ours.theta[-2] == pytest.approx(motion.start().theta[0], abs=1e-15)


@needs_heyoka
@pytest.mark.parametrize(
    "motion",
    [
        BRICK.motion(omega=(1.0, 2.0, 3.0)),
        rt.FreeBody(1.0, 2.0, 2.7).motion(omega=(0.01, 3.0, 0.01)),
        rt.FreeBody(2.0, 2.0, 1.0).motion((0.7, 0.0, 5.0), Rotation.from_rotvec([0.3, 0.4, 0.5])),
    ],
)
def test_bodies_agree_with_dop853(motion):
    ours, theirs = series(motion, T), motion.integrate(T, rtol=1e-13, atol=1e-15)
    assert ours.omega == pytest.approx(theirs.omega, abs=1e-9)
    assert (ours.rotation.inv() * theirs.rotation).magnitude().max() < 1e-9


@needs_heyoka
@pytest.mark.parametrize("theta", [0.5, 1e-6, 0.0, math.pi])
def test_drift_is_rounding(theta):
    motion = TOP.motion(theta=theta, theta_dot=0.1, phi_dot=1.0, psi_dot=40.0)
    assert max(series(motion, np.linspace(-100, 100, 101)).drift().values()) < 1e-14
    coarse = series(motion, [100.0], rtol=1e-6).drift()
    assert 1e-12 < max(coarse.values()) < 1e-4  # what is asked for is what is done


@needs_heyoka
def test_many_steps_are_taken_in_pieces(monkeypatch):
    motion = TOP.motion(theta=0.5, phi=0.1, phi_dot=1.0, omega3=40.0)
    whole = series(motion, T)
    monkeypatch.setattr(taylor, "STEPS_AT_ONCE", 7)
    pieces = series(motion, T)
    for name in ANGLES:
        assert getattr(pieces, name) == pytest.approx(getattr(whole, name), rel=1e-12)


@needs_heyoka
@pytest.mark.parametrize("kept", [3, 1_000_000])
def test_powers_that_are_kept_are_the_dense_output(monkeypatch, kept):
    """On both sides of t = 0, at the ends of steps and between, in pieces of either kind."""
    motion, times = TOP.motion(theta=0.5, phi_dot=1.0, omega3=40.0), np.linspace(-9, 9, 1001)
    monkeypatch.setattr(taylor, "STEPS_KEPT", kept)
    found = series(motion, times)
    monkeypatch.setattr(taylor, "_kept", taylor._compiled)
    dense = series(motion, times)
    for name in ANGLES:
        assert getattr(found, name) == pytest.approx(getattr(dense, name), rel=1e-12, abs=1e-13)


def small_and_linear(sign, spin, z, t):
    """z = δ exp(iφ) near upright (sign 1) or hanging (−1): λ₁z̈ − sign (iλ₃ω₃ż + MgRz) = 0."""
    p = sign * 0.25 * spin
    root = np.sqrt(complex(sign * 4.905 - p * p))
    first, second = 1j * p + root, 1j * p - root
    share = -second * z / (first - second)
    return share * np.exp(first * t) + (z - share) * np.exp(second * t)


@needs_heyoka
@pytest.mark.parametrize("delta", [1e-9, 1e-12, 1e-15, 1e-100])
@pytest.mark.parametrize(("rtol", "error"), [(2.3e-16, 1e-14), (1e-10, 1e-10)])
def test_small_motions_are_as_accurate_as_large_ones(delta, rtol, error):
    t = np.linspace(0, 20, 201)
    upright = series(TOP.motion(theta=delta, omega3=20.0), t, rtol)
    expected = abs(small_and_linear(1, 20.0, delta, t))
    assert upright.theta == pytest.approx(expected, abs=error * delta, rel=0)
    # By attitude, because π − θ has no digits.
    hanging = Rotation.from_quat([0.0, 1.0, 0.0, delta / 2])
    run = series(TOP.motion(attitude=hanging, omega=(0.0, 0.0, 20.0)), t, rtol)
    x, y, z, w = run.rotation.as_quat().T
    assert np.hypot(x, y) == pytest.approx(np.ones(201))
    expected = abs(small_and_linear(-1, 20.0, delta, t))
    assert 2 * np.hypot(z, w) == pytest.approx(expected, abs=error * delta, rel=0)


@needs_heyoka
def test_a_fall_from_close_to_upright():
    """Through the bottom: from rest tan(θ/4) grows like e^κt, to θ₀e^κt/8."""
    t = np.linspace(0, 15, 301)
    run = series(TOP.motion(theta=1e-12, omega3=0.0), t)
    assert run.theta.max() > 3
    assert max(run.drift().values()) < 1e-14
    rising = slice(120, np.argmax(run.theta > 2.5))
    expected = 4 * np.arctan(1e-12 / 8 * np.exp(math.sqrt(4.905) * t[rising]))
    assert run.theta[rising] == pytest.approx(expected, rel=1e-11)


@needs_heyoka
@pytest.mark.parametrize("speed", [1e-6, 1e-60, 1e50])
def test_a_slow_body_tumbles_like_a_fast_one(speed):
    omega, t, body = np.array([0.3, 1.0, 0.2]), np.linspace(0, 20, 41), rt.FreeBody(1.0, 2.0, 2.5)
    fast, slow = series(body.motion(omega), t), series(body.motion(omega * speed), t / speed)
    assert slow.omega / speed == pytest.approx(fast.omega, abs=1e-13)
    assert max((slow.rotation.inv() * fast.rotation).magnitude()) < 1e-13


@needs_heyoka
def test_what_does_not_move():
    run = series(rt.FreeBody(1.0, 2.0, 2.5).motion(omega=(0, 0, 0)), [5.0, -5.0, 0.0])
    assert not run.omega.any()
    assert series(TOP.motion(theta=0.0, omega3=9.0), [3.0]).psi == pytest.approx(27 - 27 / 4)


@pytest.mark.parametrize(
    ("rtol", "says"),
    [
        (1e-16, "rtol must be at least 2.3e-16, not 1e-16"),
        (0.2, "rtol must be at most 0.1, not 0.2"),
    ],
)
def test_tolerances(rtol, says):
    with pytest.raises(rt.RigidtopError, match=f"^{says}$"):
        series(TOP.motion(theta=1.0, omega3=9.0), 1.0, rtol)


def test_an_unknown_method_names_it_among_the_others():
    with pytest.raises(rt.RigidtopError) as caught:
        TOP.motion(theta=1.0, omega3=9.0).integrate(1.0, method="Euler")
    assert str(caught.value) == (
        "unknown method 'Euler': DOP853, RK45, RK23, Radau, BDF, LSODA, taylor"
    )


def test_without_heyoka(monkeypatch):
    monkeypatch.setitem(sys.modules, "heyoka", None)
    with pytest.raises(rt.RigidtopError) as caught:
        series(TOP.motion(theta=1.0, omega3=9.0), 1.0)
    assert str(caught.value) == (
        "method 'taylor' needs heyoka: pip install 'rigidtop[taylor]' (wheels for Linux only)"
    )


def test_heyoka_is_loaded_by_the_method_alone():
    code = (
        "import sys, rigidtop as rt; top = rt.HeavyTop(lambda1=1, lambda3=0.5, M=1, R=0.5);"
        "top.motion(theta=0.5, omega3=40.0).integrate([0.0, 0.1]);"
        "sys.exit('heyoka' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False, timeout=120).returncode == 0


@needs_heyoka
def test_overflow_has_one_line():
    steady = dataclasses.replace(systems.TOP, rate=lambda _, state: 1.0)
    parameters = (1.2, 0.5, 1.0, 9.81, 0.3, 7.0)
    start = np.array([0.9, 1e300, 0.4, 0.0, 1e300, 1e300])
    with pytest.raises(rt.RigidtopError, match=r"stopped at t = .* on the way to -2: the Tay") as c:
        taylor.flow(steady, parameters, start, -2.0, FINEST.rtol)
    assert "\n" not in str(c.value)
    start[4] = math.inf
    with pytest.raises(rt.RigidtopError, match=r"^the rates overflow at the start"):
        taylor.flow(systems.TOP, parameters, start, 1.0, FINEST.rtol)
