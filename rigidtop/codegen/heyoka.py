"""Derived expressions compiled by heyoka, an extra: the call of `rigidtop.codegen.numpy.function`.

As many elements are computed at once as a processor's registers hold, sines too, and large arrays
by several threads.
"""

from __future__ import annotations

import ast
import importlib
import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray
from sympy import Symbol

from rigidtop.codegen import numpy as plain
from rigidtop.codegen import source
from rigidtop.codegen.numpy import Function
from rigidtop.errors import RigidtopError

Floats = NDArray[np.float64]


@dataclass(frozen=True)
class BatchFunction(Function):
    """A function that also takes all its arguments in one array."""

    batch: Callable[..., Floats]
    """An array (arguments, N) in, contiguous, and one (expressions, N) out, or into ``outputs``.

    Nothing is copied: `array` and `scalar` put their arguments into such an array first.
    """


def function(
    expressions: Iterable[Any],
    arguments: Sequence[Symbol],
    name: str,
    shared: Sequence[tuple[Symbol, Any]] = (),
) -> BatchFunction:
    """As `rigidtop.codegen.numpy.function`.

    What is divided by zero becomes infinite or NaN, without a warning, also for floats.

    Raises RigidtopError if heyoka is not installed, or if it has no counterpart of a function that
    occurs.
    """
    heyoka = loaded("heyoka is not installed")
    made = plain.function(expressions, arguments, name, shared)
    symbols = [heyoka.expression(argument.name) for argument in arguments]
    compiled = heyoka.cfunc(on_symbols(heyoka, made, name, symbols), symbols)

    def scalar(*values: float) -> list[float]:
        result: list[float] = compiled(np.array(values, dtype=float)).tolist()
        return result

    def array(*values: Any) -> Floats:
        inputs = [np.asarray(value, dtype=float) for value in values]
        shape = np.broadcast_shapes(*(value.shape for value in inputs))
        rows = np.empty((len(inputs), *shape))
        for k, value in enumerate(inputs):
            rows[k, ...] = value
        result: Floats = compiled(rows.reshape(len(inputs), -1))
        return result.reshape(len(result), *shape)

    return BatchFunction(
        scalar=scalar,
        array=array,
        source=made.source,
        operations=made.operations,
        definition=made.definition,
        batch=compiled,
    )


def loaded(without: str) -> Any:
    """heyoka.  Raises RigidtopError, which says what is the matter `without` it."""
    try:
        return importlib.import_module("heyoka")
    except ImportError:
        raise RigidtopError(
            f"{without}: pip install 'rigidtop[taylor]' (wheels for Linux only)"
        ) from None


def on_symbols(heyoka: Any, made: Function, name: str, symbols: Sequence[Any]) -> list[Any]:
    """The source of a function, run on heyoka's symbols."""
    # A choice between cases would be made once, for symbols, which are neither true nor false.
    if any(
        isinstance(node, ast.IfExp | ast.BoolOp | ast.Compare) for node in ast.walk(made.definition)
    ):
        raise RigidtopError(f"{name}: heyoka's functions have no cases")
    called = {word: getattr(heyoka, word, None) for word in source.names_called(made.definition)}
    unknown = sorted(word for word, function in called.items() if function is None)
    if unknown:
        raise RigidtopError(f"{name}: heyoka has no {', '.join(unknown)}")
    both = {
        word: partial(_of_either, word, function) for word, function in called.items() if function
    }
    names: dict[str, Any] = {"pi": math.pi, "e": math.e, **both}
    exec(made.source, names)
    # What is constant comes back as a plain number.
    return [
        heyoka.expression(value) if isinstance(value, int | float) else value
        for value in names[name](*symbols)
    ]


def _of_either(word: str, compiled: Any, *values: Any) -> Any:
    """Of plain numbers, such as √π, which heyoka's functions do not take, or of its symbols."""
    plain_numbers = all(isinstance(value, int | float) for value in values)
    return getattr(math, word)(*values) if plain_numbers else compiled(*values)
