"""Figures: what they show is computed, and they come out the same each time."""

import sys
from xml.etree import ElementTree

import numpy as np
import pytest
from matplotlib.figure import Figure as Canvas

from rigidtop.present import plots
from rigidtop.present.plots import EXAMPLE, FIGURES, effective_potential, rendered


@pytest.fixture
def axes():
    return Canvas().subplots()


@pytest.mark.parametrize(
    ("figure", "draw"), [f[1:] for f in FIGURES], ids=lambda f: getattr(f, "name", "")
)
def test_svg_is_well_formed_and_the_same_each_time(figure, draw):
    made = rendered(draw, "svg")
    assert made == rendered(draw, "svg")
    assert b"<metadata" not in made
    root = ElementTree.fromstring(made)
    assert root.tag.endswith("svg")
    assert b"font-family" not in made  # letters are paths, no font is asked for


def test_pdf_is_the_same_each_time():
    draw = FIGURES[1][2]
    assert rendered(draw, "pdf") == rendered(draw, "pdf")


def test_pyplot_is_not_touched():
    assert (
        "matplotlib.pyplot" not in sys.modules or not sys.modules["matplotlib.pyplot"].get_fignums()
    )


def test_precession_rates_solve_the_quadratic(axes):
    theta = np.pi / 3
    plots.draw_precession_rates(axes, EXAMPLE, theta, 70.0)
    weight = EXAMPLE.M * EXAMPLE.g * EXAMPLE.R
    curves = [
        line.get_xydata() for line in axes.lines if line.get_color() in ("#0b4f8a", "#a33c1a")
    ]
    assert len(curves) == 2
    for curve in curves:
        spin, rate = np.asarray(curve).T
        rest = EXAMPLE.lambda1 * np.cos(theta) * rate**2 - EXAMPLE.lambda3 * spin * rate + weight
        assert np.abs(rest).max() < 1e-9 * weight + 1e-9


def test_effective_potential_is_the_energy_at_rest():
    theta, rate, spin = 1.1, 2.0, 30.0
    p_psi = EXAMPLE.lambda3 * spin
    p_phi = EXAMPLE.lambda1 * rate * np.sin(theta) ** 2 + p_psi * np.cos(theta)
    motion = EXAMPLE.motion(theta=theta, phi_dot=rate, omega3=spin)
    energy = motion.start().energy[0] - p_psi**2 / (2 * EXAMPLE.lambda3)
    assert effective_potential(EXAMPLE, theta, p_phi, p_psi) == pytest.approx(energy, rel=1e-12)


def test_paths_are_waves_cusps_and_loops():
    shapes = {}
    for name, e3 in plots.paths():
        azimuth = np.unwrap(np.arctan2(e3[:, 1], e3[:, 0]))
        steps = np.diff(azimuth)
        shapes[name] = steps.min() / steps.max()
    assert shapes["waves"] > 0.01
    assert abs(shapes["cusps"]) < 0.01
    assert shapes["loops"] < -0.1


def test_the_cones_share_a_plane(axes):
    plots.draw_cones(axes, 1.0, 0.55, 0.42, space=True)
    assert [t.get_text() for t in axes.texts if t.get_text()] == [
        r"$\mathbf{e}_3$",
        r"$\boldsymbol{\omega}$",
        r"$\mathbf{L}$",
    ]
    tips = [t.xy for t in axes.texts if t.get_text()]
    assert tips[2][0] == pytest.approx(0)  # in space L stands upright


def test_captions_say_what_is_drawn():
    waves, cusps, loops = (rate for rate in (1.2, 0.0, -2.5))
    caption = FIGURES[3][1].caption
    assert f"φ̇ = {waves}, {cusps:.0f} and −{-loops}" in caption
    assert EXAMPLE.smallest_spin(np.pi / 3) == pytest.approx(20, abs=0.5)
