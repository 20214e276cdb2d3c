"""The surroundings of a point at which an equation holds: whether lines say as much as it does.

What is true need not be the equation that bears the number: 0 = 0 is true under every number.  Near
a point where the claim's equation holds let the meaning of each name in it vary on its own.  To
first order the equation then is a set of linear conditions on the variations, and so are the lines
of the file: they say as much if its conditions are among the combinations of theirs.
"""

from __future__ import annotations

import random
from collections.abc import Mapping
from typing import Any

import numpy as np
import sympy
from sympy import Eq, Expr, MatrixBase, Symbol

from rigidtop.proof.counterexample import assertions, entries
from rigidtop.proof.equation import Equation, Meaning, Underbrace, as_printed
from rigidtop.proof.page import Check
from rigidtop.theory.symbols import const, unit

_CLOSE = 1e-7


def among(rows: Any, others: Any) -> bool:
    """Whether each row is a combination of the others."""
    rows, others = scaled(rows), scaled(others)
    if not len(rows):
        return True
    if not len(others):
        return False
    weights = np.linalg.lstsq(others.T, rows.T, rcond=1e-10)[0]
    return bool(np.abs(others.T @ weights - rows.T).max() < _CLOSE)


def scaled(rows: Any) -> Any:
    """The rows that are not 0, each of length 1."""
    lengths = np.linalg.norm(rows, axis=1) if len(rows) else np.zeros(0)
    return rows[lengths > _CLOSE] / lengths[lengths > _CLOSE, None]


class Near:
    """The surroundings of a point at which a check's equation holds."""

    def __init__(self, check: Check) -> None:
        self._check = check
        self._equal = {
            a.condition.lhs: a.condition.rhs for a in check.assuming if isinstance(a.condition, Eq)
        }
        self._step = sympy.Dummy("step", real=True)
        self._names = sorted(_names(check), key=str)
        self._meanings = [m for name in self._names for m in self._varied(name)]
        self._point = self._found()
        # Braces explain; what a line has to say is in the chain.
        bare = Equation(*map(_bare, check.claimed.sides), relation=check.claimed.relation)
        self.own = self.conditions(bare)

    def conditions(self, equation: Equation) -> Any:
        """A row for each thing that the equation says to be 0: how fast it grows with each name."""
        columns = [self._rates(equation, meaning) for meaning in self._meanings]
        height = max((len(column) for column in columns if column), default=0)
        full = [column if len(column) == height else [0.0] * height for column in columns]
        return np.array(full).reshape(len(columns), height).T

    def _rates(self, equation: Equation, meaning: Meaning) -> list[float]:
        try:
            return [
                self._number(entry.diff(self._step).subs(self._step, 0))
                for _, left, right in assertions(equation, meaning)
                for entry in map(self._imposed, entries(left, right))
            ]
        except Exception:
            # An integral or a sum can't follow every variation: it then says nothing of it.
            return []

    def _imposed(self, expression: Expr) -> Expr:
        expression = sympy.sympify(expression)
        return expression.subs(self._equal).subs(self._equal)

    def _number(self, expression: Expr) -> float:
        values = {x: self._point.get(x) or _somewhere(x) for x in expression.free_symbols}
        return float(expression.xreplace(values).doit().evalf())

    def _varied(self, name: Expr) -> list[dict[Expr, Expr]]:
        """The meanings in which one number of a name varies; what stands for it follows."""
        check, step = self._check, self._step
        meant = check.meaning.get(name, name)
        made: list[dict[Expr, Expr]] = []
        if name == const:
            made.append({const: lambda left: meant(left) + step * left})
        elif callable(meant) and not isinstance(meant, sympy.Basic):
            made.append({name: lambda integrand: meant(integrand) * (1 + step)})
        elif isinstance(meant, (list, tuple)):
            for n, term in enumerate(meant):
                for x, old in term.items():
                    made += [
                        {name: [*meant[:n], {**term, x: new}, *meant[n + 1 :]]}
                        for new in _each_varied(old, step)
                    ]
        else:
            made += [{name: new} for new in _each_varied(meant, step)]
        if meant == name:
            return [{**self._following(name), **varied} for varied in made]
        return [{**check.meaning, **self._equals(), **varied} for varied in made]

    def _following(self, name: Expr) -> dict[Expr, Any]:
        """The meaning in which the names that are not in the equation vary with a symbol of it."""
        varied = {name: name + self._step}
        return {
            **{
                x: self._imposed(m).subs(varied)
                if x not in self._names and isinstance(m, (sympy.Basic, sympy.MatrixBase))
                else m
                for x, m in self._check.meaning.items()
            },
            **{x: sympy.sympify(m).subs(varied) for x, m in self._equals().items()},
        }

    def _equals(self) -> dict[Expr, Expr]:
        return {x: m for x, m in self._equal.items() if x not in self._check.meaning}

    def _found(self) -> dict[Expr, Expr]:
        """A point at which the assumptions hold and what is given vanishes."""
        check, rng = self._check, random.Random(5)
        given = [self._imposed(h) for h in check.given]
        conditions = [
            self._imposed(a.condition) for a in check.assuming if not isinstance(a.condition, Eq)
        ]
        symbols = set().union(*(e.free_symbols for e in (*given, *conditions)), set())
        point: dict[Expr, Expr] = {}
        for _ in range(60):
            point = {x: _somewhere(x, rng) for x in sorted(symbols, key=str)}
            for h in given:
                point |= _solved(h, point)
            if all(c.xreplace(point) == sympy.true for c in conditions if c != sympy.true):
                break
        return point


