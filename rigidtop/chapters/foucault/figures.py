"""The axes of a laboratory on the earth, and the rosette of a pendulum on an earth in a hurry."""

from __future__ import annotations

import math
from functools import partial

import numpy as np
from matplotlib.axes import Axes

from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing, Film, film
from rigidtop.figures.space import UPRIGHT, View, arc, bow, circle, ring
from rigidtop.figures.style import Floats
from rigidtop.parameters import Parameter

from .laboratory import motion

# --- The laboratory ------------------------------------------------------------------------------

VIEW = View(0.0, 0.35)
MERIDIAN = math.radians(38)
"""Where the laboratory is, to the right of the middle."""


def draw_laboratory(axes: Axes, latitude: float) -> None:
    """The globe, the axes to the east, to the north and upwards, and the latitude."""
    outward = np.array([math.cos(MERIDIAN), math.sin(MERIDIAN), 0.0])
    east = np.array([-math.sin(MERIDIAN), math.cos(MERIDIAN), 0.0])
    up = math.cos(latitude) * outward + math.sin(latitude) * UPRIGHT
    north = np.cross(up, east)
    turn = arc(outward, up)
    around = ring(np.array([0.0, 0.0, 1.22]), UPRIGHT, 0.16, east, 4.8)
    parts: list[pen.Part] = [
        pen.Sphere(),
        pen.on_sphere(circle(UPRIGHT, math.pi / 2 - latitude), look.GREY, lw=0.8),
        *(pen.on_sphere(arc(k * UPRIGHT, outward), look.RULE, lw=0.8) for k in (-1, 1)),
        pen.Curve([-1.2 * UPRIGHT, UPRIGHT], look.OMEGA, 0.8, look.DASHED, z=1.5),
        pen.Arrow(1.5 * UPRIGHT, look.OMEGA_VEC, look.OMEGA, 1.5, UPRIGHT, (9, 0)),
        pen.round_axis(around, look.OMEGA, head=True),
        pen.guide([pen.ORIGIN, outward]),
        pen.Arrow(up, "", look.NOTE, 1.0),
        pen.Words(0.55 * up, r"$\mathbf{r}_0$", (-4, 5), look.NOTE, "right"),
        *pen.angle(0.42 * turn, r"$\lambda$", (8, -3), head=latitude > 0.15, z=4),
        pen.Markers(up),
    ]
    parts += pen.frame(np.array([east, north, up]), 0.5, centre=up, lw=1.6, z=6)
    pen.picture(axes, parts, (-1.05, 1.65), (-1.15, 1.62), VIEW)


LABORATORY = Drawing(
    "laboratory",
    "A laboratory on the earth",
    "1",
    (Parameter("latitude", math.radians(48.85), "latitude", "rad", least=0.0, most=1.4),),
    pen.alone(3.4, draw_laboratory),
    r"At the latitude $\lambda = {latitude:°}$; $\mathbf e_1$ points to the east, $\mathbf e_2$ to "
    "the north.",
    "A globe with its axis and the arrow omega upwards. From a place on it at the latitude "
    "{latitude:°} degrees three arrows start: e1 to the east, e2 to the north, e3 away from the "
    "middle of the globe.",
)

# --- The rosette ---------------------------------------------------------------------------------

SWINGS = Parameter("swings", 9.0, "swings while the plane comes round", least=3, most=60)


def path(swings: float, share: float, held: bool) -> tuple[Floats, Floats]:
    """East and north of the bob, by A, until a share of a turn of the plane.

    It starts at rest as it is seen from the axes that turn back, or `held` in the laboratory.
    """
    plane = 2 * math.pi / swings
    times = np.linspace(0.0, share * swings, max(2, int(240 * share * swings)))
    frequency = math.sqrt(max(4 * math.pi**2 - plane**2, 0.0))
    # At a pole the plane turns as fast as the earth does.
    start = (1.0, 0.0, 0.0), (0.0, 0.0 if held else -plane, 0.0)
    run = motion(*start, math.pi / 2, plane, frequency=frequency).integrate(times)
    return run.q[:, 0], run.q[:, 1]


def draw_rosette(axes: Axes, swings: float, share: float = 1.0, held: bool = False) -> None:
    """The path over the floor, north upwards; the plane of now, where the turn is not yet whole."""
    x, y = path(swings, share, held)
    parts: list[pen.Part] = [
        pen.guide(bow(1.0)),
        pen.Curve((x, y), look.FIRST, 1.0),
        pen.Markers((1.0, 0.0), look.SECOND, 4, words="start", shift=(5, 0), va="center"),
        pen.Words((0.0, 1.0), "N", (0, 4), look.NOTE, "center", size=look.SMALL),
        pen.Words((0.0, -1.0), "S", (0, -11), look.NOTE, "center", size=look.SMALL),
    ]
    if share < 1:
        plane = bow(1.0, math.pi - 2 * math.pi * share, -2 * math.pi * share, count=2)
        parts.append(pen.Curve(plane, look.SECOND, 0.9, look.DASHED))
        parts.append(pen.Markers((x[-1], y[-1]), look.INK, 7, fill=look.FACE))
    pen.picture(axes, parts, (-1.08, 1.36), (-1.2, 1.2))


def _film(swings: float) -> Film:
    """One turn of the plane."""
    return film(look.COLUMN, 3.3, lambda share, axes: draw_rosette(axes, swings, share))


ROSETTE = Drawing(
    "rosette",
    "The path of Foucault's bob over the floor",
    "3",
    (SWINGS,),
    pen.abreast(2.55, draw_rosette, partial(draw_rosette, held=True)),
    "The path over the floor, seen from above, while the plane comes round once, on an earth that "
    "turns so fast that this takes {swings} swings. Left: the start of (3.3), and the bob goes "
    "through the middle each time. Right: let go at rest in the laboratory, where it starts with "
    "the velocity of the floor, and misses the middle.",
    "Two rosettes within circles. On the left {swings} swings go through the middle and turn "
    "clockwise; on the right they have points at the circle and leave a hole around the middle.",
    animate=_film,
)

FIGURES = (LABORATORY, ROSETTE)
