"""The map of a lecture: which equation rests on which, as text and as a picture."""

from __future__ import annotations

import textwrap
from collections.abc import Collection, Mapping, Sequence
from io import BytesIO
from typing import TYPE_CHECKING

from rigidtop.notation import NOTES, Notation
from rigidtop.proof.lecture import Lecture
from rigidtop.report import plain
from rigidtop.report.ways import called

if TYPE_CHECKING:
    from matplotlib.figure import Figure

KINDS = ("svg", "pdf", "png")
Map = Mapping[str, tuple[str, ...]]


def label(lecture: Lecture, name: str, notation: Notation = NOTES) -> str:
    """What a name of the map is called: (3.57), constant-rate, Lagrange's equation for θ."""
    if name in lecture.laws:
        return plain.rich(called(lecture.lines[name], notation))
    return f"({name})" if name[:1].isdigit() else name


def part(whole: Map, names: Sequence[str]) -> dict[str, tuple[str, ...]]:
    """The part of a map that some names rest on, themselves included."""
    wanted, waiting = set(names), list(names)
    while waiting:
        new = set(whole[waiting.pop()]) - wanted
        wanted |= new
        waiting += new
    return {name: on for name, on in whole.items() if name in wanted}


def reduced(whole: Map) -> dict[str, tuple[str, ...]]:
    """The map without the arrows that a chain of others says too."""
    above: dict[str, set[str]] = {}
    for name, on in whole.items():  # in reading order: what a name rests on comes first
        above[name] = set(on).union(*(above[each] for each in on))
    return {
        name: tuple(e for e in on if not any(e in above[other] for other in on if other != e))
        for name, on in whole.items()
    }


def layers(whole: Map) -> list[list[str]]:
    """Names by the length of the longest chain to them, neighbours near what they rest on."""
    depth: dict[str, int] = {}
    for name, on in whole.items():
        depth[name] = 1 + max((depth[each] for each in on), default=-1)
    made: list[list[str]] = [[] for _ in range(max(depth.values(), default=-1) + 1)]
    for name, k in depth.items():
        made[k].append(name)
    uses: dict[str, list[str]] = {name: [] for name in whole}
    for name, on in whole.items():
        for each in on:
            uses[each].append(name)
    for sweep in range(8):
        forth = sweep % 2 == 0
        rows = made[1:] if forth else made[-2::-1]
        place = {x: i / max(1, len(row) - 1) for row in made for i, x in enumerate(row)}
        for row in rows:
            near = {x: [place[e] for e in (whole[x] if forth else uses[x])] for x in row}
            row.sort(key=lambda x: sum(near[x]) / len(near[x]) if near[x] else place[x])
            place |= {x: i / max(1, len(row) - 1) for i, x in enumerate(row)}
    return made


def contracted(whole: Map, kept: Collection[str]) -> dict[str, tuple[str, ...]]:
    """The map of a part of its names, with arrows for chains through those that are left out."""
    near: dict[str, set[str]] = {}
    for name, on in whole.items():  # in reading order: what a name rests on comes first
        near[name] = set().union(*({each} if each in kept else near[each] for each in on))
    return {
        name: tuple(each for each in whole if each in near[name]) for name in whole if name in kept
    }


def drawn(lecture: Lecture, whole: Map, kind: str, notation: Notation = NOTES) -> bytes:
    """The map as a file: laws at the left, what rests on them to the right."""
    import matplotlib as mpl

    from rigidtop.figures import style

    with mpl.rc_context(style.STYLE):
        file = BytesIO()
        metadata = {"svg": {"Date": None}, "pdf": {"CreationDate": None}}.get(kind)
        picture(lecture, whole, notation).savefig(file, format=kind, dpi=160, metadata=metadata)
    return file.getvalue()


def picture(lecture: Lecture, whole: Map, notation: Notation = NOTES, wide: float = 1.9) -> Figure:
    """The map as a figure whose columns are so `wide` (inches)."""
    from matplotlib.figure import Figure

    from rigidtop.figures import style

    arrows = reduced(whole)
    columns = layers(arrows)
    labels = {name: _broken(label(lecture, name, notation)) for name in whole}
    rows = {name: 0.6 + words.count("\n") + 1 for name, words in labels.items()}
    tallest = max((sum(rows[name] for name in column) for column in columns), default=1)
    width, height = wide * len(columns), max(2.0, 0.17 * tallest + 0.3)
    canvas = Figure(figsize=(width, height))
    axes = canvas.add_axes((0, 0, 1, 1))
    axes.set_axis_off()
    axes.set_xlim(-0.5, len(columns) - 0.5)
    axes.set_ylim(-0.02, 1.02)
    place: dict[str, tuple[float, float]] = {}
    for x, column in enumerate(columns):
        total, above = sum(rows[name] for name in column), 0.0
        for name in column:
            place[name] = (float(x), 1 - (above + rows[name] / 2) / total)
            above += rows[name]
    for name, on in arrows.items():
        for each in on:
            start, end = place[each], place[name]
            axes.annotate(
                "",
                (end[0] - _half(labels[name], wide), end[1]),
                (start[0] + _half(labels[each], wide), start[1]),
                arrowprops={
                    "arrowstyle": "-|>,head_length=0.25,head_width=0.12",
                    "connectionstyle": "arc3,rad=0.06",
                    "color": style.GREY if each in lecture.laws else style.FIRST,
                    "linewidth": 0.5,
                    "alpha": 0.7,
                    "shrinkA": 0,
                    "shrinkB": 0,
                },
            )
    for name, at in place.items():
        law = name in lecture.laws
        axes.text(
            *at,
            labels[name],
            ha="center",
            va="center",
            fontsize=style.SMALL,
            linespacing=0.95,
            color=style.INK,
            bbox={
                "boxstyle": "round,pad=0.25",
                "facecolor": "#f3f0e8" if law else "#e3edf6",
                "edgecolor": style.RULE if law else style.FIRST,
                "linewidth": 0.6,
            },
        )
    return canvas


def _half(words: str, wide: float) -> float:
    """Half the width of a label with its frame, in columns of this width."""
    return (0.021 * max(map(len, words.split("\n"))) + 0.05) / wide


def _broken(words: str, most: int = 20) -> str:
    """A label in lines of at most so many letters."""
    return "\n".join(textwrap.wrap(words, most)) or words
