"""The bodies of the exercises: their parameters, and their defaults."""

from __future__ import annotations

from math import cos, pi

import numpy as np
from numpy.typing import NDArray

from rigidtop.motion.top import ROUNDING, HeavyTop
from rigidtop.parameters import Parameter

Vectors = NDArray[np.float64]

# About the pivot; no two numbers are equal, so that a formula with two of them exchanged shows.
LAMBDA1 = Parameter("lambda1", 1.3, r"$\lambda_1$ about the pivot", "kg m²", above=0)
LAMBDA3 = Parameter("lambda3", 0.7, r"$\lambda_3$ about the axis", "kg m²", above=0)
FREE1 = Parameter("lambda1", 1.3, r"$\lambda_1$ about the centre of mass", "kg m²", above=0)
"""Of a free body, which nothing holds."""

MASS = Parameter("M", 0.8, "mass", "kg", above=0)
ARM = Parameter("R", 0.6, "distance from the pivot to the centre of mass", "m", above=0)
GRAVITY = Parameter("g", 9.81, "acceleration of gravity", "m/s²", above=0)
HEAVY_TOP = (LAMBDA1, LAMBDA3, MASS, ARM, GRAVITY)
"""What `HeavyTop` takes."""


def heavy_top(lambda1: float, lambda3: float, M: float, R: float, g: float) -> HeavyTop:
    """The top of these settings."""
    return HeavyTop(lambda1=lambda1, lambda3=lambda3, M=M, R=R, g=g)


TILT = Parameter("theta", pi / 6, r"$\theta$ at the start", "rad", above=0, most=pi)
SPIN = Parameter("omega3", 20.0, r"$\omega_3$", "rad/s")


def angles(a: Vectors, b: Vectors) -> Vectors:
    """The angles (N,) between the rows of two arrays (N, 3), in radians."""
    across = np.linalg.norm(np.cross(a, b), axis=-1)
    made: Vectors = np.arctan2(across, np.sum(a * b, axis=-1))
    return made


def smallness(top: HeavyTop, spin: float) -> float:
    """ε₀ = λ₁MgR/(λ₃ω₃)²."""
    return top.lambda1 * top.weight[2] / (top.lambda3 * spin) ** 2


def simple_rate(top: HeavyTop, spin: float) -> float:
    """Ω by (3.52) (rad/s)."""
    return top.weight[2] / (top.lambda3 * spin)


def least_spin(top: HeavyTop, theta: float) -> float | str:
    """The smallest |ω₃| with a steady precession at θ (rad/s), in words where there is none.

    A horizontal top needs some spin, and none is too small.
    """
    return "more than 0" if abs(cos(theta)) < ROUNDING else top.smallest_spin(theta)
