"""A solid cone that stands on its tip and leans: its weight, torque and height (section 3.5.1)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.derivations.exercises.net_torque import gravity_on_a_solid
from rigidtop.figures import picture as pen
from rigidtop.figures import solids
from rigidtop.figures import style as look
from rigidtop.figures.bodies import vertical
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.solved import answers
from rigidtop.figures.space import UPRIGHT, View, circle
from rigidtop.figures.style import Floats, degrees
from rigidtop.motion.attitude import from_euler_angles

TALL = 1.4
"""Of the arrow ẑ, where the mantle of the cone has the length 1."""

NARROW = 0.15
"""An arc that goes less far has no room for a name."""


def view_of(phi: float) -> View:
    """From where a cone that leans towards the azimuth `phi` (rad) leans to the right, and what
    points into the paper goes up and to the left."""
    return View(azimuth=phi - math.pi / 2 - 0.3, elevation=0.42)


def draw_leaning_cone(
    axes: Axes, radius: float, height: float, theta: float, phi: float, centre: float
) -> None:
    """The cone (m), its centre of mass at the distance `centre` (m) from the tip, and N.

    The cone is to scale, its mantle has the length 1; Mg and N have lengths of their own.  The
    paper is as large as they need.
    """
    view, attitude = view_of(phi), from_euler_angles(theta, phi, 0.0).as_matrix()
    e3, nodes = attitude[:, 2], attitude[:, 1]
    level = np.array([math.cos(phi), math.sin(phi), 0.0])  # where it leans to
    size = math.hypot(radius, height)
    place = centre / size * e3
    weight = place - 0.42 * UPRIGHT
    lean = theta * np.linspace(0.0, 1.0, 61)
    way = 1.18 * (np.outer(np.cos(lean), UPRIGHT) + np.outer(np.sin(lean), level))
    upright = vertical(theta)
    parts: list[pen.Part] = [
        *solids.cone(e3, height / size, radius / size),
        pen.Arrow(TALL * UPRIGHT, look.Z, look.GREY, 0.8, shift=(-8, 0)),
        pen.Arrow(1.35 * e3, look.E3, look.AXIS, 1.0, shift=(9, 0)),
        pen.Arrow(place, lw=2.0),
        *_height(place, level),
        pen.Arrow(weight, start=place),
        pen.Words(weight, look.WEIGHT, (6, 2)),
        pen.Mark(place),
        pen.Words(place, look.R_CM, (7, -9)),
        pen.couple(0.0 * nodes if upright else 0.85 * nodes, (20, -4)),
    ]
    edge = [
        circle(e3, math.atan2(radius, height)),
        TALL * UPRIGHT,
        1.35 * e3,
        weight,
        -0.2 * UPRIGHT,
    ]
    if not upright:
        parts += [*_angle(view, way, r"$\theta$", (-8, -2), 3), *_azimuth(view, phi, level)]
        edge.append(1.1 * way)
    pen.draw(axes, parts, view)
    x, y, _ = view(np.vstack(edge))
    pen.paper(axes, (min(x.min(), -1.1), max(x.max(), 0.7) + 0.2), (y.min() - 0.1, y.max() + 0.1))


def _azimuth(view: View, phi: float, level: Floats) -> list[pen.Part]:
    """The azimuth from x̂ to the direction into which the cone leans, under it."""
    turned = math.remainder(phi, 2 * math.pi) * np.linspace(0.0, 1.0, 61)
    way = 0.4 * np.column_stack([np.cos(turned), np.sin(turned), 0 * turned])
    return [
        pen.Arrow([0.6, 0.0, 0.0], look.X, look.GREY, 0.7, z=1.5),
        pen.guide([pen.ORIGIN, 0.5 * level], ls=look.DOTTED, z=1.5),
        *_angle(view, way, degrees(phi), (2, -8), 1.5),
    ]


def _angle(view: View, way: Floats, words: str, aside: pen.Shift, z: float) -> list[pen.Part]:
    """An arc (N, 3) about the origin, and its name: outside, or `aside` where there is no room."""
    x, y, _ = view(way)
    narrow = float(np.linalg.norm(way[-1] - way[0])) < NARROW
    k = 0 if narrow else 2 * len(way) // 5
    away = (8 if words.startswith("$") else 15) / math.hypot(x[k], y[k])
    shift = aside if narrow else (float(x[k]) * away, float(y[k]) * away)
    arc = pen.Curve(way, look.NOTE, 0.8, z=z, label="_angle")
    return [arc, pen.Words(way[k], words, shift, look.NOTE, "center", "center", z=z)]


def _height(place: Floats, level: Floats) -> list[pen.Part]:
    """R cos θ, the height of the centre of mass over the tip, on the other side of ẑ."""
    beyond, height = -0.62 * level, place[2] * UPRIGHT
    top = beyond + height
    return [
        pen.guide([place, 1.1 * beyond + height], ls=look.DASHED, z=2.9),
        pen.guide([pen.ORIGIN, 1.1 * beyond], ls=look.DASHED, z=2.9),
        pen.Arrow(top, "", look.NOTE, 0.8, beyond, z=3, size=(0.12, 0.25), ends="<|-|>"),
        pen.Words((beyond + top) / 2, r"$R\,\cos\theta$", (-4, 0), look.NOTE, "right", "center"),
    ]


def _draw(axes: Axes, **values: float) -> None:
    found = answers(gravity_on_a_solid, **values)
    radius, height, theta, phi = (values[name] for name in ("radius", "height", "theta", "phi"))
    draw_leaning_cone(axes, radius, height, theta, phi, found["R"])


def _facts(theta: float, **others: float) -> dict[str, Any]:
    facts = answers(gravity_on_a_solid, theta=theta, **others)
    if vertical(theta):
        leans = r"on the vertical, $\theta = {theta:°}$, where it has no azimuth and $N = 0$"
        return facts | {"leans": leans, "turning": "There is no torque, as the axis is vertical."}
    leans = (
        r"leaning at $\theta = {theta:°}$ towards the azimuth {phi:°}; $\mathbf N$, along "
        r"$\mathbf e_2'$, of magnitude $MgR \sin\theta = {torque}$ N m, is horizontal"
    )
    turning = "The torque N points horizontally into the paper, at right angles to e3 and z."
    return facts | {"leans": leans, "turning": turning}


LEANING_CONE = Drawing(
    "leaning-cone",
    "A solid cone on its tip: torque and potential energy",
    "",
    gravity_on_a_solid.parameters,
    pen.alone(3.0, _draw),
    "A solid cone on its tip, of radius {radius} m, height {height} m and density {density} kg/m³, "
    "{leans}. The centre of mass of the cone is at $R = {R}$ m, three quarters of its height, and "
    "with $M = {mass}$ kg and $g = {g}$ m/s² its potential energy is "
    r"$MgR \cos\theta = {potential}$ J. The cone is to scale, the arrows are not.",
    "A cone that stands on its tip, its axis e3 at {theta:°} degrees to the upright z. R_CM leads "
    "from the tip to the centre of mass, {R} metres, from which the weight Mg points down. Beside "
    "it its height over the tip is marked, R cos theta. {turning}",
    _facts,
)
