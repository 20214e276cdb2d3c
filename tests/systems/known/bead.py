"""A bead on a hoop that turns: it rests at cos θ = g/(RΩ²), and about there it nods at Ω sin θ.

Goldstein, Classical Mechanics, chapter 2; Taylor, Classical Mechanics, section 7.6.
"""

import math

import numpy as np
from sympy import acos, cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt

m, R, g, Omega = symbols("m R g Omega", positive=True)
theta = dynamicsymbols("theta")
SYSTEM = rt.System(
    m * R**2 * (theta.diff() ** 2 + Omega**2 * sin(theta) ** 2) / 2 + m * g * R * cos(theta), theta
)
PARAMETERS = {m: 0.5, R: 0.7, g: 9.81, Omega: 6.0}
CONSERVED = {"energy"}  # Jacobi's integral, which is not T + V: the hoop does work


def answers():
    """At rest, and a half-period beside it."""
    rest = math.acos(9.81 / (0.7 * 36))
    run = SYSTEM.motion(PARAMETERS, q=rest).integrate([5.0])
    yield "at rest", run.q[0] - rest, 1e-9
    places = sorted(float(x[theta].subs(PARAMETERS)) for x in SYSTEM.equilibria())
    yield "at rest in symbols", np.array(places) - [-rest, 0, rest, math.pi], 1e-12
    beside = SYSTEM.small({theta: acos(g / (R * Omega**2))})
    yield "its rate", beside.frequencies(PARAMETERS) - 6 * math.sin(rest), 1e-12
    below = SYSTEM.small({theta: 0})
    yield "stable", int(beside.stability(PARAMETERS) != "stable"), 0
    yield "unstable", int(below.stability(PARAMETERS) != "unstable"), 0
    small = 1e-4
    rate = 6 * math.sin(rest)
    beside = SYSTEM.motion(PARAMETERS, q=rest + small).integrate(
        [2.0], atol=1e-15, rtol=1e-13, events={"turns": theta.diff()}
    )
    yield "the period", beside.events["turns"][1] * rate / (2 * math.pi) - 1, 1e-7
