"""A rotor whose axle is held at one end, in steady precession: the arrows at its start."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.space import UPRIGHT, View, ring, unit
from rigidtop.figures.style import Floats, in_math
from rigidtop.figures.torque import torque
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.top import HeavyTop


def steady(top: HeavyTop, theta: float, omega3: float) -> TopMotion:
    """The slow steady precession, with e₃ leaning to the right in the yz plane."""
    rate, _ = top.steady_precession(theta, omega3)
    return top.motion(theta=theta, phi=math.pi / 2, phi_dot=rate, omega3=omega3)


def facts_of_axle(motion: TopMotion) -> dict[str, Any]:
    """L (J s), N (N m) and where L points, in {side} and {aslant} (rad)."""
    start = motion.start()
    momentum = start.angular_momentum[0]
    cosine = float(unit(momentum) @ start.e3[0])
    return {
        "L": float(np.linalg.norm(momentum)),
        "N": float(np.linalg.norm(torque(motion))),
        "side": "away from" if cosine > 0 else "towards",
        "aslant": math.acos(min(1.0, abs(cosine))),
    }


def to_scale(motion: TopMotion, radius: float) -> tuple[float, float]:
    """R and the radius of the rotor (m) where the farthest point of it has the distance 1."""
    size = math.hypot(motion.body.R, radius)
    return motion.body.R / size, radius / size


def level(view: View, side: Floats) -> float:
    """The order of drawing of what lies on this side of the rotor: behind it, or before it."""
    return 4.2 if float(side @ view.axes[2]) > 0 else 1.6


def axle(view: View, motion: TopMotion, radius: float) -> list[pen.Part]:
    """The axle, from the end that is held to a little beyond the rotor."""
    arm, half = to_scale(motion, radius)
    e3 = motion.start().e3[0]
    pieces = ((0.0, arm), -e3), ((arm, arm + 0.1 + 0.12 * half), e3)
    return [
        *(
            pen.Curve(np.outer(ends, e3), look.NOTE, 2.6, z=level(view, side) - 0.1, cap="round")
            for ends, side in pieces
        ),
        pen.Mark(pen.ORIGIN, size=3.8),
    ]


def arrows(view: View, motion: TopMotion, radius: float) -> tuple[list[pen.Part], list[Floats]]:
    """Mg, N, L, dL/dt and ω₃ at the start of a steady precession; points that must be seen.

    L and dL/dt begin at the centre of mass, N where the axle is held.  Dashed is the circle on
    which the tip of L goes, as seen from where L begins.
    """
    start, top = motion.start(), motion.body
    arm, half = to_scale(motion, radius)
    e3, rate = start.e3[0], float(start.phi_dot[0])
    momentum, couple = unit(start.angular_momentum[0]), unit(torque(motion))
    centre, spin = arm * e3, (arm + 0.3 + 0.27 * half) * e3
    outward = float(momentum @ e3) > 0  # else N is above L
    tip = centre + (0.85 + 0.35 * half if outward else arm + 0.5) * momentum
    turning = pen.Turning(spin, e3, 0.15, motion.omega[2], r"$\omega_3$", z=level(view, e3))
    across = (tip - centre) * [1.0, 1.0, 0.0]
    distance, sweep = float(np.linalg.norm(across)), math.copysign(0.8, rate)
    way = ring(tip - across, UPRIGHT, distance, across, sweep)
    beyond, weight = tip + 0.5 * couple, centre - max(0.6, 1.2 * half) * UPRIGHT
    # Away from the axle, which may be where the words are else.
    change = ((0, 4), "center", "bottom") if momentum[2] > -0.2 else ((-3, -3), "right", "top")
    aside, side = ((-5, 0), "right") if e3[2] < -0.85 else ((5, 0), "left")
    below, above = (None, None) if outward else ((-2.0, -9.0), (0.0, 9.0))
    parts = [
        pen.Arrow(tip, look.L_VEC, look.MOMENTUM, 1.8, centre, below, level(view, momentum)),
        turning,
        pen.Curve(way, look.OMEGA, 0.9, look.DASHED, 1.3, label="_way"),
        pen.Arrow(beyond, "", look.TORQUE, start=tip),
        pen.Words(beyond, look.L_DOT, change[0], look.TORQUE, *change[1:]),
        pen.Arrow(0.6 * couple, look.N_VEC, look.TORQUE, 1.9, shift=above, z=6),
        pen.Arrow(weight, lw=1.5, start=centre, z=6),
        pen.Mark(centre),
        pen.Words(weight, f"$Mg = {in_math(top.M * top.g)}$ N", aside, ha=side),
    ]
    edge = [tip, beyond, 0.7 * couple, weight, centre, *turning.points(view), *way]
    return parts, edge
