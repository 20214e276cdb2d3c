"""A bicycle wheel whose horizontal axle hangs on a cord at one end."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes

from rigidtop.derivations.exercises.gyroscope import (
    bicycle_wheel,
    hoop_on_axle,
    slope_of_cord,
    spinning,
)
from rigidtop.figures import style as look
from rigidtop.figures.axle import draw_arrows, draw_axle, lean_of_momentum, steady, to_scale
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.rotors import fit, sense_of_turn
from rigidtop.figures.solved import answers
from rigidtop.figures.space import UPRIGHT, Scene, View, ring
from rigidtop.figures.style import Floats, alone, degrees, in_math, said, spoken
from rigidtop.figures.torque import torque
from rigidtop.motion.motion import TopMotion

VIEW = View(azimuth=-0.36, elevation=0.3)
"""Nearly along the wheel, which would else hide its cord."""

SPOKES = 18

LONGEST = 1.3
"""Of the cord as it is drawn, where the rim is at the distance 1 from its lower end."""


def draw_wheel(axes: Axes, motion: TopMotion, radius: float, cord: float) -> None:
    """A wheel of this radius (m) on its axle and on a cord of this length (m), with the arrows.

    Wheel, axle and the lean of the cord are to scale, arrows are not; a long cord is cut off.
    """
    scene = Scene(axes, VIEW)
    arm, half = to_scale(motion, radius)
    start, top = motion.start(), motion.body
    e3, rate = start.e3[0], float(start.phi_dot[0])
    slope = slope_of_cord(rate, top.R, cord, top.g)
    # From the end of the axle up, and in towards the vertical about which all goes round.
    along = np.array([0.0, -slope, 1.0]) / math.hypot(1.0, slope)
    whole = cord / math.hypot(top.R, radius)
    upper = min(whole, LONGEST) * along
    scene.line([np.zeros(3), upper], color=look.NOTE, lw=1.1, zorder=5, label="_cord")
    _end_of_cord(scene, upper, cut=whole > LONGEST)
    draw_axle(scene, motion, radius)
    centre = arm * e3
    rim = ring(centre, e3, half, VIEW.axes[2] + 0.1 * VIEW.axes[0])
    for point in ring(centre, e3, half, UPRIGHT, count=SPOKES + 1)[:-1]:
        scene.line([centre, point], color=look.GREY, lw=0.6, zorder=2.2)
    scene.line(rim, color=look.INK, lw=3.4, zorder=2.4, label="_rim")
    scene.line(rim, color=look.MANTLE, lw=1.6, zorder=2.5)
    drawn = draw_arrows(scene, motion, radius)
    around = _sense(scene, upper, rate)
    fit(scene, [*drawn, *rim, *around, 1.05 * upper], (0.2, 0.06, 0.05, 0.02))


def _sense(scene: Scene, upper: Floats, rate: float) -> Floats:
    """Ω about the vertical, beside a cord that ends at `upper`, or above a short one."""
    words = rf"$\Omega = {in_math(rate)}$ rad/s"
    middle = 0.8 * upper
    leans = abs(upper[1]) > 0.5 * upper[2]
    if np.linalg.norm(upper) < 0.6:
        middle = 0.7 * UPRIGHT
        axis = np.outer([0.0, 0.9], UPRIGHT)
        scene.line(axis, color=look.GREY, lw=0.8, ls=look.DOTTED, zorder=1)
        leans = False
    if leans:  # the cord is where the words would be
        scene.words(middle, words, (0, 9), color=look.OMEGA, ha="center", zorder=8)
        words = ""
    return sense_of_turn(scene, middle, UPRIGHT, 0.17, rate, words, left=True, zorder=3.5)


def _end_of_cord(scene: Scene, upper: Floats, *, cut: bool) -> None:
    """Where it is fixed, or a stroke through it where it goes on."""
    if cut:
        scene.line(upper, marker=(2, 0, 60), ms=9, color=look.NOTE, mew=1.0, zorder=5)
    else:
        scene.line(upper, "s", ms=5, color=look.GREY, zorder=5)
    scene.words(np.zeros(3), "$O$", (-4, -10), color=look.INK, ha="right", zorder=8)


def _motion(M: float, radius: float, R: float, g: float, omega3: float) -> TopMotion:
    spinning(omega3)
    return steady(hoop_on_axle(M, radius, R, g), math.pi / 2, omega3)


def _draw(axes: Axes, cord: float, **values: float) -> None:
    draw_wheel(axes, _motion(**values), values["radius"], cord)


def _caption(cord: float, **values: float) -> str:
    motion = _motion(**values)
    found = answers(bicycle_wheel, cord=cord, **values)
    momentum = float(np.linalg.norm(motion.start().angular_momentum[0]))
    couple = float(np.linalg.norm(torque(motion)))
    return (
        f"A bicycle wheel of {said(values['M'])} kg and radius {said(values['radius'])} m at $R = "
        f"{said(values['R'])}$ m from the end $O$ of its horizontal axle, with $ω₃ = "
        f"{said(values['omega3'])}$ rad/s and $g = {said(values['g'])}$ m/s²: $L = "
        f"{said(momentum)}$ J s, and the torque about $O$, $N = {said(couple)}$ N m, turns it "
        f"{found['direction']}, as seen from above, at $Ω = {said(found['precession'])}$ rad/s, a "
        f"turn in {said(found['period'])} s. The cord of {said(cord)} m, drawn "
        f"shorter, pulls with {said(found['tension'])} N and leans by {degrees(found['lean'])}. "
        "Dashed: the circle of the tip of $𝐋$. Directions are computed, lengths of "
        "arrows are not to scale."
    )


def _in_words(cord: float, **values: float) -> str:
    found = answers(bicycle_wheel, cord=cord, **values)
    momentum = lean_of_momentum(_motion(**values))
    return (
        "A wheel with spokes, seen aslant, on a horizontal axle; a cord that leans by "
        f"{spoken(math.degrees(found['lean']))} degrees holds it at one end, O. The weight points "
        f"down from the hub, L points {momentum}. The torque N at O is horizontal and points into "
        "the paper, and so does the change of L at its tip. Seen from above the wheel goes "
        f"{found['direction']}: the tip of L into the paper."
    )


BICYCLE_WHEEL = Drawing(
    "bicycle-wheel",
    "The bicycle wheel on a cord: weight, torque and the change of $L$",
    "",
    bicycle_wheel.parameters,
    alone(2.9, _draw),
    _caption,
    _in_words,
    motions=lambda cord, **values: (_motion(**values),),
)
