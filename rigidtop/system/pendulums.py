"""Pendulums in a row: the example on which systems are measured.

>>> pendulums(1).accelerations
Matrix([[-g*sin(theta1(t))/length]])
"""

from __future__ import annotations

from typing import Any

import sympy
from sympy import Expr, cos, sin
from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols

from rigidtop.system.parts import Mass
from rigidtop.system.system import System

m, length, g = sympy.symbols("m length g", positive=True)
PARAMETERS = {m: 1.0, length: 1.0, g: 9.81}


def _masses(n: int) -> tuple[list[Expr], list[Mass]]:
    angles = [dynamicsymbols(f"theta{k + 1}") for k in range(n)]
    x, y, masses = sympy.S.Zero, sympy.S.Zero, []
    for angle in angles:
        x, y = x + length * sin(angle), y - length * cos(angle)
        masses.append(Mass(m, [x, y]))
    return angles, masses


def pendulums(n: int) -> System:
    """n equal masses, each on a rod from the one before, by their angles to the vertical."""
    angles, masses = _masses(n)
    return System.of_parts(masses, angles, gravity=[0, -g])


def by_sympy(n: int) -> LagrangesMethod:
    """The same by SymPy, with its equations formed."""
    angles, masses = _masses(n)
    t = dynamicsymbols._t
    T = sum(part.mass * part.place.diff(t).dot(part.place.diff(t)) for part in masses) / 2
    V = sum(part.mass * g * part.place[1] for part in masses)
    method = LagrangesMethod(T - V, angles)
    method.form_lagranges_equations()
    return method


def operations(expressions: Any) -> int:
    """Of SymPy's expressions, their common subexpressions taken out."""
    shared, reduced = sympy.cse(list(expressions))
    return int(sympy.count_ops([*(value for _, value in shared), *reduced]))
