"""Dry friction that sticks: against closed forms, by its energy, and where it is refused."""

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from sympy import cos, sign, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt

m, g, k, mu, mu_s, u, alpha, length, tau = symbols(
    "m g k mu mu_s u alpha length tau", positive=True
)
x, v, y, w, a, t = symbols("x v y w a t", real=True)
FINE = {"rtol": 1e-12, "atol": 1e-14}
FREE = m * v**2 / 2
SPRING = FREE - k * x**2 / 2
BLOCK = rt.System(SPRING, x, v, forces=rt.DryFriction(x, m * g, mu, mu_s))
BELT = rt.System(SPRING, x, v, forces=rt.DryFriction(v - u, m * g, mu, mu_s))
TABLE = {m: 1.3, k: 20, g: 9.81, mu: 0.15, mu_s: 0.2}
SLOW = TABLE | {u: 0.4, mu_s: 0.3}


def swings(start, times):
    """x of a block on a spring that is let go, half a swing after the other, then at rest."""
    omega, band = np.sqrt(20 / 1.3), 0.15 * 1.3 * 9.81 / 20
    found, begin, place = np.full(len(times), np.nan), 0.0, start
    while abs(place) > band * 0.2 / 0.15:
        centre, rows = np.sign(place) * band, times >= begin
        found[rows] = centre + (place - centre) * np.cos(omega * (times[rows] - begin))
        place, begin = 2 * centre - place, begin + np.pi / omega
    found[times >= begin] = place
    return found, begin


@pytest.mark.parametrize("start", [1.0, -0.83, 0.05])
def test_a_block_on_a_spring_swings_about_both_centres_and_stays(start):
    times = np.linspace(0, 40, 4001)
    run = BLOCK.motion(TABLE, start).integrate(times, **FINE)
    expected, end = swings(start, times)
    assert np.max(np.abs(run.q[:, 0] - expected)) < 1e-9
    rest = times > end + 1e-9
    assert rest.any()
    assert not run.slip[rest].any()
    assert np.all(run.slip[(times > 0) & (times < end - 1e-9)] != 0)
    assert not run.qdot[rest].any()
    assert not run.accelerations[rest].any()
    assert np.allclose(run.friction[rest], 20 * run.q[rest, 0], rtol=1e-14)
    assert np.all(np.abs(run.friction[rest]) <= 0.2 * 1.3 * 9.81)
    assert run.drift()["energy balance"] < 1e-10


@pytest.mark.parametrize("method", ["DOP853", "taylor"])
def test_a_block_on_a_belt_sticks_and_slips_by_turns(method):
    omega, pressed = np.sqrt(20 / 1.3), 1.3 * 9.81
    loose, centre = 0.3 * pressed / 20, 0.15 * pressed / 20
    slips = 2 / omega * (np.pi - np.arctan((loose - centre) * omega / 0.4))
    sticks = 2 * (loose - centre) / 0.4
    times = np.linspace(0, 3 * (slips + sticks), 1001)
    events = {"caught": (v - u, 0)}
    run = BELT.motion(SLOW, 2 * centre - loose, 0.4).integrate(times, method, events=events, **FINE)
    phase = times % (slips + sticks)
    late = phase - sticks
    slipping = centre + (loose - centre) * np.cos(omega * late) + 0.4 / omega * np.sin(omega * late)
    expected = np.where(late < 0, 2 * centre - loose + 0.4 * phase, slipping)
    assert np.max(np.abs(run.q[:, 0] - expected)) < 1e-8
    clear = np.abs(late) > 1e-6
    assert np.array_equal(run.slip[clear][1:-1], np.where(late < 0, 0, -1)[clear][1:-1])
    assert np.all(run.qdot[run.slip == 0] == 0.4)
    caught = (slips + sticks) * np.array([1, 2])
    assert np.max(np.abs(run.crossings["caught"].t[:2] - caught)) < 1e-8
    assert run.drift()["energy balance"] < 1e-9


def gauss(edges):
    """Times between edges, and the weights of an integral over them."""
    nodes, weights = np.polynomial.legendre.leggauss(24)
    half = np.diff(edges)[:, None] / 2
    return (edges[:-1, None] + half * (1 + nodes)).ravel(), (half * weights).ravel()


def test_the_energy_that_is_lost_is_what_friction_takes():
    """Where the table presses more the further out; and on a belt, that pulls too."""
    rough = rt.DryFriction(x, m * g * (1 + x**2), mu, mu_s)
    block = rt.System(SPRING, x, v, forces=[rough]).motion(TABLE, 1.0)
    belt = BELT.motion(SLOW, 0.05, 0.4)
    for motion, turns in ((block, v), (belt, v - u)):
        seen = motion.integrate([0, 9], events={"turns": turns}, **FINE)
        end = seen.events["turns"][3]
        edges = np.array([0, *seen.events["turns"][:4]])
        if motion is belt:  # which lets go between
            loose = motion.integrate([0, 9], events={"loose": (k * x - mu_s * m * g, 1)}, **FINE)
            edges = np.unique([*edges, *loose.events["loose"][loose.events["loose"] < end]])
        times, weights = gauss(edges)
        run = motion.integrate([*times, end], **FINE)
        work = np.sum(weights * (run.friction * run.qdot[:, 0])[:-1])
        assert abs(run.energy[-1] - seen.energy[0] - work) < 1e-8
        assert abs(run.work[-1] - work) < 1e-8
        assert abs(work) > 0.01


