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
    "vertical-trap", "With the wrong sign “$ẑ$” points as far beyond $e₃$ as $e₃$ is from $ẑ$."
)


@exercise(
    "vertical-in-primed-frame",
    "The vertical in the primed frame",
    section="3.3",
    asks="exercise before (3.42)",
    statement="After the first two Euler rotations, by $φ$ and by $θ$, the axes of the body "
    "are those of the primed frame. Write the vertical $ẑ$ in them. A sign is easily lost "
    "here: how far from the vertical does the vector point that has it wrong?",
    claims=(vertical, vertical_trap),
    parameters=(
        Parameter("phi", 0.7, "azimuth of $e₃$", "rad"),
        Parameter("theta", pi / 6, "$θ$, polar angle of $e₃$", "rad", least=0, most=pi),
    ),
    figure="euler-angles",
    text="exercises/vertical_in_primed_frame",
)
def vertical_in_primed_frame(phi: float, theta: float) -> Iterator[Outcome]:
    """The two turns, made one after the other, give the axes of the table. Beside their components
    along $ẑ$ stands what the formula has for these."""
    first = Rotation.from_rotvec([0.0, 0.0, phi])
    second = Rotation.from_rotvec(theta * first.apply([0.0, 1.0, 0.0]))
    axes = (second * first).apply(np.eye(3))
    yield Table(
        "axes",
        "The axes in space components, and $ẑ$ along them",
        ("axis", "$x$", "$y$", "$z$", "$ẑ$ by the formula"),
        tuple(
            (name, *map(float, axis), along)
            for name, axis, along in zip(
                ("$e₁′$", "$e₂′$", "$e₃$"), axes, (-sin(theta), 0.0, cos(theta)), strict=True
            )
        ),
    )
    right = cos(theta) * axes[2] - sin(theta) * axes[0]
    wrong = cos(theta) * axes[2] + sin(theta) * axes[0]
    yield Answer("along_e1p", "component of $ẑ$ along $e₁′$", -sin(theta))
    yield Answer("along_e3", "component of $ẑ$ along $e₃$", cos(theta))
    yield Answer(
        "angle_of_wrong_sign",
        "angle between $ẑ$ and $cos θ e₃ + sin θ e₁′$",
        atan2(float(np.hypot(*wrong[:2])), float(wrong[2])),
        "rad",
    )
    error = float(np.linalg.norm(right - [0.0, 0.0, 1.0]))
    yield Measure("$cos θ e₃ − sin θ e₁′$ against $ẑ$, with SciPy's rotations", error, 1e-14)


azimuth_near_the_upright = Claim(
    "azimuth-near-the-upright", "Where $φ̇$ of (3.45) has a pole, $φ̇ + ψ̇$ has none."
)


MISSES = (0.1, 0.03, 0.01, 0.003, 0.001)
"""By how much L_z differs from L₃, relative, in tops that pass the upright ever closer."""


@exercise(
    "azimuthal-rate",
    "The rate of $φ$ from two momenta",
    section="3.3",
    asks="“with a few technical steps you can derive” (3.45)",
    statement="Derive $φ̇$ from $L_z$ and $L₃$. Take a heavy top, whose $L_z$ and $L₃$ do not "
    "change, and "
    "compare (3.45) with the rate at which the axis of the computed motion really goes "
    "round.\n\nWhat does $φ̇$ do when the axis comes close to the vertical? Let $L_z$ be almost "
    "$L₃$, as it must be for that, and look at the smallest $θ$.",
    claims=(azimuthal_rate, azimuth_near_the_upright),
    parameters=(
        Parameter("theta", pi / 6, "$θ$ at the start", "rad", above=0, most=3.1),
        Parameter("phi_dot", 1.0, "$φ̇$ at the start", "rad/s"),
        SPIN,
        *HEAVY_TOP,
    ),
    figure="motion",
    text="exercises/azimuthal_rate",
)
def azimuth_of_a_motion(
    theta: float, phi_dot: float, omega3: float, **shape: float
) -> Iterator[Outcome]:
    """The motion is integrated over one nutation without Euler angles, by $𝐞̇₃ = 𝛚 × e₃$; the
    azimuth of the axis then changes at the rate $(xẏ − yẋ)/(x² + y²)$, where $x$ and $y$ are the
    horizontal components of $e₃$. The tops that pass the vertical closely start on their way up,
    with the $φ̇$ of their $L_z$ and with the $θ̇$ of a top that falls from the upright without
    spin, which is enough for all of them."""
    if omega3 == 0:
        raise RigidtopError("omega3 must not be 0: L_z/L₃ says how closely a spinning top passes")
    top = heavy_top(**shape)
    motion = top.motion(theta=theta, phi_dot=phi_dot, omega3=omega3)
    spin = top.lambda3 * omega3
    vertical_momentum = top.lambda1 * phi_dot * sin(theta) ** 2 + spin * cos(theta)
    yield Answer("L_z", "$L_z$, conserved", vertical_momentum, "J s")
    yield Answer("L_3", "$L₃$, conserved", spin, "J s")

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
        ("$t$ (s)", "$θ$ (rad)", "$φ̇$ by (3.45) (rad/s)", "$φ̇$ seen (rad/s)"),
        tuple(zip(*(map(float, c) for c in (times, path.theta, by_momenta, seen)), strict=True)),
    )
    largest = float(np.abs(seen).max()) or 1.0
    error = float(np.abs(by_momenta - seen).max()) / largest
    yield Measure("$φ̇$ by (3.45) against the azimuth of $e₃$, relative", error, 1e-8)

    yield Answer(
        "at_the_upright", "$φ̇ → L₃/(2λ₁)$ for $L_z = L₃$", spin / (2 * top.lambda1), "rad/s"
    )
    passes = tuple(_pass(top, theta, omega3, miss) for miss in MISSES)
    yield Table(
        "near_the_upright",
        "Tops that pass the upright closely",
        ("$L_z/L₃ − 1$", "smallest $θ$ (rad)", "$φ̇$ there (rad/s)", "$θ φ̇$ there (rad/s)"),
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
