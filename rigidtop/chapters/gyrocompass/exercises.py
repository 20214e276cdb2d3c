"""What a reader may find with the chapter, confirmed by motions that are integrated."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Outcome, exercise
from rigidtop.proof.page import Claim, Measure

LATITUDE = Parameter(
    "latitude", math.radians(50), r"latitude, $\beta$", "rad", least=-1.5, most=1.5
)
SPIN = Parameter("spin", 20000 * 2 * math.pi / 60, r"spin, $\omega$", "rad/s", least=10, most=1e5)
RATIO = Parameter("ratio", 2.0, "$C$ by $A$", above=0, most=2)


@exercise(
    "swing",
    "From nearly south",
    section="3",
    asks="north and south",
    statement="The axis is let go at rest. How long does a small swing to and fro about north "
    "take? How fast does the axis turn as it comes past north from the angle that is given, and "
    "after what time is it there for the first time?",
    claims=(Claim("3.3", "The period."), Claim("3.5", "The way to the north.")),
    parameters=(
        Parameter(
            "alpha", math.radians(179), r"angle at the start, $\alpha_0$", "rad", above=0, most=3.14
        ),
        LATITUDE,
        SPIN,
        RATIO,
    ),
)
def swing(alpha: float, latitude: float, spin: float, ratio: float) -> Iterator[Outcome]:
    r"""(3.3); by (3.5) $\dot\alpha = 2\nu\sin(\alpha_0/2)$ at north. The time is that of a pendulum
    for a quarter of a swing, $K(m)/\nu$ with $m = \sin^2(\alpha_0/2)$. The wheel is integrated
    besides, with the term that (2.2) leaves out."""
    from scipy.special import ellipkm1

    from .compass import frequency, let_go

    rate = frequency(spin, latitude, ratio)
    # K(m), from what is left of m to 1.
    quarter = float(ellipkm1(math.cos(alpha / 2) ** 2)) / rate
    fastest = 2 * rate * math.sin(alpha / 2)
    yield Answer("period", "period of small swings", 2 * math.pi / rate, "s")
    yield Answer("fastest", "rate of the axis at north", fastest, "rad/s")
    yield Answer("time", "time until it is at north", quarter, "s")
    run = let_go(alpha, spin, latitude, ratio).integrate([quarter, 2 * quarter])
    yield Measure("at north, integrated (rad)", abs(run.q[0, 0]), 1e-4)
    yield Measure("rate there, relative", abs(-run.qdot[0, 0] / fastest - 1), 1e-5)
    yield Measure("as far on the other side (rad)", abs(run.q[1, 0] + alpha), 1e-4)


@exercise(
    "course",
    "A ship sails to the north",
    section="5",
    asks="on a ship",
    statement="How far from north, and to which side, is a gyrocompass at rest on a ship that "
    "sails to the north? Nothing holds the axis back, and it is let go at rest as it points to the "
    "north: how far to the west does it come?",
    claims=(Claim("5.4", "The equation of motion."), Claim("5.5", "The error.")),
    parameters=(
        Parameter("speed", 10.3, "speed of the ship, $v$", "m/s", above=0, most=300),
        LATITUDE,
        SPIN,
        RATIO,
    ),
)
def course(speed: float, latitude: float, spin: float, ratio: float) -> Iterator[Outcome]:
    r"""(5.5), to the west; it swings about there, as far to one side as to the other, so that it
    comes to $2\delta$. The wheel is integrated, at rest at $\delta$ and let go at north."""
    from scipy.special import ellipk

    from .compass import EARTH, RADIUS, frequency, let_go

    error = math.atan2(speed, RADIUS * EARTH * math.cos(latitude))
    yield Answer("error", "where it is at rest, to the west", error, "rad")
    yield Answer("farthest", "how far it comes to the west", 2 * error, "rad")
    half = math.pi / frequency(spin, latitude, ratio, speed)
    rest = let_go(error, spin, latitude, ratio, speed).integrate([half, 2 * half]).q[:, 0]
    yield Measure("away from there, integrated (rad)", float(abs(rest - error).max()), 1e-8)
    late = half * float(ellipk(math.sin(error / 2) ** 2)) * 2 / math.pi
    far = let_go(0.0, spin, latitude, ratio, speed).integrate([late]).q[0, 0]
    yield Measure("the farthest, integrated (rad)", abs(far - 2 * error), 1e-6)
