"""A rotor whose axle is held at one end, in steady precession: the arrows at its start."""

from __future__ import annotations

import math

import numpy as np

from rigidtop.figures import style as look
from rigidtop.figures.rotors import sense_of_turn
from rigidtop.figures.space import UPRIGHT, Scene, View, ring, unit
from rigidtop.figures.style import Floats, in_math, spoken
from rigidtop.figures.torque import torque
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.top import HeavyTop


def steady(top: HeavyTop, theta: float, omega3: float) -> TopMotion:
    """The slow steady precession, with e₃ leaning to the right in the yz plane."""
    rate, _ = top.steady_precession(theta, omega3)
    return top.motion(theta=theta, phi=math.pi / 2, phi_dot=rate, omega3=omega3)


def lean_of_momentum(motion: TopMotion) -> str:
    """Where L points, for a screen reader."""
    start = motion.start()
    cosine = float(unit(start.angular_momentum[0]) @ start.e3[0])
    outward, angle = cosine > 0, math.degrees(math.acos(min(1.0, abs(cosine))))
    return f"{'away from' if outward else 'towards'} O, {spoken(angle)} degrees from the axle"


def to_scale(motion: TopMotion, radius: float) -> tuple[float, float]:
    """R and the radius of the rotor (m) where the farthest point of it has the distance 1."""
    size = math.hypot(motion.body.R, radius)
    return motion.body.R / size, radius / size


def level(view: View, side: Floats) -> float:
    """The order of drawing of what lies on this side of the rotor: behind it, or before it."""
    return 4.2 if float(side @ view.axes[2]) > 0 else 1.6


def draw_axle(scene: Scene, motion: TopMotion, radius: float) -> None:
    """The axle, from the end that is held to a little beyond the rotor."""
    arm, half = to_scale(motion, radius)
    e3 = motion.start().e3[0]
    for ends, side in (((0.0, arm), -e3), ((arm, arm + 0.1 + 0.12 * half), e3)):
        order = level(scene.view, side) - 0.1
        line = np.outer(ends, e3)
        scene.line(line, color=look.NOTE, lw=2.6, solid_capstyle="round", zorder=order)
    scene.dot(np.zeros(3), ms=3.8)


def draw_arrows(scene: Scene, motion: TopMotion, radius: float) -> list[Floats]:
    """Mg, N, L, dL/dt and ω₃ at the start of a steady precession; points that must be seen.

    L and dL/dt begin at the centre of mass, N where the axle is held.  Dashed is the circle on
    which the tip of L goes, as seen from where L begins.
    """
    start, top, view = motion.start(), motion.body, scene.view
    arm, half = to_scale(motion, radius)
    e3, rate = start.e3[0], float(start.phi_dot[0])
    momentum, couple = unit(start.angular_momentum[0]), unit(torque(motion))
    centre = arm * e3
    outward = float(momentum @ e3) > 0
    tip = centre + (0.85 + 0.35 * half if outward else arm + 0.5) * momentum
    order = level(view, momentum)
    below = None if outward else (-2.0, -9.0)  # N is above
    scene.arrow(
        tip, look.L_VEC, start=centre, shift=below, color=look.MOMENTUM, lw=1.8, zorder=order
    )
    spin = centre + (0.3 + 0.27 * half) * e3
    turning = sense_of_turn(
        scene, spin, e3, 0.15, motion.omega[2], r"$\omega_3$", zorder=level(view, e3)
    )
    across = tip - centre - (tip - centre) * UPRIGHT
    distance, sweep = float(np.linalg.norm(across)), math.copysign(0.8, rate)
    way = ring(tip - across, UPRIGHT, distance, across, sweep)
    scene.line(way, color=look.OMEGA, lw=0.9, ls=look.DASHED, zorder=1.3, label="_way")
    beyond = tip + 0.5 * couple
    scene.arrow(beyond, start=tip, color=look.TORQUE, lw=1.4)
    if momentum[2] > -0.2:
        scene.words(
            beyond, look.L_DOT, (0, 4), color=look.TORQUE, ha="center", va="bottom", zorder=8
        )
    else:  # away from the axle, which is above
        scene.words(beyond, look.L_DOT, (-3, -3), color=look.TORQUE, ha="right", va="top", zorder=8)
    above = None if outward else (0.0, 9.0)
    scene.arrow(0.6 * couple, look.N_VEC, shift=above, color=look.TORQUE, lw=1.9, zorder=6)
    weight = centre - max(0.6, 1.2 * half) * UPRIGHT
    scene.arrow(weight, start=centre, color=look.INK, lw=1.5, zorder=6)
    scene.dot(centre)
    # The axle may be where the words are else.
    aside, side = (-5, "right") if e3[2] < -0.85 else (5, "left")
    words = f"$Mg = {in_math(top.M * top.g)}$ N"
    scene.words(weight, words, (aside, 0), color=look.INK, ha=side, zorder=8)
    return [tip, beyond, 0.7 * couple, weight, centre, *turning, *way]
