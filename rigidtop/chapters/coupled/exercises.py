"""What a reader may find with the chapter, confirmed by swings that are integrated."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Outcome, exercise
from rigidtop.proof.page import Claim, Measure

PENDULUM = (
    Parameter("m", 0.5, "mass of a bob, $m$", "kg", above=0),
    Parameter("length", 1.0, "length of a string, $l$", "m", above=0),
    Parameter("g", 9.81, "acceleration of gravity, $g$", "m/s²", above=0),
    Parameter("D", 0.6, "stiffness of a spring, $D$", "N/m", above=0),
)


@exercise(
    "exchange",
    "Until the other one has it all",
    section="2",
    asks="beats",
    statement="The first of the two pendulums is let go, the second one hangs. After what time "
    "does the second one swing as wide as the first did, and how often did they swing until then?",
    claims=(Claim("2.8", "The beats."),),
    parameters=PENDULUM,
)
def exchange(m: float, length: float, g: float, D: float) -> Iterator[Outcome]:
    r"""Where $(\omega_2 - \omega_1)t/2$ is $\pi/2$ in (2.8); the pendulums with their sines and
    cosines are integrated besides, from a small deflection."""
    from .swings import SLOWEST, frequency, swing

    first, second = (frequency(phase, m, length, g, D) for phase in (0.0, math.pi / 2))
    time = math.pi / (second - first)
    swings = time * (first + second) / (4 * math.pi)
    yield Answer("time", "time until all is handed over", time, "s")
    yield Answer("swings", "swings until then", swings)
    t = np.linspace(0.0, time, 201)
    run = swing([SLOWEST, 0.0], m, length, g, D).integrate(t)
    slow, fast = (second - first) * t / 2, (second + first) * t / 2
    beats = np.stack([np.cos(slow) * np.cos(fast), np.sin(slow) * np.sin(fast)], axis=1)
    wrong = float(np.abs(run.q / SLOWEST - beats).max())
    yield Measure("beats against the integrated swings, beside the deflection", wrong, 1e-5)


@exercise(
    "three",
    "Three in a row",
    section="3",
    asks="a row without an end",
    statement="Three pendulums hang in a row, with springs between neighbours, and free ends. "
    "Which waves of (3.2) fit, and what are their frequencies?\n\nAt a free end a pendulum is "
    "drawn by one spring only: as if it had a neighbour who does the same as itself.",
    claims=(Claim("3.2", "The band."),),
    parameters=PENDULUM,
)
def three(m: float, length: float, g: float, D: float) -> Iterator[Outcome]:
    r"""$\cos(j\alpha + \alpha/2)$ for $j = 0, 1, 2$ has the same value before the first and at it,
    and behind the last if $3\alpha$ is a multiple of $\pi$: $\alpha = 0$, $\pi/3$, $2\pi/3$. Each
    shape is let go, and integrated for its period."""
    from .swings import SLOWEST, frequency, swing

    modes = (("slowest", "0"), ("middle", r"\pi/3"), ("fastest", r"2\pi/3"))
    for k, (name, alpha) in enumerate(modes):
        phase = k * math.pi / 3
        rate = frequency(phase, m, length, g, D)
        yield Answer(name, rf"frequency for $\alpha = {alpha}$", rate, "rad/s")
        shape = SLOWEST * np.cos(phase * (np.arange(3) + 0.5))
        end = swing([*shape], m, length, g, D).integrate([math.pi / rate, 2 * math.pi / rate]).q
        wrong = float(np.abs(end - [-shape, shape]).max()) / SLOWEST
        yield Measure(f"{name}: over there after half a period, and back", wrong, 1e-5)
