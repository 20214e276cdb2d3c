"""``rigidtop new``: a collection to start from, which passes its checks as it is."""

from __future__ import annotations

import argparse
import keyword
import os
import shutil
from pathlib import Path

from rigidtop.commands.output import print_json
from rigidtop.errors import RigidtopError

ABOUT = "start a collection of one's own: a folder with a page, two claims and an exercise"

EPILOG = """\
A collection is Python and runs as such. What is written passes at once:
  rigidtop new my_course
  rigidtop check my_course/
  rigidtop lecture my_course/ -o out
  rigidtop new --page my_chapter    # Markdown alone: letters, laws, claims
  rigidtop new --system my_system
  rigidtop new --from kepler my_chapter"""

STARTER = Path(__file__).parents[1] / "starter"
"""The package that is copied, so that what is started has been tested as it stands."""


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to its parser."""
    kind = parser.add_mutually_exclusive_group()
    kind.add_argument(
        "--system",
        action="store_true",
        help="start from a Lagrangian: a system, its derivation line by line, two claims",
    )
    kind.add_argument(
        "--page",
        action="store_true",
        help="write a page in Markdown alone: its letters, its laws, its claims, and no Python",
    )
    kind.add_argument(
        "--from",
        dest="chapter",
        metavar="CHAPTER",
        help="copy one of the chapters that `rigidtop list --chapters` names, such as kepler",
    )
    parser.add_argument("folder", help="a folder that is not there yet, or is empty")


def run(options: argparse.Namespace) -> int:
    """Write the folder, as a whole or not at all."""
    from rigidtop.collection import typed

    if not options.folder:
        raise RigidtopError("name a folder, such as my_course")
    folder = Path(options.folder)
    _check_name(folder.resolve().name)
    contents = _contents(options)
    names = [*contents]
    write(folder, contents)
    if options.json:
        print_json({"files": [str(folder / name) for name in names]})
    else:
        print("\n".join(str(folder / name) for name in names))
        print(f"now: rigidtop check {typed(folder)}")
    return 0


def _contents(options: argparse.Namespace) -> dict[str, bytes]:
    """What is written, by the names of its files."""
    from rigidtop.collection.chapters import chapter

    if options.page:
        return _page()
    if options.chapter is not None:
        return _files(chapter(options.chapter))
    return _files(STARTER / "system" if options.system else STARTER)


def _files(starter: Path) -> dict[str, bytes]:
    """The files that are copied, by their names."""
    files = sorted(file for file in starter.glob("*") if file.suffix in (".py", ".md"))
    return {file.name: file.read_bytes() for file in files}


def _page() -> dict[str, bytes]:
    """The starter's page with a table of its letters, which needs nothing beside it."""
    from rigidtop.collection.pages import table_of
    from rigidtop.starter import letters
    from rigidtop.theory.lettered import Lettered

    symbols = sorted(
        (x for x in vars(letters).values() if isinstance(x, Lettered)), key=lambda x: x.place
    )
    page = (STARTER / "pendulum.md").read_text("utf-8")
    before, laws, behind = page.partition("## Laws\n")
    written = f"{before}{table_of(symbols)}\n\n{laws}{behind}"
    return {"pendulum.md": written.encode()}


def _check_name(name: str) -> None:
    """RigidtopError for a name that no module can have."""
    if not name.isidentifier() or keyword.iskeyword(name):
        raise RigidtopError(
            f"{name!r} is no name for a folder that is a Python module: give it letters, digits "
            "and _, such as my_course"
        )


def write(folder: Path, contents: dict[str, bytes]) -> None:
    """Make a folder with these files, which has its name only when all of them are in it.

    Raises RigidtopError where something is there already, and where the system refuses.
    """
    target = folder.resolve()
    if target.exists() and not target.is_dir():
        raise RigidtopError(f"{folder} is there already, and is not a folder")
    if target.is_dir() and any(target.iterdir()):
        raise RigidtopError(f"{folder} is there already, and is not empty")
    if target.is_dir() and target == Path.cwd():
        raise RigidtopError("name a folder inside this one, such as my_course")
    try:
        # Beside the target, so that giving it its name is one step.
        part = target.with_name(f".{target.name}.{os.getpid()}.part")
        part.mkdir(parents=True)
        try:
            for name, content in contents.items():
                (part / name).write_bytes(content)
            if target.is_dir():
                target.rmdir()  # refuses if something has come into it
            part.rename(target)
        finally:
            shutil.rmtree(part, ignore_errors=True)
    except OSError as error:
        raise RigidtopError(f"cannot write {folder}: {error.strerror or error}") from error
