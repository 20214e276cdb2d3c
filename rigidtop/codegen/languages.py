"""A claim's right-hand sides as source for others: a whole file with one function.

SymPy's printers write the expressions.  Here are the names, which every language restricts in its
own way, the comment that says what goes in and what comes out, and the text around them.  What
several values share is computed once, and small powers are products.

>>> from rigidtop.codegen.values import values
>>> from rigidtop.derivations.lagrange_formalism import momentum_psi
>>> from rigidtop.proof.verdict import judge
>>> made = source(values(judge(momentum_psi)), "javascript")
>>> made.arguments, made.returns
(('theta', 'phidot', 'psidot', 'lambda3'), ('p_psi',))
>>> print(made.text[made.text.index("function"):])
function equation_3_56(theta, phidot, psidot, lambda3) {
  return [
    lambda3*(phidot*Math.cos(theta) + psidot),
  ];
}
<BLANKLINE>
"""

from __future__ import annotations

import ast
import keyword
import math
import re
import textwrap
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass

import sympy
from sympy import Basic, Expr, Pow, Symbol
from sympy.core.relational import Relational
from sympy.printing.c import C99CodePrinter
from sympy.printing.fortran import FCodePrinter
from sympy.printing.jscode import JavascriptCodePrinter
from sympy.printing.julia import JuliaCodePrinter
from sympy.printing.octave import OctaveCodePrinter

from rigidtop.codegen.lines import StraightLine, in_pieces
from rigidtop.codegen.source import INDENT, WIDTH, Printer, body, broken, signature
from rigidtop.codegen.values import ClaimLine, ClaimOutputs, Output
from rigidtop.proof.equation import Equation
from rigidtop.proof.page import Assumption
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.symbols import VOCABULARY
from rigidtop.typeset.words import unmarked


@dataclass(frozen=True)
class Source:
    """A file in another language.  The text ends with a line feed."""

    name: str
    language: str
    arguments: tuple[str, ...]
    returns: tuple[str, ...]
    text: str


def plain(tree: Basic) -> str:
    """Equations, conditions and symbols in SymPy's own words."""
    if isinstance(tree, Equation):
        return f" {tree.relation} ".join(map(str, tree.sides))
    return f"{tree.lhs} {tree.rel_op} {tree.rhs}" if isinstance(tree, Relational) else str(tree)


def source(claim: ClaimOutputs, language: str, spell: Callable[[Expr], str] = plain) -> Source:
    """What a claim has to evaluate, as a file in one of `LANGUAGES`.

    `spell` writes equations, conditions and symbols in the comment.  Names that a language
    reserves, or can't tell from another, get an underscore behind them.
    """
    if language not in LANGUAGES:
        raise ValueError(f"no language {language!r}: {', '.join(LANGUAGES)}")
    write = LANGUAGES[language]
    program = _program(claim, write, spell)
    lines = [line.rstrip() for line in write.file(program)]
    returns = tuple(name for name, _ in program.results)
    return Source(claim.claim, language, program.arguments, returns, "\n".join(lines) + "\n")


def function_name(claim: str) -> str:
    """3.54 is equation_3_54, two-roots is two_roots."""
    name = re.sub(r"\W", "_", claim)
    return f"equation_{name}" if name[0].isdigit() else name


# --- Names and comments --------------------------------------------------------------------------


@dataclass(frozen=True)
class Routine:
    """A function before it is written: names that the language takes, and expressions in them."""

    name: str
    about: tuple[str, ...]
    takes: tuple[str, ...]
    gives: tuple[str, ...]
    arguments: tuple[str, ...]
    shared: tuple[tuple[str, Expr], ...]
    results: tuple[tuple[str, Expr], ...]


@dataclass(frozen=True)
class Language:
    """What `source` has to know of a language."""

    file: Callable[[Routine], Iterable[str]]
    reserved: frozenset[str]
    ignores_case: bool = False


