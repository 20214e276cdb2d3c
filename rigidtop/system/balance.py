"""M and f of M q̈ = f on a graph: of masses and bodies by d'Alembert, of a Lagrangian by Lagrange.

M is Σ JᵀIJ, of parts and of squares ½ I w² in a Lagrangian, with J = ∂w/∂q̇: no square is expanded.

Derivatives are forward ones, along coordinates, velocities and time; nothing is multiplied out.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property

import sympy
from sympy import Expr

from rigidtop.codegen.graph import Direction, Graph
from rigidtop.codegen.nodes import HALF, ONE, ZERO, Leaf, PowerNode, ProductNode, SumNode, Value
from rigidtop.codegen.nodes import parts as parts_of
from rigidtop.codegen.solve import SingularError, ldl, solutions
from rigidtop.system.directions import Column, Directions
from rigidtop.system.linkage import Tree
from rigidtop.system.parts import Body, Mass, Part
from rigidtop.system.recursion import Recursion


@dataclass(frozen=True)
class MovingComponent:
    """One component of what moves: its rate v with ∂v/∂q̇, its inertia, the force for q̈ = 0."""

    jacobian: Column
    rate: Value
    inertia: Value
    bias: Value
    slant: Column = ()
    """For each coordinate what Lagrange's equations have besides, where v is no rate of a place."""


@dataclass(frozen=True)
class Balanced:
    """M and f of M q̈ = f, with the constraints A q̈ = c."""

    graph: Graph
    mass: Sequence[Column]
    force: Column
    constraints: Sequence[Column]
    right: Column
    rules: Column
    """The constraints themselves."""
    speeds: Column
    """A q̇ + b, which the constraints let vanish."""
    acting: Column
    """Q − ∂ℱ/∂q̇."""
    lagrangian: Value
    momenta: Column
    """∂L/∂q̇."""
    energy: Value
    """Jacobi's integral Σ p q̇ − L."""
    power: Value
    """The rate of the energy, Q·q̇ − ∂L/∂t − λ·b, with the letters of the multipliers."""

    @cached_property
    def solution(self) -> list[Value]:
        """q̈, and the multipliers with the sign that leaves the matrix symmetric: −λ.

        Raises SingularError.
        """
        lines = [[*line, *(A[i] for A in self.constraints)] for i, line in enumerate(self.mass)]
        lines += [[*A, *(ZERO for _ in self.constraints)] for A in self.constraints]
        return solutions(self.graph, lines, [*self.force, *self.right])

    def why_singular(self, qdot: Iterable[Expr]) -> str:
        """What is amiss where there is no solution, in one line."""
        for v, column in zip(qdot, self.mass, strict=True):
            if all(x == ZERO for x in column):
                return f"the mass matrix is singular: L is not quadratic in {v}"
        with suppress(SingularError):
            solutions(self.graph, self.mass, self.force)
            return "the constraints depend on one another: leave one out"
        return (
            "the mass matrix is singular: some combination of the velocities does not enter L, "
            "or enters it only linearly"
        )

    def by_place(self, x: Expr) -> Value:
        """The derivative ∂L/∂q by a coordinate."""
        return self.graph.derivative(self.lagrangian, Direction({x: ONE}))

    def gradients(self, values: Iterable[Value], letters: Iterable[Expr]) -> list[list[Value]]:
        """The derivatives of each value by the letters, a row for each value."""
        directions = [Direction({x: ONE}) for x in letters]
        return [[self.graph.derivative(x, along) for along in directions] for x in values]

    @property
    def leaves(self) -> list[Expr]:
        """The letters that occur in L, the forces or the masses."""
        values = (self.lagrangian, *self.force, *(x for row in self.mass for x in row))
        nodes = (self.graph.nodes[k] for k in self.graph.below(values))
        return [node.expression for node in nodes if isinstance(node, Leaf)]


