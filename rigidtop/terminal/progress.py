"""How far a long command is, on a terminal."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator, Sequence
from typing import TextIO, TypeVar

Item = TypeVar("Item")

EVERY_SECONDS = 0.1
"""Between two lines; the first waits as long, so what is quick shows none."""

WIDTH = 20
"""Of the bar, characters."""


def bar(label: str, stream: TextIO | None = None) -> Callable[[int, int], None]:
    """What to call with the number done and of all: it keeps one line on stderr, if a terminal.

    The line is gone when all is done.  What was done at the first call, as by an earlier run, does
    not count for the rate.
    """
    out = sys.stderr if stream is None else stream
    if not out.isatty():
        return lambda done, total: None
    start = latest = time.monotonic()
    begin: int | None = None

    def show(done: int, total: int) -> None:
        nonlocal begin, latest
        begin = done if begin is None else begin
        now = time.monotonic()
        if done >= total:
            print("\r\033[K", end="", file=out, flush=True)
        elif now - latest >= EVERY_SECONDS:
            latest = now
            text = line(label, done, total, done - begin, now - start)
            print(f"\r\033[K{text}", end="", file=out, flush=True)

    return show


def over(label: str, items: Sequence[Item], stream: TextIO | None = None) -> Iterator[Item]:
    """The items one after the other, with a bar for those that are done."""
    show = bar(label, stream)
    for done, item in enumerate(items):
        show(done, len(items))
        yield item
    show(len(items), len(items))


def ticking(label: str, stream: TextIO | None = None) -> Callable[[float], None]:
    """What to call with the seconds that something of unknown length has taken: one line on stderr.

    It is shown on a terminal, once a second; a negative number says that the end has come.
    """
    out = sys.stderr if stream is None else stream
    last = 0

    def show(seconds: float) -> None:
        nonlocal last
        if out.isatty() and (seconds < 0 < last or int(seconds) > last):
            text = f"{label}, {int(seconds)} s" if seconds >= 0 else ""
            print(f"\r\033[K{text}", end="", file=out, flush=True)
            last = int(seconds)

    return show


def line(label: str, done: int, total: int, new: int, seconds: float) -> str:
    """The line, `new` of what is done having taken these seconds.

    >>> line("sweeping", 250, 1000, 200, 8.0)
    'sweeping [#####               ]  25%  250 of 1000, 25/s, 0:30 left'
    """
    share = done / total
    filled = "#" * int(WIDTH * share)
    rate = new / seconds if seconds > 0 else 0.0
    text = f"{label} [{filled:<{WIDTH}}] {share:4.0%}  {done} of {total}"
    if not rate:
        return text
    left = round((total - done) / rate)
    hours, minutes = divmod(left // 60, 60)
    clock = f"{hours}:{minutes:02}:{left % 60:02}" if hours else f"{minutes}:{left % 60:02}"
    return f"{text}, {_short(rate)}/s, {clock} left"


def _short(rate: float) -> str:
    """Three digits.

    >>> _short(1234567.0), _short(25.0)
    ('1.23M', '25')
    """
    for unit, size in (("G", 1e9), ("M", 1e6), ("k", 1e3)):
        if rate >= size:
            return f"{rate / size:.3g}{unit}"
    return f"{rate:.3g}"
