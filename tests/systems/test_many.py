"""Many motions of a system at once are the single ones."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from sympy import Piecewise, cos, sin, symbols

import rigidtop as rt
from rigidtop.motion import abreast, taylor
from rigidtop.motion.integrate import Accuracy

m, length, g, c = symbols("m length g c", positive=True)
theta, phi, w, u, t = symbols("theta phi w u t", real=True)
PENDULUM = rt.System.of_energies(m * length**2 * w**2 / 2, -m * g * length * cos(theta), theta, w)
DOUBLE = rt.System.of_parts(
    [
        rt.Mass(m, [length * sin(theta), -length * cos(theta)]),
        rt.Mass(m, [length * (sin(theta) + sin(phi)), -length * (cos(theta) + cos(phi))]),
    ],
    [theta, phi],
    [w, u],
    gravity=[0, -g],
)
NUMBERS = {m: 1, length: 1, g: 9.81}


@pytest.fixture(params=["taylor", "DOP853"])
def method(request):
    if request.param == "taylor":
        pytest.importorskip("heyoka", reason="heyoka has no wheel here")
    return request.param


def one_by_one(motions, *arguments, **more):
    runs = [each.integrate(*arguments, **more) for each in motions]
    return np.stack([[run.q for run in runs], [run.qdot for run in runs]])


def test_starts_and_parameters_of_their_own(method):
    """On both sides of t = 0, in any order, twice the same time, and 13 fill no batch."""
    random = np.random.default_rng(3)
    motions = DOUBLE.motions(
        {m: 1, length: random.uniform(0.5, 2, 13), g: 9.81},
        q=random.uniform(-1, 1, (2, 13)),
        qdot=random.uniform(-1, 1, (2, 13)),
    )
    times = [2.0, -1.5, 0.0, 0.3, 0.3, -0.1]
    found = motions.integrate(times, method, rtol=1e-12, atol=1e-13)
    alone = one_by_one(motions, times, method, 1e-12, 1e-13)
    assert found.shape == (2, 13, 6, 2)
    assert np.abs(found - alone).max() < 1e-9
    assert pytest.approx(motions.q, rel=1e-15) == found[0, :, 2].T


def test_work_and_time(method):
    driven = rt.System.of_energies(
        m * length**2 * w**2 / 2, -m * g * length * cos(theta), theta, w, forces=sin(t) - c * w
    )
    motions = driven.motions(NUMBERS | {c: [0.1, 0.3, 0.9]}, [[0.2]], [[0.5]])
    found = motions.integrate([3, -2], method)
    assert np.abs(found - one_by_one(motions, [3, -2], method)).max() < 1e-8


def test_small_motions_are_as_accurate(method):
    """Relative to themselves; that which starts in the middle needs a finer tolerance later."""
    motions = PENDULUM.motions(NUMBERS, [[1e-9, 0.0]], [[0.0, 1e-7]])
    found = motions.integrate([1.0, 2.0], method)
    rate = np.sqrt(9.81)
    exact = [1e-9 * np.cos(rate * 2), 1e-7 * np.sin(rate * 2) / rate]
    assert found[0, :, 1, 0] == pytest.approx(exact, rel=1e-7)
    assert np.array_equal(found[0, 1], motions[1].integrate([1.0, 2.0], method).q)


def test_steps_are_those_of_scipy():
    """Also the number of evaluations, so that no step is shorter than it need be."""
    calls = [0]

    def rates(states, which):
        calls[0] += 1
        return np.stack([states[1], -np.sin(states[0])])

    def ones(states):
        return np.ones(states.shape)

    times = np.linspace(0, 20, 300)
    problems = abreast.InitialValueProblems(
        rates, ones, lambda states: np.ones(states.shape[1], dtype=bool)
    )
    found = abreast.states(
        problems, np.array([[1.0], [0.5]]), times, Accuracy("DOP853", 1e-9, 1e-11)
    )
    own = calls[0]
    scipy = solve_ivp(
        lambda _, x: [x[1], -np.sin(x[0])],
        (0, 20),
        [1.0, 0.5],
        "DOP853",
        times,
        rtol=1e-9,
        atol=1e-11,
        dense_output=True,
    )
    assert np.abs(found[:, :, 0].T - scipy.y).max() < 1e-12
    assert scipy.nfev - own == 3  # SciPy looks also within a step in which there is no time


def test_rounding_drives_no_steps_to_nothing():
    """What has been 1e-12 comes to 1, and then rounding is larger than the first tolerance."""

    def rates(states, which):
        a, b, v, w = states
        return np.stack([v, w, np.sin(a), np.sin(a) ** 2 + np.cos(a) ** 2 - 1 - b])

    def largest(states):
        return np.abs(states).max(axis=0, initial=1e-300) * np.ones(states.shape)

    problems = abreast.InitialValueProblems(
        rates, largest, lambda states: np.ones(states.shape[1], dtype=bool)
    )
    start = np.array([[1e-12], [0.0], [1e-12], [0.0]])
    [end] = abreast.states(problems, start, np.array([35.0]), Accuracy())
    assert abs(end[2, 0] ** 2 / 2 + np.cos(end[0, 0]) - 1) < 1e-8


def test_how_it_goes_is_said(method):
    heyoka = method == "taylor"
    motions = PENDULUM.motions(NUMBERS, [[0.1, 0.2]])
    said = f"taylor in batches of {taylor.batch()}" if heyoka else "DOP853 on arrays of 2048"
    assert motions.way(method) == said
    assert motions.way("LSODA") == "LSODA, one after the other"
    rod = rt.System(
        m * (w**2 + u**2) / 2, [theta, phi], [w, u], constraints=theta**2 + phi**2 - length**2
    ).motions({m: 1, length: 1}, [[1.0, 1.0], [0.0, 0.0]], [[0.0, 0.0], [1.0, 2.0]])
    assert rod.way(method) == f"{method}, one after the other"
    found = rod.integrate(1.0, method)
    assert found[0, :, 0, 0] == pytest.approx(np.cos([1.0, 2.0]), abs=1e-8)


def test_without_heyoka_and_where_it_has_no_function(monkeypatch):
    """Then they go on arrays, with the same results."""
    cases = rt.System(w**2 / 2, theta, w, forces=Piecewise((-theta, theta > 0), (-4 * theta, True)))
    assert cases.motions(q=[[1.0]]).way() == "DOP853 on arrays of 2048"
    fresh = rt.System(w**2 / 2 - theta**2 / 2, theta, w)

    def missing():
        raise rt.RigidtopError("no heyoka")

    monkeypatch.setattr(taylor, "loaded", missing)
    motions = fresh.motions(q=[[1.0, 2.0]])
    assert motions.way() == "DOP853 on arrays of 2048"
    assert motions.integrate(1.0)[0, :, 0, 0] == pytest.approx(np.cos(1.0) * motions.q[0], abs=1e-9)


def test_which_does_not_arrive(method):
    """One whose force is infinite on the way is told as it is alone; others would have come."""
    pulled = rt.System(w**2 / 2 + 1 / theta**2, theta, w)
    motions = pulled.motions(q=[[3.0, 0.5]])
    with pytest.raises(rt.RigidtopError) as alone:
        motions[1].integrate(2.0, method)
    with pytest.raises(rt.RigidtopError) as together:
        motions.integrate(2.0, method)
    assert str(together.value) == str(alone.value)


def test_a_coordinate_that_was_declared_positive(method):
    r = symbols("r", positive=True)
    free = rt.System(w**2 / 2 + r, r, w)
    motions = free.motions(q=[[1.0, 1.0]], qdot=[[0.0, -2.0]])
    with pytest.raises(rt.RigidtopError, match="r is declared positive, and does not stay so"):
        motions.integrate(2.0, method)


def test_what_cannot_start():
    with pytest.raises(rt.RigidtopError, match="m must be positive, not -1"):
        PENDULUM.motions(NUMBERS | {m: [1, -1, 2]}, [[1, 2, 3]])
    with pytest.raises(rt.RigidtopError, match="no number for g"):
        PENDULUM.motions({m: 1, length: 1}, [[1, 2, 3]])
    even = symbols("n", even=True)
    with pytest.raises(rt.RigidtopError, match="n must be even, not 3"):
        rt.System(w**2 / 2 - even * theta**2, theta, w).motions({even: [2, 3, 4]}, [1.0])
    pulled = rt.System(w**2 / 2 + 1 / theta**2, theta, w)
    with pytest.raises(rt.RigidtopError, match="can't be computed at theta = 0: "):
        pulled.motions(q=[[1.0, 0.0]])
    with pytest.raises(rt.RigidtopError, match="there are no motions"):
        PENDULUM.motions(NUMBERS, [[]]).integrate(1.0)


def test_it_is_a_sequence(method):
    motions = PENDULUM.motions(NUMBERS, [np.array([[0.1, 0.2], [0.3, 0.4]])])
    assert motions.integrate([0, 1], method).shape == (2, 2, 2, 2, 1)
    assert [each.q[0] for each in motions] == [0.1, 0.2, 0.3, 0.4]
    assert [each.q[0] for each in motions[1:3]] == [0.2, 0.3]
    told = []
    motions.integrate(1.0, method, progress=lambda done, of: told.append((done, of)))
    assert told[-1] == (4, 4)
