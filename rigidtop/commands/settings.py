"""The option ``--set name=value …``, the same in every command."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
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


def apart(given: Sequence[str]) -> tuple[list[str], list[str]]:
    """Settings, and the other words behind them, which name what they are for.

    >>> apart(["theta=30deg", "toppling-top"])
    (['theta=30deg'], ['toppling-top'])
    """
    return [word for word in given if "=" in word], [word for word in given if "=" not in word]
