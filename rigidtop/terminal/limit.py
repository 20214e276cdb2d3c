"""A limit of time for what may never end."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType


class TooLong(BaseException):
    """The time is over; like KeyboardInterrupt it is no Exception, which a library may catch."""


@contextmanager
def within(seconds: float) -> Iterator[None]:
    """Raises `TooLong` out of the body after this time of the processor.

    Only the main thread can be stopped so, and not on Windows or in a browser: elsewhere there is
    no limit.  In a browser the page keeps one, by ending the worker (`rigidtop.commands.browser`).
    """
    main = threading.current_thread() is threading.main_thread()
    if not main or not hasattr(signal, "setitimer"):
        yield
        return

    def stop(number: int, frame: FrameType | None) -> None:
        raise TooLong

    before = signal.signal(signal.SIGVTALRM, stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, max(seconds, 1e-3))
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)
