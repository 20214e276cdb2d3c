"""Rigid bodies with any three moments: free, or heavy with one point held."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike
from scipy.spatial.transform import Rotation

from rigidtop.errors import RigidtopError
from rigidtop.motion import checks, inertia
from rigidtop.motion.motion import Motion
from rigidtop.motion.rigid import RigidBody, Triple
from rigidtop.motion.start import InitialState


@dataclass(frozen=True)
class AnyBody(RigidBody):
    """A body with three moments (kg m²)."""

    lambda1: float
    lambda2: float
    lambda3: float

    @property
    def moments(self) -> Triple:
        return self.lambda1, self.lambda2, self.lambda3

    @property
    def axes(self) -> Rotation:
        """Where the principal axes stand at t = 0 unless a motion is told."""
        return Rotation.identity()

    def motion(self, omega: Sequence[float], attitude: Rotation | None = None) -> Motion:
        """The motion from ω in body components (rad/s) and an attitude, body to space.

        The attitude at t = 0 is the identity (e₃ upright) unless given; of a body by `from_inertia`
        it is its `attitude`.  Raises RigidtopError if
        `omega` is not three finite numbers or `attitude` not a single rotation.

        >>> brick = HeavyBody(3.0, 2.0, 1.5, M=1.0, centre_of_mass=(0.2, 0.3, 0.4))
        >>> run = brick.motion(omega=(1.0, 2.0, 3.0)).integrate([0.0, 5.0])
        >>> all(change < 1e-9 for change in run.drift().values())
        True
        """
        start = self.axes if attitude is None else attitude
        return Motion(self, InitialState(start, checks.vector("omega", omega)))


@dataclass(frozen=True)
class FreeBody(AnyBody):
    """A body without torque; moments about its centre of mass (kg m²).

    `physical=False` lets moments through that no body has, as benchmarks use them.

    >>> FreeBody(2.0, 2.0, 1.0).motion(omega=(0.1, 0.0, 3.0)).integrate(1.0).omega.round(6)
    array([[ 0.007074, -0.099749,  3.      ]])
    >>> FreeBody(1.0, 1.0, 3.0)
    Traceback (most recent call last):
    ...
    rigidtop.errors.RigidtopError: lambda3 = 3 exceeds the sum of the other two moments, 2: no \
body has such moments about its centre of mass (physical=False lets them through)
    """

    # A float too, so that numbers by name, as figures have them, may be all arguments.
    physical: bool | float = field(default=True, repr=False, compare=False)

    attitude: Rotation = field(
        default_factory=Rotation.identity, init=False, repr=False, compare=False
    )
    """Principal components to those of the axes in which the body was described."""

    @classmethod
    def from_inertia(cls, I: ArrayLike, physical: bool = True) -> FreeBody:  # noqa: E741
        """The body with an inertia tensor: its principal moments, and its axes as its `attitude`.

        `I` is the tensor about the centre of mass, shape (3, 3), in kg m², with the products of
        inertia as they stand in it, I₁₂ = −∫xy dm.  `attitude` takes components along the principal
        axes, in which ω and the moments are, to those of the tensor: I = R diag(λ) Rᵀ.  The axes
        are right-handed, each numbered and directed as the nearest of the tensor's.

        Raises RigidtopError for a tensor that is not symmetric, whose moments are not positive, or,
        unless `physical` is False, one of which exceeds the sum of the other two.

        >>> body = FreeBody.from_inertia([[2.0, 0.6, 0.0], [0.6, 1.1, 0.0], [0.0, 0.0, 3.0]])
        >>> np.round(body.moments, 12), f"{np.degrees(body.attitude.magnitude()):.6f}°"
        (array([2.3, 0.8, 3. ]), '26.565051°')
        >>> body.motion(omega=body.attitude.inv().apply([0.1, 2.0, 0.0])).regime
        'long axis'
        """
        moments, axes = inertia.principal(I)
        body = cls(*moments, physical=physical)
        object.__setattr__(body, "attitude", axes)
        return body

    @property
    def axes(self) -> Rotation:
        return self.attitude

    def __post_init__(self) -> None:
        checks.settle(self, checks.positive, "lambda1", "lambda2", "lambda3")
        if checks.truth("physical", self.physical) and not checks.triangle(
            self.moments, max(self.moments)
        ):
            largest = int(np.argmax(self.moments))
            rest = sum(self.moments) - self.moments[largest]
            raise RigidtopError(
                f"lambda{largest + 1} = {self.moments[largest]:g} exceeds the sum of the other two "
                f"moments, {rest:g}: no body has such moments about its centre of mass"
                f"{checks.UNPHYSICAL}"
            )

    @property
    def weight(self) -> Triple:
        return 0.0, 0.0, 0.0


@dataclass(frozen=True)
class HeavyBody(AnyBody):
    """A body with one point held, in uniform gravity g ≥ 0 along −ẑ (m/s²).

    λ₁, λ₂, λ₃ are the moments about the pivot (kg m²) along principal axes there; `centre_of_mass`
    is (R₁, R₂, R₃), from the pivot, along the same axes (m); M is the mass (kg).

    Raises RigidtopError for moments that no such body can have: those about the centre of mass,
    λ − M(R² − R⊗R), must obey the triangle inequality; `physical=False` lets others through.
    """

    M: float
    centre_of_mass: Triple
    g: float = 9.81
    # A float too, so that numbers by name, as figures have them, may be all arguments.
    physical: bool | float = field(default=True, repr=False, compare=False)

    def __post_init__(self) -> None:
        checks.settle(self, checks.positive, "lambda1", "lambda2", "lambda3", "M")
        checks.settle(self, checks.not_negative, "g")
        checks.settle(self, checks.vector, "centre_of_mass")
        arm = np.array(self.centre_of_mass)
        shift = self.M * (arm @ arm * np.eye(3) - np.outer(arm, arm))
        central = np.linalg.eigvalsh(np.diag(self.moments) - shift)
        if checks.truth("physical", self.physical) and not checks.triangle(
            central.tolist(), max(self.moments)
        ):
            sizes = ", ".join(f"{moment:.4g}" for moment in central)
            raise RigidtopError(
                f"the moments about the centre of mass would be {sizes}, the largest more than the "
                "sum of the other two: larger moments about the pivot or a nearer centre of mass"
                f"{checks.UNPHYSICAL}"
            )

    @property
    def weight(self) -> Triple:
        first, second, third = (self.M * self.g * arm for arm in self.centre_of_mass)
        return first, second, third
