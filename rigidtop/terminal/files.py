"""Files that users name: text read in one way, and what is written whole or not there."""

from __future__ import annotations

import argparse
import os
from collections.abc import Mapping, Sequence
from pathlib import Path

from rigidtop.errors import RigidtopError

LONGEST = 4_000_000
"""A file is no longer than this (bytes)."""


def text_of(path: Path | str) -> str:
    """The text of a file in UTF-8, its lines ended by \\n alone.

    Raises RigidtopError for what is not there, is no text, or is too long.
    """
    there = Path(path)
    if there.exists() and not (there.is_file() or there.is_dir()):  # a pipe may never be written
        raise RigidtopError(f"cannot read {path}: it is not an ordinary file")
    try:
        with there.open("rb") as file:
            content = file.read(LONGEST + 1)
    except OSError as error:
        raise RigidtopError(f"cannot read {path}: {error.strerror or error}") from None
    if len(content) > LONGEST:
        raise RigidtopError(f"cannot read {path}: it has more than {LONGEST} bytes")
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = "\0"
    if "\0" in text:
        raise RigidtopError(f"cannot read {path}: it is not text in UTF-8")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def write_whole(path: Path, content: bytes) -> None:
    """Replace `path` by the content, once all of it is on the disk beside it.

    A link keeps its place and its target is replaced.  Raises RigidtopError for what is there and
    is no ordinary file, such as a folder or a device, and where the system refuses.
    """
    path = path.resolve()
    if path.exists() and not path.is_file():
        raise RigidtopError(f"cannot write {path}: it is there, and is not an ordinary file")
    part = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        try:
            part.write_bytes(content)
            os.replace(part, path)
        finally:
            part.unlink(missing_ok=True)
    except OSError as error:
        raise RigidtopError(f"cannot write {path}: {error.strerror or error}") from error


def write_all(folder: Path, contents: Mapping[str, bytes]) -> list[Path]:
    """Write files by their names relative to the folder, each as a whole."""
    paths = [folder / name for name in contents]
    for path, content in zip(paths, contents.values(), strict=True):
        write_whole(path, content)
    return paths


def check_folder(folder: Path | str) -> None:
    """Make the folder, or raise RigidtopError: ask before long work, not after it."""
    path = Path(folder)
    existing = next(p for p in (path, *path.absolute().parents) if p.exists())
    if not existing.is_dir():
        raise RigidtopError(f"cannot write into {path}: {existing} is not a folder")
    try:
        path.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise RigidtopError(f"cannot write into {path}: {error.strerror or error}") from error
    if not os.access(path, os.W_OK | os.X_OK):
        raise RigidtopError(f"cannot write into {path}: no permission")


def rewrite(command: str, about: str | None, path: Path, text: str, words: Sequence[str]) -> int:
    """A command for a module that a program writes: it writes the text, or says if it is current.

    With ``--check`` among its `words` nothing is written.  Returns the exit code, 1 where the file
    should be written and is not.
    """
    parser = argparse.ArgumentParser(command, description=about)
    parser.add_argument("--check", action="store_true", help="only say whether it is current")
    check = parser.parse_args(words).check
    current = path.exists() and path.read_text("utf-8") == text
    if check and not current:
        print(f"{path} is not what the theory gives: run {command}")
        return 1
    if not current:
        write_whole(path, text.encode())
    print(f"{path} is current" if current else f"{path} rewritten")
    return 0
