"""The numbers of an exercise or a figure that its reader may change."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from rigidtop.errors import RigidtopError

UNITS = {"deg": math.pi / 180, "°": math.pi / 180, "rpm": math.pi / 30}
"""What may stand behind a number in place of radians or rad/s."""


def quantity(text: str) -> float:
    """A finite number, in radians if it is followed by deg, in rad/s if by rpm.

    Raises ValueError for other text.

    >>> quantity("0.5"), round(quantity("30deg"), 6), round(quantity("60 rpm"), 6)
    (0.5, 0.523599, 6.283185)
    """
    match = re.fullmatch(rf"(.*?)\s*({'|'.join(UNITS)})?", text.strip())
    number = float(match[1]) if match else math.nan
    value = number * UNITS.get(match[2] or "", 1.0) if match else number
    if not math.isfinite(value):
        raise ValueError(f"{text!r} is not a finite number")
    return value


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
        number = float(value)
        if not math.isfinite(number):
            raise RigidtopError(f"{self.name} must be a finite number, not {value}")
        for wrong, right in (
            (number <= self.above, f"more than {self.above:g}"),
            (number < self.least, f"at least {self.least:g}"),
            (number > self.most, f"at most {self.most:g}"),
        ):
            if wrong:
                unit = "" if self.unit == "1" else f" {self.unit}"
                raise RigidtopError(f"{self.name} must be {right}{unit}, not {number:g}")
        return number


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
    rigidtop.errors.RigidtopError: theta must be at most 3.14159 rad, not 3.49066
    """
    known = {parameter.name: parameter for parameter in parameters}
    changes = dict(given) if isinstance(given, Mapping) else _parsed(given, known)
    for name in changes:
        if name not in known:
            there = f"there are {', '.join(known)}" if known else "there is none to set"
            raise RigidtopError(f"no parameter {name!r}; {there}")
    return {name: p.checked(changes.get(name, p.default)) for name, p in known.items()}


def _parsed(given: Sequence[str], known: Mapping[str, Parameter]) -> dict[str, float]:
    changes: dict[str, float] = {}
    for text in given:
        name, equals, value = (part.strip() for part in text.partition("="))
        if not equals:
            raise RigidtopError(f"{text!r} is not of the form name=value, such as theta=30deg")
        if name in changes:
            raise RigidtopError(f"{name} is set twice")
        try:
            changes[name] = quantity(value)
        except ValueError:
            raise RigidtopError(
                f"{name} must be a number, such as 0.5, 30deg or 600rpm, not {value!r}"
            ) from None
        unit = known[name].unit if name in known else "rad/s"
        if value.endswith(_foreign(unit)):
            raise RigidtopError(f"{name} is in {unit}: {value!r} is something else")
    return changes


def _foreign(unit: str) -> tuple[str, ...]:
    """What may not stand behind a number of that unit: turns a minute behind an angle, say."""
    if "rad" not in unit:
        return tuple(UNITS)
    return () if unit.startswith("rad/s") else ("rpm",)
