"""The top on a table: Newton and Euler against Lagrange, and what the contact can't change."""

import pytest
import sympy
from sympy import Matrix, Rational, cos, sin

from rigidtop.codegen import shipped
from rigidtop.theory import sliding, top
from rigidtop.theory import symbols as s
from rigidtop.theory.euler import OMEGA
from rigidtop.theory.lagrangian import accelerations, cyclic
from rigidtop.theory.rotation import Z_AXIS, total_derivative
from rigidtop.theory.top import QUATERNION
from rigidtop.theory.trig import reduce_ratio, reduce_trig

NAMES = [side.name for side in shipped.SLIDING]
MOMENTA = Matrix([s.lambda1 * s.omega1, s.lambda1 * s.omega2, s.lambda3 * s.omega3])

UNIT = dict(zip(QUATERNION, (Rational(n, 5) for n in (4, 2, 1, 2)), strict=True))
"""A rational unit quaternion: identities that hold on unit quaternions alone are tested there."""

NUMBERS = {
    symbol: Rational(k + 3, 7) * (-1) ** k
    for k, symbol in enumerate((*OMEGA, *sliding.SLIP, *sliding.CONTACT_FORCE))
} | {
    s.lambda1: Rational(5, 3),
    s.lambda3: Rational(6, 7),
    s.M: Rational(11, 4),
    s.g: Rational(49, 5),
    s.R: Rational(3, 5),
    sliding.tip: Rational(1, 7),
    sliding.drag: Rational(1, 11),
    sliding.drag1: Rational(2, 13),
    sliding.drag3: Rational(3, 17),
    s.mu: Rational(3, 10),
    sliding.viscosity: Rational(1, 5),
}


def at(expression):
    """The value where attitude, rates and parameters are `UNIT` and `NUMBERS`."""
    return sympy.sympify(expression).subs(UNIT).subs(NUMBERS)


def moving():
    """e₃, V and a as symbols, and what they are."""
    values = shipped.contact_kinematics()
    names = (*sliding.AXIS, *sliding.VELOCITY, *sliding.FREE_SLIP)
    return dict(zip(names, values, strict=True))


def rates():
    """Rates of all variables, by symbol, under any contact force."""
    known = moving()
    axis = dict(list(known.items())[:3])
    turning = sliding.rates().subs(known)
    force = Matrix(sliding.CONTACT_FORCE)
    slipping = Matrix([known[a] for a in sliding.FREE_SLIP]) + sliding.mobility().subs(axis) * force
    return dict(
        zip((*QUATERNION, *OMEGA, *sliding.SLIP), (*turning[:7], *slipping[:2]), strict=True)
    )


def test_axis_and_velocity_go_with_the_attitude():
    axis, velocity = sliding.kinematics()
    flow = dict(zip(QUATERNION, sliding.rates()[:4], strict=True))
    rising = sliding.CENTRE_ABOVE_TIP * total_derivative(axis[2], flow)
    on_unit = {s.q0**2: 1 - s.q1**2 - s.q2**2 - s.q3**2}
    assert sympy.expand(sympy.expand(rising - velocity[2]).subs(on_unit)) == 0


def test_free_slip_and_mobility_are_the_rate_of_the_slip():
    """v = V + ω × ρ differentiated, V by Newton's law, the frame and ω by Euler's."""
    known = moving()
    force = Matrix(sliding.CONTACT_FORCE)
    flow = rates()
    frame = sliding.attitude()
    axis = frame * Matrix(Z_AXIS)
    turning = total_derivative(frame * Matrix(OMEGA), {k: flow[k] for k in (*QUATERNION, *OMEGA)})
    axis_rate = total_derivative(axis, {k: flow[k] for k in QUATERNION})
    velocity = Matrix([known[v] for v in sliding.VELOCITY])
    newton = force / s.M - s.g * Matrix(Z_AXIS) - sliding.drag / s.M * velocity
    rate = (
        newton
        + turning.cross(sliding.arm(axis))
        - sliding.CENTRE_ABOVE_TIP * (frame * Matrix(OMEGA)).cross(axis_rate)
    )
    free = Matrix([known[a] for a in sliding.FREE_SLIP])
    on_axis = dict(zip(sliding.AXIS, axis, strict=True))
    found = free + sliding.mobility().subs(on_axis) * force
    assert [at(x) for x in found - rate] == [0, 0, 0]
    # It can fail: half of the mobility is not enough.
    assert at((free + sliding.mobility().subs(on_axis) * force / 2 - rate)[0]) != 0


