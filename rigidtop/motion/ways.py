"""The ways to one motion: laws that share no equation.

======== ======================================================================================
way      what is solved
======== ======================================================================================
Euler    L̇ + ω × L = N and q̇ = ½ q∘ω, attitude as a quaternion: `Motion.integrate`
Lagrange θ̈, φ̈, ψ̈ from Lagrange's equations in Euler angles
Routh    θ̈ from the Routhian, p_φ and p_ψ constant; φ and ψ by Gauss's quadrature along it
Hamilton the angles and their momenta from Hamilton's equations
exact    the closed form: `Motion.exact`
======== ======================================================================================

Routh's way needs a body that is symmetric about e₃.  In Euler angles a motion through θ = 0 or π
has no equations: that way is left out, with the time at which it ends.  The space frame of a free
body without symmetry is no one's choice, so it is turned to where e₃ keeps clear of its poles.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

import numpy as np
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from rigidtop.errors import RigidtopError
from rigidtop.motion import attitude as attitudes
from rigidtop.motion import equations
from rigidtop.motion.attitude import Floats
from rigidtop.motion.integrate import SMALLEST_RTOL, Flow, on_both_sides
from rigidtop.motion.motion import Motion, TopMotion
from rigidtop.motion.trajectory import BodyTrajectory, Trajectory

POLE = 1e-3
"""Nearer than this to θ = 0 or π (sin θ) the terms with 1/sin²θ leave too few digits."""

GAUSS_NODES = 8
"""Exact for polynomials of degree 15 on each piece of a step: more than the solver's own 7."""

PIECES = 4
"""Of a step of the solver, for the quadrature."""

DIRECTIONS = 200
"""Candidates for the pole of the space frame of a free body."""

SAMPLES = 2000
"""Of the way of e₃, to find the one that it keeps away from."""

Way = Callable[[Motion, Floats, float], Trajectory]


def by_euler(motion: Motion, times: Floats, rtol: float) -> Trajectory:
    """Euler's equations with torque, on quaternions."""
    return motion.integrate(times, rtol=rtol, atol=rtol / 100)


def in_closed_form(motion: Motion, times: Floats, _: float) -> Trajectory:
    """The exact motion."""
    return motion.exact(times)


def by_lagrange(motion: Motion, times: Floats, rtol: float) -> Trajectory:
    """Lagrange's equations: state θ, φ, ψ, θ̇, φ̇, ψ̇."""
    start = _start(motion, times)
    if motion.body.symmetric:
        rates, at = equations.top_in_euler_angles(*_top(motion)), [0, 3, 4, 5]
    else:
        rates, at = equations.body_in_euler_angles(*_body(motion)), [0, 2, 3, 4, 5]

    def right_hand_side(state: Sequence[float]) -> tuple[float, ...]:
        return *state[3:], *rates([state[k] for k in at])

    first = np.array([*start.angles, *start.velocities])
    units = np.repeat([1.0, motion.rate or 1.0], 3)
    states = _solved(right_hand_side, first, times, rtol, units)
    return start.trajectory(motion, times, states[:3], states[3:])


def by_hamilton(motion: Motion, times: Floats, rtol: float) -> Trajectory:
    """Hamilton's equations: state θ, φ, ψ, p_θ and, without symmetry, p_ψ; p_φ is constant."""
    start = _start(motion, times)
    p_theta, p_phi, p_psi = start.momenta
    if motion.body.symmetric:
        law = _laws(equations.top_by_hamilton, *_top(motion), p_phi, p_psi)
        at, moving = [0, 3], [p_theta]
    else:
        law = _laws(equations.body_by_hamilton, *_body(motion), p_phi)
        at, moving = [0, 2, 3, 4], [p_theta, p_psi]
    rates, over_arrays = law
    first = np.array([*start.angles, *moving])
    units = np.full(len(first), max(motion.body.moments) * (motion.rate or 1.0))
    units[:3] = 1.0

    def right_hand_side(state: Sequence[float]) -> tuple[float, ...]:
        return rates([state[k] for k in at])

    states = _solved(right_hand_side, first, times, rtol, units)
    velocities = np.array(over_arrays(list(states[at]))[:3])
    return start.trajectory(motion, times, states[:3], velocities)


