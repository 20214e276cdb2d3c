"""The opening: two masses on a stick."""

from math import pi, sqrt

import pytest


def test_dumbbell_at_45_degrees(solve):
    """Two masses of 1 kg, 1 m from the bearing: Kleppner & Kolenkow, chapter 7, the skew rod.

    There L = 2ml²ω cos α and the torque 2ml²ω² sin α cos α, with α against the plane across ω.
    """
    found = solve("two-masses", M_1=1, M_2=1, a=1, b=1, alpha=pi / 4, omega=3)
    assert found["angular_momentum"] == pytest.approx(2 * 3 / sqrt(2), rel=1e-14)
    assert found["torque"] == pytest.approx(2 * 9 / 2, rel=1e-14)
    assert found["angle"] == pytest.approx(pi / 4, rel=1e-14)
    assert found["force"] == 0
    assert found["drift"] == 0


def test_a_single_mass_is_held_by_its_centripetal_force(solve):
    """With b → 0 one mass goes around: F = mω²r with r = a sin α, and it flies off at ωr."""
    found = solve("two-masses", M_1=2, M_2=1e-12, a=0.3, b=1e-9, alpha=pi / 6, omega=5)
    assert found["force"] == pytest.approx(2 * 25 * 0.15, rel=1e-9)
    assert found["drift"] == pytest.approx(5 * 0.15, rel=1e-9)


@pytest.mark.parametrize("alpha", [0.05, 0.7, 1.4])
@pytest.mark.parametrize("b", [0.1, 3.0])
def test_measures_hold_elsewhere(solve, alpha, b):
    measures = solve("two-masses", alpha=alpha, b=b, omega=11).measures
    assert len(measures) == 4
    assert all(measure.passed for measure in measures)
