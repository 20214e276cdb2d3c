"""The gyroscope of introductory books: its arrows, and how good (3.52) is for it."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas

from rigidtop.derivations.exercises.bodies import simple_rate
from rigidtop.derivations.exercises.gyroscope import disc_on_axle, gyroscope, spin_for, spinning
from rigidtop.figures import style as look
from rigidtop.figures.axle import draw_arrows, draw_axle, lean_of_momentum, steady, to_scale
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.rotors import fit, sense_of_turn, solid_disc
from rigidtop.figures.solved import answers
from rigidtop.figures.space import UPRIGHT, Scene, View, arc, ring
from rigidtop.figures.style import Floats, canvas, degrees, in_math, name_at, said, spoken
from rigidtop.figures.torque import torque
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.rigid import SymmetricTop

VIEW = View(azimuth=-0.6, elevation=0.3)
"""From the side that is held: what points into the paper goes up and to the left."""

# --- The picture ---------------------------------------------------------------------------------


def draw_gyroscope(axes: Axes, motion: TopMotion, radius: float) -> None:
    """A disc of this radius (m) on its axle, with the arrows at the start of a motion.

    Axle and disc are to scale, arrows are not.
    """
    scene = Scene(axes, VIEW)
    arm, half = to_scale(motion, radius)
    e3 = motion.start().e3[0]
    height = height_of_post(float(motion.start().theta[0]), arm, half)
    post = np.outer([0.0, height], UPRIGHT)
    plate = ring(post[1], UPRIGHT, 0.28, VIEW.axes[0])
    scene.face(plate, fc=look.GROUND, ec=look.GREY, lw=0.7, zorder=0.5)
    scene.line(post, color=look.GREY, lw=3.2, solid_capstyle="butt", zorder=1)
    draw_axle(scene, motion, radius)
    solid_disc(scene, arm * e3, e3, half, 0.16 * half, zorder=2.5)
    _angle(scene, e3, 0.55 * arm)
    rim = ring(arm * e3, e3, half, VIEW.axes[2] + 0.1 * VIEW.axes[0])
    drawn = draw_arrows(scene, motion, radius)
    rate = float(motion.start().phi_dot[0])
    words = rf"$\Omega = {in_math(rate)}$ rad/s"
    around, left = 0.55 * post[1], rate > 0  # else L is there
    drawn += [*sense_of_turn(scene, around, UPRIGHT, 0.2, rate, words, left=left, zorder=3.5)]
    fit(scene, [*drawn, *rim, *plate], (0.25, 0.06, 0.02, 0.1))


def _angle(scene: Scene, e3: Floats, size: float) -> None:
    """θ, from the vertical through O to the axle."""
    scene.line(np.outer([0.0, 1.25 * size], UPRIGHT), color=look.GREY, lw=0.8, zorder=1)
    way = size * arc(UPRIGHT, e3)
    scene.line(way, color=look.GREY, lw=0.9, zorder=1, label="_theta")
    middle = 1.1 * way[len(way) // 2]
    scene.words(middle, r"$\theta$", ha="center", va="bottom", color=look.INK, zorder=8)
    scene.words(np.zeros(3), "$O$", (5, -9), color=look.INK, zorder=8)


def height_of_post(theta: float, arm: float, half: float) -> float:
    """Where the foot of the stand is: below, or above where the disc is in the way of a post.

    `arm` and `half` are R and the radius of the disc.
    """
    if theta > math.pi / 2 and arm * math.tan(math.pi - theta) < 1.2 * half:
        return 0.9
    return min(-0.7, arm * math.cos(theta) - half * math.sin(theta) - 0.12)


# --- Ω against ω₃ --------------------------------------------------------------------------------


def draw_simple_and_exact(
    axes: Axes, top: SymmetricTop, theta: float, omega3: float, tolerance: float
) -> None:
    """|Ω₋| of (3.57) and |Ω| of (3.52) against |ω₃|, a dot at the spin `omega3` (rad/s).

    A line marks the spin from which on the two differ by no more than the share `tolerance`.
    """
    least, needed, marked = top.smallest_spin(theta), spin_for(tolerance, top, theta), abs(omega3)
    last = max(1.3 * marked, 1.15 * needed if needed < 6 * marked else 0.0, 2.2 * least)
    first = max(least * (1 + 1e-12), 0.2 * marked)
    slowest = max(least * (1 + 1e-12), 0.6 * first)  # out at the top, unless there is a least spin
    spins = slowest + (last - slowest) * np.linspace(0.0, 1.0, 400) ** 2
    exact = np.array([top.steady_precession(theta, spin)[0] for spin in spins])
    from_zero = np.linspace(0.6 * first, last, 400)
    words = r"$MgR/(\lambda_3\omega_3)$"
    axes.plot(
        from_zero, simple_rate(top, from_zero), color=look.GREY, ls=look.DASHED, lw=1.1, label=words
    )
    axes.plot(spins, exact, color=look.FIRST, label=r"$\Omega_-$ of (3.57)")
    now = top.steady_precession(theta, marked)[0]
    axes.plot(marked, now, "o", color=look.FIRST, ms=4.5, label="_now")
    highest = 1.12 * max(top.steady_precession(theta, first)[0], 1.5 * now)
    axes.set(xlim=(0.6 * first, last), ylim=(0, highest))
    if least > 0.6 * first:
        axes.axvline(least, color=look.GREY, lw=0.9, ls=look.DOTTED, label="_least")
    if 0.6 * first < needed < last:
        axes.plot(
            [needed] * 2, [0, 0.45 * highest], color=look.SECOND, ls=look.DOTTED, label="_needed"
        )
        words, right = f"{100 * tolerance:.3g} % apart", needed > 0.6 * (first + last)
        aside, side = (-4, "right") if right else (4, "left")
        # Where the curves are not: above them, or below where they are steep.
        height = 0.4 if simple_rate(top, needed) < 0.3 * highest else 0.06
        name_at(axes, needed, height * highest, words, (aside, 0), ha=side, color=look.SECOND)
    axes.legend(loc="upper right", handlelength=2.2, borderaxespad=0.1)
    axes.set(xlabel=r"$|\omega_3|$  (rad/s)", ylabel=r"$|\Omega|$  (rad/s)")


# --- Together ------------------------------------------------------------------------------------


def _motion(M: float, radius: float, R: float, g: float, theta: float, omega3: float) -> TopMotion:
    spinning(omega3)
    return steady(disc_on_axle(M, radius, R, g), theta, omega3)


def _draw(tolerance: float, **values: float) -> Canvas:
    drawn = canvas(look.TEXT, 2.2)
    motion = _motion(**values)
    picture, chart = drawn.subplots(1, 2)
    draw_gyroscope(picture, motion, values["radius"])
    draw_simple_and_exact(chart, motion.body, values["theta"], values["omega3"], tolerance)
    return drawn


def _caption(tolerance: float, **values: float) -> str:
    motion = _motion(**values)
    found = answers(gyroscope, tolerance=tolerance, **values)
    momentum = float(np.linalg.norm(motion.start().angular_momentum[0]))
    couple = float(np.linalg.norm(torque(motion)))
    return (
        f"A gyroscope, a disc of {said(values['M'])} kg and radius {said(values['radius'])} m at "
        f"$R = {said(values['R'])}$ m from the end $O$ of its axle, at $θ = "
        f"{degrees(values['theta'])}$ and $ω₃ = {said(values['omega3'])}$ rad/s, with $g = "
        f"{said(values['g'])}$ m/s²: $L = {said(momentum)}$ J s, and the torque about $O$ of "
        f"{said(couple)} N m turns it {found['direction']}, as seen from above, at $Ω₋ = "
        f"{said(found['exact'])}$ rad/s, a turn in {said(found['period'])} s; dashed is the circle "
        "of the tip of $𝐋$. The curve: this rate against the spin; (3.52) gives "
        f"{said(found['simple'])} rad/s, and is "
        f"{_how_good(tolerance, found['spin_needed'])}.{_threshold(found['smallest_spin'])} "
        "Directions are computed, lengths of arrows are not to scale."
    )


def _how_good(tolerance: float, needed: float | str) -> str:
    if isinstance(needed, str):
        return "exact at $90°$"
    return f"off by no more than {said(100 * tolerance)} % from $|ω₃| = {said(needed)}$ rad/s on"


def _threshold(least: float | str) -> str:
    if isinstance(least, str):
        return " Any spin but 0 lets it go round steadily."
    if not least:
        return ""
    return f" Below {said(least)} rad/s it cannot go round steadily."


def _in_words(tolerance: float, **values: float) -> str:
    found = answers(gyroscope, tolerance=tolerance, **values)
    tilt = spoken(math.degrees(values["theta"]))
    momentum = lean_of_momentum(_motion(**values))
    return (
        f"A disc on an axle that is held at its other end O, {tilt} degrees from the upright. The "
        f"weight points down from the centre of the disc, and L points {momentum}. The torque "
        "N at O is horizontal, at right angles to the axle, and so is the change of L at its tip. "
        f"Seen from above it goes {found['direction']}. Beside it the rate of precession falls "
        f"with the spin, to {spoken(abs(found['exact']))} radians per second at a dot; a dashed "
        f"curve beside it, M g R over lambda3 omega3, is at {spoken(abs(found['simple']))} there."
    )


GYROSCOPE = Drawing(
    "gyroscope",
    "The gyroscope: torque, $L$ and precession; $Ω$ against $ω₃$",
    "",
    gyroscope.parameters,
    _draw,
    _caption,
    _in_words,
    motions=lambda tolerance, **values: (_motion(**values),),
)
