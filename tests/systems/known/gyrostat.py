"""A symmetric body with a rotor about e₃: free, it precesses about L at |L|/λ₁ as a body does.

The rotor turns at χ̇ relative to the body, with the moment J about e₃ (in λ₃ already); p_ψ and p_χ
are constant.  Wittenburg, Dynamics of Systems of Rigid Bodies, section 4.6.
"""

import numpy as np
from sympy import cos, symbols
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt
from rigidtop.theory.rotation import euler_matrix

lambda1, lambda3, J = symbols("lambda1 lambda3 J", positive=True)
phi, theta, psi, chi = dynamicsymbols("phi theta psi chi")
BODY = rt.Body(0, (lambda1, lambda1, lambda3), [0, 0, 0], euler_matrix(phi, theta, psi))
TURNING = rt.System.of_parts(BODY, [phi, theta, psi])
SPIN = psi.diff() + phi.diff() * cos(theta)
SYSTEM = rt.System(
    TURNING.L + J * (2 * SPIN * chi.diff() + chi.diff() ** 2) / 2, [phi, theta, psi, chi]
)
PARAMETERS = {lambda1: 2.0, lambda3: 1.5, J: 0.4}
CONSERVED = {"energy", "p_phi", "p_psi", "p_chi"}


def answers():
    """With L along ẑ: θ stays, φ̇ = L/λ₁ where L cos θ = λ₃ω₃ + Jχ̇."""
    tilt, spin, rotor = 0.6, 3.0, 5.0
    L = (1.5 * spin + 0.4 * rotor) / np.cos(tilt)
    rate = L / 2.0
    start = {"q": [0, tilt, 0, 0], "qdot": [rate, 0, spin - rate * np.cos(tilt), rotor]}
    run = SYSTEM.motion(PARAMETERS, **start).integrate([4.0], rtol=1e-12)
    yield "precession", run.q[0, :2] - [4 * rate, tilt], 1e-9
    yield "the rotor", run.q[0, 3] - 4 * rotor, 1e-9
