"""What a system's quantities are called, whichever way they were given.

Coordinates come as functions of time, such as SymPy's `dynamicsymbols`, or as plain symbols with
their rates.  Inside all of them are plain symbols, in which SymPy computes many times faster, and
which have letters; what is handed out is in the names that were given.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeVar

import sympy
from sympy import Derivative, Eq, Expr, Integral, MatrixBase, Sum, Symbol
from sympy.core.function import AppliedUndef

from rigidtop.errors import RigidtopError
from rigidtop.motion import checks
from rigidtop.parameters import in_one_line
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.symbols import Glyph, VocabularyEntry
from rigidtop.typeset.nodes import glyph

ExprOrMatrix = TypeVar("ExprOrMatrix", Expr, MatrixBase)

Given = Any
"""What SymPy takes for an expression; sequences and mappings of such."""


UNDONE = (Derivative, Integral, Sum, sympy.Product)
"""What may stand for something that is known: written out, where it is met."""


@dataclass(frozen=True)
class PlainSymbols:
    """Plain symbols for coordinates, velocities, accelerations and momenta, n of each.

    `given` says which of them stand for what was given otherwise; `t` is the time.
    """

    q: tuple[Symbol, ...]
    v: tuple[Symbol, ...]
    a: tuple[Symbol, ...]
    p: tuple[Symbol, ...]
    t: Symbol
    given: Mapping[Symbol, Expr]

    def plain(self, expression: ExprOrMatrix) -> ExprOrMatrix:
        """An expression in the given names, in plain symbols."""
        if not self.given:
            return expression
        back = {x: symbol for symbol, x in self.given.items()}
        # Derivatives first: a function would be found within its own.
        rates = {x: y for x, y in back.items() if isinstance(x, Derivative)}
        plain = expression.xreplace(rates)
        if plain.has(*UNDONE):
            plain = expression.doit().xreplace(rates)
        return plain.xreplace(back)

    def back(self, expression: ExprOrMatrix) -> ExprOrMatrix:
        """An expression in plain symbols, in the given names."""
        return expression.xreplace(dict(self.given)) if self.given else expression

    @property
    def rates(self) -> dict[Expr, Expr]:
        """The rate of each symbol: q̇ for q, q̈ for q̇."""
        return dict(zip((*self.q, *self.v), (*self.v, *self.a), strict=True))

    def rate(self, value: ExprOrMatrix, rates: Mapping[Expr, Expr]) -> ExprOrMatrix:
        """d/dt by the chain rule, explicit time too; in plain symbols."""
        if isinstance(value, MatrixBase):
            return value.applyfunc(lambda entry: self.rate(entry, rates))
        return sympy.Add(*(value.diff(x) * v for x, v in rates.items()), value.diff(self.t))

    def spelled(self, x: Symbol) -> str:
        """A name in tables and source: theta_dot, theta_ddot, or the one that it was given."""
        of_functions = isinstance(self.given.get(self.v[0]), Derivative)
        for group, rate in ((self.v, "dot"), (self.a, "ddot")):
            if x in group and (of_functions or rate == "ddot"):
                return f"{self.q[group.index(x)].name}_{rate}"
        return str(x.name)

    def find(self, name: Expr) -> Symbol | None:
        """The coordinate that is meant: as it was given, its plain symbol, or its name."""
        for symbol in self.q:
            if name in (symbol, self.given.get(symbol), symbol.name):
                return symbol
        return None


def named(q: Sequence[Expr], qdot: Sequence[Expr] | None, taken: Iterable[Symbol]) -> PlainSymbols:
    """Names for coordinates as they are given.  Raises RigidtopError, in one line, for others.

    `taken` are the letters that mean something else already.
    """
    q = _row("coordinates", q)
    qdot = None if qdot is None else _row("velocities", qdot)
    if not q:
        raise RigidtopError("a system needs a coordinate, such as q = [theta]")
    for what, group in (("coordinates", q), ("velocities", qdot or ())):
        if len({*group}) < len(group):
            symbols = ", ".join(map(str, group))
            raise RigidtopError(f"among the {what}, {symbols}, one stands twice")
    if qdot is not None and len(qdot) != len(q):
        raise RigidtopError(
            f"{len(q)} coordinates and {len(qdot)} velocities: there have to be as many of each"
        )
    functions = [x for x in q if isinstance(x, AppliedUndef)]
    if len(functions) not in (0, len(q)):
        raise RigidtopError("coordinates are all functions of time, or all plain symbols")
    if functions:
        return _of_functions(q, qdot, {x.name for x in taken})
    return _of_symbols(q, qdot, {x.name for x in taken})


def _row(what: str, group: Given) -> tuple[Expr, ...]:
    if isinstance(group, (str, bytes)) or not isinstance(
        group, (Sequence, MatrixBase, Expr, sympy.Tuple)
    ):
        raise RigidtopError(f"the {what} must be symbols, such as [x, y], not {in_one_line(group)}")
    row = (group,) if isinstance(group, Expr) else tuple(group)
    for x in row:
        if not (isinstance(x, Expr) and getattr(x, "_diff_wrt", False)):
            raise RigidtopError(
                f"{in_one_line(x)} is among the {what}: no symbol and no function of time"
            )
    return row


def _of_symbols(q: Sequence[Expr], qdot: Sequence[Expr] | None, taken: set[str]) -> PlainSymbols:
    if qdot is None:
        raise RigidtopError(
            f"which symbol is the rate of {q[0]}? Plain coordinates need their velocities: "
            "qdot = […], in the same order"
        )
    for x in (*q, *qdot):
        if not isinstance(x, Symbol):
            raise RigidtopError(f"{x} is given with plain symbols: it has to be one too")
        if x.is_real is False:
            raise RigidtopError(f"{x} is a symbol for numbers that are not real")
    both = [x for x in qdot if x in q]
    if both:
        raise RigidtopError(f"{both[0]} is given as a coordinate and as a velocity")
    free = _Free(taken | {x.name for x in (*q, *qdot)})
    a = tuple(_dotted(x, free, 2) for x in q)
    p = tuple(_momentum(x, free) for x in q)
    # |x| has no derivative for SymPy where x might be complex.
    real = {x: x if x.is_real else like(x, x.name, real=True) for x in (*q, *qdot)}
    originals = {own: x for x, own in real.items() if own != x}
    return PlainSymbols(
        tuple(map(real.get, q)), tuple(map(real.get, qdot)), a, p, Symbol("t"), originals
    )


def _of_functions(q: Sequence[Expr], qdot: Sequence[Expr] | None, taken: set[str]) -> PlainSymbols:
    times = {x for f in q for x in f.args}
    if len(times) != 1 or not next(iter(times)).is_Symbol:
        raise RigidtopError(f"{', '.join(map(str, q))}: coordinates are functions of one time")
    [t] = times
    rates = [f.diff(t) for f in q]
    for x, v, rate in zip(q, qdot or rates, rates, strict=True):
        if v != rate:
            raise RigidtopError(f"{v} is given as the rate of {x}: that is {rate}")
    free = _Free(taken | {t.name})
    plain = tuple(free.take(Symbol(f.func.__name__, real=True)) for f in q)
    v, a = (tuple(_dotted(x, free, order) for x in plain) for order in (1, 2))
    p = tuple(_momentum(x, free) for x in plain)
    originals = {
        **dict(zip(plain, q, strict=True)),
        **dict(zip(v, rates, strict=True)),
        **{x: f.diff(t, 2) for x, f in zip(a, q, strict=True)},
    }
    return PlainSymbols(plain, v, a, p, t, originals)


@dataclass
class _Free:
    """Names that are not taken yet; one that is gets underscores behind it."""

    taken: set[str]

    def take(self, wanted: Symbol) -> Symbol:
        name = wanted.name
        while name in self.taken:
            name += "_"
        self.taken.add(name)
        if name == wanted.name:
            return wanted
        return like(wanted, name)


def like(x: Symbol, name: str, **assumed: bool) -> Symbol:
    """A symbol with the letter of another, if it has one, and its assumptions."""
    assumptions = {**x.assumptions0, **assumed}
    if isinstance(x, Lettered):
        return Lettered(name, x.quantity, x.place, **assumptions)
    return Symbol(name, **assumptions)


def lettered(x: Symbol, place: int = 0) -> Lettered:
    """The same symbol with its letter, and a place in print; a plain one means what it likes."""
    quantity = x.quantity if isinstance(x, Lettered) else VocabularyEntry(glyph(x.name), "", "")
    return Lettered(x.name, quantity, place, **x.assumptions0)


def _dotted(x: Symbol, free: _Free, order: int) -> Symbol:
    """A symbol for a rate: thetadot, thetaddot."""
    accent = "d" * (order - 1) + "dot"
    name = f"{x.name}{accent}"
    if not isinstance(x, Lettered):
        return free.take(Symbol(name, real=True))
    unit = f"{x.quantity.unit}/s" if order == 1 else f"{x.quantity.unit}/s²"
    quantity = VocabularyEntry(
        replace(x.quantity.glyph, accent=accent),
        f"{'rate' if order == 1 else 'second rate'} of {x.quantity.meaning}",
        unit if x.quantity.unit else "",
    )
    return free.take(Lettered(name, quantity, x.place, real=True))


def _momentum(x: Symbol, free: _Free) -> Symbol:
    """A symbol for a momentum: p_theta."""
    name = f"p_{x.name}"
    if not isinstance(x, Lettered):
        return free.take(Symbol(name, real=True))
    glyph = x.quantity.glyph
    quantity = VocabularyEntry(Glyph("p", sub=glyph.base + glyph.sub), f"momentum of {x.name}", "")
    return free.take(Lettered(name, quantity, x.place, real=True))


def multipliers(count: int, taken: Iterable[Symbol]) -> tuple[Symbol, ...]:
    """Symbols λ₁, λ₂, … for the multipliers of constraints, none of them `taken`."""
    free = _Free({x.name for x in taken})
    symbols = []
    for k in range(count):
        quantity = VocabularyEntry(Glyph("λ", str(k + 1) if count > 1 else ""), "multiplier", "")
        symbols.append(free.take(Lettered(f"multiplier{k + 1}", quantity, k, real=True)))
    return tuple(symbols)


def expression(what: str, value: Given) -> Expr:
    """An expression of SymPy, or a number; of an equation the left side less the right.

    Raises RigidtopError.
    """
    if isinstance(value, Eq):
        value = value.lhs - value.rhs
    try:
        symbolic = sympy.sympify(value, strict=True)
    except (sympy.SympifyError, TypeError):
        symbolic = None
    if not isinstance(symbolic, Expr) or symbolic.is_Matrix:
        raise RigidtopError(f"{what} must be an expression of SymPy, not {in_one_line(value)}")
    if symbolic.has(sympy.nan, sympy.zoo, sympy.oo, -sympy.oo):
        raise RigidtopError(f"{what} must be finite, not {in_one_line(value)}")
    if symbolic.has(sympy.I):
        raise RigidtopError(f"{what} must be real, not {in_one_line(value)}")
    return symbolic


def several(values: Given) -> tuple[Any, ...]:
    """What is given, one after the other; itself alone where it is one thing, such as a text."""
    try:
        return (values,) if isinstance(values, (str, bytes)) else tuple(values)
    except TypeError:
        return (values,)


def mapping(complaint: str, value: Given) -> Mapping[Any, Any]:
    """What is given by name or symbol; nothing for None.  Raises RigidtopError for what is not."""
    value = {} if value is None else value
    if not isinstance(value, Mapping):
        raise RigidtopError(f"{complaint}, not {in_one_line(value)}")
    return value


def own_functions(expressions: Sequence[Expr]) -> Iterator[Expr]:
    """Functions of time and derivatives that are left: no coordinates, and no velocities."""
    for each in expressions:
        yield from sorted(each.atoms(Derivative, AppliedUndef), key=str)


ASSUMED = [
    "positive",
    "negative",
    "nonnegative",
    "nonpositive",
    "zero",
    "nonzero",
    "integer",
    "noninteger",
    "even",
    "odd",
    "prime",
    "composite",
    "real",
    "imaginary",
]
"""What SymPy may have used of a symbol."""


def numbers(letters: Sequence[Symbol], parameters: Given) -> dict[Expr, Expr]:
    """A number for each letter, which are given by symbol or by name, as they are written.

    Raises RigidtopError for one that is missing, unknown, or not what the symbol is assumed to be.
    """
    parameters = mapping("parameters are given as {symbol: number}", parameters)
    by_name = {x.name: x for x in letters}
    values: dict[str, Expr] = {}
    for key, value in parameters.items():
        name = str(getattr(key, "name", key))
        if name not in by_name:
            there = f"there are {', '.join(by_name)}" if by_name else "there are none"
            raise RigidtopError(f"no parameter {in_one_line(key)}: {there}")
        number = checks.number(name, value)
        as_assumed(by_name[name], number)
        values[name] = sympy.Float(repr(number), WRITTEN)
    missing = [name for name in by_name if name not in values]
    if missing:
        raise RigidtopError(f"no number for {', '.join(missing)}: give {{symbol: number}}")
    return {by_name[name]: values[name] for name in by_name}


def as_assumed(letter: Symbol, number: float) -> None:
    """Raises RigidtopError where a number is not what the symbol is assumed to be."""
    exact = sympy.Rational(repr(number))
    for wanted, verb in ((True, "must be"), (False, "must not be")):
        for word in (f"is_{each}" for each in ASSUMED):
            if getattr(letter, word) is wanted is not getattr(exact, word):
                raise RigidtopError(f"{letter.name} {verb} {word[3:]}, not {number:g}")


WRITTEN = 60
"""Digits to which a number counts as it is written: 0.1 is a tenth."""
