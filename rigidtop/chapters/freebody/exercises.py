"""What a reader may find with the chapter, confirmed by bodies whose motion is integrated."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rigidtop.parameters import Parameter
from rigidtop.proof.exercise import Answer, Outcome, exercise
from rigidtop.proof.page import Claim, Measure

MOMENTS = (
    Parameter("lambda1", 1.0, r"smallest moment, $\lambda_1$", "kg m²", above=0),
    Parameter("lambda2", 2.0, r"middle moment, $\lambda_2$", "kg m²", above=0),
    Parameter("lambda3", 2.5, r"largest moment, $\lambda_3$", "kg m²", above=0),
)


@exercise(
    "turnover",
    "How long it waits",
    section="4",
    asks="the flip",
    statement=r"A body is spun about its middle axis with $a_2$, and with $\delta$ about the "
    "third, which is not wanted. How long is it from one flip to the next, exactly and by the "
    "logarithm, and how much longer if the push is ten times weaker?",
    claims=(Claim("4.6", "The logarithm."), Claim("4.8", "With the push.")),
    parameters=(
        *MOMENTS,
        Parameter("a2", 2 * math.pi, r"rate about the middle axis, $a_2$", "rad/s", above=0),
        Parameter("push", 0.05, r"push, $\delta$", "rad/s", above=0),
    ),
)
def turnover(a2: float, push: float, **moments: float) -> Iterator[Outcome]:
    r"""(3.4) has twice the time; (4.8) needs $p$ and $a_3$, by (3.2) and (1.7). The body is
    integrated besides, from one end of its wait to that of the next."""
    from .bodies import Path, body

    path = Path(body(**moments), a2, push)
    time = path.period / 2
    yield Answer("time", "time from one flip to the next", time, "s")
    yield Answer("log", "the same by the logarithm", 2 / path.p * math.log(4 * path.a3 / push), "s")
    weaker = Path(path.body, a2, push / 10).period / 2
    yield Answer("longer", "how much longer with a tenth of the push", weaker - time, "s")
    end = path.body.motion(omega=(0.0, a2, push)).integrate([time]).omega[0]
    wrong = max(abs(float(x) - y) for x, y in zip(end, (0.0, -a2, push), strict=True))
    yield Measure("upside down after this time, integrated (rad/s)", wrong, 1e-6 * a2)


@exercise(
    "whole-turn",
    "What is left over",
    section="5",
    asks="the angle about L",
    statement=r"A body starts with $\omega_1 = a_1$ and $\omega_3 = a_3$. After which time is its "
    r"angular momentum back in the body, and by which angle, between 0 and $2\pi$, has the body "
    "then turned about it? How much of this would a clock tell, and how much the path?",
    claims=(Claim("3.4", "The period."), Claim("5.2", "The angle.")),
    parameters=(
        *MOMENTS,
        Parameter("a1", 1.0, r"$\omega_1$ at the start, $a_1$", "rad/s", above=0),
        Parameter("a3", 2.0, r"$\omega_3$ at the start, $a_3$", "rad/s", above=0),
    ),
)
def whole_turn(a1: float, a3: float, **moments: float) -> Iterator[Outcome]:
    r"""(3.4) has the time and (5.2) the angle; the solid angle is an integral along the path, in
    numbers. The body is integrated with its attitude besides: where (5.2) takes it, and no other
    turn, has it gone."""
    from scipy.spatial.transform import Rotation

    from .bodies import Path, body

    path = Path.started(body(**moments), a1, a3)
    motion = path.body.motion(omega=(a1, 0.0, a3))
    start = motion.start()
    momentum = start.angular_momentum[0]
    size = math.hypot(*momentum)
    clock = 2 * float(start.energy[0]) * path.period / size
    angle = (clock - path.solid_angle) % (2 * math.pi)
    yield Answer("period", "period", path.period, "s")
    yield Answer("clock", r"$2E/L$ times the period", clock, "rad")
    yield Answer("path", "solid angle", path.solid_angle)
    yield Answer("angle", r"angle about $\mathbf L$", angle, "rad")
    turn = Rotation.from_rotvec(angle * momentum / size)
    end = motion.integrate([path.period]).rotation[0]
    wrong = float((end * (turn * start.rotation[0]).inv()).magnitude())
    yield Measure("attitude after the period, integrated (rad)", wrong, 1e-7)
