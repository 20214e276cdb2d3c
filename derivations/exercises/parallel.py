"""Section 3.5.2: L beside ω, for a weak torque."""

from __future__ import annotations

from collections.abc import Iterator
from math import atan, atan2, cos, hypot, pi, sin, sqrt

import numpy as np
from scipy.optimize import minimize_scalar

from rigidtop.derivations.simplified_picture import parallel
from rigidtop.errors import RigidtopError
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Exercise, Outcome, Table, exercise
from rigidtop.proof.page import Claim, Measure

from .bodies import HEAVY_TOP, SPIN, angles, heavy_top, simple_rate, smallness

bound_on_the_axis = Claim(
    "bound-on-the-axis",
    r"A top released with $\boldsymbol\omega$ along $\mathbf e_3$ keeps "
    r"$|\omega_\perp| \leq 2\Omega \sin\theta$, $\Omega$ of (3.52).",
)


bound_on_the_tilt = Claim(
    "bound-on-the-tilt",
    r"Where it is lowest, $(1 - 4\varepsilon_0 \cos\theta_i) \sin^2\theta < \sin^2\theta_i$.",
)


bound_on_the_angle = Claim(
    "bound-on-the-angle",
    r"The tangent of the angle between $\mathbf L$ and $\boldsymbol\omega$ is at most "
    r"$2\varepsilon_0|1 - \lambda_3/\lambda_1|\sin\theta$ at all times.",
)


mean_of_the_cusps = Claim(
    "mean-of-the-cusps",
    r"To first order in $\varepsilon_0$ the mean precession of a released top is (3.52) times "
    r"$1 + \varepsilon_0 \cos\theta_i$.",
)


def bound_of_angle(top: HeavyTop, start: float, spin: float) -> float:
    """No angle between L and ω of a top released at θ = `start` with ω along e₃ exceeds this (rad).

    sin θ ≤ 1 besides, where the spin is too low for the bound on the tilt.
    """
    weak = smallness(top, spin)
    narrowed = 1 - 4 * weak * cos(start)
    sine = min(1.0, sin(start) / sqrt(narrowed)) if narrowed > 0 else 1.0
    return atan(2 * weak * abs(1 - top.lambda3 / top.lambda1) * sine)


def fastest_across(top: HeavyTop, theta: float, omega3: float) -> float:
    """The largest |ω⊥| of a top released at θ with ω along e₃: at its lowest point (rad/s)."""
    if sin(theta) == 0:
        return 0.0  # nothing disturbs it
    weak = smallness(top, omega3)
    # δ = 2ε₀ sin²θ there, with cos θ = cos θᵢ − δ; without differences of large numbers.
    linear, torque = 1 - 4 * weak * cos(theta), 4 * weak * sin(theta)
    root = hypot(linear, torque)
    sunk = torque * sin(theta) / (root + linear) if linear > 0 else (root - linear) / (4 * weak)
    return sqrt(2 * top.weight[2] * sunk / top.lambda1)


def largest_angle(top: HeavyTop, theta: float, omega3: float) -> float:
    """The largest angle between L and ω of a top released at θ with ω along e₃ (rad).

    Its tangent |λ₁ − λ₃| |ω₃| |ω⊥|/(λ₁ω⊥² + λ₃ω₃²) grows up to λ₁ω⊥² = λ₃ω₃². A fast top stays
    below that: its angle is largest where it is lowest. A slow top comes past it on its way.
    """
    across = min(fastest_across(top, theta, omega3), sqrt(top.lambda3 / top.lambda1) * abs(omega3))
    crossed = abs((top.lambda1 - top.lambda3) * omega3) * across
    return atan2(crossed, top.lambda1 * across**2 + top.lambda3 * omega3**2)


def widest_on_the_way(motion: TopMotion) -> float:
    """The largest angle between L and ω in space on the way down, integrated (rad)."""

    def missing(time: float) -> float:
        path = motion.integrate(time, rtol=1e-12, atol=1e-14)
        return -float(angles(path.angular_momentum, path.omega_space)[0])

    down = motion.nutation_period / 2
    # The angle has one maximum on the way, or is largest at its end.
    found = minimize_scalar(
        missing, bounds=(0.0, down), method="bounded", options={"xatol": 1e-12 * down}
    )
    return max(-float(found.fun), -missing(down))


DOUBLINGS = 8


