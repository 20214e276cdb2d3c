"""Make the notebooks from their sources.

    python notebooks/build.py              execute them, write teacher/ and student/
    python notebooks/build.py --check      execute them, and say which of those are not what they
                                           would be (exit code 1)
    python notebooks/build.py 4 5          only those

A source is a Python file with cells after ``# %%``, which jupytext and editors understand.  A cell
tagged ``lecturer`` or ``solution`` is in the teacher's copy only; in the student's one empty cell
stands for a solution.  Behind each is a cell tagged ``check``, a ``%%answer`` with the right
numbers, for which the student's copy has dots.  All solutions stand behind all other code, so the
student's copy is executed too: up to its exercises it is the teacher's.

What is written depends on the source and on what it computes alone: no times, no random names.
"""

from __future__ import annotations

import argparse
import copy
import os
import re
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import jupytext
import nbformat
from jupyter_client.kernelspec import KernelSpec, KernelSpecManager
from jupyter_client.manager import AsyncKernelManager
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError
from nbformat import NotebookNode

HERE = Path(__file__).parent
COPIES = ("teacher", "student")
SOLUTION, CHECK, LECTURER = "solution", "check", "lecturer"
LIMIT = 300
"""Seconds after which a cell is given up."""

WIDGET = "application/vnd.jupyter.widget-view+json"
MARKING = "application/vnd.rigidtop.marking+json"
METADATA = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"file_extension": ".py", "name": "python", "pygments_lexer": "ipython3"},
}
ENVIRONMENT = {
    "PYTHONHASHSEED": "0",
    "PYDEVD_DISABLE_FILE_VALIDATION": "1",
    "OMP_NUM_THREADS": "1",
}


class BuildError(Exception):
    """What is wrong with a source, in one line."""


def sources() -> list[Path]:
    """In the order of the lecture."""
    return sorted(HERE.glob("[0-9]-*.py"))


def read(source: Path) -> NotebookNode:
    """The cells of a source, with names that do not change from one reading to the next."""
    raw = jupytext.read(source, fmt="py:percent")
    cells = []
    for number, cell in enumerate(raw.cells, 1):
        tags = cell.metadata.get("tags", [])
        fresh = {
            "code": nbformat.v4.new_code_cell,
            "markdown": nbformat.v4.new_markdown_cell,
        }[cell.cell_type](cell.source, id=f"cell-{number:02}")
        if tags:
            fresh.metadata["tags"] = tags
        if tagged(fresh, CHECK):  # its lines are no Python, and so are comments in the source
            fresh.source = re.sub("^# ", "", fresh.source, flags=re.M)
        cells.append(fresh)
    notebook = nbformat.v4.new_notebook(cells=cells, metadata=copy.deepcopy(METADATA))
    notebook.nbformat_minor = 5
    _check_order(source.name, cells)
    return notebook


def tagged(cell: NotebookNode, *tags: str) -> bool:
    """Whether a cell has one of these tags."""
    return not {*tags}.isdisjoint(cell.metadata.get("tags", []))


def _check_order(name: str, cells: list[NotebookNode]) -> None:
    """No code of the lecture behind a solution; every exercise has one, and then a check."""
    behind = False
    kinds = "".join(_kind(cell) for cell in cells)
    for number, cell in enumerate(cells):
        behind = behind or tagged(cell, SOLUTION)
        if behind and cell.cell_type == "code" and not tagged(cell, SOLUTION, CHECK):
            raise BuildError(f"{name}, {cell.id}: code that is no solution stands behind one")
        if kinds[number] == "E" and not re.match("S+", kinds[number + 1 :]):
            raise BuildError(f"{name}, {cell.id}: an exercise without a solution")
        if kinds[number] == "E" and not re.match("S+C", kinds[number + 1 :]):
            raise BuildError(f"{name}, {cell.id}: an exercise without a check")


def _kind(cell: NotebookNode) -> str:
    """E for an exercise, S for a part of its solution, C for its check, - for all else."""
    if tagged(cell, SOLUTION, CHECK):
        return "S" if tagged(cell, SOLUTION) else "C"
    return "E" if re.search("^### Exercise", cell.source, flags=re.M) else "-"


class _ThisPython(KernelSpecManager):
    """The kernel is the Python that builds, whatever kernels a user has installed."""

    def get_kernel_spec(self, kernel_name: str) -> Any:
        return KernelSpec(
            argv=[sys.executable, "-m", "ipykernel_launcher", "-f", "{connection_file}"],
            display_name="Python 3",
            language="python",
        )


def execute(name: str, notebook: NotebookNode) -> float:
    """Run all cells of a notebook in place; the seconds that it took, with the kernel's start."""
    began = time.perf_counter()
    with tempfile.TemporaryDirectory() as empty:
        manager = AsyncKernelManager(
            kernel_name="python3",
            kernel_spec_manager=_ThisPython(),
            connection_file=str(Path(empty) / "kernel.json"),
            # Through files where they can carry it, not through the network.
            transport="ipc" if os.name == "posix" else "tcp",
        )
        client = NotebookClient(
            notebook,
            km=manager,
            timeout=LIMIT,
            record_timing=False,
            store_widget_state=False,
            coalesce_streams=True,
        )
        # IPYTHONDIR: no start-up files and no settings of a user.
        environment = {**os.environ, **ENVIRONMENT, "IPYTHONDIR": empty}
        try:
            client.execute(cleanup_kc=True, cwd=str(HERE), env=environment)
        except CellExecutionError as error:
            last = next(c.id for c in reversed(notebook.cells) if c.get("outputs"))
            raise BuildError(f"{name}, {last} fails: {error.ename}: {error.evalue}") from error
    notebook.metadata = nbformat.from_dict(METADATA)
    for cell in notebook.cells:
        if cell.cell_type == "code":
            cell.outputs = [_settled(name, cell, output) for output in cell.outputs]
    return time.perf_counter() - began


