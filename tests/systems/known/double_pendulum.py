"""Two pendulums in a row: for small angles ω² = (2 ∓ √2) g/l where masses and lengths are equal.

Landau and Lifshitz, Mechanics, § 23, problem 2.
"""

import math

from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt

m1, m2, l1, l2, g = symbols("m1 m2 l1 l2 g", positive=True)
theta1, theta2 = dynamicsymbols("theta1 theta2")
first = [l1 * sin(theta1), -l1 * cos(theta1)]
second = [first[0] + l2 * sin(theta2), first[1] - l2 * cos(theta2)]
SYSTEM = rt.System.of_parts(
    [rt.Mass(m1, first), rt.Mass(m2, second)], [theta1, theta2], gravity=[0, -g]
)
PARAMETERS = {m1: 1, m2: 1, l1: 1, l2: 1, g: 9.81}
CONSERVED = {"energy"}


def answers():
    """Both modes: the second angle is ±√2 times the first, and they turn after a half-period."""
    small = 1e-5
    for sign in (-1, 1):
        rate = math.sqrt((2 + sign * math.sqrt(2)) * 9.81)
        start = [small, -sign * math.sqrt(2) * small]
        run = SYSTEM.motion(PARAMETERS, q=start).integrate([1.0], rtol=1e-12, atol=1e-18)
        yield "a mode", run.q[0] / small - [math.cos(rate) * x / small for x in start], 1e-8
