"""What a reader may find with the chapter, confirmed by motions that are integrated."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Outcome, exercise
from rigidtop.proof.page import Claim, Measure


@exercise(
    "hanging",
    "A plate on a nail",
    section="4",
    asks="small swings and over the top",
    statement="A square plate hangs at rest, and a ball joint holds it at the middle of an edge. "
    r"How long does a small swing take in its plane, about $\mathbf e_3$, and how long one across "
    r"it, about $\mathbf e_2$? How fast has it to turn in its plane, at the lowest place, to come "
    "just upright?",
    claims=(
        Claim("4.2", "The pendulum."),
        Claim("4.3", "Upright."),
        Claim("4.4", "In the plane."),
        Claim("4.5", "Across."),
    ),
    parameters=(
        Parameter("M", 0.5, "mass, $M$", "kg", above=0),
        Parameter("R", 0.15, "distance of the centre of mass, $R$", "m", above=0),
        Parameter("lambda2", 0.015, r"moment, $\lambda_2$", "kg m²", above=0),
        Parameter("lambda3", 0.01875, r"moment, $\lambda_3$", "kg m²", above=0),
        Parameter("g", 9.81, "acceleration of gravity, $g$", "m/s²", above=0),
    ),
)
def hanging(M: float, R: float, lambda2: float, lambda3: float, g: float) -> Iterator[Outcome]:
    r"""(4.4) and (4.5) have the frequencies; $\tfrac12\lambda_3\omega_3^2 - MgR = MgR$ by (4.2)
    and (4.3), so that $\omega_3 = 2\nu_3$. The plate is integrated besides."""
    from .top import let_go

    pull, tiny = M * g * R, 1e-3
    flat = lambda3 - lambda2 if lambda3 > lambda2 else lambda2
    moments = flat, lambda2, lambda3
    across, within = math.sqrt(pull / lambda2), math.sqrt(pull / lambda3)
    fastest = 2 * within
    yield Answer("within", "period in the plane", 2 * math.pi / within, "s")
    yield Answer("across", "period across the plane", 2 * math.pi / across, "s")
    yield Answer("fastest", "rate at the lowest place", fastest, "rad/s")
    run = let_go(moments, pull, tiny).integrate([math.pi / within])
    yield Measure("on the other side in the plane (rad)", abs(run.q[0, 2] + tiny), 1e-8)
    run = let_go(moments, pull, 0.0, tilt=tiny).integrate([math.pi / across])
    yield Measure("on the other side across (rad)", abs(run.q[0, 1] - math.pi / 2 + tiny), 1e-8)
    run = let_go(moments, pull, 0.0, (0.0, 0.0, fastest)).integrate([3 / within])
    wrong = abs(run.q[0, 2] - 2 * math.asin(math.tanh(3)))
    yield Measure("a pendulum that only just comes upright (rad)", wrong, 1e-6)


@exercise(
    "lost",
    "Kovalevskaya's integral, kept and lost",
    section="3",
    asks="how fast it goes",
    statement=r"At the start $\mathbf e_3$ is level and $\mathbf e_1$ is at the angle $\chi$ from "
    r"straight below, so that $\gamma_1 = -\cos\chi$, $\gamma_2 = \sin\chi$ and $\gamma_3 = 0$. "
    r"What is $K$ for a top with $\kappa = 2$? And at which rate does $K$ change at the start if "
    r"$\kappa$ is not 2, for the same $\mu$?",
    claims=(Claim("3.4", "Its rate."), Claim("3.6", "The integral.")),
    parameters=(
        Parameter("kappa", 1.8, r"ratio of the moments, $\kappa$", above=0.5, most=100),
        Parameter("mu", 40.0, r"pull, $\mu$", "1/s²", above=0),
        Parameter("chi", 1.0, r"angle at the start, $\chi$", "rad", least=-3.1, most=3.1),
        Parameter("omega1", 5.0, r"$\omega_1$", "rad/s"),
        Parameter("omega2", 2.0, r"$\omega_2$", "rad/s"),
        Parameter("omega3", 8.0, r"$\omega_3$", "rad/s"),
    ),
)
def lost(
    kappa: float, mu: float, chi: float, omega1: float, omega2: float, omega3: float
) -> Iterator[Outcome]:
    r"""(3.6), and (3.4) with $\gamma_1$ and $\gamma_2$ of the start. Both tops are integrated: of
    one $K$ is looked at again and again, of the other shortly before and after the start."""
    from .top import kovalevskaya, let_go

    omega, along, across = (omega1, omega2, omega3), -math.cos(chi), math.sin(chi)
    square, double = omega1**2 - omega2**2, 2 * omega1 * omega2
    kept = (square - mu * along) ** 2 + (double - mu * across) ** 2
    rate = 4 * (kappa - 2) / kappa**2 * mu * omega3 * (square * across - double * along)
    yield Answer("kept", r"$K$ for $\kappa = 2$", kept, "1/s⁴")
    yield Answer("rate", r"rate of $K$ at the start for this $\kappa$", rate, "1/s⁵")
    times = [k / math.sqrt(mu) for k in range(1, 21)]
    run = let_go((2.0, 2.0, 1.0), mu, chi, omega).integrate(times, rtol=1e-12, atol=1e-14)
    numbers = run.value(kovalevskaya(2.0, mu))
    yield Measure("$K$ is kept, relative", float(abs(numbers / kept - 1).max()), 1e-9)
    # As large as a rate can be, but for a small number.
    fast = math.sqrt(mu) + math.hypot(*omega)
    step, size = 1e-4 / fast, (mu + omega1**2 + omega2**2) ** 2 * fast
    other = let_go((kappa, kappa, 1.0), mu, chi, omega)
    before, after = other.integrate([-step, step], rtol=1e-13, atol=1e-15).value(
        kovalevskaya(kappa, mu)
    )
    wrong = abs((after - before) / (2 * step) - rate) / size
    yield Measure("rate, integrated, by the largest", float(wrong), 1e-7)
