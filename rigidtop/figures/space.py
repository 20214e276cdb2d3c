"""Space on paper: seen from far away, with what is hidden dashed."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import ArrayLike, NDArray
from scipy.spatial import ConvexHull

from rigidtop.figures import style as look
from rigidtop.figures.style import Floats, head, name_at

SIZE = 10
"""Of the names of arrows (points)."""

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


def arc(first: ArrayLike, last: ArrayLike, count: int = 61, length: float = 1.0) -> Floats:
    """Points (count, 3) on the shorter great circle between two directions."""
    a, b = unit(first), unit(last)
    angle = math.atan2(float(np.linalg.norm(np.cross(a, b))), float(a @ b))
    across = unit(b - (a @ b) * a)
    turn = np.linspace(0.0, angle, count)[:, None]
    return length * (np.cos(turn) * a + np.sin(turn) * across)


@dataclass(frozen=True)
class Scene:
    """Axes on which space is seen from a view.  Points are those of space, (N, 3) or (3,)."""

    axes: Axes
    view: View = View()

    def line(self, points: ArrayLike, *marker: str, **style: Any) -> None:
        """What goes through these points, or marks at them."""
        self.axes.plot(*self.view(points)[:2], *marker, **style)

    def dot(self, point: ArrayLike, **style: Any) -> None:
        """A point, over most of the rest."""
        self.line(point, "o", **{"color": look.INK, "ms": 3.5, "zorder": 7, **style})

    def face(self, points: ArrayLike, **style: Any) -> None:
        """The area within these points."""
        self.axes.fill(*self.view(points)[:2], **style)

    def words(
        self, point: ArrayLike, words: str, shift: tuple[float, float] = (0, 0), **style: Any
    ) -> None:
        """Words `shift` points (of print) away from a point."""
        x, y, _ = self.view(point)
        name_at(self.axes, float(x), float(y), words, shift, **style)

    def head(self, piece: Floats, **style: Any) -> None:
        """The head of a curved arrow, at the end of a short piece of it (2, 3)."""
        (x0, x1), (y0, y1), _ = self.view(piece)
        head(self.axes, (x0, y0), (x1, y1), **style)

    def curve(self, points: Floats, hidden: NDArray[np.bool_], **style: Any) -> None:
        """A curve, dashed, thin and light where it is `hidden` (N,)."""
        across, up, _ = self.view(points)
        front, back = np.where(hidden, np.nan, 1.0), np.where(hidden, 1.0, np.nan)
        # A front part goes on to the first point that is hidden, so that no gap is left.
        front[1:][~hidden[:-1]] = 1.0
        width = style.get("lw", 1.2)
        style.setdefault("zorder", 3)
        if np.any(hidden):
            faint = {"lw": 0.65 * width, "alpha": 0.65, "ls": look.HIDDEN, "zorder": 1.5}
            self.axes.plot(across * back, up * back, **{**style, **faint})
        if not np.all(hidden):
            self.axes.plot(across * front, up * front, **style)

    def ring(self, points: Floats, **style: Any) -> None:
        """A curve round an axis, whose far half is hidden."""
        near = self.view(points)[2]
        self.curve(points, near < near.mean(), **style)

    def on_sphere(self, points: Floats, **style: Any) -> None:
        """A curve on the unit sphere, which hides its far half."""
        self.curve(points, self.view(points)[2] < -1e-9, **style)

    def sphere(self) -> None:
        """The outline of the unit sphere, and its equator."""
        around = np.linspace(0.0, 2 * math.pi, 241)
        self.axes.plot(np.cos(around), np.sin(around), color=look.RULE, lw=0.8, zorder=1)
        self.on_sphere(circle(UPRIGHT, math.pi / 2), color=look.RULE, lw=0.8)

    def arrow(
        self,
        tip: ArrayLike,
        words: str = "",
        *,
        start: ArrayLike = (0.0, 0.0, 0.0),
        shift: tuple[float, float] | None = None,
        color: str = look.INK,
        lw: float = 1.4,
        zorder: float = 5,
    ) -> None:
        """An arrow from `start` to `tip` (3,), with its name beyond the tip.

        One that points along the line of sight is drawn as the textbooks do: ⊙ towards the eye,
        ⊗ away from it.
        """
        ends = np.array([start, tip], dtype=float)
        (x0, x1), (y0, y1), (n0, n1) = self.view(ends)
        length = math.hypot(x1 - x0, y1 - y0)
        if length < 1e-3 * abs(n1 - n0):
            style: dict[str, Any] = {"mec": color, "color": color, "mew": lw}
            self.dot(start, ms=9, zorder=zorder, **style | {"mfc": "white"})
            self.line(start, "." if n1 > n0 else "x", ms=5, zorder=zorder + 0.1, **style)
        elif length:
            style = {"width": 0.18, "length": 0.42, "joinstyle": "miter"}
            head(self.axes, (x0, y0), (x1, y1), color=color, lw=lw, zorder=zorder, **style)
        if words:
            if shift is None:
                shift = 9 * (x1 - x0) / (length or 1.0), 9 * (y1 - y0) / (length or 1.0)
            style = {"ha": "center", "va": "center", "fontsize": SIZE}
            self.words(tip, words, shift, color=color, zorder=zorder + 0.2, **style)

    def couple(self, along: ArrayLike, shift: tuple[float, float], **style: Any) -> None:
        """N at the origin, or that there is none, `shift` points (of print) away from it."""
        if np.any(along):
            self.arrow(along, look.N_VEC, color=look.TORQUE, lw=1.9)
        else:
            self.words(np.zeros(3), r"$\mathbf{N} = 0$", shift, color=look.TORQUE, **style)


def total(vectors: Floats, sizes: float = 0.0) -> Floats:
    """The sum of vectors (N, 3); zero where it is no more than rounding.

    `sizes` are those of the factors, where the vectors themselves may be no more than that.
    """
    found: Floats = vectors.sum(axis=0)
    most = max(sizes, float(np.linalg.norm(vectors, axis=1).sum()))
    return np.zeros(3) if np.linalg.norm(found) <= ROUNDING * most else found


def paper(axes: Axes, x: tuple[float, float], y: tuple[float, float]) -> None:
    """Equal scales, no frame, these limits."""
    axes.set_aspect("equal")
    axes.set(xlim=x, ylim=y)
    axes.set_axis_off()


# --- Things --------------------------------------------------------------------------------------


def outline(view: View, points: Floats) -> Floats:
    """The outline (K, 2) on paper of a convex body that `points` (N, 3) span."""
    across, up, _ = view(points)
    flat = np.column_stack([across, up])
    return flat[ConvexHull(flat).vertices]


def top_body(
    scene: Scene,
    e3: ArrayLike,
    height: float = 0.9,
    radius: float = 0.36,
    *,
    psi_mark: ArrayLike | None = None,
    zorder: float = 2,
) -> None:
    """A top on its tip at the origin, its axis along `e3`: a cone with a lid.

    `psi_mark` is a vector fixed in the body and across the axis, towards which a line on the lid
    points, so that the turning can be seen.
    """
    axis = unit(e3)
    slant, angle = math.hypot(height, radius), math.atan2(radius, height)
    rim = circle(axis, angle, 121, slant)
    seen_from_above = float(scene.view(axis)[2]) > 0
    mantle = outline(scene.view, np.vstack([rim, np.zeros((1, 3))]))
    lid = np.column_stack(scene.view(rim)[:2])
    parts = [(mantle, look.MANTLE), (lid, look.FACE)]
    if not seen_from_above:
        parts.reverse()
    for step, (shape, color) in enumerate(parts):
        scene.axes.fill(*shape.T, fc="white", ec="none", zorder=zorder + 0.1 * step)
        scene.axes.fill(*shape.T, fc=color, ec=look.EDGE, lw=0.7, zorder=zorder + 0.1 * step + 0.05)
    if psi_mark is not None and seen_from_above:
        centre = height * axis
        line = np.array([centre, centre + radius * unit(psi_mark)])
        scene.line(line, color=look.EDGE, lw=1.2, zorder=zorder + 0.3)


def table(scene: Scene, radius: float = 0.75) -> None:
    """The table on which the tip stands: a disc about the origin."""
    rim = circle(UPRIGHT, math.pi / 2, length=radius)
    scene.face(rim, fc=look.GROUND, ec=look.RULE, lw=0.6, zorder=0)
