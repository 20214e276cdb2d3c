"""The page "Check my derivation": the judge in a browser, by Pyodide, on the reader's computer.

The page is one file, with rigidtop packed into it.  Pyodide itself, SymPy and NumPy for it come
from a base address, a folder beside the page by default.  The page's policy lets it speak with that
address and its own alone, and it sends nothing there.
"""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Iterator
from html import escape
from importlib.metadata import version
from io import BytesIO
from pathlib import Path
from urllib.parse import urlsplit
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

import rigidtop
from rigidtop import derivations
from rigidtop.errors import RigidtopError
from rigidtop.report.html import page as html_page
from rigidtop.web.page import json_text

FOLDER = Path(__file__).parent / "check-page"
TITLE = "Check my derivation"
BASE = "pyodide/"
"""Where Pyodide is, as seen from the page."""

PYODIDE = "0.29.5"
"""The version of Pyodide with which the page is tested."""

RELEASE = f"https://github.com/pyodide/pyodide/releases/download/{PYODIDE}"
FETCH = f"curl -L {RELEASE}/pyodide-{PYODIDE}.tar.bz2 | tar -xj"
"""What puts Pyodide's release beside the page, in the folder of that name."""

EXAMPLE = r"""A bob of mass $m$ hangs on a rod of length $l$. Its Lagrangian is

$$L = \tfrac12 m l^2\dot\theta^2 + m g l\cos\theta,$$

and so its momentum is

$$p_\theta = \frac{\partial L}{\partial\dot\theta} = m l^2\dot\theta$$

and its equation of motion is

$$l\ddot\theta = g\sin\theta.$$

For small angles $\theta \ll 1$ this is

$$\ddot\theta = -\frac{g}{l}\theta.$$
"""


def page(seconds: float, base: str = BASE) -> str:
    """The page as HTML, which waits so many seconds for a statement.

    `base` is the address of Pyodide's files: a folder, as seen from the page, or a URL.
    Raises RigidtopError for what is no address.
    """
    source = _origin(base)
    policy = (
        "default-src 'none'; style-src 'unsafe-inline'; img-src data:; worker-src blob:; "
        f"script-src 'unsafe-inline' 'wasm-unsafe-eval' blob: {source}; connect-src {source}; "
        "form-action 'none'; base-uri 'none'"
    )
    data = {"base": base.rstrip("/") + "/", "seconds": seconds, "fetch": FETCH}
    parts = {
        "example": escape(EXAMPLE),
        "version": escape(version("rigidtop")),
        "data": json_text(data),
        "package": b64encode(package()).decode(),
        "worker": (FOLDER / "worker.js").read_text("utf-8"),
        "script": (FOLDER / "check.js").read_text("utf-8"),
    }
    template = (FOLDER / "body.html").read_text("utf-8")
    body = re.sub(r"\{\{(\w+)\}\}", lambda place: parts[place[1]], template)
    whole = html_page(TITLE, ("page.css", "annotated.css"), body, "check", "text")
    meta = f'<meta http-equiv="Content-Security-Policy" content="{policy}"/>'
    style = (FOLDER / "check.css").read_text("utf-8")
    whole = whole.replace("</style>", f"{style}</style>", 1)
    return whole.replace("<title>", f'{meta}\n<link rel="icon" href="data:,"/>\n<title>', 1)


def _origin(base: str) -> str:
    """What the page may speak with, as its policy says it."""
    if not re.fullmatch(r"[\w.:/@~%+-]+", base):
        raise RigidtopError(f"{base!r} is no address of a folder, such as {BASE} or https://…/")
    address = urlsplit(base)
    if not address.scheme:
        return "'self'"
    if address.scheme not in ("http", "https") or not address.netloc:
        raise RigidtopError(f"{base} is no address on the web: https://…/, or a folder like {BASE}")
    return f"'self' {address.scheme}://{address.netloc}"


LEFT_OUT = {"chapters", "codegen", "figures", "starter", "system", "web"}
"""Rooms that no text is judged by."""


def package() -> bytes:
    """Rigidtop as a ZIP file, the same for the same files, without rooms that judge no text."""
    packed = BytesIO()
    with ZipFile(packed, "w", ZIP_DEFLATED, compresslevel=9) as archive:
        for name, path in sorted(_files()):
            entry = ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            entry.compress_type = ZIP_DEFLATED
            archive.writestr(entry, path.read_bytes())
    return packed.getvalue()


def _files() -> Iterator[tuple[str, Path]]:
    """Each file by its name in the package."""
    own = Path(rigidtop.__file__).parent
    beside = Path(derivations.__file__).parent  # in a checkout it lies outside
    for path in own.rglob("*"):
        room = path.relative_to(own).parts[0]
        if path.is_file() and room not in {*LEFT_OUT, "derivations"} and _is_source(path):
            yield f"rigidtop/{path.relative_to(own).as_posix()}", path
    for path in beside.rglob("*"):
        if path.is_file() and _is_source(path):
            yield f"rigidtop/derivations/{path.relative_to(beside).as_posix()}", path


def _is_source(path: Path) -> bool:
    return path.suffix != ".pyc"
