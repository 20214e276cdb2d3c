"""Derived expressions as functions of a JavaScript module, with the types of what they take.

>>> from sympy import cos
>>> from rigidtop.theory import symbols as s
>>> print(quantity("height", "Height of the centre of mass (m).", s.R * cos(s.theta)))
/**
 * Height of the centre of mass (m).
 *
 * @param {{ R: number, theta: number }} quantities
 */
export function height({ R, theta }) {
  return R*Math.cos(theta);
}
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Mapping, Sequence

import sympy
from sympy import Expr, Symbol

from rigidtop.codegen.languages import JavaScript, shared_parts
from rigidtop.codegen.shipped import RightHandSide, split
from rigidtop.codegen.source import WIDTH, broken


def quantity(name: str, about: str, wanted: Expr | Iterable[Expr]) -> str:
    """A function of an object with a number for each symbol, by the symbol's name.

    It returns a number for an expression, and an array for several.  What they have in common is
    computed once.
    """
    single = isinstance(wanted, Expr)
    expressions: list[Expr] = [wanted] if isinstance(wanted, Expr) else list(wanted)
    names = sorted({x.name for e in expressions for x in e.free_symbols})
    typed = ", ".join(f"{n}: number" for n in names)
    lines = _comment(about, f"@param {{{{ {typed} }}}} quantities")
    lines += broken(f"export function {name}({{ {', '.join(names)} }}) {{")
    shared, results = _texts(expressions)
    lines += shared
    if single:
        lines += broken(f"  return {results[0]};")
    else:
        lines += ["  return [", *(x for r in results for x in broken(f"    {r},")), "  ];"]
    return "\n".join([*lines, "}"])


def rates(name: str, side: RightHandSide) -> str:
    """A function of the parameters that returns one of the state, which writes the rates."""
    parts = split(side)
    lines = _comment(
        f"{side.about}\n\nThe state is ({', '.join(x.name for x in side.state)}).",
        *(f"@param {{number}} {p.name}" for p in side.parameters),
        "@returns {(state: ArrayLike<number>, rates: Float64Array) => void}",
    )
    lines += broken(f"export function {name}({', '.join(p.name for p in side.parameters)}) {{")
    printer = JavaScript()
    for symbol, constant in parts.constants.items():
        lines += broken(f"  const {symbol.name} = {printer.text(constant)};")
    lines.append("  return (state, rates) => {")
    for index, symbol in enumerate(side.state):
        if any(symbol in e.free_symbols for e in parts.expressions):
            lines.append(f"    const {symbol.name} = state[{index}];")
    shared, results = _texts(parts.expressions)
    lines += ["  " + line for line in shared]
    for index, result in enumerate(results):
        lines += broken(f"    rates[{index}] = {result};")
    return "\n".join([*lines, "  };", "}"])


def of_arrays(
    name: str,
    about: str,
    takes: Mapping[str, Sequence[Symbol]],
    wanted: Sequence[Expr],
    shared: Sequence[tuple[Symbol, Expr]] = (),
) -> str:
    """A function of arrays of numbers, one for each group of symbols, which writes into `out`.

    What the symbols are called stays outside: the first of a group ``s`` is ``s0`` inside.  What is
    computed once is `shared` if it is given.  Raises ValueError or NotImplementedError, as SymPy's
    printers do, for what has no counterpart.

    >>> x, m = sympy.symbols("x m")
    >>> print(of_arrays("force", "The force (N).", {"s": [x], "p": [m]}, [m * x]))
    /**
     * The force (N).
     *
     * @param {ArrayLike<number>} s
     * @param {ArrayLike<number>} p
     * @param {Float64Array} out
     */
    export function force(s, p, out) {
      const s0 = s[0];
      const p0 = p[0];
      out[0] = p0*s0;
    }
    """
    inside = {x: Symbol(f"{group}{k}") for group, row in takes.items() for k, x in enumerate(row)}
    parts = {x: Symbol(f"x{k}") for k, (x, _) in enumerate(shared)}
    own = inside | parts
    results = [sympy.sympify(each).xreplace(own) for each in wanted]
    once = [(parts[x], value.xreplace(own)) for x, value in shared]
    if not shared:
        once, results = shared_parts(results, sympy.numbered_symbols("x"))
    used = set().union(*(e.free_symbols for e in (*results, *(e for _, e in once))))
    kinds = [*(f"@param {{ArrayLike<number>}} {group}" for group in takes)]
    lines = _comment(about, *kinds, "@param {Float64Array} out")
    lines.append(f"export function {name}({', '.join([*takes, 'out'])}) {{")
    for group, row in takes.items():
        read = (k for k, x in enumerate(row) if inside[x] in used)
        lines += [f"  const {group}{k} = {group}[{k}];" for k in read]
    printer = JavaScript()
    for x, value in once:
        lines += broken(f"  const {x.name} = {printer.text(value)};")
    for k, result in enumerate(results):
        lines += broken(f"  out[{k}] = {printer.text(result)};")
    return "\n".join([*lines, "}"])


def _texts(expressions: Sequence[Expr]) -> tuple[list[str], list[str]]:
    """Lines with what is shared, and the values in terms of it."""
    taken = {x.name for e in expressions for x in e.free_symbols}
    fresh = (x for x in sympy.numbered_symbols("x") if x.name not in taken)
    # Plain symbols: two of one name are one, whatever is assumed of them.
    plain = {x: Symbol(x.name) for e in expressions for x in e.free_symbols}
    shared, reduced = shared_parts([e.xreplace(plain) for e in expressions], fresh)
    printer = JavaScript()
    lines = [line for x, e in shared for line in broken(f"  const {x.name} = {printer.text(e)};")]
    return lines, [printer.text(e) for e in reduced]


def _comment(about: str, *tags: str) -> list[str]:
    lines = [line for part in about.split("\n") for line in textwrap.wrap(part, WIDTH - 3) or [""]]
    wrapped = [
        line
        for tag in tags
        for line in textwrap.wrap(tag, WIDTH - 3, subsequent_indent="  ", break_long_words=False)
    ]
    return ["/**", *(f" * {line}".rstrip() for line in [*lines, "", *wrapped]), " */"]
