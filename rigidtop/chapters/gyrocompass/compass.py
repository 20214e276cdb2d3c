"""A wheel whose axis is kept level on an earth that turns, integrated with nothing dropped."""

from __future__ import annotations

import math
from functools import cache

from sympy import Rational, cos, sin, symbols

from rigidtop.system.motion import SystemMotion
from rigidtop.system.system import System

EARTH = 2 * math.pi / 86164.0905
"""The rate at which the earth turns (rad/s)."""

RADIUS = 6.371e6
"""Of the earth (m)."""

MINUTE = 2 * math.pi / 60
"""A turn a minute (rad/s)."""

DISC = 2.0
"""C/A of a thin disc."""

HALF = Rational(1, 2)


@cache
def system() -> System:
    """The wheel of (5.3), with a liquid that holds its axis back."""
    A, C, omega = symbols("A C Omega", positive=True)
    latitude, way, damping = symbols("beta k gamma", real=True)
    alpha, psi, u, w = symbols("alpha psi alphadot psidot", real=True)
    north = omega * cos(latitude)
    along = w + north * cos(alpha) + way * sin(alpha)
    across = north * sin(alpha) - way * cos(alpha)
    upright = u + omega * sin(latitude)
    kinetic = HALF * A * (upright**2 + across**2) + HALF * C * along**2
    return System(kinetic, [alpha, psi], [u, w], rayleigh=A * damping * u**2)


def let_go(
    alpha: float,
    spin: float,
    latitude: float,
    ratio: float = DISC,
    speed: float = 0.0,
    damping: float = 0.0,
) -> SystemMotion:
    """At rest at an angle from north, on a ship of a speed to the north (m/s)."""
    way = speed / RADIUS
    values = {"A": 1.0, "C": ratio, "Omega": EARTH, "beta": latitude, "k": way, "gamma": damping}
    share = EARTH * math.cos(latitude) * math.cos(alpha) + way * math.sin(alpha)
    given = {x: values[x.name] for x in system().parameters}
    return system().motion(given, q=[alpha, 0.0], qdot=[0.0, spin - share])


def frequency(spin: float, latitude: float, ratio: float = DISC, speed: float = 0.0) -> float:
    """Of small swings about where the axis is at rest (rad/s)."""
    return math.sqrt(ratio * spin * math.hypot(EARTH * math.cos(latitude), speed / RADIUS))
