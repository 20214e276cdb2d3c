"""Lagrangian mechanics on systems that are no tops."""

import re

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from sympy import Derivative, Function, Matrix, Rational, cos, sin, symbols
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

from rigidtop.theory import lagrangian as mechanics

m, M, l1, l2, k, g, B, e, p = symbols("m M l1 l2 k g B e p", positive=True)
x, y, z, u, v, w = symbols("x y z u v w", real=True)
a, b, c = symbols("a b c", real=True)


def double_pendulum():
    """Angles x, y from the vertical, velocities u, v."""
    kinetic = (m + M) * l1**2 * u**2 / 2 + M * l2**2 * v**2 / 2
    kinetic += M * l1 * l2 * u * v * cos(x - y)
    return kinetic + (m + M) * g * l1 * cos(x) + M * g * l2 * cos(y)


def spherical_pendulum():
    """Polar angle x from the upward vertical, azimuth y."""
    return m * l1**2 * (u**2 + v**2 * sin(x) ** 2) / 2 - m * g * l1 * cos(x)


def charge():
    """A charge in a magnetic field B along z, on a spring of stiffness k."""
    return m * (u**2 + v**2) / 2 + e * B * (x * v - y * u) / 2 - k * (x**2 + y**2) / 2


SYSTEMS = {
    "double pendulum": (double_pendulum(), (x, y), (u, v)),
    "spherical pendulum": (spherical_pendulum(), (x, y), (u, v)),
    "charge": (charge(), (x, y), (u, v)),
    "pendulum on a cart": (
        (m + M) * u**2 / 2 + m * l1 * u * v * cos(y) + m * l1**2 * v**2 / 2 + m * g * l1 * cos(y),
        (x, y),
        (u, v),
    ),
    "bead on a helix": (
        m * (u**2 + v**2 * x**2 + w**2) / 2 - k * (x - l1) ** 2 / 2 - m * g * z * cos(y),
        (x, y, z),
        (u, v, w),
    ),
}


@pytest.mark.parametrize("name", SYSTEMS)
def test_accelerations_are_those_of_lagranges_method(name):
    L, q, qdot = SYSTEMS[name]
    ours = mechanics.accelerations(L, q, qdot)
    t = symbols("t")
    dynamic = [Function(f"f{n}")(t) for n in range(len(q))]
    functions = dict(zip(q, dynamic, strict=True))
    rates = {old: f.diff(t) for old, f in zip(qdot, dynamic, strict=True)}
    method = LagrangesMethod(L.subs(rates).subs(functions), dynamic)
    method.form_lagranges_equations()
    rng = np.random.default_rng(11)
    parameters = {n: Rational(int(rng.integers(5, 30)), 10) for n in (m, M, l1, l2, k, g, B, e)}
    for _ in range(3):
        at = {n: Rational(int(rng.integers(-30, 30)), 17) for n in (*q, *qdot)}
        back = {f.diff(t): at[d] for f, d in zip(dynamic, qdot, strict=True)}
        back |= {f: at[n] for n, f in functions.items()}
        mass = np.array(method.mass_matrix.subs(back).subs(parameters).evalf(), dtype=float)
        force = np.array(method.forcing.subs(back).subs(parameters).evalf(), dtype=float)
        found = np.array(ours.subs(at).subs(parameters).evalf(), dtype=float)
        assert found == pytest.approx(np.linalg.solve(mass, force), rel=1e-10, abs=1e-12)


def test_accelerations_solve_the_equations():
    for L, q, qdot in SYSTEMS.values():
        accelerations = symbols("a:3")[: len(q)]
        equations = mechanics.euler_lagrange(L, q, qdot, accelerations)
        solution = mechanics.accelerations(L, q, qdot)
        residual = equations.subs(dict(zip(accelerations, solution, strict=True)))
        at = {n: 0.1 * n_th + 0.3 for n_th, n in enumerate((*q, *qdot, m, M, l1, l2, k, g, B, e))}
        assert np.array(residual.subs(at).evalf(), dtype=float) == pytest.approx(0, abs=1e-11)


