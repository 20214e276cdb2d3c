"""The spin and the weight of a heavy symmetric top, from its angles at some times."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.integrate import cumulative_trapezoid

from rigidtop.motion import attitude as attitudes
from rigidtop.motion.attitude import Floats
from rigidtop.motion.exact import heavy, heavy_orbit
from rigidtop.motion.least_squares import Fit, FitModel
from rigidtop.motion.motion import Motion
from rigidtop.motion.top import HeavyTop


class TopFit(Fit[Motion]):
    """The fit of a heavy symmetric top; its `motion` has λ₁ = 1 and M = 1."""

    @property
    def spin(self) -> float:
        """The spin λ₃ω₃/λ₁ that fits best (rad/s)."""
        return self.values["spin"]

    @property
    def weight(self) -> float:
        """The weight MgR/λ₁ that fits best (1/s²)."""
        return self.values["weight"]


GRAVITY = 9.81
"""g of the top that is made (m/s²); only MgR counts."""

NUTATES = (
    "λ₃ω₃/λ₁ and MgR/λ₁ cannot be known from this: a top that nutates explains the angles hardly "
    "better than a steady precession, which tells one relation of both"
)


def _lines(columns: list[Floats], wanted: Floats) -> Floats:
    """Factors of columns, and of 1, by linear least squares."""
    parts = np.stack([*columns, np.ones_like(wanted)], axis=-1)
    return np.asarray(np.linalg.lstsq(parts, wanted, rcond=None)[0], dtype=float)


@dataclass(frozen=True, eq=False)
class TopModel(FitModel[Motion]):
    """λ₃ω₃/λ₁, MgR/λ₁, θ, θ̇, φ and φ̇ sin θ at the first time; with ψ measured ω₃ and ψ too."""

    unknown = NUTATES

    theta: Floats
    phi: Floats
    psi: Floats | None

    @property
    def measured(self) -> dict[str, Floats]:
        angles = {"theta/rad": self.theta, "phi/rad": self.phi, "psi/rad": self.psi}
        return {name: angle for name, angle in angles.items() if angle is not None}

    @property
    def groups(self) -> list[int]:
        return [*range(len(self.measured))]

    def start(self, parameters: Floats) -> heavy_orbit.HeavyStart:
        """What a motion starts from, each (P, 1)."""
        b, mu, theta, v_theta, phi, v_phi, *turning = (x[:, None] for x in parameters.T)
        omega3, psi = turning or (b, 0 * b)
        cos_half, sin_half, _ = attitudes.of_polar_angle(np.clip(theta, 1e-9, math.pi - 1e-9), np)
        return heavy_orbit.HeavyStart(
            abs(mu), b, omega3, cos_half, sin_half, v_theta, v_phi, phi, psi
        )

    def computed(self, parameters: Floats, rows: Any) -> Floats:
        state = heavy.solve(self.start(parameters)).at(self.t[rows])
        names = [name.partition("/")[0] for name in self.measured]
        return np.stack(np.broadcast_arrays(*(getattr(state, x) for x in names)), axis=-1)

    def starts(self) -> list[Floats]:
        """First parameters from φ̇ sin²θ + b cos θ = a and θ̈'s equation, integrated in time."""
        t, sine, cosine = self.t, np.sin(self.theta), np.cos(self.theta)

        def summed(values: Floats, over: Floats = t) -> Floats:
            return cumulative_trapezoid(values, over, initial=0)

        a, b, _ = _lines([t, -summed(cosine)], summed(sine**2, self.phi))
        starts = []
        for factor in (1.0, 0.5, 0.0, 2.0, -1.0):
            rate = (a - b * cosine * factor + b * (factor - 1) * cosine.mean()) / sine**2
            part = summed(summed(sine * rate * (cosine * rate - b * factor)))
            mu, v_theta, theta = _lines([summed(summed(sine)), t], self.theta - part)
            start = [b * factor, mu, theta, v_theta, self.phi[0], rate[0] * sine[0]]
            if self.psi is not None:
                start += [_lines([t], self.psi + summed(cosine, self.phi))[0], self.psi[0]]
            starts.append(np.array(start))
        return starts

    def telling(self, parameters: Floats) -> Floats:
        spin, weight = np.abs(parameters[:2])
        return np.array([spin + math.sqrt(weight), weight])

    def motion(self, parameters: Floats, values: dict[str, float], since: float) -> Motion:
        share = values.get("lambda3/lambda1", 1.0)
        top = HeavyTop(
            lambda1=1.0,
            lambda3=share,
            M=1.0,
            R=values["weight"] / GRAVITY,
            g=GRAVITY,
            physical=False,
        )
        state = heavy.solve(self.start(parameters[None])).at(np.array(-since))
        names = ("theta", "theta_dot", "phi", "phi_dot", "psi", "omega3")
        return top.motion(**{name: np.asarray(getattr(state, name)).item() for name in names})

    def quantities(self, parameters: Floats) -> dict[str, Floats]:
        names = ("spin", "weight", "theta", "theta_dot", "phi", "v_phi", "omega3", "psi")
        values = dict(zip(names, parameters.T, strict=False)) | {"weight": np.abs(parameters[:, 1])}
        if self.psi is not None:
            values["lambda3/lambda1"] = values["spin"] / values["omega3"]
        return values

    def still(self) -> Floats:
        """The residuals of a steady precession, one column for each angle."""
        columns = [self.theta - self.theta.mean()]
        for angle in (self.phi, self.psi):
            if angle is not None:
                rate, first = _lines([self.t], angle)
                columns.append(angle - rate * self.t - first)
        return np.stack(columns, axis=-1)
