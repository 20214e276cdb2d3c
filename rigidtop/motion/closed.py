"""Closed forms of the bodies that have one, as attitudes and ω of a motion."""

from __future__ import annotations

import math
from dataclasses import fields
from typing import TYPE_CHECKING

import numpy as np
from scipy.spatial.transform import Rotation

from rigidtop.errors import RigidtopError
from rigidtop.motion import attitude as attitudes
from rigidtop.motion.attitude import Floats
from rigidtop.motion.exact import free, heavy, samples

if TYPE_CHECKING:
    from rigidtop.motion.body import RigidBody
    from rigidtop.motion.motion import Motion

UPSIDE_DOWN = np.array([0.0, 1.0, 0.0, 0.0])
"""Half a turn about x̂, as a quaternion: ẑ becomes −ẑ."""


def orbit(
    body: RigidBody, attitude: Rotation, omega: tuple[float, float, float]
) -> free.Orbit | heavy.Orbit:
    """The closed form of a motion; RigidtopError for a body that has none here."""
    if not any(body.weight):
        return free.solve(body.moments, omega)
    if not body.symmetric:
        raise RigidtopError(
            "no closed form: a heavy body has one only if lambda1 = lambda2 and its centre of mass "
            "lies on e3; integrate the motion instead"
        )
    return _heavy_orbit(body, attitude, omega)


def _heavy_orbit(
    body: RigidBody, attitude: Rotation, omega: tuple[float, float, float]
) -> heavy.Orbit:
    """Of a body that is symmetric about e₃, its centre of mass on e₃ above or below the pivot."""
    q = attitudes.quaternions(attitude)
    if body.weight[2] < 0:
        q = attitudes.product(UPSIDE_DOWN, q)
    phi, psi = attitudes.azimuth_and_spin(attitudes.rotation(q), omega)
    alpha, beta = attitudes.spinors(q)
    # ω = −φ̇ sin θ e₁′ + θ̇ e₂′ + ω₃e₃, and the body is turned by ψ about e₃ (3.42).
    sin_psi, cos_psi = math.sin(psi), math.cos(psi)
    return heavy.solve(
        start(
            body,
            omega3=omega[2],
            halves=(float(abs(alpha)), float(abs(beta))),
            rates=(
                omega[0] * sin_psi + omega[1] * cos_psi,
                omega[1] * sin_psi - omega[0] * cos_psi,
            ),
            angles=(phi, psi),
        )
    )


def start(
    body: RigidBody,
    omega3: float,
    halves: tuple[float, float],
    rates: tuple[float, float],
    angles: tuple[float, float],
) -> heavy.Start:
    """From cos(θ/2) and sin(θ/2), θ̇ and φ̇ sin θ, φ and ψ."""
    (lambda1, _, lambda3), weight = body.moments, body.weight[2]
    return heavy.Start(
        abs(weight) / lambda1, lambda3 * omega3 / lambda1, omega3, *halves, *rates, *angles
    )


def states(motion: Motion, times: Floats) -> tuple[Floats, Floats]:
    """Quaternions (N, 4), scalar first, body to space, and ω (N, 3) in body components (rad/s)."""
    solved = motion.orbit
    if isinstance(solved, free.Orbit):
        columns = _free_states(solved, motion.attitude, times)
        return np.stack(columns[:4], axis=-1), np.stack(columns[4:], axis=-1)
    s = solved.states(times)
    if motion.body.weight[2] < 0:
        return attitudes.product(attitudes.conjugate(UPSIDE_DOWN), s.quaternion), s.omega
    return s.quaternion, s.omega


def _free_states(orbit: free.Orbit, attitude: Rotation, times: Floats) -> list[Floats]:
    first = attitude.as_quat(scalar_first=True).tolist()
    names = [each.name for each in fields(free.State)]

    def at(t: Floats | float) -> free.State:
        state = orbit.at(t)
        return free.State(*free.after(first, state.quaternion), *state.omega)

    def columns(part: Floats) -> list[Floats]:
        return [getattr(at(part), name) for name in names]

    if len(times) == 1:
        return [np.array([value]) for value in vars(at(float(times[0]))).values()]
    latest = float(max(abs(times[0]), abs(times[-1])))

    def needed(state: free.State) -> list[tuple[Floats, Floats]]:
        size = np.broadcast_to(1 + latest * 2 * orbit.sigma, np.shape(state.q0))
        return [
            *((part, size) for part in state.quaternion),
            *((part, size * orbit.sigma) for part in state.omega),
        ]

    even = samples.samples(times, orbit.half_piece, at, needed)
    if even is not None:
        return [even.of(name) for name in names]
    return samples.in_blocks(columns, times)
