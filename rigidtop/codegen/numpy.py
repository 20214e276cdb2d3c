"""Derived expressions become functions: of floats through `math`, of arrays through NumPy.

>>> from sympy import sin, symbols
>>> theta, thetadot = symbols("theta thetadot")
>>> pendulum = function([thetadot, -sin(theta) / 2], (theta, thetadot), "pendulum")
>>> print(pendulum.source)
def pendulum(theta, thetadot):
    return (
        thetadot,
        -sin(theta)/2,
    )
>>> pendulum.scalar(0.5, 3.0)
(3.0, -0.2397127693021015)
>>> pendulum.array([[0.0, 0.5]], 1.0).shape    # two expressions, each of shape (1, 2)
(2, 1, 2)
>>> pendulum(0.5, 3.0) == pendulum.scalar(0.5, 3.0)    # of arrays it is `array`
True
>>> pendulum.operations                        # a sine, a sign and a division
3
"""

from __future__ import annotations

import ast
import builtins
import keyword
import math
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
import sympy
from numpy.typing import NDArray
from sympy import Expr, Symbol

from rigidtop.codegen import source
from rigidtop.codegen.lines import StraightLine, in_pieces


@dataclass(frozen=True)
class Function:
    """Expressions as a function of numbers, made by `function`."""

    scalar: Callable[..., Sequence[float]]
    """Floats in, floats out, one for each expression; through `math`."""

    array: Callable[..., NDArray[np.float64]]
    """Arrays in, one array out, of shape (expressions, *shape to which the arguments broadcast)."""

    program: StraightLine
    """What is computed, shared subexpressions once."""

    source: str
    """The Python that `scalar` runs, as text for a reader."""

    @property
    def definition(self) -> ast.FunctionDef:
        """The definition in `source` as a syntax tree."""
        [definition] = ast.parse(self.source).body
        assert isinstance(definition, ast.FunctionDef)
        return definition

    @property
    def operations(self) -> int:
        """Sums, products, powers, signs and calls in one evaluation."""
        return source.operations(self.definition)

    def __call__(self, *values: Any) -> Any:
        """`scalar` of numbers, `array` as soon as one argument is no single number."""
        return (self.array if any(map(np.ndim, values)) else self.scalar)(*values)


def function(
    expressions: Iterable[Expr],
    arguments: Sequence[Symbol],
    name: str,
    shared: Sequence[tuple[Symbol, Expr]] = (),
) -> Function:
    """Make a function of `arguments`, in this order, that returns the values of `expressions`.

    `expressions` is any iterable of SymPy expressions, also a column matrix.  The names of the
    symbols become the names of the parameters.  Nothing is simplified; what the expressions have
    in common is computed once.  What is `shared`, each in terms of those before it, is computed as
    it stands, and nothing else is looked for.

    Raises ValueError if an expression contains a symbol that is not an argument or a function that
    Python does not have, or if a name is no Python identifier.
    """
    wanted = [sympy.sympify(expression) for expression in expressions]
    unbound = set().union(*(e.free_symbols for e in (*wanted, *(x for _, x in shared))))
    unbound -= {*arguments, *(x for x, _ in shared)}
    if unbound:
        raise ValueError(f"{name}: {', '.join(sorted(map(str, unbound)))} missing in the arguments")
    for word in (name, *(a.name for a in arguments)):
        if not word.isidentifier() or keyword.iskeyword(word):
            raise ValueError(f"{word!r} cannot be a name in Python")
    assignments, reduced = (shared, wanted) if shared else sympy.cse(wanted)
    taken = {x.name for x in (*arguments, *(x for x, _ in assignments))}
    free = (x for x in sympy.numbered_symbols("x") if x.name not in taken)
    lines, results = in_pieces(assignments, reduced, free)
    program = StraightLine(tuple(lines), tuple(results))
    try:
        text = source.signature(name, [a.name for a in arguments])
        text += source.body(program, sorts=not shared)
    except NotImplementedError as error:
        [what] = re.findall(r"\w+(?='>)", str(error))[-1:] or [str(error)]
        raise ValueError(f"{name}: Python has no {what}") from None
    names = {word: value for word, value in vars(math).items() if not word.startswith("_")}
    exec("\n".join(text), names)

    @cache
    def over_arrays() -> Any:
        return _over_arrays(program, arguments)

    def array(*values: Any) -> NDArray[np.float64]:
        inputs = [np.asarray(value, dtype=float) for value in values]
        shape = np.broadcast_shapes(*(value.shape for value in inputs))
        # An expression that is constant comes back as one number, whatever the shape.
        return np.stack([np.broadcast_to(value, shape) for value in over_arrays()(*inputs)])

    function = Function(names[name], array, program, "\n".join(text))
    missing = source.names_called(function.definition) - {*names, *dir(builtins)}
    if missing:
        raise ValueError(f"{name}: Python has no {', '.join(sorted(missing))}")
    return function


def _over_arrays(program: StraightLine, arguments: Sequence[Symbol]) -> Any:
    modules: Any = "numpy"
    if any(e.has(*OF_SCIPY) for e in (*program.results, *(x for _, x in program.shared))):
        from scipy import special

        names = {"erf": "erf", "erfc": "erfc", "gamma": "gamma", "lgamma": "gammaln"}
        modules = [{name: getattr(special, own) for name, own in names.items()}, "numpy"]
    lines = list(program.shared), list(program.results)
    return sympy.lambdify(list(arguments), lines[1], modules=modules, cse=lambda _: lines)


OF_SCIPY = (sympy.erf, sympy.erfc, sympy.gamma, sympy.loggamma)
"""What `math` has for one number, and NumPy for none."""
