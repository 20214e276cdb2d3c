"""``rigidtop sweep``: a quantity of the heavy top on a grid, in as many runs as it takes."""

from __future__ import annotations

import argparse
import math
import multiprocessing
import os
import re
import signal
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import contextmanager
from types import FrameType
from typing import TYPE_CHECKING, Any

from rigidtop.commands import motions
from rigidtop.commands.output import print_json
from rigidtop.commands.settings import add_settings, whole
from rigidtop.errors import RigidtopError
from rigidtop.parameters import EXAMPLE_SPIN, EXAMPLE_TOP, quantity

if TYPE_CHECKING:
    from rigidtop.motion.sweep import Axis, Map

ABOUT = "map a grid of tops into a file, on one machine or a cluster"

EPILOG = """\
quantities: regime (codes; their names are in FILE.json), nutation_period,
  mean_precession, precession_per_period, theta_min, theta_max; and at a time t:
  theta, phi, psi, theta_dot, phi_dot, psi_dot
names: lambda1, lambda3, M, R, g, theta, theta_dot, phi, phi_dot, psi, t, and
  omega3 or psi_dot; angles and their rates in radians, or degrees with the
  suffix deg

FILE can be read by numpy.load.  Interrupted, the same command goes on from there.

examples:
  rigidtop sweep -o map.npy --axis omega3=0:60:10000 --axis phi_dot=-5:5:10000
  rigidtop sweep -o tilt.npy --quantity theta --axis t=0:9:901 --axis M=1,2
  rigidtop sweep -o map.npy --axis theta=1deg:179deg:2000 \\
    --axis omega3=0:60:2000 --scheduler tcp://host:8786"""

EXAMPLE = {**EXAMPLE_TOP, "theta": motions.THETA.default}
"""What is neither set nor an axis."""

UNITS = dict.fromkeys(("lambda1", "lambda3", "M", "R", "g", "t"), "1") | dict.fromkeys(
    ("theta", "phi", "psi"), "rad"
)
"""What is no rate of an angle."""

