"""The axis in the horizontal plane, and how it swings about north."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.figures import picture as pen
from rigidtop.figures import solids
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing, Film, film
from rigidtop.figures.space import UPRIGHT, View, bow, circle, ring
from rigidtop.figures.style import Floats
from rigidtop.parameters import Parameter

from .compass import MINUTE, frequency, let_go

LATITUDE = Parameter("latitude", math.radians(50), "latitude", "rad", least=0.1, most=1.45)

# --- The horizontal plane ------------------------------------------------------------------------

VIEW = View(azimuth=0.35, elevation=0.5)
EAST, NORTH = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])


def draw_level(axes: Axes, alpha: float, latitude: float) -> None:
    """The plane with our axes, the wheel on its axis, and the rotation of the earth."""
    along = math.cos(alpha) * NORTH - math.sin(alpha) * EAST
    turn = ring(pen.ORIGIN, UPRIGHT, 0.95, NORTH, alpha)
    level, up = 1.5 * math.cos(latitude) * NORTH, 1.5 * math.sin(latitude) * UPRIGHT
    plane = circle(UPRIGHT, math.pi / 2, length=1.35)
    away = bool(along @ VIEW.axes[2] < 0)
    parts: list[pen.Part] = [
        pen.Face(plane, look.GROUND, look.RULE, 0.6, z=0),
        *pen.frame(np.eye(3), 1.75, color=look.NOTE, lw=0.9, z=1.5),
        pen.guide([level, level + up]),
        pen.guide([up, level + up]),
        pen.Arrow(level, r"$\Omega\cos\beta$", look.OMEGA, 1.5, shift=(6, -11)),
        pen.Arrow(up, r"$\Omega\sin\beta$", look.OMEGA, 1.5, shift=(-24, -2)),
        pen.Arrow(level + up, r"$\boldsymbol{\Omega}$", look.OMEGA, 1.7, z=6),
        *solids.disc(pen.ORIGIN, along, 0.42, 0.1, z=3),
        pen.Arrow(1.25 * along, r"$\mathbf{a}$", look.AXIS, 1.6, z=2.5 if away else 5.5),
        pen.Curve(np.outer([-0.05, -0.45], along), look.AXIS, 1.6, z=5.5 if away else 2.5),
        pen.Turning(0.55 * along, along, 0.22, 1.0, r"$\dot\psi$"),
        *pen.angle(turn, r"$\alpha$", (9, -3), head=alpha > 0.15, z=4),
    ]
    pen.picture(axes, parts, (-1.9, 1.9), (-0.95, 1.75), VIEW)


LEVEL = Drawing(
    "level",
    "The axis in the horizontal plane",
    "1",
    (
        Parameter("alpha", math.radians(55), "angle from north", "rad", least=0.2, most=2.5),
        LATITUDE,
    ),
    pen.alone(3.0, draw_level),
    r"At the latitude $\beta = {latitude:°}$, with $\alpha = {alpha:°}$ to the west of north; "
    r"$\mathbf e_1$ points to the east, $\mathbf e_2$ to the north.",
    "A level disc with arrows to the east, to the north and upwards. A wheel stands upright on it; "
    "its axis a is level, {alpha:°} degrees to the west of north. The arrow Omega, {latitude:°} "
    "degrees above north, is the sum of an arrow to the north and one upwards.",
)

# --- The swings ----------------------------------------------------------------------------------

START = Parameter("start", math.radians(60), "angle at the start", "rad", least=0.02, most=3.0)
TURNS = Parameter("turns", 20000.0, "turns a minute", least=1000, most=50000)
ROWS = 401


@lru_cache(maxsize=16)
def swings(start: float, turns: float, latitude: float, time: float) -> tuple[Floats, Floats]:
    """Times (s) and angles (rad) of an axis that is let go."""
    t = np.linspace(0.0, time, ROWS)
    return t, let_go(start, turns * MINUTE, latitude).integrate(t).q[:, 0]


def whole(start: float, turns: float, latitude: float) -> float:
    """The time of a swing to and fro from there (s), that of a pendulum."""
    from scipy.special import ellipk

    m = math.sin(start / 2) ** 2
    return 4 * float(ellipk(m)) / frequency(turns * MINUTE, latitude)


def _at(angle: float, radius: float = 1.0) -> Floats:
    """On the dial, north upwards and west to the left."""
    return radius * np.array([-math.sin(angle), math.cos(angle)])


def wheel(angle: float, light: bool = False) -> list[pen.Part]:
    """The wheel and its axis from above."""
    along, across = _at(angle), _at(angle + math.pi / 2)
    if light:
        return [pen.Arrow(0.85 * along, "", look.RULE, 0.8, -0.6 * along, z=1)]
    corners = np.array([[1, 1], [1, -1], [-1, -1], [-1, 1]]) @ [0.07 * along, 0.34 * across]
    return [
        pen.Face(corners, look.MANTLE, look.EDGE, z=3),
        pen.Arrow(0.85 * along, "", look.AXIS, 1.6, -0.6 * along, z=4),
    ]


def draw_dial(axes: Axes, angles: Floats, flashes: Floats | None = None) -> None:
    """The wheel from above at the last of these angles; it came from the first."""
    parts: list[pen.Part] = [
        pen.guide(bow(1.0)),
        pen.Curve((-0.92 * np.sin(angles), 0.92 * np.cos(angles)), look.FIRST, 1.0, alpha=0.7),
        *wheel(float(angles[-1])),
    ]
    for words, angle in zip("NWSE", np.arange(4) * math.pi / 2, strict=True):
        parts.append(pen.guide([_at(angle, 0.95), _at(angle)]))
        place = _at(angle, 1.13)
        parts.append(pen.Words(place, words, color=look.NOTE, ha="center", va="center", size=8))
    for angle in () if flashes is None else flashes:
        parts += wheel(float(angle), light=True)
    pen.picture(axes, parts, (-1.25, 1.25), (-1.25, 1.25))


def draw_angles(axes: Axes, t: Floats, angle: Floats, until: int = ROWS) -> None:
    """The angle over time, as far as a row."""
    parts: list[pen.Part] = [
        pen.Rule(y=0.0),
        pen.Curve((t[:until], np.degrees(angle[:until])), look.FIRST),
        pen.Markers((t[until - 1], np.degrees(angle[until - 1])), look.FIRST, 4),
    ]
    most = 1.1 * math.degrees(angle[0])
    limits = {"xlim": (0, t[-1]), "ylim": (-most, most)}
    pen.chart(axes, parts, "$t$  (s)", r"$\alpha$  (degrees)", **limits)


def _search(dial: Axes, chart: Axes, **values: float) -> None:
    t, angle = swings(**values, time=2 * whole(**values))
    draw_dial(dial, angle[:1], angle[25:101:25])
    draw_angles(chart, t, angle)


def _film(**values: float) -> Film:
    """Two swings."""
    t, angle = swings(**values, time=2 * whole(**values))

    def show(share: float, dial: Axes, chart: Axes) -> None:
        until = 1 + round(share * (ROWS - 1))
        draw_dial(dial, angle[:until])
        draw_angles(chart, t, angle, until)

    return film(look.TEXT, 2.4, show, (0.0, 0.0, 0.42, 1.0), (0.55, 0.2, 0.42, 0.74))


def _facts(start: float, turns: float, latitude: float) -> dict[str, Any]:
    small = 2 * math.pi / frequency(turns * MINUTE, latitude)
    return {"small": small, "whole": whole(start, turns, latitude)}


SEARCH = Drawing(
    "search",
    "The axis swings about north",
    "3",
    (START, TURNS, LATITUDE),
    pen.panels(look.TEXT, 2.5, _search, 1, 2, width_ratios=(1, 1.5)),
    r"A thin disc with {turns} turns a minute at the latitude $\beta = {latitude:°}$, let go at "
    r"$\alpha_0 = {start:°}$. Left: from above, at equal times on the way to the other side. A "
    "swing to and fro takes {whole} s, a small one {small} s.",
    "A compass card with the wheel and its axis, which starts {start:°} degrees to the west of "
    "north; its places at four later times are grey. Beside it the angle against time: two swings "
    "to and fro of {whole} seconds each.",
    _facts,
    _film,
)

FIGURES = (LEVEL, SEARCH)
