"""Section 3.3: the vertical in the primed frame, and φ̇ from the conserved momenta."""

from __future__ import annotations

from collections.abc import Iterator
from math import atan2, cos, inf, pi, sin, sqrt

import numpy as np
from scipy.spatial.transform import Rotation

from rigidtop.derivations.euler_angles import (
    azimuthal_rate,
    vertical,
)
from rigidtop.errors import RigidtopError
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Exercise, Outcome, Table, exercise
from rigidtop.proof.page import Claim, Measure

from .bodies import HEAVY_TOP, SPIN, heavy_top

vertical_trap = Claim(
    "vertical-trap",
    r"With the wrong sign “$\hat{\mathbf z}$” points as far beyond $\mathbf e_3$ as $\mathbf e_3$ "
    r"is from $\hat{\mathbf z}$.",
)


@exercise(
    "vertical-in-primed-frame",
    "The vertical in the primed frame",
    section="3.3",
    asks="exercise before (3.42)",
    statement=r"After the first two Euler rotations, by $\phi$ and by $\theta$, the axes of the "
    r"body are those of the primed frame. Write the vertical $\hat{\mathbf z}$ in them. "
    "A sign is easily lost here: how far from the vertical does the vector point that "
    "has it wrong?",
    claims=(vertical, vertical_trap),
    parameters=(
        Parameter("phi", 0.7, r"azimuth of $\mathbf e_3$", "rad"),
        Parameter(
            "theta", pi / 6, r"$\theta$, polar angle of $\mathbf e_3$", "rad", least=0, most=pi
        ),
    ),
    figure="euler-angles",
    text="exercises/vertical_in_primed_frame",
)
def vertical_in_primed_frame(phi: float, theta: float) -> Iterator[Outcome]:
    r"""The two turns, made one after the other, give the axes of the table. Beside their
    components along $\hat{\mathbf z}$ stands what the formula has for these."""
    first = Rotation.from_rotvec([0.0, 0.0, phi])
    second = Rotation.from_rotvec(theta * first.apply([0.0, 1.0, 0.0]))
    axes = (second * first).apply(np.eye(3))
    yield Table(
        "axes",
        r"The axes in space components, and $\hat{\mathbf z}$ along them",
        ("axis", "$x$", "$y$", "$z$", r"$\hat{\mathbf z}$ by the formula"),
        tuple(
            (name, *map(float, axis), along)
            for name, axis, along in zip(
                (r"$\mathbf e_1'$", r"$\mathbf e_2'$", r"$\mathbf e_3$"),
                axes,
                (-sin(theta), 0.0, cos(theta)),
                strict=True,
            )
        ),
    )
    right = cos(theta) * axes[2] - sin(theta) * axes[0]
    wrong = cos(theta) * axes[2] + sin(theta) * axes[0]
    yield Answer("along_e1p", r"component of $\hat{\mathbf z}$ along $\mathbf e_1'$", -sin(theta))
    yield Answer("along_e3", r"component of $\hat{\mathbf z}$ along $\mathbf e_3$", cos(theta))
    yield Answer(
        "angle_of_wrong_sign",
        r"angle between $\hat{\mathbf z}$ and $\cos\theta \mathbf e_3 + \sin\theta \mathbf e_1'$",
        atan2(float(np.hypot(*wrong[:2])), float(wrong[2])),
        "rad",
    )
    error = float(np.linalg.norm(right - [0.0, 0.0, 1.0]))
    yield Measure(
        r"$\cos\theta \mathbf e_3 - \sin\theta \mathbf e_1'$ against $\hat{\mathbf z}$, with "
        "SciPy's rotations",
        error,
        1e-14,
    )


azimuth_near_the_upright = Claim(
    "azimuth-near-the-upright",
    r"Where $\dot\phi$ of (3.45) has a pole, $\dot\phi + \dot\psi$ has none.",
)


MISSES = (0.1, 0.03, 0.01, 0.003, 0.001)
"""By how much L_z differs from L₃, relative, in tops that pass the upright ever closer."""


