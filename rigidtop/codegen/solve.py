"""Linear equations solved line by line, as a program does it: nothing is ever multiplied out.

A symbolic inverse of an n × n matrix has of the order of n! terms; its elimination has n³/6 lines.
What comes out is a straight-line program: values, each in terms of those before it.  Where the
matrix is symmetric, so is the elimination (LDLᵀ), which halves the work; zeros cost nothing.

>>> a, b, c, f, g = sympy.symbols("a b c f g")
>>> made = solved(sympy.Matrix([[a, b], [b, c]]), [f, g], sympy.numbered_symbols("x"))
>>> for name, value in made.shared:
...     print(name, "=", value)
x0 = b/a
x1 = (-f*x0 + g)/(-b*x0 + c)
>>> made.results
(-x0*x1 + f/a, x1)
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import sympy
from sympy import Derivative, Expr, MatrixBase, Subs, Symbol
from sympy.core.function import AppliedUndef

from rigidtop.errors import RigidtopError

MOST_TERMS = 64
"""Terms of a sum on one line: Python's own compiler fails at sums of thousands."""


class SingularError(ValueError):
    """A matrix that is singular whatever its letters are."""


@dataclass(frozen=True)
class StraightLine:
    """Values that are computed one after the other, and the results in terms of them."""

    shared: tuple[tuple[Symbol, Expr], ...]
    results: tuple[Expr, ...]

    @property
    def operations(self) -> int:
        """Sums, products, powers, signs and calls."""
        return int(sympy.count_ops([*(value for _, value in self.shared), *self.results]))

    def written_out(self) -> tuple[Expr, ...]:
        """The results with everything put in."""
        values: dict[Symbol, Expr] = {}
        for name, value in self.shared:
            values[name] = value.xreplace(values)
        return tuple(result.xreplace(values) for result in self.results)


def solved(matrix: MatrixBase, right: Sequence[Expr], names: Iterator[Symbol]) -> StraightLine:
    """x of A x = b, for a matrix (n×n) and n right sides; `names` are free letters.

    Raises SingularError where the determinant vanishes identically, RigidtopError where the
    entries have no real values.
    """
    n = matrix.rows
    entries = [*matrix, *right]
    shared, reduced = sympy.cse(entries, symbols=names)
    shared, reduced = _with_signs(shared, reduced)
    numbers = _somewhere(shared, reduced)
    program = _Program(list(shared), names)
    a = {(i, j): program.named(reduced[i * n + j]) for i in range(n) for j in range(n)}
    b = [program.named(value) for value in reduced[n * n :]]
    at = {(i, j): numbers[i * n + j] for i in range(n) for j in range(n)}
    symmetric = all(matrix[i, j] == matrix[j, i] for i in range(n) for j in range(i))
    done: list[tuple[int, int]] = []
    rows, columns = set(range(n)), set(range(n))
    while rows:
        r, c = _pivot(a, at, rows, columns, symmetric)
        symmetric = symmetric and r == c
        rows.discard(r)
        columns.discard(c)
        done.append((r, c))
        for i in sorted(rows):
            if a[i, c] == 0:
                continue
            factor = program.named(a[i, c] / a[r, c])
            number = at[i, c] / at[r, c]
            for j in sorted(columns):
                if a[r, j] == 0 or (symmetric and j > i):
                    continue
                a[i, j] = program.named(a[i, j] - factor * a[r, j])
                at[i, j] -= number * at[r, j]
                if symmetric:
                    a[j, i], at[j, i] = a[i, j], at[i, j]
            b[i] = program.named(b[i] - factor * b[r])
    x: dict[int, Expr] = {}
    for r, c in reversed(done):
        # With what is left of the row divided once: b/d − Σ (a/d) x has the factors found above.
        rest = b[r] / a[r, c]
        for j in x:
            if a[r, j] != 0:
                rest -= program.named(a[r, j] / a[r, c]) * x[j]
        x[c] = program.named(rest)
    return trimmed(program.lines, [x[k] for k in range(n)])


def in_pieces(
    lines: Sequence[tuple[Symbol, Expr]], results: Sequence[Expr], names: Iterator[Symbol]
) -> tuple[list[tuple[Symbol, Expr]], list[Expr]]:
    """The same with sums and products of very many terms in several lines; `names` are free.

    >>> a = sympy.symbols("a:200")
    >>> lines, [total] = in_pieces([], [sympy.Add(*a)], sympy.numbered_symbols("x"))
    >>> len(lines), total
    (4, x0 + x1 + x2 + x3)
    """
    made: list[tuple[Symbol, Expr]] = []

    def is_long(value: Expr) -> bool:
        return len(value.args) > MOST_TERMS and (value.is_Add or value.is_Mul)

    def split(value: Expr) -> Expr:
        args = value.args
        while len(args) > MOST_TERMS:
            groups = [args[k : k + MOST_TERMS] for k in range(0, len(args), MOST_TERMS)]
            pieces = [(next(names), value.func(*group)) for group in groups]
            made.extend(pieces)
            args = tuple(name for name, _ in pieces)
        return value.func(*args)

    def broken(value: Expr) -> Expr:
        if any(map(is_long, sympy.preorder_traversal(value))):
            return value.replace(is_long, split)
        return value

    for name, value in lines:
        made.append((name, broken(value)))
    return made, list(map(broken, results))


