"""Section 3.5.4: the upright top, asleep and awake."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import asin, cos, log, pi, sin, sqrt

import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipkm1

from rigidtop.derivations.nutation import nutation
from rigidtop.errors import RigidtopError
from rigidtop.motion.motion import TopMotion
from rigidtop.motion.top import HeavyTop
from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Exercise, Outcome, Table, exercise
from rigidtop.proof.page import Claim, Measure

from .bodies import HEAVY_TOP, SPIN, heavy_top
from .nutation import TIGHT

RPM = 30 / pi
"""Turns a minute in 1 rad/s."""


upright_potential = Claim(
    "upright-potential",
    r"The upright top is stable if $(\lambda_3\omega_3)^2$ is at least $4\lambda_1MgR$.",
)


waking = Claim("waking", "A top that spins more slowly wakes up to a known tilt, in a known time.")


@dataclass(frozen=True)
class Waking:
    """A top that was upright with ω₃ and is tilted by a disturbance that leaves p_φ = p_ψ."""

    top: HeavyTop
    spin: float
    disturbance: float

    @property
    def phi_dot(self) -> float:
        """φ̇ at which p_φ = p_ψ, where the disturbed top has θ̇ = 0 (rad/s)."""
        turning = self.top.lambda1 * 2 * cos(self.disturbance / 2) ** 2
        return self.top.lambda3 * self.spin / turning

    @property
    def sine2(self) -> float:
        """sin² of half the tilt to which it wakes; less than that of the disturbance: it sleeps."""
        w = self.top.lambda1 * self.top.weight[2]
        ratio = self.top.lambda3 * self.spin / (2 * sqrt(w) * cos(self.disturbance / 2))
        return (1 - ratio) * (1 + ratio)

    @property
    def wakes(self) -> bool:
        return self.sine2 > sin(self.disturbance / 2) ** 2

    @property
    def tilt(self) -> float:
        """θ to which it wakes (rad)."""
        return 2 * asin(sqrt(self.sine2))

    @property
    def growth(self) -> float:
        """σ of a small tilt e^{σt} (1/s)."""
        unstable = 4 * self.top.lambda1 * self.top.weight[2] - (self.top.lambda3 * self.spin) ** 2
        return sqrt(unstable) / (2 * self.top.lambda1)

    @property
    def period(self) -> float:
        """From one smallest θ to the next: 2√(2λ₁/(MgR(1 − cos θ₂))) K(m) (s)."""
        slowness = sqrt(self.top.lambda1 / self.top.weight[2] / self.sine2)
        return 2 * slowness * float(ellipkm1(sin(self.disturbance / 2) ** 2 / self.sine2))

    def motion(self) -> TopMotion:
        return self.top.motion(theta=self.disturbance, phi_dot=self.phi_dot, omega3=self.spin)


@exercise(
    "sleeping-top",
    "The sleeping top, and how it wakes",
    section="3.5.4",
    asks=r"$\theta = 0$ is a value where $\theta$ “could be constant” too",
    statement=r"A top stands upright and spins with $\omega_3$. How fast must it spin for the "
    "upright to be stable? How does a faster top answer a small disturbance?\n\nA slower "
    "top is disturbed by a tiny tilt. How fast does the tilt grow, how far does the axis "
    "fall, and after which time is it back?",
    claims=(nutation, upright_potential, waking),
    parameters=(
        *HEAVY_TOP,
        replace(SPIN, default=6.0),
        Parameter(
            "disturbance", 1e-8, r"$\theta$ of the disturbed top", "rad", least=1e-12, most=0.01
        ),
    ),
    figure="sleeping",
    text="exercises/sleeping_top",
)
def sleeping_top(omega3: float, disturbance: float, **shape: float) -> Iterator[Outcome]:
    """Threshold, growth and tilt follow from these formulas, the time of waking from the complete
    elliptic integral. A motion integrated from the disturbance has the same tilt and the same
    time."""
    top = heavy_top(**shape)
    threshold = top.sleeping_spin()
    waking = Waking(top, omega3, disturbance)
    asleep = abs(omega3) >= threshold
    if not asleep and not waking.wakes:
        raise RigidtopError(
            f"omega3 = {omega3:g} is so close to the sleeping spin {threshold:.12g} that a "
            f"disturbance of {disturbance:g} rad does not show whether the top sleeps"
        )
    yield Answer(
        "sleeping_spin", r"smallest $|\omega_3|$ at which the upright is stable", threshold, "rad/s"
    )
    yield Answer("sleeping_rpm", "the same in turns a minute", threshold * RPM, "rpm")
    yield Measure(
        r"sleeping spin by the curvature of the potential at small $\theta$, relative",
        abs(_curvature_changes(top) / threshold - 1),
        1e-5,
    )
    if asleep:
        yield from _asleep(waking)
    else:
        yield from _awake(waking)
    slower = [Waking(top, share * threshold, disturbance) for share in (0.25, 0.5, 0.75, 0.9, 0.99)]
    yield Table(
        "waking",
        "Slower than the sleeping spin",
        (r"$\omega_3$ (rad/s)", "growth rate (1/s)", "tilt (rad)", "time to the largest tilt (s)"),
        tuple((x.spin, x.growth, x.tilt, x.period / 2) for x in slower if x.wakes),
    )
    faster = [share * threshold for share in (1.01, 1.25, 1.5, 2, 4)]
    yield Table(
        "wobble",
        "Faster than the sleeping spin",
        (r"$\omega_3$ (rad/s)", "slow wobble (rad/s)", "fast wobble (rad/s)"),
        tuple((spin, *top.steady_precession(0.0, spin)) for spin in faster),
    )


def _awake(waking: Waking) -> Iterator[Outcome]:
    motion = waking.motion()
    back = 2 / waking.growth * log(8 * sqrt(waking.sine2) / waking.disturbance)
    yield Answer("growth_rate", r"growth rate $\sigma$ of a small tilt", waking.growth, "1/s")
    yield Answer("tilt", r"$\theta$ to which the top wakes", waking.tilt, "rad")
    yield Answer("period", "time until the tilt is smallest again", waking.period, "s")
    yield Answer(
        "period_log", r"the same by ($2/\sigma$) $\ln(8 \sin(\theta_2/2)/\theta_i)$", back, "s"
    )
    error = abs(motion.turning_points[1] - waking.tilt)
    yield Measure(r"largest $\theta$ of the disturbed top, in closed form (rad)", error, 1e-9)
    error = abs(motion.nutation_period / waking.period - 1)
    yield Measure("its period, in closed form, relative", error, 1e-9)
    path = motion.integrate([waking.period / 2, waking.period], **TIGHT)
    error = abs(float(path.theta[0]) - waking.tilt)
    yield Measure(r"$\theta$ half a period later, integrated (rad)", error, 1e-6)


def _asleep(waking: Waking) -> Iterator[Outcome]:
    slow, fast = waking.top.steady_precession(0.0, waking.spin)
    yield Answer("slow_wobble", "slow frequency of a disturbance", slow, "rad/s")
    yield Answer("fast_wobble", "fast frequency of a disturbance", fast, "rad/s")
    yield Answer("tilt", r"largest $\theta$ of the disturbed top", waking.disturbance, "rad")
    # Not for longer than small differences in frequency stay small differences in angle.
    times = np.linspace(0, min(2 * pi / abs(slow), 60 * pi / abs(fast)), 41)
    path = waking.motion().integrate(times, **TIGHT).theta
    expected = waking.disturbance * np.abs(np.cos((fast - slow) / 2 * times))
    error = float(np.max(np.abs(path - expected))) / waking.disturbance
    allowed = 1e-6 + 100 * waking.disturbance**2
    yield Measure(r"$\theta(t)$ as the sum of both, integrated, relative", error, allowed)


def _curvature_changes(top: HeavyTop) -> float:
    """|ω₃| at which the upright stops being lower in the potential than its neighbours (rad/s)."""
    tilt = 1e-3

    def rise(spin: float) -> float:
        momentum = top.lambda3 * spin
        turning = (momentum * (1 - cos(tilt))) ** 2 / (2 * top.lambda1 * sin(tilt) ** 2)
        return turning - top.weight[2] * (1 - cos(tilt))

    high = 1.0
    while rise(high) < 0:
        high *= 2
    return float(brentq(rise, 0.0, high, rtol=1e-12))


EXERCISES: tuple[Exercise, ...] = (sleeping_top,)
"""In the order of the notes."""
