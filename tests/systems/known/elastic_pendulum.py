"""A mass on a spring: straight up and down it is harmonic, and beside its rest there are two modes.

ω² = k/m and ω² = g/(l + mg/k): Lynch, Int. J. Non-Linear Mechanics 37 (2002) 345.
"""

import math

from sympy import cos, symbols
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt

m, k, length, g = symbols("m k length g", positive=True)
r, theta = dynamicsymbols("r theta")
SYSTEM = rt.System.of_energies(
    m * (r.diff() ** 2 + r**2 * theta.diff() ** 2) / 2,
    k * (r - length) ** 2 / 2 - m * g * r * cos(theta),
    [r, theta],
)
PARAMETERS = {m: 1.5, k: 30, length: 1, g: 9.81}
CONSERVED = {"energy"}
REST = 1 + 1.5 * 9.81 / 30


def answers():
    """Up and down; both frequencies; stable, where K is positive definite."""
    run = SYSTEM.motion(PARAMETERS, q=[REST + 0.3, 0]).integrate([1.7], rtol=1e-12)
    rate = math.sqrt(30 / 1.5)
    yield "up and down", run.q[0] - [REST + 0.3 * math.cos(1.7 * rate), 0], 1e-10
    small = SYSTEM.small({r: length + m * g / k, theta: 0})
    known = [math.sqrt(9.81 / REST), rate]
    yield "both frequencies", small.frequencies(PARAMETERS) - known, 1e-12
    yield "stable", int(small.stability(PARAMETERS) != "stable"), 0
