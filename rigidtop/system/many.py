"""Many motions of a system: together where that is possible, else one after the other."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import overload

import numpy as np
from numpy.typing import ArrayLike, NDArray
from sympy import Expr, Symbol

from rigidtop.errors import RigidtopError
from rigidtop.motion import abreast, checks, taylor
from rigidtop.motion.attitude import Floats
from rigidtop.motion.integrate import TAYLOR, Accuracy, sides
from rigidtop.system.friction import refuse
from rigidtop.system.motion import SystemMotion
from rigidtop.system.names import Given, as_assumed, mapping, numbers
from rigidtop.system.numeric import Computed
from rigidtop.system.start import TOO_SMALL, row, sizes, with_units

AT_ONCE = 1 << 11
"""So many motions at a time: NumPy's calls cost little then, and the arrays stay near."""


Together = Callable[[NDArray[np.intp], Floats, Accuracy], Floats]
"""Which motions (L,), times (N,) and the accuracy in, their states (N, 2n, L) out."""


def many(system: Computed, parameters: Given, q: Given, qdot: Given) -> SystemMotions:
    """Motions from many starts at once: see `System.motions`."""
    refuse(system.friction, "motions(…)", "take motion(…) for one start after the other")
    parameters = mapping("parameters are given as {symbol: number}", parameters)
    items = [*parameters.items(), *row(system, "q", q).items(), *row(system, "qdot", qdot).items()]
    arrays = [(str(x), checks.numbers(str(x), value)) for x, value in items]
    firsts = (next(value.flat, 1.0) for _, value in arrays)
    numbers(system.parameters, dict(zip(parameters, firsts, strict=False)))  # complains
    shape = checks.common_shape(dict(arrays))
    flat = [np.broadcast_to(value, shape).ravel() + 0.0 for _, value in arrays]
    count, n = len(parameters), len(system.q)
    ordered = _in_order(system, dict(zip(parameters, flat[:count], strict=True)))
    values = np.reshape(ordered, (len(ordered), flat[-1].size))
    motions = SystemMotions(system, values, np.stack(flat[count:-n]), np.stack(flat[-n:]), shape)
    motions.check()
    return motions


def _in_order(system: Computed, parameters: Mapping[Expr, Floats]) -> list[Floats]:
    """K numbers for each parameter of the system.  Raises RigidtopError as `as_assumed` does."""
    by_name = {str(getattr(key, "name", key)): values for key, values in parameters.items()}
    rows = [by_name[letter.name] for letter in system.parameters]
    for letter, values in zip(system.parameters, rows, strict=True):
        for value in _telling(letter, values):
            as_assumed(letter, float(value))
    return rows


def _telling(letter: Symbol, values: Floats) -> Floats:
    """Values of which all are as a letter is assumed to be where these are."""
    words = ("integer", "noninteger", "even", "odd", "prime", "composite")
    if any(getattr(letter, f"is_{word}") is not None for word in words):
        return np.unique(values)
    if not len(values):
        return values
    return values[[values.argmin(), values.argmax(), np.abs(values).argmin()]]


