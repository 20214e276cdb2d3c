"""Pendulums in a row with springs between them, integrated without neglecting anything."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cache
from itertools import pairwise

from sympy import Rational, cos, sin, symbols

from rigidtop.system.motion import SystemMotion
from rigidtop.system.system import System

HALF = Rational(1, 2)
SLOWEST = 1e-4
"""A deflection (rad) at which a swing is small."""


@cache
def row(count: int) -> System:
    """So many pendulums beside each other, with all of the energies of the laws."""
    m, length, g, D = symbols("m l g D", positive=True)
    angles = symbols(f"theta1:{count + 1}", real=True)
    rates = symbols(f"thetadot1:{count + 1}", real=True)
    kinetic = HALF * m * length**2 * sum(rate**2 for rate in rates)
    weight = -m * g * length * sum(map(cos, angles))
    stretched = (sin(b) - sin(a) for a, b in pairwise(angles))
    springs = HALF * D * length**2 * sum(x**2 for x in stretched)
    return System.of_energies(kinetic, weight + springs, angles, rates)


def swing(start: Sequence[float], m: float, length: float, g: float, D: float) -> SystemMotion:
    """Let go at rest at these deflections (rad)."""
    system = row(len(start))
    values = {"m": m, "l": length, "g": g, "D": D}
    given = {x: values[x.name] for x in system.parameters}
    return system.motion(given, q=[*start], qdot=[0.0] * len(start))


def frequency(phase: float, m: float, length: float, g: float, D: float) -> float:
    """Of the wave with this phase from one pendulum to the next, by (3.2), in rad/s."""
    return math.sqrt(g / length + 4 * D / m * math.sin(phase / 2) ** 2)
