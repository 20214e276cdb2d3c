"""Section 3.4."""

from math import pi, sqrt

import pytest

NAME = "rotations-form-a-group"


def test_two_quarter_turns_are_a_third_of_a_turn_about_the_diagonal(solve):
    """About x̂ after ŷ they take ẑ to x̂, x̂ to ŷ and ŷ to ẑ: the cube turns about its diagonal."""
    found = solve(NAME)
    assert found["angle"] == pytest.approx(2 * pi / 3, rel=1e-15)
    axis = [found[f"axis_{letter}"] for letter in "xyz"]
    assert axis == pytest.approx([1 / sqrt(3)] * 3, rel=1e-14)
    # In the other order about the diagonal of (1, 1, −1): these third turns differ by one.
    assert found["commutator"] == pytest.approx(2 * pi / 3, rel=1e-14)


@pytest.mark.parametrize("gamma", [0.05, 0.3, 0.7, 1.2])
def test_two_half_turns_turn_by_twice_the_angle_between_their_axes(solve, gamma):
    """Mirrored in n₂ and then in n₁, within their plane: from n₂ towards n₁, by 2γ.

    The other order turns as far the other way, so the two differ by 4γ, or by what is left of a
    whole turn.
    """
    found = solve(NAME, alpha=pi, beta=pi, gamma=gamma)
    assert found["angle"] == pytest.approx(2 * gamma, rel=1e-13)
    assert found["axis_z"] == pytest.approx(-1, rel=1e-13)
    assert found["commutator"] == pytest.approx(min(4 * gamma, 2 * pi - 4 * gamma))


def test_turns_about_one_axis_add_up_and_commute(solve):
    found = solve(NAME, alpha=2.0, beta=-0.5, gamma=0.0)
    assert found["angle"] == pytest.approx(1.5, rel=1e-14)
    assert found["axis_x"] == pytest.approx(1.0, rel=1e-14)
    assert found["commutator"] == 0.0
    assert found["small_turns"].rows[0][2] == pytest.approx(0.0, abs=1e-15)


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
