"""Linear equations solved line by line, as a program does it: nothing is ever multiplied out.

A symbolic inverse of an n × n matrix has of the order of n! terms; its elimination has n³/6 lines.
Where the matrix is symmetric, so is the elimination (LDLᵀ), which halves the work; zeros cost
nothing.

>>> import sympy
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

from collections.abc import Iterator, Mapping, Sequence
from functools import partial
from itertools import tee

from sympy import Expr, MatrixBase, Symbol

from rigidtop.codegen.graph import Graph, somewhere
from rigidtop.codegen.lines import StraightLine, straight_line
from rigidtop.codegen.nodes import MINUS, ONE, ZERO, Value

NEGLIGIBLE = 1e-20
"""Part of the largest entry of a matrix up to which another is none."""


class SingularError(ValueError):
    """A matrix that is singular whatever its letters are."""


def solved(matrix: MatrixBase, right: Sequence[Expr], names: Iterator[Symbol]) -> StraightLine:
    """x of A x = b, for a matrix (n×n) and n right sides; `names` are free letters.

    Raises SingularError where the determinant vanishes identically, RigidtopError where the
    entries have no real values.
    """

    def program(graph: Graph, step: int, names: Iterator[Symbol]) -> StraightLine:
        rows = [[graph.expression(x) for x in matrix.row(i)] for i in range(matrix.rows)]
        column = [graph.expression(x) for x in right]
        solution = solutions(graph, [row[::step] for row in rows[::step]], column[::step])
        return straight_line(graph, solution[::step], names)

    # From the first, or from the last: neither is always shorter.
    programs = [
        somewhere([*matrix, *right], partial(program, step=step, names=own))
        for step, own in zip((1, -1), tee(names), strict=True)
    ]
    return min(programs, key=lambda each: each.operations)


def solutions(
    graph: Graph, matrix: Sequence[Sequence[Value]], right: Sequence[Value]
) -> list[Value]:
    """x of A x = b, line by line; LDLᵀ as long as the matrix is symmetric.

    Raises SingularError where the determinant vanishes identically.
    """
    a = {(i, j): graph.whole(x) for i, row in enumerate(matrix) for j, x in enumerate(row)}
    b = list(right)
    rows, columns = set(range(len(b))), set(range(len(b)))
    symmetric = all(x == a[j, i] for (i, j), x in a.items())
    done: list[tuple[int, int]] = []
    while rows:
        r, c = _pivot(graph, a, rows, columns, symmetric)
        symmetric = symmetric and r == c
        rows.discard(r)
        columns.discard(c)
        done.append((r, c))
        for i in sorted(rows):
            if a[i, c] == ZERO:
                continue
            factor = graph.product([a[i, c]], [a[r, c]])
            for j in sorted(columns):
                if a[r, j] == ZERO or (symmetric and j > i):
                    continue
                rest = graph.difference(a[i, j], graph.product([factor, a[r, j]]))
                a[i, j] = graph.whole(rest)
                if symmetric:
                    a[j, i] = a[i, j]
            b[i] = graph.difference(b[i], graph.product([factor, b[r]]))
    x: dict[int, Value] = {}
    for r, c in reversed(done):
        # With what is left of the row divided once: b/d − Σ (a/d) x has the factors found above.
        terms = [graph.product([b[r]], [a[r, c]])]
        for j, value in x.items():
            factor = graph.product([a[r, j]], [a[r, c]])
            terms.append(graph.product([MINUS, factor, value]))
        x[c] = graph.total(terms)
    return [x[k] for k in range(len(b))]


def ldl(graph: Graph, matrix: Sequence[Sequence[Value]]) -> tuple[list[Value], list[list[Value]]]:
    """D and L of A = L D Lᵀ: a quadratic form that is nowhere negative, as a sum of squares.

    Where an entry of D is none, the rest of its row is none either.
    """
    n = len(matrix)
    diagonal, lower = [ZERO] * n, [[ONE if i == j else ZERO for j in range(n)] for i in range(n)]
    for j in range(n):

        def rest(i: int, j: int = j) -> Value:
            own = (graph.product([lower[i][k], lower[j][k], diagonal[k]]) for k in range(j))
            return graph.difference(matrix[i][j], graph.total(own))

        diagonal[j] = rest(j)
        if diagonal[j] != ZERO:
            for i in range(j + 1, n):
                lower[i][j] = graph.product([rest(i)], [diagonal[j]])
    return diagonal, lower


def _pivot(
    graph: Graph,
    a: Mapping[tuple[int, int], Value],
    rows: set[int],
    columns: set[int],
    symmetric: bool,
) -> tuple[int, int]:
    """The entry that is divided by: on the diagonal, where that can be; few others beside it."""
    at = {(i, j): graph.number(a[i, j]) for i in rows for j in columns}
    scale = max(map(abs, at.values()))

    def others(i: int, j: int) -> int:
        return sum(a[k, j] != ZERO for k in rows) * sum(a[i, k] != ZERO for k in columns)

    places = [(i, i) for i in sorted(rows)] if symmetric else []
    for group in (places, [(i, j) for i in sorted(rows) for j in sorted(columns)]):
        candidates = [p for p in group if a[p] != ZERO and abs(at[p]) > scale * NEGLIGIBLE]
        if candidates:
            return min(candidates, key=lambda p: (others(*p), not at[p] > 0, p))
    raise SingularError("the matrix is singular")
