"""``rigidtop certify``: one motion computed in several ways, and by how much they differ."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from rigidtop.commands import motions
from rigidtop.commands.output import print_json

if TYPE_CHECKING:
    from rigidtop.motion.certify import Certificate

ABOUT = "compute one motion in several ways and compare them"

EPILOG = """\
The closed form must give the attitudes of Euler's equations, and Lagrange's, Routh's and Hamilton's
equations in Euler angles the same rates.  Exit code 1 if they do not.

examples:
  rigidtop certify top --theta 0.5 --theta-dot 0.1 --phi-dot 1 --psi-dot 40
  rigidtop certify free --moments 1 2 3 --omega 0.01 2 0.01 --time 30"""

DISAGREE = 1
"""The exit code."""

KEPT = {"energy": "energy", "p_phi": "p_φ", "p_psi": "p_ψ", "L": "|L|"}
"""What a motion keeps, in print."""


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to its parser."""
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
    certificate = certify(motion, times, rtol=options.rtol)
    if options.json:
        print_json(record(certificate))
    else:
        asked = f"{options.samples} times from 0 to {options.time:g} s, rtol {options.rtol:g}"
        print(text(certificate, asked))
    return 0 if certificate.passed else DISAGREE


def record(certificate: Certificate) -> dict[str, object]:
    """A certificate as plain values, for JSON."""
    return {
        "passed": certificate.passed,
        "undecided": certificate.undecided,
        "differences": dict(certificate.differences),
        "bounds": {way: certificate.bounds[way] for way in certificate.differences},
        "reach": certificate.reach,
        "drifts": {way: dict(drift) for way, drift in certificate.drifts.items()},
        "left_out": dict(certificate.left_out),
    }


def text(certificate: Certificate, asked: str) -> str:
    """A certificate as tables for the terminal; `asked` says what for."""
    from rigidtop.terminal.table import paragraph, table

    differences, drifts = certificate.differences, certificate.drifts
    about = f"One motion by Euler's equations and in {len(differences)} other ways, {asked}"
    parts = [paragraph(about)]
    if differences:
        rows = [
            [way, _small(apart), _small(certificate.bounds[way]), "rad" if way == "exact" else ""]
            for way, apart in differences.items()
        ]
        parts.append(table(rows, ("way", "difference", "bound", ""), right=(1, 2)))
    names = list(drifts["Euler"])
    rows = [[way, *(_small(drift[name]) for name in names)] for way, drift in drifts.items()]
    head = ("relative drift of", *(KEPT[name] for name in names))
    parts.append(table(rows, head, right=range(1, len(head))))
    reasons = [[what, why] for what, why in certificate.left_out.items()]
    if reasons:
        parts.append(table(reasons, ("left out", "because")))
    parts.append(paragraph(verdict(certificate)))
    return "\n\n".join(parts)


def verdict(certificate: Certificate) -> str:
    """Whether the ways agree, in one sentence."""
    if not certificate.differences:
        return "NOTHING TO COMPARE: one way alone proves nothing"
    if certificate.undecided:
        return (
            f"NOT DECIDED: the attitudes differ by {certificate.differences['exact']:.1e} rad; in "
            f"so long a time the solver's own errors may grow to {certificate.reach:.1e} rad: take "
            "a shorter one"
        )
    if certificate.passed:
        return "the ways agree: no difference exceeds its bound"
    return f"THE WAYS DISAGREE: {', '.join(certificate.strays)}"


def _small(value: float) -> str:
    return f"{value:.1e}" if value else "0"
