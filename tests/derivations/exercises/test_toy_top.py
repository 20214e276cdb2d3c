"""The top from the toy box."""

from math import atan, pi, sqrt

import pytest

from rigidtop.errors import RigidtopError

THIN_DISC = {
    "disc_mass": 0.1,
    "disc_radius": 0.1,
    "disc_thickness": 1e-9,
    "disc_height": 0.05,
    "stem_mass": 1e-15,
    "stem_length": 0.06,
}


def test_thin_disc_alone(solve):
    """Handbook moments: ½Mr² and ¼Mr² + Md²; slow rate near 2gd/(r²ω₃)."""
    found = solve("top-from-the-toy-box", **THIN_DISC, omega3=1000)
    assert found["lambda3"] == pytest.approx(5e-4, rel=1e-12)
    assert found["lambda1"] == pytest.approx(0.1 * (0.0025 + 0.0025), rel=1e-12)
    assert found["slow_leading"] == pytest.approx(2 * 9.81 * 0.05 / (0.01 * 1000), rel=1e-12)
    assert found["slow"] == pytest.approx(found["slow_leading"], rel=1e-3)
    assert found["energy"] == pytest.approx(250, rel=1e-14)
    assert found["touching"] == pytest.approx(atan(0.5), rel=1e-7)


def test_cylinder_with_equal_moments_on_a_stem(solve):
    """Thickness √3 r makes the disc's moments about its centre equal; the stem adds ml²/3."""
    settings = {"disc_radius": 0.02, "disc_thickness": 0.02 * sqrt(3), "disc_height": 0.03}
    stem = {"stem_mass": 0.03, "stem_length": 0.1}
    found = solve("top-from-the-toy-box", disc_mass=0.2, **settings, **stem, omega3=300)
    assert found["lambda1"] - 0.2 * 0.03**2 - 0.03 * 0.1**2 / 3 == pytest.approx(
        found["lambda3"], rel=1e-13
    )
    assert found["M"] * found["R"] == pytest.approx(0.2 * 0.03 + 0.03 * 0.05, rel=1e-14)


def test_precession_is_timed(solve):
    found = solve("top-from-the-toy-box")
    assert found["slow_turn"] * found["slow"] == pytest.approx(2 * pi, rel=1e-15)
    assert found["sleeping_rpm"] > found["least_rpm"]
    assert found["height"] * 0.055 * 9.81 == pytest.approx(found["energy"], rel=1e-14)


def test_a_disc_that_touches_the_table_is_refused(solve):
    with pytest.raises(RigidtopError, match=r"the rim of the disc touches the table at 0\.4899"):
        solve("top-from-the-toy-box", theta=0.5)
    with pytest.raises(RigidtopError, match="the disc must be on the stem"):
        solve("top-from-the-toy-box", disc_height=0.003)
