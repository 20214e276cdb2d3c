"""The heavy top against Newton and Euler, and its steady precession at forty digits."""

import mpmath
import numpy as np
import pytest
import sympy
from scipy.spatial.transform import Rotation
from sympy import Rational, cos, sin

from rigidtop.theory import symbols as s
from rigidtop.theory import top
from rigidtop.theory.lagrangian import energy, momenta
from rigidtop.theory.rotation import euler_omega
from rigidtop.theory.trig import reduce_ratio

POINT = {
    s.lambda1: 1.3,
    s.lambda3: 0.6,
    s.M: 0.8,
    s.g: 9.81,
    s.R: 0.4,
    s.theta: 0.9,
    s.thetadot: -0.7,
    s.phidot: 1.9,
    s.psidot: 5.3,
    s.phi: 0.2,
    s.psi: -1.1,
}


def attitude_and_omega(phi, theta, psi, rates):
    """Body-to-space rotation and ω in space, from the three turns as vectors."""
    turn = Rotation.from_euler("ZYZ", [phi, theta, psi]).as_matrix()
    nodes = np.array([-np.sin(phi), np.cos(phi), 0.0])
    thetadot, phidot, psidot = rates
    return turn, phidot * np.array([0, 0, 1.0]) + thetadot * nodes + psidot * turn[:, 2]


def newton_euler(moments, weight, centre, turn, omega):
    """ω̇ in body components: L̇ + ω × L = R × Mg, all in the body."""
    inside = turn.T @ omega
    torque = np.cross(centre, turn.T @ np.array([0, 0, -weight]))
    return (torque - np.cross(inside, moments * inside)) / moments


def test_symmetric_accelerations_are_newtons():
    p = {x.name: n for x, n in POINT.items()}
    rates = np.array([p["thetadot"], p["phidot"], p["psidot"]])
    turn, omega = attitude_and_omega(p["phi"], p["theta"], p["psi"], rates)
    moments = np.array([p["lambda1"], p["lambda1"], p["lambda3"]])
    wanted = newton_euler(moments, p["M"] * p["g"], np.array([0, 0, p["R"]]), turn, omega)
    found = np.array(top.symmetric_top_accelerations().subs(POINT), dtype=float)[:, 0]

    # ω in the body as the angles run on with these accelerations, differentiated.
    def omega_body(t):
        at = rates + found * t
        angles = np.array([p["theta"], p["phi"], p["psi"]]) + rates * t + found * t * t / 2
        now, turning = attitude_and_omega(angles[1], angles[0], angles[2], at)
        return now.T @ turning

    h = 1e-5
    differences = (omega_body(h) - omega_body(-h)) / (2 * h)
    assert differences == pytest.approx(wanted, rel=1e-8, abs=1e-8)


def test_heavy_body_rates_are_newtons():
    rng = np.random.default_rng(9)
    for _ in range(4):
        q = rng.normal(size=4)
        q /= np.linalg.norm(q)
        moments, centre = rng.uniform(1, 2, 3), rng.normal(size=3)
        inside = rng.normal(size=3)
        mass, gravity = 0.7, 9.81
        turn = Rotation.from_quat(q, scalar_first=True)
        wanted = newton_euler(moments, mass * gravity, centre, turn.as_matrix(), turn.apply(inside))
        values = dict(zip(top.QUATERNION, q, strict=True))
        values |= dict(zip(top.MOMENTS, moments, strict=True))
        values |= dict(zip(top.OMEGA, inside, strict=True))
        values |= dict(zip(top.CENTRE_OF_MASS, centre, strict=True))
        values |= {s.M: mass, s.g: gravity}
        found = np.array(top.heavy_body_rates().subs(values), dtype=float)[:, 0]
        assert found[4:] == pytest.approx(wanted)
        # The attitude a little later, turned by exp(ω h) in the body.
        h = 1e-6
        later = (turn * Rotation.from_rotvec(inside * h)).as_quat(scalar_first=True)
        earlier = (turn * Rotation.from_rotvec(-inside * h)).as_quat(scalar_first=True)
        later *= np.sign(later @ q)
        earlier *= np.sign(earlier @ q)
        assert found[:4] == pytest.approx((later - earlier) / (2 * h), abs=1e-8)


def test_energies_of_any_body():
    values = {
        **POINT,
        s.lambda2: 0.9,
        s.R1: 0.1,
        s.R2: -0.2,
        s.R3: 0.3,
    }
    p = {x.name: n for x, n in values.items()}
    turn, omega = attitude_and_omega(
        p["phi"], p["theta"], p["psi"], (p["thetadot"], p["phidot"], p["psidot"])
    )
    inside = turn.T @ omega
    kinetic = 0.5 * np.array([p["lambda1"], p["lambda2"], p["lambda3"]]) @ inside**2
    height = (turn @ np.array([p["R1"], p["R2"], p["R3"]]))[2]
    assert float(top.kinetic_energy().subs(values)) == pytest.approx(kinetic)
    assert float(top.potential_energy().subs(values)) == pytest.approx(p["M"] * p["g"] * height)
    assert float(top.lagrangian().subs(values)) == pytest.approx(kinetic - p["M"] * p["g"] * height)


