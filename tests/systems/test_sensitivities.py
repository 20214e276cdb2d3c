"""Derivatives of motions: against closed forms, differences, and laws that hold for all of them."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.special import ellipe, ellipk
from sympy import Abs, Max, Mod, Piecewise, Symbol, cos, floor, sign, sin, sqrt, symbols
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt

m, g, rod, k, c, F = symbols("m g l k c F", positive=True)
x, y, a, b, u, v, w, t, Omega = symbols("x y a b u v w t Omega", real=True)
SPRING = rt.System(u**2 / 2 - k**2 * x**2 / 2, x, u)
PENDULUM = rt.System(m * rod**2 * u**2 / 2 + m * g * rod * cos(x), x, u)
DOUBLE = rt.System.of_parts(
    [
        rt.Mass(m, [rod * sin(x), -rod * cos(x)]),
        rt.Mass(m, [rod * sin(x) + sin(y), -rod * cos(x) - cos(y)]),
    ],
    [x, y],
    [u, v],
    gravity=[0, -g],
)
DRIVEN = rt.System(
    m * u**2 / 2 - k * x**2 / 2 - x**4 / 4,
    x,
    u,
    forces=F * cos(Omega * t),
    rayleigh=c * u**2 / 2,
)
CHARGE = rt.System(m * (u**2 + v**2) / 2 + k * x**2 * v - g * (x**2 + 2 * y**2), [x, y], [u, v])
BOB = rt.System(m * (u**2 + v**2) / 2 - m * g * y, [x, y], [u, v], constraints=x**2 + y**2 - rod**2)
FINE = {"rtol": 1e-12, "atol": 1e-14}

FEW = settings(max_examples=12)
numbers = st.floats(-2, 2).map(lambda z: round(z, 3))
lengths = st.floats(0.2, 3).map(lambda z: round(z, 3))


def by_differences(system, parameters, q, qdot, letter, times, h=2e-3):
    """∂(q, q̇)/∂(a letter), (N, 2n), by central differences, extrapolated twice."""
    n = len(q)

    def states(change):
        values, start = dict(parameters), [*q, *qdot]
        if letter in values:
            values[letter] += change
        else:
            start[[*system.names.q, *system.names.v].index(letter)] += change
        run = system.motion(values, start[:n], start[n:]).integrate(times, rtol=2.3e-14, atol=1e-15)
        return np.hstack([run.q, run.qdot])

    first, second, third = ((states(s) - states(-s)) / (2 * s) for s in (h, h / 2, h / 4))
    return (64 * third - 20 * second + first) / 45


# --- Closed forms --------------------------------------------------------------------------------


@FEW
@given(rate=lengths, place=numbers, speed=numbers)
def test_of_an_oscillator(rate, place, speed):
    """x = x₀ cos ωt + (v₀/ω) sin ωt, before t = 0 too, and in any order."""
    times = np.array([3.0, -2.0, 0.0, 10.0, 0.5])
    run = SPRING.motion({k: rate}, place, speed).sensitivities(times, [k, u, x])
    s, co = np.sin(rate * times), np.cos(rate * times)
    own = -place * times * s + speed * (times * co / rate - s / rate**2)
    turned = -place * (s + rate * times * co) - speed * times * s
    assert run.q_by[:, 0] == pytest.approx(np.stack([own, s / rate, co], 1), abs=2e-8)
    assert run.qdot_by[:, 0] == pytest.approx(np.stack([turned, co, -rate * s], 1), abs=2e-8)
    assert run.q_by.shape == run.qdot_by.shape == (5, 1, 3)


def test_of_the_period_of_a_pendulum():
    """At a quarter of it θ = 0, where ∂θ/∂p = −θ̇ ∂(T/4)/∂p; T = 4K(sin² α/2) √(l/g)."""
    numbers, amplitude = {m: 1.3, g: 9.81, rod: 0.7}, 2.0
    k2 = np.sin(amplitude / 2) ** 2
    quarter = ellipk(k2) * np.sqrt(0.7 / 9.81)
    by_k2 = (ellipe(k2) / (1 - k2) - ellipk(k2)) / (2 * k2)
    known = {
        g: -quarter / (2 * 9.81),
        rod: quarter / (2 * 0.7),
        m: 0.0,
        x: by_k2 * np.sqrt(0.7 / 9.81) * np.sin(amplitude) / 2,
    }
    run = PENDULUM.motion(numbers, amplitude).sensitivities([quarter], [*known], **FINE)
    assert run.q[0, 0] == pytest.approx(0, abs=1e-10)
    assert -run.q_by[0, 0] / run.qdot[0, 0] == pytest.approx([*known.values()], abs=1e-9)


def test_of_the_precession_of_a_heavy_top():
    """A steady one under a weight that grows: θ shakes about a new place, φ̇ follows by p_φ."""
    theta, phi, psi = dynamicsymbols("theta phi psi")
    l1, l3, R = symbols("lambda1 lambda3 R", positive=True)
    spin = psi.diff() + phi.diff() * cos(theta)
    L = l1 * (theta.diff() ** 2 + phi.diff() ** 2 * sin(theta) ** 2) / 2 + l3 * spin**2 / 2
    top = rt.System(L - m * g * R * cos(theta), [theta, phi, psi])
    tilt, omega3 = 0.6, 30.0
    body = rt.HeavyTop(lambda1=1.0, lambda3=0.5, M=2.0, R=0.4)
    rate, _ = body.steady_precession(theta=tilt, omega3=omega3)
    motion = top.motion(
        {l1: 1, l3: 0.5, m: 2, R: 0.4, g: 9.81},
        [tilt, 0, 0],
        [0, rate, omega3 - rate * np.cos(tilt)],
    )
    run = motion.sensitivities(np.linspace(0, 20, 201), ["g", "phi"], **FINE)
    s, co, gyration, push = np.sin(tilt), np.cos(tilt), 0.5 * omega3, 0.8
    follows = gyration / s - 2 * rate * co / s
    stiffness = -(
        rate**2 * np.cos(2 * tilt)
        - gyration * rate * co
        + push * 9.81 * co
        + (2 * rate * s * co - gyration * s) * follows
    )
    shakes = np.sqrt(stiffness)
    shift = push * s / stiffness
    known = shift * (1 - np.cos(shakes * run.t))
    turned = follows * shift * (run.t - np.sin(shakes * run.t) / shakes)
    assert run.of(g)[0][:, 0] == pytest.approx(known, abs=1e-9)
    assert run.of(g)[0][:, 1] == pytest.approx(turned, abs=1e-8)
    assert run.of(phi)[0] == pytest.approx(np.tile([0, 1, 0], (201, 1)), abs=1e-12)


# --- Differences ---------------------------------------------------------------------------------


@pytest.mark.parametrize("letter", [m, rod, y, u])
def test_of_a_double_pendulum_as_by_differences(letter):
    given = {m: 1.5, g: 9.81, rod: 0.8}, [1.1, -0.4], [0.2, 0.7]
    times = np.linspace(0, 4, 9)
    run = DOUBLE.motion(*given).sensitivities(times, letter, **FINE)
    other = by_differences(DOUBLE, *given, letter, times)
    size = max(1.0, np.max(np.abs(other)))
    assert np.hstack(run.of(letter)) == pytest.approx(other, abs=1e-7 * size)


@pytest.mark.parametrize("letter", [m, c, Omega, x])
def test_of_a_driven_and_damped_oscillator_as_by_differences(letter):
    given = {m: 1.2, k: 2.0, c: 0.3, F: 0.9, Omega: 1.7}, [0.4], [-0.3]
    times = np.array([-1.0, 2.0, 9.0])
    run = DRIVEN.motion(*given).sensitivities(times, [letter], **FINE)
    other = by_differences(DRIVEN, *given, letter, times)
    assert np.hstack(run.of(letter)) == pytest.approx(other, abs=1e-7)


@pytest.mark.parametrize("method", ["Radau", "LSODA", "taylor"])
def test_of_other_solvers(method):
    if method == "taylor":
        pytest.importorskip("heyoka", reason="heyoka has no wheel here")
    times = [-1.0, 5.0]
    motion = DRIVEN.motion({m: 1.1, k: 2, c: 0.3, F: 1, Omega: 2}, 0.4)
    run, other = (motion.sensitivities(times, [Omega, x, m], each) for each in (method, "DOP853"))
    assert run.q_by == pytest.approx(other.q_by, abs=1e-7)
    assert run.qdot_by == pytest.approx(other.qdot_by, abs=1e-7)


def test_of_taylor_series_with_constraints_and_in_other_units():
    pytest.importorskip("heyoka", reason="heyoka has no wheel here")
    bob = BOB.motion({m: 1e-26, g: 9.81e4, rod: 2e-10}, [1.2e-10, -1.6e-10])
    run, other = (bob.sensitivities(1e-6, [g, m], each) for each in ("taylor", "DOP853"))
    assert np.max(np.abs(other.of(g)[0])) > 1e-17
    assert run.of(g)[0] == pytest.approx(other.of(g)[0], rel=1e-6)


def test_a_new_start_never_compiles_again(monkeypatch):
    heyoka = pytest.importorskip("heyoka", reason="heyoka has no wheel here")
    first = SPRING.motion({k: 2}, 0.3).sensitivities(3.0, [k, u], "taylor")
    assert first.q_by[0, 0] == pytest.approx([-0.9 * np.sin(6), np.sin(6) / 2], abs=1e-12)
    monkeypatch.setattr(heyoka, "taylor_adaptive", None)
    other = SPRING.motion({k: 1}, 0.3).sensitivities(3.0, [k, u], "taylor")
    assert other.q_by[0, 0] == pytest.approx([-0.9 * np.sin(3), np.sin(3)], abs=1e-12)


# --- Laws ----------------------------------------------------------------------------------------


def canonical(run, system):
    """∂(q, p)/∂(q₀, q̇₀), of shape (N, 2n, 2n), where that was asked for."""
    turned = np.stack([run.gradient(p) for p in system.p], axis=1)
    return np.concatenate([run.q_by, turned], axis=1)


@FEW
@given(start=st.lists(numbers, min_size=4, max_size=4))
@pytest.mark.parametrize(
    ("system", "values"),
    [(DOUBLE, {m: 1.5, g: 2.0, rod: 0.8}), (CHARGE, {m: 1.5, g: 2.0, k: 0.8})],
)
def test_a_flow_is_symplectic(system, values, start):
    """MᵀJM = J and det M = 1 in q and p; in q and q̇ it is neither."""
    motion = system.motion(values, start[:2], start[2:])
    run = motion.sensitivities([0.0, 1.0, 2.0], [*system.q, *system.qdot], **FINE)
    first, *later = canonical(run, system)
    J = np.block([[np.zeros((2, 2)), np.eye(2)], [-np.eye(2), np.zeros((2, 2))]])
    for each in later:
        M = each @ np.linalg.inv(first)
        size = np.linalg.norm(M) ** 2
        assert pytest.approx(J, abs=1e-9 * size) == M.T @ J @ M
        assert np.linalg.det(M) == pytest.approx(1, abs=1e-9 * size)


@FEW
@given(start=st.lists(numbers, min_size=4, max_size=4), first=numbers, then=numbers)
def test_derivatives_of_motions_that_follow_one_another_multiply(start, first, then):
    values, by = {m: 1.5, g: 2.0, k: 0.8}, [x, y, u, v]

    def moved(state, time):
        run = CHARGE.motion(values, state[:2], state[2:]).sensitivities(time, by, **FINE)
        return np.hstack([run.q, run.qdot])[0], np.vstack([run.q_by[0], run.qdot_by[0]])

    middle, M = moved(start, first)
    _, N = moved(middle, then)
    _, whole = moved(start, first + then)
    size = np.linalg.norm(M) * np.linalg.norm(N)
    assert pytest.approx(whole, abs=1e-9 * size) == N @ M


@FEW
@given(angle=numbers, speed=numbers, gravity=lengths, length=lengths)
def test_a_pendulum_has_no_clock_and_no_ruler(angle, speed, gravity, length):
    """With lengths and with times measured otherwise it is the same: 2g θ_g + v θ_v = t θ̇."""
    times = np.array([0.5, 2.0])
    motion = PENDULUM.motion({m: 1, g: gravity, rod: length}, angle, speed)
    run = motion.sensitivities(times, [g, rod, x, u], **FINE)
    by_g, by_l, by_x, by_u = run.q_by[:, 0].T
    size = 1e-8 * (1 + np.abs(run.q_by).max())
    assert 2 * gravity * by_g + speed * by_u == pytest.approx(times * run.qdot[:, 0], abs=size)
    assert gravity * by_g + length * by_l == pytest.approx([0, 0], abs=size)
    # Of a start that is later on the way (θ̇, θ̈) goes on as itself.
    late = by_x * speed - by_u * gravity / length * np.sin(angle)
    assert late == pytest.approx(run.qdot[:, 0], abs=size)


@FEW
@given(start=st.lists(numbers, min_size=4, max_size=4))
def test_what_is_conserved_has_derivatives_that_stay(start):
    motion = DOUBLE.motion({m: 1.5, g: 2.0, rod: 0.8}, start[:2], start[2:])
    run = motion.sensitivities([0.0, 1.0, -2.0], [m, g, rod, x, y, u, v], **FINE)
    slopes = run.gradient(DOUBLE.energy)
    size = 1 + np.max(np.abs(run.qdot_by))
    assert slopes == pytest.approx(np.tile(slopes[0], (3, 1)), abs=1e-8 * size)
    assert slopes[0, 0] == pytest.approx(
        motion.integrate(0.0).energy[0] / 1.5, abs=1e-12
    )  # all of it is by mass


# --- Constraints ---------------------------------------------------------------------------------


def test_of_a_bob_by_constraint_as_by_its_angle():
    values, times = {m: 1.5, g: 9.81, rod: 2.0}, np.linspace(-10, 10, 41)
    run = BOB.motion(values, [2 * np.sin(1.0), -2 * np.cos(1.0)]).sensitivities(times, [g, m])
    other = PENDULUM.motion(values, 1.0).sensitivities(times, [g], **FINE)
    angle, by = other.q[:, 0], other.q_by[:, 0, 0]
    known = 2 * np.stack([np.cos(angle) * by, np.sin(angle) * by], axis=1)
    assert run.of(g)[0] == pytest.approx(known, abs=1e-7)
    assert run.of(m)[0] == pytest.approx(np.zeros((41, 2)), abs=1e-12)
    assert np.sum(run.q * run.of(g)[0], axis=1) == pytest.approx(np.zeros(41), abs=1e-7)
    low = BOB.motion(values, [0, -2.0]).sensitivities([1.0], [x, u], **FINE)
    rate = np.sqrt(9.81 / 2)
    assert low.q_by[0] == pytest.approx(
        np.array([[np.cos(rate), np.sin(rate) / rate], [0, 0]]), abs=1e-9
    )


def test_of_a_bob_that_is_brought_back_to_its_circle():
    """Coarsely and for long: without that it would be off by 0.02 and 0.16."""
    values, times = {m: 1.5, g: 9.81, rod: 2.0}, np.linspace(0, 60, 61)
    motion = BOB.motion(values, [2 * np.sin(1.0), -2 * np.cos(1.0)])
    run = motion.sensitivities(times, g, rtol=1e-5, atol=1e-7)
    other = PENDULUM.motion(values, 1.0).sensitivities(times, g, **FINE)
    turned = 2 * np.stack([np.sin(other.q[:, 0]), -np.cos(other.q[:, 0])], axis=1)
    across = 2 * np.stack([np.cos(other.q[:, 0]), np.sin(other.q[:, 0])], axis=1)
    assert run.q == pytest.approx(turned, abs=0.004)
    assert run.of(g)[0] == pytest.approx(across * other.of(g)[0], abs=0.08)


def test_of_a_blade_that_slides_along_itself():
    """ẋ sin θ = ẏ cos θ: θ = wt and x = (v/w) sin wt, by what the blade may do alone."""
    blade = rt.System(
        m * (u**2 + v**2 + w**2) / 2, [x, y, a], [u, v, w], constraints=u * sin(a) - v * cos(a)
    )
    motion = blade.motion({m: 1}, [0, 0, 0], [1, 0, 2])
    run = motion.sensitivities((0, 10), [x, u, w], **FINE)
    late = run.t * np.cos(2 * run.t) / 2 - np.sin(2 * run.t) / 4
    known = np.stack([np.ones(501), np.sin(2 * run.t) / 2, late], axis=1)
    assert run.q_by[:, 0] == pytest.approx(known, abs=1e-8)
    for tied in (v, a):
        with pytest.raises(rt.RigidtopError, match=f"^{tied} can't change alone at the start: "):
            motion.sensitivities(1.0, tied)


# --- What comes out, and what does not -----------------------------------------------------------


def test_it_is_a_table():
    run = DOUBLE.motion({m: 1, g: 9.81, rod: 1}, [0.1, 0.2]).sensitivities((0, 1), ["g", v])
    assert len(run) == 501
    assert run.by == (g, v)
    assert [*run.columns()] == ["t/s", "x_by_g", "x_by_v", "y_by_g", "y_by_v"]
    assert np.array_equal(run["y_by_v"], run.of("v")[0][:, 1])
    assert repr(run).startswith("<Sensitivities: 501 rows, t = 0 … 1 s; t, x_by_g")
    with pytest.raises(rt.RigidtopError, match="no derivatives by x: there are those by g, v"):
        run.of(x)


def test_quantities_are_named_as_they_were_given():
    theta = dynamicsymbols("theta")
    system = rt.System(rod * theta.diff() ** 2 / 2 + g * cos(theta), [theta])
    motion = system.motion({rod: 1, g: 9.81}, 0.5)
    runs = [
        motion.sensitivities(1.0, by)
        for by in (
            [theta, theta.diff()],
            ["theta", "theta_dot"],
            list(system.names.q + system.names.v),
        )
    ]
    assert runs[0] == runs[1] == runs[2]
    assert runs[0].by == (theta, theta.diff())
    assert "theta_by_theta_dot" in runs[0].columns()
    assert motion.sensitivities(1.0, Symbol("g")).by == (g,)  # other assumptions, the same name


def test_units_make_no_difference():
    """An oscillator of 1e-10 m and 1e15/s has the digits that one of 1 m and 1/s has."""
    small = rt.System(m * u**2 / 2 - k * x**2 / 2 - F * x**4, x, u)
    one = small.motion({m: 1, k: 1, F: 0.3}, 0.5, 0.1)
    other = small.motion({m: 1e-26, k: 1e4, F: 0.3e24}, 0.5e-10, 0.1e5)
    run, tiny = one.sensitivities(5.0, [k, x, u]), other.sensitivities(5e-15, [k, x, u])
    scaled = tiny.q_by * [1e4 / 1e-10, 1, 1e15]
    assert scaled == pytest.approx(run.q_by, abs=1e-8)


def test_what_has_a_corner_has_derivatives():
    """A spring that only pushes, and the drag of a fast body; neither jumps."""
    for force in (k * Max(0, -x), -k * Abs(u) * u, k * Abs(x)):
        system, given = rt.System(u**2 / 2, x, u, forces=force), ({k: 1.5}, [0.3], [-0.5])
        run = system.motion(*given).sensitivities(2.0, [k, x, u], **FINE)
        for each in (k, x, u):
            other = by_differences(system, *given, each, [2.0], 2e-3)
            assert np.hstack(run.of(each)) == pytest.approx(other, abs=1e-6)


@pytest.mark.parametrize(
    ("by", "said"),
    [
        ("z", "no derivatives by 'z': the system has g, l, m, x, u"),
        (Symbol("kappa"), "no derivatives by kappa: the system has g, l, m, x, u"),
        (g * rod, "no derivatives by g*l: the system has g, l, m, x, u"),
        ([g, 3], "no derivatives by 3: the system has"),
        (None, "no derivatives by None: the system has"),
        (t, "no derivatives by t: the system has"),
        ([], "derivatives by what? by = a row of parameters and coordinates"),
        ([g, x, "g"], "g stands twice in by"),
    ],
)
def test_what_is_no_quantity_is_refused_in_one_line(by, said):
    with pytest.raises(rt.RigidtopError) as error:
        PENDULUM.motion({m: 1, g: 9.81, rod: 1}, 0.5).sensitivities(1.0, by)
    assert str(error.value).startswith(said)
    assert "\n" not in str(error.value)


def moved(force, given, start):
    return rt.System(u**2 / 2, x, u, forces=force).motion(given, *start)


@pytest.mark.parametrize(
    ("made", "said"),
    [
        (lambda: moved(-k * sign(u), {k: 1}, [1]).sensitivities(1, k), "may jump with sign(u)"),
        (lambda: moved(k * floor(x), {k: 1}, [1]).sensitivities(1, k), "may jump with floor(x)"),
        (lambda: moved(k * Mod(x, 2), {k: 1}, [1]).sensitivities(1, k), "may jump with Mod(x, 2)"),
        (
            lambda: moved(Piecewise((1, t < k), (0, True)), {k: 1}, [1]).sensitivities(1, k),
            "may jump with Piecewise((1, k > t), (0, True))",
        ),
        (
            lambda: moved(sqrt(x), {}, [0.0, 1.0]).sensitivities(1, x),
            "the variational equations can't be computed: ",
        ),
        (lambda: moved(x**3, {}, [1, 1]).sensitivities(9, x), "the integration stopped at t = "),
        (lambda: moved(-x, {}, [1]).sensitivities([np.nan], x), "t must be finite"),
        (lambda: moved(-x, {}, [1]).sensitivities(1, x, "Euler"), "unknown method 'Euler'"),
        (lambda: moved(-x, {}, [1]).sensitivities(1, x, rtol=0), "rtol must be at least"),
        (lambda: moved(-x, {}, [1]).sensitivities(1, x, atol=np.inf), "atol must be finite"),
        (
            lambda: rt.System(u**2 / 2 - k, k, u).motion({}, 1.0).sensitivities(2.0, k),
            "k is declared positive, and does not stay so",
        ),
        (
            lambda: BOB.motion({m: 1, g: 1, rod: 1}, [0.6, -0.8]).sensitivities(1, rod),
            "l can't change alone at the start: the constraint -l**2 + x**2 + y**2 = 0 ties it",
        ),
        (
            lambda: BOB.motion({m: 1, g: 1, rod: 1}, [0.6, -0.8]).sensitivities(1, u),
            "u can't change alone at the start",
        ),
    ],
)
def test_what_has_no_derivatives_is_refused_in_one_line(made, said):
    with pytest.raises(rt.RigidtopError) as error:
        made()
    assert said in str(error.value)
    assert "\n" not in str(error.value)


def test_a_switch_at_a_given_time_is_no_jump_by_other_letters():
    """A push F from t = 0 until t = 1: x = F (t − 1/2) later."""
    run = moved(F * Piecewise((1, t < 1), (0, True)), {F: 2}, [0.0]).sensitivities([1.0, 3.0], F)
    assert run.q_by[:, 0, 0] == pytest.approx([0.5, 2.5], abs=1e-7)
