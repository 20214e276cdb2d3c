"""An array in a file that fills block by block, in as many runs as it takes.

Three files: PATH, a .npy that `numpy.load` reads; PATH.json, which says what it holds; and, until
it is complete, PATH.journal, a line for each block that is on the disk, with a checksum.  A line is
written after its block has reached the disk, so a run may end anywhere: what the journal does not
name is computed again, and so is what is no longer what was written.
"""

from __future__ import annotations

import io
import json
import os
import re
import shutil
import sys
import time
import zlib
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import DTypeLike, NDArray

from rigidtop.errors import RigidtopError

SYNC_SECONDS = 1.0
"""Between two journal entries: waiting for the disk after each block could take most of the time;
a run that is killed loses what it finished since."""

PIECE = 1 << 20
"""Bytes at a time, of a block that is read again."""

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
    damaged: int = 0
    """How many of those missing had been there, and were no longer what was written."""
    _waiting: list[str] = field(default_factory=list)
    _synced: float = field(default_factory=time.monotonic)

    def write(self, start: int, values: NDArray[Any]) -> None:
        """Numbers from the index `start` on."""
        # No memory map: its pages would count as this process's memory until they are reclaimed.
        self.data.seek(self.offset + start * values.itemsize)
        written = np.ascontiguousarray(values).data
        self.data.write(written)
        self._waiting.append(_line((start, start + len(values)), [written]))
        self.done += len(values)
        if time.monotonic() - self._synced >= SYNC_SECONDS:
            self.sync()

    def sync(self) -> None:
        """Bring what has been written to the disk, and then its lines in the journal."""
        if self._waiting:
            _to_disk(self.data)
            self.journal.write("".join(self._waiting).encode())
            _to_disk(self.journal)
            self._waiting.clear()
        self._synced = time.monotonic()


@contextmanager
def open_store(
    path: Path, about: Mapping[str, Any], dtype: DTypeLike, shape: tuple[int, ...]
) -> Iterator[Store]:
    """The file, new or as an earlier run with the same `about` left it.

    Complete when the body ends with nothing missing.  Raises RigidtopError for a file that holds
    something else, for one that another run is writing, and where the system refuses.
    """
    header = _header(np.dtype(dtype), shape)
    total = int(np.prod(shape, dtype=object))
    size = len(header) + total * np.dtype(dtype).itemsize
    with readable_errors(path):
        if path.is_file() and read_about(path) == {**about, "complete": True}:
            _check(path, header, size)
            with path.open("rb") as data:
                yield Store(path, total, data, io.BytesIO(), len(header), [], total)
            return
        if not _begun(path, about):
            path.parent.mkdir(parents=True, exist_ok=True)
            free = shutil.disk_usage(path.absolute().parent).free
            if size > free:
                raise RigidtopError(f"{path} takes {size:.3g} bytes, and {free:.3g} are free")
        # Until here all is as it was: what is refused gets no journal beside it.
        with journal_path(path).open("a+b") as journal:
            _lock(journal, path)
            if _begun(path, about):  # by another run, perhaps, since
                _check(path, header, size)
            else:
                journal.truncate(0)
                _replace(about_path(path), _json(about, complete=False))
                _replace(path, header, size)
            journal.seek(0)
            lines, length = read_journal(journal.read(), total)
            journal.truncate(length)  # or the next line would continue a torn one
            with path.open("r+b") as data:
                sound = _sound(data, lines, len(header), np.dtype(dtype).itemsize)
                missing = gaps(sound, total)
                there, named = (total - _size(gaps(part, total)) for part in (sound, lines))
                store = Store(
                    path, total, data, journal, len(header), missing, there, named - there
                )
                try:
                    yield store
                except BaseException:
                    with suppress(OSError):  # a full disk, say: the first error is the one to see
                        store.sync()
                    raise
                store.sync()
            if store.done == total:
                _replace(about_path(path), _json(about, complete=True))
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


