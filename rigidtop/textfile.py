"""Text files that users name: read in one way, refused in one wording."""

from __future__ import annotations

from pathlib import Path

from rigidtop.errors import RigidtopError

LONGEST = 4_000_000
"""A file is no longer than this (bytes)."""


def text_of(path: Path | str) -> str:
    """The text of a file in UTF-8, its lines ended by \\n alone.

    Raises RigidtopError for what is not there, is no text, or is too long.
    """
    try:
        with Path(path).open("rb") as file:
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
