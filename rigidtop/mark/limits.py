"""Marking in a process of its own, which is stopped when a line takes too long."""

from __future__ import annotations

import signal
import sys
import time
from collections.abc import Callable
from typing import TYPE_CHECKING

from rigidtop.errors import RigidtopError
from rigidtop.mark.answer import mark
from rigidtop.mark.marking import Mark, Marked, Marking
from rigidtop.mark.passages import Subject

if TYPE_CHECKING:
    from multiprocessing.connection import Connection

LONGEST = 200_000
"""An answer has no more characters."""

SECONDS_A_LINE = 20.0
SECONDS = 120.0
STARTING = 60.0
"""What loading may take."""

_ENDING = 5.0
"""What a process may take to end whose pipe is closed."""

_GIBIBYTES = 4
"""What marking may take of the memory."""


class MarkingError(RigidtopError):
    """The marking came to no end for a reason that is not the answer's: a failure of ours."""

    def __init__(self, reason: str) -> None:
        super().__init__(f"rigidtop itself failed, which says nothing of the answer: {reason}")
        self.reason = reason

    def __reduce__(self) -> tuple[type[MarkingError], tuple[str]]:
        return type(self), (self.reason,)


def marked(
    source: str,
    start: str,
    goal: str,
    a_line: float = SECONDS_A_LINE,
    altogether: float = SECONDS,
    subject: Callable[[], Subject] | None = None,
) -> Marking:
    """`rigidtop.mark.answer.mark` in limited time (seconds): what takes longer is inconclusive.

    The process makes the `subject`, which is the top if none is given.

    Raises RigidtopError for a pair of numbers without facts, and for a text that is too long, and
    MarkingError where the process breaks, is killed or runs out of memory.
    """
    if len(source) > LONGEST:
        raise RigidtopError(f"an answer has no more than {LONGEST} characters, not {len(source)}")
    if sys.platform == "emscripten":  # a browser has no processes; its reader can close the page
        return mark(source, start, goal, subject=subject and subject())
    end = time.monotonic() + altogether
    skip: set[int] = set()
    while True:
        found, lines = _run(source, start, goal, frozenset(skip), a_line, end, subject)
        if found is not None:
            return found
        if time.monotonic() >= end:
            late = Marked(
                0, "", Mark.INCONCLUSIVE, f"the marking takes longer than {altogether:g} s"
            )
            return Marking((*lines, late), False, goal, problem=late.note)
        if len(lines) in skip:
            problem = "whether the derivation arrives could not be decided in time"
            return Marking(lines, False, goal, problem=problem)
        skip.add(len(lines))


def _run(
    source: str,
    start: str,
    goal: str,
    skip: frozenset[int],
    a_line: float,
    end: float,
    subject: Callable[[], Subject] | None,
) -> tuple[Marking | None, tuple[Marked, ...]]:
    """The marking, or the lines that were marked before one took too long."""
    import multiprocessing

    # A fork is there at once; elsewhere than on Linux it is not safe.
    context = multiprocessing.get_context("fork" if sys.platform == "linux" else "spawn")
    ours, theirs = context.Pipe(duplex=False)
    process = context.Process(  # type: ignore[attr-defined]
        target=_work, args=(theirs, source, start, goal, skip, subject), daemon=True
    )
    process.start()
    theirs.close()
    lines: list[Marked] = []
    patience = STARTING
    try:
        while ours.poll(max(0.0, min(patience, end - time.monotonic()))):
            patience = a_line
            said = ours.recv()
            if isinstance(said, RigidtopError):
                raise said
            if isinstance(said, Marking):
                return said, tuple(lines)
            if isinstance(said, Marked):
                lines.append(said)
    except EOFError:
        process.join(_ENDING)
        raise MarkingError(f"the process that marks {_ended(process.exitcode)}") from None
    finally:
        process.kill()
        process.join()
        ours.close()
    return None, tuple(lines)


def _work(
    pipe: Connection,
    source: str,
    start: str,
    goal: str,
    skip: frozenset[int],
    subject: Callable[[], Subject] | None,
) -> None:
    """Mark, and say each line."""
    try:
        import resource

        resource.setrlimit(resource.RLIMIT_DATA, (_GIBIBYTES * 2**30,) * 2)
    except (ImportError, ValueError, OSError):
        pass  # not on every system; time is limited all the same
    try:
        made = subject and subject()
        try:
            mark("", start, goal, subject=made)  # what is loaded once
            pipe.send("ready")
            first = mark(source, start, goal, skip, pipe.send, made)
        except RigidtopError:
            other = _in_worlds(source, start, goal, made)
            if other is None:
                raise
            first = other
        if not first.passed and first.first_wrong is None:
            first = _in_worlds(source, start, goal, made) or first
        pipe.send(first)
    except RigidtopError as error:
        pipe.send(error)
    except MemoryError:
        pipe.send(MarkingError(f"it takes more than {_GIBIBYTES} GiB of memory"))
    except Exception as error:
        pipe.send(MarkingError(" ".join(f"{type(error).__name__}: {error}".split())))


def _in_worlds(source: str, start: str, goal: str, subject: Subject | None) -> Marking | None:
    """The marking in worlds, where the answer passes or has a slip; None for any other."""
    from rigidtop.mark.worlds import marking  # with it NumPy, which a browser may not have

    try:
        found = marking(source, start, goal, subject)
    except Exception:  # what cannot be judged there either stays what it was
        return None
    wrong = found.first_wrong
    return found if found.passed or (wrong is not None and wrong.slips) else None


def _ended(code: int | None) -> str:
    """How a process ended, in words.

    >>> _ended(-9), _ended(1)
    ('was killed (SIGKILL)', 'ended with exit code 1')
    """
    if code is not None and code < 0:
        return f"was killed ({signal.Signals(-code).name})"
    return f"ended with exit code {code}"
