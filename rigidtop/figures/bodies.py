"""The bodies of the figures, and the parameters that say which."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TypeVar

from matplotlib.axes import Axes

from rigidtop.errors import RigidtopError
from rigidtop.figures.style import degrees, said
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

THETA = Parameter("theta", math.pi / 3, "$θ$ at the start", "rad", least=0, most=math.pi)
SPIN = Parameter("omega3", 40.0, "$ω₃$", "rad/s", above=0)


def of_top(told: Callable[..., T]) -> Callable[..., T]:
    """What takes all parameters by name, from what takes a heavy top and those that `TOP` has not.

    Axes stand before both.
    """
    names = [parameter.name for parameter in TOP]

    def of_all(*axes: Axes, **values: float) -> T:
        return told(*axes, HeavyTop(**{name: values.pop(name) for name in names}), **values)

    return of_all


def top_in_words(top: SymmetricTop) -> str:
    """λ₁ = …, λ₃ = …, MgR = …."""
    return (
        f"$λ₁ = {said(top.lambda1)}$ kg m², $λ₃ = {said(top.lambda3)}$ kg m² and "
        f"$MgR = {said(top.M * top.g * top.R)}$ J"
    )


def start_in_words(theta: float, omega3: float) -> str:
    """θ = … and ω₃ = …."""
    return f"$θ = {degrees(theta)}$ and $ω₃ = {said(omega3)}$ rad/s"


def vertical(theta: float) -> bool:
    """Whether e₃ is upright or straight down, where φ has no meaning."""
    return theta in (0.0, math.pi)


def has_phi(theta: float, phi_dot: float) -> None:
    """Raises RigidtopError for a rate of φ where φ has no meaning."""
    if vertical(theta) and phi_dot:
        raise RigidtopError(
            f"at theta = {theta:g} phi has no meaning: phi_dot must be 0, not {phi_dot:g}"
        )


def rates_in_words(theta: float, phi_dot: float, theta_dot: float = 0.0) -> str:
    """θ̇ = … and φ̇ = …; without φ̇ where φ has no meaning."""
    if vertical(theta):
        unit = " rad/s" if theta_dot else ""
        return f"$θ̇ = {said(theta_dot)}{unit}$, where $φ$ has no meaning"
    return f"$θ̇ = {said(theta_dot)}$ and $φ̇ = {said(phi_dot)}$ rad/s"
