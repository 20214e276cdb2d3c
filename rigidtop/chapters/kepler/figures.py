"""The conics of (1.5), and the areas that the radius sweeps over in equal times."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing, Film, film
from rigidtop.figures.space import bow
from rigidtop.figures.style import Floats
from rigidtop.parameters import Parameter

from .orbits import orbit, period

ECCENTRICITY = Parameter("epsilon", 0.6, "eccentricity of the ellipse", least=0.05, most=0.9)
SUN = pen.Markers((0.0, 0.0), look.SECOND, 9, fill="#f6c95c")
PARTS = 12
"""Sectors, each of the same time."""


def places(epsilon: float, times: Floats, p: float = 1.0) -> tuple[Floats, Floats]:
    """Where a planet is at some times, x along the long axis, from an orbit that is integrated."""
    r, phi = orbit(p, epsilon).integrate(times).q.T
    return r * np.cos(phi), r * np.sin(phi)


def _closed(epsilon: float) -> tuple[Floats, Floats]:
    return places(epsilon, np.linspace(0.0, period(1.0, epsilon), 721))


# --- Conics --------------------------------------------------------------------------------------


def draw_conics(axes: Axes, epsilon: float) -> None:
    """Four orbits with one semi-latus rectum, and the letters of (1.5) at the ellipse."""
    long = np.linspace(-9.0, 9.0, 721)
    parabola, hyperbola = places(1.0, long), places(1.5, long)
    far, near = -1.0 / (1 - epsilon), 1.0 / (1 + epsilon)
    [planet] = np.transpose(places(epsilon, np.array([0.22 * period(1.0, epsilon)])))
    turn = bow(0.3, 0.0, math.atan2(planet[1], planet[0]))
    high = 2.2  # of the names of what opens to the left
    first, second = ((np.interp(high, y, x), high) for x, y in (parabola, hyperbola))
    parts: list[pen.Part] = [
        pen.Curve(_closed(0.0), look.GREY, 1.4, z=3),
        pen.Words((-0.94, -0.34), r"$\varepsilon=0$", (-2, 0), look.GREY, "right", "top"),
        pen.Curve(parabola, look.SECOND, 1.4, z=3),
        pen.Words(first, r"$\varepsilon=1$", (-4, -4), look.SECOND, "right", "top"),
        pen.Curve(hyperbola, look.THIRD, 1.4, z=3),
        pen.Words(second, r"$\varepsilon=1.5$", (5, 0), "#55803d"),
        pen.Curve(_closed(epsilon), look.FIRST, 1.4, z=3),
        pen.Words((far, 0.0), rf"$\varepsilon={look.in_math(epsilon)}$", (4, 5), look.FIRST),
        pen.guide(([far, 1.06], 0.0), ls=look.DASHED),
        pen.Markers((near, 0.0), look.FIRST, 3),
        pen.guide((0.0, [-1.0, 0.0])),
        pen.Words((0.0, -0.5), "$p$", (5, -3), look.NOTE),
        pen.Curve([0 * planet, planet], z=4),
        pen.Words(0.6 * planet, "$r$", (3, 4)),
        *pen.angle(turn, r"$\phi$", (7, 2), head=True, z=4),
        pen.Markers(planet, look.FIRST, 5),
        pen.Words((1.06, 0.0), "perihelion", (3, 0), look.NOTE, va="center", size=look.SMALL),
        SUN,
    ]
    pen.picture(axes, parts, (min(far, -2.2) - 0.15, 1.75), (-1.9, 2.6))


CONICS = Drawing(
    "conics",
    "Orbits of one angular momentum and different eccentricities",
    "1",
    (ECCENTRICITY,),
    pen.alone(3.3, draw_conics),
    r"All have the semi-latus rectum $p$: a circle, an ellipse of $\varepsilon = {epsilon}$, a "
    "parabola and a hyperbola, integrated from the perihelion.",
    "Four curves about the sun, which all go through the same point above it: a circle, an ellipse "
    "of eccentricity {epsilon}, a parabola and a hyperbola that open to the left. A planet on the "
    "ellipse is at the distance r and the angle phi from the perihelion.",
)


# --- Areas ---------------------------------------------------------------------------------------


def sector(epsilon: float, start: float, share: float) -> tuple[Floats, Floats]:
    """The edge of what is swept over in a share of the period, from the sun round to the sun."""
    times = period(1.0, epsilon) * np.linspace(start, start + share, 91)
    x, y = places(epsilon, times)
    return np.array([0.0, *x]), np.array([0.0, *y])


def draw_areas(axes: Axes, epsilon: float, now: float | None = None) -> None:
    """The orbit in parts of one time, every other one shaded; or what was swept over till `now`."""
    starts = (np.arange(PARTS) - 0.5) / PARTS
    x, y = places(epsilon, period(1.0, epsilon) * starts)
    parts: list[pen.Part] = [pen.Curve(_closed(epsilon), look.FIRST, 1.4, z=3), SUN]
    if now is None:
        parts += [pen.Face(sector(epsilon, s, 1 / PARTS), look.FACE) for s in starts[::2]]
        parts += [pen.guide(([0, a], [0, b])) for a, b in zip(x, y, strict=True)]
        parts += [pen.Markers((x, y), look.FIRST, 4)]
    else:
        swept = sector(epsilon, now - 1 / PARTS, 1 / PARTS)
        planet = swept[0][-1], swept[1][-1]
        parts += [pen.Face(swept, look.FACE, look.EDGE), pen.Markers(planet, look.FIRST, 6)]
        parts += [pen.Markers((x, y), look.GREY, 2.5, z=4)]
    a, b = 1 / (1 - epsilon**2), 1 / math.sqrt(1 - epsilon**2)
    across = -a * (1 + epsilon) - 0.1, a * (1 - epsilon) + 0.1
    pen.picture(axes, parts, across, (-b - 0.1, b + 0.1))


def _film(epsilon: float) -> Film:
    """One period."""
    a, b = 1 / (1 - epsilon**2), 1 / math.sqrt(1 - epsilon**2)
    height = look.COLUMN * (b + 0.1) / (a + 0.1)
    return film(look.COLUMN, height, lambda share, axes: draw_areas(axes, epsilon, share))


def _facts(epsilon: float) -> dict[str, Any]:
    half = 0.5 * period(1.0, epsilon) / PARTS
    ends = half * np.array([1, PARTS - 1, PARTS + 1])
    near, first, last = orbit(1.0, epsilon).integrate(ends).q[:, 1]
    return {"wide": 2 * float(near), "narrow": float(last - first), "parts": PARTS}


AREAS = Drawing(
    "areas",
    "Equal areas in equal times",
    "2",
    (ECCENTRICITY,),
    pen.alone(2.7, draw_areas),
    r"An orbit of $\varepsilon = {epsilon}$ in {parts} sectors, each swept over in the same time. "
    "At the perihelion the planet goes {wide:°} about the sun in that time, at the aphelion "
    "{narrow:°}.",
    "An ellipse with the sun near its right end, cut by lines from the sun into {parts} sectors of "
    "equal areas: a short and wide one at the perihelion, {wide:°} degrees, long and narrow ones "
    "at the aphelion, {narrow:°} degrees.",
    _facts,
    _film,
)

FIGURES = (CONICS, AREAS)
