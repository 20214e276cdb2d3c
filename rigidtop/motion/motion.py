"""A motion: a body, and its attitude and rotational velocity at t = 0."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, fields
from functools import cached_property, partial

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from rigidtop.errors import RigidtopError
from rigidtop.motion import attitude as attitudes
from rigidtop.motion import checks, closed, systems, taylor
from rigidtop.motion.attitude import Floats
from rigidtop.motion.exact import free, heavy, heavy_orbit, samples
from rigidtop.motion.integrate import (
    TAYLOR,
    Accuracy,
    Flow,
    Flows,
    counted_angles,
    flow,
    on_both_sides,
)
from rigidtop.motion.rigid import RigidBody, SymmetricTop
from rigidtop.motion.start import Start
from rigidtop.motion.state import TopState, of_spinors, spinning
from rigidtop.motion.trajectory import BodyTrajectory, SampledTop, TopTrajectory, Trajectory
from rigidtop.trace import Solved


@dataclass(frozen=True, eq=False)
class Motion:
    """The motion of a free or heavy body from its initial state; made by the body's `motion`."""

    body: RigidBody

    attitude: Rotation
    """At t = 0, body components to space components."""

    omega: tuple[float, float, float]
    """Rotational velocity at t = 0, body components, rad/s."""

    def __post_init__(self) -> None:
        checks.single_rotation(self.attitude)
        object.__setattr__(self, "omega", checks.vector("omega", self.omega))

    def __getstate__(self) -> dict[str, object]:
        """What a copy in another process needs: it writes out the closed form anew."""
        return {name: value for name, value in vars(self).items() if name != "solved"}

    def start(self) -> Trajectory:
        """The initial state, as a trajectory of one row."""
        return BodyTrajectory(self, np.zeros(1), *self._attitudes(self._initial(), np.zeros(1)))

    def exact(self, t: ArrayLike, compiled: bool = False) -> Trajectory:
        """The motion at the times `t`, in closed form.

        `t` (s) is a float or a row of N floats in any order, also negative; the result has one row
        for each.  A late time costs what an early one costs.

        `compiled` computes many times by Numba (``pip install 'rigidtop[numba]'``): a few times
        as fast, with the same errors.  The first such call of a process compiles, for some seconds,
        one for heavy bodies and one for free ones.

        The error is a few units in the last place of what the motion does when the initial state,
        the body and t change by theirs, near separatrices, poles and steady precession too, and of
        a small tilt it is relative to the tilt, down to 1e-50.  A deviation of less than 1e-140
        from a separatrix counts as none: such a top stays upright.

        Beside a separatrix, by less than the last digit of the initial state, it is the motion of
        an initial state that differs by so little.

        Closed forms exist for every free body, for a heavy body with two equal moments and its
        centre of mass on the axis of the third, and for one with three equal moments.  Raises
        RigidtopError for other bodies, for times that are not finite, and without Numba if
        `compiled` asks for it.
        """
        times = checks.times(t)
        return BodyTrajectory(
            self, times, *closed.states(self.solved, self.body, self.attitude, times, compiled)
        )

    def integrate(
        self, t: ArrayLike, method: str = "DOP853", rtol: float = 1e-10, atol: float = 1e-12
    ) -> Trajectory:
        """The motion at the times `t`, integrated from the initial state at t = 0.

        `t` (s) is a float or a row of N floats in any order, also negative; the result has one row
        for each, in that order.  `method` is one of `scipy.integrate.solve_ivp`, or
        "taylor", the Taylor series of heyoka (``pip install 'rigidtop[taylor]'``).

        `rtol` and `atol` are its tolerances for one step, on the components of the unit quaternion
        and of ω (rad/s): rtol |x| + atol s for a component x.  The size s is 1, but for a symmetric
        body s is less where less moves, so that a small motion is as accurate, relative to itself,
        as a large one.  It is the larger of sin θ and |(ω₁, ω₂)|/ν, at most 1, with
        ν = λ₃|ω₃|/λ₁ + √(MgR/λ₁) + |(ω₁, ω₂)|: how far the axis is from the vertical, or soon will
        be.  For ω of a free body it is |(ω₁, ω₂)|, at most 1.  A small motion about the vertical of
        a heavy body without symmetry is resolved to `atol`, and needs a smaller one.

        s follows a motion that grows, and not one that shrinks: what is small only in passing has
        the errors of the large motion around it.

        For "taylor" `rtol`, down to 2.3e-16, bounds what a step leaves out of the series, relative
        to 1 in the quaternion and to a rate of the motion (1/s) in ω; steps are short enough for
        small motions to be as accurate, relative to themselves.  `atol` plays no part.

        Raises RigidtopError for times that are not finite or too late, for an unknown method, for
        tolerances that are zero or above 0.1, when they turn out too coarse, and, with the solver's
        message, when the solver does not reach the last time.
        """
        times = self._times(t)
        states = on_both_sides(
            self._flows(Accuracy(method, rtol, atol)),
            self._initial(),
            times,
            lambda motion, ordered: motion.path(ordered),
        )
        return BodyTrajectory(self, times, *self._attitudes(states, times))

    @cached_property
    def solved(self) -> Solved:
        """The closed form, for one time."""
        return closed.solved(self.body, self.attitude, self.omega)

    @property
    def orbit(self) -> free.Orbit | heavy_orbit.Orbit:
        """The closed form: its periods, its turning points and its state at any times."""
        found: free.Orbit | heavy_orbit.Orbit = self.solved.orbit
        return found

    @property
    def regime(self) -> str:
        """What kind of motion it is, to rounding of the initial state.

        Of a free body: "short axis" or "long axis" (the largest or the smallest moment's, about
        which ω circles in the body), "separatrix", "regular precession" (two equal moments) or
        "steady" (ω constant).  Of a heavy symmetric body: "sleeping" and "hanging" (at rest, the
        centre of mass above or below the pivot), "free precession" (no weight), "steady",
        "asymptotic" (to the upright), "plane" (a pendulum), "through the vertical", "waves",
        "cusps", "loops".
        """
        return str(self.orbit.regime)

    @property
    def turning_points(self) -> tuple[float, float]:
        """The smallest and the largest θ (rad).

        Of a top θ is the angle between e₃ and the vertical, of another heavy body that between the
        vertical and the direction to its centre of mass; of a free body that between L and the
        principal axis about which ω circles, towards the side on which it is.
        """
        smallest, largest = (float(angle) for angle in self.orbit.turning_points)
        below = self.body.symmetric and self.body.weight[2] < 0  # e₃ points away from the centre
        return (math.pi - largest, math.pi - smallest) if below else (smallest, largest)

    @property
    def nutation_period(self) -> float:
        """The time from one smallest θ to the next (s).

        Where θ is constant, that of a small nutation; infinite where there is no next.
        """
        return float(self.orbit.nutation_period)

    @property
    def precession_per_period(self) -> float:
        """The angle by which the axis turns about the vertical, or about L, in that time (rad)."""
        return float(self.orbit.precession_per_period)

    @property
    def mean_precession(self) -> float:
        """The mean rate of that turning (rad/s).

        Where the axis is constant, that of its neighbours.  An axis that passes through the
        vertical, to rounding of the initial state, comes out on the other side; this half turn is
        none of precession, so a pendulum that swings in a plane has 0.
        """
        return float(self.orbit.mean_precession)

    @property
    def rate(self) -> float:
        """|ω| + √(MgR/λ) with the smallest moment, which the motion does not much exceed (1/s)."""
        moments, weight = self.body.moments, self.body.weight
        return math.hypot(*self.omega) + math.sqrt(math.hypot(*weight) / min(moments))

    def _times(self, t: ArrayLike) -> Floats:
        return checks.times_within_reach(t, self.rate)

    def _flows(self, accuracy: Accuracy) -> Flows:
        """The motion from t = 0 on, as `accuracy` says."""
        system = systems.TOP if self.body.symmetric else systems.BODY
        moments, weight = self.body.moments, self.body.weight
        # M and g occur in nothing but the product M g R, which `weight` is.
        parameters: tuple[float, ...] = (*moments, 1.0, 1.0, *weight)
        if self.body.symmetric:
            parameters = moments[0], moments[2], 1.0, 1.0, weight[2], self.omega[2]
        start = self._initial()
        if accuracy.method == TAYLOR:
            return lambda end: taylor.flow(system, parameters, start, end, accuracy)
        rates, sizes = system.equations(*parameters), system.sizes(parameters)
        return lambda end: flow(rates, start, end, accuracy, sizes)

    def _initial(self) -> Floats:
        """The state at t = 0: q and ω, or ω₁ and ω₂ alone for a symmetric body."""
        omega = self.omega[:2] if self.body.symmetric else self.omega
        return np.concatenate([attitudes.quaternions(self.attitude), omega])

    def _attitudes(self, states: Floats, times: Floats) -> tuple[Floats, Floats]:
        """Unit quaternions (N, 4) and ω (N, 3) of states (n, N), with the turn about e₃ back."""
        frame = _units(states)
        if not self.body.symmetric:
            return frame, states[4:].reshape(3, -1).T
        spin = self.omega[2]
        omega1, omega2 = states[4:].reshape(2, -1)
        across = (omega1 + 1j * omega2) * np.exp(-1j * spin * times)
        turn = np.zeros((len(times), 4))
        turn[:, 0], turn[:, 3] = np.cos(spin * times / 2), np.sin(spin * times / 2)
        omega = np.stack([across.real, across.imag, np.full(len(times), spin)], axis=1)
        return attitudes.product(frame, turn), omega


