"""What a top on a table is doing at given times."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from rigidtop.motion.attitude import Floats
from rigidtop.motion.table.contact import Contact, Sliding
from rigidtop.motion.table.phases import Event, ending
from rigidtop.motion.trajectory import TopTrajectory


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class SlidingTrajectory(TopTrajectory):
    """A top on a table at N times, one row each, in the order in which they were asked for.

    Times after a fall or a lift-off are left out: see `ended`.  Angles, their rates and ω are those
    of `TopState`, of shape (N,) and (N, 3); φ and ψ count turns.  `angular_momentum` is that about
    the **centre of mass**.  Vectors with three components in
    the space frame have the table at z = 0.
    """

    centre: Floats
    """X and Y of the centre of mass, shape (N, 2), in m."""

    slip: Floats
    """Velocity over the table of the material point that touches it, shape (N, 2), in m/s."""

    dissipated_by_friction: Floats
    """Energy that friction has taken since t = 0, shape (N,), in J."""

    dissipated_by_air: Floats
    """Energy that the drag of the air has taken since t = 0, shape (N,), in J."""

    rolling: NDArray[np.bool_]
    """Whether static friction holds the contact, shape (N,)."""

    events: tuple[Event, ...] = ()
    """What happened until the last of the times asked for, in order of time."""

    def columns(self) -> dict[str, Floats]:
        """t, the Euler angles and rates, place, slip, rolling, the table's force, energies."""
        return {
            **self.euler_columns,
            **{f"{axis}/m": self.position[:, k] for k, axis in enumerate("xyz")},
            **{f"slip_{axis}/(m/s)": self.slip[:, k] for k, axis in enumerate("xy")},
            "rolling": self.rolling.astype(float),
            "normal_force/N": self.normal_force,
            "energy/J": self.energy,
            "dissipated/J": self.dissipated_by_friction + self.dissipated_by_air,
        }

    @property
    def ended(self) -> Event | None:
        """The fall or the lift-off after which there are no rows, None if there was none."""
        return ending(self.events)

    @cached_property
    def _known(self) -> Floats:
        """e₃, the velocity of the centre of mass and a, shape (9, N)."""
        contact = Contact(self.motion.body)
        rows = (*self.quaternion.T, *self.omega.T, *self.slip.T)
        return np.stack(np.broadcast_arrays(*contact.kinematics(rows)))

    @property
    def position(self) -> Floats:
        """The place of the centre of mass, shape (N, 3), in m; the table is z = 0."""
        body = self.motion.body
        height = body.tip + (body.R - body.tip) * self._known[2]
        return np.column_stack([self.centre, height])

    @property
    def velocity(self) -> Floats:
        """The velocity of the centre of mass, shape (N, 3), in m/s."""
        return self._known[3:6].T

    @property
    def contact(self) -> Floats:
        """The point of the table that is touched, shape (N, 3), in m."""
        body = self.motion.body
        below = self.position - (body.R - body.tip) * self.e3
        place: Floats = below * np.array([1.0, 1.0, 0.0])
        return place

    @cached_property
    def _force(self) -> Floats:
        """F_x, F_y, N, shape (3, N)."""
        contact = Contact(self.motion.body)
        rows = (*self.quaternion.T, *self.omega.T, *self.slip.T, *np.zeros((5, len(self.t))))
        speed = np.hypot(*self.slip.T)
        direction = self.slip.T / np.where(speed > 0, speed, 1.0)
        if self.motion.body.mu > 0:
            # A slip that has just begun, from rest: it goes where it is about to go.
            for k in np.flatnonzero((speed == 0) & ~self.rolling):
                direction[:, k] = contact.onset([float(row[k]) for row in rows])
        slides = contact.sliding(rows, (direction[0], direction[1])).force
        rolls = contact.rolling(rows).force
        return np.where(self.rolling, np.stack(rolls), np.stack(slides))

    @property
    def normal_force(self) -> Floats:
        """N, with which the table pushes upwards, shape (N,), in N."""
        normal: Floats = self._force[2]
        return normal

    @property
    def friction_force(self) -> Floats:
        """The friction of the table on the top, along x̂ and ŷ, shape (N, 2), in N."""
        return self._force[:2].T

    @property
    def energy(self) -> Floats:
        """½MV² + ½ Σ λₖωₖ² + Mgz, kinetic and potential, shape (N,), in J; zero on the table."""
        body = self.motion.body
        kinetic = self.omega**2 @ np.array(body.moments) + body.M * np.sum(self.velocity**2, axis=1)
        energy: Floats = kinetic / 2 + body.M * body.g * self.position[:, 2]
        return energy

    @property
    def jellett(self) -> Floats:
        """Jellett's integral −L·ρ = (R − r) L₃ + r L_z, shape (N,), in J s m.

        No force at the contact changes it, whatever the friction; the air does.
        """
        body: Sliding = self.motion.body
        along = body.lambda3 * self.omega[:, 2]
        return (body.R - body.tip) * along + body.tip * self.angular_momentum[:, 2]

    def conserved(self) -> Mapping[str, Floats]:
        """The energy together with what is dissipated."""
        return {"energy": self.energy + self.dissipated_by_friction + self.dissipated_by_air}

    @property
    def scales(self) -> tuple[float, float]:
        """The kinetic energy at t = 0 and MgR together (J), and 1 J s."""
        start, body = self.motion.start(), self.motion.body
        below = body.R - float(start.position[0, 2])
        return float(start.energy[0]) + body.M * body.g * below, 1.0

    def budget(self) -> float:
        """The largest amount by which energy and dissipated energy miss the energy at t = 0.

        Relative to the kinetic energy at t = 0 and MgR together.
        """
        return self.drift()["energy"]
