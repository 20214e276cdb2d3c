"""Systems by constraints: they keep them, and rest and shake as by free coordinates."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Rational, cos, sin, sqrt, symbols

import rigidtop as rt

m, g, length = symbols("m g length", positive=True)
x, y, theta, phi, u, v, w, c, r, z, a, b = symbols("x y theta phi u v w c r z a b", real=True)
NUMBERS = {m: 1.5, g: 9.81, length: 2.0}
BOB = rt.System(
    m * (u**2 + v**2) / 2 - m * g * y, [x, y], [u, v], constraints=x**2 + y**2 - length**2
)
BY_ANGLE = rt.System(m * length**2 * w**2 / 2 + m * g * length * cos(theta), theta, w)


@pytest.mark.parametrize(
    ("method", "times"),
    [("taylor", (0, 200)), ("DOP853", (-20, 20)), ("LSODA", [5.0])],
)
def test_a_pendulum_by_constraint_keeps_its_length(method, times):
    run = BOB.motion(NUMBERS, [2 * np.sin(1.0), -2 * np.cos(1.0)]).integrate(times, method)
    other = BY_ANGLE.motion(NUMBERS, 1.0).integrate(times, "taylor", rtol=1e-15)
    angle, drift = other.q[:, 0], run.drift()
    assert drift["constraint 1"] < 1e-15
    assert np.max(np.abs(np.sum(run.q * run.qdot, axis=1))) < 1e-14
    assert drift["energy"] < 1e-8
    assert np.max(np.abs(run.q - 2 * np.stack([np.sin(angle), -np.cos(angle)], axis=1))) < 1e-7


def test_a_wire_that_is_moved_and_a_blade_are_kept_too():
    """A bead on a line that turns about its foot, r̈ = Ω²r; a blade slides along itself."""
    t, Omega = symbols("t Omega", real=True)
    bead = rt.System(
        m * (u**2 + v**2) / 2, [x, y], [u, v], constraints=x * sin(Omega * t) - y * cos(Omega * t)
    )
    run = bead.motion({m: 1, "Omega": 0.5}, [1, 0], [0, 0.5]).integrate((0, 6))
    along, across = np.cos(run.t / 2), np.sin(run.t / 2)
    assert np.max(np.abs(run.q[:, 0] - np.cosh(run.t / 2) * along)) < 1e-8
    turning = (run.q[:, 0] * along + run.q[:, 1] * across) / 2
    off = run.qdot[:, 0] * across - run.qdot[:, 1] * along + turning
    assert np.max(np.abs(off)) < 1e-14
    assert run.drift()["constraint 1"] < 1e-15
    blade = rt.System(
        m * (u**2 + v**2 + w**2) / 2,
        [x, y, theta],
        [u, v, w],
        constraints=u * sin(theta) - v * cos(theta),
    )
    run = blade.motion({m: 1}, [0, 0, 0], [1, 0, 2]).integrate((0, 30))
    assert np.max(np.abs(run.q[:, 0] - np.sin(2 * run.t) / 2)) < 1e-8
    assert run.drift()["constraint 1"] < 1e-15


def test_where_a_bob_rests_and_how_it_shakes():
    assert BOB.equilibria() == ({x: 0, y: -length}, {x: 0, y: length})
    low = BOB.small({x: 0, y: -length})
    assert low.free == (x,)
    assert low.stability(NUMBERS) == "stable"
    assert low.frequencies(NUMBERS) == pytest.approx([np.sqrt(9.81 / 2)])
    assert BOB.small({x: 0, y: length}).stability(NUMBERS) == "unstable"


def test_a_conical_pendulum_by_constraint_shakes_as_by_its_angle():
    turned = rt.System(
        m * (a**2 + b**2 + r**2 * c**2) / 2 - m * g * z,
        [r, z, phi],
        [a, b, c],
        constraints=r**2 + z**2 - length**2,
    )
    angles = rt.System(
        m * length**2 * (w**2 + sin(theta) ** 2 * c**2) / 2 + m * g * length * cos(theta),
        [theta, phi],
        [w, c],
    )
    tilt = Rational(7, 10)
    rate = sqrt(g / (length * cos(tilt)))
    held = turned.small({r: length * sin(tilt), z: -length * cos(tilt), c: rate})
    known = np.sqrt(9.81 / (2 * np.cos(0.7)) * (1 + 3 * np.cos(0.7) ** 2))
    assert held.frequencies(NUMBERS) == pytest.approx([known])
    assert angles.small({theta: tilt, c: rate}).frequencies(NUMBERS) == pytest.approx([known])


@pytest.mark.parametrize(
    ("about", "said"),
    [
        ({x: 0, y: 0}, "the constraint -length.* = 0 does not hold there"),
        ({x: length, y: 0}, r"no steady motion: a force of g\*m is left"),
        ({x: 0}, "gives no value for y"),
    ],
)
def test_what_is_no_steady_motion_is_said(about, said):
    with pytest.raises(rt.RigidtopError, match=said):
        BOB.small(about)


def test_constraints_that_fall_together_and_those_of_velocities_are_refused():
    flat = rt.System(m * (u**2 + v**2) / 2, [x, y], [u, v], constraints=x**2 + y**2)
    with pytest.raises(rt.RigidtopError, match="depend on one another there"):
        flat.small({x: 0, y: 0})
    rolling = rt.System(m * (u**2 + v**2) / 2, [x, y], [u, v], constraints=u - x * v)
    for asked in (rolling.equilibria, lambda: rolling.small({})):
        with pytest.raises(rt.RigidtopError, match="u - v\\*x = 0 is a constraint of velocities"):
            asked()


TURNED = rt.System(
    m * (u**2 + v**2) / 2 - m * g * (y * cos(a) + x * sin(a)),
    [x, y],
    [u, v],
    constraints=x**2 + y**2 - length**2,
)


@settings(max_examples=40, deadline=None)
@given(
    st.floats(-6, 3),
    st.floats(-3.1, 3.1),
    st.floats(-13, -4),
    st.floats(-14, -8),
    st.booleans(),
)
def test_a_pendulum_at_rest_stays_at_rest_to_any_tolerance(power, tilt, rtol, atol, upright):
    """Its weight and the rod's force cancel to rounding, which no tolerance may resolve."""
    size, sign = 10.0**power, -1 if upright else 1
    start = [-sign * size * np.sin(tilt), -sign * size * np.cos(tilt)]
    motion = TURNED.motion({m: 1.5, g: 9.81, length: size, a: tilt}, start)
    time = 3 * np.sqrt(size)  # half of a swing
    atol = max(10.0**atol, 1e-16 * size)
    run = motion.integrate((0, time), rtol=10.0**rtol, atol=atol)
    speed = np.sqrt(9.81 * size)
    assert np.max(np.abs(run.q - start)) < 1e-11 * size + atol * time
    assert np.max(np.abs(run.qdot)) < 1e-11 * speed + atol
    assert run.drift()["constraint 1"] < 1e-14


