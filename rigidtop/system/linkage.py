"""Links and joints: a tree of bodies of which each is moved by a joint in the one before.

Its equations come by recursion from link to link, see `recursion`, and not from places in space.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy
from sympy import Derivative, Expr, Function, Matrix, MatrixBase
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import dynamicsymbols

from rigidtop.errors import RigidtopError
from rigidtop.parameters import in_one_line
from rigidtop.system.names import Given, expression
from rigidtop.system.parts import (
    Assembly,
    Body,
    checked_attitude,
    checked_inertia,
    checked_place,
    potential_energy,
)

REVOLUTE, PRISMATIC, FIXED = KINDS = ("revolute", "prismatic", "fixed")


@dataclass(frozen=True)
class Link:
    """A body of a mechanism, in the axes of the joint that moves it.

    `centre` is its centre of mass (3 components, m) and `inertia` that about the centre of mass:
    three principal moments or a symmetric tensor (3×3, kg m²), none if it is not given.
    """

    name: str
    mass: Expr
    centre: MatrixBase
    inertia: MatrixBase

    def __init__(
        self, name: str, mass: Given = 0, centre: Given = (0, 0, 0), inertia: Given = None
    ) -> None:
        object.__setattr__(self, "name", _name("a link", name))
        object.__setattr__(self, "mass", expression("a mass", mass))
        object.__setattr__(self, "centre", checked_place(centre))
        tensor = checked_inertia((0, 0, 0) if inertia is None else inertia)
        object.__setattr__(self, "inertia", tensor)
        _stands(f"the link {self.name}", self.expressions)

    @property
    def expressions(self) -> tuple[Expr, ...]:
        """All expressions that it is given."""
        return (self.mass, *self.centre, *self.inertia)


@dataclass(frozen=True)
class Joint:
    """A joint that moves the link `child` in the link `parent`.

    `kind` is "revolute" (about the `axis`), "prismatic" (along it) or "fixed".  `place` (3
    components, m) and `attitude` (3×3, its axes as columns) are those of the joint in the axes of
    the parent; the `axis`, of any length but zero, stands in the joint's own.  `motion` is the
    angle (rad) or the distance (m), by which the child's axes leave the joint's: a coordinate
    with the joint's name if it is not given, else any expression of coordinates, as functions of
    time, and of time.  `damping` is the torque over the rate (N m s), or the force over the speed
    (N s/m).

    >>> Joint("elbow", "arm", "forearm").motion
    elbow(t)
    >>> Joint("motor", "base", "wheel", motion=3*dynamicsymbols._t, axis=(0, 0, 2)).axis.T
    Matrix([[0, 0, 1]])
    """

    name: str
    parent: str
    child: str
    kind: str
    axis: MatrixBase
    place: MatrixBase
    attitude: MatrixBase
    motion: Expr
    damping: Expr

    def __init__(
        self,
        name: str,
        parent: str,
        child: str,
        kind: str = REVOLUTE,
        axis: Given = (0, 0, 1),
        place: Given = (0, 0, 0),
        attitude: MatrixBase | None = None,
        motion: Given = None,
        damping: Given = 0,
    ) -> None:
        name = _name("a joint", name)
        if kind not in KINDS:
            word = in_one_line(kind)
            raise RigidtopError(f"the joint {name} is {', '.join(KINDS[:2])} or fixed, not {word}")
        if kind == FIXED:
            axis, motion = (0, 0, 1), 0 if motion is None else motion
        if motion is None:
            motion = Function(name)(dynamicsymbols._t)
        for field, value in (
            ("name", name),
            ("parent", _name("a link", parent)),
            ("child", _name("a link", child)),
            ("kind", kind),
            ("axis", _unit(name, checked_place(axis))),
            ("place", checked_place(place)),
            ("attitude", checked_attitude(sympy.eye(3) if attitude is None else attitude)),
            ("motion", expression(f"the motion of {name}", motion)),
            ("damping", expression(f"the damping of {name}", damping)),
        ):
            object.__setattr__(self, field, value)
        if kind == FIXED and (self.motion != 0 or self.damping != 0):
            raise RigidtopError(f"the joint {name} is fixed: it has no motion and no damping")
        if self.motion.has(Derivative):
            raise RigidtopError(f"the motion of {name} is of coordinates and time, not of rates")
        _stands(f"the joint {name}", (*self.axis, *self.place, *self.attitude, self.damping))

    @property
    def expressions(self) -> tuple[Expr, ...]:
        """All expressions that it is given."""
        return (*self.axis, *self.place, *self.attitude, self.motion)

    @property
    def coordinates(self) -> tuple[Expr, ...]:
        """The functions of time in its motion."""
        return tuple(sorted(self.motion.atoms(AppliedUndef), key=str))


@dataclass(frozen=True)
class Linkage:
    """Links and joints that make a tree: its root is the link that no joint moves, at rest.

    The root's axes are those of space.  Raises RigidtopError, in one line, for what is no tree.
    """

    links: tuple[Link, ...]
    joints: tuple[Joint, ...]

    def __init__(self, links: Given, joints: Given) -> None:
        for what, group, kind in (("links", links, Link), ("joints", joints, Joint)):
            if isinstance(group, (str, bytes)) or not isinstance(group, Sequence):
                raise RigidtopError(f"the {what} are a row of them, not {in_one_line(group)}")
            for each in group:
                if not isinstance(each, kind):
                    raise RigidtopError(f"among the {what} is {in_one_line(each)}")
            names = [each.name for each in group]
            twice = next((name for name in names if names.count(name) > 1), None)
            if twice is not None:
                raise RigidtopError(f"two {what} are called {twice}")
            object.__setattr__(self, what, tuple(group))
        self._check()

    def _check(self) -> None:
        names = {link.name for link in self.links}
        moved: dict[str, str] = {}
        for joint in self.joints:
            for link in (joint.parent, joint.child):
                if link not in names:
                    raise RigidtopError(f"the joint {joint.name} has {link}, which is no link")
            if joint.child in moved:
                both = f"{moved[joint.child]} and {joint.name}"
                raise RigidtopError(f"two joints move the link {joint.child}: {both}")
            moved[joint.child] = joint.name
        roots = [link.name for link in self.links if link.name not in moved]
        if len(roots) != 1:
            listed = " and ".join(roots) if roots else "none"
            raise RigidtopError(f"one link is moved by no joint, the root, and not {listed}")
        reached = {roots[0], *(joint.child for joint in self.outward)}
        lost = next((link.name for link in self.links if link.name not in reached), None)
        if lost is not None:
            raise RigidtopError(f"the joints of {lost} go round in a loop, away from the root")

    @property
    def root(self) -> Link:
        """The link that no joint moves."""
        moved = {joint.child for joint in self.joints}
        return next(link for link in self.links if link.name not in moved)

    @cached_property
    def outward(self) -> tuple[Joint, ...]:
        """The joints from the root outward."""
        ordered, ends = [], [self.root.name]
        while ends:
            end = ends.pop(0)
            behind = [joint for joint in self.joints if joint.parent == end]
            ordered += behind
            ends += [joint.child for joint in behind]
        return tuple(ordered)

    @property
    def q(self) -> tuple[Expr, ...]:
        """The coordinates, in the order of the joints in which they come first."""
        return tuple(dict.fromkeys(x for joint in self.joints for x in joint.coordinates))

    def link(self, name: str) -> Link:
        """A link by its name.  Raises RigidtopError for another."""
        for link in self.links:
            if link.name == name:
                return link
        raise RigidtopError(f"no link is called {in_one_line(name)}")

    def place(self, link: str, point: Given = (0, 0, 0)) -> Matrix:
        """Where a point (3 components, in a link's axes, m) is in space (3×1)."""
        origin, attitude = self._frames[self.link(link).name]
        return origin + attitude * checked_place(point)

    def attitude(self, link: str) -> Matrix:
        """The axes of a link in space, as columns (3×3)."""
        return self._frames[self.link(link).name][1]

    @cached_property
    def _frames(self) -> Mapping[str, tuple[Matrix, Matrix]]:
        frames = {self.root.name: (sympy.zeros(3, 1), sympy.eye(3))}
        for joint in self.outward:
            origin, attitude = frames[joint.parent]
            at, turned = origin + attitude * joint.place, attitude * joint.attitude
            if joint.kind == PRISMATIC:
                at += turned * joint.axis * joint.motion
            if joint.kind == REVOLUTE:
                turned = turned * _turn(joint.axis, joint.motion)
            frames[joint.child] = (at, turned)
        return frames

    @property
    def massive(self) -> tuple[Link, ...]:
        """The links with mass or inertia, of which the motion of the others is a part."""
        return tuple(
            link for link in self.links if link.mass != 0 or not link.inertia.is_zero_matrix
        )

    @cached_property
    def bodies(self) -> tuple[Body, ...]:
        """Each of these links as a body in space."""
        return tuple(
            Body(
                link.mass,
                link.inertia,
                self.place(link.name, link.centre),
                self.attitude(link.name),
            )
            for link in self.massive
        )


@dataclass(frozen=True)
class Tree(Assembly):
    """A linkage with the gravity (3×1) that acts on it: a part of a system."""

    linkage: Linkage
    gravity: MatrixBase

    @property
    def expressions(self) -> tuple[Expr, ...]:
        """All that links and joints are given, and gravity."""
        return tuple(self._given())

    def _given(self) -> Iterator[Expr]:
        yield from self.gravity
        for link in self.linkage.links:
            yield from link.expressions
        for joint in self.linkage.joints:
            yield from joint.expressions

    @property
    def bodies(self) -> tuple[Body, ...]:
        """The links with mass or inertia, in space."""
        return self.linkage.bodies

    @property
    def potential(self) -> Expr:
        """−Σ m g·r, without the root, which rests."""
        root = self.linkage.root
        still = potential_energy(
            [Body(root.mass, root.inertia, root.centre, sympy.eye(3))], self.gravity
        )
        return potential_energy(self.bodies, self.gravity) - still


def _turn(axis: MatrixBase, angle: Expr) -> Matrix:
    """The rotation about a unit axis."""
    along = axis * axis.T
    x, y, z = axis
    across = Matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return along + sympy.cos(angle) * (sympy.eye(3) - along) + sympy.sin(angle) * across


def _unit(name: str, axis: MatrixBase) -> MatrixBase:
    size = sympy.sqrt(axis.dot(axis))
    if size == 0:
        raise RigidtopError(f"the axis of the joint {name} is zero: it has no direction")
    return (axis / size).as_immutable()


def _name(what: str, name: Any) -> str:
    if not isinstance(name, str) or not name.strip():
        raise RigidtopError(f"{what} has a name, not {in_one_line(name)}")
    return name


def _stands(what: str, expressions: Sequence[Expr]) -> None:
    """Raises RigidtopError where something changes that belongs to a rigid body."""
    for x in expressions:
        if x.has(AppliedUndef, dynamicsymbols._t):
            raise RigidtopError(f"{what} has {in_one_line(x)}, which changes: it is rigid")
