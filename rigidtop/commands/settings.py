"""Options that are the same in every command: ``--set name=value …``, and whole numbers."""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable, Sequence
from typing import Any


def add_settings(
    parser: argparse.ArgumentParser, about: str, option: str = "--set", **more: Any
) -> None:
    """Several settings behind one --set, or behind several."""
    parser.add_argument(
        option,
        **{"nargs": "+", "action": "extend", "default": [], "metavar": "NAME=VALUE"} | more,
        help=f"{about}; several may follow",
    )


def apart(words: Sequence[str]) -> tuple[list[str], list[str]]:
    """Settings, and the other words behind them, which name what they are for.

    >>> apart(["theta=30deg", "toppling-top"])
    (['theta=30deg'], ['toppling-top'])
    """
    return [word for word in words if "=" in word], [word for word in words if "=" not in word]


def within(least: float, most: float) -> Callable[[str], float]:
    """What reads a number in a range.

    >>> within(1, 50)("8.6")
    8.6
    """

    def read(text: str) -> float:
        try:
            number = float(text)
        except ValueError:
            number = math.nan
        if not least <= number <= most:
            complaint = f"{text!r} is not a number from {least:g} to {most:g}"
            raise argparse.ArgumentTypeError(complaint)
        return number

    return read


def whole(least: int, most: int | None = None) -> Callable[[str], int]:
    """What reads a whole number in a range.

    >>> whole(2)("21")
    21
    """

    bounds = f"from {least}" + (f" to {most}" if most else "")

    def read(text: str) -> int:
        is_whole = text.isdecimal() and len(text) <= 12 and least <= int(text)
        if not is_whole or (most and int(text) > most):
            raise argparse.ArgumentTypeError(f"{text!r} is not a whole number {bounds}")
        return int(text)

    return read
