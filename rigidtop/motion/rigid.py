"""What motions, their closed forms and trajectories need to know of each other."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Any, Protocol

Triple = tuple[float, float, float]


class RigidBody(ABC):
    """What a motion needs to know of a body."""

    @property
    @abstractmethod
    def moments(self) -> Triple:
        """λ₁, λ₂, λ₃ about the point that stays at rest (kg m²)."""

    @property
    @abstractmethod
    def weight(self) -> Triple:
        """Mg (R₁, R₂, R₃) in body components (N m): the potential energy is this · ẑ."""

    @property
    def symmetric(self) -> bool:
        """Whether e₃ is an axis of symmetry, also for the weight; then ω₃ is constant."""
        return self.moments[0] == self.moments[1] and self.weight[:2] == (0.0, 0.0)


class SymmetricTop(RigidBody):
    """A heavy body about whose e₃, through its centre of mass, it is symmetric: see `HeavyTop`."""

    lambda1: float
    lambda3: float
    M: float
    R: float
    g: float

    @abstractmethod
    def smallest_spin(self, theta: float) -> float:
        """The smallest |ω₃| with a steady precession at θ (rad/s)."""

    @abstractmethod
    def sleeping_spin(self) -> float:
        """The smallest |ω₃| at which the upright top is stable (rad/s)."""

    @abstractmethod
    def steady_precession(self, theta: float, omega3: float) -> tuple[float, float]:
        """Both rates φ̇ at which θ stays constant (rad/s)."""


class Moving(Protocol):
    """What a trajectory belongs to."""

    @property
    def body(self) -> Any: ...
    @property
    def omega(self) -> Triple: ...
    def start(self) -> Any:
        """The initial state, as a trajectory of one row."""
