"""Motions from options: what every command that computes one asks for."""

from __future__ import annotations

import argparse
import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from rigidtop.commands.settings import whole
from rigidtop.errors import RigidtopError
from rigidtop.parameters import EXAMPLE_SPIN, EXAMPLE_TOP, Parameter, quantity

if TYPE_CHECKING:
    from rigidtop.motion.motion import Motion
    from rigidtop.motion.table.motion import SlidingMotion

TOP_OPTIONS = ("lambda1", "lambda3", "mass", "arm", "gravity", "theta", "phi", "psi", "theta_dot")
TOP_RATES = ("phi_dot", "omega3", "psi_dot", "steady")
CONSTANTS = ("E", "p_phi", "p_psi")
MOST_ROWS = 10_000_000
THETA = Parameter("theta", 0.5, "θ at t = 0", "rad", least=0, most=math.pi)

FREE_OPTIONS = ("moments", "omega")
TABLE_OPTIONS = (
    *("tip", "mu", "viscosity", "drag", "drag1", "drag3", "fall"),
    *("velocity", "slip"),
)

OTHER_NAMES = {"mass": "M", "arm": "R", "gravity": "g"}
"""Of the properties of a top, in options."""

START = ("phi", "psi", "theta_dot", "phi_dot", "omega3", "psi_dot")


def number(text: str) -> float:
    """A finite number.

    >>> number("2.5e-3")
    0.0025
    """
    return _typed(text, "1")


def angle(text: str) -> float:
    """Radians, or degrees with the suffix deg.

    >>> angle("0.5"), round(angle("30deg"), 6)
    (0.5, 0.523599)
    """
    return _typed(text, "rad")


def rate(text: str) -> float:
    """Radians a second, or degrees with the suffix deg, or turns a minute with the suffix rpm.

    >>> rate("0.5"), round(rate("30rpm"), 6)
    (0.5, 3.141593)
    """
    return _typed(text, "rad/s")


def _typed(text: str, unit: str) -> float:
    try:
        return quantity(text, unit)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


count = whole(2, 9_999_999)
"""A number of rows."""


def add_motion(parser: argparse.ArgumentParser, table: bool = False) -> None:
    """The body and its start; with `table`, also a top that slides on one."""
    bodies, about = ["top", "free"], "a heavy symmetric top or a free body"
    if table:
        bodies.append("sliding")
        about = "a heavy symmetric top with its tip held, a free body, or a top on a table"
    parser.add_argument("body", choices=bodies, help=about)
    top = parser.add_argument_group("the top (defaults: the example top)")
    for *flags, name, about in (
        ("--lambda1", "lambda1", "moment across the axis, about the pivot, kg m²"),
        ("--lambda3", "lambda3", "moment about the axis, kg m²"),
        ("--mass", "--M", "M", "mass M, kg"),
        ("--arm", "--R", "R", "distance R from the pivot to the centre of mass, m"),
        ("--gravity", "--g", "g", "g, m/s²"),
    ):
        top.add_argument(*flags, type=number, help=f"{about} (default {EXAMPLE_TOP[name]:g})")
    top.add_argument("--theta", type=angle, help="θ at t = 0 (default 0.5)")
    top.add_argument("--phi", type=angle, help="φ at t = 0")
    top.add_argument("--psi", type=angle, help="ψ at t = 0")
    top.add_argument("--theta-dot", type=rate, help="θ̇ at t = 0, per second")
    top.add_argument("--phi-dot", type=rate, help="φ̇ at t = 0, per second")
    spin = top.add_mutually_exclusive_group()
    spin.add_argument("--omega3", type=rate, help=f"ω₃, per second (default {EXAMPLE_SPIN:g})")
    spin.add_argument("--psi-dot", type=rate, help="ψ̇ at t = 0, per second, instead of ω₃")
    top.add_argument("--steady", choices=("slow", "fast"), help="start with φ̇ = Ω₋ or Ω₊")
    constants = "instead of rates: it starts at the smallest θ, or at --theta"
    top.add_argument("--E", type=number, help=f"the energy, J, {constants}")
    top.add_argument("--p-phi", type=number, help="p_φ, J s, with --E and --p-psi")
    top.add_argument("--p-psi", type=number, help="p_ψ, J s")
    free = parser.add_argument_group("the free body")
    free.add_argument("--moments", type=number, nargs=3, metavar="λ", help="λ₁ λ₂ λ₃, kg m²")
    free.add_argument("--omega", type=rate, nargs=3, metavar="ω", help="ω in the body, per second")
    if table:
        _add_table(parser)


