"""A PDF of the lecture: by latexmk where there is one, else by Typst (extra ``pdf``).

Typst's is tagged, for screen readers.  LaTeX's has an outline and metadata and is not tagged: that
needs a TeX Live newer than those that we know.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from importlib.util import find_spec
from pathlib import Path

from rigidtop.errors import RigidtopError
from rigidtop.report.blocks import Look
from rigidtop.terminal.progress import ticking

SECONDS = 180.0
"""How long latexmk may take."""

EVERY = 0.2
"""How often it is asked whether it is ready (s)."""

PLAIN = Look()

DAY = 86_400
"""Seconds of a day."""

OWN = (
    "no PDF: a preamble and a class of one's own are for LaTeX, and no latexmk is on the PATH; "
    "without --pdf they stand in the .tex"
)

NEITHER = (
    "no PDF: neither latexmk is on the PATH, nor are typst and tylax installed "
    "(pip install 'rigidtop[pdf]')"
)


class LatexError(RigidtopError):
    """LaTeX found an error; `log` is what it says itself."""

    def __init__(self, words: str, log: str = "") -> None:
        super().__init__(words)
        self.log = log


def latexmk_for(look: Look) -> str:
    """The path of latexmk, empty where Typst is there instead and does for this `look`.

    Raises RigidtopError where there is no way to a PDF.
    """
    latexmk = shutil.which("latexmk")
    if not latexmk and (look.preamble or look.documentclass):
        raise RigidtopError(OWN)
    if not latexmk and not (find_spec("typst") and find_spec("tylax")):
        raise RigidtopError(NEITHER)
    return latexmk or ""


def make_pdf(
    tex: Callable[[], str],
    typst: Callable[[], str],
    figures: Mapping[str, bytes],
    look: Look = PLAIN,
) -> bytes:
    """The PDF of the document by the first way there is.

    `tex` and `typst` give the sources; `figures` are the files they include, by relative path.
    """
    latexmk = latexmk_for(look)
    return by_latexmk(latexmk, tex(), figures) if latexmk else by_typst(typst(), figures)


def written_at() -> int:
    """When a PDF says that it was made, in seconds since 1970: SOURCE_DATE_EPOCH, or else today.

    So it is the same file all day.
    """
    epoch = os.environ.get("SOURCE_DATE_EPOCH", "")
    if epoch and not (epoch.isascii() and epoch.isdigit()):
        raise RigidtopError(f"SOURCE_DATE_EPOCH wants seconds since 1970, not {epoch!r}")
    now = time.time()
    return int(epoch) if epoch else int(now - now % DAY)


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
        # The same source gives the same file on one day; paths only inside the folder.
        environment = {
            **os.environ,
            "SOURCE_DATE_EPOCH": str(written_at()),
            "FORCE_SOURCE_DATE": "1",
            "openin_any": "p",
            "openout_any": "p",
        }
        code = _run(command, folder, environment)
        output = folder / "lecture.pdf"
        if code or not output.exists():
            path = folder / "lecture.log"
            log = path.read_text(encoding="utf-8", errors="replace") if path.exists() else ""
            raise LatexError(f"no PDF: latexmk failed: {_first_error(log)}", log)
        return output.read_bytes()


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


def _first_error(log: str) -> str:
    r"""The first error of a log in one line, with its place.

    >>> _first_error("! Undefined control sequence.\nl.3 A \\nonsense\n")
    'Undefined control sequence \\nonsense (line 3 of the .tex)'
    """
    match = re.search(r"^! (.*)(?:.|\n)*?(?:^l\.(\d+)(.*)|\Z)", log, re.MULTILINE)
    if match is None:
        return "its log names no error" if log else "it left no log"
    words, line, source = match[1].strip().rstrip("."), match[2], match[3] or ""
    command = re.findall(r"\\[A-Za-z@]+", source) if words == "Undefined control sequence" else []
    return " ".join([words, *command[-1:], *([f"(line {line} of the .tex)"] if line else [])])


def by_typst(source: str, figures: Mapping[str, bytes]) -> bytes:
    """Compile with the fonts that the typst package brings along; nothing is fetched."""
    import typst

    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        _lay_out(folder, figures)
        (folder / "lecture.typ").write_text(source, encoding="utf-8")
        try:
            pages = typst.compile(
                str(folder / "lecture.typ"), root=str(folder), ignore_system_fonts=True
            )
        except (RuntimeError, typst.TypstError) as error:
            message = " ".join(str(error).split())
            raise RigidtopError(f"no PDF: typst failed: {message}") from None
    return bytes(pages)