def test_symmetric_lagrangian_is_the_general_one():
    general = top.lagrangian().subs(top.SYMMETRIC).subs(POINT)
    assert float(top.symmetric_lagrangian().subs(POINT)) == pytest.approx(float(general), rel=1e-13)


def test_effective_potential_by_hand():
    p_phi, p_psi = 1.7, 3.1
    at = {**POINT, s.p_phi: p_phi, s.p_psi: p_psi}
    theta = POINT[s.theta]
    wanted = (p_phi - p_psi * np.cos(theta)) ** 2 / (2 * 1.3 * np.sin(theta) ** 2)
    wanted += p_psi**2 / (2 * 0.6) + 0.8 * 9.81 * 0.4 * np.cos(theta)
    assert float(top.top_effective_potential().subs(at)) == pytest.approx(wanted)


# --- steady precession -------------------------------------------------------------------------

PARAMETERS = {s.lambda1: "1.3", s.lambda3: "0.6", s.M: "0.8", s.g: "9.81", s.R: "0.4"}


def values_at(theta, omega3):
    at = {**PARAMETERS, s.theta: theta, s.omega3: omega3}
    return {x: sympy.Float(n, 60) for x, n in at.items()}


def forty(expression, values):
    return mpmath.mpf(str(expression.evalf(45, subs=values)))


def roots_by_mpmath(theta, omega3):
    """Ω₋ and Ω₊ of a Ω² − b Ω + c = 0, by mpmath's polynomial solver at 60 digits."""
    with mpmath.workdps(60):
        p = {x.name: mpmath.mpf(n) for x, n in PARAMETERS.items()}
        leading = p["lambda1"] * mpmath.cos(mpmath.mpf(theta))
        spin, pull = p["lambda3"] * mpmath.mpf(omega3), p["M"] * p["g"] * p["R"]
        return sorted(
            mpmath.polyroots([leading, -spin, pull], maxsteps=200, extraprec=200), key=abs
        )


@pytest.mark.parametrize("theta", ["0.5", "1.4", "2.2"])
@pytest.mark.parametrize("omega3", ["14", "1000", "1e8"])
def test_steady_roots_to_forty_digits(theta, omega3):
    with mpmath.workdps(50):
        values = values_at(theta, omega3)
        for ours, root in zip(top.steady_roots(), roots_by_mpmath(theta, omega3), strict=True):
            assert abs(forty(ours, values) / root - 1) < mpmath.mpf(10) ** -40


@pytest.mark.parametrize("theta", [0.5, 2.2])
def test_steady_roots_do_not_cancel_in_double_precision(theta):
    parameters = [*PARAMETERS, s.theta, s.omega3]
    function = sympy.lambdify(parameters, top.steady_roots(), "math")
    found = function(*(float(n) for n in PARAMETERS.values()), theta, 1e8)
    for ours, root in zip(found, roots_by_mpmath(str(theta), "1e8"), strict=True):
        assert abs(ours / float(root) - 1) < 1e-15
    # The schoolbook form keeps three digits at most.
    a, b, c = 1.3 * np.cos(theta), 0.6 * 1e8, 0.8 * 9.81 * 0.4
    cancelled = (b - np.sqrt(b * b - 4 * a * c)) / (2 * a)
    assert abs(cancelled / found[0] - 1) > 1e-3


def test_the_slow_root_is_regular_for_a_horizontal_top():
    slow, _ = top.steady_roots()
    at = {x: Rational(n) for x, n in PARAMETERS.items()}
    horizontal = slow.subs({**at, s.omega3: 7, cos(s.theta): 0})
    assert horizontal == Rational("0.8") * Rational("9.81") * Rational("0.4") / (
        Rational("0.6") * 7
    )


@pytest.mark.parametrize("order", [1, 2, 3])
def test_expansions_miss_the_roots_by_the_next_power(order):
    with mpmath.workdps(60):
        errors = []
        for omega3 in ("1e4", "1e5"):
            values = values_at("0.7", omega3)
            roots = roots_by_mpmath("0.7", omega3)
            expansions = [forty(x, values) for x in top.steady_expansions(order)]
            errors.append([abs(x / r - 1) for x, r in zip(expansions, roots, strict=True)])
        for few, many in zip(*errors, strict=True):
            # ε falls by 10² when the spin grows tenfold.
            assert mpmath.log10(few / many) == pytest.approx(2 * order, abs=1e-3)


def test_expansions_by_hand():
    slow, fast = top.steady_expansions(2)
    pull, spin, along = s.M * s.g * s.R, s.lambda3 * s.omega3, s.lambda1 * cos(s.theta)
    assert sympy.simplify(slow - pull / spin - along * pull**2 / spin**3) == 0
    assert sympy.simplify(fast - spin / along + pull / spin) == 0


