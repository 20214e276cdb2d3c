"""The torque of the weight, and where it moves the angular momentum (sections 3.5.1 and 3.5.2)."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes

from rigidtop.errors import NoSteadyPrecession
from rigidtop.figures import style as look
from rigidtop.figures.bodies import TOP, start_in_words, top_in_words
from rigidtop.figures.drawing import Drawing, one
from rigidtop.figures.space import Scene, View, circle, paper, table, top_body, unit
from rigidtop.figures.style import Floats, alone, said, spoken
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter

VIEW = View(azimuth=-0.3, elevation=0.42)
"""So that what points into the paper goes up and to the left."""


def torque(motion: TopMotion) -> Floats:
    """N = R_CM × (−Mgẑ) at the start (3.49), space components (3,), N m."""
    top = motion.body
    centre = top.R * motion.start().e3[0]
    return np.cross(centre, [0.0, 0.0, -top.M * top.g])


def direction_of_torque(motion: TopMotion) -> Floats:
    """N as a unit vector; zero for a top that is upright or hangs, to rounding."""
    found, top = torque(motion), motion.body
    vertical = float(np.linalg.norm(found)) <= 1e-12 * top.M * top.g * top.R
    return np.zeros(3) if vertical else unit(found)


def draw_torque(axes: Axes, motion: TopMotion) -> None:
    """R_CM, Mg, N, L and ω of a top at the start of a motion; each has a length of its own.

    The circle is that on which the tip of L goes in a steady precession.
    """
    start = motion.start()
    e3, momentum, omega = start.e3[0], unit(start.angular_momentum[0]), unit(start.omega_space[0])
    couple = direction_of_torque(motion)
    scene, centre = Scene(axes, VIEW), 0.62 * e3
    lean = math.acos(float(np.clip(e3[2], -1, 1)))
    half = 0.37
    if lean < 1.3:  # above the table, which it does not touch but with its tip
        table(scene, 0.62)
        half = min(half, 0.8 * (math.pi / 2 - lean))
    top_body(scene, e3, 0.78, 0.78 * math.tan(half))
    length = 1.42
    tilt = math.acos(float(np.clip(momentum[2], -1, 1)))
    rim = circle([0.0, 0.0, 1.0], tilt, length=length)
    scene.ring(rim, color=look.MOMENTUM, lw=0.9, ls=look.DASHED)
    scene.arrow([0, 0, 1.95], look.Z, lw=0.8, color=look.GREY, shift=(7, 2))
    scene.arrow(centre, start=(0, 0, 0), color=look.INK, lw=2.0)
    scene.arrow(1.05 * e3, look.E3, color=look.AXIS, lw=1.0, shift=(9, 0))
    scene.arrow(length * momentum, look.L_VEC, color=look.MOMENTUM, lw=1.7, shift=(9, 2))
    scene.arrow(1.2 * omega, look.OMEGA_VEC, color=look.OMEGA, lw=1.7, shift=(9, -3))
    scene.couple(0.95 * couple, (-6, -10), ha="right")
    if np.any(couple):
        beyond = length * momentum + 0.42 * couple
        scene.arrow(beyond, start=length * momentum, color=look.TORQUE, lw=1.2)
        scene.words(beyond, look.L_DOT, (2, 4), color=look.TORQUE, ha="center")
    scene.arrow(centre - [0, 0, 0.46], start=centre, color=look.INK, lw=1.4)
    scene.words(centre - [0, 0, 0.46], look.WEIGHT, (6, 2), color=look.INK)
    scene.dot(centre)
    scene.words(centre, look.R_CM, (6, -8), color=look.INK, zorder=8)
    scene.words([0.0, 0.0, 0.0], "$O$", (5, -10), color=look.INK)
    paper(axes, (-1.45, 1.7), (min(-0.3, 1.6 * e3[2] - 0.4), 1.92))


def _motion(theta: float, omega3: float, **top: float) -> TopMotion:
    """With e₃ leaning to the right in the plane of the paper, the yz plane.

    Steady and slow; where there is no steady precession, let go with ω along e₃.
    """
    body = HeavyTop(**top)
    try:
        rate, _ = body.steady_precession(theta, omega3)
    except NoSteadyPrecession:
        rate = 0.0
    return body.motion(theta=theta, phi=math.pi / 2, phi_dot=rate, omega3=omega3)


def _caption(theta: float, omega3: float, **top: float) -> str:
    motion = _motion(theta, omega3, **top)
    size = float(np.linalg.norm(torque(motion)))
    steady = motion.start().phi_dot[0]
    goes = (
        f"the top goes round at {said(steady)} rad/s, its exact slow rate"
        if steady
        else "$𝛚$ is along $e₃$ at first"
    )
    where = "it points into the paper, and the tip of $𝐋$ follows it round $ẑ$"
    if not np.any(direction_of_torque(motion)):
        where = "on the vertical there is none"
    return (
        "The torque $𝐍 = 𝐑_CM × M𝐠$ of the weight, with $e₃$ leaning to the right in the plane of "
        f"the paper: {where}. At {start_in_words(theta, omega3)}, with "
        f"{top_in_words(motion.body)}, its magnitude is {said(size)} N m, and {goes}. Directions "
        "are computed, lengths are not to one scale."
    )


def _in_words(**values: float) -> str:
    motion = _motion(**values)
    into_the_eye = direction_of_torque(motion)[0]
    start = motion.start()
    momentum = unit(start.angular_momentum[0])
    lean = math.degrees(math.acos(float(np.clip(momentum @ start.e3[0], -1, 1))))
    seen = (
        "A top on a table, its axis e3 leaning to the right. From the contact point O the arrows "
        f"e3, omega and L, L {spoken(lean)} degrees from e3. The weight points down from the "
        "centre of mass. "
    )
    if not into_the_eye:
        return seen + "There is no torque, as the axis is vertical."
    into = "into" if into_the_eye < 0 else "out of"
    return (
        f"{seen}The torque N points horizontally {into} the paper, at right angles to "
        "e3 and to z, and so does the change of L at its tip, along a dashed circle around z."
    )


TORQUE_ARROWS = Drawing(
    "torque",
    "The torque of the weight, $𝐋$ and $𝛚$: into the paper",
    "3.5.2",
    (
        *TOP,
        Parameter("theta", math.pi / 4, "$θ$", "rad", least=0, most=math.pi),
        Parameter("omega3", 30.0, "$ω₃$", "rad/s", above=0),
    ),
    alone(2.75, lambda axes, **values: draw_torque(axes, _motion(**values))),
    _caption,
    _in_words,
    motions=one(_motion),
)
