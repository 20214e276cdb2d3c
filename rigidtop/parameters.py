"""Numbers that come in, and those of an exercise or a figure that its reader may change."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

from rigidtop.errors import RigidtopError

_UNITS = {"deg": math.pi / 180, "°": math.pi / 180, "rpm": math.pi / 30}
_SUFFIXES = {"rad": ("deg", "°"), "rad/s": ("deg", "°", "rpm")}
_EXAMPLES = {"rad": "0.5 or 30deg", "rad/s": "0.5, 30deg or 600rpm"}
"""An angle and its rate may have a unit behind them; another number is in SI units."""

EXAMPLE_TOP: Mapping[str, float] = MappingProxyType(
    {"lambda1": 1.0, "lambda3": 0.5, "M": 1.0, "g": 9.81, "R": 0.5}
)
"""The heavy top of what is not told another, in SI units; the order is that of the equations."""

EXAMPLE_SPIN = 40.0
"""Its ω₃ (rad/s)."""

LONGEST = 60
"""Characters of what is no number, in a message."""


def quantity(text: str, unit: str = "1") -> float:
    """A finite number, from text; behind that of an angle may stand deg, of its rate also rpm.

    Raises ValueError, which says what it must be.

    >>> quantity("0.5"), round(quantity("30deg", "rad"), 6), round(quantity("60 rpm", "rad/s"), 6)
    (0.5, 0.523599, 6.283185)
    >>> quantity("30degrees", "rad")
    Traceback (most recent call last):
    ...
    ValueError: must be a number in rad, such as 0.5 or 30deg, not '30degrees'
    """
    match = re.fullmatch(rf"(.*?)\s*({'|'.join(_UNITS)})?", text.strip())
    value = math.nan
    if match and match[2] in (None, *_SUFFIXES.get(unit, ())):
        with suppress(ValueError):
            value = float(match[1]) * _UNITS.get(match[2] or "", 1.0)
    if not math.isfinite(value):
        known = "" if unit == "1" else f" in {unit}"
        raise ValueError(
            f"must be a number{known}, such as {_EXAMPLES.get(unit, '0.5')}, not {text!r}"
        )
    return value


def real(value: Any) -> float:
    """The float of one real number, of Python, NumPy or SymPy.

    Raises TypeError, with what it is in one line, for what float() would take for one: text, truth
    values, complex numbers, dates, rows and what is masked.

    >>> real(2), real(True)
    Traceback (most recent call last):
    ...
    TypeError: True
    """
    if type(value) is float:
        return value
    kind = getattr(getattr(value, "dtype", None), "kind", "f")
    if not (
        isinstance(value, (bool, str, bytes, bytearray, complex))
        or kind not in "iuf"
        or getattr(value, "shape", None)
        or getattr(value, "mask", False)
    ):
        with suppress(TypeError, ValueError):
            try:
                return float(value)
            except OverflowError:
                return math.inf if value > 0 else -math.inf
    raise TypeError(in_one_line(value))


def in_one_line(value: object) -> str:
    """What is no number, in a message."""
    text = " ".join(repr(value).split())
    return text if len(text) <= LONGEST else f"{text[:LONGEST]}…"


@dataclass(frozen=True)
class Parameter:
    """A number by its name, in SI units and radians, with its default and its range.

    `above` is excluded from the range, `least` and `most` belong to it.
    """

    name: str
    default: float
    about: str
    unit: str = "1"
    above: float = -math.inf
    least: float = -math.inf
    most: float = math.inf

    def checked(self, value: float) -> float:
        """The value as a float; RigidtopError with what would be right if it is out of range."""
        try:
            number = real(value)
        except TypeError as error:
            raise RigidtopError(f"{self.name} must be a number, not {error}") from None
        if not math.isfinite(number):
            raise RigidtopError(f"{self.name} must be a finite number, not {value}")
        for wrong, right in (
            (number <= self.above, f"more than {shown(self.above, self.unit)}"),
            (number < self.least, f"at least {shown(self.least, self.unit)}"),
            (number > self.most, f"at most {shown(self.most, self.unit)}"),
        ):
            if wrong:
                raise RigidtopError(f"{self.name} must be {right}, not {shown(number, self.unit)}")
        return number


def shown(value: float, unit: str) -> str:
    """A number in a message, an angle also in degrees.

    >>> shown(0.25, "kg"), shown(math.pi, "rad")
    ('0.25 kg', '3.14159 rad (180°)')
    """
    written = f"{value:.6g}" if unit == "1" else f"{value:.6g} {unit}"
    return f"{written} ({math.degrees(value):.6g}°)" if unit == "rad" else written


def settings(
    parameters: Sequence[Parameter], given: Mapping[str, float] | Sequence[str] = ()
) -> dict[str, float]:
    """Every parameter's value: its default, or what is `given` by name or as "name=value".

    Raises RigidtopError for a name that is unknown or given twice, for text that is no number, and
    for a value out of range.

    >>> tilt = Parameter("theta", 0.5, "θ at the start", "rad", least=0, most=math.pi)
    >>> settings([tilt]), settings([tilt], {"theta": 1})
    ({'theta': 0.5}, {'theta': 1.0})
    >>> settings([tilt], ["theta=200deg"])
    Traceback (most recent call last):
    ...
    rigidtop.errors.RigidtopError: theta must be at most 3.14159 rad (180°), not 3.49066 rad (200°)
    """
    known = {parameter.name: parameter for parameter in parameters}
    changes = dict(given) if isinstance(given, Mapping) else _parsed(given, known)
    for name in changes:
        _check_known(name, known)
    return {name: p.checked(changes.get(name, p.default)) for name, p in known.items()}


def _check_known(name: str, known: Mapping[str, Parameter]) -> None:
    if name not in known:
        there = f"there are {', '.join(known)}" if known else "there is none to set"
        raise RigidtopError(f"no parameter {name!r}; {there}")


def _parsed(given: Sequence[str], known: Mapping[str, Parameter]) -> dict[str, float]:
    changes: dict[str, float] = {}
    for text in given:
        name, equals, value = (part.strip() for part in text.partition("="))
        if not equals:
            raise RigidtopError(f"{text!r} is not of the form name=value, such as theta=30deg")
        if name in changes:
            raise RigidtopError(f"{name} is set twice")
        _check_known(name, known)
        try:
            changes[name] = quantity(value, known[name].unit)
        except ValueError as error:
            raise RigidtopError(f"{name} {error}") from None
    return changes
