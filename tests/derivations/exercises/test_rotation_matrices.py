"""Section 3.4."""

from math import pi

import pytest

NAME = "rotations-form-a-group"


def test_more_than_half_a_turn_is_less_the_other_way(solve):
    found = solve(NAME, alpha=2.5, beta=2.0, gamma=0.0)
    assert found["angle"] == pytest.approx(2 * pi - 4.5, rel=1e-14)
    assert found["axis_x"] == pytest.approx(-1.0, rel=1e-14)


def test_small_turns_about_x_and_y_leave_one_about_z(solve):
    """[Jₓ, J_y] = J_z (Goldstein, Classical Mechanics, § 4.8): by αβ, to lowest order.

    The share that is missing goes as the angle², the other components of the axis as the angle.
    """
    rows = solve(NAME)["small_turns"].rows
    assert rows[-1][3] == pytest.approx(1, abs=1e-4)
    assert (1 - rows[-1][3]) / (1 - rows[-2][3]) == pytest.approx(1 / 4, rel=1e-3)
    assert rows[-1][6] == pytest.approx(1, abs=1e-3)
    assert rows[-1][4] / rows[-2][4] == pytest.approx(1 / 2, rel=1e-3)
    assert rows[-1][5] == pytest.approx(-rows[-1][4], rel=1e-9)


def test_the_angle_of_the_table_is_that_of_the_answer(solve):
    """From the matrices there, by the exact formula here."""
    found = solve(NAME, alpha=1.1, beta=-0.8, gamma=1.0)
    assert found["small_turns"].rows[0][2] == pytest.approx(found["commutator"], rel=1e-13)
