"""Jacobi's functions against mpmath at 50 digits, and where SciPy fails."""

import itertools
import math

import numpy as np
import pytest
from mpmath.ctx_mp import MPContext
from numpy.testing import assert_allclose

from rigidtop.elliptic import first_kind, jacobi, quarter_period, third_kind

EPS = float(np.finfo(float).eps)
CONTEXT = MPContext()
CONTEXT.dps = 50


def exactly(u, m, m1=None):
    """sn, cn, dn and their slopes by u."""
    mp = CONTEXT
    parameter = mp.mpf(m) if m1 is None else 1 - mp.mpf(m1)
    turns, left = 0, mp.mpf(u)
    if parameter < 1:
        turns = mp.nint(left / (2 * mp.ellipk(parameter)))
        left -= turns * 2 * mp.ellipk(parameter)
    sn, cn, dn = (mp.ellipfun(name, left, m=parameter) for name in ("sn", "cn", "dn"))
    sign = (-1) ** int(turns)
    sn, cn = sign * sn, sign * cn
    return (sn, cn, dn), (cn * dn, -sn * dn, -parameter * sn * cn)


def drawn(count, seed):
    random = np.random.default_rng(seed)
    for _ in range(count):
        near = 10 ** random.uniform(-16, 0)
        m = float(random.choice([0.0, 0.5, random.random(), near, 1 - near]))
        quarter = float(quarter_period(m))
        size = quarter if math.isfinite(quarter) else 20.0
        u = random.uniform(-9, 9) * size
        yield float(random.choice([u, u / 9, u * 1e-9, size * random.integers(-3, 4) + near])), m


EXTREME = itertools.product(
    (1e-30, 1e-8, -0.7, 40.0, -700.0, 1e5, -1e8, 1e15, -1e15),
    (0.0, 1e-300, EPS / 2, 0.5, math.nextafter(0.5, 1), 1 - 1e-10, 1 - EPS / 2, 1.0),
)
"""Arguments and parameters."""


def test_against_fifty_digits():
    for u, m in [*drawn(400, 4), *EXTREME]:
        found = jacobi(u, m)
        known, slopes = exactly(u, m)
        for value, true, slope in zip(found, known, slopes, strict=False):
            units = 12 + 2 * math.log(1 / max(1 - m, EPS))
            allowed = units * EPS * abs(true) + 8 * EPS * abs(u * slope)
            assert abs(value - float(true)) <= allowed + 1e-300, (u, m)
        assert math.sin(found.am) == pytest.approx(found.sn, rel=1e-14, abs=8 * EPS * (1 + abs(u)))


def test_m1_keeps_the_digits_near_one():
    for m1 in (1e-17, 1e-40, 1e-200):
        quarter = float(quarter_period(1.0, m1))
        for u in (0.3, quarter / 2, quarter * 0.99, quarter * 1.5, -quarter * 3.2):
            context = MPContext()
            context.dps = 260
            parameter = 1 - context.mpf(m1)
            found = jacobi(u, 1.0, m1)
            for name, value in zip(("sn", "cn", "dn"), found, strict=False):
                true = context.ellipfun(name, context.mpf(u), m=parameter)
                assert abs(value - float(true)) <= 1e-15 * (1 + abs(u)), (m1, u, name)
                if abs(u) < quarter and name != "sn":
                    assert value == pytest.approx(float(true), rel=8 * EPS * (4 + abs(u)))


def test_where_scipy_has_nan_or_loses_digits():
    """scipy/scipy#8480: NaN at m = 1 and wrong values next to it."""
    u = np.array([-30.0, -2.0, 0.0, 1e-9, 0.5, 5.0, 700.0])
    found = jacobi(u, 1.0)
    assert_allclose(found.sn, np.tanh(u), rtol=4 * EPS)
    assert_allclose(found.cn, 1 / np.cosh(u), rtol=8 * EPS)
    assert_allclose(found.dn, 1 / np.cosh(u), rtol=8 * EPS)
    assert_allclose(found.am, 2 * np.arctan(np.tanh(u / 2)), rtol=8 * EPS)
    near = jacobi(u[:-1], np.nextafter(1.0, 0.0))
    assert np.all(np.isfinite(near.sn))


def test_identities_and_shapes():
    u, m = np.linspace(-20, 20, 301), np.linspace(0, 1, 7)[:, None]
    sn, cn, dn, am = jacobi(u, m)
    assert sn.shape == (7, 301)
    assert_allclose(sn**2 + cn**2, 1.0, atol=1e-14)
    assert_allclose(dn**2 + m * sn**2, 1.0, atol=1e-14)
    assert_allclose(np.sin(am), sn, atol=1e-14)
    assert np.all(np.diff(am, axis=1) > 0)


def test_inverse_and_third_kind():
    mp = CONTEXT
    for u, m in ((0.7, 0.3), (1e-9, 0.9), (1.5, 0.99), (-0.4, 1.0)):
        sn, cn, dn, _ = jacobi(u, m)
        assert first_kind(sn, cn, dn) == pytest.approx(u, rel=1e-15)
    for n, u, m in ((0.3, 0.7, 0.2), (-5.0, 1.2, 0.9), (0.9, 9.3, 0.5), (-0.2, -30.0, 0.999)):
        amplitude = float(jacobi(u, m).am)
        true = mp.ellippi(mp.mpf(n), mp.mpf(amplitude), mp.mpf(m))
        assert float(third_kind(n, u, m)) == pytest.approx(float(true), rel=1e-13)


def test_the_third_kind_next_to_its_pole_and_far_from_it():
    mp, random = CONTEXT, np.random.default_rng(10)
    for _ in range(200):
        n = float(random.choice([-(10 ** random.uniform(-3, 3)), 1 - 10 ** random.uniform(-8, 0)]))
        m = float(random.choice([random.random(), 1 - 10 ** random.uniform(-16, 0)]))
        u = float(random.normal() * 10 ** random.uniform(-3, 2))
        (sn, _, _), _ = exactly(u, m)
        turns = mp.nint(mp.mpf(u) / (2 * mp.ellipk(m)))
        true = mp.ellippi(n, mp.asin(sn) * (-1) ** int(turns) + mp.pi * turns, m)
        allowed = (50 + 2 * math.log(1 / (1 - m))) * (abs(true) + abs(u)) + 8 * abs(u) / (
            1 - n * sn**2
        )
        assert abs(float(third_kind(n, u, m)) - true) <= allowed * EPS, (n, u, m)


@pytest.mark.parametrize("m", [-0.1, 1.1, math.nan])
def test_parameters_outside_are_refused(m):
    with pytest.raises(ValueError, match="m must lie between 0 and 1"):
        jacobi(0.5, m)
    with pytest.raises(ValueError, match="n must be less than 1"):
        third_kind(1.0, 0.5, 0.5)
