"""Section 3.5.2: a top without spin."""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, pi, sin, sqrt

import numpy as np
import sympy
from scipy.special import elliprf
from sympy import Expr

from rigidtop.derivations.printed import printed, worked
from rigidtop.derivations.simplified_picture import toppling
from rigidtop.errors import RigidtopError
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Exercise, Outcome, exercise
from rigidtop.proof.page import Evidence, Formal, Measure, Step, claim
from rigidtop.theory import symbols as s
from rigidtop.theory import top as theory
from rigidtop.theory.lagrangian import energy
from rigidtop.theory.trig import reduce_ratio

from .bodies import ARM, GRAVITY, LAMBDA1, MASS


def fall_rate_squared() -> Expr:
    """θ̇² of a top let go at θ_i without rotation, from its energy (rad²/s²)."""
    falling = theory.symmetric_lagrangian().subs({s.phidot: 0, s.psidot: 0})
    gained = energy(falling, [s.thetadot])
    at_rest = gained.subs({s.thetadot: 0, s.theta: s.theta_i})
    square = sympy.Symbol("square")
    [rate] = sympy.solve((gained - at_rest).subs(s.thetadot**2, square), square, simplify=False)
    return rate


@claim(
    "time-to-fall", "A top let go at $θᵢ$ at rest takes the time of an elliptic integral to fall."
)
def time_to_fall() -> Iterator[Evidence]:
    """The energy gives $θ̇$, and the time is the integral of $dθ/θ̇$.

    With $m = cos²(θᵢ/2)$ and $cos(θ/2) = √m sin χ$ it is Legendre's integral of the first kind;
    $χ$ falls from $π/2$ at the start. A pendulum would take as long from $π − θᵢ$ to $π − θ$.
    """
    rate = worked.of("time-to-fall", r"\lambda_1\dot\theta^2")
    legendre = printed(r"(1 - m\sin^2\chi)t^2_\chi = \frac{\lambda_1}{MgR}")
    whole = worked.of("time-to-fall", "t")
    derived = fall_rate_squared()
    yield Formal(rate, {s.thetadot: sympy.sqrt(derived)}, reason="By energy.")
    # cos θ = 2 cos²(θ/2) − 1, at the start and later.
    cosine = 2 * s.m * sympy.sin(s.chi) ** 2 - 1
    against_chi = cosine.diff(s.chi) ** 2 / (1 - cosine**2)
    slope = against_chi / derived.subs(
        {sympy.cos(s.theta): cosine, sympy.cos(s.theta_i): 2 * s.m - 1}
    )
    yield Formal(
        legendre,
        {s.t_chi2: reduce_ratio(slope)},
        reason="$(dθ/dχ)²$ over $θ̇²$ is the square of $dt/dχ$.",
    )
    yield Step(whole, "Integrated from $χ$ to $π/2$.")
    top = HeavyTop(lambda1=1.3, lambda3=0.7, M=0.8, R=0.6)
    start, end = 0.4, 2.5
    seconds, _ = fall(top, start, end)
    fallen = top.motion(theta=start, omega3=0.0).integrate(seconds, rtol=1e-12, atol=1e-14)
    yield Measure("$θ$ at that time, integrated (rad)", abs(float(fallen.theta[0]) - end), 1e-9)


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
    statement="A top leans at the angle $θ$ and is let go without any rotation, so that $L = 0$. "
    "How "
    "does $L$ evolve, and what motion is this? How long does the top take to fall to the angle "
    "“until”, and how fast does it fall then? Compare with the "
    "time that exponential growth, which holds for small angles, would give.",
    claims=(toppling, time_to_fall),
    parameters=(
        Parameter("theta", pi / 18, "$θ$ at the start", "rad", above=0, most=pi),
        Parameter("until", pi / 2, "$θ$ at the end", "rad", above=0, most=pi),
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
    """The elliptic integral is evaluated, and the motion in closed form, another one, is where it
    should be at that time."""
    if until <= theta:
        raise RigidtopError(f"until = {until:g} must be more than theta = {theta:g}: the top falls")
    # λ₃ plays no part: that of a body with three equal moments about its centre of mass.
    top = HeavyTop(lambda1=lambda1, lambda3=lambda1 - M * R**2, M=M, R=R, g=g)
    seconds, rate = fall(top, theta, until)
    growth = sqrt(top.weight[2] / lambda1)
    yield Answer("growth_rate", "growth rate $κ = √(MgR/λ₁)$ of a small tilt", growth, "1/s")
    yield Answer("time_to_fall", "time until $θ$ has the value “until”", seconds, "s")
    yield Answer("theta_dot", "$θ̇$ then", rate, "rad/s")
    yield Answer("angular_momentum", "$L$ then, along $e₂′$", lambda1 * rate, "J s")
    yield Answer(
        "time_linear",
        "time by $θ = θᵢ cosh κt$, for comparison",
        float(np.arccosh(until / theta)) / growth,
        "s",
    )

    moved = top.motion(theta=theta, omega3=0.0).exact(seconds)
    yield Measure(
        "$θ$ at that time, in closed form (rad)", abs(float(moved.theta[0]) - until), 1e-9
    )


EXERCISES: tuple[Exercise, ...] = (toppling_top,)
