"""Section 3.2.2: about which axes a free body rotates stably, and the flip about the middle one."""

from __future__ import annotations

from collections.abc import Iterator
from math import acosh, log, pi, sqrt

import numpy as np
from scipy.special import ellipkm1

from rigidtop.derivations.eulers_equations import axis_stability, principal_stays
from rigidtop.errors import RigidtopError
from rigidtop.motion.body import FreeBody
from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Exercise, Outcome, Table, exercise
from rigidtop.proof.page import Claim, Measure

flip_time = Claim(
    "flip-time",
    r"The time in which $\omega$ turns over about the middle axis is an elliptic integral.",
)


def flip_measured(moments: tuple[float, float, float], spin: float, kick: float) -> Measure:
    """The time of the claim against a motion of the product, to errors relative to the kick."""
    seconds = flip_seconds(moments, spin, kick)
    motion = FreeBody(*moments).motion(omega=(kick, spin, 0.0))
    path = motion.integrate([seconds / 2, seconds], rtol=1e-13, atol=1e-15 * kick / spin)
    error = float(np.abs(path.omega[:, 1] + [0.0, spin]).max()) / spin
    return Measure(
        r"$\omega_2$ after half of that time and at its end over $\omega$, integrated", error, 1e-9
    )


def flip_seconds(moments: tuple[float, float, float], spin: float, kick: float) -> float:
    """The time (s) from ω = (kick, spin, 0) to ω = (kick, −spin, 0), in rad/s."""
    m1, rate = flip_constants(moments, spin, kick)
    return 2 * float(ellipkm1(m1)) / rate


def flip_constants(
    moments: tuple[float, float, float], spin: float, kick: float
) -> tuple[float, float]:
    """1 − m and ν (1/s) of the claim.

    Not m: K is infinite at m = 1, and a small kick would be lost in the difference.
    """
    i1, i2, i3 = moments
    kicked, spinning = i1 * (i3 - i1) * kick**2, i2 * (i3 - i2) * spin**2
    nu = sqrt((i2 - i1) * (kicked + spinning) / (i1 * i2 * i3))
    return kicked / (kicked + spinning), nu


@exercise(
    "stable-axes",
    "Which axes are stable, and the flip about the middle one",
    section="3.2.2",
    asks="assignment 5",
    statement=r"A body with three different moments $\lambda_1 < \lambda_2 < \lambda_3$, thrown in "
    r"the air, turns with the same speed $\omega$ about one principal axis after the "
    r"other. Show that a small kick makes $\boldsymbol\omega$ oscillate about two of the "
    "axes and run away from the third. How fast does it oscillate, how fast run away?\n\n"
    r"About the middle axis, and with a kick that adds a small $\omega_1$, how long does "
    r"it take until $\boldsymbol\omega$ is well away from the axis? In the end the body "
    "turns over: how long does one flip take, and after what time is "
    r"$\boldsymbol\omega$ in the body what it was?",
    claims=(principal_stays, axis_stability, flip_time),
    parameters=(
        Parameter("lambda1", 1.0, r"$\lambda_1$, the smallest moment", "kg m²", above=0),
        Parameter("lambda2", 1.7, r"$\lambda_2$, the middle moment", "kg m²", above=0),
        Parameter("lambda3", 2.3, r"$\lambda_3$, the largest moment", "kg m²", above=0),
        Parameter("omega", 6.0, "spin about the axis", "rad/s", above=0),
        Parameter("kick", 0.006, r"$\omega_1$ that the kick adds", "rad/s", above=0),
    ),
    figure="flip",
    text="exercises/stable_axes",
)
def stable_axes(
    lambda1: float, lambda2: float, lambda3: float, omega: float, kick: float
) -> Iterator[Outcome]:
    """Growth rates and frequencies are those of (3.36), linearised about each axis. The time of a
    flip is a complete elliptic integral; an integrated motion turns over in the same time."""
    moments = (lambda1, lambda2, lambda3)
    if not lambda1 < lambda2 < lambda3:
        raise RigidtopError(
            f"the moments must grow, lambda1 < lambda2 < lambda3, not {lambda1:g}, {lambda2:g}, "
            f"{lambda3:g}"
        )
    if not 1e-8 * omega <= kick < omega:
        raise RigidtopError(
            f"kick must be less than omega = {omega:g} and at least 1e-08 of it, not {kick:g}"
        )
    body = FreeBody(*moments)
    growths = [_growth_squared(moments, axis) * omega**2 for axis in range(3)]
    rows = []
    for axis, growth in enumerate(growths):
        rate = sqrt(abs(growth))
        kind, time = ("runs away", 1 / rate) if growth > 0 else ("oscillates", 2 * pi / rate)
        rows.append((rf"$\mathbf e_{axis + 1}$", moments[axis], kind, rate, time))
    yield Table(
        "axes",
        "A small kick: rate of growth and time to grow by the factor e, or frequency and period",
        ("axis", r"moment (kg $\mathrm m^2$)", r"$\boldsymbol\omega$", "rate (1/s)", "time (s)"),
        tuple(rows),
    )
    rate = sqrt(growths[1])
    seconds = flip_seconds(moments, omega, kick)
    part, _ = flip_constants(moments, omega, kick)
    yield Answer(
        "growth_rate",
        r"rate $\sigma$ at which $\boldsymbol\omega$ leaves the middle axis",
        rate,
        "1/s",
    )
    yield Answer(
        "time_to_leave",
        r"time until $\omega_1$ is $\omega$ if it grows as $\cosh\sigma t$",
        acosh(omega / kick) / rate,
        "s",
    )
    yield Answer(
        "flip_time",
        r"time of one flip, from $\omega$ to $-\omega$ about $\mathbf e_2$",
        seconds,
        "s",
    )
    yield Answer(
        "period", r"time until $\boldsymbol\omega$ in the body is what it was", 2 * seconds, "s"
    )
    yield Answer(
        "flip_estimate",
        r"the flip for a small kick, ($2/\sigma$) $\ln(4/\sqrt{1 - m})$, for comparison",
        2 / rate * log(4 / sqrt(part)),
        "s",
    )
    motion = body.motion(omega=(kick, omega, 0.0))
    yield Measure(
        "flip by the closed form of the motion, relative",
        abs(motion.nutation_period / seconds - 1),
        1e-12 * lambda3 / min(lambda2 - lambda1, lambda3 - lambda2),
    )
    yield flip_measured(moments, omega, kick)
    # A kick that is small even against the differences of the moments.
    gap = min(lambda2 - lambda1, lambda3 - lambda2) / lambda3
    for axis in (0, 2):
        spin = [1e-5 * gap * omega * (k == (axis + 1) % 3) + omega * (k == axis) for k in range(3)]
        period = 2 * body.motion(omega=spin).nutation_period
        yield Measure(
            rf"period about $\mathbf e_{axis + 1}$ by the closed form, relative",
            abs(period * sqrt(-growths[axis]) / (2 * pi) - 1),
            1e-8,
        )


def _growth_squared(moments: tuple[float, float, float], axis: int) -> float:
    """σ²/ω² of a deviation from rotation about an axis."""
    i, j, k = (moments[(axis + shift) % 3] for shift in range(3))
    return (i - j) * (k - i) / (j * k)


EXERCISES: tuple[Exercise, ...] = (stable_axes,)
