"""The motion of a body with a ball in oil inside it: how friction inside changes the axis."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

Floats = NDArray[np.float64]

NEAR = 1e-3
"""Of L: so near to rotation with the largest moment the motion has ended."""


@dataclass(frozen=True)
class Relaxation:
    """N times (s, or the unit of time of ω) with L in body and in space components, T and heat."""

    t: Floats
    momentum: Floats
    in_space: Floats
    energy: Floats
    heat: Floats

    @property
    def strayed(self) -> float:
        """By how much L in space is not what it was, at most, relative."""
        size = float(np.linalg.norm(self.in_space[0]))
        return float(np.linalg.norm(self.in_space - self.in_space[0], axis=1).max()) / size

    @property
    def imbalance(self) -> float:
        """By how much energy and heat do not add up to the energy at first, at most, relative."""
        total = self.energy + self.heat
        return float(np.abs(total / total[0] - 1).max())


def _across(a: Floats, b: Floats) -> Floats:
    """The vector product of two vectors: `np.cross` takes ten times as long for a single pair."""
    (a1, a2, a3), (b1, b2, b3) = a.tolist(), b.tolist()
    return np.array([a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1])


def relaxed(
    moments: ArrayLike,
    omega: ArrayLike,
    ball: float,
    friction: float,
    longest: float,
    samples: int = 13,
) -> Relaxation:
    """From ω with the ball at rest in the body, until L is near the axis of the largest moment.

    `moments` are those of the whole, `ball` is λ₀, and `friction` is c/(λ₀|ω|).  By
    `rigidtop.theory.gyrostat`, with the attitude, the unit matrix at first, as a quaternion.  It
    ends after `longest` at the latest.
    """
    moments, omega = np.asarray(moments, dtype=float), np.asarray(omega, dtype=float)
    largest = moments == moments.max()
    speed = float(np.linalg.norm(omega))
    size = float(np.linalg.norm(moments * omega)) / speed

    def momentum(state: Floats) -> Floats:
        return moments * state[:3] + ball * state[3:6]

    # With 1/|ω| for the unit of time the tolerances suit a body of any speed.
    def rates(_: float, state: Floats) -> Floats:
        w, relative, (v, scalar) = state[:3], state[3:6], (state[6:9], state[9])
        oil = friction * ball * relative
        turning = (oil - _across(w, moments * w)) / (moments - ball)
        slowing = -friction * relative - _across(w, relative) - turning
        attitude = (scalar * w + _across(v, w)) / 2
        return np.hstack([turning, slowing, attitude, -v @ w / 2, oil @ relative])

    def ends(_: float, state: Floats) -> float:
        rest = np.hstack([momentum(state)[~largest], ball * state[3:6]])
        return float(np.linalg.norm(rest)) / size - NEAR

    ends.terminal = True  # type: ignore[attr-defined]
    path: Any = solve_ivp(
        rates,
        (0.0, longest * speed),
        np.hstack([omega / speed, np.zeros(6), 1.0, 0.0]),
        method="DOP853",
        events=ends,
        dense_output=True,
        rtol=1e-11,
        atol=1e-13,
    )
    times = np.linspace(0.0, path.t[-1], samples)
    states = path.sol(times).T
    w, relative = states[:, :3] * speed, states[:, 3:6] * speed
    in_body = moments * w + ball * relative
    inside = ball * (relative * (2 * w + relative)).sum(axis=1)
    return Relaxation(
        times / speed,
        in_body,
        Rotation.from_quat(states[:, 6:10]).apply(in_body),
        ((moments * w**2).sum(axis=1) + inside) / 2,
        states[:, 10] * speed**2,
    )
