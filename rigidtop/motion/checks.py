"""Input is checked where it enters; each message says what is wrong and what would be right."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.spatial.transform import Rotation

from rigidtop.errors import RigidtopError
from rigidtop.parameters import in_one_line, real

MOST_TURNS = 1e7
"""No integration goes on for longer: it would run for hours and fill the memory."""

TOLERANCE = 1e-12
"""Relative slack in inequalities that a real body may satisfy with equality (a flat body)."""

LARGEST = 1e100
"""Products of the few numbers that make an energy or a rate stay below the largest float."""

MOST = 10**12
"""Nothing is counted farther."""

SMALLEST = 1e-100
"""Their quotients too, when moments, masses, lengths and the like are above this."""


def number(name: str, value: object) -> float:
    """A finite float of at most `LARGEST` in magnitude; −0.0, whose quotients differ, is 0.0."""
    try:
        result = real(value)
    except TypeError as error:
        raise RigidtopError(f"{name} must be a number, not {error}") from None
    if not math.isfinite(result):
        raise RigidtopError(f"{name} must be finite, not {result}")
    if abs(result) > LARGEST:
        raise RigidtopError(
            f"{name} must be at most {LARGEST:g} in magnitude, not {result:g}: use other units"
        )
    return result + 0.0


def positive(name: str, value: object) -> float:
    result = number(name, value)
    if result <= 0:
        raise RigidtopError(f"{name} must be positive, not {result:g}")
    return _not_tiny(name, result)


def not_negative(name: str, value: object) -> float:
    result = number(name, value)
    if result < 0:
        raise RigidtopError(f"{name} must be zero or positive, not {result:g}")
    return _not_tiny(name, result) if result else result


def settle(body: object, check: Callable[[str, object], object], *names: str) -> None:
    """Put what a check makes of them in the place of fields of a frozen dataclass."""
    for name in names:
        object.__setattr__(body, name, check(name, getattr(body, name)))


def whole(name: str, value: object, least: int) -> int:
    """An integer, of Python or NumPy."""
    if not isinstance(value, (int, np.integer)) or isinstance(value, bool) or value < least:
        raise RigidtopError(f"{name} must be a whole number from {least}, not {in_one_line(value)}")
    if value > MOST:
        raise RigidtopError(f"{name} must be at most {MOST:g}, not {in_one_line(value)}")
    return int(value)


def callback(name: str, value: object) -> None:
    """Raises RigidtopError for what is neither None nor can be called."""
    if value is not None and not callable(value):
        raise RigidtopError(f"{name} must be a function, not {in_one_line(value)}")


def _not_tiny(name: str, value: float) -> float:
    if value < SMALLEST:
        raise RigidtopError(f"{name} must be at least {SMALLEST:g}, not {value:g}: use other units")
    return value


def truth(name: str, value: object) -> bool:
    """True or False, also as a number, 1 or 0."""
    if not isinstance(value, (bool, np.bool_)) and number(name, value) not in (0.0, 1.0):
        raise RigidtopError(f"{name} must be True or False, not {value}")
    return bool(value)


def vector(name: str, value: object) -> tuple[float, float, float]:
    """The value as three finite floats, or an error that says its name."""
    first, second, third = _row(name, value, 3, "three numbers")
    return first, second, third


def pair(name: str, value: object) -> tuple[float, float]:
    """The value as two finite floats, along x̂ and ŷ."""
    first, second = _row(name, value, 2, "two numbers, along x and y")
    return first, second


def _row(name: str, value: Any, count: int, wanted: str) -> list[float]:
    ordered = isinstance(value, Sequence) or np.ndim(value) == 1
    if not ordered or len(value) != count:
        raise RigidtopError(f"{name} must be {wanted}, not {in_one_line(value)}")
    return [number(f"{name}[{k}]", x) for k, x in enumerate(value)]


def polar_angle(value: object) -> float:
    result = number("theta", value)
    if not 0 <= result <= math.pi:
        raise RigidtopError(f"theta must lie between 0 and pi radians, not at {result:g}")
    return result


def single_rotation(value: object) -> Rotation:
    if not isinstance(value, Rotation):
        raise RigidtopError(f"attitude must be a scipy Rotation, not {type(value).__name__}")
    if not value.single:
        raise RigidtopError(f"attitude must be one rotation, not a stack of {len(value)}")
    if not all(map(math.isfinite, value.as_quat().tolist())):
        raise RigidtopError("attitude must be finite: its quaternion is not")
    return value


UNPHYSICAL = " (physical=False lets them through)"
"""Behind what is said of moments that no body has: published benchmarks have such."""


def triangle(moments: Sequence[float], scale: float) -> bool:
    """No moment about the centre of mass exceeds the sum of the other two (equal: a flat body)."""
    return 2 * max(moments) <= sum(moments) + TOLERANCE * scale


def _floats(value: ArrayLike) -> NDArray[np.float64]:
    """An array of floats, −0.0 as 0.0; TypeError, with what it is, for what NumPy takes for one.

    See `parameters.real`.  An array with masked elements is none: what is under the mask would be
    taken for numbers.
    """
    if _masked(value):
        raise TypeError("a masked array: leave out, or fill, what is masked")
    try:
        array = np.asarray(value, dtype=None if hasattr(value, "dtype") else object)
    except ValueError:
        raise TypeError("rows of different lengths") from None
    if array.dtype.kind not in "iufO":
        raise TypeError(f"an array of {array.dtype}" if array.ndim else repr(array[()]))
    if array.dtype.kind == "O" and not {*map(type, array.flat)} <= {float, np.float64}:
        array = np.reshape([real(x) for x in array.flat], array.shape)
    return array.astype(float, copy=False) + 0.0


def _masked(value: object) -> bool:
    if isinstance(value, (list, tuple)):
        return any(map(_masked, value))
    return isinstance(value, np.ma.MaskedArray) and bool(np.ma.is_masked(value))


def numbers(
    name: str,
    value: ArrayLike,
    above: float = -math.inf,
    least: float = -math.inf,
    most: float = math.inf,
    tiny: bool = False,
) -> NDArray[np.float64]:
    """An array of finite floats of at most `LARGEST` in magnitude, in a range; may they be `tiny`?

    What multiplies and divides may not, like `positive` and `not_negative`.
    """
    try:
        result = _floats(value)
    except TypeError as error:
        raise RigidtopError(f"{name} must be numbers, not {error}") from None
    if not np.all(np.isfinite(result)):
        raise RigidtopError(f"{name} must be finite: it contains NaN or infinity")
    size = np.abs(result)
    limits = (
        (size > LARGEST, f"at most {LARGEST:g} in magnitude: use other units"),
        (result <= above, f"more than {above:g}"),
        (result < least, f"at least {least:g}"),
        (result > most, f"at most {most:.6g}"),
        (
            (size > 0) & (size < SMALLEST) & (max(above, least) == 0) & (not tiny),
            "0 or not so tiny",
        ),
    )
    for wrong, right in limits:
        if np.any(wrong):
            raise RigidtopError(f"{name} must be {right}, not {float(result[wrong][0])!r}")
    return result


def common_shape(values: Mapping[str, NDArray[np.float64]]) -> tuple[int, ...]:
    """The shape to which arrays broadcast."""
    try:
        return np.broadcast_shapes(*(value.shape for value in values.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {value.shape}" for name, value in values.items() if value.ndim)
        raise RigidtopError(f"these shapes do not broadcast: {shapes}") from None


SPAN = 501
"""So many evenly spaced times make a span."""


def times(value: Any) -> NDArray[np.float64]:
    """Finite times, shape (N,) with N ≥ 1; a tuple (start, end) is a span, as SciPy has it."""
    if type(value) is float and abs(value) <= LARGEST:
        return np.array([value + 0.0])
    if isinstance(value, tuple) and len(value) == 2:
        start, end = times(list(value)).tolist()
        return np.linspace(start, end, SPAN)
    try:
        result = np.atleast_1d(_floats(value))
    except TypeError as error:
        raise RigidtopError(f"t must be a number or an array of numbers, not {error}") from None
    if result.ndim != 1 or result.size == 0:
        raise RigidtopError(f"t must be a number or a row of numbers, not of shape {result.shape}")
    if not np.all(np.isfinite(result)):
        raise RigidtopError("t must be finite: it contains NaN or infinity")
    if np.abs(result).max() > LARGEST:
        raise RigidtopError(f"t must be at most {LARGEST:g} in magnitude: use other units")
    return result


def times_within_reach(value: ArrayLike, rate: float) -> NDArray[np.float64]:
    """Times at which a motion that turns at this rate (rad/s) can be integrated."""
    array = times(value)
    turns = rate * float(np.abs(array).max()) / (2 * math.pi)
    if turns > MOST_TURNS:
        raise RigidtopError(
            f"about {turns:.0e} turns: at most {MOST_TURNS:.0e} can be integrated, "
            "so ask for earlier times"
        )
    return array
