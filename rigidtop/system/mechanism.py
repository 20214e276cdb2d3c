"""`rt.Mechanism`: links and joints, and the system that they are."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from sympy import Expr, Integer
from sympy.physics.mechanics import dynamicsymbols

from rigidtop.errors import RigidtopError
from rigidtop.parameters import in_one_line
from rigidtop.system.linkage import Linkage
from rigidtop.system.names import Given, expression
from rigidtop.system.system import System
from rigidtop.system.urdf import links_and_joints


@dataclass(frozen=True, init=False)
class Mechanism(Linkage):
    """Links and joints that make a tree: its root is the link that no joint moves, at rest.

    The root's axes are those of space.  Loops are closed by `constraints`.  Raises RigidtopError,
    in one line, for what is no tree.

    >>> from sympy import symbols
    >>> from rigidtop.system.linkage import Joint, Link
    >>> m, l, g, tau = symbols("m l g tau", positive=True)
    >>> bob = Link("bob", m, centre=(0, -l, 0))
    >>> pendulum = Mechanism([Link("wall"), bob], [Joint("theta", "wall", "bob")])
    >>> pendulum.place("bob", (0, -l, 0)).T
    Matrix([[l*sin(theta(t)), -l*cos(theta(t)), 0]])
    >>> pendulum.system(gravity=(0, -g, 0)).accelerations
    Matrix([[-g*sin(theta(t))/l]])
    """

    @classmethod
    def from_urdf(cls, given: str | Path, friction: bool = True) -> Mechanism:
        """The mechanism that a URDF describes, a path or the text; its root rests in space.

        Decimals count as they are written; an angle of an `rpy` that is a multiple of π/12, rounded
        to the decimals that are written, four at least, is taken as that multiple.  A floating
        joint is six single ones, name_x to name_z, name_yaw, name_pitch and name_roll, and a planar
        one is name_x, name_y and name_yaw.  A joint that mimics another has no coordinate.  Damping
        is that of the joints; Coulomb friction, which is not smooth, is refused, and with
        `friction` False left out.  Raises RigidtopError, in one line, for what is no URDF.

        >>> made = Mechanism.from_urdf(
        ...     '''<robot name="pendulum"><link name="wall"/>
        ...     <link name="bob">
        ...     <inertial><origin xyz="0 0 -0.5"/><mass value="2"/></inertial></link>
        ...     <joint name="theta" type="continuous"><parent link="wall"/><child link="bob"/>
        ...     <dynamics damping="0.1"/></joint></robot>'''
        ... )
        >>> made.system(gravity=(0, 0, -10)).accelerations
        Matrix([[-20*sin(theta(t)) - Derivative(theta(t), t)/5]])
        """
        return cls(*links_and_joints(given, friction))

    def system(
        self,
        gravity: Given = (0, 0, 0),
        forces: Given = None,
        constraints: Given = (),
        V: Given = 0,
        rayleigh: Given = 0,
    ) -> System:
        """The equations of motion, as a `rigidtop.System` in the coordinates `q`.

        `gravity` is g as a vector in space (m/s²), and `forces` are torques (N m) or forces (N) by
        the name of the joint in which they act, or by coordinate.  The others are as in
        `System.of_parts`; the damping of the joints is a part of `rayleigh`.
        """
        lost = Integer(0)
        for joint in self.joints:
            if joint.damping != 0:
                lost += joint.damping * joint.motion.diff(dynamicsymbols._t) ** 2 / 2
        return System.of_parts(
            self,
            self.q,
            V=V,
            gravity=gravity,
            forces=self._acting(forces),
            constraints=constraints,
            rayleigh=expression("rayleigh", rayleigh) + lost,
        )

    def _acting(self, forces: Given) -> Given:
        """Forces by coordinate: one in a joint acts on all that its motion is made of."""
        if not isinstance(forces, Mapping):
            return forces
        joints = {joint.name: joint for joint in self.joints}
        acting: dict[Any, Expr] = {}
        for key, force in forces.items():
            if not isinstance(key, str):
                acting[key] = acting.get(key, Integer(0)) + expression("a force", force)
                continue
            if key not in joints:
                raise RigidtopError(f"a force in {in_one_line(key)}, which is no joint")
            if not joints[key].coordinates:
                raise RigidtopError(f"the motion of {key} is given: a force there does not matter")
            for x in joints[key].coordinates:
                share = expression("a force", force) * joints[key].motion.diff(x)
                acting[x] = acting.get(x, Integer(0)) + share
        return acting
