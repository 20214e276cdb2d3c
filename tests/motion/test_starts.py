"""Bodies as they come: an inertia tensor, and starts from the constants of the motion."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import rigidtop as rt
from rigidtop.cli import main

TOP = rt.HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5)
MOMENTS = np.array([1.0, 2.0, 2.5])


@given(st.integers(0, 2**32 - 1))
def test_a_tensor_is_its_moments_in_its_axes(seed):
    turn = Rotation.random(random_state=seed)
    tensor = turn.as_matrix() @ np.diag(MOMENTS) @ turn.as_matrix().T
    body = rt.FreeBody.from_inertia(tensor)
    axes = body.attitude.as_matrix()
    assert np.allclose(np.sort(body.moments), MOMENTS, atol=1e-13)
    assert np.allclose(axes @ np.diag(body.moments) @ axes.T, tensor, atol=1e-13)
    assert math.isclose(np.linalg.det(axes), 1.0)


def test_a_diagonal_tensor_keeps_its_axes():
    body = rt.FreeBody.from_inertia(np.diag([2.5, 1.0, 2.0]))
    assert body == rt.FreeBody(2.5, 1.0, 2.0)
    assert body.attitude.magnitude() == 0.0


def test_a_body_starts_with_its_tensor_s_axes_along_the_space_s():
    turn = Rotation.from_euler("xyz", [0.1, 0.2, 0.3])
    body = rt.FreeBody.from_inertia(turn.as_matrix() @ np.diag(MOMENTS) @ turn.as_matrix().T)
    omega = np.array([1.0, 2.0, 3.0])
    start = body.motion(omega=body.attitude.inv().apply(omega)).start()
    assert np.allclose(start.omega_space, omega)


@pytest.mark.parametrize(
    ("tensor", "says"),
    [
        ([1, 2, 3], r"tensor of shape \(3, 3\), not \(3,\)"),
        ([[1, 0.1, 0], [0.2, 1, 0], [0, 0, 1]], r"symmetric: I\[0\]\[1\] = 0.1, but I\[1\]\[0\]"),
        (np.diag([1.0, 2.0, -1.0]), "moments of I are -1, 1, 2, and each must be positive"),
        (np.zeros((3, 3)), "each must be positive"),
        (np.diag([1.0, 1.0, 3.0]), "lambda3 = 3 exceeds the sum of the other two"),
        (np.full((3, 3), math.nan), "I must be finite"),
        ("brick", "I must be numbers"),
    ],
)
def test_a_bad_tensor(tensor, says):
    with pytest.raises(rt.RigidtopError, match=says):
        rt.FreeBody.from_inertia(tensor)


def test_a_tensor_that_no_body_has_is_let_through():
    assert rt.FreeBody.from_inertia(np.diag([1.0, 1, 3]), physical=False).lambda3 == 3


RATES = st.floats(-20, 20)


@given(st.floats(0.01, 3.13), RATES, RATES, RATES)
def test_the_constants_tell_the_motion(theta, theta_dot, phi_dot, omega3):
    motion = TOP.motion(theta=theta, theta_dot=theta_dot, phi_dot=phi_dot, omega3=omega3)
    state = motion.start()
    constants = {
        "E": state.energy[0],
        "p_phi": state.p_phi[0],
        "p_psi": state.p_psi[0],
    }
    # Beside a steady motion rounding of E decides: the square root of its last digit.
    assert np.allclose(TOP.motion(**constants).turning_points, motion.turning_points, atol=1e-6)
    there = TOP.motion(theta=theta, **constants).start()
    assert np.allclose(there.theta_dot, abs(theta_dot), atol=1e-6)
    assert np.allclose(there.phi_dot, phi_dot)
    assert np.allclose(there.energy, state.energy)


def test_it_begins_at_the_smallest_angle():
    state = TOP.motion(E=405.0, p_phi=18.0, p_psi=20.0, phi=7.0, psi=9.0).start()
    assert (state.theta_dot, state.phi, state.psi) == (0.0, 7.0, 9.0)
    assert state.theta == pytest.approx(0.4040860915771713)
    assert [state.energy[0], state.p_phi[0], state.p_psi[0]] == pytest.approx([405.0, 18.0, 20.0])


@pytest.mark.parametrize(
    ("constants", "regime"),
    [
        ({"E": 410.0, "p_phi": 20.0, "p_psi": 20.0}, "through the vertical"),
        ({"E": 404.905, "p_phi": 20.0, "p_psi": 20.0}, "sleeping"),
        ({"E": 410.0, "p_phi": -20.0, "p_psi": 20.0}, "through the vertical"),
        ({"E": -4.905, "p_phi": 0.0, "p_psi": 0.0}, "hanging"),
        ({"E": 0.0, "p_phi": 0.0, "p_psi": 0.0}, "plane"),
    ],
)
def test_at_the_poles(constants, regime):
    motion = TOP.motion(**constants)
    assert motion.regime == regime
    assert motion.start().energy[0] == pytest.approx(constants["E"], abs=1e-12)


def test_a_steady_precession_comes_back():
    slow, _ = TOP.steady_precession(0.5, 40.0)
    state = TOP.motion(theta=0.5, phi_dot=slow, omega3=40.0).start()
    motion = TOP.motion(E=state.energy[0], p_phi=state.p_phi[0], p_psi=state.p_psi[0])
    assert motion.regime == "steady"
    assert motion.start().phi_dot[0] == pytest.approx(slow)


GIVEN = {"E": 405.0, "p_phi": 18.0, "p_psi": 20.0}


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"E": 404.0}, "E = 404 is too small: .* it is at least 404.408656 J"),
        ({"theta": 1.0}, "theta = 1 is out of reach: .* from 0.404086092 to 0.51518953$"),
        ({"theta": 0.0}, "theta = 0 is out of reach"),
        ({"theta": 4.0}, "theta must lie between 0 and pi"),
        ({"E": None}, "E, p_phi and p_psi are needed together"),
        ({"omega3": 40.0}, "they tell every rate"),
        ({"E": math.inf}, "E must be finite"),
    ],
)
def test_constants_that_cannot_be(change, says):
    with pytest.raises(rt.RigidtopError, match=says):
        TOP.motion(**{**GIVEN, **change})


def test_constants_on_the_command_line(capsys):
    words = [
        "simulate",
        "top",
        "--E",
        "405",
        "--p-phi",
        "18",
        "--p-psi",
        "20",
        "--time",
        "1",
        "--samples",
        "2",
    ]
    assert main(words) == 0
    assert "θ from 0.404086 to 0.51519 rad" in capsys.readouterr().out
    assert main([*words, "--steady", "slow"]) == 2
    assert main([*words, "--omega3", "40"]) == 2
    assert "they tell every rate" in capsys.readouterr().err
    assert main(["simulate", "sliding", "--E", "4"]) == 2
    assert capsys.readouterr().err.endswith("--E does not go with `simulate sliding`\n")