@exercise(
    "azimuthal-rate",
    r"The rate of $\phi$ from two momenta",
    section="3.3",
    asks="“with a few technical steps you can derive” (3.45)",
    statement=r"Derive $\dot\phi$ from $L_z$ and $L_3$. Take a heavy top, whose $L_z$ and $L_3$ do "
    "not change, and compare (3.45) with the rate at which the axis of the computed "
    "motion really goes round.\n\nWhat does $\\dot\\phi$ do when the axis comes close to "
    "the vertical? Let $L_z$ be almost $L_3$, as it must be for that, and look at the "
    r"smallest $\theta$.",
    claims=(azimuthal_rate, azimuth_near_the_upright),
    parameters=(
        Parameter("theta", pi / 6, r"$\theta$ at the start", "rad", above=0, most=3.1),
        Parameter("phi_dot", 1.0, r"$\dot\phi$ at the start", "rad/s"),
        SPIN,
        *HEAVY_TOP,
    ),
    figure="motion",
    text="exercises/azimuthal_rate",
)
def azimuth_of_a_motion(
    theta: float, phi_dot: float, omega3: float, **shape: float
) -> Iterator[Outcome]:
    r"""The motion is integrated over one nutation without Euler angles, by $\dot{\mathbf e}_3 =
    \boldsymbol\omega \times \mathbf e_3$; the azimuth of the axis then changes at the rate
    $(x\dot y - y\dot x)/(x^2 + y^2)$, where $x$ and $y$ are the horizontal components of
    $\mathbf e_3$. The tops that pass the vertical closely start on their way up, with the
    $\dot\phi$ of their $L_z$ and with the $\dot\theta$ of a top that falls from the upright
    without spin, which is enough for all of them."""
    if omega3 == 0:
        raise RigidtopError("omega3 must not be 0: L_z/L₃ says how closely a spinning top passes")
    top = heavy_top(**shape)
    motion = top.motion(theta=theta, phi_dot=phi_dot, omega3=omega3)
    spin = top.lambda3 * omega3
    vertical_momentum = top.lambda1 * phi_dot * sin(theta) ** 2 + spin * cos(theta)
    yield Answer("L_z", "$L_z$, conserved", vertical_momentum, "J s")
    yield Answer("L_3", "$L_3$, conserved", spin, "J s")

    period = motion.nutation_period
    # In an odd number of steps: halfway the axis may be at the vertical, where φ has no rate.
    times = np.linspace(0.0, period if period < inf else sqrt(top.lambda1 / top.weight[2]), 10)
    path = motion.integrate(times, rtol=1e-12, atol=1e-14)
    by_momenta = (vertical_momentum - spin * path.e3[:, 2]) / (
        top.lambda1 * (1 - path.e3[:, 2]) * (1 + path.e3[:, 2])
    )
    moving = np.cross(path.omega_space, path.e3)
    x, y, _ = path.e3.T
    seen = (x * moving[:, 1] - y * moving[:, 0]) / (x**2 + y**2)
    yield Table(
        "nutation",
        "Over one nutation",
        ("$t$ (s)", r"$\theta$ (rad)", r"$\dot\phi$ by (3.45) (rad/s)", r"$\dot\phi$ seen (rad/s)"),
        tuple(zip(*(map(float, c) for c in (times, path.theta, by_momenta, seen)), strict=True)),
    )
    largest = float(np.abs(seen).max()) or 1.0
    error = float(np.abs(by_momenta - seen).max()) / largest
    yield Measure(
        r"$\dot\phi$ by (3.45) against the azimuth of $\mathbf e_3$, relative", error, 1e-8
    )

    yield Answer(
        "at_the_upright",
        r"$\dot\phi \to L_3/(2\lambda_1)$ for $L_z = L_3$",
        spin / (2 * top.lambda1),
        "rad/s",
    )
    passes = tuple(_pass(top, theta, omega3, miss) for miss in MISSES)
    yield Table(
        "near_the_upright",
        "Tops that pass the upright closely",
        (
            "$L_z/L_3 - 1$",
            r"smallest $\theta$ (rad)",
            r"$\dot\phi$ there (rad/s)",
            r"$\theta \dot\phi$ there (rad/s)",
        ),
        passes,
    )


def _pass(top: HeavyTop, theta: float, omega3: float, miss: float) -> tuple[float, ...]:
    """`miss`, the smallest θ of a top that rises with L_z = (1 + miss)L₃, φ̇ there, and θφ̇."""
    spin = top.lambda3 * omega3
    # L_z − L₃ cos θ = L₃ (2 sin²(θ/2) + miss), at the start and at the smallest θ.
    started = spin * (2 * sin(theta / 2) ** 2 + miss) / (top.lambda1 * sin(theta) ** 2)
    rising = -2 * sqrt(top.weight[2] / top.lambda1) * sin(theta / 2)
    motion = top.motion(theta=theta, phi_dot=started, theta_dot=rising, omega3=omega3)
    smallest, _ = motion.turning_points
    there = spin * (2 * sin(smallest / 2) ** 2 + miss) / (top.lambda1 * sin(smallest) ** 2)
    return miss, smallest, there, smallest * there


EXERCISES: tuple[Exercise, ...] = (vertical_in_primed_frame, azimuth_of_a_motion)
