"""The torque of the weight, and where it moves the angular momentum (sections 3.5.1 and 3.5.2)."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas

from rigidtop.motion.motion import TopMotion
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter
from rigidtop.present.figures.bodies import TOP, start_in_words, top_in_words
from rigidtop.present.figures.drawing import Drawing
from rigidtop.present.figures.space import (
    View,
    arrow,
    circle,
    curve,
    paper,
    table,
    top_body,
    unit,
)
from rigidtop.present.figures.style import (
    AXIS,
    COLUMN,
    DASHED,
    E3,
    GREY,
    INK,
    L_VEC,
    MOMENTUM,
    OMEGA,
    OMEGA_VEC,
    TORQUE,
    Floats,
    Z,
    canvas,
    name_at,
    said,
    spoken,
)

VIEW = View(azimuth=-0.3, elevation=0.42)
"""So that what points into the paper goes up and to the left."""


def torque(motion: TopMotion) -> Floats:
    """N = R_CM × (−Mgẑ) at the start (3.49), space components (3,), N m."""
    top = motion.body
    centre = top.R * motion.start().e3[0]
    return np.cross(centre, [0.0, 0.0, -top.M * top.g])


def draw_torque(axes: Axes, motion: TopMotion) -> None:
    """R_CM, Mg, N, L and ω of a top at the start of a motion; each has a length of its own.

    The circle is that on which the tip of L goes in a steady precession.
    """
    start = motion.start()
    e3, momentum, omega = start.e3[0], unit(start.angular_momentum[0]), unit(start.omega_space[0])
    couple = unit(torque(motion))
    view, centre = VIEW, 0.62 * e3
    lean = math.acos(float(np.clip(e3[2], -1, 1)))
    if lean < 1.2:
        table(axes, view, 0.62)
    half = min(0.37, 0.8 * max(math.pi / 2 - lean, 0.12))
    top_body(axes, view, e3, 0.78, 0.78 * math.tan(half))
    length = 1.42
    tilt = math.acos(float(np.clip(momentum[2], -1, 1)))
    rim = circle([0.0, 0.0, 1.0], tilt, length=length)
    _, _, near = view(rim)
    curve(axes, view, rim, near < near.mean(), color=OMEGA, lw=0.9, ls=DASHED)
    arrow(axes, view, [0, 0, 1.72], Z, lw=0.8, color=GREY, shift=(7, 2))
    arrow(axes, view, centre, start=(0, 0, 0), color=INK, lw=2.0)
    arrow(axes, view, 1.62 * e3, E3, color=AXIS, lw=1.0, shift=(9, 0))
    arrow(axes, view, length * momentum, L_VEC, color=MOMENTUM, lw=1.7, shift=(9, 2))
    arrow(axes, view, 1.2 * omega, OMEGA_VEC, color=OMEGA, lw=1.7, shift=(9, -3))
    arrow(axes, view, 0.95 * couple, r"$\mathbf{N}$", color=TORQUE, lw=1.9)
    # L̇ = N: the tip of L moves with the torque.
    tip = length * momentum
    arrow(axes, view, tip + 0.42 * couple, start=tip, color=TORQUE, lw=1.2, ls="-")
    beyond = tip + 0.42 * couple
    x, y, _ = view(beyond)
    name_at(
        axes,
        float(x),
        float(y),
        r"$\dot{\mathbf{L}}=\mathbf{N}$",
        (2, 4),
        color=TORQUE,
        ha="center",
    )
    arrow(axes, view, centre - [0, 0, 0.46], start=centre, color=INK, lw=1.4)
    x, y, _ = view(centre - [0, 0, 0.46])
    name_at(axes, float(x), float(y), r"$M\mathbf{g}$", (6, 2), color=INK)
    x, y, _ = view(centre)
    axes.plot(x, y, "o", color=INK, ms=3.5, zorder=7)
    name_at(axes, float(x), float(y), r"$\mathbf{R}_\mathrm{CM}$", (7, -9), color=INK, zorder=8)
    x, y, _ = view([0.0, 0.0, 0.0])
    name_at(axes, float(x), float(y), "$O$", (5, -10), color=INK)


def _motion(theta: float, omega3: float, **top: float) -> TopMotion:
    """Steady, slow, with e₃ leaning to the right in the plane of the paper, the yz plane."""
    body = HeavyTop(**top)
    slow, _ = body.steady_precession(theta, omega3)
    return body.motion(theta=theta, phi=math.pi / 2, phi_dot=slow, omega3=omega3)


def _draw(**values: float) -> Canvas:
    drawn = canvas(COLUMN, 2.75)
    axes = drawn.subplots()
    draw_torque(axes, _motion(**values))
    low = min(-0.3, 1.75 * math.cos(values["theta"]))
    paper(axes, (-1.45, 1.7), (low, 1.7))
    return drawn


def _caption(theta: float, omega3: float, **top: float) -> str:
    motion = _motion(theta, omega3, **top)
    size = float(np.linalg.norm(torque(motion)))
    rate = motion.start().phi_dot[0]
    return (
        "The torque N = R_CM × Mg of the weight, with e₃ leaning to the right in the plane of the "
        f"paper: it points into the paper, and the tip of L follows it round ẑ. At "
        f"{start_in_words(theta, omega3)}, with {top_in_words(motion.body)}, its magnitude is "
        f"{said(size)} N m, and Ω₋ = {said(rate)} rad/s. Directions are computed, lengths are not "
        "to one scale."
    )


def _in_words(**values: float) -> str:
    motion = _motion(**values)
    into_the_eye = unit(torque(motion))[0]
    start = motion.start()
    momentum = unit(start.angular_momentum[0])
    lean = math.degrees(math.acos(float(np.clip(momentum @ start.e3[0], -1, 1))))
    into = "into" if into_the_eye < 0 else "out of"
    return (
        "A top on a table, its axis e3 leaning to the right. From the contact point O the arrows "
        f"e3, omega and L, L {spoken(lean)} degrees from e3. The weight points down from the "
        f"centre of mass. The torque N points horizontally {into} the paper, at right angles to "
        "e3 and to z, and so does the change of L at its tip, along a dashed circle around z."
    )


TORQUE_ARROWS = Drawing(
    "torque",
    "The torque of the weight, L and ω: into the paper",
    "3.5.2",
    (
        *TOP,
        Parameter("theta", math.pi / 4, "θ", "rad", above=0, most=3.1415),
        Parameter("omega3", 24.5, "ω₃", "rad/s", above=0),
    ),
    _draw,
    _caption,
    _in_words,
)
