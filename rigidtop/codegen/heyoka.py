"""Derived expressions in heyoka's symbols, of which it makes Taylor series; heyoka is an extra."""

from __future__ import annotations

import ast
import math
from collections.abc import Sequence
from functools import partial
from typing import Any

from rigidtop.codegen import source
from rigidtop.codegen.numpy import Function
from rigidtop.errors import RigidtopError


def on_symbols(heyoka: Any, func: Function, name: str, symbols: Sequence[Any]) -> list[Any]:
    """The source of a function, run on heyoka's symbols.

    Raises RigidtopError if heyoka has no counterpart of a function that occurs.
    """
    # A choice between cases would be made once, for symbols, which are neither true nor false.
    if any(
        isinstance(node, ast.IfExp | ast.BoolOp | ast.Compare) for node in ast.walk(func.definition)
    ):
        raise RigidtopError(f"{name}: heyoka's functions have no cases")
    called = {word: getattr(heyoka, word, None) for word in source.names_called(func.definition)}
    unknown = sorted(word for word, function in called.items() if function is None)
    if unknown:
        raise RigidtopError(f"{name}: heyoka has no {', '.join(unknown)}")
    both = {
        word: partial(_of_either, word, function) for word, function in called.items() if function
    }
    names: dict[str, Any] = {"pi": math.pi, "e": math.e, **both}
    exec(func.source, names)
    # What is constant comes back as a plain number.
    return [
        heyoka.expression(value) if isinstance(value, int | float) else value
        for value in names[name](*symbols)
    ]


def _of_either(word: str, compiled: Any, *values: Any) -> Any:
    """A function of plain numbers, such as √π, which heyoka does not take, or of its symbols."""
    plain_numbers = all(isinstance(value, int | float) for value in values)
    return getattr(math, word)(*values) if plain_numbers else compiled(*values)
