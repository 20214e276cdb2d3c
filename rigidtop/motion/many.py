"""Many motions at once: arrays of parameters and initial states that broadcast, in closed form.

Work goes in chunks, so memory is little more than what the results take.
"""

from __future__ import annotations

import math
from abc import abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rigidtop.errors import RigidtopError
from rigidtop.motion import attitude as attitudes
from rigidtop.motion import checks
from rigidtop.motion.attitude import Floats
from rigidtop.motion.exact import free, heavy, heavy_orbit
from rigidtop.motion.integrate import Progress
from rigidtop.motion.periods import Periods
from rigidtop.motion.state import TopState

CHUNK = 1 << 13
"""States at a time: so many that NumPy's calls cost little beside its loops."""


def top_motions(
    *,
    lambda1: ArrayLike,
    lambda3: ArrayLike,
    M: ArrayLike,
    R: ArrayLike,
    theta: ArrayLike,
    g: ArrayLike = 9.81,
    theta_dot: ArrayLike = 0.0,
    phi: ArrayLike = 0.0,
    phi_dot: ArrayLike = 0.0,
    psi: ArrayLike = 0.0,
    psi_dot: ArrayLike | None = None,
    omega3: ArrayLike | None = None,
    physical: bool | float = True,
) -> TopMotions:
    """Motions of heavy symmetric tops, as of `HeavyTop` and its `motion`; the arrays broadcast.

    Raises RigidtopError as these do, for the first value that makes no sense.

    >>> tops = top_motions(lambda1=1, lambda3=0.5, M=1, R=0.5, theta=0.5, omega3=[0, 20, 40])
    >>> tops.regime.tolist(), tops.exact(1.0).theta.round(6)
    (['plane', 'cusps', 'cusps'], array([2.048994, 0.552801, 0.501512]))
    """
    if (psi_dot is None) == (omega3 is None):
        raise RigidtopError("give omega3 or psi_dot, one of them")
    positive: dict[str, ArrayLike] = {"lambda1": lambda1, "lambda3": lambda3, "M": M}
    values = {name: checks.numbers(name, value, above=0.0) for name, value in positive.items()}
    values["R"], values["g"] = checks.numbers("R", R, least=0.0), checks.numbers("g", g, least=0.0)
    values["theta"] = checks.numbers("theta", theta, least=0.0, most=math.pi, tiny=True)
    rates: dict[str, ArrayLike] = {
        "theta_dot": theta_dot,
        "phi": phi,
        "phi_dot": phi_dot,
        "psi": psi,
    }
    if omega3 is not None:
        rates["omega3"] = omega3
    if psi_dot is not None:
        rates["psi_dot"] = psi_dot
    values |= {name: checks.numbers(name, value) for name, value in rates.items()}
    shape = checks.common_shape(values)
    central = values["lambda1"] - values["M"] * values["R"] ** 2
    slack = checks.TOLERANCE * np.maximum(values["lambda1"], values["lambda3"])
    wrong = 2 * np.maximum(central, values["lambda3"]) > 2 * central + values["lambda3"] + slack
    if checks.truth("physical", physical) and np.any(wrong):
        raise RigidtopError(
            f"lambda1 is too small in {np.count_nonzero(wrong)} of {wrong.size}: "
            "it must be at least MR² + lambda3/2"
        )
    if "psi_dot" in values:
        values["omega3"] = values.pop("psi_dot") + values["phi_dot"] * np.cos(values["theta"])
    return TopMotions(shape=shape, **values)


def free_motions(*, moments: ArrayLike, omega: ArrayLike) -> FreeMotions:
    """Motions of free bodies: `moments` and `omega` (body components, rad/s) of shape (…, 3).

    All but the last axis broadcast.  Raises RigidtopError as `FreeBody` and its `motion` do.

    >>> bodies = free_motions(moments=[1.0, 2.0, 2.5], omega=[[1.0, 0.1, 0.0], [0.1, 0.0, 1.0]])
    >>> bodies.regime.tolist(), bodies.exact(1.0)[1].shape
    (['long axis', 'short axis'], (2, 3))
    """
    inertia = checks.numbers("moments", moments, above=0.0)
    rates = checks.numbers("omega", omega)
    for name, value in (("moments", inertia), ("omega", rates)):
        if value.shape[-1:] != (3,):
            raise RigidtopError(f"{name} must have shape (…, 3), not {value.shape}")
    largest = inertia.max(axis=-1)
    wrong = 2 * largest > inertia.sum(axis=-1) + checks.TOLERANCE * largest
    if np.any(wrong):
        raise RigidtopError(
            f"moments: the largest exceeds the sum of the other two in {np.count_nonzero(wrong)} "
            f"of {wrong.size}, and no body has such moments about its centre of mass"
        )
    shape = checks.common_shape({"moments": inertia[..., 0], "omega": rates[..., 0]})
    return FreeMotions(inertia, rates, shape)


class _Motions(Periods[NDArray[np.str_], Floats]):
    """What motions of tops and of free bodies have in common: one number each, of shape `shape`."""

    shape: tuple[int, ...]

    @abstractmethod
    def _orbits(self, index: NDArray[np.intp]) -> free.FreeOrbit | heavy_orbit.HeavyOrbit:
        """The orbits of the motions whose place in the flattened array is `index`."""

    def _of_orbit(self, name: str) -> Any:
        def quantities(index: NDArray[np.intp], _: Floats) -> list[Any]:
            value = getattr(self._orbits(index), name)
            return list(value) if isinstance(value, tuple) else [value]

        results = _in_chunks(quantities, np.zeros(()), self.shape, None)
        return tuple(results) if len(results) > 1 else results[0]


