"""The names of units, as siunitx has them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

_NAMES: Final = {
    "meter": "m",
    "metre": "m",
    "second": "s",
    "gram": "g",
    "kilogram": "kg",
    "newton": "N",
    "joule": "J",
    "watt": "W",
    "pascal": "Pa",
    "hertz": "Hz",
    "radian": "rad",
    "degree": "°",
    "kelvin": "K",
    "ampere": "A",
    "volt": "V",
    "coulomb": "C",
    "tesla": "T",
    "tonne": "t",
    "minute": "min",
    "hour": "h",
    "liter": "l",
    "litre": "l",
    "electronvolt": "eV",
}
_PREFIXES: Final = {
    "giga": "G",
    "mega": "M",
    "kilo": "k",
    "hecto": "h",
    "deci": "d",
    "centi": "c",
    "milli": "m",
    "micro": "µ",
    "nano": "n",
    "pico": "p",
}
_POWERS: Final = {"square": 2, "squared": 2, "cubic": 3, "cubed": 3}


def spelled(names: Iterable[str]) -> str:
    """A unit whose parts are named, as text.

    >>> spelled(["kilo", "meter", "per", "second", "squared"])
    'km s^-2'
    """
    parts: list[tuple[str, int]] = []
    prefix, power = "", 1
    for name in names:
        if name == "per":
            power = -power
        elif name in _PREFIXES:
            prefix = _PREFIXES[name]
        elif name in ("squared", "cubed") and parts:
            parts[-1] = (parts[-1][0], parts[-1][1] * _POWERS[name])
        elif name in _POWERS:
            power *= _POWERS[name]
        else:
            parts.append((prefix + _NAMES.get(name, name), power))
            prefix, power = "", 1
    return " ".join(name if power == 1 else f"{name}^{power}" for name, power in parts)
