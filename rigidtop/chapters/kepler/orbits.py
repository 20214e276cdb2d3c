"""Orbits, integrated: what the figures show and what confirms the numbers of the exercises."""

from __future__ import annotations

import math
from functools import cache

from sympy import Rational, symbols

from rigidtop.system.motion import SystemMotion
from rigidtop.system.system import System

GM = 1.32712440018e20
"""Of the sun (m³/s²)."""

HALF, M_K = Rational(1, 2), symbols("m k", positive=True)


@cache
def system() -> System:
    """A planet about a sun at the origin, in polar coordinates."""
    m, k = M_K
    r = symbols("r", positive=True)
    phi, r_dot, phi_dot = symbols("phi rdot phidot", real=True)
    lagrangian = HALF * m * (r_dot**2 + r**2 * phi_dot**2) + k / r
    return System(lagrangian, [r, phi], [r_dot, phi_dot])


def orbit(p: float, eccentricity: float, strength: float = 1.0) -> SystemMotion:
    """A motion that starts at the perihelion at φ = 0; p (m), `strength` is GM (m³/s²)."""
    nearest = p / (1 + eccentricity)
    rate = math.sqrt(strength * p) / nearest**2
    m, k = M_K
    return system().motion({m: 1.0, k: strength}, q=[nearest, 0.0], qdot=[0.0, rate])


def period(p: float, eccentricity: float, strength: float = 1.0) -> float:
    """Of an ellipse, by (2.4), in s."""
    a = p / (1 - eccentricity**2)
    return 2 * math.pi * math.sqrt(a**3 / strength)
