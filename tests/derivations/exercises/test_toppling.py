"""The toppling top."""

from math import gamma, pi, sqrt

import pytest

from rigidtop.errors import RigidtopError


def test_toppling_from_the_horizontal_is_a_lemniscate(solve):
    """From π/2 to π it is a quarter of a pendulum with amplitude 90°: K(½) = Γ(¼)²/(4√π).

    DLMF 23.5.8; with √(λ₁/MgR) = 1.
    """
    found = solve("toppling-top", theta=pi / 2, until=pi, lambda1=1, M=1, R=0.5, g=2)
    assert found["time_to_fall"] == pytest.approx(gamma(0.25) ** 2 / (4 * sqrt(pi)), rel=1e-14)
    assert found["theta_dot"] == pytest.approx(sqrt(2), rel=1e-14)  # ½λ₁θ̇² = MgR


def test_toppling_of_a_hanging_top_is_harmonic(solve):
    """Small swings about the hanging top: a quarter of a period from rest to the lowest point."""
    found = solve("toppling-top", theta=pi - 1e-6, until=pi)
    assert found["time_to_fall"] == pytest.approx(pi / 2 / found["growth_rate"], rel=1e-9)


def test_toppling_upwards_is_refused(solve):
    with pytest.raises(RigidtopError, match=r"until = 0\.3 must be more than theta = 0\.5"):
        solve("toppling-top", theta=0.5, until=0.3)
