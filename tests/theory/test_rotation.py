"""Rotations against SciPy's, and ω against differences in forty digits."""

import itertools
import re

import mpmath
import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation
from sympy import Derivative, Function, Matrix, cos, eye, sin, symbols
from sympy.physics.mechanics import ReferenceFrame, dynamicsymbols

from rigidtop.theory import rotation
from rigidtop.theory import symbols as s
from rigidtop.theory.lettered import real
from rigidtop.theory.trig import reduce_ratio, reduce_trig

ANGLES = list(itertools.product((-2.1, 0.4, 3.0), (0.0, 0.3, 1.6, 3.1), (-0.7, 2.5)))


def numeric(matrix, values):
    return np.array(matrix.subs(values).evalf(), dtype=float)


@pytest.mark.parametrize(("phi", "theta", "psi"), ANGLES)
def test_euler_matrix_is_scipys(phi, theta, psi):
    ours = numeric(rotation.euler_matrix(phi, theta, psi), {})
    theirs = Rotation.from_euler("ZYZ", [phi, theta, psi]).as_matrix()
    assert ours == pytest.approx(theirs, abs=1e-14)


@pytest.mark.parametrize("axis", [(1, 0, 0), (0, 1, 0), (0, 0, 1), (0.6, 0.0, -0.8)])
def test_rodrigues_is_scipys(axis):
    ours = numeric(rotation.rotation(Matrix(axis), sympy.Float(1.234)), {})
    theirs = Rotation.from_rotvec(1.234 * np.array(axis)).as_matrix()
    assert ours == pytest.approx(theirs, abs=1e-14)


def test_rotations_about_the_axes():
    turns = {"x": rotation.rotation_x, "y": rotation.rotation_y, "z": rotation.rotation_z}
    for name, turn in turns.items():
        theirs = Rotation.from_euler(name, 0.8).as_matrix()
        assert numeric(turn(sympy.Float(0.8)), {}) == pytest.approx(theirs, abs=1e-15)


def test_quaternion_is_scipys_scalar_first():
    rng = np.random.default_rng(5)
    for q in rng.normal(size=(5, 4)):
        q /= np.linalg.norm(q)
        theirs = Rotation.from_quat(q, scalar_first=True).as_matrix()
        assert numeric(rotation.quaternion_matrix(Matrix(q)), {}) == pytest.approx(
            theirs, abs=1e-14
        )


def test_hat_is_the_cross_product_and_vee_takes_it_back():
    v, w = Matrix(symbols("v1:4")), Matrix(symbols("w1:4"))
    assert (rotation.hat(v) * w - v.cross(w)).expand() == sympy.zeros(3, 1)
    assert rotation.vee(rotation.hat(v)) == v
    with pytest.raises(ValueError, match="vee needs an antisymmetric matrix"):
        rotation.vee(eye(3))


def test_primed_frame_is_the_one_before_the_last_turn():
    ours = rotation.primed_matrix()
    assert ours == rotation.euler_matrix(psi=0)
    assert ours[:, 2] == rotation.euler_matrix()[:, 2]


PATH = {"phi": (0.3, 1.7, -0.4), "theta": (0.9, -0.6, 0.8), "psi": (-0.2, 2.3, 0.5)}


def at(t):
    """Angles and their rates on a path, at 40 digits."""
    angles = {k: c0 + c1 * t + c2 * t * t for k, (c0, c1, c2) in PATH.items()}
    rates = {k: c1 + 2 * c2 * t for k, (_, c1, c2) in PATH.items()}
    return angles, rates


def matrix_at(t):
    """Rz Ry Rz by hand."""
    angles, _ = at(t)

    def about_z(x):
        c, z = mpmath.cos(x), mpmath.sin(x)
        return mpmath.matrix([[c, -z, 0], [z, c, 0], [0, 0, 1]])

    c, z = mpmath.cos(angles["theta"]), mpmath.sin(angles["theta"])
    about_y = mpmath.matrix([[c, 0, z], [0, 1, 0], [-z, 0, c]])
    return about_z(angles["phi"]) * about_y * about_z(angles["psi"])


@pytest.mark.parametrize("frame", ["space", "body", "primed"])
def test_omega_against_differences(frame):
    with mpmath.workdps(40):
        t, h = mpmath.mpf("0.37"), mpmath.mpf(10) ** -12
        attitude = matrix_at(t)
        rate = (matrix_at(t + h) - matrix_at(t - h)) / (2 * h)
        turning = rate * attitude.T
        omega = mpmath.matrix([turning[2, 1], turning[0, 2], turning[1, 0]])
        angles, rates = at(t)
        if frame == "body":
            omega = attitude.T * omega
        if frame == "primed":
            c, z = mpmath.cos(angles["psi"]), mpmath.sin(angles["psi"])
            omega = mpmath.matrix([[c, -z, 0], [z, c, 0], [0, 0, 1]]) * (attitude.T * omega)
        values = {s.phi: angles["phi"], s.theta: angles["theta"], s.psi: angles["psi"]}
        values |= {s.phidot: rates["phi"], s.thetadot: rates["theta"], s.psidot: rates["psi"]}
        for k, component in enumerate(rotation.euler_omega(frame)):
            ours = component.evalf(40, subs={x: sympy.Float(v, 40) for x, v in values.items()})
            assert abs(mpmath.mpf(str(ours)) - omega[k]) < 1e-21