def _units(states: Floats) -> Floats:
    """The quaternions (N, 4) of states (n, N), with norm 1."""
    quaternions = states[:4].reshape(4, -1)
    norms = np.linalg.norm(quaternions, axis=0)
    if not np.all((norms > 0.5) & (norms < 2)):  # also NaN
        raise RigidtopError(
            "the integration lost the attitude, its quaternion is far from a unit: "
            "smaller rtol and atol are needed"
        )
    made: Floats = (quaternions / norms).T
    return made


@dataclass(frozen=True, eq=False)
class TopMotion(Motion):
    """The motion of a symmetric top; made by `HeavyTop.motion`."""

    body: SymmetricTop

    phi: float = 0.0
    """φ at t = 0, from which φ(t) continues (rad)."""

    psi: float = 0.0
    """ψ at t = 0, from which ψ(t) continues (rad)."""

    def start(self) -> TopTrajectory:
        """The initial state, as a trajectory of one row."""
        return self._trajectory(
            self._initial()[:, None], np.zeros(1), np.array([self.phi]), np.array([self.psi])
        )

    @property
    def _solvable(self) -> heavy_orbit.Start:
        first = self.start()
        return self._of_halves(
            halves=(float(first.cos_half[0]), float(first.sin_half[0])),
            rates=(float(first.theta_dot[0]), float(first.v_phi[0])),
        )

    def _of_halves(
        self, halves: tuple[float, float], rates: tuple[float, float]
    ) -> heavy_orbit.Start:
        axis = closed.Axis(self.body.lambda1, self.body.lambda3, self.body.weight[2], None)
        return closed.start(axis, self.omega[2], halves, rates, (self.phi, self.psi))

    @cached_property
    def solved(self) -> Solved:
        return heavy.solved(self._solvable)

    def _row(self, times: Floats, state: Sequence[float]) -> TopTrajectory:
        """One state, in the order of `TopState`."""
        *changing, spin, upright = state
        columns = [np.array([x]) for x in changing]
        fixed = [np.array(spin), np.array(upright)]
        named = zip((each.name for each in fields(TopState)), [*columns, *fixed], strict=True)
        return TopTrajectory(motion=self, t=times, **dict(named))

    def exact(self, t: ArrayLike, compiled: bool = False) -> TopTrajectory:
        """The motion at the times `t`, in closed form, with Euler angles: see `Motion.exact`.

        φ and ψ count every turn, however far apart the times are.

        >>> from rigidtop import HeavyTop
        >>> top = HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5)
        >>> run = top.motion(theta=0.5, phi_dot=1.0, omega3=40.0).exact([0.0, 1e6])
        >>> run.theta.round(6), run.phi.round(3)
        (array([0.5     , 0.463232]), array([     0.   , 247889.744]))
        """
        times = checks.times(t)
        if len(times) == 1:
            return self._row(times, self.solved.at(float(times[0])))
        even = None
        if not compiled or len(times) > samples.MANY:
            orbit: heavy_orbit.Orbit = self.solved.orbit
            states = partial(heavy.states, self.solved, compiled=compiled)
            even = samples.samples(times, orbit.course, states, orbit.sizes)
        if even is not None:
            return SampledTop(self, times, lambda name: even.of(name)[0])
        if compiled:
            return SampledTop(self, times, heavy.rows(self.solved, times).__getitem__)
        return TopTrajectory(motion=self, t=times, **vars(orbit.states(times)))

    def integrate(
        self, t: ArrayLike, method: str = "DOP853", rtol: float = 1e-10, atol: float = 1e-12
    ) -> TopTrajectory:
        """The motion at the times `t`, with Euler angles: see `Motion.integrate`.

        >>> from rigidtop import HeavyTop
        >>> top = HeavyTop(lambda1=1.0, lambda3=0.5, M=1.0, R=0.5)
        >>> slow, fast = top.steady_precession(theta=0.5, omega3=40.0)
        >>> run = top.motion(theta=0.5, phi_dot=slow, omega3=40.0).integrate([0.0, 10.0])
        >>> bool(abs(run.theta[1] - 0.5) < 1e-9), bool(abs(run.phi[1] - 10 * slow) < 1e-9)
        (True, True)
        """
        times = self._times(t)
        upright = float(spinning(self.body, self.omega[2])["upright_phi_dot"])

        def sample(motion: Flow, ordered: Floats) -> Floats:
            counted = counted_angles(motion, ordered, (self.phi, self.psi), upright)
            return np.concatenate([motion.path(ordered), counted])

        flows = self._flows(Accuracy(method, rtol, atol))
        states = on_both_sides(flows, self._initial(), times, sample)
        return self._trajectory(states[:6], times, *states[6:])

    def _trajectory(
        self, states: Floats, times: Floats, phi: Floats, psi_in_frame: Floats
    ) -> TopTrajectory:
        """From states (6, N) and continuous angles in the frame that does not turn about e₃."""
        spin = self.omega[2]
        return TopTrajectory(
            motion=self,
            t=times,
            **of_spinors(attitudes.spinors(_units(states).T), states[4:6], psi_in_frame),
            phi=phi,
            psi=psi_in_frame + spin * times,
            **spinning(self.body, spin),
        )


class EulerTopMotion(TopMotion):
    """One that is given by Euler angles, which keep the digits of large φ and ψ."""

    euler: Start

    def __init__(self, body: SymmetricTop, euler: Start) -> None:
        omega = checks.vector("omega", euler.omega)
        given = {"body": body, "euler": euler, "omega": omega, "phi": euler.phi, "psi": euler.psi}
        for name, value in given.items():
            object.__setattr__(self, name, value)

    @cached_property
    def attitude(self) -> Rotation:
        return self.euler.attitude

    def start(self) -> TopTrajectory:
        s = self._solvable
        angles = s.cos_half, s.sin_half, s.phi, s.psi
        return self._row(np.zeros(1), (*angles, s.v_theta, s.v_phi, s.omega3, s.b / 2))

    @property
    def _solvable(self) -> heavy_orbit.Start:
        cos_half, sin_half, sine = attitudes.of_polar_angle(self.euler.theta)
        rates = self.euler.theta_dot, self.euler.phi_dot * sine
        return self._of_halves((cos_half, sin_half), rates)