def by_routh(motion: Motion, times: Floats, rtol: float) -> Trajectory:
    """θ from the Routhian: state θ, θ̇; then φ and ψ as integrals of functions of θ."""
    if not motion.body.symmetric:
        raise RigidtopError("ψ is not cyclic: the body has no symmetry about e₃")
    start = _start(motion, times)
    rates, over_arrays = _laws(equations.top_by_routh, *_top(motion), *start.momenta[1:])
    theta, phi, psi = start.angles

    def right_hand_side(state: Sequence[float]) -> tuple[float, ...]:
        return state[1], rates(state[:1])[0]

    def sample(motion: Flow, ordered: Floats) -> Floats:
        def precession_and_spin(times: Floats) -> Floats:
            return np.array(over_arrays(list(motion.path(times)[:1]))[1:])

        integrals = _quadrature(precession_and_spin, motion.steps, ordered)
        return np.concatenate([motion.path(ordered), integrals])

    first = np.array([theta, start.velocities[0]])
    units = np.array([1.0, motion.rate or 1.0])
    states = _solved(right_hand_side, first, times, rtol, units, sample)
    angles = np.stack([states[0], phi + states[2], psi + states[3]])
    velocities = np.stack([states[1], *over_arrays(list(states[:1]))[1:]])
    return start.trajectory(motion, times, angles, velocities)


def _laws(
    shipped: Callable[..., equations.Rates], *parameters: float
) -> tuple[equations.Rates, equations.Rates]:
    """A right-hand side of floats, and of arrays."""
    return shipped(*parameters), shipped(*parameters, sin=np.sin, cos=np.cos)


WAYS: Mapping[str, Way] = MappingProxyType(
    {
        "Euler": by_euler,
        "Lagrange": by_lagrange,
        "Routh": by_routh,
        "Hamilton": by_hamilton,
        "exact": in_closed_form,
    }
)


# --- Euler angles ---------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Start:
    """A motion's start in Euler angles, in a frame that is turned against the space frame."""

    frame: Rotation
    """From the frame in which the angles are to the space frame."""

    angles: tuple[float, float, float]
    velocities: tuple[float, float, float]
    momenta: tuple[float, float, float]
    """θ, φ, ψ; their rates; p_θ, p_φ, p_ψ."""

    def trajectory(
        self, motion: Motion, times: Floats, angles: Floats, velocities: Floats
    ) -> Trajectory:
        """From θ, φ, ψ (3, N) and their rates (3, N)."""
        theta, phi, psi = angles
        theta_dot, phi_dot, psi_dot = velocities
        turned = attitudes.from_spinors(np.cos(theta / 2), np.sin(theta / 2), phi, psi)
        omega = [
            *attitudes.from_nodes(theta_dot, phi_dot * np.sin(theta), psi, np),
            psi_dot + phi_dot * np.cos(theta),
        ]
        rotation = self.frame * attitudes.rotation(turned)
        return BodyTrajectory(motion, times, attitudes.quaternions(rotation), np.stack(omega, 1))


def _start(motion: Motion, times: Floats) -> _Start:
    """RigidtopError where there are no Euler angles."""
    frame = _frame(motion, times)
    attitude = frame.inv() * motion.attitude
    theta = float(attitudes.polar_angle(*attitudes.spinors(attitudes.quaternions(attitude))))
    if math.sin(theta) < POLE:
        raise _at_pole(theta, 0.0)
    phi, psi = attitudes.azimuth_and_spin(attitude, motion.omega)
    sine, cosine = math.sin(theta), math.cos(theta)
    theta_dot, v_phi = attitudes.to_nodes(*motion.omega[:2], psi)
    velocities = theta_dot, v_phi / sine, motion.omega[2] - v_phi / sine * cosine
    L1, L2, L3 = (
        moment * rate for moment, rate in zip(motion.body.moments, motion.omega, strict=True)
    )
    p_theta, across = attitudes.to_nodes(L1, L2, psi)
    return _Start(frame, (theta, phi, psi), velocities, (p_theta, across * sine + L3 * cosine, L3))


def _top(motion: Motion) -> tuple[float, ...]:
    """λ₁, λ₃, M, g, R; M and g occur in nothing but the product M g R, which `weight` is."""
    return motion.body.moments[0], motion.body.moments[2], 1.0, 1.0, motion.body.weight[2]


def _body(motion: Motion) -> tuple[float, ...]:
    """λ₁, λ₂, λ₃, M, g, R₁, R₂, R₃."""
    return *motion.body.moments, 1.0, 1.0, *motion.body.weight


def _frame(motion: Motion, times: Floats) -> Rotation:
    """The space frame, but for a free body one whose z-axis e₃ never comes near."""
    if any(motion.body.weight) or isinstance(motion, TopMotion):
        return Rotation.identity()
    first, last = min(0.0, float(times.min())), max(0.0, float(times.max()))
    e3 = motion.exact(np.linspace(first, last, SAMPLES)).e3
    # Points on half a sphere along a spiral, evenly: at the golden angle from one to the next.
    k = np.arange(DIRECTIONS)
    polar, azimuth = np.arccos((k + 0.5) / DIRECTIONS), k * math.pi * (3 - math.sqrt(5))
    poles = np.stack(
        [np.sin(polar) * np.cos(azimuth), np.sin(polar) * np.sin(azimuth), np.cos(polar)]
    )
    best = int(np.argmin(np.max(np.abs(e3 @ poles), axis=0)))
    return attitudes.from_euler_angles(float(polar[best]), float(azimuth[best]), 0.0)