def test_unknown_frame():
    with pytest.raises(ValueError, match="unknown frame 'lab': it is 'space', 'body' or 'primed'"):
        rotation.euler_omega("lab")


def test_quaternion_rates_turn_the_matrix_and_keep_the_length():
    q, w = Matrix(symbols("q0:4", real=True)), Matrix(symbols("w1:4", real=True))
    rates = rotation.quaternion_rates(q, w)
    assert sympy.expand(q.dot(rates)) == 0
    # Ṙ = R hat(ω) holds where |q| = 1: at random unit quaternions.
    derivative = rotation.total_derivative(
        rotation.quaternion_matrix(q), dict(zip(q, rates, strict=True))
    )
    expected = rotation.quaternion_matrix(q) * rotation.hat(w)
    values = dict(zip([*q, *w], (0.5, -0.1, 0.7, 0.5, 1.1, 2.2, -3.3), strict=True))
    assert sum(float(values[x]) ** 2 for x in q) == pytest.approx(1)
    assert numeric(derivative, values) == pytest.approx(numeric(expected, values), abs=1e-14)


def test_total_derivative_is_the_chain_rule():
    x, v, a = symbols("x v a")
    assert rotation.total_derivative(x**2 * v, {x: v, v: a}) == 2 * x * v**2 + x**2 * a
    assert rotation.total_derivative(Matrix([x, 3]), {x: v}) == Matrix([v, 0])


TIME = dynamicsymbols._t
f, h = dynamicsymbols("f h")
V = Function("V")
PARTS = st.sampled_from(
    [f, h, f.diff(), h.diff(), f.diff(TIME, 2), TIME, sin(f), V(f), cos(h * TIME)]
)


@settings(max_examples=30)
@given(st.lists(st.lists(PARTS, min_size=1, max_size=4), min_size=1, max_size=3))
def test_total_derivative_of_functions_of_time_is_sympys(terms):
    expression = sum(sympy.prod(parts) for parts in terms)
    wanted = expression.diff(TIME)
    for rates in ({}, {f: f.diff()}, {f: f.diff(), h: h.diff()}, {f.diff(): f.diff(TIME, 2)}):
        assert sympy.expand(rotation.total_derivative(expression, rates) - wanted) == 0


def test_total_derivative_of_functions_with_rates_of_their_own():
    u, w = symbols("u w")
    assert rotation.total_derivative(f**2 * u + TIME, {f: u, u: w}) == 2 * f * u**2 + f**2 * w + 1
    fall = rotation.total_derivative(f.diff() ** 2, {f: f.diff(), f.diff(): -sin(f)})
    assert fall == -2 * f.diff() * sin(f)
    assert rotation.total_derivative(TIME * f, {f: u, TIME: 0}) == TIME * u


@pytest.mark.parametrize(
    ("expression", "rates", "said"),
    [
        (f.diff(), {f: 1}, "Derivative(f(t), t) does not go with the rate given for f(t)"),
        (f.diff(TIME, 2), {f.diff(): 0}, "Derivative(f(t), (t, 2)) does not go with the rate"),
        (Derivative(f**2, TIME, evaluate=False), {f: 1}, "Derivative(f(t)**2, t) does not go with"),
        (f, {sin(f): 1}, "sin(f(t)) has a rate, but is no symbol and no function of time"),
        (V(s.theta), {}, "is theta in V(theta) the time? Then give it the rate 1, else 0"),
        (f * s.t, {f: 1}, "two times, Symbol('t') and Symbol('t', real=True): there is only one"),
    ],
)
def test_what_has_no_total_derivative_is_said(expression, rates, said):
    with pytest.raises(ValueError, match=f"^{re.escape(said)}"):
        rotation.total_derivative(expression, rates)


def test_the_letter_t_of_ones_own_is_a_time_by_its_unit():
    time, thickness = real("t", s.Glyph("t"), "time", "s"), real("t", s.Glyph("t"), "wall", "m")
    assert rotation.total_derivative(time**2, {}) == 2 * time
    assert rotation.total_derivative(thickness**2, {}) == 0


def test_omega_of_functions_of_time_is_sympys():
    angles = dynamicsymbols("alpha beta gamma")
    fixed, body = ReferenceFrame("N"), ReferenceFrame("B")
    body.orient_body_fixed(fixed, angles, "ZYZ")
    attitude = rotation.euler_matrix(*angles)
    for found, frame in (
        (rotation.omega_body(attitude, {x: x.diff() for x in angles}), body),
        (rotation.omega_space(attitude, {}), fixed),
    ):
        theirs = body.ang_vel_in(fixed).to_matrix(frame)
        assert (found - theirs).applyfunc(reduce_trig).is_zero_matrix


def test_omega_of_a_turn_with_the_time_written_out():
    assert rotation.omega_space(rotation.rotation_z(s.omega * s.t), {}) == Matrix([0, 0, s.omega])


def test_normal_forms():
    x, y = symbols("x y")
    assert reduce_trig(sin(x) ** 4 - 1 + 2 * cos(x) ** 2 - cos(x) ** 4) == 0
    assert reduce_trig(cos(x) ** 3, keep="sin") == cos(x) - cos(x) * sin(x) ** 2
    assert reduce_trig(Matrix([sin(x) ** 2, y])) == Matrix([1 - cos(x) ** 2, y])
    assert reduce_ratio((y**2 - 1) * sin(x) / ((1 - cos(x) ** 2) * (y - 1))) == (y + 1) / sin(x)