@dataclass(frozen=True)
class Balance(Directions):
    """The equations of a system on a graph."""

    def products(self, triples: Iterable[tuple[Value, Value, Value]]) -> Value:
        """Σ abc, by a, then by b: what is in all masses goes out."""
        graph = self.graph
        grouped: dict[Value, dict[Value, list[Value]]] = {}
        for a, b, c in triples:
            if ZERO not in (a, b, c):
                grouped.setdefault(a, {}).setdefault(b, []).append(c)
        return graph.total(
            graph.product(
                [a, graph.total(graph.product([b, graph.total(cs)]) for b, cs in inner.items())]
            )
            for a, inner in grouped.items()
        )

    # --- the two ways -----------------------------------------------------------------------------

    def of_parts(self) -> Balanced:
        """The balance by d'Alembert's principle for the parts, by Lagrange for the rest of L."""
        return self.balanced(self.system.names.plain(self.system.rest), self.system.parts)

    def of_lagrangian(self) -> Balanced:
        """The balance by Lagrange's equations for all of L."""
        return self.balanced(self.system.plain, ())

    def balanced(self, rest: Expr, parts: Sequence[Part]) -> Balanced:
        """What a Lagrangian gives besides parts; its squares ½ I w² are as theirs.

        (∂²L/∂q̇∂q̇) q̈ = ∂L/∂q + Q − what ∂L/∂q̇ changes by without q̈, and of the parts
        Σ ((∂v/∂q̇)ᵀ(m v̇) + (∂ω/∂q̇)ᵀ(Iω̇ + ω × Iω)).
        """
        graph, n = self.graph, len(self.velocities)
        L = graph.expression(rest)
        shares = [Recursion(self, part).share() for part in parts if isinstance(part, Tree)]
        rows = [row for part in parts if isinstance(part, (Mass, Body)) for row in self.rows(part)]
        kinetic = [graph.product([HALF, row.inertia, row.rate, row.rate]) for row in rows]
        squares, left = self.squares(L)
        rows += [self.square(inertia, rate) for inertia, rate in squares]
        slopes, pushes = (
            self.slopes(left, each) for each in (self.along_places, self.along_velocities)
        )

        def mass(i: int, j: int) -> Value:
            own = self.products((row.jacobian[i], row.jacobian[j], row.inertia) for row in rows)
            more = graph.derivative(pushes[i], self.along_velocities[j])
            return graph.total([own, more, *(share.mass[i][j] for share in shares)])

        # From the last, which moves least: its sums are parts of those before.
        lower = {(i, j): mass(i, j) for i in reversed(range(n)) for j in range(i + 1)}
        force = {
            i: graph.total(
                [
                    self.acting[i],
                    slopes[i],
                    self.less(self.rate(pushes[i])),
                    self.less(self.products((row.jacobian[i], ONE, row.bias) for row in rows)),
                    *(self.less(row.slant[i]) for row in rows if row.slant),
                    *(self.less(share.bias[i]) for share in shares),
                ]
            )
            for i in reversed(range(n))
        }
        lagrangian = graph.total([L, *kinetic, *(share.lagrangian for share in shares)])
        rules, A, right, speeds = self.held()
        momenta = [
            graph.total(
                [
                    p,
                    *(graph.product([row.jacobian[i], self.push(row)]) for row in rows),
                    *(share.momenta[i] for share in shares),
                ]
            )
            for i, p in enumerate(pushes)
        ]
        return Balanced(
            graph,
            [[lower[max(i, j), min(i, j)] for j in range(n)] for i in range(n)],
            [force[i] for i in range(n)],
            A,
            right,
            rules,
            speeds,
            self.acting,
            lagrangian,
            momenta,
            graph.total([self.energy(rows, left, pushes), *(share.energy for share in shares)]),
            self.power(lagrangian, A, speeds),
        )

    def push(self, row: MovingComponent) -> Value:
        """The momentum I w of a component."""
        return self.graph.product([row.inertia, row.rate])

    def energy(self, rows: Iterable[MovingComponent], left: Value, pushes: Column) -> Value:
        """Jacobi's integral: of each square ½ I w² it is I w (J·q̇ − w/2), of a rest p·q̇ less it."""
        graph = self.graph
        terms = [self.less(left), self.along(pushes)]
        for row in rows:
            push = self.push(row)
            terms.append(graph.product([push, self.along(row.jacobian)]))
            terms.append(self.less(graph.product([HALF, push, row.rate])))
        return graph.total(terms)

    def along(self, column: Column) -> Value:
        """The scalar product of a column with q̇."""
        return self.graph.total(map(self.graph.product, zip(column, self.velocities, strict=True)))

    def power(self, lagrangian: Value, A: Sequence[Column], speeds: Column) -> Value:
        """What the energy changes by: the work of forces, of moved constraints, and of L itself."""
        graph = self.graph
        moved = [
            graph.product([graph.expression(x), graph.difference(self.along(row), speed)])
            for x, row, speed in zip(self.system.multipliers, A, speeds, strict=True)
        ]
        by_time = graph.derivative(lagrangian, Direction({self.system.names.t: ONE}))
        return graph.total([self.along(self.acting), *moved, self.less(by_time)])

    @cached_property
    def acting(self) -> list[Value]:
        """The forces Q − ∂ℱ/∂q̇ on the n coordinates."""
        names = self.system.names
        dissipation = self.graph.expression(names.plain(self.system.rayleigh))
        lost = self.slopes(dissipation, self.along_velocities)
        return [
            self.graph.total([self.graph.expression(names.plain(Q)), self.less(F)])
            for Q, F in zip(self.system.forces, lost, strict=True)
        ]

    def held(self) -> tuple[list[Value], list[list[Value]], list[Value], list[Value]]:
        """The constraints, A and c of A q̈ = c, A q̇ + b: derived by time until they are so."""
        rules = list(map(self.graph.expression, self.system.rules))
        speeds = [
            self.rate(value) if of_places else value
            for value, of_places in zip(rules, self.system.holonomic, strict=True)
        ]
        rows = [self.slopes(value, self.along_velocities) for value in speeds]
        return rules, rows, [self.less(self.rate(value)) for value in speeds], speeds

    def frames(self) -> Iterator[Value]:
        """The place (3) of each mass and body, then its attitude row by row (9), in space."""
        plain, value = self.system.names.plain, self.graph.expression
        for part in self.system.parts:
            if isinstance(part, Tree):
                for place, rows in Recursion(self, part).frames():
                    yield from (*place, *(x for row in rows for x in row))
            elif isinstance(part, (Mass, Body)):
                attitude = part.attitude if isinstance(part, Body) else sympy.eye(3)
                yield from map(value, (*plain(part.place), *plain(attitude)))

    # --- squares ---------------------------------------------------------------------------------

    def moves(self, value: Value) -> bool:
        """Whether a value depends on velocities."""
        return any(x != ZERO for x in self.slopes(value, self.along_velocities))

    def squares(self, value: Value) -> tuple[list[tuple[Value, Value]], Value]:
        """I and w of the terms ½ I w² of a value, and the rest: w is linear in q̇, and I has none.

        Each node is met once, with all that stands in front of it.
        """
        graph = self.graph
        squares: list[tuple[Value, Value]] = []
        rest: list[Value] = []
        fronts: dict[int, list[Value]] = {value[1]: [(value[0], 0)]}
        for k in reversed(graph.below([value])):
            if k not in fronts:
                continue
            node, front = graph.nodes[k], graph.total(fronts[k])
            moving = [j for j in parts_of(node) if self.moves((1, j))]
            if isinstance(node, SumNode) and moving:
                for c, j in node.terms:
                    fronts.setdefault(j, []).append(graph.product([front, (c, 0)]))
            elif isinstance(node, ProductNode) and len(moving) == 1 and moving[0] in node.above:
                [j] = moving
                others = [(1, i) for i in node.above if i != j]
                below = [(1, i) for i in node.below]
                fronts.setdefault(j, []).append(graph.product([front, *others], below))
            elif isinstance(node, PowerNode) and node.exponent == 2 and self.is_linear(node.base):
                squares.append((graph.product([front, (2, 0)]), node.base))
            else:
                rest.append(graph.product([front, (1, k)]))
        return squares, graph.total(rest)

    def is_linear(self, value: Value) -> bool:
        """Whether a value is linear in the velocities, and has some."""
        slopes = self.slopes(value, self.along_velocities)
        return self.moves(value) and not any(map(self.moves, slopes))

    def square(self, inertia: Value, rate: Value) -> MovingComponent:
        """½ I w² by Lagrange: I w ∂w/∂q̇ derived by time, less the slopes of both by places.

        Of a place's rate w nothing but I ẇ ∂w/∂q̇ is left, and the graph sees it.
        """
        graph = self.graph
        jacobian = self.slopes(rate, self.along_velocities)
        push = graph.product([inertia, rate])
        turned, changed = (self.slopes(x, self.along_places) for x in (rate, inertia))
        slant = [
            graph.total(
                [
                    graph.product([push, graph.difference(self.rate(J), by_place)]),
                    graph.product([(Fraction(-1, 2), 0), change, rate, rate]),
                ]
            )
            for J, by_place, change in zip(jacobian, turned, changed, strict=True)
        ]
        return MovingComponent(jacobian, rate, inertia, self.rate(push), slant)

    # --- masses and bodies ------------------------------------------------------------------------

    def rows(self, part: Mass | Body) -> Iterator[MovingComponent]:
        """The components of a part: of its centre of mass, and of the turning about it."""
        graph, names = self.graph, self.system.names
        mass = graph.expression(names.plain(part.mass))
        if mass != ZERO:
            for x in names.plain(part.place):
                place = graph.expression(x)
                rate = self.rate(place)
                bias = graph.product([mass, self.rate(rate)])
                yield MovingComponent(self.slopes(place, self.along_places), rate, mass, bias)
        if isinstance(part, Body):
            yield from self.turning(part)

    def turning(self, body: Body) -> list[MovingComponent]:
        """Iω̇ + ω × Iω, with ω from RᵀṘ = hat(ω), along the axes in which ω·Iω is three squares."""
        graph, names = self.graph, self.system.names
        attitude, inertia = names.plain(body.attitude), names.plain(body.inertia)
        R = [[graph.expression(x) for x in attitude.row(k)] for k in range(3)]
        tensor = [[graph.expression(x) for x in inertia.row(k)] for k in range(3)]

        def spin(direction: Direction) -> list[Value]:
            rates = [[graph.derivative(x, direction) for x in row] for row in R]
            return [
                graph.total(graph.product([R[k][i], rates[k][j]]) for k in range(3))
                for i, j in ((2, 1), (0, 2), (1, 0))
            ]

        columns = [spin(each) for each in self.along_places]
        omega = [
            graph.total([x, *map(graph.product, zip(row, self.velocities, strict=True))])
            for x, row in zip(
                spin(Direction({names.t: ONE})), zip(*columns, strict=True), strict=True
            )
        ]
        biases = self.gyration(tensor, omega, [self.rate(w) for w in omega])
        diagonal, lower = ldl(graph, tensor)
        components = []
        for k, inertia in enumerate(diagonal):
            # The rows of Lᵀ turn ω into what is squared; L⁻¹ turns the torque into what drives it.
            along = [(lower[i][k], i) for i in range(k, 3)]
            jacobian = [
                graph.total(graph.product([x, column[i]]) for x, i in along) for column in columns
            ]
            rate = graph.total(graph.product([x, omega[i]]) for x, i in along)
            components.append(MovingComponent(jacobian, rate, inertia, biases[k]))
            for i in range(k + 1, 3):
                biases[i] = graph.difference(biases[i], graph.product([lower[i][k], biases[k]]))
        return components
