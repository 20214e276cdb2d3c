"""A rod that swings about its end, by x, y and θ with constraints, against the same by θ alone."""

import numpy as np
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt

m, length, g = symbols("m length g", positive=True)
x, y, theta = dynamicsymbols("x y theta")
SYSTEM = rt.System(
    m * (x.diff() ** 2 + y.diff() ** 2) / 2 + m * length**2 * theta.diff() ** 2 / 24 - m * g * y,
    [x, y, theta],
    constraints=[x - length * sin(theta) / 2, y + length * cos(theta) / 2],
)
BY_ANGLE = rt.System(m * length**2 * theta.diff() ** 2 / 6 + m * g * length * cos(theta) / 2, theta)
PARAMETERS = {m: 1.2, length: 0.9, g: 9.81}
CONSERVED = {"energy"}


def answers():
    """The angle; the force of the hinge at the lowest place is mg + ½ml θ̇²."""
    start = 1.1
    place = [0.45 * np.sin(start), -0.45 * np.cos(start), start]
    times = [1.0, 4.0]
    run = SYSTEM.motion(PARAMETERS, q=place).integrate(times, rtol=1e-12, events={"lowest": theta})
    other = BY_ANGLE.motion(PARAMETERS, q=start).integrate(times, rtol=1e-12)
    yield "the angle", run.q[:, 2] - other.q[:, 0], 1e-8
    lowest = SYSTEM.motion(PARAMETERS, q=place).integrate([run.events["lowest"][0]], rtol=1e-12)
    force = 1.2 * 9.81 + 1.2 * 0.45 * lowest.qdot[0, 2] ** 2
    yield "the hinge", lowest.multipliers[0, 1] - force, 1e-8
