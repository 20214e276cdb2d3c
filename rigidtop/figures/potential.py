"""The effective potential, and the turning points of θ."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.bodies import RATE, SPIN, THETA, TOP, facts_of_motion, top_motion, vertical
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.style import Floats
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.rigid import SymmetricTop

NEAREST = 1e-4
"""To the vertical that the curve is drawn (rad); there it may be infinite."""


def effective_potential(top: SymmetricTop, theta: ArrayLike, p_phi: float, p_psi: float) -> Floats:
    """(p_φ − p_ψ cos θ)²/(2λ₁ sin² θ) + MgR cos θ, in J; θ in rad, the momenta in J s."""
    angle = np.asarray(theta, dtype=float)
    turning = (p_phi - p_psi * np.cos(angle)) ** 2 / (2 * top.lambda1 * np.sin(angle) ** 2)
    return np.asarray(turning + top.M * top.g * top.R * np.cos(angle))


def draw_effective_potential(axes: Axes, motion: TopMotion) -> None:
    """U(θ) of a motion, its energy less p_ψ²/2λ₃, and the turning points between which θ runs."""
    top, start = motion.body, motion.start()
    p_phi, p_psi = float(start.p_phi[0]), float(start.p_psi[0])
    energy = float(start.energy[0]) - p_psi**2 / (2 * top.lambda3)
    turns = np.clip(motion.turning_points, 0.0, math.pi)
    span = max(float(turns[1] - turns[0]), 0.02)
    shown = np.clip(turns + 0.6 * span * np.array([-1, 1]), NEAREST, math.pi - NEAREST)
    angles = np.linspace(shown[0], shown[1], 1201)
    potential = effective_potential(top, angles, p_phi, p_psi)
    low = int(np.argmin(potential))
    depth = max(energy - float(potential[low]), 1e-3 * top.M * top.g * top.R)
    bottom = float(potential[low]) - depth
    inside = np.clip(np.linspace(turns[0], turns[1], 300), *shown)
    below = np.minimum(effective_potential(top, inside, p_phi, p_psi), energy)
    at = np.degrees(turns)
    parts: list[pen.Part] = [
        pen.Curve((np.degrees(angles), potential), look.FIRST, 1.3, label="_potential"),
        pen.Band(np.degrees(inside), below, energy),
        *(pen.Curve((turn, [bottom, energy]), look.GREY, 0.8, look.DOTTED) for turn in at),
        pen.Curve((at, energy), lw=1.0, label="_energy"),
        pen.Markers((at, energy)),
        pen.Words((at[1], energy), "$E$", (7, 0), va="center"),
    ]
    if 0 < low < len(angles) - 1:
        place = math.degrees(angles[low]), float(potential[low])
        name: Any = {"words": "steady", "shift": (0, -6), "ha": "center", "va": "top"}
        parts.append(pen.Markers(place, look.SECOND, 4.5, "s", **name))
    limits = {"xlim": np.degrees(shown), "ylim": (bottom, energy + 1.6 * depth)}
    up = r"$U - {p_\psi}^2/(2\lambda_3)$  (J)"
    pen.chart(axes, parts, r"$\theta$  (degrees)", up, **limits)


def _facts(theta: float, phi_dot: float, **others: float) -> dict[str, Any]:
    facts = facts_of_motion(top_motion(theta, phi_dot, **others), theta, 0.0)
    at_rest = phi_dot == 0 and not vertical(theta)
    return facts | ({"rates": r"$\dot\phi = \dot\theta = 0$"} if at_rest else {})


EFFECTIVE_POTENTIAL = Drawing(
    "effective-potential",
    "The effective potential with the turning points",
    "3.5.4",
    (*TOP, THETA, RATE, SPIN),
    pen.alone(2.5, lambda axes, **values: draw_effective_potential(axes, top_motion(**values))),
    "The effective potential $U$ and the energy $E$, both less the constant "
    r"$p_\psi^2/(2\lambda_3)$, of a top with {top} that starts at {start} with {rates}. $\theta$ "
    "runs between the turning points, {first:°} and {last:°} (dotted); the square marks the steady "
    "precession with the same momenta.",
    "A valley-shaped curve of the effective potential against theta. A horizontal line at the "
    "energy E meets it at two turning points, {first:°} and {last:°} degrees; the lowest point "
    "lies between them.",
    _facts,
)
