"""A wheel on a slope in flashes of light, and the circle of a ball on a turntable."""

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

from .rolling import down, set_down

# --- The wheel -----------------------------------------------------------------------------------

RATIO = Parameter("ratio", 1.0, "$I$ by $mR^2$", above=0, most=1)
SLOPE = Parameter("slope", math.radians(22), "slope", "rad", least=0.1, most=1.0)
WAY, FLASHES = 7.0, 5
"""By R, and how often light falls on it."""


def rim(centre: Floats, angle: float, light: bool) -> list[pen.Part]:
    """The wheel of radius 1 with a spoke that has turned by an angle, clockwise."""
    edge = bow(1.0, centre=centre)
    spoke = [centre, centre + np.array([math.sin(angle), math.cos(angle)])]
    color = look.RULE if light else look.EDGE
    face = [] if light else [pen.Face(edge, look.MANTLE, z=1)]
    return [*face, pen.Curve(edge, color, 1.2), pen.Curve(spoke, color, 1.2)]


def draw_wheel(axes: Axes, ratio: float, slope: float) -> None:
    """The wheel where it is let go and later, and the forces on it; mg is 2.4 R long."""
    along = np.array([math.cos(slope), -math.sin(slope)])
    out = np.array([math.sin(slope), math.cos(slope)])
    last = math.sqrt(2 * WAY * (1 + ratio) / math.sin(slope))
    s, chi = down(ratio, slope, 1.0, 1.0, 1.0).integrate(np.linspace(0.0, last, FLASHES)).q.T
    parts: list[pen.Part] = []
    for way, angle in reversed([*zip(s, chi, strict=True)]):
        parts += rim(way * along + out, angle, light=way > 0)
    low, high = -1.6 * along, (WAY + 1.4) * along
    ground = [low, high, [low[0], high[1]]]
    touch, weight = np.zeros(2), 2.4
    friction = weight * ratio / (1 + ratio) * math.sin(slope)
    arrows = (
        (out, np.array([0.0, -weight]), r"$m\mathbf{g}$", (9, 2)),
        (touch, weight * math.cos(slope) * out, r"$\mathbf{S}$", (8, 3)),
        (touch, -friction * along, r"$|\mu|$", (-3, -9)),
    )
    for start, force, words, shift in arrows:
        parts.append(pen.Arrow(start + force, words, look.TORQUE, 1.5, start, shift, 6))
    parts += [
        pen.Face(ground, look.GROUND, z=0.5),
        pen.Curve(ground[:2], look.NOTE, 1.2, z=1.5),
        pen.Curve(bow(2.2, math.pi, math.pi - slope, high), lw=0.8),
        pen.Words((high[0] - 2.6, high[1]), r"$\alpha$", (0, 3), ha="right"),
        pen.Markers([out, touch], size=3),
    ]
    pen.picture(axes, parts, (low[0] - 0.1, high[0] + 0.1), (high[1] - 0.1, 2.75))


def _wheel_facts(ratio: float, slope: float) -> dict[str, Any]:
    share = 1 / (1 + ratio)
    return {"share": share, "rough": ratio * share * math.tan(slope)}


WHEEL = Drawing(
    "wheel",
    "A wheel that rolls down a slope",
    "1",
    (RATIO, SLOPE),
    pen.alone(2.4, draw_wheel),
    r"The slope is $\alpha = {slope:°}$, and $I/mR^2 = {ratio}$; $\mathbf S$ is the push of the "
    "slope. The wheel has {share:%} per cent of the acceleration of something that slides without "
    r"friction, and does not slip for $\mu_s > {rough}$. Grey: in flashes of light, at equal "
    "intervals.",
    "A wheel with a spoke on a slope of {slope:°} degrees. Arrows are its weight, the push of the "
    "slope and the friction, which points up the slope. Further down it stands in grey, farther "
    "and farther apart, the spoke turned.",
    _wheel_facts,
)

# --- The ball ------------------------------------------------------------------------------------

D = Parameter("d", 0.2, "distance from the axis at the start", "m", least=0.05, most=1)
V = Parameter("v", 0.1, "velocity at the start, outwards", "m/s", above=0, most=2)
TURN = Parameter("turn", math.pi, r"rate of the table, $\Omega$", "rad/s", above=0)