@dataclass(frozen=True, eq=False)
class SystemMotions(Sequence[SystemMotion]):
    """Many motions of a system, a sequence of them; made by `System.motions`."""

    system: Computed
    parameters: Floats = field(repr=False)
    """In the order of `System.parameters`, shape (p, K); K runs as an array read row by row."""

    q: Floats = field(repr=False)
    """Shape (n, K)."""

    qdot: Floats = field(repr=False)
    """Shape (n, K)."""

    shape: tuple[int, ...]
    """Of the arrays that were given, broadcast: S."""

    def __len__(self) -> int:
        return int(self.q.shape[1])

    @overload
    def __getitem__(self, index: int) -> SystemMotion: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[SystemMotion, ...]: ...
    def __getitem__(self, index: int | slice) -> SystemMotion | tuple[SystemMotion, ...]:
        if isinstance(index, slice):
            return tuple(self[k] for k in range(*index.indices(len(self))))
        of_one = (tuple(x[:, index].tolist()) for x in (self.parameters, self.q, self.qdot))
        return SystemMotion(self.system, *of_one)

    def check(self) -> None:
        """Raises RigidtopError where one of the motions can't start so."""
        if self.system.constraints:
            suspects: Sequence[int] = range(len(self))
        else:
            try:
                with np.errstate(divide="raise", over="raise", invalid="raise"):
                    rates = self._rates(self._start, np.arange(len(self)))
                fine = np.isfinite(rates).all(axis=0) & self._allowed(self._start)
                suspects = np.flatnonzero(~fine).tolist()
            except FloatingPointError:  # as of 1/(1/0), which is finite all the same
                suspects = range(len(self))
        for k in suspects:
            self[k].check()

    def integrate(
        self,
        t: ArrayLike,
        method: str | None = None,
        rtol: float = 1e-10,
        atol: float = 1e-12,
        progress: Callable[[int, int], None] | None = None,
    ) -> Floats:
        """The coordinates and velocities at the N times `t`, shape (2, *S, N, n).

        As `SystemMotion.integrate` has them, to the tolerance; `way` says how they are found.
        Without a `method` it is "taylor" where heyoka is there and has all functions that occur,
        else "DOP853".  `progress` is called with the number of motions that are done, and of all.

        Raises RigidtopError where a motion does not arrive.
        """
        times = checks.times(t)
        checks.callback("progress", progress)
        if not len(self):
            raise RigidtopError("there are no motions: an array that was given is empty")
        accuracy = self.system.numeric.accuracy(method, rtol, atol)
        together = self._together(accuracy.method)
        size = AT_ONCE if together else 1
        states = np.empty((len(times), 2 * len(self.q), len(self)))
        for first in range(0, len(self), size):
            which = np.arange(first, min(first + size, len(self)))
            if together:
                states[..., which] = together(which, times, accuracy)
            for k in which[np.isnan(states[..., which]).any((0, 1))] if together else which:
                run = self[int(k)].integrate(times, accuracy.method, rtol, atol)
                states[..., k] = np.hstack([run.q, run.qdot])
            if progress is not None:
                progress(int(which[-1]) + 1, len(self))
        both = states.transpose(2, 0, 1).reshape(*self.shape, len(times), 2, len(self.q))
        return np.ascontiguousarray(np.moveaxis(both, -2, 0))

    def way(self, method: str | None = None) -> str:
        """How `integrate` goes about it, in words: in batches, on arrays or one after the other.

        >>> from sympy import symbols
        >>> from rigidtop.system.system import System
        >>> x, v = symbols("x v", real=True)
        >>> springs = System(v**2/2 - x**2/2, [x], [v]).motions(q=[[1, 2, 3]])
        >>> springs.way("DOP853"), springs.way("Radau")
        ('DOP853 on arrays of 2048', 'Radau, one after the other')
        """
        method = self.system.numeric.accuracy(method).method
        if not self._together(method):
            return f"{method}, one after the other"
        if method == TAYLOR:
            return f"{method} in batches of {taylor.batch()}"
        return f"{method} on arrays of {AT_ONCE}"

    def _together(self, method: str) -> Together | None:
        """What gives the states of motions together, NaN where it does not, if anything does."""
        # Each is brought back to constraints, and seen to be stuck, on its own.
        if self.system.constraints or self.system.switches:
            return None
        if method == "DOP853":
            return self._abreast
        # Between its times nobody sees on which side a coordinate of one sign is.
        return self._in_batches if method == TAYLOR and not self.system.one_sided else None

    @cached_property
    def _start(self) -> Floats:
        numeric = self.system.numeric
        more = np.zeros((int(numeric.works) + int(numeric.timed), len(self)))
        return np.concatenate([self.q, self.qdot, more])

    def _rates(self, states: Floats, which: NDArray[np.intp]) -> Floats:
        numeric, n = self.system.numeric, len(self.q)
        time = states[-1] if numeric.timed else np.zeros(len(which))
        rates = numeric.rates.array(time, *states[: 2 * n], *self.parameters[:, which])
        return np.concatenate([rates, np.ones((1, len(which)))]) if numeric.timed else rates

    def _allowed(self, states: Floats) -> NDArray[np.bool_]:
        allowed = np.ones(states.shape[1], dtype=bool)
        for k, sign in self.system.one_sided:
            allowed &= sign * states[k] > 0
        return allowed

    def _abreast(self, which: NDArray[np.intp], times: Floats, accuracy: Accuracy) -> Floats:
        problems = abreast.InitialValueProblems(
            lambda states, some: self._rates(states, which[some]),
            lambda states: sizes(self.system, states),
            self._allowed,
        )
        start = self._start[:, which]
        return self._settled(times, start, lambda at: abreast.states(problems, start, at, accuracy))

    def _in_batches(self, which: NDArray[np.intp], times: Floats, accuracy: Accuracy) -> Floats:
        start, series = self._start[:, which], self.system.numeric.series
        unit = sizes(self.system, start)
        values = with_units(self.system, unit, self.parameters[:, which])

        def states(at: Floats) -> Floats:
            with series(accuracy.rtol, taylor.batch()) as integrator:
                return taylor.sampled(integrator, start / unit, values, at) * unit

        return self._settled(times, start, states)

    def _settled(self, times: Floats, start: Floats, states: Callable[[Floats], Floats]) -> Floats:
        """The q and q̇ at `times`, of either sign; NaN where a finer tolerance is wanted."""
        samples = np.empty((len(times), *start.shape))
        for rows, ordered in sides(times):
            samples[rows] = states(ordered)
        largest = np.maximum(np.abs(start), np.abs(samples).max(axis=0))
        grown = sizes(self.system, largest) > TOO_SMALL * sizes(self.system, start)
        samples[..., ~grown.all(axis=0)] = np.nan
        return samples[:, : 2 * len(self.q)]
