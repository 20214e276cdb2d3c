"""What a reader may find with the chapter, confirmed by orbits that are integrated."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Outcome, exercise
from rigidtop.proof.page import Claim, Measure

AXIS = Parameter("a", 2.6679e12, "half of the long axis, $a$", "m", above=0)
ECCENTRICITY = Parameter("epsilon", 0.967, r"eccentricity, $\varepsilon$", least=0, most=0.99)
YEAR = 365.25 * 86400.0
"""In s."""


@exercise(
    "comet",
    "Halley's comet",
    section="2",
    asks="the third law",
    statement="Of a comet one knows the long axis and the eccentricity. How often does it come "
    "back, how near does it come to the sun, and how fast is it there and at the other end? How "
    "long does it take from the perihelion to the end of the short axis?",
    claims=(Claim("2.3", "Kepler's equation."), Claim("2.4", "The third law.")),
    parameters=(AXIS, ECCENTRICITY),
)
def comet(a: float, epsilon: float) -> Iterator[Outcome]:
    r"""(2.4) gives the period, (2.6) the speeds, and (2.3), with $\eta = \pi/2$, the time; the
    orbit is integrated besides."""
    from .orbits import GM, orbit

    motion = math.sqrt(GM / a**3)
    period = 2 * math.pi / motion
    near, far = a * (1 - epsilon), a * (1 + epsilon)
    fast = math.sqrt(GM * (2 / near - 1 / a))
    slow = math.sqrt(GM * (2 / far - 1 / a))
    aside = (math.pi / 2 - epsilon) / motion
    yield Answer("period", "period", period, "s")
    yield Answer("nearest", "distance at the perihelion", near, "m")
    yield Answer("fastest", "speed at the perihelion", fast, "m/s")
    yield Answer("slowest", "speed at the aphelion", slow, "m/s")
    yield Answer("to_the_short_axis", "time to the end of the short axis", aside, "s")
    run = orbit(a * (1 - epsilon**2), epsilon, GM).integrate([aside, period / 2, period])
    places, turned = run.q[:, 0], run.q[:, 1]
    speeds = run.qdot[1, 1] * places[1]
    wrong = abs(places[1] / far - 1), abs(speeds / slow - 1), abs(turned[1] / math.pi - 1)
    yield Measure("at the aphelion after half a period, relative", max(wrong), 1e-6)
    yield Measure("at the end of the short axis in time, relative", abs(places[0] / a - 1), 1e-6)
    yield Measure("round after a period (rad)", abs(turned[2] - 2 * math.pi), 1e-3)


@exercise(
    "seasons",
    "Which half of the year is longer",
    section="2",
    asks="Kepler's equation",
    statement="A line through the sun, across the long axis, cuts the orbit in two. In what share "
    "of a period does the planet pass the part with the perihelion, and how much longer does it "
    "take for the other part, if a period is a year?",
    claims=(Claim("2.3", "Kepler's equation."),),
    parameters=(Parameter("epsilon", 0.0167, r"eccentricity, $\varepsilon$", least=0, most=0.9),),
)
def seasons(epsilon: float) -> Iterator[Outcome]:
    r"""At the line $x = 0$, which is $\cos\eta = \varepsilon$; (2.3) gives the time. The orbit is
    integrated until $\phi = \pi/2$ besides."""
    from sympy import Symbol

    from .orbits import orbit, period

    eta = math.acos(epsilon)
    share = (eta - epsilon * math.sin(eta)) / math.pi
    yield Answer("share", "share of the part with the perihelion", share)
    yield Answer("longer", "time by which the other part is longer", YEAR * (1 - 2 * share), "s")
    whole = period(1.0, epsilon)
    phi = Symbol("phi", real=True)
    run = orbit(1.0, epsilon).integrate((0.0, whole / 2), until=phi - math.pi / 2)
    assert run.ended is not None
    yield Measure("share of the period, integrated", abs(2 * run.ended / whole - share), 1e-9)
