"""The moments of a free body, from its ω or its attitudes at some times."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from itertools import permutations
from typing import Any

import numpy as np
from scipy.integrate import cumulative_trapezoid
from scipy.spatial.transform import Rotation

from rigidtop.errors import RigidtopError
from rigidtop.motion import attitude as attitudes
from rigidtop.motion import inertia
from rigidtop.motion.attitude import Floats
from rigidtop.motion.body import FreeBody
from rigidtop.motion.exact import free
from rigidtop.motion.least_squares import Fit, FitModel
from rigidtop.motion.motion import Motion

SHAPE = (1.0, 1.6, 2.2)
"""Moments of other starts, in every order."""


class FreeFit(Fit[Motion]):
    """The fit of a free body; L and E are in units in which the moments are the `values`."""

    @property
    def lambda1(self) -> float:
        """λ₁: the smallest moment is 1 unless one was given."""
        return self.values["lambda1"]

    @property
    def lambda2(self) -> float:
        """The principal moment λ₂ that fits best."""
        return self.values["lambda2"]

    @property
    def lambda3(self) -> float:
        """The principal moment λ₃ that fits best."""
        return self.values["lambda3"]


TUMBLES = (
    "the moments cannot be known from this: a body that tumbles explains ω hardly better than a "
    "constant ω, as where the spin is along a principal axis or the three moments are equal"
)


@dataclass(frozen=True, eq=False)
class FreeModel(FitModel[Motion]):
    """log λ of what is not given, ω at the first time, the sensor's turn, the first attitude."""

    unknown = TUMBLES

    omega: Floats | None
    attitude: Rotation | None
    given: tuple[float | None, ...]
    turned: bool

    @cached_property
    def held(self) -> tuple[float | None, ...]:
        """Moments that are not parameters: with none of them known, the last is a unit."""
        return self.given if any(self.given) else (None, None, 1.0)

    @cached_property
    def unit(self) -> float:
        """What the moments are relative to: the first that is held."""
        return next(held for held in self.held if held is not None)

    @property
    def measured(self) -> dict[str, Floats]:
        columns: dict[str, Floats] = {}
        if self.omega is not None:
            columns |= {f"omega{k + 1}/(rad/s)": self.omega[:, k] for k in range(3)}
        if self.attitude is not None:
            columns |= {f"turn{k + 1}/rad": np.zeros(len(self.t)) for k in range(3)}
        return columns

    @property
    def groups(self) -> list[int]:
        return [int(name.startswith("turn")) for name in self.measured]

    @cached_property
    def rates(self) -> tuple[Floats, Floats]:
        """Times and ω: measured, or mean rates between two attitudes."""
        if self.omega is not None:
            return self.t, self.omega
        assert self.attitude is not None
        between = (self.attitude[:-1].inv() * self.attitude[1:]).as_rotvec()
        return (self.t[1:] + self.t[:-1]) / 2, between / np.diff(self.t)[:, None]

    @cached_property
    def tensor(self) -> Floats:
        """The tensor by least squares from Iω + ∫ω × Iω dt = const, in the sensor's axes."""
        t, omega = self.rates
        pairs = [(k, k) for k in range(3)] + [(0, 1), (0, 2), (1, 2)] * self.turned
        basis = []
        for row, column in pairs:
            each = np.zeros((3, 3))
            each[row, column] = each[column, row] = 1.0 if row == column else math.sqrt(0.5)
            basis.append(each)
        columns = []
        for each in basis:
            momentum = omega @ each
            torque = np.cross(omega, momentum)
            whole = momentum + cumulative_trapezoid(torque, t, axis=0, initial=0)
            columns.append((whole - whole.mean(axis=0)).ravel())
        parts = np.linalg.svd(np.stack(columns, axis=-1), full_matrices=False)[2][-1]
        tensor = np.tensordot(parts, basis, axes=1)
        return np.asarray(tensor * np.sign(np.trace(tensor) or 1.0))

    @cached_property
    def guess(self) -> tuple[Floats, Rotation]:
        """Moments and axes of that tensor, or of a ball where it has a moment below zero."""
        try:
            moments, axes = inertia.principal(self.tensor)
        except RigidtopError:
            return np.ones(3), Rotation.identity()
        return np.array(moments), axes if self.turned else Rotation.identity()

    def starts(self) -> list[Floats]:
        shapes = [self.guess[0], *map(np.array, permutations(SHAPE))]
        first = self.guess[1].inv().apply(self.rates[1][0])
        rest = np.zeros(3 * (self.turned + (self.attitude is not None)))
        free_ones = [held is None for held in self.held]
        return [
            np.concatenate([np.log(shape / shape[free_ones.index(False)])[free_ones], first, rest])
            for shape in shapes
        ]

    def parts(self, parameters: Floats) -> tuple[Floats, Floats, Rotation, Floats]:
        """Moments (P, 3), ω (P, 3), the turns from principal axes to the sensor's, and the rest."""
        logs = iter(parameters.T)
        moments = [
            np.exp(np.clip(next(logs), -9, 9)) * self.unit
            if held is None
            else np.full(len(parameters), held)
            for held in self.held
        ]
        rest = parameters[:, self.held.count(None) :]
        turn = rest[:, 3:6] if self.turned else np.zeros((len(rest), 3))
        axes = self.guess[1] * Rotation.from_rotvec(turn)
        return np.stack(moments, axis=-1), rest[:, :3], axes, rest[:, 3 + 3 * self.turned :]

    def computed(self, parameters: Floats, rows: Any) -> Floats:
        moments, omega, axes, rest = self.parts(parameters)
        one, two, three = (x[:, None] for x in moments.T)
        state = free.solve((one, two, three), tuple(x[:, None] for x in omega.T)).at(self.t[rows])
        columns = []
        if self.omega is not None:
            own = np.stack(np.broadcast_arrays(*state.omega), axis=-1)
            columns.append(np.einsum("pij,ptj->pti", axes.as_matrix(), own))
        if self.attitude is not None:
            turns = np.stack(np.broadcast_arrays(*state.quaternion), axis=-1)
            back = attitudes.product(turns, _rows(axes.inv()))
            start = self.attitude[0] * Rotation.from_rotvec(rest) * axes
            there = attitudes.product(_rows(start), back)
            off = attitudes.product(attitudes.quaternions(self.attitude[rows].inv()), there)
            vectors = attitudes.rotation(off.reshape(-1, 4)).as_rotvec()
            columns.append(vectors.reshape(off[..., 1:].shape))
        return np.concatenate(columns, axis=-1)

    def settled(self, parameters: Floats) -> Floats:
        """A turned body has its moments in any order: each axis is the nearest of the sensor's."""
        if not self.turned or any(self.given):
            return parameters
        (moments,), (omega,), axes, rest = self.parts(parameters[None])
        turn = axes.as_matrix()[0]
        nearest, principal = inertia.principal(turn @ np.diag(moments) @ turn.T)
        logs = np.log(np.array(nearest) / nearest[2])[:2]
        rates = principal.inv().apply(turn @ omega)
        return np.concatenate([logs, rates, (self.guess[1].inv() * principal).as_rotvec(), rest[0]])

    def telling(self, parameters: Floats) -> Floats:
        return np.ones(self.held.count(None))

    def motion(self, parameters: Floats, values: dict[str, float], since: float) -> Motion:
        _, omega, axes, rest = self.parts(parameters[None])
        start = axes[0]
        if self.attitude is not None:
            start = self.attitude[0] * Rotation.from_rotvec(rest[0]) * start
        first, second, third = (values[f"lambda{k}"] for k in (1, 2, 3))
        body = FreeBody(first, second, third, physical=False)
        then = body.motion(omega[0], start).exact(-since)
        return body.motion(then.omega[0], then.rotation[0])

    def quantities(self, parameters: Floats) -> dict[str, Floats]:
        moments, omega, axes, _ = self.parts(parameters)
        if not any(self.given):
            moments = moments / moments.min(axis=1, keepdims=True)
        quantities = {f"lambda{k + 1}": moments[:, k] for k in range(3)}
        quantities |= {f"omega{k + 1}": omega[:, k] for k in range(3)}
        if self.turned:
            quantities |= {f"turn{k + 1}": x for k, x in enumerate(axes.as_rotvec().T)}
        momentum = np.linalg.norm(moments * omega, axis=1)
        return quantities | {"L": momentum, "E": (moments * omega**2).sum(axis=1) / 2}

    def still(self) -> Floats:
        """The residuals of a ball, whose ω is constant."""
        columns = []
        mean = self.rates[1].mean(axis=0)
        if self.omega is not None:
            columns.append(self.omega - mean)
        if self.attitude is not None:
            even = Rotation.from_rotvec(np.outer(self.t, mean))
            columns.append((self.attitude.inv() * self.attitude[0] * even).as_rotvec())
        return np.concatenate(columns, axis=-1)


def _rows(rotation: Rotation) -> Floats:
    """The quaternions of P attitudes, shape (P, 1, 4)."""
    return attitudes.quaternions(rotation)[:, None]
