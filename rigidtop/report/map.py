"""The map of a lecture: which equation rests on which, as text and as a picture."""

from __future__ import annotations

import textwrap
from collections.abc import Collection, Mapping, Sequence
from io import BytesIO
from typing import TYPE_CHECKING

import numpy as np
from scipy.optimize import isotonic_regression

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


Cell = tuple[str, int]
"""A name and 0, or a lane for its arrows, so many columns behind it."""


def columns(whole: Map) -> tuple[list[list[Cell]], list[tuple[Cell, Cell]]]:
    """Names by the length of the longest chain to them, and the arrows from column to column.

    What rests on nothing stands just before what rests on it.
    """
    depth: dict[str, int] = {}
    for name, on in whole.items():  # in reading order: what a name rests on comes first
        depth[name] = 1 + max((depth[each] for each in on), default=-1)
    uses = {name: [other for other, on in whole.items() if name in on] for name in whole}
    for name, on in whole.items():
        if not on:
            depth[name] = min((depth[other] for other in uses[name]), default=1) - 1
    lanes: list[list[Cell]] = [[] for _ in range(max(depth.values(), default=-1) + 1)]
    arrows: list[tuple[Cell, Cell]] = []
    for name, at in depth.items():
        for k in range(max((depth[other] for other in uses[name]), default=at + 1) - at):
            lanes[at + k].append((name, k))
            arrows += [((name, k - 1), (name, k))] * (k > 0)
        arrows += [((name, depth[other] - at - 1), (other, 0)) for other in uses[name]]
    return lanes, arrows


def heights(
    lanes: Sequence[Sequence[Cell]], arrows: Sequence[tuple[Cell, Cell]], room: Mapping[Cell, float]
) -> dict[Cell, float]:
    """How far down each cell stands: near what it is joined to, `room` around it."""
    near: tuple[dict[Cell, list[Cell]], ...] = ({}, {})
    for start, end in arrows:
        near[0].setdefault(end, []).append(start)
        near[1].setdefault(start, []).append(end)
    place = {cell: float(k) for column in lanes for k, cell in enumerate(column)}

    def wanted(cell: Cell, *sides: Mapping[Cell, list[Cell]]) -> float:
        neighbours = [place[each] for side in sides for each in side.get(cell, ())]
        return sum(neighbours) / len(neighbours) if neighbours else place[cell]

    for sweep in range(SWEEPS):
        sides = near if sweep >= SORTING else near[sweep % 2 : sweep % 2 + 1]
        for column in lanes[:: -1 if sweep % 2 else 1]:
            aims = {cell: wanted(cell, *sides) for cell in column}
            order = sorted(column, key=(aims if sweep < SORTING else place).__getitem__)
            least = np.cumsum([room[cell] for cell in order])
            least -= [room[cell] / 2 for cell in order]
            aim = np.array([aims[cell] for cell in order])
            place |= zip(order, isotonic_regression(aim - least).x + least, strict=True)
    tops = {cell: place[cell] - room[cell] / 2 for cell in place}
    filled, empty = min(tops.values()), min(tops.values())
    for cell in sorted(tops, key=tops.__getitem__):  # what stands by itself follows close behind
        empty += max(tops[cell] - filled, 0.0)
        filled = max(filled, tops[cell] + room[cell])
        place[cell] -= empty
    return place


SWEEPS, SORTING = 24, 12
"""To and fro over the columns, and in how many of them cells may change their order."""


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
    from matplotlib.patches import FancyArrowPatch
    from matplotlib.path import Path

    from rigidtop.figures import style

    lanes, arrows = columns(reduced(whole))
    labels = {name: _broken(label(lecture, name, notation)) for name in whole}
    at = {cell: k for k, column in enumerate(lanes) for cell in column}
    room = {cell: 0.8 if cell[1] else 1.6 + labels[cell[0]].count("\n") for cell in at}
    down = heights(lanes, arrows, room)
    bottom = max(down[cell] + room[cell] / 2 for cell in down) + EDGE
    canvas = Figure(figsize=(wide * len(lanes), LINE * (bottom + EDGE)))
    axes = canvas.add_axes((0, 0, 1, 1))
    axes.set_axis_off()
    axes.set_xlim(-0.5, len(lanes) - 0.5)
    axes.set_ylim(bottom, -EDGE)
    half = {cell: _half(labels[cell[0]], wide) for cell in at if not cell[1]}
    for column in lanes:  # a lane is as long as the boxes above it and below
        widest = max((half[cell] for cell in column if cell in half), default=0.0)
        half |= {cell: widest for cell in column if cell[1]}
    for start, end in arrows:
        from_, to = at[start] + half[start], at[end] - half[end]
        bend, y0, y1 = (from_ + to) / 2, down[start], down[end]
        curve = [(from_, y0), (bend, y0), (bend, y1), (to, y1)]
        codes = [Path.MOVETO, Path.CURVE4, Path.CURVE4, Path.CURVE4]
        if end[1]:  # along the lane
            curve, codes = [*curve, (at[end] + half[end], y1)], [*codes, Path.LINETO]
        axes.add_patch(
            FancyArrowPatch(
                path=Path(curve, codes),
                arrowstyle="-" if end[1] else "-|>,head_length=2.5,head_width=1.2",
                color=style.GREY if start[0] in lecture.laws else style.FIRST,
                linewidth=0.5,
                shrinkA=0,
                shrinkB=0,
            )
        )
    for name in labels:
        law = name in lecture.laws
        axes.text(
            at[name, 0],
            down[name, 0],
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


LINE = 0.17
"""The height of a line of a label (inches)."""

EDGE = 0.2
"""Above and below the boxes (lines)."""


def _half(words: str, wide: float) -> float:
    """Half the width of a label with its frame, in columns of this width."""
    return (0.021 * max(map(len, words.split("\n"))) + 0.05) / wide


def _broken(words: str, most: int = 20) -> str:
    """A label in lines of at most so many letters."""
    return "\n".join(textwrap.wrap(words, most)) or words
