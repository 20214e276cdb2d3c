"""What a symmetric top is doing, at one time or at many, one top or many."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from rigidtop.motion import attitude
from rigidtop.motion.attitude import Floats
from rigidtop.motion.exact.numbers import Arrays, Kit, Real
from rigidtop.motion.start import AnyStart
from rigidtop.motion.systems import SMALLEST_SIZE

CHANGING = ("cos_half", "sin_half", "phi", "psi", "theta_dot", "v_phi")
"""What of a state is not constant."""


@dataclass(frozen=True, eq=False)
class TopState:
    """Attitude and rates of symmetric tops: arrays of one shape S, or such as broadcast to it.

    R = Rz(φ) Ry(θ) Rz(ψ).  Half angles and the components of ė₃ are known to all their digits near
    the vertical too, where φ̇ and the digits of θ close to π are not.
    """

    cos_half: Floats
    """cos(θ/2) ≥ 0."""

    sin_half: Floats
    """sin(θ/2) ≥ 0."""

    phi: Floats
    """Azimuth of e₃ (rad)."""

    psi: Floats
    """Turn about e₃ (rad)."""

    theta_dot: Floats
    """θ̇, the component of ω along e₂′ (rad/s)."""

    v_phi: Floats
    """φ̇ sin θ, minus the component of ω along e₁′ (3.42) (rad/s)."""

    omega3: Floats
    """ω₃ (rad/s)."""

    upright_phi_dot: Floats
    """λ₃ω₃/(2λ₁): the limit of φ̇ where e₃ goes through the upright; minus that, hanging (rad/s)."""

    @property
    def theta(self) -> Floats:
        """Polar angle of e₃ in [0, π] (rad)."""
        return 2 * np.arctan2(self.sin_half, self.cos_half)

    @cached_property
    def _rates(self) -> tuple[Floats, Floats]:
        with np.errstate(all="ignore"):
            return rates(Arrays, self)

    @property
    def phi_dot(self) -> Floats:
        """φ̇ (rad/s).  Exactly at θ = 0 or π it is the limit along a motion through it."""
        return self._rates[0]

    @property
    def psi_dot(self) -> Floats:
        """ψ̇ = ω₃ − φ̇ cos θ (rad/s)."""
        return self._rates[1]

    @property
    def quaternion(self) -> Floats:
        """Unit quaternions, scalar first, body to space, shape (*S, 4)."""
        return attitude.from_spinors(self.cos_half, self.sin_half, self.phi, self.psi)

    @property
    def omega(self) -> Floats:
        """Rotational velocity in body components, shape (*S, 3) (rad/s)."""
        first, second = attitude.from_nodes(self.theta_dot, self.v_phi, self.psi, np)
        return np.stack([first, second, np.broadcast_to(self.omega3, first.shape)], axis=-1)


def spinning(body: Real, omega3: Real) -> dict[str, Real]:
    """What of a state ω₃ tells, of a body with λ₁ and λ₃."""
    upright = body.lambda3 * omega3 / (2 * body.lambda1)
    return {"omega3": np.asarray(omega3), "upright_phi_dot": np.asarray(upright)}


def rates(k: Kit, state: Real) -> tuple[Real, Real]:
    """φ̇ and ψ̇, of the numbers of a kit."""
    c, s = state.cos_half, state.sin_half
    sine, cosine = 2 * s * c, (c - s) * (c + s)
    phi_dot = k.over(state.v_phi, sine)
    if k.any(sine == 0):
        limit = k.copysign(1.0, c - s) * state.upright_phi_dot
        phi_dot = k.where(sine == 0, limit, phi_dot)
    return phi_dot, state.omega3 - phi_dot * cosine


def of_numbers(numbers: Sequence[float]) -> TopState:
    """One state, from numbers in the order of its fields: in arrays of one element."""
    *changing, omega3, upright = numbers
    columns = [*(np.array([x]) for x in changing), np.array(omega3), np.array(upright)]
    return TopState(*columns)


def of_start(start: AnyStart, body: Real) -> TopState:
    """The state at t = 0, of a body with λ₁ and λ₃."""
    omega3 = start.omega[2]
    upright = body.lambda3 * omega3 / (2 * body.lambda1)
    return of_numbers((*start.halves, *start.angles, *start.rates, omega3, upright))


def of_frame(states: Floats, angles: Floats, turn: Floats, spin: Mapping[str, Floats]) -> TopState:
    """From q, ω₁ and ω₂ (6, N), and φ and ψ that count turns (2, N), in a frame that follows e₃.

    The body turns in it by `turn`, and `spin` is what `spinning` tells.
    """
    phi, psi = angles
    alpha, beta = attitude.spinors(attitude.units(states).T)
    product = alpha * beta.conj()
    size = np.abs(product)
    # cos ψ + i sin ψ; where the attitude has no ψ, the one that counts.
    nodes = np.divide(product, size, out=np.exp(1j * psi), where=size > SMALLEST_SIZE)
    omega1, omega2 = states[4:6]
    return TopState(
        cos_half=np.abs(alpha),
        sin_half=np.abs(beta),
        phi=phi,
        psi=psi + turn,
        theta_dot=omega1 * nodes.imag + omega2 * nodes.real,
        v_phi=omega2 * nodes.imag - omega1 * nodes.real,
        **spin,
    )
