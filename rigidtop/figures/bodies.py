"""The bodies of the figures, and the parameters that say which."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any, TypeVar

from matplotlib.axes import Axes
from scipy.optimize import brentq

from rigidtop.errors import RigidtopError
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.rigid import SymmetricTop
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter

T = TypeVar("T")

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


def facts_of(top: SymmetricTop, **more: Any) -> dict[str, Any]:
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


def has_phi(theta: float, phi_dot: float) -> None:
    """Raises RigidtopError for a rate of φ where φ has no meaning."""
    if vertical(theta) and phi_dot:
        raise RigidtopError(
            f"at theta = {theta:g} phi has no meaning: phi_dot must be 0, not {phi_dot:g}"
        )


def rates_in_words(theta: float, theta_dot: float = 0.0) -> str:
    """θ̇ = … and φ̇ = …, for a caption; without φ̇ where φ has no meaning."""
    if vertical(theta):
        unit = " rad/s" if theta_dot else ""
        return rf"$\dot\theta = {{theta_dot}}${unit}, where $\phi$ has no meaning"
    return r"$\dot\theta = {theta_dot}$ and $\dot\phi = {phi_dot}$ rad/s"
