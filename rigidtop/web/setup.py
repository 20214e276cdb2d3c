"""What the page starts from: a body and its state at t = 0, and what to look at."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from rigidtop.errors import RigidtopError
from rigidtop.motion.attitude import (
    azimuth_and_spin,
    polar_angle,
    quaternions,
    rotation,
    spinors,
    to_nodes,
)
from rigidtop.motion.body import FreeBody, HeavyBody
from rigidtop.motion.motion import Motion
from rigidtop.motion.rigid import RigidBody
from rigidtop.motion.top import HeavyTop

HEAVY, FREE = "heavy-top", "free"

ROUNDING = 1e-12
"""Of ω: less is no component."""


@dataclass(frozen=True)
class Setup:
    """A body and its state at t = 0, as `types.d.ts` of the page describes it.

    SI units and radians; with the clock "d" every rate is per day.
    """

    kind: str
    values: Mapping[str, float]
    clock: str = "s"


@dataclass(frozen=True)
class Preset:
    """A setup with a name, with what happens in it, and with what to look at."""

    name: str
    title: str
    about: str
    setup: Setup
    layers: tuple[str, ...]
    shape: str
    view: str = "space"
    speed: float = 1.0
    """Units of the clock for each second that passes."""


def heavy(
    body: RigidBody, M: float, g: float, centre: tuple[float, float, float], **state: float
) -> Setup:
    """A heavy body; the state is that of `HeavyTop.motion`, 0 where it is not given.

    `friction` at the pivot is its torque over ω (J s).
    """
    moments = {f"lambda{k + 1}": moment for k, moment in enumerate(body.moments)}
    where = {"M": M, "g": g, "R1": centre[0], "R2": centre[1], "R": centre[2]}
    names = ("friction", "theta", "theta_dot", "phi", "phi_dot", "psi", "omega3")
    return Setup(HEAVY, moments | where | {name: state.get(name, 0.0) for name in names})


def free(
    moments: tuple[float, float, float], omega: tuple[float, float, float], clock: str = "s"
) -> Setup:
    """A free body whose L is along ẑ at the start."""
    values = {f"lambda{k + 1}": moment for k, moment in enumerate(moments)}
    return Setup(FREE, values | {f"omega{k + 1}": w for k, w in enumerate(omega)}, clock)


def body_of(setup: Setup) -> RigidBody:
    """The body of a setup; raises RigidtopError where there is none."""
    values = setup.values
    moments = values["lambda1"], values["lambda2"], values["lambda3"]
    if setup.kind == FREE:
        return FreeBody(*moments)
    centre = values["R1"], values["R2"], values["R"]
    if moments[0] == moments[1] and centre[:2] == (0.0, 0.0) and centre[2] >= 0:
        return HeavyTop(
            lambda1=moments[0], lambda3=moments[2], M=values["M"], R=centre[2], g=values["g"]
        )
    return HeavyBody(*moments, M=values["M"], centre_of_mass=centre, g=values["g"])


def setup_of(motion: Motion) -> Setup:
    """The setup from which the page computes the same motion."""
    body = motion.body
    theta, phi, psi = _angles(motion)
    if isinstance(body, FreeBody):
        setup = free(body.moments, motion.omega)
        return Setup(FREE, {**setup.values, "theta": theta, "phi": phi, "psi": psi})
    if isinstance(body, HeavyTop):
        centre = (0.0, 0.0, body.R)
    elif isinstance(body, HeavyBody):
        centre = body.centre_of_mass
    else:
        raise RigidtopError(f"the page knows free and heavy bodies, no {type(body).__name__}")
    theta_dot, v_phi = to_nodes(*motion.omega[:2], psi)
    # At a pole φ̇ is nothing: ω has no component along e₁′.
    sine = 0.0 if theta == math.pi else math.sin(theta)
    return heavy(
        body,
        body.M,
        body.g,
        centre,
        theta=theta,
        theta_dot=theta_dot,
        phi=phi,
        phi_dot=v_phi / sine if sine else 0.0,
        psi=psi,
        omega3=motion.omega[2],
    )


def _angles(motion: Motion) -> tuple[float, float, float]:
    """θ, φ, ψ at t = 0; of a vertical body those that it has as soon as it moves."""
    q = quaternions(motion.attitude)
    alpha, beta = spinors(q)
    theta = float(polar_angle(alpha, beta))
    phi, psi = motion.initial.angles
    _, v_phi = to_nodes(*motion.omega[:2], psi)
    if theta in (0.0, math.pi) and abs(v_phi) > ROUNDING * math.hypot(*motion.omega):
        vertical = np.where([theta == 0, theta > 0, theta > 0, theta == 0], q, 0.0)
        phi, psi = azimuth_and_spin(rotation(vertical), motion.omega)
    return theta, phi, psi
