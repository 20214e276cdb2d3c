"""Jacobi's functions and elliptic integrals from the complementary parameter m₁ = 1 − m.

Near a separatrix m rounds to 1 while m₁, which sets the period, is known to all its digits; so m₁
is the argument here.  Everything broadcasts.  The integrals are Carlson's symmetric ones (DLMF 19).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.special import ellipkm1, elliprf, elliprj

from rigidtop.motion.attitude import Floats

SMALLEST_ARGUMENT = 1e-150
"""Below this sn u = u and cn u = dn u = 1 to all digits, and cn/sn need not be formed."""

SMALLEST_PART = 1e-100
"""Of squares: the integral of the third kind is out of range for parameters of 1e-200.

Deviations from a separatrix or a pole of 1e-50 and less thus count as none.
"""

MEANS = 16
"""Arithmetic-geometric means converge in 9 steps for m₁ = 1e-300, in 4 for m₁ > 0.1."""


@dataclass(frozen=True)
class Jacobi:
    """sn, cn and dn of some argument."""

    sn: Floats
    cn: Floats
    dn: Floats

    def third_kind(self, p: Floats) -> Floats:
        """∫ sn²/(1 − n sn²) du from 0 to u, for p = 1 − n sn² and |u| ≤ K (DLMF 19.25.14).

        It is given p itself, which the caller forms without cancellation.
        """
        return self.sn**3 / 3 * elliprj(self.cn**2, self.dn**2, 1.0, p)


def quarter_period(m1: Floats) -> Floats:
    """K, infinite on a separatrix (m₁ = 0).

    >>> float(quarter_period(1.0)) * 2
    3.141592653589793
    """
    return np.asarray(ellipkm1(m1), dtype=float)


def first_kind(sn: Floats, cn: Floats, dn: Floats) -> Floats:
    """u with |u| ≤ K from its sn, cn ≥ 0 and dn."""
    return sn * elliprf(cn**2, dn**2, 1.0)


def jacobi(u: Floats, m1: Floats) -> Jacobi:
    """sn, cn, dn for |u| ≤ K.

    Gauss's transformation of cn/sn, which keeps the relative accuracy of cn and dn where they are
    small (Bulirsch 1965, Numer. Math. 7, 78).

    >>> jacobi(0.5, 1.0).sn == np.sin(0.5), float(jacobi(0.5, 0.0).dn * np.cosh(0.5))
    (np.True_, 1.0)
    """
    u, m1 = np.asarray(u, dtype=float), np.asarray(m1, dtype=float)
    bounded = np.where(m1 > 0, m1, 1.0)
    arithmetic, geometric = [np.ones_like(bounded)], [np.sqrt(bounded)]
    for _ in range(MEANS):
        if np.all(np.abs(arithmetic[-1] - geometric[-1]) <= 1e-8 * arithmetic[-1]):
            break
        mean = (arithmetic[-1] + geometric[-1]) / 2
        geometric.append(np.sqrt(arithmetic[-1] * geometric[-1]))
        arithmetic.append(mean)
    mean = (arithmetic[-1] + geometric[-1]) / 2
    tiny = np.abs(u) < SMALLEST_ARGUMENT
    angle = np.where(tiny, 1.0, u) * mean
    sine = np.sin(angle)
    a = np.cos(angle) / sine
    c, dn = mean * a, np.ones_like(a)
    for b, root in zip(reversed(arithmetic), reversed(geometric), strict=True):
        a = a * c
        c = c * dn
        dn = (root + a) / (b + a)
        a = c / b
    sn = np.copysign(1 / np.sqrt(c**2 + 1), sine)
    cn = np.abs(c * sn)  # at K rounding may have gone beyond
    if np.any(tiny):
        sn, cn, dn = (np.where(tiny, value, f) for value, f in ((u, sn), (1.0, cn), (1.0, dn)))
    separatrix = m1 == 0
    if np.any(separatrix):
        sech = 1 / np.cosh(np.where(separatrix, np.clip(u, -700, 700), 0.0))
        sn = np.where(separatrix, np.tanh(u), sn)
        cn, dn = np.where(separatrix, sech, cn), np.where(separatrix, sech, dn)
    return Jacobi(sn, cn, dn)
