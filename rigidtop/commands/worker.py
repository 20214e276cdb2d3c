"""A server that listens in a thread, with what takes long done in the main thread.

Only there can a limit of time end it: see `rigidtop.terminal.limit`.
"""

from __future__ import annotations

import _thread
import logging
import os
import sys
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from contextlib import contextmanager
from queue import SimpleQueue
from typing import BinaryIO, TypeVar

T = TypeVar("T")


class Worker:
    """What does jobs one after another, in the order in which they are handed in."""

    def __init__(self) -> None:
        self._jobs: SimpleQueue[Callable[[], None]] = SimpleQueue()
        self._over = threading.Event()

    def result(self, job: Callable[[], T]) -> Future[T]:
        """What will come of a job, or the error that it raises."""
        future: Future[T] = Future()

        def do() -> None:
            if not future.set_running_or_notify_cancel():
                return
            try:
                future.set_result(job())
            except Exception as error:
                future.set_exception(error)

        self._jobs.put(do)
        return future

    def serve(self, listen: Callable[[], None]) -> None:
        """Do jobs for as long as something listens; what is not done then is given up."""

        def listening() -> None:
            try:
                listen()
            finally:
                self._over.set()
                _thread.interrupt_main()
                self._jobs.put(lambda: None)  # wakes it

        logging.disable(logging.CRITICAL)  # a broken message is answered, or skipped
        threading.Thread(target=listening, daemon=True).start()
        try:
            while not self._over.is_set():  # an interrupt within a destructor is lost
                self._jobs.get()()
        except KeyboardInterrupt:
            if not self._over.is_set():
                raise


@contextmanager
def own_output() -> Iterator[BinaryIO]:
    """Standard output for the protocol alone: what is printed besides goes to standard error."""
    sys.stdout.flush()
    printed = sys.stdout
    with os.fdopen(os.dup(1), "wb") as output:
        sys.stdout = sys.stderr
        try:
            yield output
        finally:
            sys.stdout = printed
