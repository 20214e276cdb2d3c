"""However little moves, it moves as it should: closed solutions of the linearised equations."""

import math

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import rigidtop as rt
from rigidtop.motion.attitude import quaternions, spinors

TOP = rt.HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5)
SLEEPING = TOP.sleeping_spin()  # 8.86 rad/s
TILTS = [1e-6, 1e-7, 1e-12, 1e-100]


def linear(sign, spin, z, z_dot, t):
    """z = δ exp(iφ), δ the small angle from the upright (sign 1) or the hanging (−1) position.

    λ₁z̈ − sign (iλ₃ω₃ż + MgRz) = 0: (3.54) and (3.55) to first order in δ.
    """
    p, weight = sign * TOP.lambda3 * spin / 2, sign * 4.905
    root = np.sqrt(complex(weight - p * p))
    first, second = 1j * p + root, 1j * p - root
    share = (z_dot - second * z) / (first - second)
    return share * np.exp(first * t) + (z - share) * np.exp(second * t)


def hanging(delta, phi, spin):
    """At δ from straight down; θ = π − δ itself has no digits for a small δ."""
    half = phi / 2  # ψ = 0
    alpha, beta = math.sin(delta / 2), math.cos(delta / 2)
    x, y = -beta * math.sin(half), beta * math.cos(half)
    attitude = Rotation.from_quat([x, y, alpha * math.sin(half), alpha * math.cos(half)])
    return TOP.motion(attitude=attitude, omega=(0.0, 0.0, spin))


def from_below(run):
    """π − θ, with its digits."""
    alpha, beta = spinors(quaternions(run.rotation).T)
    return 2 * np.arctan2(abs(alpha), abs(beta))


def close(run, delta, expected, allowed=1e-9):
    """δ and φ, as curves; φ to its own turns."""
    assert np.max(abs(delta / abs(expected) - 1)) < allowed
    assert np.max(abs(run.phi - np.unwrap(np.angle(expected)))) < allowed


@pytest.mark.parametrize("theta", TILTS)
@pytest.mark.parametrize("spin", [20.0, -20.0, 1.2 * SLEEPING])
def test_upright_above_the_sleeping_spin(theta, spin):
    t = np.linspace(0, 5, 201)
    run = TOP.motion(theta=theta, phi=0.4, omega3=spin).integrate(t)
    close(run, run.theta, linear(1, spin, theta * np.exp(0.4j), 0, t))


@pytest.mark.parametrize("theta", TILTS[2:])
@pytest.mark.parametrize("spin", [0.9 * SLEEPING, 5.0, 0.0])
def test_upright_below_the_sleeping_spin(theta, spin):
    """Which grows by up to e¹¹ in 5 s; the first two tilts would be no longer small then."""
    t = np.linspace(0, 5, 201)
    run = TOP.motion(theta=theta, phi=0.4, omega3=spin).integrate(t)
    close(run, run.theta, linear(1, spin, theta * np.exp(0.4j), 0, t), 3e-9)


@pytest.mark.parametrize("delta", TILTS)
@pytest.mark.parametrize("spin", [20.0, 3.0])
def test_hanging(delta, spin):
    t = np.linspace(0, 5, 201)
    motion = hanging(delta, 0.4, spin)
    run = motion.integrate(t)
    assert motion.phi == pytest.approx(0.4)
    close(run, from_below(run), linear(-1, spin, delta * np.exp(0.4j), 0, t))


@pytest.mark.parametrize("theta", [1e-6, 1e-9, 1e-12])
def test_near_pi_by_its_euler_angles(theta):
    """Within what floats near π can tell: δ itself is what the start says."""
    t = np.linspace(0, 5, 201)
    run = TOP.motion(theta=math.pi - theta, phi=0.4, omega3=20.0).integrate(t)
    delta = from_below(run)
    close(run, delta, linear(-1, 20.0, delta[0] * np.exp(0.4j), 0, t))


