"""The largest Lyapunov exponent, where it is known and against neighbours that are integrated."""

import numpy as np
import pytest
from sympy import cos, sin, sinh, sqrt, symbols

import rigidtop as rt
from rigidtop.system.lyapunov import beginning

x, y, u, v, t = symbols("x y u v t", real=True)
k, g, m = symbols("k g m", positive=True)
HILL = rt.System(u**2 / 2 + k**2 * x**2 / 2, x, u)
STARS = rt.System((u**2 + v**2) / 2 - (x**2 + y**2) / 2 - x**2 * y + y**3 / 3, [x, y], [u, v])
DOUBLE = rt.System.of_parts(
    [rt.Mass(m, [sin(x), -cos(x)]), rt.Mass(m, [sin(x) + sin(y), -cos(x) - cos(y)])],
    [x, y],
    [u, v],
    gravity=[0, -g],
)


@pytest.fixture(params=["taylor", "DOP853"])
def method(request):
    if request.param == "taylor":
        pytest.importorskip("heyoka", reason="heyoka has no wheel here")
    return request.param


def test_a_saddle_has_its_rate(method):
    """Also a fast one, whose neighbours go apart by e^3000."""
    for rate in (0.7, 30.0):
        found = HILL.motion({k: rate}, 0.0, 0.0).lyapunov(100.0, method)
        assert found.value == pytest.approx(rate, abs=0.05)
        assert found.growth[-1] - found.growth[249] == pytest.approx(rate * 50, rel=1e-8)
        assert abs(found.value - rate) < 2 * found.error


def test_a_damped_motion_has_a_negative_one(method):
    """ẍ = −3x − 4ẋ + sin t: the slower of the rates −1 and −3."""
    damped = rt.System(u**2 / 2 - 3 * x**2 / 2, x, u, forces=sin(t) - 4 * u)
    found = damped.motion({}, 1.0).lyapunov(50.0, method)
    assert (found.growth[-1] - found.growth[249]) / 25 == pytest.approx(-1, abs=1e-8)


def test_growth_is_that_of_a_neighbour(method):
    """Of 1e-7 beside it, which goes on by itself."""
    numbers, start = {m: 1, g: 9.81}, np.array([2.0, 1.0, 0.0, 0.5])
    motion = DOUBLE.motion(numbers, start[:2], start[2:])
    found = motion.lyapunov(5.0, method)
    state, rate = beginning(motion.system, motion.parameters, start)
    away = 1e-7 * state[4:8] * [1, 1, rate, rate]
    ends = [
        DOUBLE.motion(numbers, (start + s * away)[:2], (start + s * away)[2:]).integrate(
            5.0, "DOP853", 1e-13, 1e-15
        )
        for s in (1, -1)
    ]
    apart = [ends[0].q - ends[1].q, (ends[0].qdot - ends[1].qdot) / rate]
    size = np.linalg.norm(apart) / 2e-7
    assert found.growth[-1] == pytest.approx(np.log(size), abs=1e-5)


def test_regular_and_chaotic_motions_differ():
    """Of the stars with low and with high energy: the first does not show chaos."""
    regular = STARS.motion(q=[0, 0.1], qdot=[0.1, 0.0]).lyapunov(2000.0)
    assert 0 < regular.value < 0.01
    assert regular.value < 3 * regular.error
    chaotic = STARS.motion(q=[0, -0.15], qdot=[0.54, 0.0]).lyapunov(2000.0)
    assert chaotic.value > max(0.03, 5 * chaotic.error)


def test_it_is_a_table():
    found = HILL.motion({k: 1}, 0.0).lyapunov(10.0, "DOP853")
    assert len(found) == 500
    assert found["exponent"][-1] == found.value
    assert repr(found).startswith("<LyapunovExponent: ")
    assert len(found.plot().lines) == 1


def test_a_new_start_never_compiles_again(monkeypatch):
    heyoka = pytest.importorskip("heyoka", reason="heyoka has no wheel here")
    motion = HILL.motion({k: 1}, 0.0)
    first = motion.lyapunov(10.0, "taylor")
    monkeypatch.setattr(heyoka, "taylor_adaptive", None)
    assert np.array_equal(motion.lyapunov(10.0, "taylor").growth, first.growth)
    assert HILL.motion({k: 2}, 0.1).lyapunov(20.0, "taylor").value == pytest.approx(2, abs=0.2)


@pytest.mark.parametrize(
    ("made", "said"),
    [
        (lambda: HILL.motion({k: 1}, 0.0).lyapunov(-1.0), "of a time t > 0, not -1"),
        (
            lambda: (
                rt.System((u**2 + v**2) / 2, [x, y], [u, v], constraints=x - y)
                .motion({}, [1, 1])
                .lyapunov(1.0)
            ),
            "an exponent wants independent coordinates",
        ),
        (
            lambda: rt.System(u**2 / 2 + sinh(x), x, u).motion({}, 1.0).lyapunov(99.0, "DOP853"),
            "the integration stopped at t = 1.84",
        ),
        (
            lambda: rt.System(u**2 / 2 - k, k, u).motion({}, 1.0).lyapunov(2.0),
            "k is declared positive, and does not stay so",
        ),
        (
            lambda: rt.System(u**2 / 2, x, u, forces=sqrt(x)).motion({}, 0.0, 1.0).lyapunov(1.0),
            "the variational equations can't be computed: ",
        ),
    ],
)
def test_what_has_none(made, said):
    with pytest.raises(rt.RigidtopError) as error:
        made()
    assert said in str(error.value)
