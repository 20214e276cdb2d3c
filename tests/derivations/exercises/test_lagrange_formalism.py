"""Section 3.5.3."""

from math import pi

import pytest

from rigidtop.errors import NoSteadyPrecession, RigidtopError

# λ₁ cos θ = 1 and MgR = 4, so that the roots are those of Ω² − λ₃ω₃ Ω + 4.
WHOLE = {"lambda1": 2, "lambda3": 0.5, "M": 1, "R": 0.5, "g": 8, "theta": pi / 3}
BELOW = {**WHOLE, "theta": 2 * pi / 3}


def test_roots_in_whole_numbers(solve):
    """Ω² − 5Ω + 4 = (Ω − 1)(Ω − 4); the leading terms are 4/5 and 5, the next 4/5·1.16 and 4.2."""
    found = solve("fast-spin-roots", **WHOLE, omega3=10)
    expected = {"epsilon": 0.16, "slow": 1, "slow_leading": 0.8, "slow_error": -0.2}
    expected |= {"fast": 4, "fast_leading": 5, "fast_error": 0.25, "threshold": 8}
    expected |= {"slow_next": 0.928, "fast_next": 4.2}
    for name, value in expected.items():
        assert found[name] == pytest.approx(value, rel=1e-14), name


@pytest.mark.parametrize(
    ("top", "accuracy", "name", "spin"),
    [
        (WHOLE, 0.2, "slow_spin", 10),
        (WHOLE, 0.25, "fast_spin", 10),
        (BELOW, 1 / 3, "slow_spin", 6),
        (BELOW, 0.25, "fast_spin", 6),
    ],
)
def test_spin_at_which_the_errors_above_are_allowed(solve, top, accuracy, name, spin):
    found = solve("fast-spin-roots", **top, omega3=10, accuracy=accuracy)
    assert found[name] == pytest.approx(spin, rel=1e-14)
    assert all(measure.passed for measure in found.measures)


def test_small_errors_need_the_inverse_root_of_the_error(solve):
    """For small errors both spins are √(λ₁MgR cos θ/error)/λ₃."""
    found = solve("fast-spin-roots", **WHOLE, omega3=10, accuracy=1e-8)
    for name in ("slow_spin", "fast_spin"):
        assert found[name] == pytest.approx(2e4 / 0.5, rel=2e-8)
    assert all(measure.passed for measure in found.measures)


def test_settings_without_both_roots_are_refused(solve):
    with pytest.raises(NoSteadyPrecession, match="at least"):
        solve("fast-spin-roots", omega3=2)
    with pytest.raises(RigidtopError, match="horizontal axis has the slow rate alone"):
        solve("fast-spin-roots", theta=pi / 2)
    with pytest.raises(RigidtopError, match="omega3 = 0"):
        solve("fast-spin-roots", theta=2.5, omega3=0)
