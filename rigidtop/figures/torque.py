"""The torque of the weight, and where it moves the angular momentum (sections 3.5.1 and 3.5.2)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.errors import NoSteadyPrecession
from rigidtop.figures import picture as pen
from rigidtop.figures import solids
from rigidtop.figures import style as look
from rigidtop.figures.bodies import TOP, facts_of
from rigidtop.figures.drawing import Drawing, one
from rigidtop.figures.space import UPRIGHT, View, circle, unit
from rigidtop.figures.style import Floats
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
    turning = direction_of_torque(motion)
    lean, tilt = (math.acos(float(np.clip(each[2], -1, 1))) for each in (e3, momentum))
    standing = lean < 1.3  # above the table, which it does not touch but with its tip
    half = min(0.37, 0.8 * (math.pi / 2 - lean)) if standing else 0.37
    centre, end = 0.62 * e3, 1.42 * momentum
    weight = centre - 0.46 * UPRIGHT
    parts: list[pen.Part] = [
        *([solids.table(0.62)] if standing else []),
        *solids.cone(e3, 0.78, 0.78 * math.tan(half)),
        pen.round_axis(circle(UPRIGHT, tilt, length=1.42), look.MOMENTUM, lw=0.9, ls=look.DASHED),
        pen.Arrow(1.95 * UPRIGHT, look.Z, look.GREY, 0.8, shift=(7, 2)),
        pen.Arrow(centre, lw=2.0),
        pen.Arrow(1.05 * e3, look.E3, look.AXIS, 1.0, shift=(9, 0)),
        pen.Arrow(end, look.L_VEC, look.MOMENTUM, 1.7, shift=(9, 2)),
        pen.Arrow(1.2 * omega, look.OMEGA_VEC, look.OMEGA, 1.7, shift=(9, -3)),
        pen.couple(0.95 * turning, (-6, -10), "right"),
        pen.Arrow(weight, start=centre),
        pen.Words(weight, look.WEIGHT, (6, 2)),
        pen.Mark(centre, words=look.R_CM, shift=(6, -8)),
        pen.Words(pen.ORIGIN, "$O$", (5, -10)),
    ]
    if np.any(turning):
        beyond = end + 0.42 * turning
        parts.append(pen.Arrow(beyond, "", look.TORQUE, 1.2, start=end))
        parts.append(pen.Words(beyond, look.L_DOT, (2, 4), look.TORQUE, "center", z=7))
    low = min(-0.3, 1.6 * e3[2] - 0.4)
    pen.picture(axes, parts, (-1.45, 1.7), (low, 1.92), VIEW)


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


def _facts(**values: float) -> dict[str, Any]:
    motion = _motion(**values)
    start, along = motion.start(), direction_of_torque(motion)
    lean = float(unit(start.angular_momentum[0]) @ start.e3[0])
    rate = float(start.phi_dot[0])
    steady = "the top goes round at {rate} rad/s, its exact slow rate"
    where = (
        r"it points into the paper, and the tip of $\mathbf L$ follows it round $\hat{\mathbf z}$"
    )
    points = (
        f"The torque N points horizontally {'into' if along[0] < 0 else 'out of'} the paper, at "
        "right angles to e3 and to z, and so does the change of L at its tip, along a dashed "
        "circle around z."
    )
    return facts_of(
        motion.body,
        where=where if np.any(along) else "on the vertical there is none",
        size=float(np.linalg.norm(torque(motion))),
        rate=rate,
        goes=steady if rate else r"$\boldsymbol\omega$ is along $\mathbf e_3$ at first",
        lean=math.acos(min(1.0, max(-1.0, lean))),
        points=points if along[0] else "There is no torque, as the axis is vertical.",
    )


TORQUE_ARROWS = Drawing(
    "torque",
    r"The torque of the weight, $\mathbf L$ and $\boldsymbol\omega$: into the paper",
    "3.5.2",
    (
        *TOP,
        Parameter("theta", math.pi / 4, r"$\theta$", "rad", least=0, most=math.pi),
        Parameter("omega3", 30.0, r"$\omega_3$", "rad/s", above=0),
    ),
    pen.alone(2.75, lambda axes, **values: draw_torque(axes, _motion(**values))),
    r"The torque $\mathbf N = \mathbf R_{\text{CM}} \times M\mathbf g$ of the weight, with "
    r"$\mathbf e_3$ leaning to the right in the plane of the paper: {where}. At {start}, with "
    "{top}, its magnitude is {size} N m, and {goes}. Directions are computed, lengths are not to "
    "one scale.",
    "A top on a table, its axis e3 leaning to the right. From the contact point O the arrows e3, "
    "omega and L, L {lean:°} degrees from e3. The weight points down from the centre of mass. "
    "{points}",
    _facts,
    motions=one(_motion),
)
