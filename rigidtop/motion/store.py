"""An array in a file that fills block by block, in as many runs as it takes.

Three files: PATH, a .npy that `numpy.load` reads; PATH.json, which says what it holds; and, until
it is complete, PATH.journal, a line for each block that has been written, with a checksum.  Of what
is complete PATH.json has these lines.  A run may end anywhere: what they do not name is computed
again, and so is what is no longer, or never came to be, what was written.
"""

from __future__ import annotations

import io
import json
import os
import re
import shutil
import sys
import zlib
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import DTypeLike, NDArray

from rigidtop.errors import RigidtopError
from rigidtop.terminal.files import write_whole

PIECE = 1 << 20
"""Bytes at a time, of a block that is read again."""

CHECKSUMS = "checksums"
"""What PATH.json calls the lines of the journal."""

Interval = tuple[int, int]
"""First index and the one past the last, of the flattened array."""


@dataclass(eq=False)
class Store:
    """The open file, made by `open_store`."""

    path: Path
    total: int
    data: BinaryIO
    journal: BinaryIO
    offset: int
    """Of the first number, bytes."""
    missing: list[Interval]
    """What was not there when the file was opened."""
    done: int
    """How many numbers are there."""
    lines: dict[Interval, str]
    """Of the journal, for the blocks that are there."""
    damaged: int = 0
    """How many of those missing had been there, and were no longer what was written."""

    def write(self, start: int, values: NDArray[np.generic]) -> None:
        """Numbers from the index `start` on."""
        # No memory map: its pages would count as this process's memory until they are reclaimed.
        self.data.seek(self.offset + start * values.itemsize)
        written = np.ascontiguousarray(values).data
        self.data.write(written)
        self.data.flush()
        block = start, start + len(values)
        self.lines[block] = _line(block, [written])
        self.journal.write(f"{self.lines[block]}\n".encode())
        self.journal.flush()
        self.done += len(values)


@contextmanager
def open_store(
    path: Path, about: Mapping[str, object], dtype: DTypeLike, shape: tuple[int, ...]
) -> Iterator[Store]:
    """The file, new or as an earlier run with the same `about` left it.

    Complete when the body ends with nothing missing.  Raises RigidtopError for a file that holds
    something else, for one that another run is writing, and where the system refuses.
    """
    dtype = np.dtype(dtype)
    total = int(np.prod(shape, dtype=object))
    size = total * dtype.itemsize
    with readable_errors(path):
        begun = _begun(path, about)
        if begun and _is_complete(path):
            lines = sound(path, dtype, shape)
            if not gaps(lines, total):
                with path.open("rb") as data:
                    yield Store(path, total, data, io.BytesIO(), 0, [], total, lines)
                return
        if not begun:
            path.parent.mkdir(parents=True, exist_ok=True)
            free = shutil.disk_usage(path.absolute().parent).free
            if size > free:
                raise RigidtopError(f"{path} takes {size:.3g} bytes, and {free:.3g} are free")
        # Until here all is as it was: what is refused gets no journal beside it.
        with journal_path(path).open("a+b") as journal:
            _lock(journal, path)
            if not _begun(path, about):  # nor by another run, since
                journal.truncate(0)
                _say(path, about, complete=False)
                part = path.with_name(f".{path.name}.{os.getpid()}.part")
                np.lib.format.open_memmap(part, "w+", dtype, shape)  # a header, and a hole
                os.replace(part, path)
            elif _is_complete(path):  # and damaged
                journal.truncate(0)
                journal.writelines(
                    f"{line}\n".encode() for line in read_lines(path, total).values()
                )
                journal.flush()
                _say(path, about, complete=False)
            offset = data_offset(path, dtype, shape)
            journal.seek(0)
            named = read_journal(journal.read(), total)
            journal.write(b"\n")  # behind what may be a torn line
            with path.open("r+b") as data:
                lines = _sound(data, named, offset, dtype.itemsize)
                missing = gaps(lines, total)
                there, before = (total - _size(gaps(part, total)) for part in (lines, named))
                store = Store(
                    path, total, data, journal, offset, missing, there, lines, before - there
                )
                yield store
                os.fsync(data.fileno())
            if store.done == total:
                _say(path, {**about, CHECKSUMS: list(store.lines.values())}, complete=True)
                journal_path(path).unlink(missing_ok=True)


@contextmanager
def readable_errors(path: Path) -> Iterator[None]:
    """What the system refuses, in one line."""
    try:
        yield
    except OSError as error:
        where = error.filename or path
        raise RigidtopError(f"cannot use {where}: {error.strerror or error}") from error


def place(path: Path | str) -> Path:
    """Where the files are; a link keeps its place."""
    path = Path(path)
    return path.resolve() if path.is_symlink() else path


def about_path(path: Path) -> Path:
    """Where it is said what the file holds."""
    return path.with_name(path.name + ".json")


def journal_path(path: Path) -> Path:
    """Where the blocks are listed that are there."""
    return path.with_name(path.name + ".journal")


