"""Columns of a trajectory as curves: over the time, or one over another."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import matplotlib
import numpy as np
from matplotlib.axes import Axes

from rigidtop.figures import style as look
from rigidtop.figures.style import STYLE, canvas
from rigidtop.typeset.latex import letter
from rigidtop.typeset.nodes import glyph

if TYPE_CHECKING:
    from rigidtop.motion.attitude import Floats

COLOURS = (look.FIRST, look.SECOND, look.INK, look.THIRD, look.GREY)
SIZE = (4.8, 3.0)
"""Of a figure (inches)."""


def drawn(
    curves: Sequence[tuple[tuple[str, Floats], tuple[str, Floats]]],
    axes: Axes | None = None,
    *,
    dots: bool = False,
) -> Axes:
    """The axes with a curve for each pair of columns, the first across and the second up.

    A column is its header, such as "theta/rad", and its numbers, shape (N,).  What is drawn over
    the time is sorted by it.  Without `axes` there are new ones, in a figure of their own.
    """
    with matplotlib.rc_context(STYLE):
        if axes is None:
            axes = canvas(*SIZE).add_subplot()
        marks = {"linestyle": "none", "marker": ".", "markersize": 2} if dots else {}
        for k, ((across, x), (up, y)) in enumerate(curves):
            order = np.argsort(x, kind="stable") if across == "t/s" else slice(None)
            line: dict[str, Any] = {"color": COLOURS[k % len(COLOURS)], "label": label(up), **marks}
            axes.plot(x[order], y[order], **line)
        headers = {across for (across, _), _ in curves}
        axes.set_xlabel(label(headers.pop()) if len(headers) == 1 else "")
        if len(curves) == 1:
            axes.set_ylabel(label(curves[0][1][0]))
        else:
            axes.legend()
    return axes


def label(header: str) -> str:
    """A column's letter and unit: $\\dot{\\theta}$ (rad/s)."""
    name, _, unit = header.partition("/")
    spelled = name.replace("_dot", "dot").replace("e3_", "e3")
    made = name if name in ("energy", "rolling", "dissipated") else f"${letter(glyph(spelled))}$"
    made = made.replace("_", " ") if made == name else made
    return f"{made} ({unit.strip('()')})" if unit else made
