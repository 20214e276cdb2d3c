"""The equations of a top on a table: what pushes it, and how it slides, rolls and starts to slip.

The state is (q₀ … q₃, ω₁, ω₂, ω₃, v_x, v_y, χ, X, Y, W_f, W_a): the attitude of the frame that
follows e₃ without turning about it and ω there, the slip v of the contact, the turn χ of the body
about e₃ in that frame, the centre of mass over the table, and what friction and air have
dissipated.  The equations are those of `theory.sliding`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

from rigidtop.errors import RigidtopError
from rigidtop.motion import equations
from rigidtop.motion.attitude import Floats
from rigidtop.motion.equations import Number, Rates

VARIABLES = 14

Direction = tuple[float, float]
NOWHERE: Direction = 0.0, 0.0


@dataclass(frozen=True, kw_only=True)
class Sliding:
    """The numbers of a top with a round tip on a table, in SI units: see `SlidingTop`."""

    lambda1: float
    lambda3: float
    M: float
    R: float
    tip: float = 0.0
    g: float = 9.81
    mu: float = 0.0
    viscosity: float = 0.0
    drag: float = 0.0
    drag1: float = 0.0
    drag3: float = 0.0
    fall: float = math.pi / 2


@dataclass(frozen=True)
class Moment:
    """What a state leads to: its rate, the contact force, the slip's rate, N's divisor."""

    rate: tuple[Number, ...]
    force: tuple[Number, Number, Number]
    slipping: tuple[Number, Number] = (0.0, 0.0)
    divisor: Number = 1.0


class Contact:
    """The equations of one top, of states as floats or as arrays."""

    def __init__(self, body: Sliding) -> None:
        b = body
        drags = b.drag, b.drag1, b.drag3
        shape = b.lambda1, b.lambda3, b.M, b.R, b.tip
        self.body = body
        self.kinematics: Rates = equations.contact_kinematics(
            b.lambda1, b.lambda3, b.M, b.g, b.R, b.tip, *drags
        )
        self._slide: Rates = equations.sliding_force(*shape, b.mu, b.viscosity)
        self._roll: Rates = equations.rolling_force(*shape)
        self._top: Rates = equations.sliding_top(b.lambda1, b.lambda3, b.R, b.tip, *drags)
        self.speed_unit = math.sqrt(b.g * b.R)

    def sliding(self, state: Sequence[Number], direction: tuple[Number, Number]) -> Moment:
        """The rates and the force while it slides in this direction, a unit vector."""
        kinematics = self.kinematics(state[:9])
        axis, velocity, free = kinematics[:3], kinematics[3:6], kinematics[6:]
        solution = self._slide((*axis, *state[7:9], *direction, *free))
        force, slipping = (solution[0], solution[1], solution[2]), (solution[3], solution[4])
        return Moment(self._rate(state, velocity, force, slipping), force, slipping, solution[5])

    def slipping(self, state: Sequence[Number], otherwise: Direction) -> Moment:
        """The same in the direction of the slip, or `otherwise` where there is none."""
        direction: tuple[Number, Number]
        if isinstance(state[7], float):
            speed = math.hypot(state[7], state[8])
            direction = (state[7] / speed, state[8] / speed) if speed else otherwise
        else:
            speed = np.hypot(state[7], state[8])
            divisor = np.where(speed > 0, speed, 1.0)
            direction = (
                np.where(speed > 0, state[7] / divisor, otherwise[0]),
                np.where(speed > 0, state[8] / divisor, otherwise[1]),
            )
        return self.sliding(state, direction)

    def rolling(self, state: Sequence[Number]) -> Moment:
        """The rates and the force while the body rolls without slipping."""
        kinematics = self.kinematics(state[:9])
        axis, velocity, free = kinematics[:3], kinematics[3:6], kinematics[6:]
        solution = self._roll((*axis, *free))
        force = solution[0], solution[1], solution[2]
        return Moment(self._rate(state, velocity, force, (0.0, 0.0)), force)

    def _rate(
        self,
        state: Sequence[Number],
        velocity: Sequence[Number],
        force: Sequence[Number],
        slipping: tuple[Number, Number],
    ) -> tuple[Number, ...]:
        turning = self._top((*state[:9], *velocity, *force))
        return *turning[:7], *slipping, state[6], velocity[0], velocity[1], *turning[7:]

    def holds(self, state: Sequence[float]) -> bool:
        """Whether static friction can hold the contact, which does not slip now."""
        return bool(self.body.mu > 0 and self.reserve(self.rolling(state)) >= 0)

    def reserve(self, rolling: Moment) -> Number:
        """μN − |F| of a contact that rolls."""
        friction_x, friction_y, normal = rolling.force
        return self.body.mu * normal - np.hypot(friction_x, friction_y)

    def struck(self, state: Sequence[float], slip: Direction) -> list[float]:
        """The state after the impulse at the contact that makes the slip what it is to be."""
        kinematics = self.kinematics(state[:9])
        change = slip[0] - state[7], slip[1] - state[8]
        impulse = self._roll((*kinematics[:3], -change[0], -change[1], 0.0))
        still = (0.0,) * 5
        pushed, left = (
            self._top((*state[:7], *still, *force)) for force in (impulse, (0.0, 0.0, 0.0))
        )
        after = list(state)
        for k in (4, 5, 6):
            after[k] += pushed[k] - left[k]
        after[7:9] = slip
        gained = sum(
            (before + now) / 2 * push
            for before, now, push in zip(state[7:9], slip, impulse, strict=False)
        )
        after[12] -= gained
        return after

    def onset(self, state: Sequence[float]) -> Direction:
        """Where a contact that rests but cannot be held starts to slip: v̇ along v.

        Raises RigidtopError where no direction does that.
        """

        def across(angle: float) -> float:
            d = math.cos(angle), math.sin(angle)
            v = self.sliding(state, d).slipping
            return float(d[0] * v[1] - d[1] * v[0])

        # None of these is an axis, along which a top falls that does not spin.
        angles = np.linspace(-math.pi, math.pi, 361) + 0.01
        turning = [across(angle) for angle in angles]
        # Stable where a slip that points a little aside turns back.
        directions = [
            brentq(across, angles[k], angles[k + 1])
            for k in range(len(angles) - 1)
            if turning[k] > 0 >= turning[k + 1]
        ]
        rates = []
        for angle in directions:
            d = math.cos(angle), math.sin(angle)
            v = self.sliding(state, d).slipping
            rates.append((d[0] * v[0] + d[1] * v[1], d))
        fastest, direction = max(rates, default=(0.0, NOWHERE))
        if fastest <= 0:
            raise RigidtopError(
                "friction can neither hold the contact nor let it slip from rest (Painlevé): "
                "the rigid body has no motion there; a smaller mu has"
            )
        return direction


def units(body: Sliding) -> Floats:
    """What the absolute tolerance multiplies, for each variable: 1, √(g/R), R and so on."""
    rate, length = math.sqrt(body.g / body.R), body.R
    speed, energy = rate * length, body.M * body.g * body.R
    return np.array([1.0] * 4 + [rate] * 3 + [speed] * 2 + [1.0] + [length] * 2 + [energy] * 2)