@exercise(
    "parallel-bound",
    r"How nearly $\mathbf L$ is parallel to $\boldsymbol\omega$",
    section="3.5.2",
    asks="“this would have to be shown”",
    statement=r"A top is released at the angle $\theta$, spinning about $\mathbf e_3$, so that at "
    r"first $\mathbf L$ and $\boldsymbol\omega$ are parallel. Show that for a weak "
    "torque they stay nearly so: find a bound on the angle between them, for all times, "
    "in terms of $\\varepsilon_0 = \\lambda_1MgR/(\\lambda_3\\omega_3)^2$.\n\nHow good "
    "is the bound? Double the spin again and again, and compare with the largest angle "
    "of the exact motion. How good is (3.52) for the mean precession?",
    claims=(parallel, bound_on_the_axis, bound_on_the_tilt, bound_on_the_angle, mean_of_the_cusps),
    parameters=(
        Parameter("theta", pi / 6, r"$\theta$ at the start", "rad", above=0, most=3.1),
        SPIN,
        *HEAVY_TOP,
    ),
    figure="parallel",
    text="exercises/parallel_bound",
)
def parallel_bound(theta: float, omega3: float, **shape: float) -> Iterator[Outcome]:
    r"""A fast top has its largest angle between $\mathbf L$ and $\boldsymbol\omega$ at its
    lowest point, a slow one on the way there. This angle and the mean precession are those of
    the exact motion, which an integrated one confirms. In place of $\sin\theta$ the bound of the
    table has what bounds it, $\sin\theta_i/\sqrt{1 - 4\varepsilon_0 \cos\theta_i}$."""
    top = heavy_top(**shape)
    if omega3 == 0:
        raise RigidtopError(
            "omega3 must not be 0: without spin the top topples, and ε₀ is infinite"
        )
    if top.lambda1 == top.lambda3:
        raise RigidtopError("lambda1 and lambda3 must differ: with equal moments L is along ω")

    def compared(spin: float) -> tuple[float, ...]:
        weak, bound = smallness(top, spin), bound_of_angle(top, theta, spin)
        largest = largest_angle(top, theta, spin)
        mean = top.motion(theta=theta, omega3=spin).mean_precession
        off = mean / simple_rate(top, spin) - 1
        return spin, weak, bound, largest, largest / bound, mean, off, off / weak

    rows = tuple(compared(omega3 * 2**k) for k in range(DOUBLINGS))
    _, weak, bound, largest, share, mean, off, _ = rows[0]
    yield Answer("epsilon_0", r"$\varepsilon_0$", weak)
    yield Answer(
        "bound", r"no angle between $\mathbf L$ and $\boldsymbol\omega$ exceeds", bound, "rad"
    )
    yield Answer("largest", "the largest angle is", largest, "rad")
    yield Answer("share", "the largest angle over the bound", share)
    yield Answer("simple", r"$\Omega$ by (3.52)", simple_rate(top, omega3), "rad/s")
    yield Answer("mean", "mean precession", mean, "rad/s")
    yield Answer("off", "by how much it exceeds (3.52), relative", off)
    yield Answer(
        "off_first_order",
        r"$\varepsilon_0 \cos\theta_i$, the same to first order",
        weak * cos(theta),
    )
    yield Table(
        "spins",
        "The spin doubled again and again",
        (
            r"$\omega_3$ (rad/s)",
            r"$\varepsilon_0$",
            "bound (rad)",
            "largest angle (rad)",
            "their ratio",
            r"mean $\dot\phi$ (rad/s)",
            "excess over (3.52)",
            r"$\text{excess}/\varepsilon_0$",
        ),
        rows,
    )

    above = max(row[4] for row in rows) - 1
    yield Measure("by how much any angle of the table exceeds its bound", max(above, 0.0), 1e-9)
    motion = top.motion(theta=theta, omega3=omega3)
    yield Measure(
        r"the largest angle against that of $\mathbf L$ and $\boldsymbol\omega$ in space, "
        "integrated (rad)",
        abs(widest_on_the_way(motion) - largest),
        1e-11,
    )
    lowest = motion.turning_points[1]
    path = motion.integrate(motion.nutation_period / 2, rtol=1e-12, atol=1e-14)
    across = float(np.hypot(*path.omega[0, :2]))
    yield Measure(
        r"$|\omega_\perp|$ at the lowest point against $2\Omega \sin\theta$ there, relative",
        abs(across / (2 * top.weight[2] * sin(lowest) / abs(top.lambda3 * omega3)) - 1),
        1e-8,
    )


EXERCISES: tuple[Exercise, ...] = (parallel_bound,)
