"""A figure by its name: what may be changed in it, how it is drawn, what its caption says."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from io import BytesIO
from typing import Any

import matplotlib
from matplotlib.axes import Axes
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure as Canvas
from matplotlib.transforms import Bbox

from rigidtop.figures.style import STYLE
from rigidtop.motion.motion import Motion
from rigidtop.parameters import Parameter, settings

KINDS = ("svg", "pdf", "png")
"""Of a still figure, by the suffix of its file."""

RIM = 0.03
"""Above and below what is drawn (inches)."""

DOTS, POINTS = 300, 72
"""Of a png, and of what is drawn in lines, to the inch."""


@dataclass(frozen=True)
class Film:
    """A figure that moves: `show` draws what it is at a share of its time, from 0 to 1.

    It is played again and again: where the motion has a period, 1 is like 0.
    """

    canvas: Canvas
    show: Callable[[float], None]


@dataclass(frozen=True)
class Drawing:
    """A figure.  `draw`, `caption`, `alternative`, `animate` and `motions` take its parameters by
    name.

    `section` is the section of the notes that it closes in the lecture; "" for none.  `alternative`
    says in ASCII what is to be seen.  No number of a caption can disagree with the picture: both
    are computed from the same parameters.

    All raise RigidtopError, in one line, for parameters that no such body or motion has.
    """

    name: str
    title: str
    section: str
    parameters: tuple[Parameter, ...]
    draw: Callable[..., Canvas]
    caption: Callable[..., str]
    alternative: Callable[..., str]
    animate: Callable[..., Film] | None = None
    motions: Callable[..., Sequence[Motion]] | None = None
    """Those that it shows, to be played."""

    def values(self, given: Mapping[str, float] | None = None) -> dict[str, float]:
        """Every parameter's value, those `given` checked against their ranges."""
        return settings(self.parameters, given or {})


def one(motion: Callable[..., Motion]) -> Callable[..., Sequence[Motion]]:
    """What a figure of a single motion shows."""
    return lambda **values: (motion(**values),)


def rendered(drawing: Drawing, kind: str, given: Mapping[str, float] | None = None) -> bytes:
    """The bytes of a figure as "svg", "pdf" or "png"; the same each time."""
    values = drawing.values(given)
    with matplotlib.rc_context(STYLE):
        canvas = drawing.draw(**values)
        buffer = BytesIO()
        about, clear = _ABOUT[kind], kind == "svg"
        canvas.savefig(buffer, format=kind, metadata=about, dpi=DOTS, transparent=clear)
    made = buffer.getvalue()
    return _without_metadata(made) if kind == "svg" else made


_ABOUT: Mapping[str, dict[str, Any]] = {
    "svg": {},  # goes below
    "pdf": {"CreationDate": None, "Creator": None, "Producer": None},
    "png": {"Software": None},
}


def both(drawing: Drawing, given: Mapping[str, float] | None = None) -> tuple[bytes, bytes]:
    """A figure as PDF and as SVG, drawn and laid out once.

    The letters of the PDF are outlines (Type 3): to cut a font for each figure takes longer than
    all the rest of it.
    """
    values = drawing.values(given)
    paper, page = BytesIO(), BytesIO()
    with matplotlib.rc_context({**STYLE, "pdf.fonttype": 3}):
        canvas = drawing.draw(**values)
        FigureCanvasSVG(canvas)
        canvas.dpi = POINTS
        if engine := canvas.get_layout_engine():
            engine.execute(canvas)
            canvas.set_layout_engine("none")
        # As wide as it was made, and no higher than what is drawn.
        extents = [extent for axes in canvas.axes for extent in _extents(axes)]
        low, high = (y / POINTS for y in Bbox.union(extents).intervaly)
        box = Bbox.from_extents(0, low - RIM, canvas.get_figwidth(), high + RIM)
        about: dict[str, Any] = {"dpi": POINTS, "bbox_inches": box}
        canvas.savefig(paper, format="pdf", metadata=_ABOUT["pdf"], **about)
        canvas.savefig(page, format="svg", transparent=True, **about)
    return paper.getvalue(), _without_metadata(page.getvalue())


def _extents(axes: Axes) -> Iterator[Bbox]:
    """Where something is drawn (dots): without a frame, that of each curve, face and name."""
    parts = [*axes.lines, *axes.patches, *axes.collections, *axes.texts, axes.title]
    for part in [axes] if axes.axison else parts:
        extent = part.get_tightbbox()
        if extent is not None and extent.height > 0:
            yield extent


def _without_metadata(svg: bytes) -> bytes:
    return re.sub(rb"\s*<metadata>.*?</metadata>", b"", svg, flags=re.DOTALL)
