"""Section 3.5.1."""

from math import cos, pi, radians, sin

import numpy as np
import pytest

from rigidtop.derivations.exercises.net_torque import discs


def test_cone_that_leans_towards_x(solve):
    """As ∫ x dm by hand: x = z sin θ + … of the axis, so N_y = g sin θ ∫ z dm = ¾Mgh sin θ."""
    theta = radians(40)
    found = solve("gravity-on-a-solid", theta=theta, phi=0.0, g=10.0)
    arm = 0.75 * 0.06 * found["mass"] * 10
    assert found["torque_x"] == pytest.approx(0, abs=1e-18)
    assert found["torque_y"] == pytest.approx(arm * sin(theta), rel=1e-14)
    assert found["potential"] == pytest.approx(arm * cos(theta), rel=1e-14)


def test_discs_integrate_polynomials(solve):
    """∫ x²z d³r over the cone = π r⁴h²/24: ∫ dz z · π(rz/h)⁴/4, and z⁶/6 at h."""
    radius, height = 0.7, 1.3
    points, sizes = discs(radius, height)
    expected = pi * radius**4 * height**2 / 24
    assert sizes @ (points[:, 0] ** 2 * points[:, 2]) == pytest.approx(expected, rel=1e-13)
    assert float(np.hypot(points[:, 0], points[:, 1]).max()) < radius