@pytest.mark.parametrize("speed", [1e-6, 1e-15])
def test_a_push_from_upright(speed):
    """θ = 0 at first: how small the motion is only ω₁ and ω₂ say."""
    t = np.linspace(0.01, 5, 201)
    run = TOP.motion(theta=0.0, theta_dot=speed, omega3=20.0).integrate(t)
    expected = linear(1, 20.0, 0, speed, t)
    assert np.max(abs(run.theta - abs(expected))) < 1e-9 * speed


@pytest.mark.parametrize("method", ["RK45", "RK23", "Radau", "BDF", "LSODA"])
def test_with_every_method(method):
    t = np.linspace(0, -1, 21)
    run = TOP.motion(theta=1e-12, omega3=20.0).integrate(t, method=method, rtol=1e-6, atol=1e-8)
    close(run, run.theta, linear(1, 20.0, 1e-12, 0, t), 0.02 if method == "BDF" else 2e-3)


@pytest.mark.parametrize("phi", [0.0, 0.7])
def test_a_fall_from_close_to_upright(phi):
    """From 1e-12 through the bottom: tolerances follow, or rounding would halt the steps.

    All but on the separatrix of the pendulum, where tan(θ/4) grows like e^κt; from rest at θ₀ it is
    θ₀e^κt/8 as soon as e^−2κt is nothing.
    """
    t = np.linspace(0, 15, 301)
    run = TOP.motion(theta=1e-12, phi=phi, psi=-phi, omega3=0.0).integrate(t)
    assert run.theta.max() > 3
    assert max(run.drift().values()) < 1e-9
    kappa = math.sqrt(4.905)
    rising = slice(40, np.argmax(run.theta > 2.5))
    expected = 4 * np.arctan(1e-12 / 8 * np.exp(kappa * t[rising]))
    assert run.theta[rising] == pytest.approx(expected, rel=1e-7)


def test_a_slowly_spinning_top_falls_and_rises_again():
    run = TOP.motion(theta=1e-14, phi=1.0, psi=-1.0, omega3=5.0).integrate(np.linspace(0, 40, 9))
    assert run.theta.max() > 0.1
    assert max(run.drift().values()) < 1e-9


@pytest.mark.parametrize("speed", [1.0, 1e-6, 1e-13, 1e-60])
def test_a_slow_body_tumbles_like_a_fast_one(speed):
    """Times 1/speed, all is the same."""
    omega, t = np.array([0.3, 1.0, 0.2]), np.linspace(0, 20, 41)
    body = rt.FreeBody(1.0, 2.0, 2.5)
    fast = body.motion(omega=omega).integrate(t, rtol=1e-13, atol=1e-15)
    slow = body.motion(omega=omega * speed).integrate(t / speed)
    assert slow.omega / speed == pytest.approx(fast.omega, abs=1e-8)
    assert max((slow.rotation.inv() * fast.rotation).magnitude()) < 1e-8


@pytest.mark.parametrize("small", [1e-6, 1e-14])
def test_a_free_body_close_to_its_stable_axis(small):
    """ω₁ and ω₂ oscillate, as small as they are, at the rate ω₃√((λ₃−λ₁)(λ₃−λ₂)/(λ₁λ₂))."""
    t = np.linspace(0, 20, 101)
    run = rt.FreeBody(1.0, 2.0, 2.5).motion(omega=(small, 0.0, 2.0)).integrate(t)
    rate = 2 * math.sqrt(1.5 * 0.5 / 2)
    assert run.omega[:, 0] == pytest.approx(small * np.cos(rate * t), abs=2e-8 * small)


@pytest.mark.parametrize("small", [1e-6, 1e-14])
def test_a_free_symmetric_body_far_from_the_vertical(small):
    """(ω₁, ω₂) goes round at the rate ω₃(λ₃ − λ₁)/λ₁, however small it is."""
    t = np.linspace(0, 20, 101)
    attitude = Rotation.from_rotvec([0.3, 1.0, -0.5])
    body = rt.FreeBody(2.0, 2.0, 1.0)
    run = body.motion(omega=(small, 0.0, 3.0), attitude=attitude).integrate(t)
    across = small * np.exp(-1.5j * t)
    assert np.max(abs(run.omega[:, 0] + 1j * run.omega[:, 1] - across)) < 1e-9 * small