def test_mass_matrix_and_momenta():
    mass = mechanics.mass_matrix(double_pendulum(), (u, v))
    coupling = M * l1 * l2 * cos(x - y)
    wanted = Matrix([[(m + M) * l1**2, coupling], [coupling, M * l2**2]])
    assert sympy.simplify(mass - wanted) == sympy.zeros(2)
    assert mechanics.momenta(charge(), (u, v)).expand() == Matrix(
        [m * u - B * e * y / 2, m * v + B * e * x / 2]
    )


def test_a_velocity_that_does_not_enter():
    with pytest.raises(ValueError, match="the mass matrix is singular: some velocity does not"):
        mechanics.accelerations(m * u**2 / 2 - k * (x**2 + y**2), (x, y), (u, v))


def test_a_velocity_that_enters_only_with_another():
    with pytest.raises(ValueError, match="the mass matrix is singular"):
        mechanics.accelerations(m * (u + v) ** 2 / 2, (x, y), (u, v))


def test_energy_of_a_natural_system_and_of_a_charge():
    potential = m * g * l1 * cos(x)
    assert (
        sympy.expand(
            mechanics.energy(spherical_pendulum(), (u, v)) - spherical_pendulum() - 2 * potential
        )
        == 0
    )
    # The magnetic field does no work.
    wanted = m * (u**2 + v**2) / 2 + k * (x**2 + y**2) / 2
    assert sympy.expand(mechanics.energy(charge(), (u, v)) - wanted) == 0


def test_cyclic_coordinates():
    assert mechanics.cyclic(spherical_pendulum(), (x, y)) == (y,)
    assert mechanics.cyclic(double_pendulum(), (x, y)) == ()
    assert mechanics.cyclic(double_pendulum().subs(g, 0), (x, y)) == ()
    assert mechanics.cyclic(m * (u**2 + v**2) / 2, (x, y)) == (x, y)
    assert mechanics.cyclic((x + 1) ** 2 - x**2 - 2 * x + u**2, (x,)) == (x,)


def test_routhian_of_a_spherical_pendulum():
    L = spherical_pendulum()
    assert mechanics.cyclic_velocities(L, (v,), (p,)) == {v: p / (m * l1**2 * sin(x) ** 2)}
    effective = mechanics.effective_potential(L, (v,), (p,), (u,))
    wanted = p**2 / (2 * m * l1**2 * sin(x) ** 2) + m * g * l1 * cos(x)
    assert sympy.simplify(effective - wanted) == 0
    routhian = mechanics.routhian(L, (v,), (p,))
    assert sympy.simplify(routhian - (m * l1**2 * u**2 / 2 - wanted)) == 0


def test_sign_of_the_gyroscopic_force_is_newtons():
    # m r̈ = e ṙ × B ẑ − k r: to the right of its way goes a positive charge.
    found = mechanics.accelerations(charge(), (x, y), (u, v))
    wanted = Matrix([(e * B * v - k * x) / m, (-e * B * u - k * y) / m])
    assert (found - wanted).applyfunc(sympy.simplify) == sympy.zeros(2, 1)


# --- Hamilton -------------------------------------------------------------------------------------

P, Q, S = symbols("P Q S", real=True)


def test_hamiltonian_of_a_pendulum():
    H = mechanics.hamiltonian(m * l1**2 * u**2 / 2 + m * g * l1 * cos(x), (u,), (P,))
    assert H.expand() == P**2 / (2 * m * l1**2) - m * g * l1 * cos(x)
    rates = mechanics.hamilton_equations(H, (x,), (P,))
    assert rates == Matrix([P / (m * l1**2), -m * g * l1 * sin(x)])


def test_hamiltonian_of_a_relativistic_particle():
    fast = symbols("fast", positive=True)
    H = mechanics.hamiltonian(-m * sympy.sqrt(1 - fast**2) - k * x**2 / 2, (fast,), (p,))
    wanted = sympy.sqrt(p**2 + m**2) + k * x**2 / 2
    at = {m: 1.3, k: 0.4, x: 0.7, p: 2.1}
    assert float(H.subs(at)) == pytest.approx(float(wanted.subs(at)), rel=1e-14)


