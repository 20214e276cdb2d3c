"""Foucault's pendulum, small: in the turning frame it is the space's ellipse, turned back.

x + iy = e^{−iΩt} (A e^{iνt} + B e^{−iνt}) with ν² = k/m where L is that of a fixed frame.
"""

import numpy as np
from sympy import symbols

import rigidtop as rt

m, k, Omega = symbols("m k Omega", positive=True)
x, y, u, v = symbols("x y u v", real=True)
SYSTEM = rt.System(
    m * ((u - Omega * y) ** 2 + (v + Omega * x) ** 2) / 2 - k * (x**2 + y**2) / 2, [x, y], [u, v]
)
PARAMETERS = {m: 2, k: 3, Omega: 0.4}
CONSERVED = {"energy"}


def answers():
    """From rest in the turning frame, which is Ω × r in space."""
    run = SYSTEM.motion(PARAMETERS, q=[1, 0]).integrate([2.0, 7.0], rtol=1e-12)
    nu, turn = np.sqrt(1.5), 0.4
    place = np.cos(nu * run.t) + 1j * turn / nu * np.sin(nu * run.t)
    yield "the place", run.q @ [1, 1j] - np.exp(-1j * turn * run.t) * place, 1e-10