def _program(claim: ClaimOutputs, language: Language, spell: Callable[[Expr], str]) -> Routine:
    taken = set(language.reserved)
    name = _free_name(function_name(claim.claim), taken, language.ignores_case)
    taken.add(f"{name}_module")
    symbols = {x: _free_name(x.name, taken, language.ignores_case) for x in claim.arguments}
    outputs = [_free_name(v.name, taken, language.ignores_case) for v in claim.outputs]
    # Plain symbols: two of one name are one, whatever a page assumes of them.
    renamed = {
        x: Symbol(symbols[y])
        for expression in (*(v.expression for v in claim.outputs), *(e for _, e in claim.shared))
        for x in expression.free_symbols
        for y in claim.arguments
        if x.name == y.name
    }
    fresh = _fresh(taken, language.ignores_case)
    renamed |= {x: next(fresh) for x, _ in claim.shared}
    expressions = [v.expression.xreplace(renamed) for v in claim.outputs]
    if claim.shared:
        shared = [(renamed[x], expression.xreplace(renamed)) for x, expression in claim.shared]
        reduced = expressions
    else:
        shared, reduced = shared_parts(expressions, fresh)
    shared, reduced = in_pieces(shared, reduced, fresh)
    arguments = [(symbols[x], _argument(x, spell)) for x in claim.arguments]
    results = [(o, _output(v, spell)) for o, v in zip(outputs, claim.outputs, strict=True)]
    return Routine(
        name,
        tuple(_about(claim, name, spell)),
        tuple(_aligned(arguments)),
        tuple(_aligned(results)),
        tuple(symbols.values()),
        tuple((x.name, e) for x, e in shared),
        tuple(zip(outputs, reduced, strict=True)),
    )


def _free_name(wanted: str, taken: set[str], ignores_case: bool) -> str:
    """`wanted`, with underscores behind it until it is free; it is taken from then on."""
    spoken_for = {name.lower() for name in taken} if ignores_case else taken
    name = re.sub(r"^(?![A-Za-z])", "x", re.sub(r"\W", "_", wanted, flags=re.ASCII))
    while (name.lower() if ignores_case else name) in spoken_for:
        name += "_"
    taken.add(name)
    return name


def _fresh(taken: set[str], ignores_case: bool) -> Iterator[Symbol]:
    spoken_for = {name.lower() for name in taken} if ignores_case else set(taken)
    return (x for x in sympy.numbered_symbols("x") if x.name not in spoken_for)


def shared_parts(
    expressions: Sequence[Expr], names: Iterator[Symbol]
) -> tuple[list[tuple[Symbol, Expr]], list[Expr]]:
    """What is computed once, and the values in terms of it.

    What is squared counts twice, so that sin²θ is a product of a name with itself.
    """
    powers = set().union(*(e.atoms(Pow) for e in expressions))
    squared = {p.base for p in powers if p.exp.is_Integer and abs(p.exp) > 1 and p.base.args}
    bases = sorted(squared, key=sympy.default_sort_key)
    shared, reduced = sympy.cse([*expressions, *bases], symbols=names)
    return shared, reduced[: len(expressions)]


def _about(claim: ClaimOutputs, name: str, spell: Callable[[Expr], str]) -> Iterator[str]:
    """The lines of the comment: name, claim, equations, axes, conditions."""
    yield from textwrap.wrap(f"{name}: {unmarked(claim.says)}", WIDTH - 8)
    yield ""
    conditions = [_conditions(line, spell) for line in claim.lines]
    alike = len(set(conditions)) == 1
    for line, condition in zip(claim.lines, conditions, strict=True):
        yield from _hanging(spell(line.equation))
        if condition and not alike:
            yield from _hanging(f"  if {condition}")
        if line.reason:
            yield from _hanging(f"  {unmarked(line.reason)}")
    if claim.vectors:
        axes = ", ".join(
            f"{spell(vector)} = ({', '.join(map(spell, components))})"
            for vector, components in claim.vectors
        )
        yield from _hanging(f"Components with {axes}.")
    if alike and conditions[0]:
        yield from _hanging(f"Holds if {conditions[0]}.")
    if any(v.name == "residual" for v in claim.outputs):
        yield "The value is the right-hand side, which vanishes where the equation holds."
    if claim.note:
        yield from _hanging(claim.note)
    yield ""


def _conditions(line: ClaimLine, spell: Callable[[Expr], str]) -> str:
    return "; ".join(dict.fromkeys(_condition(c, spell) for c in line.assuming))


def _hanging(text: str) -> list[str]:
    indent = " " * (len(text) - len(text.lstrip()) + 2)
    return textwrap.wrap(text, WIDTH - 8, subsequent_indent=indent, break_long_words=False)


def _condition(assumption: Assumption, spell: Callable[[Expr], str]) -> str:
    relation = spell(assumption.condition)
    if assumption.otherwise is not None:
        relation = relation.replace(" = ", " → ", 1).replace(" == ", " → ", 1)
    words = unmarked(assumption.words).rstrip(".")
    return f"{relation} ({words})" if words else relation


