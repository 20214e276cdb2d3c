"""Lines judged by two processes: while one makes their moves, the other asks worlds.

Each goes on with something else that is asked, so that neither waits for long.
"""

from __future__ import annotations

import multiprocessing
import os
import pickle
import sys
import threading
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeVar

from rigidtop.commands.sweep import follow
from rigidtop.terminal.progress import over

if TYPE_CHECKING:
    from rigidtop.judge.outcome import Outcome
    from rigidtop.proof.derivation import Judged
    from rigidtop.proof.lecture import Lecture

Moved = TypeVar("Moved")
Apart = TypeVar("Apart")


def judged_beside(
    lecture: Lecture, moved: Callable[[Lecture], Moved], apart: Callable[[Lecture], Apart]
) -> tuple[Lecture, Moved, Apart]:
    """The lecture with all its lines judged; as it came where that takes one process.

    Besides, what two functions make of it: `moved` after the moves, which it may ask for, and
    `apart` in the other process, from which it has to be sent.

    Of what worlds say the moves need to know only that no line is false in them.  Where one is, the
    lines have to be judged one after the other, so that what rests on it is judged without it.
    """
    from rigidtop.judge.outcome import FALSE
    from rigidtop.judge.page import remember

    def alone() -> tuple[Lecture, Moved, Apart]:
        return lecture, moved(lecture), apart(lecture)

    if lecture.refuted is None or not can_fork():
        return alone()
    unsent: list[str] = []
    try:
        with _asking(lecture, apart) as (asked, reply):

            def ask(lecture: Lecture, judged: Judged) -> str:
                try:
                    asked.put(pickle.dumps(replace(judged.known, equations=())))
                except (pickle.PicklingError, AttributeError, TypeError):
                    unsent.append(judged.line.id)
                return ""

            asking = replace(lecture, refuted=ask)
            for id in over("following lines", [*asking.lines]):
                asking.judged(id)
            asked.put(None)
            here = moved(asking)
            outcomes: dict[str, Outcome]
            outcomes, there = reply.recv()
    except (EOFError, OSError, ImportError):  # the other process has ended, or can't be
        return alone()
    if unsent or any(each.verdict == FALSE for each in outcomes.values()):
        return alone()
    remember(asking, outcomes)
    return asking, here, there


def can_fork() -> bool:
    """Whether there is a second processor, and a copy of this process would be whole."""
    free = len(os.sched_getaffinity(0)) if sys.platform == "linux" else 1
    return free > 1 and threading.active_count() == 1


@contextmanager
def _asking(lecture: Lecture, apart: Callable[[Lecture], object]) -> Iterator[tuple[Any, Any]]:
    """Where to put what is known of a line, pickled, None at last; and where outcomes come from."""
    context = multiprocessing.get_context("fork")
    asked = context.Queue()
    reply, tell = context.Pipe(duplex=False)
    other = context.Process(target=_answer, args=(lecture, apart, asked, reply, tell), daemon=True)
    with warnings.catch_warnings():
        # Python warns of threads; those of the linear algebra are made anew in the copy.
        warnings.simplefilter("ignore", DeprecationWarning)
        other.start()
    tell.close()
    try:
        yield asked, reply
    finally:
        other.terminate()
        other.join()
        reply.close()
        asked.cancel_join_thread()
        asked.close()


def _answer(
    lecture: Lecture, apart: Callable[[Lecture], object], asked: Any, reply: Any, tell: Any
) -> None:
    """Send the outcome of each line by its id, and what is made `apart`: the other process."""
    from rigidtop.judge.page import outcome
    from rigidtop.proof.derivation import Judged
    from rigidtop.proof.equation import as_printed

    follow()
    reply.close()
    outcomes: dict[str, Outcome] = {}
    with suppress(Exception):  # what does not answer is not asked again
        while (question := asked.get()) is not None:
            with as_printed():  # SymPy makes each tree anew, and is to keep it as it is
                read = pickle.loads(question)
            outcomes[read.id] = outcome(lecture, Judged(lecture.lines[read.id], read))
        tell.send((outcomes, apart(lecture)))
