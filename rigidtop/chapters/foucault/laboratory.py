"""What moves in a laboratory that turns, integrated from the Lagrangian as space has it."""

from __future__ import annotations

import math
from functools import cache

from sympy import Rational, cos, sin, symbols

from rigidtop.system.motion import SystemMotion
from rigidtop.system.system import System

EARTH = 2 * math.pi / 86164.0905
"""The rate at which the earth turns (rad/s)."""

HALF = Rational(1, 2)


@cache
def system() -> System:
    """A body at (x, y, z) to the east, to the north and upwards, on a soft or on no wire.

    The centrifugal force is a part of the weight, and so stands in no place but g.
    """
    m, omega = symbols("m omega", positive=True)
    g, frequency, latitude = symbols("g omega0 lambda", real=True)
    x, y, z, u, v, w = symbols("x y z xdot ydot zdot", real=True)
    # m v·(ω × r): what Coriolis' force comes from.
    east = omega * (z * cos(latitude) - y * sin(latitude))
    rest = omega * x
    coriolis = m * (u * east + v * rest * sin(latitude) - w * rest * cos(latitude))
    kinetic = HALF * m * (u**2 + v**2 + w**2) + coriolis
    wire = HALF * m * frequency**2 * (x**2 + y**2)
    return System.of_energies(kinetic, m * g * z + wire, [x, y, z], [u, v, w])


def motion(
    q: tuple[float, float, float],
    qdot: tuple[float, float, float],
    latitude: float,
    omega: float = EARTH,
    g: float = 0.0,
    frequency: float = 0.0,
) -> SystemMotion:
    """From a place (m) at a velocity (m/s); a wire pulls back with `frequency` (rad/s)."""
    values = {"m": 1.0, "omega": omega, "g": g, "omega0": frequency, "lambda": latitude}
    given = {x: values[x.name] for x in system().parameters}
    return system().motion(given, q=q, qdot=qdot)
