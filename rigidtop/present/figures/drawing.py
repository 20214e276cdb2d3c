"""A figure by its name: what may be changed in it, how it is drawn, what its caption says."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from io import BytesIO
from typing import Any

import matplotlib
from matplotlib.figure import Figure as Canvas

from rigidtop.parameters import Parameter, settings
from rigidtop.present.figures.style import STYLE

KINDS = ("svg", "pdf", "png")
"""Of a still figure, by the suffix of its file."""

DOTS = 300
"""Of a png, to the inch."""


@dataclass(frozen=True)
class Film:
    """A figure that moves: `show` draws what it is at a share of its time, from 0 to 1.

    It is played again and again: where the motion has a period, 1 is like 0.
    """

    canvas: Canvas
    show: Callable[[float], None]


@dataclass(frozen=True)
class Drawing:
    """A figure.  `draw`, `caption`, `alternative` and `animate` take its parameters by name.

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

    def values(self, given: Mapping[str, float] | None = None) -> dict[str, float]:
        """Every parameter's value, those `given` checked against their ranges."""
        return settings(self.parameters, given or {})


def rendered(drawing: Drawing, kind: str, given: Mapping[str, float] | None = None) -> bytes:
    """The bytes of a figure as "svg", "pdf" or "png"; the same each time."""
    return both(drawing, (kind,), given)[kind]


_ABOUT: Mapping[str, dict[str, Any]] = {
    "svg": {},  # goes below
    "pdf": {"CreationDate": None, "Creator": None, "Producer": None},
    "png": {"Software": None},
}


def both(
    drawing: Drawing, kinds: Sequence[str], given: Mapping[str, float] | None = None
) -> dict[str, bytes]:
    """A figure in several kinds, drawn once."""
    values = drawing.values(given)
    made: dict[str, bytes] = {}
    with matplotlib.rc_context(STYLE):
        canvas = drawing.draw(**values)
        for kind in kinds:
            buffer = BytesIO()
            about = _ABOUT[kind]
            transparent = kind == "svg"
            canvas.savefig(buffer, format=kind, metadata=about, dpi=DOTS, transparent=transparent)
            made[kind] = buffer.getvalue()
    if "svg" in made:
        made["svg"] = re.sub(rb"\s*<metadata>.*?</metadata>", b"", made["svg"], flags=re.DOTALL)
    return made