def read_about(path: Path) -> dict[str, Any] | None:
    """What the file is said to hold, with the key "complete"; None where nothing is said."""
    try:
        about = json.loads(about_path(path).read_bytes())
    except (FileNotFoundError, ValueError):
        return None
    return about if isinstance(about, dict) else None


def read_lines(path: Path, total: int) -> dict[Interval, str]:
    """The blocks of a file that is complete, with the lines of its journal."""
    lines = (read_about(path) or {}).get(CHECKSUMS)
    return read_journal("\n".join(map(str, lines or ())).encode(), total)


def read_journal(text: bytes, total: int) -> dict[Interval, str]:
    r"""The blocks that it names, with their lines; a line that a crash has torn names none.

    >>> read_journal(b"0 10 0badcafe\n20 30 00c0\n40 50 00c0ffee\n", 100)
    {(0, 10): '0 10 0badcafe', (40, 50): '40 50 00c0ffee'}
    """
    lines = re.findall(rb"^((\d{1,19}) (\d{1,19}) [0-9a-f]{8})$", text, re.MULTILINE)
    pieces = {(int(start), int(stop)): line.decode() for line, start, stop in lines}
    return {(start, stop): line for (start, stop), line in pieces.items() if start < stop <= total}


def sound(path: Path, dtype: DTypeLike, shape: tuple[int, ...]) -> dict[Interval, str]:
    """The blocks of a file that is complete that are what was written, with their lines."""
    dtype = np.dtype(dtype)
    lines = read_lines(path, int(np.prod(shape, dtype=object)))
    with path.open("rb") as data:
        return _sound(data, lines, data_offset(path, dtype, shape), dtype.itemsize)


def gaps(done: Iterable[Interval], total: int) -> list[Interval]:
    """What is not done.

    >>> gaps([(20, 30), (0, 10), (25, 40)], 100)
    [(10, 20), (40, 100)]
    """
    missing, reached = [], 0
    for start, stop in sorted(done):
        if start > reached:
            missing.append((reached, start))
        reached = max(reached, stop)
    return [*missing, (reached, total)] if reached < total else missing


def _size(intervals: Iterable[Interval]) -> int:
    return sum(stop - start for start, stop in intervals)


def _line(block: Interval, content: Iterable[bytes | memoryview]) -> str:
    """A line of the journal; its checksum is also one of the place."""
    place = "{} {}".format(*block)
    checksum = zlib.crc32(place.encode())
    for piece in content:
        checksum = zlib.crc32(piece, checksum)
    return f"{place} {checksum:08x}"


def _sound(
    data: BinaryIO, lines: Mapping[Interval, str], offset: int, itemsize: int
) -> dict[Interval, str]:
    """The blocks that are what was written, with their lines."""

    def pieces(start: int, stop: int) -> Iterator[bytes]:
        data.seek(offset + start * itemsize)
        left = (stop - start) * itemsize
        while piece := data.read(min(left, PIECE)):
            left -= len(piece)
            yield piece

    return {block: line for block, line in lines.items() if _line(block, pieces(*block)) == line}


def _is_complete(path: Path) -> bool:
    return bool((read_about(path) or {}).get("complete"))


def _begun(path: Path, about: Mapping[str, object]) -> bool:
    """Whether an earlier run began this file; raises RigidtopError where it is another's."""
    if not path.exists():
        return False
    if not path.is_file():
        raise RigidtopError(f"cannot write {path}: it is there, and is not an ordinary file")
    there = read_about(path)
    if there is None:
        raise RigidtopError(
            f"{path} is there, and no {about_path(path).name} says that a sweep wrote it: delete "
            "it, or write elsewhere"
        )
    names = sorted({*there, *about} - {"complete", CHECKSUMS})
    differ = " and ".join(name for name in names if there.get(name) != about.get(name))
    if differ:
        raise RigidtopError(
            f"{path} holds another sweep (other {differ}): delete it, or write elsewhere"
        )
    return True


def data_offset(path: Path, dtype: np.dtype[np.generic], shape: tuple[int, ...]) -> int:
    """Where the numbers begin, bytes; raises RigidtopError for a file that is not as it was left.

    That is one that has been replaced since, or is shorter or longer.
    """
    try:
        data = np.load(path, mmap_mode="r")
        as_left = (data.dtype, data.shape, data.flags.c_contiguous) == (dtype, shape, True)
    except (ValueError, EOFError):
        as_left = False
    if not as_left or path.stat().st_size != data.offset + data.nbytes:
        raise RigidtopError(f"{path} is not as the sweep left it: delete it, or write elsewhere")
    return int(data.offset)


def _say(path: Path, about: Mapping[str, object], complete: bool) -> None:
    text = json.dumps({**about, "complete": complete}, indent=1, allow_nan=False)
    write_whole(about_path(path), f"{text}\n".encode())


def _lock(journal: BinaryIO, path: Path) -> None:
    """Until it is closed; two runs at one file would each take it for their own."""
    if sys.platform == "win32":
        return
    import fcntl

    try:
        fcntl.flock(journal, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise RigidtopError(f"another run is writing {path}") from None
    except OSError:
        return  # a file system without locks
