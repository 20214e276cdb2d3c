"""A figure by its name: what may be changed in it, how it is drawn, what its caption says."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from io import BytesIO, StringIO
from typing import Any

import matplotlib
from matplotlib.axes import Axes
from matplotlib.backends.backend_svg import FigureCanvasSVG, RendererSVG
from matplotlib.figure import Figure as Canvas
from matplotlib.text import Text
from matplotlib.transforms import Bbox

from rigidtop.figures import style as look
from rigidtop.figures.style import STYLE
from rigidtop.motion.motion import Motion
from rigidtop.parameters import Parameter, settings

KINDS = ("svg", "pdf", "png")
"""Of a still figure, by the suffix of its file."""

RIM = 0.03
"""Above and below what is drawn (inches)."""

DOTS, POINTS = 300, 72
"""Of a png, and of what is drawn in lines, to the inch."""

MATHTEXT = (
    (r"(_\{?\w\}?)'", r"\1′"),  # its own prime stands high above an index,
    (r"_\{?([+-])\}?", r"_{{\1}}"),  # a sign apart from its letter,
    (r"\\dot\{\\mathbf\{(\w)\}\}", r"\\mathbf{\\dot{\1}}"),  # a dot is lost on a vector
)
"""What Matplotlib sets better in other words."""


@dataclass(frozen=True)
class Film:
    """A figure that moves: `show` draws what it is at a share of its time, from 0 to 1.

    It is played again and again: where the motion has a period, 1 is like 0.
    """

    canvas: Canvas
    show: Callable[[float], None]


Box = tuple[float, float, float, float]
"""Left, low, width and height, as shares of the paper."""
PAGE: Box = (0.0, 0.0, 1.0, 1.0)


def film(width: float, height: float, fill: Callable[..., None], *boxes: Box) -> Film:
    """A film (inches) that `fill` draws anew at each share: it takes that, and Axes in each box."""
    drawn = Canvas(figsize=(width, height))
    panels = [drawn.add_axes(box) for box in boxes or (PAGE,)]

    def show(share: float) -> None:
        for axes in panels:
            axes.clear()
        fill(share, *panels)

    show(0.0)
    return Film(drawn, show)


@dataclass(frozen=True)
class Drawing:
    """A figure.  `draw`, `facts`, `animate` and `motions` take its parameters by name.

    `section` is the section of the notes that it closes in the lecture; "" for none.  The caption
    and the `spoken` words, in ASCII, name in braces the parameters and the `facts`, which are
    computed from them: no number of a caption can disagree with the picture.

    All raise RigidtopError, in one line, for parameters that no such body or motion has.
    """

    name: str
    title: str
    section: str
    parameters: tuple[Parameter, ...]
    draw: Callable[..., Canvas]
    printed: str
    spoken: str
    facts: Callable[..., Mapping[str, Any]] = lambda **values: {}
    animate: Callable[..., Film] | None = None
    motions: Callable[..., Sequence[Motion]] | None = None
    """Those that it shows, to be played."""
    asked: Mapping[str, float] = field(default_factory=dict)
    """Other settings for who is to find out, in an exercise, what it shows at the usual ones."""
    turned: Callable[[str], Drawing] | None = None
    """The same for another sequence of Euler angles, "zyz" or "zxz", where that is its matter."""
    wording: Callable[[str], str] = str
    """What the caption is in another notation."""

    def caption(self, **values: float) -> str:
        """What stands below it, at these values of its parameters."""
        facts = {**self.facts(**values), **values}
        return self.wording(told(self.printed, facts))

    def alternative(self, **values: float) -> str:
        """What is to be seen, in ASCII."""
        return told(self.spoken, {**self.facts(**values), **values}, aloud=True)

    def values(self, given: Mapping[str, float] | None = None) -> dict[str, float]:
        """Every parameter's value, those `given` checked against their ranges."""
        return settings(self.parameters, given or {})


_HOLE = re.compile(r"(?<![\w^}])\{([A-Za-z]\w*)(?::([^{}]+))?\}")
"""What is filled in: braces in which a name stands, and which are none of a formula's."""


def told(words: str, facts: Mapping[str, Any], *, aloud: bool = False) -> str:
    """Words with their numbers, as captions print them or as a screen reader says them `aloud`.

    {x} is a number, {x:4} one of four digits, {x:°} an angle (rad) in degrees, {x:%} a share in per
    cent.  What is itself words may name others.

    >>> told("It is {where}.", {"angle": 0.5, "where": "at {angle:°}"})
    'It is at 28.6°.'
    """

    def number(hole: re.Match[str]) -> str:
        value, spec = facts[hole[1]], hole[2] or ""
        if isinstance(value, str):
            return told(value, facts, aloud=aloud)
        if spec == "°":
            return look.spoken(math.degrees(value)) if aloud else look.degrees(value)
        value = 100 * value if spec == "%" else value
        digits = int(spec) if spec.isdecimal() else 3
        return look.spoken(value) if aloud else look.said(value, digits)

    return _HOLE.sub(number, words)


