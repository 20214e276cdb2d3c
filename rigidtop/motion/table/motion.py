"""A symmetric top with a round tip on a table: friction moves its contact and takes its energy.

The moments are those about the **centre of mass**: `HeavyTop` has them about the pivot, λ₁ + MR².
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rigidtop.errors import RigidtopError
from rigidtop.motion import attitude as attitudes
from rigidtop.motion import checks
from rigidtop.motion.attitude import Floats
from rigidtop.motion.integrate import TAYLOR, Accuracy, on_both_sides, with_angles
from rigidtop.motion.rigid import Pair, Triple
from rigidtop.motion.start import AnyStart, Moving, from_angles
from rigidtop.motion.state import TopState, of_frame, of_start, spinning
from rigidtop.motion.table import smooth
from rigidtop.motion.table.contact import VARIABLES, Contact, Sliding
from rigidtop.motion.table.phases import Course, Event, course, ending
from rigidtop.motion.table.trajectory import SlidingTrajectory


@dataclass(frozen=True, kw_only=True)
class SlidingTop(Sliding):
    """A symmetric top that stands with a round tip on a horizontal table, in gravity g > 0 (m/s²).

    λ₁ = λ₂ and λ₃ are moments about the **centre of mass** (kg m²), not about a pivot.  M is the
    mass (kg), R > 0 the distance of the centre of mass from the lowest point of the upright top
    (m).  The tip is part of a sphere of radius `tip` = r ≥ 0 (m), its centre on the axis at R − r
    below the centre of mass; r > R puts the centre of mass below it, as in a tippe top.

    The table pushes with N upwards and rubs with F = −(μN/|v| + γ) v against the slip v of the
    contact: `mu` = μ ≥ 0 is Coulomb's coefficient, sliding and static, `viscosity` = γ ≥ 0 that of
    viscous friction (N s/m).  It exerts no torque at the contact.  The air pulls the centre of mass
    with −c V and turns against ω with −(c₁ω₁, c₁ω₂, c₃ω₃): `drag` = c (N s/m), `drag1` and `drag3`
    (N m s).  At θ = `fall` the body touches the table with more than its tip (π: it never does).

    Raises RigidtopError for what no such body can have, as λ₃ > 2λ₁.

    >>> top = SlidingTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5, tip=0.1, mu=0.3)
    >>> run = top.motion(theta=0.3, omega3=60.0).integrate([0.0, 5.0])
    >>> bool(run.theta[1] < 0.3), run.budget() < 1e-8        # friction raises a fast top
    (True, True)
    """

    def __post_init__(self) -> None:
        checks.settle(self, checks.positive, "lambda1", "lambda3", "M", "R", "g")
        checks.settle(self, checks.not_negative, "tip", "mu", "viscosity", "drag", "drag1", "drag3")
        checks.settle(self, checks.number, "fall")
        if not 0 < self.fall <= math.pi:
            raise RigidtopError(
                f"fall must be an angle of more than 0 and at most pi radians, not {self.fall:g}"
            )
        if not checks.triangle(self.moments, max(self.moments)):
            raise RigidtopError(
                f"lambda3 = {self.lambda3:g} exceeds 2 lambda1 = {2 * self.lambda1:g}: no body has "
                "such moments about its centre of mass, which are meant here"
            )

    @property
    def moments(self) -> Triple:
        """λ₁, λ₁, λ₃ about the centre of mass (kg m²)."""
        return self.lambda1, self.lambda1, self.lambda3

    @property
    def smooth(self) -> bool:
        """Whether nothing takes energy: neither friction nor air."""
        return not any((self.mu, self.viscosity, self.drag, self.drag1, self.drag3))

    def motion(
        self,
        *,
        theta: float,
        theta_dot: float = 0.0,
        phi: float = 0.0,
        phi_dot: float = 0.0,
        psi: float = 0.0,
        psi_dot: float | None = None,
        omega3: float | None = None,
        velocity: Sequence[float] | None = None,
        slip: Sequence[float] | None = None,
    ) -> SlidingMotion:
        """The motion from Euler angles and rates at t = 0, the centre of mass above the origin.

        R = Rz(φ) Ry(θ) Rz(ψ) takes body components to space components; 0 ≤ θ < `fall`.  The spin
        is `psi_dot` or `omega3` = ψ̇ + φ̇ cos θ.  `velocity` is that of the centre of mass along x̂
        and ŷ, (0, 0) unless given (m/s); or `slip` that of the contact, of which (0, 0) lets the
        tip start at rest on the table.  Radians and rad/s.

        Raises RigidtopError for anything else.

        >>> top = SlidingTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5)
        >>> top.motion(theta=0.5, omega3=40.0, phi_dot=1.0, slip=(0.0, 0.0)).velocity.round(6) + 0.0
        array([0.      , 0.239713])
        """
        missing = "give theta and the spin, as omega3 or psi_dot"
        angles = theta, theta_dot, phi, phi_dot, psi, psi_dot, omega3
        start = from_angles(missing, *angles)
        if velocity is not None and slip is not None:
            raise RigidtopError("give velocity (of the centre of mass) or slip, not both")
        if start.theta >= self.fall and self.fall < math.pi:
            raise RigidtopError(
                f"theta = {start.theta:g} is no start: the top lies on the table from "
                f"fall = {self.fall:g}"
            )
        if slip is not None:
            return SlidingMotion(self, start, checks.pair("slip", slip))
        wanted = (0.0, 0.0) if velocity is None else checks.pair("velocity", velocity)
        without = _without_slip(self, start)
        return SlidingMotion(self, start, (wanted[0] - without[0], wanted[1] - without[1]))


def _without_slip(body: SlidingTop, start: AnyStart) -> Pair:
    """The velocity of the centre of mass along x̂ and ŷ, −ω × ρ, if the contact does not slip."""
    state = [*attitudes.quaternions(start.attitude).tolist(), *start.omega, 0.0, 0.0]
    kinematics = Contact(body).kinematics(state)
    return float(kinematics[3]), float(kinematics[4])


@dataclass(frozen=True, eq=False)
class SlidingMotion(Moving):
    """The motion of a top on a table from its initial state; made by `SlidingTop.motion`."""

    body: SlidingTop

    slip: Pair
    """Velocity of the contact over the table at t = 0 (m/s)."""

    @property
    def velocity(self) -> Floats:
        """The velocity of the centre of mass along x̂ and ŷ at t = 0, shape (2,), in m/s."""
        return np.array(_without_slip(self.body, self.initial)) + self.slip

    def start(self) -> SlidingTrajectory:
        """The initial state, as a trajectory of one row."""
        contact, table = Contact(self.body), np.zeros((6, 1))
        table[:2, 0] = self.slip
        rolling = not any(self.slip) and contact.holds(self._initial())
        state = of_start(self.initial, self.body)
        return self._trajectory(np.zeros(1), state, table, np.array([rolling]))

    def exact(self, t: ArrayLike) -> SlidingTrajectory:
        """The motion on a smooth table without air at the times `t`, in closed form.

        `t` (s) is a float or a row of N floats in any order, also negative.  The nutation is one
        quadrature, whose integrand is smooth over a period and so a Fourier series to rounding;
        then a late time costs what an early one costs.

        Raises RigidtopError where friction or air take energy, where the top would fall or leave
        the table, and where it comes so near to the vertical without going through it, or to a
        motion without period, that the series does not converge: integrate those.
        """
        body = self.body
        if not body.smooth:
            raise RigidtopError(
                "no closed form: friction or air take energy; integrate the motion, or leave mu, "
                "viscosity and drag out"
            )
        times = checks.times(t)
        start = self.start()
        orbit = smooth.solve(
            lambda1=body.lambda1,
            lambda3=body.lambda3,
            M=body.M,
            g=body.g,
            h=body.R - body.tip,
            theta=float(start.theta[0]),
            theta_dot=float(start.theta_dot[0]),
            v_phi=float(start.v_phi[0]),
            omega3=self.omega[2],
        )
        if orbit.turning_points[1] >= body.fall:
            raise RigidtopError(
                f"no closed form: the top falls, its theta reaches fall = {body.fall:g}; "
                "integrate the motion"
            )
        if orbit.smallest_normal_force <= 0:
            raise RigidtopError(
                "no closed form: the top leaves the table in the course of its nutation; "
                "integrate the motion"
            )
        at = orbit.at(times)
        state = TopState(
            cos_half=np.cos(at.theta / 2),
            sin_half=np.sin(at.theta / 2),
            phi=self.phi + at.phi,
            psi=self.psi + at.psi,
            theta_dot=at.theta_dot,
            v_phi=at.v_phi,
            **spinning(body, self.omega[2]),
        )
        velocity, table = self.velocity, np.zeros((6, len(times)))
        table[2:4] = velocity[:, None] * times
        trajectory = self._trajectory(times, state, table, np.zeros(len(times), dtype=bool))
        # Without slip the velocity would be −ω × ρ.
        return replace(trajectory, slip=velocity - trajectory.velocity[:, :2])

    def integrate(
        self, t: ArrayLike, method: str = "DOP853", rtol: float = 1e-10, atol: float = 1e-12
    ) -> SlidingTrajectory:
        """The motion at the times `t` ≥ 0, integrated from the initial state at t = 0.

        `t` (s) is a float or a row of N floats in any order.  `method` is one of
        `scipy.integrate.solve_ivp`; an implicit one, "Radau", where viscous friction is strong.
        `rtol` and `atol` are tolerances for one step, the absolute one in units of 1 for the unit
        quaternion and the turn about e₃, √(g/R) for ω, R for lengths, √(gR) for the slip and MgR
        for what is dissipated.

        The trajectory has one row for each time that the motion reaches.  A motion ends where the
        top falls (θ = `fall`) or lifts off (N = 0): **later times have no row**, and
        `SlidingTrajectory.ended` says why.

        Raises RigidtopError for times that are negative, not finite, too late, or all after the
        end; for an unknown method or tolerance; where the top does not stay on the table from the
        start; where friction jams it (Painlevé); and when the solver gives up.
        """
        times = self._times(t)
        if method == TAYLOR:
            raise RigidtopError(
                "Taylor series do not see friction change: use another method, such as DOP853"
            )
        accuracy = Accuracy(method, rtol, atol)
        contact, start, last = Contact(self.body), np.array(self._initial()), float(times.max())
        run = course(contact, start.tolist(), last, accuracy) if last else Course((), ())
        end = ending(run.events)
        if end is not None:
            times = times[times <= end.time]
            if len(times) == 0:
                raise RigidtopError(
                    f"the motion ends at t = {end.time:g} ({end.kind}): ask for earlier times"
                )
        spin, angles = spinning(self.body, self.omega[2]), self.initial.angles
        states = on_both_sides(
            lambda _: run.flow,
            start,
            times,
            lambda motion, ordered: with_angles(motion, ordered, angles, spin),
        )
        omega3, turn = states[6], states[9]
        state = of_frame(states[:6], states[VARIABLES:], turn, spinning(self.body, omega3))
        rolling = run.rolling(times) if last else np.repeat(self.start().rolling, len(times))
        table = states[[7, 8, 10, 11, 12, 13]]
        return self._trajectory(times, state, table, rolling, run.events)

    def _times(self, t: ArrayLike) -> Floats:
        rate = math.hypot(*self.omega) + math.sqrt(self.body.g / self.body.R)
        times = checks.times_within_reach(t, rate)
        if times.min() < 0:
            raise RigidtopError(
                f"t must not be negative, as {times.min():g}: what friction has done has no past"
            )
        return times

    def _initial(self) -> list[float]:
        q = attitudes.quaternions(self.attitude).tolist()
        return [*q, *self.omega, *self.slip, *[0.0] * (VARIABLES - 9)]

    def _trajectory(
        self,
        times: Floats,
        state: TopState,
        table: Floats,
        rolling: NDArray[np.bool_],
        events: tuple[Event, ...] = (),
    ) -> SlidingTrajectory:
        """The trajectory with what happens on the table: slip, place, dissipation, (6, N)."""
        return SlidingTrajectory(
            motion=self,
            t=times,
            **vars(state),
            slip=table[:2].T,
            centre=table[2:4].T,
            dissipated_by_friction=table[4],
            dissipated_by_air=table[5],
            rolling=rolling,
            events=events,
        )
