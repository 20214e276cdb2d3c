"""The bodies of the figures, and the parameters that say which."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, TypeAlias, TypeVar

from matplotlib.axes import Axes
from scipy.optimize import brentq

from rigidtop.errors import RigidtopError
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.rigid import SymmetricTop
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter

T = TypeVar("T")
Facts: TypeAlias = dict[str, Any]

TOP = (
    Parameter("lambda1", 0.02, "moment across the axis, about the pivot", "kg m²", above=0),
    Parameter("lambda3", 0.01, "moment about the axis", "kg m²", above=0),
    Parameter("M", 1.0, "mass", "kg", above=0),
    Parameter("R", 0.1, "distance from the pivot to the centre of mass", "m", above=0),
    Parameter("g", 9.81, "acceleration of gravity", "m/s²", above=0),
)
"""A heavy top: MgR = 0.981 J, and about the centre of mass 0.01 kg m² each way."""

THETA = Parameter("theta", math.pi / 3, r"$\theta$ at the start", "rad", least=0, most=math.pi)
RATE = Parameter("phi_dot", 0.0, r"$\dot\phi$ at the start", "rad/s")
SPIN = Parameter("omega3", 40.0, r"$\omega_3$", "rad/s", above=0)


def of_top(told: Callable[..., T]) -> Callable[..., T]:
    """What takes all parameters by name, from what takes a heavy top and those that `TOP` has not.

    Axes stand before both.
    """
    names = [parameter.name for parameter in TOP]

    def of_all(*axes: Axes, **values: float) -> T:
        return told(*axes, HeavyTop(**{name: values.pop(name) for name in names}), **values)

    return of_all


def facts_of(top: SymmetricTop, **more: Any) -> Facts:
    """What captions say of a top, in {top}, of how it starts, in {start}, and `more`."""
    return {
        "MgR": top.M * top.g * top.R,
        "top": r"$\lambda_1 = {lambda1}$ kg m², $\lambda_3 = {lambda3}$ kg m² and $MgR = {MgR}$ J",
        "start": r"$\theta = {theta:°}$ and $\omega_3 = {omega3}$ rad/s",
        **more,
    }


def time_to(motion: TopMotion, theta: float) -> float:
    """When a top that is let go, and leans ever more at first, leans by `theta` (rad), in s."""

    def above(t: float) -> float:
        return float(motion.exact(t).theta[0]) - theta

    return float(brentq(above, 0.0, motion.nutation_period / 2, xtol=1e-14, rtol=1e-13))


def vertical(theta: float) -> bool:
    """Whether e₃ is upright or straight down, where φ has no meaning."""
    return theta in (0.0, math.pi)


def top_motion(
    theta: float,
    phi_dot: float,
    omega3: float,
    theta_dot: float = 0.0,
    phi: float = 0.0,
    **top: float,
) -> TopMotion:
    """The motion of a top by the parameters of a figure.

    Raises RigidtopError for a rate of φ where φ has no meaning.
    """
    if vertical(theta) and phi_dot:
        raise RigidtopError(
            f"at theta = {theta:g} phi has no meaning: phi_dot must be 0, not {phi_dot:g}"
        )
    start = {"theta": theta, "phi": phi, "theta_dot": theta_dot, "phi_dot": phi_dot}
    return HeavyTop(**top).motion(**start, omega3=omega3)


def facts_of_motion(motion: TopMotion, theta: float, theta_dot: float, **more: Any) -> Facts:
    """The same, the rates at the start, in {rates}, and where θ turns, in {first} and {last}."""
    first, last = motion.turning_points
    rates = r"$\dot\theta = {theta_dot}$ and $\dot\phi = {phi_dot}$ rad/s"
    if vertical(theta):
        unit = " rad/s" if theta_dot else ""
        rates = rf"$\dot\theta = {{theta_dot}}${unit}, where $\phi$ has no meaning"
    facts = {"rates": rates, "theta_dot": theta_dot, "regime": motion.regime}
    return facts_of(motion.body, **{**facts, "first": first, "last": last, **more})
