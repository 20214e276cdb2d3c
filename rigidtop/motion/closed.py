"""Closed forms of the bodies that have one, as attitudes and ω of a motion."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, fields

import numpy as np
from scipy.spatial.transform import Rotation

from rigidtop.errors import RigidtopError
from rigidtop.motion import attitude as attitudes
from rigidtop.motion.attitude import Floats
from rigidtop.motion.exact import free, heavy, heavy_orbit, samples
from rigidtop.motion.rigid import RigidBody
from rigidtop.motion.start import AnyStart, InitialState
from rigidtop.trace import Solved


@dataclass(frozen=True)
class Axis:
    """The axis of a symmetric heavy body, through its centre of mass."""

    lambda1: float
    lambda3: float
    weight: float
    """MgR > 0."""
    turn: Floats | None
    """A quaternion from axes of which the third points to the centre of mass; None: the body's."""

    def start(self, start: AnyStart) -> heavy_orbit.HeavyStart:
        """What a motion starts from, in axes of which it is the third."""
        mu, omega3 = self.weight / self.lambda1, start.omega[2]
        b = self.lambda3 * omega3 / self.lambda1
        return heavy_orbit.HeavyStart(mu, b, omega3, *start.halves, *start.rates, *start.angles)


def axis(body: RigidBody) -> Axis:
    """The symmetry axis of a heavy body that has one; RigidtopError for others."""
    moments, weight = body.moments, body.weight
    if moments[0] == moments[1] == moments[2]:
        size = math.hypot(*weight)
        x, y, z = (part / size for part in weight)
        # The shortest way from ẑ, or from −ẑ after half a turn about x̂.
        turn = np.array([1 + z, -y, x, 0.0] if z > -0.5 else [-y, 1 - z, 0.0, -x])
        whole = turn if z < 1 else None
        return Axis(
            moments[0], moments[0], size, None if whole is None else turn / np.linalg.norm(turn)
        )
    for third in (2, 0, 1):
        first, second = (third + 1) % 3, (third + 2) % 3
        if moments[first] == moments[second] and weight[first] == weight[second] == 0.0:
            cyclic = np.array([1.0, *(1.0,) * 3]) / 2  # ẑ to x̂
            named = (None, cyclic, attitudes.conjugate(cyclic))[(third + 1) % 3]
            if weight[third] < 0:
                below = np.array([0.0, 1.0, 0.0, 0.0])
                named = below if named is None else attitudes.product(named, below)
            return Axis(moments[first], moments[third], abs(weight[third]), named)
    raise RigidtopError(
        "no closed form: a heavy body has one only if two of its moments are equal and its centre "
        "of mass lies on the axis of the third, or if all three are; integrate the motion instead"
    )


def solved(body: RigidBody, start: AnyStart) -> Solved:
    """The closed form of a motion; RigidtopError for a body that has none here."""
    if not any(body.weight):
        return free.solved(body.moments, start.omega)
    symmetry = axis(body)
    if symmetry.turn is not None:
        turn = attitudes.rotation(symmetry.turn)
        first, second, third = turn.inv().apply(start.omega).tolist()
        start = InitialState(start.attitude * turn, (first, second, third))
    return heavy.solved(symmetry.start(start))


def states(
    solved: Solved, body: RigidBody, start: AnyStart, times: Floats, compiled: bool
) -> tuple[Floats, Floats]:
    """Quaternions (N, 4), scalar first, body to space, and ω (N, 3) in body components (rad/s)."""
    if not any(body.weight):
        rows = _free_states(solved, start.attitude, times, compiled)
        return rows[:4].T, rows[4:].T
    s, turn = heavy.states(solved, times, compiled), axis(body).turn
    if turn is None:
        return s.quaternion, s.omega
    whole = attitudes.product(s.quaternion, attitudes.conjugate(turn))
    return whole, np.asarray(attitudes.rotation(turn).apply(s.omega))


def _free_states(solved: Solved, attitude: Rotation, times: Floats, compiled: bool) -> Floats:
    """The quaternion and ω, (7, N)."""
    first = attitude.as_quat(scalar_first=True).tolist()

    if len(times) == 1:
        state = solved.at(float(times[0]))
        return np.array([[*attitudes.after(first, state[:4]), *state[4:]]]).T
    if compiled and len(times) <= samples.MANY:
        return free.rows(solved, first, times)
    orbit: free.FreeOrbit = solved.orbit

    def columns(t: Floats) -> Sequence[Floats]:
        state = orbit.at(t)
        return *attitudes.after(first, state.quaternion), *state.omega

    def states(t: Floats) -> Floats:
        return free.rows(solved, first, t) if compiled else samples.in_blocks(columns, t)

    rotation = 1 + float(max(abs(times[0]), abs(times[-1]))) * 2 * orbit.sigma
    names = [each.name for each in fields(free.FreeState)]
    needed = [(name, rotation if name[0] == "q" else rotation * orbit.sigma) for name in names]
    even = samples.samples(
        times,
        orbit.smoothness,
        lambda nodes: free.FreeState(*states(nodes)),
        lambda _: lambda _: needed,
    )
    return even.of(*names) if even is not None else states(times)
