"""Chaplygin's sleigh: a blade that can't slip sideways, the centre of mass ahead of it by a.

With u along the blade and the turn w: u̇ = aw², ẇ = −m a u w/(λ + ma²), solved by tanh and sech:
Bloch, Nonholonomic Mechanics and Control, section 1.7.
"""

import numpy as np
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt

m, moment, a = symbols("m moment a", positive=True)
x, y, theta = dynamicsymbols("x y theta")  # of the blade
centre = [x + a * cos(theta), y + a * sin(theta)]
speed2 = sum(z.diff(theta.args[0]) ** 2 for z in centre)
SYSTEM = rt.System(
    m * speed2 / 2 + moment * theta.diff() ** 2 / 2,
    [x, y, theta],
    constraints=y.diff() * cos(theta) - x.diff() * sin(theta),
)
PARAMETERS = {m: 2.0, moment: 1.5, a: 0.4}
CONSERVED = {"energy"}


def answers():
    """It starts to turn, and in the end glides straight ahead."""
    whole = 1.5 + 2.0 * 0.4**2
    turn = 1.3  # with u = 0 at t = 0: w = w₀ sech(κt), u = κ(λ + ma²)/(ma) tanh(κt)
    kappa = turn * 0.4 * np.sqrt(2.0 / whole)
    run = SYSTEM.motion(PARAMETERS, q=[0, 0, 0], qdot=[0, 0, turn]).integrate(
        [0.7, 5.0], rtol=1e-12
    )
    along = np.cos(run.q[:, 2]) * run.qdot[:, 0] + np.sin(run.q[:, 2]) * run.qdot[:, 1]
    yield "the turn", run.qdot[:, 2] - turn / np.cosh(kappa * run.t), 1e-9
    yield "the speed", along - kappa * whole / (2.0 * 0.4) * np.tanh(kappa * run.t), 1e-9
    yield "the blade", run.drift()["constraint 1"], 1e-9
