"""Nutation: the path of the figure axis."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Canvas
from numpy.typing import ArrayLike

from rigidtop.motion.motion import TopMotion
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter
from rigidtop.present.figures.bodies import SPIN, THETA, TOP, start_in_words, top_in_words
from rigidtop.present.figures.drawing import Drawing
from rigidtop.present.figures.space import View, arrow, circle, on_sphere, paper, sphere
from rigidtop.present.figures.style import (
    FIRST,
    GREY,
    INK,
    RULE,
    WIDE,
    Floats,
    Z,
    canvas,
    said,
    spoken,
)

# --- The path of e₃ on the sphere ----------------------------------------------------------------

MOST_NUTATIONS = 14
"""In one picture; more of them blur."""

UPRIGHT = np.array([0.0, 0.0, 1.0])


def draw_path(axes: Axes, e3: ArrayLike, title: str = "") -> None:
    """The path of the figure axis, unit vectors (N, 3) in space, on the sphere."""
    path = np.asarray(e3, dtype=float)
    view = View(elevation=0.5)
    sphere(axes)
    on_sphere(axes, view, circle(UPRIGHT, math.pi / 2), color=RULE, lw=0.8)
    polar = np.arccos(np.clip(path[:, 2], -1, 1))
    for theta in (polar.min(), polar.max()):
        on_sphere(axes, view, circle(UPRIGHT, float(theta)), color=GREY, lw=0.7)
    on_sphere(axes, view, path, color=FIRST, lw=1.3, label="_path")
    arrow(axes, view, 1.45 * UPRIGHT, Z, start=UPRIGHT, lw=0.9, shift=(7, -3))
    paper(axes, (-1.04, 1.04), (-1.04, 1.34))
    if title:
        axes.set_title(title, color=INK)


def nutation_times(motion: TopMotion, samples: int = 2400) -> Floats:
    """Times (s) of a path that shows how a motion nutates: about half a turn of precession."""
    period = motion.nutation_period
    if not math.isfinite(period):  # to the upright, or at rest
        top = motion.body
        rate = math.hypot(*motion.omega[:2]) + math.sqrt(top.M * top.g * top.R / top.lambda1)
        return np.linspace(0.0, 12 / rate, samples)
    turn = abs(motion.mean_precession)
    wanted = 4.2 / turn if turn else math.inf
    return np.linspace(0.0, min(max(wanted, 2 * period), MOST_NUTATIONS * period), samples)


def _paths(theta: float, phi_dot: float, omega3: float, **top: float) -> list[TopMotion]:
    """φ̇ at the start positive, zero, negative; the middle of the picture faces the reader."""
    body = HeavyTop(**top)
    return [
        body.motion(theta=theta, phi=-1.25, phi_dot=rate, omega3=omega3)
        for rate in (phi_dot, 0.0, -phi_dot)
    ]


def _draw_paths(**values: float) -> Canvas:
    drawn = canvas(WIDE, 2.55)
    motions = _paths(**values)
    for axes, motion in zip(drawn.subplots(1, 3), motions, strict=True):
        draw_path(axes, motion.exact(nutation_times(motion)).e3, motion.regime)
    return drawn


def _paths_caption(theta: float, phi_dot: float, omega3: float, **top: float) -> str:
    body = HeavyTop(**top)
    return (
        f"The path of e₃ on the sphere from {start_in_words(theta, omega3)} with θ̇ = 0 and "
        f"φ̇ = {said(phi_dot)}, 0 and {said(-phi_dot)} rad/s, for {top_in_words(body)}. "
        "The thin circles are the turning points of θ."
    )


def _paths_in_words(**values: float) -> str:
    regimes = [motion.regime for motion in _paths(**values)]
    return (
        "Three spheres with the path of the figure axis between two circles of latitude, for a "
        f"start with phi dot {spoken(values['phi_dot'])}, zero and {spoken(-values['phi_dot'])} "
        f"radians per second: {', '.join(regimes)}."
    )


PATHS = Drawing(
    "paths",
    "The path of e₃ on the sphere: waves, cusps, loops",
    "3.5.4",
    (
        *TOP,
        THETA,
        Parameter("phi_dot", 1.6, "φ̇ at the start, in turn positive, 0, negative", "rad/s"),
        SPIN,
    ),
    _draw_paths,
    _paths_caption,
    _paths_in_words,
)
