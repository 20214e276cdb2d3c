"""One motion by laws that share no equation: they must give the same rates and attitudes.

======== ======================================================================================
way      what is held against Euler's equations
======== ======================================================================================
exact    the attitudes of the closed form, `Motion.exact`, against those of `Motion.integrate`
Lagrange θ̈, φ̈, ψ̈ from Lagrange's equations in Euler angles
Routh    θ̈, φ̇, ψ̇ from the Routhian, of a body that is symmetric about e₃
Hamilton the rates of the angles and of their momenta from Hamilton's equations
======== ======================================================================================

A law is asked for its rates at each time at which θ is clear of 0 and π, where Euler angles end: no
solver stands between one law and another.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from rigidtop.errors import RigidtopError
from rigidtop.motion import attitude as attitudes
from rigidtop.motion import checks, equations
from rigidtop.motion.attitude import Floats
from rigidtop.motion.integrate import Accuracy
from rigidtop.motion.motion import Motion
from rigidtop.motion.start import InitialState
from rigidtop.motion.trajectory import Trajectory

NUDGE = 1e-7
"""By how much a start is changed to see how a motion amplifies errors."""

ROUNDING = 1e-12
"""What rounding makes of rates, and of tolerances below it."""

LOOSEST = 1e-4
"""No bound is above this (rad): so far apart two motions are not called the same."""

POLE = 1e-3
"""Nearer than this to θ = 0 or π (sin θ) Euler angles have too few digits."""


@dataclass(frozen=True, eq=False)
class Certificate:
    """What came out; made by `certify`."""

    motion: Motion

    t: Floats
    """Times, shape (N,), s."""

    differences: Mapping[str, float]
    """The largest difference of each way from Euler's: of "exact" an angle (rad), of a law that of
    its rates times sin²θ, relative to what the motion and its body are like."""

    bounds: Mapping[str, float]
    """Ways that agree differ by less: see `certify`."""

    reach: float
    """What a solver whose errors all have one sign could differ by (rad); it may exceed a turn."""

    drifts: Mapping[str, Mapping[str, float]]
    """For "Euler" and "exact" by how much what the motion keeps strays at most, relative.

    Energy and momenta are relative to what `Trajectory.drift` says; "L" is |L|, which a motion
    without torque keeps.
    """

    left_out: Mapping[str, str]
    """Ways that were not gone, and why."""

    @property
    def strays(self) -> tuple[str, ...]:
        """The ways that differ by more than their bounds, or by no number."""
        return tuple(x for x, apart in self.differences.items() if not apart < self.bounds[x])

    @property
    def passed(self) -> bool:
        """Whether a way at least was held against Euler's, and all agree."""
        return bool(self.differences) and not self.strays

    @property
    def undecided(self) -> bool:
        """Whether only attitudes differ, and no more than the errors of the solver may do."""
        return self.strays == ("exact",) and self.differences["exact"] < self.reach


