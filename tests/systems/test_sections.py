"""Poincaré's sections, and events with states and directions."""

import matplotlib
import numpy as np
import pytest
from sympy import Eq, cos, sin, symbols

import rigidtop as rt

x, y, u, v, t = symbols("x y u v t", real=True)
k = symbols("k", positive=True)
SPRING = rt.System(u**2 / 2 - k * x**2 / 2, x, u)
STARS = rt.System((u**2 + v**2) / 2 - (x**2 + y**2) / 2 - x**2 * y + y**3 / 3, [x, y], [u, v])


@pytest.fixture(params=["taylor", "DOP853"])
def method(request):
    if request.param == "taylor":
        pytest.importorskip("heyoka", reason="heyoka has no wheel here")
    return request.param


def test_times_states_and_directions(method):
    motion = SPRING.motion({k: 4}, 1.0)  # cos 2t
    found = motion.section(Eq(x, 0.5), 7.0, method=method)
    turns = np.arange(3) * np.pi
    known = np.sort(np.concatenate([turns + np.pi / 6, turns[1:] - np.pi / 6]))
    assert found.t == pytest.approx(known[known < 7], abs=1e-11)
    assert found.q[:, 0] == pytest.approx(0.5, abs=1e-11)
    assert found.qdot[:, 0] == pytest.approx(-2 * np.sin(2 * found.t), abs=1e-10)
    assert np.array_equal(found.rising, found.qdot[:, 0] > 0)
    for direction in (1, -1):
        one = motion.section(x - 0.5, 7.0, direction, method)
        assert np.array_equal(one.t, found.t[found.rising == (direction > 0)])


def test_backwards_in_time_directions_are_those_of_time(method):
    found = SPRING.motion({k: 1}, 1.0).section(x, (-5.0, 5.0), direction=1, method=method)
    assert found.t == pytest.approx([-np.pi / 2, 1.5 * np.pi], abs=1e-10)
    assert found.qdot[:, 0] == pytest.approx(1.0, abs=1e-10)


def test_a_section_in_time_of_a_driven_motion(method):
    """Once in each period of the force, as for Duffing's oscillator: ẍ = −4x + sin t."""
    driven = rt.System(u**2 / 2 - 2 * x**2, x, u, forces=sin(t))
    found = driven.motion({}, 0.0, 1 / 3).section(sin(t / 2), 20.0, method=method)
    assert found.t == pytest.approx(2 * np.pi * np.arange(1, 4), abs=1e-10)
    assert found.qdot[:, 0] == pytest.approx(1 / 3, abs=1e-9)  # x = sin t / 3


def test_a_section_of_henon_and_heiles():
    """Both ways come to the same points, which have the energy and lie on the section."""
    motion = STARS.motion(q=[0, 0.1], qdot=[0.49, 0.0])
    by_steps = motion.section(x, 100.0, 1, "DOP853")
    found = motion.section(x, 100.0, 1)
    assert len(found) == len(by_steps) > 10
    assert np.abs(found.q - by_steps.q).max() < 1e-8
    assert np.abs(found.q[:, 0]).max() < 1e-12
    assert found.drift()["energy"] < 1e-12
    assert np.all(found.qdot[:, 0] > 0)


def test_constraints_hold_on_a_section(method):
    g, length = symbols("g length", positive=True)
    bob = rt.System((u**2 + v**2) / 2 - g * y, [x, y], [u, v], constraints=x**2 + y**2 - length**2)
    found = bob.motion({g: 9.81, length: 1}, [1, 0]).section(x, 10.0, method=method)
    assert len(found) == 8
    assert np.abs(np.hypot(*found.q.T) - 1).max() < 1e-13
    assert found.q[:, 1] == pytest.approx(-1, abs=1e-12)


def test_work_at_a_section():
    dragged = rt.System(u**2 / 2 - x**2 / 2, x, u, forces=-u / 10)
    found = dragged.motion({}, 1.0).section(x, 10.0, method="DOP853")
    assert found.drift()["energy balance"] < 1e-11


def test_events_have_states_and_directions(method):
    motion = SPRING.motion({k: 1}, 1.0)
    run = motion.integrate(
        (0, 10), method, events={"through": x, "up": (x, 1), "turns": u}, until=(x, 1)
    )
    assert run.ended == pytest.approx(1.5 * np.pi, abs=1e-9)
    assert run.crossings["through"].t == pytest.approx([np.pi / 2, 1.5 * np.pi], abs=1e-9)
    assert run.crossings["up"].t == pytest.approx([1.5 * np.pi], abs=1e-9)
    assert run.crossings["turns"].q[:, 0] == pytest.approx([-1], abs=1e-9)
    assert run.events["turns"] == pytest.approx([np.pi], abs=1e-9)
    assert run.t[-1] < run.ended


def test_a_section_is_drawn_as_dots():
    found = STARS.motion(q=[0, 0.1], qdot=[0.49, 0.0]).section(x, 50.0, 1, "DOP853")
    axes = found.plot()
    assert isinstance(axes, matplotlib.axes.Axes)
    [dots] = axes.lines
    assert dots.get_linestyle() == "None"
    assert np.array_equal(dots.get_xydata(), np.stack([found.q[:, 1], found.qdot[:, 1]], axis=1))
    assert found["x"] == pytest.approx(0, abs=1e-12)
    assert found.plot(("x", "u"), axes=axes) is axes


def test_no_crossing_is_an_empty_section(method):
    found = SPRING.motion({k: 1}, 1.0).section(x - 2, 10.0, method=method)
    assert len(found) == 0
    assert found.q.shape == (0, 1)
    assert repr(found) == "<SystemSection: 0 rows, no times; t, x, u, energy>"


@pytest.mark.parametrize(
    ("asked", "said"),
    [
        ((x, 1.0, 2), "the direction of the event section is +1, −1 or 0, not 2"),
        (("x", 1.0), "the event section must be an expression of SymPy, not 'x'"),
        ((y, 1.0), "no number for y: the system has t, x, u, k"),
        ((x, "a"), "t must be a number or an array of numbers, not 'a'"),
        ((cos(x) / (x - x.subs(x, 1.0)), 1.0), "the event section can't be computed at t = 0"),
    ],
)
def test_what_is_no_section(asked, said):
    with pytest.raises(rt.RigidtopError) as error:
        SPRING.motion({k: 1}, 1.0).section(*asked)
    assert said in str(error.value)
