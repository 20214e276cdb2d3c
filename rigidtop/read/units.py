"""Units as they are written behind numbers.

>>> units("m/s^2") is not None, units("mass")
(True, None)
"""

from __future__ import annotations

import re
from typing import Final

from rigidtop.read.shapes import product_of
from rigidtop.tree.nodes import Negative, Node, Number, Power, Product, Quotient, Unit

_UNIT: Final = re.compile(
    r"(?:da|[EPTGMkhdcmμµunpf])?(?:mol|Hz|Pa|eV|cal|[mgstNJWKCVATFHΩLl])|rad|deg|sr|min|h|hr|yr|sec|°"
)
_UNITS: Final = re.compile(r"([^\W\d_]+|°)\s*(?:\^?\s*([-−]?\d+))?|([/()])|[·.\s*]+")


_JOINED: Final = re.compile(r"([EPTGMkm]?[WANV])(h|s|m|A)")
"""Two units that are written as one word: kWh, Nm, Ah."""


def _apart(name: str) -> list[str]:
    joined = None if _UNIT.fullmatch(name) else _JOINED.fullmatch(name)
    return [*joined.groups()] if joined else [name]


def raised(unit: Unit, exponent: Node) -> Node:
    """A unit with its power; nobody divides by milliseconds: ms^-1 is a metre a second."""
    if unit.name == "ms" and isinstance(exponent, Negative):
        return Product((Unit("m"), Power(Unit("s"), exponent)))
    return Power(unit, exponent)


def units(text: str) -> Node | None:
    """A unit with its powers and slashes, "kg m^2/s"; None for what is no unit."""
    over: list[Node] = []
    under: list[Node] = []
    below, end = False, 0
    for match in _UNITS.finditer(text):
        if match.start() != end:
            return None
        end = match.end()
        name, power, sign = match.groups()
        names = _apart(name) if name else []
        if not all(map(_UNIT.fullmatch, names)):
            return None
        for unit in map(Unit, names):
            made: Node = unit
            if power and unit.name == names[-1]:
                value = Number(power.lstrip("-−"))
                made = raised(unit, Negative(value) if power[0] in "-−" else value)
            (under if below else over).append(made)
        below = below or sign == "/"
    if end != len(text) or not over:
        return None
    return Quotient(product_of(over), product_of(under), slash=True) if under else product_of(over)
