"""The exercise on the conical pendulum."""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, pi, sin, sqrt

import numpy as np
import sympy

from rigidtop.parameters import Parameter
from rigidtop.proof.equation import Equation, as_printed
from rigidtop.proof.exercise import Answer, Outcome, exercise
from rigidtop.proof.page import Check, Evidence, Measure, claim

from . import evidence
from .conical import WEIGHT, cone, frequency
from .engine import ON_A_CONE
from .engine import speed as moving
from .letters import g, length, theta, v


@claim("speed", "The speed on a cone.")
def speed() -> Iterator[Evidence]:
    r"""$v = \omega l \sin\theta$ with the rate of the cone."""
    with as_printed():
        printed = Equation(v**2 * sympy.cos(theta), g * length * sympy.sin(theta) ** 2)
    yield Check(printed, {v: moving().subs(ON_A_CONE), **WEIGHT})


@exercise(
    "conical-pendulum",
    "The conical pendulum",
    section="2",
    asks="a question of every textbook",
    statement="A bob of mass $m$ on a string of length l goes round on a cone at the angle "
    "$\\theta$. How long does a turn take? What is the force in the string?\n\nSomebody "
    "gives it a slight push upwards. By what angle has it gone round from one highest "
    "place to the next?",
    claims=(cone, frequency, speed),
    parameters=(
        Parameter("m", 0.5, "mass of the bob", "kg", above=0),
        Parameter("length", 1.2, "length of the string", "m", above=0),
        Parameter("theta", pi / 4, r"$\theta$", "rad", above=0, most=1.5),
        Parameter("g", 9.81, "acceleration of gravity", "m/s²", above=0),
    ),
)
def conical_pendulum(m: float, length: float, theta: float, g: float) -> Iterator[Outcome]:
    """The formulas of the claims; the motion is computed in $x$, $y$, $z$ besides."""
    rate = evidence.rate(theta, g, length)
    period = 2 * pi / rate
    yield Answer("rate", r"$\omega$", rate, "rad/s")
    yield Answer("period", "time for a turn", period, "s")
    yield Answer("speed", "speed", rate * length * sin(theta), "m/s")
    yield Answer("force", "force in the string", m * g / cos(theta), "N")
    yield Answer(
        "nod", "angle from highest to highest", 2 * pi / sqrt(1 + 3 * cos(theta) ** 2), "rad"
    )
    times = np.linspace(0, period, 5)
    places, velocities = evidence.moved(theta, 0.0, rate, times, g, length)
    yield Measure(
        "back after a turn, over the length of the string",
        float(np.linalg.norm(places[-1] - places[0]) / length),
        1e-9,
    )
    # The string's force is what Newton's law leaves: its part towards the axis is mv²/r.
    across = m * float(velocities[1] @ velocities[1]) / (length * sin(theta))
    needed = float(np.hypot(across, m * g))
    yield Measure("force in the string, relative", abs(needed * cos(theta) / (m * g) - 1), 1e-9)
    kick, nod = 1e-4, 2 * pi / (rate * sqrt(1 + 3 * cos(theta) ** 2))
    places, _ = evidence.moved(theta, kick, rate, np.linspace(0, nod, 5), g, length)
    back = (np.arccos(-places[-1, 2] / length) - theta) * 2 * pi / (kick * nod)
    yield Measure(r"$\theta$ back after a nod, over its amplitude", float(abs(back)), 1e-2)
