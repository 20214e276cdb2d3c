"""One motion, several ways: laws that share no equation must give the same attitudes."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from rigidtop.errors import RigidtopError
from rigidtop.motion import checks
from rigidtop.motion.attitude import Floats
from rigidtop.motion.integrate import Accuracy
from rigidtop.motion.motion import Motion
from rigidtop.motion.orders import LEFT_OUT, Order, orders
from rigidtop.motion.trajectory import Trajectory
from rigidtop.motion.ways import WAYS, Ended

NUDGE = 1e-7
"""By how much a start is changed to see how a motion amplifies errors."""

ROUNDING = 1e-12
"""What rounding makes of tolerances below it, in Euler angles that pass a pole."""

LOOSEST = 1e-4
"""No bound is above this (rad): so far apart two motions are not called the same."""


@dataclass(frozen=True, eq=False)
class Certificate:
    """What came out; made by `certify`."""

    motion: Motion

    t: Floats
    """Times, shape (N,), s."""

    ways: tuple[str, ...]
    """The names of the k ways that were gone."""

    differences: Floats
    """Between two ways the largest angle from one attitude to the other, shape (k, k), in rad."""

    drifts: Mapping[str, Mapping[str, float]]
    """For each way what the motion keeps, and by how much that strays at most, relative.

    Energy and momenta are relative to what `Trajectory.drift` says; "L" is |L|, which a motion
    without torque keeps.
    """

    bound: float
    """Ways that agree differ by less (rad): see `certify`."""

    reach: float
    """What solvers whose errors all have one sign could differ by (rad); it may exceed a turn."""

    amplification: float
    """The largest factor by which the motion amplifies a small error."""

    orders: tuple[Order, ...]
    """The observed orders of the integrators."""

    left_out: Mapping[str, str]
    """Ways and integrators that were not gone, and why."""

    stray: tuple[str, ...]
    """Those of `left_out` that end where, by Euler's equations, e₃ is near no pole: wrong ones."""

    @property
    def passed(self) -> bool:
        """Whether two ways at least were gone, all agree to `bound`, and none is `stray`."""
        agree = bool(np.all(self.differences < self.bound))  # not NaN
        return len(self.ways) > 1 and agree and not self.stray

    @property
    def undecided(self) -> bool:
        """Whether they differ by more than `bound`, but no more than errors of solvers may do."""
        near = bool(np.all(self.differences < self.reach))
        return len(self.ways) > 1 and near and not self.passed and not self.stray

    @property
    def largest(self) -> float:
        """The largest difference (rad)."""
        return float(self.differences.max())


def certify(motion: Motion, t: ArrayLike, rtol: float = 1e-12) -> Certificate:
    """Compute a motion in every way that there is, and compare.

    `t` (s) is a float or a row of floats.  Solvers are asked for `rtol`, and rtol/100 absolute.

    The bound is 10 ε √(1 + n) A, at most 10⁻⁴ rad.  A solver makes an error of about ε in a step
    and a few steps a radian: ε is rtol, or 10⁻¹² if that is more, for near the poles of the Euler
    angles rounding decides.  n is the number of radians through which the motion turns,
    |ω| + √(MgR/λ) with the smallest moment, times the longest time; n errors of either sign add up
    as √n.  A is by how much the motion amplifies an error until then, found from closed forms (or
    integrations, if there are none) that start 10⁻⁷ aside, in all six directions.  So a wrong law,
    which is off by a fixed amount, does not pass, and a motion near a separatrix is not blamed for
    its nature.  Errors of one sign add up as n: what lies between is neither confirmed nor refuted.

    Raises RigidtopError for bad times and tolerances.

    >>> from rigidtop import HeavyTop
    >>> top = HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5)
    >>> found = certify(top.motion(theta=0.5, omega3=10.0), [0.5, 1.0])
    >>> found.ways, found.passed
    (('Euler', 'Lagrange', 'Routh', 'Hamilton', 'exact'), True)
    """
    times = checks.times(t)
    Accuracy(rtol=rtol)  # complains
    found: dict[str, Trajectory] = {}
    left_out: dict[str, str] = {}
    stray = []
    for name, way in WAYS.items():
        try:
            found[name] = _finite(way(motion, times, rtol))
        except RigidtopError as reason:
            left_out[name] = str(reason)
            if isinstance(reason, Ended) and not reason.confirmed(motion, times):
                left_out[name] += "; by Euler's equations e₃ is near no pole there"
                stray.append(name)
    paths = list(found.values())
    differences = np.array([[angle(one, other) for other in paths] for one in paths])
    span = float(np.abs(times).max())
    amplification = _amplification(motion, times, rtol)
    turned = motion.rate * span
    step = 10 * max(rtol, ROUNDING) * amplification
    measured, unmeasured = orders(motion)
    return Certificate(
        motion,
        times,
        tuple(found),
        differences.reshape(len(paths), len(paths)),
        {name: _drift(path) for name, path in found.items()},
        min(step * math.sqrt(1 + turned), LOOSEST),
        step * (1 + turned),
        amplification,
        measured,
        {**left_out, **unmeasured, **LEFT_OUT},
        tuple(stray),
    )


def angle(one: Trajectory, other: Trajectory) -> float:
    """The largest angle from the attitudes of one to those of the other (rad)."""
    turns: Rotation = one.rotation.inv() * other.rotation
    return float(np.max(turns.magnitude()))


def _finite(path: Trajectory) -> Trajectory:
    if not np.all(np.isfinite(path.omega)) or not np.all(np.isfinite(path.rotation.as_quat())):
        raise RigidtopError("it leaves the numbers")
    return path


def _drift(path: Trajectory) -> dict[str, float]:
    """Of energy, p_φ, p_ψ and |L|, those that the motion keeps, relative as in `drift`."""
    body, start = path.motion.body, path.motion.start()
    kinetic = float(np.dot(body.moments, np.square(path.motion.omega))) / 2
    energy = (kinetic + float(np.linalg.norm(body.weight))) or 1.0
    momentum = math.sqrt(2 * max(body.moments)) * math.sqrt(energy)
    kept: dict[str, tuple[Callable[[Trajectory], Floats], float]] = {
        "energy": (lambda path: path.energy, energy),
        "p_phi": (lambda path: path.angular_momentum[:, 2], momentum),
    }
    if body.symmetric:
        kept["p_psi"] = (lambda path: path.omega[:, 2] * body.moments[2], momentum)
    if not any(body.weight):
        kept["L"] = (lambda path: np.linalg.norm(path.angular_momentum, axis=1), momentum)
    return {
        name: float(np.max(np.abs((value(path) - value(start)) / scale)))
        for name, (value, scale) in kept.items()
    }


def _amplification(motion: Motion, times: Floats, rtol: float) -> float:
    """The largest change of the attitude at `times`, over the change of the start, at least 1."""

    def followed(attitude: Rotation, omega: Floats) -> Trajectory:
        changed = Motion(motion.body, attitude, (omega[0], omega[1], omega[2]))
        try:
            return changed.exact(times)
        except RigidtopError:
            return changed.integrate(times, rtol=rtol, atol=rtol / 100)

    omega = np.array(motion.omega)
    reference = followed(motion.attitude, omega)
    nudges = NUDGE * np.eye(3)
    nearby = [followed(motion.attitude * Rotation.from_rotvec(turn), omega) for turn in nudges]
    nearby += [followed(motion.attitude, omega + motion.rate * push) for push in nudges]
    return max(1.0, *(angle(reference, other) / NUDGE for other in nearby))
