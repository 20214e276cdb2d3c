"""The effective potential, and the turning points of θ."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from rigidtop.figures import style as look
from rigidtop.figures.bodies import (
    SPIN,
    THETA,
    TOP,
    has_phi,
    rates_in_words,
    start_in_words,
    top_in_words,
    vertical,
)
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.style import Floats, alone, degrees, name_at, spoken
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.rigid import SymmetricTop
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter

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
    shown = (
        max(float(turns[0]) - 0.6 * span, NEAREST),
        min(float(turns[1]) + 0.6 * span, math.pi - NEAREST),
    )
    angles = np.linspace(*shown, 1201)
    potential = effective_potential(top, angles, p_phi, p_psi)
    low = int(np.argmin(potential))
    depth = max(energy - float(potential[low]), 1e-3 * top.M * top.g * top.R)
    bottom = float(potential[low]) - 1.0 * depth
    axes.plot(np.degrees(angles), potential, color=look.FIRST, label="_potential")
    inside = np.clip(np.linspace(turns[0], turns[1], 300), *shown)
    axes.fill_between(
        np.degrees(inside),
        np.minimum(effective_potential(top, inside, p_phi, p_psi), energy),
        energy,
        color=look.FIRST,
        alpha=0.12,
        lw=0,
    )
    at = np.degrees(turns)
    axes.plot(at, [energy, energy], "-o", color=look.INK, lw=1.0, ms=3.5, label="_energy")
    for turn in at:
        axes.plot([turn, turn], [bottom, energy], color=look.GREY, lw=0.8, ls=look.DOTTED)
    name_at(axes, float(at[1]), energy, "$E$", (7, 0), va="center", color=look.INK)
    if 0 < low < len(angles) - 1:
        place = float(np.degrees(angles[low])), float(potential[low])
        axes.plot(*place, "s", color=look.SECOND, ms=4.5)
        name_at(axes, *place, "steady", (0, -6), ha="center", va="top", color=look.SECOND)
    axes.set(
        xlim=np.degrees(shown),
        ylim=(bottom, energy + 1.6 * depth),
        xlabel=r"$\theta$  (degrees)",
        ylabel=r"$U - {p_\psi}^2/(2\lambda_3)$  (J)",
    )


def _motion(theta: float, phi_dot: float, omega3: float, **top: float) -> TopMotion:
    has_phi(theta, phi_dot)
    return HeavyTop(**top).motion(theta=theta, phi_dot=phi_dot, omega3=omega3)


def _caption(theta: float, phi_dot: float, omega3: float, **top: float) -> str:
    motion = _motion(theta, phi_dot, omega3, **top)
    first, last = motion.turning_points
    rates = rates_in_words(theta, phi_dot)
    if phi_dot == 0 and not vertical(theta):
        rates = "$φ̇ = θ̇ = 0$"
    return (
        "The effective potential $U$ and the energy $E$, both less the constant $p_ψ²/(2λ₃)$, of a "
        f"top with {top_in_words(motion.body)} that starts at "
        f"{start_in_words(theta, omega3)} with {rates}. "
        f"$θ$ runs between the turning points, {degrees(first)} and {degrees(last)} (dotted); "
        "the square marks the steady precession with the same momenta."
    )


def _in_words(**values: float) -> str:
    first, last = np.degrees(_motion(**values).turning_points)
    return (
        "A valley-shaped curve of the effective potential against theta. A horizontal line at the "
        f"energy E meets it at two turning points, {spoken(first)} and {spoken(last)} degrees; "
        "the lowest point lies between them."
    )


EFFECTIVE_POTENTIAL = Drawing(
    "effective-potential",
    "The effective potential with the turning points",
    "3.5.4",
    (*TOP, THETA, Parameter("phi_dot", 0.0, "$φ̇$ at the start", "rad/s"), SPIN),
    alone(2.5, lambda axes, **values: draw_effective_potential(axes, _motion(**values))),
    _caption,
    _in_words,
)
