"""Parameters of a system, and where it started, from what was measured of its motion."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import pairwise
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike
from sympy import Expr, Symbol

from rigidtop.codegen.numpy import Function
from rigidtop.errors import RigidtopError
from rigidtop.motion import checks
from rigidtop.motion.attitude import Floats
from rigidtop.motion.least_squares import Fit, FitModel, reported, solved
from rigidtop.parameters import in_one_line
from rigidtop.system.motion import SystemMotion
from rigidtop.system.names import Given, as_assumed, mapping
from rigidtop.system.numeric import Computed
from rigidtop.system.sensitivities import check_smooth, letter_of

FACTOR = 3.0
"""Of a parameter with a value to start from, the search begins between its third and its triple."""

NEAR = 6
"""A start that is not given is guessed from so many rows by each coordinate that was measured."""

SHARE = 1e-2
"""Less than this part of a change that changes nothing is left of slopes that are not exact."""

WHOLE = 4
"""Powers in a product of parameters are told up to this number."""


class SystemFit(Fit[SystemMotion]):
    """The fit of a system: the parameters asked for, and the start where it was not given."""

    @property
    def parameters(self) -> dict[Expr, float]:
        """What came out for each parameter, by its symbol, in the order of `values`."""
        letters = {x.name: x for x in self.motion.system.parameters}
        return {letters[name]: x for name, x in self.values.items() if name in letters}


@dataclass(frozen=True)
class Range:
    """Where a search looks for a number: at first at `guess`, and then from `low` to `high`."""

    guess: float
    low: float
    high: float

    def at(self, share: Floats) -> Floats:
        """Shares from 0 to 1 of the range; of a positive one, of its logarithm."""
        if self.low > 0:
            return np.asarray(self.low * (self.high / self.low) ** share)
        return self.low + (self.high - self.low) * share


@dataclass(frozen=True, eq=False)
class SystemModel(FitModel[SystemMotion]):
    """The letters that are free, in a row; the rest of the motion as it is given."""

    unknown = "the parameters can't be known from this"
    significant: ClassVar[float] = -math.inf  # a system at rest tells them too
    rank: ClassVar[float] = 1e-5  # the slopes come from motions that are as good as their rtol

    system: Computed
    ranges: Mapping[Symbol, Range]
    """Of the n letters that are free: parameters, coordinates and velocities at t = 0."""

    given: Mapping[Symbol, float]
    """The numbers of the others."""

    quantities_measured: tuple[Expr, ...]
    """In plain symbols."""

    data_by_name: Mapping[str, Floats]
    noise: Floats | None
    places: int
    """Where a search begins."""

    how: Mapping[str, Any]
    """The method and the tolerances of the motions."""

    @property
    def measured(self) -> dict[str, Floats]:
        return dict(self.data_by_name)

    @property
    def groups(self) -> list[int]:
        return [*range(len(self.data_by_name))]

    @property
    def sigma(self) -> Floats | None:
        return self.noise

    def motion(
        self, parameters: Floats, values: Mapping[str, float] | None = None, since: float = 0.0
    ) -> SystemMotion:
        system = self.system
        number = {**self.given, **dict(zip(self.ranges, parameters.tolist(), strict=True))}
        for x in self.ranges:
            as_assumed(x, number[x])
        rows = (system.parameters, system.names.q, system.names.v)
        motion = SystemMotion(system, *(tuple(number[x] for x in row) for row in rows))
        motion.check()
        return motion

    @cached_property
    def _values(self) -> Function:
        return self.system.numeric.of(self.quantities_measured)

    @cached_property
    def _slopes(self) -> Function:
        """The derivatives of each quantity by q, q̇ and the free letters, (m (2n + k))."""
        names = self.system.names
        own = [x for x in self.ranges if x in self.system.parameters]
        letters = [*names.q, *names.v, *own]
        slopes = (x.diff(y) for x in self.quantities_measured for y in letters)
        return self.system.numeric.of(tuple(slopes))

    def computed(self, parameters: Floats, rows: Any) -> Floats:
        """NaN for parameters with which there is no motion."""
        times, count = self.t[rows], len(self.quantities_measured)
        result = np.full((len(parameters), len(times), count), np.nan)
        for k, each in enumerate(parameters):
            try:
                motion = self.motion(each)
                run = motion.integrate(times, **self.how)
            except RigidtopError:
                continue
            columns = (times, *run.q.T, *run.qdot.T, *motion.parameters)
            result[k] = self._values.array(*columns).T
        return result

    def slopes(self, parameters: Floats, rows: Any, weights: Floats) -> Floats:
        """The derivatives by the variational equations; zeros where there is no motion."""
        times, free = self.t[rows], [*self.ranges]
        try:
            motion = self.motion(parameters)
            run = motion.sensitivities(times, free, **self.how)
        except RigidtopError:
            return np.zeros((len(times) * len(weights), len(free)))
        columns = (times, *run.q.T, *run.qdot.T, *motion.parameters)
        derivatives = self._slopes.array(*columns).reshape(len(weights), -1, len(times))
        states = np.concatenate([run.q_by, run.qdot_by], axis=1)
        slopes = np.einsum("mit,tik->tmk", derivatives[:, : states.shape[1]], states)
        own = [k for k, x in enumerate(free) if x in self.system.parameters]
        slopes[:, :, own] += derivatives[:, states.shape[1] :].transpose(2, 0, 1)
        return np.asarray((slopes * weights[:, None]).reshape(-1, len(free)))

    def starts(self) -> list[Floats]:
        """The guess, and places of a Latin hypercube: of each range every part is looked at."""
        draw = np.random.default_rng(1)
        count = self.places - 1
        shares = [(draw.permutation(count) + 0.5) / max(count, 1) for _ in self.ranges]
        drawn = [x.at(share) for x, share in zip(self.ranges.values(), shares, strict=True)]
        return [np.array([x.guess for x in self.ranges.values()]), *np.stack(drawn, axis=-1)]

    def telling(self, parameters: Floats) -> Floats:
        return np.empty(0)  # every error is reported, however large

    def quantities(self, parameters: Floats) -> dict[str, Floats]:
        spelled = self.system.names.spelled
        return {spelled(x): parameters[:, k] for k, x in enumerate(self.ranges)}

    def still(self) -> Floats:
        """The residuals of a mean value, which set the size of the noise at first."""
        away = self.data - self.data.mean(axis=0)
        return np.where(np.ptp(self.data, axis=0) > 0, away, self.data)

    def unknown_along(self, parameters: Floats, changes: Floats, norms: Floats) -> str:
        """Says which letters, or which products of powers of them, can be known."""
        letters = [self.system.names.spelled(x) for x in self.ranges]
        moved = [k for k in range(len(letters)) if np.abs(changes[:, k]).max() > SHARE]
        names = _listed([letters[k] for k in moved])
        if len(moved) == len(changes):
            return (
                f"{names} can't be known from this: what was measured does not change with "
                f"{'it' if len(moved) == 1 else 'them'}; give a number by known = {{…}} or start"
            )
        remark = ""
        relative = (changes / norms)[:, moved] / np.where(parameters, parameters, 1.0)[moved]
        powers = _whole(relative[0]) if len(changes) == 1 else []
        if powers:
            products = [
                _product({letters[a]: q, letters[b]: -p})
                for (a, p), (b, q) in pairwise(zip(moved, powers, strict=True))
            ]
            remark = f": only {_listed(products)} {'is' if len(products) == 1 else 'are'} known"
        return (
            f"{names} can't all be known from this{remark or ': some of them change together'}; "
            "give a number to one of them, by known = {…} or start"
        )


def _listed(words: Sequence[str]) -> str:
    return ", ".join(words[:-1]) + " and " * (len(words) > 1) + words[-1]


def _whole(change: Floats) -> list[int]:
    """Whole numbers in the ratio of some numbers, none of them 0; empty where none are small."""
    least = change / change[np.argmin(np.abs(change))]
    for factor in range(1, WHOLE + 1):
        powers = np.round(least * factor)
        if np.all(np.abs(least * factor - powers) < 1e-3) and np.all(np.abs(powers) <= WHOLE):
            return [int(x) for x in powers]
    return []


def _product(powers: Mapping[str, int]) -> str:
    """A product of powers as it is written: k/m, k*m, k/m**2; the first without a minus."""
    (first, p), (second, q) = powers.items()
    share = Fraction(q, p)
    p, q = abs(share.denominator), share.numerator
    head = first if p == 1 else f"{first}**{p}"
    tail = second if abs(q) == 1 else f"{second}**{abs(q)}"
    return f"{head}{'*' if q > 0 else '/'}{tail}"


# --- what is given --------------------------------------------------------------------------------


def fitted(
    system: Computed,
    t: ArrayLike,
    measured: Mapping[Expr, ArrayLike],
    parameters: Mapping[Expr, object] | None,
    start: Mapping[Expr, object] | None,
    known: Mapping[Expr, object] | None,
    sigma: Given,
    starts: int,
    how: Mapping[str, Any],
) -> SystemFit:
    """The parameters that fit measured columns best: see `System.fit`."""
    times = checks.times(t)
    if np.any(np.diff(times) <= 0):
        raise RigidtopError("t must increase from row to row")
    columns = _columns(system, measured, times)
    names = system.names
    free, fixed = _ranges(system, parameters, known)
    states = _by_letter(system, "start", start, (*names.q, *names.v))
    guesses = _guesses(system, times, dict(columns.values()))
    for x in (*names.q, *names.v):
        if x not in states:
            guess = guesses.get(x, 0.0)
            spread = abs(guess) or 1.0
            free[x] = Range(guess, guess - spread, guess + spread)
        elif isinstance(states[x], (tuple, list)):
            free[x] = _range(x.name, states[x])
        else:
            fixed[x] = checks.number(x.name, states[x])
    if not free:
        raise RigidtopError("what shall be found? parameters = {symbol: value or (low, high)}")
    check_smooth(system, [*free])
    places = checks.whole("starts", starts, 1)
    noise = None if sigma is None else _noise(sigma, measured, len(columns))
    data = {name: column for name, (_, column) in columns.items()}
    quantities = tuple(x for x, _ in columns.values())
    model = SystemModel(times, system, free, fixed, quantities, data, noise, places, how)
    first = model.motion(model.starts()[0])  # where there is none, it is said why
    first.sensitivities(times[:1], [*free], **how)
    with np.errstate(all="ignore"):
        best, covariance = solved(model)
        values, covariance = reported(model, best, covariance)
        computed = dict(zip(data, model.computed(best[None], slice(None))[0].T, strict=True))
    return SystemFit(model.motion(best), values, covariance, times, data, computed)


def _columns(system: Computed, measured: Given, times: Floats) -> dict[str, tuple[Expr, Floats]]:
    """Quantities in plain symbols, and what was measured of them, by name."""
    if not isinstance(measured, Mapping) or len(measured) == 0:
        raise RigidtopError(
            f"what was measured is given as {{quantity: row of {len(times)} numbers}}, "
            f"not {in_one_line(measured)}"
        )
    columns = {}
    for key, values in measured.items():
        plain = system.varying("what was measured", key)
        name = system.names.spelled(plain) if isinstance(plain, Symbol) else str(key)
        column = checks.numbers(f"what was measured of {name}", values)
        if column.shape != times.shape:
            raise RigidtopError(
                f"what was measured of {name} must be {len(times)} numbers, as t has them, "
                f"not of shape {column.shape}"
            )
        columns[name] = (plain, column)
    system.numeric.of(tuple(x for x, _ in columns.values()))  # complains of unknown letters
    return columns


def _by_letter(
    system: Computed, what: str, values: Mapping[Expr, object] | None, letters: Sequence[Symbol]
) -> dict[Symbol, Any]:
    by_letter = {}
    for key, value in mapping(f"{what} is given as {{symbol: value}}", values).items():
        try:
            letter = letter_of(system, key)
        except RigidtopError:
            letter = None
        if letter not in letters:
            there = ", ".join(map(system.names.spelled, letters)) or "nothing"
            raise RigidtopError(f"{what} has {in_one_line(key)}: there is {there}")
        by_letter[letter] = value
    return by_letter


def _ranges(
    system: Computed,
    parameters: Mapping[Expr, object] | None,
    known: Mapping[Expr, object] | None,
) -> tuple[dict[Symbol, Range], dict[Symbol, float]]:
    """Where free parameters are looked for, and the numbers of the others."""
    asked = _by_letter(system, "parameters", parameters, system.parameters)
    numbers = _by_letter(system, "known", known, system.parameters)
    for x in system.parameters:
        if (x in asked) == (x in numbers):
            both = "is in parameters and in known" if x in asked else "has no number"
            raise RigidtopError(
                f"{x.name} {both}: parameters has what shall be found, known all the others"
            )
    free = {x: _range(x.name, value) for x, value in asked.items()}
    fixed = {x: checks.number(x.name, value) for x, value in numbers.items()}
    for x in asked:
        as_assumed(x, free[x].guess)
    for x, number in fixed.items():
        as_assumed(x, number)
    return free, fixed


def _range(name: str, value: object) -> Range:
    """The range that is given as a number, or as a pair of numbers."""
    if isinstance(value, (tuple, list)):
        ends = [checks.number(name, x) for x in value]
        if len(ends) != 2 or ends[0] >= ends[1]:
            raise RigidtopError(f"the range of {name} is (low, high), not {in_one_line(value)}")
        low, high = ends
        return Range(math.sqrt(low * high) if low > 0 else (low + high) / 2, low, high)
    guess = checks.number(name, value)
    if guess == 0:
        return Range(0.0, -1.0, 1.0)
    ends = sorted([guess / FACTOR, guess * FACTOR])
    return Range(guess, *ends)


def _noise(sigma: Given, measured: Mapping[Expr, ArrayLike], count: int) -> Floats:
    """The standard deviation of each column, from one number or from one for each quantity."""
    if not isinstance(sigma, Mapping):
        return np.full(count, checks.positive("sigma", sigma))
    if {*sigma} != {*measured}:
        raise RigidtopError("sigma is one number, or has one for each quantity that was measured")
    return np.array([checks.positive(f"sigma of {x}", sigma[x]) for x in measured])


def _guesses(system: Computed, times: Floats, data: Mapping[Expr, Floats]) -> dict[Symbol, float]:
    """Coordinates and velocities at t = 0, by a parabola through what was measured near it."""
    names = system.names
    guesses: dict[Symbol, float] = {}
    near = np.argsort(np.abs(times), kind="stable")[:NEAR]
    for x, v in zip(names.q, names.v, strict=True):
        if x in data and len(near) > 2:
            _, slope, place = np.polyfit(times[near], data[x][near], 2)
            guesses |= {x: float(place), v: float(slope)}
        if v in data:
            guesses[v] = float(data[v][near[0]])
    return guesses
