"""A solid cone that stands on its tip and leans: its weight, torque and height (section 3.5.1)."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.derivations.exercises.net_torque import gravity_on_a_solid
from rigidtop.figures import style as look
from rigidtop.figures.bodies import vertical
from rigidtop.figures.drawing import Drawing
from rigidtop.figures.solved import answers
from rigidtop.figures.space import UPRIGHT, Scene, View, circle, paper, top_body
from rigidtop.figures.style import Floats, alone, degrees, said, spoken
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
    scene = Scene(axes, view_of(phi))
    attitude = from_euler_angles(theta, phi, 0.0).as_matrix()
    e3, nodes = attitude[:, 2], attitude[:, 1]
    level = np.array([math.cos(phi), math.sin(phi), 0.0])  # where it leans to
    size = math.hypot(radius, height)
    place = centre / size * e3
    weight = place - 0.42 * UPRIGHT
    top_body(scene, e3, height / size, radius / size)
    scene.arrow(TALL * UPRIGHT, look.Z, lw=0.8, color=look.GREY, shift=(-8, 0))
    scene.arrow(1.35 * e3, look.E3, color=look.AXIS, lw=1.0, shift=(9, 0))
    scene.arrow(place, color=look.INK, lw=2.0)
    lean = theta * np.linspace(0.0, 1.0, 61)
    way = 1.18 * (np.outer(np.cos(lean), UPRIGHT) + np.outer(np.sin(lean), level))
    if not vertical(theta):
        _draw_angle(scene, way, r"$\theta$", (-8, -2), zorder=3)
        _draw_azimuth(scene, phi, level)
    _draw_height(scene, place, level)
    scene.arrow(weight, start=place, color=look.INK, lw=1.4)
    scene.words(weight, look.WEIGHT, (6, 2), color=look.INK)
    scene.dot(place)
    scene.words(place, look.R_CM, (7, -9), color=look.INK, zorder=8)
    scene.couple(0.0 * nodes if vertical(theta) else 0.85 * nodes, (20, -4))
    shown = [
        circle(e3, math.atan2(radius, height)),
        TALL * UPRIGHT,
        1.35 * e3,
        weight,
        -0.2 * UPRIGHT,
    ]
    if not vertical(theta):
        shown.append(1.1 * way)
    x, y, _ = scene.view(np.vstack(shown))
    paper(axes, (min(x.min(), -1.1), max(x.max(), 0.7) + 0.2), (y.min() - 0.1, y.max() + 0.1))


def _draw_azimuth(scene: Scene, phi: float, level: Floats) -> None:
    """The azimuth from x̂ to the direction into which the cone leans, under it."""
    scene.arrow([0.6, 0.0, 0.0], look.X, color=look.GREY, lw=0.7, zorder=1.5)
    scene.line(np.outer([0.0, 0.5], level), color=look.GREY, lw=0.7, ls=look.DOTTED, zorder=1.5)
    turned = math.remainder(phi, 2 * math.pi) * np.linspace(0.0, 1.0, 61)
    way = 0.4 * np.column_stack([np.cos(turned), np.sin(turned), 0 * turned])
    _draw_angle(scene, way, degrees(phi), (2, -8), zorder=1.5)


def _draw_angle(
    scene: Scene,
    way: Floats,
    words: str,
    aside: tuple[float, float],
    *,
    zorder: float,
) -> None:
    """An arc (N, 3) about the origin, and its name: outside, or `aside` where there is no room."""
    x, y, _ = scene.view(way)
    scene.line(way, color=look.NOTE, lw=0.8, zorder=zorder, label="_angle")
    narrow = float(np.linalg.norm(way[-1] - way[0])) < NARROW
    at = 0 if narrow else 2 * len(way) // 5
    away = (8 if words.startswith("$") else 15) / math.hypot(x[at], y[at])
    shift = aside if narrow else (float(x[at]) * away, float(y[at]) * away)
    style = {"ha": "center", "va": "center", "zorder": zorder}
    scene.words(way[at], words, shift, **style)


def _draw_height(scene: Scene, place: Floats, level: Floats) -> None:
    """R cos θ, the height of the centre of mass over the tip, on the other side of ẑ."""
    beyond, height = -0.62 * level, place[2] * UPRIGHT
    for start, above in ((place, height), (np.zeros(3), 0 * UPRIGHT)):
        scene.line(
            [start, 1.1 * beyond + above], color=look.GREY, lw=0.8, ls=look.DASHED, zorder=2.9
        )
    both: dict[str, Any] = {"ends": "<|-|>", "width": 0.12, "length": 0.25, "zorder": 3}
    scene.head(np.array([beyond, beyond + height]), color=look.NOTE, lw=0.8, **both)
    middle = beyond + height / 2
    scene.words(middle, r"$R\,\cos\theta$", (-4, 0), ha="right", va="center")


def _draw(axes: Axes, **values: float) -> None:
    found = answers(gravity_on_a_solid, **values)
    radius, height, theta, phi = (values[name] for name in ("radius", "height", "theta", "phi"))
    draw_leaning_cone(axes, radius, height, theta, phi, found["R"])


def _caption(
    radius: float, height: float, density: float, theta: float, phi: float, g: float
) -> str:
    found = answers(
        gravity_on_a_solid,
        radius=radius,
        height=height,
        density=density,
        theta=theta,
        phi=phi,
        g=g,
    )
    weight = f"$g = {said(g)}$ m/s²"
    if vertical(theta):
        leans = f"on the vertical, $θ = {degrees(theta)}$, where it has no azimuth and $N = 0$"
    else:
        leans = (
            f"leaning at $θ = {degrees(theta)}$ towards the azimuth {degrees(phi)}; $𝐍$, along "
            f"$e₂′$, of magnitude $MgR sin θ = {said(found['torque'])}$ N m, is horizontal"
        )
    return (
        f"A solid cone on its tip, of radius {said(radius)} m, height {said(height)} m and density "
        f"{said(density)} kg/m³, {leans}. The centre of mass of the cone is at $R = "
        f"{said(found['R'])}$ m, three quarters of its height, and with "
        f"$M = {said(found['mass'])}$ kg and {weight} its potential energy is "
        f"$MgR cos θ = {said(found['potential'])}$ J. The cone is to scale, the arrows are not."
    )


def _in_words(**values: float) -> str:
    found = answers(gravity_on_a_solid, **values)
    theta = values["theta"]
    seen = (
        "A cone that stands on its tip, its axis e3 at "
        f"{spoken(math.degrees(theta))} degrees to the upright z. R_CM leads from the tip to the "
        f"centre of mass, {spoken(found['R'])} metres, from which the weight Mg points down. "
        "Beside it its height over the tip is marked, R cos theta. "
    )
    if vertical(theta):
        return seen + "There is no torque, as the axis is vertical."
    return seen + "The torque N points horizontally into the paper, at right angles to e3 and z."


LEANING_CONE = Drawing(
    "leaning-cone",
    "A solid cone on its tip: torque and potential energy",
    "",
    gravity_on_a_solid.parameters,
    alone(3.0, _draw),
    _caption,
    _in_words,
)
