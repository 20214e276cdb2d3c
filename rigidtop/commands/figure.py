"""``rigidtop figure``: a figure as a file, still or moving, with numbers of one's own."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rigidtop.commands.claims import FOLDER
from rigidtop.commands.notation import add_notation, chosen
from rigidtop.commands.output import print_json
from rigidtop.commands.settings import add_settings, apart, whole, within
from rigidtop.errors import RigidtopError
from rigidtop.parameters import settings

if TYPE_CHECKING:
    from rigidtop.collection import Collection
    from rigidtop.figures.drawing import Drawing

ABOUT = "draw a figure as SVG, PDF or PNG, or let it move as GIF or MP4"

EPILOG = """\
Without NAME it lists the figures and what can be set in each.  Angles are radians, or
degrees with the suffix deg; rates rad/s, or turns a minute with the suffix rpm.

examples:
  rigidtop figure
  rigidtop figure torque -o torque.pdf
  rigidtop figure paths --set theta=30deg omega3=400rpm -o paths.svg
  rigidtop figure rolling-cones -o cones.mp4 --seconds 8 --dpi 300
  rigidtop figure my_course/ orbit -o orbit.gif"""

STILL, MOVING = ("svg", "pdf", "png"), ("gif", "mp4")
MOST_FRAMES, MOST_SECONDS = 2000, 100
CENTIMETRES = 2.54
"""In an inch."""

WIDEST, MOST_DOTS = 17.8, 10_000
"""Centimetres of a figure as it was made, and dots in a row of one."""


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to its parser."""
    parser.add_argument("name", nargs="*", metavar="NAME", help=f"the figure; {FOLDER}")
    parser.add_argument(
        "-o",
        "--output",
        metavar="FILE",
        help="its suffix says what it becomes: svg, pdf, png; gif, mp4 (default: NAME.svg)",
    )
    add_settings(parser, "change parameters of the figure, such as theta=30deg")
    parser.add_argument(
        "--frames",
        type=whole(2, MOST_FRAMES),
        metavar="N",
        help="of a gif or mp4, 20 a second (default: 80)",
    )
    parser.add_argument(
        "--seconds",
        type=within(0.1, MOST_SECONDS),
        metavar="S",
        help="how long a gif or mp4 is, in place of --frames",
    )
    parser.add_argument(
        "--width",
        type=within(2, 50),
        metavar="CM",
        help="how wide; letters keep their size (default: that of the figure, 8.6 to 17.8)",
    )
    parser.add_argument(
        "--dpi",
        type=whole(20, 1200),
        metavar="N",
        help="dots to the inch of a png (default: 300), gif or mp4 (120)",
    )
    add_notation(parser)


def run(options: argparse.Namespace) -> int:
    """List the figures, or write one; returns the exit code."""
    from rigidtop.collection import is_folder, opened

    if all(map(is_folder, options.name)):  # no figure before --set: is it behind?
        options.set, more = apart(options.set)
        options.name += more
    with opened(options.name) as (collection, names):
        return _run(collection, names, options)


def _run(collection: Collection, names: Sequence[str], options: argparse.Namespace) -> int:
    from rigidtop.figures.catalog import named

    figures = collection.figures
    if len(names) > 1:
        raise RigidtopError(f"one figure at a time: {' '.join(names)} are too many")
    if not names:
        if options.output is not None or options.set or options.frames:
            raise RigidtopError(f"which figure?  `{collection.command('figure')}` lists them")
        _print_list(figures, options.json)
        return 0
    from rigidtop.report.wording import Wording
    from rigidtop.typeset.words import unmarked

    drawing, notation = named(names[0], figures), chosen(options)
    values = settings(drawing.parameters, options.set)
    path = Path(f"{drawing.name}.svg" if options.output is None else options.output)
    kind = path.suffix.removeprefix(".").lower()
    _check(options, drawing, path, kind, figures)
    if kind in MOVING and notation.images:
        raise RigidtopError(f"--notation goes with .svg, .pdf or .png, not with a .{kind}")
    drawing = Wording(notation).drawing(drawing)
    record: dict[str, Any] = {
        "file": str(path),
        "name": drawing.name,
        "parameters": values,
        "caption": unmarked(drawing.caption(**values)),
        "alternative": unmarked(drawing.alternative(**values)),
    }
    if kind in MOVING:
        from rigidtop.figures.animation import FRAMES, PER_SECOND

        seconds = round((options.seconds or 0) * PER_SECOND)
        record["frames"] = options.frames or seconds or FRAMES
    size: dict[str, Any] = {"dots": options.dpi} if options.dpi else {}
    size |= {"width": options.width / CENTIMETRES} if options.width else {}
    _write(drawing, path, kind, values, record.get("frames", 0), size)
    if options.json:
        print_json(record)
    else:
        print(f"{record['file']}\n{record['caption']}")
    return 0