CONNECT_SECONDS = 10


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to its parser."""
    parser.add_argument(
        "-o", "--output", metavar="FILE", required=True, help="the file, a .npy for numpy.load"
    )
    parser.add_argument("--quantity", default="regime", metavar="NAME", help="(default: regime)")
    add_settings(
        parser,
        "numbers along an axis of the array, or NAME=A,B,…",
        "--axis",
        type=axis,
        metavar="NAME=START:STOP:COUNT",
    )
    add_settings(
        parser, "a number that is the same everywhere (default: the example top)", type=setting
    )
    where = parser.add_mutually_exclusive_group()
    where.add_argument(
        "--workers",
        type=whole(1),
        metavar="N",
        help="compute in processes (default: in threads, which are enough for a few cores)",
    )
    where.add_argument(
        "--scheduler", metavar="ADDRESS", help="compute on a Dask cluster; wants the extra cluster"
    )
    parser.add_argument(
        "--block", type=whole(1), metavar="POINTS", help="computed at a time (default: 131072)"
    )


def axis(text: str) -> tuple[str, str]:
    """The name and the numbers of an axis, as they are typed.

    >>> axis("phi-dot=-5:5:11")
    ('phi_dot', '-5:5:11')
    """
    name, _, value = (part.strip() for part in text.partition("="))
    if not name or not value:
        raise argparse.ArgumentTypeError(f"{text!r} is not NAME=VALUE")
    name = name.replace("-", "_")
    return motions.OTHER_NAMES.get(name, name), value


setting = axis


def numbers(name: str, text: str) -> Axis:
    """An axis.

    >>> numbers("theta", "0:180deg:3"), numbers("M", "1,2")
    (Span(start=0.0, stop=3.141592653589793, count=3), Listed(values=(1.0, 2.0)))
    """
    from rigidtop.motion.sweep import Listed, Span

    parts = text.split(":")
    if len(parts) == 1:
        return Listed(tuple(one(name, part) for part in text.split(",")))
    if len(parts) != 3 or not parts[2].strip().isdecimal():
        raise RigidtopError(f"--axis {name}={text} is not {name}=START:STOP:COUNT or {name}=A,B,…")
    return Span(one(name, parts[0]), one(name, parts[1]), int(parts[2]))


def one(name: str, text: str) -> float:
    """A number, an angle or its rate, by what it is for.

    >>> round(one("omega3", "180deg"), 6)
    3.141593
    """
    try:
        value = quantity(text, UNITS.get(name, "rad/s"))
    except ValueError as error:
        raise RigidtopError(f"{name} {error}") from None
    return motions.THETA.checked(value) if name == "theta" else value


def run(options: argparse.Namespace) -> int:
    """Compute what is missing in the file, and say what it holds."""
    from rigidtop.motion import sweep
    from rigidtop.terminal.progress import bar

    if not options.output.endswith(".npy"):
        raise RigidtopError(f"--output wants a name that ends in .npy, not {options.output!r}")
    axes = {name: numbers(name, text) for name, text in _once("--axis", options.axis).items()}
    values = {name: one(name, text) for name, text in _once("--set", options.set).items()}
    fixed = {name: value for name, value in EXAMPLE.items() if name not in axes} | values
    if not {"omega3", "psi_dot"} & {*axes, *fixed}:
        fixed["omega3"] = EXAMPLE_SPIN
    asked = sweep.Sweep(options.quantity, axes, fixed)
    size = options.block or sweep.BLOCK
    show = bar("sweeping")
    first: int | None = None
    last = 0

    def progress(done: int, total: int) -> None:
        nonlocal first, last
        first, last = done if first is None else first, done
        show(done, total)
        if interrupted():
            raise KeyboardInterrupt

    start = time.monotonic()
    try:
        with noted_interrupts() as interrupted, executor(options) as (pool, ahead):
            result = sweep.run(
                asked, options.output, pool, block_size=size, ahead=ahead, progress=progress
            )
    except KeyboardInterrupt:
        if not last:
            raise
        raise KeyboardInterrupt(
            f"{last} of {asked.size} points are in {options.output}; "
            "the same command goes on from there"
        ) from None
    record = summary(result) | {
        "computed": last - (first or 0),
        "seconds": round(time.monotonic() - start, 3),
    }
    if result.damaged:
        record["damaged"] = result.damaged
    if options.json:
        print_json(record)
    else:
        print(text(record))
    return 0


def summary(result: Map) -> dict[str, object]:
    """What a map holds, as plain values, read piece by piece."""
    import numpy as np

    from rigidtop.motion.sweep import REGIMES

    record: dict[str, object] = {
        "file": str(result.path),
        "quantity": result.sweep.quantity,
        "axes": list(result.sweep.axes),
        "shape": list(result.sweep.shape),
        "points": result.sweep.size,
    }
    if result.sweep.quantity == "regime":
        counts = sum(np.bincount(piece, minlength=len(REGIMES)) for piece in result.pieces())
        pairs = zip(REGIMES, np.atleast_1d(counts).tolist(), strict=True)
        return record | {"regimes": {name: count for name, count in pairs if count}}
    least, largest = math.inf, -math.inf
    for piece in result.pieces():
        finite = piece[np.isfinite(piece)]
        if finite.size:
            least, largest = min(least, float(finite.min())), max(largest, float(finite.max()))
    valid = least <= largest
    return record | {"least": least if valid else None, "largest": largest if valid else None}


def text(record: dict[str, Any]) -> str:
    """The summary of a sweep, in lines of text."""
    shape = " × ".join(
        f"{n} {name}" for n, name in zip(record["shape"], record["axes"], strict=True)
    )
    lines = [f"{record['file']}: {record['quantity']}, {shape}"]
    if "regimes" in record:
        shares = sorted(record["regimes"].items(), key=lambda item: -item[1])
        lines.append(", ".join(f"{name} {n / record['points']:.3%}" for name, n in shares))
    elif record["least"] is not None:
        lines.append(f"from {record['least']:.6g} to {record['largest']:.6g}, where finite")
    lines.append(f"{record['computed']} points computed in {record['seconds']:.1f} s")
    if "damaged" in record:
        lines.append(
            f"{record['damaged']} of them again: on the disk they were no longer what was written"
        )
    return "\n".join(lines)


@contextmanager
def executor(options: argparse.Namespace) -> Iterator[tuple[Executor | None, int]]:
    """Where to compute, and how many blocks to send ahead; none means threads of this process."""
    from rigidtop.motion.sweep import AHEAD

    if options.scheduler is not None:
        with _cluster(options.scheduler) as client:
            threads = sum(client.nthreads().values())
            yield client.get_executor(), max(AHEAD, 2 * threads)
    elif options.workers:
        # A fresh interpreter each: a fork of a process with threads may hang.
        context = multiprocessing.get_context("spawn")
        with ProcessPoolExecutor(options.workers, context, initializer=follow) as pool:
            yield pool, max(AHEAD, 2 * options.workers)
    else:
        yield None, AHEAD


@contextmanager
def _cluster(address: str) -> Iterator[Any]:
    try:
        from distributed import Client
    except ImportError:
        raise RigidtopError("--scheduler wants Dask: pip install 'rigidtop[cluster]'") from None
    if not re.fullmatch(r"(\w+://)?[^\s:/]+:\d{1,5}", address):
        raise RigidtopError(f"--scheduler wants an address like tcp://host:8786, not {address!r}")
    try:
        client = Client(address, timeout=CONNECT_SECONDS, set_as_default=False)
    except OSError as error:
        raise RigidtopError(f"no Dask scheduler at {address!r}: {error}") from None
    with client:
        yield client


@contextmanager
def noted_interrupts() -> Iterator[Callable[[], bool]]:
    """Whether Ctrl-C was pressed, for the time between two blocks; a second one raises at once.

    Raised anywhere, KeyboardInterrupt may come out of the midst of a lock of `concurrent.futures`,
    which then hangs, or fails with an error of its own.
    """
    pressed = False

    def note(number: int, frame: FrameType | None) -> None:
        nonlocal pressed
        if pressed:
            signal.default_int_handler(number, frame)
        pressed = True

    if threading.current_thread() is not threading.main_thread():
        yield lambda: False  # only the main thread may set handlers, and only it is interrupted
        return
    before = signal.signal(signal.SIGINT, note)
    try:
        yield lambda: pressed
    finally:
        signal.signal(signal.SIGINT, before)


def follow() -> None:
    """End a worker with the process that asked, and leave the interrupts to that."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    if parent is not None:
        threading.Thread(target=_leave_after, args=(parent,), daemon=True).start()


def _leave_after(parent: Any) -> None:
    parent.join()
    os._exit(1)


def _once(option: str, pairs: Sequence[tuple[str, str]]) -> dict[str, str]:
    texts: dict[str, str] = {}
    for name, value in pairs:
        if name in texts:
            raise RigidtopError(f"{option} {name} is given twice")
        texts[name] = value
    return texts
