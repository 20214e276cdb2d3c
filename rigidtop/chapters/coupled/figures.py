"""The two modes in flashes of light, and the beats."""

from __future__ import annotations

import math
from functools import partial
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.drawing import Drawing, Film, film
from rigidtop.figures.style import Floats
from rigidtop.parameters import Parameter

from .swings import swing

THETA = Parameter("theta", 0.35, "deflection at the start", "rad", above=0, most=0.8)
STIFFNESS = Parameter("stiffness", 0.15, "stiffness of the spring, $Dl/mg$", above=0, most=2)
APART, COILS = 1.5, 9
"""Between the pivots, by the length of a string; turns of the spring."""


def frequencies(stiffness: float) -> tuple[float, float]:
    """ω₁ and ω₂ by (2.3) and (2.4), where l = g = m = 1."""
    return 1.0, math.sqrt(1 + 2 * stiffness)


def let_go(start: tuple[float, float], stiffness: float, times: Floats) -> Floats:
    """The deflections (N, 2) of pendulums that are let go at rest, where l = g = m = 1."""
    return swing(start, 1.0, 1.0, 1.0, stiffness).integrate(times).q


def pendulums(angles: Floats, light: bool = False) -> list[pen.Part]:
    """Two pendulums with the spring between them; or where they are at another time, in grey."""
    pivots = np.array([-APART / 2, APART / 2])
    x, y = pivots + np.sin(angles), -np.cos(angles)
    color, z = (look.RULE, 1.0) if light else (look.INK, 3.0)
    parts: list[pen.Part] = [
        pen.Curve(([a, b], [0.0, c]), color, 0.7 if light else 1.1, z=z)
        for a, b, c in zip(pivots, x, y, strict=True)
    ]
    if light:
        return [*parts, pen.Markers((x, y), color, 6, fill="white", z=1.5)]
    along = np.linspace(0.0, 1.0, 4 * COILS + 1)
    bends = np.where((along > 0.12) & (along < 0.88), np.sin(2 * math.pi * COILS * along), 0.0)
    gap = np.array([x[1] - x[0], y[1] - y[0]])
    across = np.array([-gap[1], gap[0]]) / math.hypot(*gap)
    spring = np.array([x[0], y[0]]) + np.outer(along, gap) + 0.05 * np.outer(bends, across)
    return [
        *parts,
        pen.Curve(spring, lw=0.8, z=2),
        pen.Markers((x, y), look.FIRST, 10, fill=look.FACE, z=6),
        pen.Curve(([-1.25, 1.25], 0.0), look.NOTE, 2.2, z=4),
        pen.Markers((pivots, 0.0), look.NOTE, 2.5),
    ]


# --- Modes ---------------------------------------------------------------------------------------


def draw_mode(axes: Axes, sign: int, theta: float, stiffness: float) -> None:
    """One mode in flashes of half a period, drawn in full where it is let go."""
    rate = frequencies(stiffness)[sign < 0]
    times = np.linspace(0.0, math.pi / rate, 6)
    run = let_go((theta, sign * theta), stiffness, times)
    name = (r"$\omega_2$", r"$\omega_1$")[sign > 0]
    factor = "" if sign > 0 else rf"{look.in_math(rate)}\,"
    words = rf"{name}${{}} = {factor}\sqrt{{g/l}}$"
    parts = [part for angles in run[1:] for part in pendulums(angles, light=True)]
    parts += [*pendulums(run[0]), pen.Words((0.0, -1.42), words, ha="center")]
    pen.picture(axes, parts, (-1.65, 1.65), (-1.5, 0.1))


MODES = Drawing(
    "modes",
    "The two modes",
    "2",
    (THETA, STIFFNESS),
    pen.abreast(1.35, partial(draw_mode, sign=1), partial(draw_mode, sign=-1)),
    "They are let go at {theta:°}; grey: in flashes of light, at equal intervals, until they have "
    "come to the other side. The spring has $Dl/mg = {stiffness}$.",
    "Two pictures of two pendulums with a spring between the bobs. On the left both lean to the "
    "right by {theta:°} degrees, on the right they lean apart. Light lines show where they are in "
    "later flashes, to the other side.",
)


# --- Beats ---------------------------------------------------------------------------------------


def _span(stiffness: float) -> float:
    """Two exchanges."""
    first, second = frequencies(stiffness)
    return min(2 * math.pi / (second - first), 80 * math.pi)


def _curves(axes: Axes, k: int, theta: float, stiffness: float, until: float = 1.0) -> None:
    """One deflection in time, in degrees, between what changes slowly in (2.8)."""
    first, second = frequencies(stiffness)
    t = np.linspace(0.0, _span(stiffness), 1201)
    slow = (second - first) * t / 2
    bound = math.degrees(theta) * np.abs((np.cos, np.sin)[k](slow))
    shown = t <= until * t[-1]
    run = np.degrees(let_go((theta, 0.0), stiffness, t)[:, k])
    turns = t / (2 * math.pi)
    parts: list[pen.Part] = [
        pen.Curve((turns, sign * bound), look.SECOND, 0.9, look.DASHED, z=3) for sign in (1, -1)
    ]
    parts += [pen.Curve((turns[shown], run[shown]), look.FIRST, 1.1)]
    if until < 1:
        parts += [pen.Markers((turns[shown][-1], run[shown][-1]), look.FIRST, 4)]
    most = 1.08 * math.degrees(theta)
    limits = {"xlim": (0, turns[-1]), "ylim": (-most, most)}
    pen.chart(axes, [*parts, pen.Rule(y=0.0)], "", rf"$\theta_{k + 1}$  (degrees)", **limits)


def _beats(*panels: Axes, theta: float, stiffness: float, until: float = 1.0) -> None:
    for k, axes in enumerate(panels):
        _curves(axes, k, theta, stiffness, until)
    panels[0].tick_params(labelbottom=False)
    panels[1].set_xlabel(r"time  (periods $2\pi\,\sqrt{l/g}$)")


def _film(theta: float, stiffness: float) -> Film:
    """The pendulums above, what they did below; two exchanges."""

    def show(share: float, above: Axes, *below: Axes) -> None:
        _beats(*below, theta=theta, stiffness=stiffness, until=share)
        now = np.array([share * _span(stiffness)])
        bobs = pendulums(let_go((theta, 0.0), stiffness, now)[0])
        pen.picture(above, bobs, (-1.65, 1.65), (-1.15, 0.1))

    boxes = (0.2, 0.6, 0.6, 0.39), (0.12, 0.36, 0.85, 0.21), (0.12, 0.11, 0.85, 0.21)
    return film(look.TEXT, 4.4, show, *boxes)


def _facts(stiffness: float, **_: float) -> dict[str, Any]:
    first, second = frequencies(stiffness)
    return {"exchange": first / (2 * (second - first))}


BEATS = Drawing(
    "beats",
    "Beats of two pendulums",
    "2",
    (Parameter("theta", 0.2, THETA.about, "rad", above=0, most=0.5), STIFFNESS),
    pen.panels(look.TEXT, 2.9, _beats, 2, sharex=True),
    "The first pendulum is let go at {theta:°}. The equations are integrated with their sines and "
    "cosines; dashed: what changes slowly in (2.8). With $Dl/mg = {stiffness}$ the second one has "
    "all after {exchange} periods.",
    "Two curves over the time, one above the other. The first deflection starts wide, at {theta:°} "
    "degrees, dies down and comes back; the second is widest where the first is at rest, after "
    "{exchange} periods.",
    _facts,
    _film,
)

FIGURES = (MODES, BEATS)
