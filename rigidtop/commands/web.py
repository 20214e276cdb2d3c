"""``rigidtop web``: pages that run in a browser, with a motion or with the judge."""

from __future__ import annotations

import argparse
import math
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from rigidtop.commands.output import print_json
from rigidtop.commands.settings import add_settings, apart
from rigidtop.errors import RigidtopError
from rigidtop.parameters import Parameter, settings

if TYPE_CHECKING:
    from rigidtop.web.setup import Preset, Setup

ABOUT = "write a page that computes a motion, or checks a derivation, in the browser"

EPILOG = """\
heavy-top and free show a motion.  Such a page needs no network: open the file, or send
it.  Its address records what is set, so it can be shared as a link.  It needs the extra
web: pip install 'rigidtop[web]'

--preset is what the page shows first, --set changes a number of that:
  heavy-top: loops, slow, fast, waves, cusps, sleeping, waking, toppling,
    running-down
    lambda1, lambda2, lambda3 (kg m²), M (kg), g (m/s²), R1, R2, R (m), friction (J s),
    theta, phi, psi, theta_dot, phi_dot, omega3
  free: free-precession, plate, flip, largest, smallest, toutatis
    lambda1, lambda2, lambda3, omega1, omega2, omega3
Angles are radians, or degrees with the suffix deg; rates rad/s, or turns a minute with
the suffix rpm.

check is a sheet for a text with formulas, which are judged as `rigidtop audit` does, in
the browser: no text leaves the computer.  It wants Pyodide in the folder pyodide beside
it, or at another ADDRESS, and says how to get it.

examples:
  rigidtop web heavy-top -o top.html
  rigidtop web heavy-top --preset loops --set theta=45deg omega3=20 -o my.html
  rigidtop web free --preset toutatis -o toutatis.html
  rigidtop web check -o check.html"""

KINDS = ("heavy-top", "free")
CHECK = "check"


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to its parser."""
    parser.add_argument("kind", nargs="?", metavar="PAGE", help="heavy-top, free or check")
    parser.add_argument(
        "-o", "--output", metavar="FILE", help="the page (default: its name, heavy-top.html)"
    )
    parser.add_argument("--preset", metavar="NAME", help="what it shows first")
    parser.add_argument(
        "--pyodide", metavar="ADDRESS", help="of check: where Pyodide is (default: pyodide/)"
    )
    add_settings(parser, "change numbers in it, such as theta=45deg")


def run(options: argparse.Namespace) -> int:
    """Write the page; the exit code is 0."""
    from rigidtop.terminal.files import write_whole
    from rigidtop.web.page import page
    from rigidtop.web.presets import PRESETS

    if options.output == "":
        raise RigidtopError("--output wants the name of a file")
    kind, settings = _kind(options)
    if kind == CHECK:
        return _check(options, settings)
    if options.pyodide is not None:
        raise RigidtopError(f"--pyodide is for the page check, not for {kind}")
    presets = PRESETS[kind]()
    first = _changed(_named(options.preset, presets), settings)
    written = page(kind, first)
    path = Path(options.output or f"{kind}.html")
    content = written.html.encode()
    write_whole(path, content)
    if options.json:
        print_json(
            {
                "file": str(path),
                "bytes": len(content),
                "preset": first.name,
                "values": dict(first.setup.values),
                "clock": first.setup.clock,
                "presets": [{"name": p.name, "title": p.title} for p in presets],
            }
        )
    else:
        print(f"{path}\n{written.title}: {first.title} ({len(content) / 1e6:.1f} MB)")
    return 0


def _check(options: argparse.Namespace, settings: list[str]) -> int:
    """Write the page that checks a derivation."""
    from rigidtop.commands.browser import SECONDS
    from rigidtop.terminal.files import write_whole
    from rigidtop.web.check import BASE, FETCH, TITLE, page

    if settings or options.preset is not None:
        raise RigidtopError("the page check shows no motion: it has no --preset and no --set")
    base = BASE if options.pyodide is None else options.pyodide
    content = page(SECONDS, base).encode()
    path = Path(options.output or f"{CHECK}.html")
    write_whole(path, content)
    if options.json:
        print_json({"file": str(path), "bytes": len(content), "pyodide": base})
        return 0
    print(f"{path}\n{TITLE} ({len(content) / 1e6:.1f} MB)")
    if options.pyodide is None:
        print(f"beside it it wants Pyodide: {FETCH}\nthen serve the folder: python -m http.server")
    return 0


def _kind(options: argparse.Namespace) -> tuple[str, list[str]]:
    """Which page, and what is set in it; the page may stand behind --set."""
    kind, settings = options.kind, options.set
    if kind is None:
        settings, more = apart(settings)
        kind = " ".join(more)
    if kind not in (*KINDS, CHECK):
        names = f"{', '.join(KINDS)} or {CHECK}"
        raise RigidtopError(f"which page?  {names}" + f", not {kind!r}" * bool(kind))
    return kind, settings


def _named(name: str | None, presets: tuple[Preset, ...]) -> Preset:
    if name is None:
        return presets[0]
    for preset in presets:
        if preset.name == name:
            return preset
    raise RigidtopError(f"no preset {name!r}: there are {', '.join(p.name for p in presets)}")


def _changed(preset: Preset, words: list[str]) -> Preset:
    """The preset with other numbers, if a body has them."""
    from rigidtop.web.setup import body_of

    if not words:
        return preset
    values = preset.setup.values
    parameters = [_parameter(name, value) for name, value in values.items()]
    chosen = settings(parameters, words)
    symmetric = preset.setup.kind == KINDS[0] and values["lambda1"] == values["lambda2"]
    if symmetric and chosen["lambda2"] == values["lambda2"]:
        chosen["lambda2"] = chosen["lambda1"]  # as on the page, unless it is set itself
    setup: Setup = replace(preset.setup, values=chosen)
    body_of(setup)  # raises for moments that no body has
    changes = [name for name in values if setup.values[name] != values[name]]
    if not changes:
        return preset
    says = ", ".join(f"{name} = {setup.values[name]:.4g}" for name in changes)
    about = f"As “{preset.title}”, but with {says} (SI units and radians)."
    return replace(preset, name="own", title="An example, changed", about=about, setup=setup)


def _parameter(name: str, value: float) -> Parameter:
    if name == "theta":
        return Parameter(name, value, "θ at the start", "rad", least=0, most=math.pi)
    if name == "friction":
        return Parameter(name, value, "torque of friction over ω", "J s", least=0)
    rate = name.startswith("omega") or name.endswith("_dot")
    unit = "rad/s" if rate else "rad" if name in ("phi", "psi") else UNITS.get(name, "kg m²")
    return Parameter(name, value, name, unit)


UNITS = {"M": "kg", "g": "m/s²", "R1": "m", "R2": "m", "R": "m"}
