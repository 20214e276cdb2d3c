"""Measurements beside the motion that fits them, and what is left."""

from __future__ import annotations

from io import BytesIO

import matplotlib
import numpy as np

from rigidtop.figures import style as look
from rigidtop.figures.style import STYLE, TEXT, canvas
from rigidtop.figures.trajectories import COLOURS, label
from rigidtop.motion.least_squares import Fit

HEIGHT = 3.6
"""Of the figure (inches)."""


def compared(fit: Fit, kind: str) -> bytes:
    """The bytes of a figure as "svg", "pdf" or "png": dots on curves, and residuals below."""
    with matplotlib.rc_context(STYLE):
        figure = canvas(TEXT, HEIGHT)
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
