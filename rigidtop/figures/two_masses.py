"""Two masses on a stick that a bearing turns about a tilted axis (opening of chapter 3.2)."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes

from rigidtop.derivations.exercises.opening import two_masses
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.solved import answers
from rigidtop.figures.space import UPRIGHT, Scene, View, arc, circle, paper, total, unit
from rigidtop.figures.style import Floats, alone, degrees, said, spoken

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
    scene = Scene(axes, VIEW)
    places = held.positions / np.linalg.norm(held.positions, axis=1).max()
    along = unit(places[0])
    shaft = np.array([[0.0, 0.0, -1.05], [0.0, 0.0, 0.0]])
    scene.line(shaft, color=look.RULE, lw=3.5, solid_capstyle="butt", zorder=1)
    for place in places:
        distance = float(np.linalg.norm(place))
        tilt = math.acos(float(np.clip(place[2] / distance, -1, 1)))
        way = circle(UPRIGHT, tilt, length=distance)
        scene.ring(way, color=look.GREY, lw=0.8, ls=look.DASHED)
    scene.line(places, color=look.NOTE, lw=2.6, zorder=4, label="_stick")
    heaviest = held.masses.max()
    for k, (side, arm) in enumerate((("left", "$a$"), ("right", "$b$"))):
        size = 12 * float(np.cbrt(held.masses[k] / heaviest))  # as balls of one material
        scene.dot(places[k], ms=size, mfc=look.FACE, mec=look.EDGE, mew=0.8, zorder=6)
        away = (0.5 * size + 3) * (1 - 2 * k)
        short = bool(np.linalg.norm(places[k]) < SHORT)  # beside F, which may lie there
        above = (5, -14)[k] if short else -3
        scene.words(places[k], f"$M_{k + 1}$", (away, above), color=look.INK, ha=side)
        if short:
            continue
        across = 8 * unit(np.array([places[k, 2], -places[k, 1]]))
        shift = (float(across[0]), float(across[1]))
        scene.words(0.62 * places[k], arm, shift, ha="center", va="center", zorder=7)
    scene.line(np.outer([0.0, 0.55], along), color=look.GREY, lw=0.7, zorder=2)
    angle = 0.5 * arc(UPRIGHT, along)
    scene.line(angle, color=look.GREY, lw=0.9, zorder=3)
    aside = (-9, 0) if float(along[1]) < SHORT else (0, 0)
    scene.words(1.16 * angle[30], r"$\alpha$", aside, ha="center", va="center")
    momentum = 1.15 * unit(held.momentum)
    scene.arrow(1.4 * UPRIGHT, look.OMEGA_VEC, color=look.OMEGA, lw=1.7, shift=(9, -2))
    beside = None if momentum[1] < -0.15 else (-9.0, -2.0)
    scene.arrow(momentum, look.L_VEC, color=look.MOMENTUM, lw=1.9, shift=beside, zorder=5.2)
    if np.any(held.force):
        scene.arrow(0.55 * unit(held.force), r"$\mathbf{F}$", color=look.INK, lw=1.2, shift=(0, 9))
    couple = unit(held.torque)
    scene.couple(couple, (8, -12))
    if np.any(couple):
        scene.arrow(momentum + 0.5 * couple, start=momentum, color=look.TORQUE, lw=1.2)
        scene.words(momentum, look.L_DOT, (-4, -17), color=look.TORQUE, ha="right")
    scene.dot(np.zeros(3))
    paper(axes, (-1.5, 1.5), (-1.15, 1.35))


def _caption(M_1: float, M_2: float, a: float, b: float, alpha: float, omega: float) -> str:
    held = stick(M_1, M_2, a, b, alpha, omega)
    found = answers(two_masses, M_1=M_1, M_2=M_2, a=a, b=b, alpha=alpha, omega=omega)
    torque = "$L$ stays where it is: the bearing exerts no torque"
    if np.any(held.torque):
        torque = (
            "As $𝐋$ turns with the stick, the bearing exerts the torque $𝐍 = 𝛚 × 𝐋$ of "
            f"{said(found['torque'])} N m, out of the plane of the paper"
        )
    force = "no force, as it holds the centre of mass"
    if np.any(held.force):
        force = f"the force $F = {said(found['force'])}$ N, from the centre of mass to the axis"
    return (
        f"Two masses on a stick, $M₁ = {said(M_1)}$ kg at $a = {said(a)}$ m and $M₂ = {said(M_2)}$ "
        f"kg at $b = {said(b)}$ m, which a bearing turns at $ω = {said(omega)}$ rad/s, tilted by "
        f"$α = {degrees(alpha)}$. $𝐋$ is at right angles to the stick, {degrees(found['angle'])} "
        f"from $𝛚$, of magnitude {said(found['angular_momentum'])} J s. {torque}, and {force}. "
        "Grey: the shaft of the bearing. Directions are computed, lengths of arrows are not to one "
        "scale."
    )


def _in_words(**values: float) -> str:
    held = stick(**values)
    found = answers(two_masses, **values)
    tilt = spoken(math.degrees(values["alpha"]))
    lean = spoken(math.degrees(found["angle"]))
    seen = (
        f"A stick with a mass at either end goes through a bearing, tilted by {tilt} degrees "
        "against the upright arrow omega; dashed circles about omega are the ways of the masses. "
        f"The arrow L leans to the other side, {lean} degrees from omega, at right angles to the "
        "stick. "
    )
    if np.any(held.torque):
        seen += "The torque N points out of the paper, across the plane of stick and omega."
    else:
        seen += "There is no torque."
    if np.any(held.force):
        side = "left" if held.force[1] < 0 else "right"
        seen += f" The force F of the bearing points to the {side}, at right angles to omega."
    return seen


TWO_MASSES = Drawing(
    "two-masses",
    "Two masses on a stick: $𝛚$, $𝐋$, and what the bearing exerts",
    "",
    two_masses.parameters,
    alone(2.8, lambda axes, **values: draw_two_masses(axes, stick(**values))),
    _caption,
    _in_words,
    asked={"M_1": 1.0, "M_2": 1.2, "a": 0.5, "b": 0.3, "alpha": math.radians(40), "omega": 2.0},
)
