"""Two masses on a stick that a bearing turns about a tilted axis (opening of chapter 3.2)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.derivations.exercises.opening import two_masses
from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.solved import answers
from rigidtop.figures.space import UPRIGHT, View, arc, circle, total, unit
from rigidtop.figures.style import Floats

VIEW = View(azimuth=-0.35, elevation=0.5)
"""So that what points at the reader goes down and to the right."""

SHORT = 0.15
"""No room for a name along an arm of this length, or between stick and axis."""


@dataclass(frozen=True)
class Stick:
    """Two masses (kg) on a stick in the yz plane that turns about ẑ, at one moment (SI units)."""

    masses: Floats
    positions: Floats
    omega: Floats

    @property
    def momenta(self) -> Floats:
        """m r × (ω × r) of each (2, 3), J s."""
        velocities = np.cross(self.omega, self.positions)
        return np.cross(self.positions, self.masses[:, None] * velocities)

    @property
    def momentum(self) -> Floats:
        """L (3,), J s."""
        return total(self.momenta)

    @property
    def torque(self) -> Floats:
        """N = ω × L (3,), which turns L along with the stick, N m."""
        sizes = float(np.linalg.norm(self.omega) * np.linalg.norm(self.momenta))
        return total(np.cross(self.omega, self.momenta), sizes)

    @property
    def force(self) -> Floats:
        """F (3,), which keeps the centre of mass on its circle, N."""
        rates = np.cross(self.omega, np.cross(self.omega, self.positions))
        return total(self.masses[:, None] * rates)


def stick(M_1: float, M_2: float, a: float, b: float, alpha: float, omega: float) -> Stick:
    """The first mass above the bearing and to the right of the axis."""
    along = np.array([0.0, math.sin(alpha), math.cos(alpha)])
    return Stick(np.array([M_1, M_2]), np.outer([a, -b], along), np.array([0.0, 0.0, omega]))


def draw_two_masses(axes: Axes, held: Stick) -> None:
    """ω, L, the torque N and the force F of the bearing, which has each a length of its own.

    The masses lie to scale, the longer arm has the length 1; the circles are their ways.
    """
    places = held.positions / np.linalg.norm(held.positions, axis=1).max()
    along, momentum, turning = unit(places[0]), 1.15 * unit(held.momentum), unit(held.torque)
    angle = 0.5 * arc(UPRIGHT, along)
    narrow = (-9, 0) if float(along[1]) < SHORT else (0, 0)
    beside = None if momentum[1] < -0.15 else (-9.0, -2.0)
    parts: list[pen.Part] = [
        pen.Curve([-1.05 * UPRIGHT, pen.ORIGIN], look.RULE, 3.5, z=1, cap="butt"),
        pen.Curve(places, look.NOTE, 2.6, z=4, label="_stick"),
        pen.guide([pen.ORIGIN, 0.55 * along], z=2),
        *pen.angle(angle, r"$\alpha$", narrow, look.NOTE, 1.12, color=look.GREY, lw=0.8, z=3),
        pen.Arrow(1.4 * UPRIGHT, look.OMEGA_VEC, look.OMEGA, 1.7, shift=(9, -2)),
        pen.Arrow(momentum, look.L_VEC, look.MOMENTUM, 1.9, shift=beside, z=5.2),
        pen.couple(turning, (8, -12)),
        pen.Mark(pen.ORIGIN),
    ]
    for k, place in enumerate(places):
        parts += _mass(k, place, 12 * float(np.cbrt(held.masses[k] / held.masses.max())))
    if np.any(held.force):
        parts.append(pen.Arrow(0.55 * unit(held.force), r"$\mathbf{F}$", lw=1.2, shift=(0, 9)))
    if np.any(turning):
        parts.append(pen.Arrow(momentum + 0.5 * turning, "", look.TORQUE, 1.2, start=momentum))
        parts.append(pen.Words(momentum, look.L_DOT, (-4, -17), look.TORQUE, "right"))
    pen.picture(axes, parts, (-1.5, 1.5), (-1.15, 1.35), VIEW)


def _mass(k: int, place: Floats, size: float) -> list[pen.Part]:
    """A ball as one of the same material as the other, its way, and the name of its arm."""
    distance = float(np.linalg.norm(place))
    tilt = math.acos(float(np.clip(place[2] / distance, -1, 1)))
    way = circle(UPRIGHT, tilt, length=distance)
    short = distance < SHORT  # beside F, which may lie there
    aside = (0.5 * size + 3) * (1 - 2 * k), (5, -14)[k] if short else -3
    parts: list[pen.Part] = [
        pen.round_axis(way, look.GREY, lw=0.8, ls=look.DASHED),
        pen.Mark(place, size=size, fill=look.FACE, edge=look.EDGE, width=0.8, z=6),
        pen.Words(place, f"$M_{k + 1}$", aside, ha=("left", "right")[k]),
    ]
    across = 8 * unit([place[2], -place[1]])
    shift = float(across[0]), float(across[1])
    arm = pen.Words(0.62 * place, ("$a$", "$b$")[k], shift, look.NOTE, "center", "center", z=7)
    return parts if short else [*parts, arm]


def _facts(**values: float) -> dict[str, Any]:
    held, facts = stick(**values), answers(two_masses, **values)
    turns, pulls = np.any(held.torque), np.any(held.force)
    bearing = "$L$ stays where it is: the bearing exerts no torque"
    if turns:
        bearing = (
            r"As $\mathbf L$ turns with the stick, the bearing exerts the torque $\mathbf N = "
            r"\boldsymbol\omega \times \mathbf L$ of {torque} N m, out of the plane of the paper"
        )
    across = "The torque N points out of the paper, across the plane of stick and omega."
    push = "the force $F = {force}$ N, from the centre of mass to the axis"
    side = "left" if held.force[1] < 0 else "right"
    pushes = f" The force F of the bearing points to the {side}, at right angles to omega."
    return facts | {
        "couple": bearing,
        "push": push if pulls else "no force, as it holds the centre of mass",
        "turns": across if turns else "There is no torque.",
        "pushes": pushes if pulls else "",
    }


TWO_MASSES = Drawing(
    "two-masses",
    r"Two masses on a stick: $\boldsymbol\omega$, $\mathbf L$, and what the bearing exerts",
    "",
    two_masses.parameters,
    pen.alone(2.8, lambda axes, **values: draw_two_masses(axes, stick(**values))),
    "Two masses on a stick, $M_1 = {M_1}$ kg at $a = {a}$ m and $M_2 = {M_2}$ kg at $b = {b}$ m, "
    r"which a bearing turns at $\omega = {omega}$ rad/s, tilted by $\alpha = {alpha:°}$. "
    r"$\mathbf L$ is at right angles to the stick, {angle:°} from $\boldsymbol\omega$, of "
    "magnitude {angular_momentum} J s. {couple}, and {push}. Grey: the shaft of the bearing. "
    "Directions are computed, lengths of arrows are not to one scale.",
    "A stick with a mass at either end goes through a bearing, tilted by {alpha:°} degrees against "
    "the upright arrow omega; dashed circles about omega are the ways of the masses. The arrow L "
    "leans to the other side, {angle:°} degrees from omega, at right angles to the stick. "
    "{turns}{pushes}",
    _facts,
    asked={"M_1": 1.0, "M_2": 1.2, "a": 0.5, "b": 0.3, "alpha": math.radians(40), "omega": 2.0},
)