def _add_table(parser: argparse.ArgumentParser) -> None:
    """What a top on a table has besides."""
    sliding = parser.add_argument_group(
        "the top on a table, `sliding`",
        "The options of the top, but --lambda1 (default 0.75) and --lambda3 are about the centre "
        "of mass, and --arm is its distance from the lowest point of the upright top.",
    )
    for flag, about in (
        ("--tip", "radius of the round tip, m"),
        ("--mu", "coefficient of Coulomb friction"),
        ("--viscosity", "viscous friction force over slip, N s/m"),
        ("--drag", "drag of the air over the velocity of the centre of mass, N s/m"),
        ("--drag1", "torque of the air over ω₁ and ω₂, N m s"),
        ("--drag3", "torque of the air over ω₃, N m s"),
    ):
        sliding.add_argument(flag, type=number, help=f"{about} (default 0)")
    sliding.add_argument("--fall", type=angle, help="θ at which it lies on its rim (default 90deg)")
    start = sliding.add_mutually_exclusive_group()
    start.add_argument(
        "--velocity",
        type=number,
        nargs=2,
        metavar=("X", "Y"),
        help="of the centre of mass at t = 0, m/s (default 0 0)",
    )
    start.add_argument(
        "--slip",
        type=number,
        nargs=2,
        metavar=("X", "Y"),
        help="of the contact at t = 0, m/s, instead; 0 0 if it starts at rest",
    )


def motion(options: argparse.Namespace, command: str) -> Motion:
    """What was asked for, in the words of that command where it makes no sense."""
    _check(options, command, _foreign(options.body))
    return _top(options) if options.body == "top" else _free(options)


def _foreign(body: str) -> tuple[str, ...]:
    """The options that belong to the other kind of body."""
    return FREE_OPTIONS if body == "top" else TOP_OPTIONS + TOP_RATES + CONSTANTS


def on_table(options: argparse.Namespace, command: str) -> SlidingMotion:
    """A top on a table, from the options of `add_motion` with `table`."""
    import rigidtop

    _check(options, command, (*FREE_OPTIONS, "steady", *CONSTANTS), TABLE_OPTIONS)
    values = {name: value for name, value in vars(options).items() if value is not None}
    more = {name: values[name] for name in TABLE_OPTIONS[:-2] if name in values}
    top = rigidtop.SlidingTop(**{**EXAMPLE_TOP, "lambda1": 0.75, **_properties(values), **more})
    start = {name: values[name] for name in (*START, "velocity", "slip") if name in values}
    if "omega3" not in start and "psi_dot" not in start:
        start["omega3"] = EXAMPLE_SPIN
    return top.motion(theta=THETA.checked(values.get("theta", THETA.default)), **start)


def _check(
    options: argparse.Namespace,
    command: str,
    foreign: tuple[str, ...],
    own: tuple[str, ...] = (),
) -> None:
    """RigidtopError for an option that is not this body's, and where nothing is asked."""
    for name in (*foreign, *(name for name in TABLE_OPTIONS if name not in own)):
        if getattr(options, name, None) is not None:
            flag = name.replace("_", "-")
            raise RigidtopError(f"--{flag} does not go with `{command} {options.body}`")
    if options.time == 0:
        raise RigidtopError("--time 0 leaves nothing to compute: give a time in seconds")


def _properties(values: Mapping[str, Any]) -> dict[str, float]:
    """What the options say of a top, by the names of its own."""
    named = {OTHER_NAMES.get(name, name): value for name, value in values.items()}
    return {name: named[name] for name in EXAMPLE_TOP if name in named}


def _top(options: argparse.Namespace) -> Motion:
    import rigidtop

    values = {name: value for name, value in vars(options).items() if value is not None}
    top = rigidtop.HeavyTop(**{**EXAMPLE_TOP, **_properties(values)})
    start = {name: values[name] for name in START if name in values}
    if constants := {name: values[name] for name in CONSTANTS if name in values}:
        if options.steady:
            raise RigidtopError("--steady sets the rates: leave --E, --p-phi and --p-psi out")
        return top.motion(theta=values.get("theta"), **constants, **start)
    theta = THETA.checked(values.get("theta", THETA.default))
    if "omega3" not in start and "psi_dot" not in start:
        start["omega3"] = EXAMPLE_SPIN
    if options.steady:
        for other in ("phi_dot", "psi_dot", "theta_dot"):
            if other in start:
                flag = other.replace("_", "-")
                raise RigidtopError(f"--steady sets the rates: leave --{flag} out, give --omega3")
        if math.sin(theta) < 1e-9:
            raise RigidtopError("--steady wants a tilt: upright or hanging, every rate is steady")
        slow, fast = top.steady_precession(theta, start["omega3"])
        start["phi_dot"] = slow if options.steady == "slow" else fast
        if not math.isfinite(start["phi_dot"]):
            raise RigidtopError("a horizontal top has no fast steady precession: use --steady slow")
    return top.motion(theta=theta, **start)


def _free(options: argparse.Namespace) -> Motion:
    import rigidtop

    if options.moments is None or options.omega is None:
        raise RigidtopError("a free body needs --moments λ₁ λ₂ λ₃ and --omega ω₁ ω₂ ω₃")
    return rigidtop.FreeBody(*options.moments).motion(omega=tuple(options.omega))
