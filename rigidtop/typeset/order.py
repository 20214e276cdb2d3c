"""The order of mechanics: of the factors of a product, of the terms of a sum."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy
from sympy import Add, Expr, Mul, Pow, Symbol

from rigidtop.theory.lettered import Lettered, known, stands_for
from rigidtop.typeset.nodes import glyph

_RATE_WEIGHT = {"rad/s": 1, "1/s": 1, "rad/s²": 2, "rad/s³": 3, "J s": 1}
_ACCENT_WEIGHT = {"dot": 1, "ddot": 2}
_FUNCTIONS = ("sin", "cos", "tan")
_NUMBER, _PARAMETER, _PARAMETER_SUM, _MOMENTUM, _SUM, _RATE, _ANGLE, _FUNCTION, _REST, _VECTOR = (
    range(10)
)
_Key = tuple[Any, ...]


def _weight(symbol: Symbol) -> int:
    """How many inverse seconds a symbol brings to a term."""
    symbol = stands_for(symbol)
    _, quantity = known(symbol)
    if isinstance(symbol, Lettered):  # a velocity may be in m/s as well
        by_accent = _ACCENT_WEIGHT.get(symbol.quantity.glyph.accent, 0)
        return _RATE_WEIGHT.get(symbol.quantity.unit, by_accent)
    if quantity is not None:
        return _RATE_WEIGHT.get(quantity.unit, 0)
    return _ACCENT_WEIGHT.get(glyph(symbol.name).accent, 0)


def _symbol_key(symbol: Symbol) -> _Key:
    symbol = stands_for(symbol)
    position, quantity = known(symbol)
    sign = glyph(symbol.name) if quantity is None else quantity.glyph
    if sign.bold:
        kind = _VECTOR
    elif quantity is not None and quantity.unit in ("J s", "kg m/s"):
        kind = _MOMENTUM
    elif _weight(symbol):
        kind = _RATE
    elif quantity is not None and quantity.unit in ("rad", "s"):
        kind = _ANGLE
    elif isinstance(symbol, Lettered) and not symbol.is_positive:
        kind = _ANGLE  # a coordinate in m
    else:
        kind = _PARAMETER
    return kind, position, symbol.name


def factor_key(factor: Expr) -> _Key:
    base = factor.base if isinstance(factor, Pow) else factor
    if base.is_number:
        return _NUMBER, 0 if base.is_Rational else 1, str(base)
    if isinstance(base, Symbol):
        return _symbol_key(base)
    symbols = sorted(base.free_symbols, key=_symbol_key)
    if isinstance(base, (Add, Mul)):  # a product only beneath a root
        if all(_symbol_key(symbol)[0] == _PARAMETER for symbol in symbols):
            return _PARAMETER_SUM, _symbol_key(symbols[0])[1], str(base)
        moves = any(_weight(symbol) for symbol in symbols)
        return _SUM if moves else _REST, _symbol_key(symbols[0])[1], str(base)
    name = type(base).__name__
    if name in _FUNCTIONS and len(symbols) >= 1:
        return _FUNCTION, _symbol_key(symbols[0])[1], _FUNCTIONS.index(name), str(base)
    return _REST, 0, str(base)


def _degree(factor: Expr) -> float:
    if isinstance(factor, Symbol):
        return _weight(factor)
    if isinstance(factor, Pow) and factor.exp.is_number:
        return float(factor.exp) * _degree(factor.base)
    if isinstance(factor, Mul):
        return sum(_degree(part) for part in factor.args)
    if isinstance(factor, Add):
        return max(_degree(part) for part in factor.args)
    return 0


def _term_key(term: Expr) -> _Key:
    """Many rates first; then by parameters; then as the glossary has the rates.

    Terms of first degree with a bare rate stand before those with functions: ψ̇ + φ̇ cos θ.
    """
    degree = _degree(term)
    root = any(isinstance(f, Pow) and not f.exp.is_integer and f.base.is_Add for f in term.args)
    keys = sorted(factor_key(factor) for factor in Mul.make_args(term))
    symbols = sorted(map(_symbol_key, term.free_symbols))
    parameters = tuple(key[1:] for key in symbols if key[0] == _PARAMETER)
    functions = sum(key[0] == _FUNCTION for key in keys)
    return (
        -degree,
        root,
        parameters,
        functions if degree == 1 else 0,
        [(key[0], key[1]) for key in keys if key[0] not in (_NUMBER, _PARAMETER)],
        str(term),
    )


def ordered_terms(terms: Sequence[Expr]) -> list[Expr]:
    return sorted(terms, key=_term_key)


def with_one_root(factors: Sequence[Expr]) -> list[Expr]:
    """√a √b as √(ab), above and below the bar."""
    rest = list(factors)
    for power in (sympy.S.Half, -sympy.S.Half):
        roots = [f for f in rest if isinstance(f, Pow) and f.exp == power]
        if len(roots) > 1:
            rest = [f for f in rest if f not in roots]
            rest.append(Pow(Mul(*(root.base for root in roots)), power, evaluate=False))
    return rest
