"""The curves that are drawn for a free body, against its first integrals and its closed form."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import rigidtop as rt

from .conftest import Engine


@pytest.fixture(scope="module")
def curves():
    return Engine("equations", "polhode")


BODIES = [(1.0, 1.7, 2.3), (2.3, 1.0, 1.7), (1.7, 2.3, 1.0), (1.3, 1.3, 0.7), (1.0, 2.0, 2.0)]


@settings(max_examples=25)
@given(st.sampled_from(BODIES), st.lists(st.floats(-4, 4), min_size=3, max_size=3))
def test_the_curve_goes_through_omega_and_keeps_both_integrals(curves, moments, omega):
    assume(min(map(abs, omega)) > 0.01)
    axis, integrals, points = curves.run(
        "i = invariants(moments, omega); k = enclosedAxis(moments, i.twiceEnergy, i.squareL);"
        "[k, i, Array.from({ length: 720 }, (_, n) => polhodePoint(moments, i.twiceEnergy,"
        " i.squareL, k, Math.sign(omega[k]) || 1, (n * Math.PI) / 360, [0, 0, 0]))]",
        moments=moments, omega=omega,
    )  # fmt: skip
    square = np.square(points)
    assert np.allclose(square @ np.array(moments), integrals["twiceEnergy"], rtol=1e-10)
    assert np.allclose(square @ np.square(moments), integrals["squareL"], rtol=1e-10)
    # Half a degree apart on an ellipse no longer than |ω|.
    nearest = np.linalg.norm(np.array(points) - omega, axis=1).min()
    assert nearest < 0.02 * np.linalg.norm(omega), axis


@settings(max_examples=25)
@given(st.sampled_from(BODIES), st.lists(st.floats(-4, 4), min_size=3, max_size=3))
def test_the_period_is_that_of_the_closed_form(curves, moments, omega):
    assume(min(map(abs, omega)) > 0.01)
    motion = rt.FreeBody(*moments).motion(omega=omega)
    assume(motion.regime not in ("separatrix", "steady"))
    found = curves.run(
        "i = invariants(moments, omega); polhodePeriod(moments, i.twiceEnergy, i.squareL)",
        moments=moments, omega=omega,
    )  # fmt: skip
    turn = motion.exact([0.0, found]).omega
    assert np.allclose(turn[0], turn[1], atol=1e-7 * np.linalg.norm(omega))
    assert math.isclose(found, 2 * motion.nutation_period, rel_tol=1e-8) or len({*moments}) == 2


@settings(max_examples=25)
@given(st.sampled_from(BODIES[:3]), st.lists(st.floats(-4, 4), min_size=3, max_size=3))
def test_the_next_flip_is_where_the_middle_component_vanishes(curves, moments, omega):
    assume(min(map(abs, omega)) > 0.01)
    motion = rt.FreeBody(*moments).motion(omega=omega)
    assume(motion.regime not in ("separatrix", "steady"))
    until, nearest = curves.run(
        "[untilFlip(moments, omega), nearestToMiddle(moments, omega)]",
        moments=moments, omega=omega,
    )  # fmt: skip
    middle = np.argsort(moments)[1]
    assert 0 < until <= motion.nutation_period * (1 + 1e-9)
    along = motion.exact(np.linspace(0, until, 400)).omega[:, middle]
    assert abs(along[-1]) < 1e-7 * np.linalg.norm(omega)
    assert np.all(np.sign(along[:-1]) == np.sign(along[0]))
    whole = motion.exact(np.linspace(0, 2 * motion.nutation_period, 4000)).omega
    share = np.abs(whole[:, middle]) * moments[middle] / np.linalg.norm(whole * moments, axis=1)
    assert math.isclose(math.cos(nearest), share.max(), abs_tol=1e-5)
