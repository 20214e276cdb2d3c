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
    """A path about e₃ that starts with ω₁ = `a1`, ω₂ = 0 and ω₃ = `a3` (rad/s)."""

    body: FreeBody
    a1: float
    a3: float

    @classmethod
    def pushed(cls, body: FreeBody, a2: float, push: float) -> Path:
        """That on which ω = (0, a₂, δ) lies, by (1.6) and (1.7)."""
        first, middle, third = body.moments
        a1 = a2 * math.sqrt(middle * (third - middle) / (first * (third - first)))
        ratio = middle * (middle - first) / (third * (third - first))
        return cls(body, a1, math.sqrt(ratio * a2**2 + push**2))

    @property
    def a2(self) -> float:
        """The largest ω₂ (rad/s), by (1.6)."""
        first, middle, third = self.body.moments
        return self.a1 * math.sqrt(first * (third - first) / (middle * (third - middle)))

    @property
    def p(self) -> float:
        """(3.2), in 1/s."""
        first, middle, third = self.body.moments
        return self.a3 * math.sqrt((third - first) * (third - middle) / (first * middle))

    @property
    def rest(self) -> float:
        """1 − m, by (3.3)."""
        first, middle, third = self.body.moments
        inner, outer = first * (middle - first), third * (third - middle)
        return 1 - inner * self.a1**2 / (outer * self.a3**2)

    @property
    def period(self) -> float:
        """(3.4), in s.  Raises RigidtopError for a path that is not about e₃."""
        if self.rest <= 0:
            raise RigidtopError("this path is not about e3: a larger a3 or a smaller a1 is wanted")
        return 4 * float(ellipkm1(self.rest)) / self.p

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
