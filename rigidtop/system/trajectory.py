"""What came of a motion of a system: its states, and what is conserved as a measure of errors."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from sympy import Expr, Symbol

from rigidtop.codegen.numpy import Function
from rigidtop.errors import RigidtopError
from rigidtop.motion.attitude import Floats
from rigidtop.motion.rows import Rows
from rigidtop.system.names import expression
from rigidtop.system.numeric import BALANCE, Computed
from rigidtop.system.slipping import Slipping
from rigidtop.system.start import SystemStart

Signs = NDArray[np.int_] | None
"""−1, 0 or 1 for each row, if there are such."""


@dataclass(frozen=True, eq=False, repr=False)
class SystemTrajectory(Rows):
    """What a system does at N times, one row each, in the order in which they were asked for."""

    motion: SystemStart
    """The motion that it belongs to, with its system and its initial state."""

    t: Floats
    """Times, shape (N,), in s."""

    q: Floats
    """Coordinates, shape (N, n)."""

    qdot: Floats
    """Velocities, shape (N, n)."""

    work: Floats
    """What forces have done since t = 0, where the energy is not conserved, shape (N,)."""

    slip: Signs = None
    """With a `DryFriction` the sign of the sliding velocity, 0 while it sticks, shape (N,)."""

    crossings: Mapping[str, SystemSection] = field(default_factory=dict)
    """Where each of the events that were asked for changes its sign, with times that increase.

    A zero at t = 0 is left out, and one at which a quantity only touches zero may be.
    """

    ended: float | None = None
    """When `until` was zero, after which there are no rows; None if it was not."""

    @property
    def events(self) -> dict[str, Floats]:
        """The times of the `crossings`, by their names (s)."""
        return {name: section.t for name, section in self.crossings.items()}

    def columns(self) -> dict[str, Floats]:
        """t, the coordinates, their velocities and the energy."""
        names = self._system.names
        columns = {"t/s": self.t}
        columns |= {header(x): self.q[:, k] for k, x in enumerate(names.q)}
        columns |= {header(v, names.spelled(v)): self.qdot[:, k] for k, v in enumerate(names.v)}
        return columns | {"energy/J" if _in_si(self._system) else "energy": self.energy}

    @property
    def plotted(self) -> tuple[str | tuple[str, str], ...]:
        """The names of the columns that `plot` draws: the coordinates."""
        return tuple(x.name for x in self._system.names.q)

    def places(self) -> Floats:
        """Where the parts of the system are in space, shape (parts, N, 3), in m.

        Those of a mechanism are its links with mass or inertia, by their centres of mass.
        Raises RigidtopError for a system that was not made of parts.
        """
        return self._frames[:, :3].swapaxes(1, 2)

    def attitudes(self) -> Floats:
        """R of the parts, of mass points 1, shape (parts, N, 3, 3): body to space."""
        rows = self._frames[:, 3:].reshape(-1, 3, 3, len(self))
        return np.moveaxis(rows, -1, 1)

    @cached_property
    def _frames(self) -> Floats:
        if not self._system.parts:
            raise RigidtopError(
                "the system is not made of masses and bodies: System.of_parts makes one that is"
            )
        return self._along(self._system.numeric.frames).reshape(-1, 12, len(self))

    def animate(self, path: str, duration: float | None = None) -> None:
        """A film of the parts as a GIF, or an MP4 where ffmpeg is: points, rods, bodies' axes.

        A rod is drawn where two neighbours, or the origin and the first, keep their distance.  The
        rows should be evenly spaced; `duration` is that of the film (s), by default the motion's.

        Raises RigidtopError for a system without parts, and where the file can't be written.
        """
        from rigidtop.figures.trajectories import filmed

        filmed(self, path, duration)

    def value(self, quantity: Expr) -> Floats:
        """A quantity of q, q̇, p, t and the parameters along the motion, shape (N,)."""
        asked = self._system.quantity(expression("the quantity", quantity))
        values: Floats = self._arrays((asked,))[0]
        return values

    @property
    def _system(self) -> Computed:
        return self.motion.system

    def _arrays(self, expressions: Sequence[Expr]) -> Floats:
        return self._along(self._system.numeric.of(tuple(expressions)))

    def _along(self, function: Function) -> Floats:
        """A function of numbers along the motion, shape (results, N)."""
        with np.errstate(all="ignore"):
            return function.array(self.t, *self.q.T, *self.qdot.T, *self.motion.parameters)

    @cached_property
    def energy(self) -> Floats:
        """Jacobi's integral, shape (N,), in J."""
        energy: Floats = self._along(self._system.numeric.energy)[0]
        return energy

    @cached_property
    def momenta(self) -> Floats:
        """p = ∂L/∂q̇, shape (N, n)."""
        return self._along(self._system.numeric.momenta).T

    @cached_property
    def accelerations(self) -> Floats:
        """The accelerations q̈, shape (N, n)."""
        return self._solved[:, : len(self.motion.q)]

    @cached_property
    def multipliers(self) -> Floats:
        """λ of each of the k constraints, shape (N, k)."""
        return -self._solved[:, len(self.motion.q) :]

    @cached_property
    def _solved(self) -> Floats:
        if self.slip is None:
            return self._along(self._system.numeric.solved).T
        rows = np.empty((len(self), len(self.motion.q) + len(self._system.constraints)))
        slipping = Slipping(self._system, self.motion.parameters)
        for slip in np.unique(self.slip):
            at = self.slip == slip
            states = np.concatenate([self.q[at], self.qdot[at]], axis=1).T
            solved = slipping.solved(slip, self.t[at], states)
            rows[at] = solved[: rows.shape[1]].T
        return rows

    @cached_property
    def friction(self) -> Floats:
        """The force of the `DryFriction` along its sliding velocity, shape (N,), in N.

        It is what holds while it sticks.  Raises RigidtopError for a system without one.
        """
        if self.slip is None:
            raise RigidtopError("the system has no DryFriction among its forces")
        states = np.concatenate([self.q, self.qdot], axis=1).T
        slipping = Slipping(self._system, self.motion.parameters)
        return slipping.friction(self.t, states, self.slip.astype(float))

    def drift(self) -> dict[str, float]:
        """The largest changes of what is conserved from its value at t = 0; constraints too.

        Each is relative to the largest sum of the magnitudes of its terms along the motion.  Where
        the energy is not conserved, "energy balance" is what energy and work fail to add up to.
        """
        numeric = self._system.numeric
        along = self._along(numeric.watch)
        first = self.motion.at_start(numeric.watch, "what is conserved")
        drifts = {}
        for k, name in enumerate(numeric.watched):
            change, size = along[2 * k] - first[2 * k], first[2 * k + 1]
            if name == BALANCE:
                change = change - self.work
            if name.startswith("constraint"):
                change, size = along[2 * k], 0.0
            drifts[name] = _relative(change, along[2 * k + 1], size)
        return drifts


@dataclass(frozen=True, eq=False, repr=False)
class SystemSection(SystemTrajectory):
    """The states of a motion at which a quantity changes its sign, a row each."""

    rising: NDArray[np.bool_] = field(default_factory=lambda: np.empty(0, dtype=bool))
    """Whether it increases with the time there, shape (N,)."""

    dots = True

    @property
    def plotted(self) -> tuple[tuple[str, str], ...]:
        """The velocity of the last coordinate over that coordinate."""
        names = self._system.names
        return ((names.q[-1].name, names.spelled(names.v[-1])),)


def header(x: Symbol, name: str = "") -> str:
    unit = getattr(getattr(x, "quantity", None), "unit", "")
    name = name or x.name
    if not unit:
        return name
    return f"{name}/({unit})" if "/" in unit else f"{name}/{unit}"


def _in_si(system: Computed) -> bool:
    """Whether the coordinates say in which units they are."""
    return all("/" in header(x) for x in system.names.q)


def _relative(change: Floats, sizes: Floats, size: float) -> float:
    largest = max(float(np.max(sizes, initial=0.0)), size)
    return float(np.max(np.abs(change), initial=0.0)) / (largest or 1.0)
