"""Answers that would be plausible and wrong: each of these was, or might have been, given."""

import pickle

import numpy as np
import pytest
from sympy import (
    Abs,
    Function,
    Heaviside,
    I,
    Mod,
    Symbol,
    acos,
    besselj,
    cbrt,
    cos,
    erf,
    exp,
    log,
    pi,
    sign,
    sin,
    sqrt,
    symbols,
)
from sympy.physics.mechanics import dynamicsymbols

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


def test_another_symbol_named_t_is_not_taken_for_a_constant():
    """The energy of what is driven would be conserved."""
    other, angle = Symbol("t", positive=True), dynamicsymbols("angle")
    kinetic = m * angle.diff() ** 2 / 2
    with pytest.raises(rt.RigidtopError, match="two symbols named t: there is only one time"):
        rt.System(kinetic + k * cos(Omega * other) * cos(angle), angle)
    with pytest.raises(rt.RigidtopError, match="two symbols named t"):
        rt.System(kinetic, angle, forces=[cos(Omega * other)])
    free = rt.System(m * u**2 / 2, x, u)
    assert free.is_conserved(x - u * t)
    with pytest.raises(rt.RigidtopError, match="two different symbols are called t"):
        free.is_conserved(x - u * other)
    with pytest.raises(rt.RigidtopError, match="two different symbols are called t"):
        free.poisson(x - u * other, u)


def test_a_lagrangian_has_to_be_real():
    with pytest.raises(rt.RigidtopError, match="L must be real, not"):
        rt.System(u**2 / 2 - I * x**2, x, u)
    with pytest.raises(rt.RigidtopError, match="z is a symbol for numbers that are not real"):
        rt.System(u**2, Symbol("z", imaginary=True), u)


def test_a_relativistic_particle_has_a_mass_matrix():
    """L is real for v < c alone; in a field B it goes round at eB/γm."""
    light, charge = symbols("light charge", positive=True)
    free = -m * light**2 * sqrt(1 - (u**2 + v**2) / light**2)
    system = rt.System(free + charge * (x * v - y * u) / 2, [x, y], [u, v])
    assert system.is_conserved(system.energy)
    run = system.motion({m: 1, light: 2, charge: 3}, [0, 0], [1, 0]).integrate([0.7])
    rate = 3 * np.sqrt(1 - 1 / 4)
    assert np.allclose(run.qdot[0], [np.cos(0.7 * rate), -np.sin(0.7 * rate)], atol=1e-9)


def test_coordinates_without_assumptions_are_real():
    a, b = symbols("a b")
    thrown = rt.System(b**2 / 2 - Abs(a), a, b)
    run = thrown.motion({}, 0.5, 0.0).integrate([0.5, 1.5])
    assert np.allclose(run.q[:, 0], [0.375, -0.375], atol=1e-8)
    assert thrown.accelerations[0] == -sign(a)
    assert run.columns().keys() == {"t/s", "a", "b", "energy"}


@pytest.mark.parametrize(
    ("potential", "said"),
    [
        (Heaviside(x), "Python has no DiracDelta"),
        (besselj(0, x), "Python has no besselj"),
        (Function("V")(x), r"Derivative\(V\(x\), x\) has no numbers: put in what it is"),
        (Mod(x, 1), r"Derivative\(Mod\(x, 1\), x\) has no numbers"),
        (cbrt(x), "can't be computed at x = -0.5: a power of a negative number is not real"),
    ],
)
def test_what_has_no_numbers_says_so(potential, said):
    with pytest.raises(rt.RigidtopError, match=said):
        rt.System(u**2 / 2 - potential, x, u).motion({}, -0.5)