def places(d: float, v: float, turn: float, times: Floats) -> Floats:
    """Of the ball (N, 2), as seen from the room."""
    return set_down((d, 0.0), (v, 0.0), turn).integrate(times).q[:, :2]


def _rounds(turn: float, count: int = 1) -> Floats:
    """Times, so often round the circle."""
    return np.linspace(0.0, 7 * math.pi * count / turn, 600 * count + 1)


def _on_table(run: Floats, angles: Floats) -> Floats:
    """The same places for somebody who stands on the table."""
    c, s = np.cos(angles), np.sin(angles)
    return np.stack([c * run[:, 0] + s * run[:, 1], c * run[:, 1] - s * run[:, 0]], axis=1)


def _table(axes: Axes, size: float, angle: float, words: str) -> None:
    spokes = bow(size, angle, angle + 2 * math.pi, count=7)[:-1]
    parts = [
        pen.Face(bow(size), look.GROUND, look.RULE, z=0.4),
        *(pen.guide([0 * end, end], color=look.RULE, lw=0.7) for end in spokes),
        pen.Markers((0.0, 0.0), look.NOTE, 3),
        pen.Words((0.0, -size), words, (0, -12), look.NOTE, "center", size=look.SMALL),
    ]
    pen.picture(axes, parts, (-1.08 * size, 1.08 * size), (-1.25 * size, 1.08 * size))


def _size(d: float, v: float, turn: float) -> float:
    """Of a table on which there is room for the circle."""
    radius = 7 * v / (2 * turn)
    return 1.15 * (math.hypot(d, radius) + radius)


def draw_room(axes: Axes, d: float, v: float, turn: float, share: float = 1.0) -> None:
    """The ball as seen from the room, until a share of the circle."""
    size, times = _size(d, v, turn), _rounds(turn)
    run = places(d, v, turn, times)
    passed = run[times <= share * times[-1]]
    _table(axes, size, turn * share * times[-1], "from the room")
    tip, centre = (d + 0.35 * size, 0.0), (d, 7 * v / (2 * turn))
    parts: list[pen.Part] = [
        pen.Curve(passed, look.FIRST, 1.4, z=3),
        pen.Markers(centre, look.SECOND, 5, "+", words=r"$\mathbf{c}$", shift=(5, 3)),
        pen.Markers(passed[-1], look.INK, 9 if share < 1 else 7, fill=look.FACE),
    ]
    if share == 1:
        parts.append(pen.Arrow(tip, r"$\mathbf{v}$", look.INK, 1.2, (d, 0.0), (7, 3)))
    pen.draw(axes, parts)


def draw_on_table(axes: Axes, d: float, v: float, turn: float) -> None:
    """The same for somebody who stands on the table."""
    times = _rounds(turn, 2)  # after seven turns of the table the path closes
    path = _on_table(places(d, v, turn, times), turn * times)
    _table(axes, _size(d, v, turn), 0.0, "from the table")
    ball = pen.Markers((d, 0.0), look.INK, 7, fill=look.FACE)
    pen.draw(axes, [pen.Curve(path, look.FIRST, 1.4, z=3), ball])


def _film(**values: float) -> Film:
    """Once round the circle, from the room; the table turns below."""
    return film(look.COLUMN, 3.6, lambda share, axes: draw_room(axes, **values, share=share))


CIRCLE = Drawing(
    "circle",
    "A ball on a turntable",
    "2",
    (D, V, TURN),
    pen.abreast(2.75, draw_room, draw_on_table),
    r"The table turns to the left at $\Omega = {turn}$ rad/s; the ball starts {d} m from the axis "
    r"with $v = {v}$ m/s and goes round in {time} s, at the distance {radius} m from $\mathbf c$. "
    "Right: two rounds as seen by somebody on the table.",
    "Two round tables from above. On the left the ball goes round in a circle of {radius} m about "
    "a point c that is not the axis of the table; on the right, from the table, its path winds "
    "about the axis seven times and closes.",
    lambda d, v, turn: {"radius": 7 * v / (2 * turn), "time": 7 * math.pi / turn},
    _film,
)

FIGURES = (WHEEL, CIRCLE)
