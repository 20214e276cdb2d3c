"""λ₁ = λ₂ = 2λ₃ with the centre of mass on e₁: a third integral besides E and p_φ.

K = |(ω₁ + iω₂)² + (MgR/λ₃)(γ₁ + iγ₂)|² for γ = −ẑ: Kovalevskaya, Acta Mathematica 12 (1889) 177;
here with ẑ upwards, so that the sign of the second term is the other.
"""

import numpy as np
from sympy import I, Matrix, expand, im, re, symbols
from sympy.physics.mechanics import dynamicsymbols

import rigidtop as rt
from rigidtop.system.parts import spin
from rigidtop.theory.rotation import euler_matrix

moment, weight = symbols("lambda3 weight", positive=True)
phi, theta, psi = dynamicsymbols("phi theta psi")
attitude = euler_matrix(phi, theta, psi)
SYSTEM = rt.System.of_parts(
    rt.Body(0, (2 * moment, 2 * moment, moment), [0, 0, 0], attitude),
    [phi, theta, psi],
    V=weight * (attitude * Matrix([1, 0, 0]))[2],
)
OTHER = rt.System.of_parts(
    rt.Body(0, (2 * moment, 2 * moment, 3 * moment / 2), [0, 0, 0], attitude),
    [phi, theta, psi],
    V=weight * (attitude * Matrix([1, 0, 0]))[2],
)
PARAMETERS = {moment: 0.8, weight: 3.0}
CONSERVED = {"energy", "p_phi"}


def answers():
    """K along a motion; of another body it is not constant."""
    names = SYSTEM.names
    omega = spin(names.plain(attitude), names)
    gamma = names.plain(attitude).T[:, 2]
    z = expand((omega[0] + I * omega[1]) ** 2 - weight / moment * (gamma[0] + I * gamma[1]))
    K = re(z) ** 2 + im(z) ** 2
    for ratio in (1, 2):
        system = SYSTEM if ratio == 1 else OTHER
        run = system.motion(PARAMETERS, q=[0, 0.9, 0.4], qdot=[0.5, 0.2, 1.0])
        values = run.integrate(np.linspace(0, 3, 9), rtol=1e-12).value(names.back(K))
        change = np.ptp(values) / np.max(values)
        yield "K", change if ratio == 1 else min(0, change - 0.1), 1e-9
