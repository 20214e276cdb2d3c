"""Least squares between measurements and a motion in closed form, from several starts.

The first guess comes from linear least squares on equations of motion that were integrated once in
time, so that nothing noisy is differentiated.  From there, and from other starts, the method of
Levenberg and Marquardt goes on through windows that double, in which a wrong period is still right
to half a turn, and from each to the next the better half of the starts.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar, Generic, TypeVar

import numpy as np
from scipy.optimize import least_squares

from rigidtop.errors import RigidtopError
from rigidtop.motion.attitude import Floats

Moves = TypeVar("Moves", covariant=True)
"""The kind of the motion."""

STEP = 1e-7
"""Of a derivative by a parameter, relative to the parameter or 1."""

SEARCHED = 200
"""Rows of a window that a search looks at."""

WINDOWS = (1 / 16, 1 / 8, 1 / 4, 1 / 2, 1.0)
"""How much of the data a search has seen, one after the other."""

SIGNIFICANT = 100.0
"""By so many variances a motion must be better than one that tells no moments."""

RANK = 1e-9
"""Of slopes that are as good as `STEP` leaves them."""

VAGUE = 0.2
"""A relative error from which on a linear estimate of it means little."""


@dataclass(frozen=True, eq=False)
class Fit(Generic[Moves]):
    """What measurements tell of a body or a system, made by `rigidtop.fit` or `System.fit`."""

    motion: Moves
    """The motion that fits, at t = 0 of the measured times: ``fit.motion.exact(t)``."""

    values: dict[str, float]
    """Every quantity by its name, in SI units."""

    covariance: Floats
    """Of the `values`, in their order; zeros where a number was given and not measured."""

    t: Floats
    """The times, shape (N,), in s."""

    measured: dict[str, Floats]
    """What was measured, by name and unit, each of shape (N,)."""

    computed: dict[str, Floats]
    """What the motion has at those times."""

    @property
    def errors(self) -> dict[str, float]:
        """The standard errors of the `values`, by name."""
        return dict(zip(self.values, np.sqrt(np.diag(self.covariance)).tolist(), strict=True))

    @property
    def residuals(self) -> dict[str, Floats]:
        """The measured columns minus the computed ones, by name."""
        return {name: data - self.computed[name] for name, data in self.measured.items()}

    def __repr__(self) -> str:
        errors = self.errors
        rows = (f"{name} = {x:.6g} ± {errors[name]:.2g}" for name, x in self.values.items())
        return f"<{type(self).__name__} of {len(self.t)} rows: {', '.join(rows)}>"


@dataclass(frozen=True, eq=False)
class FitModel(ABC, Generic[Moves]):
    """Measurements, and a motion with parameters in a row; of many such rows the columns."""

    t: Floats
    """Times (N,), from the first on (s)."""

    @property
    @abstractmethod
    def measured(self) -> dict[str, Floats]:
        """The columns (N,), by name and unit."""

    @property
    @abstractmethod
    def groups(self) -> list[int]:
        """The number of each column's instrument: columns of one have the same noise."""

    @abstractmethod
    def computed(self, parameters: Floats, rows: Any) -> Floats:
        """The columns (P, N, m) at some rows of times, of parameters (P, n)."""

    @abstractmethod
    def starts(self) -> list[Floats]:
        """Parameters to start from, the best guess first."""

    unknown: ClassVar[str]
    """What is said where nothing can be known."""

    significant: ClassVar[float] = SIGNIFICANT
    """By so many variances the motion must be better than `still`."""

    rank: ClassVar[float] = RANK
    """A singular value of the slopes below this part of the largest is none."""

    @property
    def sigma(self) -> Floats | None:
        """The noise of each column, (m,), or None where the residuals have to tell it."""
        return None

    def unknown_along(self, parameters: Floats, changes: Floats, norms: Floats) -> str:
        """What is said where changes of the parameters (j, n) change nothing that was measured.

        They are told in units of 1/`norms`, by which each parameter alone changes as much.
        """
        return self.unknown

    @abstractmethod
    def telling(self, parameters: Floats) -> Floats:
        """What the errors of the first parameters must be small to."""

    @abstractmethod
    def motion(self, parameters: Floats, values: dict[str, float], since: float) -> Moves:
        """The motion at t = 0, with a first time `since`."""

    def settled(self, parameters: Floats) -> Floats:
        """The parameters whose names are right, of those that make the same motion."""
        return parameters

    @abstractmethod
    def quantities(self, parameters: Floats) -> dict[str, Floats]:
        """The quantities that a fit reports, each (P,), by name."""

    @abstractmethod
    def still(self) -> Floats:
        """Residuals (N, m) of the motion from which nothing can be known."""

    def slopes(self, parameters: Floats, rows: Any, weights: Floats) -> Floats:
        """Derivatives of the `residuals` by the parameters, (N m, n)."""
        return _slopes(lambda p: self.residuals(p, rows, weights), parameters)

    @cached_property
    def data(self) -> Floats:
        return np.stack([*self.measured.values()], axis=-1)

    def residuals(self, parameters: Floats, rows: Any, weights: Floats) -> Floats:
        """Computed minus measured in units of the noise, (P, N m)."""
        with np.errstate(all="ignore"):
            far = self.computed(np.atleast_2d(parameters), rows) - self.data[rows]
        scaled = np.where(np.isfinite(far), far, 1e6) * weights
        return np.asarray(scaled.reshape(len(scaled), -1))