def test_functions_of_scipy_and_numbers_within_them():
    """erf'(x) = 2 exp(−x²)/√π: NumPy has no erf, and heyoka no root of a number."""
    well = rt.System(u**2 / 2 - erf(x), x, u).motion({}, 0.7, -1.0)
    runs = [well.integrate([0.5, 1.5], method=method) for method in ("DOP853", "taylor")]
    assert np.allclose(runs[0].q, runs[1].q, atol=1e-9)
    assert max(run.drift()["energy"] for run in runs) < 1e-9


def test_an_event_without_numbers_is_refused():
    motion = rt.System(u**2 / 2 - x**2 / 2, x, u).motion({}, 1)
    with pytest.raises(rt.RigidtopError, match="the event there can't be computed at t = "):
        motion.integrate((0, 10), events={"there": log(x)})


def test_nothing_is_refuted_where_nothing_is_real():
    nowhere = rt.System(u**2 / 2, x, u)
    with pytest.raises(rt.RigidtopError, match="neither shown nor refuted"):
        nowhere.is_conserved(sqrt(-1 - x**2))


def test_certified_with_names_that_are_none_in_python():
    odd, keyword = symbols("m_{1} lambda", positive=True)
    spring = rt.System(odd * u**2 / 2 - keyword * x**2 / 2, x, u)
    assert max(spring.certify({odd: 1, keyword: 4}).values()) < 1e-12


@pytest.mark.parametrize("name", ["pi", "e", "sin", "abs", "None", "1a", "_p", "a%b"])
def test_names_that_mean_something_else(name):
    """A parameter called pi was not π's 3.14, and one called sin no function."""
    letter = Symbol(name, positive=True)
    spring = rt.System(u**2 / 2 - letter * (pi * x**2 / 2 + sin(x)), x, u)
    known = rt.System(u**2 / 2 - k * (pi * x**2 / 2 + sin(x)), x, u)
    runs = [s.motion({p: 2}, 1).integrate([1.0]) for s, p in ((spring, letter), (known, k))]
    assert runs[0].q == pytest.approx(runs[1].q, rel=1e-12)
    made = {}
    exec(spring.source("python"), made)
    assert made["accelerations"](0.3, 0.1, 2.0)[0] == pytest.approx(
        float(-2 * (pi * 0.3 + cos(0.3))), rel=1e-14
    )


@pytest.mark.parametrize("method", ["DOP853", "taylor"])
@pytest.mark.parametrize(("size", "field"), [(1e-10, 1.0), (1e11, 1e20)])
def test_an_orbit_is_as_exact_in_an_atom_as_in_the_sky(size, field, method):
    """An absolute tolerance of 1e-12 m is a hundredth of an atom."""
    kepler = rt.System(m * (u**2 + v**2) / 2 + k * m / sqrt(x**2 + y**2), [x, y], [u, v])
    speed = np.sqrt(3 * field / size)  # at the perihelion, for ε = ½
    motion = kepler.motion({m: 1e-30, k: field}, [size / 2, 0], [0, speed])
    run = motion.integrate([6 * np.pi * np.sqrt(size**3 / field)], method=method)
    assert run.q[0] / size == pytest.approx([0.5, 0], abs=1e-7)
    assert max(run.drift().values()) < 1e-9


@pytest.mark.parametrize("method", ["DOP853", "taylor"])
@pytest.mark.parametrize("start", [(1e-14, 0), (0, 1e-14), (1e-17, 1), (1, 1e-17)])
def test_small_motions_are_large_ones_made_small(start, method):
    spring = rt.System(m * u**2 / 2 - k * x**2 / 2, x, u).motion({m: 1e-30, k: 1e-30}, *start)
    run = spring.integrate([10.0], method=method)
    known = start[0] * np.cos(10) + start[1] * np.sin(10)
    assert run.q[0, 0] == pytest.approx(known, rel=1e-8)


def test_no_zero_of_what_changes_fast_is_missed():
    """The steps of a free motion are as long as they like."""
    free = rt.System(u**2 / 2, x, u).motion({}, 0, 1)
    found = free.integrate((0, 10), events={"zero": sin(50 * x)}).events["zero"]
    assert found == pytest.approx(np.arange(1, 160) * np.pi / 50, abs=1e-9)


