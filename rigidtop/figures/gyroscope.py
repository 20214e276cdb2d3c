"""The gyroscope of introductory books: its arrows, and how good (3.52) is for it."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.derivations.exercises.bodies import simple_rate
from rigidtop.derivations.exercises.gyroscope import disc_on_axle, gyroscope, spin_for, spinning
from rigidtop.figures import picture as pen
from rigidtop.figures import solids
from rigidtop.figures import style as look
from rigidtop.figures.axle import arrows, axle, facts_of_axle, steady, to_scale
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.solved import answers
from rigidtop.figures.space import UPRIGHT, View, arc, ring
from rigidtop.figures.style import Canvas, Floats, canvas, in_math
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.rigid import SymmetricTop

VIEW = View(azimuth=-0.6, elevation=0.3)
"""From the side that is held: what points into the paper goes up and to the left."""

# --- The picture ---------------------------------------------------------------------------------


def draw_gyroscope(axes: Axes, motion: TopMotion, radius: float) -> None:
    """A disc of this radius (m) on its axle, with the arrows at the start of a motion.

    Axle and disc are to scale, arrows are not.
    """
    arm, half = to_scale(motion, radius)
    start = motion.start()
    e3, rate = start.e3[0], float(start.phi_dot[0])
    foot = height_of_post(float(start.theta[0]), arm, half) * UPRIGHT
    plate = ring(foot, UPRIGHT, 0.28, VIEW.axes[0])
    rim = ring(arm * e3, e3, half, VIEW.axes[2] + 0.1 * VIEW.axes[0])
    words, left = rf"$\Omega = {in_math(rate)}$ rad/s", rate > 0  # else L is there
    turning = pen.Turning(0.55 * foot, UPRIGHT, 0.2, rate, words, left, z=3.5)
    pull, edge = arrows(VIEW, motion, radius)
    parts = [
        pen.Face(plate, look.GROUND, look.GREY, z=0.5),
        pen.Curve([pen.ORIGIN, foot], look.GREY, 3.2, z=1, cap="butt"),
        *axle(VIEW, motion, radius),
        *solids.disc(arm * e3, e3, half, 0.16 * half, z=2.5),
        *_angle(e3, 0.55 * arm),
        *pull,
        turning,
    ]
    pen.draw(axes, parts, VIEW)
    pen.fit(axes, VIEW, [*edge, *turning.points(VIEW), *rim, *plate], (0.25, 0.06, 0.02, 0.1))


def _angle(e3: Floats, size: float) -> list[pen.Part]:
    """θ, from the vertical through O to the axle."""
    way, style = size * arc(UPRIGHT, e3), {"color": look.GREY, "lw": 0.8, "z": 1}
    return [
        pen.guide([pen.ORIGIN, 1.25 * size * UPRIGHT]),
        *pen.angle(way, r"$\theta$", (0, 2), out=1.1, label="_theta", **style),
        pen.Words(pen.ORIGIN, "$O$", (5, -9)),
    ]


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
    now = top.steady_precession(theta, marked)[0]
    highest = 1.12 * max(top.steady_precession(theta, first)[0], 1.5 * now)
    simple, law = simple_rate(top, from_zero), r"$MgR/(\lambda_3\omega_3)$"
    parts: list[pen.Part] = [
        pen.Curve((from_zero, simple), look.GREY, 1.1, look.DASHED, label=law),
        pen.Curve((spins, exact), look.FIRST, 1.3, label=r"$\Omega_-$ of (3.57)"),
        pen.Mark((marked, now), look.FIRST, 4.5, label="_now"),
    ]
    if least > 0.6 * first:
        parts.append(pen.Rule(x=least, label="_least"))
    if 0.6 * first < needed < last:
        line, right = ([needed] * 2, [0, 0.45 * highest]), needed > 0.6 * (first + last)
        aside, side = ((-4, 0), "right") if right else ((4, 0), "left")
        # Where the curves are not: above them, or below where they are steep.
        height = 0.4 if simple_rate(top, needed) < 0.3 * highest else 0.06
        words = f"{100 * tolerance:.3g} % apart"
        parts.append(pen.Curve(line, look.SECOND, 1.3, look.DOTTED, label="_needed"))
        parts.append(pen.Words((needed, height * highest), words, aside, look.SECOND, side))
    limits = {"xlim": (0.6 * first, last), "ylim": (0, highest)}
    pen.chart(axes, parts, r"$|\omega_3|$  (rad/s)", r"$|\Omega|$  (rad/s)", **limits)
    axes.legend(loc="upper right", handlelength=2.2, borderaxespad=0.1)


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


def _facts(tolerance: float, **values: float) -> dict[str, Any]:
    facts = answers(gyroscope, tolerance=tolerance, **values) | facts_of_axle(_motion(**values))
    good = r"off by no more than {tolerance:%} % from $|\omega_3| = {spin_needed}$ rad/s on"
    least = "Below {smallest_spin} rad/s it cannot go round steadily."
    if isinstance(facts["smallest_spin"], str):
        least = "Any spin but 0 lets it go round steadily."
    return facts | {
        "good": r"exact at $90^\circ$" if isinstance(facts["spin_needed"], str) else good,
        "threshold": f" {least}" if facts["smallest_spin"] else "",
        "rate": abs(facts["exact"]),
        "by_formula": abs(facts["simple"]),
    }


GYROSCOPE = Drawing(
    "gyroscope",
    r"The gyroscope: torque, $L$ and precession; $\Omega$ against $\omega_3$",
    "",
    gyroscope.parameters,
    _draw,
    "A gyroscope, a disc of {M} kg and radius {radius} m at $R = {R}$ m from the end $O$ of its "
    r"axle, at $\theta = {theta:°}$ and $\omega_3 = {omega3}$ rad/s, with $g = {g}$ m/s²: "
    "$L = {L}$ J s, and the torque about $O$ of {N} N m turns it {direction}, as seen from above, "
    r"at $\Omega_- = {exact}$ rad/s, a turn in {period} s; dashed is the circle of the tip of "
    r"$\mathbf L$. The curve: this rate against the spin; (3.52) gives {simple} rad/s, and is "
    "{good}.{threshold} Directions are computed, lengths of arrows are not to scale.",
    "A disc on an axle that is held at its other end O, {theta:°} degrees from the upright. The "
    "weight points down from the centre of the disc, and L points {side} O, {aslant:°} degrees "
    "from the axle. The torque N at O is horizontal, at right angles to the axle, and so is the "
    "change of L at its tip. Seen from above it goes {direction}. Beside it the rate of precession "
    "falls with the spin, to {rate} radians per second at a dot; a dashed curve beside it, M g R "
    "over lambda3 omega3, is at {by_formula} there.",
    _facts,
    motions=lambda tolerance, **values: (_motion(**values),),
)