def read_journal(text: bytes, total: int) -> tuple[dict[Interval, str], int]:
    r"""The blocks that it names, with their lines, and how many of its bytes make sense.

    >>> read_journal(b"0 10 0badcafe\n20 30 00c0ffee\n30 4", 100)
    ({(0, 10): '0 10 0badcafe\n', (20, 30): '20 30 00c0ffee\n'}, 29)
    """
    found, length = {}, 0
    # A line torn by a crash ends the journal: its block, and any after it, are computed again.
    for line in text.splitlines(keepends=True):
        numbers = re.fullmatch(rb"(\d{1,19}) (\d{1,19}) [0-9a-f]{8}\n", line)
        if numbers is None or not int(numbers[1]) < int(numbers[2]) <= total:
            break
        found[int(numbers[1]), int(numbers[2])] = line.decode()
        length += len(line)
    return found, length


def gaps(done: Iterable[Interval], total: int) -> list[Interval]:
    """What is not done.

    >>> gaps([(20, 30), (0, 10), (25, 40)], 100)
    [(10, 20), (40, 100)]
    """
    found, reached = [], 0
    for start, stop in sorted(done):
        if start > reached:
            found.append((reached, start))
        reached = max(reached, stop)
    return [*found, (reached, total)] if reached < total else found


def _size(intervals: Iterable[Interval]) -> int:
    return sum(stop - start for start, stop in intervals)


def _line(block: Interval, content: Iterable[Any]) -> str:
    """Of the journal; the checksum is also one of the place."""
    place = "{} {}".format(*block)
    checksum = zlib.crc32(place.encode())
    for piece in content:
        checksum = zlib.crc32(piece, checksum)
    return f"{place} {checksum:08x}\n"


def _sound(
    data: BinaryIO, lines: Mapping[Interval, str], offset: int, itemsize: int
) -> list[Interval]:
    """The blocks that are what was written."""

    def pieces(start: int, stop: int) -> Iterator[bytes]:
        data.seek(offset + start * itemsize)
        left = (stop - start) * itemsize
        while piece := data.read(min(left, PIECE)):
            left -= len(piece)
            yield piece

    return [block for block, line in lines.items() if _line(block, pieces(*block)) == line]


def _begun(path: Path, about: Mapping[str, Any]) -> bool:
    """Whether an earlier run began this file; raises RigidtopError where it is another's."""
    if not path.exists():
        return False
    if not path.is_file():
        raise RigidtopError(f"cannot write {path}: it is there, and is not an ordinary file")
    there = read_about(path)
    if there == {**about, "complete": False}:
        return True
    if there is None:
        raise RigidtopError(
            f"{path} is there, and no {about_path(path).name} says that a sweep wrote it: delete "
            "it, or write elsewhere"
        )
    now: Mapping[str, Any] = {**about, "complete": there.get("complete")}
    differ = " and ".join(
        name for name in sorted({*there, *now}) if there.get(name) != now.get(name)
    )
    raise RigidtopError(
        f"{path} holds another sweep (other {differ}): delete it, or write elsewhere"
    )


def _header(dtype: np.dtype[Any], shape: tuple[int, ...]) -> bytes:
    buffer = io.BytesIO()
    description = {"descr": np.lib.format.dtype_to_descr(dtype), "fortran_order": False}
    np.lib.format.write_array_header_1_0(buffer, {**description, "shape": shape})
    return buffer.getvalue()


def _check(path: Path, header: bytes, size: int) -> None:
    """Raises RigidtopError for a file that has been replaced or cut since."""
    with path.open("rb") as file:
        if file.read(len(header)) != header or path.stat().st_size != size:
            raise RigidtopError(
                f"{path} is not as the sweep left it: delete it, or write elsewhere"
            )


def _json(about: Mapping[str, Any], complete: bool) -> bytes:
    text = json.dumps({**about, "complete": complete}, indent=1, allow_nan=False)
    return f"{text}\n".encode()


def _replace(path: Path, content: bytes, size: int | None = None) -> None:
    """A file, whole or not there; of a size beyond its content, the rest is zeros and a hole."""
    part = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        with part.open("wb") as file:
            file.write(content)
            if size is not None:
                file.truncate(size)
            _to_disk(file)
        os.replace(part, path)
    finally:
        part.unlink(missing_ok=True)


def _to_disk(file: BinaryIO) -> None:
    file.flush()
    os.fsync(file.fileno())


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
