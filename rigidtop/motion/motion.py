"""A motion: a body, and its attitude and rotational velocity at t = 0."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from rigidtop.motion import attitude as attitudes
from rigidtop.motion import checks, closed, systems, taylor
from rigidtop.motion.attitude import Floats
from rigidtop.motion.exact import free, heavy, heavy_orbit, samples
from rigidtop.motion.integrate import (
    Accuracy,
    Flow,
    Flows,
    InitialValueProblem,
    flow,
    on_both_sides,
    with_angles,
)
from rigidtop.motion.periods import Periods
from rigidtop.motion.rigid import RigidBody, SymmetricTop
from rigidtop.motion.start import Moving
from rigidtop.motion.state import TopState, of_frame, of_numbers, of_start, spinning
from rigidtop.motion.trajectory import BodyTrajectory, SampledTop, TopTrajectory, Trajectory
from rigidtop.trace import Solved


@dataclass(frozen=True, eq=False)
class Motion(Moving, Periods[str, float]):
    """The motion of a free or heavy body from its initial state; made by the body's `motion`."""

    body: RigidBody

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
            self, times, *closed.states(self.solved, self.body, self.initial, times, compiled)
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
        return closed.solved(self.body, self.initial)

    @property
    def orbit(self) -> free.FreeOrbit | heavy_orbit.HeavyOrbit:
        """The closed form: its periods, its turning points and its state at any times."""
        orbit: free.FreeOrbit | heavy_orbit.HeavyOrbit = self.solved.orbit
        return orbit

    def _of_orbit(self, name: str) -> Any:
        quantity = getattr(self.orbit, name)
        if isinstance(quantity, tuple):
            return tuple(float(each) for each in quantity)
        return np.asarray(quantity).item()

    @property
    def turning_points(self) -> tuple[float, float]:
        smallest, largest = super().turning_points
        below = self.body.symmetric and self.body.weight[2] < 0  # e₃ points away from the centre
        return (math.pi - largest, math.pi - smallest) if below else (smallest, largest)

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
        series = partial(taylor.flow, system, parameters, start)
        problem = InitialValueProblem(
            system.equations(*parameters), start, system.sizes(parameters), series
        )
        return lambda end: flow(problem, end, accuracy)

    def _initial(self) -> Floats:
        """The state at t = 0: q and ω, or ω₁ and ω₂ alone for a symmetric body."""
        omega = self.omega[:2] if self.body.symmetric else self.omega
        return np.concatenate([attitudes.quaternions(self.attitude), omega])

    def _attitudes(self, states: Floats, times: Floats) -> tuple[Floats, Floats]:
        """Unit quaternions (N, 4) and ω (N, 3) of states (n, N), with the turn about e₃ back."""
        frame = attitudes.units(states)
        if not self.body.symmetric:
            return frame, states[4:].reshape(3, -1).T
        spin = self.omega[2]
        omega1, omega2 = states[4:].reshape(2, -1)
        across = (omega1 + 1j * omega2) * np.exp(-1j * spin * times)
        turn = np.zeros((len(times), 4))
        turn[:, 0], turn[:, 3] = np.cos(spin * times / 2), np.sin(spin * times / 2)
        omega = np.stack([across.real, across.imag, np.full(len(times), spin)], axis=1)
        return attitudes.product(frame, turn), omega


@dataclass(frozen=True, eq=False)
class TopMotion(Motion):
    """The motion of a symmetric top; made by `HeavyTop.motion`."""

    body: SymmetricTop

    def start(self) -> TopTrajectory:
        """The initial state, as a trajectory of one row."""
        return self._trajectory(np.zeros(1), of_start(self.initial, self.body))

    @cached_property
    def solved(self) -> Solved:
        axis = closed.Axis(self.body.lambda1, self.body.lambda3, self.body.weight[2], None)
        return heavy.solved(axis.start(self.initial))

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
            return self._trajectory(times, of_numbers(self.solved.at(float(times[0]))))
        even = None
        if not compiled or len(times) > samples.MANY:
            orbit: heavy_orbit.HeavyOrbit = self.solved.orbit
            states = partial(heavy.states, self.solved, compiled=compiled)
            even = samples.samples(times, orbit.smoothness, states, orbit.sizes)
        if even is not None:
            return SampledTop(self, times, lambda name: even.of(name)[0])
        if compiled:
            return SampledTop(self, times, heavy.rows(self.solved, times).__getitem__)
        return self._trajectory(times, orbit.states(times))

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
        spin = spinning(self.body, self.omega[2])

        def sample(motion: Flow, ordered: Floats) -> Floats:
            return with_angles(motion, ordered, self.initial.angles, spin)

        flows = self._flows(Accuracy(method, rtol, atol))
        states = on_both_sides(flows, self._initial(), times, sample)
        turn = self.omega[2] * times
        return self._trajectory(times, of_frame(states[:6], states[6:], turn, spin))

    def _trajectory(self, times: Floats, state: TopState) -> TopTrajectory:
        return TopTrajectory(motion=self, t=times, **vars(state))