def one(motion: Callable[..., Motion]) -> Callable[..., Sequence[Motion]]:
    """What a figure of a single motion shows."""
    return lambda **values: (motion(**values),)


def rendered(
    drawing: Drawing,
    kind: str,
    given: Mapping[str, float] | None = None,
    *,
    width: float | None = None,
    dots: int = DOTS,
) -> bytes:
    """The bytes of a figure as "svg", "pdf" or "png"; the same each time.

    It is `width` inches wide, or as wide as it was made, and no higher than what is drawn; letters
    keep their size.  `dots` are those of a png to the inch.
    """
    return _saved(drawing, given, kind, width=width, dots=dots)[0]


def resize(figure: Canvas, width: float | None) -> None:
    """Make a figure `width` inches wide, and as high in proportion; None leaves it."""
    if width is not None:
        own, high = figure.get_size_inches()
        figure.set_size_inches(width, high * width / own)


def both(drawing: Drawing, given: Mapping[str, float] | None = None) -> tuple[bytes, bytes]:
    """A figure of a document as PDF and as SVG, drawn and laid out once, as wide as is drawn."""
    paper, page = _saved(drawing, given, "pdf", "svg", wide=False)
    return paper, page


def _saved(
    drawing: Drawing,
    given: Mapping[str, float] | None,
    *kinds: str,
    wide: bool = True,
    width: float | None = None,
    dots: int = DOTS,
) -> list[bytes]:
    """A figure as each of the kinds, "svg" last, which has no white behind it."""
    with matplotlib.rc_context(STYLE):
        figure = drawing.draw(**drawing.values(given))
        resize(figure, width)
        for name in figure.findobj(Text):
            for ours, theirs in MATHTEXT:
                name.set_text(re.sub(ours, theirs, name.get_text()))
        figure.dpi = POINTS
        vector = _Vector(figure)
        if engine := figure.get_layout_engine():
            engine.execute(figure)
            figure.set_layout_engine(None)
        extents = [each for axes in figure.axes for each in _extents(axes, vector.get_renderer())]
        box = Bbox(Bbox.union(extents).get_points() / POINTS).padded(RIM)
        if wide:
            box = Bbox.from_extents(0, box.y0, figure.get_figwidth(), box.y1)
        return [
            vector.cropped(box) if kind == "svg" else _bytes(figure, box, kind, dots)
            for kind in kinds
        ]


class _Vector(FigureCanvasSVG):
    """Lays out and draws by one renderer: each new one reads every formula anew."""

    def __init__(self, figure: Canvas) -> None:
        super().__init__(figure)
        self._page = StringIO()
        width, height = POINTS * figure.get_size_inches()
        self._renderer = RendererSVG(width, height, self._page)  # type: ignore[no-untyped-call]

    def get_renderer(self) -> RendererSVG:
        """The one that is asked for the sizes of letters."""
        return self._renderer

    def cropped(self, box: Bbox) -> bytes:
        """The SVG of what is in the box (inches)."""
        for part in (self.figure.patch, *(axes.patch for axes in self.figure.axes)):
            part.set_visible(False)
        self.figure.draw(self._renderer)
        self._renderer.finalize()  # type: ignore[no-untyped-call]
        left, low, width, height = (POINTS * x for x in box.bounds)
        top = POINTS * self.figure.get_figheight() - low - height
        size = f'width="{width:.6g}pt" height="{height:.6g}pt"'
        place = f'viewBox="{left:.6g} {top:.6g} {width:.6g} {height:.6g}"'
        whole = r'width="\S*" height="\S*" viewBox="[^"]*"'
        page = re.sub(whole, f"{size} {place}", self._page.getvalue(), count=1)
        return re.sub(r"\s*<metadata>.*?</metadata>", "", page, flags=re.DOTALL).encode()


_ABOUT: Mapping[str, dict[str, Any]] = {
    "pdf": {"CreationDate": None, "Creator": None, "Producer": None},
    "png": {"Software": None},
}


def _bytes(figure: Canvas, box: Bbox, kind: str, dots: int) -> bytes:
    buffer = BytesIO()
    dots = dots if kind == "png" else POINTS
    figure.savefig(buffer, format=kind, metadata=_ABOUT[kind], dpi=dots, bbox_inches=box)
    return buffer.getvalue()


def _extents(axes: Axes, renderer: RendererSVG) -> Iterator[Bbox]:
    """Where something is drawn (dots): without a frame, that of each curve, face and name."""
    axes.apply_aspect()
    parts = [*axes.lines, *axes.patches, *axes.collections, *axes.texts, axes.title]
    for part in [axes] if axes.axison else parts:
        extent = part.get_tightbbox(renderer)
        if extent is not None and extent.height > 0:
            yield extent
