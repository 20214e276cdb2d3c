"""Pendulums in a row: the example on which systems are measured.

>>> pendulums(1).accelerations
Matrix([[-g*sin(theta1(t))/length]])
"""

from __future__ import annotations

import sympy
from sympy import Expr, cos, sin
from sympy.physics.mechanics import dynamicsymbols

from rigidtop.system.parts import Mass
from rigidtop.system.system import System

m, length, g = sympy.symbols("m length g", positive=True)
PARAMETERS = {m: 1.0, length: 1.0, g: 9.81}


def masses(n: int) -> tuple[list[Expr], list[Mass]]:
    """Their angles to the vertical, and the masses with their places."""
    angles = [dynamicsymbols(f"theta{k + 1}") for k in range(n)]
    x, y, found = sympy.S.Zero, sympy.S.Zero, []
    for angle in angles:
        x, y = x + length * sin(angle), y - length * cos(angle)
        found.append(Mass(m, [x, y]))
    return angles, found


def pendulums(n: int) -> System:
    """n equal masses, each on a rod from the one before, by their angles to the vertical."""
    angles, parts = masses(n)
    return System.of_parts(parts, angles, gravity=[0, -g])
