"""A tippe top in numbers, and the least energy of (4.2)."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from rigidtop.errors import RigidtopError

if TYPE_CHECKING:
    from rigidtop.motion.table.motion import SlidingTop

UNIT = 0.02 * 0.02**2
USUAL = {"M": 0.02, "r": 0.02, "h": 0.006, "lambda1": 131 / 350 * UNIT, "lambda3": 0.4 * UNIT}
"""The top of Ciocci, Malengier, Langerock and Grimonprez, J. Appl. Math. 2012, 268537."""


def tippe_top(
    M: float, r: float, h: float, lambda1: float, lambda3: float, f: float = 0.1
) -> SlidingTop:
    """The top in the letters of the pages, in SI units; its friction is −f v."""
    from rigidtop.motion.table.motion import SlidingTop  # which no page needs

    if h >= r:
        raise RigidtopError(f"h = {h:g} must be less than r = {r:g}")
    moments = {"lambda1": lambda1, "lambda3": lambda3}
    return SlidingTop(**moments, M=M, R=r - h, tip=r, viscosity=f, fall=math.pi)


def least_energy(top: SlidingTop, J: float, tilt: float) -> float:
    """U at a tilt (J)."""
    r, h, c = top.tip, top.tip - top.R, math.cos(tilt)
    moment = top.lambda1 * r**2 * (1 - c**2) + top.lambda3 * (h - r * c) ** 2
    return J**2 / (2 * moment) + top.M * top.g * (r - h * c)
