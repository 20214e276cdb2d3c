"""A mechanism's share of M q̈ = f, by recursion from link to link on the graph.

Velocities and accelerations go outward, forces and composite bodies come back, all in the axes of
the links: Newton and Euler for q̈ = 0, and the mass matrix by what a unit acceleration of each joint
takes (Featherstone, Rigid Body Dynamics Algorithms, 2008, chapters 5 and 6).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property

import sympy
from sympy import MatrixBase

from rigidtop.codegen.graph import Graph
from rigidtop.codegen.nodes import HALF, MINUS, ONE, ZERO, Value
from rigidtop.system.directions import Directions
from rigidtop.system.linkage import FIXED, PRISMATIC, REVOLUTE, Joint, Link, Tree

Vector = Sequence[Value]
"""Three components."""


@dataclass(frozen=True)
class Share:
    """What a part of a system adds to M, to what M q̈ equals with the other sign, to L and so on."""

    mass: Sequence[Vector]
    bias: Vector
    lagrangian: Value
    momenta: Vector
    energy: Value


@dataclass(frozen=True)
class Composite:
    """A link with all that hangs on it: its mass, m c and the inertia about its origin."""

    mass: Value
    moment: Vector
    inertia: Sequence[Vector]


@dataclass(frozen=True)
class Vectors:
    """Sums and products of vectors on a graph."""

    graph: Graph

    def plus(self, *vectors: Vector) -> Vector:
        """The sum of two or more vectors."""
        return [self.graph.total(row) for row in zip(*vectors, strict=True)]

    def times(self, factor: Value, vector: Vector) -> Vector:
        """The vector multiplied by a factor."""
        return [self.graph.product([factor, x]) for x in vector]

    def dot(self, one: Vector, other: Vector) -> Value:
        """The scalar product of two vectors."""
        return self.graph.total(map(self.graph.product, zip(one, other, strict=True)))

    def cross(self, one: Vector, other: Vector) -> Vector:
        """The vector product of two vectors."""
        product, difference = self.graph.product, self.graph.difference
        return [
            difference(product([one[i], other[j]]), product([one[j], other[i]]))
            for i, j in ((1, 2), (2, 0), (0, 1))
        ]

    def of(self, rows: Sequence[Vector], vector: Vector) -> Vector:
        """The product of a matrix, row by row, and a vector."""
        return [self.dot(row, vector) for row in rows]

    def steiner(self, mass: Value, arm: Vector, moment: Vector) -> Sequence[Vector]:
        """What an inertia (3×3) gets besides where its body is moved by an arm.

        It is that about the origin before, at which the body has m c.
        """
        graph = self.graph
        double = self.plus(moment, moment, self.times(mass, arm))
        size = self.dot(arm, double)

        def entry(i: int, j: int) -> Value:
            own = graph.product([arm[i], graph.total([moment[j], graph.product([mass, arm[j]])])])
            taken = graph.total([own, graph.product([moment[i], arm[j]])])
            return graph.difference(size if i == j else ZERO, taken)

        lower = {(i, j): entry(i, j) for i in range(3) for j in range(i + 1)}
        return [[lower[max(i, j), min(i, j)] for j in range(3)] for i in range(3)]


@dataclass(frozen=True)
class Hinge:
    """A joint on the graph, which turns vectors of its child into those of its parent, and back."""

    vectors: Vectors
    kind: str
    axis: Vector
    attitude: Sequence[Vector]
    arm: Vector
    """From the origin of the parent to that of the child, in the axes of the parent."""

    cosine: Value
    sine: Value

    def inward(self, vector: Vector) -> Vector:
        """A vector of the child in the axes of the parent."""
        return self.vectors.of(self.attitude, self._turned(vector, self.sine))

    def outward(self, vector: Vector) -> Vector:
        """A vector of the parent in the axes of the child."""
        back = [list(row) for row in zip(*self.attitude, strict=True)]
        sine = self.vectors.graph.product([MINUS, self.sine])
        return self._turned(self.vectors.of(back, vector), sine)

    def _turned(self, vector: Vector, sine: Value) -> Vector:
        if self.kind != REVOLUTE:
            return vector
        own = self.vectors
        along = own.times(own.dot(self.axis, vector), self.axis)
        across = [own.graph.difference(x, y) for x, y in zip(vector, along, strict=True)]
        sideways = own.cross(self.axis, vector)
        return own.plus(along, own.times(self.cosine, across), own.times(sine, sideways))

    def felt(self, force: Vector, torque: Vector) -> Value:
        """What of a force, and of a torque about the origin, is in the direction of its motion."""
        return self.vectors.dot(self.axis, force if self.kind == PRISMATIC else torque)


@dataclass(frozen=True)
class Recursion:
    """The links and joints of a tree on the graph of a system."""

    along: Directions
    tree: Tree

    @cached_property
    def vectors(self) -> Vectors:
        return Vectors(self.along.graph)

    def _column(self, column: MatrixBase) -> Vector:
        plain = self.along.system.names.plain(column)
        return [self.along.graph.expression(x) for x in plain]

    def _matrix(self, matrix: MatrixBase) -> list[Vector]:
        return [self._column(matrix.row(k)) for k in range(3)]

    @cached_property
    def joints(self) -> tuple[Joint, ...]:
        """The joints, in order from the root outward."""
        return self.tree.linkage.outward

    @cached_property
    def moving(self) -> list[Joint]:
        """The joints that are not fixed, from the root outward."""
        return [joint for joint in self.joints if joint.kind != FIXED]

    @cached_property
    def hinges(self) -> dict[str, Hinge]:
        """The joints by the names of their children."""
        return {joint.child: self._hinge(joint) for joint in self.joints}

    def _hinge(self, joint: Joint) -> Hinge:
        graph, own = self.along.graph, self.vectors
        motion = self.along.system.names.plain(joint.motion)
        axis, attitude = self._column(joint.axis), self._matrix(joint.attitude)
        arm = self._column(joint.place)
        if joint.kind == PRISMATIC:
            arm = own.plus(arm, own.times(self.motions[joint.child], own.of(attitude, axis)))
        cosine, sine = ONE, ZERO
        if joint.kind == REVOLUTE:
            cosine, sine = (graph.expression(f(motion)) for f in (sympy.cos, sympy.sin))
        return Hinge(own, joint.kind, axis, attitude, arm, cosine, sine)

    @cached_property
    def motions(self) -> dict[str, Value]:
        """The angles and distances by the names of the children."""
        plain, graph = self.along.system.names.plain, self.along.graph
        return {joint.child: graph.expression(plain(joint.motion)) for joint in self.joints}

    @cached_property
    def links(self) -> dict[str, Composite]:
        """The links that are moved, each by itself."""
        return {
            joint.child: self._alone(self.tree.linkage.link(joint.child)) for joint in self.joints
        }

    def _alone(self, link: Link) -> Composite:
        own, [mass] = self.vectors, self._column(sympy.Matrix([link.mass]))
        centre, inertia = self._column(link.centre), self._matrix(link.inertia)
        moved = own.steiner(mass, centre, [ZERO] * 3)
        rows = [own.plus(x, y) for x, y in zip(inertia, moved, strict=True)]
        return Composite(mass, own.times(mass, centre), rows)

    # --- outward, and back ------------------------------------------------------------------------

    @cached_property
    def torques(self) -> list[Value]:
        """What the joints that move have to give for q̈ = 0, against gravity too."""
        own, graph, rate = self.vectors, self.along.graph, self.along.rate
        none: Vector = [ZERO] * 3
        lifted = own.times(MINUS, self._column(self.tree.gravity))
        states = {self.tree.linkage.root.name: (none, none, lifted)}
        for joint in self.joints:
            hinge = self.hinges[joint.child]
            spin, turn, pull = states[joint.parent]
            swept = own.cross(spin, own.cross(spin, hinge.arm))
            pull = hinge.outward(own.plus(pull, own.cross(turn, hinge.arm), swept))
            spin, turn = hinge.outward(spin), hinge.outward(turn)
            speed = rate(self.motions[joint.child])
            moved, driven = own.times(speed, hinge.axis), own.times(rate(speed), hinge.axis)
            if joint.kind == REVOLUTE:
                turn = own.plus(turn, driven, own.cross(spin, moved))
                spin = own.plus(spin, moved)
            elif joint.kind == PRISMATIC:
                sideways = own.cross(spin, moved)
                pull = own.plus(pull, driven, sideways, sideways)
            states[joint.child] = (spin, turn, pull)
        loads = {name: self._load(self.links[name], *states[name]) for name in self.links}
        felt = {}
        for joint in reversed(self.joints):
            hinge, (force, torque) = self.hinges[joint.child], loads[joint.child]
            felt[joint.child] = hinge.felt(force, torque)
            if joint.parent in loads:
                force, torque = self._inward(hinge, force, torque)
                before = loads[joint.parent]
                loads[joint.parent] = (own.plus(before[0], force), own.plus(before[1], torque))
        return [graph.total([felt[joint.child]]) for joint in self.moving]

    def _load(
        self, link: Composite, spin: Vector, turn: Vector, pull: Vector
    ) -> tuple[Vector, Vector]:
        """The force on a link, and the torque about its origin."""
        own = self.vectors
        swept = own.cross(spin, own.cross(spin, link.moment))
        force = own.plus(own.times(link.mass, pull), own.cross(turn, link.moment), swept)
        gyration = self.along.gyration(link.inertia, spin, turn)
        return force, own.plus(gyration, own.cross(link.moment, pull))

    def _inward(self, hinge: Hinge, force: Vector, torque: Vector) -> tuple[Vector, Vector]:
        """A force, and a torque about the origin, in the parent."""
        own, force = self.vectors, hinge.inward(force)
        return force, own.plus(hinge.inward(torque), own.cross(hinge.arm, force))

    @cached_property
    def composites(self) -> dict[str, Composite]:
        """The links with all that hangs on them, the root too, of which the own part rests."""
        none: Vector = [ZERO] * 3
        whole = {**self.links, self.tree.linkage.root.name: Composite(ZERO, none, [none] * 3)}
        own = self.vectors
        for joint in reversed(self.joints):
            hinge, moved, before = self.hinges[joint.child], whole[joint.child], whole[joint.parent]
            moment = hinge.inward(moved.moment)
            inertia = before.inertia
            if joint.parent in self.links:
                turned = self._turned(hinge, moved.inertia)
                shift = own.steiner(moved.mass, hinge.arm, moment)
                inertia = [own.plus(*rows) for rows in zip(inertia, turned, shift, strict=True)]
            whole[joint.parent] = Composite(
                own.graph.total([before.mass, moved.mass]),
                own.plus(before.moment, moment, own.times(moved.mass, hinge.arm)),
                inertia,
            )
        return whole

    def _turned(self, hinge: Hinge, inertia: Sequence[Vector]) -> list[Vector]:
        """The tensor of inertia R I Rᵀ in the axes further in."""
        columns = [hinge.inward(row) for row in inertia]
        return [hinge.inward(row) for row in zip(*columns, strict=True)]

    @cached_property
    def mass(self) -> list[list[Value]]:
        """H: what each joint has to give for a unit acceleration of another."""
        own, places = self.vectors, {joint.child: k for k, joint in enumerate(self.moving)}
        before = {joint.child: joint.parent for joint in self.joints}
        H = [[ZERO] * len(places) for _ in places]
        for joint in reversed(self.moving):
            body, hinge = self.composites[joint.child], self.hinges[joint.child]
            if joint.kind == PRISMATIC:
                force = own.times(body.mass, hinge.axis)
                torque = own.cross(body.moment, hinge.axis)
            else:
                force = own.cross(hinge.axis, body.moment)
                torque = own.of(body.inertia, hinge.axis)
            k, at = places[joint.child], joint.child
            while at in before:
                if at in places:
                    H[k][places[at]] = H[places[at]][k] = self.hinges[at].felt(force, torque)
                force, torque = self._inward(self.hinges[at], force, torque)
                at = before[at]
        return H

    # --- in coordinates ---------------------------------------------------------------------------

    def share(self) -> Share:
        """M = EᵀHE and so on, with E = ∂(motions)/∂q; L = ½ θ̇·Hθ̇ + g·(m c of the root)."""
        along, own, H = self.along, self.vectors, self.mass
        graph, n = along.graph, len(along.velocities)
        motions = [self.motions[joint.child] for joint in self.moving]
        E = [along.slopes(motion, along.along_places) for motion in motions]
        carried = [[own.dot(row, column) for column in zip(*E, strict=True)] for row in H]

        def by_coordinate(column: Vector) -> list[Value]:
            return [own.dot([row[i] for row in E], column) for i in range(n)]

        rows = [by_coordinate([row[j] for row in carried]) for j in range(n)]
        speeds = [along.rate(motion) for motion in motions]
        pushes = [own.dot(row, speeds) for row in H]
        doubled = own.dot(speeds, pushes)
        hanging = self.composites[self.tree.linkage.root.name].moment
        lifted = own.dot(self._column(self.tree.gravity), hanging)
        momenta = by_coordinate(pushes)
        turned = own.dot(momenta, along.velocities)
        return Share(
            rows,
            by_coordinate(self.torques),
            graph.total([graph.product([HALF, doubled]), lifted]),
            momenta,
            graph.total(
                [
                    graph.product([HALF, turned]),
                    graph.product([HALF, graph.difference(turned, doubled)]),
                    graph.product([MINUS, lifted]),
                ]
            ),
        )

    def frames(self) -> Iterator[tuple[Vector, Sequence[Vector]]]:
        """The place and attitude in space of the centre of each link with mass or inertia."""
        own, linkage = self.vectors, self.tree.linkage
        still = self._matrix(sympy.eye(3))
        frames: dict[str, tuple[Vector, list[Vector]]]
        frames = {linkage.root.name: ([ZERO] * 3, still)}
        for joint in self.joints:
            hinge, (place, rows) = self.hinges[joint.child], frames[joint.parent]
            frames[joint.child] = (
                own.plus(place, own.of(rows, hinge.arm)),
                [hinge.outward(row) for row in rows],
            )
        for link in linkage.massive:
            place, rows = frames[link.name]
            yield own.plus(place, own.of(rows, self._column(link.centre))), rows
