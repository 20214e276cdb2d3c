"""Many motions of a system."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from rigidtop.errors import RigidtopError
from rigidtop.motion import checks
from rigidtop.motion.attitude import Floats
from rigidtop.system.motion import SystemMotion, row, started
from rigidtop.system.names import Given, numbers
from rigidtop.system.numeric import Computed


def many(system: Computed, parameters: Given, q: Given, qdot: Given) -> SystemMotions:
    """See `System.motions`."""
    if not isinstance(parameters, Mapping):
        numbers(system.parameters, parameters)  # complains
    given = [*parameters.items(), *row(system, "q", q).items(), *row(system, "qdot", qdot).items()]
    arrays = [(str(x), checks.numbers(str(x), value)) for x, value in given]
    shape = checks.common_shape(dict(arrays))
    flat = (np.broadcast_to(value, shape).ravel().tolist() for _, value in arrays)
    first, last = len(parameters), len(parameters) + len(system.q)
    motions = (
        started(system, dict(zip(parameters, each, strict=False)), each[first:last], each[last:])
        for each in zip(*flat, strict=True)
    )
    return SystemMotions(tuple(motions), shape)


@dataclass(frozen=True)
class SystemMotions:
    """Many motions of a system; made by `System.motions`.  It is a sequence of `SystemMotion`s."""

    motions: tuple[SystemMotion, ...] = field(repr=False)
    """In the order of an array that is read row by row."""

    shape: tuple[int, ...]
    """Of the arrays that were given, broadcast: S."""

    def __len__(self) -> int:
        return len(self.motions)

    def __getitem__(self, index: int) -> SystemMotion:
        return self.motions[index]

    def integrate(
        self,
        t: ArrayLike,
        method: str = "DOP853",
        rtol: float = 1e-10,
        atol: float = 1e-12,
        progress: Callable[[int, int], None] | None = None,
    ) -> Floats:
        """The coordinates and velocities at the N times `t`, shape (2, *S, N, n).

        As `SystemMotion.integrate` has them; `progress` is called with the number of motions that
        are done, and of all.
        """
        found = []
        for done, motion in enumerate(self.motions):
            run = motion.integrate(t, method, rtol, atol)
            found.append(np.stack([run.q, run.qdot]))
            if progress is not None:
                progress(done + 1, len(self.motions))
        if not found:
            raise RigidtopError("there are no motions: an array that was given is empty")
        stacked = np.stack(found, axis=1)
        return stacked.reshape(2, *self.shape, *stacked.shape[2:])
