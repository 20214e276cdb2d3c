"""Many motions of a system."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike
from sympy import Expr

from rigidtop.errors import RigidtopError
from rigidtop.motion import checks
from rigidtop.motion.attitude import Floats
from rigidtop.system.motion import SystemMotion, started
from rigidtop.system.names import Given
from rigidtop.system.numeric import Computed


def many(
    system: Computed, parameters: Mapping[Expr, object], q: Given, qdot: Given
) -> SystemMotions:
    """See `System.motions`."""
    rows = {"q": system.names.q, "qdot": system.names.v}
    given: dict[Expr, Expr] = dict(parameters)
    for what, value in (("q", q), ("qdot", qdot)):
        if value is None and what == "qdot":
            continue
        if isinstance(value, Mapping):
            given |= {(what, key): each for key, each in value.items()}
        elif not np.iterable(value) or len(list(value)) != len(rows[what]):
            shown = ", ".join(map(system.names.spelled, rows[what]))
            raise RigidtopError(f"{what} has a number, or an array, for each of {shown}")
        else:
            given |= {(what, x): each for x, each in zip(rows[what], value, strict=True)}
    arrays = {key: checks.numbers(_spoken(key), value) for key, value in given.items()}
    shape = checks.common_shape({_spoken(key): value for key, value in arrays.items()})
    flat = {key: np.broadcast_to(value, shape).ravel() for key, value in arrays.items()}
    made = []
    for k in range(math.prod(shape)):
        one: dict[str, dict[Expr, float]] = {"": {}, "q": {}, "qdot": {}}
        for key, values in flat.items():
            what, name = key if isinstance(key, tuple) else ("", key)
            one[what][name] = float(values[k])
        made.append(started(system, one[""], one["q"], one["qdot"]))
    return SystemMotions(tuple(made), shape)


def _spoken(key: Any) -> str:
    return str(key[1] if isinstance(key, tuple) else key)


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
