"""Section 3.5.1."""

from math import cos, pi, radians, sin

import numpy as np
import pytest

from rigidtop.derivations.exercises.net_torque import discs

NAMES = [f"{letter}{k}" for k in (1, 2, 3) for letter in "mxyz"]
NOWHERE = dict.fromkeys((name for name in NAMES if name[0] != "m"), 0.0)


def test_lever_in_balance(solve):
    """Archimedes, On the Equilibrium of Planes I.6: masses balance at inverse distances."""
    found = solve("gravity-on-points", **NOWHERE | {"m1": 3, "x1": 2, "m2": 2, "x2": -3})
    torque = [found[f"torque_{letter}"] for letter in "xyz"]
    assert torque == pytest.approx([0, 0, 0], abs=1e-14)
    assert found["centre_x"] == pytest.approx(0, abs=1e-15)


def test_weight_at_the_end_of_an_arm(solve):
    """x̂ × (−ẑ) = ŷ and ŷ × (−ẑ) = −x̂: mgx about ŷ, and −mgy about x̂."""
    found = solve("gravity-on-points", **NOWHERE | {"m1": 2, "x1": 3, "y1": 5, "z1": 7, "g": 10})
    assert [found[f"torque_{letter}"] for letter in "xyz"] == pytest.approx([-100, 60, 0])
    assert found["potential"] == pytest.approx(140)


@pytest.mark.parametrize(("radius", "height"), [(0.5, 0.2), (0.03, 2.0)])
def test_moments_of_a_cone_about_its_tip(solve, radius, height):
    """Landau & Lifshitz, Mechanics, § 32, problem 2(e): ⅗μ(¼R² + h²), 3μR²/10, centre at ¾h."""
    found = solve("gravity-on-a-solid", radius=radius, height=height, density=3.0)
    mass = 3.0 * pi * radius**2 * height / 3  # Euclid XII.10: a third of the cylinder
    assert found["mass"] == pytest.approx(mass, rel=1e-14)
    assert found["R"] == pytest.approx(3 * height / 4, rel=1e-14)
    assert found["lambda1"] == pytest.approx(0.6 * mass * (radius**2 / 4 + height**2), rel=1e-14)
    assert found["lambda3"] == pytest.approx(0.3 * mass * radius**2, rel=1e-14)


def test_cone_that_leans_towards_x(solve):
    """As ∫ x dm by hand: x = z sin θ + … of the axis, so N_y = g sin θ ∫ z dm = ¾Mgh sin θ."""
    theta = radians(40)
    found = solve("gravity-on-a-solid", theta=theta, phi=0.0, g=10.0)
    arm = 0.75 * 0.06 * found["mass"] * 10
    assert found["torque_x"] == pytest.approx(0, abs=1e-18)
    assert found["torque_y"] == pytest.approx(arm * sin(theta), rel=1e-14)
    assert found["potential"] == pytest.approx(arm * cos(theta), rel=1e-14)


def test_tilted_cone_goes_round_at_less_spin_than_it_stands(solve):
    """λ₃²ω₃² = 4λ₁MgR cos θ (Goldstein, Classical Mechanics, § 5.7): the ratio is √cos θ."""
    found = solve("gravity-on-a-solid", theta=1.0)
    assert found["smallest_spin"] / found["sleeping_spin"] == pytest.approx(cos(1.0) ** 0.5)


def test_discs_integrate_polynomials(solve):
    """∫ x²z d³r over the cone = π r⁴h²/24: ∫ dz z · π(rz/h)⁴/4, and z⁶/6 at h."""
    radius, height = 0.7, 1.3
    points, sizes = discs(radius, height)
    expected = pi * radius**4 * height**2 / 24
    assert sizes @ (points[:, 0] ** 2 * points[:, 2]) == pytest.approx(expected, rel=1e-13)
    assert float(np.hypot(points[:, 0], points[:, 1]).max()) < radius