def _argument(symbol: Symbol, spell: Callable[[Expr], str]) -> str:
    quantity = symbol.quantity if isinstance(symbol, Lettered) else VOCABULARY.get(symbol)
    letter = "" if spell(symbol) == symbol.name else spell(symbol)
    if quantity is None:
        return letter
    unit = "" if quantity.unit in ("", "1") else f" ({quantity.unit})"
    return ", ".join(filter(None, [letter, unmarked(quantity.meaning)])) + unit


def _output(value: Output, spell: Callable[[Expr], str]) -> str:
    if value.symbol is None:
        return "" if value.name == "residual" else spell(value.equation.sides[0])
    place = ", ".join(map(str, value.index))
    which = f"{'component' if len(value.index) == 1 else 'entry'} {place} of " if place else ""
    return which + _argument(value.symbol, spell)


def _aligned(rows: Sequence[tuple[str, str]]) -> Iterator[str]:
    width = max(len(name) for name, _ in rows)
    return (f"  {name:{width}}  {about}".rstrip() for name, about in rows)


# --- Expressions ---------------------------------------------------------------------------------


class _C(Printer, C99CodePrinter):
    powers_as_products = True

    def _print_Pi(self, expr: Expr) -> str:
        return repr(math.pi)


class _Fortran(Printer, FCodePrinter):
    def _print_Pi(self, expr: Expr) -> str:
        return f"{math.pi!r}d0"

    # Beside reals, these take nothing but reals.

    def _print_Max(self, expr: Expr) -> str:
        return (
            f"{expr.func.__name__.lower()}({', '.join(self._print(_real(x)) for x in expr.args)})"
        )

    _print_Min = _print_Max

    def _print_Piecewise(self, expr: Expr) -> str:
        cases = [(_real(value), condition) for value, condition in expr.args]
        return str(super()._print_Piecewise(sympy.Piecewise(*cases, evaluate=False)))


def _real(value: Expr) -> Expr:
    return sympy.Float(value) if value.is_Integer else value


class JavaScript(Printer, JavascriptCodePrinter):
    """The printer that writes expressions in JavaScript."""

    powers_as_products = True


class _Julia(Printer, JuliaCodePrinter):
    def _print_Pow(self, expr: Expr) -> str:
        return super()._print_Pow(expr).replace(" .^ ", "^").replace(" ^ ", "^")


class _Octave(Printer, OctaveCodePrinter):
    times, over = ".*", "./"


def _printed(program: Routine, printer: Printer) -> tuple[list[tuple[str, str]], ...]:
    """Shared parts and results as text."""
    return tuple(
        [(name, printer.text(expression)) for name, expression in pairs]
        for pairs in (program.shared, program.results)
    )


# --- Files ---------------------------------------------------------------------------------------


def _comment(program: Routine, mark: str, returns: str) -> list[str]:
    takes = "Takes numbers, in this order:"
    lines = [*program.about, takes, *program.takes, f"{returns}:", *program.gives]
    return [f"{mark} {line}" for line in lines]


def _c(program: Routine) -> Iterator[str]:
    shared, results = _printed(program, _C({"math_macros": {}}))
    count = len(results)
    yield "/*"
    for line in _comment(program, " *", f"Puts {_numbers(count)} into out, in this order"):
        yield line.replace("*/", "* /")
    yield " */"
    yield "#include <math.h>"
    yield ""
    parameters = ", ".join(f"double {name}" for name in program.arguments)
    yield from broken(f"void {program.name}({parameters}, double *out)")
    yield "{"
    for name, text in shared:
        yield from broken(f"    const double {name} = {text};")
    for i, (_, text) in enumerate(results):
        yield from broken(f"    out[{i}] = {text};")
    yield "}"


def _fortran(program: Routine) -> Iterator[str]:
    printer = _Fortran({"source_format": "free", "standard": 2008})
    shared, results = _printed(program, printer)
    count = len(results)
    yield from _comment(program, "!", f"Puts {_numbers(count)} into out, in this order")
    yield f"module {program.name}_module"
    yield "  use, intrinsic :: iso_fortran_env, only: real64"
    yield "  implicit none"
    yield "  private"
    yield f"  public :: {program.name}"
    yield "contains"
    names = ", ".join(program.arguments)
    yield from broken(f"  pure subroutine {program.name}({names}, out)", " &")
    yield from broken(f"    real(real64), intent(in) :: {names}", " &")
    yield f"    real(real64), intent(out) :: out({count})"
    if shared:
        yield from broken(f"    real(real64) :: {', '.join(name for name, _ in shared)}", " &")
    yield ""
    for name, text in shared:
        yield from broken(f"    {name} = {text}", " &")
    for i, (_, text) in enumerate(results):
        yield from broken(f"    out({i + 1}) = {text}", " &")
    yield f"  end subroutine {program.name}"
    yield f"end module {program.name}_module"


