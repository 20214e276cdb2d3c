"""What every trajectory has in common: it is a table, a row for each of its times."""

from __future__ import annotations

import importlib
from abc import ABC, abstractmethod
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from rigidtop.errors import RigidtopError
from rigidtop.parameters import in_one_line
from rigidtop.terminal.files import write_whole

if TYPE_CHECKING:
    import pandas
    import xarray

Floats = NDArray[np.float64]

FIRST = 8
"""Rows that a notebook shows."""


class Rows(ABC):
    """A table with N rows: it has a length, gives its rows, writes itself for other tools.

    Two are equal where they are of one kind and all their columns are.
    """

    t: Floats
    """Times, shape (N,), in s."""

    @abstractmethod
    def columns(self) -> dict[str, Floats]:
        """The columns, of shape (N,), by name and unit, such as "theta/rad"; the first is "t/s"."""

    def __len__(self) -> int:
        return len(self.t)

    def __iter__(self) -> Iterator[dict[str, float]]:
        """A row after the other: numbers by name."""
        columns = {_name(header): column for header, column in self.columns().items()}
        for row in zip(*columns.values(), strict=True):
            yield dict(zip(columns, map(float, row), strict=True))

    def __getitem__(self, name: str) -> Floats:
        """A column by its name.  Raises RigidtopError for one that there is not."""
        return self.column(name)[1]

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        mine, theirs = self.columns(), other.columns()
        return mine.keys() == theirs.keys() and all(
            np.array_equal(mine[name], theirs[name], equal_nan=True) for name in mine
        )

    __hash__ = None  # type: ignore[assignment]  # its arrays can be changed

    def __repr__(self) -> str:
        names = ", ".join(map(_name, self.columns()))
        span = f"t = {self.t.min():g} … {self.t.max():g} s" if len(self) else "no times"
        return f"<{type(self).__name__}: {len(self)} rows, {span}; {names}>"

    def _repr_html_(self) -> str:
        """The first rows as an HTML table, for notebooks."""
        columns = self.columns()
        head = "".join(f"<th>{header}</th>" for header in columns)
        body = "".join(
            "<tr>" + "".join(f"<td>{float(x):.6g}</td>" for x in row) + "</tr>"
            for row in list(zip(*columns.values(), strict=True))[:FIRST]
        )
        more = f"<p>… {len(self) - FIRST} more rows</p>" if len(self) > FIRST else ""
        return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>{more}"

    def to_csv(self, path: str | Path | None = None) -> str:
        """Comma-separated values with all digits, a header first; into a file too, if one is named.

        Raises RigidtopError where the file can't be written.
        """
        columns = self.columns()
        lines = [",".join(columns)]
        lines += [
            ",".join(map(repr, map(float, row))) for row in zip(*columns.values(), strict=True)
        ]
        text = "\n".join(lines) + "\n"
        if path is not None:
            write_whole(Path(path), text.encode())
        return text

    def to_pandas(self) -> pandas.DataFrame:
        """A `pandas.DataFrame` with t as its index; units stand in ``.attrs["units"]``."""
        pandas = _loaded("pandas")
        columns = self.columns()
        frame = pandas.DataFrame({_name(header): column for header, column in columns.items()})
        frame.attrs["units"] = {_name(header): _unit(header) for header in columns}
        return frame.set_index("t")

    def to_xarray(self) -> xarray.Dataset:
        """An `xarray.Dataset` over the dimension t; each variable has its unit as ``.units``."""
        xarray = _loaded("xarray")
        variables = {
            _name(header): ("t", column, {"units": _unit(header)})
            for header, column in self.columns().items()
        }
        time = variables.pop("t")
        return xarray.Dataset(variables, coords={"t": time})

    def plot(self, *names: str | tuple[str, str], axes: Any = None) -> Any:
        """Columns over the time, or one over another where two names stand in a tuple.

        Without names all angles, or all coordinates, are drawn.  On the `axes` of Matplotlib that
        are given, or on new ones of a figure of their own, which are returned.

        Raises RigidtopError for a name that is none of the columns.
        """
        from rigidtop.figures.curves import drawn

        pairs = [name if isinstance(name, tuple) else ("t", name) for name in names or self.plotted]
        for pair in pairs:
            if len(pair) != 2:
                raise RigidtopError(f"two columns make a curve, not {len(pair)}")
        curves = [(self.column(across), self.column(up)) for across, up in pairs]
        return drawn(curves, axes, dots=self.dots)

    dots: ClassVar[bool] = False
    """Whether rows are drawn as dots, not as a curve."""

    @property
    def plotted(self) -> tuple[str | tuple[str, str], ...]:
        """What `plot` draws without being told."""
        return tuple(_name(header) for header in self.columns())[1:4]

    def column(self, name: str) -> tuple[str, Floats]:
        """A column with its header.  Raises RigidtopError for a name that is none."""
        columns = self.columns()
        for header, values in columns.items():
            if str(name) in (header, _name(header)):
                return header, values
        there = ", ".join(map(_name, columns))
        raise RigidtopError(f"no column {in_one_line(name)}: there are {there}")


def _name(header: str) -> str:
    return header.partition("/")[0]


def _unit(header: str) -> str:
    return header.partition("/")[2].strip("()") or "1"


def _loaded(module: str) -> ModuleType:
    try:
        return importlib.import_module(module)
    except ImportError:
        raise RigidtopError(f"{module} is not installed: pip install {module}") from None
