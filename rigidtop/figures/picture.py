"""What a figure shows, as data, and the one place where it is put on Axes.

A place is a pair (x, y) or points (…, 2) on the paper, or points of space (…, 3), which are seen
from a view.

>>> from matplotlib.figure import Figure
>>> axes = Figure().subplots()
>>> draw(axes, [Sphere(), Arrow([0, 0, 1.4], r"$z$"), Rule(y=0.5)])
>>> len(axes.lines), [words.get_text() for words in axes.texts]
(4, ['', '$z$'])
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any, TypeAlias

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patheffects import withStroke
from matplotlib.text import Annotation
from numpy.typing import ArrayLike, NDArray
from scipy.spatial import ConvexHull

from rigidtop.figures import style as look
from rigidtop.figures.space import UPRIGHT, View, circle, nearest_side, ring, unit
from rigidtop.figures.style import Floats

Place: TypeAlias = Any
Shift: TypeAlias = tuple[float, float]
"""How far words are from what they name (points of print)."""

ORIGIN = np.zeros(3)


class Part:
    """Something to be drawn: `on` Axes, if it is seen from the view."""

    def on(self, axes: Axes, view: View) -> None:
        """Draws it."""
        raise NotImplementedError


FRONT = View()


def draw(axes: Axes, parts: Iterable[Part], view: View = FRONT) -> None:
    """Puts the parts on Axes, the last over the first where their `z` is the same."""
    for part in parts:
        part.on(axes, view)


def seen(place: Place, view: View) -> tuple[Floats, Floats, Floats]:
    """To the right, up and towards the eye; what lies on the paper is neither near nor far."""
    if isinstance(place, tuple) and len(place) == 2:
        x, y = np.broadcast_arrays(*(np.asarray(each, dtype=float) for each in place))
        return x, y, 0.0 * x
    points = np.asarray(place, dtype=float)
    if points.shape[-1] == 2:
        return points[..., 0], points[..., 1], 0.0 * points[..., 0]
    return view(points)


def turned_away(normal: ArrayLike | None, view: View) -> bool:
    """Whether the face with this normal is seen from behind, or along it."""
    return normal is not None and float(view(normal)[2]) <= 1e-9


# --- Lines, points, words ------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class Curve(Part):
    """A line through points; dashed, thin and light where it is `hidden`.

    Hidden is a mask (N,), or what hides it: the unit "sphere", or of a ring its "near" half.
    """

    points: Place
    color: str = look.INK
    lw: float = 1.2
    ls: Any = "-"
    z: float = 2
    hidden: str | NDArray[np.bool_] = ""
    head: bool = False
    """Whether it ends as an arrow does."""
    label: str = "_"
    alpha: float = 1.0
    cap: str = "projecting"
    normal: ArrayLike | None = None
    """Of the face that it is on, which is seen from the side to which this points."""

    def on(self, axes: Axes, view: View) -> None:
        if turned_away(self.normal, view):
            return
        x, y, near = seen(self.points, view)
        style: dict[str, Any] = {"color": self.color, "lw": self.lw, "label": self.label}
        style |= {"zorder": self.z, "ls": self.ls, "alpha": self.alpha, "solid_capstyle": self.cap}
        hidden = self.hidden
        if isinstance(hidden, str):
            edge = {"": -math.inf, "sphere": -1e-9}.get(hidden)
            hidden = near < (np.mean(near) if edge is None else edge)
        if not np.any(hidden):
            axes.plot(x, y, **style)
        else:
            front, back = np.where(hidden, np.nan, 1.0), np.where(hidden, 1.0, np.nan)
            # A front part goes on to the first point that is hidden, so that no gap is left.
            front[1:][~hidden[:-1]] = 1.0
            faint = {"lw": 0.65 * self.lw, "alpha": 0.65, "ls": look.HIDDEN, "zorder": 1.5}
            axes.plot(x * back, y * back, **{**style, **faint})
            if not np.all(hidden):
                axes.plot(x * front, y * front, **style)
        if self.head:
            start, tip = ((x[k], y[k]) for k in (-8, -1))
            head = Arrow(tip, "", self.color, 0.8, start, z=self.z + 0.1, size=(0.16, 0.32))
            head.on(axes, view)


def on_sphere(points: Place, color: str, **style: Any) -> Curve:
    """A path on the unit sphere, which hides its far half."""
    return Curve(points, color, **{"z": 3, "hidden": "sphere", **style})


def round_axis(points: Place, color: str, **style: Any) -> Curve:
    """A ring about an axis, whose far half is hidden."""
    return Curve(points, color, **{"z": 3, "hidden": "near", **style})


def guide(points: Place, **style: Any) -> Curve:
    """A line beside the matter: thin, grey and solid."""
    return Curve(points, **{"color": look.GREY, "lw": 0.8, "z": 1, **style})


def angle(
    way: Floats,
    words: str,
    shift: Shift = (0, 0),
    ink: str = look.INK,
    out: float = 1.0,
    **style: Any,
) -> list[Part]:
    """An arc about the origin (N, 2 or 3), and its name at its middle, or `out` times as far."""
    name = Words(out * way[len(way) // 2], words, shift, ink, ha="center")
    return [Curve(way, **{"color": ink, "lw": 0.9, **style}), name]


def three(t: Floats, rates: Floats, per: str = "") -> list[Part]:
    """ω₁, ω₂ and ω₃ (N, 3) against the time, by `per`, if it is given; and zero."""
    styles = (look.SECOND, look.DASH_DOT), (look.FIRST, "-"), (look.INK, look.DASHED)
    curves = [
        Curve((t, rate), color, ls=ls, label=rf"$\omega_{k}{per}$")
        for k, (rate, (color, ls)) in enumerate(zip(rates.T, styles, strict=True), 1)
    ]
    return [*curves, Rule(y=0.0, color=look.RULE, lw=0.6, ls="-")]


@dataclass(frozen=True)
class Rule(Part):
    """A straight line over all of a chart, at an x or at a y; dotted if nothing else is said."""

    x: float | None = None
    y: float | None = None
    color: str = look.GREY
    lw: float = 0.9
    ls: Any = look.DOTTED
    label: str = "_"

    def on(self, axes: Axes, view: View) -> None:
        style: dict[str, Any] = {"color": self.color, "lw": self.lw, "ls": self.ls, "zorder": 1.9}
        if self.x is not None:
            axes.axvline(self.x, label=self.label, **style)
        if self.y is not None:
            axes.axhline(self.y, label=self.label, **style)


@dataclass(frozen=True, eq=False)
class Markers(Part):
    """Points, never cut off; `fill` and `edge` are colours other than that of all.

    One may have a name beside it, in `ink` if not in its own colour.
    """

    points: Place
    color: str = look.INK
    size: float = 3.5
    shape: Any = "o"
    z: float = 7
    fill: str | None = None
    edge: str | None = None
    width: float = 1.0
    label: str = "_"
    words: str = ""
    shift: Shift = (0, 0)
    ha: str = "left"
    va: str = "baseline"
    ink: str | None = None

    def on(self, axes: Axes, view: View) -> None:
        x, y, _ = seen(self.points, view)
        style: dict[str, Any] = {"ms": self.size, "zorder": self.z, "mew": self.width}
        style |= {"mfc": self.fill or self.color, "mec": self.edge or self.color}
        axes.plot(x, y, ls="", marker=self.shape, clip_on=False, label=self.label, **style)
        if self.words:
            ink = self.ink or self.color
            name = Words(self.points, self.words, self.shift, ink, self.ha, self.va)
            name.on(axes, view)


@dataclass(frozen=True, eq=False)
class Words(Part):
    """Words beside a point, over what lies below; never cut off."""

    at: Place
    words: str
    shift: Shift = (0, 0)
    color: str = look.INK
    ha: str = "left"
    va: str = "baseline"
    size: float | None = None
    z: float = 8

    def on(self, axes: Axes, view: View) -> None:
        x, y, _ = seen(self.at, view)
        style: dict[str, Any] = {"color": self.color, "ha": self.ha, "va": self.va}
        style |= {"path_effects": [withStroke(linewidth=2.0, foreground="white")]}
        style |= {"textcoords": "offset points", "fontsize": self.size, "zorder": self.z}
        place = float(x), float(y)
        axes.annotate(self.words, place, self.shift, annotation_clip=False, **style)


@dataclass(frozen=True, eq=False)
class Arrow(Part):
    """An arrow from `start` to `tip` (3,), with its name beyond the tip.

    One that points along the line of sight is drawn as the textbooks do: ⊙ towards the eye, ⊗ away
    from it.  `ends` are heads as Matplotlib writes them.
    """

    tip: Place
    words: str = ""
    color: str = look.INK
    lw: float = 1.4
    start: Place = (0.0, 0.0, 0.0)
    shift: Shift | None = None
    z: float = 5
    size: tuple[float, float] = (0.18, 0.42)
    ends: str = "-|>"

    def on(self, axes: Axes, view: View) -> None:
        (x0, y0, n0), (x1, y1, n1) = seen(self.start, view), seen(self.tip, view)
        across, up = float(x1 - x0), float(y1 - y0)
        length = math.hypot(across, up)
        if length < 1e-3 * abs(float(n1 - n0)):
            sight = Markers(self.start, self.color, 9, z=self.z, fill="white", width=self.lw)
            inner = "." if n1 > n0 else "x"
            sign = Markers(self.start, self.color, 5, inner, z=self.z + 0.1, width=self.lw)
            draw(axes, (sight, sign), view)
        elif length:
            head = f"{self.ends},head_width={self.size[0]},head_length={self.size[1]}"
            style = {"arrowstyle": head, "shrinkA": 0, "shrinkB": 0, "joinstyle": "miter"}
            style |= {"color": self.color, "lw": self.lw}
            axes.annotate("", (x1, y1), (x0, y0), arrowprops=style, zorder=self.z)
        if self.words:
            away = 9 / (length or 1.0)
            shift = (away * across, away * up) if self.shift is None else self.shift
            name = Words(self.tip, self.words, shift, self.color, "center", "center", 10)
            draw(axes, [replace(name, z=self.z + 0.2)], view)


# --- Areas and turns -----------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class Face(Part):
    """The area within points, or of all that is convex about them, a `hull`.

    One that has a `normal` is seen only from the side to which this points.
    """

    points: Place
    color: str
    edge: str = "none"
    lw: float = 0.7
    z: float = 1
    alpha: float = 1.0
    hull: bool = False
    normal: ArrayLike | None = None

    def on(self, axes: Axes, view: View) -> None:
        if turned_away(self.normal, view):
            return
        flat = np.column_stack(seen(self.points, view)[:2])
        shape = flat[ConvexHull(flat).vertices] if self.hull else flat
        style: dict[str, Any] = {"fc": self.color, "ec": self.edge, "alpha": self.alpha}
        axes.fill(*shape.T, lw=self.lw, zorder=self.z, joinstyle="round", **style)


@dataclass(frozen=True, eq=False)
class Band(Part):
    """What lies between two curves over x."""

    x: ArrayLike
    low: ArrayLike
    high: ArrayLike
    color: str = look.FIRST
    alpha: float = 0.12
    label: str = "_"

    def on(self, axes: Axes, view: View) -> None:
        style: dict[str, Any] = {"fc": self.color, "alpha": self.alpha, "label": self.label}
        axes.fill_between(self.x, self.low, self.high, lw=0.0, **style)


@dataclass(frozen=True)
class Sphere(Part):
    """The outline of the unit sphere, and its equator."""

    def on(self, axes: Axes, view: View) -> None:
        outline = Curve(circle(view.axes[2], math.pi / 2), look.RULE, 0.8, z=1)
        draw(axes, [outline, on_sphere(circle(UPRIGHT, math.pi / 2), look.RULE, lw=0.8)], view)


TAIL, HEAD = 3.6, 1.0
"""Where a curved arrow begins and ends, in angles from the side of the eye (rad)."""


@dataclass(frozen=True, eq=False)
class Turning(Part):
    """A curved arrow about `axis` in the sense of a `rate`, with its name beside it.

    The head is on the side of the eye, what lies behind the axis is dashed.
    """

    centre: Floats
    axis: ArrayLike
    radius: float
    rate: float
    words: str
    left: bool = False
    z: float = 4

    def points(self, view: View) -> Floats:
        """On the arrow, from its tail to its head."""
        along = math.copysign(1.0, self.rate) * unit(self.axis)
        first = ring(ORIGIN, along, 1.0, nearest_side(view, along), -TAIL, 2)[1]
        return ring(self.centre, along, self.radius, first, TAIL + HEAD)

    def on(self, axes: Axes, view: View) -> None:
        points = self.points(view)
        x, _, near = view(points)
        behind = near < float(view(self.centre)[2]) - 1e-9
        k, shift, side = (np.argmin(x), -4, "right") if self.left else (np.argmax(x), 4, "left")
        arrow = Curve(points, look.OMEGA, z=self.z, hidden=behind, head=True)
        draw(axes, [arrow, Words(points[k], self.words, (shift, -3), look.OMEGA, side)], view)


def couple(along: ArrayLike, shift: Shift, ha: str = "left") -> Part:
    """N at the origin, or that there is none, `shift` points (of print) away from it."""
    if np.any(along):
        return Arrow(along, look.N_VEC, look.TORQUE, 1.9)
    return Words(ORIGIN, r"$\mathbf{N} = 0$", shift, look.TORQUE, ha)


def frame(
    axes: Floats,
    length: float,
    names: Iterable[str] = look.BODY,
    start: float = 0.0,
    centre: Floats = ORIGIN,
    **style: Any,
) -> list[Arrow]:
    """The three directions in the rows of `axes`, with their names, from a start to a length."""
    style = {"color": look.AXIS, "lw": 1.0, **style}
    return [
        Arrow(centre + length * axis, name, start=centre + start * axis, **style)
        for axis, name in zip(axes, names, strict=True)
    ]


# --- The paper -----------------------------------------------------------------------------------


def paper(axes: Axes, x: tuple[float, float], y: tuple[float, float]) -> None:
    """Equal scales, no frame, these limits."""
    axes.set_aspect("equal")
    axes.set(xlim=x, ylim=y)
    axes.set_axis_off()


def picture(
    axes: Axes,
    parts: Iterable[Part],
    x: tuple[float, float],
    y: tuple[float, float],
    view: View = FRONT,
) -> None:
    """Puts the parts on paper with these limits."""
    draw(axes, parts, view)
    paper(axes, x, y)


def chart(axes: Axes, parts: Iterable[Part], x: str, y: str, **limits: Any) -> None:
    """Puts the parts on a chart with these names of its axes, and limits as Matplotlib has them."""
    draw(axes, parts)
    axes.set(xlabel=x, ylabel=y, **limits)


def fit(
    axes: Axes, parts: Iterable[Part], view: View, margins: tuple[float, float, float, float]
) -> None:
    """Puts the parts on paper just large enough, with margins (left, right, below, above).

    The margins are shares of the larger side: they are for words, whose size is that of letters.
    """
    draw(axes, parts, view)
    shapes = [line.get_xydata() for line in axes.lines]
    shapes += [patch.get_path().vertices for patch in axes.patches]
    drawn = np.vstack([*shapes, *(name.xy for name in axes.texts if isinstance(name, Annotation))])
    low, high = np.nanmin(drawn, axis=0), np.nanmax(drawn, axis=0)
    left, right, below, above = (float(max(high - low)) * margin for margin in margins)
    paper(axes, (low[0] - left, high[0] + right), (low[1] - below, high[1] + above))


def legend_above(axes: Axes, **style: Any) -> None:
    """A legend over the frame."""
    place = {"loc": "lower center", "bbox_to_anchor": (0.5, 1.0), "borderpad": 0}
    axes.legend(**place, **{"handlelength": 2.4, **style})


def panels(
    width: float, height: float, fill: Callable[..., None], *shape: int, **grid: Any
) -> Callable[..., look.Canvas]:
    """What draws a figure (inches) of so many rows and columns of panels, as `subplots` has them.

    `fill` fills them all: it takes their Axes, row by row, and the parameters.  Where they share
    what goes across, the names of what goes up stand below each other.
    """

    def drawn(**values: float) -> look.Canvas:
        figure = look.canvas(width, height)
        fill(*np.ravel(figure.subplots(*shape, **grid)), **values)
        if grid.get("sharex"):
            figure.align_ylabels()
        return figure

    return drawn


def alone(height: float, fill: Callable[..., None]) -> Callable[..., look.Canvas]:
    """What draws a figure of one panel in a column, which `fill` fills: its Axes, parameters."""
    return panels(look.COLUMN, height, fill)


def abreast(
    height: float, *fills: Callable[..., None], width: float = look.TEXT
) -> Callable[..., look.Canvas]:
    """What draws pictures side by side without room between, each by what fills it."""

    def drawn(**values: float) -> look.Canvas:
        figure = look.Canvas(figsize=(width, height))
        for k, fill in enumerate(fills):
            fill(figure.add_axes((k / len(fills), 0.0, 1 / len(fills), 1.0)), **values)
        return figure

    return drawn