def test_a_pendulum_comes_to_rest_within_the_band_of_its_hinge():
    pendulum = rt.System(
        m * length**2 * v**2 / 2 + m * g * length * cos(x), x, v, forces=rt.DryFriction(x, tau, 1)
    )
    numbers = {m: 0.7, length: 0.5, g: 9.81, tau: 0.2}
    run = pendulum.motion(numbers, 2.5, 1.0).integrate((0, 60), **FINE)
    assert run.slip[-1] == 0
    assert not run.qdot[-20:].any()
    assert abs(0.7 * 9.81 * 0.5 * np.sin(run.q[-1, 0])) <= 0.2
    assert np.ptp(run.q[-20:, 0]) == 0
    assert run.drift()["energy balance"] < 1e-10


@settings(max_examples=25, deadline=None)
@example(start=0.0, speed=1e-190, kinetic=0.5, more=0.0)
@given(
    start=st.floats(-2, 2),
    speed=st.floats(-3, 3),
    kinetic=st.floats(0.01, 0.5),
    more=st.floats(0, 0.3),
)
def test_no_energy_comes_from_a_table_at_rest(start, speed, kinetic, more):
    numbers = TABLE | {mu: kinetic, mu_s: kinetic + more}
    run = BLOCK.motion(numbers, start, speed).integrate((0, 10))
    assert np.max(np.diff(run.energy)) < 1e-8 * max(run.energy[0], 1e-3)
    held = run.slip == 0
    assert np.all(np.abs(run.friction[held]) <= (kinetic + more) * 1.3 * 9.81 * (1 + 1e-9))
    assert np.all(run.friction[~held] * run.slip[~held] < 0)


@pytest.mark.parametrize("static", [0.2, 0.35])
def test_a_force_that_grows_tears_it_loose(static):
    """Also where it lets go without a jerk, μₛ = μ, and where the time enters."""
    block = rt.System(FREE, x, v, forces=[a * t, rt.DryFriction(x, m * g, mu, mu_s)])
    times = np.linspace(0, 8, 81)
    run = block.motion({m: 2, g: 10, a: 1, mu: 0.2, mu_s: static}, 1.0).integrate(times, **FINE)
    loose = 20 * static
    later = np.maximum(times - loose, 0)
    expected = 1 + (later**3 / 6 + (loose - 4) * later**2 / 2) / 2
    assert np.max(np.abs(run.q[:, 0] - expected)) < 1e-9
    clear = np.abs(times - loose) > 1e-9
    assert np.array_equal(run.slip[clear], (times > loose).astype(int)[clear])


def test_what_holds_only_just_is_torn_loose_at_once():
    force = [mu * m * g + a * t, rt.DryFriction(x, m * g, mu)]
    just = rt.System(FREE, x, v, forces=force).motion({m: 2, g: 10, a: 1, mu: 0.2}, 0)
    run = just.integrate((0, 3), **FINE)
    assert np.max(np.abs(run.q[:, 0] - run.t**3 / 12)) < 1e-9
    assert run.slip[1:].all()


def test_a_belt_that_shakes_and_one_block_on_another():
    """A light belt takes the block along while u̇ is within μg; two blocks end with one velocity."""
    shaken = rt.System(FREE, x, v, forces=rt.DryFriction(v - u * cos(t), m * g, mu))
    run = shaken.motion({m: 1, g: 10, mu: 0.2, u: 1.9}, 0, 1.9).integrate((0, 20), **FINE)
    assert not run.slip.any()
    assert np.max(np.abs(run.q[:, 0] - 1.9 * np.sin(run.t))) < 1e-9
    run = shaken.motion({m: 1, g: 10, mu: 0.2, u: 3}, 0, 3).integrate((0, 20), **FINE)
    assert set(run.slip) == {-1, 0, 1}
    pair = rt.System(
        m * v**2 / 2 + 3 * m * w**2 / 2, [x, y], [v, w], forces=rt.DryFriction(x - y, m * g, mu)
    )
    run = pair.motion({m: 1, g: 10, mu: 0.2}, [0, 0], [4, 0]).integrate([0, 1, 1.5, 2, 9], **FINE)
    assert np.allclose(run.qdot, [[4, 0], [2, 2 / 3], [1, 1], [1, 1], [1, 1]], rtol=0, atol=1e-12)
    assert np.allclose(run.q[:, 0] - run.q[:, 1], [0, 8 / 3, 3, 3, 3], rtol=0, atol=1e-10)
    assert abs(run.work[-1] + 6) < 1e-9


