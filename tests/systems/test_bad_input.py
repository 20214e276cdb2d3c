"""What is no system, or no start, is said in one line."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from sympy import (
    Eq,
    Function,
    Matrix,
    Piecewise,
    Rational,
    Symbol,
    cos,
    gamma,
    oo,
    sign,
    sin,
    symbols,
)
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt
from rigidtop.motion import taylor

m, k, length, g = symbols("m k length g", positive=True)
x, y, u, v = symbols("x y u v", real=True)
theta = dynamicsymbols("theta")
SPRING = rt.System(m * u**2 / 2 - k * x**2 / 2, x, u)
BOB = rt.System(
    m * (u**2 + v**2) / 2 - m * g * y, [x, y], [u, v], constraints=x**2 + y**2 - length**2
)
ON_SPHERE = rt.System(
    m * (theta.diff() ** 2 + Function("phi")(theta.args[0]).diff() ** 2 * sin(theta) ** 2),
    [theta, Function("phi")(theta.args[0])],
)
NUMBERS = {m: 1, k: 2}
RUN = SPRING.motion(NUMBERS, 1)
TURN = Rotation.identity()


@pytest.mark.parametrize(
    ("made", "said"),
    [
        (lambda: SPRING.derivation(section=np.zeros(3)), "section must be a text such as"),
        (
            lambda: SPRING.motions(NUMBERS, [[1.0]]).integrate([1], progress=3),
            "progress must be a",
        ),
        (
            lambda: SPRING.fit([0, 1], {x: [0, 1]}, {k: 1}, known={m: 1}, starts=10**400),
            "starts must be at most 1e",
        ),
        (lambda: rt.System("m*u**2/2", [x], [u]), "L must be an expression of SymPy, not 'm"),
        (lambda: rt.System(oo, [x], [u]), "L must be finite"),
        (lambda: rt.System(u**2, [], []), "a system needs a coordinate"),
        (lambda: rt.System(u**2, [x]), "which symbol is the rate of x?"),
        (lambda: rt.System(u**2, [x, y], [u]), "2 coordinates and 1 velocities"),
        (lambda: rt.System(u**2, [x, x], [u, v]), "among the coordinates, x, x, one stands twice"),
        (lambda: rt.System(u**2, [x, y], [u, x]), "x is given as a coordinate and as a velocity"),
        (lambda: rt.System(u**2, [x, theta], [u, v]), "all functions of time, or all plain"),
        (lambda: rt.System(u**2, [x], ["u"]), "'u' is among the velocities"),
        (lambda: rt.System(theta.diff(), [theta], [u]), "u is given as the rate of theta"),
        (lambda: rt.System(theta.diff().diff() * theta, [theta]), "L has an acceleration"),
        (lambda: rt.System(u**2, x, u, forces=[1, 2]), "2 forces for 1 coordinates"),
        (lambda: rt.System(u**2, x, u, forces={y: 2}), "a force on y, which is none of"),
        (lambda: rt.System(u**2, x, u, constraints=u**2), "is not linear in the velocities"),
        (lambda: rt.System(u**2, x, u, constraints=m), "no coordinate and no velocity"),
        (lambda: rt.System(m * u**2, [x, y], [u, v]).accelerations, "L is not quadratic in v"),
        (lambda: rt.System((u + v) ** 2, [x, y], [u, v]).accelerations, "mass matrix is singular"),
        (
            lambda: rt.System(u**2 + v**2, [x, y], [u, v], constraints=[x - y, y - x]).program,
            "the constraints depend on one another",
        ),
        (lambda: SPRING.motion(NUMBERS), r"where does it start\? q = a number for each of x"),
        (lambda: SPRING.motion({m: 1}, 1), "no number for k"),
        (lambda: SPRING.motion({**NUMBERS, g: 1}, 1), "no parameter g: there are k, m"),
        (lambda: SPRING.motion({m: -1, k: 2}, 1), "m must be positive, not -1"),
        (lambda: SPRING.motion({m: 1, k: np.nan}, 1), "k must be finite"),
        (lambda: SPRING.motion([1, 2], 1), "parameters are given as"),
        (lambda: SPRING.motion(NUMBERS, [1, 2]), "q has 2 numbers, for x"),
        (lambda: SPRING.motion(NUMBERS, {y: 2}), "q has y, which is none of x"),
        (lambda: SPRING.motion(NUMBERS, "a"), "x must be a number, not 'a'"),
        (
            lambda: BOB.motion({m: 1, g: 9.81, length: 1}, [1, 0.1]),
            "the constraint .* does not hold at the start: it is 0.01",
        ),
        (
            lambda: BOB.motion({m: 1, g: 9.81, length: 1}, [1, 0], [1, 0]),
            "the rate of the constraint .* does not hold at the start: it is 2",
        ),
        (lambda: ON_SPHERE.motion({m: 1}, [0, 0]), "can't be computed at theta = 0, phi = 0"),
        (lambda: SPRING.motion(NUMBERS, 1).integrate("now"), "t must be a number"),
        (lambda: SPRING.motion(NUMBERS, 1).integrate(1, method="euler"), "unknown method 'euler'"),
        (lambda: SPRING.small({x: 1}), "no steady motion: a force of k is left"),
        (lambda: SPRING.small({}), "gives no value for x"),
        (lambda: SPRING.small(0), "a motion is given as {coordinate: value}, not 0"),
        (
            lambda: SPRING.motion(NUMBERS, 1).integrate(1, events=[x]),
            "events are given as {name: q",
        ),
        (lambda: SPRING.motion(NUMBERS, 1).integrate(1)["y"], "no column 'y': there are t, x, u,"),
        (lambda: SPRING.motion(NUMBERS, 1).integrate(1)[0], "no column 0: there are t, x, u,"),
        (lambda: rt.Mass(m, [1]), "a place has two or three components, not 1"),
        (lambda: rt.Body(m, [1, 2], [0, 0], None), "three principal moments, not 2"),
        (lambda: rt.Body(m, [[1, 2], [2, 1], [0, 0]], [0, 0], None), "a tensor with 3×3 entries"),
        (lambda: rt.Body(m, [[3, 1, 0], [0, 3, 0], [0, 0, 3]], [0, 0], None), "is symmetric"),
        (lambda: rt.Body(m, 3, [0, 0], None), "three principal moments"),
        (lambda: rt.System.of_parts([x], x, u), "a part is a Mass or a Body, not x"),
        (lambda: rt.System.of_parts(x, x, u), "a part is a Mass or a Body, not x"),
        (lambda: rt.Mass(m, TURN), "a place has two or three components, not 1"),
        (lambda: rt.System({x: [1]}, x, u), "L must be an expression of SymPy, not {x"),
        (lambda: rt.System(float, x, u), "L must be an expression of SymPy, not <class"),
        (lambda: rt.System(Matrix([1, 2]), x, u), "L must be an expression of SymPy, not Matrix"),
        (lambda: rt.System(u**2, x, u, forces=1j), "a force must be real, not 1j"),
        (lambda: rt.System(u**2, x, u, forces={TURN: 1}), "a force on Rotation"),
        (lambda: rt.System(u**2, x, u, constraints=None), "a constraint must be an expression"),
        (lambda: rt.DryFriction(u, None, k), "normal of a DryFriction must be an expression"),
        (lambda: SPRING.motion(np.zeros(2), 1), "parameters are given as {symbol: number}, not a"),
        (lambda: SPRING.motion({TURN: 1}, 1), "no parameter Rotation"),
        (lambda: SPRING.motion(NUMBERS, TURN), "x must be a number, not Rotation"),
        (lambda: SPRING.motion(NUMBERS, {TURN: 1}), "q has Rotation"),
        (lambda: SPRING.motions({x: [1, 2]}, 1), "no parameter x: there are k, m"),
        (lambda: RUN.integrate(1, np.zeros(2)), r"unknown method array\(\[0., 0.\]\): DOP853"),
        (lambda: RUN.integrate(1, events=Eq(x, 1)), r"events are given as .*, not Eq\(x, 1\)"),
        (lambda: RUN.integrate(1, until=(x, [1])), r"the direction of until must be a number"),
        (lambda: RUN.integrate(1, until=0.5), "until is 0.5, which no motion changes: give an exp"),
        (lambda: RUN.integrate(1, until=k - 1), "until is k - 1, which no motion changes"),
        (lambda: RUN.section(x, 1, method=np.zeros(2)), "unknown method array"),
        (lambda: RUN.sensitivities(1, TURN), "no derivatives by Rotation"),
        (lambda: RUN.integrate(1)[np.zeros(2)], r"no column array\(\[0., 0.\]\): there are t, x"),
        (lambda: RUN.integrate(1).animate(1.5), "a film is a .gif or an .mp4, not 1.5"),
        (
            lambda: SPRING.fit([0, 1], {5: [0, 1]}),
            "what was measured is 5, which no",
        ),
        (lambda: SPRING.fit([0, 1], {x: [0, 1]}, Eq(x, 1)), "parameters is given as {symbol: val"),
        (lambda: rt.fit([0, 1], [[1, 2, 3]] * 2, misalignment=5), "misalignment must be True or F"),
        (lambda: SPRING.linearise({x: Matrix([1, 2])}), "the value of x must be an expression"),
        (lambda: SPRING.certify(NUMBERS, 0.5), "seed must be a whole number from 0, not 0.5"),
        (lambda: SPRING.source([]), r"no language \[\]: there are python, c"),
        (lambda: SPRING.source("c", 3), "'3' is no name for a function"),
    ],
)
def test_bad_input_is_one_line(made, said):
    with pytest.raises(rt.RigidtopError, match=said) as raised:
        made()
    assert "\n" not in str(raised.value)


def test_what_runs_away_says_so():
    away = rt.System(m * u**2 / 2 + k * x**4, x, u)
    with pytest.raises(rt.RigidtopError, match="the integration stopped at t = "):
        away.motion(NUMBERS, 1).integrate(10)


def test_a_pole_of_a_force_stops_each_solver():
    """LSODA goes on there for ever, by steps of nothing."""
    t = symbols("t")
    at_pole = rt.System(u**2 / 2, x, u, forces=1 / (t - 1)).motion(q=1)
    with pytest.raises(rt.RigidtopError, match="stopped at t = 1 on the way to 3: stuck"):
        at_pole.integrate(3.0, "LSODA", 1e-12, 1e-14)


def test_many_motions_that_get_stuck_say_so():
    dry = rt.System(u**2 / 2, x, u, forces=-k * sign(u)).motions({k: 1}, q=[[0]], qdot=[[0.5]])
    assert dry.way("DOP853") == "DOP853, one after the other"
    with pytest.raises(rt.RigidtopError, match=r"at t = 0.5 .*: stuck; .* is rt.DryFriction"):
        dry.integrate(3.0, "DOP853")


def test_what_no_one_knows_is_neither_conserved_nor_not():
    well = rt.System(m * u**2 / 2 - Function("V")(x), x, u)
    with pytest.raises(rt.RigidtopError, match="neither shown nor refuted"):
        well.is_conserved(u)


def test_an_equation_is_a_constraint_and_numbers_are_forces():
    same = rt.System(u**2 + v**2, [x, y], [u, v], [1, 0], constraints=Eq(x, y))
    assert list(same.accelerations) == [Rational(1, 4), Rational(1, 4)]


def test_a_name_that_is_taken_gets_another():
    """A parameter that is called as the rate of a coordinate would be."""
    thetadot = Symbol("thetadot", positive=True)
    system = rt.System(m * theta.diff() ** 2 / 2 + thetadot * cos(theta), theta)
    assert system.accelerations[0] == -thetadot * sin(theta) / m
    run = system.motion({m: 1, "thetadot": 1}, 0.1).integrate([1.0])
    assert run.drift()["energy"] < 1e-9


def test_a_span_is_no_pair_of_samples():
    run = SPRING.motion(NUMBERS, 1).integrate((0, 10))
    assert len(run.t) == 501
    assert (run.t[0], run.t[-1]) == (0, 10)
    top = rt.HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5).motion(theta=0.5, omega3=40.0)
    assert len(top.exact((0, 10)).t) == 501


def test_methods_agree_and_times_are_of_either_sign():
    at = [-3.0, 0.0, 2.0]
    known = np.cos(np.sqrt(2) * np.array(at))
    for method in ("DOP853", "Radau", "taylor"):
        run = SPRING.motion(NUMBERS, 1).integrate(at, method=method, rtol=1e-11)
        assert np.allclose(run.q[:, 0], known, atol=1e-8)


def test_explicit_time_by_both_solvers():
    t, rate = symbols("t rate")
    driven = rt.System(m * u**2 / 2, x, u, forces=k * cos(rate * t))
    motion = driven.motion({m: 1, k: 2, "rate": 3.0}, 0)
    known = 2 * (1 - np.cos(6.0)) / 9
    for method in ("DOP853", "taylor"):
        run = motion.integrate([2.0], method=method, rtol=1e-12)
        assert abs(run.q[0, 0] - known) < 1e-10
        assert run.drift()["energy balance"] < 1e-10


def test_many_motions_are_the_single_ones():
    stiffness, start = np.array([[1.0], [4.0]]), np.array([0.5, 1.0, 2.0])
    springs = SPRING.motions({m: 1, k: stiffness}, [start])
    assert len(springs) == 6
    places, velocities = springs.integrate([0.3, 1.0])
    assert places.shape == (2, 3, 2, 1)
    rate = np.sqrt(stiffness)
    assert np.allclose(places[..., 1, 0], start * np.cos(rate), atol=1e-8)
    assert np.allclose(velocities[..., 1, 0], -start * rate * np.sin(rate), atol=1e-8)
    assert np.allclose(places[1, 2], springs[5].integrate([0.3, 1.0]).q, atol=1e-8)
    with pytest.raises(rt.RigidtopError, match="these shapes do not broadcast: k"):
        SPRING.motions({m: 1, k: [1, 2]}, [[1, 2, 3]])
    with pytest.raises(rt.RigidtopError, match="q has 2 numbers, for x"):
        SPRING.motions(NUMBERS, [1, 2])
    with pytest.raises(rt.RigidtopError, match="k must be numbers, not 'a'"):
        SPRING.motions({m: 1, k: "a"}, [1])


def test_names_that_are_none_in_python():
    odd, keyword = symbols("m_{1} lambda", positive=True)
    spring = rt.System(odd * u**2 / 2 - keyword * x**2 / 2, x, u)
    run = spring.motion({"m_{1}": 1, "lambda": 4}, 1).integrate([1.0], method="taylor")
    assert run.q[0, 0] == pytest.approx(np.cos(2.0), abs=1e-9)
    assert "double lambda, double m__1_" in spring.source("c")


def test_what_is_not_the_system_s_is_refused():
    run = SPRING.motion(NUMBERS, 1).integrate([1.0])
    with pytest.raises(rt.RigidtopError, match="no number for g: the system has t, x, u, k, m"):
        run.value(g * x)
    with pytest.raises(rt.RigidtopError, match="no number for y"):
        SPRING.motion(NUMBERS, 1).integrate([1.0], events={"there": y})
    with pytest.raises(rt.RigidtopError, match="two different symbols are called m"):
        rt.System(m * u**2 / 2 - Symbol("m") * x, x, u)
    with pytest.raises(rt.RigidtopError, match="tells nothing"):
        BOB.is_conserved(m * (u**2 + v**2) / 2 + m * g * y)


def test_a_swing_that_is_pumped_has_no_frequencies():
    t = symbols("t")
    pumped = rt.System(m * u**2 / 2 - k * (2 + cos(t)) * x**2 / 2, x, u)
    with pytest.raises(rt.RigidtopError, match="change in time by themselves"):
        pumped.small({x: 0})
    free = symbols("free")
    with pytest.raises(rt.RigidtopError, match=r"a force of free\*k is left"):
        SPRING.small({x: free})


def test_many_starts_may_be_arrays_beside_numbers():
    y_, v_ = symbols("y_ v_", real=True)
    plane = rt.System(m * (u**2 + v_**2) / 2 - k * (x**2 + y_**2) / 2, [x, y_], [u, v_])
    many = plane.motions(NUMBERS, q=(np.linspace(0, 1, 5), 0.5), qdot=(0, 0))
    assert many.shape == (5,)
    with pytest.raises(rt.RigidtopError, match="q has 1 numbers, for x, y_"):
        plane.motions(NUMBERS, q=(np.linspace(0, 1, 5),))


@pytest.mark.parametrize(
    ("force", "said"),
    [
        (Piecewise((x, x > 0), (-k, True)), "rates: heyoka's functions have no cases"),
        (gamma(2 + x**2), "rates: heyoka has no gamma"),
        (abs(u), "rates: heyoka has no abs"),
    ],
)
def test_forces_that_taylor_series_do_not_know(force, said):
    pytest.importorskip("heyoka", reason="heyoka has no wheel here")
    moved = rt.System(m * u**2 / 2 - k * x**2 / 2, x, u, forces=[force]).motion(NUMBERS, 1)
    with pytest.raises(rt.RigidtopError) as caught:
        moved.integrate([1.0], method="taylor")
    assert str(caught.value) == said


def test_a_taylor_series_does_not_go_on_for_ever(monkeypatch):
    pytest.importorskip("heyoka", reason="heyoka has no wheel here")
    monkeypatch.setattr(taylor, "MOST_STEPS", 100)
    monkeypatch.setattr(taylor, "STEPS_AT_ONCE", 10)
    with pytest.raises(rt.RigidtopError, match="more than 100 steps on the way to 1000"):
        SPRING.motion(NUMBERS, 1).integrate([1000.0], method="taylor")
