"""Derivatives by symbols and by time, along a motion and in a series."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import lru_cache

import sympy
from sympy import (
    Add,
    Derivative,
    Dummy,
    Expr,
    Integer,
    Matrix,
    MatrixBase,
    Mul,
    Pow,
    Symbol,
    cos,
    exp,
    sin,
    tan,
)
from sympy.core.function import AppliedUndef

from rigidtop.theory.lettered import Lettered
from rigidtop.theory.polynomial import CACHED


@lru_cache(maxsize=10 * CACHED)
def slope(expression: Expr, x: Symbol) -> Expr:
    """The partial derivative by a symbol, in the form that `Expr.diff` gives it.

    That asks of each part's derivative whether it vanishes, by all that is known of its symbols:
    most of its time.

    >>> from sympy.abc import x, y
    >>> slope(y*sympy.sin(x*y)/x**2, x)
    y**2*cos(x*y)/x**2 - 2*y*sin(x*y)/x**3
    """
    if not expression.args:
        return Integer(int(expression == x))
    parts = expression.args
    if expression.is_Add:
        return Add(*(slope(part, x) for part in parts))
    if expression.is_Pow and expression.exp.is_number:
        power = expression.exp
        return slope(expression.base, x) * power * expression.base ** (power - 1)
    if expression.is_Mul:
        kept = [(parts[:k], slope(part, x), parts[k + 1 :]) for k, part in enumerate(parts)]
        return Add(*(Mul(*before, part, *after) for before, part, after in kept if part != 0))
    if isinstance(expression, (sin, cos)):
        return slope(parts[0], x) * expression.fdiff()
    return expression.diff(x)


_SMOOTH = (Add, Mul, Pow, sin, cos, tan, exp, Symbol, sympy.Number, sympy.NumberSymbol)
"""What has all its derivatives where one of them is finite: no bars, no steps."""


def slopes_at_zero(expression: Expr, x: Symbol) -> Iterator[Expr]:
    """f(0), f′(0), f″(0) …, as long as they are finite; nothing where f need not be smooth.

    >>> from itertools import islice
    >>> from sympy.abc import x
    >>> [*islice(slopes_at_zero(sin(2*x)/(1 - x), x), 3)], [*slopes_at_zero(sympy.sqrt(x), x)]
    ([0, 2, 4], [0])
    """
    if all(isinstance(part, _SMOOTH) for part in sympy.preorder_traversal(expression)):
        while not (at := expression.subs(x, 0)).has(sympy.nan, sympy.zoo, sympy.oo):
            yield at
            expression = slope(expression, x)


def total_derivative(expression: Expr | MatrixBase, rates: Mapping[Expr, Expr]) -> Expr | Matrix:
    """d/dt by the chain rule: Σ ∂/∂q · q̇ over the q in `rates`, and ∂/∂t.

    The q are symbols, or functions of time and their derivatives.  A function of time that has no
    rate there is differentiated; the symbol named t is the time; other symbols are constant.

    >>> from rigidtop.theory import symbols as s
    >>> total_derivative(sympy.sin(s.theta), {s.theta: s.thetadot})
    thetadot*cos(theta)
    >>> x = sympy.Function("x")(s.t)
    >>> total_derivative(s.t*x**2, {x: s.omega})
    2*omega*t*x(t) + x(t)**2

    Raises ValueError where it cannot be known what a rate belongs to, or which symbol is the time.
    """
    if isinstance(expression, MatrixBase):
        return expression.applyfunc(lambda entry: total_derivative(entry, rates))
    moving = _moving(expression, rates)
    # A letter for each: SymPy would find a function within its own derivatives.
    letters = {x: x if x.is_Symbol else Dummy() for x in moving}
    lettered = expression.xreplace(letters)
    words = {letter: x for x, letter in letters.items()}
    present = lettered.free_symbols
    changing = (x for x in words if x in present and moving[words[x]] != 0)
    terms = (slope(lettered, x) * moving[words[x]] for x in changing)
    return sum((term.xreplace(words) for term in terms), Integer(0))


def _moving(expression: Expr, rates: Mapping[Expr, Expr]) -> dict[Expr, Expr]:
    """What changes in time, each with its rate: `rates`, the time, derivatives of the functions."""
    functions = {x.expr if isinstance(x, Derivative) else x for x in rates if not x.is_Symbol}
    unknown = [x for x in functions if not (isinstance(x, AppliedUndef) and len(x.args) == 1)]
    if unknown:
        raise ValueError(f"{unknown[0]} has a rate, but is no symbol and no function of time")
    times = {x.args[0] for x in functions}
    times |= {x for x in expression.free_symbols if _is_time(x)}
    if len(times) > 1:
        both = " and ".join(sorted(map(sympy.srepr, times)))
        raise ValueError(f"two times, {both}: there is only one")
    moving = {**dict.fromkeys(times, Integer(1)), **rates}
    for x in expression.atoms(AppliedUndef):
        if len(x.args) == 1 and x.args[0].is_Symbol and x.args[0] not in moving:
            raise ValueError(f"is {x.args[0]} in {x} the time? Then give it the rate 1, else 0")
    for x in expression.atoms(Derivative):
        own = functions & x.atoms(AppliedUndef)
        if x in rates or not own or not times & {*x.variables}:
            continue
        lower = [f for f in rates if f.has(*own) and rates[f] != f.diff(*times)]
        if lower or x.expr not in own:
            raise ValueError(f"{x} does not go with the rate given for {', '.join(map(str, own))}")
        moving[x] = x.diff(*times)
    return moving


def _is_time(symbol: Expr) -> bool:
    """Whether a symbol is the time, by its name; but a t of one's own may be a thickness."""
    return str(symbol) == "t" and (not isinstance(symbol, Lettered) or symbol.quantity.unit == "s")
