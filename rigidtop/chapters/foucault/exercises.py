"""What a reader may find with the chapter, confirmed by motions that are integrated."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Outcome, exercise
from rigidtop.proof.page import Claim, Measure

GRAVITY = Parameter("g", 9.81, "acceleration of gravity, $g$", "m/s²", above=0)


@exercise(
    "tower",
    "From a tower",
    section="2",
    asks="to the east",
    statement="A stone is let go from a tower. How long does it fall, how far to the east of the "
    "plumb line does it land, and how fast does it go to the east then?",
    claims=(Claim("2.3", "The way to the east."), Claim("2.4", "The same for a short fall.")),
    parameters=(
        Parameter("height", 158.0, "height", "m", above=0, most=1e4),
        Parameter(
            "latitude", math.radians(53.55), r"latitude, $\lambda$", "rad", least=-1.57, most=1.57
        ),
        GRAVITY,
    ),
)
def tower(height: float, latitude: float, g: float) -> Iterator[Outcome]:
    """The time is that of a free fall, which the earth changes by less than one part in a million;
    (2.3) gives the way. All three equations are integrated besides."""
    from .laboratory import EARTH, motion

    time = math.sqrt(2 * height / g)
    turn = 2 * EARTH * time
    # t − sin(2ωt)/2ω, where the two differ by little.
    late = time * (turn**2 / 6 - turn**4 / 120)
    east = g * math.cos(latitude) / (2 * EARTH) * late
    rate = g * math.cos(latitude) / EARTH * math.sin(turn / 2) ** 2
    yield Answer("time", "time of the fall", time, "s")
    yield Answer("east", "way to the east", east, "m")
    yield Answer("rate", "velocity to the east", rate, "m/s")
    end = motion((0, 0, height), (0, 0, 0), latitude, g=g).integrate([time])
    yield Measure("height after this time (m)", abs(end.q[0, 2]), 1e-4 * height)
    wrong = abs(end.q[0, 0] - east), abs(end.qdot[0, 0] - rate)
    yield Measure("to the east, integrated (m, m/s)", max(wrong), 1e-6)


@exercise(
    "pantheon",
    "In the Panthéon",
    section="3",
    asks="Foucault's pendulum",
    statement="Foucault's pendulum hangs on a wire and swings as wide as said. How long does a "
    "swing to and fro take, how long does it take the plane to come round, and how far beside its "
    "start does the bob come back from its first swing?",
    claims=(Claim("3.4", "The plane turns."),),
    parameters=(
        Parameter("length", 67.0, "length of the wire", "m", above=0),
        Parameter("A", 3.0, "deflection at the start, $A$", "m", above=0),
        Parameter(
            "latitude", math.radians(48.85), r"latitude, $\lambda$", "rad", least=0.02, most=1.57
        ),
        GRAVITY,
    ),
)
def pantheon(length: float, A: float, latitude: float, g: float) -> Iterator[Outcome]:
    r"""The bob is farthest out again when $\cos\omega_1t = 1$ in (3.4), with
    $\omega_0 = \sqrt{g/l}$. The equations are integrated besides, with the start of (3.3)."""
    from .laboratory import EARTH, motion

    plane = EARTH * math.sin(latitude)
    frequency = math.sqrt(g / length)
    period = 2 * math.pi / math.sqrt(frequency**2 + plane**2)
    yield Answer("period", "time of a swing to and fro", period, "s")
    yield Answer("round", "time in which the plane comes round", 2 * math.pi / plane, "s")
    yield Answer("beside", "distance beside the start", A * math.sin(plane * period), "m")
    start = (A, 0.0, 0.0), (0.0, -A * plane, 0.0)
    swings = 40
    run = motion(*start, latitude, frequency=frequency).integrate([period, swings * period])
    beside = abs(run.q[0, 1] + A * math.sin(plane * period)) / A
    turned = -math.atan2(run.q[1, 1], run.q[1, 0])
    yield Measure("beside the start, integrated, by the deflection", beside, 1e-7)
    wrong = abs(turned - math.remainder(swings * period * plane, 2 * math.pi))
    yield Measure(f"turned after {swings} swings (rad)", wrong, 1e-6)
