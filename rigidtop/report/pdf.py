"""A PDF of the lecture: by latexmk where there is one, else by Typst (extra ``pdf``).

Typst's is tagged, for screen readers.  LaTeX's has an outline and metadata and is not tagged: that
needs a TeX Live newer than those that we know.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from importlib.util import find_spec
from pathlib import Path

from rigidtop.errors import RigidtopError
from rigidtop.terminal.progress import ticking

SECONDS = 180.0
"""How long latexmk may take."""

EVERY = 0.2
"""How often it is asked whether it is ready (s)."""

NEITHER = (
    "no PDF: neither latexmk is on the PATH, nor are typst and tylax installed "
    "(pip install 'rigidtop[pdf]')"
)


def make_pdf(
    tex: Callable[[], str], typst: Callable[[], str], figures: Mapping[str, bytes]
) -> bytes:
    """The PDF of the document by the first way there is.

    `tex` and `typst` give the sources; `figures` are the files they include, by relative path.
    """
    latexmk = shutil.which("latexmk")
    if latexmk:
        return by_latexmk(latexmk, tex(), figures)
    if find_spec("typst") and find_spec("tylax"):
        return by_typst(typst(), figures)
    raise RigidtopError(NEITHER)


def _lay_out(folder: Path, figures: Mapping[str, bytes]) -> None:
    for name, content in figures.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def by_latexmk(latexmk: str, source: str, figures: Mapping[str, bytes]) -> bytes:
    """Run latexmk in a folder of its own, without shell escape and within `SECONDS`."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        _lay_out(folder, figures)
        (folder / "lecture.tex").write_text(source, encoding="utf-8")
        command = [
            latexmk,
            "-norc",
            "-pdf",
            "-pdflatex=pdflatex -no-shell-escape %O %S",
            "-interaction=nonstopmode",
            "-halt-on-error",
            "lecture.tex",
        ]
        # The same source gives the same file: no dates, paths only inside the folder.
        environment = {
            **os.environ,
            "SOURCE_DATE_EPOCH": "0",
            "FORCE_SOURCE_DATE": "1",
            "openin_any": "p",
            "openout_any": "p",
        }
        code = _run(command, folder, environment)
        made = folder / "lecture.pdf"
        if code or not made.exists():
            raise RigidtopError(f"no PDF: latexmk failed: {_first_error(folder / 'lecture.log')}")
        return made.read_bytes()


def _run(command: Sequence[str], folder: Path, environment: Mapping[str, str]) -> int:
    """The exit code of latexmk; meanwhile the seconds are shown."""
    show, start, nothing = ticking("typesetting"), time.monotonic(), subprocess.DEVNULL
    try:
        with subprocess.Popen(
            command, cwd=folder, env=environment, stdin=nothing, stdout=nothing, stderr=nothing
        ) as running:
            while True:
                try:
                    return running.wait(EVERY)
                except subprocess.TimeoutExpired:
                    seconds = time.monotonic() - start
                    show(seconds)
                    if seconds > SECONDS:
                        running.kill()
                        raise RigidtopError(
                            f"no PDF: latexmk took more than {SECONDS:.0f} s"
                        ) from None
                except BaseException:
                    running.kill()
                    raise
    except OSError as error:
        raise RigidtopError(f"no PDF: cannot run latexmk: {error.strerror}") from None
    finally:
        show(-1)


def _first_error(log: Path) -> str:
    """The first error of a log in one line."""
    if not log.exists():
        return "it left no log"
    lines = log.read_text(encoding="utf-8", errors="replace").splitlines()
    for i, line in enumerate(lines):
        if line.startswith("!"):
            where = next((follow for follow in lines[i:] if follow.startswith("l.")), "")
            return " ".join(f"{line[1:].strip()} {where}".split())
    return "its log names no error"


def by_typst(source: str, figures: Mapping[str, bytes]) -> bytes:
    """Compile with the fonts that the typst package brings along; nothing is fetched."""
    import typst

    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        _lay_out(folder, figures)
        (folder / "lecture.typ").write_text(source, encoding="utf-8")
        try:
            made = typst.compile(
                str(folder / "lecture.typ"), root=str(folder), ignore_system_fonts=True
            )
        except (RuntimeError, typst.TypstError) as error:
            message = " ".join(str(error).split())
            raise RigidtopError(f"no PDF: typst failed: {message}") from None
    return bytes(made)
