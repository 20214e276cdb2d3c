"""A quantity of the heavy top on a grid of parameters and initial states, of any size.

The grid is cut into blocks that a `concurrent.futures.Executor` computes: threads, processes, a
Dask cluster's `client.get_executor()`, an `mpi4py.futures.MPIPoolExecutor`.  What is finished goes
into a file (see `store`), and a sweep that ended before its end goes on from there.  In memory are
the blocks on their way alone, never the grid.
"""

from __future__ import annotations

import itertools
import math
import os
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import FIRST_COMPLETED, Executor, Future, ThreadPoolExecutor, wait
from contextlib import nullcontext
from dataclasses import asdict, dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from rigidtop.errors import RigidtopError
from rigidtop.motion import checks, store
from rigidtop.motion.attitude import Floats
from rigidtop.motion.exact import heavy_orbit
from rigidtop.motion.integrate import Progress
from rigidtop.motion.many import CHUNK, TopMotions, top_motions

BLOCK = 1 << 17
"""Points a block: a tenth of a second of work or more, beside which sending it takes no time."""

AHEAD = 64
"""Blocks on their way at a time: some for each worker, and together not much memory."""

REGIMES = ("not computed", *heavy_orbit.REGIMES)
"""Names of regimes by code; 0 is what a file holds that is not complete."""

OF_MOTION = (
    "regime",
    "nutation_period",
    "mean_precession",
    "precession_per_period",
    "theta_min",
    "theta_max",
)
"""Quantities of a whole motion (s, rad/s, rad)."""

OF_STATE = ("theta", "phi", "psi", "theta_dot", "phi_dot", "psi_dot")
"""Quantities at the time t (rad, rad/s)."""

REQUIRED = ("lambda1", "lambda3", "M", "R", "theta")
OPTIONAL = {"g": 9.81, "theta_dot": 0.0, "phi": 0.0, "phi_dot": 0.0, "psi": 0.0}
SPINS = ("omega3", "psi_dot")
NAMES = (*REQUIRED, *OPTIONAL, *SPINS, "t")
"""What an axis or a fixed number may be: the arguments of `top_motions`, and the time t (s)."""


@dataclass(frozen=True)
class Span:
    """`count` numbers from `start` to `stop`, both included, evenly spaced: `numpy.linspace`."""

    start: float
    stop: float
    count: int

    def __post_init__(self) -> None:
        checks.settle(self, checks.number, "start", "stop")
        object.__setattr__(self, "count", checks.whole("count", self.count, 2))

    def at(self, index: NDArray[np.intp]) -> Floats:
        """The numbers at these places of the axis."""
        step = (self.stop - self.start) / (self.count - 1)
        return np.where(index == self.count - 1, self.stop, index * step + self.start)

    @property
    def ends(self) -> tuple[float, float]:
        """The smallest and the largest, in either order."""
        return self.start, self.stop


@dataclass(frozen=True)
class Listed:
    """An axis of numbers that are given one by one."""

    values: tuple[float, ...]

    def __post_init__(self) -> None:
        values = tuple(checks.number("a value", value) for value in self.values)
        if not values:
            raise RigidtopError("an axis wants at least one value")
        object.__setattr__(self, "values", values)

    @property
    def count(self) -> int:
        """How many numbers the axis has."""
        return len(self.values)

    def at(self, index: NDArray[np.intp]) -> Floats:
        """The numbers at these places of the axis."""
        return np.array(self.values)[index]

    @property
    def ends(self) -> tuple[float, float]:
        """The smallest number and the largest."""
        return min(self.values), max(self.values)


Axis = Span | Listed


