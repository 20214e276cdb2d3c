"""URDF, the file of a robot, as links and joints (wiki.ros.org/urdf/XML).

Decimals count as they are written.  An angle of an `rpy` that is a multiple of π/12, rounded to the
decimals that are written, four at least, is taken as that multiple: 1.5708 is a right angle.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

import sympy
from sympy import Expr, Matrix, MatrixBase, Rational

from rigidtop.errors import RigidtopError
from rigidtop.parameters import in_one_line
from rigidtop.system.linkage import FIXED, PRISMATIC, REVOLUTE, Joint, Link

LARGEST = 20_000_000
"""Bytes of a file."""

NUMBER = re.compile(r"[+-]?(\d{1,40}\.?\d{0,40}|\.\d{1,40})([eE][+-]?\d{1,2})?", re.ASCII)

ANGLE = re.compile(r"[+-]?\d{1,40}\.(\d{4,40})", re.ASCII)
"""With decimals enough that it may stand for a part of π."""

SINGLE = {"revolute": REVOLUTE, "continuous": REVOLUTE, "prismatic": PRISMATIC, "fixed": FIXED}

X, Y, Z = ((1, 0, 0), (0, 1, 0), (0, 0, 1))

FLOATING = (
    *(("x", PRISMATIC, X), ("y", PRISMATIC, Y), ("z", PRISMATIC, Z)),
    *(("yaw", REVOLUTE, Z), ("pitch", REVOLUTE, Y), ("roll", REVOLUTE, X)),
)


def links_and_joints(source: Any, friction: bool) -> tuple[list[Link], list[Joint]]:
    """The links and joints of a file or a text; see `Mechanism.from_urdf`."""
    robot = _root(_text(source))
    links = [_link(each) for each in robot.findall("link")]
    names = [_named(each) for each in robot.findall("joint")]
    for name in names:
        if names.count(name) > 1:
            raise RigidtopError(f"two joints are called {name}")
    read = _Joints(dict(zip(names, robot.findall("joint"), strict=True)), friction)
    joints = [joint for name in read.elements for joint in read.made(name)]
    between = {joint.child for joint in joints} - {link.name for link in links}
    children = {_link_of(each, "child") for each in read.elements.values()}
    links += [Link(name) for name in sorted(between - children)]
    return links, joints


def _text(source: Any) -> str:
    """The text that is given, or that of the file."""
    if isinstance(source, str) and "<" in source:
        return source
    if not isinstance(source, (str, Path)):
        raise RigidtopError(f"a URDF is a path or a text, not {in_one_line(source)}")
    path = Path(source)
    try:
        if not path.is_file():
            problem = "there is no such file"
        elif path.stat().st_size > LARGEST:
            problem = f"it is larger than {LARGEST // 10**6} MB"
        else:
            return path.read_bytes().decode("utf-8-sig")
    except UnicodeError:
        problem = "it is not in UTF-8"
    except (OSError, ValueError) as error:
        problem = in_one_line(str(error))
    raise RigidtopError(f"the URDF {in_one_line(path.name)} can't be read: {problem}")


def _root(text: str) -> Element:
    """The element `robot`.  No document type is read: entities could stand for anything."""
    if "<!DOCTYPE" in text or "<!ENTITY" in text:
        raise RigidtopError("a URDF has no DOCTYPE and no entities")
    try:
        robot = ElementTree.fromstring(text)
    except (ElementTree.ParseError, ValueError, RecursionError) as error:
        raise RigidtopError(f"the URDF is broken: {in_one_line(str(error))}") from None
    if robot.tag != "robot":
        raise RigidtopError(f"a URDF is a robot, not {in_one_line(robot.tag)}")
    if any("xacro" in str(each.tag) for each in robot.iter()):
        raise RigidtopError("the URDF has macros: expand them with xacro first")
    return robot


def _named(element: Element) -> str:
    name = element.get("name")
    if not name:
        raise RigidtopError(f"a {element.tag} of the URDF has no name")
    return name


def _link_of(joint: Element, which: str) -> str:
    element = joint.find(which)
    name = None if element is None else element.get("link")
    if not name:
        raise RigidtopError(f"the joint {_named(joint)} has no {which}")
    return name


def _link(element: Element) -> Link:
    """A link, its tensor in its own axes."""
    name, inertial = _named(element), element.find("inertial")
    if inertial is None:
        return Link(name)
    place, attitude = _origin(inertial, name)
    [mass] = _numbers(inertial.find("mass"), "value", "0", 1, name)
    row = inertial.find("inertia")
    xx, xy, xz, yy, yz, zz = (
        _numbers(row, key, "0", 1, name)[0] for key in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
    )
    inertia = attitude * Matrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) * attitude.T
    tensor = Matrix(3, 3, lambda i, j: inertia[max(i, j), min(i, j)])
    return Link(name, mass, place, tensor)


@dataclass(frozen=True)
class _Joints:
    """The joints of a file by their names."""

    elements: Mapping[str, Element]
    friction: bool

    def made(self, name: str) -> Iterator[Joint]:
        """A joint, or the single joints that do as it does, with links without mass between."""
        element = self.elements[name]
        kind = element.get("type")
        place, attitude = _origin(element, name)
        axis = Matrix(_numbers(element.find("axis"), "xyz", "1 0 0", 3, name))
        ends = _link_of(element, "parent"), _link_of(element, "child")
        damping = self._damping(element, name)
        if kind in SINGLE:
            fixed = SINGLE[kind] == FIXED
            motion = None if fixed else self.motion(name)
            damping = sympy.S.Zero if fixed else damping
            yield Joint(name, *ends, SINGLE[kind], axis, place, attitude, motion, damping)
            return
        if kind not in ("floating", "planar"):
            raise RigidtopError(f"the joint {name} is of no known type: {in_one_line(kind)}")
        if damping != 0:
            raise RigidtopError(f"the joint {name} is {kind}, and has one damping for all it does")
        several = FLOATING if kind == "floating" else _planar(axis, name)
        before = ends[0]
        for k, (end, single, along) in enumerate(several):
            after = ends[1] if k == len(several) - 1 else f"{name}_{end}"
            yield Joint(f"{name}_{end}", before, after, single, along, place, attitude)
            before, place, attitude = after, sympy.zeros(3, 1), sympy.eye(3)

    def motion(self, name: str, seen: tuple[str, ...] = ()) -> Expr | None:
        """What a joint does as another does, if it does so."""
        mimic = self.elements[name].find("mimic")
        if mimic is None:
            return None
        other = mimic.get("joint", "")
        if other in (name, *seen):
            raise RigidtopError(f"the joint {name} mimics itself")
        if other not in self.elements or SINGLE.get(self.elements[other].get("type", "")) not in (
            REVOLUTE,
            PRISMATIC,
        ):
            raise RigidtopError(f"the joint {name} mimics {in_one_line(other)}, which can't be")
        [factor] = _numbers(mimic, "multiplier", "1", 1, name)
        [offset] = _numbers(mimic, "offset", "0", 1, name)
        own = self.motion(other, (name, *seen))
        if own is None:
            own = Joint(other, "before", "after").motion
        return factor * own + offset

    def _damping(self, element: Element, name: str) -> Expr:
        dynamics = element.find("dynamics")
        [friction] = _numbers(dynamics, "friction", "0", 1, name)
        if friction != 0 and self.friction:
            raise RigidtopError(
                f"the joint {name} has Coulomb friction, which has no Rayleigh function: "
                "friction=False leaves it out"
            )
        return _numbers(dynamics, "damping", "0", 1, name)[0]


def _planar(normal: Matrix, name: str) -> tuple[tuple[str, str, Any], ...]:
    """Along two directions across the normal, and about it."""
    if normal.is_zero_matrix:
        raise RigidtopError(f"the axis of the joint {name} is zero: it has no direction")
    least = min(range(3), key=lambda k: abs(normal[k]))
    along = sympy.eye(3)[:, least] * normal.dot(normal) - normal[least] * normal
    return (
        ("x", PRISMATIC, along),
        ("y", PRISMATIC, normal.cross(along)),
        ("yaw", REVOLUTE, normal),
    )


def _origin(element: Element, name: str) -> tuple[MatrixBase, MatrixBase]:
    """Place and attitude, R_z(yaw) R_y(pitch) R_x(roll)."""
    origin = element.find("origin")
    place = Matrix(_numbers(origin, "xyz", "0 0 0", 3, name))
    roll, pitch, yaw = _numbers(origin, "rpy", "0 0 0", 3, name, angles=True)
    turned = sympy.rot_axis3(-yaw) * sympy.rot_axis2(-pitch) * sympy.rot_axis1(-roll)
    return place, turned


def _numbers(
    element: Element | None, key: str, otherwise: str, count: int, name: str, angles: bool = False
) -> list[Expr]:
    """The numbers of an attribute, as many as are wanted."""
    text = otherwise if element is None else element.get(key, otherwise)
    words = text.split()
    if len(words) != count or not all(map(NUMBER.fullmatch, words)):
        wanted = "a number" if count == 1 else f"{count} numbers"
        raise RigidtopError(f"{key} of {name} is {wanted}, not {in_one_line(text)}")
    return [_angle(word) if angles else Rational(word) for word in words]


def _angle(word: str) -> Expr:
    """A part of π where that is what was rounded.

    >>> _angle("1.5708"), _angle("-0.261799388"), _angle("1.57"), _angle("1.5707")
    (pi/2, -pi/12, 157/100, 15707/10000)
    """
    value, match = Rational(word), ANGLE.fullmatch(word)
    if match:
        near = sympy.Integer(round(float(value) * 12 / float(sympy.pi))) * sympy.pi / 12
        half = Rational(1, 2 * 10 ** len(match[1]))
        if near != 0 and abs(sympy.N(near - value, 60)) <= half:
            return near
    return value
