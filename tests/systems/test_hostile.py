"""Answers that would be plausible and wrong: each of these was, or might have been, given."""

import numpy as np
import pytest
from sympy import Symbol, acos, cos, exp, pi, sin, sqrt, symbols

import rigidtop as rt

m, k, g, c, Omega, R = symbols("m k g c Omega R", positive=True)
x, y, u, v, theta, phi, w, wphi = symbols("x y u v theta phi w wphi", real=True)
t = symbols("t")

# On a saddle that only gyroscopic forces hold: s = ±iΩ ± √(k − Ω²).
HILL = (u**2 + v**2) / 2 + Omega * (x * v - y * u) + k * (x**2 + y**2) / 2
BEAD = rt.System(
    m * R**2 * (w**2 + Omega**2 * sin(theta) ** 2) / 2 + m * g * R * cos(theta), theta, w
)


def _held(rayleigh=0):
    return rt.System(HILL, [x, y], [u, v], rayleigh=rayleigh).small({x: 0, y: 0})


def test_dissipation_destroys_gyroscopic_stability():
    """Kelvin, Tait and Chetaev: however little it is."""
    assert _held().stability({Omega: 2, k: 1}) == "oscillates"
    damped = _held(c * (u**2 + v**2) / 2)
    for damping in (0.1, 1e-3, 1e-7):
        assert damped.stability({Omega: 2, k: 1, c: damping}) == "unstable"


@pytest.mark.parametrize(("rate", "stiffness"), [(1, 1), (0.1, 0.01), (0.3, 0.09)])
def test_a_double_frequency_with_one_deviation_is_not_called_oscillating(rate, stiffness):
    """At k = Ω² deviations grow as t e^{iΩt}, and the last digit decides."""
    held = _held()
    assert held.stability({Omega: rate, k: stiffness}) == "undecided"
    assert np.allclose(np.abs(held.rates({Omega: rate, k: stiffness})), rate, rtol=1e-14)


def test_resonance_is_not_called_oscillating():
    driven = rt.System((u**2 + v**2 - k * (x**2 + y**2)) / 2, [x, y], [u, v], forces=[0, c * x])
    assert driven.small({x: 0, y: 0}).stability({k: 2, c: 1}) == "undecided"
    apart = rt.System((u**2 + v**2 - k * x**2) / 2 - y**2, [x, y], [u, v], forces=[0, c * x])
    assert apart.small({x: 0, y: 0}).stability({k: 3, c: 1}) == "oscillates"


def test_slow_growth_beside_fast_oscillations_is_seen():
    beside = (u**2 + v**2) / 2 - 10**12 * x**2 / 2
    falling = rt.System(beside + k * y**2 / 2, [x, y], [u, v])
    assert falling.small({x: 0, y: 0}).stability({k: 9}) == "unstable"
    pushed = rt.System(beside - k * y**2 / 2, [x, y], [u, v], rayleigh=-c * v**2 / 2)
    assert pushed.small({x: 0, y: 0}).stability({k: 1e6, c: 1}) == "unstable"


def test_stability_where_the_linear_equations_do_not_tell():
    assert BEAD.small({theta: 0}).stability({m: 1, g: 9.8, R: 1, Omega: 9.8**0.5}) == "undecided"
    grows = rt.System(u**2 / 2 - k * x**2 / 2 - exp(t) * x**3, x, u)
    assert grows.small({x: 0}).stability({k: 1}) == "undecided"


def test_a_motion_that_does_not_exist_for_the_numbers():
    tilted = BEAD.small({theta: acos(g / (R * Omega**2))})
    assert tilted.stability({m: 1, g: 9.8, R: 1, Omega: 10}) == "stable"
    with pytest.raises(rt.RigidtopError, match=r"no such motion: theta would be 2.97\d*\*I"):
        tilted.stability({m: 1, g: 9.8, R: 1, Omega: 1})


def test_a_mass_matrix_that_is_singular_at_the_place():
    bob = rt.System(
        m * (w**2 + sin(theta) ** 2 * wphi**2) / 2 + m * g * cos(theta), [theta, phi], [w, wphi]
    )
    with pytest.raises(rt.RigidtopError, match="the mass matrix is singular there"):
        bob.small({theta: 0}).stability({m: 1, g: 1})


def test_letters_of_a_steady_motion_are_given_as_parameters():
    """The conical pendulum by its rate: ω² = Ω²(1 + 3 cos²θ)."""
    rate = Symbol("rate", positive=True)
    bob = rt.System(
        m * (w**2 + sin(theta) ** 2 * wphi**2) / 2 + m * g * cos(theta), [theta, phi], [w, wphi]
    )
    small = bob.small({theta: acos(g / rate**2), wphi: rate})
    [found] = small.frequencies({m: 1, g: 8.0, "rate": 4.0})
    assert found == pytest.approx(4 * sqrt(1 + 3 / 4), rel=1e-14)
    with pytest.raises(rt.RigidtopError, match="no number for rate"):
        small.frequencies({m: 1, g: 8.0})


@pytest.mark.parametrize(
    ("assumed", "value", "said"),
    [
        ({"integer": True}, 0.5, "n must be integer, not 0.5"),
        ({"negative": True}, 2, "n must be negative, not 2"),
        ({"nonnegative": True}, -2, "n must be nonnegative, not -2"),
        ({"nonzero": True}, 0, "n must be nonzero, not 0"),
        ({"imaginary": True}, 2, "n must be imaginary, not 2"),
        ({"even": True}, 3, "n must be even, not 3"),
    ],
)
def test_numbers_are_what_the_symbols_are_assumed_to_be(assumed, value, said):
    """SymPy may have used it: √(n²) = −n for a negative n, sin πn = 0 for a whole one."""
    n = Symbol("n", **assumed)
    system = rt.System(u**2 / 2 - n**2 * x**2 / 2 - sqrt(n**2) * cos(pi * n) * x, x, u)
    for made in (lambda: system.motion({n: value}, 1), lambda: system.certify({n: value})):
        with pytest.raises(rt.RigidtopError, match=said):
            made()
