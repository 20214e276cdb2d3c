"""What a motion of a system starts with: its coordinates and velocities, and their sizes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from sympy import Expr, Symbol

from rigidtop.errors import RigidtopError
from rigidtop.motion.attitude import Floats
from rigidtop.system.names import Given
from rigidtop.system.numeric import Computed


def row(system: Computed, what: str, given: Given) -> dict[Symbol, Any]:
    """What is given for each coordinate ("q") or velocity ("qdot"), in their order."""
    letters = system.names.q if what == "q" else system.names.v
    shown = ", ".join(map(system.names.spelled, letters))
    if given is None and what == "q":
        raise RigidtopError(f"where does it start? q = a number for each of {shown}")
    given = {} if given is None else given
    if isinstance(given, Mapping):
        places = {}
        for key, value in given.items():
            place = _place(key, letters, system)
            if place is None:
                raise RigidtopError(f"{what} has {key!s}, which is none of {shown}")
            places[place] = value
        missing = [x.name for k, x in enumerate(letters) if k not in places]
        if missing and what == "q":
            raise RigidtopError(f"q has no number for {', '.join(missing)}")
        values = [places.get(k, 0.0) for k in range(len(letters))]
    else:
        values = list(given) if np.iterable(given) and not isinstance(given, str) else [given]
    if len(values) != len(letters):
        raise RigidtopError(f"{what} has {len(values)} numbers, for {shown}")
    return dict(zip(letters, values, strict=True))


def _place(key: Expr, letters: Sequence[Symbol], system: Computed) -> int | None:
    """Which coordinate is meant, also where its velocity is: by symbol, function or name."""
    names = system.names
    for k, x in enumerate(letters):
        own = (names.q[k], names.v[k], names.given.get(names.q[k]), names.given.get(names.v[k]))
        if key in own or key in (x.name, names.q[k].name, names.spelled(names.v[k])):
            return k
    return None


def sizes(system: Computed, states: Floats) -> Floats:
    """What absolute tolerances are fractions of: at most 1, or of q, of q̇, of work.

    Of one state (n,) or of many (n, L).
    """
    n, made = len(system.q), np.ones(states.shape)
    for part in (slice(n), slice(n, 2 * n), slice(2 * n, 2 * n + system.numeric.works)):
        largest = np.max(np.abs(states[part]), axis=0, initial=0.0)
        made[part] = np.where((largest > 0) & (largest < 1), largest, 1.0)
    return made


def with_units(system: Computed, units: Floats, parameters: Floats) -> Floats:
    """The numbers that an integrator of `Numeric.series` wants, for one motion or for many."""
    n = len(system.q)
    own = np.concatenate([units[[0, n]], units[2 * n : 2 * n + system.numeric.works]])
    return np.concatenate([own, 1 / own, parameters])
