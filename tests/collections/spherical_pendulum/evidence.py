"""Motions of the bob by Newton's law in x, y, z, which knows no angles and no Lagrangian."""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, pi, sin, sqrt

import numpy as np
from scipy.integrate import solve_ivp

from rigidtop.proof.page import Measure

# No two are equal, so that a formula with two of them exchanged shows.
MASS, GRAVITY, LENGTH, TILT = 0.8, 9.81, 1.3, 0.7


def moved(theta, theta_dot, phi_dot, times, gravity=GRAVITY, length=LENGTH):
    """Places and velocities, (n, 3) each, of a bob that starts over the x axis."""

    def newton(_, y):
        r, v = y[:3], y[3:]
        pull = (v @ v - gravity * r[2]) / length**2  # keeps the string as long as it is
        return [*v, *(-pull * r + [0.0, 0.0, -gravity])]

    place = [length * sin(theta), 0.0, -length * cos(theta)]
    velocity = [
        length * theta_dot * cos(theta),
        length * phi_dot * sin(theta),
        length * theta_dot * sin(theta),
    ]
    solved = solve_ivp(
        newton,
        (0, times[-1]),
        [*place, *velocity],
        "DOP853",
        t_eval=times,
        rtol=1e-12,
        atol=1e-13,
    )
    return solved.y[:3].T, solved.y[3:].T


def rate(theta, gravity=GRAVITY, length=LENGTH):
    """ω of the cone (rad/s)."""
    return sqrt(gravity / (length * cos(theta)))


def conserved() -> Iterator[Measure]:
    """L_z and E of a motion that goes up and down, by their formulas in x, y, z."""
    r, v = moved(TILT, 0.4, 1.9, np.linspace(0, 20, 101))
    for name, series in (
        ("$L_z$", r[:, 0] * v[:, 1] - r[:, 1] * v[:, 0]),
        ("E", (v * v).sum(axis=1) / 2 + GRAVITY * r[:, 2]),
    ):
        drift = float(np.ptp(series) / abs(series[0]))
        yield Measure(f"drift of {name} over 20 s, relative", drift, 1e-9)


def cone() -> Iterator[Measure]:
    """A bob that is started on a cone at ω stays on it."""
    r, _ = moved(TILT, 0.0, rate(TILT), np.linspace(0, 20, 101))
    held = float(np.abs(r[:, 2] + LENGTH * cos(TILT)).max())
    yield Measure("height held over 20 s on a cone (m)", held, 1e-8)


def nodding() -> Iterator[Measure]:
    """θ of a bob that is pushed a little on its cone, over three nods."""
    frequency, kick = rate(TILT) * sqrt(1 + 3 * cos(TILT) ** 2), 1e-5
    times = np.linspace(0, 6 * pi / frequency, 61)
    r, _ = moved(TILT, kick, rate(TILT), times)
    seen = np.arccos(-r[:, 2] / LENGTH) - TILT
    expected = kick / frequency * np.sin(frequency * times)
    error = float(np.abs(seen - expected).max() * frequency / kick)
    yield Measure(r"$\theta(t)$ of small nodding at $\Omega$, three nods, relative", error, 1e-3)