def _solved(vanishing: Expr, point: Mapping[Expr, Expr]) -> dict[Expr, Expr]:
    """A symbol with the value that makes an expression vanish."""
    for symbol in sorted(vanishing.free_symbols, key=str):
        if not vanishing.is_polynomial(symbol):
            continue
        others = {x: v for x, v in point.items() if x != symbol}
        roots = [r for r in sympy.solve(vanishing.xreplace(others), symbol) if r.is_real]
        if roots:
            return {symbol: max(roots)}
    return {}


def _somewhere(symbol: Expr, rng: random.Random | None = None) -> sympy.Float:
    """A number of no special kind; without a generator always the same one."""
    rng = rng if rng is not None else random.Random(str(symbol))
    sign = 1 if symbol.is_positive else rng.choice((1, 1, -1))
    return sympy.Float(sign * rng.uniform(0.4, 1.9))


def _each_varied(meant: Expr | MatrixBase, step: Symbol) -> list[Expr | MatrixBase]:
    """What is meant with one of its numbers varied."""
    if not isinstance(meant, sympy.MatrixBase):
        return [meant + step]
    made = []
    for k in range(len(meant)):
        new = meant.as_mutable()
        new[k] += step
        made.append(new)
    return made


def _names(check: Check) -> set[Expr]:
    """What stands for something in a check's equation, braces left out."""
    equal = {a.condition.lhs for a in check.assuming if isinstance(a.condition, Eq)}
    names: set[Expr] = set()

    def walk(node: Expr) -> None:
        if node in check.meaning or node.is_Symbol:
            names.add(node)
            return
        arguments = node.args[:1] if isinstance(node, Underbrace) else node.args
        for argument in arguments:
            walk(argument)

    for side in check.claimed.sides:
        for entry in side if isinstance(side, sympy.MatrixBase) else [side]:
            walk(entry)
    # A symbol that is assumed to be equal to another one varies with that.
    names |= {x for e in check.assuming if isinstance(e.condition, Eq) and e.condition.lhs in names
              for x in e.condition.rhs.free_symbols}  # fmt: skip
    return {x for x in names if x != unit and (x in check.meaning or x not in equal)}


def _bare(node: Expr) -> Expr:
    """An expression without what stands under its braces."""
    if isinstance(node, sympy.MatrixBase):
        return sympy.ImmutableMatrix(*node.shape, [_bare(entry) for entry in node])
    if isinstance(node, Underbrace):
        return _bare(node.args[0])
    if not node.has(Underbrace):
        return node
    with as_printed():
        return node.func(*map(_bare, node.args))
