"""Derived expressions compiled by Numba, an extra: the call of `rigidtop.codegen.numpy.function`.

What is compiled is the source that the NumPy bridge shows, so the numbers differ by rounding at
most.  The first call compiles; arrays compile anew for each choice of which arguments are arrays.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray
from sympy import Symbol

from rigidtop.codegen import numpy as plain
from rigidtop.codegen.numpy import Function
from rigidtop.errors import RigidtopError


def function(expressions: Iterable[Any], arguments: Sequence[Symbol], name: str) -> Function:
    """As `rigidtop.codegen.numpy.function`; the array function is one loop over the elements.

    Where Python raises ZeroDivisionError, floats do so here too; arrays get infinities and NaN, as
    from NumPy, but without its warning.

    Raises RigidtopError if Numba is not installed.
    """
    try:
        numba = importlib.import_module("numba")
    except ImportError:
        raise RigidtopError("numba is not installed: pip install 'rigidtop[numba]'") from None
    expressions = list(expressions)
    made = plain.function(expressions, arguments, name)
    count = len(expressions)
    names = dict(made.scalar.__globals__)  # sin, cos and all else that the source calls
    exec(made.source, names)
    element = numba.njit(names[name], error_model="numpy")

    @cache
    def loop(arrays: tuple[bool, ...]) -> Callable[..., None]:
        made: Callable[..., None] = numba.njit(_loop(element, arrays, count), error_model="numpy")
        return made

    def array(*values: Any) -> NDArray[np.float64]:
        inputs = [np.asarray(value, dtype=float) for value in values]
        shape = np.broadcast_shapes(*(value.shape for value in inputs))
        result = np.empty((count, *shape))
        # What is one number stays one, and what depends on such alone is computed once.
        rows = [
            np.ascontiguousarray(np.broadcast_to(value, shape)).reshape(-1)
            if value.ndim
            else value[()]
            for value in inputs
        ]
        loop(tuple(value.ndim > 0 for value in inputs))(*rows, result.reshape(count, -1))
        return result

    return replace(made, scalar=numba.njit(names[name]), array=array)


def _loop(element: Callable[..., Any], arrays: Sequence[bool], count: int) -> Callable[..., None]:
    """``result[:, i] = element(arguments at i)`` for all i."""
    given = ", ".join(f"a{k}[i]" if array else f"a{k}" for k, array in enumerate(arrays))
    parameters = "".join(f"a{k}, " for k in range(len(arrays)))
    targets = "".join(f"result[{k}, i], " for k in range(count))
    names: dict[str, Any] = {"element": element}
    exec(
        f"def loop({parameters}result):\n"
        "    for i in range(result.shape[1]):\n"
        f"        {targets} = element({given})",
        names,
    )
    loop: Callable[..., None] = names["loop"]
    return loop
