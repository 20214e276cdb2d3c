"""The closed form of one motion at many times, compiled by Numba, an extra.

The lines that `trace` writes stand in a loop over the times.  What they branch by is the same for
all times, but for little, so a compiler makes eight samples at a time of them if they call no
function.  The kit `Sums` has sums and products in the place of functions, good to two units in the
last place.
"""

from __future__ import annotations

import importlib
import math
from collections.abc import Callable, Sequence
from functools import cache
from typing import Any

import numpy as np

from rigidtop.errors import RigidtopError
from rigidtop.motion.attitude import Floats
from rigidtop.motion.exact.numbers import Real
from rigidtop.motion.exact.theta import FARTHEST
from rigidtop.trace import Solved, Trace, Written, leaves, loaded

SINE = [(-1) ** n / math.factorial(2 * n + 1) for n in range(9)]
COSINE = [(-1) ** n / math.factorial(2 * n) for n in range(9)]
ARC = [(-1) ** n / (2 * n + 1) for n in range(21)]
EXPONENTIAL = [1 / math.factorial(n + 1) for n in range(14)]
"""Of (e^x − 1)/x."""

QUARTERS = 1.5707963267341256, 6.077100506303966e-11, 2.0222662487959506e-21
"""π/2 in parts, of which multiples of the first two by 2²⁰ are exact."""

LOG2 = 0.6931471803691238, 1.9082149292705877e-10
"""log 2 in parts, of which multiples of the first by 2¹¹ are exact."""

STEEP = math.sqrt(2) - 1
"""tan(π/8)."""

LOOP = """\
def loop(o, t, found):
    x = np.empty(({count}, 256))
    for begin in range(0, len(t), 256):
        size = min(256, len(t) - begin)
        for i in range(size):
            x[0, i] = t[begin + i]
        for i in range(size):
            {body}
        for k in range({count}):
            for i in range(size):
                found[k, begin + i] = x[k, i]
"""
"""Of small rows of one size a compiler knows that they do not overlap."""


def series(coefficients: Sequence[float], x: Real) -> Real:
    """The polynomial in x with these coefficients, the constant first."""
    total: Real = coefficients[-1]
    for coefficient in coefficients[-2::-1]:
        total = total * x + coefficient
    return total


class Sums(Trace):
    """A kit that leaves no functions but the square root, for what a state needs of them."""

    @staticmethod
    def _circle(x: Real) -> tuple[Real, Real]:
        """cos and sin of |x| ≤ π/4."""
        y = x * x
        return 1 + y * series(COSINE[1:], y), x + x * y * series(SINE[1:], y)

    def tan(self, x: Real) -> Real:
        """The tangent of x, for |x| ≤ π/2."""
        c, s = self._circle(abs(x) / 2)
        return self.copysign(2 * s * c / ((c - s) * (c + s)), x)

    def circle(self, angle: Real) -> tuple[Real, Real]:
        quarters = self.rint(angle * (2 / math.pi))
        for part in QUARTERS:
            angle = angle - quarters * part
        c, s = self._circle(angle)
        half = self.rint(quarters / 2)  # turns of π, but for one of π/2
        odd, sign = quarters != 2 * half, self.where(half == 2 * self.rint(half / 2), 1.0, -1.0)
        beyond = quarters - 2 * half  # −1, 0 or 1
        return sign * self.where(odd, -beyond * s, c), sign * self.where(odd, beyond * c, s)

    def cos(self, x: Real) -> Real:
        return self.circle(x)[0]

    def sin(self, x: Real) -> Real:
        return self.circle(x)[1]

    def atan2(self, y: Real, x: Real) -> Real:
        """The angle of finite numbers; x = −0.0 is 0."""
        up, along = abs(y), abs(x)
        small, large = self.smaller(up, along), self.larger(up, along)
        far = small > STEEP * large
        over = self.where(far, large + small, self.where(large > 0, large, 1.0))
        r = self.where(far, small - large, small) / over
        square = r * r
        angle = r + r * square * series(ARC[1:], square)
        angle = self.where(far, angle + math.pi / 4, angle)
        angle = self.where(up > along, math.pi / 2 - angle, angle)
        return self.copysign(self.where(x < 0, math.pi - angle, angle), y)

    def _grown(self, x: Real) -> tuple[Real, Real]:
        """2ⁿ and e^r − 1, for −2 FARTHEST ≤ x = n log 2 + r ≤ 0."""
        n = self.rint(x * (1 / math.log(2)))
        r = (x - n * LOG2[0]) - n * LOG2[1]
        power = self.value("np.int64((np.int64({0}) + 1023) << 52).view(np.float64)", n)
        return power, r + r * r * series(EXPONENTIAL[1:], r)

    def exp(self, x: Real) -> Real:
        power, rest = self._grown(x)
        return power + power * rest

    def tanh(self, x: Real) -> Real:
        power, rest = self._grown(-2 * self.smaller(abs(x), FARTHEST))
        fall = power * rest + (power - 1)
        return self.copysign(fall / (2 + fall), x)

    def hypot(self, x: Real, y: Real) -> Real:
        small, large = self.smaller(abs(x), abs(y)), self.larger(abs(x), abs(y))
        ratio = small / self.where(large > 0, large, 1.0)
        return large * self.sqrt(1 + ratio * ratio)

    def over(self, a: Real, b: Real) -> Real:
        return a / b


Formula = Callable[[Any, Any, Real], tuple[Real, ...]]
"""From a kit, an orbit and a time: what is asked for."""


def rows(solved: Solved, formula: Formula, times: Floats, *more: float) -> Floats:
    """What it gives at each time, (rows, N); `more` numbers stand behind those of the orbit.

    Raises RigidtopError if Numba is not installed.
    """
    run, count = _compiled(solved.written, formula)
    values = np.empty((count, len(times)))
    run((*solved.numbers, *more), np.ascontiguousarray(times), values)
    return values


@cache
def _compiled(written: Written, formula: Formula) -> tuple[Callable[..., None], int]:
    try:
        numba = importlib.import_module("numba")
    except ImportError:
        raise RigidtopError(
            "compiled=True needs Numba: pip install 'rigidtop[numba]', or leave it out"
        ) from None
    source, count = loop(Sums(), written, formula)
    function = loaded(source, {"np": np, "rint": np.rint})["loop"]
    return numba.njit(function, error_model="numpy", fastmath={"contract"}), count


def loop(kit: Trace, written: Written, formula: Formula) -> tuple[str, int]:
    """Source of the loop over the times, and how many rows it fills."""
    orbit = kit.inputs("o", written.orbit)
    results = leaves(formula(kit, orbit, kit.value("x[0, i]")))
    body, values = kit.lines(results)
    body += [f"x[{k}, i] = {text}" for k, text in enumerate(values)]
    return LOOP.format(count=len(results), body="\n            ".join(body)), len(results)
