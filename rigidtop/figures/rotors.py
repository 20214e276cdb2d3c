"""Rotors on an axle that is held at one end: a gyroscope, and a bicycle wheel on a cord."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.derivations.exercises import gyroscope as exercise
from rigidtop.derivations.exercises.bodies import simple_rate
from rigidtop.figures import picture as pen
from rigidtop.figures import solids
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.solved import answers
from rigidtop.figures.space import UPRIGHT, View, arc, circle, ring, unit
from rigidtop.figures.style import Floats, in_math
from rigidtop.figures.tops import torque
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.rigid import SymmetricTop
from rigidtop.motion.top import HeavyTop

# --- A rotor whose axle is held at one end, in steady precession ---------------------------------


def steady(top: HeavyTop, theta: float, omega3: float) -> TopMotion:
    """The slow steady precession, with e₃ leaning to the right in the yz plane."""
    exercise.spinning(omega3)
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


@dataclass
class Rotor:
    """The start of a steady precession, seen from a `view`; the rotor has a `radius` (m).

    Lengths are to scale where the farthest point of the rotor has the distance 1.
    """

    motion: TopMotion
    radius: float
    view: View

    def __post_init__(self) -> None:
        """Its size (m), arm and half are the distance of the farthest point, and R and the radius
        to scale; e3 is along the axle, and the rate Ω in rad/s."""
        start, arm = self.motion.start(), self.motion.body.R
        self.size = math.hypot(arm, self.radius)
        self.arm, self.half = arm / self.size, self.radius / self.size
        self.e3, self.rate = unit(start.e3[0]), float(start.phi_dot[0])

    def level(self, side: Floats) -> float:
        """The order of drawing of what lies on this side of it: behind it, or before it."""
        return 4.2 if float(side @ self.view.axes[2]) > 0 else 1.6

    def axle(self) -> list[pen.Part]:
        """The axle, from the end that is held to a little beyond the rotor."""
        end = self.arm + 0.1 + 0.12 * self.half
        pieces = ((0.0, self.arm), -self.e3), ((self.arm, end), self.e3)
        lines = [(np.outer(ends, self.e3), self.level(side) - 0.1) for ends, side in pieces]
        axle = [pen.Curve(line, look.NOTE, 2.6, z=z, cap="round") for line, z in lines]
        return [*axle, pen.Markers(pen.ORIGIN, size=3.8)]

    def arrows(self) -> list[pen.Part]:
        """Mg, N, L, dL/dt and ω₃.

        L and dL/dt begin at the centre of mass, N where the axle is held.  Dashed is the circle on
        which the tip of L goes, as seen from where L begins.
        """
        e3, arm, half, top = self.e3, self.arm, self.half, self.motion.body
        momentum = unit(self.motion.start().angular_momentum[0])
        couple, omega3 = unit(torque(self.motion)), self.motion.omega[2]
        centre, spin = arm * e3, (arm + 0.3 + 0.27 * half) * e3
        outward = float(momentum @ e3) > 0  # else N is above L
        tip = centre + (0.85 + 0.35 * half if outward else arm + 0.5) * momentum
        across = (tip - centre) * [1.0, 1.0, 0.0]
        distance, sweep = float(np.linalg.norm(across)), math.copysign(0.8, self.rate)
        way = ring(tip - across, UPRIGHT, distance, across, sweep)
        beyond, weight = tip + 0.5 * couple, centre - max(0.6, 1.2 * half) * UPRIGHT
        # Away from the axle, which may be where the words are else.
        change = ((0, 4), "center", "bottom") if momentum[2] > -0.2 else ((-3, -3), "right", "top")
        aside, side = ((-5, 0), "right") if e3[2] < -0.85 else ((5, 0), "left")
        below, above = (None, None) if outward else ((-2.0, -9.0), (0.0, 9.0))
        z = self.level(momentum)
        return [
            pen.Arrow(tip, look.L_VEC, look.MOMENTUM, 1.8, centre, below, z),
            pen.Turning(spin, e3, 0.15, omega3, r"$\omega_3$", z=self.level(e3)),
            pen.Curve(way, look.OMEGA, 0.9, look.DASHED, 1.3, label="_way"),
            pen.Arrow(beyond, "", look.TORQUE, start=tip),
            pen.Words(beyond, look.L_DOT, change[0], look.TORQUE, *change[1:]),
            pen.Arrow(0.6 * couple, look.N_VEC, look.TORQUE, 1.9, shift=above, z=6),
            pen.Arrow(weight, lw=1.5, start=centre, z=6),
            pen.Markers(centre),
            pen.Words(weight, f"$Mg = {in_math(top.M * top.g)}$ N", aside, ha=side),
        ]


# --- The gyroscope of introductory books ---------------------------------------------------------

VIEW_GYROSCOPE = View(azimuth=-0.6, elevation=0.3)
"""From the side that is held: what points into the paper goes up and to the left."""


def draw_gyroscope(axes: Axes, motion: TopMotion, radius: float) -> None:
    """A disc of this radius (m) on its axle, with the arrows at the start of a motion.

    Axle and disc are to scale, arrows are not.
    """
    rotor = Rotor(motion, radius, VIEW_GYROSCOPE)
    e3, arm, half, rate = rotor.e3, rotor.arm, rotor.half, rotor.rate
    foot = height_of_post(float(motion.start().theta[0]), arm, half) * UPRIGHT
    words, left = rf"$\Omega = {in_math(rate)}$ rad/s", rate > 0  # else L is there
    theta = 0.55 * arm * arc(UPRIGHT, e3)
    parts = [
        pen.Face(foot + circle(UPRIGHT, math.pi / 2, length=0.28), look.GROUND, look.GREY, z=0.5),
        pen.Curve([pen.ORIGIN, foot], look.GREY, 3.2, z=1, cap="butt"),
        *rotor.axle(),
        *solids.disc(arm * e3, e3, half, 0.16 * half, z=2.5),
        pen.guide([pen.ORIGIN, 0.69 * arm * UPRIGHT]),
        *pen.angle(theta, r"$\theta$", (0, 2), out=1.1, label="_theta", color=look.GREY, z=1),
        pen.Words(pen.ORIGIN, "$O$", (5, -9)),
        *rotor.arrows(),
        pen.Turning(0.55 * foot, UPRIGHT, 0.2, rate, words, left, z=3.5),
    ]
    pen.fit(axes, parts, VIEW_GYROSCOPE, (0.25, 0.06, 0.02, 0.1))


def height_of_post(theta: float, arm: float, half: float) -> float:
    """Where the foot of the stand is: below, or above where the disc is in the way of a post.

    `arm` and `half` are R and the radius of the disc.
    """
    if theta > math.pi / 2 and arm * math.tan(math.pi - theta) < 1.2 * half:
        return 0.9
    return min(-0.7, arm * math.cos(theta) - half * math.sin(theta) - 0.12)


def draw_simple_and_exact(
    axes: Axes, top: SymmetricTop, theta: float, omega3: float, tolerance: float
) -> None:
    """|Ω₋| of (3.57) and |Ω| of (3.52) against |ω₃|, a dot at the spin `omega3` (rad/s).

    A line marks the spin from which on the two differ by no more than the share `tolerance`.
    """
    least, marked = top.smallest_spin(theta), abs(omega3)
    needed = exercise.spin_for(tolerance, top, theta)
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
        pen.Markers((marked, now), look.FIRST, 4.5, label="_now"),
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


def _motion_gyroscope(theta: float, omega3: float, **body: float) -> TopMotion:
    return steady(exercise.disc_on_axle(**body), theta, omega3)


def _draw_gyroscope(picture: Axes, chart: Axes, tolerance: float, **values: float) -> None:
    motion = _motion_gyroscope(**values)
    draw_gyroscope(picture, motion, values["radius"])
    draw_simple_and_exact(chart, motion.body, values["theta"], values["omega3"], tolerance)


def _facts_gyroscope(tolerance: float, **values: float) -> dict[str, Any]:
    facts = answers(exercise.gyroscope, tolerance=tolerance, **values)
    facts |= facts_of_axle(_motion_gyroscope(**values))
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
    exercise.gyroscope.parameters,
    pen.panels(look.TEXT, 2.2, _draw_gyroscope, 1, 2),
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
    _facts_gyroscope,
    motions=lambda tolerance, **values: (_motion_gyroscope(**values),),
)

# --- A bicycle wheel whose horizontal axle hangs on a cord at one end ----------------------------

VIEW_BICYCLE_WHEEL = View(azimuth=-0.36, elevation=0.3)
"""Nearly along the wheel, which would else hide its cord."""

SPOKES = 18

LONGEST = 1.3
"""Of the cord as it is drawn, where the rim is at the distance 1 from its lower end."""


def draw_wheel(axes: Axes, motion: TopMotion, radius: float, cord: float) -> None:
    """A wheel of this radius (m) on its axle and on a cord of this length (m), with the arrows.

    Wheel, axle and the lean of the cord are to scale, arrows are not; a long cord is cut off.
    """
    rotor, top = Rotor(motion, radius, VIEW_BICYCLE_WHEEL), motion.body
    e3, centre, half = rotor.e3, rotor.arm * rotor.e3, rotor.half
    slope = exercise.slope_of_cord(rotor.rate, top.R, cord, top.g)
    # From the end of the axle up, and in towards the vertical about which all goes round.
    along = np.array([0.0, -slope, 1.0]) / math.hypot(1.0, slope)
    whole = cord / rotor.size
    upper = min(whole, LONGEST) * along
    rim = ring(centre, e3, half, rotor.view.axes[2] + 0.1 * rotor.view.axes[0])
    spokes = ring(centre, e3, half, UPRIGHT, count=SPOKES + 1)[:-1]
    # Where the cord is fixed, or a stroke through it where it goes on.
    cut = pen.Markers(upper, look.NOTE, 9, (2, 0, 60), z=5)
    parts: list[pen.Part] = [
        pen.Curve([pen.ORIGIN, upper], look.NOTE, 1.1, z=5, label="_cord"),
        cut if whole > LONGEST else pen.Markers(upper, look.GREY, 5, "s", z=5),
        pen.Words(pen.ORIGIN, "$O$", (-4, -10), ha="right"),
        *rotor.axle(),
        *(pen.Curve([centre, point], look.GREY, 0.6, z=2.2) for point in spokes),
        pen.Curve(rim, look.INK, 3.4, z=2.4, label="_rim"),
        pen.Curve(rim, look.MANTLE, 1.6, z=2.5),
        *rotor.arrows(),
        *_sense(upper, rotor.rate),
    ]
    pen.fit(axes, parts, rotor.view, (0.2, 0.06, 0.05, 0.05))


def _sense(upper: Floats, rate: float) -> list[pen.Part]:
    """Ω about the vertical, beside a cord that ends at `upper`, or above a short one."""
    words = rf"$\Omega = {in_math(rate)}$ rad/s"
    middle, beside = 0.8 * upper, list[pen.Part]()
    if np.linalg.norm(upper) < 0.6:
        middle = 0.7 * UPRIGHT
        beside = [pen.guide(np.outer([0.0, 0.9], UPRIGHT), ls=look.DOTTED)]
    elif abs(upper[1]) > 0.5 * upper[2]:  # the cord is where the words would be
        beside, words = [pen.Words(middle, words, (0, 9), look.OMEGA, "center")], ""
    return [pen.Turning(middle, UPRIGHT, 0.17, rate, words, left=True, z=3.5), *beside]


def _motion_bicycle_wheel(omega3: float, **body: float) -> TopMotion:
    return steady(exercise.hoop_on_axle(**body), math.pi / 2, omega3)


def _draw_bicycle_wheel(axes: Axes, cord: float, **values: float) -> None:
    draw_wheel(axes, _motion_bicycle_wheel(**values), values["radius"], cord)


def _facts_bicycle_wheel(cord: float, **values: float) -> dict[str, Any]:
    facts = answers(exercise.bicycle_wheel, cord=cord, **values)
    return facts | facts_of_axle(_motion_bicycle_wheel(**values))


BICYCLE_WHEEL = Drawing(
    "bicycle-wheel",
    "The bicycle wheel on a cord: weight, torque and the change of $L$",
    "",
    exercise.bicycle_wheel.parameters,
    pen.alone(2.9, _draw_bicycle_wheel),
    "A bicycle wheel of {M} kg and radius {radius} m at $R = {R}$ m from the end $O$ of its "
    r"horizontal axle, with $\omega_3 = {omega3}$ rad/s and $g = {g}$ m/s²: $L = {L}$ J s, and the "
    "torque about $O$, $N = {N}$ N m, turns it {direction}, as seen from above, at "
    r"$\Omega = {precession}$ rad/s, a turn in {period} s. The cord of {cord} m, drawn shorter, "
    r"pulls with {tension} N and leans by {lean:°}. Dashed: the circle of the tip of $\mathbf L$. "
    "Directions are computed, lengths of arrows are not to scale.",
    "A wheel with spokes, seen aslant, on a horizontal axle; a cord that leans by {lean:°} degrees "
    "holds it at one end, O. The weight points down from the hub, L points {side} O, {aslant:°} "
    "degrees from the axle. The torque N at O is horizontal and points into the paper, and so does "
    "the change of L at its tip. Seen from above the wheel goes {direction}: the tip of L into the "
    "paper.",
    _facts_bicycle_wheel,
    motions=lambda cord, **values: (_motion_bicycle_wheel(**values),),
)
