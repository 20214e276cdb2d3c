"""Characters that nobody sees, and that tell a terminal or TeX what to do, made visible.

They come in with titles, names of files and notes: control characters, and those that turn the
direction of writing, so that a line reads as another than it is.
"""

from __future__ import annotations

import io
import os
import re
from typing import Any, TextIO, cast

_UNSEEN = re.compile(
    "[\0-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ufeff]"
)
_OURS = re.compile(r"(\x1b\[\d?\d?m|\r\x1b\[K)")
"""A colour, and what takes a line of progress away."""


def visible(text: str) -> str:
    """The text with such characters as their numbers; ends of lines and tabs stay.

    >>> visible("a\\x1b[2J\\u202eb\\n")
    'a(U+001B)[2J(U+202E)b\\n'
    """
    return _UNSEEN.sub(lambda match: f"(U+{ord(match[0]):04X})", text)


def escaped(json: str) -> str:
    """The same of JSON, which reads back as it was."""
    return _UNSEEN.sub(lambda match: f"\\u{ord(match[0]):04x}", json)


class _Visible:
    """A stream that shows them; a terminal has its colours and lines of progress besides."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream

    def write(self, text: str) -> int:
        parts = _OURS.split(text) if self._stream.isatty() else [text]
        line = "".join(part if k % 2 else visible(part) for k, part in enumerate(parts))
        self._stream.write(line)
        return len(text)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._stream, name)


def shown_on(stream: TextIO | None) -> TextIO:
    """The stream, on which all that is printed is visible; nowhere if it was closed at the start.

    A terminal that can't show θ gets an escape in its place, not an error.
    """
    if stream is None:
        return open(os.devnull, "w", encoding="utf-8")
    if isinstance(stream, io.TextIOWrapper):
        stream.reconfigure(errors="backslashreplace")
    return cast(TextIO, _Visible(stream))