@dataclass(frozen=True, eq=False, kw_only=True)
class TopMotions(_Motions):
    """Motions of heavy symmetric tops, made by `top_motions`; each array broadcasts to `shape`."""

    lambda1: Floats
    lambda3: Floats
    M: Floats
    R: Floats
    g: Floats
    theta: Floats
    theta_dot: Floats
    phi: Floats
    phi_dot: Floats
    psi: Floats
    omega3: Floats
    shape: tuple[int, ...]

    @cached_property
    def _start(self) -> heavy_orbit.HeavyStart:
        cos_half, sin_half, sine = attitudes.of_polar_angle(self.theta, np)
        return heavy_orbit.HeavyStart(
            mu=self.M * self.g * self.R / self.lambda1,
            b=self.lambda3 * self.omega3 / self.lambda1,
            omega3=self.omega3,
            cos_half=cos_half,
            sin_half=sin_half,
            v_theta=self.theta_dot,
            v_phi=self.phi_dot * sine,
            phi=self.phi,
            psi=self.psi,
        )

    def _orbits(self, index: NDArray[np.intp]) -> heavy_orbit.HeavyOrbit:
        return heavy.solve(heavy_orbit.HeavyStart(**_taken(vars(self._start), self.shape, index)))

    def exact(self, t: ArrayLike, progress: Progress | None = None) -> TopState:
        """The states at the times `t` (s), which broadcast against `shape`.

        `progress` is called with the number of states that are done, and of all.
        """
        times = checks.numbers("t", t)

        def states(index: NDArray[np.intp], at: Floats) -> list[Floats]:
            state = self._orbits(index).at(at)
            return [getattr(state, each.name) for each in fields(TopState)]

        rows = _in_chunks(states, times, self.shape, progress)
        return TopState(**dict(zip((each.name for each in fields(TopState)), rows, strict=True)))


@dataclass(frozen=True, eq=False)
class FreeMotions(_Motions):
    """Motions of free bodies, made by `free_motions`."""

    moments: Floats
    omega: Floats
    shape: tuple[int, ...]

    def _orbits(self, index: NDArray[np.intp]) -> free.FreeOrbit:
        of = {"moments": self.moments, "omega": self.omega}
        return free.solve(
            *(
                tuple(np.broadcast_to(x, (*self.shape, 3)).reshape(-1, 3)[index].T)
                for x in of.values()
            )
        )

    def exact(self, t: ArrayLike, progress: Progress | None = None) -> tuple[Floats, Floats]:
        """Attitudes and ω at the times `t` (s), which broadcast against `shape`.

        Returns unit quaternions (…, 4), scalar first, from the body at t to the body at t = 0, and
        ω (…, 3) in body components (rad/s).
        """
        times = checks.numbers("t", t)

        def states(index: NDArray[np.intp], at: Floats) -> list[Floats]:
            state = self._orbits(index).at(at)
            return [np.stack(parts, axis=-1) for parts in (state.quaternion, state.omega)]

        quaternion, omega = _in_chunks(states, times, self.shape, progress)
        return quaternion, omega


def _taken(
    arrays: dict[str, Floats], shape: tuple[int, ...], index: NDArray[np.intp]
) -> dict[str, Floats]:
    """The elements `index` of the flattened arrays; what is one number stays so."""
    return {
        name: value if np.ndim(value) == 0 else np.broadcast_to(value, shape).reshape(-1)[index]
        for name, value in arrays.items()
    }


def _in_chunks(
    states: Callable[[NDArray[np.intp], Floats], list[Any]],
    times: Floats,
    shape: tuple[int, ...],
    progress: Progress | None,
) -> list[Any]:
    """`states` of motions and times, chunk by chunk; each result of the common shape, and more."""
    checks.callback("progress", progress)
    try:
        whole = np.broadcast_shapes(times.shape, shape)
    except ValueError:
        raise RigidtopError(
            f"t of shape {times.shape} does not broadcast against motions of shape {shape}"
        ) from None
    total = math.prod(whole)
    results: list[Any] = []
    of_motion = np.arange(math.prod(shape)).reshape(shape)
    rows = whole or (1,)  # a single number has no place in an array
    every, at = np.broadcast_to(of_motion, rows), np.broadcast_to(times, rows)

    # One chunk also of nothing, which says what kinds of arrays there are.
    for first in range(0, max(total, 1), CHUNK):
        end = min(first + CHUNK, total)
        place = np.unravel_index(np.arange(first, end), rows)
        parts = states(every[place], at[place])
        if not results:
            results = [np.empty((total, *np.shape(part)[1:]), _kind(part)) for part in parts]
        for result, part in zip(results, parts, strict=True):
            result[first:end] = part
        if progress is not None:
            progress(end, total)
    return [result.reshape((*whole, *result.shape[1:])) for result in results]


def _kind(part: ArrayLike) -> np.dtype[np.generic]:
    # Names of regimes have different lengths in different chunks.
    return np.dtype("U32") if np.asarray(part).dtype.kind == "U" else np.asarray(part).dtype
