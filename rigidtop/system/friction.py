"""Dry friction as it is declared: what slides, and how hard it is pressed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy
from sympy import Expr

from rigidtop.errors import RigidtopError
from rigidtop.system.names import Given, PlainSymbols, expression


@dataclass(frozen=True)
class DryFriction:
    """Coulomb's friction, which sticks: one of the `forces` of a `System`.

    `of` is the velocity w at which two surfaces slide, linear in the velocities, such as ẋ − u on a
    belt of speed u; of an expression of coordinates it is the rate.  `normal` is the force N ≥ 0
    that presses them together, an expression of q, q̇, t and parameters; at a hinge it is a force
    times a radius, or the friction's torque with μ = 1.  `mu` is μ while they slide, `mu_static`
    ≥ μ that of rest, the same by default.

    While they slide the force is −μN sign(w) ∂w/∂q̇.  While w is zero and the force that keeps it so
    is at most μₛN, that force acts instead, and w stays zero.  A system has one friction, in its
    motions; it stands alone as `forces`, or in a list with the forces of the coordinates.

    >>> from sympy import symbols
    >>> from rigidtop.system.system import System
    >>> m, g, k, mu = symbols("m g k mu", positive=True)
    >>> x, v = symbols("x v", real=True)
    >>> block = System(m*v**2/2 - k*x**2/2, [x], [v], forces=DryFriction(v, m*g, mu))
    >>> run = block.motion({m: 1, g: 10, k: 100, mu: 0.2}, q=0.09).integrate([0, 0.2, 1, 9])
    >>> run.q[:, 0].round(6).tolist(), run.slip.tolist()
    ([0.09, -0.00913, 0.01, 0.01], [-1, -1, 0, 0])
    """

    of: Given
    normal: Given
    mu: Given
    mu_static: Given = None

    def __post_init__(self) -> None:
        static = self.mu if self.mu_static is None else self.mu_static
        for name, value in {**vars(self), "mu_static": static}.items():
            number = expression(f"{name} of a DryFriction", value)
            object.__setattr__(self, name, number)
            if name != "of" and number.is_number and number.is_negative:
                raise RigidtopError(f"{name} of a DryFriction is {number}: it can't be negative")

    @property
    def expressions(self) -> dict[str, Expr]:
        """What it is given, by what that is."""
        return {f"{name} of a DryFriction": value for name, value in vars(self).items()}

    def velocity(self, names: PlainSymbols) -> Expr:
        """The velocity w with which it slides, in plain symbols."""
        of: Expr = names.plain(self.of)
        if of.has(*names.v):
            return of
        return names.rate(of, dict(zip(names.q, names.v, strict=True)))

    def on_coordinates(self, names: PlainSymbols, sign: Expr | None = None) -> tuple[Expr, ...]:
        """The generalised forces while it slides with a sign, or with that of w, plain."""
        w = self.velocity(names)
        size = names.plain(self.mu * self.normal)
        return tuple(-size * (sign or sympy.sign(w)) * w.diff(v) for v in names.v)


def apart(forces: Given) -> tuple[Given, DryFriction | None]:
    """The other forces, and the dry friction among them."""
    if isinstance(forces, DryFriction):
        return None, forces
    if isinstance(forces, Mapping):
        if any(isinstance(x, DryFriction) for x in forces.values()):
            raise RigidtopError(
                "a DryFriction says itself what slides: forces=[…, DryFriction(…)], a list with "
                "the other forces in the order of the coordinates"
            )
        return forces, None
    if not isinstance(forces, (list, tuple)):
        return forces, None
    frictions = [x for x in forces if isinstance(x, DryFriction)]
    if len(frictions) > 1:
        raise RigidtopError(
            f"{len(frictions)} dry frictions: a system has one; write the others smooth, with "
            "tanh(v/c) for sign(v)"
        )
    if not frictions:
        return forces, None
    return [x for x in forces if not isinstance(x, DryFriction)] or None, frictions[0]


def refuse(friction: DryFriction | None, what: str, instead: str = "") -> None:
    """Raises RigidtopError where there is dry friction, for what can't have it."""
    if friction is not None:
        raise RigidtopError(
            f"{what} can't have a DryFriction, which sticks: "
            + (instead or "write it smooth, with tanh(v/c) for sign(v)")
        )