def _slopes(function: Callable[[Floats], Floats], parameters: Floats) -> Floats:
    """Derivatives (…, n) of what a function makes of rows of parameters, (P, …)."""
    steps = STEP * np.maximum(np.abs(parameters), 1.0)
    values = function(np.concatenate([parameters + np.diag(steps), [parameters]]))
    slopes: Floats = (values[:-1] - values[-1]).T / steps
    return slopes


def _descended(
    model: FitModel[Any], start: Floats, rows: Any, weights: Floats, patience: int
) -> Any:
    """The least squares near a start: SciPy's result."""

    def residuals(parameters: Floats) -> Floats:
        return np.asarray(model.residuals(parameters, rows, weights)[0])

    def slopes(parameters: Floats) -> Floats:
        return model.slopes(parameters, rows, weights)

    return least_squares(residuals, start, slopes, method="lm", x_scale="jac", max_nfev=patience)


def _searched(model: FitModel[Any], weights: Floats) -> Floats:
    """Parameters of the best motion to which a start leads."""
    count, starts = len(model.t), model.starts()
    ends = [_descended(model, starts[0], _spread(count), weights, 60)]
    for share in WINDOWS:
        stop = max(round(share * count), min(4 * len(starts[0]), count))
        reached = [_descended(model, start, _spread(stop), weights, 30) for start in starts]
        reached.sort(key=lambda end: float(end.cost))
        starts = [end.x for end in reached[: max(2, len(starts) // 2)]]
    best: Floats = min([*ends, *reached], key=lambda end: float(end.cost)).x
    return best


def _spread(stop: int) -> Any:
    """Rows before that one, not too many."""
    return np.unique(np.linspace(0, stop - 1, min(stop, SEARCHED)).astype(int))


def _sizes(model: FitModel[Any], residuals: Floats) -> Floats:
    """The root mean square of residuals (N, m), for each column that of its instrument."""
    groups, squares = np.array(model.groups), (residuals**2).mean(axis=0)
    size = np.sqrt([squares[groups == group].mean() for group in groups])
    rounding = 1e-13 * (np.abs(model.data).max() + 1.0)
    sizes: Floats = np.maximum(size, rounding)
    return sizes


def solved(model: FitModel[Any]) -> tuple[Floats, Floats]:
    """Parameters and their covariance; RigidtopError where the measurements do not tell them."""
    if model.data.size <= 2 * len(model.starts()[0]):
        raise RigidtopError(f"{len(model.t)} rows are too few to fit a motion")
    still = model.still()
    precision = None if model.sigma is None else 1 / model.sigma
    weights = 1 / _sizes(model, still) if precision is None else precision
    parameters = _searched(model, weights)
    for _ in range(3):  # the noise of each instrument comes from what the last fit leaves
        end = _descended(model, parameters, slice(None), weights, 60)
        parameters = model.settled(end.x)
        residuals = end.fun.reshape(still.shape) / weights
        weights = 1 / _sizes(model, residuals) if precision is None else precision
    left = float(np.square(residuals * weights).sum())
    variance = left / (still.size - len(parameters))
    if np.square(still * weights).sum() - left < model.significant * variance:
        raise RigidtopError(model.unknown)
    inverse = _inverse(model, parameters, model.slopes(parameters, slice(None), weights))
    covariance = inverse * (variance if precision is None else 1.0)
    scales = model.telling(parameters)
    if np.any(np.sqrt(np.diag(covariance))[: len(scales)] > VAGUE * scales):
        raise RigidtopError(model.unknown)
    return parameters, covariance


def _inverse(model: FitModel[Any], parameters: Floats, slopes: Floats) -> Floats:
    """(JᵀJ)⁻¹ of slopes J (rows, n); RigidtopError where some parameters change nothing."""
    norms = np.linalg.norm(slopes, axis=0)
    norms[norms == 0] = 1.0
    _, singular, across = np.linalg.svd(slopes / norms, full_matrices=False)
    nothing = singular <= model.rank * singular[0]
    if nothing.any():
        raise RigidtopError(model.unknown_along(parameters, across[nothing], norms))
    root = across.T / singular / norms[:, None]
    inverse: Floats = root @ root.T
    return inverse


def reported(
    model: FitModel[Any], parameters: Floats, covariance: Floats
) -> tuple[dict[str, float], Floats]:
    """The fitted quantities by name, and their covariance."""
    values = {name: float(x[0]) for name, x in model.quantities(parameters[None]).items()}
    slopes = _slopes(lambda p: np.stack([*model.quantities(p).values()], axis=-1), parameters)
    return values, slopes @ covariance @ slopes.T
