"""M and f of M q̈ = f on a graph: of masses and bodies by d'Alembert, of a Lagrangian by Lagrange.

Derivatives are forward ones, along coordinates, velocities and time; nothing is multiplied out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import sympy

from rigidtop.codegen.graph import ONE, ZERO, Direction, Graph, Value
from rigidtop.codegen.solve import solutions
from rigidtop.system.parts import Body, Part

if TYPE_CHECKING:
    from rigidtop.system.derived import Derived

Column = Sequence[Value]
"""Values of a vector: its components, or one for each coordinate."""


@dataclass(frozen=True)
class Inertia:
    """What moves, as rows with an inertia each: ∂v/∂q̇, and the force that q̈ = 0 needs."""

    jacobian: Sequence[Column]
    inertia: Column
    bias: Column


@dataclass(frozen=True)
class Balance:
    """The graph of a system, and directions in it."""

    system: Derived
    graph: Graph

    @cached_property
    def velocities(self) -> list[Value]:
        """q̇."""
        return [self.graph.expression(v) for v in self.system.names.v]

    @cached_property
    def motion(self) -> Direction:
        """The direction in which a motion without accelerations goes."""
        names = self.system.names
        return Direction({**dict(zip(names.q, self.velocities, strict=True)), names.t: ONE})

    @cached_property
    def along_places(self) -> list[Direction]:
        """∂/∂q."""
        return [Direction({x: ONE}) for x in self.system.names.q]

    @cached_property
    def along_velocities(self) -> list[Direction]:
        """∂/∂q̇."""
        return [Direction({v: ONE}) for v in self.system.names.v]

    def rate(self, value: Value) -> Value:
        """d/dt, where q̈ = 0."""
        return self.graph.derivative(value, self.motion)

    def slopes(self, value: Value, directions: Sequence[Direction]) -> list[Value]:
        """A derivative for each direction."""
        return [self.graph.derivative(value, each) for each in directions]

    def less(self, value: Value) -> Value:
        """−x."""
        return self.graph.product([(sympy.S.NegativeOne, 0), value])

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

    def of_parts(self) -> tuple[list[list[Value]], list[Value]]:
        """Σ ((∂v/∂q̇)ᵀ(m v̇) + (∂ω/∂q̇)ᵀ(λω̇ + ω × λω)) = Q − ∂V/∂q: d'Alembert's principle."""
        n = len(self.velocities)
        moved = [each for part in self.system.parts for each in self.inertias(part)]
        rows = [row for each in moved for row in zip(each.jacobian, each.inertia, strict=True)]
        forces = [(J, b) for each in moved for J, b in zip(each.jacobian, each.bias, strict=True)]
        mass = self.symmetric(lambda i, j: self.products((J[i], J[j], m) for J, m in rows), n)
        potential = self.graph.expression(self.system.names.plain(self.system.potential))
        slopes = self.slopes(potential, self.along_places)
        inert = {
            i: self.products((J[i], ONE, b) for J, b in reversed(forces))
            for i in reversed(range(n))  # what is last moves least, and is part of what is before
        }
        return mass, [
            self.graph.total([Q, self.less(slopes[i]), self.less(inert[i])])
            for i, Q in enumerate(self.acting)
        ]

    def symmetric(self, entry: Callable[[int, int], Value], n: int) -> list[list[Value]]:
        """A matrix by its entries on the diagonal and below."""
        lower = {(i, j): entry(i, j) for i in reversed(range(n)) for j in range(i + 1)}
        return [[lower[max(i, j), min(i, j)] for j in range(n)] for i in range(n)]

    def of_lagrangian(self) -> tuple[list[list[Value]], list[Value]]:
        """(∂²L/∂q̇∂q̇) q̈ = ∂L/∂q + Q − what ∂L/∂q̇ changes by without q̈: Lagrange's equations."""
        L = self.graph.expression(self.system.plain)
        momenta = self.slopes(L, self.along_velocities)
        mass = self.symmetric(
            lambda i, j: self.graph.derivative(momenta[i], self.along_velocities[j]), len(momenta)
        )
        return mass, [
            self.graph.total([Q, slope, self.less(self.rate(p))])
            for Q, slope, p in zip(
                self.acting, self.slopes(L, self.along_places), momenta, strict=True
            )
        ]

    @property
    def acting(self) -> list[Value]:
        """Q − ∂ℱ/∂q̇."""
        names = self.system.names
        dissipation = self.graph.expression(names.plain(self.system.rayleigh))
        lost = self.slopes(dissipation, self.along_velocities)
        return [
            self.graph.difference(self.graph.expression(names.plain(Q)), F)
            for Q, F in zip(self.system.forces, lost, strict=True)
        ]

    def held(self) -> tuple[list[list[Value]], list[Value]]:
        """A and c of A q̈ = c: the constraints, derived by time until they have accelerations."""
        rows, right = [], []
        for rule, of_places in zip(self.system.rules, self.system.holonomic, strict=True):
            value = self.graph.expression(rule)
            if of_places:
                value = self.rate(value)
            rows.append(self.slopes(value, self.along_velocities))
            right.append(self.less(self.rate(value)))
        return rows, right

    def solved(self, mass: list[list[Value]], force: list[Value]) -> list[Value]:
        """q̈, and multipliers with the sign of the unknowns that leave the matrix symmetric: −λ."""
        rows, right = self.held()
        lines = [[*line, *(A[i] for A in rows)] for i, line in enumerate(mass)]
        lines += [[*A, *(ZERO for _ in rows)] for A in rows]
        return solutions(self.graph, lines, [*force, *right])

    # --- masses and bodies ------------------------------------------------------------------------

    def inertias(self, part: Part) -> list[Inertia]:
        """Of the centre of mass, and of the turning about it."""
        graph, names = self.graph, self.system.names
        mass = graph.expression(names.plain(part.mass))
        made = []
        if mass != ZERO:
            place = [graph.expression(x) for x in names.plain(part.place)]
            jacobian = [self.slopes(x, self.along_places) for x in place]
            bias = [graph.product([mass, self.rate(self.rate(x))]) for x in place]
            made.append(Inertia(jacobian, [mass] * 3, bias))
        if isinstance(part, Body):
            made.append(self.turning(part))
        return made

    def turning(self, body: Body) -> Inertia:
        """λω̇ + ω × λω, with ω from RᵀṘ = hat(ω)."""
        graph, names = self.graph, self.system.names
        attitude = names.plain(body.attitude)
        R = [[graph.expression(x) for x in attitude.row(k)] for k in range(3)]
        moments = [graph.expression(names.plain(x)) for x in body.moments]

        def spin(rates: Sequence[Column]) -> list[Value]:
            return [
                graph.total(graph.product([R[k][i], rates[k][j]]) for k in range(3))
                for i, j in ((2, 1), (0, 2), (1, 0))
            ]

        by_places = [
            spin([[graph.derivative(x, each) for x in row] for row in R])
            for each in self.along_places
        ]
        jacobian = [list(row) for row in zip(*by_places, strict=True)]
        own = spin([[graph.derivative(x, Direction({names.t: ONE})) for x in row] for row in R])
        omega = [
            graph.total(
                [
                    own[k],
                    *(graph.product([J, v]) for J, v in zip(row, self.velocities, strict=True)),
                ]
            )
            for k, row in enumerate(jacobian)
        ]
        momentum = [graph.product([x, w]) for x, w in zip(moments, omega, strict=True)]
        bias = []
        for i, (x, w) in enumerate(zip(moments, omega, strict=True)):
            j, k = (i + 1) % 3, (i + 2) % 3
            turned = graph.difference(
                graph.product([omega[j], momentum[k]]), graph.product([omega[k], momentum[j]])
            )
            bias.append(graph.total([graph.product([x, self.rate(w)]), turned]))
        return Inertia(jacobian, moments, bias)
