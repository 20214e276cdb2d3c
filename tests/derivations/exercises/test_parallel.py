"""L beside ω."""

from math import asin, cos, pi, sqrt

import numpy as np
import pytest

from rigidtop.derivations.exercises.parallel import bound_of_angle, largest_angle
from rigidtop.errors import RigidtopError
from rigidtop.motion.top import HeavyTop


@pytest.mark.parametrize(("theta", "spin"), [(pi / 6, 0.01), (1e-3, 0.3), (3.0, -0.01)])
def test_slow_top_reaches_the_widest_angle_of_its_body(solve, theta, spin):
    """Any angle between ω and L is at most arcsin |λ₁ − λ₃|/(λ₁ + λ₃); 17.46° for 1.3 and 0.7."""
    found = solve("parallel-bound", theta=theta, omega3=spin)
    assert found["largest"] == pytest.approx(asin(0.6 / 2.0), rel=1e-14)
    assert all(measure.passed for measure in found.measures)


def test_nothing_disturbs_an_upright_top():
    top = HeavyTop(lambda1=1.3, lambda3=0.7, M=0.8, R=0.6)
    assert largest_angle(top, 0.0, 1.0) == 0


def test_no_angle_exceeds_the_bound():
    """Over tops, tilts and spins of every kind, slow ones too."""
    rng = np.random.default_rng(11)
    for _ in range(200):
        lambda3, thickness, M, R = 10 ** rng.uniform(-2, 1, 4)
        top = HeavyTop(lambda1=M * R**2 + lambda3 / 2 + thickness, lambda3=lambda3, M=M, R=R)
        theta = rng.uniform(0.01, 3.1)
        spin = rng.choice([-1, 1]) * sqrt(top.lambda1 * M * 9.81 * R) / lambda3
        spin *= 10 ** rng.uniform(-1, 2)
        assert largest_angle(top, theta, spin) <= bound_of_angle(top, theta, spin) * (1 + 1e-9)


def test_bound_is_reached_by_a_fast_top(solve):
    shares = [row[4] for row in solve("parallel-bound")["spins"].rows]
    assert shares[-1] == pytest.approx(1, abs=1e-9)
    # What is missing is of second order: a sixteenth for twice the spin.
    assert (1 - shares[2]) / (1 - shares[1]) == pytest.approx(1 / 16, rel=0.05)


@pytest.mark.parametrize("theta", [0.3, 1.2, pi / 2, 2.5])
def test_mean_precession_exceeds_the_simple_one_by_epsilon_cos_theta(solve, theta):
    """To zeroth order it is Mgl/(I₃ω₃): Goldstein, Classical Mechanics, § 5.7. To first, cos θ.

    Extrapolated from two rows, of which the second has a quarter of the first's ε₀.
    """
    rows = solve("parallel-bound", theta=theta)["spins"].rows
    fine, coarse = rows[4][7], rows[3][7]
    assert fine + (fine - coarse) / 3 == pytest.approx(cos(theta), abs=1e-6)
    assert rows[-1][6] == pytest.approx(0, abs=1e-5)


def test_tops_without_an_angle_are_refused(solve):
    with pytest.raises(RigidtopError, match="omega3 must not be 0"):
        solve("parallel-bound", omega3=0)
    with pytest.raises(RigidtopError, match="lambda1 and lambda3 must differ"):
        solve("parallel-bound", lambda1=1.3, lambda3=1.3)
