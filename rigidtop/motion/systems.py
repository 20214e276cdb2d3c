"""The two systems that are integrated, and what a solver has to know of each.

A state is the quaternion q₀ … q₃ and then the components of ω (rad/s); a motion is given by the
parameters of the right-hand side and by the state at t = 0.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from rigidtop.motion import equations
from rigidtop.motion.attitude import Floats

SMALLEST_SIZE = 1e-150
"""Motions smaller than this are not resolved: tolerances and squares would be near underflow."""

Sizes = Callable[[Floats], Floats]
"""A state (n,) in, what an absolute tolerance multiplies for each component (n,) out, none zero."""


@dataclass(frozen=True)
class ShippedEquations:
    """Shipped equations ẋ = f(x; parameters)."""

    equations: Callable[..., equations.Rates]

    per_time: tuple[int, ...]
    """For each parameter the power of 1/s in its unit.  Of a state, q has 0 and ω has 1."""

    rate: Callable[[Sequence[float], Floats], float]
    """Parameters and a state in, out the fastest rate of small changes (1/s)."""

    sizes: Callable[[Sequence[float]], Sizes]
    """Parameters in, out what absolute tolerances are measured against: see `Motion.integrate`."""


def _top_rate(parameters: Sequence[float], state: Floats) -> float:
    lambda1, lambda3, M, g, R, omega3 = parameters
    steady = lambda3 / lambda1 * np.abs(omega3) + np.sqrt(np.abs(M * g * R) / lambda1)
    return float(steady + np.hypot(state[4], state[5]))


def _body_rate(parameters: Sequence[float], state: Floats) -> float:
    moments, (M, g, R1, R2, R3) = parameters[:3], parameters[3:]
    arm = np.hypot(np.hypot(R1, R2), R3)
    speed = np.hypot(np.hypot(state[4], state[5]), state[6])
    return float(speed + np.sqrt(np.abs(M * g) * arm / np.minimum.reduce(moments)))


def _top_sizes(parameters: Sequence[float]) -> Sizes:
    _, _, M, g, R, _ = parameters
    weight, steady = M * g * R, float(_top_rate(parameters, np.zeros(6)))

    def sizes(state: Floats) -> Floats:
        q0, q1, q2, q3, omega1, omega2 = state.tolist()
        speed = math.hypot(omega1, omega2)
        nu = steady + speed
        sine = 2 * min(math.hypot(q0, q3), math.hypot(q1, q2))
        tilt = min(1.0, max(sine, speed / nu if nu else 0.0))
        turning = tilt if weight else min(1.0, speed)
        # Where nothing moves, nothing will: any size does.
        return np.maximum([tilt or 1.0] * 4 + [turning or 1.0] * 2, SMALLEST_SIZE)

    return sizes


TOP = ShippedEquations(equations.heavy_top, (0, 0, 0, 2, 0, 1), _top_rate, _top_sizes)
"""Symmetric about e₃, in the frame that does not turn about it; ω₃ is a parameter."""

BODY = ShippedEquations(
    equations.heavy_body, (0, 0, 0, 0, 2, 0, 0, 0), _body_rate, lambda _: np.ones_like
)
"""Any body, in the body frame."""
