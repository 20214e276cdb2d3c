"""The page of a top on a table: computed here, with its changes between sliding and rolling.

Beside the motion that was given there are some with one thing changed: Coulomb's friction has no
equations that a page could integrate from end to end.
"""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Mapping
from dataclasses import replace
from math import pi

import numpy as np
import sympy
from sympy import Matrix, cos

from rigidtop.codegen.javascript import of_arrays
from rigidtop.errors import RigidtopError
from rigidtop.motion.table.motion import SlidingMotion, SlidingTop
from rigidtop.motion.table.trajectory import SlidingTrajectory
from rigidtop.theory import rotation
from rigidtop.theory import symbols as s
from rigidtop.web.page import LivePage, common, document, json_text
from rigidtop.web.setup import Preset, Setup

LONGEST, ROWS = 10.0, 200
"""How long it is played (s), and rows in a second of it."""

X, Y, E = sympy.symbols("X Y E", real=True)
COLUMNS = (
    ("θ", "rad"),
    ("φ", "rad"),
    ("X", "m"),
    ("Y", "m"),
    ("θ̇", "rad/s"),
    ("slip", "m/s"),
    ("ω₃", "rad/s"),
    ("W", "J"),
)
"""What is plotted, with its unit: W is what friction and air have taken."""

ENDS = {
    "fall": "the top lies on the table",
    "lift-off": "the top leaves the table",
    "": f"it was computed for {LONGEST:g} s",
}
HAPPENS = {"standstill": "its contact stops slipping", "slip": "its contact slips again"}


def page_of_table(motion: SlidingMotion, height: int = LivePage.height) -> LivePage:
    """The page of a top on a table; see `rigidtop.show`.

    Raises RigidtopError where it cannot be integrated.
    """
    title = "A top on a table"
    runs = {"As given": integrated(motion)}
    for name, changed in variants(motion).items():
        try:
            runs[name] = integrated(changed)
        except RigidtopError:
            continue  # the motion that was given is possible, this one is not
    text = json_text(data(runs, title))
    return LivePage(title, document(title, text, "system", module(motion.body)), height)


def integrated(motion: SlidingMotion) -> SlidingTrajectory:
    """The trajectory up to the end of what the page plays."""
    return motion.integrate(np.arange(0, LONGEST + 0.5 / ROWS, 1 / ROWS))


def variants(motion: SlidingMotion) -> dict[str, SlidingMotion]:
    """The same top with less friction, with more, and with less spin, by their titles."""
    body, (omega1, omega2, omega3) = motion.body, motion.omega
    rubbing = (("Half the friction", 0.5), ("Twice the friction", 2.0)) if body.mu else ()
    start = replace(motion.initial, omega=(omega1, omega2, omega3 / 2))
    slower = {"Half the spin": replace(motion, initial=start)}
    return {
        name: replace(motion, body=replace(body, mu=factor * body.mu)) for name, factor in rubbing
    } | (slower if omega3 else {})


def places(body: SlidingTop) -> tuple[Matrix, ...]:
    """The contact, the centre of the round tip, the centre of mass, and the axis above it."""
    axis = Matrix(rotation.euler_matrix()[:, 2])
    below = body.R - body.tip
    centre = Matrix([X, Y, body.tip + below * cos(s.theta)])
    tip = centre - below * axis
    contact = Matrix([*tip[:2], 0])
    return contact, tip, centre, centre + body.R * axis


def module(body: SlidingTop) -> str:
    """The places and the attitude as functions of a row."""
    row = [s.theta, s.phi, X, Y, *sympy.symbols("thetadot slip omega3 W"), s.psi, E]
    takes = {"s": row, "p": ()}
    seen = [x for place in places(body) for x in place] + list(rotation.euler_matrix())
    return "\n\n".join(
        (
            of_arrays("rates", "What a page of rows does not ask for.", takes, ()),
            of_arrays("points", "Contact, tip, centre, axis, then the attitude.", takes, seen),
            of_arrays("measures", "E (J).", takes, [E]),
        )
    )


def data(runs: Mapping[str, SlidingTrajectory], title: str) -> Mapping[str, object]:
    """`SystemData` of the page's types, of motions by their titles, that which is given first."""
    state = [
        {
            "letter": letter,
            "math": "",
            "meaning": "",
            "unit": "" if unit == "rad" else unit,
            "angle": unit == "rad",
        }
        for letter, unit in COLUMNS
    ]
    presets = [
        Preset(name.replace(" ", "-").lower(), name, said(run), Setup("system", {}), (), "")
        for name, run in runs.items()
    ]
    pairs = zip(presets, runs.values(), strict=True)
    return common("system", title, [], presets, presets[0]) | {
        "state": state,
        "start": [],
        "given": [],
        "sides": [],
        "points": 4,
        "bodies": [2],
        "planar": False,
        "follow": 2,
        "kept": [],
        "written": "",
        "recordings": {preset.name: recording(run) for preset, run in pairs},
    }


def recording(run: SlidingTrajectory) -> Mapping[str, object]:
    """The rows of a recording, as numbers of four bytes, and why there are no more."""
    taken = run.dissipated_by_friction + run.dissipated_by_air
    slip = np.hypot(*run.slip.T)
    rows = np.column_stack(
        (
            *(run.theta, run.phi, run.centre, run.theta_dot, slip, run.omega[:, 2], taken),
            *(run.psi, run.energy),
        )
    )
    return {
        "step": 1 / ROWS,
        "width": rows.shape[1],
        "rows": b64encode(rows.astype("<f4").tobytes()).decode(),
        "ended": ENDS[run.ended.kind if run.ended else ""],
    }


def said(run: SlidingTrajectory) -> str:
    """The body, and what happens in the course of the motion."""
    body = run.motion.body
    numbers = {
        "λ₁": (body.lambda1, "kg m²"),
        "λ₃": (body.lambda3, "kg m²"),
        "M": (body.M, "kg"),
        "R": (body.R, "m"),
        "r": (body.tip, "m"),
        "μ": (body.mu, ""),
        "γ": (body.viscosity, "N s/m"),
    }
    values = ", ".join(f"{name} = {x:g} {unit}".strip() for name, (x, unit) in numbers.items() if x)
    happens = [f"at t = {e.time:.4g} s {HAPPENS[e.kind]}" for e in run.events if e.kind in HAPPENS]
    more = f" and {len(happens) - 3} changes more" if len(happens) > 3 else ""
    course = f" {'; '.join(happens[:3])}{more}.".replace(" at", " At", 1) if happens else ""
    turned = float(run.theta[-1] - run.theta[0]) * 180 / pi
    way = "falls" if turned > 0 else "rises"
    last = f" In {run.t[-1]:.4g} s its axis {way} by {abs(turned):.3g}°." if abs(turned) > 1 else ""
    return f"{values}.{course}{last} The trails are those of the contact, the centre and the axis."
