"""The weights of a body of points, and one weight at its centre of mass (section 3.5.1)."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.derivations.exercises.net_torque import POINTS, gravity_on_points
from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.solved import answers
from rigidtop.figures.space import View, total, unit
from rigidtop.figures.style import Floats, said

VIEW = View(azimuth=0.6, elevation=0.36)


@dataclass(frozen=True)
class Points:
    """Mass points (kg; m from the pivot), held together and held at the pivot, and g (m/s²)."""

    masses: Floats
    places: Floats
    g: float

    @property
    def weights(self) -> Floats:
        """The force on each (N, 3), N."""
        made: Floats = self.masses[:, None] * np.array([0.0, 0.0, -self.g])
        return made

    @property
    def centre(self) -> Floats:
        """R_CM (3,), m."""
        made: Floats = self.masses @ self.places / self.masses.sum()
        return made

    @property
    def torque(self) -> Floats:
        """N = Σ r × mg (3,), N m."""
        return total(np.cross(self.places, self.weights))


def points(g: float, **given: float) -> Points:
    """As the exercise names them: m1, x1, y1, z1, and so on."""
    numbers = range(1, POINTS + 1)
    masses = np.array([given[f"m{k}"] for k in numbers])
    return Points(masses, np.array([[given[f"{x}{k}"] for x in "xyz"] for k in numbers]), g)


@dataclass(frozen=True)
class Sketch:
    """What is drawn: places with the farthest at 1, weights to a scale of their own, and N."""

    places: Floats
    weights: Floats
    centre: Floats
    couple: Floats


def sketch(body: Points) -> Sketch:
    """Lengths for the paper; all weights together have the length 0.75, N has 0.6."""
    reach = float(np.linalg.norm(body.places, axis=1).max()) or 1.0
    weights = 0.75 * body.weights / np.linalg.norm(body.weights, axis=1).sum()
    return Sketch(body.places / reach, weights, body.centre / reach, 0.6 * unit(body.torque))


def draw_weights(axes: Axes, body: Points) -> None:
    """Each point with its weight, the whole weight at the centre of mass, and the torque of both.

    The paper is as large as they need.
    """
    drawn = sketch(body)
    end = drawn.centre + drawn.weights.sum(axis=0)
    side, shift = ("left", (5, 3)) if _room_on_the_right(drawn) else ("right", (-5, 3))
    parts: list[pen.Part] = pen.axes_of_space(0.45, z=1.5)
    for k, place in enumerate(drawn.places):
        size = 9 * float(np.cbrt(body.masses[k] / body.masses.max()))  # as balls of one material
        parts += _point(place, drawn.weights[k], f"$m_{k + 1}$", size)
    parts += [
        pen.Arrow(end, look.WEIGHT, lw=2.0, start=drawn.centre),
        pen.Arrow(drawn.centre, lw=1.6, z=5.5),
        pen.Mark(drawn.centre, size=4),
        pen.Words(drawn.centre, look.R_CM, shift, ha=side),
        pen.couple(drawn.couple, (10, -22)),
    ]
    pen.draw(axes, parts, VIEW)
    under = drawn.places + drawn.weights
    x, y, _ = VIEW(np.vstack([0.55 * np.eye(3), drawn.places, under, end, drawn.couple]))
    pen.paper(axes, (x.min() - 0.2, x.max() + 0.2), (y.min() - 0.15, y.max() + 0.15))


def _room_on_the_right(drawn: Sketch) -> bool:
    """Whether the name of the centre of mass is farther from balls and other names on the right."""
    x, y, _ = VIEW(drawn.centre)
    balls = np.column_stack(VIEW(drawn.places)[:2])
    above = balls + np.array([0.0, 0.09])
    tips = np.column_stack(VIEW(np.vstack([0.55 * np.eye(3), 1.15 * drawn.couple]))[:2])
    others = np.vstack([balls, above, tips])
    right, left = (np.linalg.norm(others - [x + k * 0.1, y + 0.03], axis=1).min() for k in (1, -1))
    return bool(right >= left)


def _point(place: Floats, weight: Floats, words: str, size: float) -> list[pen.Part]:
    """A ball on its rod, its weight, and a plumb line to the plane of x̂ and ŷ."""
    foot = place * [1.0, 1.0, 0.0]
    return [
        pen.Curve([pen.ORIGIN, place], look.RULE, 2.0),
        pen.Curve([place, foot], look.GREY, 0.7, look.DOTTED, z=1),
        pen.Mark(foot, look.GREY, 3, ".", z=1),
        pen.Arrow(place + weight, "", look.FIRST, 1.3, start=place),
        pen.Mark(place, size=size, fill=look.FACE, edge=look.EDGE, width=0.8, z=6),
        pen.Words(place, words, (0, 0.5 * size + 3), ha="center", z=7),
    ]


def _facts(**values: float) -> dict[str, Any]:
    body, facts = points(**values), answers(gravity_on_points, **values)
    masses = ", ".join(f"$m_{k + 1} = {said(mass)}$" for k, mass in enumerate(body.masses))
    centre, torque = "{centre_x}, {centre_y}, {centre_z}", "{torque_x}, {torque_y}, {torque_z}"
    facts |= {f"torque_{letter}": facts[f"torque_{letter}"] + 0.0 for letter in "xyz"}
    facts |= {"masses": masses, "centre": centre}
    facts["size"] = math.hypot(*(facts[f"torque_{letter}"] for letter in "xyz"))
    if not np.any(body.torque):
        return facts | {"turning": "which is zero here", "torque": "There is no torque."}
    turning = f"here ({torque}) N m, of the magnitude {{size}} N m"
    across = "The torque N, {size} newton metres, is horizontal and at right angles to R_CM."
    return facts | {"turning": turning, "torque": across}


WEIGHTS = Drawing(
    "weights",
    "The weights of three points, and one at their centre of mass",
    "",
    gravity_on_points.parameters,
    pen.alone(2.7, lambda axes, **values: draw_weights(axes, points(**values))),
    "Three masses, {masses} kg, held together by light rods and held at the origin, and their "
    "weights at $g = {g}$ m/s². The whole mass $M = {mass}$ kg at the centre of mass, "
    r"$\mathbf R_{\text{CM}} = ({centre})$ m, has their torque: $\sum \mathbf r_k "
    r"\times m_k\mathbf g = \mathbf R_{\text{CM}} \times M\mathbf g$, {turning}; and their "
    "potential energy, {potential} J. Weights are drawn to one scale, places to another; dotted "
    r"lines lead to the plane of $\hat{\mathbf x}$ and $\hat{\mathbf y}$.",
    "Three balls at the ends of rods from one point, each with an arrow down, its weight. From the "
    "same point R_CM leads to the centre of mass, {centre_z} metres above it, where one arrow Mg "
    "points down, as long as the other three together. {torque}",
    _facts,
)