def test_two_zeros_near_each_other_and_none():
    spring = rt.System(u**2 / 2 - x**2 / 2, x, u).motion({}, 1)
    watched = {"near": x - 1 + 1e-9, "touched": x - 1, "pole": 1 / x, "nothing": 0 * x}
    found = spring.integrate((0, 7), events=watched).events
    apart = np.sqrt(2e-9)
    turn = 2 * np.pi
    assert found.pop("near") == pytest.approx([apart, turn - apart, turn + apart], abs=1e-6)
    assert not any(map(len, found.values()))


def test_a_system_and_its_motions_can_be_pickled():
    angle = dynamicsymbols("angle")
    for system in (BEAD, rt.System(m * angle.diff() ** 2 / 2 + m * g * cos(angle), angle)):
        numbers = dict.fromkeys(system.parameters, 1.5)
        run = system.motion(numbers, 0.1).integrate([1.0])
        again = pickle.loads(pickle.dumps(run))
        assert again == run
        assert again.motion == run.motion
        assert again.motion.integrate([1.0]) == run


@pytest.mark.parametrize(
    ("potential", "places"),
    [
        (cos(3 * x), [k * pi / 3 for k in range(6)]),
        (cos(2 * x), [k * pi / 2 for k in range(4)]),
        (cos(x / 2), [0, 2 * pi]),
        (cos(x), [0, pi]),
        (x**4 - x**2, [-sqrt(2) / 2, 0, sqrt(2) / 2]),
    ],
)
def test_all_equilibria_of_a_turn_are_found_once(potential, places):
    """SymPy has 0 and π/3 of sin 3x = 0."""
    found = rt.System(u**2 / 2 - potential, x, u).equilibria()
    assert len(found) == len(places)
    assert {each[x] for each in found} == {*places}


def test_without_cyclic_coordinates_the_routhian_is_the_lagrangian():
    spring = rt.System(m * u**2 / 2 - k * x**2, x, u)
    assert spring.routhian == spring.L
    assert spring.effective_potential == k * x**2


def test_a_coordinate_stays_where_it_was_declared():
    """|x|³ is x³ for SymPy where x is positive, and pushes away on the other side."""
    x = dynamicsymbols("x", positive=True)
    system = rt.System(m * x.diff() ** 2 / 2 - k * Abs(x) ** 3, [x])
    motion = system.motion({m: 1, k: 1}, q=[1.0])
    assert motion.integrate([0.5]).q[0, 0] < 1
    with pytest.raises(rt.RigidtopError, match=r"^x is declared positive, and does not stay so"):
        motion.integrate([2.5])
    with pytest.raises(rt.RigidtopError, match=r"^x is declared positive"):
        system.motion({m: 1, k: 1}, q=[-1.0])


def test_a_velocity_has_both_signs():
    """Where it is said to have one, −cv|v| is −cv² and the sign of v is 1."""
    x, v = symbols("x v", positive=True)
    for force in (-c * v * Abs(v), -c * sign(v)):
        with pytest.raises(rt.RigidtopError, match=r"^v is declared to have one sign"):
            rt.System(m * v**2 / 2 - k * x**2 / 2, [x], [v], forces=[force])
    with pytest.raises(rt.RigidtopError, match=r"^v is declared to have one sign"):
        rt.System(m * v**2 / 2 + k * v, [x], [v])


def test_what_is_the_same_on_both_sides_may_be_declared_on_one():
    x, v = symbols("x v", positive=True)
    swing = rt.System(m * v**2 / 2 - k * x**2 / 2, [x], [v])
    run = swing.motion({m: 1, k: 1}, q=[1.0]).integrate([0.0, 3.0])
    assert run.q[1, 0] == pytest.approx(np.cos(3.0), abs=1e-9)