@dataclass(frozen=True)
class Sweep:
    """What to compute: one of `OF_MOTION` or `OF_STATE` at each point of a grid of tops.

    `axes`, the last of which varies fastest, and `fixed` numbers have the names and units of
    the arguments of `top_motions`; what is in neither is 0, and g is 9.81 m/s².  A quantity at a
    time wants t (s) too.  Raises RigidtopError for what has no motion anywhere on the grid, too.

    >>> axes = {"omega3": Span(0, 40, 3), "phi_dot": Listed((0, 5))}
    >>> top = {"lambda1": 1, "lambda3": 0.5, "M": 1, "R": 0.5, "theta": 0.5}
    >>> sweep = Sweep("regime", axes, top)
    >>> sweep.shape, [REGIMES[code] for code in block(sweep, 0, 4)]
    ((3, 2), ['plane', 'waves', 'cusps', 'loops'])
    """

    quantity: str
    axes: Mapping[str, Axis]
    fixed: Mapping[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if self.quantity not in OF_MOTION + OF_STATE:
            names = ", ".join(OF_MOTION + OF_STATE)
            raise RigidtopError(f"no quantity {self.quantity!r}: there are {names}")
        if not self.axes:
            raise RigidtopError("a sweep wants an axis at least")
        for name in (*self.axes, *self.fixed):
            if name not in NAMES:
                raise RigidtopError(f"a top has no {name!r}: there are {', '.join(NAMES)}")
            if name in self.axes and name in self.fixed:
                raise RigidtopError(f"{name} is both fixed and an axis: give it once")
        fixed = {name: checks.number(name, value) for name, value in self.fixed.items()}
        fixed = {**{n: v for n, v in OPTIONAL.items() if n not in self.axes}, **fixed}
        parameters = {*fixed, *self.axes}
        for name in REQUIRED:
            if name not in parameters:
                raise RigidtopError(f"a sweep wants {name}, fixed or as an axis")
        if ("t" in parameters) != (self.quantity in OF_STATE):
            raise RigidtopError(
                f"{self.quantity} has no time: leave t out"
                if "t" in parameters
                else f"{self.quantity} is wanted at a time: give t (s), fixed or as an axis"
            )
        object.__setattr__(self, "axes", dict(self.axes))
        object.__setattr__(self, "fixed", fixed)
        # Each condition on a top is one on how large or small its numbers are: if the corners of
        # the grid meet it, every point does, and no block fails after hours.
        corners = np.array(list(itertools.product(*(axis.ends for axis in self.axes.values()))))
        _motions(self, dict(zip(self.axes, corners.T, strict=True)))

    @property
    def shape(self) -> tuple[int, ...]:
        """The number of points along each axis."""
        return tuple(axis.count for axis in self.axes.values())

    @property
    def size(self) -> int:
        """The number of points in all."""
        return math.prod(self.shape)

    @property
    def dtype(self) -> np.dtype[np.generic]:
        """The type of the values: codes of regimes in `REGIMES`, or floats."""
        return np.dtype(np.uint8 if self.quantity == "regime" else np.float64)

    @property
    def about(self) -> Mapping[str, object]:
        """The sweep as plain values, for JSON."""
        axes = {name: asdict(axis) for name, axis in self.axes.items()}
        for axis in axes.values():
            axis.update({name: list(value) for name, value in axis.items() if name == "values"})
        about = {"quantity": self.quantity, "axes": axes, "fixed": dict(self.fixed)}
        return about | ({"names": list(REGIMES)} if self.quantity == "regime" else {})


@dataclass(frozen=True, eq=False)
class Map:
    """A sweep that is complete, made by `run` and `load`."""

    sweep: Sweep
    path: Path

    damaged: int = 0
    """Points of an earlier run that were no longer what it wrote, and were computed again."""

    @property
    def axes(self) -> dict[str, Floats]:
        """The numbers along each axis, by its name."""
        return {n: axis.at(np.arange(axis.count)) for n, axis in self.sweep.axes.items()}

    @property
    def values(self) -> NDArray[np.generic]:
        """The values in the sweep's shape, read from the file when used; regimes are codes."""
        with store.readable_errors(self.path):
            try:
                values: NDArray[np.generic] = np.load(self.path, mmap_mode="r")
            except ValueError as error:
                raise RigidtopError(f"cannot read {self.path}: {error}") from error
        return values

    def pieces(self, size: int = BLOCK) -> Iterator[NDArray[np.generic]]:
        """The same, flattened, so many at a time: for maps that are larger than the memory."""
        with store.readable_errors(self.path), self.path.open("rb") as file:
            file.seek(store.data_offset(self.path, self.sweep.dtype, self.sweep.shape))
            for first in range(0, self.sweep.size, size):
                count = min(size, self.sweep.size - first)
                yield np.frombuffer(file.read(count * self.sweep.dtype.itemsize), self.sweep.dtype)


def block(sweep: Sweep, start: int, stop: int) -> NDArray[np.generic]:
    """The values at the points `start` to `stop` of the flattened grid.

    Where blocks are cut may change the last digit.
    """
    values = np.empty(stop - start, sweep.dtype)
    # Chunks of the size that `many` works in, so that each is one thread's: how many run beside
    # each other is for the executor to say.
    for first in range(start, stop, CHUNK):
        index = np.arange(first, min(first + CHUNK, stop))
        places = np.unravel_index(index, sweep.shape)
        coordinates = {
            name: axis.at(place)
            for (name, axis), place in zip(sweep.axes.items(), places, strict=True)
        }
        motions = _motions(sweep, coordinates)
        t = coordinates.get("t", sweep.fixed.get("t", 0.0))
        values[index - start] = _quantity(sweep.quantity, motions, t)
    return values


def _motions(sweep: Sweep, coordinates: Mapping[str, Floats]) -> TopMotions:
    arguments = {**sweep.fixed, **coordinates}
    arguments.pop("t", None)
    return top_motions(**arguments)  # type: ignore[arg-type]


def _quantity(name: str, motions: TopMotions, t: Floats | float) -> NDArray[np.generic]:
    if name == "regime":
        regimes = motions.regime
        codes = np.zeros(regimes.shape, np.uint8)
        for code, regime in enumerate(REGIMES):
            codes[regimes == regime] = code
        return codes
    if name in ("theta_min", "theta_max"):
        return motions.turning_points[name == "theta_max"]
    values: Floats = getattr(motions.exact(t) if name in OF_STATE else motions, name)
    return values


def run(
    sweep: Sweep,
    path: Path | str,
    executor: Executor | None = None,
    *,
    block_size: int = BLOCK,
    ahead: int = AHEAD,
    progress: Progress | None = None,
) -> Map:
    """Compute the sweep into the file `path`, from where an earlier run left it.

    Without an executor, threads of this process compute.  `ahead` blocks of `block_size` points
    are on their way at a time; give twice as many as there are workers, or more.  `progress` is
    called with the number of points that are done, and of all.  What an earlier run left is held
    against its checksums: blocks that were damaged since are computed again, see `Map.damaged`.

    Raises RigidtopError for a file that holds something else; and for what an executor raises, as
    when its workers are gone: then, and after an interrupt, the same call goes on.

    >>> from tempfile import TemporaryDirectory
    >>> top = {"lambda1": 1, "lambda3": 0.5, "M": 1, "R": 0.5, "theta": 0.5}
    >>> sweep = Sweep("theta_max", {"omega3": Span(20, 40, 3)}, top)
    >>> with TemporaryDirectory() as folder:
    ...     run(sweep, f"{folder}/map.npy").values.round(6)
    array([0.553991, 0.522175, 0.51215 ])
    """
    for name, number in (("block_size", block_size), ("ahead", ahead)):
        checks.whole(name, number, 1)
    path = store.place(path)
    with store.open_store(path, sweep.about, sweep.dtype, sweep.shape) as file:
        if progress is not None:
            progress(file.done, file.total)
        if not file.missing:
            return Map(sweep, path)
        # An executor that is given stays its giver's to shut down.
        with nullcontext(executor) if executor else ThreadPoolExecutor(os.cpu_count()) as pool:
            _fill(sweep, file, pool.submit, block_size, ahead, progress)
    return Map(sweep, path, file.damaged)


def load(path: Path | str) -> Map:
    """The map that `run` wrote; raises RigidtopError where there is none, or not all of it.

    All of it is read once, and held against its checksums.
    """
    path = store.place(path)
    with store.readable_errors(path):
        about = store.read_about(path)
    if about is None or not path.is_file():
        raise RigidtopError(f"no sweep wrote {path}: it is not there with its .json beside it")
    if not about.get("complete"):
        raise RigidtopError(f"{path} is not complete: run its sweep again, which goes on")
    try:
        axes = {
            name: Listed(tuple(axis["values"])) if "values" in axis else Span(**axis)
            for name, axis in about["axes"].items()
        }
        sweep = Sweep(about["quantity"], axes, about["fixed"])
    except (KeyError, TypeError, AttributeError):
        raise RigidtopError(f"{store.about_path(path)} is not what a sweep wrote") from None
    with store.readable_errors(path):
        damaged = store.gaps(store.sound(path, sweep.dtype, sweep.shape), sweep.size)
    if damaged:
        raise RigidtopError(
            f"{path} is no longer what was written: run its sweep again, which mends it"
        )
    return Map(sweep, path)


def _blocks(missing: list[store.Interval], size: int) -> Iterator[store.Interval]:
    for start, stop in missing:
        for first in range(start, stop, size):
            yield first, min(first + size, stop)


def _fill(
    sweep: Sweep,
    file: store.Store,
    submit: Callable[..., Future[NDArray[np.generic]]],
    block_size: int,
    ahead: int,
    progress: Progress | None,
) -> None:
    blocks = _blocks(file.missing, block_size)
    pending: dict[Future[NDArray[np.generic]], store.Interval] = {}
    failed: list[Exception] = []
    try:
        while True:
            try:
                for start, stop in itertools.islice(blocks, ahead - len(pending)):
                    pending[submit(block, sweep, start, stop)] = (start, stop)
            except Exception as error:  # an executor that takes no more work
                failed.append(error)
            if not (pending or failed):
                return
            # What else has been computed by the time of a failure is kept.
            for future in wait(pending, 0 if failed else None, FIRST_COMPLETED).done:
                start, stop = pending.pop(future)
                try:
                    values = future.result()
                except Exception as error:  # an executor may raise anything
                    failed.append(error)
                    continue
                _check(values, sweep, stop - start)
                file.write(start, values)
                if progress is not None:
                    progress(file.done, file.total)
            if failed:
                raise _failure(failed[0], file)
    finally:
        for future in pending:
            future.cancel()


def _check(values: NDArray[np.generic], sweep: Sweep, count: int) -> None:
    """A worker with another version of this package must not write over other blocks."""
    if values.shape != (count,) or values.dtype != sweep.dtype:
        raise RigidtopError(
            f"a worker returned {values.shape} {values.dtype}, not ({count},) {sweep.dtype}: "
            "is its rigidtop the same as here?"
        )


def _failure(error: Exception, file: store.Store) -> RigidtopError:
    if isinstance(error, RigidtopError):
        return error
    reason = " ".join(f"{type(error).__name__}: {error}".split()).rstrip(": .")
    failure = RigidtopError(
        f"the executor failed ({reason}); {file.done} of {file.total} points are in {file.path}, "
        "and the same call goes on from there"
    )
    failure.__cause__ = error
    return failure
