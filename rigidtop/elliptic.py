"""Jacobi's elliptic functions for every real argument, next to m = 1 too.

Four terms of theta functions, in the nome q or, for m > ½, in that of 1 − m, of which the smaller
is at most e^(−π) (DLMF 20, 22).  So every parameter costs the same, and none loses digits.  Near
m = 1 the parameter itself does: m₁ = 1 − m may be given beside it, as small as 1e-280.

The error of sn, cn and dn is at most 12 + 2 ln(1/m₁) units of 2.2e-16 of each, also next to their
zeros, and what 8 such units of u change, be u 1e15; that of K 1 unit, that of the first kind 4.
Arguments broadcast.  ValueError for m outside [0, 1].
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import ellipkm1, elliprf, elliprj

from rigidtop.motion.exact import theta
from rigidtop.motion.exact.numbers import Arrays, cubic

Floats = NDArray[np.float64]


class Jacobi(NamedTuple):
    """Of some arguments u and parameters m, of their common shape."""

    sn: Floats
    cn: Floats
    dn: Floats
    am: Floats
    """The amplitude: sn = sin am and cn = cos am, continuous in u (rad)."""


def jacobi(u: ArrayLike, m: ArrayLike, m1: ArrayLike | None = None) -> Jacobi:
    """sn, cn, dn and am of real u, for 0 ≤ m ≤ 1; m₁ = 1 − m is used where it is given.

    >>> jacobi(0.5, 0.0).sn == np.sin(0.5), jacobi(100.0, 1.0).sn
    (np.True_, array(1.))
    >>> [float(f.round(9)) for f in jacobi(20.0, 1.0, m1=1e-16)]
    [1.0, -2e-09, 1e-08, 1.570796329]
    """
    argument = np.asarray(u, dtype=float)
    parameter, rest = _parameters(m, m1)
    with np.errstate(all="ignore"):
        k = Arrays
        mod = theta.modulus(k, parameter, rest)
        functions = theta.real4(k, mod)
        _, two0, three0, four0 = functions.at(k, mod, theta.place(k, mod, mod.rate * 0))
        at = theta.place(k, mod, mod.rate * argument)
        one, two, three, four = functions.at(k, mod, at)
        sign = np.where(at.turns % 2 == 1, -1.0, 1.0)
        sn = four0 / (mod.rate * cubic(mod.sines, mod.q)) * one / four
        cn, dn = four0 / two0 * two / four, four0 / three0 * three / four
        sech = 1 / np.cosh(np.minimum(np.abs(argument), 700.0))
        cn, dn = (np.where(rest == 0, sech, part) for part in (cn, dn))
        return Jacobi(*(np.asarray(x) for x in (sign * sn, sign * cn, dn, _amplitude(at, sn, cn))))


def _amplitude(at: theta.Place, sn: Floats, cn: Floats) -> Floats:
    return np.asarray(np.arctan2(sn, cn) + at.turns * np.pi)


def quarter_period(m: ArrayLike, m1: ArrayLike | None = None) -> Floats:
    """K(m), infinite for m = 1.

    >>> float(quarter_period(0.0)) * 2
    3.141592653589793
    """
    return np.asarray(ellipkm1(_parameters(m, m1)[1]), dtype=float)


def first_kind(sn: ArrayLike, cn: ArrayLike, dn: ArrayLike) -> Floats:
    """u with |u| ≤ K, from its sn, cn ≥ 0 and dn, with their relative accuracy (DLMF 19.25.5)."""
    s, c, d = (np.asarray(x, dtype=float) for x in (sn, cn, dn))
    return np.asarray(s * elliprf(c**2, d**2, 1.0))


def third_kind(n: ArrayLike, u: ArrayLike, m: ArrayLike, m1: ArrayLike | None = None) -> Floats:
    """Π(n; u | m) = ∫₀ᵘ dv/(1 − n sn²v) for real u and n < 1 (DLMF 19.25.14).

    The error is at most 50 + 2 ln(1/m₁) units of 2.2e-16 of it and of u, and what 8 of u change.

    >>> float(third_kind(0.0, 0.7, 0.3)), round(float(third_kind(-2.0, 3.0, 0.5)), 12)
    (0.7, 1.477501748474)
    """
    characteristic, argument = np.asarray(n, dtype=float), np.asarray(u, dtype=float)
    if np.any(characteristic >= 1):
        raise ValueError("n must be less than 1")
    parameter, rest = _parameters(m, m1)
    quarter = ellipkm1(rest)
    half = np.where(np.isfinite(quarter), 2 * quarter, 1.0)
    turns = np.where(np.isfinite(quarter), np.rint(argument / half), 0.0)
    left = argument - turns * half
    f = jacobi(left, parameter, rest)
    complete = np.where(turns == 0, 0.0, elliprj(0.0, rest, 1.0, 1 - characteristic))
    sn2, cn2 = f.sn**2, f.cn**2
    # 1 − n sn² as a sum of what is positive, for it is small where n is almost 1.
    positive = (1 - characteristic) + characteristic * cn2
    rest_of_one = np.where(characteristic > 0, positive, 1 - characteristic * sn2)
    part = f.sn * sn2 * elliprj(cn2, f.dn**2, 1.0, rest_of_one)
    return np.asarray(argument + characteristic / 3 * (part + 2 * turns * complete))


def _parameters(m: ArrayLike, m1: ArrayLike | None) -> tuple[Floats, Floats]:
    parameter = np.asarray(m, dtype=float)
    rest = 1 - parameter if m1 is None else np.asarray(m1, dtype=float)
    for name, value in (("m", parameter), ("m1", rest)):
        if not np.all((value >= 0) & (value <= 1)):
            raise ValueError(f"{name} must lie between 0 and 1")
    return parameter, rest
