"""What a reader may find with the chapter, confirmed by motions that are integrated."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Outcome, Table, exercise
from rigidtop.proof.page import Claim, Measure


@exercise(
    "race",
    "A race down a slope",
    section="1",
    asks="rolling",
    statement="A hoop, a disc and a ball start together and roll down a slope. When does each "
    "arrive, and how rough must the slope be at least for it? How fast is the ball in the end?",
    claims=(Claim("1.3", "The acceleration."), Claim("1.4", "Without slipping.")),
    parameters=(
        Parameter("slope", math.radians(20), r"slope, $\alpha$", "rad", above=0, most=1.4),
        Parameter("way", 2.0, "way", "m", above=0),
        Parameter("R", 0.1, "radius, $R$", "m", above=0),
        Parameter("g", 9.81, "acceleration of gravity, $g$", "m/s²", above=0),
    ),
)
def race(slope: float, way: float, R: float, g: float) -> Iterator[Outcome]:
    """(1.3) and (1.4) with $I = mR^2$, $mR^2/2$ and $2mR^2/5$; the equations with their constraint
    are integrated besides."""
    from .rolling import SHAPES, down

    rows = []
    for name, ratio in SHAPES.items():
        time = math.sqrt(2 * way * (1 + ratio) / (g * math.sin(slope)))
        rough = ratio / (1 + ratio) * math.tan(slope)
        yield Answer(name, f"time of the {name}", time, "s")
        rows.append((name, time, rough))
        run = down(ratio, slope, 1.0, R, g).integrate([time])
        yield Measure(f"way of the {name}, integrated (m)", abs(run.q[0, 0] - way), 1e-8 * way)
    yield Answer("speed", "speed of the ball in the end", 2 * way / time, "m/s")
    yield Answer("rough", "least coefficient of friction for the hoop", rows[0][2])
    yield Table(
        "each", "What each needs", ("what rolls", "time (s)", r"least $\mu_s$"), tuple(rows)
    )


@exercise(
    "turntable",
    "Where the ball goes",
    section="2",
    asks="a ball on a turntable",
    statement="A homogeneous ball is set down on a turntable at the distance $d$ from its axis, "
    "and rolls off straight outwards. How large is its circle, how long does it take for it, and "
    "how far from the axis does it come at most?",
    claims=(Claim("2.4", "The middle of the circle."), Claim("2.5", "The circle.")),
    parameters=(
        Parameter("turn", math.pi, r"rate of the table, $\Omega$", "rad/s", above=0),
        Parameter("d", 0.2, "distance from the axis", "m", least=0),
        Parameter("v", 0.1, "velocity outwards", "m/s", above=0),
    ),
)
def turntable(turn: float, d: float, v: float) -> Iterator[Outcome]:
    r"""(2.5) has the radius, (2.2) the time, and the middle of the circle is $7v/(2\Omega)$ beside
    the start; the ball is integrated with its rolling constraint besides, once round."""
    from .rolling import set_down

    radius, time = 7 * v / (2 * turn), 7 * math.pi / turn
    farthest = math.hypot(d, radius) + radius
    yield Answer("radius", "radius of the circle", radius, "m")
    yield Answer("time", "time for the circle", time, "s")
    yield Answer("farthest", "largest distance from the axis", farthest, "m")
    # Along the circle, from its start: where it is farthest out.
    angle = math.atan2(radius, d) + math.pi / 2
    reached = angle / (2 * math.pi) * time
    start = set_down((d, 0.0), (v, 0.0), turn)
    (x, y), (x_end, y_end) = start.integrate([reached, time]).q[:, :2]
    yield Measure("farthest out, integrated (m)", abs(math.hypot(x, y) - farthest), 1e-7 * farthest)
    yield Measure("back after the circle (m)", math.hypot(x_end - d, y_end), 1e-7 * farthest)
