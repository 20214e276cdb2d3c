"""The closed forms compiled by Numba: judged as those of NumPy, and the same but for rounding."""

import math
import sys

import judge
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rigidtop import FreeBody, HeavyBody, HeavyTop
from rigidtop.errors import RigidtopError
from rigidtop.motion.exact import compiled
from rigidtop.motion.exact.numbers import cubic
from rigidtop.trace import loaded

TOP = HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5)
NAMES = ("theta", "phi", "psi", "theta_dot", "phi_dot", "psi_dot", "quaternion", "omega")


def function(name, count=1):
    """As floats of Python."""
    kit = compiled.Sums()
    found = getattr(kit, name)(*(kit.value(f"x[{k}]") for k in range(count)))
    source = kit.function("made(*x)", found if isinstance(found, tuple) else (found,))
    return loaded(source, {"np": np, "rint": np.rint})["made"]


TAN, EXP, TANH, CIRCLE = map(function, ("tan", "exp", "tanh", "circle"))
ATAN2, HYPOT = function("atan2", 2), function("hypot", 2)


def held(found, exact, largest):
    assert abs(found[0] - exact) <= largest * max(abs(exact), 1e-300)
    assert math.copysign(1.0, found[0]) == math.copysign(1.0, exact)


UNIT = sys.float_info.epsilon
SIGNED = st.floats(-1e6, 1e6).filter(lambda x: x == 0 or abs(x) > 1e-150)


@given(st.floats(-1.57, 1.57), SIGNED, SIGNED)
def test_functions_are_good_to_their_last_digits(angle, y, x):
    fall = -min(abs(x), 680.0)
    held(TAN(angle), math.tan(angle), 2 * UNIT * (1 + abs(math.tan(angle))))  # or of the angle
    held(ATAN2(y, x), math.atan2(y, x + 0.0), 2 * UNIT)
    held(HYPOT(y, x), math.hypot(y, x), 2 * UNIT)
    held(TANH(x), math.tanh(x), 2 * UNIT)
    held(EXP(np.float64(fall)), math.exp(fall), 2 * UNIT)


@given(st.floats(-1e5, 1e5))
def test_a_circle_has_the_errors_of_its_angle(angle):
    assert CIRCLE(angle) == pytest.approx((math.cos(angle), math.sin(angle)), abs=UNIT)


def test_a_series_is_the_polynomial():
    assert compiled.series([1.0, 2.0, 3.0, 4.0], 0.5) == cubic([1.0, 2.0, 3.0, 4.0], 0.5) == 3.25


def test_without_numba_one_line_says_so(monkeypatch):
    monkeypatch.setitem(sys.modules, "numba", None)
    compiled._compiled.cache_clear()
    with pytest.raises(RigidtopError, match=r"compiled=True needs Numba: pip install 'rigidtop\["):
        TOP.motion(theta=0.5, omega3=40.0).exact([0.0, 1.0], compiled=True)


SOME = {
    "heavy": [
        TOP.motion(theta=0.5, theta_dot=0.1, phi_dot=1.0, omega3=40.0),
        TOP.motion(theta=0.0, omega3=5.0),
        HeavyBody(2.0, 1.0, 2.0, M=1.0, centre_of_mass=(0.0, -0.5, 0.0)).motion((1.0, 2.0, 3.0)),
    ],
    "free": [
        FreeBody(1.0, 1.7, 2.5).motion((1.0, 0.5, 2.0)),
        FreeBody(1.0, 1.7, 2.5).motion((0.0, 0.0, 2.0)),
    ],
}


@pytest.mark.parametrize("bodies", SOME)
def test_stored_motions_are_as_exact_and_others_the_same_as_by_numpy(bodies):
    """One test for each of the two loops, which a process compiles once."""
    pytest.importorskip("numba", reason="numba is not installed")
    stored = [one for one in judge.references() if (one.inputs.size == 11) == (bodies == "heavy")]
    found = list(judge.worst(stored[::25], judge.compiled))  # of each family some
    if bodies == "heavy":
        found += judge.worst(stored[::25], judge.compiled, judge.axis_ratios)
    assert [judge.describe(one, judge.compiled) for ratio, one, _ in found if ratio > 1] == []
    for motion in SOME[bodies]:
        for count in (2, 40_000):
            t = np.linspace(-3.0, 7.0, count)
            one, other = motion.exact(t, compiled=True), motion.exact(t)
            for name in NAMES:
                expected = getattr(other, name, 0.0)
                most = 1e-12 * (1 + np.abs(expected).max())
                assert np.abs(getattr(one, name, 0.0) - expected).max() <= most, name