@pytest.mark.parametrize("rtol", [1e-6, 1e-10, 1e-12])
@pytest.mark.parametrize("swing", [1e-9, 1e-5, 1.0])
def test_a_pendulum_released_by_constraint_swings_as_by_its_angle(swing, rtol):
    """From rest, in axes that are tilted, so that no coordinate of the swing stands alone."""
    motion = TURNED.motion(
        {m: 1.5, g: 9.81, length: 2.0, a: 0.7},
        [2 * np.sin(swing - 0.7), -2 * np.cos(swing - 0.7)],
    )
    run = motion.integrate((0, 4), rtol=rtol, atol=1e-14)
    other = BY_ANGLE.motion(NUMBERS, swing).integrate((0, 4), "taylor", rtol=1e-15)
    along = run.q @ [np.cos(0.7), -np.sin(0.7)]
    assert np.max(np.abs(along / 2 - np.sin(other.q[:, 0]))) < 100 * rtol * swing + 5e-14


def test_a_constraint_that_ends_ends_the_motion():
    """A circle that shrinks to nothing at t = 1: there is no motion on it afterwards."""
    time = symbols("t")
    circle = rt.System(m * (u**2 + v**2) / 2, [x, y], [u, v], constraints=x**2 + y**2 + time - 1)
    for rtol in (1e-6, 1e-10, 1e-12):
        with pytest.raises(rt.RigidtopError, match="the integration stopped at t = 1 on the way"):
            circle.motion({m: 1}, [1, 0], [-0.5, 1]).integrate((0, 2), rtol=rtol)
    for off in (1e-6, 1e-3):
        with pytest.raises(rt.RigidtopError, match="does not hold at the start"):
            BOB.motion(NUMBERS, [0, -2 - off])
