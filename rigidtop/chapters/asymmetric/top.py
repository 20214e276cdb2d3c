"""A heavy top without symmetry, in Euler's angles: its Lagrangian, and motions from a start."""

from __future__ import annotations

import math
from functools import cache
from typing import Any, TypeAlias

import numpy as np
from sympy import Expr, cos, sin, symbols

from rigidtop.system.motion import SystemMotion
from rigidtop.system.system import System

Moments: TypeAlias = tuple[float, float, float]
Number: TypeAlias = Any
"""A float, or an array of them."""
Triple: TypeAlias = tuple[Number, Number, Number]

PHI, THETA, PSI = symbols("phi theta psi", real=True)
RATES = symbols("phidot thetadot psidot", real=True)

OMEGA = (
    -RATES[0] * sin(THETA) * cos(PSI) + RATES[1] * sin(PSI),
    RATES[0] * sin(THETA) * sin(PSI) + RATES[1] * cos(PSI),
    RATES[0] * cos(THETA) + RATES[2],
)
"""ω₁, ω₂ and ω₃."""

GAMMA = (-sin(THETA) * cos(PSI), sin(THETA) * sin(PSI), cos(THETA))
"""γ₁, γ₂ and γ₃."""


@cache
def system() -> System:
    """The top of (1.3); `pull` is MgR."""
    moments = symbols("lambda1:4", positive=True)
    pull = symbols("pull", real=True)
    kinetic = sum((a * rate**2 / 2 for a, rate in zip(moments, OMEGA, strict=True)), start=0)
    return System.of_energies(kinetic, pull * GAMMA[0], [PHI, THETA, PSI], [*RATES])


def parameters(moments: Moments, pull: float) -> dict[str, float]:
    """The numbers of a top, by their names."""
    return dict(zip(("lambda1", "lambda2", "lambda3"), moments, strict=True)) | {"pull": pull}


def angle_rates(theta: Number, psi: Number, omega: Triple) -> tuple[Number, Number, Number]:
    """The rates of Euler's angles (rad/s) for ω₁, ω₂ and ω₃, which needs sin θ ≠ 0."""
    round_ = (omega[1] * np.sin(psi) - omega[0] * np.cos(psi)) / np.sin(theta)
    over = omega[0] * np.sin(psi) + omega[1] * np.cos(psi)
    return round_, over, omega[2] - round_ * np.cos(theta)


def across(moments: Moments, energy: float, chi: Number, rate: Number) -> tuple[Number, Number]:
    """ω₁ and ω₂ of a top with e₃ level, ω₃ = `rate`, L_z = 0 and an energy, where MgR = 1."""
    along = moments[1] * np.sin(chi), moments[0] * np.cos(chi)
    left = 2 * (energy + np.cos(chi)) - moments[2] * rate**2
    size = np.sqrt(left / (moments[0] * along[0] ** 2 + moments[1] * along[1] ** 2))
    return size * along[0], size * along[1]


def let_go(
    moments: Moments,
    pull: float,
    chi: float,
    omega: Triple = (0.0, 0.0, 0.0),
    tilt: float = 0.0,
) -> SystemMotion:
    """From e₁ at the angle χ from straight below, and e₃ at a tilt from level, both in rad."""
    theta = math.pi / 2 + tilt
    rates = angle_rates(theta, chi, omega)
    return system().motion(parameters(moments, pull), [0.0, theta, chi], rates)


def kovalevskaya(ratio: float, mu: float) -> Expr:
    """K of a top with λ₁ = λ₂, in Euler's angles."""
    first = OMEGA[0] ** 2 - OMEGA[1] ** 2 - 2 / ratio * mu * GAMMA[0]
    second = 2 * OMEGA[0] * OMEGA[1] - 2 / ratio * mu * GAMMA[1]
    return first**2 + second**2
