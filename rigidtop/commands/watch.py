"""``rigidtop watch``: notes audited each time they are saved."""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

from rigidtop.errors import RigidtopError

if TYPE_CHECKING:
    from rigidtop.collection import Collection

ABOUT = "audit notes each time they are saved, what is wrong first"

EPILOG = """\
It prints what `rigidtop audit` prints, again after each change of the file or of one
that it takes in, and ends with Ctrl-C.

examples:
  rigidtop watch notes.md
  rigidtop watch my_course/ my_notes.tex      # against your own collection"""

PAUSE = 0.3
"""So long between two looks at the files (s)."""


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to its parser."""
    parser.add_argument(
        "file", nargs="+", metavar="FILE", help="the notes; before them a collection's folder"
    )


def run(options: argparse.Namespace) -> int:
    """Audit the file now and after each change, until it is interrupted."""
    from rigidtop.collection import opened
    from rigidtop.read.project import sources

    *folders, name = options.file
    if len(folders) > 1:
        raise RigidtopError(f"one file at a time: {len(options.file)} names are too many")
    if options.json:
        raise RigidtopError("watch prints text; `rigidtop audit --json` prints JSON")
    path = Path(name)
    sources(path)  # what can't be read at the start will not be
    with opened([f"{folder}/" for folder in folders]) as (collection, _):
        for _ in saved(path):
            _tell(path, collection)
    return 0


def _tell(path: Path, collection: Collection) -> None:
    """Print the time and what is found now."""
    from rigidtop.commands.audit import tell
    from rigidtop.commands.notes import audited
    from rigidtop.read.project import sources

    print(f"{time.strftime('%H:%M:%S')}  {path}\n")
    try:
        tell(audited(sources(path), collection).findings)
    except RigidtopError as error:  # the next change may mend it
        print(error)
    print(flush=True)


def saved(path: Path, pause: float = PAUSE) -> Iterator[tuple[tuple[Path, int], ...]]:
    """The files that belong together with their times of change: now and after each change."""
    from rigidtop.read.project import sources

    seen: tuple[tuple[Path, int], ...] = ()
    while True:
        with suppress(OSError, RigidtopError):  # while an editor writes it, it may not be there
            now = tuple((each.path, each.path.stat().st_mtime_ns) for each in sources(path))
            if now != seen:
                seen = now
                yield now
        time.sleep(pause)