def test_what_friction_and_air_take_is_what_the_energy_loses():
    """Ė = −(dissipated), for every contact force that keeps the tip on the table."""
    known = moving()
    velocity = Matrix([known[v] for v in sliding.VELOCITY])
    energy = (
        s.M * velocity.dot(velocity) / 2
        + Matrix(OMEGA).dot(MOMENTA) / 2
        + s.M * s.g * sliding.CENTRE_ABOVE_TIP * known[sliding.e_z]
    )
    change = total_derivative(energy, rates())
    normal = sliding.N
    on_table = (
        known[sliding.a_z]
        + (
            sliding.mobility()[2, :].subs({e: known[e] for e in sliding.AXIS})
            * Matrix(sliding.CONTACT_FORCE)
        )[0]
    )
    *_, of_friction, of_air = sliding.rates().subs(known)
    numbers = {k: v for k, v in NUMBERS.items() if k is not normal}
    [push] = sympy.solve(on_table.subs(UNIT).subs(numbers), normal)
    gap = (change + of_friction + of_air).subs(UNIT).subs(numbers)
    assert sympy.simplify(gap.subs(normal, push)) == 0
    assert sympy.simplify(gap.subs(normal, push + 1)) != 0


def jellett_rate(drag):
    flow = rates()
    frame = sliding.attitude()
    axis = frame * Matrix(Z_AXIS)
    integral = -(frame * MOMENTA).dot(sliding.arm(axis))
    zero = {} if drag else dict.fromkeys((sliding.drag1, sliding.drag3), 0)
    return at(total_derivative(integral, flow).subs(zero))


def test_no_contact_force_changes_jelletts_integral():
    assert jellett_rate(drag=False) == 0
    assert jellett_rate(drag=True) != 0


def smooth_accelerations():
    """θ̈, φ̈, ψ̈ by Newton and Euler on a smooth plane, at φ = 0 and where frame and nodes agree."""
    half = s.theta / 2
    attitude = dict(zip(QUATERNION, (cos(half), 0, sin(half), 0), strict=True))
    spin = s.psidot + s.phidot * cos(s.theta)
    turning = {s.omega1: -s.phidot * sin(s.theta), s.omega2: s.thetadot, s.omega3: spin}
    nothing = dict.fromkeys((sliding.drag, sliding.drag1, sliding.drag3, *sliding.SLIP), 0)
    known = {
        name: value.subs(attitude).subs(turning).subs(nothing) for name, value in moving().items()
    }
    smooth = dict.fromkeys((s.mu, sliding.viscosity, *sliding.SLIP), 0)
    force = sliding.sliding_force().subs(smooth).subs(known)[:3]
    pushed = dict(zip(sliding.CONTACT_FORCE, force, strict=True))
    rate1, rate2, rate3 = (
        x.subs(pushed).subs(attitude).subs(turning).subs(nothing) for x in sliding.rates()[4:7]
    )
    # ω₁ = θ̇ sin χ − φ̇ sin θ cos χ and ω₂ = θ̇ cos χ + φ̇ sin θ sin χ with χ̇ = −φ̇ cos θ, at χ = 0.
    frame = -s.phidot * cos(s.theta)
    theta2 = rate2 - s.phidot * sin(s.theta) * frame
    phi2 = (s.thetadot * frame - s.phidot * cos(s.theta) * s.thetadot - rate1) / sin(s.theta)
    psi2 = rate3 - phi2 * cos(s.theta) + s.phidot * s.thetadot * sin(s.theta)
    return theta2, phi2, psi2


def smooth_lagrangian():
    """T − V on a smooth plane, the uniform drift of the centre left out: its height alone moves."""
    height = sliding.tip + sliding.CENTRE_ABOVE_TIP * cos(s.theta)
    turning = reduce_trig(top.kinetic_energy().subs(s.lambda2, s.lambda1))
    return turning + s.M * (height.diff(s.theta) * s.thetadot) ** 2 / 2 - s.M * s.g * height


