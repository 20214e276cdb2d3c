"""Space on paper, seen from far away: the view, and points on circles and arcs."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from rigidtop.figures.style import Floats

ROUNDING = 1e-12

UPRIGHT = np.array([0.0, 0.0, 1.0])
"""ẑ."""


@dataclass(frozen=True)
class View:
    """Where the eye is: azimuth from x̂ towards ŷ, and elevation over the xy plane (rad)."""

    azimuth: float = 0.0
    elevation: float = 0.42

    @property
    def axes(self) -> Floats:
        """Rows: to the right, up, and towards the eye, as vectors of space."""
        ca, sa = math.cos(self.azimuth), math.sin(self.azimuth)
        ce, se = math.cos(self.elevation), math.sin(self.elevation)
        return np.array([[-sa, ca, 0.0], [-se * ca, -se * sa, ce], [ce * ca, ce * sa, se]])

    def __call__(self, points: ArrayLike) -> tuple[Floats, Floats, Floats]:
        """Right, up and towards the eye, of points (…, 3)."""
        across, up, near = np.moveaxis(np.asarray(points, dtype=float) @ self.axes.T, -1, 0)
        return across, up, near


def unit(vector: ArrayLike) -> Floats:
    """The direction of a vector (3,); a vector of no length stays."""
    values = np.asarray(vector, dtype=float)
    size = float(np.linalg.norm(values))
    return values / size if size else values


def circle(axis: ArrayLike, half_angle: float, count: int = 241, length: float = 1.0) -> Floats:
    """Points (count, 3) at `length` from the origin and `half_angle` (rad) from an axis, round it.

    They go round it by the right hand.
    """
    along = unit(axis)
    across = np.cross(along, [1.0, 0.0, 0.0] if abs(along[0]) < 0.9 else [0.0, 1.0, 0.0])
    centre, radius = length * math.cos(half_angle) * along, length * math.sin(half_angle)
    return ring(centre, along, radius, across, count=count)


def ring(
    centre: ArrayLike,
    axis: ArrayLike,
    radius: float,
    towards: ArrayLike,
    sweep: float = 2 * math.pi,
    count: int = 121,
) -> Floats:
    """Points (count, 3) on a circle: by the angle `sweep` (rad) about `axis`, by the right hand.

    They begin on the side `towards` which a vector points that is not along the axis.
    """
    along, wanted = unit(axis), np.asarray(towards, dtype=float)
    first = unit(wanted - (wanted @ along) * along)
    turn = np.linspace(0.0, sweep, count)[:, None]
    second = np.cross(along, first)
    points = radius * (np.cos(turn) * first + np.sin(turn) * second)
    return np.asarray(centre, dtype=float) + points


def bow(
    radius: float,
    first: float = 0.0,
    last: float = 2 * math.pi,
    centre: ArrayLike = (0.0, 0.0),
    count: int = 121,
) -> Floats:
    """Points (count, 2) of the paper on a circle, from one angle to another (rad)."""
    turn = np.linspace(first, last, count)
    return np.asarray(centre) + radius * np.column_stack([np.cos(turn), np.sin(turn)])


def arc(first: ArrayLike, last: ArrayLike, count: int = 61, length: float = 1.0) -> Floats:
    """Points (count, 3) on the shorter great circle between two directions."""
    a, b = unit(first), unit(last)
    angle = math.atan2(float(np.linalg.norm(np.cross(a, b))), float(a @ b))
    across = unit(b - (a @ b) * a)
    turn = np.linspace(0.0, angle, count)[:, None]
    return length * (np.cos(turn) * a + np.sin(turn) * across)


def total(vectors: Floats, sizes: float = 0.0) -> Floats:
    """The sum of vectors (N, 3); zero where it is no more than rounding.

    `sizes` are those of the factors, where the vectors themselves may be no more than that.
    """
    found: Floats = vectors.sum(axis=0)
    most = max(sizes, float(np.linalg.norm(vectors, axis=1).sum()))
    return np.zeros(3) if np.linalg.norm(found) <= ROUNDING * most else found


def nearest_side(view: View, axis: ArrayLike) -> Floats:
    """A vector across `axis` to the side that is nearest to the eye; up where there is none."""
    along, eye = unit(axis), view.axes[2]
    across = eye - (eye @ along) * along
    return unit(across) if float(np.linalg.norm(across)) > 1e-6 else view.axes[1]
