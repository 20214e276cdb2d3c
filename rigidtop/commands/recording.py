"""What apps of phones record: tables as CSV, with columns by many names."""

from __future__ import annotations

import csv
import math
import re
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING

from rigidtop.errors import RigidtopError
from rigidtop.parameters import in_one_line
from rigidtop.terminal.files import text_of

if TYPE_CHECKING:
    from rigidtop.motion.attitude import Floats

MOST_ROWS = 10_000
"""What is longer is no flight, and would take minutes."""

CLOCKS = ("seconds_elapsed", "time", "t")
"""Names of the time, the first that is there."""

TURNING = ("gyro", "omega", "rotation", "angular")
"""How the name of a rotational velocity begins; columns that are axes alone are one too."""

AXES = {"x": 0, "y": 1, "z": 2, "1": 0, "2": 1, "3": 2}

SCALES = {"deg": math.pi / 180, "°": math.pi / 180, "ms": 1e-3, "ns": 1e-9}
"""How units begin that are not those of SI."""


@dataclass(frozen=True, eq=False)
class Recording:
    """Times and what was measured then, in SI units: the arguments of `rigidtop.fit`."""

    t: Floats
    columns: dict[str, Floats]
    """`omega` (N, 3), or `theta`, `phi` and perhaps `psi` (N,)."""


def recording(path: str, since: float, until: float) -> Recording:
    """The rows of a file from one time to another; RigidtopError with what it lacks, or its line.

    Columns are parted by tabs, semicolons or commas, and decimals by points, or by commas where
    these part no columns.  Lines that begin with # are left out.
    """
    lines = [
        (number, line)
        for number, line in enumerate(text_of(path).splitlines(), 1)
        if line.strip() and not line.startswith("#")
    ]
    if len(lines) < 2:
        raise RigidtopError(f"{path} has no rows")
    separator = max("\t;,", key=lines[0][1].count)
    try:
        head, *cells = csv.reader((line for _, line in lines), delimiter=separator, strict=True)
    except csv.Error as error:
        raise RigidtopError(f"{path} is no table: {error}") from None
    places, scales = _named(path, head)
    rows = [
        _numbers(f"{path}, line {number}", row, places, separator == ",")
        for (number, _), row in zip(lines[1:], cells, strict=False)
    ]
    return _arranged(path, [*places], rows, scales, since, until)


def _named(path: str, head: list[str]) -> tuple[dict[str, int], list[float]]:
    """Where the columns are that count, by our names, and what their unit is in SI."""
    names: dict[str, int] = {}
    units = []
    for place, header in enumerate(head):
        name, *unit = re.split(r"[(\[/]+", header.lower(), maxsplit=1)  # a unit stands behind one
        units.append(
            next((x for begin, x in SCALES.items() if "".join(unit).startswith(begin)), 1.0)
        )
        names.setdefault(_own(name.strip()), place)
    clock = next((name for name in CLOCKS if name in names), None)
    columns = [f"omega{k}" for k in range(3)]
    if not all(name in names for name in columns):
        columns = [name for name in ("theta", "phi", "psi") if name in names]
    if clock is None or len(columns) < 2:
        raise RigidtopError(
            f"{path} needs columns for the time and for x, y, z of a gyroscope, such as "
            '"Time (s)" and "Gyroscope x (rad/s)", or for theta and phi of a top; it has '
            f"{in_one_line(head)}"
        )
    places = {name: names[name] for name in (clock, *columns)}
    return places, [units[place] for place in places.values()]


def _own(name: str) -> str:
    """The name that rigidtop has for a column of a recording."""
    words = re.findall(r"[a-z]+|\d+", name)
    bare = len(words) == 1 and words[0] in "xyz"
    if words and words[-1] in AXES and (bare or words[0].startswith(TURNING)):
        return f"omega{AXES[words[-1]]}"
    return name


def _numbers(place: str, row: list[str], places: dict[str, int], points: bool) -> list[float]:
    if len(row) <= max(places.values()):
        raise RigidtopError(f"{place} has {len(row)} cells, too few")
    numbers = []
    for name, column in places.items():
        cell = row[column].strip()
        try:
            numbers.append(float(cell if points else cell.replace(",", ".")))
        except ValueError:
            raise RigidtopError(f"{place}: {in_one_line(cell)} under {name} is no number") from None
    return numbers


def _arranged(
    path: str,
    names: list[str],
    rows: list[list[float]],
    scales: list[float],
    since: float,
    until: float,
) -> Recording:
    import numpy as np

    values = np.array(rows) * scales
    within = values[(values[:, 0] >= since) & (values[:, 0] <= until)]
    if not len(within):
        times = f"{values[:, 0].min():g} to {values[:, 0].max():g} s"
        raise RigidtopError(f"{path} has no rows between those times: it goes from {times}")
    if len(within) > MOST_ROWS:
        raise RigidtopError(
            f"{len(within)} rows are too many for a flight: say where it is with --from and --to"
        )
    for before, after in pairwise(within[:, 0]):
        if after <= before:
            raise RigidtopError(f"{path}: the time goes from {before:g} to {after:g} s, not on")
    t, *measured = within.T
    if names[1].startswith("omega"):
        return Recording(t, {"omega": np.stack(measured, axis=-1)})
    return Recording(t, dict(zip(names[1:], measured, strict=True)))
