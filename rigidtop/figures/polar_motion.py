"""The way of the Earth's pole of rotation around the pole of its figure (section 3.2.3)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.derivations.exercises.precession_of_rotation_axis import DAY, earth_euler_period
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.solved import answers
from rigidtop.figures.space import paper
from rigidtop.figures.style import Floats, alone, head, in_math, name_at, said, spoken
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
    size = found["ground"]
    axes.plot(*way.T, color=look.OMEGA, lw=1.3, label="_way")
    dot: dict[str, Any] = {
        "ms": 3.5,
        "mfc": look.INK,
        "mec": look.INK,
        "zorder": 5,
        "label": "_rigid",
    }
    ring = {"ms": 5.5, "mfc": "white", "mec": look.SECOND, "zorder": 4.5, "label": "_yielding"}
    for motion, period, outwards, mark in (
        (rigid, found["period"], 1, dot),
        (yielding, observed, -1, ring),
    ):
        days = marked_days(period)
        points = way_of_the_pole(motion, radius, days * DAY * omega3)
        axes.plot(*points.T, "o", **mark)
        for day, point in zip(days[1:], points[1:], strict=True):
            x, y = map(float, point)
            name_at(
                axes,
                x,
                y,
                f"${in_math(float(day), 4)}$",
                (12 * outwards * x / size, 12 * outwards * y / size),
                color=mark["mec"],
                ha="center",
                va="center",
                fontsize=look.SMALL,
            )
    for k in (15, 195):  # where there are no days of either
        head(axes, way[k], way[k + 5], width=0.18, length=0.4, color=look.OMEGA, lw=0.5, zorder=4)
    axes.plot([0.0, size], [0.0, 0.0], color=look.GREY, lw=0.9, ls=look.DASHED, zorder=2)
    axes.plot(0, 0, "o", color=look.AXIS, ms=4, zorder=5)
    axes.plot(*way[0], "o", color=look.OMEGA, ms=6.5, zorder=6)
    name_at(axes, 0.0, 0.0, look.E3, (-6, 0), color=look.AXIS, ha="right", va="center", fontsize=10)
    name_at(axes, size, 0.0, look.OMEGA_VEC, (7, -3), color=look.OMEGA, fontsize=10)
    name_at(axes, 0.5 * size, 0.0, f"${in_math(size)}$ m", (0, 3), ha="center", fontsize=look.SMALL)
    for words, period, up, color in (
        ("outside: rigid", found["period"], 0.32, look.INK),
        ("inside: observed", observed, -0.38, look.SECOND),
    ):
        text = f"{words},\n${in_math(period)}$ days"
        name_at(axes, 0.0, up * size, text, color=color, ha="center", va="center")
    paper(axes, (-1.3 * size, 1.3 * size), (-1.2 * size, 1.2 * size))


def _caption(H: float, omega3: float, observed: float, angle: float, radius: float) -> str:
    found = answers(
        earth_euler_period, H=H, omega3=omega3, observed=observed, angle=angle, radius=radius
    )
    seconds = math.degrees(angle) * 3600
    nearer = radius * (math.tan(angle) - math.tan(angle - found["space_cone"]))
    return (
        "The pole of rotation, where $𝛚$ meets the ground, goes round the pole of the figure, "
        f"$e₃$: {found['direction']}; seen from above. With $H = {said(H)}$ and $ω₃ = "
        f"{said(omega3)}$ rad/s a rigid Earth needs {said(found['period'])} days (dots, days "
        f"outside). Observed are {said(observed, 4)} (circles, days inside), as if "
        f"{said(100 * found['share'])} % of the bulge followed $𝛚$. At ${said(seconds)}″$ from "
        f"$e₃$ and {said(radius)} m from the centre the circle has a radius of "
        f"{said(found['ground'])} m; for a rigid Earth $𝐋$ is {said(nearer)} m nearer to $e₃$ than "
        "$𝛚$."
    )


def _in_words(**values: float) -> str:
    found = answers(earth_euler_period, **values)
    return (
        f"A circle of radius {spoken(found['ground'])} metres around the point e3, which the tip "
        "of omega goes round counterclockwise, seen from above. Dots with the days of a rigid "
        f"Earth, which is back after {spoken(found['period'])}, and open circles with those of the "
        f"observed wobble, which is back after {spoken(values['observed'])}."
    )


POLAR_MOTION = Drawing(
    "polar-motion",
    "The wobble of the Earth: rigid, and as it is observed",
    "",
    earth_euler_period.parameters,
    alone(3.05, draw_polar_motion),
    _caption,
    _in_words,
)
