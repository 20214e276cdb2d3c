"""The formulas of the pages in numbers; what they say is confirmed by `rigidtop.FreeBody`."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy.special import ellipkm1

from rigidtop.errors import RigidtopError
from rigidtop.motion.body import FreeBody

Floats: TypeAlias = NDArray[np.float64]


def body(lambda1: float, lambda2: float, lambda3: float) -> FreeBody:
    """A body with these moments.  Raises RigidtopError unless each is larger than the last."""
    if not lambda1 < lambda2 < lambda3:
        raise RigidtopError("the moments are wanted in their order: lambda1 < lambda2 < lambda3")
    return FreeBody(lambda1, lambda2, lambda3)


@dataclass(frozen=True)
class Path:
    """A path about e₃ on which (0, `a2`, `push`) lies (rad/s)."""

    body: FreeBody
    a2: float
    push: float

    @classmethod
    def started(cls, body: FreeBody, a1: float, a3: float) -> Path:
        """That on which (a₁, 0, a₃) lies.  Raises RigidtopError where it is not about e₃."""
        one, two, three = body.moments
        a2 = a1 * math.sqrt(one * (three - one) / (two * (three - two)))  # (1.6)
        square = a3**2 - a2**2 * two * (two - one) / (three * (three - one))  # (1.7)
        if square <= 0:
            raise RigidtopError("this path is not about e3: a larger a3 or a smaller a1 is wanted")
        return cls(body, a2, math.sqrt(square))

    @property
    def a1(self) -> float:
        """ω₁ where ω₂ = 0 (rad/s), by (1.6)."""
        one, two, three = self.body.moments
        return self.a2 * math.sqrt(two * (three - two) / (one * (three - one)))

    @property
    def a3(self) -> float:
        """ω₃ where ω₂ = 0 (rad/s), by (1.7)."""
        one, two, three = self.body.moments
        return math.sqrt(two * (two - one) / (three * (three - one)) * self.a2**2 + self.push**2)

    @property
    def p(self) -> float:
        """(3.2), in 1/s."""
        one, two, three = self.body.moments
        return self.a3 * math.sqrt((three - one) * (three - two) / (one * two))

    @property
    def period(self) -> float:
        """(3.4), in s; 1 − m is k'², the square of δ/a₃."""
        return 4 * float(ellipkm1((self.push / self.a3) ** 2)) / self.p

    def momentum(self, samples: int) -> Floats:
        """The tip of 𝐋 in the body (N, 3) at equal steps of an angle, once round (J s)."""
        angle = np.linspace(0.0, 2 * math.pi, samples)
        moments = np.array(self.body.moments)
        first, second = self.a1 * np.cos(angle), self.a2 * np.sin(angle)
        total = moments[0] ** 2 * self.a1**2 + moments[2] ** 2 * self.a3**2
        third = total - (moments[0] * first) ** 2 - (moments[1] * second) ** 2
        return np.stack([moments[0] * first, moments[1] * second, np.sqrt(third)], axis=1)

    @property
    def solid_angle(self) -> float:
        """∮(1 − cos θ) dβ: a mean over the path, where dβ/dα is L₁(0) L₂(¼) over L₁² + L₂²."""
        x, y, z = self.momentum(4001)[:-1].T
        height = z / math.sqrt(x[0] ** 2 + z[0] ** 2)
        return float(2 * math.pi * np.mean((1 - height) * x.max() * y.max() / (x**2 + y**2)))
