"""Section 3.3."""

from math import cos, pi, sin, tan

import numpy as np
import pytest

from rigidtop.errors import RigidtopError


def test_primed_axes_are_those_of_spherical_coordinates(solve):
    """e₁′, e₂′, e₃ are θ̂, φ̂, r̂ in Griffiths, Introduction to Electrodynamics, inside the cover.

    There too: ẑ = cos θ r̂ − sin θ θ̂.
    """
    phi, theta = 2.3, 1.9
    found = solve("vertical-in-primed-frame", phi=phi, theta=theta)
    along_theta = [cos(theta) * cos(phi), cos(theta) * sin(phi), -sin(theta)]
    along_phi = [-sin(phi), cos(phi), 0.0]
    along_r = [sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)]
    axes = np.array([row[1:4] for row in found["axes"].rows])
    assert axes == pytest.approx(np.array([along_theta, along_phi, along_r]), abs=1e-15)
    assert [row[4] for row in found["axes"].rows] == pytest.approx(list(axes[:, 2]), abs=1e-15)


@pytest.mark.parametrize("theta", [0.0, 0.4, pi / 2])
def test_wrong_sign_doubles_the_angle(solve, theta):
    found = solve("vertical-in-primed-frame", theta=theta)
    assert found["angle_of_wrong_sign"] == pytest.approx(2 * theta, abs=1e-14)


@pytest.mark.parametrize("spin", [20.0, 5.0, 0.5])
def test_passing_the_upright_turns_phi_at_the_speed_of_passing(solve, spin):
    """θφ̇ tends to the speed at which a top with L_z = L₃ crosses the vertical, by its energy.

    With L_z = L₃ the energy of φ̇ is L₃² tan²(θ/2)/2λ₁ (Landau & Lifshitz, Mechanics, § 35); that
    of θ̇ is spent on the way up. It gets there with little spin too.
    """
    theta, lambda1, lambda3 = pi / 6, 1.3, 0.7
    speed = lambda3 * spin * tan(theta / 2) / lambda1
    rows = solve("azimuthal-rate", theta=theta, omega3=spin)["near_the_upright"].rows
    off = [row[3] / speed - 1 for row in rows]
    assert off[-1] == pytest.approx(0, abs=0.02)
    if spin == 20.0:
        # First order in the miss: the last row misses a tenth of what the third misses.
        assert off[-1] / off[2] == pytest.approx(0.1, rel=0.01)
        # And the smallest θ is in proportion to it.
        assert rows[-1][1] / rows[2][1] == pytest.approx(0.1, rel=0.01)


def test_a_top_through_the_vertical_has_the_rate_of_half_l3(solve):
    """φ̇ = L₃/λ₁(1 + cos θ) for L_z = L₃: bounded all the way."""
    theta, lambda1, spin = 0.5, 1.3, 0.7 * 20.0
    started = spin / (lambda1 * (1 + cos(theta)))
    found = solve("azimuthal-rate", theta=theta, phi_dot=started)
    for _, tilt, by_momenta, seen in found["nutation"].rows:
        expected = spin / (lambda1 * (1 + cos(tilt)))
        assert [by_momenta, seen] == pytest.approx([expected] * 2, rel=1e-6)
    assert found["at_the_upright"] == pytest.approx(spin / lambda1 / 2)


def test_settings_that_have_no_azimuthal_rate(solve):
    with pytest.raises(RigidtopError, match=r"omega3 must not be 0"):
        solve("azimuthal-rate", omega3=0)
    with pytest.raises(RigidtopError, match=r"theta must be more than 0"):
        solve("azimuthal-rate", theta=0)