def certify(motion: Motion, t: ArrayLike, rtol: float = 1e-12) -> Certificate:
    """Hold a motion by Euler's equations against all other ways to it.

    `t` (s) is a float or a row of floats.  The solver is asked for `rtol`, and rtol/100 absolute.

    The bound of the closed form is 10 ε √(1 + n) A, at most 10⁻⁴ rad.  A solver makes an error of
    about ε in a step and a few steps a radian: ε is rtol, or 10⁻¹² if that is more.  n is the
    number of radians through which the motion turns, |ω| + √(MgR/λ) with the smallest moment, times
    the longest time; n errors of either sign add up as √n.  A is by how much the motion amplifies
    an error until then, found from closed forms that start 10⁻⁷ aside, in all six directions.  So a
    wrong law, which is off by a fixed amount, does not pass, and a motion near a separatrix is not
    blamed for its nature.  Errors of one sign add up as n: what lies between is neither confirmed
    nor refuted.  Rates differ by rounding alone, which grows with the ratio of the moments.

    Raises RigidtopError for bad times and tolerances.

    >>> from rigidtop import HeavyTop
    >>> top = HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5)
    >>> certificate = certify(top.motion(theta=0.5, omega3=10.0), [0.5, 1.0])
    >>> tuple(certificate.differences), certificate.passed
    (('exact', 'Lagrange', 'Routh', 'Hamilton'), True)
    """
    times = checks.times(t)
    Accuracy(rtol=rtol)  # complains
    path = motion.integrate(times, rtol=rtol, atol=rtol / 100)
    paths = {"Euler": path}
    differences: dict[str, float] = {}
    left_out: dict[str, str] = {}
    reach = 0.0
    ratio = max(motion.body.moments) / min(motion.body.moments)
    bounds = dict.fromkeys(LAWS, 10 * ROUNDING * ratio)
    try:
        paths["exact"] = motion.exact(times)
    except RigidtopError as reason:
        left_out["exact"] = str(reason)
    else:
        differences["exact"] = angle(path, paths["exact"])
        turned = motion.rate * float(np.abs(times).max())
        step = 10 * max(rtol, ROUNDING) * _amplification(motion, times)
        bounds["exact"], reach = min(step * math.sqrt(1 + turned), LOOSEST), step * (1 + turned)
    for name, law in LAWS.items():
        try:
            differences[name] = law(_angles(motion, path))
        except RigidtopError as reason:
            left_out[name] = str(reason)
    drifts = {name: _drift(each) for name, each in paths.items()}
    return Certificate(motion, times, differences, bounds, reach, drifts, left_out)


def angle(one: Trajectory, other: Trajectory) -> float:
    """The largest angle from the attitudes of one to those of the other (rad)."""
    turns: Rotation = one.rotation.inv() * other.rotation
    return float(np.max(turns.magnitude()))


# --- Laws -----------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Angles:
    """The Euler angles of a motion at N times, and by Euler's equations how they change."""

    motion: Motion
    theta: Floats
    psi: Floats
    velocities: Floats
    """Of θ, φ, ψ; (3, N)."""
    accelerations: Floats
    momenta: Floats
    """p_θ, p_φ, p_ψ; (3, N)."""
    forces: Floats
    """The rates of p_θ and p_ψ; (2, N)."""

    @property
    def top(self) -> tuple[float, ...]:
        """λ₁, λ₃, M, g, R; M and g occur in nothing but MgR, which `weight` is."""
        body = self.motion.body
        return body.moments[0], body.moments[2], 1.0, 1.0, body.weight[2]

    @property
    def body(self) -> tuple[float, ...]:
        """λ₁, λ₂, λ₃, M, g, R₁, R₂, R₃."""
        return *self.motion.body.moments, 1.0, 1.0, *self.motion.body.weight

    def apart(self, *pairs: tuple[object, Floats, float]) -> float:
        """The largest difference between rates of a law and Euler's, in a unit, times sin²θ."""
        return max(
            float(np.max(np.abs(np.array(rates) - right) * np.sin(self.theta) ** 2)) / unit
            for rates, right, unit in pairs
        )