@pytest.mark.parametrize("name", SYSTEMS)
def test_legendre_transform_undoes_itself_and_hamilton_agrees_with_lagrange(name):
    L, q, qdot = SYSTEMS[name]
    conjugate = (P, Q, S)[: len(q)]
    H = mechanics.hamiltonian(L, qdot, conjugate)
    rng = np.random.default_rng(5)
    at = {n: Rational(int(rng.integers(5, 30)), 11) for n in (*q, *qdot, m, M, l1, l2, k, g, B, e)}
    momenta = dict(zip(conjugate, mechanics.momenta(L, qdot).subs(at), strict=True))
    there = {**at, **momenta}
    back = mechanics.hamiltonian(H, conjugate, qdot)
    assert float(back.subs(at)) == pytest.approx(float(L.subs(at)), rel=1e-12)
    assert float(H.subs(there)) == pytest.approx(float(mechanics.energy(L, qdot).subs(at)))
    rates = mechanics.hamilton_equations(H, q, conjugate).subs(there)
    n = len(q)
    # ∂H/∂p = q̇, and ṗ is Lagrange's: ∂L/∂q.
    assert [float(r) for r in rates[:n]] == pytest.approx([float(at[d]) for d in qdot])
    assert [float(r) for r in rates[n:]] == pytest.approx([float(L.diff(c).subs(at)) for c in q])


@pytest.mark.parametrize("name", SYSTEMS)
def test_hamiltonian_is_conserved(name):
    L, q, qdot = SYSTEMS[name]
    conjugate = (P, Q, S)[: len(q)]
    H = mechanics.hamiltonian(L, qdot, conjugate)
    rates = mechanics.hamilton_equations(H, q, conjugate)
    change = sum(H.diff(z) * rate for z, rate in zip((*q, *conjugate), rates, strict=True))
    assert sympy.expand(change) == 0


@pytest.mark.parametrize(
    "L", [m * u**2 / 2 - k * (x**2 + y**2), m * (u + v) ** 2 / 2, m * (u**4 - v**4)]
)
def test_momenta_that_do_not_determine_the_velocities(L):
    with pytest.raises(ValueError, match=r"^the momenta do not determine the velocities$"):
        mechanics.hamiltonian(L, (u, v), (P, Q))


def test_routhian_is_the_legendre_transform_of_the_cyclic_part():
    L = spherical_pendulum()
    partial = mechanics.hamiltonian(L, (v,), (p,))
    assert sympy.expand(mechanics.routhian(L, (v,), (p,)) + partial) == 0


# --- Functions of time ----------------------------------------------------------------------------

TIME = dynamicsymbols._t
r, phi = dynamicsymbols("r phi")
ORBIT = m * (r.diff() ** 2 + r**2 * phi.diff() ** 2) / 2 - k * r**2 / 2


def of_time(L, q, qdot):
    """The same system with functions of time, and how to write its functions as symbols again."""
    functions = [Function(f"f{n}")(TIME) for n in range(len(q))]
    rates = [f.diff(TIME) for f in functions]
    back = {**dict(zip(rates, qdot, strict=True)), **dict(zip(functions, q, strict=True))}
    there = {name: function for function, name in back.items()}
    return L.xreplace(there), functions, rates, back


@pytest.mark.parametrize("name", SYSTEMS)
def test_functions_of_time_do_what_symbols_do(name):
    plain, q, qdot = SYSTEMS[name]
    L, functions, rates, back = of_time(*SYSTEMS[name])
    n, conjugate, beyond = len(q), (P, Q, S)[: len(q)], [f.diff(TIME, 2) for f in functions]

    def same(found, wanted):
        return sympy.expand(Matrix([found]).xreplace(back) - Matrix([wanted])).is_zero_matrix

    assert same(
        mechanics.accelerations(L, functions, rates), mechanics.accelerations(*SYSTEMS[name])
    )
    assert same(
        mechanics.hamiltonian(L, rates, conjugate), mechanics.hamiltonian(plain, qdot, conjugate)
    )
    assert same(mechanics.energy(L, rates), mechanics.energy(plain, qdot))
    assert [back[f] for f in mechanics.cyclic(L, functions)] == [*mechanics.cyclic(plain, q)]
    last = (L, rates[-1:], conjugate[-1:])
    assert same(mechanics.routhian(*last), mechanics.routhian(plain, qdot[-1:], conjugate[-1:]))
    equations = mechanics.euler_lagrange(L, functions, rates, beyond)
    named = equations.xreplace(dict(zip(beyond, (a, b, c), strict=False)))
    assert same(named, mechanics.euler_lagrange(plain, q, qdot, (a, b, c)[:n]))


