"""What a motion is at given times."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from rigidtop.motion import attitude
from rigidtop.motion.attitude import Floats
from rigidtop.motion.rows import Rows
from rigidtop.motion.start import Moving
from rigidtop.motion.state import TopState, spinning


class Trajectory(Rows):
    """A motion at N times, one row each, in the order in which they were asked for."""

    motion: Moving
    """The motion that it belongs to, with its body and its initial state."""

    t: Floats
    """Times, shape (N,), in s."""

    @property
    @abstractmethod
    def rotation(self) -> Rotation:
        """Attitudes, N of them: body components to space components."""

    @property
    @abstractmethod
    def omega(self) -> Floats:
        """Rotational velocity in body components, shape (N, 3), in rad/s."""

    @property
    def omega_space(self) -> Floats:
        """Rotational velocity in space components, shape (N, 3), in rad/s."""
        return self.rotation.apply(self.omega)

    @property
    def angular_momentum(self) -> Floats:
        """L = Iω in space components, shape (N, 3), in J s, about the point of the moments."""
        return self.rotation.apply(self.omega * np.array(self.motion.body.moments))

    @property
    def e3(self) -> Floats:
        """The figure axis in space components, shape (N, 3)."""
        return self.rotation.as_matrix()[:, :, 2]

    @property
    def vertical(self) -> Floats:
        """ẑ in body components, shape (N, 3)."""
        return self.rotation.as_matrix()[:, 2, :]

    @property
    def energy(self) -> Floats:
        """½ Σ λₖωₖ² + Mg × (height of the centre of mass above the pivot), shape (N,), in J."""
        body = self.motion.body
        # No matrix product, whose last digit depends on how its rows lie in the memory.
        kinetic = (self.omega**2 * body.moments).sum(axis=1) / 2
        energy: Floats = kinetic + self.vertical @ np.array(body.weight)
        return energy

    def columns(self) -> dict[str, Floats]:
        """t, ω in the body, e₃ and the energy."""
        columns = {"t/s": self.t}
        columns |= {f"omega{k + 1}/(rad/s)": self.omega[:, k] for k in range(3)}
        columns |= {f"e3_{axis}": self.e3[:, k] for k, axis in enumerate("xyz")}
        return columns | {"energy/J": self.energy}

    def conserved(self) -> Mapping[str, Floats]:
        """What the exact motion keeps: the energy, and L (free) or L_z, called p_φ (heavy)."""
        if any(self.motion.body.weight):
            return {"energy": self.energy, "p_phi": self.angular_momentum[:, 2]}
        return {"energy": self.energy, "angular_momentum": self.angular_momentum}

    def drift(self) -> dict[str, float]:
        """The largest changes of the conserved quantities from their values at t = 0.

        Each is relative: the energy to T₀ + MgR, a momentum to √(2λ(T₀ + MgR)) with the largest
        moment λ, which no |L| of a body with that kinetic energy exceeds.  T₀ is the kinetic energy
        at t = 0.  For a body at rest without weight, where both would be zero, they are 1 J and
        1 J s.  For L the change of the vector counts, not that of its length.
        """
        energy, momentum = self.scales
        initial = self.motion.start().conserved()
        drifts = {}
        for name, values in self.conserved().items():
            change = (values - initial[name]).reshape(len(self.t), -1)
            scale = energy if name == "energy" else momentum
            # Relative before it is squared: no overflow.
            drifts[name] = float(np.linalg.norm(change / scale, axis=1).max())
        return drifts

    @property
    def scales(self) -> tuple[float, float]:
        """What a drift of the energy (J) and of a momentum (J s) is relative to: see `drift`."""
        body = self.motion.body
        kinetic = float(np.dot(body.moments, np.square(self.motion.omega))) / 2
        energy = kinetic + float(np.linalg.norm(body.weight))
        # As a product of roots it does not overflow.
        return energy or 1.0, float(np.sqrt(2 * max(body.moments)) * np.sqrt(energy)) or 1.0


@dataclass(frozen=True, eq=False, repr=False)
class BodyTrajectory(Trajectory):
    """The motion of any body, known by its quaternion and ω."""

    motion: Moving
    t: Floats

    quaternion: Floats
    """Unit quaternions, scalar first, shape (N, 4), body to space."""

    body_rates: Floats
    """ω in body components, shape (N, 3), rad/s."""

    @cached_property
    def rotation(self) -> Rotation:
        return attitude.rotation(self.quaternion)

    @property
    def omega(self) -> Floats:
        return self.body_rates


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class TopTrajectory(TopState, Trajectory):
    """The motion of a symmetric top, with its Euler angles, of shape (N,).

    φ and ψ are continuous in t, from the values at t = 0 that the motion was given: they count
    turns.  Only a top whose axis goes exactly through the vertical makes φ jump by ±π there, and ψ
    by ∓π at the upright (φ + ψ does not jump) or by ±π hanging (φ − ψ does not).  In closed form
    the jumps take turns; in an integrated motion rounding decides the signs.
    """

    motion: Moving
    t: Floats

    __repr__ = Rows.__repr__

    @cached_property
    def rotation(self) -> Rotation:
        return attitude.rotation(self.quaternion)

    @cached_property
    def omega(self) -> Floats:
        return super().omega

    @property
    def euler_columns(self) -> dict[str, Floats]:
        """t, the Euler angles and their rates, by name and unit."""
        angles = ("theta", "phi", "psi")
        columns = {"t/s": self.t} | {f"{name}/rad": getattr(self, name) for name in angles}
        return columns | {f"{name}_dot/(rad/s)": getattr(self, f"{name}_dot") for name in angles}

    def columns(self) -> dict[str, Floats]:
        """t, the Euler angles, their rates and the energy."""
        return self.euler_columns | {"energy/J": self.energy}

    @property
    def p_phi(self) -> Floats:
        """Momentum conjugate to φ (3.55), which is L_z, shape (N,), in J s."""
        return self.angular_momentum[:, 2]

    @property
    def p_psi(self) -> Floats:
        """Momentum conjugate to ψ (3.56), which is L₃, shape (N,), in J s."""
        lambda3: float = self.motion.body.lambda3
        return lambda3 * self.omega[:, 2]

    def conserved(self) -> Mapping[str, Floats]:
        """The conserved quantities by name: the energy, p_φ and p_ψ."""
        return {"energy": self.energy, "p_phi": self.p_phi, "p_psi": self.p_psi}


def _sampled(name: str) -> cached_property[Floats]:
    return cached_property(lambda self: self.samples(name))


class SampledTop(TopTrajectory):
    """The closed form at many times: what is asked for is taken from `samples`, by its name."""

    samples: Callable[[str], Floats]

    def __init__(self, motion: Moving, times: Floats, samples: Callable[[str], Floats]) -> None:
        values = {"motion": motion, "t": times, "samples": samples}
        for name, value in (values | spinning(motion.body, motion.omega[2])).items():
            object.__setattr__(self, name, value)

    def __reduce__(self) -> tuple[Any, ...]:
        """What a copy is made of: the samples themselves, computed."""
        computed = {
            name: getattr(self, name)
            for name, value in vars(SampledTop).items()
            if isinstance(value, cached_property)
        }
        return SampledTop, (self.motion, self.t, computed.__getitem__)

    cos_half = _sampled("cos_half")
    sin_half = _sampled("sin_half")
    phi = _sampled("phi")
    psi = _sampled("psi")
    theta_dot = _sampled("theta_dot")
    v_phi = _sampled("v_phi")
    theta = _sampled("theta")
    phi_dot = _sampled("phi_dot")
    psi_dot = _sampled("psi_dot")
