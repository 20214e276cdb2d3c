"""Ways of doing the same, measured in rounds that take turns, and shown side by side."""

from __future__ import annotations

import math
import statistics
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import groupby
from time import perf_counter
from typing import Any

Progress = Callable[[int, int], None]

ROUNDS = 5
SHORTEST = 0.05
"""A round repeats what is shorter than this (s)."""


@dataclass(frozen=True)
class Way:
    """One way of doing something: `go` returns what was computed, and is None without a package."""

    name: str
    go: Callable[[], object] | None
    error: Callable[[Any], float] | None = None
    note: str = ""
    rounds: int = ROUNDS
    of_all: float = 1.0
    """The part of the task that `go` does; its time is divided by it."""


def missing(name: str, package: str) -> Way:
    """A way that needs a package which is not there."""
    return Way(name, None, note=f"{package} is not installed")


@dataclass(frozen=True)
class Task:
    """Something that can be done in several ways."""

    name: str
    ways: Callable[[], Sequence[Way]]
    per: int = 1
    """How many samples or tops that is."""
    kind: str = ""
    """Of motion, in a task that has many: its last way is that which the others are held against,
    else the first."""


@dataclass(frozen=True)
class Row:
    """How long one way took."""

    task: str
    way: str
    seconds: float | None
    """Median of one go; None where a package is missing, which `note` says."""
    per: int = 1
    error: float | None = None
    """The largest error of θ, φ, ψ at the end, or of the attitude, rad."""
    note: str = ""
    kind: str = ""


def seconds(go: Callable[[], object]) -> float:
    """Of one go; if it is short, the median of several."""
    begin, taken = perf_counter(), list[float]()
    while not taken or perf_counter() - begin < SHORTEST:
        before = perf_counter()
        go()
        taken.append(perf_counter() - before)
    return statistics.median(taken)


def rows_of(
    task: Task, rounds: int, clock: Callable[[Callable[[], object]], float] = seconds
) -> list[Row]:
    """A row for each of its ways."""
    ways = task.ways()
    taken: list[list[float]] = [[] for _ in ways]
    # The first go pays for imports and compilation.
    results = [way.go() if way.go else None for way in ways]
    errors = [
        way.error(result) if way.error and way.go else None
        for way, result in zip(ways, results, strict=True)
    ]
    for k in range(rounds):
        for way, times in zip(ways, taken, strict=True):
            if way.go and k < way.rounds:
                times.append(clock(way.go) / way.of_all)
    return [
        Row(task.name, way.name, statistics.median(times) if times else None, task.per, *rest)
        for way, times, error in zip(ways, taken, errors, strict=True)
        for rest in [(error, way.note, task.kind)]
    ]


def measured(tasks: Sequence[Task], rounds: int, progress: Progress | None = None) -> list[Row]:
    """Every task; `progress` is called with the number of those done, and of all."""
    rows: list[Row] = []
    for done, task in enumerate(tasks, 1):
        rows += rows_of(task, rounds)
        if progress is not None:
            progress(done, len(tasks))
    return rows


# --- Side by side ---------------------------------------------------------------------------------


def _groups(rows: Iterable[Row]) -> list[tuple[str, list[list[Row]]]]:
    """Tasks with the rows of each kind, the worst kind first: whose first way is the slowest."""
    found = []
    for task, of_task in groupby(rows, lambda row: row.task):
        kinds = [list(ways) for _, ways in groupby(of_task, lambda row: row.kind)]
        found.append((task, sorted(kinds, key=lambda ways: -(_shares(ways)[0] or 0))))
    return found


def _shares(ways: Sequence[Row]) -> list[float | None]:
    """The times over that of the last way for a kind of motion, else over that of the first."""
    unit = ways[-1 if ways[0].kind else 0].seconds or math.nan
    return [None if way.seconds is None else way.seconds / unit for way in ways]


def table(rows: Sequence[Row]) -> str:
    """Each task: seconds, per item, ratio, error at the end; of kinds of motions a line each."""
    blocks = []
    for task, kinds in _groups(rows):
        first = kinds[0]
        if first[0].kind:
            names = [row.way for row in first]
            head = f"{task}: {', '.join(names)}; over {names[-1]}"
            blocks.append("\n".join([head, *map(_of_kind, kinds)]))
        else:
            ways = zip(first, _shares(first), strict=True)
            blocks.append("\n".join([task, *(_of_way(row, share) for row, share in ways)]))
    return "\n\n".join(blocks)


def _of_way(row: Row, share: float | None) -> str:
    if row.seconds is None or share is None:
        return f"  {row.way:29}{row.note}"
    cells = [
        f"{_time(row.seconds):>10}",
        f"{_time(row.seconds / row.per):>10} each" if row.per > 1 else " " * 15,
        f"{_digits(share):>9} ×",
        f"  error {row.error:.0e} rad" if row.error is not None else "",
        f"  ({row.note})" if row.note else "",
    ]
    return f"  {row.way:29}" + "".join(cells).rstrip()


def _of_kind(ways: Sequence[Row]) -> str:
    times = [_time(row.seconds) if row.seconds is not None else "–" for row in ways]
    shares = [f"{share:.2f} ×" if share else "–" for share in _shares(ways)[:-1]]
    errors = ", ".join(f"{row.error:.0e}" for row in ways if row.error is not None)
    cells = [*(f"{cell:>10}" for cell in times), *(f"{cell:>9}" for cell in shares)]
    return f"  {ways[0].kind:22}" + "".join(cells) + f"  errors {errors} rad"


def markdown(rows: Sequence[Row]) -> str:
    """Every kind of motion: a line of ratios, columns of each task, the worst first."""
    tasks = [(task, kinds) for task, kinds in _groups(rows) if kinds[0][0].kind]
    if not tasks:
        return ""
    lines: dict[str, list[str]] = {}
    head = ["time over that of " + tasks[0][1][0][-1].way]
    for task, kinds in tasks:
        head += [f"{task}, {row.way}" for row in kinds[0][:-1]]
        for ways in kinds:
            shares = [f"{share:.2f} ×" if share else "–" for share in _shares(ways)[:-1]]
            lines.setdefault(ways[0].kind, []).extend(shares)
    for ways in tasks[-1][1]:
        errors = (f"{row.error:.0e}" if row.error is not None else "–" for row in ways)
        lines[ways[0].kind].append(", ".join(errors))
    cells = [[*head, "errors (rad)"], ["---"] * (len(head) + 1)]
    cells += [[kind, *line] for kind, line in lines.items()]
    return "\n".join(f"| {' | '.join(line)} |" for line in cells)


def _time(seconds: float) -> str:
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            return f"{_digits(seconds / size)} {unit}"
    return f"{seconds * 1e9:.3g} ns"


def _digits(value: float) -> str:
    """Three digits, and no power of ten.

    >>> _digits(0.4321), _digits(15734.2)
    ('0.432', '15,734')
    """
    return f"{value:.3g}" if value < 1000 else f"{value:,.0f}"
