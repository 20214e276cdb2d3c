"""The conics of (1.5), and the areas that the radius sweeps over in equal times."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing, Film
from rigidtop.figures.style import Canvas, Floats
from rigidtop.parameters import Parameter

from .orbits import orbit, period

ECCENTRICITY = Parameter("epsilon", 0.6, "eccentricity of the ellipse", least=0.05, most=0.9)
SUN = pen.Mark((0.0, 0.0), look.SECOND, 9, fill="#f6c95c")
PARTS = 12
"""Sectors, each of the same time."""


def places(epsilon: float, times: Floats, p: float = 1.0) -> tuple[Floats, Floats]:
    """Where a planet is at some times, x along the long axis, from an orbit that is integrated."""
    r, phi = orbit(p, epsilon).integrate(times).q.T
    return r * np.cos(phi), r * np.sin(phi)


def _closed(epsilon: float) -> tuple[Floats, Floats]:
    return places(epsilon, np.linspace(0.0, period(1.0, epsilon), 721))


# --- Conics --------------------------------------------------------------------------------------


def _at_height(path: tuple[Floats, Floats], height: float) -> tuple[float, float]:
    """The point of a path that opens to the left at which y is so much."""
    return float(np.interp(height, path[1], path[0])), height


def draw_conics(axes: Axes, epsilon: float) -> None:
    """Four orbits with one semi-latus rectum, and the letters of (1.5) at the ellipse."""
    long = np.linspace(-9.0, 9.0, 721)
    parabola, hyperbola = places(1.0, long), places(1.5, long)
    curves = (
        (_closed(0.0), look.GREY),
        (parabola, look.SECOND),
        (hyperbola, look.THIRD),
        (_closed(epsilon), look.FIRST),
    )
    parts: list[pen.Part] = [pen.Curve(path, color, 1.4, z=3) for path, color in curves]
    parts += [
        pen.Words((-0.94, -0.34), r"$\varepsilon=0$", (-2, 0), look.GREY, "right", "top"),
        pen.Words(
            _at_height(parabola, 2.2), r"$\varepsilon=1$", (-4, -4), look.SECOND, "right", "top"
        ),
        pen.Words(_at_height(hyperbola, 2.2), r"$\varepsilon=1.5$", (5, 0), "#55803d"),
    ]
    far = -1.0 / (1 - epsilon), 1.0 / (1 + epsilon)
    x, y = places(epsilon, np.array([0.22 * period(1.0, epsilon)]))
    angle = math.atan2(float(y[0]), float(x[0]))
    turn = np.linspace(0.0, angle, 61)
    parts += [
        pen.guide((np.array([far[0], 1.06]), np.zeros(2)), ls=look.DASHED),
        pen.Mark((far[1], 0.0), look.FIRST, 3),
        pen.guide((np.zeros(2), np.array([-1.0, 0.0]))),
        pen.Words((0.0, -0.5), "$p$", (5, -3), look.NOTE),
        pen.Curve((np.array([0.0, x[0]]), np.array([0.0, y[0]])), z=4),
        pen.Words((0.6 * x[0], 0.6 * y[0]), "$r$", (3, 4)),
        pen.Curve((0.3 * np.cos(turn), 0.3 * np.sin(turn)), lw=0.9, head=True, z=4),
        pen.Words((0.3 * math.cos(angle / 2), 0.3 * math.sin(angle / 2)), r"$\phi$", (3, 2)),
        pen.Mark((x[0], y[0]), look.FIRST, 5),
        pen.Words((far[0], 0.0), rf"$\varepsilon={look.in_math(epsilon)}$", (4, 5), look.FIRST),
        pen.Words((1.06, 0.0), "perihelion", (3, 0), look.NOTE, va="center", size=look.SMALL),
        SUN,
    ]
    pen.draw(axes, parts)
    pen.paper(axes, (min(far[0], -2.2) - 0.15, 1.75), (-1.9, 2.6))


CONICS = Drawing(
    "conics",
    "Orbits of one angular momentum and different eccentricities",
    "1",
    (ECCENTRICITY,),
    pen.alone(3.3, lambda axes, **values: draw_conics(axes, **values)),
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
        parts += [
            pen.guide((np.array([0, a]), np.array([0, b]))) for a, b in zip(x, y, strict=True)
        ]
        parts += [pen.Mark((x, y), look.FIRST, 4)]
    else:
        swept = sector(epsilon, now - 1 / PARTS, 1 / PARTS)
        planet = swept[0][-1], swept[1][-1]
        parts += [pen.Face(swept, look.FACE, look.EDGE), pen.Mark(planet, look.FIRST, 6)]
        parts += [pen.Mark((x, y), look.GREY, 2.5, z=4)]
    pen.draw(axes, parts)
    a, b = 1 / (1 - epsilon**2), 1 / math.sqrt(1 - epsilon**2)
    pen.paper(axes, (-a * (1 + epsilon) - 0.1, a * (1 - epsilon) + 0.1), (-b - 0.1, b + 0.1))


def _film(epsilon: float) -> Film:
    """One period."""
    a, b = 1 / (1 - epsilon**2), 1 / math.sqrt(1 - epsilon**2)
    drawn = Canvas(figsize=(look.COLUMN, look.COLUMN * (b + 0.1) / (a + 0.1)))
    axes = drawn.add_axes((0.0, 0.0, 1.0, 1.0))

    def show(share: float) -> None:
        axes.clear()
        draw_areas(axes, epsilon, share)

    show(0.0)
    return Film(drawn, show)


def _facts(epsilon: float) -> dict[str, Any]:
    half = 0.5 * period(1.0, epsilon) / PARTS
    ends = np.array([half, PARTS * half - half, PARTS * half + half])
    near, first, last = orbit(1.0, epsilon).integrate(ends).q[:, 1]
    return {"wide": 2 * float(near), "narrow": float(last - first), "parts": PARTS}


AREAS = Drawing(
    "areas",
    "Equal areas in equal times",
    "2",
    (ECCENTRICITY,),
    pen.alone(2.7, lambda axes, **values: draw_areas(axes, **values)),
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
