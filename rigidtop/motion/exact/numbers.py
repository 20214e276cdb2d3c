"""The same formulas for arrays, by NumPy, and for one float.

A formula is written once, for a kit `k`: `Arrays`, which broadcast, or a `Trace`, which writes the
formula out for floats.  Division by zero gives ±inf or NaN in both.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

Real = Any
"""A float, an array of floats, or one that is traced."""

Truth = Any
"""A bool, or an array of them."""


ROUNDING = 16 * float(np.finfo(float).eps)
"""What rounding of the initial state does to quantities that decide the regime."""

SMALLEST_PART = 1e-280
"""Of squares: deviations from a separatrix or a pole of 1e-140 and less count as none."""


def cubic(c: Sequence[Real], x: Real) -> Real:
    """A cubic, by its coefficients, the constant first."""
    return ((c[3] * x + c[2]) * x + c[1]) * x + c[0]


class Arrays:
    """The functions of arrays; use it with `numpy.errstate(all="ignore")`."""

    sqrt = staticmethod(np.sqrt)
    sin = staticmethod(np.sin)
    cos = staticmethod(np.cos)
    tan = staticmethod(np.tan)
    atan = staticmethod(np.arctan)
    atan2 = staticmethod(np.arctan2)
    sinh = staticmethod(np.sinh)
    cosh = staticmethod(np.cosh)
    tanh = staticmethod(np.tanh)
    asinh = staticmethod(np.arcsinh)
    atanh = staticmethod(np.arctanh)
    acos = staticmethod(np.arccos)
    exp = staticmethod(np.exp)
    hypot = staticmethod(np.hypot)
    copysign = staticmethod(np.copysign)
    larger = staticmethod(np.maximum)
    smaller = staticmethod(np.minimum)
    rint = staticmethod(np.rint)
    finite = staticmethod(np.isfinite)
    both = staticmethod(np.logical_and)
    either = staticmethod(np.logical_or)
    over = staticmethod(np.divide)

    @staticmethod
    def circle(angle: Real) -> tuple[Real, Real]:
        """The cosine and sine, by the tangent of the half: a tenth of their cost in NumPy."""
        t = np.tan(angle / 2)
        per = 1 / (1 + t * t)
        return (1 - t * t) * per, 2 * t * per

    @staticmethod
    def cubics(coefficients: Sequence[Sequence[Real]], x: Real) -> NDArray[np.float64] | list[Real]:
        """Cubics of one x; of one motion they are one matrix product."""
        if np.ndim(x) == 1 and isinstance(coefficients[0][0], float):
            powers = np.empty((4, len(x)))
            powers[0], powers[1] = 1.0, x
            np.multiply(x, x, out=powers[2])
            np.multiply(powers[2], x, out=powers[3])
            return np.asarray(coefficients) @ powers
        return [cubic(c, x) for c in coefficients]

    @staticmethod
    def any(condition: Truth) -> bool:
        return condition if isinstance(condition, bool) else bool(np.any(condition))

    @staticmethod
    def where(condition: Truth, one: Real, other: Real) -> Real:
        if isinstance(condition, (bool, np.bool_)):  # of the one motion that there is
            return one if condition else other
        return np.where(condition, one, other)

    @staticmethod
    def pick(
        condition: Truth, one: Callable[[], Sequence[Real]], other: Callable[[], Sequence[Real]]
    ) -> Sequence[Real]:
        if isinstance(condition, (bool, np.bool_)):
            return one() if condition else other()
        if np.all(condition):
            return one()
        if not np.any(condition):
            return other()
        pairs = zip(one(), other(), strict=True)
        return tuple(np.where(condition, first, second) for first, second in pairs)


Kit = Any
"""`Arrays`, or a `Trace`."""
