"""Section 3.2.2."""

from math import log, pi, sqrt

import pytest

from rigidtop.errors import RigidtopError
from rigidtop.typeset.words import unmarked


def test_rates_of_a_body_with_moments_1_2_3(solve):
    """Landau & Lifshitz, Mechanics §37: ω² (I₃ − I₁)(I₃ − I₂)/(I₁I₂) about the axis x₃."""
    found = solve("stable-axes", lambda1=2, lambda2=3, lambda3=4, omega=6, kick=1e-3)
    rates = {unmarked(row[0]): (row[2], row[3]) for row in found["axes"].rows}
    assert rates["e₁"] == ("oscillates", pytest.approx(6 * sqrt(2 * 1 / 12), rel=1e-14))
    assert rates["e₂"] == ("runs away", pytest.approx(6 * sqrt(1 * 1 / 8), rel=1e-14))
    assert rates["e₃"] == ("oscillates", pytest.approx(6 * sqrt(2 * 1 / 6), rel=1e-14))
    period = found["axes"].rows[2][4]
    assert period == pytest.approx(2 * pi / (6 * sqrt(2 * 1 / 6)), rel=1e-14)


def test_each_tenth_of_the_kick_costs_the_logarithm(solve):
    """2 ln 10/σ: the kick must grow tenfold more, and die out tenfold more."""
    found = [solve("stable-axes", kick=kick) for kick in (1e-6, 1e-7)]
    longer = found[1]["flip_time"] - found[0]["flip_time"]
    assert longer == pytest.approx(2 * log(10) / found[0]["growth_rate"], rel=1e-9)
    assert found[1]["flip_estimate"] == pytest.approx(found[1]["flip_time"], rel=1e-9)


def test_period_of_ω_is_two_flips(solve):
    found = solve("stable-axes")
    assert found["period"] == 2 * found["flip_time"]
    assert found["time_to_leave"] == pytest.approx(found["flip_time"] / 2, rel=0.1)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"lambda2": 0.9}, "must grow, lambda1 < lambda2 < lambda3, not 1, 0.9, 2.3"),
        ({"lambda2": 1.0}, "must grow"),
        ({"kick": 7}, "kick must be less than omega = 6"),
        ({"kick": 1e-9}, "at least 1e-08 of it"),
        ({"lambda3": 3}, "no body has such moments"),
    ],
)
def test_bad_settings(solve, given, message):
    with pytest.raises(RigidtopError, match=message):
        solve("stable-axes", **given)
