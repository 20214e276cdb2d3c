"""Opening of chapter 3.2: two masses on a stick, held by a bearing and let go."""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, pi, sin

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from rigidtop.derivations.opening import two_mass_points
from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Exercise, Outcome, exercise
from rigidtop.proof.page import Claim, Measure

bearing_torque = Claim(
    "bearing-torque",
    r"What keeps $\boldsymbol\omega$ constant is a torque $\boldsymbol\omega \times \mathbf L$ "
    r"across the plane of $\boldsymbol\omega$ and stick.",
)


def free_flight(
    positions: NDArray[np.float64],
    velocities: NDArray[np.float64],
    masses: NDArray[np.float64],
    time: float,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Positions and velocities (2, 3) of two masses that a massless stick joins, after `time` (s).

    Newton's law with the one force F that keeps the distance d: F d = −m₁m₂/(m₁+m₂) |ḋ|² along d.
    """
    reduced = masses.prod() / masses.sum()

    def rates(_: float, state: NDArray[np.float64]) -> NDArray[np.float64]:
        r, v = state.reshape(2, 2, 3)
        apart, opening = r[0] - r[1], v[0] - v[1]
        pull = -reduced * (opening @ opening) / (apart @ apart) * apart
        return np.concatenate([v.ravel(), pull / masses[0], -pull / masses[1]])

    start = np.concatenate([positions.ravel(), velocities.ravel()])
    size = float(np.abs(velocities).max()) * time
    path = solve_ivp(rates, (0, time), start, method="DOP853", rtol=1e-12, atol=1e-13 * size)
    r, v = path.y[:, -1].reshape(2, 2, 3)
    return r, v


@exercise(
    "two-masses",
    "Two masses on a stick",
    section="3.2 (opening)",
    asks="opening example",
    statement="The masses $M_1$ and $M_2$ sit at the distances $a$ and $b$ on either side of the "
    "origin on a stick without mass, which a bearing at the origin turns at constant "
    r"$\boldsymbol\omega$, tilted against $\boldsymbol\omega$ by the angle $\alpha$. "
    r"Gravity is left out. Which direction has $\mathbf L$, and how far is it from "
    "$\\boldsymbol\\omega$?\n\nWhat torque, and what force, must the bearing exert, and "
    "in which directions? What do stick and masses do when the bearing lets go?",
    claims=(two_mass_points, bearing_torque),
    parameters=(
        Parameter("M_1", 1.5, "first mass", "kg", above=0),
        Parameter("M_2", 0.8, "second mass", "kg", above=0),
        Parameter("a", 0.4, "distance of the first mass from the bearing", "m", above=0),
        Parameter("b", 0.5, "distance of the second mass from the bearing", "m", above=0),
        Parameter(
            "alpha",
            pi / 6,
            r"tilt of the stick against $\boldsymbol\omega$",
            "rad",
            above=0,
            most=pi / 2,
        ),
        Parameter("omega", 3.0, r"$\omega$", "rad/s", above=0),
    ),
    figure="two-masses",
    text="exercises/two_masses",
)
def two_masses(
    M_1: float, M_2: float, a: float, b: float, alpha: float, omega: float
) -> Iterator[Outcome]:
    r"""$\mathbf L$ and $\mathbf N$ follow from these formulas; sums over the two masses give
    the same. The flight is that of Newton's law for each mass, with the pull of the stick: about
    its centre of mass the stick turns with the part of $\boldsymbol\omega$ across it, about an
    axis parallel to the last $\mathbf L$."""
    moment = M_1 * a**2 + M_2 * b**2
    momentum = moment * omega * sin(alpha)
    torque = moment * omega**2 * sin(alpha) * cos(alpha)
    force = abs(M_1 * a - M_2 * b) * omega**2 * sin(alpha)
    free_rate = omega * sin(alpha)
    drift = omega * sin(alpha) * abs(M_1 * a - M_2 * b) / (M_1 + M_2)
    yield Answer("angular_momentum", "$L$, at right angles to the stick", momentum, "J s")
    yield Answer(
        "angle",
        r"angle between $\mathbf L$ and $\boldsymbol\omega$, $\pi/2 - \alpha$",
        pi / 2 - alpha,
        "rad",
    )
    yield Answer(
        "torque",
        r"torque of the bearing, across the plane of stick and $\boldsymbol\omega$",
        torque,
        "N m",
    )
    yield Answer("force", "force of the bearing, from the centre of mass to the axis", force, "N")
    yield Answer(
        "free_rate",
        r"$|\boldsymbol\omega|$ after it lets go, $\omega \sin\alpha$",
        free_rate,
        "rad/s",
    )
    yield Answer("free_period", "time of one turn then", 2 * pi / free_rate, "s")
    yield Answer("drift", "speed of the centre of mass then", drift, "m/s")

    masses = np.array([M_1, M_2])
    stick = np.array([0.0, sin(alpha), cos(alpha)])
    axis = np.array([0.0, 0.0, omega])
    positions = np.outer([a, -b], stick)
    velocities = np.cross(axis, positions)
    summed = np.cross(positions, masses[:, None] * velocities).sum(axis=0)
    direction = np.arctan2(np.linalg.norm(np.cross(summed, axis)), summed @ axis)
    yield Measure(
        "$L$ as a sum over the masses, relative",
        abs(float(np.linalg.norm(summed)) / momentum - 1),
        1e-12,
    )
    yield Measure(
        r"its angle to $\boldsymbol\omega$ (rad)", abs(float(direction) - (pi / 2 - alpha)), 1e-12
    )
    pushes = masses[:, None] * np.cross(axis, velocities)
    held = np.cross(positions, pushes).sum(axis=0) - np.array([torque, 0.0, 0.0])
    across = float(np.linalg.norm(held)) / (moment * omega**2)
    yield Measure(
        r"$N$ as a sum of $\mathbf r \times \mathbf F$ over the masses, relative to $I\omega^2$",
        across,
        1e-12,
    )
    period = 2 * pi / free_rate
    later, _ = free_flight(positions, velocities, masses, period / 4)
    turned = (later[0] - later[1]) / (a + b)
    # A quarter of a turn about L later the stick points along ω × r of the first mass.
    expected = np.array([-1.0, 0.0, 0.0])
    yield Measure(
        "direction of the stick a quarter of a turn after it is let go, by Newton's law",
        float(np.linalg.norm(turned - expected)),
        1e-9,
    )


EXERCISES: tuple[Exercise, ...] = (two_masses,)
"""Exercises, solved for the settings of a test."""
