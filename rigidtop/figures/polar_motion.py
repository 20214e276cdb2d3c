"""The way of the Earth's pole of rotation around the pole of its figure (section 3.2.3)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.derivations.exercises.precession_of_rotation_axis import DAY, earth_euler_period
from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.solved import answers
from rigidtop.figures.style import Floats, in_math
from rigidtop.motion.body import FreeBody
from rigidtop.motion.motion import Motion

MARKS = 9
"""At most, on the way once around."""


def wobble(H: float, angle: float, share: float = 0.0) -> Motion:
    """The free motion of the Earth, with C = 1 and ω₃ = 1, from ω at `angle` (rad) to e₃.

    Where the `share` k of the bulge follows ω, L is that of a rigid body with the moments
    λ₁ + k(λ₃ − λ₁) and λ₃, and so ω in the body is that of one too.
    """
    across = 1 - (1 - share) * H
    return FreeBody(across, across, 1.0).motion(omega=(math.tan(angle), 0.0, 1.0))


def way_of_the_pole(motion: Motion, radius: float, turned: Floats) -> Floats:
    """Where ω meets the ground (N, 2), in metres from e₃ along e₁ and e₂, after angles (rad) by
    which the Earth has `turned`."""
    omega = motion.exact(turned).omega
    return radius * omega[:, :2] / omega[:, 2:]


def marked_days(period: float) -> Floats:
    """Round numbers of days on the way once around, from 0 on; none too near to its end."""
    size = 10.0 ** math.floor(math.log10(period))
    steps = [share * size for share in (0.2, 0.5, 1.0, 2.0) if period / (share * size) <= MARKS]
    return np.arange(0.0, period - 0.45 * steps[0], steps[0])


def draw_polar_motion(
    axes: Axes, H: float, omega3: float, observed: float, angle: float, radius: float
) -> None:
    """The circle of the pole of rotation seen from above the pole, in metres.

    Outside are the days of a rigid Earth, inside those of one whose bulge follows so far that the
    period is the `observed` one.
    """
    found = answers(
        earth_euler_period, H=H, omega3=omega3, observed=observed, angle=angle, radius=radius
    )
    rigid, yielding = wobble(H, angle), wobble(H, angle, max(found["share"], 0.0))
    once = np.linspace(0.0, found["period"], 361)
    way = way_of_the_pole(rigid, radius, once * DAY * omega3)
    size, small = found["ground"], look.SMALL
    metres = f"${in_math(size)}$ m"
    parts: list[pen.Part] = [
        pen.Curve(way, look.OMEGA, 1.3, label="_way"),
        # Heads where there are no days of either.
        *(pen.Curve(way[k : k + 9], look.OMEGA, head=True) for k in (12, 192)),
        pen.Curve(([0.0, size], 0.0), look.GREY, 0.9, look.DASHED),
        pen.Mark((0.0, 0.0), look.AXIS, 4, z=5),
        pen.Mark(way[0], look.OMEGA, 6.5, z=6),
        pen.Words((0.0, 0.0), look.E3, (-6, 0), look.AXIS, "right", "center", 10),
        pen.Words((size, 0.0), look.OMEGA_VEC, (7, -3), look.OMEGA, size=10),
        pen.Words(
            (0.5 * size, 0.0), f"${in_math(size)}$ m", (0, 3), look.NOTE, "center", size=small
        ),
    ]
    dot: dict[str, Any] = {"z": 5.0}
    ring: dict[str, Any] = {"size": 5.5, "fill": "white", "z": 4.5}
    for motion, period, outwards, words, color, height, mark in (
        (rigid, found["period"], 12, "outside: rigid", look.INK, 0.32, dot),
        (yielding, observed, -12, "inside: observed", look.SECOND, -0.38, ring),
    ):
        days = marked_days(period)
        poles = way_of_the_pole(motion, radius, days * DAY * omega3)
        label = "_rigid" if outwards > 0 else "_yielding"
        parts.append(pen.Mark(poles, color, label=label, **mark))
        for pole, day in zip(poles[1:], days[1:], strict=True):
            right, up = outwards * pole / size
            number = f"${in_math(float(day), 4)}$"
            parts.append(pen.Words(pole, number, (right, up), color, "center", "center", small))
        text = f"{words},\n${in_math(period)}$ days"
        parts.append(pen.Words((0.0, height * size), text, (0, 0), color, "center", "center"))
    pen.picture(axes, parts, (-1.3 * size, 1.3 * size), (-1.2 * size, 1.2 * size))


def _facts(angle: float, radius: float, **others: float) -> dict[str, Any]:
    facts = answers(earth_euler_period, angle=angle, radius=radius, **others)
    nearer = radius * (math.tan(angle) - math.tan(angle - facts["space_cone"]))
    return facts | {"seconds": math.degrees(angle) * 3600, "nearer": nearer}


POLAR_MOTION = Drawing(
    "polar-motion",
    "The wobble of the Earth: rigid, and as it is observed",
    "",
    earth_euler_period.parameters,
    pen.alone(3.05, draw_polar_motion),
    r"The pole of rotation, where $\boldsymbol\omega$ meets the ground, goes round the pole of the "
    r"figure, $\mathbf e_3$: {direction}; seen from above. With $H = {H}$ and "
    r"$\omega_3 = {omega3}$ rad/s a rigid Earth needs {period} days (dots, days outside). Observed "
    "are {observed:4} (circles, days inside), as if {share:%} % of the bulge followed "
    r"$\boldsymbol\omega$. At ${seconds}''$ from $\mathbf e_3$ and {radius} m from the centre the "
    r"circle has a radius of {ground} m; for a rigid Earth $\mathbf L$ is {nearer} m nearer to "
    r"$\mathbf e_3$ than $\boldsymbol\omega$.",
    "A circle of radius {ground} metres around the point e3, which the tip of omega goes round "
    "counterclockwise, seen from above. Dots with the days of a rigid Earth, which is back after "
    "{period}, and open circles with those of the observed wobble, which is back after {observed}.",
    _facts,
)
