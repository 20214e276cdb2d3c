"""Euler's equations against vectors in space, and their small deviations."""

import numpy as np
import pytest
import sympy
from sympy import Matrix, Rational, symbols

from rigidtop.theory import euler
from rigidtop.theory import symbols as s

VALUES = {
    **dict(zip(euler.MOMENTS, (1.3, 2.1, 0.9), strict=True)),
    **dict(zip(euler.OMEGA, (0.7, -1.9, 2.4), strict=True)),
}
MOMENTS = np.array([1.3, 2.1, 0.9])
OMEGA = np.array([0.7, -1.9, 2.4])
TORQUE = Matrix([s.N1, s.N2, s.N3])


def numeric(matrix, values=VALUES):
    return np.array(matrix.subs(values).evalf(), dtype=float).squeeze()


def test_rates_keep_the_angular_momentum_in_space():
    # L̇ in space is I ω̇ + ω × Iω, whatever the frame in which it is written.
    rates = numeric(euler.body_accelerations())
    assert MOMENTS * rates + np.cross(OMEGA, MOMENTS * OMEGA) == pytest.approx(np.zeros(3))


def test_rates_with_a_torque():
    torque = np.array([0.3, 0.5, -1.1])
    values = {**VALUES, **dict(zip(TORQUE, torque, strict=True))}
    rates = numeric(euler.body_accelerations(TORQUE), values)
    assert MOMENTS * rates + np.cross(OMEGA, MOMENTS * OMEGA) == pytest.approx(torque)


def test_first_integrals_stay():
    for integral in euler.first_integrals():
        assert sympy.expand(sympy.cancel(euler.along_flow(integral))) == 0
    twice, squared = (float(i.subs(VALUES)) for i in euler.first_integrals())
    assert twice == pytest.approx(MOMENTS @ OMEGA**2)
    assert squared == pytest.approx(MOMENTS**2 @ OMEGA**2)
    assert float(euler.kinetic_energy().subs(VALUES)) == pytest.approx(MOMENTS @ OMEGA**2 / 2)


def test_a_torque_does_the_work_omega_times_it():
    power = euler.along_flow(euler.kinetic_energy(), TORQUE)
    assert sympy.expand(power - TORQUE.dot(Matrix(euler.OMEGA))) == 0


def test_the_time_counts_along_the_flow():
    turning = s.omega1 * sympy.cos(s.Omega * s.t)
    rate = euler.along_flow(turning) - euler.along_flow(s.omega1) * sympy.cos(s.Omega * s.t)
    assert rate == -s.Omega * s.omega1 * sympy.sin(s.Omega * s.t)


@pytest.mark.parametrize("axis", [1, 2, 3])
def test_growth_is_the_eigenvalue_of_differences(axis):
    spin, h = 1.7, 1e-6

    def rates(omega):
        return -np.cross(omega, MOMENTS * omega) / MOMENTS

    about = np.zeros(3)
    about[axis - 1] = spin
    columns = [(rates(about + h * d) - rates(about - h * d)) / (2 * h) for d in np.eye(3)]
    eigenvalues = np.linalg.eigvals(np.array(columns).T)
    square = eigenvalues[np.argmax(abs(eigenvalues))] ** 2
    found = euler.axis_growth(axis).subs({**VALUES, euler.OMEGA[axis - 1]: spin})
    assert float(found) == pytest.approx(square.real, rel=1e-8)
    assert numeric(euler.axis_jacobian(axis), {**VALUES, euler.OMEGA[axis - 1]: spin}) == (
        pytest.approx(np.array(columns).T, abs=1e-8)
    )


def test_only_the_middle_axis_is_unstable():
    moments = dict(zip(euler.MOMENTS, (1, 2, 3), strict=True))
    spins = dict.fromkeys(euler.OMEGA, 1)
    growths = [euler.axis_growth(axis).subs(moments).subs(spins) for axis in (1, 2, 3)]
    # −(λₖ − λᵢ)(λₖ − λⱼ)/(λᵢλⱼ), by hand.
    assert growths == [-Rational(1, 3), Rational(1, 3), -1]


@pytest.mark.parametrize("axis", [0, 4, -1])
def test_there_are_three_axes(axis):
    with pytest.raises(ValueError, match=f"no axis {axis}: a body has axes 1, 2 and 3"):
        euler.axis_growth(axis)


def test_momentum_is_along_omega_for_a_sphere():
    equal = dict.fromkeys(euler.MOMENTS, symbols("I"))
    assert euler.angular_momentum().subs(equal) == symbols("I") * Matrix(euler.OMEGA)
    assert euler.body_accelerations().subs(equal) == sympy.zeros(3, 1)
