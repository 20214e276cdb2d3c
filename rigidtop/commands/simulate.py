"""``rigidtop simulate``: one motion as a table, in closed form or integrated."""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from rigidtop.commands import motions
from rigidtop.commands.output import print_json
from rigidtop.errors import RigidtopError

if TYPE_CHECKING:
    from rigidtop.motion.motion import Motion

ABOUT = "compute a motion, its periods and the drift of what it keeps"

EPILOG = """\
Angles are in radians, or in degrees with the suffix deg; everything else is SI.
Attitudes are R = Rz(φ) Ry(θ) Rz(ψ), body to space.

examples:
  rigidtop simulate top --theta 30deg --omega3 40 --time 2 --samples 81
  rigidtop simulate top --theta 0.5 --omega3 40 --steady slow --time 20
  rigidtop simulate free --moments 1 2 3 --omega 0.01 2 0.01 -o flip.csv
  rigidtop simulate sliding --theta 0.3 --omega3 60 --tip 0.02 --mu 0.3"""

EXACT = "exact"
INTEGRATED = "DOP853"


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to its parser."""
    motions.add_motion(parser, table=True)
    run = parser.add_argument_group("the computation")
    run.add_argument("--time", type=motions.number, default=10.0, help="to this time, s (10)")
    run.add_argument("--samples", type=motions.count, default=21, help="rows, at least 2 (21)")
    run.add_argument(
        "--method",
        help="exact (the closed form, default where there is one), taylor, or one of scipy's "
        "solve_ivp (DOP853, default with friction)",
    )
    run.add_argument("--rtol", type=motions.number, help="relative tolerance (1e-10), not exact")
    run.add_argument("--atol", type=motions.number, help="absolute tolerance (1e-12), not exact")
    run.add_argument(
        "-o",
        "--output",
        metavar="FILE",
        help="write the table as CSV; an existing file is replaced",
    )


def run(options: argparse.Namespace) -> int:
    """Print a computed motion, or write it to a file and print a summary; the exit code is 0."""
    import numpy as np

    if options.output == "":
        raise RigidtopError("--output wants the name of a file")
    summary = _of_table if options.body == "sliding" else _of_motion
    if options.body == "sliding":
        motion: Any = motions.on_table(options, "simulate")
        options.method = options.method or (EXACT if motion.body.smooth else INTEGRATED)
    else:
        motion = motions.motion(options, "simulate")
    path = _computed(motion, np.linspace(0.0, options.time, options.samples), options)
    columns, (record, lines, warned) = path.columns(), summary(path, options)
    if options.output:
        path.to_csv(options.output)
    if options.json:
        values = {name: [float(x) for x in column] for name, column in columns.items()}
        print_json({"columns": values, **record})
        return 0
    from rigidtop.terminal.table import paragraph, table

    if options.output:
        print(options.output)
    else:
        # + 0.0 writes −0 as 0
        rows = [[f"{x + 0.0:.6g}" for x in row] for row in zip(*columns.values(), strict=True)]
        print(table(rows, tuple(columns), right=range(len(columns))) + "\n")
    print("\n".join(map(paragraph, lines)))
    for line in warned:
        print(paragraph(line), file=sys.stderr)
    return 0


Told = tuple[dict[str, Any], list[str], list[str]]
"""What JSON has besides the columns, what stands below the table, and what on stderr."""


def _of_motion(path: Any, options: argparse.Namespace) -> Told:
    drift, about = path.drift(), _about(path.motion)
    kept = ", ".join(f"{name} {value:.1e}" for name, value in drift.items())
    sentence = f"relative drift of what the exact motion keeps: {kept}"
    warned = list(_few_samples(about["nutation_period"], options))
    return {"drift": drift, **about}, [_sentence(path.motion, about), sentence], warned


def _of_table(path: Any, options: argparse.Namespace) -> Told:
    """The summary for a top that slides, rolls, and may fall before the end."""
    events = [{"time": event.time, "kind": event.kind} for event in path.events]
    budget, ended = path.budget(), path.ended.kind if path.ended else None
    friction, air = path.dissipated_by_friction[-1] + 0.0, path.dissipated_by_air[-1] + 0.0
    lines = [
        f"dissipated by friction {friction:.6g} J, by the air {air:.6g} J",
        f"relative gap in the budget of the energy: {budget:.1e}",
    ]
    warned = [f"{event.kind} at t = {event.time:.6g} s" for event in path.events]
    if ended:
        warned.append(f"the motion ends there: {len(path)} of {options.samples} rows")
    return {"budget": budget, "events": events, "ended": ended}, lines, warned


def _computed(motion: Any, times: Any, options: argparse.Namespace) -> Any:
    """The trajectory of any motion, as asked."""
    options_by_name = {name: getattr(options, name) for name in ("rtol", "atol")}
    tolerances = {name: value for name, value in options_by_name.items() if value is not None}
    if options.method in (None, EXACT):
        for name in tolerances:
            raise RigidtopError(f"--{name} is for integration: give a --method too")
        return motion.exact(times)
    return motion.integrate(times, method=options.method, **tolerances)


def _about(motion: Motion) -> dict[str, Any]:
    """Regime, turning points and periods; what is infinite is None."""
    periods = {
        name: getattr(motion, name)
        for name in ("nutation_period", "precession_per_period", "mean_precession")
    }
    finite = {name: x if math.isfinite(x) else None for name, x in periods.items()}
    return {"regime": motion.regime, "turning_points": list(motion.turning_points), **finite}


def _sentence(motion: Motion, about: dict[str, Any]) -> str:
    from rigidtop.motion.motion import TopMotion

    smallest, largest = about["turning_points"]
    period = about["nutation_period"]
    # A free body knows no vertical: what is told is its tilt against L.
    upright = isinstance(motion, TopMotion) or any(motion.body.weight)
    angle = "θ" if upright else "angle of e₃ to L"
    parts = [_regime(motion), f"{angle} from {smallest:.6g} to {largest:.6g} rad"]
    parts.append("no nutation period" if period is None else f"nutation period {period:.6g} s")
    if about["mean_precession"] is not None:
        parts.append(f"mean precession {about['mean_precession']:.6g} rad/s")
    return ", ".join(parts)


def _regime(motion: Motion) -> str:
    """The regime, with what its name leaves open."""
    from rigidtop.motion.top import HeavyTop

    regime, moments = motion.regime, motion.body.moments
    extremes = {"short axis": max(moments), "long axis": min(moments)}
    if regime in extremes:
        axis = "₁₂₃"[moments.index(extremes[regime])]
        which = "largest" if regime == "short axis" else "smallest"
        return f"{regime} (ω circles about e{axis}, the axis of the {which} moment)"
    if regime == "sleeping" and isinstance(motion.body, HeavyTop):
        least = motion.body.sleeping_spin()
        if abs(motion.omega[2]) < least:
            return f"sleeping, but not stable (it is from |ω₃| = {least:.6g} rad/s on)"
    return regime


def _few_samples(period: float | None, options: argparse.Namespace) -> Iterator[str]:
    spacing = abs(options.time) / (options.samples - 1)
    if period and spacing > period / 4:
        enough = math.ceil(abs(options.time) / period * 20) + 1
        advice = f"--samples {enough}" if enough < motions.MOST_ROWS else "an earlier --time"
        yield (
            f"a row every {spacing:.2g} s, but the nutation takes {period:.2g} s: "
            f"for a plot use {advice}"
        )
