"""Moments of a body, or of a top, from what a laboratory measures of its motion."""

from __future__ import annotations

import math
from typing import TypeVar, overload

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from rigidtop.errors import RigidtopError
from rigidtop.motion import checks
from rigidtop.motion.attitude import Floats
from rigidtop.motion.free_fit import FreeFit, FreeModel
from rigidtop.motion.least_squares import Fit, FitModel, reported, solved
from rigidtop.motion.motion import Motion
from rigidtop.motion.top_fit import TopFit, TopModel

Kind = TypeVar("Kind", bound=Fit[Motion])

EITHER = "give omega or attitude of a free body, or theta and phi of a top"


@overload
def fit(
    t: ArrayLike,
    omega: ArrayLike,
    attitude: Rotation | None = None,
    *,
    lambda1: float | None = None,
    lambda2: float | None = None,
    lambda3: float | None = None,
    misalignment: bool = False,
) -> FreeFit: ...


@overload
def fit(
    t: ArrayLike,
    *,
    attitude: Rotation,
    lambda1: float | None = None,
    lambda2: float | None = None,
    lambda3: float | None = None,
    misalignment: bool = False,
) -> FreeFit: ...


@overload
def fit(
    t: ArrayLike, *, theta: ArrayLike, phi: ArrayLike, psi: ArrayLike | None = None
) -> TopFit: ...


def fit(
    t: ArrayLike,
    omega: ArrayLike | None = None,
    attitude: Rotation | None = None,
    *,
    theta: ArrayLike | None = None,
    phi: ArrayLike | None = None,
    psi: ArrayLike | None = None,
    lambda1: float | None = None,
    lambda2: float | None = None,
    lambda3: float | None = None,
    misalignment: bool = False,
) -> FreeFit | TopFit:
    """The body and the motion that fit measurements best, with standard errors.

    `t` are times (N,) that increase, in s.  Of a free body, such as a thrown phone, `omega` (N, 3)
    are the body rates in the axes of the sensor (rad/s), `attitude` N rotations of these to space;
    either tells the ratios of the moments, or both together.  Free motion knows no more: the
    smallest moment is 1, unless some of `lambda1`, `lambda2` and `lambda3` (kg m²) are given.  The
    axes of the sensor are principal ones, and λ₁ belongs to the first of them; `misalignment` asks
    for their turn too, `turn1` … (rad), from principal components to the sensor's, and needs a
    motion that tumbles well.

    Of a heavy symmetric top `theta` and `phi` (N,) (rad) tell λ₃ω₃/λ₁, its `spin`, and MgR/λ₁, its
    `weight`; with `psi` also ω₃ and λ₃/λ₁.

    Noise is taken as independent from row to row and equal within ω, within the attitudes, and
    within each angle; its size is that of the residuals.  Friction, and the air, are left out.

    Raises RigidtopError for arrays that do not fit together, for too few rows, and where the motion
    tells no moments: a spin along a principal axis, three equal moments, a steady precession.

    >>> from rigidtop import FreeBody
    >>> t = np.linspace(0.0, 2.0, 101)
    >>> flight = FreeBody(1.0, 4.2, 5.0).motion(omega=(2.0, 9.0, 3.0)).exact(t)
    >>> noise = 0.05 * np.random.default_rng(1).normal(size=(101, 3))
    >>> phone = fit(t, omega=flight.omega + noise)
    >>> print(f"{phone.lambda2:.2f} ± {phone.errors['lambda2']:.2f}, {phone.lambda3:.2f}")
    4.22 ± 0.02, 5.02
    >>> print(f"{abs(phone.motion.exact(t).omega - flight.omega).max():.2f} rad/s")
    0.03 rad/s
    """
    times = checks.times(t)
    if np.any(np.diff(times) <= 0):
        raise RigidtopError("t must increase from row to row")
    moments = {"lambda1": lambda1, "lambda2": lambda2, "lambda3": lambda3}
    fixed = tuple(x if x is None else checks.positive(n, x) for n, x in moments.items())
    angles = {"theta": theta, "phi": phi, "psi": psi}
    misalignment = checks.truth("misalignment", misalignment)
    if omega is None and attitude is None:
        if any(fixed) or misalignment:
            raise RigidtopError("moments and misalignment go with omega or attitude of a free body")
        return _fitted(TopFit, _top(times, angles), times)
    if any(x is not None for x in angles.values()):
        raise RigidtopError(EITHER)
    rates = None if omega is None else _shaped("omega", omega, (len(times), 3))
    _check_attitudes(attitude, len(times))
    model = FreeModel(times - times[0], rates, attitude, fixed, misalignment)
    return _fitted(FreeFit, model, times)


def _check_attitudes(attitude: object, count: int) -> None:
    several = isinstance(attitude, Rotation) and not attitude.single and len(attitude)
    if attitude is not None and several != count:
        raise RigidtopError(f"attitude must be a scipy Rotation of {count}, one for each time")


def _top(times: Floats, angles: dict[str, ArrayLike | None]) -> TopModel:
    columns = {name: _shaped(name, x, times.shape) for name, x in angles.items() if x is not None}
    if not {"theta", "phi"} <= columns.keys():
        raise RigidtopError(EITHER)
    theta, phi, *psi = columns.values()
    checks.numbers("theta", theta, above=0.0, most=math.pi)
    return TopModel(times - times[0], theta, np.unwrap(phi), np.unwrap(psi[0]) if psi else None)


def _fitted(kind: type[Kind], model: FitModel[Motion], times: Floats) -> Kind:
    parameters, inner = solved(model)
    values, covariance = reported(model, parameters, inner)
    motion = model.motion(parameters, values, float(times[0]))
    columns = model.computed(parameters[None], slice(None))[0].T
    computed = dict(zip(model.measured, columns, strict=True))
    return kind(motion, values, covariance, times, model.measured, computed)


def _shaped(name: str, value: ArrayLike, shape: tuple[int, ...]) -> Floats:
    array = checks.numbers(name, value)
    if array.shape != shape:
        raise RigidtopError(f"{name} must be of shape {shape}, as t has it, not {array.shape}")
    return array
