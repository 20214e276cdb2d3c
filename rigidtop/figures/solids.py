"""Solid bodies as parts of a picture: discs, cones, boxes, and the table on which they stand."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.space import UPRIGHT, View, circle, unit
from rigidtop.figures.style import Floats


def disc(
    centre: Floats, axis: ArrayLike, radius: float, thickness: float, z: float = 2
) -> list[pen.Part]:
    """A cylinder with its middle at `centre`: its outline, and the face that is turned to us."""
    along, rim = unit(axis), radius * circle(axis, math.pi / 2)
    below, above = (rim + centre + k * thickness * along for k in (-0.5, 0.5))
    return [
        pen.Face(np.vstack([below, above]), look.MANTLE, look.EDGE, z=z, hull=True),
        pen.Face(below, look.FACE, look.EDGE, z=z + 0.05, normal=-along),
        pen.Face(above, look.FACE, look.EDGE, z=z + 0.05, normal=along),
    ]


def cone(
    e3: ArrayLike,
    height: float = 0.9,
    radius: float = 0.36,
    mark: ArrayLike | None = None,
    z: float = 2,
) -> list[pen.Part]:
    """A top on its tip at the origin, its axis along `e3`: a cone with a lid.

    `mark` is a vector fixed in the body and across the axis, towards which a line on the lid
    points, so that the turning can be seen.
    """
    axis = unit(e3)
    rim = circle(axis, math.atan2(radius, height), 121, math.hypot(height, radius))
    mantle = pen.Face(np.vstack([rim, pen.ORIGIN]), look.MANTLE, look.EDGE, z=z, hull=True)
    parts: list[pen.Part] = [mantle, pen.Face(rim, look.FACE, look.EDGE, z=z + 0.1, normal=axis)]
    if mark is not None:
        line = np.array([height * axis, height * axis + radius * unit(mark)])
        parts += [pen.Curve(line, look.EDGE, z=z + 0.3, normal=axis)]
    return parts


def cone_mantle(rim: Floats, color: str, alpha: float, z: float = 3) -> list[pen.Part]:
    """A hollow cone from the origin to its rim (N, 3), with its two edges."""
    mantle = pen.Face([*rim, pen.ORIGIN], color, lw=0, alpha=alpha)
    return [mantle, Edges(rim, color), pen.round_axis(rim, color, lw=0.95, z=z)]


@dataclass(frozen=True, eq=False)
class Edges(pen.Part):
    """The two lines from the origin to a rim that bound its cone; none for who looks into it."""

    rim: Floats
    color: str

    def on(self, axes: Axes, view: View) -> None:
        x, y, _ = view(self.rim)
        turn = np.unwrap(np.arctan2(x, y))
        if np.ptp(turn) < math.pi:
            ends = self.rim[[np.argmax(turn), np.argmin(turn)]]
            lines = [pen.Curve([pen.ORIGIN, end], self.color, 0.6, alpha=0.7) for end in ends]
            pen.draw(axes, lines, view)


def table(radius: float = 0.75) -> pen.Face:
    """The table on which the tip stands: a disc about the origin."""
    return pen.Face(circle(UPRIGHT, math.pi / 2, length=radius), look.GROUND, look.RULE, 0.6, z=0)


def faces(attitude: Floats, sizes: ArrayLike) -> list[tuple[Floats, Floats]]:
    """Corners (4, 3) and outward normal (3,) of each face of a box about the origin.

    Its half edges are `sizes` along the columns of `attitude`; first come the faces across the
    first edge, before and behind.
    """
    square = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])
    turned = np.asarray(sizes)[:, None] * attitude.T
    sides = [(k, sign) for k in range(3) for sign in (1.0, -1.0)]
    corners = [np.asarray(np.insert(square, k, sign, axis=1) @ turned) for k, sign in sides]
    return [(four, sign * attitude[:, k]) for four, (k, sign) in zip(corners, sides, strict=True)]