def test_newton_and_euler_agree_with_lagrange_on_a_smooth_plane():
    coordinates = (s.theta, s.phi, s.psi)
    lagrangian = smooth_lagrangian()
    assert cyclic(lagrangian, coordinates) == (s.phi, s.psi)
    theirs = accelerations(lagrangian, coordinates, (s.thetadot, s.phidot, s.psidot))
    halves = {
        cos(s.theta / 2) ** 2: (1 + cos(s.theta)) / 2,
        sin(s.theta / 2) ** 2: (1 - cos(s.theta)) / 2,
        sin(s.theta / 2) * cos(s.theta / 2): sin(s.theta) / 2,
    }
    ours = [sympy.expand(x).subs(halves) for x in smooth_accelerations()]
    numbers = NUMBERS | {s.thetadot: Rational(2, 3), s.phidot: Rational(7, 5), s.psidot: 4}
    for mine, other in zip(ours, theirs, strict=True):
        for angle in (Rational(1, 3), Rational(6, 5)):
            gap = (mine - other).subs(numbers).subs(s.theta, angle)
            assert abs(sympy.N(gap, 50)) < Rational(1, 10**40)
            wrong = (mine - other * (1 + s.epsilon)).subs(numbers | {s.epsilon: Rational(1, 10**9)})
            assert abs(sympy.N(wrong.subs(s.theta, angle), 50)) > Rational(1, 10**40)


def test_lagrangian_of_the_sharp_tip_is_that_of_the_held_top_but_for_the_inertia():
    """The held top turns about its pivot: λ₁ + MR² there, for θ̇ and for φ̇ sin θ."""
    held = top.symmetric_lagrangian().subs(s.lambda1, s.lambda1 + s.M * s.R**2)
    free = smooth_lagrangian().subs(sliding.tip, 0)
    sideways = s.M * s.R**2 * (cos(s.theta) ** 2 * s.thetadot**2 + sin(s.theta) ** 2 * s.phidot**2)
    assert reduce_trig(held - free - sideways / 2) == 0


def test_rolling_force_holds_the_contact_and_sliding_force_its_height():
    rolling = sliding.mobility() * sliding.rolling_force() + Matrix(sliding.FREE_SLIP)
    names = (*sliding.AXIS, *sliding.FREE_SLIP, *sliding.DIRECTION)
    numbers = NUMBERS | {x: Rational(k + 2, 9) for k, x in enumerate(names)}
    assert [x.subs(numbers) for x in rolling] == [0, 0, 0]
    *force, slip_x, slip_y, divisor = sliding.sliding_force()
    moved = sliding.mobility() * Matrix(force) + Matrix(sliding.FREE_SLIP)
    assert (moved - Matrix([slip_x, slip_y, 0])).subs(numbers) == sympy.zeros(3, 1)
    normal = force[2]
    for f, d, v in zip(force, sliding.DIRECTION, sliding.SLIP, strict=False):
        assert (f + s.mu * normal * d + sliding.viscosity * v).subs(numbers) == 0
    upright = dict(zip(sliding.AXIS, (0, 0, 1), strict=True))
    assert divisor.subs(upright) == 1


@pytest.mark.parametrize("name", NAMES)
def test_shipped_equals_derived(name):
    side = shipped.named(name)
    numbers = {
        x: Rational(3 * k + 5, 2 * k + 9) for k, x in enumerate((*side.state, *side.parameters))
    }
    for ours, theirs in zip(shipped.symbolic(name), shipped.derived(name), strict=True):
        assert not ours.has(sympy.Float)
        if side.expand:
            assert sympy.expand(ours - theirs) == 0
        else:
            assert reduce_ratio((ours - theirs).subs(numbers)) == 0
        assert (ours * (1 + s.epsilon) - theirs).subs(numbers) != 0


@pytest.mark.parametrize(("name", "most"), list(zip(NAMES, (175, 70, 90, 110), strict=True)))
def test_operations(name, most):
    assert shipped.split(shipped.named(name)).rates.operations <= most


def test_constants_do_not_contain_the_state():
    for side in shipped.SLIDING:
        for constant in shipped.split(side).constants.values():
            assert constant.free_symbols <= set(side.parameters)