def _angles(motion: Motion, path: Trajectory) -> _Angles:
    """RigidtopError where e₃ is near a pole at all times."""
    q, body = attitudes.quaternions(path.rotation), motion.body
    theta = attitudes.polar_angle(*attitudes.spinors(q.T))
    clear = np.sin(theta) > POLE
    if not np.any(clear):
        raise RigidtopError(f"sin θ stays below {POLE:g}: Euler angles are not defined there")
    q, omega, theta = q[clear].T, path.omega[clear].T, theta[clear]
    alpha, beta = attitudes.spinors(q)
    psi = np.angle(alpha) - np.angle(beta)
    turned = np.array(equations.heavy_body(*body.moments, 1.0, 1.0, *body.weight)([*q, *omega])[4:])
    moments = np.array(body.moments)[:, None]
    L, torque = moments * omega, moments * turned

    sine, cosine = np.sin(theta), np.cos(theta)
    theta_dot, across = attitudes.to_nodes(omega[0], omega[1], psi, np)
    phi_dot = across / sine
    psi_dot = omega[2] - phi_dot * cosine
    # The nodes turn with ψ̇ against the body.
    along, beside = attitudes.to_nodes(turned[0], turned[1], psi, np)
    phi_ddot = (beside + (psi_dot - phi_dot * cosine) * theta_dot) / sine
    psi_ddot = turned[2] - phi_ddot * cosine + phi_dot * theta_dot * sine
    p_theta, p_across = attitudes.to_nodes(L[0], L[1], psi, np)
    force = attitudes.to_nodes(torque[0], torque[1], psi, np)[0] - psi_dot * p_across
    return _Angles(
        motion,
        theta,
        psi,
        np.array([theta_dot, phi_dot, psi_dot]),
        np.array([along - psi_dot * across, phi_ddot, psi_ddot]),
        np.array([p_theta, p_across * sine + L[2] * cosine, L[2]]),
        np.array([force, torque[2]]),
    )


def _lagrange(at: _Angles) -> float:
    if at.motion.body.symmetric:
        rates = equations.top_in_euler_angles(*at.top, sin=np.sin, cos=np.cos)
        law = rates([at.theta, *at.velocities])
    else:
        rates = equations.body_in_euler_angles(*at.body, sin=np.sin, cos=np.cos)
        law = rates([at.theta, at.psi, *at.velocities])
    return at.apart((law, at.accelerations, (at.motion.rate or 1.0) ** 2))


def _routh(at: _Angles) -> float:
    if not at.motion.body.symmetric:
        raise RigidtopError("ψ is not cyclic: the body has no symmetry about e₃")
    rates = equations.top_by_routh(*at.top, *at.momenta[1:], sin=np.sin, cos=np.cos)
    theta_ddot, *velocities = rates([at.theta])
    unit = at.motion.rate or 1.0
    return at.apart(
        (theta_ddot, at.accelerations[0], unit**2), (velocities, at.velocities[1:], unit)
    )


def _hamilton(at: _Angles) -> float:
    p_theta, p_phi, p_psi = at.momenta
    if at.motion.body.symmetric:
        rates = equations.top_by_hamilton(*at.top, p_phi, p_psi, sin=np.sin, cos=np.cos)
        law = rates([at.theta, p_theta])
    else:
        rates = equations.body_by_hamilton(*at.body, p_phi, sin=np.sin, cos=np.cos)
        law = rates([at.theta, at.psi, p_theta, p_psi])
    unit, forces = at.motion.rate or 1.0, law[3:]
    return at.apart(
        (law[:3], at.velocities, unit),
        (forces, at.forces[: len(forces)], max(at.motion.body.moments) * unit**2),
    )


LAWS: Mapping[str, Callable[[_Angles], float]] = MappingProxyType(
    {"Lagrange": _lagrange, "Routh": _routh, "Hamilton": _hamilton}
)


# --- Attitudes ------------------------------------------------------------------------------------


def _drift(path: Trajectory) -> dict[str, float]:
    """The drifts of energy, p_φ, p_ψ and |L|, as far as the motion keeps them; see `drift`."""
    body, start = path.motion.body, path.motion.start()
    energy, momentum = path.scales
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


def _amplification(motion: Motion, times: Floats) -> float:
    """The largest change of the attitude at `times`, over the change of the start, at least 1."""

    def followed(attitude: Rotation, omega: Floats) -> Trajectory:
        start = InitialState(attitude, (omega[0], omega[1], omega[2]))
        return Motion(motion.body, start).exact(times)

    omega = np.array(motion.omega)
    reference = followed(motion.attitude, omega)
    nudges = NUDGE * np.eye(3)
    nearby = [followed(motion.attitude * Rotation.from_rotvec(turn), omega) for turn in nudges]
    nearby += [followed(motion.attitude, omega + motion.rate * push) for push in nudges]
    return max(1.0, *(angle(reference, other) / NUDGE for other in nearby))
