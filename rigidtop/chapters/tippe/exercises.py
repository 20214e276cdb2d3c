"""What a reader may find with the chapter, confirmed by motions that are integrated."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial

import numpy as np

from rigidtop.errors import RigidtopError
from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Outcome, exercise
from rigidtop.proof.page import Claim, Measure

from .top import USUAL, least_energy, tippe_top

GIVEN = (
    Parameter("M", USUAL["M"], "mass, $M$", "kg", above=0),
    Parameter("r", USUAL["r"], "radius, $r$", "m", above=0),
    Parameter("h", USUAL["h"], "centre of mass below the middle, $h$", "m", above=0),
    Parameter("lambda1", USUAL["lambda1"], r"moment $\lambda_1$", "kg m²", above=0),
    Parameter("lambda3", USUAL["lambda3"], r"moment $\lambda_3$", "kg m²", above=0),
    Parameter("tilt", 0.1, r"tilt at the start, $\theta_0$", "rad", above=0, most=0.5),
)


@exercise(
    "spin",
    "How fast it must spin",
    section="4",
    asks="when it turns over",
    statement="How fast must the top spin upright to give way, and to come to stand on its head? "
    "With a spin between the two it hangs: at which tilt, if it is set down with the tilt and the "
    "spin that are given, and turns about its axis alone?",
    claims=(Claim("4.4", "The slope."), Claim("4.6", "Upright."), Claim("4.7", "On its head.")),
    parameters=(*GIVEN, Parameter("omega3", 55.0, r"spin, $\omega_3$", "rad/s", above=0)),
)
def spin(tilt: float, omega3: float, **body: float) -> Iterator[Outcome]:
    r"""(4.6) and (4.7); it hangs where $U$ is least, with the $J_0$ of (1.7),
    $\lambda_3\omega_3(r\cos\theta_0 - h)$. It is integrated with a viscous friction, and so is one
    with a tenth less spin than (4.6) asks for."""
    from scipy.optimize import minimize_scalar

    top = tippe_top(**body)
    r, h = top.tip, top.tip - top.R
    upright, head = top.lambda1 * r - top.lambda3 * (r - h), top.lambda3 * (r + h) - top.lambda1 * r
    if upright <= 0 or head <= 0:
        raise RigidtopError("no spin is enough for these moments")
    weight = math.sqrt(top.M * top.g * h / r)
    least = weight * (r - h) / math.sqrt(upright)
    J = top.lambda3 * omega3 * (r * math.cos(tilt) - h)
    hangs = float(minimize_scalar(partial(least_energy, top, J), bounds=(0.0, math.pi)).x)
    whole = weight * (r + h) ** 2 / ((r - h) * math.sqrt(head))
    yield Answer("least", "rate at which it gives way", least, "rad/s")
    yield Answer("whole", "rate at which it comes to its head", whole, "rad/s")
    yield Answer("hangs", "tilt at which it hangs", hangs, "rad")
    late = top.motion(theta=tilt, omega3=omega3).integrate(np.linspace(20.0, 24.0, 9)).theta
    yield Measure("tilt, integrated (rad)", abs(float(late.mean()) - hangs), 0.01)
    slow = top.motion(theta=tilt, omega3=0.9 * least).integrate([4.0]).theta[0]
    yield Measure("tilt of the slow top, by that at the start", slow / tilt, 0.5)


@exercise(
    "over",
    "What is left on the head",
    section="3",
    asks="upright and on its head",
    statement="The top is set down with the tilt and the spin that are given, turns about its axis "
    "alone, and turns over. How fast does it turn about the vertical in the end, how far has its "
    "centre of mass risen, and how much energy has friction taken?",
    claims=(Claim("1.7", "Jellett's integral."), Claim("3.1", "At both ends.")),
    parameters=(*GIVEN, Parameter("omega3", 160.0, r"spin, $\omega_3$", "rad/s", above=0)),
)
def over(tilt: float, omega3: float, **body: float) -> Iterator[Outcome]:
    r"""$J_0 = \lambda_3\omega_3(r\cos\theta_0 - h)$ by (1.7), and (3.1) on the head; the energy is
    $\tfrac12\lambda_3\omega_3^2 + Mg(r - h\cos\theta_0)$ at the start and (3.3) in the end. The top
    is integrated with a viscous friction besides."""
    top = tippe_top(**body)
    r, h = top.tip, top.tip - top.R
    rate, rise = omega3 * (r * math.cos(tilt) - h) / (r + h), h * (1 + math.cos(tilt))
    heat = top.lambda3 * (omega3**2 - rate**2) / 2 - top.M * top.g * rise
    run = top.motion(theta=tilt, omega3=omega3).integrate([0.0, 30.0])
    if run.theta[1] < 3:
        raise RigidtopError("with so little spin it does not turn over")
    yield Answer("rate", "rate about the vertical in the end", rate, "rad/s")
    yield Answer("rise", "rise of the centre of mass", rise, "m")
    yield Answer("heat", "energy that friction takes", heat, "J")
    yield Measure("rate, integrated (rad/s)", abs(run.omega_space[1, 2] - rate), 1e-3 * rate)
    yield Measure(
        "rise, integrated (m)", abs(float(np.ptp(run.position[:, 2])) - rise), 1e-3 * rise
    )
    yield Measure(
        "energy, integrated (J)", abs(run.dissipated_by_friction[1] - heat), 1e-3 * abs(heat)
    )
    yield Measure("change of J, relative", abs(float(run.jellett[1] / run.jellett[0]) - 1), 1e-8)