class Ended(RigidtopError):  # noqa: N818 - it says what happened
    """A way in Euler angles ends before the last time."""

    def __init__(self, message: str, time: float) -> None:
        super().__init__(message)
        self.time = time

    def confirmed(self, motion: Motion, times: Floats) -> bool:
        """Whether e₃ is there near a pole by Euler's equations on quaternions too."""
        e3 = motion.integrate(self.time).e3[0]
        z = _frame(motion, times).apply([0.0, 0.0, 1.0])
        return float(np.linalg.norm(np.cross(e3, z))) < 2 * POLE


def _at_pole(theta: float, time: float) -> Ended:
    pole = "0" if math.cos(theta) > 0 else "π"
    near = f"θ comes within {POLE:g} of {pole} at t = {time:.6g}"
    return Ended(f"{near}: Euler angles are not defined there", time)


# --- Solving --------------------------------------------------------------------------------------


def _solved(
    rates: equations.Rates,
    first: Floats,
    times: Floats,
    rtol: float,
    units: Floats,
    sample: Callable[[Flow, Floats], Floats] = lambda flow, ordered: flow.path(ordered),
) -> Floats:
    """The states at `times` from `first`, whose component 0 is θ; `units` are their sizes.

    RigidtopError where θ reaches a pole or the solver stops.
    """
    # φ and ψ, components 1 and 2 where there are so many, grow without an end: a tolerance relative
    # to them would be none.
    relative = np.full(len(first), rtol)
    if len(first) > 2:
        relative[1:3] = SMALLEST_RTOL

    def right_hand_side(time: float, state: Floats) -> tuple[float, ...]:
        try:
            return rates(state.tolist())
        except ArithmeticError:  # 1/sin θ
            raise _at_pole(float(state[0]), time) from None

    def clearance(_: float, state: Floats) -> float:
        return math.sin(state[0]) - POLE  # negative beyond the pole too: no step jumps over it

    clearance.terminal = True  # type: ignore[attr-defined]

    def flow(end: float) -> Flow:
        solution = solve_ivp(
            right_hand_side,
            (0.0, end),
            first,
            method="DOP853",
            rtol=relative,
            atol=rtol / 100 * units,
            dense_output=True,
            events=clearance,
        )
        time, theta = float(solution.t[-1]), float(solution.y[0, -1])
        if solution.status == 1:
            raise _at_pole(theta, time)
        if solution.sol is None or solution.status < 0 or not np.all(np.isfinite(solution.y)):
            raise Ended(f"the solver stops at t = {time:.6g}, θ = {theta:.6g}", time)
        between = _between(solution.t)
        passed = np.flatnonzero(np.sin(solution.sol(between)[0]) < POLE)
        if len(passed):  # there and back in one step
            raise _at_pole(float(solution.sol(between[passed[0]])[0]), float(between[passed[0]]))
        return Flow(solution.sol, solution.t)

    return on_both_sides(flow, first, times, sample)


def _between(steps: Floats) -> Floats:
    """The steps, each cut into `PIECES`."""
    inner = steps[:-1, None] + np.diff(steps)[:, None] * np.arange(PIECES) / PIECES
    return np.concatenate([inner.ravel(), steps[-1:]])


def _quadrature(f: Callable[[Floats], Floats], steps: Floats, times: Floats) -> Floats:
    """∫ f dt from 0 to each of `times`, which increase in magnitude; f is smooth in each step.

    f takes times (N,) and gives (n, N).

    >>> _quadrature(lambda t: np.stack([np.cos(t), t]), np.array([0.0, 1.0]), np.array([0.5, 1.0]))
    array([[0.47942554, 0.84147098],
           [0.125     , 0.5       ]])
    """
    direction = -1.0 if times[-1] < 0 else 1.0
    nodes = direction * np.unique(np.abs(np.concatenate([_between(steps), times])))
    points, weights = np.polynomial.legendre.leggauss(GAUSS_NODES)
    half = np.diff(nodes) / 2
    at = (nodes[:-1] + half)[:, None] + half[:, None] * points
    values = f(at.ravel())
    pieces = np.sum(values.reshape(len(values), *at.shape) * weights, axis=2) * half
    total = np.cumsum(np.pad(pieces, ((0, 0), (1, 0))), axis=1)
    return total[:, np.searchsorted(np.abs(nodes), np.abs(times))]
