"""Discs and wheels on paper, and which way they turn."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from rigidtop.figures import style as look
from rigidtop.figures.space import Scene, View, outline, paper, ring, unit
from rigidtop.figures.style import Floats

TAIL, HEAD = 3.6, 1.0
"""Where a curved arrow begins and ends, in angles from the side of the eye (rad)."""


def nearest_side(view: View, axis: ArrayLike) -> Floats:
    """A vector across `axis` to the side that is nearest to the eye; up where there is none."""
    along, eye = unit(axis), view.axes[2]
    across = eye - (eye @ along) * along
    return unit(across) if float(np.linalg.norm(across)) > 1e-6 else view.axes[1]


def solid_disc(
    scene: Scene,
    centre: ArrayLike,
    axis: ArrayLike,
    radius: float,
    thickness: float,
    zorder: float = 2,
) -> None:
    """A cylinder with its middle at `centre`: its outline, and the face that is turned to us."""
    along, middle = unit(axis), np.asarray(centre, dtype=float)
    side = nearest_side(scene.view, along)
    faces = [ring(middle + half * thickness * along, along, radius, side) for half in (-0.5, 0.5)]
    near = faces[1] if float(along @ scene.view.axes[2]) > 0 else faces[0]
    style: dict[str, Any] = {"ec": look.EDGE, "lw": 0.7, "joinstyle": "round"}
    scene.axes.fill(
        *outline(scene.view, np.vstack(faces)).T, fc=look.MANTLE, zorder=zorder, **style
    )
    scene.face(near, fc=look.FACE, zorder=zorder + 0.05, **style)


def sense_of_turn(
    scene: Scene,
    centre: ArrayLike,
    axis: ArrayLike,
    radius: float,
    rate: float,
    words: str,
    *,
    left: bool = False,
    zorder: float = 4,
) -> Floats:
    """A curved arrow about `axis` in the sense of a `rate`, with its name beside it.

    The head is on the side of the eye, what lies behind the axis is dashed.  Returns its points.
    """
    along = math.copysign(1.0, rate) * unit(axis)
    middle = np.asarray(centre, dtype=float)
    view = scene.view
    front = nearest_side(view, along)
    first = ring(np.zeros(3), along, 1.0, front, -TAIL, 2)[1]
    points = ring(middle, along, radius, first, TAIL + HEAD)
    behind = view(points)[2] < float(view(middle)[2]) - 1e-9
    scene.curve(points, behind, color=look.OMEGA, lw=1.2, zorder=zorder)
    tip = zorder + 0.1
    scene.head(points[[-8, -1]], width=0.16, length=0.34, color=look.OMEGA, lw=0.8, zorder=tip)
    x, _, _ = view(points)
    k, shift, side = (np.argmin(x), -4, "right") if left else (np.argmax(x), 4, "left")
    scene.words(points[k], words, (shift, -3), color=look.OMEGA, ha=side, zorder=8)
    return points


def fit(
    scene: Scene,
    points: ArrayLike,
    margins: tuple[float, float, float, float],
) -> None:
    """Paper just large enough for `points` (N, 3), with margins (left, right, below, above).

    The margins are shares of the larger side: they are for words, whose size is that of letters.
    """
    x, y, _ = scene.view(points)
    size = max(float(np.ptp(x)), float(np.ptp(y)))
    left, right, below, above = (size * margin for margin in margins)
    paper(
        scene.axes,
        (float(x.min()) - left, float(x.max()) + right),
        (float(y.min()) - below, float(y.max()) + above),
    )