@dataclass
class _Program:
    """Lines as they are written; what is no more than a letter or a number needs none."""

    lines: list[tuple[Symbol, Expr]]
    names: Iterator[Symbol]
    known: dict[Expr, Symbol] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.known.update((value, name) for name, value in self.lines)

    def named(self, value: Expr) -> Expr:
        if value.is_Atom or (value.is_Mul and len(value.args) == 2 and (-value).is_Atom):
            return value
        if value not in self.known:
            self.known[value] = next(self.names)
            self.lines.append((self.known[value], value))
        return self.known[value]


def _pivot(
    a: dict[tuple[int, int], Expr],
    at: dict[tuple[int, int], sympy.Float],
    rows: set[int],
    columns: set[int],
    symmetric: bool,
) -> tuple[int, int]:
    """The entry that is divided by: on the diagonal, where that can be; few others beside it."""
    scale = max(abs(at[i, j]) for i in rows for j in columns)

    def others(i: int, j: int) -> int:
        return int(sum(a[k, j] != 0 for k in rows) * sum(a[i, k] != 0 for k in columns))

    places = [(i, i) for i in sorted(rows)] if symmetric else []
    for group in (places, [(i, j) for i in sorted(rows) for j in sorted(columns)]):
        found = [p for p in group if a[p] != 0 and abs(at[p]) > scale * 1e-20]
        if found and scale > 0:
            return min(found, key=lambda p: (others(*p), not at[p] > 0, p))
    raise SingularError("the matrix is singular")


def _with_signs(
    shared: Sequence[tuple[Symbol, Expr]], entries: Sequence[Expr]
) -> tuple[list[tuple[Symbol, Expr]], list[Expr]]:
    """Without lines x = −y: a sign goes into the sum or the product where it is used."""
    signed: dict[Symbol, Expr] = {}
    kept = []
    for name, value in shared:
        put = value.xreplace(signed)
        if (-put).is_Symbol:
            signed[name] = put
        else:
            kept.append((name, put))
    return kept, [e.xreplace(signed) for e in entries]


TRIED = 60
"""Points at which numbers are looked for, where square roots and logarithms may have none."""


def points(letters: Sequence[Expr]) -> Iterator[dict[Expr, Expr]]:
    """Numbers without a relation between them, first all from a half to three halves."""
    first = {
        x: sympy.N(sympy.Rational(1, 2) + sympy.frac(sympy.sqrt(sympy.prime(k + 5))), 60)
        for k, x in enumerate(letters)
    }
    yield first
    rng = random.Random(1)
    for _ in range(TRIED):
        yield {
            x: value * (1 if x.is_positive or rng.random() < 0.5 else -1) * 4 ** rng.randint(-4, 4)
            for x, value in first.items()
        }


def _somewhere(shared: Sequence[tuple[Symbol, Expr]], entries: Sequence[Expr]) -> list[sympy.Float]:
    """The entries at a point, to many digits."""
    own = {name for name, _ in shared}
    expressions = [*(value for _, value in shared), *entries]
    letters = set().union(*(e.free_symbols for e in expressions)) - own
    # A function that is not known, and its derivatives, are letters too.
    letters |= set().union(*(e.atoms(AppliedUndef, Derivative, Subs) for e in expressions))
    for point in points(sorted(letters, key=str)):
        for name, value in shared:
            point[name] = sympy.N(value.xreplace(point), 60)
        values = [sympy.N(e.xreplace(point), 60) for e in entries]
        if all(value.is_comparable for value in values):
            return values
    raise RigidtopError(
        "no masses and forces in real numbers come of L, at none of the points that were tried"
    )


def trimmed(lines: Sequence[tuple[Symbol, Expr]], results: Sequence[Expr]) -> StraightLine:
    """Without what is used once, which is put in where it is used, and what is never used."""
    values = dict(lines)
    uses: dict[Symbol, int] = {}
    for expression in (*values.values(), *results):
        for x in _occurrences(expression, values):
            uses[x] = uses.get(x, 0) + 1
    kept: dict[Symbol, Expr] = {}
    inline: dict[Symbol, Expr] = {}
    for name, value in lines:
        put = value.xreplace(inline)
        if uses.get(name, 0) > 1:
            kept[name] = put
        else:
            inline[name] = put
    numbered = dict(zip(kept, values, strict=False))  # the names without gaps
    shared = [(numbered[name], value.xreplace(numbered)) for name, value in kept.items()]
    made = [result.xreplace(inline).xreplace(numbered) for result in results]
    return StraightLine(tuple(shared), tuple(made))


def _occurrences(expression: Expr, names: dict[Symbol, Expr]) -> Iterator[Symbol]:
    for node in sympy.preorder_traversal(expression):
        if node in names:
            yield node