def test_a_slope_holds_a_block_up_to_its_angle():
    slope = rt.System(
        FREE - m * g * x * sin(alpha), x, v, forces=rt.DryFriction(v, m * g * cos(alpha), mu)
    )
    numbers = {m: 1, g: 10, mu: 0.5}
    still = slope.motion(numbers | {alpha: np.arctan(0.499)}, 0).integrate([0, 5])
    assert still.q.tolist() == [[0], [0]]
    assert still.slip.tolist() == [0, 0]
    steep = slope.motion(numbers | {alpha: np.arctan(0.501)}, 0)
    assert steep.integrate(0).slip.tolist() == [-1]
    down = slope.motion(numbers | {alpha: np.arctan(0.75)}, 0).integrate([2], **FINE)
    assert abs(down.q[0, 0] + 2 * 10 * (0.6 - 0.4)) < 1e-9
    up = slope.motion(numbers | {alpha: np.arctan(0.4)}, 0, 3.0).integrate((0, 3), **FINE)
    assert abs(up.q[-1, 0] - 9 / 2 / (10 * 0.9 / np.sqrt(1.16))) < 1e-9


def test_friction_joins_constraints_and_functions_of_time():
    X, Y = dynamicsymbols("X Y")
    wire = rt.System(
        m * (X.diff() ** 2 + Y.diff() ** 2) / 2 - m * g * Y,
        [X, Y],
        forces=[0, 0, rt.DryFriction(X.diff(), m * g, mu)],
        constraints=Y - X,
    )
    assert "sign(Derivative(X(t), t))" in str(wire.equations[0])
    run = wire.motion({m: 1, g: 10, mu: 0.2}, [0, 0], [2, 2]).integrate((0, 3), **FINE)
    assert np.max(np.abs(run.q[:, 0] - run.q[:, 1])) < 1e-14
    rising = run.t < 1 / 3
    assert np.max(np.abs(run.q[:, 0] - 2 * run.t + 3 * run.t**2)[rising]) < 1e-10
    top, later = 1 / 3, run.t[~rising] - 1 / 3
    assert np.max(np.abs(run.q[~rising, 0] - top + 2 * later**2)) < 1e-9
    assert run.multipliers.shape == (501, 1)


STUCK = rt.System(SPRING, x, v, forces=-mu * m * g * sign(v))


@pytest.mark.parametrize(
    ("made", "message"),
    [
        (lambda: BLOCK.source("c"), "a source file can't have a DryFriction"),
        (lambda: BLOCK.motions(TABLE, [1, 2]), r"take motion\(…\) for one start after the other"),
        (lambda: BLOCK.linearise({x: 0}), "a linearisation can't have a DryFriction"),
        (lambda: BLOCK.equilibria(), "it rests within a band"),
        (lambda: BLOCK.motion(TABLE, 1).lyapunov(9), "a Lyapunov exponent can't have"),
        (lambda: BLOCK.motion(TABLE, 1).sensitivities(9, x), "derivatives of a motion can't have"),
        (lambda: BLOCK.motion(TABLE, 1).integrate([-1, 1]), "give times t ≥ 0"),
        (lambda: BLOCK.motion(TABLE | {mu: 1}, 1).integrate(1), "mu_static is less than mu"),
        (
            lambda: rt.System(SPRING, x, v, forces=[rt.DryFriction(x, 1, mu)] * 2),
            "2 dry frictions: a system has one",
        ),
        (lambda: rt.System(SPRING, x, v, forces={x: rt.DryFriction(x, 1, mu)}), "a list with"),
        (lambda: rt.System(SPRING, x, v, forces=rt.DryFriction(v**2, 1, mu)), r"not of v\*\*2"),
        (lambda: rt.System(SPRING, x, v, forces=rt.DryFriction(k, 1, mu)), "not of k"),
        (lambda: rt.DryFriction(x, -1, mu), "normal of a DryFriction is -1: it can't be negative"),
        (
            lambda: (
                rt.System(FREE, x, v, forces=rt.DryFriction(x, 1 - x, mu))
                .motion({m: 1, mu: 0.1}, 0, 5)
                .integrate(2)
            ),
            "can't be negative, the contact is lost there",
        ),
        (
            lambda: STUCK.motion({m: 1, k: 4, g: 9.81, mu: 0.1}, 1).integrate(10),
            "stopped at t = 3.14.*: stuck; .*friction that sticks is rt.DryFriction",
        ),
        (
            lambda: rt.System(SPRING, x, v).motion({m: 1, k: 4}, 1).integrate(1).friction,
            "the system has no DryFriction",
        ),
    ],
)
def test_what_can_t_be_is_told_in_one_line(made, message):
    with pytest.raises(rt.RigidtopError, match=message) as error:
        made()
    assert len(str(error.value).splitlines()) == 1


def test_without_friction_it_slides_to_and_fro():
    free = rt.System(SPRING, x, v, forces=rt.DryFriction(x, m * g, a))
    run = free.motion({m: 1, k: 4, g: 10, a: 0}, 1.0).integrate((0, 10), **FINE)
    assert np.max(np.abs(run.q[:, 0] - np.cos(2 * run.t))) < 1e-9
    clear = np.abs(run.qdot[:, 0]) > 1e-9
    assert np.array_equal(run.slip[clear], np.sign(run.qdot[clear, 0]))
