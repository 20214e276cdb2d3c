"""Worlds: numbers for all letters at which equations hold, found from random starts.

Each is found by weighted least squares, in which the highest rates move first and parameters last.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import combinations, compress
from operator import attrgetter

import numpy as np
import sympy
from numpy.typing import NDArray
from sympy import Expr, I, Integer, Mul, Symbol, exp, factor_terms, fraction, together
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from rigidtop.judge.digits import Place, has_extremes, needed, places, refined
from rigidtop.judge.jets import TIME, Jet, jet_of, symbols
from rigidtop.judge.letters import VELOCITIES
from rigidtop.judge.program import Array, Program, Steps, UnknownFunctionError
from rigidtop.judge.solver import order, solved, starts, weight
from rigidtop.tree.nodes import Letter

WORLDS = 4
"""So many worlds are asked."""

SMALLEST = 0.02
"""A parameter nearer to zero makes a place degenerate, and such a place is no world."""

_ZERO = 1e-6

CLOSE, _FLOOR = 1e-7, 1e-4
"""Sides that are equal in exact worlds differ by no more than this share of their terms, which are
of the size of 1 where they are not zero."""

_INEXACT, _TINY = 1e-11, 1e-290
"""The numbers of worlds are off by this much, and nothing smaller is told from zero."""

_LARGEST = 1e12
"""Of sides with larger terms nothing is seen."""


NO_WORLD = "no world was found in which all above holds"
TOO_FEW_DIGITS = "a number in it is too small or too large to be seen beside the rest"


@dataclass(frozen=True, eq=False)
class Gaps:
    """By how much pairs of sides differ, with the size of their terms; a column a world.

    `values` are those of the sides one after the other; no less than `floor` is seen.
    """

    values: Array
    gap: NDArray[np.float64]
    size: NDArray[np.float64]
    floor: NDArray[np.float64]

    @cached_property
    def known(self) -> NDArray[np.bool_]:
        """In which worlds all of it has a value."""
        known = np.isfinite(self.gap).all(axis=0) & np.isfinite(self.size).all(axis=0)
        return np.asarray(known, bool)

    @property
    def extent(self) -> NDArray[np.float64]:
        """The size of the largest terms."""
        return np.asarray(self.size.max(axis=0, initial=0), float)

    @property
    def closed(self) -> NDArray[np.bool_]:
        """Which differ by no more than rounding."""
        return np.asarray(self.gap <= CLOSE * self.size + self.floor, bool)

    @property
    def are_hidden(self) -> bool:
        """Whether both sides are lost in the rounding of their terms."""
        seen = np.abs(self.values[:, self.known]).max(axis=0, initial=1)
        return bool((CLOSE * self.extent[self.known] > seen).any())

    @property
    def says_little(self) -> bool:
        """Whether somewhere all is zero, or so large that what is written is rounded away."""
        extent, floor = self.extent[self.known], self.floor.max(axis=0, initial=0)[self.known]
        return bool(((CLOSE * extent < floor) | (extent > _LARGEST)).any())


@dataclass(frozen=True, eq=False)
class Worlds:
    """Letters with their numbers, a column a world; none where no world was found.

    They are those of `equations`, `free` where no equation holds in them, and `tied` where they all
    have a difference of parameters that vanishes: what holds is hardly what is meant then.
    """

    letters: tuple[Symbol, ...]
    points: Array
    equations: tuple[Expr, ...] = ()
    free: bool = False
    tied: bool = False

    @property
    def count(self) -> int:
        return int(self.points.shape[1])

    @property
    def zeros(self) -> frozenset[Symbol]:
        """The letters that are zero in every world."""
        vanish: NDArray[np.bool_] = np.all(np.abs(self.points) < _ZERO, axis=1)
        return frozenset(compress(self.letters, vanish))

    @cached_property
    def program(self) -> Program:
        """What evaluates expressions in these worlds."""
        return Program(self.letters, self.points)

    def holds(self, sides: Sequence[tuple[Expr, Expr]], trivially: bool = True) -> bool | None:
        """Whether both sides agree in every world; None where they have a value in none.

        With `trivially` false they may not all be nothing but zeros, nor too large to be seen.
        """
        gaps = self._gaps(sides)
        if gaps is None or not gaps.known.any():
            return None
        if gaps.are_hidden:
            # Where equations hold and no number is large, they are divided by zero.
            told = self.free or self._may_hide(sides)
            exactly = self._holds_exactly(sides, gaps.known) if told else None
            return exactly if trivially else bool(exactly)
        if not trivially and gaps.says_little:
            return False
        holds = bool(gaps.closed[:, gaps.known].all())
        return self._holds_exactly(sides, gaps.known) if holds and self._may_hide(sides) else holds

    def why_unknown(self, sides: Sequence[tuple[Expr, Expr]]) -> str:
        """Why it is not known whether both sides agree."""
        return TOO_FEW_DIGITS if self.count and self._may_hide(sides) else NO_WORLD

    def holds_one(self, sides: Sequence[tuple[Expr, Expr]]) -> bool:
        """Whether in every world one of several pairs of sides agrees."""
        gaps = self._gaps(sides)
        if gaps is None or not gaps.closed.any(axis=0).all():
            return False
        return not self._may_hide(sides) or all(
            place is not None and any(place.agree(*pair) for pair in sides)
            for place in self._places(sides)
        )

    def vanish(self, expressions: Sequence[Expr]) -> bool:
        """Whether all of them are zero in every world."""
        if not self.knows(expressions) or not self.count:
            return False
        values = np.abs(self.program.values(expressions).values)
        return bool((values < _ZERO).all() and (values <= self._noise(expressions)).all())

    def _gaps(self, sides: Sequence[tuple[Expr, Expr]]) -> Gaps | None:
        """By how much both sides differ; None where there are no worlds, or no numbers in them."""
        expressions = [x for pair in sides for x in pair]
        if not self.knows(expressions) or not self.count:
            return None
        try:
            found = self.program.values(expressions)
        except UnknownFunctionError:
            return None
        size = found.sizes[::2] + found.sizes[1::2]
        gap = np.abs(found.values[::2] - found.values[1::2])
        floor = np.full(gap.shape, _FLOOR * CLOSE)
        if (size < _FLOOR).any():  # small numbers may be all that is written
            floor = np.minimum(floor, self._noise([a - b for a, b in sides]))
        return Gaps(found.values, gap, size, floor)

    def _noise(self, expressions: Sequence[Expr]) -> NDArray[np.float64]:
        """By how much values change as the numbers of the worlds do within their errors."""
        slopes = Steps(expressions, self.letters).at(self.points).slopes
        total = np.abs(slopes).sum(axis=1)
        return np.where(np.isfinite(total), _INEXACT * total, np.inf) + _TINY

    def _places(self, sides: Sequence[tuple[Expr, Expr]]) -> tuple[Place | None, ...]:
        """The worlds with as many digits as tell these sides apart; None where one has too few."""
        return _with_digits(self, needed([*self.equations, *(x for pair in sides for x in pair)]))

    def _holds_exactly(
        self, sides: Sequence[tuple[Expr, Expr]], known: NDArray[np.bool_]
    ) -> bool | None:
        """The same with many digits; None where a world has not so many of them."""
        unknown = False
        for place in compress(self._places(sides), known):
            for pair in sides:
                agree = place.agree(*pair) if place is not None else None
                if agree is False:
                    return False
                unknown |= agree is None
        return None if unknown else True

    def _may_hide(self, sides: Sequence[tuple[Expr, Expr]]) -> bool:
        """Whether a number is so small or large that these sides may differ without being seen."""
        return self._hide or any(has_extremes(x) for pair in sides for x in pair)

    @cached_property
    def _hide(self) -> bool:
        return any(map(has_extremes, self.equations))

    def signs(self, expressions: Sequence[Expr]) -> NDArray[np.float64] | None:
        """The sign of each expression in each world; None where they are no numbers."""
        if not self.knows(expressions) or not self.count:
            return None
        values = self.program.values(expressions).values
        return np.sign(values.real) if np.isfinite(values).all() else None

    def knows(self, expressions: Sequence[Expr]) -> bool:
        """Whether each letter of some expressions has a number."""
        known = {*self.letters}
        return all(symbols(x) <= known for x in expressions)


def found(
    equations: Sequence[Expr],
    letters: Sequence[Symbol],
    may_vanish: Collection[Letter] = (),
    not_zero: Sequence[Expr] = (),
    enough: int = WORLDS,
) -> Worlds:
    """Worlds in which `equations` vanish; those with real numbers, if there are any.

    No parameter is zero there but those that `may_vanish`, which may be negative too, nor is
    anything that is `not_zero`.
    More worlds are looked for until there are `enough`, from three times as many places.
    """
    if not equations or not letters:
        return Worlds(tuple(letters), starts(letters, 0)[:, :WORLDS], free=True)
    settled = tuple(equations), tuple(letters), frozenset(may_vanish), tuple(not_zero)
    return _found(*settled, enough)


@lru_cache(maxsize=512)
def _found(
    equations: tuple[Expr, ...],
    letters: tuple[Symbol, ...],
    may_vanish: frozenset[Letter],
    not_zero: tuple[Expr, ...],
    enough: int,
) -> Worlds:
    fixed = _parameters(letters)
    weights = np.array([0.3 if x in fixed else weight(x) for x in letters])
    parameters = np.array([x in fixed and not _is_of(x, may_vanish) for x in letters])
    still = [e for e in equations if symbols(e) <= fixed]
    factors = (x for e in equations if e not in still for x in _factors(e) if symbols(x) <= fixed)
    ties = [x for x in factors if not any(symbols(x) <= symbols(e) for e in still)]
    speeds = [x for x in letters if _is_speed(x)]
    backwards = frozenset({*speeds, *(x for x in letters if _is_of(x, may_vanish))})
    sums = [*ties, *(x for e in still for x in _factors(e))]
    sums += [x - y for x, y in combinations(speeds, 2)]  # after an impact as before it
    phased = any(x.has(I) for x in equations)
    amplitudes = np.array([phased and _is_of(x, may_vanish) for x in letters])
    every = np.zeros((len(letters), 0), complex)
    for seed in range(_SEEDS):
        try:
            origins = starts(letters, seed, backwards)[:, : 3 * enough]
            points, exact = _with_amplitudes(
                equations, letters, origins, weights, enough, amplitudes
            )
            if not exact.any():
                points, exact = solved(equations, letters, origins, weights, enough)
            if exact.any() and not _stay(points, exact, parameters).any():
                # A parameter that everything is multiplied by goes to zero.
                bare = [_without_factors(x, fixed) for x in equations]
                points, exact = solved(bare, letters, origins, weights, enough)
            exact &= _is_not_zero(not_zero, letters, points)
        except UnknownFunctionError:
            break
        exact = _stay(points, exact, parameters)
        exact &= (np.abs(points) < 1e4).all(axis=0)
        every = np.hstack([every, points[:, exact]])
        if not every.size and (seed or not speeds):
            break  # what does not hold together at so many places hardly does at others
        zero, real = _vanishing(letters, every, sums)
        # What vanishes wherever it was tried has to vanish: no other place will tell more.
        forced = zero[:, real].all(axis=1, keepdims=True)
        if (real & (zero <= forced).all(axis=0)).sum() >= enough:
            break
    if not every.size:
        return Worlds(letters, every, equations)
    nothing = [x for x, at in zip(letters, zero, strict=False) if at.all()]
    bare = [_with_other_factors(x, nothing) for x in equations] if nothing else [*equations]
    if bare != [*equations]:
        # Of ε (ω² − k) = 0 it is the other factor that is meant to vanish.
        origins = starts(letters, 0, backwards)[:, : 3 * enough]
        points, exact = solved(bare, letters, origins, weights, enough)
        exact = _stay(points, exact & _is_not_zero(not_zero, letters, points), parameters)
        every = np.hstack([every, points[:, exact & (np.abs(points) < 1e4).all(axis=0)]])
        zero, real = _vanishing(letters, every, sums)
    tried = _in_exponents(equations)
    free = np.array([x in tried or _is_of(x, may_vanish) for x in letters])
    if tried and not phased and (np.abs(every[free]) < SMALLEST).any(axis=0).all():
        # With real numbers exp(κ t) solves nothing but where κ, or what it multiplies, is zero.
        turned = starts(letters, 0) * np.exp(1j * np.arange(len(letters)))[:, None]
        points, exact = solved(equations, letters, turned, weights, enough)
        exact = _stay(points, exact, parameters | free)
        every = np.hstack([every, points[:, exact & (np.abs(points) < 1e4).all(axis=0)]])
        zero, real = _vanishing(letters, every, sums)
    turns = _half_turns(equations, letters, every)
    if turns.any():
        # An angle that is π there may be zero as well.
        origins = starts(letters, 0)[:, : 3 * enough] * np.where(turns, 0.1, 1)[:, None]
        points, exact = solved(equations, letters, origins, weights, enough)
        exact = _stay(points, exact & _is_not_zero(not_zero, letters, points), parameters & ~turns)
        every = np.hstack([every[:, : (enough + 1) // 2], points[:, exact]])
        zero, real = _vanishing(letters, every, sums)
        zero[: len(letters)][turns] = False
    # A place where something happens to vanish says less than one where nothing does, or only
    # the rate of it.
    vanishing = np.array([4 - min(order(x), 3) for x in letters] + [4] * len(sums)) @ zero
    chosen = vanishing == vanishing.min()
    chosen = chosen & real if (chosen & real).sum() >= 2 else chosen
    tied = bool(zero[len(letters) : len(letters) + len(ties), chosen].all(axis=1).any())
    return Worlds(letters, every[:, chosen][:, :WORLDS], equations, tied=tied)


@lru_cache(maxsize=50)
def _with_digits(worlds: Worlds, digits: int) -> tuple[Place | None, ...]:
    """The places of worlds with many digits; none where nothing says what holds in them."""
    if worlds.free:
        return tuple(places(worlds.letters, worlds.points, digits, exact=True))
    if not worlds.equations:
        return (None,) * worlds.count
    return tuple(refined(worlds.equations, worlds.letters, worlds.points, digits))


_SEEDS = 3


def _vanishing(
    letters: Sequence[Symbol], points: Array, sums: Sequence[Expr]
) -> tuple[NDArray[np.bool_], NDArray[np.bool_]]:
    """Which letters and sums are zero at each of some points, and which of these are real."""
    zero = np.abs(np.vstack([points, Program(letters, points).values(sums).values])) < 1e-6
    return zero, np.abs(points.imag).max(axis=0, initial=0) < 1e-9


def _in_exponents(equations: Iterable[Expr]) -> frozenset[Symbol]:
    """The letters that stand beside the time in an exponent, as κ in exp(κ t)."""
    exponents = (x.args[0] for e in equations for x in e.atoms(exp) if TIME in symbols(x))
    return frozenset().union(*map(symbols, exponents)) - {TIME}


def _half_turns(
    equations: Sequence[Expr], letters: Sequence[Symbol], points: Array
) -> NDArray[np.bool_]:
    """Which letters are angles that are multiples of π in all worlds, and not zero in all."""
    with np.errstate(all="ignore"):
        whole = np.abs(np.sin(points)) < 1e-6
    turns: NDArray[np.bool_] = np.logical_and(whole.all(axis=1), (np.abs(points) > 1).any(axis=1))
    if not turns.any():
        return turns
    outside = [e.replace(TrigonometricFunction, lambda *_: Integer(1)) for e in equations]
    free = {x for e in outside for x in symbols(e)}
    return turns & [x not in free for x in letters]


def _with_amplitudes(
    equations: Sequence[Expr],
    letters: Sequence[Symbol],
    origins: Array,
    weights: NDArray[np.float64],
    enough: int,
    amplitudes: NDArray[np.bool_],
) -> tuple[Array, NDArray[np.bool_]]:
    """The same with complex numbers for amplitudes alone, where all others are real."""
    if not amplitudes.any():
        return origins, np.zeros(origins.shape[1], bool)
    names = {x for x, is_one in zip(letters, amplitudes, strict=True) if is_one}
    others = [x for x in equations if not symbols(x) & names]
    if others:
        origins, exact = solved(others, letters, origins, np.where(amplitudes, 0, weights), enough)
        origins = origins[:, exact]
    made, exact = solved(equations, letters, origins, np.where(amplitudes, weights, 0), enough)
    return made, _stay(made, exact, amplitudes)


def _without_factors(equation: Expr, parameters: Collection[Symbol]) -> Expr:
    """What vanishes in an equation whose parameters do not: neither a factor nor a denominator."""
    factors = Mul.make_args(_above(equation))
    return Mul(*(x for x in factors if x.as_base_exp()[0] not in parameters))


def _with_other_factors(equation: Expr, zeros: Collection[Symbol]) -> Expr:
    """What else makes an equation hold than that some letters vanish; itself if nothing does."""
    here = [x for x in zeros if x in symbols(equation) and _is_multiple(equation, x)]
    other = _without_factors(equation, here) if here else equation
    return other if symbols(other) else equation


def _is_multiple(expression: Expr, x: Symbol) -> bool:
    """Whether each of its terms has the factor `x`, as they are written."""
    if expression.is_Add:
        return all(_is_multiple(y, x) for y in expression.args)
    if expression.is_Mul:
        return any(_is_multiple(y, x) for y in expression.args)
    base, exponent = expression.as_base_exp()
    return base == x and bool(exponent.is_positive)


@lru_cache(maxsize=1_000)
def _above(equation: Expr) -> Expr:
    """What stands above in an equation over one denominator, with its factors taken out."""
    return factor_terms(fraction(together(equation))[0])


def _stay(
    points: Array, exact: NDArray[np.bool_], parameters: NDArray[np.bool_]
) -> NDArray[np.bool_]:
    """The worlds among the exact ones in which none of these letters is zero."""
    return exact & ~(np.abs(points[parameters]) < SMALLEST).any(axis=0)


@lru_cache(maxsize=20_000)
def _factors(expression: Expr) -> tuple[Expr, ...]:
    """The sums by which something is multiplied in it, as B − ρ in (B − ρ) θ̈."""
    bases = (x.base if x.is_Pow else x for x in expression.args)
    own = [x for x in bases if x.is_Add] if expression.is_Mul else []
    return tuple(dict.fromkeys([*own, *(y for x in expression.args for y in _factors(x))]))


def _is_not_zero(
    expressions: Sequence[Expr], letters: Sequence[Symbol], points: Array
) -> NDArray[np.bool_]:
    known = [x for x in expressions if x.free_symbols <= {*letters}]
    values = Program(letters, points).values(known).values
    return np.asarray((np.abs(values) > SMALLEST).all(axis=0), bool)


def _is_speed(x: Symbol) -> bool:
    """Whether it is a speed by its name."""
    jet = jet_of(x)
    return jet is not None and not jet.order and jet.letter.base in VELOCITIES


def _parameters(letters: Sequence[Symbol]) -> frozenset[Symbol]:
    """The letters of which no rate is asked, and that are not what one is at an instant."""
    known = [(x, jet) for x, jet in zip(letters, map(jet_of, letters), strict=True) if jet]
    moving = {jet.letter for _, jet in known if jet.order}
    return frozenset(
        x
        for x, jet in known
        if not (jet.order or jet.instant or is_component(jet) or jet.letter in moving)
    )


def _is_of(x: Symbol, letters: Collection[Letter]) -> bool:
    jet = jet_of(x)
    return jet is not None and jet.letter in letters


def is_component(jet: Jet) -> bool:
    """Whether it is one number of a vector."""
    return jet.letter.bold or jet.letter.mark == "hat"


def rank(equations: Sequence[Expr], worlds: Worlds, by: Sequence[Symbol]) -> int:
    """How many of the equations are independent as equations for some letters."""
    if not equations or not by or not worlds.count:
        return 0
    places = [worlds.letters.index(x) for x in by]
    try:
        at = Steps(equations, worlds.letters).at(worlds.points[:, :1])
    except UnknownFunctionError:
        return 0
    slopes = at.slopes[:, places, 0]
    if not np.isfinite(slopes).all():
        return 0
    scale = np.abs(slopes).max(axis=1, keepdims=True)
    return int(np.linalg.matrix_rank(slopes / np.where(scale > 0, scale, 1), tol=1e-8))


def symbols_of(expressions: Sequence[Expr]) -> tuple[Symbol, ...]:
    """The letters of expressions, always in the same order."""
    every: set[Symbol] = set().union(*(symbols(sympy.sympify(x)) for x in expressions))
    return tuple(sorted(every, key=attrgetter("name")))
