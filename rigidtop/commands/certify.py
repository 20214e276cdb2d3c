"""``rigidtop certify``: one motion computed in several ways, and by how much they differ."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from typing import TYPE_CHECKING

from rigidtop.commands import motions
from rigidtop.commands.output import print_json

if TYPE_CHECKING:
    from rigidtop.motion.certify import Certificate

ABOUT = "compute one motion in several ways and compare them"

EPILOG = """\
Euler's equations on quaternions, Lagrange's, Routh's and Hamilton's in Euler angles,
and the closed form must give the same attitudes.  Exit code 1 if they do not.

examples:
  rigidtop certify top --theta 0.5 --theta-dot 0.1 --phi-dot 1 --psi-dot 40
  rigidtop certify free --moments 1 2 3 --omega 0.01 2 0.01 --time 30"""

DISAGREE = 1
"""The exit code."""

KEPT = {"energy": "energy", "p_phi": "p_φ", "p_psi": "p_ψ", "L": "|L|"}
"""What a motion keeps, in print."""


def add_options(parser: argparse.ArgumentParser) -> None:
    """What can be asked."""
    motions.add_motion(parser)
    run = parser.add_argument_group("the computation")
    run.add_argument(
        "--time", type=motions.number, default=10.0, help="from 0 to this time, s (10)"
    )
    run.add_argument("--samples", type=motions.count, default=21, help="times, at least 2 (21)")
    run.add_argument("--rtol", type=motions.number, default=1e-12, help="of the solvers (1e-12)")


def run(options: argparse.Namespace) -> int:
    """Compute and print; 0 if the ways agree."""
    motion = motions.motion(options, "certify")

    import numpy as np

    from rigidtop.motion.certify import certify

    times = np.linspace(0.0, options.time, options.samples)
    found = certify(motion, times, rtol=options.rtol)
    if options.json:
        print_json(record(found))
    else:
        asked = f"{options.samples} times from 0 to {options.time:g} s, rtol {options.rtol:g}"
        print(text(found, asked))
    return 0 if found.passed else DISAGREE


def record(found: Certificate) -> dict[str, object]:
    """A certificate as plain values."""
    return {
        "passed": found.passed,
        "ways": list(found.ways),
        "differences": found.differences.tolist(),
        "bound": found.bound,
        "reach": found.reach,
        "undecided": found.undecided,
        "amplification": found.amplification,
        "drifts": {way: dict(drift) for way, drift in found.drifts.items()},
        "orders": [dict(vars(order)) for order in found.orders],
        "left_out": dict(found.left_out),
        "stray": list(found.stray),
    }


def text(found: Certificate, asked: str) -> str:
    """A certificate as tables for the terminal; `asked` says what for."""
    from rigidtop.terminal.table import paragraph, table

    parts = [f"One motion in {len(found.ways)} ways, {asked}"]
    if found.ways:
        rows = [
            [way, *("·" if k == row else f"{x:.1e}" for k, x in enumerate(found.differences[row]))]
            for row, way in enumerate(found.ways)
        ]
        parts.append(_numbers(rows, ("difference/rad", *found.ways)))
        names = list(found.drifts[found.ways[0]])
        rows = [[way, *(_small(found.drifts[way][name]) for name in names)] for way in found.ways]
        parts.append(_numbers(rows, ("relative drift of", *(KEPT[name] for name in names))))
    if found.orders:
        rows = [
            [
                order.method,
                str(order.classical),
                f"{order.observed:.2f}",
                *(
                    f"{error:.1e} in {n} steps"
                    for n, error in zip(order.steps, order.errors, strict=True)
                ),
            ]
            for order in found.orders
        ]
        head = ("integrator", "order", "observed", "error/rad", "with half the step")
        parts.append(_numbers(rows, head))
    reasons = [[what, why] for what, why in found.left_out.items()]
    parts.append(table(reasons, ("left out", "because")))
    parts.append(paragraph(verdict(found)))
    return "\n\n".join(parts)


def verdict(found: Certificate) -> str:
    """One line."""
    if found.stray:
        return f"THE WAYS DISAGREE: {', '.join(found.stray)} ends at a pole that is not there"
    if len(found.ways) < 2:
        return "NOTHING TO COMPARE: one way alone proves nothing"
    compared = f"largest difference {found.largest:.1e} rad, bound {found.bound:.1e} rad"
    if found.undecided:
        return (
            f"NOT DECIDED: {compared}; in so long a time the solvers' own errors may grow to "
            f"{found.reach:.1e} rad: take a shorter one"
        )
    return f"the ways agree: {compared}" if found.passed else f"THE WAYS DISAGREE: {compared}"


def _numbers(rows: Sequence[Sequence[str]], head: Sequence[str]) -> str:
    """A table of which all columns but the first are numbers."""
    from rigidtop.terminal.table import table

    return table(rows, head, right=range(1, len(head)))


def _small(value: float) -> str:
    return f"{value:.1e}" if value else "0"