def _settled(name: str, cell: NotebookNode, output: NotebookNode) -> NotebookNode:
    """An output without what needs a kernel; BuildError for what should not be there."""
    said = output.get("text", "") + str(output.get("data", {}).get("text/plain", ""))
    if output.get("name") == "stderr":
        raise BuildError(f"{name}, {cell.id} complains: {said.strip()}")
    if re.search(r" at 0x[0-9a-f]+", said):
        raise BuildError(f"{name}, {cell.id} shows an address: {said.strip()}")
    if "data" in output:
        output.data.pop(WIDGET, None)
        output.data.pop(MARKING, None)
        if "<iframe" in output.data.get("text/html", ""):  # the live page, which a kernel makes
            output.data["text/html"] = "<em>Run this cell, and the page plays here.</em>"
    return output


def student(notebook: NotebookNode) -> NotebookNode:
    """A copy with an empty cell in place of each solution, and dots in place of each number."""
    cut = copy.deepcopy(notebook)
    cells: list[NotebookNode] = []
    for cell in cut.cells:
        if tagged(cell, CHECK):
            cell.source = re.sub(r"= *\S+?(?=$|[ °])", "= …", cell.source, flags=re.M)
            cell.outputs, cell.execution_count = [], None
        if tagged(cell, LECTURER):
            continue
        if not tagged(cell, SOLUTION):
            cells.append(cell)
        elif not cells[-1].id.startswith("answer"):
            number = sum(c.id.startswith("answer") for c in cells) + 1
            cells.append(nbformat.v4.new_code_cell("", id=f"answer-{number}"))
    count = 0
    for cell in cells:
        if cell.get("execution_count"):
            count += 1
            _counted(cell, count)
    cut.cells = cells
    return cut


def _counted(cell: NotebookNode, count: int) -> None:
    """Give a cell and what it shows their number."""
    for part in (cell, *cell.outputs):
        if "execution_count" in part:
            part.execution_count = count


def made(source: Path) -> tuple[dict[Path, NotebookNode], float]:
    """Both copies of a source, executed, by where they belong; and the seconds that it took."""
    teacher = read(source)
    seconds = execute(source.name, teacher)
    copies = dict(zip(COPIES, (teacher, student(teacher)), strict=True))
    for notebook in copies.values():
        nbformat.validate(notebook)
    return {HERE / kind / f"{source.stem}.ipynb": copies[kind] for kind in COPIES}, seconds


def written(notebook: NotebookNode) -> str:
    return nbformat.writes(notebook) + "\n"


def differences(fresh: NotebookNode, shipped: NotebookNode) -> list[str]:
    """The cells that differ; of a picture, only whether there is one."""
    if len(fresh.cells) != len(shipped.cells):
        return [f"{len(shipped.cells)} cells instead of {len(fresh.cells)}"]
    return [
        new.id
        for new, old in zip(fresh.cells, shipped.cells, strict=True)
        if _comparable(new) != _comparable(old)
    ]


def _comparable(cell: NotebookNode) -> Any:
    plain = nbformat.from_dict(copy.deepcopy(cell))
    for output in plain.get("outputs", []):
        if "image/png" in output.get("data", {}):
            output.data["image/png"] = "a picture"
    return plain


def check(path: Path, fresh: NotebookNode) -> list[str]:
    """What is amiss with a shipped copy, a line each."""
    name = f"{path.parent.name}/{path.name}"
    if not path.exists():
        return [f"{name} is missing"]
    shipped = nbformat.read(path, as_version=4)
    found = [f"{name}: {cell} is not what its source makes" for cell in differences(fresh, shipped)]
    return found[:3]


def main(arguments: list[str] | None = None) -> int:
    """Build or check; 1 if something is amiss."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("numbers", nargs="*", help="first letters of the sources; all by default")
    parser.add_argument("--check", action="store_true", help="write nothing, compare")
    options = parser.parse_args(arguments)
    wanted = [s for s in sources() if s.name.startswith(tuple(options.numbers or [""]))]
    if not wanted:
        parser.error(f"no source begins with {' or '.join(options.numbers)}")
    amiss = 0
    with ThreadPoolExecutor(2) as pool:
        for source, result in zip(wanted, pool.map(_attempt, wanted), strict=True):
            if isinstance(result, BuildError):
                print(result, file=sys.stderr)
                amiss = 1
                continue
            copies, seconds = result
            print(f"{source.name}: {seconds:.1f} s", flush=True)
            for path, notebook in copies.items():
                if not options.check:
                    path.parent.mkdir(exist_ok=True)
                    path.write_text(written(notebook), "utf-8")
                    continue
                for line in check(path, notebook):
                    print(line, file=sys.stderr)
                    amiss = 1
    return amiss


def _attempt(source: Path) -> tuple[dict[Path, NotebookNode], float] | BuildError:
    try:
        return made(source)
    except BuildError as error:
        return error


if __name__ == "__main__":
    sys.exit(main())
