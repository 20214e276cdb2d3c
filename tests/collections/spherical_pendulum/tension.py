"""Section 3: the force in the string."""

from __future__ import annotations

from collections.abc import Iterator

from sympy import Gt, cos, sin, sqrt

from rigidtop.proof.equation import Equation, as_printed
from rigidtop.proof.page import Assumption, Check, Evidence, Page, claim
from rigidtop.theory.trig import reduce_trig

from .conical import WEIGHT
from .engine import ON_A_CONE, along_the_string, speed
from .letters import S, g, length, m, phidot, theta, thetadot, v


@claim("3.1", "The force in the string.")
def force() -> Iterator[Evidence]:
    """Newton's law along the string."""
    with as_printed():
        printed = Equation(S, m * g * cos(theta) + m * v**2 / length, tag="3.1")
    yield Check(printed, {S: along_the_string(), v: speed()})


@claim("3.2", "On a cone the string carries the weight.")
def on_a_cone() -> Iterator[Evidence]:
    """The vertical part of the force is the weight, since the bob stays at its height."""
    with as_printed():
        printed = Equation(S * cos(theta), m * g, tag="3.2")
    yield Check(printed, {S: along_the_string().subs(ON_A_CONE).subs(WEIGHT), **WEIGHT})


@claim("taut", "The string stays taut.")
def taut() -> Iterator[Evidence]:
    """Below the support no term of the force in the string is negative."""
    with as_printed():
        printed = Equation(S, 0, relation=">")
    below = Assumption(Gt(cos(theta), 0), "the bob is below the support")
    turning = sqrt(v**2 / length**2 - (phidot * sin(theta)) ** 2)
    meaning = {S: reduce_trig(along_the_string().subs(thetadot, turning))}
    yield Check(printed, meaning, (below,))


page = Page("3", "The string", "What the string bears.", (force, on_a_cone, taut))
