"""Section 3.5.2: a top without spin."""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, pi, sin, sqrt

import numpy as np
from scipy.special import elliprf

from rigidtop.derivations.simplified_picture import toppling
from rigidtop.errors import RigidtopError
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Exercise, Outcome, exercise
from rigidtop.proof.page import Claim, Measure

from .bodies import ARM, GRAVITY, LAMBDA1, MASS

time_to_fall = Claim(
    "time-to-fall",
    r"A top let go at $\theta_i$ at rest takes the time of an elliptic integral to fall.",
)


def fall(top: HeavyTop, start: float, end: float) -> tuple[float, float]:
    """The time (s) from rest at θ = `start` to `end` ≥ `start` (rad), and θ̇ then (rad/s)."""
    slowest = sqrt(top.lambda1 / top.weight[2])
    fallen = sin((end - start) / 2) * sin((end + start) / 2)  # cos²(θᵢ/2) − cos²(θ/2)
    # K(m) − F(χ, m) = F(β, m) with tan β = cot χ/√(1 − m) (DLMF 19.11.7), in Carlson's form
    # (19.25.5), which keeps its digits for a top that is let go close to the upright.
    across = (sin(start / 2) * cos(end / 2)) ** 2
    sine2, cosine2 = fallen / (fallen + across), across / (fallen + across)
    legendre = sqrt(sine2) * elliprf(cosine2, cosine2 + sin(start / 2) ** 2 * sine2, 1.0)
    return slowest * float(legendre), 2 * sqrt(fallen) / slowest


@exercise(
    "toppling-top",
    "The toppling top",
    section="3.5.2",
    asks="example 34",
    statement=r"A top leans at the angle $\theta$ and is let go without any rotation, so that "
    r"$\mathbf L = 0$. How does $\mathbf L$ evolve, and what motion is this? How long "
    "does the top take to fall to the final angle, and how fast does it fall then? "
    "Compare with the time that exponential growth, which holds for small angles, would "
    "give.",
    claims=(toppling, time_to_fall),
    parameters=(
        Parameter("theta", pi / 18, r"$\theta$ at the start", "rad", above=0, most=pi),
        Parameter("until", pi / 2, r"final $\theta$", "rad", above=0, most=pi),
        LAMBDA1,
        MASS,
        ARM,
        GRAVITY,
    ),
    figure="toppling",
    text="exercises/toppling_top",
)
def toppling_top(
    theta: float, until: float, lambda1: float, M: float, R: float, g: float
) -> Iterator[Outcome]:
    """The time is this elliptic integral, and the speed follows from the energy."""
    if until <= theta:
        raise RigidtopError(f"until = {until:g} must be more than theta = {theta:g}: the top falls")
    # λ₃ plays no part: that of a body with three equal moments about its centre of mass.
    top = HeavyTop(lambda1=lambda1, lambda3=lambda1 - M * R**2, M=M, R=R, g=g)
    seconds, rate = fall(top, theta, until)
    growth = sqrt(top.weight[2] / lambda1)
    yield Answer(
        "growth_rate", r"growth rate $\sigma = \sqrt{MgR/\lambda_1}$ of a small tilt", growth, "1/s"
    )
    yield Answer("time_to_fall", r"time until $\theta$ has its final value", seconds, "s")
    yield Answer("theta_dot", r"$\dot\theta$ then", rate, "rad/s")
    yield Answer("angular_momentum", r"$L$ then, along $\mathbf e_2'$", lambda1 * rate, "J s")
    yield Answer(
        "time_linear",
        r"time by $\theta = \theta_i \cosh\sigma t$, for comparison",
        float(np.arccosh(until / theta)) / growth,
        "s",
    )

    moved = top.motion(theta=theta, omega3=0.0).exact(seconds)
    yield Measure(
        r"$\theta$ at that time, in closed form (rad)", abs(float(moved.theta[0]) - until), 1e-9
    )


EXERCISES: tuple[Exercise, ...] = (toppling_top,)
