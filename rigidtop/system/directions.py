"""Directions in the graph of a system: along coordinates, velocities and the motion."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

from sympy import Expr

from rigidtop.codegen.graph import Direction, Graph
from rigidtop.codegen.nodes import MINUS, ONE, Value
from rigidtop.system.names import PlainSymbols
from rigidtop.system.parts import Part

Column = Sequence[Value]
"""Values of a vector: its components, or one for each coordinate."""


class Given(Protocol):
    """What is known of a system before anything is derived, in its plain symbols inside."""

    @property
    def names(self) -> PlainSymbols: ...
    @property
    def rest(self) -> Expr: ...
    @property
    def parts(self) -> tuple[Part, ...]: ...
    @property
    def forces(self) -> tuple[Expr, ...]: ...
    @property
    def rayleigh(self) -> Expr: ...
    @property
    def plain(self) -> Expr: ...
    @property
    def multipliers(self) -> tuple[Expr, ...]: ...
    @property
    def rules(self) -> tuple[Expr, ...]: ...
    @property
    def holonomic(self) -> tuple[bool, ...]: ...


@dataclass(frozen=True)
class Directions:
    """The graph of a system, and directions in it."""

    system: Given
    graph: Graph

    @cached_property
    def velocities(self) -> list[Value]:
        """The velocities q̇ as values of the graph."""
        return [self.graph.expression(v) for v in self.system.names.v]

    @cached_property
    def motion(self) -> Direction:
        """The direction in which a motion without accelerations goes."""
        names = self.system.names
        return Direction({**dict(zip(names.q, self.velocities, strict=True)), names.t: ONE})

    @cached_property
    def along_places(self) -> list[Direction]:
        """The directions of ∂/∂q, one for each coordinate."""
        return [Direction({x: ONE}) for x in self.system.names.q]

    @cached_property
    def along_velocities(self) -> list[Direction]:
        """The directions of ∂/∂q̇, one for each velocity."""
        return [Direction({v: ONE}) for v in self.system.names.v]

    def rate(self, value: Value) -> Value:
        """The rate d/dt of a value, with all accelerations q̈ = 0."""
        return self.graph.derivative(value, self.motion)

    def slopes(self, value: Value, directions: Sequence[Direction]) -> list[Value]:
        """The derivatives of a value along the directions, one for each."""
        return [self.graph.derivative(value, each) for each in directions]

    def less(self, value: Value) -> Value:
        """The value with the opposite sign."""
        return self.graph.product([MINUS, value])

    def gyration(
        self, tensor: Sequence[Column], omega: Sequence[Value], rates: Sequence[Value]
    ) -> list[Value]:
        """Iω̇ + ω × Iω for rates ω̇: of the moments the differences stand together."""
        graph = self.graph
        tilted = [
            graph.total(graph.product([tensor[i][j], omega[j]]) for j in range(3) if j != i)
            for i in range(3)
        ]
        components = []
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            moments = graph.difference(tensor[k][k], tensor[j][j])
            components.append(
                graph.total(
                    [
                        *(graph.product([tensor[i][m], rates[m]]) for m in range(3)),
                        graph.product([moments, omega[j], omega[k]]),
                        graph.product([omega[j], tilted[k]]),
                        self.less(graph.product([omega[k], tilted[j]])),
                    ]
                )
            )
        return components
