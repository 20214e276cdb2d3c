"""A pole on a cart that is pushed, its moment λ = ml²/3 about the centre: the equations of Florian.

Barto, Sutton and Anderson, IEEE Trans. SMC 13 (1983) 834, without friction; Florian, Correct
equations for the dynamics of the cart-pole system (2007), (23) and (24); l is half the pole.
"""

import numpy as np
from sympy import cos, symbols
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt

M, m, length, g, F = symbols("M m length g F", positive=True)
x, theta = dynamicsymbols("x theta")
SYSTEM = rt.System.of_energies(
    (M + m) * x.diff() ** 2 / 2
    + m * length * x.diff() * theta.diff() * cos(theta)
    + (m * length**2 + m * length**2 / 3) * theta.diff() ** 2 / 2,
    m * g * length * cos(theta),
    [x, theta],
    forces={x: F},
)
PARAMETERS = {M: 1.0, m: 0.1, length: 0.5, g: 9.8, F: 10.0}
CONSERVED = set()


def answers():
    """Both accelerations, and what the push does."""
    rng = np.random.default_rng(1)
    for angle, turning in rng.uniform(-2, 2, (5, 2)):
        c, s, total = np.cos(angle), np.sin(angle), 1.1
        push = (-10.0 - 0.05 * turning**2 * s) / total
        alpha = (9.8 * s + c * push) / (0.5 * (4 / 3 - 0.1 * c**2 / total))
        a = (10.0 + 0.05 * (turning**2 * s - alpha * c)) / total
        run = SYSTEM.motion(PARAMETERS, q=[0, angle], qdot=[0.3, turning]).integrate([0.0])
        yield "accelerations", run.accelerations[0] - [a, alpha], 1e-12
    run = SYSTEM.motion(PARAMETERS, q=[0, 0.1]).integrate(np.linspace(0, 1, 5))
    yield "energy and work", run.drift()["energy balance"], 1e-9
