"""A mass on a string: steady on a cone with φ̇² = g/(l cos θ), and in a plane with Jacobi's period.

The period in a plane is 4 √(l/g) K(sin² ½θ₀): Landau and Lifshitz, Mechanics, § 11, problem 1.
"""

import math

import numpy as np
from scipy.special import ellipk
from sympy import cos, sin, symbols
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt

m, length, g = symbols("m l g", positive=True)
theta, phi = dynamicsymbols("theta phi")
SYSTEM = rt.System(
    m * length**2 * (theta.diff() ** 2 + phi.diff() ** 2 * sin(theta) ** 2) / 2
    + m * g * length * cos(theta),
    [theta, phi],
)
PARAMETERS = {m: 0.8, length: 1.3, g: 9.81}
CONSERVED = {"energy", "p_phi"}


def answers():
    """The cone, and the period of the plane pendulum that starts at 2 rad."""
    rate = math.sqrt(9.81 / (1.3 * math.cos(0.7)))
    run = SYSTEM.motion(PARAMETERS, q=[0.7, 0], qdot=[0, rate]).integrate([0.0, 3.0])
    yield "the cone", run.q[1] - [0.7, 3 * rate], 1e-9
    plane = SYSTEM.motion(PARAMETERS, q=[2.0, 0]).integrate(
        [5.0], events={"turns": theta.diff()}, rtol=1e-12
    )
    period = 4 * math.sqrt(1.3 / 9.81) * ellipk(math.sin(1.0) ** 2)
    yield "the period", plane.events["turns"][1] - period, 1e-9
    yield "the momentum", np.ptp(run.momenta[:, 1]), 1e-12
