"""A body with any moments and its centre of mass anywhere, by Euler angles.

Its motion is that of `rt.HeavyBody`, which is integrated in quaternions by Euler's equations: no
line of code is shared but the solver's.
"""

import numpy as np
from scipy.spatial.transform import Rotation
from sympy import Matrix, symbols
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt
from rigidtop.theory.rotation import euler_matrix

moments = symbols("lambda1:4", positive=True)
M, g = symbols("M g", positive=True)
arm = symbols("R1:4", real=True)
phi, theta, psi = dynamicsymbols("phi theta psi")
attitude = euler_matrix(phi, theta, psi)
SYSTEM = rt.System.of_parts(
    rt.Body(0, moments, [0, 0, 0], attitude),
    [phi, theta, psi],
    V=M * g * (attitude * Matrix(arm))[2],
)
PARAMETERS = dict(
    zip((*moments, M, g, *arm), (3.0, 2.0, 1.5, 1.0, 9.81, 0.2, 0.3, 0.4), strict=True)
)
CONSERVED = {"energy", "p_phi"}


def answers():
    """The attitude after a while."""
    start, rates = [0.3, 0.7, -0.2], [0.5, 0.4, 2.0]
    run = SYSTEM.motion(PARAMETERS, q=start, qdot=rates).integrate([1.5], rtol=1e-12)
    p, t, s = rates
    a, b = np.sin(start[2]), np.cos(start[2])
    sine, cosine = np.sin(start[1]), np.cos(start[1])
    omega = (t * a - p * sine * b, t * b + p * sine * a, s + p * cosine)
    body = rt.HeavyBody(3.0, 2.0, 1.5, M=1.0, centre_of_mass=(0.2, 0.3, 0.4))
    held = body.motion(omega, Rotation.from_euler("ZYZ", start)).integrate([1.5], rtol=1e-12)
    found = Rotation.from_euler("ZYZ", run.q[0])
    yield "the attitude", (found.inv() * held.rotation[0]).magnitude(), 1e-8