def _check(
    options: argparse.Namespace,
    drawing: Drawing,
    path: Path,
    kind: str,
    figures: Sequence[Drawing],
) -> None:
    """Refuse what can't be written before anything is drawn."""
    from rigidtop.terminal.files import check_folder

    if kind not in STILL + MOVING:
        ending = f"not .{kind}" if kind else f"and {str(path)!r} has none"
        raise RigidtopError(
            f"--output wants a file with the suffix .svg, .pdf, .png, .gif or .mp4, {ending}"
        )
    if kind in MOVING and drawing.animate is None:
        those = ", ".join(each.name for each in figures if each.animate is not None) or "nothing"
        raise RigidtopError(
            f"{drawing.name} does not move: write it as .svg, .pdf or .png (what moves: {those})"
        )
    if kind in MOVING:
        from rigidtop.figures.animation import writer

        writer(kind)  # an mp4 wants ffmpeg
    for name in ("frames", "seconds"):
        if kind in STILL and getattr(options, name):
            raise RigidtopError(f"--{name} goes with a .gif or .mp4, not with a .{kind}")
    if options.frames and options.seconds:
        raise RigidtopError("--frames and --seconds both say how long it is: give one")
    if options.dpi and kind in ("svg", "pdf"):
        raise RigidtopError(f"--dpi goes with a .png, .gif or .mp4: a .{kind} has no dots")
    dots = round((options.width or WIDEST) / CENTIMETRES * (options.dpi or 300))
    if kind not in ("svg", "pdf") and dots > MOST_DOTS:
        raise RigidtopError(f"a row of {dots} dots is too long: at most {MOST_DOTS}")
    check_folder(path.parent)


def _write(
    drawing: Drawing,
    path: Path,
    kind: str,
    values: dict[str, float],
    frames: int,
    size: dict[str, Any],
) -> None:
    from rigidtop.terminal.files import write_whole
    from rigidtop.terminal.progress import bar

    if kind in STILL:
        from rigidtop.figures.drawing import rendered

        content = rendered(drawing, kind, values, **size)
    else:
        from rigidtop.figures.animation import animated

        content = animated(drawing, kind, values, frames=frames, **size, progress=bar("drawing"))
    write_whole(path, content)


def _print_list(figures: Sequence[Drawing], as_json: bool) -> None:
    from rigidtop.terminal.table import columns, padded, paragraph
    from rigidtop.typeset.words import unmarked

    if as_json:
        print_json([_record(each) for each in figures])
        return
    room = max((columns(each.name) for each in figures), default=0) + 2
    for each in figures:
        title = unmarked(each.title) + (" (moves)" if each.animate else "")
        print(paragraph(title, padded(each.name, room), " " * room))
        defaults = " ".join(f"{p.name}={p.default:.4g}" for p in each.parameters)
        if defaults:
            print(paragraph(defaults, "    ", "    "))


def _record(drawing: Drawing) -> dict[str, object]:
    """A figure of the catalogue as plain values, for JSON."""
    from rigidtop.typeset.words import unmarked

    return {
        "name": drawing.name,
        "title": unmarked(drawing.title),
        "section": drawing.section,
        "kinds": [*STILL, *(MOVING if drawing.animate else ())],
        "parameters": [
            {"name": p.name, "default": p.default, "unit": p.unit, "about": unmarked(p.about)}
            for p in drawing.parameters
        ],
    }
