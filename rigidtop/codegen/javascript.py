"""Derived expressions as functions of a JavaScript module, with the types of what they take.

>>> from sympy import cos
>>> from rigidtop.theory import symbols as s
>>> print(quantity("height", "Height of the centre of mass (m).", s.R * cos(s.theta)))
/**
 * Height of the centre of mass (m).
 *
 * @param {{ R: number, theta: number }} quantities
 * @returns {number}
 */
export function height({ R, theta }) {
  return R*Math.cos(theta);
}
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Sequence

import sympy
from sympy import Expr, Symbol

from rigidtop.codegen.languages import JavaScript, broken, shared_parts
from rigidtop.codegen.shipped import RightHandSide, split

WIDTH = 100


def quantity(name: str, about: str, wanted: Expr | Iterable[Expr]) -> str:
    """A function of an object with a number for each symbol, by the symbol's name.

    It returns a number for an expression, and an array for several.  What they have in common is
    computed once.
    """
    single = isinstance(wanted, Expr)
    expressions: list[Expr] = [wanted] if isinstance(wanted, Expr) else list(wanted)
    names = sorted({x.name for e in expressions for x in e.free_symbols})
    typed = ", ".join(f"{n}: number" for n in names)
    lines = _comment(
        about,
        f"@param {{{{ {typed} }}}} quantities",
        f"@returns {{{'number' if single else 'number[]'}}}",
    )
    lines += _broken(f"export function {name}({{ {', '.join(names)} }}) {{")
    shared, results = _texts(expressions)
    lines += shared
    if single:
        lines += _broken(f"  return {results[0]};")
    else:
        lines += ["  return [", *(x for r in results for x in _broken(f"    {r},")), "  ];"]
    return "\n".join([*lines, "}"])


def rates(name: str, side: RightHandSide) -> str:
    """A function of the parameters that returns one of the state, which writes the rates."""
    parts = split(side)
    lines = _comment(
        f"{side.about}\n\nThe state is ({', '.join(x.name for x in side.state)}).",
        *(f"@param {{number}} {p.name}" for p in side.parameters),
        "@returns {(state: ArrayLike<number>, rates: Float64Array) => void}",
    )
    lines += _broken(f"export function {name}({', '.join(p.name for p in side.parameters)}) {{")
    printer = JavaScript()
    for symbol, constant in parts.constants.items():
        lines += _broken(f"  const {symbol.name} = {printer.text(constant)};")
    lines.append("  return (state, rates) => {")
    for index, symbol in enumerate(side.state):
        if any(symbol in e.free_symbols for e in parts.expressions):
            lines.append(f"    const {symbol.name} = state[{index}];")
    shared, results = _texts(parts.expressions)
    lines += ["  " + line for line in shared]
    for index, result in enumerate(results):
        lines += _broken(f"    rates[{index}] = {result};")
    return "\n".join([*lines, "  };", "}"])


def _texts(expressions: Sequence[Expr]) -> tuple[list[str], list[str]]:
    """Lines with what is shared, and the values in terms of it."""
    taken = {x.name for e in expressions for x in e.free_symbols}
    fresh = (x for x in sympy.numbered_symbols("x") if x.name not in taken)
    # Plain symbols: two of one name are one, whatever is assumed of them.
    plain = {x: Symbol(x.name) for e in expressions for x in e.free_symbols}
    shared, reduced = shared_parts([e.xreplace(plain) for e in expressions], fresh)
    printer = JavaScript()
    lines = [line for x, e in shared for line in _broken(f"  const {x.name} = {printer.text(e)};")]
    return lines, [printer.text(e) for e in reduced]


def _comment(about: str, *tags: str) -> list[str]:
    said = [line for part in about.split("\n") for line in textwrap.wrap(part, WIDTH - 3) or [""]]
    wrapped = [
        line
        for tag in tags
        for line in textwrap.wrap(tag, WIDTH - 3, subsequent_indent="  ", break_long_words=False)
    ]
    return ["/**", *(f" * {line}".rstrip() for line in [*said, "", *wrapped]), " */"]


def _broken(line: str) -> list[str]:
    return [piece.rstrip() for piece in broken(line, width=WIDTH)]
