"""``rigidtop fit``: the body that was measured, from a file of a phone or a laboratory."""

from __future__ import annotations

import argparse
import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rigidtop.commands import motions
from rigidtop.commands.output import print_json
from rigidtop.commands.recording import recording
from rigidtop.errors import RigidtopError

if TYPE_CHECKING:
    from rigidtop.motion.least_squares import Fit

ABOUT = "find the moments of a thrown phone, or the spin of a top, from what was measured"

EPILOG = """\
FILE is CSV as phyphox, Sensor Logger and others write it: the time, and x, y, z of a
gyroscope (rad/s, or deg/s where the header says so), or theta and phi of a top (rad or deg).
Only while nothing touches the phone does it move freely: give that time by --from and --to.

examples:
  rigidtop fit gyroscope.csv --from 1.9 --to 2.5
  rigidtop fit gyroscope.csv --misalignment -o fit.svg
  rigidtop fit top.csv --json"""

KINDS = ("svg", "pdf", "png")

SHOWN = {
    **{f"lambda{k}": (f"λ{sub}", "1") for k, sub in zip((1, 2, 3), "₁₂₃", strict=True)},
    **{f"omega{k}": (f"ω{sub}", "rad/s") for k, sub in zip((1, 2, 3), "₁₂₃", strict=True)},
    **{f"turn{k}": (f"turn{sub}", "rad") for k, sub in zip((1, 2, 3), "₁₂₃", strict=True)},
    "L": ("L", "rad/s"),
    "E": ("E", "rad²/s²"),
    "spin": ("λ₃ω₃/λ₁", "rad/s"),
    "weight": ("MgR/λ₁", "1/s²"),
    "theta": ("θ", "rad"),
    "theta_dot": ("θ̇", "rad/s"),
    "phi": ("φ", "rad"),
    "v_phi": ("φ̇ sin θ", "rad/s"),
    "psi": ("ψ", "rad"),
    "lambda3/lambda1": ("λ₃/λ₁", "1"),
}
"""How quantities are written, and their units where no moment was given."""

SCALED = {"1": "kg m²", "rad/s": "J s", "rad²/s²": "J"}
"""Units of λ, L and E where one was."""


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to its parser."""
    parser.add_argument("file", metavar="FILE", help="a table as CSV, its names in the first line")
    parser.add_argument(
        "--from", dest="since", type=motions.number, default=-math.inf, help="the first time, s"
    )
    parser.add_argument("--to", type=motions.number, default=math.inf, help="the last time, s")
    for k in (1, 2, 3):
        parser.add_argument(
            f"--lambda{k}", type=motions.number, help="kg m², if known: it is the scale"
        )
    parser.add_argument(
        "--misalignment", action="store_true", help="find how the sensor is turned in the body too"
    )
    parser.add_argument(
        "-o", "--output", metavar="FILE", help="draw data, motion and residuals: svg, pdf or png"
    )


def run(options: argparse.Namespace) -> int:
    """Print what the measurements tell, and perhaps draw them; the exit code is 0."""
    kind = Path(options.output or "").suffix.removeprefix(".").lower()
    if options.output is not None and kind not in KINDS:
        raise RigidtopError("--output wants a file with the suffix .svg, .pdf or .png")
    data = recording(options.file, options.since, options.to)
    moments = {f"lambda{k}": getattr(options, f"lambda{k}") for k in (1, 2, 3)}
    fit: Fit[Any] = _fit()(data.t, **data.columns, **moments, misalignment=options.misalignment)
    if options.output is not None:
        from rigidtop.figures.trajectories import compared
        from rigidtop.terminal.files import write_whole

        write_whole(Path(options.output), compared(fit, kind))
    if options.json:
        print_json(_record(fit))
        return 0
    from rigidtop.terminal.table import paragraph, table

    scaled = any(x is not None for x in moments.values())
    print(table(_rows(fit, scaled), ("", "value", "error", "unit"), right=(1, 2)) + "\n")
    for line in _words(fit, scaled):
        print(paragraph(line))
    if options.output is not None:
        print(options.output)
    return 0


def _fit() -> Any:
    import rigidtop

    return rigidtop.fit


def _rows(fit: Fit[Any], scaled: bool) -> list[tuple[str, str, str, str]]:
    """Values to two digits of their errors."""
    rows = []
    for name, value in fit.values.items():
        error = fit.errors[name]
        written, unit = SHOWN[name]
        if scaled and name[:1] in "lLE":
            unit = SCALED[unit]
        digits = 3 if not error else 2 + max(0, _power(value) - _power(error))
        value_text = f"{value:#.{digits}g}".rstrip(".") if error else f"{value:g}"
        rows.append(
            (written, value_text, f"{error:.2g}" if error else "given" if scaled else "unit", unit)
        )
    return rows


def _power(value: float) -> int:
    """The power of ten of a value's first digit; 0 for 0."""
    return math.floor(math.log10(abs(value))) if value else 0


def _noise(fit: Fit[Any]) -> dict[str, float]:
    """The root mean square of the residuals, by column."""
    return {
        name: math.sqrt(float((residual**2).mean())) for name, residual in fit.residuals.items()
    }


def _words(fit: Fit[Any], scaled: bool) -> list[str]:
    noise = ", ".join(f"{name} {value:.2g}" for name, value in _noise(fit).items())
    first = float(fit.t[0])
    lines = [
        f"{len(fit.t)} rows, {fit.motion.regime}; ω and angles are those at t = {first:g} s",
        f"root mean square of the residuals: {noise}",
    ]
    if "lambda1" not in fit.values:
        return [*lines, "λ₁, λ₃ and M by themselves cannot be known from angles"]
    if not scaled:
        lines.append(
            "only ratios of the moments can be known from a free motion: the smallest is 1, and "
            "L and E are in its unit"
        )
    return lines


def _record(fit: Fit[Any]) -> dict[str, Any]:
    return {
        "values": fit.values,
        "errors": fit.errors,
        "covariance": fit.covariance.tolist(),
        "residuals": _noise(fit),
        "rows": len(fit.t),
        "regime": fit.motion.regime,
    }