POWERS = st.tuples(*[st.integers(0, 2)] * 5)
TERMS = st.lists(st.tuples(st.integers(-4, 4), POWERS), max_size=4)


@settings(max_examples=8)
@given(TERMS)
def test_lagranges_equations_of_any_L_of_functions_and_time_are_sympys(terms):
    # h(t) is a motion that is given; t enters besides.
    h = Function("h")(TIME)
    factors = (r, sin(phi), r.diff(), phi.diff() + h.diff(), TIME)
    L = ORBIT + sum(
        n * sympy.prod(factor**power for factor, power in zip(factors, powers, strict=True))
        for n, powers in terms
    )
    q, qdot = [r, phi], [r.diff(), phi.diff()]
    ours = mechanics.euler_lagrange(L, q, qdot, [x.diff(TIME, 2) for x in q])
    theirs = LagrangesMethod(L, q).form_lagranges_equations()
    assert (ours - theirs).expand().is_zero_matrix


def test_a_pivot_that_is_shaken():
    # Kapitza's pendulum: its pivot at the height h(t) changes g to g + ḧ.
    height = Function("h")(TIME)
    for pivot in (height, l2 * cos(k * TIME)):
        x, z = l1 * sin(phi), pivot - l1 * cos(phi)
        L = m * (x.diff(TIME) ** 2 + z.diff(TIME) ** 2) / 2 - m * g * z
        [found] = mechanics.accelerations(L, [phi], [phi.diff()])
        assert sympy.expand(found + (g + pivot.diff(TIME, 2)) * sin(phi) / l1) == 0


def test_the_time_itself_in_plain_symbols():
    t = symbols("t", real=True)
    swing = m * u**2 * sympy.exp(k * t / m) / 2  # friction −k ẋ, by Caldirola and Kanai
    assert mechanics.accelerations(swing, [x], [u]) == Matrix([-k * u / m])


def test_functions_whose_velocities_are_not_determined():
    L = m * (r.diff() + phi.diff()) ** 2 / 2
    with pytest.raises(ValueError, match=r"^the momenta do not determine the velocities$"):
        mechanics.hamiltonian(L, [r.diff(), phi.diff()], [P, Q])
    with pytest.raises(ValueError, match=r"^the mass matrix is singular"):
        mechanics.accelerations(L, [r, phi], [r.diff(), phi.diff()])


@pytest.mark.parametrize(
    ("L", "q", "qdot", "said"),
    [
        (
            ORBIT,
            [r, phi],
            [phi.diff(), r.diff()],
            "Derivative(phi(t), t) is given as the rate of r",
        ),
        (ORBIT, [r, phi], [r.diff(TIME, 2), phi.diff()], "Derivative(r(t), (t, 2)) is given as"),
        (ORBIT, [r, phi], [u, v], "L has Derivative("),
        (ORBIT + r.diff(TIME, 2), [r], [r.diff()], "L has Derivative(r(t), (t, 2)), which is none"),
        (
            ORBIT + Derivative(r**2, TIME, evaluate=False),
            [r, phi],
            [r.diff(), phi.diff()],
            "L has Derivative(r(t)**2, t), which is none of the velocities",
        ),
        (ORBIT, [r, phi], [r.diff()], "2 coordinates, 1 velocities: there have to be as many"),
        (u**2, [x, x], [u, v], "among the coordinates, x, x, one stands twice"),
        (u**2, [x], [2 * u], "2*u is among the velocities: no symbol and no function of time"),
        (u**2, x, u, "the coordinates are x: a sequence was expected, such as [x]"),
        ("u**2", [x], [u], "'u**2' is no expression of SymPy: L or H has to be one"),
    ],
)
def test_what_cannot_be_taken_is_said(L, q, qdot, said):
    with pytest.raises(ValueError, match=f"^{re.escape(said)}"):
        mechanics.accelerations(L, q, qdot)


def test_momenta_that_are_too_few():
    with pytest.raises(ValueError, match=r"^2 velocities, 1 momenta: there have to be as many of"):
        mechanics.hamiltonian(charge(), (u, v), (P,))
    with pytest.raises(ValueError, match=r"^1 velocities, 2 accelerations: there have to be as"):
        mechanics.euler_lagrange(u**2, (x,), (u,), (a, b))
