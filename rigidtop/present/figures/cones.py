"""The cones on which e₃, ω and L of a free symmetric body go round each other."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas

from rigidtop.motion.body import FreeBody
from rigidtop.motion.motion import Motion
from rigidtop.parameters import Parameter
from rigidtop.present.figures.drawing import Drawing
from rigidtop.present.figures.space import View, arrow, circle, curve, paper, unit
from rigidtop.present.figures.style import (
    AXIS,
    E3,
    L_VEC,
    MOMENTUM,
    OMEGA,
    OMEGA_VEC,
    WIDE,
    Floats,
    canvas,
    said,
    spoken,
)

BODY = (
    Parameter("lambda1", 1.0, "moment across the axis", "kg m²", above=0),
    Parameter("lambda3", 0.55, "moment about the axis", "kg m²", above=0),
    Parameter("omega_0", 0.45, "magnitude of ω across the axis", "rad/s", above=0),
    Parameter("omega3", 1.0, "ω₃", "rad/s", above=0),
)


def free_motion(lambda1: float, lambda3: float, omega_0: float, omega3: float) -> Motion:
    """(3.38) at t = 0: ω = (ω₀, 0, ω₃)."""
    return FreeBody(lambda1, lambda1, lambda3).motion(omega=(omega_0, 0.0, omega3))


def three_directions(motion: Motion, *, space: bool) -> tuple[Floats, Floats, Floats]:
    """e₃, ω and L as unit vectors at t = 0, in the plane of the paper (yz), to the left of ẑ.

    In the body frame e₃ is along ẑ, in the space frame L.
    """
    start = motion.start()
    e3, omega, momentum = start.e3[0], unit(start.omega_space[0]), unit(start.angular_momentum[0])
    upright = momentum if space else e3
    # Left is where ω and L lean from e₃, and e₃ from L.
    away = e3 if space else momentum
    left = unit(away - (away @ upright) * upright)
    frame = np.array([np.cross(-left, upright), -left, upright])
    first, second, third = (frame @ vector for vector in (e3, omega, momentum))
    return first, second, third


def draw_cones(axes: Axes, motion: Motion, *, space: bool) -> None:
    """The cones of a free symmetric body, and the three arrows in one plane.

    In the body frame ω and L go round e₃; in the space frame ω and e₃ go round L.
    """
    view = View()
    directions = three_directions(motion, space=space)
    upright = directions[2 if space else 0]
    drawn = ((E3, AXIS, 1.0), (OMEGA_VEC, OMEGA, 1.06), (L_VEC, MOMENTUM, 1.18))
    for direction, (_, color, length) in zip(directions, drawn, strict=True):
        angle = math.atan2(
            float(np.linalg.norm(np.cross(upright, direction))), float(upright @ direction)
        )
        if angle > 1e-9:
            rim = circle(upright, angle, length=length)
            _, _, near = view(rim)
            curve(axes, view, rim, near < near.mean(), color=color, lw=0.9)
            shade(axes, view, rim, color, 0.12 if color == OMEGA else 0.05)
    for direction, (words, color, length) in zip(directions, drawn, strict=True):
        arrow(axes, view, length * direction, words, color=color, lw=1.5)
    paper(axes, (-1.0, 1.0), (-0.03, 1.3))


def shade(axes: Axes, view: View, rim: Floats, color: str, alpha: float) -> None:
    """The mantle of a cone from the origin to its rim (N, 3), with its two edges."""
    across, up, _ = view(rim)
    axes.fill(np.append(across, 0.0), np.append(up, 0.0), color=color, alpha=alpha, lw=0, zorder=1)
    turn = np.unwrap(np.arctan2(across, up))
    if np.ptp(turn) < math.pi:  # else the eye looks into it, and there is no edge
        for i in (int(np.argmax(turn)), int(np.argmin(turn))):
            axes.plot([0, across[i]], [0, up[i]], color=color, lw=0.6, alpha=0.7, zorder=2)


def _cones(**values: float) -> Canvas:
    drawn = canvas(WIDE, 2.8)
    motion = free_motion(**values)
    left, right = drawn.subplots(1, 2)
    draw_cones(left, motion, space=False)
    draw_cones(right, motion, space=True)
    in_body, in_space = _rates(motion)
    left.set_title(rf"body frame: $\Omega_b = {in_body:.3g}$ rad/s")
    right.set_title(rf"space frame: $\Omega_s = L/\lambda_1 = {in_space:.3g}$ rad/s")
    return drawn


def _rates(motion: Motion) -> tuple[float, float]:
    """Ω_b of (3.40), and Ω_s: how fast the plane turns in the body and in space."""
    lambda1, _, lambda3 = motion.body.moments
    return (lambda1 - lambda3) * motion.omega[2] / lambda1, motion.mean_precession


def _shape(lambda1: float, lambda3: float) -> str:
    relation = ">" if lambda1 > lambda3 else "<" if lambda1 < lambda3 else "="
    return f"λ₁ = {said(lambda1)} {relation} λ₃ = {said(lambda3)} kg m²"


def _cones_caption(lambda1: float, lambda3: float, omega_0: float, omega3: float) -> str:
    in_body, in_space = _rates(free_motion(lambda1, lambda3, omega_0, omega3))
    return (
        f"The cones of a free symmetric body with {_shape(lambda1, lambda3)}, "
        f"ω₀ = {said(omega_0)} and ω₃ = {said(omega3)} rad/s. Left: in the body frame ω and L go "
        f"round e₃ at Ω_b = {said(in_body)} rad/s. Right: in the space frame L stands still, and "
        f"the plane of the three turns about it at Ω_s = {said(in_space)} rad/s."
    )


def _cones_in_words(lambda1: float, lambda3: float, omega_0: float, omega3: float) -> str:
    motion = free_motion(lambda1, lambda3, omega_0, omega3)
    e3, omega, momentum = three_directions(motion, space=False)
    tilt = math.degrees(math.acos(min(1.0, float(e3 @ omega))))
    lean = math.degrees(math.acos(min(1.0, float(e3 @ momentum))))
    return (
        "Two drawings of three arrows from one point, always in one plane. In the body frame the "
        f"arrow e3 stands upright and the tips of omega and of L, {spoken(tilt)} and "
        f"{spoken(lean)} degrees from it, go round it on circles. In the space frame L stands "
        "upright, omega and e3 go round it."
    )


CONES = Drawing(
    "cones",
    "The cones of a free symmetric body, in the body frame and in space",
    "3.2.3",
    BODY,
    _cones,
    _cones_caption,
    _cones_in_words,
)
