"""Figures that move, as files: GIF by Pillow, MP4 by ffmpeg where that is found."""

from __future__ import annotations

import subprocess
from collections.abc import Callable, Mapping
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib
from matplotlib.animation import AbstractMovieWriter, FFMpegWriter, PillowWriter

from rigidtop.errors import RigidtopError
from rigidtop.figures.drawing import Drawing, Film, resize
from rigidtop.figures.style import STYLE

KINDS = ("gif", "mp4")
"""By the suffix of the file."""

FRAMES = 80
PER_SECOND = 20
"""Of which a GIF can keep the time: its clock counts hundredths of a second."""

DOTS = 120
"""To the inch."""

Progress = Callable[[int, int], None]


def writer(kind: str) -> AbstractMovieWriter:
    """What writes such a file; RigidtopError where there is no ffmpeg for an mp4."""
    if kind == "gif":
        return PillowWriter(fps=PER_SECOND)
    if not FFMpegWriter.isAvailable():
        raise RigidtopError("an mp4 wants ffmpeg, which is not found: install it, or write a .gif")
    # Sides of an even number of dots, and colours that every player knows.
    even = ["-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2:color=white", "-pix_fmt", "yuv420p"]
    return FFMpegWriter(fps=PER_SECOND, codec="h264", extra_args=even)


def animated(
    drawing: Drawing,
    kind: str,
    given: Mapping[str, float] | None = None,
    *,
    frames: int = FRAMES,
    width: float | None = None,
    dots: int = DOTS,
    progress: Progress = lambda done, total: None,
) -> bytes:
    """The bytes of a film as "gif" or "mp4", `width` inches wide, or as wide as it was made.

    `progress` is called with the number of frames that are done, and of all.  Raises RigidtopError
    for a figure that does not move, and for an mp4 that ffmpeg is not there or not able to write.
    """
    if drawing.animate is None:
        raise RigidtopError(f"figure {drawing.name!r} does not move: write it as svg, pdf or png")
    values = drawing.values(given)
    with matplotlib.rc_context(STYLE), TemporaryDirectory() as folder:
        film, path = drawing.animate(**values), Path(folder) / f"film.{kind}"
        resize(film.canvas, width)
        record(path, film, frames, progress, dots)
        return path.read_bytes()


def record(
    path: Path,
    film: Film,
    frames: int,
    progress: Progress = lambda done, total: None,
    dots: int = DOTS,
) -> None:
    """Write a film of so many frames, by the suffix of its file; see `animated`."""
    kind = path.suffix.removeprefix(".")
    out = writer(kind)
    try:
        with out.saving(film.canvas, str(path), dots):
            for done in range(frames):
                film.show(done / frames)
                out.grab_frame()
                progress(done + 1, frames)
    except (OSError, subprocess.CalledProcessError) as error:
        raise RigidtopError(f"the {kind} cannot be written: {error}") from error
