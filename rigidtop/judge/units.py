"""Units of measurement as factors and powers of SI units."""

from __future__ import annotations

import sympy
from sympy import Expr, Integer, Rational


def _prefixed() -> dict[str, tuple[Expr, dict[str, int]]]:
    plain: dict[str, tuple[Expr, dict[str, int]]] = {
        "m": (Integer(1), {"m": 1}),
        "g": (Rational(1, 1000), {"kg": 1}),
        "s": (Integer(1), {"s": 1}),
        "N": (Integer(1), {"kg": 1, "m": 1, "s": -2}),
        "J": (Integer(1), {"kg": 1, "m": 2, "s": -2}),
        "W": (Integer(1), {"kg": 1, "m": 2, "s": -3}),
        "Pa": (Integer(1), {"kg": 1, "m": -1, "s": -2}),
        "Hz": (Integer(1), {"s": -1}),
        "A": (Integer(1), {"A": 1}),
        "K": (Integer(1), {"K": 1}),
        "C": (Integer(1), {"A": 1, "s": 1}),
        "V": (Integer(1), {"kg": 1, "m": 2, "s": -3, "A": -1}),
        "T": (Integer(1), {"kg": 1, "s": -2, "A": -1}),
        "mol": (Integer(1), {"mol": 1}),
        "rad": (Integer(1), {}),
    }
    prefixes = {"": 0, "k": 3, "M": 6, "G": 9, "c": -2, "d": -1, "m": -3, "μ": -6, "n": -9}
    made = {
        prefix + name: (factor * Rational(10) ** power, powers)
        for name, (factor, powers) in plain.items()
        for prefix, power in prefixes.items()
    }
    return made | {
        "min": (Integer(60), {"s": 1}),
        "h": (Integer(3600), {"s": 1}),
        "d": (Integer(86400), {"s": 1}),
        "l": (Rational(1, 1000), {"m": 3}),
        "t": (Integer(1000), {"kg": 1}),
        "°": (sympy.pi / 180, {}),
        "%": (Rational(1, 100), {}),
        "kg": (Integer(1), {"kg": 1}),
        "sr": (Integer(1), {}),
        "rpm": (2 * sympy.pi / 60, {"s": -1}),
    }


UNITS = _prefixed()
"""Each unit with its factor and its powers of SI units."""