def _javascript(program: Routine) -> Iterator[str]:
    shared, results = _printed(program, JavaScript())
    yield from _comment(program, "//", f"Returns an array of {_numbers(len(results))}")
    yield from broken(f"function {program.name}({', '.join(program.arguments)}) {{")
    for name, text in shared:
        yield from broken(f"  const {name} = {text};")
    yield "  return ["
    for _, text in results:
        yield from broken(f"    {text},")
    yield "  ];"
    yield "}"


def _julia(program: Routine) -> Iterator[str]:
    shared, results = _printed(program, _Julia())
    yield from _comment(program, "#", f"Returns a tuple of {_numbers(len(results))}")
    yield f"# Over arrays it broadcasts: {program.name}.(…)"
    yield from broken(f"function {program.name}({', '.join(program.arguments)})")
    for name, text in shared:
        yield from broken(f"    {name} = {text}")
    yield "    return ("
    for _, text in results:
        yield from broken(f"        {text},")
    yield "    )"
    yield "end"


def _octave(program: Routine) -> Iterator[str]:
    shared, results = _printed(program, _Octave())
    names = ", ".join(name for name, _ in results)
    yield from broken(
        f"function [{names}] = {program.name}({', '.join(program.arguments)})", " ..."
    )
    yield from _comment(program, "  %", f"Returns {_numbers(len(results))}")
    yield "  % Elementwise: arrays of one shape may stand for numbers, in Octave and in MATLAB."
    if any(not expression.free_symbols for _, expression in program.results):
        yield "  % What is constant stays one number."
    for name, text in (*shared, *results):
        yield from broken(f"  {name} = {text};", " ...")
    yield "end"


def _python(program: Routine) -> Iterator[str]:
    shared = tuple((Symbol(name), value) for name, value in program.shared)
    lines = body(StraightLine(shared, tuple(value for _, value in program.results)))
    head = signature(program.name, program.arguments)
    tree = ast.parse("\n".join([*head, *lines]))
    used = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name)}
    imported = sorted(name for name in used - {*program.arguments} if hasattr(math, name))
    if imported:
        yield f"from math import {', '.join(imported)}  # from numpy, and it takes arrays"
        yield ""
        yield ""
    yield from head
    about = _comment(program, "", f"Returns a tuple of {_numbers(len(program.results))}")
    first, *others = (line.removeprefix(" ") for line in about)
    yield f'{INDENT}"""{first.removeprefix(program.name + ": ")}'
    yield from (INDENT + line for line in others)
    yield f'{INDENT}"""'
    yield from lines


def _numbers(count: int) -> str:
    return "1 number" if count == 1 else f"{count} numbers"


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


_FUNCTIONS = "sin cos tan asin acos atan atan2 exp log sqrt abs pow pi"

LANGUAGES = {
    "python": Language(_python, frozenset(keyword.kwlist) | _words(_FUNCTIONS)),
    "c": Language(
        _c,
        _words(
            "auto break case char const continue default do double else enum extern float for "
            "goto if inline int long main register restrict return short signed sizeof static "
            "struct switch typedef union unsigned void volatile while fabs out " + _FUNCTIONS
        ),
    ),
    "fortran": Language(_fortran, _words("real real64 out " + _FUNCTIONS), ignores_case=True),
    "julia": Language(
        _julia,
        _words(
            "baremodule begin break catch const continue do else elseif end export false "
            "finally for function global if import in isa let local macro module quote return "
            "struct true try using where while " + _FUNCTIONS
        ),
    ),
    "javascript": Language(
        _javascript,
        _words(
            "arguments await break case catch class const continue debugger default delete do else "
            "enum eval export extends false finally for function if implements import in "
            "instanceof interface let new null package private protected public return static "
            "super switch this throw true try typeof var void while with yield Math"
        ),
    ),
    "octave": Language(
        _octave,
        _words(
            "break case catch continue do else elseif end end_try_catch end_unwind_protect endfor "
            "endfunction endif endparfor endswitch endwhile for function global if otherwise "
            "parfor persistent return switch try until unwind_protect unwind_protect_cleanup while "
            + _FUNCTIONS
        ),
    ),
}
"""How each language is written, by its name on the command line."""