def test_quadratic_and_what_was_divided_out():
    quadratic = s.lambda1 * cos(s.theta) * s.Omega**2 - s.lambda3 * s.omega3 * s.Omega
    quadratic += s.M * s.g * s.R
    assert sympy.expand(top.steady_quadratic() - quadratic) == 0
    assert sympy.expand(top.steady_balance() - sin(s.theta) * quadratic) == 0
    assert top.steady_balance().subs(s.theta, sympy.pi) == 0
    discriminant = (s.lambda3 * s.omega3) ** 2 - 4 * s.lambda1 * s.M * s.g * s.R * cos(s.theta)
    assert sympy.expand(top.discriminant() - discriminant) == 0


def test_roots_are_leading_roots_times_functions_of_epsilon():
    values = {x: float(n) for x, n in PARAMETERS.items()} | {s.theta: 0.8, s.omega3: 17.0}
    epsilon = float(top.smallness().subs(values))
    for root, lead, factor in zip(
        top.steady_roots(), top.leading_roots(), top.root_factors(), strict=True
    ):
        product = float(lead.subs(values)) * float(factor.subs(s.epsilon, epsilon))
        assert product == pytest.approx(float(root.subs(values)), rel=1e-13)


@pytest.mark.parametrize("omega3", ["17", "-17"])
def test_roots_by_smallness_have_their_signs_of_the_root_for_either_spin(omega3):
    values = values_at("0.8", omega3)
    values[s.epsilon] = forty(top.smallness(), values)
    lead, spin, pull = (
        forty(x, values) for x in (s.lambda1 * cos(s.theta), s.lambda3 * s.omega3, s.M * s.g * s.R)
    )
    for sign, ours in zip((-1, 1), top.steady_roots_by_smallness(), strict=True):
        root = (spin + sign * mpmath.sqrt(spin**2 - 4 * lead * pull)) / (2 * lead)
        assert abs(forty(ours, values) / root - 1) < 1e-12


def test_a_top_that_spins_backwards_has_its_roots_exchanged():
    there, back = ({**values_at("0.8", spin)} for spin in ("17", "-17"))
    slow, fast = top.steady_roots()
    assert abs(forty(slow, back) + forty(fast, there)) < 1e-12
    assert abs(forty(fast, back) + forty(slow, there)) < 1e-12
    assert abs(forty(slow, back)) > abs(forty(fast, back))


def test_hamiltonian_of_the_top_is_energy_in_momenta():
    conjugate = dict(zip(top.CONJUGATE, top.symmetric_momenta(), strict=True))
    found = top.symmetric_hamiltonian().subs(conjugate)
    assert reduce_ratio(found - energy(top.symmetric_lagrangian(), top.RATES)) == 0


def test_angular_momentum_from_conjugate_momenta():
    conjugate = dict(zip(top.CONJUGATE, momenta(top.lagrangian(), top.RATES), strict=True))
    omega = euler_omega("body")
    moments = (s.lambda1, s.lambda2, s.lambda3)
    for found, moment, rate in zip(
        top.angular_momentum_from_conjugate(), moments, omega, strict=True
    ):
        assert reduce_ratio(found.subs(conjugate) - moment * rate) == 0


def test_hamiltonian_of_the_body_is_the_legendre_transform():
    conjugate = dict(zip(top.CONJUGATE, momenta(top.lagrangian(), top.RATES), strict=True))
    found = top.body_hamiltonian().subs(conjugate)
    assert reduce_ratio(found - energy(top.lagrangian(), top.RATES)) == 0


def test_hamiltonian_of_the_body_becomes_that_of_the_top():
    found = top.body_hamiltonian().subs(top.SYMMETRIC)
    assert reduce_ratio(found - top.symmetric_hamiltonian()) == 0


def test_hamilton_of_the_body_gives_the_velocities_and_lagranges_forces():
    L = top.lagrangian()
    conjugate = dict(zip(top.CONJUGATE, momenta(L, top.RATES), strict=True))
    rates = top.body_hamilton_equations().subs(conjugate)
    for found, wanted in zip(rates, (*top.RATES, *(L.diff(q) for q in top.ANGLES)), strict=True):
        assert reduce_ratio(found - wanted) == 0
    assert rates[4] == 0  # nothing turns about the vertical


def test_reduced_rates_are_those_of_all_three_angles():
    conjugate = dict(zip(top.CONJUGATE, top.symmetric_momenta(), strict=True))
    found = top.reduced_rates().subs(conjugate)
    wanted = (top.symmetric_top_accelerations()[0], s.phidot, s.psidot)
    assert [reduce_ratio(a - b) for a, b in zip(found, wanted, strict=True)] == [0, 0, 0]


def test_accelerations_of_the_body_become_those_of_the_top():
    found = top.accelerations_in_euler_angles().subs(top.SYMMETRIC)
    for ours, theirs in zip(found, top.symmetric_top_accelerations(), strict=True):
        assert reduce_ratio(ours - theirs) == 0
