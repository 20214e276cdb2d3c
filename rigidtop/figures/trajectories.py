"""Trajectories drawn: beside measurements, and as parts that move."""

from __future__ import annotations

import math
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

import matplotlib
import numpy as np
from matplotlib.axes import Axes

from rigidtop.errors import RigidtopError
from rigidtop.figures import animation
from rigidtop.figures import picture as pen
from rigidtop.figures import style as look
from rigidtop.figures.curves import COLOURS, label
from rigidtop.figures.drawing import Film
from rigidtop.figures.space import View
from rigidtop.figures.style import STYLE, canvas
from rigidtop.parameters import in_one_line

if TYPE_CHECKING:
    from rigidtop.motion.attitude import Floats
    from rigidtop.motion.least_squares import Fit

RIGID = 1e-6
"""Two parts whose distance changes by less than this share of it are joined by a rod."""

ALONG = 0.35
"""The length of a body's axes, of the whole picture."""


HEIGHT = 3.6
"""Of the figure (inches)."""


def compared(fit: Fit[Any], kind: str) -> bytes:
    """The bytes of a figure as "svg", "pdf" or "png": dots on curves, and residuals below."""
    with matplotlib.rc_context(STYLE):
        figure = canvas(look.TEXT, HEIGHT)
        above, below = figure.subplots(2, sharex=True, height_ratios=(3, 1))
        for color, (header, measured) in zip(COLOURS, fit.measured.items(), strict=False):
            dots = {"color": color, "marker": ".", "markersize": 2.5, "linestyle": "none"}
            above.plot(fit.t, measured, **dots)
            above.plot(fit.t, fit.computed[header], color=color, lw=0.9, label=label(header))
            below.plot(fit.t, fit.residuals[header], **dots)
        below.axhline(0.0, color=look.GREY, lw=0.7)
        largest = max(float(np.abs(x).max()) for x in fit.residuals.values())
        below.set_ylim(-1.1 * (largest or 1.0), 1.1 * (largest or 1.0))
        below.set_xlabel(label("t/s"))
        below.set_ylabel("residual")
        figure.legend(loc="outside upper center", ncols=len(fit.measured))
        file = BytesIO()
        dated = {"Date": None} if kind == "svg" else {"CreationDate": None} if kind == "pdf" else {}
        figure.savefig(file, format=kind, dpi=200, metadata=dated)
    return file.getvalue()


def filmed(run: Any, path: str, duration: float | None) -> None:
    """See `rigidtop.system.motion.SystemTrajectory.animate`."""
    kind = Path(str(path)).suffix.removeprefix(".")
    if kind not in animation.KINDS:
        raise RigidtopError(f"a film is a .gif or an .mp4, not {in_one_line(path)}")
    places, attitudes = run.places(), run.attitudes()
    if len(run) < 2:
        raise RigidtopError("a film needs two times at least")
    seconds = float(np.ptp(run.t)) if duration is None else duration
    if not seconds > 0:
        raise RigidtopError("a film takes some time: duration must be positive")
    frames = max(2, round(seconds * animation.PER_SECOND))
    last = (len(run) - 1) * frames / (frames - 1)
    with matplotlib.rc_context(STYLE):
        figure = canvas(4.0, 4.0)
        axes = figure.add_subplot()

        def show(share: float) -> None:
            axes.clear()
            draw(axes, places, attitudes, round(share * last))

        animation.record(Path(path), Film(figure, show), frames)


def draw(axes: Axes, places: Floats, attitudes: Floats, row: int) -> None:
    """The parts at one row: points, their paths so far, rods, the axes of bodies."""
    turned = not np.allclose(attitudes, np.eye(3))
    flat = not turned and not np.any(places[..., 2])
    view = View(-math.pi / 2, math.pi / 2) if flat else View(0.7)  # flat: x̂ right and ŷ up
    sides = view(np.vstack([places.reshape(-1, 3), pen.ORIGIN]))[:2]
    half = 0.6 * max(float(np.ptp(side)) for side in sides)
    half = half if half > 1e-11 else 1.0
    length = ALONG * half
    room = half + length * turned
    middles = ((side.max() + side.min()) / 2 for side in sides)
    across, up = ((middle - room, middle + room) for middle in middles)
    parts: list[pen.Part] = [pen.Markers(pen.ORIGIN, look.GREY, 6, "+", 1)]
    parts += [pen.Curve([first[row], second[row]], lw=1.3) for first, second in _rods(places)]
    for k, (path, turning) in enumerate(zip(places, attitudes, strict=True)):
        color = COLOURS[k % len(COLOURS)]
        parts.append(pen.Curve(path[: row + 1], color, 0.6, z=1, alpha=0.6))
        parts.append(pen.Markers(path[row], color, 7, z=3))
        if not np.allclose(turning, np.eye(3)):
            ends = zip(turning[row].T, (look.SECOND, look.THIRD, look.FIRST), strict=True)
            parts += [pen.Curve([path[row], path[row] + length * e], c, 1.3) for e, c in ends]
    pen.picture(axes, parts, across, up, view)


def _rods(places: Floats) -> list[tuple[Floats, Floats]]:
    """Neighbours, the origin before the first, that keep their distance."""
    made = []
    before = np.zeros_like(places[0])
    for path in places:
        distance = np.linalg.norm(path - before, axis=1)
        if distance.max() > 0 and np.ptp(distance) < RIGID * distance.max():
            made.append((before, path))
        before = path
    return made
