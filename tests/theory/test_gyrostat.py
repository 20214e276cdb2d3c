"""A body with a ball in oil inside, against Newton for the two bodies in space."""

import numpy as np
import pytest
import sympy

from rigidtop.theory import gyrostat
from rigidtop.theory import symbols as s
from rigidtop.theory.euler import MOMENTS, OMEGA

WHOLE, W, RELATIVE = np.array([1.3, 2.1, 0.9]), np.array([0.7, -1.9, 2.4]), np.array([0.3, -0.2, 1])
BALL, DRAG = 0.2, 0.6
VALUES = {
    **dict(zip(MOMENTS, WHOLE, strict=True)),
    **dict(zip(OMEGA, W, strict=True)),
    **dict(zip(gyrostat.RELATIVE, RELATIVE, strict=True)),
    s.ball: BALL,
    s.damping: DRAG,
}


def numeric(expressions):
    return np.array([float(x.subs(VALUES)) for x in expressions])


def test_each_body_gets_the_torque_of_the_oil():
    rates = gyrostat.rates()
    turning, slowing = numeric(map(rates.get, OMEGA)), numeric(map(rates.get, gyrostat.RELATIVE))
    around = WHOLE - BALL
    assert around * turning + np.cross(W, around * W) == pytest.approx(DRAG * RELATIVE)
    in_space = turning + slowing + np.cross(W, W + RELATIVE)  # of ω + ζ
    assert BALL * in_space == pytest.approx(-DRAG * RELATIVE)
    whole = gyrostat.angular_momentum()
    change = numeric([gyrostat.along_flow(x) for x in whole])
    assert change + np.cross(W, numeric(whole)) == pytest.approx(np.zeros(3), abs=1e-12)


def test_energy_is_that_of_both_and_goes_into_the_oil():
    ball = W + RELATIVE
    expected = ((WHOLE - BALL) @ W**2 + BALL * ball @ ball) / 2
    assert numeric([gyrostat.kinetic_energy()]) == pytest.approx(expected)
    lost = gyrostat.along_flow(gyrostat.kinetic_energy())
    assert sympy.expand(lost + s.damping * sum(x**2 for x in gyrostat.RELATIVE)) == 0
