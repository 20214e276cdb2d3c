"""Taylor series of a system are compiled once, whatever the start and the parameters."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from sympy import cos, sin, symbols

import rigidtop as rt

heyoka = pytest.importorskip("heyoka")

m, length, g, c = symbols("m length g c", positive=True)
theta, w, t = symbols("theta w t", real=True)
ENERGIES = m * length**2 * w**2 / 2, -m * g * length * cos(theta)
NUMBERS = {m: 1, length: 2, g: 9.81}


def test_a_new_start_never_compiles_again(monkeypatch):
    system = rt.System.of_energies(*ENERGIES, theta, w)
    system.motion(NUMBERS, 1.0).integrate(1.0, "taylor")
    monkeypatch.setattr(heyoka, "taylor_adaptive", None)
    for start, rod in ((0.5, 2), (1e-9, 1), (3.0, 0.1)):  # in other units, too
        run = system.motion(NUMBERS | {length: rod}, start).integrate([-3, 0, 3], "taylor")
        assert run.q[1] == start
        assert run.q[0] == pytest.approx(run.q[2], rel=1e-9)
        assert run.drift()["energy"] < 1e-12


def test_work_and_time_start_anew():
    """A damped and driven bob; each motion has its own work and its own time."""
    push = rt.System.of_energies(*ENERGIES, theta, w, forces=sin(t) - c * w)
    first, again = (
        push.motion(NUMBERS | {c: 0.3}, 0.2).integrate([0, 5], "taylor", rtol=1e-14)
        for _ in range(2)
    )
    other = push.motion(NUMBERS | {c: 0.3}, 0.2).integrate([0, 5], rtol=1e-12, atol=1e-13)
    assert np.array_equal(first.q, again.q)
    assert np.array_equal(first.work, again.work)
    assert first.q[-1] == pytest.approx(other.q[-1], abs=1e-10)
    assert first.drift()["energy balance"] < 1e-12


def test_threads_have_integrators_of_their_own():
    system = rt.System.of_energies(*ENERGIES, theta, w)
    starts = np.linspace(0.5, 2.5, 12)

    def end(start):
        return system.motion(NUMBERS, start).integrate(20.0, "taylor").q[0, 0]

    with ThreadPoolExecutor(4) as threads:
        found = list(threads.map(end, starts))
    assert found == [end(start) for start in starts]
