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
        if name and not _UNIT.fullmatch(name):
            return None
        if name:
            unit = Unit(name)
            made: Node = unit
            if power:
                value = Number(power.lstrip("-−"))
                made = raised(unit, Negative(value) if power[0] in "-−" else value)
            (under if below else over).append(made)
        below = below or sign == "/"
    if end != len(text) or not over:
        return None
    return Quotient(product_of(over), product_of(under), slash=True) if under else product_of(over)
